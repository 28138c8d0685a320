//! Comments of the SRDF, the summary and the JSON object.

use super::proposal::{Proposal, is_mobile};
use super::trial::Tried;
use crate::args::RobotSetupArgs;
use crate::commands::PROGRAM;
use crate::commands::words::{format_count, internal};
use crate::failure::Failure;
use serde::Serialize;
use std::f64::consts::FRAC_PI_3;
use std::fmt::Write;
use std::iter;
use std::path::Path;
use wisch::robot::setup::{
    ArmChain, LinkPairs, ProposedGroup, ReadyPosture, SINGULAR, SetupConfig, SetupError,
    find_table, held_posture,
};
use wisch::robot::{LinkAxis, LinkId, READY_STATE, RobotModel, SrdfComments};
use wisch_io::shell_word;

/// The schema of the object that `--json` prints.
const SCHEMA: u32 = 1;
/// Reasons for which a pair is not checked, in the order of the file.
const REASONS: [&str; 4] = ["Adjacent", "Never", "Always", "Default"];
/// Shipped tasks to try first: for a robot that drives, and for one that is fixed.
const FIRST_TASKS: [&str; 2] = ["chopping-board", "arm-board"];

/// Angle of a tip's z axis from the direction of the hand above which it is remarked on \[rad\].
const MAX_TIP_TILT: f64 = FRAC_PI_3;
/// Angle from straight above which a ready posture is remarked on \[rad\].
const MAX_TILT: f64 = 0.02;

/// The object that `--json` prints.
#[derive(Debug, Serialize)]
pub struct SetupRecord<'a> {
    format: &'static str,
    schema: u32,
    file: String,
    robot: &'a str,
    groups: Vec<GroupRecord<'a>>,
    ready: Vec<ReadyRecord<'a>>,
    /// Link that `--mobile` puts on a base that drives, or null.
    mobile_base: Option<&'a str>,
    /// Joints whose effort limits are too low to hold the ready posture.
    counterbalanced: Vec<&'a str>,
    /// Whether a tool at the tips is free of collision in the ready posture.
    has_room_for_tool: bool,
    /// Whether the robot is assumed to hang over the surface.
    is_assumed_to_hang: bool,
    pairs: PairsRecord,
    seed: u64,
    task: Option<String>,
    out: String,
}

#[derive(Debug, Serialize)]
struct GroupRecord<'a> {
    name: &'a str,
    base: &'a str,
    tip: &'a str,
    joints: usize,
    reason: &'a str,
    /// A link of the gripper that hangs on the tip, or null.
    gripper: Option<&'a str>,
    /// Axis of the tip along which a tool is held.
    tip_axis: &'static str,
    tip_tilt_rad: f64,
}

/// How the posture was chosen with a task.
#[derive(Debug, Serialize)]
struct TriedRecord {
    /// Number of postures from which a plan over the task's surface was followed.
    postures: usize,
    nodes: usize,
    /// Number of nodes that are out of reach from this posture.
    abandoned_nodes: usize,
}

impl From<Tried> for TriedRecord {
    fn from(tried: Tried) -> Self {
        Self {
            postures: tried.postures,
            nodes: tried.nodes,
            abandoned_nodes: tried.abandoned,
        }
    }
}

#[derive(Debug, Serialize)]
struct ReadyRecord<'a> {
    group: &'a str,
    /// Left out without a task, for a base that drives, and if no plan of the task can be followed.
    #[serde(skip_serializing_if = "Option::is_none")]
    tried: Option<TriedRecord>,
    place: &'a str,
    clearance_m: f64,
    manipulability: f64,
    /// Distance to the nearest limit, as a share of half the joint's range.
    limit_share: f64,
    tilt_rad: f64,
    tip_m: [f64; 3],
    samples: usize,
    free: usize,
}

#[derive(Debug, Serialize)]
struct PairsRecord {
    total: usize,
    adjacent: usize,
    never: usize,
    always: usize,
    default: usize,
    /// Pairs that random postures missed, but a descent did not.
    near: usize,
    samples: usize,
}

/// The object that `--json` prints if a part was not found.
#[derive(Debug, Serialize)]
pub struct FailedRecord<'a> {
    format: &'static str,
    schema: u32,
    file: String,
    robot: &'a str,
    /// Nothing was written.
    out: Option<String>,
    problem: String,
    help: &'a str,
}

