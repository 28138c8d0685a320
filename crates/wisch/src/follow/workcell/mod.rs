//! Robot, tool and scene as one: what is to move, where it may move, and what is in the way.

mod grasp;
mod group;
pub(super) mod second_arm;
mod target_surface;

pub use group::{PlanarBase, PlanningGroup};
pub use second_arm::{GRIP_TOLERANCE, LEAN_TOLERANCE, SecondArm};

use crate::follow::{FollowError, FollowerLimit, JointLimit, JointLimits, ToolPose};
use crate::geometry::{PlanarPose, Point2, Point3, Polygon, Pose, Vector3};
use crate::plan::Plan;
use crate::represent::{SceneObject, ScenePart, Task};
use crate::robot::{
    CollisionModel, IkConfig, IkSolver, Joint, JointKind, LinkId, READY_STATE, Range, RobotModel,
    Srdf,
};
use grasp::{relaxed, tip_from_tool, without_rim};
use group::{hand_and_holder, planar_base, put_in, standing_links};
use nalgebra::{Translation3, UnitQuaternion};
use std::collections::BTreeSet;
use std::f64::consts::TAU;
pub(in crate::follow) use target_surface::HandBelow;
use target_surface::{TargetSurface, ToolMount, hand_below, is_tool_behind};

/// How far a base may stand off the plane of its floor before that is an error [m, rad].
const FLOOR_TOLERANCE: f64 = 1e-6;
/// Random starts from which the second hand is brought to its grip in the ready posture.
const SECOND_STARTS: u64 = 40;

/// How much less than the margin the sides of the tool keep clear of the scene while it wipes [m]. A corner
/// loses √3 times as much, which is still less than the usual margin.
const TOOL_RIM: f64 = 2.8e-3;

/// What the tool may touch while a motion is checked for collisions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AllowedContact {
    /// Nothing, as in free motion.
    None,
    /// The target surface and the object that carries it.
    Surface,
}

/// Which part of the robot wipes, and where the robot stands.
#[derive(Debug, Clone)]
pub struct WorkcellConfig {
    /// Name of the SRDF's group; `None` takes its first, or without an SRDF the longest chain.
    pub group: Option<String>,
    /// Name of the SRDF's group whose hand holds the tool's second grip; `None` leaves it free.
    pub second_group: Option<String>,
    /// Where the robot stands in the world. For a robot on a planar base: where it starts, in the
    /// plane of the floor.
    pub world_from_robot: Option<Pose>,
    /// The tool in the frame of the link that holds it; `None` takes the tool's grip, or if it has none puts
    /// the rear edge of its upper face at the hand's outermost point.
    pub tip_from_tool: Option<Pose>,
    /// How far the hand leans back from upright over the tool, against its motion [rad].
    pub hand_lean: f64,
    /// How far inside their limits turning joints are kept while the tool is wielded [rad]: a compliant arm is not
    /// exactly where it is wanted.
    pub limit_margin: f64,
}

impl Default for WorkcellConfig {
    /// The first group, the robot at the origin, the hand leaning back by 0.8 rad: so far that a hand as
    /// thick as the tool is wide reaches along obstacles, not so far that it touches the surface. Joints
    /// stay 0.02 rad inside their limits, twice what a torso sags by.
    fn default() -> Self {
        Self {
            group: None,
            second_group: None,
            world_from_robot: None,
            tip_from_tool: None,
            hand_lean: 0.8,
            limit_margin: 0.02,
        }
    }
}

/// A robot with a tool in its hand before a scene.
#[derive(Debug, Clone)]
pub struct Workcell {
    robot: RobotModel,
    world_from_root: Pose,
    tip: LinkId,
    tip_from_tool: Pose,
    ik: IkSolver,
    second: Option<SecondArm>,
    arm_variables: Vec<usize>,
    base: Option<PlanarBase>,
    ready: Vec<f64>,
    collisions: CollisionModel,
    collisions_in_contact: CollisionModel,
    base_collisions: CollisionModel,
    arm_collisions: CollisionModel,
    arm_collisions_in_contact: CollisionModel,
    limits: JointLimits,
    limit_margin: f64,
    obstacles: BTreeSet<String>,
}

