//! Bags that are cut off or damaged.

use super::{Wiping, head, in_folder, named, refused, wipe, write_bag};
use mcap::{Compression, WriteOptions};
use proptest::prelude::*;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::LazyLock;
use std::time::{Duration, Instant};
use wisch_telemetry::{BagWriter, LogOptions, active_path, read};

#[test]
fn a_cut_bag_is_read_up_to_its_last_complete_second() {
    let (folder, path) = in_folder();
    write_bag(&path, 200.0, 0);
    let bytes = fs::read(&path).unwrap();
    let whole = read(&path, &LogOptions::default()).unwrap().samples;
    let cut = folder.path().join("cut.mcap");
    let mut most = 0;
    for share in [0.2, 0.4, 0.6, 0.8] {
        let cut_bytes = &bytes[..(bytes.len() as f64 * share) as usize];
        fs::write(active_path(&cut), cut_bytes).unwrap();
        // The bag is found by its present name and by its final name.
        for name in [active_path(&cut), cut.clone()] {
            let Ok(log) = read(&name, &LogOptions::default()) else {
                assert!(share < 0.4);
                continue;
            };
            assert!(log.is_unfinished);
            assert_eq!(log.samples, whole[..log.samples.len()]);
            assert_eq!(log.samples.len() % 200, 0, "complete seconds");
            assert!(log.samples.len() >= most);
            most = log.samples.len();
        }
        fs::write(folder.path().join("finished.mcap"), cut_bytes).unwrap();
        let message = refused(&folder.path().join("finished.mcap"), &LogOptions::default());
        let expected = format!(
            ": the bag ends at byte {} in the middle of a record, ",
            cut_bytes.len()
        );
        assert!(message.starts_with(&expected), "{message}");
    }
    assert!(most >= whole.len() / 2, "{most} of {}", whole.len());
}

#[test]
fn a_bag_without_a_complete_message_is_refused_by_its_cause() {
    let (folder, path) = in_folder();
    write_bag(&path, 200.0, 0);
    let bytes = fs::read(&path).unwrap();
    let cut = folder.path().join("cut.mcap");
    // Nothing, a part of the first bytes, and a part of the first chunk, as a recording or as a damaged file.
    for len in [0, 5, 700] {
        for name in [active_path(&cut), cut.clone()] {
            fs::write(&name, &bytes[..len]).unwrap();
            let message = refused(&name, &LogOptions::default());
            let expected = format!(
                ": the bag ends at byte {len} in the middle of a record, before its first message: it holds no complete message"
            );
            assert_eq!(message, expected);
            fs::remove_file(&name).unwrap();
        }
    }
    // The forces begin later than the pose of the markers.
    let mut bag = BagWriter::create(&path, head(0)).unwrap();
    bag.write_particles(0.0, &[]).unwrap();
    bag.finish().unwrap();
    let bytes = fs::read(&path).unwrap();
    fs::write(active_path(&cut), &bytes[..bytes.len() - 20]).unwrap();
    let message = refused(&active_path(&cut), &LogOptions::default());
    assert!(
        message.contains("before its first wrench: its complete messages (")
            && message.contains("/particles"),
        "{message}"
    );
    // A recording of nothing.
    let bag = BagWriter::create(&path, head(0)).unwrap();
    bag.finish().unwrap();
    let message = refused(&path, &LogOptions::default());
    assert_eq!(
        message,
        ": the bag is complete, but it holds no complete message"
    );
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_reported_in_the_words_of_the_system() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("full.mcap");
    std::os::unix::fs::symlink("/dev/full", active_path(&path)).unwrap();
    let mut bag = BagWriter::create(&path, head(0)).unwrap();
    let error = wipe(20.0).write(&mut bag).and_then(|_| bag.finish());
    let error = error.unwrap_err().to_string();
    assert!(
        error.contains("full.mcap.active: No space left on device"),
        "{error}"
    );
}

/// Not an independent test: the process that the next test starts and kills.
#[test]
fn a_writer_that_does_not_end_by_itself() {
    let Some(path) = std::env::var_os("WISCH_TEST_ENDLESS_BAG") else {
        return;
    };
    let mut bag = BagWriter::create(Path::new(&path), head(0)).unwrap();
    // Long enough to be killed, but short enough not to fill a disk otherwise.
    let endless = Wiping {
        rows: 4000,
        ..wipe(1000.0)
    };
    endless.write(&mut bag).unwrap();
    std::thread::sleep(Duration::from_secs(60));
}

