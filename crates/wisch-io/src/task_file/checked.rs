//! Checks the keys of a task file and converts them to its contents.

use super::clusters::heaps;
use super::deserialize::{At, record};
use super::execution::camera;
use super::outline::Outline;
use super::tables::{
    EdgeName, FrameName, ObjectTable, ParticlesTable, PatchName, PolishTable, RobotTable,
    ShapeName, SurfaceMeshTable, SurfaceTable, TaskTable,
};
use super::tree::{Source, description, integer};
use super::values::{AngleRad, Name, PositionM, QuaternionPart, mask, point};
use super::{
    Frame, Intent, NO_SKIM_OF_MESH, ObjectRecord, RobotDescription, RobotRecord, SCHEMA, Shape,
    SurfaceMesh, SurfacePatch, SurfaceRecord, TaskError, TaskFile, parts,
};
use crate::particles::ParticleSource;
use nalgebra::{Quaternion, Translation3, UnitQuaternion};
use toml::Spanned;
use toml::de::DeValue;
use wisch::follow::FollowConfig;
use wisch::geometry::{MAX_CHARTS, PartChoice, Pose, Vector2, Vector3};
use wisch::plan::{PlanConfig, SearchConfig, YawRule};
use wisch::represent::{Cone, Surface, SurfaceShape, Treatment};
use wisch::run::RunConfig;
use wisch::source_location::{Place, UnknownName};

/// Tolerance of a quaternion's norm around 1.
const QUATERNION_NORM_TOLERANCE: f64 = 1e-3;

pub(super) fn read(source: &Source<'_>) -> Result<TaskFile, TaskError> {
    let tree = parts::tree(source)?;
    // Another schema may have other keys, so the schema is checked first.
    schema(&tree, source)?;
    let file: At<TaskTable> = record(source, &tree)?;
    let task = &file.value;
    let (intent, intent_at) = intent(&file)?;
    let named = |name: Option<&At<Name>>| name.map_or(&intent_at, |name| &name.place).clone();
    let tool = task.tool.as_ref().map(|tool| &tool.value);
    let medium = task.medium.as_ref().map(|medium| &medium.value);
    let scene = scene(&task.scene)?;
    let mount = tool.and_then(|tool| tool.mount.as_ref());
    let mount = mount.map(super::mount::mount).transpose()?;
    let surface = surface(&task.surface, &scene)?;
    let robot = task.robot.as_ref().map(robot).transpose()?;
    let camera = camera(&task.perception)?;
    task.execution.check()?;
    let polish = task.polish.as_ref().map(polish).transpose()?;
    let particles = particle_source(&task.particles.value)?;
    let definitions = super::definitions::read(&file)?;
    let mut remarks = earlier_names(&tree, source);
    remarks.extend(surface.edge_numbers.clone());
    Ok(TaskFile {
        name: task.name.0.clone(),
        remarks,
        intent,
        strategy: task.strategy.as_ref().map(|name| name.0.clone()),
        run: run_config(task),
        robot,
        camera,
        particles,
        tool_at: named(tool.and_then(|tool| tool.name.as_ref())),
        tool_start: tool.and_then(|tool| tool.start_m).map(point),
        mount,
        medium_at: named(medium.and_then(|medium| medium.name.as_ref())),
        surface,
        collect_goal: (task.collect.as_ref())
            .and_then(|collect| collect.goal_m)
            .map(point),
        polish,
        dispense: task.dispense.as_ref().map(|dispense| Treatment::Dispense {
            thickness: dispense.thickness_m.0,
            volume_per_metre: dispense.volume_m3_per_m.0,
        }),
        scene,
        particles_at: file.value.particles.place,
        definitions,
        execution: file.value.execution,
    })
}

/// Returns a sentence for each key and value that has another name today.
fn earlier_names(tree: &Spanned<DeValue<'_>>, source: &Source<'_>) -> Vec<String> {
    let at = |key: &str| tree.get_ref().get(key);
    let holds_emit = |value: &&Spanned<DeValue<'_>>| value.get_ref().as_str() == Some("emit");
    let is_emitted = |goal: &&Spanned<DeValue<'_>>| {
        let text = goal.get_ref().as_str().unwrap_or_default();
        (text.trim_start().strip_prefix('('))
            .is_some_and(|words| words.trim_start().to_lowercase().starts_with("emitted"))
    };
    let actions = at("interaction").and_then(|table| table.get_ref().get("actions"));
    let actions = actions.and_then(|actions| actions.get_ref().as_array());
    [
        (
            at("action").filter(holds_emit),
            "action \"emit\"",
            "\"dispense\"",
        ),
        (
            actions.and_then(|actions| actions.iter().find(holds_emit)),
            "action \"emit\"",
            "\"dispense\"",
        ),
        (at("emit"), "table [emit]", "[dispense]"),
        (
            at("goal").filter(is_emitted),
            "predicate \"emitted\"",
            "\"dispensed\"",
        ),
    ]
    .into_iter()
    .filter_map(|(value, what, name)| {
        let place = source.place(value?.span().start);
        Some(format!(
            "{place}: the {what} is called {name} today; the earlier name is still read"
        ))
    })
    .collect()
}

