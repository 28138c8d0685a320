//! Task files whose goal has several parts: several surfaces, media on them, and tools in a rack. Each part is a task.

use super::TaskError;
use super::tree::{Source, description, float, integer};
use std::borrow::Cow;
use toml::Spanned;
use toml::de::{DeTable, DeValue};
use wisch::goal::{CompoundGoal, GoalLiteral, MediumOnSurface};
use wisch::source_location::{Place, UnknownName};

/// Keys that a `[[medium]]` may have for its part of the goal, in place of those of the file.
const OF_MEDIUM: [&str; 10] = [
    "strategy",
    "target_performance",
    "interaction",
    "collect",
    "polish",
    "dispense",
    "particles",
    "perception",
    "plan",
    "execution",
];
/// Keys of settings that are not of a single part of the goal.
const OF_ALL: [&str; 8] = [
    "action",
    "goal",
    "name",
    "seed",
    "tool.name",
    "tool.in_hand",
    "tool.available",
    "tool.rack",
];
/// Largest number of surfaces, of media and of tools in the rack.
const MOST: usize = 64;
/// Largest coordinate of a place in the rack [m].
const FARTHEST: f64 = 100.0;

/// A tool with the place at which it is fetched and put back.
#[derive(Debug, Clone, PartialEq)]
pub struct RackTool {
    /// Name of the tool in the knowledge base.
    pub name: String,
    /// Place in the world \[m\]; `None` if the file states none.
    pub position: Option<[f64; 3]>,
}

/// What a task file with a goal of several parts states beside the tables of its parts.
#[derive(Debug, Clone)]
pub(crate) struct Parts {
    /// Name of the task.
    pub(crate) name: String,
    /// The goal.
    pub(crate) goal: CompoundGoal,
    /// The media, each with its surface.
    pub(crate) media: Vec<MediumOnSurface>,
    /// Tool in the hand.
    pub(crate) tool_in_hand: Option<String>,
    /// Tools that the robot can fetch.
    pub(crate) tools: Vec<RackTool>,
}

type Value<'a> = Spanned<DeValue<'a>>;

/// Reads the parts of a task file; `None` if its goal is a single fact.
pub(super) fn read(source: &Source<'_>) -> Result<Option<Parts>, TaskError> {
    let mut root = source.parse()?;
    source.apply(&mut root, |key| OF_ALL.contains(&key))?;
    let Some(StatedGoal { goal, is_fact, at }) = stated_goal(&root, source)? else {
        return Ok(None);
    };
    if is_fact {
        return Ok(None);
    }
    let surfaces = elements(&root, "surface", source)?;
    if surfaces.len() > 1 {
        refuse_scene_on_surface(&root, source)?;
    }
    let mut media = Vec::new();
    for medium in elements(&root, "medium", source)? {
        let on = MediumOnSurface {
            medium: name_of(medium, "medium", source)?,
            surface: surface_of(medium, &surfaces, source)?,
        };
        if media.contains(&on) {
            let problem = format!("{} on {} is stated twice", on.medium, on.surface);
            return Err(fault(source.place(medium.span().start), "medium", problem));
        }
        media.push(on);
    }
    for (_, fact) in goal.parts() {
        let is_known = |word: &String| {
            media
                .iter()
                .any(|on| on.medium == *word || on.surface == *word)
        };
        if !fact.arguments().iter().any(is_known) {
            let problem = format!("{fact} names no medium and no surface of this file");
            return Err(fault(at, "goal", problem));
        }
    }
    let tool = get(&root, "tool");
    let text = |key: &str| {
        tool.and_then(|tool| get(tool, key))
            .and_then(|value| value.get_ref().as_str())
    };
    let mut tools = rack(tool, source)?;
    let available = tool
        .and_then(|tool| get(tool, "available"))
        .and_then(|list| list.get_ref().as_array());
    for name in available
        .into_iter()
        .flatten()
        .filter_map(|name| name.get_ref().as_str())
    {
        if tools.iter().all(|tool| tool.name != name) {
            tools.push(RackTool {
                name: name.to_owned(),
                position: None,
            });
        }
    }
    Ok(Some(Parts {
        name: name_of(&root, "task", source)?,
        goal,
        media,
        tool_in_hand: text("in_hand").or_else(|| text("name")).map(str::to_owned),
        tools,
    }))
}

