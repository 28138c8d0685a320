//! Motion of dirt by its own weight.

use super::MediumKind;

/// Friction coefficients of dry grains and of wet dirt at rest on a surface [1].
const DRY_FRICTION: f64 = 0.8;
const WET_FRICTION: f64 = 1.5;

/// Returns the friction coefficient of dirt at rest on a surface \[1\], if none is declared. Grains hold by their edges and
/// wet dirt by adhesion, at least as well as a tool slides on the surface, whose friction is `of_surface` \[1\]. An
/// assumption, the same in prediction and simulation.
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

/// What is known about the motion of a medium by its own weight.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum DirtMobility {
    /// Nothing is known. The dirt is assumed to stay in place after it has settled before the first round.
    #[default]
    Unknown,
    /// Pieces or grains that slide where the surface is too steep for their friction.
    Slides(DirtFriction),
}
