//! Aggregates over all solutions of a block.

use super::expression::{Binary, evaluate_binary};
use super::goal::{Aggregate, Block};
use super::solver::{Flow, Solver, Stop};
use super::value::{JoinValue, Pattern, standard_order};
use crate::ask::term::Term;
use std::cmp::Ordering;

/// Largest number of terms that are kept for a list or for means; more are left to the engine.
const MOST_TERMS: usize = 2_000_000;

impl Solver<'_> {
    /// Returns the result; `None` without a result, such as the maximum of no solutions.
    pub(super) fn compute_aggregate(
        &mut self,
        block: &Block,
        aggregate: &Aggregate,
    ) -> Result<Option<JoinValue>, Stop> {
        match aggregate {
            Aggregate::Count => {
                let mut count = 0;
                self.solve(block, &mut |_| {
                    count += 1;
                    Ok(Flow::Continue)
                })?;
                Ok(Some(JoinValue::Integer(count)))
            }
            Aggregate::All(pattern) => {
                let all = self.instances_of(block, pattern)?;
                Ok(Some(JoinValue::Term(Term::List(all))))
            }
            Aggregate::Set(pattern) => {
                let mut all = self.instances_of(block, pattern)?;
                sort(&mut all, |term| term)?;
                all.dedup();
                Ok(Some(JoinValue::Term(Term::List(all))))
            }
            Aggregate::Sum(of) => {
                let (sum, _) = self.total(block, of)?;
                Ok(Some(sum))
            }
            Aggregate::Mean(of) => match self.total(block, of)? {
                (_, 0) => Ok(None),
                (sum, count) => quotient(sum, count).map(Some),
            },
            Aggregate::Extreme {
                is_max,
                of,
                witness,
            } => {
                let mut best: Option<(JoinValue, Option<Term>)> = None;
                self.solve(block, &mut |solver| {
                    let value = solver.evaluate(of)?;
                    let number = value.as_number().ok_or(Stop::Declined)?;
                    let before = best.as_ref().and_then(|(best, _)| best.as_number());
                    let is_better = match before {
                        None => true,
                        Some(before) if *is_max => number > before,
                        Some(before) => number < before,
                    };
                    if is_better {
                        let witness = witness.as_ref().map(|pattern| solver.term(pattern));
                        best = Some((value, witness.transpose()?));
                    }
                    Ok(Flow::Continue)
                })?;
                let catalogue = &self.known.catalogue;
                Ok(best.map(|(value, witness)| match witness {
                    None => value,
                    Some(witness) => {
                        let name = if *is_max { "max" } else { "min" };
                        let pair = [value.to_term(catalogue), witness];
                        JoinValue::Term(Term::compound(name, pair))
                    }
                }))
            }
        }
    }

    /// Returns key, mean and count of each group of solutions, sorted by key.
    pub(super) fn means(
        &mut self,
        block: &Block,
        key: &Pattern,
        number: &Pattern,
    ) -> Result<Vec<[JoinValue; 3]>, Stop> {
        let mut all: Vec<(Term, JoinValue)> = Vec::new();
        self.solve(block, &mut |solver| {
            if all.len() == MOST_TERMS {
                return Err(Stop::Declined);
            }
            let number = solver.instance(number).ok_or(Stop::Declined)?;
            all.push((solver.term(key)?, number));
            Ok(Flow::Continue)
        })?;
        sort(&mut all, |(key, _)| key)?;
        let groups = all.chunk_by(|a, b| a.0 == b.0).map(|group| {
            let mut sum = JoinValue::Integer(0);
            for (_, number) in group {
                sum = evaluate_binary(Binary::Plus, sum, number.clone()).ok_or(Stop::Declined)?;
            }
            let count = i64::try_from(group.len()).map_err(|_| Stop::Declined)?;
            let mean = quotient(sum, count)?;
            Ok([
                JoinValue::from_term(group[0].0.clone()),
                mean,
                JoinValue::Integer(count),
            ])
        });
        groups.collect()
    }

    fn instances_of(&mut self, block: &Block, pattern: &Pattern) -> Result<Vec<Term>, Stop> {
        let mut all = Vec::new();
        self.solve(block, &mut |solver| {
            if all.len() == MOST_TERMS {
                return Err(Stop::Declined);
            }
            all.push(solver.term(pattern)?);
            Ok(Flow::Continue)
        })?;
        Ok(all)
    }

    fn total(
        &mut self,
        block: &Block,
        of: &super::expression::Expression,
    ) -> Result<(JoinValue, i64), Stop> {
        let (mut sum, mut count) = (JoinValue::Integer(0), 0);
        self.solve(block, &mut |solver| {
            let value = solver.evaluate(of)?;
            let before = std::mem::replace(&mut sum, JoinValue::Integer(0));
            sum = evaluate_binary(Binary::Plus, before, value).ok_or(Stop::Declined)?;
            count += 1;
            Ok(Flow::Continue)
        })?;
        Ok((sum, count))
    }
}

fn quotient(sum: JoinValue, count: i64) -> Result<JoinValue, Stop> {
    evaluate_binary(Binary::Over, sum, JoinValue::Integer(count)).ok_or(Stop::Declined)
}

/// Sorts by the standard order of a key; the sort is stable.
fn sort<T>(all: &mut [T], key: impl Fn(&T) -> &Term) -> Result<(), Stop> {
    let mut is_agreed = true;
    all.sort_by(|a, b| {
        standard_order(key(a), key(b)).unwrap_or_else(|| {
            is_agreed = false;
            Ordering::Equal
        })
    });
    is_agreed.then_some(()).ok_or(Stop::Declined)
}
