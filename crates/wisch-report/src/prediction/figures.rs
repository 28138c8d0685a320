//! The pictures of a plan and its prediction.

use super::chart;
use super::frames::{Frame, thin_places};
use super::keys::{Key, entries};
use super::layers::{Drawing, HEIGHT};
use crate::draw::{
    BANDS, Entry, Figure, GAP, Panel, View, WIDTH, format_decimal, format_percent, inset, legend,
    px, surface,
};
use maud::{Markup, html};
use wisch::geometry::Vector2;

/// Margins of legends, left and right.
const MARGINS: [f64; 2] = [48.0, 10.0];
/// Number of snapshots side by side, as in Fig. 7.
pub(crate) const SNAPSHOTS: usize = 5;

const PARTICLE_KEYS: [Key; 5] = [
    Key::Before,
    Key::Left,
    Key::Done,
    Key::Lost,
    Key::Unreachable,
];
const GRAPH_KEYS: [Key; 10] = [
    Key::Node,
    Key::NodeCut,
    Key::Goal,
    Key::GoalArea,
    Key::Edge,
    Key::Start,
    Key::Lifted,
    Key::Tool,
    Key::SkimEdge,
    Key::Obstacle,
];

/// Draws nodes, edges and order of strokes over the initial particles; paper Fig. 5.
pub(crate) fn graph(drawing: &Drawing) -> String {
    let view = drawing.map_view();
    let layers = html! {
        (drawing.ground(&view))
        (drawing.before(&view))
        (drawing.tool_at_start(&view))
        (drawing.edges(&view))
        (drawing.nodes(&view))
        (drawing.order(&view))
    };
    let wanted = [Key::Before, Key::Unreachable]
        .into_iter()
        .chain(GRAPH_KEYS);
    Figure {
        panel: add_axes(drawing, &view, layers),
        entries: entries(drawing, wanted),
        what: "Planned strokes, seen from above".to_owned(),
    }
    .standalone(drawing.input.title, MARGINS)
}

