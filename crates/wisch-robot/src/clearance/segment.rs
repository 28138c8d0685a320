//! Collision checks of straight joint segments.

use super::{Body, BodyId, CollisionModel, Contact, Margins, Scratch, with_scratch};
use crate::RobotError;

/// Largest motion of any pair within a span at which bisection ends \[m\]; a pair that keeps its margin by less may be
/// reported as a contact.
pub const SEGMENT_RESOLUTION: f64 = 1e-4;

/// Largest number of postures examined for one segment; a span that is not proven clear by then
/// counts as a contact.
const MAX_POSTURES: usize = 100_000;

/// A pair that is not yet proven to stay apart.
#[derive(Debug, Clone, Copy)]
pub(super) struct OpenPair {
    pair: [BodyId; 2],
    /// Upper bound on its relative motion over the whole segment [m].
    motion: f64,
    /// Distance that it must keep [m].
    margin: f64,
}

/// A part of a segment, with the pairs that are not yet proven to stay apart on it.
pub(super) struct Span {
    /// Its middle, from 0 to 1 along the segment.
    middle: f64,
    half: f64,
    /// Index of its first pair among the open ones.
    from: usize,
    to: usize,
}

impl CollisionModel {
    /// Returns an upper bound on how far any point of the robot and of attached bodies moves between two configurations
    /// (n) [rad or m] on a straight joint segment \[m\].
    ///
    /// Infinity if an array does not have n finite values.
    pub fn motion_bound(&self, from: &[f64], to: &[f64]) -> f64 {
        if self
            .check_positions(from)
            .and(self.check_positions(to))
            .is_err()
        {
            return f64::INFINITY;
        }
        let motion = |body: &Body| {
            self.frames
                .motion([body.frame, 0], [body.reach, 0.0], from, to)
        };
        self.bodies.iter().map(motion).fold(0.0, f64::max)
    }

    /// Returns a pair that comes within its margin \[m\] on the straight joint segment between two configurations (n)
    /// [rad or m]. `None` only if every checked pair keeps its margin everywhere on the segment.
    ///
    /// A span is clear if each pair moves on it by no more than its distance at the middle exceeds its margin
    /// (Schwarzer, Saha, Latombe 2005); other spans are bisected. A pair may be returned that keeps its margin by less
    /// than [`SEGMENT_RESOLUTION`], or that 100 000 postures could not prove clear. The distance of the contact is that
    /// at the posture where it was found.
    ///
    /// # Errors
    /// If an array does not have n finite values, or a margin is below 0 m.
    pub fn segment_contact(
        &self,
        from: &[f64],
        to: &[f64],
        margins: impl Into<Margins>,
    ) -> Result<Option<Contact>, RobotError> {
        let margins = margins.into();
        self.check_positions(from)?;
        self.check_positions(to)?;
        margins.check()?;
        Ok(with_scratch(|scratch| {
            self.first_on_segment(from, to, margins, scratch)
        }))
    }

    fn first_on_segment(
        &self,
        from: &[f64],
        to: &[f64],
        margins: Margins,
        scratch: &mut Scratch,
    ) -> Option<Contact> {
        let posture = |at: f64, scratch: &mut Scratch| {
            let mut q = std::mem::take(&mut scratch.q);
            q.clear();
            q.extend(from.iter().zip(to).map(|(a, b)| a + at * (b - a)));
            self.place(&q, scratch);
            scratch.q = q;
        };
        posture(0.5, scratch);
        self.open_pairs(from, to, margins, scratch);
        scratch.spans.clear();
        scratch.spans.push(Span {
            middle: 0.5,
            half: 0.5,
            from: 0,
            to: scratch.open.len(),
        });
        let mut postures = 0;
        while let Some(span) = scratch.spans.pop() {
            if postures > 0 {
                posture(span.middle, scratch);
            }
            postures += 1;
            scratch.open.truncate(span.to);
            for at in span.from..span.to {
                let open = scratch.open[at];
                let motion = open.motion * span.half;
                let margin = open.margin;
                let enough = margin + motion;
                let distance = self.distance(open.pair, scratch, enough.next_up());
                if distance > enough {
                    continue;
                }
                if distance <= margin || motion <= SEGMENT_RESOLUTION || postures >= MAX_POSTURES {
                    let [a, b] = open.pair;
                    return Some(Contact { a, b, distance });
                }
                scratch.open.push(open);
            }
            if scratch.open.len() > span.to {
                let half = span.half / 2.0;
                let (from, to) = (span.to, scratch.open.len());
                for middle in [span.middle + half, span.middle - half] {
                    scratch.spans.push(Span {
                        middle,
                        half,
                        from,
                        to,
                    });
                }
            }
        }
        None
    }

    /// Opens the pairs of a segment whose middle is placed; obstacles out of range of a body are left out.
    fn open_pairs(&self, from: &[f64], to: &[f64], margins: Margins, scratch: &mut Scratch) {
        scratch.open.clear();
        for row in &self.rows {
            let listed = self.pairs[row.pairs.clone()].iter();
            scratch.open.extend(listed.map(|&pair| OpenPair {
                pair,
                motion: self.pair_motion(pair, from, to),
                margin: margins.own,
            }));
            if !row.meets_obstacles {
                continue;
            }
            let Body { frame, reach, .. } = self.bodies[row.body.0];
            let motion = self.frames.motion([frame, 0], [reach, 0.0], from, to);
            let margin = margins.obstacles;
            self.find_obstacles_near(row, margin + 0.5 * motion, scratch);
            let obstacles = scratch.near.iter();
            scratch.open.extend(obstacles.map(|&obstacle| OpenPair {
                pair: [row.body, obstacle],
                motion,
                margin,
            }));
        }
    }

    fn pair_motion(&self, pair: [BodyId; 2], from: &[f64], to: &[f64]) -> f64 {
        let [a, b] = pair.map(|id| &self.bodies[id.0]);
        self.frames
            .motion([a.frame, b.frame], [a.reach, b.reach], from, to)
    }
}
