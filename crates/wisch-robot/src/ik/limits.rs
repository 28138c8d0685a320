//! Position limits as half-spaces of a chain's variables: lower ≤ normal · q ≤ upper.

use super::JointPositions;
use crate::{Chain, JointKind, Range, RobotModel};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use std::f64::consts::PI;

/// Distance that a sum of variables keeps from its limits, against rounding [rad or m].
const SUM_MARGIN: f64 = 1e-9;

/// Tolerance of a limit [rad or m]; far below [`SUM_MARGIN`].
const ROUNDING: f64 = 1e-12;

/// Largest number of rounds of projecting positions onto one limit after the other.
const PROJECTION_ROUNDS: usize = 200;

/// Largest distance of random positions of a sliding joint from a reference [m], as a base may have a wide range.
const SLIDE_REACH: f64 = 1.0;

/// Share of a range at either end from which joints are pushed inwards [1].
const OUTER_PART: f64 = 0.1;

/// The limits of a chain.
#[derive(Debug, Clone)]
pub(super) struct Limits {
    slides: Vec<bool>,
    limits: Vec<Limit>,
}

/// A limit lower ≤ normal · q ≤ upper; the unit normal is given as pairs of a variable and its component.
#[derive(Debug, Clone)]
pub(super) struct Limit {
    normal: Vec<(usize, f64)>,
    lower: f64,
    upper: f64,
    /// Change of the value per radian of the joint; `None` if it slides.
    per_rad: Option<f64>,
}

impl Limits {
    pub(super) fn new(robot: &RobotModel, chain: &Chain) -> Self {
        let variables = chain.variables();
        let own = |variable: usize| variables.binary_search(&variable).ok();
        let mut limits = Vec::new();
        for joint in robot.joints() {
            let terms = &joint.drive.terms;
            let ours = terms
                .iter()
                .filter_map(|&(i, factor)| Some((own(i)?, factor)));
            let normal: Vec<(usize, f64)> = ours.filter(|(_, factor)| *factor != 0.0).collect();
            if let Some(range) = joint.limits.position
                && normal.len() == terms.len()
                && !normal.is_empty()
            {
                let slides = joint.kind == JointKind::Prismatic;
                limits.push(Limit::new(normal, joint.drive.offset, range, slides));
            }
        }
        let slides = |&i: &usize| robot.variable(i).kind == JointKind::Prismatic;
        Self {
            slides: variables.iter().map(slides).collect(),
            limits,
        }
    }

    /// Removes a margin at both ends of revolute joints [rad], at most a tenth of their range.
    pub(super) fn narrow(&mut self, margin: f64) {
        for limit in &mut self.limits {
            let range = Range {
                lower: limit.lower,
                upper: limit.upper,
            };
            let range = range.shrink(limit.per_rad.map_or(0.0, |per_rad| margin * per_rad));
            (limit.lower, limit.upper) = (range.lower, range.upper);
        }
    }

