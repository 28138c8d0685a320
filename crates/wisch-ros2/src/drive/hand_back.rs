//! The hand-back of controllers after the last motion.

use super::Driver;
use super::checks::REST;
use std::time::{Duration, Instant};

/// Time for the whole hand-back: wisch waits for 2 s after an error.
const HAND_BACK: Duration = Duration::from_millis(1500);
/// Attempts to deactivate the controllers, and the wait between them.
const ATTEMPTS: usize = 2;
const RETRY_DELAY: Duration = Duration::from_millis(100);

impl Driver {
    /// Deactivates those controllers that were inactive before.
    ///
    /// # Errors
    /// If controllers stay active; the text names them.
    pub(super) fn finish(&mut self) -> Result<(), String> {
        let Some(activated) = self.activated.take().filter(|names| !names.is_empty()) else {
            return Ok(());
        };
        let manager = &self.connection.manager;
        deactivate_within(
            HAND_BACK,
            activated,
            |limit| self.inactive_controllers(Some(limit)),
            || self.confirm_rest(),
            |names, limit| {
                let deactivated = manager.deactivate(names.to_vec(), limit);
                deactivated.map_err(|error| error.to_string())
            },
        )
    }

    /// Checks that the robot is known to rest.
    ///
    /// # Errors
    /// If it may still move, or its state is stale.
    fn confirm_rest(&self) -> Result<(), String> {
        let limit = self.connection.file.limits.state_age_ms;
        let readings = self.connection.readings.lock();
        let rests = readings.joints.as_ref().is_some_and(|joints| {
            let is_recent = 1e3 * joints.arrival.elapsed().as_secs_f64() <= limit;
            is_recent && joints.velocities.iter().all(|speed| speed.abs() <= REST)
        });
        if self.rests && rests {
            Ok(())
        } else {
            Err("the robot has not confirmed that it rests".to_owned())
        }
    }
}

/// Deactivates controllers, with one repetition. Each call may take half of the time that is left, so that all of them
/// together do not take longer than `limit`.
///
/// - `list`: returns which controllers are inactive, within a time.
/// - `confirm`: returns whether controllers may be switched now.
/// - `deactivate`: deactivates controllers, all or none of them, within a time.
///
/// # Errors
/// If controllers may stay active: their names, what went wrong, and what to do.
fn deactivate_within(
    limit: Duration,
    mut active: Vec<String>,
    list: impl Fn(Duration) -> Result<Vec<String>, String>,
    confirm: impl Fn() -> Result<(), String>,
    deactivate: impl Fn(&[String], Duration) -> Result<(), String>,
) -> Result<(), String> {
    let begin = Instant::now();
    let half = || limit.saturating_sub(begin.elapsed()) / 2;
    let mut faults: Vec<String> = Vec::new();
    let mut note = |fault: String| {
        if !faults.contains(&fault) {
            faults.push(fault);
        }
    };
    for attempt in 0..=ATTEMPTS {
        if attempt > 0 {
            std::thread::sleep(RETRY_DELAY.min(half()));
        }
        // A switch whose answer was late may have succeeded.
        match list(half()) {
            Ok(inactive) => active.retain(|name| !inactive.contains(name)),
            Err(fault) => note(fault),
        }
        if active.is_empty() {
            return Ok(());
        }
        if attempt == ATTEMPTS {
            break;
        }
        match confirm().and_then(|()| deactivate(&active, half())) {
            Ok(()) => return Ok(()),
            Err(fault) => note(fault),
        }
    }
    let names = active.join(", ");
    let (faults, seconds) = (faults.join("; "), limit.as_secs_f64());
    Err(format!(
        "as far as known, these controllers stay active: {names}. After {ATTEMPTS} attempts within {seconds} s: {faults}. \
         Deactivate them with `ros2 control switch_controllers`"
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::{Cell, RefCell};

    /// A controller manager that refuses or is silent.
    #[derive(Default)]
    struct Manager {
        inactive: RefCell<Vec<String>>,
        refusals: Cell<usize>,
        is_silent: bool,
        /// Whether it switches, but never answers.
        is_late: bool,
        switches: RefCell<Vec<String>>,
    }

    impl Manager {
        fn hand_back(&self, rests: bool) -> Result<(), String> {
            let silence = |limit: Duration| {
                std::thread::sleep(limit);
                Err("the service has not answered".to_owned())
            };
            let names = ["jtc", "force"].map(str::to_owned).to_vec();
            deactivate_within(
                Duration::from_millis(600),
                names,
                |limit| match self.is_silent {
                    true => silence(limit).map(|()| Vec::new()),
                    false => Ok(self.inactive.borrow().clone()),
                },
                || match rests {
                    true => Ok(()),
                    false => Err("it moves".to_owned()),
                },
                |names, limit| {
                    self.switches.borrow_mut().push(names.join(" "));
                    if self.is_silent {
                        return silence(limit);
                    }
                    if self.refusals.get() > 0 {
                        self.refusals.set(self.refusals.get() - 1);
                        return Err("refused".to_owned());
                    }
                    self.inactive.borrow_mut().extend_from_slice(names);
                    if self.is_late { silence(limit) } else { Ok(()) }
                },
            )
        }
    }

    #[test]
    fn a_refused_switch_is_repeated_once() {
        let manager = Manager::default();
        manager.refusals.set(1);
        assert_eq!(manager.hand_back(true), Ok(()));
        assert_eq!(*manager.switches.borrow(), ["jtc force", "jtc force"]);
        let manager = Manager::default();
        manager.refusals.set(2);
        let error = manager.hand_back(true).unwrap_err();
        assert!(
            error.contains("stay active: jtc, force. After 2 attempts within 0.6 s: refused."),
            "{error}"
        );
    }

    #[test]
    fn a_silent_manager_is_an_error_with_names_within_the_time_for_all_calls() {
        let manager = Manager {
            is_silent: true,
            ..Manager::default()
        };
        let begin = Instant::now();
        let error = manager.hand_back(true).unwrap_err();
        assert!(
            begin.elapsed() < Duration::from_millis(1200),
            "{:?}",
            begin.elapsed()
        );
        assert!(error.contains("jtc, force. After"), "{error}");
        assert!(error.contains("the service has not answered"), "{error}");
        assert_eq!(manager.switches.borrow().len(), 2);
    }

    #[test]
    fn what_is_inactive_is_not_switched_and_a_late_switch_counts() {
        let manager = Manager {
            inactive: RefCell::new(vec!["jtc".to_owned()]),
            is_late: true,
            ..Manager::default()
        };
        assert_eq!(manager.hand_back(true), Ok(()));
        assert_eq!(*manager.switches.borrow(), ["force"]);
    }

    #[test]
    fn a_robot_that_may_move_keeps_its_controllers() {
        let manager = Manager::default();
        let error = manager.hand_back(false).unwrap_err();
        assert!(error.contains("it moves"), "{error}");
        assert!(manager.switches.borrow().is_empty());
    }
}
