//! What is drawn on the surface, layer by layer.

use super::ReportInput;
use super::contour::{Contours, rings};
use super::frames::{MAX_DRAWN, thinning};
use super::palette::BANDS;
use super::view::{Pen, View, px};
use maud::{Markup, html};
use wisch::geometry::{Bounds2, Point2, Vector2};
use wisch::plan::{DensityMap, FreeSpace, NodeRole, data_bandwidth};
use wisch::represent::{Fate, GoalState, Surface, Task};

/// A particle in a picture: where, and what became of it.
pub(super) type Particle = (Point2, Fate);

/// Everything of a run that is drawn, found once.
pub(super) struct Drawing<'a> {
    pub(super) input: &'a ReportInput<'a>,
    /// What is shown [m].
    pub(super) bounds: Bounds2,
    /// What is shown where the tool's start does not matter [m].
    pub(super) close: Bounds2,
    obstacles: Vec<Vec<Point2>>,
    before: Vec<Point2>,
    unreachable: Vec<Point2>,
    pub(super) after: Vec<Particle>,
    /// Every how many-th particle is drawn.
    pub(super) thinning: usize,
}

/// What becomes of a particle, as a colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Outcome {
    Left,
    Done,
    Lost,
    Gone,
}

impl<'a> Drawing<'a> {
    pub(super) fn new(input: &'a ReportInput<'a>) -> Self {
        let task = input.task;
        let radius = input.plan.collision_radius;
        let obstacles = obstacle_rings(task, radius);
        let thinning = thinning(task.particles.len(), MAX_DRAWN);
        let before: Vec<Point2> = task
            .particles
            .iter()
            .step_by(thinning)
            .map(|(p, _)| p)
            .collect();
        let unreachable = if input.plan.unreachable_share > 0.0 {
            let graph = &input.plan.graph;
            before
                .iter()
                .copied()
                .filter(|&p| !graph.reaches(p, radius))
                .collect()
        } else {
            Vec::new()
        };
        Self {
            input,
            bounds: bounds(input, Some(input.plan.tool_start)),
            close: bounds(input, None),
            obstacles,
            before,
            unreachable,
            after: input
                .prediction
                .particles
                .iter()
                .step_by(thinning)
                .collect(),
            thinning,
        }
    }

    pub(super) fn outcome(&self, particle: Particle) -> Outcome {
        let (goal, surface) = (&self.input.plan.graph.goal, &self.input.task.surface);
        outcome(goal, surface, particle)
    }

