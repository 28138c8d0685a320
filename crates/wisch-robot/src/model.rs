//! The constant part of a robot: its tree of links, joints, limits and bodies.

use super::description::check::Checked;
use super::description::elements::{Urdf, UrdfInertial, UrdfJoint, UrdfMimic};
use super::{Collision, Diagnostic, RobotError, Severity};
use crate::geometry::{Point3, Pose, Vector3};
use crate::source_location::UnknownName;
use nalgebra::{Matrix3, Unit, UnitQuaternion};
use std::collections::BTreeMap;

/// A link of one robot; links are numbered so that a parent comes before its children, the root first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct LinkId(pub(super) usize);

/// A joint of one robot, numbered along the tree.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct JointId(pub(super) usize);

impl LinkId {
    /// Position of the link in [`RobotModel::links`].
    pub const fn index(self) -> usize {
        self.0
    }
}

impl JointId {
    /// Position of the joint in [`RobotModel::joints`].
    pub const fn index(self) -> usize {
        self.0
    }
}

/// A rigid part of the robot.
#[derive(Debug, Clone, PartialEq)]
pub struct Link {
    /// Its name, which no other link has.
    pub name: String,
    /// The joint that holds it; `None` for the root.
    pub parent: Option<JointId>,
    /// Its mass and inertia; `None` if it has none.
    pub body: Option<Body>,
    /// Its shapes for collision checks.
    pub collision: Vec<Collision>,
}

/// Mass and inertia of a link.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Body {
    /// Mass [kg].
    pub mass: f64,
    /// Centre of mass in the link frame [m].
    pub center_in_link: Point3,
    /// Inertia about the centre of mass, in the axes of the link [kg m²].
    pub inertia_about_center: Matrix3<f64>,
}

/// How a joint moves, and by that the unit of its positions; a URDF's planar joint is read as three of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum JointKind {
    /// Not at all.
    Fixed,
    /// It turns about its axis, positions are angles [rad]. URDF's `continuous` is one without
    /// position limits.
    Revolute,
    /// It slides along its axis, positions are lengths [m].
    Prismatic,
}

impl JointKind {
    /// The unit of its positions: "rad" or "m"; empty for a fixed joint.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Fixed => "",
            Self::Revolute => "rad",
            Self::Prismatic => "m",
        }
    }

    /// The unit of its efforts: "Nm" or "N"; empty for a fixed joint.
    pub const fn effort_unit(self) -> &'static str {
        match self {
            Self::Fixed => "",
            Self::Revolute => "Nm",
            Self::Prismatic => "N",
        }
    }
}

/// A joint between two links.
///
/// `parent_from_child = parent_from_joint * motion(axis, position)`.
#[derive(Debug, Clone, PartialEq)]
pub struct Joint {
    /// Its name, which no other joint has.
    pub name: String,
    /// How it moves.
    pub kind: JointKind,
    /// The link that holds it.
    pub parent: LinkId,
    /// The link that it holds.
    pub child: LinkId,
    /// Where the child is at position zero.
    pub parent_from_joint: Pose,
    /// Its axis, the same in the joint's and the child's frame.
    pub axis: Unit<Vector3>,
    /// What moves it.
    pub drive: Drive,
    /// Its limits; those of a joint that follows several others couple them.
    pub limits: SingleJointLimits,
}

/// Where a joint is, as a linear function of the variables: `offset + Σ factor · q[variable]`.
///
/// A joint that is a variable itself has the one term (variable, 1), a fixed one has none.
#[derive(Debug, Clone, PartialEq)]
pub struct Drive {
    /// Position when all variables are zero [rad or m].
    pub offset: f64,
    /// Pairs of a variable and its factor.
    pub terms: Vec<(usize, f64)>,
}

impl Drive {
    /// Position of the joint [rad or m] at these variables.
    ///
    /// # Panics
    /// If `q` is shorter than the robot has variables.
    pub fn position(&self, q: &[f64]) -> f64 {
        self.offset + self.rate(q)
    }

    /// Velocity of the joint at these velocities of the variables; likewise acceleration.
    ///
    /// # Panics
    /// If `qd` is shorter than the robot has variables.
    pub fn rate(&self, qd: &[f64]) -> f64 {
        self.terms.iter().map(|&(i, factor)| factor * qd[i]).sum()
    }
}

/// Values from `lower` to `upper`, both included.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// The least [rad or m].
    pub lower: f64,
    /// The greatest [rad or m].
    pub upper: f64,
}

impl Range {
    /// The share of its width that a range loses at either end at most.
    const MOST_NARROWED: f64 = 0.1;

