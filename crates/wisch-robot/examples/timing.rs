//! Times a joint path: `timing PATH.csv LIMITS.csv [BLEND_TOLERANCE] [SAMPLES.csv]`.
//!
//! Each line of the path is a waypoint, one position [rad or m] per joint; each line of the limits is a
//! joint: `name,lower,upper,velocity,acceleration`. Prints the duration [s], the number of faults that the
//! checker finds, and the milliseconds taken, comma-separated. With a fourth argument it also writes
//! time, q, qd, qdd every millisecond.

use std::time::Instant;
use wisch_robot::timing::{
    JointLimit, JointLimits, JointPath, SAMPLE_PERIOD, TimingConfig, TrajectoryCheckConfig,
    time_path, trajectory_faults,
};

type Failure = Box<dyn std::error::Error>;

fn rows<T: serde::de::DeserializeOwned>(path: &str) -> Result<Vec<T>, Failure> {
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .from_path(path)?;
    Ok(reader.deserialize().collect::<Result<_, _>>()?)
}

fn main() -> Result<(), Failure> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [path, limits, optional @ ..] = arguments.as_slice() else {
        return Err("usage: timing PATH.csv LIMITS.csv [BLEND_TOLERANCE] [SAMPLES.csv]".into());
    };
    let path = JointPath::new(&rows::<Vec<f64>>(path)?)?;
    let limits = rows::<(String, f64, f64, f64, f64)>(limits)?
        .into_iter()
        .map(|(name, lower, upper, velocity, acceleration)| JointLimit {
            name,
            lower,
            upper,
            velocity,
            acceleration,
        })
        .collect();
    let limits = JointLimits::new(limits)?;
    let mut config = TimingConfig::default();
    if let Some(tolerance) = optional.first() {
        config.blend_tolerance = tolerance.parse()?;
    }

    let begin = Instant::now();
    let trajectory = time_path(&path, &limits, &config)?;
    let milliseconds = begin.elapsed().as_secs_f64() * 1e3;
    let samples: Vec<_> = trajectory.samples(SAMPLE_PERIOD).collect();
    let check = TrajectoryCheckConfig {
        path_deviation: config.blend_tolerance,
        ..TrajectoryCheckConfig::default()
    };
    let faults = trajectory_faults(&samples, &path, &limits, &check);
    println!(
        "{:.9},{},{milliseconds:.3}",
        trajectory.duration(),
        faults.len()
    );
    for fault in faults.iter().take(5) {
        eprintln!("{fault}");
    }

    if let Some(file) = optional.get(1) {
        let mut writer = csv::WriterBuilder::new()
            .has_headers(false)
            .from_path(file)?;
        for sample in &samples {
            writer.serialize((sample.time, &sample.q, &sample.qd, &sample.qdd))?;
        }
        writer.flush()?;
    }
    Ok(())
}
