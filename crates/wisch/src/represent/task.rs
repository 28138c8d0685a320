//! A task as it is meant: everything resolved, checked and in SI units.

use super::{
    Action, AngleRange, GoalState, Grip, Interaction, ParticleDistribution, SceneObject, ScenePart,
    SecondGrip, Surface, TiltFreedom, Treatment,
};
use crate::geometry::{Mesh, Point2, Pose, Region, Vector2, Vector3};

/// A tool as the planner sees it.
#[derive(Debug, Clone, PartialEq)]
pub struct Tool {
    /// Its name in the knowledge base.
    pub name: String,
    /// Its surface in the tool frame [m].
    pub mesh: Mesh,
    /// Where it touches the surface, in the tool frame.
    pub footprint: Region,
    /// Area of effect D_aoe: depth along and width across the motion [m].
    pub area_of_effect: Vector2,
    /// How it may be turned about the surface normal; 0 is its broad side across the motion.
    pub rotation_about_normal: AngleRange,
    /// How it may lean, if it may.
    pub tilt: Option<TiltFreedom>,
    /// How the leading hand holds it; `None` for the rear edge of its upper face at the end of the hand.
    pub grip: Option<Grip>,
    /// Where a second hand may hold it.
    pub second_grip: Option<SecondGrip>,
}

impl Tool {
    /// Radius r_s = ‖D_aoe‖ / 2 of the collision sphere [m].
    pub fn collision_radius(&self) -> f64 {
        self.area_of_effect.norm() / 2.0
    }

    /// Extent of the footprint across the motion [m].
    pub fn width(&self) -> f64 {
        let bounds = self.footprint.bounds();
        bounds.map_or(self.area_of_effect.y, |bounds| bounds.size().y)
    }

    /// Distance from the tool centre point within which a particle counts as reached [m].
    ///
    /// The radius of the largest circle in the area of effect, so that the tool covers the particle
    /// whichever way it is turned; half of r_s for a tool as narrow as a blade.
    pub fn reach(&self) -> f64 {
        (self.area_of_effect.min() / 2.0).max(self.collision_radius() / 2.0)
    }

    /// Whether its footprint is a disc about the tool centre point, to a fiftieth of its radius: what it does does not depend
    /// on how it is turned.
    pub fn is_round(&self) -> bool {
        let [disc] = self.footprint.polygons() else {
            return false;
        };
        let corners = disc.edges().map(|edge| edge.start.coords.norm());
        let radius = corners.fold(0.0, f64::max);
        disc.is_convex()
            && disc.edges().all(|edge| {
                let middle = nalgebra::center(&edge.start, &edge.end);
                middle.coords.norm() > 0.98 * radius
            })
    }

    /// Whether half a turn about the tool centre point maps the footprint onto itself.
    pub fn is_half_turn_symmetric(&self) -> bool {
        let corners: Vec<Point2> = self.footprint.edges().map(|edge| edge.start).collect();
        corners
            .iter()
            .all(|a| corners.iter().any(|b| (a.coords + b.coords).norm() < 1e-6))
    }
}

/// What is to be wiped, where, with what, and to what end.
#[derive(Debug, Clone)]
pub struct Task {
    /// Its name.
    pub name: String,
    /// What is to be done.
    pub action: Action,
    /// The target surface.
    pub surface: Surface,
    /// Everything round it, the object that carries it included.
    pub scene: Vec<SceneObject>,
    /// The tool.
    pub tool: Tool,
    /// Name of the medium.
    pub medium: String,
    /// How the tool is used on this medium and surface, and how well that works.
    pub interaction: Interaction,
    /// The dirt as it is believed to lie.
    pub particles: ParticleDistribution,
    /// n_goal for a collect, in the surface frame [m]; `None` leaves the choice to the planner.
    pub collect_goal: Option<Point2>,
    /// What a polish or an emit asks for; `None` for what moves dirt.
    pub treatment: Option<Treatment>,
    /// Where the tool starts, in the surface frame [m].
    pub tool_start: Point2,
    /// Seed of everything random in this task.
    pub seed: u64,
}

impl Task {
    /// What the particles are to be measured against; `None` where it is left to the planner where to collect.
    pub fn goal(&self) -> Option<GoalState> {
        match (self.action, self.collect_goal) {
            (Action::Absorb, _) => Some(GoalState::Absorbed),
            (Action::Skim, _) => Some(GoalState::Skimmed),
            (Action::Collect, center) => center.map(|center| GoalState::Collected {
                center,
                radius: self.tool.collision_radius(),
            }),
            (Action::Polish | Action::Emit, _) => {
                (self.treatment).map(|treatment| treatment.goal(self.tool.width()))
            }
        }
    }

    /// What one pass with the force that is asked for does to the surface [m]: how much it removes, or leaves; `None` for what
    /// moves dirt, or where that is not said.
    pub fn depth_per_pass(&self) -> Option<f64> {
        let force = self.interaction.contact_force();
        self.treatment?.per_pass(self.tool.width(), force)
    }

    /// What a tool feels that is pressed as the task asks for: the force of the surface on it, in the axes of the
    /// world [N].
    pub fn surface_reaction(&self) -> Vector3 {
        self.surface.world_from_surface * Vector3::z() * self.interaction.contact_force()
    }

    /// What stands round the surface: without robot, tool and the object that carries the surface.
    pub fn obstacles(&self) -> impl Iterator<Item = &SceneObject> {
        (self.scene.iter()).filter(|object| object.part == ScenePart::Obstacle)
    }

    /// Where the scene shows the robot, facing the surface, on the floor: the pose of its root in the world [m].
    /// `None` if the scene shows none.
    pub fn robot_before_surface(&self) -> Option<Pose> {
        let mut scene = self.scene.iter();
        let stands = scene.find(|object| object.part == ScenePart::Robot)?;
        let at = stands.world_from_object.translation.vector;
        let towards = self.surface.world_from_surface.translation.vector - at;
        Some(Pose::new(
            Vector3::new(at.x, at.y, 0.0),
            Vector3::z() * towards.y.atan2(towards.x),
        ))
    }

    /// The obstacles' meshes in the surface frame.
    pub fn obstacles_in_surface(&self) -> impl Iterator<Item = Mesh> + '_ {
        let surface_from_world = self.surface.world_from_surface.inverse();
        self.obstacles().map(move |object| {
            object
                .mesh
                .transformed(&(surface_from_world * object.world_from_object))
        })
    }
}
