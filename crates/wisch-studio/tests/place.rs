//! A studio with its own memory and a program that imitates runs.

use crate::client::{Answer, send};
use flate2::Compression;
use flate2::write::GzEncoder;
use std::io::Write;
use std::net::{IpAddr, Ipv4Addr};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::thread::JoinHandle;
use std::time::{Duration, Instant};
use tempfile::TempDir;
use tokio::sync::oneshot;
use wisch_memory::{EPISODE_SCHEMA, EpisodeRecord, Individual, Memory, Origin, Value};
use wisch_studio::{Config, Studio};

pub const ID: &str = "20261122-010000-abcd";
pub const OTHER: &str = "20261123-010000-0001";

/// Imitates `wisch run --live`: it writes as many lines as the file `lines` beside it states, and ends in order after a
/// termination signal. The task `fails` does not exist.
const PROGRAM: &str = r#"#!/bin/bash
here=$(dirname "$0")
[ "$1" = scenarios ] && { echo "board       Crumbs on a board"; echo "fails       Nothing"; exit; }
echo "$@" >> "$here/calls"
[ "${@: -1}" = fails ] && { echo "error: there is no task fails" >&2; exit 2; }
while [ $# -gt 0 ]; do [ "$1" = --memory ] && memory=$2; shift; done
id=20261124-010000-$(printf %04x $(($$ % 65536)))
mkdir -p "$memory/.live"
lines=$memory/.live/$id.jsonl
end() { echo '{"piece":"ended","met":true,"episode":"'$id'"}' >> "$lines"; rm -f "$memory/.live/$id.json" "$lines"; exit; }
trap end TERM
echo '{"piece":"head","title":"board"}' > "$lines"
echo '{"pid":'$$',"task":"board","begun":"2026-11-24 01:00:00"}' > "$memory/.live/$id.json"
for i in $(seq "$(cat "$here/lines")"); do
  printf '{"piece":"samples","n":%d}\n' "$i" >> "$lines"
  sleep 0.002
done
[ -e "$here/dies" ] && { echo "error: out of luck" >&2; kill -9 $$; }
[ -e "$here/waits" ] && while :; do sleep 0.02; done
end
"#;

pub struct Place {
    pub folder: TempDir,
    pub address: String,
    /// `/TOKEN/`
    pub base: String,
    end: Option<oneshot::Sender<()>>,
    server: Option<JoinHandle<()>>,
}

impl Place {
    pub fn new() -> Self {
        Self::with_engine(None)
    }

    pub fn with_engine(engine: Option<PathBuf>) -> Self {
        Self::with(engine, Ipv4Addr::LOCALHOST.into())
    }

    /// Starts a studio that listens at an address.
    pub fn at(host: IpAddr) -> Self {
        Self::with(None, host)
    }

    fn with(engine: Option<PathBuf>, host: IpAddr) -> Self {
        let folder = tempfile::tempdir().unwrap();
        script(&folder.path().join("wisch"), PROGRAM);
        std::fs::write(folder.path().join("lines"), "100").unwrap();
        let config = Config {
            memory: folder.path().join("episodes"),
            wisch: folder.path().join("wisch"),
            engine,
            scenarios: None,
            host,
            port: 0,
        };
        let (say_url, url) = std::sync::mpsc::channel();
        let (end, ended) = oneshot::channel::<()>();
        let server = std::thread::spawn(move || {
            let runtime = tokio::runtime::Runtime::new().unwrap();
            runtime.block_on(async {
                let studio = Studio::begin(&config).await.unwrap();
                say_url.send(studio.url().to_owned()).unwrap();
                let until = async { drop(ended.await) };
                studio.serve(until).await;
            });
            runtime.shutdown_timeout(Duration::from_secs(1));
        });
        let url = url.recv().unwrap();
        let (address, base) = url
            .strip_prefix("http://")
            .unwrap()
            .split_once('/')
            .unwrap();
        Self {
            address: address.to_owned(),
            base: format!("/{base}"),
            folder,
            end: Some(end),
            server: Some(server),
        }
    }

    pub fn memory(&self) -> Memory {
        Memory::open(&self.folder.path().join("episodes")).unwrap()
    }

    pub fn live(&self) -> PathBuf {
        self.folder.path().join("episodes/.live")
    }

    pub fn get(&self, path: &str) -> Answer {
        self.get_with(path, &[])
    }

    pub fn get_with(&self, path: &str, headers: &[(&str, &str)]) -> Answer {
        let path = format!("{}{path}", self.base);
        send(&self.address, "GET", &path, headers, "")
    }

    pub fn post(&self, path: &str, body: &str) -> Answer {
        let path = format!("{}{path}", self.base);
        let headers = [("Content-Type", "application/json")];
        send(&self.address, "POST", &path, &headers, body)
    }

    /// Ends the server, and waits until it has ended.
    pub fn end(&mut self) {
        if let Some(end) = self.end.take() {
            let _ = end.send(());
        }
        if let Some(server) = self.server.take() {
            server.join().unwrap();
        }
    }

    /// Stores an episode with a recording.
    /// Keeps an episode of a day with a first round, and the offset of its surface \[m\].
    pub fn keep_round(&self, day: u32, offset: f64) {
        let mut record = record(&format!("day{day:02}"));
        record.interval = [0.0, 10.0].map(|time| 1.79e9 + 86_400.0 * f64::from(day) + time);
        let numbers = [("semco:round", 1.0), ("semco:planeOffset", offset)];
        record.individuals[2].values = numbers
            .map(|(name, value)| (name.to_owned(), Value::Number(value)))
            .into();
        let writer = self.memory().begin(&record.id).unwrap();
        writer.commit(&record).unwrap();
    }

    pub fn keep(&self, id: &str, recording: Option<&[u8]>) {
        keep(&self.memory(), id, recording);
    }
}

/// Stores an episode with a recording in a memory.
pub fn keep(memory: &Memory, id: &str, recording: Option<&[u8]>) {
    let writer = memory.begin(id).unwrap();
    if let Some(recording) = recording {
        writer.attach("recording.jsonl.gz", recording).unwrap();
    }
    writer.commit(&record(id)).unwrap();
}

impl Drop for Place {
    fn drop(&mut self) {
        self.end();
    }
}

/// Writes a script from another process. A file that this process holds open for writing is inherited by children of other
/// tests, and could then not be executed.
pub fn script(file: &Path, text: &str) {
    let mut command = Command::new("sh");
    command.args(["-c", "printf %s \"$1\" > \"$0\" && chmod 755 \"$0\""]);
    assert!(command.arg(file).arg(text).status().unwrap().success());
}

pub fn packed(lines: &str) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::fast());
    encoder.write_all(lines.as_bytes()).unwrap();
    encoder.finish().unwrap()
}

