//! Pressure under a compliant tool that is inclined to the plane, or lies on a bend.
//!
//! The tool is a bed of springs. A spring is compressed more where the surface rises towards the
//! hand. A spring that would be stretched has left the surface and carries no force. The force is
//! the mean over the tool.

use super::motions::{ContactMotion, NormalizedForce};
use super::tool_on_bend::ToolOnBend;
use crate::geometry::{Bounds2, PlanarPose, Point2, Vector2};
use crate::represent::{LocalPressure, MAX_PRESSURE, ToolMotion};

/// Difference of f′ under the tool below which the pressure counts as even [1]; a fraction of the measurement noise.
const EVEN: f64 = 1e-3;
/// Bisection steps of the mean: 1e-6 of the difference under the tool.
const HALVINGS: usize = 20;
/// Least ratio of the smaller difference to the larger [1], as the formula divides by both.
const LEAST_RATIO: f64 = 1e-3;

/// f′ under a tool that presses unevenly, as a function of place.
#[derive(Debug)]
pub(in crate::interpret) struct PressureDistribution {
    motion: ToolMotion,
    under: UnderTool,
    bounds: Bounds2,
}

/// f′ under the tool.
#[derive(Debug)]
enum UnderTool {
    /// On a plane.
    Linear {
        /// f′ in the middle of the tool; below 0 if the middle has left the plane [1].
        middle: f64,
        /// Gradient of f′ along the tool's x and y [1/m].
        rise: Vector2,
    },
    /// On a bend, with the least and the largest value [1].
    Bent(LocalPressure, [f64; 2]),
}

impl PressureDistribution {
    /// Returns the distribution under a tool with these `bounds` (tool frame); `compression` is that at nominal force
    /// [m]. `on_bend`: the tool on a surface that bends; `None` on a plane. Returns `None` where the pressure is even.
    pub(in crate::interpret) fn of(
        contact: &ContactMotion,
        bounds: Option<Bounds2>,
        compression: f64,
        on_bend: Option<&ToolOnBend>,
    ) -> Option<Self> {
        if let Some(tool) = on_bend {
            return Self::of_bend(contact, bounds?, tool);
        }
        let bounds = bounds.filter(|_| compression > 0.0)?;
        let rise = contact.slope / compression;
        let half = rise.abs().component_mul(&bounds.size()) / 2.0;
        (half.sum() > EVEN).then(|| Self {
            motion: contact.motion,
            under: UnderTool::Linear {
                middle: match contact.force {
                    NormalizedForce::NoContact => -half.sum(),
                    NormalizedForce::Mean(share) => middle(share, half),
                    NormalizedForce::Middle(share) => share,
                },
                rise,
            },
            bounds,
        })
    }

    fn of_bend(contact: &ContactMotion, bounds: Bounds2, tool: &ToolOnBend) -> Option<Self> {
        let force = match contact.force {
            NormalizedForce::NoContact => return None,
            NormalizedForce::Mean(share) | NormalizedForce::Middle(share) => share,
        };
        let at = contact.motion.from;
        let mut pressure = tool.press(force, at, contact.slope);
        if let NormalizedForce::Middle(share) = contact.force {
            // The distance is that of a tool on a plane (`ToolOnBend::level`), where the tool would
            // have this force.
            pressure.middle = share + tool.sinking(share, at) / tool.compression();
        }
        let range = tool.range(&pressure);
        (range[1] - range[0] > EVEN).then_some(Self {
            motion: contact.motion,
            under: UnderTool::Bent(pressure, range),
            bounds,
        })
    }

    /// Returns the pressure of a tool that touches a bend with a part of its footprint.
    pub(in crate::interpret) fn of_part(&self) -> Option<LocalPressure> {
        match self.under {
            UnderTool::Bent(pressure, [least, _]) if least < 0.0 => Some(pressure),
            _ => None,
        }
    }

    /// Largest f′ under the tool [1].
    pub(in crate::interpret) fn most(&self) -> f64 {
        match self.under {
            UnderTool::Linear { middle, rise } => {
                let half = rise.abs().dot(&self.bounds.size()) / 2.0;
                (middle + half).max(0.0)
            }
            UnderTool::Bent(_, [_, most]) => most.clamp(0.0, MAX_PRESSURE),
        }
    }

    /// Returns the largest f′ at a particle that the motion passes over [1].
    ///
    /// On a plane, f′ changes linearly over the motion, so it is largest where the particle comes under the tool or where
    /// it is last. On a bend it is a parabola on the particle's way under the tool.
    pub(in crate::interpret) fn share(&self, position: Point2) -> f64 {
        let ends = [&self.motion.from, &self.motion.to];
        match self.under {
            UnderTool::Linear { middle, rise } => {
                let [from, to] =
                    ends.map(|tool| middle + rise.dot(&self.place_under(tool, position)));
                from.max(to).max(0.0)
            }
            UnderTool::Bent(pressure, [_, most]) => {
                let way = ends.map(|tool| tool.inverse_transform(position));
                let [from, to] = clip(&self.bounds, way).unwrap_or_else(|| {
                    ends.map(|tool| self.bounds.center() + self.place_under(tool, position))
                });
                // Between the pieces of a footprint, the pressure is at most the largest one under
                // the pieces.
                pressure.largest_between(from, to).min(most.max(0.0))
            }
        }
    }

    /// Returns the place of the bounds that is nearest to a particle, from their centre [m].
    fn place_under(&self, tool: &PlanarPose, position: Point2) -> Vector2 {
        let half = self.bounds.size() / 2.0;
        let place = tool.inverse_transform(position) - self.bounds.center();
        Vector2::new(
            place.x.clamp(-half.x, half.x),
            place.y.clamp(-half.y, half.y),
        )
    }
}

