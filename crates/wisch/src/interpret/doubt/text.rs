//! The texts of doubts for people.

use super::force_unit::describe_units;
use super::{Doubt, LEAST_NEAR, LONGEST_PERIOD, MOST_BY_SCALE, MOST_LEAN, NEAR, PLAUSIBLE_FORCE};
use crate::interpret::contact::{ContactLevel, STIFFEST};
use crate::interpret::wrench_quality::UnusableWrenches;
use std::fmt;

/// Texts of doubts without values.
const NO_FREE_MOTION: &str = "the log shows no calm free motion, so the bias of the force is unknown: record a second of motion above the surface";
const UNPROVEN_CAMERA: &str = "the observation shows no dirt, and no earlier one shows that the camera detects any: it does not decide what touch cannot";
const OTHER_SIDE: &str = "the tool presses against the other side of the believed surface, and its free motion is on that side too: correct the side of a mesh (surface.mesh.towards), or turn the surface by 180° about its x axis (surface.rpy_rad)";

impl fmt::Display for Doubt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NoContactForce {
                closest,
                force,
                declared,
                lasts,
            } => write_no_contact(f, closest, [force, declared], lasts),
            Self::ForceInOtherUnit { force, declared } => write_other_unit(f, force, declared),
            Self::FarAway { distance } => write_far_away(f, distance),
            Self::OtherSide => f.write_str(OTHER_SIDE),
            Self::NeverNearSurface { closest } => write_never_near(f, closest),
            Self::NoFreeMotion => f.write_str(NO_FREE_MOTION),
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
            Self::NotPlanar { off } => write_not_planar(f, off),
            Self::SeveralHeights { levels, contacts } => write_heights(f, &levels, contacts),
            Self::OffShape { off } => write_off_shape(f, off),
            Self::PressForceDiffers {
                force,
                declared,
                matters,
                offsets,
            } => {
                write_pressed_otherwise(f, force, declared, matters)?;
                write_offsets(f, offsets)
            }
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
            Self::Sparse { period } => write_sparse(f, period),
            Self::HeldPoses { period } => write_held(f, period),
            Self::TaredEarly { time, change } => write_tared(f, time, change),
            Self::Inertia { mass } => write_inertia(f, mass),
            Self::ClocksUncertain { offsets } => write_uncertain_clocks(f, offsets),
            Self::BiasChange {
                change,
                share,
                times,
            } => write_bias_change(f, change, share, times),
            Self::TooSteep { tilt, searched } => write_steep(f, tilt, searched),
            Self::ToolLeans { lean, beyond } => write_lean(f, lean, beyond),
            Self::UnusableWrench { unusable, share } => write_unusable(f, unusable, share),
            Self::ObservationContradicts { .. } => write_contradiction(f, self),
            Self::ObservationInOtherFrame { .. } => write_other_frame(f, self),
            Self::UnprovenCamera => f.write_str(UNPROVEN_CAMERA),
            Self::DetectionsBeside {
                left_out,
                of,
                farthest,
            } => write_beside(f, left_out, of, farthest),
            Self::FastTurns { turn, .. } => write_fast_turns(f, turn),
            Self::HeightOnly { height } => write_height_only(f, height),
            Self::DetectionsRepeated { repeated, of } => write_repeated(f, repeated, of),
            Self::PositionsContradictPose { distance, angle } => {
                write_elsewhere(f, distance, angle)
            }
            Self::RobotStoodStill { time, ordered } => write_still(f, time, ordered),
            Self::RobotOffPath { distance } => write_off_path(f, distance),
            Self::HandGuided { share } => write_guided(f, share),
            Self::ContactFarFromSurface { height, searched } => write_far_off(f, height, searched),
            Self::LoadInAir { force, mass } => write_load(f, force, mass),
            Self::ContactBesideSurface { share } => write_contact_beside(f, share),
            Self::OnOtherPatches { share } => write_other_patches(f, share),
            Self::Scattered { inliers, confident } => write!(
                f,
                "only {inliers} of {confident} confident contacts lie on one plane"
            ),
            Self::LittleContact { share } => write!(
                f,
                "the tool is in contact for only {:.0} % of its time on or near the surface",
                100.0 * share
            ),
            Self::LittleSliding { travel, radius } => write_sliding(f, travel, radius),
        }
    }
}

