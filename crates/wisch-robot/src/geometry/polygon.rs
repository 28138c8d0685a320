//! Polygons with holes and regions made of several of them.

use super::{Point2, Vector2};

/// A straight edge of a boundary; the interior lies to its left.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Edge {
    /// Where the edge begins \[m\].
    pub start: Point2,
    /// Where the edge ends \[m\].
    pub end: Point2,
}

impl Edge {
    /// Returns the distance of a point from the closed edge \[m\].
    pub fn distance(&self, point: Point2) -> f64 {
        let along: Vector2 = self.end - self.start;
        let squared = along.norm_squared();
        let t = if squared > 0.0 {
            ((point - self.start).dot(&along) / squared).clamp(0.0, 1.0)
        } else {
            0.0
        };
        (point - (self.start + along * t)).norm()
    }
}

/// A simple polygon with holes. The outer ring is counter-clockwise, the holes are clockwise.
#[derive(Debug, Clone, PartialEq)]
pub struct Polygon {
    outer: Vec<Point2>,
    holes: Vec<Vec<Point2>>,
    is_convex: bool,
}

impl Polygon {
    /// Returns a polygon, with its rings brought into the right orientation. Rings are closed implicitly.
    pub fn new(outer: Vec<Point2>, holes: Vec<Vec<Point2>>) -> Self {
        let orient = |ring: Vec<Point2>, counter_clockwise: bool| {
            if (signed_area(&ring) > 0.0) == counter_clockwise {
                ring
            } else {
                ring.into_iter().rev().collect()
            }
        };
        let outer = orient(outer, true);
        Self {
            is_convex: holes.is_empty() && turns_left_once(&outer),
            outer,
            holes: holes.into_iter().map(|hole| orient(hole, false)).collect(),
        }
    }

    /// Returns an axis-aligned rectangle centred on the origin; `size` is its extent along x and y \[m\].
    pub fn rectangle(size: Vector2) -> Self {
        let (x, y) = (size.x / 2.0, size.y / 2.0);
        Self::new(
            vec![
                Point2::new(-x, -y),
                Point2::new(x, -y),
                Point2::new(x, y),
                Point2::new(-x, y),
            ],
            Vec::new(),
        )
    }

    /// Outer ring, counter-clockwise \[m\]; its last vertex joins the first, which is not repeated.
    pub fn outer(&self) -> &[Point2] {
        &self.outer
    }

    /// Rings of the holes, clockwise \[m\]; empty for a polygon without holes.
    pub fn holes(&self) -> &[Vec<Point2>] {
        &self.holes
    }

    /// Iterates over the outer ring, then the holes.
    pub fn rings(&self) -> impl Iterator<Item = &[Point2]> {
        std::iter::once(self.outer.as_slice()).chain(self.holes.iter().map(Vec::as_slice))
    }

    /// Iterates over all edges: those of the outer ring in order (edge i starts at vertex i), then those of the holes.
    pub fn edges(&self) -> impl Iterator<Item = Edge> + '_ {
        self.rings().flat_map(|ring| {
            (0..ring.len()).map(move |i| Edge {
                start: ring[i],
                end: ring[if i + 1 < ring.len() { i + 1 } else { 0 }],
            })
        })
    }

    /// Whether the outer ring is convex and there are no holes.
    pub fn is_convex(&self) -> bool {
        self.is_convex
    }

    /// Area of the polygon without its holes \[m²\].
    pub fn area(&self) -> f64 {
        self.rings().map(signed_area).sum()
    }

    /// Whether the polygon contains a point (even–odd rule; a point on the boundary belongs to either side).
    pub fn contains(&self, point: Point2) -> bool {
        encloses(self.edges(), point)
    }
}