/// Waits until a condition holds.
pub fn wait_until(what: &str, mut holds: impl FnMut() -> bool) {
    let deadline = Instant::now() + Duration::from_secs(20);
    while !holds() {
        assert!(Instant::now() < deadline, "{what}");
        std::thread::sleep(Duration::from_millis(20));
    }
}

/// Returns the record of an episode with a collision from 3 to 4.5 s.
fn record(id: &str) -> EpisodeRecord {
    let individual = |class: &str, parent, interval| Individual {
        class: format!("semco:{class}"),
        interval: Some(interval),
        parent,
        relations: [].into(),
        values: [].into(),
    };
    let all = [1000.0, 1010.0];
    let mut action = individual("WipingAction", Some(0), all);
    action.values = [("semco:performance".to_owned(), Value::Number(0.75))].into();
    let states = vec!["soma:ExecutionState_Succeeded".to_owned()];
    action.relations = [("soma:hasExecutionState".to_owned(), states)].into();
    EpisodeRecord {
        schema: EPISODE_SCHEMA,
        id: id.to_owned(),
        task: "board".to_owned(),
        interval: all,
        origin: Origin::Simulated,
        program: "test".to_owned(),
        seed: 1,
        rounds: vec![1000.0],
        individuals: vec![
            individual("WipingEpisode", None, all),
            action,
            individual("WipingRound", Some(1), all),
            individual("HumanCollision", Some(2), [1003.0, 1004.5]),
        ],
    }
}
