//! The command line.

use clap::{Args, Parser, Subcommand};
use std::net::SocketAddr;
use std::path::PathBuf;

/// SQL over the episodes of many robots, and transfer of episodes between memories and a shared store.
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
~/.aws/credentials. Exit codes: 0 success, 1 faults found or episodes left out, 2 an error."
)]
pub struct FleetCli {
    /// Command.
    #[command(subcommand)]
    pub command: FleetCommand,
}

/// Commands of the program.
#[derive(Debug, Subcommand)]
pub enum FleetCommand {
    /// Answer SQL: one statement, statements from a pipe, or statements at a prompt.
    #[command(after_help = "\
Examples:
  wisch-fleet sql \"SELECT tool, avg(performance) FROM episodes GROUP BY tool\" --memory episodes
  wisch-fleet sql \"SELECT * FROM peak_force_per_collision WHERE day = '2026-11-22'\" --fleet s3://robots/fleet --csv
  echo 'SELECT count(*) FROM strokes;' | wisch-fleet sql --fleet /mnt/fleet --memory episodes --json")]
    Sql(SqlArgs),
    /// List the built-in views and their meaning.
    Views(ListArgs),
    /// List all tables and columns with units.
    Columns(ListArgs),
    /// Copy the episodes of a memory into a fleet.
    #[command(
        after_help = "Example:\n  wisch-fleet push episodes s3://robots/fleet --robot kitchen-7"
    )]
    Push(PushArgs),
    /// Copy episodes of a fleet into a memory, byte for byte.
    #[command(after_help = "\
Example:
  wisch-fleet pull s3://robots/fleet kitchen --since 2026-11-01 --where \"performance <= 0.8\"")]
    Pull(PullArgs),
    /// Remove episodes from a fleet: their rows and their archives.
    #[command(after_help = "Example:\n  wisch-fleet forget s3://robots/fleet 20261122-005612-3f2a")]
    Forget(ForgetArgs),
    /// Merge small files into large ones, and delete objects that have long been unused.
    #[command(after_help = "Example:\n  wisch-fleet compact s3://robots/fleet --older-than 7d")]
    Compact(CompactArgs),
    /// Delete telemetry except that of the last days.
    #[command(after_help = "Example:\n  wisch-fleet retain s3://robots/fleet --keep-telemetry 30d")]
    Retain(RetainArgs),
    /// Verify every file and every episode of a fleet.
    Verify(VerifyArgs),
    /// Run the scheduler of a cluster, which answers `sql --cluster` together with executors.
    #[command(after_help = "Example:\n  wisch-fleet scheduler --bind 127.0.0.1:50050")]
    Scheduler(SchedulerArgs),
    /// Run an executor of a cluster. It reads stores with the credentials of its own environment.
    #[command(after_help = "Example:\n  wisch-fleet executor --scheduler 127.0.0.1:50050")]
    Executor(ExecutorArgs),
}

/// Arguments of `sql`.
#[derive(Debug, Args)]
pub struct SqlArgs {
    /// The statement; without it, statements are read from standard input.
    pub statement: Option<String>,
    /// A fleet: s3://BUCKET/PREFIX, file:///FOLDER or a folder. Repeatable.
    #[arg(long, value_name = "URL")]
    pub fleet: Vec<String>,
    /// A memory of episodes on this machine, which need not be pushed. Repeatable.
    #[arg(long, value_name = "FOLDER")]
    pub memory: Vec<PathBuf>,
    /// A cluster that answers: the scheduler's address, df://HOST:PORT. Its executors must reach the same files.
    #[arg(long, value_name = "URL")]
    pub cluster: Option<String>,
    /// Print the answer as CSV.
    #[arg(long, group = "form")]
    pub csv: bool,
    /// Print the answer as JSON, one object per line.
    #[arg(long, group = "form")]
    pub json: bool,
    /// Write the answer to a Parquet file.
    #[arg(long, value_name = "FILE", group = "form")]
    pub parquet: Option<PathBuf>,
    /// Print the duration of each statement on standard error.
    #[arg(long)]
    pub timing: bool,
    /// Time limit of a statement [s].
    #[arg(long, value_name = "SECONDS", default_value_t = 300, value_parser = clap::value_parser!(u32).range(1..=86_400))]
    pub timeout: u32,
    /// Memory limit of the program [MB]; sorting and grouping move to disk above half of it.
    #[arg(long, value_name = "MB", default_value_t = 4096, value_parser = clap::value_parser!(u32).range(256..=1_048_576))]
    pub memory_limit: u32,
}

