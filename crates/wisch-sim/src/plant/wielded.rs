//! The tool as it really is, and how it really sits in the hand.

use crate::RealTool;
use nalgebra::{Translation3, UnitQuaternion};
use wisch::follow::Workcell;
use wisch::geometry::{Edge, Point2, Point3, Polygon, Pose, Region, Vector2, Vector3};
use wisch::represent::Task;

/// What a rigid tool gives way by at nominal force all the same [m]: a contact of two stiff bodies is not resolved
/// at 1 kHz.
const LEAST_DEPTH: f64 = 1e-3;

/// A tool in a hand.
#[derive(Debug, Clone)]
pub(crate) struct Wielded {
    /// Its underside, in its own frame [m].
    pub footprint: Region,
    /// Length and width of that [m].
    pub size: Vector2,
    /// Length and width of what it acts on [m].
    pub area_of_effect: Vector2,
    /// The vertices of each connected part of its mesh, in its own frame [m].
    pub parts: Vec<Vec<Point3>>,
    /// Where the hand's link really holds it.
    pub tip_from_tool: Pose,
    /// The force that it shall be pressed on with [N].
    pub press_force: f64,
    /// How far it gives way at that force [m].
    pub depth: f64,
    /// How far its underside hangs below the tool centre point when nothing presses [m]: what is believed, for a
    /// tool is measured unloaded.
    pub rest: f64,
    /// How high it hovers over the surface instead [m]; 0 where it is pressed on.
    pub gap: f64,
    /// Pressure at that force over the one that a tool of the believed area has [1].
    pub pressure: f64,
}

impl Wielded {
    /// The tool of a task, as the world has it.
    pub fn new(cell: &Workcell, task: &Task, real: &RealTool) -> Self {
        let size = real.footprint;
        let scaled = |p: &Point2| Point2::from(p.coords * size);
        let ring = |ring: &[Point2]| ring.iter().map(scaled).collect::<Vec<_>>();
        let polygon = |polygon: &Polygon| {
            let holes = polygon.holes().iter().map(|hole| ring(hole)).collect();
            Polygon::new(ring(polygon.outer()), holes)
        };
        let polygons = task.tool.footprint.polygons().iter().map(polygon);
        let footprint = Region::new(polygons.collect());
        let area_of_effect = task.tool.area_of_effect * size;
        // A stick does not make a cone of its broom.
        let mut parts = task.tool.mesh.parts();
        for vertex in parts.iter_mut().flatten() {
            (vertex.x, vertex.y) = (vertex.x * size, vertex.y * size);
        }
        let gap = task.interaction.gap_m;
        let depth = nominal_depth(task);
        // One that hovers hangs above the tool centre point.
        let rest = if gap > 0.0 { -gap } else { depth };
        let offset = Translation3::new(real.grasp_offset.x, real.grasp_offset.y, 0.0);
        let turn = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), real.grasp_turn);
        Self {
            size: footprint.bounds().map_or(area_of_effect, |b| b.size()),
            footprint,
            area_of_effect,
            parts,
            tip_from_tool: cell.tip_from_tool() * Pose::from_parts(offset, turn),
            press_force: task.interaction.press_force_n,
            depth: (depth / real.stiffness).max(LEAST_DEPTH),
            rest,
            gap,
            pressure: 1.0 / (size * size),
        }
    }

    /// Stiffness of the whole underside [N/m].
    pub fn stiffness(&self) -> f64 {
        self.press_force / self.depth
    }

    /// The edges of the underside.
    pub fn edges(&self) -> impl Iterator<Item = Edge> + '_ {
        self.footprint.edges()
    }
}

/// How far the tool is believed to give way at nominal force, as far as that is simulated [m].
fn nominal_depth(task: &Task) -> f64 {
    task.interaction.compression_depth_m.max(LEAST_DEPTH)
}
