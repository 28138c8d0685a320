//! Shapes of links for collision checks, from the `<collision>` elements of a URDF.

use super::diagnostics::{Diagnostics, words};
use super::elements::{Urdf, UrdfGeometry, UrdfShape};
use crate::geometry::{LikelyUnits, Mesh, MeshFormat, Point3, Pose, Vector3};
use crate::{DiagnosticKind, Severity, Subject};
use nalgebra::{Translation3, UnitQuaternion};

/// Longest mesh of any robot \[m\]; a longer one is probably in millimetres.
pub const MAX_MESH_EXTENT: f64 = 20.0;
/// Longest mesh over the reach of the robot [1], and the least value of that limit [m]: some URDFs include the walls of
/// a cell.
const MESH_PER_REACH: f64 = 3.0;
const LEAST_MESH_LIMIT: f64 = 2.0;
/// Shortest mesh of a link [m].
const MIN_MESH_EXTENT: f64 = 1e-3;
/// Usual length of a link's mesh: at least this [m], and at most this share of the robot's reach [1].
const LEAST_USUAL_MESH: f64 = 0.005;
const USUAL_MESH_PER_REACH: f64 = 0.5;
/// Least value of that share [m].
const LEAST_USUAL_MOST: f64 = 0.3;

/// Returns the longest extent of a mesh [m] for a robot of this reach [m].
fn mesh_limit(reach: f64) -> f64 {
    if reach > 0.0 {
        (MESH_PER_REACH * reach).clamp(LEAST_MESH_LIMIT, MAX_MESH_EXTENT)
    } else {
        MAX_MESH_EXTENT
    }
}

/// Returns the units in which the extent of a mesh [m] is probably given, for a robot of this reach [m].
fn guess_units(extent: f64, reach: f64) -> Option<LikelyUnits> {
    let most = LEAST_MESH_LIMIT;
    let usual = match reach > 0.0 {
        true => (USUAL_MESH_PER_REACH * reach).clamp(LEAST_USUAL_MOST, most),
        false => most,
    };
    LikelyUnits::guess(extent, [LEAST_USUAL_MESH, usual], [MIN_MESH_EXTENT, most])
}

/// Tolerance within which spheres at the ends of a cylinder make it a capsule, in place and radius [m].
const CAPSULE_TOLERANCE: f64 = 1e-6;

/// A `<collision>` element of a URDF: a shape fixed to a link.
#[derive(Debug, Clone, PartialEq)]
pub struct Collision {
    /// Pose of the shape in the link frame.
    pub link_from_shape: Pose,
    /// The shape in its own frame.
    pub shape: Shape,
}

/// A solid in its own frame.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// A box centred on the origin.
    Box {
        /// Extent along x, y and z \[m\].
        size: Vector3,
    },
    /// A cylinder along z, centred on the origin.
    Cylinder {
        /// Radius \[m\].
        radius: f64,
        /// Extent along z \[m\].
        length: f64,
    },
    /// A cylinder along z, centred on the origin, with hemispheres on its ends. In a URDF: a cylinder with two spheres
    /// of its radius at its ends, or `<capsule>`.
    Capsule {
        /// Radius \[m\].
        radius: f64,
        /// Distance between the centres of the hemispheres \[m\].
        length: f64,
    },
    /// A sphere about the origin.
    Sphere {
        /// Radius \[m\].
        radius: f64,
    },
    /// A mesh, scaled to metres, in the axes of its file.
    Mesh(Mesh),
}

/// Segments of a round shape that is converted to a mesh: a rim of 0.1 m radius is off by 0.5 mm.
const SEGMENTS: u32 = 32;
/// Least size of a shape [m], for shapes without thickness.
const LEAST_SIZE: f64 = 1e-6;

fn at_least(size: f64) -> f64 {
    size.max(LEAST_SIZE)
}

impl Collision {
    /// Returns the shape as a mesh in the link frame, inscribed in round shapes; `None` for sizes that no mesh can
    /// have.
    pub fn mesh_in_link(&self) -> Option<Mesh> {
        let mesh = match &self.shape {
            Shape::Box { size } => Mesh::cuboid(size.map(at_least)),
            &Shape::Cylinder { radius, length } => {
                Mesh::cylinder(at_least(radius), at_least(length), SEGMENTS)
            }
            &Shape::Capsule { radius, length } => {
                Mesh::capsule(at_least(radius), at_least(length), SEGMENTS)
            }
            &Shape::Sphere { radius } => Mesh::sphere(at_least(radius), SEGMENTS),
            Shape::Mesh(mesh) => Ok(mesh.clone()),
        };
        Some(mesh.ok()?.transform(&self.link_from_shape))
    }
}

