//! The episodes of a memory with which a run is compared.

use super::bands::{BandError, ConformalBands};
use super::gauge::{Gauge, Touch};
use super::profile::{EpisodeProfile, PhaseWindow, ProfileBuilder};
use crate::catalogue::{Catalogue, CatalogueNode, EpisodeRow, IndividualId, entries};
use crate::frames::scene_of;
use crate::record::Origin;
use crate::remember::{WARNING_CLASS, class_of, shared_name};
use crate::store::{Memory, MemoryError};
use crate::telemetry::{PHASES, Telemetry, TelemetryError};
use std::collections::{BTreeMap, HashSet};
use std::thread;
use wisch::geometry::{Point3, Vector3};
use wisch::represent::Task;
use wisch::run::AlikeEpisode;

/// Largest number of episodes with which a run is compared, unless its rate of false warnings needs more.
const MOST_EPISODES: usize = 200;
/// Number of the newest comparable episodes of which those with a warning are left out, so that a fault that lasts is warned of
/// again. Older ones count, because without the runs that deviate most the rate of false warnings would grow from run to run.
const NEW_WARNING_RUNS: usize = 10;
/// Number of episodes that are read at once.
const BATCH: usize = 16;

/// Events that exclude an episode: after them, it does not show a run without a fault.
const DISTURBED: [&str; 4] = [
    "semco:HumanCollision",
    "semco:HandGuiding",
    "semco:Overload",
    "semco:ProtectiveStop",
];

/// Relations of a round to robot, tool, surface and dirt.
const THINGS: [&str; 4] = [
    "soma:isPerformedBy",
    "semco:usesTool",
    "semco:actsOnSurface",
    "semco:removesMedium",
];

/// The properties of a run that an episode must share to be comparable with it.
#[derive(Debug, Clone)]
pub struct ComparableRun {
    /// The task, with tool, dirt, surface, press force and action.
    pub task: Task,
    /// Name of the robot.
    pub robot: String,
    /// Executor of the run: the simulated world, or a program by its name.
    pub origin: Origin,
}

/// The comparable episodes of a memory, by the strategy of their first plan.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct WarningBasis {
    episodes: Vec<(String, EpisodeProfile)>,
    /// Number of further episodes that are comparable by their records, but whose telemetry is missing or damaged.
    pub unreadable: usize,
}

impl WarningBasis {
    /// Computes the bands of a run whose first plan has a strategy, from the episodes with the same strategy.
    ///
    /// `rate`: largest probability of a warning in a run without a change \[1\].
    ///
    /// # Errors
    /// If the rate is not between 0 and 1, or there are too few episodes for it.
    pub fn fit_bands(&self, strategy: &str, rate: f64) -> Result<ConformalBands, BandError> {
        let same = self.episodes.iter().filter(|(other, _)| other == strategy);
        let profiles: Vec<EpisodeProfile> = same.map(|(_, profile)| profile.clone()).collect();
        ConformalBands::fit(&profiles, rate)
    }
}

/// Reads the newest comparable episodes of a memory.
///
/// `rate`: largest probability of a warning in a run without a change \[1\].
///
/// # Errors
/// If the memory cannot be listed. An episode that cannot be read is left out and counted.
pub fn find_basis(
    memory: &Memory,
    run: &ComparableRun,
    rate: f64,
) -> Result<WarningBasis, MemoryError> {
    let catalogue = memory.catalogue()?;
    let candidates = find_candidates(&catalogue, run);
    let most = MOST_EPISODES.max(ConformalBands::least_episodes(rate));
    let mut basis = WarningBasis::default();
    for batch in candidates.chunks(BATCH) {
        for profile in read_batch(memory, &catalogue, batch, run) {
            match profile {
                Ok(Some(episode)) if basis.episodes.len() < most => basis.episodes.push(episode),
                Ok(_) => {}
                Err(_) => basis.unreadable += 1,
            }
        }
        if basis.episodes.len() == most {
            break;
        }
    }
    Ok(basis)
}

