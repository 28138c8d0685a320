//! The keys of a task file. These types define both the reader and the JSON Schema; their comments are its descriptions.

use super::clusters::ClusterTable;
use super::deserialize::At;
use super::execution_tables::ExecutionTable;
use super::values::{
    AdheringM, AngleRad, BandwidthM, Channel, ColorDistance, ContactSpeed, DampingRatio,
    DensityKgPerM3, DepthM, DistanceM, Evaluations, FalseAlarms, FlangeM, FootprintM, FreeSpeed,
    Friction, GrainM, GripM, HalfAngleRad, HalfSizeM, HolderRadiusM, LawSpread, LeanRad,
    LiftHeightM, LogForce, LogSpread, MarginM, Name, ParticleCount, Passes, Pixel, PositionErrorM,
    PositionM, PostureWeight, PressForceN, PrestonPerPa, QuaternionPart, RadiusM, RedrawLengthM,
    Scale, SchemaVersion, Score, Seed, Share, SizeM, Stiffness, ThicknessM, Variants, ViscosityPaS,
    VolumeM3, VolumePerMetre, names,
};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{EnumAccess, Error as _, VariantAccess, Visitor};
use serde::{Deserialize, Deserializer};
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fmt;
use wisch::plan::YawRule;
use wisch::represent::{Action, MediumKind, ScenePart};
use wisch::robot::LinkAxis;
use wisch::run::RunConfig;

/// A task: action, tool, medium, surface and goal. Lengths in metres, angles in radians.
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
    /// Name of the task, its output folder and its report.
    pub(super) name: Name,
    /// Seed of all random numbers.
    #[serde(default = "seed")]
    pub(super) seed: Seed,
    /// Action; excludes `goal`.
    pub(super) action: Option<At<ActionName>>,
    /// Goal as a PDDL literal, such as (collected breadcrumbs chopping_board), from which wisch derives action and tool;
    /// excludes `action`.
    pub(super) goal: Option<At<Name>>,
    /// Strategy that plans the strokes.
    pub(super) strategy: Option<Name>,
    /// Share of the particles that meets the goal.
    #[serde(default = "target_performance")]
    pub(super) target_performance: Share,
    /// The tool.
    pub(super) tool: Option<At<ToolTable>>,
    /// The medium.
    pub(super) medium: Option<At<MediumTable>>,
    /// The surface.
    pub(super) surface: At<SurfaceTable>,
    /// Use of the tool on the medium and surface. Missing values come from the knowledge base; if it has no such
    /// interaction, wisch uses defaults and prints them.
    pub(super) interaction: Option<At<InteractionTable>>,
    /// The robot; without a robot, wisch predicts the plan but does not follow it.
    pub(super) robot: Option<At<RobotTable>>,
    /// The robot's senses.
    #[serde(default)]
    pub(super) perception: PerceptionTable,
    /// Ground truth of the simulation, hidden from planner and interpreter.
    #[serde(default)]
    pub(super) execution: ExecutionTable,
    /// Settings of the action collect.
    pub(super) collect: Option<CollectTable>,
    /// Settings of the action polish.
    pub(super) polish: Option<PolishTable>,
    /// Settings of the action dispense.
    #[serde(alias = "emit")]
    pub(super) dispense: Option<DispenseTable>,
    /// Objects around the surface.
    #[serde(default)]
    pub(super) scene: Vec<At<ObjectTable>>,
    /// Believed dirt locations.
    pub(super) particles: At<ParticlesTable>,
    /// Planner settings.
    #[serde(default)]
    pub(super) plan: PlanTable,
}

names! {
    /// Action on the dirt or the surface.
    ActionName("action", "lowercase") for Action {
        /// Absorb the dirt with the tool.
        Absorb,
        /// Push the dirt into a goal area.
        Collect,
        /// Push the dirt over a skim edge.
        Skim,
        /// Pass the tool over the whole surface a given number of times.
        Polish,
        /// Dispense the medium onto the surface with a given thickness.
        #[serde(alias = "emit")]
        Dispense,
    }
}

