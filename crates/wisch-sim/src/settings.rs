//! How the simulated world really is, which neither the plan nor the interpretation is told.

use crate::{GrainCount, Places};
use std::f64::consts::TAU;
use wisch::follow::Followed;
use wisch::geometry::{Point2, Pose, Vector2, Vector3};
use wisch::represent::{GrainSize, KnowledgeError, LogNormal, MediumKind, SensorModel};
use wisch_io::{FrictionChange, LoadedTask, Push, RealDirt};

/// Drops of a liquid on a surface that they wet [m].
const DROPS: GrainSize = GrainSize {
    min_m: 0.002,
    max_m: 0.004,
};
/// Smaller grains are simulated as ones of this diameter [m]: a contact of two smaller bodies is not
/// resolved at 1 kHz.
const LEAST_GRAIN: f64 = 0.0008;

/// The world as it is: where the surface really is, how rough it is, who pushes, how bad the sensors
/// are, and how hard the dirt is to wipe.
#[derive(Debug, Clone, PartialEq)]
pub struct SimulationSettings {
    /// Where the surface really is, in the frame of the believed one.
    pub believed_from_real: Pose,
    /// Coulomb coefficient between tool and surface at the start [1].
    pub friction: f64,
    /// Changes of it, in any order.
    pub friction_changes: Vec<FrictionChange>,
    /// Who pushes, in any order.
    pub pushes: Vec<Push>,
    /// Standard deviation of the measured force, per axis [N].
    pub force_noise: f64,
    /// What is always added to the measured force, in the axes of the world [N].
    pub force_bias: Vector3,
    /// Distribution of the normalised pressure from which on a grain is taken along. Each grain has its
    /// own, for good.
    pub likelihood: LogNormal,
    /// Diameters of the grains.
    pub grain_size: GrainSize,
    /// The nature of the medium.
    pub kind: MediumKind,
    /// Up to how many particles are real bodies; a task with more is executed without dirt.
    pub max_bodies: usize,
    /// Where the dirt lies at the start.
    pub dirt: Places,
    /// How much of it there is, where places are drawn.
    pub count: GrainCount,
    /// Mass of the dirt that each grain stands for [kg]; `None` is that of the grain alone.
    pub grain_mass: Option<f64>,
    /// Whether the tool feels what it pushes.
    pub grains_resist: bool,
    /// The tool, and how it sits in the hand.
    pub tool: RealTool,
    /// How joints and forces are measured.
    pub sensing: Sensing,
    /// Coulomb friction in each joint that wipes [Nm or N].
    pub joint_friction: f64,
    /// Waves in the surface.
    pub waviness: Waviness,
    /// The camera; `None` is a world in which nothing can look.
    pub camera: Option<Camera>,
}

/// How the real tool differs from the believed one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RealTool {
    /// Its stiffness over the believed one [1].
    pub stiffness: f64,
    /// Length and width of its footprint over the believed ones [1].
    pub footprint: f64,
    /// Where it sits in the hand, in the frame of the tool as believed [m].
    pub grasp_offset: Vector2,
    /// How far it is turned about its z [rad].
    pub grasp_turn: f64,
}

impl Default for RealTool {
    /// As believed.
    fn default() -> Self {
        Self {
            stiffness: 1.0,
            footprint: 1.0,
            grasp_offset: Vector2::zeros(),
            grasp_turn: 0.0,
        }
    }
}

/// How what is measured differs from what is, beyond noise and bias of the force.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Sensing {
    /// Standard deviation of joint positions [rad or m].
    pub encoder_noise: f64,
    /// Play between joints and what measures them [rad or m].
    pub backlash: f64,
    /// How late a force is measured [s].
    pub force_delay: f64,
    /// How fast the bias of the force grows in a round, in the axes of the world [N/s].
    pub force_drift: Vector3,
}

impl Sensing {
    /// Whether joints are measured as they are.
    pub(crate) fn sees_joints(&self) -> bool {
        self.encoder_noise == 0.0 && self.backlash == 0.0
    }
}

/// Waves in a surface: the sum of two sines, along its x and along its y.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Waviness {
    /// Height from the lowest valley to the highest crest [m].
    pub height: f64,
    /// Length of a wave [m].
    pub length: f64,
}

impl Default for Waviness {
    /// A plane.
    fn default() -> Self {
        Self {
            height: 0.0,
            length: 0.2,
        }
    }
}

impl Waviness {
    /// Height of the surface over its plane at a place [m], and its slope along x and y [1].
    pub(crate) fn at(&self, place: Point2) -> (f64, Vector2) {
        let number = TAU / self.length;
        let sines = place.coords.map(|x| libm::sin(number * x));
        let cosines = place.coords.map(|x| libm::cos(number * x));
        // Each sine swings by half of the height.
        let amplitude = self.height / 4.0;
        (amplitude * sines.sum(), amplitude * number * cosines)
    }
}

/// A camera above the surface, along its normal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera {
    /// How well it sees.
    pub sensor: SensorModel,
    /// Whether the robot's links and the tool hide what lies under them.
    pub arm_hides: bool,
}

impl SimulationSettings {
    /// The world of a task file: what its table `[execution]` says, over what the knowledge base says of surface and
    /// medium. This alone looks at the task's belief about the dirt: for how much there is about, and, if the file asks
    /// for `as_believed`, for where it lies.
    ///
    /// # Errors
    /// If surface or medium of the task are unknown.
    pub fn of(loaded: &LoadedTask) -> Result<Self, KnowledgeError> {
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
            // Places of a surface are no bodies.
            max_bodies: if task.action.treats() {
                usize::MAX
            } else {
                record.max_bodies
            },
            dirt: match &record.dirt.source {
                // The surface has the places that it has.
                _ if task.action.treats() => Places::Listed(believed()),
                RealDirt::AsBelieved => Places::Listed(believed()),
                RealDirt::Uniform => Places::Uniform,
                RealDirt::Clusters(heaps) => Places::Clusters(heaps.clone()),
                RealDirt::Stripe {
                    center,
                    direction,
                    width,
                } => Places::Stripe {
                    center: *center,
                    direction: *direction,
                    width: *width,
                },
                RealDirt::Edge(within) => Places::Edge(*within),
                RealDirt::Csv { .. } | RealDirt::Image { .. } => {
                    Places::Listed(loaded.real_places.clone().unwrap_or_default())
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
                sensor: record.camera.over(believed),
                arm_hides: record.camera.arm_hides,
            }),
        })
    }

    /// What disturbs a round's motion, and when.
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

/// What disturbs one motion.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Schedule {
    /// Pushes, each with its start [s].
    pub pushes: Vec<(f64, Push)>,
    /// From when on [s] which coefficient of friction [1], by time.
    pub friction_changes: Vec<(f64, f64)>,
    /// In words, what never happens because the motion ends before.
    pub missed: Vec<String>,
}
