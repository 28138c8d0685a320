//! What happened during a log: contacts, losses of contact, pushes, stick-slip and phases.

mod collisions;
mod contacts;
mod detector;
mod event;
mod phases;
mod stick_slip;

pub(super) use detector::EventDetector;
pub use event::{Event, EventKind};

impl EventDetector<'_> {
    /// All events, by start.
    pub(super) fn events(&self) -> Vec<Event> {
        let mut events = self.contacts();
        events.extend(self.phases(&events));
        let collisions = self.collisions();
        // What a push takes from the surface is the push's, not a loss.
        events.extend(self.losses().into_iter().filter(|loss| {
            !(collisions.iter()).any(|push| loss.start < push.end && push.start < loss.end)
        }));
        events.extend(collisions);
        events.extend(self.stick_slips());
        events.sort_by(|a, b| a.start.total_cmp(&b.start).then(a.kind.cmp(&b.kind)));
        events
    }
}
