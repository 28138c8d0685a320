//! Whether a log looks like wiping of this surface, and if not, why.

use super::config::InterpretConfig;
use super::contact::{
    ClassifiedPath, Curvature, ForceReading, MeasuredPiece, PathPiece, PressDirection,
};
use super::events::{Event, EventKind};
use crate::geometry::Point3;
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
/// Height over the believed surface within which a tool may have touched where nothing is felt [m].
const NEAR: f64 = 0.02;
/// Height over the lowest plane of the tool's own within which it may have touched [m].
const LOW: f64 = 5e-3;
/// Force over the declared one from which on the tool pressed with another [1]; either way.
const OTHER_FORCE: f64 = 1.2;
/// Difference of the performance beyond which the scale of the force decides [1].
const MOST_BY_SCALE: f64 = 0.1;
/// f′ from which on a tool at the end of a log presses [1].
const PRESSING: f64 = 0.5;
/// Longest time between two samples that leaves nothing out [s].
const LONGEST_GAP: f64 = 1.0;

/// Why a log does not look like wiping, or not like wiping of this surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Doubt {
    /// The tool came near the surface, but its force shows no contact.
    NothingFelt {
        /// Smallest distance of the tool from the believed surface [m].
        closest: f64,
        /// Size of the force that is not exceeded for nine tenths of the time near the surface [N].
        force: f64,
    },
    /// The tool never came near the surface.
    StayedAway {
        /// Smallest distance of the tool from the believed surface [m].
        closest: f64,
    },
    /// The log shows no calm free motion, so what the sensor adds to the force is not known.
    NoFreeMotion,
    /// The contacts lie on a cylinder rather than on a plane.
    Curved {
        /// Radius [m].
        radius: f64,
        /// Angle of its axis from the surface's x, from 0 to π [rad].
        axis: f64,
        /// Whether it bulges towards the tool.
        is_convex: bool,
    },
    /// The tool pressed with another force than the task declares.
    PressedOtherwise {
        /// The force with which it mostly pressed [N].
        force: f64,
        /// The declared one [N].
        declared: f64,
        /// Difference that it makes to the performance whether the tool really pressed so, or the force has another scale [1].
        matters: f64,
    },
    /// The force of contact points into the surface: the log has the force of the tool on the surface.
    SignTurned,
    /// The force of contact lies along another direction than the surface's normal: its frame is another.
    FrameTurned {
        /// The direction, a unit vector.
        direction: [f64; 3],
        /// Whether it is constant in the axes of the tool rather than in those of the surface.
        in_tool: bool,
    },
    /// The clocks of force and position differ.
    ClocksApart {
        /// By how long the force is late; negative where it is early [s].
        offset: f64,
    },
    /// The log begins or ends while the tool presses, or has a gap: what was wiped then is not counted.
    Incomplete {
        /// It begins while the tool presses.
        begins: bool,
        /// It ends while the tool presses.
        ends: bool,
        /// Time without a sample [s].
        missing: f64,
    },
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

impl Doubt {
    /// Whether with it the log does not say what was wiped. The others say how it was read.
    pub fn is_decisive(&self) -> bool {
        match self {
            Self::PressedOtherwise { matters, .. } => *matters > MOST_BY_SCALE,
            Self::NothingFelt { .. }
            | Self::StayedAway { .. }
            | Self::NoFreeMotion
            | Self::Curved { .. }
            | Self::LedByHand { .. }
            | Self::PressedFarOff { .. }
            | Self::PressedBeside { .. }
            | Self::Scattered { .. } => true,
            Self::SignTurned
            | Self::FrameTurned { .. }
            | Self::ClocksApart { .. }
            | Self::Incomplete { .. }
            | Self::HardlyTouching { .. }
            | Self::HardlySliding { .. } => false,
        }
    }

