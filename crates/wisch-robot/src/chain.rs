//! Kinematics between two links without allocation, for numerical solvers.

use super::frame::{Frame, rotation_from_z};
use super::{JointKind, LinkId, RobotError, RobotModel};
use crate::geometry::{Point3, Pose, Vector3};
use nalgebra::{Dyn, Matrix3, MatrixView, Rotation3, Translation3, U1, U6, UnitQuaternion};

/// Largest number of moving joints, and of variables, of a [`Chain`].
pub const MAX_CHAIN: usize = 24;

/// The joints between two links of a robot, with all constants computed in advance.
///
/// The variables of a chain are those variables of the robot that move its joints, in the robot's order.
///
/// ```
/// # use wisch_robot::RobotModel;
/// # let text = r#"<robot name="r"><link name="wall"/><link name="rod"/><link name="tip"/>
/// #   <joint name="pivot" type="continuous"><parent link="wall"/><child link="rod"/><axis xyz="0 0 1"/></joint>
/// #   <joint name="end" type="fixed"><parent link="rod"/><child link="tip"/><origin xyz="2 0 0"/></joint>
/// # </robot>"#;
/// # let robot = RobotModel::from_urdf("r", text, &mut |_| Err(String::new()))?;
/// let chain = robot.chain(robot.root(), robot.link("tip")?)?;
/// let kinematics = chain.forward_kinematics(&[0.5])?;
/// assert!((kinematics.base_from_tip().translation.vector.norm() - 2.0).abs() < 1e-12);
/// assert_eq!(kinematics.jacobian(wisch_robot::geometry::Point3::origin()).view().ncols(), 1);
/// # Ok::<(), wisch_robot::RobotError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Chain {
    base: LinkId,
    tip: LinkId,
    /// Indices into the robot's variables.
    variables: Vec<usize>,
    names: Vec<String>,
    joints: Vec<ChainJoint>,
    last_from_tip: Frame,
}

#[derive(Debug, Clone)]
struct ChainJoint {
    /// Transform from the previous moving joint, after its motion, to this one before its own. The z axis is the axis
    /// of the joint.
    previous_from_this: Frame,
    slides: bool,
    offset: f64,
    /// Pairs of a variable of the chain and its factor.
    terms: Vec<(usize, f64)>,
}

/// The kinematics of a chain in one configuration.
#[derive(Debug, Clone)]
pub struct ChainKinematics<'a> {
    chain: &'a Chain,
    /// Axis of every moving joint in the base.
    axes: [Vector3; MAX_CHAIN],
    origins: [Vector3; MAX_CHAIN],
    base_from_tip: Frame,
}

/// Jacobian of a point of the tip over the chain's variables: 6 × n, linear first, in the axes of the base.
#[derive(Debug, Clone)]
pub struct ChainJacobian {
    /// One column per variable; zero beyond `count`.
    columns: [[f64; 6]; MAX_CHAIN],
    count: usize,
}

impl RobotModel {
    /// Returns the chain from `base` out to `tip`.
    ///
    /// # Errors
    /// If the tip is no descendant of the base, or more than [`MAX_CHAIN`] joints or variables move it.
    ///
    /// # Panics
    /// If a link belongs to another, larger robot.
    pub fn chain(&self, base: LinkId, tip: LinkId) -> Result<Chain, RobotError> {
        let name = |link: LinkId| self.links()[link.0].name.clone();
        let mut path = Vec::new();
        let mut at = tip;
        while at != base {
            let Some(id) = self.links()[at.0].parent else {
                let parents = path.iter().map(|&j: &usize| name(self.joints()[j].parent));
                return Err(RobotError::NoChain {
                    base: name(base),
                    tip: name(tip),
                    ancestors: parents.collect(),
                });
            };
            path.push(id.0);
            at = self.joints()[id.0].parent;
        }
        path.reverse();
        let mut variables: Vec<usize> = path
            .iter()
            .flat_map(|&j| self.joints()[j].drive.terms.iter().map(|&(i, _)| i))
            .collect();
        variables.sort_unstable();
        variables.dedup();
        let mut joints = Vec::new();
        let mut pending = Pose::identity();
        for &j in &path {
            let joint = &self.joints()[j];
            pending *= joint.parent_from_joint;
            if joint.kind == JointKind::Fixed {
                continue;
            }
            let joint_from_axis =
                Pose::from_parts(Translation3::identity(), rotation_from_z(&joint.axis));
            let term = |&(i, factor): &(usize, f64)| {
                variables.binary_search(&i).ok().map(|own| (own, factor))
            };
            joints.push(ChainJoint {
                previous_from_this: Frame::from_pose(&(pending * joint_from_axis)),
                slides: joint.kind == JointKind::Prismatic,
                offset: joint.drive.offset,
                terms: joint.drive.terms.iter().filter_map(term).collect(),
            });
            pending = joint_from_axis.inverse();
        }
        for (what, value) in [
            ("moving joints", joints.len()),
            ("variables", variables.len()),
        ] {
            if value > MAX_CHAIN {
                return Err(RobotError::ChainTooLong {
                    base: name(base),
                    tip: name(tip),
                    what,
                    value,
                    limit: MAX_CHAIN,
                });
            }
        }
        Ok(Chain {
            base,
            tip,
            names: variables
                .iter()
                .map(|&i| self.variable(i).name.clone())
                .collect(),
            variables,
            joints,
            last_from_tip: Frame::from_pose(&pending),
        })
    }
}

