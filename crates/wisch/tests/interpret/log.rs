//! Logs as a sponge would write them that strokes over a board: 10 N, 0.1 m/s, noise in force and position.

use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};
use wisch::geometry::{Point2, Point3, Pose, Vector2, Vector3};
use wisch::interpret::TouchSample;
use wisch::represent::{Action, Interaction, LogNormal, ParticleDistribution, Surface, Task};
use wisch_testkit::{interaction, sponge, surface};

pub const BOARD: [f64; 2] = [0.40, 0.28];
pub const PRESS: f64 = 10.0;
/// How far the sponge is compressed at nominal force [m].
pub const DEPTH: f64 = 0.005;
const SPEED: f64 = 0.1;
const APPROACH_SPEED: f64 = 0.05;
const LIFT: f64 = 0.05;
const FRICTION: f64 = 0.4;

/// A board that stands inclined somewhere in the world, so that no frame passes for another.
pub fn task(count: usize, likelihood: LogNormal) -> Task {
    let surface = Surface {
        world_from_surface: Pose::new(Vector3::new(0.6, -0.3, 0.8), Vector3::new(0.4, -0.2, 1.1)),
        skim_edges: vec![],
        ..surface(BOARD)
    };
    Task {
        name: "test".into(),
        action: Action::Absorb,
        scene: vec![],
        tool: sponge(),
        medium: "breadcrumbs".into(),
        interaction: Interaction {
            press_force_n: PRESS,
            compression_depth_m: DEPTH,
            gap_m: 0.0,
            likelihood,
            ..interaction()
        },
        particles: ParticleDistribution::new(&uniform(count)).unwrap(),
        collect_goal: None,
        treatment: None,
        mobility: Default::default(),
        tool_start: Point2::new(0.0, -0.3),
        seed: 7,
        surface,
    }
}

/// The values of the knowledge base for a sponge and breadcrumbs.
pub const STEEP: LogNormal = LogNormal {
    mu: -1.05,
    sigma: 0.25,
};

fn uniform(count: usize) -> Vec<Point2> {
    let mut random = ChaCha8Rng::seed_from_u64(3);
    (0..count)
        .map(|_| {
            let mut along = |side: f64| (random.random::<f64>() - 0.5) * side;
            Point2::new(along(BOARD[0]), along(BOARD[1]))
        })
        .collect()
}

/// A person's hand on the tool during an interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hand {
    pub start: f64,
    pub end: f64,
    /// Displacement of the tool by the hand, in the axes of the surface [m].
    pub off: Vector3,
    /// Force on the tool in place of that of wiping, in the axes of the surface [N].
    pub force: Vector3,
}

/// The parameters of a synthetic log.
#[derive(Debug, Clone)]
pub struct Script {
    /// Ends of straight strokes in the surface frame; each begins with an approach and ends with a
    /// lift, unless it continues from the end of the one before.
    pub strokes: Vec<[Point2; 2]>,
    /// Height of the real surface over the believed one, by place [m].
    pub surface: fn(Point2) -> f64,
    /// Normal force that is reached at a place [N].
    pub press: fn(Point2) -> f64,
    pub hands: Vec<Hand>,
    pub bias: f64,
    /// Coefficient of friction [1].
    pub friction: f64,
    pub force_noise: f64,
    pub position_noise: f64,
    pub rate: f64,
    /// Time constant of the estimate of the force [s].
    pub force_lag: f64,
    /// Frequency of stick-slip on the strokes [Hz].
    pub stick_slip: f64,
    /// Speed of the strokes [m/s].
    pub speed: f64,
    /// Intervals in which the robot stands still on its path [s].
    pub rests: Vec<[f64; 2]>,
}

impl Default for Script {
    fn default() -> Self {
        let line = |y: f64| [Point2::new(-0.16, y), Point2::new(0.16, y)];
        let back = |y: f64| [Point2::new(0.16, y), Point2::new(-0.16, y)];
        Self {
            strokes: vec![line(-0.085), back(0.0), line(0.085)],
            surface: |_| 0.0,
            press: |_| PRESS,
            hands: vec![],
            bias: 0.0,
            friction: FRICTION,
            force_noise: 0.5,
            position_noise: 1e-4,
            rate: 1000.0,
            force_lag: 0.0,
            stick_slip: 0.0,
            speed: SPEED,
            rests: vec![],
        }
    }
}

/// A segment of the path: from, to, speed; heights over nominal contact.
type Leg = (Point3, Point3, f64);

