//! Execution of one motion order: the loop of control, simulation and telemetry.

use crate::camera::hide_behind;
use crate::grains::GrainBodies;
use crate::plant::{GRAVITY, HeldTool, Plant, TOOL_MASS, firm_load};
use crate::treated::TreatedSurface;
use crate::{Dirt, GroundTruth, Push, SimulationError, SimulationSettings, Spread};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use std::collections::VecDeque;
use std::ops::ControlFlow;
use wisch::control::{ControlCommand, ControlConfig, MotionController};
use wisch::follow::{Followed, FollowerLimit, Phase, TrajectorySample, Workcell};
use wisch::geometry::{Point3, Pose, Vector3};
use wisch::random::normal;
use wisch::represent::Task;
use wisch::robot::{Articulation, ArticulationState, JointKind, Range};
use wisch::run::{
    Ending, Execution, MotionOrder, SampleSink, SampleStatus, StopCause, TelemetrySample, Wrench,
};

/// Largest joint velocity that counts as physical [rad/s or m/s]; beyond it the simulation has diverged.
const MAX_VELOCITY: f64 = 100.0;
/// Least speed of the commanded tool along the surface at which its contact force counts as sliding force [m/s].
const MIN_SLIDING_SPEED: f64 = 0.01;
/// Time after which contact forces count again, once the tool has begun to slide or a push has
/// ended [s].
const SETTLING_TIME: f64 = 0.3;
/// Streams of random numbers: force noise and encoder noise.
const NOISE_STREAM: u64 = 0x6e6f_6973;
const ENCODER_STREAM: u64 = 0x656e_636f;

/// Largest distance of the tool from its commanded position; beyond it the robot stops itself [m].
const MAX_TOOL_ERROR: f64 = 0.5;
/// Largest joint velocity as a multiple of the joint's limit; beyond it the robot stops itself [1].
const OVERSPEED_FACTOR: f64 = 4.0;
/// Largest distance of a joint beyond its position limit; beyond it the robot stops itself [rad or m].
const MAX_OVERSHOOT: f64 = 0.1;

/// Executes the motion of `order` in the simulated world.
///
/// `sink` receives one telemetry sample per control period and may stop the execution. Pushes and changes of friction
/// are those that `settings` schedule for the round of `order`. `dirt` is the ground truth of the dirt at the start; an
/// empty `dirt` is executed without dirt. The same arguments give the same result, bit for bit.
///
/// # Errors
/// If no joint moves the tool, if surface or tool have no area, or if the simulation diverges.
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
        if let Some(ending) = simulation.run_period(k as f64 * control.period, sink)? {
            return simulation.finish(ending);
        }
    }
    simulation.finish(Ending::Complete)
}

/// State of one execution, allocated once.
pub(crate) struct Simulation<'a> {
    task: &'a Task,
    cell: &'a Workcell,
    followed: &'a Followed,
    config: &'a ControlConfig,
    settings: &'a SimulationSettings,
    /// Pushes, each with its start [s].
    pushes: Vec<(f64, Push)>,
    /// Whether a hand touched the tool, and whether robot or tool touched the scene, in the previous period.
    was_touched: bool,
    was_obstructed: bool,
    friction_changes: Vec<(f64, f64)>,
    plant: Plant,
    tool: HeldTool,
    grains: GrainBodies,
    treated: Option<TreatedSurface>,
    dirt: Dirt,
    controller: MotionController,
    /// True joint state, used where the encoders measure something else.
    actual: ArticulationState,
    /// Pose of the real tool in the frame of the moving joint that carries it.
    joint_from_real_tool: Pose,
    /// The articulation's variables: ground truth.
    actual_q: Vec<f64>,
    /// Encoder positions, dragged along by the joints within their backlash.
    encoder_q: Vec<f64>,
    /// The articulation's variables, as measured.
    q: Vec<f64>,
    qd: Vec<f64>,
    joint_efforts: Vec<f64>,
    /// All variables of the robot, as measured.
    robot_q: Vec<f64>,
    robot_qd: Vec<f64>,
    robot_efforts: Vec<f64>,
    /// Wrenches that the force sensor has not yet reported, the oldest first.
    delayed_wrenches: VecDeque<Wrench>,
    random: ChaCha8Rng,
    encoder_random: ChaCha8Rng,
    /// Index of the current motion.
    motion: usize,
    /// Setpoint of the current period, in place of the motion: state of all variables, and the
    /// share of the full press depth.
    setpoint: Option<(TrajectorySample, f64)>,
    sliding_since: Option<f64>,
    time: f64,
    sliding_time: f64,
    lost_time: f64,
    truth: GroundTruth,
}

