//! The pictures: layers put together, with a legend.

use super::chart;
use super::frames::Frame;
use super::palette::{BANDS, standalone_rules};
use super::picture::Drawing;
use super::view::{View, metres, percent, px};
use maud::{Markup, PreEscaped, html};
use wisch::geometry::Vector2;
use wisch::plan::{Node, NodeRole};
use wisch::represent::GoalState;

/// Width of a picture.
pub(super) const WIDTH: f64 = 760.0;
/// Where legends begin.
const MARGIN: f64 = 48.0;
/// Most height of the surface in it.
const HEIGHT: f64 = 560.0;
/// Room for the headline of a picture that stands alone.
const HEADLINE: f64 = 44.0;
/// Moments shown side by side, as in Fig. 7.
pub(super) const SNAPSHOTS: usize = 5;

/// Something drawn, with its size.
pub(super) struct Panel {
    pub(super) width: f64,
    pub(super) height: f64,
    pub(super) body: Markup,
    /// What its marks are to be explained by.
    pub(super) keys: Vec<Key>,
}

impl Panel {
    /// Nothing.
    pub(super) fn empty() -> Self {
        Self {
            width: WIDTH,
            height: 0.0,
            body: html! {},
            keys: Vec::new(),
        }
    }

    /// As part of a page, which brings colours.
    pub(super) fn inline(&self, label: &str) -> Markup {
        html! {
            svg viewBox=(format!("0 0 {} {}", px(self.width), px(self.height))) role="img" aria-label=(label) {
                (self.body)
            }
        }
    }

    /// With its legend below.
    fn with_legend(self, drawing: &Drawing, left: f64) -> Self {
        let (legend, height) = legend(
            drawing,
            &self.keys,
            left,
            self.height,
            self.width - left - 10.0,
        );
        Self {
            height: self.height + height,
            body: html! { (self.body) (legend) },
            ..self
        }
    }

    /// As a file of its own, with light colours and a headline.
    pub(super) fn standalone(&self, title: &str, what: &str) -> String {
        let height = self.height + HEADLINE;
        html! {
            svg xmlns="http://www.w3.org/2000/svg" width=(px(self.width)) height=(px(height))
                viewBox=(format!("0 0 {} {}", px(self.width), px(height))) {
                style { (PreEscaped(standalone_rules())) }
                rect class="ground" width=(px(self.width)) height=(px(height)) {}
                text class="text strong" x="12" y="20" { (short(title, 70)) }
                text class="text small quiet" x="12" y="36" { (what) }
                g transform=(format!("translate(0 {HEADLINE})")) { (self.body) }
            }
        }
        .into_string()
    }
}

/// One entry of a legend.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Key {
    Before,
    Left,
    Done,
    Lost,
    Unreachable,
    Node,
    NodeCut,
    Goal,
    GoalArea,
    Edge,
    Start,
    Lifted,
    Tool,
    Obstacle,
    SkimEdge,
    LeftNow,
    DoneNow,
    Trail,
}

