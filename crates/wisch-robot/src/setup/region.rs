//! The region in which a ready posture holds the tool: over a known surface, or over the probable
//! place of one.

use super::postures::random_stream;
use super::{ArmChain, SetupError};
use crate::clearance::draw_posture;
use crate::geometry::{Bounds2, Point3, Pose, Vector3};
use crate::{Collision, JointKind, LinkAxis, LinkId, RobotError, RobotModel, Shape};
use nalgebra::{Translation3, UnitQuaternion};
use std::f64::consts::{FRAC_PI_2, PI};

/// Number of random postures that measure the reach of an arm.
const REACH_SAMPLES: usize = 300;
/// Height of a shoulder over the robot's root, as a share of the reach, above which the robot is taken to stand on the
/// floor before a table rather than on the table [1].
const STANDING_SHARE: f64 = 0.75;
/// Half width of the region, as a share of the reach [1].
const HALF_WIDTH: f64 = 0.2;
/// Distances before the shoulder between which the tool of an arm on a table waits, as shares of the reach [1].
const FORWARD_ON_TABLE: [f64; 2] = [0.35, 0.70];
/// Heights of the tool over the robot's root, on a table, as shares of the reach [1].
const ON_TABLE: [f64; 2] = [0.25, 0.55];
/// Distances before the shoulder of a standing robot, which may drive with its tool in front, as shares of the reach
/// [1].
const FORWARD_STANDING: [f64; 2] = [0.30, 0.60];
/// Depths of the tool under the shoulder of a standing robot, as shares of the reach [1].
const BELOW_SHOULDER: [f64; 2] = [0.45, 0.10];
/// Height over the floor from which a tool clears a usual table of 0.75 m \[m\].
const OVER_TABLES: f64 = 1.0;
/// Depths of the tool under the shoulder of an arm that hangs, as shares of the reach [1].
const BELOW_HANGING: [f64; 2] = [0.80, 0.40];
/// Heights of the tool over a known surface [m].
const OVER_SURFACE: [f64; 2] = [0.15, 0.40];
/// Distance of a table below the lowest link that its arm cannot lift [m].
const TABLE_GAP: f64 = 0.01;
/// Least extent of a region over a known surface, so that a small surface can be approached from
/// several places [m].
const MIN_EXTENT: f64 = 0.2;

/// A box in which the tip of an arm waits, over a surface. Its z axis is the outward normal of the surface, against
/// which the tool points.
#[derive(Debug, Clone, PartialEq)]
pub struct WipingRegion {
    /// Frame of the box in the robot's root frame.
    pub root_from_region: Pose,
    /// Least corner in this frame \[m\].
    pub low: Vector3,
    /// Greatest corner in this frame \[m\].
    pub high: Vector3,
    /// Where the region is, in words, such as "in front of the robot".
    pub place: String,
}

impl WipingRegion {
    /// Returns regions around an arm, the most likely one first: before the robot along its x axis, then to its left,
    /// to its right and behind it. Their size and height follow from the arm's reach and from the height of its
    /// shoulder: an arm whose shoulder is low stands on the table that it wipes; one whose shoulder is high stands
    /// before it.
    ///
    /// `held`: posture of the robot (n) [rad or m], from which the place of the shoulder and of a mobile base is taken.
    ///
    /// # Errors
    /// If the arm or the posture does not fit the robot.
    ///
    /// # Panics
    /// If a link of the arm belongs to another, larger robot.
    pub fn around(
        robot: &RobotModel,
        arm: &ArmChain,
        held: &[f64],
    ) -> Result<Vec<Self>, SetupError> {
        let (shoulder, reach) = measure_arm(robot, arm, held)?;
        let is_standing = shoulder.z > STANDING_SHARE * reach;
        let (forward, [low, high]) = if is_standing {
            let [low, high] = BELOW_SHOULDER.map(|share| shoulder.z - share * reach);
            // Half of the heights remain, where they would end under a table's.
            let low = low.max(OVER_TABLES.min(f64::midpoint(low, high)));
            (FORWARD_STANDING, [low, high])
        } else {
            (FORWARD_ON_TABLE, ON_TABLE.map(|share| share * reach))
        };
        let carrier = arm
            .groups
            .first()
            .map_or(robot.root(), |group| group.group.base);
        let (_, _, yaw) = (robot.forward_kinematics(held)?.world_from_link(carrier))
            .rotation
            .euler_angles();
        let (_, _, own_yaw) = (robot.forward_kinematics(&vec![0.0; robot.dof()])?)
            .world_from_link(carrier)
            .rotation
            .euler_angles();
        let places = [
            ("in front of the robot", 0.0),
            ("to the left of the robot", FRAC_PI_2),
            ("to the right of the robot", -FRAC_PI_2),
            ("behind the robot", PI),
        ];
        let around = places.map(|(place, angle)| Self {
            root_from_region: Pose::from_parts(
                Translation3::new(shoulder.x, shoulder.y, 0.0),
                UnitQuaternion::from_axis_angle(&Vector3::z_axis(), yaw - own_yaw + angle),
            ),
            low: Vector3::new(forward[0] * reach, -HALF_WIDTH * reach, low),
            high: Vector3::new(forward[1] * reach, HALF_WIDTH * reach, high),
            place: place.to_owned(),
        });
        Ok(around.to_vec())
    }

