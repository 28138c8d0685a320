//! What the 3-D view shows one at a time: a plan, or a round as it was executed.

use super::input::{MotionInput, Origin};
use super::sampled::{MAX_FRAMES, SampledMotion};
use crate::draw::metres;
use maud::{Markup, html};

/// Most frames of all tracks together.
const MAX_FRAMES_OF_ALL: usize = 8_000;
/// A surface that has moved and turned less than this since is where it was [m], [rad].
const STILL: [f64; 2] = [1e-5, 1e-4];
/// Least width of a mark in the strip below the slider, which is 1000 wide.
const LEAST_MARK: f64 = 4.0;

/// A motion that can be chosen.
#[derive(Debug, Clone)]
pub(crate) struct Track<'a> {
    /// The round, counted from 1; `None` for a plan that was not executed.
    pub(crate) round: Option<usize>,
    pub(crate) motion: &'a MotionInput<'a>,
    /// What happened meanwhile.
    pub(crate) marks: Vec<Mark>,
}

/// A time at which something happened.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Mark {
    pub(crate) kind: MarkKind,
    /// For the reader.
    pub(crate) name: &'static str,
    /// From, to [s].
    pub(crate) times: [f64; 2],
}

/// Who says so.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum MarkKind {
    /// The robot felt it.
    Felt,
    /// It was really so.
    True,
}

impl MarkKind {
    /// Class of its area.
    pub(crate) const fn class(self) -> &'static str {
        match self {
            Self::Felt => "event-collision",
            Self::True => "event-push",
        }
    }

    /// Top and height in the strip: what was felt lies on what is true and leaves it seen.
    const fn lane(self) -> (u32, u32) {
        match self {
            Self::Felt => (10, 3),
            Self::True => (8, 7),
        }
    }
}

/// A track with its frames, of which there is one at least.
pub(crate) struct SampledTrack<'a> {
    pub(crate) track: Track<'a>,
    pub(crate) frames: SampledMotion,
}

/// The rounds that have samples; without one, the plan.
pub(crate) fn sampled<'a>(
    plan: &'a MotionInput<'a>,
    rounds: Vec<Track<'a>>,
) -> Vec<SampledTrack<'a>> {
    let most = MAX_FRAMES.min(MAX_FRAMES_OF_ALL / rounds.len().max(1));
    let with_frames = |track: Track<'a>| {
        let frames = SampledMotion::within(track.motion, most);
        (!frames.is_empty()).then_some(SampledTrack { track, frames })
    };
    let rounds: Vec<SampledTrack> = rounds.into_iter().filter_map(with_frames).collect();
    if !rounds.is_empty() {
        return rounds;
    }
    let plan = Track {
        round: None,
        motion: plan,
        marks: Vec::new(),
    };
    with_frames(plan).into_iter().collect()
}

impl SampledTrack<'_> {
    /// How far the surface is believed from where another track has it: moved [m] and turned [rad]; `None` if it
    /// is there.
    pub(crate) fn surface_moved(&self, first: &Self) -> Option<[f64; 2]> {
        let [first, now] = [first, self].map(|at| at.track.motion.task.surface.world_from_surface);
        let moved = (now.translation.vector - first.translation.vector).norm();
        let turned = first.rotation.angle_to(&now.rotation);
        (moved > STILL[0] || turned > STILL[1]).then_some([moved, turned])
    }

    /// What is shown of a round, in words.
    pub(crate) fn caption(&self, first: &Self) -> Option<String> {
        let number = self.track.round?;
        let joints = match self.track.motion.origin {
            Origin::Measured => "the joints as measured",
            Origin::Planned => "the joints as planned, for none were measured",
        };
        let surface = self.surface_moved(first).map_or_else(String::new, |[moved, turned]| {
            format!(
                " The surface is where it was believed then: {} mm and {}° from where it was believed at first.",
                metres(1e3 * moved, 1),
                metres(turned.to_degrees(), 2)
            )
        });
        Some(format!("Round {number}, {joints}.{surface}"))
    }

    /// Below the slider: when the tool wipes, when it is lifted, and what happened.
    pub(crate) fn strip(&self) -> Markup {
        let place = |[start, end]: [f64; 2]| {
            let [from, to] = [start, end].map(|time| 1000.0 * self.frames.share(time));
            (from, (to - from).max(0.0))
        };
        let marks = &self.track.marks;
        let height = if marks.is_empty() { 6 } else { 16 };
        html! {
            svg viewBox=(format!("0 0 1000 {height}")) height=(height + 1) preserveAspectRatio="none" aria-hidden="true" {
                rect class="lane" width="1000" height=(height) {}
                @for phase in self.track.motion.phases {
                    @let (left, width) = place([phase.start, phase.end]);
                    rect class=(phase.contact.class()) x=(format!("{left:.1}")) width=(format!("{width:.1}")) height="6" {
                        title { (phase.name) }
                    }
                }
                @for mark in marks {
                    @let (left, width) = place(mark.times);
                    @let (top, height) = mark.kind.lane();
                    rect class=(mark.kind.class()) x=(format!("{:.1}", left.min(1000.0 - LEAST_MARK))) y=(top)
                        width=(format!("{:.1}", width.max(LEAST_MARK))) height=(height) {
                        title { (mark.name) }
                    }
                }
            }
        }
    }
}
