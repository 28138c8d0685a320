//! The views' answers, compared with values computed from the catalogue.

use crate::memories::{memory, place, session, some};
use datafusion::arrow::array::{Array, AsArray, RecordBatch};
use datafusion::arrow::compute::cast;
use datafusion::arrow::datatypes::DataType;
use std::collections::BTreeMap;
use wisch_fleet::ask::SqlSession;
use wisch_fleet::moves::{Part, PushOptions, open_local, push};
use wisch_memory::catalogue::entries;
use wisch_memory::{Catalogue, CatalogueNode, EpisodeRecord, IndividualId};

/// Returns the rows as texts; numbers have all digits.
fn texts(batches: &[RecordBatch]) -> Vec<Vec<String>> {
    let mut rows = Vec::new();
    for batch in batches {
        let columns: Vec<_> = (batch.columns().iter())
            .map(|column| cast(column, &DataType::Utf8).unwrap())
            .collect();
        for row in 0..batch.num_rows() {
            let text = |column: &std::sync::Arc<dyn Array>| {
                let column = column.as_string::<i32>();
                if column.is_valid(row) {
                    column.value(row).to_owned()
                } else {
                    "null".to_owned()
                }
            };
            rows.push(columns.iter().map(text).collect());
        }
    }
    rows.sort();
    rows
}

fn numbers(batches: &[RecordBatch], column: &str) -> Vec<f64> {
    let all = batches.iter().flat_map(|batch| {
        let column = cast(batch.column_by_name(column).unwrap(), &DataType::Float64).unwrap();
        let column = column
            .as_primitive::<datafusion::arrow::datatypes::Float64Type>()
            .clone();
        column.iter().map(Option::unwrap).collect::<Vec<f64>>()
    });
    let mut all: Vec<f64> = all.collect();
    all.sort_by(f64::total_cmp);
    all
}

fn number(catalogue: &Catalogue, property: &str, id: IndividualId) -> Option<f64> {
    entries(catalogue.numbers(property), id)
        .first()
        .map(|(_, value)| *value)
}

fn thing(catalogue: &Catalogue, property: &str, id: IndividualId) -> String {
    match entries(catalogue.relations(property), id).first() {
        Some((_, CatalogueNode::Shared(place))) => {
            let name = &catalogue.shared_individuals()[*place as usize];
            name.split_once(':').unwrap().1.to_owned()
        }
        _ => String::new(),
    }
}

fn round_of(catalogue: &Catalogue, id: IndividualId) -> IndividualId {
    match catalogue.class(id) {
        "semco:WipingRound" => id,
        _ => round_of(catalogue, catalogue.parent(id).unwrap()),
    }
}

/// Returns records in which some rounds have the ground truth, and some strokes have no contact.
pub fn records() -> Vec<EpisodeRecord> {
    let mut all = some(300);
    for (number, record) in all.iter_mut().enumerate() {
        for (place, one) in record.individuals.iter_mut().enumerate() {
            let mut set = |property: &str, value: f64| {
                one.values
                    .insert(property.to_owned(), wisch_memory::Value::Number(value));
            };
            match one.class.as_str() {
                "semco:WipingRound" if number % 3 == 0 => {
                    set(
                        "semco:simulatedPerformance",
                        0.3 + 0.01 * (number % 60) as f64,
                    );
                }
                "semco:Stroke" if (number + place) % 11 == 0 => set("semco:contactShare", 0.0),
                _ => {}
            }
        }
    }
    all
}

async fn with_sources(run: impl AsyncFn(&SqlSession, &Catalogue)) {
    let folder = tempfile::tempdir().unwrap();
    let records = records();
    let memory = memory(&folder.path().join("episodes"), &records);
    let catalogue = Catalogue::from_records(&records);
    // A fleet and a local memory give the same answers.
    let fleet = place(&folder.path().join("fleet"));
    push(&memory, &fleet, &PushOptions::default(), &mut |_, _| {})
        .await
        .unwrap();
    run(&session(&fleet).await, &catalogue).await;
    let local = open_local(&memory, Part::Facts).await.unwrap();
    run(&SqlSession::new(&local.sources).await.unwrap(), &catalogue).await;
}

#[tokio::test]
async fn performance_of_80_percent_or_less() {
    with_sources(async |session, catalogue| {
        for (view, class) in [
            ("low_performance", "semco:WipingAction"),
            ("low_performance_rounds", "semco:WipingRound"),
        ] {
            let found = session
                .rows(&format!("SELECT * FROM {view}"))
                .await
                .unwrap();
            let all = catalogue.individuals_of_class(class).iter();
            let all = all.filter_map(|&id| number(catalogue, "semco:performance", id));
            let mut expected: Vec<f64> = all.filter(|value| *value <= 0.8).collect();
            expected.sort_by(f64::total_cmp);
            assert!(expected.len() > 10);
            assert_eq!(numbers(&found, "performance"), expected, "{view}");
        }
    })
    .await;
}

