//! One stroke of the arm of seven joints over a small board, to be executed in any reality.

use std::ops::ControlFlow;
use wisch::control::ControlConfig;
use wisch::follow::{FollowConfig, Followed, Phase, Workcell, follow};
use wisch::geometry::{Pose, Vector3};
use wisch::represent::{Action, GrainSize, LogNormal, MediumKind, Mount, Task};
use wisch::run::{Ending, Execution, MotionOrder, TelemetrySample};
use wisch_sim::{
    Dirt, GrainCount, GroundTruth, RealTool, Sensing, SimulationSettings, TrueDirt, Waviness,
    execute,
};
use wisch_testkit::{board, cell, first_stroke, planned};

/// Force that the tool shall be pressed on with [N].
pub const FORCE: f64 = 10.0;
/// How far the mean of the true force may be off, and its greatest deviation [N].
const FORCE_TOLERANCE: f64 = 1.0;
const FORCE_SPREAD: f64 = 1.0;
/// How far the tool may be from the plane of the surface [m].
const PLANE_TOLERANCE: f64 = 2e-3;
/// Commanded speed from which on a tool slides [m/s], and how long it does so before forces count [s].
const SLIDING: f64 = 0.01;
const SETTLING: f64 = 0.3;

/// What is to be executed.
#[derive(Clone)]
pub struct Wiping {
    pub task: Task,
    pub cell: Workcell,
    pub followed: Followed,
    pub settings: SimulationSettings,
    pub dirt: Dirt,
    pub config: ControlConfig,
    pub seed: u64,
}

/// One sample.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    pub time: f64,
    pub positions: Vec<f64>,
    pub velocities: Vec<f64>,
    pub efforts: Vec<f64>,
    pub world_from_commanded: Pose,
    pub world_from_tool: Pose,
    pub controller: Vector3,
    pub external: Vector3,
    pub phase: Phase,
}

/// What came of it.
pub struct Log {
    pub executed: Execution,
    pub truth: GroundTruth,
    pub rows: Vec<Row>,
}

impl Wiping {
    /// The first stroke of the board's plan, without dirt.
    pub fn of_one_stroke(action: Action) -> Self {
        let mut task = board(action, [0.5, 0.0, 0.2]);
        // The bounds of the tests are chosen for this mount.
        task.tool.mount = Some(Mount::Hand { lean: 0.8 });
        Self::of_first_stroke(task)
    }

    /// The first stroke of a task's plan, without dirt.
    pub fn of_first_stroke(task: Task) -> Self {
        let plan = first_stroke(planned(&task));
        let cell = cell(&task);
        // The stroke as planned: tests put things in its way, and waves under it.
        let config = FollowConfig {
            free_order: false,
            free_yaw: false,
            ..FollowConfig::default()
        };
        let followed = follow(&task, &plan, &cell, None, &config, &mut |_| ()).unwrap();
        assert_eq!(followed.abandoned, []);
        Self {
            task,
            cell,
            followed,
            settings: as_believed(),
            dirt: Dirt::default(),
            config: ControlConfig::default(),
            seed: 0,
        }
    }

    /// The time at which the first wiping motion is half done [s].
    pub fn midst(&self) -> f64 {
        let motions = &self.followed.motions;
        let wipe = motions.iter().find(|m| m.phase.is_contact()).unwrap();
        0.5 * (wipe.start + wipe.end())
    }

    pub fn execute(&self) -> Log {
        self.execute_until(f64::INFINITY)
    }

    /// Stops it at a time [s].
    pub fn execute_until(&self, time: f64) -> Log {
        let mut rows = Vec::new();
        let order = MotionOrder {
            round: 1,
            seed: self.seed,
            task: &self.task,
            cell: &self.cell,
            followed: &self.followed,
        };
        let executed = execute(
            &order,
            &self.settings,
            &self.dirt,
            &self.config,
            &mut |sample| {
                rows.push(Row::of(sample));
                if sample.time >= time {
                    return ControlFlow::Break(());
                }
                ControlFlow::Continue(())
            },
        );
        let (executed, truth) = executed.unwrap();
        Log {
            executed,
            truth,
            rows,
        }
    }
}

impl Row {
    fn of(sample: &TelemetrySample<'_>) -> Self {
        Self {
            time: sample.time,
            positions: sample.positions.to_vec(),
            velocities: sample.velocities.to_vec(),
            efforts: sample.efforts.to_vec(),
            world_from_commanded: sample.world_from_commanded,
            world_from_tool: sample.world_from_tool,
            controller: sample.controller.force,
            external: sample.external.force,
            phase: sample.phase,
        }
    }

