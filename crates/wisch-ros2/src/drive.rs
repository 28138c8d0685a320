//! The executor: takes motions from wisch and lets the robot execute them.

mod checks;
mod hand_back;
mod run;

use crate::commissioning::Commissioning;
use crate::connection::Connection;
use crate::guard::Guard;
use crate::motion::WipingMotion;
use crate::protocol::{Incoming, MotionEnding, MotionHead, Outgoing, Request, VERSION};
use crate::robot_file::RobotFile;
use crate::wrench_quality::assumptions;
use nalgebra::Vector3;
use run::MotionRun;
use serde_json::{Value, json};
use std::cell::Cell;
use std::path::Path;
use std::time::Duration;

/// Longest time without a message during a motion [s]. The robot's own silence ends a motion earlier.
const MAX_SILENCE_S: f64 = 2.0;
/// Longest wait for a point of a motion.
const POINT_TIMEOUT: Duration = Duration::from_secs(10);

/// Options of the motions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct DriveOptions {
    /// Share of the planned speed, above 0 and at most 1.
    pub speed: f64,
    /// Whether the robot moves above the surface, without force.
    pub is_in_air: bool,
    /// Whether an operator permits each motion before it arrives. Otherwise no motion follows a stop.
    pub is_operated: bool,
}

/// A commissioned robot.
pub(crate) struct Driver {
    connection: Connection,
    /// 1 if the sensor reports the force of the surroundings on the tool, -1 if the opposite.
    sign: f64,
    options: DriveOptions,
    guard: Guard,
    /// Force of the latest tare in the axes of the world [N]; `None` before the first.
    tare: Cell<Option<Vector3<f64>>>,
    /// Why the robot has stopped, if it has.
    stopped: Option<String>,
    /// Controllers that this program has activated; `None` before it has prepared the robot.
    activated: Option<Vec<String>>,
    /// Whether the robot rests, as far as this program knows.
    rests: bool,
}

/// Serves wisch over the standard streams until the end of input.
pub(crate) fn serve(robot_file: &Path, options: DriveOptions) {
    let incoming = Incoming::start();
    let outgoing = Outgoing::start();
    match incoming.next() {
        Request::Hello(_) => {}
        Request::End => return,
        other => {
            let text = format!("expected hello, found {other:?}");
            outgoing.say_surely(&json!({"error": text}));
            return;
        }
    }
    let file = RobotFile::read(robot_file).map_err(|error| error.to_string());
    let mut driver = match file.and_then(|file| Driver::open(file, options)) {
        Ok(driver) => driver,
        Err(text) => {
            outgoing.say_surely(&json!({"error": text}));
            return;
        }
    };
    outgoing.say_surely(&json!({"ready": {
        "version": VERSION,
        "reports_state": true,
        "max_silence_s": MAX_SILENCE_S,
        "real_time": true,
        "prepares": true,
        "pauses": true,
        "stamp_clock": "epoch",
        "knot_error_rad": driver.connection.file.motion.knot_error_rad,
    }}));
    loop {
        let answer = match incoming.next() {
            Request::Execute(head) => match driver.execute(*head, &incoming, &outgoing) {
                Ok(Some(done)) => json!({"done": done}),
                Ok(None) => break,
                Err(text) => json!({"error": text}),
            },
            Request::Prepare => match driver.prepare() {
                Ok(()) => json!("prepared"),
                Err(text) => json!({"error": text}),
            },
            Request::Finish => match driver.finish() {
                Ok(()) => json!("finished"),
                Err(text) => json!({"error": text}),
            },
            Request::State => match driver.state() {
                Ok(state) => json!({"state": state}),
                Err(text) => json!({"error": text}),
            },
            Request::Observe(_) => json!({"observation": null}),
            // They may arrive after the motion has ended.
            Request::Stop | Request::Pause | Request::Resume => continue,
            Request::End => break,
            Request::Hello(_) | Request::Point(_) => json!({"error": "unexpected message"}),
            Request::Invalid(why) => json!({"error": format!("a line is no message: {why}")}),
        };
        outgoing.say_surely(&answer);
        if answer.get("error").is_some() {
            finish_after_error(&mut driver, &incoming, &outgoing);
            return;
        }
    }
    // wisch has ended, perhaps without a request to finish.
    if let Err(text) = driver.finish() {
        eprintln!("wisch-ros2: {text}");
    }
}

