//! Kinematics and dynamics of the moving part of a robot without allocation, for control loops.

use super::frame::{Frame, rotation_from_z};
use super::model::motion;
use super::{Body, JointId, JointKind, LinkId, RobotError, RobotModel};
use crate::geometry::{Pose, Vector3};
use nalgebra::{DMatrix, Matrix3, Matrix6xX, Point3, Rotation3, Translation3, UnitQuaternion};

/// The joints of a robot that move while all others are locked, as a tree of rigid bodies. Links that do not move
/// against each other form one body.
///
/// All quantities are in the axes of the world. Quantities that depend on the configuration are in
/// an [`ArticulationState`], which [`Articulation::evaluate`] fills repeatedly without allocation.
///
/// ```
/// # use wisch_robot::{Articulation, RobotModel};
/// # use wisch_robot::geometry::{Pose, Vector3};
/// let text = r#"<robot name="pendulum"><link name="wall"/>
///   <link name="rod"><inertial><origin xyz="0.5 0 0"/><mass value="2"/>
///     <inertia ixx="0.01" iyy="0.01" izz="0.01"/></inertial></link>
///   <joint name="pivot" type="continuous"><parent link="wall"/><child link="rod"/><axis xyz="0 1 0"/></joint>
/// </robot>"#;
/// let robot = RobotModel::from_urdf("pendulum", text, &mut |_| Err(String::new()))?;
/// let moving = Articulation::new(&robot, &Pose::identity(), &[0.0], &[true], &[])?;
/// let mut state = moving.state();
/// moving.evaluate(&mut state, &[0.3], &[0.0], Vector3::new(0.0, 0.0, -9.81));
/// assert!((state.mass_matrix()[(0, 0)] - (0.01 + 2.0 * 0.25)).abs() < 1e-12);
/// assert!((state.bias()[0] + 2.0 * 9.81 * 0.5 * 0.3_f64.cos()).abs() < 1e-12);
/// # Ok::<(), wisch_robot::RobotError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Articulation {
    joints: Vec<ArticulatedJoint>,
    /// Index of each own variable among the robot's variables.
    variables: Vec<usize>,
    /// For each link, the joint that moves it.
    carriers: Vec<Carrier>,
}

/// A joint of an [`Articulation`]; the z axis of its frame is the joint's axis.
#[derive(Debug, Clone, PartialEq)]
pub struct ArticulatedJoint {
    /// The joint of the robot.
    pub id: JointId,
    /// The previous moving joint; `None` if the joint is attached to the world.
    pub parent: Option<usize>,
    /// Transform from the parent's frame, after its motion, to this joint's frame before its own.
    pub parent_from_joint: Pose,
    /// Whether the joint is prismatic (along z) rather than revolute (about z).
    pub slides: bool,
    /// Position with all own variables at 0 [rad or m].
    pub offset: f64,
    /// Pairs of an own variable and its factor.
    pub terms: Vec<(usize, f64)>,
    /// Whether the joint is a variable itself, that of its only term. If not, it follows others, possibly with the factor 1.
    pub is_variable: bool,
    /// Mass \[kg\], centre of mass and inertia about it, in the joint's frame, of all links from this joint up to the
    /// next moving ones.
    pub body: Body,
}

impl ArticulatedJoint {
    /// Position at the own variables `q` [rad or m].
    pub fn position(&self, q: &[f64]) -> f64 {
        self.offset + self.terms.iter().map(|&(i, f)| f * q[i]).sum::<f64>()
    }

    fn rate(&self, qd: &[f64]) -> f64 {
        self.terms.iter().map(|&(i, f)| f * qd[i]).sum()
    }
}

/// The joint that moves a link, with the pose of the link in its frame.
#[derive(Debug, Clone, Copy)]
struct Carrier {
    joint: Option<usize>,
    carrier_from_link: Pose,
}

/// Configuration of an [`Articulation`], with its dynamics.
#[derive(Debug, Clone)]
pub struct ArticulationState {
    frames: Vec<Frame>,
    motions: Vec<Motion>,
    wrenches: Vec<(Vector3, Vector3)>,
    composites: Vec<Composite>,
    mass: DMatrix<f64>,
    bias: Vec<f64>,
    joint_efforts: Vec<f64>,
}

