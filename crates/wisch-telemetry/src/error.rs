//! Errors of telemetry files.

use super::quantity::QuantityError;
use super::ros2::{MessageError, SchemaError};
use std::path::{Path, PathBuf};

/// The reason why telemetry could not be written.
#[derive(Debug, thiserror::Error)]
pub enum WriteError {
    /// The operating system refuses an operation.
    #[error("{}: {error}", path.display())]
    File {
        /// Path of the file.
        path: PathBuf,
        /// Error of the operating system.
        error: std::io::Error,
    },
    /// The bag cannot be written.
    #[error("{}: {error}", path.display())]
    Mcap {
        /// Path of the file.
        path: PathBuf,
        /// Error of the MCAP writer.
        error: mcap::McapError,
    },
    /// A message cannot be encoded.
    #[error("a message of {topic} cannot be encoded: {error}")]
    Message {
        /// Its topic.
        topic: &'static str,
        /// Error of the CDR encoder.
        error: cdr::Error,
    },
    /// A time is out of range.
    #[error("a sample's time is {time} s; it must be within 0 to {limit} s")]
    Time {
        /// The time \[s\].
        time: f64,
        /// The limit \[s\].
        limit: f64,
    },
    /// A sample is not later than the previous one.
    #[error("a sample's time is {time} s; it must be later than the previous sample's, {last} s")]
    Backwards {
        /// The time \[s\].
        time: f64,
        /// Time of the previous sample \[s\].
        last: f64,
    },
    /// An array of a sample does not match the joints of the bag.
    #[error("a sample has {count} {what}, but the bag has {joints} joints")]
    Joints {
        /// Name of the array.
        what: &'static str,
        /// Number of values in the array.
        count: usize,
        /// Number of joints in the bag.
        joints: usize,
    },
    /// The robot does not match the joints of the bag.
    #[error("robot {name:?} has {variables} variables, but the bag has {joints} joints")]
    Robot {
        /// Name of the robot.
        name: String,
        /// Number of its variables.
        variables: usize,
        /// Number of joints in the bag.
        joints: usize,
    },
}

impl WriteError {
    /// Returns the error of a bag; an error of the operating system, such as a full disk, in its own words.
    pub(crate) fn of_mcap(path: &Path, error: mcap::McapError) -> Self {
        let path = path.to_owned();
        match error {
            mcap::McapError::Io(error) => Self::File { path, error },
            error => Self::Mcap { path, error },
        }
    }
}

/// The reason why a log cannot be read.
#[derive(Debug, thiserror::Error)]
#[error("{file}: {fault}")]
pub struct ReadError {
    /// Path of the file.
    pub file: String,
    /// The fault in it.
    pub fault: ReadFault,
}

/// Describes an error of the operating system, as other crates do.
fn system_fault(error: &std::io::Error) -> String {
    match error.kind() {
        // An error of this crate has a text of its own.
        std::io::ErrorKind::NotFound if error.raw_os_error().is_some() => {
            "there is no such file".to_owned()
        }
        _ => error.to_string(),
    }
}

