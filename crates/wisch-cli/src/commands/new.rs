//! `wisch new` and `wisch schema`: a commented task file, and the JSON Schema with which editors check it.

use super::words::internal;
use crate::args::{GlobalArgs, NewArgs, SchemaArgs};
use crate::failure::Failure;
use crate::terminal::{Outcome, print, print_json};
use wisch_io::{OutputFile, TaskFile, shell_word, shipped_scenarios};

/// The shipped scenario whose goal has several parts.
const WITH_SEVERAL_PARTS: &str = "kitchen";
/// The schema's file name, which the template's first line points editors to.
const SCHEMA_FILE: &str = "wisch-task.schema.json";

/// Prints the schema of task files.
pub fn schema(args: &SchemaArgs) -> Result<Outcome, Failure> {
    let text = TaskFile::json_schema();
    if args.json {
        print_json(&serde_json::from_str::<serde_json::Value>(&text).map_err(internal)?)?;
    } else {
        print(&text)?;
    }
    Ok(Outcome::Done)
}

/// Returns the text to start from.
fn template(args: &NewArgs) -> Result<&'static str, Failure> {
    if !args.goal {
        return Ok(TaskFile::TEMPLATE);
    }
    let shipped = shipped_scenarios().find(|(name, _)| *name == WITH_SEVERAL_PARTS);
    let (_, text) = shipped.ok_or_else(|| internal("the scenario is not shipped"))?;
    Ok(text)
}

/// Writes the template, and the schema beside it.
pub fn new(args: &NewArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let template = template(args)?;
    let Some(path) = &args.file else {
        if args.json {
            print_json(&serde_json::json!({ "task_file": template }))?;
        } else {
            print(template)?;
        }
        return Ok(Outcome::Done);
    };
    let shown = path.display();
    if path.exists() && !args.force {
        return Err(Failure::new("the file exists already")
            .within(path)
            .with_help("choose another name, or overwrite it with --force"));
    }
    // The schema belongs to the program, and is written again.
    let schema = path.with_file_name(SCHEMA_FILE);
    let [file, of_schema] = [path, &schema].map(|path| OutputFile::begin(path));
    let (file, of_schema) = (file?, of_schema?);
    of_schema.finish(TaskFile::json_schema().as_bytes())?;
    if args.force {
        file.finish(template.as_bytes())?;
    } else {
        // Another program may have made the file meanwhile.
        file.finish_new(template.as_bytes())?;
    }
    if args.json {
        let written = [path, &schema].map(|path| path.display().to_string());
        print_json(&serde_json::json!({ "written": written }))?;
    } else if !global.quiet {
        let word = shell_word(&shown.to_string());
        print(&format!(
            "wrote {shown} and its schema for editors, {}\nnext: wisch check {word}, then wisch run {word}\n",
            schema.display()
        ))?;
    }
    Ok(Outcome::Done)
}
