//! Free motion of the arm between two configurations: a bidirectional random tree in joint space
//! (RRT-Connect; Kuffner and LaValle, 2000), shortened.

use super::arm::{Arm, between, widest_step};
use crate::follow::AllowedContact;
use crate::robot::JointPositions;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Longest new branch of a tree, for any joint [rad or m].
const BRANCH: f64 = 0.5;
/// Largest number of random configurations.
const MAX_DRAWS: usize = 1500;
/// Largest number of random configurations with the larger clearance.
const MAX_DRAWS_AT_CLEARANCE: usize = 200;
/// Number of attempts to shorten the path.
const SHORTCUTS: usize = 60;

struct Tree {
    nodes: Vec<(JointPositions, usize)>,
}

impl Tree {
    fn new(root: JointPositions) -> Self {
        Self {
            nodes: vec![(root, 0)],
        }
    }

    fn nearest(&self, q: &JointPositions) -> usize {
        (0..self.nodes.len())
            .min_by(|&a, &b| {
                distance(&self.nodes[a].0, q).total_cmp(&distance(&self.nodes[b].0, q))
            })
            .unwrap_or(0)
    }

    /// Grows the tree towards `q`, which keeps both hands on the tool; returns the new node, if the path is
    /// free.
    fn grow(&mut self, arm: &Arm, q: &JointPositions) -> Option<usize> {
        let parent = self.nearest(q);
        let from = self.nodes[parent].0;
        let share = (BRANCH / widest_step(&from, q)).min(1.0);
        // `q` itself already keeps both hands on the tool. Correcting it again might move it, and the trees
        // would never meet.
        let to = if share < 1.0 {
            arm.hold(&between(&from, q, share))?
        } else {
            *q
        };
        arm.free_path(&from, &to, AllowedContact::None).ok()?;
        self.nodes.push((to, parent));
        Some(self.nodes.len() - 1)
    }

    fn to_root(&self, mut at: usize) -> Vec<JointPositions> {
        let mut path = vec![self.nodes[at].0];
        while at != 0 {
            at = self.nodes[at].1;
            path.push(self.nodes[at].0);
        }
        path
    }
}

/// Returns a free path between two configurations, both included; `None` if none is found within the budget. If
/// possible, the path keeps [`free_clearance`](crate::follow::FollowConfig::free_clearance) from obstacles.
pub(in crate::follow) fn free_motion(
    arm: &Arm,
    from: &JointPositions,
    to: &JointPositions,
    seed: u64,
) -> Option<Vec<JointPositions>> {
    let clear = search_free_path(
        &arm.with_free_clearance(),
        [from, to],
        seed,
        MAX_DRAWS_AT_CLEARANCE,
    );
    clear.or_else(|| search_free_path(arm, [from, to], seed, MAX_DRAWS))
}

/// Searches for a free path with two random trees that grow towards each other.
fn search_free_path(
    arm: &Arm,
    [from, to]: [&JointPositions; 2],
    seed: u64,
    draws: usize,
) -> Option<Vec<JointPositions>> {
    if let Ok(way) = arm.free_path(from, to, AllowedContact::None) {
        return Some([vec![*from], way].concat());
    }
    if !(arm.is_free_at(from, AllowedContact::None) && arm.is_free_at(to, AllowedContact::None)) {
        return None;
    }
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let ranges = arm.ranges();
    let mut trees = [Tree::new(*from), Tree::new(*to)];
    for draw in 0..draws {
        let q: JointPositions = ranges
            .iter()
            .map(|&[lower, upper]| random.random_range(lower..=upper))
            .collect();
        if !arm.is_within_ranges(&q) {
            continue;
        }
        let Some(q) = arm.hold(&q) else { continue };
        let (grown, other) = (draw % 2, 1 - draw % 2);
        let Some(new) = trees[grown].grow(arm, &q) else {
            continue;
        };
        let goal = trees[grown].nodes[new].0;
        let mut left = f64::INFINITY;
        while let Some(met) = trees[other].grow(arm, &goal) {
            if trees[other].nodes[met].0 == goal {
                let ends = if grown == 0 { [new, met] } else { [met, new] };
                let mut path = trees[0].to_root(ends[0]);
                path.reverse();
                path.extend(trees[1].to_root(ends[1]).into_iter().skip(1));
                shorten(arm, &mut path, &mut random);
                return whole(arm, &path);
            }
            // Bringing the second hand back to the tool may increase the distance again.
            let before = std::mem::replace(&mut left, distance(&trees[other].nodes[met].0, &goal));
            if left >= before {
                break;
            }
        }
    }
    None
}

/// Shortcuts: replaces pieces of the path by straight ones.
fn shorten(arm: &Arm, path: &mut Vec<JointPositions>, random: &mut ChaCha8Rng) {
    for _ in 0..SHORTCUTS {
        if path.len() < 3 {
            return;
        }
        let mut pick = || {
            let i = random.random_range(0..path.len() - 1);
            let s: f64 = random.random();
            (i, arm.hold(&between(&path[i], &path[i + 1], s)))
        };
        let ((a, Some(from_a)), (b, Some(from_b))) = (pick(), pick()) else {
            continue;
        };
        let (a, b) = ((a, from_a), (b, from_b));
        let ((i, from), (k, to)) = if a.0 <= b.0 { (a, b) } else { (b, a) };
        let is_free = |a: &JointPositions, b: &JointPositions| {
            arm.free_path(a, b, AllowedContact::None).is_ok()
        };
        // With two hands on the tool, the rest of a piece need not be free if the whole piece is.
        let is_rest = |a, b| arm.cell.second_arm().is_none() || is_free(a, b);
        if i < k && is_free(&from, &to) && is_rest(&path[i], &from) && is_rest(&to, &path[k + 1]) {
            path.splice(i + 1..=k, [from, to]);
        }
    }
}

/// Returns the corners with all configurations between them.
fn whole(arm: &Arm, corners: &[JointPositions]) -> Option<Vec<JointPositions>> {
    let mut path = vec![corners[0]];
    for pair in corners.windows(2) {
        path.extend(
            arm.free_path(&pair[0], &pair[1], AllowedContact::None)
                .ok()?,
        );
    }
    Some(path)
}

fn distance(a: &JointPositions, b: &JointPositions) -> f64 {
    a.iter().zip(b.iter()).map(|(a, b)| (a - b) * (a - b)).sum()
}