/// A fault of a log that prevents reading it.
#[derive(Debug, thiserror::Error)]
pub enum ReadFault {
    /// The operating system refuses an operation.
    #[error("{}", system_fault(.0))]
    System(std::io::Error),
    /// The value of an option is out of range.
    #[error("{option}: {value} is not {limit}")]
    Option {
        /// Name of the option on the command line.
        option: &'static str,
        /// Its value.
        value: f64,
        /// Allowed range.
        limit: &'static str,
    },
    /// The file is not an MCAP file.
    #[error(
        "this is not a bag: it begins with bytes {found}, but an MCAP file begins with 89 4d 43 41 50 30 0d 0a"
    )]
    NotABag {
        /// Its first bytes.
        found: String,
    },
    /// The file is in another format, which other programs convert to a format that is read.
    #[error("this is {kind}, but {}", what_is_read(*kind))]
    OtherRecording {
        /// Format of the recording.
        kind: RecordingKind,
    },
    /// The bag ends in the middle of a record.
    #[error(
        "the bag ends at byte {byte} in the middle of a record, like a bag that is still being written"
    )]
    Truncated {
        /// Length of the file [bytes].
        byte: u64,
    },
    /// The file ends before the first message that is needed.
    #[error("{}{}", too_early(*.byte, .what), of_messages(*.messages, .topics))]
    TooEarly {
        /// "pose", "wrench" or "message".
        what: &'static str,
        /// Length of a file that ends in the middle of a record [bytes]; `None` for a complete bag.
        byte: Option<u64>,
        /// Number of complete messages.
        messages: usize,
        /// Every topic of these messages.
        topics: Vec<String>,
    },
    /// A chunk has an unknown compression.
    #[error(
        "byte {byte}: a chunk is compressed with {compression:?}, but only \"lz4\", \"zstd\" and no compression are read"
    )]
    Compression {
        /// Position of the record.
        byte: u64,
        /// Name of the compression.
        compression: String,
    },
    /// A record is too long.
    #[error("byte {byte}: a record of {len} bytes exceeds the limit of {limit} bytes")]
    RecordLength {
        /// Position of the record.
        byte: u64,
        /// Its unpacked length [bytes].
        len: u64,
        /// The limit [bytes].
        limit: usize,
    },
    /// The container is damaged.
    #[error("byte {byte}: {error}")]
    Damaged {
        /// Position of the record.
        byte: u64,
        /// Description of the damage.
        error: String,
    },
    /// The encoding of a topic's messages or schema is not supported.
    #[error("topic {topic}: its {what} encoding is {encoding:?}, but only {limit:?} is read")]
    Encoding {
        /// Name of the topic.
        topic: String,
        /// "message" or "schema".
        what: &'static str,
        /// The encoding.
        encoding: String,
        /// The supported encoding.
        limit: &'static str,
    },
    /// The schema of a topic cannot be parsed.
    #[error("topic {topic}: {error}")]
    Schema {
        /// Name of the topic.
        topic: String,
        /// Error of the schema.
        error: SchemaError,
    },
    /// A message cannot be decoded.
    #[error("topic {topic}, message {number}: {error}")]
    Message {
        /// Name of the topic.
        topic: String,
        /// Number of the message, from 1.
        number: usize,
        /// Error of the message.
        error: MessageError,
    },
    /// A message or line holds an invalid pose or force.
    #[error("{place}: {error}")]
    Quantity {
        /// Name of the message or line.
        place: String,
        /// Error of the numbers.
        error: QuantityError,
    },
    /// A time is earlier than a previous one by more than the reorder window.
    #[error(
        "{place}: its time of {time} s is {} s earlier than the latest earlier time, {last} s; the limit is {limit} s",
        ((.last - .time) * 1e9).round() / 1e9
    )]
    Backwards {
        /// Name of the message or line.
        place: String,
        /// Its time \[s\].
        time: f64,
        /// Latest time before it \[s\].
        last: f64,
        /// The reorder window \[s\].
        limit: f64,
    },
    /// The messages of a topic are in several frames.
    #[error(
        "topic {topic}: its messages are in the frames {:?} and {:?}, so that several sensors or publishers may be mixed",
        .frames[0],
        .frames[1]
    )]
    SeveralFrames {
        /// The topic.
        topic: String,
        /// The frame of the first message, and the first other one.
        frames: [String; 2],
    },
    /// The times jump back, and then repeat times that occurred before.
    #[error(
        "{place}: the clock was set back from {last} s to {time} s: the log holds other values for the same times"
    )]
    ClockSetBack {
        /// Name of a message or line soon after that.
        place: String,
        /// Time to which the clock was set \[s\].
        time: f64,
        /// Latest time before \[s\].
        last: f64,
    },
    /// A table has numbers with commas and numbers with points.
    #[error(
        "line {line}: {text:?}: the table has numbers with commas and numbers with points, and does not say which are decimal: remove separators of thousands"
    )]
    DecimalMarks {
        /// Line of the first number with the other mark.
        line: usize,
        /// That number as written.
        text: String,
    },
    /// A message of a sample is invalid.
    #[error("topic {topic}: {problem}")]
    Sample {
        /// Name of the topic.
        topic: String,
        /// Description of the fault.
        problem: String,
    },
    /// A camera observation is invalid.
    #[error("topic {topic}: {problem}")]
    Observation {
        /// Name of the topic.
        topic: String,
        /// Description of the fault.
        problem: String,
    },
    /// An option names a topic, frame or column that does not exist.
    #[error("{0}")]
    Unknown(wisch::represent::UnknownName),
    /// A named topic does not hold the quantity.
    #[error("topic {topic} of type {kind}: there is no {what}{}{}", in_field(.field), list_fields(.fields))]
    NotThere {
        /// Name of the topic.
        topic: String,
        /// Its type.
        kind: Box<str>,
        /// The named field; empty for the whole message.
        field: String,
        /// "pose" or "wrench".
        what: &'static str,
        /// Every field that holds the quantity; an empty name is the whole message.
        fields: Box<[String]>,
    },
    /// No topic holds the quantity.
    #[error("no topic holds a {what}; the topics are: {}{}", join_names(.topics), and_unread(.unread))]
    Nothing {
        /// "pose" or "wrench".
        what: &'static str,
        /// Every readable topic with its type.
        topics: Vec<String>,
        /// Every other topic, with the reason.
        unread: Vec<String>,
    },
    /// The frame that an option names as the tool's never moves.
    #[error("frame {frame:?} never moves in {reference:?}; name the frame of a tool that moves")]
    StillFrame {
        /// Name of the frame.
        frame: String,
        /// The frame in which it does not move.
        reference: String,
    },
    /// A message that was packed by itself cannot be unpacked.
    #[error("topic {topic}: a packed message cannot be unpacked: {error}")]
    PackedMessage {
        /// Name of the topic.
        topic: String,
        /// Error of the decompressor.
        error: String,
    },
    /// The path is a pipe or device, which may never end.
    #[error("this is {kind}, but only files and folders are read")]
    NoFile {
        /// Kind of the path.
        kind: &'static str,
    },
    /// Several topics hold the quantity.
    #[error("{} topics hold a {what}; choose one of: {}", .topics.len(), join_names(.topics))]
    Several {
        /// "pose" or "wrench".
        what: &'static str,
        /// Names of the topics.
        topics: Vec<String>,
    },
    /// All samples of the log have the same time.
    #[error("all {count} samples have the same time, {time} s: the time does not advance")]
    SameTime {
        /// Number of samples.
        count: usize,
        /// Their time \[s\].
        time: f64,
    },
    /// All wrenches of the log are stale, saturated or untared.
    #[error(
        "all {count} samples have a stale, saturated or untared wrench, or a frozen pose, so the log shows no touch"
    )]
    UnusableWrenches {
        /// Number of samples.
        count: usize,
    },
    /// The transforms to the task's world are known at no time.
    #[error(
        "the transforms to the task's world are known at no time: their times are more than {limit} s apart"
    )]
    Transforms {
        /// The limit \[s\].
        limit: f64,
    },
    /// Poses and forces do not overlap in time.
    #[error(
        "{pose} covers {:.3} to {:.3} s and {wrench} {:.3} to {:.3} s: they do not overlap within the limit of {limit} s",
        .pose_times[0], .pose_times[1], .wrench_times[0], .wrench_times[1]
    )]
    Apart {
        /// Source of the poses.
        pose: String,
        /// First and last time of the poses \[s\].
        pose_times: [f64; 2],
        /// Source of the forces.
        wrench: String,
        /// First and last time of the forces \[s\].
        wrench_times: [f64; 2],
        /// The largest gap that is interpolated \[s\].
        limit: f64,
    },
    /// A table is not text.
    #[error("byte {byte}: the table is not UTF-8 text")]
    NotText {
        /// Position of the first invalid byte.
        byte: usize,
    },
    /// A table is too long.
    #[error("the table exceeds the limit of {limit} bytes")]
    TableLength {
        /// The limit [bytes].
        limit: u64,
    },
    /// A table has no line of numbers.
    #[error("the table has no line of numbers")]
    Empty,
    /// A line has more or fewer values than there are names.
    #[error("line {line}: it has {count} values, but the table has {names} names")]
    ValueCount {
        /// Number of the line, from 1.
        line: usize,
        /// Number of values.
        count: usize,
        /// Number of names.
        names: usize,
    },
    /// A table has no column of times.
    #[error("no column holds the time; the columns are: {}", join_names(.columns))]
    NoTime {
        /// Names of all columns.
        columns: Vec<String>,
    },
    /// Two columns match the same name.
    #[error(
        "two columns may be {name:?}: number {} {:?} and number {} {:?}",
        .columns[0].0, .columns[0].1, .columns[1].0, .columns[1].1
    )]
    DuplicateColumn {
        /// The name.
        name: String,
        /// Number, from 1, and name of each column.
        columns: [(usize, String); 2],
    },
    /// Several sets of columns match a quantity.
    #[error("{} sets of columns may be the {what}: {}", .columns.len(), .columns.join("; "))]
    SeveralColumns {
        /// "position", "orientation" or "force".
        what: &'static str,
        /// Names of each set.
        columns: Vec<String>,
    },
    /// The reader of text tables refuses the table.
    #[error("{0}")]
    Csv(String),
    /// A binary table is damaged or unsupported.
    #[error("the {kind} file cannot be read: {error}")]
    Table {
        /// Format of the file.
        kind: &'static str,
        /// Description of the damage.
        error: String,
    },
    /// The table is in Arrow's format, and this build cannot read that.
    #[error("the table is in Arrow's format, which this build does not read")]
    NoArrow,
    /// A table has too many rows.
    #[error("the table has {rows} rows, and the limit is {limit}")]
    TooManyRows {
        /// Number of rows, or a lower bound of it.
        rows: usize,
        /// The limit.
        limit: usize,
    },
    /// Unpacked data are too long.
    #[error("{what} is {len} bytes long when unpacked, and the limit is {limit} bytes")]
    Unpacked {
        /// Name of the column, array or batch of rows.
        what: String,
        /// Unpacked length [bytes].
        len: u64,
        /// The limit [bytes].
        limit: u64,
    },
    /// Columns have different lengths.
    #[error(
        "column {:?} has {} rows, but column {:?} has {}",
        .columns[0], .rows[0], .columns[1], .rows[1]
    )]
    Rows {
        /// Names of the two columns.
        columns: [String; 2],
        /// Number of rows of each column.
        rows: [usize; 2],
    },
    /// A column holds values other than numbers, times or text.
    #[error("column {column:?} holds {kind}, but only numbers, times and text are read")]
    ColumnType {
        /// Name of the column.
        column: String,
        /// Type of its values.
        kind: String,
    },
    /// The missing column may be one whose type is not supported.
    #[error("{fault}; lists, records and objects are not read: {}", join_names(.columns))]
    BesideUnread {
        /// The fault: the missing column.
        fault: Box<ReadFault>,
        /// Names of the unsupported columns.
        columns: Vec<String>,
    },
    /// A time is out of range.
    #[error("{place}: the time {time} s is not within {limit} s of 0")]
    Time {
        /// Name of the line or row.
        place: String,
        /// The time \[s\].
        time: f64,
        /// The limit \[s\].
        limit: f64,
    },
    /// A value is not a number.
    #[error("{place}, column {column:?}: {text:?} is not a number")]
    NotANumber {
        /// Name of the line or row.
        place: String,
        /// Name of the column.
        column: String,
        /// Text of the value.
        text: String,
    },
    /// A column of whole seconds or nanoseconds holds another value.
    #[error("{place}, column {column:?}: {text:?} is not a whole number of {expected}")]
    SplitTime {
        /// Name of the line or row.
        place: String,
        /// Name of the column.
        column: String,
        /// Text of the value.
        text: String,
        /// What is expected.
        expected: &'static str,
    },
}

