//! Executors in separate processes: the documented one, and faulty ones.

use std::ops::ControlFlow;
use std::process::Command;
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};
use wisch::geometry::{Mesh, Point3, SheetConfig, Vector3};
use wisch::recover::Verdict;
use wisch::represent::{AngleRange, MeshShape, SurfaceShape, TiltFreedom};
use wisch::run::{
    Ending, Execution, Executor, ExecutorError, MotionOrder, NoExecutor, PlannedRound,
    RecordedSample, RunError, Stage, StopKind, ignore_events,
};
use wisch_io::{LoadOptions, LoadedTask, ProcessExecutor, ProcessOptions, Robot, load_task};

const ECHO_ROBOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/echo_robot.py");

/// The first lines of the children below: functions to greet, to receive a motion, and to send
/// samples.
pub const CHILD: &str = r#"
import json, select, signal, sys, time
signal.signal(signal.SIGPIPE, signal.SIG_DFL)
def hear():
    line = sys.stdin.readline()
    return json.loads(line) if line else sys.exit()
def say(**message):
    print(json.dumps(message), flush=True)
hear()
say(ready={"version": 1})
motion = hear()["execute"]
points = [hear()["point"] for _ in range(motion["points"])]
last = 0
def sample(time, **more):
    global last
    last = time
    pose = points[0]["world_from_tool"]
    at = {"world_from_tool": pose, "positions": points[0]["positions"]}
    say(sample={"time_s": time, "force_n": [0, 0, 0], **at, **more})
def follow(speed=1):
    for point in points:
        place = {"world_from_tool": point["world_from_tool"], "positions": point["positions"]}
        sample(point["time_s"] / speed, **place)
def done(ending, positions=points[-1]["positions"], duration=None):
    duration = max(last, 1) if duration is None else duration
    say(done={"duration_s": duration, "ending": ending, "positions": positions})
"#;

/// Whether Python is installed; in CI it must be.
pub fn has_python() -> bool {
    let is_there = Command::new("python3").arg("--version").output().is_ok();
    let is_ci = std::env::var("CI").is_ok_and(|ci| ci == "true");
    assert!(is_there || !is_ci, "there is no python3");
    if !is_there {
        eprintln!("SKIPPED: there is no python3 to run executors with");
    }
    is_there
}

pub fn loaded() -> (LoadedTask, Robot) {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../scenarios/arm-board.toml"
    );
    let touch = ("perception.senses".to_owned(), r#"["touch"]"#.to_owned());
    let options = LoadOptions {
        settings: vec![touch],
        ..LoadOptions::default()
    };
    let loaded = load_task(path.as_ref(), &options).expect("a task");
    let robot = loaded.robot().expect("a robot").expect("it names one");
    (loaded, robot)
}

/// A motion that can be executed.
pub fn motion() -> PlannedRound {
    let (loaded, robot) = loaded();
    let mut session = loaded.session().with_robot(robot.robot_setup());
    session
        .run_until(Stage::Audited, &mut NoExecutor, &mut ignore_events)
        .expect("a motion");
    session.planned_round().expect("a motion").clone()
}

/// Returns the order of a planned motion.
pub fn order(planned: &PlannedRound) -> MotionOrder<'_> {
    MotionOrder {
        round: 1,
        seed: 1,
        task: &planned.task,
        cell: &planned.cell,
        followed: &planned.followed,
    }
}

fn start(script: &str) -> Result<ProcessExecutor, ExecutorError> {
    ProcessExecutor::start("python3", &["-c".to_owned(), script.to_owned()])
}

/// Has a child execute a motion by these lines after the common ones. The receiver of samples stops
/// the motion after `most` of them.
fn executed(
    planned: &PlannedRound,
    lines: &str,
    most: usize,
) -> Result<(Execution, usize), ExecutorError> {
    // On a busy machine, a child may be slow. The limit of silence is short only for children that
    // sleep.
    let patience = if lines.contains("time.sleep") {
        700
    } else {
        20_000
    };
    let limit = Duration::from_millis(patience);
    let mut child = start(&format!("{CHILD}{lines}\n"))?.with_silence_limit(limit);
    let order = order(planned);
    let mut taken = 0;
    let execution = child.execute(&order, &mut |_| {
        taken += 1;
        if taken < most {
            ControlFlow::Continue(())
        } else {
            ControlFlow::Break(())
        }
    })?;
    Ok((execution, taken))
}