/// Writes [`Doubt::OnOtherPatches`].
fn write_other_patches(f: &mut fmt::Formatter<'_>, share: f64) -> fmt::Result {
    write!(
        f,
        "for {:.0} % of the time with force, the tool is on other patches of the mesh, which are not counted: interpret the log for each patch (surface.mesh.patch)",
        100.0 * share
    )
}

/// Writes [`Doubt::FarAway`].
fn write_far_away(f: &mut fmt::Formatter<'_>, distance: f64) -> fmt::Result {
    write!(
        f,
        "the tool is about {} m from the believed surface: check the unit of length (--length-unit-m), then the frame of the log and the pose of the surface",
        round_to_one_digit(distance)
    )
}

/// Writes [`Doubt::NotPlanar`].
fn write_not_planar(f: &mut fmt::Formatter<'_>, off: f64) -> fmt::Result {
    write!(
        f,
        "the contacts lie on no plane: a tenth of them is more than {:.1} mm off the best one, and no cylinder or other smooth shape explains them",
        1e3 * off
    )
}

/// Writes [`Doubt::OffShape`].
fn write_off_shape(f: &mut fmt::Formatter<'_>, off: f64) -> fmt::Result {
    write!(
        f,
        "the contacts do not lie on the believed curved surface: a tenth of them is more than {:.1} mm off it at the pose that fits them best; check its radius and axis, its mesh, and its pose",
        1e3 * off
    )
}

/// Writes [`Doubt::Sparse`].
fn write_sparse(f: &mut fmt::Formatter<'_>, period: f64) -> fmt::Result {
    write!(
        f,
        "the log has a sample every {period:.2} s, which is too slow to show contact: record at least 5 samples per second"
    )
}

/// Writes [`Doubt::HeldPoses`].
fn write_held(f: &mut fmt::Formatter<'_>, period: f64) -> fmt::Result {
    let way = if period > LONGEST_PERIOD {
        "which is too slow to show contact"
    } else {
        "and was interpolated"
    };
    write!(
        f,
        "the pose changes only every {period:.2} s, {way}: record at least 5 poses per second, better 50"
    )
}

/// Writes [`Doubt::TaredEarly`].
fn write_tared(f: &mut fmt::Formatter<'_>, time: f64, change: f64) -> fmt::Result {
    write!(
        f,
        "the force changes by {change:.1} N at {time:.2} s, before the first contact, as if the sensor was tared: samples before it are left out"
    )
}

/// Writes [`Doubt::Inertia`].
fn write_inertia(f: &mut fmt::Formatter<'_>, mass: f64) -> fmt::Result {
    write!(
        f,
        "the forces include the inertia of {mass:.2} kg behind the sensor: this mass times the acceleration of the pose is subtracted"
    )
}

/// Writes [`Doubt::ClocksUncertain`].
fn write_uncertain_clocks(f: &mut fmt::Formatter<'_>, [one, other]: [f64; 2]) -> fmt::Result {
    write!(
        f,
        "the clocks of force and position differ, but the log fits a force that is late by {one:.2} s as well as by {other:.2} s: record both with one clock, and begin and end in free motion"
    )
}

