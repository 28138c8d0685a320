//! Ground truth of the simulated world. Neither planner nor interpreter reads it.

use crate::{FrictionChange, Push};
use std::f64::consts::TAU;
use wisch::follow::Followed;
use wisch::geometry::{Point2, Pose, Vector2, Vector3};
use wisch::represent::{
    Cluster, DirtMobility, GrainSize, KnowledgeBase, KnowledgeError, LogNormal, MediumKind,
    ParticleDistribution, SensorModel, SurfaceShape, Task,
};

/// Diameters of the drops of a liquid on a surface that they wet [m].
const DROPS: GrainSize = GrainSize {
    min_m: 0.002,
    max_m: 0.004,
};
/// Smaller grains are simulated with this diameter [m]: at 1 kHz the engine does not resolve a contact of smaller
/// bodies.
const LEAST_GRAIN: f64 = 0.0008;

/// Settings of a simulated world: the real pose and friction of the surface, pushes, sensor errors, tool and dirt.
#[derive(Debug, Clone, PartialEq)]
pub struct SimulationSettings {
    /// Pose of the real surface in the frame of the believed one.
    pub believed_from_real: Pose,
    /// Shape of the real surface; `None` for the believed one.
    pub shape: Option<SurfaceShape>,
    /// Coulomb coefficient between tool and surface at the start \[1\].
    pub friction: f64,
    /// Changes of the friction, in any order.
    pub friction_changes: Vec<FrictionChange>,
    /// Pushes by a person, in any order.
    pub pushes: Vec<Push>,
    /// Standard deviation of the measured force, per axis \[N\].
    pub force_noise: f64,
    /// Constant bias of the measured force, in the axes of the world \[N\].
    pub force_bias: Vector3,
    /// Distribution of the normalised pressure above which the tool takes a grain along. Each grain draws its own
    /// threshold once.
    pub likelihood: LogNormal,
    /// Diameters of the grains \[m\].
    pub grain_size: GrainSize,
    /// Kind of the medium.
    pub kind: MediumKind,
    /// How the medium moves by its own weight.
    pub mobility: DirtMobility,
    /// Largest number of particles that are simulated as bodies; a task with more is executed without dirt.
    pub max_bodies: usize,
    /// Where the dirt lies at the start.
    pub dirt: TrueDirt,
    /// Number of grains, if their positions are drawn.
    pub count: GrainCount,
    /// Mass of the dirt that each grain stands for \[kg\]; `None` stands for the grain alone.
    pub grain_mass: Option<f64>,
    /// Whether grains that the tool pushes resist it.
    pub grains_resist: bool,
    /// The real tool, and its real pose in the hand.
    pub tool: RealTool,
    /// Errors of the joint and force sensors.
    pub sensing: Sensing,
    /// Coulomb friction in each joint that the controller drives [Nm or N].
    pub joint_friction: f64,
    /// Waves in the surface.
    pub waviness: Waviness,
    /// The camera; `None` for a world without one.
    pub camera: Option<Camera>,
}

/// Differences of the real tool from the believed one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RealTool {
    /// Real stiffness over the believed stiffness \[1\].
    pub stiffness: f64,
    /// Real length and width of the footprint over the believed ones \[1\].
    pub footprint: f64,
    /// Offset of the real tool in the hand, in the frame of the believed tool \[m\].
    pub grasp_offset: Vector2,
    /// Rotation of the real tool about its z \[rad\].
    pub grasp_turn: f64,
}

impl Default for RealTool {
    /// The real tool equals the believed one.
    fn default() -> Self {
        Self {
            stiffness: 1.0,
            footprint: 1.0,
            grasp_offset: Vector2::zeros(),
            grasp_turn: 0.0,
        }
    }
}

/// Errors of the joint and force sensors, beyond noise and bias of the force.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Sensing {
    /// Standard deviation of measured joint positions [rad or m].
    pub encoder_noise: f64,
    /// Play between a joint and its encoder [rad or m].
    pub backlash: f64,
    /// Delay of the measured force \[s\].
    pub force_delay: f64,
    /// Growth of the force bias during a round, in the axes of the world [N/s].
    pub force_drift: Vector3,
}

impl Sensing {
    /// Whether encoders measure the joints without error.
    pub fn has_ideal_encoders(&self) -> bool {
        self.encoder_noise == 0.0 && self.backlash == 0.0
    }
}

/// Waves in a surface: the sum of a sine along its x and a sine along its y.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Waviness {
    /// Height from the lowest valley to the highest crest \[m\].
    pub height: f64,
    /// Length of a wave \[m\].
    pub length: f64,
}

impl Default for Waviness {
    /// No waves: a plane.
    fn default() -> Self {
        Self {
            height: 0.0,
            length: 0.2,
        }
    }
}

impl Waviness {
    /// Returns the height of the surface over its plane at `place` \[m\], and its slope along x and y \[1\]. `place`: in
    /// the frame of the real surface \[m\].
    pub fn sample(&self, place: Point2) -> (f64, Vector2) {
        let number = TAU / self.length;
        let sines = place.coords.map(|x| libm::sin(number * x));
        let cosines = place.coords.map(|x| libm::cos(number * x));
        // Two sines of amplitude a swing between −2a and 2a, so that the total height is 4a.
        let amplitude = self.height / 4.0;
        (amplitude * sines.sum(), amplitude * number * cosines)
    }
}

/// A camera above the surface, along its normal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera {
    /// Detection rate and noise of the camera.
    pub sensor: SensorModel,
    /// Whether the robot's links and the tool hide the surface under them.
    pub arm_hides: bool,
}

