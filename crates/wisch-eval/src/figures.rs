//! The figures that each evaluation publishes, with the targets of the paper and of the project.

use crate::evidence::PublishedFigure as Figure;
use crate::goal_run::GoalScores;
use crate::interval::binomial_interval;
use crate::quantity::{Quantity, QuantitySummary};
use crate::scenario::{Quartiles, ScenarioScores};
use crate::scores::{Calibration, ClaimCounts, LevelCoverage, MethodScores};
use crate::sweep::SweepCell;
use crate::table1::Table1Row;
use crate::world::{Disturbance, Senses};
use std::collections::BTreeSet;

/// Name of the interval of a share.
const BINOMIAL: &str = "95 % binomial";
/// Name of the interval of a median.
const QUARTILES: &str = "quartiles";
/// Name of the interval of a mean over seeds.
const EXTREMES: &str = "minimum to maximum";
/// Who set the targets that are not the paper's.
const PROJECT: &str = "the project";

/// Range of the share of rounds that 90 % intervals with sight contain \[%\].
const SIGHT_90: [Option<f64>; 2] = [Some(87.0), Some(93.0)];
/// Range of this share in each class of at least [`CLASS_ROUNDS`] rounds \[%\].
const SIGHT_CLASS_90: [Option<f64>; 2] = [Some(80.0), None];
/// Rounds of a class for which the target with sight holds.
const CLASS_ROUNDS: usize = 50;
/// Range of the share of rounds that 90 % intervals by touch contain, in each class \[%\].
const TOUCH_90: [Option<f64>; 2] = [Some(85.0), None];
/// CRPS by touch as a multiple of that of the force-blind replay, at most: in undisturbed and in disturbed worlds.
const TOUCH_CRPS: [f64; 2] = [1.0, 0.75];
/// Range of the share of worlds with a false claim \[%\].
const FALSE_CLAIMS: [Option<f64>; 2] = [None, Some(0.1)];
/// Shares of the misplaced dirt that suitable tools of Fig. 13 bring to the goal \[%\].
const FIG_13: [(&str, f64); 2] = [("solar-panel-wiper", 85.0), ("broom-chippings", 80.0)];

/// Share of the runs of a goal in which all its parts are reached \[%\].
const GOAL_REACHED: [Option<f64>; 2] = [Some(90.0), None];
/// Share of the runs of a goal with a false claim \[%\].
const GOAL_FALSE_CLAIMS: [Option<f64>; 2] = [None, Some(0.0)];
/// Time of all steps of a goal as a multiple of the best order.
const GOAL_TIME: [Option<f64>; 2] = [None, Some(1.1)];
/// Time to compute the order of the steps \[s\].
const GOAL_ORDERING: [Option<f64>; 2] = [None, Some(1.0)];

/// Quantities of Table 1 and of sweeps, with the names of their tables, unit, and decimals.
const QUANTITIES: [(Quantity, &str, &str, usize); 13] = [
    (Quantity::Predicted, "predicted performance", "%", 2),
    (Quantity::PredictedLoss, "predicted loss", "%", 2),
    (
        Quantity::Limited,
        "performance within the paper's shortest path",
        "%",
        2,
    ),
    (Quantity::Estimated, "estimated performance", "%", 2),
    (Quantity::Truth, "true performance", "%", 2),
    (Quantity::TrueLoss, "true loss", "%", 2),
    (Quantity::OutOfReach, "out of reach", "%", 2),
    (Quantity::DistanceM, "distance", "m", 2),
    (Quantity::Lifts, "lifts", "", 1),
    (Quantity::Abandoned, "abandoned nodes", "", 1),
    (Quantity::Rounds, "rounds", "", 1),
    (Quantity::ExecutionS, "execution", "s", 1),
    (Quantity::ComputationS, "computation on one core", "s", 2),
];

fn build_share_figure(place: [&str; 3], hits: usize, trials: usize, noun: &'static str) -> Figure {
    let share = 100.0 * hits as f64 / trials as f64;
    let bounds = binomial_interval(hits, trials).map(|bound| 100.0 * bound);
    Figure::from_value(place, share, "%", 1)
        .with_interval(BINOMIAL, bounds)
        .with_count(trials, noun)
}

