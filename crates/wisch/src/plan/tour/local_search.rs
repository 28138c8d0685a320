//! Iterated local search: repair a tour by sequential exchanges, kick it at a random place, keep what shortens
//! it.

use super::problem::{Neighbours, Problem};
use super::ring::{ArrayTour, Direction, OpenedTour, Reversal};
use super::{TourConfig, greedy};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::collections::VecDeque;

/// Number of a node's neighbours that are tried at each step of an exchange; its length is the largest number
/// of steps. Wider and deeper searches gave shorter tours for equal kicks, but longer ones for equal time.
const BREADTH: [usize; 3] = [6, 4, 3];

/// Steps of the random walks that choose where to kick.
const KICK_WALK: usize = 15;

/// A saving below this share of the costs it was computed from may be rounding.
const RELATIVE_ROUNDING: f64 = 1e-14;

/// Costs removed from the tour and added to it so far.
#[derive(Debug, Clone, Copy, Default)]
struct Saving {
    amount: f64,
    magnitude: f64,
}

impl Saving {
    fn removing(self, cost: f64) -> Self {
        Self {
            amount: self.amount + cost,
            magnitude: self.magnitude + cost.abs(),
        }
    }

    fn adding(self, cost: f64) -> Self {
        Self {
            amount: self.amount - cost,
            magnitude: self.magnitude + cost.abs(),
        }
    }

    /// Whether the saving exceeds rounding errors; so two exchanges cannot undo each other for ever.
    fn is_gain(self) -> bool {
        self.amount > RELATIVE_ROUNDING * self.magnitude
    }
}

/// Nodes whose surroundings changed, each at most once.
struct Queue {
    nodes: VecDeque<usize>,
    waiting: Vec<bool>,
}

impl Queue {
    fn push(&mut self, node: usize) {
        if !self.waiting[node] {
            self.waiting[node] = true;
            self.nodes.push_back(node);
        }
    }

    fn pop(&mut self) -> Option<usize> {
        let node = self.nodes.pop_front()?;
        self.waiting[node] = false;
        Some(node)
    }
}

struct LocalSearch<'a> {
    problem: &'a Problem<'a>,
    neighbours: &'a Neighbours,
    tour: ArrayTour,
    queue: Queue,
}

impl<'a> LocalSearch<'a> {
    fn new(problem: &'a Problem<'a>, neighbours: &'a Neighbours, order: Vec<usize>) -> Self {
        Self {
            problem,
            neighbours,
            queue: Queue {
                nodes: order.iter().copied().collect(),
                waiting: vec![true; order.len()],
            },
            tour: ArrayTour::new(order),
        }
    }

    /// Improves the tour around the queued nodes until no exchange saves cost; returns the saving, ≥ 0.
    fn settle(&mut self) -> f64 {
        let mut saved = 0.0;
        while let Some(node) = self.queue.pop() {
            while let Some(saving) = self.improve_at(node) {
                saved += saving;
            }
        }
        saved
    }

    /// Makes the first exchange that removes an edge of `node` and saves cost; returns the saving.
    fn improve_at(&mut self, node: usize) -> Option<f64> {
        for direction in [Direction::Forward, Direction::Backward] {
            let first = match direction {
                Direction::Forward => self.tour.next(node),
                Direction::Backward => self.tour.previous(node),
            };
            if self.problem.is_fixed(node, first) {
                continue;
            }
            let mut opened = OpenedTour {
                first,
                last: node,
                direction,
                turned: Vec::new(),
            };
            let removed = Saving::default().removing(self.problem.cost(node, first));
            let found = self
                .exchange_by_turning(&mut opened, removed, 0)
                .or_else(|| self.exchange_by_moving(&mut opened, removed));
            if let Some(saving) = found {
                for reversal in opened.reversals(&self.tour) {
                    self.tour.reverse(reversal);
                    let Reversal {
                        before,
                        first,
                        last,
                        after,
                    } = reversal;
                    for touched in [before, first, last, after] {
                        self.queue.push(touched);
                    }
                }
                return Some(saving);
            }
        }
        None
    }

