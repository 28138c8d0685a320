//! Detection, during a stroke, that the stroke no longer has an effect.

use super::{TelemetrySample, WarningChannel};
use crate::follow::Phase;
use crate::geometry::{Point2, Pose};
use crate::represent::{Surface, SurfaceShape, Task};

/// Share of the press force below which the tool is out of contact [1].
const CONTACT_SHARE: f64 = 0.2;
/// Path without contact at which contact counts as lost, over the collision radius [1].
const WITHOUT_CONTACT: f64 = 2.0;
/// Time off its path after which the tool counts as led off its stroke [s].
const LED_FOR: f64 = 0.3;
/// Longest time between two samples over which the tool's travel counts [s].
const LONGEST_GAP: f64 = 0.1;

/// Why a round ended during a stroke.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum StrokeEnd {
    /// The tool moved on without pressing on the surface.
    #[error("the tool had lost contact for {way:.2} m of its stroke")]
    ContactLost {
        /// Path without contact \[m\].
        way: f64,
    },
    /// A person or an object led the tool off its stroke.
    #[error("the tool had been led {distance:.2} m off its stroke")]
    LedAway {
        /// Distance from the stroke \[m\].
        distance: f64,
    },
    /// The stroke differed from earlier runs.
    #[error("a warning ended it: the {channel} differed from earlier episodes")]
    Warned {
        /// The quantity that differed.
        channel: WarningChannel,
    },
}

/// A detector that examines the samples of a round one by one.
#[derive(Debug)]
pub(super) struct StrokeWatch {
    surface: Surface,
    /// Force below which there is no contact [N]; 0 for a tool that hovers.
    least_force: f64,
    radius: f64,
    /// Stroke, place and time of the last sample.
    last: Option<(usize, Point2, f64)>,
    without_contact: f64,
    led_since: Option<f64>,
}

impl StrokeWatch {
    pub(super) fn new(task: &Task) -> Self {
        let hovers = task.interaction.gap_m > 0.0;
        Self {
            surface: task.surface.clone(),
            least_force: if hovers {
                0.0
            } else {
                CONTACT_SHARE * task.interaction.press_force_n
            },
            radius: task.tool.collision_radius(),
            last: None,
            without_contact: 0.0,
            led_since: None,
        }
    }

    /// Returns why the stroke no longer has an effect, if this sample shows it.
    pub(super) fn check(&mut self, sample: &TelemetrySample<'_>) -> Option<StrokeEnd> {
        let Phase::Wipe(stroke) = sample.phase else {
            self.reset();
            return None;
        };
        let in_chart = |pose: &Pose| self.surface.chart_from_tool(pose).translation.vector.xy();
        let at = Point2::from(in_chart(&sample.world_from_tool));
        let wanted = Point2::from(in_chart(&sample.world_from_commanded));
        let way = match self.last.replace((stroke, at, sample.time)) {
            Some((last, before, since)) if last == stroke => {
                if sample.time - since <= LONGEST_GAP {
                    (at - before).norm()
                } else {
                    // The motion of the tool since the last sample is unknown.
                    self.led_since = None;
                    0.0
                }
            }
            _ => {
                self.reset();
                self.last = Some((stroke, at, sample.time));
                0.0
            }
        };
        let world_from_surface = &self.surface.world_from_surface;
        let in_surface = world_from_surface.rotation.inverse() * sample.external.force;
        let pressed = match &self.surface.shape {
            SurfaceShape::Plane => in_surface.z,
            shape => (shape.orientation(at).inverse() * in_surface).z,
        };
        self.without_contact = if pressed < self.least_force {
            self.without_contact + way
        } else {
            0.0
        };
        if self.without_contact > WITHOUT_CONTACT * self.radius {
            let way = self.without_contact;
            return Some(StrokeEnd::ContactLost { way });
        }
        let distance = (at - wanted).norm();
        self.led_since = (distance > self.radius).then(|| self.led_since.unwrap_or(sample.time));
        (self.led_since)
            .filter(|since| sample.time - since >= LED_FOR)
            .map(|_| StrokeEnd::LedAway { distance })
    }

