//! The closed loop of `wisch run`: rounds of planning, wiping and interpreting, with a bag of each.

use super::follow::{Chosen, Following, performer, workcell_config};
use super::past::{self, Keeper};
use super::prepare::Prepared;
use super::remember::Remembering;
use super::words::{counted, percent};
use crate::args::{LoopArgs, TaskArgs};
use crate::failure::Failure;
use crate::output::OutputFolder;
use crate::progress::Progress;
use crate::records::{RoundSummary, RoundTimes};
use crate::terminal::remark;
use std::cell::RefCell;
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::time::{Duration, Instant};
use wisch::execute::{Ending, ExecuteConfig, TelemetrySample};
use wisch::follow::{FollowConfig, audit};
use wisch::geometry::Point3;
use wisch::interpret::EventKind;
use wisch::recover::{Pace, Verdict};
use wisch::represent::{ParticleDistribution, Task};
use wisch::run::{Motion, News, Performer, Round, RunConfig, RunError, resume};
use wisch_report::{RoundView, RoundsInput};
use wisch_telemetry::{BagHead, BagWriter, WriteError};

/// Between two updates of the progress [samples].
const SAY_EVERY: usize = 200;

/// Rounds of a single stroke that stand for one of a whole plan.
const GREEDY_ROUNDS: usize = 10;

/// A round with how long its parts took.
pub struct Done {
    /// The round.
    pub round: Round,
    /// How long its parts took.
    pub times: RoundTimes,
    /// Where the dirt really lies after it; `None` where none was simulated.
    pub truth: Option<ParticleDistribution>,
    /// When somebody pushed [s].
    pub pushes: Vec<[f64; 2]>,
}

/// What a round's bag is called.
pub fn bag_name(number: usize) -> String {
    format!("round-{number}.mcap")
}

/// Wipes until the goal is met, or no more can be done; says where the episode is kept, if it is.
#[allow(clippy::too_many_arguments, reason = "what a run is made of")]
pub fn wipe(
    chosen: &Chosen<'_>,
    args: &LoopArgs,
    task_args: &TaskArgs,
    prepared: &Prepared,
    given: Option<wisch::plan::Plan>,
    folder: &OutputFolder,
    progress: &Progress,
) -> Result<(Vec<Done>, Option<PathBuf>), Failure> {
    progress.say("reading the robot");
    let robot = performer(chosen, task_args)?;
    let mut episode = Remembering::begin(&args.memory)?;
    let reality = &prepared.reality;
    let (pace, usual_rounds) = if args.greedy {
        (Pace::Greedy, GREEDY_ROUNDS * reality.max_rounds)
    } else {
        (Pace::Whole, reality.max_rounds)
    };
    let config = RunConfig {
        plan: prepared.config.clone(),
        variants: prepared.file.plan_variants(),
        workcell: workcell_config(chosen, prepared),
        follow: FollowConfig {
            seed: prepared.config.seed,
            ..FollowConfig::default()
        },
        execute: ExecuteConfig::default(),
        target: prepared.file.target_performance(),
        max_rounds: args.rounds.map_or(usual_rounds, usize::from),
        pace,
    };
    let performer = Performer {
        robot: &robot.model,
        srdf: robot.srdf.as_ref(),
        map: robot.map.as_ref(),
    };
    let fingerprint = {
        // More or fewer rounds are no other run.
        let config = RunConfig {
            max_rounds: 0,
            ..config.clone()
        };
        let pushed: [&dyn std::fmt::Debug; 5] =
            [&prepared.task, reality, &performer, &given, &config];
        past::fingerprint(&pushed)
    };
    let past = match folder.found().is_taken_over {
        true => past::read(folder, fingerprint)?,
        false => Vec::new(),
    };
    if args.resume && folder.found().is_taken_over {
        let kept = counted(past.len(), "round");
        progress.aside(|| remark(&format!("{kept} of the killed run taken over")));
    }
    let (past, executing_s) = past.into_iter().map(|p| (p.past, p.executing_s)).unzip();
    let keeper = Keeper::new(folder, fingerprint);
    let watch = Watch::new(folder, progress, keeper, executing_s, args.realtime);
    let watch = RefCell::new(watch);
    let rounds = resume(
        &prepared.task,
        &performer,
        reality,
        given,
        past,
        &config,
        &mut |news| {
            episode.see(&news)?;
            watch.borrow_mut().see(&news)
        },
    );
    episode.check()?;
    let watch = watch.into_inner();
    if let Some(failure) = watch.failure {
        return Err(failure);
    }
    let rounds = rounds.map_err(|error| match error {
        RunError::Follow(error) => chosen.cannot_follow(&error, task_args, prepared),
        error => prepared.failure(task_args, error),
    })?;
    let done = rounds.into_iter().zip(watch.times);
    let done = done.map(|(round, times)| {
        let dirt = &round.executed.truth.dirt;
        let truth = (!dirt.grains().is_empty()).then(|| dirt.particles());
        let number = round.motion.number;
        let pushes = reality.pushes.iter().filter(|push| push.round == number);
        Ok(Done {
            truth: truth
                .transpose()
                .map_err(|error| prepared.failure(task_args, error))?,
            pushes: pushes
                .map(|push| [push.start, push.start + push.duration])
                .collect(),
            round,
            times,
        })
    });
    let done: Vec<Done> = done.collect::<Result<_, Failure>>()?;
    let kept = episode.commit(&done, prepared, task_args, &robot.files)?;
    Ok((done, kept))
}

