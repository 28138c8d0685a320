//! Facts of the catalogue, found from any known argument.

use super::expression::{Comparison, Expression};
use super::goal::{GoalSource, Side};
use super::indices::Children;
use super::solver::{Flow, Next, Solver, Stop};
use super::value::{JoinValue, Pattern};
use crate::ask::intervals::Relation;
use crate::ask::term::Term;
use crate::catalogue::{CatalogueNode, IndividualId, entries};
use std::slice;

/// Returns early if no more solutions are wanted.
macro_rules! go_on {
    ($flow:expr) => {
        if $flow? == Flow::Stop {
            return Ok(Flow::Stop);
        }
    };
}

/// Returns the sort key of a solution; outer positions count most.
fn key(source: usize, place: usize) -> u64 {
    (source as u64) << 40 | place as u64
}

impl From<CatalogueNode> for JoinValue {
    fn from(node: CatalogueNode) -> Self {
        match node {
            CatalogueNode::Individual(id) => Self::Individual(id),
            CatalogueNode::Shared(number) => Self::Shared(number),
        }
    }
}

impl<'s> Solver<'s> {
    pub(super) fn class(
        &mut self,
        thing: &Pattern,
        classes: &[String],
        next: Next<'_, 's>,
    ) -> Result<Flow, Stop> {
        let known = self.known;
        let place = |class: &str| classes.iter().position(|of| of == class);
        if let Some(found) = self.thing(thing)? {
            let key_of = match &found {
                JoinValue::Individual(id) => {
                    place(known.catalogue.class(*id)).map(|class| key(class, *id as usize))
                }
                other => {
                    let name = other.to_term(&known.catalogue);
                    let class = name
                        .as_atom()
                        .and_then(|name| known.names.class_of_shared(name));
                    class
                        .and_then(|class| place(&class))
                        .map(|class| key(class, usize::MAX >> 32))
                }
            };
            return match key_of {
                Some(key) => next(self, key),
                None => Ok(Flow::Continue),
            };
        }
        for (number, class) in classes.iter().enumerate() {
            for &id in known.catalogue.individuals_of_class(class) {
                let member = JoinValue::Individual(id);
                go_on!(self.candidate(&[(thing, member)], key(number, id as usize), next));
            }
            for name in known.names.share_names(class) {
                let member = self.find_thing(name);
                go_on!(self.candidate(&[(thing, member)], key(number, usize::MAX >> 32), next));
            }
        }
        Ok(Flow::Continue)
    }

    pub(super) fn statement(
        &mut self,
        subject: &Pattern,
        object: &Pattern,
        sources: &[GoalSource],
        next: Next<'_, 's>,
    ) -> Result<Flow, Stop> {
        let of = match self.individual(subject)? {
            Ok(id) => Some(id),
            Err(true) => None,
            // Shared things have no statements.
            Err(false) => return Ok(Flow::Continue),
        };
        for (number, source) in sources.iter().enumerate() {
            go_on!(match source {
                GoalSource::Parts => self.parts(number, (subject, of), object, next),
                GoalSource::Relations(property) => {
                    self.relations(number, property, (subject, of), object, next)
                }
                GoalSource::Values {
                    property,
                    is_lenient,
                } => self.values((number, property), *is_lenient, (subject, of), object, next),
            });
        }
        Ok(Flow::Continue)
    }

    fn parts(
        &mut self,
        source: usize,
        (whole, of): (&Pattern, Option<IndividualId>),
        part: &Pattern,
        next: Next<'_, 's>,
    ) -> Result<Flow, Stop> {
        let catalogue = &self.known.catalogue;
        let parts = match (self.individual(part)?, of) {
            (Ok(part), _) => part..part + 1,
            (Err(false), _) => return Ok(Flow::Continue),
            (Err(true), Some(of)) => {
                let children = self.indices.children(catalogue);
                for &id in children.parts(of) {
                    let pair = [(part, JoinValue::Individual(id))];
                    go_on!(self.candidate(&pair, key(source, id as usize), next));
                }
                return Ok(Flow::Continue);
            }
            (Err(true), None) => 0..u32::try_from(catalogue.len()).unwrap_or(u32::MAX),
        };
        for id in parts {
            let Some(parent) = catalogue.parent(id) else {
                continue;
            };
            if of.is_none_or(|of| of == parent) {
                let pairs = [
                    (whole, JoinValue::Individual(parent)),
                    (part, JoinValue::Individual(id)),
                ];
                go_on!(self.candidate(&pairs, key(source, id as usize), next));
            }
        }
        Ok(Flow::Continue)
    }