#[derive(Debug, Clone, Copy)]
struct Motion {
    angular_velocity: Vector3,
    angular_acceleration: Vector3,
    /// Acceleration of the frame's origin minus the gravitational acceleration.
    acceleration: Vector3,
}

/// Mass, its first moment, and inertia about the world's origin.
#[derive(Debug, Clone, Copy)]
struct Composite {
    mass: f64,
    moment: Vector3,
    inertia: Matrix3<f64>,
}

impl Articulation {
    /// Returns the part of a robot that its `moving` variables (n) move. All other variables stay at their positions in
    /// `posture` (n); `loads` are bodies in the frames of links.
    ///
    /// # Errors
    /// If `posture` or `moving` is not of length n, or a position is not finite.
    pub fn new(
        robot: &RobotModel,
        world_from_root: &Pose,
        posture: &[f64],
        moving: &[bool],
        loads: &[(LinkId, Body)],
    ) -> Result<Self, RobotError> {
        robot.check_values("positions", posture)?;
        if moving.len() != robot.dof() {
            return Err(RobotError::Length {
                what: "moving variables",
                found: moving.len(),
                expected: robot.dof(),
            });
        }
        let variables: Vec<usize> = (0..robot.dof()).filter(|&i| moving[i]).collect();
        let own = |i: usize| variables.binary_search(&i).ok();
        let mut carriers = vec![Carrier {
            joint: None,
            carrier_from_link: *world_from_root,
        }];
        let mut joints: Vec<ArticulatedJoint> = Vec::new();
        for (i, joint) in robot.joints().iter().enumerate() {
            let before = carriers[joint.parent.index()];
            let to_joint = before.carrier_from_link * joint.parent_from_joint;
            let moves =
                joint.kind != JointKind::Fixed && joint.drive.terms.iter().any(|&(i, _)| moving[i]);
            if !moves {
                carriers.push(Carrier {
                    joint: before.joint,
                    carrier_from_link: to_joint * motion(joint, joint.drive.position(posture)),
                });
                continue;
            }
            let joint_from_axis =
                Pose::from_parts(Translation3::identity(), rotation_from_z(&joint.axis));
            let held = (joint.drive.terms.iter()).filter(|&&(i, _)| !moving[i]);
            let offset = joint.drive.offset + held.map(|&(i, f)| f * posture[i]).sum::<f64>();
            let terms = joint.drive.terms.iter();
            joints.push(ArticulatedJoint {
                id: JointId(i),
                parent: before.joint,
                parent_from_joint: to_joint * joint_from_axis,
                slides: joint.kind == JointKind::Prismatic,
                offset,
                terms: terms.filter_map(|&(i, f)| Some((own(i)?, f))).collect(),
                is_variable: robot.variables().contains(&JointId(i)),
                body: NOTHING,
            });
            carriers.push(Carrier {
                joint: Some(joints.len() - 1),
                carrier_from_link: joint_from_axis.inverse(),
            });
        }
        let bodies = robot.links().iter().enumerate();
        let bodies = bodies.filter_map(|(at, link)| Some((LinkId(at), link.body?)));
        for (link, body) in bodies.chain(loads.iter().copied()) {
            let carrier = carriers[link.index()];
            if let Some(joint) = carrier.joint {
                let carried = transform(&body, &carrier.carrier_from_link);
                joints[joint].body = merge_bodies(&joints[joint].body, &carried);
            }
        }
        Ok(Self {
            joints,
            variables,
            carriers,
        })
    }

    /// Moving joints, including followers; a parent comes before its children.
    pub fn joints(&self) -> &[ArticulatedJoint] {
        &self.joints
    }

    /// Index of each own variable among the robot's variables.
    pub fn variables(&self) -> &[usize] {
        &self.variables
    }

    /// Number of own variables n: the length of `q`, `qd` and efforts here, at most that of the robot's.
    pub fn dof(&self) -> usize {
        self.variables.len()
    }