/// Recording formats that are recognised but not read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RecordingKind {
    /// A bag of ROS 2 in a SQLite database (.db3).
    Sqlite,
    /// A bag of ROS 1.
    Ros1,
    /// Text in JSON, one value or one per line.
    Json,
    /// A file compressed by gzip.
    Gzip,
    /// Text in UTF-16.
    Utf16,
    /// A file of HDF5, such as a MATLAB file.
    Hdf5,
    /// A workbook of a spreadsheet program.
    Workbook,
}

impl std::fmt::Display for RecordingKind {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Sqlite => "a bag of ROS 2 in a SQLite database (.db3)",
            Self::Ros1 => "a bag of ROS 1",
            Self::Json => "JSON",
            Self::Gzip => "compressed by gzip",
            Self::Utf16 => "text in UTF-16",
            Self::Hdf5 => "an HDF5 file",
            Self::Workbook => "a workbook of a spreadsheet program",
        })
    }
}

/// States what is read instead of a format.
const fn what_is_read(kind: RecordingKind) -> &'static str {
    match kind {
        RecordingKind::Sqlite | RecordingKind::Ros1 => {
            "only MCAP files are read; convert it to MCAP first"
        }
        RecordingKind::Json
        | RecordingKind::Gzip
        | RecordingKind::Utf16
        | RecordingKind::Hdf5
        | RecordingKind::Workbook => "only bags (MCAP) and tables (CSV, Parquet, npz) are read",
    }
}

