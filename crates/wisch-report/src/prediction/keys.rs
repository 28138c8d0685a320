//! Legend of the drawings of a plan and its prediction.

use super::layers::Drawing;
use crate::draw::Entry;
use crate::draw::surface::{achieved_label, lost_label, open_label};
use maud::{Markup, html};
use wisch::plan::{Node, NodeRole};
use wisch::represent::GoalState;

/// One entry of a legend.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Key {
    Before,
    Left,
    Done,
    Lost,
    Unreachable,
    Node,
    NodeCut,
    Goal,
    GoalArea,
    Edge,
    Start,
    Lifted,
    Tool,
    Obstacle,
    SkimEdge,
    LeftNow,
    DoneNow,
    Trail,
}

impl Key {
    fn label(self, goal: &GoalState) -> &'static str {
        match (self, goal) {
            (Self::Before, GoalState::Absorbed) => "particle before (empty: absorbed)",
            (Self::Left, GoalState::Absorbed) => "after, not absorbed",
            (Self::Left, GoalState::Collected { .. }) => "after, outside the goal area",
            (Self::Left, GoalState::Skimmed) => "after, still on the surface",
            (
                Self::Left | Self::LeftNow,
                GoalState::Polished { .. } | GoalState::Dispensed { .. },
            ) => open_label(goal),
            (
                Self::Done | Self::DoneNow,
                GoalState::Polished { .. } | GoalState::Dispensed { .. },
            ) => achieved_label(goal),
            (Self::Before, GoalState::Polished { .. } | GoalState::Dispensed { .. }) => {
                "point of the surface"
            }
            (Self::Before, _) => "particle before",
            (Self::Done, GoalState::Skimmed) => "after, pushed over the skim edge",
            (Self::Done, _) => "after, in the goal area",
            (Self::Lost, _) => lost_label(goal),
            (Self::Unreachable, _) => "out of reach",
            (Self::Node, _) => "node",
            (Self::NodeCut, _) => "node without a path to the goal",
            (Self::Goal, _) => "goal node",
            (Self::GoalArea, _) => "goal area",
            (Self::Edge, _) => "direction of wiping",
            (Self::Start, _) => "start of stroke 1, 2, …",
            (Self::Lifted, _) => "lifted move",
            (Self::Tool, _) => "tool, to scale",
            (Self::Obstacle, _) => "obstacle",
            (Self::SkimEdge, _) => "skim edge",
            (Self::LeftNow, GoalState::Collected { .. }) => "outside the goal area",
            (Self::LeftNow, _) => "on the surface",
            (Self::DoneNow, GoalState::Skimmed) => "over the skim edge",
            (Self::DoneNow, _) => "in the goal area",
            (Self::Trail, _) => "path wiped so far",
        }
    }

    /// Draws a sample of 24 by 14 units around (12, 0).
    fn sample(self) -> Markup {
        html! {
            @match self {
                Self::Before => circle class="before" cx="12" cy="0" r="3.6" {},
                Self::Left | Self::LeftNow => path class="dots-left" stroke-width="7" d="M12 0h0" {},
                Self::Done | Self::DoneNow => path class="dots-done" stroke-width="7" d="M12 0h0" {},
                Self::Lost => path class="mark-lost" d="M8.5-3.5l7 7m0-7l-7 7" {},
                Self::Unreachable => {
                    circle class="before" cx="12" cy="0" r="3.6" {}
                    path class="mark-lost" d="M7 5l10-10" {}
                },
                Self::Node => circle class="node" cx="12" cy="0" r="5" {},
                Self::NodeCut => circle class="node-cut" cx="12" cy="0" r="4.5" {},
                Self::Goal => circle class="goal" cx="12" cy="0" r="6" {},
                Self::GoalArea => rect class="goal-reach" x="2" y="-6" width="20" height="12" rx="6" {},
                Self::Edge => {
                    path class="edge" d="M1 0h22" {}
                    path class="arrow" d="M17 0l-9-4.5l2.5 4.5l-2.5 4.5z" {}
                },
                Self::Start => {
                    circle class="node" cx="12" cy="0" r="8" {}
                    text class="number" font-size="10" x="12" y="3.7" { "1" }
                },
                Self::Trail => path class="trail" d="M0 0h24" {},
                Self::Lifted => path class="lifted" d="M0 0h24" {},
                Self::Tool => rect class="tool" x="4" y="-6" width="16" height="12" {},
                Self::Obstacle => rect class="obstacle" x="4" y="-6" width="16" height="12" {},
                Self::SkimEdge => {
                    path class="skim-edge" d="M0 0h24" {}
                    path class="skim-core" d="M0 0h24" {}
                },
            }
        }
    }
}

/// Returns the legend entries of the `wanted` marks that can occur in a picture of this run.
pub(crate) fn entries(drawing: &Drawing, wanted: impl IntoIterator<Item = Key>) -> Vec<Entry> {
    let input = drawing.input;
    let (plan, performance) = (input.plan, &input.prediction.performance);
    let lifted = plan.strokes.len() > 1;
    wanted
        .into_iter()
        .filter(|key| match key {
            Key::Before | Key::Left | Key::LeftNow => performance.initial > 0,
            Key::Done | Key::DoneNow => {
                plan.graph.goal != GoalState::Absorbed && performance.initial > 0
            }
            Key::Lost => performance.lost > 0,
            Key::Unreachable => drawing.has_unreachable(),
            Key::Tool => true,
            Key::Node => !plan.graph.nodes.is_empty(),
            Key::NodeCut => !plan.graph.unreachable.is_empty(),
            Key::Goal => {
                let is_goal = |node: &Node| node.role == NodeRole::Goal;
                plan.graph.nodes.iter().any(is_goal)
            }
            Key::GoalArea => matches!(plan.graph.goal, GoalState::Collected { .. }),
            Key::Edge => !plan.graph.edges.is_empty(),
            Key::Start => !plan.strokes.is_empty() && drawing.map_has_numbers(),
            Key::Trail => !plan.strokes.is_empty(),
            Key::Lifted => lifted,
            Key::Obstacle => drawing.has_obstacles(),
            Key::SkimEdge => plan.graph.goal == GoalState::Skimmed,
        })
        .map(|key| Entry {
            label: key.label(&plan.graph.goal).to_owned(),
            sample: key.sample(),
        })
        .collect()
}
