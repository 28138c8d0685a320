//! The keys of a task file. What is written here is at once the reader and the schema.

use super::clusters::ClusterTable;
use super::deserialize::At;
use super::execution_tables::ExecutionTable;
use super::values::{
    AngleRad, BandwidthM, Channel, ColorDistance, ContactSpeed, DampingRatio, DepthM, DistanceM,
    Evaluations, FalseAlarms, FootprintM, Friction, GrainM, HalfSizeM, LawSpread, LiftHeightM,
    LogForce, LogSpread, MarginM, Name, ParticleCount, Passes, Pixel, PositionErrorM, PositionM,
    PostureWeight, PressForceN, PrestonPerPa, QuaternionPart, RedrawLengthM, Scale, SchemaVersion,
    Score, Seed, Share, SizeM, Stiffness, ThicknessM, Variants, VolumePerMetre,
};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{EnumAccess, Error as _, VariantAccess, Visitor};
use serde::{Deserialize, Deserializer};
use std::borrow::Cow;
use std::fmt;
use wisch::plan::HeadingRule;
use wisch::represent::{Action, MediumKind, ScenePart};
use wisch::run::MIN_SCORE;

/// A task: what is to be wiped, where, with what, and to what end. Lengths in metres, angles in radians.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(
    title = "Task of wisch",
    extend("oneOf" = [{ "required": ["action"] }, { "required": ["goal"] }])
)]
pub(super) struct TaskTable {
    /// Version of this file format.
    #[serde(rename = "schema")]
    pub(super) _schema: SchemaVersion,
    /// Name of the task, of its output folder and report.
    pub(super) name: Name,
    /// Seed of everything random.
    #[serde(default = "seed")]
    pub(super) seed: Seed,
    /// What to do; excludes `goal`.
    pub(super) action: Option<At<ActionName>>,
    /// A PDDL literal such as (collected breadcrumbs chopping_board), which finds action and tool; excludes `action`.
    pub(super) goal: Option<At<Name>>,
    /// Coverage strategy that places the waypoints.
    pub(super) strategy: Option<Name>,
    /// Share of the particles at which the task counts as done.
    #[serde(default = "target_performance")]
    pub(super) target_performance: Share,
    /// What it is done with.
    pub(super) tool: Option<At<ToolTable>>,
    /// What it is done to.
    pub(super) medium: Option<At<MediumTable>>,
    /// Where it is done.
    pub(super) surface: At<SurfaceTable>,
    /// How the tool is used on the medium here; what is left out is taken from the knowledge base, or, where that does
    /// not know the three together, from defaults that are told.
    pub(super) interaction: Option<At<InteractionTable>>,
    /// Who does it; without one the plan is predicted but not followed.
    pub(super) robot: Option<At<RobotTable>>,
    /// What the robot perceives the dirt by.
    #[serde(default)]
    pub(super) perception: PerceptionTable,
    /// What a simulated execution takes for real, hidden from planner and interpreter.
    #[serde(default)]
    pub(super) execution: ExecutionTable,
    /// Of the action collect.
    pub(super) collect: Option<CollectTable>,
    /// Of the action polish.
    pub(super) polish: Option<PolishTable>,
    /// Of the action emit.
    pub(super) emit: Option<EmitTable>,
    /// What stands round the surface.
    #[serde(default)]
    pub(super) scene: Vec<At<ObjectTable>>,
    /// Where the dirt is believed to be.
    pub(super) particles: At<ParticlesTable>,
    /// How to plan.
    #[serde(default)]
    pub(super) plan: PlanTable,
}

/// What to do with the dirt.
#[derive(Deserialize, JsonSchema, Clone, Copy)]
#[serde(rename = "action", rename_all = "lowercase")]
#[schemars(rename = "Action", inline)]
pub(super) enum ActionName {
    /// Take it up with the tool.
    Absorb,
    /// Push it together.
    Collect,
    /// Push it over an edge.
    Skim,
    /// Go over all of the surface so many times.
    Polish,
    /// Leave the medium on the surface, so thick everywhere.
    Emit,
}

impl From<ActionName> for Action {
    fn from(action: ActionName) -> Self {
        match action {
            ActionName::Absorb => Self::Absorb,
            ActionName::Collect => Self::Collect,
            ActionName::Skim => Self::Skim,
            ActionName::Polish => Self::Polish,
            ActionName::Emit => Self::Emit,
        }
    }
}

