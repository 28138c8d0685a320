//! Physics of the dirt: grains lie on the surface, are gripped by the tool's underside, and fall
//! off edges.
//!
//! The model assumes the following.
//! - The underside of a tool closes around a grain instead of riding on it, so grains do not lift
//!   the tool.
//! - The tool moves or absorbs a grain if its pressure at the grain exceeds the grain's own
//!   threshold: an absorbing tool removes the grain, a pushing tool moves it.
//! - The tool's side pushes a grain ahead of it. If the tool was set down on a grain, the underside
//!   holds the grain.
//! - Grains do not roll.
//! - Pressure is that of the tool's compliance, uneven where the tool is tilted. For a hovering tool, the ratio of its
//!   gap to the clearance over the grain replaces the pressure.

use super::Dirt;
use super::plant::{GRAVITY, HeldTool, Plant, groups_of_grains, vector};
use crate::SimulationSettings;
use rapier3d_f64::dynamics::{CoefficientCombineRule, RigidBodyBuilder, RigidBodyHandle};
use rapier3d_f64::geometry::ColliderBuilder;
use wisch::geometry::{Point2, Point3, Vector2, Vector3};
use wisch::represent::{
    ChartPoint, DirtMobility, Effect, Fate, FilmFlow, Task, dirt_friction, mean_distance, run_off,
};

/// Density of grains [kg/m³].
const DENSITY: f64 = 600.0;
/// Friction coefficient between grains and the side of a tool [1]: foam and bristles hold them.
const SIDE_FRICTION: f64 = 1.0;
/// Stiffness of the tool's grip on a grain, as a natural frequency [rad/s]; critically damped.
const GRIP_RATE: f64 = 200.0;
/// A grain this far below the surface has fallen off it [m].
const FALL_DEPTH: f64 = 0.004;
/// A grain this far over the surface has fallen from a part that faces down [m].
const FALLEN_HEIGHT: f64 = 0.1;

/// Depth under the tool beyond which the tool's side no longer pushes a grain [m].
const SIDE_DEPTH: f64 = 4e-3;

/// Speed below which the friction of a heap grows in proportion to the speed [m/s].
const RUBBING_SPEED: f64 = 0.01;

/// Friction that holds the drops of a film, over the tangent of the slope [1].
const FILM_FRICTION: f64 = 1.5;
/// Longest time between two steps of a liquid film [s].
const FILM_STEP: f64 = 0.05;
/// Speed above which a grain counts as sliding [m/s].
const SLIDING_SPEED: f64 = 5e-3;
/// Smallest friction between tool and surface by which the friction of a grain is divided [1].
const LEAST_FRICTION: f64 = 1e-3;

/// A grain's body, and the tool's grip on it.
#[derive(Debug, Clone, Copy)]
struct GrainBody {
    body: RigidBodyHandle,
    grip: Grip,
}

/// Grip of the tool on a grain.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Grip {
    /// No grip; the grain lies beside the tool.
    Beside,
    /// No grip; the grain lies under the tool, which does not reach it or slips over it.
    Below,
    /// The side of the tool pushes the grain, and friction holds it at this point in the underside's frame [m].
    Side(Point3),
    /// The underside holds the grain at this point in its frame [m].
    Held(Point3),
}

/// The bodies of all grains.
pub(super) struct GrainBodies {
    bodies: Vec<Option<GrainBody>>,
    /// Drag on the tool for every grain that it pushes [N]: friction of the dirt that the grain stands for.
    drag: f64,
    /// Whether grains that the tool pushes resist it.
    is_resisting: bool,
    effect: Effect,
    reach: f64,
    /// Largest diameter of a grain [m].
    max_diameter: f64,
    /// Friction of grains at rest and sliding, over that of the surface [1]; `None` if it is assumed, and the same for both.
    declared_friction: Option<[f64; 2]>,
    /// The film whose drops are the grains, the mean distance of all drops [m], and the time since
    /// they were last moved [s].
    film: Option<(FilmFlow, f64, f64)>,
}