    /// All its numbers.
    pub fn numbers(&self) -> Vec<f64> {
        let mut numbers = vec![self.time];
        for part in [&self.positions, &self.velocities, &self.efforts] {
            numbers.extend(part);
        }
        for pose in [&self.world_from_commanded, &self.world_from_tool] {
            numbers.extend(pose.to_homogeneous().iter());
        }
        for force in [&self.controller, &self.external] {
            numbers.extend(force.iter());
        }
        numbers
    }
}

impl Log {
    pub fn bytes(&self) -> Vec<u8> {
        let numbers = self.rows.iter().flat_map(Row::numbers);
        numbers.flat_map(f64::to_le_bytes).collect()
    }

    /// Rows in which the tool has slid for a while.
    pub fn sliding(&self) -> impl Iterator<Item = &Row> {
        let mut since = None;
        let commanded = |row: &Row| row.world_from_commanded.translation.vector;
        self.rows.windows(2).filter_map(move |pair| {
            let elapsed = pair[1].time - pair[0].time;
            let speed = (commanded(&pair[1]) - commanded(&pair[0])).norm() / elapsed;
            if !pair[1].phase.is_contact() || speed < SLIDING {
                since = None;
                return None;
            }
            let since = *since.get_or_insert(pair[1].time);
            (pair[1].time - since > SETTLING).then_some(&pair[1])
        })
    }

    /// Greatest distance of the tool from its commanded position [m].
    pub fn furthest(&self) -> f64 {
        let apart = self.rows.iter().map(|row| {
            let told = row.world_from_commanded.translation.vector;
            (told - row.world_from_tool.translation.vector).norm()
        });
        apart.fold(0.0, f64::max)
    }

    /// That everything is a number, and where it stopped itself.
    pub fn assert_finite(&self) {
        for row in &self.rows {
            assert!(
                row.numbers().iter().all(|n| n.is_finite()),
                "at {} s",
                row.time
            );
        }
        let truth = &self.truth;
        assert!(truth.max_controller_force.is_finite() && truth.contact_force.mean().is_finite());
        assert!(self.executed.positions.iter().all(|q| q.is_finite()));
    }

    pub fn is_stopped(&self) -> bool {
        matches!(self.executed.ending, Ending::ProtectiveStop { .. })
    }
}

/// The world as the plan takes it to be, with perfect sensors.
pub fn as_believed() -> SimulationSettings {
    SimulationSettings {
        believed_from_real: Pose::identity(),
        shape: None,
        friction: 0.4,
        friction_changes: Vec::new(),
        pushes: Vec::new(),
        force_noise: 0.0,
        force_bias: Vector3::zeros(),
        likelihood: LogNormal {
            mu: -1.0,
            sigma: 0.25,
        },
        grain_size: GrainSize {
            min_m: 0.002,
            max_m: 0.003,
        },
        kind: MediumKind::Solid,
        mobility: Default::default(),
        max_bodies: 400,
        dirt: TrueDirt::Uniform,
        count: GrainCount::Exactly(80),
        grain_mass: None,
        grains_resist: true,
        tool: RealTool::default(),
        sensing: Sensing::default(),
        joint_friction: 0.0,
        waviness: Waviness::default(),
        camera: None,
    }
}

/// Everything that is wrong with an undisturbed wipe.
pub fn faults(log: &Log) -> Vec<String> {
    let truth = &log.truth;
    let (mean, spread) = (truth.contact_force.mean(), truth.contact_force.deviation());
    let mut faults = controller_faults(log);
    if (mean - FORCE).abs() > FORCE_TOLERANCE {
        faults.push(format!("mean contact force {mean:.2} N"));
    }
    if spread > FORCE_SPREAD {
        faults.push(format!("contact force spreads by {spread:.2} N"));
    }
    if truth.max_plane_distance > PLANE_TOLERANCE {
        let distance = 1e3 * truth.max_plane_distance;
        faults.push(format!("the tool is {distance:.1} mm from the plane"));
    }
    if truth.lost_share > 0.0 {
        let share = 100.0 * truth.lost_share;
        faults.push(format!("contact is lost for {share:.1} % of the time"));
    }
    faults
}

/// The controller pulls harder than allowed, or in another direction than commanded.
pub fn controller_faults(log: &Log) -> Vec<String> {
    // Rounding, where a force is cut to its limit.
    let limit = FORCE + 1e-9;
    let greatest = log.truth.max_controller_force;
    let told = (log.rows.iter()).map(|row| row.controller.norm());
    let told = told.fold(0.0, f64::max);
    [("the truth", greatest), ("the log", told)]
        .into_iter()
        .filter(|(_, force)| *force > limit)
        .map(|(who, force)| format!("the controller pulls with {force:.2} N, says {who}"))
        .collect()
}
