//! Logs as tables of numbers, with a line of names above them.

use super::error::ReadFault;
use super::frames::Frames;
use super::options::LogOptions;
use super::quantity::Quantity;
use super::ros2::NANOSECONDS_PER_SECOND;
use super::track::{JointPositions, RawLog, Track, UnitsLine};
use wisch::geometry::{Pose, Vector3};
use wisch::represent::UnknownName;

/// What the time is called.
const TIME: &str = "t";

/// Longest time that a table may tell [s]: with nanoseconds, what an integer holds.
const MAX_TIME: f64 = 9e9;

/// How a line is split.
#[derive(Debug, Clone, Copy)]
enum Separator {
    Character(char),
    Space,
}

impl Separator {
    /// Told by the line of names.
    fn of(names: &str) -> Self {
        [',', ';', '\t']
            .into_iter()
            .find(|&separator| names.contains(separator))
            .map_or(Self::Space, Self::Character)
    }

    fn split(self, line: &str) -> Vec<&str> {
        match self {
            Self::Character(separator) => line.split(separator).map(plain).collect(),
            Self::Space => line.split_whitespace().map(plain).collect(),
        }
    }
}

/// Without spaces and quotes round it.
fn plain(text: &str) -> &str {
    text.trim().trim_matches('"').trim()
}

/// A column: its name in the table, and its index.
struct Column {
    name: String,
    index: usize,
}

/// Our names of all columns that are read: time, pose, force.
fn column_names() -> impl Iterator<Item = &'static str> {
    let quantities = Pose::NUMBERS.iter().chain(Vector3::NUMBERS).copied();
    std::iter::once(TIME).chain(quantities)
}

/// Reads a table. Lines that begin with a hash are comments, unless the names stand in one; a line of units may
/// follow the names.
pub(crate) fn read(bytes: &[u8], options: &LogOptions) -> Result<RawLog, ReadFault> {
    let text = std::str::from_utf8(bytes).map_err(|error| ReadFault::NotText {
        byte: error.valid_up_to(),
    })?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut lines = (text.lines().enumerate())
        .map(|(index, line)| (index + 1, line.trim()))
        .filter(|(_, line)| !line.is_empty());
    let (_, names) = lines.next().ok_or(ReadFault::Empty)?;
    let names = names.trim_start_matches('#');
    let separator = Separator::of(names);
    let columns = columns(&separator.split(names), &options.columns)?;

    let mut poses = Track::new("the table's pose".to_owned());
    let mut wrenches = Track::new("the table's force".to_owned());
    let mut is_first = true;
    let mut units = None;
    let mut scales = vec![1.0; columns.len()];
    for (line, text) in lines.filter(|(_, line)| !line.starts_with('#')) {
        let values = separator.split(text);
        let may_be_units = std::mem::take(&mut is_first);
        if may_be_units && are_units(&values, &columns) {
            let (said, sizes) = units_line(&values, &columns, options);
            (units, scales) = (Some(said), sizes);
            continue;
        }
        let mut numbers = numbers(line, &values, &columns)?;
        for (number, scale) in numbers.iter_mut().zip(&scales) {
            *number *= scale;
        }
        let time = nanoseconds(line, numbers[0] * options.time_unit.unwrap_or(1.0))?;
        let (pose, force) = numbers[1..].split_at(Pose::NUMBERS.len());
        let place = || format!("line {line}");
        poses.push(time, Pose::from_numbers(pose), place)?;
        wrenches.push(time, Vector3::from_numbers(force), place)?;
    }
    let (poses, wrenches) = (poses.filled()?, wrenches.filled()?);
    if poses.entries.is_empty() {
        return Err(ReadFault::Empty);
    }
    Ok(RawLog {
        poses,
        wrenches,
        frames: Frames::default(),
        joints: JointPositions::default(),
        task: None,
        round: None,
        looks: [None, None],
        units,
        axes: None,
        start: None,
        unfinished: false,
    })
}