    fn relations(
        &mut self,
        source: usize,
        property: &str,
        (subject, of): (&Pattern, Option<IndividualId>),
        object: &Pattern,
        next: Next<'_, 's>,
    ) -> Result<Flow, Stop> {
        let catalogue = &self.known.catalogue;
        let column = catalogue.relations(property);
        let wanted = match self.instance(object) {
            Some(JoinValue::Integer(_) | JoinValue::Float(_)) => return Ok(Flow::Continue),
            Some(JoinValue::Term(term)) => match super::compile::object_of(self.known, &term) {
                JoinValue::Term(_) => return Ok(Flow::Continue),
                thing => Some(thing),
            },
            other => other,
        };
        if let (None, Some(wanted)) = (of, &wanted) {
            let node = match wanted {
                JoinValue::Individual(id) => CatalogueNode::Individual(*id),
                JoinValue::Shared(number) => CatalogueNode::Shared(*number),
                _ => return Ok(Flow::Continue),
            };
            let index = self.indices.relations_by_object(catalogue, property);
            for &place in index.get(&node).map_or(&[][..], Vec::as_slice) {
                let (id, _) = column[place as usize];
                let pairs = [(subject, JoinValue::Individual(id))];
                go_on!(self.candidate(&pairs, key(source, place as usize), next));
            }
            return Ok(Flow::Continue);
        }
        let (first, some) = part_of(column, of);
        for (place, (id, node)) in (first..).zip(some) {
            let value = JoinValue::from(*node);
            if wanted.as_ref().is_some_and(|wanted| *wanted != value) {
                continue;
            }
            let pairs = [(subject, JoinValue::Individual(*id)), (object, value)];
            go_on!(self.candidate(&pairs, key(source, place), next));
        }
        Ok(Flow::Continue)
    }

    fn values(
        &mut self,
        (source, property): (usize, &str),
        is_lenient: bool,
        (subject, of): (&Pattern, Option<IndividualId>),
        object: &Pattern,
        next: Next<'_, 's>,
    ) -> Result<Flow, Stop> {
        let catalogue = &self.known.catalogue;
        let wanted = self.instance(object);
        let number = wanted.as_ref().and_then(JoinValue::as_number);
        let numbers = catalogue.numbers(property);
        let (first, some) = part_of(numbers, of);
        for (place, (id, value)) in (first..).zip(some) {
            let subject = (subject, JoinValue::Individual(*id));
            let key = key(source, place);
            #[allow(clippy::float_cmp, reason = "the query asks for exact equality")]
            let flow = match number {
                Some(number) if is_lenient => {
                    if number != *value {
                        continue;
                    }
                    self.candidate(slice::from_ref(&subject), key, next)
                }
                _ => self.candidate(&[subject, (object, JoinValue::Float(*value))], key, next),
            };
            go_on!(flow);
        }
        if number.is_some() {
            return Ok(Flow::Continue);
        }
        let (first, some) = part_of(catalogue.texts(property), of);
        for (place, (id, text)) in (first + numbers.len()..).zip(some) {
            if let Some(JoinValue::Term(Term::Atom(wanted))) = &wanted
                && wanted != text
            {
                self.tick()?;
                continue;
            }
            let text = JoinValue::Term(Term::atom(text));
            let pairs = [(subject, JoinValue::Individual(*id)), (object, text)];
            go_on!(self.candidate(&pairs, key(source, place), next));
        }
        Ok(Flow::Continue)
    }

    pub(super) fn compared(
        &mut self,
        thing: &Pattern,
        properties: &[String],
        comparison: Comparison,
        bound: &Expression,
        next: Next<'_, 's>,
    ) -> Result<Flow, Stop> {
        let catalogue = &self.known.catalogue;
        let bound = self.number(bound)?;
        let of = match self.individual(thing)? {
            Ok(id) => Some(id),
            Err(true) => None,
            Err(false) => return Ok(Flow::Continue),
        };
        for (source, property) in properties.iter().enumerate() {
            let (first, some) = part_of(catalogue.numbers(property), of);
            for (place, (id, value)) in (first..).zip(some) {
                if comparison.holds(*value, bound) {
                    let pair = [(thing, JoinValue::Individual(*id))];
                    go_on!(self.candidate(&pair, key(source, place), next));
                } else {
                    self.tick()?;
                }
            }
        }
        Ok(Flow::Continue)
    }

