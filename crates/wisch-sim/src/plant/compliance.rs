//! The compliant tool: its plate on springs, and the load that the firm part puts on the robot.

use super::held_tool::HeldTool;
use super::{GRAVITY, Plant, free_axis, to_engine};
use crate::SimulationError;
use nalgebra::Translation3;
use rapier3d_f64::dynamics::{
    GenericJoint, MassProperties, MultibodyJointHandle, PrismaticJointBuilder,
    RevoluteJointBuilder, RigidBodyBuilder, RigidBodyHandle,
};
use rapier3d_f64::math as engine;
use rapier3d_f64::pipeline::PhysicsWorld;
use wisch::control::tool_load;
use wisch::geometry::{Point2, Pose, Vector3};
use wisch::robot::Body;

/// Least and largest thickness of the tool's plate [m]: thick enough that the engine never pushes it out on the far
/// side of what it touches.
const PLATE_THICKNESS: [f64; 2] = [0.01, 0.03];
/// Masses of the firm part of the tool and of its compliant plate [kg].
const FIRM_MASS: f64 = 0.1;
const PLATE_MASS: f64 = 0.05;
/// Mass of a link that only connects two joints of the tool [kg].
const LINK_MASS: f64 = 2e-3;
/// Mass of the tool that the controller assumes [kg].
pub(crate) const TOOL_MASS: f64 = FIRM_MASS + PLATE_MASS + 2.0 * LINK_MASS;
/// Damping of the tool's compliance: damping ratio [1], and the mass that an arm presses with [kg].
const TOOL_DAMPING: [f64; 2] = [0.2, 5.0];
/// Least stiffness against rocking, for tools as narrow as a blade [Nm/rad].
const LEAST_ROCKING: f64 = 0.3;

/// Compression of the tool: pose of its plate relative to the plate's frame at rest.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Compression {
    /// Displacement of the plate towards the hand [m].
    pub depth: f64,
    /// Rotation of the plate about the tool's x and y [rad].
    pub rocking: [f64; 2],
}

impl Compression {
    /// Returns the normalised pressure at a point under the tool [1]: the local share of the force per area, over the
    /// nominal pressure. `under` is the point in the plate's frame [m], `higher` the height of the surface there over
    /// the plane that carries the plate [m].
    pub fn pressure(&self, under: Point2, higher: f64, tool: &HeldTool) -> f64 {
        // Springs under the whole plate: p / p₀ = (depth + θx y − θy x + higher) / depth₀.
        let [about_x, about_y] = self.rocking;
        let depth = self.depth + about_x * under.y - about_y * under.x + higher;
        depth / tool.depth * tool.pressure
    }
}

impl Plant {
    /// Returns the true force of the surface on the tool along the surface normal [N], from the compression and the
    /// weight of the plate.
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

    /// Returns the compression of the tool; zero if the plate only hangs on its springs.
    pub fn compression(&self) -> Compression {
        let Some((multibody, _)) = self.world.multibody_joints.get(self.multibody) else {
            return Compression::default();
        };
        let axis = self.world_from_plate() * Vector3::z();
        // The weight of the plate stretches the spring by weight / stiffness, which is no contact.
        let weight = -(PLATE_MASS + 2.0 * LINK_MASS) * GRAVITY.dot(&axis);
        let [stiffness, _] = self.foam_spring;
        let at = |link: usize| {
            multibody.link(link).map_or(0.0, |link| {
                link.joint.coords()[free_axis(link.joint.data.locked_axes.bits())]
            })
        };
        Compression {
            depth: at(self.foam[0]) + weight / stiffness,
            rocking: [at(self.foam[1]), at(self.foam[2])],
        }
    }
}

/// Returns the thickness of the tool's plate [m], which grows with the compression depth.
pub(super) fn plate_thickness(tool: &HeldTool) -> f64 {
    let [least, most] = PLATE_THICKNESS;
    (2.0 * tool.depth.max(tool.rest)).clamp(least, most)
}

/// Returns stiffness and damping of the tool's compliance in depth [N/m, Ns/m] and in rocking about its x and y
/// [Nm/rad, Nms/rad]: a bed of springs under the whole footprint.
pub(super) fn foam_springs(tool: &HeldTool) -> [[f64; 2]; 3] {
    let stiffness = tool.stiffness();
    let [ratio, mass] = TOOL_DAMPING;
    // Damping of a mass on a spring: d = 2 ζ √(k m).
    let damping = 2.0 * ratio * (stiffness * mass).sqrt();
    let size = tool.size;
    // Mean square distance from the axis over a rectangle is b² / 12, so that k_rocking = k b² / 12.
    let about_x = (stiffness * size.y * size.y / 12.0).max(LEAST_ROCKING);
    let about_y = (stiffness * size.x * size.x / 12.0).max(LEAST_ROCKING);
    let share = damping / stiffness;
    [
        [stiffness, damping],
        [about_x, about_x * share],
        [about_y, about_y * share],
    ]
}

/// Adds the tool's underside on its springs: a plate that slides along the tool's z and rocks about x and y.
pub(super) fn compliance(
    world: &mut PhysicsWorld,
    hand: RigidBodyHandle,
    joint_from_tool: &Pose,
    tool: &HeldTool,
) -> Result<(RigidBodyHandle, [RigidBodyHandle; 3], MultibodyJointHandle), SimulationError> {
    // At nominal force, the plate of a tool with the believed stiffness lies at the tool centre point.
    let joint_from_rest = joint_from_tool * Translation3::new(0.0, 0.0, -tool.rest);
    let (x, y, z) = (tool.size.x, tool.size.y, plate_thickness(tool));
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
    let handle = handle.ok_or(SimulationError::NoFootprint)?;
    Ok((bodies[2], bodies, handle))
}

/// Returns the load of the real tool without its plate and the links that carry the plate, which are bodies of their
/// own.
pub(crate) fn firm_load(tool: &HeldTool) -> Body {
    tool_load(&tool.tip_from_tool, tool.area_of_effect, FIRM_MASS)
}
