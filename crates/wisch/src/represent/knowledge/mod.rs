//! What is known of tools, media and surfaces, and of what they do to each other (§4.3, Fig. 11, 13).
//!
//! Knowledge belongs to the objects: an entry per tool, medium and surface, and an [`Interaction`] per
//! combination that makes sense.

mod grip;
mod likelihood;

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::str::FromStr;

pub use crate::source_location::{Place, UnknownName};
pub use grip::{Grip, SecondGrip};
pub use likelihood::{LogNormal, LogNormalSpread, Redraw};

use crate::geometry::Vector3;

/// What a wiping motion is meant to achieve (§3.1).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Action {
    /// Take the medium up.
    Absorb,
    /// Push the medium together at one place of the surface.
    Collect,
    /// Push the medium over an edge of the surface.
    Skim,
    /// Go over every place of the surface so many times.
    Polish,
    /// Leave the medium on the surface, so thick everywhere.
    Emit,
}

impl Action {
    /// Every action: those of the paper in its order, then those that treat the surface itself.
    pub const ALL: [Self; 5] = [
        Self::Absorb,
        Self::Collect,
        Self::Skim,
        Self::Polish,
        Self::Emit,
    ];
    /// The actions that move dirt, in the order of the paper.
    pub const WIPING: [Self; 3] = [Self::Absorb, Self::Collect, Self::Skim];

    /// The action as files and goals write it.
    ///
    /// ```
    /// use wisch::represent::Action;
    /// assert_eq!(Action::Skim.as_str(), "skim");
    /// assert_eq!("collect".parse(), Ok(Action::Collect));
    /// assert_eq!("colect".parse::<Action>().unwrap_err().nearest(), Some("collect"));
    /// ```
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Absorb => "absorb",
            Self::Collect => "collect",
            Self::Skim => "skim",
            Self::Polish => "polish",
            Self::Emit => "emit",
        }
    }

    /// What the tool does to a particle that it touches.
    pub fn effect(self) -> Effect {
        match self {
            Self::Absorb => Effect::Absorb,
            Self::Collect | Self::Skim => Effect::Push,
            Self::Polish | Self::Emit => Effect::Treat,
        }
    }

    /// Whether it is the surface that is treated: particles are places of it, and strokes run in lanes.
    pub fn treats(self) -> bool {
        self.effect() == Effect::Treat
    }
}

impl fmt::Display for Action {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

impl FromStr for Action {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        Self::ALL
            .into_iter()
            .find(|action| action.as_str() == name)
            .ok_or_else(|| UnknownName::new("action", name, Self::ALL.map(Self::as_str)))
    }
}

/// What happens to a particle under the tool (§3.1).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Effect {
    /// The particle is deleted.
    Absorb,
    /// The particle is carried along with the tool.
    Push,
    /// The particle is a place of the surface: it stays, and counts how far the tool slides over it.
    Treat,
}

/// A range of angles with `min_rad <= max_rad`, both within ±π.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AngleRange {
    /// Smallest angle [rad].
    pub min_rad: f64,
    /// Largest angle [rad].
    pub max_rad: f64,
}

impl AngleRange {
    /// From −π to π: any angle is allowed.
    pub const FULL: Self = Self {
        min_rad: -std::f64::consts::PI,
        max_rad: std::f64::consts::PI,
    };
}

/// The part of the surface on which a tool acts, D_aoe (§3.2).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AreaOfEffect {
    /// Extent across the motion, the tool's broad side [m].
    pub width_m: f64,
    /// Extent along the motion [m].
    pub depth_m: f64,
}

/// An axis about which a tool may lean while it wipes, such as a window wiper's blade.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TiltFreedom {
    /// Direction of the axis, a unit vector in the tool frame.
    pub axis_in_tool: nalgebra::Unit<Vector3>,
    /// How far the tool may lean; 0 is upright.
    pub range: AngleRange,
}

