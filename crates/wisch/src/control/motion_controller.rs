//! The controller (8) along a motion: the desired state at each time, the efforts for it, and the external
//! force.

use super::{
    ControlConfig, DesiredPosture, DesiredToolState, ImpedanceController, MeasuredJointState,
    MomentumObserver, Wrench,
};
use crate::follow::{Followed, Phase, TrajectorySample, Workcell};
use crate::geometry::{Point3, Pose, Vector2, Vector3};
use crate::represent::Task;
use crate::robot::{Articulation, ArticulationState, Body, RobotError};
use nalgebra::{Matrix3, Matrix6xX, Translation3, Vector6};

/// Gravitational acceleration in the world [m/s²].
const GRAVITY: Vector3 = Vector3::new(0.0, 0.0, -9.81);

/// Returns the commanded pose with which the tool presses: `world_from_tool`, its pose on the
/// estimated surface, shifted into the surface as far as the spring requires. The shift grows as
/// the tool comes down. In free motion the pose does not change.
pub fn press_into_surface(
    world_from_tool: Pose,
    phase: Option<Phase>,
    task: &Task,
    config: &ControlConfig,
) -> Pose {
    let (height, _) = height_and_normal(&world_from_tool, task);
    let presses = matches!(phase, Some(Phase::Lower | Phase::Wipe(_) | Phase::Lift));
    let share = if presses {
        (1.0 - height / config.approach_height).clamp(0.0, 1.0)
    } else {
        0.0
    };
    press_by_share(world_from_tool, share, task, config)
}

/// Returns the height of the tool over the believed surface [m], and the normal of the surface
/// there, in the world.
fn height_and_normal(world_from_tool: &Pose, task: &Task) -> (f64, Vector3) {
    let tool: Point3 = world_from_tool.translation.vector.into();
    let surface = &task.surface;
    if surface.shape.is_plane() {
        let world_from_surface = &surface.world_from_surface;
        let height = (world_from_surface.inverse() * tool).z;
        return (height, world_from_surface * Vector3::z());
    }
    let at = surface.chart(tool);
    (at.height, surface.normal(at.place))
}

/// Returns a pose of the tool, shifted into the surface by a share of the depth at which the spring
/// exerts its full force.
fn press_by_share(world_from_tool: Pose, share: f64, task: &Task, config: &ControlConfig) -> Pose {
    let (_, normal) = height_and_normal(&world_from_tool, task);
    let interaction = &task.interaction;
    // The spring presses with the margin times the contact force at depth = margin · F / k.
    let depth = config.press_margin * interaction.contact_force() / interaction.stiffness_n_per_m;
    Translation3::from(-normal * (depth * share)) * world_from_tool
}

/// Input that determines how far the commanded tool is shifted into the surface.
#[derive(Debug, Clone, Copy)]
enum Press {
    /// The phase of a motion and the height of the tool.
    Phase(Option<Phase>),
    /// A share of the full depth, 0 to 1.
    Share(f64),
}

/// Returns the load of a tool of this mass \[kg\] on the link that holds it: a cuboid at the tool
/// centre point, of this `extent` along the tool's x and y \[m\], and as high as the shorter side.
pub fn tool_load(tip_from_tool: &Pose, extent: Vector2, mass: f64) -> Body {
    // Moment of inertia of a cuboid: m (a² + b²) / 12.
    let about = |a: f64, b: f64| mass / 12.0 * (a * a + b * b) + 1e-6;
    let depth = extent.min();
    Body {
        mass,
        center_in_link: tip_from_tool * Point3::origin(),
        inertia_about_center: Matrix3::from_diagonal(&Vector3::new(
            about(extent.y, depth),
            about(extent.x, depth),
            about(extent.x, extent.y),
        )),
    }
}

/// The controller's output at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ControlCommand {
    /// Measured pose of the tool, by forward kinematics.
    pub world_from_tool: Pose,
    /// Desired pose and twist of the tool, the press into the surface included.
    pub desired: DesiredToolState,
    /// f_c: the controller's wrench on the tool, saturated.
    pub controller: Wrench,
    /// f_ext: the observed external wrench on the tool.
    pub external: Wrench,
}

impl ControlCommand {
    /// Vector from the tool to its commanded position, in the world \[m\].
    pub fn error(&self) -> Vector3 {
        self.desired.world_from_tool.translation.vector - self.world_from_tool.translation.vector
    }
}

/// Drives a robot along a motion by torques, compliantly. It allocates all memory at the start.
///
/// Of the moving variables, those of arm and torso are compliant. The drives of all other
/// variables, for example those of a mobile base, must hold them at their planned positions.
#[derive(Debug, Clone)]
pub struct MotionController {
    config: ControlConfig,
    articulation: Articulation,
    state: ArticulationState,
    planned: ArticulationState,
    controller: ImpedanceController,
    observer: MomentumObserver,
    carrier: usize,
    joint_from_tool: Pose,
    jacobian: Matrix6xX<f64>,
    planned_sample: TrajectorySample,
    /// Positions, velocities and accelerations of the articulation's variables as planned.
    planned_q: [Vec<f64>; 3],
    q: Vec<f64>,
    qd: Vec<f64>,
    /// Efforts of the drives after limitation, and their limits [Nm or N].
    efforts: Vec<f64>,
    effort_limits: Vec<f64>,
}

