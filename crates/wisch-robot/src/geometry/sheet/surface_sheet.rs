//! A surface of a mesh in one chart.

use super::error::SheetError;
use super::flatten::{FlatTriangle, flat_triangles, flatten};
use super::locate::{ChartGrid, FootFinder, Located};
use super::part::MeshSurvey;
use super::prepared::{Prepared, SheetConfig, too_large};
use super::stretch::{
    SheetStretch, chart_from_triangle, measure, share_beyond, triangle_stretches,
};
use super::topology::Triangles;
use crate::geometry::{Mesh, Point2, Point3, Polygon, Pose, Vector2, Vector3};
use nalgebra::Matrix2;

/// Share of the area that may be stretched beyond the limit [1].
const STRETCHED_SHARE: f64 = 0.01;
/// Share of the area stretched beyond the limit after a few rounds at which a patch is abandoned [1].
const HOPELESS_SHARE: f64 = 0.3;
/// Weight of a triangle beyond the seams of a patch while the patch is unrolled, relative to one within it [1].
const WEIGHT_BEYOND: f64 = 0.01;
/// Smoothing by less than this does not matter to contact [m].
const LEAST_LIMIT: f64 = 5e-4;
/// Integral of the absolute Gaussian curvature that a part with a stretch of 3 % may have \[rad²\]. A cap of a sphere to the
/// angle θ has 2π(1 − cos θ) ≈ πθ², and a stretch of at least θ²/12: 0.6 leaves 1.6 %.
const CURVATURE_PER_PART: f64 = 0.6;

/// A surface of a mesh, unrolled into a chart as rigidly as possible.
///
/// The chart's origin is the centroid of the area, and its x axis follows that of the mesh as far as possible. Between the
/// vertices, the surface is flat, and its normals and bends are interpolated.
///
/// ```
/// use wisch_robot::geometry::{Mesh, Point2, Point3, Sheet, SheetConfig};
/// // A gutter of 0.5 m radius.
/// let mut vertices = Vec::new();
/// let mut triangles = Vec::new();
/// for i in 0..=20u32 {
///     let angle = 0.03 * (f64::from(i) - 10.0);
///     for y in [-0.2, 0.2] {
///         vertices.push(Point3::new(0.5 * angle.sin(), y, 0.5 * angle.cos() - 0.5));
///     }
///     if i > 0 {
///         let a = 2 * i - 2;
///         triangles.extend([[a, a + 2, a + 3], [a, a + 3, a + 1]]);
///     }
/// }
/// let sheet = Sheet::from_mesh(&Mesh::new(vertices, triangles)?, &SheetConfig::default())?;
/// assert!(sheet.stretch().most < 1e-3);
/// let middle = sheet.lift(Point2::origin()).unwrap();
/// assert!((middle.bend[(0, 0)] - 2.0).abs() < 0.1 && middle.bend[(1, 1)].abs() < 0.1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone)]
pub struct Sheet {
    surface: Triangles,
    normals: Vec<Vector3>,
    /// Second fundamental forms in the axes of the chart \[1/m\].
    bends: Vec<Matrix2<f64>>,
    places: Vec<Point2>,
    outline: Polygon,
    stretches: Vec<f64>,
    stretch: SheetStretch,
    survey: MeshSurvey,
    smoothed_by: f64,
    smoothed_at: Point3,
    areas: Vec<f64>,
    /// Directions of the chart's x at the vertices, not normalised.
    x_axes: Vec<Vector3>,
    overlap: Option<Point3>,
    stretch_limit: f64,
    grid: ChartGrid,
    finder: FootFinder,
}

/// A point of a sheet, with the surface around it; in the frame of the mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SheetPoint {
    /// The point \[m\].
    pub point: Point3,
    /// Unit normal, towards the tool.
    pub normal: Vector3,
    /// Unit vector along the chart's x, across the normal.
    pub x_axis: Vector3,
    /// Second fundamental form in the axes of the chart \[1/m\], positive where the surface bulges towards the tool.
    pub bend: Matrix2<f64>,
    /// Stretch of the triangle that holds the point \[1\].
    pub stretch: f64,
}