/// Waits until wisch asks a prepared driver to finish, or ends, and ignores what else it sends.
fn finish_after_error(driver: &mut Driver, incoming: &Incoming, outgoing: &Outgoing) {
    if driver.activated.is_none() {
        return;
    }
    while !matches!(incoming.next(), Request::Finish | Request::End) {}
    let answer = match driver.finish() {
        Ok(()) => json!("finished"),
        Err(text) => json!({"error": text}),
    };
    outgoing.say_surely(&answer);
}

impl Driver {
    /// Connects to a commissioned robot.
    ///
    /// # Errors
    /// If anything forbids a motion; the text names it with value and limit.
    fn open(file: RobotFile, options: DriveOptions) -> Result<Self, String> {
        let robot_file = file.path.clone();
        let needs_force = file.force.topic.is_some();
        let connection = Connection::open(file, "wisch")?;
        let sign = if needs_force {
            Commissioning::read(&connection.file, &connection.frames)?.sign
        } else {
            1.0
        };
        let faults = connection.faults(&connection.survey());
        if let Some(fault) = faults.first() {
            return Err(fault.clone());
        }
        let guard = Guard::start(&robot_file)?;
        for text in assumptions(&connection.file, options.is_in_air) {
            eprintln!("wisch-ros2: {text}");
        }
        Ok(Self {
            connection,
            sign,
            options,
            guard,
            tare: Cell::new(None),
            stopped: None,
            activated: None,
            rests: true,
        })
    }

    /// Activates the robot's controllers, once.
    ///
    /// # Errors
    /// If a controller does not become active, or a joint moves then.
    fn prepare(&mut self) -> Result<(), String> {
        if self.activated.is_some() {
            return Ok(());
        }
        let missing = self.inactive_controllers(None)?;
        self.activated = Some(missing.clone());
        self.activate(missing).map_err(|text| match self.finish() {
            Ok(()) => text,
            Err(left) => format!("{text}; {left}"),
        })
    }

    /// The measured positions and velocities.
    ///
    /// # Errors
    /// If the robot may not move, or its state is stale.
    fn state(&self) -> Result<Value, String> {
        let readings = self.connection.readings.lock();
        if let Some((_, reason)) = self.connection.stop_reason(&readings) {
            return Err(reason);
        }
        let joints = readings.joints.as_ref();
        let joints = joints.ok_or("the robot has sent no state")?;
        Ok(json!({"positions": joints.positions, "velocities": joints.velocities}))
    }

    /// Executes a motion. Returns the content of `done`, or `None` if wisch has ended.
    ///
    /// # Errors
    /// If the motion or the robot's state is refused. Nothing has moved then.
    fn execute(
        &mut self,
        head: MotionHead,
        incoming: &Incoming,
        outgoing: &Outgoing,
    ) -> Result<Option<Value>, String> {
        let mut points = Vec::with_capacity(head.points.min(1 << 16));
        while points.len() < head.points {
            match incoming.next_within(POINT_TIMEOUT) {
                Some(Request::Point(point)) => points.push(point),
                Some(Request::End) => return Ok(None),
                other => {
                    let at = points.len();
                    return Err(format!(
                        "expected {} points, found {other:?} after {at}",
                        head.points
                    ));
                }
            }
        }
        if let Some(reason) = self.stopped.as_ref().filter(|_| !self.options.is_operated) {
            return Err(format!(
                "the robot has stopped ({reason}), and nothing moves after a stop unless an operator permits it; \
                 start the run again, without --yes-every-round to be asked before each round"
            ));
        }
        let motion = WipingMotion::new(head, points)?;
        let parts = motion.parts()?;
        self.prepare()?;
        self.refuse_motion(&motion, &parts)?;
        self.refuse_state(&motion)?;
        if !self.guard.is_alive() {
            return Err("the guard has ended, so nothing would stop the robot".to_owned());
        }
        self.guard.set_armed(true)?;
        let mut run = MotionRun::begin(self, &motion, incoming, outgoing)?;
        let (ending, rests) = run.follow(&parts);
        let done = run.finish(&ending);
        if let MotionEnding::Stop(_, reason) = &ending {
            self.stopped = Some(reason.clone());
        }
        self.rests = rests;
        // A guard that stays armed hears nothing from now on, and stops the robot.
        if rests {
            let _ = self.guard.set_armed(false);
        }
        Ok((ending != MotionEnding::Deserted).then_some(done))
    }
}
