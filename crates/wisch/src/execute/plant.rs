//! The simulated world: the robot as a multibody, its compliant tool, the real surface and the scene.

use super::{ExecuteConfig, ExecuteError};
use crate::follow::Workcell;
use crate::geometry::{Mesh, Point2, Point3, Pose, Vector3};
use crate::represent::{Reality, ScenePart, Task};
use crate::robot::{ArticulatedJoint, Articulation, ArticulationState, Body, Collision, Shape};
use nalgebra::{DMatrix, DVector, Matrix3, Translation3};
use petgraph::unionfind::UnionFind;
use rapier3d_f64::dynamics::{
    GenericJoint, MassProperties, MultibodyJointHandle, PrismaticJointBuilder,
    RevoluteJointBuilder, RigidBodyBuilder, RigidBodyHandle, SpringCoefficients,
};
use rapier3d_f64::geometry::{
    ColliderBuilder, ColliderHandle, Group, InteractionGroups, InteractionTestMode, SharedShape,
};
use rapier3d_f64::math as engine;
use rapier3d_f64::pipeline::PhysicsWorld;
use std::collections::BTreeMap;

/// Acceleration of free fall [m/s²].
pub(super) const GRAVITY: Vector3 = Vector3::new(0.0, 0.0, -9.81);

/// A length that is small in this world [m]: that of grains. With the engine's usual metre, its broad
/// phase would pair everything with everything.
const LENGTH_UNIT: f64 = 0.01;
/// Distance from which on contacts are prepared [m].
const PREDICTION: f64 = 2e-3;
/// How far bodies may sink into each other [m].
const ALLOWED_ERROR: f64 = 1e-4;
/// How fast the engine may push bodies apart [m/s].
const CORRECTION: f64 = 0.5;
/// Stiffness and damping of contacts: natural frequency [Hz] and damping ratio [1].
const CONTACT: [f64; 2] = [240.0, 10.0];
const SOLVER_ITERATIONS: usize = 1;
const CONTACT_ITERATIONS: usize = 4;
/// Thickness of the surface, and of the tool's plate at least and at most [m]: so much that neither is ever
/// pushed out on the far side.
const SURFACE_THICKNESS: f64 = 0.1;
const PLATE_THICKNESS: [f64; 2] = [0.01, 0.03];
/// Up to this many times its compression depth a tool gives way.
const YIELDING: f64 = 2.0;
/// Mass of the tool and of the part of it that gives way [kg].
const TOOL_MASS: f64 = 0.1;
const PLATE_MASS: f64 = 0.05;
/// Mass of a link that only stands between two joints of the tool [kg].
const LINK_MASS: f64 = 2e-3;
/// Damping of the tool's compliance, as a damping ratio of the mass that an arm presses with [1, kg].
const TOOL_DAMPING: [f64; 2] = [0.2, 5.0];
/// Least stiffness against rocking, for tools as narrow as a blade [Nm/rad].
const LEAST_ROCKING: f64 = 0.3;
/// Natural frequency of joints that follow others and of drives that hold a position [rad/s].
const COUPLING_RATE: f64 = 250.0;
const SERVO_RATE: f64 = 100.0;

const ROBOT: Group = Group::GROUP_1;
const SCENE: Group = Group::GROUP_2;
const SURFACE: Group = Group::GROUP_3;
const PLATE: Group = Group::GROUP_4;
const TOOL: Group = Group::GROUP_5;
const GRAIN: Group = Group::GROUP_6;

/// How the tool gives way: the plate against its frame at rest.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Compression {
    /// How far the plate is pushed towards the hand [m].
    pub depth: f64,
    /// How far it is rocked about the tool's x and y [rad].
    pub rocking: [f64; 2],
}

impl Compression {
    /// Pressure at a place under the tool, over that of a compression by `nominal_depth` [m].
    pub fn pressure(&self, under: Point2, nominal_depth: f64) -> f64 {
        let [about_x, about_y] = self.rocking;
        (self.depth + about_x * under.y - about_y * under.x) / nominal_depth
    }
}

