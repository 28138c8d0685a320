//! Collision models of a robot with its tool in a scene, by what the tool may touch.

use super::FLOOR_TOLERANCE;
use super::grasp::{relax, without_rim};
use super::group::{PlanarBase, hand_and_holder, standing_links};
use super::target_surface::{PlacedTool, TargetSurface, is_tool_behind};
use crate::follow::FollowError;
use crate::geometry::{Mesh, Point3, Pose, Vector3};
use crate::represent::{SceneObject, ScenePart, Surface, Task};
use crate::robot::setup::lowest_point;
use crate::robot::{CollisionModel, LinkId, RobotError, RobotModel, Srdf};
use std::collections::BTreeSet;

/// Reduction of the clearance between the sides of the tool and the scene while it wipes [m]. A corner loses √3
/// times as much, which is still less than the usual margin.
const TOOL_RIM: f64 = 2.8e-3;

/// Size of the floor under a robot that drives [m].
const FLOOR: Vector3 = Vector3::new(2000.0, 2000.0, 1.0);
/// Height of a surface over the floor up to which the tool may touch the floor beside it [m].
const FLOOR_SURFACE: f64 = 0.02;

/// Collision models, by what the tool may touch and which variables move.
#[derive(Debug, Clone)]
pub(super) struct WorkcellCollisions {
    /// For free motion.
    pub(super) free: CollisionModel,
    /// While the tool touches the surface.
    pub(super) in_contact: CollisionModel,
    /// For free motion, only pairs whose distance the base's variables change.
    pub(super) base: CollisionModel,
    /// For free motion, only pairs whose distance the arm's variables change.
    pub(super) arm: CollisionModel,
    /// While the tool touches the surface, only pairs whose distance the arm's variables change, without the
    /// tool's rim.
    pub(super) arm_in_contact: CollisionModel,
    /// Names of the scene's objects and of the target surface.
    pub(super) obstacles: BTreeSet<String>,
}

/// A robot with its tool, before it is placed in the scene of a task.
pub(super) struct MountedTool<'a> {
    robot: &'a RobotModel,
    task: &'a Task,
    mount: &'a PlacedTool,
    /// Name of the tool among the bodies of the models.
    tool: String,
    /// Name of the tool without its rim.
    core: String,
    models: ContactModels,
}

/// An object of the scene, with its name among the obstacles.
type NamedObject<'a> = (String, &'a SceneObject);

impl<'a> MountedTool<'a> {
    /// Attaches the tool of a task to its link.
    pub(super) fn attach(
        robot: &'a RobotModel,
        srdf: Option<&Srdf>,
        task: &'a Task,
        mount: &'a PlacedTool,
    ) -> Result<Self, FollowError> {
        let tool = rename_if_link(robot, &task.tool.name);
        let core = rename_if_link(robot, &format!("{} without its rim", task.tool.name));
        let mesh = &task.tool.mesh;
        let (tip, tip_from_tool) = (mount.tip, mount.tip_from_tool);
        let bare = CollisionModel::new(robot, srdf)?;
        // A tool in free motion is not compressed.
        let relaxed = relax(mesh, task.interaction.compression_depth_m)?;
        let mut free = bare.clone();
        free.attach(&tool, tip, tip_from_tool, &relaxed)?;
        let mut in_contact = bare.clone();
        in_contact.attach(&tool, tip, tip_from_tool, mesh)?;
        // The whole tool against the robot, the tool without its rim against the scene.
        let mut rimless = bare;
        let core_mesh = without_rim(mesh, TOOL_RIM)?;
        rimless.attach(&tool, tip, tip_from_tool, mesh)?;
        rimless.attach(&core, tip, tip_from_tool, &core_mesh)?;
        for link in robot.links() {
            rimless.allow(&core, &link.name)?;
        }
        let mut models = ContactModels {
            free,
            in_contact,
            rimless,
        };
        // A gripper on the tip holds the tool.
        for link in robot.carried_links(tip) {
            models.allow_in_all(&tool, &robot.links()[link.index()].name)?;
        }
        Ok(Self {
            robot,
            task,
            mount,
            tool,
            core,
            models,
        })
    }

    /// Attaches the holder of the tool, which may touch nothing. `mesh`: in the frame of the link that holds the tool \[m\].
    pub(super) fn add_holder(&mut self, mesh: &Mesh) -> Result<(), FollowError> {
        let name = rename_if_link(self.robot, &name_holder(self.task));
        for model in self.models.all() {
            model.attach(&name, self.mount.tip, Pose::identity(), mesh)?;
        }
        Ok(())
    }

    /// Allows a second hand to touch the tool that it holds.
    pub(super) fn allow_second_hand(&mut self, tip: LinkId) -> Result<(), FollowError> {
        for link in hand_and_holder(self.robot, tip) {
            self.models.allow_in_all(&self.tool, &link)?;
        }
        Ok(())
    }

