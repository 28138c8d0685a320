//! A run as it is shown: for its report and its episode, and while it goes on for others.

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
use wisch_io::{LoadedTask, Robot};
use wisch_memory::live_place;
use wisch_report::{PlannedOnly, RecordingHead, RecordingWriter, RoundTruth, RunOutcome};

/// Writes the recording of a run, of which the page is made: into memory, and where it is asked for into a file that others
/// read while the run goes on.
#[derive(Debug)]
pub struct PageSink {
    writer: RecordingWriter<Outputs>,
    remarks: Vec<String>,
}

/// What is kept, and what others read meanwhile.
#[derive(Debug)]
struct Outputs {
    kept: Vec<u8>,
    live: Option<Live>,
}

/// A file that grows while the run goes on.
#[derive(Debug)]
struct Live {
    file: File,
    lines: PathBuf,
    /// Who writes it.
    card: PathBuf,
}

impl Write for Outputs {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.kept.extend_from_slice(bytes);
        // A reader never stops a run.
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
            // The next reader finds no such process.
            let _ = fs::remove_file(path);
        }
    }
}

impl PageSink {
    /// Begins a recording.
    ///
    /// # Parameters
    /// - `program`: what writes it, such as "wisch 0.2.0".
    /// - `robot`: the robot and which part of it wipes from where; `None` for a run without one.
    ///
    /// # Errors
    /// [`RecordError::Internal`], which no input should bring about.
    pub fn begin(
        loaded: &LoadedTask,
        program: &str,
        robot: Option<(&Robot, &WorkcellConfig)>,
    ) -> Result<Self, RecordError> {
        Self::begin_with(loaded, program, robot, None)
    }

    /// Begins one that can be followed in a memory, under the name of the episode to be.
    ///
    /// # Errors
    /// A file that cannot be written there.
    pub fn begin_live(
        loaded: &LoadedTask,
        program: &str,
        robot: Option<(&Robot, &WorkcellConfig)>,
        (memory, id): (&Path, &str),
    ) -> Result<Self, RecordError> {
        let [lines, card] = ["jsonl", "json"].map(|ending| live_place(memory, id, ending));
        let folder = lines.parent().unwrap_or(memory);
        let begun = wisch_memory::date_and_time(crate::clock::now());
        let who = serde_json::json!({
            "pid": std::process::id(),
            "task": loaded.task.name,
            "begun": begun,
        });
        let file = fs::create_dir_all(folder).and_then(|()| {
            fs::write(&card, who.to_string())?;
            File::create(&lines)
        });
        let file = file.map_err(|error| RecordError::Live {
            place: lines.clone(),
            error,
        })?;
        Self::begin_with(loaded, program, robot, Some(Live { file, lines, card }))
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
            let performer = robot.performer();
            // Where there is none, the session says why.
            let (model, task) = (performer.robot.clone(), &loaded.task);
            Workcell::new(model, performer.srdf, task, config).ok()
        });
        let appearance = robot.and_then(|(robot, _)| appearance(robot, &mut remarks));
        let head = RecordingHead {
            title: &title(loaded),
            program,
            task: &loaded.task,
            strategy: loaded.config.strategy,
            target: loaded.file.target_performance(),
            cell: cell.as_ref(),
            appearance: appearance.as_ref(),
        };
        writer.begin(&head).map_err(internal)?;
        Ok(Self { writer, remarks })
    }

    /// What is odd about the looks of the robot, a sentence each.
    pub fn remarks(&self) -> &[String] {
        &self.remarks
    }

    /// Ends it with what came of the run: the recording as it is kept, JSON lines.
    ///
    /// # Errors
    /// [`RecordError::Internal`], which no input should bring about.
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
            self.writer.planned_only(&PlannedOnly {
                task: &results.task,
                plan: &results.wiped(),
                prediction,
                frames,
                followed: following.map(|f| (&f.cell, &f.followed, &f.audit)),
            })?;
        }
        for finished in &results.rounds {
            let Some(known) = &finished.truth else {
                continue;
            };
            if known.performance.is_none() && known.particles.is_none() {
                continue;
            }
            self.writer.truth(&RoundTruth {
                round: finished.round.motion.number,
                performance: known.performance,
                particles: known.particles.as_ref(),
                pushes: &known.pushes,
                world_from_surface: known.world_from_surface,
            })?;
        }
        // Readers are told where the episode lies as well, once it lies there.
        let live = self.writer.get_mut().live.take();
        self.write_end(loaded, results, None)?;
        let outputs = self.writer.get_mut();
        outputs.live = live;
        Ok(std::mem::take(&mut outputs.kept))
    }

    /// Tells those who read it meanwhile how it ended, and under which name the episode is kept.
    pub fn leave(mut self, loaded: &LoadedTask, results: &RunResults, episode: Option<&str>) {
        if self.writer.get_mut().live.is_some() {
            // Only what is kept can fail.
            let _ = self.write_end(loaded, results, episode);
        }
    }

    fn write_end(
        &mut self,
        loaded: &LoadedTask,
        results: &RunResults,
        episode: Option<&str>,
    ) -> io::Result<()> {
        let target = loaded.file.target_performance();
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
            },
            episode,
        )
    }
}

impl RunSink for PageSink {
    /// Takes in one event; that this fails is a fault of this library, which ends the run in order.
    fn on_event(&mut self, event: &RunEvent<'_>) -> Result<(), SinkError> {
        self.writer.see(event).map_err(SinkError::end_in_order)
    }
}

/// What a robot looks like. It is shown and nothing else: what cannot be read is a remark and no more.
fn appearance(robot: &Robot, remarks: &mut Vec<String>) -> Option<Appearance> {
    match robot.appearance() {
        Ok(looks) => {
            remarks.extend(looks.diagnostics().iter().map(ToString::to_string));
            Some(looks)
        }
        Err(error) => {
            remarks.push(format!(
                "the robot is shown by its collision geometry: {error}"
            ));
            None
        }
    }
}
