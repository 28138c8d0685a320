//! The effect model: the effect of a tool in contact on the particles under it; paper §3.1.
//!
//! - *absorb*: a particle that comes under the footprint is deleted.
//! - *push*: a particle that comes under the footprint is carried along with the tool's motion until it is outside. It
//!   rides on the footprint's leading boundary while that boundary advances towards it, and stays behind when the
//!   boundary recedes.
//! - *treat*: a particle is a place of the surface. It stays, and counts in passes how far the footprint slides over
//!   it. A pass is the footprint's mean length along the tool. Polishing and painting use the count differently.
//!
//! Particles do not touch each other, so each is computed alone. A translation has a closed form
//! ([`swept_translation`](super::swept_translation)); a motion that also turns is followed from one contact event to
//! the next ([`swept_rotation`](super::swept_rotation)). Neither has a step size.
//!
//! On a curved surface, a compliant tool acts only where its pressure is high enough
//! ([`EffectModel::with_contact`]).

use super::acting_part::ActingPart;
use super::field::{OrientedBox, ParticleField, Slot};
use super::film::FilmFlow;
use super::heap::Heap;
use super::motion::{CLEARANCE, ToolMotion};
use super::sliding::DirtSlide;
use super::swept_rotation::SweptRotation;
use super::swept_translation::SweptTranslation;
use super::{Effect, ElasticFoundation, Fate, LocalPressure, Surface};
use crate::geometry::{Edge, PlanarPose, Point2, Region, Vector2};
use rayon::prelude::*;

/// Number of particles near a turning tool above which they are followed on all threads.
const PARALLEL_FROM: usize = 1024;
/// Turn below which a motion counts as straight if only a part of the tool acts [rad].
const SMALL_TURN: f64 = 0.1;
/// Number of particles of a block before a tool above which the model first checks whether any can
/// leave the surface.
const CHECKED_FROM: usize = 8;

/// Numbers of particles that one motion absorbed, displaced or lost.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct MotionEffect {
    /// Particles that the tool absorbed.
    pub absorbed: usize,
    /// Particles that the tool displaced and that are still on the surface.
    pub pushed: usize,
    /// Particles that the tool pushed over an edge of the surface.
    pub off_surface: usize,
    /// Places that the tool slid over.
    pub treated: usize,
}

/// Effect of a tool on the particles of a medium.
///
/// The cost of a motion is proportional to the number of particles in the blocks near the swept area. Once the first
/// motions have sized its scratch memory, the model allocates nothing, except for the thread pool when a turning tool
/// meets very many particles.
///
/// ```
/// use wisch::geometry::*;
/// use wisch::represent::*;
/// let sponge = Region::new(vec![Polygon::rectangle(Vector2::new(0.07, 0.11))]);
/// let board = Surface {
///     name: "board".into(),
///     outline: Polygon::rectangle(Vector2::new(0.4, 0.28)),
///     world_from_surface: Pose::identity(),
///     skim_edges: vec![],
///     shape: Default::default(),
/// };
/// let crumbs = ParticleDistribution::new(&[Point2::new(0.05, 0.0), Point2::new(0.05, 0.1)])?;
/// let mut field = ParticleField::new(&crumbs);
/// let stroke = ToolMotion {
///     from: PlanarPose::new(Point2::new(0.0, 0.0), 0.0),
///     to: PlanarPose::new(Point2::new(0.1, 0.0), 0.0),
/// };
/// let effect = EffectModel::new(&sponge, Effect::Push).apply(&mut field, &board, &stroke);
/// assert_eq!(effect.pushed, 1);
/// // The crumb rides on the leading edge, half the sponge's depth ahead of the tool centre point.
/// assert!((field.distribution().position(0).x - 0.135).abs() < 1e-8);
/// # Ok::<(), ParticleError>(())
/// ```
#[derive(Debug, Clone)]
pub struct EffectModel {
    kind: Effect,
    footprint: Region,
    edges: Vec<Edge>,
    /// Largest distance of the footprint from the tool centre point [m].
    reach: f64,
    /// Travel over a place that counts as one pass [m].
    pass_length: f64,
    translation: SweptTranslation,
    /// Blocks of particles near a motion.
    blocks: Vec<u32>,
    near: Vec<Slot>,
    outcomes: Vec<Option<Outcome>>,
    heap: Option<Heap>,
    /// How the dirt slides by its own weight; `None` if it stays.
    slide: Option<DirtSlide>,
    /// How a film runs by its own weight; `None` if it stays.
    film: Option<FilmFlow>,
    /// The part that acts where the surface bends; `None` if the whole footprint acts everywhere.
    acting: Option<ActingPart>,
    /// The pressure of a tool that touches with a part of its footprint.
    pressure: Option<LocalPressure>,
}