#[test]
fn the_documented_robot_wipes_until_touch_tells_no_more() {
    if !has_python() {
        return;
    }
    let (loaded, robot) = loaded();
    let mut child = ProcessExecutor::start("python3", &[ECHO_ROBOT.to_owned()]).expect("it greets");
    assert_eq!(child.observe(&loaded.task), Ok(None));
    let mut session = loaded.session().with_robot(robot.robot_setup());
    session
        .run(&mut child, &mut ignore_events)
        .expect("it ends");
    let last = session.rounds().last().expect("a round");
    // The executor has no camera.
    let gave_up = [Verdict::NoWay, Verdict::Undecidable, Verdict::UnsafeMotion];
    assert!(!gave_up.contains(&last.verdict), "{:?}", last.verdict);
    assert_eq!(last.execution.ending, Ending::Complete);
    assert!(last.interpretation.plane.is_some());
    // During the rest of the time near the surface, the tool is lowered or lifted.
    let felt = last.interpretation.contact_share.unwrap();
    assert!(
        felt > 0.75,
        "contact for {felt} of the time near the surface"
    );
}

#[test]
fn a_child_that_goes_wrong_ends_in_an_error_that_says_how() {
    if !has_python() {
        return;
    }
    let planned = motion();
    let dof = planned.cell.robot().dof();
    let joints = format!("positions has 1 numbers, but the robot has {dof} joints");
    let cases = [
        ("time.sleep(60)", "no message for 0.7 s"),
        (
            "print('hullo', flush=True)",
            "its line \"hullo\" is not JSON from column 1 on (expected value); expected one message per line, such as",
        ),
        (
            "say(hullo=1)",
            "its line \"{\"hullo\": 1}\" is not a message of the protocol: unknown variant `hullo`",
        ),
        (
            "say(ready={'version': 1})",
            "expected a sample, found \"ready\"",
        ),
        ("say(sample={'time_s': 0})", "missing field"),
        ("sample(float('nan'))", "NaN"),
        (
            "print('{\"sample\": {\"time_s\": 1e999}}', flush=True)",
            "1e999",
        ),
        (
            "sample(0.1); sample(0.1)",
            "the sample at 0.1 s follows the sample at 0.1 s",
        ),
        (
            "sample(0.2); sample(0.1)",
            "the sample at 0.1 s follows the sample at 0.2 s",
        ),
        ("sample(0, positions=[1])", joints.as_str()),
        (
            "sample(0, world_from_tool=[0] * 7)",
            "a quaternion has norm 0",
        ),
        (
            "sample(0); sys.exit(3)",
            "it ended while wisch waited for a message (exit status: 3)",
        ),
        (
            "print('x' * (1 << 20) + 'y', flush=True)",
            "it sent a line above the limit of 1048576 bytes",
        ),
        (
            "sys.stdout.buffer.write(bytes([255, 10])); sys.stdout.flush()",
            "not UTF-8",
        ),
        ("say(error='the arm is locked')", "the arm is locked"),
        ("say(error='hot \\x1b[31m\\nred')", "hot \\u{1b}[31m\\nred"),
        (
            "print('\\x1b]0;title\\x07', flush=True)",
            "its line \"\\u{1b}]0;title\\u{7}\" is not JSON",
        ),
        (
            "sample(0, force_n=[1e308, 0, 0])",
            "at 0 s force_n[0] is 1e308, beyond the limit of 1e6",
        ),
        (
            "sample(0, world_from_tool=[1e300, 0, 0, 0, 0, 0, 1])",
            "world_from_tool[0] is 1e300, beyond the limit of 1e5",
        ),
        (
            "sample(0, trajectory_time_s=2); sample(1, trajectory_time_s=1)",
            "at 1 s: trajectory time 1 s is earlier than the last reported time, 2 s",
        ),
        (
            "sample(-5)",
            "the sample at -5 s is before the start of the motion at 0 s",
        ),
        (
            "sample(0); done('stopped', duration=-5)",
            "at the end duration_s is -5e0 s; expected 0 to",
        ),
        (
            "follow(); done('complete', duration=1e300)",
            "at the end duration_s is 1e300 s; expected 0 to",
        ),
        (
            "sample(0); done({'protective_stop': {'time_s': -1e308, 'reason': 'x'}})",
            "protective_stop.time_s is -1e308 s; expected 0 to",
        ),
        (
            "k = 0\nwhile True:\n    k += 1\n    sample(k * 1e-5)",
            "exceed the limit of 10000 samples per second",
        ),
        (
            "sample(0); sample(1e-12)",
            "follows the sample at 0 s by less than 1e-6 s",
        ),
        (
            "k = time.sleep(0) or 0\nwhile True:\n    k += 1\n    sample(k * 1e-3)",
            "no progress for 0.7 s, at 0.0 s of a motion of",
        ),
        (
            "k = time.sleep(0) or points[-1]['time_s']\nfollow()\npoints = points[-1:]\nwhile True:\n    k += 1e-3\n    sample(k)",
            "it still sends samples 0.7 s after the end of its motion without \"done\"",
        ),
        ("done('exploded')", "unknown variant `exploded`"),
        (
            "sample(0); sample(4.5); done('stopped', duration=1)",
            "at the end duration_s is 1 s, but the last sample is at 4.5 s; expected a duration that includes all samples",
        ),
        (
            "sample(3000)",
            "the first sample is at 3000 s, without pauses more than 60 s after the start of the motion; time_s counts from the start",
        ),
        (
            "sample(61, trajectory_time_s=0)",
            "without pauses more than 60 s after the start of the motion",
        ),
        (
            "sample(1764000000)",
            "time_s = 1764000000 of a sample is beyond the limit of 10000000 s; time_s counts from the start",
        ),
        (
            "sample(0); done('complete')",
            "is reported complete, but the last sample is at 0 s",
        ),
        (
            "done('complete')",
            "is reported complete, but there is no sample",
        ),
    ];
    for (lines, expected) in cases {
        let begin = Instant::now();
        let error = executed(&planned, lines, usize::MAX).expect_err(lines);
        let error = error.to_string();
        assert!(
            error.starts_with("executor \"python3\": "),
            "{lines}: {error}"
        );
        assert!(error.contains(expected), "{lines}: {error}");
        assert!(begin.elapsed() < Duration::from_secs(30), "{lines}");
    }
}

