//! A killed `wisch ask` leaves no engine behind, whatever query that is at.

use super::{build_engine, memory, program};
use rustix::process::{Pid, Signal, kill_process, test_kill_process};
use std::fs;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};
use wisch_memory::ask::EngineCommand;

/// No query of Prolog that ends.
const ENDLESS: &str = "forall(between(1, 1000000000000, X), X > 0)";
/// Far longer than anything here takes; who waits so long waits in vain.
const PATIENCE: Duration = Duration::from_secs(60);

fn wait_for<T>(what: &str, mut found: impl FnMut() -> Option<T>) -> T {
    let begin = Instant::now();
    loop {
        if let Some(found) = found() {
            return found;
        }
        assert!(begin.elapsed() < PATIENCE, "{what}");
        std::thread::sleep(Duration::from_millis(20));
    }
}

/// State, parent and processor time [ticks] of a process.
fn stat(pid: i32) -> Option<(String, i32, u64)> {
    let text = fs::read_to_string(format!("/proc/{pid}/stat")).ok()?;
    // Its name, in brackets, may hold anything.
    let (_, rest) = text.rsplit_once(") ")?;
    let fields: Vec<&str> = rest.split(' ').collect();
    let ticks = fields[11].parse::<u64>().ok()? + fields[12].parse::<u64>().ok()?;
    Some((fields[0].to_owned(), fields[1].parse().ok()?, ticks))
}

/// The engine that a program began, once it has begun to work hard.
fn engine_at_work(of: &Child) -> Pid {
    let parent = i32::try_from(of.id()).unwrap();
    wait_for("an engine at work", || {
        let processes = fs::read_dir("/proc").unwrap();
        let mut pids = processes.filter_map(|entry| entry.ok()?.file_name().to_str()?.parse().ok());
        let engine = pids.find(|&pid| {
            stat(pid).is_some_and(|(_, its_parent, ticks)| its_parent == parent && ticks > 30)
        })?;
        Pid::from_raw(engine)
    })
}

#[test]
fn an_engine_ends_with_the_program_that_began_it() {
    build_engine();
    let folder = memory();
    let engines: &[&str] = match EngineCommand::find_swi() {
        Some(_) => &["scryer", "swi"],
        None => &["scryer"],
    };
    for engine in engines {
        for signal in [Signal::KILL, Signal::TERM, Signal::HUP, Signal::INT] {
            let mut asking = Command::new(program())
                .current_dir(folder.path())
                .args(["ask", "--engine", engine, ENDLESS])
                .stdout(Stdio::null())
                .stderr(Stdio::null())
                .spawn()
                .unwrap();
            let at_work = engine_at_work(&asking);
            kill_process(Pid::from_child(&asking), signal).unwrap();
            // It is not waited for yet: an engine must not need that to see that it is alone.
            wait_for(&format!("{engine} after {signal:?}: it works on"), || {
                let is_gone = test_kill_process(at_work).is_err();
                let is_dead = || {
                    stat(at_work.as_raw_nonzero().get())?
                        .0
                        .eq("Z")
                        .then_some(())
                };
                is_gone.then_some(()).or_else(is_dead)
            });
            // The program itself ends at a signal that it can handle, with the code that shells give it.
            let code = (signal != Signal::KILL).then(|| 128 + signal.as_raw());
            assert_eq!(asking.wait().unwrap().code(), code, "{signal:?} ends it");
        }
    }
}

/// Another end of the pipe that is an engine's standard input, so that this does not end with the program.
#[cfg(target_os = "linux")]
fn held_open(engine: Pid, program: &Child) -> fs::File {
    let pipe = fs::read_link(format!("/proc/{}/fd/0", engine.as_raw_nonzero())).unwrap();
    let streams = fs::read_dir(format!("/proc/{}/fd", program.id())).unwrap();
    let mut streams = streams.map(|entry| entry.unwrap().path());
    let other_end = streams.find(|stream| fs::read_link(stream).is_ok_and(|end| end == pipe));
    let other_end = other_end.expect("the program writes to it");
    fs::File::options().write(true).open(other_end).unwrap()
}

#[cfg(target_os = "linux")]
#[test]
fn an_engine_ends_with_its_program_though_its_input_does_not() {
    let has_setpriv = Command::new("setpriv")
        .args(["--pdeathsig", "KILL", "true"])
        .status();
    build_engine();
    let folder = memory();
    let mut engines = vec!["scryer"];
    if EngineCommand::find_swi().is_some() && has_setpriv.is_ok_and(|status| status.success()) {
        engines.push("swi");
    }
    for engine in engines {
        let mut asking = Command::new(program())
            .current_dir(folder.path())
            .args(["ask", "--engine", engine, ENDLESS])
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        let at_work = engine_at_work(&asking);
        let held = held_open(at_work, &asking);
        asking.kill().unwrap();
        asking.wait().unwrap();
        wait_for(&format!("{engine}: it works on"), || {
            test_kill_process(at_work).is_err().then_some(())
        });
        drop(held);
    }
}

#[test]
fn an_engine_has_limits_of_its_own() {
    build_engine();
    let folder = memory();
    for (engine, memory_bytes) in [("scryer", 512 << 20), ("swi", (512 << 20) + (1 << 30))] {
        if engine == "swi" && EngineCommand::find_swi().is_none() {
            continue;
        }
        let mut asking = Command::new(program())
            .current_dir(folder.path())
            .args([
                "ask",
                "--engine",
                engine,
                "--timeout",
                "600",
                "--memory-limit",
                "512",
                ENDLESS,
            ])
            .stdout(Stdio::null())
            .spawn()
            .unwrap();
        let at_work = engine_at_work(&asking);
        let limits =
            fs::read_to_string(format!("/proc/{}/limits", at_work.as_raw_nonzero())).unwrap();
        let limit = |name: &str| {
            let line = limits.lines().find(|line| line.starts_with(name)).unwrap();
            let soft = line[name.len()..].split_whitespace().next().unwrap();
            soft.parse::<u64>().ok()
        };
        assert_eq!(limit("Max address space"), Some(memory_bytes), "{engine}");
        let processor_s = limit("Max cpu time").expect("a limit");
        assert!(
            (1200..1300).contains(&processor_s),
            "{engine}: {processor_s} s"
        );
        asking.kill().unwrap();
        asking.wait().unwrap();
    }
}