/// The tool.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Tool")]
pub(super) struct ToolTable {
    /// Name in the knowledge base; required with `action`. With `goal`: the tool in the hand.
    pub(super) name: Option<At<Name>>,
    /// Start position, surface frame [m]; default: the middle of the outline's side with the smallest y.
    pub(super) start_m: Option<[PositionM; 2]>,
    /// For `goal`: name of the tool in the hand; default: `name`.
    pub(super) in_hand: Option<Name>,
    /// For `goal`: tools that the robot can fetch.
    pub(super) available: Option<Vec<Name>>,
    /// Sides of a rectangular pad along and across the motion [m]: defines a tool of this task; excludes `mesh`.
    pub(super) footprint_m: Option<At<[FootprintM; 2]>>,
    /// Height of that pad, from its lower face to its upper one [m]; default 0.05.
    pub(super) height_m: Option<At<FootprintM>>,
    /// STL, OBJ, DAE or PLY in the tool frame, path relative to this file: defines a tool of this task; excludes
    /// `footprint_m`.
    pub(super) mesh: Option<At<Name>>,
    /// Compression depth of a tool of this task under nominal force [m]; 0 is rigid; default 0.005.
    pub(super) compression_depth_m: Option<At<DepthM>>,
    /// How the robot holds the tool; default: as the knowledge base or the robot's SRDF declares, else square on the flange.
    pub(super) mount: Option<At<MountTable>>,
}

/// How the robot holds the tool: exactly one of `on` and `point_m`.
///
/// The hand is a frame on the z axis of the group's tip link, at the outermost point of the shapes of that link and of the
/// links that it carries; its axes are those of the link.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Mount")]
pub(super) struct MountTable {
    /// Part of the robot that holds the tool.
    pub(super) on: Option<At<MountName>>,
    /// On a flange: rotation of the tool about its z axis [rad]; at 0 its x axis is the link's; default 0.
    pub(super) yaw_rad: Option<At<AngleRad>>,
    /// On a flange: distance of the tool's upper face from the origin of the link, along its z axis [m]; default: the hand.
    pub(super) distance_m: Option<At<FlangeM>>,
    /// With `distance_m`: radius of the holder between flange and tool, for collision checks [m]; default: 0.0315, or half the
    /// width of the tool if that is less.
    pub(super) holder_radius_m: Option<At<HolderRadiusM>>,
    /// On a flange: axis of the link that points out of the flange; default: as the robot's SRDF declares, else "z".
    pub(super) axis: Option<At<AxisName>>,
    /// In a hand: angle by which the hand leans back over the tool [rad]; default 0.8.
    pub(super) lean_rad: Option<At<LeanRad>>,
    /// Position of the hand in the tool frame [m].
    pub(super) point_m: Option<At<[GripM; 3]>>,
    /// With `point_m`: roll, pitch, yaw of the hand in the tool frame [rad].
    pub(super) hand_rpy_rad: Option<At<[AngleRad; 3]>>,
}

names! {
    /// Axis of a link.
    AxisName("axis", "lowercase") for LinkAxis {
        #[serde(rename = "x")]
        X,
        #[serde(rename = "-x")]
        NegativeX,
        #[serde(rename = "y")]
        Y,
        #[serde(rename = "-y")]
        NegativeY,
        #[serde(rename = "z")]
        Z,
        #[serde(rename = "-z")]
        NegativeZ,
    }
}

/// Part of the robot that holds the tool.
#[derive(Deserialize, JsonSchema, Clone, Copy, PartialEq, Eq)]
#[serde(rename = "on", rename_all = "lowercase")]
#[schemars(rename = "MountName", inline)]
pub(super) enum MountName {
    /// The tool's upper face lies square on the flange or gripper.
    Flange,
    /// A hand holds the rear edge of the tool's upper face and leans back.
    Hand,
}

/// The dirt.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Medium")]
pub(super) struct MediumTable {
    /// Name in the knowledge base, or a new name with `kind`; required with `action`.
    pub(super) name: Option<At<Name>>,
    /// Kind of the medium: defines a medium of this task.
    pub(super) kind: Option<At<MediumKindName>>,
    /// Smallest and largest diameter of its grains [m]; not for liquids; default: 0.0005 to 0.002.
    pub(super) grain_size_m: Option<At<[GrainM; 2]>>,
    /// Coefficient of friction of the dirt at rest on the surface: it slides where the tangent of the slope exceeds it; not
    /// for liquids; default: the dirt is assumed to stay in place.
    pub(super) static_friction: Option<At<Friction>>,
    /// Coefficient of friction of the dirt while it slides, at most `static_friction`; default: `static_friction`.
    pub(super) kinetic_friction: Option<At<Friction>>,
    /// Dynamic viscosity of a liquid [Pa s]; with `volume_m3`, a film of it runs down a leaning plane.
    pub(super) viscosity_pa_s: Option<At<ViscosityPaS>>,
    /// Density of the liquid [kg/m³]; default: 1000.
    pub(super) density_kg_per_m3: Option<DensityKgPerM3>,
    /// Thickness of the layer of the liquid that adheres and does not run [m]; default: 0.
    pub(super) adhering_thickness_m: Option<AdheringM>,
    /// Volume of all the liquid on the surface [m³]; default: the liquid is assumed to stay in place.
    pub(super) volume_m3: Option<At<VolumeM3>>,
}

