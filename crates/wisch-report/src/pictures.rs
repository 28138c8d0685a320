//! The pictures of a run, as files.

use crate::input::ReportInput;
use crate::motion::{joint_plots, placements_plan};
use crate::prediction::figures;
use crate::prediction::layers::Drawing;
use crate::rounds;

/// Draws the pictures of a run as (file stem, SVG).
pub fn pictures(input: &ReportInput) -> Vec<(String, String)> {
    let drawing = Drawing::new(input);
    let mut pictures = Vec::new();
    let mut add = |stem: &str, svg: String| pictures.push((stem.to_owned(), svg));
    add("before-after", figures::before_after(&drawing));
    add("graph", figures::graph(&drawing));
    add("density", figures::density(&drawing));
    add("effect-over-time", figures::effect_over_time(&drawing));
    if let Some(motion) = input.motion {
        add("joints", joint_plots(motion));
        add("placements", placements_plan(motion));
    }
    if let Some(rounds) = input.rounds {
        pictures.extend(rounds::pictures(rounds));
    }
    pictures
}
