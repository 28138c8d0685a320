//! The execution of one motion: its goals, its samples, and the supervision of the robot.

mod hold;
mod pause;
mod press;

use super::Driver;
use super::checks::REST;
use crate::connection::Connection;
use crate::goals::{GoalRequest, GoalSender, TrajectoryAction};
use crate::guard::LONGEST_SILENCE;
use crate::jumps::JumpWatch;
use crate::motion::{Part, WipingMotion, goal_bytes};
use crate::pace::GoalPace;
use crate::protocol::{Incoming, Kind, MotionEnding, Outgoing, Request};
use crate::readings::{JointReading, ProgressReading, WrenchReading};
use crate::wrench_quality::assess_wrench;
use nalgebra::Vector3;
use ros2_client::action_msgs::{GoalId, GoalStatusEnum};
use serde_json::{Value, json};
use std::time::{Duration, Instant};
use wisch::interpret::WrenchQuality;

/// Longest wait for a joint state before readings are checked again.
const TURN: Duration = Duration::from_millis(5);
/// Shortest time between two samples to wisch [s].
const SAMPLE_PERIOD_S: f64 = 0.004;
/// Longest wait for an answer of an action or service.
const ANSWER: Duration = Duration::from_secs(2);
/// How long the robot must rest before it is tared, and the longest wait for rest.
const SETTLE: Duration = Duration::from_millis(300);
const SETTLE_TIMEOUT: Duration = Duration::from_secs(3);
/// Least force along the normal that counts as contact while the tool is lowered [N].
const TOUCH_N: f64 = 3.0;
/// Time without progress on the trajectory that ends a motion [s].
const STALL_S: f64 = 5.0;
/// Largest difference between the robot's clock and this computer's since the start of a motion [s].
const CLOCK_DRIFT_S: f64 = 0.5;
/// Allowance when a controller's time is matched to the present goal: share, and time [s].
const PROGRESS_ALLOWANCE: [f64; 2] = [1.3, 0.3];
/// Time before the end of a part that still counts as of its last phase [s].
const PHASE_EDGE_S: f64 = 1e-4;
/// Longest time between the stamps of a state and of a controller's time, from which the time of the state is computed [s].
const MOST_APART_S: f64 = 0.1;
/// Largest distance of a joint from the start of a later goal of a motion [rad or m]: it fades within half a second.
const MOST_OFFSET: f64 = 0.1;

/// A goal that the robot executes.
struct ActiveGoal {
    id: GoalId,
    sent: Instant,
    /// The request to accept it.
    request: GoalRequest,
    is_accepted: bool,
    /// Whether it was cancelled: its time no longer passes.
    is_ending: bool,
    /// Where on the trajectory it began, and how fast it goes.
    pace: GoalPace,
    /// End of its part, as planned [s].
    end: f64,
    /// Time of the controller since it began [s].
    since: f64,
    /// Distance of the robot from the trajectory at the beginning [rad or m].
    offset: Vec<f64>,
    is_wipe: bool,
}

/// The execution of one motion.
pub(super) struct MotionRun<'a> {
    driver: &'a Driver,
    robot: &'a Connection,
    motion: &'a WipingMotion,
    incoming: &'a Incoming,
    outgoing: &'a Outgoing,
    /// Stamp and arrival of the joint state at the beginning.
    began: (f64, Instant),
    /// The latest joint state, and time of the latest sample [s].
    latest: JointReading,
    sample_time: f64,
    jumps: JumpWatch,
    /// Force of the surroundings on the tool in the axes of the world, less the tare [N].
    force: Vector3<f64>,
    bias: Vector3<f64>,
    quality: WrenchQuality,
    /// Whether there is a tare, and whether it is of this motion.
    is_tared: bool,
    is_tared_anew: bool,
    is_pressing: bool,
    /// Whether the operator wants the motion to pause.
    wants_pause: bool,
    goal: Option<ActiveGoal>,
    /// Time on the trajectory, as planned [s].
    trajectory_time: f64,
    /// Whether the controller reports that time for the latest state.
    is_time_reported: bool,
    /// Share of the commanded speed at which the controller runs.
    scaling: f64,
    /// The time at which the motion last progressed on the trajectory [s], and when.
    progressed: (f64, Instant),
    turned: Instant,
    /// Time of the latest supervision.
    supervised: Instant,
}