/// A point in space relative to a sheet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SheetFoot {
    /// Foot of the perpendicular, in the chart \[m\]; on the border for points beyond it.
    pub place: Point2,
    /// Height over the surface, along its normal \[m\].
    pub height: f64,
    /// Unit normal at the foot, in the frame of the mesh.
    pub normal: Vector3,
    /// Distance of the point from the perpendicular \[m\]: zero unless it is beyond the border.
    pub beyond: f64,
}

/// A vertex of a sheet: its position in space and in the chart, its normal and its bend.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SheetVertex {
    /// Place in the chart \[m\].
    pub place: Point2,
    /// Point in the frame of the mesh \[m\].
    pub point: Point3,
    /// Unit normal in the frame of the mesh.
    pub normal: Vector3,
    /// Second fundamental form in the axes of the chart \[1/m\].
    pub bend: Matrix2<f64>,
    /// Area that belongs to the vertex \[m²\].
    pub area: f64,
}

impl Sheet {
    /// Makes a sheet of a mesh, if one chart suffices.
    ///
    /// # Errors
    /// As [`Sheet::draft`], and for a chart that [`Sheet::check`] refuses.
    pub fn from_mesh(mesh: &Mesh, config: &SheetConfig) -> Result<Self, SheetError> {
        let sheet = Self::draft(mesh, config)?;
        sheet.check()?;
        Ok(sheet)
    }

    /// Makes a sheet of a mesh, even if its stretch exceeds the limit.
    ///
    /// # Errors
    /// If a setting is out of range, the mesh has no area, the part is closed and no direction to the tool is given, no
    /// triangle faces it, the part has no consistent side, or needs more than [`MAX_SHEET_TRIANGLES`](super::MAX_SHEET_TRIANGLES).
    pub fn draft(mesh: &Mesh, config: &SheetConfig) -> Result<Self, SheetError> {
        Self::unrolled(Prepared::new(mesh, config)?, config)
    }

    /// Makes a sheet of a prepared surface, if one chart suffices; `None` if it does not.
    pub(super) fn checked(prepared: Prepared, config: &SheetConfig) -> Option<Self> {
        let unrolled = Unrolled::new(&prepared, |unrolled| {
            unrolled.share_beyond(config.stretch_limit) > HOPELESS_SHARE
        });
        if unrolled.share_beyond(config.stretch_limit) > STRETCHED_SHARE {
            return None;
        }
        let sheet = Self::with_places(prepared, unrolled, config)?;
        sheet.check().is_ok().then_some(sheet)
    }

    /// Unrolls a prepared surface, even if its stretch exceeds the limit.
    pub(super) fn unrolled(prepared: Prepared, config: &SheetConfig) -> Result<Self, SheetError> {
        let unrolled = Unrolled::new(&prepared, |_| false);
        Self::with_places(prepared, unrolled, config).ok_or(too_large(config))
    }

    fn with_places(prepared: Prepared, unrolled: Unrolled, config: &SheetConfig) -> Option<Self> {
        let Prepared {
            surface,
            fits,
            survey,
            smoothed_by,
            smoothed_at,
            is_beyond,
            ..
        } = prepared;
        let Unrolled {
            flat,
            within,
            places,
            stretches,
            counted,
        } = unrolled;
        let limit = config.stretch_limit;
        let stretch = measure(
            &surface,
            &within,
            &places,
            &counted,
            limit,
            config.tool_radius,
        );
        let grid = ChartGrid::new(&places, &surface.triangles);
        let overlap = find_overlap(&surface, &places, &grid);
        let mut areas = vec![0.0; surface.vertices.len()];
        for (triangle, flat) in surface.triangles.iter().zip(&within) {
            triangle
                .iter()
                .for_each(|&i| areas[i as usize] += flat.area / 3.0);
        }
        let x_axes = chart_x_axes(&surface, &flat, &places);
        let bends = (fits.iter().zip(&x_axes))
            .map(|(fit, x_axis)| {
                let axes = axes_across(fit.normal, *x_axis);
                Matrix2::from_fn(|i, j| axes[i].dot(&(fit.bend * axes[j])))
            })
            .collect();
        Some(Self {
            finder: FootFinder::new(&surface)?,
            outline: outline(&surface, &is_beyond, &places),
            normals: fits.iter().map(|fit| fit.normal).collect(),
            bends,
            areas,
            x_axes,
            places,
            stretches,
            stretch,
            survey,
            smoothed_by,
            smoothed_at,
            overlap,
            stretch_limit: limit,
            grid,
            surface,
        })
    }

