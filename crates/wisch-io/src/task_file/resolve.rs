//! Resolves a task file: looks up knowledge, reads files and places particles.

use super::extent::{USUAL_OBJECT, USUAL_SURFACE, check_object, check_tool};
use super::{
    Frame, NO_SKIM_OF_MESH, ObjectRecord, Shape, SurfaceMesh, SurfacePatch, TaskError, TaskFile,
};
use crate::particles::{ParticleSource, csv_particles, mask_particles};
use crate::shell::shell_word;
use std::sync::{Arc, Mutex, PoisonError};
use wisch::geometry::{
    Atlas, Bounds2, MAX_CHARTS, Mesh, MeshError, MeshFormat, Point2, Polygon, Pose, RIGID_DEPTH,
    Region, SheetConfig, SheetError, Vector2, Vector3, footprint,
};
use wisch::represent::{
    Action, DirtArea, DirtMobility, Interaction, KnowledgeBase, MeshShape, Mount,
    ParticleDistribution, SceneObject, ScenePart, Surface, SurfaceShape, Task, Tool, ToolEntry,
    ToolMesh, Treatment, cluster_particles, surface_cells, uniform_particles,
};
use wisch::source_location::Place;

/// A function that reads a file by its path, or returns the reason why it cannot.
pub type ReadFile<'a> = dyn FnMut(&str) -> Result<Vec<u8>, String> + 'a;

/// Number of segments around cylinders, spheres and capsules; the error is 2 mm at a radius of 1 m.
const SEGMENTS: u32 = 48;
/// Largest number of particles of a film that runs: each step compares the particles of a column with each other.
const MAX_FILM: usize = 50_000;

