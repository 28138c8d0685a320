//! The program with a real S3 server; it is also killed at many moments.

use crate::memories::{contents, memory, some};
use crate::s3_server::{KEY_ID, SECRET, Server};
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};
use wisch_memory::Memory;

const FLEET: &str = "s3://fleet/robots";

fn run(command: &mut Command) -> Output {
    command.stdin(Stdio::null()).output().unwrap()
}

fn stdout(output: &Output) -> String {
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{}: {errors}", output.status);
    String::from_utf8_lossy(&output.stdout).into_owned()
}

#[test]
fn a_push_killed_at_any_moment_leaves_whole_episodes_once() {
    let folder = tempfile::tempdir().unwrap();
    let server = Server::start(&folder.path().join("s3"));
    let records = some(600);
    let here = memory(&folder.path().join("here"), &records);
    let push = || {
        let mut command = server.program(SECRET);
        command
            .arg("push")
            .arg(here.folder())
            .args([FLEET, "--json"]);
        command
    };
    let verify = || {
        stdout(&run(server
            .program(SECRET)
            .args(["verify", FLEET, "--json"])))
    };
    let mut killed = 0;
    // The golden ratio spreads the moments evenly over the duration of a push.
    for moment in 0..20_u32 {
        let wait = 0.05 + 1.2 * (f64::from(moment) * 0.618_034).fract();
        let mut child = push()
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        let begun = Instant::now();
        while begun.elapsed() < Duration::from_secs_f64(wait) && child.try_wait().unwrap().is_none()
        {
            std::thread::sleep(Duration::from_millis(5));
        }
        // A push that has ended already does not count as killed.
        killed += u32::from(child.try_wait().unwrap().is_none());
        let _ = child.kill();
        child.wait().unwrap();
        assert!(verify().contains("\"faults\":[]"), "after kill {moment}");
    }
    assert!(killed > 0, "every push ended before it was killed");
    stdout(&run(&mut push()));
    let found = verify();
    assert!(
        found.contains("\"episodes\":600") && found.contains("\"faults\":[]"),
        "{found}"
    );
    let mut pull = server.program(SECRET);
    pull.arg("pull").arg(FLEET).arg(folder.path().join("there"));
    stdout(&run(&mut pull));
    let there = Memory::open(&folder.path().join("there")).unwrap();
    assert_eq!(contents(&here), contents(&there));
    let rounds: usize = records.iter().map(|record| record.rounds.len()).sum();
    let mut sql = server.program(SECRET);
    sql.args([
        "sql",
        "SELECT count(*) AS n FROM rounds",
        "--fleet",
        FLEET,
        "--csv",
    ]);
    assert_eq!(stdout(&run(&mut sql)), format!("n\n{rounds}\n"));
}

#[test]
fn simultaneous_programs_push_each_episode_once() {
    let folder = tempfile::tempdir().unwrap();
    let server = Server::start(&folder.path().join("s3"));
    let records = some(120);
    let one = memory(&folder.path().join("one"), &records[..80]);
    let other = memory(&folder.path().join("other"), &records[40..]);
    let children: Vec<_> = [&one, &other]
        .map(|memory| {
            let mut command = server.program(SECRET);
            command.arg("push").arg(memory.folder()).arg(FLEET);
            command.stdout(Stdio::null()).spawn().unwrap()
        })
        .into();
    for mut child in children {
        assert!(child.wait().unwrap().success());
    }
    let found = stdout(&run(server
        .program(SECRET)
        .args(["verify", FLEET, "--json"])));
    assert!(
        found.contains("\"episodes\":120") && found.contains("\"faults\":[]"),
        "{found}"
    );
}

#[test]
fn wrong_credentials_are_an_error_that_does_not_show_them() {
    let folder = tempfile::tempdir().unwrap();
    let server = Server::start(&folder.path().join("s3"));
    let output = run(server.program("another-secret").args(["verify", FLEET]));
    assert_eq!(output.status.code(), Some(2));
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(
        message.contains("s3://fleet/robots") && message.contains("AWS_SECRET_ACCESS_KEY"),
        "{message}"
    );
    assert!(
        !message.contains(KEY_ID) && !message.contains("another-secret"),
        "{message}"
    );
}

#[test]
fn a_full_disk_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    let here = Memory::create(&folder.path().join("here")).unwrap();
    let record = some(1).remove(0);
    let writer = here.begin(&record.id).unwrap();
    // 64 KiB of pseudorandom bytes, which compression does not shorten.
    let mut state = 1_u64;
    let noise: Vec<u8> = (0..65_536)
        .map(|_| {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            (state >> 56) as u8
        })
        .collect();
    writer.attach("noise.bin", &noise).unwrap();
    writer.commit(&record).unwrap();
    let fleet = folder.path().join("fleet");
    // No file may grow beyond 16 KiB. The program sees the same kind of error as on a full disk.
    let output = Command::new("sh")
        .arg("-c")
        .arg("trap '' XFSZ; ulimit -f 32; exec \"$@\"")
        .arg("sh")
        .arg(env!("CARGO_BIN_EXE_wisch-fleet"))
        .arg("push")
        .args([here.folder(), &fleet])
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(2));
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(
        message.contains(&record.id) && message.contains("File too large"),
        "{message}"
    );
    let output = run(Command::new(env!("CARGO_BIN_EXE_wisch-fleet"))
        .arg("verify")
        .arg(&fleet));
    assert!(stdout(&output).contains("0 episodes: no faults"));
}

