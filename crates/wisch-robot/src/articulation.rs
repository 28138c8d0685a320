//! Kinematics and dynamics of a robot's moving part without allocation, for control loops.

use super::frame::{Frame, z_to};
use super::model::motion;
use super::{Body, JointId, JointKind, LinkId, RobotError, RobotModel};
use crate::geometry::{Pose, Vector3};
use nalgebra::{DMatrix, Matrix3, Matrix6xX, Point3, Rotation3, Translation3, UnitQuaternion};

/// The joints of a robot that move while the others hold still, as a tree of rigid bodies: links
/// between them are lumped together.
///
/// Everything is in the axes of the world. What depends on where the joints are is in an
/// [`ArticulationState`], which [`Articulation::evaluate`] fills again and again without allocation.
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
    /// For each own variable its position among the robot's.
    variables: Vec<usize>,
    /// For each link what moves it.
    carriers: Vec<Carrier>,
    /// The root in the world.
    world_from_root: Pose,
}

/// A joint of an [`Articulation`]: its frame's z axis is the joint's axis.
#[derive(Debug, Clone, PartialEq)]
pub struct ArticulatedJoint {
    /// The joint of the robot.
    pub id: JointId,
    /// The moving joint before it; `None` if it stands in the world.
    pub parent: Option<usize>,
    /// From the frame of the parent, after its motion, to this one before its own.
    pub parent_from_joint: Pose,
    /// Whether it slides along z instead of turning about it.
    pub slides: bool,
    /// Position with all own variables at zero [rad or m].
    pub offset: f64,
    /// Pairs of an own variable and its factor.
    pub terms: Vec<(usize, f64)>,
    /// Mass [kg], centre of mass and inertia about it in the joint's frame, of all that it moves up to
    /// the next moving joints.
    pub body: Body,
}

impl ArticulatedJoint {
    /// Position at these own variables [rad or m].
    pub fn position(&self, q: &[f64]) -> f64 {
        self.offset + self.terms.iter().map(|&(i, f)| f * q[i]).sum::<f64>()
    }

    fn rate(&self, qd: &[f64]) -> f64 {
        self.terms.iter().map(|&(i, f)| f * qd[i]).sum()
    }

    /// Whether it is a variable itself rather than following others.
    pub fn is_variable(&self) -> bool {
        self.offset == 0.0 && matches!(self.terms[..], [(_, 1.0)])
    }
}

/// What moves a link, and where the link is on it.
#[derive(Debug, Clone, Copy)]
struct Carrier {
    joint: Option<usize>,
    carrier_from_link: Pose,
}

/// Where an [`Articulation`] is, and its dynamics there.
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
    /// Of the frame's origin, less that of a falling body.
    acceleration: Vector3,
}

/// Mass, its first moment and inertia about the world's origin.
#[derive(Debug, Clone, Copy)]
struct Composite {
    mass: f64,
    moment: Vector3,
    inertia: Matrix3<f64>,
}