    /// Returns the moving joint that carries a link, and the pose of the link in that joint's
    /// frame; without such a joint, the pose in the world.
    pub fn carrier(&self, link: LinkId) -> (Option<usize>, &Pose) {
        let carrier = &self.carriers[link.index()];
        (carrier.joint, &carrier.carrier_from_link)
    }

    /// Returns an empty state of this articulation, allocated once before a control loop.
    pub fn state(&self) -> ArticulationState {
        let count = self.joints.len();
        ArticulationState {
            frames: vec![Frame::identity(); count],
            motions: vec![Motion::in_free_fall(Vector3::zeros()); count],
            wrenches: vec![(Vector3::zeros(), Vector3::zeros()); count],
            composites: vec![Composite::NOTHING; count],
            mass: DMatrix::zeros(self.dof(), self.dof()),
            bias: vec![0.0; self.dof()],
            joint_efforts: vec![0.0; count],
        }
    }

    /// Computes the poses of all joints at the own variables `q` [rad or m], without dynamics.
    ///
    /// # Panics
    /// If an array is shorter than the number of own variables, or the state is that of another articulation.
    pub fn locate(&self, state: &mut ArticulationState, q: &[f64]) {
        for (i, joint) in self.joints.iter().enumerate() {
            let before = joint
                .parent
                .map_or_else(Frame::identity, |p| state.frames[p]);
            let mut frame = before.then(&Frame::from_pose(&joint.parent_from_joint));
            let position = joint.position(q);
            let [x, y, z] = frame.axes;
            if joint.slides {
                frame.translation += position * z;
            } else {
                let (sin, cos) = position.sin_cos();
                frame.axes = [cos * x + sin * y, cos * y - sin * x, z];
            }
            state.frames[i] = frame;
        }
    }

    /// Computes poses, mass matrix and bias at positions `q` and velocities `qd` of the own
    /// variables. `gravity_in_world` is the acceleration of free fall [m/s²].
    ///
    /// Source: Featherstone, *Rigid Body Dynamics Algorithms* (2008), chapters 5 and 6, in the axes of
    /// the world.
    ///
    /// # Panics
    /// As [`Articulation::locate`].
    pub fn evaluate(
        &self,
        state: &mut ArticulationState,
        q: &[f64],
        qd: &[f64],
        gravity_in_world: Vector3,
    ) {
        self.locate(state, q);
        state.bias.fill(0.0);
        let still = std::mem::take(&mut state.bias);
        self.newton_euler(state, qd, &still, gravity_in_world);
        state.bias = still;
        for (joint, effort) in self.joints.iter().zip(&state.joint_efforts) {
            for &(variable, factor) in &joint.terms {
                state.bias[variable] += factor * effort;
            }
        }
        state.mass.fill(0.0);
        self.composite_bodies(state, |mass, i, j, entry| {
            for &(row, a) in &self.joints[i].terms {
                for &(column, b) in &self.joints[j].terms {
                    mass[(row, column)] += a * b * entry;
                    if j != i {
                        mass[(column, row)] += a * b * entry;
                    }
                }
            }
        });
    }

    /// Computes the efforts of every moving joint, as if each had its own drive, for accelerations
    /// `qdd` of the own variables in the current state. The result is in
    /// [`ArticulationState::joint_efforts`] [Nm or N].
    ///
    /// # Panics
    /// As [`Articulation::locate`].
    pub fn inverse_dynamics(
        &self,
        state: &mut ArticulationState,
        qd: &[f64],
        qdd: &[f64],
        gravity_in_world: Vector3,
    ) {
        self.newton_euler(state, qd, qdd, gravity_in_world);
    }

    /// Returns the mass matrix of the moving joints as if none followed others, in the current
    /// state: joints × joints [kg m², kg m or kg].
    pub fn joint_mass_matrix(&self, state: &ArticulationState) -> DMatrix<f64> {
        let count = self.joints.len();
        let mut composites = state.clone();
        composites.mass = DMatrix::zeros(count, count);
        for (i, joint) in self.joints.iter().enumerate() {
            composites.composites[i] = self.body_in_world(state, i, &joint.body);
        }
        self.composite_bodies(&mut composites, |mass, i, j, entry| {
            mass[(i, j)] = entry;
            mass[(j, i)] = entry;
        });
        composites.mass
    }

