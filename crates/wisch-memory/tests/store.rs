//! The store: an episode is stored completely or not at all, whatever happens to its writers and readers.

#[path = "../examples/synthetic/records.rs"]
mod records;

use proptest::prelude::*;
use records::record;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::{Duration, Instant};
use wisch::follow::Phase;
use wisch::geometry::{Point2, Polygon, Pose, Region};
use wisch::represent::Observation;
use wisch_memory::catalogue::entries;
use wisch_memory::{
    Catalogue, CatalogueNode, EpisodeRecord, Individual, IndividualId, Mark, Memory, MemoryError,
    Origin, RoundObservations, TelemetryHead, Value,
};

/// Environment variable with the folder into which the child process writes.
const CHILD_MEMORY: &str = "WISCH_TEST_MEMORY";

/// Returns an observation before a round, and none after it.
fn example_observations() -> RoundObservations {
    let seen = Observation {
        detections: vec![Point2::new(0.1, -1.0 / 3.0)],
        hidden: Region::new(vec![Polygon::rectangle([0.1, 0.2].into())]),
    };
    RoundObservations {
        round: Some(1),
        world_from_surface: Pose::translation(0.6, 0.1, 0.75),
        observations: [Some(seen), None],
    }
}

/// Stores an episode with one column of telemetry, observations and files.
fn store(memory: &Memory, record: &EpisodeRecord) -> Result<(), MemoryError> {
    let writer = memory.begin(&record.id)?;
    let columns = ["v".to_owned()];
    let mut log = writer.telemetry_with_columns(1, TelemetryHead::default(), &columns)?;
    let mark = Mark {
        motion: 0,
        phase: Phase::FreeMotion,
    };
    for step in 0..100 {
        log.push(f64::from(step) * 0.2, mark, [f64::from(step)])?;
    }
    log.finish()?;
    writer.observations(1, &example_observations())?;
    writer.attach("task.toml", b"name = \"board\"")?;
    writer.attach("round-1/plan.json", b"{}")?;
    writer.commit(record)
}

/// A record with the rounds that [`store`] writes.
fn one_round(number: usize) -> EpisodeRecord {
    let mut record = record(7, number);
    record.rounds.truncate(1);
    record
}

fn memory(folder: &Path) -> Memory {
    Memory::create(&folder.join("episodes")).unwrap()
}

/// Returns the contents of a catalogue without its indices, which depend on the order of episodes.
fn contents(catalogue: &Catalogue) -> BTreeMap<String, Vec<String>> {
    let mut episodes = BTreeMap::new();
    for row in catalogue.episodes() {
        let head = format!("{} {:?} {:?}", row.task, row.interval, row.rounds);
        let mut lines = vec![head];
        for id in row.first..row.first + row.len {
            lines.push(individual(catalogue, id));
        }
        episodes.insert(row.id.clone(), lines);
    }
    episodes
}

fn individual(catalogue: &Catalogue, id: IndividualId) -> String {
    let parent = catalogue.parent(id).map(|parent| catalogue.name(parent));
    let name = catalogue.name(id);
    assert_eq!(catalogue.find(&name), Some(id));
    assert!(
        catalogue
            .individuals_of_class(catalogue.class(id))
            .contains(&id)
    );
    let mut lines = vec![format!("{name} {:?} {parent:?}", catalogue.interval(id))];
    for property in catalogue.properties() {
        for (_, value) in entries(catalogue.numbers(property), id) {
            lines.push(format!("{property} {value:?}"));
        }
        for (_, text) in entries(catalogue.texts(property), id) {
            lines.push(format!("{property} {text:?}"));
        }
        for (_, node) in entries(catalogue.relations(property), id) {
            let object = match *node {
                CatalogueNode::Individual(id) => catalogue.name(id),
                CatalogueNode::Shared(place) => {
                    catalogue.shared_individuals()[place as usize].clone()
                }
            };
            lines.push(format!("{property} {object}"));
        }
    }
    lines[1..].sort();
    lines.join("; ")
}

