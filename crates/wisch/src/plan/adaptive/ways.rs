//! A cache of where the tool can move: the search asks about places near those that it asked about before.

use crate::geometry::{Bounds2, Point2};
use crate::plan::FreeSpace;
use crate::plan::clearance::MARCH_STEP;
use std::collections::HashMap;

/// Pitch of the grid of cached distances [m], and the largest number of grid nodes, beyond which the pitch
/// grows.
const PITCH: f64 = 0.005;
const MOST_NODES: f64 = 262_144.0;
/// Shortest step along a path when marching by cached distances [m].
const LEAST_STEP: f64 = 0.003;

/// Cached distances to the scene, and legs that were checked.
///
/// Distances are computed at the nodes of a grid, each when first needed. The distance changes by no more than
/// the way between two places (Lipschitz constant 1), so a node decides for most places near it whether the
/// tool can stand there.
pub(super) struct KnownWays<'a> {
    space: &'a FreeSpace,
    origin: Point2,
    pitch: f64,
    columns: usize,
    rows: usize,
    /// Distance at each node [m]; NaN if it has not been computed.
    distances: Vec<f64>,
    legs: HashMap<[u64; 4], bool>,
}

impl<'a> KnownWays<'a> {
    /// Largest number of cached legs.
    const MOST: usize = 1 << 16;

    pub(super) fn new(space: &'a FreeSpace) -> Self {
        let outline = space.surface().outline.outer().iter().copied();
        let bounds = Bounds2::from_points(outline).unwrap_or(Bounds2 {
            min: Point2::origin(),
            max: Point2::origin(),
        });
        let size = bounds.size();
        let pitch = PITCH
            .max((size.x * size.y / MOST_NODES).sqrt())
            .max(size.max() / MOST_NODES);
        let [columns, rows] = [size.x, size.y].map(|size| (size / pitch) as usize + 2);
        Self {
            space,
            origin: bounds.min,
            pitch,
            columns,
            rows,
            distances: vec![f64::NAN; columns * rows],
            legs: HashMap::new(),
        }
    }

    /// Lower and upper bound of the distance from a place to the scene [m].
    fn distance(&mut self, place: Point2) -> [f64; 2] {
        let at = (place - self.origin) / self.pitch;
        let (column, row) = (at.x.round(), at.y.round());
        let is_inside =
            (0.0..self.columns as f64).contains(&column) && (0.0..self.rows as f64).contains(&row);
        if !is_inside {
            return [self.space.distance(place); 2];
        }
        let node = self.origin + nalgebra::Vector2::new(column, row) * self.pitch;
        let known = &mut self.distances[row as usize * self.columns + column as usize];
        if known.is_nan() {
            *known = self.space.distance(node);
        }
        let off = (place - node).norm();
        [*known - off, *known + off]
    }

    /// Whether the tool touches nothing at a place.
    pub(super) fn is_clear(&mut self, place: Point2) -> bool {
        let [least, most] = self.distance(place);
        let radius = self.space.radius();
        least >= radius || most >= radius && self.space.is_clear(place)
    }

    /// Whether the tool may stand here within a stroke.
    pub(super) fn is_free(&mut self, place: Point2) -> bool {
        self.space.surface().outline.contains(place) && self.is_clear(place)
    }

    /// Whether the tool can move straight from `a` to `b`.
    pub(super) fn is_clear_between(&mut self, a: Point2, b: Point2) -> bool {
        if self.legs.len() >= Self::MOST {
            self.legs.clear();
        }
        let key = [a.x, a.y, b.x, b.y].map(f64::to_bits);
        if let Some(&is_clear) = self.legs.get(&key) {
            return is_clear;
        }
        let is_clear = self.space.surface().carries_between(a, b) && self.march(a, b);
        self.legs.insert(key, is_clear);
        is_clear
    }

    /// Marches from `a` by steps as long as the known free space ahead; where that is short, the exact distance
    /// is computed.
    fn march(&mut self, a: Point2, b: Point2) -> bool {
        let length = (b - a).norm();
        let mut at = 0.0;
        while at < length {
            let point = a + (b - a) * (at / length);
            let [least, most] = self.distance(point);
            let radius = self.space.radius();
            if most < radius {
                return false;
            }
            let step = match least - radius {
                known if known >= LEAST_STEP => known,
                _ => {
                    let margin = self.space.distance(point) - radius;
                    if margin < 0.0 {
                        return false;
                    }
                    margin.max(MARCH_STEP)
                }
            };
            at += step;
        }
        self.is_clear(b)
    }
}
