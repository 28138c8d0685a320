//! What is drawn of a run: one HTML file that asks nothing of the network, and the same pictures as files.

pub(crate) mod document;

use crate::draw::{View, WIDTH, grouped, legend, metres, percent, px, surface::dot_radius};
use crate::input::ReportInput;
use crate::motion::{joint_plots, motion_section, placements_plan};
use crate::prediction::chart::{self, across, down};
use crate::prediction::figures::{self, caption, moment_entries, snapshot, snapshots};
use crate::prediction::layers::Drawing;
use crate::prediction::player::{self, Player};
use crate::rounds::{self, RoundView, RoundsInput};
use document::document;
use maud::{Markup, PreEscaped, html};
use wisch::geometry::Vector2;
use wisch::represent::{GoalState, THICKNESS_TOLERANCE, Treatment};

/// Narrower than the surface, so that its numbers can be read on a phone.
const CHART_WIDTH: f64 = 480.0;
const SCRIPT: &str = include_str!("page.js");

/// The report as one HTML file: pictures, numbers and the effect over time.
pub fn page(input: &ReportInput) -> String {
    let drawing = Drawing::new(input);
    let rounds = input.rounds.map_or(&[][..], |rounds| rounds.rounds);
    let tracks = rounds.iter().filter_map(RoundView::track);
    let main = html! {
        (header(input))
        (metrics(input))
        @if let Some(motion) = input.motion { (motion_section(motion, tracks.collect())) }
        @if let Some(rounds) = input.rounds { (rounds::section(rounds)) }
        (surface(&drawing))
        (effect(&drawing))
        (density(&drawing))
        footer class="note" {
            "Predicted by wisch with the particle model of Leidner et al., "
            cite { "Cognition-enabled robotic wiping" }
            ", Robotics and Autonomous Systems 114 (2019). "
            @if input.rounds.is_some() {
                "What stands under “Round by round” was executed, and so was what the 3-D view shows as measured; all else was predicted."
            } @else {
                "Nothing on this page was measured on a robot."
            }
        }
    };
    document(input.title, "", &main)
}

/// The pictures of a run as (file stem, SVG).
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

fn header(input: &ReportInput) -> Markup {
    let task = input.task;
    let performance = input.prediction.performance;
    html! {
        h1 { (input.title) }
        p class="lead" {
            b { (task.action.as_str()) } " " (task.medium) " on " (task.surface.name)
            " with " (task.tool.name) ", nodes placed by " b { (input.plan.strategy.as_str()) }
        }
        @match input.rounds.and_then(|rounds| Some((rounds, rounds.rounds.last()?))) {
            Some((rounds, last)) => (felt(rounds, last, performance.ratio())),
            None => section class="result" {
                span class="number-large" { (percent(performance.ratio())) }
                div {
                    p class="verdict" { (verdict(input)) }
                    @for sentence in account(input) { p { (sentence) } }
                }
                div class="bar" { i style=(format!("width:{:.1}%", 100.0 * performance.ratio())) {} }
            },
        }
    }
}

/// The outcome of what was executed, by touch and, where something looked, by sight.
fn felt(rounds: &RoundsInput, last: &RoundView, predicted: f64) -> Markup {
    let estimate = last.interpretation.performance;
    let count = rounds.rounds.len();
    let senses = if last.interpretation.observation.is_some() {
        "By touch and sight"
    } else {
        "By touch"
    };
    html! {
        section class="result" {
            span class="number-large" { (percent(estimate.mean)) }
            div {
                p class="verdict" {
                    (senses) ", after " (counted(count, "round", "rounds")) ": "
                    (percent(estimate.low)) " to " (percent(estimate.high)) " with 90 % confidence."
                }
                p {
                    (percent(rounds.target)) " were wanted, " (percent(predicted))
                    " predicted for the first round."
                    @if let Some((_, truth)) = last.truth {
                        " In the simulated world it is really " (percent(truth)) "."
                    }
                }
            }
            div class="bar" { i style=(format!("width:{:.1}%", 100.0 * estimate.mean)) {} }
        }
    }
}

/// The performance in words.
fn verdict(input: &ReportInput) -> &'static str {
    let performance = input.prediction.performance;
    match performance.ratio() {
        _ if performance.initial == 0 => "There is nothing to wipe.",
        _ if input.plan.strokes.is_empty() => "The plan has no strokes: nothing will be wiped.",
        ratio if ratio >= 0.95 => "Nearly everything should end up where it is wanted.",
        ratio if ratio >= 0.8 => "Most of it should end up where it is wanted.",
        ratio if ratio >= 0.5 => "More than half of it should end up where it is wanted.",
        _ => "Less than half of it should end up where it is wanted.",
    }
}

