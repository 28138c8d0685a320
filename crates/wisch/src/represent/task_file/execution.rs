//! The table `[execution]`: what a simulated execution takes for real.

use super::reader::{Field, Section};
use super::{ExecutionRecord, TaskError, TaskFile};
use crate::geometry::{Pose, Vector3};
use crate::represent::{
    FrictionChange, GrainSize, KnowledgeBase, KnowledgeError, LogNormal, MediumKind, Push, Reality,
    Task,
};
use nalgebra::{Translation3, UnitQuaternion};
use std::ops::RangeInclusive;

pub(super) const EXECUTION_KEYS: &[&str] = &[
    "surface_tilt_rad",
    "surface_shift_m",
    "friction",
    "friction_change",
    "push",
    "force_noise_n",
    "force_bias_n",
    "mu",
    "sigma",
    "max_bodies",
    "max_rounds",
];
pub(super) const PUSH_KEYS: &[&str] = &[
    "round",
    "start_s",
    "duration_s",
    "force_n",
    "hand_speed_m_per_s",
];
pub(super) const FRICTION_KEYS: &[&str] = &["round", "start_s", "friction"];

/// Beyond this a surface is another one, not one badly localised.
const TILT_RAD: RangeInclusive<f64> = -0.3..=0.3;
const SHIFT_M: RangeInclusive<f64> = -0.2..=0.2;
/// From ice to rubber.
const FRICTION: RangeInclusive<f64> = 0.0..=2.0;
/// Executions of up to an hour.
const TIME_S: RangeInclusive<f64> = 0.0..=3600.0;
const DURATION_S: RangeInclusive<f64> = 1e-3..=60.0;
/// What people push with.
const FORCE_N: RangeInclusive<f64> = -200.0..=200.0;
const HAND_SPEED: RangeInclusive<f64> = 1e-3..=2.0;
const NOISE_N: RangeInclusive<f64> = 0.0..=10.0;
const BIAS_N: RangeInclusive<f64> = -20.0..=20.0;
const LOG_FORCE: RangeInclusive<f64> = -20.0..=20.0;
const LOG_SPREAD: RangeInclusive<f64> = 1e-3..=20.0;
const BODIES: RangeInclusive<u64> = 0..=2000;
const ROUNDS: RangeInclusive<u64> = 1..=100;

/// Speed of a hand that leads a robot away [m/s].
const HAND_SPEED_DEFAULT: f64 = 0.1;
/// A good joint-torque sensor at the tool [N].
const NOISE_DEFAULT: f64 = 0.15;
/// As many grains as are simulated at several times real time.
const BODIES_DEFAULT: usize = 400;
const ROUNDS_DEFAULT: usize = 4;
/// Drops of a liquid on a surface that they wet [m].
const DROPS: GrainSize = GrainSize {
    min_m: 0.002,
    max_m: 0.004,
};
/// Smaller grains are simulated as ones of this diameter [m]: a contact of two smaller bodies is not
/// resolved at 1 kHz.
const LEAST_GRAIN: f64 = 0.0008;

impl Default for ExecutionRecord {
    fn default() -> Self {
        Self {
            believed_from_real: Pose::identity(),
            friction: None,
            friction_changes: Vec::new(),
            pushes: Vec::new(),
            force_noise: NOISE_DEFAULT,
            force_bias: Vector3::zeros(),
            mu: None,
            sigma: None,
            max_bodies: BODIES_DEFAULT,
            max_rounds: ROUNDS_DEFAULT,
        }
    }
}