impl<'a> Simulation<'a> {
    pub(crate) fn new(
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
        let start = (followed.sample(0.0)).map_or_else(|| cell.ready_posture().to_vec(), |s| s.q);
        let q: Vec<f64> = articulation.variables().iter().map(|&i| start[i]).collect();
        let tool = HeldTool::new(cell, task, &settings.tool);
        let (_, joint_from_tip) = articulation.carrier(cell.tip());
        let moving: Vec<bool> = (0..robot.dof())
            .map(|i| articulation.variables().contains(&i))
            .collect();
        let loads = [(cell.tip(), firm_load(&tool))];
        let firm = Articulation::new(robot, cell.world_from_root(), &start, &moving, &loads)?;
        let compliant = controller.compliant_indices();
        let mut plant = Plant::new(cell, task, &tool, settings, &firm, compliant, &q, config)?;
        let treated = TreatedSurface::from_task(task, &tool);
        let none = Dirt::default();
        // Points of a treated surface need no bodies.
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
            encoder_q: q.clone(),
            q,
            joint_efforts: vec![0.0; articulation.joints().len()],
            robot_qd: vec![0.0; start.len()],
            robot_efforts: vec![0.0; start.len()],
            robot_q: start,
            delayed_wrenches: VecDeque::new(),
            random,
            encoder_random,
            motion: 0,
            setpoint: None,
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

    /// Removes all pushes and changes of friction.
    pub(crate) fn clear_disturbances(&mut self) {
        self.pushes.clear();
        self.friction_changes.clear();
    }

    /// Makes the next periods follow a setpoint instead of the motion. `press_share`: share of the
    /// full press into the surface, 0 to 1.
    pub(crate) fn head_for(&mut self, setpoint: &TrajectorySample, press_share: f64) {
        self.setpoint = Some((setpoint.clone(), press_share));
    }

    /// Runs one control period: measures, commands, records, and steps the plant. Returns the ending if the execution
    /// ends.
    pub(crate) fn run_period(
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

        // Inverse dynamics for joints that follow others, including the planned acceleration.
        let has_ideal_encoders = self.settings.sensing.has_ideal_encoders();
        if has_ideal_encoders {
            self.controller.inverse_dynamics();
        } else {
            let articulation = self.controller.articulation();
            let [_, _, qdd] = self.controller.planned_variables();
            articulation.evaluate(&mut self.actual, &self.actual_q, &self.qd, GRAVITY);
            articulation.inverse_dynamics(&mut self.actual, &self.qd, qdd, GRAVITY);
        }
        let actual = if has_ideal_encoders {
            self.controller.state()
        } else {
            &self.actual
        };
        let world_from_real_tool =
            actual.pose(self.controller.carrier()) * self.joint_from_real_tool;
        self.plant.drive(
            actual,
            self.controller.compliant_indices(),
            self.controller.efforts(),
            self.controller.planned_variables(),
            &mut self.joint_efforts,
        );
        let real_tool = world_from_real_tool.translation.vector.into();
        let is_pushed = self.disturb(time, &real_tool);
        self.plant.lay_surface();
        self.grains.act(&mut self.plant, &mut self.dirt, &self.tool);
        if let Some(treated) = &self.treated {
            let period = self.config.period;
            treated.act(&self.plant, &mut self.dirt, &self.tool, period);
        }
        let period = self.config.period;
        (self.grains).run_film(&mut self.plant, &mut self.dirt, self.task, period);
        self.plant.step();
        let is_obstructed = self.plant.is_obstructed();
        let was_obstructed = std::mem::replace(&mut self.was_obstructed, is_obstructed);
        let obstructed = [was_obstructed, is_obstructed];
        extend_spans(&mut self.truth.obstructions, time, obstructed);
        self.grains
            .settle(&mut self.plant, &mut self.dirt, self.task);
        self.observe_truth(&command, &world_from_real_tool, is_pushed);
        Ok(flow.is_break().then_some(Ending::Stopped))
    }

    /// Reads the encoders: backlash first, then noise.
    fn measure_joints(&mut self) {
        let sensing = &self.settings.sensing;
        if sensing.has_ideal_encoders() {
            self.q.copy_from_slice(&self.actual_q);
            return;
        }
        let play = sensing.backlash / 2.0;
        for ((q, encoder_q), actual) in self
            .q
            .iter_mut()
            .zip(&mut self.encoder_q)
            .zip(&self.actual_q)
        {
            // Backlash: |encoder − joint| ≤ play / 2, so the joint drags the encoder along only at the end of the play.
            *encoder_q = encoder_q.clamp(actual - play, actual + play);
            *q = *encoder_q + sensing.encoder_noise * normal(&mut self.encoder_random);
        }
    }

    /// Returns the force sensor's reading [N]: the true wrench, delayed, with bias, drift and noise.
    fn measure_force(&mut self, time: f64, true_wrench: Wrench) -> Wrench {
        let sensing = &self.settings.sensing;
        let delay = (sensing.force_delay / self.config.period).round() as usize;
        self.delayed_wrenches.push_back(true_wrench);
        let mut measured = if self.delayed_wrenches.len() > delay {
            self.delayed_wrenches.pop_front().unwrap_or(true_wrench)
        } else {
            self.delayed_wrenches
                .front()
                .copied()
                .unwrap_or(true_wrench)
        };
        for axis in 0..3 {
            measured.force[axis] += self.settings.force_bias[axis]
                + sensing.force_drift[axis] * time
                + self.settings.force_noise * normal(&mut self.random);
        }
        measured
    }

    /// Computes the controller's command from the measured joint state.
    fn command(&mut self, time: f64) -> Result<ControlCommand, SimulationError> {
        self.motion = self.followed.index_at(time);
        for (k, &i) in (self.controller.articulation().variables().iter()).enumerate() {
            self.robot_q[i] = self.q[k];
            self.robot_qd[i] = self.qd[k];
        }
        let (q, qd) = (&self.robot_q, &self.robot_qd);
        let command = match &self.setpoint {
            Some((setpoint, share)) => {
                (self.controller).command_toward(self.task, setpoint, *share, q, qd)
            }
            None => (self.controller).command(self.task, self.followed, time, q, qd),
        };
        command.ok_or(SimulationError::NoInertia { time })
    }

    /// Returns the reason why the robot must stop itself; `None` if it need not.
    fn stop_cause(&self, command: &ControlCommand) -> Option<StopCause> {
        let distance = command.error().norm();
        if distance > MAX_TOOL_ERROR {
            let limit = MAX_TOOL_ERROR;
            return Some(StopCause::Astray { distance, limit });
        }
        let moving = self.controller.articulation().variables();
        let velocity_of = |variable: usize| {
            let k = moving.iter().position(|&moving| moving == variable);
            k.map_or(0.0, |k| self.qd[k])
        };
        let kind_of = |name: &str| {
            let mut joints = self.cell.robot().joints().iter();
            let joint = joints.find(|joint| joint.name == name);
            joint.map_or(JointKind::Revolute, |joint| joint.kind)
        };
        if let Some(cause) = find_overspeed(self.cell.limits().followers(), velocity_of, kind_of) {
            return Some(cause);
        }
        let limits = self.cell.limits().joints();
        for &k in self.controller.compliant_indices() {
            let i = moving[k];
            let joint = self.cell.robot().variable(i);
            let limit = OVERSPEED_FACTOR * limits[i].velocity;
            if self.qd[k].abs() > limit {
                return Some(StopCause::Overspeed {
                    joint: joint.name.clone(),
                    velocity: self.qd[k],
                    limit,
                    kind: joint.kind,
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
                    kind: joint.kind,
                });
            }
        }
        None
    }

    /// Checks that the state of the simulated robot is finite and physically possible.
    fn check(&self) -> Result<(), SimulationError> {
        if let Some(id) = self.plant.find_oscillating_follower() {
            return Err(SimulationError::Oscillates {
                time: self.time,
                joint: self.cell.robot().joints()[id.index()].name.clone(),
            });
        }
        for (i, &velocity) in self.qd.iter().enumerate() {
            if velocity.abs() > MAX_VELOCITY
                || !velocity.is_finite()
                || !self.actual_q[i].is_finite()
            {
                let variable = self.controller.articulation().variables()[i];
                let joint = self.cell.robot().variable(variable);
                return Err(SimulationError::Diverged {
                    time: self.time,
                    joint: joint.name.clone(),
                    velocity,
                    limit: MAX_VELOCITY,
                    unit: joint.kind.unit(),
                });
            }
        }
        Ok(())
    }

    /// Sends one telemetry sample to the sink.
    fn record(
        &mut self,
        time: f64,
        command: &ControlCommand,
        sample: &mut SampleSink<'_>,
    ) -> ControlFlow<()> {
        let Some(phase) = self.phase() else {
            return ControlFlow::Break(());
        };
        let external = self.measure_force(time, command.external);
        let variables = self.controller.articulation().variables();
        for (&i, bias) in variables.iter().zip(self.controller.state().bias()) {
            self.robot_efforts[i] = *bias;
        }
        for (i, effort) in (self.controller.compliant_variables()).zip(self.controller.efforts()) {
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
            phase,
            status: SampleStatus::default(),
        })
    }

