//! Camera observations of dirt, with the sensor model.

use super::{GrainSize, SurfaceShape};
use crate::geometry::{Point2, Point3, Polygon, Pose, Region};

/// Largest number of detections that an executor may return for one observation.
pub const MAX_DETECTIONS: usize = 100_000;

/// Detections of dirt on a surface at one moment, in the chart of the believed surface.
///
/// Nothing is known about dirt in [`Self::hidden`]. Elsewhere, a particle without a detection was
/// missed or is absent.
///
/// ```
/// use wisch::geometry::Point2;
/// use wisch::represent::Observation;
/// let seen = Observation { detections: vec![Point2::new(0.1, 0.0)], ..Observation::default() };
/// assert!(!seen.is_hidden(Point2::origin()));
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Observation {
    /// Places of detected dirt \[m\], one per detection.
    pub detections: Vec<Point2>,
    /// Occluded area in the same chart \[m\], such as the area behind an arm.
    pub hidden: Region,
}

impl Observation {
    /// Whether a place on the surface is occluded.
    pub fn is_hidden(&self, place: Point2) -> bool {
        self.hidden.contains(place)
    }

    /// Returns the observation in the frame of a surface at another pose, projected onto it along its normal.
    /// `now_from_then` is the pose of the observed surface in the frame of the other one; `shape` is that of both.
    ///
    /// ```
    /// use wisch::geometry::{Point2, Pose};
    /// use wisch::represent::{Observation, SurfaceShape};
    /// let seen = Observation { detections: vec![Point2::new(0.1, 0.0)], ..Observation::default() };
    /// let moved = seen.transform(&Pose::translation(0.0, 0.2, 0.0), &SurfaceShape::Plane);
    /// assert_eq!(moved.detections, [Point2::new(0.1, 0.2)]);
    /// ```
    pub fn transform(&self, now_from_then: &Pose, shape: &SurfaceShape) -> Self {
        let moved = |p: &Point2| {
            let then = Point3::from(shape.place(*p, 0.0).translation.vector);
            shape.chart(now_from_then * then).place
        };
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

/// Detection rate and noise of a camera for dirt.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SensorModel {
    /// Probability that a grain much larger than `half_size_m` is detected \[1\].
    pub detection: f64,
    /// Diameter at which this probability is halved \[m\].
    pub half_size_m: f64,
    /// Density of false alarms [1/m²].
    pub false_alarms_per_m2: f64,
    /// Standard deviation of a detection's position, along x and along y \[m\].
    pub position_error_m: f64,
}

/// Detection of a medium's dirt by a robot's camera.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sight {
    /// Detection rate and noise of the camera.
    pub sensor: SensorModel,
    /// Probability that a grain of this medium is detected where nothing hides it \[1\]; see
    /// [`SensorModel::mean_detection`].
    pub detection: f64,
}

/// Exponent of the detection rate about the half size.
const STEEPNESS: i32 = 4;
/// Number of diameters over which the mean over a range of sizes is taken.
const SIZES: usize = 16;

impl SensorModel {
    /// Returns the probability that an unoccluded grain of this diameter \[m\] is detected \[1\].
    pub fn detection_of(&self, diameter: f64) -> f64 {
        if self.half_size_m <= 0.0 {
            return self.detection;
        }
        self.detection / (1.0 + (self.half_size_m / diameter).powi(STEEPNESS))
    }

    /// Returns the mean detection probability over a medium's grain sizes \[1\]; `None` is a liquid, whose drops count as
    /// large.
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
    /// An assumption: a camera 0.5 m above the surface, with a grain of 0.5 mm on one pixel.
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