impl GrainBodies {
    /// Adds a body for each grain that lies on the surface.
    pub fn new(
        plant: &mut Plant,
        dirt: &Dirt,
        task: &Task,
        tool: &HeldTool,
        settings: &SimulationSettings,
    ) -> Self {
        // A grain stays on a slope up to the angle at which the task's dirt slides.
        let declared = match settings.mobility {
            DirtMobility::Slides(friction) => Some(friction),
            DirtMobility::Unknown | DirtMobility::Runs(_) => None,
        };
        let film = task.film_flow();
        let friction = declared.map_or_else(
            || dirt_friction(settings.kind, 0.0),
            |friction| friction.at_rest,
        );
        let over_surface = |coefficient| coefficient / settings.friction.max(LEAST_FRICTION);
        let (in_engine, rule) = match declared {
            Some(_) => (over_surface(friction), CoefficientCombineRule::Multiply),
            // The drops of a film move by its law alone.
            None if film.is_some() => {
                let held = FILM_FRICTION * libm::tan(plant.real().steepest_slope());
                (friction.max(held), CoefficientCombineRule::Max)
            }
            None => (friction, CoefficientCombineRule::Max),
        };
        let put = |grain: &super::Grain| {
            if grain.fate != Fate::OnSurface {
                return None;
            }
            let at = plant.real().world_from_place(grain.position, grain.radius);
            let body = plant.world.insert_body(
                RigidBodyBuilder::dynamic()
                    .translation(vector(&at.translation.vector))
                    .lock_rotations(),
            );
            let collider = ColliderBuilder::ball(grain.radius)
                .density(DENSITY)
                .friction(in_engine)
                .friction_combine_rule(rule)
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
            drag: friction * settings.grain_mass.unwrap_or(0.0) * GRAVITY.norm(),
            is_resisting: settings.grains_resist,
            effect: task.action.effect(),
            reach: corners
                .map(|edge| edge.start.coords.norm())
                .fold(0.0, f64::max),
            max_diameter: 2.0 * radii.fold(0.0, f64::max),
            declared_friction: declared
                .map(|friction| [friction.at_rest, friction.sliding].map(over_surface)),
            film: film.map(|film| (film, mean_distance(&task.surface, dirt.grains.len()), 0.0)),
        }
    }

