//! Tool, medium, surface and interaction that a task file itself defines, beside or over the knowledge base's.

use super::deserialize::At;
use super::tables::{InteractionTable, MediumKindName, MediumTable, TaskTable, ToolTable};
use super::tree::Source;
use super::values::Name;
use super::{TaskError, TaskFile};
use crate::knowledge::is_entry_name;
use std::collections::BTreeSet;
use wisch::geometry::Vector3;
use wisch::represent::{
    Action, AngleRange, GrainSize, Interaction, KnowledgeBase, KnowledgeError, LogNormal,
    LogNormalSpread, MediumEntry, Redraw, SurfaceEntry, SurfaceScope, ToolEntry, ToolMesh,
};
use wisch::source_location::Place;

/// How deep a tool gives way that says nothing of it [m]: a tenth of a sponge's height.
const COMPRESSION_DEPTH: f64 = 0.005;
/// Height of a pad that is only given by its footprint [m].
const PAD_HEIGHT: f64 = 0.05;
/// Grains that say nothing of their size [m]: crumbs.
const GRAIN_SIZE: GrainSize = GrainSize {
    min_m: 0.0005,
    max_m: 0.002,
};
/// A sponge's force on crumbs [N].
const PRESS_FORCE: f64 = 10.0;
/// Yields to a hand, holds against friction [N/m].
const STIFFNESS: f64 = 500.0;
/// Settles without much overshoot.
const DAMPING_RATIO: f64 = 0.7;
/// The posture gives way to the tool.
const POSTURE_WEIGHT: f64 = 0.2;
/// A sponge on crumbs: half of them are taken along at a third of the nominal pressure.
const LIKELIHOOD: LogNormal = LogNormal {
    mu: -1.05,
    sigma: 0.25,
};

/// What a task file defines itself.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Definitions {
    tool: Option<ToolEntry>,
    medium: Option<MediumEntry>,
    surface: Option<SurfaceEntry>,
    interaction: Option<Overrides>,
}

/// The values of an interaction that a task file gives.
#[derive(Debug, Clone, PartialEq)]
struct Overrides {
    at: Place,
    /// Names of the tool and medium, which the file must say.
    pair: (String, String),
    actions: Option<BTreeSet<Action>>,
    press_force_n: Option<f64>,
    stiffness_n_per_m: Option<f64>,
    damping_ratio: Option<f64>,
    nullspace_posture_weight: Option<f64>,
    compression_depth_m: Option<f64>,
    gap_m: Option<f64>,
    mu: Option<f64>,
    sigma: Option<f64>,
    mu_spread: Option<f64>,
    ln_sigma_spread: Option<f64>,
    redraw_length_m: Option<f64>,
    ln_redraw_length_spread: Option<f64>,
    kept_share: Option<f64>,
}

pub(super) fn read(file: &At<TaskTable>, source: &Source<'_>) -> Result<Definitions, TaskError> {
    let task = &file.value;
    let surface = match task.surface.value.friction {
        Some(friction) => Some(SurfaceEntry {
            name: new_name(&task.surface.value.name, source)?,
            friction: friction.0,
        }),
        None => None,
    };
    Ok(Definitions {
        tool: match &task.tool {
            Some(table) => tool(table, source)?,
            None => None,
        },
        medium: match &task.medium {
            Some(table) => medium(table, source)?,
            None => None,
        },
        surface,
        interaction: match &task.interaction {
            Some(table) => Some(overrides(table, task, source)?),
            None => None,
        },
    })
}

fn new_name(name: &At<Name>, source: &Source<'_>) -> Result<String, TaskError> {
    let text = &name.value.0;
    if is_entry_name(text) {
        Ok(text.clone())
    } else {
        Err(name.inconsistent(
            source,
            format!(
                "{text:?} is no name of something new: it starts with a small letter and goes on with small letters, digits, _ and -"
            ),
        ))
    }
}

fn tool(table: &At<ToolTable>, source: &Source<'_>) -> Result<Option<ToolEntry>, TaskError> {
    let given = &table.value;
    let mesh = match (&given.footprint_m, &given.mesh) {
        (None, None) => {
            return match &given.compression_depth_m {
                Some(depth) => Err(depth.inconsistent(
                    source,
                    "it belongs to a tool of this task, with footprint_m or mesh; to change it of a known tool, set interaction.compression_depth_m",
                )),
                None => Ok(None),
            };
        }
        (Some(_), Some(mesh)) => {
            return Err(mesh.inconsistent(source, "footprint_m and mesh exclude each other"));
        }
        (Some(footprint), None) => {
            let [depth, width] = footprint.value.map(|side| side.0);
            ToolMesh::Cuboid(Vector3::new(depth, width, PAD_HEIGHT))
        }
        (None, Some(file)) => ToolMesh::BesideTask(file.value.0.clone()),
    };
    let name = (given.name.as_ref()).ok_or_else(|| table.missing(source, "name"))?;
    let depth = given.compression_depth_m.as_ref();
    Ok(Some(ToolEntry {
        name: new_name(name, source)?,
        mesh,
        compression_depth_m: depth.map_or(COMPRESSION_DEPTH, |depth| depth.value.0),
        area_of_effect: None,
        rotation_about_normal: AngleRange::FULL,
        tilt: None,
        grasp: "as the task file has it".to_owned(),
        grip: None,
        second_grip: None,
    }))
}

