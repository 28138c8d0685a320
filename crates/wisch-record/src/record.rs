//! The complete record of a run: one call at its beginning, one per event, and one at its end.

use crate::bag::{BagSink, bag_name};
use crate::episode::{EpisodeSink, EpisodeTarget, KeptEpisode};
use crate::error::{RecordError, internal};
use crate::folder::write_results;
use crate::packed::pack;
use crate::page::PageSink;
use crate::results::{RoundGroundTruth, RunResults};
use crate::sink::{AfterFailure, RunSink, SinkError, SinkSet};
use crate::stages::StageSink;
use std::ops::ControlFlow;
use std::path::PathBuf;
use wisch::follow::WorkcellConfig;
use wisch::represent::Observation;
use wisch::run::{RunEvent, Session};
use wisch_io::{ExecutedBy, Leftover, LoadedTask, OutputFolder, Replaceable, Robot};
use wisch_report::CommandOptions;
use wisch_telemetry::active_path;

/// Settings of a run's record: the parts to keep, and their locations.
#[derive(Debug, Clone, Default)]
pub struct RecordOptions {
    /// Name and version of the program that writes the record, such as "wisch 0.2.0".
    pub program: String,
    /// Folder of the results; it replaces the folder of an earlier run. `None` writes no results.
    pub out: Option<PathBuf>,
    /// Existing folder for the bags; `None` writes them into the folder of the results.
    pub bags: Option<PathBuf>,
    /// Number of rounds whose bags a killed run has written.
    pub taken_over: usize,
    /// Memory for the episode; `None` keeps no episode.
    pub episode: Option<EpisodeTarget>,
    /// Whether to publish the recording in the episode's memory during the run, for live pages.
    pub is_live: bool,
    /// Planning groups and pose of the robot; `None` uses those of the task.
    pub workcell: Option<WorkcellConfig>,
    /// Options of the run beside its task, with which the page suggests commands; `None` if they are unknown.
    pub options: Option<CommandOptions>,
}

/// The record of a run: a bag of each round, the recording for the page, an episode, and the folder of results.
///
/// ```no_run
/// use wisch_io::{ExecutedBy, LoadOptions, load_task};
/// use wisch_record::{EpisodeTarget, RecordOptions, RunRecord};
/// # fn run(executor: &mut dyn wisch::run::Executor) -> Result<(), Box<dyn std::error::Error>> {
///
/// let loaded = load_task("my-board.toml".as_ref(), &LoadOptions::default())?;
/// let robot = loaded.robot()?.ok_or("the task names no robot")?;
/// let options = RecordOptions {
///     program: "my program 1.0".to_owned(),
///     out: Some("out/my-board".into()),
///     episode: Some(EpisodeTarget {
///         memory: "episodes".into(),
///         executor: Some("my robot".to_owned()),
///         ..EpisodeTarget::default()
///     }),
///     ..RecordOptions::default()
/// };
/// let mut record = RunRecord::begin(&loaded, Some(&robot), options)?;
/// let mut session = loaded.session().with_robot(robot.robot_setup());
/// let run = session.run(executor, &mut |event| record.on_event(event));
/// let kept = record.finish(&loaded, Some(&robot), session, ExecutedBy::Executor, Vec::new())?;
/// run?;
/// println!("{} rounds", kept.results.rounds.len());
/// # Ok(()) }
/// ```
pub struct RunRecord {
    program: String,
    stages: StageSink,
    page: PageSink,
    more: SinkSet,
    episode: Option<EpisodeSink>,
    bags: Option<BagSink>,
    folder: Option<OutputFolder>,
    failure: Option<RecordError>,
    no_bag: Option<RecordError>,
    lost_sinks: Vec<SinkError>,
    is_ending: bool,
}

/// The outputs of a finished record.
#[derive(Debug)]
pub struct KeptRun {
    /// The results of the run.
    pub results: RunResults,
    /// The episode; `None` if none was requested, or the error that prevented it.
    pub episode: Result<Option<KeptEpisode>, RecordError>,
    /// The error after which no further bags were written, if the run continued for its episode.
    pub no_bag: Option<RecordError>,
    /// The failure of a sink that stopped the run, if there was one.
    pub failure: Option<RecordError>,
    /// The failures of custom sinks without which the run continued.
    pub lost_sinks: Vec<SinkError>,
    /// The error that prevented the folder of results; the episode is kept regardless of it.
    pub results_error: Option<RecordError>,
}

