//! Knowledge about tools, media and surfaces, and about their interactions (§4.3, Fig. 11, 13).
//!
//! Knowledge belongs to the objects: there is an entry per tool, medium and surface, and an [`Interaction`] per
//! meaningful combination.

mod grip;
mod likelihood;
mod mobility;

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::str::FromStr;

pub use crate::source_location::{Place, UnknownName};
pub use grip::{Grip, Mount, SecondGrip};
pub use likelihood::{LogNormal, LogNormalSpread, Redraw};
pub use mobility::{DirtFriction, DirtMobility, Liquid, LiquidFilm, ToolPace, dirt_friction};

use super::MAX_PRESSURE;
use crate::geometry::Vector3;

/// Action of a wiping task (§3.1).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Action {
    /// Absorb the medium.
    Absorb,
    /// Push the medium together at one place of the surface.
    Collect,
    /// Push the medium over an edge of the surface.
    Skim,
    /// Slide over every place of the surface a given number of times.
    Polish,
    /// Coat every place of the surface to a given thickness with the medium.
    Dispense,
}

impl Action {
    /// All actions: those of the paper in its order, then those that treat the surface.
    pub const ALL: [Self; 5] = [
        Self::Absorb,
        Self::Collect,
        Self::Skim,
        Self::Polish,
        Self::Dispense,
    ];
    /// The actions that move dirt, in the order of the paper.
    pub const WIPING: [Self; 3] = [Self::Absorb, Self::Collect, Self::Skim];

    /// Whether further wiping keeps what an action has reached. Dirt that is absorbed or skimmed off stays away. Wiping can push
    /// dirt out of the goal of a collect, and can polish or coat points too often.
    ///
    /// ```
    /// use wisch::represent::Action;
    /// assert!(Action::Absorb.is_lasting() && !Action::Collect.is_lasting());
    /// ```
    pub fn is_lasting(self) -> bool {
        match self {
            Self::Absorb | Self::Skim => true,
            Self::Collect | Self::Polish | Self::Dispense => false,
        }
    }

    /// Name of the action in files and goals.
    ///
    /// ```
    /// use wisch::represent::Action;
    /// assert_eq!(Action::Skim.as_str(), "skim");
    /// assert_eq!("collect".parse(), Ok(Action::Collect));
    /// assert_eq!("emit".parse(), Ok(Action::Dispense), "its name in earlier versions");
    /// assert_eq!("colect".parse::<Action>().unwrap_err().nearest(), Some("collect"));
    /// ```
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Absorb => "absorb",
            Self::Collect => "collect",
            Self::Skim => "skim",
            Self::Polish => "polish",
            Self::Dispense => "dispense",
        }
    }

    /// Name of the action in files of earlier versions, which are still read.
    pub fn earlier_name(self) -> Option<&'static str> {
        match self {
            Self::Dispense => Some("emit"),
            Self::Absorb | Self::Collect | Self::Skim | Self::Polish => None,
        }
    }

    /// Effect of the tool on a particle that it touches.
    pub fn effect(self) -> Effect {
        match self {
            Self::Absorb => Effect::Absorb,
            Self::Collect | Self::Skim => Effect::Push,
            Self::Polish | Self::Dispense => Effect::Treat,
        }
    }

    /// Whether the action treats the surface: particles are places of it, and strokes run in lanes.
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
            .find(|action| action.as_str() == name || action.earlier_name() == Some(name))
            .ok_or_else(|| UnknownName::new("action", name, Self::ALL.map(Self::as_str)))
    }
}

/// Effect on a particle under the tool (§3.1).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Effect {
    /// The particle is deleted.
    Absorb,
    /// The particle is carried along with the tool.
    Push,
    /// The particle is a place of the surface: it stays, and counts the travel of the tool over it.
    Treat,
}

/// A range of angles with `min_rad <= max_rad`, both within ±π.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AngleRange {
    /// Smallest angle \[rad\].
    pub min_rad: f64,
    /// Largest angle \[rad\].
    pub max_rad: f64,
}

impl AngleRange {
    /// The range from −π to π, which permits every angle.
    pub const FULL: Self = Self {
        min_rad: -std::f64::consts::PI,
        max_rad: std::f64::consts::PI,
    };
}

/// Part of the surface on which a tool acts, D_aoe (§3.2).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AreaOfEffect {
    /// Extent across the motion, the tool's broad side \[m\].
    pub width_m: f64,
    /// Extent along the motion \[m\].
    pub depth_m: f64,
}

