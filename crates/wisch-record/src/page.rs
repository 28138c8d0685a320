//! The recording of a run for its report, its episode and the live page.

use crate::error::{RecordError, internal};
use crate::folder::{facts_of, title};
use crate::results::RunResults;
use crate::sink::{RunSink, SinkError};
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use wisch::follow::{Workcell, WorkcellConfig};
use wisch::robot::Appearance;
use wisch::run::RunEvent;
use wisch_io::{LoadedTask, Robot, Unfinished, UnfinishedPath, shell_word, shipped_scenarios};
use wisch_memory::live_path;
use wisch_report::{
    CommandOptions, EffectFrames, RecordingHead, RecordingWriter, RoundTruth, RunOutcome,
    UnexecutedPlan,
};

/// A sink that writes the recording for a run's page into memory, and optionally into a file that live pages read.
#[derive(Debug)]
pub struct PageSink {
    writer: RecordingWriter<Outputs>,
    remarks: Vec<String>,
    options: Option<CommandOptions>,
}

/// The output of a recording: a buffer, and the file of the live page.
#[derive(Debug)]
struct Outputs {
    kept: Vec<u8>,
    live: Option<Live>,
}

/// The file of the live page, which grows during the run.
#[derive(Debug)]
struct Live {
    file: File,
    lines: PathBuf,
    /// The card with the process that writes it.
    card: PathBuf,
    /// Dropped after the files are removed.
    _unfinished: Unfinished,
}

