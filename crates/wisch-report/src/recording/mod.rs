//! The recording of a run for its page: a sequence of pieces, one JSON object per line, in order of time.
//!
//! A live run, an episode and the report of a run all use the same lines. `crates/wisch-web/web/src/recording.ts`
//! describes the fields of each piece.

mod considered;
mod head;
mod incidents;
mod interpreted;
mod logged;
mod particles;
mod phases;
mod reasons;
mod robot;
mod round;
mod samples;
mod story;
mod surface;
#[cfg(test)]
mod tests;
mod treated;
mod words;

pub use logged::{LoggedEpisode, LoggedOccurrence, LoggedRobot, LoggedRound, LoggedTask};
pub use story::{CommandOptions, RunFact, RunOutcome};

use crate::prediction::frames::EffectFrames;
use crate::scene::Meshes;
use considered::ConsideredRecord;
use head::Head;
use interpreted::{Interpreted, Truth};
use round::RoundPiece;
use samples::Batch;
use serde::Serialize;
use std::io::{self, Write};
use story::{Ended, Stopping};
use treated::TreatedPlaces;
use wisch::follow::{Audit, Workcell};
use wisch::geometry::Pose;
use wisch::plan::{Plan, Prediction, Strategy};
use wisch::represent::{ParticleDistribution, SurfaceShape, Task};
use wisch::robot::Appearance;
use wisch::run::{PlannedRound, RunEvent};

/// Version of the format of recordings.
pub const RECORDING_SCHEMA: u32 = 1;

/// The first piece of a recording: task, program and robot.
#[derive(Debug, Clone, Copy)]
pub struct RecordingHead<'a> {
    /// Headline.
    pub title: &'a str,
    /// Name and version of the program that writes it, such as "wisch 0.1.0".
    pub program: &'a str,
    /// The task.
    pub task: &'a Task,
    /// Strategy that plans the strokes.
    pub strategy: Strategy,
    /// Target performance, in [0, 1].
    pub target: f64,
    /// The robot with its tool and scene; `None` without a robot.
    pub cell: Option<&'a Workcell>,
    /// Visual geometry of the robot; `None` shows its collision geometry.
    pub appearance: Option<&'a Appearance>,
}

/// A plan that is not executed.
#[derive(Debug, Clone, Copy)]
pub struct UnexecutedPlan<'a> {
    /// The task as it was believed.
    pub task: &'a Task,
    /// The plan without abandoned nodes.
    pub plan: &'a Plan,
    /// The predicted effect.
    pub prediction: &'a Prediction,
    /// The predicted effect over time.
    pub frames: &'a EffectFrames,
    /// The robot's motion and its check; `None` without a robot.
    pub followed: Option<(&'a Workcell, &'a wisch::follow::Followed, &'a Audit)>,
}

/// The simulated world's ground truth of a round.
#[derive(Debug, Clone, Copy)]
pub struct RoundTruth<'a> {
    /// Number of the round, from 1.
    pub round: usize,
    /// True performance, in [0, 1]; `None` without simulated dirt.
    pub performance: Option<f64>,
    /// True dirt locations in the frame of the true surface \[m\].
    pub particles: Option<&'a ParticleDistribution>,
    /// Times of pushes: start, end \[s\].
    pub pushes: &'a [[f64; 2]],
    /// True pose of the surface in the world.
    pub world_from_surface: Option<Pose>,
    /// Its true shape, if it differs from the believed one.
    pub surface_shape: Option<&'a SurfaceShape>,
}

/// A writer of a run's recording; it writes each piece as soon as it is known.
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
    /// Number of meshes that are written.
    written: usize,
    /// The round's predicted effect, until the round is executed.
    frames: Option<EffectFrames>,
    /// The predicted effect of the first round, once it is executed.
    first: Option<EffectFrames>,
    /// The candidates among which the round's plan was chosen.
    considered: Vec<ConsideredRecord>,
    /// Sentence about the check of the round's motion.
    audited: Option<String>,
    batch: Batch,
    target: f64,
    /// The places of a treated surface; `None` for dirt.
    treated: Option<TreatedPlaces>,
    /// How the session came to its end.
    stopping: Stopping,
}

impl<W: Write> RecordingWriter<W> {
    /// Makes a writer of a recording to `output`.
    pub fn new(output: W) -> Self {
        Self {
            output,
            meshes: Meshes::new(robot::MAX_TRIANGLES),
            written: 0,
            frames: None,
            first: None,
            considered: Vec::new(),
            audited: None,
            batch: Batch::default(),
            target: 0.0,
            treated: None,
            stopping: Stopping::Failed,
        }
    }

    /// Takes the predicted effect of the first round over time; `None` for a plan without strokes.
    pub fn take_first_frames(&mut self) -> Option<EffectFrames> {
        match self.batch.round() {
            0 => self.frames.take(),
            _ => self.first.take(),
        }
    }

    /// Ends writing and returns the output.
    pub fn into_inner(self) -> W {
        self.output
    }

    /// The output, while the recording is unfinished.
    pub const fn get_mut(&mut self) -> &mut W {
        &mut self.output
    }

    /// Writes the first piece of the recording.
    ///
    /// # Errors
    /// If the output cannot be written.
    pub fn begin(&mut self, head: &RecordingHead<'_>) -> io::Result<()> {
        self.target = head.target;
        self.treated = TreatedPlaces::new(head.task);
        let piece = Head::new(head, &mut self.meshes);
        self.written = self.meshes.len();
        write(&mut self.output, &piece)
    }

