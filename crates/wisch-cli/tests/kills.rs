//! Random kills of `wisch run` and `wisch ask`: any signal, at any moment.
//!
//! ```sh
//! WISCH_KILLS=1000 cargo test --workspace --test main kills:: -- --ignored --nocapture
//! ```

use crate::program::{folder_with, path as program};
use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rustix::process::{Pid, Signal, kill_process};
use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};
use wisch_memory::Memory;
use wisch_memory::ask::EngineCommand;

/// How many kills, if `WISCH_KILLS` does not say so.
const KILLS: usize = 20;
/// How long a process may outlive the program that began it.
const AFTERLIFE: Duration = Duration::from_secs(2);
/// How long a program runs at most before it is killed: a run of one round takes longer [s].
const LONGEST: f64 = 6.0;
/// What a run ends with that is interrupted.
const INTERRUPTED: i32 = 130;
/// How often a killed run is resumed to its end.
const RESUMED: f64 = 0.1;
/// Set for all processes of one kill, which inherit it.
pub const MARK: &str = "WISCH_KILL";

/// All that end a program which does nothing about them, but for SIGPIPE, which it ignores.
const SIGNALS: [Signal; 9] = [
    Signal::KILL,
    Signal::TERM,
    Signal::HUP,
    Signal::INT,
    Signal::QUIT,
    Signal::ABORT,
    Signal::SEGV,
    Signal::ALARM,
    Signal::USR1,
];
const QUERIES: [&str; 5] = [
    "forall(between(1, 1000000000000, X), X > 0)",
    "length(L, 100000000), msort(L, M)",
    "has_type(C, 'Stroke'), telemetry(force, C, max, F)",
    "has_type(S, 'Stroke'), tell(holds(S, semco:recordLog, seen)), fail ; repeat, fail",
    "has_type(S, 'Stroke'), tell(holds(S, semco:recordLog, told))",
];

/// The processes of a kill that are still there, by number and command line.
pub fn alive(mark: &str) -> Vec<String> {
    let mark = format!("{MARK}={mark}\0");
    let processes = fs::read_dir("/proc").expect("processes");
    let marked = processes.filter_map(|entry| {
        let folder = entry.ok()?.path();
        let environment = fs::read(folder.join("environ")).ok()?;
        let is_marked = (environment.windows(mark.len())).any(|part| part == mark.as_bytes());
        is_marked.then(|| {
            let words = fs::read(folder.join("cmdline")).unwrap_or_default();
            format!(
                "{}: {}",
                folder.display(),
                String::from_utf8_lossy(&words).replace('\0', " ")
            )
        })
    });
    marked.collect()
}

fn begin(folder: &Path, mark: &str, args: &[&str]) -> Child {
    Command::new(program())
        .current_dir(folder)
        .env(MARK, mark)
        .args(args)
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("it begins")
}

/// How the random kills went.
#[derive(Debug, Default)]
struct Tally {
    asked: usize,
    ran: usize,
    ended_before: usize,
    resumed: usize,
    episodes: usize,
    longest_afterlife_ms: u128,
}

#[test]
#[ignore = "slow: many cases; `just slow`; WISCH_KILLS says how many"]
fn no_kill_leaves_a_process_or_takes_an_episode() {
    let kills = std::env::var("WISCH_KILLS").ok();
    let kills: usize = kills.map_or(KILLS, |kills| kills.parse().expect("a number of kills"));
    let seed = std::env::var("WISCH_SEED").ok();
    let mut random =
        ChaCha8Rng::seed_from_u64(seed.map_or(1, |seed| seed.parse().expect("a seed")));
    let folder = folder_with("arm-board.toml");
    let folder = folder.path();
    let engines: &[&str] = match EngineCommand::find_swi() {
        Some(_) => &["scryer", "swi"],
        None => &["scryer"],
    };
    let run = [
        "run",
        "task.toml",
        "--rounds",
        "1",
        "--out",
        "out",
        "--quiet",
    ];
    // One that is finished before anything is killed.
    assert!(begin(folder, "none", &run).wait().unwrap().code().is_some());
    let memory = Memory::open(&folder.join("episodes")).unwrap();
    let mut finished = memory.episodes().unwrap();
    let mut tally = Tally::default();
    for kill in 0..kills {
        let mark = format!("{}-{kill}", std::process::id());
        let is_run = random.random_bool(0.5);
        let signal = *SIGNALS.choose(&mut random).unwrap();
        let mut begun = if is_run {
            begin(folder, &mark, &run)
        } else {
            let engine = engines.choose(&mut random).unwrap();
            let query = QUERIES.choose(&mut random).unwrap();
            begin(folder, &mark, &["ask", "--engine", engine, query])
        };
        // Often early, where more begins than later.
        let moment = random.random::<f64>().powi(3) * LONGEST;
        std::thread::sleep(Duration::from_secs_f64(moment));
        let _ = kill_process(Pid::from_child(&begun), signal);
        // A run that Ctrl-C ends says how to go on with it, and ends by itself.
        let is_killed = matches!(begun.wait().unwrap().code(), None | Some(INTERRUPTED));
        let since = Instant::now();
        loop {
            let left = alive(&mark);
            let afterlife = since.elapsed();
            assert!(
                left.is_empty() || afterlife < AFTERLIFE,
                "kill {kill}, {signal:?}: {left:?}"
            );
            if left.is_empty() {
                tally.longest_afterlife_ms = tally.longest_afterlife_ms.max(afterlife.as_millis());
                break;
            }
            std::thread::sleep(Duration::from_millis(20));
        }
        *if is_run {
            &mut tally.ran
        } else {
            &mut tally.asked
        } += 1;
        tally.ended_before += usize::from(!is_killed);
        let now = memory.episodes().unwrap();
        let lost: Vec<_> = finished.iter().filter(|id| !now.contains(id)).collect();
        assert!(
            lost.is_empty(),
            "kill {kill}, {signal:?}: {lost:?} are gone"
        );
        finished = now;
        let faults = memory.verify().unwrap();
        assert!(faults.is_empty(), "kill {kill}, {signal:?}: {faults:?}");
        if is_run && is_killed && random.random_bool(RESUMED) {
            let resume = [&run[..], &["--resume"]].concat();
            let ended = begin(folder, &mark, &resume).wait().unwrap();
            assert!(
                ended.code().is_some_and(|code| code <= 1),
                "kill {kill}: --resume: {ended}"
            );
            tally.resumed += 1;
            finished = memory.episodes().unwrap();
        }
    }
    tally.episodes = finished.len();
    println!("{kills} kills: {tally:?}");
    let answered = Command::new(program())
        .current_dir(folder)
        .args(["ask", "has_type(S, 'Stroke')", "--quiet"])
        .status();
    assert_eq!(answered.unwrap().code(), Some(0));
    let (code, out, err) = crate::program::wisch(folder, &["memory", "verify"]);
    assert_eq!(code, 0, "{out}{err}");
}
