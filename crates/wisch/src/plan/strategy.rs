//! How strokes are found.

use super::CoverageStrategy;
use crate::represent::UnknownName;
use std::str::FromStr;

/// How the strokes of a plan are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Strategy {
    /// Nodes that cover the surface or the dirt, joined by the action's policy; the paper's.
    Coverage(CoverageStrategy),
    /// Whole plans that are changed at random and kept by what they are simulated to do.
    Adaptive,
    /// Whichever of the others is predicted to be worth most. No plan has this as its own strategy.
    Best,
}

impl Strategy {
    /// Every strategy, the paper's first; names in flags, files and error texts are taken from here.
    pub const ALL: [Self; 5] = [
        Self::Coverage(CoverageStrategy::ALL[0]),
        Self::Coverage(CoverageStrategy::ALL[1]),
        Self::Coverage(CoverageStrategy::ALL[2]),
        Self::Adaptive,
        Self::Best,
    ];

    /// Whether strokes are searched for by what they are simulated to do.
    pub const fn is_searched(self) -> bool {
        matches!(self, Self::Adaptive | Self::Best)
    }

    /// The coverage strategy whose nodes serve where strokes have to run through nodes: the density's, unless it is one.
    pub(super) fn covering(self) -> CoverageStrategy {
        match self {
            Self::Coverage(strategy) => strategy,
            Self::Adaptive | Self::Best => CoverageStrategy::Kde,
        }
    }

    /// The name used in task files, flags and results.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::Coverage(strategy) => strategy.as_str(),
            Self::Adaptive => "adaptive",
            Self::Best => "best",
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
        let named = Self::ALL.into_iter().find(|s| s.as_str() == name);
        named.ok_or_else(|| UnknownName::new("strategy", name, Self::ALL.map(Self::as_str)))
    }
}