/// A moving joint in the engine.
#[derive(Debug, Clone, Copy)]
struct Link {
    body: RigidBodyHandle,
    joint: usize,
    /// Position of its velocity in the multibody's.
    at: usize,
    /// The body that it turns against, unless that stands in the world.
    parent: Option<RigidBodyHandle>,
    slides: bool,
}

/// The world of one execution.
pub(super) struct Plant {
    pub world: PhysicsWorld,
    articulation: Articulation,
    multibody: MultibodyJointHandle,
    links: Vec<Link>,
    /// Links of the tool's compliance in the multibody: depth, rocking about x, about y.
    foam: [usize; 3],
    /// Stiffness and damping of its depth.
    foam_spring: [f64; 2],
    plate: RigidBodyHandle,
    hand: RigidBodyHandle,
    plate_collider: ColliderHandle,
    surface_collider: ColliderHandle,
    normal: Vector3,
    /// Of each own variable: stiffness and damping of the drive that holds it, if it is none of the
    /// compliant ones.
    servos: Vec<Option<[f64; 2]>>,
    couplings: Vec<Coupling>,
}

/// A joint that follows others, held to them by a stiff spring.
#[derive(Debug, Clone, Copy)]
struct Coupling {
    link: usize,
    stiffness: f64,
    damping: f64,
}

pub(super) fn to_engine(pose: &Pose) -> engine::Pose {
    (*pose).into()
}

pub(super) fn vector(v: &Vector3) -> engine::Vector {
    engine::Vector::new(v.x, v.y, v.z)
}

/// Grains meet the surface and each other; what the tool does to them is a force of its own.
pub(super) fn groups_of_grains() -> InteractionGroups {
    groups(GRAIN, SURFACE | GRAIN)
}

fn groups(memberships: Group, filter: Group) -> InteractionGroups {
    InteractionGroups::new(memberships, filter, InteractionTestMode::And)
}

