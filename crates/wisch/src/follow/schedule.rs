//! Timing of one motion: the fastest along its path that keeps the tool on its line and in both hands.
//!
//! The audit (`audit/`) checks the result with code of its own; neither may use the code of the other.

use super::workcell::second_arm::off_grip;
use super::{
    FollowConfig, FollowError, GripDeviation, JointPath, LineDeviation, Phase, TimingConfig,
    ToolPose, Trajectory, Workcell, time_path,
};
use crate::geometry::{Pose, Vector3};
use crate::represent::Task;
use crate::robot::{Articulation, ArticulationState, JointKind};

/// Largest deviation of a joint from its path in free motion [rad or m]; small against the clearance.
const FREE_BLEND: f64 = 5e-4;
/// First deviation of a joint that is tried where the tool follows a line [rad or m].
const LINE_BLEND: f64 = 2e-4;
/// Period at which the second hand's grip is checked [s].
const GRIP_PERIOD: f64 = 0.01;
/// Period at which the tool is compared with its line [s].
const LINE_PERIOD: f64 = 0.005;
/// Gravitational acceleration in the world [m/s²].
const GRAVITY: Vector3 = Vector3::new(0.0, 0.0, -9.81);
/// Period at which efforts are checked [s].
const EFFORT_PERIOD: f64 = 0.005;
/// Time before a jump of the acceleration at which efforts are also checked [s].
const BEFORE_JUMP: f64 = 1e-9;
/// Share of the effort limits that the timing uses, because efforts between samples are not checked [1].
const EFFORT_SHARE: f64 = 0.98;
/// Smallest share of its effort limit that the weight must leave to a joint, for a slower motion to
/// be possible [1].
const LEAST_LEFT: f64 = 1e-3;
/// Step in which an arc of the line is compared [m or rad].
const LINE_STEP: f64 = 1e-3;
/// Largest distance from the tool of the points of its line that it may skip where it rounds a corner, beyond its deviation
/// [m]; larger than any permitted deviation.
const MOST_SKIPPED: f64 = 2e-3;
/// Least distance by which the tool must be nearer to a later part of its line, to which the line leads by a detour [m].
const LEAST_GAIN: f64 = 2e-4;
/// Largest step of a variable for which a limit of the tool's speed is computed [rad or m].
const MAX_STEP: f64 = 0.05;
/// Number of parts of a step over which the speed of the tool is compared.
const PARTS: usize = 4;
/// Relative excess of the tool's speed over its limit that is left as it is [1]; half of what the audit allows.
const SPEED_EXCESS: f64 = 5e-3;
/// Longest time that a joint may need for one motion at its limits [s].
pub(super) const MAX_DURATION: f64 = 1200.0;
/// Number of blends that are tried until the tool stays on its line, each half of the one before.
const BLENDS: i32 = 7;
/// Number of accelerations that are tried after that, each half of the one before.
const ACCELERATIONS: i32 = 4;
/// Share of the first blend with which they are tried [1].
const BLEND_OF_SLOWER: f64 = 0.25;

