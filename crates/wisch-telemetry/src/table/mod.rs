//! Logs as tables: text with a line of names, or named columns in a binary file.

mod arrow;
#[cfg(feature = "arrow")]
mod arrow_file;
mod cell;
mod columnar;
mod delimited;
mod known;
mod layout;
mod names;
mod npz;
mod orientation;
mod parquet_file;
mod source;
mod times;

pub use self::columnar::catches_panics;

use self::cell::Cell;
use self::layout::Layout;
use self::names::UnitKind;
use self::source::Source;
use self::times::Instant;
use super::error::ReadFault;
use super::frames::Frames;
use super::options::{LogOptions, OrientationForm};
use super::quantity::{Quantity, QuantityError};
use super::track::{JointPositions, RawLog, Track};
use wisch::geometry::Vector3;

/// Angles above this value are degrees [rad].
const MOST_RADIANS: f64 = 2.0 * std::f64::consts::PI + 0.01;

/// Positions beside KUKA's angles above this distance are millimetres [m]: no arm reaches that far.
const MOST_METRES: f64 = 20.0;

/// Reads a table: text with comments, names, optional units, and numbers; or a binary file of columns.
pub(crate) fn read(bytes: &[u8], options: &LogOptions) -> Result<RawLog, ReadFault> {
    let (source, layout) = Source::open(bytes, options)?;
    let mut table = Table {
        scales: vec![1.0; layout.columns.len()],
        remarks: layout.remarks.clone(),
        has_units_line: false,
        source,
        layout,
        options,
    };
    table.read_units()?;
    let times = table.survey()?;
    table.collect(&times)
}

/// Whether a cell states a number with decimals.
fn is_decimal(cell: &Cell<'_>) -> bool {
    cell.number().is_some_and(|number| number.fract() != 0.0)
}

/// Callback that receives a row of numbers: its number and its cells.
type TakeNumbers<'a> = dyn FnMut(usize, &[Cell<'_>]) -> Result<(), ReadFault> + 'a;

/// A table with the meaning of its columns.
struct Table<'a> {
    source: Source<'a>,
    layout: Layout,
    options: &'a LogOptions,
    /// Factor for the numbers of each column; for times, the unit [s].
    scales: Vec<f64>,
    /// Whether the first row states units.
    has_units_line: bool,
    remarks: Vec<String>,
}