impl RunRecord {
    /// Begins the record, before the run begins.
    ///
    /// # Parameters
    /// - `robot`: the robot of the session; `None` for a session without a robot.
    ///
    /// # Errors
    /// If a folder cannot be written, or holds files that are neither results nor episodes.
    pub fn begin(
        loaded: &LoadedTask,
        robot: Option<&Robot>,
        options: RecordOptions,
    ) -> Result<Self, RecordError> {
        let RecordOptions {
            program,
            out,
            bags,
            taken_over,
            episode,
            is_live,
            workcell,
            options,
        } = options;
        let folder = out
            .map(|out| OutputFolder::begin(&out, Leftover::Remove, Replaceable::All))
            .transpose()?;
        let episode = episode.map(EpisodeSink::begin).transpose()?;
        let workcell = workcell.unwrap_or_else(|| loaded.run.workcell.clone());
        let performer = robot.map(|robot| (robot, &workcell));
        let live = episode.as_ref().filter(|_| is_live);
        let page = match live {
            Some(episode) => {
                let place = (episode.memory_folder(), episode.id());
                PageSink::begin_live(loaded, &program, performer, place)?
            }
            None => PageSink::begin(loaded, &program, performer)?,
        }
        .with_options(options);
        let bags = bags.or_else(|| {
            let bag = folder.as_ref()?.file_path(&bag_name(1));
            bag.parent().map(PathBuf::from)
        });
        let urdf = robot.map(|robot| robot.files.urdf.as_str());
        let bags = bags
            .map(|place| BagSink::new(place, urdf, &loaded.task).with_resumed_rounds(taken_over));
        let mut episode = episode;
        if let (Some(episode), true) = (&mut episode, bags.is_some()) {
            episode.take_from_bags();
        }
        Ok(Self {
            program,
            stages: StageSink::default(),
            page,
            more: SinkSet::default(),
            episode,
            bags,
            folder,
            failure: None,
            no_bag: None,
            lost_sinks: Vec::new(),
            is_ending: false,
        })
    }