    /// Whether the log begins or ends while the tool presses, so that more may have been wiped than it shows.
    pub fn is_cut(&self) -> bool {
        matches!(self, Self::Incomplete { begins, ends, .. } if *begins || *ends)
    }
}

impl fmt::Display for Doubt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NothingFelt { closest, force } => write!(
                f,
                "the tool came within {:.1} mm of the believed surface, but its force shows no contact (it stays below {force:.1} N there): the surface may lie lower than believed, the wrench may be of another link or frame, or the tool did not press",
                1e3 * closest
            ),
            Self::StayedAway { closest } => write!(
                f,
                "the tool never came within {:.0} mm of the believed surface (closest: {closest:.3} m): the pose of the surface, the frame of the log or its unit of length may be another",
                1e3 * NEAR
            ),
            Self::NoFreeMotion => f.write_str(
                "the log shows no calm free motion, so the bias of the force is not known",
            ),
            Self::Curved {
                radius,
                axis,
                is_convex,
            } => write_curved(f, radius, axis, is_convex),
            Self::PressedOtherwise {
                force,
                declared,
                matters,
            } => write_pressed_otherwise(f, force, declared, matters),
            Self::SignTurned => f.write_str(
                "the force of contact points into the surface: read with the opposite sign (--wrench-sign)",
            ),
            Self::FrameTurned { direction, in_tool } => write_frame_turned(f, direction, in_tool),
            Self::ClocksApart { offset } => write_clock_offset(f, offset),
            Self::Incomplete {
                begins,
                ends,
                missing,
            } => write_incomplete(f, begins, ends, missing),
            Self::LedByHand { share } => write!(
                f,
                "somebody leads the tool by hand for {:.0} % of the log",
                100.0 * share
            ),
            Self::PressedFarOff { height, searched } => write_far_off(f, height, searched),
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

/// Writes [`Doubt::Curved`].
fn write_curved(
    f: &mut fmt::Formatter<'_>,
    radius: f64,
    axis: f64,
    is_convex: bool,
) -> fmt::Result {
    let shape = if is_convex { "convex" } else { "concave" };
    write!(
        f,
        "the contacts lie on a {shape} cylinder of radius {radius:.2} m, whose axis is at {:.0}° to the surface's x axis, not on a plane",
        axis.to_degrees()
    )
}

/// Writes [`Doubt::PressedOtherwise`].
fn write_pressed_otherwise(
    f: &mut fmt::Formatter<'_>,
    force: f64,
    declared: f64,
    matters: f64,
) -> fmt::Result {
    let consequence = if matters > MOST_BY_SCALE {
        ", and what that wiped depends on whether the declared force or the scale of the measured one is right"
    } else {
        ""
    };
    write!(
        f,
        "the tool pressed with {force:.1} N, {:.2} × press_force_n ({declared:.1} N){consequence}: set interaction.press_force_n if {force:.1} N is the nominal force",
        force / declared
    )
}

/// Writes [`Doubt::FrameTurned`].
fn write_frame_turned(
    f: &mut fmt::Formatter<'_>,
    [x, y, z]: [f64; 3],
    in_tool: bool,
) -> fmt::Result {
    let frame = if in_tool { "tool" } else { "surface" };
    write!(
        f,
        "the force of contact lies along ({x:.2}, {y:.2}, {z:.2}) in the axes of the {frame}, not along the normal: taken for the normal force (--wrench-frame)"
    )
}

/// Writes [`Doubt::ClocksApart`].
fn write_clock_offset(f: &mut fmt::Formatter<'_>, offset: f64) -> fmt::Result {
    let late = if offset < 0.0 { "early" } else { "late" };
    write!(
        f,
        "the force is {:.2} s {late} against the position: aligned",
        offset.abs()
    )
}

