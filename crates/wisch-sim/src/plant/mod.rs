//! The plant: the robot as a multibody, its compliant tool, the real surface and the scene.
//!
//! This module builds and steps the plant. Module `drives` holds the robot's bodies and their
//! actuation, `compliance` the tool and its plate, `ground` the surface under the tool, and
//! `shapes` the collision shapes.

mod compliance;
mod drives;
mod ground;
mod held_tool;
mod shapes;

pub(super) use compliance::{TOOL_MASS, firm_load};
pub(super) use ground::find_real_surface;
pub(super) use held_tool::HeldTool;

use self::compliance::{compliance, foam_springs, plate_thickness};
use self::drives::{Coupling, Drives, Link, add_bodies};
use self::ground::{BentContact, CarriedFromBelow, GroundUnderTool, facets, slab};
use self::shapes::{add_scene, add_shapes, prism};
use crate::{SimulationError, SimulationSettings, Waviness};
use rapier3d_f64::dynamics::{
    MultibodyJointHandle, RigidBodyHandle, SphericalJointBuilder, SpringCoefficients,
};
use rapier3d_f64::geometry::{
    ColliderBuilder, ColliderHandle, ContactPair, Group, InteractionGroups, InteractionTestMode,
};
use rapier3d_f64::math as engine;
use rapier3d_f64::pipeline::PhysicsWorld;
use wisch::control::ControlConfig;
use wisch::follow::Workcell;
use wisch::geometry::{Point3, Pose, Vector3};
use wisch::represent::{Surface, Task};
use wisch::robot::Articulation;

/// Acceleration of free fall [m/s²].
pub(super) const GRAVITY: Vector3 = Vector3::new(0.0, 0.0, -9.81);

/// Typical length in this world [m], that of grains. With the engine's default of a metre, its
/// broad phase would pair all bodies.
const LENGTH_UNIT: f64 = 0.01;
/// Distance below which the engine prepares contacts [m].
const PREDICTION: f64 = 2e-3;
/// Depth to which bodies may penetrate each other [m].
const ALLOWED_ERROR: f64 = 1e-4;
/// Largest velocity at which the engine may push bodies apart [m/s].
const CORRECTION: f64 = 0.5;
/// Stiffness and damping of contacts: natural frequency [Hz] and damping ratio [1].
const CONTACT: [f64; 2] = [240.0, 10.0];
const SOLVER_ITERATIONS: usize = 1;
const CONTACT_ITERATIONS: usize = 4;
/// Thickness of the surface [m]: thick enough that the engine never pushes the tool out on the far side.
const SURFACE_THICKNESS: f64 = 0.1;

const ROBOT: Group = Group::GROUP_1;
const SCENE: Group = Group::GROUP_2;
const SURFACE: Group = Group::GROUP_3;
const PLATE: Group = Group::GROUP_4;
const TOOL: Group = Group::GROUP_5;
const GRAIN: Group = Group::GROUP_6;

/// Physics of one execution.
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
    /// Objects around the surface, and what carries the surface.
    scene: Vec<ColliderHandle>,
    real: Surface,
    waviness: Option<Waviness>,
    bent: Option<BentContact>,
    ground: GroundUnderTool,
    /// For each variable, stiffness and damping of the drive that holds it; `None` for compliant variables.
    servos: Vec<Option<[f64; 2]>>,
    couplings: Vec<Coupling>,
}

pub(super) fn to_engine(pose: &Pose) -> engine::Pose {
    (*pose).into()
}

pub(super) fn vector(v: &Vector3) -> engine::Vector {
    engine::Vector::new(v.x, v.y, v.z)
}

/// Returns the one free axis of a joint, in the engine's order: linear, then angular.
fn free_axis(locked: u8) -> usize {
    (!locked).trailing_zeros() as usize
}

/// Returns the collision groups of grains. They touch the surface and each other; the tool acts on them by explicit
/// forces.
pub(super) fn groups_of_grains() -> InteractionGroups {
    groups(GRAIN, SURFACE | GRAIN)
}

fn groups(memberships: Group, filter: Group) -> InteractionGroups {
    InteractionGroups::new(memberships, filter, InteractionTestMode::And)
}

