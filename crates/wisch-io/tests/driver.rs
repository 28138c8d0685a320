//! What version 2 of the executor protocol offers to the drivers of real robots.

use crate::process::{CHILD, has_python, loaded, motion, order};
use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};
use wisch::follow::Phase;
use wisch::interpret::{Doubt, WrenchQuality};
use wisch::run::{
    Ending, Execution, Executor, ExecutorError, PlannedRound, RunConfig, SampleStatus, Session,
    Stamp, StampClock, TelemetrySample, ignore_events,
};
use wisch_io::{DriverRobotRecord, PauseSwitch, ProcessExecutor, ProcessOptions};

/// Executes any number of motions, each twice as fast as planned, and writes the received messages
/// to a file, one word each. `spoil(word)` is called before the answer to each word.
const DRIVER: &str = r#"
import json, sys
def hear():
    line = sys.stdin.readline()
    return json.loads(line) if line else None
def write(message):
    print(json.dumps(message), flush=True)
def say(**message):
    write(message)
def done(motion, ending):
    say(done={"duration_s": motion["duration_s"], "ending": ending, "positions": points[-1]["positions"]})
while (message := hear()) is not None:
    word = message if isinstance(message, str) else next(iter(message))
    with open(HEARD, "a") as file:
        file.write(word + "\n")
    spoil(word)
    if word == "hello":
        robot = message["hello"].get("robot")
        say(ready={"version": 2, **READY})
    elif word == "prepare":
        write("prepared")
    elif word == "finish":
        write("finished")
    elif word == "execute":
        motion = message["execute"]
        points = [hear()["point"] for _ in range(motion["points"])]
        for point in points:
            say(sample={"time_s": point["time_s"], "force_n": [0, 0, 0], "positions": point["positions"]})
        done(motion, "complete")
"#;

/// Starts a driver. `ready`: what its greeting adds. `spoil`: lines of Python that it executes before each answer.
fn driver(heard: &tempfile::NamedTempFile, ready: &str, spoil: &str) -> ProcessExecutor {
    let spoil = spoil.replace('\n', "\n    ");
    let script = format!(
        "HEARD = {:?}\nREADY = {{{ready}}}\ndef spoil(word):\n    {spoil}\n{DRIVER}",
        heard.path().display().to_string()
    );
    let options = ProcessOptions {
        robot: Some(described()),
        ..ProcessOptions::default()
    };
    ProcessExecutor::start_with("python3", &["-c".to_owned(), script], options).expect("it greets")
}

fn described() -> DriverRobotRecord {
    let planned = motion();
    let (_, robot) = loaded();
    DriverRobotRecord::new(&robot, &planned.cell, &planned.task.tool.name)
}

fn words(heard: &tempfile::NamedTempFile) -> Vec<String> {
    let text = std::fs::read_to_string(heard.path()).expect("its words");
    text.lines().map(str::to_owned).collect()
}

fn file() -> tempfile::NamedTempFile {
    tempfile::NamedTempFile::new().expect("a file")
}

fn execute(
    child: &mut ProcessExecutor,
    planned: &PlannedRound,
) -> Result<Execution, ExecutorError> {
    let order = order(planned);
    child.execute(&order, &mut |_| ControlFlow::Continue(()))
}

#[test]
fn a_driver_learns_which_robot_it_drives() {
    if !has_python() {
        return;
    }
    let heard = file();
    let lines = r#"
global check
if word == "execute":
    check = lambda motion: [
        key for key, same in [
            ("joints", robot["joints"] == motion["joints"]),
            ("tip", robot["tip"] == motion["tip"]),
            ("tip_from_tool", robot["tip_from_tool"] == motion["tip_from_tool"]),
            ("name", robot["name"] == motion["robot"] == "arm7"),
            ("tool", robot["tool"] == motion["tool"]),
            ("urdf", "<robot" in robot["urdf"] and all(f'"{j}"' in robot["urdf"] for j in robot["joints"])),
            ("srdf", "<group" in robot["srdf"]),
            ("arm_joints", set(robot["arm_joints"]) <= set(robot["joints"]) and robot["arm_joints"]),
        ] if not same
    ]
    wrong = check(message["execute"])
    if wrong:
        say(error=f"these differ: {wrong}")
"#;
    let planned = motion();
    execute(&mut driver(&heard, "", lines), &planned).expect("it is the same robot");
}