impl<'a> SetupRecord<'a> {
    pub fn new(
        args: &RobotSetupArgs,
        robot: &'a RobotModel,
        proposal: &'a Proposal,
        out: &Path,
    ) -> Self {
        let groups = proposal.arms.iter().flat_map(|arm| {
            let gripper = arm.gripper.map(|link| link_name(robot, link));
            arm.groups.iter().map(move |proposed| GroupRecord {
                name: &proposed.group.name,
                base: link_name(robot, proposed.group.base),
                tip: link_name(robot, proposed.group.tip),
                joints: proposed.joints,
                reason: &proposed.reason,
                gripper,
                tip_axis: arm.tip_axis.as_str(),
                tip_tilt_rad: arm.tip_tilt,
            })
        });
        // The first arm holds the tool.
        let tried = iter::once(proposal.tried).chain(iter::repeat(None));
        let ready = (proposal.ready.iter().zip(tried)).map(|((group, ready), tried)| ReadyRecord {
            tried: tried.map(TriedRecord::from),
            group: &group.name,
            place: &ready.place,
            clearance_m: ready.clearance,
            manipulability: ready.manipulability,
            limit_share: ready.limit_share,
            tilt_rad: ready.tilt,
            tip_m: ready.tip.into(),
            samples: ready.samples,
            free: ready.free,
        });
        let pairs = &proposal.pairs;
        let [adjacent, never, always, default] = REASONS.map(|reason| pairs.count(reason));
        Self {
            format: "wisch-robot-setup",
            schema: SCHEMA,
            file: args.file.display().to_string(),
            robot: robot.name(),
            groups: groups.collect(),
            ready: ready.collect(),
            mobile_base: (proposal.srdf.virtual_joints.first())
                .map(|base| base.child_link.as_str()),
            counterbalanced: name_counterbalanced(robot, proposal).collect(),
            has_room_for_tool: !proposal.assumed.no_tool,
            is_assumed_to_hang: proposal.assumed.hangs,
            pairs: PairsRecord {
                total: pairs.total,
                adjacent,
                never,
                always,
                default,
                near: pairs.near,
                samples: pairs.samples,
            },
            seed: args.seed,
            task: args.task.as_ref().map(|task| task.display().to_string()),
            out: out.display().to_string(),
        }
    }

    pub fn line(&self) -> Result<String, Failure> {
        json_line(self)
    }
}

impl<'a> FailedRecord<'a> {
    pub fn new(
        args: &RobotSetupArgs,
        robot: &'a RobotModel,
        error: &SetupError,
        help: &'a str,
    ) -> Self {
        Self {
            format: "wisch-robot-setup",
            schema: SCHEMA,
            file: args.file.display().to_string(),
            robot: robot.name(),
            out: None,
            problem: error.to_string(),
            help,
        }
    }

    pub fn line(&self) -> Result<String, Failure> {
        json_line(self)
    }
}

fn json_line(record: &impl Serialize) -> Result<String, Failure> {
    Ok(serde_json::to_string(record).map_err(internal)? + "\n")
}

fn link_name(robot: &RobotModel, link: LinkId) -> &str {
    &robot.links()[link.index()].name
}

