//! The bags of a run: one per round, written during execution.

use crate::sink::{RunSink, SinkError};
use std::path::PathBuf;
use wisch::geometry::{Point3, Pose};
use wisch::represent::{Observation, Surface, SurfaceShape, Task};
use wisch::robot::show_collision_shapes;
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
    /// Whether the bag holds a sample.
    has_samples: bool,
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
            has_samples: false,
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

    /// Finishes the bag of a round, also if its execution or interpretation failed. Removes the bag of a round that did not
    /// begin to move.
    ///
    /// # Errors
    /// If the bag cannot be written or removed.
    pub fn end(&mut self) -> Result<(), WriteError> {
        let Some(bag) = self.bag.take() else {
            return Ok(());
        };
        if self.is_executed || self.has_samples {
            return bag.finish();
        }
        let path = bag.active_path().to_owned();
        drop(bag);
        std::fs::remove_file(&path).map_err(|error| WriteError::File { path, error })
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
            RunEvent::Sample(sample) => {
                self.has_samples = true;
                self.bag.as_mut().map_or(Ok(()), |bag| bag.write(sample))
            }
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
            ("press_force_n", task.interaction.press_force_n.to_string()),
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
            let hand = &robot.links()[planned.cell.tip().index()].name;
            bag.write_robot(&BagRobot {
                urdf: &show_collision_shapes(urdf, hand),
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
        self.has_samples = false;
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

#[cfg(test)]
mod tests {
    use super::*;
    use std::ops::ControlFlow;
    use wisch::run::{Execution, Executor, ExecutorError, MotionOrder, RobotState, SampleSink};
    use wisch_io::{LoadOptions, load_task};

    /// An executor whose robot is not at the start of its motion.
    struct Elsewhere(usize);

    impl Executor for Elsewhere {
        fn execute(
            &mut self,
            _: &MotionOrder<'_>,
            _: &mut SampleSink<'_>,
        ) -> Result<Execution, ExecutorError> {
            Err(ExecutorError::new("it was executed"))
        }

        fn state(&mut self) -> Result<Option<RobotState>, ExecutorError> {
            Ok(Some(vec![2.0; self.0].into()))
        }
    }

    #[test]
    fn a_round_that_does_not_begin_to_move_leaves_no_bag() {
        let path = concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/../../scenarios/arm-board.toml"
        );
        let loaded = load_task(path.as_ref(), &LoadOptions::default()).expect("a task");
        let robot = loaded.robot().expect("a robot").expect("it names one");
        let folder = tempfile::tempdir().expect("a folder");
        let mut bags = BagSink::new(folder.path().to_owned(), None, &loaded.task);
        let mut session = loaded.session().with_robot(robot.robot_setup());
        let mut executor = Elsewhere(7);
        let run = session.run(&mut executor, &mut |event| {
            bags.take_in(event).expect("written");
            ControlFlow::Continue(())
        });
        let error = run.expect_err("it is refused").to_string();
        assert!(error.contains("from the start of the motion"), "{error}");
        let count = || std::fs::read_dir(folder.path()).expect("a folder").count();
        assert_eq!(count(), 1);
        bags.end().expect("removed");
        assert_eq!(count(), 0);
    }
}
