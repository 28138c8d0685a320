//! The switch with which an operator pauses motions.

use std::sync::atomic::{AtomicBool, Ordering};

/// A switch with which an operator pauses the motions of an executor in another process, and lets them continue.
#[derive(Debug, Default)]
pub struct PauseSwitch {
    is_wanted: AtomicBool,
    is_supported: AtomicBool,
}

impl PauseSwitch {
    /// Turns the switch. Returns whether a pause is wanted now.
    ///
    /// ```
    /// let switch = wisch_io::PauseSwitch::default();
    /// assert!(switch.toggle() && !switch.toggle());
    /// ```
    pub fn toggle(&self) -> bool {
        !self.is_wanted.fetch_xor(true, Ordering::SeqCst)
    }

    /// Ends the pause that is wanted, if one is.
    pub(super) fn end(&self) {
        self.is_wanted.store(false, Ordering::SeqCst);
    }

    /// Whether a pause is wanted.
    pub fn is_wanted(&self) -> bool {
        self.is_wanted.load(Ordering::SeqCst)
    }

    /// Whether the executor is able to pause during a motion. Others pause before their next motion.
    pub fn is_supported(&self) -> bool {
        self.is_supported.load(Ordering::SeqCst)
    }

    pub(super) fn set_supported(&self, is_supported: bool) {
        self.is_supported.store(is_supported, Ordering::SeqCst);
    }
}
