//! Order of goals: the one that leaves the fewest candidates first.

use super::goal::{Block, Goal, GoalSource, Side};
use super::value::Pattern;
use crate::ask::intervals::Relation;
use crate::catalogue::Catalogue;
use std::collections::HashSet;

/// Factor by which another order must reduce the candidates to be chosen [1].
const MIN_IMPROVEMENT: f64 = 2.0;
/// Estimated number of parts of a whole.
const PARTS: f64 = 8.0;
/// Estimated number of events that overlap another event.
const AT_A_TIME: f64 = 8.0;

/// Returns a block of goals in the best order. Goals that look facts up may move; other goals stay behind those that
/// bind their variables.
pub fn order_goals(
    goals: Vec<Goal>,
    is_bound: impl Fn(usize) -> bool,
    catalogue: &Catalogue,
) -> Block {
    let variables: Vec<Vec<usize>> = goals.iter().map(Goal::variables).collect();
    let mut binds: Vec<usize> = variables.concat();
    binds.sort_unstable();
    binds.dedup();
    binds.retain(|variable| !is_bound(*variable));
    let stays = goals
        .iter()
        .any(|goal| matches!(goal, Goal::Either(_) | Goal::Once(_)));
    let places: Vec<usize> = (0..goals.len()).collect();
    let cost = |order: &[usize]| cost(order, &goals, &variables, &is_bound, catalogue);
    let better = (!stays).then(|| greedy(&goals, &variables, &is_bound, catalogue));
    let better =
        better.filter(|order| *order != places && cost(order) * MIN_IMPROVEMENT < cost(&places));
    match better {
        None => Block {
            goals,
            stood: Vec::new(),
            binds,
        },
        Some(order) => {
            let mut left: Vec<Option<Goal>> = goals.into_iter().map(Some).collect();
            let goals = order.iter().filter_map(|place| left[*place].take());
            Block {
                goals: goals.collect(),
                stood: order,
                binds,
            }
        }
    }
}

fn greedy(
    goals: &[Goal],
    variables: &[Vec<usize>],
    is_bound: &impl Fn(usize) -> bool,
    catalogue: &Catalogue,
) -> Vec<usize> {
    let shares = |a: usize, b: usize| variables[a].iter().any(|v| variables[b].contains(v));
    let mut bound: HashSet<usize> = HashSet::new();
    let mut order: Vec<usize> = Vec::new();
    while order.len() < goals.len() {
        let is_free = |place: &usize| {
            let before = (0..*place).filter(|other| !order.contains(other));
            let mut before = before.filter(|other| shares(*place, *other));
            before.all(|other| goals[*place].is_fact() && goals[other].is_fact())
        };
        let left = (0..goals.len()).filter(|place| !order.contains(place));
        let costs = left.filter(is_free).map(|place| {
            let known = |variable: usize| is_bound(variable) || bound.contains(&variable);
            (fan_out(&goals[place], &known, catalogue), place)
        });
        let Some((_, next)) = costs.min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1))) else {
            break;
        };
        bound.extend(&variables[next]);
        order.push(next);
    }
    order
}

/// Returns the estimated number of candidates of an order.
fn cost(
    order: &[usize],
    goals: &[Goal],
    variables: &[Vec<usize>],
    is_bound: &impl Fn(usize) -> bool,
    catalogue: &Catalogue,
) -> f64 {
    let mut bound: HashSet<usize> = HashSet::new();
    let (mut rows, mut sum) = (1.0, 0.0);
    for &place in order {
        let known = |variable: usize| is_bound(variable) || bound.contains(&variable);
        rows *= fan_out(&goals[place], &known, catalogue);
        sum += rows;
        bound.extend(&variables[place]);
    }
    sum
}

/// Returns the estimated number of a goal's solutions, given which variables are known.
fn fan_out(goal: &Goal, known: &impl Fn(usize) -> bool, catalogue: &Catalogue) -> f64 {
    let is_known = |pattern: &Pattern| {
        let mut variables = Vec::new();
        pattern.variables(&mut variables);
        variables.into_iter().all(known)
    };
    let all = len(catalogue.len());
    match goal {
        Goal::Class { thing, .. } if is_known(thing) => 0.5,
        Goal::Class { classes, .. } => {
            let members = classes
                .iter()
                .map(|class| catalogue.individuals_of_class(class).len());
            len(members.sum())
        }
        Goal::Statement {
            subject,
            object,
            sources,
        } => {
            let of_each =
                sources.iter().map(
                    |source| match (source, is_known(subject), is_known(object)) {
                        (_, true, true) => 0.5,
                        (GoalSource::Parts, true, false) => PARTS,
                        (GoalSource::Parts, false, true) => 1.0,
                        (GoalSource::Parts, false, false) => all,
                        (GoalSource::Relations(property), false, is_object) => {
                            let relations = len(catalogue.relations(property).len());
                            if is_object {
                                relations / 10.0
                            } else {
                                relations
                            }
                        }
                        (GoalSource::Values { property, .. }, false, is_object) => {
                            let values =
                                catalogue.numbers(property).len() + catalogue.texts(property).len();
                            if is_object {
                                len(values) / 10.0
                            } else {
                                len(values)
                            }
                        }
                        (_, true, false) => 1.0,
                    },
                );
            let of_each: Vec<f64> = of_each.collect();
            // A subject has its value in only one of the sources.
            if is_known(subject) {
                of_each.into_iter().fold(0.0, f64::max)
            } else {
                of_each.into_iter().sum()
            }
        }
        Goal::Compared {
            thing, properties, ..
        } => {
            let values = properties
                .iter()
                .map(|property| catalogue.numbers(property).len());
            if is_known(thing) {
                0.5
            } else {
                len(values.sum()) / 3.0
            }
        }
        Goal::Timed { event, start, end } => match is_known(event) {
            true => 1.0,
            false if is_known(start) && is_known(end) => 2.0,
            false => all,
        },
        Goal::Related {
            relation,
            first,
            second,
        } => {
            let is_known = |side: &Side| match side {
                Side::Event(event) => is_known(event),
                Side::Times(..) => true,
            };
            let found = match relation {
                Relation::Before | Relation::After => all / 2.0,
                _ => AT_A_TIME,
            };
            match (is_known(first), is_known(second)) {
                (true, true) => 0.5,
                (false, false) => all * found,
                _ => found,
            }
        }
        Goal::PartBelow { .. } => PARTS,
        Goal::Comparison(..) | Goal::Number(_) | Goal::Not(_) => 0.5,
        Goal::Either(_) | Goal::MeanByKey { .. } => 2.0,
        Goal::Telemetry { .. } => 1.5,
        _ => 1.0,
    }
}

#[allow(clippy::cast_precision_loss, reason = "counts are far below 2^53")]
fn len(count: usize) -> f64 {
    count as f64
}