/// Returns the fastest motion along a path of all n variables; `None` if nothing moves.
pub(super) fn time_motion(
    cell: &Workcell,
    task: &Task,
    config: &FollowConfig,
    phase: Phase,
    path: &[Vec<f64>],
    tool_line: &[ToolPose],
) -> Result<Option<Trajectory>, FollowError> {
    if path.len() < 2 || path.windows(2).all(|pair| pair[0] == pair[1]) {
        return Ok(None);
    }
    check_duration(cell, path)?;
    let speed = match phase {
        Phase::Wipe(_) => config.contact_speed,
        Phase::Lower => config.approach_speed.min(config.free_speed),
        Phase::Drive | Phase::FreeMotion | Phase::Lifted | Phase::Lift => config.free_speed,
    };
    // Where the tool follows a line, its steps are short.
    let divided = (speed.is_finite() && tool_line.is_empty()).then(|| divide_steps(path));
    let path = divided.as_deref().unwrap_or(path);
    let joints = JointPath::new(path)?;
    let time = |joints: &JointPath, corners: Corners| -> Result<Trajectory, FollowError> {
        let timing = TimingConfig {
            blend_tolerance: corners.blend,
            ..TimingConfig::default()
        };
        let limits = cell.limits().clone();
        let limits = limits.with_accelerations_scaled(corners.acceleration);
        let fastest = time_path(joints, &limits, &timing)?;
        let slowed = slow_to_efforts(cell, task, fastest, cell.tool_load(task, phase))?;
        Ok(slowed.with_acceleration_ramp(config.acceleration_ramp))
    };
    let ways = (speed.is_finite().then(|| measure_ways(cell, path))).transpose()?;
    let timed = |corners: Corners| -> Result<Trajectory, FollowError> {
        let Some([mean, fastest]) = &ways else {
            return time(&joints, corners);
        };
        let keeps = |ways: &[f64]| -> Result<Trajectory, FollowError> {
            let times = ways.iter().map(|way| way / speed).collect();
            time(&joints.clone().with_segment_times(times)?, corners)
        };
        let trajectory = keeps(mean)?;
        if greatest_speed(cell, &trajectory)? <= (1.0 + SPEED_EXCESS) * speed {
            return Ok(trajectory);
        }
        let trajectory = keeps(fastest)?;
        let greatest = greatest_speed(cell, &trajectory)?;
        Ok(if greatest > (1.0 + SPEED_EXCESS) * speed {
            trajectory.slow_down(greatest / speed)
        } else {
            trajectory
        })
    };
    let first = if tool_line.is_empty() {
        FREE_BLEND
    } else {
        LINE_BLEND
    };
    let mut last = None;
    for corners in Corners::tried(first) {
        let trajectory = timed(corners)?;
        let off = line_deviation(cell, task, &trajectory, tool_line)?;
        let is_on_line =
            off.position <= config.line_tolerance && off.rotation <= config.turn_tolerance;
        if is_on_line && worst_grip(cell, &trajectory)?.is_held() {
            return Ok(Some(trajectory));
        }
        last = Some(trajectory);
    }
    // The audit reports it.
    Ok(last)
}

/// How the corners of a path are passed.
#[derive(Debug, Clone, Copy)]
struct Corners {
    /// Largest deviation of a joint from its path [rad or m].
    blend: f64,
    /// Share of the joints' limits of acceleration that is used [1].
    acceleration: f64,
}

impl Corners {
    /// Returns what is tried until the tool stays on its line, the fastest first.
    ///
    /// However small the blend, a joint leaves the corner of its path by up to a T²/24 for its acceleration a, because
    /// accelerations are spread over the time T (see [`Trajectory::with_acceleration_ramp`]). Only less acceleration
    /// lessens that.
    fn tried(first: f64) -> impl Iterator<Item = Self> {
        let blends = (0..BLENDS).map(move |k| Self {
            blend: first * 0.5_f64.powi(k),
            acceleration: 1.0,
        });
        let slower = (1..=ACCELERATIONS).map(move |k| Self {
            blend: first * BLEND_OF_SLOWER,
            acceleration: 0.5_f64.powi(k),
        });
        blends.chain(slower)
    }
}

/// Divides the steps of a path until no variable moves by more than [`MAX_STEP`]. Over a longer step, the speed of the tool
/// differs from its mean.
fn divide_steps(path: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let mut divided: Vec<Vec<f64>> = path.first().cloned().into_iter().collect();
    for pair in path.windows(2) {
        let steps = pair[0].iter().zip(&pair[1]).map(|(from, to)| to - from);
        let widest = steps.fold(0.0, |widest: f64, step| widest.max(step.abs()));
        let count = (widest / MAX_STEP).ceil().max(1.0) as usize;
        divided.extend((1..count).map(|k| {
            let share = k as f64 / count as f64;
            let joints = pair[0].iter().zip(&pair[1]);
            joints
                .map(|(from, to)| from + share * (to - from))
                .collect()
        }));
        divided.push(pair[1].clone());
    }
    divided
}

