//! The part and the side of a mesh that a tool wipes.

use super::error::SheetError;
use super::topology::{Triangles, nearest_in_triangle};
use super::weld::{MeshRepairs, weld};
use crate::geometry::{Mesh, Point3, Vector3};

/// Largest angle of a normal from the direction to the tool at which a triangle of a closed mesh
/// belongs to the wiped side \[rad\], unless the caller gives another.
pub const SIDE_LEAN: f64 = 1.2;

/// The part and the side of a mesh that are wiped.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PartChoice {
    /// A point near the part \[m\]; without it, the largest part is taken.
    pub seed_point: Option<Point3>,
    /// Direction from the surface to the tool, of any length; without it, the side follows from the
    /// orientation of the file's triangles.
    pub towards: Option<Vector3>,
    /// Largest angle of a normal from `towards` \[rad\]; without it, [`SIDE_LEAN`] for a closed mesh and none for another.
    pub largest_lean: Option<f64>,
}

/// Properties of a mesh, and the part of it that was taken.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshSurvey {
    /// Number of triangles in the file.
    pub triangles: usize,
    /// Number of repairs of the mesh, by kind.
    pub repairs: MeshRepairs,
    /// Areas of the connected parts \[m²\], the largest first.
    pub part_areas: Vec<f64>,
    /// Index of the part that was taken, in `part_areas`.
    pub taken_part: usize,
    /// Number of triangles of the part that was taken.
    pub part_triangles: usize,
    /// Number of triangles that belong to the side that was taken.
    pub side_triangles: usize,
    /// Number of triangles of the part whose orientation in the file contradicts the others.
    pub flipped: usize,
    /// Whether the whole side was turned to face the tool.
    pub is_turned: bool,
    /// Whether the part has no border.
    pub is_closed: bool,
    /// Edges that more than two triangles of the mesh share.
    pub shared_edges: usize,
    /// Length of each border line of the side \[m\], the longest first; all but one are holes, if the side is a disc.
    pub border_lengths: Vec<f64>,
}

/// The side of a mesh that is wiped, oriented towards the tool.
#[derive(Debug, Clone)]
pub(super) struct WipedPart {
    pub(super) surface: Triangles,
    pub(super) survey: MeshSurvey,
}

/// Takes the part and the side that `choice` defines.
///
/// # Errors
/// If the part is closed and no direction to the tool is given, no triangle faces it, the part has
/// no consistent side, or no triangle has an area.
pub(super) fn take_part(mesh: &Mesh, choice: &PartChoice) -> Result<WipedPart, SheetError> {
    let (welded, repairs) = weld(mesh);
    let area = welded.area();
    if area.is_nan() || area <= 0.0 {
        let triangles = mesh.triangles().len();
        return Err(SheetError::NoArea { triangles });
    }
    let sides = welded.sides();
    let shared_edges = (sides.chunk_by(|one, other| one.edge == other.edge))
        .filter(|group| group.len() > 2)
        .count();
    let mut parts: Vec<Triangles> = (welded.parts().iter())
        .map(|part| welded.select(part))
        .collect();
    parts.sort_by(|one, other| other.area().total_cmp(&one.area()));
    let taken = choose(&parts, choice.seed_point);
    let part_areas = parts.iter().map(Triangles::area).collect();
    let (mut part, flipped) = orient(&parts[taken])?;
    let part_triangles = part.triangles.len();
    let is_closed = part.neighbours().iter().flatten().all(Option::is_some);
    if is_closed && choice.towards.is_none() {
        return Err(SheetError::Closed {
            triangles: part_triangles,
        });
    }
    let lean = choice.largest_lean.or(is_closed.then_some(SIDE_LEAN));
    let mut is_turned = false;
    if let Some(towards) = choice.towards.and_then(|to| to.try_normalize(0.0)) {
        if !is_closed && part.mean_normal().dot(&towards) < 0.0 {
            turn(&mut part);
            is_turned = true;
        }
        if is_closed && volume(&part) < 0.0 {
            turn(&mut part);
            is_turned = true;
        }
        if let Some(lean) = lean {
            part = side_towards(&part, towards, lean, choice.seed_point)?;
        }
    }
    let (surface, _) = part.with_single_fans();
    let mut border_lengths: Vec<f64> = (surface.borders().iter())
        .map(|border| length(&surface, border))
        .collect();
    border_lengths.sort_by(|one, other| other.total_cmp(one));
    let survey = MeshSurvey {
        triangles: mesh.triangles().len(),
        repairs,
        part_areas,
        taken_part: taken,
        part_triangles,
        side_triangles: surface.triangles.len(),
        flipped,
        is_turned,
        is_closed,
        shared_edges,
        border_lengths,
    };
    Ok(WipedPart { surface, survey })
}

