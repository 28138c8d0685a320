//! The table `[execution]`: what a simulated execution takes for real.

use super::reader::{Field, Section};
use super::{ExecutionRecord, FrictionChange, Push, TaskError};
use nalgebra::{Translation3, UnitQuaternion};
use std::ops::RangeInclusive;
use wisch::geometry::{Pose, Vector3};

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
        }
    }
}

/// What is taken for real, and how many rounds there may be.
pub(super) fn execution(field: Option<&Field<'_>>) -> Result<(ExecutionRecord, usize), TaskError> {
    let Some(field) = field else {
        return Ok((ExecutionRecord::default(), ROUNDS_DEFAULT));
    };
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
    let max_rounds = whole("max_rounds", ROUNDS, ROUNDS_DEFAULT)?;
    let record = ExecutionRecord {
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
    };
    Ok((record, max_rounds))
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