/// Where the mesh of a tool comes from; its frame is the tool's.
#[derive(Debug, Clone, PartialEq)]
pub enum ToolMesh {
    /// A file, by its path relative to the knowledge files.
    InKnowledge(String),
    /// A file, by its path relative to the task file.
    BesideTask(String),
    /// A box that stands on the contact plane, by its sides along x, y and z [m].
    Cuboid(Vector3),
}

/// A tool that can be grasped.
#[derive(Debug, Clone, PartialEq)]
pub struct ToolEntry {
    /// Its name, also in PDDL.
    pub name: String,
    /// The mesh from which its footprint is cut.
    pub mesh: ToolMesh,
    /// How deep it gives way under nominal force, δ [m].
    pub compression_depth_m: f64,
    /// The rectangle about the TCP on which it acts, where that is not its footprint: a nozzle
    /// touches with its rim but sucks with all of its mouth.
    pub area_of_effect: Option<AreaOfEffect>,
    /// Free rotation about the surface normal, 0 being the broad side across the motion [rad].
    pub rotation_about_normal: AngleRange,
    /// The axis about which it may lean; `None` if it has to stay upright.
    pub tilt: Option<TiltFreedom>,
    /// How the hand holds it, for people to read.
    pub grasp: String,
    /// How the leading hand holds it; `None` for the rear edge of its upper face at the end of the hand.
    pub grip: Option<Grip>,
    /// Where a second hand may hold it.
    pub second_grip: Option<SecondGrip>,
}

/// Whether a medium comes in pieces, as powder or as a liquid.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum MediumKind {
    /// Pieces that stay what they are.
    Solid,
    /// Drops and films.
    Liquid,
    /// Grains too small to be told apart.
    Powder,
}

/// The sizes between which a medium's grains lie, `0 < min_m <= max_m`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GrainSize {
    /// Smallest diameter [m].
    pub min_m: f64,
    /// Largest diameter [m].
    pub max_m: f64,
}

/// Something that may lie on a surface.
#[derive(Debug, Clone, PartialEq)]
pub struct MediumEntry {
    /// Its name, also in PDDL.
    pub name: String,
    /// Its nature.
    pub kind: MediumKind,
    /// The sizes of its grains, where it has any.
    pub grain_size: Option<GrainSize>,
}

/// A surface that can be wiped.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfaceEntry {
    /// Its name, also in PDDL.
    pub name: String,
    /// Coulomb coefficient between the surface and a tool that slides on it [1].
    pub friction: f64,
}

/// For which surfaces an interaction is known.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub enum SurfaceScope {
    /// The surface of that name.
    Named(String),
    /// Every surface for which nothing closer is known.
    Any,
}

impl SurfaceScope {
    /// What stands in place of a surface's name for all of them.
    pub const ANY_NAME: &'static str = "any";
}

impl fmt::Display for SurfaceScope {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Named(name) => name,
            Self::Any => Self::ANY_NAME,
        })
    }
}

/// How a tool is used on a medium on a surface, and how well that works.
#[derive(Debug, Clone, PartialEq)]
pub struct Interaction {
    /// The tool.
    pub tool: String,
    /// The medium.
    pub medium: String,
    /// The surface or surfaces.
    pub surface: SurfaceScope,
    /// The actions that make sense, at least one.
    pub actions: BTreeSet<Action>,
    /// Force with which the tool is pressed on, the f_min of equation (9); the most that holds one that hovers in place [N].
    pub press_force_n: f64,
    /// Cartesian stiffness of the controller [N/m].
    pub stiffness_n_per_m: f64,
    /// Damping ratio of the controller [1].
    pub damping_ratio: f64,
    /// Weight of the posture task in the null space [1].
    pub nullspace_posture_weight: f64,
    /// How deep the tool gives way here: the tool's own δ unless the files say otherwise [m].
    pub compression_depth_m: f64,
    /// How high the tool hovers over the surface instead of being pressed on [m]; 0 touches.
    pub gap_m: f64,
    /// The chance of an effect over the normalised force.
    pub likelihood: LogNormal,
    /// How well that is known.
    pub likelihood_spread: LogNormalSpread,
    /// How a particle that stays draws its threshold again.
    pub redraw: Redraw,
}

