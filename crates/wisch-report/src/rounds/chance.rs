//! The probability of an effect over contact force, and the measured contact forces; paper Fig. 11.

use super::input::{RoundView, RoundsInput};
use super::reduce;
use crate::draw::{
    Figure, GAP, Panel, Pen, axes, count_decimals, find_tick_step, format_decimal, format_percent,
    px,
};
use maud::{Markup, html};
use wisch::interpret::{PathPiece, Touch};
use wisch::represent::LogNormal;

const WIDTH: f64 = 430.0;
const LEFT: f64 = 52.0;
const RIGHT: f64 = WIDTH - 16.0;
const TOP: f64 = 28.0;
/// Bottom of the curve, and of the bars.
const CURVE: f64 = 190.0;
const BARS: f64 = 258.0;
const HEIGHT: f64 = BARS + 42.0;
/// Number of bars of the histogram.
const BINS: usize = 20;
/// Curves are drawn at this many quantiles, from −Z to Z standard deviations of ln x.
const POINTS: usize = 160;
const Z: f64 = 4.0;
/// Maximum of the density's axis; beyond it, a contact with full force has no effect.
const MOST_X: f64 = 3.0;

/// Distribution of the time in contact over f'.
struct Histogram {
    /// Share of the time in contact, per twentieth of f'.
    shares: [f64; BINS],
    /// Time in contact [s].
    total: f64,
    /// Mean of P(X ≤ f') over the time in contact.
    chance: f64,
}

impl Histogram {
    fn new(path: &[PathPiece], likelihood: &LogNormal) -> Self {
        let mut histogram = Self {
            shares: [0.0; BINS],
            total: 0.0,
            chance: 0.0,
        };
        for (i, piece) in path.iter().enumerate() {
            if !matches!(piece.touch, Touch::Weak | Touch::Confident) {
                continue;
            }
            let duration = PathPiece::duration(path, i);
            let bin = (BINS as f64 * piece.normalized_force) as usize;
            histogram.shares[bin.min(BINS - 1)] += duration;
            histogram.total += duration;
            histogram.chance += duration * likelihood.probability(piece.normalized_force);
        }
        if histogram.total > 0.0 {
            let total = histogram.total;
            histogram.shares = histogram.shares.map(|time| time / total);
            histogram.chance /= total;
        }
        histogram
    }
}

/// Draws both plots side by side.
pub(crate) fn figure(input: &RoundsInput, round: &RoundView) -> Figure {
    let [curve, density] = draw_panels(input, round);
    Figure {
        panel: Panel {
            width: 2.0 * WIDTH + GAP,
            height: HEIGHT,
            body: html! {
                (curve.body)
                g transform=(format!("translate({} 0)", px(WIDTH + GAP))) { (density.body) }
            },
        },
        entries: Vec::new(),
        what: "Probability of an effect over contact force, and contact forces of this round"
            .to_owned(),
    }
}

fn build_histogram(input: &RoundsInput, round: &RoundView) -> Histogram {
    let path = reduce::select_usable(&round.interpretation.path);
    Histogram::new(&path, &input.task.interaction.likelihood)
}

fn draw_panels(input: &RoundsInput, round: &RoundView) -> [Panel; 2] {
    let likelihood = &input.task.interaction.likelihood;
    let bodies = [
        draw_probability(likelihood, &build_histogram(input, round)),
        draw_density(likelihood),
    ];
    bodies.map(|body| Panel {
        width: WIDTH,
        height: HEIGHT,
        body,
    })
}

fn map_across(x: f64, most: f64) -> f64 {
    LEFT + (RIGHT - LEFT) * (x / most).clamp(0.0, 1.0)
}

fn map_down(share: f64, bottom: f64, top: f64) -> f64 {
    bottom - share.clamp(0.0, 1.0) * (bottom - top)
}

/// Returns the forces at which the curves are evaluated, dense where they bend.
fn list_curve_forces(likelihood: &LogNormal, most: f64) -> Vec<f64> {
    let quantile = |i: usize| {
        let z = Z * (2.0 * i as f64 / POINTS as f64 - 1.0);
        (likelihood.mu + likelihood.sigma * z).exp()
    };
    let inner = (0..=POINTS).map(quantile);
    let inner = inner.filter(|&x| x > 0.0 && x < most);
    [0.0].into_iter().chain(inner).chain([most]).collect()
}

