//! Questions to episodes with telemetry: of runs at once, and of files that were damaged.

use super::{engines, shown};
use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_6};
use std::fs;
use std::path::Path;
use tempfile::TempDir;
use wisch::follow::Phase;
use wisch::geometry::{Pose, Vector3};
use wisch::interpret::{TouchSample, WrenchQuality};
use wisch::run::TelemetrySample;
use wisch_memory::ask::{AskError, EngineCommand, QuerySession};
use wisch_memory::{
    EPISODE_SCHEMA, EpisodeRecord, Individual, Mark, Memory, Origin, RoundScene, TelemetryHead,
};

/// When both runs began and ended [s since 1970].
const RUNS: [[f64; 2]; 2] = [[1000.0, 1010.0], [1004.0, 1014.0]];
/// When somebody pushed during each [s since 1970], and the force throughout [N].
const PUSHES: [[f64; 2]; 2] = [[1005.0, 1006.25], [1005.5, 1006.5]];
const FORCES: [f64; 2] = [5.0, 7.0];
const PERIOD: f64 = 0.01;

fn store(memory: &Memory, run: usize) {
    let id = format!("run-{run}");
    let writer = memory.begin(&id).unwrap();
    let columns = ["external/fx", "external/fy", "external/fz"].map(str::to_owned);
    let mut telemetry = writer
        .telemetry_with_columns(1, TelemetryHead::default(), &columns)
        .unwrap();
    let [begin, end] = RUNS[run];
    let mark = Mark {
        motion: 0,
        phase: Phase::Wipe(0),
    };
    for k in 0..((end - begin) / PERIOD) as usize {
        let values = [0.0, 0.0, FORCES[run]];
        telemetry.push(k as f64 * PERIOD, mark, values).unwrap();
    }
    telemetry.finish().unwrap();
    writer.commit(&record(run)).unwrap();
}

fn record(run: usize) -> EpisodeRecord {
    let [begin, _] = RUNS[run];
    let individual = |class: &str, parent, interval| Individual {
        class: format!("semco:{class}"),
        interval: Some(interval),
        parent,
        relations: BTreeMap::new(),
        values: BTreeMap::new(),
    };
    EpisodeRecord {
        schema: EPISODE_SCHEMA,
        id: format!("run-{run}"),
        task: "board".to_owned(),
        interval: RUNS[run],
        origin: Origin::Simulated,
        program: "test".to_owned(),
        seed: 1,
        rounds: vec![begin],
        individuals: vec![
            individual("WipingEpisode", None, RUNS[run]),
            individual("HumanCollision", Some(0), PUSHES[run]),
        ],
    }
}

/// Two runs that wiped at the same time.
fn two_runs() -> (TempDir, Memory) {
    let folder = tempfile::tempdir().unwrap();
    let memory = Memory::create(&folder.path().join("episodes")).unwrap();
    (0..RUNS.len()).for_each(|run| store(&memory, run));
    (folder, memory)
}

fn asked(memory: &Memory, command: EngineCommand, query: &str) -> Vec<String> {
    let mut asker = QuerySession::open(memory.clone(), command).unwrap();
    shown(
        &asker
            .ask(query)
            .unwrap_or_else(|error| panic!("{query}: {error}")),
    )
}

/// The second run states that its sensor hung in the second half.
#[test]
fn wrenches_that_are_not_usable_are_no_forces_and_this_is_stated() {
    let folder = tempfile::tempdir().unwrap();
    let memory = Memory::create(&folder.path().join("episodes")).unwrap();
    let writer = memory.begin("run-1").unwrap();
    let mut telemetry = writer.telemetry(1, TelemetryHead::default()).unwrap();
    for k in 0..1000_u64 {
        let hangs = k >= 500;
        let force = Vector3::new(0.0, 0.0, if hangs { 90.0 } else { 7.0 });
        let mut sample = TelemetrySample::from_touch(
            &TouchSample::new(k as f64 * PERIOD, Pose::identity(), force),
            0,
            Phase::Wipe(0),
        );
        if hangs {
            sample.status.wrench = WrenchQuality::Stale;
        }
        telemetry.write(&sample).unwrap();
    }
    telemetry.finish().unwrap();
    writer.commit(&record(1)).unwrap();
    for command in engines() {
        let mut asker = QuerySession::open(memory.clone(), command.clone()).unwrap();
        let query = "telemetry(force, [1004, 1014], max, F)";
        let found = asker.ask(query).unwrap();
        assert_eq!(shown(&found), ["7.0"]);
        let remarks = found.remarks.join(" ");
        assert!(
            remarks.contains("the wrench of 500 samples is not usable"),
            "{remarks}"
        );
        for (channel, answer) in [("wrench_quality", "1.0"), ("'external/fz'", "90.0")] {
            let query = format!("telemetry({channel}, [1004, 1014], max, F)");
            assert_eq!(asked(&memory, command.clone(), &query), [answer], "{query}");
        }
    }
}