impl Key {
    fn label(self, goal: &GoalState) -> &'static str {
        match (self, goal) {
            (Self::Before, GoalState::Absorbed) => "particle before (empty: taken up)",
            (Self::Before, _) => "particle before",
            (Self::Left, GoalState::Absorbed) => "after, still there",
            (Self::Left, GoalState::Collected { .. }) => "after, outside the goal",
            (Self::Left, GoalState::Skimmed) => "after, still on the surface",
            (Self::Done, GoalState::Skimmed) => "after, pushed over the allowed edge",
            (Self::Done, _) => "after, at the goal",
            (Self::Lost, _) => "lost over a wrong edge",
            (Self::Unreachable, _) => "out of the plan's reach",
            (Self::Node, _) => "node",
            (Self::NodeCut, _) => "node without a way",
            (Self::Goal, _) => "goal node",
            (Self::GoalArea, _) => "counts as collected",
            (Self::Edge, _) => "wiped in this direction",
            (Self::Start, _) => "start of stroke 1, 2, …",
            (Self::Lifted, _) => "lifted move",
            (Self::Tool, _) => "tool, to scale",
            (Self::Obstacle, _) => "obstacle",
            (Self::SkimEdge, _) => "edge to push over",
            (Self::LeftNow, GoalState::Collected { .. }) => "outside the goal",
            (Self::LeftNow, _) => "on the surface",
            (Self::DoneNow, GoalState::Skimmed) => "over the allowed edge",
            (Self::DoneNow, _) => "at the goal",
            (Self::Trail, _) => "wiped so far",
        }
    }

    /// A sample of 24 by 14 units round (12, 0).
    fn sample(self) -> Markup {
        html! {
            @match self {
                Self::Before => circle class="before" cx="12" cy="0" r="3.6" {},
                Self::Left | Self::LeftNow => path class="dots-left" stroke-width="7" d="M12 0h0" {},
                Self::Done | Self::DoneNow => path class="dots-done" stroke-width="7" d="M12 0h0" {},
                Self::Lost => path class="mark-lost" d="M8.5-3.5l7 7m0-7l-7 7" {},
                Self::Unreachable => {
                    circle class="before" cx="12" cy="0" r="3.6" {}
                    path class="mark-lost" d="M7 5l10-10" {}
                },
                Self::Node => circle class="node" cx="12" cy="0" r="5" {},
                Self::NodeCut => circle class="node-cut" cx="12" cy="0" r="4.5" {},
                Self::Goal => circle class="goal" cx="12" cy="0" r="6" {},
                Self::GoalArea => rect class="goal-reach" x="2" y="-6" width="20" height="12" rx="6" {},
                Self::Edge => {
                    path class="edge" d="M1 0h22" {}
                    path class="arrow" d="M17 0l-9-4.5l2.5 4.5l-2.5 4.5z" {}
                },
                Self::Start => {
                    circle class="node" cx="12" cy="0" r="8" {}
                    text class="number" font-size="10" x="12" y="3.7" { "1" }
                },
                Self::Trail => path class="trail" d="M0 0h24" {},
                Self::Lifted => path class="lifted" d="M0 0h24" {},
                Self::Tool => rect class="tool" x="4" y="-6" width="16" height="12" {},
                Self::Obstacle => rect class="obstacle" x="4" y="-6" width="16" height="12" {},
                Self::SkimEdge => {
                    path class="skim-edge" d="M0 0h24" {}
                    path class="skim-core" d="M0 0h24" {}
                },
            }
        }
    }
}

/// A legend as a list of the page.
pub(super) fn legend_list(drawing: &Drawing, keys: &[Key]) -> Markup {
    let goal = &drawing.input.plan.graph.goal;
    html! {
        ul class="legend" {
            @for key in keys {
                li {
                    svg viewBox="0 -9 24 18" width="24" height="18" aria-hidden="true" { (key.sample()) }
                    (key.label(goal))
                }
            }
        }
    }
}

/// A legend in rows from (`left`, `top`) on; gives its height too.
fn legend(drawing: &Drawing, keys: &[Key], left: f64, top: f64, width: f64) -> (Markup, f64) {
    const ROW: f64 = 23.0;
    let goal = &drawing.input.plan.graph.goal;
    let (mut x, mut row) = (0.0, 0);
    let mut places = Vec::new();
    for &key in keys {
        let wide = 31.0 + text_width(key.label(goal)) + 20.0;
        if x > 0.0 && x + wide > width {
            (x, row) = (0.0, row + 1);
        }
        places.push((key, left + x, top + ROW * (row as f64 + 0.5)));
        x += wide;
    }
    let rows = if keys.is_empty() { 0 } else { row + 1 };
    let body = html! {
        @for (key, x, y) in places {
            g transform=(format!("translate({} {})", px(x), px(y))) {
                (key.sample())
                text class="text" font-size="12" x="31" y="4.3" { (key.label(goal)) }
            }
        }
    };
    (body, ROW * rows as f64 + 8.0)
}

/// About the width of a text of 12 units in Inter and its like.
pub(super) fn text_width(text: &str) -> f64 {
    text.chars()
        .map(|c| match c {
            'i' | 'j' | 'l' | 't' | 'f' | 'r' | ' ' | ',' | '.' | '\'' => 4.4,
            'm' | 'w' => 10.4,
            _ => 7.2,
        })
        .sum()
}