/// Returns the settings of the stages that the file states; the rest has its default.
fn run_config(task: &TaskTable) -> RunConfig {
    let (plan, execution) = (&task.plan, &task.execution);
    let yaw = plan.heading.into();
    RunConfig {
        plan: PlanConfig {
            seed: task.seed.0,
            bandwidth: plan.bandwidth_m.map(|h| h.0),
            yaw,
            lift_height: plan.lift_height_m.0,
            max_distance: plan.max_distance_m.map(|most| most.0),
            search: SearchConfig {
                evaluations: plan.evaluations.0 as usize,
                margin_m: plan.margin_m.0,
            },
            ..PlanConfig::default()
        },
        variants: plan.variants.0 as usize,
        follow: FollowConfig {
            contact_speed: plan.contact_speed_m_per_s.0,
            free_speed: (plan.free_speed_m_per_s).map_or(f64::INFINITY, |speed| speed.0),
            // A rule that the user has chosen is not changed.
            free_yaw: yaw == YawRule::Best,
            ..FollowConfig::default()
        },
        target: task.target_performance.0,
        min_score: plan.min_score.0,
        max_rounds: execution.max_rounds.0 as usize,
        pace: execution.pace.into(),
        end_strokes_early: execution.end_strokes_early,
        after_stop: execution.after_stop.into(),
        on_warning: execution.on_warning.into(),
        false_warning_rate: execution.false_warning_rate.0,
        start_tolerance: execution.start_rad.0,
        ..RunConfig::default()
    }
}

