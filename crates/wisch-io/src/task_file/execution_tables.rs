//! The keys of the table `[execution]`.

use super::clusters::ClusterTable;
use super::deserialize::At;
use super::values::{
    AngleRad, Backlash, BiasN, Bodies, Channel, ColorDistance, DelayS, DriftN, DurationS,
    EncoderNoise, Factor, FalseAlarms, Friction, GrainM, GrainMassKg, GraspM, GraspRad, HalfSizeM,
    HandSpeed, JointFriction, LogForce, LogSpread, Name, NoiseN, ParticleCount, Pixel,
    PositionErrorM, PositionM, PushForceN, Rounds, Share, ShiftM, SizeFactor, SizeM, StartRad,
    StrokeNumber, TiltRad, TimeS, WaveLengthM, WavinessM,
};
use schemars::JsonSchema;
use serde::Deserialize;
use wisch::run::{AfterStop, Pace};

/// What a simulated execution takes for real, hidden from planner and interpreter.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
#[schemars(rename = "Execution")]
pub(super) struct ExecutionTable {
    /// Tilt of the real against the believed surface, about its x and y [rad].
    pub(super) surface_tilt_rad: Option<[TiltRad; 2]>,
    /// Shift of the real surface in the believed one's frame [m].
    pub(super) surface_shift_m: Option<[ShiftM; 3]>,
    /// Coulomb coefficient between tool and surface; default: from the knowledge base.
    pub(super) friction: Option<Friction>,
    /// Changes of it.
    pub(super) friction_change: Vec<At<FrictionChangeTable>>,
    /// People who push the tool.
    pub(super) push: Vec<At<PushTable>>,
    /// Standard deviation of the measured force, per axis [N].
    pub(super) force_noise_n: NoiseN,
    /// Constant bias of the measured force, world axes [N].
    pub(super) force_bias_n: Option<[BiasN; 3]>,
    /// Mean of ln f', the pressure over the nominal one from which on a grain is taken along; default: from the
    /// knowledge base.
    pub(super) mu: Option<LogForce>,
    /// Standard deviation of ln f'; default: from the knowledge base.
    pub(super) sigma: Option<LogSpread>,
    /// Where the dirt really lies, drawn apart from what is believed; default: evenly over the free surface.
    pub(super) dirt: Option<At<DirtTable>>,
    /// Smallest and largest diameter of the real grains [m]; default: the medium's.
    pub(super) grain_size_m: Option<At<[GrainM; 2]>>,
    /// Mass of the dirt that each grain stands for [kg]; default: that of the grain alone.
    pub(super) grain_mass_kg: Option<GrainMassKg>,
    /// Whether the tool feels what it pushes.
    pub(super) grains_resist: bool,
    /// Stiffness of the real tool over the believed one.
    pub(super) tool_stiffness: Factor,
    /// Length and width of the real tool's footprint over the believed one's.
    pub(super) footprint: SizeFactor,
    /// Where the tool really sits in the hand, tool frame [m].
    pub(super) grasp_offset_m: Option<[GraspM; 2]>,
    /// How far it is really turned about its z [rad].
    pub(super) grasp_turn_rad: GraspRad,
    /// Standard deviation of the measured joint positions [rad or m].
    pub(super) encoder_noise_rad: EncoderNoise,
    /// Play between joints and what measures them [rad or m].
    pub(super) backlash_rad: Backlash,
    /// How late a force is measured [s].
    pub(super) force_delay_s: DelayS,
    /// How fast the bias of the measured force grows in a round, world axes [N/s].
    pub(super) force_drift_n_per_s: Option<[DriftN; 3]>,
    /// Coulomb friction in each joint that wipes [Nm or N].
    pub(super) joint_friction_nm: JointFriction,
    /// Height of the waves in the real surface, from valley to crest [m].
    pub(super) waviness_m: WavinessM,
    /// Length of these waves [m].
    pub(super) waviness_length_m: WaveLengthM,
    /// How the real camera sees; default: as the robot believes.
    pub(super) camera: CameraTable,
    /// Particles simulated as bodies, none if there are more.
    pub(super) max_bodies: Bodies,
    /// Most rounds of wiping and estimating.
    pub(super) max_rounds: Rounds,
    /// Whether a round ends amid a stroke once contact is lost or the tool is led away, and the rest is planned anew.
    pub(super) end_strokes_early: bool,
    /// How far a round goes before its outcome is looked at: a whole plan, or the segment that is predicted to gain most.
    pub(super) pace: PaceName,
    /// What follows where a person or a safety system stopped the robot: it waits for its operator, which ends the run, or
    /// it retreats from the surface by itself and goes on.
    pub(super) after_stop: AfterStopName,
    /// How far any joint may stand from where a motion begins [rad, or m]; beyond, the motion is not executed.
    pub(super) start_rad: StartRad,
}