fn build_points_figure(place: [&str; 3], value: f64, rounds: usize) -> Figure {
    let value = if rounds == 0 { f64::NAN } else { 100.0 * value };
    Figure::from_value(place, value, "points", 1).with_count(rounds, "rounds")
}

fn build_median_figure(place: [&str; 3], of: Option<Quartiles>, runs: usize) -> Figure {
    let Quartiles([_, first, median, third, _]) = of.unwrap_or(Quartiles([f64::NAN; 5]));
    Figure::from_value(place, 100.0 * median, "%", 1)
        .with_interval(QUARTILES, [100.0 * first, 100.0 * third])
        .with_count(runs, "runs")
}

fn build_coverage_figure(place: [&str; 3], level: &LevelCoverage, rounds: usize) -> Figure {
    let value = if rounds == 0 {
        f64::NAN
    } else {
        100.0 * level.share
    };
    Figure::from_value(place, value, "%", 1)
        .with_interval(BINOMIAL, level.bounds.map(|bound| 100.0 * bound))
        .with_count(rounds, "rounds")
}

/// Lists the figures of a calibration: by estimator, by kind of world, and of goals and pushes.
pub fn calibration_figures(of: &Calibration, senses: Senses) -> Vec<Figure> {
    let mut figures = Vec::new();
    for (number, method) in of.methods.iter().enumerate() {
        let target = (number == 0).then_some(match senses {
            Senses::Touch => TOUCH_90,
            Senses::TouchAndSight => SIGHT_90,
        });
        let table = ["estimators", &method.name];
        figures.extend(list_method_figures(table, method, of.rounds, target));
    }
    for group in &of.groups {
        let target = match senses {
            Senses::Touch => Some(TOUCH_90),
            Senses::TouchAndSight => (group.rounds >= CLASS_ROUNDS).then_some(SIGHT_CLASS_90),
        };
        let place = |column| ["kinds of world", &*group.name, column];
        figures.push(Figure::from_count(place("worlds"), group.worlds));
        figures.push(Figure::from_count(place("rounds"), group.rounds));
        let row = ["kinds of world", &*group.name];
        let scores = list_method_figures(row, &group.method, group.rounds, target).into_iter();
        let shown = ["CRPS", "error", "90 % interval", "width of 90 %"];
        let scores = scores.filter(|one| shown.contains(&&*one.column));
        let is_compared = group.kind == "disturbance" && senses == Senses::Touch;
        let is_disturbed = group.name != Disturbance::None.as_str();
        let blind = group.force_blind_crps;
        let most = TOUCH_CRPS[usize::from(is_disturbed)] * 100.0 * blind;
        figures.extend(scores.map(|figure| match &*figure.column {
            "CRPS" if is_compared => figure.with_target([None, Some(most)], PROJECT),
            _ => figure,
        }));
        figures.push(build_points_figure(
            place("CRPS, force-blind"),
            blind,
            group.rounds,
        ));
        figures.push(build_points_figure(
            place("paper's error"),
            group.paper_error,
            group.rounds,
        ));
        let ended = (group.ended_at_90 * group.worlds as f64).round() as usize;
        figures.push(build_share_figure(
            place("end ≥ 90 %"),
            ended,
            group.worlds,
            "worlds",
        ));
        figures.extend(list_claim_figures(place, &group.claims, group.worlds));
    }
    let place = |row| ["goals and pushes", row, "result"];
    let claims = &of.claims;
    let claimed = list_claim_figures(place, claims, of.worlds);
    figures.extend(claimed.into_iter().map(|figure| match &*figure.row {
        "false claims" => figure.with_target(FALSE_CLAIMS, PROJECT),
        _ => figure,
    }));
    let worlds = |row, count| build_share_figure(place(row), count, of.worlds, "worlds");
    figures.push(worlds("undecided by touch", claims.undecided_by_touch));
    let pushes = &of.pushes;
    for (row, count) in [
        ("pushes detected", pushes.found),
        ("starts of pushes within 50 ms", pushes.starts),
        ("ends of pushes within 50 ms", pushes.ends),
    ] {
        figures.push(build_share_figure(
            place(row),
            count,
            pushes.pushes,
            "pushes",
        ));
    }
    for (row, count) in [
        ("detections at collisions with objects", pushes.obstructed),
        ("false detections", pushes.false_detections),
    ] {
        let figure = Figure::from_count(place(row), count);
        figures.push(figure.with_count(pushes.undisturbed, "rounds without a push"));
    }
    figures
}

