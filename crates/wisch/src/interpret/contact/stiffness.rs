//! Estimate of the tool's stiffness from a log: the harder the tool presses, the closer it is to the plane.
//!
//! The height over the plane falls by 1/k per newton and lags behind a changing force, as the tool is damped and forces
//! are measured with a delay. Both are fitted to short stretches of contact, each about its own mean, as no surface is
//! exactly plane. The disagreement between stretches gives the standard error.

use super::path::PathPiece;
use nalgebra::{Matrix2, Vector2};
use std::ops::Range;

/// Longest stretch that is fitted about its own mean [s].
const STRETCH: f64 = 0.4;
/// Number of pieces on either side over which the normal speed is taken.
const SPEED_REACH: usize = 2;
/// Least share of the nominal force at which the whole tool touches [1].
const LEAST_SHARE: f64 = 0.15;
/// Least change of the force within a stretch over the nominal force [1], at which noise of the force hardly matters.
const LEAST_CHANGE: f64 = 0.3;
/// Least number of stretches for a standard error.
const MIN_STRETCHES: usize = 4;

/// Model error, as a standard deviation of the logarithm [1]: tools rock when they land, and surfaces bend. Chosen on
/// seeds 2004 to 2058 of `wisch eval calibration`, where 18 measured stiffnesses have a root mean square error of 0.12.
const MODEL: f64 = 0.12;
/// Deviation from the belief, in standard deviations, beyond which a measurement is rejected.
const FARTHEST: f64 = 3.0;

/// The stiffness of a tool, as estimated from its compression.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ToolStiffness {
    /// Most likely value [N/m].
    pub n_per_m: f64,
    /// Standard deviation of its logarithm \[1\].
    pub ln_deviation: f64,
    /// Whether it is the declared stiffness, because no log shows another value.
    pub is_assumed: bool,
}

/// Log-normal belief about a tool's stiffness.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::interpret) struct StiffnessBelief {
    /// Mean of the logarithm of the stiffness over that of the settings [1].
    ln_scale: f64,
    /// Its standard deviation [1].
    deviation: f64,
}

impl StiffnessBelief {
    /// Returns the belief about the stiffness of the settings, with this standard deviation of the logarithm [1].
    pub(in crate::interpret) const fn prior(deviation: f64) -> Self {
        Self {
            ln_scale: 0.0,
            deviation,
        }
    }

    /// Updates the belief by a measurement (Kalman update of the logarithm). No other parameter of a member depends on
    /// the stiffness, so each member moves along its own quantile and none is lost to resampling.
    #[must_use]
    pub(in crate::interpret) fn update(self, measured: Option<MeasuredStiffness>) -> Self {
        let Some(measured) = measured else {
            return self;
        };
        let variance = self.deviation * self.deviation;
        let error = measured.deviation * measured.deviation + MODEL * MODEL;
        let off = measured.ln_scale - self.ln_scale;
        if off.abs() > FARTHEST * (variance + error).sqrt() {
            return self;
        }
        // Kalman gain of a scalar: prior variance over the sum of prior and measurement variance.
        let gain = variance / (variance + error);
        Self {
            ln_scale: self.ln_scale + gain * off,
            deviation: (variance * (1.0 - gain)).sqrt(),
        }
    }

    /// Stiffness over that of the settings, this many standard deviations from the mean [1].
    pub(in crate::interpret) fn scale(self, deviations: f64) -> f64 {
        libm::exp(self.ln_scale + self.deviation * deviations)
    }

    /// Returns the belief as a stiffness; `n_per_m` is that of the settings [N/m].
    pub(in crate::interpret) fn of_tool(self, n_per_m: f64, is_assumed: bool) -> ToolStiffness {
        ToolStiffness {
            n_per_m: n_per_m * self.scale(0.0),
            ln_deviation: self.deviation,
            is_assumed,
        }
    }
}

/// Stiffness over that of the settings, as one log shows it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::interpret) struct MeasuredStiffness {
    /// Logarithm of the stiffness over that of the settings [1].
    ln_scale: f64,
    /// Standard error, from the spread of the stretches [1].
    deviation: f64,
}