/// Returns the episodes that are comparable by the catalogue, the newest one first.
fn find_candidates<'a>(catalogue: &'a Catalogue, run: &ComparableRun) -> Vec<&'a EpisodeRow> {
    let task = &run.task;
    let names = [
        &run.robot,
        &task.tool.name,
        &task.surface.name,
        &task.medium,
    ];
    let shared = catalogue.shared_individuals();
    let wanted = names.map(|name| {
        let name = shared_name(name);
        shared.iter().position(|other| *other == name)
    });
    let [Some(robot), Some(tool), Some(surface), Some(medium)] = wanted else {
        return Vec::new();
    };
    let wanted = [robot, tool, surface, medium].map(|place| CatalogueNode::Shared(place as u32));
    let asked = Some(task.interaction.contact_force()).filter(|force| *force > 0.0);
    let is_comparable = |round: IndividualId| {
        let force = entries(catalogue.numbers("semco:pressForce"), round).first();
        let ending = entries(catalogue.texts("semco:ending"), round).first();
        force.map(|(_, force)| *force) == asked
            && ending.is_some_and(|(_, ending)| ending == "complete")
            && THINGS.iter().zip(&wanted).all(|(relation, thing)| {
                let objects = entries(catalogue.relations(relation), round);
                objects.first().is_some_and(|(_, node)| node == thing)
            })
    };
    // By the first individual of the episode.
    let mut episodes: BTreeMap<IndividualId, bool> = BTreeMap::new();
    for &(round, _) in catalogue.numbers("semco:round") {
        let first = catalogue.episode_of(round).first;
        *episodes.entry(first).or_insert(true) &= is_comparable(round);
    }
    for class in DISTURBED {
        for &event in catalogue.individuals_of_class(class) {
            episodes.insert(catalogue.episode_of(event).first, false);
        }
    }
    let action = class_of(task.action);
    let same_action: HashSet<IndividualId> = (catalogue.individuals_of_class(action).iter())
        .map(|&id| catalogue.episode_of(id).first)
        .collect();
    let comparable = (episodes.into_iter())
        .filter(|(first, is_comparable)| *is_comparable && same_action.contains(first));
    let mut rows: Vec<&EpisodeRow> = comparable
        .map(|(first, _)| catalogue.episode_of(first))
        .collect();
    rows.sort_by(|a, b| {
        let newest = b.interval[1].total_cmp(&a.interval[1]);
        newest.then_with(|| a.id.cmp(&b.id))
    });
    let warned: HashSet<IndividualId> = (catalogue.individuals_of_class(WARNING_CLASS).iter())
        .map(|&id| catalogue.episode_of(id).first)
        .collect();
    let mut place = 0;
    rows.retain(|row| {
        place += 1;
        place > NEW_WARNING_RUNS || !warned.contains(&row.first)
    });
    rows
}

/// An episode with the strategy of its first plan; `None` for one that is not comparable after all.
type ReadEpisode = Result<Option<(String, EpisodeProfile)>, MemoryError>;

/// Reads some episodes at once; `None` for one with another executor, or without a window.
fn read_batch(
    memory: &Memory,
    catalogue: &Catalogue,
    rows: &[&EpisodeRow],
    run: &ComparableRun,
) -> Vec<ReadEpisode> {
    let threads = thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let share = rows.len().div_ceil(threads).max(1);
    thread::scope(|scope| {
        let parts = rows.chunks(share);
        let running: Vec<_> = parts
            .map(|part| {
                let read = |row: &&EpisodeRow| read_profile(memory, catalogue, row, run);
                scope.spawn(move || part.iter().map(read).collect::<Vec<_>>())
            })
            .collect();
        let done = running.into_iter().flat_map(|thread| match thread.join() {
            Ok(profiles) => profiles,
            Err(panic) => std::panic::resume_unwind(panic),
        });
        done.collect()
    })
}