impl MotionController {
    /// Returns a controller for a motion of a robot with a tool of this mass \[kg\] in its hand;
    /// `None` if no moving joint carries the tool.
    ///
    /// # Errors
    /// [`RobotError`] if the robot does not have the joints of the motion.
    pub fn new(
        task: &Task,
        cell: &Workcell,
        followed: &Followed,
        tool_mass: f64,
        config: &ControlConfig,
    ) -> Result<Option<Self>, RobotError> {
        let robot = cell.robot();
        let start = (followed.sample(0.0)).map_or_else(|| cell.ready_posture().to_vec(), |s| s.q);
        let chain = cell.ik().chain().variables();
        let base = (cell.base()).map_or(vec![], |base| vec![base.x, base.y, base.yaw]);
        let moving: Vec<bool> = (0..robot.dof())
            .map(|i| chain.contains(&i) || base.contains(&i) || varies(followed, i, start[i]))
            .collect();
        let load = tool_load(cell.tip_from_tool(), task.tool.area_of_effect, tool_mass);
        let loads = [(cell.tip(), load)];
        let articulation =
            Articulation::new(robot, cell.world_from_root(), &start, &moving, &loads)?;
        let (Some(carrier), joint_from_tip) = articulation.carrier(cell.tip()) else {
            return Ok(None);
        };
        let joint_from_tool = joint_from_tip * cell.tip_from_tool();
        let compliant: Vec<usize> = (0..articulation.dof())
            .filter(|&i| {
                let variable = articulation.variables()[i];
                chain.contains(&variable) && !base.contains(&variable)
            })
            .collect();
        let limits = |k: &usize| &robot.variable(articulation.variables()[*k]).limits;
        let effort_limits: Vec<f64> = (compliant.iter())
            .map(|k| limits(k).effort.unwrap_or(f64::INFINITY))
            .collect();
        let ranges = compliant.iter().map(|k| limits(k).position).collect();
        let count = articulation.dof();
        Ok(Some(Self {
            config: *config,
            state: articulation.state(),
            planned: articulation.state(),
            observer: MomentumObserver::new(&compliant, count, config.observer_gain),
            efforts: vec![0.0; compliant.len()],
            controller: ImpedanceController::new(
                compliant,
                ranges,
                &task.interaction,
                &task.surface,
                config,
            ),
            carrier,
            joint_from_tool,
            jacobian: Matrix6xX::zeros(count),
            planned_sample: TrajectorySample::from_positions(&start),
            planned_q: [(); 3].map(|()| vec![0.0; count]),
            q: vec![0.0; count],
            qd: vec![0.0; count],
            effort_limits,
            articulation,
        }))
    }

