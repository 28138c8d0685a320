//! Camera observations of the dirt before and after a round, as a file of the episode.

use crate::frames::StoredPose;
use nalgebra::{Quaternion, UnitQuaternion};
use serde::{Deserialize, Serialize};
use wisch::geometry::{Point2, Polygon, Pose, Region};
use wisch::represent::Observation;

/// Version of the schema of a round's observations.
pub const OBSERVATIONS_SCHEMA: u32 = 1;

/// Largest deviation of a stored quaternion's norm from 1 [1].
const UNIT_TOLERANCE: f64 = 1e-6;

/// Camera observations of the dirt before and after a round.
#[derive(Debug, Clone, PartialEq)]
pub struct RoundObservations {
    /// Number of the round in its run, from 1, if known. An imported log is the first round of its episode, but may be
    /// any round of its run.
    pub round: Option<usize>,
    /// Believed pose of the surface in this round: the frame of both observations.
    pub world_from_surface: Pose,
    /// Observations before the first sample and after the last; `None` where the camera was not used.
    pub observations: [Option<Observation>; 2],
}

/// A fault of the stored observations of a round.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ObservationFault {
    /// The file is not JSON of this form.
    #[error("{0}")]
    Json(String),
    /// The schema is not supported.
    #[error("schema: {found} is not supported; this program reads {OBSERVATIONS_SCHEMA}")]
    Schema {
        /// The file's schema.
        found: u32,
    },
    /// A quaternion is not a rotation.
    #[error(
        "world_from_surface.quaternion: its length is {length}, further than {UNIT_TOLERANCE} from 1"
    )]
    Quaternion {
        /// Its norm \[1\].
        length: f64,
    },
    /// A number is not finite.
    #[error("{place}: {value} is not finite")]
    Number {
        /// Path of the number.
        place: &'static str,
        /// The number.
        value: f64,
    },
}

/// Schema of the file.
#[derive(Debug, Serialize, Deserialize)]
struct ObservationsRecord {
    schema: u32,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    round: Option<usize>,
    world_from_surface: StoredPose,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    before: Option<ObservationRecord>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    after: Option<ObservationRecord>,
}

/// An observation, in the frame of the surface.
#[derive(Debug, Serialize, Deserialize)]
struct ObservationRecord {
    detections_m: Vec<[f64; 2]>,
    /// For each polygon, its outer ring and then its holes.
    hidden_m: Vec<Vec<Vec<[f64; 2]>>>,
}

impl RoundObservations {
    /// Whether there is an observation, before or after the round.
    pub fn is_any(&self) -> bool {
        self.observations.iter().any(Option::is_some)
    }

    /// Checks that the observations can be stored.
    ///
    /// # Errors
    /// The first fault: a number that is not finite, or a quaternion whose norm is not 1.
    pub fn check(&self) -> Result<(), ObservationFault> {
        let pose = &self.world_from_surface;
        let parts = pose.translation.vector.iter();
        check_finite("world_from_surface", parts.copied())?;
        let length = pose.rotation.coords.norm();
        let off = (length - 1.0).abs();
        if off.is_nan() || off > UNIT_TOLERANCE {
            return Err(ObservationFault::Quaternion { length });
        }
        for seen in self.observations.iter().flatten() {
            check_finite("detections_m", numbers(&seen.detections))?;
            for part in seen.hidden.polygons() {
                check_finite("hidden_m", part.rings().flat_map(numbers))?;
            }
        }
        Ok(())
    }

    /// Returns the contents of the file.
    pub(crate) fn to_json(&self) -> Result<String, ObservationFault> {
        self.check()?;
        let [before, after] = self.observations.each_ref().map(|seen| {
            let seen = seen.as_ref();
            seen.map(ObservationRecord::from)
        });
        let record = ObservationsRecord {
            schema: OBSERVATIONS_SCHEMA,
            round: self.round,
            world_from_surface: (&self.world_from_surface).into(),
            before,
            after,
        };
        serde_json::to_string(&record).map_err(|error| ObservationFault::Json(error.to_string()))
    }

    /// Parses the contents of a file.
    pub(crate) fn from_json(bytes: &[u8]) -> Result<Self, ObservationFault> {
        let record: ObservationsRecord = serde_json::from_slice(bytes)
            .map_err(|error| ObservationFault::Json(error.to_string()))?;
        if record.schema != OBSERVATIONS_SCHEMA {
            return Err(ObservationFault::Schema {
                found: record.schema,
            });
        }
        let observations = Self {
            round: record.round,
            world_from_surface: pose(
                record.world_from_surface.position,
                record.world_from_surface.quaternion,
            ),
            observations: [record.before, record.after].map(|seen| seen.map(Observation::from)),
        };
        observations.check()?;
        Ok(observations)
    }
}

