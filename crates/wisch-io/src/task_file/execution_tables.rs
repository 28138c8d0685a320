//! The keys of the table `[execution]`: most set a [`SimulationSettings`], whose defaults they take; the last five set the
//! session.

use super::clusters::ClusterTable;
use super::deserialize::At;
use super::values::{
    AngleRad, Backlash, BiasN, Bodies, Channel, ColorDistance, DelayS, DriftN, DurationS,
    EncoderNoise, Factor, FalseAlarms, Friction, GrainM, GrainMassKg, GraspM, GraspRad,
    HalfAngleRad, HalfSizeM, HandSpeed, JointFriction, LogForce, LogSpread, Name, NoiseN,
    ParticleCount, Pixel, PositionErrorM, PositionM, PushForceN, RadiusM, Rounds, Share, ShiftM,
    SizeFactor, SizeM, StartRad, StrokeNumber, TiltRad, TimeS, WarningRate, WaveLengthM, WavinessM,
    names,
};
use schemars::JsonSchema;
use serde::Deserialize;
use wisch::run::{AfterStop, OnWarning, Pace, RunConfig};
use wisch_sim::{RealTool, Sensing, SimulationSettings, Waviness};

/// Ground truth of the simulation, hidden from planner and interpreter.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
#[schemars(rename = "Execution")]
pub(super) struct ExecutionTable {
    /// Tilt of the true surface relative to the believed surface, about its x and y [rad].
    pub(super) surface_tilt_rad: Option<[TiltRad; 2]>,
    /// Shift of the true surface in the frame of the believed surface [m].
    pub(super) surface_shift_m: Option<[ShiftM; 3]>,
    /// True radius of the surface as a cylinder or a cone [m], positive where it bulges towards the tool; default: as
    /// believed. It may differ from a believed plane.
    pub(super) surface_radius_m: Option<At<RadiusM>>,
    /// True half angle of the surface as a cone [rad]; default: as believed.
    pub(super) surface_half_angle_rad: Option<At<HalfAngleRad>>,
    /// True angle from x of the cylinder's axis, or of the direction in which the cone widens [rad]; default: as believed,
    /// or 0 on a believed plane.
    pub(super) surface_axis_rad: Option<At<AngleRad>>,
    /// Coulomb coefficient between tool and surface; default: from the knowledge base.
    pub(super) friction: Option<Friction>,
    /// Changes of the friction.
    pub(super) friction_change: Vec<At<FrictionChangeTable>>,
    /// People who push the tool.
    pub(super) push: Vec<At<PushTable>>,
    /// Standard deviation of the measured force, per axis [N].
    pub(super) force_noise_n: NoiseN,
    /// Constant bias of the measured force, world axes [N].
    pub(super) force_bias_n: Option<[BiasN; 3]>,
    /// Mean of ln X, where X is the ratio of the pressure that moves a grain to the nominal pressure; default: from the
    /// knowledge base.
    pub(super) mu: Option<LogForce>,
    /// Standard deviation of ln X; default: from the knowledge base.
    pub(super) sigma: Option<LogSpread>,
    /// True dirt locations, independent of the believed locations; default: uniform over the free surface.
    pub(super) dirt: Option<At<DirtTable>>,
    /// Smallest and largest diameter of the true grains [m]; default: the medium's.
    pub(super) grain_size_m: Option<At<[GrainM; 2]>>,
    /// Mass of the dirt that each simulated grain represents [kg]; default: the grain's own mass.
    pub(super) grain_mass_kg: Option<GrainMassKg>,
    /// Whether pushed dirt exerts a force on the tool.
    pub(super) grains_resist: bool,
    /// Ratio of the true to the believed stiffness of the tool.
    pub(super) tool_stiffness: Factor,
    /// Ratio of the true to the believed length and width of the tool's footprint.
    pub(super) footprint: SizeFactor,
    /// True offset of the tool in the hand, tool frame [m].
    pub(super) grasp_offset_m: Option<[GraspM; 2]>,
    /// True rotation of the tool in the hand about its z [rad].
    pub(super) grasp_turn_rad: GraspRad,
    /// Standard deviation of the measured joint positions [rad or m].
    pub(super) encoder_noise_rad: EncoderNoise,
    /// Backlash between joints and their encoders [rad or m].
    pub(super) backlash_rad: Backlash,
    /// Delay of the measured force [s].
    pub(super) force_delay_s: DelayS,
    /// Drift of the bias of the measured force within a round, world axes [N/s].
    pub(super) force_drift_n_per_s: Option<[DriftN; 3]>,
    /// Coulomb friction in each joint of the wiping arm [Nm or N].
    pub(super) joint_friction_nm: JointFriction,
    /// Height of the waves of the true surface, from trough to crest [m].
    pub(super) waviness_m: WavinessM,
    /// Length of these waves [m].
    pub(super) waviness_length_m: WaveLengthM,
    /// The true camera; default: as the robot believes.
    pub(super) camera: CameraTable,
    /// Maximum number of particles that are simulated as rigid bodies; with more particles, none are.
    pub(super) max_bodies: Bodies,
    /// Maximum number of rounds of wiping and estimating.
    pub(super) max_rounds: Rounds,
    /// Whether a contact loss or hand guiding ends a round within a stroke, so that the rest is planned anew.
    pub(super) end_strokes_early: bool,
    /// Extent of a round: the whole plan, or only the segment with the greatest predicted gain.
    pub(super) pace: PaceName,
    /// Reaction to a stop by a person or a safety system: wait for the operator, which ends the run, or retreat from the
    /// surface and resume.
    pub(super) after_stop: AfterStopName,
    /// Reaction to a stroke that differs from comparable episodes of the memory.
    pub(super) on_warning: OnWarningName,
    /// Largest share of the runs without a change that give a warning.
    pub(super) false_warning_rate: WarningRate,
    /// Maximum deviation of a joint from the start of a motion [rad, or m]; beyond it, the motion is not executed.
    pub(super) start_rad: StartRad,
}