    /// The robot's compliant variables, in the order of [`Self::efforts`].
    pub fn compliant_variables(&self) -> impl Iterator<Item = usize> + '_ {
        let own = self.compliant_indices().iter();
        own.map(|&k| self.articulation.variables()[k])
    }

    /// The compliant variables as indices into the articulation's variables.
    pub fn compliant_indices(&self) -> &[usize] {
        self.controller.compliant_variables()
    }

    /// The joints that move, with the tool in the hand.
    pub const fn articulation(&self) -> &Articulation {
        &self.articulation
    }

    /// The articulation as measured at the last command.
    pub const fn state(&self) -> &ArticulationState {
        &self.state
    }

    /// The moving joint that carries the tool.
    pub const fn carrier(&self) -> usize {
        self.carrier
    }

    /// The tool's twist in the world per velocity of each of the articulation's variables, as measured (6 × variables).
    pub const fn jacobian(&self) -> &Matrix6xX<f64> {
        &self.jacobian
    }

    /// Positions, velocities and accelerations of the articulation's variables, as planned for the time of the
    /// last command.
    pub const fn planned_variables(&self) -> &[Vec<f64>; 3] {
        &self.planned_q
    }

    /// Adds to the state the efforts of every joint for the planned accelerations, as
    /// [`Articulation::inverse_dynamics`] does.
    pub fn inverse_dynamics(&mut self) {
        let [_, _, qdd] = &self.planned_q;
        self.articulation
            .inverse_dynamics(&mut self.state, &self.qd, qdd, GRAVITY);
    }

    /// Commanded efforts of the compliant variables, within their limits [Nm or N].
    pub fn efforts(&self) -> &[f64] {
        &self.efforts
    }

    /// All n variables of the robot, as planned for the time of the last command.
    pub const fn planned_sample(&self) -> &TrajectorySample {
        &self.planned_sample
    }

    /// Runs one control period: computes the efforts from the measured positions [rad or m] and
    /// velocities [rad/s or m/s] of all n variables, at a `time` of the motion \[s\]. The observer
    /// assumes that the efforts of the last call acted for one period. Returns `None` if the mass
    /// matrix is not positive definite, as for a robot without inertia.
    ///
    /// # Panics
    /// If an array is shorter than the robot has variables.
    pub fn command(
        &mut self,
        task: &Task,
        followed: &Followed,
        time: f64,
        positions: &[f64],
        velocities: &[f64],
    ) -> Option<ControlCommand> {
        let motion = followed.motion_at(time);
        if let Some(motion) = motion {
            let since = time - motion.start;
            motion
                .trajectory
                .sample_into(since, &mut self.planned_sample);
        }
        let press = Press::Phase(motion.map(|motion| motion.phase));
        self.control(task, press, positions, velocities)
    }

    /// Does the same as [`Self::command`], but towards a setpoint that the caller gives instead of
    /// a motion.
    ///
    /// - `setpoint`: all n variables of the robot.
    /// - `press_share`: how far the tool is pressed into the surface, from 0 (not at all) to 1 (fully).
    ///
    /// # Panics
    /// If an array is shorter than the robot has variables.
    pub fn command_toward(
        &mut self,
        task: &Task,
        setpoint: &TrajectorySample,
        press_share: f64,
        positions: &[f64],
        velocities: &[f64],
    ) -> Option<ControlCommand> {
        self.planned_sample.clone_from(setpoint);
        self.control(task, Press::Share(press_share), positions, velocities)
    }

    /// Runs one control period towards the planned sample.
    fn control(
        &mut self,
        task: &Task,
        press: Press,
        positions: &[f64],
        velocities: &[f64],
    ) -> Option<ControlCommand> {
        for (k, &i) in self.articulation.variables().iter().enumerate() {
            self.q[k] = positions[i];
            self.qd[k] = velocities[i];
        }
        self.articulation
            .evaluate(&mut self.state, &self.q, &self.qd, GRAVITY);
        let desired = self.desired(task, press);
        let world_from_tool = self.state.pose(self.carrier) * self.joint_from_tool;
        let tool = world_from_tool.translation.vector.into();
        self.articulation
            .jacobian(&self.state, self.carrier, tool, &mut self.jacobian);
        let external =
            self.observer
                .update(&self.state, &self.qd, &self.efforts, self.config.period);
        let measured = MeasuredJointState {
            q: &self.q,
            qd: &self.qd,
            world_from_tool,
            jacobian: &self.jacobian,
        };
        let [q, qd, qdd] = &self.planned_q;
        let posture = DesiredPosture { q, qd, qdd };
        let controller = self
            .controller
            .command(&self.state, &measured, &desired, &posture)?;
        let external = self.controller.external_wrench(external);
        let asked = self.controller.efforts().iter().zip(&self.effort_limits);
        for (effort, (asked, most)) in self.efforts.iter_mut().zip(asked) {
            *effort = asked.clamp(-most, *most);
        }
        Some(ControlCommand {
            world_from_tool,
            desired,
            controller,
            external,
        })
    }

    /// Returns the desired pose and twist of the tool for the planned sample, the press into the surface included.
    fn desired(&mut self, task: &Task, press: Press) -> DesiredToolState {
        let planned = &self.planned_sample;
        for (k, &i) in self.articulation.variables().iter().enumerate() {
            self.planned_q[0][k] = planned.q[i];
            self.planned_q[1][k] = planned.qd[i];
            self.planned_q[2][k] = planned.qdd[i];
        }
        self.articulation
            .locate(&mut self.planned, &self.planned_q[0]);
        let world_from_tool = self.planned.pose(self.carrier) * self.joint_from_tool;
        let tool = world_from_tool.translation.vector.into();
        self.articulation
            .jacobian(&self.planned, self.carrier, tool, &mut self.jacobian);
        let mut velocity = Vector6::zeros();
        for (column, rate) in self.jacobian.column_iter().zip(&self.planned_q[1]) {
            velocity += column * *rate;
        }
        let world_from_tool = match press {
            Press::Phase(phase) => press_into_surface(world_from_tool, phase, task, &self.config),
            Press::Share(share) => press_by_share(world_from_tool, share, task, &self.config),
        };
        DesiredToolState {
            world_from_tool,
            velocity,
        }
    }
}

/// Whether a variable of the robot moves during the motion.
fn varies(followed: &Followed, variable: usize, start: f64) -> bool {
    let ends = followed.motions.iter().flat_map(|motion| {
        let duration = motion.trajectory.duration();
        [0.25, 0.5, 0.75, 1.0].map(|share| motion.trajectory.sample(share * duration))
    });
    ends.into_iter()
        .any(|sample| (sample.q[variable] - start).abs() > 1e-9)
}
