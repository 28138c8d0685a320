//! Tools, media, surfaces and interactions that a task file defines, in addition to the knowledge base or overriding it.

use super::deserialize::At;
use super::mobility::{self, MediumMotion};
use super::tables::{InteractionTable, MediumKindName, MediumTable, TaskTable, ToolTable};
use super::values::Name;
use super::{Intent, TaskError, TaskFile};
use crate::knowledge::is_entry_name;
use wisch::geometry::Vector3;
use wisch::represent::{
    AngleRange, GrainSize, Interaction, KnowledgeBase, KnowledgeError, MediumEntry, SurfaceEntry,
    SurfaceScope, ToolEntry, ToolMesh,
};
use wisch::source_location::Place;

/// Default compression depth of a tool [m]: a tenth of a sponge's height.
const COMPRESSION_DEPTH: f64 = 0.005;
/// Height of a pad that the file defines by its footprint [m].
const PAD_HEIGHT: f64 = 0.05;
/// Default grain diameters [m]: crumbs.
const GRAIN_SIZE: GrainSize = GrainSize {
    min_m: 0.0005,
    max_m: 0.002,
};

/// The entries that a task file defines.
#[derive(Debug, Clone)]
pub(super) struct Definitions {
    tool: Option<ToolEntry>,
    /// Whether the height of the tool is assumed.
    has_assumed_height: bool,
    medium: Option<MediumEntry>,
    /// How the medium moves by its own weight.
    pub(super) motion: Option<MediumMotion>,
    surface: Option<SurfaceEntry>,
    interaction: Option<Overrides>,
}

/// Overrides of the knowledge base's interaction.
#[derive(Debug, Clone)]
struct Overrides {
    at: Place,
    /// Names of the tool and the medium, which the file must state.
    pair: (String, String),
    given: InteractionTable,
}

pub(super) fn read(file: &At<TaskTable>) -> Result<Definitions, TaskError> {
    let task = &file.value;
    let surface = match task.surface.value.friction {
        Some(friction) => Some(SurfaceEntry {
            name: new_name(&task.surface.value.name)?,
            friction: friction.0,
        }),
        None => None,
    };
    let tool_table = task.tool.as_ref().map(|table| &table.value);
    Ok(Definitions {
        has_assumed_height: tool_table
            .is_some_and(|tool| tool.footprint_m.is_some() && tool.height_m.is_none()),
        tool: match &task.tool {
            Some(table) => tool(table)?,
            None => None,
        },
        medium: match &task.medium {
            Some(table) => medium(table)?,
            None => None,
        },
        motion: match &task.medium {
            Some(table) => mobility::read(table)?,
            None => None,
        },
        surface,
        interaction: match &task.interaction {
            Some(table) => Some(overrides(table, task)?),
            None => None,
        },
    })
}

fn new_name(name: &At<Name>) -> Result<String, TaskError> {
    let text = &name.value.0;
    if is_entry_name(text) {
        Ok(text.clone())
    } else {
        Err(name.inconsistent(format!(
                "{text:?} is not a valid new name: expected a small letter, then small letters, digits, _ and -"
            ),
        ))
    }
}

fn tool(table: &At<ToolTable>) -> Result<Option<ToolEntry>, TaskError> {
    let given = &table.value;
    if let Some(height) = &given.height_m
        && given.footprint_m.is_none()
    {
        return Err(height.inconsistent("this key needs footprint_m, which defines a pad"));
    }
    let mesh = match (&given.footprint_m, &given.mesh) {
        (None, None) => {
            return match &given.compression_depth_m {
                Some(depth) => Err(depth.inconsistent("this key needs footprint_m or mesh, which define a tool of this task; for a tool of the knowledge base, set interaction.compression_depth_m",
                )),
                None => Ok(None),
            };
        }
        (Some(_), Some(mesh)) => {
            return Err(mesh.inconsistent("footprint_m and mesh exclude each other"));
        }
        (Some(footprint), None) => {
            let [depth, width] = footprint.value.map(|side| side.0);
            let height = given.height_m.as_ref();
            let height = height.map_or(PAD_HEIGHT, |height| height.value.0);
            ToolMesh::Cuboid(Vector3::new(depth, width, height))
        }
        (None, Some(file)) => ToolMesh::BesideTask(file.value.0.clone()),
    };
    let name = (given.name.as_ref()).ok_or_else(|| table.missing("name"))?;
    let depth = given.compression_depth_m.as_ref();
    // A thin cloth is pressed in by less.
    let usual = match &mesh {
        ToolMesh::Cuboid(size) => COMPRESSION_DEPTH.min(size.z / 2.0),
        ToolMesh::InKnowledge(_) | ToolMesh::BesideTask(_) => COMPRESSION_DEPTH,
    };
    Ok(Some(ToolEntry {
        name: new_name(name)?,
        mesh,
        compression_depth_m: depth.map_or(usual, |depth| depth.value.0),
        area_of_effect: None,
        rotation_about_normal: AngleRange::FULL,
        tilt: None,
        grasp: "as stated in the task file".to_owned(),
        grip: None,
        second_grip: None,
    }))
}

