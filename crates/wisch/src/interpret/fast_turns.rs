//! Turns of the tool that are too fast for the rate of the samples.

use super::contact::{PathPiece, median};
use super::doubt::Doubt;
use crate::geometry::wrap_angle;

/// Turn between two samples from which a log does not show the turns [rad]: a quarter turn. The same tool at twice the
/// speed would make half a turn, whose direction is unknown.
const FAST_TURN: f64 = std::f64::consts::FRAC_PI_2;
/// Largest share of the contact with such turns that is ignored [1], as wrong poses have some.
const FEW_FAST_TURNS: f64 = 0.1;

/// Returns a doubt if the tool turns so far between two samples that the log cannot show how far: a turn beyond half a turn
/// looks like a smaller one in the other direction. `counts`: whether each turn counts, as in polishing.
pub(super) fn find_fast_turns(path: &[PathPiece], counts: bool) -> Option<Doubt> {
    let contact = (1..path.len()).filter(|&i| path[i - 1].is_on_plane() && path[i].is_on_plane());
    let turns: Vec<(f64, f64)> = contact
        .map(|i| {
            let turn = wrap_angle(path[i].heading - path[i - 1].heading);
            (turn.abs(), PathPiece::duration(path, i))
        })
        .collect();
    let fast = turns.iter().filter(|(turn, _)| *turn > FAST_TURN).copied();
    let fast: Vec<(f64, f64)> = fast.collect();
    let lasts = |turns: &[(f64, f64)]| turns.iter().map(|(_, lasts)| lasts).sum::<f64>();
    let is_fast = !fast.is_empty() && lasts(&fast) > FEW_FAST_TURNS * lasts(&turns);
    is_fast.then(|| Doubt::FastTurns {
        turn: median(fast),
        counts,
    })
}
