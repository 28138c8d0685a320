//! The collision sphere: where a tool's sweep stays clear of the scene; paper §3.2, Fig. 3.
//!
//! Only geometry above the surface counts. What lies below its plane supports the surface (the table under a
//! chopping board) and cannot touch a tool that stands on it.

use super::PlanError;
use super::bend::check_scene;
use crate::geometry::{Mesh, Point2, Region, Vector2};
use crate::represent::{OccupiedArea, SURFACE_SKIN, Surface};
use parry3d_f64::math::Vector;
use parry3d_f64::query::PointQuery;
use parry3d_f64::shape::TriMesh;
use rayon::prelude::*;

/// Shortest step of the march along an edge [m]: an intrusion thinner than this may be missed.
pub(super) const MARCH_STEP: f64 = 1e-3;
/// Free space for the tool that is narrower than this may be overlooked [m].
const REACH_STEP: f64 = 1e-4;

/// The target surface and the scene above it, in the surface frame.
#[derive(Clone)]
pub struct FreeSpace {
    surface: Surface,
    radius: f64,
    geometry: Option<TriMesh>,
    occupied: OccupiedArea,
}

impl FreeSpace {
    /// Prepares the scene for a collision sphere of `radius` r_s \[m\].
    ///
    /// `scene`: meshes in the surface frame, without robot, tool and target surface.
    ///
    /// # Errors
    /// [`PlanError::Scene`] if the collision library refuses the geometry, and [`PlanError::ObstacleOnBend`] for an object
    /// near a curved surface.
    pub fn new<'a>(
        surface: &Surface,
        scene: impl IntoIterator<Item = &'a Mesh> + Clone,
        radius: f64,
    ) -> Result<Self, PlanError> {
        if !surface.shape.is_plane() {
            check_scene(surface, scene, radius)?;
            return Ok(Self {
                surface: surface.clone(),
                radius,
                geometry: None,
                occupied: OccupiedArea::default(),
            });
        }
        let mut corners: Vec<Vector> = Vec::new();
        for mesh in scene.clone() {
            for triangle in mesh.clip_above(SURFACE_SKIN) {
                corners.extend(triangle.map(|p| Vector::new(p.x, p.y, p.z)));
            }
        }
        let triangles = (0..corners.len() as u32 / 3)
            .map(|i| [3 * i, 3 * i + 1, 3 * i + 2])
            .collect::<Vec<_>>();
        let geometry = if triangles.is_empty() {
            None
        } else {
            Some(
                TriMesh::new(corners, triangles)
                    .map_err(|error| PlanError::Scene(error.to_string()))?,
            )
        };
        Ok(Self {
            surface: surface.clone(),
            radius,
            geometry,
            occupied: OccupiedArea::from_scene(scene),
        })
    }

    /// The collision sphere's radius r_s \[m\].
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// The target surface, whose frame all places here refer to.
    pub fn surface(&self) -> &Surface {
        &self.surface
    }

    /// The part of the surface on which objects of the scene stand.
    pub fn occupied_area(&self) -> &OccupiedArea {
        &self.occupied
    }

    /// The reason why no node fits on the surface.
    pub(super) fn explain_no_free_node(&self) -> PlanError {
        PlanError::NoFreeNode {
            surface: self.surface.name.clone(),
            diameter: 2.0 * self.radius,
            has_obstacles: self.geometry.is_some(),
        }
    }

    /// Distance from a point of the surface's plane, in the surface frame \[m\], to the scene above
    /// it \[m\]; 0 inside an object.
    pub fn distance(&self, point: Point2) -> f64 {
        if self.is_occupied(point) {
            return 0.0;
        }
        self.geometry.as_ref().map_or(f64::INFINITY, |geometry| {
            geometry
                .distance_to_local_point(Vector::new(point.x, point.y, 0.0), false)
                .abs()
        })
    }

    /// Whether an object of the scene stands on this point of the surface frame \[m\].
    pub fn is_occupied(&self, point: Point2) -> bool {
        self.occupied.contains(point)
    }

    /// Whether the collision sphere at this point of the plane touches nothing.
    pub fn is_clear(&self, point: Point2) -> bool {
        self.distance(point) >= self.radius
    }

    /// Whether a node may stand here: it is on the surface and its sphere touches nothing.
    pub fn is_free(&self, point: Point2) -> bool {
        self.surface.outline.contains(point) && self.is_clear(point)
    }

    /// Whether the tool can move straight from `a` to `b`: its collision sphere touches nothing, and the
    /// surface carries it.
    ///
    /// Marches by the distance to the scene: a step as long as the free space ahead is safe.
    pub fn is_clear_between(&self, a: Point2, b: Point2) -> bool {
        if !self.surface.carries_between(a, b) {
            return false;
        }
        if self.geometry.is_none() {
            return true;
        }
        let length = (b - a).norm();
        let mut at = 0.0;
        loop {
            let point = a + (b - a) * if length > 0.0 { at / length } else { 0.0 };
            let margin = self.distance(point) - self.radius;
            if margin < 0.0 {
                return false;
            }
            if at >= length {
                return true;
            }
            at = (at + margin.max(MARCH_STEP)).min(length);
        }
    }

    /// Share of `places`, in the surface frame \[m\], that the tool covers from no free position of
    /// its centre, at any rotation \[1\]; 0 without places.
    ///
    /// `footprint`: the tool's footprint, in the tool frame. `gap`: vector in the surface frame
    /// \[m\]; along it, in both directions, the tool does not act nearer to its centre than the
    /// length of this vector.
    pub fn unreachable_share(&self, places: &[Point2], footprint: &Region, gap: &Vector2) -> f64 {
        let rings = rings(footprint);
        let missed = (places.par_iter())
            .filter(|&&place| !self.is_covered(place, &rings, gap))
            .count();
        missed as f64 / places.len().max(1) as f64
    }

    /// Whether a tool at some free position covers `place`. `rings`: the distances from its centre that the
    /// footprint covers [m]. `gap`: see [`Self::unreachable_share`].
    ///
    /// Squares around the place are divided until the centre of one square is a free position that
    /// covers the place, or until no point of any square can be. Both distances change by no more
    /// than the distance that a point moves.
    fn is_covered(&self, place: Point2, rings: &[[f64; 2]], gap: &Vector2) -> bool {
        let reach = rings.iter().map(|ring| ring[1]).fold(0.0, f64::max);
        let mut squares = vec![(place, reach)];
        while let Some((middle, half)) = squares.pop() {
            let distance = (middle - place).norm();
            let spread = half * std::f64::consts::SQRT_2;
            let covers = |slack: f64| {
                (middle - place).dot(gap).abs() + slack * gap.norm() >= gap.norm_squared()
                    && (rings.iter()).any(|[least, most]| {
                        distance + slack >= *least && distance - slack <= *most
                    })
            };
            let outline = &self.surface.outline;
            let is_beside = !outline.contains(middle)
                && outline.edges().all(|edge| edge.distance(middle) > spread);
            if !covers(spread) || is_beside || self.distance(middle) + spread < self.radius {
                continue;
            }
            if covers(0.0) && self.is_free(middle) {
                return true;
            }
            if half > REACH_STEP {
                let half = half / 2.0;
                squares.extend(
                    [[-1.0, -1.0], [-1.0, 1.0], [1.0, -1.0], [1.0, 1.0]]
                        .map(|[x, y]| (middle + Vector2::new(x, y) * half, half)),
                );
            }
        }
        false
    }
}

/// Returns the distances from the tool centre point that each part of a footprint covers in some direction [m].
fn rings(footprint: &Region) -> Vec<[f64; 2]> {
    let center = Point2::origin();
    let parts = footprint.polygons().iter().map(|part| {
        let nearest = if part.contains(center) {
            0.0
        } else {
            (part.edges().map(|edge| edge.distance(center))).fold(f64::INFINITY, f64::min)
        };
        let farthest = part.outer().iter().map(|corner| corner.coords.norm());
        [nearest, farthest.fold(0.0, f64::max)]
    });
    parts.collect()
}
