//! Dirt that slides down a surface by its own weight.
//!
//! A particle rests while tan θ is at most the coefficient of friction at rest, where θ is the angle between the normal
//! and the vertical. Otherwise it takes the steepest way down until tan θ is at most the coefficient of sliding friction,
//! or over a border. Its inertia is neglected, so a slide has a path but no duration. If the
//! surface faces down, the particle falls.
//!
//! The path is a straight line of the chart on a plane and on a cylinder whose axis is level. On other shapes it is
//! integrated by the method of Runge and Kutta, on a mesh over its smoothed normals.

use super::surface::UPRIGHT;
use super::{
    DirtFriction, Fate, OccupiedArea, ParticleDistribution, ParticleField, Surface, SurfaceShape,
};
use crate::geometry::{Bounds2, Edge, Point2, Vector2, Vector3};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Slope from which no coefficient of friction is compared with the tangent [rad]: 89°, whose tangent is 57.
const STEEPEST: f64 = 89.0 * PI / 180.0;

/// Step at which the path of a sliding particle is checked for objects, and at which it is integrated [m].
const STEP: f64 = 0.002;
/// Largest number of steps along a straight path, and along an integrated path.
const MAX_STEPS: f64 = 500.0;
const MAX_INTEGRATED: usize = 20_000;
/// Step below which a path that turns upwards has reached the bottom of a valley [m].
const LEAST_STEP: f64 = 1e-7;
/// Number of bisections that locate the place where a particle comes to rest.
const BISECTIONS: usize = 40;
/// Distance beyond a border at which a particle that slid over it is placed [m].
const BEYOND: f64 = 1e-3;
/// Share of gravity along the axis of a cylinder below which the axis counts as level [1].
const LEVEL_AXIS: f64 = 1e-9;

/// A surface on which dirt slides before the first round.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SteepSurface {
    /// Largest angle between the surface's normal and the vertical \[rad\].
    pub slope: f64,
    /// Coefficient of friction of the dirt at rest \[1\].
    pub friction: f64,
    /// Number of particles on the surface before they slid.
    pub lay: usize,
    /// Number of particles that slid.
    pub slid: usize,
    /// Number of particles that slid over a border or into a hole, or that fell.
    pub left: usize,
}

impl std::fmt::Display for SteepSurface {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self {
            slope,
            friction,
            lay,
            slid,
            left,
        } = self;
        let angle = slope.to_degrees();
        let steep = match *slope < STEEPEST {
            true => format!(
                "tan({angle:.1}°) = {:.2} exceeds the friction of the dirt on it, {friction}",
                slope.tan()
            ),
            false => format!("it leans by {angle:.1}°"),
        };
        write!(
            f,
            "the surface is too steep for the dirt to rest, {steep}: "
        )?;
        let resting = slid - left;
        if resting > 0 {
            write!(
                f,
                "{resting} of {lay} particles slide down and come to rest, and "
            )?;
        }
        write!(
            f,
            "{left} of {lay} particles slide off before the first round"
        )
    }
}

/// How dirt slides among the objects on a surface.
///
/// ```
/// use std::f64::consts::FRAC_PI_2;
/// use wisch::geometry::{Point2, Polygon, Pose, Vector2};
/// use wisch::represent::{DirtFriction, DirtSlide, OccupiedArea, Surface, SurfaceShape};
/// // A gutter of 0.5 m radius along y.
/// let outline = Polygon::rectangle(Vector2::new(1.2, 0.4));
/// let mut gutter = Surface::new("gutter", outline, Pose::identity());
/// gutter.shape = SurfaceShape::Cylinder { radius: -0.5, axis: FRAC_PI_2 };
/// let friction = DirtFriction { at_rest: 0.6, sliding: 0.5 };
/// let slide = DirtSlide::new(friction, OccupiedArea::default());
/// assert_eq!(slide.find_end(&gutter, Point2::new(0.26, 0.1)), None);
/// // It slides to the angle whose tangent is 0.5.
/// let end = slide.find_end(&gutter, Point2::new(0.5, 0.1)).ok_or("it rests")?;
/// assert!((end.place - Point2::new(0.5 * 0.5_f64.atan(), 0.1)).norm() < 1e-9);
/// # Ok::<(), &str>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct DirtSlide {
    friction: DirtFriction,
    occupied: OccupiedArea,
}

/// The end of the path of a sliding particle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlideEnd {
    /// Place in the chart, beyond the border if the particle left the surface \[m\].
    pub place: Point2,
    /// Whether the particle is still on the surface, and if not, over which edge it left.
    pub fate: Fate,
    /// Length of the path on the surface \[m\].
    pub length: f64,
}

/// Gravity at a place: along the surface, in the axes of the chart, and into it [1].
#[derive(Debug, Clone, Copy)]
struct Pull {
    along: Vector2,
    into: f64,
}

impl Pull {
    fn at(surface: &Surface, place: Point2) -> Self {
        let orientation = surface.world_from_surface.rotation * surface.shape.orientation(place);
        let down = orientation.inverse() * -Vector3::z();
        Self {
            along: down.xy(),
            into: -down.z,
        }
    }

