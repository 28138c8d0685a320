//! The loop of control, simulation and telemetry.

use crate::camera::hidden_by;
use crate::grains::GrainBodies;
use crate::plant::{GRAVITY, Plant, TOOL_MASS, Wielded, firm_load};
use crate::treated::TreatedSurface;
use crate::{Dirt, GroundTruth, SimulationError, SimulationSettings, Spread};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use std::collections::VecDeque;
use std::ops::ControlFlow;
use wisch::control::{ControlCommand, ControlConfig, MotionController};
use wisch::follow::{Followed, FollowerLimit, Workcell};
use wisch::geometry::{Point3, Pose, Vector3};
use wisch::random::normal;
use wisch::represent::Task;
use wisch::robot::{Articulation, ArticulationState, Range};
use wisch::run::{Ending, Execution, MotionOrder, SampleSink, StopCause, TelemetrySample, Wrench};
use wisch_io::Push;

/// Faster than this no robot moves [rad/s or m/s].
const MAX_VELOCITY: f64 = 100.0;
/// How fast the commanded tool slides at least for its force to count as that of sliding [m/s].
const SLIDING: f64 = 0.01;
/// After the commanded speed rose above that, and after a push, this long passes before forces count [s].
const SETTLING: f64 = 0.3;
/// Streams of random numbers.
const NOISE_STREAM: u64 = 0x6e6f_6973;
const ENCODER_STREAM: u64 = 0x656e_636f;

/// Further off than this from where it is told to be, the tool is caught or led astray [m].
const MAX_ASTRAY: f64 = 0.5;
/// Faster than this over its limit a joint moves only when something is wrong [1].
const MAX_OVERSPEED: f64 = 4.0;
/// Beyond its limit by more than this a joint moves only when something is wrong [rad or m].
const MAX_OVERSHOOT: f64 = 0.1;

/// Executes a motion on some dirt.
///
/// `sink` gets what is measured, once per period, and may stop the execution. Disturbances are those that the
/// settings have for the order's round. `dirt` is where the dirt really is at the start; without grains, none is
/// simulated.
///
/// # Errors
/// If the robot has no dynamics, or the simulation comes apart.
pub fn execute(
    order: &MotionOrder<'_>,
    settings: &SimulationSettings,
    dirt: &Dirt,
    control: &ControlConfig,
    sink: &mut SampleSink<'_>,
) -> Result<(Execution, GroundTruth), SimulationError> {
    let mut simulation = Simulation::new(order, settings, dirt, control)?;
    let periods = (order.followed.duration() / control.period).ceil() as usize;
    for k in 0..=periods {
        if let Some(ending) = simulation.period(k as f64 * control.period, sink)? {
            return simulation.finish(ending);
        }
    }
    simulation.finish(Ending::Complete)
}

/// Everything that one execution needs, allocated once.
struct Simulation<'a> {
    task: &'a Task,
    cell: &'a Workcell,
    followed: &'a Followed,
    config: &'a ControlConfig,
    settings: &'a SimulationSettings,
    /// With when they begin [s].
    pushes: Vec<(f64, Push)>,
    /// Whether a hand touched the tool, and robot or tool something in the scene, in the period before.
    was_touched: bool,
    was_obstructed: bool,
    friction_changes: Vec<(f64, f64)>,
    plant: Plant,
    tool: Wielded,
    grains: GrainBodies,
    treated: Option<TreatedSurface>,
    dirt: Dirt,
    controller: MotionController,
    /// The joints as they are, where the encoders say something else.
    actual: ArticulationState,
    /// The real tool in the frame of the moving joint that carries it.
    joint_from_real_tool: Pose,
    /// The articulation's variables: as they are, and as measured.
    actual_q: Vec<f64>,
    /// Where the joints' play has left their encoders.
    dragged: Vec<f64>,
    q: Vec<f64>,
    qd: Vec<f64>,
    joint_efforts: Vec<f64>,
    /// All of the robot's variables, as measured.
    robot_q: Vec<f64>,
    robot_qd: Vec<f64>,
    robot_efforts: Vec<f64>,
    /// What was felt and is not measured yet.
    late: VecDeque<Wrench>,
    random: ChaCha8Rng,
    encoder_random: ChaCha8Rng,
    /// Index of the motion that runs.
    motion: usize,
    sliding_since: Option<f64>,
    time: f64,
    sliding_time: f64,
    lost_time: f64,
    truth: GroundTruth,
}