/// Where each of our columns is.
fn columns(names: &[&str], renamed: &[(String, String)]) -> Result<Vec<Column>, ReadFault> {
    let unknown = |name: &str, known: &mut dyn Iterator<Item = &str>| {
        let known: Vec<String> = known.map(str::to_owned).collect();
        ReadFault::Unknown(UnknownName::new(
            "column",
            name,
            known.iter().map(String::as_str),
        ))
    };
    for (ours, _) in renamed {
        if !column_names().any(|name| name == ours) {
            return Err(unknown(ours, &mut column_names()));
        }
    }
    column_names()
        .map(|ours| {
            let renamed = renamed.iter().find(|(name, _)| name == ours);
            let name = renamed.map_or(ours, |(_, theirs)| theirs);
            let is_it = |candidate: &&&str| match renamed {
                Some(_) => **candidate == name,
                None => candidate.eq_ignore_ascii_case(name),
            };
            let found = names
                .iter()
                .enumerate()
                .find(|(_, candidate)| is_it(candidate));
            match found {
                Some((index, name)) => Ok(Column {
                    name: (*name).to_owned(),
                    index,
                }),
                None => Err(unknown(name, &mut names.iter().copied())),
            }
        })
        .collect()
}

/// What a line of units says of the columns that are read, and by what their numbers are to be multiplied. Of what the
/// options give a unit for, the line says nothing.
fn units_line(values: &[&str], columns: &[Column], options: &LogOptions) -> (UnitsLine, Vec<f64>) {
    let mut said = UnitsLine {
        units: Vec::new(),
        unknown: Vec::new(),
    };
    let scale = |(ours, column): (&str, &Column)| {
        let text = values.get(column.index).copied().unwrap_or_default();
        let unit = text.trim_matches(['[', ']', '(', ')']);
        let (known, given): (&[(&str, f64)], _) = match ours {
            TIME => (&TIME_UNITS, options.time_unit),
            "x" | "y" | "z" => (&LENGTH_UNITS, options.length_unit),
            "fx" | "fy" | "fz" => (&FORCE_UNITS, options.force_unit),
            _ => return 1.0,
        };
        if unit.is_empty() || given.is_some() {
            return 1.0;
        }
        let found = known.iter().find(|(name, _)| *name == unit);
        let list = match found {
            Some(_) => &mut said.units,
            None => &mut said.unknown,
        };
        list.push((ours.to_owned(), unit.to_owned()));
        found.map_or(1.0, |(_, size)| *size)
    };
    let scales = column_names().zip(columns).map(scale).collect();
    (said, scales)
}

/// Units of time [s], length [m] and force [N] that a line of units may name.
const TIME_UNITS: [(&str, f64); 8] = [
    ("s", 1.0),
    ("sec", 1.0),
    ("ms", 1e-3),
    ("us", 1e-6),
    ("µs", 1e-6),
    ("ns", 1e-9),
    ("min", 60.0),
    ("h", 3600.0),
];
const LENGTH_UNITS: [(&str, f64); 5] = [
    ("m", 1.0),
    ("cm", 1e-2),
    ("mm", 1e-3),
    ("um", 1e-6),
    ("in", 0.0254),
];
const FORCE_UNITS: [(&str, f64); 6] = [
    ("N", 1.0),
    ("kN", 1e3),
    ("mN", 1e-3),
    ("kp", 9.80665),
    ("kgf", 9.80665),
    ("lbf", 4.448_221_615_260_5),
];

/// Whether none of the values that are read is a number.
fn are_units(values: &[&str], columns: &[Column]) -> bool {
    let is_number = |column: &Column| {
        (values.get(column.index)).is_some_and(|value| value.parse::<f64>().is_ok())
    };
    !columns.iter().any(is_number)
}

fn numbers(line: usize, values: &[&str], columns: &[Column]) -> Result<Vec<f64>, ReadFault> {
    let number = |column: &Column| {
        let text = values
            .get(column.index)
            .ok_or_else(|| ReadFault::ShortLine {
                line,
                count: values.len(),
                column: column.name.clone(),
                needed: column.index + 1,
            })?;
        text.parse().map_err(|_| ReadFault::NotANumber {
            line,
            column: column.name.clone(),
            text: (*text).to_owned(),
        })
    };
    columns.iter().map(number).collect()
}

fn nanoseconds(line: usize, time: f64) -> Result<i64, ReadFault> {
    if time.is_finite() && time.abs() <= MAX_TIME {
        return Ok((time * NANOSECONDS_PER_SECOND as f64).round() as i64);
    }
    Err(ReadFault::Time {
        line,
        time,
        limit: MAX_TIME,
    })
}