/// The tool.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Tool")]
pub(super) struct ToolTable {
    /// In the knowledge base; needed with `action`. With `goal`: already in hand.
    pub(super) name: Option<At<Name>>,
    /// Where it starts, surface frame [m]; default: the middle of the outline's side with the smallest y.
    pub(super) start_m: Option<[PositionM; 2]>,
    /// For `goal`: what the hand holds; default: `name`.
    pub(super) in_hand: Option<Name>,
    /// For `goal`: what can be fetched.
    pub(super) available: Option<Vec<Name>>,
    /// Sides of a rectangular pad along and across the motion [m]: defines a tool of this task; excludes `mesh`.
    pub(super) footprint_m: Option<At<[FootprintM; 2]>>,
    /// STL, OBJ or DAE in the tool frame, path relative to this file: defines a tool of this task; excludes
    /// `footprint_m`.
    pub(super) mesh: Option<At<Name>>,
    /// How deep a tool of this task gives way under nominal force [m]; 0 is rigid; default 0.005.
    pub(super) compression_depth_m: Option<At<DepthM>>,
}

/// The dirt.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Medium")]
pub(super) struct MediumTable {
    /// In the knowledge base, or a new one with `kind`; needed with `action`.
    pub(super) name: Option<At<Name>>,
    /// Defines a medium of this task.
    pub(super) kind: Option<At<MediumKindName>>,
    /// Smallest and largest diameter of its grains [m]; not for liquids; default: 0.0005 to 0.002.
    pub(super) grain_size_m: Option<At<[GrainM; 2]>>,
}

/// Whether a medium comes in pieces, as powder or as a liquid.
#[derive(Deserialize, JsonSchema, Clone, Copy, PartialEq, Eq)]
#[serde(rename = "kind", rename_all = "lowercase")]
#[schemars(rename = "MediumKind", inline)]
pub(super) enum MediumKindName {
    Solid,
    Liquid,
    Powder,
}

impl From<MediumKindName> for MediumKind {
    fn from(kind: MediumKindName) -> Self {
        match kind {
            MediumKindName::Solid => Self::Solid,
            MediumKindName::Liquid => Self::Liquid,
            MediumKindName::Powder => Self::Powder,
        }
    }
}

/// How the tool is used on the medium on this surface.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Interaction")]
pub(super) struct InteractionTable {
    /// What makes sense with the three; default: all.
    pub(super) actions: Option<At<Vec<ActionName>>>,
    /// Force with which the tool is pressed on [N]; default 10.
    pub(super) press_force_n: Option<PressForceN>,
    /// Cartesian stiffness of the controller [N/m]; default 500.
    pub(super) stiffness_n_per_m: Option<Stiffness>,
    /// Damping ratio of the controller; default 0.7.
    pub(super) damping_ratio: Option<DampingRatio>,
    /// Weight of the posture task in the null space; default 0.2.
    pub(super) nullspace_posture_weight: Option<PostureWeight>,
    /// How deep the tool gives way here [m]; 0 is rigid; default: the tool's.
    pub(super) compression_depth_m: Option<DepthM>,
    /// How high the tool hovers over the surface instead of touching it [m]; default: as known, or 0, which touches.
    pub(super) gap_m: Option<DepthM>,
    /// Mean of ln f', the pressure over the nominal one from which on a grain is taken along; default -1.05.
    pub(super) mu: Option<LogForce>,
    /// Standard deviation of ln f'; default 0.25.
    pub(super) sigma: Option<LogSpread>,
    /// How well `mu` is known, as a standard deviation; default 0.3, that of an estimate.
    pub(super) mu_spread: Option<LawSpread>,
    /// How well the logarithm of `sigma` is known, as a standard deviation; default 0.2.
    pub(super) ln_sigma_spread: Option<LawSpread>,
    /// Travel under the tool after which a grain draws anew from which pressure on it is taken along [m]; default: the radius
    /// of the tool's collision sphere.
    pub(super) redraw_length_m: Option<RedrawLengthM>,
    /// How well its logarithm is known, as a standard deviation.
    pub(super) ln_redraw_length_spread: Option<LawSpread>,
    /// Probability that grains keep for good what they once drew.
    pub(super) kept_share: Option<Share>,
}

