//! Phases of a round: motions with the same purpose.

use super::samples::round_to;
use serde::Serialize;
use wisch::follow::{Followed, Phase};

#[derive(Serialize)]
pub(super) struct PhaseRecord {
    pub(super) name: &'static str,
    pub(super) start: f64,
    pub(super) end: f64,
    pub(super) contact: bool,
    pub(super) stroke: Option<usize>,
}

/// Merges consecutive motions of the same phase.
pub(super) fn phases(followed: &Followed) -> Vec<PhaseRecord> {
    let mut phases: Vec<PhaseRecord> = Vec::new();
    for motion in &followed.motions {
        let (phase, end): (Phase, f64) = (motion.phase, round_to(motion.end(), 1e3));
        match phases.last_mut() {
            Some(last) if last.name == phase.as_str() && last.stroke == phase.stroke() => {
                last.end = end;
            }
            _ => phases.push(PhaseRecord {
                name: phase.as_str(),
                start: round_to(motion.start, 1e3),
                end,
                contact: phase.is_contact(),
                stroke: phase.stroke(),
            }),
        }
    }
    phases
}