fn medium(table: &At<MediumTable>) -> Result<Option<MediumEntry>, TaskError> {
    let given = &table.value;
    let sizes = given.grain_size_m.as_ref();
    let Some(kind) = &given.kind else {
        return match sizes {
            Some(sizes) => {
                Err(sizes.inconsistent("this key needs kind, which defines a medium of this task"))
            }
            None => Ok(None),
        };
    };
    let name = (given.name.as_ref()).ok_or_else(|| table.missing("name"))?;
    let grain_size = match (kind.value, sizes) {
        (MediumKindName::Liquid, Some(sizes)) => {
            return Err(sizes.inconsistent("a liquid has no grains"));
        }
        (MediumKindName::Liquid, None) => None,
        (_, None) => Some(GRAIN_SIZE),
        (_, Some(sizes)) => {
            let [min_m, max_m] = sizes.value.map(|size| size.0);
            if min_m > max_m {
                return Err(
                    sizes.inconsistent(format!("the minimum {min_m} exceeds the maximum {max_m}"))
                );
            }
            Some(GrainSize { min_m, max_m })
        }
    };
    Ok(Some(MediumEntry {
        name: new_name(name)?,
        kind: kind.value.into(),
        grain_size,
        friction: None,
        liquid: None,
    }))
}

fn overrides(table: &At<InteractionTable>, task: &TaskTable) -> Result<Overrides, TaskError> {
    let tool = task.tool.as_ref().and_then(|tool| tool.value.name.as_ref());
    let medium = task.medium.as_ref();
    let medium = medium.and_then(|medium| medium.value.name.as_ref());
    let (Some(tool), Some(medium)) = (tool, medium) else {
        return Err(table.inconsistent("this table needs tool.name and medium.name"));
    };
    if let Some(actions) = &table.value.actions
        && actions.value.is_empty()
    {
        return Err(actions.inconsistent("at least one action is needed"));
    }
    Ok(Overrides {
        at: table.place.clone(),
        pair: (tool.value.0.clone(), medium.value.0.clone()),
        given: table.value.clone(),
    })
}

impl TaskFile {
    /// Adds the file's own tool, medium, surface and interaction to the knowledge base.
    /// Returns a sentence for each assumed value.
    ///
    /// # Errors
    /// If neither the file nor the knowledge base has the interaction's tool, medium or surface.
    pub fn extend(&self, knowledge: &mut KnowledgeBase) -> Result<Vec<String>, TaskError> {
        let defined = &self.definitions;
        defined.insert_entries(knowledge);
        self.set_medium_motion(knowledge)?;
        let mut assumed: Vec<String> = (defined.tool.iter())
            .filter(|_| defined.has_assumed_height)
            .map(|tool| {
                let name = &tool.name;
                format!("tool {name:?} is taken to be {PAD_HEIGHT} m high: set tool.height_m")
            })
            .collect();
        let bare;
        let overrides = match (&defined.interaction, &self.intent) {
            (Some(overrides), _) => overrides,
            (None, Intent::Action { tool, medium, .. }) if defined.has_tool_or_medium() => {
                bare = Overrides {
                    at: self.tool_at.clone(),
                    pair: (tool.clone(), medium.clone()),
                    given: InteractionTable::default(),
                };
                &bare
            }
            _ => return Ok(assumed),
        };
        let (tool, medium) = &overrides.pair;
        let surface = &self.surface.surface.name;
        let unknown = |error: KnowledgeError| self.unknown(error, &overrides.at);
        let (mut interaction, is_assumed) = match knowledge.interaction(tool, medium, surface) {
            Ok(known) => (known.clone(), false),
            Err(KnowledgeError::NoInteraction { .. }) => {
                let tool = knowledge.tool(tool).map_err(unknown)?;
                (assume_interaction(tool, medium, surface), true)
            }
            Err(error) => return Err(unknown(error)),
        };
        // An entry for all surfaces stays unchanged for other surfaces.
        interaction.surface = SurfaceScope::Named(surface.to_owned());
        let remark = (!is_assumed)
            .then(|| {
                overrides
                    .given
                    .press(&mut interaction, defined.tool.is_some())
            })
            .flatten();
        assumed.extend(remark);
        if let Some(tool) = &defined.tool {
            interaction.compression_depth_m = tool.compression_depth_m;
        }
        let kept = overrides.given.apply(&mut interaction);
        knowledge.insert_interaction(interaction).map_err(unknown)?;
        if is_assumed && !kept.is_empty() {
            assumed.push(format!(
                "the knowledge base has no interaction of {tool} on {medium} on {surface}: assuming {} (set them in [interaction])",
                kept.join(", ")
            ));
        }
        Ok(assumed)
    }
}