fn list_method_figures(
    [table, row]: [&str; 2],
    of: &MethodScores,
    rounds: usize,
    target_90: Option<[Option<f64>; 2]>,
) -> Vec<Figure> {
    let place = |column| [table, row, column];
    let mut figures = vec![
        build_points_figure(place("CRPS"), of.crps, rounds),
        build_points_figure(place("error"), of.error, rounds),
        build_points_figure(place("bias"), of.bias, rounds),
    ];
    for level in &of.coverage {
        let name = format!("{} % interval", 100.0 * level.level);
        let figure = build_coverage_figure([table, row, &name], level, rounds);
        figures.push(match target_90.filter(|_| level.level == 0.9) {
            Some(target) => figure.with_target(target, PROJECT),
            None => figure,
        });
        if level.level == 0.9 {
            figures.push(build_points_figure(
                place("width of 90 %"),
                level.width,
                rounds,
            ));
        }
    }
    figures
}

fn list_claim_figures<'a>(
    place: impl Fn(&'a str) -> [&'a str; 3],
    of: &ClaimCounts,
    worlds: usize,
) -> Vec<Figure> {
    let share = |name, count| build_share_figure(place(name), count, worlds, "worlds");
    vec![
        share("claimed", of.claimed),
        share("met", of.met),
        share("false claims", of.false_claims),
    ]
}

/// Lists the figures of Table 1: a table for each quantity, with the paper's figures. `reached`: number of cells in which
/// the paper's performance is reached, and number of the paper's cells.
pub fn table1_figures(rows: &[Table1Row], reached: [usize; 2]) -> Vec<Figure> {
    let [hits, cells] = reached;
    let place = [
        "cells",
        "cells that reach the paper's performance",
        "result",
    ];
    let mut figures = Vec::new();
    if cells > 0 {
        figures.push(Figure::from_count(place, hits).with_count(cells, "cells"));
    }
    let others = rows.iter().filter(|row| !row.is_papers_own);
    let others: BTreeSet<&str> = others.map(|row| &*row.strategy).collect();
    for strategy in others {
        let of: Vec<_> = rows.iter().filter(|row| row.strategy == strategy).collect();
        let name = format!("cells in which `{strategy}` reaches the paper's best performance");
        let hits = of.iter().filter(|row| row.is_reached).count();
        let figure = Figure::from_count(["cells", &name, "result"], hits);
        figures.push(figure.with_count(of.len(), "cells"));
    }
    for (quantity, table, unit, decimals) in QUANTITIES {
        for row in rows {
            let Some(statistics) = row.ours.get(&quantity) else {
                continue;
            };
            let factor = if unit == "%" { 100.0 } else { 1.0 };
            // Means that differ only by rounding errors are the same figure.
            let value = |value: f64| (1e9 * factor * value).round() / 1e9;
            let [least, .., most] = statistics.quartiles.0.map(value);
            let cell = format!("{} {}", row.action, row.surface);
            let place = [table, &cell, &row.strategy];
            let figure = Figure::from_value(place, value(statistics.mean), unit, decimals)
                .with_interval(EXTREMES, [least, most])
                .with_count(row.runs, "seeds");
            let paper = row.paper;
            let target = match quantity {
                Quantity::Predicted => Some([Some(paper.performance_percent), None]),
                _ => None,
            };
            figures.push(match target {
                Some(target) => figure.with_target(target, "the paper"),
                None => figure,
            });
            let paper = match quantity {
                Quantity::DistanceM => paper.distance_m,
                Quantity::ExecutionS => paper.execution_s,
                _ => continue,
            };
            let column = match row.is_papers_own {
                true => format!("{}: the paper", row.strategy),
                false => "least of the paper's three".to_owned(),
            };
            figures.push(Figure::from_value(
                [table, &cell, &column],
                paper,
                unit,
                decimals,
            ));
        }
    }
    figures
}

