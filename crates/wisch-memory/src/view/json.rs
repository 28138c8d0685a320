//! Answers of a query with the data that it shows, as JSON for the page of `wisch-web`.

use super::titles::titles;
use super::{
    Colour, DirtState, Emphasis, Figure, Plot, PlotData, ShownBody, ShownDirt, ShownEpisode, Track,
    View,
};
use crate::ask::{Answers, Term, units_of};
use crate::catalogue::Catalogue;
use serde_json::{Value, json};
use wisch::geometry::flatten_pose;

/// Number of decimals of lengths [m] and times [s].
const PLACES: i32 = 4;

/// Returns answers as the page of `wisch-web` expects them; times in seconds since 1970, lengths in metres in the world.
///
/// `query`: its text, from which the units of the answers follow. `view`: the data that the query shows, or the reason
/// why the scene cannot show it.
pub fn answers_json(
    query: &str,
    answers: &Answers,
    view: Result<&View, &str>,
    catalogue: &Catalogue,
) -> Value {
    let rows = answers.rows.iter();
    let rows = rows.map(|row| row.iter().map(Term::to_json).collect::<Vec<_>>());
    let mut remarks = answers.remarks.clone();
    match view {
        Ok(view) => remarks.extend(view.remarks.iter().cloned()),
        Err(reason) => remarks.push(format!("the scene cannot show the answers: {reason}")),
    }
    json!({
        "columns": answers.names,
        "units": units_of(query, &answers.names),
        "names": titles(answers, view.ok(), catalogue),
        "rows": rows.collect::<Vec<_>>(),
        "about": about(answers, catalogue),
        "holds": answers.holds(),
        "more": answers.is_cut,
        "printed": answers.printed,
        "remarks": remarks,
        "view": view.ok().map(|view| view_json(view, catalogue)),
    })
}

/// Returns, for each answer, the intervals of episodes that it names, which the page can show.
fn about(answers: &Answers, catalogue: &Catalogue) -> Vec<Vec<Value>> {
    let named = |term: &Term| {
        let id = catalogue.find(term.as_atom()?.strip_prefix("semco:")?)?;
        let class = catalogue.class(id);
        let episode = catalogue.episode_of(id);
        Some(json!({
            "episode": episode.id,
            "task": episode.task,
            "begun": episode.interval[0],
            "class": class.strip_prefix("semco:").unwrap_or(class),
            "interval": catalogue.interval(id),
        }))
    };
    let rows = answers.rows.iter();
    rows.map(|row| row.iter().filter_map(named).collect())
        .collect()
}

fn view_json(view: &View, catalogue: &Catalogue) -> Value {
    let round = |place: usize| {
        let round = &view.rounds[place];
        (view.episodes[round.episode].id.as_str(), round.number)
    };
    json!({
        "episodes": view.episodes.iter().map(|one| episode(one, catalogue)).collect::<Vec<_>>(),
        "tracks": view.tracks.iter().map(|one| track(one, round(one.round))).collect::<Vec<_>>(),
        "bodies": view.bodies.iter().map(|one| body(one, round(one.round))).collect::<Vec<_>>(),
        "particles": view.particles.iter().map(|one| dirt(one, round(one.round))).collect::<Vec<_>>(),
        "plots": view.plots.iter().map(plot).collect::<Vec<_>>(),
        "left_out": view.left_out,
    })
}

fn episode(shown: &ShownEpisode, catalogue: &Catalogue) -> Value {
    let occurrences = shown.occurrences.iter().map(|occurrence| {
        json!({
            "name": occurrence.name,
            "class": occurrence.class,
            "collision": occurrence.is_collision,
            "interval": occurrence.interval,
        })
    });
    json!({
        "id": shown.id,
        "task": shown.task,
        "interval": shown.interval,
        "rounds": catalogue.episode(&shown.id).map(|row| row.rounds.clone()),
        "occurrences": occurrences.collect::<Vec<_>>(),
        "shown": shown.shown,
    })
}

fn track(track: &Track, (episode, round): (&str, usize)) -> Value {
    let path = track.path.iter().map(|at| [at.x, at.y, at.z].map(short));
    let samples = track.samples.iter();
    let samples = samples.map(|(time, at)| json!([time, short(at.x), short(at.y), short(at.z)]));
    json!({
        "thing": track.thing,
        "episode": episode,
        "round": round,
        "interval": track.interval,
        "path": path.collect::<Vec<_>>(),
        "samples": samples.collect::<Vec<_>>(),
        "strong": track.emphasis == Emphasis::Strong,
        "colour": track.colour.map(hex),
    })
}

fn body(body: &ShownBody, (episode, round): (&str, usize)) -> Value {
    let kind = match body.figure {
        Figure::Robot => "robot",
        Figure::Tool => "tool",
        Figure::Surface => "surface",
        Figure::Frame => "frame",
    };
    json!({
        "thing": body.thing,
        "kind": kind,
        "episode": episode,
        "round": round,
        "time": body.time,
        "pose": flatten_pose(&body.world_from_frame),
        "strong": body.emphasis == Emphasis::Strong,
        "colour": body.colour.map(hex),
    })
}

fn dirt(dirt: &ShownDirt, (episode, round): (&str, usize)) -> Value {
    let positions = dirt.positions.iter().map(|at| [at.x, at.y].map(short));
    json!({
        "episode": episode,
        "round": round,
        "state": match dirt.state {
            DirtState::Before => "before",
            DirtState::Estimated => "estimated",
        },
        "positions": positions.collect::<Vec<_>>(),
        "colour": dirt.colour.map(hex),
    })
}

fn plot(plot: &Plot) -> Value {
    let (kind, data) = match &plot.data {
        PlotData::Amounts(amounts) => ("amounts", json!(amounts)),
        PlotData::Spans(spans) => ("spans", json!(spans)),
        PlotData::Points(points) => ("points", json!(points)),
    };
    json!({
        "diagram": plot.diagram.as_str(),
        "id": plot.id,
        "title": plot.title,
        "x_label": plot.x_label,
        "y_label": plot.y_label,
        kind: data,
    })
}

fn hex(Colour([red, green, blue]): Colour) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

fn short(value: f64) -> f64 {
    let scale = 10_f64.powi(PLACES);
    (value * scale).round() / scale
}