    /// Places the robot in the scene of the task. `ready`: start posture, all n variables [rad or m]; `arm`:
    /// the variables of its arms.
    pub(super) fn place_in_scene(
        mut self,
        base: Option<PlanarBase>,
        ready: &[f64],
        arm: &[usize],
    ) -> Result<WorkcellCollisions, FollowError> {
        let objects = self.add_objects()?;
        let surface = self.add_surface(&objects, ready)?;
        let mut floor = None;
        if let Some(base) = base {
            self.allow_driving(&base, &objects, &surface.face)?;
            floor = Some(self.add_floor(&objects, &surface, (ready, arm))?);
        }
        self.allow_wiping(&objects, &surface)?;
        if let Some(behind) = &surface.behind {
            for link in self.robot.links() {
                self.models.allow_in_all(&link.name, behind)?;
            }
        }
        let names = objects.into_iter().map(|(name, _)| name);
        let base_variables = base.map_or(vec![], |base| vec![base.x, base.y, base.yaw]);
        let ContactModels {
            free,
            in_contact,
            rimless,
        } = self.models;
        Ok(WorkcellCollisions {
            base: free.with_variables(&base_variables),
            arm: free.with_variables(arm),
            arm_in_contact: rimless.with_variables(arm),
            free,
            in_contact,
            obstacles: names
                .chain([surface.face])
                .chain(surface.behind)
                .chain(floor)
                .collect(),
        })
    }