/// Which marks can occur in a picture of this run.
fn keys(drawing: &Drawing, wanted: &[Key]) -> Vec<Key> {
    let input = drawing.input;
    let (plan, performance) = (input.plan, &input.prediction.performance);
    let lifted = plan.strokes.len() > 1;
    wanted
        .iter()
        .copied()
        .filter(|key| match key {
            Key::Before | Key::Left | Key::LeftNow => performance.initial > 0,
            Key::Done | Key::DoneNow => {
                plan.graph.goal != GoalState::Absorbed && performance.initial > 0
            }
            Key::Lost => performance.lost > 0,
            Key::Unreachable => drawing.has_unreachable(),
            Key::Tool => true,
            Key::Node => !plan.graph.nodes.is_empty(),
            Key::NodeCut => !plan.graph.unreachable.is_empty(),
            Key::Goal => {
                let is_goal = |node: &Node| node.role == NodeRole::Goal;
                plan.graph.nodes.iter().any(is_goal)
            }
            Key::GoalArea => matches!(plan.graph.goal, GoalState::Collected { .. }),
            Key::Edge => !plan.graph.edges.is_empty(),
            Key::Start => !plan.strokes.is_empty() && numbers_fit(drawing),
            Key::Trail => !plan.strokes.is_empty(),
            Key::Lifted => lifted,
            Key::Obstacle => drawing.has_obstacles(),
            Key::SkimEdge => plan.graph.goal == GoalState::Skimmed,
        })
        .collect()
}

const PARTICLE_KEYS: [Key; 5] = [
    Key::Before,
    Key::Left,
    Key::Done,
    Key::Lost,
    Key::Unreachable,
];
const GRAPH_KEYS: [Key; 9] = [
    Key::Node,
    Key::NodeCut,
    Key::Goal,
    Key::GoalArea,
    Key::Edge,
    Key::Start,
    Key::Lifted,
    Key::Tool,
    Key::SkimEdge,
];

/// The surface from above with every layer, each in a group that the page can hide.
pub(super) fn map(drawing: &Drawing) -> Panel {
    let view = View::with_axes(drawing.bounds, Vector2::new(WIDTH, HEIGHT));
    let wanted: Vec<Key> = PARTICLE_KEYS
        .into_iter()
        .chain(GRAPH_KEYS)
        .chain([Key::Obstacle])
        .collect();
    framed(drawing, &view, &wanted, |view| {
        html! {
            (drawing.ground(view))
            g class="layer-before" { (drawing.before(view)) }
            g class="layer-after" { (drawing.particles(view, &drawing.after, drawing.dot_radius(view, drawing.after.len()))) }
            g class="layer-tool" { (drawing.tool_at_start(view)) }
            g class="layer-graph" { (drawing.edges(view)) }
            g class="layer-graph" { (drawing.nodes(view)) }
            g class="layer-order" { (drawing.order(view)) }
        }
    })
}

/// Whether the map has room for the strokes' numbers.
pub(super) fn numbers_fit(drawing: &Drawing) -> bool {
    let view = View::with_axes(drawing.bounds, Vector2::new(WIDTH, HEIGHT));
    drawing.numbers_fit(&view)
}

/// Nodes, edges and order over the particles as they lay; paper Fig. 5.
pub(super) fn graph(drawing: &Drawing) -> String {
    let view = View::with_axes(drawing.bounds, Vector2::new(WIDTH, HEIGHT));
    let wanted: Vec<Key> = [Key::Before, Key::Unreachable]
        .into_iter()
        .chain(GRAPH_KEYS)
        .chain([Key::Obstacle])
        .collect();
    framed(drawing, &view, &wanted, |view| {
        html! {
            (drawing.ground(view))
            (drawing.before(view))
            (drawing.tool_at_start(view))
            (drawing.edges(view))
            (drawing.nodes(view))
            (drawing.order(view))
        }
    })
    .with_legend(drawing, MARGIN)
    .standalone(drawing.input.title, "Planned strokes, seen from above")
}

/// Bands of equal density with the nodes on top; paper Fig. 4.
pub(super) fn density_panel(drawing: &Drawing) -> Panel {
    let view = View::with_axes(drawing.close, Vector2::new(WIDTH, HEIGHT));
    let mut panel = framed(
        drawing,
        &view,
        &[
            Key::Before,
            Key::Unreachable,
            Key::Node,
            Key::NodeCut,
            Key::Goal,
            Key::Obstacle,
        ],
        |view| {
            html! {
                (drawing.density(view))
                path class="outline" d=(view.rings(drawing.input.task.surface.outline.rings())) {}
                g class="on-density" { (drawing.before(view)) }
                (drawing.nodes(view))
            }
        },
    );
    let (top, cell) = (panel.height + 6.0, 34.0);
    panel.body = html! {
        (panel.body)
        g transform=(format!("translate({} {})", px(MARGIN), px(top))) {
            text class="text" font-size="12" x="0" y="12" { "density, share of its peak" }
            @for band in 1..=BANDS {
                @let x = 180.0 + cell * (band - 1) as f64;
                rect class=(format!("band-{band}")) x=(px(x)) y="0" width=(px(cell)) height="14" {}
                text class="text small quiet middle" x=(px(x)) y="28" {
                    (format!("{:.0} %", 100.0 * band as f64 / (BANDS + 1) as f64))
                }
            }
        }
    };
    panel.height += 44.0;
    panel
}