/// Returns the default interaction of a tool and medium that the knowledge base does not have together.
fn assume_interaction(tool: &ToolEntry, medium: &str, surface: &str) -> Interaction {
    Interaction {
        surface: SurfaceScope::Named(surface.to_owned()),
        compression_depth_m: tool.compression_depth_m,
        ..Interaction::assume(&tool.name, medium)
    }
}

impl Definitions {
    /// Adds the tool, medium and surface to the knowledge base.
    fn insert_entries(&self, knowledge: &mut KnowledgeBase) {
        if let Some(tool) = &self.tool {
            knowledge.insert_tool(tool.clone());
        }
        if let Some(medium) = &self.medium {
            knowledge.insert_medium(medium.clone());
        }
        if let Some(surface) = &self.surface {
            knowledge.insert_surface(surface.clone());
        }
    }

    fn has_tool_or_medium(&self) -> bool {
        self.tool.is_some() || self.medium.is_some()
    }
}

impl InteractionTable {
    /// Sets the given press force in an interaction that is known for another force, and returns a
    /// sentence on the assumed likelihood and compression; `None` if the file states these, or no
    /// other force.
    ///
    /// `has_tool`: whether the file defines the tool, with its compression.
    fn press(&self, known: &mut Interaction, has_tool: bool) -> Option<String> {
        let force = self.press_force_n.as_ref()?.0;
        let before = known.press_force_n;
        let hovers = (self.gap_m.as_ref()).map_or(known.hovers(), |gap| gap.0 > 0.0);
        if force == before || hovers {
            return None;
        }
        known.press_with(force);
        let law = self.mu.is_none().then(|| {
            format!(
                "interaction.mu = {:.3}, so that {:.1} % of the particles react when the tool first touches them",
                known.likelihood.mu,
                100.0 * known.reaction_probability()
            )
        });
        let depth = known.compression_depth_m;
        let is_kept = has_tool || self.compression_depth_m.is_some() || depth == 0.0;
        let depth = (!is_kept).then(|| format!("interaction.compression_depth_m = {depth:.4}"));
        let assumed: Vec<String> = law.into_iter().chain(depth).collect();
        (!assumed.is_empty()).then(|| {
            format!(
                "interaction.press_force_n is {force} N, and the knowledge base has {before} N: assuming that particles need the same force, and that the tool is as stiff up to twice its compression: {}",
                assumed.join("; ")
            )
        })
    }

    /// Sets the given values in an interaction, and returns `key = value` of each force, stiffness, damping, weight, depth
    /// and likelihood parameter that is not given.
    fn apply(&self, to: &mut Interaction) -> Vec<String> {
        if let Some(actions) = &self.actions {
            to.actions = actions.value.iter().map(|&action| action.into()).collect();
        }
        let redraw = &mut to.redraw;
        redraw.length_m = self.redraw_length_m.map(|x| x.0).or(redraw.length_m);
        for (given, value) in [
            (
                self.ln_redraw_length_spread.map(|x| x.0),
                &mut redraw.ln_length_spread,
            ),
            (self.kept_share.map(|x| x.0), &mut redraw.kept_share),
            (self.gap_m.map(|x| x.0), &mut to.gap_m),
        ] {
            *value = given.unwrap_or(*value);
        }
        let mut kept = Vec::new();
        let mut set = |key: &str, value: &mut f64, given: Option<f64>| match given {
            Some(given) => *value = given,
            None => kept.push(format!("{key} = {value}")),
        };
        set(
            "press_force_n",
            &mut to.press_force_n,
            self.press_force_n.map(|x| x.0),
        );
        set(
            "stiffness_n_per_m",
            &mut to.stiffness_n_per_m,
            self.stiffness_n_per_m.map(|x| x.0),
        );
        set(
            "damping_ratio",
            &mut to.damping_ratio,
            self.damping_ratio.map(|x| x.0),
        );
        set(
            "nullspace_posture_weight",
            &mut to.nullspace_posture_weight,
            self.nullspace_posture_weight.map(|x| x.0),
        );
        set(
            "compression_depth_m",
            &mut to.compression_depth_m,
            self.compression_depth_m.map(|x| x.0),
        );
        set("mu", &mut to.likelihood.mu, self.mu.map(|x| x.0));
        set("sigma", &mut to.likelihood.sigma, self.sigma.map(|x| x.0));
        set(
            "mu_spread",
            &mut to.likelihood_spread.mu,
            self.mu_spread.map(|x| x.0),
        );
        set(
            "ln_sigma_spread",
            &mut to.likelihood_spread.ln_sigma,
            self.ln_sigma_spread.map(|x| x.0),
        );
        kept
    }
}
