//! Reader of telemetry by column and time: it decodes only what is requested, and caches it.

use super::cache::{Piece, PieceCache, Place};
use super::{
    FIXED, JOINTS_KEY, NANOSECONDS_PER_SECOND, NOTE_PREFIX, SCHEMA_KEY, STAMP, TELEMETRY_SCHEMA,
    TIME, TelemetryError, seconds,
};
use crate::checked_file::CheckedFile;
use crate::columns::{find_column, open, read_chunk};
use parquet::data_type::{FloatType, Int32Type, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::reader::FileReader;
use parquet::file::serialized_reader::SerializedFileReader;
use parquet::file::statistics::Statistics;
use std::collections::{BTreeMap, HashMap};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Size of the cache [bytes]: an hour of 13 joints at 1 kHz takes 190 MB.
const CACHE_BYTES: usize = 256 << 20;

/// Values of a column over an interval.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Series {
    /// Times since the round began \[s\].
    pub times: Vec<f64>,
    /// The values at these times, in the column's unit.
    pub values: Vec<f64>,
}

/// The telemetry of a round, as columns in a file.
///
/// Opening reads only the footer. Any number of threads may read.
pub struct Telemetry {
    path: PathBuf,
    joints: Vec<String>,
    notes: BTreeMap<String, String>,
    columns: HashMap<String, usize>,
    groups: Vec<Group>,
    /// The file has one cursor, so threads read one after the other.
    file: Mutex<Source>,
}

struct Source {
    reader: SerializedFileReader<CheckedFile>,
    cache: PieceCache,
}

/// A row group.
#[derive(Debug, Clone, PartialEq)]
struct Group {
    rows: Range<usize>,
    /// First and last time [ns].
    times: [i64; 2],
}

impl Telemetry {
    /// Opens a telemetry file and reads its footer.
    ///
    /// # Errors
    /// If the file cannot be read, is cut off, or was not written by [`TelemetryWriter`](super::TelemetryWriter).
    pub fn open(path: &Path) -> Result<Self, TelemetryError> {
        Self::open_checked(path, None)
    }

    /// Opens a file with the check sums of all its blocks, which are verified as the blocks are read.
    pub(crate) fn open_checked(
        path: &Path,
        sums: Option<Vec<u32>>,
    ) -> Result<Self, TelemetryError> {
        let file = CheckedFile::open(path, sums).map_err(|error| TelemetryError::File {
            path: path.to_path_buf(),
            error,
        })?;
        let reader = open(file).map_err(|error| at(path, "footer", error))?;
        let foreign = |what: String| TelemetryError::Foreign {
            path: path.to_path_buf(),
            what,
        };
        let metadata = reader.metadata().file_metadata().key_value_metadata();
        let metadata: BTreeMap<&str, &str> = metadata
            .into_iter()
            .flatten()
            .filter_map(|entry| Some((entry.key.as_str(), entry.value.as_deref()?)))
            .collect();
        match metadata.get(SCHEMA_KEY) {
            None => return Err(foreign("this is not telemetry of wisch".to_owned())),
            Some(schema) if schema.parse() == Ok(TELEMETRY_SCHEMA) => {}
            Some(schema) => {
                return Err(foreign(format!(
                    "schema {schema} is not supported; this program reads {TELEMETRY_SCHEMA}"
                )));
            }
        }
        let joints = metadata.get(JOINTS_KEY).copied().unwrap_or("[]");
        let joints = serde_json::from_str(joints)
            .map_err(|error| foreign(format!("{JOINTS_KEY}: {error}")))?;
        let notes = metadata.iter().filter_map(|(key, value)| {
            let key = key.strip_prefix(NOTE_PREFIX)?;
            Some((key.to_owned(), (*value).to_owned()))
        });
        let notes = notes.collect();
        for (place, (name, _)) in FIXED.iter().enumerate() {
            if find_column(&reader, name) != Some(place) {
                return Err(foreign(format!("column {place} is not {name:?}")));
            }
        }
        let schema = reader.metadata().file_metadata().schema_descr();
        let columns = (schema.columns().iter().enumerate())
            .map(|(place, column)| (column.name().to_owned(), place))
            .collect();
        Ok(Self {
            groups: groups(&reader).map_err(|error| at(path, "footer", error))?,
            path: path.to_path_buf(),
            joints,
            notes,
            columns,
            file: Mutex::new(Source {
                reader,
                cache: PieceCache::new(CACHE_BYTES),
            }),
        })
    }

    /// Path of the file from which the telemetry is read.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Names of the robot's variables, in the order of its model.
    pub fn joints(&self) -> &[String] {
        &self.joints
    }

    /// Notes that the writer added, by name.
    pub fn notes(&self) -> &BTreeMap<String, String> {
        &self.notes
    }

    /// Returns the names of the columns, sorted.
    pub fn columns(&self) -> Vec<&str> {
        let mut names: Vec<&str> = self.columns.keys().map(String::as_str).collect();
        names.sort_unstable();
        names
    }

    /// Number of rows, one per sample.
    pub fn rows(&self) -> usize {
        self.groups.last().map_or(0, |group| group.rows.end)
    }

