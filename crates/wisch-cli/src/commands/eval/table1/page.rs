//! The page table1.html: the table, with pictures of one seed.

use super::super::super::words::format_count;
use super::super::wipings::{find_heading, format_figure, format_mean};
use super::record::{Table1Record, format_paper_figure, list_columns, write_lead};
use crate::failure::Failure;
use std::path::Path;
use wisch::geometry::Point2;
use wisch::represent::{Action, Task};
use wisch_eval::{Picture, Quantity, Table1Row, Table1Run, TaskCase, WipingExtent, WipingScore};
use wisch_io::{LoadOptions, load_task};
use wisch_report::{
    ActionRows, ComparedFigure, StrategyColumn, SurfaceColumns, Table1Input, WipedSurface,
    table1_page,
};

/// Writes the page of an evaluation as HTML. Its runs must still have their pictures.
pub(super) fn page(record: &Table1Record) -> Result<String, Failure> {
    let pictured: Vec<&Table1Run> = (record.runs.iter())
        .filter(|run| run.score.picture.is_some())
        .collect();
    let mut tasks: Vec<(TaskCase, Task)> = Vec::new();
    for run in &pictured {
        let case = run.case.task;
        if tasks.iter().all(|(known, _)| *known != case) {
            let options = LoadOptions {
                action: Some(case.action()),
                settings: record.setup.settings.clone(),
                ..LoadOptions::default()
            };
            tasks.push((case, load_task(Path::new(case.scenario()), &options)?.task));
        }
    }
    let column = |task: TaskCase, row: &Table1Row| {
        let is_of = |run: &&&Table1Run| run.case.task == task && run.case.strategy == row.strategy;
        let run = pictured.iter().find(is_of);
        let surface = tasks.iter().find(|(case, _)| *case == task);
        let picture = run.zip(surface).and_then(|(run, (_, task))| {
            let picture = run.score.picture.as_ref()?;
            Some((wiped_surface(task, picture), format_caption(&run.score)))
        });
        StrategyColumn {
            strategy: row.strategy.clone(),
            figures: list_columns(&record.setup)
                .into_iter()
                .map(|(quantity, paper)| ComparedFigure {
                    ours: format_mean(&row.ours, quantity),
                    paper: paper.map(|of| format_paper_figure(row, of(&row.paper))),
                    is_strong: quantity == Quantity::Predicted && row.is_reached,
                })
                .collect(),
            picture,
        }
    };
    let surface = |task: TaskCase| {
        let is_of =
            |row: &&Table1Row| row.action == task.action().as_str() && row.surface == task.place();
        let rows = record.rows.iter().filter(is_of);
        SurfaceColumns {
            surface: task.place().to_owned(),
            columns: rows.map(|row| column(task, row)).collect(),
        }
    };
    let of_action = |action: Action| {
        let cells = TaskCase::cases_by_action().filter(|task| task.action() == action);
        ActionRows {
            action: action.to_string(),
            surfaces: cells
                .map(surface)
                .filter(|surface| !surface.columns.is_empty())
                .collect(),
        }
    };
    let actions = Action::ALL.into_iter().map(of_action);
    let [reached, own] = record.reached;
    let headline = (own > 0).then(|| {
        let sentence = "of the paper's cells: mean predicted performance reaches the paper's.";
        (format!("{reached} of {own}"), sentence.to_owned())
    });
    Ok(table1_page(&Table1Input {
        lead: write_lead(record),
        headline,
        quantities: list_columns(&record.setup)
            .into_iter()
            .map(|(quantity, _)| find_heading(quantity).0.to_owned())
            .collect(),
        actions: actions.filter(|rows| !rows.surfaces.is_empty()).collect(),
        pictured: format!(
            "Seed {}, seen from above: {}.",
            record.setup.pictured_seed,
            match record.setup.extent {
                WipingExtent::Executed => "the true dirt before the first and after the last round",
                WipingExtent::Followed => "the predicted effect of the robot's strokes",
                WipingExtent::Planned => "the predicted effect of the plans",
            }
        ),
        notes: [
            "Means over the seeds. Green: the paper's performance is reached. In brackets: the best of the paper's three strategies, for strategies that the paper does not have.",
            "Computation is wall time on one core and the only figure that depends on the machine; the paper's figure is that of another planner on another machine.",
        ]
        .map(str::to_owned)
        .to_vec(),
    }))
}

fn wiped_surface<'a>(task: &'a Task, picture: &Picture) -> WipedSurface<'a> {
    let points = |places: &[[f64; 2]]| places.iter().map(|&place| Point2::from(place)).collect();
    WipedSurface {
        task,
        goal: picture.goal.into(),
        collision_radius: picture.collision_radius_m,
        strokes: picture
            .strokes
            .iter()
            .map(|stroke| points(stroke))
            .collect(),
        before: points(&picture.before),
        left: points(&picture.left),
        done: points(&picture.done),
        lost: points(&picture.lost),
    }
}

/// The caption of a run's picture: its performance, and its costs.
fn format_caption(score: &WipingScore) -> [String; 2] {
    let outcome = match &score.execution {
        Some(execution) => format_figure(Quantity::Truth, execution.truth) + " % true",
        None => format_figure(Quantity::Predicted, score.predicted) + " %",
    };
    let time = score.execution_s();
    let time = time.map_or_else(String::new, |time| {
        format!(" · {} s", format_figure(Quantity::ExecutionS, time))
    });
    let distance = format_figure(Quantity::DistanceM, score.distance_m);
    let lifts = format_count(score.lifts, "lift");
    [outcome, format!("{distance} m · {lifts}{time}")]
}