    /// Applies pushes and changes of friction. Returns whether a push acts or has just ended.
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
            if !(*start..end + SETTLING_TIME).contains(&time) {
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
            // Yielding: speed of the tool along the push, Σ q̇ᵢ Jᵢ · direction [m/s].
            let mut yielding = 0.0;
            for (column, qd) in self.controller.jacobian().column_iter().zip(&self.qd) {
                let moved = Vector3::new(column[0], column[1], column[2]);
                yielding += qd * moved.dot(&direction);
            }
            // The faster the tool yields, the smaller is the force of the hand: F = F₀ (1 − v /
            // v_hand), between 0 and F₀.
            let share = (1.0 - yielding / push.hand_speed).clamp(0.0, 1.0);
            self.plant.push(&(push.force * share), tool);
            is_touched |= share > 0.0;
        }
        let was_touched = std::mem::replace(&mut self.was_touched, is_touched);
        extend_spans(&mut self.truth.pushes, time, [was_touched, is_touched]);
        is_pushed
    }

    /// The phase of the current motion. While an arm follows setpoints, it wipes if it presses.
    fn phase(&self) -> Option<Phase> {
        match &self.setpoint {
            Some((_, share)) if *share > 0.0 => Some(Phase::Wipe(0)),
            Some(_) => Some(Phase::FreeMotion),
            None => (self.followed.motions.get(self.motion)).map(|motion| motion.phase),
        }
    }

    fn is_wiping(&self) -> bool {
        self.phase().is_some_and(Phase::is_contact)
    }

    /// Updates the ground truth of this period.
    fn observe_truth(&mut self, command: &ControlCommand, world_from_tool: &Pose, is_pushed: bool) {
        let (time, desired) = (self.time, &command.desired);
        let is_wiping = self.is_wiping();
        let truth = &mut self.truth;
        let force = command.controller.force.norm();
        truth.max_controller_force = truth.max_controller_force.max(force);
        let speed = desired.velocity.fixed_rows::<3>(0).norm();
        let slides = is_wiping && speed > MIN_SLIDING_SPEED && !is_pushed;
        if !slides {
            self.sliding_since = None;
            return;
        }
        let since = *self.sliding_since.get_or_insert(time);
        if time - since < SETTLING_TIME {
            return;
        }
        let force = self.plant.contact_force();
        self.sliding_time += self.config.period;
        if force <= 0.0 {
            self.lost_time += self.config.period;
        }
        truth.contact_force.add(force);
        let real = self.plant.real();
        let at = real.chart(Point3::from(world_from_tool.translation.vector));
        truth.max_plane_distance = truth.max_plane_distance.max(at.height.abs());
        let error = desired.world_from_tool.translation.vector - world_from_tool.translation.vector;
        let normal = real.normal(at.place);
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
            self.truth.hidden = hide_behind(
                self.cell,
                &positions,
                &self.tool.parts,
                &self.tool.tip_from_tool,
                self.plant.real(),
            )?;
        }
        self.truth.lost_share = self.lost_time / self.sliding_time.max(self.config.period);
        self.truth.dirt = self.dirt;
        let execution = Execution {
            duration: self.time,
            ending,
            positions: self.robot_q,
            pauses: Vec::new(),
            dropped_samples: 0,
        };
        Ok((execution, self.truth))
    }
}