impl Plant {
    /// The world in which `articulation` stands at `q`, its variables `compliant` driven by efforts and
    /// the others by drives that hold them.
    pub fn new(
        cell: &Workcell,
        task: &Task,
        reality: &Reality,
        articulation: &Articulation,
        compliant: &[usize],
        q: &[f64],
        config: &ExecuteConfig,
    ) -> Result<Self, ExecuteError> {
        let mut world = PhysicsWorld::new();
        world.gravity = vector(&GRAVITY);
        let parameters = &mut world.integration_parameters;
        parameters.dt = config.period;
        parameters.length_unit = LENGTH_UNIT;
        parameters.normalized_prediction_distance = PREDICTION / LENGTH_UNIT;
        parameters.normalized_allowed_linear_error = ALLOWED_ERROR / LENGTH_UNIT;
        parameters.normalized_max_corrective_velocity = CORRECTION / LENGTH_UNIT;
        // Each further iteration computes the robot's mass matrix anew; contacts are few and light.
        parameters.num_solver_iterations = SOLVER_ITERATIONS;
        parameters.num_internal_pgs_iterations = CONTACT_ITERATIONS;
        let [frequency, ratio] = CONTACT;
        parameters.static_contact_softness = SpringCoefficients::new(frequency, ratio);
        parameters.contact_softness = SpringCoefficients::new(frequency / 2.0, ratio);

        let ground = world.insert_body(RigidBodyBuilder::fixed());
        let mut bodies: Vec<RigidBodyHandle> = Vec::new();
        let mut handle = None;
        for joint in articulation.joints() {
            let body = world.insert_body(
                RigidBodyBuilder::dynamic()
                    .additional_mass_properties(mass_properties(&joint.body))
                    .gyroscopic_forces_enabled(true)
                    .can_sleep(false),
            );
            let parent = joint.parent.map_or(ground, |p| bodies[p]);
            let frame = to_engine(&joint.parent_from_joint);
            let mut data: GenericJoint = if joint.slides {
                PrismaticJointBuilder::new(engine::Vector::Z).build().into()
            } else {
                RevoluteJointBuilder::new(engine::Vector::Z).build().into()
            };
            // Both builders turn their frames so that the joint's axis is the engine's x.
            data.local_frame1 = frame * data.local_frame1;
            handle = world.insert_multibody_joint(parent, body, data);
            bodies.push(body);
        }
        let (carrier, joint_from_tip) = articulation.carrier(cell.tip());
        let (Some(carrier), Some(_)) = (carrier, handle) else {
            return Err(ExecuteError::NothingMoves {
                robot: cell.robot().name().to_owned(),
            });
        };
        let joint_from_tool = joint_from_tip * cell.tip_from_tool();
        let hand = bodies[carrier];
        let (plate, foam_bodies, multibody) = compliance(&mut world, hand, &joint_from_tool, task)?;

        let plate_shape = prism(
            task.tool.footprint.edges().map(|edge| edge.start),
            0.0,
            plate_thickness(task),
        );
        let plate_shape = plate_shape.ok_or(ExecuteError::NoFootprint)?;
        let plate_collider = world.insert_collider(
            ColliderBuilder::new(plate_shape)
                .density(0.0)
                .friction(reality.friction)
                .collision_groups(groups(PLATE, SURFACE)),
            Some(plate),
        );
        let world_from_real = task.surface.world_from_surface * reality.believed_from_real;
        let slab = prism(
            task.surface.outline.outer().iter().copied(),
            -SURFACE_THICKNESS,
            0.0,
        );
        let surface_collider = world.insert_collider(
            ColliderBuilder::new(slab.ok_or(ExecuteError::NoSurface)?)
                .position(to_engine(&world_from_real))
                .friction(reality.friction)
                .collision_groups(groups(SURFACE, PLATE | GRAIN)),
            None,
        );
        add_scene(&mut world, task, reality);
        add_shapes(&mut world, cell, task, articulation, compliant, &bodies);

        let mut plant = Self {
            links: Vec::new(),
            foam: [0; 3],
            foam_spring: foam_springs(task)[0],
            plate,
            hand,
            plate_collider,
            surface_collider,
            normal: world_from_real * Vector3::z(),
            servos: vec![None; articulation.dof()],
            couplings: Vec::new(),
            articulation: articulation.clone(),
            multibody,
            world,
        };
        plant.place(&bodies, &foam_bodies, q)?;
        plant.set_drives(compliant, q, task);
        Ok(plant)
    }

    /// Brings the multibody to its start, and remembers where its joints are kept.
    fn place(
        &mut self,
        bodies: &[RigidBodyHandle],
        foam: &[RigidBodyHandle; 3],
        q: &[f64],
    ) -> Result<(), ExecuteError> {
        let Some((multibody, _)) = self.world.multibody_joints.get_mut(self.multibody) else {
            return Err(ExecuteError::NoSurface);
        };
        // The first pass tells the engine that the root is fixed, which takes its six degrees away.
        multibody.forward_kinematics(&self.world.bodies, false);
        let mut displacement = vec![0.0; multibody.ndofs()];
        for (joint, body) in bodies.iter().enumerate() {
            let found = multibody
                .links()
                .find(|link| link.rigid_body_handle() == *body);
            if let Some(link) = found {
                let at = link.assembly_id();
                displacement[at] = self.articulation.joints()[joint].position(q);
                self.links.push(Link {
                    body: *body,
                    joint: link.link_id(),
                    at,
                    parent: self.articulation.joints()[joint].parent.map(|p| bodies[p]),
                    slides: self.articulation.joints()[joint].slides,
                });
            }
        }
        for (at, body) in self.foam.iter_mut().zip(foam) {
            let found = multibody
                .links()
                .find(|link| link.rigid_body_handle() == *body);
            *at = found.map_or(0, |link| link.link_id());
        }
        multibody.damping_mut().fill(0.0);
        multibody.apply_displacements(&displacement);
        multibody.forward_kinematics(&self.world.bodies, false);
        multibody.update_rigid_bodies(&mut self.world.bodies, true);
        Ok(())
    }