fn from_folders(memory: &Memory) -> BTreeMap<String, Vec<String>> {
    let ids = memory.episodes().unwrap();
    let records = ids.iter().map(|id| memory.episode(id).unwrap().record());
    let records: Vec<EpisodeRecord> = records.collect::<Result<_, _>>().unwrap();
    contents(&Catalogue::from_records(&records))
}

#[test]
fn an_episode_is_read_back_and_deleted() {
    let folder = tempfile::tempdir().unwrap();
    let memory = memory(folder.path());
    let record = one_round(0);
    store(&memory, &record).unwrap();
    assert_eq!(memory.episodes().unwrap(), [record.id.as_str()]);
    let episode = memory.episode(&record.id).unwrap();
    assert_eq!(episode.record().unwrap(), record);
    assert_eq!(episode.attachment("round-1/plan.json").unwrap(), b"{}");
    assert_eq!(episode.telemetry(1).unwrap().rows(), 100);
    assert_eq!(
        episode.observations(1).unwrap(),
        Some(example_observations())
    );
    // As for rounds without a camera, and for episodes from before observations.
    assert_eq!(episode.observations(2).unwrap(), None);
    let files = [
        "checksums.json",
        "episode.json",
        "round-1.parquet",
        "round-1/observations.json",
        "round-1/plan.json",
        "task.toml",
    ];
    assert_eq!(episode.files().unwrap(), files);
    assert!(memory.verify().unwrap().is_empty());
    assert!(matches!(
        memory.begin(&record.id),
        Err(MemoryError::Exists { .. })
    ));
    let message = memory.episode("20260101-080000-0001").unwrap_err();
    assert!(
        message
            .to_string()
            .ends_with("the nearest is \"20260101-080000-0000\""),
        "{message}"
    );

    memory.forget(&record.id).unwrap();
    assert!(memory.episodes().unwrap().is_empty());
    assert!(memory.catalogue().unwrap().is_empty());
    // After a deletion, the same name can be used for another episode.
    let mut other = record.clone();
    other.task = "another".into();
    store(&memory, &other).unwrap();
    assert_eq!(memory.catalogue().unwrap().episodes()[0].task, "another");
}

#[test]
fn invalid_episodes_are_refused_and_leave_no_files() {
    let folder = tempfile::tempdir().unwrap();
    let memory = memory(folder.path());
    for id in ["", "a b", "../x", ".new-x", &"x".repeat(81)] {
        assert!(
            matches!(memory.begin(id), Err(MemoryError::Id { .. })),
            "{id}"
        );
    }
    let writer = memory.begin("a").unwrap();
    for name in ["", "..", "../x", "/x", "a/../../x", "episode.json", "a\\b"] {
        let attached = writer.attach(name, b"");
        assert!(matches!(attached, Err(MemoryError::Name { .. })), "{name}");
    }
    let refused = writer.commit(&one_round(0));
    assert!(matches!(refused, Err(MemoryError::Other { .. })));
    let mut broken = one_round(0);
    broken.individuals[1].parent = Some(9);
    let writer = memory.begin(&broken.id).unwrap();
    let refused = writer.commit(&broken);
    assert!(matches!(refused, Err(MemoryError::Record { .. })));
    let writer = memory.begin(&broken.id).unwrap();
    let log = writer.telemetry(1, TelemetryHead::default()).unwrap();
    let refused = writer.commit(&one_round(0));
    assert!(matches!(refused, Err(MemoryError::Unfinished { .. })));
    drop(log);
    assert_eq!(list_remains(&memory), [""; 0]);
    assert_eq!(names_in(memory.folder()), [".new"]);
    assert!(matches!(
        Memory::open(&folder.path().join("none")),
        Err(MemoryError::NoMemory { .. })
    ));
}