impl TaskFile {
    /// Returns the task for an action with a tool on a medium: looks up the tool's mesh and interaction, reads the scene's
    /// meshes, and places the particles.
    ///
    /// - `assets`: reads a file of the task, by its path relative to the task file.
    /// - `knowledge_assets`: reads a tool's mesh, by its path relative to the knowledge files.
    ///
    /// Equal arguments give an equal task, byte for byte.
    ///
    /// # Errors
    /// If the knowledge base has no interaction of tool, medium and surface, if that does not allow the action, if a file
    /// is missing or invalid, or if the particles cannot be placed. The error states the location in the task file.
    #[expect(
        clippy::too_many_arguments,
        reason = "each has its own meaning, and none has a default"
    )]
    pub fn resolve(
        &self,
        action: Action,
        tool: &str,
        medium: &str,
        seed: u64,
        knowledge: &KnowledgeBase,
        assets: &mut ReadFile<'_>,
        knowledge_assets: &mut ReadFile<'_>,
    ) -> Result<Task, TaskError> {
        let surface = &self.surface.surface;
        let tool_at = &self.tool_at;
        let unknown = |error| self.unknown(error, tool_at);
        knowledge.surface(&surface.name).map_err(unknown)?;
        knowledge.medium(medium).map_err(unknown)?;
        let entry = knowledge.tool(tool).map_err(unknown)?;
        let interaction = (knowledge.interaction(tool, medium, &surface.name)).map_err(unknown)?;
        if !interaction.actions.contains(&action) {
            let known: Vec<_> = interaction.actions.iter().map(|a| a.as_str()).collect();
            let known = match &known[..] {
                [others @ .., last] if !others.is_empty() => {
                    format!("{} and {last}", others.join(", "))
                }
                one => one.concat(),
            };
            return Err(TaskError::Inconsistent {
                at: tool_at.clone(),
                key: "tool".to_owned(),
                problem: format!(
                    "{tool} cannot {action} {medium} on {} according to the knowledge base, only {}; choose another tool or action, or set interaction.actions",
                    surface.name, known
                ),
            });
        }
        if action == Action::Skim {
            self.check_skim_edges()?;
        }
        let treatment = self.treatment(action)?;
        let mesh = match &entry.mesh {
            ToolMesh::InKnowledge(file) => parsed_mesh(knowledge_assets, tool_at, file)?,
            ToolMesh::BesideTask(file) => parsed_mesh(assets, tool_at, file)?,
            ToolMesh::Cuboid(size) => cuboid_on_plane(*size).map_err(|error| TaskError::Mesh {
                at: tool_at.clone(),
                error,
            })?,
        };
        if let ToolMesh::InKnowledge(file) | ToolMesh::BesideTask(file) = &entry.mesh {
            check_tool(&mesh, (file, tool_at))?;
        }
        check_compression(&mesh, interaction, tool_at)?;
        let tool = Tool {
            mount: self.mount.or(entry.grip.map(Mount::Grip)),
            ..resolved_tool(entry, mesh, interaction, tool_at)?
        };
        let (surface, rest) = self.surface(&tool, assets)?;
        let mut scene = self.scene(&surface, assets)?;
        scene.extend(rest);
        let mut task = Task {
            name: self.name.clone(),
            action,
            tool_start: (self.tool_start).unwrap_or_else(|| start_before(&surface.outline)),
            surface,
            scene,
            tool,
            medium: medium.to_owned(),
            mobility: DirtMobility::Unknown,
            interaction: interaction.clone(),
            particles: ParticleDistribution::default(),
            collect_goal: self.collect_goal,
            treatment,
            seed,
        };
        let area = DirtArea {
            outline: &task.surface.outline,
            occupied: &task.occupied_area(),
        };
        task.particles = self.particles(area, seed, assets)?;
        task.mobility = self.mobility(knowledge, medium, task.particles.len());
        let count = task.particles.len();
        if task.has_running_film() && count > MAX_FILM {
            return Err(TaskError::Inconsistent {
                at: self.particles_at.clone(),
                key: "particles".to_owned(),
                problem: format!(
                    "{count} particles exceed the limit of {MAX_FILM} for a film that runs down; give fewer, or no medium.volume_m3"
                ),
            });
        }
        Ok(task)
    }

    /// Checks that the surface has edges over which a skim can push the dirt.
    fn check_skim_edges(&self) -> Result<(), TaskError> {
        let (at, key, problem) = match &self.surface.mesh {
            Some(mesh) => (&mesh.at, "surface.mesh", NO_SKIM_OF_MESH),
            None if self.surface.surface.skim_edges.is_empty() => (
                &self.surface.at,
                "surface",
                "key \"skim_edges\" is missing: a skim pushes the dirt over edges of the surface, such as skim_edges = [\"y_min\"]",
            ),
            None => return Ok(()),
        };
        Err(TaskError::Inconsistent {
            at: at.clone(),
            key: key.to_owned(),
            problem: problem.to_owned(),
        })
    }

    /// Returns the treatment of an action that treats the surface; `None` for an action that moves dirt.
    fn treatment(&self, action: Action) -> Result<Option<Treatment>, TaskError> {
        let (given, table, key) = match action {
            Action::Polish => (self.polish, "polish", "passes"),
            Action::Dispense => (self.dispense, "dispense", "thickness_m"),
            Action::Absorb | Action::Collect | Action::Skim => return Ok(None),
        };
        let at = self.tool_at.clone();
        if given.is_none() {
            let table = table.to_owned();
            return Err(TaskError::Missing { at, table, key });
        }
        if self.camera.is_some() {
            return Err(TaskError::Inconsistent {
                at,
                key: "perception.senses".to_owned(),
                problem: format!(
                    "\"sight\" does not work with the action {action}: the camera detects dirt only"
                ),
            });
        }
        Ok(given)
    }

    /// Whether the task is to wipe all patches of a divided mesh, one after another.
    pub fn wipes_all_patches(&self) -> bool {
        let patch = self
            .surface
            .mesh
            .as_ref()
            .and_then(|mesh| mesh.patch.as_ref());
        patch.is_some_and(|(patch, _)| *patch == SurfacePatch::All)
    }

    /// Returns the surface; of a mesh, with the chart at the scale of a tool. Of a patch, also returns the other patches,
    /// which carry it.
    fn surface(
        &self,
        tool: &Tool,
        assets: &mut ReadFile<'_>,
    ) -> Result<(Surface, Option<SceneObject>), TaskError> {
        let surface = self.surface.surface.clone();
        let Some(SurfaceMesh {
            at,
            file,
            scale,
            choice,
            patch,
        }) = &self.surface.mesh
        else {
            return Ok((surface, None));
        };
        let mesh = scaled_mesh(parsed_mesh(assets, at, file)?, *scale);
        let mesh = mesh.map_err(|error| TaskError::Mesh {
            at: at.clone(),
            error,
        })?;
        check_object(&mesh, (file, at), *scale, USUAL_SURFACE)?;
        let config = SheetConfig {
            tool_radius: tool.collision_radius(),
            choice: *choice,
            ..SheetConfig::default()
        };
        let unusable = |error: SheetError| {
            let radius = config.tool_radius;
            // The path of the file counts from the task's folder.
            let mut mesh = shell_word(file);
            if *scale != 1.0 {
                mesh += &format!(" --scale {scale}");
            }
            let advice = match (&error, patch) {
                // With the radius to the last digit, the command finds the patches of this task.
                (
                    SheetError::Stretched { .. }
                    | SheetError::Folded { .. }
                    | SheetError::Overlapping { .. },
                    None,
                ) => format!(
                    "surface.mesh.patch takes a part of it, see wisch surface split {mesh} --tool-radius {radius} in the task's folder"
                ),
                _ => format!(
                    "wisch surface check {mesh} --tool-radius {radius} in the task's folder shows more"
                ),
            };
            TaskError::File {
                at: at.clone(),
                file: file.clone(),
                problem: format!("not usable as a surface: {error}; {advice}"),
            }
        };
        let world_from_mesh = surface.world_from_surface;
        let (shape, mesh_from_surface, rest) = match patch {
            None => {
                let (shape, pose) = MeshShape::from_mesh(&mesh, &config).map_err(unusable)?;
                (shape, pose, None)
            }
            Some((patch, patch_at)) => {
                let atlas = divide(&mesh, &config).map_err(unusable)?;
                let index = index_of_patch(*patch, patch_at, atlas.charts().len())?;
                let (shape, pose) = MeshShape::from_patch(&mesh, &atlas, index);
                let rest = atlas.rest_mesh(index);
                let rest = rest.map(|rest| self.rest_of_surface(rest, world_from_mesh));
                (shape, pose, rest)
            }
        };
        let surface = Surface {
            outline: shape.outline(),
            world_from_surface: world_from_mesh * mesh_from_surface,
            shape: SurfaceShape::Mesh(Arc::new(shape)),
            ..surface
        };
        Ok((surface, rest))
    }

    /// Returns the other patches of a surface as an object that the robot avoids, and that the tool touches where it reaches
    /// over a seam.
    fn rest_of_surface(&self, mesh: Mesh, world_from_mesh: Pose) -> SceneObject {
        let mut name = format!("other patches of {}", self.surface.surface.name);
        while self.scene.iter().any(|object| object.name == name) {
            name.push('\'');
        }
        SceneObject {
            name,
            part: ScenePart::Carrier,
            mesh,
            world_from_object: world_from_mesh,
        }
    }

    /// Returns the objects of the scene with their roles.
    fn scene(
        &self,
        surface: &Surface,
        assets: &mut ReadFile<'_>,
    ) -> Result<Vec<SceneObject>, TaskError> {
        let world_from_surface = surface.world_from_surface;
        (self.scene.iter().enumerate())
            .map(|(i, object)| {
                Ok(SceneObject {
                    name: object.name.clone(),
                    part: match self.surface.carried_by {
                        Some(carrier) if carrier == i => ScenePart::Carrier,
                        _ => object.part,
                    },
                    mesh: object.mesh(assets)?,
                    world_from_object: match object.frame {
                        Frame::World => object.frame_from_object,
                        Frame::Surface => world_from_surface * object.frame_from_object,
                    },
                })
            })
            .collect()
    }

    fn particles(
        &self,
        area: DirtArea<'_>,
        seed: u64,
        assets: &mut ReadFile<'_>,
    ) -> Result<ParticleDistribution, TaskError> {
        let at = &self.particles_at;
        let particles = match &self.particles {
            ParticleSource::Surface { count } => surface_cells(area, *count).map_err(Into::into),
            ParticleSource::Uniform { count } => {
                uniform_particles(area, *count, seed).map_err(Into::into)
            }
            ParticleSource::Clusters { count, clusters } => {
                cluster_particles(area, clusters, *count, seed).map_err(Into::into)
            }
            ParticleSource::Csv { file } => {
                let text = read(assets, at, file)?;
                csv_particles(file, &text, area)
            }
            ParticleSource::Image(mask) => {
                let bytes = read(assets, at, &mask.file)?;
                mask_particles(mask, &bytes, area, seed)
            }
        };
        particles.map_err(|error| TaskError::particles(at, error))
    }
}

