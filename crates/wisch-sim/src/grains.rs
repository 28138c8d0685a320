//! Real dirt in the world: grains that lie, are gripped by the tool's underside, and fall off edges.
//!
//! Assumptions of this stand-in for settings: the underside of a tool closes round a grain instead of
//! riding on it, so that grains do not lift the tool; where the tool's pressure at a grain's place
//! exceeds the grain's own threshold, the grain is taken up (absorb) or moved (push): one that the tool's
//! side meets is pushed ahead of it, one that the tool was set down on is held under it. Grains do not
//! roll. Pressure is that of the tool's compliance, uneven where the tool is tilted; for a tool that hovers, the share of its
//! gap in the clearance over the grain stands in for it.

use super::Dirt;
use super::plant::{GRAVITY, Plant, Wielded, groups_of_grains, vector};
use crate::SimulationSettings;
use rapier3d_f64::dynamics::{CoefficientCombineRule, RigidBodyBuilder, RigidBodyHandle};
use rapier3d_f64::geometry::ColliderBuilder;
use wisch::geometry::{Point2, Point3, Pose, Vector2, Vector3};
use wisch::represent::{Effect, Fate, Task, dirt_friction};

/// Density of grains [kg/m³].
const DENSITY: f64 = 600.0;
/// Friction of grains on the side of a tool: foam and bristles hold them [1].
const SIDE_FRICTION: f64 = 1.0;
/// Stiffness of the tool's grip on a grain, as a natural frequency [rad/s]; critically damped.
const GRIP_RATE: f64 = 200.0;
/// A grain that is this far below the surface has fallen off it [m].
const FALLEN: f64 = 0.004;

/// Deeper than this under the tool a grain is no longer pushed by its side [m].
const SIDE: f64 = 4e-3;

/// Slower than this, friction of a heap grows with the speed [m/s].
const RUBBING: f64 = 0.01;

/// A grain's body, and how the tool has it.
#[derive(Debug, Clone, Copy)]
struct GrainBody {
    body: RigidBodyHandle,
    grip: Grip,
}

/// How the tool has a grain.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Grip {
    /// Not at all; the grain lies beside the tool.
    Beside,
    /// Not at all; the grain lies under the tool, which does not reach down to it or slips over it.
    Below,
    /// The side of the tool pushes it, and holds it by friction at a place in the underside's frame.
    Side(Point3),
    /// The underside holds it at a place in its frame.
    Held(Point3),
}

/// The bodies of some dirt.
pub(super) struct GrainBodies {
    bodies: Vec<Option<GrainBody>>,
    real_from_world: Pose,
    /// Outward normal of the real surface in the world.
    normal: Vector3,
    /// What drags on the tool for every grain that it pushes: friction of the dirt that the grain stands for [N].
    drag: f64,
    /// Whether the tool feels what it pushes.
    resist: bool,
    effect: Effect,
    reach: f64,
    /// How far off the surface's outline a grain has left it.
    tallest: f64,
}