    pub(super) fn timed(
        &mut self,
        event: &Pattern,
        [start, end]: [&Pattern; 2],
        next: Next<'_, 's>,
    ) -> Result<Flow, Stop> {
        let catalogue = &self.known.catalogue;
        let events: Box<dyn Iterator<Item = IndividualId>> = match self.individual(event)? {
            Ok(id) => Box::new(std::iter::once(id)),
            Err(false) => return Ok(Flow::Continue),
            Err(true) => {
                let times = [start, end].map(|pattern| self.instance(pattern));
                match times {
                    [Some(start), Some(end)] => {
                        let (Some(start), Some(end)) = (start.as_number(), end.as_number()) else {
                            return Ok(Flow::Continue);
                        };
                        let timeline = self.indices.timeline(catalogue);
                        let found = timeline
                            .intervals
                            .find_related(Relation::Equals, [start, end]);
                        // As the engine does: the answer repeats the given times, 1 or 1.0.
                        for id in found {
                            let pair = [(event, JoinValue::Individual(id))];
                            go_on!(self.candidate(&pair, u64::from(id), next));
                        }
                        return Ok(Flow::Continue);
                    }
                    _ => Box::new(0..u32::try_from(catalogue.len()).unwrap_or(u32::MAX)),
                }
            }
        };
        for id in events {
            let Some([from, to]) = catalogue.interval(id) else {
                continue;
            };
            // A given time need not have the stored form: 1 equals 1.0.
            let mut pairs = vec![(event, JoinValue::Individual(id))];
            let mut is_then = true;
            for (pattern, time) in [(start, from), (end, to)] {
                match self.instance(pattern).and_then(|value| value.as_number()) {
                    #[allow(clippy::float_cmp, reason = "the query asks for exact equality")]
                    Some(asked) => is_then &= asked == time,
                    None => pairs.push((pattern, JoinValue::Float(time))),
                }
            }
            if is_then {
                go_on!(self.candidate(&pairs, u64::from(id), next));
            }
        }
        Ok(Flow::Continue)
    }

    pub(super) fn related(
        &mut self,
        relation: Relation,
        first: &Side,
        second: &Side,
        next: Next<'_, 's>,
    ) -> Result<Flow, Stop> {
        let (Some(one), Some(other)) = (self.side(first)?, self.side(second)?) else {
            return Ok(Flow::Continue);
        };
        let timeline = self.indices.timeline(&self.known.catalogue);
        let place = |id: Option<IndividualId>| id.map_or(0, |id| u64::from(timeline.place(id)));
        let key = |first, second| place(second) << 32 | place(first);
        match (one, other) {
            (Known::Times(a, first), Known::Times(b, second)) => {
                let is_other = first.is_none() || first != second;
                match is_other && relation.holds(a, b) {
                    true => next(self, key(first, second)),
                    false => Ok(Flow::Continue),
                }
            }
            (Known::Nothing(first), Known::Times(to, second)) => {
                for id in timeline.intervals.find_related(relation, to) {
                    if Some(id) != second {
                        let pair = [(first, JoinValue::Individual(id))];
                        go_on!(self.candidate(&pair, key(Some(id), second), next));
                    }
                }
                Ok(Flow::Continue)
            }
            (Known::Times(to, first), Known::Nothing(second)) => {
                for id in timeline.intervals.find_related(relation.inverse(), to) {
                    if Some(id) != first {
                        let pair = [(second, JoinValue::Individual(id))];
                        go_on!(self.candidate(&pair, key(first, Some(id)), next));
                    }
                }
                Ok(Flow::Continue)
            }
            (Known::Nothing(first), Known::Nothing(second)) => {
                for place in 0..timeline.intervals.len() {
                    let (to, of_second) = timeline.intervals.entry(place);
                    for id in timeline.intervals.find_related(relation, to) {
                        if id == of_second {
                            continue;
                        }
                        let pairs = [
                            (first, JoinValue::Individual(id)),
                            (second, JoinValue::Individual(of_second)),
                        ];
                        go_on!(self.candidate(&pairs, key(Some(id), Some(of_second)), next));
                    }
                }
                Ok(Flow::Continue)
            }
        }
    }

