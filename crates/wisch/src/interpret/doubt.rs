//! Whether a log shows wiping of this surface, and if not, why.

use super::contact::{ContactLevel, MOST_LEVELS, STIFFEST};
use super::wrench_quality::UnusableWrenches;
use std::fmt;

/// Height over the believed surface within which a tool without measured force may have touched [m].
pub(super) const NEAR: f64 = 0.02;
/// Difference of the performance from which the scale of the force is decisive [1].
const MOST_BY_SCALE: f64 = 0.1;
/// Largest share of samples without a usable wrench with which the rest still shows what was wiped [1].
const MOST_UNUSABLE: f64 = 0.5;
/// Largest share of samples without a usable wrench in which nothing was wiped that matters [1].
const FEW_UNUSABLE: f64 = 0.02;
/// Largest share of samples with a wrong pose with which the rest still shows what was wiped [1].
const MOST_JUMPS: f64 = 0.05;
/// Range of the press force over the declared one beyond which the unit of the force must be wrong [1].
const PLAUSIBLE_FORCE: std::ops::RangeInclusive<f64> = 0.2..=5.0;
/// Largest change of the bias over the press force with which contact still differs from free motion [1].
const MOST_BIAS_CHANGE: f64 = 0.3;
/// Largest lean of a tool whose underside still faces the surface [rad]; 60°, a cosine of 0.5.
const MOST_LEAN: f64 = std::f64::consts::FRAC_PI_3;

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
    /// The contacts lie on parallel planes at different heights rather than on one plane.
    SeveralHeights {
        /// The planes, the lowest first; unused entries are without contacts.
        levels: [ContactLevel; MOST_LEVELS],
        /// Number of contacts.
        contacts: usize,
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
    /// The heights of the contacts fit a tool of another stiffness than the declared one.
    StiffnessDiffers {
        /// Stiffness that the contacts show \[N/m\].
        found: f64,
        /// Declared press force over declared compression \[N/m\].
        declared: f64,
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
        /// Time without samples in which the tool may have wiped \[s\].
        missing: f64,
    },
    /// The pose jumps faster than any tool moves.
    PoseJumps {
        /// Number of samples that were left out, because the pose jumped there and back.
        left_out: usize,
        /// Their share of all samples \[1\].
        share: f64,
        /// Number of jumps after which the pose stayed elsewhere, or that took several samples.
        lasting: usize,
        /// Time \[s\] and distance \[m\] of the first jump.
        first: (f64, f64),
    },
    /// The time between two samples is too long to show contact.
    Sparse {
        /// Median time between two samples \[s\].
        period: f64,
    },
    /// The bias of the force differs between two free motions: it drifts, or the sensor was tared in between.
    BiasChange {
        /// Size of the change \[N\].
        change: f64,
        /// The same over the usual press force \[1\].
        share: f64,
        /// Times of the two free motions \[s\].
        times: [f64; 2],
    },
    /// The contacts lie on a plane that is steeper than those that are searched.
    TooSteep {
        /// Its angle to the believed surface \[rad\].
        tilt: f64,
        /// Largest angle that is searched \[rad\].
        searched: f64,
    },
    /// In contact, the z axis of the tool's frame leans away from the normal of the surface.
    ToolLeans {
        /// Median angle between the two lines, from 0 to π/2 \[rad\].
        lean: f64,
        /// The part of it beyond the tilt that the tool has by design \[rad\].
        beyond: f64,
    },
    /// The wrenches of these samples were not usable, so that they do not show what the tool touched.
    UnusableWrench {
        /// Their numbers.
        unusable: UnusableWrenches,
        /// Their share of all samples \[1\].
        share: f64,
    },
    /// An observation after the log shows a number of grains that hardly a member of the belief explains.
    ObservationContradicts {
        /// Number of detections.
        seen: usize,
        /// Range of the numbers of detections that touch predicts, from the 5th to the 95th percentile.
        left: [f64; 2],
        /// The same if nothing had been removed.
        believed: [f64; 2],
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
    /// In the air, the force is vertical and as large as the weight of a tool.
    LoadInAir {
        /// Size of the force \[N\].
        force: f64,
        /// Mass with this weight \[kg\].
        mass: f64,
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
            Self::PressForceDiffers {
                force,
                declared,
                matters,
            } => *matters > MOST_BY_SCALE || !PLAUSIBLE_FORCE.contains(&(force / declared)),
            Self::PoseJumps { share, lasting, .. } => *lasting > 0 || *share > MOST_JUMPS,
            Self::BiasChange { share, .. } => *share > MOST_BIAS_CHANGE,
            Self::ToolLeans { beyond, .. } => *beyond > MOST_LEAN,
            Self::ObservationContradicts { seen, believed, .. } => *seen as f64 > believed[1],
            Self::UnusableWrench { unusable, share } => unusable.lost_share(*share) > MOST_UNUSABLE,
            Self::NoContactForce { .. }
            | Self::NeverNearSurface { .. }
            | Self::NoFreeMotion
            | Self::Curved { .. }
            | Self::CurvedAlong { .. }
            | Self::DoublyCurved { .. }
            | Self::NotPlanar { .. }
            | Self::SeveralHeights { .. }
            | Self::OffShape { .. }
            | Self::HandGuided { .. }
            | Self::ContactFarFromSurface { .. }
            | Self::ContactBesideSurface { .. }
            | Self::Sparse { .. }
            | Self::TooSteep { .. }
            | Self::Scattered { .. } => true,
            Self::StiffnessDiffers { .. }
            | Self::WrenchSignInverted
            | Self::WrenchFrameRotated { .. }
            | Self::ClockOffset { .. }
            | Self::LoadInAir { .. }
            | Self::Incomplete { .. }
            | Self::LittleContact { .. }
            | Self::LittleSliding { .. } => false,
        }
    }

    /// Whether the log shows the shape or the pose of another surface than the believed one.
    pub(super) fn is_other_surface(&self) -> bool {
        matches!(
            self,
            Self::ContactFarFromSurface { .. }
                | Self::NeverNearSurface { .. }
                | Self::TooSteep { .. }
                | Self::Curved { .. }
                | Self::CurvedAlong { .. }
                | Self::DoublyCurved { .. }
                | Self::SeveralHeights { .. }
                | Self::OffShape { .. }
        )
    }

    /// Whether the tool may have wiped more than the log shows: it begins or ends while the tool presses, or has no usable
    /// samples for a time.
    pub fn is_cut(&self) -> bool {
        match self {
            Self::Incomplete { .. } => true,
            Self::UnusableWrench { unusable, share } => unusable.lost_share(*share) > FEW_UNUSABLE,
            _ => false,
        }
    }
}

