//! Whether a log shows wiping of this surface, and if not, why.

use super::config::InterpretConfig;
use super::contact::{
    ClassifiedPath, ContactShape, ForceReading, MeasuredPiece, PathPiece, PressDirection, is_inland,
};
use super::events::{Event, EventKind};
use super::wrench_quality::UnusableWrenches;
use crate::geometry::Point3;
use crate::represent::Surface;
use std::fmt;

/// Least time of pressing that shows the height of a surface [s].
const LEAST_PRESSING: f64 = 0.5;
/// Largest spread of the heights at which a tool presses on one surface, which may be inclined [m].
const MOST_SPREAD: f64 = 0.03;
/// Pieces with more time between them do not follow each other [s].
const LONGEST_STEP: f64 = 0.1;
/// Least share of the confident contacts that a plane must hold [1].
const LEAST_ON_PLANE: f64 = 0.5;
/// Least share of the time on or near the surface that a wiping tool is in contact [1].
const LEAST_CONTACT: f64 = 0.3;
/// Largest share of the contact time that may lie beside the surface [1].
const MOST_BESIDE: f64 = 0.5;

/// Travel over which steady sliding is recognised [m], least force over the nominal one at each of its pieces [1], and range
/// of the mean force over the nominal one [1].
const STEADY_TRAVEL: f64 = 0.02;
const LEAST_PRESSED: f64 = 0.5;
const STEADY: std::ops::RangeInclusive<f64> = 0.85..=1.15;
/// Steepest rise of a surface against the plane [1].
const STEEPEST: f64 = 0.25;
/// Least share of its pieces that are off the plane where a tool slides off it [1].
const MOSTLY: f64 = 0.5;
/// Least share of all steady sliding [1], and least travel [m], off the plane that shows a surface that is no plane.
const LEAST_STEADY_OFF: f64 = 0.1;
const LEAST_STEADY_TRAVEL: f64 = 0.04;
/// Largest share of a log that hand guiding may take [1].
const MOST_LED: f64 = 0.3;
/// Height over the believed surface within which a tool without measured force may have touched [m].
const NEAR: f64 = 0.02;
/// Height over the lowest plane that the tool itself slid on, within which it may have touched [m].
const LOW: f64 = 5e-3;
/// Ratio of the measured press force to the declared one, in either direction, from which they count as different [1].
const OTHER_FORCE: f64 = 1.2;
/// Difference of the performance from which the scale of the force is decisive [1].
const MOST_BY_SCALE: f64 = 0.1;
/// Largest share of samples without a usable wrench with which the rest still shows what was wiped [1].
const MOST_UNUSABLE: f64 = 0.5;
/// Least f′ of a tool that presses at the beginning or the end of a log [1].
const PRESSING: f64 = 0.5;
/// Longest time between two samples within which nothing is missed [s].
const LONGEST_GAP: f64 = 1.0;