#[test]
fn a_description_that_is_too_long_leaves_texts_out() {
    let (_, mut robot) = loaded();
    let planned = motion();
    let mut describe = |urdf: usize, srdf: usize| {
        robot.files.urdf = "u".repeat(urdf);
        robot.files.srdf = Some("s".repeat(srdf));
        let record = DriverRobotRecord::new(&robot, &planned.cell, "sponge");
        (record.urdf.is_some(), record.srdf.is_some())
    };
    assert_eq!(describe(400_000, 600_000), (true, true));
    assert_eq!(describe(400_000, 700_000), (true, false));
    assert_eq!(describe(1_100_000, 10), (false, false));
}

#[test]
fn a_driver_prepares_before_its_first_motion_and_finishes_after_its_last() {
    if !has_python() {
        return;
    }
    let (loaded, robot) = loaded();
    let heard = file();
    let mut child = driver(&heard, "\"prepares\": True", "pass");
    let mut session = loaded.session().with_robot(robot.robot_setup());
    let run = session.run(&mut child, &mut ignore_events);
    assert_eq!((run, session.finish_failure()), (Ok(()), None));
    drop(child);
    let mut words = words(&heard);
    words.retain(|word| word != "observe");
    words.dedup();
    assert_eq!(words, ["hello", "prepare", "execute", "finish"]);

    // A driver that does not state this ability receives neither.
    let heard = file();
    let mut child = driver(&heard, "", "pass");
    let mut session = loaded.session().with_robot(robot.robot_setup());
    assert_eq!(session.run(&mut child, &mut ignore_events), Ok(()));
    let words = self::words(&heard);
    assert!(
        !words
            .iter()
            .any(|word| word == "prepare" || word == "finish"),
        "{words:?}"
    );
}

#[test]
fn a_driver_that_cannot_prepare_moves_nothing_and_one_that_cannot_finish_is_named() {
    if !has_python() {
        return;
    }
    let (loaded, robot) = loaded();
    let run = |spoil: &str| {
        let heard = file();
        let mut child = driver(&heard, "\"prepares\": True", spoil);
        let mut session = loaded.session().with_robot(robot.robot_setup());
        let run = session.run(&mut child, &mut ignore_events);
        let failure = session.finish_failure().map(ToString::to_string);
        drop(child);
        (
            run.map_err(|error| error.to_string()),
            failure,
            words(&heard),
        )
    };
    let (result, failure, words) =
        run("if word == \"prepare\": say(error=\"the brakes are closed\")");
    let reason = "executor \"python3\": the brakes are closed";
    assert_eq!((result, failure), (Err(reason.to_owned()), None));
    let moved = words
        .iter()
        .any(|word| word == "execute" || word == "finish");
    assert!(!moved, "{words:?}");

    let (result, failure, _) = run("if word == \"finish\": say(error=\"the pendant is locked\")");
    let reason = "executor \"python3\": the pendant is locked";
    assert_eq!((result, failure.as_deref()), (Ok(()), Some(reason)));

    // After a fault the robot is stopped first.
    let (result, failure, words) = run("if word == \"execute\": say(nonsense=1)");
    let error = result.expect_err("it is no message");
    assert!(
        error.contains("is not a message of the protocol"),
        "{error}"
    );
    assert_eq!(failure, None);
    assert_eq!(words[words.len() - 2..], ["stop", "finish"]);

    // Late messages about the motion are no fault, and the driver has time to hand the robot back.
    let late = "if word == \"execute\": say(nonsense=1)\nif word == \"finish\":\n    print(\"no message\", flush=True)\n    say(observation=None)\n    import time\n    time.sleep(0.8)\n    open(HEARD, \"a\").write(\"handed back\\n\")";
    let (_, failure, words) = run(late);
    assert_eq!(failure, None);
    assert_eq!(words[words.len() - 2..], ["finish", "handed back"]);
}