#[tokio::test]
async fn collisions_by_tool_and_hour() {
    with_sources(async |session, catalogue| {
        let found = session
            .rows("SELECT * FROM collisions_by_tool_and_hour")
            .await
            .unwrap();
        let mut expected: BTreeMap<(String, i64), usize> = BTreeMap::new();
        for &id in catalogue.individuals_of_class("semco:HumanCollision") {
            let tool = thing(catalogue, "semco:usesTool", round_of(catalogue, id));
            let [start, _] = catalogue.interval(id).unwrap();
            *expected
                .entry((tool, start as i64 / 3600 % 24))
                .or_default() += 1;
        }
        let mut expected: Vec<Vec<String>> = (expected.into_iter())
            .map(|((tool, hour), count)| vec![tool, hour.to_string(), count.to_string()])
            .collect();
        expected.sort();
        assert!(expected.len() > 10);
        assert_eq!(texts(&found), expected);
    })
    .await;
}

#[tokio::test]
async fn peak_force_of_each_collision() {
    with_sources(async |session, catalogue| {
        let sql =
            "SELECT 'HumanCollision_' || episode || '-' || place FROM peak_force_per_collision";
        let found = session.rows(sql).await.unwrap();
        let all = catalogue
            .individuals_of_class("semco:HumanCollision")
            .iter();
        let mut expected: Vec<String> = all.map(|&id| catalogue.name(id)).collect();
        expected.sort();
        let names: Vec<String> = texts(&found)
            .into_iter()
            .map(|row| row[0].clone())
            .collect();
        assert!(!names.is_empty());
        assert_eq!(names, expected);
        let found = session
            .rows("SELECT * FROM peak_force_per_collision")
            .await
            .unwrap();
        let all = catalogue
            .individuals_of_class("semco:HumanCollision")
            .iter();
        let all = all.map(|&id| number(catalogue, "semco:peakForce", id).unwrap());
        let mut expected: Vec<f64> = all.collect();
        expected.sort_by(f64::total_cmp);
        assert_eq!(numbers(&found, "peak_force_n"), expected);
    })
    .await;
}

#[tokio::test]
async fn strokes_without_contact() {
    with_sources(async |session, catalogue| {
        let sql = "SELECT episode, CAST(place AS VARCHAR) FROM strokes_without_contact";
        let found = session.rows(sql).await.unwrap();
        let all = catalogue.individuals_of_class("semco:Stroke").iter();
        let all = all.filter(|&&id| number(catalogue, "semco:contactShare", id).unwrap() <= 0.01);
        let mut expected: Vec<Vec<String>> = all
            .map(|&id| {
                let episode = catalogue.episode_of(id);
                vec![episode.id.clone(), (id - episode.first).to_string()]
            })
            .collect();
        expected.sort();
        assert!(expected.len() > 10);
        assert_eq!(texts(&found), expected);
    })
    .await;
}

#[tokio::test]
async fn calibration_of_estimates() {
    with_sources(async |session, catalogue| {
        let sql = "SELECT sum(rounds) AS rounds, sum(rounds * held_share) AS held FROM calibration";
        let found = session.rows(sql).await.unwrap();
        let (mut rounds, mut held) = (0.0, 0.0);
        for &id in catalogue.individuals_of_class("semco:WipingRound") {
            let of = |property: &str| number(catalogue, property, id);
            if let Some(truth) = of("semco:simulatedPerformance") {
                rounds += 1.0;
                let low = of("semco:performanceLow").unwrap();
                let high = of("semco:performanceHigh").unwrap();
                held += f64::from(u8::from(low <= truth && truth <= high));
            }
        }
        assert!(held > 5.0 && rounds > held);
        assert_eq!(numbers(&found, "rounds"), [rounds]);
        assert!((numbers(&found, "held")[0] - held).abs() < 1e-6);
    })
    .await;
}

