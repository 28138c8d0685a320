//! A task: all names are resolved, all values checked and converted to SI units.

use super::surface::UPRIGHT;
use super::{
    Action, AngleRange, DirtMobility, DirtSlide, Effect, EffectModel, ElasticFoundation, FilmFlow,
    GoalState, Interaction, Mount, OccupiedArea, ParticleDistribution, SceneObject, ScenePart,
    SecondGrip, Surface, TiltFreedom, Treatment, effective_pressure,
};
use crate::geometry::{Mesh, MeshError, Point2, Polygon, Pose, Region, Vector2, Vector3};

/// A tool with its geometry and degrees of freedom.
#[derive(Debug, Clone, PartialEq)]
pub struct Tool {
    /// Name in the knowledge base.
    pub name: String,
    /// Mesh in the tool frame \[m\].
    pub mesh: Mesh,
    /// Contact area with the surface, in the tool frame \[m\].
    pub footprint: Region,
    /// Area of effect D_aoe: depth along and width across the motion \[m\].
    pub area_of_effect: Vector2,
    /// Permitted yaw about the surface normal; at 0 the broad side is across the motion.
    pub rotation_about_normal: AngleRange,
    /// Permitted tilt; `None` for a tool that stays upright.
    pub tilt: Option<TiltFreedom>,
    /// How the leading hand holds the tool. `None` if neither task nor knowledge base declares it;
    /// then the robot determines it ([`Workcell::mount`](crate::follow::Workcell::mount)).
    pub mount: Option<Mount>,
    /// Grip of a second hand, if there is one.
    pub second_grip: Option<SecondGrip>,
}

impl Tool {
    /// Returns a rectangular pad that wipes with its whole lower face and is held upright, in any yaw.
    ///
    /// # Parameters
    /// - `size`: depth along the motion, width across it, and thickness \[m\].
    ///
    /// # Errors
    /// [`MeshError`] if a side of `size` is not positive and finite.
    pub fn pad(name: impl Into<String>, size: Vector3) -> Result<Self, MeshError> {
        let face = Vector2::new(size.x, size.y);
        let tool_from_mesh = Pose::translation(0.0, 0.0, size.z / 2.0);
        Ok(Self {
            name: name.into(),
            mesh: Mesh::cuboid(size)?.transform(&tool_from_mesh),
            footprint: Region::new(vec![Polygon::rectangle(face)]),
            area_of_effect: face,
            rotation_about_normal: AngleRange::FULL,
            tilt: None,
            mount: None,
            second_grip: None,
        })
    }

    /// Radius r_s = ‖D_aoe‖ / 2 of the collision sphere \[m\].
    pub fn collision_radius(&self) -> f64 {
        self.area_of_effect.norm() / 2.0
    }

    /// Extent of the footprint across the motion \[m\].
    pub fn width(&self) -> f64 {
        let bounds = self.footprint.bounds();
        bounds.map_or(self.area_of_effect.y, |bounds| bounds.size().y)
    }

    /// Distance from the tool centre point within which a particle counts as reached \[m\].
    ///
    /// It is the radius of the largest circle in the area of effect, so the tool covers the particle at any yaw; half
    /// of r_s for a tool as narrow as a blade.
    pub fn reach(&self) -> f64 {
        (self.area_of_effect.min() / 2.0).max(self.collision_radius() / 2.0)
    }

    /// Whether the footprint is a disc about the tool centre point, within 2 % of its radius, so that its effect does
    /// not depend on its yaw.
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

    /// Whether a rotation by π about the tool centre point maps the footprint onto itself.
    pub fn is_half_turn_symmetric(&self) -> bool {
        let corners: Vec<Point2> = self.footprint.edges().map(|edge| edge.start).collect();
        corners
            .iter()
            .all(|a| corners.iter().any(|b| (a.coords + b.coords).norm() < 1e-6))
    }
}

/// A wiping task: action, surface, scene, tool, medium and dirt.
#[derive(Debug, Clone, PartialEq)]
pub struct Task {
    /// Name of the task.
    pub name: String,
    /// The action to perform.
    pub action: Action,
    /// The target surface.
    pub surface: Surface,
    /// Objects of the scene, including the one that carries the surface.
    pub scene: Vec<SceneObject>,
    /// The tool.
    pub tool: Tool,
    /// Name of the medium.
    pub medium: String,
    /// How the medium moves by its own weight.
    pub mobility: DirtMobility,
    /// Press force, controller settings and likelihood of this tool on this medium and surface.
    pub interaction: Interaction,
    /// Estimated places of the dirt.
    pub particles: ParticleDistribution,
    /// n_goal of a collect, in the surface frame \[m\]; `None` lets the planner choose.
    pub collect_goal: Option<Point2>,
    /// Target of `polish` or `dispense`; `None` for actions that move dirt.
    pub treatment: Option<Treatment>,
    /// Start of the tool, in the surface frame \[m\].
    pub tool_start: Point2,
    /// Seed of all random numbers of the task.
    pub seed: u64,
}

