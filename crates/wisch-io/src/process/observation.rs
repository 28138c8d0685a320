//! Checks the observations of executors in other processes or languages.

use serde::Deserialize;
use wisch::geometry::{Point2, Polygon, Region};
use wisch::represent::{MAX_DETECTIONS, Observation};

/// Maximum coordinate of a detection, in the surface frame [m].
const MAX_SEEN: f64 = 1e3;
/// Maximum number of corners of all hidden polygons.
const MAX_HIDDEN_CORNERS: usize = 1_000;

/// An observation of the dirt, in the frame of the believed surface \[m\].
#[derive(Debug, Clone, PartialEq, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ObservationRecord {
    /// Detected dirt locations.
    pub detections: Vec<[f64; 2]>,
    /// Polygons that are hidden from the camera.
    #[serde(default)]
    pub hidden: Vec<Vec<[f64; 2]>>,
}

impl ObservationRecord {
    /// Checks the record and returns its observation.
    ///
    /// # Errors
    /// If a number is not finite or beyond the limit of coordinates, if there are more than [`MAX_DETECTIONS`] detections,
    /// if a polygon has fewer than three corners, or if all polygons together have too many corners.
    pub fn into_observation(self) -> Result<Observation, String> {
        let counts = [
            ("detections", self.detections.len(), MAX_DETECTIONS),
            (
                "corners of hidden polygons",
                self.hidden.iter().map(Vec::len).sum(),
                MAX_HIDDEN_CORNERS,
            ),
        ];
        for (what, count, most) in counts {
            if count > most {
                return Err(format!(
                    "observation: {count} {what} exceed the limit of {most}"
                ));
            }
        }
        let places = self.hidden.iter().flatten().chain(&self.detections);
        for [x, y] in places {
            if !(x.is_finite() && y.is_finite()) {
                return Err(format!("observation: position ({x}, {y}) m is not finite"));
            }
            if x.abs().max(y.abs()) > MAX_SEEN {
                return Err(format!(
                    "observation: position ({x:e}, {y:e}) m is more than {MAX_SEEN} m from the surface's origin"
                ));
            }
        }
        if let Some((i, ring)) = (self.hidden.iter().enumerate()).find(|(_, ring)| ring.len() < 3) {
            let corners = ring.len();
            return Err(format!(
                "observation: hidden[{i}] has {corners} corners; expected 3 or more"
            ));
        }
        let points = |ring: Vec<[f64; 2]>| ring.into_iter().map(Point2::from).collect();
        let hidden = self
            .hidden
            .into_iter()
            .map(|ring| Polygon::new(points(ring), vec![]));
        Ok(Observation {
            hidden: Region::new(hidden.collect()),
            detections: points(self.detections),
        })
    }
}