/// Writes [`Doubt::NoContactForce`].
fn write_no_contact(
    f: &mut fmt::Formatter<'_>,
    closest: f64,
    [force, declared]: [f64; 2],
    lasts: f64,
) -> fmt::Result {
    write!(
        f,
        "the tool came within {:.1} mm of the believed surface, but ",
        1e3 * closest
    )?;
    if lasts < LEAST_NEAR {
        return write!(
            f,
            "it was within {:.0} mm for only {lasts:.2} s, which is too short to show contact: check the pose of the surface and the frame of the log; or the tool did not wipe",
            1e3 * NEAR
        );
    }
    let size = Newtons(force);
    if force < declared {
        write!(
            f,
            "its force shows no contact (for 90 % of the time there it is below {size}; press_force_n is {declared:.1} N)"
        )?;
    } else {
        write!(
            f,
            "its force, up to {size} for 90 % of the time there, is not that of a tool that slides on a plane"
        )?;
    }
    f.write_str(": check the height of the surface, and the link and frame of the wrench; or the tool did not press")
}

/// Writes [`Doubt::ForceInOtherUnit`].
fn write_other_unit(f: &mut fmt::Formatter<'_>, force: f64, declared: f64) -> fmt::Result {
    let units = describe_units(force, declared).unwrap_or_default();
    let pressed = if force < declared {
        "the tool hardly pressed or "
    } else {
        ""
    };
    write!(
        f,
        "near the believed surface the median force is {}, {:.3} × press_force_n ({declared:.1} N): {units}, unless {pressed}the sensor has a bias",
        Newtons(force),
        force / declared
    )
}

/// Rounds a positive number to its first digit.
fn round_to_one_digit(number: f64) -> f64 {
    let digit = libm::pow(10.0, libm::floor(libm::log10(number)));
    (number / digit).round() * digit
}

/// A force in newtons, of which a small one has more digits.
struct Newtons(f64);

impl fmt::Display for Newtons {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let digits = if self.0.abs() < 0.1 { 4 } else { 1 };
        write!(f, "{:.digits$} N", self.0)
    }
}

/// Writes [`Doubt::NeverNearSurface`].
fn write_never_near(f: &mut fmt::Formatter<'_>, closest: f64) -> fmt::Result {
    write!(
        f,
        "the tool never came within {:.0} mm of the believed surface (closest: {closest:.3} m): check the pose of the surface, the frame of the log and its unit of length",
        1e3 * NEAR
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

/// Word for the curvature of a surface, as viewed from the tool.
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
    let ratio = force / declared;
    if let Some(units) = describe_units(force, declared) {
        let (verb, consequence) = match PLAUSIBLE_FORCE.contains(&ratio) {
            false => ("is probably", ""),
            true if matters > MOST_BY_SCALE => ("may be", ", and the estimate depends on it"),
            true => ("may be", ""),
        };
        return write!(
            f,
            "the tool pressed with {}, {ratio:.3} × press_force_n ({declared:.1} N), so that the unit of the force {verb} wrong{consequence}: {units}; or set interaction.press_force_n if this is the nominal force",
            Newtons(force)
        );
    }
    let consequence = if !PLAUSIBLE_FORCE.contains(&ratio) {
        ", so that the unit or the scale of the force is probably wrong (--force-unit-n, --force-scale)"
    } else if matters > MOST_BY_SCALE {
        ", and the estimate depends on whether the tool pressed with this force or the measured force has a wrong scale"
    } else {
        ""
    };
    write!(
        f,
        "the tool pressed with {force:.1} N, {ratio:.2} × press_force_n ({declared:.1} N){consequence}: set interaction.press_force_n if {force:.1} N is the nominal force"
    )
}

/// Least difference of two offsets of the surface that is stated [m].
const LEAST_DIFFERENCE: f64 = 1e-3;

/// Writes the distance of the surface under both explanations of the force, if these distances
/// differ.
fn write_offsets(f: &mut fmt::Formatter<'_>, offsets: Option<[f64; 2]>) -> fmt::Result {
    match offsets {
        Some([by_press, by_scale])
            if (by_press - by_scale).abs() >= LEAST_DIFFERENCE
                && (by_press + by_scale).is_finite() =>
        {
            let taken = if by_press < by_scale {
                "first"
            } else {
                "second"
            };
            write!(
                f,
                "; the surface is up to {:.1} mm from where it is believed to be if this force is right, up to {:.1} mm if its scale is wrong: the {taken} is taken, as it is nearer",
                1e3 * by_press,
                1e3 * by_scale
            )
        }
        _ => Ok(()),
    }
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
        (missing > 0.0).then(|| format!("has no samples, or no forces, for {missing:.1} s")),
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
        (
            unusable.frozen_pose,
            "with a pose that stays exactly the same while the force changes",
        ),
        (
            unusable.missing_pose,
            "before the first pose or after the last",
        ),
    ];
    let kinds = kinds.into_iter().filter(|(count, _)| *count > 0);
    let kinds: Vec<String> = kinds
        .map(|(count, kind)| format!("{count} {kind}"))
        .collect();
    write!(
        f,
        "{}{} samples, {:.1} % of all, {} not used as touch ({}): wiping at that time is not counted",
        if unusable.frozen_pose > 0 {
            ""
        } else {
            "the wrench of "
        },
        unusable.count(),
        100.0 * share,
        if unusable.frozen_pose > 0 {
            "are"
        } else {
            "is"
        },
        kinds.join(", ")
    )
}

