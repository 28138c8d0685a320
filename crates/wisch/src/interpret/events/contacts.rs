//! Detection of contacts and of contact losses during a stroke.

use super::detector::{Candidate, EventDetector, Level, level};
use super::event::{Event, EventKind};

/// Travel within 0.05 s below which a tool counts as standing [m]; above the noise of positions.
const STANDING: f64 = 1e-3;

impl EventDetector<'_> {
    /// Returns the contacts, sorted by start.
    pub(super) fn contacts(&self) -> Vec<Event> {
        let contacts = self.candidates(|i| self.contact_level(i), |_| self.config.events.bridge_s);
        (contacts.iter())
            .map(|contact| self.describe(EventKind::Contact, contact.first, contact.last))
            .collect()
    }

    /// Returns the contact losses, sorted by start: the tool moves on without force, or stands
    /// without force during a stroke. `contacts` are sorted by start.
    pub(super) fn losses(&self, contacts: &[Event]) -> Vec<Event> {
        let losses = self.candidates(|i| self.loss_level(i), |_| self.config.events.bridge_s);
        let strokes = self.strokes(contacts);
        let events = &self.config.events;
        let is_long = |loss: &&Candidate| {
            let travel = self.path[loss.last].position - self.path[loss.first].position;
            let is_around = |[first, last]: &[usize; 2]| *first < loss.first && loss.last < *last;
            travel.xy().norm() >= events.loss_travel_m
                || (self.duration(loss) >= events.loss_rest_s && strokes.iter().any(is_around))
        };
        (losses.iter().filter(is_long))
            .map(|loss| self.describe(EventKind::ContactLoss, loss.first, loss.last))
            .collect()
    }

    /// Time in contact over the time on or near the surface [1]; `None` for no such time.
    pub(in crate::interpret) fn contact_share(&self) -> Option<f64> {
        let (mut near, mut touching) = (0.0, 0.0);
        for i in 0..self.path.len() {
            let [start, end] = self.span(i);
            let is_touching = self.is_touching(i);
            if is_touching || self.is_near(i) {
                near += end - start;
            }
            if is_touching {
                touching += end - start;
            }
        }
        (near > 0.0).then(|| touching / near)
    }

    fn contact_level(&self, i: usize) -> Level {
        let [begin, end] = self.config.events.contact_share;
        let share = self.path[i].normalized_force;
        let on_plane = self.is_on_plane(i);
        level(on_plane && share >= end, on_plane && share >= begin)
    }

    /// Level of a loss: the tool is over the surface and near it, moves along it or stands, and has no force.
    fn loss_level(&self, i: usize) -> Level {
        let without_force = self.path[i].normalized_force < self.config.events.contact_share[0]
            && !self.is_disturbed(i);
        let lost = self.has_plane && without_force && self.is_near(i);
        let [rise, along] = self.travel(i);
        let is_standing = along.max(rise) < STANDING;
        level(lost, lost && (along > 2.0 * rise || is_standing))
    }
}
