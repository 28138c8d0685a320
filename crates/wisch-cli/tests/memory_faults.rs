//! Faults of the place: clocks that are wrong, disks that are full, kills while results come to their place.

use crate::program::{folder_with, path as program, wisch};
use serde_json::Value as Json;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};
use wisch_memory::{EPISODE_SCHEMA, EpisodeRecord, Individual, Memory, Origin, Value, episode_id};

const YEAR: f64 = 31_557_600.0;
const RUN: [&str; 8] = [
    "run",
    "task.toml",
    "--rounds",
    "1",
    "--set",
    "strategy='kde'",
    "--touch-only",
    "--out",
];

fn now() -> f64 {
    SystemTime::now()
        .duration_since(UNIX_EPOCH)
        .unwrap()
        .as_secs_f64()
}

fn memory(folder: &Path) -> Memory {
    Memory::create(&folder.join("episodes")).unwrap()
}

/// An episode that a machine kept by its clock, and without telemetry.
fn keep(memory: &Memory, begin: f64, duration: f64) -> String {
    let id = episode_id(begin, 1);
    let interval = [begin, begin + duration];
    let record = EpisodeRecord {
        schema: EPISODE_SCHEMA,
        id: id.clone(),
        task: "board".to_owned(),
        interval,
        origin: Origin::Simulated,
        program: "by hand".to_owned(),
        seed: 1,
        rounds: Vec::new(),
        individuals: vec![Individual {
            class: "semco:WipingEpisode".to_owned(),
            interval: Some(interval),
            parent: None,
            relations: [].into(),
            values: [].into(),
        }],
    };
    memory.begin(&id).unwrap().commit(&record).unwrap();
    id
}

#[test]
fn an_episode_is_dated_by_the_clock_whatever_others_are_dated() {
    // A clock that was a year ahead, one that was a year behind, and a duration in milliseconds.
    for (begin, duration, is_told) in [
        (now() + YEAR, 30.0, true),
        (now() - YEAR, 30.0, false),
        (now() - 60.0, 3e7, false),
    ] {
        let folder = folder_with("arm-board.toml");
        let folder = folder.path();
        let memory = memory(folder);
        let other = keep(&memory, begin, duration);
        let before = now();
        let (code, out, err) = wisch(folder, &[&RUN[..], &["out"]].concat());
        assert!(code <= 1, "{out}{err}");
        let ids = memory.episodes().unwrap();
        let id = ids.iter().find(|id| **id != other).expect("a new episode");
        let record = memory.episode(id).unwrap().record().unwrap();
        let [began, ended] = record.interval;
        assert!(before <= began && began <= now(), "{began}");
        // The robot's time counts from there, and the clock's is stated, too.
        assert_eq!(record.rounds, [began]);
        assert!(ended > began, "{ended}");
        let values = &record.individuals[0].values;
        assert_eq!(values["semco:clockBegin"], Value::Number(began));
        let says = format!("episode {other} is dated ");
        assert_eq!(err.contains(&says), is_told, "{err}");
        if is_told {
            assert!(err.contains("365 days"), "{err}");
        }
        let (code, out, _) = wisch(folder, &["memory", "verify"]);
        let is_ahead = begin + duration > now();
        assert_eq!(code, i32::from(is_ahead), "{out}");
        assert_eq!(
            out.contains(&format!("{other}: its interval, ")),
            is_ahead,
            "{out}"
        );
    }
}

/// Whether commands may mount small disks of their own here.
fn can_mount() -> bool {
    let tried = Command::new("unshare")
        .args(["-rm", "mount", "-t", "tmpfs", "tmpfs", "/mnt"])
        .output();
    let can = tried.is_ok_and(|output| output.status.success());
    if !can {
        eprintln!("SKIPPED: no small disk can be mounted");
    }
    can
}