/// How evenly a surface is treated, and what comes of it.
fn treatment_in_words(input: &ReportInput) -> String {
    let [mean, deviation] = Treatment::spread(&input.prediction.particles);
    let task = input.task;
    let per_pass = task.depth_per_pass();
    let depth = per_pass.map_or_else(String::new, |per_pass| {
        let [mean, deviation] = [mean, deviation].map(|passes| 1e6 * passes * per_pass);
        format!(
            ", {} µm with a deviation of {} µm",
            metres(mean, 3),
            metres(deviation, 3)
        )
    });
    format!(
        "On average it is {} passes with a deviation of {} from place to place{depth}.",
        metres(mean, 2),
        metres(deviation, 2)
    )
}

/// Where the particles go, counted.
fn account(input: &ReportInput) -> Vec<String> {
    let (plan, performance) = (input.plan, input.prediction.performance);
    if performance.initial == 0 {
        return Vec::new();
    }
    let kept = input.prediction.particles.tally().remaining;
    let all = format!(
        "Of {} particles, {}",
        grouped(performance.initial),
        grouped(performance.achieved)
    );
    let mut sentences = vec![match plan.graph.goal {
        GoalState::Absorbed => format!(
            "{all} {} taken up and {} on the surface.",
            verb(performance.achieved, "is", "are"),
            counted(kept, "stays", "stay")
        ),
        GoalState::Collected { radius, .. } => format!(
            "{all} {} within {} m of the goal node and {} elsewhere on the surface.",
            verb(performance.achieved, "ends", "end"),
            metres(radius, 3),
            counted(kept - performance.achieved.min(kept), "lies", "lie")
        ),
        GoalState::Skimmed => {
            format!(
                "{all} {} the surface over an allowed edge and {} on it.",
                verb(performance.achieved, "leaves", "leave"),
                counted(kept, "stays", "stay")
            )
        }
        GoalState::Polished { passes } => format!(
            "{all} places of the surface get {}. {}",
            counted(passes as usize, "pass", "passes"),
            treatment_in_words(input)
        ),
        GoalState::Emitted { thickness, .. } => format!(
            "{all} places of the surface get a coat within {} of {} mm. {}",
            percent(THICKNESS_TOLERANCE),
            metres(1e3 * thickness, 3),
            treatment_in_words(input)
        ),
    }];
    if performance.lost > 0 {
        sentences.push(match plan.graph.goal {
            GoalState::Emitted { .. } => {
                format!("{} too much.", counted(performance.lost, "gets", "get"))
            }
            _ => format!(
                "{} over an edge where nothing should.",
                counted(performance.lost, "falls", "fall")
            ),
        });
    }
    if plan.unreachable_share > 0.0 {
        sentences.push(format!(
            "{} of the particles lie further than {} m from every planned motion.",
            percent(plan.unreachable_share),
            metres(plan.collision_radius, 3)
        ));
    }
    if !plan.graph.unreachable.is_empty() {
        sentences.push(format!(
            "No clear way connects {} of {} nodes to the goal.",
            plan.graph.unreachable.len(),
            plan.graph.nodes.len()
        ));
    }
    sentences
}

/// The verb for one or for many.
fn verb(count: usize, one: &'static str, many: &'static str) -> &'static str {
    if count == 1 { one } else { many }
}

/// A count with its verb.
fn counted(count: usize, one: &'static str, many: &'static str) -> String {
    format!("{} {}", grouped(count), verb(count, one, many))
}

fn metrics(input: &ReportInput) -> Markup {
    html! {
        @if !input.facts.is_empty() {
            h2 { "In numbers" }
            table {
                tbody {
                    @for (label, value) in input.facts {
                        tr { th scope="row" { (label) } td { (value) } }
                    }
                }
            }
        }
    }
}

fn surface(drawing: &Drawing) -> Markup {
    let toggles = [
        ("show-before", "particles before"),
        ("show-after", "particles after"),
        ("show-graph", "nodes and edges"),
        ("show-order", "order of strokes"),
        ("show-tool", "tool"),
    ];
    let map = figures::map(drawing);
    html! {
        section class="map" {
            h2 { "The surface from above" }
            div class="toggles" {
                @for (id, label) in toggles {
                    label { input type="checkbox" id=(id) checked; (label) }
                }
            }
            (map.scrolling())
            @if drawing.thinning > 1 {
                p class="note" {
                    "Drawn is one particle in " (drawing.thinning) ", evenly over the list; all "
                    (grouped(drawing.input.prediction.performance.initial)) " are counted."
                }
            }
            @if !drawing.map_has_numbers() && !drawing.input.plan.strokes.is_empty() {
                p class="note" { "The tool is so small beside the surface that the strokes' numbers are left out." }
            }
        }
    }
}