pub(super) fn execution(field: &Field<'_>) -> Result<ExecutionRecord, TaskError> {
    let section = field.section(EXECUTION_KEYS)?;
    let usual = ExecutionRecord::default();
    let vector = |key, limits: &RangeInclusive<f64>| -> Result<Vector3, TaskError> {
        let numbers = section.get(key).map(|field| field.numbers::<3>(limits));
        Ok(numbers
            .transpose()?
            .map_or_else(Vector3::zeros, Vector3::from))
    };
    let tilt = section.get("surface_tilt_rad");
    let [about_x, about_y] = tilt.map_or(Ok([0.0; 2]), |field| field.numbers::<2>(&TILT_RAD))?;
    let shift = vector("surface_shift_m", &SHIFT_M)?;
    let number = |key, limits: &RangeInclusive<f64>| {
        section
            .get(key)
            .map(|field| field.number(limits))
            .transpose()
    };
    let whole = |key, limits: RangeInclusive<u64>, usual: usize| {
        let given = section.get(key).map(|field| field.integer(limits));
        Ok::<_, TaskError>(given.transpose()?.map_or(usual, |n| n as usize))
    };
    Ok(ExecutionRecord {
        believed_from_real: Pose::from_parts(
            Translation3::from(shift),
            UnitQuaternion::from_scaled_axis(Vector3::new(about_x, about_y, 0.0)),
        ),
        friction: number("friction", &FRICTION)?,
        friction_changes: tables(section, "friction_change", FRICTION_KEYS, |table| {
            Ok(FrictionChange {
                round: round(table)?,
                time: table.require("start_s")?.number(&TIME_S)?,
                friction: table.require("friction")?.number(&FRICTION)?,
            })
        })?,
        pushes: tables(section, "push", PUSH_KEYS, |table| {
            Ok(Push {
                round: round(table)?,
                start: table.require("start_s")?.number(&TIME_S)?,
                duration: table.require("duration_s")?.number(&DURATION_S)?,
                force: Vector3::from(table.require("force_n")?.numbers::<3>(&FORCE_N)?),
                hand_speed: table.number_or(
                    "hand_speed_m_per_s",
                    &HAND_SPEED,
                    HAND_SPEED_DEFAULT,
                )?,
            })
        })?,
        force_noise: section.number_or("force_noise_n", &NOISE_N, usual.force_noise)?,
        force_bias: vector("force_bias_n", &BIAS_N)?,
        mu: number("mu", &LOG_FORCE)?,
        sigma: number("sigma", &LOG_SPREAD)?,
        max_bodies: whole("max_bodies", BODIES, usual.max_bodies)?,
        max_rounds: whole("max_rounds", ROUNDS, usual.max_rounds)?,
    })
}

fn round(table: Section<'_>) -> Result<usize, TaskError> {
    let given = table.get("round").map(|field| field.integer(ROUNDS));
    Ok(given.transpose()?.map_or(1, |n| n as usize))
}

fn tables<T>(
    section: Section<'_>,
    key: &'static str,
    keys: &[&'static str],
    read: impl Fn(Section<'_>) -> Result<T, TaskError>,
) -> Result<Vec<T>, TaskError> {
    let Some(field) = section.get(key) else {
        return Ok(Vec::new());
    };
    let items = field.items("an array of tables")?;
    items.iter().map(|item| read(item.section(keys)?)).collect()
}

impl TaskFile {
    /// The world as a simulated execution of a task takes it for real: what the file says of it, over what
    /// the knowledge base says of surface and medium.
    ///
    /// # Errors
    /// If surface or medium of the task are unknown.
    pub fn reality(
        &self,
        task: &Task,
        knowledge: &KnowledgeBase,
    ) -> Result<Reality, KnowledgeError> {
        let record = &self.contents.execution;
        let medium = knowledge.medium(&task.medium)?;
        let likelihood = task.interaction.likelihood;
        let grain_size = medium.grain_size.unwrap_or(DROPS);
        Ok(Reality {
            believed_from_real: record.believed_from_real,
            friction: match record.friction {
                Some(friction) => friction,
                None => knowledge.surface(&task.surface.name)?.friction,
            },
            friction_changes: record.friction_changes.clone(),
            pushes: record.pushes.clone(),
            force_noise: record.force_noise,
            force_bias: record.force_bias,
            likelihood: LogNormal {
                mu: record.mu.unwrap_or(likelihood.mu),
                sigma: record.sigma.unwrap_or(likelihood.sigma),
            },
            grain_size: GrainSize {
                min_m: grain_size.min_m.max(LEAST_GRAIN),
                max_m: grain_size.max_m.max(LEAST_GRAIN),
            },
            kind: if medium.grain_size.is_none() {
                MediumKind::Liquid
            } else {
                medium.kind
            },
            max_bodies: record.max_bodies,
            max_rounds: record.max_rounds,
        })
    }
}