    /// Checks whether one chart suffices: at most 1 % of the area is stretched by more than the limit, no triangle lies upside
    /// down, and the chart does not cover itself.
    ///
    /// # Errors
    /// If it does not.
    pub fn check(&self) -> Result<(), SheetError> {
        let stretch = &self.stretch;
        if let Some(at) = stretch.folded_at {
            let triangles = stretch.folded;
            return Err(SheetError::Folded { triangles, at });
        }
        if let Some(at) = self.overlap {
            return Err(SheetError::Overlapping { at });
        }
        if stretch.share_beyond > STRETCHED_SHARE {
            return Err(SheetError::Stretched {
                at: stretch.at,
                stretch: stretch.most,
                limit: self.stretch_limit,
                share: stretch.share_beyond,
            });
        }
        Ok(())
    }

    /// Returns the point of the surface at a place of the chart \[m\]; `None` outside the outline.
    pub fn lift(&self, place: Point2) -> Option<SheetPoint> {
        let located = self
            .grid
            .holding(place, &self.places, &self.surface.triangles)
            .next()?;
        Some(self.point_at(located))
    }

    /// Returns foot and height of a point in the frame of the mesh \[m\]: the inverse of [`Self::lift`].
    pub fn chart(&self, point: Point3) -> SheetFoot {
        let located = self.finder.find(point, &self.surface, &self.normals);
        let foot = self.point_at(located);
        let offset = point - foot.point;
        let height = offset.dot(&foot.normal);
        SheetFoot {
            place: self.place_of(located),
            height,
            normal: foot.normal,
            beyond: (offset - foot.normal * height).norm(),
        }
    }

