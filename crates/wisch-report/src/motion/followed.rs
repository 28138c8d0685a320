//! A followed plan for figures: samples, phases, and particles over time.

use super::{BasePose, CandidateBase, MotionInput, ParticleFrame, ShownContact, ShownPhase};
use crate::prediction::frames::EffectFrames;
use wisch::follow::{self, Followed, TrajectorySample, Workcell};
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
    particles: Vec<ParticleFrame>,
}

impl<'a> ShownMotion<'a> {
    /// Samples a motion. Particles are those of `frames`, at the times at which the tool has covered their distance.
    pub fn sample(cell: &'a Workcell, followed: &'a Followed, frames: &EffectFrames) -> Self {
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
            particles: particles(followed, frames),
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
            particles: &self.particles,
        }
    }
}

/// Assigns times to the particles of a prediction's frames, on the assumption of a constant speed within each stroke.
fn particles(followed: &Followed, frames: &EffectFrames) -> Vec<ParticleFrame> {
    let mut before = vec![0.0];
    for stroke in &followed.strokes {
        before.push(before.last().unwrap_or(&0.0) + stroke.length());
    }
    let time = |stroke: usize, distance: f64| {
        let motions = &followed.motions;
        let motion = motions
            .iter()
            .find(|m| m.phase == follow::Phase::Wipe(stroke))?;
        let length = before.get(stroke + 1)? - before[stroke];
        let share = ((distance - before[stroke]) / length.max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
        Some(motion.start + share * motion.trajectory.duration())
    };
    let mut shown: Vec<ParticleFrame> = Vec::new();
    for frame in frames.frames() {
        let since = shown.last().map_or(0.0, |last| last.time);
        let at = frame.stroke.and_then(|stroke| time(stroke, frame.distance));
        shown.push(ParticleFrame {
            time: at.unwrap_or(since).max(since),
            positions: (frame.particles.iter())
                .filter(|(_, fate)| fate.is_on_surface())
                .map(|(position, _)| *position)
                .collect(),
        });
    }
    shown
}
