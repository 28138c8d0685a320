//! Round trips over DDS: how long a message and its echo take, and how many are lost.

use crate::link::Link;
use crate::messages::{Header, JointStateMessage, Stamp};
use crate::robot_file::RobotFile;
use crate::service::wait_for_match;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Topic of the messages, and of their echoes.
const PING: &str = "/wisch_ping";
const ECHO: &str = "/wisch_echo";
/// Joints of a message.
const JOINTS: usize = 7;
/// Wait after the match, and after the last message.
const SETTLE: Duration = Duration::from_millis(500);
const LAST_ECHO: Duration = Duration::from_secs(1);

/// Sends joint states at a rate [Hz] for a time [s], and prints the times until their echoes arrive. The first tenth only
/// warms up.
///
/// # Errors
/// If DDS refuses, or nothing sends the messages back.
pub(crate) fn measure(file: &RobotFile, rate: f64, seconds: f64) -> Result<(), String> {
    let text = |error: crate::link::LinkError| error.to_string();
    let mut link = Link::open(&file.link, "wisch_ping").map_err(text)?;
    let count = ((rate * seconds) as usize).max(1);
    let echoes = Arc::new(Mutex::new(vec![None::<Instant>; count]));
    let into = Arc::clone(&echoes);
    let kind = ["sensor_msgs", "JointState"];
    let take = move |message: JointStateMessage, _: &_| {
        let now = Instant::now();
        let mut echoes = into.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(echo) = echoes.get_mut(message.header.stamp.sec as usize) {
            echo.get_or_insert(now);
        }
    };
    link.listen(ECHO, kind, false, take).map_err(text)?;
    let publisher = link.publisher(PING, kind, false).map_err(text)?;
    let deadline = Instant::now() + Duration::from_secs_f64(file.link.discovery_s);
    let is_matched = wait_for_match(deadline, || publisher.wait_for_subscription(link.node()));
    while link.publishers(ECHO).is_empty() && Instant::now() < deadline {
        std::thread::sleep(Duration::from_millis(20));
    }
    if !is_matched || link.publishers(ECHO).is_empty() {
        return Err(format!(
            "nothing takes {PING} and sends {ECHO} ({})",
            link.network
        ));
    }
    std::thread::sleep(SETTLE);
    let mut sent = Vec::with_capacity(count);
    let begin = Instant::now();
    for number in 0..count {
        let due = begin + Duration::from_secs_f64(number as f64 / rate);
        std::thread::sleep(due.saturating_duration_since(Instant::now()));
        sent.push(Instant::now());
        let published = publisher.publish(message(number as i32));
        published.map_err(|error| format!("{PING}: {error:?}"))?;
    }
    std::thread::sleep(LAST_ECHO);
    let echoes = echoes.lock().unwrap_or_else(PoisonError::into_inner);
    let pairs = sent.iter().zip(echoes.iter()).skip(count / 10);
    let mut trips: Vec<f64> = pairs
        .filter_map(|(sent, echo)| echo.map(|echo| 1e6 * (echo - *sent).as_secs_f64()))
        .collect();
    trips.sort_by(f64::total_cmp);
    let lost = echoes.iter().filter(|echo| echo.is_none()).count();
    let quantile = |share: f64| {
        let last = trips.len().saturating_sub(1) as f64;
        trips.get((share * last).round() as usize).copied()
    };
    let shown = |share| quantile(share).map_or("-".to_owned(), |trip| format!("{trip:.0}"));
    println!(
        "sent {count}, lost {lost}; round trip median {} us, 90 % {} us, 99 % {} us",
        shown(0.5),
        shown(0.9),
        shown(0.99)
    );
    Ok(())
}

/// A joint state whose stamp holds its number.
fn message(number: i32) -> JointStateMessage {
    JointStateMessage {
        header: Header {
            stamp: Stamp {
                sec: number,
                nanosec: 0,
            },
            frame_id: String::new(),
        },
        name: (1..=JOINTS).map(|i| format!("joint_{i}")).collect(),
        position: vec![0.1; JOINTS],
        velocity: vec![0.2; JOINTS],
        effort: vec![0.3; JOINTS],
    }
}