impl Workcell {
    /// The robot before the scene of a task, with the task's tool in its hand.
    ///
    /// While it wipes, comes down or lifts off, the tool may touch the target surface and the object that carries it; otherwise
    /// nothing may touch anything. The surface is an obstacle whether or not the scene has an object that carries it, and
    /// the tool keeps out of the space behind it, unless that is where it waits in the ready posture. A surface that lies in
    /// the plane of the floor may be driven on.
    ///
    /// # Errors
    /// A group or link that does not exist, a group whose base hangs on joints that are no planar
    /// base, a planar base that does not stand on its floor, or geometry that no collision check
    /// takes.
    pub fn new(
        robot: RobotModel,
        srdf: Option<&Srdf>,
        task: &Task,
        config: &WorkcellConfig,
    ) -> Result<Self, FollowError> {
        let PlanningGroup {
            base: base_link,
            tip,
            mut ready,
        } = PlanningGroup::choose(&robot, srdf, config.group.as_deref())?;
        put_in(
            &mut ready,
            srdf,
            &format!("{READY_STATE}_{}", task.tool.name),
        );
        let base = planar_base(&robot, base_link)?;
        let world_from_robot = config.world_from_robot.unwrap_or_else(Pose::identity);
        let world_from_root = match base {
            None => world_from_robot,
            Some(base) => {
                let on_floor = on_floor(&world_from_robot)?;
                ready[base.x] = on_floor.position.x;
                ready[base.y] = on_floor.position.y;
                ready[base.yaw] = on_floor.heading;
                Pose::identity()
            }
        };
        let tip_from_tool = (config.tip_from_tool)
            .unwrap_or_else(|| tip_from_tool(&robot, tip, &task.tool, config.hand_lean));
        let ik = IkSolver::new(&robot, base_link, tip, tip_from_tool)?;
        let posture: Vec<f64> = ik.chain().variables().iter().map(|&i| ready[i]).collect();
        let ik = (ik.with_posture(&posture)?).with_limit_margin(config.limit_margin)?;
        let second = match &config.second_group {
            None => None,
            Some(name) => {
                let grip = task
                    .tool
                    .second_grip
                    .ok_or_else(|| FollowError::NoSecondGrip {
                        tool: task.tool.name.clone(),
                        group: name.clone(),
                    })?;
                let tip = PlanningGroup::choose(&robot, srdf, Some(name))?.tip;
                Some(SecondArm::new(
                    &robot,
                    &ik,
                    tip_from_tool,
                    tip,
                    grip,
                    &ready,
                    config.limit_margin,
                )?)
            }
        };
        let mut arm_variables = ik.chain().variables().to_vec();
        if let Some(second) = &second {
            arm_variables.extend_from_slice(second.chain().variables());
        }

        let tool = unlike(&robot, &task.tool.name);
        let bare = CollisionModel::new(&robot, srdf)?;
        // Nothing presses a tool in free motion.
        let relaxed = relaxed(&task.tool.mesh, task.interaction.compression_depth_m)?;
        let mut collisions = bare.clone();
        collisions.attach(&tool, tip, tip_from_tool, &relaxed)?;
        let mut in_contact = bare.clone();
        in_contact.attach(&tool, tip, tip_from_tool, &task.tool.mesh)?;
        // Whole against the robot, without its rim against the scene.
        let mut slim = bare;
        let core = unlike(&robot, &format!("core of {}", task.tool.name));
        let core_mesh = without_rim(&task.tool.mesh, TOOL_RIM)?;
        slim.attach(&tool, tip, tip_from_tool, &task.tool.mesh)?;
        slim.attach(&core, tip, tip_from_tool, &core_mesh)?;
        for link in robot.links() {
            slim.allow(&core, &link.name)?;
        }
        if let Some(second) = &second {
            for link in hand_and_holder(&robot, second.chain().tip()) {
                for model in [&mut collisions, &mut in_contact, &mut slim] {
                    model.allow(&tool, &link)?;
                }
            }
        }
        let on_wheels = base.map_or(vec![], |base| standing_links(&robot, &base));
        let root_from_world = world_from_root.inverse();
        let standing = (task.scene.iter())
            .filter(|object| !matches!(object.part, ScenePart::Robot | ScenePart::Tool));
        let named: Vec<(String, &SceneObject)> = standing
            .map(|object| (unlike(&robot, &object.name), object))
            .collect();
        for model in [&mut collisions, &mut in_contact, &mut slim] {
            let placed = named.iter().map(|(name, object)| {
                let root_from_object = root_from_world * object.world_from_object;
                (name.as_str(), root_from_object, &object.mesh)
            });
            model.add_obstacles(placed)?;
        }
        let tool_mount = ToolMount {
            world_from_root,
            tip,
            tip_from_tool,
        };
        let waits_behind = is_tool_behind(task, &robot.forward_kinematics(&ready)?, &tool_mount);
        let is_taken = |name: &str| {
            let bodies = [tool.as_str(), core.as_str()];
            let mut objects = named.iter().map(|(name, _)| name.as_str());
            bodies.contains(&name) || objects.any(|known| known == name)
        };
        let unused = |name: &str| {
            let mut name = unlike(&robot, name);
            while is_taken(&name) {
                name.push_str(" (target)");
            }
            name
        };
        let models = &mut [&mut collisions, &mut in_contact, &mut slim];
        let surface = TargetSurface::add(task, &root_from_world, &unused, waits_behind, models)?;
        for (name, object) in &named {
            for link in on_wheels.iter().filter(|_| is_below_floor(object)) {
                for model in [&mut collisions, &mut in_contact, &mut slim] {
                    model.allow(link, name)?;
                }
            }
            slim.allow(&tool, name)?;
            if object.part == ScenePart::Carrier {
                in_contact.allow(&tool, name)?;
                slim.allow(&core, name)?;
            }
        }
        let is_floor =
            is_below_floor_plane(&task.surface.world_from_surface, &task.surface.outline);
        for link in on_wheels.iter().filter(|_| is_floor) {
            for model in [&mut collisions, &mut in_contact, &mut slim] {
                model.allow(link, &surface.face)?;
            }
        }
        for name in [Some(&surface.face), surface.behind.as_ref()]
            .into_iter()
            .flatten()
        {
            in_contact.allow(&tool, name)?;
            slim.allow(&tool, name)?;
            slim.allow(&core, name)?;
        }
        if let Some(behind) = &surface.behind {
            for link in robot.links() {
                for model in [&mut collisions, &mut in_contact, &mut slim] {
                    model.allow(&link.name, behind)?;
                }
            }
        }
        let obstacles = (named.into_iter().map(|(name, _)| name))
            .chain([surface.face])
            .chain(surface.behind)
            .collect();
        let arm_collisions = collisions.for_variables(&arm_variables);
        let arm_collisions_in_contact = slim.for_variables(&arm_variables);
        let base_variables = base.map_or(vec![], |base| vec![base.x, base.y, base.yaw]);
        let base_collisions = collisions.for_variables(&base_variables);
        let limits = limits(&robot)?;
        if let Some(second) = &second {
            grip_with_second_hand(&robot, second, &ik, &collisions, &mut ready)?;
        }
        Ok(Self {
            world_from_root,
            tip,
            tip_from_tool,
            ik,
            second,
            arm_variables,
            base,
            ready,
            collisions,
            collisions_in_contact: in_contact,
            base_collisions,
            arm_collisions,
            arm_collisions_in_contact,
            limits,
            limit_margin: config.limit_margin,
            obstacles,
            robot,
        })
    }

