//! Checks the keys of a task file and converts them to its contents.

use super::clusters::heaps;
use super::deserialize::{At, record};
use super::execution::{execution, perception};
use super::mount::mount;
use super::outline::Outline;
use super::tables::{
    EdgeName, FrameName, ObjectTable, ParticlesTable, PolishTable, RobotTable, SurfaceTable,
    TaskTable,
};
use super::tree::{Node, Source, Value};
use super::values::{AngleRad, Name, PositionM, QuaternionPart, point};
use super::{
    Frame, Intent, ObjectRecord, RobotDescription, RobotRecord, SCHEMA, Shape, SurfaceRecord,
    TaskError, TaskFile,
};
use crate::particles::{MaskSource, ParticleSource};
use nalgebra::{Quaternion, Translation3, UnitQuaternion};
use wisch::geometry::{Pose, Vector2, Vector3};
use wisch::represent::{Surface, Treatment};
use wisch::source_location::{Place, UnknownName};

/// Tolerance of a quaternion's norm around 1.
const QUATERNION_NORM_TOLERANCE: f64 = 1e-3;

pub(super) fn read(source: &Source<'_>) -> Result<TaskFile, TaskError> {
    let tree = source.tree()?;
    // Another schema may have other keys, so the schema is checked first.
    schema(&tree, source)?;
    let file: At<TaskTable> = record(source, &tree)?;
    let task = &file.value;
    let (intent, intent_at) = intent(&file, source)?;
    let named = |name: Option<&At<Name>>| name.map_or(intent_at.clone(), |name| name.place(source));
    let tool = task.tool.as_ref().map(|tool| &tool.value);
    let medium = task.medium.as_ref().map(|medium| &medium.value);
    let scene = scene(&task.scene, source)?;
    Ok(TaskFile {
        name: task.name.0.clone(),
        seed: task.seed.0,
        strategy: task.strategy.as_ref().map(|name| name.0.clone()),
        target_performance: task.target_performance.0,
        tool_at: named(tool.and_then(|tool| tool.name.as_ref())),
        tool_start: tool.and_then(|tool| tool.start_m).map(point),
        mount: (tool.and_then(|tool| tool.mount.as_ref()))
            .map(|table| mount(table, source))
            .transpose()?,
        medium_at: named(medium.and_then(|medium| medium.name.as_ref())),
        surface: surface(&task.surface, &scene, source)?,
        robot: task
            .robot
            .as_ref()
            .map(|table| robot(table, source))
            .transpose()?,
        perception: perception(&task.perception, source)?,
        execution: execution(&task.execution, source)?,
        max_rounds: task.execution.max_rounds.0 as usize,
        end_strokes_early: task.execution.end_strokes_early,
        pace: task.execution.pace.into(),
        after_stop: task.execution.after_stop.into(),
        start_rad: task.execution.start_rad.0,
        collect_goal: (task.collect.as_ref())
            .and_then(|collect| collect.goal_m)
            .map(point),
        polish: (task.polish.as_ref())
            .map(|table| polish(table, source))
            .transpose()?,
        emit: task.emit.as_ref().map(|emit| Treatment::Emit {
            thickness: emit.thickness_m.0,
            volume_per_metre: emit.volume_m3_per_m.0,
        }),
        particles_at: task.particles.place(source),
        particles: particle_source(&task.particles.value, source)?,
        scene,
        bandwidth: task.plan.bandwidth_m.map(|h| h.0),
        yaw: task.plan.heading.into(),
        lift_height: task.plan.lift_height_m.0,
        evaluations: task.plan.evaluations.0 as usize,
        margin: task.plan.margin_m.0,
        max_distance: task.plan.max_distance_m.map(|most| most.0),
        contact_speed: task.plan.contact_speed_m_per_s.0,
        free_speed: task.plan.free_speed_m_per_s.map(|speed| speed.0),
        variants: task.plan.variants.0 as usize,
        min_score: task.plan.min_score.0,
        definitions: super::definitions::read(&file, source)?,
        intent,
    })
}

