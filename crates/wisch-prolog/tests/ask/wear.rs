//! What changes over episodes: a surface that creeps away or is moved at once, and a tool that grows softer.

use super::{asker_of, engines, shown};
use std::collections::BTreeMap;
use wisch_memory::{Catalogue, EPISODE_SCHEMA, EpisodeRecord, Individual, Origin, Value};

/// Newtons with which every episode presses.
const FORCE: f64 = 10.0;

/// Start of the first episode [s since 1970].
const BEGIN: f64 = 1.0e6;

/// An episode a day, with the offset of the plane [m] and the stiffness of the tool [N/m] if it is known.
fn episodes(values: impl IntoIterator<Item = (f64, Option<f64>)>) -> Catalogue {
    Catalogue::from_records(&records_from(BEGIN, values))
}

/// The records of such episodes, the first of which begins at a time [s since 1970].
fn records_from(
    first: f64,
    values: impl IntoIterator<Item = (f64, Option<f64>)>,
) -> Vec<EpisodeRecord> {
    let records = values
        .into_iter()
        .enumerate()
        .map(|(day, (offset, stiffness))| {
            let begin = first + 86_400.0 * day as f64;
            let interval = [begin, begin + 30.0];
            let individual = |class: &str, parent| Individual {
                class: format!("semco:{class}"),
                interval: Some(interval),
                parent,
                relations: BTreeMap::new(),
                values: BTreeMap::new(),
            };
            let mut round = individual("WipingRound", Some(1));
            let numbers = [
                ("semco:round", Some(1.0)),
                ("semco:planeOffset", Some(offset)),
                ("semco:meanNormalForce", Some(-FORCE)),
                ("semco:toolStiffness", stiffness),
            ];
            for (property, number) in numbers {
                if let Some(number) = number {
                    round
                        .values
                        .insert(property.to_owned(), Value::Number(number));
                }
            }
            for (property, thing) in [
                ("semco:usesTool", "semco:sponge"),
                ("semco:actsOnSurface", "semco:table"),
            ] {
                round
                    .relations
                    .insert(property.to_owned(), vec![thing.to_owned()]);
            }
            EpisodeRecord {
                schema: EPISODE_SCHEMA,
                id: format!("day{day:02}"),
                task: "board".to_owned(),
                interval,
                origin: Origin::Simulated,
                program: "by hand".to_owned(),
                seed: 1,
                rounds: vec![begin],
                individuals: vec![
                    individual("WipingEpisode", None),
                    individual("WipingAction", Some(0)),
                    round,
                ],
            }
        });
    records.collect()
}

fn check(catalogue: &Catalogue, queries: &[(&str, &[&str])]) {
    for engine in engines() {
        let mut asker = asker_of(engine, catalogue.clone());
        for (query, expected) in queries {
            let found = asker
                .ask(query)
                .unwrap_or_else(|error| panic!("{query}: {error}"));
            assert_eq!(shown(&found), *expected, "{query}");
        }
    }
}

const ROUNDED: &str = "A is round(1000 * _F), B is round(1000 * _L)";

#[test]
fn a_table_that_was_lowered_once_is_a_change_and_no_drift() {
    let moved = |day| if day < 8 { 0.0 } else { -0.006 };
    let catalogue = episodes((0..16).map(|day| (moved(day), Some(2000.0))));
    check(
        &catalogue,
        &[
            ("localization_drift(S, _, _, _)", &[]),
            (
                &format!("localization_change(S, T, _F, _L), {ROUNDED}"),
                &["semco:table 1691200.0 0 -6"],
            ),
            ("localization_change(_, _, _, _) until 1600000", &[]),
            ("drift_cause(S, _, C)", &["semco:table lowered_surface"]),
            ("drift_cause(S, _, C) until 1600000", &[]),
            ("tool_wear(_, _, _, _)", &[]),
        ],
    );
}

#[test]
fn a_table_that_creeps_is_a_drift_in_the_queried_time() {
    let catalogue = episodes((0..16).map(|day| (-5e-4 * f64::from(day.max(8) - 8), Some(2000.0))));
    check(
        &catalogue,
        &[
            (
                &format!("localization_drift(S, _, _F, _L) since 1691200, {ROUNDED}"),
                &["semco:table 0 -4"],
            ),
            ("localization_drift(S, _, _, _) until 1691200", &[]),
            ("drift_cause(S, _, C)", &["semco:table lowered_surface"]),
        ],
    );
}

