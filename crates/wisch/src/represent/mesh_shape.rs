//! The shape of a surface that is a mesh: its chart, and the mesh as it was given.

use super::LeastRadii;
use crate::geometry::{
    Atlas, Edge, Mesh, Point2, Point3, Polygon, Pose, Sheet, SheetConfig, SheetError, Vector3,
};
use nalgebra::{Matrix2, Matrix3, Rotation3, Translation3, UnitQuaternion};
use std::collections::BTreeMap;
use std::fmt;
use std::sync::Arc;

/// The prime of FNV-1a with 128 bits.
const FNV_PRIME: u128 = 0x0000_0000_0100_0000_0000_0000_0000_013B;
/// Largest distance between the places at which a bend is sampled, relative to the radius of the tool [1].
const SAMPLE_SHARE: f64 = 0.5;

/// The shape of a surface of a mesh, in the frame of the surface: its origin is the chart's, with z along the normal and x
/// along the chart's x.
///
/// ```
/// use wisch::geometry::{Mesh, Point2, Point3, SheetConfig};
/// use wisch::represent::MeshShape;
/// // A board of 0.4 m × 0.3 m, whose file has its origin at a corner.
/// let corners = [[0.0, 0.0], [0.4, 0.0], [0.4, 0.3], [0.0, 0.3]];
/// let corners = corners.map(|[x, y]| Point3::new(x, y, 0.1));
/// let board = Mesh::new(corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]])?;
/// let (shape, mesh_from_surface) = MeshShape::from_mesh(&board, &SheetConfig::default())?;
/// assert!((mesh_from_surface.translation.vector.xy().norm() - 0.25).abs() < 1e-6);
/// assert!((shape.sheet().outline().area() - 0.12).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone)]
pub struct MeshShape {
    sheet: Sheet,
    mesh: Mesh,
    digest: u128,
    samples: Vec<(Point2, Matrix2<f64>)>,
    tightest: Matrix2<f64>,
    patch: Option<PatchOfMesh>,
}

/// Largest distance from the perpendicular at which a point lies over a patch \[m\].
const SEAM: f64 = 1e-3;

/// The patch of a divided mesh that a shape is.
#[derive(Clone)]
pub struct PatchOfMesh {
    /// Index among all patches.
    pub index: usize,
    /// The divided mesh.
    pub atlas: Arc<Atlas>,
    /// Pose of the surface's frame in the frame of the mesh.
    pub mesh_from_surface: Pose,
}

impl PatchOfMesh {
    /// Iterates over the areas of all patches \[m²\].
    pub fn areas(&self) -> impl Iterator<Item = f64> + '_ {
        self.atlas.charts().iter().map(Sheet::area)
    }
}

impl MeshShape {
    /// Returns the shape of a mesh, and the pose of the surface's frame in the frame of the mesh.
    ///
    /// # Errors
    /// If one chart does not suffice, see [`Sheet::from_mesh`].
    pub fn from_mesh(mesh: &Mesh, config: &SheetConfig) -> Result<(Self, Pose), SheetError> {
        let sheet = Sheet::from_mesh(mesh, config)?;
        Ok(Self::new(sheet, mesh, config.tool_radius))
    }

    /// Returns the shape of a patch of a divided mesh, and the pose of the surface's frame in the frame of the mesh. The chart
    /// reaches beyond the seams by the radius of the tool, and the outline does not.
    ///
    /// - `mesh`: the whole mesh that was divided, against which motions are audited.
    /// - `index`: index of the patch.
    ///
    /// # Panics
    /// If there is no such patch.
    pub fn from_patch(mesh: &Mesh, atlas: &Arc<Atlas>, index: usize) -> (Self, Pose) {
        let radius = atlas.config().tool_radius;
        let (shape, mesh_from_surface) = Self::new(atlas.patch(index, radius), mesh, radius);
        let shape = Self {
            // Of FNV-1a; the index tells the patches of one mesh apart.
            digest: (shape.digest ^ (index as u128 + 1)).wrapping_mul(FNV_PRIME),
            patch: Some(PatchOfMesh {
                index,
                atlas: Arc::clone(atlas),
                mesh_from_surface,
            }),
            ..shape
        };
        (shape, mesh_from_surface)
    }

