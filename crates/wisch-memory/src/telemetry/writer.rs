//! Writer of telemetry during an execution, in bounded memory.

use super::{
    FIXED, JOINTS_KEY, NANOSECONDS_PER_SECOND, NO_STAMP, NOTE_PREFIX, PHASES, SCHEMA_KEY, STAMP,
    STAMP_CLOCK_NOTE, TELEMETRY_SCHEMA, TelemetryError, robot_columns, seconds,
};
use crate::columns::{Kind, Values, schema, with_encodings, write_group};
use parquet::basic::{Compression, ZstdLevel};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::ColumnPath;
use std::collections::{BTreeMap, BTreeSet};
use std::fs::{self, File};
use std::io::BufWriter;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use wisch::follow::Phase;
use wisch::geometry::flatten_pose;
use wisch::interpret::WrenchQuality;
use wisch::run::{Stamp, StampClock, TelemetrySample, Wrench};

/// Length of a row group [ns]: reading a second decodes ten seconds.
const GROUP_TIME: i64 = 10 * NANOSECONDS_PER_SECOND as i64;
/// Largest number of rows in a row group: 100 columns of them are 40 MB.
const GROUP_ROWS: usize = 100_000;
/// Largest time of a sample [s]: thirty years, well within 64 bits of nanoseconds.
const MAX_TIME: f64 = 1e9;

/// The constant data of a telemetry file.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TelemetryHead {
    /// Names of the robot's variables, in the order of the samples' arrays.
    pub joints: Vec<String>,
    /// Further notes.
    pub notes: BTreeMap<String, String>,
}

/// Motion and phase of a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Mark {
    /// Number of the motion in the round.
    pub motion: usize,
    /// Phase of that motion.
    pub phase: Phase,
}

/// Writer of telemetry during an execution.
///
/// Until [`finish`](Self::finish), the file name has the additional ending `.active`, so that a file with its own name
/// is complete. Memory holds at most the last ten seconds, the rows of one row group.
///
/// ```
/// use wisch::run::{SampleStatus, TelemetrySample, Wrench};
/// use wisch::follow::Phase;
/// use wisch::geometry::{Pose, Vector3};
/// use wisch_memory::{Telemetry, TelemetryHead, TelemetryWriter};
///
/// # let folder = tempfile::tempdir()?;
/// # let path = folder.path().join("round-1.parquet");
/// let head = TelemetryHead { joints: vec!["slide".into()], ..TelemetryHead::default() };
/// let mut writer = TelemetryWriter::create(&path, head)?;
/// for index in 0..1000 {
///     let time = f64::from(index) * 1e-3;
///     writer.write(&TelemetrySample {
///         time,
///         positions: &[0.5 * time],
///         velocities: &[0.5],
///         efforts: &[3.0],
///         world_from_commanded: Pose::translation(0.6 + 0.5 * time, 0.0, 0.74),
///         world_from_tool: Pose::translation(0.6 + 0.5 * time, 0.0, 0.75),
///         controller: Wrench::default(),
///         external: Wrench { force: Vector3::new(0.0, 0.0, 10.0), moment: Vector3::zeros() },
///         motion: 0,
///         phase: Phase::Wipe(0),
///         status: SampleStatus::default(),
///     })?;
/// }
/// writer.finish()?;
///
/// let telemetry = Telemetry::open(&path)?;
/// let slide = telemetry.series("position/slide", [0.25, 0.75])?;
/// assert_eq!(slide.times.len(), 501);
/// assert_eq!(slide.values[0], 0.125);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct TelemetryWriter {
    target: PathBuf,
    active: PathBuf,
    file: SerializedFileWriter<BufWriter<File>>,
    joints: usize,
    times: Vec<i64>,
    marks: [Vec<i32>; 3],
    columns: Vec<Vec<f32>>,
    /// Absolute stamps [ns]; `None` for a file without them.
    stamps: Option<Vec<i64>>,
    /// The clock of the stamps, if there was one.
    clock: Option<StampClock>,
    /// Time of the last row, if any [ns].
    last: Option<i64>,
}

impl TelemetryWriter {
    /// Begins the telemetry of a robot, which [`Self::finish`] moves to `path`.
    ///
    /// # Errors
    /// If two variables have the same name, or the file cannot be written.
    pub fn create(path: &Path, head: TelemetryHead) -> Result<Self, TelemetryError> {
        let columns = robot_columns(&head.joints);
        Self::begin(path, head, &columns, Some(Vec::new()))
    }

    /// Begins a file with the given columns, for a log without joints.
    ///
    /// # Errors
    /// If two columns have the same name, or the file cannot be written.
    pub fn with_columns(
        path: &Path,
        head: TelemetryHead,
        columns: &[String],
    ) -> Result<Self, TelemetryError> {
        Self::begin(path, head, columns, None)
    }

