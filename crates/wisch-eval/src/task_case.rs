//! The nine tasks of the paper's Table 1, on shipped scenarios.

use serde::{Deserialize, Serialize};
use wisch::represent::Action;

/// A task of Table 1: an action on the surface of a scenario.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct TaskCase {
    /// Index of the surface: board, table, windshield.
    place: usize,
    /// Index into [`Action::WIPING`].
    action: usize,
}

/// The shipped scenarios with the names of their surfaces.
const PLACES: [(&str, &str); 3] = [
    ("chopping-board", "board"),
    ("table", "table"),
    ("windshield", "windshield"),
];

impl TaskCase {
    /// Returns all nine tasks, surface by surface.
    pub fn cases_by_surface() -> impl Iterator<Item = Self> {
        (0..PLACES.len())
            .flat_map(|place| (0..Action::WIPING.len()).map(move |action| Self { place, action }))
    }

    /// Returns all nine tasks in the order of the paper's Table 1, action by action.
    pub fn cases_by_action() -> impl Iterator<Item = Self> {
        (0..Action::WIPING.len())
            .flat_map(|action| (0..PLACES.len()).map(move |place| Self { place, action }))
    }

    /// Index of the surface among board, table and windshield.
    pub const fn place_index(&self) -> usize {
        self.place % PLACES.len()
    }

    /// Index of the action in [`Action::WIPING`].
    pub const fn action_index(&self) -> usize {
        self.action % Action::WIPING.len()
    }

    /// Name of the shipped scenario with this surface.
    pub fn scenario(&self) -> &'static str {
        PLACES[self.place_index()].0
    }

    /// Name of the surface: board, table or windshield.
    pub fn place(&self) -> &'static str {
        PLACES[self.place_index()].1
    }

    /// The wiping action of the task.
    pub fn action(&self) -> Action {
        Action::WIPING[self.action_index()]
    }

    /// Name of the task, such as `collect chopping-board`.
    pub fn name(&self) -> String {
        format!("{} {}", self.action(), self.scenario())
    }

    /// Returns the tasks that a text names by a surface, an action, or both, such as `board/absorb`, in the order of
    /// [`Self::cases_by_action`].
    ///
    /// # Errors
    /// If the text names no task.
    ///
    /// ```
    /// use wisch_eval::TaskCase;
    /// let names = |text| TaskCase::parse(text).map(|cases| cases.iter().map(TaskCase::name).collect::<Vec<_>>());
    /// assert_eq!(names("board/absorb"), Ok(vec!["absorb chopping-board".to_owned()]));
    /// assert_eq!(names("windshield").map(|names| names.len()), Ok(3));
    /// assert!(names("bord/absorb").is_err());
    /// ```
    pub fn parse(text: &str) -> Result<Vec<Self>, UnknownCell> {
        let fits = |case: &Self, word: &str| {
            [case.place(), case.scenario(), case.action().as_str()].contains(&word)
        };
        let cases: Vec<Self> = Self::cases_by_action()
            .filter(|case| text.split('/').all(|word| fits(case, word)))
            .collect();
        if cases.is_empty() {
            return Err(UnknownCell(text.to_owned()));
        }
        Ok(cases)
    }
}

/// A text that names no cell of Table 1.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error(
    "{0:?} is not a cell of Table 1: write a surface (board, table, windshield), an action (absorb, collect, skim), or both, such as board/absorb"
)]
pub struct UnknownCell(String);
