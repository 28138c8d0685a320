//! Footprint of a tool's mesh on a surface.

use super::mesh::{MAX_COORDINATE, Mesh, Side, crossing, cut};
use super::{Edge, Point2, Point3, Polygon, Region};
use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay::ShapeType;
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::float::overlay::FloatOverlay;
use i_overlay::i_float::adapter::FloatPointAdapter;
use std::collections::{HashMap, HashSet};

/// Least compression depth \[m\]; below it, a flat face that rounding tilts would not lie within the slab.
pub const MIN_COMPRESSION_DEPTH: f64 = 1e-5;
/// Contact depth of a rigid tool \[m\], for the unevenness of an underside.
pub const RIGID_DEPTH: f64 = 1e-4;

/// Largest number of edges of a footprint; a mesh with more is rejected.
pub const MAX_FOOTPRINT_EDGES: usize = 100_000;

/// Number of rings in a batch of a union.
const BATCH: usize = 250;
/// Number of pairs of rings with overlapping bounds up to which all rings are united at once, and number of pairs
/// checked to count them.
const FEW_OVERLAPS: usize = 2_000_000;
const MOST_COMPARED: usize = 200_000_000;
/// Largest number of edges that the union of a batch may leave; part of them lies within later batches.
const MOST_BATCH_EDGES: usize = 4 * MAX_FOOTPRINT_EDGES;

/// Least area of pieces and holes [m²]: a thousandth of a square millimetre.
const MIN_AREA: f64 = 1e-9;

/// Distance of a point from the line between its neighbours below which it is dropped [m].
const COLLINEAR_TOLERANCE: f64 = 1e-9;

/// Area of a projected triangle below which it counts as vertical and is skipped [m²].
const SLIVER_AREA: f64 = 1e-15;

/// Grid points per metre on which unions are computed: a pitch of 0.1 nm, far below the tolerances above, and a power
/// of two, so that scaling is exact.
const GRID_PER_METRE: f64 = (1u64 << 33) as f64;

/// A closed ring of points, without repetition of the first.
type Ring = Vec<[f64; 2]>;

/// A reason why a mesh has no footprint.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum FootprintError {
    /// The compression depth is invalid.
    #[error(
        "compression depth {value} m is not a finite depth of at least {MIN_COMPRESSION_DEPTH} m"
    )]
    CompressionDepth {
        /// Compression depth \[m\].
        value: f64,
    },
    /// A transform has moved the mesh beyond the largest coordinate.
    #[error("the mesh reaches out to {value} m, beyond the limit of ±{MAX_COORDINATE} m")]
    OutOfRange {
        /// Largest coordinate \[m\].
        value: f64,
    },
    /// No part of the tool covers the surface.
    #[error(
        "the lowest {depth} m of the mesh cover less than {MIN_AREA} m²: check the mesh's orientation and the compression depth"
    )]
    Empty {
        /// Compression depth \[m\].
        depth: f64,
    },
    /// The mesh has gaps and covers no area by itself.
    #[error(
        "the mesh is not watertight: its section at z = {height} m ends at {gaps} gaps, \
         and its lowest {depth} m cover nothing"
    )]
    Open {
        /// Height of the section in the tool frame \[m\].
        height: f64,
        /// Number of open chains of section edges.
        gaps: usize,
        /// Compression depth \[m\].
        depth: f64,
    },
    /// The footprint has too many edges for planning.
    #[error("{edges} edges exceed the limit of {MAX_FOOTPRINT_EDGES}: simplify the mesh")]
    TooManyEdges {
        /// Number of edges.
        edges: usize,
    },
}

/// Returns the area of the surface that a tool covers when its lowest point is compressed by `compression_depth` \[m\]:
/// the part of the mesh within that height of its lowest point, projected along z. Mesh and footprint are in the tool
/// frame, with z out of the surface.
///
/// A ray that goes down from inside a solid meets its surface. The projected surface within the slab therefore covers
/// everything that the solid's section covers, and the union of the projected triangles is exactly the footprint. Only
/// if the mesh is not watertight, such as a tube without end caps, the closed loops of the section at the top of the
/// slab are filled (even–odd) and added; open chains of section edges are left out.
///
/// A depth beyond the height of the mesh covers the whole mesh. Pieces and holes below 1e-9 m² are dropped, as are
/// points within 1 nm of the line between their neighbours.
///
/// # Errors
/// If the depth is not finite and at least [`MIN_COMPRESSION_DEPTH`], the footprint is empty, or
/// it has more than [`MAX_FOOTPRINT_EDGES`] edges.
///
/// ```
/// use wisch_robot::geometry::{Mesh, Vector3, footprint};
/// let sponge = Mesh::cuboid(Vector3::new(0.07, 0.11, 0.05))?;
/// let area_of_effect = footprint(&sponge, 0.005)?;
/// assert!((area_of_effect.area() - 0.07 * 0.11).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn footprint(mesh: &Mesh, compression_depth: f64) -> Result<Region, FootprintError> {
    let depth = compression_depth;
    if !(depth >= MIN_COMPRESSION_DEPTH && depth.is_finite()) {
        return Err(FootprintError::CompressionDepth { value: depth });
    }
    let (min, max) = mesh.bounds();
    let value = min.coords.amax().max(max.coords.amax());
    if !mesh
        .vertices()
        .iter()
        .all(|p| p.iter().all(|c| c.is_finite()))
        || value > MAX_COORDINATE
    {
        return Err(FootprintError::OutOfRange { value });
    }
    let top = (min.z + depth).min(max.z);
    let mut cover: Vec<Ring> = mesh
        .corners()
        .filter_map(|corners| shadow(corners, top))
        .collect();
    let mut gaps = 0;
    if !mesh.is_watertight() {
        let section = section(mesh, top);
        gaps = section.gaps;
        cover.extend(
            union(&section.loops, FillRule::EvenOdd)
                .into_iter()
                .flatten(),
        );
    }
    let region = simplify(union_of_many(cover)?);
    let edges = region.edges().count();
    match edges {
        0 if gaps > 0 => Err(FootprintError::Open {
            height: top,
            gaps,
            depth,
        }),
        0 => Err(FootprintError::Empty { depth }),
        1..=MAX_FOOTPRINT_EDGES => Ok(region),
        _ => Err(FootprintError::TooManyEdges { edges }),
    }
}

