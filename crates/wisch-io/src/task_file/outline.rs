//! Outlines of surfaces: checks that rings bound an area and do not cross themselves or each other.

use super::TaskError;
use super::deserialize::At;
use super::tables::RingPoints;
use super::values::point;
use wisch::geometry::{Edge, Point2, Polygon, Vector2};

/// Maximum number of points of an outline with its holes; every pair of edges is compared.
const MAX_POINTS: usize = 2_000;
/// Number of renumbered edges that a message shows.
const NUMBERS_SHOWN: usize = 6;
/// Minimum area of a ring [m²]: that of the smallest rectangle.
const MIN_AREA: f64 = 1e-6;

/// A checked polygon of a task file.
pub(super) struct Outline {
    pub(super) polygon: Polygon,
    /// Whether the polygon's outer ring has the opposite direction of the typed points.
    reversed: bool,
}

impl Outline {
    /// Makes a rectangle; its points are in the order of [`Polygon::rectangle`].
    pub(super) fn rectangle(size: Vector2) -> Self {
        Self {
            polygon: Polygon::rectangle(size),
            reversed: false,
        }
    }

    pub(super) fn read(outer: &At<RingPoints>) -> Result<Self, TaskError> {
        let ring = ring(outer)?;
        let reversed = Polygon::new(ring.clone(), Vec::new()).outer() != ring;
        Ok(Self {
            polygon: Polygon::new(ring, Vec::new()),
            reversed,
        })
    }

    pub(super) fn with_holes(self, holes: &[At<RingPoints>]) -> Result<Self, TaskError> {
        let mut rings: Vec<Vec<Point2>> = Vec::new();
        let mut points = self.polygon.outer().len();
        for field in holes {
            let hole = ring(field)?;
            points += hole.len();
            if points > MAX_POINTS {
                return Err(field.inconsistent(format!(
                    "the outline with its holes exceeds the limit of {MAX_POINTS} points"
                )));
            }
            let others =
                std::iter::once(self.polygon.outer()).chain(rings.iter().map(Vec::as_slice));
            for (index, other) in others.enumerate() {
                let name = match index {
                    0 => "the outline".to_owned(),
                    i => format!("hole {}", i - 1),
                };
                if edges(&hole).any(|a| edges(other).any(|b| meet(a, b))) {
                    return Err(field.inconsistent(format!("the hole crosses or touches {name}")));
                }
            }
            if !self.polygon.contains(hole[0]) {
                return Err(field.inconsistent("the hole is outside the outline"));
            }
            let inside =
                |ring: &[Point2], point| Polygon::new(ring.to_vec(), Vec::new()).contains(point);
            let nested = rings
                .iter()
                .position(|other| inside(other, hole[0]) || inside(&hole, other[0]));
            if let Some(other) = nested {
                return Err(field.inconsistent(format!("the hole and hole {other} overlap")));
            }
            rings.push(hole);
        }
        Ok(Self {
            polygon: Polygon::new(self.polygon.outer().to_vec(), rings),
            reversed: self.reversed,
        })
    }

    /// Describes how edges are numbered, if the typed points run clockwise.
    pub(super) fn describe_numbering(&self) -> Option<String> {
        self.reversed.then(|| {
            let count = self.polygon.outer().len();
            let numbers: Vec<String> = (0..count.min(NUMBERS_SHOWN))
                .map(|typed| self.edge(typed).to_string())
                .collect();
            let more = if count > NUMBERS_SHOWN { ", …" } else { "" };
            format!(
                "surface.outline_m runs clockwise and is read in the other direction: its edges 0, 1, 2, … are numbered {}{more} in all results",
                numbers.join(", ")
            )
        })
    }

    /// Returns the polygon's index of the outer edge from the `typed`-th point to the next.
    pub(super) fn edge(&self, typed: usize) -> usize {
        let count = self.polygon.outer().len();
        if self.reversed {
            (2 * count - 2 - typed) % count
        } else {
            typed
        }
    }
}

/// Checks a ring: at least three points, no self-intersection, and a minimum area. A last point that repeats the first
/// closes the ring, as in GeoJSON, and is left out.
fn ring(field: &At<RingPoints>) -> Result<Vec<Point2>, TaskError> {
    let mut points: Vec<Point2> = field.value.iter().map(|xy| point(*xy)).collect();
    if points.len() > 3 && points.first() == points.last() {
        points.pop();
    }
    if !(3..=MAX_POINTS).contains(&points.len()) {
        return Err(field.inconsistent(format!(
            "{} points are outside the limits of a ring: 3 to {MAX_POINTS}",
            points.len()
        )));
    }
    let edges: Vec<Edge> = edges(&points).collect();
    let count = edges.len();
    if let Some(i) = edges.iter().position(|edge| edge.start == edge.end) {
        let next = (i + 1) % count;
        return Err(field.inconsistent(format!(
            "points {i} and {next} are equal; remove one of them"
        )));
    }
    for i in 0..count {
        for j in i + 1..count {
            let crosses = if j == i + 1 || (i == 0 && j == count - 1) {
                // Adjacent edges share a point; they must not overlap otherwise.
                let (one, other) = if j == i + 1 { (i, j) } else { (j, i) };
                runs_back(edges[one], edges[other])
            } else {
                meet(edges[i], edges[j])
            };
            if crosses {
                return Err(field.inconsistent(format!(
                    "the ring crosses itself: edge {i} meets edge {j} (edge i runs from point i to the next)"
                )));
            }
        }
    }
    let area = Polygon::new(points.clone(), Vec::new()).area();
    if area < MIN_AREA {
        return Err(field.inconsistent(format!(
            "its area of {area} m2 is below the limit of {MIN_AREA} m2"
        )));
    }
    Ok(points)
}

fn edges(ring: &[Point2]) -> impl Iterator<Item = Edge> + '_ {
    (0..ring.len()).map(|i| Edge {
        start: ring[i],
        end: ring[(i + 1) % ring.len()],
    })
}

fn runs_back(one: Edge, next: Edge) -> bool {
    let (a, b) = (one.end - one.start, next.end - next.start);
    a.perp(&b) == 0.0 && a.dot(&b) < 0.0
}

/// Whether two edges, with their ends, share a point.
fn meet(a: Edge, b: Edge) -> bool {
    let side = |edge: Edge, point: Point2| (edge.end - edge.start).perp(&(point - edge.start));
    let (a0, a1) = (side(b, a.start), side(b, a.end));
    let (b0, b1) = (side(a, b.start), side(a, b.end));
    if a0 * a1 < 0.0 && b0 * b1 < 0.0 {
        return true;
    }
    let on = |edge: Edge, side: f64, point: Point2| {
        side == 0.0 && (point - edge.start).dot(&(point - edge.end)) <= 0.0
    };
    on(b, a0, a.start) || on(b, a1, a.end) || on(a, b0, b.start) || on(a, b1, b.end)
}
