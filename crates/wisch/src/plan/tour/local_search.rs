//! Iterated local search: repair a tour by sequential exchanges, kick it somewhere, keep what pays.
//!
//! An open path is a closed tour with one more node: it is next to the start by a fixed edge, and it
//! costs nothing to reach from anywhere. Leaving it out leaves a path with a free end.

use super::{CostMatrix, Finish, TourConfig, greedy};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::collections::VecDeque;

/// How many of its nearest others a node knows.
const NEIGHBOUR_COUNT: usize = 8;

/// How many of them are tried at each step of an exchange, and so how many steps it may have.
/// Wider and deeper searches gave shorter tours for equal kicks, but longer ones for equal time.
const BREADTH: [usize; 3] = [6, 4, 3];

/// Steps of the random walks that choose where to kick.
const KICK_WALK: usize = 15;

/// A saving below this share of the costs it was computed from may be rounding.
const RELATIVE_ROUNDING: f64 = 1e-14;

/// A closed tour to be found, of which one edge may be given.
pub(super) struct Problem<'a> {
    costs: &'a CostMatrix,
    start: usize,
    finish: Finish,
}

impl Problem<'_> {
    pub(super) fn node_count(&self) -> usize {
        match self.finish {
            Finish::AtStart => self.costs.node_count(),
            Finish::Anywhere => self.costs.node_count() + 1,
        }
    }

    pub(super) fn cost(&self, a: usize, b: usize) -> f64 {
        if a.max(b) < self.costs.node_count() {
            self.costs.cost(a, b)
        } else {
            0.0
        }
    }

    /// The edge that every tour must use.
    pub(super) fn fixed_edge(&self) -> Option<(usize, usize)> {
        match self.finish {
            Finish::AtStart => None,
            Finish::Anywhere => Some((self.start, self.costs.node_count())),
        }
    }

    fn is_fixed(&self, a: usize, b: usize) -> bool {
        self.fixed_edge()
            .is_some_and(|edge| edge == (a, b) || edge == (b, a))
    }
}

/// A node near another and the cost between them.
#[derive(Debug, Clone, Copy)]
pub(super) struct Neighbour {
    pub(super) node: usize,
    pub(super) cost: f64,
}

/// For each node its nearest others, nearest first.
pub(super) struct Neighbours {
    all: Vec<Neighbour>,
}

impl Neighbours {
    fn nearest(problem: &Problem) -> Self {
        let node_count = problem.node_count();
        let mut all = Vec::with_capacity(node_count * NEIGHBOUR_COUNT);
        let by_cost =
            |x: &Neighbour, y: &Neighbour| x.cost.total_cmp(&y.cost).then(x.node.cmp(&y.node));
        for from in 0..node_count {
            let mut others: Vec<Neighbour> = (0..node_count)
                .filter(|&node| node != from)
                .map(|node| Neighbour {
                    node,
                    cost: problem.cost(from, node),
                })
                .collect();
            others.select_nth_unstable_by(NEIGHBOUR_COUNT, by_cost);
            others.truncate(NEIGHBOUR_COUNT);
            others.sort_by(by_cost);
            all.extend(others);
        }
        Self { all }
    }

    pub(super) fn of(&self, node: usize) -> &[Neighbour] {
        &self.all[node * NEIGHBOUR_COUNT..][..NEIGHBOUR_COUNT]
    }
}

/// A closed tour in an array, with every change on record so that it can be taken back.
struct ArrayTour {
    /// Node at each place of the tour.
    order: Vec<usize>,
    /// Place of each node.
    place: Vec<usize>,
    /// First and last place of the stretches reversed since the last [`ArrayTour::keep`].
    reversed: Vec<(usize, usize)>,
}

impl ArrayTour {
    fn new(order: Vec<usize>) -> Self {
        let mut place = vec![0; order.len()];
        for (index, &node) in order.iter().enumerate() {
            place[node] = index;
        }
        Self {
            order,
            place,
            reversed: Vec::new(),
        }
    }

    fn len(&self) -> usize {
        self.order.len()
    }

    fn next_place(&self, place: usize) -> usize {
        if place + 1 == self.len() {
            0
        } else {
            place + 1
        }
    }

    fn previous_place(&self, place: usize) -> usize {
        place.checked_sub(1).unwrap_or(self.len() - 1)
    }

    fn next(&self, node: usize) -> usize {
        self.order[self.next_place(self.place[node])]
    }