fn polish(table: &PolishTable, source: &Source<'_>) -> Result<Treatment, TaskError> {
    let passes = table.passes.0 as u32;
    let max_passes = match &table.max_passes {
        Some(most) if (most.value.0 as u32) < passes => {
            let most_passes = most.value.0;
            let problem = format!("{most_passes} is below polish.passes = {passes}");
            return Err(most.inconsistent(source, problem));
        }
        Some(most) => most.value.0 as u32,
        None => passes + 1,
    };
    Ok(Treatment::Polish {
        passes,
        max_passes,
        preston: table.preston_per_pa.map(|coefficient| coefficient.0),
    })
}

fn schema(tree: &Value, source: &Source<'_>) -> Result<(), TaskError> {
    let Node::Table(entries) = &tree.node else {
        return Ok(());
    };
    let Some(entry) = entries.iter().find(|entry| entry.key == "schema") else {
        return Ok(());
    };
    match entry.value.node {
        Node::Integer(found) if found == i128::from(SCHEMA) => Ok(()),
        ref other => Err(TaskError::Schema {
            at: source.place(entry.value.offset),
            found: other.description(),
        }),
    }
}

fn intent(file: &At<TaskTable>, source: &Source<'_>) -> Result<(Intent, Place), TaskError> {
    let task = &file.value;
    let offset = |at: &At<_>| at.offset;
    file.exactly_one(
        source,
        &[
            ("action", task.action.as_ref().map(offset)),
            ("goal", task.goal.as_ref().map(|goal| goal.offset)),
        ],
    )?;
    let text = |name: &Name| name.0.clone();
    let tool = task.tool.as_ref().map(|tool| &tool.value);
    let tool_name = tool.and_then(|tool| tool.name.as_ref());
    let tool_name = tool_name.map(|name| text(&name.value));
    if let Some(goal) = &task.goal {
        let in_hand = tool.and_then(|tool| tool.in_hand.as_ref()).map(text);
        let available = tool.and_then(|tool| tool.available.as_ref());
        let intent = Intent::Goal {
            literal: text(&goal.value),
            tool_in_hand: in_hand.or(tool_name),
            available_tools: available
                .map_or_else(Vec::new, |names| names.iter().map(text).collect()),
        };
        return Ok((intent, goal.place(source)));
    }
    let action = (task.action.as_ref()).ok_or_else(|| file.missing(source, "action"))?;
    let at = action.place(source);
    let missing = |table: &str| TaskError::Missing {
        at: at.clone(),
        table: table.to_owned(),
        key: "name",
    };
    let medium = task.medium.as_ref();
    let medium = medium.and_then(|medium| medium.value.name.as_ref());
    let intent = Intent::Action {
        action: action.value.into(),
        tool: tool_name.ok_or_else(|| missing("tool"))?,
        medium: text(&medium.ok_or_else(|| missing("medium"))?.value),
    };
    Ok((intent, at))
}

fn surface(
    table: &At<SurfaceTable>,
    scene: &[ObjectRecord],
    source: &Source<'_>,
) -> Result<SurfaceRecord, TaskError> {
    let surface = &table.value;
    table.exactly_one(
        source,
        &[
            ("size_m", surface.size_m.as_ref().map(|size| size.offset)),
            (
                "outline_m",
                surface.outline_m.as_ref().map(|outline| outline.offset),
            ),
        ],
    )?;
    let outline = match (&surface.size_m, &surface.outline_m) {
        (Some(size), _) => Outline::rectangle(Vector2::from(size.value.map(|side| side.0))),
        (None, Some(outline)) => Outline::read(outline, source)?,
        (None, None) => return Err(table.missing(source, "size_m")),
    }
    .with_holes(&surface.holes_m, source)?;
    let mut skim_edges = Vec::new();
    for item in &surface.skim_edges {
        let typed = match item.value {
            EdgeName::OfRectangle(_) if surface.size_m.is_none() => {
                return Err(item.inconsistent(
                    source,
                    "names of edges need size_m; for outline_m, use the numbers of edges",
                ));
            }
            EdgeName::OfRectangle(edge) => edge,
            EdgeName::FromPoint(point) => {
                let last = outline.polygon.outer().len() - 1;
                match usize::try_from(point) {
                    Ok(point) if point <= last => point,
                    _ => {
                        return Err(TaskError::OutOfRange {
                            at: item.place(source),
                            key: item.path.clone(),
                            value: point.to_string(),
                            limits: format!("at least 0 and at most {last}"),
                        });
                    }
                }
            }
        };
        let edge = outline.edge(typed);
        if skim_edges.contains(&edge) {
            return Err(item.inconsistent(source, "the edge is given twice"));
        }
        skim_edges.push(edge);
    }
    let carried_by = match &surface.carried_by {
        Some(name) => {
            let index = scene.iter().position(|object| object.name == name.value);
            Some(index.ok_or_else(|| TaskError::UnknownReference {
                at: name.place(source),
                unknown: Box::new(UnknownName::new(
                    "scene object",
                    &name.value,
                    scene.iter().map(|object| object.name.as_str()),
                )),
            })?)
        }
        None => None,
    };
    Ok(SurfaceRecord {
        at: surface.name.place(source),
        surface: Surface {
            name: surface.name.value.0.clone(),
            outline: outline.polygon,
            world_from_surface: pose(
                table,
                surface.position_m,
                surface.rpy_rad,
                surface.quaternion_xyzw.as_ref(),
                source,
            )?,
            skim_edges,
        },
        carried_by,
    })
}