/// Looks on while the loop runs: says where it is, writes bags, and takes the time.
struct Watch<'a> {
    folder: &'a OutputFolder,
    progress: &'a Progress,
    realtime: bool,
    bag: Option<BagWriter>,
    failure: Option<Failure>,
    keeper: Keeper,
    /// How long the executions of an earlier run took [s].
    past_s: Vec<f64>,
    times: Vec<RoundTimes>,
    since: Instant,
    samples: usize,
    /// Whether the round is planned.
    follows: bool,
    /// The round, and how long its motion takes [s].
    round: usize,
    duration: f64,
}

impl<'a> Watch<'a> {
    fn new(
        folder: &'a OutputFolder,
        progress: &'a Progress,
        keeper: Keeper,
        past_s: Vec<f64>,
        realtime: bool,
    ) -> Self {
        Self {
            keeper,
            past_s,
            folder,
            progress,
            realtime,
            bag: None,
            failure: None,
            times: Vec::new(),
            since: Instant::now(),
            samples: 0,
            follows: false,
            round: 0,
            duration: 0.0,
        }
    }

    fn see(&mut self, news: &News<'_>) -> ControlFlow<()> {
        let result = match news {
            News::Planning(round) => {
                self.round = *round;
                self.progress.say(format!("round {round}: planning"));
                self.since = Instant::now();
                self.follows = false;
                self.times.push(RoundTimes::default());
                Ok(())
            }
            News::Following { passed, nodes } => {
                if !self.follows {
                    self.take(|times| &mut times.planning_s);
                    self.follows = true;
                }
                let round = self.round;
                self.progress.say(format!(
                    "round {round}: following, {passed} of {nodes} nodes"
                ));
                Ok(())
            }
            News::Executing(motion) => {
                self.take(|times| &mut times.following_s);
                self.begin(motion)
            }
            News::Sample(sample) => self.sample(sample),
            News::Recalling(motion) => {
                self.take(|times| &mut times.following_s);
                let executing_s = self.past_s.get(motion.number - 1).copied();
                if let Some(times) = self.times.last_mut() {
                    times.executing_s = executing_s.unwrap_or_default();
                }
                Ok(())
            }
            News::Interpreting => {
                self.take(|times| &mut times.executing_s);
                self.progress
                    .say(format!("round {}: interpreting", self.round));
                self.bag.take().map_or(Ok(()), BagWriter::finish)
            }
            News::Over(round) => {
                self.take(|times| &mut times.interpreting_s);
                return self.flow(self.keep(round));
            }
        };
        self.flow(
            result
                .map_err(|error| Failure::new(error).with_help("choose another folder with --out")),
        )
    }

    fn flow(&mut self, result: Result<(), Failure>) -> ControlFlow<()> {
        match result {
            Ok(()) => ControlFlow::Continue(()),
            Err(failure) => {
                self.failure.get_or_insert(failure);
                ControlFlow::Break(())
            }
        }
    }

    /// Keeps a round, unless it was taken over, or the run is about to fail.
    fn keep(&self, round: &Round) -> Result<(), Failure> {
        let executing_s = self.times.last().map_or(0.0, |times| times.executing_s);
        if round.motion.number <= self.past_s.len() || self.failure.is_some() {
            return Ok(());
        }
        self.keeper.keep(round, executing_s)
    }

    /// Books the time since the last booking.
    fn take(&mut self, part: impl Fn(&mut RoundTimes) -> &mut f64) {
        if let Some(times) = self.times.last_mut() {
            *part(times) += self.since.elapsed().as_secs_f64();
        }
        self.since = Instant::now();
    }