    /// Returns the region below an arm that hangs from a ceiling or a frame.
    ///
    /// `held`: posture of the robot (n) [rad or m], from which the place of the shoulder is taken.
    ///
    /// # Errors
    /// If the arm or the posture does not fit the robot.
    ///
    /// # Panics
    /// If a link of the arm belongs to another, larger robot.
    pub fn below(robot: &RobotModel, arm: &ArmChain, held: &[f64]) -> Result<Self, SetupError> {
        let (shoulder, reach) = measure_arm(robot, arm, held)?;
        let [low, high] = BELOW_HANGING.map(|share| shoulder.z - share * reach);
        let half = HALF_WIDTH * reach;
        Ok(Self {
            root_from_region: Pose::translation(shoulder.x, shoulder.y, 0.0),
            low: Vector3::new(-half, -half, low),
            high: Vector3::new(half, half, high),
            place: "below the robot (assumed to hang)".to_owned(),
        })
    }

    /// Returns the region over a known surface.
    ///
    /// - `root_from_surface`: frame of the surface in the robot's root frame; z is its outward normal.
    /// - `bounds`: extent of the surface in its frame \[m\].
    /// - `name`: name of the surface.
    pub fn from_surface(root_from_surface: Pose, bounds: &Bounds2, name: &str) -> Self {
        let middle = bounds.center();
        let half = bounds.size().map(|side| side.max(MIN_EXTENT) / 2.0);
        Self {
            root_from_region: root_from_surface,
            low: Vector3::new(middle.x - half.x, middle.y - half.y, OVER_SURFACE[0]),
            high: Vector3::new(middle.x + half.x, middle.y + half.y, OVER_SURFACE[1]),
            place: format!("over {name}"),
        }
    }

    /// Returns the region with heights over a level surface.
    ///
    /// `height`: height of the surface in the robot's root frame \[m\]. `name`: name of the
    /// surface.
    #[must_use]
    pub fn with_height(mut self, height: f64, name: &str) -> Self {
        let from_root = height - self.root_from_region.translation.z;
        self.low.z = from_root + OVER_SURFACE[0];
        self.high.z = from_root + OVER_SURFACE[1];
        self.place = format!("{}, at the height of {name}", self.place);
        self
    }
}

/// Returns the height of the table on which a robot with one fixed arm and a low shoulder stands, in the root frame
/// \[m\]: just below its lowest link that does not move or that its first joint turns, and below 0. Other robots
/// stand on the floor and have no table.
///
/// # Errors
/// If the arm or the posture does not fit the robot.
///
/// # Panics
/// If a link of an arm belongs to another, larger robot.
pub fn find_table(
    robot: &RobotModel,
    arms: &[ArmChain],
    held: &[f64],
) -> Result<Option<f64>, SetupError> {
    let [arm] = arms else {
        return Ok(None);
    };
    let (shoulder, reach) = measure_arm(robot, arm, held)?;
    let base = arm
        .groups
        .first()
        .map_or(robot.root(), |group| group.group.base);
    let moving = |link: LinkId| {
        let joints = robot.joints_above(link);
        joints
            .filter(|joint| joint.kind != JointKind::Fixed)
            .count()
    };
    if shoulder.z > STANDING_SHARE * reach || moving(base) > 0 {
        return Ok(None);
    }
    let kinematics = robot.forward_kinematics(held)?;
    let mut lowest: f64 = 0.0;
    for link in (0..robot.links().len())
        .map(LinkId)
        .filter(|&link| moving(link) <= 1)
    {
        let root_from_link = kinematics.world_from_link(link);
        let shapes = robot.links()[link.index()].collision.iter();
        lowest = shapes
            .map(|shape| lowest_point(&root_from_link, shape))
            .fold(lowest, f64::min);
    }
    Ok(Some(lowest - TABLE_GAP))
}