impl Interaction {
    /// Whether the tool acts without touching: what it feels tells nothing.
    pub fn hovers(&self) -> bool {
        self.gap_m > 0.0
    }

    /// Force of the tool on the surface as asked for: none from one that hovers [N].
    pub fn contact_force(&self) -> f64 {
        if self.hovers() {
            0.0
        } else {
            self.press_force_n
        }
    }
}

/// A tool that can do what was asked, with its prospects.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RankedTool<'a> {
    /// The tool.
    pub tool: &'a ToolEntry,
    /// How to use it.
    pub interaction: &'a Interaction,
    /// The chance of an effect at nominal force, P(X ≤ 1).
    pub probability: f64,
}

/// Tools, media and surfaces with what they do to each other. Every name it holds resolves.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct KnowledgeBase {
    tools: BTreeMap<String, ToolEntry>,
    media: BTreeMap<String, MediumEntry>,
    surfaces: BTreeMap<String, SurfaceEntry>,
    /// Tool → medium → surface.
    interactions: BTreeMap<String, BTreeMap<String, BTreeMap<SurfaceScope, Interaction>>>,
}

impl KnowledgeBase {
    /// Adds a tool, in place of one of the same name.
    pub fn insert_tool(&mut self, tool: ToolEntry) {
        self.tools.insert(tool.name.clone(), tool);
    }

    /// Adds a medium, in place of one of the same name.
    pub fn insert_medium(&mut self, medium: MediumEntry) {
        self.media.insert(medium.name.clone(), medium);
    }

    /// Adds a surface, in place of one of the same name.
    pub fn insert_surface(&mut self, surface: SurfaceEntry) {
        self.surfaces.insert(surface.name.clone(), surface);
    }

    /// Adds what a tool does to a medium on a surface, in place of what was known of the same three.
    ///
    /// # Errors
    ///
    /// [`KnowledgeError::Unknown`] for a tool, medium or surface that was not added before.
    ///
    /// ```
    /// use wisch::represent::{KnowledgeBase, SurfaceEntry};
    /// let mut knowledge = KnowledgeBase::default();
    /// knowledge.insert_surface(SurfaceEntry { name: "table".to_owned(), friction: 0.4 });
    /// assert_eq!(knowledge.surface("table")?.friction, 0.4);
    /// let error = knowledge.surface("tabel").unwrap_err();
    /// assert_eq!(error.to_string(), r#"unknown surface "tabel"; nearest: table"#);
    /// # Ok::<(), wisch::represent::KnowledgeError>(())
    /// ```
    pub fn insert_interaction(&mut self, interaction: Interaction) -> Result<(), KnowledgeError> {
        self.tool(&interaction.tool)?;
        self.medium(&interaction.medium)?;
        if let SurfaceScope::Named(surface) = &interaction.surface {
            self.surface(surface)?;
        }
        self.interactions
            .entry(interaction.tool.clone())
            .or_default()
            .entry(interaction.medium.clone())
            .or_default()
            .insert(interaction.surface.clone(), interaction);
        Ok(())
    }

    /// The tool of that name.
    ///
    /// # Errors
    ///
    /// [`KnowledgeError::Unknown`], naming the nearest.
    pub fn tool(&self, name: &str) -> Result<&ToolEntry, KnowledgeError> {
        entry("tool", &self.tools, name)
    }

    /// The medium of that name.
    ///
    /// # Errors
    ///
    /// [`KnowledgeError::Unknown`], naming the nearest.
    pub fn medium(&self, name: &str) -> Result<&MediumEntry, KnowledgeError> {
        entry("medium", &self.media, name)
    }

    /// The surface of that name.
    ///
    /// # Errors
    ///
    /// [`KnowledgeError::Unknown`], naming the nearest.
    pub fn surface(&self, name: &str) -> Result<&SurfaceEntry, KnowledgeError> {
        entry("surface", &self.surfaces, name)
    }

    /// The tools in the alphabetical order of their names.
    pub fn tools(&self) -> impl Iterator<Item = &ToolEntry> {
        self.tools.values()
    }

