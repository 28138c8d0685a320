//! Ground truth of a treated surface: number of passes of the real tool over each point, and depth
//! of wear.
//!
//! A pass counts where the true pressure exceeds the point's own threshold. Wear follows Preston's law: depth = k ·
//! pressure · sliding distance (Preston 1927).

use super::Dirt;
use super::plant::{HeldTool, Plant};
use wisch::geometry::{Point2, Point3};
use wisch::represent::{Fate, Task, Treatment};

/// Treatment of the points of the real surface by the real tool.
pub(super) struct TreatedSurface {
    /// Sliding distance over a point that counts as one pass [m].
    pass_length: f64,
    /// Largest distance of the underside from the centre of its plate [m].
    reach: f64,
    /// Depth rubbed off per sliding distance, at nominal pressure [1].
    wear: f64,
}

impl TreatedSurface {
    /// Returns the treatment of a task; `None` for a task that moves dirt.
    pub fn from_task(task: &Task, tool: &HeldTool) -> Option<Self> {
        let treatment = task.treatment.filter(|_| task.action.treats())?;
        let area = tool.footprint.area();
        let preston = match treatment {
            Treatment::Polish { preston, .. } => preston.unwrap_or(0.0),
            Treatment::Dispense { .. } => 0.0,
        };
        let corners = tool.edges().map(|edge| edge.start.coords.norm());
        Some(Self {
            pass_length: area / tool.size.y,
            reach: corners.fold(0.0, f64::max),
            wear: preston * tool.press_force * tool.pressure.recip() / area,
        })
    }

    /// Treats the points under the tool for one period [s]: counts passes and adds wear.
    pub fn act(&self, plant: &Plant, dirt: &mut Dirt, tool: &HeldTool, period: f64) {
        let plate = plant.world_from_plate();
        let to_plate = plate.inverse();
        let compression = plant.compression();
        let real = plant.real();
        let middle = real.chart(Point3::from(plate.translation.vector)).place;
        for place in &mut dirt.grains {
            if (place.position - middle).norm_squared() > self.reach * self.reach {
                continue;
            }
            let at = Point3::from(
                real.world_from_place(place.position, 0.0)
                    .translation
                    .vector,
            );
            let in_plate = to_plate * at;
            let under = Point2::new(in_plate.x, in_plate.y);
            if !tool.footprint.contains(under) {
                continue;
            }
            let higher = plant.local_height(place.position).measure_over_plate();
            let pressure = compression.pressure(under, higher, tool);
            if pressure < place.threshold {
                continue;
            }
            let normal = real.normal(place.position);
            let velocity = plant.plate_velocity(&at);
            // Only the velocity in the surface slides: v − n (n · v).
            let slid = (velocity - normal * normal.dot(&velocity)).norm() * period;
            let passes = place.fate.passes() + slid / self.pass_length;
            place.fate = Fate::Treated { passes };
            place.wear += self.wear * pressure * slid;
        }
    }
}