pub(super) fn density(drawing: &Drawing) -> String {
    let bandwidth = metres(drawing.bandwidth(), 3);
    density_panel(drawing)
        .with_legend(drawing, MARGIN)
        .standalone(
            drawing.input.title,
            &format!("Density of the particles (kernel bandwidth {bandwidth} m) and the nodes"),
        )
}

/// Axes and scale bar round what `layers` draws, which is cut off at the view's border.
fn framed(
    drawing: &Drawing,
    view: &View,
    wanted: &[Key],
    layers: impl FnOnce(&View) -> Markup,
) -> Panel {
    Panel {
        width: WIDTH,
        height: view.bottom(),
        body: html! {
            (inset(view, html! { (layers(view)) (drawing.obstacles(view)) }))
            (view.axes())
            (view.scale_bar())
        },
        keys: keys(drawing, wanted),
    }
}

/// Shows only what lies within the view.
pub(super) fn inset(view: &View, body: Markup) -> Markup {
    let frame = [view.left(), view.top(), view.width(), view.height()].map(px);
    let [x, y, width, height] = &frame;
    html! {
        svg x=(x) y=(y) width=(width) height=(height) viewBox=(frame.join(" ")) { (body) }
    }
}

/// Two views, before and after, with the particles alone.
pub(super) fn before_after(drawing: &Drawing) -> String {
    const WIDE: f64 = 1000.0;
    const GAP: f64 = 24.0;
    let extent = drawing.close.size();
    let beside = extent.x < 1.6 * extent.y;
    let size = if beside {
        Vector2::new((WIDE - 3.0 * GAP) / 2.0, HEIGHT)
    } else {
        Vector2::new(WIDE - 2.0 * GAP, 440.0)
    };
    let first = View::fit(drawing.close, GAP, 24.0, size);
    let second = if beside {
        View::fit(
            drawing.close,
            first.left() + first.width() + GAP,
            24.0,
            size,
        )
    } else {
        let top = first.top() + first.height() + 40.0;
        View::fit(drawing.close, GAP, top, size)
    };
    let bottom = second.top() + second.height() + 14.0;
    let wanted: Vec<Key> = PARTICLE_KEYS
        .into_iter()
        .chain([Key::Goal, Key::GoalArea, Key::SkimEdge, Key::Obstacle])
        .filter(|&key| key != Key::Goal)
        .collect();
    let performance = drawing.input.prediction.performance;
    let frame = |view: &View, title: &str, particles: Markup| {
        html! {
            text class="text strong" x=(px(view.left())) y=(px(view.top() - 8.0)) { (title) }
            (inset(view, html! { (drawing.ground(view)) (particles) (drawing.obstacles(view)) }))
            rect class="rule" x=(px(view.left())) y=(px(view.top())) width=(px(view.width())) height=(px(view.height())) {}
            (view.scale_bar())
        }
    };
    Panel {
        width: if beside {
            second.left() + second.width() + GAP
        } else {
            first.width() + 2.0 * GAP
        }
        .max(640.0),
        height: bottom,
        body: html! {
            (frame(&first, "before", drawing.before(&first)))
            (frame(&second, &format!("after: {} {}", percent(performance.ratio()), drawing.achieved()),
                drawing.particles(&second, &drawing.after, drawing.dot_radius(&second, drawing.after.len()))))
        },
        keys: keys(drawing, &wanted),
    }
    .with_legend(drawing, GAP)
    .standalone(drawing.input.title, "Particles before and after, as predicted")
}

/// Frames about evenly spaced over the distance, the first and the last among them.
pub(super) fn snapshots<'a>(drawing: &Drawing<'a>) -> Vec<&'a Frame> {
    let frames = drawing.input.frames.all();
    let total = frames.last().map_or(0.0, |frame| frame.distance);
    let mut chosen: Vec<usize> = (0..SNAPSHOTS)
        .filter_map(|i| {
            let wanted = total * i as f64 / (SNAPSHOTS - 1) as f64;
            (0..frames.len()).min_by(|&a, &b| {
                let off = |f: usize| (frames[f].distance - wanted).abs();
                off(a).total_cmp(&off(b))
            })
        })
        .chain(frames.len().checked_sub(1))
        .collect();
    chosen.dedup();
    chosen.truncate(SNAPSHOTS + 1);
    chosen.iter().map(|&i| &frames[i]).collect()
}

