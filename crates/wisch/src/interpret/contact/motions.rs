//! Straight contact motions that approximate a path.

use super::path::PathPiece;
use crate::geometry::{Edge, PlanarPose, Point2, Pose, Vector2, wrap_angle};
use crate::represent::ToolMotion;

/// Longest motion that is replayed in one step [m], as thresholds are drawn between motions.
pub(in crate::interpret) const MAX_LENGTH: f64 = 0.01;
/// Largest travel of a standing tool [m], and largest rotation [rad].
const STANDING: [f64; 2] = [2e-3, 0.035];
/// Limits of a standing tool at the beginning of a contact [m, rad]. The dirt below the tool is
/// carried in the direction of its first motion, which must not be that of a vibration, of
/// settling, or of a turn before the stroke.
const SETTLING: [f64; 2] = [0.01, 0.35];
/// Largest distance of a path from the straight motion that approximates it [m].
const MAX_DEVIATION: f64 = 5e-4;
/// Change of f′ at which a new motion begins [1]; above the noise of forces at 100 Hz, as otherwise the strongest of
/// many noisy values would be chosen.
const MAX_SHARE_CHANGE: f64 = 0.15;
/// Rotation below which the yaw counts as constant [rad]; half a degree, 0.5 mm at a sponge's corner.
const HEADING_STEP: f64 = 0.0087;
/// Largest rotation within one motion [rad]; 6°, for which a straight line may replace an arc.
const MAX_TURN: f64 = 0.105;
/// Distance below which two places are the same [m].
const SAME_PLACE: f64 = 1e-4;
/// Longest time between two pieces of one contact [s].
const MAX_GAP: f64 = 0.25;

/// f′ of a contact, and the point under the tool to which it refers [1].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::interpret) enum NormalizedForce {
    /// There is no contact.
    NoContact,
    /// Mean over the whole tool, from a measured force.
    Mean(f64),
    /// Value in the middle of the tool, from its distance to the plane; below 0 if only a side touches.
    Middle(f64),
}

impl NormalizedForce {
    pub(in crate::interpret) const fn value(self) -> f64 {
        match self {
            Self::NoContact => 0.0,
            Self::Mean(value) | Self::Middle(value) => value,
        }
    }

    /// Returns f′ for a force scaled by `factor`; a value from a distance does not change.
    pub(in crate::interpret) fn scale(self, factor: f64) -> Self {
        match self {
            Self::Mean(share) => Self::Mean(share * factor),
            Self::NoContact | Self::Middle(_) => self,
        }
    }

    /// Returns the same kind with another value.
    const fn with(self, share: f64) -> Self {
        match self {
            Self::NoContact => Self::NoContact,
            Self::Mean(_) => Self::Mean(share),
            Self::Middle(_) => Self::Middle(share),
        }
    }
}

/// A straight motion in contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::interpret) struct ContactMotion {
    pub(in crate::interpret) motion: ToolMotion,
    /// Mean f′ over the motion.
    pub(in crate::interpret) force: NormalizedForce,
    /// Mean slope of the plane against the underside, in the tool frame [1].
    pub(in crate::interpret) slope: Vector2,
    /// Whether it begins where the motion before ended, without a lift between them.
    pub(in crate::interpret) continues: bool,
    /// Time at its end [s].
    pub(in crate::interpret) end_time: f64,
}

/// Returns the straight contact motions of a path, in the frame of the real surface. `force` gives f′ of each piece.
pub(in crate::interpret) fn contact_motions(
    path: &[PathPiece],
    real_from_believed: &Pose,
    force: impl Fn(usize) -> NormalizedForce,
) -> Vec<ContactMotion> {
    let mut builder = Builder::default();
    for (i, piece) in path.iter().enumerate() {
        match force(i) {
            NormalizedForce::NoContact => builder.interrupt(),
            force => builder.take(piece, force, real_from_believed),
        }
    }
    builder.interrupt();
    builder.motions
}

/// Joins pieces into motions.
#[derive(Debug, Default)]
struct Builder {
    motions: Vec<ContactMotion>,
    open: Option<Open>,
}

/// A motion that is still growing.
#[derive(Debug)]
struct Open {
    from: PlanarPose,
    to: PlanarPose,
    last_time: f64,
    kind: NormalizedForce,
    /// Places passed so far, the last one included.
    passed: Vec<Point2>,
    /// Travel [m] and f′ times travel; a standing tool counts pieces instead.
    travel: f64,
    share_by_travel: f64,
    pieces: f64,
    share_by_pieces: f64,
    slope_by_pieces: Vector2,
    continues: bool,
}

