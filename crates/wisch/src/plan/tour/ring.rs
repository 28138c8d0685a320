//! A tour in an array, changed by reversing stretches of it, in the array or only in the bookkeeping.

/// A closed tour in an array that records every change, so that changes can be undone.
pub(super) struct ArrayTour {
    /// Node at each place of the tour.
    pub(super) order: Vec<usize>,
    /// Place of each node.
    pub(super) place: Vec<usize>,
    /// First and last place of the stretches reversed since the last [`ArrayTour::keep`].
    reversed: Vec<(usize, usize)>,
}

impl ArrayTour {
    pub(super) fn new(order: Vec<usize>) -> Self {
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

    pub(super) fn len(&self) -> usize {
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

    pub(super) fn next(&self, node: usize) -> usize {
        self.order[self.next_place(self.place[node])]
    }

    pub(super) fn previous(&self, node: usize) -> usize {
        self.order[self.previous_place(self.place[node])]
    }

    /// Number of steps forward from one place to another.
    pub(super) fn steps(&self, from: usize, to: usize) -> usize {
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

    pub(super) fn reverse_recorded(&mut self, first: usize, last: usize) {
        self.reverse_places(first, last);
        self.reversed.push((first, last));
    }

    /// Reverses a stretch. Reversing the rest instead gives the same ring, read backwards, so the shorter of
    /// the two is reversed.
    pub(super) fn reverse(&mut self, reversal: Reversal) {
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

    /// Undoes everything since the last [`ArrayTour::keep`].
    pub(super) fn undo(&mut self) {
        while let Some((first, last)) = self.reversed.pop() {
            self.reverse_places(first, last);
        }
    }

    pub(super) fn keep(&mut self) {
        self.reversed.clear();
    }
}

/// A stretch of the tour to be reversed, from `first` to `last`, and the nodes beside it. Because it names
/// nodes, it means the same in either reading direction.
#[derive(Debug, Clone, Copy)]
pub(super) struct Reversal {
    pub(super) before: usize,
    pub(super) first: usize,
    pub(super) last: usize,
    pub(super) after: usize,
}

#[derive(Debug, Clone, Copy)]
pub(super) enum Direction {
    Forward,
    Backward,
}

/// The tour cut open at one edge and read as a path from `first` to `last`. Reversed stretches are only
/// recorded: `turned` lists first and last index of each, in order.
///
/// Looking up an index or a node costs time in proportion to the number of reversed stretches, not of nodes.
pub(super) struct OpenedTour {
    pub(super) first: usize,
    pub(super) last: usize,
    pub(super) direction: Direction,
    pub(super) turned: Vec<(usize, usize)>,
}

impl OpenedTour {
    pub(super) fn index(&self, tour: &ArrayTour, node: usize) -> usize {
        let (origin, place) = (tour.place[self.first], tour.place[node]);
        let index = match self.direction {
            Direction::Forward => tour.steps(origin, place),
            Direction::Backward => tour.steps(place, origin),
        };
        self.turned
            .iter()
            .fold(index, |index, &stretch| mirror(index, stretch))
    }

    pub(super) fn node(&self, tour: &ArrayTour, index: usize) -> usize {
        self.node_after(tour, index, self.turned.len())
    }

    /// Returns the node at an index after the first `turned_count` reversals.
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

    /// Returns the recorded turns as reversals of the closed tour.
    pub(super) fn reversals(&self, tour: &ArrayTour) -> Vec<Reversal> {
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
