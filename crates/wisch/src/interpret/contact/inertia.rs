//! Inertia of the mass behind the force sensor.
//!
//! A sensor between robot and tool measures F = F_c − m a: the contact force less the mass of tool and holder times the
//! acceleration of the logged pose. In free motion F_c is 0, so the log shows m. A hand that moves the tool pushes along the
//! acceleration, inertia points against it.

use super::downsampling::MeasuredPiece;
use super::registration::in_space;
use super::weighted::median;
use crate::geometry::{Point3, Vector3};
use crate::interpret::config::InterpretConfig;
use crate::represent::Surface;
use nalgebra::Matrix3;

/// Time on either side of a piece over which a parabola is fitted to the positions [s], and the longest time to the
/// neighbours in logs with fewer poses [s].
const REACH: f64 = 0.05;
const LONGEST_REACH: f64 = 0.15;
/// Least acceleration that shows a mass [m/s²], and least time of such motion [s].
const LEAST_ACCELERATION: f64 = 0.5;
const LEAST_TIME: f64 = 0.2;
/// Largest force that a mass leaves unexplained, over its inertial force [1], and least share of the motion, weighted by the
/// square of the acceleration, in which it leaves no more [1].
const MOST_LEFT: f64 = 0.5;
const LEAST_EXPLAINED: f64 = 0.7;
/// Largest norm of the mean acceleration over the mean of its norm [1]: the force of inertia reverses as a motion ends,
/// the force of a hand does not.
const MOST_ONE_WAY: f64 = 0.7;
/// Quantile of the acceleration, weighted as above, at which the inertial force has to be large enough [1].
const STRONG: f64 = 0.75;

/// Inertial force of the mass behind the sensor.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Inertia {
    /// The mass [kg].
    pub(super) mass: f64,
    /// Force m a by piece, which is added to the measured one, in the axes of the believed surface at the piece [N].
    pub(super) forces: Vec<Vector3>,
}

impl Inertia {
    /// Returns the inertia that the forces in free motion show, or else that of the mass which the settings state; `None` if
    /// it produces no force that matters.
    ///
    /// # Parameters
    /// - `pieces`: with forces as read, without bias.
    /// - `is_clear`: whether the tool is above the surface at each piece.
    pub(super) fn of(
        pieces: &[MeasuredPiece],
        is_clear: &[bool],
        surface: &Surface,
        config: &InterpretConfig,
    ) -> Option<Self> {
        let accelerations = fit_accelerations(pieces, surface);
        let moving: Vec<usize> = (0..pieces.len())
            .filter(|&i| is_clear[i] && accelerations[i].norm() >= LEAST_ACCELERATION)
            .collect();
        let free = FreeMotion {
            pieces,
            accelerations: &accelerations,
            moving: &moving,
        };
        let stated = (config.moved_mass_kg > 0.0).then_some(config.moved_mass_kg);
        let mass = (free.estimate_mass(config.events.free_force_n[1]))
            .or_else(|| stated.filter(|mass| free.is_reduced_by(*mass)))?;
        let forces = (0..pieces.len()).map(|i| {
            let full = accelerations[i] * mass;
            // The parabola spreads the impact of a landing over the time before and after it.
            let is_settled = near(pieces, i).all(|j| is_clear[j]);
            let share = if is_settled {
                1.0
            } else {
                let square = full.norm_squared().max(f64::MIN_POSITIVE);
                (-pieces[i].force.dot(&full) / square).clamp(0.0, 1.0)
            };
            full * share
        });
        let forces = forces.collect();
        Some(Self { mass, forces })
    }
}

/// Accelerated free motion.
struct FreeMotion<'a> {
    pieces: &'a [MeasuredPiece],
    /// By piece [m/s²].
    accelerations: &'a [Vector3],
    /// Pieces of accelerated motion above the surface.
    moving: &'a [usize],
}