/// Arguments of commands that list something.
#[derive(Debug, Args)]
pub struct ListArgs {
    /// Print JSON, one object per line.
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `push`.
#[derive(Debug, Args)]
pub struct PushArgs {
    /// The memory.
    pub memory: PathBuf,
    /// The fleet.
    pub url: String,
    /// Name of the robot, if the model's name in the episodes is not unique in the fleet.
    #[arg(long)]
    pub robot: Option<String>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `pull`.
#[derive(Debug, Args)]
pub struct PullArgs {
    /// The fleet.
    pub url: String,
    /// The memory, created if necessary.
    pub memory: PathBuf,
    /// Episodes that ended at this time or later: a day or a time (UTC), such as 2026-11-22 or 2026-11-22T08:00:00Z.
    #[arg(long, value_name = "TIME", value_parser = time)]
    pub since: Option<f64>,
    /// Episodes that began at this time or earlier; a day includes its end.
    #[arg(long, value_name = "TIME", value_parser = end_time)]
    pub until: Option<f64>,
    /// Episodes of this robot. Repeatable.
    #[arg(long)]
    pub robot: Vec<String>,
    /// Episodes with an event of this class, such as HumanCollision. Repeatable.
    #[arg(long)]
    pub class: Vec<String>,
    /// This episode. Repeatable.
    #[arg(long, value_name = "ID")]
    pub episode: Vec<String>,
    /// Episodes that meet this condition, in SQL over the table of episodes.
    #[arg(long = "where", value_name = "SQL")]
    pub condition: Option<String>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `forget`.
#[derive(Debug, Args)]
pub struct ForgetArgs {
    /// The fleet.
    pub url: String,
    /// The episodes, by name.
    #[arg(value_name = "ID", required = true)]
    pub ids: Vec<String>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `compact`.
#[derive(Debug, Args)]
pub struct CompactArgs {
    /// The fleet.
    pub url: String,
    /// Delete objects that have been unused for this time, such as 12h or 7d; choose it longer than any read or push
    /// takes.
    #[arg(long, value_name = "TIME", default_value = "7d", value_parser = span)]
    pub older_than: f64,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `retain`.
#[derive(Debug, Args)]
pub struct RetainArgs {
    /// The fleet.
    pub url: String,
    /// How long telemetry is kept, such as 30d; older telemetry becomes unused now, and `compact` deletes it.
    #[arg(long, value_name = "TIME", value_parser = span)]
    pub keep_telemetry: f64,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `verify`.
#[derive(Debug, Args)]
pub struct VerifyArgs {
    /// The fleet.
    pub url: String,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `scheduler`.
#[derive(Debug, Args)]
#[cfg_attr(not(feature = "cluster"), allow(dead_code))]
pub struct SchedulerArgs {
    /// Address at which it listens. There is no authentication: use other addresses than this machine's own only in a
    /// trusted network.
    #[arg(long, value_name = "HOST:PORT", default_value = "127.0.0.1:50050")]
    pub bind: SocketAddr,
    /// Name by which executors reach this machine, if it differs from the address.
    #[arg(long, value_name = "HOST")]
    pub host: Option<String>,
}

/// Arguments of `executor`.
#[derive(Debug, Args)]
#[cfg_attr(not(feature = "cluster"), allow(dead_code))]
pub struct ExecutorArgs {
    /// The scheduler.
    #[arg(long, value_name = "HOST:PORT")]
    pub scheduler: String,
    /// Address at which other executors fetch results; port 0 for any free port. There is no authentication.
    #[arg(long, value_name = "HOST:PORT", default_value = "127.0.0.1:0")]
    pub bind: SocketAddr,
    /// Name by which others reach this machine, if it differs from the address.
    #[arg(long, value_name = "HOST")]
    pub host: Option<String>,
    /// Number of simultaneous tasks; by default one per core.
    #[arg(long, value_name = "N")]
    pub slots: Option<usize>,
    /// Folder of its results; by default a temporary folder.
    #[arg(long, value_name = "DIR")]
    pub work_dir: Option<PathBuf>,
}

const DAY: f64 = 86_400.0;

/// Parses a time or the beginning of a day [s since 1970].
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

/// Parses a time or the end of a day [s since 1970].
fn end_time(text: &str) -> Result<f64, String> {
    let is_day = text.parse::<jiff::Timestamp>().is_err();
    let start = time(text)?;
    Ok(if is_day { start + DAY - 1e-6 } else { start })
}

/// Parses a duration [s].
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
            return Err("a duration is a number with d, h, min or s, such as 30d".to_owned());
        }
    };
    let number: f64 = digits
        .parse()
        .map_err(|_| format!("{digits:?} is not a number"))?;
    if number.is_finite() && number >= 0.0 {
        return Ok(number * unit);
    }
    Err(format!("{number} is not a valid duration"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_and_days_are_parsed() {
        assert_eq!(time("1970-01-02"), Ok(DAY));
        assert_eq!(time("1970-01-02T01:00:00Z"), Ok(DAY + 3600.0));
        assert!(end_time("1970-01-01").unwrap() > DAY - 1.0);
        assert_eq!(end_time("1970-01-01T00:00:10Z"), Ok(10.0));
        assert_eq!(span("30d"), Ok(30.0 * DAY));
        assert_eq!(span("90min"), Ok(5400.0));
        assert!(span("30").is_err() && span("d").is_err() && span("-1d").is_err());
    }
}
