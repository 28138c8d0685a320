//! Figures of a robot's motion: joints over time, and base poses.

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
pub use input::{BasePose, CandidateBase, MotionInput, ShownContact, ShownPhase};

use crate::draw::Panel;
use sampled::SampledMotion;

/// Draws position and velocity of every moving joint over time, as SVG with light colours.
pub fn joint_plots(input: &MotionInput) -> String {
    let what = "Joint positions within their limits, and velocities as a share of their limits";
    standalone(input, &joints::panel(input), what)
}

/// Draws the rated and chosen base poses with the scene from above, as SVG with light colours.
/// For a fixed base it shows its pose.
pub fn placements_plan(input: &MotionInput) -> String {
    let panel = above::panel(input, &SampledMotion::new(input)).unwrap_or_else(Panel::empty);
    standalone(input, &panel, "Base poses, seen from above")
}

fn standalone(input: &MotionInput, panel: &Panel, what: &str) -> String {
    let title = format!("{}: {}", input.task.name, input.robot.name());
    panel.standalone(&title, what)
}