/// Slows a motion down until no joint exceeds its effort limit by its weight, the robot's own inertia and the force of
/// the surface on the tool \[N\], mimic joints included. Weight and force alone beyond a limit are left to the audit to
/// report.
fn slow_to_efforts(
    cell: &Workcell,
    task: &Task,
    trajectory: Trajectory,
    load: Option<f64>,
) -> Result<Trajectory, FollowError> {
    let robot = cell.robot();
    let all = vec![true; robot.dof()];
    let articulation = Articulation::new(
        robot,
        cell.world_from_root(),
        cell.ready_posture(),
        &all,
        &[],
    )?;
    let mut state = articulation.state();
    let at_rest = vec![0.0; robot.dof()];
    // First the effort of each joint by itself, then that of each variable with all joints that it moves.
    let efforts = |state: &ArticulationState| {
        let through = state.joint_efforts();
        let mut of_variables = vec![0.0; robot.dof()];
        for (joint, effort) in articulation.joints().iter().zip(through) {
            for &(variable, factor) in &joint.terms {
                of_variables[variable] += factor * effort;
            }
        }
        (articulation.joints().iter().zip(through))
            .map(|(joint, &effort)| match joint.terms[..] {
                [(variable, _)] if robot.variables()[variable] == joint.id => {
                    of_variables[variable]
                }
                _ => effort,
            })
            .collect::<Vec<f64>>()
    };
    let limits = articulation.joints().iter();
    let limits: Vec<f64> = limits
        .map(|joint| {
            let limit = robot.joints()[joint.id.index()].limits.effort;
            limit.filter(|limit| *limit > 0.0).unwrap_or(f64::INFINITY)
        })
        .collect();
    let mut square = 1.0_f64;
    for time in effort_times(&trajectory) {
        let sample = trajectory.sample(time);
        articulation.locate(&mut state, &sample.q);
        articulation.inverse_dynamics(&mut state, &at_rest, &at_rest, GRAVITY);
        let carrying = efforts(&state);
        articulation.inverse_dynamics(&mut state, &sample.qd, &sample.qdd, GRAVITY);
        let moving: Vec<f64> = (efforts(&state).iter().zip(&carrying))
            .map(|(whole, carrying)| whole - carrying)
            .collect();
        // Contact may begin late or be lost, so the efforts without it count as well.
        let mut held = vec![carrying.clone()];
        if let Some(force) = load {
            let pressing = press_efforts(cell, task, &sample.q, force)?;
            let joints = articulation.joints().iter();
            let pressing = joints.map(|joint| pressing[joint.id.index()]);
            held.push(carrying.iter().zip(pressing).map(|(a, b)| a + b).collect());
        }
        for held in &held {
            for ((moving, held), limit) in moving.iter().zip(held).zip(&limits) {
                // The effort left in the direction of the motion.
                let left = EFFORT_SHARE * limit - held * moving.signum();
                if left > LEAST_LEFT * limit && left.is_finite() {
                    // Slower by a factor s, the efforts of the motion shrink by s²; s² is the largest ratio needed.
                    square = square.max(moving.abs() / left);
                }
            }
        }
    }
    Ok(if square > 1.0 {
        trajectory.slow_down(square.sqrt())
    } else {
        trajectory
    })
}

/// Returns the effort by which each joint holds its tool against the force of the surface, in the order of the robot's
/// joints \[Nm or N\]: −Jᵀ F, where a joint that moves others has their efforts too.
fn press_efforts(
    cell: &Workcell,
    task: &Task,
    q: &[f64],
    force: f64,
) -> Result<Vec<f64>, FollowError> {
    let robot = cell.robot();
    let kinematics = robot.forward_kinematics(q)?;
    let root_from_tool = kinematics.world_from_link(cell.tip()) * cell.tip_from_tool();
    let place = root_from_tool.translation.vector;
    let reaction = cell.normal_at(task, place) * force;
    let mut through = vec![0.0; robot.joints().len()];
    for (i, joint) in robot.joints().iter().enumerate() {
        let is_above = robot
            .joints_above(cell.tip())
            .any(|other| other.child == joint.child);
        if is_above {
            let root_from_joint = kinematics.world_from_link(joint.child);
            let axis = root_from_joint.rotation * joint.axis.into_inner();
            through[i] = -match joint.kind {
                JointKind::Fixed => 0.0,
                JointKind::Revolute => {
                    let arm = place - root_from_joint.translation.vector;
                    axis.dot(&arm.cross(&reaction))
                }
                JointKind::Prismatic => axis.dot(&reaction),
            };
        }
    }
    let mut of_variables = vec![0.0; robot.dof()];
    for (joint, effort) in robot.joints().iter().zip(&through) {
        for &(variable, factor) in &joint.drive.terms {
            of_variables[variable] += factor * effort;
        }
    }
    for (variable, id) in robot.variables().iter().enumerate() {
        through[id.index()] = of_variables[variable];
    }
    Ok(through)
}