/// Writes [`Doubt::ObservationContradicts`].
fn write_contradiction(f: &mut fmt::Formatter<'_>, doubt: &Doubt) -> fmt::Result {
    let Doubt::ObservationContradicts {
        seen,
        left: [least, most],
        believed: [fewest, all],
        is_more_than_before,
        hidden_share,
        shares,
        ..
    } = doubt
    else {
        return Ok(());
    };
    if let Some(shares) = shares {
        let [found, low, high] = shares.map(|share| 100.0 * share);
        return write!(
            f,
            "of the {seen} dirt locations that the observation shows, {found:.0} % lie within the goal, but after the log {low:.0} % to {high:.0} % were expected: the estimate follows the observation; the log may lack contact, or the tool has another effect than expected"
        );
    }
    let advice = if (*seen as f64) < *least {
        "the observation may be incomplete, or the tool wiped more than the log shows"
    } else if *is_more_than_before {
        "more than there were believed to be before: check the number of particles of the task"
    } else {
        "the estimate follows the observation; the log may lack contact, or the tool has another effect than expected"
    };
    if (*least..=*most).contains(&(*seen as f64)) {
        return write!(
            f,
            "the observation shows {seen} dirt locations, within the {least:.0} to {most:.0} that were expected after the log, but hardly any explanation of the log gives this number: {advice}"
        );
    }
    write!(
        f,
        "the observation shows {seen} dirt locations, but after the log {least:.0} to {most:.0} were expected, of {fewest:.0} to {all:.0} before: {advice}"
    )?;
    if *hidden_share <= 0.0 {
        return Ok(());
    }
    let percent = 100.0 * hidden_share;
    write!(
        f,
        "; {percent:.0} % of the dirt is hidden from the camera, where the log may be as wrong"
    )
}

/// Writes [`Doubt::FastTurns`].
fn write_fast_turns(f: &mut fmt::Formatter<'_>, turn: f64) -> fmt::Result {
    write!(
        f,
        "in contact the tool turns by about {:.0}° between two samples: the log does not show whether it turns faster, as more than half a turn looks like less in the other direction; record the pose at a higher rate",
        turn.to_degrees()
    )
}

/// Writes [`Doubt::HeightOnly`].
fn write_height_only(f: &mut fmt::Formatter<'_>, height: f64) -> fmt::Result {
    write!(
        f,
        "the contacts lie on no common plane, so that only their median height, {:.1} mm {} the believed surface, is used for its pose, and no tilt",
        1e3 * height.abs(),
        if height < 0.0 { "below" } else { "above" }
    )
}

