//! A bag of each round, written while it is executed.

use crate::sink::{RunSink, SinkError};
use std::path::PathBuf;
use wisch::geometry::{Point3, Pose};
use wisch::represent::{Observation, Task};
use wisch::run::{PlannedRound, RunEvent};
use wisch_telemetry::{BagHead, BagWriter, LookTime, RobotShown, SceneShown, WriteError};

/// The name of a round's bag, counted from 1.
pub fn bag_name(round: usize) -> String {
    format!("round-{round}.mcap")
}

/// Writes what is measured as MCAP: a bag of each round, at full rate. What the viewers of robotics show is in it too: robot,
/// scene, strokes and particles.
pub struct BagSink {
    folder: PathBuf,
    /// Rounds that an earlier run executed and recorded.
    taken_over: usize,
    /// The robot's description.
    urdf: Option<String>,
    bag: Option<BagWriter>,
    /// Whether what the bag records is over.
    is_executed: bool,
    /// Where the surface was believed to be when it was planned, and what was last seen of it.
    world_from_surface: Pose,
    seen: Option<Seen>,
    round: usize,
}

impl BagSink {
    /// A sink that writes `round-1.mcap` and so on into a folder that is there.
    ///
    /// # Parameters
    /// - `urdf`: the robot's description, which the bags hold; `None` leaves it out.
    /// - `task`: the task, with its surface where it is believed to be at the start.
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

    /// The same, but the bags of so many rounds are there already.
    #[must_use]
    pub fn after(self, taken_over: usize) -> Self {
        Self { taken_over, ..self }
    }

    /// Ends the bag of a round that was executed, whatever became of it afterwards.
    ///
    /// # Errors
    /// What the system says.
    pub fn end(&mut self) -> Result<(), WriteError> {
        let bag = self.bag.take_if(|_| self.is_executed);
        bag.map_or(Ok(()), BagWriter::finish)
    }

    /// Takes in one event.
    pub(crate) fn take_in(&mut self, event: &RunEvent<'_>) -> Result<(), WriteError> {
        self.follow(event);
        if self.round <= self.taken_over {
            return Ok(());
        }
        self.write(event)
    }

    /// Follows which round it is and what is seen, taken over or not.
    fn follow(&mut self, event: &RunEvent<'_>) {
        match event {
            RunEvent::Executing(planned) => {
                self.round = planned.number;
                self.world_from_surface = planned.task.surface.world_from_surface;
            }
            // The bag of this round has been begun with what was seen before it.
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
                bag.write_observation(LookTime::After, observation)
            }),
            RunEvent::Judged(_) => self.end(),
            _ => Ok(()),
        }
    }

    fn begin(&mut self, planned: &PlannedRound) -> Result<(), WriteError> {
        let robot = planned.cell.robot();
        let task = &planned.task;
        let head = BagHead {
            joints: (0..robot.dof())
                .map(|i| robot.variable(i).name.clone())
                .collect(),
            world_from_surface: task.surface.world_from_surface,
            start: 0,
            notes: [
                ("task", task.name.clone()),
                ("round", planned.number.to_string()),
                ("seed", task.seed.to_string()),
            ]
            .map(|(key, value)| (key.to_owned(), value))
            .into(),
        };
        let path = self.folder.join(bag_name(planned.number));
        let mut bag = BagWriter::create(&path, head)?;
        if let Some(urdf) = &self.urdf {
            bag.write_robot(&RobotShown {
                urdf,
                model: robot,
                world_from_root: *planned.cell.world_from_root(),
            })?;
        }
        bag.write_scene(&SceneShown {
            surface: &task.surface,
            objects: &task.scene,
            tool: &task.tool.mesh,
            goal: &planned.plan.graph.goal,
        })?;
        bag.write_strokes(&planned.followed.strokes)?;
        bag.write_particles(0.0, &in_world(task))?;
        if let Some(seen) = &self.seen {
            let before = seen.of_surface(&task.surface.world_from_surface);
            bag.write_observation(LookTime::Before, &before)?;
        }
        self.bag = Some(bag);
        self.is_executed = false;
        Ok(())
    }
}

impl RunSink for BagSink {
    /// Takes in one event. A bag that cannot be written ends the run in order.
    fn on_event(&mut self, event: &RunEvent<'_>) -> Result<(), SinkError> {
        self.take_in(event).map_err(SinkError::end_in_order)
    }
}

/// What was seen of a surface that was believed to be there.
pub(crate) struct Seen {
    pub world_from_surface: Pose,
    pub observation: Observation,
}

impl Seen {
    /// The same, of the surface believed elsewhere since.
    pub fn of_surface(&self, world_from_surface: &Pose) -> Observation {
        if self.world_from_surface == *world_from_surface {
            return self.observation.clone();
        }
        let now_from_then = world_from_surface.inverse() * self.world_from_surface;
        self.observation.moved(&now_from_then)
    }
}

/// Where a task's particles are believed to lie in the world.
fn in_world(task: &Task) -> Vec<Point3> {
    let remaining = task.particles.remaining();
    remaining
        .map(|p| task.surface.world_from_surface * Point3::new(p.x, p.y, 0.0))
        .collect()
}