impl Table<'_> {
    /// Reads the units in names and in a line of units, except where the options state them.
    fn read_units(&mut self) -> Result<(), ReadFault> {
        let indices = self.layout.indices();
        let mut first: Vec<String> = Vec::new();
        let mut is_units = false;
        self.source.visit_rows(&indices, &mut |_, cells| {
            is_units = (cells.iter()).any(|cell| !matches!(cell, Cell::Empty))
                && cells
                    .iter()
                    .zip(&self.layout.columns)
                    .all(|(cell, column)| {
                        let is_time =
                            column.kind == UnitKind::Time && Instant::parse(cell).is_some();
                        !is_time && cell.number().is_none()
                    });
            first = cells.iter().map(|cell| cell.text().into_owned()).collect();
            Ok(false)
        })?;
        self.has_units_line = is_units;
        let (mut by_line, mut by_name, mut unknown) = (Vec::new(), Vec::new(), Vec::new());
        for (index, column) in self.layout.columns.iter_mut().enumerate() {
            let given = match column.kind {
                UnitKind::Time => self.options.time_unit,
                UnitKind::Length => self.options.length_unit,
                UnitKind::Force => self.options.force_unit,
                UnitKind::Angle | UnitKind::None => None,
            };
            // `combine` applies units of length and force from the options.
            if let (Some(unit), UnitKind::Time) = (given, column.kind) {
                self.scales[index] = unit;
            }
            if given.is_some() || column.kind == UnitKind::None {
                continue;
            }
            let stated = first.get(index).filter(|_| is_units);
            let stated = stated.map(|text| text.trim_matches(['[', ']', '(', ')']).trim());
            let (text, list) = match (stated.filter(|text| !text.is_empty()), &column.unit) {
                (Some(text), _) => (text.to_owned(), &mut by_line),
                (None, Some(unit)) => (unit.text.clone(), &mut by_name),
                (None, None) => continue,
            };
            let remark = format!("{} in {text}", column.ours);
            match column.kind.size_of(&text) {
                Some(size) => {
                    self.scales[index] = size;
                    column.is_unit_known = true;
                    list.push(remark);
                }
                None => unknown.push(remark),
            }
        }
        let partly = self.describe_partly_stated();
        let mut add_remark = |what: &str, list: Vec<String>| {
            if !list.is_empty() {
                self.remarks.push(format!("{what}: {}", list.join(", ")));
            }
        };
        add_remark("from its line of units", by_line);
        add_remark("from its names of columns", by_name);
        add_remark(
            "its units include unknown ones, which are read as SI units",
            unknown,
        );
        self.remarks.extend(partly);
        Ok(())
    }

    /// Names the columns that state no unit beside others of their quantity that do.
    fn describe_partly_stated(&self) -> Option<String> {
        let kinds = [
            (UnitKind::Length, "metres"),
            (UnitKind::Force, "newtons"),
            (UnitKind::Angle, "radians"),
        ];
        let open = kinds.into_iter().filter_map(|(kind, unit)| {
            let columns = &self.layout.columns[self.layout.columns_of_kind(kind)];
            let open: Vec<&str> = (columns.iter().filter(|column| !column.is_unit_known))
                .map(|column| column.ours)
                .collect();
            let is_partly = !open.is_empty() && open.len() < columns.len();
            is_partly.then(|| format!("{} in {unit}", open.join(", ")))
        });
        let open: Vec<String> = open.collect();
        (!open.is_empty()).then(|| {
            format!(
                "read as {}: the log states no unit for these columns, but one for other columns of the same quantity",
                open.join(" and ")
            )
        })
    }

    /// Calls `take` with the number and the requested cells of each row of numbers.
    fn visit_rows(&self, columns: &[usize], take: &mut TakeNumbers<'_>) -> Result<(), ReadFault> {
        let indices: Vec<usize> = (columns.iter())
            .map(|&column| self.layout.columns[column].index)
            .collect();
        let mut is_units = self.has_units_line;
        self.source.visit_rows(&indices, &mut |row, cells| {
            if !std::mem::take(&mut is_units) {
                take(row, cells)?;
            }
            Ok(true)
        })
    }

    /// First pass: reads the times [ns], and finds the units that only the size of the numbers reveals.
    fn survey(&mut self) -> Result<Vec<Option<i64>>, ReadFault> {
        let layout = &self.layout;
        let angles = layout.angles();
        let lengths = layout.columns_of_kind(UnitKind::Length);
        let time = layout.columns_of_kind(UnitKind::Time);
        let wanted: Vec<usize> = time
            .clone()
            .chain(angles.clone())
            .chain(lengths.clone())
            .collect();
        let part = layout.part_of_second;
        let mut instants = Vec::new();
        let mut rows = Vec::new();
        // Whether the second column holds parts of a second, by the first row.
        let mut is_split = time.len() > 1;
        let [mut largest_angle, mut largest_length] = [0.0_f64; 2];
        let (first_angle, first_length) = (time.len(), time.len() + angles.len());
        self.visit_rows(&wanted, &mut |row, cells| {
            let largest = |cells: &[Cell<'_>], most: f64| {
                let sizes = cells.iter().filter_map(Cell::number).map(f64::abs);
                sizes.filter(|size| size.is_finite()).fold(most, f64::max)
            };
            largest_angle = largest(&cells[first_angle..first_length], largest_angle);
            largest_length = largest(&cells[first_length..], largest_length);
            rows.push(row);
            instants.push(match &cells[..first_angle] {
                [] | [Cell::Empty, ..] | [_, Cell::Empty] => None,
                [cell] => match Instant::parse(cell) {
                    None => return Err(self.not_a_number(row, wanted[0], cell)),
                    instant => instant,
                },
                [seconds, parts, ..] => match Instant::join(seconds, parts, part) {
                    Ok(joined) if is_split => Some(joined),
                    // The first column states whole times.
                    _ if !is_split || (instants.is_empty() && is_decimal(seconds)) => {
                        is_split = false;
                        Instant::parse(seconds)
                    }
                    Ok(_) => None,
                    Err(fault) => return Err(self.split_time_fault(row, fault, &cells[fault])),
                },
            });
            Ok(())
        })?;
        self.assume_angles(largest_angle);
        let is_kuka = self.layout.form == OrientationForm::Abc;
        let is_given = (lengths.clone()).any(|column| self.layout.columns[column].is_unit_known);
        if is_kuka
            && largest_length > MOST_METRES
            && !is_given
            && self.options.length_unit.is_none()
        {
            for column in lengths {
                self.scales[column] = 1e-3;
            }
            self.remarks.push(format!(
                "positions are read as millimetres, because a position beside the angles A, B, C is {largest_length:.0}; --length-unit-m states another unit"
            ));
        }
        if let Some(rate) = self.options.rate {
            self.remarks
                .push(format!("times by --rate: {rate} samples per second"));
            return Ok(times::at_rate(rows.len(), rate)
                .into_iter()
                .map(Some)
                .collect());
        }
        let given = time.clone().next().filter(|&column| {
            self.options.time_unit.is_some() || self.layout.columns[column].is_unit_known
        });
        let given = if is_split {
            if self.options.time_unit.is_some() {
                let unused = "--time-unit-s is not used: times stand in columns of seconds and of parts of a second";
                self.remarks.push(unused.to_owned());
            }
            Some(1.0)
        } else {
            given.map(|column| self.scales[column])
        };
        if time.len() > 1 && !is_split {
            let column = &self.layout.columns[time.start + 1];
            self.remarks.push(format!(
                "the column of seconds states whole times, so that column {:?} is ignored",
                self.source.names()[column.index]
            ));
        }
        let scaled = times::scale_times(&instants, given)
            .map_err(|fault| fault.into_read_fault(|index| self.source.place(rows[index])))?;
        self.remarks.extend(scaled.remarks);
        Ok(scaled.times)
    }

    /// States which quantities are read in SI units because nothing states their unit.
    fn describe_assumed_units(&self) -> Option<String> {
        let is_open = |kind, given: Option<f64>| {
            let mut columns = self.layout.columns_of_kind(kind);
            given.is_none()
                && !columns.is_empty()
                && columns.all(|column| {
                    !self.layout.columns[column].is_unit_known && self.scales[column] == 1.0
                })
        };
        let open: Vec<&str> = [
            (
                UnitKind::Length,
                self.options.length_unit,
                "positions in metres",
            ),
            (
                UnitKind::Force,
                self.options.force_unit,
                "forces in newtons",
            ),
            (UnitKind::Angle, None, "angles in radians"),
        ]
        .into_iter()
        .filter_map(|(kind, given, read)| is_open(kind, given).then_some(read))
        .collect();
        let (last, others) = open.split_last()?;
        let open = match others {
            [] => (*last).to_owned(),
            _ => format!("{} and {last}", others.join(", ")),
        };
        Some(format!("read as {open}: the log states no unit"))
    }

    /// Converts angles to radians where no unit is stated.
    fn assume_angles(&mut self, largest: f64) {
        let angles = self.layout.angles();
        let is_stated = (angles.clone()).any(|column| self.layout.columns[column].is_unit_known);
        let are_degrees = match self.layout.form {
            _ if angles.is_empty() || is_stated => return,
            OrientationForm::Abc => true,
            _ => largest > MOST_RADIANS,
        };
        if are_degrees {
            let first = &self.layout.columns[angles.start].ours;
            let last = &self.layout.columns[angles.end - 1].ours;
            self.remarks.push(match self.layout.form {
                OrientationForm::Abc => format!("angles {first} to {last} are read as degrees"),
                _ => format!(
                    "angles {first} to {last} are read as degrees, because one is {largest:.1}"
                ),
            });
            for column in angles {
                self.scales[column] = std::f64::consts::PI / 180.0;
            }
        }
    }

    /// Second pass: reads poses and forces.
    fn collect(mut self, times: &[Option<i64>]) -> Result<RawLog, ReadFault> {
        let window = self.options.reorder_window;
        let mut poses = Track::new("the table's pose".to_owned(), window);
        let mut wrenches = Track::new("the table's force".to_owned(), window);
        let first = self.layout.columns_of_kind(UnitKind::Time).len();
        let wanted: Vec<usize> = (first..self.layout.columns.len()).collect();
        let pose_len = 3 + self.layout.form.names().len();
        let (mut without_time, mut number) = (0_usize, 0);
        self.visit_rows(&wanted, &mut |row, cells| {
            let time = times.get(number).copied().flatten();
            number += 1;
            let place = || self.source.place(row);
            let (pose, force) = cells.split_at(pose_len);
            let pose = self.numbers(row, first, pose)?;
            let force = self.numbers(row, first + pose_len, force)?;
            let Some(time) = time else {
                without_time += 1;
                return Ok(());
            };
            let form = self.layout.form;
            if let Some(pose) = pose {
                let pose = pose.and_then(|numbers| orientation::pose(form, &numbers));
                poses.push(time, pose, place)?;
            }
            if let Some(force) = force {
                wrenches.push(
                    time,
                    force.and_then(|numbers| Vector3::from_numbers(&numbers)),
                    place,
                )?;
            }
            Ok(())
        })?;
        if without_time > 0 {
            self.remarks.push(format!(
                "left out: {without_time} of {number} rows, which state no time"
            ));
        }
        let (poses, mut wrenches) = (poses.finish()?, wrenches.finish()?);
        // A row with a pose and a force is left out once.
        wrenches.repeated = wrenches.repeated.saturating_sub(poses.repeated);
        if poses.entries.is_empty() && wrenches.entries.is_empty() {
            return Err(ReadFault::Empty);
        }
        self.remarks
            .extend(poses.reordering().or_else(|| wrenches.reordering()));
        if self.source.has_decimal_commas() {
            self.remarks
                .push("commas are read as decimal points".to_owned());
        }
        let assumed_units = self.describe_assumed_units();
        let unfinished = self.source.is_cut_off();
        if unfinished {
            self.remarks
                .push("left out: the last line, which is incomplete".to_owned());
        }
        Ok(RawLog {
            poses,
            wrenches,
            frames: Frames::default(),
            joints: JointPositions::default(),
            task: None,
            surface_mesh: None,
            press_force_n: None,
            round: None,
            looks: [None, None],
            qualities: Vec::new(),
            axes: self.layout.axes.map(|axes| axes.as_str().to_owned()),
            sign: self.layout.sign,
            remarks: self.remarks,
            assumed_units,
            start: None,
            unfinished,
        })
    }

    /// Reads the numbers of a quantity in SI units, from column `first` of the columns that are read. Returns `None` if
    /// all its cells are empty.
    fn numbers(
        &self,
        row: usize,
        first: usize,
        cells: &[Cell<'_>],
    ) -> Result<Option<Result<Vec<f64>, QuantityError>>, ReadFault> {
        if cells.iter().all(|cell| matches!(cell, Cell::Empty)) {
            return Ok(None);
        }
        let mut numbers = Vec::with_capacity(cells.len());
        let mut missing = None;
        for (column, cell) in (first..).zip(cells) {
            match (cell, cell.number()) {
                (_, Some(number)) => numbers.push(number * self.scales[column]),
                (Cell::Empty, None) => missing = Some(self.layout.columns[column].ours),
                (_, None) => return Err(self.not_a_number(row, column, cell)),
            }
        }
        Ok(Some(match missing {
            Some(name) => Err(QuantityError::Missing { name }),
            None => Ok(numbers),
        }))
    }

    /// Describes a cell of the seconds (`part` 0) or the nanoseconds (1) of a time.
    fn split_time_fault(&self, row: usize, part: usize, cell: &Cell<'_>) -> ReadFault {
        ReadFault::SplitTime {
            place: self.source.place(row),
            column: self.source.names()[self.layout.columns[part].index].clone(),
            text: cell.text().into_owned(),
            expected: match (part, self.layout.part_of_second) {
                (0, _) => "seconds",
                (_, 1) => "nanoseconds, from 0 to 999999999",
                _ => "microseconds, from 0 to 999999",
            },
        }
    }

    fn not_a_number(&self, row: usize, column: usize, cell: &Cell<'_>) -> ReadFault {
        ReadFault::NotANumber {
            place: self.source.place(row),
            column: self.source.names()[self.layout.columns[column].index].clone(),
            text: cell.text().into_owned(),
        }
    }
}