/// Outcome of a motion for a particle that it touches.
#[derive(Debug, Clone, Copy)]
enum Outcome {
    Absorbed,
    Pushed { to: Point2 },
    OffSurface { at: Point2, edge: u16 },
    Treated { passes: f64 },
}

impl EffectModel {
    /// Returns the model of a footprint (tool frame \[m\]) with this effect.
    pub fn new(footprint: &Region, kind: Effect) -> Self {
        let edges: Vec<Edge> = footprint.edges().collect();
        let reach = edges
            .iter()
            .map(|edge| edge.start.coords.norm())
            .fold(0.0, f64::max);
        Self {
            kind,
            pass_length: mean_length(footprint),
            translation: SweptTranslation::new(
                edges.len(),
                matches!(footprint.polygons(), [one] if one.is_convex()),
            ),
            edges,
            reach,
            blocks: Vec::new(),
            near: Vec::new(),
            outcomes: Vec::new(),
            heap: None,
            slide: None,
            film: None,
            acting: None,
            pressure: None,
            footprint: footprint.clone(),
        }
    }

    /// Returns the model of a tool that acts on a curved surface only where its pressure is high
    /// enough. On a plane it acts with its whole footprint.
    ///
    /// While the tool turns, only the part acts whose pressure is high enough at every yaw. The
    /// result therefore depends neither on the place of the motion nor on how it is split.
    ///
    /// # Parameters
    /// - `foundation`: the foundation of the whole tool; the footprint of the model may be a part of it.
    /// - `least`: least pressure over the nominal one at which the tool acts \[1\], see
    ///   [`effective_pressure`](super::effective_pressure).
    ///
    /// ```
    /// # use wisch::geometry::*;
    /// # use wisch::represent::*;
    /// let plate = Region::new(vec![Polygon::rectangle(Vector2::new(0.06, 0.1))]);
    /// let outline = Polygon::rectangle(Vector2::new(0.4, 0.28));
    /// let mut pipe = Surface::new("pipe", outline, Pose::identity());
    /// pipe.shape = SurfaceShape::Cylinder { radius: 0.5, axis: 0.0 };
    /// let crumbs = ParticleDistribution::new(&[Point2::new(0.05, 0.0), Point2::new(0.05, 0.03)])?;
    /// let mut field = ParticleField::new(&crumbs);
    /// let stroke = ToolMotion {
    ///     from: PlanarPose::new(Point2::new(0.0, 0.0), 0.0),
    ///     to: PlanarPose::new(Point2::new(0.1, 0.0), 0.0),
    /// };
    /// // A rigid plate touches a strip of 3.9 cm along the pipe, so that the second crumb stays.
    /// let rigid = ElasticFoundation::new(&plate, 0.0).expect("it has an area");
    /// let mut model = EffectModel::new(&plate, Effect::Absorb).with_contact(rigid, 0.0);
    /// assert_eq!(model.apply(&mut field, &pipe, &stroke).absorbed, 1);
    /// # Ok::<(), ParticleError>(())
    /// ```
    #[must_use]
    pub fn with_contact(self, foundation: ElasticFoundation, least: f64) -> Self {
        let acting = Some(ActingPart::new(foundation, least));
        Self { acting, ..self }
    }

    /// Returns the model with a heap: carried particles take space ahead of the tool, `depth_of_all` \[m\] deep if it
    /// holds all particles; see [`heap_depth`](super::heap_depth).
    ///
    /// At the end of each motion, particles whose place in the heap is beyond an edge have fallen; at
    /// [`EffectModel::lift_off`] the remaining ones stay spread over the heap. The place of a particle in the heap
    /// depends on `seed`, the particle and the number of the contact only.
    ///
    /// ```
    /// # use wisch::geometry::*;
    /// # use wisch::represent::*;
    /// # let sponge = Region::new(vec![Polygon::rectangle(Vector2::new(0.07, 0.11))]);
    /// # let board = Surface {
    /// #     name: "board".into(),
    /// #     outline: Polygon::rectangle(Vector2::new(0.4, 0.28)),
    /// #     world_from_surface: Pose::identity(),
    /// #     skim_edges: vec![],
    /// #     shape: Default::default(),
    /// # };
    /// let crumbs = ParticleDistribution::new(&[Point2::new(0.05, 0.0); 100])?;
    /// let mut field = ParticleField::new(&crumbs);
    /// // Pushed to 1 cm before the edge, a heap 2 cm deep has lost about half of its particles.
    /// let stroke = ToolMotion {
    ///     from: PlanarPose::new(Point2::new(0.0, 0.0), 0.0),
    ///     to: PlanarPose::new(Point2::new(0.155, 0.0), 0.0),
    /// };
    /// let mut model = EffectModel::new(&sponge, Effect::Push).with_heap(0.02, 1);
    /// let effect = model.apply(&mut field, &board, &stroke);
    /// assert!((30..70).contains(&effect.off_surface));
    /// # Ok::<(), ParticleError>(())
    /// ```
    #[must_use]
    pub fn with_heap(self, depth_of_all: f64, seed: u64) -> Self {
        Self {
            heap: Some(Heap::new(depth_of_all, seed)),
            ..self
        }
    }

