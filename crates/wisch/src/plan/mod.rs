//! From a goal to the motions that reach it.

mod goal;

pub use goal::{Domain, GoalError, GoalLiteral, Problem, ResolvedGoal, Step, resolve_goal, solve};