    /// Returns the point over any place \[m\]: that of [`Sheet::lift`], and beyond the outline that of the tangent plane at
    /// the nearest place of the border.
    ///
    /// ```
    /// # use wisch_robot::geometry::{Mesh, Point2, Point3, Sheet, SheetConfig};
    /// let corners = [[0.0, 0.0], [0.4, 0.0], [0.4, 0.3], [0.0, 0.3]];
    /// let board = Mesh::new(
    ///     corners.map(|[x, y]| Point3::new(x, y, 0.1)).to_vec(),
    ///     vec![[0, 1, 2], [0, 2, 3]],
    /// )?;
    /// let sheet = Sheet::from_mesh(&board, &SheetConfig::default())?;
    /// // The chart's origin is the middle of the board.
    /// let beyond = sheet.extend(Point2::new(0.3, 0.0));
    /// assert!((beyond.point - Point3::new(0.5, 0.15, 0.1)).norm() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn extend(&self, place: Point2) -> SheetPoint {
        if let Some(point) = self.lift(place) {
            return point;
        }
        let Some(located) = self
            .finder
            .nearest_on_border(place, &self.places, &self.surface)
        else {
            return self.point_at(Located {
                triangle: 0,
                weights: [1.0 / 3.0; 3],
            });
        };
        let border = self.point_at(located);
        let offset = place - self.place_of(located);
        let y_axis = border.normal.cross(&border.x_axis);
        SheetPoint {
            point: border.point + border.x_axis * offset.x + y_axis * offset.y,
            ..border
        }
    }

    /// Returns the second fundamental form over any place, in the axes of the chart \[1/m\]: that of [`Sheet::extend`].
    pub fn bend(&self, place: Point2) -> Matrix2<f64> {
        let mut holding = (self.grid).holding(place, &self.places, &self.surface.triangles);
        let located = (holding.next()).or_else(|| {
            self.finder
                .nearest_on_border(place, &self.places, &self.surface)
        });
        self.bend_at(located.unwrap_or(Located {
            triangle: 0,
            weights: [1.0 / 3.0; 3],
        }))
    }

    fn bend_at(&self, located: Located) -> Matrix2<f64> {
        let corners = self.surface.triangles[located.triangle];
        let weighted = corners.iter().zip(located.weights);
        weighted.fold(Matrix2::zeros(), |bend, (&i, w)| {
            bend + self.bends[i as usize] * w
        })
    }

    /// Returns the place in the chart and the height of a point in the frame of the mesh \[m\]: the inverse of
    /// [`Sheet::extend`].
    pub fn chart_extended(&self, point: Point3) -> (Point2, f64) {
        let located = self.finder.find(point, &self.surface, &self.normals);
        let foot = self.point_at(located);
        let offset = point - foot.point;
        let y_axis = foot.normal.cross(&foot.x_axis);
        let beyond = Vector2::new(offset.dot(&foot.x_axis), offset.dot(&y_axis));
        (self.place_of(located) + beyond, offset.dot(&foot.normal))
    }

    /// Returns the place of the first point of the surface that a line along −z meets, from above; `None` if there is none.
    ///
    /// `at`: the line's x and y in the frame of the mesh \[m\].
    pub fn place_below(&self, at: Point2) -> Option<Point2> {
        Some(self.place_of(self.finder.find_below(at, &self.surface)?))
    }

    /// Returns the sheet in another frame. Its chart stays.
    pub fn transform(&self, frame_from_mesh: &Pose) -> Self {
        let turned = |vectors: &[Vector3]| vectors.iter().map(|v| frame_from_mesh * v).collect();
        let vertices = self.surface.vertices.iter().map(|p| frame_from_mesh * p);
        let surface = Triangles {
            vertices: vertices.collect(),
            triangles: self.surface.triangles.clone(),
        };
        Self {
            finder: FootFinder::new(&surface).unwrap_or_else(|| self.finder.clone()),
            surface,
            normals: turned(&self.normals),
            x_axes: turned(&self.x_axes),
            overlap: self.overlap.map(|p| frame_from_mesh * p),
            stretch: SheetStretch {
                at: frame_from_mesh * self.stretch.at,
                folded_at: self.stretch.folded_at.map(|p| frame_from_mesh * p),
                ..self.stretch
            },
            ..self.clone()
        }
    }

    fn place_of(&self, located: Located) -> Point2 {
        let corners = self.surface.triangles[located.triangle];
        let sum = (corners.iter().zip(located.weights)).fold(Vector2::zeros(), |sum, (&i, w)| {
            sum + self.places[i as usize].coords * w
        });
        Point2::from(sum)
    }

    fn point_at(&self, located: Located) -> SheetPoint {
        let corners = self.surface.triangles[located.triangle];
        let weighted = || corners.iter().map(|&i| i as usize).zip(located.weights);
        let sum = |vector: &dyn Fn(usize) -> Vector3| {
            weighted().fold(Vector3::zeros(), |sum, (i, w)| sum + vector(i) * w)
        };
        let point = Point3::from(sum(&|i| self.surface.vertices[i].coords));
        let facet = self.surface.doubled_normal(corners).try_normalize(0.0);
        let normal = (sum(&|i| self.normals[i]).try_normalize(0.0))
            .or(facet)
            .unwrap_or_else(Vector3::z);
        let [x_axis, _] = axes_across(normal, sum(&|i| self.x_axes[i]));
        SheetPoint {
            point,
            normal,
            x_axis,
            bend: self.bend_at(located),
            stretch: self.stretches[located.triangle],
        }
    }

    /// Outline of the chart with its holes \[m\].
    pub fn outline(&self) -> &Polygon {
        &self.outline
    }

    /// How much the chart stretches lengths.
    pub fn stretch(&self) -> &SheetStretch {
        &self.stretch
    }

    /// Properties of the mesh from which the sheet was made.
    pub fn survey(&self) -> &MeshSurvey {
        &self.survey
    }

    /// Largest distance by which smoothing moved a vertex \[m\].
    pub fn smoothed_by(&self) -> f64 {
        self.smoothed_by
    }

    /// Point of the mesh as given that smoothing moved farthest, in the frame of the mesh \[m\].
    pub fn smoothed_at(&self) -> Point3 {
        self.smoothed_at
    }

    /// Returns the largest distance by which smoothing may move a surface so that a tool with this compression still touches
    /// the surface as given \[m\]: the compression, and at least 0.5 mm.
    ///
    /// ```
    /// use wisch_robot::geometry::Sheet;
    /// assert_eq!(Sheet::limit_smoothing(0.005), 0.005);
    /// assert_eq!(Sheet::limit_smoothing(0.0), 0.0005);
    /// ```
    pub fn limit_smoothing(compression_depth: f64) -> f64 {
        compression_depth.max(LEAST_LIMIT)
    }

    /// Whether smoothing removed shapes that a tool with this compression \[m\] does not follow, so that contact there is not
    /// predicted; see [`Self::limit_smoothing`].
    pub fn is_smoothed_beyond(&self, compression_depth: f64) -> bool {
        self.smoothed_by > Self::limit_smoothing(compression_depth)
    }

    /// Area of the surface \[m²\].
    pub fn area(&self) -> f64 {
        self.areas.iter().sum()
    }

    /// Number of triangles of the chart.
    pub fn triangle_count(&self) -> usize {
        self.surface.triangles.len()
    }

    /// Iterates over the vertices.
    pub fn vertices(&self) -> impl Iterator<Item = SheetVertex> + '_ {
        (0..self.places.len()).map(|i| SheetVertex {
            place: self.places[i],
            point: self.surface.vertices[i],
            normal: self.normals[i],
            bend: self.bends[i],
            area: self.areas[i],
        })
    }

    /// Iterates over the triangles: vertex indices and stretch \[1\].
    pub fn triangles(&self) -> impl Iterator<Item = ([u32; 3], f64)> + '_ {
        (self.surface.triangles.iter().copied()).zip(self.stretches.iter().copied())
    }

    /// Estimates how many charts of a stretch of 3 % the surface needs, from its Gaussian curvature; a lower bound in
    /// practice.
    pub fn estimate_charts(&self) -> usize {
        let curvature: f64 = (self.bends.iter().zip(&self.areas))
            .map(|(bend, area)| bend.determinant().abs() * area)
            .sum();
        (curvature / CURVATURE_PER_PART).ceil().max(1.0) as usize
    }
}