/// The target surface.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(
    rename = "Surface",
    extend("oneOf" = [{ "required": ["size_m"] }, { "required": ["outline_m"] }])
)]
pub(super) struct SurfaceTable {
    /// In the knowledge base, or a new one with `friction`.
    pub(super) name: At<Name>,
    /// Coulomb coefficient between it and a tool that slides on it: defines a surface of this task.
    pub(super) friction: Option<Friction>,
    /// A rectangle about the origin, along x and y [m]; excludes `outline_m`.
    pub(super) size_m: Option<At<[SizeM; 2]>>,
    /// A polygon of 3 to 2000 points that does not cross itself, surface frame [m]; excludes `size_m`.
    pub(super) outline_m: Option<At<RingPoints>>,
    /// Rings inside the outline, surface frame [m].
    #[serde(default)]
    pub(super) holes_m: Vec<At<RingPoints>>,
    /// Its origin in the world [m].
    pub(super) position_m: Option<[PositionM; 3]>,
    /// Roll, pitch, yaw about the world's x, y, z in turn [rad]; excludes `quaternion_xyzw`.
    pub(super) rpy_rad: Option<[AngleRad; 3]>,
    /// A unit quaternion; excludes `rpy_rad`.
    pub(super) quaternion_xyzw: Option<At<[QuaternionPart; 4]>>,
    /// The scene object whose face it is, no obstacle to the tool.
    pub(super) carried_by: Option<At<String>>,
    /// Edges over which a skim may push: y_min, x_max, y_max, x_min of a rectangle, or i for the edge of an outline
    /// from point i (counted from 0) to the next.
    #[serde(default)]
    pub(super) skim_edges: Vec<At<EdgeName>>,
}

/// Points of a ring that closes by itself.
pub(super) type RingPoints = Vec<[PositionM; 2]>;

/// An edge of an outline.
pub(super) enum EdgeName {
    /// One of a rectangle, by its index in [`RECTANGLE_EDGES`].
    OfRectangle(usize),
    /// That from this point to the next.
    FromPoint(u64),
}

/// The edges of [`wisch::geometry::Polygon::rectangle`], by index.
const RECTANGLE_EDGES: &[&str] = &["y_min", "x_max", "y_max", "x_min"];

impl<'de> Deserialize<'de> for EdgeName {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Edge;
        impl<'de> Visitor<'de> for Edge {
            type Value = EdgeName;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("the name or number of an edge")
            }
            fn visit_u64<E>(self, point: u64) -> Result<EdgeName, E> {
                Ok(EdgeName::FromPoint(point))
            }
            fn visit_enum<A: EnumAccess<'de>>(self, name: A) -> Result<EdgeName, A::Error> {
                let (name, rest): (String, _) = name.variant()?;
                rest.unit_variant()?;
                let index = RECTANGLE_EDGES.iter().position(|edge| *edge == name);
                index
                    .map(EdgeName::OfRectangle)
                    .ok_or_else(|| A::Error::unknown_variant(&name, RECTANGLE_EDGES))
            }
        }
        deserializer.deserialize_enum("edge", RECTANGLE_EDGES, Edge)
    }
}

impl JsonSchema for EdgeName {
    fn inline_schema() -> bool {
        true
    }
    fn schema_name() -> Cow<'static, str> {
        "Edge".into()
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "anyOf": [{ "enum": RECTANGLE_EDGES }, { "type": "integer", "minimum": 0 }] })
    }
}

/// The robot.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(
    rename = "Robot",
    extend("oneOf" = [{ "required": ["name"] }, { "required": ["urdf"] }])
)]
pub(super) struct RobotTable {
    /// One that is shipped: humanoid, arm7 or arm6; excludes `urdf`.
    pub(super) name: Option<At<Name>>,
    /// Path of its URDF relative to this file; excludes `name`.
    pub(super) urdf: Option<At<Name>>,
    /// Path of its SRDF: groups, ready state, disabled collisions; default: beside the URDF.
    pub(super) srdf: Option<Name>,
    /// Planning group that holds the tool; default: the SRDF's first.
    pub(super) group: Option<Name>,
    /// The group whose hand holds the tool too; the tool needs a second grip.
    pub(super) second_group: Option<Name>,
    /// Of its root in the world [m]; of a mobile base: where it starts, on z = 0. Default: before the surface's scene
    /// object with role = "robot".
    pub(super) position_m: Option<[PositionM; 3]>,
    /// Roll, pitch, yaw [rad]; a mobile base only turns about z.
    pub(super) rpy_rad: Option<[AngleRad; 3]>,
    /// A unit quaternion; excludes `rpy_rad`.
    pub(super) quaternion_xyzw: Option<At<[QuaternionPart; 4]>>,
}

/// Of the action collect.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Collect")]
pub(super) struct CollectTable {
    /// Where to push the dirt together, surface frame [m]; default: chosen by prediction.
    pub(super) goal_m: Option<[PositionM; 2]>,
}

