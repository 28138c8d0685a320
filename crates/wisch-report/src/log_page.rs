//! The page of an interpreted log: path, force, fitted plane and estimated dirt.

use crate::draw::{GAP, format_decimal};
use crate::page::document::document;
use crate::rounds::{RoundView, RoundsInput, log_figures, words};
use maud::{Markup, PreEscaped, html};
use wisch::interpret::Event;

/// Maximum number of events in the table.
const MAX_EVENTS: usize = 500;
const STYLE: &str = "table.facts th { text-align: left; padding-right: 1.5em; white-space: nowrap; font-weight: normal; vertical-align: top; } \
                     figure { margin: 1.5em 0; } figure svg { max-width: 100%; height: auto; }";

/// Input of the page of a log.
#[derive(Debug, Clone, Copy)]
pub struct LogPageInput<'a> {
    /// Headline.
    pub title: &'a str,
    /// Task, goal and target, and the log as its only round.
    pub rounds: &'a RoundsInput<'a>,
    /// Facts about the log and its interpretation: name and value.
    pub facts: &'a [(String, String)],
    /// Assumptions, remarks, and doubts about the interpretation.
    pub notes: &'a [String],
}

/// Returns one self-contained HTML file, which loads nothing from the network.
pub fn log_page(input: &LogPageInput) -> String {
    let main = html! {
        h1 { (input.title) }
        table class="facts" {
            @for (name, value) in input.facts {
                tr { th scope="row" { (name) } td { (value) } }
            }
        }
        @for note in input.notes {
            p class="note" { (note) }
        }
        @for round in input.rounds.rounds {
            @for figure in draw_figures(input, round) {
                figure { (PreEscaped(figure)) }
            }
            (list_events(&round.interpretation.events))
        }
        footer class="note" {
            "Made by wisch from a log of tool poses and forces. The dirt is estimated from touch, without a camera."
        }
    };
    document(input.title, STYLE, &main)
}

fn draw_figures(input: &LogPageInput, round: &RoundView) -> Vec<String> {
    let figures = log_figures(input.rounds, round).into_iter();
    let drawn = figures.map(|figure| {
        let what = figure.what.clone();
        figure.standalone(&what, [GAP, GAP])
    });
    drawn.collect()
}

fn list_events(events: &[Event]) -> Markup {
    html! {
        @if !events.is_empty() {
            h2 { "Events" }
            div class="scroll" {
                table class="answers" {
                    thead { tr {
                        th scope="col" { "event" } th scope="col" { "from [s]" } th scope="col" { "to [s]" }
                        th scope="col" { "largest force [N]" }
                    } }
                    tbody {
                        @for event in events.iter().take(MAX_EVENTS) {
                            tr {
                                td { (words::kind_name(event.kind)) }
                                td { (format_decimal(event.start, 2)) } td { (format_decimal(event.end, 2)) }
                                td { (format_decimal(event.peak_force, 1)) }
                            }
                        }
                    }
                }
            }
            @if events.len() > MAX_EVENTS {
                p class="note" { "The table lists the first " (MAX_EVENTS) " of " (events.len()) " events." }
            }
        }
    }
}
