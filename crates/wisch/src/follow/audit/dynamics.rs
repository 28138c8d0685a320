//! Efforts of the audit: joint efforts for the robot's own weight and inertia and for the press force, link by link.
//!
//! Newton-Euler equations of every link in the frame of the root, summed from the links outward (Luh, Walker,
//! Paul 1980).

use super::kinematics::{Frame, moved_by};
use crate::follow::{TrajectorySample, Workcell};
use crate::geometry::Vector3;
use crate::represent::Task;
use crate::robot::{Joint, JointKind, RobotModel};

/// Motion of a link, in the frame of the root.
#[derive(Debug, Clone)]
struct LinkMotion {
    frame: Frame,
    angular_velocity: Vector3,
    angular_acceleration: Vector3,
    /// Acceleration of its origin, less gravity.
    acceleration: Vector3,
}

/// Force of the surface on a tool.
#[derive(Debug, Clone, Copy)]
pub(super) struct ToolLoad<'a> {
    pub(super) cell: &'a Workcell,
    pub(super) task: &'a Task,
    /// Size of the force, along the surface's outward normal [N].
    pub(super) force: f64,
}

/// Returns the effort of every joint [Nm or N] in the order of the robot's, as if each had its own drive; 0 for
/// a fixed joint. Gravity is given in the frame of the root [m/s²].
pub(super) fn joint_efforts(
    robot: &RobotModel,
    sample: &TrajectorySample,
    gravity_in_root: Vector3,
    load: Option<&ToolLoad<'_>>,
) -> Vec<f64> {
    let rate = |joint: &Joint, of: &[f64]| -> f64 {
        let terms = joint.drive.terms.iter();
        terms.map(|(i, factor)| factor * of[*i]).sum()
    };
    let mut links = vec![LinkMotion {
        frame: Frame::identity(),
        angular_velocity: Vector3::zeros(),
        angular_acceleration: Vector3::zeros(),
        acceleration: -gravity_in_root,
    }];
    let mut axes = Vec::with_capacity(robot.joints().len());
    for joint in robot.joints() {
        let parent = &links[joint.parent.index()];
        let frame = parent.frame.then(&moved_by(joint, &sample.q));
        let axis = frame.rotation * joint.axis.into_inner();
        let (speed, change) = (rate(joint, &sample.qd), rate(joint, &sample.qdd));
        let (spin, turn) = (parent.angular_velocity, parent.angular_acceleration);
        let arm = frame.origin - parent.frame.origin;
        let mut link = LinkMotion {
            frame,
            angular_velocity: spin,
            angular_acceleration: turn,
            // a = a_parent + α × r + ω × (ω × r).
            acceleration: parent.acceleration + turn.cross(&arm) + spin.cross(&spin.cross(&arm)),
        };
        match joint.kind {
            JointKind::Fixed => {}
            JointKind::Revolute => {
                link.angular_velocity += axis * speed;
                link.angular_acceleration += axis * change + spin.cross(&axis) * speed;
            }
            JointKind::Prismatic => {
                link.acceleration += axis * change + 2.0 * speed * spin.cross(&axis);
            }
        }
        links.push(link);
        axes.push(axis);
    }
    // For each link with all links that it carries: force, and moment about the origin of the root.
    let mut wrenches: Vec<(Vector3, Vector3)> = (robot.links().iter().zip(&links))
        .map(|(link, motion)| {
            let Some(body) = &link.body else {
                return (Vector3::zeros(), Vector3::zeros());
            };
            let rotation = motion.frame.rotation;
            let (spin, turn) = (motion.angular_velocity, motion.angular_acceleration);
            let arm = rotation * body.center_in_link.coords;
            let inertia = rotation * body.inertia_about_center * rotation.transpose();
            let force = body.mass
                * (motion.acceleration + turn.cross(&arm) + spin.cross(&spin.cross(&arm)));
            // Euler: moment = I α + ω × (I ω).
            let moment = inertia * turn + spin.cross(&(inertia * spin));
            (force, moment + (motion.frame.origin + arm).cross(&force))
        })
        .collect();
    if let Some(load) = load {
        // The surface carries the press force, and the joints carry the rest.
        let tip = load.cell.tip().index();
        let Frame { rotation, origin } = links[tip].frame;
        let place = origin + rotation * load.cell.tip_from_tool().translation.vector;
        let reaction = load.cell.normal_at(load.task, place) * load.force;
        let (force, moment) = &mut wrenches[tip];
        *force -= reaction;
        *moment -= place.cross(&reaction);
    }
    let mut efforts = vec![0.0; axes.len()];
    for (i, joint) in robot.joints().iter().enumerate().rev() {
        let (force, moment) = wrenches[joint.child.index()];
        let origin = links[joint.child.index()].frame.origin;
        efforts[i] = match joint.kind {
            JointKind::Fixed => 0.0,
            JointKind::Revolute => axes[i].dot(&(moment - origin.cross(&force))),
            JointKind::Prismatic => axes[i].dot(&force),
        };
        let below = &mut wrenches[joint.parent.index()];
        below.0 += force;
        below.1 += moment;
    }
    efforts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn efforts_are_those_of_the_robots_own_dynamics() {
        let urdf = include_str!("../../../../../robots/humanoid.urdf");
        let robot = RobotModel::from_urdf("humanoid", urdf, &mut |_| Err(String::new())).unwrap();
        let gravity = Vector3::new(0.3, -0.2, -9.7);
        let wave = |rate: f64| -> Vec<f64> {
            (0..robot.dof())
                .map(|i| (rate * (i + 1) as f64).sin())
                .collect()
        };
        let sample = TrajectorySample {
            time: 0.0,
            q: wave(0.7),
            qd: wave(1.3),
            qdd: wave(2.9),
        };
        let efforts = joint_efforts(&robot, &sample, gravity, None);
        let mut of_variables = vec![0.0; robot.dof()];
        for (joint, effort) in robot.joints().iter().zip(efforts) {
            for &(variable, factor) in &joint.drive.terms {
                of_variables[variable] += factor * effort;
            }
        }
        let TrajectorySample { q, qd, qdd, .. } = &sample;
        let dynamics = robot.dynamics().unwrap();
        let expected = dynamics.inverse_dynamics(q, qd, qdd, gravity).unwrap();
        for (i, (found, expected)) in of_variables.iter().zip(expected.iter()).enumerate() {
            assert!(
                (found - expected).abs() < 1e-9,
                "variable {i}: {found}, expected {expected}"
            );
        }
    }
}
