//! The plan of a session's first round, computed for another session or taken from one.

use super::planning::NextPlan;
use super::{Session, Stage};
use crate::run::first_plan::{FirstInputs, FirstPlan};
use crate::run::{Executor, Observer, RunError, RunEvent};

impl<'a> Session<'a> {
    /// Completes the first round up to [`Stage::Audited`], or without a robot up to [`Stage::Planned`], and returns its plan
    /// for [`Self::with_first_plan`]. Returns `None` if there is no plan, or a plan that the user has given.
    ///
    /// # Errors
    /// As [`Self::step`].
    ///
    /// ```
    /// # use wisch::prelude::*;
    /// # let outline = Polygon::rectangle(Vector2::new(0.4, 0.3));
    /// # let surface = Surface::new("tray", outline, Pose::identity());
    /// # let sponge = Tool::pad("sponge", Vector3::new(0.07, 0.11, 0.05))?;
    /// # let crumbs = ParticleDistribution::new(&[Point2::new(0.0, 0.0), Point2::new(0.0, 0.12)])?;
    /// # let task = Task::new(Action::Absorb, surface, sponge, "crumbs", crumbs);
    /// use wisch::run::NoExecutor;
    /// let mut session = Session::new(&task, RunConfig::default());
    /// let first = session.plan_first(&mut NoExecutor, &mut ignore_events)?;
    /// let mut same = Session::new(&task, RunConfig::default()).with_first_plan(first);
    /// same.step(&mut NoExecutor, &mut ignore_events)?;
    /// assert!(same.has_used_first_plan());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn plan_first(
        &mut self,
        executor: &mut dyn Executor,
        observer: &mut Observer<'_>,
    ) -> Result<Option<FirstPlan<'a>>, RunError> {
        let is_given = self.own.is_some() || self.given.is_some();
        let until = match self.performer {
            Some(_) => Stage::Audited,
            None => Stage::Planned,
        };
        let (mut considered, mut progress) = (None, Vec::new());
        self.run_until(until, executor, &mut |event| {
            match event {
                RunEvent::Evaluated {
                    considered: all, ..
                } => considered = Some(all.to_vec()),
                RunEvent::Following { passed, .. } => progress.push(*passed),
                _ => {}
            }
            observer(event)
        })?;
        let plan = self.plan().filter(|_| !is_given && self.rounds.is_empty());
        let motion = self.planned_round().cloned().map(Box::new);
        Ok(plan.cloned().map(|plan| FirstPlan {
            inputs: self.first_inputs(),
            considered,
            plan,
            motion: motion.map(|motion| (motion, progress)),
        }))
    }

    /// Sets a plan for the first round that another session has computed. The session uses it if all inputs of its own first
    /// plan are equal, and then reports the same events; otherwise it plans anew.
    #[must_use]
    pub fn with_first_plan(self, first: Option<FirstPlan<'a>>) -> Self {
        Self { first, ..self }
    }

    /// Whether the first round uses the plan of [`Self::with_first_plan`].
    pub const fn has_used_first_plan(&self) -> bool {
        self.is_first_used
    }

    /// Returns the inputs of the first plan, after the first observation and the first joint state.
    fn first_inputs(&self) -> FirstInputs<'a> {
        FirstInputs {
            task: self.task.clone(),
            belief: self.belief.clone(),
            robot: self.performer,
            workcell: self.workcell.clone(),
            plan: self.config.plan.clone(),
            variants: self.config.variants,
            follow: self.config.follow.clone(),
            pace: self.config.pace,
            is_observed: self.first_observation().is_some(),
            positions: self.stands.clone(),
        }
    }

    /// Takes the plan of another session, if it was computed from the inputs of this one.
    pub(super) fn take_first_plan(&mut self, observer: &mut Observer<'_>) -> Option<NextPlan> {
        let first = self.first.take()?;
        let is_given = self.own.is_some() || self.given.is_some();
        if is_given || first.inputs != self.first_inputs() {
            return None;
        }
        self.is_first_used = true;
        if let Some(considered) = &first.considered {
            let round = self.number();
            let _ = observer(&RunEvent::Evaluated { round, considered });
        }
        Some(match first.motion {
            Some((motion, progress)) => {
                self.cell = Ok(motion.cell.clone()).into();
                NextPlan::Followed(motion, progress)
            }
            None => NextPlan::Alone(first.plan),
        })
    }
}