#[test]
fn answers_have_the_requested_form() {
    let folder = tempfile::tempdir().unwrap();
    let here = memory(&folder.path().join("here"), &some(5));
    let ask = |more: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_wisch-fleet"));
        command.args(["sql", "SELECT count(*) AS n FROM episodes", "--memory"]);
        run(command.arg(here.folder()).args(more))
    };
    assert_eq!(stdout(&ask(&["--csv"])), "n\n5\n");
    assert_eq!(stdout(&ask(&["--json"])), "{\"n\":5}\n");
    assert!(stdout(&ask(&[])).contains("1 row"));
    let file = folder.path().join("n.parquet");
    stdout(&ask(&["--parquet", file.to_str().unwrap()]));
    assert!(std::fs::read(file).unwrap().starts_with(b"PAR1"));
    let wrong = run(Command::new(env!("CARGO_BIN_EXE_wisch-fleet")).args(["sql", "SELECT 1"]));
    assert_eq!(wrong.status.code(), Some(2));
}

#[test]
fn a_statement_beyond_a_limit_is_an_error_with_the_limit() {
    let folder = tempfile::tempdir().unwrap();
    let here = memory(&folder.path().join("here"), &some(5));
    let deep = format!("SELECT 1{}", "+1".repeat(50_000));
    let endless = "SELECT count(*) FROM generate_series(1, 1000000000) a CROSS JOIN generate_series(1, 1000000) b";
    let rows = [
        (deep.as_str(), &[][..], "at most 1000"),
        (endless, &["--timeout", "2"], "longer than the limit of 2 s"),
        ("SELECT * FROM generate_series(1, 100000000)", &[], "256 MB"),
        (
            "SELECT repeat('x', 1000000000)",
            &["--memory-limit", "256", "--csv"],
            "256 MB",
        ),
    ];
    for (statement, more, words) in rows {
        let mut command = Command::new(env!("CARGO_BIN_EXE_wisch-fleet"));
        command
            .args(["sql", statement, "--memory"])
            .arg(here.folder())
            .args(more);
        let output = run(&mut command);
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{words}: {message}");
        assert!(message.contains(words), "{words}: {message}");
    }
    // A statement below the limit of depth is answered.
    let chain = format!("SELECT 1{} AS n", "+1".repeat(900));
    let mut command = Command::new(env!("CARGO_BIN_EXE_wisch-fleet"));
    command
        .args(["sql", &chain, "--csv", "--memory"])
        .arg(here.folder());
    assert_eq!(stdout(&run(&mut command)), "n\n901\n");
}

#[test]
fn a_pull_that_leaves_an_episode_out_has_exit_code_1() {
    let folder = tempfile::tempdir().unwrap();
    let records = some(2);
    let here = memory(&folder.path().join("here"), &records);
    let fleet = folder.path().join("fleet");
    let program = || Command::new(env!("CARGO_BIN_EXE_wisch-fleet"));
    stdout(&run(program().arg("push").arg(here.folder()).arg(&fleet)));
    std::fs::write(
        fleet.join(format!("episodes/{}.tar.zst", records[0].id)),
        "no archive",
    )
    .unwrap();
    let there = folder.path().join("there");
    let output = run(program().arg("pull").arg(&fleet).arg(&there).arg("--json"));
    assert_eq!(output.status.code(), Some(1));
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(
        message.contains(&records[0].id) && message.contains("left out"),
        "{message}"
    );
    let message = String::from_utf8_lossy(&output.stdout);
    assert!(
        message.contains("\"selected\":2") && message.contains("\"episodes\":1"),
        "{message}"
    );
    // Times in the wrong order are refused before anything is written.
    let elsewhere = folder.path().join("elsewhere");
    let mut pull = program();
    pull.arg("pull").arg(&fleet).arg(&elsewhere);
    let output = run(pull.args(["--since", "2026-11-02", "--until", "2026-11-01"]));
    assert_eq!(output.status.code(), Some(2));
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(message.contains("--until is before --since"), "{message}");
    assert!(!elsewhere.exists());
    assert_eq!(
        Memory::open(&there).unwrap().episodes().unwrap(),
        [records[1].id.clone()]
    );
}

#[cfg(not(feature = "cluster"))]
#[test]
fn a_build_without_clusters_names_the_feature() {
    for args in [
        &[
            "sql",
            "SELECT 1",
            "--memory",
            "none",
            "--cluster",
            "df://h:1",
        ][..],
        &["scheduler"],
        &["executor", "--scheduler", "h:1"],
    ] {
        let output = run(Command::new(env!("CARGO_BIN_EXE_wisch-fleet")).args(args));
        assert_eq!(output.status.code(), Some(2), "{args:?}");
        let message = String::from_utf8_lossy(&output.stderr);
        assert!(message.contains("--features cluster"), "{message}");
    }
}