    /// The same without a margin at either end, which is at most a tenth of the range.
    #[must_use]
    pub fn narrowed(self, margin: f64) -> Self {
        let margin = margin.min(Self::MOST_NARROWED * (self.upper - self.lower));
        Self {
            lower: self.lower + margin,
            upper: self.upper - margin,
        }
    }
}

/// Velocity [rad/s] and acceleration [rad/s²] that are assumed of a joint that turns and has no such limits: those of the
/// paper's arm (§3.4).
pub const ASSUMED_TURN_RATES: [f64; 2] = [1.0, 10.0];
/// The same of a joint that slides: those of the paper's mobile base (§3.4) [m/s], [m/s²].
pub const ASSUMED_SLIDE_RATES: [f64; 2] = [0.5, 1.0];

/// The limits of a joint; what is `None` is not limited.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SingleJointLimits {
    /// Positions [rad or m].
    pub position: Option<Range>,
    /// Greatest velocity, either direction [rad/s or m/s].
    pub velocity: Option<f64>,
    /// Greatest acceleration, either direction [rad/s² or m/s²].
    pub acceleration: Option<f64>,
    /// Greatest torque or force, either direction [Nm or N].
    pub effort: Option<f64>,
}

/// A joint outside its position limits.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("joint {joint:?}: {position} {unit} is outside its limits {} to {} {unit}", limits.lower, limits.upper)]
pub struct LimitFault {
    /// The joint's name.
    pub joint: String,
    /// Where it is [rad or m].
    pub position: f64,
    /// Where it may be [rad or m].
    pub limits: Range,
    /// "rad" or "m".
    pub unit: &'static str,
}

/// A robot: a tree of links, with limits, bodies and shapes. Constant once read.
///
/// ```
/// use wisch_robot::RobotModel;
/// let text = r#"<robot name="pendulum">
///   <link name="wall"/>
///   <link name="rod"/>
///   <joint name="pivot" type="revolute">
///     <parent link="wall"/><child link="rod"/><axis xyz="0 1 0"/>
///     <limit lower="-1" upper="1" velocity="2" effort="10"/>
///   </joint>
/// </robot>"#;
/// let robot = RobotModel::from_urdf("pendulum.urdf", text, &mut |_| Err("no meshes".into()))?;
/// assert_eq!(robot.dof(), 1);
/// assert_eq!(robot.limit_faults(&[1.5])?[0].to_string(),
///     "joint \"pivot\": 1.5 rad is outside its limits -1 to 1 rad");
/// # Ok::<(), wisch_robot::RobotError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct RobotModel {
    name: String,
    links: Vec<Link>,
    joints: Vec<Joint>,
    variables: Vec<JointId>,
    diagnostics: Vec<Diagnostic>,
}

impl RobotModel {
    /// Reads a URDF. `name` is used in messages; `meshes` returns the bytes of a collision mesh by the
    /// file name that the URDF gives it, or says why it cannot. Visual geometry is not read: [`Appearance`](super::Appearance) has it.
    ///
    /// # Errors
    /// If the text is no URDF or larger than is read, or if [`check`](super::check) finds errors:
    /// all of them are in [`RobotError::Unusable`].
    pub fn from_urdf(
        name: &str,
        text: &str,
        meshes: &mut dyn FnMut(&str) -> Result<Vec<u8>, String>,
    ) -> Result<Self, RobotError> {
        let Checked {
            urdf,
            mut diagnostics,
            mut collision,
        } = Checked::new(name, text, meshes)?;
        if diagnostics.iter().any(|f| f.severity == Severity::Error) {
            diagnostics.retain(|f| f.severity == Severity::Error);
            let file = name.to_owned();
            return Err(RobotError::Unusable { file, diagnostics });
        }
        let (order, parents) = along_the_tree(&urdf);
        let mut links = Vec::with_capacity(order.len());
        let mut id_of = BTreeMap::new();
        for (i, &at) in order.iter().enumerate() {
            let link = &urdf.links[at];
            id_of.insert(link.name.as_str(), LinkId(i));
            links.push(Link {
                name: link.name.clone(),
                parent: i.checked_sub(1).map(JointId),
                body: link.inertial.as_ref().and_then(body),
                collision: std::mem::take(&mut collision[at]),
            });
        }
        let follows = |joint: &UrdfJoint| urdf.mimics.iter().any(|m| m.joint == joint.name);
        let mut joints: Vec<Joint> = parents
            .iter()
            .map(|&at| joint(&urdf.joints[at], &id_of))
            .collect();
        let mut variables = Vec::new();
        for (i, &at) in parents.iter().enumerate() {
            if joints[i].kind != JointKind::Fixed && !follows(&urdf.joints[at]) {
                joints[i].drive.terms.push((variables.len(), 1.0));
                variables.push(JointId(i));
            }
        }
        drive_followers(&urdf, &mut joints);
        Ok(Self {
            name: urdf.robot,
            links,
            joints,
            variables,
            diagnostics,
        })
    }

