//! Taring, and force along the normal of the surface.

use super::{ANSWER, MotionResult, MotionRun, stop};
use crate::messages::{
    EmptyRequest, ForceModeRequest, Header, PoseStamped, QuaternionMessage, Vector, VectorPair,
};
use crate::protocol::Kind;
use nalgebra::Vector3;
use std::time::{Duration, Instant};

/// Wait after taring, and time over which the force is averaged then.
const TARE_DELAY: Duration = Duration::from_millis(200);
const TARE_MEASURE: Duration = Duration::from_millis(300);
/// Largest force after taring, and largest spread of the force then [N].
const TARED_N: f64 = 3.0;
/// Share of the press force that counts as contact before a stroke, and longest wait for it.
const CONTACT_SHARE: f64 = 0.7;
const CONTACT_TIMEOUT: Duration = Duration::from_secs(1);
/// Force mode: the frame is taken as it is; deviations of the other axes [m, rad]; damping and gain as the robot's defaults.
const FRAME_AS_GIVEN: u8 = 2;
const DEVIATION: [f32; 6] = [0.05, 0.05, 0.05, 0.3, 0.3, 0.3];
const DAMPING: f32 = 0.025;
const GAIN: f32 = 0.5;

impl MotionRun<'_> {
    /// Makes the present force zero, and checks that it is.
    pub(super) fn tare(&mut self) -> MotionResult<()> {
        self.settle()?;
        self.bias = Vector3::zeros();
        (self.is_tared, self.is_tared_anew) = (false, false);
        if let Some(tare) = &self.robot.tare {
            let request = match tare.send(EmptyRequest::default()) {
                Ok(request) => request,
                Err(error) => return stop(Kind::LinkLost, error.to_string()),
            };
            let answer = self.wait("the answer to the tare", ANSWER, |run| {
                run.robot
                    .tare
                    .as_ref()
                    .and_then(|tare| tare.answer(request))
            })?;
            if !answer.success {
                let name = tare.name();
                return stop(
                    Kind::Tolerance,
                    format!("{name} refuses: {}", answer.message),
                );
            }
            self.turn_for(TARE_DELAY)?;
        }
        let forces = self.measure_forces(TARE_MEASURE)?;
        let mean = forces.iter().sum::<Vector3<f64>>() / forces.len().max(1) as f64;
        let spread = forces
            .iter()
            .map(|force| (force - mean).norm())
            .fold(0.0, f64::max);
        if spread > TARED_N {
            return stop(
                Kind::Tolerance,
                format!(
                    "the force varies by {spread:.1} N while the robot rests; the limit is {TARED_N} N"
                ),
            );
        }
        if self.robot.tare.is_some() && mean.norm() > TARED_N {
            return stop(
                Kind::Tolerance,
                format!(
                    "the force is {:.1} N right after taring; the limit is {TARED_N} N",
                    mean.norm()
                ),
            );
        }
        self.bias = mean;
        (self.is_tared, self.is_tared_anew) = (true, true);
        self.driver.tare.set(Some(mean));
        Ok(())
    }

    /// Waits while samples are passed on.
    fn turn_for(&mut self, time: Duration) -> MotionResult<()> {
        let end = Instant::now() + time;
        while Instant::now() < end {
            self.supervise_once()?;
        }
        Ok(())
    }

    fn measure_forces(&mut self, time: Duration) -> MotionResult<Vec<Vector3<f64>>> {
        let end = Instant::now() + time;
        let mut forces = Vec::new();
        while Instant::now() < end {
            self.supervise_once()?;
            forces.push(self.force);
        }
        Ok(forces)
    }

    /// Switches force along the normal on.
    pub(super) fn start_pressing(&mut self) -> MotionResult<()> {
        let robot = self.robot;
        let Some(force) = &robot.force else {
            return Ok(());
        };
        let Some(request) = self.force_mode_request() else {
            return stop(Kind::LinkLost, "the pose of the base frame is not known");
        };
        let sent = match force.start.send(request) {
            Ok(sent) => sent,
            Err(error) => return stop(Kind::LinkLost, error.to_string()),
        };
        // From here on the robot may press, whether or not it answers.
        self.is_pressing = true;
        let answer = self.wait("the answer to the start of force mode", ANSWER, |_| {
            force.start.answer(sent)
        })?;
        if !answer.success {
            let name = force.start.name();
            return stop(Kind::ProtectiveStop, format!("{name} refuses"));
        }
        // The tool presses first, and then wipes. Without contact it wipes in the air, which its samples show.
        let contact = CONTACT_SHARE * self.motion.head.press_force_n;
        let deadline = Instant::now() + CONTACT_TIMEOUT;
        while self.force.dot(&self.motion.normal()) < contact && Instant::now() < deadline {
            self.supervise_once()?;
        }
        Ok(())
    }

    /// The request of force mode for the believed surface, in the axes of the base frame.
    fn force_mode_request(&self) -> Option<ForceModeRequest> {
        let frames = &self.robot.frames;
        let root_from_base = frames.root_from_link(&self.latest.positions, frames.base.0)?;
        let world_from_base = self.motion.world_from_root * root_from_base;
        let base_from_surface = world_from_base.inverse() * self.motion.world_from_surface;
        let p = base_from_surface.translation.vector;
        let q = base_from_surface.rotation.coords;
        let along_z = |z: f64| VectorPair {
            linear: Vector {
                z,
                ..Vector::default()
            },
            ..VectorPair::default()
        };
        Some(ForceModeRequest {
            task_frame: PoseStamped {
                header: Header {
                    frame_id: frames.base.1.clone(),
                    ..Header::default()
                },
                position: Vector {
                    x: p.x,
                    y: p.y,
                    z: p.z,
                },
                orientation: QuaternionMessage {
                    x: q.x,
                    y: q.y,
                    z: q.z,
                    w: q.w,
                },
            },
            selection: [false, false, true, false, false, false],
            wrench: along_z(-self.motion.head.press_force_n),
            frame_type: FRAME_AS_GIVEN,
            speed_limits: along_z(self.robot.file.force.press_speed_m_s),
            deviation_limits: DEVIATION,
            damping_factor: DAMPING,
            gain_scaling: GAIN,
        })
    }

    /// Switches force along the normal off.
    pub(super) fn stop_pressing(&mut self) -> MotionResult<()> {
        let robot = self.robot;
        let Some(force) = robot.force.as_ref().filter(|_| self.is_pressing) else {
            return Ok(());
        };
        let sent = match force.stop.send(EmptyRequest::default()) {
            Ok(sent) => sent,
            Err(error) => return stop(Kind::LinkLost, error.to_string()),
        };
        let answer = self.wait("the answer to the end of force mode", ANSWER, |_| {
            force.stop.answer(sent)
        })?;
        if answer.success {
            self.is_pressing = false;
            return Ok(());
        }
        stop(
            Kind::ProtectiveStop,
            format!("{} refuses: {}", force.stop.name(), answer.message),
        )
    }
}
