//! Conversion of a round's telemetry to rows.

use super::rows::{Cell, Rows};
use wisch_memory::telemetry::PHASES;
use wisch_memory::{Telemetry, TelemetryError};

/// Number of rows that are decoded at once.
const PIECE: usize = 65_536;

/// Columns of an episode's file that are copied, in the order of the table's.
const TAKEN: [&str; 16] = [
    "commanded/x",
    "commanded/y",
    "commanded/z",
    "measured/x",
    "measured/y",
    "measured/z",
    "measured/qx",
    "measured/qy",
    "measured/qz",
    "measured/qw",
    "external/fx",
    "external/fy",
    "external/fz",
    "external/mx",
    "external/my",
    "external/mz",
];

/// Values that all rows of a round share.
pub(super) struct Of<'a> {
    /// Name of the robot.
    pub robot: &'a str,
    /// Day on which the episode began, days since 1970.
    pub day: i32,
    /// Name of the episode.
    pub episode: &'a str,
    /// Number of the round, from 1.
    pub round: i32,
    /// Start of the round [s since 1970].
    pub start: f64,
}

/// Adds the telemetry of a round. Columns that a log lacks are null.
pub(super) fn add(rows: &mut Rows, of: &Of<'_>, log: &Telemetry) -> Result<(), TelemetryError> {
    let known = log.columns();
    for begin in (0..log.rows()).step_by(PIECE) {
        let piece = begin..(begin + PIECE).min(log.rows());
        let read = |name: &str| -> Result<Option<Vec<f64>>, TelemetryError> {
            let is_known = known.binary_search(&name).is_ok();
            is_known
                .then(|| log.values(name, piece.clone()))
                .transpose()
        };
        let times = log.times(piece.clone())?;
        let [motions, strokes, phases] = ["motion", "stroke", "phase"].map(read);
        let [motions, strokes, phases] = [motions?, strokes?, phases?];
        let taken = TAKEN.iter().map(|name| read(name));
        let taken: Vec<Option<Vec<f64>>> = taken.collect::<Result<_, _>>()?;
        for (row, time) in times.iter().enumerate() {
            let code = |column: &Option<Vec<f64>>| column.as_ref().map(|v| v[row] as i32);
            let phase = code(&phases).and_then(|code| PHASES.get(usize::try_from(code).ok()?));
            let mut cells = vec![
                Cell::Text(Some(of.robot)),
                Cell::Day(of.day),
                Cell::Text(Some(of.episode)),
                Cell::Whole(Some(of.round)),
                Cell::Number(Some(of.start + time)),
                Cell::Number(Some(*time)),
                Cell::Whole(code(&motions)),
                Cell::Whole(code(&strokes)),
                Cell::Text(phase.copied()),
            ];
            let values = taken
                .iter()
                .map(|column| column.as_ref().map(|v| v[row] as f32));
            cells.extend(values.map(Cell::Single));
            rows.push(&cells);
        }
    }
    Ok(())
}
