//! What can be wrong with a bag.

use super::quantity::QuantityError;
use super::ros2::{MessageError, SchemaError};
use std::path::PathBuf;

/// Why telemetry could not be written.
#[derive(Debug, thiserror::Error)]
pub enum WriteError {
    /// The system refuses.
    #[error("{}: {error}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What the system says.
        error: std::io::Error,
    },
    /// The bag cannot be written.
    #[error("{}: {error}", path.display())]
    Mcap {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        error: mcap::McapError,
    },
    /// A message cannot be laid out.
    #[error("a message of {topic}: {error}")]
    Message {
        /// The topic.
        topic: &'static str,
        /// What is wrong.
        error: cdr::Error,
    },
    /// A time that no log bears.
    #[error("a sample's time of {time} s is not within 0 to {limit} s")]
    Time {
        /// The time [s].
        time: f64,
        /// The limit [s].
        limit: f64,
    },
    /// Samples out of order.
    #[error("a sample's time of {time} s is not after that of the sample before, {last} s")]
    Backwards {
        /// The time [s].
        time: f64,
        /// That of the sample before [s].
        last: f64,
    },
    /// A sample of another robot.
    #[error("a sample has {count} {what}, but the bag has {joints} joints")]
    Joints {
        /// Which array.
        what: &'static str,
        /// How many values it has.
        count: usize,
        /// How many it should have.
        joints: usize,
    },
    /// A robot that the samples are not of.
    #[error("robot {name:?} has {variables} variables, but the bag has {joints} joints")]
    Robot {
        /// Its name.
        name: String,
        /// How many variables it has.
        variables: usize,
        /// How many it should have.
        joints: usize,
    },
}

/// Why a log cannot be read.
#[derive(Debug, thiserror::Error)]
#[error("{file}: {fault}")]
pub struct ReadError {
    /// The file.
    pub file: String,
    /// What is wrong in it.
    pub fault: ReadFault,
}

