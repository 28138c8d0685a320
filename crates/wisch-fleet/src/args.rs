//! The command line.

use clap::{Args, Parser, Subcommand};
use std::net::SocketAddr;
use std::path::PathBuf;

/// SQL over the episodes of many robots, and the way of episodes between memories and a shared store.
#[derive(Debug, Parser)]
#[command(
    name = "wisch-fleet",
    version,
    arg_required_else_help = true,
    after_help = "\
Examples:
  wisch-fleet push episodes s3://robots/fleet
  wisch-fleet sql \"SELECT * FROM low_performance\" --fleet s3://robots/fleet
  wisch-fleet sql --memory episodes < questions.sql
  wisch-fleet pull s3://robots/fleet kitchen --since 2026-11-01 --class HumanCollision

Credentials come from the environment (AWS_ACCESS_KEY_ID, AWS_SECRET_ACCESS_KEY, AWS_ENDPOINT, AWS_REGION, …) or from
~/.aws/credentials. Exit codes: 0 done, 1 done but not as hoped (faults found, episodes left out), 2 error."
)]
pub struct FleetCli {
    /// What to do.
    #[command(subcommand)]
    pub command: FleetCommand,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub enum FleetCommand {
    /// Ask: a statement, statements from a pipe, or one after the other at a prompt.
    #[command(after_help = "\
Examples:
  wisch-fleet sql \"SELECT tool, avg(performance) FROM episodes GROUP BY tool\" --memory episodes
  wisch-fleet sql \"SELECT * FROM peak_force_per_collision WHERE day = '2026-11-22'\" --fleet s3://robots/fleet --csv
  echo 'SELECT count(*) FROM strokes;' | wisch-fleet sql --fleet /mnt/fleet --memory episodes --json")]
    Sql(SqlArgs),
    /// List the views that are shipped, and what they mean.
    Views(ListArgs),
    /// List all tables and columns with units.
    Columns(ListArgs),
    /// Bring the episodes of a memory into a fleet.
    #[command(
        after_help = "Example:\n  wisch-fleet push episodes s3://robots/fleet --robot kitchen-7"
    )]
    Push(PushArgs),
    /// Bring episodes of a fleet into a memory, byte for byte.
    #[command(after_help = "\
Example:
  wisch-fleet pull s3://robots/fleet kitchen --since 2026-11-01 --where \"performance <= 0.8\"")]
    Pull(PullArgs),
    /// Make few large files of many small ones, and delete what has not counted for long.
    #[command(after_help = "Example:\n  wisch-fleet compact s3://robots/fleet --older-than 7d")]
    Compact(CompactArgs),
    /// Keep telemetry of the last days only.
    #[command(after_help = "Example:\n  wisch-fleet retain s3://robots/fleet --keep-telemetry 30d")]
    Retain(RetainArgs),
    /// Look for what is broken: every file and every episode is read.
    Verify(VerifyArgs),
    /// Run the scheduler of a cluster, which answers `sql --cluster` with the help of executors.
    #[command(after_help = "Example:\n  wisch-fleet scheduler --bind 127.0.0.1:50050")]
    Scheduler(SchedulerArgs),
    /// Run an executor of a cluster. Stores are read with the credentials of its own environment.
    #[command(after_help = "Example:\n  wisch-fleet executor --scheduler 127.0.0.1:50050")]
    Executor(ExecutorArgs),
}

/// Of `sql`.
#[derive(Debug, Args)]
pub struct SqlArgs {
    /// The statement; without one, statements are read from standard input.
    pub statement: Option<String>,
    /// A fleet: s3://BUCKET/PREFIX, file:///FOLDER or a folder. Repeatable.
    #[arg(long, value_name = "URL")]
    pub fleet: Vec<String>,
    /// A memory of episodes on this machine; nothing has to be pushed. Repeatable.
    #[arg(long, value_name = "FOLDER")]
    pub memory: Vec<PathBuf>,
    /// A cluster that answers: the scheduler's address, df://HOST:PORT. Its executors have to reach the same files.
    #[arg(long, value_name = "URL")]
    pub cluster: Option<String>,
    /// Print the answer as CSV.
    #[arg(long, group = "form")]
    pub csv: bool,
    /// Print the answer as JSON, one object a line.
    #[arg(long, group = "form")]
    pub json: bool,
    /// Write the answer to a Parquet file.
    #[arg(long, value_name = "FILE", group = "form")]
    pub parquet: Option<PathBuf>,
    /// Say on standard error how long each statement took.
    #[arg(long)]
    pub timing: bool,
    /// Time limit of a statement [s].
    #[arg(long, value_name = "SECONDS", default_value_t = 300, value_parser = clap::value_parser!(u32).range(1..=86_400))]
    pub timeout: u32,
    /// Memory limit of the program [MB]; sorting and grouping put on disk what is more than half of it.
    #[arg(long, value_name = "MB", default_value_t = 4096, value_parser = clap::value_parser!(u32).range(256..=1_048_576))]
    pub memory_limit: u32,
}

/// Of what lists something.
#[derive(Debug, Args)]
pub struct ListArgs {
    /// Print JSON, one object a line.
    #[arg(long)]
    pub json: bool,
}