names! {
    /// Kind of a medium: solid pieces, powder or liquid.
    MediumKindName("kind", "lowercase") for MediumKind {
        Solid,
        Liquid,
        Powder,
    }
}

/// Use of the tool on the medium and surface.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Interaction")]
pub(super) struct InteractionTable {
    /// Actions that suit tool, medium and surface; default: all.
    pub(super) actions: Option<At<Vec<ActionName>>>,
    /// Force with which the tool is pressed on [N]; default 10. If the knowledge base has another one, its `mu` and its
    /// compression are converted, so that they hold in newtons.
    pub(super) press_force_n: Option<PressForceN>,
    /// Cartesian stiffness of the controller [N/m]; default 500.
    pub(super) stiffness_n_per_m: Option<Stiffness>,
    /// Damping ratio of the controller; default 0.7.
    pub(super) damping_ratio: Option<DampingRatio>,
    /// Weight of the posture task in the null space; default 0.2.
    pub(super) nullspace_posture_weight: Option<PostureWeight>,
    /// Compression depth of the tool on this surface [m]; 0 is rigid; default: the tool's.
    pub(super) compression_depth_m: Option<DepthM>,
    /// Gap between tool and surface for work without contact [m]; default: that of the knowledge base, or 0 (contact).
    pub(super) gap_m: Option<DepthM>,
    /// Mean of ln X, where X is the ratio of the pressure that moves a grain to the nominal pressure; default -1.05.
    pub(super) mu: Option<LogForce>,
    /// Standard deviation of ln X; default 0.25.
    pub(super) sigma: Option<LogSpread>,
    /// Uncertainty of `mu`, as a standard deviation; default 0.3.
    pub(super) mu_spread: Option<LawSpread>,
    /// Uncertainty of the logarithm of `sigma`, as a standard deviation; default 0.2.
    pub(super) ln_sigma_spread: Option<LawSpread>,
    /// Travel of the tool over a grain after which its threshold X is drawn anew [m]; default: the radius of the tool's
    /// collision sphere.
    pub(super) redraw_length_m: Option<RedrawLengthM>,
    /// Uncertainty of the logarithm of `redraw_length_m`, as a standard deviation; default 0.5.
    pub(super) ln_redraw_length_spread: Option<LawSpread>,
    /// Probability that a grain keeps its first threshold X permanently; default 0.5.
    pub(super) kept_share: Option<Share>,
}

/// The target surface.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(
    rename = "Surface",
    extend("oneOf" = [
        { "required": ["size_m"] }, { "required": ["outline_m"] }, { "required": ["mesh"] }
    ])
)]
pub(super) struct SurfaceTable {
    /// Name in the knowledge base, or a new name with `friction`.
    pub(super) name: At<Name>,
    /// Coulomb coefficient between the surface and a sliding tool: defines a surface of this task.
    pub(super) friction: Option<Friction>,
    /// Sides of a rectangle around the origin, along x and y [m]; excludes `outline_m`.
    pub(super) size_m: Option<At<[SizeM; 2]>>,
    /// Simple polygon of 3 to 2000 points, surface frame [m]; excludes `size_m`.
    pub(super) outline_m: Option<At<RingPoints>>,
    /// Holes as polygons inside the outline, surface frame [m].
    #[serde(default)]
    pub(super) holes_m: Vec<At<RingPoints>>,
    /// A curved surface from a file, whose border is the outline. The pose is that of the file's frame.
    pub(super) mesh: Option<At<SurfaceMeshTable>>,
    /// Shape onto which the outline is rolled; default: plane.
    #[serde(default)]
    pub(super) shape: ShapeName,
    /// Radius of a cylinder, or distance of the origin from the axis of a cone [m]; positive where the surface bulges
    /// towards the tool, negative where it is hollow.
    pub(super) radius_m: Option<At<RadiusM>>,
    /// Angle between the axis of a cone and its surface [rad].
    pub(super) half_angle_rad: Option<At<HalfAngleRad>>,
    /// Angle from x of the axis of a cylinder, or of the direction in which a cone widens [rad]; default: 0.
    pub(super) axis_rad: Option<At<AngleRad>>,
    /// Origin of the surface in the world [m].
    pub(super) position_m: Option<[PositionM; 3]>,
    /// Roll, pitch, yaw about the world's x, y, z in turn [rad]; excludes `quaternion_xyzw`.
    pub(super) rpy_rad: Option<[AngleRad; 3]>,
    /// A unit quaternion; excludes `rpy_rad`.
    pub(super) quaternion_xyzw: Option<At<[QuaternionPart; 4]>>,
    /// Scene object that carries the surface; it is no obstacle to the tool.
    pub(super) carried_by: Option<At<String>>,
    /// Skim edges, over which a skim may push dirt: y_min, x_max, y_max, x_min of a rectangle, or i for the edge of an
    /// outline from point i (counted from 0) to the next.
    #[serde(default)]
    pub(super) skim_edges: Vec<At<EdgeName>>,
}