/// Axis about which a tool may tilt while it wipes, such as a window wiper's blade.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TiltFreedom {
    /// Direction of the axis, a unit vector in the tool frame.
    pub axis_in_tool: nalgebra::Unit<Vector3>,
    /// Range of the tilt; 0 is upright.
    pub range: AngleRange,
}

/// Source of a tool's mesh, whose frame is the tool's.
#[derive(Debug, Clone, PartialEq)]
pub enum ToolMesh {
    /// A file, by its path relative to the knowledge files.
    InKnowledge(String),
    /// A file, by its path relative to the task file.
    BesideTask(String),
    /// A box that stands on the contact plane, by its sides along x, y and z \[m\].
    Cuboid(Vector3),
}

/// A tool of the knowledge base.
#[derive(Debug, Clone, PartialEq)]
pub struct ToolEntry {
    /// Name, also in PDDL.
    pub name: String,
    /// The mesh from which its footprint is cut.
    pub mesh: ToolMesh,
    /// Compression δ under nominal force \[m\].
    pub compression_depth_m: f64,
    /// Rectangle about the TCP on which the tool acts, if it is not the footprint: a nozzle touches with its rim but
    /// acts with its whole opening.
    pub area_of_effect: Option<AreaOfEffect>,
    /// Permitted yaw about the surface normal \[rad\]; at 0 the broad side is across the motion.
    pub rotation_about_normal: AngleRange,
    /// Axis of tilt; `None` if the tool stays upright.
    pub tilt: Option<TiltFreedom>,
    /// Description of the grasp, for people.
    pub grasp: String,
    /// Grip of the leading hand; `None` puts the rear edge of the tool's upper face at the end of the hand.
    pub grip: Option<Grip>,
    /// Grip of a second hand, if there is one.
    pub second_grip: Option<SecondGrip>,
}

/// Kind of a medium, which determines how its particles behave.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum MediumKind {
    /// Pieces that keep their shape.
    Solid,
    /// Drops and films.
    Liquid,
    /// Grains too small to be distinguished.
    Powder,
}

/// Range of a medium's grain diameters, `0 < min_m <= max_m`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GrainSize {
    /// Smallest diameter \[m\].
    pub min_m: f64,
    /// Largest diameter \[m\].
    pub max_m: f64,
}

/// A medium of the knowledge base.
#[derive(Debug, Clone, PartialEq)]
pub struct MediumEntry {
    /// Name, also in PDDL.
    pub name: String,
    /// Kind.
    pub kind: MediumKind,
    /// Grain sizes; `None` for a liquid.
    pub grain_size: Option<GrainSize>,
    /// Its friction on a surface; `None` if it is unknown.
    pub friction: Option<DirtFriction>,
    /// How it runs, if it is a liquid; `None` if that is unknown.
    pub liquid: Option<Liquid>,
}

/// A surface of the knowledge base.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfaceEntry {
    /// Name, also in PDDL.
    pub name: String,
    /// Coulomb friction coefficient of a tool that slides on the surface \[1\].
    pub friction: f64,
}

/// Surfaces to which an interaction applies.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub enum SurfaceScope {
    /// The surface of this name.
    Named(String),
    /// Every surface without an interaction of its own.
    Any,
}