    /// Returns the model with dirt that slides by its own weight whenever the tool lifts off.
    #[must_use]
    pub fn with_slide(self, slide: Option<DirtSlide>) -> Self {
        Self { slide, ..self }
    }

    /// Returns the model with a film that runs by its own weight while time passes, see [`EffectModel::wait`].
    #[must_use]
    pub fn with_film(self, film: Option<FilmFlow>) -> Self {
        Self { film, ..self }
    }

    /// Sets the pressure under the tool for the following motions: only the part under pressure
    /// acts. `None` if the whole footprint acts. Motions that turn by less than [`SMALL_TURN`] then
    /// count as straight; during larger turns, the whole footprint acts.
    pub(crate) fn set_pressure(&mut self, pressure: Option<LocalPressure>) {
        self.pressure = pressure;
    }

    /// Ends the contact. The dirt that the tool has carried since the last motion began comes to
    /// rest: spread over its heap, or, without a heap, exactly where the motion left it. If the
    /// surface is too steep for the dirt, it slides.
    pub fn lift_off(&mut self, field: &mut ParticleField, surface: &Surface) {
        if let Some(heap) = &mut self.heap {
            heap.come_to_rest(field, surface);
        }
        if let Some(slide) = &self.slide {
            slide.settle_field(field, surface);
        }
    }

    /// Lets a film run for a duration \[s\]. Nothing else changes with time.
    pub fn wait(&mut self, field: &mut ParticleField, surface: &Surface, duration: f64) {
        if let Some(film) = &self.film {
            film.run(field, surface, duration);
        }
    }

    /// Sets the number of contacts so far, with nothing carried.
    pub(crate) fn resume_after(&mut self, contacts: u32) {
        if let Some(heap) = &mut self.heap {
            heap.resume(contacts);
        }
    }

    /// Applies a motion in contact to the particles, and returns the numbers of affected ones.
    pub fn apply(
        &mut self,
        field: &mut ParticleField,
        surface: &Surface,
        motion: &ToolMotion,
    ) -> MotionEffect {
        self.apply_where(field, surface, motion, |_, _| true)
    }

    /// Applies a motion in contact to the particles that respond to it, and returns the numbers of
    /// affected ones.
    ///
    /// `responds` is called once for each particle that the motion would affect. It gets the particle's index in the
    /// original distribution and its place before the motion (surface frame \[m\]). The order of the calls depends on the
    /// field alone. A particle that does not respond stays as it is.
    ///
    /// ```
    /// # use wisch::geometry::*;
    /// # use wisch::represent::*;
    /// # let sponge = Region::new(vec![Polygon::rectangle(Vector2::new(0.07, 0.11))]);
    /// # let board = Surface {
    /// #     name: "board".into(),
    /// #     outline: Polygon::rectangle(Vector2::new(0.4, 0.28)),
    /// #     world_from_surface: Pose::identity(),
    /// #     skim_edges: vec![],
    /// #     shape: Default::default(),
    /// # };
    /// let crumbs = ParticleDistribution::new(&[Point2::new(0.05, 0.0), Point2::new(0.05, 0.02)])?;
    /// let mut field = ParticleField::new(&crumbs);
    /// let stroke = ToolMotion {
    ///     from: PlanarPose::new(Point2::new(0.0, 0.0), 0.0),
    ///     to: PlanarPose::new(Point2::new(0.1, 0.0), 0.0),
    /// };
    /// let effect = EffectModel::new(&sponge, Effect::Absorb)
    ///     .apply_where(&mut field, &board, &stroke, |particle, _| particle == 1);
    /// assert_eq!(effect.absorbed, 1);
    /// assert_eq!(field.distribution().fate(1), Fate::Absorbed);
    /// # Ok::<(), ParticleError>(())
    /// ```
    pub fn apply_where(
        &mut self,
        field: &mut ParticleField,
        surface: &Surface,
        motion: &ToolMotion,
        mut responds: impl FnMut(usize, Point2) -> bool,
    ) -> MotionEffect {
        let Some(mut heap) = self.heap.take() else {
            return self.sweep(field, surface, motion, responds);
        };
        heap.begin(motion, surface);
        let mut effect = self.sweep(field, surface, motion, |particle, position| {
            let is_carried = responds(particle, position);
            if is_carried {
                heap.carry(particle);
            }
            is_carried
        });
        let fallen = heap.spill(field, surface);
        effect.pushed -= fallen;
        effect.off_surface += fallen;
        self.heap = Some(heap);
        effect
    }