/// What can be wrong with a log.
#[derive(Debug, thiserror::Error)]
pub enum ReadFault {
    /// The system refuses.
    #[error("{0}")]
    System(std::io::Error),
    /// An option that cannot be.
    #[error("{option}: {value} is not {limit}")]
    Option {
        /// As the command line calls it.
        option: &'static str,
        /// Its value.
        value: f64,
        /// What it has to be.
        limit: &'static str,
    },
    /// It is another kind of file.
    #[error(
        "this is no bag: it begins with bytes {found}, and an MCAP file with 89 4d 43 41 50 30 0d 0a"
    )]
    NotABag {
        /// Its first bytes.
        found: String,
    },
    /// It is a recording of another format, which other programs convert.
    #[error("this is {kind}, and only MCAP files are read")]
    OtherRecording {
        /// Which.
        kind: RecordingKind,
    },
    /// It ends too early.
    #[error(
        "the bag ends at byte {byte} in the middle of a record, as one that is being written does"
    )]
    Truncated {
        /// Its length.
        byte: u64,
    },
    /// It is packed in a way that is not read.
    #[error(
        "byte {byte}: a chunk is compressed with {compression:?}, and only \"lz4\", \"zstd\" and none at all are read"
    )]
    Compression {
        /// Where the record begins.
        byte: u64,
        /// How it is packed.
        compression: String,
    },
    /// A record that is longer than any.
    #[error("byte {byte}: a record of {len} bytes exceeds the limit of {limit} bytes")]
    RecordLength {
        /// Where it begins.
        byte: u64,
        /// Its length, unpacked.
        len: u64,
        /// The limit.
        limit: usize,
    },
    /// The container is damaged.
    #[error("byte {byte}: {error}")]
    Damaged {
        /// Where the record begins.
        byte: u64,
        /// What is wrong.
        error: String,
    },
    /// A topic's messages or schema are encoded in a way that is not read.
    #[error("topic {topic}: its {what} encoding is {encoding:?}, and only {limit:?} is read")]
    Encoding {
        /// The topic.
        topic: String,
        /// message or schema.
        what: &'static str,
        /// The encoding.
        encoding: String,
        /// The one that is read.
        limit: &'static str,
    },
    /// A topic's schema cannot be read.
    #[error("topic {topic}: {error}")]
    Schema {
        /// The topic.
        topic: String,
        /// What is wrong.
        error: SchemaError,
    },
    /// A message cannot be taken apart.
    #[error("topic {topic}, message {number}: {error}")]
    Message {
        /// The topic.
        topic: String,
        /// Counted from 1.
        number: usize,
        /// What is wrong.
        error: MessageError,
    },
    /// A message or line says what cannot be.
    #[error("{place}: {error}")]
    Quantity {
        /// The message or line.
        place: String,
        /// What is wrong.
        error: QuantityError,
    },
    /// Time that goes back by more than messages come late.
    #[error(
        "{place}: its time of {time} s is {} s before the latest one before it, {last} s; the limit is {limit} s",
        .last - .time
    )]
    Backwards {
        /// The message or line.
        place: String,
        /// Its time [s].
        time: f64,
        /// The latest time before it [s].
        last: f64,
        /// By how much it may come late [s].
        limit: f64,
    },
    /// What a camera saw cannot be read.
    #[error("topic {topic}: {problem}")]
    Look {
        /// The topic.
        topic: String,
        /// What is wrong.
        problem: String,
    },
    /// A topic or column that is not there.
    #[error("{0}")]
    Unknown(wisch::represent::UnknownName),
    /// A topic without what was looked for.
    #[error("topic {topic} of type {kind}: there is no {what}{}", in_field(.field))]
    NotThere {
        /// The topic.
        topic: String,
        /// Its type.
        kind: String,
        /// The field that was named, or nothing.
        field: String,
        /// pose or wrench.
        what: &'static str,
    },
    /// Nothing that could be meant.
    #[error("no topic holds a {what}; there are: {}{}", listed(.topics), and_unread(.unread))]
    Nothing {
        /// pose or wrench.
        what: &'static str,
        /// Every topic that is read with its type.
        topics: Vec<String>,
        /// Why each of the others is not read.
        unread: Vec<String>,
    },
    /// A frame that is to be a tool's, but never moves.
    #[error("frame {frame:?} never moves in {reference:?}, so nothing was wiped with it")]
    StillFrame {
        /// Its name.
        frame: String,
        /// The frame that it does not move in.
        reference: String,
    },
    /// A message that is packed by itself, and cannot be unpacked.
    #[error("topic {topic}: a packed message: {error}")]
    PackedMessage {
        /// The topic.
        topic: String,
        /// What is wrong.
        error: String,
    },
    /// A pipe or device, which may never end.
    #[error("this is {kind}, and only files and folders are read")]
    NoFile {
        /// What it is.
        kind: &'static str,
    },
    /// More than one that could be meant.
    #[error("{} topics hold a {what}, and one has to be chosen: {}", .topics.len(), listed(.topics))]
    Several {
        /// pose or wrench.
        what: &'static str,
        /// Their names.
        topics: Vec<String>,
    },
    /// Transforms that are known at none of the log's times.
    #[error(
        "at no time are the transforms known that lead to the task's world: they are told more than {limit} s apart"
    )]
    Transforms {
        /// The limit [s].
        limit: f64,
    },
    /// Poses and forces of different times.
    #[error(
        "{pose} covers {:.3} to {:.3} s and {wrench} {:.3} to {:.3} s: at no time are there both, at most {limit} s apart",
        .pose_times[0], .pose_times[1], .wrench_times[0], .wrench_times[1]
    )]
    Apart {
        /// Where the poses come from.
        pose: String,
        /// Their first and last time [s].
        pose_times: [f64; 2],
        /// Where the forces come from.
        wrench: String,
        /// Their first and last time [s].
        wrench_times: [f64; 2],
        /// The limit [s].
        limit: f64,
    },
    /// A table that is no text.
    #[error("byte {byte}: the table is not UTF-8 text")]
    NotText {
        /// The first byte that is none.
        byte: usize,
    },
    /// A table that is longer than is read.
    #[error("the table exceeds the limit of {limit} bytes")]
    TableLength {
        /// The limit.
        limit: u64,
    },
    /// A table without any line of numbers.
    #[error("the table has no line of numbers")]
    Empty,
    /// A line with another number of values than there are names.
    #[error("line {line}: it has {count} values, but there are {names} names")]
    ValueCount {
        /// Counted from 1.
        line: usize,
        /// How many values it has.
        count: usize,
        /// How many names there are.
        names: usize,
    },
    /// A table without a column of times.
    #[error("no column holds the time; there are: {}", listed(.columns))]
    NoTime {
        /// The names of all columns.
        columns: Vec<String>,
    },
    /// Two columns that a name may mean.
    #[error(
        "two columns may be {name:?}: number {} {:?} and number {} {:?}",
        .columns[0].0, .columns[0].1, .columns[1].0, .columns[1].1
    )]
    DuplicateColumn {
        /// The name.
        name: String,
        /// Number, from 1, and name of each.
        columns: [(usize, String); 2],
    },
    /// More columns than one that a quantity may stand in.
    #[error("{} sets of columns may be the {what}: {}", .columns.len(), .columns.join("; "))]
    SeveralColumns {
        /// position, orientation or force.
        what: &'static str,
        /// The names of each set.
        columns: Vec<String>,
    },
    /// A table that its reader refuses.
    #[error("{0}")]
    Csv(String),
    /// A table in a binary file that is damaged, or not of those that are read.
    #[error("the {kind} file cannot be read: {error}")]
    Table {
        /// What kind of file it is.
        kind: &'static str,
        /// What is wrong.
        error: String,
    },
    /// A table in Arrow's format, and a build that does not read it.
    #[error("it is a table in Arrow's format, which this build does not read")]
    NoArrow,
    /// A table with more rows than are read.
    #[error("the table has {rows} rows, and the limit is {limit}")]
    TooManyRows {
        /// How many it has, or at least has.
        rows: usize,
        /// The limit.
        limit: usize,
    },
    /// What is too long when it is unpacked.
    #[error("{what} is {len} bytes long when unpacked, and the limit is {limit} bytes")]
    Unpacked {
        /// The column, array or batch of rows.
        what: String,
        /// Its length [bytes].
        len: u64,
        /// The limit [bytes].
        limit: u64,
    },
    /// Columns of different lengths.
    #[error(
        "column {:?} has {} rows, but column {:?} has {}",
        .columns[0], .rows[0], .columns[1], .rows[1]
    )]
    Rows {
        /// Their names.
        columns: [String; 2],
        /// How many rows each has.
        rows: [usize; 2],
    },
    /// A column of what is no number, time or text.
    #[error("column {column:?} holds {kind}, and only numbers, times and text are read")]
    ColumnType {
        /// Its name.
        column: String,
        /// What it holds.
        kind: String,
    },
    /// A table in which something is missing that may be in a column that is not read.
    #[error("{fault}; lists, records and objects are not read: {}", listed(.columns))]
    BesideUnread {
        /// What is missing.
        fault: Box<ReadFault>,
        /// The names of those columns.
        columns: Vec<String>,
    },
    /// A time that no log bears.
    #[error("{place}: a time of {time} s is not within {limit} s of 0")]
    Time {
        /// The line or row.
        place: String,
        /// The time [s].
        time: f64,
        /// The limit [s].
        limit: f64,
    },
    /// A value that is no number.
    #[error("{place}, column {column:?}: {text:?} is no number")]
    NotANumber {
        /// The line or row.
        place: String,
        /// The column.
        column: String,
        /// The value.
        text: String,
    },
}

/// Recordings that are not read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RecordingKind {
    /// A bag of ROS 2 in a SQLite database (.db3).
    Sqlite,
    /// A bag of ROS 1.
    Ros1,
}

impl std::fmt::Display for RecordingKind {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Sqlite => "a bag of ROS 2 in a SQLite database (.db3)",
            Self::Ros1 => "a bag of ROS 1",
        })
    }
}

/// How many topics a message lists.
const TOPICS_SHOWN: usize = 12;

fn listed(topics: &[String]) -> String {
    let mut text = topics[..topics.len().min(TOPICS_SHOWN)].join(", ");
    match topics.len() {
        0 => "none".to_owned(),
        count if count > TOPICS_SHOWN => {
            text += &format!(" and {} more", count - TOPICS_SHOWN);
            text
        }
        _ => text,
    }
}

fn and_unread(unread: &[String]) -> String {
    match unread {
        [] => String::new(),
        _ => {
            let shown = unread[..unread.len().min(TOPICS_SHOWN)].join("; ");
            format!(". What is not read: {shown}")
        }
    }
}

fn in_field(field: &str) -> String {
    if field.is_empty() {
        " in it".to_owned()
    } else {
        format!(" in {field:?}")
    }
}