    /// Adds a sink of your own to the record.
    ///
    /// ```
    /// use wisch::run::RunEvent;
    /// use wisch_io::{LoadOptions, load_task};
    /// use wisch_record::{EventSink, RecordOptions, RunRecord};
    /// # let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenarios/chopping-board.toml").as_ref();
    /// let loaded = load_task(path, &LoadOptions::default())?;
    /// let mut record = RunRecord::begin(&loaded, None, RecordOptions::default())?;
    /// record.add(Box::new(EventSink::new("standard error", std::io::stderr())));
    /// assert!(record.on_event(&RunEvent::Planning { round: 1 }).is_continue());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn add(&mut self, sink: Box<dyn RunSink + Send>) {
        self.more.add(sink);
    }

    /// Remarks about the recording, one sentence each.
    pub fn remarks(&self) -> &[String] {
        self.page.remarks()
    }

    /// The episode that the record keeps, while it is unfinished.
    pub fn episode_mut(&mut self) -> Option<&mut EpisodeSink> {
        self.episode.as_mut()
    }

    /// The durations of the stages of each round.
    pub fn stages_mut(&mut self) -> &mut StageSink {
        &mut self.stages
    }

    /// Collects the results of a session, without its rounds.
    ///
    /// # Errors
    /// [`RecordError::Nothing`] if no round was planned.
    pub fn results(&mut self, session: &Session<'_>) -> Result<RunResults, RecordError> {
        let frames = self.page.take_first_frames();
        RunResults::from_session(session, &mut self.stages, frames)
    }

    /// Whether a failure stops the run or prevents resuming it later.
    pub const fn has_failed(&self) -> bool {
        self.failure.is_some() || self.no_bag.is_some()
    }

    /// Passes an event to every sink. Returns `Break` if the session must stop cleanly; return that to the session.
    ///
    /// With an episode, the run continues after bags cannot be written. The episode's telemetry is then written during
    /// execution.
    pub fn on_event(&mut self, event: &RunEvent<'_>) -> ControlFlow<()> {
        // This sink only measures time and cannot fail.
        let _ = self.stages.on_event(event);
        // Such a session was ended by a failure, not by its operator.
        let is_failing = matches!(event, RunEvent::Ended(None)) && self.failure.is_some();
        if !is_failing && let Err(error) = self.page.on_event(event) {
            self.fail(internal(format!("a recording cannot be written: {error}")));
        }
        let more = self.more.on_event(event);
        for error in self.more.take_failures() {
            match error.after {
                AfterFailure::StopRun => self.fail(RecordError::Sink(error)),
                AfterFailure::ContinueRun => self.lost_sinks.push(error),
            }
        }
        if let Some(episode) = &mut self.episode {
            let _ = episode.on_event(event);
        }
        let bag = self.bags.as_mut().map(|bags| bags.take_in(event));
        if let Some(Err(error)) = bag {
            self.abandon_bags(error.into());
        }
        if let (RunEvent::Decided(_), Some(episode), Some(bags)) =
            (event, &mut self.episode, &self.bags)
        {
            episode.copy_bag(&bags.path());
        }
        self.is_ending |= more.is_break();
        if self.is_ending {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    }

    fn fail(&mut self, error: RecordError) {
        self.failure.get_or_insert(error);
        self.is_ending = true;
    }

    /// Stops writing bags after an error. With an episode the run continues; without an episode it stops cleanly.
    pub fn abandon_bags(&mut self, error: RecordError) {
        // The writer of the bag ends here, so that the bag holds what could be written.
        let bag = self.bags.take().map(|bags| active_path(&bags.path()));
        if let Some(episode) = &mut self.episode {
            if let Some(bag) = bag {
                episode.leave_bags(&bag);
            }
            self.no_bag.get_or_insert(error);
        } else {
            self.fail(error);
        }
    }

    /// Finishes the bag that is being written; the caller passes no further events.
    pub fn end_bags(&mut self) {
        let ended = self.bags.as_mut().map_or(Ok(()), BagSink::end);
        if let Err(error) = ended {
            self.no_bag.get_or_insert(error.into());
        }
    }

    /// Takes the failure of the sink that stopped the run, if there was one.
    pub fn take_failure(&mut self) -> Option<RecordError> {
        self.failure.take()
    }

    /// Finishes the recording and stores the episode in the memory, without writing the results.
    ///
    /// # Errors
    /// [`RecordError::Internal`], which no input should cause.
    pub fn keep(
        mut self,
        loaded: &LoadedTask,
        robot: Option<&Robot>,
        mut results: RunResults,
        first_observation: Option<Observation>,
    ) -> Result<KeptRun, RecordError> {
        self.end_bags();
        results.recording = self.page.end(loaded, &results)?;
        results.packed = pack(&results.recording)?;
        let files = robot.map(|robot| &robot.files);
        let program = &self.program;
        let episode = (self.episode)
            .map(|episode| {
                let (rounds, packed) = (&results.rounds, Some(&results.packed[..]));
                episode.commit(rounds, first_observation, loaded, files, packed, program)
            })
            .transpose();
        let kept = episode.as_ref().ok().and_then(Option::as_ref);
        self.page
            .leave(loaded, &results, kept.map(|kept| kept.id.as_str()));
        Ok(KeptRun {
            results,
            episode,
            no_bag: self.no_bag,
            failure: self.failure,
            lost_sinks: self.lost_sinks,
            results_error: None,
        })
    }

    /// Finishes the recording, stores the episode and writes the results. Call it after the session has ended or failed.
    ///
    /// # Parameters
    /// - `truths`: ground truth of the rounds in a simulated world, in their order; empty for a real robot.
    ///
    /// # Errors
    /// [`RecordError::Nothing`] if no round was planned. A part that cannot be written is stated in [`KeptRun`].
    pub fn finish(
        mut self,
        loaded: &LoadedTask,
        robot: Option<&Robot>,
        session: Session<'_>,
        executed_by: ExecutedBy,
        truths: Vec<RoundGroundTruth>,
    ) -> Result<KeptRun, RecordError> {
        let mut results = self.results(&session)?;
        let first_observation = session.first_observation().cloned();
        results.add_rounds(session.into_rounds(), &mut self.stages, executed_by, truths);
        self.finish_with(loaded, robot, results, first_observation)
    }

    /// Finishes the record like [`finish`](Self::finish), with results that the caller has collected.
    ///
    /// # Errors
    /// [`RecordError::Internal`], which no input should cause. A part that cannot be written is stated in [`KeptRun`].
    pub fn finish_with(
        mut self,
        loaded: &LoadedTask,
        robot: Option<&Robot>,
        results: RunResults,
        first_observation: Option<Observation>,
    ) -> Result<KeptRun, RecordError> {
        let folder = self.folder.take();
        let mut kept = self.keep(loaded, robot, results, first_observation)?;
        if let Some(folder) = folder {
            let written = write_results(&folder, loaded, &kept.results);
            let written = written.and_then(|()| Ok(folder.finish()?));
            kept.results_error = written.err();
        }
        Ok(kept)
    }
}
