//! The constant part of a robot: its tree of links, joints, limits and bodies.

use super::description::check::Checked;
use super::description::elements::{Urdf, UrdfInertial, UrdfJoint, UrdfMimic};
use super::{Collision, Diagnostic, RobotError, Severity};
use crate::geometry::{Point3, Pose, Vector3};
use crate::source_location::UnknownName;
use nalgebra::{Matrix3, Unit, UnitQuaternion};
use std::collections::BTreeMap;

/// Index of a link of a robot. A parent comes before its children, the root first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct LinkId(pub(super) usize);

/// Index of a joint of a robot, along the tree.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct JointId(pub(super) usize);

impl LinkId {
    /// Index of the link in [`RobotModel::links`].
    pub const fn index(self) -> usize {
        self.0
    }
}

impl JointId {
    /// Index of the joint in [`RobotModel::joints`].
    pub const fn index(self) -> usize {
        self.0
    }
}

/// A rigid part of the robot.
#[derive(Debug, Clone, PartialEq)]
pub struct Link {
    /// Name, unique among the links.
    pub name: String,
    /// The joint above the link; `None` for the root.
    pub parent: Option<JointId>,
    /// Mass and inertia; `None` for a link without mass.
    pub body: Option<Body>,
    /// Shapes for collision checks.
    pub collision: Vec<Collision>,
}

/// Mass and inertia of a link.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Body {
    /// Mass \[kg\].
    pub mass: f64,
    /// Centre of mass in the link frame \[m\].
    pub center_in_link: Point3,
    /// Inertia about the centre of mass, in the axes of the link [kg m²].
    pub inertia_about_center: Matrix3<f64>,
}

/// Kind of a joint, which determines the unit of its positions. A planar joint of a URDF is read as three joints.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum JointKind {
    /// The joint does not move.
    Fixed,
    /// The joint rotates about its axis; positions are angles \[rad\]. URDF's `continuous` is a revolute joint without
    /// position limits.
    Revolute,
    /// The joint slides along its axis; positions are lengths \[m\].
    Prismatic,
}

impl JointKind {
    /// Unit of its positions: "rad" or "m"; empty for a fixed joint.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Fixed => "",
            Self::Revolute => "rad",
            Self::Prismatic => "m",
        }
    }

    /// Unit of its efforts: "Nm" or "N"; empty for a fixed joint.
    pub const fn effort_unit(self) -> &'static str {
        match self {
            Self::Fixed => "",
            Self::Revolute => "Nm",
            Self::Prismatic => "N",
        }
    }
}

/// A joint that connects a child link to its parent.
///
/// `parent_from_child = parent_from_joint * motion(axis, position)`.
#[derive(Debug, Clone, PartialEq)]
pub struct Joint {
    /// Name, unique among the joints.
    pub name: String,
    /// Kind of its motion.
    pub kind: JointKind,
    /// Parent link.
    pub parent: LinkId,
    /// Child link.
    pub child: LinkId,
    /// Pose of the child in the parent at position 0.
    pub parent_from_joint: Pose,
    /// Axis, the same in the joint's and in the child's frame.
    pub axis: Unit<Vector3>,
    /// How the variables determine its position.
    pub drive: Drive,
    /// Limits of the joint; the limits of a joint that follows several others couple those joints.
    pub limits: SingleJointLimits,
}

/// Position of a joint as a linear function of the variables: `offset + Σ factor · q[variable]`.
///
/// A joint that is a variable has the single term (variable, 1); a fixed joint has none.
#[derive(Debug, Clone, PartialEq)]
pub struct Drive {
    /// Position when all variables are 0 [rad or m].
    pub offset: f64,
    /// Pairs of a variable and its factor.
    pub terms: Vec<(usize, f64)>,
}

impl Drive {
    /// Position of the joint [rad or m] at the variables `q`.
    ///
    /// # Panics
    /// If `q` has fewer values than the robot has variables.
    pub fn position(&self, q: &[f64]) -> f64 {
        self.offset + self.rate(q)
    }

    /// Velocity of the joint, given those of the variables; the same holds for accelerations.
    ///
    /// # Panics
    /// If `qd` has fewer values than the robot has variables.
    pub fn rate(&self, qd: &[f64]) -> f64 {
        self.terms.iter().map(|&(i, factor)| factor * qd[i]).sum()
    }
}

/// A closed range from `lower` to `upper`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// Lower end [rad or m].
    pub lower: f64,
    /// Upper end [rad or m].
    pub upper: f64,
}

impl Range {
    /// Largest share of its width that a range may lose at either end [1].
    const MOST_NARROWED: f64 = 0.1;

    /// Returns the range without a margin at either end; the margin is limited to a tenth of the range.
    #[must_use]
    pub fn shrink(self, margin: f64) -> Self {
        let margin = margin.min(Self::MOST_NARROWED * (self.upper - self.lower));
        Self {
            lower: self.lower + margin,
            upper: self.upper - margin,
        }
    }
}

/// Velocity [rad/s] and acceleration [rad/s²] that are assumed for a revolute joint without these limits: those of the
/// paper's arm (§3.4).
pub const ASSUMED_TURN_RATES: [f64; 2] = [1.0, 10.0];
/// Velocity [m/s] and acceleration [m/s²] that are assumed for a prismatic joint without these
/// limits: those of the paper's mobile base (§3.4).
pub const ASSUMED_SLIDE_RATES: [f64; 2] = [0.5, 1.0];

