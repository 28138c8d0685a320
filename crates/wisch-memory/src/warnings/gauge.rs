//! The quantities of one sample.

use super::profile::StrokeSample;
use wisch::geometry::{Point2, Point3, Pose, Vector3};
use wisch::interpret::InterpretConfig;
use wisch::represent::{Surface, SurfaceShape, Task};

/// Measures the channels of a sample over a surface.
#[derive(Debug, Clone)]
pub(super) struct Gauge {
    surface: Surface,
    /// Least force of a tool in contact [N]; `None` for a tool that hovers, which is never out of contact.
    least_force: Option<f64>,
}

/// Positions of the tool in the world [m] and the force on it, in the axes of the world [N].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Touch {
    pub tool: Point3,
    pub commanded: Point3,
    pub force: Vector3,
}

impl Gauge {
    /// Returns the gauge of a task. `world_from_surface`: pose of the surface as it was believed in the round.
    pub fn new(task: &Task, world_from_surface: Pose) -> Self {
        let least_share = InterpretConfig::from_task(task).events.contact_share[1];
        Self {
            surface: Surface {
                world_from_surface,
                ..task.surface.clone()
            },
            least_force: (!task.interaction.hovers())
                .then(|| least_share * task.interaction.contact_force()),
        }
    }

    /// Measures a sample.
    pub fn measure(&self, touch: &Touch) -> StrokeSample {
        let chart = |point| {
            let chart = self.surface.chart(point);
            (Point2::new(chart.place.x, chart.place.y), chart.height)
        };
        let (place, height) = chart(touch.tool);
        let (wanted, _) = chart(touch.commanded);
        let world_from_surface = &self.surface.world_from_surface;
        let in_surface = world_from_surface.rotation.inverse() * touch.force;
        let force = match &self.surface.shape {
            SurfaceShape::Plane => in_surface.z,
            shape => (shape.orientation(place).inverse() * in_surface).z,
        };
        StrokeSample {
            force,
            height,
            tracking_error: (place - wanted).norm(),
            is_contact: self.least_force.is_none_or(|least| force >= least),
        }
    }
}