/// Of the action polish.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Polish")]
pub(super) struct PolishTable {
    /// How often the tool is to slide over every place, each time by its own length.
    pub(super) passes: Passes,
    /// Most over any place, of all rounds together; default: one more than `passes`.
    pub(super) max_passes: Option<At<Passes>>,
    /// Coefficient of Preston's law, by which a pass removes so much: depth over pressure and way slid [1/Pa]; default: nothing
    /// is said of that.
    pub(super) preston_per_pa: Option<PrestonPerPa>,
}

/// Of the action emit.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Emit")]
pub(super) struct EmitTable {
    /// How thick the medium is to lie everywhere [m].
    pub(super) thickness_m: ThicknessM,
    /// How much of it the tool leaves on each metre of its way, over all of its width [m³/m].
    pub(super) volume_m3_per_m: VolumePerMetre,
}

/// A thing in the scene, of exactly one shape.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(
    rename = "SceneObject",
    extend("oneOf" = [
        { "required": ["box_m"] }, { "required": ["cylinder"] }, { "required": ["sphere"] },
        { "required": ["capsule"] }, { "required": ["mesh"] }
    ])
)]
pub(super) struct ObjectTable {
    /// Each name once.
    pub(super) name: At<Name>,
    /// A box along x, y, z [m].
    pub(super) box_m: Option<At<[SizeM; 3]>>,
    /// A cylinder, its axis along z.
    pub(super) cylinder: Option<At<TurnedTable>>,
    /// A sphere.
    pub(super) sphere: Option<At<SphereTable>>,
    /// A capsule along z; its height is that between the centres of its two halves.
    pub(super) capsule: Option<At<TurnedTable>>,
    /// A mesh from a file.
    pub(super) mesh: Option<At<MeshTable>>,
    /// In which frame its pose is given.
    #[serde(default)]
    pub(super) frame: FrameName,
    /// Its middle, or a mesh's origin [m].
    pub(super) position_m: Option<[PositionM; 3]>,
    /// Roll, pitch, yaw [rad]; excludes `quaternion_xyzw`.
    pub(super) rpy_rad: Option<[AngleRad; 3]>,
    /// A unit quaternion; excludes `rpy_rad`.
    pub(super) quaternion_xyzw: Option<At<[QuaternionPart; 4]>>,
    /// What it is to the task; collision ignores robot and tool.
    #[serde(default)]
    pub(super) role: RoleName,
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(inline)]
pub(super) struct TurnedTable {
    pub(super) radius_m: SizeM,
    pub(super) height_m: SizeM,
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(inline)]
pub(super) struct SphereTable {
    pub(super) radius_m: SizeM,
}

#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(inline)]
pub(super) struct MeshTable {
    /// STL, OBJ or DAE; path relative to this file.
    pub(super) file: At<Name>,
    /// What makes its lengths metres.
    #[serde(default = "scale")]
    pub(super) scale: Scale,
}

#[derive(Deserialize, JsonSchema, Clone, Copy, Default)]
#[serde(rename = "frame", rename_all = "lowercase")]
#[schemars(rename = "Frame", inline)]
pub(super) enum FrameName {
    #[default]
    World,
    Surface,
}

#[derive(Deserialize, JsonSchema, Clone, Copy, Default)]
#[serde(rename = "role", rename_all = "lowercase")]
#[schemars(rename = "Role", inline)]
pub(super) enum RoleName {
    #[default]
    Obstacle,
    Robot,
    Tool,
}

impl From<RoleName> for ScenePart {
    fn from(role: RoleName) -> Self {
        match role {
            RoleName::Obstacle => Self::Obstacle,
            RoleName::Robot => Self::Robot,
            RoleName::Tool => Self::Tool,
        }
    }
}

