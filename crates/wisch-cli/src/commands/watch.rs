//! What looks on while a session goes on: progress and times, bags and checkpoints.

use super::job::{Job, WatchedRound};
use crate::failure::Failure;
use crate::progress::Progress;
use std::ops::ControlFlow;
use std::time::{Duration, Instant};
use wisch::geometry::{Point3, Pose};
use wisch::represent::{Observation, Task};
use wisch::run::{PlannedRound, RunEvent, TelemetrySample};
use wisch_io::{OutputFolder, RoundTimes};
use wisch_report::EffectFrames;
use wisch_sim::Checkpoints;
use wisch_telemetry::{BagHead, BagWriter, LookTime, RobotShown, SceneShown, WriteError};

/// Between two updates of the progress [samples].
const SAY_EVERY: usize = 200;

/// What a round's bag is called.
pub fn bag_name(number: usize) -> String {
    format!("round-{number}.mcap")
}

/// Looks on while a session goes on: says where it is, takes the time, and keeps what the report shows of the rounds.
pub struct Watch<'a> {
    progress: &'a Progress,
    pub failure: Option<Failure>,
    /// The rounds that have begun, in order.
    rounds: Vec<WatchedRound>,
    since: Instant,
}

impl<'a> Watch<'a> {
    pub fn new(job: &Job<'a>) -> Self {
        Self {
            progress: job.progress,
            failure: None,
            rounds: Vec::new(),
            since: Instant::now(),
        }
    }

    /// A round, counted from 1.
    pub fn round(&mut self, number: usize) -> &mut WatchedRound {
        self.rounds
            .resize(self.rounds.len().max(number), WatchedRound::default());
        &mut self.rounds[number - 1]
    }

    pub fn see(&mut self, event: &RunEvent<'_>) -> ControlFlow<()> {
        match event {
            RunEvent::Planning { round } => {
                self.progress.say(format!("round {round}: planning"));
                self.since = Instant::now();
            }
            RunEvent::Planned { round, .. } => {
                self.take(*round, |times| &mut times.planning_s);
            }
            RunEvent::Following {
                round,
                passed,
                nodes,
            } => self.progress.say(format!(
                "round {round}: following, {passed} of {nodes} nodes"
            )),
            RunEvent::Predicting {
                round,
                task,
                wiped,
                progress,
            } => {
                let frames = &mut self.round(*round).frames;
                let begin = || EffectFrames::new(task, wiped);
                frames.get_or_insert_with(begin).watch(progress);
            }
            RunEvent::Audited { round, .. } => {
                self.take(*round, |times| &mut times.following_s);
            }
            RunEvent::Interpreting { round } => {
                self.take(*round, |times| &mut times.executing_s);
                self.progress.say(format!("round {round}: interpreting"));
            }
            RunEvent::Judged(round) => {
                self.take(round.motion.number, |times| &mut times.interpreting_s);
            }
            RunEvent::Considered { .. }
            | RunEvent::Sample(_)
            | RunEvent::Executing(_)
            | RunEvent::Observed { .. }
            | RunEvent::Ended(_) => {}
        }
        ControlFlow::Continue(())
    }

    /// Books the time since the last booking.
    fn take(&mut self, round: usize, part: impl Fn(&mut RoundTimes) -> &mut f64) {
        let seconds = self.since.elapsed().as_secs_f64();
        *part(&mut self.round(round).times) += seconds;
        self.since = Instant::now();
    }

    pub fn flow(&mut self, result: Result<(), Failure>) -> ControlFlow<()> {
        match result {
            Ok(()) => ControlFlow::Continue(()),
            Err(failure) => {
                self.failure.get_or_insert(failure);
                ControlFlow::Break(())
            }
        }
    }
}

/// Writes what is measured: a bag of each round, and what a killed run can be resumed with.
pub struct Recorder<'a> {
    pub folder: &'a OutputFolder,
    progress: &'a Progress,
    pub checkpoints: Checkpoints,
    /// Rounds that an earlier run executed and recorded.
    taken_over: usize,
    is_realtime: bool,
    /// The robot's description.
    urdf: Option<&'a str>,
    bag: Option<BagWriter>,
    /// Whether what the bag records is over.
    is_executed: bool,
    /// Where the surface was believed to be when it was planned, and what was last seen of it.
    world_from_surface: Pose,
    seen: Option<Seen>,
    has_given_up: bool,
    samples: usize,
    round: usize,
    begin: Instant,
    /// How long the round's motion takes [s].
    duration: f64,
}

impl<'a> Recorder<'a> {
    /// A recorder of the rounds after so many that an earlier run recorded.
    pub fn new(
        job: &Job<'a>,
        checkpoints: Checkpoints,
        taken_over: usize,
        is_realtime: bool,
    ) -> Self {
        Self {
            folder: job.folder,
            progress: job.progress,
            checkpoints,
            taken_over,
            is_realtime,
            urdf: job.robot.map(|(_, robot)| robot.files.urdf.as_str()),
            bag: None,
            is_executed: false,
            world_from_surface: job.prepared.task.surface.world_from_surface,
            seen: None,
            has_given_up: false,
            samples: 0,
            round: 0,
            begin: Instant::now(),
            duration: 0.0,
        }
    }

