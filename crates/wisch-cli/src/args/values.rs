//! Parsers of values, whose errors state what is expected.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use std::path::PathBuf;
use wisch::plan::Strategy;
use wisch::represent::Action;

/// Returns a parser of planning strategies.
pub(super) fn strategy_parser() -> impl TypedValueParser<Value = Strategy> {
    PossibleValuesParser::new(Strategy::ALL.map(Strategy::as_str)).try_map(|name| name.parse())
}

/// Returns a parser of wiping actions.
pub(super) fn action_parser() -> impl TypedValueParser<Value = Action> {
    let names = Action::ALL
        .map(|action| PossibleValue::new(action.as_str()).aliases(action.earlier_name()));
    PossibleValuesParser::new(names).try_map(|name| name.parse())
}

/// Parses KEY=VALUE, an override of a value of the task file.
pub(super) fn parse_setting(text: &str) -> Result<(String, String), String> {
    let (key, value) = text
        .split_once('=')
        .ok_or("\"=\" is missing; write KEY=VALUE with a key of the task file")?;
    if key.trim().is_empty() {
        return Err("the key before \"=\" is missing; write KEY=VALUE".to_owned());
    }
    Ok((key.trim().to_owned(), value.trim().to_owned()))
}

/// Parses a time, from 0.001 to 86400 \[s\].
pub(super) fn parse_seconds(text: &str) -> Result<f64, String> {
    let number: f64 = text
        .parse()
        .map_err(|_| "not a number; write seconds, such as 60".to_owned())?;
    if (0.001..=86_400.0).contains(&number) {
        return Ok(number);
    }
    Err(format!("{number} s is outside 0.001 to 86400 s"))
}

/// Parses a share, above 0 and at most 1 \[1\].
pub(super) fn parse_share(text: &str) -> Result<f64, String> {
    let number: f64 =
        (text.parse()).map_err(|_| "not a number; write a share, such as 0.25".to_owned())?;
    if number > 0.0 && number <= 1.0 {
        return Ok(number);
    }
    Err(format!(
        "{number} is outside its limits: above 0 and at most 1"
    ))
}

/// Parses a height above the surface, from 0.005 to 0.5 \[m\].
pub(super) fn parse_height(text: &str) -> Result<f64, String> {
    let number: f64 =
        (text.parse()).map_err(|_| "not a number; write metres, such as 0.05".to_owned())?;
    if (0.005..=0.5).contains(&number) {
        return Ok(number);
    }
    Err(format!("{number} m is outside 0.005 to 0.5 m"))
}

/// Reads a compression depth \[m\], within the limits of the key `compression_depth_m`.
pub(super) fn parse_compression_depth(text: &str) -> Result<f64, String> {
    let number: f64 =
        (text.parse()).map_err(|_| "not a number; write metres, such as 0.002".to_owned())?;
    if (0.0..=0.1).contains(&number) {
        return Ok(number);
    }
    Err(format!("{number} m is outside 0 (rigid) to 0.1 m"))
}

/// Parses NAME=DIR, the name of a ROS package and its folder.
pub(super) fn parse_package(text: &str) -> Result<(String, PathBuf), String> {
    match text.split_once('=') {
        Some((name, folder)) if !name.trim().is_empty() && !folder.is_empty() => {
            Ok((name.trim().to_owned(), PathBuf::from(folder)))
        }
        _ => Err("write NAME=DIR: the package's name and its folder".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::parse_setting;

    #[test]
    fn a_setting_splits_at_its_first_equals_sign() {
        assert_eq!(
            parse_setting("goal.literal = (a b=c)"),
            Ok(("goal.literal".to_owned(), "(a b=c)".to_owned()))
        );
        assert!(parse_setting("seed").is_err());
        assert!(parse_setting("=3").is_err());
    }
}
