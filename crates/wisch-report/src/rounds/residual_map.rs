//! The remaining dirt: believed, estimated and true, and the uncertainty of the estimate by location. Also the distances of
//! the contacts from the fitted surface.

use super::input::{RoundView, RoundsInput};
use crate::draw::{
    BANDS, Entry, Figure, GAP, Panel, Pen, View, find_tick_step, format_decimal, format_percent,
    inset, legend, px, shorten,
    surface::{
        self, Outcome, achieved_label, dot_radius, draw_ground, extent, lost_label, obstacle_rings,
        open_label, outcome,
    },
};
use crate::prediction::frames::thin_places;
use maud::{Markup, html};
use wisch::geometry::{Bounds2, Point2, Vector2};
use wisch::interpret::{ContactResidual, RESIDUAL_CELL};
use wisch::represent::{GoalState, ParticleDistribution, Surface};

/// Width of a view on the page, and its maximum height as a share of the width.
const VIEW: f64 = 306.0;
const MAP: f64 = 450.0;
const TALLEST: f64 = 1.1;
/// Margins for the name above, and for the scale of the map below.
const NAME: f64 = 24.0;
const RAMP: f64 = 46.0;
/// Approximate maximum number of cells along the longer side of the surface.
const MOST_CELLS: f64 = 20.0;
/// Minimum width of views side by side.
const NARROWEST: f64 = 600.0;
/// Maximum number of drawn particles.
const MAX_DRAWN: usize = 3_000;

/// A map in square cells of the remaining particles, or of the mean passes over a treated surface.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Cells {
    pub(crate) low: Point2,
    /// Side of a cell [m].
    pub(crate) side: f64,
    pub(crate) columns: usize,
    /// Row by row: mean over the replays, and standard deviation.
    pub(crate) mean: Vec<f64>,
    pub(crate) deviation: Vec<f64>,
}

impl Cells {
    /// Counts the particles on the surface outside the goal, or averages the passes of a treated surface, for each replay.
    pub(crate) fn new(
        replays: &[ParticleDistribution],
        goal: &GoalState,
        surface: &Surface,
    ) -> Self {
        let bounds = extent(surface);
        let side = cell_side(
            &bounds,
            replays.first().map_or(0, ParticleDistribution::len),
        );
        let count = bounds
            .size()
            .map(|length| (length / side - 1e-9).ceil().max(1.0) as usize);
        let (columns, rows) = (count.x, count.y);
        let mut sum = vec![0.0; columns * rows];
        let mut squares = sum.clone();
        for replay in replays {
            let mut counts = vec![0.0; columns * rows];
            let mut places = counts.clone();
            let treats = goal.action().treats();
            let left = replay.iter().filter(|&(p, fate)| {
                treats || fate.is_on_surface() && !goal.is_met_by(p, fate, surface)
            });
            for (p, fate) in left {
                let place = (p - bounds.min) / side;
                let column = (place.x.max(0.0) as usize).min(columns - 1);
                let row = (place.y.max(0.0) as usize).min(rows - 1);
                let cell = row * columns + column;
                counts[cell] += if treats { fate.passes() } else { 1.0 };
                places[cell] += 1.0;
            }
            if treats {
                for (count, places) in counts.iter_mut().zip(&places) {
                    *count /= f64::max(*places, 1.0);
                }
            }
            for (cell, count) in counts.into_iter().enumerate() {
                sum[cell] += count;
                squares[cell] += count * count;
            }
        }
        let replays = replays.len().max(1) as f64;
        let mean: Vec<f64> = sum.iter().map(|sum| sum / replays).collect();
        let variance = squares.iter().zip(&mean).map(|(s, m)| s / replays - m * m);
        Self {
            low: bounds.min,
            side,
            columns,
            deviation: variance.map(|v| v.max(0.0).sqrt()).collect(),
            mean,
        }
    }

