//! A run as it is shown: a sequence of pieces, one JSON object a line, in the order in which things happen.
//!
//! The same lines are a run while it goes on, an episode that is kept and the data of a report in one file. What each piece
//! holds, `crates/wisch-web/web/src/recording.ts` says.

mod considered;
mod head;
mod judged;
mod particles;
mod robot;
mod round;
mod samples;
mod story;
#[cfg(test)]
mod tests;
mod words;

pub use story::RunOutcome;

use crate::prediction::frames::EffectFrames;
use crate::scene::Meshes;
use considered::ConsideredRecord;
use head::Head;
use judged::{Judged, Truth};
use round::RoundPiece;
use samples::Batch;
use serde::Serialize;
use std::io::{self, Write};
use story::Ended;
use wisch::follow::{Audit, Workcell};
use wisch::geometry::Pose;
use wisch::plan::{Plan, Prediction, Strategy};
use wisch::represent::{ParticleDistribution, Task};
use wisch::robot::Appearance;
use wisch::run::{PlannedRound, RunEvent};

/// The version of what a recording is made of.
pub const RECORDING_SCHEMA: u32 = 1;

/// What a recording begins with.
#[derive(Debug, Clone, Copy)]
pub struct RecordingHead<'a> {
    /// Headline.
    pub title: &'a str,
    /// What writes it, such as "wisch 0.1.0".
    pub program: &'a str,
    /// What is to be done.
    pub task: &'a Task,
    /// How nodes are placed.
    pub strategy: Strategy,
    /// The performance that is wanted, in [0, 1].
    pub target: f64,
    /// Who is to do it; `None` for nobody.
    pub cell: Option<&'a Workcell>,
    /// What the robot looks like; `None` shows its collision geometry.
    pub appearance: Option<&'a Appearance>,
}

/// What nobody executed.
#[derive(Debug, Clone, Copy)]
pub struct PlannedOnly<'a> {
    /// The task as it was believed.
    pub task: &'a Task,
    /// The plan as it is wiped.
    pub plan: &'a Plan,
    /// What is to be expected of it.
    pub prediction: &'a Prediction,
    /// The effect over time.
    pub frames: &'a EffectFrames,
    /// The motion that follows it and its check; `None` without a robot.
    pub followed: Option<(&'a Workcell, &'a wisch::follow::Followed, &'a Audit)>,
}

/// What the simulated world knows of a round.
#[derive(Debug, Clone, Copy)]
pub struct RoundTruth<'a> {
    /// The round, from 1.
    pub round: usize,
    /// The performance, in [0, 1]; `None` where no dirt was simulated.
    pub performance: Option<f64>,
    /// Where the dirt lies, in the frame of the real surface [m].
    pub particles: Option<&'a ParticleDistribution>,
    /// When somebody pushed: from, to [s].
    pub pushes: &'a [[f64; 2]],
    /// Where the surface really is, in the world.
    pub world_from_surface: Option<Pose>,
}

/// Writes a run as it goes on.
///
/// ```
/// use wisch_report::{RecordingHead, RecordingWriter};
/// # let task = wisch_testkit::board(wisch::represent::Action::Absorb, [0.0, 0.0, 0.0]);
/// let mut recording = RecordingWriter::new(Vec::new());
/// recording.begin(&RecordingHead {
///     title: "a board",
///     program: "example 1",
///     task: &task,
///     strategy: wisch::plan::Strategy::Adaptive,
///     target: 0.9,
///     cell: None,
///     appearance: None,
/// })?;
/// let text = String::from_utf8(recording.into_inner())?;
/// assert!(text.starts_with("{\"piece\":\"head\",\"schema\":1,"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct RecordingWriter<W> {
    output: W,
    meshes: Meshes,
    /// How many of them are written.
    written: usize,
    /// What the round is predicted to do, before it is executed.
    frames: Option<EffectFrames>,
    /// Among which plans its plan was chosen.
    considered: Vec<ConsideredRecord>,
    /// What the check of its motion says.
    audited: Option<String>,
    batch: Batch,
    target: f64,
}

impl<W: Write> RecordingWriter<W> {
    /// Writes to this.
    pub fn new(output: W) -> Self {
        Self {
            output,
            meshes: Meshes::new(robot::MAX_TRIANGLES),
            written: 0,
            frames: None,
            considered: Vec::new(),
            audited: None,
            batch: Batch::default(),
            target: 0.0,
        }
    }

    /// What was written to.
    pub fn into_inner(self) -> W {
        self.output
    }

    /// The same, while it is written to.
    pub const fn get_mut(&mut self) -> &mut W {
        &mut self.output
    }

    /// Begins with who is to do what.
    ///
    /// # Errors
    /// What the system says.
    pub fn begin(&mut self, head: &RecordingHead<'_>) -> io::Result<()> {
        self.target = head.target;
        let piece = Head::new(head, &mut self.meshes);
        self.written = self.meshes.len();
        write(&mut self.output, &piece)
    }