    fn new(sheet: Sheet, mesh: &Mesh, tool_radius: f64) -> (Self, Pose) {
        let mesh_from_surface = frame(&sheet, Point2::origin(), 0.0);
        let surface_from_mesh = mesh_from_surface.inverse();
        let sheet = sheet.transform(&surface_from_mesh);
        let samples = sample(&sheet, SAMPLE_SHARE * tool_radius);
        let shape = Self {
            tightest: find_tightest(&samples),
            samples,
            mesh: mesh.transform(&surface_from_mesh),
            digest: mesh.digest(),
            patch: None,
            sheet,
        };
        (shape, mesh_from_surface)
    }

    /// Returns the shape with another mesh against which motions are audited, such as a scan, in the frame of the surface.
    #[must_use]
    pub fn with_mesh(self, mesh: Mesh) -> Self {
        Self { mesh, ..self }
    }

    /// The chart, in the frame of the surface.
    pub fn sheet(&self) -> &Sheet {
        &self.sheet
    }

    /// The mesh as it was given, in the frame of the surface.
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// The patch of a divided mesh that the surface is; `None` for a whole mesh.
    pub fn patch(&self) -> Option<&PatchOfMesh> {
        self.patch.as_ref()
    }

    /// Whether a place outside the outline lies on another patch of the divided mesh, over which the chart reaches; `false` for
    /// a whole mesh.
    pub fn reaches_beyond_seam(&self, place: Point2) -> bool {
        self.patch.is_some() && self.sheet.lift(place).is_some()
    }

    /// Whether a point in the frame of the surface lies beyond the chart, and within `height` of another patch of the divided
    /// mesh \[m\]; `false` for a whole mesh.
    pub fn is_on_other_patch(&self, point: Point3, height: f64) -> bool {
        let Some(patch) = &self.patch else {
            return false;
        };
        let at = patch.mesh_from_surface * point;
        let is_over = |chart: &Sheet| {
            let foot = chart.chart(at);
            foot.beyond <= SEAM && foot.height.abs() <= height
        };
        let charts = patch.atlas.charts().iter().enumerate();
        self.sheet.chart(point).beyond > SEAM
            && charts
                .filter(|(index, _)| *index != patch.index)
                .any(|(_, chart)| is_over(chart))
    }

    /// The digest of the mesh from which the shape was made, in the frame of the mesh, see
    /// [`Mesh::digest`]; for a patch, its index is included.
    pub fn digest(&self) -> u128 {
        self.digest
    }

    /// Iterates over places of the chart about half a tool's radius apart, with their second fundamental forms \[1/m\].
    pub fn bends(&self) -> impl Iterator<Item = (Point2, Matrix2<f64>)> + '_ {
        self.samples.iter().copied()
    }

    /// The border of the chart, simplified by at most 0.2 mm: outline and holes \[m\].
    pub fn outline(&self) -> Polygon {
        let given = self.sheet.outline();
        let holes = given.holes().iter().map(|ring| simplify_ring(ring));
        Polygon::new(simplify_ring(given.outer()), holes.collect())
    }

    /// Returns the pose of a frame over a place, as [`super::SurfaceShape::place`].
    pub(super) fn place(&self, place: Point2, height: f64) -> Pose {
        frame(&self.sheet, place, height)
    }

    /// The bend to which a tool fits worst \[1/m\]: a bulge counts as much as a hollow of half its
    /// radius.
    pub fn tightest_bend(&self) -> Matrix2<f64> {
        self.tightest
    }

    /// Returns the least radii that occur, see [`Self::bends`].
    pub fn least_radii(&self) -> LeastRadii {
        LeastRadii::from_bends(self.bends().map(|(_, bend)| bend))
    }

    /// Returns the angle by which the normal turns on the path between two places \[rad\]; for an
    /// arc that turns back, the sum of all turns.
    pub(super) fn turn_between(&self, from: Point2, to: Point2) -> f64 {
        let along = to - from;
        let parts = (along.norm() / TURN_STEP).ceil().max(1.0) as usize;
        let place = |i: usize| from + along * (i as f64 / parts as f64);
        let normals: Vec<Vector3> = (0..=parts)
            .map(|i| self.sheet.extend(place(i)).normal)
            .collect();
        normals
            .windows(2)
            .map(|pair| angle(&pair[0], &pair[1]))
            .sum()
    }
}

