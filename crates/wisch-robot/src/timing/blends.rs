//! A path with round corners: straight pieces joined by parabolic blends.
//!
//! The path parameter σ is the time [s] in which the fastest joint could cover the path at its velocity limit,
//! so that along a straight piece the joint limits mean σ̇ ≤ 1. Around a waypoint, from σ − ℓ to σ + ℓ, the
//! direction dq/dσ turns linearly from that of one segment to that of the other. The parabola misses the
//! waypoint by ℓ·|Δdirection|/4 and stays within that distance of the segments. It lies in the triangle of its
//! ends and the waypoint, hence within the range of every joint.

use super::{JointLimits, JointPath};

/// Waypoints nearer to the last one than this share of the blend tolerance are skipped [1].
const MERGED_SHARE: f64 = 0.1;

/// Remainder of a segment between two blends that is only rounding; relative to the segment.
const NO_REMAINDER: f64 = 1e-13;

/// The shortest straight piece kept between two blends; relative to its segment.
const LEAST_REMAINDER: f64 = 1e-3;

/// A part of the path in which q(σ) is quadratic.
#[derive(Debug, Clone, Copy)]
pub(super) struct BlendedPiece {
    /// Length in σ [s].
    pub length: f64,
    /// Largest σ̇ [1] that the segments' shortest times allow.
    pub speed_cap: f64,
    /// Whether the piece is a link between two blends, so short that one grid interval suffices.
    pub is_link: bool,
}

/// A path with a continuous direction.
#[derive(Debug, Clone)]
pub(super) struct BlendedPath {
    joint_count: usize,
    pieces: Vec<BlendedPiece>,
    /// Per piece and joint: q, dq/dσ at the piece's start, and d²q/dσ².
    terms: Vec<[f64; 3]>,
}

/// The waypoints that are kept, and the segments between them.
struct Polyline<'a> {
    waypoints: Vec<&'a [f64]>,
    /// Shortest time of each segment [s].
    times: Vec<f64>,
}

impl<'a> Polyline<'a> {
    fn new(path: &'a JointPath, merged: f64) -> Self {
        let is_near = |a: &[f64], b: &[f64]| a.iter().zip(b).all(|(a, b)| (a - b).abs() <= merged);
        let mut waypoints = vec![path.waypoint(0)];
        let mut times = Vec::new();
        let mut pending = 0.0;
        let last = path.waypoint_count() - 1;
        for index in 1..=last {
            let waypoint = path.waypoint(index);
            pending += path.segment_times()[index - 1];
            if is_near(waypoint, waypoints[waypoints.len() - 1]) {
                if index < last {
                    continue;
                }
                // The last waypoint replaces the one that it is near, unless that is the first.
                if waypoints.len() > 1 {
                    waypoints.pop();
                    pending += times.pop().unwrap_or(0.0);
                } else if waypoint == waypoints[0] {
                    break;
                }
            }
            waypoints.push(waypoint);
            times.push(pending);
            pending = 0.0;
        }
        Self { waypoints, times }
    }
}

impl BlendedPath {
    /// Rounds the corners so that no joint deviates from the polyline by more than `tolerance` [rad or m]. The
    /// path has no pieces if all waypoints are the same.
    pub fn new(path: &JointPath, limits: &JointLimits, tolerance: f64) -> Self {
        let merged = MERGED_SHARE * tolerance;
        let polyline = Polyline::new(path, merged);
        let waypoints = &polyline.waypoints;
        let lengths: Vec<f64> = waypoints
            .windows(2)
            .map(|ends| {
                let joints = limits.joints().iter().zip(ends[0].iter().zip(ends[1]));
                joints
                    .map(|(joint, (a, b))| (b - a).abs() / joint.velocity)
                    .fold(0.0, f64::max)
            })
            .collect();
        let directions: Vec<Vec<f64>> = waypoints
            .windows(2)
            .zip(&lengths)
            .map(|(ends, length)| {
                let steps = ends[0].iter().zip(ends[1]);
                steps.map(|(a, b)| (b - a) / length).collect()
            })
            .collect();
        let reaches = blend_reaches(&lengths, &directions, tolerance - merged);

        let mut blended = Self {
            joint_count: path.joint_count(),
            pieces: Vec::new(),
            terms: Vec::new(),
        };
        let speed = |segment: usize| lengths[segment] / polyline.times[segment];
        for (segment, direction) in directions.iter().enumerate() {
            let (before, after) = (reaches[segment], reaches[segment + 1]);
            let length = lengths[segment];
            let remainder = length - before - after;
            if remainder > NO_REMAINDER * length {
                let begin = waypoints[segment].iter().zip(direction);
                blended.pieces.push(BlendedPiece {
                    length: remainder,
                    speed_cap: speed(segment),
                    is_link: remainder < 10.0 * LEAST_REMAINDER * length,
                });
                blended
                    .terms
                    .extend(begin.map(|(q, d)| [q + before * d, *d, 0.0]));
            }
            if segment + 1 < directions.len() {
                blended.pieces.push(BlendedPiece {
                    length: 2.0 * after,
                    speed_cap: speed(segment).min(speed(segment + 1)),
                    is_link: false,
                });
                let turn = direction.iter().zip(&directions[segment + 1]);
                let corner = waypoints[segment + 1].iter().zip(turn);
                // A blend of length 2 ℓ: q(σ) = w − ℓ d₁ + σ d₁ + σ² (d₂ − d₁) / (4 ℓ).
                blended.terms.extend(
                    corner.map(|(q, (from, to))| {
                        [q - after * from, *from, (to - from) / (2.0 * after)]
                    }),
                );
            }
        }
        blended
    }

    pub fn pieces(&self) -> &[BlendedPiece] {
        &self.pieces
    }

    /// For each joint: q, dq/dσ at the piece's start, and d²q/dσ².
    pub fn terms(&self, piece: usize) -> &[[f64; 3]] {
        &self.terms[piece * self.joint_count..][..self.joint_count]
    }
}

/// Returns the length by which each waypoint's blend reaches into its two segments [s]; 0 at the ends.
fn blend_reaches(lengths: &[f64], directions: &[Vec<f64>], tolerance: f64) -> Vec<f64> {
    let mut reaches = vec![0.0; lengths.len() + 1];
    for corner in 1..lengths.len() {
        let turn = directions[corner - 1].iter().zip(&directions[corner]);
        let sharpest = turn.map(|(a, b)| (b - a).abs()).fold(0.0, f64::max);
        let room = 0.5 * lengths[corner - 1].min(lengths[corner]);
        // The parabola misses the waypoint by ℓ · |Δdirection| / 4 ≤ tolerance.
        reaches[corner] = room.min(4.0 * tolerance / sharpest);
    }
    // A straight piece of vanishing length would consist only of rounding errors.
    for (segment, &length) in lengths.iter().enumerate() {
        let remainder = length - reaches[segment] - reaches[segment + 1];
        if remainder > NO_REMAINDER * length && remainder < LEAST_REMAINDER * length {
            let shrink = 1.0 - LEAST_REMAINDER;
            reaches[segment] *= shrink;
            reaches[segment + 1] *= shrink;
        }
    }
    reaches
}