#[test]
fn a_driver_whose_run_is_abandoned_finishes_too() {
    if !has_python() {
        return;
    }
    let planned = motion();
    let heard = file();
    let mut child = driver(&heard, "\"prepares\": True", "pass");
    child.prepare(&planned.cell).expect("it prepares");
    drop(child);
    assert_eq!(words(&heard), ["hello", "prepare", "finish"]);
    let greeting = "say(ready={\"version\": 1, \"prepares\": True})";
    let script = CHILD.replace("say(ready={\"version\": 1})", greeting);
    let started = ProcessExecutor::start("python3", &["-c".to_owned(), script]);
    let error = started.expect_err("it is refused").to_string();
    assert!(error.contains("ready: prepares needs version 2"), "{error}");
}

/// Has a child of version 2 execute a motion with a switch to pause it. `ready`: what its greeting adds. `lines`: what it
/// does after it has received the points. Returns the execution and the samples.
fn executed(
    planned: &PlannedRound,
    ready: &str,
    lines: &str,
    options: ProcessOptions,
    mut take: impl FnMut(&TelemetrySample<'_>),
) -> Result<Execution, ExecutorError> {
    let greeting = format!("say(ready={{\"version\": 2, {ready}}})");
    let begin = CHILD.replace("say(ready={\"version\": 1})", &greeting);
    let script = format!("{begin}{lines}\n");
    let mut child = ProcessExecutor::start_with("python3", &["-c".to_owned(), script], options)?;
    let order = order(planned);
    child.execute(&order, &mut |sample| {
        take(sample);
        ControlFlow::Continue(())
    })
}

fn with_silence(seconds: f64) -> ProcessOptions {
    ProcessOptions {
        silence: Duration::from_secs_f64(seconds),
        ..ProcessOptions::default()
    }
}

#[test]
fn stamps_and_qualities_of_wrenches_are_taken_over() {
    if !has_python() {
        return;
    }
    let planned = motion();
    let lines = r#"
for k, quality in enumerate(["ok", "stale", "saturated", "untared"]):
    sample(k, stamp_ns=1764150000123456789 + k, wrench_quality=quality)
sample(4)
done("stopped")
"#;
    let mut statuses = Vec::new();
    executed(
        &planned,
        "\"stamp_clock\": \"device\"",
        lines,
        ProcessOptions::default(),
        |sample| statuses.push(sample.status),
    )
    .expect("it ends");
    let mut expected: Vec<SampleStatus> = (0..)
        .zip(WrenchQuality::ALL)
        .map(|(k, wrench)| SampleStatus {
            stamp: Some(Stamp {
                nanoseconds: 1_764_150_000_123_456_789 + k,
                clock: StampClock::Device,
            }),
            wrench,
            is_paused: false,
        })
        .collect();
    expected.push(SampleStatus::default());
    assert_eq!(statuses, expected);

    for (ready, lines, expected) in [
        (
            "",
            "sample(0, stamp_ns=1)",
            "at 0 s there is a stamp_ns, but stamp_clock does not state its clock",
        ),
        (
            "\"stamp_clock\": \"epoch\"",
            "sample(0, stamp_ns=1 << 62)",
            "at 0 s stamp_ns is 4611686018427387904, beyond the limit of 2147483647000000000",
        ),
        (
            "\"stamp_clock\": \"device\"",
            "sample(0, stamp_ns=7)\nsample(1, stamp_ns=7)\nsample(2, stamp_ns=6)",
            "stamp_ns is 6, less than 7 of an earlier sample",
        ),
        (
            "\"stamp_clock\": \"sundial\"",
            "",
            "unknown clock of stamps \"sundial\"",
        ),
        (
            "",
            "sample(0, wrench_quality=\"dirty\")",
            "unknown quality of a wrench \"dirty\"",
        ),
    ] {
        let options = ProcessOptions::default();
        let error = executed(&planned, ready, lines, options, |_| ()).expect_err(lines);
        assert!(error.to_string().contains(expected), "{lines}: {error}");
    }
}

#[test]
fn a_wrench_that_is_not_usable_is_no_touch() {
    if !has_python() {
        return;
    }
    let (loaded, robot) = loaded();
    // In the second half of the motion the sensor repeats its last value, 50 N.
    let lines = r#"
x, y, z, w = motion["world_from_surface"][3:]
normal = [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)]
wipes = [p for p in motion["phases"] if p["phase"] == "wipe"]
for point in points:
    time = point["time_s"]
    presses = any(p["start_s"] <= time <= p["end_s"] for p in wipes)
    stale = time > motion["duration_s"] / 2
    force = 50.0 if stale else motion["press_force_n"] * presses
    sample(time, world_from_tool=point["world_from_tool"], positions=point["positions"],
           force_n=[force * n for n in normal], wrench_quality="stale" if stale and USE else "ok")
done("complete", duration=motion["duration_s"])
"#;
    let run = |is_stated: &str| {
        let greeting = "say(ready={\"version\": 2})";
        let begin = CHILD.replace("say(ready={\"version\": 1})", greeting);
        let script = format!("USE = {is_stated}\n{begin}{lines}\n");
        let mut child =
            ProcessExecutor::start("python3", &["-c".to_owned(), script]).expect("it greets");
        let config = RunConfig {
            max_rounds: 1,
            ..loaded.run.clone()
        };
        let mut session = Session::new(&loaded.task, config)
            .with_belief(loaded.belief())
            .with_robot(robot.robot_setup());
        let run = session.run(&mut child, &mut ignore_events);
        assert_eq!(run, Ok(()));
        session.into_rounds().remove(0)
    };
    let round = run("True");
    let samples = round.execution.duration / 0.01;
    let [Doubt::UnusableWrench { unusable, share }] = round.interpretation.doubts[..] else {
        panic!("{:?}", round.interpretation.doubts);
    };
    assert_eq!(unusable.stale, unusable.count());
    assert!(
        (unusable.count() as f64 - 0.5 * samples).abs() < 2.0,
        "{unusable:?} of {samples}"
    );
    assert!((share - 0.5).abs() < 0.01, "{share}");
    let doubt = round.interpretation.doubts[0].to_string();
    assert!(
        doubt.contains(&format!("({} stale)", unusable.stale)),
        "{doubt}"
    );
    let trusted = run("False");
    assert!(
        trusted.interpretation.events != round.interpretation.events,
        "the stale force would be read as a push"
    );
    assert!(
        round
            .interpretation
            .events
            .iter()
            .all(|event| !event.kind.is_by_hand())
    );
}