    /// What the performance counts, in two or three words.
    pub(super) fn achieved(&self) -> &'static str {
        achieved(&self.input.plan.graph.goal)
    }

    /// Radius of a particle that leaves room between `count` of them.
    pub(super) fn dot_radius(&self, view: &View, count: usize) -> f64 {
        dot_radius(view, count)
    }

    /// The surface, its edges, the goal and what stands on it.
    pub(super) fn ground(&self, view: &View) -> Markup {
        let (surface, goal) = (&self.input.task.surface, &self.input.plan.graph.goal);
        ground(view, surface, goal)
    }

    pub(super) fn obstacles(&self, view: &View) -> Markup {
        html! {
            @if !self.obstacles.is_empty() {
                path class="obstacle" d=(view.rings(self.obstacles.iter().map(Vec::as_slice))) {}
            }
        }
    }

    pub(super) fn has_obstacles(&self) -> bool {
        !self.obstacles.is_empty()
    }

    pub(super) fn has_unreachable(&self) -> bool {
        !self.unreachable.is_empty()
    }

    /// The particles before: hollow; struck through where no node or edge comes near.
    pub(super) fn before(&self, view: &View) -> Markup {
        let radius = self.dot_radius(view, self.before.len());
        let (mut hollow, mut struck) = (Pen::default(), Pen::default());
        for &p in &self.before {
            hollow.ring(view.at(p), radius);
        }
        for &p in &self.unreachable {
            struck.slash(view.at(p), radius + 2.0);
        }
        html! {
            path class="before" d=(hollow.path()) {}
            path class="mark-lost" d=(struck.path()) {}
        }
    }

    /// Particles as they lie at one moment: filled, by outcome.
    pub(super) fn particles(&self, view: &View, particles: &[Particle], radius: f64) -> Markup {
        let outcomes = particles.iter().map(|&p| (p.0, self.outcome(p)));
        self::particles(view, outcomes, radius)
    }

    /// Directed edges, an arrow on each.
    pub(super) fn edges(&self, view: &View) -> Markup {
        let graph = &self.input.plan.graph;
        let size = (0.13 * self.input.plan.collision_radius * view.scale).clamp(2.5, 7.0);
        let (mut lines, mut arrows) = (Pen::default(), Pen::default());
        for &(from, to) in &graph.edges {
            let (a, b) = (view.at(graph.position(from)), view.at(graph.position(to)));
            lines.line([a, b]);
            let (dx, dy) = (b.0 - a.0, b.1 - a.1);
            let length = dx.hypot(dy);
            if length < 2.5 * size {
                continue;
            }
            let (ux, uy) = (dx / length, dy / length);
            let tip = 0.5 * length + size;
            let point = |along: f64, across: f64| {
                (
                    a.0 + ux * along - uy * across,
                    a.1 + uy * along + ux * across,
                )
            };
            arrows.line([
                point(tip, 0.0),
                point(tip - 2.0 * size, 0.75 * size),
                point(tip - 1.5 * size, 0.0),
                point(tip - 2.0 * size, -0.75 * size),
            ]);
            arrows.close();
        }
        html! {
            path class="edge" style=[self.thin(view, "stroke-width:1")] d=(lines.path()) {}
            path class="arrow" d=(arrows.path()) {}
        }
    }

    /// Nodes: red where they cover, yellow where they are goals, hollow where nothing leads.
    pub(super) fn nodes(&self, view: &View) -> Markup {
        let graph = &self.input.plan.graph;
        let radius = self.node_radius(view);
        html! {
            @for (i, node) in graph.nodes.iter().enumerate() {
                @let (x, y) = view.at(node.position);
                @let class = match (graph.unreachable.contains(&i), node.role) {
                    (true, _) => "node-cut",
                    (false, NodeRole::Coverage) => "node",
                    (false, NodeRole::Goal) => "goal",
                };
                @let r = if node.role == NodeRole::Goal { 1.4 * radius } else { radius };
                circle class=(class) cx=(px(x)) cy=(px(y)) r=(px(r)) {}
            }
        }
    }

    fn node_radius(&self, view: &View) -> f64 {
        (0.1 * self.input.plan.collision_radius * view.scale).clamp(1.6, 5.0)
    }

    /// Whether there is room for the strokes' numbers.
    pub(super) fn numbers_fit(&self, view: &View) -> bool {
        self.input.plan.collision_radius * view.scale >= 22.0
    }

    /// A lighter hand where the tool is small beside the surface and lines lie close.
    fn thin(&self, view: &View, style: &'static str) -> Option<&'static str> {
        (!self.numbers_fit(view)).then_some(style)
    }

    /// Lifted moves, and the number of each stroke where it begins.
    pub(super) fn order(&self, view: &View) -> Markup {
        let plan = self.input.plan;
        let mut lifted = Pen::default();
        let mut tool = plan.tool_start;
        for stroke in &plan.strokes {
            if let (Some(first), Some(last)) = (stroke.poses.first(), stroke.poses.last()) {
                lifted.line([view.at(tool), view.at(first.position)]);
                tool = last.position;
            }
        }
        let radius = 2.0 * self.node_radius(view);
        html! {
            path class="lifted" style=[self.thin(view, "stroke-width:.6;stroke-opacity:.7")] d=(lifted.path()) {}
            @if self.numbers_fit(view) {
                @for (i, stroke) in plan.strokes.iter().enumerate() {
                    @if let Some(first) = stroke.poses.first() {
                        @let (x, y) = view.at(first.position);
                        @let size = if i < 99 { 1.2 * radius } else { 0.95 * radius };
                        circle class="node" cx=(px(x)) cy=(px(y)) r=(px(radius)) {}
                        text class="number" font-size=(px(size)) x=(px(x)) y=(px(y + 0.37 * size)) { (i + 1) }
                    }
                }
            }
        }
    }

    /// The tool at scale where it waits, on the robot's side.
    pub(super) fn tool_at_start(&self, view: &View) -> Markup {
        let Some(start) = self.input.frames.all().first() else {
            return html! {};
        };
        let pose = start.surface_from_tool;
        if !self.shows(pose.position) {
            return html! {};
        }
        let (x, y) = view.at(pose.position);
        let reach = self.input.plan.collision_radius * view.scale;
        html! {
            path class="tool" d=(view.footprint(&self.input.task.tool.footprint, &pose)) {}
            circle class="start" cx=(px(x)) cy=(px(y)) r="3" {}
            @if x + reach + 130.0 < view.left() + view.width() {
                text class="text small" x=(px(x + reach)) y=(px(y - 1.0)) { "tool start" }
                text class="text small quiet" x=(px(x + reach)) y=(px(y + 12.0)) { "robot's side" }
            } @else {
                text class="text small end" x=(px(x - reach)) y=(px(y - 1.0)) { "tool start" }
                text class="text small quiet end" x=(px(x - reach)) y=(px(y + 12.0)) { "robot's side" }
            }
        }
    }

    fn shows(&self, p: Point2) -> bool {
        let b = &self.bounds;
        (b.min.x..=b.max.x).contains(&p.x) && (b.min.y..=b.max.y).contains(&p.y)
    }

    /// Filled bands of the density (2), each a fixed share of the peak.
    pub(super) fn density(&self, view: &View) -> Markup {
        let outline = &self.input.task.surface.outline;
        let particles: Vec<Point2> = self.input.task.particles.remaining().collect();
        let Some(bounds) = Bounds2::of(outline.outer().iter().copied()) else {
            return html! {};
        };
        let map = DensityMap::new(&particles, bounds, self.bandwidth());
        let contours = Contours::new(&map);
        html! {
            clipPath id="on-surface" { path clip-rule="evenodd" d=(view.rings(outline.rings())) {} }
            g clip-path="url(#on-surface)" {
                @if contours.peak > 0.0 {
                    @for band in 1..=BANDS {
                        @let level = contours.peak * band as f64 / (BANDS + 1) as f64;
                        @let rings = contours.rings(level);
                        path class=(format!("contour band-{band}")) d=(view.rings(rings.iter().map(Vec::as_slice))) {}
                    }
                }
            }
        }
    }

    /// Bandwidth h of the density [m]: the one the plan was asked for, or that of the data.
    pub(super) fn bandwidth(&self) -> f64 {
        self.input.bandwidth.unwrap_or_else(|| {
            let particles: Vec<Point2> = self.input.task.particles.remaining().collect();
            data_bandwidth(&particles, self.input.plan.collision_radius)
        })
    }
}