    fn sweep(
        &mut self,
        field: &mut ParticleField,
        surface: &Surface,
        motion: &ToolMotion,
        responds: impl FnMut(usize, Point2) -> bool,
    ) -> MotionEffect {
        let turn = motion.turn().abs();
        let is_straight = turn * self.reach < CLEARANCE;
        if is_straight || (self.pressure.is_some() && turn < SMALL_TURN) {
            self.translate(field, surface, motion, responds)
        } else {
            self.turn(field, surface, motion, responds)
        }
    }

    fn translate(
        &mut self,
        field: &mut ParticleField,
        surface: &Surface,
        motion: &ToolMotion,
        mut responds: impl FnMut(usize, Point2) -> bool,
    ) -> MotionEffect {
        let (along, length) = motion.travel();
        if self.kind == Effect::Push && length == 0.0 {
            return MotionEffect::default();
        }
        let heading = motion.from.heading;
        let mut acting = (self.acting.as_mut())
            .and_then(|part| part.is_partial(surface, heading).then_some(part));
        let given = self.pressure.map(|pressure| (pressure, 0.0));
        let is_partial = acting.is_some() || given.is_some();
        let edges = &self.edges;
        (self.translation).fill(edges, heading, (along, length), is_partial);
        let Some((low, high)) = self.translation.extent() else {
            return MotionEffect::default();
        };
        let side = Vector2::new(-along.y, along.x);
        let near = OrientedBox {
            center: motion.from.position
                + along * ((low.x + high.x + length) / 2.0)
                + side * ((low.y + high.y) / 2.0),
            axis: along,
            half: Vector2::new(high.x - low.x + length, high.y - low.y) / 2.0,
        };
        field.blocks_near(&near, &mut self.blocks);

        let mut stays = None;
        let mut effect = MotionEffect::default();
        for &block in &self.blocks {
            let slots = field.slots(block);
            let particles = field.coordinates(slots.clone());
            let from = motion.from.position;
            let met = if is_partial {
                let part = |at| {
                    let acting = acting.as_mut();
                    given.or_else(|| acting?.pressure(surface, at, heading))
                };
                (self.translation).find_met_by_part(particles, &motion.from, self.kind, part)
            } else {
                (self.translation).find_met(particles, from, self.kind)
            };
            if met >= CHECKED_FROM {
                stays.get_or_insert_with(|| is_inside(surface, edges, &motion.to));
            }
            let pushed = effect.pushed;
            // Backwards, as a particle that leaves the surface gives its slot to the last one of its block.
            for number in (0..met).rev() {
                let (particle, extent) = self.translation.outcome(number);
                let slot = slots.start + particle;
                let position = field.position(slot);
                if !responds(field.index(slot), position) {
                    continue;
                }
                let to = position + along * extent;
                if self.kind == Effect::Push && stays == Some(true) {
                    field.put(slot, to);
                    effect.pushed += 1;
                    continue;
                }
                let outcome = match self.kind {
                    Effect::Push => landing(surface, &[position, to]),
                    Effect::Absorb => Outcome::Absorbed,
                    Effect::Treat => Outcome::Treated {
                        passes: extent / self.pass_length,
                    },
                };
                effect.settle(field, slot, outcome);
            }
            if effect.pushed > pushed {
                field.refit(block as usize);
            }
        }
        effect
    }