/// Spatial distribution of the true dirt in a simulated world, in the frame of the true surface.
#[derive(Debug, Clone, PartialEq)]
pub enum TrueDirt {
    /// At these particles; the stated number of grains is ignored. Particles that earlier wiping has removed count in the
    /// performance.
    Listed(ParticleDistribution),
    /// Uniformly over the free surface.
    Uniform,
    /// In heaps; `None` draws 1 to 6 heaps, each with a standard deviation of 1 to 10 cm, anywhere on the surface.
    Clusters(Option<Vec<Cluster>>),
    /// In a band across the surface; a field that is `None` is drawn.
    Stripe {
        /// A point of the band's middle line \[m\].
        center: Option<Point2>,
        /// Direction of the band, about the surface's z from its x \[rad\].
        direction: Option<f64>,
        /// Width of the band \[m\].
        width: Option<f64>,
    },
    /// Along the outline, at most this far inside it \[m\].
    Edge(f64),
}

/// Number of grains in a world.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GrainCount {
    /// Exactly this number.
    Exactly(usize),
    /// This number times a random log-normal factor with a spread of 20 %.
    About(usize),
}

/// Enlarges diameters to those that the engine resolves.
fn simulated_sizes(diameters: GrainSize) -> GrainSize {
    GrainSize {
        min_m: diameters.min_m.max(LEAST_GRAIN),
        max_m: diameters.max_m.max(LEAST_GRAIN),
    }
}

impl SimulationSettings {
    /// Returns the number of particles if it exceeds [`Self::max_bodies`], so that no dirt is simulated.
    pub fn count_over_limit(&self) -> Option<usize> {
        let count = match (&self.dirt, self.count) {
            (TrueDirt::Listed(particles), _) => particles.remaining().count(),
            (_, GrainCount::Exactly(count) | GrainCount::About(count)) => count,
        };
        (count > self.max_bodies).then_some(count)
    }

    /// Standard deviation of the force that a good joint-torque sensor measures at the tool, per axis \[N\].
    pub const FORCE_NOISE: f64 = 0.15;
    /// Number of bodies with which the simulation still runs several times faster than real time.
    pub const MAX_BODIES: usize = 400;

    /// Returns the world that a robot believes in, except for the dirt, which lies uniformly over the surface.
    ///
    /// - `task`: of its belief about the dirt, only the approximate number of grains is used; an action that treats the
    ///   surface acts on the points of the task.
    /// - `knowledge`: the entries of the surface and the medium.
    /// - `camera`: the believed camera; `None` for a world without one.
    ///
    /// # Errors
    /// If the knowledge base does not know the task's surface or medium.
    pub fn as_believed(
        task: &Task,
        knowledge: &KnowledgeBase,
        camera: Option<SensorModel>,
    ) -> Result<Self, KnowledgeError> {
        let medium = knowledge.medium(&task.medium)?;
        // Points of a treated surface need no bodies.
        let (dirt, max_bodies) = if task.action.treats() {
            (TrueDirt::Listed(task.particles.clone()), usize::MAX)
        } else {
            (TrueDirt::Uniform, Self::MAX_BODIES)
        };
        Ok(Self {
            believed_from_real: Pose::identity(),
            shape: None,
            friction: knowledge.surface(&task.surface.name)?.friction,
            friction_changes: Vec::new(),
            pushes: Vec::new(),
            force_noise: Self::FORCE_NOISE,
            force_bias: Vector3::zeros(),
            likelihood: task.interaction.likelihood,
            grain_size: simulated_sizes(medium.grain_size.unwrap_or(DROPS)),
            kind: if medium.grain_size.is_none() {
                MediumKind::Liquid
            } else {
                medium.kind
            },
            mobility: task.mobility,
            max_bodies,
            dirt,
            count: GrainCount::About(task.particles.len()),
            grain_mass: None,
            grains_resist: true,
            tool: RealTool::default(),
            sensing: Sensing::default(),
            joint_friction: 0.0,
            waviness: Waviness::default(),
            camera: camera.map(|sensor| Camera {
                sensor,
                arm_hides: false,
            }),
        })
    }

    /// Returns these settings with grains of other diameters \[m\]; smaller grains than the engine resolves are enlarged.
    #[must_use]
    pub fn with_grain_size(self, diameters: GrainSize) -> Self {
        Self {
            grain_size: simulated_sizes(diameters),
            ..self
        }
    }

    /// Returns the pushes and changes of friction of a round, with their times in the motion `followed`.
    pub fn schedule(&self, round: usize, followed: &Followed) -> Schedule {
        let mut schedule = Schedule::default();
        for push in self.pushes.iter().filter(|push| push.round == round) {
            match push.start.time(followed) {
                Some(start) => schedule.pushes.push((start, *push)),
                None => schedule.missed.push(format!("a push at {}", push.start)),
            }
        }
        let changes = self.friction_changes.iter();
        for change in changes.filter(|change| change.round == round) {
            match change.start.time(followed) {
                Some(start) => schedule.friction_changes.push((start, change.friction)),
                None => {
                    let text = format!("a change of friction at {}", change.start);
                    schedule.missed.push(text);
                }
            }
        }
        (schedule.friction_changes).sort_by(|a, b| a.0.total_cmp(&b.0));
        schedule
    }
}

/// Pushes and changes of friction during one motion.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Schedule {
    /// Pushes, each with its start \[s\].
    pub pushes: Vec<(f64, Push)>,
    /// Changes of friction: start \[s\] and new coefficient \[1\], by time.
    pub friction_changes: Vec<(f64, f64)>,
    /// Descriptions of the disturbances that do not happen because the motion ends before them.
    pub missed: Vec<String>,
}
