//! Tasks over all patches of a divided mesh: a command wipes one patch after another.

use super::prepare::{load, stage_failure};
use super::words::{format_count, internal, percent};
use crate::args::TaskArgs;
use crate::failure::Failure;
use crate::terminal::remark;
use serde::Serialize;
use std::path::Path;
use std::sync::Arc;
use wisch::geometry::{Atlas, Sheet};
use wisch::represent::{Action, SurfaceShape};
use wisch_io::{KeptFiles, LoadedTask, ParticleSource, REPORT_FILE, Summary};
use wisch_report::{PatchFound, PatchRow, PatchesPageInput, patches_page};

/// The schema of the object.
const SCHEMA: u32 = 1;
/// The note on passes at seams, which are not added up.
const SEAMS: &str = "passes are counted for each patch alone: strokes of neighbouring patches overlap at seams, so that points there have more passes than stated, and max_passes is not checked over patches";

/// The patches of a task.
pub(super) struct TaskPatches {
    /// Arguments of the task of each patch, in the order of execution.
    pub tasks: Vec<TaskArgs>,
    /// The task of the first patch, with the name of the task over all.
    pub first: LoadedTask,
    /// The divided mesh.
    pub atlas: Arc<Atlas>,
}

impl TaskPatches {
    /// Reads the task, and shares its particles among the patches by their areas.
    pub fn read(args: &TaskArgs) -> Result<Self, Failure> {
        let first = load(
            &with_settings(args, &[("surface.mesh.patch", "1".to_owned())]),
            &KeptFiles::default(),
        )?;
        let SurfaceShape::Mesh(mesh) = &first.task.surface.shape else {
            return Err(internal("a patch is not of a mesh"));
        };
        let patch = (mesh.patch()).ok_or_else(|| internal("the surface is no patch"))?;
        let (atlas, areas) = (
            Arc::clone(&patch.atlas),
            patch.areas().collect::<Vec<f64>>(),
        );
        if first.task.action == Action::Dispense && areas.len() > 1 {
            let problem = "surface.mesh.patch = \"all\" does not work with the action dispense: strokes of neighbouring patches overlap at seams, and their coats add up there, which no plan of a patch takes into account";
            return Err(stage_failure(args, problem)
                .with_help("coat one patch: surface.mesh.patch = 1, and mask its neighbours"));
        }
        let (ParticleSource::Uniform { count } | ParticleSource::Surface { count }) =
            first.file.particles
        else {
            let problem = "surface.mesh.patch = \"all\" needs particles.source = \"uniform\" or \"surface\", because other sources state places in the chart of one patch";
            return Err(stage_failure(args, problem)
                .with_help("wipe the patches one by one: surface.mesh.patch = 1"));
        };
        let name = first.task.name.clone();
        let tasks = divide_particles(count, &areas)
            .into_iter()
            .zip(1..)
            .map(|(count, number)| {
                with_settings(
                    args,
                    &[
                        ("surface.mesh.patch", number.to_string()),
                        ("particles.count", count.to_string()),
                        ("name", toml_string(&format!("{name}-patch-{number}"))),
                    ],
                )
            });
        let tasks = tasks.collect();
        Ok(Self {
            tasks,
            first,
            atlas,
        })
    }
}

/// Shares particles by areas: at least one for each.
fn divide_particles(count: usize, areas: &[f64]) -> Vec<usize> {
    let total: f64 = areas.iter().sum();
    let (mut sum, mut given) = (0.0, 0);
    let shares = areas.iter().map(|area| {
        sum += area;
        let until = (count as f64 * sum / total).round() as usize;
        let own = until.saturating_sub(given);
        given = until;
        own.max(1)
    });
    shares.collect()
}

fn with_settings(args: &TaskArgs, settings: &[(&str, String)]) -> TaskArgs {
    let mut args = args.clone();
    let added = settings
        .iter()
        .map(|(key, value)| ((*key).to_owned(), value.clone()));
    args.settings.extend(added);
    args
}

/// Writes a text as a TOML string.
fn toml_string(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}

