//! What a plan file assumes that differs from the task for which it is used.

use super::{GoalRecord, PlanRecord};
use nalgebra::{Quaternion, UnitQuaternion};
use wisch::geometry::{Point2, Pose, Vector3};
use wisch::represent::Task;

/// Differences in position \[m\], in length \[m\] and in angle \[rad\] up to which two values are the same.
const SAME_POSITION: f64 = 1e-3;
const SAME_LENGTH: f64 = 1e-4;
const SAME_ANGLE: f64 = 1e-3;

impl PlanRecord {
    /// Describes in sentences in what the task of the plan differs from `task`, where the plan is usable for both: the
    /// pose of the surface, the size of the tool, and the goal. Empty if nothing differs.
    ///
    /// ```
    /// # fn describe(record: &wisch_io::PlanRecord, task: &wisch::represent::Task) {
    /// for sentence in record.describe_differences(task) {
    ///     eprintln!("plan.json: {sentence}");
    /// }
    /// # }
    /// ```
    pub fn describe_differences(&self, task: &Task) -> Vec<String> {
        let differences = [
            self.describe_moved_surface(task),
            self.describe_other_tool(task),
            self.describe_other_goal(task),
        ];
        differences.into_iter().flatten().collect()
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