/// The sensor measures 8 N too little along the normal of a wall, with which the tool presses with 7 N.
#[test]
fn forces_are_those_on_the_tool_without_the_bias_of_the_sensor() {
    let folder = tempfile::tempdir().unwrap();
    let memory = Memory::create(&folder.path().join("episodes")).unwrap();
    for (run, angle) in [0.0, FRAC_PI_2, FRAC_PI_6].into_iter().enumerate() {
        let writer = memory.begin(&format!("run-{run}")).unwrap();
        let place = Vector3::new(0.5, 0.0, 0.7);
        let world_from_surface = Pose::new(place, Vector3::y() * angle);
        let rotation = world_from_surface.rotation;
        let scene = RoundScene::from_log("sponge", "board", &world_from_surface);
        let mut telemetry = writer.telemetry(1, scene.head(Vec::new())).unwrap();
        for k in 0..100 {
            let force = rotation * Vector3::new(0.0, 0.0, 7.0 - 8.0);
            let touch = TouchSample::new(f64::from(k) * PERIOD, Pose::identity(), force);
            let sample = TelemetrySample::from_touch(&touch, 0, Phase::Wipe(0));
            telemetry.write(&sample).unwrap();
        }
        telemetry.finish().unwrap();
        let mut record = record(0);
        record.id = format!("run-{run}");
        let mut round = record.individuals[1].clone();
        round.class = "semco:WipingRound".to_owned();
        for (key, value) in [("semco:round", 1.0), ("semco:forceBias", -8.0)] {
            (round.values).insert(key.to_owned(), wisch_memory::Value::Number(value));
        }
        record.individuals.push(round);
        writer.commit(&record).unwrap();
    }
    for command in engines() {
        let ask = |channel: &str| {
            let query = format!("telemetry({channel}, [1000, 1001], mean, F)");
            let found = asked(&memory, command.clone(), &query);
            let number = |text: &String| (1e3 * text.parse::<f64>().unwrap()).round() / 1e3;
            let mut found: Vec<f64> = found.iter().map(number).collect();
            found.sort_by(f64::total_cmp);
            found
        };
        assert_eq!(ask("force"), [7.0, 7.0, 7.0]);
        assert_eq!(ask("vertical_force"), [0.0, 6.062, 7.0]);
        assert_eq!(ask("'external/fz'"), [-1.0, -0.866, 0.0], "as measured");
    }
}

/// Half of the time the tool presses with 10 N, logged at 1 kHz, and half of the time it is in the air, logged at 20 Hz;
/// then there is a gap of 100 s before a last sample with 10 N.
#[test]
fn a_mean_is_over_time_at_any_rate() {
    let folder = tempfile::tempdir().unwrap();
    let memory = Memory::create(&folder.path().join("episodes")).unwrap();
    let writer = memory.begin("run-0").unwrap();
    let columns = ["external/fx", "external/fy", "external/fz"].map(str::to_owned);
    let mut telemetry = writer
        .telemetry_with_columns(1, TelemetryHead::default(), &columns)
        .unwrap();
    let mark = Mark {
        motion: 0,
        phase: Phase::Wipe(0),
    };
    let times = (0..5000).map(|k| 1e-3 * f64::from(k));
    let times = times.chain((100..200).map(|k| 0.05 * f64::from(k)));
    for time in times {
        let force = if time < 5.0 { 10.0 } else { 0.0 };
        telemetry.push(time, mark, [0.0, 0.0, force]).unwrap();
    }
    telemetry.push(110.0, mark, [0.0, 0.0, 10.0]).unwrap();
    telemetry.finish().unwrap();
    let mut record = record(0);
    record.interval = [1000.0, 1110.0];
    record.individuals[0].interval = Some(record.interval);
    writer.commit(&record).unwrap();
    for command in engines() {
        for (query, expected) in [
            ("telemetry(vertical_force, [1000, 1010], mean, F)", 5.0),
            (
                "telemetry(vertical_force, [1000, 1010], rms, F)",
                50_f64.sqrt(),
            ),
            // 10 s, half a second on either side of the gap, and 10 N for 5.5 s.
            ("telemetry(force, [1000, 1110], mean, F)", 5.0),
        ] {
            let found = asked(&memory, command.clone(), query);
            let [found] = found.as_slice() else {
                panic!("{query}: {found:?}");
            };
            let found: f64 = found.parse().unwrap();
            assert!(
                (found - expected).abs() < 0.03 * expected,
                "{query}: {found}"
            );
        }
    }
}