    /// Applies the forces of the tool to the grains near it, for the next period.
    pub fn act(&mut self, plant: &mut Plant, dirt: &mut Dirt, tool: &HeldTool) {
        let plate = plant.world_from_plate();
        let to_plate = plate.inverse();
        let compression = plant.compression();
        let near = self.reach + self.max_diameter;
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
            let place = plant.real().chart(at).place;
            let height = plant.local_height(place);
            let is_reached = if tool.gap > 0.0 {
                // Suction decreases with the distance from the mouth to the grain's foot.
                let clearance = grain.radius - in_plate.z - height.wave;
                tool.gap / clearance.max(tool.gap) >= grain.threshold
            } else {
                // The underside yields to the bend, so that a grain is as high over it as over the surface.
                let middle = in_plate.z + height.wave - height.bend;
                middle + grain.radius > 0.0
                    && middle < grain.radius + tool.depth
                    && compression.pressure(under, height.measure_over_plate(), tool)
                        >= grain.threshold
            };
            if !is_reached {
                held.grip = Grip::Below;
                continue;
            }
            if self.effect == Effect::Absorb {
                grain.fate = Fate::Absorbed;
                grain.position = place;
                plant.world.remove_body(held.body);
                *slot = None;
                continue;
            }
            let (depth, outward) = nearest_side(tool, under);
            held.grip = match held.grip {
                Grip::Beside => Grip::Side(in_plate),
                Grip::Side(_) if depth > SIDE_DEPTH => Grip::Held(in_plate),
                Grip::Below => Grip::Held(in_plate),
                kept => kept,
            };
            let goal = match held.grip {
                Grip::Held(place) | Grip::Side(place) => plate * place,
                Grip::Beside | Grip::Below => at,
            };
            let velocity = plant.plate_velocity(&goal);
            let normal = plant.real().normal(place);
            let Some(body) = plant.world.bodies.get_mut(held.body) else {
                continue;
            };
            let (v, mass) = (body.linvel(), body.mass());
            let slip = velocity - Vector3::new(v.x, v.y, v.z);
            // Critically damped spring to the grip: F = m (ω² (goal − x) + 2 ω (v_tool − v)).
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
            // The force acts along the surface; in the direction of the normal, the tool yields.
            let along = force - normal * normal.dot(&force);
            body.reset_forces(true);
            body.add_force(vector(&along), true);
            if !self.is_resisting {
                continue;
            }
            // The reaction of the force that moves the grain acts on the tool, and so does the
            // friction of the dirt that the grain stands for, against the tool's motion.
            let moving = velocity - normal * normal.dot(&velocity);
            let rubbing = moving * (self.drag / moving.norm().max(RUBBING_SPEED));
            plant.resist(&-(along + rubbing), &at);
        }
    }

    /// Lets the drops of a film that the tool does not hold run down for a period [s].
    pub fn run_film(&mut self, plant: &mut Plant, dirt: &mut Dirt, task: &Task, period: f64) {
        let Some((film, spacing, elapsed)) = &mut self.film else {
            return;
        };
        *elapsed += period;
        if *elapsed < FILM_STEP {
            return;
        }
        let is_free = |slot: &Option<GrainBody>| {
            slot.is_some_and(|held| matches!(held.grip, Grip::Beside | Grip::Below))
        };
        let free = (0..self.bodies.len()).filter(|&i| is_free(&self.bodies[i]));
        let free: Vec<usize> = free.collect();
        let places: Vec<Point2> = free.iter().map(|&i| dirt.grains[i].position).collect();
        let moved = film.displacements(&places, plant.real(), *spacing, *elapsed);
        *elapsed = 0.0;
        for (index, by) in free.into_iter().zip(moved) {
            let Some(held) = self.bodies[index].filter(|_| by != Vector2::zeros()) else {
                continue;
            };
            let grain = &mut dirt.grains[index];
            let to = grain.position + by;
            if let Some(fate) = run_off(&task.surface, grain.position, to) {
                grain.fate = fate;
                plant.world.remove_body(held.body);
                self.bodies[index] = None;
            } else {
                let at = plant.real().world_from_place(to, grain.radius);
                if let Some(body) = plant.world.bodies.get_mut(held.body) {
                    body.set_translation(vector(&at.translation.vector), true);
                }
            }
            grain.position = to;
        }
    }

    /// Releases grains that the tool left, and removes grains that fell off the surface.
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
            if let Some([at_rest, sliding]) = self.declared_friction {
                let is_sliding = body.linvel().length() > SLIDING_SPEED;
                let friction = if is_sliding { sliding } else { at_rest };
                for &collider in body.colliders() {
                    if let Some(collider) = plant.world.colliders.get_mut(collider) {
                        collider.set_friction(friction);
                    }
                }
            }
            let at = body.translation();
            let at = Point3::new(at.x, at.y, at.z);
            let ChartPoint { place: now, height } = plant.real().chart(at);
            if !(now.x.is_finite() && now.y.is_finite()) {
                continue;
            }
            let has_left =
                height < grain.radius - FALL_DEPTH || !task.surface.outline.contains(now);
            let edge = task.surface.exit_edge(grain.position, now);
            let off = match edge.filter(|_| has_left) {
                Some(edge) => Some(Fate::OffSurface {
                    edge: u16::try_from(edge).unwrap_or(u16::MAX),
                }),
                None => {
                    let has_fallen = self.declared_friction.is_some() && height > FALLEN_HEIGHT;
                    has_fallen.then_some(Fate::FALLEN)
                }
            };
            if let Some(fate) = off {
                grain.fate = fate;
                plant.world.remove_body(held.body);
                *slot = None;
            }
            if task.surface.outline.contains(now) || grain.fate != Fate::OnSurface {
                grain.position = now;
            }
        }
    }
}

/// Returns the distance [m] of a point under the tool from the nearest side, and the outward direction of that side.
fn nearest_side(tool: &HeldTool, under: Point2) -> (f64, Vector2) {
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