/// Where the dirt is believed to be, by its source.
#[derive(Deserialize, JsonSchema)]
#[serde(rename = "source", rename_all = "lowercase", deny_unknown_fields)]
#[schemars(rename = "Particles", tag = "source")]
pub(super) enum ParticlesTable {
    /// The places of the surface itself, in square cells: what polish and emit are about.
    Surface {
        /// About how many.
        count: ParticleCount,
    },
    /// Evenly over the free surface.
    Uniform {
        /// How many.
        count: ParticleCount,
    },
    /// Heaps.
    Clusters {
        /// How many in all.
        count: ParticleCount,
        /// The heaps.
        clusters: At<Vec<ClusterTable>>,
    },
    /// Listed: columns x,y in the surface frame, or an estimate with particle,x_m,y_m,fate,edge.
    Csv {
        /// Path relative to this file.
        file: Name,
    },
    /// Seen in a mask or photo.
    Image {
        /// Path relative to this file, of a PNG or JPEG up to 64 megapixels.
        file: Name,
        /// Where the corners of the surface's bounding box are seen: (min x, min y), (max x, min y), (max x, max y),
        /// (min x, max y); x to the right, y down [px].
        corners_px: [[Pixel; 2]; 4],
        /// Of the dirt: red, green, blue.
        color: [Channel; 3],
        /// Greatest Euclidean distance from that colour.
        tolerance: ColorDistance,
        /// How many.
        count: ParticleCount,
    },
}

/// How to plan.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
#[schemars(rename = "Plan")]
pub(super) struct PlanTable {
    /// Bandwidth of the density estimate of the strategy kde [m]; default: from the particles.
    pub(super) bandwidth_m: Option<BandwidthM>,
    /// How the tool is turned along the strokes of the strategies grid, rrt and kde.
    pub(super) heading: HeadingName,
    /// How high the tool is lifted between strokes [m].
    pub(super) lift_height_m: LiftHeightM,
    /// Candidate plans, of which the best by prediction is taken.
    pub(super) variants: Variants,
    /// Least score of a plan that is executed: the predicted share of the dirt that is brought where it belongs, less three times
    /// the share that is lost.
    pub(super) min_score: Score,
    /// Plans that the strategies adaptive and best try; more take longer and find better ones.
    pub(super) evaluations: Evaluations,
    /// By how much the tool may be off its way and still do what these strategies plan [m].
    pub(super) margin_m: MarginM,
    /// How far the tool may go in contact in a round [m]; default: as far as it takes.
    pub(super) max_distance_m: Option<DistanceM>,
    /// Fastest the tool moves in contact [m/s].
    pub(super) contact_speed_m_per_s: ContactSpeed,
}

impl Default for PlanTable {
    fn default() -> Self {
        Self {
            bandwidth_m: None,
            heading: HeadingName::Best,
            lift_height_m: LiftHeightM(0.05),
            variants: Variants(1),
            min_score: Score(MIN_SCORE),
            evaluations: Evaluations(60_000),
            margin_m: MarginM(0.003),
            max_distance_m: None,
            contact_speed_m_per_s: ContactSpeed(0.25),
        }
    }
}

/// How the tool is turned along strokes.
#[derive(Deserialize, JsonSchema, Clone, Copy)]
#[serde(rename = "heading", rename_all = "snake_case")]
#[schemars(rename = "Heading", inline)]
pub(super) enum HeadingName {
    Blended,
    AlongEdges,
    Constant,
    Best,
}

impl From<HeadingName> for HeadingRule {
    fn from(name: HeadingName) -> Self {
        match name {
            HeadingName::Blended => Self::Blended,
            HeadingName::AlongEdges => Self::AlongEdges,
            HeadingName::Constant => Self::Constant,
            HeadingName::Best => Self::Best,
        }
    }
}

/// What the robot perceives the dirt by, and how well it believes to.
#[derive(Deserialize, JsonSchema, Default)]
#[serde(deny_unknown_fields, default)]
#[schemars(rename = "Perception")]
pub(super) struct PerceptionTable {
    /// Touch, and sight where a camera looks after each round; default: touch alone.
    pub(super) senses: Option<At<Vec<SenseName>>>,
    /// Probability that the camera detects a large grain; default 0.98.
    pub(super) detection: Option<Share>,
    /// Diameter at which this probability is halved [m]; default 0.0003.
    pub(super) half_size_m: Option<HalfSizeM>,
    /// Detections where nothing lies, per area [1/m²]; default 2.
    pub(super) false_alarms_per_m2: Option<FalseAlarms>,
    /// Standard deviation of where a grain is seen, per axis [m]; default 0.002.
    pub(super) position_error_m: Option<PositionErrorM>,
}

/// A sense.
#[derive(Deserialize, JsonSchema, Clone, Copy, PartialEq, Eq)]
#[serde(rename = "sense", rename_all = "lowercase")]
#[schemars(rename = "Sense", inline)]
pub(super) enum SenseName {
    Touch,
    Sight,
}

fn seed() -> Seed {
    Seed(0)
}

fn target_performance() -> Share {
    Share(0.95)
}

fn scale() -> Scale {
    Scale(1.0)
}