/// Reads the shapes of all links, in their order, and reports those that cannot be read. `reach` is the robot's [m].
pub(crate) fn load_shapes(
    urdf: &Urdf,
    reach: f64,
    meshes: &mut dyn FnMut(&str) -> Result<Vec<u8>, String>,
    report: &mut Diagnostics,
) -> Vec<Vec<Collision>> {
    let nothing = urdf.links.iter().all(|link| link.shapes.is_empty());
    if nothing {
        let w = words(
            "no link has collision geometry",
            "<collision> on the links that can touch something",
            "add capsules or boxes around the links: without them no collision is detected",
        );
        report.add(
            Severity::Warning,
            DiagnosticKind::CollisionMissing,
            Subject::Robot,
            0,
            w,
        );
    }
    let mut all = Vec::with_capacity(urdf.links.len());
    for link in &urdf.links {
        let heavy = link.inertial.as_ref().is_some_and(|i| i.mass > 0.0);
        if !nothing && heavy && link.shapes.is_empty() {
            let w = words(
                "it has mass but no collision geometry",
                "<collision>",
                "add a shape unless another link's covers it",
            );
            let subject = Subject::Link(link.name.clone());
            report.add(
                Severity::Note,
                DiagnosticKind::CollisionMissing,
                subject,
                link.at,
                w,
            );
        }
        let known = report.diagnostics.len();
        let shapes = link
            .shapes
            .iter()
            .filter_map(|shape| load(&link.name, shape, reach, meshes, report))
            .collect();
        let added = report.diagnostics[known..].iter_mut();
        for unread in added.filter(|found| found.kind == DiagnosticKind::Mesh) {
            unread.advice += "; until it is corrected, this shape is not checked for collisions";
        }
        all.push(with_capsules(shapes));
    }
    if !nothing && all.iter().all(Vec::is_empty) {
        let w = words(
            "none of the collision shapes can be used",
            "<collision> on the links that can touch something",
            "correct them: without them no collision is detected",
        );
        let kind = DiagnosticKind::CollisionMissing;
        report.add(Severity::Warning, kind, Subject::Robot, 0, w);
    }
    all
}

pub(super) fn load(
    link: &str,
    shape: &UrdfShape,
    reach: f64,
    meshes: &mut dyn FnMut(&str) -> Result<Vec<u8>, String>,
    report: &mut Diagnostics,
) -> Option<Collision> {
    if shape.geometry.is_point() {
        let w = words(
            "a collision shape without extent",
            "lengths above 0 m",
            "it is ignored: remove it, or give its size",
        );
        let (kind, subject) = (
            DiagnosticKind::CollisionMissing,
            Subject::Link(link.to_owned()),
        );
        report.add(Severity::Note, kind, subject, shape.at, w);
        return None;
    }
    let solid = match &shape.geometry {
        UrdfGeometry::Box(size) => Shape::Box {
            size: size.map(at_least),
        },
        &UrdfGeometry::Cylinder { radius, length } => Shape::Cylinder {
            radius: at_least(radius),
            length: at_least(length),
        },
        &UrdfGeometry::Capsule { radius, length } => Shape::Capsule {
            radius: at_least(radius),
            length: at_least(length),
        },
        &UrdfGeometry::Sphere(radius) => Shape::Sphere {
            radius: at_least(radius),
        },
        UrdfGeometry::Mesh { file, scale } => {
            let subject = || Subject::Link(link.to_owned());
            let mesh = match read_mesh(file, *scale, meshes) {
                Ok(mesh) => mesh,
                Err(problem) => {
                    // The reader of meshes names the file too.
                    let name = format!("mesh {file:?}: ");
                    let problem = problem.strip_prefix(&name).unwrap_or(&problem);
                    let w = words(
                        name.clone() + problem,
                        "a readable STL, OBJ, COLLADA or PLY mesh",
                        "correct the path or the file",
                    );
                    report.add(
                        Severity::Warning,
                        DiagnosticKind::Mesh,
                        subject(),
                        shape.at,
                        w,
                    );
                    return None;
                }
            };
            let (extent, most) = (mesh.extent(), mesh_limit(reach));
            if !(MIN_MESH_EXTENT..=most).contains(&extent) {
                let units = guess_units(extent, reach);
                let w = words(
                    format!("mesh {file:?} is {} m long", significant(extent)),
                    match extent > most {
                        true if reach > 0.0 => {
                            format!("at most {most:.1} m on a robot of {reach:.2} m reach")
                        }
                        true => format!("at most {most} m"),
                        false => format!("at least {MIN_MESH_EXTENT} m"),
                    },
                    units.map_or("correct the scale".to_owned(), |units| {
                        let scales = units.factors(|metres| {
                            let [x, y, z] = (scale * metres).map(rounded).into();
                            format!("scale=\"{x} {y} {z}\"")
                        });
                        format!("it is probably in {}: use {scales}", units.names())
                    }),
                );
                report.add(
                    Severity::Warning,
                    DiagnosticKind::MeshScale,
                    subject(),
                    shape.at,
                    w,
                );
            }
            Shape::Mesh(mesh)
        }
    };
    Some(Collision {
        link_from_shape: shape.link_from_shape,
        shape: solid,
    })
}