    fn begin(
        path: &Path,
        head: TelemetryHead,
        columns: &[String],
        stamps: Option<Vec<i64>>,
    ) -> Result<Self, TelemetryError> {
        let mut active = path.as_os_str().to_owned();
        active.push(".active");
        let active = PathBuf::from(active);
        let mut names: BTreeSet<&str> = FIXED.iter().map(|(name, _)| *name).collect();
        names.extend(stamps.as_ref().map(|_| STAMP));
        if let Some(twice) = columns.iter().find(|name| !names.insert(name)) {
            return Err(TelemetryError::Twice {
                path: path.to_path_buf(),
                name: twice.clone(),
            });
        }
        let kinds = || {
            let own = columns.iter().map(|name| (name.as_str(), Kind::Single));
            let stamp = stamps.is_some().then_some((STAMP, Kind::Growing));
            FIXED.into_iter().chain(own).chain(stamp)
        };
        let output = File::create(&active).map_err(|error| TelemetryError::File {
            path: active.clone(),
            error,
        })?;
        let properties = properties(&head, kinds());
        let file = schema(kinds())
            .and_then(|schema| {
                SerializedFileWriter::new(BufWriter::new(output), schema, Arc::new(properties))
            })
            .map_err(|error| failed(&active, "head", error))?;
        Ok(Self {
            target: path.to_path_buf(),
            active,
            file,
            joints: head.joints.len(),
            times: Vec::new(),
            marks: Default::default(),
            columns: vec![Vec::new(); columns.len()],
            stamps,
            clock: None,
            last: None,
        })
    }

    /// Adds a sample. Positions, velocities and efforts that are not measured (empty arrays) are written as NaN.
    ///
    /// # Errors
    /// If the time is not finite, is negative or is not later than the previous one, if an array does not have one
    /// value per joint, or if the file cannot be written.
    pub fn write(&mut self, sample: &TelemetrySample<'_>) -> Result<(), TelemetryError> {
        let unmeasured = vec![f64::NAN; self.joints];
        let mut arrays = [
            ("positions", sample.positions),
            ("velocities", sample.velocities),
            ("efforts", sample.efforts),
        ];
        for (_, values) in &mut arrays {
            if values.is_empty() {
                *values = &unmeasured;
            }
        }
        for (what, values) in arrays {
            if values.len() != self.joints {
                return Err(TelemetryError::Count {
                    what,
                    count: values.len(),
                    expected: self.joints,
                });
            }
        }
        let joints = arrays.into_iter().flat_map(|(_, values)| values).copied();
        let poses = [&sample.world_from_commanded, &sample.world_from_tool];
        let wrenches = [&sample.controller, &sample.external];
        let mark = Mark {
            motion: sample.motion,
            phase: sample.phase,
        };
        let poses = poses.into_iter().flat_map(flatten_pose);
        let wrenches = wrenches.into_iter().flat_map(parts_of_wrench);
        let status = &sample.status;
        let quality = WrenchQuality::ALL.iter().position(|q| *q == status.wrench);
        let quality = quality.expect("all qualities are listed");
        let status_columns = [quality as f64, f64::from(u8::from(status.is_paused))];
        let values = joints.chain(poses).chain(wrenches).chain(status_columns);
        let stamp = status.stamp;
        self.push_stamped(sample.time, mark, stamp, values)
    }

    /// Adds a row with a value for each of the file's own columns.
    ///
    /// # Errors
    /// If the time \[s\] is not finite, is negative or is not later than the previous one, if the number of values is
    /// wrong, or if the file cannot be written.
    pub fn push(
        &mut self,
        time: f64,
        mark: Mark,
        values: impl IntoIterator<Item = f64>,
    ) -> Result<(), TelemetryError> {
        self.push_stamped(time, mark, None, values)
    }

    fn push_stamped(
        &mut self,
        time: f64,
        mark: Mark,
        stamp: Option<Stamp>,
        values: impl IntoIterator<Item = f64>,
    ) -> Result<(), TelemetryError> {
        let time = self.check(time)?;
        let first = self.times.first().copied().unwrap_or(time);
        if time - first >= GROUP_TIME || self.times.len() >= GROUP_ROWS {
            self.flush()?;
        }
        let row = self.times.len();
        let mut count = 0;
        for value in values {
            if let Some(column) = self.columns.get_mut(count) {
                // Single precision resolves a tenth of a micrometre at arm's length.
                column.push(value as f32);
            }
            count += 1;
        }
        if count != self.columns.len() {
            // Removes the incomplete row.
            for column in &mut self.columns {
                column.truncate(row);
            }
            return Err(TelemetryError::Count {
                what: "row",
                count,
                expected: self.columns.len(),
            });
        }
        self.times.push(time);
        if let Some(stamps) = &mut self.stamps {
            let nanoseconds = stamp.and_then(|stamp| i64::try_from(stamp.nanoseconds).ok());
            stamps.push(nanoseconds.unwrap_or(NO_STAMP));
            self.clock = self.clock.or(stamp.map(|stamp| stamp.clock));
        }
        let stroke = mark.phase.stroke().map_or(-1, code);
        let marks = [code(mark.motion), stroke, code(place_of(mark.phase))];
        for (column, mark) in self.marks.iter_mut().zip(marks) {
            column.push(mark);
        }
        self.last = Some(time);
        Ok(())
    }