#[test]
fn a_child_that_does_not_greet_is_refused() {
    if !has_python() {
        return;
    }
    for (script, expected) in [
        (
            "print('{\"ready\": {\"version\": 7}}')",
            "it uses protocol version 7; expected 1",
        ),
        ("pass", "it ended while wisch waited for a message"),
        ("print('null')", "null"),
        (
            "print('{\"observation\": null}')",
            "expected \"ready\", found \"observation\"",
        ),
    ] {
        let error = start(script).expect_err(script).to_string();
        assert!(error.contains(expected), "{script}: {error}");
    }
    let error = ProcessExecutor::start("no-such-robot", &[]).expect_err("there is none");
    let error = error.to_string();
    assert!(error.starts_with("executor \"no-such-robot\": "), "{error}");
}

#[test]
fn a_child_is_stopped_after_enough_samples() {
    if !has_python() {
        return;
    }
    let planned = motion();
    let endless = "\nk = 0\nwhile not select.select([sys.stdin], [], [], 0.001)[0]:\n    k += 1\n    sample(k * 1e-3)\nheard = hear()\ndone('stopped' if heard == 'stop' else 'complete')";
    let (execution, taken) = executed(&planned, endless, 5).expect("it stops");
    assert_eq!((execution.ending, taken), (Ending::Stopped, 5));

    let deaf = "\nk = 0\nwhile True:\n    k += 1\n    sample(k * 1e-3)\n    time.sleep(0.001)";
    let error = executed(&planned, deaf, 5)
        .expect_err("it goes on")
        .to_string();
    assert!(
        error.contains("it still sends samples 0.7 s after \"stop\""),
        "{error}"
    );
}