/// Returns the times at which efforts are checked: periodic, and on both sides of every jump of the
/// acceleration [s].
fn effort_times(trajectory: &Trajectory) -> impl Iterator<Item = f64> {
    let count = (trajectory.duration() / EFFORT_PERIOD).ceil() as usize;
    let often = (0..count).map(|k| k as f64 * EFFORT_PERIOD);
    let jumps = trajectory.switch_times();
    often.chain(jumps.flat_map(|time| [time - BEFORE_JUMP, time]))
}

/// Returns the largest deviation of the second hand from its grip over a motion; zero if one hand holds the
/// tool.
fn worst_grip(cell: &Workcell, trajectory: &Trajectory) -> Result<GripDeviation, FollowError> {
    let mut worst = GripDeviation::default();
    let Some(second) = cell.second_arm() else {
        return Ok(worst);
    };
    for sample in trajectory.samples(GRIP_PERIOD) {
        let kinematics = cell.robot().forward_kinematics(&sample.q)?;
        let root_from_tool = kinematics.world_from_link(cell.tip()) * cell.tip_from_tool();
        let hand = second.chain().tip();
        let root_from_hand = kinematics.world_from_link(hand) * second.tip_from_hand();
        worst = worst.max(off_grip(second.grip(), &root_from_tool, &root_from_hand));
    }
    Ok(worst)
}

/// Returns the place of the tool centre point in the root frame [m].
fn locate_tool(cell: &Workcell, q: &[f64]) -> Result<Vector3, FollowError> {
    let kinematics = cell.robot().forward_kinematics(q)?;
    let root_from_tool = kinematics.world_from_link(cell.tip()) * cell.tip_from_tool();
    Ok(root_from_tool.translation.vector)
}

/// Returns the distance of the tool from each configuration to the next [m], and the path length
/// that the tool would cover in the same time at its greatest speed [m]: while the joints move
/// evenly, the tool may not.
fn measure_ways(cell: &Workcell, path: &[Vec<f64>]) -> Result<[Vec<f64>; 2], FollowError> {
    let (mut mean, mut fastest) = (Vec::new(), Vec::new());
    for pair in path.windows(2) {
        let [begin, end] = [locate_tool(cell, &pair[0])?, locate_tool(cell, &pair[1])?];
        let (mut before, mut longest) = (begin, 0.0_f64);
        for k in 1..=PARTS {
            let share = k as f64 / PARTS as f64;
            let joints = pair[0].iter().zip(&pair[1]);
            let q: Vec<f64> = joints
                .map(|(from, to)| from + share * (to - from))
                .collect();
            let place = locate_tool(cell, &q)?;
            longest = longest.max((place - before).norm());
            before = place;
        }
        mean.push((end - begin).norm());
        fastest.push((PARTS as f64 * longest).max((end - begin).norm()));
    }
    Ok([mean, fastest])
}

/// Returns the greatest speed of the tool over a motion [m/s].
fn greatest_speed(cell: &Workcell, trajectory: &Trajectory) -> Result<f64, FollowError> {
    let mut greatest = 0.0_f64;
    let mut before: Option<Vector3> = None;
    for sample in trajectory.samples(LINE_PERIOD) {
        let place = locate_tool(cell, &sample.q)?;
        let step = before.map_or(0.0, |before| (place - before).norm());
        greatest = greatest.max(step / LINE_PERIOD);
        before = Some(place);
    }
    Ok(greatest)
}

