//! What a person looks at after a run: pictures, and one page that needs nothing but itself.

mod chart;
mod contour;
mod frames;
mod memory;
mod motion;
mod page;
mod palette;
mod panel;
mod picture;
mod player;
mod png;
mod rounds;
#[cfg(test)]
mod tests;
mod view;

pub use frames::Frames;
pub use memory::{AnswersInput, answers_page};
pub use motion::{Contact, ParticleFrame, Phase, Placement, RatedPlace};
pub use motion::{MotionInput, joint_plots, motion_section, placements_plan};
pub use page::page;
pub use png::rasterize;
pub use rounds::{RoundView, RoundsInput};

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
    /// What came of it, round by round; `None` if nothing was executed.
    pub rounds: Option<&'a RoundsInput<'a>>,
}

/// The pictures of a run as (file stem, SVG).
pub fn pictures(input: &ReportInput) -> Vec<(String, String)> {
    let drawing = Drawing::new(input);
    let mut pictures = Vec::new();
    let mut add = |stem: &str, svg: String| pictures.push((stem.to_owned(), svg));
    add("before-after", panel::before_after(&drawing));
    add("graph", panel::graph(&drawing));
    add("density", panel::density(&drawing));
    add("effect-over-time", panel::effect_over_time(&drawing));
    if let Some(motion) = input.motion {
        add("joints", joint_plots(motion));
        add("placements", placements_plan(motion));
    }
    if let Some(rounds) = input.rounds {
        pictures.extend(rounds::pictures(rounds));
    }
    pictures
}
