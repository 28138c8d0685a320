//! Reads the tables `[perception]` and `[execution]`: the robot's camera, and the simulated world.

use super::clusters::heaps;
use super::deserialize::At;
use super::execution_tables::{
    CameraTable, DirtTable, ExecutionTable, FrictionChangeTable, PushTable,
};
use super::resolve::ReadFile;
use super::tables::{PerceptionTable, SenseName};
use super::values::{Share, StrokeNumber, TimeS, mask, point};
use super::{TaskError, TaskFile};
use crate::particles::{csv_particles, mask_particles};
use nalgebra::{Translation3, UnitQuaternion};
use wisch::geometry::{Pose, Vector3};
use wisch::represent::{
    Cone, DirtArea, GrainSize, KnowledgeBase, SensorModel, Surface, SurfaceShape, Task,
};
use wisch_sim::{
    Camera, FrictionChange, GrainCount, Moment, Push, RealTool, Sensing, SimulationSettings,
    TrueDirt, Waviness,
};

/// Default of `within_m`: maximum distance from the outline of dirt along it [m].
const WITHIN: f64 = 0.04;

/// Returns the believed model of the robot's camera; `None` for touch only.
pub(super) fn camera(table: &PerceptionTable) -> Result<Option<SensorModel>, TaskError> {
    let Some(senses) = &table.senses else {
        return Ok(None);
    };
    let count = |sense| senses.value.iter().filter(|s| **s == sense).count();
    let problem = match (count(SenseName::Touch), count(SenseName::Sight)) {
        (1, 0) => return Ok(None),
        (1, 1) => {
            let usual = SensorModel::default();
            return Ok(Some(SensorModel {
                detection: table.detection.map_or(usual.detection, |x| x.0),
                half_size_m: table.half_size_m.map_or(usual.half_size_m, |x| x.0),
                false_alarms_per_m2: (table.false_alarms_per_m2)
                    .map_or(usual.false_alarms_per_m2, |x| x.0),
                position_error_m: (table.position_error_m).map_or(usual.position_error_m, |x| x.0),
            }));
        }
        (0, _) => "\"touch\" is missing; it is always one of the senses",
        _ => "a sense is given twice",
    };
    Err(senses.inconsistent(problem))
}

impl ExecutionTable {
    /// Checks what the type of a single key does not: the number of heaps, the order of the diameters, and that each
    /// disturbance has one start.
    pub(super) fn check(&self) -> Result<(), TaskError> {
        if let Some(dirt) = &self.dirt
            && let DirtTable::Clusters {
                clusters: Some(clusters),
                ..
            } = &dirt.value
        {
            heaps(clusters)?;
        }
        if let Some(size) = &self.grain_size_m {
            let [min_m, max_m] = size.value.map(|diameter| diameter.0);
            if min_m > max_m {
                let problem =
                    format!("the smallest diameter, {min_m} m, exceeds the largest, {max_m} m");
                return Err(size.inconsistent(problem));
            }
        }
        for change in &self.friction_change {
            moment(change, change.value.starts())?;
        }
        for push in &self.push {
            moment(push, push.value.starts())?;
        }
        Ok(())
    }
}

impl FrictionChangeTable {
    fn starts(&self) -> Starts {
        (self.start_s, self.start_share, self.start_stroke)
    }
}

impl PushTable {
    fn starts(&self) -> Starts {
        (self.start_s, self.start_share, self.start_stroke)
    }
}

/// The three keys that state when a disturbance starts.
type Starts = (Option<TimeS>, Option<Share>, Option<StrokeNumber>);

/// Reads the start of a disturbance, which a table states by exactly one key.
fn moment<T>(table: &At<T>, starts: Starts) -> Result<Moment, TaskError> {
    Ok(match starts {
        (Some(time), None, None) => Moment::Seconds(time.0),
        (None, Some(share), None) => Moment::Share(share.0),
        (None, None, Some(stroke)) => Moment::Stroke(stroke.0 as usize),
        (time, share, stroke) => {
            let place = |is_there: bool| is_there.then_some(&table.place);
            let keys = [
                ("start_s", place(time.is_some())),
                ("start_share", place(share.is_some())),
                ("start_stroke", place(stroke.is_some())),
            ];
            return Err(match table.exactly_one(&keys) {
                Err(error) => error,
                Ok(()) => table.missing("start_s"),
            });
        }
    })
}