fn polish(table: &PolishTable) -> Result<Treatment, TaskError> {
    let passes = table.passes.0 as u32;
    let max_passes = match &table.max_passes {
        Some(most) if (most.value.0 as u32) < passes => {
            let most_passes = most.value.0;
            let problem = format!("{most_passes} is below polish.passes = {passes}");
            return Err(most.inconsistent(problem));
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

fn schema(tree: &Spanned<DeValue<'_>>, source: &Source<'_>) -> Result<(), TaskError> {
    let Some(found) = tree.get_ref().get("schema") else {
        return Ok(());
    };
    match found.get_ref() {
        DeValue::Integer(number) if integer(number) == Some(i128::from(SCHEMA)) => Ok(()),
        other => Err(TaskError::Schema {
            at: source.place(found.span().start),
            found: description(other),
        }),
    }
}

fn intent(file: &At<TaskTable>) -> Result<(Intent, Place), TaskError> {
    let task = &file.value;
    file.exactly_one(&[
        ("action", task.action.as_ref().map(|action| &action.place)),
        ("goal", task.goal.as_ref().map(|goal| &goal.place)),
    ])?;
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
        return Ok((intent, goal.place.clone()));
    }
    let action = (task.action.as_ref()).ok_or_else(|| file.missing("action"))?;
    let at = action.place.clone();
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

fn surface(table: &At<SurfaceTable>, scene: &[ObjectRecord]) -> Result<SurfaceRecord, TaskError> {
    let surface = &table.value;
    table.exactly_one(&[
        ("size_m", surface.size_m.as_ref().map(|size| &size.place)),
        (
            "outline_m",
            surface.outline_m.as_ref().map(|outline| &outline.place),
        ),
        ("mesh", surface.mesh.as_ref().map(|mesh| &mesh.place)),
    ])?;
    let outline = match (&surface.size_m, &surface.outline_m) {
        (Some(size), _) => Outline::rectangle(Vector2::from(size.value.map(|side| side.0))),
        (None, Some(outline)) => Outline::read(outline)?,
        (None, None) if surface.mesh.is_some() => {
            let of_outline = "is that of an outline; the mesh has its own";
            if let Some(hole) = surface.holes_m.first() {
                return Err(hole.inconsistent(of_outline));
            }
            if let Some(edge) = surface.skim_edges.first() {
                return Err(edge.inconsistent(NO_SKIM_OF_MESH));
            }
            // Replaced by the border of the mesh.
            Outline::rectangle(Vector2::new(1.0, 1.0))
        }
        (None, None) => return Err(table.missing("size_m")),
    }
    .with_holes(&surface.holes_m)?;
    let mut skim_edges = Vec::new();
    for item in &surface.skim_edges {
        let typed = match item.value {
            EdgeName::OfRectangle(_) if surface.size_m.is_none() => {
                return Err(item.inconsistent(
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
                            at: item.place.clone(),
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
            return Err(item.inconsistent("the edge is given twice"));
        }
        skim_edges.push(edge);
    }
    let carried_by = match &surface.carried_by {
        Some(name) => {
            let index = scene.iter().position(|object| object.name == name.value);
            Some(index.ok_or_else(|| TaskError::UnknownReference {
                at: name.place.clone(),
                unknown: Box::new(UnknownName::new(
                    "scene object",
                    &name.value,
                    scene.iter().map(|object| object.name.as_str()),
                )),
            })?)
        }
        None => None,
    };
    let mut record = SurfaceRecord {
        at: surface.name.place.clone(),
        edge_numbers: outline.describe_numbering(),
        surface: Surface {
            name: surface.name.value.0.clone(),
            outline: outline.polygon,
            world_from_surface: pose(
                table,
                surface.position_m,
                surface.rpy_rad,
                surface.quaternion_xyzw.as_ref(),
            )?,
            skim_edges,
            shape: SurfaceShape::Plane,
        },
        mesh: surface.mesh.as_ref().map(surface_mesh).transpose()?,
        carried_by,
    };
    record.surface.shape = surface_shape(table)?;
    if let Some(fault) = record.surface.shape_fault() {
        return Err(table.inconsistent(fault.to_string()));
    }
    Ok(record)
}

fn surface_mesh(table: &At<SurfaceMeshTable>) -> Result<SurfaceMesh, TaskError> {
    let mesh = &table.value;
    let patch = mesh.patch.as_ref().map(|patch| {
        let chosen = match patch.value {
            PatchName::All => SurfacePatch::All,
            PatchName::Numbered(number) if (1..=MAX_CHARTS as u64).contains(&number) => {
                SurfacePatch::Indexed(number as usize - 1)
            }
            PatchName::Numbered(number) => {
                let problem = format!("{number} is outside 1 to {MAX_CHARTS}");
                return Err(patch.inconsistent(problem));
            }
        };
        Ok((chosen, patch.place.clone()))
    });
    let vector = |given: &[PositionM; 3]| Vector3::from(given.map(|x| x.0));
    Ok(SurfaceMesh {
        at: mesh.file.place.clone(),
        file: mesh.file.value.0.clone(),
        scale: mesh.scale.0,
        choice: PartChoice {
            seed_point: mesh.seed_point_m.as_ref().map(|point| vector(point).into()),
            towards: mesh.towards.as_ref().map(vector),
            largest_lean: mesh.largest_lean_rad.map(|lean| lean.0),
        },
        patch: patch.transpose()?,
    })
}

/// Reads the shape of a surface.
fn surface_shape(table: &At<SurfaceTable>) -> Result<SurfaceShape, TaskError> {
    let surface = &table.value;
    let only_of_round =
        "is that of a cylinder or a cone; set surface.shape = \"cylinder\" or \"cone\"";
    let only_of_cones = "is that of a cone; set surface.shape = \"cone\"";
    let shape = match surface.shape {
        ShapeName::Plane => None,
        ShapeName::Cylinder => Some("cylinder"),
        ShapeName::Cone => Some("cone"),
    };
    if let (Some(mesh), Some(shape)) = (&surface.mesh, shape) {
        return Err(mesh.inconsistent(format!("has its own shape; remove shape = \"{shape}\"")));
    }
    if let (ShapeName::Plane | ShapeName::Cylinder, Some(angle)) =
        (surface.shape, &surface.half_angle_rad)
    {
        return Err(angle.inconsistent(only_of_cones));
    }
    let axis = (surface.axis_rad.as_ref()).map_or(0.0, |axis| axis.value.0);
    match (surface.shape, &surface.radius_m, &surface.axis_rad) {
        (ShapeName::Plane, None, None) => Ok(SurfaceShape::Plane),
        (ShapeName::Plane, Some(radius), _) => Err(radius.inconsistent(only_of_round)),
        (ShapeName::Plane, None, Some(axis)) => Err(axis.inconsistent(only_of_round)),
        (ShapeName::Cylinder | ShapeName::Cone, None, _) => Err(table.missing("radius_m")),
        (ShapeName::Cylinder, Some(radius), _) => Ok(SurfaceShape::Cylinder {
            radius: radius.value.0,
            axis,
        }),
        (ShapeName::Cone, Some(radius), _) => {
            let Some(angle) = &surface.half_angle_rad else {
                return Err(table.missing("half_angle_rad"));
            };
            Ok(SurfaceShape::Cone(Cone {
                radius: radius.value.0,
                half_angle: angle.value.0,
                axis,
            }))
        }
    }
}

fn robot(table: &At<RobotTable>) -> Result<RobotRecord, TaskError> {
    let robot = &table.value;
    table.exactly_one(&[
        ("name", robot.name.as_ref().map(|name| &name.place)),
        ("urdf", robot.urdf.as_ref().map(|urdf| &urdf.place)),
    ])?;
    let text = |name: &Option<Name>| name.as_ref().map(|name| name.0.clone());
    let srdf = text(&robot.srdf);
    let description = match (&robot.name, &robot.urdf) {
        (Some(_), _) if srdf.is_some() => {
            return Err(table.inconsistent("srdf needs urdf; a shipped robot has its own SRDF"));
        }
        (Some(_), _) if robot.packages.is_some() => {
            return Err(table.inconsistent("packages needs urdf; a shipped robot has no meshes"));
        }
        (Some(name), _) => RobotDescription::Named(name.value.0.clone()),
        (None, Some(urdf)) => RobotDescription::Files {
            urdf: urdf.value.0.clone(),
            srdf,
            packages: (robot.packages.iter().flatten())
                .map(|(name, folder)| (name.clone(), folder.0.clone()))
                .collect(),
        },
        (None, None) => return Err(table.missing("name")),
    };
    let quaternion = robot.quaternion_xyzw.as_ref();
    let is_turned = robot.rpy_rad.is_some() || quaternion.is_some();
    Ok(RobotRecord {
        description,
        group: text(&robot.group),
        second_group: text(&robot.second_group),
        world_from_robot: match robot.position_m {
            Some(position) => Some(pose(table, Some(position), robot.rpy_rad, quaternion)?),
            None if is_turned => {
                return Err(table.inconsistent("a rotation needs position_m, too"));
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
                return Err(given.inconsistent(format!(
                    "its norm is {norm}, but must be within {QUATERNION_NORM_TOLERANCE} of 1"
                )));
            }
            UnitQuaternion::from_quaternion(quaternion)
        }
        (Some(_), Some(_)) => {
            return Err(table.inconsistent("rpy_rad and quaternion_xyzw exclude each other"));
        }
    };
    Ok(Pose::from_parts(Translation3::from(position), rotation))
}

fn scene(tables: &[At<ObjectTable>]) -> Result<Vec<ObjectRecord>, TaskError> {
    let mut objects: Vec<ObjectRecord> = Vec::new();
    let mut places = std::collections::BTreeMap::new();
    for table in tables {
        let object = &table.value;
        let name = object.name.value.0.clone();
        let at = object.name.place.clone();
        if let Some(first) = places.insert(name.clone(), at.clone()) {
            let problem = format!("{name:?} is already defined at {first}");
            return Err(object.name.inconsistent(problem));
        }
        objects.push(ObjectRecord {
            at,
            name,
            shape: shape(table)?,
            frame: match object.frame {
                FrameName::World => Frame::World,
                FrameName::Surface => Frame::Surface,
            },
            frame_from_object: pose(
                table,
                object.position_m,
                object.rpy_rad,
                object.quaternion_xyzw.as_ref(),
            )?,
            part: object.role.into(),
        });
    }
    Ok(objects)
}

fn shape(table: &At<ObjectTable>) -> Result<Shape, TaskError> {
    let object = &table.value;
    table.exactly_one(&[
        ("box_m", object.box_m.as_ref().map(|shape| &shape.place)),
        (
            "cylinder",
            object.cylinder.as_ref().map(|shape| &shape.place),
        ),
        ("sphere", object.sphere.as_ref().map(|shape| &shape.place)),
        ("capsule", object.capsule.as_ref().map(|shape| &shape.place)),
        ("mesh", object.mesh.as_ref().map(|shape| &shape.place)),
    ])?;
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
    let mesh = (object.mesh.as_ref()).ok_or_else(|| table.missing("mesh"))?;
    Ok(Shape::Mesh {
        at: mesh.value.file.place.clone(),
        file: mesh.value.file.value.0.clone(),
        scale: mesh.value.scale.0,
    })
}

fn particle_source(table: &ParticlesTable) -> Result<ParticleSource, TaskError> {
    Ok(match table {
        ParticlesTable::Surface { count } => ParticleSource::Surface {
            count: count.0 as usize,
        },
        ParticlesTable::Uniform { count } => ParticleSource::Uniform {
            count: count.0 as usize,
        },
        ParticlesTable::Clusters { count, clusters } => ParticleSource::Clusters {
            count: count.0 as usize,
            clusters: heaps(clusters)?,
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
        } => ParticleSource::Image(mask(file, corners_px, color, *tolerance, *count)),
    })
}
