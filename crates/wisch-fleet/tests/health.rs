//! Warnings and drifts of the memory in SQL, compared with the health report over the same records.

use crate::memories::{memory, place, session, some};
use datafusion::arrow::util::pretty::pretty_format_batches;
use std::fs;
use std::path::Path;
use wisch_fleet::ask::{SqlSession, SqlSource};
use wisch_fleet::moves::{Part, PushOptions, open_local, push};
use wisch_fleet::store::StorePlace;
use wisch_memory::health::{ChannelState, GroupHealth, assess_groups, gather_groups};
use wisch_memory::{Catalogue, EpisodeRecord, Individual, Value};

/// Returns records with a press force and a tool that becomes softer; the last has two warnings, one by an earlier
/// version without values.
fn records() -> Vec<EpisodeRecord> {
    let mut all = some(60);
    for (number, record) in all.iter_mut().enumerate() {
        for one in &mut record.individuals {
            if one.class == "semco:WipingRound" {
                let stiffness = 2000.0 * 0.98_f64.powi(number as i32);
                for (property, value) in [
                    ("semco:pressForce", 10.0),
                    ("semco:toolStiffness", stiffness),
                ] {
                    one.values.insert(property.to_owned(), Value::Number(value));
                }
            }
        }
    }
    let last = all.last_mut().unwrap();
    let is_round = |one: &Individual| one.class == "semco:WipingRound";
    let round = last.individuals.iter().position(is_round).unwrap();
    let at = last.individuals[round].interval.unwrap()[0] + 1.0;
    let known = [
        ("semco:warningChannel", Value::Text("height".to_owned())),
        ("semco:warningValue", Value::Number(0.0015)),
        ("semco:bandLow", Value::Number(-0.004)),
        ("semco:bandHigh", Value::Number(-0.002)),
        ("semco:pValue", Value::Number(0.01)),
        ("semco:alikeEpisodes", Value::Text("a b".to_owned())),
    ];
    for values in [&known[..], &[]] {
        let values = values
            .iter()
            .map(|(name, value)| ((*name).to_owned(), value.clone()));
        last.individuals.push(Individual {
            class: "semco:MemoryWarning".to_owned(),
            interval: Some([at, at]),
            parent: Some(round),
            relations: Default::default(),
            values: values.collect(),
        });
    }
    all
}

async fn answer(session: &SqlSession, sql: &str) -> String {
    pretty_format_batches(&session.rows(sql).await.unwrap())
        .unwrap()
        .to_string()
}

/// Returns a session over a fleet, and one over a local memory, with the same episodes.
async fn sessions(folder: &Path, records: &[EpisodeRecord]) -> [SqlSession; 2] {
    let memory = memory(&folder.join("episodes"), records);
    let fleet = place(&folder.join("fleet"));
    push(&memory, &fleet, &PushOptions::default(), &mut |_, _| {})
        .await
        .unwrap();
    let local = open_local(&memory, Part::Facts).await.unwrap();
    let here = SqlSession::new(&local.sources).await.unwrap();
    [session(&fleet).await, here]
}

#[tokio::test]
async fn warnings_have_channel_deviation_and_p_value() {
    let folder = tempfile::tempdir().unwrap();
    for session in sessions(folder.path(), &records()).await {
        let sql = "SELECT channel, unit, round(deviation * 1000.0, 3) AS mm, p_value, alike_episodes, ending FROM warnings ORDER BY place";
        let found = answer(&session, sql).await;
        let lines: Vec<&str> = found.lines().collect();
        assert_eq!(lines.len(), 6, "{found}");
        assert_eq!(
            lines[3],
            "| height  | m    | 3.5 | 0.01    | a b            | complete |"
        );
        // What an episode does not state is null, not 0.
        assert_eq!(
            lines[4],
            "|         |      |     |         |                | complete |"
        );
        let others = "SELECT count(*) AS n FROM events WHERE class <> 'MemoryWarning' AND (channel IS NOT NULL OR p_value IS NOT NULL)";
        assert!(answer(&session, others).await.contains("| 0 |"));
    }
}

/// Returns the rows that the health report implies, as the statement of the test selects them.
fn expected(group: &GroupHealth) -> Vec<String> {
    let rows = group.channels.iter().map(|health| {
        let name = format!(
            "{}|{}|{}|{}|{}",
            group.robot.as_deref().unwrap(),
            group.tool.as_deref().unwrap(),
            group.surface.as_deref().unwrap(),
            group.runs,
            health.channel.as_str()
        );
        let number = |value: Option<f64>| {
            value.map_or_else(|| "null".to_owned(), |value| format!("{value:.9}"))
        };
        let ChannelState::Assessed(assessed) = &health.state else {
            return format!("{name}|null|null|null|null|null");
        };
        let trend = assessed.trend.as_ref();
        let left = trend.and_then(|trend| trend.runs_to_limit.as_ref());
        let change = assessed.change.as_ref();
        format!(
            "{name}|{}|{}|{}|{}|{}",
            number(trend.map(|trend| trend.value)),
            number(trend.map(|trend| trend.per_run)),
            number(trend.map(|trend| trend.p_adjusted)),
            number(change.map(|change| change.time_s)),
            number(left.map(|left| left.estimate)),
        )
    });
    rows.collect()
}

