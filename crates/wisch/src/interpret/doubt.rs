//! Whether a log looks like wiping of this surface, and if not, why.

use super::config::InterpretConfig;
use super::contact::{ClassifiedPath, PathPiece};
use super::events::{Event, EventKind};
use crate::represent::Surface;
use std::fmt;

/// Least time of pressing that shows where the tool pressed [s].
const LEAST_PRESSING: f64 = 0.5;
/// Most that the heights may differ at which a tool presses on a surface, which may be inclined [m].
const MOST_SPREAD: f64 = 0.03;
/// Pieces further apart than this are none that follow each other [s].
const LONGEST_STEP: f64 = 0.1;
/// Less than this share of the confident contacts on one plane lie on none [1].
const LEAST_ON_PLANE: f64 = 0.5;
/// A tool that wipes is in contact for at least this share of its time on or near the surface [1].
const LEAST_CONTACT: f64 = 0.3;
/// Most of the contact that may lie beside the surface [1].
const MOST_BESIDE: f64 = 0.5;

/// Most of a log that somebody may lead the tool by hand [1].
const MOST_LED: f64 = 0.3;

/// Why a log does not look like wiping, or not like wiping of this surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Doubt {
    /// Somebody led the tool by hand: what it felt was the hand's as much as the surface's.
    LedByHand {
        /// Share of the log [1].
        share: f64,
    },
    /// The tool pressed as it should, but far from where the surface is believed to be.
    PressedFarOff {
        /// Median height of the tool over the believed surface as it pressed [m].
        height: f64,
        /// How far from the believed surface contact is looked for [m].
        searched: f64,
    },
    /// The tool was mostly in contact beside the surface.
    PressedBeside {
        /// Share of the contact's time beside the outline [1].
        share: f64,
    },
    /// The contacts lie on no plane.
    Scattered {
        /// Confident contacts on the plane that most lie on.
        inliers: usize,
        /// Confident contacts in all.
        confident: usize,
    },
    /// The tool was near the surface, but hardly in contact with it.
    HardlyTouching {
        /// Time in contact over the time on or near the surface [1].
        share: f64,
    },
    /// In contact, the tool hardly moved along the surface.
    HardlySliding {
        /// Travel in contact [m].
        travel: f64,
        /// Radius of the tool [m].
        radius: f64,
    },
}

impl fmt::Display for Doubt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::LedByHand { share } => write!(
                f,
                "somebody leads the tool by hand for {:.0} % of the log",
                100.0 * share
            ),
            Self::PressedFarOff { height, searched } => {
                let side = if height < 0.0 { "below" } else { "above" };
                let height = height.abs();
                write!(
                    f,
                    "the tool pressed {height:.3} m {side} the believed surface, and contact is looked for within {searched:.3} m of it"
                )
            }
            Self::PressedBeside { share } => write!(
                f,
                "{:.0} % of the contact is beside the surface",
                100.0 * share
            ),
            Self::Scattered { inliers, confident } => write!(
                f,
                "only {inliers} of {confident} confident contacts lie on one plane"
            ),
            Self::HardlyTouching { share } => write!(
                f,
                "the tool is in contact for only {:.0} % of its time on or near the surface",
                100.0 * share
            ),
            Self::HardlySliding { travel, radius } => write!(
                f,
                "in contact the tool slid {travel:.3} m in all, less than its own radius of {radius:.3} m"
            ),
        }
    }
}

/// What speaks against wiping of this surface; nothing where nothing pressed at all.
pub(super) fn doubts(
    classified: &ClassifiedPath,
    events: &[Event],
    contact_share: f64,
    surface: &Surface,
    config: &InterpretConfig,
) -> Vec<Doubt> {
    let led = led(&classified.path, events);
    let Some((_, plane)) = &classified.plane else {
        // What presses at one height for long is a surface, not a hand.
        let far_off = far_off(&classified.path, config);
        return far_off.or(led).into_iter().collect();
    };
    let touching = |piece: &PathPiece| {
        piece.is_on_plane() && piece.normalized_force >= config.events.contact_share[1]
    };
    let (mut time, mut beside, mut travel) = (0.0, 0.0, 0.0);
    for pair in classified.path.windows(2) {
        let [before, piece] = [&pair[0], &pair[1]];
        if !touching(piece) {
            continue;
        }
        let lasts = (piece.time[1] - before.time[1]).min(LONGEST_STEP);
        time += lasts;
        if !surface.outline.contains(piece.position.xy()) {
            beside += lasts;
        }
        if touching(before) {
            travel += (piece.position - before.position).xy().norm();
        }
    }
    let share = if time > 0.0 { beside / time } else { 0.0 };
    let (inliers, confident) = (plane.inliers, plane.confident);
    let radius = config.redraw_length_m;
    let all = [
        (
            (inliers as f64) < LEAST_ON_PLANE * confident as f64,
            Doubt::Scattered { inliers, confident },
        ),
        (
            contact_share < LEAST_CONTACT,
            Doubt::HardlyTouching {
                share: contact_share,
            },
        ),
        (travel < radius, Doubt::HardlySliding { travel, radius }),
        (share > MOST_BESIDE, Doubt::PressedBeside { share }),
    ];
    let told = all.into_iter().filter(|(is_so, _)| *is_so);
    let told = told.map(|(_, doubt)| doubt);
    led.into_iter().chain(told).collect()
}

fn led(path: &[PathPiece], events: &[Event]) -> Option<Doubt> {
    let led = (events.iter()).filter(|event| event.kind == EventKind::HandGuiding);
    let led: f64 = led.map(|event| event.end - event.start).sum();
    let all = path.last()?.time[1] - path.first()?.time[0];
    let share = led / all;
    (share > MOST_LED).then_some(Doubt::LedByHand { share })
}

/// Where the tool pressed, if that is too far off to be taken for the surface. Without a plane, heights are those over
/// the believed surface.
fn far_off(path: &[PathPiece], config: &InterpretConfig) -> Option<Doubt> {
    let is_pressed = |piece: &&PathPiece| piece.normalized_force >= config.confident_share;
    let mut heights: Vec<(f64, f64)> = (path.iter().filter(is_pressed))
        .map(|piece| (piece.height, piece.time[1] - piece.time[0]))
        .collect();
    let pressed: f64 = heights.iter().map(|(_, lasts)| lasts).sum();
    if pressed < LEAST_PRESSING {
        return None;
    }
    heights.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
    let at = |tenth: usize| heights[(heights.len() - 1) * tenth / 10].0;
    if at(9) - at(1) > MOST_SPREAD {
        return None;
    }
    let height = at(5);
    let searched = config.search_height_m;
    (height.abs() > searched).then_some(Doubt::PressedFarOff { height, searched })
}