/// A prepared surface with a place in the chart for each vertex.
struct Unrolled {
    flat: Vec<FlatTriangle>,
    /// The same, without weight beyond the seams.
    within: Vec<FlatTriangle>,
    places: Vec<Point2>,
    stretches: Vec<f64>,
    /// The stretches within the seams, and zero beyond.
    counted: Vec<f64>,
}

impl Unrolled {
    /// Unrolls a surface, with few rounds if `is_hopeless`.
    fn new(prepared: &Prepared, is_hopeless: impl Fn(&Self) -> bool) -> Self {
        let surface = &prepared.surface;
        let flat = flat_triangles(surface);
        let weighted = |weight: f64| -> Vec<FlatTriangle> {
            (flat.iter().enumerate())
                .map(|(t, flat)| flat.weighted(if prepared.is_beyond(t) { weight } else { 1.0 }))
                .collect()
        };
        let with_places = |places: Vec<Point2>| {
            let stretches = triangle_stretches(surface, &flat, &places);
            // Only triangles within the seams count.
            let counted = (stretches.iter().enumerate())
                .map(|(t, &stretch)| if prepared.is_beyond(t) { 0.0 } else { stretch })
                .collect();
            Self {
                flat: flat.clone(),
                within: weighted(0.0),
                places,
                stretches,
                counted,
            }
        };
        with_places(flatten(
            surface,
            &weighted(WEIGHT_BEYOND),
            chart_axes(surface.mean_normal()),
            |places| is_hopeless(&with_places(places.to_vec())),
        ))
    }

    /// Returns the share of the area within the seams that is stretched beyond a limit \[1\].
    fn share_beyond(&self, limit: f64) -> f64 {
        share_beyond(&self.within, &self.counted, limit)
    }
}

/// Returns the places of the vertices of a surface, unrolled as one piece \[m\].
pub(super) fn unroll_places(surface: &Triangles) -> Vec<Point2> {
    flatten(
        surface,
        &flat_triangles(surface),
        chart_axes(surface.mean_normal()),
        |_| false,
    )
}

