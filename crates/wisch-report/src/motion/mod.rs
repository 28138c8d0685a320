//! A robot's motion in figures: joint by joint over time, and where its base stands.

mod above;
#[cfg(test)]
pub(crate) mod demo;
mod followed;
mod input;
mod joints;
mod sampled;
#[cfg(test)]
mod tests;

pub use followed::ShownMotion;
pub use input::{MotionInput, ParticleFrame, ShownContact, ShownPhase, ShownPlace, ShownPlacement};

use crate::draw::Panel;
use sampled::SampledMotion;

/// Position and velocity of every moving joint over time, as SVG with light colours.
pub fn joint_plots(input: &MotionInput) -> String {
    let what = "Positions within their limits, velocities as a share of theirs";
    alone(input, &joints::panel(input), what)
}

/// Base positions, rated and chosen, with the scene round them from above, as SVG with light colours.
/// For a robot whose base stands still it shows where it stands.
pub fn placements_plan(input: &MotionInput) -> String {
    let panel = above::panel(input, &SampledMotion::new(input)).unwrap_or_else(Panel::empty);
    alone(input, &panel, "Where the base stands, seen from above")
}

fn alone(input: &MotionInput, panel: &Panel, what: &str) -> String {
    let title = format!("{}: {}", input.task.name, input.robot.name());
    panel.standalone(&title, what)
}
