//! What happened in each round of planning, wiping and interpreting, and how far that led.

mod chance;
mod course;
#[cfg(test)]
mod demo;
mod key;
mod overview;
mod reduce;
mod space;
mod spread;
#[cfg(test)]
mod tests;
mod words;

use super::panel::Panel;
use key::Entry;
use maud::{Markup, PreEscaped, html};
use wisch::interpret::Interpretation;
use wisch::plan::Plan;
use wisch::represent::{GoalState, ParticleDistribution, Performance, Task};

const STYLE: &str = include_str!("rounds.css");
/// Most rounds that are shown with pictures; all stand in the table.
const MAX_PICTURED: usize = 8;
/// Width of a picture that stands alone and is made of several.
const WIDE: f64 = 1000.0;
const GAP: f64 = 24.0;

/// One round: what was planned, and what touch told of its execution.
#[derive(Debug, Clone, Copy)]
pub struct RoundView<'a> {
    /// Its number, counted from 1.
    pub number: usize,
    /// The strokes that were to be wiped.
    pub plan: &'a Plan,
    /// Where the dirt was believed to lie when the plan was made.
    pub believed: &'a ParticleDistribution,
    /// The performance that the plan promised, in [0, 1].
    pub predicted: f64,
    /// What the log says.
    pub interpretation: &'a Interpretation,
    /// Where the dirt lay after the round, and the performance by it in [0, 1]; `None` where nobody knows,
    /// as on a real robot.
    pub truth: Option<(&'a ParticleDistribution, f64)>,
    /// When something really pushed the tool: from, to [s].
    pub pushes: &'a [[f64; 2]],
}

/// All rounds of a task.
#[derive(Debug, Clone, Copy)]
pub struct RoundsInput<'a> {
    /// What was to be done.
    pub task: &'a Task,
    /// What the performance counts.
    pub goal: &'a GoalState,
    /// The performance that was wanted, in [0, 1].
    pub target: f64,
    /// The rounds in their order.
    pub rounds: &'a [RoundView<'a>],
}

/// A picture with its name and what explains its marks.
struct Figure {
    panel: Panel,
    entries: Vec<Entry>,
    /// What is seen, for those who do not see it, and for the headline of the file.
    what: String,
}

impl<'a> RoundView<'a> {
    /// What makes up the belief after the round.
    fn replays(&self) -> &'a [ParticleDistribution] {
        self.interpretation.belief.replays()
    }

    /// The replay whose performance is nearest to the mean: one way in which it may be.
    fn typical(&self, input: &RoundsInput) -> &'a ParticleDistribution {
        let mean = self.interpretation.performance.mean;
        let off = |particles: &ParticleDistribution| {
            (Performance::of(particles, input.goal, &input.task.surface).ratio() - mean).abs()
        };
        let nearest = (self.replays().iter()).min_by(|a, b| off(a).total_cmp(&off(b)));
        nearest.unwrap_or(self.believed)
    }
}

impl Figure {
    /// As part of the page, all of it in sight.
    fn whole(&self) -> Markup {
        html! {
            figure class="whole limited" { (self.panel.inline(&self.what)) }
            (key::list(&self.entries))
        }
    }

    /// As part of the page; scrolls where the page is too narrow to read it.
    fn scrolling(&self) -> Markup {
        html! {
            figure class="scroll" { (self.panel.inline(&self.what)) }
            (key::list(&self.entries))
        }
    }

    /// As a file of its own.
    fn standalone(self, title: &str) -> String {
        let (legend, below) = key::rows(
            &self.entries,
            [GAP, self.panel.height],
            self.panel.width - 2.0 * GAP,
        );
        Panel {
            height: self.panel.height + below,
            body: html! { (self.panel.body) (legend) },
            ..self.panel
        }
        .standalone(title, &self.what)
    }
}

/// The rounds as a section of the page.
pub fn section(input: &RoundsInput) -> Markup {
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
pub fn pictures(input: &RoundsInput) -> Vec<(String, String)> {
    if input.rounds.is_empty() {
        return Vec::new();
    }
    let title = &input.task.name;
    let mut pictures = vec![("rounds".to_owned(), overview::bars(input).standalone(title))];
    for round in pictured(input.rounds) {
        let mut add = |stem: &str, figure: Figure| {
            let number = round.number;
            let title = format!("Round {number}: {title}");
            pictures.push((format!("round-{number}-{stem}"), figure.standalone(&title)));
        };
        add("force", course::figure(input, round));
        add("path", space::figure(input, round));
        add("chance", chance::figure(input, round));
        add("particles", spread::particles_figure(input, round));
        add("density", spread::density_figure(input, round));
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
    html! {
        h3 { "Round " (round.number) }
        p { (words::unbroken(&words::round(input, round))) }
        h4 { "Force and height" }
        (course::figure(input, round).scrolling())
        h4 { "Where the tool felt the surface" }
        (space::figure(input, round).whole())
        h4 { "The chance of an effect" }
        (chance::section(input, round))
        h4 { "What is left" }
        (spread::section(input, round))
        (overview::events(&found.events))
    }
}