    /// Follows which round it is and what is seen, taken over or not.
    pub fn round_of(&mut self, event: &RunEvent<'_>) {
        match event {
            RunEvent::Executing(planned) => {
                self.round = planned.number;
                self.world_from_surface = planned.task.surface.world_from_surface;
            }
            // The bag of this round has been begun with what was seen before it.
            RunEvent::Observed { observation, .. } => {
                self.seen = Some(Seen {
                    world_from_surface: self.world_from_surface,
                    observation: (*observation).clone(),
                });
            }
            _ => {}
        }
    }

    pub const fn is_taken_over(&self) -> bool {
        self.round <= self.taken_over
    }

    /// Writes nothing more, as where it cannot.
    pub fn give_up(&mut self) {
        self.bag = None;
        self.has_given_up = true;
    }

    pub fn see(&mut self, event: &RunEvent<'_>) -> Result<(), WriteError> {
        match event {
            _ if self.has_given_up => Ok(()),
            RunEvent::Executing(planned) => self.begin(planned),
            RunEvent::Sample(sample) => self.sample(sample),
            RunEvent::Interpreting { .. } => {
                self.is_executed = true;
                Ok(())
            }
            RunEvent::Observed { observation, .. } => (self.bag.as_mut()).map_or(Ok(()), |bag| {
                bag.write_observation(LookTime::After, observation)
            }),
            RunEvent::Judged(_) => self.end(),
            _ => Ok(()),
        }
    }

    /// Ends the bag of a round that was executed, whatever became of it afterwards.
    pub fn end(&mut self) -> Result<(), WriteError> {
        let bag = self.bag.take_if(|_| self.is_executed);
        bag.map_or(Ok(()), BagWriter::finish)
    }

    fn begin(&mut self, planned: &PlannedRound) -> Result<(), WriteError> {
        let robot = planned.cell.robot();
        self.duration = planned.followed.duration();
        self.samples = 0;
        self.begin = Instant::now();
        self.checkpoints.begin(planned.number);
        let task = &planned.task;
        let head = BagHead {
            joints: (0..robot.dof())
                .map(|i| robot.variable(i).name.clone())
                .collect(),
            world_from_surface: task.surface.world_from_surface,
            start: 0,
            notes: [
                ("task", task.name.clone()),
                ("round", planned.number.to_string()),
                ("seed", task.seed.to_string()),
            ]
            .map(|(key, value)| (key.to_owned(), value))
            .into(),
        };
        let path = self.folder.place(&bag_name(planned.number));
        let mut bag = BagWriter::create(&path, head)?;
        if let Some(urdf) = self.urdf {
            bag.write_robot(&RobotShown {
                urdf,
                model: robot,
                world_from_root: *planned.cell.world_from_root(),
            })?;
        }
        bag.write_scene(&SceneShown {
            surface: &task.surface,
            objects: &task.scene,
            tool: &task.tool.mesh,
            goal: &planned.plan.graph.goal,
        })?;
        bag.write_strokes(&planned.followed.strokes)?;
        bag.write_particles(0.0, &in_world(task))?;
        if let Some(seen) = &self.seen {
            let before = seen.of_surface(&task.surface.world_from_surface);
            bag.write_observation(LookTime::Before, &before)?;
        }
        self.bag = Some(bag);
        self.is_executed = false;
        Ok(())
    }

    fn sample(&mut self, sample: &TelemetrySample<'_>) -> Result<(), WriteError> {
        if self.samples.is_multiple_of(SAY_EVERY) {
            self.progress.say(format!(
                "round {}: wiping, {:.1} of {:.1} s",
                self.round, sample.time, self.duration
            ));
        }
        self.samples += 1;
        self.checkpoints.sample(sample);
        if self.is_realtime {
            let ahead = Duration::try_from_secs_f64(sample.time).unwrap_or_default();
            std::thread::sleep(ahead.saturating_sub(self.begin.elapsed()));
        }
        self.bag.as_mut().map_or(Ok(()), |bag| bag.write(sample))
    }
}

/// What was seen of a surface that was believed to be there.
pub struct Seen {
    pub world_from_surface: Pose,
    pub observation: Observation,
}

impl Seen {
    /// The same, of the surface believed elsewhere since.
    pub fn of_surface(&self, world_from_surface: &Pose) -> Observation {
        if self.world_from_surface == *world_from_surface {
            return self.observation.clone();
        }
        let now_from_then = world_from_surface.inverse() * self.world_from_surface;
        self.observation.moved(&now_from_then)
    }
}

/// Where a task's particles are believed to lie in the world.
fn in_world(task: &Task) -> Vec<Point3> {
    let remaining = task.particles.remaining();
    remaining
        .map(|p| task.surface.world_from_surface * Point3::new(p.x, p.y, 0.0))
        .collect()
}