impl Write for Outputs {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.kept.extend_from_slice(bytes);
        // A failure of the live page never stops a run.
        if let Some(live) = &mut self.live
            && live.file.write_all(bytes).is_err()
        {
            self.live = None;
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Drop for Live {
    fn drop(&mut self) {
        for path in [&self.card, &self.lines] {
            // The next reader finds that the process has ended.
            let _ = fs::remove_file(path);
        }
    }
}

impl PageSink {
    /// Begins a recording that is kept in memory.
    ///
    /// # Parameters
    /// - `program`: name and version of the program that writes it, such as "wisch 0.2.0".
    /// - `robot`: the robot with its planning groups and pose; `None` for a run without a robot.
    ///
    /// # Errors
    /// [`RecordError::Internal`], which no input should cause.
    pub fn begin(
        loaded: &LoadedTask,
        program: &str,
        robot: Option<(&Robot, &WorkcellConfig)>,
    ) -> Result<Self, RecordError> {
        Self::begin_with(loaded, program, robot, None)
    }

    /// Begins a recording that live pages can read in a memory, under the name of the future episode.
    ///
    /// # Errors
    /// If the file of the live page cannot be written.
    pub fn begin_live(
        loaded: &LoadedTask,
        program: &str,
        robot: Option<(&Robot, &WorkcellConfig)>,
        (memory, id): (&Path, &str),
    ) -> Result<Self, RecordError> {
        let [lines, card] = ["jsonl", "json"].map(|ending| live_path(memory, id, ending));
        let folder = lines.parent().unwrap_or(memory);
        let begun = wisch_memory::date_and_time(crate::clock::unix_time());
        let who = serde_json::json!({
            "pid": std::process::id(),
            "task": loaded.task.name,
            "begun": begun,
        });
        let made = Unfinished::create(|| {
            fs::create_dir_all(folder)?;
            fs::write(&card, who.to_string())?;
            let paths = [&card, &lines].map(|path| UnfinishedPath::Whole(path.clone()));
            io::Result::Ok((File::create(&lines)?, paths.into()))
        });
        let (file, unfinished) = made.map_err(|error| RecordError::Live {
            place: lines.clone(),
            error,
        })?;
        let live = Live {
            file,
            lines,
            card,
            _unfinished: unfinished,
        };
        Self::begin_with(loaded, program, robot, Some(live))
    }

    fn begin_with(
        loaded: &LoadedTask,
        program: &str,
        robot: Option<(&Robot, &WorkcellConfig)>,
        live: Option<Live>,
    ) -> Result<Self, RecordError> {
        let kept = Vec::new();
        let mut writer = RecordingWriter::new(Outputs { kept, live });
        let mut remarks = Vec::new();
        let cell = robot.and_then(|(robot, config)| {
            let performer = robot.robot_setup();
            // If the workcell cannot be built, the session reports the error.
            let (model, task) = (performer.robot.clone(), &loaded.task);
            Workcell::new(model, performer.srdf, task, config).ok()
        });
        let appearance = robot.and_then(|(robot, _)| appearance(robot, &mut remarks));
        let head = RecordingHead {
            title: &title(loaded),
            program,
            task: &loaded.task,
            strategy: loaded.run.plan.strategy,
            target: loaded.run.target,
            cell: cell.as_ref(),
            appearance: appearance.as_ref(),
        };
        writer.begin(&head).map_err(internal)?;
        Ok(Self {
            writer,
            remarks,
            options: None,
        })
    }

    /// Sets the options of the run beside its task, with which the page suggests commands.
    #[must_use]
    pub fn with_options(self, options: Option<CommandOptions>) -> Self {
        Self { options, ..self }
    }

    /// Takes the predicted effect of the first round over time; `None` for a plan without strokes.
    pub fn take_first_frames(&mut self) -> Option<EffectFrames> {
        self.writer.take_first_frames()
    }

    /// Remarks about the robot's visual geometry, one sentence each.
    pub fn remarks(&self) -> &[String] {
        &self.remarks
    }

    /// Finishes the recording with the results of the run and returns it as JSON lines.
    ///
    /// # Errors
    /// [`RecordError::Internal`], which no input should cause.
    pub fn end(
        &mut self,
        loaded: &LoadedTask,
        results: &RunResults,
    ) -> Result<Vec<u8>, RecordError> {
        self.end_as(loaded, results).map_err(internal)
    }

    fn end_as(&mut self, loaded: &LoadedTask, results: &RunResults) -> io::Result<Vec<u8>> {
        if let (true, Some((prediction, frames))) = (results.rounds.is_empty(), &results.predicted)
        {
            let following = results.following.as_ref();
            self.writer.record_plan(&UnexecutedPlan {
                task: &results.task,
                plan: &results.executable_plan(),
                prediction,
                frames,
                followed: following.map(|f| (&*f.cell, &f.followed, &f.audit)),
            })?;
        }
        for finished in &results.rounds {
            let Some(known) = &finished.truth else {
                continue;
            };
            if known.performance.is_none() && known.particles.is_none() {
                continue;
            }
            self.writer.record_truth(&RoundTruth {
                round: finished.round.motion.number,
                performance: known.performance,
                particles: known.particles.as_ref(),
                pushes: &known.pushes,
                world_from_surface: known.world_from_surface,
                surface_shape: known.surface_shape.as_ref(),
            })?;
        }
        // Live pages get the episode's name later, once the episode is stored.
        let live = self.writer.get_mut().live.take();
        self.write_end(loaded, results, None)?;
        let outputs = self.writer.get_mut();
        outputs.live = live;
        Ok(std::mem::take(&mut outputs.kept))
    }

    /// Writes the outcome and the episode's name into the file of the live page.
    pub fn leave(mut self, loaded: &LoadedTask, results: &RunResults, episode: Option<&str>) {
        if self.writer.get_mut().live.is_some() {
            // Failures of the live page are ignored.
            let _ = self.write_end(loaded, results, episode);
        }
    }

    fn write_end(
        &mut self,
        loaded: &LoadedTask,
        results: &RunResults,
        episode: Option<&str>,
    ) -> io::Result<()> {
        let target = loaded.run.target;
        let predicted = (results.predicted.as_ref()).map_or(0.0, |(p, _)| p.performance.ratio());
        let last = results.rounds.last();
        self.writer.end(
            &RunOutcome {
                task: &loaded.task,
                target,
                is_met: results.is_goal_met(target),
                predicted,
                last: last.map(|last| (&last.round, results.rounds.len())),
                truth: last.and_then(|last| last.truth.as_ref()?.performance),
                facts: &facts_of(loaded, results),
                task_arguments: name_task(loaded).as_deref(),
                options: self.options.as_ref(),
                after_stop: loaded.run.after_stop,
            },
            episode,
        )
    }
}

/// Returns the arguments of a command that reads this task file with its settings and seed; `None` if there is no such file
/// or scenario.
fn name_task(loaded: &LoadedTask) -> Option<String> {
    let path = &loaded.path;
    let is_shipped = || shipped_scenarios().any(|(name, _)| Path::new(name) == path);
    if !path.is_file() && !is_shipped() {
        return None;
    }
    let mut words = vec![shell_word(&path.display().to_string())];
    for (key, value) in &loaded.settings {
        words.extend(["--set".to_owned(), shell_word(&format!("{key}={value}"))]);
    }
    words.extend(["--seed".to_owned(), loaded.task.seed.to_string()]);
    Some(words.join(" "))
}

impl RunSink for PageSink {
    /// Records one event. A failure is an error in this library and stops the run cleanly.
    fn on_event(&mut self, event: &RunEvent<'_>) -> Result<(), SinkError> {
        self.writer.record_event(event).map_err(SinkError::stop_run)
    }
}

/// Reads the robot's visual geometry. It is used for display only, so a failure is a remark.
fn appearance(robot: &Robot, remarks: &mut Vec<String>) -> Option<Appearance> {
    match robot.appearance() {
        Ok(looks) => {
            remarks.extend(looks.diagnostics().iter().map(ToString::to_string));
            Some(looks)
        }
        Err(error) => {
            remarks.push(format!(
                "the page shows the robot's collision geometry, because its visual geometry cannot be read: {error}"
            ));
            None
        }
    }
}