impl FreeMotion<'_> {
    /// Returns the one mass that explains the forces [kg]; `None` if no mass does, or if its inertial force is below `least`
    /// \[N\].
    fn estimate_mass(&self, least: f64) -> Option<f64> {
        let time: f64 = self.moving.iter().map(|&i| lasts(self.pieces, i)).sum();
        if time < LEAST_TIME {
            return None;
        }
        let ratios = self.moving.iter().map(|&i| {
            let acceleration = self.accelerations[i];
            let along = -self.pieces[i].force.dot(&acceleration) / acceleration.norm_squared();
            (along, self.weight(i))
        });
        let mass = median(ratios.collect());
        let left = |i: usize| (self.pieces[i].force + self.accelerations[i] * mass).norm();
        let is_explained = |i: &usize| left(*i) <= MOST_LEFT * mass * self.accelerations[*i].norm();
        let explained: Vec<usize> = (self.moving.iter().copied()).filter(is_explained).collect();
        let sum = |some: &[usize]| some.iter().map(|&i| self.weight(i)).sum::<f64>();
        let (mut way, mut all) = (Vector3::zeros(), 0.0);
        for &i in &explained {
            way += self.accelerations[i] * lasts(self.pieces, i);
            all += self.accelerations[i].norm() * lasts(self.pieces, i);
        }
        let mut sizes: Vec<(f64, f64)> = (explained.iter())
            .map(|&i| (self.accelerations[i].norm(), self.weight(i)))
            .collect();
        sizes.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
        let mut passed = 0.0;
        let strong = sizes.iter().find(|(_, weight)| {
            passed += weight;
            passed >= STRONG * sum(&explained)
        })?;
        (mass * strong.0 >= least
            && sum(&explained) >= LEAST_EXPLAINED * sum(self.moving)
            && way.norm() <= MOST_ONE_WAY * all)
            .then_some(mass)
    }

    /// Whether the forces are smaller without the inertia of a mass [kg].
    fn is_reduced_by(&self, mass: f64) -> bool {
        let size = |mass: f64| {
            let left = self.moving.iter().map(|&i| {
                let left = self.pieces[i].force + self.accelerations[i] * mass;
                (left.norm(), self.weight(i))
            });
            median(left.collect())
        };
        !self.moving.is_empty() && size(mass) < size(0.0)
    }

    /// Weight of a piece: time times the square of the acceleration, as the error of a mass is that of a force over the
    /// acceleration.
    fn weight(&self, i: usize) -> f64 {
        self.accelerations[i].norm_squared() * lasts(self.pieces, i)
    }
}

/// Fits z = c + b τ + ½ a τ² to the positions about each piece, and returns the accelerations a in the axes of the forces
/// [m/s²]; 0 where too few poses are near.
fn fit_accelerations(pieces: &[MeasuredPiece], surface: &Surface) -> Vec<Vector3> {
    let points: Vec<Point3> = (pieces.iter())
        .map(|piece| match piece.turn {
            Some(_) => in_space(&surface.shape, &piece.position),
            None => piece.position,
        })
        .collect();
    let fit = |i: usize| {
        let about = middle(&pieces[i]);
        let (mut normal, mut right) = (Matrix3::zeros(), Matrix3::zeros());
        let (mut before, mut after) = (0, 0);
        for j in near(pieces, i) {
            let time = pieces[j].time[1] - about;
            // Scaled by the reach, so that the matrix is well conditioned.
            let scaled = time / REACH;
            let row = Vector3::new(1.0, scaled, 0.5 * scaled * scaled);
            normal += row * row.transpose();
            right += row * (points[j] - points[i]).transpose();
            before += usize::from(j < i);
            after += usize::from(j > i);
        }
        if before == 0 || after == 0 {
            return Vector3::zeros();
        }
        let Some(inverse) = normal.try_inverse() else {
            return Vector3::zeros();
        };
        let acceleration: Vector3 = (inverse * right).row(2).transpose() / (REACH * REACH);
        (pieces[i].turn).map_or(acceleration, |turn| turn.inverse() * acceleration)
    };
    (0..pieces.len()).map(fit).collect()
}

/// Pieces within the reach of a piece, at least its neighbours unless they are far away in time.
fn near(pieces: &[MeasuredPiece], i: usize) -> std::ops::Range<usize> {
    let about = middle(&pieces[i]);
    let is_near = |j: usize, next: usize| {
        let off = (pieces[j].time[1] - about).abs();
        off <= REACH || next == i && off <= LONGEST_REACH
    };
    let mut range = i..i + 1;
    while range.start > 0 && is_near(range.start - 1, range.start) {
        range.start -= 1;
    }
    while range.end < pieces.len() && is_near(range.end, range.end - 1) {
        range.end += 1;
    }
    range
}

/// Time in the middle of a piece [s].
fn middle(piece: &MeasuredPiece) -> f64 {
    0.5 * (piece.time[0] + piece.time[1])
}

/// Time up to the next piece, at most the reach of a fit [s].
fn lasts(pieces: &[MeasuredPiece], i: usize) -> f64 {
    let end = (pieces.get(i + 1)).map_or(pieces[i].time[1], |next| next.time[0]);
    (end - pieces[i].time[0]).min(REACH)
}