/// Of `push`.
#[derive(Debug, Args)]
pub struct PushArgs {
    /// The memory.
    pub memory: PathBuf,
    /// The fleet.
    pub url: String,
    /// Name of the robot, where the model's name in the episodes does not tell robots apart.
    #[arg(long)]
    pub robot: Option<String>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Of `pull`.
#[derive(Debug, Args)]
pub struct PullArgs {
    /// The fleet.
    pub url: String,
    /// The memory, which is made if it is not there.
    pub memory: PathBuf,
    /// Episodes that ended then or later: a day or a time (UTC), such as 2026-11-22 or 2026-11-22T08:00:00Z.
    #[arg(long, value_name = "TIME", value_parser = time)]
    pub since: Option<f64>,
    /// Episodes that began then or earlier; a day counts whole.
    #[arg(long, value_name = "TIME", value_parser = end_time)]
    pub until: Option<f64>,
    /// Episodes of this robot. Repeatable.
    #[arg(long)]
    pub robot: Vec<String>,
    /// Episodes in which something of this class happened, such as HumanCollision. Repeatable.
    #[arg(long)]
    pub class: Vec<String>,
    /// This episode. Repeatable.
    #[arg(long, value_name = "ID")]
    pub episode: Vec<String>,
    /// Episodes for which this is true, in SQL over the table of episodes.
    #[arg(long = "where", value_name = "SQL")]
    pub condition: Option<String>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Of `compact`.
#[derive(Debug, Args)]
pub struct CompactArgs {
    /// The fleet.
    pub url: String,
    /// Objects that have not counted for so long are deleted, such as 12h or 7d: longer than anybody reads or pushes.
    #[arg(long, value_name = "TIME", default_value = "7d", value_parser = span)]
    pub older_than: f64,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Of `retain`.
#[derive(Debug, Args)]
pub struct RetainArgs {
    /// The fleet.
    pub url: String,
    /// How long telemetry is kept, such as 30d; what is older is taken out now, and deleted by `compact`.
    #[arg(long, value_name = "TIME", value_parser = span)]
    pub keep_telemetry: f64,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Of `verify`.
#[derive(Debug, Args)]
pub struct VerifyArgs {
    /// The fleet.
    pub url: String,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Of `scheduler`.
#[derive(Debug, Args)]
#[cfg_attr(not(feature = "cluster"), allow(dead_code))]
pub struct SchedulerArgs {
    /// Where it listens. There is no authentication: another address than this machine's own is for a network that is trusted.
    #[arg(long, value_name = "HOST:PORT", default_value = "127.0.0.1:50050")]
    pub bind: SocketAddr,
    /// How executors reach this machine, where it is not by the address it listens at.
    #[arg(long, value_name = "HOST")]
    pub host: Option<String>,
}

/// Of `executor`.
#[derive(Debug, Args)]
#[cfg_attr(not(feature = "cluster"), allow(dead_code))]
pub struct ExecutorArgs {
    /// The scheduler.
    #[arg(long, value_name = "HOST:PORT")]
    pub scheduler: String,
    /// Where others fetch from it; port 0 is any that is free. There is no authentication.
    #[arg(long, value_name = "HOST:PORT", default_value = "127.0.0.1:0")]
    pub bind: SocketAddr,
    /// How others reach this machine, where it is not by the address it listens at.
    #[arg(long, value_name = "HOST")]
    pub host: Option<String>,
    /// How many tasks it runs at once; without it one for each core.
    #[arg(long, value_name = "N")]
    pub slots: Option<usize>,
    /// Where it keeps what it has made; without it a folder that is gone afterwards.
    #[arg(long, value_name = "DIR")]
    pub work_dir: Option<PathBuf>,
}

const DAY: f64 = 86_400.0;

/// A time or the beginning of a day [s since 1970].
fn time(text: &str) -> Result<f64, String> {
    if let Ok(time) = text.parse::<jiff::Timestamp>() {
        return Ok(time.as_nanosecond() as f64 * 1e-9);
    }
    let day: jiff::civil::Date = text.parse().map_err(|_| {
        "this is neither a day, such as 2026-11-22, nor a time, such as 2026-11-22T08:00:00Z"
            .to_owned()
    })?;
    let start = day.to_zoned(jiff::tz::TimeZone::UTC);
    start
        .map(|start| start.timestamp().as_second() as f64)
        .map_err(|error| error.to_string())
}

/// A time or the end of a day [s since 1970].
fn end_time(text: &str) -> Result<f64, String> {
    let is_day = text.parse::<jiff::Timestamp>().is_err();
    let start = time(text)?;
    Ok(if is_day { start + DAY - 1e-6 } else { start })
}

/// How long [s].
fn span(text: &str) -> Result<f64, String> {
    let (digits, unit) = text.split_at(
        text.trim_end_matches(|c: char| c.is_ascii_alphabetic())
            .len(),
    );
    let unit = match unit {
        "d" => DAY,
        "h" => 3600.0,
        "min" => 60.0,
        "s" => 1.0,
        _ => {
            return Err("a length of time is a number with d, h, min or s, such as 30d".to_owned());
        }
    };
    let number: f64 = digits
        .parse()
        .map_err(|_| format!("{digits:?} is no number"))?;
    if number.is_finite() && number >= 0.0 {
        return Ok(number * unit);
    }
    Err(format!("{number} is no length of time"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_read_as_they_are_meant() {
        assert_eq!(time("1970-01-02"), Ok(DAY));
        assert_eq!(time("1970-01-02T01:00:00Z"), Ok(DAY + 3600.0));
        assert!(end_time("1970-01-01").unwrap() > DAY - 1.0);
        assert_eq!(end_time("1970-01-01T00:00:10Z"), Ok(10.0));
        assert_eq!(span("30d"), Ok(30.0 * DAY));
        assert_eq!(span("90min"), Ok(5400.0));
        assert!(span("30").is_err() && span("d").is_err() && span("-1d").is_err());
    }
}