/// The surface with the nodes, what was pushed off, and the tool's start if it is asked for and near.
fn bounds(input: &ReportInput, tool_start: Option<Point2>) -> Bounds2 {
    let outline = input.task.surface.outline.outer().iter().copied();
    let surface = Bounds2::of(outline.clone()).unwrap_or(Bounds2 {
        min: Point2::new(-0.5, -0.5),
        max: Point2::new(0.5, 0.5),
    });
    let radius = input.plan.collision_radius;
    let room = surface.size().norm().max(4.0 * radius);
    let near = |p: &Point2| {
        let beyond = (p - surface.center()).abs() - surface.size() / 2.0;
        beyond.x.max(beyond.y) < 0.6 * room
    };
    let around = |p: Point2, reach: f64| {
        let reach = Vector2::new(reach, reach);
        [p - reach, p + reach]
    };
    let nodes = input.plan.graph.nodes.iter().map(|n| n.position);
    let moved = input.prediction.particles.iter().map(|(p, _)| p);
    let shown = nodes
        .chain(tool_start)
        .filter(near)
        .flat_map(|p| around(p, radius))
        .chain(moved.filter(near).flat_map(|p| around(p, 0.2 * radius)))
        .chain(outline.flat_map(|p| around(p, 0.35 * radius)));
    Bounds2::of(shown).unwrap_or(surface)
}

/// What stands on the surface, as rings in its frame [m].
pub(super) fn obstacle_rings(task: &Task, collision_radius: f64) -> Vec<Vec<Point2>> {
    let scene: Vec<_> = task.obstacles_in_surface().collect();
    // A scene that the collision library refuses has no plan and never comes here.
    FreeSpace::new(&task.surface, &scene, collision_radius)
        .map(|space| {
            let sections = space.occupied().sections().iter();
            sections.flat_map(|edges| rings(edges)).collect()
        })
        .unwrap_or_default()
}

/// What a particle's fate is worth for the goal.
pub(super) fn outcome(goal: &GoalState, surface: &Surface, particle: Particle) -> Outcome {
    let (position, fate) = particle;
    match fate {
        Fate::Absorbed => Outcome::Gone,
        _ if goal.is_met_by(position, fate, surface) => Outcome::Done,
        Fate::OffSurface { .. } => Outcome::Lost,
        Fate::OnSurface => Outcome::Left,
    }
}

/// What the performance counts, in two or three words.
pub(super) fn achieved(goal: &GoalState) -> &'static str {
    match goal {
        GoalState::Absorbed => "taken up",
        GoalState::Collected { .. } => "at the goal",
        GoalState::Skimmed => "over the allowed edge",
    }
}

/// Radius of a particle that leaves room between `count` of them.
pub(super) fn dot_radius(view: &View, count: usize) -> f64 {
    let room = view.width() * view.height() / count.max(1) as f64;
    (0.07 * room.sqrt()).clamp(0.9, 3.2)
}

/// The surface, its edges and the goal.
pub(super) fn ground(view: &View, surface: &Surface, goal: &GoalState) -> Markup {
    let outline = view.rings(surface.outline.rings());
    let edges: Vec<_> = surface.outline.edges().collect();
    let skim = surface.skim_edges.iter().filter_map(|&i| edges.get(i));
    let reach = match *goal {
        GoalState::Collected { center, radius } => Some((view.at(center), radius)),
        GoalState::Absorbed | GoalState::Skimmed => None,
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

/// Particles, filled, by what became of them.
pub(super) fn particles(
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