/// Draws bands of equal density with the nodes on top; paper Fig. 4.
pub(crate) fn density_figure(drawing: &Drawing) -> Figure {
    let view = View::with_axes(drawing.close, Vector2::new(WIDTH, HEIGHT));
    let layers = html! {
        (drawing.density(&view))
        path class="outline" d=(view.rings(drawing.input.task.surface.outline.rings())) {}
        g class="on-density" { (drawing.before(&view)) }
        (drawing.nodes(&view))
    };
    let panel = add_axes(drawing, &view, layers);
    let (top, cell) = (panel.height + 6.0, 34.0);
    let body = html! {
        (panel.body)
        g transform=(format!("translate({} {})", px(MARGINS[0]), px(top))) {
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
    let wanted = [
        Key::Before,
        Key::Unreachable,
        Key::Node,
        Key::NodeCut,
        Key::Goal,
        Key::Obstacle,
    ];
    Figure {
        panel: Panel {
            height: panel.height + 44.0,
            body,
            ..panel
        },
        entries: entries(drawing, wanted),
        what: "Contours of the particle density with the plan's nodes".to_owned(),
    }
}

/// Draws [`density_figure`] as a file.
pub(crate) fn density(drawing: &Drawing) -> String {
    let bandwidth = format_decimal(drawing.bandwidth(), 3);
    Figure {
        what: format!("Density of the particles (kernel bandwidth {bandwidth} m) and the nodes"),
        ..density_figure(drawing)
    }
    .standalone(drawing.input.title, MARGINS)
}

/// Clips layers to the view, and adds axes and a scale bar.
fn add_axes(drawing: &Drawing, view: &View, layers: Markup) -> Panel {
    Panel {
        width: WIDTH,
        height: view.bottom(),
        body: html! {
            (inset(view, html! { (layers) (drawing.obstacles(view)) }))
            (view.axes())
            (view.scale_bar())
        },
    }
}

/// Draws the particles before and after in two views.
pub(crate) fn before_after(drawing: &Drawing) -> String {
    const WIDE: f64 = 1000.0;
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
    let wanted = (PARTICLE_KEYS.into_iter()).chain([Key::GoalArea, Key::SkimEdge, Key::Obstacle]);
    let performance = drawing.input.prediction.performance;
    let frame = |view: &View, title: &str, particles: Markup| {
        html! {
            text class="text strong" x=(px(view.left())) y=(px(view.top() - 8.0)) { (title) }
            (inset(view, html! { (drawing.ground(view)) (particles) (drawing.obstacles(view)) }))
            rect class="rule" x=(px(view.left())) y=(px(view.top())) width=(px(view.width())) height=(px(view.height())) {}
            (view.scale_bar())
        }
    };
    let panel = Panel {
        width: if beside {
            second.left() + second.width() + GAP
        } else {
            first.width() + 2.0 * GAP
        }
        .max(640.0),
        height: bottom,
        body: html! {
            (frame(&first, "before", drawing.before(&first)))
            (frame(&second, &format!("after: {} {}", format_percent(performance.ratio()), drawing.achieved()),
                drawing.after(&second)))
        },
    };
    Figure {
        panel,
        entries: entries(drawing, wanted),
        what: "Particles before, and predicted after".to_owned(),
    }
    .standalone(drawing.input.title, [GAP, MARGINS[1]])
}

/// Selects frames at about even distances, including the first and the last.
pub(crate) fn snapshots<'a>(drawing: &Drawing<'a>) -> Vec<&'a Frame> {
    let frames = drawing.input.frames.frames();
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

/// Returns the legend of a snapshot.
pub(crate) fn moment_entries(drawing: &Drawing) -> Vec<Entry> {
    let wanted = [
        Key::LeftNow,
        Key::DoneNow,
        Key::Lost,
        Key::Tool,
        Key::Trail,
        Key::Obstacle,
    ];
    entries(drawing, wanted)
}

/// Draws a snapshot.
pub(crate) fn snapshot(drawing: &Drawing, frame: &Frame, width: f64) -> Panel {
    let view = View::fit(drawing.bounds, 0.0, 0.0, Vector2::new(width, 1.2 * width));
    let trail = drawing
        .input
        .plan
        .strokes
        .iter()
        .take(frame.stroke.map_or(0, |s| s + 1));
    // A snapshot is small, so it shows fewer particles than a frame.
    let places: Vec<_> = frame.particles.iter().map(|(place, _)| *place).collect();
    let kept = thin_places(&places, 1_500, drawing.input.task.action);
    let particles: Vec<_> = kept.iter().map(|&i| frame.particles[i]).collect();
    let radius = surface::dot_radius(&view, particles.len()).clamp(0.8, 2.0);
    let last = frame.stroke.unwrap_or(0);
    let body = html! {
        (drawing.ground(&view))
        @for (i, stroke) in trail.enumerate() {
            @let until = if i == last { count_passed(stroke, frame) } else { stroke.poses.len() };
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
    }
}

/// Returns the number of poses of a stroke that the tool has passed.
fn count_passed(stroke: &wisch::plan::Stroke, frame: &Frame) -> usize {
    stroke
        .poses
        .iter()
        .position(|pose| *pose == frame.surface_from_tool)
        .map_or(stroke.poses.len(), |i| i + 1)
}

/// Returns the caption of a snapshot.
pub(crate) fn caption(frame: &Frame) -> String {
    format!(
        "{} m · {}",
        format_decimal(frame.distance, 2),
        format_percent(frame.performance.ratio())
    )
}

/// Draws snapshots in a row, with the performance over the distance below; paper Fig. 7.
pub(crate) fn effect_over_time(drawing: &Drawing) -> String {
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
    let (legend, legend_height) = legend::rows(
        &moment_entries(drawing),
        [GAP, row + 28.0],
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
    }
    .standalone(drawing.input.title, "Predicted effect over the distance in contact")
}
