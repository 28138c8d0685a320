//! From the tree of a task file to its checked contents.

use super::outline::Outline;
use super::reader::{Field, POSITION_M, Section};
use super::tree::Source;
use super::{
    Frame, Intent, ObjectRecord, RobotDescription, RobotRecord, Shape, SurfaceRecord, TaskError,
    TaskFile,
};
use crate::particles::{MaskSource, ParticleSource};
use nalgebra::{Quaternion, Translation3, UnitQuaternion};
use std::f64::consts::TAU;
use std::ops::RangeInclusive;
use wisch::geometry::{Point2, Pose, Vector2, Vector3};
use wisch::represent::{Action, Cluster, MAX_PARTICLES, ScenePart, Surface};
use wisch::source_location::{Place, UnknownName};

/// The schema that this version reads.
pub(super) const SCHEMA: u64 = 1;

/// Sizes of surfaces and objects [m].
const SIZE_M: RangeInclusive<f64> = 1e-3..=100.0;
/// A full turn either way.
const ANGLE_RAD: RangeInclusive<f64> = -TAU..=TAU;
/// A component of a unit quaternion, with room for rounding.
const QUATERNION: RangeInclusive<f64> = -1.001..=1.001;
/// How far a quaternion's norm may be from 1.
const QUATERNION_NORM_TOLERANCE: f64 = 1e-3;
/// From drawings in micrometres to drawings in kilometres.
const SCALE: RangeInclusive<f64> = 1e-6..=1e3;
/// Spread of a heap: less than a crumb up to a room.
const SIGMA_M: RangeInclusive<f64> = 1e-5..=10.0;
/// Shares relative to each other.
const WEIGHT: RangeInclusive<f64> = 1e-9..=1e9;
/// Narrower than the grains, or wider than any surface, says nothing.
const BANDWIDTH_M: RangeInclusive<f64> = 1e-3..=10.0;
/// Clear of the surface, within an arm's reach.
const LIFT_HEIGHT_M: RangeInclusive<f64> = 1e-3..=1.0;
/// Plans to choose from.
const VARIANTS: RangeInclusive<u64> = 1..=100;
/// Distances between colours in RGB; black and white are 441.67 apart.
const TOLERANCE: RangeInclusive<f64> = 0.0..=442.0;
/// A channel of a colour.
const CHANNEL: RangeInclusive<u64> = 0..=255;
/// Coordinates in an image; its true size is known once it is read.
const PIXEL: RangeInclusive<f64> = 0.0..=1e6;
/// Shares.
const SHARE: RangeInclusive<f64> = 0.0..=1.0;
/// How many particles.
const COUNT: RangeInclusive<u64> = 1..=MAX_PARTICLES as u64;
/// How many clusters.
const MAX_CLUSTERS: usize = 10_000;

/// Default of `plan.lift_height_m` [m].
const LIFT_HEIGHT_DEFAULT: f64 = 0.05;
/// Default of `target_performance`.
const TARGET_PERFORMANCE_DEFAULT: f64 = 0.95;

/// The edges of [`wisch::geometry::Polygon::rectangle`], by index.
const RECTANGLE_EDGES: [&str; 4] = ["y_min", "x_max", "y_max", "x_min"];
const SHAPES: [&str; 5] = ["box_m", "cylinder", "sphere", "capsule", "mesh"];