    /// Whether this friction [1] holds a particle: gravity along the surface against friction from gravity into it.
    fn is_held(&self, friction: f64) -> bool {
        self.along.norm() <= friction * self.into
    }

    fn direction(&self) -> Vector2 {
        self.along
            .try_normalize(f64::MIN_POSITIVE)
            .unwrap_or_default()
    }
}

impl DirtSlide {
    /// Returns the sliding of dirt with this friction on a surface of which objects occupy an area.
    /// Objects stop the dirt on planes only.
    pub const fn new(friction: DirtFriction, occupied: OccupiedArea) -> Self {
        Self { friction, occupied }
    }

    /// Returns where a particle at a place of the chart ends; `None` if it rests there.
    pub fn find_end(&self, surface: &Surface, from: Point2) -> Option<SlideEnd> {
        let pull = Pull::at(surface, from);
        if pull.is_held(self.friction.at_rest) {
            return None;
        }
        if pull.into < -UPRIGHT {
            return Some(SlideEnd::falling(from, 0.0));
        }
        match surface.shape {
            SurfaceShape::Plane => self.find_end_on_plane(surface, from, pull.direction()),
            _ => Some(
                self.find_end_of_arc(surface, from)
                    .unwrap_or_else(|| self.integrate(surface, from)),
            ),
        }
    }

    /// Returns the particles after those on the surface have slid.
    #[must_use]
    pub fn settle(
        &self,
        particles: &ParticleDistribution,
        surface: &Surface,
    ) -> ParticleDistribution {
        let mut settled = particles.clone();
        for (index, end) in self.ends(particles.iter(), surface) {
            settled.put(index, end.place, end.fate);
        }
        settled
    }

    /// Lets the particles of a field slide.
    pub(super) fn settle_field(&self, field: &mut ParticleField, surface: &Surface) {
        let places = (0..field.len()).map(|index| field.place(index));
        for (index, end) in self.ends(places, surface) {
            field.relocate(index, end.place, end.fate);
        }
    }

    /// Returns the particles that slide, by index, with the ends of their paths.
    fn ends(
        &self,
        particles: impl Iterator<Item = (Point2, Fate)>,
        surface: &Surface,
    ) -> Vec<(usize, SlideEnd)> {
        let is_level = surface.shape.is_plane()
            && Pull::at(surface, Point2::origin()).is_held(self.friction.at_rest);
        if is_level {
            return Vec::new();
        }
        let lying = particles
            .enumerate()
            .filter(|(_, (_, fate))| *fate == Fate::OnSurface);
        lying
            .filter_map(|(index, (place, _))| Some((index, self.find_end(surface, place)?)))
            .collect()
    }

    /// Returns the end of a straight path down to the first object, border or hole; `None` if an
    /// object stops the particle where it is.
    fn find_end_on_plane(
        &self,
        surface: &Surface,
        from: Point2,
        direction: Vector2,
    ) -> Option<SlideEnd> {
        let bounds = Bounds2::from_points(surface.outline.outer().iter().copied())?;
        let longest = bounds.size().norm() + BEYOND;
        let length = find_border(surface, from, direction).map_or(longest, |way| way.min(longest));
        let Some(stop) = find_stop(&self.occupied, from, direction, length) else {
            return Some(SlideEnd::beyond_border(surface, from, direction, length));
        };
        (stop > 0.0).then(|| SlideEnd::resting(from + direction * stop, stop))
    }

    /// Returns the end of an arc around a cylinder whose axis is level; `None` on other shapes.
    ///
    /// At the angle χ from the line where the normal points up, gravity is sin χ along the arc and cos χ into it. In a
    /// hollow the particle slides to tan |χ| = μ, and on a bulge it falls at |χ| = π/2.
    fn find_end_of_arc(&self, surface: &Surface, from: Point2) -> Option<SlideEnd> {
        let SurfaceShape::Cylinder { radius, axis } = surface.shape else {
            return None;
        };
        let across = Vector2::new(-libm::sin(axis), libm::cos(axis));
        let down = surface.world_from_surface.rotation.inverse() * -Vector3::z();
        let along_axis = Vector2::new(across.y, -across.x).dot(&down.xy());
        if along_axis.abs() > LEVEL_AXIS {
            return None;
        }
        // The normal at the angle φ is n cos φ + e sin φ, and points up half a turn from where it points down.
        let top = libm::atan2(across.dot(&down.xy()), down.z) + PI;
        let turned = surface.shape.roll(from) - top;
        let angle = turned - TAU * (turned / TAU).round();
        let end = match radius > 0.0 {
            true => FRAC_PI_2,
            false => libm::atan(self.friction.sliding),
        };
        let arc = radius * (end.copysign(angle) - angle);
        let (direction, length) = (across * arc.signum(), arc.abs());
        let border = find_border(surface, from, direction).filter(|way| *way <= length);
        let place = from + direction * length;
        Some(match border {
            Some(way) => SlideEnd::beyond_border(surface, from, direction, way),
            None if radius > 0.0 => SlideEnd::falling(place, length),
            None => SlideEnd::resting(place, length),
        })
    }