#[test]
fn every_damage_is_reported_with_its_file() {
    let folder = tempfile::tempdir().unwrap();
    let memory = memory(folder.path());
    let record = one_round(0);
    store(&memory, &record).unwrap();
    let episode = memory.episode(&record.id).unwrap();
    for name in episode.files().unwrap() {
        let path = episode.folder().join(&name);
        let whole = std::fs::read(&path).unwrap();
        let faulty = |what: &str| {
            let faults = memory.verify().unwrap();
            let messages: Vec<String> = faults.iter().map(ToString::to_string).collect();
            let is_named = messages.iter().any(|fault| fault.contains(&name));
            // Damaged check sums are reported for another file, or for themselves.
            assert!(
                is_named || name == "checksums.json" && !messages.is_empty(),
                "{what} {name}: {messages:?}"
            );
        };
        let step = whole.len() / 7 + 1;
        for place in (0..whole.len()).step_by(step) {
            let mut bytes = whole.clone();
            bytes[place] ^= 0x15;
            std::fs::write(&path, &bytes).unwrap();
            faulty("scratched");
            std::fs::write(&path, &whole[..place]).unwrap();
            faulty("cut off");
        }
        std::fs::remove_file(&path).unwrap();
        faulty("lost");
        std::fs::write(&path, &whole).unwrap();
    }
    assert!(memory.verify().unwrap().is_empty());
}

#[test]
fn reading_telemetry_detects_every_damage() {
    let folder = tempfile::tempdir().unwrap();
    let memory = memory(folder.path());
    let record = one_round(0);
    store(&memory, &record).unwrap();
    let episode = memory.episode(&record.id).unwrap();
    let read = || -> Result<Vec<f64>, MemoryError> {
        let telemetry = episode.telemetry(1)?;
        Ok(telemetry.values("v", 0..telemetry.rows())?)
    };
    assert_eq!(read().unwrap().len(), 100);
    let path = episode.folder().join("round-1.parquet");
    let whole = std::fs::read(&path).unwrap();
    for place in 0..whole.len() {
        let mut bytes = whole.clone();
        bytes[place] ^= 1;
        std::fs::write(&path, &bytes).unwrap();
        let error = read().expect_err(&format!("byte {place}"));
        assert!(error.to_string().contains("round-1.parquet"), "{error}");
    }
    std::fs::write(&path, &whole[..whole.len() - 1]).unwrap();
    assert!(read().is_err(), "cut off");
}

#[test]
fn the_catalogues_from_tables_and_from_folders_are_equal() {
    let folder = tempfile::tempdir().unwrap();
    let memory = memory(folder.path());
    let put = |numbers: std::ops::Range<usize>| {
        for number in numbers {
            let record = record(7, number);
            memory.begin(&record.id).unwrap().commit(&record).unwrap();
        }
    };
    let tables = memory.folder().join(".catalogue");
    let current = || std::fs::read_to_string(tables.join("current")).unwrap_or_default();
    let agrees = || {
        assert_eq!(
            contents(&memory.catalogue().unwrap()),
            from_folders(&memory)
        )
    };
    put(0..120);
    agrees();
    assert_eq!(current(), "1");
    // From the tables alone, then with additional episodes, and without deleted ones.
    agrees();
    put(120..130);
    agrees();
    for number in [3, 64, 119, 125] {
        memory.forget(&record(7, number).id).unwrap();
    }
    agrees();
    assert_eq!(current(), "1");
    put(3..4);
    agrees();
    put(130..240);
    agrees();
    assert_eq!(current(), "2");
    assert!(!tables.join("forgotten").exists());
    agrees();

    // Damaged tables are rewritten.
    let damages: [fn(&mut Vec<u8>); 2] = [
        |bytes| bytes.truncate(bytes.len() / 2),
        |bytes| {
            let middle = bytes.len() / 2;
            bytes[middle] ^= 1;
        },
    ];
    for damage in damages {
        for file in std::fs::read_dir(tables.join(current())).unwrap() {
            let path = file.unwrap().path();
            let path = tables.join(current()).join(path.file_name().unwrap());
            let mut bytes = std::fs::read(&path).unwrap();
            damage(&mut bytes);
            std::fs::write(&path, &bytes).unwrap();
            let before = current();
            agrees();
            assert_ne!(current(), before, "{} is broken", path.display());
            agrees();
        }
    }
}

