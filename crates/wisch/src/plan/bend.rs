//! What a plan on a curved surface needs: a tool that lies on the bend, dirt that does not slide, and nothing in the way.
//!
//! The tool is a bed of springs under a held force. Where the surface bends by κ across an axis, and u is the distance of a
//! point of the tool from the line through its middle along the axis, the pressure over the mean one is
//! f′(u) = 1 + κ (E\[u²\] − u²) / 2δ, with the mean of u² over the footprint and the compression δ at nominal force. This holds
//! as long as it is positive everywhere.

use super::PlanError;
use crate::geometry::{Mesh, Point2, Point3, Region, Vector2, Vector3};
use crate::represent::{SURFACE_SKIN, Surface, SurfaceShape, Task, dirt_friction};

/// Least pressure over the mean one at which a plan counts every point under the tool as touched [1]: about the median
/// threshold e^μ = 0.35 of the shipped laws.
const LEAST_PRESSURE: f64 = 0.3;
/// Number of yaws at which the tool is tried.
const YAWS: usize = 90;
/// Half the distance between the points of an object that are checked [m]; also their slack.
const SEARCH_STEP: f64 = 0.01;

/// Checks that the method's model holds on the surface of a task; always on a plane.
///
/// # Errors
/// A chart that does not fit its shape, a tool that does not lie on the bend, or a slope on which dirt slides.
pub(super) fn check_bend(task: &Task) -> Result<(), PlanError> {
    let surface = &task.surface;
    let SurfaceShape::Cylinder { radius, .. } = surface.shape else {
        return Ok(());
    };
    if let Some(fault) = surface.shape_fault() {
        let surface = surface.name.clone();
        return Err(PlanError::Shape { surface, fault });
    }
    let depth = task.interaction.compression_depth_m;
    let share = least_pressure(&task.tool.footprint, 1.0 / radius, depth);
    if !task.interaction.hovers() && share < LEAST_PRESSURE {
        return Err(PlanError::TooBent {
            tool: task.tool.name.clone(),
            surface: surface.name.clone(),
            radius,
            // A tool does not pull: where the formula is negative, it does not touch.
            share: share.max(0.0),
            limit: LEAST_PRESSURE,
            depth,
        });
    }
    let slope = steepest(surface);
    // The kind of the medium and the friction of the surface are not part of a task, so the smallest friction counts.
    let friction = dirt_friction(crate::represent::MediumKind::Solid, 0.0);
    if task.treatment.is_none() && slope > libm::atan(friction) {
        return Err(PlanError::SteepBend {
            surface: surface.name.clone(),
            slope: slope.to_degrees(),
        });
    }
    Ok(())
}

/// Returns the least pressure under a tool over the mean one [1], at its worst yaw on a bend of this curvature [1/m].
fn least_pressure(footprint: &Region, curvature: f64, depth: f64) -> f64 {
    let corners: Vec<Vector2> = footprint.edges().map(|edge| edge.start.coords).collect();
    let yaws = (0..YAWS).map(|i| i as f64 * std::f64::consts::PI / YAWS as f64);
    let least = yaws.map(|yaw| {
        let across = Vector2::new(libm::cos(yaw), libm::sin(yaw));
        let mean = mean_square(footprint, &across);
        // A bulge is least pressed at the corners, a hollow in the middle.
        let far = corners.iter().map(|corner| across.dot(corner).powi(2));
        let square = if curvature > 0.0 {
            far.fold(0.0, f64::max)
        } else {
            0.0
        };
        curvature * (mean - square)
    });
    let least = least.fold(f64::INFINITY, f64::min);
    if depth > 0.0 {
        1.0 + least / (2.0 * depth)
    } else if least < 0.0 {
        f64::NEG_INFINITY
    } else {
        1.0
    }
}

/// Mean of u² over a footprint [m²], with u along a direction.
fn mean_square(footprint: &Region, across: &Vector2) -> f64 {
    let (mut area, mut moment) = (0.0, 0.0);
    for edge in footprint.edges() {
        // Triangles to the origin: area (a × b)/2, mean of u² (u_a² + u_a u_b + u_b²)/6.
        let [a, b] = [edge.start.coords, edge.end.coords];
        let (u, v) = (across.dot(&a), across.dot(&b));
        let twice = a.perp(&b);
        area += twice / 2.0;
        moment += twice / 12.0 * (u * u + u * v + v * v);
    }
    if area > 0.0 { moment / area } else { 0.0 }
}

/// Largest angle between the surface's normal and the vertical [rad].
fn steepest(surface: &Surface) -> f64 {
    let corners = surface.outline.outer().iter();
    let angle = |place: &Point2| surface.normal(*place).angle(&Vector3::z());
    corners.map(angle).fold(0.0, f64::max)
}

/// Checks that no object of a scene is within a radius of a curved surface, on its outer side: as on a plane, what lies
/// below the surface supports it.
///
/// `scene`: meshes in the surface frame.
pub(super) fn check_scene<'a>(
    surface: &Surface,
    scene: impl IntoIterator<Item = &'a Mesh>,
    radius: f64,
) -> Result<(), PlanError> {
    let outline = &surface.outline;
    let distance = |point: &Point3| {
        let at = surface.shape.chart(*point);
        if at.height <= SURFACE_SKIN {
            return f64::INFINITY;
        }
        let edges = outline.edges().map(|edge| edge.distance(at.place));
        let beside = if outline.contains(at.place) {
            0.0
        } else {
            edges.fold(f64::INFINITY, f64::min)
        };
        at.height.hypot(beside)
    };
    for mesh in scene {
        let fine = mesh.split_edges(2.0 * SEARCH_STEP);
        let distance = (fine.vertices().iter().map(distance)).fold(f64::INFINITY, f64::min);
        if distance < radius + SEARCH_STEP {
            return Err(PlanError::ObstacleOnBend {
                surface: surface.name.clone(),
                distance,
                radius,
            });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Polygon;

    #[test]
    fn the_least_pressure_is_that_of_a_strip_across_the_bend() {
        // A strip of length L across: 1 − κ L²/12δ at its ends on a bulge, 1 − κ L²/24δ in the middle of a hollow.
        let strip = Region::new(vec![Polygon::rectangle(Vector2::new(0.1, 1e-6))]);
        let by_length = 2.0 * 0.1 * 0.1 / 0.01;
        let bulge = least_pressure(&strip, 2.0, 0.01);
        let hollow = least_pressure(&strip, -2.0, 0.01);
        assert!((bulge - (1.0 - by_length / 12.0)).abs() < 1e-4, "{bulge}");
        assert!((hollow - (1.0 - by_length / 24.0)).abs() < 1e-4, "{hollow}");
        assert_eq!(least_pressure(&strip, 0.0, 0.0), 1.0);
        assert!(least_pressure(&strip, 2.0, 0.0) < 0.0);
    }
}