/// Checks that no joint needs longer for a path than [`MAX_DURATION`], at its limits of velocity and acceleration.
fn check_duration(cell: &Workcell, path: &[Vec<f64>]) -> Result<(), FollowError> {
    for (i, joint) in cell.limits().joints().iter().enumerate() {
        let travel: f64 = path
            .windows(2)
            .map(|pair| (pair[1][i] - pair[0][i]).abs())
            .sum();
        let [low, high] = path
            .iter()
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], q| {
                [low.min(q[i]), high.max(q[i])]
            });
        let unit = cell.robot().variable(i).kind.unit();
        // From rest to rest over a distance d with the acceleration a takes at least 2 √(d / a).
        for (quantity, limit, per, duration) in [
            ("velocity", joint.velocity, "s", travel / joint.velocity),
            (
                "acceleration",
                joint.acceleration,
                "s2",
                2.0 * ((high - low) / joint.acceleration).sqrt(),
            ),
        ] {
            if duration > MAX_DURATION {
                return Err(FollowError::TooSlow {
                    joint: joint.name.clone(),
                    quantity,
                    limit,
                    unit: format!("{unit}/{per}"),
                    duration,
                });
            }
        }
    }
    Ok(())
}

/// Returns the largest deviation of the tool from its line over a motion; zero if it follows none.
///
/// The tool is compared with the nearest point of the line that lies no earlier than the last one. At the start
/// and the end of the motion it is compared with those of the line.
fn line_deviation(
    cell: &Workcell,
    task: &Task,
    trajectory: &Trajectory,
    corners: &[ToolPose],
) -> Result<LineDeviation, FollowError> {
    let mut deviation = LineDeviation::default();
    if corners.len() < 2 {
        return Ok(deviation);
    }
    let line = Line::new(task, corners);
    let mut passed = PassedCorners::new(&line);
    let mut at = 0;
    let mut add = |off: LineDeviation| {
        deviation.position = deviation.position.max(off.position);
        deviation.rotation = deviation.rotation.max(off.rotation);
    };
    let mut last = None;
    for sample in trajectory.samples(LINE_PERIOD) {
        let kinematics = cell.robot().forward_kinematics(&sample.q)?;
        let world_from_tool =
            cell.world_from_root() * kinematics.world_from_link(cell.tip()) * cell.tip_from_tool();
        if last.is_none() {
            add(between(&line.poses[0], &line.poses[0], &world_from_tool));
        }
        add(line.deviation(&mut at, &world_from_tool));
        passed.note(
            &line,
            at,
            [last.as_ref().unwrap_or(&world_from_tool), &world_from_tool],
        );
        last = Some(world_from_tool);
    }
    passed.nearest.iter().for_each(|off| add(*off));
    if let (Some(tool), Some(end)) = (last, line.poses.last()) {
        add(between(end, end, &tool));
    }
    Ok(deviation)
}

/// How near the tool passes each corner of its line. Where an acute corner is rounded, the tool may stay near both sides
/// and far from the corner.
struct PassedCorners {
    nearest: Vec<LineDeviation>,
}

impl PassedCorners {
    /// Along the line, the tool is near a corner within this many steps of it.
    const AROUND: usize = 60;

    fn new(line: &Line) -> Self {
        let far = LineDeviation {
            position: f64::INFINITY,
            rotation: f64::INFINITY,
        };
        Self {
            nearest: vec![far; line.corners.len()],
        }
    }

    /// Notes that the tool has moved straight between two poses, the later of which is at index `at` of the line.
    fn note(&mut self, line: &Line, at: usize, [before, tool]: [&Pose; 2]) {
        for (&corner, nearest) in line.corners.iter().zip(&mut self.nearest) {
            if corner.abs_diff(at) <= Self::AROUND {
                let off = between(before, tool, &line.poses[corner]);
                if cost(&off) < cost(nearest) {
                    *nearest = off;
                }
            }
        }
    }
}

