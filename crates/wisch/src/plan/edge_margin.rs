//! Dirt that is pushed so near an edge, or the rim of the goal, that part of its heap may go beyond it.

use crate::geometry::{Edge, Point2, Polygon, Pose, Vector2};
use crate::represent::{
    Fate, GoalState, HEAP_DEPTH, ParticleDistribution, ParticleField, Surface, heap_depth,
    heap_slide,
};

/// Depth of a heap of all particles ahead of the place to which it is pushed, over the radius of
/// the tool's collision sphere [1]. It lies between the depths of the belief (up to 0.12) and
/// [`HEAP_DEPTH`]. An assumption; with [`HEAP_DEPTH`], single strokes leave more dirt away from the
/// goal (performance of 87.5 % instead of 90 % on the board, seed 3).
const RIM_DEPTH: f64 = 0.2;
/// Positions of the particles of a heap within its depth [1].
const HEAP_PLACES: [f64; 4] = [0.125, 0.375, 0.625, 0.875];

/// The strip along the edges over which no dirt may fall, as wide as a heap is deep.
#[derive(Debug, Clone)]
pub(super) struct EdgeMargin {
    edges: Vec<Edge>,
    /// Depth of a heap of all particles [m].
    heap: f64,
    before: ParticleDistribution,
    /// Particles that the last motion pushed, and their positions before it.
    pushed: Vec<(usize, Point2)>,
    /// Largest nearness of each particle to an edge so far, over the width of the margin [1].
    nearness: Vec<f64>,
    world_from_surface: Pose,
    /// Depth of the heap ahead of each particle, in the direction of its last push and down a slope [m].
    ahead: Vec<Vector2>,
}

impl EdgeMargin {
    /// Returns the margin for dirt at these places. `radius`: that of the collision sphere [m].
    pub(super) fn new(
        particles: &ParticleDistribution,
        surface: &Surface,
        goal: &GoalState,
        radius: f64,
    ) -> Self {
        let is_allowed = |edge: usize| *goal == GoalState::Skimmed && surface.is_skim_edge(edge);
        let edges = surface.outline.edges().enumerate();
        Self {
            edges: edges
                .filter(|&(index, _)| !is_allowed(index))
                .map(|(_, edge)| edge)
                .collect(),
            heap: HEAP_DEPTH * radius,
            world_from_surface: surface.world_from_surface,
            nearness: vec![0.0; particles.len()],
            ahead: vec![Vector2::zeros(); particles.len()],
            before: particles.clone(),
            pushed: Vec::new(),
        }
    }

    /// Updates the margin with the positions after a motion. `moved`: indices of all particles that
    /// moved; an index may occur more than once.
    pub(super) fn pass_of(
        &mut self,
        after: &ParticleField,
        moved: impl IntoIterator<Item = usize>,
    ) {
        self.pushed.clear();
        for i in moved {
            let (place, fate) = after.place(i);
            let from = self.before.position(i);
            if fate == Fate::OnSurface && place != from {
                self.pushed.push((i, from));
            }
            self.before.put(i, place, fate);
        }
        let share = self.pushed.len() as f64 / self.before.len().max(1) as f64;
        // The margin is as wide as the heap of the particles that this motion pushed is deep.
        let width = heap_depth(self.heap, share);
        for &(i, from) in &self.pushed {
            let (place, _) = after.place(i);
            let distances = self.edges.iter().map(|edge| edge.distance(place));
            let distance = distances.fold(width, f64::min);
            // Nearness 1 − d / width: 0 at the border of the margin, 1 at the edge.
            self.nearness[i] = self.nearness[i].max(1.0 - distance / width);
            let along = (place - from).normalize();
            let reach = along + heap_slide(&self.world_from_surface, along);
            self.ahead[i] = reach * (width * RIM_DEPTH / HEAP_DEPTH);
        }
    }

    /// Sum of the particles' largest nearness to an edge, each over the width of the margin [1].
    pub(super) fn nearness(&self) -> f64 {
        self.nearness.iter().sum()
    }

    /// Number of particles within the goal of a collect whose heap reaches beyond the goal, each counted by
    /// that share of its heap.
    pub(super) fn beyond(&self, goal: &GoalState, outline: &Polygon) -> f64 {
        let GoalState::Collected { center, radius } = goal else {
            return 0.0;
        };
        let is_met = |place: Point2| (place - center).norm() <= *radius;
        // Particles beyond an edge are counted by their nearness instead.
        let is_beyond = |place: &Point2| !is_met(*place) && outline.contains(*place);
        let share_beyond = |(place, ahead): (Point2, &Vector2)| {
            let places = HEAP_PLACES.map(|share| place + ahead * share);
            places.iter().filter(|place| is_beyond(place)).count() as f64 / places.len() as f64
        };
        let places = (self.before.iter().zip(&self.ahead))
            .filter(|((place, fate), _)| *fate == Fate::OnSurface && is_met(*place));
        places
            .map(|((place, _), ahead)| share_beyond((place, ahead)))
            .sum()
    }
}