impl Articulation {
    /// The part of a robot that its `moving` variables (n) move, the others at their positions in
    /// `posture` (n), with loads in the frames of links.
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
        robot.checked("positions", posture)?;
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
            let joint_from_axis = Pose::from_parts(Translation3::identity(), z_to(&joint.axis));
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
                let carried = transformed(&body, &carrier.carrier_from_link);
                joints[joint].body = together(&joints[joint].body, &carried);
            }
        }
        Ok(Self {
            joints,
            variables,
            carriers,
            world_from_root: *world_from_root,
        })
    }

    /// The joints that move, those that follow others included; a parent comes before its children.
    pub fn joints(&self) -> &[ArticulatedJoint] {
        &self.joints
    }

    /// For each own variable its position among the robot's.
    pub fn variables(&self) -> &[usize] {
        &self.variables
    }

    /// Number of own variables, n: the length of `q`, `qd` and efforts here, at most that of the robot's.
    pub fn dof(&self) -> usize {
        self.variables.len()
    }

    /// The robot's root in the world.
    pub const fn world_from_root(&self) -> &Pose {
        &self.world_from_root
    }

    /// The moving joint that carries a link, and the link in that joint's frame; without a joint, in the
    /// world.
    pub fn carrier(&self, link: LinkId) -> (Option<usize>, &Pose) {
        let carrier = &self.carriers[link.index()];
        (carrier.joint, &carrier.carrier_from_link)
    }

    /// Room for one state of this articulation, taken once so that a control loop allocates nothing.
    pub fn state(&self) -> ArticulationState {
        let count = self.joints.len();
        ArticulationState {
            frames: vec![Frame::identity(); count],
            motions: vec![Motion::fallen(Vector3::zeros()); count],
            wrenches: vec![(Vector3::zeros(), Vector3::zeros()); count],
            composites: vec![Composite::NOTHING; count],
            mass: DMatrix::zeros(self.dof(), self.dof()),
            bias: vec![0.0; self.dof()],
            joint_efforts: vec![0.0; count],
        }
    }

    /// Where all joints are at the own variables `q` [rad or m], without dynamics.
    ///
    /// # Panics
    /// If an array is shorter than the number of own variables, or the state another articulation's.
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

    /// Fills the state at positions `q` and velocities `qd` of the own variables, under an acceleration
    /// of free fall in the world [m/s²]: places, mass matrix and bias.
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

    /// Efforts of every moving joint, as if each had a drive of its own, for accelerations `qdd` of the own
    /// variables where the state is: in [`ArticulationState::joint_efforts`] [Nm or N].
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

    /// The mass matrix of the moving joints as if none followed others, where the state is: joints ×
    /// joints [kg m², kg m or kg].
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
                None => (Motion::fallen(gravity), Vector3::zeros()),
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

    /// Hands every pair of a joint and one it hangs on (or itself) to `put`, with their entry in the mass
    /// matrix of the joints. The state's composites are those of single bodies before, of all that a joint
    /// carries after.
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

    /// Velocity at the world's origin and rotation when only this joint moves, at unit speed.
    fn twist(&self, state: &ArticulationState, joint: usize) -> (Vector3, Vector3) {
        let axis = state.frames[joint].axes[2];
        if self.joints[joint].slides {
            (axis, Vector3::zeros())
        } else {
            (state.frames[joint].translation.cross(&axis), axis)
        }
    }

    /// Pose in the world of something in the frame of a moving joint.
    pub fn world_from(&self, state: &ArticulationState, joint: usize, in_joint: &Pose) -> Pose {
        state.pose(joint) * in_joint
    }

    /// How a point that a moving joint carries moves with the own variables, 6 × n, linear first, in the
    /// axes of the world. The point is given in the world [m].
    ///
    /// # Panics
    /// If `jacobian` has not n columns.
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

    /// Origin of a moving joint's frame in the world [m].
    pub fn origin(&self, joint: usize) -> Vector3 {
        self.frames[joint].translation
    }

    /// The mass matrix, n × n [kg m², kg m or kg].
    pub const fn mass_matrix(&self) -> &DMatrix<f64> {
        &self.mass
    }

    /// Coriolis and centrifugal forces and weight, n [Nm or N].
    pub fn bias(&self) -> &[f64] {
        &self.bias
    }

    /// The bias of every moving joint, as if each had a drive of its own [Nm or N].
    pub fn joint_efforts(&self) -> &[f64] {
        &self.joint_efforts
    }
}

impl Motion {
    fn fallen(gravity: Vector3) -> Self {
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

/// Inertia of a unit mass at a place about the origin.
fn about_origin(at: &Vector3) -> Matrix3<f64> {
    Matrix3::from_diagonal_element(at.norm_squared()) - at * at.transpose()
}

const NOTHING: Body = Body {
    mass: 0.0,
    center_in_link: Point3::new(0.0, 0.0, 0.0),
    inertia_about_center: Matrix3::new(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
};

/// A body in another frame.
fn transformed(body: &Body, to: &Pose) -> Body {
    let rotation = to.rotation.to_rotation_matrix();
    Body {
        mass: body.mass,
        center_in_link: to * body.center_in_link,
        inertia_about_center: rotation * body.inertia_about_center * rotation.transpose(),
    }
}

/// Two bodies of the same frame as one.
fn together(a: &Body, b: &Body) -> Body {
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
