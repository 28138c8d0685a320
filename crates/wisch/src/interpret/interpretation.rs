//! Result of an interpretation.

use super::belief::{Belief, Estimate, ObservationUpdate, PerformanceDistribution};
use super::contact::{ContactResidual, FittedPlane, PathPiece, ShapeFit, ToolStiffness};
use super::doubt::Doubt;
use super::events::Event;
use crate::geometry::Pose;
use crate::represent::{Action, GoalState, Observation};

/// Probability that the performance is unknown if an observation contradicts the number of particles [1].
const UNKNOWN_SHARE: f64 = 0.5;

/// Conclusion from the fitted plane: where the surface lies, or that there was no contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Diagnosis {
    /// The surface is where it was believed to be.
    Localized,
    /// The surface is misplaced: recovery plans with the pose that was found.
    Relocalize {
        /// Pose of the surface as found.
        world_from_surface: Pose,
    },
    /// Too few confident contacts for a plane, so the log gives no conclusion.
    NoContact,
    /// The contacts fit the believed surface at no pose, so its pose is unknown.
    Unfitted,
    /// The tool hovers and has no contact: the belief follows the positions of the tool alone.
    Hovering,
}

impl Diagnosis {
    /// Name of the diagnosis in files.
    pub fn as_str(&self) -> &'static str {
        match self {
            Self::Localized => "localized",
            Self::Relocalize { .. } => "relocalize",
            Self::NoContact => "no contact",
            Self::Unfitted => "unfitted",
            Self::Hovering => "hovering",
        }
    }
}

/// Contact, real plane of the surface and dirt, as inferred from a log of poses and forces; paper §4.2.
#[derive(Debug, Clone)]
pub struct Interpretation {
    /// The path, in pieces.
    pub path: Vec<PathPiece>,
    /// The fitted plane; `None` where there were too few contacts.
    pub plane: Option<FittedPlane>,
    /// Pose at which a curved surface fits the contacts, in all degrees of freedom that they determine; `None` for a plane,
    /// and where there were too few contacts.
    pub registration: Option<ShapeFit>,
    /// Distances of the contacts from the fitted surface, in cells of [`RESIDUAL_CELL`](super::RESIDUAL_CELL).
    pub residuals: Vec<ContactResidual>,
    /// Whether the surface is where it was believed to be.
    pub diagnosis: Diagnosis,
    /// Reasons why the log may not show wiping of this surface; empty where there are none.
    pub doubts: Vec<Doubt>,
    /// Detected events, sorted by start.
    pub events: Vec<Event>,
    /// Bias of the sensor along the surface's outward normal, as found in free motion and subtracted \[N\]; `None` where the
    /// log shows no free motion, so that the bias is unknown and nothing was subtracted.
    pub force_bias: Option<f64>,
    /// Force with which the tool pressed for most of its sliding, inferred from the log \[N\]; `None` where the tool slid
    /// over no plane.
    pub pressed_force: Option<f64>,
    /// Belief about the tool's stiffness after this log and those before it; `None` for a rigid tool.
    pub tool_stiffness: Option<ToolStiffness>,
    /// Time in contact over the time that the tool was on or near the surface \[1\]; `None` if it
    /// never was near, and if the log shows no contact with a plane, so that contact is unknown.
    pub contact_share: Option<f64>,
    /// Belief about the dirt after the log.
    pub belief: Belief,
    /// Distribution of the performance.
    pub distribution: PerformanceDistribution,
    /// Mean and 90 % interval of `distribution`.
    pub performance: Estimate,
    /// Estimate of the performance by touch alone, before any observation.
    pub by_touch: Estimate,
    /// The camera's observation after the log, if there was one.
    pub observation: Option<Observation>,
}

