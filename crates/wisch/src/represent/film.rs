//! Films of liquid that run down a plane.
//!
//! Each particle stands for a volume of liquid. A film of thickness h on a plane that leans by θ runs down at the mean
//! speed u = ρ g h² sin θ / 3μ (Nusselt, 1916). A layer of the thickness a adheres, so that only h − a takes part. With the
//! rate c = ρ g sin θ / 3μ, the thickness follows the kinematic wave ∂h/∂t + ∂/∂x c (h − a)³ = 0.
//!
//! The volume M(x, t) upstream of a place, per width, then obeys ∂M/∂t + H(∂M/∂x) = 0 with H(h) = c (h − a)³. Its solution
//! is a minimum over the places y from which the liquid may have come (Lax, 1957):
//!
//! M(x, t) = min over y of M(y, 0) + t L((x − y)/t), with L(v) = max over h of h v − H(h) = a v + ⅔ v √(v/3c).
//!
//! A particle keeps the volume that lies upstream of it. It therefore moves to the largest y + t L⁻¹((M − M(y, 0))/t).
//! This is exact for any duration, as long as the thickness is constant between the particles from which it is read.

use super::sliding::{find_border, find_stop};
use super::surface::UPRIGHT;
use super::{Fate, Liquid, LiquidFilm, OccupiedArea, ParticleField, Surface};
use crate::geometry::{Point2, Vector2, Vector3};

/// Acceleration of gravity [m/s²].
const GRAVITY: f64 = 9.81;
/// Largest Reynolds number ρ u h/μ up to which a film runs by its viscosity alone \[1\]; the waves
/// on a thicker film carry part of it. They are assumed to run as fast as the waves on a film of
/// this number, so that the front runs at most three times as fast.
pub const MAX_REYNOLDS: f64 = 30.0;
/// Number of successive particles over which the thickness is averaged.
const AVERAGED: usize = 8;
/// Width of the columns into which a film is divided, over the mean distance of its particles [1].
const COLUMN: f64 = 4.0;
/// Largest number of steps of Newton's method, which converges from above.
const MAX_NEWTON: usize = 30;

/// A film of liquid on a plane.
#[derive(Debug, Clone, PartialEq)]
pub struct FilmFlow {
    film: LiquidFilm,
    occupied: OccupiedArea,
}

/// The film on one surface.
struct Slope {
    /// c = ρ g sin θ / 3μ [1/(m s)].
    rate: f64,
    /// Thickness above which the waves on a film run no faster [m].
    thickest: f64,
    /// Thickness that adheres [m].
    adhering: f64,
}

/// A film of constant thickness, and the wave on it.
struct FilmWave {
    /// Volume of the film per width [m²], and its thickness [m].
    part: f64,
    thickness: f64,
    /// Speed of the wave [m/s], and the volume per width that passes it in a time, a v + ⅔ v (h − a) [m²/s].
    speed: f64,
    flow: f64,
}

/// A particle of a column: its place along the slope [m] and its index.
type Along = (f64, usize);

impl Liquid {
    /// Returns the mean speed [m/s] of a film of a thickness \[m\] on a slope of an angle \[rad\],
    /// at most the speed at [`MAX_REYNOLDS`].
    ///
    /// ```
    /// use wisch::represent::Liquid;
    /// // 0.1 mm of water on glass at 30°: 1.6 cm/s.
    /// assert!((Liquid::WATER.speed(1e-4, 30_f64.to_radians()) - 0.01635).abs() < 1e-5);
    /// ```
    pub fn speed(&self, thickness: f64, angle: f64) -> f64 {
        let slope = self.on_slope(libm::sin(angle));
        let running = (thickness.min(slope.thickest) - self.adhering_thickness).max(0.0);
        slope.rate * running * running
    }

    /// Returns the thickness at which a film on a slope of an angle \[rad\] reaches [`MAX_REYNOLDS`] \[m\]; infinite on a
    /// level.
    pub fn largest_thickness(&self, angle: f64) -> f64 {
        self.on_slope(libm::sin(angle)).thickest
    }

