//! A compliant tool that leans on a plane: how far its frame is above the place at which it would lie flat.

use super::classification::slope;
use super::downsampling::MeasuredPiece;
use super::pressure_distribution::middle;
use super::weighted::median;
use crate::geometry::{Region, Vector3};
use crate::interpret::config::InterpretConfig;

/// Least f′ of a contact that shows how the tool leans [1].
const PRESSING: f64 = 0.5;
/// Least median change of the height that matters [m].
const LEAST_CHANGE: f64 = 3e-4;
/// Largest lean for which the model holds [rad]; 40°. Beyond it, the frame is probably not that of the tool.
const MOST_LEAN: f64 = 40.0 * std::f64::consts::PI / 180.0;

/// Returns the pieces with the heights that the tool would have if it lay flat with the same force; `None` if it leans too
/// little or too far.
///
/// The tool is a bed of springs. A leaning one carries the force with one edge, so that its middle is higher than that of a
/// flat one: by the compression at nominal force times the difference of f′ in the middle and its mean.
///
/// # Parameters
/// - `pieces`: with forces as read.
/// - `normal`: of the plane of the contacts, in the believed surface frame.
/// - `footprint`: in the tool frame.
pub(in crate::interpret) fn level_leaning_tool(
    pieces: &[MeasuredPiece],
    normal: &Vector3,
    footprint: &Region,
    config: &InterpretConfig,
) -> Option<Vec<MeasuredPiece>> {
    let compression = config.nominal_compression();
    let bounds = footprint.bounds().filter(|_| compression > 0.0)?;
    let share = |piece: &MeasuredPiece| config.normalized(-piece.force.z).clamp(0.0, 1.0);
    let change = |piece: &MeasuredPiece| {
        let rise = slope(piece, normal) / compression;
        let half = rise.abs().component_mul(&bounds.size()) / 2.0;
        let share = share(piece);
        let beside = rise.dot(&bounds.center().coords);
        compression * (middle(share, half) - beside - share)
    };
    let changes: Vec<f64> = pieces.iter().map(change).collect();
    let pressed = pieces.iter().zip(&changes);
    let pressed = pressed.filter(|(piece, _)| share(piece) >= PRESSING);
    let (sizes, leans): (Vec<_>, Vec<_>) = pressed
        .map(|(piece, change)| {
            let lean = libm::atan(slope(piece, normal).norm());
            let time = f64::from(piece.samples);
            ((change.abs(), time), (lean, time))
        })
        .unzip();
    let matters = median(sizes) >= LEAST_CHANGE && median(leans) <= MOST_LEAN;
    matters.then(|| {
        (pieces.iter().zip(changes))
            .map(|(piece, change)| MeasuredPiece {
                mean_height: piece.mean_height + change,
                ..*piece
            })
            .collect()
    })
}
