//! The frames of a robot that move against each other: links that are fixed to each other share one.

use super::super::frame::{Frame, z_to};
use super::super::{JointKind, RobotModel};
use crate::geometry::Pose;
use nalgebra::Translation3;

/// The frames of a robot, a parent before its children. Frame 0 stands still: it is the root link's.
#[derive(Debug, Clone)]
pub(super) struct LinkFrames {
    /// What moves frame i + 1.
    joints: Vec<MovingJoint>,
}

#[derive(Debug, Clone)]
struct MovingJoint {
    parent: usize,
    /// At position zero; its z axis is the axis of the joint.
    parent_from_this: Frame,
    slides: bool,
    offset: f64,
    /// Pairs of a variable and its factor.
    terms: Vec<(usize, f64)>,
}

/// Where a link is: fixed to which frame, and how.
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
    /// The frames of a robot, and where each of its links is.
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
            let joint_from_axis = Pose::from_parts(Translation3::identity(), z_to(&joint.axis));
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

    /// How many there are, the root's included.
    pub fn count(&self) -> usize {
        self.joints.len() + 1
    }

    /// The frames from this one up to the root's, without the latter.
    pub fn upward(&self, frame: usize) -> impl Iterator<Item = usize> {
        let above = |frame: &usize| Some(self.joints[frame.checked_sub(1)?].parent);
        std::iter::successors(Some(frame), above).take_while(|&frame| frame > 0)
    }

    /// Places these frames in the world, a parent before its children.
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

    /// Calls `visit` with each frame that moves one of two frames but not both, and whether it is the
    /// first that it moves; from the leaves to where they meet.
    fn between(&self, mut a: usize, mut b: usize, mut visit: impl FnMut(usize, bool)) {
        // A child's number is greater than its parent's.
        while a != b {
            let first = a > b;
            visit(a.max(b), first);
            let end = if first { &mut a } else { &mut b };
            *end = self.joints[*end - 1].parent;
        }
    }

    /// Whether one frame moves in the other when these variables do.
    pub fn moves(&self, a: usize, b: usize, is_moved: &[bool]) -> bool {
        let mut moves = false;
        self.between(a, b, |frame, _| {
            let terms = &self.joints[frame - 1].terms;
            moves |= terms.iter().any(|&(variable, _)| is_moved[variable]);
        });
        moves
    }

    /// Upper bound on how far any two points of two frames, at most `reach` from their origins [m],
    /// move against each other between two configurations on a straight joint segment [m].
    ///
    /// A joint that turns by δ moves a point by at most δ times its distance from the joint, which is
    /// at most the sum of the lengths between (Schwarzer, Saha, Latombe 2005).
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