#[tokio::test]
async fn drift_equals_the_health_report() {
    let folder = tempfile::tempdir().unwrap();
    let records = records();
    let report = assess_groups(&gather_groups(&Catalogue::from_records(&records)));
    let mut expected: Vec<String> = report.groups.iter().flat_map(expected).collect();
    expected.sort();
    assert!(report.groups.len() > 2 && report.needs_attention);
    for session in sessions(folder.path(), &records).await {
        let names = "robot, tool, surface, CAST(runs AS VARCHAR), channel";
        let sql =
            format!("SELECT {names}, value, per_run, p_value, changed_s, runs_to_limit FROM drift");
        let mut found = Vec::new();
        for batch in session.rows(&sql).await.unwrap() {
            use datafusion::arrow::array::{Array, AsArray};
            use datafusion::arrow::compute::cast;
            use datafusion::arrow::datatypes::{DataType, Float64Type};
            for row in 0..batch.num_rows() {
                let cells = batch.columns().iter().enumerate().map(|(place, column)| {
                    if place < 5 {
                        let texts = cast(column, &DataType::Utf8).unwrap();
                        return texts.as_string::<i32>().value(row).to_owned();
                    }
                    match column.is_null(row) {
                        true => "null".to_owned(),
                        false => format!("{:.9}", column.as_primitive::<Float64Type>().value(row)),
                    }
                });
                found.push(cells.collect::<Vec<_>>().join("|"));
            }
        }
        found.sort();
        assert_eq!(found, expected);
        let drifts = "SELECT DISTINCT channel, needs_attention, advice FROM drift WHERE is_drift AND channel = 'tool stiffness'";
        let drifts = answer(&session, drifts).await;
        assert!(
            drifts.contains("replace the tool: it becomes softer"),
            "{drifts}"
        );
    }
}

#[tokio::test]
async fn unknown_values_are_null() {
    let folder = tempfile::tempdir().unwrap();
    for session in sessions(folder.path(), &records()[..8]).await {
        let sql = "SELECT count(*) AS n FROM drift WHERE state = 'too few' AND value IS NULL AND is_drift IS NULL \
                   AND needs_attention IS NULL AND runs_to_limit IS NULL AND p_value IS NULL";
        let all = answer(&session, "SELECT count(*) AS n FROM drift").await;
        assert_eq!(answer(&session, sql).await, all);
        assert!(!all.contains("| 0 "), "{all}");
    }
    // A session without episodes has the table, without rows.
    let none = session(&place(&folder.path().join("none"))).await;
    assert!(
        answer(&none, "SELECT count(*) AS n FROM drift")
            .await
            .contains("| 0 |")
    );
}

#[tokio::test]
async fn files_of_an_earlier_version_have_nulls() {
    let fixtures = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures");
    for name in ["version-1.0", "version-1.0-lacking"] {
        let fleet = StorePlace::open(fixtures.join(name).to_str().unwrap()).unwrap();
        let source = SqlSource::open(fleet).await.unwrap();
        let session = SqlSession::new(&[source]).await.unwrap();
        let stiffness =
            "SELECT DISTINCT state, press_force_n FROM drift WHERE channel = 'tool stiffness'";
        let found = answer(&session, stiffness).await;
        assert_eq!(found.lines().count(), 5, "{name}: {found}");
        assert!(
            found.contains("| not recorded |               |"),
            "{name}: {found}"
        );
        let warnings = "SELECT count(*) AS n FROM warnings";
        assert!(answer(&session, warnings).await.contains("| 0 |"), "{name}");
    }
}

#[tokio::test]
async fn rows_of_a_memory_by_an_earlier_version_are_written_anew() {
    let folder = tempfile::tempdir().unwrap();
    let memory = memory(folder.path(), &some(2));
    open_local(&memory, Part::Facts).await.unwrap();
    let log = folder.path().join(".catalogue/fleet/log");
    let read_log = || {
        let files = fs::read_dir(&log).unwrap();
        let texts = files.map(|file| fs::read_to_string(file.unwrap().path()).unwrap());
        texts.collect::<String>()
    };
    let now = read_log();
    assert!(now.contains("\"schema\":[1,1]"), "{now}");
    for file in fs::read_dir(&log).unwrap() {
        let path = file.unwrap().path();
        let text = fs::read_to_string(&path).unwrap();
        fs::write(&path, text.replace("\"schema\":[1,1]", "\"schema\":[1,0]")).unwrap();
    }
    let rows = open_local(&memory, Part::Facts).await.unwrap();
    let again = read_log();
    assert!(
        !again.contains("\"schema\":[1,0]") && again.contains("\"schema\":[1,1]"),
        "{again}"
    );
    let session = SqlSession::new(&rows.sources).await.unwrap();
    assert!(
        answer(&session, "SELECT count(*) AS n FROM episodes")
            .await
            .contains("| 2 |")
    );
}