/// Returns the index of the part nearest to the seed point, or of the first.
fn choose(parts: &[Triangles], seed_point: Option<Point3>) -> usize {
    let Some(seed) = seed_point else {
        return 0;
    };
    let distance = |part: &Triangles| {
        let distances = (part.triangles.iter())
            .map(|&triangle| nearest_in_triangle(seed, part.corners(triangle)).0);
        distances.fold(f64::INFINITY, f64::min)
    };
    let distances: Vec<f64> = parts.iter().map(distance).collect();
    (0..parts.len())
        .min_by(|&one, &other| distances[one].total_cmp(&distances[other]))
        .unwrap_or(0)
}

/// Gives all triangles of a connected part the side of the larger share of its area; returns the number of flipped ones.
fn orient(part: &Triangles) -> Result<(Triangles, usize), SheetError> {
    let neighbours = part.neighbours();
    let mut result = part.clone();
    let mut is_flipped = vec![None; part.triangles.len()];
    is_flipped[0] = Some(false);
    let (mut open, mut at) = (vec![0u32], 0);
    while let Some(&t) = open.get(at) {
        at += 1;
        let corners = result.triangles[t as usize];
        for other in neighbours[t as usize].into_iter().flatten() {
            let other_corners = result.triangles[other as usize];
            let is_same = !has_equal_direction(corners, other_corners);
            match is_flipped[other as usize] {
                None => {
                    is_flipped[other as usize] = Some(!is_same);
                    if !is_same {
                        result.triangles[other as usize].swap(1, 2);
                    }
                    open.push(other);
                }
                Some(_) if is_same => {}
                Some(_) => {
                    let at = result.corners(other_corners)[0];
                    return Err(SheetError::NotOrientable { at });
                }
            }
        }
    }
    let area = |flipped: bool| {
        let chosen = part.triangles.iter().zip(&is_flipped);
        let areas = chosen.filter(|(_, is)| **is == Some(flipped));
        areas
            .map(|(&t, _)| part.doubled_normal(t).norm())
            .sum::<f64>()
    };
    let is_against = area(true) > area(false);
    if is_against {
        turn(&mut result);
    }
    let flipped = is_flipped.iter().filter(|is| **is == Some(!is_against));
    Ok((result, flipped.count()))
}

/// Whether two triangles run along a common edge in the same direction, which contradicts a common side.
fn has_equal_direction(one: [u32; 3], other: [u32; 3]) -> bool {
    (0..3).any(|i| (0..3).any(|k| one[i] == other[k] && one[(i + 1) % 3] == other[(k + 1) % 3]))
}

/// Turns all triangles to their other side.
fn turn(part: &mut Triangles) {
    for corners in &mut part.triangles {
        corners.swap(1, 2);
    }
}

/// Returns six times the enclosed volume, positive if the normals point outwards.
fn volume(part: &Triangles) -> f64 {
    let origin = part.vertices[0];
    (part.triangles.iter())
        .map(|&t| {
            let [a, b, c] = part.corners(t).map(|corner| corner - origin);
            a.dot(&b.cross(&c))
        })
        .sum()
}

/// Returns the triangles that face the tool and are connected: nearest to the seed point, or of the largest area.
fn side_towards(
    part: &Triangles,
    towards: Vector3,
    lean: f64,
    seed_point: Option<Point3>,
) -> Result<Triangles, SheetError> {
    let least = libm::cos(lean);
    let facing: Vec<u32> = (0..part.triangles.len() as u32)
        .filter(|&t| {
            let normal = part.doubled_normal(part.triangles[t as usize]);
            normal.dot(&towards) >= least * normal.norm() && normal.norm() > 0.0
        })
        .collect();
    if facing.is_empty() {
        return Err(SheetError::NoSide { lean });
    }
    let facing = part.select(&facing);
    let mut sides: Vec<Triangles> = (facing.parts().iter())
        .map(|side| facing.select(side))
        .collect();
    sides.sort_by(|one, other| other.area().total_cmp(&one.area()));
    Ok(sides.swap_remove(choose(&sides, seed_point)))
}

fn length(surface: &Triangles, border: &[u32]) -> f64 {
    let at = |i: usize| surface.vertices[border[i % border.len()] as usize];
    (0..border.len()).map(|i| (at(i + 1) - at(i)).norm()).sum()
}