impl SurfaceScope {
    /// Name that stands for all surfaces.
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

/// Use of a tool on a medium on a surface, with its likelihood.
#[derive(Debug, Clone, PartialEq)]
pub struct Interaction {
    /// The tool.
    pub tool: String,
    /// The medium.
    pub medium: String,
    /// The surface or surfaces.
    pub surface: SurfaceScope,
    /// Actions for which the tool is suited, at least one.
    pub actions: BTreeSet<Action>,
    /// Press force of the tool \[N\], the magnitude of f_min in equation (9); for a hovering tool,
    /// the largest force that holds it in place.
    pub press_force_n: f64,
    /// Cartesian stiffness of the controller [N/m].
    pub stiffness_n_per_m: f64,
    /// Damping ratio of the controller \[1\].
    pub damping_ratio: f64,
    /// Weight of the posture task in the null space \[1\].
    pub nullspace_posture_weight: f64,
    /// Compression of the tool in this interaction \[m\]: δ of the tool unless the files declare
    /// another value.
    pub compression_depth_m: f64,
    /// Height at which the tool hovers over the surface \[m\]; 0 for a tool that touches.
    pub gap_m: f64,
    /// Probability of an effect as a function of the normalised force.
    pub likelihood: LogNormal,
    /// Uncertainty of `likelihood`.
    pub likelihood_spread: LogNormalSpread,
    /// How a particle that stays draws its threshold again.
    pub redraw: Redraw,
}

impl Interaction {
    /// Returns assumed values for a tool on a medium without a known interaction. The tool presses
    /// with 10 N, a stiffness of 500 N/m and a damping ratio of 0.7, and is compressed by 5 mm.
    /// Half of the particles are affected at 35 % of the press force. These are the values of a
    /// sponge on crumbs.
    pub fn assume(tool: &str, medium: &str) -> Self {
        Self {
            tool: tool.to_owned(),
            medium: medium.to_owned(),
            surface: SurfaceScope::Any,
            actions: Action::ALL.into_iter().collect(),
            press_force_n: 10.0,
            stiffness_n_per_m: 500.0,
            damping_ratio: 0.7,
            nullspace_posture_weight: 0.2,
            compression_depth_m: 0.005,
            gap_m: 0.0,
            likelihood: LogNormal {
                mu: -1.05,
                sigma: 0.25,
            },
            likelihood_spread: LogNormalSpread::default(),
            redraw: Redraw::default(),
        }
    }

    /// Whether the tool acts without contact, so that its force carries no information.
    pub fn hovers(&self) -> bool {
        self.gap_m > 0.0
    }

    /// Sets the force with which the tool presses \[N\], above 0, for a tool whose effect is known
    /// at another force. Thresholds of particles and stiffness of the tool stay the same in
    /// newtons. The likelihood is stated relative to the press force, so it shifts by the logarithm
    /// of the ratio. The compression scales by the ratio, at most by two, where foam bottoms out. A
    /// hovering tool does not press, so only the force that holds it changes.
    ///
    /// ```
    /// use wisch::represent::Interaction;
    /// let mut gentle = Interaction::assume("sponge", "crumbs");
    /// assert!(gentle.reaction_probability() > 0.99);
    /// gentle.press_with(3.0);
    /// assert!(gentle.reaction_probability() < 0.3);
    /// assert!((gentle.compression_depth_m - 0.0015).abs() < 1e-12);
    /// ```
    pub fn press_with(&mut self, force_n: f64) {
        let ratio = force_n / self.press_force_n;
        if ratio != 1.0 && !self.hovers() {
            self.likelihood.mu -= libm::log(ratio);
            self.compression_depth_m *= ratio.min(MAX_PRESSURE);
        }
        self.press_force_n = force_n;
    }

    /// Returns the probability that a particle reacts when the tool first touches it at the press force, P(X ≤ 1) of
    /// equation 12 \[1\]. Predictions assume that every particle does.
    pub fn reaction_probability(&self) -> f64 {
        self.likelihood.probability(NOMINAL_FORCE)
    }

    /// Nominal force of the tool on the surface \[N\]; 0 for a hovering tool.
    pub fn contact_force(&self) -> f64 {
        if self.hovers() {
            0.0
        } else {
            self.press_force_n
        }
    }
}

/// Returns a sentence, without its full stop, about the particles that a prediction assumes to
/// react although they may not. `None` if at least 95 % of the particles react, and at least the
/// share that the target requires.
///
/// # Parameters
/// - `probability`: [`Interaction::reaction_probability`] of the task \[1\].
/// - `target`: performance that meets the goal \[1\].
pub fn describe_weak_reaction(probability: f64, target: f64) -> Option<String> {
    (probability < WEAK_REACTION.max(target)).then(|| {
        format!(
            "by the law of the interaction, {:.1} % of the particles react when the tool first passes; the prediction assumes that all do",
            100.0 * probability
        )
    })
}

/// A tool that can do the requested action, with its probability of success.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RankedTool<'a> {
    /// The tool.
    pub tool: &'a ToolEntry,
    /// Interaction to use.
    pub interaction: &'a Interaction,
    /// Probability of an effect at nominal force, P(X ≤ 1) \[1\].
    pub probability: f64,
}

