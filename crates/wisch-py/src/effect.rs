//! The effect model on arrays.

use crate::arrays::{self, Matrix, rows};
use crate::error::{plain, refused};
use crate::task::PyTask;
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::{Mutex, PoisonError};
use wisch::geometry::{PlanarPose, Point2, Polygon, Pose, Region};
use wisch::represent::{
    Effect, EffectModel, MotionEffect, ParticleDistribution, ParticleField, Surface, ToolMotion,
};

/// Particles on a surface, with the effect model of a tool.
#[pyclass(name = "EffectField", module = "wisch", frozen)]
pub struct PyEffectField {
    surface: Surface,
    state: Mutex<(ParticleField, EffectModel)>,
}

impl PyEffectField {
    fn with<T>(&self, run: impl FnOnce(&mut ParticleField, &mut EffectModel) -> T) -> T {
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        let (field, model) = &mut *state;
        run(field, model)
    }

    fn new(
        particles: &[[f64; 2]],
        surface: Surface,
        footprint: &Region,
        effect: Effect,
    ) -> PyResult<Self> {
        let points: Vec<Point2> = particles.iter().copied().map(Into::into).collect();
        let particles = ParticleDistribution::new(&points).map_err(plain)?;
        let state = (
            ParticleField::new(&particles),
            EffectModel::new(footprint, effect),
        );
        Ok(Self {
            surface,
            state: Mutex::new(state),
        })
    }
}

fn polygon(name: &str, given: &Bound<'_, PyAny>) -> PyResult<Polygon> {
    let corners = rows::<2>(name, given)?;
    if corners.len() < 3 || corners.iter().flatten().any(|x| !x.is_finite()) {
        let found = format!("{} corners", corners.len());
        return Err(refused(name, found, "three finite corners or more"));
    }
    let corners = corners.into_iter().map(Point2::from).collect();
    Ok(Polygon::new(corners, vec![]))
}

#[pymethods]
impl PyEffectField {
    /// Creates particles (N, 2) [m] on a surface with an outline (corners, 2) [m], and a tool with a footprint
    /// (corners, 2) [m] in its own frame. The effect is "push", "absorb" or "treat".
    #[new]
    #[pyo3(signature = (particles, outline, footprint, effect = "push"))]
    fn of_polygons(
        particles: &Bound<'_, PyAny>,
        outline: &Bound<'_, PyAny>,
        footprint: &Bound<'_, PyAny>,
        effect: &str,
    ) -> PyResult<Self> {
        let effect = match effect {
            "push" => Effect::Push,
            "absorb" => Effect::Absorb,
            "treat" => Effect::Treat,
            other => {
                let known = "\"push\", \"absorb\" or \"treat\"";
                return Err(refused("effect", format!("{other:?}"), known));
            }
        };
        let surface = Surface {
            name: "surface".to_owned(),
            outline: polygon("outline", outline)?,
            world_from_surface: Pose::identity(),
            skim_edges: Vec::new(),
            shape: Default::default(),
        };
        let footprint = Region::new(vec![polygon("footprint", footprint)?]);
        Self::new(&rows("particles", particles)?, surface, &footprint, effect)
    }

    /// Creates the field of a task's particles, surface, tool and action.
    #[staticmethod]
    fn of_task(task: &PyTask) -> PyResult<Self> {
        let task = &task.loaded.task;
        let particles: Vec<[f64; 2]> = task.particles.remaining().map(Into::into).collect();
        let (surface, tool) = (task.surface.clone(), &task.tool);
        Self::new(&particles, surface, &tool.footprint, task.action.effect())
    }

    /// Moves the tool in contact through poses x, y [m] and yaw [rad], (k, 3) in the frame of the surface; a single
    /// pose is a touch. Returns the numbers of particles absorbed, pushed, lost over an edge, and treated.
    fn apply<'py>(
        &self,
        py: Python<'py>,
        poses: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let poses = rows::<3>("poses", poses)?;
        if let Some(row) = poses.iter().position(|p| p.iter().any(|x| !x.is_finite())) {
            let place = format!("poses[{row}]");
            let value = format!("{:?}", poses[row]);
            return Err(refused(&place, value, "finite numbers"));
        }
        let poses = poses
            .iter()
            .map(|&[x, y, heading]| PlanarPose::new(Point2::new(x, y), heading));
        let poses: Vec<PlanarPose> = poses.collect();
        let mut all = MotionEffect::default();
        py.detach(|| {
            self.with(|field, model| {
                let touch = [poses.clone(), poses.clone()].concat();
                let way = if poses.len() == 1 { &touch } else { &poses };
                for pair in way.windows(2) {
                    let (from, to) = (pair[0], pair[1]);
                    let effect = model.apply(field, &self.surface, &ToolMotion { from, to });
                    all.absorbed += effect.absorbed;
                    all.pushed += effect.pushed;
                    all.off_surface += effect.off_surface;
                    all.treated += effect.treated;
                }
                model.lift_off(field, &self.surface);
            });
        });
        let counts = PyDict::new(py);
        counts.set_item("absorbed", all.absorbed)?;
        counts.set_item("pushed", all.pushed)?;
        counts.set_item("off_surface", all.off_surface)?;
        counts.set_item("treated", all.treated)?;
        Ok(counts)
    }

    /// Positions of the particles, or where they left the surface, in their original order, (N, 2) [m].
    #[getter]
    fn particles<'py>(&self, py: Python<'py>) -> Matrix<'py> {
        self.with(|field, _| arrays::places(py, &field.distribution()))
    }

    /// Fates of the particles: 0 on the surface, 1 absorbed, 2 off the surface, (N).
    #[getter]
    fn fates<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i8>> {
        self.with(|field, _| arrays::fates(py, &field.distribution()))
    }
}