    /// Returns the cells of contacts: how far they are above the fitted surface, and how far below it [mm].
    fn from_residuals(residuals: &[ContactResidual]) -> Self {
        let bounds = Bounds2::from_points(residuals.iter().map(|cell| cell.place));
        let bounds = bounds.unwrap_or(Bounds2 {
            min: Point2::origin(),
            max: Point2::origin(),
        });
        let count = |length: f64| (length / RESIDUAL_CELL).round() as usize;
        let (columns, rows) = (count(bounds.size().x) + 1, count(bounds.size().y) + 1);
        let mut cells = Self {
            low: bounds.min - Vector2::repeat(0.5 * RESIDUAL_CELL),
            side: RESIDUAL_CELL,
            columns,
            mean: vec![0.0; columns * rows],
            deviation: vec![0.0; columns * rows],
        };
        for residual in residuals {
            let from_low = residual.place - bounds.min;
            let cell = count(from_low.y) * columns + count(from_low.x);
            cells.mean[cell] = (1e3 * residual.height).max(0.0);
            cells.deviation[cell] = (-1e3 * residual.height).max(0.0);
        }
        cells
    }

    /// Draws filled cells in bands of an eighth of the peak, clipped to the surface. `id`: unique on the page.
    fn draw(&self, view: &View, surface: &Surface, id: &str, values: &[f64]) -> Markup {
        let peak = find_peak(values);
        let mut bands: [Pen; BANDS] = Default::default();
        for (cell, value) in values.iter().enumerate() {
            let Some(band) = find_band(*value, peak) else {
                continue;
            };
            let corner = Vector2::new((cell % self.columns) as f64, (cell / self.columns) as f64);
            let corner = self.low + self.side * corner;
            let (low, high) = (
                view.at(corner),
                view.at(corner + Vector2::repeat(self.side)),
            );
            bands[band].line([low, (high.0, low.1), high, (low.0, high.1)]);
            bands[band].close();
        }
        html! {
            clipPath id=(id) { path clip-rule="evenodd" d=(view.rings(surface.outline.rings())) {} }
            g clip-path=(format!("url(#{id})")) {
                @for (i, band) in bands.into_iter().enumerate() {
                    path class=(format!("cell band-{}", i + 1)) d=(band.path()) {}
                }
            }
        }
    }
}

/// Returns a round cell size [m] with which uniform particles give about one per cell; with smaller cells, colours have no
/// meaning.
pub(crate) fn cell_side(bounds: &Bounds2, particles: usize) -> f64 {
    let size = bounds.size();
    let cell = (size.x * size.y / particles.max(1) as f64).sqrt();
    let longest = size.max();
    find_tick_step(cell.clamp(longest / MOST_CELLS, longest))
}

fn find_peak(values: &[f64]) -> f64 {
    values.iter().copied().fold(0.0, f64::max)
}

/// Returns the band of a value, an eighth of the peak each; `None` for 0.
fn find_band(value: f64, peak: f64) -> Option<usize> {
    let some = value > 0.0 && peak > 0.0;
    some.then(|| ((value / peak * BANDS as f64).ceil() as usize).clamp(1, BANDS) - 1)
}

/// Returns the bounds of the surface and of particles that fell off it.
fn find_drawn_bounds(surface: &Surface) -> Bounds2 {
    let mut bounds = extent(surface);
    let margin = Vector2::repeat(0.06 * bounds.size().max());
    bounds.min -= margin;
    bounds.max += margin;
    bounds
}

pub(crate) fn particles_figure(input: &RoundsInput, round: &RoundView) -> Figure {
    let cells = Cells::new(round.members(), input.goal, &input.task.surface);
    let views = draw_views(input, round, &cells);
    let panels = views.into_iter().map(|(panel, _)| panel).collect();
    Figure {
        panel: place_in_row(panels),
        entries: list_particle_entries(input, round),
        what: "Believed dirt before the round, and estimated and true dirt after it".to_owned(),
    }
}

pub(crate) fn density_figure(input: &RoundsInput, round: &RoundView) -> Figure {
    let cells = Cells::new(round.members(), input.goal, &input.task.surface);
    Figure {
        panel: place_in_row(draw_density_maps(input, round, &cells).into()),
        entries: Vec::new(),
        what: match round.members().len() {
            1 => format!("{}, in the only replay", choose_map_title(input.goal)),
            many => format!("{}, over {many} members", choose_map_title(input.goal)),
        },
    }
}

/// Draws where the contacts are above and below the fitted surface; `None` without a fitted surface.
pub(crate) fn contacts_figure(input: &RoundsInput, round: &RoundView) -> Option<Figure> {
    let residuals = &round.interpretation.residuals;
    if residuals.is_empty() {
        return None;
    }
    let cells = Cells::from_residuals(residuals);
    let named = [
        ("above", "contacts above the fitted surface"),
        ("below", "contacts below the fitted surface"),
    ];
    let panels = draw_maps(input, round, &cells, named, "mm, median per cell of 2 cm");
    Some(Figure {
        panel: place_in_row(panels.into()),
        entries: Vec::new(),
        what: "Distances of the contacts from the fitted surface".to_owned(),
    })
}

