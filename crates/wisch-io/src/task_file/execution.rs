//! The tables `[perception]` and `[execution]`: the robot's senses, and the ground truth of the simulation.

use super::clusters::heaps;
use super::deserialize::At;
use super::execution_tables::{CameraTable, DirtTable, ExecutionTable};
use super::tables::{PerceptionTable, SenseName};
use super::tree::Source;
use super::values::{Share, StrokeNumber, TimeS, point};
use super::{FrictionChange, Moment, Push, TaskError};
use crate::particles::MaskSource;
use nalgebra::{Translation3, UnitQuaternion};
use wisch::geometry::{Point2, Pose, Vector2, Vector3};
use wisch::represent::{Cluster, GrainSize, SensorModel};
use wisch::source_location::Place;

/// Default of `within_m`: maximum distance from the outline of dirt along it [m].
const WITHIN: f64 = 0.04;

/// The robot's senses: always touch, and sight with a camera.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Perception {
    /// Believed model of the camera; `None` for touch only.
    pub sight: Option<SensorModel>,
}

/// The table `[execution]`: ground truth of the simulation, which planner and interpreter do not know.
#[derive(Debug, Clone, PartialEq)]
pub struct ExecutionRecord {
    /// True pose of the surface in the frame of the believed surface.
    pub believed_from_real: Pose,
    /// Coulomb coefficient between tool and surface at the start \[1\]; `None` takes the knowledge base's.
    pub friction: Option<f64>,
    /// Changes of the friction, as typed.
    pub friction_changes: Vec<FrictionChange>,
    /// Pushes, as typed.
    pub pushes: Vec<Push>,
    /// Standard deviation of the measured force, per axis \[N\].
    pub force_noise: f64,
    /// Constant bias of the measured force, world axes \[N\].
    pub force_bias: Vector3,
    /// Mean of ln f′, the threshold above which a grain moves; `None` takes the knowledge base's.
    pub mu: Option<f64>,
    /// Standard deviation of ln f′; `None` takes the knowledge base's.
    pub sigma: Option<f64>,
    /// True dirt locations.
    pub dirt: DirtRecord,
    /// Diameters of the true grains; `None` takes the medium's.
    pub grain_size: Option<GrainSize>,
    /// Mass of the dirt that each grain represents \[kg\]; `None` takes the grain's own mass.
    pub grain_mass: Option<f64>,
    /// Whether pushed dirt exerts a force on the tool.
    pub grains_resist: bool,
    /// Ratio of the true to the believed stiffness of the tool \[1\].
    pub tool_stiffness: f64,
    /// Ratio of the true to the believed length and width of the footprint \[1\].
    pub footprint: f64,
    /// True offset of the tool in the hand, in the frame of the believed tool \[m\].
    pub grasp_offset: Vector2,
    /// True rotation of the tool in the hand about its z \[rad\].
    pub grasp_turn: f64,
    /// Standard deviation of the measured joint positions [rad or m].
    pub encoder_noise: f64,
    /// Backlash between joints and their encoders [rad or m].
    pub backlash: f64,
    /// Delay of the measured force \[s\].
    pub force_delay: f64,
    /// Drift of the bias of the measured force within a round, world axes [N/s].
    pub force_drift: Vector3,
    /// Coulomb friction in each joint of the wiping arm [Nm or N].
    pub joint_friction: f64,
    /// Height of the waves of the true surface, from trough to crest \[m\].
    pub waviness: f64,
    /// Length of these waves \[m\].
    pub waviness_length: f64,
    /// The true camera.
    pub camera: CameraRecord,
    /// Maximum number of particles that are simulated as rigid bodies.
    pub max_bodies: usize,
}

/// True locations and number of the grains of a simulated world.
#[derive(Debug, Clone, PartialEq)]
pub struct DirtRecord {
    /// Source of the locations.
    pub source: DirtSource,
    /// Number of grains; `None` draws a number near the believed one.
    pub count: Option<usize>,
}