/// A reason why a log may not show wiping, or not wiping of this surface, and what had to be assumed to read it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Doubt {
    /// The tool came near the surface, but its force shows no contact.
    NoContactForce {
        /// Smallest distance of the tool from the believed surface \[m\].
        closest: f64,
        /// Size of the force that 90 % of the time near the surface stays below \[N\].
        force: f64,
    },
    /// The tool never came near the surface.
    NeverNearSurface {
        /// Smallest distance of the tool from the believed surface \[m\].
        closest: f64,
    },
    /// The log shows no calm free motion, so the bias of the force is unknown.
    NoFreeMotion,
    /// The contacts lie on a cylinder rather than on a plane.
    Curved {
        /// Radius \[m\].
        radius: f64,
        /// Angle of its axis from the surface's x, from 0 to π \[rad\].
        axis: f64,
        /// Whether it bulges towards the tool.
        is_convex: bool,
    },
    /// The contacts lie on an arc along one direction rather than on a plane; they do not show the rest of the surface.
    CurvedAlong {
        /// Radius \[m\].
        radius: f64,
        /// Angle of the direction from the surface's x, from 0 to π \[rad\].
        direction: f64,
        /// Whether it bulges towards the tool.
        is_convex: bool,
    },
    /// The contacts lie on a surface that is curved in two directions rather than on a plane.
    DoublyCurved {
        /// Principal radii, the smaller first; positive where the surface bulges towards the tool \[m\].
        radii: [f64; 2],
        /// Angle of the direction with the first radius from the surface's x, from 0 to π \[rad\].
        direction: f64,
    },
    /// The contacts lie on no plane, and no shape explains them.
    NotPlanar {
        /// Distance from the best plane that a tenth of the contacts exceeds \[m\].
        off: f64,
    },
    /// The contacts do not lie on the curved surface that was believed.
    OffShape {
        /// Distance from the believed shape, at its best pose, that a tenth of the contacts exceeds \[m\].
        off: f64,
    },
    /// The tool pressed with a force other than the declared one.
    PressForceDiffers {
        /// Force with which the tool pressed for most of the time \[N\].
        force: f64,
        /// Declared force \[N\].
        declared: f64,
        /// Difference of the performance between the two explanations \[1\]: the tool really pressed with this force, or
        /// the force is measured on another scale.
        matters: f64,
    },
    /// The force of contact points into the surface: the log holds the force of the tool on the surface.
    WrenchSignInverted,
    /// The force of contact does not lie along the surface's normal: it is given in another frame.
    WrenchFrameRotated {
        /// Its direction, a unit vector.
        direction: [f64; 3],
        /// Whether it is constant in the axes of the tool rather than in those of the surface.
        in_tool: bool,
    },
    /// The clocks of force and position differ by a constant.
    ClockOffset {
        /// Delay of the force; negative where it is early \[s\].
        offset: f64,
    },
    /// The log begins or ends while the tool presses, or has a gap: wiping at that time is not counted.
    Incomplete {
        /// Whether it begins while the tool presses.
        begins: bool,
        /// Whether it ends while the tool presses.
        ends: bool,
        /// Time without samples in contact \[s\].
        missing: f64,
    },
    /// The wrenches of these samples were not usable, so that they do not show what the tool touched.
    UnusableWrench {
        /// Their numbers.
        unusable: UnusableWrenches,
        /// Their share of all samples \[1\].
        share: f64,
    },
    /// A person guided the tool by hand: the force is that of the hand as well as that of the surface.
    HandGuided {
        /// Share of the log \[1\].
        share: f64,
    },
    /// The tool pressed with its nominal force, but far from the believed surface.
    ContactFarFromSurface {
        /// Median height of the pressing tool over the believed surface \[m\].
        height: f64,
        /// Largest distance from the believed surface at which contact is searched \[m\].
        searched: f64,
    },
    /// The tool was in contact mostly beside the surface.
    ContactBesideSurface {
        /// Share of the contact time beside the outline \[1\].
        share: f64,
    },
    /// The contacts lie on no common plane.
    Scattered {
        /// Number of confident contacts on the plane that holds most of them.
        inliers: usize,
        /// Number of confident contacts.
        confident: usize,
    },
    /// The tool was near the surface, but hardly in contact with it.
    LittleContact {
        /// Time in contact over the time on or near the surface \[1\].
        share: f64,
    },
    /// In contact, the tool hardly moved along the surface.
    LittleSliding {
        /// Travel along the surface in contact \[m\].
        travel: f64,
        /// Radius of the tool \[m\].
        radius: f64,
    },
}

impl Doubt {
    /// Whether the log cannot show what was wiped. The remaining doubts state how it was read.
    pub fn is_decisive(&self) -> bool {
        match self {
            Self::PressForceDiffers { matters, .. } => *matters > MOST_BY_SCALE,
            Self::UnusableWrench { share, .. } => *share > MOST_UNUSABLE,
            Self::NoContactForce { .. }
            | Self::NeverNearSurface { .. }
            | Self::NoFreeMotion
            | Self::Curved { .. }
            | Self::CurvedAlong { .. }
            | Self::DoublyCurved { .. }
            | Self::NotPlanar { .. }
            | Self::OffShape { .. }
            | Self::HandGuided { .. }
            | Self::ContactFarFromSurface { .. }
            | Self::ContactBesideSurface { .. }
            | Self::Scattered { .. } => true,
            Self::WrenchSignInverted
            | Self::WrenchFrameRotated { .. }
            | Self::ClockOffset { .. }
            | Self::Incomplete { .. }
            | Self::LittleContact { .. }
            | Self::LittleSliding { .. } => false,
        }
    }