    /// Springs: of the tool, of the drives that hold, of the joints that follow others.
    fn set_drives(&mut self, compliant: &[usize], q: &[f64], task: &Task) {
        let mut state = self.articulation.state();
        let still = vec![0.0; self.articulation.dof()];
        self.articulation.evaluate(&mut state, q, &still, GRAVITY);
        let joints = self.articulation.joint_mass_matrix(&state);
        let Some((multibody, _)) = self.world.multibody_joints.get_mut(self.multibody) else {
            return;
        };
        for (i, joint) in self.articulation.joints().iter().enumerate() {
            if joint.is_variable() {
                let variable = joint.terms[0].0;
                if compliant.contains(&variable) {
                    continue;
                }
                let inertia = state.mass_matrix()[(variable, variable)];
                let stiffness = inertia * SERVO_RATE * SERVO_RATE;
                let damping = 2.0 * inertia * SERVO_RATE;
                self.servos[variable] = Some([stiffness, damping]);
                multibody.damping_mut()[self.links[i].at] = damping;
            } else {
                let inertia = coupled_inertia(&self.articulation, &joints, i);
                self.couplings.push(Coupling {
                    link: i,
                    stiffness: inertia * COUPLING_RATE * COUPLING_RATE,
                    damping: 2.0 * inertia * COUPLING_RATE,
                });
            }
        }
        let springs = foam_springs(task);
        for (at, [stiffness, damping]) in self.foam.into_iter().zip(springs) {
            let Some(link) = multibody.link_mut(at) else {
                continue;
            };
            let axis = free_axis(link.joint.data.locked_axes.bits());
            link.joint.set_spring(axis, stiffness, 0.0);
            let dof = link.assembly_id();
            multibody.damping_mut()[dof] = damping;
        }
    }

    /// Positions and velocities of the articulation's variables.
    pub fn read(&self, q: &mut [f64], qd: &mut [f64]) {
        let Some((multibody, _)) = self.world.multibody_joints.get(self.multibody) else {
            return;
        };
        let velocities = multibody.generalized_velocity();
        for (link, joint) in self.links.iter().zip(self.articulation.joints()) {
            if !joint.is_variable() {
                continue;
            }
            let variable = joint.terms[0].0;
            q[variable] = self.coordinate(link);
            qd[variable] = velocities[link.at];
        }
    }

    fn coordinate(&self, link: &Link) -> f64 {
        let multibody = self.world.multibody_joints.get(self.multibody);
        let found = multibody.and_then(|(multibody, _)| multibody.link(link.joint));
        found.map_or(0.0, |found| {
            found.joint.coords()[free_axis(found.joint.data.locked_axes.bits())]
        })
    }

    /// Lets efforts act on the compliant variables and moves on the targets of the others, over one period.
    pub fn drive(
        &mut self,
        state: &ArticulationState,
        compliant: &[usize],
        efforts: &[f64],
        target_q: &[f64],
        target_qd: &[f64],
        joint_efforts: &mut [f64],
    ) {
        for link in &self.links {
            let body = &mut self.world.bodies[link.body];
            body.reset_forces(false);
            body.reset_torques(false);
        }
        self.couple(state, joint_efforts);
        for (i, joint) in self.articulation.joints().iter().enumerate() {
            if joint.is_variable() {
                let variable = joint.terms[0].0;
                joint_efforts[i] += match compliant.iter().position(|&c| c == variable) {
                    Some(k) => efforts[k],
                    // What holds against gravity; the spring does the rest.
                    None => state.bias()[variable],
                };
            }
        }
        for (i, link) in self.links.iter().enumerate() {
            let axis = vector(&(state.axis(i) * joint_efforts[i]));
            let origin = state.origin(i);
            if link.slides {
                let at = vector(&origin);
                self.world.bodies[link.body].add_force_at_point(axis, at, true);
                if let Some(parent) = link.parent {
                    self.world.bodies[parent].add_force_at_point(-axis, at, true);
                }
            } else {
                self.world.bodies[link.body].add_torque(axis, true);
                if let Some(parent) = link.parent {
                    self.world.bodies[parent].add_torque(-axis, true);
                }
            }
        }
        let Some((multibody, _)) = self.world.multibody_joints.get_mut(self.multibody) else {
            return;
        };
        for (link, joint) in self.links.iter().zip(self.articulation.joints()) {
            if !joint.is_variable() {
                continue;
            }
            let variable = joint.terms[0].0;
            let (Some([stiffness, damping]), Some(found)) =
                (self.servos[variable], multibody.link_mut(link.joint))
            else {
                continue;
            };
            // The damper brakes against standing still: the spring's rest runs ahead by what that takes.
            let ahead = target_qd[variable] * damping / stiffness;
            let axis = free_axis(found.joint.data.locked_axes.bits());
            found
                .joint
                .set_spring(axis, stiffness, target_q[variable] + ahead);
        }
    }