/// Returns how far the shapes of a link, and of all links that it carries, reach along an axis of it from its origin, at
/// least 0 \[m\]: where a hand or gripper ends.
///
/// `q`: posture of the robot (n) [rad or m], for the joints of a gripper.
///
/// # Errors
/// If the posture does not fit the robot.
///
/// # Panics
/// If the link belongs to another, larger robot.
pub fn hand_extent(
    robot: &RobotModel,
    tip: LinkId,
    axis: LinkAxis,
    q: &[f64],
) -> Result<f64, RobotError> {
    let kinematics = robot.forward_kinematics(q)?;
    // The hand upside down: its end is the lowest point.
    let hand_from_tip = LinkAxis::NegativeZ.frame() * axis.frame().inverse();
    let hand_from_root = hand_from_tip * kinematics.world_from_link(tip).inverse();
    let ends = robot.carried_links(tip).into_iter().flat_map(|link| {
        let hand_from_link = hand_from_root * kinematics.world_from_link(link);
        let shapes = robot.links()[link.index()].collision.iter();
        shapes.map(move |shape| -lowest_point(&hand_from_link, shape))
    });
    Ok(ends.fold(0.0, f64::max))
}

/// Returns the least height of a shape in the root frame \[m\].
///
/// `root_from_link`: pose of the shape's link in the root frame \[m\].
pub fn lowest_point(root_from_link: &Pose, collision: &Collision) -> f64 {
    let root_from_shape = root_from_link * collision.link_from_shape;
    let height = |x: f64, y: f64, z: f64| (root_from_shape * Point3::new(x, y, z)).z;
    let axis_z = (root_from_shape.rotation * Vector3::z()).z.abs();
    let middle = height(0.0, 0.0, 0.0);
    match &collision.shape {
        Shape::Sphere { radius } => middle - radius,
        Shape::Capsule { radius, length } => middle - axis_z * length / 2.0 - radius,
        Shape::Cylinder { radius, length } => {
            middle - axis_z * length / 2.0 - radius * (1.0 - axis_z * axis_z).max(0.0).sqrt()
        }
        Shape::Box { size } => {
            let turned = root_from_shape.rotation.to_rotation_matrix();
            middle
                - (0..3)
                    .map(|i| turned[(2, i)].abs() * size[i] / 2.0)
                    .sum::<f64>()
        }
        Shape::Mesh(mesh) => {
            let vertices = mesh.vertices().iter();
            vertices
                .map(|v| height(v.x, v.y, v.z))
                .fold(f64::INFINITY, f64::min)
        }
    }
}

/// Returns the place of an arm's first revolute joint in the root frame, and the largest distance of its tip from there
/// in random postures [m].
fn measure_arm(
    robot: &RobotModel,
    arm: &ArmChain,
    held: &[f64],
) -> Result<(Vector3, f64), SetupError> {
    let Some(own) = arm.groups.last() else {
        return Ok((Vector3::zeros(), 0.0));
    };
    let (base, tip) = (own.group.base, own.group.tip);
    let mut first = None;
    for joint in robot.joints_above(tip) {
        if joint.kind == JointKind::Revolute {
            first = Some(joint.child);
        }
        if joint.parent == base {
            break;
        }
    }
    let first = first.unwrap_or(base);
    let place = |q: &[f64]| -> Result<(Vector3, f64), SetupError> {
        let kinematics = robot.forward_kinematics(q)?;
        let [shoulder, tip] =
            [first, tip].map(|l| kinematics.world_from_link(l).translation.vector);
        Ok((shoulder, (tip - shoulder).norm()))
    };
    let mut random = random_stream(0, 0);
    let mut reach: f64 = 0.0;
    for _ in 0..REACH_SAMPLES {
        reach = reach.max(place(&draw_posture(robot, &mut random))?.1);
    }
    Ok((place(held)?.0, reach))
}