/// Creates an empty world with the step time of `config`.
fn empty_world(config: &ControlConfig) -> PhysicsWorld {
    let mut world = PhysicsWorld::new();
    world.gravity = vector(&GRAVITY);
    let parameters = &mut world.integration_parameters;
    parameters.dt = config.period;
    parameters.length_unit = LENGTH_UNIT;
    parameters.normalized_prediction_distance = PREDICTION / LENGTH_UNIT;
    parameters.normalized_allowed_linear_error = ALLOWED_ERROR / LENGTH_UNIT;
    parameters.normalized_max_corrective_velocity = CORRECTION / LENGTH_UNIT;
    // Each further iteration recomputes the robot's mass matrix; contacts are few and light.
    parameters.num_solver_iterations = SOLVER_ITERATIONS;
    parameters.num_internal_pgs_iterations = CONTACT_ITERATIONS;
    let [frequency, ratio] = CONTACT;
    parameters.static_contact_softness = SpringCoefficients::new(frequency, ratio);
    parameters.contact_softness = SpringCoefficients::new(frequency / 2.0, ratio);
    world
}

impl Plant {
    /// Builds the plant with the robot at `q`. `articulation` includes the load of the firm part of the tool. Efforts
    /// drive its variables `compliant`, and position drives hold the other variables.
    #[expect(
        clippy::too_many_arguments,
        reason = "each is a different thing, none has a default"
    )]
    pub fn new(
        cell: &Workcell,
        task: &Task,
        tool: &HeldTool,
        settings: &SimulationSettings,
        articulation: &Articulation,
        compliant: &[usize],
        q: &[f64],
        config: &ControlConfig,
    ) -> Result<Self, SimulationError> {
        let mut world = empty_world(config);
        let bodies = add_bodies(&mut world, articulation);
        let (carrier, joint_from_tip) = articulation.carrier(cell.tip());
        let (Some(carrier), Some(bodies)) = (carrier, bodies) else {
            return Err(SimulationError::NothingMoves {
                robot: cell.robot().name().to_owned(),
            });
        };
        let joint_from_tool = joint_from_tip * tool.tip_from_tool;
        let hand = bodies[carrier];
        let (plate, foam_bodies, multibody) = compliance(&mut world, hand, &joint_from_tool, tool)?;

        let plate_shape = prism(
            tool.edges().map(|edge| edge.start),
            0.0,
            plate_thickness(tool),
        );
        let plate_shape = plate_shape.ok_or(SimulationError::NoFootprint)?;
        let real = find_real_surface(task, settings);
        let slab = slab(&real).ok_or(SimulationError::NoSurface)?;
        let plate_collider = world.insert_collider(
            ColliderBuilder::new(plate_shape)
                .density(0.0)
                .friction(settings.friction)
                .active_hooks(CarriedFromBelow::choose_hooks(&slab))
                .collision_groups(groups(PLATE, SURFACE)),
            Some(plate),
        );
        let mut lay = |shape, meets| {
            world.insert_collider(
                ColliderBuilder::new(shape)
                    .position(to_engine(&real.world_from_surface))
                    .friction(settings.friction)
                    .collision_groups(groups(SURFACE, meets)),
                None,
            )
        };
        // With waves or a bend, the tool touches a surface of its own, which takes the height and slope under the tool.
        let is_wavy = settings.waviness.height > 0.0;
        let bent = BentContact::new(&real, tool);
        let surface_collider = if bent.is_some() {
            lay(facets(&real, SURFACE_THICKNESS)?, GRAIN);
            lay(slab, PLATE)
        } else if is_wavy {
            lay(slab.clone(), GRAIN);
            lay(slab, PLATE)
        } else {
            lay(slab, PLATE | GRAIN)
        };
        let scene = add_scene(&mut world, task, settings);
        add_shapes(&mut world, cell, tool, articulation, compliant, &bodies);

        let mut plant = Self {
            links: Vec::new(),
            foam: [0; 3],
            foam_spring: foam_springs(tool)[0],
            plate,
            hand,
            plate_collider,
            surface_collider,
            scene,
            real,
            waviness: is_wavy.then_some(settings.waviness),
            bent,
            ground: GroundUnderTool::default(),
            servos: vec![None; articulation.dof()],
            couplings: Vec::new(),
            articulation: articulation.clone(),
            multibody,
            world,
        };
        plant.place(&bodies, &foam_bodies, q)?;
        let led = plant.hold_with_second_hand(cell, task, &(joint_from_tip * tool.tip_from_tool));
        let drives = Drives {
            compliant,
            led: &led,
            friction: settings.joint_friction,
        };
        plant.set_drives(&drives, q, tool);
        Ok(plant)
    }

    /// Connects the second hand, if there is one, to the tool by a ball joint at its grip. Returns the variables of
    /// that arm, which the tool leads along.
    fn hold_with_second_hand(
        &mut self,
        cell: &Workcell,
        task: &Task,
        hand_from_tool: &Pose,
    ) -> Vec<usize> {
        let (Some(second), Some(grip)) = (cell.second_arm(), &task.tool.second_grip) else {
            return Vec::new();
        };
        let (Some(joint), _) = self.articulation.carrier(second.chain().tip()) else {
            return Vec::new();
        };
        let other = self.links.iter().find(|link| link.of == joint);
        let Some(other) = other.map(|link| link.body) else {
            return Vec::new();
        };
        let in_hand = hand_from_tool * grip.point_in_tool;
        let pose = |body: RigidBodyHandle| Pose::from(*self.world.bodies[body].position());
        let in_other = pose(other).inverse() * (pose(self.hand) * in_hand);
        let held = SphericalJointBuilder::new()
            .local_anchor1(vector(&in_hand.coords))
            .local_anchor2(vector(&in_other.coords));
        self.world.insert_impulse_joint(self.hand, other, held);
        let own = second.chain().variables();
        let variables = self.articulation.variables().iter().enumerate();
        let led = variables.filter(|(_, variable)| own.contains(variable));
        led.map(|(k, _)| k).collect()
    }

    /// Applies a force [N] on the hand at a point in the world [m] during the next period.
    pub fn push(&mut self, force: &Vector3, at: &Point3) {
        let body = &mut self.world.bodies[self.hand];
        body.add_force_at_point(vector(force), vector(&at.coords), true);
    }

    /// Applies a force [N] on the tool's underside at a point in the world [m] during the next period.
    pub fn resist(&mut self, force: &Vector3, at: &Point3) {
        let body = &mut self.world.bodies[self.plate];
        body.add_force_at_point(vector(force), vector(&at.coords), true);
    }

    /// Removes the forces that acted on the tool's underside.
    pub fn release(&mut self) {
        let body = &mut self.world.bodies[self.plate];
        body.reset_forces(false);
        body.reset_torques(false);
    }

    /// Advances the world by one period.
    pub fn step(&mut self) {
        self.world.step_with_events(&CarriedFromBelow, &());
    }

    /// Whether robot or tool touch anything but the surface.
    pub fn is_obstructed(&self) -> bool {
        (self.scene.iter())
            .flat_map(|&object| self.world.narrow_phase.contact_pairs_with(object))
            .any(ContactPair::has_any_active_contact)
    }

    /// Sets the Coulomb coefficient between tool and surface [1].
    pub fn set_friction(&mut self, friction: f64) {
        for handle in [self.plate_collider, self.surface_collider] {
            if let Some(collider) = self.world.colliders.get_mut(handle) {
                collider.set_friction(friction);
            }
        }
    }

    /// Pose of the tool's underside in the world.
    pub fn world_from_plate(&self) -> Pose {
        (*self.world.bodies[self.plate].position()).into()
    }

    /// Returns the velocity of a point of the tool's underside, both in the world [m, m/s].
    pub fn plate_velocity(&self, at: &Point3) -> Vector3 {
        let v = self.world.bodies[self.plate].velocity_at_point(vector(&at.coords));
        Vector3::new(v.x, v.y, v.z)
    }

    /// The real surface.
    pub const fn real(&self) -> &Surface {
        &self.real
    }
}