#[test]
fn how_a_child_ended_is_taken_over() {
    if !has_python() {
        return;
    }
    let planned = motion();
    let lines = "sample(0); sample(0.5)\ndone({'protective_stop': {'time_s': 0.5, 'reason': 'a hand is in the way'}})";
    let (execution, taken) = executed(&planned, lines, usize::MAX).expect("it ends");
    assert_eq!(taken, 2);
    let Ending::ProtectiveStop { time, cause } = execution.ending else {
        panic!("{:?}", execution.ending);
    };
    assert_eq!(
        (time, cause.to_string().as_str()),
        (0.5, "a hand is in the way")
    );

    // A stop without a request is a stop by the robot.
    let lines = "sample(0); sample(0.5)\ndone('stopped', duration=0.5)";
    let (execution, _) = executed(&planned, lines, usize::MAX).expect("it ends");
    let Ending::ProtectiveStop { time, cause } = execution.ending else {
        panic!("{:?}", execution.ending);
    };
    assert_eq!((time, cause.kind()), (0.5, StopKind::ProtectiveStop));
    assert!(cause.to_string().contains("without a request"), "{cause}");

    let (loaded, robot) = loaded();
    let script = format!("{CHILD}sample(0)\ndone('stopped', [1, 2])\n");
    let mut session = loaded.session().with_robot(robot.robot_setup());
    let error = session.run(&mut start(&script).expect("it greets"), &mut ignore_events);
    let is_refused = matches!(error, Err(RunError::Positions { found: 2, .. }));
    assert!(is_refused, "{error:?}");
}

#[test]
fn an_interruption_between_motions_is_no_fault_of_the_child() {
    if !has_python() {
        return;
    }
    let ready = r#"print('{"ready": {"version": 1, "reports_state": true}}', flush=True)"#;
    for (then, is_interruption) in [("time.sleep(600)", true), ("sys.exit(1)", false)] {
        let hear = "sys.stdin.readline()";
        let script = format!("import sys, time\n{hear}\n{ready}\n{hear}\n{then}\n");
        let options = ProcessOptions::default();
        let stop = Arc::clone(&options.stop);
        let arguments = ["-c".to_owned(), script];
        let mut child =
            ProcessExecutor::start_with("python3", &arguments, options).expect("it greets");
        stop.store(is_interruption, Ordering::SeqCst);
        let error = child.state().expect_err("it does not answer");
        assert_eq!(error.is_interruption(), is_interruption, "{error}");
    }
}

#[test]
fn samples_before_the_fault_of_a_child_are_kept() {
    if !has_python() {
        return;
    }
    let (loaded, robot) = loaded();
    let lines = "for point in points[:200]:\n    sample(point['time_s'], world_from_tool=point['world_from_tool'], positions=point['positions'])\nsay(error='the arm is locked')\n";
    let mut child = start(&format!("{CHILD}{lines}")).expect("it greets");
    let mut session = loaded.session().with_robot(robot.robot_setup());
    let error = session.run(&mut child, &mut ignore_events);
    assert!(matches!(error, Err(RunError::Execute(_))), "{error:?}");
    let [round] = session.rounds() else {
        panic!("{} rounds", session.rounds().len());
    };
    assert_eq!(round.execution.ending, Ending::Stopped);
    assert!((round.execution.duration - 1.99).abs() < 1e-9);
    let again = session.step(&mut child, &mut ignore_events);
    assert_eq!(again, Ok(Stage::Ended));

    // A child that fails at once has sent no sample.
    let mut child = start(&format!("{CHILD}say(error='no power')\n")).expect("it greets");
    let mut session = loaded.session().with_robot(robot.robot_setup());
    assert!(session.run(&mut child, &mut ignore_events).is_err());
    assert!(session.rounds().is_empty());
}

