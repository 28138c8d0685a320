//! One step of a descent, within the limits.

use super::limits::Limits;
use super::{JointPositions, MAX_CHAIN};
use nalgebra::{Cholesky, Const, Matrix6, Vector6};

/// Component of a limit's normal below which the held limits already prescribe it.
const DEPENDENT: f64 = 1e-6;

/// Task of a step: J Δq = e up to damping, and Δq = z in the null space.
#[derive(Debug, Clone)]
pub(super) struct Task {
    /// The columns of J, one per variable.
    pub(super) columns: [Vector6<f64>; MAX_CHAIN],
    /// e, the remaining error.
    pub(super) residual: Vector6<f64>,
    /// z, the desired null-space motion.
    pub(super) drift: JointPositions,
    /// λ of J† = Jᵀ (J Jᵀ + λ)⁻¹.
    pub(super) damping: f64,
    /// Longest null-space motion [rad or m].
    pub(super) max_drift: f64,
    /// Largest motion of a variable [rad or m].
    pub(super) max_step: f64,
}

/// Limits that are equations of the step.
struct Held {
    /// Orthonormalised normals of the held limits.
    normals: [JointPositions; MAX_CHAIN],
    count: usize,
    /// Motion that they prescribe.
    motion: JointPositions,
}

impl Task {
    /// Returns J q̇.
    fn rate(&self, qd: &[f64]) -> Vector6<f64> {
        self.columns
            .iter()
            .zip(qd)
            .map(|(column, qd)| column * *qd)
            .sum()
    }

    /// Returns the step from `q`, scaled to the longest one, that keeps all limits that `q` keeps.
    pub(super) fn step(mut self, q: &[f64], limits: &Limits) -> JointPositions {
        let mut step = self.free_step();
        self.shorten(&mut step);
        let Some(mut worst) = worst(q, &step, limits) else {
            return step;
        };
        let mut held = Held {
            normals: [JointPositions::zeros(q.len()); MAX_CHAIN],
            count: 0,
            motion: JointPositions::zeros(q.len()),
        };
        while self.hold(&mut held, &worst) {
            step = self.free_step();
            for (own, prescribed) in step.iter_mut().zip(held.motion.iter()) {
                *own += prescribed;
            }
            self.shorten(&mut step);
            match self::worst(q, &step, limits) {
                Some(next) => worst = next,
                None => return step,
            }
        }
        clip(q, &mut step, limits);
        step
    }

    /// Returns the step of (7), Δq = J†e + (1 − J†J) z, with the second part limited in length.
    fn free_step(&self) -> JointPositions {
        let n = self.drift.len();
        let mut step = JointPositions::zeros(n);
        let mut normal = Matrix6::from_diagonal_element(self.damping);
        for column in &self.columns[..n] {
            normal.syger(1.0, column, column, 1.0);
        }
        let Some(normal) = Cholesky::<f64, Const<6>>::new(normal) else {
            return step;
        };
        // J†e = Jᵀ (J Jᵀ + λ)⁻¹ e, and the null-space part is z − Jᵀ (J Jᵀ + λ)⁻¹ J z.
        let towards = normal.solve(&self.residual);
        let back = normal.solve(&self.rate(&self.drift));
        let mut drift = self.drift;
        for (own, column) in drift.iter_mut().zip(&self.columns) {
            *own -= column.dot(&back);
        }
        let length = drift.iter().map(|d| d * d).sum::<f64>().sqrt();
        let part = if length > self.max_drift {
            self.max_drift / length
        } else {
            1.0
        };
        for (i, own) in step.iter_mut().enumerate() {
            *own = self.columns[i].dot(&towards) + part * drift[i];
        }
        step
    }

    fn shorten(&self, step: &mut [f64]) {
        let longest = step
            .iter()
            .fold(0.0, |longest: f64, s| longest.max(s.abs()));
        if longest > self.max_step {
            step.iter_mut().for_each(|s| *s *= self.max_step / longest);
        }
    }

    /// Makes a limit an equation of the step, and the remaining task orthogonal to it. Returns false if the held limits
    /// already prescribe the motion along it.
    fn hold(&mut self, held: &mut Held, broken: &Broken) -> bool {
        let n = self.drift.len();
        if held.count == n {
            return false;
        }
        // Gram–Schmidt: the part of the normal that is orthogonal to the held ones.
        let mut normal = JointPositions::zeros(n);
        broken.limit.add_to(&mut normal, 1.0);
        let missing = broken.room - broken.limit.value(&held.motion);
        for other in &held.normals[..held.count] {
            subtract(&mut normal, other);
        }
        let length = dot(&normal, &normal).sqrt();
        if length < DEPENDENT {
            return false;
        }
        normal.iter_mut().for_each(|part| *part /= length);
        let along = missing / length;
        let effect = self.rate(&normal);
        for i in 0..n {
            held.motion[i] += along * normal[i];
            self.columns[i] -= effect * normal[i];
        }
        self.residual -= effect * along;
        subtract(&mut self.drift, &normal);
        held.normals[held.count] = normal;
        held.count += 1;
        true
    }
}

/// A limit that a step breaks.
struct Broken<'a> {
    limit: &'a super::limits::Limit,
    /// Distance of the variables from the limit, along its normal.
    room: f64,
}

/// Returns the limit that a step exceeds most.
fn worst<'a>(q: &[f64], step: &[f64], limits: &'a Limits) -> Option<Broken<'a>> {
    let mut most = 0.0;
    let mut worst = None;
    for limit in limits.iter() {
        let (value, rate) = (limit.value(q), limit.value(step));
        if let Some(room) = limit.room(value, rate)
            && (rate - room).abs() > most
        {
            most = (rate - room).abs();
            worst = Some(Broken { limit, room });
        }
    }
    worst
}

/// Shortens a step to the first limit.
fn clip(q: &[f64], step: &mut [f64], limits: &Limits) {
    let mut part: f64 = 1.0;
    for limit in limits.iter() {
        let (value, rate) = (limit.value(q), limit.value(step));
        if let Some(room) = limit.room(value, rate) {
            part = part.min((room / rate).max(0.0));
        }
    }
    step.iter_mut().for_each(|s| *s *= part);
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Subtracts the component along a unit vector.
fn subtract(from: &mut [f64], unit: &[f64]) {
    let along = dot(from, unit);
    for (own, unit) in from.iter_mut().zip(unit) {
        *own -= along * unit;
    }
}