impl<'a> Simulation<'a> {
    fn new(
        order: &MotionOrder<'a>,
        settings: &'a SimulationSettings,
        dirt: &Dirt,
        config: &'a ControlConfig,
    ) -> Result<Self, SimulationError> {
        let MotionOrder {
            round,
            seed,
            task,
            cell,
            followed,
        } = *order;
        let robot = cell.robot();
        let controller = MotionController::new(task, cell, followed, TOOL_MASS, config)?;
        let controller = controller.ok_or_else(|| SimulationError::NothingMoves {
            robot: robot.name().to_owned(),
        })?;
        let articulation = controller.articulation();
        let start = (followed.sample(0.0)).map_or_else(|| cell.ready().to_vec(), |s| s.q);
        let q: Vec<f64> = articulation.variables().iter().map(|&i| start[i]).collect();
        let tool = Wielded::new(cell, task, &settings.tool);
        let (_, joint_from_tip) = articulation.carrier(cell.tip());
        let moving: Vec<bool> = (0..robot.dof())
            .map(|i| articulation.variables().contains(&i))
            .collect();
        let loads = [(cell.tip(), firm_load(&tool))];
        let firm = Articulation::new(robot, cell.world_from_root(), &start, &moving, &loads)?;
        let compliant = controller.own_compliant();
        let mut plant = Plant::new(cell, task, &tool, settings, &firm, compliant, &q, config)?;
        let treated = TreatedSurface::of(task, &tool, settings);
        let none = Dirt::default();
        // Places of the surface are no bodies.
        let loose = if treated.is_some() { &none } else { dirt };
        let grains = GrainBodies::new(&mut plant, loose, task, &tool, settings);
        let schedule = settings.schedule(round, followed);
        let mut friction_changes = schedule.friction_changes;
        friction_changes.reverse();
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        random.set_stream(NOISE_STREAM ^ round as u64);
        let mut encoder_random = random.clone();
        encoder_random.set_stream(ENCODER_STREAM ^ round as u64);
        Ok(Self {
            task,
            cell,
            followed,
            config,
            settings,
            pushes: schedule.pushes,
            was_touched: false,
            was_obstructed: false,
            friction_changes,
            plant,
            grains,
            treated,
            dirt: dirt.clone(),
            actual: articulation.state(),
            joint_from_real_tool: joint_from_tip * tool.tip_from_tool,
            qd: vec![0.0; q.len()],
            actual_q: q.clone(),
            dragged: q.clone(),
            q,
            joint_efforts: vec![0.0; articulation.joints().len()],
            robot_qd: vec![0.0; start.len()],
            robot_efforts: vec![0.0; start.len()],
            robot_q: start,
            late: VecDeque::new(),
            random,
            encoder_random,
            motion: 0,
            sliding_since: None,
            time: 0.0,
            sliding_time: 0.0,
            lost_time: 0.0,
            truth: GroundTruth {
                dirt: Dirt::default(),
                contact_force: Spread::default(),
                max_plane_distance: 0.0,
                max_controller_force: 0.0,
                lost_share: 0.0,
                max_lateral_error: 0.0,
                pushes: Vec::new(),
                obstructions: Vec::new(),
                hidden: Vec::new(),
            },
            tool,
            controller,
        })
    }