    /// Finishes the file, syncs it to disk and moves it to its path.
    ///
    /// # Errors
    /// If the file cannot be written or moved; it then keeps the ending `.active`.
    pub fn finish(mut self) -> Result<(), TelemetryError> {
        self.flush()?;
        if let Some(clock) = self.clock {
            let key = format!("{NOTE_PREFIX}{STAMP_CLOCK_NOTE}");
            let note = KeyValue::new(key, clock.as_str().to_owned());
            self.file.append_key_value_metadata(note);
        }
        let active = self.active;
        let file_failed = |error| TelemetryError::File {
            path: active.clone(),
            error,
        };
        let writer = self
            .file
            .into_inner()
            .map_err(|error| failed(&active, "footer", error))?;
        let file = writer
            .into_inner()
            .map_err(|error| file_failed(error.into_error()))?;
        file.sync_all().map_err(file_failed)?;
        fs::rename(&active, &self.target).map_err(|error| TelemetryError::File {
            path: self.target.clone(),
            error,
        })
    }

    /// Ends writing and removes the unfinished file.
    pub fn abandon(self) {
        drop(self.file);
        // A file that cannot be removed keeps the ending that marks it as incomplete.
        let _ = fs::remove_file(&self.active);
    }

    fn check(&self, time: f64) -> Result<i64, TelemetryError> {
        if !(0.0..MAX_TIME).contains(&time) {
            return Err(TelemetryError::Time {
                time,
                limit: MAX_TIME,
            });
        }
        let nanoseconds = (time * NANOSECONDS_PER_SECOND).round() as i64;
        match self.last {
            Some(last) if nanoseconds <= last => Err(TelemetryError::Backwards {
                time,
                last: seconds(last),
            }),
            _ => Ok(nanoseconds),
        }
    }

    fn flush(&mut self) -> Result<(), TelemetryError> {
        if self.times.is_empty() {
            return Ok(());
        }
        let marks = self.marks.iter().map(|column| Values::Ints(column));
        let own = self.columns.iter().map(|column| Values::Singles(column));
        let columns = std::iter::once(Values::Longs(&self.times));
        let stamps = self.stamps.iter().map(|stamps| Values::Longs(stamps));
        let group = self.file.flushed_row_groups().len();
        write_group(
            &mut self.file,
            columns.chain(marks).chain(own).chain(stamps),
        )
        .map_err(|error| failed(&self.active, &format!("row group {group}"), error))?;
        self.times.clear();
        self.marks.iter_mut().for_each(Vec::clear);
        self.columns.iter_mut().for_each(Vec::clear);
        self.stamps.iter_mut().for_each(Vec::clear);
        Ok(())
    }
}

fn properties<'a>(
    head: &TelemetryHead,
    columns: impl IntoIterator<Item = (&'a str, Kind)>,
) -> WriterProperties {
    let note = |key: String, value: String| KeyValue::new(key, value);
    let joints = serde_json::to_string(&head.joints).unwrap_or_default();
    let mut notes = vec![
        note(SCHEMA_KEY.to_owned(), TELEMETRY_SCHEMA.to_string()),
        note(JOINTS_KEY.to_owned(), joints),
    ];
    notes.extend((head.notes.iter()).map(|(k, v)| note(format!("{NOTE_PREFIX}{k}"), v.clone())));
    // Only times are searched, so statistics of other columns are left out and opening a file stays fast.
    let builder = WriterProperties::builder()
        .set_compression(Compression::ZSTD(ZstdLevel::default()))
        .set_max_row_group_row_count(None)
        .set_data_page_row_count_limit(GROUP_ROWS)
        .set_statistics_enabled(EnabledStatistics::None)
        .set_column_statistics_enabled(
            ColumnPath::new(vec!["time".into()]),
            EnabledStatistics::Chunk,
        )
        .set_offset_index_disabled(true)
        .set_created_by(concat!("wisch ", env!("CARGO_PKG_VERSION")).to_owned())
        .set_key_value_metadata(Some(notes));
    with_encodings(builder, columns).build()
}

fn parts_of_wrench(wrench: &Wrench) -> [f64; 6] {
    let (f, m) = (wrench.force, wrench.moment);
    [f.x, f.y, f.z, m.x, m.y, m.z]
}

/// Returns the index of a phase in [`PHASES`].
fn place_of(phase: Phase) -> usize {
    let name = phase.as_str();
    PHASES.iter().position(|&other| other == name).unwrap_or(0)
}

fn code(number: usize) -> i32 {
    i32::try_from(number).unwrap_or(i32::MAX)
}

fn failed(path: &Path, place: &str, error: ParquetError) -> TelemetryError {
    TelemetryError::Parquet {
        path: path.to_path_buf(),
        place: place.to_owned(),
        error,
    }
}