/// A result, or the ending of the motion.
type MotionResult<T> = Result<T, MotionEnding>;

fn stop<T>(kind: Kind, reason: impl Into<String>) -> MotionResult<T> {
    Err(MotionEnding::Stop(kind, reason.into()))
}

impl<'a> MotionRun<'a> {
    /// Begins a motion; nothing moves yet.
    ///
    /// # Errors
    /// If the robot has sent no state.
    pub fn begin(
        driver: &'a Driver,
        motion: &'a WipingMotion,
        incoming: &'a Incoming,
        outgoing: &'a Outgoing,
    ) -> Result<Self, String> {
        let robot = &driver.connection;
        let latest = robot.readings.lock().joints.clone();
        let latest = latest.ok_or("the robot has sent no state")?;
        let now = Instant::now();
        Ok(Self {
            driver,
            robot,
            motion,
            incoming,
            outgoing,
            began: (latest.stamp, latest.arrival),
            latest,
            sample_time: -1.0,
            jumps: JumpWatch::new(robot.frames.velocity_limits(), robot.frames.units()),
            force: Vector3::zeros(),
            bias: driver.tare.get().unwrap_or_default(),
            quality: WrenchQuality::Untared,
            is_tared: driver.tare.get().is_some(),
            is_tared_anew: false,
            is_pressing: false,
            wants_pause: false,
            goal: None,
            trajectory_time: 0.0,
            is_time_reported: false,
            scaling: 1.0,
            progressed: (0.0, now),
            turned: now,
            supervised: now,
        })
    }

    /// Executes all parts. After any other ending than complete, the robot has been commanded to hold. Returns whether the
    /// robot has confirmed that it rests, too; if it has not, the link counts as lost, so that wisch does not go on.
    pub fn follow(&mut self, parts: &[Part]) -> (MotionEnding, bool) {
        let followed = parts.iter().try_for_each(|part| self.follow_part(part));
        let Err(ending) = followed.and_then(|()| self.settle()) else {
            return (MotionEnding::Complete, true);
        };
        let Err(missing) = self.hold() else {
            return (ending, true);
        };
        let reason = match ending {
            MotionEnding::Deserted => return (MotionEnding::Deserted, false),
            MotionEnding::Stop(_, reason) => reason,
            MotionEnding::Stopped | MotionEnding::Complete => "stopped on request".to_owned(),
        };
        let reason = format!("{reason}; the robot has not confirmed that it rests: {missing}");
        (MotionEnding::Stop(Kind::LinkLost, reason), false)
    }

    /// The content of `done`.
    pub fn finish(self, ending: &MotionEnding) -> Value {
        if let Some(remark) = self.jumps.remark_on_further_jumps() {
            eprintln!("wisch-ros2: {remark}");
        }
        let time = self.sample_time.max(0.0);
        json!({
            "duration_s": time,
            "ending": ending.to_json(time),
            "positions": self.latest.positions,
        })
    }

    /// Executes one part: tares, presses, sends the goal, and waits for its end. After a pause, another goal executes the rest.
    fn follow_part(&mut self, part: &Part) -> MotionResult<()> {
        let is_in_air = self.driver.options.is_in_air;
        self.pause_if_wanted()?;
        if part.is_tared && !is_in_air && self.robot.file.force.topic.is_some() {
            self.tare()?;
        }
        if part.is_wipe && !is_in_air && self.motion.head.gap_m.is_none() {
            self.start_pressing()?;
        }
        let begin = self.motion.knots[part.knots[0]].time;
        let mut pace = GoalPace::from_rest(begin, self.driver.options.speed);
        self.pause_if_wanted()?;
        while !self.follow_goal(part, pace)? {
            self.pause_if_wanted()?;
            self.settle_for(Duration::ZERO)?;
            if self.has_touched(part) {
                break;
            }
            pace = self.resumed_pace(part);
        }
        self.trajectory_time = self.end_of(part);
        self.stop_pressing()
    }