/// Whether a ring never turns right and winds once, that is reverses its direction along x twice.
fn turns_left_once(ring: &[Point2]) -> bool {
    let count = ring.len();
    let along = |i: usize| ring[(i + 1) % count] - ring[i % count];
    let turns_left = (0..count).all(|i| along(i).perp(&along(i + 1)) >= 0.0);
    let ahead: Vec<bool> = (0..count)
        .map(|i| along(i).x)
        .filter(|&x| x != 0.0)
        .map(|x| x > 0.0)
        .collect();
    let changes = (0..ahead.len()).filter(|&i| ahead[i] != ahead[(i + 1) % ahead.len()]);
    turns_left && changes.count() <= 2
}

/// Whether a boundary of edges in any order contains a point (even–odd rule).
pub fn encloses(edges: impl IntoIterator<Item = Edge>, point: Point2) -> bool {
    let mut inside = false;
    for Edge { start, end } in edges {
        if (start.y > point.y) != (end.y > point.y) {
            let x = start.x + (point.y - start.y) / (end.y - start.y) * (end.x - start.x);
            inside ^= point.x < x;
        }
    }
    inside
}

/// Several disjoint polygons, such as the footprint of a brush.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Region {
    polygons: Vec<Polygon>,
}

impl Polygon {
    /// Returns the polygon scaled by a factor about the origin.
    fn scale(&self, factor: f64) -> Self {
        let ring = |ring: &Vec<Point2>| ring.iter().map(|corner| corner * factor).collect();
        Self {
            outer: ring(&self.outer),
            holes: self.holes.iter().map(ring).collect(),
            is_convex: self.is_convex,
        }
    }
}

impl Region {
    /// Returns a region of polygons in one frame, which must not overlap, as their areas are added.
    pub fn new(polygons: Vec<Polygon>) -> Self {
        Self { polygons }
    }

    /// Disjoint pieces, in the order of their creation.
    pub fn polygons(&self) -> &[Polygon] {
        &self.polygons
    }

    /// Returns the region scaled about the origin by a factor above 0.
    #[must_use]
    pub fn scale(&self, factor: f64) -> Self {
        let scaled = |polygon: &Polygon| polygon.scale(factor);
        Self::new(self.polygons.iter().map(scaled).collect())
    }

    /// Returns the region made narrower by a margin on each side of its bounding box \[m\], at most to half its extent.
    #[must_use]
    pub fn shrink(&self, margin: f64) -> Self {
        let Some(bounds) = self.bounds() else {
            return self.clone();
        };
        let center = bounds.center();
        let share = bounds
            .size()
            .map(|size| (1.0 - 2.0 * margin / size).clamp(0.5, 1.0));
        let moved = |corner: &Point2| center + (corner - center).component_mul(&share);
        let ring = |ring: &Vec<Point2>| ring.iter().map(moved).collect();
        let narrowed = |polygon: &Polygon| Polygon {
            outer: ring(&polygon.outer),
            holes: polygon.holes.iter().map(ring).collect(),
            ..polygon.clone()
        };
        Self::new(self.polygons.iter().map(narrowed).collect())
    }

    /// Iterates over the edges of all pieces, piece by piece, in the order of [`Polygon::edges`].
    pub fn edges(&self) -> impl Iterator<Item = Edge> + '_ {
        self.polygons.iter().flat_map(Polygon::edges)
    }

    /// Sum of the areas of all pieces \[m²\].
    pub fn area(&self) -> f64 {
        self.polygons.iter().map(Polygon::area).sum()
    }

    /// Whether any piece contains a point.
    pub fn contains(&self, point: Point2) -> bool {
        self.polygons.iter().any(|polygon| polygon.contains(point))
    }

    /// Returns the distance of a point from the nearest boundary \[m\]; infinity for an empty region.
    pub fn boundary_distance(&self, point: Point2) -> f64 {
        self.edges()
            .map(|edge| edge.distance(point))
            .fold(f64::INFINITY, f64::min)
    }

    /// Returns the smallest axis-aligned box around all pieces; `None` for an empty region.
    pub fn bounds(&self) -> Option<Bounds2> {
        Bounds2::from_points(self.polygons.iter().flat_map(|p| p.outer().iter().copied()))
    }
}