#[test]
fn tables_answer_for_no_episode_that_was_changed_or_emptied_by_hand() {
    let folder = tempfile::tempdir().unwrap();
    let memory = memory(folder.path());
    let [first, second] = [one_round(1), one_round(2)];
    store(&memory, &first).unwrap();
    store(&memory, &second).unwrap();
    let known = || -> Vec<String> {
        let catalogue = memory.catalogue().unwrap();
        catalogue
            .episodes()
            .iter()
            .map(|row| row.id.clone())
            .collect()
    };
    // Read, and written to the tables by the second call at the latest.
    assert_eq!(known(), [&*first.id, &*second.id]);
    let place = |id: &str| memory.folder().join(id);
    // Another episode of the same name.
    std::fs::remove_dir_all(place(&first.id)).unwrap();
    let mut again = first.clone();
    again.task = "again".to_owned();
    store(&memory, &again).unwrap();
    let catalogue = memory.catalogue().unwrap();
    let found = (catalogue.episodes().iter()).find(|row| row.id == first.id);
    assert_eq!(found.unwrap().task, "again");
    // A copy that was interrupted.
    std::fs::remove_dir_all(place(&second.id)).unwrap();
    std::fs::create_dir(place(&second.id)).unwrap();
    let catalogue = memory.catalogue().unwrap();
    assert_eq!(catalogue.episodes().len(), 1);
    let omitted = catalogue.omitted_episodes();
    assert!(
        omitted.len() == 1 && omitted[0].contains(&second.id),
        "{omitted:?}"
    );
    // A copy under a name that no episode can have.
    std::fs::rename(place(&first.id), place("Küche 1")).unwrap();
    let omitted = memory.catalogue().unwrap().omitted_episodes().join("; ");
    assert!(omitted.contains("\"Küche 1\""), "{omitted}");
    assert_eq!(memory.ignored_episodes().unwrap().len(), 1);
}

#[test]
fn readers_see_only_complete_episodes() {
    const WRITERS: usize = 4;
    const EACH: usize = 8;
    let folder = tempfile::tempdir().unwrap();
    let memory = memory(folder.path());
    let done = AtomicBool::new(false);
    thread::scope(|scope| {
        let writers: Vec<_> = (0..WRITERS)
            .map(|writer| {
                let memory = &memory;
                scope.spawn(move || {
                    for number in writer * EACH..(writer + 1) * EACH {
                        store(memory, &one_round(number)).unwrap();
                        if number % EACH == 5 {
                            memory.forget(&one_round(number).id).unwrap();
                        }
                    }
                })
            })
            .collect();
        for _ in 0..2 {
            scope.spawn(|| {
                while !done.load(Ordering::Relaxed) {
                    memory.catalogue().unwrap();
                    for id in memory.episodes().unwrap() {
                        let read = memory.episode(&id).and_then(|episode| episode.record());
                        // The episode may have been deleted since.
                        assert!(read.is_ok() || memory.episode(&id).is_err(), "{read:?}");
                    }
                }
            });
        }
        let results: Vec<_> = writers
            .into_iter()
            .map(thread::ScopedJoinHandle::join)
            .collect();
        done.store(true, Ordering::Relaxed);
        assert!(results.iter().all(Result::is_ok));
    });
    assert_eq!(memory.episodes().unwrap().len(), WRITERS * (EACH - 1));
    assert!(memory.verify().unwrap().is_empty());
    assert_eq!(
        contents(&memory.catalogue().unwrap()),
        from_folders(&memory)
    );
}

/// Not an independent test: the child process of the next test, which runs until it is killed.
#[test]
fn child_writes_until_it_is_killed() {
    let Some(folder) = std::env::var_os(CHILD_MEMORY) else {
        return;
    };
    let memory = Memory::create(&PathBuf::from(folder)).unwrap();
    let first = memory.episodes().unwrap().len();
    for number in first.. {
        store(&memory, &one_round(number)).unwrap();
        if number % 5 == 4 {
            // The same name is used again at once, so that the number of episodes still gives the
            // next number.
            memory.forget(&one_round(number).id).unwrap();
            store(&memory, &one_round(number)).unwrap();
        }
        memory.catalogue().unwrap();
    }
}