#[test]
fn what_a_child_sees_is_limited_and_said() {
    if !has_python() {
        return;
    }
    let (loaded, _) = loaded();
    let looking = |seen: &str| {
        let script = format!(
            "import json\ninput()\nprint('{{\"ready\": {{\"version\": 1}}}}', flush=True)\ninput()\nprint(json.dumps({{'observation': {seen}}}), flush=True)\ninput()"
        );
        start(&script).expect("it greets").observe(&loaded.task)
    };
    let seen = looking("{'detections': [[0.1, 0]], 'hidden': [[[0, 0], [1, 0], [0, 1]]]}");
    assert_eq!(seen.expect("a look").expect("it sees").detections.len(), 1);
    for (seen, expected) in [
        ("{'detections': [[1e300, 0]]}", "is more than 1000 m"),
        (
            "{'detections': [], 'hidden': [[[0, 0]]]}",
            "hidden[0] has 1 corners; expected 3 or more",
        ),
        (
            "{'detections': [], 'hidden': [[[k, k * k % 7] for k in range(999)]] * 2}",
            "1998 corners of hidden polygons exceed the limit of 1000",
        ),
        ("{'detections': [[0]]}", "invalid length 1"),
        (
            "{'detections': [[0, 0, 0]]}",
            "is not a message of the protocol: trailing characters at column",
        ),
    ] {
        let error = looking(seen).expect_err(seen).to_string();
        assert!(error.contains(expected), "{seen}: {error}");
    }
}

#[test]
fn phases_follow_the_trajectory_at_any_speed() {
    if !has_python() {
        return;
    }
    let planned = motion();
    let order = order(&planned);
    for speed in [1.0, 0.5, 0.2] {
        let script = format!(
            "{CHILD}follow({speed})\ndone('complete', duration=points[-1]['time_s'] / {speed})\n"
        );
        let mut child = start(&script).expect("it greets");
        let (mut wrong, mut count) = (0, 0);
        let execution = child.execute(&order, &mut |sample| {
            let meant = order.motion_at(sample.time * speed).expect("it moves");
            wrong += usize::from(meant != (sample.motion, sample.phase));
            count += 1;
            ControlFlow::Continue(())
        });
        let execution = execution.expect("it ends");
        assert_eq!(execution.ending, Ending::Complete);
        assert!(
            count > 100 && wrong * 100 <= count,
            "{speed}: {wrong} of {count}"
        );
    }
}

#[test]
fn positions_need_not_be_measured_and_a_state_may_be_asked_for() {
    if !has_python() {
        return;
    }
    let planned = motion();
    let lines = "follow_ = [sample(p['time_s'], world_from_tool=p['world_from_tool'], positions=[]) for p in points]\ndone('complete', positions=[], duration=points[-1]['time_s'])";
    let (execution, _) = executed(&planned, lines, usize::MAX).expect("it ends");
    let end = planned.followed.sample(planned.followed.duration());
    assert_eq!(execution.positions, end.expect("a motion").q);
    let (execution, _) = executed(
        &planned,
        "sample(0, positions=[])\ndone('stopped', positions=[])",
        usize::MAX,
    )
    .expect("it ends");
    assert_eq!(execution.positions, Vec::<f64>::new());

    let script = r#"
import json
for line in open(0):
    message = json.loads(line)
    answer = {"state": {"positions": [1, 2]}} if message == "state" else {"ready": {"version": 1, "reports_state": True}}
    print(json.dumps(answer), flush=True)
"#;
    assert_eq!(
        start(script).expect("it greets").state(),
        Ok(Some(vec![1.0, 2.0].into()))
    );
    // Velocities are kept without positions, so that they are checked.
    let moving = script.replace("[1, 2]}", "[], \"velocities\": [0.5]}");
    let state = start(&moving).expect("it greets").state().expect("a state");
    let state = state.expect("velocities");
    assert_eq!((state.positions, state.velocities), (vec![], vec![0.5]));
}