/// Refuses objects of the scene whose poses refer to a surface, which would be another place for each surface.
fn refuse_scene_on_surface(root: &Value<'_>, source: &Source<'_>) -> Result<(), TaskError> {
    for object in elements(root, "scene", source)? {
        if let Some(frame) = get(object, "frame")
            && frame.get_ref().as_str() == Some("surface")
        {
            let problem = "\"surface\" is a different place for each of the surfaces of this file; state the pose in the world";
            let at = source.place(frame.span().start);
            return Err(fault(at, "scene.frame", problem.to_owned()));
        }
    }
    Ok(())
}

/// Returns the tree of a task with its settings. Of a file with several surfaces or media, it keeps those of the goal.
pub(super) fn tree<'a>(source: &Source<'a>) -> Result<Value<'a>, TaskError> {
    let mut root = source.parse()?;
    let is_rack = |key: &str| key == "tool.rack" || key.starts_with("tool.rack.");
    source.apply(&mut root, |key| key == "goal" || is_rack(key))?;
    select(&mut root, source)?;
    source.apply(&mut root, |key| !is_rack(key))?;
    Ok(root)
}

/// Reduces the tree of a file with several surfaces or media to the task of its goal, which must be a single fact about a
/// medium on a surface.
fn select(root: &mut Value<'_>, source: &Source<'_>) -> Result<(), TaskError> {
    let Some(StatedGoal { goal, is_fact, at }) = stated_goal(root, source)? else {
        return Ok(());
    };
    let parts: Vec<String> = goal.parts().map(|(_, fact)| fact.to_string()).collect();
    if parts.len() > 1 {
        let problem = format!(
            "the goal has {} parts, but this command needs one: choose it, for example with --set goal='{}'",
            parts.len(),
            parts[0]
        );
        return Err(fault(at, "goal", problem));
    }
    let Some((_, fact)) = goal.parts().find(|(holds, _)| *holds) else {
        let problem = format!("{goal} is negated, but this command needs a fact that is to hold");
        return Err(fault(at, "goal", problem));
    };
    if !is_fact && let Some(value) = get_mut(root, "goal") {
        *value.get_mut() = DeValue::String(Cow::Owned(fact.to_string()));
    }
    let names = fact.arguments();
    let is_named = |value: &Value<'_>| {
        let name = get(value, "name").and_then(|name| name.get_ref().as_str());
        name.is_some_and(|name| names.iter().any(|other| other == name))
    };
    let surfaces = elements(root, "surface", source)?;
    let media = elements(root, "medium", source)?;
    let position = |all: &[&Value<'_>], is_it: &dyn Fn(&Value<'_>) -> bool| {
        all.iter().position(|value| is_it(value))
    };
    let surface = position(&surfaces, &is_named);
    let lies_there = |medium: &Value<'_>| {
        is_named(medium)
            && surface_of(medium, &surfaces, source).is_ok_and(|on| names.contains(&on))
    };
    let medium = position(&media, &lies_there);
    for (table, chosen) in [("surface", surface), ("medium", medium)] {
        if chosen.is_none()
            && get(root, table).is_some_and(|value| value.get_ref().as_array().is_some())
        {
            let known: Vec<String> = elements(root, table, source)?
                .into_iter()
                .filter_map(|value| name_of(value, table, source).ok())
                .collect();
            let problem = format!(
                "{} names no {table} of this file, which has {}",
                parts[0],
                known.join(", ")
            );
            return Err(fault(at, "goal", problem));
        }
    }
    take(root, "surface", surface);
    take(root, "medium", medium);
    spread(root);
    make_rack_available(root, source)
}

/// Replaces an array of tables by one of them.
fn take(root: &mut Value<'_>, key: &str, chosen: Option<usize>) {
    if let Some(value) = get_mut(root, key)
        && let DeValue::Array(items) = value.get_mut()
        && let Some(index) = chosen
    {
        *value = items[index].clone();
    }
}