    /// Returns the known side of a relation; `None` if it has no time.
    fn side<'p>(&self, side: &'p Side) -> Result<Option<Known<'p>>, Stop> {
        Ok(match side {
            Side::Event(event) => match self.individual(event)? {
                Ok(id) => {
                    (self.known.catalogue.interval(id)).map(|times| Known::Times(times, Some(id)))
                }
                Err(true) => Some(Known::Nothing(event)),
                Err(false) => None,
            },
            Side::Times(start, end) => {
                let times = [start, end].map(|pattern| self.instance(pattern)?.as_number());
                let [Some(start), Some(end)] = times else {
                    return Err(Stop::Declined);
                };
                // The engine reports times in the wrong order.
                if end < start {
                    return Err(Stop::Declined);
                }
                Some(Known::Times([start, end], None))
            }
        })
    }

    pub(super) fn part_below(
        &mut self,
        whole: &Pattern,
        part: &Pattern,
        classes: &[String],
        next: Next<'_, 's>,
    ) -> Result<Flow, Stop> {
        let Ok(whole) = self.individual(whole)? else {
            return Ok(Flow::Continue);
        };
        let mut below = Vec::new();
        let children = self.indices.children(&self.known.catalogue);
        parts_below(&children, whole, &mut below);
        let known = self.known;
        for (place, id) in (0..).zip(below) {
            if classes
                .iter()
                .any(|class| class == known.catalogue.class(id))
            {
                go_on!(self.candidate(&[(part, JoinValue::Individual(id))], place, next));
            }
        }
        Ok(Flow::Continue)
    }

    pub(super) fn above(
        &mut self,
        part: &Pattern,
        whole: &Pattern,
        classes: &[String],
        next: Next<'_, 's>,
    ) -> Result<Flow, Stop> {
        let catalogue = &self.known.catalogue;
        let mut at = self.individual(part)?.ok();
        while let Some(parent) = at.and_then(|id| catalogue.parent(id)) {
            if classes.iter().any(|class| class == catalogue.class(parent)) {
                return self.candidate(&[(whole, JoinValue::Individual(parent))], 0, next);
            }
            at = Some(parent);
        }
        Ok(Flow::Continue)
    }

    pub(super) fn last_episode(
        &mut self,
        episode: &Pattern,
        time: &Pattern,
        next: Next<'_, 's>,
    ) -> Result<Flow, Stop> {
        let Some(last) = self.known.last_episode() else {
            return Ok(Flow::Continue);
        };
        let end = JoinValue::Float(last.interval[1]);
        let pairs = [(episode, JoinValue::Individual(last.first)), (time, end)];
        self.candidate(&pairs, 0, next)
    }

    pub(super) fn telemetry_statistic(
        &mut self,
        [episode, channel, when, statistic, value]: [&Pattern; 5],
        next: Next<'_, 's>,
    ) -> Result<Flow, Stop> {
        let known = self.known;
        let (start, end, of) = match self.instance(when).ok_or(Stop::Declined)? {
            JoinValue::Term(Term::List(times)) => {
                let [start, end] = times.as_slice() else {
                    return Err(Stop::Declined);
                };
                let of = match self.thing(episode)? {
                    Some(episode) => episode.to_term(&known.catalogue),
                    None => Term::atom("any"),
                };
                (start.clone(), end.clone(), of)
            }
            _ => {
                let Ok(event) = self.individual(when)? else {
                    return Err(Stop::Declined);
                };
                let [start, end] = known.catalogue.interval(event).ok_or(Stop::Declined)?;
                let of = JoinValue::Individual(event).to_term(&known.catalogue);
                (Term::Float(start), Term::Float(end), of)
            }
        };
        let (channel, statistic) = (self.term(channel)?, self.term(statistic)?);
        let request = Term::compound("telemetry", [channel, start, end, statistic, of]);
        // The engine reports this fault when it asks for the fact.
        let found = self.telemetry.rows(&known.catalogue, &request);
        for (place, row) in (0..).zip(found.map_err(|_| Stop::Declined)?) {
            if let Term::Compound(_, parts) = row
                && let Ok([Term::Atom(name), found]) = <[Term; 2]>::try_from(parts)
            {
                let name = self.find_thing(name);
                let pairs = [(episode, name), (value, JoinValue::from_term(found))];
                go_on!(self.candidate(&pairs, place, next));
            }
        }
        Ok(Flow::Continue)
    }
}

/// Side of a relation of time.
enum Known<'p> {
    /// Its times [s since 1970], and its individual, if it has one.
    Times([f64; 2], Option<IndividualId>),
    /// Still unknown.
    Nothing(&'p Pattern),
}

/// Returns the entries of one individual, or of all, and the position of the first.
fn part_of<T>(
    column: &[(IndividualId, T)],
    of: Option<IndividualId>,
) -> (usize, &[(IndividualId, T)]) {
    match of {
        None => (0, column),
        Some(id) => {
            let first = column.partition_point(|(subject, _)| *subject < id);
            (first, entries(&column[first..], id))
        }
    }
}

/// Returns all parts of a whole, each before its own parts.
fn parts_below(children: &Children, whole: IndividualId, found: &mut Vec<IndividualId>) {
    for &id in children.parts(whole) {
        found.push(id);
        parts_below(children, id, found);
    }
}