impl TaskFile {
    /// Returns the simulated world of the table `[execution]`, over the entries of the knowledge base. It reads the true dirt
    /// locations if the table names a file of them.
    ///
    /// - `task`: the result of [`Self::resolve`].
    /// - `assets`: reads a file of the task, by its path relative to the task file.
    ///
    /// # Errors
    /// If the knowledge base does not know the task's surface or medium, or if a file is missing or invalid. The error states
    /// the location in the task file.
    pub fn simulation(
        &self,
        task: &Task,
        knowledge: &KnowledgeBase,
        assets: &mut ReadFile<'_>,
    ) -> Result<SimulationSettings, TaskError> {
        let table = &self.execution;
        let usual = SimulationSettings::as_believed(task, knowledge, self.camera)
            .map_err(|error| self.unknown(error, &self.medium_at))?;
        let usual = match &table.grain_size_m {
            Some(size) => {
                let [min_m, max_m] = size.value.map(|diameter| diameter.0);
                usual.with_grain_size(GrainSize { min_m, max_m })
            }
            None => usual,
        };
        let vector = |axes: [f64; 3]| Vector3::from(axes);
        let [about_x, about_y] = (table.surface_tilt_rad).map_or([0.0; 2], |x| x.map(|x| x.0));
        let shift = (table.surface_shift_m).map_or([0.0; 3], |x| x.map(|x| x.0));
        let mut settings = SimulationSettings {
            believed_from_real: Pose::from_parts(
                Translation3::from(vector(shift)),
                UnitQuaternion::from_scaled_axis(Vector3::new(about_x, about_y, 0.0)),
            ),
            shape: table.shape(task)?,
            friction: table.friction.map_or(usual.friction, |x| x.0),
            friction_changes: (table.friction_change.iter())
                .map(friction_change)
                .collect::<Result<_, _>>()?,
            pushes: table.push.iter().map(push).collect::<Result<_, _>>()?,
            force_noise: table.force_noise_n.0,
            force_bias: vector(table.force_bias_n.map_or([0.0; 3], |x| x.map(|x| x.0))),
            grain_mass: table.grain_mass_kg.map(|mass| mass.0),
            grains_resist: table.grains_resist,
            tool: table.tool(),
            sensing: table.sensing(),
            joint_friction: table.joint_friction_nm.0,
            waviness: Waviness {
                height: table.waviness_m.0,
                length: table.waviness_length_m.0,
            },
            camera: usual
                .camera
                .map(|camera| table.camera.camera(camera.sensor)),
            ..usual
        };
        let likelihood = &mut settings.likelihood;
        likelihood.mu = table.mu.map_or(likelihood.mu, |mu| mu.0);
        likelihood.sigma = table.sigma.map_or(likelihood.sigma, |sigma| sigma.0);
        if !task.action.treats() {
            settings.max_bodies = table.max_bodies.0 as usize;
        }
        if let Some(table) = &table.dirt {
            let (dirt, count) = true_dirt(table, task, assets)?;
            if !task.action.treats() {
                settings.dirt = dirt;
            }
            settings.count = count.map_or(settings.count, GrainCount::Exactly);
        }
        Ok(settings)
    }
}

fn friction_change(table: &At<FrictionChangeTable>) -> Result<FrictionChange, TaskError> {
    let given = &table.value;
    Ok(FrictionChange {
        round: given.round.0 as usize,
        start: moment(table, given.starts())?,
        friction: given.friction.0,
    })
}

fn push(table: &At<PushTable>) -> Result<Push, TaskError> {
    let given = &table.value;
    Ok(Push {
        round: given.round.0 as usize,
        start: moment(table, given.starts())?,
        duration: given.duration_s.0,
        force: Vector3::from(given.force_n.map(|axis| axis.0)),
        hand_speed: given.hand_speed_m_per_s.0,
    })
}

impl ExecutionTable {
    /// Returns the true shape of a surface; `None` for the believed one.
    fn shape(&self, task: &Task) -> Result<Option<SurfaceShape>, TaskError> {
        let surface = &task.surface;
        let Some(radius) = &self.surface_radius_m else {
            return match (&self.surface_axis_rad, &self.surface_half_angle_rad) {
                (Some(axis), _) => {
                    Err(axis.inconsistent("is that of a cylinder or a cone; set surface_radius_m"))
                }
                (None, Some(angle)) => {
                    Err(angle.inconsistent("is that of a cone; set surface_radius_m"))
                }
                (None, None) => Ok(None),
            };
        };
        let (axis, half_angle) = match surface.shape {
            SurfaceShape::Plane => (0.0, None),
            SurfaceShape::Cylinder { axis, .. } => (axis, None),
            SurfaceShape::Cone(cone) => (cone.axis, Some(cone.half_angle)),
            SurfaceShape::Mesh(_) => {
                return Err(
                    radius.inconsistent("bends planes, cylinders and cones only, not a mesh")
                );
            }
        };
        let radius_m = radius.value.0;
        let axis = (self.surface_axis_rad.as_ref()).map_or(axis, |axis| axis.value.0);
        let half_angle =
            (self.surface_half_angle_rad.as_ref()).map_or(half_angle, |angle| Some(angle.value.0));
        let shape = match half_angle {
            None => SurfaceShape::Cylinder {
                radius: radius_m,
                axis,
            },
            Some(half_angle) => SurfaceShape::Cone(Cone {
                radius: radius_m,
                half_angle,
                axis,
            }),
        };
        let real = Surface {
            shape: shape.clone(),
            ..surface.clone()
        };
        if let Some(fault) = real.shape_fault() {
            return Err(radius.inconsistent(fault.to_string()));
        }
        let corners = task.tool.footprint.edges();
        let reach = corners
            .map(|edge| edge.start.coords.norm())
            .fold(0.0, f64::max);
        let least = real.least_radii().least();
        if reach > least {
            return Err(radius.inconsistent(format!(
                "makes a radius of curvature of {least:.3} m, less than the {reach:.3} m to which the tool touches from its centre"
            )));
        }
        Ok(Some(shape))
    }