impl Script {
    fn legs(&self) -> Vec<Leg> {
        let at = |p: Point2, height: f64| Point3::new(p.x, p.y, height);
        let mut legs: Vec<Leg> = Vec::new();
        for (index, [from, to]) in self.strokes.iter().enumerate() {
            let next = self.strokes.get(index + 1);
            match legs.last() {
                Some((_, last, _)) if *last == at(*from, 0.0) => {}
                last => {
                    if let Some((_, last, _)) = last {
                        legs.push((*last, at(*from, LIFT), 2.0 * SPEED));
                    }
                    legs.push((at(*from, LIFT), at(*from, 0.0), APPROACH_SPEED));
                }
            }
            legs.push((at(*from, 0.0), at(*to, 0.0), self.speed));
            // A stroke that begins at the end of this one continues without a lift.
            if next.is_none_or(|[from, _]| from != to) {
                legs.push((at(*to, 0.0), at(*to, LIFT), APPROACH_SPEED));
            }
        }
        legs
    }

    /// Interval of full contact of each stroke [s].
    pub fn contacts(&self) -> Vec<[f64; 2]> {
        let mut time = 0.0;
        let mut contacts = Vec::new();
        for (from, to, speed) in self.legs() {
            let end = time + (to - from).norm() / speed;
            if from.z == 0.0 && to.z == 0.0 {
                contacts.push([time, end]);
            }
            time = end;
        }
        contacts
    }

    /// Returns the duration of motion, without rests, until a time [s].
    fn moved(&self, time: f64) -> f64 {
        let rested = |[start, end]: &[f64; 2]| (time.min(*end) - start).max(0.0);
        time - self.rests.iter().map(rested).sum::<f64>()
    }

    /// The log.
    pub fn samples(&self, task: &Task) -> Vec<TouchSample> {
        let mut random = ChaCha8Rng::seed_from_u64(11);
        // Sum of uniforms: near enough to normal.
        let mut noise = |size: f64| {
            Vector3::from_fn(|_, _| {
                ((0..6).map(|_| random.random::<f64>()).sum::<f64>() - 3.0) * size / 0.5_f64.sqrt()
            })
        };
        let mut samples = Vec::new();
        let mut begin = 0.0;
        let mut index = 0_u32;
        let mut lagging = Vector3::zeros();
        for (from, to, speed) in self.legs() {
            let way = to - from;
            let duration = way.norm() / speed;
            let moving = if way.xy().norm() > 0.0 {
                way.xy().normalize()
            } else {
                Vector2::zeros()
            };
            let wipes = from.z == 0.0 && to.z == 0.0;
            loop {
                let time = f64::from(index) / self.rate;
                let moved = self.moved(time);
                if moved > begin + duration {
                    break;
                }
                let mut along = (moved - begin) / duration;
                let mut friction = self.friction;
                if wipes && self.stick_slip > 0.0 {
                    let phase = std::f64::consts::TAU * self.stick_slip * (moved - begin);
                    along -= phase.sin() / (std::f64::consts::TAU * self.stick_slip * duration);
                    friction *= 1.0 + 0.3 * phase.cos();
                }
                let (place, force) = self.felt(time, from + way * along, moving * friction);
                lagging += (force - lagging) / (1.0 + self.force_lag * self.rate);
                let surface_from_tool = Pose::from(place + noise(self.position_noise));
                let measured = lagging + Vector3::z() * self.bias + noise(self.force_noise);
                samples.push(TouchSample {
                    time,
                    world_from_tool: task.surface.world_from_surface * surface_from_tool,
                    force: task.surface.world_from_surface.rotation * measured,
                });
                index += 1;
            }
            begin += duration;
        }
        samples
    }

    /// Returns the position of the tool centre point and the force on the tool at a time, in the
    /// frame of the believed surface.
    fn felt(&self, time: f64, nominal: Point3, friction: Vector2) -> (Point3, Vector3) {
        let place = nominal.xy();
        // A press below the nominal one leaves the sponge less compressed.
        let least = DEPTH * (1.0 - (self.press)(place) / PRESS);
        let height = nominal.z.max(least);
        let normal = PRESS * (1.0 - height / DEPTH).clamp(0.0, 1.0);
        let force = Vector3::new(-friction.x, -friction.y, 1.0) * normal;
        let center = Point3::new(place.x, place.y, (self.surface)(place) + height);
        let hand = self
            .hands
            .iter()
            .find(|hand| (hand.start..hand.end).contains(&time));
        match hand {
            // The displacement rises and falls within 20 ms.
            Some(hand) => {
                let ramp = ((time - hand.start).min(hand.end - time) / 0.02).min(1.0);
                (center + hand.off * ramp, hand.force)
            }
            None => (center, force),
        }
    }
}
