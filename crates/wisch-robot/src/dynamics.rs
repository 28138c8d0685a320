//! Joint-space dynamics: mass matrix, bias, inverse dynamics.

use super::{JointKind, Kinematics, RobotError, RobotModel};
use crate::geometry::{Point3, Vector3};
use nalgebra::{DMatrix, DVector, Matrix3, Matrix6};

/// Least inertia that each variable must move for the dynamics to exist [kg m² or kg].
pub const MIN_INERTIA: f64 = 1e-9;

/// Dynamics of a robot each of whose variables moves some inertia: `M(q) qdd + bias(q, qd, g) = effort`.
///
/// | | meaning | unit |
/// |---|---|---|
/// | `mass_matrix` | M, n × n, symmetric, positive definite | kg m², kg m, kg |
/// | `bias` | Coriolis, centrifugal and gravity efforts, n | Nm or N |
/// | `gravity` | bias at rest, n: the efforts that hold the robot still | Nm or N |
/// | `inverse_dynamics` | efforts for an acceleration, n | Nm or N |
///
/// Friction and the inertia of motors are not part of a URDF and are not modelled. `gravity_in_world` is the
/// acceleration of free fall [m/s²], such as (0, 0, −9.81) if the root link stands upright.
///
/// Source: Featherstone, *Rigid Body Dynamics Algorithms* (2008), chapters 5 and 6: recursive
/// Newton–Euler and composite rigid bodies, here in the axes of the world.
#[derive(Debug, Clone, Copy)]
pub struct Dynamics<'a> {
    model: &'a RobotModel,
}

impl RobotModel {
    /// Returns the dynamics, if the robot has enough inertia.
    ///
    /// ```
    /// # use wisch_robot::RobotModel;
    /// let text = r#"<robot name="pendulum"><link name="wall"/>
    ///   <link name="rod"><inertial><origin xyz="0.5 0 0"/><mass value="2"/>
    ///     <inertia ixx="0.01" iyy="0.01" izz="0.01"/></inertial></link>
    ///   <joint name="pivot" type="continuous"><parent link="wall"/><child link="rod"/><axis xyz="0 1 0"/></joint>
    /// </robot>"#;
    /// let robot = RobotModel::from_urdf("pendulum", text, &mut |_| Err(String::new()))?;
    /// let dynamics = robot.dynamics()?;
    /// assert!((dynamics.mass_matrix(&[0.3])?[(0, 0)] - (0.01 + 2.0 * 0.25)).abs() < 1e-12);
    /// let down = wisch_robot::geometry::Vector3::new(0.0, 0.0, -9.81);
    /// // A positive angle about y lowers the rod, so holding it takes a negative torque.
    /// assert!((dynamics.gravity(&[0.0], down)?[0] + 2.0 * 9.81 * 0.5).abs() < 1e-12);
    /// # Ok::<(), wisch_robot::RobotError>(())
    /// ```
    ///
    /// # Errors
    /// If a variable moves less inertia than [`MIN_INERTIA`] with all positions at zero.
    pub fn dynamics(&self) -> Result<Dynamics<'_>, RobotError> {
        let dynamics = Dynamics { model: self };
        let at_zero = dynamics.mass_matrix(&vec![0.0; self.dof()])?;
        for i in 0..self.dof() {
            let value = at_zero[(i, i)];
            if value < MIN_INERTIA {
                let joint = self.variable(i);
                return Err(RobotError::NoInertia {
                    joint: joint.name.clone(),
                    link: self.links()[joint.child.0].name.clone(),
                    value,
                    limit: MIN_INERTIA,
                });
            }
        }
        Ok(dynamics)
    }
}