/// Rounds a length to four significant digits.
pub(super) fn significant(length: f64) -> f64 {
    format!("{length:.3e}").parse().unwrap_or(length)
}

/// Formats a factor without rounding errors.
fn rounded(factor: f64) -> f64 {
    format!("{factor:.6e}").parse().unwrap_or(factor)
}

fn read_mesh(
    file: &str,
    scale: Vector3,
    meshes: &mut dyn FnMut(&str) -> Result<Vec<u8>, String>,
) -> Result<Mesh, String> {
    let format = MeshFormat::from_file_name(file)
        .ok_or_else(|| format!("its name does not end in {}", MeshFormat::EXTENSIONS))?;
    let bytes = meshes(file)?;
    let mesh = Mesh::parse(&bytes, format, file).map_err(|error| error.to_string())?;
    if scale == Vector3::repeat(1.0) {
        return Ok(mesh);
    }
    let vertices = mesh
        .vertices()
        .iter()
        .map(|p| Point3::from(p.coords.component_mul(&scale)))
        .collect();
    // A mirrored mesh is turned right side out again.
    let mirrored = scale.product() < 0.0;
    let triangles = mesh
        .triangles()
        .iter()
        .map(|&[a, b, c]| if mirrored { [a, c, b] } else { [a, b, c] })
        .collect();
    Mesh::new(vertices, triangles).map_err(|error| format!("scaled by {scale:?}: {error}"))
}

/// Merges each cylinder with the spheres at its ends.
fn with_capsules(mut shapes: Vec<Collision>) -> Vec<Collision> {
    let mut at = 0;
    while at < shapes.len() {
        if let Shape::Cylinder { radius, length } = shapes[at].shape {
            let end = |side: f64| {
                let center =
                    shapes[at].link_from_shape * Point3::new(0.0, 0.0, side * length / 2.0);
                shapes.iter().position(|ball| {
                    matches!(ball.shape, Shape::Sphere { radius: r } if (r - radius).abs() < CAPSULE_TOLERANCE)
                        && (ball.link_from_shape.translation.vector - center.coords).norm()
                            < CAPSULE_TOLERANCE
                })
            };
            if let (Some(below), Some(above)) = (end(-1.0), end(1.0))
                && below != above
            {
                shapes[at].shape = Shape::Capsule { radius, length };
                shapes.remove(below.max(above));
                shapes.remove(below.min(above));
                at = at.saturating_sub(2);
                continue;
            }
        }
        at += 1;
    }
    shapes
}

impl Collision {
    /// Returns a capsule between two points of the link frame \[m\].
    ///
    /// ```
    /// use wisch_robot::geometry::Point3;
    /// use wisch_robot::{Collision, Shape};
    /// let arm = Collision::capsule(Point3::origin(), Point3::new(0.3, 0.0, 0.0), 0.14);
    /// assert_eq!(arm.shape, Shape::Capsule { radius: 0.14, length: 0.3 });
    /// assert!((arm.link_from_shape * Point3::new(0.0, 0.0, 0.15)).x > 0.29);
    /// ```
    pub fn capsule(from: Point3, to: Point3, radius: f64) -> Self {
        let along = to - from;
        let rotation =
            UnitQuaternion::rotation_between(&Vector3::z(), &along).unwrap_or_else(|| {
                UnitQuaternion::from_axis_angle(&Vector3::x_axis(), std::f64::consts::PI)
            });
        let middle = nalgebra::center(&from, &to);
        let length = along.norm();
        Self {
            link_from_shape: Pose::from_parts(Translation3::from(middle.coords), rotation),
            shape: if length > 0.0 {
                Shape::Capsule { radius, length }
            } else {
                Shape::Sphere { radius }
            },
        }
    }
}
