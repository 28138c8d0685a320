//! Arguments of what concerns a fleet: a store of the episodes of many robots.

use super::MemoryArgs;
use clap::Args;

/// Which episodes of a fleet are meant; of each kind of condition one must hold.
#[derive(Debug, Args)]
pub struct SelectionArgs {
    /// Of a fleet, episodes that ended then or later: a day or a time (UTC), such as 2026-11-22
    #[arg(long, value_name = "TIME")]
    pub since: Option<String>,
    /// Of a fleet, episodes that began then or earlier
    #[arg(long, value_name = "TIME")]
    pub until: Option<String>,
    /// Of a fleet, episodes of this robot; repeatable
    #[arg(long, value_name = "NAME")]
    pub robot: Vec<String>,
    /// Of a fleet, episodes in which something of this class happened, such as HumanCollision; repeatable
    #[arg(long, value_name = "CLASS")]
    pub class: Vec<String>,
    /// Of a fleet, this episode; repeatable
    #[arg(long, value_name = "ID")]
    pub episode: Vec<String>,
    /// Of a fleet, episodes for which this is true, in SQL over its table of episodes, such as "performance <= 0.8"
    #[arg(long = "where", value_name = "SQL")]
    pub condition: Option<String>,
}

impl SelectionArgs {
    /// The same arguments again.
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
    /// Name of this robot, where the model's name in the episodes does not tell robots apart
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
    /// Which episodes.
    #[command(flatten)]
    pub selection: SelectionArgs,
    /// Print one JSON object instead of the summary
    #[arg(long)]
    pub json: bool,
}
