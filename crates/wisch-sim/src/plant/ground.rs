//! The surface under the tool: the slab that carries its plate, with the waves and the bend of the real surface.
//!
//! The plate is flat. Where the surface is not, the slab lies in the tangent plane under the tool, and the local height
//! over the slab enters the pressure.

use super::held_tool::HeldTool;
use super::shapes::prism;
use super::{Plant, SURFACE_THICKNESS, to_engine};
use crate::camera::hull;
use crate::{SimulationError, SimulationSettings};
use nalgebra::{Matrix2, Translation3, UnitQuaternion};
use rapier3d_f64::geometry::{SharedShape, TriMeshFlags};
use rapier3d_f64::math as engine;
use rapier3d_f64::pipeline::{ActiveHooks, ContactModificationContext, PhysicsHooks};
use wisch::geometry::{Bounds2, Edge, Point2, Polygon, Pose, Vector2, Vector3};
use wisch::represent::{Surface, SurfaceShape, Task};

/// Number of points along each side of the underside at which its springs are evaluated.
const SPRINGS: usize = 16;
/// Most corners of a slab that is one solid.
const MOST_CORNERS: usize = 5;
/// Distance of a corner of a larger slab from the chord of its neighbours below which it is left out [m].
const LEAST_CORNER: f64 = 1e-3;
/// Least part of a contact's normal along the slab's normal with which a divided slab carries the plate [1], and
/// depth of the plate's middle below the slab from which the slab's sides stop it [m].
const LEAST_UPWARD: f64 = 0.5;
const BELOW_SLAB: f64 = 0.01;
/// Error of the mean compression that is left [m].
const LEAST_EXCESS: f64 = 1e-12;
/// Least share of the springs that count as touching when the slab follows the plate [1].
const LEAST_TOUCHING: f64 = 1e-2;

/// Returns the real surface of a task: the believed outline at the real pose, with the real shape.
pub(crate) fn find_real_surface(task: &Task, settings: &SimulationSettings) -> Surface {
    Surface {
        world_from_surface: task.surface.world_from_surface * settings.believed_from_real,
        shape: (settings.shape.as_ref())
            .unwrap_or(&task.surface.shape)
            .clone(),
        ..task.surface.clone()
    }
}

/// Returns the collision shape that grains lie on: of a curved surface, its facets.
pub(super) fn facets(real: &Surface, thickness: f64) -> Result<SharedShape, SimulationError> {
    let solid = real.solid_below(thickness).ok();
    let solid = solid.ok_or(SimulationError::NoSurface)?;
    let vertices = solid.vertices().iter().map(|p| super::vector(&p.coords));
    // Grains would catch at the edges between facets.
    let flags = TriMeshFlags::FIX_INTERNAL_EDGES | TriMeshFlags::MERGE_DUPLICATE_VERTICES;
    SharedShape::trimesh_with_flags(vertices.collect(), solid.triangles().to_vec(), flags)
        .map_err(|_| SimulationError::NoSurface)
}

/// Returns the slab that carries the plate, over the convex hull of the outline; `None` without an area.
pub(super) fn slab(real: &Surface) -> Option<SharedShape> {
    let outline = real.outline.outer();
    if outline.len() <= MOST_CORNERS {
        return prism(outline.iter().copied(), -SURFACE_THICKNESS, 0.0);
    }
    // The engine lets four corners of a solid's face carry at most: larger faces become triangles.
    let corners = without_flat_corners(hull(outline.to_vec()));
    let flat = Surface {
        outline: Polygon::new(corners, Vec::new()),
        shape: SurfaceShape::Plane,
        ..real.clone()
    };
    facets(&flat, SURFACE_THICKNESS).ok()
}

/// Leaves out the corners of a convex ring that are nearly on a line, which make slivers.
fn without_flat_corners(mut corners: Vec<Point2>) -> Vec<Point2> {
    while corners.len() > 4 {
        let count = corners.len();
        let off = |i: usize| {
            let chord = Edge {
                start: corners[(i + count - 1) % count],
                end: corners[(i + 1) % count],
            };
            chord.distance(corners[i])
        };
        let flattest = (0..count).map(|i| (i, off(i)));
        match flattest.min_by(|a, b| a.1.total_cmp(&b.1)) {
            Some((i, distance)) if distance < LEAST_CORNER => corners.remove(i),
            _ => break,
        };
    }
    corners
}

/// Contacts of the plate with a slab that is divided into triangles.
///
/// The engine finds the contact with each triangle by itself. At the border of a triangle, or of the slab, it may point
/// sideways and stop the plate, although other triangles carry it. Only contacts from below are kept.
#[derive(Debug, Clone, Copy)]
pub(super) struct CarriedFromBelow;

impl CarriedFromBelow {
    /// Returns the hooks of a plate on this slab: none on a slab that is one solid.
    pub fn choose_hooks(slab: &SharedShape) -> ActiveHooks {
        if slab.as_trimesh().is_some() {
            ActiveHooks::MODIFY_SOLVER_CONTACTS
        } else {
            ActiveHooks::empty()
        }
    }
}

