//! Optimal orders of few nodes by dynamic programming over subsets (Held and Karp, 1962).

use super::{CostMatrix, Finish};

/// The cheapest path that visits a subset and ends at one of its nodes.
#[derive(Debug, Clone, Copy)]
struct Arrival {
    cost: f64,
    previous: usize,
}

/// Returns an optimal order of all nodes that begins at `start`. Needs at least one node; time grows as 2ⁿ n².
pub(super) fn solve(costs: &CostMatrix, start: usize, finish: Finish) -> Vec<usize> {
    let others: Vec<usize> = (0..costs.node_count()).filter(|&i| i != start).collect();
    let m = others.len();
    if m == 0 {
        return vec![start];
    }
    let unreached = Arrival {
        cost: f64::INFINITY,
        previous: 0,
    };
    // arrivals[subset * m + last]: bit k of `subset` stands for `others[k]`.
    let mut arrivals = vec![unreached; m << m];
    for last in 0..m {
        arrivals[(1 << last) * m + last].cost = costs.cost(start, others[last]);
    }
    for subset in 1..1_usize << m {
        for last in (0..m).filter(|last| subset & (1 << last) != 0) {
            let here = arrivals[subset * m + last].cost;
            for next in (0..m).filter(|next| subset & (1 << next) == 0) {
                let there = &mut arrivals[(subset | 1 << next) * m + next];
                let cost = here + costs.cost(others[last], others[next]);
                if cost < there.cost {
                    *there = Arrival {
                        cost,
                        previous: last,
                    };
                }
            }
        }
    }

    let everyone = (1 << m) - 1;
    let total = |last: usize| {
        arrivals[everyone * m + last].cost
            + match finish {
                Finish::AtStart => costs.cost(others[last], start),
                Finish::Anywhere => 0.0,
            }
    };
    let mut last = (1..m).fold(0, |best, k| if total(k) < total(best) { k } else { best });
    let mut subset = everyone;
    let mut order = Vec::with_capacity(m + 1);
    while subset != 0 {
        order.push(others[last]);
        let previous = arrivals[subset * m + last].previous;
        subset &= !(1 << last);
        last = previous;
    }
    order.push(start);
    order.reverse();
    order
}