impl Builder {
    fn take(&mut self, piece: &PathPiece, force: NormalizedForce, real_from_believed: &Pose) {
        let position = (real_from_believed * piece.position).xy();
        if let Some(open) = &self.open
            && piece.time[0] - open.last_time > MAX_GAP
        {
            self.interrupt();
        }
        let Some(open) = &mut self.open else {
            let at = PlanarPose::new(position, piece.heading);
            self.open = Some(Open::at(at, piece, force, false));
            return;
        };
        let turn = wrap_angle(piece.heading - open.to.heading);
        let to = PlanarPose::new(position, open.to.heading + turn);
        if open.stands_on(force) || open.goes_on_to(&to, force) {
            open.grow(to, piece, force);
        } else {
            let mut next = Open::at(open.end(), piece, force, true);
            next.grow(to, piece, force);
            self.close();
            self.open = Some(next);
        }
    }

    /// Ends the contact. A standing remainder counts only if the contact holds nothing else.
    fn interrupt(&mut self) {
        match &mut self.open {
            Some(open) if open.is_within(STANDING) && open.continues => self.open = None,
            Some(open) => {
                if open.is_within(STANDING) {
                    open.to = open.from;
                }
                self.close();
            }
            None => {}
        }
    }

    /// Stores the motion, in parts if it is too long: pieces of a slowly sampled log may exceed the limit.
    fn close(&mut self) {
        let Some(open) = self.open.take() else {
            return;
        };
        let to = open.end();
        let way = to.position - open.from.position;
        let turn = to.heading - open.from.heading;
        let parts = (way.norm() / MAX_LENGTH).ceil().max(1.0) as u32;
        let at = |part: u32| {
            let share = f64::from(part) / f64::from(parts);
            // A motion without rotation has exactly the same yaw in all parts.
            PlanarPose::new(
                open.from.position + way * share,
                open.from.heading + turn * share,
            )
        };
        self.motions.extend((0..parts).map(|part| ContactMotion {
            motion: ToolMotion {
                from: at(part),
                to: at(part + 1),
            },
            force: open.kind.with(open.share()),
            slope: open.slope(),
            continues: open.continues || part > 0,
            end_time: open.last_time,
        }));
    }
}

impl Open {
    fn at(from: PlanarPose, piece: &PathPiece, force: NormalizedForce, continues: bool) -> Self {
        Self {
            from,
            to: from,
            last_time: piece.time[1],
            kind: force,
            passed: Vec::new(),
            travel: 0.0,
            share_by_travel: 0.0,
            pieces: 1.0,
            share_by_pieces: force.value(),
            slope_by_pieces: piece.slope,
            continues,
        }
    }

    fn length(&self) -> f64 {
        (self.to.position - self.from.position).norm()
    }

    fn turn(&self) -> f64 {
        self.to.heading - self.from.heading
    }

    fn is_within(&self, [length, turn]: [f64; 2]) -> bool {
        self.length() < length && self.turn().abs() < turn
    }

    fn is_standing(&self) -> bool {
        self.is_within(if self.continues { STANDING } else { SETTLING })
    }

    /// Pose at the end; the yaw stays that of the beginning if it has hardly changed.
    fn end(&self) -> PlanarPose {
        if self.turn().abs() < HEADING_STEP {
            PlanarPose::new(self.to.position, self.from.heading)
        } else {
            self.to
        }
    }

    /// Mean f′ along the way [1].
    fn share(&self) -> f64 {
        if self.travel > SAME_PLACE {
            self.share_by_travel / self.travel
        } else {
            self.share_by_pieces / self.pieces
        }
    }

    /// Mean slope, not weighted by travel as it changes slowly.
    fn slope(&self) -> Vector2 {
        self.slope_by_pieces / self.pieces
    }

    fn is_like(&self, force: NormalizedForce) -> bool {
        std::mem::discriminant(&self.kind) == std::mem::discriminant(&force)
    }

    fn stands_on(&self, force: NormalizedForce) -> bool {
        self.is_standing() && self.is_like(force)
    }

    fn goes_on_to(&self, to: &PlanarPose, force: NormalizedForce) -> bool {
        let chord = Edge {
            start: self.from.position,
            end: to.position,
        };
        self.is_like(force)
            && (force.value() - self.share()).abs() <= MAX_SHARE_CHANGE
            && (to.heading - self.from.heading).abs() <= MAX_TURN
            && (to.position - self.from.position).norm() <= MAX_LENGTH
            && (self.passed.iter()).all(|place| chord.distance(*place) <= MAX_DEVIATION)
    }

    fn grow(&mut self, to: PlanarPose, piece: &PathPiece, force: NormalizedForce) {
        let last = self.passed.last().copied().unwrap_or(self.from.position);
        let step = (to.position - last).norm();
        if step > SAME_PLACE {
            self.travel += step;
            self.share_by_travel += step * force.value();
            // The places of a standing tool are not on its path.
            if self.is_standing() {
                self.passed.clear();
            }
            self.passed.push(to.position);
        }
        self.pieces += 1.0;
        self.share_by_pieces += force.value();
        self.slope_by_pieces += piece.slope;
        self.last_time = piece.time[1];
        self.to = to;
    }
}
