//! Surfaces of meshes in several charts.

use super::cells::CellGraph;
use super::error::SheetError;
use super::prepared::{Prepared, SheetConfig};
use super::surface_sheet::{Sheet, axes_across, outline, unroll_places};
use crate::geometry::{Mesh, Point2, Point3, Polygon, Vector3};
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::PI;

/// Largest number of charts of a mesh.
pub const MAX_CHARTS: usize = 64;
/// Largest number of equal cells that are tried.
const MAX_EQUAL_CELLS: usize = 12;
/// Number of times that the part of a patch beyond its seams is made narrower, if it does not unroll.
const NARROWER: i32 = 3;

/// Triangles that are unrolled while patches are joined, relative to those of the surface; the unions of a smooth bowl take
/// 20.
const JOINING: usize = 60;
/// Number of unions that are unrolled at once.
const AT_ONCE: usize = 4;

/// Largest square of the border's length of joined patches, relative to that of a disc of the same area [1]; a rectangle of
/// 1 × 6 has 2.6.
const LONGEST_BORDER: f64 = 2.6;

/// A surface of a mesh, divided into patches with one chart each. Neighbouring patches meet at
/// seams.
///
/// ```
/// use wisch_robot::geometry::{Atlas, Mesh, Point3, SheetConfig};
/// // The upper half of a ball.
/// let ball = Mesh::sphere(0.2, 48)?;
/// let mut config = SheetConfig::default();
/// config.choice.towards = Some(nalgebra::Vector3::z());
/// let atlas = Atlas::from_mesh(&ball, &config, 16)?;
/// assert!(atlas.charts().len() > 1 && !atlas.seams().is_empty());
/// assert!(atlas.charts().iter().all(|chart| chart.check().is_ok()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Atlas {
    prepared: Prepared,
    graph: CellGraph,
    cells: Vec<Vec<u32>>,
    charts: Vec<Sheet>,
    config: SheetConfig,
}

/// A line at which two patches meet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AtlasSeam {
    /// Indices of the patches, the smaller first.
    pub patches: [usize; 2],
    /// Its length \[m\].
    pub length: f64,
}

/// Cells with their charts.
type Division = Vec<(Vec<u32>, Sheet)>;

impl Atlas {
    /// Divides a mesh into few patches whose charts stay within the limit of the stretch, and at most `most`.
    ///
    /// The patches are cells of about equal size or of about equal Gaussian curvature. If that
    /// gives fewer patches, they arise from halving patches with too much stretch and joining
    /// neighbours. Each patch is near the patch with the previous number.
    ///
    /// # Errors
    /// As [`Sheet::draft`], and as [`Sheet::check`] if `most` charts do not suffice.
    pub fn from_mesh(mesh: &Mesh, config: &SheetConfig, most: usize) -> Result<Self, SheetError> {
        let prepared = Prepared::new(mesh, config)?;
        let graph = CellGraph::new(&prepared.surface);
        let search = Search {
            prepared: &prepared,
            graph: &graph,
            config,
        };
        let division = search.divide(most.clamp(1, MAX_CHARTS))?;
        let (cells, charts) = order(division).into_iter().unzip();
        Ok(Self {
            prepared,
            graph,
            cells,
            charts,
            config: *config,
        })
    }

    /// The settings with which the surface was divided.
    pub fn config(&self) -> &SheetConfig {
        &self.config
    }

    /// The charts of the patches, each up to its seams.
    pub fn charts(&self) -> &[Sheet] {
        &self.charts
    }