/// Returns the axes of the projection: x follows the mesh's x, or its y where x is nearly along the normal.
fn chart_axes(normal: Vector3) -> [Vector3; 2] {
    let normal = if normal == Vector3::zeros() {
        Vector3::z()
    } else {
        normal
    };
    let along = if normal.x.abs() < 0.9 {
        Vector3::x()
    } else {
        Vector3::y()
    };
    axes_across(normal, along)
}

/// Returns unit vectors across a unit normal, the first nearest to `along`.
pub(super) fn axes_across(normal: Vector3, along: Vector3) -> [Vector3; 2] {
    let x = (along - normal * normal.dot(&along)).try_normalize(1e-12);
    let x = x.unwrap_or_else(|| {
        let axis = Vector3::ith(normal.iamin(), 1.0);
        (axis - normal * normal.dot(&axis)).normalize()
    });
    [x, normal.cross(&x)]
}

/// Returns the direction of the chart's x on a triangle; zero for a triangle without area in the chart.
fn x_axis_of(surface: &Triangles, places: &[Point2], triangle: [u32; 3]) -> Vector3 {
    let [a, b, c] = triangle.map(|i| places[i as usize]);
    let [pa, pb, pc] = surface.corners(triangle);
    let chart = Matrix2::from_columns(&[b - a, c - a]);
    let Some(inverse) = chart.try_inverse() else {
        return Vector3::zeros();
    };
    (pb - pa) * inverse[(0, 0)] + (pc - pa) * inverse[(1, 0)]
}

/// Returns the direction of the chart's x at each vertex: the mean of its triangles.
fn chart_x_axes(surface: &Triangles, flat: &[FlatTriangle], places: &[Point2]) -> Vec<Vector3> {
    let mut axes = vec![Vector3::zeros(); surface.vertices.len()];
    for (&triangle, flat) in surface.triangles.iter().zip(flat) {
        if chart_from_triangle(flat, places, triangle).is_none() {
            continue;
        }
        let axis = x_axis_of(surface, places, triangle) * flat.area;
        triangle.iter().for_each(|&i| axes[i as usize] += axis);
    }
    axes
}

/// Returns the outline of the chart within the seams: the border of the largest area around it, and the other borders as
/// holes.
pub(super) fn outline(surface: &Triangles, is_beyond: &[bool], places: &[Point2]) -> Polygon {
    let within = Triangles {
        vertices: surface.vertices.clone(),
        triangles: (surface.triangles.iter().enumerate())
            .filter(|&(t, _)| !is_beyond.get(t).copied().unwrap_or(false))
            .map(|(_, &triangle)| triangle)
            .collect(),
    };
    let (within, origins) = within.with_single_fans();
    let place = |&i: &u32| places[origins[i as usize] as usize];
    let mut rings: Vec<Vec<Point2>> = (within.borders().iter())
        .map(|border| border.iter().map(place).collect())
        .collect();
    rings.sort_by(|one, other| ring_area(other).total_cmp(&ring_area(one)));
    if rings.is_empty() {
        return Polygon::new(Vec::new(), Vec::new());
    }
    let outer = rings.remove(0);
    Polygon::new(outer, rings)
}

fn ring_area(ring: &[Point2]) -> f64 {
    let next = ring.iter().cycle().skip(1);
    let doubled: f64 = (ring.iter().zip(next))
        .map(|(a, b)| a.coords.perp(&b.coords))
        .sum();
    0.5 * doubled.abs()
}

/// Returns a point whose place in the chart another triangle covers, too.
fn find_overlap(surface: &Triangles, places: &[Point2], grid: &ChartGrid) -> Option<Point3> {
    (surface.triangles.iter().enumerate()).find_map(|(t, triangle)| {
        let [a, b, c] = triangle.map(|i| places[i as usize].coords);
        let middle = Point2::from((a + b + c) / 3.0);
        let mut others = grid.holding(middle, places, &surface.triangles);
        let is_covered = others.any(|found| {
            // Not only by the rounding of a common edge.
            found.triangle != t && found.weights.iter().all(|&w| w > 1e-6)
        });
        let [a, b, c] = surface.corners(*triangle);
        is_covered.then(|| Point3::from((a.coords + b.coords + c.coords) / 3.0))
    })
}