    /// The robot's name, as its URDF gives it.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The links, a parent before its children; the first is the root.
    pub fn links(&self) -> &[Link] {
        &self.links
    }

    /// The joints along the tree: joint i holds link i + 1.
    pub fn joints(&self) -> &[Joint] {
        &self.joints
    }

    /// The joints that move by themselves, in the order of every array of positions.
    pub fn variables(&self) -> &[JointId] {
        &self.variables
    }

    /// Number of variables, n: joints that move by themselves, not those that follow others. The length of every array
    /// of positions, velocities and efforts.
    pub fn dof(&self) -> usize {
        self.variables.len()
    }

    /// What was missing or odd in the URDF, none of it an error.
    pub fn diagnostics(&self) -> &[Diagnostic] {
        &self.diagnostics
    }

    /// The root, whose frame is the world.
    pub const fn root(&self) -> LinkId {
        LinkId(0)
    }

    /// The joints from the one that holds a link up to the root's.
    ///
    /// # Panics
    /// If the link is one of another, larger robot.
    pub fn joints_above(&self, link: LinkId) -> impl Iterator<Item = &Joint> {
        let holder = |link: LinkId| Some(&self.joints[self.links[link.0].parent?.0]);
        std::iter::successors(holder(link), move |joint| holder(joint.parent))
    }

    /// The link of a name.
    ///
    /// # Errors
    /// If there is none; the error has the nearest names.
    pub fn link(&self, name: &str) -> Result<LinkId, RobotError> {
        let found = self.links.iter().position(|link| link.name == name);
        let known = || self.links.iter().map(|link| link.name.as_str());
        found
            .map(LinkId)
            .ok_or_else(|| self.unknown("link", name, &mut known()))
    }

    /// The joint of a name.
    ///
    /// # Errors
    /// If there is none; the error has the nearest names.
    pub fn joint(&self, name: &str) -> Result<JointId, RobotError> {
        let found = self.joints.iter().position(|joint| joint.name == name);
        let known = || self.joints.iter().map(|joint| joint.name.as_str());
        found
            .map(JointId)
            .ok_or_else(|| self.unknown("joint", name, &mut known()))
    }

    fn unknown(
        &self,
        kind: &'static str,
        name: &str,
        known: &mut dyn Iterator<Item = &str>,
    ) -> RobotError {
        RobotError::Unknown {
            robot: self.name.clone(),
            unknown: Box::new(UnknownName::new(kind, name, known)),
        }
    }

    /// The joint of variable `i`.
    ///
    /// # Panics
    /// If the robot has no variable `i`.
    pub fn variable(&self, i: usize) -> &Joint {
        &self.joints[self.variables[i].0]
    }

    /// The joints that move but are no variables: those that follow others.
    pub fn followers(&self) -> impl Iterator<Item = &Joint> {
        let joints = self.joints.iter().enumerate();
        joints
            .filter(|(i, joint)| {
                joint.kind != JointKind::Fixed && !self.variables.contains(&JointId(*i))
            })
            .map(|(_, joint)| joint)
    }

    /// Every joint that these positions (n) put outside its limits, in the order of the joints;
    /// joints that follow others included, which is how coupled limits are checked.
    ///
    /// # Errors
    /// If `q` is of another length or not finite.
    pub fn limit_faults(&self, q: &[f64]) -> Result<Vec<LimitFault>, RobotError> {
        self.checked("positions", q)?;
        let fault = |joint: &Joint| {
            let limits = joint.limits.position?;
            let position = joint.drive.position(q);
            let outside = position < limits.lower || position > limits.upper;
            outside.then(|| LimitFault {
                joint: joint.name.clone(),
                position,
                limits,
                unit: joint.kind.unit(),
            })
        };
        Ok(self.joints.iter().filter_map(fault).collect())
    }

    /// Whether an array has n finite values.
    pub(super) fn checked(&self, what: &'static str, values: &[f64]) -> Result<(), RobotError> {
        if values.len() != self.dof() {
            return Err(RobotError::Length {
                what,
                found: values.len(),
                expected: self.dof(),
            });
        }
        match values.iter().position(|value| !value.is_finite()) {
            None => Ok(()),
            Some(i) => Err(RobotError::NotFinite {
                joint: self.variable(i).name.clone(),
                what,
                value: values[i],
            }),
        }
    }
}