/// Returns a deviation as a length [m].
fn cost(off: &LineDeviation) -> f64 {
    off.position + 0.1 * off.rotation
}

/// The line of the tool, finely subdivided.
struct Line {
    poses: Vec<Pose>,
    /// Indices of the corners between the ends.
    corners: Vec<usize>,
}

impl Line {
    fn new(task: &Task, corners: &[ToolPose]) -> Self {
        let mut poses = vec![Workcell::world_from_tool(task, &corners[0])];
        let mut between = Vec::new();
        for pair in corners.windows(2) {
            let turn = (pair[1].surface_from_tool.heading - pair[0].surface_from_tool.heading)
                .abs()
                .max((pair[1].tilt - pair[0].tilt).abs());
            // A milliradian counts as a millimetre.
            let count = (pair[0].distance(&pair[1]).max(turn) / LINE_STEP)
                .ceil()
                .max(1.0) as usize;
            poses.extend((1..=count).map(|i| {
                Workcell::world_from_tool(
                    task,
                    &pair[0].interpolate(&pair[1], i as f64 / count as f64),
                )
            }));
            between.push(poses.len() - 1);
        }
        between.pop();
        Self {
            poses,
            corners: between,
        }
    }

    /// Returns the deviation of a pose from the line; searches from index `at` on, which advances.
    ///
    /// The search ends where the line leads away from the tool: a line may return to the same place later.
    fn deviation(&self, at: &mut usize, pose: &Pose) -> LineDeviation {
        let measure = |i: usize| between(&self.poses[i], &self.poses[i + 1], pose);
        let last = self.poses.len() - 2;
        let mut best = measure(*at);
        let mut has_led_away = false;
        for i in *at + 1..=last {
            let off = measure(i);
            let gain = cost(&best) - cost(&off);
            if gain > if has_led_away { LEAST_GAIN } else { 0.0 } {
                (best, *at, has_led_away) = (off, i, false);
            } else if gain < -MOST_SKIPPED {
                break;
            } else {
                has_led_away |= gain < -LEAST_GAIN;
            }
        }
        best
    }
}

/// Returns the deviation of a pose from the straight line between two others.
fn between(from: &Pose, to: &Pose, pose: &Pose) -> LineDeviation {
    let along = to.translation.vector - from.translation.vector;
    let length = along.norm_squared();
    let since = pose.translation.vector - from.translation.vector;
    let turn = from.rotation.angle_to(&to.rotation);
    let s = if length > 0.0 {
        (since.dot(&along) / length).clamp(0.0, 1.0)
    } else if turn > 0.0 {
        (from.rotation.angle_to(&pose.rotation) / turn).clamp(0.0, 1.0)
    } else {
        0.0
    };
    LineDeviation {
        position: (since - along * s).norm(),
        rotation: from
            .rotation
            .slerp(&to.rotation, s)
            .angle_to(&pose.rotation),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A stroke that begins inside a board leads to its border first, and back over the same place.
    #[test]
    fn a_line_that_returns_on_itself_is_followed_from_its_beginning() {
        let steps = (0..=14).chain((-50..14).rev());
        let poses = steps.map(|k| Pose::translation(1e-3 * f64::from(k), 0.0, 0.0));
        let line = Line {
            poses: poses.collect(),
            corners: vec![14],
        };
        let mut passed = PassedCorners::new(&line);
        let (mut at, mut last) = (0, line.poses[0]);
        let mut worst: f64 = 0.0;
        // The tool passes each point 0.02 mm beside it, and rounds the corner 0.5 mm before it.
        for k in 0..line.poses.len() {
            let mut tool = line.poses[k];
            tool.translation.x = tool.translation.x.min(0.0135);
            tool.translation.y = if k % 2 == 0 { 2e-5 } else { -2e-5 };
            worst = worst.max(line.deviation(&mut at, &tool).position);
            passed.note(&line, at, [&last, &tool]);
            last = tool;
        }
        assert!(worst < 1e-4, "{worst}");
        assert_eq!(at, line.poses.len() - 2);
        assert!(passed.nearest[0].position < 6e-4, "{:?}", passed.nearest);
    }
}
