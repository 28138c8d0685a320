//! What a log tells.

use super::belief::{Belief, Estimate, Look, PerformanceDistribution};
use super::contact::{FittedPlane, PathPiece, ToolStiffness};
use super::doubt::Doubt;
use super::events::Event;
use crate::geometry::Pose;
use crate::represent::Observation;

/// What is to be made of the fitted plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Diagnosis {
    /// The surface is where it was believed.
    Localized,
    /// The surface is elsewhere: recovery plans on this pose of it.
    Relocalize {
        /// Where the surface is.
        world_from_surface: Pose,
    },
    /// Too few confident contacts for a plane: nothing can be said.
    NoContact,
    /// The tool hovers: nothing can be felt, and the belief goes by where the tool was.
    Hovering,
}

/// What a log of poses and forces says of the contact, the real plane of the surface, and the dirt; paper §4.2.
#[derive(Debug, Clone)]
pub struct Interpretation {
    /// The path in pieces.
    pub path: Vec<PathPiece>,
    /// The plane, if there were contacts enough.
    pub plane: Option<FittedPlane>,
    /// Whether the surface is where it was believed.
    pub diagnosis: Diagnosis,
    /// Why the log does not look like wiping of this surface; nothing where it does.
    pub doubts: Vec<Doubt>,
    /// What happened, by start.
    pub events: Vec<Event>,
    /// What the sensor adds to the force on the tool along the surface's outward normal, as found in free motion and
    /// taken off [N]; 0 where the log shows no free motion.
    pub force_bias: f64,
    /// Force with which the tool mostly pressed while it slid over one plane [N], by the log itself; nothing where no such
    /// plane was found.
    pub pressed_force: Option<f64>,
    /// What is believed of the tool's stiffness after this log and those before it; nothing of a tool that does not give way.
    pub tool_stiffness: Option<ToolStiffness>,
    /// Time in contact over the time that the tool was on or near the surface.
    pub contact_share: f64,
    /// Where the dirt now is believed to lie.
    pub belief: Belief,
    /// What is believed of the performance.
    pub distribution: PerformanceDistribution,
    /// The same in short.
    pub performance: Estimate,
    /// What touch alone said of it, before anything was seen.
    pub felt: Estimate,
    /// What was seen afterwards, if anything looked.
    pub observation: Option<Observation>,
}

impl Interpretation {
    /// Whether the log, or what was seen afterwards, says what was wiped. If not, the belief holds what is possible, and
    /// the doubts say why, the most likely cause first.
    pub fn can_be_told(&self) -> bool {
        let is_felt =
            self.diagnosis != Diagnosis::NoContact && !self.doubts.iter().any(Doubt::is_decisive);
        is_felt || self.observation.is_some()
    }

    /// Takes in a look at the surface after the log.
    pub fn look(&mut self, look: &Look<'_>) {
        self.belief = self.belief.seen(look);
        // What the replays leave out is no part of what is seen.
        self.distribution = self.belief.performance(look.goal, look.surface, 0.0);
        self.performance = self.distribution.estimate();
        self.observation = Some(look.observation.clone());
    }
}