    /// The media in the alphabetical order of their names.
    pub fn media(&self) -> impl Iterator<Item = &MediumEntry> {
        self.media.values()
    }

    /// The surfaces in the alphabetical order of their names.
    pub fn surfaces(&self) -> impl Iterator<Item = &SurfaceEntry> {
        self.surfaces.values()
    }

    /// All interactions, by tool, medium and surface.
    pub fn interactions(&self) -> impl Iterator<Item = &Interaction> {
        self.interactions
            .values()
            .flat_map(|media| media.values().flat_map(BTreeMap::values))
    }

    /// How a tool acts on a medium on a surface. What is known of that very surface comes before
    /// what is known of any.
    ///
    /// # Errors
    ///
    /// [`KnowledgeError::Unknown`] for a name that is not known, and
    /// [`KnowledgeError::NoInteraction`] if the three are known but not together.
    pub fn interaction(
        &self,
        tool: &str,
        medium: &str,
        surface: &str,
    ) -> Result<&Interaction, KnowledgeError> {
        self.tool(tool)?;
        self.medium(medium)?;
        self.surface(surface)?;
        self.known_interaction(tool, medium, surface)
            .ok_or_else(|| KnowledgeError::NoInteraction {
                tool: tool.to_owned(),
                medium: medium.to_owned(),
                surface: surface.to_owned(),
                capable: (self.tools.keys())
                    .filter(|tool| self.known_interaction(tool, medium, surface).is_some())
                    .cloned()
                    .collect(),
            })
    }

    fn known_interaction(&self, tool: &str, medium: &str, surface: &str) -> Option<&Interaction> {
        let surfaces = self.interactions.get(tool)?.get(medium)?;
        surfaces
            .get(&SurfaceScope::Named(surface.to_owned()))
            .or_else(|| surfaces.get(&SurfaceScope::Any))
    }

    /// The tools that can do the action, the likeliest to succeed at nominal force first, ties by
    /// name. None if there is no such tool.
    ///
    /// # Errors
    ///
    /// [`KnowledgeError::Unknown`] for a medium or surface that is not known.
    pub fn tools_for(
        &self,
        medium: &str,
        surface: &str,
        action: Action,
    ) -> Result<Vec<RankedTool<'_>>, KnowledgeError> {
        self.medium(medium)?;
        self.surface(surface)?;
        let mut ranked: Vec<RankedTool<'_>> = (self.tools.values())
            .filter_map(|tool| {
                let interaction = self.known_interaction(&tool.name, medium, surface)?;
                interaction.actions.contains(&action).then(|| RankedTool {
                    tool,
                    interaction,
                    probability: interaction.likelihood.probability(NOMINAL_FORCE),
                })
            })
            .collect();
        ranked.sort_by(|a, b| b.probability.total_cmp(&a.probability));
        Ok(ranked)
    }
}

/// The normalised force f′ of a contact with the force that was asked for (equation 9).
const NOMINAL_FORCE: f64 = 1.0;

fn entry<'a, T>(
    kind: &'static str,
    entries: &'a BTreeMap<String, T>,
    name: &str,
) -> Result<&'a T, KnowledgeError> {
    entries
        .get(name)
        .ok_or_else(|| UnknownName::new(kind, name, entries.keys().map(String::as_str)).into())
}

/// Why the knowledge base does not hold what was asked of it.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum KnowledgeError {
    /// A look-up of something that is not known.
    #[error(transparent)]
    Unknown(Box<UnknownName>),
    /// The tool, medium and surface are known, but not what they do together.
    #[error(
        "nothing is known of {tool} on {medium} on {surface}; tools known for it: {}",
        if capable.is_empty() { "none".to_owned() } else { capable.join(", ") }
    )]
    NoInteraction {
        /// The tool.
        tool: String,
        /// The medium.
        medium: String,
        /// The surface.
        surface: String,
        /// The tools of which something is known for this medium and surface.
        capable: Vec<String>,
    },
}

impl From<UnknownName> for KnowledgeError {
    fn from(unknown: UnknownName) -> Self {
        Self::Unknown(Box::new(unknown))
    }
}