#[test]
fn a_phase_states_how_the_force_rises_and_falls() {
    if !has_python() {
        return;
    }
    let planned = motion();
    let lines = r#"
def height(time):
    near = min(points, key=lambda point: abs(point["time_s"] - time))
    return near["world_from_tool"][2] - motion["world_from_surface"][2]
F = motion["press_force_n"]
wrong = []
for p in motion["phases"]:
    kind = p["phase"]
    if kind in ("drive", "transfer", "lifted"):
        wrong += [p] if "force_n" in p else []
        continue
    expected = {"lower": [0, F], "wipe": [F, F], "lift": [F, 0]}[kind]
    ramp, speed = p["force_ramp_s"], p["approach_speed_m_s"]
    if p["force_n"] != expected or (kind == "wipe") != (ramp == 0):
        wrong.append(p)
    if kind == "lower" and abs(height(p["end_s"] - ramp) - 0.012) > 0.003:
        wrong.append((p, height(p["end_s"] - ramp)))
    if kind == "lift" and abs(height(p["start_s"] + ramp) - 0.012) > 0.003:
        wrong.append((p, height(p["start_s"] + ramp)))
    # The tool comes down at 0.1 m/s at most, and lifts as fast as it may.
    most = {"wipe": 0, "lower": 0.105, "lift": 2}[kind]
    if kind != "wipe" and not 0.9 * 0.012 / ramp <= speed <= most:
        wrong.append((p, speed))
if wrong:
    say(error=json.dumps(wrong)[:300])
follow()
done("complete", duration=motion["duration_s"])
"#;
    executed(&planned, "", lines, ProcessOptions::default(), |_| ()).expect("all are as expected");
}