    /// One period: measure, command, record, let time pass.
    fn period(
        &mut self,
        time: f64,
        sample: &mut SampleSink<'_>,
    ) -> Result<Option<Ending>, SimulationError> {
        self.time = time;
        self.plant.read(&mut self.actual_q, &mut self.qd);
        self.check()?;
        self.measure_joints();
        let command = self.command(time)?;
        if let Some(cause) = self.stop_cause(&command) {
            return Ok(Some(Ending::ProtectiveStop { time, cause }));
        }
        let flow = self.record(time, &command, sample);

        // What joints that follow others will need, the planned acceleration included.
        let is_seen = self.settings.sensing.sees_joints();
        if is_seen {
            self.controller.inverse_dynamics();
        } else {
            let articulation = self.controller.articulation();
            let [_, _, qdd] = self.controller.planned_variables();
            articulation.evaluate(&mut self.actual, &self.actual_q, &self.qd, GRAVITY);
            articulation.inverse_dynamics(&mut self.actual, &self.qd, qdd, GRAVITY);
        }
        let actual = if is_seen {
            self.controller.state()
        } else {
            &self.actual
        };
        let world_from_real_tool =
            actual.pose(self.controller.carrier()) * self.joint_from_real_tool;
        self.plant.drive(
            actual,
            self.controller.own_compliant(),
            self.controller.efforts(),
            self.controller.planned_variables(),
            &mut self.joint_efforts,
        );
        let real_tool = world_from_real_tool.translation.vector.into();
        let is_pushed = self.disturb(time, &real_tool);
        self.plant.undulate();
        self.grains.act(&mut self.plant, &mut self.dirt, &self.tool);
        if let Some(treated) = &self.treated {
            let period = self.config.period;
            treated.act(&self.plant, &mut self.dirt, &self.tool, period);
        }
        self.plant.step();
        let is_obstructed = self.plant.is_obstructed();
        let was_obstructed = std::mem::replace(&mut self.was_obstructed, is_obstructed);
        let obstructed = [was_obstructed, is_obstructed];
        note(&mut self.truth.obstructions, time, obstructed);
        self.grains
            .settle(&mut self.plant, &mut self.dirt, self.task);
        self.observe_truth(&command, &world_from_real_tool, is_pushed);
        Ok(flow.is_break().then_some(Ending::Stopped))
    }

    /// What the encoders say of the joints.
    fn measure_joints(&mut self) {
        let sensing = &self.settings.sensing;
        if sensing.sees_joints() {
            self.q.copy_from_slice(&self.actual_q);
            return;
        }
        let play = sensing.backlash / 2.0;
        for ((q, dragged), actual) in self.q.iter_mut().zip(&mut self.dragged).zip(&self.actual_q) {
            // The encoder is dragged along at the end of the play.
            *dragged = dragged.clamp(actual - play, actual + play);
            *q = *dragged + sensing.encoder_noise * normal(&mut self.encoder_random);
        }
    }

    /// What a force sensor says, and when it does.
    fn measure_force(&mut self, time: f64, felt: Wrench) -> Wrench {
        let sensing = &self.settings.sensing;
        let delay = (sensing.force_delay / self.config.period).round() as usize;
        self.late.push_back(felt);
        let mut measured = if self.late.len() > delay {
            self.late.pop_front().unwrap_or(felt)
        } else {
            self.late.front().copied().unwrap_or(felt)
        };
        for axis in 0..3 {
            measured.force[axis] += self.settings.force_bias[axis]
                + sensing.force_drift[axis] * time
                + self.settings.force_noise * normal(&mut self.random);
        }
        measured
    }

    /// What the controller asks for, from what is measured.
    fn command(&mut self, time: f64) -> Result<ControlCommand, SimulationError> {
        self.motion = self.followed.index_at(time);
        for (k, &i) in (self.controller.articulation().variables().iter()).enumerate() {
            self.robot_q[i] = self.q[k];
            self.robot_qd[i] = self.qd[k];
        }
        let measured = (&self.robot_q, &self.robot_qd);
        (self.controller)
            .command(self.task, self.followed, time, measured.0, measured.1)
            .ok_or(SimulationError::NoInertia { time })
    }