#[tokio::test]
async fn drift_of_contact_force() {
    with_sources(async |session, catalogue| {
        let found = session
            .rows("SELECT * FROM contact_force_drift")
            .await
            .unwrap();
        let mut series: BTreeMap<String, Vec<(f64, f64)>> = BTreeMap::new();
        for &id in catalogue.individuals_of_class("semco:WipingRound") {
            if number(catalogue, "semco:round", id) == Some(1.0) {
                let force = number(catalogue, "semco:meanNormalForce", id)
                    .unwrap()
                    .abs();
                let surface = thing(catalogue, "semco:actsOnSurface", id);
                series
                    .entry(surface)
                    .or_default()
                    .push((catalogue.interval(id).unwrap()[0], force));
            }
        }
        let mut slopes = Vec::new();
        for mut one in series.into_values() {
            one.sort_by(|a, b| a.0.total_cmp(&b.0));
            let n = one.len() as f64;
            let mean_x = (n - 1.0) / 2.0;
            let mean_y = one.iter().map(|(_, y)| y).sum::<f64>() / n;
            let products = one
                .iter()
                .enumerate()
                .map(|(k, (_, y))| (k as f64 - mean_x) * (y - mean_y));
            let squares = (0..one.len()).map(|k| (k as f64 - mean_x).powi(2));
            let slope = products.sum::<f64>() / squares.sum::<f64>();
            let first = mean_y - slope * mean_x;
            if one.len() >= 5 && first + slope * (n - 1.0) < 0.95 * first {
                slopes.push(slope);
            }
        }
        slopes.sort_by(f64::total_cmp);
        let found = numbers(&found, "slope_n");
        assert!(!slopes.is_empty());
        assert_eq!(found.len(), slopes.len());
        for (found, expected) in found.iter().zip(&slopes) {
            // The sums have another order.
            assert!((found - expected).abs() < 1e-9 * expected.abs().max(1.0));
        }
    })
    .await;
}

#[tokio::test]
async fn collisions_that_overlap_strokes() {
    with_sources(async |session, catalogue| {
        let sql = "SELECT episode, CAST(collision AS VARCHAR), CAST(stroke_place AS VARCHAR) FROM collisions_in_strokes";
        let found = session.rows(sql).await.unwrap();
        let mut expected = Vec::new();
        for &collision in catalogue.individuals_of_class("semco:HumanCollision") {
            let episode = catalogue.episode_of(collision);
            let [start, end] = catalogue.interval(collision).unwrap();
            for &stroke in catalogue.individuals_of_class("semco:Stroke") {
                let [begin, stop] = catalogue.interval(stroke).unwrap();
                let is_here = catalogue.episode_of(stroke).id == episode.id;
                if is_here && start < stop && begin < end {
                    let places = [collision, stroke].map(|id| (id - episode.first).to_string());
                    let [collision, stroke] = places;
                    expected.push(vec![episode.id.clone(), collision, stroke]);
                }
            }
        }
        expected.sort();
        assert!(expected.len() > 10);
        assert_eq!(texts(&found), expected);
    })
    .await;
}

#[tokio::test]
async fn an_episode_of_two_sources_counts_once() {
    let folder = tempfile::tempdir().unwrap();
    let all = some(20);
    let one = memory(&folder.path().join("one"), &all[..12]);
    let other = memory(&folder.path().join("other"), &all[8..]);
    let mut sources = Vec::new();
    for memory in [&one, &other] {
        sources.extend(open_local(memory, Part::Facts).await.unwrap().sources);
    }
    let session = SqlSession::new(&sources).await.unwrap();
    assert_eq!(session.shared(), 4);
    let found = session
        .rows("SELECT count(*) AS n, count(DISTINCT episode) AS m FROM episodes")
        .await
        .unwrap();
    assert_eq!(texts(&found), [["20", "20"]]);
    let found = session
        .rows("SELECT count(*) AS n FROM rounds")
        .await
        .unwrap();
    let rounds: usize = all.iter().map(|record| record.rounds.len()).sum();
    assert_eq!(texts(&found), [[rounds.to_string()]]);
}

#[tokio::test]
async fn rows_of_a_memory_are_updated() {
    let folder = tempfile::tempdir().unwrap();
    let all = some(6);
    let here = memory(folder.path(), &all[..4]);
    let count = async || {
        let local = open_local(&here, Part::Telemetry).await.unwrap();
        let session = SqlSession::new(&local.sources).await.unwrap();
        texts(&session.rows("SELECT count(*) FROM episodes").await.unwrap())
    };
    assert_eq!(count().await, [["4"]]);
    memory(folder.path(), &all[4..]);
    assert_eq!(count().await, [["6"]]);
    here.forget(&all[1].id).unwrap();
    assert_eq!(count().await, [["5"]]);
}

#[tokio::test]
async fn a_statement_that_changes_something_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let session = session(&place(folder.path())).await;
    for sql in [
        "DROP TABLE episodes",
        "INSERT INTO episodes VALUES (1)",
        "SET a = 1",
        "SELEC 1",
    ] {
        assert!(session.rows(sql).await.is_err(), "{sql}");
    }
    assert_eq!(
        texts(&session.rows("SELECT count(*) FROM episodes").await.unwrap()),
        [["0"]]
    );
}