impl Dynamics<'_> {
    /// Returns the mass matrix at positions `q` (n): n × n [kg m², kg m or kg by the kinds of the joints].
    ///
    /// # Errors
    /// If `q` does not have n finite values.
    pub fn mass_matrix(&self, q: &[f64]) -> Result<DMatrix<f64>, RobotError> {
        let kinematics = self.model.forward_kinematics(q)?;
        // With all inertias about the world's origin in the world's axes, and joint columns for that point, sums need
        // no change of frame.
        let mut composite: Vec<Matrix6<f64>> = spatial_inertias(&kinematics);
        let joints = self.model.joints();
        let columns: Vec<_> = (0..joints.len())
            .map(|i| kinematics.joint_column(i, Point3::origin()))
            .collect();
        let mut mass = DMatrix::zeros(self.model.dof(), self.model.dof());
        for i in (0..joints.len()).rev() {
            let (parent, child) = (joints[i].parent.0, joints[i].child.0);
            let carried = composite[child];
            composite[parent] += carried;
            if joints[i].kind == JointKind::Fixed {
                continue;
            }
            let momentum = carried * columns[i];
            let mut at = joints[i].child;
            while let Some(j) = self.model.links()[at.0].parent {
                let entry = columns[j.0].dot(&momentum);
                for &(row, a) in &joints[i].drive.terms {
                    for &(column, b) in &joints[j.0].drive.terms {
                        mass[(row, column)] += a * b * entry;
                        if j.0 != i {
                            mass[(column, row)] += a * b * entry;
                        }
                    }
                }
                at = joints[j.0].parent;
            }
        }
        Ok(mass)
    }

    /// Returns the efforts (n) [Nm or N] that give the accelerations `qdd` (n) [rad/s² or m/s²] at positions `q` (n)
    /// [rad or m] and velocities `qd` (n) [rad/s or m/s].
    ///
    /// # Errors
    /// If an array does not have n finite values.
    pub fn inverse_dynamics(
        &self,
        q: &[f64],
        qd: &[f64],
        qdd: &[f64],
        gravity_in_world: Vector3,
    ) -> Result<DVector<f64>, RobotError> {
        let kinematics = self.model.forward_kinematics(q)?;
        self.model.check_values("velocities", qd)?;
        self.model.check_values("accelerations", qdd)?;
        let motions = motions(&kinematics, qd, qdd, gravity_in_world);
        Ok(self.efforts(&kinematics, &motions))
    }

    /// Returns the efforts (n) [Nm or N] without acceleration, from Coriolis, centrifugal and gravity terms, at
    /// positions `q` (n) [rad or m] and velocities `qd` (n) [rad/s or m/s].
    ///
    /// # Errors
    /// If an array does not have n finite values.
    pub fn bias(
        &self,
        q: &[f64],
        qd: &[f64],
        gravity_in_world: Vector3,
    ) -> Result<DVector<f64>, RobotError> {
        self.inverse_dynamics(q, qd, &vec![0.0; self.model.dof()], gravity_in_world)
    }

    /// Returns the efforts (n) [Nm or N] that hold the robot still at positions `q` (n) [rad or m].
    ///
    /// # Errors
    /// If `q` does not have n finite values.
    pub fn gravity(
        &self,
        q: &[f64],
        gravity_in_world: Vector3,
    ) -> Result<DVector<f64>, RobotError> {
        self.bias(q, &vec![0.0; self.model.dof()], gravity_in_world)
    }

    /// Recursive Newton–Euler: solves the equations from the tips to the root.
    fn efforts(&self, kinematics: &Kinematics, motions: &[Motion]) -> DVector<f64> {
        let links = self.model.links();
        // Force and moment about the link's origin that its joint transmits.
        let mut wrenches = vec![(Vector3::zeros(), Vector3::zeros()); links.len()];
        let mut efforts = DVector::zeros(self.model.dof());
        for at in (0..links.len()).rev() {
            let motion = &motions[at];
            let world_from_link = kinematics.world_from_link(super::LinkId(at));
            if let Some(body) = links[at].body {
                let center = world_from_link.rotation * body.center_in_link.coords;
                let turned = world_from_link.rotation.to_rotation_matrix();
                let inertia = turned * body.inertia_about_center * turned.transpose();
                let w = motion.angular_velocity;
                let acceleration = motion.acceleration
                    + motion.angular_acceleration.cross(&center)
                    + w.cross(&w.cross(&center));
                let force = body.mass * acceleration;
                let moment = inertia * motion.angular_acceleration + w.cross(&(inertia * w));
                wrenches[at].0 += force;
                wrenches[at].1 += moment + center.cross(&force);
            }
            let Some(id) = links[at].parent else {
                continue;
            };
            let joint = &self.model.joints()[id.0];
            let (force, moment) = wrenches[at];
            let axis = kinematics.world_axis(id.0);
            let effort = match joint.kind {
                JointKind::Revolute => axis.dot(&moment),
                JointKind::Prismatic => axis.dot(&force),
                JointKind::Fixed => 0.0,
            };
            for &(variable, factor) in &joint.drive.terms {
                efforts[variable] += factor * effort;
            }
            let parent = kinematics.world_from_link(joint.parent).translation.vector;
            let arm = world_from_link.translation.vector - parent;
            wrenches[joint.parent.0].0 += force;
            wrenches[joint.parent.0].1 += moment + arm.cross(&force);
        }
        efforts
    }
}