/// The links along the tree, and for each but the root the joint that holds it, as indices.
fn along_the_tree(urdf: &Urdf) -> (Vec<usize>, Vec<usize>) {
    let link_at: BTreeMap<&str, usize> = urdf
        .links
        .iter()
        .enumerate()
        .map(|(i, link)| (link.name.as_str(), i))
        .collect();
    let mut below: Vec<Vec<usize>> = vec![Vec::new(); urdf.links.len()];
    let mut is_child = vec![false; urdf.links.len()];
    for (i, joint) in urdf.joints.iter().enumerate() {
        below[link_at[joint.parent.as_str()]].push(i);
        is_child[link_at[joint.child.as_str()]] = true;
    }
    let mut order = Vec::new();
    let mut parents = Vec::new();
    let root = is_child.iter().position(|child| !child);
    let mut waiting: Vec<(usize, Option<usize>)> =
        root.map(|root| (root, None)).into_iter().collect();
    while let Some((link, parent)) = waiting.pop() {
        order.push(link);
        parents.extend(parent);
        let children = below[link].iter().rev();
        waiting.extend(children.map(|&j| (link_at[urdf.joints[j].child.as_str()], Some(j))));
    }
    (order, parents)
}

fn body(inertial: &UrdfInertial) -> Option<Body> {
    let link_from_inertia = &inertial.link_from_inertia;
    let rotation = link_from_inertia.rotation.to_rotation_matrix();
    (inertial.mass > 0.0).then(|| Body {
        mass: inertial.mass,
        center_in_link: link_from_inertia.translation.vector.into(),
        inertia_about_center: rotation * inertial.about_center * rotation.transpose(),
    })
}

fn joint(joint: &UrdfJoint, id_of: &BTreeMap<&str, LinkId>) -> Joint {
    let kind = match joint.kind.as_str() {
        "revolute" | "continuous" => JointKind::Revolute,
        "prismatic" => JointKind::Prismatic,
        _ => JointKind::Fixed,
    };
    let limit = joint.limit.unwrap_or_default();
    let position = match (limit.lower, limit.upper) {
        (Some(lower), Some(upper)) if joint.kind != "continuous" => Some(Range { lower, upper }),
        _ => None,
    };
    Joint {
        name: joint.name.clone(),
        kind,
        parent: id_of[joint.parent.as_str()],
        child: id_of[joint.child.as_str()],
        parent_from_joint: joint.parent_from_joint,
        axis: Unit::new_normalize(if kind == JointKind::Fixed {
            Vector3::x()
        } else {
            joint.axis
        }),
        drive: Drive {
            offset: 0.0,
            terms: Vec::new(),
        },
        limits: if kind == JointKind::Fixed {
            SingleJointLimits::default()
        } else {
            SingleJointLimits {
                position,
                velocity: limit.velocity,
                acceleration: limit.acceleration,
                effort: limit.effort,
            }
        },
    }
}

/// Writes joints that follow others as sums of variables. The rules are free of circles.
fn drive_followers(urdf: &Urdf, joints: &mut [Joint]) {
    let at: BTreeMap<String, usize> = joints
        .iter()
        .enumerate()
        .map(|(i, joint)| (joint.name.clone(), i))
        .collect();
    let mut waiting: Vec<&UrdfMimic> = urdf.mimics.iter().collect();
    while !waiting.is_empty() {
        let open: Vec<&str> = waiting.iter().map(|m| m.joint.as_str()).collect();
        let (ready, later): (Vec<&UrdfMimic>, Vec<&UrdfMimic>) =
            waiting.iter().copied().partition(|m| {
                m.terms
                    .iter()
                    .all(|(name, _)| !open.contains(&name.as_str()))
            });
        if ready.is_empty() {
            return;
        }
        for mimic in ready {
            let mut drive = Drive {
                offset: mimic.offset,
                terms: Vec::new(),
            };
            for (name, multiplier) in &mimic.terms {
                let followed = &joints[at[name]].drive;
                drive.offset += multiplier * followed.offset;
                for &(variable, factor) in &followed.terms {
                    match drive.terms.iter_mut().find(|(known, _)| *known == variable) {
                        Some((_, sum)) => *sum += multiplier * factor,
                        None => drive.terms.push((variable, multiplier * factor)),
                    }
                }
            }
            joints[at[&mimic.joint]].drive = drive;
        }
        waiting = later;
    }
}

/// The motion of a joint from its frame at zero to its frame at a position.
pub(super) fn motion(joint: &Joint, position: f64) -> Pose {
    match joint.kind {
        JointKind::Fixed => Pose::identity(),
        JointKind::Revolute => Pose::from_parts(
            nalgebra::Translation3::identity(),
            UnitQuaternion::from_axis_angle(&joint.axis, position),
        ),
        JointKind::Prismatic => Pose::from_parts(
            nalgebra::Translation3::from(joint.axis.into_inner() * position),
            UnitQuaternion::identity(),
        ),
    }
}