    fn tool(&self) -> RealTool {
        RealTool {
            stiffness: self.tool_stiffness.0,
            footprint: self.footprint.0,
            grasp_offset: (self.grasp_offset_m.map_or([0.0; 2], |x| x.map(|x| x.0))).into(),
            grasp_turn: self.grasp_turn_rad.0,
        }
    }

    fn sensing(&self) -> Sensing {
        Sensing {
            encoder_noise: self.encoder_noise_rad.0,
            backlash: self.backlash_rad.0,
            force_delay: self.force_delay_s.0,
            force_drift: (self
                .force_drift_n_per_s
                .map_or([0.0; 3], |x| x.map(|x| x.0)))
            .into(),
        }
    }
}

impl CameraTable {
    /// Returns the true camera: these values, with missing ones from the believed camera.
    fn camera(&self, believed: SensorModel) -> Camera {
        Camera {
            sensor: SensorModel {
                detection: self.detection.map_or(believed.detection, |x| x.0),
                half_size_m: self.half_size_m.map_or(believed.half_size_m, |x| x.0),
                false_alarms_per_m2: (self.false_alarms_per_m2)
                    .map_or(believed.false_alarms_per_m2, |x| x.0),
                position_error_m: (self.position_error_m)
                    .map_or(believed.position_error_m, |x| x.0),
            },
            arm_hides: self.arm_hides,
        }
    }
}

/// Returns the true dirt, and the number of its grains if the table states it. Of the believed dirt, it reads only what the
/// source `as_believed` asks for.
fn true_dirt(
    table: &At<DirtTable>,
    task: &Task,
    assets: &mut ReadFile<'_>,
) -> Result<(TrueDirt, Option<usize>), TaskError> {
    let area = DirtArea {
        outline: &task.surface.outline,
        occupied: &task.occupied_area(),
    };
    let (dirt, count) = match &table.value {
        DirtTable::AsBelieved {} => (TrueDirt::Listed(task.particles.clone()), &None),
        DirtTable::Uniform { count } => (TrueDirt::Uniform, count),
        DirtTable::Clusters { count, clusters } => {
            let given = clusters.as_ref().map(heaps).transpose()?;
            (TrueDirt::Clusters(given), count)
        }
        DirtTable::Stripe {
            count,
            center_m,
            direction_rad,
            width_m,
        } => {
            let stripe = TrueDirt::Stripe {
                center: center_m.map(point),
                direction: direction_rad.map(|angle| angle.0),
                width: width_m.map(|width| width.0),
            };
            (stripe, count)
        }
        DirtTable::Edge { count, within_m } => {
            let within = within_m.map_or(WITHIN, |within| within.0);
            (TrueDirt::Edge(within), count)
        }
        DirtTable::Csv { file } => {
            let (at, path) = (&file.place, &file.value.0);
            let particles = csv_particles(path, &super::resolve::read(assets, at, path)?, area);
            let dirt = particles.map_err(|error| TaskError::particles(at, error))?;
            (TrueDirt::Listed(dirt), &None)
        }
        DirtTable::Image {
            file,
            corners_px,
            color,
            tolerance,
            count,
        } => {
            let (at, path) = (&file.place, &file.value);
            let mask = mask(path, corners_px, color, *tolerance, *count);
            let bytes = super::resolve::read(assets, at, &mask.file)?;
            // A different seed than for believed particles of the same image.
            let particles = mask_particles(&mask, &bytes, area, !task.seed);
            let dirt = particles.map_err(|error| TaskError::particles(at, error))?;
            (TrueDirt::Listed(dirt), &None)
        }
    };
    Ok((dirt, count.map(|count| count.0 as usize)))
}