/// Returns the index of the patch that is wiped.
fn index_of_patch(patch: SurfacePatch, at: &Place, count: usize) -> Result<usize, TaskError> {
    let plural = if count == 1 { "" } else { "es" };
    let problem = match patch {
        SurfacePatch::Indexed(index) if index < count => return Ok(index),
        SurfacePatch::Indexed(index) => {
            format!(
                "there is no patch {}: the mesh has {count} patch{plural}",
                index + 1
            )
        }
        SurfacePatch::All => format!(
            "only wisch run, follow, predict and plan take \"all\"; choose the number of a patch, of which the mesh has {count}"
        ),
    };
    Err(TaskError::Inconsistent {
        at: at.clone(),
        key: "surface.mesh.patch".to_owned(),
        problem,
    })
}

pub(super) fn read(
    assets: &mut ReadFile<'_>,
    at: &Place,
    file: &str,
) -> Result<Vec<u8>, TaskError> {
    assets(file).map_err(|problem| TaskError::File {
        at: at.clone(),
        file: file.to_owned(),
        problem,
    })
}

fn parsed_mesh(assets: &mut ReadFile<'_>, at: &Place, file: &str) -> Result<Mesh, TaskError> {
    let Some(format) = MeshFormat::from_file_name(file) else {
        return Err(TaskError::File {
            at: at.clone(),
            file: file.to_owned(),
            problem: format!(
                "the name of a mesh file must end in {}",
                MeshFormat::EXTENSIONS
            ),
        });
    };
    let bytes = read(assets, at, file)?;
    Mesh::parse(&bytes, format, file).map_err(|error| TaskError::Mesh {
        at: at.clone(),
        error,
    })
}