impl PhysicsHooks for CarriedFromBelow {
    fn modify_solver_contacts(&self, context: &mut ContactModificationContext<'_>) {
        let colliders = [context.collider1, context.collider2];
        let [first, second] = colliders.map(|handle| &context.colliders[handle]);
        // The normal points to the second one; the plate is the one with hooks.
        let (slab, plate, sign) = if first.active_hooks().is_empty() {
            (first, second, 1.0)
        } else {
            (second, first, -1.0)
        };
        let up = slab.position().rotation * engine::Vector::Z;
        let height = up.dot(plate.translation() - slab.translation());
        if let Some(contact) = context.rigid_mut()
            && sign * contact.normal.dot(up) < LEAST_UPWARD
            && height > -BELOW_SLAB
        {
            contact.solver_contacts.clear();
        }
    }
}

/// The surface under the tool at the current time.
#[derive(Debug, Clone, Copy)]
pub(super) struct GroundUnderTool {
    /// Foot of the tool in the chart [m].
    place: Point2,
    /// Height [m] and slope [1] of the waves there.
    height: f64,
    slope: Vector2,
    /// Height of the slab over the bent surface [m], at which compression and force agree.
    raise: f64,
}

impl Default for GroundUnderTool {
    fn default() -> Self {
        Self {
            place: Point2::origin(),
            height: 0.0,
            slope: Vector2::zeros(),
            raise: 0.0,
        }
    }
}

/// Heights of the real surface at a place.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LocalHeight {
    /// Height of the waves over the surface [m]; grains do not lie on them.
    pub wave: f64,
    /// Height of the waves over the tangent plane of the waves [m].
    pub over_waves: f64,
    /// Height of the bent surface over the slab that carries the plate [m].
    pub bend: f64,
}

impl LocalHeight {
    /// Returns the height over the plane that carries the plate [m].
    pub fn measure_over_plate(&self) -> f64 {
        self.over_waves + self.bend
    }
}

/// The springs of a flat underside over a bent surface.
#[derive(Debug, Clone)]
pub(super) struct BentContact {
    /// Second fundamental form under the tool [1/m].
    bend: Matrix2<f64>,
    /// Places of the springs in the plate's frame [m].
    springs: Vec<Point2>,
}

impl BentContact {
    /// Returns the springs of a tool; `None` over a plane.
    pub fn new(real: &Surface, tool: &HeldTool) -> Option<Self> {
        if real.shape.is_plane() {
            return None;
        }
        let bounds = tool.footprint.bounds().unwrap_or(Bounds2 {
            min: Point2::origin(),
            max: Point2::origin(),
        });
        let share = |i: usize| (i as f64 + 0.5) / SPRINGS as f64;
        let places = (0..SPRINGS * SPRINGS).map(|i| {
            let share = Vector2::new(share(i % SPRINGS), share(i / SPRINGS));
            bounds.min + bounds.size().component_mul(&share)
        });
        let springs = places.filter(|place| tool.footprint.contains(*place));
        Some(Self {
            bend: real.shape.bend(Point2::origin()),
            springs: springs.collect(),
        })
    }

    /// Returns the height of the surface over its tangent plane [m], at a displacement from the foot in the chart [m].
    fn height(&self, from_foot: Vector2) -> f64 {
        -0.5 * from_foot.dot(&(self.bend * from_foot))
    }

    /// Returns the height of the slab over the tangent plane [m], at which a plate on the slab has the mean compression
    /// `depth` [m] of the springs, and the share of the springs that touch [1]. `turn`: the plate in the axes of the
    /// chart.
    ///
    /// With heights hᵢ of the surface, the underside must be at −d where Σ max(0, d + hᵢ) / n = depth.
    pub fn raise(&self, turn: &UnitQuaternion<f64>, depth: f64) -> (f64, f64) {
        let heights: Vec<f64> = (self.springs.iter())
            .map(|p| self.height((turn * Vector3::new(p.x, p.y, 0.0)).xy()))
            .collect();
        let (Some(highest), count) = (
            heights.iter().copied().reduce(f64::max),
            heights.len() as f64,
        ) else {
            return (0.0, 1.0);
        };
        if depth <= 0.0 {
            return (highest, 1.0);
        }
        // Newton from above: the sum is convex and piecewise linear in d.
        let mut below = depth - heights.iter().copied().fold(f64::INFINITY, f64::min);
        let mut share = 1.0;
        // Each step leaves more springs out; the last one is exact.
        for _ in 0..=self.springs.len() {
            let touching = heights.iter().filter(|h| below + **h > 0.0);
            let (number, sum) = touching.fold((0.0, 0.0), |(n, s), h| (n + 1.0, s + below + h));
            let excess = sum / count - depth;
            if excess <= LEAST_EXCESS || number == 0.0 {
                break;
            }
            share = number / count;
            below -= excess / share;
        }
        (depth - below, share)
    }
}

