//! What happened in each round of planning, wiping and interpreting, and how far that led.

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
mod words;

pub use input::{RoundView, RoundsInput};

use crate::draw::{Figure, GAP};
use maud::{Markup, PreEscaped, html};

const STYLE: &str = include_str!("rounds.css");
/// Most rounds that are shown with pictures; all stand in the table.
const MAX_PICTURED: usize = 8;

/// The rounds as a section of the page.
pub(crate) fn section(input: &RoundsInput) -> Markup {
    let pictured = pictured(input.rounds);
    html! {
        style { (PreEscaped(STYLE)) }
        section class="rounds" {
            h2 { "Round by round" }
            p { (words::unbroken(&words::outcome(input))) }
            @if !input.rounds.is_empty() {
                (overview::bars(input).whole())
                (overview::table(input))
            }
            @for round in &pictured { (details(input, round)) }
            @if pictured.len() < input.rounds.len() {
                p class="note" { "The first and the last rounds are shown, " (pictured.len()) " of " (input.rounds.len()) "; the table has all." }
            }
        }
    }
}

/// The pictures of all rounds as (file stem, SVG).
pub(crate) fn pictures(input: &RoundsInput) -> Vec<(String, String)> {
    if input.rounds.is_empty() {
        return Vec::new();
    }
    let title = &input.task.name;
    let mut pictures = vec![(
        "rounds".to_owned(),
        overview::bars(input).standalone(title, [GAP, GAP]),
    )];
    for round in pictured(input.rounds) {
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

/// The rounds that have pictures: all, or the first and the last.
fn pictured<'r, 'a>(rounds: &'r [RoundView<'a>]) -> Vec<&'r RoundView<'a>> {
    let left_out = rounds.len().saturating_sub(MAX_PICTURED);
    (rounds.iter().enumerate())
        .filter(|(i, _)| *i == 0 || *i > left_out)
        .map(|(_, round)| round)
        .collect()
}

/// All of one round.
fn details(input: &RoundsInput, round: &RoundView) -> Markup {
    let found = round.interpretation;
    let shown_in_3d = round.motion.map(|_| round.number);
    html! {
        h3 {
            "Round " (round.number)
            @if let Some(number) = shown_in_3d { a class="in-3d" href=(format!("#round={number}")) { "▶ in 3-D" } }
        }
        p { (words::unbroken(&words::round(input, round))) }
        h4 { "Force and height" }
        (force_plot::figure(input, round).scrolling())
        h4 { "Where the tool felt the surface" }
        (path::figure(input, round).whole())
        h4 { "The chance of an effect" }
        (chance::section(input, round))
        h4 { "What is left" }
        (residual_map::section(input, round))
        (overview::events(&found.events, shown_in_3d))
    }
}