const ROOT_KEYS: &[&str] = &[
    "schema",
    "name",
    "seed",
    "action",
    "goal",
    "strategy",
    "target_performance",
    "tool",
    "medium",
    "surface",
    "robot",
    "execution",
    "collect",
    "scene",
    "particles",
    "plan",
];
const TOOL_KEYS: &[&str] = &["name", "start_m", "in_hand", "available"];
const MEDIUM_KEYS: &[&str] = &["name"];
const SURFACE_KEYS: &[&str] = &[
    "name",
    "size_m",
    "outline_m",
    "holes_m",
    "position_m",
    "rpy_rad",
    "quaternion_xyzw",
    "carried_by",
    "skim_edges",
];
const ROBOT_KEYS: &[&str] = &[
    "name",
    "urdf",
    "srdf",
    "group",
    "second_group",
    "position_m",
    "rpy_rad",
    "quaternion_xyzw",
];
const COLLECT_KEYS: &[&str] = &["goal_m"];
const SCENE_KEYS: &[&str] = &[
    "name",
    "box_m",
    "cylinder",
    "sphere",
    "capsule",
    "mesh",
    "frame",
    "position_m",
    "rpy_rad",
    "quaternion_xyzw",
    "role",
];
const TURNED_KEYS: &[&str] = &["radius_m", "height_m"];
const SPHERE_KEYS: &[&str] = &["radius_m"];
const MESH_KEYS: &[&str] = &["file", "scale"];
const PARTICLES_KEYS: &[&str] = &[
    "source",
    "count",
    "clusters",
    "file",
    "corners_px",
    "color",
    "tolerance",
];
const UNIFORM_KEYS: &[&str] = &["source", "count"];
const CLUSTERS_KEYS: &[&str] = &["source", "count", "clusters"];
const CLUSTER_KEYS: &[&str] = &["center_m", "sigma_m", "weight"];
const CSV_KEYS: &[&str] = &["source", "file"];
const IMAGE_KEYS: &[&str] = &[
    "source",
    "file",
    "corners_px",
    "color",
    "tolerance",
    "count",
];
const PLAN_KEYS: &[&str] = &["bandwidth_m", "lift_height_m", "variants"];

/// Every list of keys, for the template's test.
#[cfg(test)]
pub(super) const ALL_KEYS: [&[&str]; 16] = [
    super::execution::EXECUTION_KEYS,
    super::execution::PUSH_KEYS,
    super::execution::FRICTION_KEYS,
    ROBOT_KEYS,
    ROOT_KEYS,
    TOOL_KEYS,
    MEDIUM_KEYS,
    SURFACE_KEYS,
    COLLECT_KEYS,
    SCENE_KEYS,
    TURNED_KEYS,
    SPHERE_KEYS,
    MESH_KEYS,
    PARTICLES_KEYS,
    CLUSTER_KEYS,
    PLAN_KEYS,
];

pub(super) fn read(source: &Source<'_>) -> Result<TaskFile, TaskError> {
    let tree = source.tree()?;
    let root = Field::root(source, &tree);
    // Another schema may well have other keys, so it is looked at first.
    schema(&tree, source)?;
    let root = root.section(ROOT_KEYS)?;
    root.require("schema")?;

    let tool_field = root.get("tool");
    let tool = match &tool_field {
        Some(field) => Some(field.section(TOOL_KEYS)?),
        None => None,
    };
    let medium_field = root.get("medium");
    let medium = match &medium_field {
        Some(field) => Some(field.section(MEDIUM_KEYS)?),
        None => None,
    };
    let (intent, intent_at) = intent(root, tool, medium)?;
    let named = |section: Option<Section<'_>>| {
        section
            .and_then(|section| Some(section.get("name")?.place()))
            .unwrap_or_else(|| intent_at.clone())
    };

    let collect_goal = match root.get("collect") {
        Some(field) => {
            let goal = field.section(COLLECT_KEYS)?.get("goal_m");
            goal.map(|goal| goal.point(&POSITION_M)).transpose()?
        }
        None => None,
    };
    let (bandwidth, lift_height, variants) = match root.get("plan") {
        Some(field) => {
            let plan = field.section(PLAN_KEYS)?;
            let bandwidth = plan.get("bandwidth_m");
            (
                bandwidth
                    .map(|field| field.number(&BANDWIDTH_M))
                    .transpose()?,
                plan.number_or("lift_height_m", &LIFT_HEIGHT_M, LIFT_HEIGHT_DEFAULT)?,
                plan.get("variants")
                    .map_or(Ok(1), |field| field.integer(VARIANTS))? as usize,
            )
        }
        None => (None, LIFT_HEIGHT_DEFAULT, 1),
    };
    let scene = match root.get("scene") {
        Some(field) => scene(&field)?,
        None => Vec::new(),
    };
    let particles = root.require("particles")?;
    let (execution, max_rounds) = super::execution::execution(root.get("execution").as_ref())?;
    Ok(TaskFile {
        name: root.require("name")?.name()?,
        seed: match root.get("seed") {
            Some(field) => field.integer(0..=u64::MAX)?,
            None => 0,
        },
        strategy: root.get("strategy").map(|f| f.name()).transpose()?,
        target_performance: root.number_or(
            "target_performance",
            &SHARE,
            TARGET_PERFORMANCE_DEFAULT,
        )?,
        tool_at: named(tool),
        tool_start: (tool.and_then(|tool| tool.get("start_m")))
            .map(|field| field.point(&POSITION_M))
            .transpose()?,
        medium_at: named(medium),
        surface: surface(&root.require("surface")?, &scene)?,
        robot: root.get("robot").map(|f| robot(&f)).transpose()?,
        execution,
        max_rounds,
        collect_goal,
        particles_at: particles.place(),
        particles: particle_source(&particles)?,
        scene,
        bandwidth,
        lift_height,
        variants,
        intent,
    })
}