fn scaled_mesh(mesh: Mesh, scale: f64) -> Result<Mesh, MeshError> {
    let vertices = mesh.vertices().iter().map(|point| point * scale).collect();
    Mesh::new(vertices, mesh.triangles().to_vec())
}

/// The last mesh that was divided, because a command over all patches loads a task for each.
static LAST_DIVISION: Mutex<Option<(Mesh, SheetConfig, Arc<Atlas>)>> = Mutex::new(None);

/// Divides a mesh into patches.
fn divide(mesh: &Mesh, config: &SheetConfig) -> Result<Arc<Atlas>, SheetError> {
    // Not locked while the mesh is divided, which runs on several threads.
    let last = || LAST_DIVISION.lock().unwrap_or_else(PoisonError::into_inner);
    let known = (last().as_ref())
        .filter(|(of, with, _)| of == mesh && with == config)
        .map(|(_, _, atlas)| Arc::clone(atlas));
    if let Some(atlas) = known {
        return Ok(atlas);
    }
    let atlas = Arc::new(Atlas::from_mesh(mesh, config, MAX_CHARTS)?);
    *last() = Some((mesh.clone(), *config, Arc::clone(&atlas)));
    Ok(atlas)
}

impl ObjectRecord {
    fn mesh(&self, assets: &mut ReadFile<'_>) -> Result<Mesh, TaskError> {
        let built = match &self.shape {
            Shape::Box(size) => Mesh::cuboid(*size),
            Shape::Cylinder { radius, height } => Mesh::cylinder(*radius, *height, SEGMENTS),
            Shape::Sphere { radius } => Mesh::sphere(*radius, SEGMENTS),
            Shape::Capsule { radius, height } => Mesh::capsule(*radius, *height, SEGMENTS),
            Shape::Mesh { at, file, scale } => {
                let mesh = scaled_mesh(parsed_mesh(assets, at, file)?, *scale);
                if let Ok(mesh) = &mesh {
                    check_object(mesh, (file, at), *scale, USUAL_OBJECT)?;
                }
                mesh
            }
        };
        built.map_err(|error| TaskError::Mesh {
            at: self.at.clone(),
            error,
        })
    }
}