fn robot(table: &At<RobotTable>, source: &Source<'_>) -> Result<RobotRecord, TaskError> {
    let robot = &table.value;
    table.exactly_one(
        source,
        &[
            ("name", robot.name.as_ref().map(|name| name.offset)),
            ("urdf", robot.urdf.as_ref().map(|urdf| urdf.offset)),
        ],
    )?;
    let text = |name: &Option<Name>| name.as_ref().map(|name| name.0.clone());
    let srdf = text(&robot.srdf);
    let description = match (&robot.name, &robot.urdf) {
        (Some(_), _) if srdf.is_some() => {
            return Err(
                table.inconsistent(source, "srdf needs urdf; a shipped robot has its own SRDF")
            );
        }
        (Some(_), _) if robot.packages.is_some() => {
            return Err(
                table.inconsistent(source, "packages needs urdf; a shipped robot has no meshes")
            );
        }
        (Some(name), _) => RobotDescription::Named(name.value.0.clone()),
        (None, Some(urdf)) => RobotDescription::Files {
            urdf: urdf.value.0.clone(),
            srdf,
            packages: (robot.packages.iter().flatten())
                .map(|(name, folder)| (name.clone(), folder.0.clone()))
                .collect(),
        },
        (None, None) => return Err(table.missing(source, "name")),
    };
    let quaternion = robot.quaternion_xyzw.as_ref();
    let is_turned = robot.rpy_rad.is_some() || quaternion.is_some();
    Ok(RobotRecord {
        description,
        group: text(&robot.group),
        second_group: text(&robot.second_group),
        world_from_robot: match robot.position_m {
            Some(position) => Some(pose(
                table,
                Some(position),
                robot.rpy_rad,
                quaternion,
                source,
            )?),
            None if is_turned => {
                return Err(table.inconsistent(source, "a rotation needs position_m, too"));
            }
            None => None,
        },
    })
}

/// Reads a pose from the optional keys of a table: a position and one of two forms of a rotation.
fn pose<T>(
    table: &At<T>,
    position: Option<[PositionM; 3]>,
    rpy: Option<[AngleRad; 3]>,
    quaternion: Option<&At<[QuaternionPart; 4]>>,
    source: &Source<'_>,
) -> Result<Pose, TaskError> {
    let position = position.map_or_else(Vector3::zeros, |p| Vector3::from(p.map(|x| x.0)));
    let rotation = match (rpy, quaternion) {
        (None, None) => UnitQuaternion::identity(),
        (Some([roll, pitch, yaw]), None) => {
            UnitQuaternion::from_euler_angles(roll.0, pitch.0, yaw.0)
        }
        (None, Some(given)) => {
            let [x, y, z, w] = given.value.map(|part| part.0);
            let quaternion = Quaternion::new(w, x, y, z);
            let norm = quaternion.norm();
            if (norm - 1.0).abs() > QUATERNION_NORM_TOLERANCE {
                return Err(given.inconsistent(
                    source,
                    format!(
                        "its norm is {norm}, but must be within {QUATERNION_NORM_TOLERANCE} of 1"
                    ),
                ));
            }
            UnitQuaternion::from_quaternion(quaternion)
        }
        (Some(_), Some(_)) => {
            return Err(
                table.inconsistent(source, "rpy_rad and quaternion_xyzw exclude each other")
            );
        }
    };
    Ok(Pose::from_parts(Translation3::from(position), rotation))
}