impl Task {
    /// Returns a task with defaults for all other fields: the interaction of
    /// [`Interaction::assume`], an empty scene, a goal that the planner chooses, and the middle of
    /// the surface as the start of the tool. Every field can be set afterwards.
    ///
    /// # Parameters
    /// - `particles`: estimated places of the dirt, in the surface frame \[m\].
    ///
    /// ```
    /// use wisch::prelude::*;
    ///
    /// let outline = Polygon::rectangle(Vector2::new(0.4, 0.3));
    /// let surface = Surface::new("tray", outline, Pose::translation(0.5, 0.0, 0.8));
    /// let sponge = Tool::pad("sponge", Vector3::new(0.07, 0.11, 0.05))?;
    /// let crumbs = [Point2::new(-0.1, 0.05), Point2::new(0.0, -0.04), Point2::new(0.12, 0.1)];
    /// let task = Task::new(Action::Absorb, surface, sponge, "crumbs", ParticleDistribution::new(&crumbs)?);
    /// let plan = Planner::new(&task, &PlanConfig::default()).plan()?;
    /// assert_eq!(predict(&task, &plan, |_| ()).performance.achieved, 3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(
        action: Action,
        surface: Surface,
        tool: Tool,
        medium: impl Into<String>,
        particles: ParticleDistribution,
    ) -> Self {
        let medium = medium.into();
        Self {
            name: surface.name.clone(),
            action,
            interaction: Interaction::assume(&tool.name, &medium),
            scene: Vec::new(),
            collect_goal: None,
            treatment: None,
            tool_start: Point2::origin(),
            seed: 0,
            mobility: DirtMobility::default(),
            surface,
            tool,
            medium,
            particles,
        }
    }

    /// Returns the goal of the task; `None` if the planner chooses where to collect.
    pub fn goal(&self) -> Option<GoalState> {
        match (self.action, self.collect_goal) {
            (Action::Absorb, _) => Some(GoalState::Absorbed),
            (Action::Skim, _) => Some(GoalState::Skimmed),
            (Action::Collect, center) => center.map(|center| GoalState::Collected {
                center,
                radius: self.tool.collision_radius(),
            }),
            (Action::Polish | Action::Dispense, _) => {
                (self.treatment).map(|treatment| treatment.goal(self.tool.width()))
            }
        }
    }

    /// Returns the depth that one pass at the nominal force removes or leaves \[m\]; `None` for actions that move dirt,
    /// or if no coefficient is known.
    pub fn depth_per_pass(&self) -> Option<f64> {
        let force = self.interaction.contact_force();
        self.treatment?.depth_per_pass(self.tool.width(), force)
    }

    /// Returns how the dirt slides by its own weight; `None` if it is assumed to stay, and for places of a treated surface.
    pub fn dirt_slide(&self) -> Option<DirtSlide> {
        match self.mobility {
            DirtMobility::Slides(friction) if !self.action.treats() => {
                Some(DirtSlide::new(friction, self.occupied_area()))
            }
            _ => None,
        }
    }

    /// Whether the dirt is a film that runs down the surface: liquids run on planes that face up.
    pub fn has_running_film(&self) -> bool {
        matches!(self.mobility, DirtMobility::Runs(_))
            && !self.action.treats()
            && self.surface.shape.is_plane()
            && self.surface.normal(Point2::origin()).z > -UPRIGHT
    }

    /// Returns how the dirt runs down the surface; `None` if it does not run, see [`Self::has_running_film`].
    pub fn film_flow(&self) -> Option<FilmFlow> {
        match self.mobility {
            DirtMobility::Runs(film) if self.has_running_film() => {
                Some(FilmFlow::new(film, self.occupied_area()))
            }
            _ => None,
        }
    }

    /// Returns the effect model with which plans are predicted: on a curved surface, the tool acts
    /// only where its pressure at nominal force is high enough.
    ///
    /// # Parameters
    /// - `footprint`: the footprint that counts, at most that of the task's tool (tool frame \[m\]).
    pub fn effect_model(&self, footprint: &Region, effect: Effect) -> EffectModel {
        let model = EffectModel::new(footprint, effect)
            .with_slide(self.dirt_slide())
            .with_film(self.film_flow());
        match ElasticFoundation::from_interaction(&self.tool.footprint, &self.interaction) {
            Some(foundation) if !self.surface.shape.is_plane() => {
                model.with_contact(foundation, effective_pressure(&self.interaction.likelihood))
            }
            _ => model,
        }
    }

    /// Force of the surface on a tool that presses with the task's nominal force, in the axes of
    /// the world \[N\].
    pub fn surface_reaction(&self) -> Vector3 {
        self.surface.world_from_surface * Vector3::z() * self.interaction.contact_force()
    }

    /// Returns the obstacles: the scene without robot, tool and the object that carries the surface.
    pub fn obstacles(&self) -> impl Iterator<Item = &SceneObject> {
        (self.scene.iter()).filter(|object| object.part == ScenePart::Obstacle)
    }

    /// Returns the pose in the world \[m\] of the root of the robot that the scene shows: on the floor, facing the
    /// surface. `None` if the scene shows no robot.
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

    /// Returns the area that the obstacles occupy on the surface. It is empty on a curved surface,
    /// because the planner refuses obstacles there.
    pub fn occupied_area(&self) -> OccupiedArea {
        if !self.surface.shape.is_plane() {
            return OccupiedArea::from_scene(&[]);
        }
        let obstacles: Vec<Mesh> = self.obstacles_in_surface().collect();
        OccupiedArea::from_scene(&obstacles)
    }

    /// Returns the obstacles' meshes in the surface frame.
    pub fn obstacles_in_surface(&self) -> impl Iterator<Item = Mesh> + '_ {
        let surface_from_world = self.surface.world_from_surface.inverse();
        self.obstacles().map(move |object| {
            object
                .mesh
                .transform(&(surface_from_world * object.world_from_object))
        })
    }
}