    /// Times of the first and last sample \[s\]; `None` without samples.
    pub fn interval(&self) -> Option<[f64; 2]> {
        let (first, last) = (self.groups.first()?, self.groups.last()?);
        Some([seconds(first.times[0]), seconds(last.times[1])])
    }

    /// Returns the rows with times in an interval \[s\], both ends included.
    ///
    /// # Errors
    /// If the file is damaged.
    pub fn rows_between(&self, [from, to]: [f64; 2]) -> Result<Range<usize>, TelemetryError> {
        let first = nanoseconds(from);
        let start = self.row_after(|time| time >= first)?;
        let last = nanoseconds(to);
        let end = self.row_after(|time| time > last)?;
        Ok(start..end.max(start))
    }

    /// Returns the row nearest to a time \[s\]; `None` without rows.
    ///
    /// # Errors
    /// If the file is damaged.
    pub fn nearest_row(&self, time: f64) -> Result<Option<usize>, TelemetryError> {
        let Some(last) = self.rows().checked_sub(1) else {
            return Ok(None);
        };
        let wanted = nanoseconds(time);
        let after = self.row_after(|time| time >= wanted)?.min(last);
        let Some(before) = after.checked_sub(1) else {
            return Ok(Some(after));
        };
        let [before_time, after_time] = [self.time_at(before)?, self.time_at(after)?];
        let is_before = wanted.saturating_sub(before_time) < after_time.saturating_sub(wanted);
        Ok(Some(if is_before { before } else { after }))
    }

    /// Returns the time of a row \[s\].
    ///
    /// # Errors
    /// If the file is damaged.
    ///
    /// # Panics
    /// If the row does not exist.
    pub fn time(&self, row: usize) -> Result<f64, TelemetryError> {
        self.time_at(row).map(seconds)
    }

    /// Returns the times of rows \[s\].
    ///
    /// # Errors
    /// If the file is damaged.
    pub fn times(&self, rows: Range<usize>) -> Result<Vec<f64>, TelemetryError> {
        self.values("time", rows)
    }

    /// Returns the values of a column in some rows, in its unit; times in seconds, NaN for a stamp that is not stated.
    ///
    /// # Errors
    /// If the column does not exist, or the file is damaged.
    pub fn values(&self, column: &str, rows: Range<usize>) -> Result<Vec<f64>, TelemetryError> {
        let column = self.column(column)?;
        let mut values = Vec::with_capacity(rows.len());
        let first = self
            .groups
            .partition_point(|group| group.rows.end <= rows.start);
        let mut source = self.source();
        for (index, group) in self.groups.iter().enumerate().skip(first) {
            if group.rows.start >= rows.end {
                break;
            }
            let from = rows.start.max(group.rows.start) - group.rows.start;
            let to = rows.end.min(group.rows.end) - group.rows.start;
            match source.piece(&self.path, (index, column))? {
                Piece::Times(piece) => {
                    let stated = |time: i64| if time < 0 { f64::NAN } else { seconds(time) };
                    values.extend(piece[from..to].iter().map(|&time| stated(time)));
                }
                Piece::Codes(piece) => values.extend(piece[from..to].iter().map(|&c| f64::from(c))),
                Piece::Singles(piece) => {
                    values.extend(piece[from..to].iter().map(|&v| f64::from(v)));
                }
            }
        }
        Ok(values)
    }

    /// Returns a column over an interval \[s\], both ends included.
    ///
    /// # Errors
    /// If the column does not exist, or the file is damaged.
    pub fn series(&self, column: &str, interval: [f64; 2]) -> Result<Series, TelemetryError> {
        // Checked first, so that a wrong name is an error even for an empty interval.
        self.column(column)?;
        let rows = self.rows_between(interval)?;
        Ok(Series {
            times: self.times(rows.clone())?,
            values: self.values(column, rows)?,
        })
    }

    /// Returns the values of some columns in one row.
    ///
    /// # Errors
    /// If a column does not exist, or the file is damaged.
    ///
    /// # Panics
    /// If the row does not exist.
    pub fn row(&self, columns: &[&str], row: usize) -> Result<Vec<f64>, TelemetryError> {
        let values = columns.iter().map(|column| {
            let values = self.values(column, row..row + 1)?;
            Ok(values[0])
        });
        values.collect()
    }

    /// Verifies the file: reads every page.
    ///
    /// # Errors
    /// At the first place that cannot be decoded, or where times decrease.
    pub fn verify(&self) -> Result<(), TelemetryError> {
        let mut places: Vec<usize> = self.columns.values().copied().collect();
        places.sort_unstable();
        let mut last = i64::MIN;
        let source = self.source();
        for index in 0..self.groups.len() {
            for &column in &places {
                let piece = decode(&source.reader, &self.path, (index, column))?;
                if let (TIME, Piece::Times(times)) = (column, piece) {
                    for &time in times.iter() {
                        if time <= last {
                            return Err(TelemetryError::Foreign {
                                path: self.path.clone(),
                                what: format!("row group {index}: the times decrease"),
                            });
                        }
                        last = time;
                    }
                }
            }
        }
        Ok(())
    }

