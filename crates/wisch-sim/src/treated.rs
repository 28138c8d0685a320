//! The surface of a world that is treated: how often the real tool slides over each of its places, and what that rubs off.
//!
//! A place counts where the true pressure on it exceeds its own threshold, and wears by Preston's law: depth over pressure and way
//! (Preston 1927).

use super::Dirt;
use super::plant::{Plant, Wielded};
use crate::SimulationSettings;
use wisch::geometry::{Point2, Point3, Pose};
use wisch::represent::{Fate, Task, Treatment};

/// How the real tool treats the places of the real surface.
pub(super) struct TreatedSurface {
    world_from_real: Pose,
    /// Way over a place that counts as one pass [m].
    pass_length: f64,
    /// Largest distance of the underside from the middle of its plate [m].
    reach: f64,
    /// Depth rubbed off on a way, at nominal pressure [1].
    wear: f64,
}

impl TreatedSurface {
    /// Of a task; `None` for one that moves dirt.
    pub fn of(task: &Task, tool: &Wielded, settings: &SimulationSettings) -> Option<Self> {
        let treatment = task.treatment.filter(|_| task.action.treats())?;
        let area = tool.footprint.area();
        let preston = match treatment {
            Treatment::Polish { preston, .. } => preston.unwrap_or(0.0),
            Treatment::Emit { .. } => 0.0,
        };
        let corners = tool.edges().map(|edge| edge.start.coords.norm());
        Some(Self {
            world_from_real: task.surface.world_from_surface * settings.believed_from_real,
            pass_length: area / tool.size.y,
            reach: corners.fold(0.0, f64::max),
            wear: preston * tool.press_force * tool.pressure.recip() / area,
        })
    }

    /// What the tool does to the places under it in a period of so many seconds.
    pub fn act(&self, plant: &Plant, dirt: &mut Dirt, tool: &Wielded, period: f64) {
        let plate = plant.world_from_plate();
        let to_plate = plate.inverse();
        let compression = plant.compression();
        let normal = plant.normal();
        let middle = self.world_from_real.inverse() * Point3::from(plate.translation.vector);
        for place in &mut dirt.grains {
            if (place.position - middle.xy()).norm_squared() > self.reach * self.reach {
                continue;
            }
            let at = self.world_from_real * Point3::new(place.position.x, place.position.y, 0.0);
            let in_plate = to_plate * at;
            let under = Point2::new(in_plate.x, in_plate.y);
            if !tool.footprint.contains(under) {
                continue;
            }
            let [_, higher] = plant.wave(place.position);
            let pressure = compression.pressure(under, higher, tool);
            if pressure < place.threshold {
                continue;
            }
            let velocity = plant.plate_velocity(&at);
            let slid = (velocity - normal * normal.dot(&velocity)).norm() * period;
            let passes = place.fate.passes() + slid / self.pass_length;
            place.fate = Fate::Treated { passes };
            place.wear += self.wear * pressure * slid;
        }
    }
}
