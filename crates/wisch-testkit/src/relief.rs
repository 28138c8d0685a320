//! Logs of a perfect wipe over surfaces of known shape.

use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};
use wisch::geometry::{Point2, Point3, Pose, Vector2, Vector3};
use wisch::interpret::TouchSample;

/// Speeds of strokes, and of approach and lift [m/s].
const SPEEDS: [f64; 2] = [0.1, 0.05];
/// Height of free motion above the surface [m], and time of rest there before each approach [s].
const LIFT: f64 = 0.05;
const REST: f64 = 0.4;

/// The shape of a surface over the plane z = 0 of its believed frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Relief {
    /// The plane itself.
    Flat,
    /// A circular cylinder whose line through the origin lies in the plane.
    Cylinder {
        /// Curvature across the axis, positive where it bulges towards the tool \[1/m\].
        curvature: f64,
        /// Angle of the axis from x \[rad\].
        axis: f64,
    },
    /// A sphere about a point below the origin, or above it for a negative curvature.
    Sphere {
        /// Curvature \[1/m\].
        curvature: f64,
    },
    /// The saddle z = −½ c (u² − v²).
    Saddle {
        /// c \[1/m\].
        curvature: f64,
        /// Angle of u from x \[rad\].
        axis: f64,
    },
    /// Two half planes that fall away from a line.
    Crease {
        /// Distance of the line from the origin, along the direction in which the second half plane lies \[m\].
        distance: f64,
        /// Angle of that direction from x \[rad\].
        direction: f64,
        /// Slope of the second half plane \[1\], positive where it falls.
        fall: f64,
    },
    /// A cone whose line through the origin lies in the plane; its curvature there is `curvature`.
    Cone {
        /// Curvature at the origin \[1/m\].
        curvature: f64,
        /// Angle of that line from x \[rad\].
        axis: f64,
        /// Distance of the tip from the origin along the line \[m\].
        tip: f64,
    },
}

impl Relief {
    /// Height over a place \[m\].
    pub fn height(&self, place: Point2) -> f64 {
        let along = |angle: f64| Vector2::new(libm::cos(angle), libm::sin(angle));
        let arc = |square: f64, curvature: f64| {
            // R − √(R² − u²), without cancellation for large R.
            let rise = curvature * square;
            -rise / (1.0 + (1.0 - curvature * rise).max(0.0).sqrt())
        };
        match *self {
            Self::Flat => 0.0,
            Self::Cylinder { curvature, axis } => {
                let across = along(axis).perp(&place.coords);
                arc(across * across, curvature)
            }
            Self::Sphere { curvature } => arc(place.coords.norm_squared(), curvature),
            Self::Saddle { curvature, axis } => {
                let [u, v] = [
                    along(axis).dot(&place.coords),
                    along(axis).perp(&place.coords),
                ];
                -0.5 * curvature * (u * u - v * v)
            }
            Self::Crease {
                distance,
                direction,
                fall,
            } => -fall * (along(direction).dot(&place.coords) - distance).max(0.0),
            Self::Cone {
                curvature,
                axis,
                tip,
            } => {
                let [u, v] = [
                    along(axis).dot(&place.coords),
                    along(axis).perp(&place.coords),
                ];
                // The radius shrinks in proportion to the distance from the tip.
                arc(v * v, curvature * tip / (tip - u))
            }
        }
    }

    /// Outward unit normal over a place.
    pub fn normal(&self, place: Point2) -> Vector3 {
        const STEP: f64 = 1e-5;
        let slope = |x: f64, y: f64| {
            let step = Vector2::new(x, y) * STEP;
            (self.height(place + step) - self.height(place - step)) / (2.0 * STEP)
        };
        Vector3::new(-slope(1.0, 0.0), -slope(0.0, 1.0), 1.0).normalize()
    }
}