fn medium(table: &At<MediumTable>, source: &Source<'_>) -> Result<Option<MediumEntry>, TaskError> {
    let given = &table.value;
    let sizes = given.grain_size_m.as_ref();
    let Some(kind) = &given.kind else {
        return match sizes {
            Some(sizes) => Err(sizes.inconsistent(
                source,
                "it belongs to a medium of this task, which says its kind",
            )),
            None => Ok(None),
        };
    };
    let name = (given.name.as_ref()).ok_or_else(|| table.missing(source, "name"))?;
    let grain_size = match (kind.value, sizes) {
        (MediumKindName::Liquid, Some(sizes)) => {
            return Err(sizes.inconsistent(source, "a liquid has no grains"));
        }
        (MediumKindName::Liquid, None) => None,
        (_, None) => Some(GRAIN_SIZE),
        (_, Some(sizes)) => {
            let [min_m, max_m] = sizes.value.map(|size| size.0);
            if min_m > max_m {
                return Err(sizes.inconsistent(
                    source,
                    format!("{min_m} comes before {max_m} but is larger"),
                ));
            }
            Some(GrainSize { min_m, max_m })
        }
    };
    Ok(Some(MediumEntry {
        name: new_name(name, source)?,
        kind: kind.value.into(),
        grain_size,
    }))
}

fn overrides(
    table: &At<InteractionTable>,
    task: &TaskTable,
    source: &Source<'_>,
) -> Result<Overrides, TaskError> {
    let tool = task.tool.as_ref().and_then(|tool| tool.value.name.as_ref());
    let medium = task.medium.as_ref();
    let medium = medium.and_then(|medium| medium.value.name.as_ref());
    let (Some(tool), Some(medium)) = (tool, medium) else {
        return Err(table.inconsistent(
            source,
            "it says how a tool is used on a medium, and needs tool.name and medium.name",
        ));
    };
    let given = &table.value;
    let actions = match &given.actions {
        Some(actions) if actions.value.is_empty() => {
            return Err(actions.inconsistent(source, "at least one action is needed"));
        }
        Some(actions) => Some(
            actions
                .value
                .iter()
                .map(|action| (*action).into())
                .collect(),
        ),
        None => None,
    };
    Ok(Overrides {
        at: table.place(source),
        pair: (tool.value.0.clone(), medium.value.0.clone()),
        actions,
        press_force_n: given.press_force_n.map(|force| force.0),
        stiffness_n_per_m: given.stiffness_n_per_m.map(|stiffness| stiffness.0),
        damping_ratio: given.damping_ratio.map(|ratio| ratio.0),
        nullspace_posture_weight: given.nullspace_posture_weight.map(|weight| weight.0),
        compression_depth_m: given.compression_depth_m.map(|depth| depth.0),
        gap_m: given.gap_m.map(|gap| gap.0),
        mu: given.mu.map(|mu| mu.0),
        sigma: given.sigma.map(|sigma| sigma.0),
        mu_spread: given.mu_spread.map(|spread| spread.0),
        ln_sigma_spread: given.ln_sigma_spread.map(|spread| spread.0),
        redraw_length_m: given.redraw_length_m.map(|length| length.0),
        ln_redraw_length_spread: given.ln_redraw_length_spread.map(|spread| spread.0),
        kept_share: given.kept_share.map(|share| share.0),
    })
}

