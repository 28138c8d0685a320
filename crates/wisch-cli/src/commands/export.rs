//! `wisch memory export`: writes episodes in the format of openEASE and KnowRob.

use super::PROGRAM;
use super::memory::{memory_failure, open};
use super::words::format_count;
use crate::args::{ExportArgs, GlobalArgs, suggest};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::terminal::{Outcome, print, print_json};
use std::collections::BTreeSet;
use wisch_io::NewFolder;
use wisch_memory::ask::Assertions;
use wisch_memory::neem::{NeemConfig, NeemError, NeemMeta, NeemReport, NeemWriter, PoseSource};
use wisch_memory::{Episode, EpisodeRecord, Memory, Ontology};
use wisch_record::unix_time;

/// Writes the named episodes, or all, as one NEEM.
pub fn export(args: &ExportArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let progress = Progress::start(global);
    let memory = open(&args.memory)?;
    let (episodes, left_out) = match args.ids.as_slice() {
        [] => find_sound_episodes(&memory)?,
        ids => {
            let named = ids
                .iter()
                .map(|id| memory.episode(id).map_err(memory_failure));
            (named.collect::<Result<_, _>>()?, Vec::new())
        }
    };
    let notes = Assertions::read(memory.folder()).map_err(Failure::new)?;
    let meta = About::of(&episodes)?.meta(episodes.len())?;
    let config = NeemConfig {
        tf_rate_hz: args.tf_rate_hz,
    };
    if args.neem.exists() {
        let path = args.neem.clone();
        return Err(export_failure(NeemError::Exists { path }));
    }
    let failed = |error| Failure::from(error).with_help("choose another folder with --neem DIR");
    let folder = NewFolder::begin(&args.neem).map_err(failed)?;
    let mut neem = NeemWriter::create(&folder.path(), &meta, &config).map_err(export_failure)?;
    for (number, episode) in (1..).zip(&episodes) {
        progress.say(format!("episode {number} of {}", episodes.len()));
        write(&mut neem, episode)?;
    }
    let report = neem.finish().map_err(export_failure)?;
    folder.finish().map_err(failed)?;
    drop(progress);
    tell(args, global, &report, (&left_out, notes.count()))?;
    Ok(if left_out.is_empty() {
        Outcome::Done
    } else {
        Outcome::GoalNotMet
    })
}

/// Returns all episodes without faults, and the faults of the remaining ones.
fn find_sound_episodes(memory: &Memory) -> Result<(Vec<Episode>, Vec<String>), Failure> {
    let (mut sound, mut left_out) = (Vec::new(), Vec::new());
    for id in memory.episodes().map_err(memory_failure)? {
        match memory.episode(&id) {
            Ok(episode) => match episode.faults().first() {
                None => sound.push(episode),
                Some(fault) => left_out.push(fault.to_string()),
            },
            Err(error) => left_out.push(error.to_string()),
        }
    }
    if let (true, Some(first)) = (sound.is_empty(), left_out.first()) {
        return Err(Failure::new(format!("no episode can be exported: {first}"))
            .with_help(format!("{} lists damaged files", suggest("memory verify"))));
    }
    Ok((sound, left_out))
}

fn write(neem: &mut NeemWriter, episode: &Episode) -> Result<(), Failure> {
    let files = episode.files().map_err(memory_failure)?;
    // An episode of an imported log has no robot.
    let written = if files.iter().any(|file| file == "robot.urdf") {
        let robot = episode.robot().map_err(memory_failure)?;
        neem.write_stored_episode(episode, PoseSource::Robot(&robot))
    } else {
        neem.write_stored_episode(episode, PoseSource::Tool)
    };
    written.map_err(export_failure)
}

/// The tasks, tools, media, surfaces and robots of all episodes.
#[derive(Debug, Default)]
struct About {
    tasks: BTreeSet<String>,
    tools: BTreeSet<String>,
    media: BTreeSet<String>,
    surfaces: BTreeSet<String>,
    robots: BTreeSet<String>,
}