/// A wipe along straight strokes that keeps its force all the way.
#[derive(Debug, Clone)]
pub struct ReliefWipe {
    /// Shape of the surface.
    pub relief: Relief,
    /// Ends of the strokes in the believed surface frame \[m\].
    pub strokes: Vec<[Point2; 2]>,
    /// Whether the tool leans with the surface; it otherwise keeps the axes of the believed surface frame.
    pub leans: bool,
    /// Force along the real normal \[N\], and compression of the tool under it \[m\].
    pub press: [f64; 2],
    /// Friction over normal force \[1\].
    pub friction: f64,
    /// Standard deviation of force \[N\] and of position \[m\], by component.
    pub noise: [f64; 2],
    /// Sampling rate \[Hz\].
    pub rate: f64,
    /// The real surface in the believed surface frame.
    pub believed_from_real: Pose,
    /// Seed of the noise.
    pub seed: u64,
}

impl ReliefWipe {
    /// Returns the log; `world_from_surface` is the believed pose of the surface.
    pub fn samples(&self, world_from_surface: &Pose) -> Vec<TouchSample> {
        let mut random = ChaCha8Rng::seed_from_u64(self.seed);
        // A sum of six uniform numbers is nearly normal, with a variance of ½.
        let mut noise = |deviation: f64| {
            Vector3::from_fn(|_, _| {
                let sum: f64 = (0..6).map(|_| random.random::<f64>()).sum();
                (sum - 3.0) * deviation * std::f64::consts::SQRT_2
            })
        };
        let mut samples = Vec::new();
        for (from, to, duration) in self.legs() {
            let count = (duration * self.rate).round().max(1.0) as usize;
            for step in 0..count {
                let share = step as f64 / count as f64;
                let at = from + (to - from) * share;
                let moving = if at.z <= 0.0 {
                    (to - from).xy()
                } else {
                    Vector2::zeros()
                };
                let (place, turn, force) = self.touch(at, moving);
                let pose = Pose::from_parts((place + noise(self.noise[1])).into(), turn);
                let force = force + noise(self.noise[0]);
                samples.push(TouchSample {
                    time: samples.len() as f64 / self.rate,
                    world_from_tool: world_from_surface * self.believed_from_real * pose,
                    force: world_from_surface.rotation * (self.believed_from_real.rotation * force),
                });
            }
        }
        samples
    }

    /// Parts of the path: from, to and duration \[s\]; z is the height along the normal over nominal contact.
    fn legs(&self) -> Vec<(Point3, Point3, f64)> {
        let at = |place: Point2, height: f64| Point3::new(place.x, place.y, height);
        let mut legs: Vec<(Point3, Point3, f64)> = Vec::new();
        for &[from, to] in &self.strokes {
            let above = at(from, LIFT);
            if let Some(&(_, before, _)) = legs.last() {
                legs.push((before, above, (above - before).norm() / (2.0 * SPEEDS[0])));
            }
            legs.push((above, above, REST));
            legs.push((above, at(from, 0.0), LIFT / SPEEDS[1]));
            legs.push((at(from, 0.0), at(to, 0.0), (to - from).norm() / SPEEDS[0]));
            legs.push((at(to, 0.0), at(to, LIFT), LIFT / SPEEDS[1]));
        }
        legs
    }

    /// Returns position and orientation of the tool and the force on it, in the frame of the real surface.
    fn touch(
        &self,
        at: Point3,
        moving: Vector2,
    ) -> (Vector3, nalgebra::UnitQuaternion<f64>, Vector3) {
        let [press, depth] = self.press;
        let (place, normal) = (at.xy(), self.relief.normal(at.xy()));
        let upright = nalgebra::UnitQuaternion::identity();
        let turn =
            nalgebra::UnitQuaternion::rotation_between(&Vector3::z(), &normal).unwrap_or(upright);
        let size = press * (1.0 - at.z / depth.max(1e-4)).clamp(0.0, 1.0);
        let ahead = turn * Vector3::new(moving.x, moving.y, 0.0);
        let drag = ahead.try_normalize(0.0).unwrap_or_default() * (-self.friction * size);
        let foot = Vector3::new(place.x, place.y, self.relief.height(place));
        (
            foot + normal * at.z,
            if self.leans { turn } else { upright },
            normal * size + drag,
        )
    }
}