/// Sums over one stretch: products of the regressors (force, speed) with each other and with the height, about their
/// means.
struct Stretch {
    squares: Matrix2<f64>,
    products: Vector2<f64>,
}

impl MeasuredStiffness {
    /// Measures the stiffness over the pieces that `is_usable` accepts. `nominal_force` [N] compresses the tool by
    /// `compression` [m]. `None` if the force hardly changes or the tool does not compress.
    pub(in crate::interpret) fn of(
        path: &[PathPiece],
        nominal_force: f64,
        compression: f64,
        is_usable: impl Fn(usize) -> bool,
    ) -> Option<Self> {
        let least = LEAST_SHARE * nominal_force;
        let is_usable = |i: usize| {
            let pressed = -path[i].normal_force;
            is_usable(i) && (least..=nominal_force).contains(&pressed) && speed(path, i).is_some()
        };
        let mut stretches: Vec<Stretch> = Vec::new();
        let mut first = 0;
        while first < path.len() {
            let end = (first..path.len())
                .find(|&i| !is_usable(i) || path[i].time[1] - path[first].time[0] > STRETCH)
                .unwrap_or(path.len());
            stretches.extend(Stretch::of(path, first..end, LEAST_CHANGE * nominal_force));
            first = end.max(first + 1);
        }
        if stretches.len() < MIN_STRETCHES {
            return None;
        }
        let squares: Matrix2<f64> = stretches.iter().map(|one| one.squares).sum();
        let products: Vector2<f64> = stretches.iter().map(|one| one.products).sum();
        let inverse = squares.try_inverse()?;
        // Least squares over all stretches: fitted = (Σ RᵀR)⁻¹ Σ Rᵀh.
        let fitted = inverse * products;
        // Contribution of each stretch to the gradient at the fit; their outer products give the sandwich variance.
        let pulls = stretches.iter().map(|one| {
            let pull = one.products - one.squares * fitted;
            pull * pull.transpose()
        });
        let count = stretches.len() as f64;
        let spread = pulls.sum::<Matrix2<f64>>() * (count / (count - 2.0));
        let variance = (inverse * spread * inverse)[(0, 0)];
        let believed = compression / nominal_force;
        let scale = believed / -fitted[0];
        (scale.is_finite() && scale > 0.0).then(|| Self {
            ln_scale: libm::log(scale),
            deviation: variance.sqrt() / fitted[0].abs(),
        })
    }
}

impl Stretch {
    fn of(path: &[PathPiece], pieces: Range<usize>, least_change: f64) -> Option<Self> {
        let rows: Vec<[f64; 3]> = pieces
            .filter_map(|i| Some([-path[i].normal_force, speed(path, i)?, path[i].height]))
            .collect();
        let forces = rows.iter().map(|row| row[0]);
        let most = forces.clone().fold(f64::NEG_INFINITY, f64::max);
        if rows.len() < 3 || most - forces.fold(f64::INFINITY, f64::min) < least_change {
            return None;
        }
        let mut means = [0.0; 3];
        for row in &rows {
            (0..3).for_each(|k| means[k] += row[k] / rows.len() as f64);
        }
        let mut stretch = Self {
            squares: Matrix2::zeros(),
            products: Vector2::zeros(),
        };
        for row in &rows {
            let regressors = Vector2::new(row[0] - means[0], row[1] - means[1]);
            stretch.squares += regressors * regressors.transpose();
            stretch.products += regressors * (row[2] - means[2]);
        }
        Some(stretch)
    }
}