impl Chain {
    /// Link to which poses and velocities are relative.
    pub const fn base(&self) -> LinkId {
        self.base
    }

    /// Link at the end of the chain.
    pub const fn tip(&self) -> LinkId {
        self.tip
    }

    /// Index of each variable of the chain among the robot's variables.
    pub fn variables(&self) -> &[usize] {
        &self.variables
    }

    /// Number n of the robot's variables that move the tip relative to the base.
    pub fn dof(&self) -> usize {
        self.variables.len()
    }

    /// Computes the configuration at positions `q` of the n variables [rad or m].
    ///
    /// # Errors
    /// If `q` does not have n finite values.
    #[inline]
    pub fn forward_kinematics(&self, q: &[f64]) -> Result<ChainKinematics<'_>, RobotError> {
        self.check_positions(q)?;
        let mut kinematics = ChainKinematics {
            chain: self,
            axes: [Vector3::zeros(); MAX_CHAIN],
            origins: [Vector3::zeros(); MAX_CHAIN],
            base_from_tip: self.last_from_tip,
        };
        let mut base_from_joint = Frame::identity();
        for (i, joint) in self.joints.iter().enumerate() {
            base_from_joint = base_from_joint.then(&joint.previous_from_this);
            let position = match joint.terms[..] {
                [(variable, factor)] => joint.offset + factor * q[variable],
                _ => joint.offset + joint.terms.iter().map(|&(v, f)| f * q[v]).sum::<f64>(),
            };
            let [x, y, axis] = base_from_joint.axes;
            if joint.slides {
                base_from_joint.translation += position * axis;
            } else {
                let (sin, cos) = position.sin_cos();
                base_from_joint.axes = [cos * x + sin * y, cos * y - sin * x, axis];
            }
            kinematics.axes[i] = axis;
            kinematics.origins[i] = base_from_joint.translation;
        }
        kinematics.base_from_tip = base_from_joint.then(&self.last_from_tip);
        Ok(kinematics)
    }

    /// Checks that an array has n finite values.
    #[inline]
    pub(super) fn check_positions(&self, q: &[f64]) -> Result<(), RobotError> {
        if q.len() != self.dof() {
            return Err(RobotError::Length {
                what: "positions of the chain",
                found: q.len(),
                expected: self.dof(),
            });
        }
        if let Some(i) = q.iter().position(|value| !value.is_finite()) {
            return Err(RobotError::NotFinite {
                joint: self.names[i].clone(),
                what: "positions of the chain",
                value: q[i],
            });
        }
        Ok(())
    }
}

impl ChainKinematics<'_> {
    /// Pose of the tip in the base.
    #[inline]
    pub fn base_from_tip(&self) -> Pose {
        // The columns are orthonormal up to rounding.
        let rotation =
            Rotation3::from_matrix_unchecked(Matrix3::from_columns(&self.base_from_tip.axes));
        Pose::from_parts(
            Translation3::from(self.base_from_tip.translation),
            UnitQuaternion::from_rotation_matrix(&rotation),
        )
    }

    /// Returns the Jacobian of a point of the tip \[m\] over the chain's variables.
    #[inline]
    pub fn jacobian(&self, point_in_tip: Point3) -> ChainJacobian {
        let tip = &self.base_from_tip;
        let point = tip.translation + tip.turn(&point_in_tip.coords);
        let mut columns = [[0.0; 6]; MAX_CHAIN];
        for (i, joint) in self.chain.joints.iter().enumerate() {
            let axis = self.axes[i];
            let column = if joint.slides {
                [axis.x, axis.y, axis.z, 0.0, 0.0, 0.0]
            } else {
                let v = axis.cross(&(point - self.origins[i]));
                [v.x, v.y, v.z, axis.x, axis.y, axis.z]
            };
            for &(variable, factor) in &joint.terms {
                for (sum, value) in columns[variable].iter_mut().zip(column) {
                    *sum += factor * value;
                }
            }
        }
        ChainJacobian {
            columns,
            count: self.chain.dof(),
        }
    }
}

impl ChainJacobian {
    /// Returns the columns of the n variables, 6 × n: linear velocity [m/s], then angular velocity [rad/s].
    pub fn view(&self) -> MatrixView<'_, f64, U6, Dyn, U1, U6> {
        let flat = self.columns[..self.count].as_flattened();
        MatrixView::from_slice_generic(flat, U6, Dyn(self.count))
    }
}