    /// Writes the first piece of an episode that was kept without a recording.
    ///
    /// # Errors
    /// If the output cannot be written.
    pub fn begin_log(&mut self, episode: &LoggedEpisode<'_>) -> io::Result<()> {
        let piece = Head::of_episode(episode, None, &mut self.meshes);
        self.written = self.meshes.len();
        write(&mut self.output, &piece)
    }

    /// Records a round of such an episode; its samples follow as [`RunEvent::Sample`]s, and [`flush`](Self::flush) ends it.
    ///
    /// # Errors
    /// If the output cannot be written.
    pub fn record_log(&mut self, round: &LoggedRound<'_>) -> io::Result<()> {
        let piece = RoundPiece::logged(round, &mut self.meshes, self.written);
        self.written = self.meshes.len();
        self.batch = Batch::new(round.number, round.surface());
        write(&mut self.output, &piece)
    }

    /// Records an event of the run.
    ///
    /// # Errors
    /// If the output cannot be written.
    pub fn record_event(&mut self, event: &RunEvent<'_>) -> io::Result<()> {
        match *event {
            RunEvent::Planning { round } => {
                self.frames = None;
                self.considered.clear();
                self.stage(round, "planning", "planning".to_owned())
            }
            RunEvent::Evaluated { considered, .. } => {
                self.considered = considered.iter().map(ConsideredRecord::new).collect();
                Ok(())
            }
            RunEvent::Planned { round, plan } => {
                self.stage(round, "planned", words::summarise_plan(plan))
            }
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
                self.frames.get_or_insert_with(begin).record(&progress);
                Ok(())
            }
            RunEvent::Audited { round, audit } => {
                let found = words::describe_audit(audit);
                self.audited = Some(found.clone());
                self.stage(round, "audited", found)
            }
            RunEvent::Executing(planned) => self.executing(planned),
            RunEvent::Sample(sample) => {
                let due = self.batch.watch(sample);
                if due { self.flush() } else { Ok(()) }
            }
            RunEvent::Warned(warning) => {
                self.stage(warning.round, "executing", format!("warning: {warning}"))
            }
            RunEvent::Interpreting { round } => {
                self.flush()?;
                self.stage(
                    round,
                    "interpreting",
                    "interpreting the measurements".to_owned(),
                )
            }
            RunEvent::Observed { round, observation } => {
                let piece = Observed {
                    piece: "observed",
                    round,
                    detections: particles::flatten_places(observation.detections.iter().copied()),
                    hidden_m2: samples::round_to(observation.hidden.area(), 1e4),
                };
                write(&mut self.output, &piece)
            }
            RunEvent::Decided(round) => {
                self.flush()?;
                let piece = Interpreted::new(round, self.target, self.treated.as_ref());
                write(&mut self.output, &piece)
            }
            RunEvent::Ended(verdict) => {
                self.stopping = match verdict {
                    Some(_) => Stopping::Decided,
                    None => Stopping::Interrupted,
                };
                Ok(())
            }
        }
    }

    /// Records a plan that is not executed.
    ///
    /// # Errors
    /// If the output cannot be written.
    pub fn record_plan(&mut self, planned: &UnexecutedPlan<'_>) -> io::Result<()> {
        let audited = planned
            .followed
            .map(|(_, _, audit)| words::describe_audit(audit));
        let piece = RoundPiece::planned(planned, audited, &mut self.meshes, self.written)
            .with_candidates(std::mem::take(&mut self.considered), planned.plan.strategy);
        self.written = self.meshes.len();
        write(&mut self.output, &piece)?;
        for batch in samples::planned(planned) {
            write(&mut self.output, &batch)?;
        }
        Ok(())
    }

    /// Records the simulated world's ground truth of a round.
    ///
    /// # Errors
    /// If the output cannot be written.
    pub fn record_truth(&mut self, truth: &RoundTruth<'_>) -> io::Result<()> {
        write(&mut self.output, &Truth::new(truth, self.treated.as_ref()))
    }

    /// Writes the last piece. `episode`: name of the episode in the memory, if one is kept.
    ///
    /// # Errors
    /// If the output cannot be written.
    pub fn end(&mut self, outcome: &RunOutcome<'_>, episode: Option<&str>) -> io::Result<()> {
        write(
            &mut self.output,
            &Ended::new(outcome, self.stopping, episode),
        )
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
        .with_candidates(std::mem::take(&mut self.considered), planned.plan.strategy);
        self.written = self.meshes.len();
        self.batch = Batch::of(planned);
        if planned.number == 1 {
            self.first = frames;
        }
        write(&mut self.output, &piece)?;
        self.stage(
            planned.number,
            "executing",
            format!("wiping for {:.1} s", planned.followed.duration()),
        )
    }

    /// Writes the samples that wait for a full piece.
    ///
    /// # Errors
    /// If the output cannot be written.
    pub fn flush(&mut self) -> io::Result<()> {
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

/// Writes a piece as one line.
fn write(output: &mut impl Write, piece: &impl Serialize) -> io::Result<()> {
    let mut line = serde_json::to_vec(piece)?;
    line.push(b'\n');
    output.write_all(&line)?;
    output.flush()
}