    /// The patches that meet, with the lengths of their seams.
    pub fn seams(&self) -> Vec<AtlasSeam> {
        let owners = self.owners();
        let mut lengths: BTreeMap<[usize; 2], f64> = BTreeMap::new();
        for (t, neighbours) in self.graph.neighbours.iter().enumerate() {
            for (side, other) in neighbours.iter().enumerate() {
                let Some(other) = other.map(|other| other as usize).filter(|&other| other > t)
                else {
                    continue;
                };
                if owners[t] != owners[other] {
                    let corners = self.prepared.surface.triangles[t];
                    let [a, b] = [side, (side + 1) % 3]
                        .map(|k| self.prepared.surface.vertices[corners[k] as usize]);
                    let (one, two) = (owners[t], owners[other]);
                    *lengths.entry([one.min(two), one.max(two)]).or_default() += (b - a).norm();
                }
            }
        }
        (lengths.into_iter())
            .map(|(patches, length)| AtlasSeam { patches, length })
            .collect()
    }

    /// Returns the outlines of the patches on the surface unrolled as one piece \[m\], at any
    /// stretch. They are for pictures: where that chart covers itself, the patches overlap.
    pub fn overview(&self) -> Vec<Polygon> {
        let places = unroll_places(&self.prepared.surface);
        let outlines = (self.cells.iter()).map(|cell| {
            let mut is_beyond = vec![true; self.prepared.surface.triangles.len()];
            cell.iter().for_each(|&t| is_beyond[t as usize] = false);
            outline(&self.prepared.surface, &is_beyond, &places)
        });
        outlines.collect()
    }

    /// Returns the chart of a patch that reaches beyond its seams by up to `reach` \[m\], so that a tool finds the surface
    /// there. Outline, area and stretch are those up to the seams. Where the chart would fold or cover itself beyond the
    /// seams, it reaches less far.
    ///
    /// # Panics
    /// If there is no patch `index`.
    pub fn patch(&self, index: usize, reach: f64) -> Sheet {
        let mut reaches = (0..NARROWER).map(|halvings| reach * 0.5f64.powi(halvings));
        reaches
            .find_map(|reach| Sheet::checked(self.reaching(index, reach), &self.config))
            .unwrap_or_else(|| self.charts[index].clone())
    }

    /// Returns a patch with the triangles beyond its seams up to a distance \[m\].
    fn reaching(&self, index: usize, reach: f64) -> Prepared {
        let cell = &self.cells[index];
        let (distances, _) = self.graph.spread(cell);
        let grown: Vec<u32> = (0u32..)
            .zip(&distances)
            .filter(|(_, distance)| **distance <= reach)
            .map(|(t, _)| t)
            .collect();
        let is_beyond = |t: &u32| cell.binary_search(t).is_err();
        Prepared {
            is_beyond: grown.iter().map(is_beyond).collect(),
            ..self.prepared.select(&grown)
        }
    }

    /// Returns a patch as a mesh in the frame of the mesh as given. Its vertices lie on that mesh, and its edges are at most
    /// a quarter of the tool's radius long.
    ///
    /// # Panics
    /// If there is no patch `index`.
    pub fn patch_mesh(&self, index: usize) -> Mesh {
        self.mesh_of(&self.cells[index])
            .expect("a patch has triangles")
    }

    /// Returns all other patches as one mesh, as [`Atlas::patch_mesh`]; `None` if there is no other.
    pub fn rest_mesh(&self, index: usize) -> Option<Mesh> {
        let others = (self.cells.iter().enumerate()).filter(|&(i, _)| i != index);
        let mut rest: Vec<u32> = others.flat_map(|(_, cell)| cell).copied().collect();
        rest.sort_unstable();
        self.mesh_of(&rest)
    }

    /// Returns some triangles as a mesh, without smoothing.
    fn mesh_of(&self, triangles: &[u32]) -> Option<Mesh> {
        let part = self.prepared.select(triangles);
        Mesh::new(part.given, part.surface.triangles).ok()
    }

    /// The patch of each triangle.
    fn owners(&self) -> Vec<usize> {
        let mut owners = vec![usize::MAX; self.graph.neighbours.len()];
        for (index, cell) in self.cells.iter().enumerate() {
            cell.iter().for_each(|&t| owners[t as usize] = index);
        }
        owners
    }
}