    fn on_slope(&self, sine: f64) -> Slope {
        let rate = self.density * GRAVITY * sine.max(0.0) / (3.0 * self.viscosity);
        // Re = ρ u h/μ with u = c h².
        let cube = MAX_REYNOLDS * self.viscosity / (self.density * rate);
        Slope {
            rate,
            thickest: self.adhering_thickness + libm::cbrt(cube),
            adhering: self.adhering_thickness,
        }
    }
}

impl FilmFlow {
    /// Returns the flow of a film among the objects that occupy an area of the surface.
    pub const fn new(film: LiquidFilm, occupied: OccupiedArea) -> Self {
        Self { film, occupied }
    }

    /// Returns how far each of these places of particles runs down in a duration \[s\], as vectors \[m\]; none on a level or a
    /// curved surface.
    ///
    /// # Parameters
    /// - `places`: places of all particles that are on the surface, in any order \[m\].
    /// - `spacing`: mean distance of the particles, if they cover the surface \[m\].
    pub fn displacements(
        &self,
        places: &[Point2],
        surface: &Surface,
        spacing: f64,
        duration: f64,
    ) -> Vec<Vector2> {
        let mut moved = vec![Vector2::zeros(); places.len()];
        let gravity = surface.world_from_surface.rotation.inverse() * -Vector3::z();
        let sine = gravity.xy().norm();
        let is_running = surface.shape.is_plane() && gravity.z < UPRIGHT && duration > 0.0;
        let Some(down) = gravity.xy().try_normalize(1e-9).filter(|_| is_running) else {
            return moved;
        };
        let slope = self.film.liquid.on_slope(sine);
        // Columns of one width over the whole breadth of the surface, so that none is covered in part.
        let beside = surface.outline.outer().iter().map(|p| down.perp(&p.coords));
        let (low, high) = beside.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| {
            (low.min(at), high.max(at))
        });
        let count = ((high - low) / (COLUMN * spacing)).round().max(1.0);
        let width = (high - low) / count;
        let column = |place: &Point2| ((down.perp(&place.coords) - low) / width).floor() as i64;
        let mut sorted: Vec<(i64, f64, usize)> = (places.iter().enumerate())
            .map(|(index, place)| (column(place), down.dot(&place.coords), index))
            .collect();
        sorted.sort_unstable_by(|a, b| {
            (a.0.cmp(&b.0))
                .then(a.1.total_cmp(&b.1))
                .then(a.2.cmp(&b.2))
        });
        // Length over which the averaged particles usually lie [m].
        let usual = spacing * AVERAGED as f64 / COLUMN;
        // Volume of a particle over the width of its column [m²].
        let volume = self.film.particle_volume / width;
        for column in sorted.chunk_by(|a, b| a.0 == b.0) {
            let column: Vec<Along> = column.iter().map(|&(_, at, index)| (at, index)).collect();
            let waves: Vec<FilmWave> = (0..column.len())
                .map(|number| slope.find_wave(&column[..=number], volume, usual))
                .collect();
            let fastest = waves.iter().map(|wave| wave.speed).fold(0.0, f64::max);
            for (number, &(at, index)) in column.iter().enumerate() {
                let reach = fastest * duration;
                let way = slope.find_place(&column[..=number], &waves, reach, duration) - at;
                let way = self.keep_before_object(surface, places[index], down, way);
                moved[index] = down * way;
            }
        }
        moved
    }

    /// Lets the particles of a field run for a duration [s].
    pub(super) fn run(&self, field: &mut ParticleField, surface: &Surface, duration: f64) {
        let lying: Vec<(usize, Point2)> = (0..field.len())
            .map(|index| (index, field.place(index)))
            .filter(|(_, (_, fate))| fate.is_on_surface())
            .map(|(index, (place, _))| (index, place))
            .collect();
        let spacing = mean_distance(surface, field.len());
        let places: Vec<Point2> = lying.iter().map(|(_, place)| *place).collect();
        let moved = self.displacements(&places, surface, spacing, duration);
        for ((index, _), by) in lying.iter().zip(moved) {
            if by == Vector2::zeros() {
                continue;
            }
            let to = field.place(*index).0 + by;
            let fate = run_off(surface, to - by, to).unwrap_or(Fate::OnSurface);
            field.relocate(*index, to, fate);
        }
    }

    /// Returns the part of a straight way [m] before the first object on the surface.
    fn keep_before_object(&self, surface: &Surface, from: Point2, down: Vector2, way: f64) -> f64 {
        let on_surface = find_border(surface, from, down).map_or(way, |border| way.min(border));
        match find_stop(&self.occupied, from, down, on_surface) {
            Some(stop) => stop,
            None if self.occupied.contains(from + down * on_surface) => 0.0,
            None => way,
        }
    }
}