fn schema(tree: &super::tree::Value, source: &Source<'_>) -> Result<(), TaskError> {
    let super::tree::Node::Table(entries) = &tree.node else {
        return Ok(());
    };
    let Some(entry) = entries.iter().find(|entry| entry.key == "schema") else {
        return Ok(());
    };
    match entry.value.node {
        super::tree::Node::Integer(found) if found == i128::from(SCHEMA) => Ok(()),
        ref other => Err(TaskError::Schema {
            at: source.place(entry.value.offset),
            found: other.description(),
        }),
    }
}

fn intent(
    root: Section<'_>,
    tool: Option<Section<'_>>,
    medium: Option<Section<'_>>,
) -> Result<(Intent, Place), TaskError> {
    let (key, field) = root.exactly_one(&["action", "goal"])?;
    let at = field.place();
    let names = |key| tool.and_then(|tool| tool.get(key));
    let in_hand = names("in_hand").map(|field| field.name()).transpose()?;
    let available = names("available").map(|field| field.names()).transpose()?;
    let tool_name = names("name").map(|field| field.name()).transpose()?;
    let medium_name = (medium.and_then(|medium| medium.get("name")))
        .map(|field| field.name())
        .transpose()?;
    if key == "goal" {
        let intent = Intent::Goal {
            literal: field.name()?,
            tool_in_hand: in_hand.or(tool_name),
            available_tools: available.unwrap_or_default(),
        };
        return Ok((intent, at));
    }
    let action: Action = known(&field, "action", &Action::ALL.map(|a| (a.as_str(), a)))?;
    let missing = |table: &str| TaskError::Missing {
        at: at.clone(),
        table: table.to_owned(),
        key: "name",
    };
    let intent = Intent::Action {
        action,
        tool: tool_name.ok_or_else(|| missing("tool"))?,
        medium: medium_name.ok_or_else(|| missing("medium"))?,
    };
    Ok((intent, at))
}

/// The value that the string names.
fn known<T: Copy>(
    field: &Field<'_>,
    kind: &'static str,
    values: &[(&str, T)],
) -> Result<T, TaskError> {
    let name = field.string()?;
    let found = values.iter().find(|(known, _)| *known == name);
    found.map(|(_, value)| *value).ok_or_else(|| {
        let unknown = UnknownName::new(kind, name, values.iter().map(|(known, _)| *known));
        TaskError::UnknownReference {
            at: field.place(),
            unknown: Box::new(unknown),
        }
    })
}

fn surface(field: &Field<'_>, scene: &[ObjectRecord]) -> Result<SurfaceRecord, TaskError> {
    let section = field.section(SURFACE_KEYS)?;
    let name = section.require("name")?;
    let (kind, shape) = section.exactly_one(&["size_m", "outline_m"])?;
    let holes = section.get("holes_m");
    let is_rectangle = kind == "size_m";
    let outline = if is_rectangle {
        let size = Vector2::from(shape.numbers::<2>(&SIZE_M)?);
        Outline::rectangle(size).with_holes(holes.as_ref())?
    } else {
        Outline::read(&shape, holes.as_ref())?
    };
    let mut skim_edges = Vec::new();
    if let Some(field) = section.get("skim_edges") {
        for item in field.items("an array of edges")? {
            let typed = if item.is_string() {
                if !is_rectangle {
                    return Err(item.inconsistent(
                        "edges have names only where size_m gives a rectangle; an outline's are numbers",
                    ));
                }
                let edges: Vec<_> = (RECTANGLE_EDGES.into_iter().zip(0_usize..)).collect();
                known(&item, "edge", &edges)?
            } else {
                let last = outline.polygon.outer().len() as u64 - 1;
                item.integer(0..=last)? as usize
            };
            let edge = outline.edge(typed);
            if skim_edges.contains(&edge) {
                return Err(item.inconsistent("the edge is named twice"));
            }
            skim_edges.push(edge);
        }
    }
    let carried_by = match section.get("carried_by") {
        Some(field) => {
            let objects: Vec<_> = (scene.iter().map(|o| o.name.as_str()).zip(0_usize..)).collect();
            Some(known(&field, "scene object", &objects)?)
        }
        None => None,
    };
    Ok(SurfaceRecord {
        at: name.place(),
        surface: Surface {
            name: name.name()?,
            outline: outline.polygon,
            world_from_surface: pose(section)?,
            skim_edges,
        },
        carried_by,
    })
}