/// Returns why a joint that follows others is too fast, given the velocities of the robot's variables [rad/s or m/s] and
/// the kind of a joint by its name.
fn find_overspeed(
    followers: &[FollowerLimit],
    velocity_of: impl Fn(usize) -> f64,
    kind_of: impl Fn(&str) -> JointKind,
) -> Option<StopCause> {
    followers.iter().find_map(|FollowerLimit { limit, drive }| {
        let terms = drive.terms.iter();
        let velocity: f64 = terms
            .map(|&(variable, factor)| factor * velocity_of(variable))
            .sum();
        let most = OVERSPEED_FACTOR * limit.velocity;
        (velocity.abs() > most).then(|| StopCause::Overspeed {
            joint: limit.name.clone(),
            velocity,
            limit: most,
            kind: kind_of(&limit.name),
        })
    })
}

/// Extends the last time span [s] while a condition holds, and opens a new span when it begins to hold.
fn extend_spans(spans: &mut Vec<[f64; 2]>, time: f64, [was, is]: [bool; 2]) {
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
        // Each variable alone is within its limit.
        let stop = |qd: [f64; 3]| {
            find_overspeed(&followers, |variable| qd[variable], |_| JointKind::Revolute)
        };
        assert_eq!(stop([9.0, 2.0, 1.9]), None);
        let expected = StopCause::Overspeed {
            joint: "torso_4".to_owned(),
            velocity: -4.5,
            limit: 4.0,
            kind: JointKind::Revolute,
        };
        let text = "joint \"torso_4\" moves at -4.50 rad/s, more than the limit of 4.00 rad/s";
        assert_eq!(expected.to_string(), text);
        assert_eq!(stop([0.0, 2.0, 2.5]), Some(expected));
    }
}
