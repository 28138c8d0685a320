//! Particles listed in CSV files: bare positions, or an estimate with fates.

use super::ParticleSourceError;
use std::fmt::Write;
use wisch::geometry::{Point2, Polygon, encloses};
use wisch::represent::{
    DirtArea, Fate, MAX_PARTICLES, Observation, ParticleDistribution, ParticleError,
};

/// Header of the lists that [`particles_to_csv`] writes of treated surfaces.
const TREATED_HEADER: [&str; 6] = ["particle", "x_m", "y_m", "fate", "edge", "passes"];
/// Header of the lists that [`particles_to_csv`] writes.
const ESTIMATE_HEADER: [&str; 5] = ["particle", "x_m", "y_m", "fate", "edge"];
/// Maximum absolute coordinate in a list, surface frame [m].
const MAX_POSITION: f64 = 100.0;
/// Distance from a border up to which a position counts as on it [m].
const BORDER: f64 = 1e-9;

/// Reads particles from a CSV text: two columns x and y \[m\] in the surface frame, without a header or with one that
/// names them in either order (`x,y`, `y_m,x_m`, `x [m],y [m]`; `x_mm,y_mm` or `x [mm],y [mm]` for millimetres); or a list with fates as
/// [`particles_to_csv`] writes it.
/// Lines that start with `#` are skipped.
///
/// Positions under objects of the scene are accepted.
///
/// # Errors
/// If a line is invalid, a particle on the surface is outside its outline, an edge does not exist, or the list is empty.
/// The error states `file` and line.
pub fn csv_particles(
    file: &str,
    text: &[u8],
    area: DirtArea<'_>,
) -> Result<ParticleDistribution, ParticleSourceError> {
    let rows = rows(file, text)?;
    let edges = area.outline.edges().count();
    for row in &rows {
        let at = |problem| ParticleSourceError::Line {
            file: file.to_owned(),
            line: row.line,
            problem,
        };
        match row.fate {
            Fate::OnSurface | Fate::Treated { .. } => {
                check_place(area.outline, row.position).map_err(at)?;
            }
            Fate::OffSurface { edge } if usize::from(edge) >= edges && row.fate != Fate::FALLEN => {
                return Err(at(format!(
                    "edge = {edge}, but the outline has {edges} edges (counted from 0)"
                )));
            }
            _ => {}
        }
    }
    distribution(&rows)
}

/// Reads an observation in the format of [`csv_particles`]; its detections are the particles on the surface. A header
/// without rows means that no dirt was detected. Detections may lie beside the surface, see
/// [`check_detections`](wisch::run::check_detections).
///
/// # Errors
/// If a line is invalid, or the text has neither a row nor a header. The error states `file` and line.
pub fn read_observed_list(file: &str, text: &[u8]) -> Result<Observation, ParticleSourceError> {
    match particles_from_csv(file, text) {
        Ok(particles) => Ok(Observation {
            detections: particles.remaining().collect(),
            ..Observation::default()
        }),
        Err(ParticleSourceError::EmptyList { .. }) => Ok(Observation::default()),
        Err(error) => Err(error),
    }
}

/// Formats particles as CSV with the columns `particle,x_m,y_m,fate,edge`: index, position in the surface frame \[m\], fate
/// (`on_surface`, `absorbed` or `off_surface`), and for `off_surface` the edge. For treated surfaces there is also the fate
/// `treated` and a column `passes`. Reading the text gives back the same bits.
///
/// ```
/// use wisch::{geometry::Point2, represent::ParticleDistribution};
/// use wisch_io::{particles_from_csv, particles_to_csv};
/// let crumbs = ParticleDistribution::new(&[Point2::new(0.1, -0.25)])?;
/// let text = particles_to_csv(&crumbs);
/// assert_eq!(text, "particle,x_m,y_m,fate,edge\n0,0.1,-0.25,on_surface,\n");
/// assert_eq!(particles_from_csv("estimate.csv", text.as_bytes())?, crumbs);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn particles_to_csv(particles: &ParticleDistribution) -> String {
    let is_treated = (particles.iter()).any(|(_, fate)| matches!(fate, Fate::Treated { .. }));
    let header: &[&str] = if is_treated {
        &TREATED_HEADER
    } else {
        &ESTIMATE_HEADER
    };
    let mut text = header.join(",") + "\n";
    for (particle, (position, fate)) in particles.iter().enumerate() {
        let (fate, edge) = match fate {
            Fate::OnSurface => ("on_surface", String::new()),
            Fate::Absorbed => ("absorbed", String::new()),
            Fate::OffSurface { edge } => ("off_surface", edge.to_string()),
            Fate::Treated { passes } => ("treated", format!(",{passes}")),
        };
        let edge = match fate {
            "treated" => edge,
            _ if is_treated => edge + ",",
            _ => edge,
        };
        let (x, y) = (position.x, position.y);
        // Writing to a String cannot fail.
        let _ = writeln!(text, "{particle},{x},{y},{fate},{edge}");
    }
    text
}