    /// Efforts that hold following joints to those that they follow, and what these feel of it.
    fn couple(&self, state: &ArticulationState, joint_efforts: &mut [f64]) {
        joint_efforts.fill(0.0);
        let Some((multibody, _)) = self.world.multibody_joints.get(self.multibody) else {
            return;
        };
        let velocities = multibody.generalized_velocity();
        for coupling in &self.couplings {
            let joint = &self.articulation.joints()[coupling.link];
            let mut error = self.coordinate(&self.links[coupling.link]) - joint.offset;
            let mut rate = velocities[self.links[coupling.link].at];
            for &(variable, factor) in &joint.terms {
                if let Some(k) = self.link_of(variable) {
                    error -= factor * self.coordinate(&self.links[k]);
                    rate -= factor * velocities[self.links[k].at];
                }
            }
            let effort = state.joint_efforts()[coupling.link]
                - coupling.stiffness * error
                - coupling.damping * rate;
            joint_efforts[coupling.link] += effort;
            for &(variable, factor) in &joint.terms {
                if let Some(k) = self.link_of(variable) {
                    joint_efforts[k] -= factor * effort;
                }
            }
        }
    }

    fn link_of(&self, variable: usize) -> Option<usize> {
        let joints = self.articulation.joints().iter();
        joints
            .enumerate()
            .find(|(_, joint)| joint.is_variable() && joint.terms[0].0 == variable)
            .map(|(i, _)| i)
    }

    /// Pushes the hand at a point in the world during the next period.
    pub fn push(&mut self, force: &Vector3, at: &Point3) {
        let body = &mut self.world.bodies[self.hand];
        body.add_force_at_point(vector(force), vector(&at.coords), true);
    }

    /// Lets one period pass.
    pub fn step(&mut self) {
        self.world.step();
    }

    /// Sets the friction between tool and surface.
    pub fn set_friction(&mut self, friction: f64) {
        for handle in [self.plate_collider, self.surface_collider] {
            if let Some(collider) = self.world.colliders.get_mut(handle) {
                collider.set_friction(friction);
            }
        }
    }

    /// Force of the surface on the tool along the surface's normal, by how much the tool gives way [N]: the
    /// truth.
    pub fn contact_force(&self) -> f64 {
        let Some((multibody, _)) = self.world.multibody_joints.get(self.multibody) else {
            return 0.0;
        };
        let rate = multibody.link(self.foam[0]).map_or(0.0, |link| {
            multibody.generalized_velocity()[link.assembly_id()]
        });
        let [stiffness, damping] = self.foam_spring;
        (stiffness * self.compression().depth + damping * rate).max(0.0)
    }

    /// How the tool gives way.
    pub fn compression(&self) -> Compression {
        let Some((multibody, _)) = self.world.multibody_joints.get(self.multibody) else {
            return Compression::default();
        };
        let at = |link: usize| {
            multibody.link(link).map_or(0.0, |link| {
                link.joint.coords()[free_axis(link.joint.data.locked_axes.bits())]
            })
        };
        Compression {
            depth: at(self.foam[0]),
            rocking: [at(self.foam[1]), at(self.foam[2])],
        }
    }

