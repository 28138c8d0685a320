//! What a person looks at after a run: pictures, and one page that needs nothing but itself.

mod chart;
mod contour;
mod frames;
mod motion;
mod page;
mod palette;
mod panel;
mod picture;
mod player;
mod png;
#[cfg(test)]
mod tests;
mod view;

pub use frames::Frames;
pub use motion::{Contact, ParticleFrame, Phase, Placement, RatedPlace};
pub use motion::{MotionInput, joint_plots, motion_section, placements_plan};
pub use page::page;
pub use png::rasterize;

use picture::Drawing;
use wisch::plan::{Plan, Prediction};
use wisch::represent::Task;

/// What a report is made of.
#[derive(Debug, Clone, Copy)]
pub struct ReportInput<'a> {
    /// Headline; the task's name as a rule.
    pub title: &'a str,
    /// What was to be done.
    pub task: &'a Task,
    /// How it is to be done.
    pub plan: &'a Plan,
    /// What is to be expected of it.
    pub prediction: &'a Prediction,
    /// The effect over time, recorded while the prediction ran.
    pub frames: &'a Frames,
    /// Bandwidth that the plan was asked for, [`wisch::plan::PlanConfig::bandwidth`] [m].
    pub bandwidth: Option<f64>,
    /// Rows of the table of metrics: label, and value with unit.
    pub facts: &'a [(String, String)],
    /// How a robot does it; `None` if none was asked to.
    pub motion: Option<&'a MotionInput<'a>>,
}

/// The pictures of a run as (file stem, SVG).
pub fn pictures(input: &ReportInput) -> Vec<(&'static str, String)> {
    let drawing = Drawing::new(input);
    let mut pictures = vec![
        ("before-after", panel::before_after(&drawing)),
        ("graph", panel::graph(&drawing)),
        ("density", panel::density(&drawing)),
        ("effect-over-time", panel::effect_over_time(&drawing)),
    ];
    if let Some(motion) = input.motion {
        pictures.push(("joints", joint_plots(motion)));
        pictures.push(("placements", placements_plan(motion)));
    }
    pictures
}