/// Returns the title of the maps.
fn choose_map_title(goal: &GoalState) -> &'static str {
    if goal.action().treats() {
        "Passes"
    } else {
        "Particles still to be wiped"
    }
}

/// Places panels in a row.
fn place_in_row(panels: Vec<Panel>) -> Panel {
    let width = panels.iter().map(|panel| panel.width + GAP).sum::<f64>() + GAP;
    let height = panels.iter().map(|panel| panel.height).fold(0.0, f64::max) + 8.0;
    let mut left = GAP;
    let placed: Vec<(f64, Panel)> = (panels.into_iter())
        .map(|panel| {
            let at = left;
            left += panel.width + GAP;
            (at, panel)
        })
        .collect();
    let width = width.max(NARROWEST);
    Panel {
        width,
        height,
        body: html! {
            @for (left, panel) in &placed {
                g transform=(format!("translate({} 0)", px(*left))) { (panel.body) }
            }
        },
    }
}

/// Returns the views with their descriptions: believed, estimated and true dirt.
fn draw_views(input: &RoundsInput, round: &RoundView, cells: &Cells) -> Vec<(Panel, String)> {
    let view = fit_view(input, VIEW);
    let typical = round.typical_replay(input);
    let performance = round.interpretation.performance;
    let planned = html! {
        (draw_particles(input, &view, round.believed))
        (draw_strokes(round, &view))
    };
    let id = format!("round-{}-estimated", round.number);
    let estimated = html! {
        g class="under-particles" { (cells.draw(&view, &input.task.surface, &id, &cells.mean)) }
        (draw_particles(input, &view, typical))
    };
    let mut views = vec![
        draw_view(
            input,
            &view,
            match round.plan {
                Some(_) => "believed before, with the plan",
                None => "believed before",
            },
            planned,
        ),
        draw_view(
            input,
            &view,
            &format!("estimated: {}", format_percent(performance.mean)),
            estimated,
        ),
    ];
    if let Some((truth, share)) = round.truth {
        let name = format!("true: {}", format_percent(share));
        views.push(draw_view(
            input,
            &view,
            &name,
            draw_particles(input, &view, truth),
        ));
    }
    views
}

fn fit_view(input: &RoundsInput, width: f64) -> View {
    let size = Vector2::new(width, TALLEST * width);
    View::fit(find_drawn_bounds(&input.task.surface), 0.0, NAME, size)
}

/// Draws a view with its name, the surface, `layers`, obstacles and a frame.
fn draw_view(input: &RoundsInput, view: &View, name: &str, layers: Markup) -> (Panel, String) {
    let radius = input.task.tool.collision_radius();
    let obstacles = obstacle_rings(input.task, radius);
    let inner = html! {
        (draw_ground(view, &input.task.surface, input.goal))
        (layers)
        path class="outline" d=(view.rings(input.task.surface.outline.rings())) {}
        @if !obstacles.is_empty() {
            path class="obstacle" d=(view.rings(obstacles.iter().map(Vec::as_slice))) {}
        }
    };
    let panel = Panel {
        width: view.width(),
        height: NAME + view.height() + 1.0,
        body: html! {
            text class="text strong" x="0" y="15" { (shorten(name, 44)) }
            (inset(view, inner))
            rect class="rule" x="0.5" y=(px(NAME)) width=(px(view.width() - 1.0)) height=(px(view.height())) {}
        },
    };
    (panel, format!("Particles {name}"))
}

fn draw_particles(input: &RoundsInput, view: &View, particles: &ParticleDistribution) -> Markup {
    let places: Vec<Point2> = particles.iter().map(|(place, _)| place).collect();
    let drawn: Vec<(Point2, Outcome)> = (thin_places(&places, MAX_DRAWN, input.task.action).iter())
        .map(|&i| {
            let particle = (places[i], particles.fate(i));
            (
                places[i],
                outcome(input.goal, &input.task.surface, particle),
            )
        })
        .collect();
    let radius = dot_radius(view, drawn.len()).clamp(0.8, 2.4);
    let mut rims = Pen::default();
    for (position, outcome) in &drawn {
        if matches!(outcome, Outcome::Left | Outcome::Done) {
            rims.dot(view.at(*position));
        }
    }
    html! {
        path class="dot-rim" stroke-width=(px(2.0 * radius + 1.8)) d=(rims.path()) {}
        (surface::particles(view, drawn, radius))
    }
}

