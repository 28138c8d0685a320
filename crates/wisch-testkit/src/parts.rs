//! A surface, the sponge, and the sponge's interaction with breadcrumbs.

use wisch::geometry::{Polygon, Pose, Vector2, Vector3};
use wisch::represent::{
    Action, Interaction, LogNormal, LogNormalSpread, Redraw, Surface, SurfaceScope, Tool,
};

/// Depth, width and height of the sponge [m].
const SPONGE: [f64; 3] = [0.07, 0.11, 0.05];

/// Returns a rectangle of a size \[m\] about the world's origin; dirt may be skimmed over its first edge.
pub fn surface(size: [f64; 2]) -> Surface {
    Surface {
        name: "board".into(),
        outline: Polygon::rectangle(Vector2::from(size)),
        world_from_surface: Pose::identity(),
        skim_edges: vec![0],
        shape: Default::default(),
    }
}

/// Returns the sponge; its lower face is in the contact plane.
pub fn sponge() -> Tool {
    Tool::pad("sponge", Vector3::from(SPONGE)).expect("a box")
}

/// Returns the interaction of the sponge with breadcrumbs.
pub fn interaction() -> Interaction {
    Interaction {
        tool: "sponge".into(),
        medium: "breadcrumbs".into(),
        surface: SurfaceScope::Any,
        actions: Action::ALL.into_iter().collect(),
        press_force_n: 10.0,
        stiffness_n_per_m: 500.0,
        damping_ratio: 0.7,
        nullspace_posture_weight: 0.1,
        compression_depth_m: 0.005,
        gap_m: 0.0,
        likelihood: LogNormal {
            mu: -1.0,
            sigma: 0.25,
        },
        likelihood_spread: LogNormalSpread::NONE,
        redraw: Redraw::default(),
    }
}