/// A box that stands on z = 0 [m].
fn cuboid_on_plane(size: Vector3) -> Result<Mesh, MeshError> {
    raised(&Mesh::cuboid(size)?, size.z / 2.0)
}

/// A mesh, so much higher [m].
fn raised(mesh: &Mesh, height: f64) -> Result<Mesh, MeshError> {
    let up = Vector3::new(0.0, 0.0, height);
    let vertices = mesh.vertices().iter().map(|vertex| vertex + up);
    Mesh::new(vertices.collect(), mesh.triangles().to_vec())
}

/// Checks that a tool is not pressed in by its whole height or more.
fn check_compression(mesh: &Mesh, interaction: &Interaction, at: &Place) -> Result<(), TaskError> {
    let (low, high) = mesh.bounds();
    let (height, depth) = (high.z - low.z, interaction.compression_depth_m);
    if depth == 0.0 || depth < height {
        return Ok(());
    }
    Err(TaskError::Inconsistent {
        at: at.clone(),
        key: "tool".to_owned(),
        problem: format!(
            "interaction.compression_depth_m is {depth} m, but must be less than the height of the tool, {height:.4} m"
        ),
    })
}

fn resolved_tool(
    entry: &ToolEntry,
    mesh: Mesh,
    interaction: &Interaction,
    at: &Place,
) -> Result<Tool, TaskError> {
    let (footprint, area_of_effect) = match entry.area_of_effect {
        Some(area) => {
            let size = Vector2::new(area.depth_m, area.width_m);
            (Region::new(vec![Polygon::rectangle(size)]), size)
        }
        None => {
            let fault = |error| TaskError::Footprint {
                at: at.clone(),
                tool: entry.name.clone(),
                error,
            };
            let region = footprint(&mesh, interaction.compression_depth_m.max(RIGID_DEPTH))
                .map_err(fault)?;
            // A footprint is never empty, so its bounds exist.
            let size = region.bounds().map_or_else(Vector2::zeros, |b| b.size());
            (region, size)
        }
    };
    let mesh = raised(&mesh, interaction.gap_m).map_err(|error| TaskError::Mesh {
        at: at.clone(),
        error,
    })?;
    Ok(Tool {
        name: entry.name.clone(),
        mesh,
        footprint,
        area_of_effect,
        rotation_about_normal: entry.rotation_about_normal,
        tilt: entry.tilt,
        mount: None,
        second_grip: entry.second_grip,
    })
}

/// Returns the middle of the side with the smallest y, where scenes have their robot by convention.
fn start_before(outline: &Polygon) -> Point2 {
    Bounds2::from_points(outline.outer().iter().copied()).map_or_else(Point2::origin, |bounds| {
        Point2::new(bounds.center().x, bounds.min.y)
    })
}
