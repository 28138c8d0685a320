//! What happens in a session, as records: one JSON object a line.

use serde::Serialize;
use std::io::{self, Write};
use wisch::run::RunEvent;

/// The schema of the records of events.
pub const EVENT_SCHEMA: u32 = 1;

/// Samples between two that are recorded: 20 a second of those at 1 kHz.
const EVERY: usize = 50;

/// What happened, with the round in which it did.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "event", rename_all = "snake_case")]
pub enum RunEventRecord {
    /// A round is being planned.
    Planning {
        /// [`EVENT_SCHEMA`].
        schema: u32,
        /// The round, from 1.
        round: usize,
    },
    /// A round is planned.
    Planned {
        /// The round, from 1.
        round: usize,
        /// Strokes of its plan.
        strokes: usize,
        /// Way in contact.
        distance_in_contact_m: f64,
    },
    /// The plan is being followed.
    Following {
        /// The round, from 1.
        round: usize,
        /// Nodes passed.
        passed: usize,
        /// Of so many.
        nodes: usize,
    },
    /// The motion was checked.
    Audited {
        /// The round, from 1.
        round: usize,
        /// Each fault in words; none of a motion that may be executed.
        faults: Vec<String>,
    },
    /// An execution begins.
    Executing {
        /// The round, from 1.
        round: usize,
        /// How long it will take.
        duration_s: f64,
        /// Performance that it is predicted to reach.
        predicted: f64,
    },
    /// What is measured, every fiftieth sample.
    Sample {
        /// Time since the execution began.
        time_s: f64,
        /// The tool in the world: x, y, z.
        tool_m: [f64; 3],
        /// Force of the surroundings on the tool, in the axes of the world.
        force_n: [f64; 3],
        /// What the motion is for.
        phase: &'static str,
    },
    /// The log is being interpreted.
    Interpreting {
        /// The round, from 1.
        round: usize,
    },
    /// The surface was looked at.
    Observed {
        /// After this round; 0 before the first.
        round: usize,
        /// How many detections there were.
        detections: usize,
        /// How much of the surface was hidden.
        hidden_m2: f64,
    },
    /// A round is over.
    Judged {
        /// The round, from 1.
        round: usize,
        /// Estimated performance.
        estimated: f64,
        /// Lower end of its 90 % interval.
        estimated_low: f64,
        /// Upper end of its 90 % interval.
        estimated_high: f64,
        /// complete, stopped, ended early or protective stop.
        ending: &'static str,
        /// What follows.
        verdict: &'static str,
    },
    /// The session is over.
    Ended {
        /// Why; null if it was stopped from outside.
        verdict: Option<&'static str>,
    },
}

/// Writes events as JSON lines, of samples only every fiftieth.
#[derive(Debug)]
pub struct EventWriter<W> {
    output: W,
    samples: usize,
}

impl<W: Write> EventWriter<W> {
    /// Writes to this.
    pub const fn new(output: W) -> Self {
        Self { output, samples: 0 }
    }

    /// Writes what there is to say of an event.
    ///
    /// # Errors
    /// What the system says.
    pub fn write(&mut self, event: &RunEvent<'_>) -> io::Result<()> {
        let Some(record) = self.record(event) else {
            return Ok(());
        };
        let mut line = serde_json::to_vec(&record)?;
        line.push(b'\n');
        self.output.write_all(&line)?;
        self.output.flush()
    }

    /// The record of an event; `None` of one that is passed over.
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
            RunEvent::Considered { .. } | RunEvent::Predicting { .. } => return None,
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
            RunEvent::Interpreting { round } => RunEventRecord::Interpreting { round },
            RunEvent::Observed { round, observation } => RunEventRecord::Observed {
                round,
                detections: observation.detections.len(),
                hidden_m2: observation.hidden.area(),
            },
            RunEvent::Judged(round) => {
                let estimate = &round.interpretation.performance;
                RunEventRecord::Judged {
                    round: round.motion.number,
                    estimated: estimate.mean,
                    estimated_low: estimate.low,
                    estimated_high: estimate.high,
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
