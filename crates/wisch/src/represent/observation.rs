//! What a camera sees of the dirt, and how far that can be trusted.

use super::GrainSize;
use crate::geometry::{Point2, Point3, Polygon, Pose, Region};

/// Most detections that an executor may hand over for one look.
pub const MAX_DETECTIONS: usize = 100_000;

/// What was seen of a surface at one moment, in the frame of the believed surface.
///
/// Nothing is known of what lies in [`Self::hidden`]; elsewhere, a particle that is not among the detections was
/// missed, or is not there.
///
/// ```
/// use wisch::geometry::Point2;
/// use wisch::represent::Observation;
/// let seen = Observation { detections: vec![Point2::new(0.1, 0.0)], ..Observation::default() };
/// assert!(!seen.is_hidden(Point2::origin()));
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Observation {
    /// Where dirt was seen [m], each spot once.
    pub detections: Vec<Point2>,
    /// Where nothing could be seen, such as behind an arm.
    pub hidden: Region,
}

impl Observation {
    /// Whether a place could not be seen.
    pub fn is_hidden(&self, place: Point2) -> bool {
        self.hidden.contains(place)
    }

    /// The same in the frame of a surface that is believed elsewhere, projected onto it along its normal; `now_from_then` is
    /// the pose of the surface it was seen on in the frame of the other.
    ///
    /// ```
    /// use wisch::geometry::{Point2, Pose};
    /// use wisch::represent::Observation;
    /// let seen = Observation { detections: vec![Point2::new(0.1, 0.0)], ..Observation::default() };
    /// let moved = seen.moved(&Pose::translation(0.0, 0.2, 0.0));
    /// assert_eq!(moved.detections, [Point2::new(0.1, 0.2)]);
    /// ```
    pub fn moved(&self, now_from_then: &Pose) -> Self {
        let moved = |p: &Point2| (now_from_then * Point3::new(p.x, p.y, 0.0)).xy();
        let ring = |ring: &[Point2]| -> Vec<Point2> { ring.iter().map(moved).collect() };
        let hidden = self.hidden.polygons().iter().map(|part| {
            let holes = part.holes().iter().map(|hole| ring(hole));
            Polygon::new(ring(part.outer()), holes.collect())
        });
        Self {
            detections: ring(&self.detections),
            hidden: Region::new(hidden.collect()),
        }
    }
}

/// How well dirt is seen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SensorModel {
    /// Probability that a grain much larger than `half_size_m` is detected [1].
    pub detection: f64,
    /// Diameter at which this probability is halved [m].
    pub half_size_m: f64,
    /// Detections where nothing lies, per area [1/m²].
    pub false_alarms_per_m2: f64,
    /// Standard deviation of where a grain is seen, along x and along y [m].
    pub position_error_m: f64,
}

/// Whether and how well a robot sees dirt of a medium.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sight {
    /// How well dirt is seen.
    pub sensor: SensorModel,
    /// Probability that a grain of this medium is detected where nothing hides it [1]; see
    /// [`SensorModel::mean_detection`].
    pub detection: f64,
}

/// How steeply detection rises about the half size.
const STEEPNESS: i32 = 4;
/// Diameters over which the mean over a range of sizes is taken.
const SIZES: usize = 16;

impl SensorModel {
    /// Probability that a grain of this diameter [m] is detected where nothing hides it [1].
    pub fn detection_of(&self, diameter: f64) -> f64 {
        if self.half_size_m <= 0.0 {
            return self.detection;
        }
        self.detection / (1.0 + (self.half_size_m / diameter).powi(STEEPNESS))
    }

    /// The same for a grain of unknown size, mean over a medium's sizes; `None` is a liquid, whose drops count as large.
    pub fn mean_detection(&self, sizes: Option<GrainSize>) -> f64 {
        let Some(sizes) = sizes else {
            return self.detection;
        };
        let at = |i: usize| {
            let share = (i as f64 + 0.5) / SIZES as f64;
            self.detection_of(sizes.min_m + (sizes.max_m - sizes.min_m) * share)
        };
        (0..SIZES).map(at).sum::<f64>() / SIZES as f64
    }
}

impl Default for SensorModel {
    /// A camera half a metre above the surface, a grain of half a millimetre on one pixel: an assumption.
    fn default() -> Self {
        Self {
            detection: 0.98,
            half_size_m: 3e-4,
            false_alarms_per_m2: 2.0,
            position_error_m: 2e-3,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_grains_are_seen_less_often() {
        let sensor = SensorModel {
            detection: 0.9,
            half_size_m: 1e-3,
            ..SensorModel::default()
        };
        assert!((sensor.detection_of(1e-3) - 0.45).abs() < 1e-12);
        assert!(sensor.detection_of(1e-2) > 0.899);
        let sizes = GrainSize {
            min_m: 1e-3,
            max_m: 2e-3,
        };
        let mean = sensor.mean_detection(Some(sizes));
        assert!(mean > 0.45 && mean < sensor.detection_of(2e-3), "{mean}");
        assert!((sensor.mean_detection(None) - 0.9).abs() < 1e-12);
    }
}