    /// The robot as described, without the tool; its n variables are the order of every array of positions.
    pub const fn robot(&self) -> &RobotModel {
        &self.robot
    }

    /// Where the robot's root link is. For a robot on a planar base this is the world's origin.
    pub const fn world_from_root(&self) -> &Pose {
        &self.world_from_root
    }

    /// The link that holds the tool.
    pub const fn tip(&self) -> LinkId {
        self.tip
    }

    /// The tool in the frame of the link that holds it.
    pub const fn tip_from_tool(&self) -> &Pose {
        &self.tip_from_tool
    }

    /// Inverse kinematics of the tool, from the group's base.
    pub const fn ik(&self) -> &IkSolver {
        &self.ik
    }

    /// The arm whose hand holds the tool as well, if one does.
    pub const fn second(&self) -> Option<&SecondArm> {
        self.second.as_ref()
    }

    /// For each variable of the arm its position among the robot's: those of the group, then those of the
    /// second arm.
    pub fn arm_variables(&self) -> &[usize] {
        &self.arm_variables
    }

    /// The planar base under the group, if there is one.
    pub const fn base(&self) -> Option<PlanarBase> {
        self.base
    }

    /// Where the robot starts: all n variables [rad or m].
    pub fn ready(&self) -> &[f64] {
        &self.ready
    }

