//! Records of a session's events, one JSON object per line.

use super::warning::WarningRecord;
use serde::Serialize;
use std::io::{self, Write};
use wisch::run::RunEvent;

/// Schema number of the records of events.
pub const EVENT_SCHEMA: u32 = 2;

/// Number of samples per recorded one: at 1 kHz, 20 per second are recorded.
const EVERY: usize = 50;

/// An event of a session with its round.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "event", rename_all = "snake_case")]
pub enum RunEventRecord {
    /// A round is being planned.
    Planning {
        /// [`EVENT_SCHEMA`].
        schema: u32,
        /// Number of the round, from 1.
        round: usize,
    },
    /// A round is planned.
    Planned {
        /// Number of the round, from 1.
        round: usize,
        /// Strokes of its plan.
        strokes: usize,
        /// Path length in contact.
        distance_in_contact_m: f64,
    },
    /// The plan is being followed.
    Following {
        /// Number of the round, from 1.
        round: usize,
        /// Nodes passed.
        passed: usize,
        /// Total number of nodes.
        nodes: usize,
    },
    /// The motion was checked.
    Audited {
        /// Number of the round, from 1.
        round: usize,
        /// Descriptions of the faults; empty for a motion that may be executed.
        faults: Vec<String>,
    },
    /// An execution begins.
    Executing {
        /// Number of the round, from 1.
        round: usize,
        /// Expected duration.
        duration_s: f64,
        /// Predicted performance.
        predicted: f64,
    },
    /// Every fiftieth sample of the measurements.
    Sample {
        /// Time since the execution began.
        time_s: f64,
        /// Tool position in the world: x, y, z.
        tool_m: [f64; 3],
        /// Force of the surroundings on the tool, in the axes of the world.
        force_n: [f64; 3],
        /// Phase of the motion.
        phase: &'static str,
    },
    /// The running stroke differs from earlier episodes.
    Warned(WarningRecord),
    /// The log is being interpreted.
    Interpreting {
        /// Number of the round, from 1.
        round: usize,
    },
    /// The camera has observed the surface.
    Observed {
        /// Number of the round before the observation; 0 before the first round.
        round: usize,
        /// Number of detections.
        detections: usize,
        /// Hidden area of the surface.
        hidden_m2: f64,
    },
    /// A round is finished.
    Decided {
        /// Number of the round, from 1.
        round: usize,
        /// Estimated performance.
        estimated: f64,
        /// Lower end of its 90 % interval.
        estimated_low: f64,
        /// Upper end of its 90 % interval.
        estimated_high: f64,
        /// complete, stopped, ended early or protective stop.
        ending: &'static str,
        /// Verdict of the termination policy.
        verdict: &'static str,
    },
    /// The session has ended.
    Ended {
        /// Last verdict; null if a user stopped the session.
        verdict: Option<&'static str>,
    },
}

/// A writer of events as JSON lines, with every fiftieth sample.
#[derive(Debug)]
pub struct EventWriter<W> {
    output: W,
    samples: usize,
}

impl<W: Write> EventWriter<W> {
    /// Makes a writer of events to `output`, one JSON object per line.
    pub const fn new(output: W) -> Self {
        Self { output, samples: 0 }
    }

    /// Writes an event as one line.
    ///
    /// # Errors
    /// If the output cannot be written.
    pub fn write(&mut self, event: &RunEvent<'_>) -> io::Result<()> {
        let Some(record) = self.record(event) else {
            return Ok(());
        };
        let mut line = serde_json::to_vec(&record)?;
        line.push(b'\n');
        self.output.write_all(&line)?;
        self.output.flush()
    }

    /// Returns the record of an event; `None` for events without a record.
    pub fn record(&mut self, event: &RunEvent<'_>) -> Option<RunEventRecord> {
        Some(match *event {
            RunEvent::Planning { round } => RunEventRecord::Planning {
                schema: EVENT_SCHEMA,
                round,
            },
            RunEvent::Planned { round, plan } => RunEventRecord::Planned {
                round,
                strokes: plan.strokes.len(),
                distance_in_contact_m: plan.contact_distance(),
            },
            RunEvent::Following {
                round,
                passed,
                nodes,
            } => RunEventRecord::Following {
                round,
                passed,
                nodes,
            },
            RunEvent::Evaluated { .. } | RunEvent::Predicting { .. } => return None,
            RunEvent::Audited { round, audit } => RunEventRecord::Audited {
                round,
                faults: audit.faults.iter().map(ToString::to_string).collect(),
            },
            RunEvent::Executing(planned) => {
                self.samples = 0;
                RunEventRecord::Executing {
                    round: planned.number,
                    duration_s: planned.followed.duration(),
                    predicted: planned.prediction.performance.ratio(),
                }
            }
            RunEvent::Sample(sample) => {
                self.samples += 1;
                if !(self.samples - 1).is_multiple_of(EVERY) {
                    return None;
                }
                RunEventRecord::Sample {
                    time_s: sample.time,
                    tool_m: sample.world_from_tool.translation.vector.into(),
                    force_n: sample.external.force.into(),
                    phase: sample.phase.as_str(),
                }
            }
            RunEvent::Warned(warning) => RunEventRecord::Warned(WarningRecord::from(warning)),
            RunEvent::Interpreting { round } => RunEventRecord::Interpreting { round },
            RunEvent::Observed { round, observation } => RunEventRecord::Observed {
                round,
                detections: observation.detections.len(),
                // The area of nothing is -0.
                hidden_m2: observation.hidden.area() + 0.0,
            },
            RunEvent::Decided(round) => {
                let [low, high] = round.interpretation.range(round.motion.task.action);
                RunEventRecord::Decided {
                    round: round.motion.number,
                    estimated: round.interpretation.performance.mean,
                    estimated_low: low,
                    estimated_high: high,
                    ending: round.execution.ending.as_str(),
                    verdict: round.verdict.as_str(),
                }
            }
            RunEvent::Ended(verdict) => RunEventRecord::Ended {
                verdict: verdict.map(wisch::recover::Verdict::as_str),
            },
        })
    }
}
