//! Arguments of the commands that use a fleet: a store with the episodes of many robots.

use super::MemoryArgs;
use clap::Args;

/// A selection of episodes of a fleet. An episode must meet every given kind of condition, and of a repeated
/// condition at least one value.
#[derive(Debug, Args)]
pub struct SelectionArgs {
    /// Select fleet episodes that ended at or after this day or time (UTC), such as 2026-11-22
    #[arg(long, value_name = "TIME")]
    pub since: Option<String>,
    /// Select fleet episodes that began at or before this day or time (UTC)
    #[arg(long, value_name = "TIME")]
    pub until: Option<String>,
    /// Select fleet episodes of this robot; repeatable
    #[arg(long, value_name = "NAME")]
    pub robot: Vec<String>,
    /// Select fleet episodes with an event of this class, such as HumanCollision; repeatable
    #[arg(long, value_name = "CLASS")]
    pub class: Vec<String>,
    /// Select the fleet episode with this name; repeatable
    #[arg(long, value_name = "ID")]
    pub episode: Vec<String>,
    /// Select fleet episodes that meet this SQL condition on the table of episodes, such as "performance <= 0.8"
    #[arg(long = "where", value_name = "SQL")]
    pub condition: Option<String>,
}

impl SelectionArgs {
    /// Returns the selection as command-line arguments, for the companion program.
    pub fn to_arguments(&self) -> Vec<String> {
        let one = |name: &str, value: &Option<String>| {
            let value = value.iter();
            value
                .flat_map(|value| [format!("--{name}"), value.clone()])
                .collect()
        };
        let many = |name: &str, values: &[String]| {
            let values = values.iter();
            values
                .flat_map(|value| [format!("--{name}"), value.clone()])
                .collect()
        };
        let all: [Vec<String>; 6] = [
            one("since", &self.since),
            one("until", &self.until),
            many("robot", &self.robot),
            many("class", &self.class),
            many("episode", &self.episode),
            one("where", &self.condition),
        ];
        all.concat()
    }
}

/// Arguments of `memory push`.
#[derive(Debug, Args)]
pub struct MemoryPushArgs {
    /// The fleet: s3://BUCKET/PREFIX, file:///FOLDER or a folder
    pub url: String,
    /// The memory.
    #[command(flatten)]
    pub memory: MemoryArgs,
    /// Name of this robot; needed if several robots of the fleet share the model name in their episodes
    #[arg(long, value_name = "NAME")]
    pub robot: Option<String>,
    /// Print one JSON object instead of the summary
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `memory pull`.
#[derive(Debug, Args)]
pub struct MemoryPullArgs {
    /// The fleet: s3://BUCKET/PREFIX, file:///FOLDER or a folder
    pub url: String,
    /// The memory.
    #[command(flatten)]
    pub memory: MemoryArgs,
    /// The selected episodes.
    #[command(flatten)]
    pub selection: SelectionArgs,
    /// Print one JSON object instead of the summary
    #[arg(long)]
    pub json: bool,
}