/// Draws P(X ≤ f'), with the histogram below.
fn draw_probability(likelihood: &LogNormal, histogram: &Histogram) -> Markup {
    let mut curve = Pen::default();
    let places = list_curve_forces(likelihood, 1.0).into_iter().map(|f| {
        let share = likelihood.probability(f);
        (map_across(f, 1.0), map_down(share, CURVE, TOP))
    });
    curve.line(places);
    let most = histogram.shares.iter().copied().fold(0.0, f64::max);
    let bar = |i: usize| {
        let share = if most > 0.0 {
            histogram.shares[i] / most
        } else {
            0.0
        };
        let (left, right) = (
            map_across(i as f64 / BINS as f64, 1.0),
            map_across((i + 1) as f64 / BINS as f64, 1.0),
        );
        (left, right - left, map_down(share, BARS, CURVE + 26.0))
    };
    html! {
        text class="text small quiet" x="8" y="14" { "P(X ≤ f'), the probability of an effect" }
        (axes::draw_ticks_beside(axes::list_quarters(|share| map_down(share, CURVE, TOP)), [LEFT, RIGHT], 6.0))
        @if (0.0..1.0).contains(&likelihood.mu.exp()) {
            @let median = map_across(likelihood.mu.exp(), 1.0);
            path class="lifted" d=(format!("M{} {}V{}", px(median), px(CURVE), px(map_down(0.5, CURVE, TOP)))) {}
        }
        path class="curve" d=(curve.path()) {}
        text class="text small quiet" x="8" y=(px(CURVE + 18.0)) {
            @if most > 0.0 { "share of the contact time (peak: " (format_percent(most)) ")" } @else { "no contact" }
        }
        @for (left, width, top) in (0..BINS).map(bar) {
            @if BARS - top > 0.05 {
                rect class="contact-time" x=(px(left + 0.5)) y=(px(top)) width=(px(width - 1.0)) height=(px(BARS - top)) {}
            }
        }
        (draw_force_axis(1.0, BARS, "normalised contact force f'"))
    }
}

/// Draws p(x), with the part that full force covers.
fn draw_density(likelihood: &LogNormal) -> Markup {
    let LogNormal { mu, sigma } = *likelihood;
    let most = (mu + 2.6 * sigma).exp().clamp(1.2, MOST_X);
    let p = |x: f64| {
        let score = (x.ln() - mu) / sigma;
        let value = (-0.5 * score * score).exp() / (x * sigma * std::f64::consts::TAU.sqrt());
        if value.is_finite() { value } else { 0.0 }
    };
    let forces = list_curve_forces(likelihood, most);
    let peak = forces.iter().map(|&x| p(x)).fold(0.0, f64::max);
    let step = find_tick_step(peak / 4.0);
    let top = if peak > 0.0 { 1.05 * peak } else { 1.0 };
    let place = |x: f64| (map_across(x, most), map_down(p(x) / top, BARS, TOP));
    let (mut curve, mut under) = (Pen::default(), Pen::default());
    curve.line(forces.iter().map(|&x| place(x)));
    let covered = forces.iter().copied().filter(|&x| x < 1.0).chain([1.0]);
    let foot = |x: f64| (map_across(x, most), BARS);
    under.line(
        [foot(0.0)]
            .into_iter()
            .chain(covered.map(place))
            .chain([foot(1.0)]),
    );
    under.close();
    let full = map_across(1.0, most);
    let ticks = (0..=(top / step) as i64).map(|tick| {
        let value = tick as f64 * step;
        (
            map_down(value / top, BARS, TOP),
            format_decimal(value, count_decimals(step)),
        )
    });
    html! {
        text class="text small quiet" x="8" y="14" { "p(x), density of the minimum force with an effect" }
        (axes::draw_ticks_beside(ticks, [LEFT, RIGHT], 6.0))
        path class="under" d=(under.path()) {}
        path class="curve" d=(curve.path()) {}
        path class="lifted" d=(format!("M{} {}V{}", px(full), px(BARS), px(TOP))) {}
        text class="text small end" x=(px(full - 6.0)) y=(px(TOP + 12.0)) { "full force" }
        text class="text small quiet end" x=(px(full - 6.0)) y=(px(TOP + 26.0)) { (format_percent(likelihood.probability(1.0))) " below" }
        (draw_force_axis(most, BARS, "normalised force x"))
    }
}

fn draw_force_axis(most: f64, y: f64, label: &str) -> Markup {
    let step = find_tick_step(most / 6.0);
    let ticks = (0..=(most / step + 1e-9) as i64).map(|tick| {
        let value = tick as f64 * step;
        (
            map_across(value, most),
            format_decimal(value, count_decimals(step)),
        )
    });
    html! {
        path class="axis" d=(format!("M{} {}H{}", px(LEFT), px(y), px(RIGHT))) {}
        (axes::draw_ticks_below(ticks, y, 18.0))
        text class="text small quiet end" x=(px(RIGHT)) y=(px(y + 34.0)) { (label) " [1]" }
    }
}
