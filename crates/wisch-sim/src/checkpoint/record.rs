//! Record of an executed round, from which a killed run resumes.

use crate::{Dirt, Grain, GroundTruth, Spread};
use serde::{Deserialize, Serialize};
use wisch::geometry::{Point2, Polygon, Region};
use wisch::represent::{Fate, Observation};
use wisch::robot::{JointKind, Range};
use wisch::run::{Ending, Execution, StopCause, StopKind, StrokeEnd, WarningChannel};

/// Version of the schema of checkpoint records.
pub const CHECKPOINT_SCHEMA: u32 = 6;

/// The record of an executed round in a checkpoint.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CheckpointRecord {
    /// [`CHECKPOINT_SCHEMA`].
    pub schema: u32,
    /// Hash of all inputs of the run.
    pub identity: u64,
    /// Times of the samples, to the last bit; empty in schema 5 [s].
    #[serde(default)]
    pub times_s: Vec<f64>,
    /// In schema 5: number of positions, velocities and efforts in each sample.
    #[serde(default, skip_serializing)]
    pub counts: [usize; 3],
    /// Wall-clock time that the simulation took [s].
    pub executing_s: f64,
    duration_s: f64,
    ending: EndingRecord,
    positions: Vec<f64>,
    grains: Vec<GrainRecord>,
    contact_force: SpreadRecord,
    max_plane_distance_m: f64,
    max_controller_force_n: f64,
    lost_share: f64,
    max_lateral_error_m: f64,
    #[serde(default)]
    pushes_s: Vec<[f64; 2]>,
    #[serde(default)]
    obstructions_s: Vec<[f64; 2]>,
    hidden_m: Vec<Vec<[f64; 2]>>,
    /// Observations before the first round, and after this round.
    looks: [Option<ObservationRecord>; 2],
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct ObservationRecord {
    detections_m: Vec<[f64; 2]>,
    hidden_m: Vec<Vec<[f64; 2]>>,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum EndingRecord {
    Complete,
    Stopped,
    Early {
        time_s: f64,
        why: EarlyRecord,
        metres: f64,
    },
    ProtectiveStop {
        time_s: f64,
        cause: CauseRecord,
    },
}

#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum EarlyRecord {
    ContactLost,
    LedAway,
    /// A warning of a channel; `metres` is 0.
    ForceWarning,
    HeightWarning,
    ContactShareWarning,
    TrackingErrorWarning,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum CauseRecord {
    Astray {
        distance_m: f64,
        limit_m: f64,
    },
    Overspeed {
        joint: String,
        velocity: f64,
        limit: f64,
        #[serde(default)]
        slides: bool,
    },
    Overshoot {
        joint: String,
        position: f64,
        lower: f64,
        upper: f64,
        #[serde(default)]
        slides: bool,
    },
    Reported {
        #[serde(default)]
        kind: String,
        reason: String,
    },
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct GrainRecord {
    position_m: [f64; 2],
    fate: FateRecord,
    radius_m: f64,
    threshold: f64,
    #[serde(default)]
    wear_m: f64,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum FateRecord {
    OnSurface,
    Absorbed,
    OffSurface(u16),
    Treated(f64),
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct SpreadRecord {
    count: usize,
    mean: f64,
    squares: f64,
}

impl CheckpointRecord {
    /// The record of a round.
    pub fn new(
        execution: &Execution,
        truth: &GroundTruth,
        looks: [Option<&Observation>; 2],
        identity: u64,
        times_s: Vec<f64>,
        executing_s: f64,
    ) -> Self {
        let force = &truth.contact_force;
        Self {
            schema: CHECKPOINT_SCHEMA,
            identity,
            times_s,
            counts: [0; 3],
            executing_s,
            duration_s: execution.duration,
            ending: EndingRecord::from(&execution.ending),
            positions: execution.positions.clone(),
            grains: truth.dirt.grains().iter().map(GrainRecord::from).collect(),
            contact_force: SpreadRecord {
                count: force.count(),
                mean: force.mean(),
                squares: force.squares(),
            },
            max_plane_distance_m: truth.max_plane_distance,
            max_controller_force_n: truth.max_controller_force,
            lost_share: truth.lost_share,
            max_lateral_error_m: truth.max_lateral_error,
            pushes_s: truth.pushes.clone(),
            obstructions_s: truth.obstructions.clone(),
            hidden_m: (truth.hidden.iter())
                .map(|hull| hull.iter().map(|p| [p.x, p.y]).collect())
                .collect(),
            looks: looks.map(|look| look.map(ObservationRecord::from)),
        }
    }

    /// Observations before the first round, and after this round.
    pub fn observations(&self) -> [Option<Observation>; 2] {
        let look = |record: &ObservationRecord| Observation::from(record);
        self.looks
            .each_ref()
            .map(|record| record.as_ref().map(look))
    }

    /// Returns outcome and ground truth, bit for bit.
    pub fn into_execution(self) -> (Execution, GroundTruth) {
        let force = &self.contact_force;
        let execution = Execution {
            duration: self.duration_s,
            ending: self.ending.into(),
            positions: self.positions,
            pauses: Vec::new(),
            dropped_samples: 0,
        };
        let truth = GroundTruth {
            dirt: Dirt::from_grains(self.grains.into_iter().map(Grain::from).collect()),
            contact_force: Spread::from_moments(force.count, force.mean, force.squares),
            max_plane_distance: self.max_plane_distance_m,
            max_controller_force: self.max_controller_force_n,
            lost_share: self.lost_share,
            max_lateral_error: self.max_lateral_error_m,
            pushes: self.pushes_s,
            obstructions: self.obstructions_s,
            hidden: (self.hidden_m.into_iter())
                .map(|hull| hull.into_iter().map(Point2::from).collect())
                .collect(),
        };
        (execution, truth)
    }
}

impl From<&Observation> for ObservationRecord {
    fn from(observation: &Observation) -> Self {
        let places = |points: &[Point2]| points.iter().map(|p| [p.x, p.y]).collect();
        let hidden = observation.hidden.polygons().iter();
        Self {
            detections_m: places(&observation.detections),
            hidden_m: hidden.map(|polygon| places(polygon.outer())).collect(),
        }
    }
}

impl From<&ObservationRecord> for Observation {
    fn from(record: &ObservationRecord) -> Self {
        let points = |places: &[[f64; 2]]| places.iter().copied().map(Point2::from).collect();
        let hidden = record.hidden_m.iter();
        let hidden = hidden.map(|ring| Polygon::new(points(ring), vec![]));
        Self {
            detections: points(&record.detections_m),
            hidden: Region::new(hidden.collect()),
        }
    }
}

impl From<&Grain> for GrainRecord {
    fn from(grain: &Grain) -> Self {
        Self {
            position_m: [grain.position.x, grain.position.y],
            fate: match grain.fate {
                Fate::OnSurface => FateRecord::OnSurface,
                Fate::Absorbed => FateRecord::Absorbed,
                Fate::OffSurface { edge } => FateRecord::OffSurface(edge),
                Fate::Treated { passes } => FateRecord::Treated(passes),
            },
            radius_m: grain.radius,
            threshold: grain.threshold,
            wear_m: grain.wear,
        }
    }
}

impl From<GrainRecord> for Grain {
    fn from(record: GrainRecord) -> Self {
        let [x, y] = record.position_m;
        Self {
            position: Point2::new(x, y),
            fate: match record.fate {
                FateRecord::OnSurface => Fate::OnSurface,
                FateRecord::Absorbed => Fate::Absorbed,
                FateRecord::OffSurface(edge) => Fate::OffSurface { edge },
                FateRecord::Treated(passes) => Fate::Treated { passes },
            },
            radius: record.radius_m,
            threshold: record.threshold,
            wear: record.wear_m,
        }
    }
}

impl From<&Ending> for EndingRecord {
    fn from(ending: &Ending) -> Self {
        let (time, cause) = match ending {
            Ending::Complete => return Self::Complete,
            Ending::Stopped => return Self::Stopped,
            Ending::Early { time, cause } => {
                let (why, metres) = match *cause {
                    StrokeEnd::ContactLost { way } => (EarlyRecord::ContactLost, way),
                    StrokeEnd::LedAway { distance } => (EarlyRecord::LedAway, distance),
                    StrokeEnd::Warned { channel } => (EarlyRecord::from(channel), 0.0),
                };
                return Self::Early {
                    time_s: *time,
                    why,
                    metres,
                };
            }
            Ending::ProtectiveStop { time, cause } => (time, cause.clone()),
        };
        Self::ProtectiveStop {
            time_s: *time,
            cause: match cause {
                StopCause::Astray { distance, limit } => CauseRecord::Astray {
                    distance_m: distance,
                    limit_m: limit,
                },
                StopCause::Overspeed {
                    joint,
                    velocity,
                    limit,
                    kind,
                } => CauseRecord::Overspeed {
                    joint,
                    velocity,
                    limit,
                    slides: kind == JointKind::Prismatic,
                },
                StopCause::Overshoot {
                    joint,
                    position,
                    limits,
                    kind,
                } => CauseRecord::Overshoot {
                    joint,
                    position,
                    lower: limits.lower,
                    upper: limits.upper,
                    slides: kind == JointKind::Prismatic,
                },
                StopCause::Reported { kind, reason } => CauseRecord::Reported {
                    kind: kind.as_str().to_owned(),
                    reason,
                },
            },
        }
    }
}

impl From<WarningChannel> for EarlyRecord {
    fn from(channel: WarningChannel) -> Self {
        match channel {
            WarningChannel::Force => Self::ForceWarning,
            WarningChannel::Height => Self::HeightWarning,
            WarningChannel::ContactShare => Self::ContactShareWarning,
            WarningChannel::TrackingError => Self::TrackingErrorWarning,
        }
    }
}

impl From<EndingRecord> for Ending {
    fn from(record: EndingRecord) -> Self {
        let warned = |channel| StrokeEnd::Warned { channel };
        let (time, cause) = match record {
            EndingRecord::Complete => return Self::Complete,
            EndingRecord::Stopped => return Self::Stopped,
            EndingRecord::Early {
                time_s: time,
                why,
                metres,
            } => {
                let cause = match why {
                    EarlyRecord::ContactLost => StrokeEnd::ContactLost { way: metres },
                    EarlyRecord::LedAway => StrokeEnd::LedAway { distance: metres },
                    EarlyRecord::ForceWarning => warned(WarningChannel::Force),
                    EarlyRecord::HeightWarning => warned(WarningChannel::Height),
                    EarlyRecord::ContactShareWarning => warned(WarningChannel::ContactShare),
                    EarlyRecord::TrackingErrorWarning => warned(WarningChannel::TrackingError),
                };
                return Self::Early { time, cause };
            }
            EndingRecord::ProtectiveStop { time_s, cause } => (time_s, cause),
        };
        Self::ProtectiveStop {
            time,
            cause: match cause {
                CauseRecord::Astray {
                    distance_m,
                    limit_m,
                } => StopCause::Astray {
                    distance: distance_m,
                    limit: limit_m,
                },
                CauseRecord::Overspeed {
                    joint,
                    velocity,
                    limit,
                    slides,
                } => StopCause::Overspeed {
                    joint,
                    velocity,
                    limit,
                    kind: joint_kind(slides),
                },
                CauseRecord::Overshoot {
                    joint,
                    position,
                    lower,
                    upper,
                    slides,
                } => StopCause::Overshoot {
                    joint,
                    position,
                    limits: Range { lower, upper },
                    kind: joint_kind(slides),
                },
                CauseRecord::Reported { kind, reason } => {
                    let known = StopKind::ALL
                        .into_iter()
                        .find(|known| known.as_str() == kind);
                    // Checkpoints of earlier versions do not hold the kind.
                    let kind = known.unwrap_or(StopKind::ProtectiveStop);
                    StopCause::Reported { kind, reason }
                }
            },
        }
    }
}

/// Returns the kind of a joint that moves.
const fn joint_kind(slides: bool) -> JointKind {
    match slides {
        true => JointKind::Prismatic,
        false => JointKind::Revolute,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use wisch::geometry::Vector2;

    #[test]
    fn what_was_executed_comes_back_to_the_last_bit() {
        let grain = |fate| Grain {
            position: Point2::new(0.1 + 0.2, -1.0 / 3.0),
            fate,
            radius: 1e-3 / 3.0,
            threshold: 0.7_f64.exp(),
            wear: 1e-7 / 3.0,
        };
        let causes = [
            StopCause::Astray {
                distance: 0.6,
                limit: 0.5,
            },
            StopCause::Overspeed {
                joint: "elbow".to_owned(),
                velocity: 4.5,
                limit: 4.0,
                kind: JointKind::Prismatic,
            },
            StopCause::Overshoot {
                joint: "elbow".to_owned(),
                position: 3.0,
                limits: Range {
                    lower: -2.0,
                    upper: 2.0,
                },
                kind: JointKind::Revolute,
            },
        ];
        let reported = StopKind::ALL.map(|kind| StopCause::Reported {
            kind,
            reason: "a hand".to_owned(),
        });
        let causes = causes.into_iter().chain(reported);
        let stops = causes.map(|cause| Ending::ProtectiveStop { time: 0.1, cause });
        let early = [
            StrokeEnd::ContactLost { way: 0.1 },
            StrokeEnd::LedAway {
                distance: 1.0 / 3.0,
            },
        ];
        let warned = WarningChannel::ALL.map(|channel| StrokeEnd::Warned { channel });
        let early = early
            .into_iter()
            .chain(warned)
            .map(|cause| Ending::Early { time: 0.1, cause });
        let stops = early.chain(stops);
        for ending in [Ending::Complete, Ending::Stopped].into_iter().chain(stops) {
            let execution = Execution {
                duration: 12.345,
                ending,
                positions: vec![std::f64::consts::PI, -0.0, 1e-300],
                pauses: Vec::new(),
                dropped_samples: 0,
            };
            let truth = GroundTruth {
                dirt: Dirt::from_grains(vec![
                    grain(Fate::OnSurface),
                    grain(Fate::Absorbed),
                    grain(Fate::OffSurface { edge: 3 }),
                    grain(Fate::Treated { passes: 2.0 / 3.0 }),
                ]),
                contact_force: Spread::from_moments(7, 9.9, 1.0 / 7.0),
                max_plane_distance: 0.001,
                max_controller_force: 10.0,
                lost_share: 0.1,
                max_lateral_error: 0.002,
                pushes: vec![[0.5, 1.0 / 3.0 + 1.0]],
                obstructions: vec![[0.7, 0.75]],
                hidden: vec![vec![Point2::new(0.1, 1.0 / 7.0), Point2::origin()]],
            };
            let seen = Observation {
                detections: vec![Point2::new(0.1, -0.2)],
                hidden: Region::new(vec![Polygon::rectangle(Vector2::new(0.1, 0.2))]),
            };
            let looks = [None, Some(&seen)];
            let times = vec![0.0, 0.001, 0.1 + 0.2];
            let record = CheckpointRecord::new(&execution, &truth, looks, u64::MAX, times, 1.5);
            let text = serde_json::to_string(&record).expect("text");
            let read: CheckpointRecord = serde_json::from_str(&text).expect("a record");
            assert_eq!(read, record);
            assert_eq!(read.observations(), [None, Some(seen)]);
            assert_eq!(read.into_execution(), (execution, truth));
        }
    }
}
