//! A strategy of the user's own: a function that returns the strokes for a task.

use crate::geometry::PlanarPose;
use crate::plan::{Plan, PlanError, plan_from_strokes};
use crate::represent::Task;
use std::fmt;
use std::sync::Arc;

/// The result of the function: strokes as for [`plan_from_strokes`], or the reason why it has none.
type OwnStrokes = Result<Vec<Vec<PlanarPose>>, String>;

/// A function that returns the strokes of a round. The planner checks them like any strokes that a user gives.
///
/// ```
/// use wisch::geometry::{PlanarPose, Point2};
/// use wisch::represent::Task;
/// use wisch::run::{OwnStrategy, Session};
/// # fn with_own(task: &Task) {
/// // One stroke along x through the middle of the surface.
/// let middle = OwnStrategy::new(|_: &Task| {
///     Ok(vec![[-0.1, 0.1].map(|x| PlanarPose::new(Point2::new(x, 0.0), 0.0)).to_vec()])
/// });
/// let session = Session::new(task, Default::default()).with_strategy(middle);
/// # }
/// ```
#[derive(Clone)]
pub struct OwnStrategy<'a>(Arc<dyn Fn(&Task) -> OwnStrokes + Send + Sync + 'a>);

impl<'a> OwnStrategy<'a> {
    /// Returns the strategy of a function. The function gets the task of the round, with the current estimate
    /// of the particles.
    pub fn new(strokes: impl Fn(&Task) -> OwnStrokes + Send + Sync + 'a) -> Self {
        Self(Arc::new(strokes))
    }

    /// Returns the function's plan for a task. `lift_height`: height by which the tool is lifted between
    /// strokes \[m\].
    ///
    /// # Errors
    /// [`PlanError::OwnStrategy`] with the function's error, or [`PlanError::Stroke`] for a stroke
    /// that the tool cannot make.
    pub fn plan(&self, task: &Task, lift_height: f64) -> Result<Plan, PlanError> {
        let strokes = (self.0)(task).map_err(PlanError::OwnStrategy)?;
        plan_from_strokes(task, &strokes, lift_height)
    }
}

impl fmt::Debug for OwnStrategy<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("OwnStrategy")
    }
}
