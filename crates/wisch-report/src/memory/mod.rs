//! The page of a query's answers: table, diagrams, timelines, and views in space.

mod names;
mod plots;
mod space;
#[cfg(test)]
mod tests;
mod times;

use crate::page::document::document;
use crate::scene::json;
use maud::{Markup, PreEscaped, html};
use names::local;
use space::Space;
use wisch_memory::ask::{Answers, Term};
use wisch_memory::view::View;

const STYLE: &str = include_str!("memory.css");
const SCRIPT: &str = include_str!("space.js");
/// Maximum number of rows of the table.
const MAX_ROWS: usize = 200;

/// Maximum length of a cell, and shown length of a longer one [characters].
const LONG_CELL: usize = 90;
const SHORT_CELL: usize = 36;

/// Input of the page of a query's answers.
#[derive(Debug, Clone, Copy)]
pub struct AnswersInput<'a> {
    /// The query.
    pub query: &'a str,
    /// The answers.
    pub answers: &'a Answers,
    /// The data that the query shows.
    pub view: &'a View,
}

/// Returns one self-contained HTML file, which loads nothing from the network.
pub fn answers_page(input: &AnswersInput) -> String {
    let view = input.view;
    let space = Space::new(view);
    let main = html! {
        h1 { "Answers of the memory" }
        pre class="query" { (input.query) }
        (table(input.answers))
        @if !space.is_empty() { (draw_space(&space)) }
        @if view.left_out > 0 {
            p class="note" { "The picture is full: " (view.left_out) @if view.left_out == 1 { " more queried object is not drawn." } @else { " more queried objects are not drawn." } }
        }
        @for remark in input.answers.remarks.iter().chain(&view.remarks) {
            p class="note" { (remark) }
        }
        @if !view.plots.is_empty() {
            h2 { "Diagrams" }
            div class="plots" {
                @for plot in &view.plots { (plots::draw_plot(plot)) }
            }
        }
        @if !view.episodes.is_empty() {
            h2 { "Over time" }
            @for episode in &view.episodes {
                h3 { (episode.task) " · " (episode.id) }
                (times::draw_timeline(episode))
            }
        }
        footer class="note" {
            "Answered by wisch from its episodic memory. Poses are computed from recorded joint positions, "
            "and events from tool poses and forces."
        }
    };
    document("Answers of the memory", STYLE, &main)
}

fn table(answers: &Answers) -> Markup {
    let count = answers.rows.len();
    // A variable without values gets no column.
    let columns: Vec<usize> = (0..answers.names.len())
        .filter(|&column| {
            let mut cells = answers.rows.iter().filter_map(|row| row.get(column));
            cells.any(|cell| !matches!(cell, Term::Variable(_)))
        })
        .collect();
    html! {
        @if count == 0 {
            p class="verdict" { "false: the memory has no match." }
        } @else if columns.is_empty() {
            p class="verdict" { "true" }
        } @else {
            p class="lead" {
                b { (count) } @if count == 1 { " answer" } @else { " answers" }
                @if answers.is_cut { ", and there are more" }
            }
            div class="scroll" {
                table class="answers" {
                    thead { tr { @for &column in &columns { th scope="col" { (answers.names[column]) } } } }
                    tbody {
                        @for row in answers.rows.iter().take(MAX_ROWS) {
                            tr { @for &column in &columns { td { (fold_text(&cell(row.get(column)))) } } }
                        }
                    }
                }
            }
            @if count > MAX_ROWS {
                p class="note" { "The table lists the first " (MAX_ROWS) " answers." }
            }
        }
    }
}

/// Folds a long text, which would distort the table.
fn fold_text(text: &str) -> Markup {
    let letters = text.chars().count();
    let start: String = text.chars().take(SHORT_CELL).collect();
    html! {
        @if letters <= LONG_CELL { (text) } @else {
            details { summary { (start) "…" } (text) }
        }
    }
}

fn cell(term: Option<&Term>) -> String {
    match term {
        None | Some(Term::Variable(_)) => String::new(),
        Some(Term::Atom(name)) => local(name).to_owned(),
        Some(Term::Float(value)) => format_number(*value),
        Some(other) => other.to_string(),
    }
}

/// Formats a number to a thousandth, or to four digits if it is small.
fn format_number(value: f64) -> String {
    if value == 0.0 || value.abs() >= 0.1 {
        format!("{value:.3}")
    } else {
        format!("{value:.3e}")
    }
}

fn draw_space(space: &Space) -> Markup {
    html! {
        h2 { "In space" }
        section class="motion" {
            p id="space-none" class="note" hidden { "This browser cannot draw 3-D graphics, so the page shows no scene." }
            noscript { p class="note" { "The 3-D scene needs JavaScript." } }
            div class="stage" id="space-stage" hidden {
                canvas id="space" tabindex="0" role="img" aria-label="Data of the query in 3-D: drag to turn, shift and drag to move, arrow keys to turn" {}
                div class="views" {
                    @if space.shines() { button type="button" data-look="near" { "Near" } }
                    button type="button" data-look="asked" { "Queried objects" }
                    button type="button" data-look="all" { "All" }
                    button type="button" data-look="above" { "From above" }
                }
            }
            ul class="legend items" {
                @for (place, item) in space.items.iter().enumerate() {
                    li {
                        label class=[(!item.asked).then_some("quiet-item")] {
                            input type="checkbox" checked data-item=(place);
                            i style=(swatch(&item.colour)) {}
                            (item.name)
                        }
                    }
                }
            }
            script type="application/json" id="space-data" { (PreEscaped(json(space))) }
            script { (PreEscaped(SCRIPT)) }
        }
    }
}

fn swatch(colour: &str) -> String {
    if colour.starts_with('#') {
        format!("background:{colour}")
    } else {
        format!("background:var(--{colour})")
    }
}