    /// Robot, tool and scene with all pairs that may not touch in free motion.
    pub const fn collisions(&self) -> &CollisionModel {
        &self.collisions
    }

    /// What may not touch while the tool touches this.
    pub const fn all_collisions(&self, allowed: AllowedContact) -> &CollisionModel {
        match allowed {
            AllowedContact::None => &self.collisions,
            AllowedContact::Surface => &self.collisions_in_contact,
        }
    }

    /// What may not touch, as far as the base's variables can change it.
    pub(in crate::follow) const fn base_collisions(&self) -> &CollisionModel {
        &self.base_collisions
    }

    /// What may not touch, as far as the group's variables can change it.
    pub const fn arm_collisions(&self, allowed: AllowedContact) -> &CollisionModel {
        match allowed {
            AllowedContact::None => &self.arm_collisions,
            AllowedContact::Surface => &self.arm_collisions_in_contact,
        }
    }

    /// The range of a joint that is kept to, inside its limits by [`WorkcellConfig::limit_margin`]; `None` for one
    /// without limits.
    pub(crate) fn range_kept(&self, joint: &Joint) -> Option<Range> {
        let limits = joint.limits.position?;
        let slides = joint.kind == JointKind::Prismatic;
        Some(limits.narrowed(if slides { 0.0 } else { self.limit_margin }))
    }

    /// Position, velocity and acceleration limits of all n variables, in the order of the robot's, and of the
    /// joints that follow them.
    pub const fn limits(&self) -> &JointLimits {
        &self.limits
    }

    /// Whether a name in a contact is one of the scene's objects.
    pub(in crate::follow) fn is_obstacle(&self, name: &str) -> bool {
        self.obstacles.contains(name)
    }

    /// The part of the hand that would be below the target surface wherever the tool touches it at the nodes of a plan; `None`
    /// where the hand is free of it somewhere.
    pub(in crate::follow) fn hand_below(
        &self,
        task: &Task,
        plan: &Plan,
    ) -> Result<Option<HandBelow>, FollowError> {
        let tool = ToolMount {
            world_from_root: self.world_from_root,
            tip: self.tip,
            tip_from_tool: self.tip_from_tool,
        };
        let kinematics = self.robot.forward_kinematics(&self.ready)?;
        Ok(hand_below(task, plan, &self.robot, &kinematics, &tool))
    }

    /// Pose of the tool in the world where it is said to be on the surface.
    pub fn world_from_tool(task: &Task, pose: &ToolPose) -> Pose {
        let PlanarPose { position, heading } = pose.surface_from_tool;
        let upright = Pose::from_parts(
            Translation3::new(position.x, position.y, pose.height),
            UnitQuaternion::from_axis_angle(&Vector3::z_axis(), heading),
        );
        let lean = task.tool.tilt.map_or_else(UnitQuaternion::identity, |t| {
            UnitQuaternion::from_axis_angle(&t.axis_in_tool, pose.tilt)
        });
        task.surface.world_from_surface * upright * lean
    }