/// Returns the projection of a triangle's part at or below `top`, counter-clockwise; `None` for slivers.
fn shadow(corners: [Point3; 3], top: f64) -> Option<Ring> {
    if corners.iter().all(|p| p.z > top) {
        return None;
    }
    let mut ring: Ring = cut(corners, top, Side::Below)
        .iter()
        .map(|p| [p.x, p.y])
        .collect();
    let [x, y] = *ring.first()?;
    let twice_area: f64 = ring
        .windows(2)
        .map(|w| (w[0][0] - x) * (w[1][1] - y) - (w[0][1] - y) * (w[1][0] - x))
        .sum();
    if twice_area < 0.0 {
        ring.reverse();
    }
    (twice_area.abs() > 2.0 * SLIVER_AREA).then_some(ring)
}

/// Section of a mesh by a horizontal plane.
struct Section {
    loops: Vec<Ring>,
    /// Number of open chains of section edges.
    gaps: usize,
}

/// Cuts the mesh by the plane z = `height`. Every vertex counts as above it or not, so each triangle gives at most one
/// segment, and segments join on the mesh edges that triangles share.
fn section(mesh: &Mesh, height: f64) -> Section {
    let above = |i: u32| mesh.vertices()[i as usize].z >= height;
    let mut segments = Segments::default();
    for [a, b, c] in mesh.welded_triangles() {
        let crossed: Vec<MeshEdge> = [(a, b), (b, c), (c, a)]
            .into_iter()
            .filter(|&(from, to)| above(from) != above(to))
            .map(|(from, to)| (from.min(to), from.max(to)))
            .collect();
        if let [one, other] = crossed[..] {
            segments.add(one, other);
        }
    }
    // Open chains first, from end to end; the remaining segments form loops.
    let mut gaps = 0;
    let mut reached: HashSet<MeshEdge> = HashSet::new();
    for end in segments.loose_ends() {
        if reached.insert(end) {
            let chain = segments.take_chain(end);
            reached.extend(chain.last().copied());
            gaps += 1;
        }
    }
    let mut loops = Vec::new();
    for start in segments.ends.clone() {
        let chain = segments.take_chain(start[0]);
        let corners = chain.iter().skip(1).map(|&(i, j)| {
            let p = crossing(
                mesh.vertices()[i as usize],
                mesh.vertices()[j as usize],
                height,
            );
            [p.x, p.y]
        });
        loops.push(corners.collect());
    }
    Section { loops, gaps }
}

/// An edge of the mesh, with the smaller vertex index first.
type MeshEdge = (u32, u32);

/// Segments of a section, each between two edges of the mesh.
#[derive(Default)]
struct Segments {
    ends: Vec<[MeshEdge; 2]>,
    taken: Vec<bool>,
    at: HashMap<MeshEdge, Vec<usize>>,
}

impl Segments {
    fn add(&mut self, one: MeshEdge, other: MeshEdge) {
        let index = self.ends.len();
        self.ends.push([one, other]);
        self.taken.push(false);
        self.at.entry(one).or_default().push(index);
        self.at.entry(other).or_default().push(index);
    }

    /// Returns the mesh edges at which an odd number of segments end, in the order of their addition.
    fn loose_ends(&self) -> Vec<MeshEdge> {
        let odd = |edge: &MeshEdge| self.at[edge].len() % 2 == 1;
        self.ends.iter().flatten().copied().filter(odd).collect()
    }

    /// Follows segments from `start` and removes them, until the chain ends.
    fn take_chain(&mut self, start: MeshEdge) -> Vec<MeshEdge> {
        let mut chain = vec![start];
        let mut here = start;
        while let Some(index) = self.at.get_mut(&here).and_then(Vec::pop) {
            if !std::mem::replace(&mut self.taken[index], true) {
                let [one, other] = self.ends[index];
                here = if here == one { other } else { one };
                chain.push(here);
            }
        }
        chain
    }
}