/// Mesh of a curved surface, and the part of it that is meant.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(inline)]
pub(super) struct SurfaceMeshTable {
    /// STL, OBJ, DAE or PLY, or a height field as Esri ASCII raster (.asc); path relative to this file.
    pub(super) file: At<Name>,
    /// Factor that converts its lengths to metres.
    #[serde(default = "scale")]
    pub(super) scale: Scale,
    /// Direction from the surface to the tool, in the frame of the file; default: the side to which the file turns its
    /// triangles. A closed mesh needs it.
    pub(super) towards: Option<[PositionM; 3]>,
    /// A point near the part that is meant, in the frame of the file [m]; default: the largest part.
    pub(super) seed_point_m: Option<[PositionM; 3]>,
    /// Largest angle of a normal from `towards` [rad]; default: 1.2 for a closed mesh, none for another.
    pub(super) largest_lean_rad: Option<AngleRad>,
    /// Number of the patch that is wiped, from 1, as `wisch surface split` numbers them, or "all"; default: the surface is
    /// not divided.
    pub(super) patch: Option<At<PatchName>>,
}

/// A patch of a divided surface.
pub(super) enum PatchName {
    /// All patches, one after another.
    All,
    /// A patch by its number, from 1.
    Numbered(u64),
}

/// The names that stand for patches, beside their numbers.
const PATCH_NAMES: &[&str] = &["all"];

impl<'de> Deserialize<'de> for PatchName {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Patch;
        impl<'de> Visitor<'de> for Patch {
            type Value = PatchName;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("the number of a patch, or \"all\"")
            }
            fn visit_u64<E>(self, number: u64) -> Result<PatchName, E> {
                Ok(PatchName::Numbered(number))
            }
            fn visit_enum<A: EnumAccess<'de>>(self, name: A) -> Result<PatchName, A::Error> {
                let (name, rest): (String, _) = name.variant()?;
                rest.unit_variant()?;
                if PATCH_NAMES.contains(&name.as_str()) {
                    Ok(PatchName::All)
                } else {
                    Err(A::Error::unknown_variant(&name, PATCH_NAMES))
                }
            }
        }
        deserializer.deserialize_enum("patch", PATCH_NAMES, Patch)
    }
}

impl JsonSchema for PatchName {
    fn inline_schema() -> bool {
        true
    }
    fn schema_name() -> Cow<'static, str> {
        "Patch".into()
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "anyOf": [{ "enum": PATCH_NAMES }, { "type": "integer", "minimum": 1 }] })
    }
}

/// Shape of a surface: flat, or rolled onto a cylinder or a cone that touches the xy plane of its frame at the origin.
#[derive(Deserialize, JsonSchema, Clone, Copy, Default, PartialEq, Eq)]
#[serde(rename = "shape", rename_all = "lowercase")]
#[schemars(rename = "SurfaceShape", inline)]
pub(super) enum ShapeName {
    #[default]
    Plane,
    Cylinder,
    Cone,
}

/// Points of a closed ring; the last point joins the first.
pub(super) type RingPoints = Vec<[PositionM; 2]>;

