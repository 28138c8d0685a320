//! Figures of the rounds of planning, wiping and interpreting.

mod chance;
#[cfg(test)]
mod demo;
mod force_plot;
mod input;
mod overview;
mod path;
mod reduce;
mod residual_map;
#[cfg(test)]
mod tests;
pub(crate) mod words;

pub use input::{RoundView, RoundsInput};

use crate::draw::{Figure, GAP};

/// Maximum number of rounds with pictures.
const MAX_PICTURED: usize = 8;

/// Draws the pictures of all rounds as (file stem, SVG).
pub(crate) fn pictures(input: &RoundsInput) -> Vec<(String, String)> {
    if input.rounds.is_empty() {
        return Vec::new();
    }
    let title = &input.task.name;
    let mut pictures = vec![(
        "rounds".to_owned(),
        overview::bars(input).standalone(title, [GAP, GAP]),
    )];
    for round in select_pictured(input.rounds) {
        let mut add = |stem: &str, figure: Figure| {
            let number = round.number;
            let title = format!("Round {number}: {title}");
            pictures.push((
                format!("round-{number}-{stem}"),
                figure.standalone(&title, [GAP, GAP]),
            ));
        };
        add("force", force_plot::figure(input, round));
        add("path", path::figure(input, round));
        add("chance", chance::figure(input, round));
        add("particles", residual_map::particles_figure(input, round));
        add("density", residual_map::density_figure(input, round));
    }
    pictures
}

/// Draws the figures of a log for its page.
pub(crate) fn log_figures(input: &RoundsInput, round: &RoundView) -> Vec<Figure> {
    let mut figures = vec![path::figure(input, round), force_plot::figure(input, round)];
    figures.extend(residual_map::contacts_figure(input, round));
    figures.push(residual_map::particles_figure(input, round));
    figures.push(residual_map::density_figure(input, round));
    figures
}

/// Returns the rounds with pictures: all, or the first and the last ones.
fn select_pictured<'r, 'a>(rounds: &'r [RoundView<'a>]) -> Vec<&'r RoundView<'a>> {
    let left_out = rounds.len().saturating_sub(MAX_PICTURED);
    (rounds.iter().enumerate())
        .filter(|(i, _)| *i == 0 || *i > left_out)
        .map(|(_, round)| round)
        .collect()
}
