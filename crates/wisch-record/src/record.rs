//! Everything that a run leaves, by one call at its beginning, one for each event, and one at its end.

use crate::bag::{BagSink, bag_name};
use crate::episode::{EpisodeSink, EpisodeTarget, KeptEpisode};
use crate::error::{RecordError, internal};
use crate::folder::write_results;
use crate::packed::packed;
use crate::page::PageSink;
use crate::results::{KnownTruth, RunResults};
use crate::sink::{AfterFailure, RunSink, SinkSet};
use crate::stages::StageSink;
use std::ops::ControlFlow;
use std::path::PathBuf;
use wisch::follow::WorkcellConfig;
use wisch::represent::Observation;
use wisch::run::{RunEvent, Session};
use wisch_io::{ExecutedBy, Leftover, LoadedTask, OutputFolder, Replaceable, Robot};

/// What is to be kept of a run, and where.
#[derive(Debug, Clone, Default)]
pub struct RecordOptions {
    /// What writes it, such as "wisch 0.2.0".
    pub program: String,
    /// The folder of the results, which replaces one of an earlier run; `None` writes none.
    pub out: Option<PathBuf>,
    /// A folder that is there, for the bags alone; `None` puts them among the results.
    pub bags: Option<PathBuf>,
    /// Rounds of which an earlier run wrote the bags.
    pub taken_over: usize,
    /// Where the episode is kept; `None` keeps none.
    pub episode: Option<EpisodeTarget>,
    /// Whether others can read the recording in the episode's memory while the run goes on.
    pub is_live: bool,
    /// Which part of the robot wipes, and where the robot stands; `None` is as the task says.
    pub workcell: Option<WorkcellConfig>,
}

/// Keeps a run: a bag of each round, the recording of which the page is made, an episode, and the folder with the results.
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
///         names: None,
///     }),
///     ..RecordOptions::default()
/// };
/// let mut record = RunRecord::begin(&loaded, Some(&robot), options)?;
/// let mut session = loaded.session().with_robot(robot.performer());
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
    is_ending: bool,
}

/// What was kept of a run.
#[derive(Debug)]
pub struct KeptRun {
    /// What came of it.
    pub results: RunResults,
    /// The episode, if one was wanted, or why there is none.
    pub episode: Result<Option<KeptEpisode>, RecordError>,
    /// Why bags are missing, where they are and the run went on for the sake of its episode.
    pub no_bag: Option<RecordError>,
    /// Why the run ended in order before its end, where that was a sink.
    pub failure: Option<RecordError>,
}