/// Has a child of protocol version 2 execute a motion. `ready`: what it adds to its greeting.
fn executed_by_version_2(
    planned: &PlannedRound,
    ready: &str,
    lines: &str,
) -> Result<(Execution, Vec<RecordedSample>), ExecutorError> {
    let greeting = format!("say(ready={{\"version\": 2, {ready}}})");
    let begin = CHILD.replace("say(ready={\"version\": 1})", &greeting);
    let mut child = start(&format!("{begin}{lines}\n"))?;
    let order = order(planned);
    let mut samples = Vec::new();
    let execution = child.execute(&order, &mut |sample| {
        samples.push(RecordedSample::from(sample));
        ControlFlow::Continue(())
    })?;
    Ok((execution, samples))
}

#[test]
fn knots_describe_a_motion_in_few_points() {
    if !has_python() {
        return;
    }
    let planned = motion();
    // The child interpolates as joint_trajectory_controller does, every 2 ms.
    let lines = r#"
def quintic(p, v, a, q, w, b, s):
    d = q - p
    return (p + s * (v + s * (0.5 * a + s * (10 * d - 6 * v - 4 * w - 1.5 * a + 0.5 * b
        + s * (-15 * d + 8 * v + 7 * w + 1.5 * a - b + s * (6 * d - 3 * v - 3 * w - 0.5 * a + 0.5 * b))))))
# The size of a message trajectory_msgs/JointTrajectory: three sequences of numbers, an empty one, and the time.
size = sum(24 * len(point["positions"]) + 24 for point in points)
if size > 100_000:
    say(error=f"{len(points)} points of {size} bytes are more than 100 kB")
k, time = 0, 0.0
while time < motion["duration_s"]:
    while points[k + 1]["time_s"] < time:
        k += 1
    a, b = points[k], points[k + 1]
    T = b["time_s"] - a["time_s"]
    s = (time - a["time_s"]) / T
    joints = zip(a["positions"], a["velocities"], a["accelerations"], b["positions"], b["velocities"], b["accelerations"])
    place = [quintic(p, v * T, u * T * T, q, w * T, x * T * T, s) for p, v, u, q, w, x in joints]
    say(sample={"time_s": time, "force_n": [0, 0, 0], "positions": place})
    time += 0.002
done("complete", duration=motion["duration_s"])
"#;
    let (_, samples) =
        executed_by_version_2(&planned, "\"knot_error_rad\": 1e-4", lines).expect("it ends");
    assert!(samples.len() as f64 > 400.0 * planned.followed.duration());
    for sample in &samples {
        let exact = planned.followed.sample(sample.time).expect("a motion").q;
        let off = exact.iter().zip(&sample.joints).map(|(a, b)| (a - b).abs());
        let off = off.fold(0.0, f64::max);
        assert!(off < 1.1e-4, "{off} rad at {} s", sample.time);
    }
}

#[test]
fn a_driver_needs_no_kinematics() {
    if !has_python() {
        return;
    }
    let planned = motion();
    let lines = r#"
sample_ = lambda k, axes: say(sample={"time_s": k * 0.01, "positions": points[100]["positions"], "force_n": [1, 2, 3], "moment_nm": [0, 0, 1], "wrench_axes": axes})
sample_(0, "world"); sample_(1, "tool"); sample_(2, "tip")
done("stopped")
"#;
    let (_, samples) =
        executed_by_version_2(&planned, "\"reports_state\": True", lines).expect("it ends");
    let cell = &planned.cell;
    let q = planned.followed.sample(1.0).expect("a motion").q;
    let tip = cell.robot().forward_kinematics(&q).expect("positions");
    let world_from_tip = cell.world_from_root() * tip.world_from_link(cell.tip());
    let world_from_tool = world_from_tip * cell.tip_from_tool();
    let force = nalgebra::Vector3::new(1.0, 2.0, 3.0);
    let expected = [
        force,
        world_from_tool.rotation * force,
        world_from_tip.rotation * force,
    ];
    for (sample, force) in samples.iter().zip(expected) {
        let off = sample.world_from_tool.inverse() * world_from_tool;
        assert!(off.translation.vector.norm() + off.rotation.angle() < 1e-6);
        assert!((sample.external.force - force).norm() < 1e-6, "{force}");
    }
    assert_eq!(samples.len(), 3);

    let error = executed_by_version_2(
        &planned,
        "",
        "say(sample={\"time_s\": 0, \"force_n\": [0, 0, 0], \"positions\": []})",
    );
    let error = error.expect_err("no pose").to_string();
    assert!(
        error.contains("neither world_from_tool nor positions"),
        "{error}"
    );
}

