//! Ground truth of the simulated world. Neither planner nor interpreter reads it.

use crate::GrainCount;
use std::f64::consts::TAU;
use wisch::follow::Followed;
use wisch::geometry::{Point2, Pose, Vector2, Vector3};
use wisch::represent::{GrainSize, KnowledgeError, LogNormal, MediumKind, SensorModel};
use wisch_io::{DirtSource, FrictionChange, LoadedTask, Push, TrueDirt};

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
    /// Largest number of particles that are simulated as bodies; a task with more is executed without dirt.
    pub max_bodies: usize,
    /// Where the dirt lies at the start.
    pub dirt: TrueDirt,
    /// Number of grains, where their positions are drawn.
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

/// How the real tool differs from the believed one.
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
    pub(crate) fn has_ideal_encoders(&self) -> bool {
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
    /// Returns the height of the surface over its plane at `place` [m], and its slope along x and y [1].
    pub(crate) fn at(&self, place: Point2) -> (f64, Vector2) {
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
    /// How reliably and how precisely it detects grains.
    pub sensor: SensorModel,
    /// Whether the robot's links and the tool hide what lies under them.
    pub arm_hides: bool,
}

impl SimulationSettings {
    /// Returns the number of particles if it exceeds [`Self::max_bodies`], so that no dirt is simulated.
    pub fn count_over_limit(&self) -> Option<usize> {
        let count = match (&self.dirt, self.count) {
            (TrueDirt::Listed(places), _) => places.len(),
            (_, GrainCount::Exactly(count) | GrainCount::About(count)) => count,
        };
        (count > self.max_bodies).then_some(count)
    }

    /// Reads the world of a task file: its table `[execution]`, over the knowledge base's entries for surface and
    /// medium.
    ///
    /// Only this function reads the task's belief about the dirt: for the approximate number of grains, and, if the
    /// file asks for `as_believed`, for their positions.
    ///
    /// # Errors
    /// If the knowledge base does not know the task's surface or medium.
    pub fn from_task(loaded: &LoadedTask) -> Result<Self, KnowledgeError> {
        let (task, knowledge) = (&loaded.task, &loaded.knowledge);
        let record = loaded.file.execution();
        let medium = knowledge.medium(&task.medium)?;
        let likelihood = task.interaction.likelihood;
        let grain_size = record.grain_size.or(medium.grain_size).unwrap_or(DROPS);
        let believed = || task.particles.remaining().collect();
        Ok(Self {
            believed_from_real: record.believed_from_real,
            friction: match record.friction {
                Some(friction) => friction,
                None => knowledge.surface(&task.surface.name)?.friction,
            },
            friction_changes: record.friction_changes.clone(),
            pushes: record.pushes.clone(),
            force_noise: record.force_noise,
            force_bias: record.force_bias,
            likelihood: LogNormal {
                mu: record.mu.unwrap_or(likelihood.mu),
                sigma: record.sigma.unwrap_or(likelihood.sigma),
            },
            grain_size: GrainSize {
                min_m: grain_size.min_m.max(LEAST_GRAIN),
                max_m: grain_size.max_m.max(LEAST_GRAIN),
            },
            kind: if medium.grain_size.is_none() {
                MediumKind::Liquid
            } else {
                medium.kind
            },
            // Points of a treated surface need no bodies.
            max_bodies: if task.action.treats() {
                usize::MAX
            } else {
                record.max_bodies
            },
            dirt: match &record.dirt.source {
                // A treated surface has the points of the task.
                _ if task.action.treats() => TrueDirt::Listed(believed()),
                DirtSource::AsBelieved => TrueDirt::Listed(believed()),
                DirtSource::Stated(dirt) => dirt.clone(),
                DirtSource::Csv { .. } | DirtSource::Image { .. } => {
                    TrueDirt::Listed(loaded.true_dirt_locations.clone().unwrap_or_default())
                }
            },
            count: record
                .dirt
                .count
                .map_or(GrainCount::About(task.particles.len()), GrainCount::Exactly),
            grain_mass: record.grain_mass,
            grains_resist: record.grains_resist,
            tool: RealTool {
                stiffness: record.tool_stiffness,
                footprint: record.footprint,
                grasp_offset: record.grasp_offset,
                grasp_turn: record.grasp_turn,
            },
            sensing: Sensing {
                encoder_noise: record.encoder_noise,
                backlash: record.backlash,
                force_delay: record.force_delay,
                force_drift: record.force_drift,
            },
            joint_friction: record.joint_friction,
            waviness: Waviness {
                height: record.waviness,
                length: record.waviness_length,
            },
            camera: loaded.file.perception().sight.map(|believed| Camera {
                sensor: record.camera.complete(believed),
                arm_hides: record.camera.arm_hides,
            }),
        })
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
    /// Descriptions of the disturbances that the motion is too short for.
    pub missed: Vec<String>,
}