/// An edge of an outline.
pub(super) enum EdgeName {
    /// Edge of a rectangle, by its index in [`RECTANGLE_EDGES`].
    OfRectangle(usize),
    /// Edge from this point to the next.
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
    /// Shipped robot: humanoid, arm7 or arm6; excludes `urdf`.
    pub(super) name: Option<At<Name>>,
    /// URDF, path relative to this file; excludes `name`.
    pub(super) urdf: Option<At<Name>>,
    /// SRDF with groups, ready state and disabled collisions; default: the file beside the URDF.
    pub(super) srdf: Option<Name>,
    /// Folders of the ROS packages whose meshes the URDF names, by package, paths relative to this file. Other packages are
    /// searched for in `ROS_PACKAGE_PATH`, in `AMENT_PREFIX_PATH` and in the folders above the URDF.
    pub(super) packages: Option<BTreeMap<String, Name>>,
    /// Planning group that holds the tool; default: the first group of the SRDF.
    pub(super) group: Option<Name>,
    /// Second planning group that holds the tool; the tool needs a second grip.
    pub(super) second_group: Option<Name>,
    /// Position of the robot's root in the world [m]; for a mobile base, its start position on z = 0. Default: at the scene
    /// object with role = "robot", facing the surface.
    pub(super) position_m: Option<[PositionM; 3]>,
    /// Roll, pitch, yaw [rad]; a mobile base turns about z only.
    pub(super) rpy_rad: Option<[AngleRad; 3]>,
    /// A unit quaternion; excludes `rpy_rad`.
    pub(super) quaternion_xyzw: Option<At<[QuaternionPart; 4]>>,
}

/// Settings of the action collect.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Collect")]
pub(super) struct CollectTable {
    /// Centre of the goal area, surface frame [m]; default: chosen by prediction.
    pub(super) goal_m: Option<[PositionM; 2]>,
}

/// Settings of the action polish.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Polish")]
pub(super) struct PolishTable {
    /// Required number of passes over every point; one pass is a slide of the tool by its own length.
    pub(super) passes: Passes,
    /// Maximum number of passes over any point, in all rounds together; default: `passes` + 1.
    pub(super) max_passes: Option<At<Passes>>,
    /// Coefficient of Preston's law: removed depth per pressure and sliding distance [1/Pa]; default: the removed depth is not
    /// computed.
    pub(super) preston_per_pa: Option<PrestonPerPa>,
}

/// Settings of the action dispense.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Dispense")]
pub(super) struct DispenseTable {
    /// Required thickness of the medium [m].
    pub(super) thickness_m: ThicknessM,
    /// Volume that the tool dispenses per metre of its path, over its full width [m³/m].
    pub(super) volume_m3_per_m: VolumePerMetre,
}

/// An object of the scene, with exactly one shape.
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
    /// Unique name.
    pub(super) name: At<Name>,
    /// A box along x, y, z [m].
    pub(super) box_m: Option<At<[SizeM; 3]>>,
    /// A cylinder, its axis along z.
    pub(super) cylinder: Option<At<TurnedTable>>,
    /// A sphere.
    pub(super) sphere: Option<At<SphereTable>>,
    /// A capsule along z; its height is the distance between the centres of its two hemispheres.
    pub(super) capsule: Option<At<TurnedTable>>,
    /// A mesh from a file.
    pub(super) mesh: Option<At<MeshTable>>,
    /// Frame of the pose.
    #[serde(default)]
    pub(super) frame: FrameName,
    /// Position of its centre, or of a mesh's origin [m].
    pub(super) position_m: Option<[PositionM; 3]>,
    /// Roll, pitch, yaw [rad]; excludes `quaternion_xyzw`.
    pub(super) rpy_rad: Option<[AngleRad; 3]>,
    /// A unit quaternion; excludes `rpy_rad`.
    pub(super) quaternion_xyzw: Option<At<[QuaternionPart; 4]>>,
    /// Role in the task; collision checks ignore the roles robot and tool.
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
    /// STL, OBJ, DAE or PLY; path relative to this file.
    pub(super) file: At<Name>,
    /// Factor that converts its lengths to metres.
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

names! {
    #[derive(Default)]
    RoleName("role", "lowercase") for ScenePart {
        #[default]
        Obstacle,
        Robot,
        Tool,
    }
}