#[test]
fn runs_at_once_are_not_mixed() {
    let (_folder, memory) = two_runs();
    for command in engines() {
        for (query, answers) in [
            // As the paper asks: each push is of its own run, by its times.
            (
                "has_type(C, 'Collision'), occurs(C, [S, E]), telemetry(force, [S, E], mean, F)",
                [
                    "semco:'HumanCollision_run-0-1' 1005.0 1006.25 5.0",
                    "semco:'HumanCollision_run-1-1' 1005.5 1006.5 7.0",
                ]
                .as_slice(),
            ),
            // An event brings its run along.
            (
                "has_type(C, 'Collision'), telemetry(force, C, mean, F)",
                &[
                    "semco:'HumanCollision_run-0-1' 5.0",
                    "semco:'HumanCollision_run-1-1' 7.0",
                ],
            ),
            // Any other time is answered run by run.
            ("telemetry(force, [1005, 1006], mean, F)", &["5.0", "7.0"]),
            ("telemetry(force, [0, 1003], max, F)", &["5.0"]),
            (
                "telemetry_in(R, force, [1005, 1006], max, F)",
                &[
                    "semco:'WipingEpisode_run-0-0' 5.0",
                    "semco:'WipingEpisode_run-1-0' 7.0",
                ],
            ),
            (
                "telemetry_in('WipingEpisode_run-1-0', force, [1005, 1006], max, F)",
                &["7.0"],
            ),
        ] {
            assert_eq!(asked(&memory, command.clone(), query), answers, "{query}");
        }
    }
}

#[test]
fn an_episode_without_telemetry_is_named_and_left_out() {
    let (_folder, memory) = two_runs();
    // As on a full disk: the record says why.
    let mut record = memory.episode("run-1").unwrap().record().unwrap();
    record.id = "run-2".to_owned();
    let mut round = record.individuals[1].clone();
    round.class = "semco:WipingRound".to_owned();
    round
        .values
        .insert("semco:round".into(), wisch_memory::Value::Number(1.0));
    record.individuals.push(round);
    record.set_telemetry_lost(1, "No space left on device");
    memory.begin("run-2").unwrap().commit(&record).unwrap();
    for command in engines() {
        let mut asker = QuerySession::open(memory.clone(), command).unwrap();
        for query in [
            "has_type(C, 'Collision'), telemetry(force, C, mean, F)",
            "findall(C-F, (has_type(C, 'Collision'), telemetry(force, C, mean, F)), L), member(C-F, L)",
        ] {
            let answers = asker.ask(query).unwrap();
            assert_eq!(answers.rows.len(), 2, "{query}: {:?}", shown(&answers));
            let [remark] = answers.remarks.as_slice() else {
                panic!("{query}: {:?}", answers.remarks);
            };
            assert!(
                remark.contains("run-2") && remark.contains("No space left"),
                "{remark}"
            );
        }
        let error = asker
            .ask("telemetry(force, 'HumanCollision_run-2-1', mean, F)")
            .unwrap_err();
        assert!(error.to_string().contains("run-2"), "{error}");
        // What is wrong with the query is said, whatever is left out.
        let error = asker
            .ask("telemetry(farce, [1005, 1006], mean, F)")
            .unwrap_err();
        assert!(
            error.to_string().contains("nearest: force; known: force, "),
            "{error}"
        );
    }
    let faults: Vec<String> = memory
        .verify()
        .unwrap()
        .iter()
        .map(ToString::to_string)
        .collect();
    let [fault] = faults.as_slice() else {
        panic!("{faults:?}");
    };
    assert!(
        fault.contains("run-2") && fault.contains("round 1 has no telemetry: No space left"),
        "{fault}"
    );
}

/// A log of a tool that moves along x for 10 s, a centimetre a second, with nothing recorded from 4 to 8 s.
fn store_log(memory: &Memory, id: &str, head: TelemetryHead) {
    let writer = memory.begin(id).unwrap();
    let columns = ["x", "y", "z", "qx", "qy", "qz", "qw"].map(|name| format!("measured/{name}"));
    let mut telemetry = writer.telemetry_with_columns(1, head, &columns).unwrap();
    let mark = Mark {
        motion: 0,
        phase: Phase::FreeMotion,
    };
    for k in (0..=1000).filter(|k| !(400..800).contains(k)) {
        let time = f64::from(k) * PERIOD;
        telemetry
            .push(time, mark, [0.01 * time, 0.25, 0.75, 0.0, 0.0, 0.0, 1.0])
            .unwrap();
    }
    telemetry.finish().unwrap();
    let mut action = Individual {
        class: "semco:WipingAction".to_owned(),
        interval: Some([1000.0, 1010.0]),
        parent: None,
        relations: BTreeMap::new(),
        values: BTreeMap::new(),
    };
    for (property, thing) in [
        ("semco:usesTool", "semco:sponge"),
        ("semco:actsOnSurface", "semco:table"),
    ] {
        action
            .relations
            .insert(property.to_owned(), vec![thing.to_owned()]);
    }
    let record = EpisodeRecord {
        schema: EPISODE_SCHEMA,
        id: id.to_owned(),
        task: "board".to_owned(),
        interval: [1000.0, 1010.0],
        origin: Origin::Imported("wipe.csv".to_owned()),
        program: "test".to_owned(),
        seed: 1,
        rounds: vec![1000.0],
        individuals: vec![action],
    };
    writer.commit(&record).unwrap();
}

