//! Motion of dirt by its own weight.

use super::MediumKind;

/// Friction coefficients of dry grains and of wet dirt at rest on a surface [1].
const DRY_FRICTION: f64 = 0.8;
const WET_FRICTION: f64 = 1.5;

/// Returns the friction coefficient of dirt at rest on a surface \[1\], if none is declared. Grains
/// hold by their edges and wet dirt by adhesion, at least as well as a tool that slides on the
/// surface with the friction `of_surface` \[1\]. An assumption that prediction and simulation
/// share.
pub fn dirt_friction(kind: MediumKind, of_surface: f64) -> f64 {
    let of_dirt = match kind {
        MediumKind::Solid | MediumKind::Powder => DRY_FRICTION,
        MediumKind::Liquid => WET_FRICTION,
    };
    of_surface.max(of_dirt)
}

/// Coulomb friction of dirt on a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DirtFriction {
    /// Coefficient at rest \[1\].
    pub at_rest: f64,
    /// Coefficient while the dirt slides, at most that at rest \[1\].
    pub sliding: f64,
}

impl DirtFriction {
    /// Returns the same friction at rest and while sliding.
    ///
    /// # Parameters
    /// - `coefficient`: the coefficient \[1\].
    pub const fn constant(coefficient: f64) -> Self {
        Self {
            at_rest: coefficient,
            sliding: coefficient,
        }
    }
}

/// Properties of a liquid that determine how a film of it runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Liquid {
    /// Dynamic viscosity [Pa s].
    pub viscosity: f64,
    /// Density [kg/m³].
    pub density: f64,
    /// Thickness of the layer that adheres to the surface and does not run \[m\].
    pub adhering_thickness: f64,
}

impl Liquid {
    /// Water at 20 °C, no layer of which adheres.
    pub const WATER: Self = Self {
        viscosity: 1e-3,
        density: 1000.0,
        adhering_thickness: 0.0,
    };
}

/// Durations that a prediction assumes for the tool's motions, during which a film runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ToolPace {
    /// Speed in contact [m/s].
    pub contact: f64,
    /// Speed between strokes [m/s].
    pub lifted: f64,
    /// Time to lift off and to land again \[s\].
    pub landing: f64,
}

impl Default for ToolPace {
    /// 0.25 m/s in contact and between strokes, and 1.5 s to lift off and land.
    fn default() -> Self {
        Self {
            contact: 0.25,
            lifted: 0.25,
            landing: 1.5,
        }
    }
}

/// A film of liquid, as particles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LiquidFilm {
    /// The liquid.
    pub liquid: Liquid,
    /// Volume for which each particle stands \[m³\].
    pub particle_volume: f64,
    /// Durations of the tool's motions in predictions.
    pub pace: ToolPace,
}

/// What is known about the motion of a medium by its own weight.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum DirtMobility {
    /// Nothing is known. The dirt is assumed to stay in place after it has settled before the first round.
    #[default]
    Unknown,
    /// Pieces or grains that slide where the surface is too steep for their friction.
    Slides(DirtFriction),
    /// A liquid that runs down a plane.
    Runs(LiquidFilm),
}

impl DirtMobility {
    /// Returns the mobility of the particles of a subset that stands for all dirt: each particle
    /// stands for more liquid.
    ///
    /// # Parameters
    /// - `share`: share of the particles in the subset \[1\].
    #[must_use]
    pub fn sample(self, share: f64) -> Self {
        match self {
            Self::Runs(film) if share > 0.0 => Self::Runs(LiquidFilm {
                particle_volume: film.particle_volume / share,
                ..film
            }),
            _ => self,
        }
    }
}