impl GrainBodies {
    /// Puts the grains that lie on the surface into the world.
    pub fn new(
        plant: &mut Plant,
        dirt: &Dirt,
        task: &Task,
        tool: &Wielded,
        settings: &SimulationSettings,
    ) -> Self {
        let world_from_real = task.surface.world_from_surface * settings.believed_from_real;
        // What lies on a slope stays there, up to the angle at which the task's own dirt slides.
        let friction = dirt_friction(settings.kind, 0.0);
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
            Some(GrainBody {
                body,
                grip: Grip::Beside,
            })
        };
        let bodies = dirt.grains.iter().map(put).collect();
        let corners = tool.edges();
        let radii = dirt.grains.iter().map(|grain| grain.radius);
        Self {
            bodies,
            real_from_world: world_from_real.inverse(),
            normal: world_from_real * Vector3::z(),
            drag: friction * settings.grain_mass.unwrap_or(0.0) * GRAVITY.norm(),
            resist: settings.grains_resist,
            effect: task.action.effect(),
            reach: corners
                .map(|edge| edge.start.coords.norm())
                .fold(0.0, f64::max),
            tallest: 2.0 * radii.fold(0.0, f64::max),
        }
    }

    /// Lets the tool act on the grains under it, for the next period.
    pub fn act(&mut self, plant: &mut Plant, dirt: &mut Dirt, tool: &Wielded) {
        let plate = plant.world_from_plate();
        let to_plate = plate.inverse();
        let compression = plant.compression();
        let near = self.reach + self.tallest;
        let normal = self.normal;
        plant.release();
        for (grain, slot) in dirt.grains.iter_mut().zip(&mut self.bodies) {
            let Some(held) = slot else {
                continue;
            };
            let at = plant.world.bodies[held.body].translation();
            let at = Point3::new(at.x, at.y, at.z);
            if (at.coords - plate.translation.vector).norm_squared() > near * near {
                held.grip = Grip::Beside;
                continue;
            }
            let in_plate = to_plate * at;
            let under = Point2::new(in_plate.x, in_plate.y);
            if !tool.footprint.contains(under) {
                held.grip = Grip::Beside;
                continue;
            }
            let [lifted, higher] = plant.wave(on_surface(&self.real_from_world, &at));
            let is_reached = if tool.gap > 0.0 {
                // Suction falls off with the way from the mouth to the grain's foot.
                let clearance = grain.radius - in_plate.z - lifted;
                tool.gap / clearance.max(tool.gap) >= grain.threshold
            } else {
                in_plate.z + lifted + grain.radius > 0.0
                    && in_plate.z + lifted < grain.radius + tool.depth
                    && compression.pressure(under, higher, tool) >= grain.threshold
            };
            if !is_reached {
                held.grip = Grip::Below;
                continue;
            }
            if self.effect == Effect::Absorb {
                grain.fate = Fate::Absorbed;
                grain.position = on_surface(&self.real_from_world, &at);
                plant.world.remove_body(held.body);
                *slot = None;
                continue;
            }
            let (depth, outward) = nearest_side(tool, under);
            held.grip = match held.grip {
                Grip::Beside => Grip::Side(in_plate),
                Grip::Side(_) if depth > SIDE => Grip::Held(in_plate),
                Grip::Below => Grip::Held(in_plate),
                kept => kept,
            };
            let goal = match held.grip {
                Grip::Held(place) | Grip::Side(place) => plate * place,
                Grip::Beside | Grip::Below => at,
            };
            let velocity = plant.plate_velocity(&goal);
            let Some(body) = plant.world.bodies.get_mut(held.body) else {
                continue;
            };
            let (v, mass) = (body.linvel(), body.mass());
            let slip = velocity - Vector3::new(v.x, v.y, v.z);
            let hold = mass * (GRIP_RATE * GRIP_RATE * (goal - at) + 2.0 * GRIP_RATE * slip);
            let force = if let Grip::Held(_) = held.grip {
                hold
            } else {
                let outward = plate * Vector3::new(outward.x, outward.y, 0.0);
                let push = GRIP_RATE * GRIP_RATE * depth + 2.0 * GRIP_RATE * slip.dot(&outward);
                let push = (mass * push).max(0.0);
                let sideways = normal.cross(&outward);
                let held_back = hold.dot(&sideways);
                if held_back.abs() > SIDE_FRICTION * push {
                    held.grip = Grip::Side(in_plate);
                }
                let friction = held_back.clamp(-SIDE_FRICTION * push, SIDE_FRICTION * push);
                push * outward + friction * sideways
            };
            // It acts along the surface; upwards the tool gives way.
            let along = force - normal * normal.dot(&force);
            body.reset_forces(true);
            body.add_force(vector(&along), true);
            if !self.resist {
                continue;
            }
            // What moves a grain is taken from the tool; so is what the rest of the dirt that it stands for rubs with,
            // against the tool's motion.
            let moving = velocity - normal * normal.dot(&velocity);
            let rubbing = moving * (self.drag / moving.norm().max(RUBBING));
            plant.resist(&-(along + rubbing), &at);
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
            if matches!(held.grip, Grip::Beside | Grip::Below) {
                if body.is_sleeping() {
                    continue;
                }
                body.reset_forces(false);
            }
            let at = body.translation();
            let in_real = self.real_from_world * Point3::new(at.x, at.y, at.z);
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

/// How far a place under the tool is inside the nearest side, and which way is out of it.
fn nearest_side(tool: &Wielded, under: Point2) -> (f64, Vector2) {
    let mut nearest = (f64::INFINITY, Vector2::zeros());
    for edge in tool.edges() {
        let distance = edge.distance(under);
        if distance < nearest.0 {
            let along = (edge.end - edge.start).normalize();
            nearest = (distance, Vector2::new(along.y, -along.x));
        }
    }
    nearest
}

fn on_surface(real_from_world: &Pose, at: &Point3) -> Point2 {
    let in_real = real_from_world * at;
    Point2::new(in_real.x, in_real.y)
}