/// Writes [`Doubt::Incomplete`].
fn write_incomplete(
    f: &mut fmt::Formatter<'_>,
    begins: bool,
    ends: bool,
    missing: f64,
) -> fmt::Result {
    let parts = [
        begins.then(|| "begins while the tool presses".to_owned()),
        ends.then(|| "ends while the tool presses".to_owned()),
        (missing > 0.0).then(|| format!("has no samples for {missing:.1} s")),
    ];
    let parts: Vec<String> = parts.into_iter().flatten().collect();
    write!(
        f,
        "the log {}: what was wiped then is not counted",
        parts.join(" and ")
    )
}

/// Writes [`Doubt::PressedFarOff`].
fn write_far_off(f: &mut fmt::Formatter<'_>, height: f64, searched: f64) -> fmt::Result {
    let side = if height < 0.0 { "below" } else { "above" };
    let height = height.abs();
    write!(
        f,
        "the tool pressed {height:.3} m {side} the believed surface, and contact is looked for within {searched:.3} m of it"
    )
}

/// What a log shows, with which its doubts are found.
pub(super) struct LogEvidence<'a> {
    /// The pieces with their forces as read.
    pub(super) pieces: &'a [MeasuredPiece],
    pub(super) reading: &'a ForceReading,
    pub(super) classified: &'a ClassifiedPath,
    pub(super) events: &'a [Event],
    pub(super) contact_share: f64,
    pub(super) surface: &'a Surface,
    /// The settings as declared, and those with the log's own nominal force.
    pub(super) declared: &'a InterpretConfig,
    pub(super) config: &'a InterpretConfig,
}