#[test]
fn where_the_tool_of_a_log_was_is_answered_from_its_poses() {
    let lifted = wisch::geometry::Pose::translation(0.0, 0.0, 0.7);
    let scene = wisch_memory::RoundScene::from_log("sponge", "table", &lifted);
    // Older episodes have no scene.
    for (head, has_scene) in [
        (scene.head(Vec::new()), true),
        (TelemetryHead::default(), false),
    ] {
        let folder = tempfile::tempdir().unwrap();
        let memory = Memory::create(&folder.path().join("episodes")).unwrap();
        store_log(&memory, "log-1", head);
        for command in engines() {
            let mut asker = QuerySession::open(memory.clone(), command).unwrap();
            let at = |asker: &mut QuerySession, query: &str| shown(&asker.ask(query).unwrap());
            let place = "[X, Y, Z], _), A is round(1000 * X), B is round(1000 * Y), C is round(1000 * Z), _ = [X, Y, Z]";
            let rows = at(&mut asker, &format!("tf(sponge, 1002.0, {place}"));
            assert!(rows[0].ends_with("20 250 750"), "{rows:?}");
            let rows = at(&mut asker, "tf(sponge, [F, _, Q])");
            assert_eq!(rows, ["world [0.0, 0.0, 0.0, 1.0]"]);
            let rows = at(
                &mut asker,
                "object_trajectory(semco:sponge, [1000, 1010], dt(1.0), _T), length(_T, N)",
            );
            // At 0, 1, 2, 3, 4, 8, 9 and 10 s: nothing is known between 4 and 8 s.
            assert_eq!(rows, ["8"]);
            let gap = asker
                .ask("tf(sponge, 1006.0, P, Q)")
                .unwrap_err()
                .to_string();
            assert!(gap.contains("nothing was recorded within 0.5 s"), "{gap}");
            let surface = asker.ask("tf(table, 1002.0, P, Q)");
            match has_scene {
                true => assert_eq!(
                    shown(&surface.unwrap()),
                    ["[0.0, 0.0, 0.7] [0.0, 0.0, 0.0, 1.0]"]
                ),
                false => assert!(
                    surface
                        .unwrap_err()
                        .to_string()
                        .contains("does not hold the pose of table")
                ),
            }
        }
    }
}

#[test]
fn a_damaged_episode_is_named_and_left_out() {
    let (_folder, memory) = two_runs();
    let file = memory.folder().join("run-1/round-1.parquet");
    let mut bytes = fs::read(&file).unwrap();
    let middle = bytes.len() / 3;
    bytes[middle] ^= 1;
    fs::write(&file, bytes).unwrap();
    for command in engines() {
        let mut asker = QuerySession::open(memory.clone(), command).unwrap();
        let answers = asker
            .ask("telemetry(force, [1005, 1006], mean, F)")
            .unwrap();
        assert_eq!(shown(&answers), ["5.0"]);
        assert_eq!(answers.remarks.len(), 1);
        let remark = &answers.remarks[0];
        assert!(
            remark.contains("run-1") && remark.contains("check sum"),
            "{remark}"
        );
        let error = asker
            .ask("telemetry(force, [1012, 1013], mean, F)")
            .unwrap_err();
        assert!(matches!(&error, AskError::Fault(_)), "{error}");
        assert!(error.to_string().contains("round-1.parquet"), "{error}");
        assert_eq!(
            shown(&asker.ask("has_type(X, 'Collision')").unwrap()).len(),
            2
        );
    }
}

#[test]
fn an_episode_whose_record_is_damaged_is_named_and_left_out() {
    for damage in [
        |file: &Path| fs::write(file, "{").unwrap(),
        |file: &Path| {
            // Still JSON, and a number still.
            let text = fs::read_to_string(file).unwrap();
            fs::write(file, text.replace("1005.5", "1005.7")).unwrap();
        },
    ] {
        let (_folder, memory) = two_runs();
        damage(&memory.folder().join("run-1/episode.json"));
        let catalogue = memory.catalogue().unwrap();
        assert_eq!(catalogue.omitted_episodes().len(), 1);
        assert!(catalogue.omitted_episodes()[0].contains("run-1"));
        for command in engines() {
            let found = asked(&memory, command, "has_type(X, 'Collision')");
            assert_eq!(found, ["semco:'HumanCollision_run-0-1'"]);
        }
    }
}
