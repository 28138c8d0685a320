//! Costs of recording, opening, and cataloguing episodes.

#[path = "../examples/synthetic/hour.rs"]
mod hour;
#[path = "../examples/synthetic/records.rs"]
mod records;

use divan::Bencher;
use divan::counter::{BytesCount, ItemsCount};
use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use tempfile::TempDir;
use wisch::run::TelemetrySample;
use wisch_memory::{
    Catalogue, EpisodeRecord, Frames, Memory, RoundScene, Sampling, Telemetry, TelemetryWriter,
};

/// Number of recorded samples: a minute, from which the costs of an hour follow.
const RECORDED: usize = hour::SAMPLES / 60;

fn main() {
    divan::main();
}

fn writer(path: &Path) -> TelemetryWriter {
    let head = RoundScene::with_upright_tool("arm", "tip", "sponge", "board").head(hour::joints());
    TelemetryWriter::create(path, head).expect("a file")
}

/// A minute at 1 kHz: 60 s in 3 s would be 5 % of one core.
#[divan::bench(sample_count = 5)]
fn record_a_minute(bencher: Bencher<'_, '_>) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("minute.parquet");
    // The samples are generated first, so that only the recording is measured.
    let mut rows: Vec<Row> = Vec::new();
    let kept: Result<(), ()> = hour::write(1, RECORDED, &mut |sample| {
        rows.push(Row::of(sample));
        Ok(())
    });
    kept.expect("nothing can fail");
    bencher.counter(ItemsCount::new(RECORDED)).bench_local(|| {
        let mut writer = writer(&path);
        for row in &rows {
            writer.write(&row.sample()).expect("a sample");
        }
        writer.finish().expect("a file");
    });
    let bytes = std::fs::metadata(&path).expect("a file").len();
    println!("an hour takes {:.3} GB", 60.0 * bytes as f64 * 1e-9);
}

/// A sample that owns its arrays.
struct Row {
    positions: Vec<f64>,
    velocities: Vec<f64>,
    efforts: Vec<f64>,
    rest: TelemetrySample<'static>,
}

impl Row {
    fn of(sample: &TelemetrySample<'_>) -> Self {
        Self {
            positions: sample.positions.to_vec(),
            velocities: sample.velocities.to_vec(),
            efforts: sample.efforts.to_vec(),
            rest: TelemetrySample {
                positions: &[],
                velocities: &[],
                efforts: &[],
                ..*sample
            },
        }
    }

    fn sample(&self) -> TelemetrySample<'_> {
        TelemetrySample {
            positions: &self.positions,
            velocities: &self.velocities,
            efforts: &self.efforts,
            ..self.rest
        }
    }
}

/// An hour of telemetry, written once.
static HOUR: LazyLock<(TempDir, PathBuf)> = LazyLock::new(|| {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("hour.parquet");
    let mut writer = writer(&path);
    hour::write(1, hour::SAMPLES, &mut |sample| writer.write(sample)).expect("samples");
    writer.finish().expect("a file");
    (folder, path)
});

#[divan::bench]
fn open_an_hour(bencher: Bencher<'_, '_>) {
    let path = &HOUR.1;
    bencher.bench_local(|| Telemetry::open(path).expect("telemetry").rows());
}

/// Poses of the tool during 50 collisions of 1.5 s, every 0.5 s: the paper's query.
#[divan::bench]
fn trajectories_warm(bencher: Bencher<'_, '_>) {
    let robot = robot();
    let telemetry = Telemetry::open(&HOUR.1).expect("telemetry");
    let frames = Frames::new(&robot, &telemetry).expect("frames");
    bencher.bench_local(|| trajectories(&frames));
}

/// The same query without cached data.
#[divan::bench(sample_count = 10)]
fn trajectories_cold(bencher: Bencher<'_, '_>) {
    let robot = robot();
    bencher.bench_local(|| {
        let telemetry = Telemetry::open(&HOUR.1).expect("telemetry");
        let frames = Frames::new(&robot, &telemetry).expect("frames");
        trajectories(&frames)
    });
}

fn trajectories(frames: &Frames<'_>) -> usize {
    let starts = (0..50).map(|number| 60.0 * f64::from(number) + 1.0);
    let poses = starts.map(|start| {
        let found = frames.trajectory("sponge", [start, start + 1.5], Sampling::Every(0.5));
        found.expect("poses").len()
    });
    poses.sum()
}

fn robot() -> wisch::robot::RobotModel {
    let mut none = |name: &str| Err(name.to_owned());
    wisch::robot::RobotModel::from_urdf("arm", &hour::urdf(), &mut none).expect("a robot")
}

/// The largest force in each of 45 collisions.
#[divan::bench]
fn peak_forces_warm(bencher: Bencher<'_, '_>) {
    let telemetry = Telemetry::open(&HOUR.1).expect("telemetry");
    bencher.bench_local(|| {
        let mut peaks = Vec::new();
        for number in 0..45 {
            let start = 80.0 * f64::from(number) + 57.0;
            let rows = telemetry.rows_between([start, start + 1.5]).expect("rows");
            let parts = ["external/fx", "external/fy", "external/fz"]
                .map(|column| telemetry.values(column, rows.clone()).expect("values"));
            let forces = (0..rows.len()).map(|row| parts.iter().map(|v| v[row].powi(2)).sum());
            peaks.push(forces.fold(0.0, f64::max).sqrt());
        }
        peaks
    });
}

fn records(count: usize) -> Vec<EpisodeRecord> {
    (0..count)
        .map(|number| records::record(1, number))
        .collect()
}

/// Returns a memory whose tables hold the whole catalogue.
fn memory(count: usize) -> (TempDir, Memory) {
    let folder = tempfile::tempdir().expect("a folder");
    let memory = Memory::create(&folder.path().join("episodes")).expect("a memory");
    for record in records(count) {
        let writer = memory.begin(&record.id).expect("an episode");
        writer.commit(&record).expect("an episode");
    }
    memory.catalogue().expect("a catalogue");
    (folder, memory)
}

#[divan::bench(args = [1000], sample_count = 10)]
fn catalogue_from_tables(bencher: Bencher<'_, '_>, count: usize) {
    let (_folder, memory) = memory(count);
    let bytes = serde_json::to_vec(&records(count)).map_or(0, |text| text.len());
    bencher
        .counter(BytesCount::new(bytes))
        .bench_local(|| memory.catalogue().expect("a catalogue").len());
}

#[divan::bench(args = [10_000, 100_000], sample_count = 3)]
fn filter_by_performance(bencher: Bencher<'_, '_>, count: usize) {
    let catalogue = Catalogue::from_records(
        (0..count)
            .map(|number| records::record(1, number))
            .collect::<Vec<_>>()
            .iter(),
    );
    bencher.bench_local(|| {
        let all = catalogue.numbers("semco:performance").iter();
        all.filter(|(_, performance)| *performance <= 0.8).count()
    });
}