/// Returns the union of the rings: counter-clockwise rings fill, clockwise ones are holes, as in [`union`].
///
/// If many rings cross each other everywhere, the crossings alone would fill the memory. The rings are therefore united
/// in batches, and the batches pairwise, so that covered parts drop out early.
///
/// # Errors
/// If the union of a batch has far more edges than a footprint may have.
fn union_of_many(rings: Vec<Ring>) -> Result<Vec<Vec<Ring>>, FootprintError> {
    if !overlap_often(&rings) {
        return Ok(union(&rings, FillRule::NonZero));
    }
    let mut batches: Vec<Vec<Ring>> = rings.chunks(BATCH).map(<[Ring]>::to_vec).collect();
    loop {
        let joined = batches.iter().map(|rings| {
            let rings: Vec<Ring> = union(rings, FillRule::NonZero)
                .into_iter()
                .flatten()
                .collect();
            let edges = rings.iter().map(Vec::len).sum();
            if edges > MOST_BATCH_EDGES {
                return Err(FootprintError::TooManyEdges { edges });
            }
            Ok(rings)
        });
        let joined = joined.collect::<Result<Vec<_>, _>>()?;
        batches = joined.chunks(2).map(<[Vec<Ring>]>::concat).collect();
        if let [last] = &batches[..] {
            return Ok(union(last, FillRule::NonZero));
        }
    }
}

/// Whether the bounds of more than [`FEW_OVERLAPS`] pairs of rings overlap, or counting them would take too long.
fn overlap_often(rings: &[Ring]) -> bool {
    let bounds = |ring: &Ring| {
        let [mut low, mut high] = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        for point in ring {
            for axis in 0..2 {
                low[axis] = low[axis].min(point[axis]);
                high[axis] = high[axis].max(point[axis]);
            }
        }
        [low, high]
    };
    let mut bounds: Vec<[[f64; 2]; 2]> = rings.iter().map(bounds).collect();
    bounds.sort_by(|a, b| a[0][0].total_cmp(&b[0][0]));
    let (mut compared, mut overlaps) = (0, 0);
    for (i, [low, high]) in bounds.iter().enumerate() {
        for [other_low, other_high] in &bounds[i + 1..] {
            if other_low[0] > high[0] {
                break;
            }
            compared += 1;
            overlaps += usize::from(other_low[1] <= high[1] && low[1] <= other_high[1]);
        }
        if overlaps > FEW_OVERLAPS || compared > MOST_COMPARED {
            return true;
        }
    }
    false
}

/// Returns the union of the rings as shapes: an outer ring, counter-clockwise, then its holes.
fn union(rings: &[Ring], fill_rule: FillRule) -> Vec<Vec<Ring>> {
    let points = rings.iter().flatten();
    let Ok(adapter) = FloatPointAdapter::<[f64; 2], i64>::try_with_iter_and_scale_conservative(
        points,
        GRID_PER_METRE,
    ) else {
        unreachable!("coordinates were checked, and {MAX_COORDINATE} m lie on the grid");
    };
    let edges = rings.iter().map(Vec::len).sum();
    FloatOverlay::with_adapter(adapter, edges)
        .unsafe_add_source(rings, ShapeType::Subject)
        .overlay(OverlayRule::Subject, fill_rule)
}

/// Returns the region without collinear points, tiny pieces and tiny holes.
fn simplify(shapes: Vec<Vec<Ring>>) -> Region {
    let polygons = shapes.into_iter().filter_map(|shape| {
        let mut rings = shape.into_iter().map(|ring| {
            let ring = without_collinear(ring.into_iter().map(Point2::from).collect());
            (Polygon::new(ring.clone(), Vec::new()).area() >= MIN_AREA).then_some(ring)
        });
        let outer = rings.next()??;
        Some(Polygon::new(outer, rings.flatten().collect()))
    });
    Region::new(polygons.collect())
}

/// Returns the ring without spikes and without points on the line between their neighbours.
fn without_collinear(ring: Vec<Point2>) -> Vec<Point2> {
    let needless = |before: Point2, here: Point2, after: Point2| {
        let chord = Edge {
            start: before,
            end: after,
        };
        chord.distance(here) <= COLLINEAR_TOLERANCE
            || (after - before).norm() <= COLLINEAR_TOLERANCE
    };
    let mut kept: Vec<Point2> = Vec::with_capacity(ring.len());
    for point in ring {
        while let [.., before, here] = kept[..] {
            if !needless(before, here, point) {
                break;
            }
            kept.pop();
        }
        kept.push(point);
    }
    // The same across the seam between the last point and the first.
    let mut first = 0;
    while kept.len() - first >= 3 {
        let n = kept.len();
        if needless(kept[n - 2], kept[n - 1], kept[first]) {
            kept.pop();
        } else if needless(kept[n - 1], kept[first], kept[first + 1]) {
            first += 1;
        } else {
            break;
        }
    }
    kept.split_off(first)
}

#[cfg(test)]
mod tests;