    fn turn(
        &mut self,
        field: &mut ParticleField,
        surface: &Surface,
        motion: &ToolMotion,
        mut responds: impl FnMut(usize, Point2) -> bool,
    ) -> MotionEffect {
        let (along, length) = motion.travel();
        let center = nalgebra::center(&motion.from.position, &motion.to.position);
        let near = OrientedBox {
            center,
            axis: along,
            half: Vector2::new(length / 2.0 + self.reach, self.reach),
        };
        field.blocks_near(&near, &mut self.blocks);
        self.near.clear();
        for &block in &self.blocks {
            let slots = field.slots(block);
            self.near
                .extend(slots.filter(|&slot| near.contains(field.position(slot))));
        }

        let at_every_yaw =
            (self.acting.as_mut()).and_then(|part| part.at_every_yaw(surface, &self.footprint));
        let rotation = SweptRotation::new(at_every_yaw.unwrap_or(&self.edges), motion);
        let corridor = Edge {
            start: motion.from.position,
            end: motion.to.position,
        };
        let outcome = |position: Point2| {
            if corridor.distance(position) > self.reach {
                return None;
            }
            match self.kind {
                Effect::Absorb => rotation.touches(position).then_some(Outcome::Absorbed),
                Effect::Push => rotation
                    .ride(position)
                    .map(|way| landing(surface, way.points())),
                Effect::Treat => {
                    let slid = rotation.slid(position);
                    let passes = slid / self.pass_length;
                    (slid > 0.0).then_some(Outcome::Treated { passes })
                }
            }
        };
        // Each particle is computed alone, so the result does not depend on the number of threads.
        if self.near.len() < PARALLEL_FROM {
            self.outcomes.clear();
            let positions = self.near.iter().map(|&slot| field.position(slot));
            self.outcomes.extend(positions.map(outcome));
        } else {
            let positions = self.near.par_iter().map(|&slot| field.position(slot));
            positions.map(outcome).collect_into_vec(&mut self.outcomes);
        }
        let mut effect = MotionEffect::default();
        // Backwards, as a particle that leaves the surface gives its slot to the last one of its block.
        for (&slot, outcome) in self.near.iter().zip(&self.outcomes).rev() {
            if let Some(outcome) = *outcome
                && responds(field.index(slot), field.position(slot))
            {
                effect.settle(field, slot, outcome);
            }
        }
        if effect.pushed > 0 {
            (self.blocks.iter()).for_each(|&block| field.refit(block as usize));
        }
        effect
    }
}

/// Whether all dirt that the footprint carries to a pose stays on the surface: the surface is
/// convex, and the footprint with its clearance lies within it.
fn is_inside(surface: &Surface, footprint: &[Edge], at: &PlanarPose) -> bool {
    let (sin, cos) = at.heading.sin_cos();
    surface.outline.is_convex()
        && surface.outline.edges().all(|edge| {
            let along = edge.end - edge.start;
            let least = 2.0 * CLEARANCE * along.norm();
            footprint.iter().all(|corner| {
                let Point2 { coords: p } = corner.start;
                let turned = Vector2::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y);
                along.perp(&(at.position + turned - edge.start)) > least
            })
        })
}

impl MotionEffect {
    /// Applies the outcome to a particle and counts it; the block of a pushed particle must be refitted afterwards.
    fn settle(&mut self, field: &mut ParticleField, slot: Slot, outcome: Outcome) {
        match outcome {
            Outcome::Absorbed => {
                field.remove(slot, field.position(slot), Fate::Absorbed);
                self.absorbed += 1;
            }
            Outcome::Pushed { to } => {
                field.put(slot, to);
                self.pushed += 1;
            }
            Outcome::OffSurface { at, edge } => {
                field.remove(slot, at, Fate::OffSurface { edge });
                self.off_surface += 1;
            }
            Outcome::Treated { passes } => {
                field.treat(slot, passes);
                self.treated += 1;
            }
        }
    }
}

/// Returns the end of a particle that is carried along `way`, which may cross the border of the
/// surface.
fn landing(surface: &Surface, way: &[Point2]) -> Outcome {
    let off = way.windows(2).find_map(|leg| {
        let edge = surface.exit_edge(leg[0], leg[1])?;
        Some(Outcome::OffSurface {
            at: leg[1],
            edge: u16::try_from(edge).unwrap_or(u16::MAX),
        })
    });
    off.unwrap_or(Outcome::Pushed {
        to: way.last().copied().unwrap_or_else(Point2::origin),
    })
}

/// Mean length of a footprint along the tool's x axis [m]: its area over its width.
fn mean_length(footprint: &Region) -> f64 {
    let width = footprint.bounds().map_or(0.0, |bounds| bounds.size().y);
    if width > 0.0 {
        footprint.area() / width
    } else {
        f64::INFINITY
    }
}