    /// Sends a goal and waits for its end. Returns whether the part has ended; otherwise a pause is wanted.
    fn follow_goal(&mut self, part: &Part, pace: GoalPace) -> MotionResult<bool> {
        let id = self.send_goal(part, pace)?;
        let sent = self.robot.action.request_result(id);
        let request = match sent {
            Ok(request) => request,
            Err(error) => return stop(Kind::LinkLost, format!("the action: {error}")),
        };
        let status = |action: &TrajectoryAction| {
            let result = action.receive_result(request).ok().flatten();
            result.map(|(status, _)| status)
        };
        loop {
            self.supervise_once()?;
            let action = &self.robot.action;
            match action.receive_result(request) {
                Ok(Some((GoalStatusEnum::Succeeded, _))) => break,
                Ok(Some((status, result))) => {
                    self.goal = None;
                    return stop(
                        ended_kind(status, result.error_code),
                        format!(
                            "the controller ended the goal as {status:?}, error code {}: {}",
                            result.error_code, result.error_string
                        ),
                    );
                }
                Ok(None) => {}
                Err(error) => return stop(Kind::LinkLost, format!("the action: {error}")),
            }
            self.check_progress()?;
            if self.wants_pause {
                return self.cancel_for_pause(id, status);
            }
            if self.has_touched(part) {
                let _ = self.robot.action.cancel_goal(id);
                self.wait("the end of a canceled goal", ANSWER, |run| {
                    status(&run.robot.action)
                })?;
                self.goal = None;
                self.settle_briefly()?;
                break;
            }
        }
        self.goal = None;
        Ok(true)
    }

    /// Sends the goal of a part, or of its rest, and waits until the controller has accepted it.
    fn send_goal(&mut self, part: &Part, pace: GoalPace) -> MotionResult<GoalId> {
        // Every goal begins at rest. A stop that came during the checks is not overtaken by a goal.
        self.settle_for(Duration::ZERO)?;
        let file = &self.robot.file;
        let first = self.motion.positions_at(pace.from);
        let positions = self.latest.positions.clone();
        self.check_offset(&first)?;
        let goal = self.motion.goal(
            part,
            &pace,
            &positions,
            &self.robot.names,
            file.motion.path_tolerance_rad,
        );
        let (bytes, limit) = (goal_bytes(&goal), file.motion.most_bytes);
        if bytes > limit {
            // Only the ramp after a pause adds points to a goal that was accepted.
            return stop(
                Kind::Operator,
                format!(
                    "after a pause, a goal has {bytes} bytes, more than motion.most_bytes = {limit}"
                ),
            );
        }
        let (request, id) = match self.robot.goals.send(&self.robot.action, goal) {
            Ok(sent) => sent,
            Err(error) => return stop(Kind::LinkLost, format!("the goal is not sent: {error}")),
        };
        let offset = positions.iter().zip(&first);
        let now = Instant::now();
        self.goal = Some(ActiveGoal {
            id,
            sent: now,
            request,
            is_accepted: false,
            is_ending: false,
            pace,
            end: self.end_of(part),
            since: 0.0,
            offset: offset
                .map(|(measured, planned)| measured - planned)
                .collect(),
            is_wipe: part.is_wipe,
        });
        self.trajectory_time = pace.from;
        self.is_time_reported = false;
        self.progressed = (pace.from, now);
        let answer = self.wait("the answer to a goal", ANSWER, |run| {
            GoalSender::answer(&run.robot.action, request)
        })?;
        if answer.accepted {
            if let Some(goal) = &mut self.goal {
                goal.is_accepted = true;
            }
            return Ok(id);
        }
        self.goal = None;
        stop(
            Kind::ProtectiveStop,
            "the controller rejects the goal; its log says why",
        )
    }

    /// Checks how far joints and tool are from the start of a goal: a goal fades this distance within half a second.
    fn check_offset(&self, planned: &[f64]) -> MotionResult<()> {
        let limit = MOST_OFFSET.max(self.robot.file.limits.start_rad);
        let joints = planned.iter().zip(&self.latest.positions);
        for (name, (planned, measured)) in self.robot.names.iter().zip(joints) {
            let distance = (measured - planned).abs();
            if distance > limit {
                return stop(
                    Kind::Tolerance,
                    format!(
                        "joint {name:?} is {distance:.3} rad from the start of the next goal, more than {limit} rad"
                    ),
                );
            }
        }
        let planned = self.driver.tool_at(self.motion, planned);
        let measured = self.driver.tool_at(self.motion, &self.latest.positions);
        let (Some(planned), Some(measured)) = (planned, measured) else {
            return Ok(());
        };
        let limits = &self.robot.file.limits;
        let (distance, limit) = (
            (measured - planned).norm(),
            limits.lag_m.max(limits.depth_m),
        );
        if distance > limit {
            return stop(
                Kind::Tolerance,
                format!(
                    "the tool is {distance:.3} m from the start of the next goal, more than the greater of limits.lag_m and limits.depth_m, {limit} m"
                ),
            );
        }
        Ok(())
    }

