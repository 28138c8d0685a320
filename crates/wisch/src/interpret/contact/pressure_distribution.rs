//! Pressure under a compliant tool that is inclined to the plane.
//!
//! The tool is a bed of springs. A spring is compressed further where the plane rises towards the hand; where it would
//! be stretched, it has left the plane. The force is the mean over the tool.

use super::motions::{ContactMotion, NormalizedForce};
use crate::geometry::{Bounds2, PlanarPose, Point2, Vector2};
use crate::represent::ToolMotion;

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
    /// f′ in the middle of the tool; below 0 if the middle has left the plane [1].
    middle: f64,
    /// Gradient of f′ along the tool's x and y [1/m].
    rise: Vector2,
    bounds: Bounds2,
}

impl PressureDistribution {
    /// Returns the distribution under a tool with these `bounds` (tool frame); `compression` is that at nominal force
    /// [m]. `None` where the pressure is even.
    pub(in crate::interpret) fn of(
        contact: &ContactMotion,
        bounds: Option<Bounds2>,
        compression: f64,
    ) -> Option<Self> {
        let bounds = bounds.filter(|_| compression > 0.0)?;
        let rise = contact.slope / compression;
        let half = rise.abs().component_mul(&bounds.size()) / 2.0;
        (half.sum() > EVEN).then(|| Self {
            motion: contact.motion,
            middle: match contact.force {
                NormalizedForce::NoContact => -half.sum(),
                NormalizedForce::Mean(share) => middle(share, half),
                NormalizedForce::Middle(share) => share,
            },
            rise,
            bounds,
        })
    }

    /// Largest f′ under the tool [1].
    pub(in crate::interpret) fn most(&self) -> f64 {
        let half = self.rise.abs().dot(&self.bounds.size()) / 2.0;
        (self.middle + half).max(0.0)
    }

    /// Returns the largest f′ at a particle that the motion passes over [1].
    ///
    /// f′ changes linearly over the motion, so it is largest where the particle comes under the tool or where it is
    /// last.
    pub(in crate::interpret) fn share(&self, position: Point2) -> f64 {
        self.share_under(&self.motion.from, position)
            .max(self.share_under(&self.motion.to, position))
            .max(0.0)
    }

    fn share_under(&self, tool: &PlanarPose, position: Point2) -> f64 {
        let half = self.bounds.size() / 2.0;
        let place = tool.inverse_transform(position) - self.bounds.center();
        let place = Vector2::new(
            place.x.clamp(-half.x, half.x),
            place.y.clamp(-half.y, half.y),
        );
        self.middle + self.rise.dot(&place)
    }
}

/// Returns f′ in the middle of a rectangle, given its clipped mean; f′ changes by `half` from the middle to each side.
fn middle(mean: f64, half: Vector2) -> f64 {
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
}