impl TaskFile {
    /// Adds to the knowledge what the file itself defines: a tool, a medium, a surface, and how they are used together.
    /// Returns a sentence for each assumption that had to be made.
    ///
    /// # Errors
    /// An interaction of a tool, medium or surface that neither the file nor the knowledge has.
    pub fn extend(&self, knowledge: &mut KnowledgeBase) -> Result<Vec<String>, TaskError> {
        let Definitions {
            tool,
            medium,
            surface,
            interaction,
        } = &self.definitions;
        let is_new = tool.is_some() || medium.is_some();
        tool.iter()
            .for_each(|tool| knowledge.insert_tool(tool.clone()));
        medium
            .iter()
            .for_each(|medium| knowledge.insert_medium(medium.clone()));
        surface
            .iter()
            .for_each(|surface| knowledge.insert_surface(surface.clone()));
        let surface = self.surface();
        let pair = match (interaction, self.intent()) {
            (Some(overrides), _) => overrides.pair.clone(),
            (None, super::Intent::Action { tool, medium, .. }) if is_new => {
                (tool.clone(), medium.clone())
            }
            _ => return Ok(Vec::new()),
        };
        let (tool, medium) = (&pair.0, &pair.1);
        let at = interaction
            .as_ref()
            .map_or(&self.tool_at, |overrides| &overrides.at);
        let unknown = |error: KnowledgeError| self.unknown(error, at);
        let known = match knowledge.interaction(tool, medium, surface) {
            Ok(known) => Some(known.clone()),
            Err(KnowledgeError::NoInteraction { .. }) => None,
            Err(error) => return Err(unknown(error)),
        };
        let is_assumed = known.is_none();
        let mut assumed = Vec::new();
        let mut interaction_now = match known {
            Some(known) => known,
            None => Interaction {
                tool: tool.clone(),
                medium: medium.clone(),
                surface: SurfaceScope::Named(surface.to_owned()),
                actions: Action::ALL.into_iter().collect(),
                press_force_n: PRESS_FORCE,
                stiffness_n_per_m: STIFFNESS,
                damping_ratio: DAMPING_RATIO,
                nullspace_posture_weight: POSTURE_WEIGHT,
                compression_depth_m: knowledge.tool(tool).map_err(unknown)?.compression_depth_m,
                gap_m: 0.0,
                likelihood: LIKELIHOOD,
                likelihood_spread: LogNormalSpread::default(),
                redraw: Redraw::default(),
            },
        };
        // A scope of all surfaces stays as it is for the others.
        interaction_now.surface = SurfaceScope::Named(surface.to_owned());
        let none = Overrides::none(at, &pair);
        let given = interaction.as_ref().unwrap_or(&none);
        if let Some(actions) = &given.actions {
            interaction_now.actions.clone_from(actions);
        }
        if let Some(length) = given.redraw_length_m {
            interaction_now.redraw.length_m = Some(length);
        }
        for (given, value) in [
            (
                given.ln_redraw_length_spread,
                &mut interaction_now.redraw.ln_length_spread,
            ),
            (given.kept_share, &mut interaction_now.redraw.kept_share),
            (given.gap_m, &mut interaction_now.gap_m),
        ] {
            *value = given.unwrap_or(*value);
        }
        for (key, given, value) in [
            (
                "press_force_n",
                given.press_force_n,
                &mut interaction_now.press_force_n,
            ),
            (
                "stiffness_n_per_m",
                given.stiffness_n_per_m,
                &mut interaction_now.stiffness_n_per_m,
            ),
            (
                "damping_ratio",
                given.damping_ratio,
                &mut interaction_now.damping_ratio,
            ),
            (
                "nullspace_posture_weight",
                given.nullspace_posture_weight,
                &mut interaction_now.nullspace_posture_weight,
            ),
            (
                "compression_depth_m",
                given.compression_depth_m,
                &mut interaction_now.compression_depth_m,
            ),
            ("mu", given.mu, &mut interaction_now.likelihood.mu),
            ("sigma", given.sigma, &mut interaction_now.likelihood.sigma),
            (
                "mu_spread",
                given.mu_spread,
                &mut interaction_now.likelihood_spread.mu,
            ),
            (
                "ln_sigma_spread",
                given.ln_sigma_spread,
                &mut interaction_now.likelihood_spread.ln_sigma,
            ),
        ] {
            match given {
                Some(given) => *value = given,
                None if is_assumed => assumed.push(format!("{key} = {value}")),
                None => {}
            }
        }
        knowledge
            .insert_interaction(interaction_now)
            .map_err(unknown)?;
        if assumed.is_empty() {
            return Ok(Vec::new());
        }
        Ok(vec![format!(
            "nothing is known of {tool} on {medium} on {surface}: assuming {} (set them in [interaction])",
            assumed.join(", ")
        )])
    }
}

impl Overrides {
    fn none(at: &Place, pair: &(String, String)) -> Self {
        Self {
            at: at.clone(),
            pair: pair.clone(),
            actions: None,
            press_force_n: None,
            stiffness_n_per_m: None,
            damping_ratio: None,
            nullspace_posture_weight: None,
            compression_depth_m: None,
            gap_m: None,
            mu: None,
            sigma: None,
            mu_spread: None,
            ln_sigma_spread: None,
            redraw_length_m: None,
            ln_redraw_length_spread: None,
            kept_share: None,
        }
    }
}
