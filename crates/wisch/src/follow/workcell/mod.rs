//! The work cell: the robot, its tool and the scene, with the movable variables and the collision
//! models.

mod collisions;
mod grasp;
mod group;
mod holder;
pub(super) mod second_arm;
mod target_surface;

pub use group::{PlanarBase, PlanningGroup, StartAssumption};
pub use second_arm::{GRIP_TOLERANCE, LEAN_TOLERANCE, SecondArm};

use crate::follow::{FollowError, FollowerLimit, JointLimit, JointLimits, Phase, ToolPose};
use crate::geometry::{PlanarPose, Point2, Point3, Pose, Vector3};
use crate::plan::Plan;
use crate::represent::{SecondGrip, SurfaceShape, Task, Tool};
use crate::robot::{
    CollisionModel, IkConfig, IkSolver, Joint, JointKind, LinkId, READY_STATE, Range, RobotModel,
    Srdf,
};
use collisions::{MountedTool, WorkcellCollisions};
pub(in crate::follow) use grasp::relax;
pub use grasp::{HeldTool, MountSource};
use group::{held_joints, planar_base, set_named_state};
pub use holder::HolderCylinder;
use nalgebra::{Translation3, UnitQuaternion};
use std::f64::consts::TAU;
pub(in crate::follow) use target_surface::HandBelow;
use target_surface::{PlacedTool, hand_below};

/// Largest distance of a base from the plane of its floor [m, rad].
const FLOOR_TOLERANCE: f64 = 1e-6;
/// Number of random starts from which the second hand is brought to its grip in the ready posture.
const SECOND_STARTS: u64 = 40;

/// What the tool may touch in a collision check.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AllowedContact {
    /// Nothing, as in free motion.
    None,
    /// The target surface and the object that carries it.
    Surface,
}

/// The planning group, and the robot's pose.
#[derive(Debug, Clone, PartialEq)]
pub struct WorkcellConfig {
    /// Name of the SRDF's group; `None` takes its first, see [`PlanningGroup::choose`].
    pub group: Option<String>,
    /// Name of the SRDF's group whose hand holds the tool's second grip; `None` leaves it free.
    pub second_group: Option<String>,
    /// Pose of the robot in the world. For a robot on a planar base: its start, in the plane of the floor.
    pub world_from_robot: Option<Pose>,
    /// Pose of the tool in the frame of the link that holds it; `None` takes the mount of the tool,
    /// or else that of the robot ([`Workcell::mount`]).
    pub tip_from_tool: Option<Pose>,
    /// Distance of revolute joints from their limits while the robot uses the tool \[rad\]: a compliant arm is
    /// not exactly at its planned position.
    pub limit_margin: f64,
}

impl Default for WorkcellConfig {
    /// The first group, the robot at the origin. Joints stay 0.02 rad inside their limits, twice the sag of a
    /// torso.
    fn default() -> Self {
        Self {
            group: None,
            second_group: None,
            world_from_robot: None,
            tip_from_tool: None,
            limit_margin: 0.02,
        }
    }
}

/// A robot with a tool in its hand, in a scene.
#[derive(Debug, Clone)]
pub struct Workcell {
    robot: RobotModel,
    world_from_root: Pose,
    tip: LinkId,
    mount: HeldTool,
    ik: IkSolver,
    second: Option<SecondArm>,
    arm_variables: Vec<usize>,
    base: Option<PlanarBase>,
    ready: Vec<f64>,
    collisions: WorkcellCollisions,
    limits: JointLimits,
    limit_margin: f64,
}

