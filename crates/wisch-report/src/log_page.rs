//! A log of wiping as one page: the path, the force, the plane, and what was wiped.

use crate::draw::{GAP, metres};
use crate::page::document::document;
use crate::rounds::{RoundView, RoundsInput, log_figures, words};
use maud::{Markup, PreEscaped, html};
use wisch::interpret::Event;

/// Most events of the table.
const MAX_EVENTS: usize = 500;
const STYLE: &str = "table.facts th { text-align: left; padding-right: 1.5em; font-weight: normal; vertical-align: top; } \
                     figure { margin: 1.5em 0; } figure svg { max-width: 100%; height: auto; }";

/// What the page of a log is made of.
#[derive(Debug, Clone, Copy)]
pub struct LogPageInput<'a> {
    /// Headline.
    pub title: &'a str,
    /// Task, goal and target, and the log as its only round.
    pub rounds: &'a RoundsInput<'a>,
    /// What is said of the log and its interpretation: name and value.
    pub facts: &'a [(String, String)],
    /// What was assumed, is odd, or speaks against the interpretation.
    pub notes: &'a [String],
}

/// Returns one HTML file that asks nothing of the network.
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
            @for figure in figures(input, round) {
                figure { (PreEscaped(figure)) }
            }
            (events(&round.interpretation.events))
        }
        footer class="note" {
            "Made by wisch from a log of poses and forces. What was wiped is estimated from touch: no camera is assumed."
        }
    };
    document(input.title, STYLE, &main)
}

fn figures(input: &LogPageInput, round: &RoundView) -> Vec<String> {
    let figures = log_figures(input.rounds, round).into_iter();
    let drawn = figures.map(|figure| {
        let what = figure.what.clone();
        figure.standalone(&what, [GAP, GAP])
    });
    drawn.collect()
}

fn events(events: &[Event]) -> Markup {
    html! {
        @if !events.is_empty() {
            h2 { "What happened" }
            div class="scroll" {
                table class="answers" {
                    thead { tr {
                        th scope="col" { "event" } th scope="col" { "from [s]" } th scope="col" { "to [s]" }
                        th scope="col" { "largest force [N]" }
                    } }
                    tbody {
                        @for event in events.iter().take(MAX_EVENTS) {
                            tr {
                                td { (words::kind(event.kind)) }
                                td { (metres(event.start, 2)) } td { (metres(event.end, 2)) }
                                td { (metres(event.peak_force, 1)) }
                            }
                        }
                    }
                }
            }
            @if events.len() > MAX_EVENTS {
                p class="note" { "The first " (MAX_EVENTS) " of " (events.len()) " events are listed." }
            }
        }
    }
}