names! {
    /// Reaction to a stroke that differs from comparable episodes of the memory.
    OnWarningName("on_warning", "snake_case") for OnWarning {
        Ignore,
        Report,
        EndStroke,
        Stop,
    }

    /// Reaction to a stop by a person or a safety system.
    AfterStopName("after_stop", "snake_case") for AfterStop {
        Wait,
        Retreat,
    }

    /// Extent of a round.
    PaceName("pace", "snake_case") for Pace {
        Whole,
        Greedy,
    }
}

impl Default for ExecutionTable {
    fn default() -> Self {
        let run = RunConfig::default();
        let (tool, sensing, waves) = (RealTool::default(), Sensing::default(), Waviness::default());
        Self {
            surface_tilt_rad: None,
            surface_shift_m: None,
            surface_radius_m: None,
            surface_half_angle_rad: None,
            surface_axis_rad: None,
            friction: None,
            friction_change: Vec::new(),
            push: Vec::new(),
            force_noise_n: NoiseN(SimulationSettings::FORCE_NOISE),
            force_bias_n: None,
            mu: None,
            sigma: None,
            dirt: None,
            grain_size_m: None,
            grain_mass_kg: None,
            grains_resist: true,
            tool_stiffness: Factor(tool.stiffness),
            footprint: SizeFactor(tool.footprint),
            grasp_offset_m: None,
            grasp_turn_rad: GraspRad(tool.grasp_turn),
            encoder_noise_rad: EncoderNoise(sensing.encoder_noise),
            backlash_rad: Backlash(sensing.backlash),
            force_delay_s: DelayS(sensing.force_delay),
            force_drift_n_per_s: None,
            joint_friction_nm: JointFriction(0.0),
            waviness_m: WavinessM(waves.height),
            waviness_length_m: WaveLengthM(waves.length),
            camera: CameraTable::default(),
            max_bodies: Bodies(SimulationSettings::MAX_BODIES as u64),
            max_rounds: Rounds(run.max_rounds as u64),
            end_strokes_early: run.end_strokes_early,
            pace: PaceName::Whole,
            after_stop: AfterStopName::Wait,
            on_warning: OnWarningName::Report,
            false_warning_rate: WarningRate(run.false_warning_rate),
            start_rad: StartRad(run.start_tolerance),
        }
    }
}

