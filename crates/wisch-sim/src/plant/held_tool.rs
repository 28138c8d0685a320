//! The real tool, and its real pose in the hand.

use crate::RealTool;
use nalgebra::{Translation3, UnitQuaternion};
use wisch::follow::Workcell;
use wisch::geometry::{Edge, Point2, Point3, Polygon, Pose, Region, Vector2, Vector3};
use wisch::represent::Task;

/// Compression of a rigid tool at nominal force [m]: at 1 kHz the engine does not resolve a contact of two stiff
/// bodies.
const LEAST_DEPTH: f64 = 1e-3;

/// The real tool in a hand.
#[derive(Debug, Clone)]
pub(crate) struct HeldTool {
    /// The tool's underside, in its own frame [m].
    pub footprint: Region,
    /// Length and width of the underside [m].
    pub size: Vector2,
    /// Length and width of the tool's area of effect [m].
    pub area_of_effect: Vector2,
    /// The vertices of each connected part of its mesh, in its own frame [m].
    pub parts: Vec<Vec<Point3>>,
    /// Real pose of the tool in the frame of the hand's link.
    pub tip_from_tool: Pose,
    /// Nominal press force [N].
    pub press_force: f64,
    /// Compression depth at that force [m].
    pub depth: f64,
    /// Height of the unloaded underside below the tool centre point [m]. It equals the believed value, because a tool
    /// is measured unloaded.
    pub rest: f64,
    /// Gap between the tool and the surface for a tool that hovers [m]; 0 for a tool that is pressed on.
    pub gap: f64,
    /// Mean pressure at nominal force over the one of a tool with the believed area [1].
    pub pressure: f64,
}

impl HeldTool {
    /// Returns the real tool of a task.
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
        // Each part is convex by itself: the hull of a broom with its stick would be a cone.
        let mut parts = task.tool.mesh.parts();
        for vertex in parts.iter_mut().flatten() {
            (vertex.x, vertex.y) = (vertex.x * size, vertex.y * size);
        }
        let gap = task.interaction.gap_m;
        let depth = nominal_depth(task);
        // A hovering tool hangs above the tool centre point.
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

/// Returns the believed compression depth at nominal force, but at least what the engine resolves [m].
fn nominal_depth(task: &Task) -> f64 {
    task.interaction.compression_depth_m.max(LEAST_DEPTH)
}