fn robot(field: &Field<'_>) -> Result<RobotRecord, TaskError> {
    let section = field.section(ROBOT_KEYS)?;
    let (kind, source) = section.exactly_one(&["name", "urdf"])?;
    let text = |key| section.get(key).map(|field| field.name()).transpose();
    let srdf = text("srdf")?;
    let description = if kind == "name" {
        if srdf.is_some() {
            return Err(section.inconsistent("srdf goes with urdf; a robot by name has its own"));
        }
        RobotDescription::Named(source.name()?)
    } else {
        RobotDescription::Files {
            urdf: source.name()?,
            srdf,
        }
    };
    Ok(RobotRecord {
        description,
        group: text("group")?,
        second_group: text("second_group")?,
        world_from_robot: match section.get("position_m") {
            Some(_) => Some(pose(section)?),
            None if section.get("rpy_rad").is_some()
                || section.get("quaternion_xyzw").is_some() =>
            {
                return Err(section.inconsistent("a rotation needs position_m beside it"));
            }
            None => None,
        },
    })
}

/// A pose from `position_m` and one of `rpy_rad` and `quaternion_xyzw`, all optional.
fn pose(section: Section<'_>) -> Result<Pose, TaskError> {
    let position = match section.get("position_m") {
        Some(field) => Vector3::from(field.numbers::<3>(&POSITION_M)?),
        None => Vector3::zeros(),
    };
    let rotation = match (section.get("rpy_rad"), section.get("quaternion_xyzw")) {
        (None, None) => UnitQuaternion::identity(),
        (Some(rpy), None) => {
            let [roll, pitch, yaw] = rpy.numbers(&ANGLE_RAD)?;
            UnitQuaternion::from_euler_angles(roll, pitch, yaw)
        }
        (None, Some(field)) => {
            let [x, y, z, w] = field.numbers(&QUATERNION)?;
            let quaternion = Quaternion::new(w, x, y, z);
            let norm = quaternion.norm();
            if (norm - 1.0).abs() > QUATERNION_NORM_TOLERANCE {
                return Err(field.inconsistent(format!(
                    "its norm is {norm}, but must be within {QUATERNION_NORM_TOLERANCE} of 1"
                )));
            }
            UnitQuaternion::from_quaternion(quaternion)
        }
        (Some(_), Some(_)) => {
            return Err(section.inconsistent("rpy_rad and quaternion_xyzw exclude each other"));
        }
    };
    Ok(Pose::from_parts(Translation3::from(position), rotation))
}

fn scene(field: &Field<'_>) -> Result<Vec<ObjectRecord>, TaskError> {
    let mut objects: Vec<ObjectRecord> = Vec::new();
    for item in field.items("an array of tables, [[scene]]")? {
        let section = item.section(SCENE_KEYS)?;
        let name_field = section.require("name")?;
        let name = name_field.name()?;
        if let Some(first) = objects.iter().find(|object| object.name == name) {
            let first = &first.at;
            return Err(name_field.inconsistent(format!("{name:?} is already at {first}")));
        }
        let frames = [("world", Frame::World), ("surface", Frame::Surface)];
        let roles = [
            ("obstacle", ScenePart::Obstacle),
            ("robot", ScenePart::Robot),
            ("tool", ScenePart::Tool),
        ];
        objects.push(ObjectRecord {
            at: name_field.place(),
            name,
            shape: shape(section)?,
            frame: match section.get("frame") {
                Some(field) => known(&field, "frame", &frames)?,
                None => Frame::World,
            },
            frame_from_object: pose(section)?,
            part: match section.get("role") {
                Some(field) => known(&field, "role", &roles)?,
                None => ScenePart::Obstacle,
            },
        });
    }
    Ok(objects)
}