/// Tools, media and surfaces with their interactions. Every name in it resolves.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct KnowledgeBase {
    tools: BTreeMap<String, ToolEntry>,
    media: BTreeMap<String, MediumEntry>,
    surfaces: BTreeMap<String, SurfaceEntry>,
    /// Tool → medium → surface.
    interactions: BTreeMap<String, BTreeMap<String, BTreeMap<SurfaceScope, Interaction>>>,
}

impl KnowledgeBase {
    /// Adds a tool; replaces one of the same name.
    pub fn insert_tool(&mut self, tool: ToolEntry) {
        self.tools.insert(tool.name.clone(), tool);
    }

    /// Adds a medium; replaces one of the same name.
    pub fn insert_medium(&mut self, medium: MediumEntry) {
        self.media.insert(medium.name.clone(), medium);
    }

    /// Adds a surface; replaces one of the same name.
    pub fn insert_surface(&mut self, surface: SurfaceEntry) {
        self.surfaces.insert(surface.name.clone(), surface);
    }

    /// Adds an interaction; replaces that of the same tool, medium and surface.
    ///
    /// # Errors
    ///
    /// [`KnowledgeError::Unknown`] for a tool, medium or surface that is not in the knowledge base.
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

    /// Returns the tool of this name.
    ///
    /// # Errors
    ///
    /// [`KnowledgeError::Unknown`], with the nearest name.
    pub fn tool(&self, name: &str) -> Result<&ToolEntry, KnowledgeError> {
        entry("tool", &self.tools, name)
    }

    /// Returns the medium of this name.
    ///
    /// # Errors
    ///
    /// [`KnowledgeError::Unknown`], with the nearest name.
    pub fn medium(&self, name: &str) -> Result<&MediumEntry, KnowledgeError> {
        entry("medium", &self.media, name)
    }

    /// Returns the surface of this name.
    ///
    /// # Errors
    ///
    /// [`KnowledgeError::Unknown`], with the nearest name.
    pub fn surface(&self, name: &str) -> Result<&SurfaceEntry, KnowledgeError> {
        entry("surface", &self.surfaces, name)
    }

    /// Tools in alphabetical order of their names.
    pub fn tools(&self) -> impl Iterator<Item = &ToolEntry> {
        self.tools.values()
    }

    /// Media in alphabetical order of their names.
    pub fn media(&self) -> impl Iterator<Item = &MediumEntry> {
        self.media.values()
    }

    /// Surfaces in alphabetical order of their names.
    pub fn surfaces(&self) -> impl Iterator<Item = &SurfaceEntry> {
        self.surfaces.values()
    }

    /// All interactions, sorted by tool, medium and surface.
    pub fn interactions(&self) -> impl Iterator<Item = &Interaction> {
        self.interactions
            .values()
            .flat_map(|media| media.values().flat_map(BTreeMap::values))
    }

    /// Returns the interaction of a tool with a medium on a surface. An interaction for that very surface takes
    /// precedence over one for any surface.
    ///
    /// # Errors
    ///
    /// [`KnowledgeError::Unknown`] for an unknown name, and [`KnowledgeError::NoInteraction`] if all three are known
    /// but have no interaction.
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

    /// Returns the tools that can do the action, sorted by their probability of success at nominal force, then by name;
    /// empty if there is none.
    ///
    /// # Errors
    ///
    /// [`KnowledgeError::Unknown`] for an unknown medium or surface.
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
                    probability: interaction.reaction_probability(),
                })
            })
            .collect();
        ranked.sort_by(|a, b| b.probability.total_cmp(&a.probability));
        Ok(ranked)
    }
}

/// Probability of a reaction below which a prediction states it [1].
const WEAK_REACTION: f64 = 0.95;
/// f′ of a contact at nominal force (equation 9).
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

/// A failed look-up in the knowledge base.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum KnowledgeError {
    /// An unknown name.
    #[error(transparent)]
    Unknown(Box<UnknownName>),
    /// Tool, medium and surface are known, but have no interaction.
    #[error(
        "no interaction of {tool} with {medium} on {surface} is known; tools known for it: {}",
        if capable.is_empty() { "none".to_owned() } else { capable.join(", ") }
    )]
    NoInteraction {
        /// The tool.
        tool: String,
        /// The medium.
        medium: String,
        /// The surface.
        surface: String,
        /// Tools with an interaction for this medium and surface.
        capable: Vec<String>,
    },
}

impl From<UnknownName> for KnowledgeError {
    fn from(unknown: UnknownName) -> Self {
        Self::Unknown(Box::new(unknown))
    }
}
