//! Pressure under a tool that gives way and stands inclined to the plane.
//!
//! A bed of springs is compressed the more the higher the plane rises towards the hand, and where it would
//! be stretched it has left the plane. The force is the mean of that over the tool.

use super::motions::{ContactMotion, NormalizedForce};
use crate::geometry::{Bounds2, PlanarPose, Point2, Vector2};
use crate::represent::ToolMotion;

/// Difference of f′ under the tool below which it presses evenly [1]; a fraction of what is measured.
const EVEN: f64 = 1e-3;
/// Halvings in search of the mean: 1e-6 of the difference under the tool.
const HALVINGS: usize = 20;
/// The smaller of two differences is at least this share of the larger [1]; the formula divides by both.
const LEAST_RATIO: f64 = 1e-3;

/// f′ under a tool that presses unevenly, by place.
#[derive(Debug)]
pub(in crate::interpret) struct PressureDistribution {
    motion: ToolMotion,
    /// f′ in the middle of the tool; below 0 where the tool has left the plane there [1].
    middle: f64,
    /// Rise of f′ along the tool's x and y [1/m].
    rise: Vector2,
    bounds: Bounds2,
}

impl PressureDistribution {
    /// Under a tool within `bounds` (tool frame) that has this compression at nominal force [m]. `None` where
    /// it presses evenly.
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

    /// Largest f′ that a particle feels which the motion passes over [1].
    ///
    /// It feels it where it comes under the tool and where it last is, if it stays: between them f′ changes
    /// evenly.
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

/// f′ in the middle of a rectangle with this mean of f′, where f′ changes by `half` from there to each side.
fn middle(mean: f64, half: Vector2) -> f64 {
    if mean >= half.sum() {
        return mean;
    }
    let largest = half.max();
    let half = half.map(|one| one.max(LEAST_RATIO * largest));
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

/// Mean over a rectangle of what is above 0 of a plane with this height in the middle: the plane integrated
/// twice, at the corners.
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
    fn the_mean_of_what_is_pressed_is_the_force() {
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
        // A wedge: 0.02 of a rise of 0.6 in all over the tool is a triangle of width w, 0.6 w²/2 = 0.02.
        let wedge = middle(0.02, Vector2::new(0.3, 0.0)) + 0.3;
        assert!(
            (wedge - (2.0 * 0.02 * 0.6_f64).sqrt()).abs() < 1e-3,
            "{wedge}"
        );
    }
}