/// Returns the comments of the SRDF: what was chosen, and why.
pub fn comments(
    proposal: &Proposal,
    robot: &RobotModel,
    args: &RobotSetupArgs,
    config: &SetupConfig,
) -> SrdfComments {
    let file = args.file.file_name().unwrap_or_default().to_string_lossy();
    let seed = config.seed;
    let groups = proposal.arms.iter().flat_map(|arm| {
        let gripper = arm.gripper.map(|link| link_name(robot, link));
        (arm.groups.iter()).map(move |proposed| match gripper {
            None => proposed.reason.clone(),
            Some(part) => format!("{} The gripper {part} is not part of it.", proposed.reason),
        })
    });
    let mut groups: Vec<String> = groups.collect();
    if let Some(first) = groups.first_mut() {
        *first += "\nwisch takes the first group, unless a task or the command line names another.";
    }
    let rest = "Joints that other joints follow: in the middle of their limits, the following joints would be outside theirs.";
    let states = proposal.arms.iter().flat_map(|arm| {
        arm.groups.iter().map(|proposed| {
            let group = &proposed.group;
            let found = proposal.ready.iter().find(|(moved, _)| moved == group);
            found.map_or_else(
                || "The same posture, for the joints of this group.".to_owned(),
                |(_, ready)| describe_ready(ready, &proposal.pairs, seed),
            )
        })
    });
    let mut states: Vec<String> = states.collect();
    if let (Some(tried), Some(first)) = (proposal.tried, states.first_mut()) {
        let _ = write!(first, "\n{}.", describe_trial(tried));
    }
    let pairs = &proposal.pairs;
    let mut about_pairs = format!(
        "{} of {} pairs of links are not checked against each other: {}.\n\
         From {} random postures, seed {seed}; Never means farther than {} m in all of them, and in a\n\
         descent from the closest posture.",
        pairs.disabled.len(),
        pairs.total,
        by_reason(proposal),
        pairs.samples,
        config.never_margin,
    );
    if pairs.total == 0 {
        "Fewer than two links have collision shapes: no link is checked against another."
            .clone_into(&mut about_pairs);
    }
    if pairs.near > 0 {
        let _ = write!(
            about_pairs,
            "\n{} never collided in these postures but can come closer: checked.",
            format_count(pairs.near, "pair")
        );
    }
    if let Some(note) = unchecked_pairs_note(robot, proposal) {
        let _ = write!(about_pairs, "\n{note}.");
    }
    SrdfComments {
        head: format!(
            "SRDF of {}, proposed by wisch robot setup ({PROGRAM}) from {file}.\n\
             Read it before you move a robot with it.",
            robot.name()
        ),
        groups,
        states: states.into_iter().chain([rest.to_owned()]).collect(),
        counterbalanced: counterbalance_note(robot, proposal).unwrap_or_default(),
        pairs: about_pairs,
    }
}

fn describe_ready(ready: &ReadyPosture, pairs: &LinkPairs, seed: u64) -> String {
    let between = if pairs.total == 0 {
        ""
    } else {
        " between links and tool"
    };
    let clearance = clearance(ready, pairs) + between;
    let (first, rest) = clearance.split_at(1);
    let [x, y, z] = ready.tip.into();
    format!(
        "Tip {} at ({x:.3}, {y:.3}, {z:.3}) m from the root, {:.1} deg from straight at the surface.\n\
         {}{rest}; {:.0} % of half a range to the nearest limit;\n\
         manipulability {:.4} (Yoshikawa, in m). Best of {} free of collision, from {} random ones, seed {seed}.",
        ready.place,
        ready.tilt.to_degrees(),
        first.to_uppercase(),
        100.0 * ready.limit_share,
        ready.manipulability,
        format_count(ready.free, "posture"),
        ready.samples,
    )
}

/// Describes how a posture was chosen with a task.
fn describe_trial(tried: Tried) -> String {
    format!(
        "Of {} tried with a plan over the task's surface, this one leaves the fewest nodes out of reach: {} of {}",
        format_count(tried.postures, "posture"),
        tried.abandoned,
        tried.nodes
    )
}

/// Describes the clearance, which is measured up to 1 m.
fn clearance(ready: &ReadyPosture, pairs: &LinkPairs) -> String {
    if pairs.total == 0 {
        "clearance not measured (fewer than two links have collision shapes)".to_owned()
    } else if ready.clearance < 1.0 {
        format!("clearance {:.3} m", ready.clearance)
    } else {
        "clearance over 1 m".to_owned()
    }
}

fn by_reason(proposal: &Proposal) -> String {
    let counts = REASONS.map(|reason| (proposal.pairs.count(reason), reason));
    let present = counts.iter().filter(|(count, _)| *count > 0);
    let words: Vec<String> = present
        .map(|(count, reason)| format!("{count} {reason}"))
        .collect();
    words.join(", ")
}