/// Lists the figures of a goal over seeds: of all its parts together, of each part, and of the times.
pub fn goal_figures(of: &GoalScores) -> Vec<Figure> {
    let share = |place, count| build_share_figure(place, count, of.runs, "runs");
    let of_all = |column| ["parts of the goal", "all parts", column];
    let mut figures = vec![
        share(of_all("reached"), of.reached).with_target(GOAL_REACHED, PROJECT),
        share(of_all("claimed"), of.claimed),
        share(of_all("false claims"), of.false_claims).with_target(GOAL_FALSE_CLAIMS, PROJECT),
    ];
    for part in &of.parts {
        let place = |column| ["parts of the goal", &*part.part, column];
        figures.push(share(place("reached"), part.reached));
        figures.push(share(place("claimed"), part.claimed));
        figures.push(share(place("false claims"), part.false_claims));
        figures.push(build_median_figure(
            place("true performance"),
            part.truth,
            of.runs,
        ));
    }
    let time = |row, of_runs: Option<Quartiles>, unit, decimals| {
        let Quartiles([_, first, median, third, _]) = of_runs.unwrap_or(Quartiles([f64::NAN; 5]));
        Figure::from_value(["times", row, "median"], median, unit, decimals)
            .with_interval(QUARTILES, [first, third])
            .with_count(of.runs, "runs")
    };
    figures.push(time("all steps", of.took_s, "s", 1));
    figures.push(time("of the expected time", of.of_expected, "", 2));
    figures
        .push(time("of the best order", of.of_best_order, "", 2).with_target(GOAL_TIME, PROJECT));
    let ordering = time("computing the order", of.ordering_s, "s", 4);
    figures.push(ordering.with_target(GOAL_ORDERING, PROJECT));
    figures
}

/// Lists the figures of scenarios over seeds, one row for each scenario.
pub fn scenario_figures(all: &[ScenarioScores]) -> Vec<Figure> {
    let mut figures = Vec::new();
    for scores in all {
        let place = |column| ["scenarios", &*scores.scenario, column];
        let runs = scores.runs;
        let moved = build_median_figure(
            place("of the misplaced dirt, round 1"),
            scores.recovered,
            runs,
        );
        let target = FIG_13.iter().find(|(name, _)| *name == scores.scenario);
        figures.extend([
            Figure::from_count(place("runs"), runs),
            build_median_figure(place("true performance after round 1"), scores.first, runs),
            match target {
                Some((_, least)) => moved.with_target([Some(*least), None], PROJECT),
                None => moved,
            },
            build_median_figure(place("true performance at the end"), scores.last, runs),
            Figure::from_count(place("goals met"), scores.met),
            Figure::from_count(place("goals claimed"), scores.claimed),
            Figure::from_count(place("false claims"), scores.false_claims)
                .with_target([None, Some(0.0)], PROJECT),
            build_share_figure(
                place("90 % interval"),
                scores.covered,
                scores.rounds,
                "rounds",
            ),
            build_points_figure(
                place("error"),
                scores.error.unwrap_or(f64::NAN),
                scores.rounds,
            ),
            Figure::from_count(place("pushes detected"), scores.collisions),
        ]);
    }
    figures
}

/// Lists the figures of a sweep, one row for each combination. `keys`: keys of the task, in the order of their values.
pub fn sweep_figures(cells: &[SweepCell], keys: &[String]) -> Vec<Figure> {
    let mut figures = Vec::new();
    for cell in cells {
        let pairs = keys.iter().zip(&cell.values);
        let row: Vec<String> = pairs.map(|(key, value)| format!("{key}={value}")).collect();
        figures.extend(list_summary_figures(
            &row.join(", "),
            &cell.summary,
            cell.runs,
        ));
    }
    figures
}

fn list_summary_figures(row: &str, of: &QuantitySummary, runs: usize) -> Vec<Figure> {
    let figure = |(quantity, column, unit, decimals): (Quantity, &str, &'static str, usize)| {
        let factor = if unit == "%" { 100.0 } else { 1.0 };
        let statistics = of.get(&quantity)?;
        let [_, first, median, third, _] = statistics.quartiles.0.map(|value| factor * value);
        let figure = Figure::from_value(["combinations", row, column], median, unit, decimals);
        let figure = figure.with_interval(QUARTILES, [first, third]);
        Some(figure.with_count(runs, "runs"))
    };
    QUANTITIES.into_iter().filter_map(figure).collect()
}