    fn previous(&self, node: usize) -> usize {
        self.order[self.previous_place(self.place[node])]
    }

    /// How many steps lead forward from one place to another.
    fn steps(&self, from: usize, to: usize) -> usize {
        if to >= from {
            to - from
        } else {
            to + self.len() - from
        }
    }

    /// Reverses the stretch that leads forward from place `first` to place `last`.
    fn reverse_places(&mut self, first: usize, last: usize) {
        let (mut low, mut high) = (first, last);
        for _ in 0..self.steps(first, last).div_ceil(2) {
            self.order.swap(low, high);
            self.place[self.order[low]] = low;
            self.place[self.order[high]] = high;
            low = self.next_place(low);
            high = self.previous_place(high);
        }
    }

    fn reverse_recorded(&mut self, first: usize, last: usize) {
        self.reverse_places(first, last);
        self.reversed.push((first, last));
    }

    /// Turns a stretch round. Turning the rest instead gives the same ring, read backwards, so the
    /// shorter of the two is turned.
    fn reverse(&mut self, reversal: Reversal) {
        let Reversal {
            before,
            first,
            last,
            ..
        } = reversal;
        let (from, to) = if self.next(before) == first {
            (self.place[first], self.place[last])
        } else {
            (self.place[last], self.place[first])
        };
        if 2 * (self.steps(from, to) + 1) <= self.len() {
            self.reverse_recorded(from, to);
        } else {
            self.reverse_recorded(self.next_place(to), self.previous_place(from));
        }
    }

    /// Takes back everything since the last [`ArrayTour::keep`].
    fn take_back(&mut self) {
        while let Some((first, last)) = self.reversed.pop() {
            self.reverse_places(first, last);
        }
    }

    fn keep(&mut self) {
        self.reversed.clear();
    }
}

/// A stretch of the tour to be turned round, from `first` to `last`, and the nodes beside it. Given by
/// nodes, it means the same in either reading direction.
#[derive(Debug, Clone, Copy)]
struct Reversal {
    before: usize,
    first: usize,
    last: usize,
    after: usize,
}

/// Costs taken out of the tour and put into it so far.
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

    /// Whether it saves more than rounding could pretend; so no exchange can be undone by another
    /// for ever.
    fn pays(self) -> bool {
        self.amount > RELATIVE_ROUNDING * self.magnitude
    }
}

#[derive(Debug, Clone, Copy)]
enum Direction {
    Forward,
    Backward,
}

/// The tour cut open at one edge and read as a path from `first` to `last`, with stretches of it
/// turned round on paper only: `turned` lists first and last index of each, in order.
///
/// Asking for an index or a node costs time in proportion to the stretches turned, not to the nodes.
struct OpenedTour {
    first: usize,
    last: usize,
    direction: Direction,
    turned: Vec<(usize, usize)>,
}

impl OpenedTour {
    fn index(&self, tour: &ArrayTour, node: usize) -> usize {
        let (origin, place) = (tour.place[self.first], tour.place[node]);
        let index = match self.direction {
            Direction::Forward => tour.steps(origin, place),
            Direction::Backward => tour.steps(place, origin),
        };
        self.turned
            .iter()
            .fold(index, |index, &stretch| mirror(index, stretch))
    }

    fn node(&self, tour: &ArrayTour, index: usize) -> usize {
        self.node_after(tour, index, self.turned.len())
    }

    /// The node at an index once the first `turned_count` stretches are turned.
    fn node_after(&self, tour: &ArrayTour, index: usize, turned_count: usize) -> usize {
        let index = self.turned[..turned_count]
            .iter()
            .rev()
            .fold(index, |index, &stretch| mirror(index, stretch));
        let origin = tour.place[self.first];
        let place = match self.direction {
            Direction::Forward => origin + index,
            Direction::Backward => origin + tour.len() - index,
        };
        tour.order[if place >= tour.len() {
            place - tour.len()
        } else {
            place
        }]
    }

    /// The turns so far as reversals of the closed tour.
    fn reversals(&self, tour: &ArrayTour) -> Vec<Reversal> {
        let mut reversals = Vec::with_capacity(self.turned.len());
        for (count, &(low, high)) in self.turned.iter().enumerate() {
            if low < high {
                let before = low.checked_sub(1).unwrap_or(tour.len() - 1);
                reversals.push(Reversal {
                    before: self.node_after(tour, before, count),
                    first: self.node_after(tour, low, count),
                    last: self.node_after(tour, high, count),
                    after: self.node_after(tour, high + 1, count),
                });
            }
        }
        reversals
    }
}

