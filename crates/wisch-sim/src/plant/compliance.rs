//! The tool: how it gives way, its plate on springs, and the load that it is to the robot.

use super::wielded::Wielded;
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

/// Thickness of the tool's plate at least and at most [m]: so much that it is never pushed out on the far
/// side of what it meets.
const PLATE_THICKNESS: [f64; 2] = [0.01, 0.03];
/// Mass of the firm part of the tool and of the part that gives way [kg].
const FIRM_MASS: f64 = 0.1;
const PLATE_MASS: f64 = 0.05;
/// Mass of a link that only stands between two joints of the tool [kg].
const LINK_MASS: f64 = 2e-3;
/// Mass of a tool, as the controller believes it [kg].
pub(crate) const TOOL_MASS: f64 = FIRM_MASS + PLATE_MASS + 2.0 * LINK_MASS;
/// Damping of the tool's compliance, as a damping ratio of the mass that an arm presses with [1, kg].
const TOOL_DAMPING: [f64; 2] = [0.2, 5.0];
/// Least stiffness against rocking, for tools as narrow as a blade [Nm/rad].
const LEAST_ROCKING: f64 = 0.3;

/// How the tool gives way: the plate against its frame at rest.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Compression {
    /// How far the plate is pushed towards the hand [m].
    pub depth: f64,
    /// How far it is rocked about the tool's x and y [rad].
    pub rocking: [f64; 2],
}

impl Compression {
    /// Pressure at a place under the tool where the surface is `higher` [m] than the plane on which the underside rests,
    /// over the nominal one: the local share of the force per area.
    pub fn pressure(&self, under: Point2, higher: f64, tool: &Wielded) -> f64 {
        let [about_x, about_y] = self.rocking;
        let depth = self.depth + about_x * under.y - about_y * under.x + higher;
        depth / tool.depth * tool.pressure
    }
}

impl Plant {
    /// Force of the surface on the tool along the surface's normal, by how much the tool gives way and what its
    /// plate weighs [N]: the truth.
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

    /// How the tool gives way to what it meets: by nothing where its plate only hangs on its springs.
    pub fn compression(&self) -> Compression {
        let Some((multibody, _)) = self.world.multibody_joints.get(self.multibody) else {
            return Compression::default();
        };
        let axis = self.world_from_plate() * Vector3::z();
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

/// Thickness of the tool's plate [m]: a tool that gives way far comes down the deeper.
pub(super) fn plate_thickness(tool: &Wielded) -> f64 {
    let [least, most] = PLATE_THICKNESS;
    (2.0 * tool.depth.max(tool.rest)).clamp(least, most)
}

/// Stiffness and damping of the tool's compliance: in depth, and rocking about its x and y, as a bed of
/// springs under the whole footprint has them.
pub(super) fn foam_springs(tool: &Wielded) -> [[f64; 2]; 3] {
    let stiffness = tool.stiffness();
    let [ratio, mass] = TOOL_DAMPING;
    let damping = 2.0 * ratio * (stiffness * mass).sqrt();
    let size = tool.size;
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
pub(super) fn compliance(
    world: &mut PhysicsWorld,
    hand: RigidBodyHandle,
    joint_from_tool: &Pose,
    tool: &Wielded,
) -> Result<(RigidBodyHandle, [RigidBodyHandle; 3], MultibodyJointHandle), SimulationError> {
    // At nominal force the plate of a tool that is as stiff as believed lies at the tool centre point.
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

/// The load that the real one is, without its plate and the links that carry the plate, which are bodies of their own.
pub(crate) fn firm_load(tool: &Wielded) -> Body {
    tool_load(&tool.tip_from_tool, tool.area_of_effect, FIRM_MASS)
}