    /// Returns the end of the steepest path down.
    fn integrate(&self, surface: &Surface, from: Point2) -> SlideEnd {
        let height = |place| surface.world_from_place(place, 0.0).translation.z;
        let (mut at, mut length, mut step) = (from, 0.0, STEP);
        for _ in 0..MAX_INTEGRATED {
            let next = descend(surface, at, step);
            if let Some(way) = find_border(surface, at, (next - at).normalize())
                && way <= (next - at).norm()
            {
                let direction = (next - at).normalize();
                let end = SlideEnd::beyond_border(surface, at, direction, way);
                return SlideEnd {
                    length: length + way,
                    ..end
                };
            }
            let pull = Pull::at(surface, next);
            if pull.into < 0.0 {
                return SlideEnd::falling(next, length + step);
            }
            if pull.is_held(self.friction.sliding) {
                let (mut sliding, mut held) = (0.0, step);
                for _ in 0..BISECTIONS {
                    let way = 0.5 * (sliding + held);
                    let there = Pull::at(surface, descend(surface, at, way));
                    match there.is_held(self.friction.sliding) {
                        true => held = way,
                        false => sliding = way,
                    }
                }
                return SlideEnd::resting(descend(surface, at, held), length + held);
            }
            if height(next) < height(at) {
                (at, length, step) = (next, length + step, STEP);
            } else if step > LEAST_STEP {
                step *= 0.5;
            } else {
                break;
            }
        }
        SlideEnd::resting(at, length)
    }
}

impl SlideEnd {
    fn resting(place: Point2, length: f64) -> Self {
        Self {
            place,
            fate: Fate::OnSurface,
            length,
        }
    }

    fn falling(place: Point2, length: f64) -> Self {
        Self {
            place,
            fate: Fate::FALLEN,
            length,
        }
    }

    /// Returns the end of a straight move that leaves the surface after `length` [m].
    fn beyond_border(surface: &Surface, from: Point2, direction: Vector2, length: f64) -> Self {
        let place = from + direction * (length + BEYOND);
        let edge = surface.exit_edge(from, place);
        let edge = edge.and_then(|edge| u16::try_from(edge).ok());
        Self {
            place,
            fate: edge.map_or(Fate::FALLEN, |edge| Fate::OffSurface { edge }),
            length,
        }
    }
}

/// Returns the place at a distance [m] on the steepest path down (Kutta, 1901).
fn descend(surface: &Surface, from: Point2, distance: f64) -> Point2 {
    let direction = |place| Pull::at(surface, place).direction();
    let first = direction(from);
    let second = direction(from + first * (0.5 * distance));
    let third = direction(from + second * (0.5 * distance));
    let fourth = direction(from + third * distance);
    from + (first + 2.0 * (second + third) + fourth) * (distance / 6.0)
}

/// Returns the length of a straight move up to the border of the surface or of a hole [m]; `None`
/// if it meets none.
pub(super) fn find_border(surface: &Surface, from: Point2, direction: Vector2) -> Option<f64> {
    let leaves = |edge: Edge| {
        let border = edge.end - edge.start;
        let divisor = direction.perp(&border);
        let way = (edge.start - from).perp(&border) / divisor;
        let on_border = (edge.start - from).perp(&direction) / divisor;
        // Outer borders run counter-clockwise and those of holes clockwise, so that only edges that are left count.
        (divisor > 0.0 && way >= 0.0 && (0.0..=1.0).contains(&on_border)).then_some(way)
    };
    (surface.outline.edges())
        .filter_map(leaves)
        .reduce(f64::min)
}

/// Returns the length of a straight move before the first object that occupies an area \[m\], if there is one.
pub(super) fn find_stop(
    occupied: &OccupiedArea,
    from: Point2,
    direction: Vector2,
    length: f64,
) -> Option<f64> {
    if occupied.sections().is_empty() {
        return None;
    }
    let step = STEP.max(length / MAX_STEPS);
    let count = (length / step) as usize;
    let way = |i: usize| step * i as f64;
    let first = (1..=count).find(|&i| occupied.contains(from + direction * way(i)))?;
    Some(way(first - 1))
}

/// Lets dirt slide on a surface that is too steep for it, and returns the dirt after the slide.
/// `None` if no particle slides.
///
/// Particles that are already gone stay as they are.
pub fn slide_down(
    particles: &ParticleDistribution,
    surface: &Surface,
    slide: &DirtSlide,
) -> Option<(ParticleDistribution, SteepSurface)> {
    let settled = slide.settle(particles, surface);
    let moves = particles.iter().zip(settled.iter());
    let slid = moves.filter(|(before, after)| before != after).count();
    let lay = particles.tally().remaining;
    let steep = SteepSurface {
        slope: surface.steepest_slope(),
        friction: slide.friction.at_rest,
        lay,
        slid,
        left: lay - settled.tally().remaining,
    };
    (slid > 0).then_some((settled, steep))
}

#[cfg(test)]
mod tests;
