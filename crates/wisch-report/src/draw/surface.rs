//! The surface from above, with obstacles and particles.

use super::contour::join_edges;
use super::numbers::px;
use super::view::{Pen, View};
use maud::{Markup, html};
use wisch::geometry::{Bounds2, Point2};
use wisch::plan::FreeSpace;
use wisch::represent::{Fate, GoalState, Surface, Task};

/// A particle in a picture: its position and fate.
pub(crate) type Particle = (Point2, Fate);

/// The outcome of a particle, which determines its colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Outcome {
    Left,
    Done,
    Lost,
    Gone,
}

/// Returns the bounding box of a surface in its frame [m].
pub(crate) fn extent(surface: &Surface) -> Bounds2 {
    Bounds2::from_points(surface.outline.outer().iter().copied()).unwrap_or(Bounds2 {
        min: Point2::new(-0.5, -0.5),
        max: Point2::new(0.5, 0.5),
    })
}

/// Returns the obstacles on the surface as rings in its frame [m].
pub(crate) fn obstacle_rings(task: &Task, collision_radius: f64) -> Vec<Vec<Point2>> {
    let scene: Vec<_> = task.obstacles_in_surface().collect();
    // A scene that the collision library rejects has no plan, so it cannot occur here.
    FreeSpace::new(&task.surface, &scene, collision_radius)
        .map(|space| {
            let sections = space.occupied_area().sections().iter();
            sections.flat_map(|edges| join_edges(edges)).collect()
        })
        .unwrap_or_default()
}

/// Returns the outcome of a particle's fate for the goal.
pub(crate) fn outcome(goal: &GoalState, surface: &Surface, particle: Particle) -> Outcome {
    let (position, fate) = particle;
    match fate {
        Fate::Absorbed => Outcome::Gone,
        _ if goal.is_met_by(position, fate, surface) => Outcome::Done,
        _ if goal.is_lost(fate) => Outcome::Lost,
        _ => Outcome::Left,
    }
}

/// Label of particles that have reached the goal.
pub(crate) fn achieved_label(goal: &GoalState) -> &'static str {
    match goal {
        GoalState::Absorbed => "absorbed",
        GoalState::Collected { .. } => "in the goal area",
        GoalState::Skimmed => "over the skim edge",
        GoalState::Polished { .. } => "polished",
        GoalState::Dispensed { .. } => "coated",
    }
}

/// Label of particles that have not reached the goal.
pub(crate) fn open_label(goal: &GoalState) -> &'static str {
    match goal {
        GoalState::Polished { .. } => "still to be polished",
        GoalState::Dispensed { .. } => "still to be coated",
        _ => "still to be wiped",
    }
}

/// Label of lost particles.
pub(crate) fn lost_label(goal: &GoalState) -> &'static str {
    match goal {
        GoalState::Dispensed { .. } => "coated too thickly",
        _ => "lost over another edge",
    }
}

/// Returns the radius of a particle's dot that leaves gaps between `count` particles.
pub(crate) fn dot_radius(view: &View, count: usize) -> f64 {
    let area = view.width() * view.height() / count.max(1) as f64;
    (0.07 * area.sqrt()).clamp(0.9, 3.2)
}

/// Draws the surface, its edges and the goal.
pub(crate) fn draw_ground(view: &View, surface: &Surface, goal: &GoalState) -> Markup {
    let outline = view.rings(surface.outline.rings());
    let edges: Vec<_> = surface.outline.edges().collect();
    let skim = surface.skim_edges.iter().filter_map(|&i| edges.get(i));
    let reach = match *goal {
        GoalState::Collected { center, radius } => Some((view.at(center), radius)),
        _ => None,
    };
    html! {
        path class="surface" fill-rule="evenodd" d=(outline) {}
        path class="outline" d=(outline) {}
        @if *goal == GoalState::Skimmed {
            @for edge in skim {
                @let line = view.line([edge.start, edge.end]);
                path class="skim-edge" d=(line) {}
                path class="skim-core" d=(line) {}
            }
        }
        @if let Some(((x, y), radius)) = reach {
            circle class="goal-reach" cx=(px(x)) cy=(px(y)) r=(px(radius * view.scale)) {}
        }
    }
}

/// Draws particles as filled dots, by outcome.
pub(crate) fn particles(
    view: &View,
    particles: impl IntoIterator<Item = (Point2, Outcome)>,
    radius: f64,
) -> Markup {
    let (mut left, mut done, mut lost) = (Pen::default(), Pen::default(), Pen::default());
    for (position, outcome) in particles {
        let at = view.at(position);
        match outcome {
            Outcome::Left => left.dot(at),
            Outcome::Done => done.dot(at),
            Outcome::Lost => lost.cross(at, radius),
            Outcome::Gone => {}
        }
    }
    html! {
        path class="dots-left" stroke-width=(px(2.0 * radius)) d=(left.path()) {}
        path class="dots-done" stroke-width=(px(2.0 * radius)) d=(done.path()) {}
        path class="mark-lost" d=(lost.path()) {}
    }
}