    /// Time at the end of a part, as planned [s]. What follows a stroke counts as lifting, and what precedes one, such as
    /// pressing, as lowering.
    fn end_of(&self, part: &Part) -> f64 {
        let end = self.motion.knots[part.knots[1]].time;
        if part.is_wipe || end >= self.motion.duration() {
            end
        } else {
            end - PHASE_EDGE_S
        }
    }

    /// Waits for one joint state or a few milliseconds: passes the sample on, and checks everything.
    fn supervise_once(&mut self) -> MotionResult<()> {
        if let Some(request) = self.incoming.poll() {
            match request {
                Request::Stop => return Err(MotionEnding::Stopped),
                Request::Pause => self.wants_pause = true,
                Request::Resume => self.wants_pause = false,
                Request::End => return Err(MotionEnding::Deserted),
                _ => return stop(Kind::LinkLost, "wisch sent an unexpected message"),
            }
        }
        let (joints, wrench, reason, progress, scaling, publishers) = {
            let readings = self.robot.readings.wait(TURN);
            (
                readings.joints.clone(),
                readings.wrench.clone(),
                self.robot.stop_reason(&readings),
                readings.progress,
                readings.scaling.map_or(1.0, |(_, scaling)| scaling),
                readings.publisher_count(),
            )
        };
        self.supervise()?;
        if let Some((kind, reason)) = reason {
            return stop(kind, reason);
        }
        if publishers > 1 {
            let topic = &self.robot.file.motion.joint_states;
            return stop(
                Kind::LinkLost,
                format!("{publishers} publishers send joint states on {topic}"),
            );
        }
        let Some(joints) = joints else {
            return Ok(());
        };
        self.scaling = scaling;
        let is_tared = self.is_tared_anew;
        self.quality = assess_wrench(&self.robot.file, wrench.as_ref(), joints.arrival, is_tared);
        self.force = match &wrench {
            Some(wrench) => self.force_in_world(&joints, wrench)?,
            None => Vector3::zeros(),
        };
        if joints.number != self.latest.number {
            let states = [&self.latest, &joints];
            let force = self.is_tared.then(|| self.force.norm());
            let remark = (self.jumps).check(&self.robot.names, states, force, self.began.0);
            if let Some(remark) = remark {
                eprintln!("wisch-ros2: {remark}");
            }
            self.latest = joints;
            self.advance(progress);
            self.report()?;
            self.check_lag()?;
            self.check_depth()?;
        }
        let force = self.force.norm();
        let limit = self.robot.file.limits.force_n;
        if self.is_tared && force > limit {
            return stop(
                Kind::Overload,
                format!(
                    "the force on the tool is {force:.1} N, more than limits.force_n = {limit} N"
                ),
            );
        }
        Ok(())
    }

    /// Tells the guard that this program runs, and ends a motion that was without supervision.
    fn supervise(&mut self) -> MotionResult<()> {
        let gap = self.supervised.elapsed();
        self.supervised = Instant::now();
        if gap > LONGEST_SILENCE {
            let (gap, limit) = (gap.as_secs_f64(), LONGEST_SILENCE.as_secs_f64());
            return stop(
                Kind::LinkLost,
                format!("wisch-ros2 did not run for {gap:.1} s; the limit is {limit} s"),
            );
        }
        self.driver
            .guard
            .beat()
            .or_else(|text| stop(Kind::LinkLost, text))
    }

    /// Turns until `poll` returns a value.
    fn wait<T>(
        &mut self,
        what: &str,
        limit: Duration,
        mut poll: impl FnMut(&mut Self) -> Option<T>,
    ) -> MotionResult<T> {
        let deadline = Instant::now() + limit;
        loop {
            self.supervise_once()?;
            if let Some(value) = poll(self) {
                return Ok(value);
            }
            if Instant::now() >= deadline {
                let seconds = limit.as_secs_f64();
                return stop(
                    Kind::LinkLost,
                    format!("{what} has not arrived within {seconds} s"),
                );
            }
        }
    }

