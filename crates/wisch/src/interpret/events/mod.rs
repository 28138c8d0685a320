//! Events of a log: contacts, contact losses, disturbances, stick-slip and phases.

mod contact_forces;
mod contacts;
mod detector;
mod disturbances;
mod event;
mod phases;
mod stick_slip;

pub(super) use detector::EventDetector;
pub use event::{Event, EventKind};

impl EventDetector<'_> {
    /// Returns all events, sorted by start.
    pub(super) fn events(&self) -> Vec<Event> {
        let mut events = self.contacts();
        let losses = self.losses(&events);
        events.extend(self.phases(&events));
        let disturbances = self.disturbances();
        // A push or the bounce of a landing interrupts the contact: neither is a contact loss.
        events.extend(losses.into_iter().filter(|loss| {
            !(disturbances.iter()).any(|other| loss.start < other.end && other.start < loss.end)
        }));
        events.extend(disturbances);
        events.extend(self.stick_slips());
        events.sort_by(|a, b| a.start.total_cmp(&b.start).then(a.kind.cmp(&b.kind)));
        events
    }
}
