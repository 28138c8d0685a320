//! A followed plan for figures: samples and phases.

use super::{BasePose, CandidateBase, MotionInput, ShownContact, ShownPhase};
use wisch::follow::{Followed, TrajectorySample, Workcell};
use wisch::represent::Task;

/// Sampling period of a motion in figures [s].
const SHOWN_PERIOD: f64 = 0.05;

/// A followed plan, sampled for figures.
#[derive(Debug, Clone)]
pub struct ShownMotion<'a> {
    cell: &'a Workcell,
    samples: Vec<TrajectorySample>,
    phases: Vec<ShownPhase>,
    placements: Vec<BasePose>,
    ratings: Vec<CandidateBase>,
}

impl<'a> ShownMotion<'a> {
    /// Samples a motion.
    pub fn sample(cell: &'a Workcell, followed: &'a Followed) -> Self {
        let count = (followed.duration() / SHOWN_PERIOD).ceil() as usize;
        let samples = (0..=count)
            .filter_map(|i| followed.sample((i as f64 * SHOWN_PERIOD).min(followed.duration())))
            .collect();
        let phases = (followed.motions.iter())
            .map(|motion| ShownPhase {
                name: motion.phase.as_str().to_owned(),
                start: motion.start,
                end: motion.end(),
                contact: if motion.phase.is_contact() {
                    ShownContact::Wiping
                } else {
                    ShownContact::Lifted
                },
                stroke: motion.phase.stroke(),
            })
            .collect();
        let placements = (followed.placements.iter())
            .map(|placement| BasePose {
                x: placement.world_from_base.position.x,
                y: placement.world_from_base.position.y,
                yaw: placement.world_from_base.heading,
            })
            .collect();
        let ratings = (followed.rated.iter())
            .map(|place| CandidateBase {
                x: place.world_from_base.position.x,
                y: place.world_from_base.position.y,
                rating: place.rating.unwrap_or(0.0),
                blocked: place.rating.is_none(),
            })
            .collect();
        Self {
            cell,
            samples,
            phases,
            placements,
            ratings,
        }
    }

    /// Returns the input of figures, with the robot and its scene.
    pub fn input(&'a self, task: &'a Task) -> MotionInput<'a> {
        MotionInput {
            robot: self.cell.robot(),
            world_from_root: *self.cell.world_from_root(),
            task,
            tool_link: self.cell.tip(),
            link_from_tool: *self.cell.tip_from_tool(),
            samples: &self.samples,
            phases: &self.phases,
            placements: &self.placements,
            ratings: &self.ratings,
        }
    }
}