impl Workcell {
    /// Returns the robot in the scene of a task, with the task's tool in its hand.
    ///
    /// Joints that the SRDF names as counterbalanced have no effort limit here.
    /// Joints that carry the group and are no planar base, such as a lift, stay where the ready posture has them.
    ///
    /// While it wipes, comes down or lifts off, the tool may touch the target surface and the object that
    /// carries it; otherwise no contact is allowed. The surface is an obstacle whether or not the scene has an
    /// object that carries it. The tool keeps out of the space behind the surface, unless it waits
    /// there in the ready posture. A robot may drive on a surface that lies in the plane of the
    /// floor.
    ///
    /// # Errors
    /// [`FollowError::UnknownGroup`], [`FollowError::OffFloor`], or geometry that the collision
    /// library refuses.
    pub fn new(
        mut robot: RobotModel,
        srdf: Option<&Srdf>,
        task: &Task,
        config: &WorkcellConfig,
    ) -> Result<Self, FollowError> {
        if let Some(srdf) = srdf {
            robot.remove_effort_limits(&srdf.counterbalanced);
        }
        let mut group = PlanningGroup::choose(&robot, srdf, config.group.as_deref())?;
        let ready_with_tool = format!("{READY_STATE}_{}", task.tool.name);
        set_named_state(&mut group.ready, srdf, &ready_with_tool);
        let base = planar_base(&robot, group.base);
        let world_from_root = place_base(base, config.world_from_robot, &mut group.ready)?;
        let mount = match config.tip_from_tool {
            Some(pose) => HeldTool::at_pose(&robot, group.tip, pose),
            None => HeldTool::choose(&robot, srdf, &group, &task.tool)?,
        };
        let tip_from_tool = mount.tip_from_tool;
        let ik = make_tool_solver(&robot, &group, tip_from_tool, config.limit_margin)?;
        let second = match &config.second_group {
            None => None,
            Some(name) => {
                let (tip, grip) = find_second_grip(&robot, srdf, &task.tool, name)?;
                let (ready, margin) = (&group.ready, config.limit_margin);
                let arm = SecondArm::new(&robot, &ik, tip_from_tool, tip, grip, ready, margin)?;
                Some(arm)
            }
        };
        let mut arm_variables = ik.chain().variables().to_vec();
        if let Some(second) = &second {
            arm_variables.extend_from_slice(second.chain().variables());
        }
        let placed = PlacedTool {
            world_from_root,
            tip: group.tip,
            tip_from_tool,
        };
        let mut tool = MountedTool::attach(&robot, srdf, task, &placed)?;
        if let Some(holder) = mount.holder {
            tool.add_holder(&holder.mesh(mount.axis)?)?;
        }
        if let Some(second) = &second {
            tool.allow_second_hand(second.chain().tip())?;
        }
        let collisions = tool.place_in_scene(base, &group.ready, &arm_variables)?;
        let limits = limits(&robot)?;
        if let Some(second) = &second {
            grip_with_second_hand(&robot, second, &ik, &collisions.free, &mut group.ready)?;
        }
        Ok(Self {
            world_from_root,
            tip: group.tip,
            mount,
            ik,
            second,
            arm_variables,
            base,
            ready: group.ready,
            collisions,
            limits,
            limit_margin: config.limit_margin,
            robot,
        })
    }

    /// The robot as described, without the tool and without the effort limits of counterbalanced
    /// joints. Its n variables give the order of every array of positions.
    pub const fn robot(&self) -> &RobotModel {
        &self.robot
    }

    /// Pose of the robot's root link in the world. For a robot on a planar base this is the world's origin.
    pub const fn world_from_root(&self) -> &Pose {
        &self.world_from_root
    }

    /// The link that holds the tool.
    pub const fn tip(&self) -> LinkId {
        self.tip
    }

    /// The tool in the frame of the link that holds it.
    pub const fn tip_from_tool(&self) -> &Pose {
        &self.mount.tip_from_tool
    }

    /// Force of the surface on the tool in a phase of a task's motion, along the surface's outward
    /// normal \[N\]. `None` out of contact, for a tool that hovers, and for a tool in two hands,
    /// whose shares of the force are unknown.
    pub fn tool_load(&self, task: &Task, phase: Phase) -> Option<f64> {
        let force = Some(task.interaction.contact_force()).filter(|force| *force > 0.0);
        force.filter(|_| phase.is_contact() && self.second_arm().is_none())
    }