    /// Whether the robot has to stop itself.
    fn stop_cause(&self, command: &ControlCommand) -> Option<StopCause> {
        let distance = command.error().norm();
        if distance > MAX_ASTRAY {
            let limit = MAX_ASTRAY;
            return Some(StopCause::Astray { distance, limit });
        }
        let moving = self.controller.articulation().variables();
        let velocity_of = |variable: usize| {
            let k = moving.iter().position(|&moving| moving == variable);
            k.map_or(0.0, |k| self.qd[k])
        };
        if let Some(cause) = overspeed(self.cell.limits().followers(), velocity_of) {
            return Some(cause);
        }
        let limits = self.cell.limits().joints();
        for &k in self.controller.own_compliant() {
            let i = moving[k];
            let joint = self.cell.robot().variable(i);
            let limit = MAX_OVERSPEED * limits[i].velocity;
            if self.qd[k].abs() > limit {
                return Some(StopCause::Overspeed {
                    joint: joint.name.clone(),
                    velocity: self.qd[k],
                    limit,
                });
            }
            let range = joint.limits.position;
            let beyond = |range: &Range| {
                !(range.lower - MAX_OVERSHOOT..=range.upper + MAX_OVERSHOOT).contains(&self.q[k])
            };
            if let Some(limits) = range.filter(beyond) {
                return Some(StopCause::Overshoot {
                    joint: joint.name.clone(),
                    position: self.q[k],
                    limits,
                });
            }
        }
        None
    }

    /// Whether the simulated robot is still one.
    fn check(&self) -> Result<(), SimulationError> {
        for (i, &velocity) in self.qd.iter().enumerate() {
            if velocity.abs() > MAX_VELOCITY
                || !velocity.is_finite()
                || !self.actual_q[i].is_finite()
            {
                let variable = self.controller.articulation().variables()[i];
                return Err(SimulationError::Diverged {
                    time: self.time,
                    joint: self.cell.robot().variable(variable).name.clone(),
                    velocity,
                    limit: MAX_VELOCITY,
                });
            }
        }
        Ok(())
    }

    /// Hands out what is measured.
    fn record(
        &mut self,
        time: f64,
        command: &ControlCommand,
        sample: &mut SampleSink<'_>,
    ) -> ControlFlow<()> {
        let Some(motion) = self.followed.motions.get(self.motion) else {
            return ControlFlow::Break(());
        };
        let external = self.measure_force(time, command.external);
        let variables = self.controller.articulation().variables();
        for (&i, bias) in variables.iter().zip(self.controller.state().bias()) {
            self.robot_efforts[i] = *bias;
        }
        for (i, effort) in (self.controller.compliant()).zip(self.controller.efforts()) {
            self.robot_efforts[i] = *effort;
        }
        sample(&TelemetrySample {
            time,
            positions: &self.robot_q,
            velocities: &self.robot_qd,
            efforts: &self.robot_efforts,
            world_from_commanded: command.desired.world_from_tool,
            world_from_tool: command.world_from_tool,
            controller: command.controller,
            external,
            motion: self.motion,
            phase: motion.phase,
        })
    }

    /// Pushes and changes of friction; whether somebody pushes.
    fn disturb(&mut self, time: f64, tool: &Point3) -> bool {
        while self
            .friction_changes
            .last()
            .is_some_and(|(start, _)| *start <= time)
        {
            if let Some((_, friction)) = self.friction_changes.pop() {
                self.plant.set_friction(friction);
            }
        }
        let mut is_pushed = false;
        let mut is_touched = false;
        for (start, push) in &self.pushes {
            let end = start + push.duration;
            if !(*start..end + SETTLING).contains(&time) {
                continue;
            }
            is_pushed = true;
            if time >= end {
                continue;
            }
            let size = push.force.norm();
            if size == 0.0 {
                continue;
            }
            let direction = push.force / size;
            let mut yielding = 0.0;
            for (column, qd) in self.controller.jacobian().column_iter().zip(&self.qd) {
                let moved = Vector3::new(column[0], column[1], column[2]);
                yielding += qd * moved.dot(&direction);
            }
            let share = (1.0 - yielding / push.hand_speed).clamp(0.0, 1.0);
            self.plant.push(&(push.force * share), tool);
            is_touched |= share > 0.0;
        }
        let was_touched = std::mem::replace(&mut self.was_touched, is_touched);
        note(&mut self.truth.pushes, time, [was_touched, is_touched]);
        is_pushed
    }

    fn is_wiping(&self) -> bool {
        let motion = self.followed.motions.get(self.motion);
        motion.is_some_and(|motion| motion.phase.is_contact())
    }