    /// Whether the log shows the shape or the height of another surface than the believed plane.
    pub(super) fn is_other_surface(&self) -> bool {
        matches!(
            self,
            Self::ContactFarFromSurface { .. }
                | Self::Curved { .. }
                | Self::CurvedAlong { .. }
                | Self::DoublyCurved { .. }
                | Self::OffShape { .. }
        )
    }

    /// Whether the log begins or ends while the tool presses, so that the tool may have wiped more than the log shows.
    pub fn is_cut(&self) -> bool {
        matches!(self, Self::Incomplete { begins, ends, .. } if *begins || *ends)
    }
}

impl fmt::Display for Doubt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NoContactForce { closest, force } => write!(
                f,
                "the tool came within {:.1} mm of the believed surface, but its force shows no contact (it stays below {force:.1} N there): check the height of the surface, and the link and frame of the wrench; or the tool did not press",
                1e3 * closest
            ),
            Self::NeverNearSurface { closest } => write!(
                f,
                "the tool never came within {:.0} mm of the believed surface (closest: {closest:.3} m): check the pose of the surface, the frame of the log and its unit of length",
                1e3 * NEAR
            ),
            Self::NoFreeMotion => f.write_str(
                "the log shows no calm free motion, so the bias of the force is unknown: record a second of motion above the surface",
            ),
            Self::Curved {
                radius,
                axis,
                is_convex,
            } => write_curved(f, radius, axis, is_convex),
            Self::CurvedAlong {
                radius,
                direction,
                is_convex,
            } => write!(
                f,
                "the contacts lie on a {} arc of radius {radius:.2} m along the direction at {:.0}° to the surface's x axis, not on a plane; strokes in another direction would show the shape",
                bulge(is_convex),
                direction.to_degrees()
            ),
            Self::DoublyCurved { radii, direction } => write_doubly_curved(f, radii, direction),
            Self::NotPlanar { off } => write!(
                f,
                "the contacts lie on no plane: a tenth of them is more than {:.1} mm off the best one, and no cylinder or other smooth shape explains them",
                1e3 * off
            ),
            Self::OffShape { off } => write!(
                f,
                "the contacts do not lie on the believed curved surface: a tenth of them is more than {:.1} mm off it, wherever it lies; check its radius and axis",
                1e3 * off
            ),
            Self::PressForceDiffers {
                force,
                declared,
                matters,
            } => write_pressed_otherwise(f, force, declared, matters),
            Self::WrenchSignInverted => f.write_str(
                "the force of contact points into the surface: read with the opposite sign (--wrench-sign)",
            ),
            Self::WrenchFrameRotated { direction, in_tool } => write_frame_turned(f, direction, in_tool),
            Self::ClockOffset { offset } => write_clock_offset(f, offset),
            Self::Incomplete {
                begins,
                ends,
                missing,
            } => write_incomplete(f, begins, ends, missing),
            Self::UnusableWrench { unusable, share } => write_unusable(f, unusable, share),
            Self::HandGuided { share } => write!(
                f,
                "a person guides the tool by hand for {:.0} % of the log",
                100.0 * share
            ),
            Self::ContactFarFromSurface { height, searched } => write_far_off(f, height, searched),
            Self::ContactBesideSurface { share } => write!(
                f,
                "{:.0} % of the contact time is beside the surface: check the pose and the outline of the surface",
                100.0 * share
            ),
            Self::Scattered { inliers, confident } => write!(
                f,
                "only {inliers} of {confident} confident contacts lie on one plane"
            ),
            Self::LittleContact { share } => write!(
                f,
                "the tool is in contact for only {:.0} % of its time on or near the surface",
                100.0 * share
            ),
            Self::LittleSliding { travel, radius } => write!(
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
    let shape = bulge(is_convex);
    write!(
        f,
        "the contacts lie on a {shape} cylinder of radius {radius:.2} m, whose axis is at {:.0}° to the surface's x axis, not on a plane",
        axis.to_degrees()
    )
}