/// Reads particles that [`particles_to_csv`] has written; bare positions count as on the surface.
/// `file`: name in error messages.
///
/// # Errors
/// If a line is invalid or the list is empty; the error states file and line.
pub fn particles_from_csv(
    file: &str,
    text: &[u8],
) -> Result<ParticleDistribution, ParticleSourceError> {
    distribution(&rows(file, text)?)
}

/// Whether a position lies on the surface or on one of its borders; if not, the error says where it lies.
fn check_place(outline: &Polygon, position: Point2) -> Result<(), String> {
    let is_on_border = || {
        outline
            .edges()
            .any(|edge| edge.distance(position) <= BORDER)
    };
    if outline.contains(position) || is_on_border() {
        return Ok(());
    }
    let mut edges = outline.edges();
    let is_within: Vec<bool> = (outline.rings())
        .map(|ring| encloses(edges.by_ref().take(ring.len()), position))
        .collect();
    let place = format!("({}, {}) m", position.x, position.y);
    match is_within.iter().skip(1).position(|&within| within) {
        Some(hole) if is_within[0] => Err(format!(
            "{place} is in hole {} of the surface, where no dirt lies (holes are counted from 1, as in surface.holes_m or the mesh)",
            hole + 1
        )),
        _ => Err(format!("{place} is outside the surface's outline")),
    }
}

struct Row {
    line: u64,
    position: Point2,
    fate: Fate,
}

fn distribution(rows: &[Row]) -> Result<ParticleDistribution, ParticleSourceError> {
    let particles: Vec<_> = rows.iter().map(|row| (row.position, row.fate)).collect();
    Ok(ParticleDistribution::with_fates(&particles)?)
}

/// The columns of a list.
#[derive(Clone, Copy, PartialEq)]
enum Columns {
    /// x and y, in this order or the other.
    Positions {
        y_is_first: bool,
        /// Unit of the numbers per metre [1].
        per_metre: f64,
    },
    Estimate,
    Treated,
}

fn rows(file: &str, text: &[u8]) -> Result<Vec<Row>, ParticleSourceError> {
    let fault = |line: u64, problem: String| ParticleSourceError::Line {
        file: file.to_owned(),
        line,
        problem,
    };
    let text = text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text);
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .trim(csv::Trim::All)
        .comment(Some(b'#'))
        .from_reader(text);
    let mut columns = None;
    let mut rows = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|error| {
            let line = error.position().map_or(1, csv::Position::line);
            fault(line, error.to_string())
        })?;
        let line = record.position().map_or(1, csv::Position::line);
        let cells: Vec<&str> = record.iter().collect();
        let columns = match columns {
            Some(columns) => columns,
            None => {
                let header = header(&cells);
                let without_header = Columns::Positions {
                    y_is_first: false,
                    per_metre: 1.0,
                };
                let first = *columns.insert(header.unwrap_or(without_header));
                if header.is_some() {
                    continue;
                }
                first
            }
        };
        if rows.len() == MAX_PARTICLES {
            return Err(ParticleError::TooMany {
                count: rows.len() + 1,
            }
            .into());
        }
        let row = match columns {
            Columns::Positions {
                y_is_first,
                per_metre,
            } => position_row(&cells, y_is_first, per_metre),
            Columns::Estimate => estimate_row(&cells, rows.len()),
            Columns::Treated => treated_row(&cells, rows.len()),
        };
        let (position, fate) = row.map_err(|problem| fault(line, problem))?;
        rows.push(Row {
            line,
            position,
            fate,
        });
    }
    if rows.is_empty() {
        let file = file.to_owned();
        return Err(match columns {
            None => ParticleSourceError::Blank { file },
            Some(_) => ParticleSourceError::EmptyList { file },
        });
    }
    Ok(rows)
}