/// Returns the part of a straight way within bounds; `None` if it does not meet them.
fn clip(bounds: &Bounds2, [from, to]: [Point2; 2]) -> Option<[Point2; 2]> {
    let along = to - from;
    let (mut low, mut high) = (0.0_f64, 1.0_f64);
    for axis in 0..2 {
        let [least, most] = [bounds.min, bounds.max].map(|corner| corner[axis] - from[axis]);
        if along[axis] == 0.0 {
            if least > 0.0 || most < 0.0 {
                return None;
            }
            continue;
        }
        let [a, b] = [least, most].map(|side| side / along[axis]);
        low = low.max(a.min(b));
        high = high.min(a.max(b));
    }
    (low <= high).then(|| [low, high].map(|share| from + along * share))
}

/// Returns f′ in the middle of a rectangle, given its clipped mean; f′ changes by `half` from the middle to each side.
pub(super) fn middle(mean: f64, half: Vector2) -> f64 {
    if mean >= half.sum() {
        return mean;
    }
    let largest = half.max();
    let half = half.map(|one| one.max(LEAST_RATIO * largest));
    // Clipping only raises the mean, so the middle is at most `mean`; bisect for it.
    let (mut low, mut high) = (-half.sum(), mean);
    for _ in 0..HALVINGS {
        let between = 0.5 * (low + high);
        if clipped_mean(between, half) < mean {
            low = between;
        } else {
            high = between;
        }
    }
    0.5 * (low + high)
}

/// Returns the mean over a rectangle of the positive part of a plane with height `middle` in its middle.
fn clipped_mean(middle: f64, half: Vector2) -> f64 {
    let cube = |x: f64| x.max(0.0).powi(3);
    let (a, b) = (half.x, half.y);
    let corners =
        cube(middle + a + b) - cube(middle + a - b) - cube(middle - a + b) + cube(middle - a - b);
    corners / (24.0 * a * b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_mean_of_the_pressure_is_the_force() {
        for (mean, half) in [
            (0.02, Vector2::new(0.3, 0.0)),
            (0.3, Vector2::new(0.2, 0.5)),
            (0.7, Vector2::new(0.9, 0.1)),
            (0.9, Vector2::new(0.2, 0.3)),
        ] {
            let middle = middle(mean, half);
            let steps = 200;
            let at = |i: i32| (2.0 * f64::from(i) + 1.0) / f64::from(steps) - 1.0;
            let mut sum = 0.0;
            for i in 0..steps {
                for j in 0..steps {
                    sum += (middle + half.x * at(i) + half.y * at(j)).max(0.0);
                }
            }
            let found = sum / f64::from(steps * steps);
            assert!((found - mean).abs() < 1e-3, "{mean} {half}: {found}");
        }
        // A wedge: with a total rise of 0.6, a mean of 0.02 is a triangle of width w, 0.6 w²/2 = 0.02.
        let wedge = middle(0.02, Vector2::new(0.3, 0.0)) + 0.3;
        assert!(
            (wedge - (2.0 * 0.02 * 0.6_f64).sqrt()).abs() < 1e-3,
            "{wedge}"
        );
    }

    /// Two computations of one quantity: the first has a closed form on a plane, the second
    /// integrates over the edges.
    #[test]
    fn an_inclined_tool_on_a_plane_is_that_of_an_elastic_foundation() {
        let side = Vector2::new(0.06, 0.1);
        let pad = crate::geometry::Region::new(vec![crate::geometry::Polygon::rectangle(side)]);
        let (compression, slope) = (0.004, Vector2::new(0.08, -0.03));
        let bed = crate::represent::ElasticFoundation::new(&pad, compression).unwrap();
        for force in [0.1, 0.5, 0.9] {
            let contact = ContactMotion {
                motion: ToolMotion {
                    from: PlanarPose::new(Point2::origin(), 0.0),
                    to: PlanarPose::new(Point2::origin(), 0.0),
                },
                force: NormalizedForce::Mean(force),
                slope,
                continues: false,
                end_time: 0.0,
            };
            let flat = PressureDistribution::of(&contact, pad.bounds(), compression, None).unwrap();
            let bent = bed.press(force, slope, &nalgebra::Matrix2::zeros());
            for place in [[0.0, 0.0], [0.03, -0.05], [-0.03, 0.05], [0.02, 0.01]] {
                let place = Point2::from(place);
                assert!(
                    (flat.share(place) - bent.evaluate(place)).abs() < 1e-5,
                    "{force} {place}"
                );
            }
        }
    }

    #[test]
    fn a_way_is_clipped_to_the_bounds() {
        let corner = Point2::new(1.0, 1.0);
        let bounds = Bounds2 {
            min: -corner,
            max: corner,
        };
        let clipped = |from: [f64; 2], to: [f64; 2]| clip(&bounds, [from.into(), to.into()]);
        let across = clipped([-3.0, 0.5], [2.0, 0.5]).unwrap();
        assert!((across[0] - Point2::new(-1.0, 0.5)).norm() < 1e-12);
        assert!((across[1] - Point2::new(1.0, 0.5)).norm() < 1e-12);
        assert_eq!(clipped([-3.0, 1.5], [2.0, 1.5]), None);
        assert_eq!(clipped([2.0, 0.0], [3.0, 0.0]), None);
        assert_eq!(
            clipped([0.2, 0.0], [0.2, 0.0]),
            Some([Point2::new(0.2, 0.0); 2])
        );
    }
}
