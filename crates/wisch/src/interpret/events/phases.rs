//! Phases of a log: approach, strokes, lifts between them, retreat.

use super::detector::EventDetector;
use super::event::{Event, EventKind};

impl EventDetector<'_> {
    /// Returns the phases, which cover the log from the first piece to the last; empty if there was no contact.
    /// `contacts` are sorted by start.
    pub(super) fn phases(&self, contacts: &[Event]) -> Vec<Event> {
        let strokes = self.strokes(contacts);
        let (Some(&[first, _]), Some(&[_, last])) = (strokes.first(), strokes.last()) else {
            return Vec::new();
        };
        let end = self.path.len() - 1;
        let mut phases = Vec::new();
        if first > 0 {
            phases.push(self.describe(EventKind::Approach, 0, first - 1));
        }
        for pair in strokes.windows(2) {
            let ([_, before], [next, _]) = (pair[0], pair[1]);
            phases.push(self.describe(EventKind::Lift, before + 1, next - 1));
        }
        phases.extend(
            (strokes.iter()).map(|&[first, last]| self.describe(EventKind::Stroke, first, last)),
        );
        if last < end {
            phases.push(self.describe(EventKind::Retreat, last + 1, end));
        }
        phases
    }

    /// Returns the first and last piece of each stroke: contacts between which the tool stayed near the surface form
    /// one.
    pub(super) fn strokes(&self, contacts: &[Event]) -> Vec<[usize; 2]> {
        let mut strokes: Vec<[usize; 2]> = Vec::new();
        for contact in contacts {
            let from = (self.path).partition_point(|piece| piece.time[1] < contact.start);
            let to = self
                .path
                .partition_point(|piece| piece.time[0] <= contact.end);
            let to = to.saturating_sub(1).max(from);
            match strokes.last_mut() {
                Some([_, last]) if self.stays_near(*last, from) => *last = to.max(*last),
                _ => strokes.push([from, to]),
            }
        }
        strokes
    }

    /// Whether the tool stayed near the surface between two pieces; true for adjacent ones.
    fn stays_near(&self, last: usize, next: usize) -> bool {
        let near = self.config.events.near_height_m;
        next <= last + 1 || (self.path[last..=next].iter()).all(|piece| piece.height.abs() <= near)
    }
}