#[test]
fn a_tool_that_grows_softer_is_worn_and_the_table_stands_where_it_stood() {
    // Half as stiff in the end: it sinks in by F / k more.
    let stiffness = |day: i32| 2000.0 * 0.5_f64.powf(f64::from(day) / 15.0);
    let sunk = |k: f64| -FORCE * (1.0 / k - 1.0 / 2000.0);
    let catalogue = episodes((0..16).map(|day| (sunk(stiffness(day)), Some(stiffness(day)))));
    check(
        &catalogue,
        &[
            (
                "tool_wear(T, _S, _F, _L), A is round(_F), B is round(_L), C is round(1000 * _S)",
                &["semco:sponge 2000 1000 -46"],
            ),
            ("drift_cause(S, _, C)", &["semco:table worn_tool"]),
        ],
    );
    for engine in engines() {
        let mut asker = asker_of(engine, catalogue.clone());
        let answers = asker.ask("wear_chart(sponge)").unwrap();
        let view = answers.views[0].to_string();
        assert!(
            view.contains("linechart(wear)") && view.contains("stiffness"),
            "{view}"
        );
        assert!(asker.ask("wear_chart(table)").is_err());
    }
}

#[test]
fn the_change_of_a_surface_is_that_from_the_first_episode_to_the_last() {
    let change = "drift_cause(S, _C, _), A is round(10_000 * _C)";
    // 0.6 mm a day over 14 days; 12 mm in the last three of 12 runs; a single outlier at the end of a drift.
    let jump = |day| if day < 9 { 0.0 } else { 0.012 };
    let outlier = |day| {
        if day == 13 {
            0.004
        } else {
            -6e-4 * f64::from(day)
        }
    };
    for (offsets, expected) in [
        ((0..14).map(|day| -6e-4 * f64::from(day)).collect(), -78),
        ((0..12).map(jump).collect::<Vec<f64>>(), 120),
        ((0..14).map(outlier).collect(), -72),
    ] {
        let catalogue = episodes(offsets.into_iter().map(|offset| (offset, Some(2000.0))));
        check(
            &catalogue,
            &[(change, &[&format!("semco:table {expected}")])],
        );
    }
}

#[test]
fn without_the_stiffness_nobody_knows_which_it_was() {
    let catalogue = episodes((0..10).map(|day| (-1e-3 * f64::from(day), None)));
    check(
        &catalogue,
        &[("drift_cause(S, _, C)", &["semco:table unknown"])],
    );
}

#[test]
fn times_are_shown_in_local_time() {
    for engine in engines() {
        let mut asker = asker_of(engine, episodes([]));
        let answers = asker.ask("local_time(1795309772.5, T)").unwrap();
        let text = answers.rows[0][0].as_atom().unwrap_or_default().to_owned();
        // Offsets are whole minutes.
        assert!(
            text.starts_with("2026-11-2") && text.contains(":32 "),
            "{text}"
        );
        let answers = asker.ask("local_time(12.34, T)").unwrap();
        let text = answers.rows[0][0].as_atom().unwrap_or_default();
        assert_eq!(text, "12.3 s from the start of the log, undated");
    }
}

#[test]
fn drifts_of_the_health_report_are_asked_for_with_their_forecast() {
    // 0.5 mm a day, without scatter; the report has no clock before 1990.
    let values = |day: i32| (-5e-4 * f64::from(day), Some(2000.0));
    let rounded = "_R = runs(_, T, S), A is round(10_000 * _D), B is sign(_P), _P < 0.01";
    let query = format!("drift(_R, C, _D, _P, _), {rounded}");
    check(
        &Catalogue::from_records(&records_from(1.7e9, (0..16).map(values))),
        &[(&query, &["surface_offset semco:sponge semco:table -5 1.0"])],
    );
    let resting = records_from(1.7e9, (0..16).map(|_| (0.0, Some(2000.0))));
    check(
        &Catalogue::from_records(&resting),
        &[("drift(_, C, _, _, _)", &[])],
    );
}

#[test]
fn warnings_of_the_memory_are_asked_for_with_channel_time_and_p_value() {
    let mut records = records_from(1.7e9, (0..2).map(|_| (0.0, None)));
    let values = [
        ("semco:warningChannel", Value::Text("height".to_owned())),
        ("semco:pValue", Value::Number(0.01)),
    ];
    let at = 1.7e9 + 86_410.0;
    records[1].individuals.push(Individual {
        class: "semco:MemoryWarning".to_owned(),
        interval: Some([at, at]),
        parent: Some(2),
        relations: BTreeMap::new(),
        values: values.map(|(name, value)| (name.to_owned(), value)).into(),
    });
    check(
        &Catalogue::from_records(&records),
        &[
            (
                "warning(E, C, T, P)",
                &["semco:'WipingEpisode_day01-0' height 1700086410.0 0.01"],
            ),
            ("warning(E, _, _, _) until 1700080000", &[]),
        ],
    );
}
