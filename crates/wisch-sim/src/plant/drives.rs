//! The robot's bodies and their actuation: efforts, position drives, and joints that follow others.

use super::compliance::foam_springs;
use super::held_tool::HeldTool;
use super::{GRAVITY, Plant, free_axis, to_engine, vector};
use crate::SimulationError;
use nalgebra::{DMatrix, DVector};
use rapier3d_f64::dynamics::{
    GenericJoint, JointAxis, MassProperties, MotorModel, MultibodyLink, PrismaticJointBuilder,
    RevoluteJointBuilder, RigidBodyBuilder, RigidBodyHandle,
};
use rapier3d_f64::math as engine;
use rapier3d_f64::pipeline::PhysicsWorld;
use wisch::robot::{ArticulatedJoint, Articulation, ArticulationState, Body, JointId};

/// Natural frequency of joints that follow others and of drives that hold a position [rad/s].
const COUPLING_RATE: f64 = 250.0;
const SERVO_RATE: f64 = 100.0;
/// Natural frequency of the drives of an arm that the tool leads along [rad/s].
const LED_RATE: f64 = 5.0;
/// Least rate of the gap between a following joint and its leaders [rad/s or m/s], and number of its reversals in a row, at which
/// the joint oscillates.
const LEAST_RATE: f64 = 0.05;
const MOST_REVERSALS: usize = 30;
/// Damping of a joint's friction below its limit [Nm s/rad or N s/m]: practically rigid.
const BRAKE_DAMPING: f64 = 1e5;
/// The engine's axes, in its order.
const JOINT_AXES: [JointAxis; 6] = [
    JointAxis::LinX,
    JointAxis::LinY,
    JointAxis::LinZ,
    JointAxis::AngX,
    JointAxis::AngY,
    JointAxis::AngZ,
];

/// A moving joint in the engine.
#[derive(Debug, Clone, Copy)]
pub(super) struct Link {
    pub(super) body: RigidBodyHandle,
    /// Index of the joint in the articulation, and of the link in the multibody.
    pub(super) of: usize,
    pub(super) joint: usize,
    /// Position of the joint's velocity in the velocities of the multibody.
    pub(super) at: usize,
    /// The body that the joint turns against; `None` for the world.
    pub(super) parent: Option<RigidBodyHandle>,
    pub(super) slides: bool,
}

/// Kind of actuation of the articulation's variables.
#[derive(Debug, Clone, Copy)]
pub(super) struct Drives<'a> {
    /// Variables that efforts move.
    pub(super) compliant: &'a [usize],
    /// Variables of an arm that the tool leads along, with soft drives.
    pub(super) led: &'a [usize],
    /// Coulomb friction in the compliant joints [Nm or N].
    pub(super) friction: f64,
}

/// A joint that follows others, held to them by a stiff spring.
#[derive(Debug, Clone, Copy)]
pub(super) struct Coupling {
    pub(super) link: usize,
    pub(super) stiffness: f64,
    pub(super) damping: f64,
    /// Rate at which the gap closed in the last period [rad/s or m/s], and number of periods in a row in which it changed its
    /// sign.
    pub(super) last_rate: f64,
    pub(super) reversals: usize,
}

impl Coupling {
    fn note_rate(&mut self, rate: f64) {
        let reverses = rate * self.last_rate < 0.0 && rate.abs() > LEAST_RATE;
        self.reversals = if reverses { self.reversals + 1 } else { 0 };
        self.last_rate = rate;
    }
}

/// Adds the bodies of all joints, linked as in the articulation; `None` if nothing moves.
pub(super) fn add_bodies(
    world: &mut PhysicsWorld,
    articulation: &Articulation,
) -> Option<Vec<RigidBodyHandle>> {
    let ground = world.insert_body(RigidBodyBuilder::fixed());
    let mut bodies: Vec<RigidBodyHandle> = Vec::new();
    let mut last = None;
    for joint in articulation.joints() {
        let body = world.insert_body(
            RigidBodyBuilder::dynamic()
                .additional_mass_properties(mass_properties(&joint.body))
                .gyroscopic_forces_enabled(true)
                .can_sleep(false),
        );
        let parent = joint.parent.map_or(ground, |p| bodies[p]);
        let mut data: GenericJoint = if joint.slides {
            PrismaticJointBuilder::new(engine::Vector::Z).build().into()
        } else {
            RevoluteJointBuilder::new(engine::Vector::Z).build().into()
        };
        // Both builders turn their frames so that the joint's axis is the engine's x.
        data.local_frame1 = to_engine(&joint.parent_from_joint) * data.local_frame1;
        last = world.insert_multibody_joint(parent, body, data);
        bodies.push(body);
    }
    last.map(|_| bodies)
}