/// Believed dirt locations, by source.
#[derive(Deserialize, JsonSchema)]
#[serde(rename = "source", rename_all = "lowercase", deny_unknown_fields)]
#[schemars(rename = "Particles", tag = "source")]
pub(super) enum ParticlesTable {
    /// Points of the surface itself, at the centres of square cells; for polish and dispense.
    Surface {
        /// Approximate number of points.
        count: ParticleCount,
    },
    /// Uniform over the free surface.
    Uniform {
        /// Number of particles.
        count: ParticleCount,
    },
    /// Heaps.
    Clusters {
        /// Total number of particles.
        count: ParticleCount,
        /// The heaps.
        clusters: At<Vec<ClusterTable>>,
    },
    /// A list with the columns x,y in the surface frame, or an estimate with particle,x_m,y_m,fate,edge.
    Csv {
        /// Path relative to this file.
        file: Name,
    },
    /// Detected in a mask or photo.
    Image {
        /// PNG or JPEG up to 64 megapixels, path relative to this file.
        file: Name,
        /// Pixels of the corners of the surface's bounding box: (min x, min y), (max x, min y), (max x, max y),
        /// (min x, max y); x to the right, y down [px].
        corners_px: [[Pixel; 2]; 4],
        /// Colour of the dirt: red, green, blue.
        color: [Channel; 3],
        /// Maximum Euclidean distance from that colour.
        tolerance: ColorDistance,
        /// Number of particles.
        count: ParticleCount,
    },
}

/// Planner settings.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
#[schemars(rename = "Plan")]
pub(super) struct PlanTable {
    /// Bandwidth of the density estimate of the strategy kde [m]; default: from the particles.
    pub(super) bandwidth_m: Option<BandwidthM>,
    /// Rule for the tool's yaw along the strokes of the strategies grid, rrt and kde.
    pub(super) heading: HeadingName,
    /// Lift height between strokes [m].
    pub(super) lift_height_m: LiftHeightM,
    /// Number of candidate plans; the plan with the best prediction is chosen.
    pub(super) variants: Variants,
    /// Minimum score of a plan that may be executed: the predicted share of the dirt that reaches the goal, minus three times
    /// the lost share.
    pub(super) min_score: Score,
    /// Number of plans that the strategies adaptive and best try; more plans take longer and give better results.
    pub(super) evaluations: Evaluations,
    /// Path error of the tool that the plans of these strategies tolerate [m].
    pub(super) margin_m: MarginM,
    /// Maximum path length in contact per round [m]; default: no limit.
    pub(super) max_distance_m: Option<DistanceM>,
    /// Maximum speed of the tool in contact [m/s].
    pub(super) contact_speed_m_per_s: ContactSpeed,
    /// Maximum speed of the tool between strokes [m/s]; default: what the joints permit.
    pub(super) free_speed_m_per_s: Option<FreeSpeed>,
}

impl Default for PlanTable {
    fn default() -> Self {
        let run = RunConfig::default();
        Self {
            bandwidth_m: None,
            heading: HeadingName::Best,
            lift_height_m: LiftHeightM(run.plan.lift_height),
            variants: Variants(run.variants as u64),
            min_score: Score(run.min_score),
            evaluations: Evaluations(run.plan.search.evaluations as u64),
            margin_m: MarginM(run.plan.search.margin_m),
            max_distance_m: None,
            contact_speed_m_per_s: ContactSpeed(run.follow.contact_speed),
            free_speed_m_per_s: None,
        }
    }
}

names! {
    /// Rule for the tool's yaw along strokes.
    HeadingName("heading", "snake_case") for YawRule {
        Blended,
        AlongEdges,
        Constant,
        Best,
    }
}

/// The robot's senses, and the believed quality of its camera.
#[derive(Deserialize, JsonSchema, Default)]
#[serde(deny_unknown_fields, default)]
#[schemars(rename = "Perception")]
pub(super) struct PerceptionTable {
    /// Touch, or touch and sight, with a camera that observes the dirt before the first round and after each round; default:
    /// touch only.
    pub(super) senses: Option<At<Vec<SenseName>>>,
    /// Probability that the camera detects a large grain; default 0.98.
    pub(super) detection: Option<Share>,
    /// Grain diameter at which the detection probability is halved [m]; default 0.0003.
    pub(super) half_size_m: Option<HalfSizeM>,
    /// False detections per area [1/m²]; default 2.
    pub(super) false_alarms_per_m2: Option<FalseAlarms>,
    /// Standard deviation of a detected position, per axis [m]; default 0.002.
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
    Seed(RunConfig::default().plan.seed)
}

fn target_performance() -> Share {
    Share(RunConfig::default().target)
}

fn scale() -> Scale {
    Scale(1.0)
}