    /// Returns the outward normal of a task's surface in the robot's root frame, at the place of the tool there \[m\].
    pub(in crate::follow) fn normal_at(&self, task: &Task, tool_in_root: Vector3) -> Vector3 {
        let surface = &task.surface;
        // A plane has the same normal everywhere.
        let place = if surface.shape.is_plane() {
            Point2::origin()
        } else {
            surface
                .chart(self.world_from_root * Point3::from(tool_in_root))
                .place
        };
        self.world_from_root.rotation.inverse() * surface.normal(place)
    }

    /// How the robot holds the tool, and whether this mount is declared or assumed.
    pub const fn mount(&self) -> &HeldTool {
        &self.mount
    }

    /// Inverse kinematics of the tool, from the group's base.
    pub const fn ik(&self) -> &IkSolver {
        &self.ik
    }

    /// The arm whose hand also holds the tool, if there is one.
    pub const fn second_arm(&self) -> Option<&SecondArm> {
        self.second.as_ref()
    }

    /// Returns for each variable of the arm its index among the robot's: those of the group, then those of the
    /// second arm.
    pub fn arm_variables(&self) -> &[usize] {
        &self.arm_variables
    }

    /// The planar base under the group, if there is one.
    pub const fn base(&self) -> Option<PlanarBase> {
        self.base
    }

    /// Names of the joints that carry the group and are not its own, such as a lift; they stay at their positions of the
    /// ready posture.
    pub fn held_joints(&self) -> Vec<String> {
        held_joints(&self.robot, self.ik.chain().base())
    }

    /// Start posture of the robot: all n variables [rad or m].
    pub fn ready_posture(&self) -> &[f64] {
        &self.ready
    }

    /// Collision model with all pairs that may not touch in free motion.
    pub const fn collisions(&self) -> &CollisionModel {
        &self.collisions.free
    }

    /// Collision model with all pairs that may not touch while the tool touches `allowed`.
    pub const fn all_collisions(&self, allowed: AllowedContact) -> &CollisionModel {
        match allowed {
            AllowedContact::None => &self.collisions.free,
            AllowedContact::Surface => &self.collisions.in_contact,
        }
    }

    /// Collision model with the pairs whose distance the base's variables change.
    pub(in crate::follow) const fn base_collisions(&self) -> &CollisionModel {
        &self.collisions.base
    }

    /// Collision model with the pairs whose distance the group's variables change.
    pub const fn arm_collisions(&self, allowed: AllowedContact) -> &CollisionModel {
        match allowed {
            AllowedContact::None => &self.collisions.arm,
            AllowedContact::Surface => &self.collisions.arm_in_contact,
        }
    }

    /// Range of a joint inside its limits by [`WorkcellConfig::limit_margin`]; `None` for a joint without
    /// limits.
    pub(crate) fn range_kept(&self, joint: &Joint) -> Option<Range> {
        let limits = joint.limits.position?;
        let slides = joint.kind == JointKind::Prismatic;
        Some(limits.shrink(if slides { 0.0 } else { self.limit_margin }))
    }

    /// Position, velocity and acceleration limits of all n variables, in the order of the robot's, and of their
    /// mimic joints.
    pub const fn limits(&self) -> &JointLimits {
        &self.limits
    }

    /// Whether a name in a contact is that of an obstacle.
    pub(in crate::follow) fn is_obstacle(&self, name: &str) -> bool {
        self.collisions.obstacles.contains(name)
    }

    /// Returns the part of the hand that would be below the target surface at every node of a plan where the
    /// tool touches it; `None` if the hand is free of it at some node.
    pub(in crate::follow) fn hand_below(
        &self,
        task: &Task,
        plan: &Plan,
    ) -> Result<Option<HandBelow>, FollowError> {
        let tool = PlacedTool {
            world_from_root: self.world_from_root,
            tip: self.tip,
            tip_from_tool: self.mount.tip_from_tool,
        };
        let kinematics = self.robot.forward_kinematics(&self.ready)?;
        Ok(hand_below(task, plan, &self.robot, &kinematics, &tool))
    }