#[test]
fn the_bag_of_a_killed_writer_is_read() {
    let (_folder, path) = in_folder();
    let mut writer = Command::new(std::env::current_exe().unwrap())
        .args([
            "--exact",
            "telemetry::damage::a_writer_that_does_not_end_by_itself",
        ])
        .env("WISCH_TEST_ENDLESS_BAG", &path)
        .stdout(Stdio::null())
        .spawn()
        .unwrap();
    let patience = Instant::now() + Duration::from_secs(60);
    let enough = 500_000;
    while fs::metadata(active_path(&path)).map_or(0, |file| file.len()) < enough {
        assert!(Instant::now() < patience, "nothing is written");
        std::thread::sleep(Duration::from_millis(5));
    }
    writer.kill().unwrap();
    writer.wait().unwrap();
    assert!(!path.exists());
    let log = read(&path, &LogOptions::default()).unwrap();
    assert!(
        log.is_unfinished && log.samples.len() >= 1000,
        "{}",
        log.samples.len()
    );
    let last = log.samples[log.samples.len() - 1].time;
    assert!((last - (log.samples.len() - 1) as f64 / 1000.0).abs() < 1e-9);
}

/// Returns a small bag for damage tests.
static SMALL: LazyLock<Vec<u8>> = LazyLock::new(|| {
    let (_folder, path) = in_folder();
    write_bag(&path, 10.0, 0);
    fs::read(&path).unwrap()
});

/// Returns the small bag with unpacked messages, so that damage reaches them.
static PLAIN: LazyLock<Vec<u8>> = LazyLock::new(|| {
    let mut plain = std::io::Cursor::new(Vec::new());
    let options = WriteOptions::new()
        .compression(None::<Compression>)
        .calculate_chunk_crcs(false);
    let mut bag = options.create(&mut plain).unwrap();
    for message in mcap::MessageStream::new(&SMALL).unwrap() {
        bag.write(&message.unwrap()).unwrap();
    }
    bag.finish().unwrap();
    drop(bag);
    plain.into_inner()
});

/// Returns a bag of another library, packed with Zstandard.
static FOREIGN: LazyLock<Vec<u8>> = LazyLock::new(|| {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/foreign.mcap");
    fs::read(path).unwrap()
});

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    /// Any damage gives a log or an error with the name of the file, never a panic.
    #[test]
    fn damaged_bags_cause_no_panic(
        which in 0..3_usize, is_active: bool, damage in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
        end in prop::option::of(any::<prop::sample::Index>()),
    ) {
        let mut bytes = [&*SMALL, &*PLAIN, &*FOREIGN][which].clone();
        for (index, byte) in damage {
            let index = index.index(bytes.len());
            bytes[index] = byte;
        }
        if let Some(end) = end {
            bytes.truncate(end.index(bytes.len()));
        }
        let (_folder, path) = in_folder();
        let path = if is_active { active_path(&path) } else { path };
        fs::write(&path, bytes).unwrap();
        for options in [LogOptions::default(), named("/tf:tool", "/wrench/controller")] {
            match read(&path, &options) {
                Ok(log) => prop_assert!(!log.samples.is_empty()),
                Err(error) => {
                    let starts_with_file = error.to_string().starts_with(&path.display().to_string());
                    prop_assert!(starts_with_file);
                }
            }
        }
    }
}

/// Returns the length of the content of the record at a position [bytes].
fn len_at(bytes: &[u8], at: usize) -> usize {
    u64::from_le_bytes(bytes[at + 1..at + 9].try_into().unwrap()) as usize
}

/// Returns the position of the first chunk; the first record follows the magic bytes.
fn first_chunk(bytes: &[u8]) -> usize {
    let mut at = 8;
    while bytes[at] != mcap::records::op::CHUNK {
        at += 9 + len_at(bytes, at);
    }
    at
}

#[test]
fn a_flipped_bit_in_a_chunk_is_detected() {
    let (_folder, path) = in_folder();
    let mut bytes = SMALL.clone();
    let chunk = first_chunk(&bytes);
    let middle = chunk + 9 + len_at(&bytes, chunk) / 2;
    bytes[middle] ^= 1;
    fs::write(&path, bytes).unwrap();
    let refused = refused(&path, &LogOptions::default());
    assert!(refused.contains(": byte "), "{refused}");
}

#[test]
fn a_record_longer_than_its_chunk_is_detected() {
    let (_folder, path) = in_folder();
    let mut bytes = PLAIN.clone();
    let chunk = first_chunk(&bytes);
    // The header of a chunk without compression has 40 bytes.
    let first = chunk + 9 + 40;
    let longer = len_at(&bytes, chunk) as u64;
    bytes[first + 1..first + 9].copy_from_slice(&longer.to_le_bytes());
    fs::write(&path, bytes).unwrap();
    assert_eq!(
        refused(&path, &LogOptions::default()),
        format!(": byte {chunk}: Chunk ended in the middle of a record")
    );
}
