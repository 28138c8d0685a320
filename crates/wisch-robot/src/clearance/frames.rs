//! The frames of a robot that move against each other. Links that are fixed to each other share a frame.

use super::super::frame::{Frame, rotation_from_z};
use super::super::{JointKind, RobotModel};
use crate::geometry::Pose;
use nalgebra::Translation3;

/// The frames of a robot, a parent before its children. Frame 0 is that of the root link and does not move.
#[derive(Debug, Clone)]
pub(super) struct LinkFrames {
    /// Joint that moves frame i + 1.
    joints: Vec<MovingJoint>,
}

#[derive(Debug, Clone)]
struct MovingJoint {
    parent: usize,
    /// Transform from the parent at position 0; the z axis is the joint's axis.
    parent_from_this: Frame,
    slides: bool,
    offset: f64,
    /// Pairs of a variable and its factor.
    terms: Vec<(usize, f64)>,
}

/// Frame to which a link is fixed, and its pose there.
#[derive(Debug, Clone, Copy)]
pub(super) struct Mount {
    pub frame: usize,
    pub frame_from_link: Pose,
}

impl MovingJoint {
    fn position(&self, q: &[f64]) -> f64 {
        self.offset + self.rate(q)
    }

    fn rate(&self, qd: &[f64]) -> f64 {
        self.terms.iter().map(|&(i, factor)| factor * qd[i]).sum()
    }
}

impl LinkFrames {
    /// Returns the frames of a robot, and the mount of each link.
    pub fn new(robot: &RobotModel) -> (Self, Vec<Mount>) {
        let mut joints: Vec<MovingJoint> = Vec::new();
        let mut mounts = vec![Mount {
            frame: 0,
            frame_from_link: Pose::identity(),
        }];
        for joint in robot.joints() {
            let parent = mounts[joint.parent.index()];
            let frame_from_joint = parent.frame_from_link * joint.parent_from_joint;
            if joint.kind == JointKind::Fixed {
                mounts.push(Mount {
                    frame: parent.frame,
                    frame_from_link: frame_from_joint,
                });
                continue;
            }
            let joint_from_axis =
                Pose::from_parts(Translation3::identity(), rotation_from_z(&joint.axis));
            joints.push(MovingJoint {
                parent: parent.frame,
                parent_from_this: Frame::from_pose(&(frame_from_joint * joint_from_axis)),
                slides: joint.kind == JointKind::Prismatic,
                offset: joint.drive.offset,
                terms: joint.drive.terms.clone(),
            });
            mounts.push(Mount {
                frame: joints.len(),
                frame_from_link: joint_from_axis.inverse(),
            });
        }
        (Self { joints }, mounts)
    }

    /// Number of frames, including the root's.
    pub fn count(&self) -> usize {
        self.joints.len() + 1
    }

    /// Iterates from a frame up to the root's, which is excluded.
    pub fn upward(&self, frame: usize) -> impl Iterator<Item = usize> {
        let above = |frame: &usize| Some(self.joints[frame.checked_sub(1)?].parent);
        std::iter::successors(Some(frame), above).take_while(|&frame| frame > 0)
    }

    /// Computes the poses of these frames in the world; a parent must come before its children.
    pub fn place(&self, wanted: &[usize], q: &[f64], world_from_frame: &mut Vec<Frame>) {
        world_from_frame.resize(self.count(), Frame::identity());
        for &frame in wanted {
            let joint = &self.joints[frame - 1];
            let mut placed = world_from_frame[joint.parent].then(&joint.parent_from_this);
            let position = joint.position(q);
            let [x, y, axis] = placed.axes;
            if joint.slides {
                placed.translation += position * axis;
            } else {
                let (sin, cos) = position.sin_cos();
                placed.axes = [cos * x + sin * y, cos * y - sin * x, axis];
            }
            world_from_frame[frame] = placed;
        }
    }

    /// Calls `visit` with each frame that moves one of two frames but not both, and whether it moves the first one,
    /// from the frames up to their common ancestor.
    fn between(&self, mut a: usize, mut b: usize, mut visit: impl FnMut(usize, bool)) {
        // A child has a greater index than its parent.
        while a != b {
            let first = a > b;
            visit(a.max(b), first);
            let end = if first { &mut a } else { &mut b };
            *end = self.joints[*end - 1].parent;
        }
    }

    /// Whether two frames move against each other when these variables change.
    pub fn moves(&self, a: usize, b: usize, is_moved: &[bool]) -> bool {
        let mut moves = false;
        self.between(a, b, |frame, _| {
            let terms = &self.joints[frame - 1].terms;
            moves |= terms.iter().any(|&(variable, _)| is_moved[variable]);
        });
        moves
    }

    /// Returns an upper bound [m] on how far any two points of two frames move against each other between two
    /// configurations on a straight joint segment. `reach`: largest distance of the points from their frames' origins
    /// [m].
    ///
    /// A joint that rotates by δ moves a point by at most δ times its distance from the joint, which is at most the sum
    /// of the lengths between them (Schwarzer, Saha, Latombe 2005).
    pub fn motion(&self, [a, b]: [usize; 2], reach: [f64; 2], from: &[f64], to: &[f64]) -> f64 {
        let [mut reach_a, mut reach_b] = reach;
        let mut bound = 0.0;
        self.between(a, b, |frame, first| {
            let joint = &self.joints[frame - 1];
            let reach = if first { &mut reach_a } else { &mut reach_b };
            let (start, end) = (joint.position(from), joint.position(to));
            let change = (end - start).abs();
            if joint.slides {
                bound += change;
                *reach += start.abs().max(end.abs());
            } else {
                bound += change * *reach;
            }
            *reach += joint.parent_from_this.translation.norm();
        });
        bound
    }
}