    /// Returns the pose of the tool in the world for its pose relative to the surface.
    pub fn world_from_tool(task: &Task, pose: &ToolPose) -> Pose {
        let PlanarPose { position, heading } = pose.surface_from_tool;
        let yaw = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), heading);
        let upright = match &task.surface.shape {
            SurfaceShape::Plane => {
                Pose::from_parts(Translation3::new(position.x, position.y, pose.height), yaw)
            }
            shape => shape.place(position, pose.height) * yaw,
        };
        let lean = task.tool.tilt.map_or_else(UnitQuaternion::identity, |t| {
            UnitQuaternion::from_axis_angle(&t.axis_in_tool, pose.tilt)
        });
        task.surface.world_from_surface * upright * lean
    }

    /// Returns the work cell with the whole turns of a base on wheels counted as the robot counts
    /// them, so that no motion begins with needless turns.
    ///
    /// `stands`: all n variables as measured [rad or m].
    pub fn with_turns_of(mut self, stands: &[f64]) -> Self {
        if let Some(base) = self.base
            && let Some(heading) = stands.get(base.yaw)
        {
            let turns = ((heading - self.ready[base.yaw]) / TAU).round();
            self.ready[base.yaw] += turns * TAU;
        }
        self
    }

    /// Returns the variables `q` with the base at a pose.
    pub(in crate::follow) fn standing(&self, q: &[f64], world_from_base: &PlanarPose) -> Vec<f64> {
        let mut q = q.to_vec();
        if let Some(base) = self.base {
            q[base.x] = world_from_base.position.x;
            q[base.y] = world_from_base.position.y;
            q[base.yaw] = world_from_base.heading;
        }
        q
    }

    /// Pose of the base; the origin for a robot without a base.
    pub(in crate::follow) fn base_pose(&self, q: &[f64]) -> PlanarPose {
        self.base
            .map_or(PlanarPose::new(Point2::origin(), 0.0), |base| {
                PlanarPose::new(Point2::new(q[base.x], q[base.y]), q[base.yaw])
            })
    }
}

/// Puts a planar base at the robot's start, and returns the pose of the robot's root in the world.
fn place_base(
    base: Option<PlanarBase>,
    world_from_robot: Option<Pose>,
    ready: &mut [f64],
) -> Result<Pose, FollowError> {
    let world_from_robot = world_from_robot.unwrap_or_else(Pose::identity);
    let Some(base) = base else {
        return Ok(world_from_robot);
    };
    let on_floor = project_to_floor(&world_from_robot)?;
    ready[base.x] = on_floor.position.x;
    ready[base.y] = on_floor.position.y;
    ready[base.yaw] = on_floor.heading;
    Ok(Pose::identity())
}

/// Returns the inverse kinematics of the tool, which prefers the ready posture.
fn make_tool_solver(
    robot: &RobotModel,
    group: &PlanningGroup,
    tip_from_tool: Pose,
    limit_margin: f64,
) -> Result<IkSolver, FollowError> {
    let ik = IkSolver::new(robot, group.base, group.tip, tip_from_tool)?;
    let variables = ik.chain().variables().iter();
    let posture: Vec<f64> = variables.map(|&i| group.ready[i]).collect();
    Ok((ik.with_posture(&posture)?).with_limit_margin(limit_margin)?)
}

/// Finds the link for the tool's second grip, and that grip.
fn find_second_grip(
    robot: &RobotModel,
    srdf: Option<&Srdf>,
    tool: &Tool,
    group: &str,
) -> Result<(LinkId, SecondGrip), FollowError> {
    let grip = tool.second_grip.ok_or_else(|| FollowError::NoSecondGrip {
        tool: tool.name.clone(),
        group: group.to_owned(),
    })?;
    let tip = PlanningGroup::choose(robot, srdf, Some(group))?.tip;
    Ok((tip, grip))
}