impl LogEvidence<'_> {
    /// What speaks against wiping of this surface, and what had to be assumed to read the log, the most likely cause first.
    pub(super) fn doubts(&self) -> Vec<Doubt> {
        let path = &self.classified.path;
        let led = led(path, self.events);
        let mut doubts: Vec<Doubt> = Vec::new();
        if self.declared.gap_m > 0.0 {
            doubts.extend(led);
            return doubts;
        }
        let Some((_, plane)) = &self.classified.plane else {
            // What presses at one height for long is a surface, not a hand.
            let far_off = far_off(path, self.config);
            let felt = far_off.or(led).or_else(|| self.scattered());
            doubts.extend(felt.or_else(|| self.nothing_felt()));
            return doubts;
        };
        doubts.extend(led);
        doubts.extend(self.curved());
        if !self.reading.has_free_motion {
            doubts.push(Doubt::NoFreeMotion);
        }
        doubts.extend(self.assumptions());
        doubts.extend(self.incomplete());
        let Sliding {
            time,
            beside,
            travel,
        } = self.sliding();
        let share = if time > 0.0 { beside / time } else { 0.0 };
        let (inliers, confident) = (plane.inliers, plane.confident);
        let radius = self.config.redraw_length_m;
        let contact_share = self.contact_share;
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
        doubts.extend(
            all.into_iter()
                .filter(|(is_so, _)| *is_so)
                .map(|(_, doubt)| doubt),
        );
        doubts
    }

    /// Pieces at which the tool was so low that it may have touched, if its force is misread.
    pub(super) fn is_low(&self) -> Vec<bool> {
        let lowest = (self.reading.lowest.as_ref()).filter(|plane| plane.height.abs() <= NEAR);
        let is_low = |piece: &MeasuredPiece| match lowest {
            Some(plane) => {
                let place = Point3::new(piece.position.x, piece.position.y, piece.mean_height);
                plane.distance(place) <= LOW
            }
            None => piece.mean_height.abs() <= NEAR,
        };
        self.pieces.iter().map(is_low).collect()
    }

    /// Where the tool pressed as it should near the surface, but its contacts lie on no plane at all.
    fn scattered(&self) -> Option<Doubt> {
        let is_pressed = |piece: &&PathPiece| {
            piece.normalized_force >= self.config.confident_share
                && piece.height.abs() <= self.config.search_height_m
        };
        let confident = self.classified.path.iter().filter(is_pressed).count();
        let inliers = 0;
        (confident >= self.config.plane.min_points)
            .then_some(Doubt::Scattered { inliers, confident })
    }

    fn nothing_felt(&self) -> Option<Doubt> {
        let closest = (self.pieces.iter())
            .map(|piece| piece.mean_height.abs())
            .min_by(f64::total_cmp)?;
        if closest > NEAR {
            return Some(Doubt::StayedAway { closest });
        }
        let is_low = self.is_low();
        let mut forces: Vec<f64> = (self.pieces.iter().zip(is_low))
            .filter(|(_, is_low)| *is_low)
            .map(|(piece, _)| piece.force.norm())
            .collect();
        forces.sort_unstable_by(f64::total_cmp);
        let force = forces.get(forces.len() * 9 / 10).copied().unwrap_or(0.0);
        Some(Doubt::NothingFelt { closest, force })
    }

    fn curved(&self) -> Option<Doubt> {
        let Curvature {
            radius,
            axis,
            is_convex,
        } = Curvature::of(self.pieces, self.surface, self.config)?;
        Some(Doubt::Curved {
            radius,
            axis,
            is_convex,
        })
    }

    /// How the forces were read where they are not as declared.
    fn assumptions(&self) -> impl Iterator<Item = Doubt> {
        let reading = self.reading;
        let turned = match reading.direction {
            PressDirection::Outward => None,
            PressDirection::Inward => Some(Doubt::SignTurned),
            PressDirection::Turned { direction, in_tool } => Some(Doubt::FrameTurned {
                direction: direction.into(),
                in_tool,
            }),
        };
        let declared = self.declared.nominal_force();
        let reference = reading.reference_force(declared);
        let ratio = reference / declared;
        let is_other = !(1.0 / OTHER_FORCE..=OTHER_FORCE).contains(&ratio);
        let otherwise = is_other
            .then_some(reference)
            .map(|force| Doubt::PressedOtherwise {
                force,
                declared,
                matters: 0.0,
            });
        let offset = reading.clock_offset;
        let clocks = (offset != 0.0).then_some(Doubt::ClocksApart { offset });
        turned.into_iter().chain(otherwise).chain(clocks)
    }

    fn is_touching(&self, piece: &PathPiece) -> bool {
        piece.is_on_plane() && piece.normalized_force >= self.config.events.contact_share[1]
    }

    fn incomplete(&self) -> Option<Doubt> {
        let path = &self.classified.path;
        let is_pressing = |piece: Option<&PathPiece>| {
            piece.is_some_and(|piece| piece.is_on_plane() && piece.normalized_force >= PRESSING)
        };
        let begins = is_pressing(path.first());
        let ends = is_pressing(path.last());
        let missing: f64 = (path.windows(2))
            .filter(|pair| self.is_touching(&pair[0]) || self.is_touching(&pair[1]))
            .map(|pair| pair[1].time[0] - pair[0].time[1])
            .filter(|gap| *gap > LONGEST_GAP)
            .sum();
        (begins || ends || missing > 0.0).then_some(Doubt::Incomplete {
            begins,
            ends,
            missing,
        })
    }

    fn sliding(&self) -> Sliding {
        let mut sliding = Sliding::default();
        for pair in self.classified.path.windows(2) {
            let [before, piece] = [&pair[0], &pair[1]];
            if !self.is_touching(piece) {
                continue;
            }
            let lasts = (piece.time[1] - before.time[1]).min(LONGEST_STEP);
            sliding.time += lasts;
            if !self.surface.outline.contains(piece.position.xy()) {
                sliding.beside += lasts;
            }
            if self.is_touching(before) {
                sliding.travel += (piece.position - before.position).xy().norm();
            }
        }
        sliding
    }
}

/// Contact in all.
#[derive(Debug, Clone, Copy, Default)]
struct Sliding {
    /// Time in contact, and that of it beside the surface [s].
    time: f64,
    beside: f64,
    /// Travel in contact [m].
    travel: f64,
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