impl Plant {
    /// Moves the surface under the tool to the height and slope of its waves there, and of a curved surface to the
    /// tangent plane there.
    pub fn lay_surface(&mut self) {
        if self.waviness.is_none() && self.bent.is_none() {
            return;
        }
        let at = self.real.chart_from_tool(&self.world_from_plate());
        let place = Point2::new(at.translation.x, at.translation.y);
        let (height, slope) = (self.waviness).map_or((0.0, Vector2::zeros()), |w| w.sample(place));
        let mut raise = self.ground.raise;
        if let Some(bent) = &mut self.bent {
            bent.bend = self.real.shape.bend(place);
        }
        if let Some(bent) = &self.bent {
            let (goal, touching) = bent.raise(&at.rotation, self.compression().depth);
            // The compression in turn depends on the slab's height; the damped Newton step
            // converges to both.
            raise += (goal - raise) * touching.max(LEAST_TOUCHING);
        }
        self.ground = GroundUnderTool {
            place,
            height,
            slope,
            raise,
        };
        // Tangent plane: tilted by the slope of the waves about the point under the tool.
        let tilt = UnitQuaternion::from_scaled_axis(Vector3::new(slope.y, -slope.x, 0.0));
        let back = Translation3::new(-place.x, -place.y, 0.0);
        let under = if self.bent.is_some() {
            self.real.shape.place(place, height + raise) * tilt
        } else {
            Pose::from_parts(Translation3::new(place.x, place.y, height), tilt)
        };
        let pose = self.real.world_from_surface * under * back;
        if let Some(collider) = self.world.colliders.get_mut(self.surface_collider) {
            collider.set_position(to_engine(&pose));
        }
    }

    /// Returns the heights of the real surface at a place of its chart [m].
    pub fn local_height(&self, place: Point2) -> LocalHeight {
        let ground = &self.ground;
        let from_foot = place - ground.place;
        let (wave, over_waves) = self.waviness.map_or((0.0, 0.0), |waviness| {
            let (here, _) = waviness.sample(place);
            // Deviation from the tangent plane: h(p) − h(c) − ∇h(c) · (p − c).
            (here, here - ground.height - ground.slope.dot(&from_foot))
        });
        let bend = (self.bent.as_ref()).map_or(0.0, |bent| bent.height(from_foot) - ground.raise);
        LocalHeight {
            wave,
            over_waves,
            bend,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A pad of 10 × 6 cm on a cylinder along its width.
    fn pad(radius: f64) -> BentContact {
        let axis = std::f64::consts::FRAC_PI_2;
        let place = |i: usize, side: f64| side * ((i as f64 + 0.5) / SPRINGS as f64 - 0.5);
        let springs = (0..SPRINGS * SPRINGS)
            .map(|i| Point2::new(place(i % SPRINGS, 0.1), place(i / SPRINGS, 0.06)));
        BentContact {
            bend: SurfaceShape::Cylinder { radius, axis }.bend(Point2::origin()),
            springs: springs.collect(),
        }
    }

    #[test]
    fn a_pad_that_touches_everywhere_is_raised_by_the_mean_height_of_the_bend() {
        // Mean of −κ u²/2 over a side L: −κ L²/24.
        for radius in [0.5, -0.5] {
            let (raise, share) = pad(radius).raise(&UnitQuaternion::identity(), 0.01);
            assert!((raise + 0.01 / (24.0 * radius)).abs() < 1e-5, "{raise}");
            assert_eq!(share, 1.0);
        }
    }

    #[test]
    fn a_stiff_pad_touches_in_a_strip_along_the_axis_of_a_bulge() {
        // With Λ = κ L²/12δ > 1, a share Λ^(−1/3) of the pad touches.
        let (depth, bend) = (1e-4_f64, 2.0);
        let wanted = (bend * 0.01 / (12.0 * depth)).powf(-1.0 / 3.0);
        let (raise, share) = pad(0.5).raise(&UnitQuaternion::identity(), depth);
        assert!((share - wanted).abs() < 1.0 / SPRINGS as f64, "{share}");
        // At the border of the strip, at half its width c, the surface is κ c²/2 below its top.
        let below = depth - raise;
        let half = 0.5 * 0.1 * wanted;
        assert!((below - bend * half * half / 2.0).abs() < 1e-4, "{below}");
    }

    #[test]
    fn a_pad_without_load_rests_on_the_highest_place() {
        let across = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), 0.3);
        let (raise, _) = pad(0.5).raise(&across, 0.0);
        assert!((-1e-5..=0.0).contains(&raise), "{raise}");
        // In a hollow the outermost springs touch first.
        let (raise, _) = pad(-0.5).raise(&UnitQuaternion::identity(), 0.0);
        assert!((raise - 0.046_875_f64.powi(2)).abs() < 1e-9, "{raise}");
    }
}
