//! The cause of a change of the localisation error, from force against depth.

use serde::Serialize;

/// Least number of rounds from which a cause is determined.
const FEWEST: usize = 5;
/// Share of a change in height above which the tool is its only cause, and below which the surface
/// is \[1\].
const IS_CAUSE: f64 = 0.7;
const IS_NO_CAUSE: f64 = 0.3;
/// Rounds before a sudden change that count, so that a long history does not hide it.
const BEFORE: usize = 20;
/// Least change in height whose cause is determined \[m\].
pub(crate) const LEAST_OFFSET: f64 = 1e-3;

/// The cause of a change in the height at which a tool gets in contact with a surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum DriftCause {
    /// The tool is softer, and sinks in deeper.
    WornTool,
    /// The tool is stiffer, and sinks in less.
    StifferTool,
    /// Both the tool and the surface have changed.
    ToolAndSurface,
    /// The surface is lower than before.
    LoweredSurface,
    /// The surface is higher than before.
    RaisedSurface,
    /// Some rounds lack force or stiffness.
    Unknown,
}

impl DriftCause {
    /// Name of the cause in queries and in JSON.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::WornTool => "worn_tool",
            Self::StifferTool => "stiffer_tool",
            Self::ToolAndSurface => "tool_and_surface",
            Self::LoweredSurface => "lowered_surface",
            Self::RaisedSurface => "raised_surface",
            Self::Unknown => "unknown",
        }
    }
}

/// Returns the change of the offset over rounds \[m\], and its cause; `None` for few rounds or a small change.
///
/// A softer tool is compressed further by the same force: at stiffness k and force F, the tool centre point is F / k
/// lower.
///
/// # Parameters
/// - `offsets`: offset of the surface along its normal in each round \[m\].
/// - `touches`: force \[N\] and stiffness [N/m] of each round; `None` where they are unknown.
/// - `sudden`: first index after a sudden change; without it, the first third is compared with the last one, which covers
///   gradual changes, too.
pub(crate) fn find_cause(
    offsets: &[f64],
    touches: &[[Option<f64>; 2]],
    sudden: Option<usize>,
) -> Option<(f64, DriftCause)> {
    let count = offsets.len();
    if count < FEWEST || sudden.is_some_and(|place| place == 0 || place >= count) {
        return None;
    }
    let some = (count / 3).max(2);
    let before = sudden.map_or(0..some, |place| place.saturating_sub(BEFORE)..place);
    let after = sudden.map_or(count - some, |place| place)..count;
    let first = before.start;
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let change = |values: &[f64]| mean(&values[after.clone()]) - mean(&values[before.clone()]);
    let moved = change(offsets);
    if moved.abs() < LEAST_OFFSET {
        return None;
    }
    let sunk = touches.iter().enumerate().map(|(k, [force, stiffness])| {
        if k < first {
            return Some(0.0);
        }
        let (force, stiffness) = ((*force)?, (*stiffness)?);
        (stiffness > 0.0).then(|| -force.abs() / stiffness)
    });
    let Some(sunk) = sunk.collect::<Option<Vec<f64>>>() else {
        return Some((moved, DriftCause::Unknown));
    };
    let by_tool = change(&sunk) / moved;
    let cause = if by_tool >= IS_CAUSE && moved < 0.0 {
        DriftCause::WornTool
    } else if by_tool >= IS_CAUSE {
        DriftCause::StifferTool
    } else if by_tool > IS_NO_CAUSE {
        DriftCause::ToolAndSurface
    } else if moved < 0.0 {
        DriftCause::LoweredSurface
    } else {
        DriftCause::RaisedSurface
    };
    Some((moved, cause))
}