    fn begin(&mut self, motion: &Motion) -> Result<(), WriteError> {
        let robot = motion.cell.robot();
        self.duration = motion.followed.duration();
        self.samples = 0;
        self.keeper.begin();
        let task = &motion.task;
        let head = BagHead {
            joints: (0..robot.dof())
                .map(|i| robot.variable(i).name.clone())
                .collect(),
            world_from_surface: task.surface.world_from_surface,
            start: 0,
            notes: [
                ("task", task.name.clone()),
                ("round", motion.number.to_string()),
                ("seed", task.seed.to_string()),
            ]
            .map(|(key, value)| (key.to_owned(), value))
            .into(),
        };
        let path = self.folder.place(&bag_name(motion.number));
        let mut bag = BagWriter::create(&path, head)?;
        bag.write_particles(0.0, &in_world(task))?;
        self.bag = Some(bag);
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
        self.keeper.sample(sample);
        if self.realtime {
            let ahead = Duration::try_from_secs_f64(sample.time).unwrap_or_default();
            std::thread::sleep(ahead.saturating_sub(self.since.elapsed()));
        }
        self.bag.as_mut().map_or(Ok(()), |bag| bag.write(sample))
    }
}

/// Where a task's particles are believed to lie in the world.
fn in_world(task: &Task) -> Vec<Point3> {
    let remaining = task.particles.remaining();
    remaining
        .map(|p| task.surface.world_from_surface * Point3::new(p.x, p.y, 0.0))
        .collect()
}

/// The first round's motion, as a following.
pub fn first_following(
    done: &Done,
    task_args: &TaskArgs,
    prepared: &Prepared,
) -> Result<Following, Failure> {
    let motion = &done.round.motion;
    let config = FollowConfig::default();
    let audit = audit(&motion.followed, &motion.cell, &motion.task, &config)
        .map_err(|error| prepared.failure(task_args, error))?;
    Ok(Following {
        robot: motion.cell.robot().name().to_owned(),
        cell: motion.cell.clone(),
        followed: motion.followed.clone(),
        audit,
        time_s: done.times.following_s,
    })
}

/// What `--json` says of a round.
pub fn summary(done: &Done) -> RoundSummary {
    RoundSummary::new(&done.round, &done.times)
}

/// What the report shows of the rounds.
pub fn views(done: &[Done]) -> Vec<RoundView<'_>> {
    done.iter()
        .map(|done| RoundView {
            number: done.round.motion.number,
            plan: &done.round.motion.plan,
            believed: &done.round.motion.task.particles,
            predicted: done.round.motion.prediction.performance.ratio(),
            interpretation: &done.round.interpretation,
            truth: done.truth.as_ref().zip(done.round.true_performance),
            pushes: &done.pushes,
        })
        .collect()
}

/// The report's part about rounds.
pub fn input<'a>(
    done: &'a [Done],
    views: &'a [RoundView<'a>],
    prepared: &'a Prepared,
) -> Option<RoundsInput<'a>> {
    let first = done.first()?;
    Some(RoundsInput {
        task: &prepared.task,
        goal: &first.round.motion.plan.graph.goal,
        target: prepared.file.target_performance(),
        rounds: views,
    })
}

/// The rounds, one line each, for people.
pub fn rounds_in_words(done: &[Done]) -> Vec<(&'static str, String)> {
    done.iter()
        .map(|done| {
            let round = &done.round;
            let told = &round.interpretation;
            let estimate = &told.performance;
            let mut text = format!(
                "estimated {} ({} to {})",
                percent(estimate.mean),
                percent(estimate.low),
                percent(estimate.high)
            );
            if let Some(truth) = round.true_performance {
                text += &format!(", true {}", percent(truth));
            }
            let collisions = (told.events.iter())
                .filter(|event| event.kind == EventKind::Collision)
                .count();
            if collisions > 0 {
                text += &format!(", {}", counted(collisions, "collision"));
            }
            if let wisch::interpret::Diagnosis::Relocalize { .. } = told.diagnosis
                && let Some(plane) = &told.plane
            {
                text += &format!(
                    ", surface found tilted by {:.1}° and {:.1} mm off",
                    plane.tilt.to_degrees(),
                    1e3 * plane.offset
                );
            }
            if let Ending::ProtectiveStop { time, cause } = &round.executed.ending {
                text += &format!(", stopped at {time:.1} s: {cause}");
            }
            text += &format!(": {}", round.verdict.as_str());
            let number = round.motion.number;
            (
                if number == 1 { "rounds" } else { "" },
                format!("{number}: {text}"),
            )
        })
        .collect()
}

/// Whether the last round met the goal.
pub fn goal_met(done: &[Done]) -> bool {
    (done.last()).is_some_and(|done| done.round.verdict == Verdict::GoalMet)
}