/// Draws the planned strokes.
fn draw_strokes(round: &RoundView, view: &View) -> Markup {
    let strokes = round.plan.iter().flat_map(|plan| &plan.strokes);
    let lines: String = strokes
        .map(|stroke| view.line(stroke.poses.iter().map(|pose| pose.position)))
        .collect();
    html! { path class="trail" d=(lines) {} }
}

fn list_particle_entries(input: &RoundsInput, round: &RoundView) -> Vec<Entry> {
    let distributions = [round.believed, round.typical_replay(input)]
        .into_iter()
        .chain(round.truth.map(|(particles, _)| particles));
    let outcomes: Vec<Outcome> = distributions
        .flat_map(ParticleDistribution::iter)
        .map(|particle| outcome(input.goal, &input.task.surface, particle))
        .collect();
    let has = |outcome| outcomes.contains(&outcome);
    let mut entries = Vec::new();
    if has(Outcome::Left) {
        entries.push(legend::dot("dots-left", open_label(input.goal)));
    }
    if has(Outcome::Done) {
        entries.push(legend::dot("dots-done", achieved_label(input.goal)));
    }
    if has(Outcome::Lost) {
        entries.push(Entry {
            label: lost_label(input.goal).to_owned(),
            sample: html! { path class="mark-lost" d="M8.5-3.5l7 7m0-7l-7 7" {} },
        });
    }
    if round.plan.is_some_and(|plan| !plan.strokes.is_empty()) {
        entries.push(legend::line("trail", "planned stroke"));
    }
    let dark = if input.goal.action().treats() {
        "more believed passes"
    } else {
        "more believed dirt"
    };
    entries.push(legend::area("band-4", dark));
    entries
}

/// Draws maps of mean and standard deviation by cell.
fn draw_density_maps(input: &RoundsInput, round: &RoundView, cells: &Cells) -> [Panel; 2] {
    let unit = format!(
        "per cell of {} cm",
        format_decimal(100.0 * cells.side, usize::from(cells.side < 0.01))
    );
    let mean = if input.goal.action().treats() {
        "mean number of passes"
    } else {
        "mean number of particles still to be wiped"
    };
    let named = [
        ("mean", mean),
        ("deviation", "standard deviation over the replays"),
    ];
    draw_maps(input, round, cells, named, &unit)
}

/// Draws both values of the cells, each with its colour scale. `named`: identifier and title of each map.
fn draw_maps(
    input: &RoundsInput,
    round: &RoundView,
    cells: &Cells,
    named: [(&str, &str); 2],
    unit: &str,
) -> [Panel; 2] {
    let view = fit_view(input, MAP);
    let [first, second] = named;
    [(first, &cells.mean), (second, &cells.deviation)].map(|((stem, name), values)| {
        let id = format!("round-{}-{stem}", round.number);
        let drawn = cells.draw(&view, &input.task.surface, &id, values);
        let (panel, _) = draw_view(input, &view, name, drawn);
        Panel {
            height: panel.height + RAMP,
            body: html! { (panel.body) (draw_colour_scale(panel.height + 10.0, values, unit)) },
            ..panel
        }
    })
}

/// Draws the colour scale of a map.
fn draw_colour_scale(top: f64, values: &[f64], unit: &str) -> Markup {
    const CELL: f64 = 24.0;
    let peak = find_peak(values);
    html! {
        @if peak > 0.0 {
            @for band in 1..=BANDS {
                rect class=(format!("band-{band}")) x=(px(CELL * (band - 1) as f64)) y=(px(top)) width=(px(CELL)) height="12" {}
            }
            @for (share, class) in [(0.0, "text small quiet"), (0.5, "text small quiet middle"), (1.0, "text small quiet end")] {
                text class=(class) x=(px(share * CELL * BANDS as f64)) y=(px(top + 25.0)) { (format_decimal(share * peak, 2)) }
            }
            text class="text small quiet" x=(px(CELL * BANDS as f64 + 12.0)) y=(px(top + 10.0)) { (unit) }
        } @else {
            text class="text small quiet" x="0" y=(px(top + 10.0)) { "0 everywhere" }
        }
    }
}