impl About {
    fn of(episodes: &[Episode]) -> Result<Self, Failure> {
        let mut about = Self::default();
        for episode in episodes {
            about.add(&episode.record().map_err(memory_failure)?);
        }
        Ok(about)
    }

    fn add(&mut self, record: &EpisodeRecord) {
        self.tasks.insert(record.task.clone());
        for (property, to) in [
            ("semco:usesTool", &mut self.tools),
            ("semco:removesMedium", &mut self.media),
            ("semco:actsOnSurface", &mut self.surfaces),
            ("soma:isPerformedBy", &mut self.robots),
        ] {
            let related = record.individuals.iter().filter_map(|individual| {
                let objects = individual.relations.get(property)?;
                Some(objects.iter().filter_map(|name| name.split_once(':')))
            });
            to.extend(related.flatten().map(|(_, local)| local.to_owned()));
        }
    }

    fn meta(&self, count: usize) -> Result<NeemMeta, Failure> {
        let words = |names: &BTreeSet<String>| {
            let names: Vec<String> = names.iter().map(|name| name.replace('_', " ")).collect();
            names.join(", ")
        };
        let mut keywords = vec!["wiping".to_owned()];
        for names in [&self.tools, &self.media, &self.surfaces, &self.robots] {
            keywords.extend(names.iter().map(|name| name.replace('_', " ")));
        }
        let wiping = Ontology::load().expand("semco:Wiping");
        Ok(NeemMeta {
            name: "Robotic wiping".to_owned(),
            description: format!(
                "{} of robotic wiping: {}",
                format_count(count, "episode"),
                words(&self.tasks)
            ),
            created_by: PROGRAM.to_owned(),
            created_at: unix_time(),
            keywords,
            url: String::new(),
            activity: ["Wiping".to_owned(), wiping.map_err(Failure::new)?],
            environment: words(&self.surfaces),
            agent: words(&self.robots),
            image: String::new(),
        })
    }
}

fn tell(
    args: &ExportArgs,
    global: &GlobalArgs,
    report: &NeemReport,
    (left_out, notes): (&[String], usize),
) -> Result<(), Failure> {
    if args.json {
        print_json(&serde_json::json!({
            "neem": args.neem,
            "episodes": report.episodes,
            "triples": report.triples,
            "annotations": report.annotations,
            "poses": report.poses,
            "wrenches": report.wrenches,
            "unusable_wrenches": report.unusable_wrenches,
            "observations": report.observations,
            "left_out": left_out,
            "notes_left_out": notes,
        }))?;
    } else if !global.quiet {
        let mut text = format!(
            "{}: {}, {} triples, {} poses, {} wrenches, {} observations\n",
            args.neem.display(),
            format_count(report.episodes as usize, "episode"),
            report.triples,
            report.poses,
            report.wrenches,
            report.observations
        );
        if report.unusable_wrenches > 0 {
            let count = format_count(report.unusable_wrenches as usize, "sample");
            text += &format!("left out: the wrench of {count}, which its driver calls unusable\n");
        }
        if notes > 0 {
            let count = format_count(notes, "statement");
            text += &format!("left out: {count} that people have added by tell\n");
        }
        for why in left_out {
            text += &format!("left out: {why}\n");
        }
        print(&text)?;
    }
    Ok(())
}

fn export_failure(error: NeemError) -> Failure {
    let help = match error {
        NeemError::Exists { .. } => "choose a new folder with --neem DIR".to_owned(),
        NeemError::Rate { .. } => {
            "choose a positive rate with --tf-rate-hz; the default is 10".to_owned()
        }
        NeemError::Io { .. } => {
            "free space on that disk, or choose another folder with --neem DIR".to_owned()
        }
        _ => format!("{} lists damaged files", suggest("memory verify")),
    };
    Failure::new(error).with_help(help)
}