/// Largest distance of a simplified border from the border [m].
const BORDER_ERROR: f64 = 2e-4;

/// Distance between places at which a normal is compared [m].
const TURN_STEP: f64 = 0.01;

impl PartialEq for MeshShape {
    /// Whether mesh and chart are the same.
    fn eq(&self, other: &Self) -> bool {
        let places = |shape: &Self| shape.sheet.vertices().map(|v| v.place).collect::<Vec<_>>();
        self.mesh == other.mesh && places(self) == places(other)
    }
}

impl fmt::Debug for MeshShape {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("MeshShape")
            .field("triangles", &self.mesh.triangles().len())
            .field("area", &self.sheet.area())
            .finish_non_exhaustive()
    }
}

/// Returns the principal curvatures of a second fundamental form \[1/m\], the larger first.
pub fn principal_curvatures(bend: &Matrix2<f64>) -> [f64; 2] {
    let (half, spread) = (
        0.5 * bend.trace(),
        libm::hypot(bend[(0, 1)], 0.5 * (bend[(0, 0)] - bend[(1, 1)])),
    );
    [half + spread, half - spread]
}

fn frame(sheet: &Sheet, place: Point2, height: f64) -> Pose {
    let at = sheet.extend(place);
    let axes = [at.x_axis, at.normal.cross(&at.x_axis), at.normal];
    let rotation = Rotation3::from_matrix_unchecked(Matrix3::from_columns(&axes));
    let point: Point3 = at.point + at.normal * height;
    Pose::from_parts(
        Translation3::from(point.coords),
        UnitQuaternion::from_rotation_matrix(&rotation),
    )
}

/// Returns a ring without needless corners (Ramer, 1972).
fn simplify_ring(ring: &[Point2]) -> Vec<Point2> {
    let farthest = |from: &Point2| {
        let distances = ring.iter().map(|p| (p - from).norm_squared()).enumerate();
        distances
            .max_by(|a, b| a.1.total_cmp(&b.1))
            .map_or(0, |(i, _)| i)
    };
    let Some(first) = ring.first() else {
        return Vec::new();
    };
    let begin = farthest(first);
    let turned: Vec<Point2> = (0..=ring.len())
        .map(|i| ring[(begin + i) % ring.len()])
        .collect();
    let other = (farthest(&turned[0]) + ring.len() - begin) % ring.len();
    let mut kept = Vec::new();
    let mut open = vec![(other, ring.len()), (0, other)];
    while let Some((from, to)) = open.pop() {
        let line = Edge {
            start: turned[from],
            end: turned[to],
        };
        let off = (from + 1..to).map(|i| (i, line.distance(turned[i])));
        match off.max_by(|a, b| a.1.total_cmp(&b.1)) {
            Some((i, distance)) if distance > BORDER_ERROR => open.extend([(i, to), (from, i)]),
            _ => kept.push(turned[from]),
        }
    }
    kept
}

fn angle(one: &Vector3, other: &Vector3) -> f64 {
    libm::atan2(one.cross(other).norm(), one.dot(other))
}

fn find_tightest(samples: &[(Point2, Matrix2<f64>)]) -> Matrix2<f64> {
    let size = |bend: &Matrix2<f64>| -> f64 {
        let needed = |k: f64| if k > 0.0 { k } else { -0.5 * k };
        principal_curvatures(bend).map(needed).iter().sum()
    };
    let bends = samples.iter().map(|(_, bend)| *bend);
    let tightest = bends.max_by(|one, other| size(one).total_cmp(&size(other)));
    tightest.unwrap_or_else(Matrix2::zeros)
}

/// Returns the bend at the first vertex in each square cell of the chart. Only vertices on the
/// surface count, because the chart of a patch reaches beyond its seams.
fn sample(sheet: &Sheet, cell: f64) -> Vec<(Point2, Matrix2<f64>)> {
    let mut found = BTreeMap::new();
    for vertex in sheet.vertices().filter(|vertex| vertex.area > 0.0) {
        let cell = [vertex.place.x, vertex.place.y].map(|at| (at / cell).floor() as i64);
        found.entry(cell).or_insert((vertex.place, vertex.bend));
    }
    found.into_values().collect()
}