    fn reset(&mut self) {
        self.last = None;
        self.without_contact = 0.0;
        self.led_since = None;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::control::Wrench;
    use crate::geometry::{Polygon, Vector2, Vector3};
    use crate::run::SampleStatus;

    fn watch() -> StrokeWatch {
        StrokeWatch {
            surface: Surface::new(
                "board",
                Polygon::rectangle(Vector2::new(1.0, 1.0)),
                Pose::identity(),
            ),
            least_force: 2.0,
            radius: 0.05,
            last: None,
            without_contact: 0.0,
            led_since: None,
        }
    }

    /// Simulates a stroke of 0.3 m in 3 s. `touch` returns the press force [N] and the distance off the path
    /// [m] at a time [s].
    fn ended(phase: Phase, touch: impl Fn(f64) -> (f64, f64)) -> Option<(f64, StrokeEnd)> {
        let mut watch = watch();
        (0..3000).find_map(|i| {
            let time = f64::from(i) * 1e-3;
            let (pressed, off) = touch(time);
            // Samples that do not show what the tool does are not checked.
            if pressed.is_nan() {
                return None;
            }
            let pose = Pose::translation(0.1 * time, off, 0.0);
            let end = watch.check(&TelemetrySample {
                time,
                positions: &[],
                velocities: &[],
                efforts: &[],
                world_from_commanded: Pose::translation(0.1 * time, 0.0, -0.01),
                world_from_tool: pose,
                controller: Wrench::default(),
                external: Wrench {
                    force: Vector3::new(0.0, 0.0, pressed),
                    ..Wrench::default()
                },
                motion: 0,
                phase,
                status: SampleStatus::default(),
            });
            end.map(|end| (time, end))
        })
    }

    #[test]
    fn a_stroke_that_presses_where_it_should_is_not_ended() {
        assert_eq!(ended(Phase::Wipe(0), |_| (10.0, 0.01)), None);
        // A tool that jumps over an edge now and then, and one that is pushed for a moment.
        let bumpy = |time: f64| (if time % 1.0 < 0.5 { 0.0 } else { 10.0 }, 0.0);
        assert_eq!(ended(Phase::Wipe(0), bumpy), None);
        let shoved = |time: f64| (10.0, if (1.0..1.2).contains(&time) { 0.1 } else { 0.0 });
        assert_eq!(ended(Phase::Wipe(0), shoved), None);
    }

    #[test]
    fn a_stroke_without_contact_is_ended_after_two_radii() {
        let (time, end) = ended(Phase::Wipe(0), |time| {
            (if time < 1.0 { 10.0 } else { 0.5 }, 0.0)
        })
        .expect("it is ended");
        assert!((time - 2.0).abs() < 0.01, "{time} s");
        assert!(matches!(end, StrokeEnd::ContactLost { way } if (way - 0.1).abs() < 1e-3));
        // Travel without a measured force is not travel without contact; travel with a measured
        // force at some samples is.
        let unseen = |time: f64| if time < 2.9 { f64::NAN } else { 0.5 };
        let seen = |time: f64| if time < 0.1 { 10.0 } else { unseen(time) };
        assert_eq!(ended(Phase::Wipe(0), |time| (seen(time), 0.0)), None);
        let every_20_ms = |time: f64| {
            if (1e3 * time).round() % 20.0 == 0.0 {
                0.5
            } else {
                f64::NAN
            }
        };
        let (time, _) =
            ended(Phase::Wipe(0), |time| (every_20_ms(time), 0.0)).expect("it is ended");
        assert!((time - 1.0).abs() < 0.05, "{time} s");
        // In the air the tool presses on nothing.
        assert_eq!(ended(Phase::Lifted, |_| (0.0, 0.0)), None);
    }

    #[test]
    fn a_stroke_that_is_led_away_is_ended() {
        let led = |time: f64| (10.0, if time > 1.0 { 0.06 } else { 0.0 });
        let (time, end) = ended(Phase::Wipe(0), led).expect("it is ended");
        assert!((time - 1.3).abs() < 0.01, "{time} s");
        assert!(matches!(end, StrokeEnd::LedAway { distance } if (distance - 0.06).abs() < 1e-9));
    }
}
