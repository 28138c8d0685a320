//! A run as it is shown: for its report and its episode, and while it goes on for who looks on.

use super::episode::PROGRAM;
use super::job::{Job, Results};
use super::prepare::Prepared;
use super::results::{facts_of, title};
use crate::failure::Failure;
use crate::terminal::remark;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use wisch::follow::Workcell;
use wisch::robot::Appearance;
use wisch::run::RunEvent;
use wisch_io::Robot;
use wisch_memory::live_place;
use wisch_report::{PlannedOnly, RecordingHead, RecordingWriter, RoundTruth, RunOutcome};

/// A recording that is being written.
pub struct RunRecording {
    writer: RecordingWriter<Sinks>,
}

/// What is kept, and what others read meanwhile.
struct Sinks {
    kept: Vec<u8>,
    live: Option<Live>,
}

/// A file that grows while the run goes on.
struct Live {
    file: File,
    lines: PathBuf,
    /// Who writes it.
    card: PathBuf,
}

impl Write for Sinks {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.kept.extend_from_slice(bytes);
        // Who looks on never stops a run.
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
            // The next who looks on finds no such process.
            let _ = fs::remove_file(path);
        }
    }
}

/// What a robot looks like. It is shown and nothing else, so that what cannot be read is told and no more.
fn appearance(robot: &Robot) -> Option<Appearance> {
    match robot.appearance() {
        Ok(looks) => {
            for told in looks.diagnostics() {
                remark(&told.to_string());
            }
            Some(looks)
        }
        Err(error) => {
            remark(&format!(
                "the robot is shown by its collision geometry: {error}"
            ));
            None
        }
    }
}

impl RunRecording {
    /// Begins one of a run that nobody looks at while it goes on.
    pub fn begin(job: &Job<'_>) -> Result<Self, Failure> {
        Self::begin_with(job, None)
    }

    /// Begins one that can be followed in a memory, under the name of the episode to be.
    pub fn begin_live(job: &Job<'_>, memory: &Path, id: &str) -> Result<Self, Failure> {
        let [lines, card] = ["jsonl", "json"].map(|ending| live_place(memory, id, ending));
        let folder = lines.parent().unwrap_or(memory);
        let begun = wisch_memory::date_and_time(super::episode::now());
        let who = serde_json::json!({
            "pid": std::process::id(),
            "task": job.prepared.task.name,
            "begun": begun,
        });
        let file = fs::create_dir_all(folder).and_then(|()| {
            fs::write(&card, who.to_string())?;
            File::create(&lines)
        });
        let file = file.map_err(|error| {
            Failure::new(format!("{}: cannot write there: {error}", lines.display())).with_help(
                "--memory DIR keeps the episode elsewhere, and without --live nobody can look on",
            )
        })?;
        Self::begin_with(job, Some(Live { file, lines, card }))
    }

    fn begin_with(job: &Job<'_>, live: Option<Live>) -> Result<Self, Failure> {
        let prepared = job.prepared;
        let kept = Vec::new();
        let mut writer = RecordingWriter::new(Sinks { kept, live });
        let cell = (job.robot.as_ref()).and_then(|(_, robot)| {
            let performer = robot.performer();
            let config = job.config(None).workcell;
            // Where there is none, the session says why.
            Workcell::new(
                performer.robot.clone(),
                performer.srdf,
                &prepared.task,
                &config,
            )
            .ok()
        });
        let appearance = (job.robot.as_ref()).and_then(|(_, robot)| appearance(robot));
        let head = RecordingHead {
            title: &title(prepared),
            program: PROGRAM,
            task: &prepared.task,
            strategy: prepared.config.strategy,
            target: prepared.file.target_performance(),
            cell: cell.as_ref(),
            appearance: appearance.as_ref(),
        };
        writer.begin(&head).map_err(no_recording)?;
        Ok(Self { writer })
    }

    /// Takes note of what happens.
    pub fn see(&mut self, event: &RunEvent<'_>) -> Result<(), Failure> {
        self.writer.see(event).map_err(no_recording)
    }

    /// Ends it with what came of the run; the recording as it is kept.
    pub fn end(&mut self, prepared: &Prepared, results: &Results) -> Result<Vec<u8>, Failure> {
        self.end_as(prepared, results).map_err(no_recording)
    }

    fn end_as(&mut self, prepared: &Prepared, results: &Results) -> io::Result<Vec<u8>> {
        if let (true, Some((prediction, frames))) = (results.rounds.is_empty(), &results.predicted)
        {
            let following = results.following.as_ref();
            let plan = following.map_or_else(|| results.plan.clone(), |f| f.plan(&results.plan));
            self.writer.planned_only(&PlannedOnly {
                task: &results.task,
                plan: &plan,
                prediction,
                frames,
                followed: following.map(|f| (&f.cell, &f.followed, &f.audit)),
            })?;
        }
        let believed = prepared.task.surface.world_from_surface;
        let world_from_surface = Some(believed * prepared.reality.believed_from_real);
        for done in &results.rounds {
            if done.true_performance.is_none() && done.truth.is_none() {
                continue;
            }
            self.writer.truth(&RoundTruth {
                round: done.round.motion.number,
                performance: done.true_performance,
                particles: done.truth.as_ref(),
                pushes: &done.pushes,
                world_from_surface,
            })?;
        }
        // Who looks on is told where the episode lies as well, once it lies there.
        let live = self.writer.get_mut().live.take();
        self.write_end(prepared, results, None)?;
        let sinks = self.writer.get_mut();
        sinks.live = live;
        Ok(std::mem::take(&mut sinks.kept))
    }

    /// Tells who looks on how it ended, and under which name the episode is kept.
    pub fn leave(mut self, prepared: &Prepared, results: &Results, episode: Option<&str>) {
        if self.writer.get_mut().live.is_some() {
            // Only what is kept can fail.
            let _ = self.write_end(prepared, results, episode);
        }
    }

    fn write_end(
        &mut self,
        prepared: &Prepared,
        results: &Results,
        episode: Option<&str>,
    ) -> io::Result<()> {
        let target = prepared.file.target_performance();
        let predicted = (results.predicted.as_ref()).map_or(0.0, |(p, _)| p.performance.ratio());
        let last = results.rounds.last();
        self.writer.end(
            &RunOutcome {
                task: &prepared.task,
                target,
                is_met: results.is_goal_met(target),
                predicted,
                last: last.map(|done| (&done.round, results.rounds.len())),
                truth: last.and_then(|done| done.true_performance),
                facts: &facts_of(prepared, results),
            },
            episode,
        )
    }
}

fn no_recording(error: io::Error) -> Failure {
    super::words::internal(format!("a recording cannot be written: {error}"))
}