/// Motion of a link's frame, in the axes of the world.
#[derive(Clone, Copy)]
struct Motion {
    angular_velocity: Vector3,
    angular_acceleration: Vector3,
    /// Acceleration of the link's origin minus that of free fall.
    acceleration: Vector3,
}

fn motions(kinematics: &Kinematics, qd: &[f64], qdd: &[f64], gravity: Vector3) -> Vec<Motion> {
    let mut motions = vec![Motion {
        angular_velocity: Vector3::zeros(),
        angular_acceleration: Vector3::zeros(),
        acceleration: -gravity,
    }];
    for (i, joint) in kinematics.model.joints().iter().enumerate() {
        let mut motion = motions[joint.parent.0];
        let origin = |link| kinematics.world_from_link(link).translation.vector;
        let arm = origin(joint.child) - origin(joint.parent);
        let w = motion.angular_velocity;
        motion.acceleration += motion.angular_acceleration.cross(&arm) + w.cross(&w.cross(&arm));
        let axis = kinematics.world_axis(i);
        let velocity = axis * joint.drive.rate(qd);
        let acceleration = axis * joint.drive.rate(qdd);
        match joint.kind {
            JointKind::Revolute => {
                motion.angular_velocity += velocity;
                motion.angular_acceleration += acceleration + w.cross(&velocity);
            }
            JointKind::Prismatic => {
                motion.acceleration += acceleration + 2.0 * w.cross(&velocity);
            }
            JointKind::Fixed => {}
        }
        motions.push(motion);
    }
    motions
}

/// Inertias of the links about the world's origin, linear first.
fn spatial_inertias(kinematics: &Kinematics) -> Vec<Matrix6<f64>> {
    let links = kinematics.model.links().iter().enumerate();
    links
        .map(|(at, link)| {
            let Some(body) = link.body else {
                return Matrix6::zeros();
            };
            let world_from_link = kinematics.world_from_link(super::LinkId(at));
            let turned = world_from_link.rotation.to_rotation_matrix();
            let about_center = turned * body.inertia_about_center * turned.transpose();
            let center = (world_from_link * body.center_in_link).coords;
            let cross = center.cross_matrix();
            let mut inertia = Matrix6::zeros();
            inertia
                .fixed_view_mut::<3, 3>(0, 0)
                .copy_from(&(body.mass * Matrix3::identity()));
            inertia
                .fixed_view_mut::<3, 3>(0, 3)
                .copy_from(&(-body.mass * cross));
            inertia
                .fixed_view_mut::<3, 3>(3, 0)
                .copy_from(&(body.mass * cross));
            inertia
                .fixed_view_mut::<3, 3>(3, 3)
                .copy_from(&(about_center - body.mass * cross * cross));
            inertia
        })
        .collect()
}