    fn source(&self) -> MutexGuard<'_, Source> {
        // A panic leaves no broken state behind, so a poisoned lock is harmless.
        self.file.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn column(&self, name: &str) -> Result<usize, TelemetryError> {
        self.columns.get(name).copied().ok_or_else(|| {
            let nearest = self
                .columns()
                .into_iter()
                .max_by(|a, b| {
                    let likeness = |other| strsim::jaro_winkler(name, other);
                    likeness(a).total_cmp(&likeness(b))
                })
                .unwrap_or_default();
            TelemetryError::Column {
                path: self.path.clone(),
                name: name.to_owned(),
                nearest: nearest.to_owned(),
            }
        })
    }

    /// Returns the first row whose time meets a monotone condition.
    fn row_after(&self, is_after: impl Fn(i64) -> bool) -> Result<usize, TelemetryError> {
        let index = self
            .groups
            .partition_point(|group| !is_after(group.times[1]));
        let Some(group) = self.groups.get(index) else {
            return Ok(self.rows());
        };
        if is_after(group.times[0]) {
            return Ok(group.rows.start);
        }
        let times = self.times_of(index)?;
        Ok(group.rows.start + times.partition_point(|&time| !is_after(time)))
    }

    fn time_at(&self, row: usize) -> Result<i64, TelemetryError> {
        let index = self.groups.partition_point(|group| group.rows.end <= row);
        Ok(self.times_of(index)?[row - self.groups[index].rows.start])
    }

    fn times_of(&self, group: usize) -> Result<Arc<[i64]>, TelemetryError> {
        self.nanoseconds_of(group, TIME)
    }

    /// Returns all values of a column of times [ns].
    pub(super) fn whole_nanoseconds(&self, name: &str) -> Result<Vec<i64>, TelemetryError> {
        let column = self.column(name)?;
        let mut times = Vec::with_capacity(self.rows());
        for group in 0..self.groups.len() {
            times.extend(self.nanoseconds_of(group, column)?.iter());
        }
        Ok(times)
    }

    /// Returns the values of a column of times in a row group [ns].
    fn nanoseconds_of(&self, group: usize, column: usize) -> Result<Arc<[i64]>, TelemetryError> {
        match self.source().piece(&self.path, (group, column))? {
            Piece::Times(times) => Ok(times),
            _ => unreachable!("the column holds times"),
        }
    }
}

impl std::fmt::Debug for Telemetry {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Telemetry")
            .field("path", &self.path)
            .finish_non_exhaustive()
    }
}

impl Source {
    fn piece(&mut self, path: &Path, place: Place) -> Result<Piece, TelemetryError> {
        if let Some(piece) = self.cache.get(place) {
            return Ok(piece);
        }
        let piece = decode(&self.reader, path, place)?;
        self.cache.put(place, piece.clone());
        Ok(piece)
    }
}

fn decode(
    reader: &SerializedFileReader<CheckedFile>,
    path: &Path,
    (group, column): Place,
) -> Result<Piece, TelemetryError> {
    let decoded = match column {
        TIME => read_chunk::<Int64Type>(reader, group, column).map(|v| Piece::Times(v.into())),
        _ if column < FIXED.len() => {
            read_chunk::<Int32Type>(reader, group, column).map(|v| Piece::Codes(v.into()))
        }
        _ if find_column(reader, STAMP) == Some(column) => {
            read_chunk::<Int64Type>(reader, group, column).map(|v| Piece::Times(v.into()))
        }
        _ => read_chunk::<FloatType>(reader, group, column).map(|v| Piece::Singles(v.into())),
    };
    decoded.map_err(|error| {
        let schema = reader.metadata().file_metadata().schema_descr();
        let name = schema.column(column).name().to_owned();
        at(path, &format!("column {name:?}, row group {group}"), error)
    })
}

fn groups(reader: &SerializedFileReader<CheckedFile>) -> Result<Vec<Group>, ParquetError> {
    let mut groups: Vec<Group> = Vec::new();
    for (index, metadata) in reader.metadata().row_groups().iter().enumerate() {
        let start = groups.last().map_or(0, |group| group.rows.end);
        let rows = usize::try_from(metadata.num_rows()).unwrap_or_default();
        let times = match metadata.column(TIME).statistics() {
            Some(Statistics::Int64(found)) => found.min_opt().zip(found.max_opt()),
            _ => None,
        };
        let Some((&first, &last)) = times else {
            return Err(ParquetError::General(format!(
                "row group {index} does not state its times"
            )));
        };
        groups.push(Group {
            rows: start..start + rows,
            times: [first, last],
        });
    }
    Ok(groups)
}

/// Returns the stored time nearest to `time` [ns].
fn nanoseconds(time: f64) -> i64 {
    (time * NANOSECONDS_PER_SECOND).round() as i64
}

fn at(path: &Path, place: &str, error: ParquetError) -> TelemetryError {
    TelemetryError::Parquet {
        path: path.to_path_buf(),
        place: place.to_owned(),
        error,
    }
}
