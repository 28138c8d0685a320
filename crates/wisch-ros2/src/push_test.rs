//! The push test: sign and axes of the measured force, by pushes of a person in known directions.

use crate::commissioning::Commissioning;
use crate::connection::Connection;
use crate::messages::EmptyRequest;
use crate::robot_file::RobotFile;
use nalgebra::Vector3;
use std::io::{BufRead, Write};
use std::time::{Duration, Instant};

/// Time over which the resting force is measured, and longest wait for a push.
const REST: Duration = Duration::from_secs(2);
const PUSH_TIMEOUT: Duration = Duration::from_secs(60);
/// Least force of a push, and the time for which it must last.
const PUSH_N: f64 = 8.0;
const PUSH_TIME: Duration = Duration::from_millis(500);
/// Largest angle between a push and the measured force [degrees].
const MAX_ANGLE_DEG: f64 = 25.0;
/// Largest force after taring [N], and largest drift [N/min].
const TARED_N: f64 = 3.0;
const DRIFT_N_PER_MIN: f64 = 3.0;
/// The pushes: what to do, and the direction of the force of the hand on the tool, in the axes of the base frame.
const PUSHES: [(&str, [f64; 3]); 2] = [
    (
        "push the tool straight down, against the z axis of the base frame",
        [0.0, 0.0, -1.0],
    ),
    (
        "push the tool along the x axis of the base frame",
        [1.0, 0.0, 0.0],
    ),
];

/// Leads a person through the test, and writes its result beside the robot file. `asks`: wait for the Enter key.
///
/// # Errors
/// If the robot is not found, moves, or measures forces that do not fit the pushes; nothing is written then.
pub(crate) fn test(file: RobotFile, asks: bool) -> Result<(), String> {
    if file.force.topic.is_none() {
        let shown = file.path.display();
        return Err(format!(
            "{shown}: force.topic is missing, so there is no force to test"
        ));
    }
    let connection = Connection::open(file, "wisch_push_test")?;
    if let Some(fault) = connection.faults(&connection.survey()).first() {
        return Err(fault.clone());
    }
    say("Nothing moves in this test. The robot rests, and nothing touches the tool.");
    wait_for_enter(asks, "press Enter to tare")?;
    if let Some(tare) = &connection.tare {
        let answer = tare.call(EmptyRequest::default(), Duration::from_secs(3));
        let answer = answer.map_err(|error| error.to_string())?;
        if !answer.success {
            return Err(format!("{} refuses: {}", tare.name(), answer.message));
        }
        std::thread::sleep(Duration::from_millis(300));
    }
    let (bias, drift) = measure_rest(&connection)?;
    let residual = bias.norm();
    if connection.tare.is_some() && residual > TARED_N {
        return Err(format!(
            "the force is {residual:.1} N right after taring; the limit is {TARED_N} N"
        ));
    }
    if drift > DRIFT_N_PER_MIN {
        return Err(format!(
            "the force drifts by {drift:.1} N/min at rest; the limit is {DRIFT_N_PER_MIN} N/min"
        ));
    }
    let mut found: Vec<(f64, f64)> = Vec::new();
    for (what, direction) in PUSHES {
        let force = measure_push(&connection, what, &bias, asks)?;
        let direction = Vector3::from(direction);
        let cosine = force.dot(&direction) / force.norm();
        let sign = cosine.signum();
        let angle = cosine.abs().min(1.0).acos().to_degrees();
        say(&format!(
            "  measured {:.1} N, {:.1} {:.1} {:.1} in the axes of the base frame: sign {sign}, angle {angle:.0} degrees",
            force.norm(),
            force.x,
            force.y,
            force.z
        ));
        if angle > MAX_ANGLE_DEG {
            return Err(format!(
                "the measured force is {angle:.0} degrees off the push; the limit is {MAX_ANGLE_DEG} degrees. \
                 Check force.link and base_frame"
            ));
        }
        found.push((sign, angle));
    }
    let sign = found[0].0;
    if found.iter().any(|(other, _)| *other != sign) {
        return Err("the pushes give different signs; check force.link and base_frame".to_owned());
    }
    let result = Commissioning {
        angle_deg: found.iter().map(|(_, angle)| *angle).fold(0.0, f64::max),
        tared_n: residual,
        drift_n_per_min: drift,
        ..Commissioning::new(&connection.file, &connection.frames, sign)
    };
    let path = result.write(&connection.file)?;
    say(&format!("wrote {}", path.display()));
    Ok(())
}