/// Writes [`Doubt::DoublyCurved`].
fn write_doubly_curved(f: &mut fmt::Formatter<'_>, radii: [f64; 2], direction: f64) -> fmt::Result {
    let [first, second] = radii.map(|radius| (radius.abs(), bulge(radius > 0.0)));
    write!(
        f,
        "the contacts lie on a surface curved in two directions, not on a plane: {} with a radius of {:.2} m at {:.0}° to the surface's x axis, {} with {:.2} m across it",
        first.1,
        first.0,
        direction.to_degrees(),
        second.1,
        second.0
    )
}

/// Word for the side to which a surface bulges, seen from the tool.
const fn bulge(is_convex: bool) -> &'static str {
    if is_convex { "convex" } else { "concave" }
}

/// Writes [`Doubt::PressForceDiffers`].
fn write_pressed_otherwise(
    f: &mut fmt::Formatter<'_>,
    force: f64,
    declared: f64,
    matters: f64,
) -> fmt::Result {
    let consequence = if matters > MOST_BY_SCALE {
        ", and the estimate depends on whether the tool pressed with this force or the measured force has a wrong scale"
    } else {
        ""
    };
    write!(
        f,
        "the tool pressed with {force:.1} N, {:.2} × press_force_n ({declared:.1} N){consequence}: set interaction.press_force_n if {force:.1} N is the nominal force",
        force / declared
    )
}

/// Writes [`Doubt::WrenchFrameRotated`].
fn write_frame_turned(
    f: &mut fmt::Formatter<'_>,
    [x, y, z]: [f64; 3],
    in_tool: bool,
) -> fmt::Result {
    let frame = if in_tool { "tool" } else { "surface" };
    write!(
        f,
        "the force of contact lies along ({x:.2}, {y:.2}, {z:.2}) in the axes of the {frame}, not along the normal: it is read as the normal force (--wrench-frame)"
    )
}

/// Writes [`Doubt::ClockOffset`].
fn write_clock_offset(f: &mut fmt::Formatter<'_>, offset: f64) -> fmt::Result {
    let late = if offset < 0.0 { "early" } else { "late" };
    write!(
        f,
        "the force is {:.2} s {late} against the position: the two were aligned",
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
        "the log {}: wiping at that time is not counted",
        parts.join(" and ")
    )
}

/// Writes [`Doubt::UnusableWrench`].
fn write_unusable(
    f: &mut fmt::Formatter<'_>,
    unusable: UnusableWrenches,
    share: f64,
) -> fmt::Result {
    let kinds = [
        (unusable.stale, "stale"),
        (unusable.saturated, "saturated"),
        (unusable.untared, "untared"),
    ];
    let kinds = kinds.into_iter().filter(|(count, _)| *count > 0);
    let kinds: Vec<String> = kinds
        .map(|(count, kind)| format!("{count} {kind}"))
        .collect();
    write!(
        f,
        "the wrench of {} samples, {:.1} % of all, is not used as touch ({}): wiping at that time is not counted",
        unusable.count(),
        100.0 * share,
        kinds.join(", ")
    )
}

/// Writes [`Doubt::ContactFarFromSurface`].
fn write_far_off(f: &mut fmt::Formatter<'_>, height: f64, searched: f64) -> fmt::Result {
    let side = if height < 0.0 { "below" } else { "above" };
    let height = height.abs();
    write!(
        f,
        "the tool pressed {height:.3} m {side} the believed surface, beyond the {searched:.3} m within which contact is searched: check the pose of the surface"
    )
}

/// Contents of a log from which its doubts are derived.
pub(super) struct LogEvidence<'a> {
    /// Pieces of the log, with their forces as read.
    pub(super) pieces: &'a [MeasuredPiece],
    pub(super) reading: &'a ForceReading,
    pub(super) classified: &'a ClassifiedPath,
    pub(super) events: &'a [Event],
    pub(super) contact_share: f64,
    pub(super) surface: &'a Surface,
    /// Settings as declared.
    pub(super) declared: &'a InterpretConfig,
    /// Settings with the log's own nominal force.
    pub(super) config: &'a InterpretConfig,
}