/// Describes the result in lines of a label and a value.
pub fn describe(
    args: &RobotSetupArgs,
    robot: &RobotModel,
    proposal: &Proposal,
    out: &Path,
) -> String {
    let mut lines: Vec<(&str, String)> = Vec::new();
    for base in &proposal.srdf.virtual_joints {
        let (root, frame) = (&base.child_link, &base.parent_frame);
        lines.push(("base", format!("{root} drives in the plane of {frame}")));
    }
    lines.extend(
        wheels_note(robot)
            .filter(|_| !args.mobile && !is_mobile(robot, &proposal.arms))
            .map(|note| ("note", note)),
    );
    for arm in &proposal.arms {
        lines.extend(group_lines(robot, arm).map(|line| ("group", line)));
        lines.extend(tip_note(robot, arm).map(|note| ("note", note)));
        if let Some(part) = arm.gripper {
            let part = link_name(robot, part);
            let advice = "if it holds the tool, name the link between its fingers with --tip";
            lines.push(("gripper", format!("{part} is on the tip: {advice}")));
        }
    }
    for (i, (group, ready)) in proposal.ready.iter().enumerate() {
        lines.push((
            READY_STATE,
            format!(
                "{}: {}, {}, manipulability {:.4}, {:.0} % from the limits",
                group.name,
                ready.place,
                clearance(ready, &proposal.pairs),
                ready.manipulability,
                100.0 * ready.limit_share
            ),
        ));
        if let (0, Some(tried)) = (i, proposal.tried) {
            lines.push(("reach", describe_trial(tried)));
        }
        if ready.manipulability <= SINGULAR {
            lines.push(("note", format!(
                "{}: the ready posture is singular: in some direction, the joints cannot move the tip",
                group.name
            )));
        }
        if ready.tilt > MAX_TILT {
            let tilt = ready.tilt.to_degrees();
            lines.push(("note", format!(
                "{}: the tool is {tilt:.0} degrees from straight at the surface, as the arm cannot turn it further",
                group.name
            )));
        }
    }
    if proposal.assumed.hangs {
        lines.push((
            "note",
            "no ready posture is found around the robot, so it is assumed to hang over the surface: if it stands, check its limits and collision shapes, or name a task with --task".to_owned(),
        ));
    }
    if proposal.assumed.no_tool {
        let advice = "choose another link with --tip, or another tool";
        lines.push((
            "note",
            format!("a tool of 30 mm at the tip would touch the arm: {advice}"),
        ));
    }
    let pairs = &proposal.pairs;
    lines.push((
        "pairs",
        match pairs.total {
            0 => {
                "none: fewer than two links have collision shapes, so nothing is checked".to_owned()
            }
            total => format!(
                "{} of {total} not checked: {}",
                pairs.disabled.len(),
                by_reason(proposal)
            ),
        },
    ));
    lines.extend(unchecked_pairs_note(robot, proposal).map(|note| ("note", note)));
    lines.extend(counterbalance_note(robot, proposal).map(|note| ("note", note)));
    let postures = proposal.ready.first().map_or(0, |(_, ready)| ready.samples);
    lines.push((
        "samples",
        format!(
            "{} for pairs, {postures} for {READY_STATE}, seed {}",
            pairs.samples, args.seed
        ),
    ));
    lines.push(("SRDF", out.display().to_string()));
    let mut text = format!("{}: groups, ready posture and pairs\n", robot.name());
    for (label, value) in lines {
        let _ = writeln!(text, "  {label:<12} {value}");
    }
    text
}

/// Returns a remark on a robot with wheels.
fn wheels_note(robot: &RobotModel) -> Option<String> {
    let is_wheel = |name: &str| {
        ["wheel", "caster"]
            .iter()
            .any(|word| name.to_lowercase().contains(word))
    };
    let wheel = robot.links().iter().find(|link| is_wheel(&link.name))?;
    let name = &wheel.name;
    Some(format!(
        "the robot has a {name}, but no base that drives: --mobile declares one"
    ))
}

/// Describes the groups of an arm.
pub fn group_lines<'a>(
    robot: &'a RobotModel,
    arm: &'a ArmChain,
) -> impl Iterator<Item = String> + 'a {
    arm.groups
        .iter()
        .map(|ProposedGroup { group, joints, .. }| {
            let [base, tip] = [group.base, group.tip].map(|link| link_name(robot, link));
            let joints = format_count(*joints, "joint");
            format!("{}: {joints}, {base} to {tip}", group.name)
        })
}