/// `WISCH_DISKS` says how many sizes are tried, if not 40.
#[cfg(target_os = "linux")]
#[test]
fn on_a_disk_that_is_full_at_any_write_a_log_is_imported_whole_or_not_at_all() {
    if !can_mount() {
        return;
    }
    let count: usize = std::env::var("WISCH_DISKS").map_or(40, |count| count.parse().unwrap());
    let folder = crate::interpret::folder(crate::interpret::believed());
    let folder = folder.path();
    fs::create_dir(folder.join("disk")).unwrap();
    let (mut kept, mut refused) = (0, 0);
    for k in 0..count {
        // From less than the first file to more than all of them.
        let size = 4096 * (1 + k * 400 / count);
        let script = format!(
            "mount -t tmpfs -o size={size} tmpfs disk
             $0 memory import log.mcap --task task.toml --memory disk/m --start-s 1795309772 --quiet; echo code $?
             $0 memory verify --memory disk/m; $0 memory list --memory disk/m --json
             $0 interpret log.mcap --task task.toml --out disk/out --quiet; echo out $?
             ls disk/out 2>/dev/null | tr '\\n' ' '; ls -A disk | grep -v '^m$\\|^out$'; ls -A disk/m/.new"
        );
        let output = Command::new("unshare")
            .current_dir(folder)
            .args(["-rm", "sh", "-c", &script])
            .arg(program())
            .output()
            .unwrap();
        let [out, err] = [&output.stdout, &output.stderr].map(|b| String::from_utf8_lossy(b));
        let is_kept = out.contains("\"task\"");
        kept += usize::from(is_kept);
        refused += usize::from(!is_kept);
        let code = if is_kept { "code 0" } else { "code 2" };
        assert!(out.contains(code), "{size}: {out}{err}");
        let episodes = if is_kept {
            "1 episode: no faults"
        } else {
            ": no faults"
        };
        assert!(
            out.contains(episodes) || err.contains("there is no memory"),
            "{size}: {out}{err}"
        );
        assert!(
            is_kept || err.contains("No space left"),
            "{size}: {out}{err}"
        );
        // Results are whole or not there.
        let has_results = out.contains("interpretation.json");
        assert_eq!(
            has_results,
            out.contains("out 0") || out.contains("out 1"),
            "{size}: {out}{err}"
        );
        assert_eq!(
            has_results,
            out.contains("report.html"),
            "{size}: {out}{err}"
        );
        assert!(
            !out.contains(".out."),
            "{size}: a temporary folder is left: {out}"
        );
        assert!(!out.contains(".active"), "{size}: {out}");
    }
    assert!(kept > 0 && refused > 0, "{kept} kept, {refused} refused");
}

#[cfg(target_os = "linux")]
#[test]
fn on_a_full_disk_an_episode_is_removed_and_advice_is_possible() {
    if !can_mount() {
        return;
    }
    let folder = crate::interpret::folder(crate::interpret::believed());
    let folder = folder.path();
    fs::create_dir(folder.join("disk")).unwrap();
    let script = "mount -t tmpfs -o size=8m tmpfs disk
        import='memory import log.mcap --task task.toml --memory disk/m --start-s 1795309772 --quiet'
        $0 $import || echo no import
        id=$(ls disk/m)
        $0 ask \"tell(holds('WipingEpisode_$id-0', rdfs:comment, 'a note'))\" --memory disk/m --engine swi --quiet
        dd if=/dev/zero of=disk/fill bs=1k count=99999 2>/dev/null
        $0 memory forget $id --memory disk/m; echo forgot $?
        $0 memory list --memory disk/m; $0 memory verify --memory disk/m
        dd if=/dev/zero of=disk/fill bs=1k count=99999 2>/dev/null
        $0 $import; echo import $?";
    let output = Command::new("unshare")
        .current_dir(folder)
        .args(["-rm", "sh", "-c", script])
        .arg(program())
        .output()
        .unwrap();
    let [out, err] = [&output.stdout, &output.stderr].map(|b| String::from_utf8_lossy(b));
    assert!(!out.contains("no import"), "{out}{err}");
    assert!(out.contains("forgot 0"), "{out}{err}");
    assert!(out.contains("the memory has no episodes"), "{out}{err}");
    assert!(out.contains("import 2"), "{out}{err}");
    assert!(
        err.contains("choose another folder with --memory DIR"),
        "{err}"
    );
    assert!(!err.contains("--no-memory"), "{err}");
}

/// Killed between the episode's coming to the memory and the results' coming to their place.
#[cfg(target_os = "linux")]
#[test]
fn a_run_that_is_resumed_after_its_episode_was_kept_has_one_episode() {
    let folder = folder_with("arm-board.toml");
    let folder = folder.path();
    let memory = memory(folder);
    let run = [&RUN[..], &["out"]].concat();
    let mut child = Command::new(program())
        .current_dir(folder)
        .args(&run)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let since = Instant::now();
    while memory.episodes().unwrap().is_empty() && since.elapsed() < Duration::from_secs(1800) {
        std::thread::sleep(Duration::from_millis(1));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    let [killed] = memory.episodes().unwrap().try_into().expect("one episode");
    let is_done = folder.join("out").exists();
    let (code, out, err) = wisch(folder, &[&run[..], &["--resume"]].concat());
    let left = memory.episodes().unwrap();
    assert_eq!(left.len(), 1, "{out}{err}");
    if is_done {
        return;
    }
    assert!(
        code <= 1 && err.contains("resuming after 1 round of the killed run"),
        "{out}{err}"
    );
    assert_ne!(left[0], killed);
    let episode = memory.episode(&left[0]).unwrap();
    assert!(episode.telemetry(1).unwrap().rows() > 100);
    assert!(folder.join("out/rounds.json").is_file());
    let (code, out, _) = wisch(folder, &["memory", "verify"]);
    assert_eq!((code, out.as_str()), (0, "1 episode: no faults\n"));
    let (_, listed, _) = wisch(folder, &["memory", "list", "--json"]);
    let listed: Json = serde_json::from_str(&listed).expect("one object");
    assert_eq!(listed["rounds"], 1);
}