impl fmt::Display for Doubt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NoContactForce { closest, force } => write_no_contact(f, closest, force),
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
            } => write_arc(f, radius, direction, is_convex),
            Self::DoublyCurved { radii, direction } => write_doubly_curved(f, radii, direction),
            Self::NotPlanar { off } => write!(
                f,
                "the contacts lie on no plane: a tenth of them is more than {:.1} mm off the best one, and no cylinder or other smooth shape explains them",
                1e3 * off
            ),
            Self::SeveralHeights { levels, contacts } => write_heights(f, &levels, contacts),
            Self::OffShape { off } => write!(
                f,
                "the contacts do not lie on the believed curved surface: a tenth of them is more than {:.1} mm off it, wherever it lies; check its radius and axis, or its mesh",
                1e3 * off
            ),
            Self::PressForceDiffers {
                force,
                declared,
                matters,
            } => write_pressed_otherwise(f, force, declared, matters),
            Self::StiffnessDiffers { found, declared } => write_stiffness(f, found, declared),
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
            Self::PoseJumps {
                left_out,
                share,
                lasting,
                first,
            } => write_jumps(f, left_out, share, lasting, first),
            Self::Sparse { period } => write!(
                f,
                "the log has a sample every {period:.2} s, which is too slow to show contact: record at least 5 samples per second"
            ),
            Self::BiasChange {
                change,
                share,
                times,
            } => write_bias_change(f, change, share, times),
            Self::TooSteep { tilt, searched } => write_steep(f, tilt, searched),
            Self::ToolLeans { lean, beyond } => write_lean(f, lean, beyond),
            Self::UnusableWrench { unusable, share } => write_unusable(f, unusable, share),
            Self::ObservationContradicts {
                seen,
                left,
                believed,
            } => write_contradiction(f, seen, left, believed),
            Self::HandGuided { share } => write!(
                f,
                "a person guides the tool by hand for {:.0} % of the log",
                100.0 * share
            ),
            Self::ContactFarFromSurface { height, searched } => write_far_off(f, height, searched),
            Self::LoadInAir { force, mass } => write_load(f, force, mass),
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