fn header(cells: &[&str]) -> Option<Columns> {
    if cells == ESTIMATE_HEADER {
        return Some(Columns::Estimate);
    }
    if cells == TREATED_HEADER {
        return Some(Columns::Treated);
    }
    let [first, second] = cells else {
        return None;
    };
    let (first, second) = (first.to_lowercase(), second.to_lowercase());
    for (suffix, per_metre) in [
        ("", 1.0),
        ("_m", 1.0),
        (" [m]", 1.0),
        ("_mm", 1e3),
        (" [mm]", 1e3),
    ] {
        let (x, y) = (format!("x{suffix}"), format!("y{suffix}"));
        let y_is_first = first == y && second == x;
        if y_is_first || (first == x && second == y) {
            return Some(Columns::Positions {
                y_is_first,
                per_metre,
            });
        }
    }
    None
}

fn position_row(
    cells: &[&str],
    y_is_first: bool,
    per_metre: f64,
) -> Result<(Point2, Fate), String> {
    let [first, second] = cells else {
        let has = |separator: char| cells.iter().any(|cell| cell.contains(separator));
        let hint = match cells {
            _ if has(';') => "the numbers are separated by semicolons",
            _ if has('\t') => "the numbers are separated by tabs",
            [_, _, ""] => "the line ends in a comma",
            [_] => "this line has no comma",
            _ => "other columns are not read",
        };
        return Err(format!(
            "{} columns, expected 2: x and y in metres, separated by a comma; {hint}",
            cells.len()
        ));
    };
    let (x, y) = if y_is_first {
        (second, first)
    } else {
        (first, second)
    };
    let position = Point2::new(
        read_length("x", x, per_metre)?,
        read_length("y", y, per_metre)?,
    );
    Ok((position, Fate::OnSurface))
}

fn estimate_row(cells: &[&str], expected: usize) -> Result<(Point2, Fate), String> {
    let [particle, x, y, fate, edge] = cells else {
        let (found, columns) = (cells.len(), ESTIMATE_HEADER.join(","));
        return Err(format!("{found} columns, expected 5: {columns}"));
    };
    if *particle != expected.to_string() {
        return Err(format!(
            "particle = {particle:?}, expected {expected}: particles are numbered from 0"
        ));
    }
    let position = Point2::new(coordinate("x_m", x)?, coordinate("y_m", y)?);
    let fate = match (*fate, *edge) {
        ("on_surface", "") => Fate::OnSurface,
        ("absorbed", "") => Fate::Absorbed,
        ("off_surface", edge) => Fate::OffSurface {
            edge: edge
                .parse()
                .map_err(|_| format!("edge = {edge:?} is not the index of an edge"))?,
        },
        ("on_surface" | "absorbed", edge) => {
            return Err(format!(
                "edge = {edge:?} is given, but only the fate off_surface has an edge"
            ));
        }
        (fate, _) => {
            return Err(format!(
                "fate = {fate:?}, expected on_surface, absorbed or off_surface"
            ));
        }
    };
    Ok((position, fate))
}

fn treated_row(cells: &[&str], expected: usize) -> Result<(Point2, Fate), String> {
    let [particle, x, y, fate, edge, passes] = cells else {
        let (found, columns) = (cells.len(), TREATED_HEADER.join(","));
        return Err(format!("{found} columns, expected 6: {columns}"));
    };
    if *fate != "treated" {
        return estimate_row(&[particle, x, y, fate, edge], expected);
    }
    let (position, _) = estimate_row(&[particle, x, y, "on_surface", edge], expected)?;
    match passes.parse::<f64>() {
        Ok(passes) if passes.is_finite() && passes >= 0.0 => {
            Ok((position, Fate::Treated { passes }))
        }
        _ => Err(format!("passes = {passes:?} is not a number of at least 0")),
    }
}

fn coordinate(column: &str, cell: &str) -> Result<f64, String> {
    read_length(column, cell, 1.0)
}

fn read_length(column: &str, cell: &str, per_metre: f64) -> Result<f64, String> {
    let value: f64 = cell
        .parse()
        .map_err(|_| format!("{column} = {cell:?} is not a number"))?;
    let value = value / per_metre;
    if value.is_finite() && value.abs() <= MAX_POSITION {
        Ok(value)
    } else {
        let hint = if value.is_finite() {
            "; name columns in millimetres x_mm and y_mm"
        } else {
            ""
        };
        Err(format!(
            "{column} = {value} m is outside its limits: at least -{MAX_POSITION} and at most {MAX_POSITION}{hint}"
        ))
    }
}
