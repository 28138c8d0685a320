//! A robot's motion on the page: in 3-D, over time, and where its base stands.

mod above;
#[cfg(test)]
pub(crate) mod demo;
mod followed;
mod input;
mod joints;
mod measured;
mod sampled;
#[cfg(test)]
mod tests;
mod track;
mod viewer;

pub use followed::ShownMotion;
pub use input::{Contact, MotionInput, Origin, ParticleFrame, Phase, Placement, RatedPlace};
pub use measured::MeasuredMotion;
pub(crate) use track::{Mark, MarkKind, Track};

use crate::draw::{Entry, Panel, legend};
use crate::scene::json;
use maud::{Markup, PreEscaped, html};
use sampled::SampledMotion;
use track::SampledTrack;
use viewer::ViewerRecord;

const STYLE: &str = include_str!("motion.css");
/// Built from the scripts beside it, see the note there.
const VIEWER: &str = include_str!("../../viewer/viewer.js");

/// The part of a page that shows the motion: in 3-D with a player, from above, and joint by joint. In 3-D it shows the
/// rounds that were executed; where none was, the plan.
pub(crate) fn motion_section<'a>(plan: &'a MotionInput<'a>, rounds: Vec<Track<'a>>) -> Markup {
    let are_rounds = !rounds.is_empty();
    let tracks = track::sampled(plan, rounds);
    if tracks.is_empty() {
        return html! {
            h2 { "The robot in motion" }
            p { "The motion has no samples, so there is nothing to play." }
        };
    }
    let above = above::panel(plan, &SampledMotion::new(plan));
    let joints = joints::panel(plan);
    let whose = html! { @if are_rounds { p class="note" { "As planned for the first round." } } };
    html! {
        style { (PreEscaped(STYLE)) }
        section class="motion" {
            h2 { "The robot in motion" }
            (viewer(plan, &tracks))
            @if let Some(above) = above {
                h2 { "Where the base stands" }
                (whose)
                figure class="scroll" { (above.inline("Base placements, seen from above")) }
            }
            h2 { "Joints over time" }
            (whose)
            figure class="scroll wide" { (joints.inline("Position and velocity of every joint over time")) }
        }
    }
}

/// Position and velocity of every moving joint over time, as SVG with light colours.
pub fn joint_plots(input: &MotionInput) -> String {
    let what = "Positions within their limits, velocities as a share of theirs";
    alone(input, &joints::panel(input), what)
}

/// Base positions, rated and chosen, with the scene round them from above, as SVG with light colours.
/// For a robot whose base stands still it shows where it stands.
pub fn placements_plan(input: &MotionInput) -> String {
    let panel = above::panel(input, &SampledMotion::new(input)).unwrap_or_else(Panel::empty);
    alone(input, &panel, "Where the base stands, seen from above")
}

fn alone(input: &MotionInput, panel: &Panel, what: &str) -> String {
    let title = format!("{}: {}", input.task.name, input.robot.name());
    panel.standalone(&title, what)
}

/// The 3-D view with its controls.
fn viewer<'a>(plan: &MotionInput<'a>, tracks: &'a [SampledTrack<'a>]) -> Markup {
    let (record, cuts) = ViewerRecord::new(plan, tracks);
    html! {
        noscript { p class="note" { "The moving picture needs scripts; the pictures below do not." } }
        p id="motion-none" class="note" hidden {
            "This browser shows no WebGL, which the moving picture needs; the pictures below do without."
        }
        div id="motion-view" hidden {
            (choice(tracks))
            div class="stage" {
                canvas id="motion-canvas" tabindex="0" role="img" aria-label="The robot in 3-D. Space plays and pauses, arrow keys move in time." {}
                div class="views" {
                    button id="motion-robot" type="button" { "Robot" }
                    button id="motion-surface" type="button" { "Surface" }
                    button id="motion-above" type="button" { "Above" }
                }
            }
            div class="controls" {
                button id="motion-play" type="button" { "▶ Play" }
                div class="timeline" {
                    input id="motion-slider" type="range" min="0" max="10000" value="0" aria-label="Time";
                    @for (i, track) in tracks.iter().enumerate() {
                        div class="strip" hidden[i > 0] { (track.strip()) }
                    }
                }
                label class="speed" {
                    "speed "
                    select id="motion-speed" {
                        @for (value, label) in [("0.5", "× 0.5"), ("1", "× 1"), ("2", "× 2"), ("4", "× 4")] {
                            option value=(value) selected[value == "1"] { (label) }
                        }
                    }
                }
                output id="motion-words" {}
            }
            (legend(tracks))
        }
        @for cut in &cuts { p class="note" { (cut) } }
        script type="application/json" id="motion-data" { (PreEscaped(json(&record))) }
        script { (PreEscaped(VIEWER)) }
    }
}

/// Which of several rounds is shown, and what that is.
fn choice(tracks: &[SampledTrack]) -> Markup {
    let numbers = tracks.iter().filter_map(|shown| shown.track.round);
    html! {
        @if tracks.len() > 1 {
            div class="rounds-shown" role="group" aria-label="Round" {
                span { "Round" }
                @for (i, number) in numbers.enumerate() {
                    button type="button" aria-pressed=(if i == 0 { "true" } else { "false" }) { (number) }
                }
            }
        }
        @for (i, track) in tracks.iter().enumerate() {
            @if let Some(caption) = track.caption(&tracks[0]) {
                p class="caption" hidden[i > 0] { (caption) }
            }
        }
    }
}

fn legend(tracks: &[SampledTrack]) -> Markup {
    let each = || tracks.iter().map(|shown| &shown.track);
    let has = |contact| {
        let mut phases = each().flat_map(|track| track.motion.phases);
        phases.any(|phase| phase.contact == contact)
    };
    let entries = [
        (has(Contact::Wiping), "phase-contact", "tool path, wiping"),
        (true, "phase-lifted", "tool path, lifted"),
        (true, "robot-arm", "arm with the tool"),
        (true, "robot-body", "rest of the robot"),
        (true, "obstacle", "scene"),
    ];
    let mut entries: Vec<Entry> = (entries.into_iter())
        .filter(|(shown, ..)| *shown)
        .map(|(_, class, label)| Entry {
            label: label.to_owned(),
            sample: html! { rect class=(class) x="3" y="-5" width="18" height="10" rx="2" {} },
        })
        .collect();
    let mut marks: Vec<&Mark> = each().flat_map(|track| &track.marks).collect();
    marks.sort_by_key(|mark| mark.name);
    marks.dedup_by_key(|mark| mark.name);
    entries.extend((marks.iter()).map(|mark| legend::area(mark.kind.class(), mark.name)));
    if (tracks.iter()).any(|shown| shown.surface_moved(&tracks[0]).is_some()) {
        let label = "outline of the surface as believed at first, where it was corrected";
        entries.push(legend::line("axis", label));
    }
    if each().any(|track| !track.motion.particles.is_empty()) {
        let particle = match each().next().and_then(|track| track.round) {
            Some(_) => "particle, as believed before the round, moved as predicted",
            None => "particle",
        };
        entries.push(legend::dot("dots-left", particle));
    }
    html! {
        ul class="legend" {
            (legend::items(&entries))
            li { span class="axis-x" { "x" } span class="axis-y" { "y" } span class="axis-z" { "z" } "world, 0.4 m long" }
        }
        p class="note" {
            "Drag to turn, two fingers or the right button to move, pinch or wheel to zoom (after a click). "
            "Space plays and pauses, ← and → move half a second. The grid on the floor is 0.5 m wide."
        }
    }
}