    /// Links the path's first node to a near node and reverses the stretch between, so that the path has a new
    /// first node. Goes one step deeper if closing the path there saves nothing.
    fn exchange_by_turning(
        &self,
        opened: &mut OpenedTour,
        removed: Saving,
        depth: usize,
    ) -> Option<f64> {
        let &breadth = BREADTH.get(depth)?;
        let first = opened.node(&self.tour, 0);
        for near in self.neighbours.of(first).iter().take(breadth) {
            let linked = removed.adding(near.cost);
            if !linked.is_gain() {
                break;
            }
            let index = opened.index(&self.tour, near.node);
            if index == 1 || index + 1 == self.tour.len() {
                continue;
            }
            let new_first = opened.node(&self.tour, index - 1);
            if self.problem.is_fixed(new_first, near.node) {
                continue;
            }
            let cut = linked.removing(self.problem.cost(new_first, near.node));
            opened.turned.push((0, index - 1));
            let closed = cut.adding(self.problem.cost(new_first, opened.last));
            if closed.is_gain() {
                return Some(closed.amount);
            }
            if let Some(saving) = self.exchange_by_turning(opened, cut, depth + 1) {
                return Some(saving);
            }
            opened.turned.pop();
        }
        None
    }

    /// Links the path's first node to a near node behind a stretch, which then becomes a ring, and opens the
    /// ring at another edge to link it to the rest. This moves a segment of any length.
    fn exchange_by_moving(&self, opened: &mut OpenedTour, removed: Saving) -> Option<f64> {
        for near in self.neighbours.of(opened.first).iter().take(BREADTH[0]) {
            let linked = removed.adding(near.cost);
            if !linked.is_gain() {
                break;
            }
            let ring_end = opened.index(&self.tour, near.node);
            if ring_end == 1 || ring_end + 1 == self.tour.len() {
                continue;
            }
            let rest = opened.node(&self.tour, ring_end + 1);
            if self.problem.is_fixed(near.node, rest) {
                continue;
            }
            let cut = linked.removing(self.problem.cost(near.node, rest));
            for joint in self.neighbours.of(rest).iter().take(BREADTH[1]) {
                let joined = cut.adding(joint.cost);
                if !joined.is_gain() {
                    break;
                }
                let split = opened.index(&self.tour, joint.node);
                if split >= ring_end {
                    continue;
                }
                // Opened behind the joint, the two parts of the ring change places; before it, each is reversed
                // where it is (and a stretch of one node fills the array).
                let behind = [
                    (0, ring_end),
                    (0, ring_end - split - 1),
                    (ring_end - split, ring_end),
                ];
                let before = split
                    .checked_sub(1)
                    .map(|new_first| (new_first, [(0, new_first), (split, ring_end), (0, 0)]));
                for (new_first, turned) in std::iter::once((split + 1, behind)).chain(before) {
                    let new_first = opened.node(&self.tour, new_first);
                    if self.problem.is_fixed(joint.node, new_first) {
                        continue;
                    }
                    let closed = joined
                        .removing(self.problem.cost(joint.node, new_first))
                        .adding(self.problem.cost(new_first, opened.last));
                    if closed.is_gain() {
                        opened.turned.extend(turned);
                        return Some(closed.amount);
                    }
                }
            }
        }
        None
    }

    /// Cuts the tour behind four nodes close to each other and joins the stretches in the opposite order
    /// without reversing any: a double bridge (Martin, Otto and Felten, 1991), which the exchanges above cannot
    /// simply undo. The saving is mostly negative. Returns `None` if four different nodes were not found or the
    /// fixed edge would break.
    fn kick(&mut self, rng: &mut ChaCha8Rng) -> Option<f64> {
        let count = self.tour.len();
        let mut places = self.places_near_each_other(rng)?;
        places.sort_unstable();
        // The longest stretch stays in place; the three other stretches follow it.
        let stretch = |k: usize| self.tour.steps(places[k], places[(k + 1) % 4]);
        let longest = (0..4).max_by_key(|&k| stretch(k))?;
        places.rotate_left((longest + 1) % 4);
        let start = places[0];
        let [_, a, b, c] = places.map(|place| self.tour.steps(start, place));

        let place = |offset: usize| (start + offset) % count;
        let at = |offset: usize| self.tour.order[place(offset)];
        let cuts = [0, a, b, c].map(|offset| (at(offset), at(offset + 1)));
        let links = [(0, b + 1), (c, a + 1), (b, 1), (a, c + 1)].map(|(x, y)| (at(x), at(y)));
        if cuts.iter().any(|&(x, y)| self.problem.is_fixed(x, y)) {
            return None;
        }
        let cost = |edges: [(usize, usize); 4]| -> f64 {
            edges.iter().map(|&(x, y)| self.problem.cost(x, y)).sum()
        };
        let saving = cost(cuts) - cost(links);
        let (third, second) = (c - b, c - a);
        for (low, high) in [(1, c), (1, third), (third + 1, second), (second + 1, c)] {
            self.tour.reverse_recorded(place(low), place(high));
        }
        for (x, y) in cuts {
            self.queue.push(x);
            self.queue.push(y);
        }
        Some(saving)
    }