/// What follows where a person or a safety system stopped the robot.
#[derive(Deserialize, JsonSchema, Clone, Copy)]
#[serde(rename = "after_stop", rename_all = "snake_case")]
#[schemars(rename = "AfterStop", inline)]
pub(super) enum AfterStopName {
    Wait,
    Retreat,
}

impl From<AfterStopName> for AfterStop {
    fn from(name: AfterStopName) -> Self {
        match name {
            AfterStopName::Wait => Self::Wait,
            AfterStopName::Retreat => Self::Retreat,
        }
    }
}

/// How far a round goes.
#[derive(Deserialize, JsonSchema, Clone, Copy)]
#[serde(rename = "pace", rename_all = "snake_case")]
#[schemars(rename = "Pace", inline)]
pub(super) enum PaceName {
    Whole,
    Greedy,
}

impl From<PaceName> for Pace {
    fn from(name: PaceName) -> Self {
        match name {
            PaceName::Whole => Self::Whole,
            PaceName::Greedy => Self::Greedy,
        }
    }
}

impl Default for ExecutionTable {
    fn default() -> Self {
        Self {
            surface_tilt_rad: None,
            surface_shift_m: None,
            friction: None,
            friction_change: Vec::new(),
            push: Vec::new(),
            // A good joint-torque sensor at the tool.
            force_noise_n: NoiseN(0.15),
            force_bias_n: None,
            mu: None,
            sigma: None,
            dirt: None,
            grain_size_m: None,
            grain_mass_kg: None,
            grains_resist: true,
            tool_stiffness: Factor(1.0),
            footprint: SizeFactor(1.0),
            grasp_offset_m: None,
            grasp_turn_rad: GraspRad(0.0),
            encoder_noise_rad: EncoderNoise(0.0),
            backlash_rad: Backlash(0.0),
            force_delay_s: DelayS(0.0),
            force_drift_n_per_s: None,
            joint_friction_nm: JointFriction(0.0),
            waviness_m: WavinessM(0.0),
            // About the width of a tool.
            waviness_length_m: WaveLengthM(0.2),
            camera: CameraTable::default(),
            // As many grains as are simulated at several times real time.
            max_bodies: Bodies(400),
            max_rounds: Rounds(4),
            end_strokes_early: false,
            pace: PaceName::Whole,
            after_stop: AfterStopName::Wait,
            start_rad: StartRad(0.05),
        }
    }
}