fn effect(drawing: &Drawing) -> Markup {
    let frames = drawing.input.frames.all();
    let moments = snapshots(drawing);
    html! {
        h2 { "Effect over time" }
        @if frames.len() < 2 {
            p { "No motion was recorded, so there is nothing to play." }
        } @else {
            p { "What the tool is predicted to do to the particles, by distance wiped." }
            (player(drawing))
            h2 { "At a glance" }
        }
        div class="snapshots" {
            @for frame in moments {
                figure {
                    (snapshot(drawing, frame, 300.0).inline(&caption(frame)))
                    figcaption { (caption(frame)) }
                }
            }
        }
    }
}

/// Surface and tool in motion, slider, and the performance below with a cursor.
fn player(drawing: &Drawing) -> Markup {
    let frames = drawing.input.frames.all();
    let view = View::centred(drawing.bounds, Vector2::new(WIDTH, 520.0));
    let data = serde_json::to_string(&Player::new(drawing, &view)).unwrap_or_default();
    let step = player::step(drawing);
    let moved = frames
        .first()
        .map_or(0, |frame| frame.particles.len().div_ceil(step));
    let radius = dot_radius(&view, moved);
    let chart = chart::performance(drawing, CHART_WIDTH);
    let identity = wisch::geometry::PlanarPose::new(wisch::geometry::Point2::origin(), 0.0);
    let footprint = view
        .at_origin()
        .footprint(&drawing.input.task.tool.footprint, &identity);
    let every = drawing.input.frames.thinning() * step;
    let last = frames.last().map_or(0.0, |frame| frame.performance.ratio());
    html! {
        noscript { p class="note" { "Without scripts the player stands still; the snapshots below show the same." } }
        div id="player" hidden {
            figure class="whole" {
                svg viewBox=(format!("0 0 {} {}", px(WIDTH), px(view.height()))) role="img" aria-label="Particles and tool over time" {
                    (drawing.ground(&view))
                    path id="moving-trail" class="trail" {}
                    path id="moving-left" class="dots-left" stroke-width=(px(2.0 * radius)) {}
                    path id="moving-done" class="dots-done" stroke-width=(px(2.0 * radius)) {}
                    path id="moving-lost" class="mark-lost" data-radius=(px(radius)) {}
                    (drawing.obstacles(&view))
                    path id="moving-tool" class="tool" d=(footprint) {}
                    rect class="rule" x="0.5" y="0.5" width=(px(WIDTH - 1.0)) height=(px(view.height() - 1.0)) {}
                    (view.scale_bar())
                }
            }
            (legend::list(&moment_entries(drawing)))
            div class="controls" {
                button id="play" type="button" { "▶ Play" }
                input id="slider" type="range" min="0" max="1000" value="0" aria-label="Distance wiped";
                output id="moment" data-achieved=(drawing.achieved()) {}
            }
            figure class="whole narrow" {
                svg viewBox=(format!("0 0 {} {}", px(chart.width), px(chart.height))) role="img" aria-label="Performance over distance wiped" {
                    (chart.body)
                    g id="cursor" data-from=(px(across(0.0, 1.0, CHART_WIDTH))) data-to=(px(across(1.0, 1.0, CHART_WIDTH)))
                        data-top=(px(down(1.0))) data-bottom=(px(down(0.0))) {
                        path id="cursor-line" class="cursor" {}
                        circle id="cursor-dot" class="cursor-dot" r="5" cy=(px(down(last))) {}
                    }
                }
            }
        }
        @if every > 1 {
            p class="note" { "The player moves one particle in " (every) "; the curve counts all." }
        }
        script type="application/json" id="effect-data" { (PreEscaped(data)) }
        script { (PreEscaped(SCRIPT)) }
    }
}

fn density(drawing: &Drawing) -> Markup {
    html! {
        h2 { "Where the dirt is densest" }
        p {
            "Gaussian kernel density of the particles before wiping, bandwidth "
            (metres(drawing.bandwidth(), 3)) " m, with the nodes of the plan on top."
        }
        (figures::density_figure(drawing).scrolling())
    }
}