/// True dirt locations, by source. Without a count, the number of grains is the believed number times a random factor.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(rename = "source", rename_all = "snake_case", deny_unknown_fields)]
#[schemars(rename = "Dirt", tag = "source")]
pub(super) enum DirtTable {
    /// Exactly as believed.
    AsBelieved {},
    /// Uniform over the free surface.
    Uniform {
        /// Number of grains.
        count: Option<ParticleCount>,
    },
    /// Heaps.
    Clusters {
        /// Total number of grains.
        count: Option<ParticleCount>,
        /// The heaps; default: 1 to 6 heaps with a standard deviation of 1 to 10 cm, at random positions.
        clusters: Option<At<Vec<ClusterTable>>>,
    },
    /// A band across the surface.
    Stripe {
        /// Number of grains.
        count: Option<ParticleCount>,
        /// Point on its centre line, surface frame [m]; default: random.
        center_m: Option<[PositionM; 2]>,
        /// Direction, about the surface's z from its x [rad]; default: random.
        direction_rad: Option<AngleRad>,
        /// Width [m]; default: random in 0.02 to 0.1.
        width_m: Option<SizeM>,
    },
    /// Along the outline.
    Edge {
        /// Number of grains.
        count: Option<ParticleCount>,
        /// Maximum distance from the outline [m]; default 0.04.
        within_m: Option<SizeM>,
    },
    /// A list with the columns x,y in the frame of the true surface.
    Csv {
        /// Path relative to this file.
        file: At<Name>,
    },
    /// Detected in a mask or photo.
    Image {
        /// PNG or JPEG up to 64 megapixels, path relative to this file.
        file: At<Name>,
        /// Pixels of the corners of the surface's bounding box [px], in the order of `particles`.
        corners_px: [[Pixel; 2]; 4],
        /// Colour of the dirt: red, green, blue.
        color: [Channel; 3],
        /// Maximum Euclidean distance from that colour.
        tolerance: ColorDistance,
        /// Number of grains.
        count: ParticleCount,
    },
}

/// The true camera, where it differs from the robot's belief.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
#[schemars(rename = "Camera")]
pub(super) struct CameraTable {
    /// Probability that a large grain is detected.
    pub(super) detection: Option<Share>,
    /// Grain diameter at which the detection probability is halved [m].
    pub(super) half_size_m: Option<HalfSizeM>,
    /// False detections per area [1/m²].
    pub(super) false_alarms_per_m2: Option<FalseAlarms>,
    /// Standard deviation of a detected position, per axis [m].
    pub(super) position_error_m: Option<PositionErrorM>,
    /// Whether the robot's links and the tool hide dirt from the camera.
    pub(super) arm_hides: bool,
}

/// A change of the friction between tool and surface.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(
    rename = "FrictionChange",
    extend("oneOf" = [
        { "required": ["start_s"] }, { "required": ["start_share"] }, { "required": ["start_stroke"] }
    ])
)]
pub(super) struct FrictionChangeTable {
    /// Number of the round.
    #[serde(default = "first_round")]
    pub(super) round: Rounds,
    /// Start time, counted from the start of the motion [s]; excludes `start_share` and `start_stroke`.
    pub(super) start_s: Option<TimeS>,
    /// Share of the motion's duration at which it starts; excludes `start_s` and `start_stroke`.
    pub(super) start_share: Option<Share>,
    /// Stroke, counted from 1, at whose half time it starts; excludes `start_s` and `start_share`.
    pub(super) start_stroke: Option<StrokeNumber>,
    /// Coulomb coefficient after the change.
    pub(super) friction: Friction,
}

/// A push of the tool by a person's hand.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(
    rename = "Push",
    extend("oneOf" = [
        { "required": ["start_s"] }, { "required": ["start_share"] }, { "required": ["start_stroke"] }
    ])
)]
pub(super) struct PushTable {
    /// Number of the round.
    #[serde(default = "first_round")]
    pub(super) round: Rounds,
    /// Start time, counted from the start of the motion [s]; excludes `start_share` and `start_stroke`.
    pub(super) start_s: Option<TimeS>,
    /// Share of the motion's duration at which it starts; excludes `start_s` and `start_stroke`.
    pub(super) start_share: Option<Share>,
    /// Stroke, counted from 1, at whose half time it starts; excludes `start_s` and `start_share`.
    pub(super) start_stroke: Option<StrokeNumber>,
    /// Duration [s].
    pub(super) duration_s: DurationS,
    /// Force on a tool at rest, world axes [N].
    pub(super) force_n: [PushForceN; 3],
    /// Speed of the tool at which the hand's force vanishes [m/s].
    #[serde(default = "hand_speed")]
    pub(super) hand_speed_m_per_s: HandSpeed,
}

fn first_round() -> Rounds {
    Rounds(1)
}

/// Typical speed of a hand that guides a robot away.
fn hand_speed() -> HandSpeed {
    HandSpeed(0.1)
}
