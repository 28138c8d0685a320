//! Layers of a drawing of the surface.

use super::frames::kept_particles;
use crate::draw::{
    BANDS, Contours, Pen, View, WIDTH, px,
    surface::{self, Outcome, Particle},
};
use crate::input::ReportInput;
use maud::{Markup, html};
use wisch::geometry::{Bounds2, Point2, Vector2};
use wisch::plan::{CoverageDensity, NodeRole, data_bandwidth};

/// Maximum height of the surface in a picture.
pub(crate) const HEIGHT: f64 = 560.0;

/// The data of a run that its drawings share.
pub(crate) struct Drawing<'a> {
    pub(crate) input: &'a ReportInput<'a>,
    /// Bounds of the view [m].
    pub(crate) bounds: Bounds2,
    /// Bounds of views without the start of the tool [m].
    pub(crate) close: Bounds2,
    obstacles: Vec<Vec<Point2>>,
    before: Vec<Point2>,
    unreachable: Vec<Point2>,
    after: Vec<Particle>,
}

impl<'a> Drawing<'a> {
    pub(crate) fn new(input: &'a ReportInput<'a>) -> Self {
        let task = input.task;
        let radius = input.plan.collision_radius;
        let obstacles = surface::obstacle_rings(task, radius);
        let kept = kept_particles(task);
        let before: Vec<Point2> = kept.iter().map(|&i| task.particles.position(i)).collect();
        let predicted = &input.prediction.particles;
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
            bounds: find_bounds(input, Some(input.plan.tool_start)),
            close: find_bounds(input, None),
            obstacles,
            before,
            unreachable,
            after: (kept.iter())
                .map(|&i| (predicted.position(i), predicted.fate(i)))
                .collect(),
        }
    }

    pub(crate) fn outcome(&self, particle: Particle) -> Outcome {
        let (goal, surface) = (&self.input.plan.graph.goal, &self.input.task.surface);
        surface::outcome(goal, surface, particle)
    }

    /// Label of a reached goal.
    pub(crate) fn achieved(&self) -> &'static str {
        surface::achieved_label(&self.input.plan.graph.goal)
    }

    /// Draws the surface, its edges, the goal and the obstacles.
    pub(crate) fn ground(&self, view: &View) -> Markup {
        let (surface, goal) = (&self.input.task.surface, &self.input.plan.graph.goal);
        surface::draw_ground(view, surface, goal)
    }

    pub(crate) fn obstacles(&self, view: &View) -> Markup {
        html! {
            @if !self.obstacles.is_empty() {
                path class="obstacle" d=(view.rings(self.obstacles.iter().map(Vec::as_slice))) {}
            }
        }
    }

    pub(crate) fn has_obstacles(&self) -> bool {
        !self.obstacles.is_empty()
    }

    pub(crate) fn has_unreachable(&self) -> bool {
        !self.unreachable.is_empty()
    }

    /// Draws the initial particles as hollow dots; those out of reach are struck through.
    pub(crate) fn before(&self, view: &View) -> Markup {
        let radius = surface::dot_radius(view, self.before.len());
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

    /// Draws the predicted particles.
    pub(crate) fn after(&self, view: &View) -> Markup {
        let radius = surface::dot_radius(view, self.after.len());
        self.particles(view, &self.after, radius)
    }

    /// Draws particles as filled dots, by outcome.
    pub(crate) fn particles(&self, view: &View, particles: &[Particle], radius: f64) -> Markup {
        let outcomes = particles.iter().map(|&p| (p.0, self.outcome(p)));
        surface::particles(view, outcomes, radius)
    }

    /// Draws directed edges with arrows.
    pub(crate) fn edges(&self, view: &View) -> Markup {
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
            path class="edge" style=[self.thin_style(view, "stroke-width:1")] d=(lines.path()) {}
            path class="arrow" d=(arrows.path()) {}
        }
    }

    /// Draws nodes: coverage nodes red, goal nodes yellow, nodes without a path to the goal hollow.
    pub(crate) fn nodes(&self, view: &View) -> Markup {
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

    /// Whether there is space for the strokes' numbers.
    fn numbers_fit(&self, view: &View) -> bool {
        self.input.plan.collision_radius * view.scale >= 22.0
    }

    /// Returns the view of the map of the surface.
    pub(crate) fn map_view(&self) -> View {
        View::with_axes(self.bounds, Vector2::new(WIDTH, HEIGHT))
    }

    /// Whether the map has space for the strokes' numbers.
    pub(crate) fn map_has_numbers(&self) -> bool {
        self.numbers_fit(&self.map_view())
    }

    /// Returns a style of thinner lines if the tool is small relative to the surface, so that lines are close.
    fn thin_style(&self, view: &View, style: &'static str) -> Option<&'static str> {
        (!self.numbers_fit(view)).then_some(style)
    }

    /// Draws lifted moves, and the number of each stroke at its start.
    pub(crate) fn order(&self, view: &View) -> Markup {
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
            path class="lifted" style=[self.thin_style(view, "stroke-width:.6;stroke-opacity:.7")] d=(lifted.path()) {}
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

    /// Draws the tool to scale at its start, on the robot's side.
    pub(crate) fn tool_at_start(&self, view: &View) -> Markup {
        let Some(start) = self.input.frames.frames().first() else {
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

    /// Draws the density (2) in filled bands of a fixed share of its peak.
    pub(crate) fn density(&self, view: &View) -> Markup {
        let outline = &self.input.task.surface.outline;
        let particles: Vec<Point2> = self.input.task.particles.remaining().collect();
        let Some(bounds) = Bounds2::from_points(outline.outer().iter().copied()) else {
            return html! {};
        };
        let map = CoverageDensity::new(&particles, bounds, self.bandwidth());
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

    /// Returns the bandwidth h of the density [m]: that of the planner settings, or else that of the data.
    pub(crate) fn bandwidth(&self) -> f64 {
        self.input.bandwidth.unwrap_or_else(|| {
            let particles: Vec<Point2> = self.input.task.particles.remaining().collect();
            data_bandwidth(&particles, self.input.plan.collision_radius)
        })
    }
}

/// Returns bounds that include the surface, the nodes, particles pushed off it, and `tool_start` if it is near [m].
fn find_bounds(input: &ReportInput, tool_start: Option<Point2>) -> Bounds2 {
    let outline = input.task.surface.outline.outer().iter().copied();
    let surface = surface::extent(&input.task.surface);
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
    Bounds2::from_points(shown).unwrap_or(surface)
}