#[test]
fn a_pause_is_no_silence_and_is_recorded() {
    if !has_python() {
        return;
    }
    let planned = motion();
    // Without a pause, the limits are 1.5 s.
    let lines = r#"
wipe = next(p for p in motion["phases"] if p["phase"] == "wipe")
at = next(i for i, point in enumerate(points) if point["time_s"] > wipe["end_s"] - 0.2)
def pass_(points, late):
    for point in points:
        sample(point["time_s"] + late, world_from_tool=point["world_from_tool"], positions=point["positions"])
pass_(points[:at], 0)
now = points[at]["time_s"]
say(paused={"time_s": now, "reason": "the pendant"})
sample(now + 0.25, world_from_tool=points[at]["world_from_tool"], positions=points[at]["positions"])
time.sleep(4)
say(resumed={"time_s": now + 0.5})
pass_(points[at:], 0.5)
done("complete", duration=motion["duration_s"] + 0.5)
"#;
    let (mut paused, mut wrong, mut count) = (0, 0, 0);
    let order = order(&planned);
    let mut begin = f64::INFINITY;
    let execution = executed(&planned, "", lines, with_silence(1.5), |sample| {
        if sample.status.is_paused {
            paused += 1;
            begin = sample.time - 0.25;
            return;
        }
        // The phase is that of the time without the pause, from the first sample after it on.
        count += 1;
        let late = if sample.time > begin { 0.5 } else { 0.0 };
        let meant = order.motion_at(sample.time - late).expect("it moves");
        wrong += usize::from(meant != (sample.motion, sample.phase));
    });
    let execution = execution.expect("it ends");
    let [pause] = &execution.pauses[..] else {
        panic!("{:?}", execution.pauses);
    };
    assert_eq!(execution.ending, Ending::Complete);
    assert_eq!(pause.phase, Phase::Wipe(0));
    let length = pause.end.expect("it has ended") - pause.start;
    assert!((length - 0.5).abs() < 1e-9, "{length} s");
    assert_eq!((pause.reason.as_str(), paused), ("the pendant", 1));
    // Times at the border of two phases are rounded.
    assert!(
        wrong <= 2 && count > 100,
        "{wrong} of {count} samples have another phase"
    );

    for (lines, expected) in [
        (
            "sample(0); say(paused={'time_s': 1}); say(paused={'time_s': 2})",
            "paused at 2 s, but it is paused already",
        ),
        (
            "sample(0); say(resumed={'time_s': 1})",
            "resumed at 1 s, but it is not paused",
        ),
        (
            "sample(0.5); say(paused={'time_s': 0.25})",
            "paused at 0.25 s; expected 0.5 to",
        ),
        (
            "sample(0); say(paused={'time_s': 1}); say(resumed={'time_s': 1}); time.sleep(60)",
            "no message for 0.7 s",
        ),
        (
            "sample(0); say(paused={'time_s': 1}); say(resumed={'time_s': 901}); sample(902, world_from_tool=points[0]['world_from_tool']); done('complete', duration=902)",
            "the last sample is at 902 s, 900.000 s of which it was paused",
        ),
        (
            "sample(0); say(paused={'time_s': 1}); sys.exit(3)",
            "it ended while wisch waited",
        ),
    ] {
        let silence = if lines.contains("sleep") { 0.7 } else { 20.0 };
        let error = executed(&planned, "", lines, with_silence(silence), |_| ()).expect_err(lines);
        assert!(error.to_string().contains(expected), "{lines}: {error}");
    }
    // A motion may end in its pause, however long that was.
    let lines = "sample(0); say(paused={'time_s': 1}); say(done={'duration_s': 5000, 'ending': 'stopped', 'positions': []})";
    let execution = executed(&planned, "", lines, with_silence(20.0), |_| ()).expect("it ends");
    assert_eq!(execution.pauses[0].end, None);
}