fn read_profile(
    memory: &Memory,
    catalogue: &Catalogue,
    row: &EpisodeRow,
    run: &ComparableRun,
) -> ReadEpisode {
    let episode = memory.episode(&row.id)?;
    if episode.record()?.origin != run.origin {
        return Ok(None);
    }
    let mut windows = Vec::new();
    for round in 1..=row.rounds.len() {
        read_windows(&episode.telemetry(round)?, &run.task, &mut windows)?;
    }
    let strategies = catalogue.texts("semco:strategy");
    let strategy = (row.first..row.first + row.len)
        .find_map(|id| entries(strategies, id).first())
        .map(|(_, strategy)| strategy.clone());
    let is_usable = !windows.is_empty();
    let profile = EpisodeProfile {
        episode: describe_outcome(catalogue, row),
        windows,
    };
    Ok(strategy
        .filter(|_| is_usable)
        .map(|strategy| (strategy, profile)))
}

/// Returns name, last verdict and final performance of an episode.
fn describe_outcome(catalogue: &Catalogue, row: &EpisodeRow) -> AlikeEpisode {
    let ids = row.first..row.first + row.len;
    let verdicts = catalogue.texts("semco:verdict");
    let verdict = (ids.clone().rev())
        .find_map(|id| entries(verdicts, id).first())
        .map(|(_, verdict)| verdict.clone());
    let performances = catalogue.numbers("semco:performance");
    let is_action = |id: &IndividualId| catalogue.class(*id) == "semco:WipingAction";
    let performance = (ids.into_iter().find(is_action))
        .and_then(|action| entries(performances, action).first())
        .map(|(_, share)| *share);
    AlikeEpisode {
        id: row.id.clone(),
        verdict,
        performance,
    }
}

/// Adds the windows of a round.
fn read_windows(
    telemetry: &Telemetry,
    task: &Task,
    windows: &mut Vec<PhaseWindow>,
) -> Result<(), MemoryError> {
    let foreign = |what: &str| TelemetryError::Foreign {
        path: telemetry.path().to_path_buf(),
        what: what.to_owned(),
    };
    let scene = scene_of(telemetry).map_err(|error| foreign(&error.to_string()))?;
    let scene = scene.ok_or_else(|| foreign("the scene is missing"))?;
    let gauge = Gauge::new(task, scene.world_from_surface.into());
    let rows = 0..telemetry.rows();
    let column = |name: &str| telemetry.values(name, rows.clone());
    let point = |what: &str| -> Result<[Vec<f64>; 3], TelemetryError> {
        Ok([
            column(&format!("{what}x"))?,
            column(&format!("{what}y"))?,
            column(&format!("{what}z"))?,
        ])
    };
    let (times, strokes, phases) = (column("time")?, column("stroke")?, column("phase")?);
    let [tool, commanded, force] = [
        point("measured/")?,
        point("commanded/")?,
        point("external/f")?,
    ];
    let qualities = telemetry.wrench_qualities(rows.clone())?;
    let is_paused = match telemetry.columns().contains(&"paused") {
        true => column("paused")?,
        false => vec![0.0; rows.len()],
    };
    let wipe = PHASES.iter().position(|phase| *phase == "wipe");
    let is_stroke = |row: usize| Some(phases[row] as usize) == wipe && strokes[row] >= 0.0;
    let at = |columns: &[Vec<f64>; 3], row: usize| [0, 1, 2].map(|axis: usize| columns[axis][row]);
    let mut builder = ProfileBuilder::default();
    let mut row = 0;
    while row < rows.len() {
        if !is_stroke(row) {
            builder.leave_stroke();
            row += 1;
            continue;
        }
        let end = (row..rows.len())
            .find(|&next| !is_stroke(next) || strokes[next] != strokes[row])
            .unwrap_or(rows.len());
        let stroke = (strokes[row] as usize, times[end - 1] - times[row]);
        for row in row..end {
            if !qualities[row].is_usable() || is_paused[row] != 0.0 {
                continue;
            }
            let sample = gauge.measure(&Touch {
                tool: Point3::from(at(&tool, row)),
                commanded: Point3::from(at(&commanded, row)),
                force: Vector3::from(at(&force, row)),
            });
            windows.extend(builder.push(stroke, times[row], &sample));
        }
        row = end;
    }
    Ok(())
}