fn mirror(index: usize, (low, high): (usize, usize)) -> usize {
    if (low..=high).contains(&index) {
        low + high - index
    } else {
        index
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

impl LocalSearch<'_> {
    /// Improves round the queued nodes until no exchange pays; the saving is ≥ 0.
    fn settle(&mut self) -> f64 {
        let mut saved = 0.0;
        while let Some(node) = self.queue.pop() {
            while let Some(saving) = self.improve_at(node) {
                saved += saving;
            }
        }
        saved
    }

    /// Makes the first exchange found that pays and removes an edge of `node`; its saving.
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

    /// Links the path's first node to a near one and turns the stretch between, so that the path has
    /// a new first node; deeper if closing the path there does not pay.
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
            if !linked.pays() {
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
            if closed.pays() {
                return Some(closed.amount);
            }
            if let Some(saving) = self.exchange_by_turning(opened, cut, depth + 1) {
                return Some(saving);
            }
            opened.turned.pop();
        }
        None
    }

    /// Links the path's first node to a near one behind a stretch, which so becomes a ring, and
    /// opens the ring elsewhere to link it to the rest: moves a segment of any length.
    fn exchange_by_moving(&self, opened: &mut OpenedTour, removed: Saving) -> Option<f64> {
        for near in self.neighbours.of(opened.first).iter().take(BREADTH[0]) {
            let linked = removed.adding(near.cost);
            if !linked.pays() {
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
                if !joined.pays() {
                    break;
                }
                let split = opened.index(&self.tour, joint.node);
                if split >= ring_end {
                    continue;
                }
                // Opened behind the joint, the two parts of the ring change places; before it,
                // each is turned round where it is (and a stretch of one node fills the array).
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
                    if closed.pays() {
                        opened.turned.extend(turned);
                        return Some(closed.amount);
                    }
                }
            }
        }
        None
    }

    /// Cuts the tour behind four nodes close to each other and joins the stretches in the opposite
    /// order without turning any of them round: a double bridge (Martin, Otto and Felten, 1991), which
    /// the exchanges above cannot simply undo. The saving is mostly negative; `None` if four
    /// different nodes were not found or the fixed edge would break.
    fn kick(&mut self, rng: &mut ChaCha8Rng) -> Option<f64> {
        let count = self.tour.len();
        let mut places = self.places_near_each_other(rng)?;
        places.sort_unstable();
        // The longest stretch stays where it is; the other three follow it.
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

    /// Places of four different nodes: one anywhere and the ends of random walks from neighbour to
    /// neighbour that begin there. `None` if the walks meet too often.
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

    /// Where a random walk from neighbour to neighbour ends.
    fn walk(&self, from: usize, rng: &mut ChaCha8Rng) -> usize {
        let mut node = from;
        for _ in 0..KICK_WALK {
            let near = self.neighbours.of(node);
            let next = near[rng.random_range(0..near.len())].node;
            // The extra node of an open path is next to everything: it would be a way to anywhere.
            if next < self.problem.costs.node_count() {
                node = next;
            }
        }
        node
    }
}

/// A short order of all nodes that begins at `start`; more nodes than [`NEIGHBOUR_COUNT`].
pub(super) fn solve(
    costs: &CostMatrix,
    start: usize,
    finish: Finish,
    config: &TourConfig,
) -> Vec<usize> {
    let problem = Problem {
        costs,
        start,
        finish,
    };
    let node_count = problem.node_count();
    let neighbours = Neighbours::nearest(&problem);
    let order = greedy::tour(&problem, &neighbours);
    let mut search = LocalSearch {
        queue: Queue {
            nodes: order.iter().copied().collect(),
            waiting: vec![true; node_count],
        },
        tour: ArrayTour::new(order),
        problem: &problem,
        neighbours: &neighbours,
    };
    search.settle();
    search.tour.keep();

    let mut rng = ChaCha8Rng::seed_from_u64(config.seed);
    for _ in 0..config.kicks_per_node.saturating_mul(node_count) {
        if let Some(kicked) = search.kick(&mut rng) {
            if kicked + search.settle() >= 0.0 {
                search.tour.keep();
            } else {
                search.tour.take_back();
            }
        }
    }
    from_start(&problem, &search.tour)
}

/// The nodes in tour order from the start; for an open path, away from the extra node.
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