fn name_counterbalanced<'a>(
    robot: &'a RobotModel,
    proposal: &'a Proposal,
) -> impl Iterator<Item = &'a str> {
    let joints = proposal.srdf.counterbalanced.iter();
    joints.map(|joint| robot.joints()[joint.index()].name.as_str())
}

/// Returns a remark on joints that cannot hold the ready posture within their effort limits.
fn counterbalance_note(robot: &RobotModel, proposal: &Proposal) -> Option<String> {
    let names: Vec<&str> = name_counterbalanced(robot, proposal).collect();
    (!names.is_empty()).then(|| {
        format!(
            "the effort limits of {} are too low to hold the ready posture: springs or weights are assumed, and these efforts are not checked; if there are none, correct the URDF and remove <counterbalance> from the SRDF",
            names.join(", ")
        )
    })
}

/// Returns a remark on pairs that are not checked although they are apart in some postures.
fn unchecked_pairs_note(robot: &RobotModel, proposal: &Proposal) -> Option<String> {
    let often = &proposal.pairs.often;
    let names = often.iter().map(|pair| {
        let [a, b] = pair.map(|link| link_name(robot, link));
        format!("{a} with {b}")
    });
    let names: Vec<String> = names.collect();
    (!names.is_empty()).then(|| {
        format!(
            "not checked, but apart in some postures: {}; if these links can touch on your robot, remove the pair from the SRDF",
            names.join(", ")
        )
    })
}

/// Returns a remark on an arm whose tip points out of the hand by another axis than z, or by none.
pub fn tip_note(robot: &RobotModel, arm: &ArmChain) -> Option<String> {
    let tip = arm.groups.first()?.group.tip;
    let (name, link, axis) = (&arm.name, link_name(robot, tip), arm.tip_axis);
    if arm.tip_tilt > MAX_TIP_TILT {
        let off = arm.tip_tilt.to_degrees();
        return Some(format!(
            "{name}: the {axis} axis of {link} points {off:.0} degrees off the direction of the hand; wisch holds a tool along it"
        ));
    }
    (axis != LinkAxis::Z).then(|| {
        format!(
            "{name}: the {axis} axis of {link} points out of the hand; wisch holds a tool along it"
        )
    })
}

/// Returns the commands to go on with.
pub fn next_steps(
    args: &RobotSetupArgs,
    robot: &RobotModel,
    proposal: &Proposal,
    out: &Path,
) -> String {
    let file = quote_path(&args.file);
    let packages = args.packages.iter();
    let packages: String = packages
        .map(|(name, folder)| {
            format!(
                " --package {}",
                shell_word(&format!("{name}={}", folder.display()))
            )
        })
        .collect();
    let is_beside = out == args.file.with_extension("srdf");
    let srdf = if is_beside {
        String::new()
    } else {
        format!(" --srdf {}", quote_path(out))
    };
    let check = format!("wisch robot check {file}{srdf}{packages}");
    if !is_beside {
        let beside = args.file.with_extension("srdf");
        return format!(
            "next: {check}, then move the SRDF to {}, where wisch finds it\n",
            beside.display()
        );
    }
    let settings = args.settings.iter();
    let settings: String = settings
        .map(|(key, value)| format!(" --set {}", shell_word(&format!("{key}={value}"))))
        .collect();
    let [driven, fixed] = FIRST_TASKS;
    let (held, _) = held_posture(robot);
    let is_on_table = matches!(find_table(robot, &proposal.arms, &held), Ok(Some(_)));
    let task = match &args.task {
        Some(task) => quote_path(task),
        None if is_mobile(robot, &proposal.arms) => driven.to_owned(),
        None if is_on_table && !proposal.assumed.hangs => fixed.to_owned(),
        None => {
            let place = if proposal.assumed.hangs {
                "above"
            } else {
                "in front of"
            };
            return format!(
                "next: {check}, then put it {place} the surface of a task with position_m in its [robot] table\n"
            );
        }
    };
    format!("next: {check}, then wisch follow {task} --robot {file}{packages}{settings}\n")
}

/// Writes a path as one word of a shell.
fn quote_path(path: &Path) -> String {
    shell_word(&path.display().to_string())
}