/// An axis-aligned box in the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bounds2 {
    /// Smallest x and y \[m\].
    pub min: Point2,
    /// Largest x and y \[m\].
    pub max: Point2,
}

impl Bounds2 {
    /// Returns the smallest box around the points; `None` if there are none.
    pub fn from_points(points: impl IntoIterator<Item = Point2>) -> Option<Self> {
        points.into_iter().fold(None, |bounds, p| {
            Some(match bounds {
                None => Self { min: p, max: p },
                Some(b) => Self {
                    min: b.min.inf(&p),
                    max: b.max.sup(&p),
                },
            })
        })
    }

    /// Whether a point is inside the box or on its border.
    pub fn contains(&self, point: Point2) -> bool {
        (self.min.x..=self.max.x).contains(&point.x) && (self.min.y..=self.max.y).contains(&point.y)
    }

    /// Extent along x and y \[m\].
    pub fn size(&self) -> Vector2 {
        self.max - self.min
    }

    /// Corners, counter-clockwise from the smallest x and y \[m\].
    pub fn corners(&self) -> [Point2; 4] {
        let Self { min, max } = *self;
        [
            min,
            Point2::new(max.x, min.y),
            max,
            Point2::new(min.x, max.y),
        ]
    }

    /// The middle of the box \[m\].
    pub fn center(&self) -> Point2 {
        nalgebra::center(&self.min, &self.max)
    }
}

/// Shoelace area of a ring [m²]; positive if it is counter-clockwise.
fn signed_area(ring: &[Point2]) -> f64 {
    let Some(&origin) = ring.first() else {
        return 0.0;
    };
    ring.windows(2)
        .map(|pair| (pair[0] - origin).perp(&(pair[1] - origin)))
        .sum::<f64>()
        / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square_with_hole() -> Polygon {
        let hole = Polygon::rectangle(Vector2::new(1.0, 1.0)).outer().to_vec();
        let outer = Polygon::rectangle(Vector2::new(2.0, 2.0)).outer().to_vec();
        Polygon::new(outer.into_iter().rev().collect(), vec![hole])
    }

    #[test]
    fn a_hole_is_taken_from_the_area_and_not_contained() {
        let polygon = square_with_hole();
        assert!((polygon.area() - 3.0).abs() < 1e-12);
        assert!(!polygon.contains(Point2::origin()));
        assert!(polygon.contains(Point2::new(0.75, 0.0)));
        assert!(!polygon.contains(Point2::new(1.25, 0.0)));
    }

    #[test]
    fn notches_holes_and_double_winding_are_not_convex() {
        let ring = |corners: &[[f64; 2]]| corners.iter().map(|&[x, y]| Point2::new(x, y)).collect();
        let polygon = |corners: &[[f64; 2]]| Polygon::new(ring(corners), Vec::new());
        assert!(Polygon::rectangle(Vector2::new(2.0, 1.0)).is_convex());
        assert!(polygon(&[[0.0, 0.0], [0.0, 1.0], [2.0, 0.5]]).is_convex());
        let on_a_side = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [1.0, 1.0]];
        assert!(polygon(&on_a_side).is_convex());
        assert!(!square_with_hole().is_convex());
        let notched = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 0.5], [0.0, 1.0]];
        assert!(!polygon(&notched).is_convex());
        // A five-pointed star in one line never turns right, and goes around twice.
        let star = [0.0_f64, 2.0, 4.0, 1.0, 3.0].map(|i| {
            let angle = i * std::f64::consts::TAU / 5.0;
            [angle.cos(), angle.sin()]
        });
        assert!(!polygon(&star).is_convex());
    }

    #[test]
    fn the_interior_lies_left_of_every_edge() {
        let polygon = square_with_hole();
        for edge in polygon.edges() {
            let along = edge.end - edge.start;
            let left = Vector2::new(-along.y, along.x).normalize() * 1e-6;
            assert!(polygon.contains(nalgebra::center(&edge.start, &edge.end) + left));
        }
    }
}