#[test]
fn a_silent_child_gets_a_stop_before_its_executor_ends() {
    if !has_python() {
        return;
    }
    let planned = motion();
    let folder = tempfile::tempdir().expect("a temporary folder");
    let heard = folder.path().join("heard.json");
    let greeting = "say(ready={\"version\": 2, \"max_silence_s\": 0.3})";
    let begin = CHILD.replace("say(ready={\"version\": 1})", greeting);
    let rest = format!(
        "sample(0); sample(0.01)\nmessage = hear()\nopen({0:?}, 'w').write(message)\nhear()\n",
        heard.display().to_string()
    );
    let mut child = start(&format!("{begin}{rest}")).expect("it greets");
    let order = order(&planned);
    let error = child.execute(&order, &mut |_| ControlFlow::Continue(()));
    let error = error.expect_err("it is silent").to_string();
    assert!(error.contains("no message for 0.3 s"), "{error}");
    // The executor is not dropped yet, as during the interpretation of its data.
    let begun = Instant::now();
    let message = loop {
        match std::fs::read_to_string(&heard) {
            Ok(message) if !message.is_empty() => break message,
            _ if begun.elapsed() > Duration::from_secs(20) => panic!("it got no message"),
            _ => std::thread::sleep(Duration::from_millis(10)),
        }
    };
    assert_eq!(message, "stop");
    drop(child);
}

#[test]
fn a_greeting_that_is_out_of_range_is_refused() {
    if !has_python() {
        return;
    }
    for (ready, expected) in [
        (
            r#""version": 3"#,
            "it uses protocol version 3; expected 1 or 2",
        ),
        (
            r#""version": 2, "max_silence_s": 0"#,
            "ready: max_silence_s is 0; expected 0.02 to 60",
        ),
        (
            r#""version": 1, "accepts_curved": True"#,
            "ready: accepts_curved needs version 2",
        ),
        (
            r#""version": 1, "knot_error_rad": 0.001"#,
            "ready: knot_error_rad needs version 2",
        ),
    ] {
        let script = format!(
            "import json\ninput()\nprint(json.dumps({{\"ready\": {{{ready}}}}}), flush=True)"
        );
        let error = start(&script).expect_err("it is refused").to_string();
        assert!(error.contains(expected), "{error}");
    }
}

#[test]
fn a_curved_surface_is_given_to_children_that_accept_it() {
    if !has_python() {
        return;
    }
    let mut planned = motion();
    let lines = r#"
if motion.get("surface_shape") != {"kind": "cylinder", "radius_m": -2.0, "axis_rad": 0.5}:
    say(error="another shape: %s" % motion.get("surface_shape"))
follow()
done("complete", duration=motion["duration_s"])
"#;
    planned.task.surface.shape = SurfaceShape::Cylinder {
        radius: -2.0,
        axis: 0.5,
    };
    executed_by_version_2(&planned, "\"accepts_curved\": True", lines).expect("it ends");
    let refused = executed_by_version_2(&planned, "\"reports_state\": False", lines);
    let error = refused.expect_err("it is refused").to_string();
    assert!(error.contains("states accepts_curved"), "{error}");
}

