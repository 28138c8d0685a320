//! Minimisation of joint travel along a row of configurations: the tool keeps its positions, while its yaw and
//! the rest of the null space are free.
//!
//! Gauss-Newton steps in the null spaces, with iteratively reweighted least squares, so that they minimise the
//! length of the path and not its square. A chain of configurations gives a block-tridiagonal system, which one
//! sweep solves.

use super::arm::Arm;
use crate::follow::{AllowedContact, ToolPose};
use crate::geometry::{PlanarPose, Point2};
use crate::robot::JointPositions;
use nalgebra::{Cholesky, DMatrix, DVector, Dyn};
use rayon::prelude::*;

/// Largest number of steps.
const MAX_STEPS: usize = 20;
/// Relative gain below which a step is the last [1].
const LEAST_GAIN: f64 = 1e-3;
/// Largest movement of a joint in one step [rad or m].
const MAX_CHANGE: f64 = 0.3;
/// Largest number of halvings of a step that does not shorten the path.
const MAX_HALVINGS: i32 = 3;
/// Length below which the weight of a piece grows no further [rad].
const SHORTEST: f64 = 1e-3;
/// Damping of the steps, against weights of the order of 1 / [`SHORTEST`].
const DAMPING: f64 = 1e-2;

/// Moves configurations that touch down at `places`, with any yaw, so that the joints move less between them.
pub(super) fn minimise_joint_travel(arm: &Arm, places: &[Point2], row: &mut Vec<JointPositions>) {
    if row.len() < 2 {
        return;
    }
    let mut length = movement(row);
    for _ in 0..MAX_STEPS {
        let Some(step) = step(arm, row) else { return };
        let shorter = (0..=MAX_HALVINGS).find_map(|halvings| {
            let share = 0.5_f64.powi(halvings);
            let tried = apply_step(arm, places, row, &step, share);
            Some((movement(&tried), tried)).filter(|(shorter, _)| *shorter < length)
        });
        let Some((shorter, tried)) = shorter else {
            return;
        };
        let gain = length - shorter;
        (*row, length) = (tried, shorter);
        if gain < LEAST_GAIN * length {
            return;
        }
    }
}

/// Returns the step of each configuration within its null space; `None` if a null space is empty.
fn step(arm: &Arm, row: &[JointPositions]) -> Option<Vec<DVector<f64>>> {
    let spaces: Vec<DMatrix<f64>> = row.par_iter().map(|q| arm.null_space(q)).collect();
    if spaces.iter().any(|space| space.ncols() == 0) {
        return None;
    }
    let between: Vec<(DVector<f64>, f64)> = (row.windows(2))
        .map(|pair| {
            let step = DVector::from_iterator(
                pair[0].len(),
                pair[0].iter().zip(pair[1].iter()).map(|(a, b)| b - a),
            );
            // With the weight w = 1 / |Δq|, half the sum of w |Δq|² has the gradient of the sum of |Δq|.
            let weight = 1.0 / step.norm().max(SHORTEST);
            (step, weight)
        })
        .collect();
    let count = row.len();
    // Normal equations (N, null spaces): diagonal blocks (w₋ + w₊ + damping) I, off-diagonal blocks −w N_iᵀ N_{i+1}.
    // Forward elimination by blocks, then back substitution.
    let mut pivots: Vec<Cholesky<f64, Dyn>> = Vec::with_capacity(count);
    let mut rests: Vec<DVector<f64>> = Vec::with_capacity(count);
    let coupling = |i: usize| spaces[i].tr_mul(&spaces[i + 1]) * -between[i].1;
    for (i, space) in spaces.iter().enumerate() {
        let mut weight = DAMPING;
        let mut pull = DVector::zeros(space.nrows());
        if let Some((step, w)) = between.get(i) {
            weight += w;
            pull += step * *w;
        }
        if i > 0 {
            let (step, w) = &between[i - 1];
            weight += w;
            pull -= step * *w;
        }
        let size = space.ncols();
        let mut pivot = DMatrix::identity(size, size) * weight;
        let mut rest = space.tr_mul(&pull);
        if i > 0 {
            let coupling = coupling(i - 1);
            pivot -= coupling.tr_mul(&pivots[i - 1].solve(&coupling));
            rest -= coupling.tr_mul(&pivots[i - 1].solve(&rests[i - 1]));
        }
        pivots.push(Cholesky::new(pivot)?);
        rests.push(rest);
    }
    let mut steps = vec![DVector::zeros(0); count];
    let mut next: Option<DVector<f64>> = None;
    for i in (0..count).rev() {
        let rest = match &next {
            Some(next) => &rests[i] - coupling(i) * next,
            None => rests[i].clone(),
        };
        let own = pivots[i].solve(&rest);
        steps[i] = &spaces[i] * &own;
        next = Some(own);
    }
    let widest = steps.iter().map(DVector::amax).fold(0.0, f64::max);
    if widest > MAX_CHANGE {
        steps
            .iter_mut()
            .for_each(|step| *step *= MAX_CHANGE / widest);
    }
    Some(steps)
}

/// Returns the configurations after a share of a step, corrected to their places; those that cannot be
/// corrected stay.
fn apply_step(
    arm: &Arm,
    places: &[Point2],
    row: &[JointPositions],
    step: &[DVector<f64>],
    share: f64,
) -> Vec<JointPositions> {
    let moved = (0..row.len()).into_par_iter().map(|i| {
        let wanted = row[i].iter().zip(step[i].iter());
        let wanted: JointPositions = wanted.map(|(q, step)| q + share * step).collect();
        touch_down_near(arm, places[i], &wanted).unwrap_or(row[i])
    });
    moved.collect()
}

/// Returns a configuration about as near to `near` as possible that touches down at a place without
/// collision.
pub(super) fn touch_down_near(
    arm: &Arm,
    place: Point2,
    near: &JointPositions,
) -> Option<JointPositions> {
    arm.nearest_with_free_yaw(&on_surface(place), near)
        .filter(|q| arm.is_free_at(q, AllowedContact::Surface))
}

/// Returns the pose of the tool on the surface at a place; its yaw is arbitrary.
pub(super) fn on_surface(place: Point2) -> ToolPose {
    ToolPose {
        surface_from_tool: PlanarPose::new(place, 0.0),
        height: 0.0,
        tilt: 0.0,
    }
}

/// Length of the joint path through these configurations [rad].
pub(in crate::follow) fn movement(row: &[JointPositions]) -> f64 {
    row.windows(2)
        .map(|pair| joint_distance(&pair[0], &pair[1]))
        .sum()
}

/// Joint distance between two configurations [rad].
pub(in crate::follow) fn joint_distance(from: &JointPositions, to: &JointPositions) -> f64 {
    let squares = from.iter().zip(to.iter()).map(|(a, b)| (b - a) * (b - a));
    squares.sum::<f64>().sqrt()
}