    fn body_in_world(&self, state: &ArticulationState, joint: usize, body: &Body) -> Composite {
        let frame = &state.frames[joint];
        let turned = Matrix3::from_columns(&frame.axes);
        let center = frame.translation + frame.turn(&body.center_in_link.coords);
        let inertia = turned * body.inertia_about_center * turned.transpose();
        Composite::of(body.mass, center, &inertia)
    }

    fn newton_euler(
        &self,
        state: &mut ArticulationState,
        qd: &[f64],
        qdd: &[f64],
        gravity: Vector3,
    ) {
        for (i, joint) in self.joints.iter().enumerate() {
            let frame = &state.frames[i];
            let (mut at, arm) = match joint.parent {
                Some(p) => {
                    let arm = frame.translation - state.frames[p].translation;
                    (state.motions[p], arm)
                }
                None => (Motion::in_free_fall(gravity), Vector3::zeros()),
            };
            let w = at.angular_velocity;
            at.acceleration += at.angular_acceleration.cross(&arm) + w.cross(&w.cross(&arm));
            let velocity = frame.axes[2] * joint.rate(qd);
            let acceleration = frame.axes[2] * joint.rate(qdd);
            if joint.slides {
                at.acceleration += acceleration + 2.0 * w.cross(&velocity);
            } else {
                at.angular_velocity += velocity;
                at.angular_acceleration += acceleration + w.cross(&velocity);
            }
            state.motions[i] = at;
            let center = frame.turn(&joint.body.center_in_link.coords);
            let turned = Matrix3::from_columns(&frame.axes);
            let inertia = turned * joint.body.inertia_about_center * turned.transpose();
            let w = at.angular_velocity;
            let acceleration = at.acceleration
                + at.angular_acceleration.cross(&center)
                + w.cross(&w.cross(&center));
            let force = joint.body.mass * acceleration;
            let moment = inertia * at.angular_acceleration + w.cross(&(inertia * w));
            state.wrenches[i] = (force, moment + center.cross(&force));
            state.composites[i] =
                Composite::of(joint.body.mass, frame.translation + center, &inertia);
        }
        for (i, joint) in self.joints.iter().enumerate().rev() {
            let (force, moment) = state.wrenches[i];
            let axis = state.frames[i].axes[2];
            state.joint_efforts[i] = axis.dot(if joint.slides { &force } else { &moment });
            if let Some(p) = joint.parent {
                let arm = state.frames[i].translation - state.frames[p].translation;
                state.wrenches[p].0 += force;
                state.wrenches[p].1 += moment + arm.cross(&force);
            }
        }
    }

    /// Calls `put` for every pair of a joint and one of its ancestors (or itself), with their entry in the joint mass
    /// matrix. On entry the composites are those of single bodies; on return they include all bodies that a joint
    /// carries.
    fn composite_bodies(
        &self,
        state: &mut ArticulationState,
        put: impl Fn(&mut DMatrix<f64>, usize, usize, f64),
    ) {
        for i in (0..self.joints.len()).rev() {
            let carried = state.composites[i];
            if let Some(p) = self.joints[i].parent {
                state.composites[p].add(&carried);
            }
            let (linear, angular) = self.twist(state, i);
            let momentum = carried.mass * linear + angular.cross(&carried.moment);
            let spin = carried.inertia * angular + carried.moment.cross(&linear);
            let mut at = Some(i);
            while let Some(j) = at {
                let (linear, angular) = self.twist(state, j);
                let entry = linear.dot(&momentum) + angular.dot(&spin);
                put(&mut state.mass, i, j, entry);
                at = self.joints[j].parent;
            }
        }
    }

    /// Returns the velocity at the world's origin and the angular velocity when only this joint moves, at unit speed.
    fn twist(&self, state: &ArticulationState, joint: usize) -> (Vector3, Vector3) {
        let axis = state.frames[joint].axes[2];
        if self.joints[joint].slides {
            (axis, Vector3::zeros())
        } else {
            (state.frames[joint].translation.cross(&axis), axis)
        }
    }

