//! Compression of the tool, estimated from all contacts: height = plane − force / stiffness.
//!
//! A pad that is harder or softer than declared seems to leave the plane as soon as its force changes.

use super::curvature::is_inland;
use super::downsampling::MeasuredPiece;
use super::force_reading::is_sliding;
use super::stiffness::ToolStiffness;
use crate::interpret::config::InterpretConfig;
use crate::represent::Surface;
use nalgebra::{Matrix4, Vector4};

/// Least force of a contact over the nominal one [1].
const LEAST_SHARE: f64 = 0.2;
/// Longest time over which contacts are averaged, and longest gap within it [s]: noise of the force
/// would otherwise make the tool appear incompressible.
const WINDOW: f64 = 0.25;
const GAP: f64 = 0.05;
/// Least number of such means.
const FEWEST: usize = 12;
/// Share of the contacts at either end of the range of forces that is excluded from the range [1],
/// and the least range over the nominal force [1].
const TAIL: f64 = 0.1;
const LEAST_RANGE: f64 = 0.3;
/// Least error of the heights by the declared stiffness over the range of forces [m].
const LEAST_ERROR: f64 = 5e-4;
/// Least median distance of the contacts from the fit with the declared stiffness [m]: noise of the force alone gives less.
const LEAST_OFF: f64 = 2.5e-4;
/// Largest median distance of the contacts from the fit, over that with the declared stiffness [1].
const LEAST_BETTER: f64 = 0.5;
/// Largest median distance of the contacts from the fit [m].
const MOST_OFF: f64 = 4e-4;
/// Iterations of reweighted least squares, and the residual beyond which a contact gets less weight [m].
const ROUNDS: usize = 10;
const OUTLIER: f64 = 5e-4;
/// Largest stiffness that heights can show [N/m].
pub(in crate::interpret) const STIFFEST: f64 = 1e5;
/// Error that heights at different forces have in common [m], and least standard deviation of the logarithm of the stiffness
/// [1]: pads settle, and forces lag.
const HEIGHT_ERROR: f64 = 5e-5;
const LEAST_DEVIATION: f64 = 0.12;

/// Mean of contacts that follow each other: height [m], and 1, place [m] and force beyond the nominal one [N].
struct Contact {
    row: Vector4<f64>,
    height: f64,
}

/// Returns the stiffness of the tool, if the declared one does not explain the heights of the contacts and this one
/// does. The forces of the pieces are read already.
pub(in crate::interpret) fn find_stiffness(
    pieces: &[MeasuredPiece],
    surface: &Surface,
    config: &InterpretConfig,
) -> Option<ToolStiffness> {
    let declared = config.stiffness().filter(|_| config.gap_m == 0.0)?;
    let nominal = config.nominal_force();
    let is_contact = |i: &usize| {
        let piece = &pieces[*i];
        piece.force.z >= LEAST_SHARE * nominal
            && is_sliding(pieces, *i, config)
            && is_inland(piece.position.xy(), surface, config)
    };
    let touching: Vec<&MeasuredPiece> = (0..pieces.len())
        .filter(is_contact)
        .map(|i| &pieces[i])
        .collect();
    let contacts = average(&touching, nominal);
    if contacts.len() < FEWEST {
        return None;
    }
    let mut forces: Vec<f64> = contacts.iter().map(|contact| contact.row.w).collect();
    forces.sort_unstable_by(f64::total_cmp);
    let at = |share: f64| forces[((forces.len() - 1) as f64 * share) as usize];
    let range = at(1.0 - TAIL) - at(TAIL);
    if range < LEAST_RANGE * nominal {
        return None;
    }
    let (free, off) = fit(&contacts, None)?;
    let (_, declared_off) = fit(&contacts, Some(1.0 / declared))?;
    let compliance = free.max(1.0 / STIFFEST);
    let is_other = (compliance - 1.0 / declared).abs() * range >= LEAST_ERROR;
    let is_wrong = declared_off >= LEAST_OFF;
    let is_better = off <= MOST_OFF && off <= LEAST_BETTER * declared_off;
    (is_other && is_wrong && is_better).then(|| ToolStiffness {
        n_per_m: 1.0 / compliance,
        ln_deviation: (HEIGHT_ERROR / range / compliance).max(LEAST_DEVIATION),
        is_assumed: false,
    })
}

/// Averages contacts over short times. `nominal`: nominal force [N].
fn average(touching: &[&MeasuredPiece], nominal: f64) -> Vec<Contact> {
    let mut contacts = Vec::new();
    let mut first = 0;
    while first < touching.len() {
        let is_next = |i: &usize| {
            touching[*i].time[0] - touching[*i - 1].time[1] <= GAP
                && touching[*i].time[1] - touching[first].time[0] <= WINDOW
        };
        let end = first + 1 + (first + 1..touching.len()).take_while(is_next).count();
        let some = &touching[first..end];
        let (mut row, mut height) = (Vector4::zeros(), 0.0);
        for piece in some {
            let place = piece.position;
            row += Vector4::new(1.0, place.x, place.y, piece.force.z - nominal);
            height += piece.mean_height;
        }
        if touching[end - 1].time[1] - touching[first].time[0] >= 0.5 * WINDOW {
            let count = some.len() as f64;
            contacts.push(Contact {
                row: row / count,
                height: height / count,
            });
        }
        first = end;
    }
    contacts
}

/// Fits plane and compliance, or the plane alone with the `given` compliance [m/N]. Returns the compliance and the median
/// distance of the contacts from the fit [m].
fn fit(contacts: &[Contact], given: Option<f64>) -> Option<(f64, f64)> {
    let row = |contact: &Contact| match given {
        Some(_) => contact.row.xyz().push(0.0),
        None => contact.row,
    };
    let height = |contact: &Contact| contact.height + given.unwrap_or(0.0) * contact.row.w;
    let distance =
        |contact: &Contact, found: &Vector4<f64>| (height(contact) - row(contact).dot(found)).abs();
    let mut found = Vector4::zeros();
    for round in 0..ROUNDS {
        let (mut normal, mut right) = (Matrix4::zeros(), Vector4::zeros());
        for contact in contacts {
            let row = row(contact);
            let weight = if round == 0 {
                1.0
            } else {
                OUTLIER / distance(contact, &found).max(OUTLIER)
            };
            normal += row * row.transpose() * weight;
            right += row * (height(contact) * weight);
        }
        // Contacts along one line leave the slope across it undetermined: the least-squares
        // solution of smallest norm is taken.
        let inverse = normal.svd(true, true);
        let least = 1e-9 * inverse.singular_values.max();
        found = inverse.solve(&right, least).ok()?;
    }
    let distances = contacts.iter().map(|contact| distance(contact, &found));
    let mut distances: Vec<f64> = distances.collect();
    let middle = distances.len() / 2;
    let off = *distances.select_nth_unstable_by(middle, f64::total_cmp).1;
    Some((given.unwrap_or(-found.w), off))
}