    /// Updates the time on the trajectory from the controller's, or else from the speed scaling.
    fn advance(&mut self, progress: Option<ProgressReading>) {
        let now = Instant::now();
        let elapsed = now.duration_since(self.turned).as_secs_f64();
        self.turned = now;
        let Some(goal) = &mut self.goal else {
            return;
        };
        // A time of the previous goal is later than the present one can be.
        let since = now.duration_since(goal.sent).as_secs_f64();
        let most = PROGRESS_ALLOWANCE[0] * since + PROGRESS_ALLOWANCE[1];
        let reported = progress
            .filter(|progress| progress.arrival > goal.sent && progress.time <= most)
            .map(|progress| (progress, self.latest.stamp - progress.stamp))
            .filter(|(_, apart)| apart.abs() <= MOST_APART_S);
        let is_reported = reported.is_some();
        match reported {
            // The time of the latest state, by the stamps of both.
            Some((progress, apart)) => {
                goal.since = goal.since.max(progress.time + apart * self.scaling);
            }
            None if self.robot.file.motion.progress.is_none() && !goal.is_ending => {
                goal.since += elapsed * self.scaling;
            }
            None => {}
        }
        let [time, ..] = goal.pace.evaluate(goal.since);
        let time = time.min(goal.end).max(self.trajectory_time);
        (self.trajectory_time, self.is_time_reported) = (time, is_reported);
        if self.trajectory_time > self.progressed.0 + 1e-3 {
            self.progressed = (self.trajectory_time, now);
        }
    }

    /// Ends a motion that makes no progress.
    fn check_progress(&self) -> MotionResult<()> {
        let (time, last) = self.progressed;
        let stalled = last.elapsed().as_secs_f64();
        if stalled > STALL_S {
            return stop(
                Kind::Tolerance,
                format!(
                    "the motion has made no progress for {stalled:.1} s, at {time:.1} s of {:.1} s",
                    self.motion.duration()
                ),
            );
        }
        Ok(())
    }

    /// The force of the surroundings on the tool in the axes of the world, less the tare [N].
    fn force_in_world(
        &self,
        joints: &JointReading,
        wrench: &WrenchReading,
    ) -> MotionResult<Vector3<f64>> {
        let frames = &self.robot.frames;
        let name = self.robot.file.force.link.as_ref().unwrap_or(&wrench.frame);
        let link = frames.link(name);
        let root_from_link = link.and_then(|link| frames.root_from_link(&joints.positions, link));
        let Some(root_from_link) = root_from_link else {
            return stop(
                Kind::LinkLost,
                format!("the wrench has frame {name:?}, which is no link of the URDF"),
            );
        };
        let world_from_link = self.motion.world_from_root.rotation * root_from_link.rotation;
        let measured = world_from_link * Vector3::from(wrench.force);
        Ok(measured * self.driver.sign - self.bias)
    }

    /// Passes the latest state to wisch as a sample.
    fn report(&mut self) -> MotionResult<()> {
        let (stamp, arrival) = self.began;
        let time = self.latest.stamp - stamp;
        let elapsed = self
            .latest
            .arrival
            .saturating_duration_since(arrival)
            .as_secs_f64();
        if (time - elapsed).abs() > CLOCK_DRIFT_S {
            return stop(
                Kind::LinkLost,
                format!(
                    "the robot's clock says {time:.2} s since the start, this computer's {elapsed:.2} s; the limit is {CLOCK_DRIFT_S} s"
                ),
            );
        }
        if time - self.sample_time < SAMPLE_PERIOD_S || time < 0.0 {
            return Ok(());
        }
        self.sample_time = time;
        let latest = &self.latest;
        let mut sample = json!({
            "time_s": time,
            "positions": latest.positions,
            "velocities": latest.velocities,
            "efforts": latest.efforts,
            "force_n": [self.force.x, self.force.y, self.force.z],
            "wrench_quality": self.quality.as_str(),
        });
        if latest.stamp > 0.0 {
            sample["stamp_ns"] = json!((latest.stamp * 1e9) as u64);
        }
        // Without the controller's time, wisch estimates the time on the trajectory from the positions.
        let is_known = self.goal.is_none() || self.is_time_reported;
        if self.robot.file.motion.progress.is_some() && is_known {
            sample["trajectory_time_s"] = json!(self.trajectory_time);
        }
        if self.outgoing.say(&json!({"sample": sample})) {
            return Ok(());
        }
        stop(Kind::LinkLost, "wisch does not read the samples")
    }

