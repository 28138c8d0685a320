//! Variants of the method with other uncertainties or fewer members, scored on the rounds that the method executed. They
//! show the contribution of each part of the method.

use serde::{Deserialize, Serialize};
use std::str::FromStr;
use wisch::interpret::{
    Belief, InterpretConfig, InterpretError, Interpreter, ObservationUpdate,
    PerformanceDistribution, TouchSample, Uncertainty,
};
use wisch::represent::{GoalState, Observation, Sight, Task};
use wisch::run::PlannedRound;

/// The field of a variant for the number of members of its belief.
const MEMBERS: &str = "members";
/// Seed of the selection of members.
const MEMBERS_SEED: u64 = 1;

/// A named variant with other uncertainties, such as `no heap:heap_depth=0`, or with fewer members, such as
/// `one draw:members=1`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Variant {
    /// Name in tables.
    pub name: String,
    /// Fields of [`Uncertainty`] with their values, and `members`.
    pub fields: Vec<(String, f64)>,
}

impl Variant {
    /// Returns the uncertainties of the variant.
    ///
    /// # Errors
    /// If a field is unknown or a value is outside its limits.
    pub fn uncertainty(&self, method: Uncertainty) -> Result<Uncertainty, InterpretError> {
        let mut fields = self.fields.iter().filter(|(name, _)| name != MEMBERS);
        fields.try_fold(method, |changed, (name, value)| {
            changed.with_field(name, *value)
        })
    }

    /// Number of members of its belief; `None` for the method's number.
    pub fn members(&self) -> Option<usize> {
        let members = self.fields.iter().rev().find(|(name, _)| name == MEMBERS);
        members.map(|(_, count)| *count as usize)
    }
}

impl FromStr for Variant {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (name, fields) = (text.split_once(':'))
            .filter(|(name, fields)| !name.trim().is_empty() && !fields.is_empty())
            .ok_or_else(|| format!("`{text}` is not NAME:FIELD=VALUE[,FIELD=VALUE…]"))?;
        let field = |field: &str| {
            let (name, value) = field
                .split_once('=')
                .ok_or_else(|| format!("`{field}` is not FIELD=VALUE"))?;
            let value: f64 = (value.trim().parse())
                .map_err(|_| format!("{}: `{}` is not a number", name.trim(), value.trim()))?;
            Ok((name.trim().to_owned(), value))
        };
        let fields: Result<Vec<_>, String> = fields.split(',').map(field).collect();
        let variant = Self {
            name: name.trim().to_owned(),
            fields: fields?,
        };
        (variant.uncertainty(Uncertainty::default())).map_err(|error| error.to_string())?;
        let counts = variant.fields.iter().filter(|(name, _)| name == MEMBERS);
        for (_, count) in counts {
            if !((1.0..=1e6).contains(count) && count.fract() == 0.0) {
                return Err(format!(
                    "{MEMBERS}: {count} is not a whole number from 1 to 1000000"
                ));
            }
        }
        Ok(variant)
    }
}

/// The inputs of a belief update that do not depend on the round.
#[derive(Debug, Clone, Copy)]
pub(crate) struct CameraObservation<'a> {
    pub(crate) observation: &'a Observation,
    pub(crate) sight: Sight,
}

impl<'a> CameraObservation<'a> {
    /// Returns an observation with the model of its camera; `None` without an observation or a camera.
    pub(crate) fn from_observation(
        observation: Option<&'a Observation>,
        sight: Option<Sight>,
    ) -> Option<Self> {
        Some(Self {
            observation: observation?,
            sight: sight?,
        })
    }

    pub(crate) fn update(self, task: &'a Task, goal: &'a GoalState) -> ObservationUpdate<'a> {
        ObservationUpdate {
            observation: self.observation,
            sight: self.sight,
            surface: &task.surface,
            goal,
            seed: task.seed,
        }
    }
}

/// The state of a variant over the rounds of a world.
#[derive(Debug, Clone)]
pub(crate) struct VariantBelief<'a> {
    variant: &'a Variant,
    belief: Belief,
}

impl<'a> VariantBelief<'a> {
    /// Makes the state before the first round, from the method's belief.
    pub(crate) fn new(variant: &'a Variant, belief: Belief) -> Self {
        let belief = match variant.members() {
            Some(members) => belief.resample(members, MEMBERS_SEED),
            None => belief,
        };
        Self { variant, belief }
    }

    /// Updates the belief with the measurements of a round and the observation after it.
    pub(crate) fn update_belief(
        &mut self,
        planned: &PlannedRound,
        touches: &[TouchSample],
        observed: Option<CameraObservation<'_>>,
        goal: &GoalState,
    ) -> Result<PerformanceDistribution, InterpretError> {
        let task = &planned.task;
        let mut config = InterpretConfig::from_task(task);
        config.uncertainty = self.variant.uncertainty(config.uncertainty)?;
        config.replays = self.variant.members().unwrap_or(config.replays);
        let mut interpreter = Interpreter::new(task, &config)?;
        for sample in touches {
            interpreter.push(sample)?;
        }
        let mut interpretation = interpreter.conclude(&self.belief, goal)?;
        if let Some(observed) = observed {
            interpretation.observe(&observed.update(task, goal));
        }
        self.belief = interpretation.belief;
        Ok(interpretation.distribution)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_variant_is_read_and_refused_by_name_and_value() {
        let variant: Variant = "no law: law_mu=0, law_sigma=0".parse().unwrap();
        let changed = variant.uncertainty(Uncertainty::default()).unwrap();
        assert_eq!((changed.law_mu, changed.law_sigma), (0.0, 0.0));
        assert_eq!(changed.heap_depth, Uncertainty::default().heap_depth);
        assert_eq!(variant.members(), None);
        let alone: Variant = "one draw:members=1".parse().unwrap();
        assert_eq!(alone.members(), Some(1));
        assert_eq!(alone.uncertainty(changed).unwrap(), changed);
        for (wrong, word) in [
            ("heap_depth=0", "NAME:FIELD=VALUE"),
            ("a:heap_depth", "FIELD=VALUE"),
            ("a:heap_depth=x", "not a number"),
            ("a:depth=1", "not a field"),
            ("a:slip_share=2", "0 to 1"),
            ("a:members=0.5", "whole number"),
        ] {
            let error = wrong.parse::<Variant>().unwrap_err();
            assert!(error.contains(word), "{error}");
        }
    }
}