    /// The underside of the tool in the world.
    pub fn world_from_plate(&self) -> Pose {
        (*self.world.bodies[self.plate].position()).into()
    }

    /// Velocity of a point of the tool's underside in the world [m/s].
    pub fn plate_velocity(&self, at: &Point3) -> Vector3 {
        let v = self.world.bodies[self.plate].velocity_at_point(vector(&at.coords));
        Vector3::new(v.x, v.y, v.z)
    }

    /// Outward normal of the real surface in the world.
    pub const fn normal(&self) -> Vector3 {
        self.normal
    }
}

/// The inertia that stands against closing the gap between a following joint and those that it follows.
fn coupled_inertia(articulation: &Articulation, mass: &DMatrix<f64>, follower: usize) -> f64 {
    let mut gap = DVector::zeros(mass.nrows());
    gap[follower] = 1.0;
    for &(variable, factor) in &articulation.joints()[follower].terms {
        let leads = |j: &ArticulatedJoint| j.is_variable() && j.terms[0].0 == variable;
        if let Some(leader) = articulation.joints().iter().position(leads) {
            gap[leader] -= factor;
        }
    }
    let accelerations = mass.clone().cholesky().map(|mass| mass.solve(&gap));
    accelerations.map_or(0.0, |a| 1.0 / gap.dot(&a).max(f64::MIN_POSITIVE))
}

/// The one free axis of a joint, in the engine's order: linear, then angular.
fn free_axis(locked: u8) -> usize {
    (!locked).trailing_zeros() as usize
}

/// Thickness of the tool's plate [m]: a tool that gives way far comes down the deeper.
fn plate_thickness(task: &Task) -> f64 {
    let [least, most] = PLATE_THICKNESS;
    (2.0 * task.interaction.compression_depth_m).clamp(least, most)
}

/// Stiffness and damping of the tool's compliance: in depth, and rocking about its x and y, as a bed of
/// springs under the whole footprint has them.
fn foam_springs(task: &Task) -> [[f64; 2]; 3] {
    let interaction = &task.interaction;
    let stiffness = interaction.press_force_n / interaction.compression_depth_m;
    let [ratio, mass] = TOOL_DAMPING;
    let damping = 2.0 * ratio * (stiffness * mass).sqrt();
    let size = (task.tool.footprint.bounds()).map_or(task.tool.area_of_effect, |b| b.size());
    // Mean square distance from the axis over a rectangle.
    let about_x = (stiffness * size.y * size.y / 12.0).max(LEAST_ROCKING);
    let about_y = (stiffness * size.x * size.x / 12.0).max(LEAST_ROCKING);
    let share = damping / stiffness;
    [
        [stiffness, damping],
        [about_x, about_x * share],
        [about_y, about_y * share],
    ]
}

/// The tool's underside on its springs: a plate that slides along the tool's z and rocks about x and y.
fn compliance(
    world: &mut PhysicsWorld,
    hand: RigidBodyHandle,
    joint_from_tool: &Pose,
    task: &Task,
) -> Result<(RigidBodyHandle, [RigidBodyHandle; 3], MultibodyJointHandle), ExecuteError> {
    let depth = task.interaction.compression_depth_m;
    // At nominal force the plate lies at the tool centre point.
    let joint_from_rest = joint_from_tool * Translation3::new(0.0, 0.0, -depth);
    let size = (task.tool.footprint.bounds()).map_or(task.tool.area_of_effect, |b| b.size());
    let (x, y, z) = (size.x, size.y, plate_thickness(task));
    let inertia = |mass: f64| {
        let about = |a: f64, b: f64| mass / 12.0 * (a * a + b * b) + 1e-6;
        engine::Vector::new(about(y, z), about(x, z), about(x, y))
    };
    let mut body = |mass: f64| {
        world.insert_body(
            RigidBodyBuilder::dynamic()
                .additional_mass_properties(MassProperties::new(
                    engine::Vector::ZERO,
                    mass,
                    inertia(mass),
                ))
                .can_sleep(false),
        )
    };
    let bodies = [body(LINK_MASS), body(LINK_MASS), body(PLATE_MASS)];
    let mut slide: GenericJoint = PrismaticJointBuilder::new(engine::Vector::Z).build().into();
    slide.local_frame1 = to_engine(&joint_from_rest) * slide.local_frame1;
    let about_x: GenericJoint = RevoluteJointBuilder::new(engine::Vector::X).build().into();
    let about_y: GenericJoint = RevoluteJointBuilder::new(engine::Vector::Y).build().into();
    world.insert_multibody_joint(hand, bodies[0], slide);
    world.insert_multibody_joint(bodies[0], bodies[1], about_x);
    let handle = world.insert_multibody_joint(bodies[1], bodies[2], about_y);
    let handle = handle.ok_or(ExecuteError::NoFootprint)?;
    Ok((bodies[2], bodies, handle))
}