/// The results of a command over all patches. Shares are in [0, 1], lengths in metres.
#[derive(Serialize)]
pub(super) struct PatchesSummary {
    format: &'static str,
    schema: u32,
    task: String,
    /// Particles of all patches.
    particles: usize,
    /// Predicted share of the particles that reach the goal; null without a prediction.
    predicted_performance: Option<f64>,
    /// Estimated share after the last round of each patch; null without an execution.
    estimated: Option<f64>,
    /// Means of the ends of the patches' 90 % intervals: wide enough if all patches err in the same direction.
    estimated_low: Option<f64>,
    estimated_high: Option<f64>,
    /// True share; null without simulated dirt.
    final_true: Option<f64>,
    /// Whether the goal is met on every patch.
    goal_met: bool,
    strokes: usize,
    distance_in_contact_m: f64,
    distance_total_m: f64,
    /// Number of patches of the surface.
    patch_count: usize,
    /// What the numbers of a treatment leave out at seams; null for other actions, and for a single patch.
    seam_note: Option<&'static str>,
    /// Whether every log allows an estimate; false if the performance on a patch is unknown.
    is_conclusive: bool,
    /// The summary of each patch that was wiped.
    patches: Vec<Summary>,
    out: String,
}

impl PatchesSummary {
    /// Sums up the patches that were wiped. `count`: number of patches; `is_met`: whether the goal is met on all.
    pub fn new(task: &str, patches: Vec<Summary>, count: usize, is_met: bool, out: String) -> Self {
        let particles: usize = patches.iter().map(|patch| patch.particles).sum();
        let mean = |of: &dyn Fn(&Summary) -> Option<f64>| -> Option<f64> {
            let weighted = (patches.iter()).map(|patch| Some(of(patch)? * patch.particles as f64));
            let sum: Option<f64> = weighted.sum();
            Some(sum? / particles.max(1) as f64)
        };
        let last = |of: fn(&wisch_io::RoundSummary) -> Option<f64>| {
            mean(&|patch| of(patch.execution.as_ref()?.rounds.last()?))
        };
        Self {
            format: "wisch-patches",
            schema: SCHEMA,
            task: task.to_owned(),
            particles,
            predicted_performance: mean(&|patch| {
                Some(patch.prediction.as_ref()?.predicted_performance)
            }),
            estimated: last(|round| Some(round.estimated)),
            estimated_low: last(|round| Some(round.estimated_low)),
            estimated_high: last(|round| Some(round.estimated_high)),
            final_true: last(|round| round.true_performance),
            goal_met: is_met,
            strokes: patches.iter().map(|patch| patch.strokes).sum(),
            distance_in_contact_m: patches
                .iter()
                .map(|patch| patch.distance_in_contact_m)
                .sum(),
            distance_total_m: patches.iter().map(|patch| patch.distance_total_m).sum(),
            patch_count: count,
            seam_note: (count > 1 && patches.iter().any(|patch| patch.treatment.is_some()))
                .then_some(SEAMS),
            is_conclusive: (patches.iter()).all(|patch| {
                (patch.execution.as_ref()).is_none_or(|execution| execution.is_conclusive)
            }),
            patches,
            out,
        }
    }

    /// The summary for people.
    pub fn in_words(&self) -> String {
        let count = self.patch_count;
        let mut text = match self.patches.len() {
            wiped if wiped == count => format!("{}: all {count} patches\n", self.task),
            wiped => format!("{}: {wiped} of {count} patches\n", self.task),
        };
        for (name, value) in self.facts() {
            text += &format!("  {name:<18} {value}\n");
        }
        text += &format!("  {:<18} {}\n", "results", self.out);
        text
    }

    /// The page over all patches, which links to those of the patches.
    pub fn page(&self, atlas: &Atlas) -> String {
        let found = |index: usize| {
            let patch = self.patches.get(index)?;
            Some(PatchFound {
                goal: (patch.prediction).map_or("", |found| found.goal).to_owned(),
                performance: performance_of(patch),
                strokes: patch.strokes,
                distance: patch.distance_in_contact_m,
                report: (Path::new(&patch.out).join(REPORT_FILE).exists())
                    .then(|| format!("patch-{}/{REPORT_FILE}", index + 1)),
            })
        };
        let rows: Vec<PatchRow> = (atlas.charts().iter().map(Sheet::area).enumerate())
            .map(|(index, area)| PatchRow {
                area,
                found: found(index),
            })
            .collect();
        patches_page(&PatchesPageInput {
            title: &self.task,
            facts: &self.facts(),
            outlines: &atlas.overview(),
            patches: &rows,
        })
    }

