//! Whether a flat surface is a face of the scene object that is said to carry it.

use wisch::geometry::{Mesh, Point2, Point3};
use wisch::represent::{SceneObject, ScenePart, Task};

/// Distance of a surface from the face of its carrier, and reach beyond it, above which a remark is made [m].
const OFF_FACE: f64 = 3e-3;
/// Largest lean of a face against a surface that counts as parallel to it [rad].
const MOST_LEAN: f64 = 0.0175;
/// Triangles of a box.
const BOX_TRIANGLES: usize = 12;
/// Least area of the faces of a mesh that is no box over that of the surface, below which they are not compared [1].
const LEAST_COVER: f64 = 0.5;

/// A triangle that may be a part of the surface, in the surface frame.
struct Face {
    corners: [Point3; 3],
    /// Mean height over the surface [m].
    height: f64,
    /// Area [m²].
    area: f64,
}

/// Returns a remark on a flat surface that is no face of the object that carries it: it lies in or over the object, leans
/// against it, or reaches beyond it. Faces of meshes that are curved or rough are not compared.
pub(super) fn carrier_remark(task: &Task) -> Option<String> {
    let is_carrier = |object: &&SceneObject| object.part == ScenePart::Carrier;
    let carrier = task.scene.iter().find(is_carrier)?;
    if !task.surface.shape.is_plane() {
        return None;
    }
    let surface_from_world = task.surface.world_from_surface.inverse();
    let mesh = (carrier.mesh).transform(&(surface_from_world * carrier.world_from_object));
    let is_box = mesh.triangles().len() == BOX_TRIANGLES;
    let (name, surface) = (&carrier.name, &task.surface.name);
    let advice = "the tool would wipe where the object has no face: correct [surface], the object, or carried_by";
    let faces = match find_faces(&mesh) {
        Ok(faces) => faces,
        Err(lean) => {
            return is_box.then(|| {
                format!(
                    "surface {surface:?} is no face of {name:?}, which carries it: it leans by {:.1} degrees against the nearest face; {advice}",
                    lean.to_degrees()
                )
            });
        }
    };
    let nearest = |a: &&Face, b: &&Face| a.height.abs().total_cmp(&b.height.abs());
    let height = faces.iter().min_by(nearest)?.height;
    let face: Vec<&Face> = (faces.iter())
        .filter(|face| (face.height - height).abs() <= OFF_FACE)
        .collect();
    let area: f64 = face.iter().map(|face| face.area).sum();
    let outline = &task.surface.outline;
    if !is_box && area < LEAST_COVER * outline.area() {
        return None;
    }
    let beyond = |point: &Point2| {
        let distances = face.iter().map(|face| measure_gap(point, &face.corners));
        distances.fold(f64::INFINITY, f64::min)
    };
    let overhang = outline.outer().iter().map(beyond).fold(0.0, f64::max);
    let off = (height.abs() > OFF_FACE).then(|| {
        let side = if height > 0.0 {
            "inside it, below"
        } else {
            "above"
        };
        format!("it lies {:.1} mm {side} its face", 1e3 * height.abs())
    });
    let over = (overhang > OFF_FACE)
        .then(|| format!("it reaches up to {:.0} mm beyond that face", 1e3 * overhang));
    let faults: Vec<String> = off.into_iter().chain(over).collect();
    (!faults.is_empty()).then(|| {
        format!(
            "surface {surface:?} is no face of {name:?}, which carries it: {}; {advice}",
            faults.join(", and ")
        )
    })
}

/// Returns the triangles of a mesh in the surface frame that face the tool.
///
/// # Errors
/// If none is parallel to the surface: the least lean [rad].
fn find_faces(mesh: &Mesh) -> Result<Vec<Face>, f64> {
    let volume: f64 = (mesh.corners())
        .map(|[a, b, c]| a.coords.dot(&b.coords.cross(&c.coords)))
        .sum();
    // The corners of a mesh may be in the wrong order.
    let outwards = if volume < 0.0 { -1.0 } else { 1.0 };
    let (mut faces, mut least) = (Vec::new(), std::f64::consts::PI);
    for corners in mesh.corners() {
        let [a, b, c] = corners;
        let normal = outwards * (b - a).cross(&(c - a));
        let lean = normal.xy().norm().atan2(normal.z);
        least = least.min(lean);
        if lean <= MOST_LEAN && normal.z > 0.0 {
            faces.push(Face {
                corners,
                height: (a.z + b.z + c.z) / 3.0,
                area: 0.5 * normal.norm(),
            });
        }
    }
    if faces.is_empty() {
        return Err(least);
    }
    Ok(faces)
}

/// Returns the distance of a point of the surface from the projection of a triangle [m]; 0 inside.
fn measure_gap(point: &Point2, corners: &[Point3; 3]) -> f64 {
    let mut sides = [0.0; 3];
    let mut gap = f64::INFINITY;
    for i in 0..3 {
        let (from, to) = (corners[i].xy(), corners[(i + 1) % 3].xy());
        let (along, off) = (to - from, point - from);
        sides[i] = along.perp(&off);
        let share = (off.dot(&along) / along.norm_squared()).clamp(0.0, 1.0);
        gap = gap.min((off - share * along).norm());
    }
    let is_inside = sides.iter().all(|side| *side >= 0.0) || sides.iter().all(|side| *side <= 0.0);
    if is_inside { 0.0 } else { gap }
}
