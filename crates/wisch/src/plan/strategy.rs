//! How strokes are found.

use super::CoverageStrategy;
use crate::represent::{Action, UnknownName};
use std::str::FromStr;

/// How the strokes of a plan are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Strategy {
    /// Nodes that cover the surface or the dirt, joined by the action's policy; the paper's.
    Coverage(CoverageStrategy),
    /// Whole plans that are changed at random and kept by what they are simulated to do.
    Adaptive,
    /// Parallel strips as wide as the tool, for actions that treat the surface itself.
    Lanes,
    /// Whichever of the others is predicted to be worth most. No plan has this as its own strategy.
    Best,
    /// Strokes that came from outside ([`plan_of_strokes`](super::plan_of_strokes)); nothing is planned by it.
    Own,
}

impl Strategy {
    /// Every strategy by which can be planned, the paper's first; names in flags, files and error texts are taken from here.
    pub const ALL: [Self; 6] = [
        Self::Coverage(CoverageStrategy::ALL[0]),
        Self::Coverage(CoverageStrategy::ALL[1]),
        Self::Coverage(CoverageStrategy::ALL[2]),
        Self::Adaptive,
        Self::Lanes,
        Self::Best,
    ];

    /// Whether it plans an action: lanes those that treat the surface, and the others those that move dirt.
    pub fn fits(self, action: Action) -> bool {
        match self {
            Self::Best => true,
            Self::Own => false,
            Self::Lanes => action.treats(),
            Self::Coverage(_) | Self::Adaptive => !action.treats(),
        }
    }

    /// The names of those that plan an action, for people to read.
    pub fn names_for(action: Action) -> String {
        let fitting = Self::ALL
            .into_iter()
            .filter(|strategy| strategy.fits(action));
        fitting.map(Self::as_str).collect::<Vec<_>>().join(", ")
    }

    /// That by which a later round of an action is planned: what is left over is best covered by its density.
    pub(crate) fn for_what_is_left(action: Action) -> Self {
        if action.treats() {
            Self::Lanes
        } else {
            CoverageStrategy::Kde.into()
        }
    }

    /// Whether strokes are searched for by what they are simulated to do.
    pub const fn is_searched(self) -> bool {
        matches!(self, Self::Adaptive | Self::Best)
    }

    /// Whether its strokes turn the tool on purpose, whatever the action.
    pub(crate) const fn turns_tool(self) -> bool {
        matches!(self, Self::Adaptive | Self::Best | Self::Own)
    }

    /// The coverage strategy whose nodes serve where strokes have to run through nodes: the density's, unless it is one.
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
        // In a plan that was written, not in a task that asks for one.
        let mut all = Self::ALL.into_iter().chain([Self::Own]);
        let named = all.find(|s| s.as_str() == name);
        named.ok_or_else(|| UnknownName::new("strategy", name, Self::ALL.map(Self::as_str)))
    }
}
