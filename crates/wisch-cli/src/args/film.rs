//! Arguments of `film`.

use super::MemoryArgs;
use clap::{Args, ValueHint};
use std::path::PathBuf;

/// Arguments of `film`.
#[derive(Debug, Args)]
pub struct FilmArgs {
    /// Episode of the memory, or folder of results
    #[arg(value_name = "EPISODE|FOLDER", value_hint = ValueHint::AnyPath)]
    pub what: String,
    /// WebM file to write [default: the name of the episode or folder, with .webm]
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub out: Option<PathBuf>,
    /// The memory.
    #[command(flatten)]
    pub memory: MemoryArgs,
    /// Round to record [default: the whole run]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub round: Option<u32>,
    /// Speed relative to the robot's clock: 1, 2, 5 or 10
    #[arg(long, value_name = "FACTOR", default_value = "5", value_parser = parse_film_speed)]
    pub speed: u32,
    /// Size of the page whose scene is recorded [pixels]
    #[arg(long, value_name = "WIDTHxHEIGHT", default_value = "1600x1000", value_parser = parse_film_size)]
    pub size: [u32; 2],
    /// Program of the browser [default: Chromium, Chrome or Edge in PATH]
    #[arg(long, value_name = "FILE", value_hint = ValueHint::ExecutablePath)]
    pub browser: Option<PathBuf>,
    /// Print one JSON object instead of the summary
    #[arg(long)]
    pub json: bool,
}

/// Parses the speed of a film.
fn parse_film_speed(text: &str) -> Result<u32, String> {
    let speed = text.parse().ok();
    speed
        .filter(|speed| [1, 2, 5, 10].contains(speed))
        .ok_or_else(|| "the speed is 1, 2, 5 or 10".to_owned())
}

/// Parses the size of a page [pixels].
fn parse_film_size(text: &str) -> Result<[u32; 2], String> {
    let sides = text.split_once('x').and_then(|(width, height)| {
        Some([width.parse::<u32>().ok()?, height.parse::<u32>().ok()?])
    });
    sides
        .filter(|sides| sides.iter().all(|side| (320..=3840).contains(side)))
        .ok_or_else(|| "a size is width and height from 320 to 3840, such as 1600x1000".to_owned())
}