/// Brings the second hand to its grip in the ready posture, without contact if there is such a configuration.
fn grip_with_second_hand(
    robot: &RobotModel,
    second: &SecondArm,
    ik: &IkSolver,
    collisions: &CollisionModel,
    ready: &mut Vec<f64>,
) -> Result<(), FollowError> {
    let of = |variables: &[usize]| -> Vec<f64> { variables.iter().map(|&i| ready[i]).collect() };
    let (leading, start) = (of(ik.chain().variables()), of(second.chain().variables()));
    let config = IkConfig::default();
    let mut first = None;
    for seed in 0..SECOND_STARTS {
        let starts: &[&[f64]] = if seed == 0 { &[&start] } else { &[] };
        let held = match second.hold_from_any_start(&leading, starts, seed, &config) {
            Ok(held) => held,
            Err(why) => {
                return Err(FollowError::NoSecondHold {
                    link: robot.links()[second.chain().tip().index()].name.clone(),
                    why,
                });
            }
        };
        let mut q = ready.clone();
        for (&variable, &position) in second.chain().variables().iter().zip(held.iter()) {
            q[variable] = position;
        }
        if collisions.collision(&q, 0.0)?.is_none() {
            *ready = q;
            return Ok(());
        }
        first.get_or_insert(q);
    }
    // The check before the start reports the contact.
    if let Some(first) = first {
        *ready = first;
    }
    Ok(())
}

/// Returns a pose on the floor as a planar pose; an error if it is off the floor.
fn project_to_floor(world_from_robot: &Pose) -> Result<PlanarPose, FollowError> {
    let (roll, pitch, yaw) = world_from_robot.rotation.euler_angles();
    let at = world_from_robot.translation.vector;
    for (what, value) in [("z_m", at.z), ("roll_rad", roll), ("pitch_rad", pitch)] {
        if value.abs() > FLOOR_TOLERANCE {
            return Err(FollowError::OffFloor { what, value });
        }
    }
    Ok(PlanarPose::new(Point2::new(at.x, at.y), yaw))
}

/// Returns the limits of a robot's variables, and of their mimic joints.
fn limits(robot: &RobotModel) -> Result<JointLimits, FollowError> {
    let of_variable = |i: usize| {
        let joint = robot.variable(i);
        // The limits of the paper, where the URDF gives none.
        let usual = match joint.kind {
            JointKind::Prismatic => JointLimit::base(&joint.name),
            _ => JointLimit::arm(&joint.name, f64::NEG_INFINITY, f64::INFINITY),
        };
        limit(joint, [usual.velocity, usual.acceleration])
    };
    let variables: Vec<JointLimit> = (0..robot.dof()).map(of_variable).collect();
    let follower = |joint: &Joint| {
        // Without limits of its own, a mimic joint has those of the variables that drive it.
        let drive = joint.drive.clone();
        let sum = |of: fn(&JointLimit) -> f64| -> f64 {
            let terms = drive.terms.iter();
            terms
                .map(|&(i, factor)| factor.abs() * of(&variables[i]))
                .sum()
        };
        let most = [sum(|limit| limit.velocity), sum(|limit| limit.acceleration)];
        let limit = limit(joint, most);
        FollowerLimit { limit, drive }
    };
    let moved = |joint: &&Joint| joint.drive.terms.iter().any(|&(_, factor)| factor != 0.0);
    let followers = robot.followers().filter(moved).map(follower).collect();
    Ok(JointLimits::new(variables)?.with_followers(followers)?)
}

/// Returns the limits of a joint, with these for velocity and acceleration where it has none.
fn limit(joint: &Joint, [velocity, acceleration]: [f64; 2]) -> JointLimit {
    let range = joint.limits.position;
    JointLimit {
        name: joint.name.clone(),
        lower: range.map_or(f64::NEG_INFINITY, |range| range.lower),
        upper: range.map_or(f64::INFINITY, |range| range.upper),
        velocity: joint.limits.velocity.unwrap_or(velocity),
        acceleration: joint.limits.acceleration.unwrap_or(acceleration),
    }
}