#[test]
fn an_operator_pauses_a_motion_and_lets_it_continue() {
    if !has_python() {
        return;
    }
    let planned = motion();
    let lines = r#"
def wait_for(word):
    heard = hear()
    if heard != word:
        say(error=f"expected {word}, found {heard}")
sample(0)
wait_for("pause")
say(paused={"time_s": 0.5})
sample(1)
wait_for("resume")
say(resumed={"time_s": 2})
sample(3)
done("stopped")
"#;
    let switch = Arc::new(PauseSwitch::default());
    let options = ProcessOptions {
        pause: Arc::clone(&switch),
        ..with_silence(20.0)
    };
    let execution = executed(&planned, "\"pauses\": True", lines, options, |sample| {
        // The operator pauses after the first sample, and continues after the second.
        if sample.time < 3.0 {
            switch.toggle();
        }
    });
    let execution = execution.expect("it ends");
    assert!(switch.is_supported());
    assert_eq!(execution.pauses.len(), 1);

    let switch = Arc::new(PauseSwitch::default());
    let options = ProcessOptions {
        pause: Arc::clone(&switch),
        ..with_silence(20.0)
    };
    let lines = "k = 0\nwhile True:\n    k += 1\n    sample(k * 1e-3)\n    time.sleep(0.001)";
    let error = executed(&planned, "\"pauses\": True", lines, options, |sample| {
        if sample.time == 1e-3 {
            switch.toggle();
        }
    });
    let error = error.expect_err("it goes on").to_string();
    assert!(
        error.contains("it has not paused 5 s after \"pause\""),
        "{error}"
    );
}

#[test]
fn slow_observers_do_not_keep_a_real_time_driver_waiting() {
    if !has_python() {
        return;
    }
    let planned = motion();
    let folder = tempfile::tempdir().expect("a folder");
    let written = folder.path().join("written");
    let lines = format!(
        r#"
pose, positions = points[0]["world_from_tool"], points[0]["positions"]
for k in range(30000):
    sys.stdout.write('{{"sample": ' + json.dumps({{"time_s": k * 1e-4, "force_n": [0, 0, 0], "world_from_tool": pose, "positions": positions}}) + "}}\n")
sys.stdout.flush()
open({:?}, "w").close()
done("stopped", duration=3)
"#,
        written.display().to_string()
    );
    let mut times = Vec::new();
    let execution = executed(
        &planned,
        "\"real_time\": True",
        &lines,
        with_silence(60.0),
        |sample| {
            let begin = Instant::now();
            while times.is_empty() && !written.exists() {
                assert!(
                    begin.elapsed() < Duration::from_secs(50),
                    "the driver waits"
                );
                std::thread::sleep(Duration::from_millis(5));
            }
            times.push(sample.time);
        },
    );
    let execution = execution.expect("it ends");
    assert_eq!(times.len() + execution.dropped_samples, 30_000);
    assert!(
        execution.dropped_samples > 9_000,
        "{}",
        execution.dropped_samples
    );
    let last = times.last().copied();
    assert_eq!(last, Some(29_999.0 * 1e-4), "the newest samples are kept");
    assert!(times.is_sorted());
}

#[test]
fn a_pause_between_motions_ends_before_the_state_is_asked_for() {
    if !has_python() {
        return;
    }
    let switch = Arc::new(PauseSwitch::default());
    let script = "import json, sys\nfor line in sys.stdin:\n    if 'hello' in line:\n        print('{\"ready\": {\"version\": 2}}', flush=True)";
    let options = ProcessOptions {
        pause: Arc::clone(&switch),
        ..ProcessOptions::default()
    };
    let arguments = ["-c".to_owned(), script.to_owned()];
    let mut child = ProcessExecutor::start_with("python3", &arguments, options).expect("it greets");
    assert!(!switch.is_supported());
    assert!(switch.toggle());
    let has_continued = AtomicBool::new(false);
    std::thread::scope(|scope| {
        scope.spawn(|| {
            std::thread::sleep(Duration::from_millis(200));
            has_continued.store(true, Ordering::SeqCst);
            switch.toggle();
        });
        assert_eq!(child.state(), Ok(None));
        assert!(has_continued.load(Ordering::SeqCst), "it did not wait");
    });
}