/// On a mesh, the axis of the tool is the normal along which a child presses.
#[test]
fn a_mesh_is_given_to_children_that_accept_curved_surfaces() {
    if !has_python() {
        return;
    }
    let mut planned = motion();
    let lines = r#"
shape = motion.get("surface_shape")
if shape["kind"] != "mesh" or len(shape["digest"]) != 32:
    say(error="another shape: %s" % shape)
follow()
done("complete", duration=motion["duration_s"])
"#;
    let corners = [[-0.2, -0.15], [0.2, -0.15], [0.2, 0.15], [-0.2, 0.15]];
    let corners = corners.map(|[x, y]| Point3::new(x, y, 0.0));
    let mesh = Mesh::new(corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]]).unwrap();
    let (shape, _) = MeshShape::from_mesh(&mesh, &SheetConfig::default()).unwrap();
    planned.task.surface.shape = SurfaceShape::Mesh(Arc::new(shape));
    executed_by_version_2(&planned, "\"accepts_curved\": True", lines).expect("it ends");
    let refused = |planned: &_, ready| {
        let refused = executed_by_version_2(planned, ready, lines);
        refused.expect_err("it is refused").to_string()
    };
    let error = refused(&planned, "\"reports_state\": False");
    assert!(error.contains("states accepts_curved"), "{error}");
    planned.task.tool.tilt = Some(TiltFreedom {
        axis_in_tool: Vector3::y_axis(),
        range: AngleRange {
            min_rad: -0.1,
            max_rad: 0.1,
        },
    });
    let error = refused(&planned, "\"accepts_curved\": True");
    assert!(error.contains("choose a tool without tilt"), "{error}");
}

#[test]
fn every_kind_of_stop_is_taken_over() {
    if !has_python() {
        return;
    }
    let planned = motion();
    for kind in StopKind::ALL {
        let lines = format!(
            "sample(0)\ndone({{'stop': {{'kind': '{}', 'time_s': 0.5, 'reason': 'why'}}}})",
            kind.as_str()
        );
        let (execution, _) = executed_by_version_2(&planned, "", &lines).expect("it ends");
        let Ending::ProtectiveStop { cause, .. } = execution.ending else {
            panic!("{:?}", execution.ending);
        };
        assert_eq!(cause.kind(), kind);
        assert!(cause.to_string().ends_with("why"), "{cause}");
    }
    let lines = "sample(0)\ndone({'stop': {'kind': 'estop', 'time_s': 0.5, 'reason': 'why'}})";
    let error = executed_by_version_2(&planned, "", lines).expect_err("an unknown kind");
    assert!(
        error
            .to_string()
            .contains("unknown kind of a stop \"estop\""),
        "{error}"
    );
}

#[cfg(target_os = "linux")]
#[test]
fn all_that_a_child_started_ends_with_it() {
    if !has_python() {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let note = folder.path().join("pid");
    let script = format!(
        "import json, signal, subprocess, sys\nignore = lambda: signal.signal(signal.SIGTERM, signal.SIG_IGN)\nchild = subprocess.Popen(['sleep', '600'], preexec_fn=ignore)\nopen({note:?}, 'w').write(str(child.pid))\ninput()\nprint('{{\"ready\": {{\"version\": 1}}}}', flush=True)\ninput()"
    );
    let is_running = |pid: &str| {
        let state = std::fs::read_to_string(format!("/proc/{pid}/stat")).unwrap_or_default();
        let after = state.rsplit(')').next().unwrap_or_default();
        // A process that has ended but was not waited for yet (a zombie) counts as ended.
        !after.is_empty() && !after.trim_start().starts_with('Z')
    };
    let child = start(&script).expect("it greets");
    let pid = std::fs::read_to_string(&note).expect("a number");
    assert!(is_running(&pid));
    drop(child);
    let since = Instant::now();
    while is_running(&pid) {
        assert!(since.elapsed() < Duration::from_secs(5), "{pid} goes on");
        std::thread::sleep(Duration::from_millis(10));
    }
}