/// The load that the tool is to the robot, in the frame of the link that holds it.
pub(super) fn tool_load(cell: &Workcell, task: &Task) -> Body {
    let mass = TOOL_MASS + PLATE_MASS + 2.0 * LINK_MASS;
    let size = task.tool.area_of_effect;
    let about = |a: f64, b: f64| mass / 12.0 * (a * a + b * b) + 1e-6;
    let depth = size.min();
    Body {
        mass,
        center_in_link: cell.tip_from_tool() * Point3::origin(),
        inertia_about_center: Matrix3::from_diagonal(&Vector3::new(
            about(size.y, depth),
            about(size.x, depth),
            about(size.x, size.y),
        )),
    }
}

fn mass_properties(body: &Body) -> MassProperties {
    let m = &body.inertia_about_center;
    let column = |i: usize| engine::Vector::new(m[(0, i)], m[(1, i)], m[(2, i)]);
    MassProperties::with_inertia_matrix(
        vector(&body.center_in_link.coords),
        body.mass,
        engine::Matrix::from_cols(column(0), column(1), column(2)),
    )
}

/// The convex hull of points in a plane, extruded along z.
fn prism(points: impl Iterator<Item = Point2>, from: f64, to: f64) -> Option<SharedShape> {
    let corners: Vec<engine::Vector> = points
        .flat_map(|p| [from, to].map(|z| engine::Vector::new(p.x, p.y, z)))
        .collect();
    SharedShape::convex_hull(&corners)
}

fn add_scene(world: &mut PhysicsWorld, task: &Task, reality: &Reality) {
    // What is mislocated is the robot before the scene: everything is off by the same.
    let world_from_surface = task.surface.world_from_surface;
    let moved = world_from_surface * reality.believed_from_real * world_from_surface.inverse();
    for object in &task.scene {
        let filter = match object.part {
            ScenePart::Robot | ScenePart::Tool => continue,
            ScenePart::Carrier => ROBOT,
            ScenePart::Obstacle => ROBOT | TOOL,
        };
        if let Some(shape) = trimesh(&object.mesh) {
            let collider = ColliderBuilder::new(shape)
                .position(to_engine(&(moved * object.world_from_object)))
                .collision_groups(groups(SCENE, filter));
            world.insert_collider(collider, None);
        }
    }
}

fn trimesh(mesh: &Mesh) -> Option<SharedShape> {
    let vertices = mesh.vertices().iter().map(|p| vector(&p.coords)).collect();
    SharedShape::trimesh(vertices, mesh.triangles().to_vec()).ok()
}

fn hull(mesh: &Mesh) -> Option<SharedShape> {
    let points: Vec<_> = mesh.vertices().iter().map(|p| vector(&p.coords)).collect();
    SharedShape::convex_hull(&points)
}