/// Largest number of topics in a message.
const TOPICS_SHOWN: usize = 12;

fn join_names(names: &[String]) -> String {
    let mut text = names[..names.len().min(TOPICS_SHOWN)].join(", ");
    match names.len() {
        0 => "none".to_owned(),
        count if count > TOPICS_SHOWN => {
            text += &format!(" and {} more", count - TOPICS_SHOWN);
            text
        }
        _ => text,
    }
}

fn too_early(byte: Option<u64>, what: &str) -> String {
    match byte {
        Some(byte) => format!(
            "the bag ends at byte {byte} in the middle of a record, before its first {what}: "
        ),
        None => "the bag is complete, but ".to_owned(),
    }
}

fn of_messages(messages: usize, topics: &[String]) -> String {
    match messages {
        0 => "it holds no complete message".to_owned(),
        _ => format!(
            "its complete messages ({messages}) are of the topics {}",
            join_names(topics)
        ),
    }
}

fn and_unread(unread: &[String]) -> String {
    match unread {
        [] => String::new(),
        _ => {
            let shown = unread[..unread.len().min(TOPICS_SHOWN)].join("; ");
            format!(". Not readable: {shown}")
        }
    }
}

/// Lists the fields that hold the quantity, of which an empty name is the whole message.
fn list_fields(fields: &[String]) -> String {
    match fields {
        [] => String::new(),
        [whole] if whole.is_empty() => "; the whole message is one: name no field".to_owned(),
        _ => format!("; known: {}", fields.join(", ")),
    }
}

fn in_field(field: &str) -> String {
    if field.is_empty() {
        " in it".to_owned()
    } else {
        format!(" in {field:?}")
    }
}
