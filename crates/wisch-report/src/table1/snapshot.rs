//! Small pictures of a wiped surface: particles before or after, and the strokes.

use crate::draw::legend::{self, Entry};
use crate::draw::surface::{self, Outcome};
use crate::draw::{Panel, Pen, View, inset, px};
use maud::{Markup, html};
use wisch::geometry::{Bounds2, Point2, Vector2};
use wisch::represent::{GoalState, Task};

/// Maximum size of a picture.
const SIZE: [f64; 2] = [300.0, 300.0];
/// Minimum and maximum radius of a particle.
const RADIUS: [f64; 2] = [1.6, 3.0];

/// A surface with its particles before and after, in its own frame \[m\].
#[derive(Debug, Clone)]
pub struct WipedSurface<'a> {
    /// Surface and scene.
    pub task: &'a Task,
    /// The goal.
    pub goal: GoalState,
    /// Radius of the collision sphere \[m\].
    pub collision_radius: f64,
    /// Path of the tool centre point for each stroke.
    pub strokes: Vec<Vec<Point2>>,
    /// Particles before wiping.
    pub before: Vec<Point2>,
    /// Particles that have not reached the goal.
    pub left: Vec<Point2>,
    /// Particles that have reached the goal.
    pub done: Vec<Point2>,
    /// Particles lost over an edge that is not a skim edge.
    pub lost: Vec<Point2>,
}

impl WipedSurface<'_> {
    /// Draws the surface before wiping.
    pub(super) fn before(&self) -> Panel {
        self.panel(|view| {
            let mut rings = Pen::default();
            for &particle in &self.before {
                rings.ring(view.at(particle), self.radius(view));
            }
            html! { path class="before" d=(rings.path()) {} }
        })
    }

    /// Draws the surface after wiping.
    pub(super) fn after(&self) -> Panel {
        self.panel(|view| {
            let of = |places: &'_ [Point2], outcome: Outcome| {
                places
                    .iter()
                    .map(move |&place| (place, outcome))
                    .collect::<Vec<_>>()
            };
            let all = [
                of(&self.left, Outcome::Left),
                of(&self.done, Outcome::Done),
                of(&self.lost, Outcome::Lost),
            ];
            html! {
                @for stroke in &self.strokes {
                    path class="trail" d=(view.line(stroke.iter().copied())) {}
                }
                (surface::particles(view, all.concat(), self.radius(view)))
            }
        })
    }

    fn radius(&self, view: &View) -> f64 {
        surface::dot_radius(view, self.before.len()).clamp(RADIUS[0], RADIUS[1])
    }

    /// Draws the surface with marks.
    fn panel(&self, marks: impl Fn(&View) -> Markup) -> Panel {
        let reach = Vector2::new(self.collision_radius, self.collision_radius);
        let extent = surface::extent(&self.task.surface);
        let shown = Bounds2 {
            min: extent.min - reach,
            max: extent.max + reach,
        };
        let view = View::fit(shown, 0.0, 0.0, SIZE.into());
        let obstacles = surface::obstacle_rings(self.task, self.collision_radius);
        let body = html! {
            (surface::draw_ground(&view, &self.task.surface, &self.goal))
            (marks(&view))
            @if !obstacles.is_empty() {
                path class="obstacle" d=(view.rings(obstacles.iter().map(Vec::as_slice))) {}
            }
        };
        Panel {
            width: view.width(),
            height: view.height(),
            body: html! {
                (inset(&view, body))
                rect class="rule" x="0.5" y="0.5" width=(px(view.width() - 1.0)) height=(px(view.height() - 1.0)) {}
            },
        }
    }
}

/// Returns the legend.
pub(super) fn entries() -> Vec<Entry> {
    vec![
        Entry {
            label: "before".to_owned(),
            sample: html! { circle class="before" cx="12" cy="0" r="3.6" {} },
        },
        legend::dot("dots-left", "after, goal not reached"),
        legend::dot("dots-done", "after, goal reached"),
        Entry {
            label: "lost over another edge".to_owned(),
            sample: html! { path class="mark-lost" d="M8.5-3.5l7 7m0-7l-7 7" {} },
        },
        legend::line("trail", "path of the tool in contact"),
        legend::area("goal-reach", "goal area"),
        legend::area("obstacle", "obstacle"),
    ]
}