/// Spatial distribution of the true dirt in a simulated world, in the frame of the true surface.
#[derive(Debug, Clone, PartialEq)]
pub enum TrueDirt {
    /// At these points \[m\]; the stated number of grains is ignored.
    Listed(Vec<Point2>),
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

/// Source of the true dirt in a task file, `execution.dirt`.
#[derive(Debug, Clone, PartialEq)]
pub enum DirtSource {
    /// The believed locations.
    AsBelieved,
    /// A distribution that the file states.
    Stated(TrueDirt),
    /// A list in a file.
    Csv {
        /// Location of its name in the task file.
        at: Place,
        /// Its path, relative to the task file.
        file: String,
    },
    /// Detected in a mask or photo.
    Image {
        /// Location of its name in the task file.
        at: Place,
        /// The image with its parameters.
        mask: MaskSource,
    },
}

impl Default for DirtRecord {
    /// Uniform, with a number near the believed one.
    fn default() -> Self {
        Self {
            source: DirtSource::Stated(TrueDirt::Uniform),
            count: None,
        }
    }
}

/// The true camera; `None` values are as the robot believes.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct CameraRecord {
    /// Probability that a large grain is detected \[1\].
    pub detection: Option<f64>,
    /// Grain diameter at which the detection probability is halved \[m\].
    pub half_size_m: Option<f64>,
    /// False detections per area [1/m²].
    pub false_alarms_per_m2: Option<f64>,
    /// Standard deviation of a detected position, along x and along y \[m\].
    pub position_error_m: Option<f64>,
    /// Whether the robot's links and the tool hide dirt from the camera.
    pub arm_hides: bool,
}

impl CameraRecord {
    /// Returns the true camera: these values, with missing ones from the believed camera.
    pub fn complete(&self, believed: SensorModel) -> SensorModel {
        SensorModel {
            detection: self.detection.unwrap_or(believed.detection),
            half_size_m: self.half_size_m.unwrap_or(believed.half_size_m),
            false_alarms_per_m2: (self.false_alarms_per_m2).unwrap_or(believed.false_alarms_per_m2),
            position_error_m: self.position_error_m.unwrap_or(believed.position_error_m),
        }
    }
}

impl From<&CameraTable> for CameraRecord {
    fn from(table: &CameraTable) -> Self {
        Self {
            detection: table.detection.map(|x| x.0),
            half_size_m: table.half_size_m.map(|x| x.0),
            false_alarms_per_m2: table.false_alarms_per_m2.map(|x| x.0),
            position_error_m: table.position_error_m.map(|x| x.0),
            arm_hides: table.arm_hides,
        }
    }
}

pub(super) fn perception(
    table: &PerceptionTable,
    source: &Source<'_>,
) -> Result<Perception, TaskError> {
    let Some(senses) = &table.senses else {
        return Ok(Perception::default());
    };
    let count = |sense| senses.value.iter().filter(|s| **s == sense).count();
    let problem = match (count(SenseName::Touch), count(SenseName::Sight)) {
        (1, 0) => return Ok(Perception::default()),
        (1, 1) => {
            let given = CameraRecord {
                detection: table.detection.map(|x| x.0),
                half_size_m: table.half_size_m.map(|x| x.0),
                false_alarms_per_m2: table.false_alarms_per_m2.map(|x| x.0),
                position_error_m: table.position_error_m.map(|x| x.0),
                arm_hides: false,
            };
            return Ok(Perception {
                sight: Some(given.complete(SensorModel::default())),
            });
        }
        (0, _) => "\"touch\" is missing; it is always one of the senses",
        _ => "a sense is given twice",
    };
    Err(senses.inconsistent(source, problem))
}

fn dirt(table: &At<DirtTable>, source: &Source<'_>) -> Result<DirtRecord, TaskError> {
    let (found, count) = match &table.value {
        DirtTable::AsBelieved {} => (DirtSource::AsBelieved, &None),
        DirtTable::Uniform { count } => (DirtSource::Stated(TrueDirt::Uniform), count),
        DirtTable::Clusters { count, clusters } => {
            let given = clusters.as_ref().map(|given| heaps(given, source));
            let heaps = TrueDirt::Clusters(given.transpose()?);
            (DirtSource::Stated(heaps), count)
        }
        DirtTable::Stripe {
            count,
            center_m,
            direction_rad,
            width_m,
        } => {
            let stripe = TrueDirt::Stripe {
                center: center_m.map(point),
                direction: direction_rad.map(|angle| angle.0),
                width: width_m.map(|width| width.0),
            };
            (DirtSource::Stated(stripe), count)
        }
        DirtTable::Edge { count, within_m } => {
            let within = within_m.map_or(WITHIN, |within| within.0);
            (DirtSource::Stated(TrueDirt::Edge(within)), count)
        }
        DirtTable::Csv { file } => {
            let at = file.place(source);
            let file = file.value.0.clone();
            (DirtSource::Csv { at, file }, &None)
        }
        DirtTable::Image {
            file,
            corners_px,
            color,
            tolerance,
            count,
        } => {
            let image = DirtSource::Image {
                at: file.place(source),
                mask: MaskSource {
                    file: file.value.0.clone(),
                    corners_px: corners_px.map(|corner| corner.map(|x| x.0).into()),
                    color: color.map(|channel| channel.0 as u8),
                    tolerance: tolerance.0,
                    count: count.0 as usize,
                },
            };
            (image, &None)
        }
    };
    Ok(DirtRecord {
        source: found,
        count: count.map(|count| count.0 as usize),
    })
}