/// Returns the fate of a particle that runs over a border between two places of the chart \[m\];
/// `None` if it crosses no border.
///
/// Over an edge over which dirt may be skimmed, the particle leaves the surface. Over another edge
/// it falls ([`Fate::FALLEN`]), because no tool pushed it.
pub fn run_off(surface: &Surface, from: Point2, to: Point2) -> Option<Fate> {
    let edge = surface.exit_edge(from, to)?;
    Some(match u16::try_from(edge) {
        Ok(number) if surface.is_skim_edge(edge) => Fate::OffSurface { edge: number },
        _ => Fate::FALLEN,
    })
}

/// Returns the mean distance of a number of particles that cover a surface \[m\].
pub fn mean_distance(surface: &Surface, count: usize) -> f64 {
    (surface.outline.area() / count.max(1) as f64).sqrt()
}

impl Slope {
    /// Returns the film upstream of the last particle of a column. At the top of a film there are
    /// few particles; they are assumed to lie over the usual length.
    ///
    /// # Parameters
    /// - `volume`: volume of each particle, per width [m²].
    /// - `usual`: length over which the averaged particles usually lie [m].
    fn find_wave(&self, column: &[Along], volume: f64, usual: f64) -> FilmWave {
        let last = column.len() - 1;
        let first = last.saturating_sub(AVERAGED);
        let part = (last - first) as f64 * volume;
        let least = if last < AVERAGED { usual } else { 0.0 };
        let length = (column[last].0 - column[first].0).max(least);
        let thickness = if first < last { part / length } else { 0.0 };
        let speed = self.wave_speed(thickness);
        let running = (thickness.min(self.thickest) - self.adhering).max(0.0);
        FilmWave {
            part,
            thickness,
            speed,
            flow: speed * (self.adhering + 2.0 / 3.0 * running),
        }
    }

    /// Returns where the last particle of a column is after a duration [s], along the slope [m].
    ///
    /// # Parameters
    /// - `waves`: the film upstream of each particle.
    /// - `reach`: how far the fastest wave of the column runs in the duration [m].
    fn find_place(&self, column: &[Along], waves: &[FilmWave], reach: f64, duration: f64) -> f64 {
        let mut farthest = column.last().map_or(0.0, |(at, _)| *at);
        let mut upper = column.len() - 1;
        let mut between = 0.0;
        // y + t L⁻¹ is concave in y between two nodes.
        while upper > 0 && column[upper].0 + reach > farthest {
            let to = column[upper].0;
            let wave = &waves[upper];
            let passed = (duration * wave.flow).clamp(between, between + wave.part);
            let start = match wave.thickness.is_finite() {
                true => to - (passed - between) / wave.thickness,
                false => to,
            };
            farthest = farthest.max(start + duration * self.speed_of(passed / duration));
            between += wave.part;
            upper = upper.saturating_sub(AVERAGED);
        }
        farthest
    }

    /// Returns 3 c (h − a)², the speed at which a thickness moves [m/s].
    fn wave_speed(&self, thickness: f64) -> f64 {
        let running = (thickness.min(self.thickest) - self.adhering).max(0.0);
        3.0 * self.rate * running * running
    }

    /// Returns L⁻¹, the speed at which this volume per width and time passes [m/s].
    fn speed_of(&self, passing: f64) -> f64 {
        // With s = √v: a s² + k s³ = l.
        let cubic = 2.0 / (3.0 * (3.0 * self.rate).sqrt());
        let mut root = libm::cbrt(passing / cubic);
        for _ in 0..MAX_NEWTON {
            let value = root * root * (self.adhering + cubic * root) - passing;
            let slope = root * (2.0 * self.adhering + 3.0 * cubic * root);
            if slope <= 0.0 || value <= 1e-15 * passing {
                break;
            }
            root -= value / slope;
        }
        (root * root).min(self.wave_speed(f64::INFINITY))
    }
}

#[cfg(test)]
mod tests;
