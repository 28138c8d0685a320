//! One step of a descent, within the limits.

use super::limits::Limits;
use super::{JointPositions, MAX_CHAIN};
use nalgebra::{Cholesky, Const, Matrix6, Vector6};

/// Part of a limit's normal below which those that already hold prescribe it.
const DEPENDENT: f64 = 1e-6;

/// What a step is for: J Δq = e, as far as damping lets it, and Δq = z where that leaves a choice.
#[derive(Debug, Clone)]
pub(super) struct Task {
    /// The columns of J, one per variable.
    pub(super) columns: [Vector6<f64>; MAX_CHAIN],
    /// e, what is left to do.
    pub(super) residual: Vector6<f64>,
    /// z, where the variables are drawn.
    pub(super) drift: JointPositions,
    /// λ of J† = Jᵀ (J Jᵀ + λ)⁻¹.
    pub(super) damping: f64,
    /// Longest motion that leaves the tool where it is [rad or m].
    pub(super) max_drift: f64,
    /// Farthest that a variable moves [rad or m].
    pub(super) max_step: f64,
}

/// Limits that hold as equations of the step.
struct Held {
    /// Their normals, made orthogonal.
    normals: [JointPositions; MAX_CHAIN],
    count: usize,
    /// The motion that they prescribe.
    motion: JointPositions,
}

impl Task {
    /// J q̇.
    fn rate(&self, qd: &[f64]) -> Vector6<f64> {
        self.columns
            .iter()
            .zip(qd)
            .map(|(column, qd)| column * *qd)
            .sum()
    }

    /// The step from `q`, scaled to its longest, that keeps all limits that `q` keeps.
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

    /// (7): Δq = J†e + (1 − J†J) z, the second part no longer than wanted.
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

    /// Makes a limit an equation of the step: what is left of the task is orthogonal to it. False if the
    /// limits that hold already prescribe the motion along it.
    fn hold(&mut self, held: &mut Held, broken: &Broken) -> bool {
        let n = self.drift.len();
        if held.count == n {
            return false;
        }
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
    /// How far from it the variables are, along its normal.
    room: f64,
}

/// The limit that a step exceeds most.
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

/// Takes the part along a unit vector away.
fn subtract(from: &mut [f64], unit: &[f64]) {
    let along = dot(from, unit);
    for (own, unit) in from.iter_mut().zip(unit) {
        *own -= along * unit;
    }
}