/// Moves the keys of a medium's part from its table to the file.
fn spread(root: &mut Value<'_>) {
    let Some(DeValue::Table(medium)) = get_mut(root, "medium").map(Spanned::get_mut) else {
        return;
    };
    medium.remove("on");
    let own: Vec<_> = OF_MEDIUM
        .iter()
        .filter_map(|key| medium.remove_entry(*key))
        .collect();
    let DeValue::Table(file) = root.get_mut() else {
        return;
    };
    for (key, value) in own {
        match (
            file.get_mut(key.get_ref().as_ref()).map(Spanned::get_mut),
            value,
        ) {
            (Some(DeValue::Table(general)), own) if own.get_ref().as_table().is_some() => {
                if let DeValue::Table(own) = own.into_inner() {
                    for (key, value) in own {
                        general.remove(key.get_ref().as_ref());
                        general.insert(key, value);
                    }
                }
            }
            (_, own) => {
                file.remove(key.get_ref().as_ref());
                file.insert(key, own);
            }
        }
    }
}

/// Replaces the rack of the table `[tool]` by the names of its tools.
fn make_rack_available(root: &mut Value<'_>, source: &Source<'_>) -> Result<(), TaskError> {
    let names = rack(get(root, "tool"), source)?;
    let Some(DeValue::Table(tool)) = get_mut(root, "tool").map(Spanned::get_mut) else {
        return Ok(());
    };
    let Some((key, value)) = tool.remove_entry("rack") else {
        return Ok(());
    };
    let names = names.into_iter().map(|tool| {
        let span = value.span();
        Spanned::new(span, DeValue::String(Cow::Owned(tool.name)))
    });
    let list = Spanned::new(value.span(), DeValue::Array(names.collect()));
    if !tool.contains_key("available") {
        tool.insert(Spanned::new(key.span(), Cow::Borrowed("available")), list);
    }
    Ok(())
}

/// The goal of a file.
struct StatedGoal {
    goal: CompoundGoal,
    /// Whether it is a single fact, without `and` and `not`.
    is_fact: bool,
    at: Place,
}

/// Returns the goal of a file with several surfaces or media, or whose goal is not a single fact.
fn stated_goal(root: &Value<'_>, source: &Source<'_>) -> Result<Option<StatedGoal>, TaskError> {
    let Some(value) = get(root, "goal") else {
        return Ok(None);
    };
    let at = source.place(value.span().start);
    let Some(text) = value.get_ref().as_str() else {
        return Ok(None);
    };
    let is_several = ["surface", "medium"]
        .iter()
        .any(|key| get(root, key).is_some_and(|value| value.get_ref().as_array().is_some()));
    match CompoundGoal::parse(text) {
        Ok(goal) => {
            let is_fact = GoalLiteral::parse(text).is_ok();
            Ok((is_several || !is_fact).then_some(StatedGoal { goal, is_fact, at }))
        }
        // A goal of a single part is checked when it is resolved.
        Err(_) if !is_several => Ok(None),
        Err(error) => Err(fault(at, "goal", error.to_string())),
    }
}

/// Returns the tables of an array, or the only table.
fn elements<'r, 'a>(
    root: &'r Value<'a>,
    key: &str,
    source: &Source<'_>,
) -> Result<Vec<&'r Value<'a>>, TaskError> {
    let Some(value) = get(root, key) else {
        return Ok(Vec::new());
    };
    let items = match value.get_ref() {
        DeValue::Array(items) => items.iter().collect(),
        _ => vec![value],
    };
    if items.len() > MOST {
        let problem = format!("{} tables exceed the limit of {MOST}", items.len());
        return Err(fault(source.place(value.span().start), key, problem));
    }
    Ok(items)
}

