//! What a plan file assumes that differs from the task for which it is used.

use super::plan::WaypointRecord;
use super::{GoalRecord, PlanRecord};
use nalgebra::{Quaternion, UnitQuaternion};
use std::f64::consts::TAU;
use wisch::geometry::{Point2, Pose, Vector3};
use wisch::plan::{Plan, TcpWaypoint};
use wisch::represent::Task;

/// Differences in position \[m\], in length \[m\] and in angle \[rad\] up to which two values are the same.
const SAME_POSITION: f64 = 1e-3;
const SAME_LENGTH: f64 = 1e-4;
const SAME_ANGLE: f64 = 1e-3;
/// Number of turns of a heading up to which it is taken for radians.
const MOST_TURNS: f64 = 2.0;

impl PlanRecord {
    /// Describes the differences between the task of the record's `plan` and `task`, one sentence
    /// each, that leave the plan usable: of the pose of the surface, the size of the tool, and the
    /// goal. Further sentences state that the path of the record is not that of its strokes, or
    /// that a heading has several turns. Empty if nothing differs.
    ///
    /// ```
    /// # fn describe(record: &wisch_io::PlanRecord, plan: &wisch::plan::Plan, task: &wisch::represent::Task) {
    /// for sentence in record.describe_differences(plan, task) {
    ///     eprintln!("plan.json: {sentence}");
    /// }
    /// # }
    /// ```
    pub fn describe_differences(&self, plan: &Plan, task: &Task) -> Vec<String> {
        let differences = [
            self.describe_many_turns(),
            self.describe_other_path(plan),
            self.describe_moved_surface(task),
            self.describe_other_tool(task),
            self.describe_other_goal(task),
        ];
        differences.into_iter().flatten().collect()
    }

    /// States headings of several turns: they may be degrees.
    fn describe_many_turns(&self) -> Option<String> {
        let poses = self
            .strokes
            .iter()
            .flat_map(|stroke| &stroke.surface_from_tool);
        let heading = poses
            .map(|pose| pose.heading_rad)
            .max_by(|a, b| a.abs().total_cmp(&b.abs()))?;
        (heading.abs() > MOST_TURNS * TAU).then(|| {
            format!("a heading_rad of {heading} is {:.0} turns; headings are read in radians, not in degrees", heading / TAU)
        })
    }

    fn describe_other_path(&self, plan: &Plan) -> Option<String> {
        let path = plan.tcp_path();
        let is_same = |(recorded, corner): (&WaypointRecord, &TcpWaypoint)| {
            let WaypointRecord {
                x_m,
                y_m,
                height_m,
                heading_rad,
            } = *recorded;
            let pose = &corner.surface_from_tool;
            (Point2::new(x_m, y_m) - pose.position).norm() <= SAME_POSITION
                && (height_m - corner.height).abs() <= SAME_POSITION
                && (heading_rad - pose.heading).abs() <= SAME_ANGLE
        };
        let is_whole = self.tcp_path.len() == path.len();
        let is_stated = !self.tcp_path.is_empty();
        (is_stated && !(is_whole && self.tcp_path.iter().zip(&path).all(is_same))).then(|| {
            "tcp_path differs from the path of the strokes; it is not used, and the strokes and \
             lift_height_m count"
                .to_owned()
        })
    }

    fn describe_moved_surface(&self, task: &Task) -> Option<String> {
        let planned = &self.world_from_surface;
        let [x, y, z, w] = planned.rotation_xyzw;
        let planned = Pose::from_parts(
            Vector3::from(planned.translation_m).into(),
            UnitQuaternion::new_normalize(Quaternion::new(w, x, y, z)),
        );
        let moved = planned.inverse() * task.surface.world_from_surface;
        let (distance, angle) = (moved.translation.vector.norm(), moved.rotation.angle());
        let has_moved = distance > SAME_POSITION || angle > SAME_ANGLE;
        if !has_moved {
            return None;
        }
        let at = |point: Vector3| format!("({:.3}, {:.3}, {:.3}) m", point.x, point.y, point.z);
        Some(format!(
            "the plan was made for the surface at {}; in the task it is at {}, turned by {:.1}°. The strokes are kept in \
             the frame of the surface, so they move with it",
            at(planned.translation.vector),
            at(task.surface.world_from_surface.translation.vector),
            angle.to_degrees()
        ))
    }

    fn describe_other_tool(&self, task: &Task) -> Option<String> {
        let radius = task.tool.collision_radius();
        ((self.collision_radius_m - radius).abs() > SAME_LENGTH).then(|| {
            format!(
                "the plan was made for a tool whose collision sphere has a radius of {:.1} mm; the task's {} has {:.1} mm. \
                 Its strokes are checked and predicted with the task's tool",
                1e3 * self.collision_radius_m,
                task.tool.name,
                1e3 * radius
            )
        })
    }

    fn describe_other_goal(&self, task: &Task) -> Option<String> {
        let (plan, of_task) = match (self.goal, task.goal().map(GoalRecord::from)?) {
            (
                GoalRecord::Collected {
                    center_in_surface_m: plan,
                    ..
                },
                GoalRecord::Collected {
                    center_in_surface_m: task,
                    ..
                },
            ) => {
                let (from, to) = (Point2::from(plan), Point2::from(task));
                let at = |point: Point2| format!("collects at ({:.3}, {:.3}) m", point.x, point.y);
                ((from - to).norm() > SAME_POSITION).then(|| (at(from), at(to)))?
            }
            (GoalRecord::Polished { passes: plan }, GoalRecord::Polished { passes: task }) => {
                let passes = |passes: u32| format!("polishes with {passes} passes");
                (plan != task).then(|| (passes(plan), passes(task)))?
            }
            (
                GoalRecord::Dispensed {
                    thickness_m: plan, ..
                },
                GoalRecord::Dispensed {
                    thickness_m: task, ..
                },
            ) => {
                let coat =
                    |thickness: f64| format!("dispenses a coat of {:.4} mm", 1e3 * thickness);
                ((plan - task).abs() > 1e-9).then(|| (coat(plan), coat(task)))?
            }
            _ => return None,
        };
        Some(format!(
            "the plan {plan}, the task {of_task}: results are compared with the goal of the task"
        ))
    }
}