/// The search for a division into few patches.
struct Search<'a> {
    prepared: &'a Prepared,
    graph: &'a CellGraph,
    config: &'a SheetConfig,
}

impl Search<'_> {
    /// Returns the division into the fewest patches that is found, and at most `most`.
    fn divide(&self, most: usize) -> Result<Division, SheetError> {
        let all: Vec<u32> = (0..self.prepared.surface.triangles.len() as u32).collect();
        let whole = Sheet::unrolled(self.prepared.clone(), self.config)?;
        let Err(refused) = whole.check() else {
            return Ok(vec![(all, whole)]);
        };
        let joined = self.halve(&all).map(|halves| self.join(halves));
        let fewest = joined.as_ref().map_or(MAX_EQUAL_CELLS, Vec::len);
        let graphs = [self.graph.clone(), self.graph.with_factors(self.bends())];
        // Fewer cells than half of the estimate have never sufficed.
        let least = (whole.estimate_charts() / 2).max(2);
        for count in least..=fewest.min(MAX_EQUAL_CELLS).min(most) {
            for graph in &graphs {
                if let Some(division) = self.unroll_all(graph.divide(count)) {
                    return Ok(division);
                }
            }
        }
        joined
            .filter(|division| division.len() <= most)
            .ok_or(refused)
    }

    fn unroll(&self, cell: &[u32]) -> Option<Sheet> {
        Sheet::checked(self.prepared.select(cell), self.config)
    }

    /// Unrolls all cells; `None` if one is refused.
    fn unroll_all(&self, cells: Vec<Vec<u32>>) -> Option<Division> {
        let sheets: Option<Vec<Sheet>> = (cells.par_iter()).map(|cell| self.unroll(cell)).collect();
        Some(cells.into_iter().zip(sheets?).collect())
    }

    /// Factors by which distances grow where the surface bends in two directions: √|K| and half its mean \[1/m\].
    fn bends(&self) -> Vec<f64> {
        let surface = &self.prepared.surface;
        let curvature: Vec<f64> = (self.prepared.fits.iter())
            .map(|fit| {
                let [x, y] = axes_across(fit.normal, Vector3::x());
                let form = |a: &Vector3, b: &Vector3| a.dot(&(fit.bend * b));
                (form(&x, &x) * form(&y, &y) - form(&x, &y) * form(&y, &x)).abs()
            })
            .collect();
        let of = |triangle: &[u32; 3]| {
            triangle.iter().map(|&i| curvature[i as usize]).sum::<f64>() / 3.0
        };
        let area = |&triangle: &[u32; 3]| surface.doubled_normal(triangle).norm();
        let total: f64 = surface.triangles.iter().map(area).sum();
        let sum: f64 = (surface.triangles.iter())
            .map(|triangle| of(triangle) * area(triangle))
            .sum();
        let mean = (sum / total.max(f64::MIN_POSITIVE)).sqrt();
        (surface.triangles.iter())
            .map(|triangle| of(triangle).sqrt() + 0.5 * mean + f64::EPSILON)
            .collect()
    }

    /// Halves cells until each unrolls; `None` if that takes more than [`MAX_CHARTS`] cells.
    fn halve(&self, all: &[u32]) -> Option<Division> {
        let (mut found, mut open) = (Vec::new(), self.halves(all));
        while !open.is_empty() {
            if found.len() + open.len() > MAX_CHARTS {
                return None;
            }
            let sheets: Vec<Option<Sheet>> =
                (open.par_iter()).map(|cell| self.unroll(cell)).collect();
            let mut refused = Vec::new();
            for (cell, sheet) in open.into_iter().zip(sheets) {
                match sheet {
                    Some(sheet) => found.push((cell, sheet)),
                    // A single triangle is flat.
                    None => refused.extend(self.halves(&cell)),
                }
            }
            open = refused;
        }
        Some(found)
    }

    fn halves(&self, cell: &[u32]) -> Vec<Vec<u32>> {
        let part = self.prepared.surface.select(cell);
        let halves = CellGraph::new(&part).divide(2);
        let renamed = |half: Vec<u32>| half.into_iter().map(|t| cell[t as usize]).collect();
        halves.into_iter().map(renamed).collect()
    }

    /// Joins neighbouring cells while their union unrolls within the limit, the smallest unions first, until the limit of the
    /// work.
    fn join(&self, mut division: Division) -> Division {
        let mut refused: BTreeSet<Vec<u32>> = BTreeSet::new();
        let (mut work, most_work) = (0, JOINING * self.graph.neighbours.len());
        loop {
            let mut owners = vec![usize::MAX; self.graph.neighbours.len()];
            for (index, (cell, _)) in division.iter().enumerate() {
                cell.iter().for_each(|&t| owners[t as usize] = index);
            }
            let mut pairs = BTreeSet::new();
            for (t, neighbours) in self.graph.neighbours.iter().enumerate() {
                for other in neighbours.iter().flatten() {
                    let (one, two) = (owners[t], owners[*other as usize]);
                    if one < two {
                        pairs.insert([one, two]);
                    }
                }
            }
            let mut pairs: Vec<[usize; 2]> = pairs.into_iter().collect();
            let area = |&[one, two]: &[usize; 2]| division[one].1.area() + division[two].1.area();
            pairs.sort_by(|one, two| area(one).total_cmp(&area(two)).then(one.cmp(two)));
            let unions: Vec<([usize; 2], Vec<u32>)> = (pairs.into_iter())
                .map(|[one, two]| {
                    let mut union = [division[one].0.as_slice(), &division[two].0].concat();
                    union.sort_unstable();
                    ([one, two], union)
                })
                .filter(|(_, union)| !refused.contains(union))
                .collect();
            let joined = unions.chunks(AT_ONCE).find_map(|unions| {
                if work > most_work {
                    return None;
                }
                work += unions.iter().map(|(_, union)| union.len()).sum::<usize>();
                let sheets: Vec<Option<Sheet>> = (unions.par_iter())
                    .map(|(_, union)| self.unroll(union).filter(is_compact))
                    .collect();
                let first = sheets.iter().position(Option::is_some);
                let before = unions.iter().take(first.unwrap_or(unions.len()));
                refused.extend(before.map(|(_, union)| union.clone()));
                let sheet = sheets.into_iter().nth(first?)??;
                let (pair, union) = unions[first?].clone();
                Some((pair, (union, sheet)))
            });
            let Some(([one, two], union)) = joined else {
                return division;
            };
            division.remove(two);
            division[one] = union;
        }
    }
}

/// Whether a chart is compact: neither long, nor bow-shaped, nor a ring. Tools wipe other charts in
/// many short strokes.
fn is_compact(sheet: &Sheet) -> bool {
    let outline = sheet.outline();
    let border: f64 = outline
        .edges()
        .map(|edge| (edge.end - edge.start).norm())
        .sum();
    border * border <= LONGEST_BORDER * 4.0 * PI * outline.area()
        && outline.contains(Point2::origin())
}

/// Orders patches so that each is near the previous one, beginning with the least x of the patches'
/// middles.
fn order(mut open: Division) -> Division {
    let middle = |(_, sheet): &(Vec<u32>, Sheet)| sheet.extend(Point2::origin()).point;
    let mut ordered: Division = Vec::new();
    while !open.is_empty() {
        let last: Option<Point3> = ordered.last().map(middle);
        let key = |patch: &(Vec<u32>, Sheet)| match last {
            Some(last) => (middle(patch) - last).norm(),
            None => middle(patch).x,
        };
        let nearest =
            (0..open.len()).min_by(|&one, &two| key(&open[one]).total_cmp(&key(&open[two])));
        ordered.push(open.remove(nearest.unwrap_or(0)));
    }
    ordered
}
