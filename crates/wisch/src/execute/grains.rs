//! Real dirt in the world: grains that lie, are gripped by the tool's underside, and fall off edges.
//!
//! Assumptions of this stand-in for reality: the underside of a tool closes round a grain instead of
//! riding on it, so that grains do not lift the tool; where the tool's pressure at a grain's place
//! exceeds the grain's own threshold, the grain is taken up (absorb) or moves with the tool (push);
//! grains do not roll. Pressure is that of the tool's compliance, uneven where the tool is tilted.

use super::Dirt;
use super::plant::{Plant, groups_of_grains, vector};
use crate::geometry::{Point2, Point3, Pose};
use crate::represent::{Effect, Fate, MediumKind, Reality, Task};
use rapier3d_f64::dynamics::{CoefficientCombineRule, RigidBodyBuilder, RigidBodyHandle};
use rapier3d_f64::geometry::ColliderBuilder;

/// Density of grains [kg/m³].
const DENSITY: f64 = 600.0;
/// Friction of grains on the surface: what lies on a slope stays there [1].
const FRICTION: f64 = 0.8;
const WET_FRICTION: f64 = 1.5;
/// Stiffness of the tool's grip on a grain, as a natural frequency [rad/s]; critically damped.
const GRIP_RATE: f64 = 200.0;
/// A grain that is this far below the surface has fallen off it [m].
const FALLEN: f64 = 0.004;

/// A grain's body, and where the tool holds it.
#[derive(Debug, Clone, Copy)]
struct GrainBody {
    body: RigidBodyHandle,
    /// Place in the frame of the tool's underside at which it is gripped.
    grip: Option<Point3>,
}

/// The bodies of some dirt.
pub(super) struct GrainBodies {
    bodies: Vec<Option<GrainBody>>,
    world_from_real: Pose,
    effect: Effect,
    /// Stiffness of the tool's compliance [N/m], and what it has at the nominal force [m].
    nominal_depth: f64,
    reach: f64,
    /// How far off the surface's outline a grain has left it.
    tallest: f64,
}

impl GrainBodies {
    /// Puts the grains that lie on the surface into the world.
    pub fn new(plant: &mut Plant, dirt: &Dirt, task: &Task, reality: &Reality) -> Self {
        let world_from_real = task.surface.world_from_surface * reality.believed_from_real;
        let friction = match reality.kind {
            MediumKind::Liquid => WET_FRICTION,
            MediumKind::Solid | MediumKind::Powder => FRICTION,
        };
        let put = |grain: &super::Grain| {
            if grain.fate != Fate::OnSurface {
                return None;
            }
            let place = Point3::new(grain.position.x, grain.position.y, grain.radius);
            let at = world_from_real * place;
            let body = plant.world.insert_body(
                RigidBodyBuilder::dynamic()
                    .translation(vector(&at.coords))
                    .lock_rotations(),
            );
            let collider = ColliderBuilder::ball(grain.radius)
                .density(DENSITY)
                .friction(friction)
                .friction_combine_rule(CoefficientCombineRule::Max)
                .collision_groups(groups_of_grains());
            plant.world.insert_collider(collider, Some(body));
            Some(GrainBody { body, grip: None })
        };
        let bodies = dirt.grains.iter().map(put).collect();
        let corners = task.tool.footprint.edges();
        let radii = dirt.grains.iter().map(|grain| grain.radius);
        Self {
            bodies,
            world_from_real,
            effect: task.action.effect(),
            nominal_depth: task.interaction.compression_depth_m,
            reach: corners
                .map(|edge| edge.start.coords.norm())
                .fold(0.0, f64::max),
            tallest: 2.0 * radii.fold(0.0, f64::max),
        }
    }

    /// Lets the tool act on the grains under it, for the next period.
    pub fn act(&mut self, plant: &mut Plant, dirt: &mut Dirt, task: &Task) {
        let plate = plant.world_from_plate();
        let to_plate = plate.inverse();
        let compression = plant.compression();
        let near = self.reach + self.tallest;
        for (grain, slot) in dirt.grains.iter_mut().zip(&mut self.bodies) {
            let Some(held) = slot else {
                continue;
            };
            let body = &plant.world.bodies[held.body];
            let at = body.translation();
            let at = Point3::new(at.x, at.y, at.z);
            if (at.coords - plate.translation.vector).norm_squared() > near * near {
                held.grip = None;
                continue;
            }
            let in_plate = to_plate * at;
            let under = Point2::new(in_plate.x, in_plate.y);
            let is_reached = in_plate.z + grain.radius > 0.0
                && in_plate.z < grain.radius + self.nominal_depth
                && task.tool.footprint.contains(under);
            if !is_reached || compression.pressure(under, self.nominal_depth) < grain.threshold {
                held.grip = None;
                continue;
            }
            if self.effect == Effect::Absorb {
                grain.fate = Fate::Absorbed;
                grain.position = on_surface(&self.world_from_real, &at);
                plant.world.remove_body(held.body);
                *slot = None;
                continue;
            }
            let grip = *held.grip.get_or_insert(in_plate);
            let goal = plate * grip;
            let velocity = plant.plate_velocity(&goal);
            let Some(body) = plant.world.bodies.get_mut(held.body) else {
                continue;
            };
            let (v, mass) = (body.linvel(), body.mass());
            let normal = self.world_from_real.rotation * crate::geometry::Vector3::z();
            let lag = goal - at;
            let slip = velocity - crate::geometry::Vector3::new(v.x, v.y, v.z);
            let force = mass * (GRIP_RATE * GRIP_RATE * lag + 2.0 * GRIP_RATE * slip);
            // The grip holds along the surface; the tool gives way upwards.
            let along = force - normal * normal.dot(&force);
            body.reset_forces(true);
            body.add_force(vector(&along), true);
        }
    }

    /// Forgets the tool's grip on grains it left, and takes off the surface what fell from it.
    pub fn settle(&mut self, plant: &mut Plant, dirt: &mut Dirt, task: &Task) {
        for (grain, slot) in dirt.grains.iter_mut().zip(&mut self.bodies) {
            let Some(held) = slot else {
                continue;
            };
            let Some(body) = plant.world.bodies.get_mut(held.body) else {
                continue;
            };
            if held.grip.is_none() {
                if body.is_sleeping() {
                    continue;
                }
                body.reset_forces(false);
            }
            let at = body.translation();
            let in_real = self.world_from_real.inverse() * Point3::new(at.x, at.y, at.z);
            let now = Point2::new(in_real.x, in_real.y);
            if !(now.x.is_finite() && now.y.is_finite()) {
                continue;
            }
            let has_left = in_real.z < grain.radius - FALLEN || !task.surface.outline.contains(now);
            let edge = task.surface.exit_edge(grain.position, now);
            if let (true, Some(edge)) = (has_left, edge) {
                grain.fate = Fate::OffSurface {
                    edge: u16::try_from(edge).unwrap_or(u16::MAX),
                };
                plant.world.remove_body(held.body);
                *slot = None;
            }
            if task.surface.outline.contains(now) || grain.fate != Fate::OnSurface {
                grain.position = now;
            }
        }
    }
}

fn on_surface(world_from_real: &Pose, at: &Point3) -> Point2 {
    let in_real = world_from_real.inverse() * at;
    Point2::new(in_real.x, in_real.y)
}