    /// Adds the objects of the scene that are neither the robot nor its tool.
    fn add_objects(&mut self) -> Result<Vec<NamedObject<'a>>, FollowError> {
        let is_own = |part| matches!(part, ScenePart::Robot | ScenePart::Tool);
        let objects: Vec<NamedObject<'a>> = (self.task.scene.iter())
            .filter(|object| !is_own(object.part))
            .map(|object| (rename_if_link(self.robot, &object.name), object))
            .collect();
        let root_from_world = self.mount.world_from_root.inverse();
        for model in self.models.all() {
            let placed = objects.iter().map(|(name, object)| {
                let root_from_object = root_from_world * object.world_from_object;
                (name.as_str(), root_from_object, &object.mesh)
            });
            model.add_obstacles(placed)?;
        }
        Ok(objects)
    }

    /// Adds the target surface, and the space behind it unless the tool waits there.
    fn add_surface(
        &mut self,
        objects: &[NamedObject<'_>],
        ready: &[f64],
    ) -> Result<TargetSurface, FollowError> {
        let root_from_world = self.mount.world_from_root.inverse();
        let kinematics = self.robot.forward_kinematics(ready)?;
        let waits_behind = is_tool_behind(self.task, &kinematics, self.mount);
        let (robot, own) = (self.robot, [&self.tool, &self.core]);
        let is_taken =
            |name: &String| own.contains(&name) || objects.iter().any(|(known, _)| known == name);
        let unused = |name: &str| find_unused(robot, name, " (target)", &is_taken);
        let models = &mut self.models.all();
        TargetSurface::add(self.task, &root_from_world, &unused, waits_behind, models)
    }

    /// Adds the floor on which the base moves, and returns its name: at z = 0 of the world, or lower if the robot or the surface
    /// reaches below. Links that no arm moves stand on it. The tool may touch it where the surface lies on it. `posture`: the
    /// ready posture, and the variables of the arms.
    fn add_floor(
        &mut self,
        objects: &[NamedObject<'_>],
        surface: &TargetSurface,
        (ready, arm): (&[f64], &[usize]),
    ) -> Result<String, FollowError> {
        let floor = find_unused(self.robot, "floor", " of the robot", &|name| {
            [&self.tool, &self.core, &surface.face].contains(&name)
                || objects.iter().any(|(known, _)| known == name)
                || surface.behind.as_ref() == Some(name)
        });
        let mesh = Mesh::cuboid(FLOOR).map_err(FollowError::Surface)?;
        let standing = unmoved_links(self.robot, arm);
        let kinematics = self.robot.forward_kinematics(ready)?;
        let mut top = heights(&self.task.surface).fold(0.0, f64::min);
        for link in &standing {
            let link = self.robot.link(link)?;
            let world_from_link = self.mount.world_from_root * kinematics.world_from_link(link);
            let shapes = self.robot.links()[link.index()].collision.iter();
            top = shapes
                .map(|shape| lowest_point(&world_from_link, shape))
                .fold(top, f64::min);
        }
        let root_from_floor =
            self.mount.world_from_root.inverse() * Pose::translation(0.0, 0.0, top - FLOOR.z / 2.0);
        for model in self.models.all() {
            model.add_obstacle(&floor, root_from_floor, &mesh)?;
        }
        for link in &standing {
            self.models.allow_in_all(link, &floor)?;
        }
        self.models.rimless.allow(&self.tool, &floor)?;
        if heights(&self.task.surface).fold(f64::NEG_INFINITY, f64::max) < top + FLOOR_SURFACE {
            self.models.allow_in_all(&self.tool, &floor)?;
            self.models.rimless.allow(&self.core, &floor)?;
        }
        Ok(floor)
    }

    /// Allows the links that stand on the floor to touch what is not above it.
    fn allow_driving(
        &mut self,
        base: &PlanarBase,
        objects: &[NamedObject<'_>],
        face: &str,
    ) -> Result<(), FollowError> {
        let floors = (objects.iter())
            .filter(|(_, object)| is_object_on_floor(object))
            .map(|(name, _)| name.as_str())
            .chain(is_surface_on_floor(&self.task.surface).then_some(face));
        let wheels = standing_links(self.robot, base);
        for floor in floors {
            for link in &wheels {
                self.models.allow_in_all(link, floor)?;
            }
        }
        Ok(())
    }

    /// Allows the tool to touch the surface and its carrier while it wipes, and its rim to touch the other
    /// objects.
    fn allow_wiping(
        &mut self,
        objects: &[NamedObject<'_>],
        surface: &TargetSurface,
    ) -> Result<(), FollowError> {
        let ContactModels {
            in_contact,
            rimless,
            ..
        } = &mut self.models;
        let faces = || std::iter::once(&surface.face).chain(&surface.behind);
        for name in objects.iter().map(|(name, _)| name).chain(faces()) {
            rimless.allow(&self.tool, name)?;
        }
        let carriers = (objects.iter()).filter(|(_, object)| object.part == ScenePart::Carrier);
        for name in carriers.map(|(name, _)| name).chain(faces()) {
            in_contact.allow(&self.tool, name)?;
            rimless.allow(&self.core, name)?;
        }
        Ok(())
    }
}

/// Models of the same bodies that differ in what the tool may touch.
struct ContactModels {
    /// The tool, not compressed, may touch nothing.
    free: CollisionModel,
    /// The tool may touch the surface and its carrier.
    in_contact: CollisionModel,
    /// The tool may touch the surface and its carrier, and its rim the other objects.
    rimless: CollisionModel,
}

impl ContactModels {
    /// All models, for changes.
    const fn all(&mut self) -> [&mut CollisionModel; 3] {
        [&mut self.free, &mut self.in_contact, &mut self.rimless]
    }

    /// Allows two bodies to touch in every model.
    fn allow_in_all(&mut self, a: &str, b: &str) -> Result<(), RobotError> {
        self.all()
            .into_iter()
            .try_for_each(|model| model.allow(a, b))
    }
}

/// Returns the name of the holder of a task's tool.
fn name_holder(task: &Task) -> String {
    format!("holder of {}", task.tool.name)
}

/// Returns a name, marked as one of the scene if a link has it.
fn rename_if_link(robot: &RobotModel, name: &str) -> String {
    if robot.links().iter().any(|link| link.name == name) {
        format!("{name} (scene)")
    } else {
        name.to_owned()
    }
}

/// Returns a name that neither a link nor another body has, with `suffix` where it needs one.
fn find_unused(
    robot: &RobotModel,
    name: &str,
    suffix: &str,
    is_taken: &dyn Fn(&String) -> bool,
) -> String {
    let mut name = rename_if_link(robot, name);
    while is_taken(&name) {
        name.push_str(suffix);
    }
    name
}

/// Returns the heights of a surface's border in the world [m].
fn heights(surface: &Surface) -> impl Iterator<Item = f64> + '_ {
    let corners = surface.outline.outer().iter();
    corners.map(|corner| surface.world_from_place(*corner, 0.0).translation.z)
}

/// Returns the links with shapes that none of these variables moves.
fn unmoved_links(robot: &RobotModel, variables: &[usize]) -> Vec<String> {
    let mut unmoved = vec![true; robot.links().len()];
    for joint in robot.joints() {
        let moves = (joint.drive.terms.iter()).any(|(variable, _)| variables.contains(variable));
        unmoved[joint.child.index()] = unmoved[joint.parent.index()] && !moves;
    }
    let links = robot.links().iter().zip(unmoved);
    let links = links.filter(|(link, unmoved)| *unmoved && !link.collision.is_empty());
    links.map(|(link, _)| link.name.clone()).collect()
}

/// Whether no point of a surface is above the floor on which the base moves.
fn is_surface_on_floor(surface: &Surface) -> bool {
    let mut corners = surface.outline.outer().iter();
    corners.all(|p| {
        let corner = surface.world_from_surface * Point3::new(p.x, p.y, 0.0);
        surface.shape.is_plane() && corner.z <= FLOOR_TOLERANCE
    })
}

/// Whether no point of an object is above the floor on which the base moves.
fn is_object_on_floor(object: &SceneObject) -> bool {
    let vertices = object.mesh.vertices().iter();
    let heights = vertices.map(|vertex| (object.world_from_object * vertex).z);
    heights.fold(f64::NEG_INFINITY, f64::max) <= FLOOR_TOLERANCE
}