/// Returns a pose, bit for bit: its quaternion has unit norm and is not normalised again.
pub(crate) fn pose(position: [f64; 3], quaternion: [f64; 4]) -> Pose {
    let rotation = UnitQuaternion::new_unchecked(Quaternion::from(quaternion));
    Pose::from_parts(position.into(), rotation)
}

fn check_finite(
    place: &'static str,
    mut numbers: impl Iterator<Item = f64>,
) -> Result<(), ObservationFault> {
    match numbers.find(|number| !number.is_finite()) {
        Some(value) => Err(ObservationFault::Number { place, value }),
        None => Ok(()),
    }
}

fn numbers(places: &[Point2]) -> impl Iterator<Item = f64> + '_ {
    places.iter().flat_map(|place| [place.x, place.y])
}

fn pairs(places: &[Point2]) -> Vec<[f64; 2]> {
    places.iter().map(|place| [place.x, place.y]).collect()
}

impl From<&Observation> for ObservationRecord {
    fn from(seen: &Observation) -> Self {
        let hidden = seen.hidden.polygons().iter();
        Self {
            detections_m: pairs(&seen.detections),
            hidden_m: hidden
                .map(|part| part.rings().map(pairs).collect())
                .collect(),
        }
    }
}

impl From<ObservationRecord> for Observation {
    fn from(record: ObservationRecord) -> Self {
        let places = |pairs: Vec<[f64; 2]>| pairs.into_iter().map(Point2::from).collect();
        let hidden = record.hidden_m.into_iter().map(|rings| {
            let mut rings = rings.into_iter().map(places);
            let outer = rings.next().unwrap_or_default();
            Polygon::new(outer, rings.collect())
        });
        Self {
            hidden: Region::new(hidden.collect()),
            detections: places(record.detections_m),
        }
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    /// Two observations of a tilted surface.
    pub(crate) fn example_observations() -> RoundObservations {
        let ring = |size: f64| {
            let corners = [[-size, -size], [size, -size], [size, size], [-size, size]];
            corners.map(Point2::from).to_vec()
        };
        let world_from_surface = pose([0.6, 0.1 + 0.2, 0.75], [0.0, 0.6, 0.0, 0.8]);
        RoundObservations {
            round: Some(2),
            world_from_surface,
            observations: [
                Some(Observation {
                    detections: vec![Point2::new(1.0 / 3.0, -0.1), Point2::new(1e-300, 0.0)],
                    hidden: Region::new(vec![
                        Polygon::new(ring(0.1), vec![ring(0.05)]),
                        Polygon::new(ring(0.02), vec![]),
                    ]),
                }),
                Some(Observation::default()),
            ],
        }
    }

    #[test]
    fn observations_are_read_back_bit_for_bit() {
        let mut only_after = example_observations();
        only_after.round = None;
        only_after.observations[0] = None;
        for written in [example_observations(), only_after] {
            let text = written.to_json().unwrap();
            assert_eq!(RoundObservations::from_json(text.as_bytes()), Ok(written));
        }
    }

    #[test]
    fn invalid_observations_are_refused() {
        let refused = |observations: &RoundObservations| observations.to_json().unwrap_err();
        let mut infinite = example_observations();
        let [Some(before), _] = &mut infinite.observations else {
            panic!("an observation");
        };
        before.detections[1].y = f64::INFINITY;
        assert_eq!(
            refused(&infinite).to_string(),
            "detections_m: inf is not finite"
        );
        let text = example_observations().to_json().unwrap();
        for (part, other, message) in [
            ("\"schema\":1", "\"schema\":9", "schema: 9 is not supported"),
            ("[0.0,0.6,", "[3.0,0.6,", "further than 0.000001 from 1"),
            ("detections_m", "detections", "missing field `detections_m`"),
        ] {
            let changed = text.replacen(part, other, 1);
            let error = RoundObservations::from_json(changed.as_bytes()).unwrap_err();
            assert!(error.to_string().contains(message), "{error}");
        }
        let mut stretched = example_observations();
        stretched.world_from_surface = pose([0.0; 3], [0.0, 0.0, 0.0, 1.5]);
        assert_eq!(
            refused(&stretched),
            ObservationFault::Quaternion { length: 1.5 }
        );
    }
}