pub(super) fn execution(
    table: &ExecutionTable,
    source: &Source<'_>,
) -> Result<ExecutionRecord, TaskError> {
    let mut record = ExecutionRecord::undisturbed(table);
    if let Some(dirt) = &table.dirt {
        record.dirt = self::dirt(dirt, source)?;
    }
    if let Some(size) = &table.grain_size_m {
        let [min_m, max_m] = size.value.map(|diameter| diameter.0);
        if min_m > max_m {
            let problem =
                format!("the smallest diameter, {min_m} m, exceeds the largest, {max_m} m");
            return Err(size.inconsistent(source, problem));
        }
        record.grain_size = Some(GrainSize { min_m, max_m });
    }
    for change in &table.friction_change {
        let given = &change.value;
        record.friction_changes.push(FrictionChange {
            round: given.round.0 as usize,
            start: moment(
                change,
                (given.start_s, given.start_share, given.start_stroke),
                source,
            )?,
            friction: given.friction.0,
        });
    }
    for push in &table.push {
        let given = &push.value;
        record.pushes.push(Push {
            round: given.round.0 as usize,
            start: moment(
                push,
                (given.start_s, given.start_share, given.start_stroke),
                source,
            )?,
            duration: given.duration_s.0,
            force: Vector3::from(given.force_n.map(|axis| axis.0)),
            hand_speed: given.hand_speed_m_per_s.0,
        });
    }
    Ok(record)
}

/// Reads the start of a disturbance, which a table states by exactly one key.
fn moment<T>(
    table: &At<T>,
    starts: (Option<TimeS>, Option<Share>, Option<StrokeNumber>),
    source: &Source<'_>,
) -> Result<Moment, TaskError> {
    Ok(match starts {
        (Some(time), None, None) => Moment::Seconds(time.0),
        (None, Some(share), None) => Moment::Share(share.0),
        (None, None, Some(stroke)) => Moment::Stroke(stroke.0 as usize),
        (time, share, stroke) => {
            let offset = |is_there: bool| is_there.then_some(table.offset);
            let keys = [
                ("start_s", offset(time.is_some())),
                ("start_share", offset(share.is_some())),
                ("start_stroke", offset(stroke.is_some())),
            ];
            return Err(match table.exactly_one(source, &keys) {
                Err(error) => error,
                Ok(()) => table.missing(source, "start_s"),
            });
        }
    })
}

impl ExecutionRecord {
    /// Reads a table without its pushes and friction changes.
    fn undisturbed(table: &ExecutionTable) -> Self {
        let tilt = table.surface_tilt_rad;
        let [about_x, about_y] = tilt.map_or([0.0; 2], |tilt| tilt.map(|angle| angle.0));
        let shift = table.surface_shift_m;
        let shift = shift.map_or([0.0; 3], |shift| shift.map(|axis| axis.0));
        let bias = table.force_bias_n;
        let bias = bias.map_or([0.0; 3], |bias| bias.map(|axis| axis.0));
        Self {
            believed_from_real: Pose::from_parts(
                Translation3::from(Vector3::from(shift)),
                UnitQuaternion::from_scaled_axis(Vector3::new(about_x, about_y, 0.0)),
            ),
            friction: table.friction.map(|friction| friction.0),
            friction_changes: Vec::new(),
            pushes: Vec::new(),
            force_noise: table.force_noise_n.0,
            force_bias: Vector3::from(bias),
            mu: table.mu.map(|mu| mu.0),
            sigma: table.sigma.map(|sigma| sigma.0),
            dirt: DirtRecord::default(),
            grain_size: None,
            grain_mass: table.grain_mass_kg.map(|mass| mass.0),
            grains_resist: table.grains_resist,
            tool_stiffness: table.tool_stiffness.0,
            footprint: table.footprint.0,
            grasp_offset: (table.grasp_offset_m)
                .map_or_else(Vector2::zeros, |offset| offset.map(|axis| axis.0).into()),
            grasp_turn: table.grasp_turn_rad.0,
            encoder_noise: table.encoder_noise_rad.0,
            backlash: table.backlash_rad.0,
            force_delay: table.force_delay_s.0,
            force_drift: (table.force_drift_n_per_s)
                .map_or_else(Vector3::zeros, |drift| drift.map(|axis| axis.0).into()),
            joint_friction: table.joint_friction_nm.0,
            waviness: table.waviness_m.0,
            waviness_length: table.waviness_length_m.0,
            camera: CameraRecord::from(&table.camera),
            max_bodies: table.max_bodies.0 as usize,
        }
    }
}

impl Default for ExecutionRecord {
    fn default() -> Self {
        Self::undisturbed(&ExecutionTable::default())
    }
}