/// What is seen in a moment of the effect over time.
pub(super) fn moment_keys(drawing: &Drawing) -> Vec<Key> {
    let wanted = [
        Key::LeftNow,
        Key::DoneNow,
        Key::Lost,
        Key::Tool,
        Key::Trail,
        Key::Obstacle,
    ];
    keys(drawing, &wanted)
}

/// One moment, small.
pub(super) fn snapshot(drawing: &Drawing, frame: &Frame, width: f64) -> Panel {
    let view = View::fit(drawing.bounds, 0.0, 0.0, Vector2::new(width, 1.2 * width));
    let trail = drawing
        .input
        .plan
        .strokes
        .iter()
        .take(frame.stroke.map_or(0, |s| s + 1));
    // Thinner than a frame's particles: a snapshot is small.
    let step = super::frames::thinning(frame.particles.len(), 1_500);
    let particles: Vec<_> = frame.particles.iter().copied().step_by(step).collect();
    let radius = drawing.dot_radius(&view, particles.len()).clamp(0.8, 2.0);
    let last = frame.stroke.unwrap_or(0);
    let body = html! {
        (drawing.ground(&view))
        @for (i, stroke) in trail.enumerate() {
            @let until = if i == last { reached(stroke, frame) } else { stroke.poses.len() };
            path class="trail" d=(view.line(stroke.poses[..until].iter().map(|p| p.position))) {}
        }
        (drawing.particles(&view, &particles, radius))
        (drawing.obstacles(&view))
        path class="tool" d=(view.footprint(&drawing.input.task.tool.footprint, &frame.surface_from_tool)) {}
    };
    Panel {
        width: view.width(),
        height: view.height(),
        body: html! {
            (inset(&view, body))
            rect class="rule" x="0.5" y="0.5" width=(px(view.width() - 1.0)) height=(px(view.height() - 1.0)) {}
        },
        keys: Vec::new(),
    }
}

/// How many of a stroke's poses lie behind the tool at this moment.
fn reached(stroke: &wisch::plan::Stroke, frame: &Frame) -> usize {
    stroke
        .poses
        .iter()
        .position(|pose| *pose == frame.surface_from_tool)
        .map_or(stroke.poses.len(), |i| i + 1)
}

/// What stands below a snapshot.
pub(super) fn caption(frame: &Frame) -> String {
    format!(
        "{} m · {}",
        metres(frame.distance, 2),
        percent(frame.performance.ratio())
    )
}

/// Snapshots in a row, and the performance over the distance below them; paper Fig. 7.
pub(super) fn effect_over_time(drawing: &Drawing) -> String {
    const WIDE: f64 = 1000.0;
    const GAP: f64 = 12.0;
    let frames = snapshots(drawing);
    let count = frames.len().max(3) as f64;
    let each = (WIDE - GAP * (count + 1.0)) / count;
    let panels: Vec<(Panel, String)> = frames
        .iter()
        .map(|frame| (snapshot(drawing, frame, each), caption(frame)))
        .collect();
    let row = panels.iter().map(|(p, _)| p.height).fold(0.0, f64::max);
    let chart = chart::performance(drawing, WIDE);
    let (legend, legend_height) = legend(
        drawing,
        &moment_keys(drawing),
        GAP,
        row + 28.0,
        WIDE - 2.0 * GAP,
    );
    let chart_top = row + 28.0 + legend_height + 6.0;
    Panel {
        width: WIDE,
        height: chart_top + chart.height,
        body: html! {
            @for (i, (panel, caption)) in panels.iter().enumerate() {
                g transform=(format!("translate({} 0)", px(GAP + i as f64 * (each + GAP)))) {
                    (panel.body)
                    text class="text small middle" x=(px(panel.width / 2.0)) y=(px(panel.height + 17.0)) { (caption) }
                }
            }
            (legend)
            g transform=(format!("translate(0 {})", px(chart_top))) { (chart.body) }
        },
        keys: Vec::new(),
    }
    .standalone(drawing.input.title, "Effect over the distance wiped, as predicted")
}

/// At most `most` characters, the rest as an ellipsis.
pub(super) fn short(text: &str, most: usize) -> String {
    if text.chars().count() <= most {
        text.to_owned()
    } else {
        text.chars().take(most - 1).chain(['…']).collect()
    }
}