#[test]
fn a_kill_loses_at_most_the_unfinished_episode() {
    let folder = tempfile::tempdir().unwrap();
    let memory = memory(folder.path());
    let mut least = 0;
    for kill in 0..12 {
        let mut child = Command::new(std::env::current_exe().unwrap())
            .args(["--exact", "store::child_writes_until_it_is_killed"])
            .env(CHILD_MEMORY, memory.folder())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        // The first child may write an episode, however slow the machine is.
        let patience = Instant::now() + Duration::from_secs(60);
        while kill == 0 && memory.episodes().unwrap().is_empty() {
            assert!(Instant::now() < patience, "nothing is written");
            thread::sleep(Duration::from_millis(5));
        }
        // The kills are spread over several episodes of the child.
        thread::sleep(Duration::from_micros(20_000 + 9_173 * kill));
        child.kill().unwrap();
        child.wait().unwrap();
        let faults: Vec<String> = memory
            .verify()
            .unwrap()
            .iter()
            .map(ToString::to_string)
            .collect();
        assert_eq!(faults, [""; 0], "kill {kill}");
        let count = memory.episodes().unwrap().len();
        // The child may have been deleting an episode.
        assert!(
            count + 1 >= least,
            "{count} episodes where there were {least}"
        );
        least = count;
        assert_eq!(
            contents(&memory.catalogue().unwrap()),
            from_folders(&memory)
        );
    }
    // The next writer removes the remains.
    store(&memory, &one_round(5000)).unwrap();
    assert_eq!(list_remains(&memory), [""; 0]);
}

fn names_in(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect()
}

/// Returns the entries of the folder for unfinished episodes, without the memory's own lock.
fn list_remains(memory: &Memory) -> Vec<String> {
    let mut names = names_in(&memory.folder().join(".new"));
    names.retain(|name| name != ".lock");
    names
}

fn value() -> impl Strategy<Value = Value> {
    let number = prop::num::f64::NORMAL | prop::num::f64::SUBNORMAL | prop::num::f64::ZERO;
    prop_oneof![
        number.prop_map(Value::Number),
        any::<String>().prop_map(Value::Text)
    ]
}

fn any_individual(place: usize) -> impl Strategy<Value = Individual> {
    let name = "[a-z]{1,4}:[A-Za-z_]{1,8}";
    let object = prop_oneof![
        name.prop_map(|name| name),
        (0..=place).prop_map(|n| format!("#{n}"))
    ];
    (
        name,
        prop::option::of((-1e12..1e12_f64, 0.0..1e6_f64)),
        prop::option::of(0..place.max(1)),
        prop::collection::btree_map(name, prop::collection::vec(object, 1..3), 0..3),
        prop::collection::btree_map(name, value(), 0..4),
    )
        .prop_map(
            move |(class, interval, parent, relations, values)| Individual {
                class,
                interval: interval.map(|(start, length)| [start, start + length]),
                parent: parent.filter(|_| place > 0),
                relations,
                values,
            },
        )
}

prop_compose! {
    fn any_record()(count in 1..6_usize)(
        individuals in (0..count).map(any_individual).collect::<Vec<_>>(),
        id in "[A-Za-z0-9-]{1,20}",
        task in any::<String>(),
        start in 0.0..4e9_f64,
        seed in any::<u64>(),
        imported in prop::option::of(any::<String>()),
    ) -> EpisodeRecord {
        EpisodeRecord {
            schema: wisch_memory::EPISODE_SCHEMA,
            id,
            task,
            interval: [start, start + 1.0],
            origin: imported.map_or(Origin::Simulated, Origin::Imported),
            program: "test".into(),
            seed,
            rounds: vec![start],
            individuals,
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn any_record_is_read_back_bit_by_bit(record in any_record()) {
        let folder = tempfile::tempdir().unwrap();
        let memory = memory(folder.path());
        memory.begin(&record.id).unwrap().commit(&record).unwrap();
        let read = memory.episode(&record.id).unwrap().record().unwrap();
        prop_assert_eq!(&read, &record);
        prop_assert_eq!(contents(&memory.catalogue().unwrap()), contents(&Catalogue::from_records([&record])));
    }
}