    pub(super) fn iter(&self) -> std::slice::Iter<'_, Limit> {
        self.limits.iter()
    }

    /// Returns the range of each variable alone; infinite for a joint without limits.
    fn range(&self, variable: usize) -> Range {
        let mut range = Range {
            lower: f64::NEG_INFINITY,
            upper: f64::INFINITY,
        };
        for limit in &self.limits {
            if let [(own, factor)] = limit.normal[..]
                && own == variable
            {
                let ends = [limit.lower / factor, limit.upper / factor];
                range.lower = range.lower.max(ends[0].min(ends[1]));
                range.upper = range.upper.min(ends[0].max(ends[1]));
            }
        }
        range
    }

    /// Returns the middle of each variable's limits (0 without limits), projected into coupled limits.
    pub(super) fn middle(&self) -> JointPositions {
        let mut q = JointPositions::zeros(self.slides.len());
        for (i, value) in q.iter_mut().enumerate() {
            let range = self.range(i);
            let middle = 0.5 * (range.lower + range.upper);
            *value = if middle.is_finite() { middle } else { 0.0 };
        }
        self.project(&mut q);
        q
    }

    /// Draws positions within the limits: angles from their whole range, or from one turn if that is unlimited; slides
    /// near the reference.
    pub(super) fn random(&self, reference: &[f64], random: &mut ChaCha8Rng) -> JointPositions {
        let mut q = JointPositions::copy_of(reference);
        for (i, value) in q.iter_mut().enumerate() {
            let range = self.range(i);
            let (lower, upper) = if self.slides[i] {
                (
                    range.lower.max(*value - SLIDE_REACH),
                    range.upper.min(*value + SLIDE_REACH),
                )
            } else if range.lower.is_finite() && range.upper.is_finite() {
                (range.lower, range.upper)
            } else {
                (range.lower.max(-PI), range.upper.min(PI))
            };
            *value = lower + (upper - lower) * random.random::<f64>();
        }
        self.project(&mut q);
        q
    }

    /// Projects positions into the limits.
    pub(super) fn project(&self, q: &mut [f64]) {
        for _ in 0..PROJECTION_ROUNDS {
            let mut moved = false;
            for limit in &self.limits {
                let value = limit.value(q);
                let excess = value - value.clamp(limit.lower, limit.upper);
                if excess.abs() > ROUNDING {
                    limit.add_to(q, -excess);
                    moved = true;
                }
            }
            if !moved {
                break;
            }
        }
        self.round(q);
    }

    /// Whether positions are within all limits.
    pub(super) fn hold(&self, q: &[f64]) -> bool {
        self.limits
            .iter()
            .all(|limit| limit.room(limit.value(q), 0.0).is_none())
    }

    /// Clamps variables that are outside their own limits by a rounding error.
    pub(super) fn round(&self, q: &mut [f64]) {
        for limit in &self.limits {
            if let [(own, 1.0)] = limit.normal[..] {
                q[own] = q[own].clamp(limit.lower, limit.upper);
            }
        }
    }
}

impl Limit {
    /// Returns the limit lower ≤ offset + Σ factor · q ≤ upper, with factors of any size.
    fn new(mut normal: Vec<(usize, f64)>, offset: f64, range: Range, slides: bool) -> Self {
        let norm = normal
            .iter()
            .map(|(_, factor)| factor * factor)
            .sum::<f64>()
            .sqrt();
        let direct = offset == 0.0 && normal[..] == [(normal[0].0, 1.0)];
        let margin = if direct { 0.0 } else { SUM_MARGIN };
        for (_, factor) in &mut normal {
            *factor /= norm;
        }
        let (lower, upper) = ((range.lower - offset) / norm, (range.upper - offset) / norm);
        let margin = margin.min(0.5 * (upper - lower));
        Self {
            normal,
            lower: lower + margin,
            upper: (upper - margin).max(lower + margin),
            per_rad: (!slides).then_some(1.0 / norm),
        }
    }

    pub(super) fn value(&self, q: &[f64]) -> f64 {
        self.normal.iter().map(|&(i, part)| part * q[i]).sum()
    }

    /// Adds a multiple of the normal to the positions.
    pub(super) fn add_to(&self, q: &mut [f64], amount: f64) {
        for &(i, part) in &self.normal {
            q[i] += amount * part;
        }
    }

    /// Returns the distance from `value` to the limit that a motion at `rate` approaches; `None` if it approaches none.
    pub(super) fn room(&self, value: f64, rate: f64) -> Option<f64> {
        let end = value + rate;
        if end > self.upper + ROUNDING {
            Some(self.upper - value)
        } else if end < self.lower - ROUNDING {
            Some(self.lower - value)
        } else {
            None
        }
    }

    /// Returns the displacement along the normal out of the outer parts of the range.
    pub(super) fn way_inwards(&self, value: f64) -> f64 {
        let width = OUTER_PART * (self.upper - self.lower);
        if !width.is_finite() {
            return 0.0;
        }
        (self.lower + width - value).max(0.0) - (value - (self.upper - width)).max(0.0)
    }
}
