//! Distances of single pairs of links, for choosing the pairs that need no check.

use super::super::LinkId;
use super::solid;
use super::{AllowedReason, BodyId, CollisionModel, with_scratch};

/// Distance of a pair that leaves a planner no room [m]: 1 mm more than the 5 mm that wisch keeps by default.
pub(crate) const CLOSE: f64 = 6e-3;

/// Distance of a pair over the postures that were examined.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct PairDistance {
    /// Number of postures in which the pair overlaps.
    pub overlaps: usize,
    /// Number of postures in which the pair is not farther apart than [`CLOSE`].
    pub close: usize,
    /// Least distance [m]; at most 0 if the pair overlaps in a posture.
    pub least: f64,
    /// Posture of the least distance; empty before the first posture.
    pub nearest: Vec<f64>,
}

impl Default for PairDistance {
    fn default() -> Self {
        Self {
            overlaps: 0,
            close: 0,
            least: f64::INFINITY,
            nearest: Vec::new(),
        }
    }
}

impl PairDistance {
    /// Adds the postures of `other`; of two equal distances the first one's posture is kept.
    pub fn merge(&mut self, other: Self) {
        self.overlaps += other.overlaps;
        self.close += other.close;
        if other.least < self.least {
            self.least = other.least;
            self.nearest = other.nearest;
        }
    }
}

impl CollisionModel {
    /// Returns the pairs of links that are checked.
    pub(crate) fn checked_links(&self) -> Vec<[LinkId; 2]> {
        let links = |pair: &[BodyId; 2]| pair.map(|body| LinkId(body.0));
        self.pairs.iter().map(links).collect()
    }

    /// Returns the pairs of neighbouring links with shapes.
    pub(crate) fn neighbouring_links(&self) -> Vec<[LinkId; 2]> {
        let neighbours = self.allowed.iter();
        neighbours
            .filter(|(_, reason)| **reason == AllowedReason::Neighbours)
            .map(|(pair, _)| pair.map(|body| LinkId(body.0)))
            .collect()
    }

    /// Returns the pairs of links with shapes that no joint moves against each other and that are no neighbours, each
    /// with whether the two overlap.
    pub(crate) fn fixed_links(&self) -> Vec<([LinkId; 2], bool)> {
        let links = 0..self.mounts.len();
        let solid: Vec<usize> = links
            .filter(|&i| !self.bodies[i].solids.is_empty())
            .collect();
        let mut fixed = Vec::new();
        for (at, &a) in solid.iter().enumerate() {
            for &b in &solid[at + 1..] {
                let shares_frame = self.bodies[a].frame == self.bodies[b].frame;
                if shares_frame && !self.may_touch([BodyId(a), BodyId(b)]) {
                    fixed.push(([LinkId(a), LinkId(b)], self.overlap_in_frame(a, b)));
                }
            }
        }
        fixed
    }

    /// Whether two bodies that share a frame overlap.
    fn overlap_in_frame(&self, a: usize, b: usize) -> bool {
        let placed = |i: usize| {
            let solid = &self.solids[i];
            (&solid.solid, &solid.frame_from_solid)
        };
        let (a, b) = (self.bodies[a].solids.clone(), self.bodies[b].solids.clone());
        a.into_iter().any(|i| {
            let mut others = b.clone();
            others.any(|j| solid::distance(placed(i), placed(j), f64::MIN_POSITIVE) <= 0.0)
        })
    }

    /// Adds a posture `q` (n) to the distances of the pairs of [`checked_links`](Self::checked_links).
    pub(crate) fn add_posture(&self, q: &[f64], pairs: &mut [PairDistance]) {
        with_scratch(|scratch| {
            self.place(q, scratch);
            for (known, &pair) in pairs.iter_mut().zip(&self.pairs) {
                let up_to = known.least.max(CLOSE.next_up());
                let distance = self.distance(pair, scratch, up_to);
                known.overlaps += usize::from(distance <= 0.0);
                known.close += usize::from(distance <= CLOSE);
                if distance < known.least {
                    known.least = distance;
                    known.nearest = q.to_vec();
                }
            }
        });
    }

    /// Returns the distances [m] of all checked pairs of links and bodies, without obstacles, at positions `q` (n),
    /// each at most `up_to`.
    pub(crate) fn own_distances(&self, q: &[f64], up_to: f64) -> Vec<f64> {
        with_scratch(|scratch| {
            self.place(q, scratch);
            let pairs = self.pairs.iter();
            pairs
                .map(|&pair| self.distance(pair, scratch, up_to).min(up_to))
                .collect()
        })
    }

    /// Returns the links of a checked pair; `None` if the pair contains a tool.
    pub(crate) fn own_links(&self, pair: usize) -> Option<[LinkId; 2]> {
        let bodies = self.pairs.get(pair)?;
        let are_links = bodies.iter().all(|body| body.0 < self.mounts.len());
        are_links.then(|| bodies.map(|body| LinkId(body.0)))
    }

    /// Returns the names of a checked pair of links and bodies.
    pub(crate) fn own_pair(&self, pair: usize) -> [&str; 2] {
        self.pairs[pair].map(|body| self.name(body))
    }

    /// Returns the distance [m] of a pair of [`checked_links`](Self::checked_links) at positions `q` (n) if it is below
    /// `up_to`, and infinity otherwise.
    pub(crate) fn pair_distance(&self, pair: usize, q: &[f64], up_to: f64) -> f64 {
        with_scratch(|scratch| {
            self.place(q, scratch);
            self.distance(self.pairs[pair], scratch, up_to.max(f64::MIN_POSITIVE))
        })
    }
}