impl Interpretation {
    /// Whether the log or a later observation shows what was wiped. If not, the belief covers all
    /// possibilities, and the doubts state the reason, the most likely cause first.
    pub fn is_conclusive(&self) -> bool {
        let is_felt =
            self.diagnosis != Diagnosis::NoContact && !self.doubts.iter().any(Doubt::is_decisive);
        // Without contact, nothing explains an observation that differs from what was there before.
        let is_contradicted = (self.doubts.iter()).any(|doubt| {
            matches!(doubt, Doubt::ObservationContradicts { .. })
                && (doubt.is_decisive() || self.diagnosis == Diagnosis::NoContact)
                || *doubt == Doubt::UnprovenCamera
        });
        is_felt || (self.observation.is_some() && !is_contradicted)
    }

    /// Whether the tool may have wiped more than the log shows, and no observation decides: the estimate is a lower bound.
    pub fn is_lower_bound(&self) -> bool {
        self.observation.is_none() && self.doubts.iter().any(Doubt::is_cut)
    }

    /// Returns the least and the largest performance of an action: the ends of the 90 % interval, or the ends that wiping outside
    /// the log leaves possible if the estimate [is a lower bound](Self::is_lower_bound) \[1\].
    ///
    /// Such wiping may have reached everything. It may also have pushed dirt out of the goal of a collect, or coated points too
    /// thickly. The performance of a polish counts points with enough passes, which stay.
    pub fn range(&self, action: Action) -> [f64; 2] {
        let Estimate { low, high, .. } = self.performance;
        if !self.is_lower_bound() {
            return [low, high];
        }
        let stays = action.is_lasting() || action == Action::Polish;
        [if stays { low } else { 0.0 }, 1.0]
    }

    /// Adds a doubt about the data of the log. After a decisive doubt, the performance counts as
    /// possibly unknown.
    pub fn add_doubt(&mut self, doubt: Doubt) {
        if doubt.is_decisive() && !self.doubts.iter().any(Doubt::is_decisive) {
            self.distribution = self.distribution.or_unknown(UNKNOWN_SHARE, 0.0);
            self.performance = self.distribution.estimate();
            if self.observation.is_none() {
                self.by_touch = self.performance;
            }
        }
        self.doubts.push(doubt);
    }

    /// Updates belief and performance by an observation of the surface after the log. If the log
    /// and the belief before it contradict the number of observed grains, a [`Doubt`] is added.
    pub fn observe(&mut self, update: &ObservationUpdate<'_>) {
        let was_felt = self.diagnosis != Diagnosis::NoContact;
        let contradiction = update.find_contradiction(&self.belief, was_felt);
        let misplaced = update.find_other_frame(&self.belief);
        let is_proven = self.belief.was_seen || update.shows_dirt();
        let is_unproven = !is_proven && !self.belief.is_certain() && !self.is_conclusive();
        self.belief = self.belief.observe(update);
        // An observation leaves no model error: effects that the replays omit do not change the
        // detections.
        self.distribution = self.belief.performance(update.goal, update.surface, 0.0);
        if let Some(doubt) = contradiction {
            // Dirt that the tool never touched does not vanish, so some may have been overlooked. A camera that has shown no
            // dirt so far may detect none at all.
            let is_too_clean = matches!(&doubt, Doubt::ObservationContradicts { seen, left, untouched, is_first, .. }
                if (*seen as f64) < if *is_first { untouched.max(left[0]) } else { *untouched });
            if doubt.is_decisive() {
                self.distribution = self.distribution.or_unknown(UNKNOWN_SHARE, 0.0);
            } else if is_too_clean {
                self.distribution = self
                    .distribution
                    .or_unknown(UNKNOWN_SHARE, self.by_touch.low);
            }
            self.doubts.push(doubt);
        }
        if let Some(doubt) = misplaced {
            // Whether dirt is in the goal depends on its place.
            if matches!(update.goal, GoalState::Collected { .. }) {
                self.distribution = self.distribution.or_unknown(UNKNOWN_SHARE, 0.0);
            }
            self.doubts.push(doubt);
        }
        if is_unproven {
            self.distribution = self
                .distribution
                .or_unknown(UNKNOWN_SHARE, self.by_touch.low);
            self.doubts.push(Doubt::UnprovenCamera);
        }
        self.performance = self.distribution.estimate();
        self.observation = Some(update.observation.clone());
    }
}