fn scene(tables: &[At<ObjectTable>], source: &Source<'_>) -> Result<Vec<ObjectRecord>, TaskError> {
    let mut objects: Vec<ObjectRecord> = Vec::new();
    let mut places = std::collections::BTreeMap::new();
    for table in tables {
        let object = &table.value;
        let name = object.name.value.0.clone();
        let at = object.name.place(source);
        if let Some(first) = places.insert(name.clone(), at.clone()) {
            let problem = format!("{name:?} is already defined at {first}");
            return Err(object.name.inconsistent(source, problem));
        }
        objects.push(ObjectRecord {
            at,
            name,
            shape: shape(table, source)?,
            frame: match object.frame {
                FrameName::World => Frame::World,
                FrameName::Surface => Frame::Surface,
            },
            frame_from_object: pose(
                table,
                object.position_m,
                object.rpy_rad,
                object.quaternion_xyzw.as_ref(),
                source,
            )?,
            part: object.role.into(),
        });
    }
    Ok(objects)
}

fn shape(table: &At<ObjectTable>, source: &Source<'_>) -> Result<Shape, TaskError> {
    let object = &table.value;
    table.exactly_one(
        source,
        &[
            ("box_m", object.box_m.as_ref().map(|shape| shape.offset)),
            (
                "cylinder",
                object.cylinder.as_ref().map(|shape| shape.offset),
            ),
            ("sphere", object.sphere.as_ref().map(|shape| shape.offset)),
            ("capsule", object.capsule.as_ref().map(|shape| shape.offset)),
            ("mesh", object.mesh.as_ref().map(|shape| shape.offset)),
        ],
    )?;
    if let Some(size) = &object.box_m {
        return Ok(Shape::Box(Vector3::from(size.value.map(|side| side.0))));
    }
    if let Some(At { value, .. }) = &object.cylinder {
        return Ok(Shape::Cylinder {
            radius: value.radius_m.0,
            height: value.height_m.0,
        });
    }
    if let Some(At { value, .. }) = &object.sphere {
        return Ok(Shape::Sphere {
            radius: value.radius_m.0,
        });
    }
    if let Some(At { value, .. }) = &object.capsule {
        return Ok(Shape::Capsule {
            radius: value.radius_m.0,
            height: value.height_m.0,
        });
    }
    let mesh = (object.mesh.as_ref()).ok_or_else(|| table.missing(source, "mesh"))?;
    Ok(Shape::Mesh {
        at: mesh.value.file.place(source),
        file: mesh.value.file.value.0.clone(),
        scale: mesh.value.scale.0,
    })
}

fn particle_source(
    table: &ParticlesTable,
    source: &Source<'_>,
) -> Result<ParticleSource, TaskError> {
    Ok(match table {
        ParticlesTable::Surface { count } => ParticleSource::Surface {
            count: count.0 as usize,
        },
        ParticlesTable::Uniform { count } => ParticleSource::Uniform {
            count: count.0 as usize,
        },
        ParticlesTable::Clusters { count, clusters } => ParticleSource::Clusters {
            count: count.0 as usize,
            clusters: heaps(clusters, source)?,
        },
        ParticlesTable::Csv { file } => ParticleSource::Csv {
            file: file.0.clone(),
        },
        ParticlesTable::Image {
            file,
            corners_px,
            color,
            tolerance,
            count,
        } => ParticleSource::Image(MaskSource {
            file: file.0.clone(),
            corners_px: corners_px.map(|corner| corner.map(|x| x.0).into()),
            color: color.map(|channel| channel.0 as u8),
            tolerance: tolerance.0,
            count: count.0 as usize,
        }),
    })
}