    /// Checks how far the tool is from its setpoint; while it wipes, along the surface only.
    fn check_lag(&self) -> MotionResult<()> {
        let Some(goal) = self.goal.as_ref().filter(|_| self.is_time_reported) else {
            return Ok(());
        };
        let pace = (&goal.pace, goal.end);
        let (time, since) = (self.trajectory_time, goal.since);
        let planned = (self.motion).faded_positions(time, since, pace, &goal.offset);
        let setpoint = self.driver.tool_at(self.motion, &planned);
        let measured = self.driver.tool_at(self.motion, &self.latest.positions);
        let (Some(setpoint), Some(measured)) = (setpoint, measured) else {
            return Ok(());
        };
        let mut lag = measured - setpoint;
        if goal.is_wipe {
            let normal = self.motion.normal();
            lag -= normal * lag.dot(&normal);
        }
        let (distance, limit) = (lag.norm(), self.robot.file.limits.lag_m);
        if distance > limit {
            return stop(
                Kind::Tolerance,
                format!(
                    "the tool is {distance:.3} m from its setpoint, more than limits.lag_m = {limit} m"
                ),
            );
        }
        Ok(())
    }

    /// Checks how far the tool is from the believed surface, along its normal, while the robot may press. Without a surface,
    /// force mode would move on without end.
    fn check_depth(&self) -> MotionResult<()> {
        if !self.is_pressing {
            return Ok(());
        }
        let tool = self.driver.tool_at(self.motion, &self.latest.positions);
        let origin = self.motion.world_from_surface.translation.vector;
        let height = tool.map_or(0.0, |tool| (tool - origin).dot(&self.motion.normal()));
        let limit = self.robot.file.limits.depth_m;
        if height.abs() > limit {
            return stop(
                Kind::Tolerance,
                format!(
                    "the pressing tool is {height:.3} m above the believed surface, more than limits.depth_m = {limit} m from it"
                ),
            );
        }
        Ok(())
    }

    /// Whether the tool that is lowered has touched the surface.
    fn has_touched(&self, part: &Part) -> bool {
        let Some(lowers_from) = part.lowers_from.filter(|_| self.is_tared) else {
            return false;
        };
        let head = &self.motion.head;
        let limit = (head.press_force_n / 2.0).max(TOUCH_N);
        head.gap_m.is_none()
            && !self.driver.options.is_in_air
            && self.trajectory_time >= lowers_from
            && self.force.dot(&self.motion.normal()) > limit
    }

    /// Waits until all joints have rested for a while.
    fn settle(&mut self) -> MotionResult<()> {
        self.settle_for(SETTLE)
    }

    fn settle_briefly(&mut self) -> MotionResult<()> {
        self.settle_for(SETTLE / 3)
    }

    /// Velocity of the fastest joint in the last state, and the unit of its positions; zero if the state has no velocities.
    fn fastest_joint(&self) -> (f64, &'static str) {
        let speeds = self.latest.velocities.iter().map(|v| v.abs());
        let speeds = speeds.zip(self.robot.frames.units());
        let fastest = speeds.max_by(|a, b| a.0.total_cmp(&b.0));
        fastest.unwrap_or((0.0, "rad"))
    }

    fn settle_for(&mut self, rest: Duration) -> MotionResult<()> {
        let begin = Instant::now();
        let mut since = begin;
        loop {
            self.supervise_once()?;
            let (speed, unit) = self.fastest_joint();
            if speed > REST {
                since = Instant::now();
            }
            if speed <= REST && since.elapsed() >= rest {
                return Ok(());
            }
            if begin.elapsed() > SETTLE_TIMEOUT {
                let seconds = SETTLE_TIMEOUT.as_secs();
                return stop(
                    Kind::Tolerance,
                    format!(
                        "a joint still moves at {speed:.3} {unit}/s after {seconds} s without a goal; the limit is {REST} {unit}/s"
                    ),
                );
            }
        }
    }
}

/// Kind of the stop if a controller ends a goal that nobody here has canceled.
const fn ended_kind(status: GoalStatusEnum, error_code: i32) -> Kind {
    match (status, error_code) {
        (GoalStatusEnum::Canceled, _) => Kind::Operator,
        // Path and goal tolerance.
        (_, -4 | -5) => Kind::Tolerance,
        _ => Kind::ProtectiveStop,
    }
}