/// Speed along the plane's normal at a piece [m/s].
fn speed(path: &[PathPiece], i: usize) -> Option<f64> {
    let before = &path[i.checked_sub(SPEED_REACH)?];
    let after = path.get(i + SPEED_REACH)?;
    let middle = |piece: &PathPiece| 0.5 * (piece.time[0] + piece.time[1]);
    Some((after.height - before.height) / (middle(after) - middle(before)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Point3, Vector2};
    use crate::interpret::contact::Touch;

    const NOMINAL_FORCE: f64 = 10.0;
    const COMPRESSION: f64 = 5e-3;

    /// Simulates a damped tool with `scale` times a stiffness of 2 kN/m that lands and lifts eight times at 1 cm/s;
    /// `wave` is the amplitude of the surface's height [m].
    fn landings(scale: f64, wave: f64) -> Vec<PathPiece> {
        let stiffness = scale * NOMINAL_FORCE / COMPRESSION;
        let damping = 20.0;
        (0..1600)
            .map(|i| {
                let time = f64::from(i) * 0.01;
                let phase = time % 2.0;
                let (depth, speed) = if phase < 1.0 {
                    (phase * 0.01, 0.01)
                } else {
                    ((2.0 - phase) * 0.01, -0.01)
                };
                let depth = depth - 5e-3;
                let force = if depth > 0.0 {
                    (stiffness * depth + damping * speed).max(0.0)
                } else {
                    0.0
                };
                let bump = wave * libm::sin(1.7 * time);
                PathPiece {
                    time: [time, time + 0.01],
                    position: Point3::new(0.01 * time, 0.0, -depth),
                    heading: 0.0,
                    normal_force: -force,
                    tangential_force: 0.0,
                    normalized_force: (force / NOMINAL_FORCE).clamp(0.0, 1.0),
                    height: COMPRESSION / scale - depth + bump,
                    slope: Vector2::zeros(),
                    touch: Touch::Weak,
                }
            })
            .collect()
    }

    fn measured(path: &[PathPiece]) -> Option<MeasuredStiffness> {
        MeasuredStiffness::of(path, NOMINAL_FORCE, COMPRESSION, |_| true)
    }

    #[test]
    fn landings_show_how_stiff_a_damped_tool_is() {
        for scale in [0.7, 1.0, 1.3] {
            let measured = measured(&landings(scale, 0.0)).unwrap();
            let off = measured.ln_scale - libm::log(scale);
            assert!(off.abs() < 0.02, "{scale}: {measured:?}");
            assert!(measured.deviation < 0.02, "{scale}: {measured:?}");
        }
    }

    #[test]
    fn a_surface_with_waves_is_trusted_less() {
        let even = measured(&landings(1.0, 0.0)).unwrap();
        let wavy = measured(&landings(1.0, 2e-3)).unwrap();
        assert!(
            wavy.deviation > 3.0 * even.deviation,
            "{even:?}, then {wavy:?}"
        );
    }

    #[test]
    fn an_even_force_shows_nothing() {
        let mut path = landings(1.0, 0.0);
        for piece in &mut path {
            piece.normal_force = -0.9 * NOMINAL_FORCE;
        }
        assert_eq!(measured(&path), None);
        assert_eq!(measured(&[]), None);
        let unusable =
            MeasuredStiffness::of(&landings(1.0, 0.0), NOMINAL_FORCE, COMPRESSION, |_| false);
        assert_eq!(unusable, None);
    }

    #[test]
    fn a_measurement_moves_every_member_and_narrows_their_spread() {
        let prior = StiffnessBelief::prior(0.2);
        let measured = MeasuredStiffness {
            ln_scale: 0.3,
            deviation: 0.05,
        };
        let believed = prior.update(Some(measured));
        // 0.04 against 0.0025 + 0.0144.
        assert!((believed.ln_scale - 0.211).abs() < 1e-3, "{believed:?}");
        assert!((believed.deviation - 0.109).abs() < 1e-3, "{believed:?}");
        assert!(believed.scale(-1.0) > prior.scale(-1.0));
        assert!(believed.scale(1.0) / believed.scale(-1.0) < prior.scale(1.0) / prior.scale(-1.0));
        assert!((believed.of_tool(2000.0, false).n_per_m - 2000.0 * 1.235).abs() < 5.0);
    }

    #[test]
    fn an_exact_belief_or_an_impossible_measurement_changes_nothing() {
        let prior = StiffnessBelief::prior(0.2);
        let absurd = MeasuredStiffness {
            ln_scale: 1.2,
            deviation: 0.15,
        };
        assert_eq!(prior.update(Some(absurd)), prior);
        assert_eq!(prior.update(None), prior);
        let known = StiffnessBelief::prior(0.0);
        let measured = MeasuredStiffness {
            ln_scale: 0.2,
            deviation: 0.05,
        };
        assert_eq!(known.update(Some(measured)), known);
    }
}