    /// Computes the Jacobian of a point that a moving joint carries, over the own variables: 6 × n, linear first, in
    /// the axes of the world. The point is given in the world \[m\].
    ///
    /// # Panics
    /// If `jacobian` does not have n columns.
    pub fn jacobian(
        &self,
        state: &ArticulationState,
        joint: usize,
        point_in_world: Point3<f64>,
        jacobian: &mut Matrix6xX<f64>,
    ) {
        jacobian.fill(0.0);
        let mut at = Some(joint);
        while let Some(i) = at {
            let (at_origin, angular) = self.twist(state, i);
            let linear = at_origin + angular.cross(&point_in_world.coords);
            for &(variable, factor) in &self.joints[i].terms {
                let mut column = jacobian.column_mut(variable);
                for k in 0..3 {
                    column[k] += factor * linear[k];
                    column[k + 3] += factor * angular[k];
                }
            }
            at = self.joints[i].parent;
        }
    }
}

impl ArticulationState {
    /// Pose of a moving joint's frame in the world.
    pub fn pose(&self, joint: usize) -> Pose {
        let frame = &self.frames[joint];
        let rotation = Rotation3::from_matrix_unchecked(Matrix3::from_columns(&frame.axes));
        Pose::from_parts(
            Translation3::from(frame.translation),
            UnitQuaternion::from_rotation_matrix(&rotation),
        )
    }

    /// Axis of a moving joint in the world.
    pub fn axis(&self, joint: usize) -> Vector3 {
        self.frames[joint].axes[2]
    }

    /// Origin of a moving joint's frame in the world \[m\].
    pub fn origin(&self, joint: usize) -> Vector3 {
        self.frames[joint].translation
    }

    /// Mass matrix, n × n [kg m², kg m or kg].
    pub const fn mass_matrix(&self) -> &DMatrix<f64> {
        &self.mass
    }

    /// Coriolis, centrifugal and gravity efforts, n [Nm or N].
    pub fn bias(&self) -> &[f64] {
        &self.bias
    }

    /// Bias of every moving joint, as if each had its own drive [Nm or N].
    pub fn joint_efforts(&self) -> &[f64] {
        &self.joint_efforts
    }
}

impl Motion {
    fn in_free_fall(gravity: Vector3) -> Self {
        Self {
            angular_velocity: Vector3::zeros(),
            angular_acceleration: Vector3::zeros(),
            acceleration: -gravity,
        }
    }
}

impl Composite {
    const NOTHING: Self = Self {
        mass: 0.0,
        moment: Vector3::new(0.0, 0.0, 0.0),
        inertia: Matrix3::new(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
    };

    fn of(mass: f64, center: Vector3, about_center: &Matrix3<f64>) -> Self {
        Self {
            mass,
            moment: mass * center,
            inertia: about_center + mass * about_origin(&center),
        }
    }

    fn add(&mut self, other: &Self) {
        self.mass += other.mass;
        self.moment += other.moment;
        self.inertia += other.inertia;
    }
}

/// Inertia of a unit point mass about the origin (parallel axis theorem).
fn about_origin(at: &Vector3) -> Matrix3<f64> {
    Matrix3::from_diagonal_element(at.norm_squared()) - at * at.transpose()
}

const NOTHING: Body = Body {
    mass: 0.0,
    center_in_link: Point3::new(0.0, 0.0, 0.0),
    inertia_about_center: Matrix3::new(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
};

/// Transforms a body into another frame.
fn transform(body: &Body, to: &Pose) -> Body {
    let rotation = to.rotation.to_rotation_matrix();
    Body {
        mass: body.mass,
        center_in_link: to * body.center_in_link,
        inertia_about_center: rotation * body.inertia_about_center * rotation.transpose(),
    }
}

/// Merges two bodies of the same frame.
fn merge_bodies(a: &Body, b: &Body) -> Body {
    let mass = a.mass + b.mass;
    if mass <= 0.0 {
        return *a;
    }
    let center = (a.mass * a.center_in_link.coords + b.mass * b.center_in_link.coords) / mass;
    let about = |body: &Body| {
        body.inertia_about_center + body.mass * about_origin(&(body.center_in_link.coords - center))
    };
    Body {
        mass,
        center_in_link: center.into(),
        inertia_about_center: about(a) + about(b),
    }
}