fn say(text: &str) {
    println!("{text}");
    let _ = std::io::stdout().flush();
}

fn wait_for_enter(asks: bool, what: &str) -> Result<(), String> {
    if !asks {
        return Ok(());
    }
    say(what);
    let mut line = String::new();
    match std::io::stdin().lock().read_line(&mut line) {
        Ok(1..) => Ok(()),
        _ => Err("standard input has ended; expected the Enter key, or --yes".to_owned()),
    }
}

/// The present force in the axes of the base frame, as the sensor has its sign [N].
fn force_in_base(connection: &Connection) -> Result<Vector3<f64>, String> {
    let readings = connection.readings.lock();
    if let Some((_, reason)) = connection.stop_reason(&readings) {
        return Err(reason);
    }
    let (Some(joints), Some(wrench)) = (&readings.joints, &readings.wrench) else {
        return Err("the robot has sent no state or no wrench".to_owned());
    };
    let frames = &connection.frames;
    let name = connection.file.force.link.as_ref().unwrap_or(&wrench.frame);
    let link = frames
        .link(name)
        .ok_or_else(|| format!("{name:?} is no link of the URDF"))?;
    let force = Vector3::from(wrench.force);
    frames
        .turn_to_base(&joints.positions, link, force)
        .ok_or_else(|| "the pose of the sensor is not known".to_owned())
}

/// Measures the mean force at rest [N] and its drift [N/min].
fn measure_rest(connection: &Connection) -> Result<(Vector3<f64>, f64), String> {
    let halves = [(); 2].map(|()| {
        let end = Instant::now() + REST / 2;
        let (mut sum, mut count) = (Vector3::zeros(), 0.0);
        while Instant::now() < end {
            sum += force_in_base(connection)?;
            count += 1.0;
            std::thread::sleep(Duration::from_millis(10));
        }
        Ok::<_, String>(sum / count)
    });
    let [first, second] = halves;
    let (first, second) = (first?, second?);
    // The means of the halves are half the time apart.
    let minutes = REST.as_secs_f64() / 2.0 / 60.0;
    // Noise over so short a time is no drift: a tenth of a newton is.
    let change = ((second - first).norm() - 0.1).max(0.0);
    Ok(((first + second) / 2.0, change / minutes))
}

/// Waits for a push that lasts, and returns its mean force [N].
fn measure_push(
    connection: &Connection,
    what: &str,
    bias: &Vector3<f64>,
    asks: bool,
) -> Result<Vector3<f64>, String> {
    wait_for_enter(asks, "take your hands off the tool, and press Enter")?;
    say(&format!("{what}, with more than {PUSH_N} N, for a second"));
    let deadline = Instant::now() + PUSH_TIMEOUT;
    let mut pushed: Vec<Vector3<f64>> = Vec::new();
    let mut since = Instant::now();
    loop {
        let force = force_in_base(connection)? - bias;
        if force.norm() < PUSH_N {
            pushed.clear();
            since = Instant::now();
        } else {
            pushed.push(force);
        }
        if since.elapsed() >= PUSH_TIME && !pushed.is_empty() {
            let mean = pushed.iter().sum::<Vector3<f64>>() / pushed.len() as f64;
            wait_for_release(connection, bias, deadline)?;
            return Ok(mean);
        }
        if Instant::now() >= deadline {
            let seconds = PUSH_TIMEOUT.as_secs();
            return Err(format!(
                "no push of more than {PUSH_N} N within {seconds} s"
            ));
        }
        std::thread::sleep(Duration::from_millis(10));
    }
}

fn wait_for_release(
    connection: &Connection,
    bias: &Vector3<f64>,
    deadline: Instant,
) -> Result<(), String> {
    while (force_in_base(connection)? - bias).norm() > PUSH_N / 2.0 {
        if Instant::now() >= deadline {
            return Err("the push does not end".to_owned());
        }
        std::thread::sleep(Duration::from_millis(10));
    }
    Ok(())
}