impl RunRecord {
    /// Begins to keep a run that has not begun.
    ///
    /// # Parameters
    /// - `robot`: the robot of the session; `None` for one without.
    ///
    /// # Errors
    /// A place that cannot be written, or that holds something else than results or episodes.
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
        } = options;
        let folder = out
            .map(|out| OutputFolder::begin(&out, Leftover::Remove, Replaceable::All))
            .transpose()?;
        let episode = episode.map(EpisodeSink::begin).transpose()?;
        let workcell = workcell.unwrap_or_else(|| loaded.run_config().workcell);
        let performer = robot.map(|robot| (robot, &workcell));
        let live = episode.as_ref().filter(|_| is_live);
        let page = match live {
            Some(episode) => {
                let place = (episode.memory_folder(), episode.id());
                PageSink::begin_live(loaded, &program, performer, place)?
            }
            None => PageSink::begin(loaded, &program, performer)?,
        };
        let bags = bags.or_else(|| {
            let bag = folder.as_ref()?.place(&bag_name(1));
            bag.parent().map(PathBuf::from)
        });
        let urdf = robot.map(|robot| robot.files.urdf.as_str());
        let bags = bags.map(|place| BagSink::new(place, urdf, &loaded.task).after(taken_over));
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
            is_ending: false,
        })
    }

    /// Adds a sink of one's own.
    pub fn add(&mut self, sink: Box<dyn RunSink + Send>) {
        self.more.add(sink);
    }

    /// What is odd about what is shown, a sentence each.
    pub fn remarks(&self) -> &[String] {
        self.page.remarks()
    }

    /// The episode in the making.
    pub fn episode_mut(&mut self) -> Option<&mut EpisodeSink> {
        self.episode.as_mut()
    }

    /// How long the stages of the rounds took.
    pub fn stages_mut(&mut self) -> &mut StageSink {
        &mut self.stages
    }

    /// Whether a sink failed without which the run cannot go on, or cannot be gone on with later.
    pub const fn has_failed(&self) -> bool {
        self.failure.is_some() || self.no_bag.is_some()
    }

    /// Passes an event on to every sink. `Break` asks the session to end in order, because a sink failed whose failure means
    /// that: pass it on to the session.
    ///
    /// Where an episode is kept the run goes on without bags that cannot be written, as it does not depend on the results.
    pub fn on_event(&mut self, event: &RunEvent<'_>) -> ControlFlow<()> {
        // It takes the time and does nothing that fails.
        let _ = self.stages.on_event(event);
        if let Err(error) = self.page.on_event(event) {
            self.fail(internal(format!("a recording cannot be written: {error}")));
        }
        let more = self.more.on_event(event);
        for error in self.more.take_failures() {
            match error.after {
                AfterFailure::EndInOrder => self.fail(RecordError::Sink(error)),
                AfterFailure::GoOn => {}
            }
        }
        if let Some(episode) = &mut self.episode {
            let _ = episode.on_event(event);
        }
        let bag = self.bags.as_mut().map(|bags| bags.take_in(event));
        if let Some(Err(error)) = bag {
            self.give_up_bags(error.into());
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

    /// Writes no more bags, because of this: with an episode the run goes on all the same, without one it ends in order.
    pub fn give_up_bags(&mut self, error: RecordError) {
        self.bags = None;
        if self.episode.is_some() {
            self.no_bag.get_or_insert(error);
        } else {
            self.fail(error);
        }
    }

    /// Ends the bag that is being written; no event follows.
    pub fn end_bags(&mut self) {
        let ended = self.bags.as_mut().map_or(Ok(()), BagSink::end);
        if let Err(error) = ended {
            self.no_bag.get_or_insert(error.into());
        }
    }

    /// Why the run ended in order before its end, where that was a sink.
    pub fn take_failure(&mut self) -> Option<RecordError> {
        self.failure.take()
    }

    /// Ends the recording with what came of the run, and puts the episode into the memory; writes no results.
    ///
    /// # Errors
    /// [`RecordError::Internal`], which no input should bring about.
    pub fn keep(
        mut self,
        loaded: &LoadedTask,
        robot: Option<&Robot>,
        mut results: RunResults,
        first_look: Option<Observation>,
    ) -> Result<KeptRun, RecordError> {
        self.end_bags();
        results.recording = self.page.end(loaded, &results)?;
        let packed = packed(&results.recording)?;
        let files = robot.map(|robot| &robot.files);
        let program = &self.program;
        let episode = (self.episode)
            .map(|episode| {
                let rounds = &results.rounds;
                episode.commit(rounds, first_look, loaded, files, Some(&packed), program)
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
        })
    }

    /// The same, with the results: to be called once the session has come to its end or failed.
    ///
    /// # Parameters
    /// - `truths`: what a simulated world knows of the rounds, in their order; empty for a real one.
    ///
    /// # Errors
    /// [`RecordError::Nothing`] if no round was planned, or what the system says.
    pub fn finish(
        mut self,
        loaded: &LoadedTask,
        robot: Option<&Robot>,
        session: Session<'_>,
        executed_by: ExecutedBy,
        truths: Vec<KnownTruth>,
    ) -> Result<KeptRun, RecordError> {
        let mut results = RunResults::of(&session, &mut self.stages)?;
        let first_look = session.first_observation().cloned();
        results.add_rounds(session.into_rounds(), &mut self.stages, executed_by, truths);
        self.finish_with(loaded, robot, results, first_look)
    }

    /// The same of results that are there.
    ///
    /// # Errors
    /// What the system says.
    pub fn finish_with(
        mut self,
        loaded: &LoadedTask,
        robot: Option<&Robot>,
        results: RunResults,
        first_look: Option<Observation>,
    ) -> Result<KeptRun, RecordError> {
        let folder = self.folder.take();
        let kept = self.keep(loaded, robot, results, first_look)?;
        if let Some(folder) = folder {
            write_results(&folder, loaded, &kept.results)?;
            folder.finish()?;
        }
        Ok(kept)
    }
}