    /// Takes note of what happens.
    ///
    /// # Errors
    /// What the system says.
    pub fn see(&mut self, event: &RunEvent<'_>) -> io::Result<()> {
        match *event {
            RunEvent::Planning { round } => {
                self.frames = None;
                self.considered.clear();
                self.stage(round, "planning", "planning".to_owned())
            }
            RunEvent::Considered { considered, .. } => {
                self.considered = considered.iter().map(ConsideredRecord::new).collect();
                Ok(())
            }
            RunEvent::Planned { round, plan } => self.stage(round, "planned", words::planned(plan)),
            RunEvent::Following {
                round,
                passed,
                nodes,
            } if passed == nodes => {
                self.stage(round, "following", format!("followed: {passed} nodes"))
            }
            RunEvent::Following { .. } => Ok(()),
            RunEvent::Predicting {
                task,
                wiped,
                progress,
                ..
            } => {
                let begin = || EffectFrames::new(task, wiped);
                self.frames.get_or_insert_with(begin).watch(&progress);
                Ok(())
            }
            RunEvent::Audited { round, audit } => {
                let found = words::audited(audit);
                self.audited = Some(found.clone());
                self.stage(round, "audited", found)
            }
            RunEvent::Executing(planned) => self.executing(planned),
            RunEvent::Sample(sample) => {
                let due = self.batch.watch(sample);
                if due { self.flush_batch() } else { Ok(()) }
            }
            RunEvent::Interpreting { round } => {
                self.flush_batch()?;
                self.stage(
                    round,
                    "interpreting",
                    "interpreting what was felt".to_owned(),
                )
            }
            RunEvent::Observed { round, observation } => {
                let piece = Observed {
                    piece: "observed",
                    round,
                    detections: particles::flat_places(observation.detections.iter().copied()),
                    hidden_m2: samples::rounded(observation.hidden.area(), 1e4),
                };
                write(&mut self.output, &piece)
            }
            RunEvent::Judged(round) => {
                self.flush_batch()?;
                write(&mut self.output, &Judged::new(round, self.target))
            }
            RunEvent::Ended(_) => Ok(()),
        }
    }

    /// Takes note of a plan that nobody executes.
    ///
    /// # Errors
    /// What the system says.
    pub fn planned_only(&mut self, planned: &PlannedOnly<'_>) -> io::Result<()> {
        let audited = planned.followed.map(|(_, _, audit)| words::audited(audit));
        let piece = RoundPiece::planned(planned, audited, &mut self.meshes, self.written)
            .chosen_among(std::mem::take(&mut self.considered), planned.plan.strategy);
        self.written = self.meshes.len();
        write(&mut self.output, &piece)?;
        for batch in samples::planned(planned) {
            write(&mut self.output, &batch)?;
        }
        Ok(())
    }

    /// Takes note of what the world knows.
    ///
    /// # Errors
    /// What the system says.
    pub fn truth(&mut self, truth: &RoundTruth<'_>) -> io::Result<()> {
        write(&mut self.output, &Truth::new(truth))
    }

    /// Ends; `episode` is the name under which it is kept.
    ///
    /// # Errors
    /// What the system says.
    pub fn end(&mut self, outcome: &RunOutcome<'_>, episode: Option<&str>) -> io::Result<()> {
        write(&mut self.output, &Ended::new(outcome, episode))
    }

    fn executing(&mut self, planned: &PlannedRound) -> io::Result<()> {
        let frames = self.frames.take();
        let audited = self.audited.take();
        let piece = RoundPiece::executed(
            planned,
            frames.as_ref(),
            audited,
            &mut self.meshes,
            self.written,
        )
        .chosen_among(std::mem::take(&mut self.considered), planned.plan.strategy);
        self.written = self.meshes.len();
        self.batch = Batch::of(planned);
        write(&mut self.output, &piece)?;
        self.stage(
            planned.number,
            "executing",
            format!("wiping for {:.1} s", planned.followed.duration()),
        )
    }

    fn flush_batch(&mut self) -> io::Result<()> {
        match self.batch.take() {
            Some(piece) => write(&mut self.output, &piece),
            None => Ok(()),
        }
    }

    fn stage(&mut self, round: usize, stage: &'static str, words: String) -> io::Result<()> {
        let piece = StagePiece {
            piece: "stage",
            round,
            stage,
            words,
        };
        write(&mut self.output, &piece)
    }
}

#[derive(Serialize)]
struct StagePiece {
    piece: &'static str,
    round: usize,
    stage: &'static str,
    words: String,
}

#[derive(Serialize)]
struct Observed {
    piece: &'static str,
    round: usize,
    detections: Vec<i64>,
    hidden_m2: f64,
}

/// One line.
fn write(output: &mut impl Write, piece: &impl Serialize) -> io::Result<()> {
    let mut line = serde_json::to_vec(piece)?;
    line.push(b'\n');
    output.write_all(&line)?;
    output.flush()
}