/// Limits of a joint; `None` stands for unlimited.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SingleJointLimits {
    /// Positions [rad or m].
    pub position: Option<Range>,
    /// Largest velocity in either direction [rad/s or m/s]; `None` if the URDF has none, or 0.
    pub velocity: Option<f64>,
    /// Largest acceleration in either direction [rad/s² or m/s²].
    pub acceleration: Option<f64>,
    /// Largest torque or force in either direction [Nm or N].
    pub effort: Option<f64>,
}

/// A joint outside its position limits.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("joint {joint:?}: {position} {unit} is outside its limits {} to {} {unit}", limits.lower, limits.upper)]
pub struct LimitFault {
    /// Name of the joint.
    pub joint: String,
    /// Its position [rad or m].
    pub position: f64,
    /// Its position limits [rad or m].
    pub limits: Range,
    /// "rad" or "m".
    pub unit: &'static str,
}

/// A robot: a tree of links with limits, bodies and shapes. It is constant once it is read.
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
    /// Reads a URDF. `name` identifies the text in messages. `meshes` returns the bytes of a collision mesh, given its
    /// file name in the URDF, or an error text. Visual geometry is not read here, but by
    /// [`Appearance`](super::Appearance).
    ///
    /// # Errors
    /// If the text is no URDF or exceeds a limit, or if [`check`](super::check) finds errors: [`RobotError::Unusable`]
    /// holds all of them.
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
        let (order, parents) = tree_order(&urdf);
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

    /// Name of the robot in its URDF.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Links, a parent before its children; the first is the root.
    pub fn links(&self) -> &[Link] {
        &self.links
    }

    /// Joints along the tree: joint i is above link i + 1.
    pub fn joints(&self) -> &[Joint] {
        &self.joints
    }

    /// Joints that move by themselves, in the order of every array of positions.
    pub fn variables(&self) -> &[JointId] {
        &self.variables
    }

    /// Number n of variables: joints that move by themselves, without followers. It is the length of every array of
    /// positions, velocities and efforts.
    pub fn dof(&self) -> usize {
        self.variables.len()
    }

    /// Warnings and notes on the URDF; errors keep a robot from being made.
    pub fn diagnostics(&self) -> &[Diagnostic] {
        &self.diagnostics
    }

    pub(crate) fn replace_body(&mut self, link: LinkId, body: Body) {
        self.links[link.0].body = Some(body);
    }

    /// Removes the effort limits of joints that springs or weights carry, so that their efforts are not checked.
    ///
    /// # Panics
    /// If a joint belongs to another, larger robot.
    pub fn remove_effort_limits(&mut self, joints: &[JointId]) {
        for joint in joints {
            self.joints[joint.0].limits.effort = None;
        }
    }

    /// The root link, whose frame is the world.
    pub const fn root(&self) -> LinkId {
        LinkId(0)
    }

    /// Returns a link and all links that it carries, by fixed and moving joints, a parent before its children.
    ///
    /// # Panics
    /// If the link belongs to another, larger robot.
    pub fn carried_links(&self, first: LinkId) -> Vec<LinkId> {
        let mut is_carried = vec![false; self.links().len()];
        is_carried[first.index()] = true;
        let mut links = vec![first];
        for joint in self.joints() {
            if is_carried[joint.parent.index()] {
                is_carried[joint.child.index()] = true;
                links.push(joint.child);
            }
        }
        links
    }

    /// Iterates over the joints from the one above a link up to the root.
    ///
    /// # Panics
    /// If the link belongs to another, larger robot.
    pub fn joints_above(&self, link: LinkId) -> impl Iterator<Item = &Joint> {
        let holder = |link: LinkId| Some(&self.joints[self.links[link.0].parent?.0]);
        std::iter::successors(holder(link), move |joint| holder(joint.parent))
    }

    /// Returns the link of this name.
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

    /// Returns the joint of this name.
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

    /// Returns the joint of variable `i`.
    ///
    /// # Panics
    /// If the robot has no variable `i`.
    pub fn variable(&self, i: usize) -> &Joint {
        &self.joints[self.variables[i].0]
    }

    /// Iterates over the joints that follow others.
    pub fn followers(&self) -> impl Iterator<Item = &Joint> {
        let joints = self.joints.iter().enumerate();
        joints
            .filter(|(i, joint)| {
                joint.kind != JointKind::Fixed && !self.variables.contains(&JointId(*i))
            })
            .map(|(_, joint)| joint)
    }

    /// Returns a fault for every joint that the positions `q` (n) put outside its limits, in the order of the joints.
    /// Followers are included, which checks coupled limits.
    ///
    /// # Errors
    /// If `q` does not have n finite values.
    pub fn limit_faults(&self, q: &[f64]) -> Result<Vec<LimitFault>, RobotError> {
        self.check_values("positions", q)?;
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

    /// Checks that an array has n finite values.
    pub(super) fn check_values(
        &self,
        what: &'static str,
        values: &[f64],
    ) -> Result<(), RobotError> {
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

/// Returns the indices of the links along the tree, and of the joint above each link but the root.
fn tree_order(urdf: &Urdf) -> (Vec<usize>, Vec<usize>) {
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
            // Many URDFs have 0 where a limit is unknown.
            let rate = |limit: Option<f64>| limit.filter(|most| *most > 0.0);
            SingleJointLimits {
                position,
                velocity: rate(limit.velocity),
                acceleration: rate(limit.acceleration),
                effort: rate(limit.effort),
            }
        },
    }
}

/// Expresses joints that follow others as sums of variables; the rules have no cycles.
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

/// Returns the motion of a joint from its frame at position 0 to its frame at `position`.
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
