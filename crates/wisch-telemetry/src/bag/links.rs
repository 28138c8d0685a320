//! Frames of a robot's links, as transforms.

use super::topic::{FRAME_SURFACE, FRAME_TOOL, FRAME_WORLD};
use wisch::geometry::Pose;
use wisch::robot::{Joint, JointKind, JointMotion, JointTransform, RobotModel};

/// Prefix of a link whose name equals a frame of the bag itself.
const PREFIX: &str = "robot/";

/// The robot that a bag shows.
#[derive(Debug, Clone, Copy)]
pub struct BagRobot<'a> {
    /// URDF of the robot, as text.
    pub urdf: &'a str,
    /// Model of the robot; its variables are those of the samples, in their order.
    pub model: &'a RobotModel,
    /// Pose of its root link in the world.
    pub world_from_root: Pose,
}

/// Frames of a robot's links: each in the frame of its parent link, the root in the world.
#[derive(Debug, Clone, Default)]
pub(super) struct LinkFrames {
    /// Fixed transforms: parent, child, and pose of the child in the parent.
    pub standing: Vec<(String, String, Pose)>,
    moving: Vec<Moving>,
}

/// A moving joint.
#[derive(Debug, Clone)]
struct Moving {
    transform: JointTransform,
    joint: Joint,
}

impl LinkFrames {
    pub fn new(robot: &BagRobot<'_>) -> Self {
        let links = robot.model.links();
        let root = &links[0].name;
        // Many descriptions call the floor their root, which is then the world's frame.
        let root_is_world = root == FRAME_WORLD && robot.world_from_root == Pose::identity();
        let frame = |index: usize| match links[index].name.as_str() {
            name if index == 0 && root_is_world => name.to_owned(),
            name @ (FRAME_WORLD | FRAME_TOOL | FRAME_SURFACE) => format!("{PREFIX}{name}"),
            name => name.to_owned(),
        };
        let mut frames = Self::default();
        if !root_is_world {
            let root = (FRAME_WORLD.to_owned(), frame(0), robot.world_from_root);
            frames.standing.push(root);
        }
        for joint in robot.model.joints() {
            let (parent, child) = (frame(joint.parent.index()), frame(joint.child.index()));
            let motion = match joint.kind {
                JointKind::Fixed => JointMotion::Fixed,
                JointKind::Revolute => JointMotion::Revolute(joint.axis),
                JointKind::Prismatic => JointMotion::Prismatic(joint.axis),
            };
            let transform = JointTransform {
                joint: joint.name.clone(),
                parent,
                child,
                parent_from_joint: joint.parent_from_joint,
                motion,
                mimic: None,
            };
            if joint.drive.terms.is_empty() {
                let pose = transform.parent_from_child(joint.drive.offset);
                (frames.standing).push((transform.parent, transform.child, pose));
            } else {
                let joint = joint.clone();
                frames.moving.push(Moving { transform, joint });
            }
        }
        frames
    }

    /// Returns the moving transforms at positions of the robot's variables [rad or m]: parent, child, and pose of the
    /// child in the parent.
    pub fn poses(&self, q: &[f64]) -> impl Iterator<Item = (&str, &str, Pose)> {
        self.moving.iter().map(|Moving { transform, joint }| {
            let pose = transform.parent_from_child(joint.drive.position(q));
            (transform.parent.as_str(), transform.child.as_str(), pose)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const URDF: &str = r#"<robot name="lift"><link name="world"/><link name="tool"/><link name="plate"/><link name="tip"/>
        <joint name="spindle" type="prismatic"><parent link="world"/><child link="tool"/><origin xyz="0 0 0.4"/>
        <axis xyz="0 0 1"/><limit lower="0" upper="1" velocity="1" effort="1"/></joint>
        <joint name="turn" type="continuous"><parent link="tool"/><child link="plate"/><axis xyz="0 0 1"/></joint>
        <joint name="end" type="fixed"><parent link="plate"/><child link="tip"/><origin xyz="0.1 0 0"/></joint></robot>"#;

    fn frames(world_from_root: Pose) -> LinkFrames {
        let model = RobotModel::from_urdf("lift", URDF, &mut |_| Err(String::new())).unwrap();
        LinkFrames::new(&BagRobot {
            urdf: URDF,
            model: &model,
            world_from_root,
        })
    }

    fn names<'a>(
        triples: impl IntoIterator<Item = (&'a str, &'a str, Pose)>,
    ) -> Vec<(&'a str, &'a str)> {
        triples.into_iter().map(|(a, b, _)| (a, b)).collect()
    }

    fn standing(frames: &LinkFrames) -> Vec<(&str, &str)> {
        names(frames.standing.iter().map(|(a, b, p)| (&**a, &**b, *p)))
    }

    #[test]
    fn links_keep_their_names_unless_the_bag_uses_them() {
        let here = frames(Pose::identity());
        assert_eq!(standing(&here), [("plate", "tip")]);
        let moving = [("world", "robot/tool"), ("robot/tool", "plate")];
        assert_eq!(names(here.poses(&[0.0; 2])), moving);
        let there = frames(Pose::translation(1.0, 0.0, 0.0));
        assert_eq!(
            standing(&there),
            [("world", "robot/world"), ("plate", "tip")]
        );
        assert_eq!(names(there.poses(&[0.0; 2]))[0].0, "robot/world");
    }

    #[test]
    fn frames_agree_with_the_robots_kinematics() {
        let model = RobotModel::from_urdf("lift", URDF, &mut |_| Err(String::new())).unwrap();
        let frames = frames(Pose::identity());
        let q = [0.3, 1.1];
        let kinematics = model.forward_kinematics(&q).unwrap();
        let moved: Vec<_> = frames.poses(&q).map(|(.., pose)| pose).collect();
        let world_from_tip = moved[0] * moved[1] * frames.standing[0].2;
        let expected = kinematics.world_from_link(model.link("tip").unwrap());
        assert!((world_from_tip.to_matrix() - expected.to_matrix()).norm() < 1e-12);
    }
}