/// The robot's shapes on its bodies, and the tool's mesh in its hand.
fn add_shapes(
    world: &mut PhysicsWorld,
    cell: &Workcell,
    task: &Task,
    articulation: &Articulation,
    compliant: &[usize],
    bodies: &[RigidBodyHandle],
) {
    let robot = cell.robot();
    for (link, at) in robot.links().iter().zip(0..) {
        let Ok(id) = robot.link(&robot.links()[at].name) else {
            continue;
        };
        let (Some(joint), joint_from_link) = articulation.carrier(id) else {
            continue;
        };
        // What stands on the floor is held by drives, and wheels are not simulated.
        if !is_compliant(articulation, compliant, joint) {
            continue;
        }
        for Collision {
            link_from_shape,
            shape,
        } in &link.collision
        {
            let Some(shape) = engine_shape(shape) else {
                continue;
            };
            let collider = ColliderBuilder::new(shape)
                .position(to_engine(&(joint_from_link * link_from_shape)))
                .density(0.0)
                .collision_groups(groups(ROBOT, SCENE));
            world.insert_collider(collider, Some(bodies[joint]));
        }
    }
    let (Some(joint), joint_from_tip) = articulation.carrier(cell.tip()) else {
        return;
    };
    // The part that gives way is the plate's.
    let yielding = YIELDING * task.interaction.compression_depth_m;
    for part in parts(&task.tool.mesh) {
        let firm = part
            .iter()
            .map(|p| engine::Vector::new(p.x, p.y, p.z.max(yielding)));
        let Some(shape) = SharedShape::convex_hull(&firm.collect::<Vec<_>>()) else {
            continue;
        };
        let collider = ColliderBuilder::new(shape)
            .position(to_engine(&(joint_from_tip * cell.tip_from_tool())))
            .density(0.0)
            .collision_groups(groups(TOOL, SCENE));
        world.insert_collider(collider, Some(bodies[joint]));
    }
}

/// Whether a joint, or one that it hangs on, is driven by the controller.
fn is_compliant(articulation: &Articulation, compliant: &[usize], joint: usize) -> bool {
    let mut at = Some(joint);
    while let Some(i) = at {
        let joint = &articulation.joints()[i];
        if joint
            .terms
            .iter()
            .any(|(variable, _)| compliant.contains(variable))
        {
            return true;
        }
        at = joint.parent;
    }
    false
}

/// The vertices of each connected part of a mesh: a stick does not make a cone of its broom.
fn parts(mesh: &Mesh) -> Vec<Vec<Point3>> {
    let key = |p: &Point3| [p.x, p.y, p.z].map(f64::to_bits);
    let mut places: BTreeMap<[u64; 3], usize> = BTreeMap::new();
    let at: Vec<usize> = (mesh.vertices().iter())
        .map(|p| {
            let next = places.len();
            *places.entry(key(p)).or_insert(next)
        })
        .collect();
    let mut sets = UnionFind::new(places.len());
    for [a, b, c] in mesh.triangles() {
        sets.union(at[*a as usize], at[*b as usize]);
        sets.union(at[*a as usize], at[*c as usize]);
    }
    let mut parts: BTreeMap<usize, Vec<Point3>> = BTreeMap::new();
    for (place, vertex) in at.iter().zip(mesh.vertices()) {
        parts.entry(sets.find(*place)).or_default().push(*vertex);
    }
    parts.into_values().collect()
}

fn engine_shape(shape: &Shape) -> Option<SharedShape> {
    Some(match shape {
        Shape::Box { size } => SharedShape::cuboid(size.x / 2.0, size.y / 2.0, size.z / 2.0),
        Shape::Cylinder { radius, length } => {
            let half = length / 2.0;
            // The engine's cylinders stand along y.
            return cylinder_hull(*radius, half);
        }
        Shape::Capsule { radius, length } => {
            let end = engine::Vector::new(0.0, 0.0, length / 2.0);
            SharedShape::capsule(-end, end, *radius)
        }
        Shape::Sphere { radius } => SharedShape::ball(*radius),
        Shape::Mesh(mesh) => return hull(mesh),
    })
}

fn cylinder_hull(radius: f64, half: f64) -> Option<SharedShape> {
    const SIDES: usize = 24;
    let corner = |i: usize| {
        let angle = std::f64::consts::TAU * i as f64 / SIDES as f64;
        Point2::new(radius * angle.cos(), radius * angle.sin())
    };
    prism((0..SIDES).map(corner), -half, half)
}