    /// Returns the results on all patches together: name and value.
    fn facts(&self) -> Vec<(String, String)> {
        let mut facts = Vec::new();
        let mut add = |name: &str, value: String| facts.push((name.to_owned(), value));
        if self.predicted_performance.is_some() {
            let is_met = |patch: &&Summary| patch.prediction.is_some_and(|found| found.goal_met);
            let met = self.patches.iter().filter(is_met).count();
            let patches = format_count(self.patch_count, "patch").replace("patchs", "patches");
            add("goal", format!("met on {met} of {patches}"));
        }
        let is_treatment = (self.patches.iter()).any(|patch| patch.treatment.is_some());
        let noun = if is_treatment { "points" } else { "particles" };
        let particles = format!("{} {noun}", self.particles);
        let estimated = [self.estimated, self.estimated_low, self.estimated_high];
        if let [Some(estimated), Some(low), Some(high)] = estimated.map(|share| share.map(percent))
        {
            let how = if self.is_conclusive {
                "estimated"
            } else {
                "unknown; guessed"
            };
            add(
                "performance",
                format!("{how} {estimated} of {particles} ({low} to {high})"),
            );
        } else if let Some(predicted) = self.predicted_performance {
            let predicted = percent(predicted);
            add(
                "performance",
                format!("predicted {predicted} of {particles}"),
            );
        }
        if let Some(truth) = self.final_true {
            add("true", percent(truth));
        }
        add("strokes", self.strokes.to_string());
        let (contact, total) = (self.distance_in_contact_m, self.distance_total_m);
        add(
            "distance",
            format!("{contact:.2} m in contact, {total:.2} m total"),
        );
        if let Some(note) = self.seam_note {
            add("seams", note.to_owned());
        }
        facts
    }
}

/// Names the results of an earlier command in the folder, which do not belong to those of the first patches.
pub(super) fn remark_earlier_patches(out: &Path, wiped: usize) {
    let entries = std::fs::read_dir(out).into_iter().flatten().flatten();
    let mut earlier: Vec<usize> = entries
        .filter_map(|entry| {
            let number = entry.file_name().to_str()?.strip_prefix("patch-")?.parse();
            number.ok().filter(|number| *number > wiped)
        })
        .collect();
    earlier.sort_unstable();
    if !earlier.is_empty() {
        let names = earlier.iter().map(|number| format!("patch-{number}"));
        let names = names.collect::<Vec<_>>().join(", ");
        remark(&format!(
            "{} holds results of an earlier command too: {names}",
            out.display()
        ));
    }
}

/// The performance that a command found, in words.
pub(super) fn performance_of(patch: &Summary) -> String {
    let last = (patch.execution.as_ref()).and_then(|execution| {
        let round = execution.rounds.last()?;
        let [estimated, low, high] =
            [round.estimated, round.estimated_low, round.estimated_high].map(percent);
        Some(if execution.is_conclusive {
            format!("estimated {estimated} ({low} to {high})")
        } else {
            format!("unknown; guessed {estimated} ({low} to {high})")
        })
    });
    last.unwrap_or_else(|| match patch.prediction {
        Some(found) => format!("predicted {}", percent(found.predicted_performance)),
        None => "not predicted".to_owned(),
    })
}

#[cfg(test)]
mod tests {
    use super::divide_particles;

    #[test]
    fn particles_are_shared_by_area() {
        assert_eq!(divide_particles(100, &[0.2, 0.2, 0.1]), [40, 40, 20]);
        assert_eq!(
            divide_particles(10, &[1.0, 1.0, 1.0]).iter().sum::<usize>(),
            10
        );
        assert_eq!(divide_particles(2, &[1.0, 1e-9, 1.0]), [1, 1, 1]);
    }
}