impl Plant {
    /// Moves the multibody to the start positions `q`, and stores the indices of its joints.
    pub(super) fn place(
        &mut self,
        bodies: &[RigidBodyHandle],
        foam: &[RigidBodyHandle; 3],
        q: &[f64],
    ) -> Result<(), SimulationError> {
        let Some((multibody, _)) = self.world.multibody_joints.get_mut(self.multibody) else {
            return Err(SimulationError::NoSurface);
        };
        // The first pass tells the engine that the root is fixed, which removes its six degrees of freedom.
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
                    of: joint,
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

    /// Sets the springs of the tool, of the position drives and of the joints that follow others, and the Coulomb
    /// friction of the compliant joints [Nm or N].
    pub(super) fn set_drives(&mut self, drives: &Drives<'_>, q: &[f64], tool: &HeldTool) {
        let Drives {
            compliant,
            led,
            friction,
        } = *drives;
        let mut state = self.articulation.state();
        let still = vec![0.0; self.articulation.dof()];
        self.articulation.evaluate(&mut state, q, &still, GRAVITY);
        let joints = self.articulation.joint_mass_matrix(&state);
        let Some((multibody, _)) = self.world.multibody_joints.get_mut(self.multibody) else {
            return;
        };
        for (i, joint) in self.articulation.joints().iter().enumerate() {
            if joint.is_variable {
                let variable = joint.terms[0].0;
                if compliant.contains(&variable) {
                    if let (true, Some(link)) =
                        (friction > 0.0, multibody.link_mut(self.links[i].joint))
                    {
                        brake(link, friction);
                    }
                    continue;
                }
                let inertia = state.mass_matrix()[(variable, variable)];
                let rate = if led.contains(&variable) {
                    LED_RATE
                } else {
                    SERVO_RATE
                };
                let stiffness = inertia * rate * rate;
                let damping = 2.0 * inertia * rate;
                self.servos[variable] = Some([stiffness, damping]);
                multibody.damping_mut()[self.links[i].at] = damping;
            } else {
                let inertia = coupled_inertia(&self.articulation, &joints, i);
                self.couplings.push(Coupling {
                    link: i,
                    stiffness: inertia * COUPLING_RATE * COUPLING_RATE,
                    damping: 2.0 * inertia * COUPLING_RATE,
                    last_rate: 0.0,
                    reversals: 0,
                });
            }
        }
        let springs = foam_springs(tool);
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

    /// Reads positions `q` and velocities `qd` of the articulation's variables [rad or m, per s].
    pub fn read(&self, q: &mut [f64], qd: &mut [f64]) {
        let Some((multibody, _)) = self.world.multibody_joints.get(self.multibody) else {
            return;
        };
        let velocities = multibody.generalized_velocity();
        for (link, joint) in self.links.iter().zip(self.articulation.joints()) {
            if !joint.is_variable {
                continue;
            }
            let variable = joint.terms[0].0;
            q[variable] = self.coordinate(link);
            qd[variable] = velocities[link.at];
        }
    }

    pub(super) fn coordinate(&self, link: &Link) -> f64 {
        let multibody = self.world.multibody_joints.get(self.multibody);
        let found = multibody.and_then(|(multibody, _)| multibody.link(link.joint));
        found.map_or(0.0, |found| {
            found.joint.coords()[free_axis(found.joint.data.locked_axes.bits())]
        })
    }

    /// Applies efforts to the compliant variables, and moves the targets of the other variables over one period.
    /// `target` holds positions, velocities and accelerations.
    pub fn drive(
        &mut self,
        state: &ArticulationState,
        compliant: &[usize],
        efforts: &[f64],
        [target_q, target_qd, target_qdd]: &[Vec<f64>; 3],
        joint_efforts: &mut [f64],
    ) {
        for link in &self.links {
            let body = &mut self.world.bodies[link.body];
            body.reset_forces(false);
            body.reset_torques(false);
        }
        self.couple(state, joint_efforts);
        for (i, joint) in self.articulation.joints().iter().enumerate() {
            if joint.is_variable {
                let variable = joint.terms[0].0;
                joint_efforts[i] += match compliant.iter().position(|&c| c == variable) {
                    Some(k) => efforts[k],
                    // Feedforward for gravity and the planned acceleration; the spring corrects the rest. Without it,
                    // the inertia of a led arm would pull on the tool.
                    None => {
                        let inertia = state.mass_matrix().row(variable);
                        let accelerating = inertia.iter().zip(target_qdd);
                        let accelerating = accelerating.map(|(inertia, qdd)| inertia * qdd);
                        state.bias()[variable] + accelerating.sum::<f64>()
                    }
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
            if !joint.is_variable {
                continue;
            }
            let variable = joint.terms[0].0;
            let (Some([stiffness, damping]), Some(found)) =
                (self.servos[variable], multibody.link_mut(link.joint))
            else {
                continue;
            };
            // The damper acts against the velocity itself, so the spring's target moves ahead by q̇ d / k.
            let ahead = target_qd[variable] * damping / stiffness;
            let axis = free_axis(found.joint.data.locked_axes.bits());
            found
                .joint
                .set_spring(axis, stiffness, target_q[variable] + ahead);
        }
    }

    /// Computes the efforts that hold following joints to their leaders, and the reactions on the leaders [Nm or N].
    fn couple(&mut self, state: &ArticulationState, joint_efforts: &mut [f64]) {
        joint_efforts.fill(0.0);
        for i in 0..self.couplings.len() {
            let Some((multibody, _)) = self.world.multibody_joints.get(self.multibody) else {
                return;
            };
            let velocities = multibody.generalized_velocity();
            let coupling = self.couplings[i];
            let joint = &self.articulation.joints()[coupling.link];
            // Gap g = q_f − (offset + Σ cᵢ qᵢ); effort τ = τ_ff − k g − d ġ, and −cᵢ τ acts on each leader.
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
            self.couplings[i].note_rate(rate);
        }
    }

    /// Returns a joint that oscillates from period to period against the joints that it follows: the simulation of this robot is
    /// wrong.
    pub(crate) fn find_oscillating_follower(&self) -> Option<JointId> {
        let oscillates = |coupling: &&Coupling| coupling.reversals >= MOST_REVERSALS;
        let found = self.couplings.iter().find(oscillates)?;
        Some(self.articulation.joints()[found.link].id)
    }

    fn link_of(&self, variable: usize) -> Option<usize> {
        let joints = self.articulation.joints().iter();
        joints
            .enumerate()
            .find(|(_, joint)| joint.is_variable && joint.terms[0].0 == variable)
            .map(|(i, _)| i)
    }
}

/// Adds Coulomb friction to a joint [Nm or N]: a velocity drive to zero whose effort is limited to `friction`.
fn brake(link: &mut MultibodyLink, friction: f64) {
    let data = &mut link.joint.data;
    let axis = JOINT_AXES[free_axis(data.locked_axes.bits())];
    data.set_motor_model(axis, MotorModel::ForceBased);
    data.set_motor_velocity(axis, 0.0, BRAKE_DAMPING);
    data.set_motor_max_force(axis, friction);
}

/// Returns the effective inertia against closing the gap between a following joint and its leaders [kg m² or kg].
fn coupled_inertia(articulation: &Articulation, mass: &DMatrix<f64>, follower: usize) -> f64 {
    let mut gap = DVector::zeros(mass.nrows());
    gap[follower] = 1.0;
    for &(variable, factor) in &articulation.joints()[follower].terms {
        let leads = |j: &ArticulatedJoint| j.is_variable && j.terms[0].0 == variable;
        if let Some(leader) = articulation.joints().iter().position(leads) {
            gap[leader] -= factor;
        }
    }
    // For the gap direction n: inertia = 1 / (nᵀ M⁻¹ n).
    let accelerations = mass.clone().cholesky().map(|mass| mass.solve(&gap));
    accelerations.map_or(0.0, |a| 1.0 / gap.dot(&a).max(f64::MIN_POSITIVE))
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
