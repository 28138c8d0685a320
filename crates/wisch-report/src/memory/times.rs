//! The timeline of an episode.

use crate::draw::{axes, decimals, px, tick_step};
use maud::{Markup, html};
use wisch_memory::view::{Occurrence, ShownEpisode};

const WIDTH: f64 = 900.0;
const LEFT: f64 = 118.0;
const RIGHT: f64 = 14.0;
const LANE: f64 = 24.0;
const TOP: f64 = 22.0;
/// Minimum width of a mark.
const THIN: f64 = 2.0;

/// Lanes from above: label, classes, and CSS class of their marks. Lanes without marks are omitted.
const LANES: [(&str, &[&str], &str); 12] = [
    ("rounds", &["WipingRound"], "bar-estimated"),
    ("strokes", &["Stroke"], "phase-contact"),
    (
        "other motions",
        &["Approach", "Transfer", "Drive", "Retreat", "Motion"],
        "phase-lifted",
    ),
    ("contact", &["ToolContact"], "event-contact"),
    ("contact loss", &["ContactLoss"], "event-loss"),
    ("stick-slip", &["StickSlip"], "event-stick"),
    ("landings", &["Landing"], "event-loss"),
    ("overloads", &["Overload"], "event-loss"),
    ("vibrations", &["Vibration"], "event-loss"),
    (
        "stops, localising",
        &["ProtectiveStop", "Relocalization"],
        "event-push",
    ),
    ("hand guiding", &["HandGuiding"], "event-push"),
    ("collisions", &[], "event-collision"),
];

/// Draws the timeline of an episode.
pub(crate) fn draw_timeline(episode: &ShownEpisode) -> Markup {
    let [start, end] = episode.interval;
    let length = (end - start).max(f64::MIN_POSITIVE);
    let scale = (WIDTH - LEFT - RIGHT) / length;
    let across = |time: f64| LEFT + (time - start).clamp(0.0, length) * scale;
    let marks = |classes: &'static [&'static str]| {
        let of_lane = move |occurrence: &&Occurrence| {
            if classes.is_empty() {
                occurrence.is_collision
            } else {
                !occurrence.is_collision && classes.contains(&occurrence.class.as_str())
            }
        };
        episode
            .occurrences
            .iter()
            .filter(of_lane)
            .collect::<Vec<_>>()
    };
    let lanes: Vec<_> = (LANES.iter())
        .map(|(label, classes, look)| (label, marks(classes), look))
        .filter(|(_, marks, _)| !marks.is_empty())
        .collect();
    let bottom = TOP + LANE * lanes.len() as f64;
    let step = tick_step(length / 8.0);
    let digits = decimals(step);
    let ticks = (0..=(length / step + 1e-9) as usize).map(|tick| {
        let time = tick as f64 * step;
        (across(start + time), format!("{time:.digits$}"))
    });
    html! {
        figure class="scroll" {
            svg viewBox=(format!("0 0 {} {}", px(WIDTH), px(bottom + 44.0))) role="img"
                aria-label=(format!("Timeline of {}", episode.id)) {
                @for (row, (label, marks, look)) in lanes.iter().enumerate() {
                    @let y = TOP + LANE * row as f64;
                    rect class="lane" x=(px(LEFT)) y=(px(y + 3.0)) width=(px(WIDTH - LEFT - RIGHT)) height=(px(LANE - 6.0)) {}
                    text class="text small quiet end" x=(px(LEFT - 8.0)) y=(px(y + LANE / 2.0 + 4.0)) { (label) }
                    @for mark in marks {
                        @let [from, to] = mark.interval.map(across);
                        rect class=(look) x=(px(from)) y=(px(y + 3.0)) width=(px((to - from - 0.6).max(THIN))) height=(px(LANE - 6.0)) {
                            title { (mark.name) ": " (format!("{:.2} to {:.2} s", mark.interval[0] - start, mark.interval[1] - start)) }
                        }
                    }
                }
                @for [from, to] in &episode.looked {
                    @let (from, to) = (across(*from), across(*to));
                    @if to - from > 1.0 {
                        rect class="looked" x=(px(from)) y=(px(TOP - 4.0)) width=(px(to - from)) height=(px(bottom - TOP + 8.0)) {}
                    } @else {
                        path class="looked-at" d=(format!("M{} {}V{}", px(from), px(TOP - 8.0), px(bottom + 4.0))) {}
                    }
                }
                path class="axis" d=(format!("M{} {}H{}", px(LEFT), px(bottom + 4.0), px(WIDTH - RIGHT))) {}
                (axes::below(ticks, bottom + 4.0, 18.0))
                text class="text small quiet end" x=(px(WIDTH - RIGHT)) y=(px(bottom + 38.0)) { "since the episode began [s]" }
                @if !episode.looked.is_empty() {
                    text class="text small quiet" x=(px(LEFT)) y=(px(bottom + 38.0)) { "framed: intervals of the query" }
                }
            }
        }
    }
}