/// Writes [`Doubt::DetectionsRepeated`].
fn write_repeated(f: &mut fmt::Formatter<'_>, repeated: usize, of: usize) -> fmt::Result {
    let verbs = if repeated == 1 {
        "repeats another one, at equal coordinates or closer than chance explains, and is"
    } else {
        "repeat other ones, at equal coordinates or closer than chance explains, and are"
    };
    write!(
        f,
        "{repeated} of {of} detections of the camera {verbs} left out"
    )
}

/// Writes [`Doubt::ObservationInOtherFrame`].
fn write_other_frame(f: &mut fmt::Formatter<'_>, doubt: &Doubt) -> fmt::Result {
    let Doubt::ObservationInOtherFrame {
        untouched,
        seen_again,
        unknown,
        of,
    } = doubt
    else {
        return Ok(());
    };
    write!(
        f,
        "the observation shows {seen_again} of the {untouched} known dirt locations that the tool did not touch, and {unknown} of its {of} detections lie where no dirt is possible: check the frame of the observation, its origin and the directions of x and y"
    )
}

/// Writes [`Doubt::ContactBesideSurface`].
fn write_contact_beside(f: &mut fmt::Formatter<'_>, share: f64) -> fmt::Result {
    write!(
        f,
        "{:.0} % of the contact time is beside the surface: check the pose and the outline of the surface",
        100.0 * share
    )
}

/// Writes [`Doubt::PositionsContradictPose`].
fn write_elsewhere(f: &mut fmt::Formatter<'_>, distance: f64, angle: f64) -> fmt::Result {
    write!(
        f,
        "for most of the motion the tool is {distance:.3} m and {:.1}° from where the joint positions put it: check the tool centre point, the mount, the base frame, and the positions of the joints",
        angle.to_degrees()
    )
}

/// Writes [`Doubt::RobotStoodStill`].
fn write_still(f: &mut fmt::Formatter<'_>, time: f64, ordered: f64) -> fmt::Result {
    write!(
        f,
        "the robot stood still for {time:.1} s of the {ordered:.1} s for which it was ordered to move: check what blocked it"
    )
}

/// Writes [`Doubt::RobotOffPath`].
fn write_off_path(f: &mut fmt::Formatter<'_>, distance: f64) -> fmt::Result {
    write!(
        f,
        "for most of the motion the tool is {distance:.3} m from every point of the ordered path: check what moved the robot, and the frame and unit of its pose"
    )
}

/// Writes [`Doubt::LittleSliding`].
fn write_sliding(f: &mut fmt::Formatter<'_>, travel: f64, radius: f64) -> fmt::Result {
    write!(
        f,
        "in contact the tool slid {travel:.3} m in all, less than its own radius of {radius:.3} m"
    )
}

/// Writes [`Doubt::HandGuided`].
fn write_guided(f: &mut fmt::Formatter<'_>, share: f64) -> fmt::Result {
    write!(
        f,
        "a person guides the tool by hand for {:.0} % of the log",
        100.0 * share
    )
}

/// Writes [`Doubt::DetectionsBeside`].
fn write_beside(
    f: &mut fmt::Formatter<'_>,
    left_out: usize,
    of: usize,
    farthest: f64,
) -> fmt::Result {
    let verb = if left_out == 1 { "is" } else { "are" };
    let advice = if 2 * left_out > of {
        ": their unit or frame is probably wrong; expected metres in the frame of the believed surface, unless the dirt was wiped off it"
    } else {
        ""
    };
    write!(
        f,
        "{left_out} of {of} detections of the camera {verb} beside the surface, up to {farthest:.3} m from its edge, and {verb} left out{advice}"
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

/// Writes [`Doubt::LoadInAir`].
fn write_load(f: &mut fmt::Formatter<'_>, force: f64, mass: f64) -> fmt::Result {
    write!(
        f,
        "in the air the force is {force:.1} N along the vertical, as the weight of {mass:.2} kg: if the sensor carries the tool, state its mass (--payload-mass)"
    )
}
