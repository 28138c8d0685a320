//! A robot's motion on the page: in 3-D, over time, and where its base stands.

mod above;
#[cfg(test)]
mod demo;
mod hull;
mod joints;
mod mesh;
mod record;
mod tempo;
#[cfg(test)]
mod tests;

pub(super) use mesh::{Thinned, thinned};

use super::panel::Panel;
use maud::{Markup, PreEscaped, html};
use record::ViewerRecord;
use tempo::Frames;
use wisch::follow::TrajectorySample;
use wisch::geometry::{Point2, Pose};
use wisch::represent::Task;
use wisch::robot::{LinkId, RobotModel};

const STYLE: &str = include_str!("motion.css");
/// Built from `../viewer`, see the note there.
const VIEWER: &str = include_str!("../viewer.js");

/// A motion of a robot that wipes, as it is shown.
#[derive(Debug, Clone, Copy)]
pub struct MotionInput<'a> {
    /// The robot.
    pub robot: &'a RobotModel,
    /// Where its root stands.
    pub world_from_root: Pose,
    /// Surface, scene and tool.
    pub task: &'a Task,
    /// The link that holds the tool, one of the robot's.
    pub tool_link: LinkId,
    /// Where the tool is on it.
    pub link_from_tool: Pose,
    /// Positions, velocities and accelerations of all n variables of the robot, by rising time.
    /// What is of another length, not finite or out of order is left out.
    pub samples: &'a [TrajectorySample],
    /// What is done when, by rising time.
    pub phases: &'a [Phase],
    /// Where the base is placed, in this order; none for a robot that stands still.
    pub placements: &'a [Placement],
    /// Where the base could have been placed.
    pub ratings: &'a [RatedPlace],
    /// The particles over time, by rising time.
    pub particles: &'a [ParticleFrame],
}

/// A stretch of time with a name.
#[derive(Debug, Clone, PartialEq)]
pub struct Phase {
    /// What is done, for the reader.
    pub name: String,
    /// When it begins [s].
    pub start: f64,
    /// When it ends [s].
    pub end: f64,
    /// Whether the tool wipes.
    pub contact: Contact,
    /// The stroke that is wiped, counted from 0 as in the plan; `None` between strokes.
    pub stroke: Option<usize>,
}

/// Whether the tool touches the surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Contact {
    /// It does.
    Wiping,
    /// It does not.
    Lifted,
}

/// Where the robot's base stands, in the world.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placement {
    /// East of the origin [m].
    pub x: f64,
    /// North of the origin [m].
    pub y: f64,
    /// Turn about the vertical [rad].
    pub yaw: f64,
}

/// A place where the base could stand, in the world.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RatedPlace {
    /// East of the origin [m].
    pub x: f64,
    /// North of the origin [m].
    pub y: f64,
    /// How good it is, from 0 to 1.
    pub rating: f64,
    /// Whether something stands in its way.
    pub blocked: bool,
}

/// The particles that remain on the surface at one time.
#[derive(Debug, Clone, PartialEq)]
pub struct ParticleFrame {
    /// When [s].
    pub time: f64,
    /// Where they lie, in the surface frame [m].
    pub positions: Vec<Point2>,
}

/// The part of a page that shows the motion: in 3-D with a player, from above, and joint by joint.
pub fn motion_section(input: &MotionInput) -> Markup {
    let frames = Frames::new(input);
    if frames.is_empty() {
        return html! {
            h2 { "The robot in motion" }
            p { "The motion has no samples, so there is nothing to play." }
        };
    }
    let above = above::panel(input, &frames);
    let joints = joints::panel(input);
    html! {
        style { (PreEscaped(STYLE)) }
        section class="motion" {
            h2 { "The robot in motion" }
            (viewer(input, &frames))
            @if let Some(above) = above {
                h2 { "Where the base stands" }
                figure class="scroll" { (above.inline("Base placements, seen from above")) }
            }
            h2 { "Joints over time" }
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
    let panel = above::panel(input, &Frames::new(input)).unwrap_or_else(Panel::empty);
    alone(input, &panel, "Where the base stands, seen from above")
}

fn alone(input: &MotionInput, panel: &Panel, what: &str) -> String {
    let title = format!("{}: {}", input.task.name, input.robot.name());
    panel.standalone(&title, what)
}

/// The 3-D view with its controls.
fn viewer(input: &MotionInput, frames: &Frames) -> Markup {
    let (record, cuts) = ViewerRecord::new(input, frames);
    // Names may hold anything, "</script>" too; in JSON a "<" occurs only within texts.
    let data = serde_json::to_string(&record).unwrap_or_default();
    let data = data.replace('<', "\\u003c");
    html! {
        noscript { p class="note" { "The moving picture needs scripts; the pictures below do not." } }
        p id="motion-none" class="note" hidden {
            "This browser shows no WebGL, which the moving picture needs; the pictures below do without."
        }
        div id="motion-view" hidden {
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
                    (strip(input, frames))
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
            (legend(input))
        }
        @for cut in &cuts { p class="note" { (cut) } }
        script type="application/json" id="motion-data" { (PreEscaped(data)) }
        script { (PreEscaped(VIEWER)) }
    }
}

/// Below the slider: when the tool wipes, and when it is lifted.
fn strip(input: &MotionInput, frames: &Frames) -> Markup {
    let share = |time: f64| frames.share(time);
    html! {
        svg class="strip" viewBox="0 0 1000 6" preserveAspectRatio="none" aria-hidden="true" {
            @for phase in input.phases {
                @let (from, to) = (1000.0 * share(phase.start), 1000.0 * share(phase.end));
                rect class=(phase.contact.class()) x=(format!("{from:.1}")) width=(format!("{:.1}", (to - from).max(0.0))) height="6" {
                    title { (phase.name) }
                }
            }
        }
    }
}

impl Contact {
    /// Class of what is filled in its colour.
    const fn class(self) -> &'static str {
        match self {
            Self::Wiping => "phase-contact",
            Self::Lifted => "phase-lifted",
        }
    }
}

fn legend(input: &MotionInput) -> Markup {
    let has = |contact| input.phases.iter().any(|phase| phase.contact == contact);
    let entries = [
        (has(Contact::Wiping), "phase-contact", "tool path, wiping"),
        (true, "phase-lifted", "tool path, lifted"),
        (true, "robot-arm", "arm with the tool"),
        (true, "robot-body", "rest of the robot"),
        (true, "obstacle", "scene"),
    ];
    html! {
        ul class="legend" {
            @for (_, class, label) in entries.into_iter().filter(|(shown, ..)| *shown) {
                li {
                    svg viewBox="0 -9 24 18" width="24" height="18" aria-hidden="true" {
                        rect class=(class) x="3" y="-5" width="18" height="10" rx="2" {}
                    }
                    (label)
                }
            }
            @if !input.particles.is_empty() {
                li {
                    svg viewBox="0 -9 24 18" width="24" height="18" aria-hidden="true" {
                        path class="dots-left" stroke-width="7" d="M12 0h0" {}
                    }
                    "particle"
                }
            }
            li { span class="axis-x" { "x" } span class="axis-y" { "y" } span class="axis-z" { "z" } "world, 0.4 m long" }
        }
        p class="note" {
            "Drag to turn, two fingers or the right button to move, pinch or wheel to zoom (after a click). "
            "Space plays and pauses, ← and → move half a second. The grid on the floor is 0.5 m wide."
        }
    }
}
