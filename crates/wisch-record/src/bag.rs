//! The bags of a run: one per round, written during execution.

use crate::sink::{RunSink, SinkError};
use std::path::PathBuf;
use wisch::geometry::{Point3, Pose};
use wisch::represent::{Observation, Surface, SurfaceShape, Task};
use wisch::run::{PlannedRound, RunEvent};
use wisch_telemetry::{BagHead, BagRobot, BagScene, BagWriter, ObservationTime, WriteError};

/// Returns the file name of a round's bag. `round`: number from 1.
pub fn bag_name(round: usize) -> String {
    format!("round-{round}.mcap")
}

/// A sink that writes a bag (MCAP) of each round at full rate. For viewers such as Foxglove and Rerun, the bag also holds
/// robot, scene, strokes and particles.
pub struct BagSink {
    folder: PathBuf,
    /// Number of rounds whose bags a killed run has written.
    taken_over: usize,
    /// The robot's URDF.
    urdf: Option<String>,
    bag: Option<BagWriter>,
    /// Whether the round of the bag is executed.
    is_executed: bool,
    /// Believed surface pose of the current plan, and the last observation.
    world_from_surface: Pose,
    seen: Option<Seen>,
    round: usize,
}

impl BagSink {
    /// Makes a sink that writes `round-1.mcap`, `round-2.mcap`, … into an existing folder.
    ///
    /// # Parameters
    /// - `urdf`: the robot's URDF for the bags; `None` leaves it out.
    /// - `task`: the task, with its surface at the initially believed pose.
    pub fn new(folder: PathBuf, urdf: Option<&str>, task: &Task) -> Self {
        Self {
            folder,
            taken_over: 0,
            urdf: urdf.map(str::to_owned),
            bag: None,
            is_executed: false,
            world_from_surface: task.surface.world_from_surface,
            seen: None,
            round: 0,
        }
    }

    /// Returns the sink for a resumed run. `taken_over`: number of rounds whose bags exist already.
    #[must_use]
    pub fn with_resumed_rounds(self, taken_over: usize) -> Self {
        Self { taken_over, ..self }
    }

    /// Path of the bag of the current round, once it is finished.
    pub(crate) fn path(&self) -> PathBuf {
        self.folder.join(bag_name(self.round))
    }

    /// Finishes the bag of an executed round, also if its interpretation failed.
    ///
    /// # Errors
    /// If the bag cannot be written.
    pub fn end(&mut self) -> Result<(), WriteError> {
        let bag = self.bag.take_if(|_| self.is_executed);
        bag.map_or(Ok(()), BagWriter::finish)
    }

    /// Receives one event.
    pub(crate) fn take_in(&mut self, event: &RunEvent<'_>) -> Result<(), WriteError> {
        self.follow(event);
        if self.round <= self.taken_over {
            return Ok(());
        }
        self.write(event)
    }

    /// Tracks the round and the last observation, also in rounds of a killed run.
    fn follow(&mut self, event: &RunEvent<'_>) {
        match event {
            RunEvent::Executing(planned) => {
                self.round = planned.number;
                self.world_from_surface = planned.task.surface.world_from_surface;
            }
            // The bag of this round already holds the observation from before the round.
            RunEvent::Observed { observation, .. } => {
                self.seen = Some(Seen {
                    world_from_surface: self.world_from_surface,
                    observation: (*observation).clone(),
                });
            }
            _ => {}
        }
    }

    fn write(&mut self, event: &RunEvent<'_>) -> Result<(), WriteError> {
        match event {
            RunEvent::Executing(planned) => self.begin(planned),
            RunEvent::Sample(sample) => self.bag.as_mut().map_or(Ok(()), |bag| bag.write(sample)),
            RunEvent::Interpreting { .. } => {
                self.is_executed = true;
                Ok(())
            }
            RunEvent::Observed { observation, .. } => (self.bag.as_mut()).map_or(Ok(()), |bag| {
                bag.write_observation(ObservationTime::After, observation)
            }),
            RunEvent::Decided(_) => self.end(),
            _ => Ok(()),
        }
    }

    fn begin(&mut self, planned: &PlannedRound) -> Result<(), WriteError> {
        let robot = planned.cell.robot();
        let task = &planned.task;
        let notes = [
            ("task", task.name.clone()),
            ("round", planned.number.to_string()),
            ("seed", task.seed.to_string()),
        ];
        let mesh = match &task.surface.shape {
            SurfaceShape::Mesh(mesh) => Some(("surface_mesh", format!("{:032x}", mesh.digest()))),
            _ => None,
        };
        let head = BagHead {
            joints: (0..robot.dof())
                .map(|i| robot.variable(i).name.clone())
                .collect(),
            world_from_surface: task.surface.world_from_surface,
            start: 0,
            notes: (notes.into_iter().chain(mesh))
                .map(|(key, value)| (key.to_owned(), value))
                .collect(),
        };
        let path = self.path();
        let mut bag = BagWriter::create(&path, head)?;
        if let Some(urdf) = &self.urdf {
            bag.write_robot(&BagRobot {
                urdf,
                model: robot,
                world_from_root: *planned.cell.world_from_root(),
            })?;
        }
        bag.write_scene(&BagScene {
            surface: &task.surface,
            objects: &task.scene,
            tool: &task.tool.mesh,
            goal: &planned.plan.graph.goal,
        })?;
        bag.write_strokes(&planned.followed.strokes)?;
        bag.write_particles(0.0, &in_world(task))?;
        if let Some(seen) = &self.seen {
            let before = seen.transform_to_surface(&task.surface);
            bag.write_observation(ObservationTime::Before, &before)?;
        }
        self.bag = Some(bag);
        self.is_executed = false;
        Ok(())
    }
}

impl RunSink for BagSink {
    /// Receives one event. A bag that cannot be written stops the run cleanly.
    fn on_event(&mut self, event: &RunEvent<'_>) -> Result<(), SinkError> {
        self.take_in(event).map_err(SinkError::stop_run)
    }
}

/// An observation with the surface pose that was believed at that time.
pub(crate) struct Seen {
    pub world_from_surface: Pose,
    pub observation: Observation,
}

impl Seen {
    /// Returns the observation in the chart of the same surface at another pose.
    pub fn transform_to_surface(&self, surface: &Surface) -> Observation {
        if self.world_from_surface == surface.world_from_surface {
            return self.observation.clone();
        }
        let now_from_then = surface.world_from_surface.inverse() * self.world_from_surface;
        self.observation.transform(&now_from_then, &surface.shape)
    }
}

/// Returns the believed positions of a task's particles in the world [m].
fn in_world(task: &Task) -> Vec<Point3> {
    let remaining = task.particles.remaining();
    remaining
        .map(|p| {
            (task.surface.world_from_place(p, 0.0).translation)
                .vector
                .into()
        })
        .collect()
}