fn shape(section: Section<'_>) -> Result<Shape, TaskError> {
    let (kind, field) = section.exactly_one(&SHAPES)?;
    let size = |section: Section<'_>, key| section.require(key)?.number(&SIZE_M);
    Ok(match kind {
        "box_m" => Shape::Box(Vector3::from(field.numbers::<3>(&SIZE_M)?)),
        "cylinder" => {
            let section = field.section(TURNED_KEYS)?;
            Shape::Cylinder {
                radius: size(section, "radius_m")?,
                height: size(section, "height_m")?,
            }
        }
        "sphere" => Shape::Sphere {
            radius: size(field.section(SPHERE_KEYS)?, "radius_m")?,
        },
        "capsule" => {
            let section = field.section(TURNED_KEYS)?;
            Shape::Capsule {
                radius: size(section, "radius_m")?,
                height: size(section, "height_m")?,
            }
        }
        _ => {
            let section = field.section(MESH_KEYS)?;
            let file = section.require("file")?;
            Shape::Mesh {
                at: file.place(),
                file: file.name()?,
                scale: section.number_or("scale", &SCALE, 1.0)?,
            }
        }
    })
}

fn particle_source(field: &Field<'_>) -> Result<ParticleSource, TaskError> {
    let section = field.section(PARTICLES_KEYS)?;
    let keys = [
        ("uniform", UNIFORM_KEYS),
        ("clusters", CLUSTERS_KEYS),
        ("csv", CSV_KEYS),
        ("image", IMAGE_KEYS),
    ];
    let source = section.require("source")?;
    let section = section.narrowed(known(&source, "particle source", &keys)?)?;
    let count =
        || -> Result<usize, TaskError> { Ok(section.require("count")?.integer(COUNT)? as usize) };
    Ok(match source.string()? {
        "uniform" => ParticleSource::Uniform { count: count()? },
        "clusters" => {
            let field = section.require("clusters")?;
            let items = field.items("an array of tables")?;
            if !(1..=MAX_CLUSTERS).contains(&items.len()) {
                return Err(field.inconsistent(format!(
                    "{} clusters, but there are at least 1 and at most {MAX_CLUSTERS}",
                    items.len()
                )));
            }
            ParticleSource::Clusters {
                count: count()?,
                clusters: items.iter().map(cluster).collect::<Result<_, _>>()?,
            }
        }
        "csv" => ParticleSource::Csv {
            file: section.require("file")?.name()?,
        },
        _ => {
            let corners = section.require("corners_px")?;
            let points = corners
                .items("an array of four points [x, y]")?
                .iter()
                .map(|corner| corner.point(&PIXEL))
                .collect::<Result<Vec<Point2>, _>>()?;
            let found = points.len();
            let corners_px = points.try_into().map_err(|_| {
                corners.inconsistent(format!("{found} corners, but the surface has four"))
            })?;
            let color = section.require("color")?;
            let channels = color
                .items("an array [red, green, blue]")?
                .iter()
                .map(|channel| Ok(channel.integer(CHANNEL)? as u8))
                .collect::<Result<Vec<u8>, TaskError>>()?;
            let color = channels
                .try_into()
                .map_err(|_| color.inconsistent("a colour has three channels, red, green, blue"))?;
            ParticleSource::Image(MaskSource {
                file: section.require("file")?.name()?,
                corners_px,
                color,
                tolerance: section.require("tolerance")?.number(&TOLERANCE)?,
                count: count()?,
            })
        }
    })
}

fn cluster(field: &Field<'_>) -> Result<Cluster, TaskError> {
    let section = field.section(CLUSTER_KEYS)?;
    Ok(Cluster {
        center: section.require("center_m")?.point(&POSITION_M)?,
        sigma: section.require("sigma_m")?.number(&SIGMA_M)?,
        weight: section.number_or("weight", &WEIGHT, 1.0)?,
    })
}