    /// What really happened in this period.
    fn observe_truth(&mut self, command: &ControlCommand, world_from_tool: &Pose, is_pushed: bool) {
        let (time, desired) = (self.time, &command.desired);
        let is_wiping = self.is_wiping();
        let truth = &mut self.truth;
        let force = command.controller.force.norm();
        truth.max_controller_force = truth.max_controller_force.max(force);
        let speed = desired.velocity.fixed_rows::<3>(0).norm();
        let slides = is_wiping && speed > SLIDING && !is_pushed;
        if !slides {
            self.sliding_since = None;
            return;
        }
        let since = *self.sliding_since.get_or_insert(time);
        if time - since < SETTLING {
            return;
        }
        let force = self.plant.contact_force();
        self.sliding_time += self.config.period;
        if force <= 0.0 {
            self.lost_time += self.config.period;
        }
        truth.contact_force.add(force);
        let world_from_real =
            self.task.surface.world_from_surface * self.settings.believed_from_real;
        let in_real = world_from_real.inverse() * Point3::from(world_from_tool.translation.vector);
        truth.max_plane_distance = truth.max_plane_distance.max(in_real.z.abs());
        let error = desired.world_from_tool.translation.vector - world_from_tool.translation.vector;
        let normal = self.plant.normal();
        let lateral = error - normal * normal.dot(&error);
        truth.max_lateral_error = truth.max_lateral_error.max(lateral.norm());
    }

    fn finish(mut self, ending: Ending) -> Result<(Execution, GroundTruth), SimulationError> {
        if self.settings.camera.is_some_and(|camera| camera.arm_hides) {
            let mut positions = self.robot_q.clone();
            let variables = self.controller.articulation().variables();
            for (&i, actual) in variables.iter().zip(&self.actual_q) {
                positions[i] = *actual;
            }
            let surface = &self.task.surface.world_from_surface;
            self.truth.hidden = hidden_by(
                self.cell,
                &positions,
                &self.tool.parts,
                &self.tool.tip_from_tool,
                &(surface * self.settings.believed_from_real),
            )?;
        }
        self.truth.lost_share = self.lost_time / self.sliding_time.max(self.config.period);
        self.truth.dirt = self.dirt;
        let execution = Execution {
            duration: self.time,
            ending,
            positions: self.robot_q,
        };
        Ok((execution, self.truth))
    }
}

/// A joint that follows others and is too fast, by the velocities of the robot's variables [rad/s or m/s].
fn overspeed(followers: &[FollowerLimit], velocity_of: impl Fn(usize) -> f64) -> Option<StopCause> {
    followers.iter().find_map(|FollowerLimit { limit, drive }| {
        let terms = drive.terms.iter();
        let velocity: f64 = terms
            .map(|&(variable, factor)| factor * velocity_of(variable))
            .sum();
        let most = MAX_OVERSPEED * limit.velocity;
        (velocity.abs() > most).then(|| StopCause::Overspeed {
            joint: limit.name.clone(),
            velocity,
            limit: most,
        })
    })
}

/// Notes what is so at this time, from when to when without a break.
fn note(spans: &mut Vec<[f64; 2]>, time: f64, [was, is]: [bool; 2]) {
    match spans.last_mut() {
        Some([_, end]) if is && was => *end = time,
        _ if is => spans.push([time, time]),
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use wisch::follow::JointLimit;
    use wisch::robot::Drive;

    #[test]
    fn a_joint_that_follows_others_stops_the_robot_when_it_is_too_fast() {
        let limit = JointLimit {
            velocity: 1.0,
            ..JointLimit::arm("torso_4", -2.0, 2.0)
        };
        let drive = Drive {
            offset: 0.0,
            terms: vec![(1, -1.0), (2, -1.0)],
        };
        let followers = [FollowerLimit { limit, drive }];
        // Each for itself is no faster than it may be.
        let stop = |qd: [f64; 3]| overspeed(&followers, |variable| qd[variable]);
        assert_eq!(stop([9.0, 2.0, 1.9]), None);
        let expected = StopCause::Overspeed {
            joint: "torso_4".to_owned(),
            velocity: -4.5,
            limit: 4.0,
        };
        assert_eq!(stop([0.0, 2.0, 2.5]), Some(expected));
    }
}