/// Writes [`Doubt::NoContactForce`].
fn write_no_contact(f: &mut fmt::Formatter<'_>, closest: f64, force: f64) -> fmt::Result {
    write!(
        f,
        "the tool came within {:.1} mm of the believed surface, but its force shows no contact (it stays below {force:.1} N there): check the height of the surface, and the link and frame of the wrench; or the tool did not press",
        1e3 * closest
    )
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

/// Writes [`Doubt::CurvedAlong`].
fn write_arc(
    f: &mut fmt::Formatter<'_>,
    radius: f64,
    direction: f64,
    is_convex: bool,
) -> fmt::Result {
    write!(
        f,
        "the contacts lie on a {} arc of radius {radius:.2} m along the direction at {:.0}° to the surface's x axis, not on a plane; strokes in another direction would show the shape",
        bulge(is_convex),
        direction.to_degrees()
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

/// Writes [`Doubt::SeveralHeights`].
fn write_heights(
    f: &mut fmt::Formatter<'_>,
    levels: &[ContactLevel],
    contacts: usize,
) -> fmt::Result {
    let used: Vec<String> = (levels.iter().filter(|level| level.contacts > 0))
        .map(|level| format!("{} at {:+.1} mm", level.contacts, 1e3 * level.height))
        .collect();
    let count = if used.len() == 2 { "two" } else { "three" };
    write!(
        f,
        "the contacts lie at {count} heights over the believed surface, not on one plane: of {contacts} contacts, {}: interpret each part of the surface as a task of its own, and check whether surface or robot moved during the log",
        used.join(", ")
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
    let consequence = if !PLAUSIBLE_FORCE.contains(&(force / declared)) {
        ", so that the unit or the scale of the force is probably wrong (--force-unit-n, --force-scale)"
    } else if matters > MOST_BY_SCALE {
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

/// Writes [`Doubt::StiffnessDiffers`].
fn write_stiffness(f: &mut fmt::Formatter<'_>, found: f64, declared: f64) -> fmt::Result {
    let more = if found >= STIFFEST { " or more" } else { "" };
    write!(
        f,
        "the heights of the contacts fit a tool of {found:.0} N/m{more}, not of {declared:.0} N/m as declared (press_force_n over compression_depth_m): contact is read with {found:.0} N/m"
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

/// Writes [`Doubt::BiasChange`].
fn write_bias_change(
    f: &mut fmt::Formatter<'_>,
    change: f64,
    share: f64,
    [before, after]: [f64; 2],
) -> fmt::Result {
    write!(
        f,
        "the bias of the force differs by {change:.1} N between the free motion at {before:.1} s and that at {after:.1} s, {:.0} % of the press force: tare the sensor before the log and not during it, or correct the force before",
        100.0 * share
    )
}

/// Writes [`Doubt::TooSteep`].
fn write_steep(f: &mut fmt::Formatter<'_>, tilt: f64, searched: f64) -> fmt::Result {
    write!(
        f,
        "the contacts lie on a plane that is tilted by {:.1}° against the believed surface, beyond the {:.0}° that are searched: check the orientation of the surface",
        tilt.to_degrees(),
        searched.to_degrees()
    )
}

/// Writes [`Doubt::PoseJumps`].
fn write_jumps(
    f: &mut fmt::Formatter<'_>,
    left_out: usize,
    share: f64,
    lasting: usize,
    (time, distance): (f64, f64),
) -> fmt::Result {
    let plural = |count: usize, what: &str| {
        let end = if count == 1 { "" } else { "s" };
        format!("{count} {what}{end}")
    };
    let parts = [
        (left_out > 0).then(|| {
            format!(
                "{} ({:.1} %) left out",
                plural(left_out, "sample"),
                100.0 * share
            )
        }),
        (lasting > 0).then(|| {
            format!(
                "{} that are wider than single samples",
                plural(lasting, "jump")
            )
        }),
    ];
    let parts: Vec<String> = parts.into_iter().flatten().collect();
    write!(
        f,
        "the pose jumps faster than a tool moves, first by {distance:.2} m at {time:.2} s: {}",
        parts.join(", ")
    )
}

/// Writes [`Doubt::ToolLeans`].
fn write_lean(f: &mut fmt::Formatter<'_>, lean: f64, beyond: f64) -> fmt::Result {
    let degrees = lean.to_degrees();
    let consequence = if beyond > MOST_LEAN {
        "so the area that the tool touched is unknown"
    } else {
        "and the estimate counts a leaning tool"
    };
    write!(
        f,
        "in contact the z axis of the logged frame is {degrees:.0}° off the surface's normal, {consequence}: if this frame is not that of the tool, state the tool's pose in it (--pose-offset)"
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

/// Writes [`Doubt::ObservationContradicts`].
fn write_contradiction(
    f: &mut fmt::Formatter<'_>,
    seen: usize,
    [least, most]: [f64; 2],
    [fewest, all]: [f64; 2],
) -> fmt::Result {
    let advice = if seen as f64 > all {
        "more than there were believed to be before: check the number of particles of the task"
    } else {
        "the log may lack contact, or the tool has another effect than expected"
    };
    write!(
        f,
        "the observation shows {seen} dirt locations, but after the log {least:.0} to {most:.0} were expected, of {fewest:.0} to {all:.0} before: {advice}"
    )
}

/// Writes [`Doubt::ContactFarFromSurface`].
fn write_far_off(f: &mut fmt::Formatter<'_>, height: f64, searched: f64) -> fmt::Result {
    let side = if height < 0.0 { "below" } else { "above" };
    let height = height.abs();
    write!(
        f,
        "the tool pressed {height:.3} m {side} the believed surface, beyond the {searched:.3} m within which contact is searched: check the pose of the surface, and state the tool's pose in the logged frame if that is not the frame of the tool (--pose-offset)"
    )
}

/// Writes [`Doubt::LoadInAir`].
fn write_load(f: &mut fmt::Formatter<'_>, force: f64, mass: f64) -> fmt::Result {
    write!(
        f,
        "in the air the force is {force:.1} N along the vertical, as the weight of {mass:.2} kg: if the sensor carries the tool, state its mass (--payload-mass)"
    )
}