    /// Returns the places of four different nodes: a random node, and the ends of random walks from neighbour
    /// to neighbour that begin there. `None` if the walks meet too often.
    fn places_near_each_other(&self, rng: &mut ChaCha8Rng) -> Option<[usize; 4]> {
        let centre = rng.random_range(0..self.tour.len());
        let mut places = [self.tour.place[centre]; 4];
        for found in 1..4 {
            let node = self.walk(centre, rng);
            places[found] = self.tour.place[node];
            if places[..found].contains(&places[found]) {
                return None;
            }
        }
        Some(places)
    }

    /// Returns the end of a random walk from neighbour to neighbour.
    fn walk(&self, from: usize, rng: &mut ChaCha8Rng) -> usize {
        let mut node = from;
        for _ in 0..KICK_WALK {
            let near = self.neighbours.of(node);
            let next = near[rng.random_range(0..near.len())].node;
            // The extra node of an open path is next to every node, so the walk must not pass it.
            if next < self.problem.costs.node_count() {
                node = next;
            }
        }
        node
    }
}

/// Returns a short order of all nodes that begins at the problem's start.
pub(super) fn solve(problem: &Problem, config: &TourConfig) -> Vec<usize> {
    let neighbours = Neighbours::nearest(problem);
    let order = greedy::tour(problem, &neighbours);
    let mut search = LocalSearch::new(problem, &neighbours, order);
    search.settle();
    search.tour.keep();

    let mut rng = ChaCha8Rng::seed_from_u64(config.seed);
    for _ in 0..config.kicks_per_node.saturating_mul(problem.node_count()) {
        if let Some(kicked) = search.kick(&mut rng) {
            if kicked + search.settle() >= 0.0 {
                search.tour.keep();
            } else {
                search.tour.undo();
            }
        }
    }
    from_start(problem, &search.tour)
}

/// Returns the nodes in tour order from the start; for an open path, away from the extra node.
fn from_start(problem: &Problem, tour: &ArrayTour) -> Vec<usize> {
    let away = problem
        .fixed_edge()
        .is_none_or(|(start, extra)| tour.previous(start) == extra);
    let step = |&node: &usize| {
        Some(if away {
            tour.next(node)
        } else {
            tour.previous(node)
        })
    };
    std::iter::successors(Some(problem.start), step)
        .take(problem.costs.node_count())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::{CostMatrix, Finish};
    use super::*;
    use proptest::prelude::*;

    fn cost(problem: &Problem, order: &[usize]) -> f64 {
        let after = order.iter().cycle().skip(1);
        order
            .iter()
            .zip(after)
            .map(|(&a, &b)| problem.cost(a, b))
            .sum()
    }

    proptest! {
        #[test]
        fn claimed_savings_are_real_and_can_be_taken_back(
            node_count in 13..80_usize,
            seed: u64,
            finish in prop_oneof![Just(Finish::AtStart), Just(Finish::Anywhere)],
        ) {
            let mut rng = ChaCha8Rng::seed_from_u64(seed);
            let costs =
                CostMatrix::from_fn(node_count, |_, _| rng.random_range(-1.0..10.0)).unwrap();
            let problem = Problem { costs: &costs, start: node_count / 2, finish };
            let neighbours = Neighbours::nearest(&problem);
            let order = greedy::tour(&problem, &neighbours);
            let mut search = LocalSearch::new(&problem, &neighbours, order);
            for _ in 0..20 {
                let before = search.tour.order.clone();
                let saved = search.kick(&mut rng).unwrap_or(0.0) + search.settle();
                let after = cost(&problem, &search.tour.order);
                prop_assert!((cost(&problem, &before) - after - saved).abs() < 1e-9);
                if let Some((a, b)) = problem.fixed_edge() {
                    prop_assert!(search.tour.next(a) == b || search.tour.previous(a) == b);
                }
                if saved < 0.0 {
                    search.tour.undo();
                    prop_assert_eq!(&search.tour.order, &before);
                }
                search.tour.keep();
            }
        }
    }
}