/// Returns the name of the surface on which a medium lies.
fn surface_of(
    medium: &Value<'_>,
    surfaces: &[&Value<'_>],
    source: &Source<'_>,
) -> Result<String, TaskError> {
    let names = surfaces
        .iter()
        .map(|surface| name_of(surface, "surface", source));
    let names: Vec<String> = names.collect::<Result<_, _>>()?;
    let at = source.place(medium.span().start);
    match (get(medium, "on"), &names[..]) {
        (None, [only]) => Ok(only.clone()),
        (None, _) => Err(TaskError::Missing {
            at,
            table: "medium".to_owned(),
            key: "on",
        }),
        (Some(on), _) => {
            let at = source.place(on.span().start);
            let Some(name) = on.get_ref().as_str() else {
                return Err(wrong(at, "medium.on", "the name of a surface", on));
            };
            if names.iter().any(|known| known == name) {
                return Ok(name.to_owned());
            }
            let known = names.iter().map(String::as_str);
            Err(TaskError::UnknownReference {
                at,
                unknown: Box::new(UnknownName::new("surface", name, known)),
            })
        }
    }
}

fn name_of(value: &Value<'_>, table: &str, source: &Source<'_>) -> Result<String, TaskError> {
    let at = source.place(value.span().start);
    let Some(name) = get(value, "name") else {
        return Err(TaskError::Missing {
            at,
            table: table.to_owned(),
            key: "name",
        });
    };
    let at = source.place(name.span().start);
    let text = name.get_ref().as_str();
    text.map(str::to_owned)
        .ok_or_else(|| wrong(at, &format!("{table}.name"), "a name", name))
}

/// Reads the tools of the rack.
fn rack(tool: Option<&Value<'_>>, source: &Source<'_>) -> Result<Vec<RackTool>, TaskError> {
    let Some(rack) = tool.and_then(|tool| get(tool, "rack")) else {
        return Ok(Vec::new());
    };
    let at = source.place(rack.span().start);
    let Some(items) = rack.get_ref().as_array() else {
        return Err(wrong(at, "tool.rack", "an array of tables", rack));
    };
    if items.len() > MOST {
        let problem = format!("{} tools exceed the limit of {MOST}", items.len());
        return Err(fault(at, "tool.rack", problem));
    }
    items.iter().map(|item| rack_tool(item, source)).collect()
}

fn rack_tool(item: &Value<'_>, source: &Source<'_>) -> Result<RackTool, TaskError> {
    let at = source.place(item.span().start);
    let Some(table) = item.get_ref().as_table() else {
        return Err(wrong(
            at,
            "tool.rack",
            "a table with name and position_m",
            item,
        ));
    };
    check_keys(table, source)?;
    let position = get(item, "position_m").map(|value| {
        let at = source.place(value.span().start);
        let numbers = value.get_ref().as_array().map(|items| {
            items
                .iter()
                .map(|item| number(item.get_ref()))
                .collect::<Option<Vec<f64>>>()
        });
        let numbers = numbers
            .flatten()
            .and_then(|numbers| <[f64; 3]>::try_from(numbers).ok());
        let Some(position) = numbers else {
            return Err(wrong(
                at,
                "tool.rack.position_m",
                "three numbers in metres",
                value,
            ));
        };
        match position.iter().find(|x| x.is_nan() || x.abs() > FARTHEST) {
            None => Ok(position),
            Some(value) => Err(TaskError::OutOfRange {
                at,
                key: "tool.rack.position_m".to_owned(),
                value: value.to_string(),
                limits: format!("-{FARTHEST} to {FARTHEST}"),
            }),
        }
    });
    Ok(RackTool {
        name: name_of(item, "tool.rack", source)?,
        position: position.transpose()?,
    })
}

fn check_keys(table: &DeTable<'_>, source: &Source<'_>) -> Result<(), TaskError> {
    let known = ["name", "position_m"];
    match table
        .keys()
        .find(|key| !known.contains(&key.get_ref().as_ref()))
    {
        None => Ok(()),
        Some(key) => Err(TaskError::UnknownKey {
            at: source.place(key.span().start),
            table: "tool.rack".to_owned(),
            unknown: Box::new(UnknownName::new("key", key.get_ref(), known)),
        }),
    }
}

fn number(value: &DeValue<'_>) -> Option<f64> {
    match value {
        DeValue::Integer(number) => integer(number).map(|number| number as f64),
        DeValue::Float(number) => float(number),
        _ => None,
    }
}

fn get<'r, 'a>(value: &'r Value<'a>, key: &str) -> Option<&'r Value<'a>> {
    value.get_ref().as_table()?.get(key)
}

fn get_mut<'r, 'a>(value: &'r mut Value<'a>, key: &str) -> Option<&'r mut Value<'a>> {
    match value.get_mut() {
        DeValue::Table(table) => table.get_mut(key),
        _ => None,
    }
}

fn fault(at: Place, key: &str, problem: String) -> TaskError {
    TaskError::Inconsistent {
        at,
        key: key.to_owned(),
        problem,
    }
}

fn wrong(at: Place, key: &str, expected: &str, found: &Value<'_>) -> TaskError {
    TaskError::WrongType {
        at,
        key: key.to_owned(),
        expected: expected.to_owned(),
        found: description(found.get_ref()),
    }
}