    /// Counts the whole turns of a base on wheels as the robot does, so that no motion begins with turns that bring it
    /// nowhere.
    ///
    /// `stands`: all n variables as the robot was measured [rad or m].
    pub fn with_turns_of(mut self, stands: &[f64]) -> Self {
        if let Some(base) = self.base
            && let Some(heading) = stands.get(base.yaw)
        {
            let turns = ((heading - self.ready[base.yaw]) / TAU).round();
            self.ready[base.yaw] += turns * TAU;
        }
        self
    }

    /// The variables with the base standing somewhere.
    pub(in crate::follow) fn standing(&self, q: &[f64], world_from_base: &PlanarPose) -> Vec<f64> {
        let mut q = q.to_vec();
        if let Some(base) = self.base {
            q[base.x] = world_from_base.position.x;
            q[base.y] = world_from_base.position.y;
            q[base.yaw] = world_from_base.heading;
        }
        q
    }

    /// Where the base stands; the origin for a robot without one.
    pub(in crate::follow) fn base_pose(&self, q: &[f64]) -> PlanarPose {
        self.base
            .map_or(PlanarPose::new(Point2::origin(), 0.0), |base| {
                PlanarPose::new(Point2::new(q[base.x], q[base.y]), q[base.yaw])
            })
    }
}

/// Brings the second hand to its grip in the ready posture: where it touches nothing, if there is such a way.
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
        let held = match second.held_anyhow(&leading, starts, seed, &config) {
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
    // What it touches is told when it is to start.
    if let Some(first) = first {
        *ready = first;
    }
    Ok(())
}

/// Whether no point of an outline is above the floor on which the base moves.
fn is_below_floor_plane(world_from_surface: &Pose, outline: &Polygon) -> bool {
    let mut corners = outline.outer().iter();
    corners.all(|p| (world_from_surface * Point3::new(p.x, p.y, 0.0)).z <= FLOOR_TOLERANCE)
}

/// Whether no point of an object is above the floor on which the base moves.
fn is_below_floor(object: &SceneObject) -> bool {
    let vertices = object.mesh.vertices().iter();
    let heights = vertices.map(|vertex| (object.world_from_object * vertex).z);
    heights.fold(f64::NEG_INFINITY, f64::max) <= FLOOR_TOLERANCE
}

fn on_floor(world_from_robot: &Pose) -> Result<PlanarPose, FollowError> {
    let (roll, pitch, yaw) = world_from_robot.rotation.euler_angles();
    let at = world_from_robot.translation.vector;
    for (what, value) in [("z_m", at.z), ("roll_rad", roll), ("pitch_rad", pitch)] {
        if value.abs() > FLOOR_TOLERANCE {
            return Err(FollowError::OffFloor { what, value });
        }
    }
    Ok(PlanarPose::new(Point2::new(at.x, at.y), yaw))
}

/// A name that no link has.
fn unlike(robot: &RobotModel, name: &str) -> String {
    if robot.links().iter().any(|link| link.name == name) {
        format!("{name} (scene)")
    } else {
        name.to_owned()
    }
}

fn limits(robot: &RobotModel) -> Result<JointLimits, FollowError> {
    let of_variable = |i: usize| {
        let joint = robot.variable(i);
        // The paper's, where the URDF gives none.
        let usual = match joint.kind {
            JointKind::Prismatic => JointLimit::base(&joint.name),
            _ => JointLimit::arm(&joint.name, f64::NEG_INFINITY, f64::INFINITY),
        };
        limit(joint, [usual.velocity, usual.acceleration])
    };
    let variables: Vec<JointLimit> = (0..robot.dof()).map(of_variable).collect();
    let follower = |joint: &Joint| {
        // Without limits of its own it has those of what it follows.
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

/// The limits of a joint, with these of velocity and acceleration where it has none.
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