/// Where the dirt really lies, by its source. Without a count there is as much as believed, but for a factor.
#[derive(Deserialize, JsonSchema)]
#[serde(rename = "source", rename_all = "snake_case", deny_unknown_fields)]
#[schemars(rename = "Dirt", tag = "source")]
pub(super) enum DirtTable {
    /// Where it is believed to be, to the last grain.
    AsBelieved {},
    /// Evenly over the free surface.
    Uniform {
        /// How many grains.
        count: Option<ParticleCount>,
    },
    /// Heaps.
    Clusters {
        /// How many grains in all.
        count: Option<ParticleCount>,
        /// The heaps; default: 1 to 6 with a spread of 1 to 10 cm, anywhere.
        clusters: Option<At<Vec<ClusterTable>>>,
    },
    /// A band across the surface.
    Stripe {
        /// How many grains.
        count: Option<ParticleCount>,
        /// A point of its middle line, surface frame [m]; default: anywhere.
        center_m: Option<[PositionM; 2]>,
        /// Which way it runs, about the surface's z from its x [rad]; default: any.
        direction_rad: Option<AngleRad>,
        /// Its width [m]; default: 0.02 to 0.1.
        width_m: Option<SizeM>,
    },
    /// Along the outline.
    Edge {
        /// How many grains.
        count: Option<ParticleCount>,
        /// How far inside the outline at most [m]; default 0.04.
        within_m: Option<SizeM>,
    },
    /// Listed: columns x,y in the frame of the real surface.
    Csv {
        /// Path relative to this file.
        file: At<Name>,
    },
    /// Seen in a mask or photo.
    Image {
        /// Path relative to this file, of a PNG or JPEG up to 64 megapixels.
        file: At<Name>,
        /// Where the corners of the surface's bounding box are seen [px], as of `particles`.
        corners_px: [[Pixel; 2]; 4],
        /// Of the dirt: red, green, blue.
        color: [Channel; 3],
        /// Greatest Euclidean distance from that colour.
        tolerance: ColorDistance,
        /// How many grains.
        count: ParticleCount,
    },
}

/// How the real camera sees, where that is other than the robot believes.
#[derive(Deserialize, JsonSchema, Default)]
#[serde(deny_unknown_fields, default)]
#[schemars(rename = "Camera")]
pub(super) struct CameraTable {
    /// Probability that a large grain is detected.
    pub(super) detection: Option<Share>,
    /// Diameter at which this probability is halved [m].
    pub(super) half_size_m: Option<HalfSizeM>,
    /// Detections where nothing lies, per area [1/m²].
    pub(super) false_alarms_per_m2: Option<FalseAlarms>,
    /// Standard deviation of where a grain is seen, per axis [m].
    pub(super) position_error_m: Option<PositionErrorM>,
    /// Whether the robot's links and the tool hide what lies under them.
    pub(super) arm_hides: bool,
}

/// The friction between tool and surface from some time on.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(
    rename = "FrictionChange",
    extend("oneOf" = [
        { "required": ["start_s"] }, { "required": ["start_share"] }, { "required": ["start_stroke"] }
    ])
)]
pub(super) struct FrictionChangeTable {
    /// In which round.
    #[serde(default = "first_round")]
    pub(super) round: Rounds,
    /// When it begins, counted from the start of the motion [s]; excludes `start_share` and `start_stroke`.
    pub(super) start_s: Option<TimeS>,
    /// The share of the motion after which it begins; excludes the others.
    pub(super) start_share: Option<Share>,
    /// The stroke, counted from 1, amid which it begins; excludes the others.
    pub(super) start_stroke: Option<StrokeNumber>,
    /// Coulomb coefficient.
    pub(super) friction: Friction,
}

/// A hand that pushes the tool.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(
    rename = "Push",
    extend("oneOf" = [
        { "required": ["start_s"] }, { "required": ["start_share"] }, { "required": ["start_stroke"] }
    ])
)]
pub(super) struct PushTable {
    /// In which round.
    #[serde(default = "first_round")]
    pub(super) round: Rounds,
    /// When it begins, counted from the start of the motion [s]; excludes `start_share` and `start_stroke`.
    pub(super) start_s: Option<TimeS>,
    /// The share of the motion after which it begins; excludes the others.
    pub(super) start_share: Option<Share>,
    /// The stroke, counted from 1, amid which it begins; excludes the others.
    pub(super) start_stroke: Option<StrokeNumber>,
    /// How long it lasts [s].
    pub(super) duration_s: DurationS,
    /// Force on a tool at rest, world axes [N].
    pub(super) force_n: [PushForceN; 3],
    /// Speed at which the hand no longer pushes [m/s].
    #[serde(default = "hand_speed")]
    pub(super) hand_speed_m_per_s: HandSpeed,
}

fn first_round() -> Rounds {
    Rounds(1)
}

/// Of a hand that leads a robot away.
fn hand_speed() -> HandSpeed {
    HandSpeed(0.1)
}
