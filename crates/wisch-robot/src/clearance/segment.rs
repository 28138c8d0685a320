//! Straight joint segments: how far things move on them at most, and whether they stay apart.

use super::{Body, BodyId, CollisionModel, Contact, Margins, Scratch, with_scratch};
use crate::RobotError;

/// A segment is bisected until nothing moves further against anything else than this [m]: a pair that
/// keeps the margin by less may be taken for a contact.
pub const SEGMENT_RESOLUTION: f64 = 1e-4;

/// Most postures looked at for one segment; what is not known to be clear by then is a contact.
const MAX_POSTURES: usize = 100_000;

/// A pair that is not known to stay apart.
#[derive(Debug, Clone, Copy)]
pub(super) struct OpenPair {
    pair: [BodyId; 2],
    /// How far they move against each other on the whole segment at most [m].
    motion: f64,
    /// How far apart they are to stay [m].
    margin: f64,
}

/// A part of a segment, and the pairs that are not known to stay apart on it.
pub(super) struct Span {
    /// From 0 to 1 along the segment.
    middle: f64,
    half: f64,
    /// Where those pairs are among the open ones.
    from: usize,
    to: usize,
}

impl CollisionModel {
    /// Upper bound on how far any point of the robot and of the bodies attached to it moves between
    /// two configurations (n) [rad or m] on a straight joint segment [m].
    ///
    /// Infinite if an array is of another length or not finite.
    pub fn motion_bound(&self, from: &[f64], to: &[f64]) -> f64 {
        if self.checked(from).and(self.checked(to)).is_err() {
            return f64::INFINITY;
        }
        let motion = |body: &Body| {
            self.frames
                .motion([body.frame, 0], [body.reach, 0.0], from, to)
        };
        self.bodies.iter().map(motion).fold(0.0, f64::max)
    }

    /// A pair that comes within its margin [m] on the straight joint segment between two configurations
    /// (n) [rad or m]; `None` only if every checked pair keeps its margin everywhere on it.
    ///
    /// A span on which a pair moves by no more than it is clear of the margin in the middle is clear
    /// (Schwarzer, Saha, Latombe 2005); other spans are bisected. A pair may be named that keeps the
    /// margin by less than [`SEGMENT_RESOLUTION`], or that 100 000 postures did not show to be clear.
    /// The contact's distance is that at the posture where it was found.
    ///
    /// # Errors
    /// If an array is of another length or not finite, or a margin below 0 m.
    pub fn segment_contact(
        &self,
        from: &[f64],
        to: &[f64],
        margins: impl Into<Margins>,
    ) -> Result<Option<Contact>, RobotError> {
        let margins = margins.into();
        self.checked(from)?;
        self.checked(to)?;
        margins.checked()?;
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

    /// Opens the pairs of a segment whose middle is placed; obstacles that a body cannot come near are left out.
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