impl LogEvidence<'_> {
    /// Returns the reasons against wiping of this surface and the assumptions made to read the log, the most likely
    /// cause first.
    pub(super) fn doubts(&self) -> Vec<Doubt> {
        let path = &self.classified.path;
        let led = find_hand_guiding(path, self.events);
        let mut doubts: Vec<Doubt> = Vec::new();
        if self.declared.gap_m > 0.0 {
            doubts.extend(led);
            return doubts;
        }
        let Some((_, plane)) = &self.classified.plane else {
            // A tool that presses at one height for long is on a surface and not guided by hand.
            let far_off = find_distant_contact(path, self.config);
            let shape = || {
                let scatter = self.find_scatter()?;
                let curved = self.find_curvature().filter(Doubt::is_other_surface);
                Some(curved.unwrap_or(scatter))
            };
            let reason = far_off.or(led).or_else(shape);
            doubts.extend(reason.or_else(|| self.explain_missing_contact()));
            return doubts;
        };
        doubts.extend(led);
        doubts.extend(self.find_curvature());
        if !self.reading.has_free_motion {
            doubts.push(Doubt::NoFreeMotion);
        }
        doubts.extend(self.assumptions());
        doubts.extend(self.find_gaps());
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
                Doubt::LittleContact {
                    share: contact_share,
                },
            ),
            (travel < radius, Doubt::LittleSliding { travel, radius }),
            (share > MOST_BESIDE, Doubt::ContactBesideSurface { share }),
        ];
        doubts.extend(
            all.into_iter()
                .filter(|(is_so, _)| *is_so)
                .map(|(_, doubt)| doubt),
        );
        doubts
    }

    /// Marks the pieces at which the tool was low enough to touch, for the case that its force is misread.
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

    /// Returns a doubt if the tool pressed near the surface but its contacts lie on no common plane.
    fn find_scatter(&self) -> Option<Doubt> {
        let is_pressed = |piece: &&PathPiece| {
            piece.normalized_force >= self.config.confident_share
                && piece.height.abs() <= self.config.search_height_m
        };
        let confident = self.classified.path.iter().filter(is_pressed).count();
        let inliers = 0;
        (confident >= self.config.plane.min_points)
            .then_some(Doubt::Scattered { inliers, confident })
    }

    /// Returns why no contact was found: the tool stayed away, or its force shows none.
    fn explain_missing_contact(&self) -> Option<Doubt> {
        let closest = (self.pieces.iter())
            .map(|piece| piece.mean_height.abs())
            .min_by(f64::total_cmp)?;
        if closest > NEAR {
            return Some(Doubt::NeverNearSurface { closest });
        }
        let is_low = self.is_low();
        let mut forces: Vec<f64> = (self.pieces.iter().zip(is_low))
            .filter(|(_, is_low)| *is_low)
            .map(|(piece, _)| piece.force.norm())
            .collect();
        forces.sort_unstable_by(f64::total_cmp);
        let force = forces.get(forces.len() * 9 / 10).copied().unwrap_or(0.0);
        Some(Doubt::NoContactForce { closest, force })
    }

    /// Returns a doubt if the contacts lie on a surface that is no plane.
    fn find_curvature(&self) -> Option<Doubt> {
        let shape = ContactShape::of(self.pieces, self.surface, self.config);
        if !self.surface.shape.is_plane() {
            let off = shape.map(|(_, off)| off);
            let doubt = off.map(|off| Doubt::OffShape { off });
            return doubt.or_else(|| self.find_steady_contact_off_plane());
        }
        let doubt = shape.map(|(shape, off)| match shape {
            ContactShape::Cylinder {
                radius,
                axis,
                is_convex,
            } => Doubt::Curved {
                radius,
                axis,
                is_convex,
            },
            ContactShape::Arc {
                radius,
                direction,
                is_convex,
            } => Doubt::CurvedAlong {
                radius,
                direction,
                is_convex,
            },
            ContactShape::Doubly { radii, direction } => Doubt::DoublyCurved { radii, direction },
            ContactShape::Other => Doubt::NotPlanar { off },
        });
        doubt.or_else(|| self.find_steady_contact_off_plane())
    }

    /// Returns a doubt if the tool slid off the plane with the force with which it slides on it: a hand that pushes gives
    /// no such force for long.
    fn find_steady_contact_off_plane(&self) -> Option<Doubt> {
        self.classified.plane.as_ref()?;
        let path = &self.classified.path;
        let nominal = self.config.nominal_force();
        let is_pressed = |i: &usize| {
            self.pieces[*i].force.z >= LEAST_PRESSED * nominal
                && is_inland(path[*i].position.xy(), self.surface, self.config)
        };
        let [mut on, mut off] = [0.0; 2];
        let mut distances: Vec<f64> = Vec::new();
        let mut first = 0;
        while first < path.len() {
            let pressed = (first..path.len()).take_while(is_pressed);
            let mut travel = 0.0;
            let mut last = first;
            for i in pressed {
                travel += (path[i].position - path[last].position).xy().norm();
                last = i;
                if travel >= STEADY_TRAVEL {
                    break;
                }
            }
            let window = first..=last;
            first = last + 1;
            if travel < STEADY_TRAVEL {
                continue;
            }
            let count = window.clone().count() as f64;
            let mean = window.clone().map(|i| self.pieces[i].force.z).sum::<f64>() / count;
            // A hand lifts the tool steeply or far, with the force that the controller keeps.
            let rise = (path[last].height - path[*window.start()].height).abs();
            let highest = window
                .clone()
                .map(|i| path[i].height.abs())
                .fold(0.0, f64::max);
            let is_lifted = rise > STEEPEST * travel || highest > MOST_SPREAD;
            let is_off = |i: &usize| !path[*i].is_on_plane();
            if (window.clone().filter(is_off).count() as f64) < MOSTLY * count {
                on += travel;
            } else if STEADY.contains(&(mean / nominal)) && !is_lifted {
                off += travel;
                distances.extend(window.map(|i| path[i].height.abs()));
            }
        }
        let least = (LEAST_STEADY_OFF * (on + off)).max(LEAST_STEADY_TRAVEL);
        if distances.is_empty() || off < least {
            return None;
        }
        distances.sort_unstable_by(f64::total_cmp);
        let off = distances[(distances.len() - 1) * 9 / 10];
        Some(if self.surface.shape.is_plane() {
            Doubt::NotPlanar { off }
        } else {
            Doubt::OffShape { off }
        })
    }

    /// Returns the assumptions made where the forces are not as declared.
    fn assumptions(&self) -> impl Iterator<Item = Doubt> {
        let reading = self.reading;
        let turned = match reading.direction {
            PressDirection::Outward => None,
            PressDirection::Inward => Some(Doubt::WrenchSignInverted),
            PressDirection::Turned { direction, in_tool } => Some(Doubt::WrenchFrameRotated {
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
            .map(|force| Doubt::PressForceDiffers {
                force,
                declared,
                matters: 0.0,
            });
        let offset = reading.clock_offset;
        let clocks = (offset != 0.0).then_some(Doubt::ClockOffset { offset });
        turned.into_iter().chain(otherwise).chain(clocks)
    }

    fn is_touching(&self, piece: &PathPiece) -> bool {
        piece.is_on_plane() && piece.normalized_force >= self.config.events.contact_share[1]
    }

    /// Returns a doubt if the log is cut while the tool presses, or has gaps in contact.
    fn find_gaps(&self) -> Option<Doubt> {
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

    /// Sums up the time and travel of the tool in contact.
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

/// Totals of the contact.
#[derive(Debug, Clone, Copy, Default)]
struct Sliding {
    /// Time in contact [s].
    time: f64,
    /// The part of it beside the surface [s].
    beside: f64,
    /// Travel in contact [m].
    travel: f64,
}

fn find_hand_guiding(path: &[PathPiece], events: &[Event]) -> Option<Doubt> {
    let led = (events.iter()).filter(|event| event.kind == EventKind::HandGuiding);
    let led: f64 = led.map(|event| event.end - event.start).sum();
    let all = path.last()?.time[1] - path.first()?.time[0];
    let share = led / all;
    (share > MOST_LED).then_some(Doubt::HandGuided { share })
}

/// Returns a doubt if the tool pressed too far from the believed surface. Without a plane, heights are those over the
/// believed surface.
fn find_distant_contact(path: &[PathPiece], config: &InterpretConfig) -> Option<Doubt> {
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
    (height.abs() > searched).then_some(Doubt::ContactFarFromSurface { height, searched })
}
