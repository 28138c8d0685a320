//! The strategies by which the planner finds strokes.

use super::CoverageStrategy;
use crate::represent::{Action, UnknownName};
use std::str::FromStr;

/// How the planner finds the strokes of a plan.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Strategy {
    /// Nodes that cover the surface or the dirt, joined by the policy of the action; the strategies
    /// of the paper.
    Coverage(CoverageStrategy),
    /// Simulated annealing over whole plans, each valued by its simulated effect.
    Adaptive,
    /// Parallel strips as wide as the tool, for actions that treat the surface itself.
    Lanes,
    /// The strategy whose plan has the highest predicted score. No plan has this as its own strategy.
    Best,
    /// Strokes that the user gave ([`plan_from_strokes`](super::plan_from_strokes)). The planner
    /// never uses this strategy.
    Own,
}

impl Strategy {
    /// Every strategy that plans, the paper's first; names in flags, files and error texts are taken from here.
    pub const ALL: [Self; 6] = [
        Self::Coverage(CoverageStrategy::ALL[0]),
        Self::Coverage(CoverageStrategy::ALL[1]),
        Self::Coverage(CoverageStrategy::ALL[2]),
        Self::Adaptive,
        Self::Lanes,
        Self::Best,
    ];

    /// Whether the strategy plans an action: lanes plan actions that treat the surface, all other strategies
    /// those that move dirt.
    pub fn fits(self, action: Action) -> bool {
        match self {
            Self::Best => true,
            Self::Own => false,
            Self::Lanes => action.treats(),
            Self::Coverage(_) | Self::Adaptive => !action.treats(),
        }
    }

    /// Names of the strategies that plan an action, for people to read.
    pub fn names_for(action: Action) -> String {
        let fitting = Self::ALL
            .into_iter()
            .filter(|strategy| strategy.fits(action));
        fitting.map(Self::as_str).collect::<Vec<_>>().join(", ")
    }

    /// The strategy for later rounds of an action: nodes by the density of the remaining dirt.
    pub(crate) fn for_what_is_left(action: Action) -> Self {
        if action.treats() {
            Self::Lanes
        } else {
            CoverageStrategy::Kde.into()
        }
    }

    /// Whether the strategy searches for strokes by their simulated effect.
    pub const fn is_searched(self) -> bool {
        matches!(self, Self::Adaptive | Self::Best)
    }

    /// Whether the strategy's strokes turn the tool on purpose, for any action.
    pub(crate) const fn turns_tool(self) -> bool {
        matches!(self, Self::Adaptive | Self::Best | Self::Own)
    }

    /// The coverage strategy for strokes that must run through nodes: this strategy if it is a
    /// coverage strategy, otherwise [`CoverageStrategy::Kde`].
    pub(super) fn covering(self) -> CoverageStrategy {
        match self {
            Self::Coverage(strategy) => strategy,
            Self::Adaptive | Self::Lanes | Self::Best | Self::Own => CoverageStrategy::Kde,
        }
    }

    /// The name used in task files, flags and results.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Coverage(strategy) => strategy.as_str(),
            Self::Adaptive => "adaptive",
            Self::Lanes => "lanes",
            Self::Best => "best",
            Self::Own => "own",
        }
    }
}

impl From<CoverageStrategy> for Strategy {
    fn from(strategy: CoverageStrategy) -> Self {
        Self::Coverage(strategy)
    }
}

impl std::fmt::Display for Strategy {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.pad(self.as_str())
    }
}

impl FromStr for Strategy {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        // A written plan may have this strategy; a task cannot ask for it.
        let mut all = Self::ALL.into_iter().chain([Self::Own]);
        let named = all.find(|s| s.as_str() == name);
        named.ok_or_else(|| UnknownName::new("strategy", name, Self::ALL.map(Self::as_str)))
    }
}
