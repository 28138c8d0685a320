//! Contents of a NEEM, and the round trip of an export and import.

mod laws;
mod stored;

use super::dump::Documents;
use super::*;
use crate::observations::tests::example_observations;
use crate::record::{EPISODE_SCHEMA, EpisodeRecord, Individual, Origin, Value};
use crate::remember::{
    EpisodeHeader, GoalOutcome, RememberedGoal, RememberedPart, RememberedStep, StepKind,
    remember_goal,
};
use bson::{DateTime, RawDocumentBuf};
use std::collections::BTreeMap;
use std::fs::File;
use std::io::BufReader;
use wisch::geometry::Pose;

fn individual(class: &str, interval: [f64; 2], parent: usize) -> Individual {
    Individual {
        class: class.to_owned(),
        interval: Some(interval),
        parent: Some(parent),
        relations: BTreeMap::new(),
        values: BTreeMap::new(),
    }
}

fn related(mut to: Individual, relations: &[(&str, &str)]) -> Individual {
    for (property, object) in relations {
        let objects = to.relations.entry((*property).to_owned()).or_default();
        objects.push((*object).to_owned());
    }
    to
}

fn valued(mut to: Individual, values: &[(&str, f64)]) -> Individual {
    for (property, value) in values {
        to.values
            .insert((*property).to_owned(), Value::Number(*value));
    }
    to
}

/// Returns an episode with one round, in which a human pushes the robot during a stroke.
fn pushed_episode() -> EpisodeRecord {
    let start = 1_767_225_600.0;
    let mut individuals = vec![
        individual("semco:WipingEpisode", [start, start + 9.0], 0),
        related(
            valued(
                individual("semco:WipingAction", [start, start + 9.0], 0),
                &[("semco:performance", 0.82)],
            ),
            &[
                ("semco:usesTool", "semco:sponge"),
                ("semco:actsOnSurface", "semco:chopping_board"),
                ("soma:isPerformedBy", "semco:humanoid"),
                ("dul:executesTask", "#2"),
                ("soma:hasExecutionState", "soma:ExecutionState_Succeeded"),
            ],
        ),
        individual("semco:Collecting", [0.0; 2], 0),
        individual("semco:WipingRound", [start, start + 9.0], 1),
        individual("semco:Stroke", [start + 2.0, start + 6.0], 3),
        related(
            valued(
                individual("semco:HumanCollision", [start + 3.25, start + 3.75], 4),
                &[("semco:peakForce", 31.5), ("semco:edgeDistance", 0.04)],
            ),
            &[
                ("dul:isClassifiedBy", "semco:collision_concept"),
                ("dul:hasParticipant", "semco:human"),
                ("dul:hasParticipant", "semco:humanoid"),
            ],
        ),
    ];
    individuals[0].parent = None;
    (individuals[2].parent, individuals[2].interval) = (None, None);
    individuals[3].values.insert(
        "semco:verdict".to_owned(),
        Value::Text("wipe again".to_owned()),
    );
    EpisodeRecord {
        schema: EPISODE_SCHEMA,
        id: "20260101-crumbs".to_owned(),
        task: "crumbs".to_owned(),
        interval: [start, start + 9.0],
        origin: Origin::Simulated,
        program: "wisch 0.1.0".to_owned(),
        seed: u64::MAX,
        rounds: vec![start],
        individuals,
    }
}

fn meta() -> NeemMeta {
    NeemMeta {
        name: "Crumbs".to_owned(),
        description: "A board is wiped".to_owned(),
        created_by: "nobody".to_owned(),
        created_at: 1_767_300_000.0,
        keywords: vec!["wiping".to_owned()],
        url: String::new(),
        activity: [
            "Wiping".to_owned(),
            "https://wisch-project.org/ont/semco.owl#Wiping".to_owned(),
        ],
        environment: "Kitchen".to_owned(),
        agent: "humanoid".to_owned(),
        image: String::new(),
    }
}

const SEMCO: &str = "https://wisch-project.org/ont/semco.owl#";
const DUL: &str = "http://www.ontologydesignpatterns.org/ont/dul/DUL.owl#";

fn documents(neem: &std::path::Path, collection: &str) -> Vec<RawDocumentBuf> {
    let file = File::open(collection_file(neem, collection)).unwrap();
    Documents::new(BufReader::new(file))
        .collect::<Result<_, _>>()
        .unwrap()
}

fn texts(document: &RawDocumentBuf, field: &str) -> Vec<String> {
    let values = document.get_array(field).into_iter().flatten();
    let texts = values.map(|value| value.unwrap().as_str().unwrap().to_owned());
    texts.collect()
}

#[test]
fn an_export_is_imported_unchanged() {
    let folder = tempfile::tempdir().unwrap();
    let neem = folder.path().join("neem");
    let mut second = pushed_episode();
    second.id = "other".to_owned();
    second.origin = Origin::Imported("lab.mcap".to_owned());
    let mut writer = NeemWriter::create(&neem, &meta(), &NeemConfig::default()).unwrap();
    for record in [&pushed_episode(), &second] {
        writer.episode(record).unwrap();
    }
    assert!(
        !neem.exists(),
        "the folder appears only when it is complete"
    );
    let report = writer.finish().unwrap();
    assert_eq!(report.episodes, 2);
    assert_eq!(report.triples, documents(&neem, "triples").len() as u64);
    assert_eq!(import(&neem).unwrap(), [pushed_episode(), second]);
    assert!(documents(&neem, "inferred").is_empty());
}

#[test]
fn the_steps_of_a_goal_are_exported_and_imported_unchanged() {
    let header = EpisodeHeader {
        id: "20260101-kitchen".to_owned(),
        task: "kitchen".to_owned(),
        start: 1_767_225_600.0,
        target: 0.9,
        seed: 3,
        program: "by hand".to_owned(),
    };
    let step = RememberedStep {
        kind: StepKind::Wipe,
        words: "collect breadcrumbs on table with brush".to_owned(),
        things: ["brush", "breadcrumbs", "table"].map(|name| Some(name.to_owned())),
        times: [0.0, 30.0, 42.5],
        is_met: Some(GoalOutcome::Unknown),
        serves: vec![0],
        episode: Some("20260101-crumbs".to_owned()),
    };
    let part = |outcome| RememberedPart {
        part: "(collected breadcrumbs table)".to_owned(),
        outcome,
        why: None,
    };
    let goal = |outcome| RememberedGoal {
        goal: "(collected breadcrumbs table)".to_owned(),
        robot: Some("arm7".to_owned()),
        expected: 30.0,
        clock_duration: 5.0,
        parts: vec![part(outcome)],
        steps: vec![step.clone()],
    };
    let record = remember_goal(&header, &goal(GoalOutcome::Unknown));
    assert_eq!(record.interval[1] - record.interval[0], 42.5);
    let state = "soma:hasExecutionState";
    let is_stated = |one: &Individual| one.relations.contains_key(state);
    assert!(
        !record.individuals.iter().any(is_stated),
        "it cannot be told"
    );
    assert_eq!(records(triples(&record).unwrap()).unwrap(), [record]);
    let met = remember_goal(&header, &goal(GoalOutcome::Met));
    assert_eq!(
        met.individuals[1].relations[state],
        ["soma:ExecutionState_Succeeded"]
    );
}

#[test]
fn documents_carry_the_closures_that_readers_match() {
    let folder = tempfile::tempdir().unwrap();
    let neem = folder.path().join("neem");
    let mut writer = NeemWriter::create(&neem, &meta(), &NeemConfig::default()).unwrap();
    writer.episode(&pushed_episode()).unwrap();
    writer.finish().unwrap();
    let all = documents(&neem, "triples");
    let event = format!("{SEMCO}HumanCollision_20260101-crumbs-5");
    let find = |predicate: &str| -> Vec<&RawDocumentBuf> {
        let of_event = |document: &&RawDocumentBuf| {
            document.get_str("s").ok() == Some(&event)
                && document.get_str("p").ok() == Some(predicate)
        };
        all.iter().filter(of_event).collect()
    };
    let types = find("http://www.w3.org/1999/02/22-rdf-syntax-ns#type");
    let above = texts(types[0], "o*");
    assert_eq!(above[0], format!("{SEMCO}HumanCollision"));
    for class in [format!("{SEMCO}Collision"), format!("{DUL}Event")] {
        assert!(above.contains(&class), "{class}");
    }
    let classified = find(&format!("{DUL}isClassifiedBy"));
    assert_eq!(
        texts(classified[0], "p*"),
        ["isClassifiedBy", "associatedWith"].map(|local| format!("{DUL}{local}"))
    );
    assert_eq!(texts(classified[0], "o*"), Vec::<String>::new());
    let time = classified[0].get_document("scope").unwrap();
    let time = time.get_document("time").unwrap();
    assert_eq!(time.get_f64("since").ok(), Some(1_767_225_603.25));
    assert_eq!(time.get_f64("until").ok(), Some(f64::INFINITY));
    assert!(
        all.iter()
            .all(|document| document.get_str("graph").ok() == Some(GRAPH))
    );

    // The force as a region, and the event that has it.
    let force = &find(&format!("{SEMCO}hasPeakForce"))[0];
    let region = force.get_str("o").unwrap();
    let value = all.iter().find(|document| {
        document.get_str("s").ok() == Some(region)
            && document.get_str("p").ok()
                == Some("http://www.ease-crc.org/ont/SOMA.owl#hasForceValue")
    });
    assert_eq!(value.unwrap().get_f64("o").ok(), Some(31.5));
    let whole = all
        .iter()
        .find(|document| document.get_str("o").ok() == Some(&event))
        .unwrap();
    assert_eq!(
        whole.get_str("p").ok(),
        Some(&*format!("{DUL}hasConstituent"))
    );
    assert_eq!(
        whole.get_str("s").ok(),
        Some(&*format!("{SEMCO}Stroke_20260101-crumbs-4"))
    );

    // A timeline shows only tasks with exactly one underscore.
    let task = all
        .iter()
        .find(|document| document.get_str("p").ok() == Some(&*format!("{DUL}executesTask")))
        .unwrap();
    assert_eq!(task.get_str("o").unwrap().matches('_').count(), 1);
}

#[test]
fn poses_are_thinned_frame_by_frame() {
    let folder = tempfile::tempdir().unwrap();
    let neem = folder.path().join("neem");
    let config = NeemConfig { tf_rate_hz: 10.0 };
    let mut writer = NeemWriter::create(&neem, &meta(), &config).unwrap();
    for step in 0..1000 {
        for frame in ["sponge", "base"] {
            let time = 1_767_225_600.0 + 1e-3 * f64::from(step);
            let sample = FrameSample {
                time,
                frame,
                parent: "world",
                parent_from_frame: Pose::translation(1.0, 2.0, f64::from(step)),
            };
            writer.frame(&sample).unwrap();
        }
    }
    let wrench = WrenchSample {
        time: 1_767_225_600.062_5,
        frame: "sponge",
        episode: "20260101-crumbs",
        topic: "wrench/external",
        force: [0.0, 0.5, -10.0],
        torque: Some([0.0; 3]),
    };
    writer.wrench(&wrench).unwrap();
    let report = writer.finish().unwrap();
    assert_eq!((report.poses, report.wrenches), (20, 1));
    let poses = documents(&neem, "tf");
    let sponge = poses
        .iter()
        .filter(|pose| pose.get_str("child_frame_id").ok() == Some("sponge"));
    for (number, pose) in sponge.enumerate() {
        let header = pose.get_document("header").unwrap();
        let stamp = 1_767_225_600_000 + 100 * number as i64;
        assert_eq!(
            header.get_datetime("stamp").unwrap(),
            DateTime::from_millis(stamp)
        );
        assert_eq!(header.get_str("frame_id").ok(), Some("world"));
        let transform = pose.get_document("transform").unwrap();
        let translation = transform.get_document("translation").unwrap();
        assert_eq!(translation.get_f64("z").ok(), Some(100.0 * number as f64));
        assert_eq!(
            transform
                .get_document("rotation")
                .unwrap()
                .get_f64("w")
                .ok(),
            Some(1.0)
        );
    }
    let wrench = &documents(&neem, "wrench")[0];
    let header = wrench.get_document("header").unwrap();
    assert_eq!(header.get_f64("time").ok(), Some(1_767_225_600.062_5));
    assert_eq!(wrench.get_str("episode").ok(), Some("20260101-crumbs"));
    let force = wrench
        .get_document("wrench")
        .unwrap()
        .get_document("force")
        .unwrap();
    assert_eq!(force.get_f64("z").ok(), Some(-10.0));
}

/// Checksums of the files of an export. Those of triples and annotations change with the ontology; the others were
/// recorded with an earlier BSON writer, except those of the observations and wrenches.
const RECORDED: [(&str, u32); 6] = [
    ("triples", 2_181_875_530),
    ("annotations", 3_054_466_018),
    ("inferred", 0),
    ("tf", 2_541_484_127),
    ("wrench", 3_417_302_854),
    ("observation", 3_666_954_012),
];

#[test]
fn an_export_has_the_recorded_checksums() {
    let folder = tempfile::tempdir().unwrap();
    let neem = folder.path().join("neem");
    let mut writer = NeemWriter::create(&neem, &meta(), &NeemConfig::default()).unwrap();
    writer.episode(&pushed_episode()).unwrap();
    let start = pushed_episode().interval[0];
    for step in 0..20 {
        let time = start + 0.1 * f64::from(step);
        let angle = 0.05 * f64::from(step);
        let frame = FrameSample {
            time,
            frame: "sponge",
            parent: "world",
            parent_from_frame: Pose::translation(0.1, -angle, 0.75),
        };
        writer.frame(&frame).unwrap();
        let wrench = WrenchSample {
            time,
            frame: "sponge",
            episode: &pushed_episode().id,
            topic: "wrench/external",
            force: [angle, 0.5, -10.0],
            torque: (step % 2 == 0).then_some([0.25, angle, 0.0]),
        };
        writer.wrench(&wrench).unwrap();
    }
    let round = NeemRound {
        episode: &pushed_episode().id,
        number: 1,
        interval: pushed_episode().interval,
        surface: "chopping_board",
    };
    writer
        .observations(&round, &example_observations())
        .unwrap();
    writer.finish().unwrap();
    let written = RECORDED.map(|(collection, _)| {
        let bytes = std::fs::read(collection_file(&neem, collection)).unwrap();
        (collection, crc32fast::hash(&bytes))
    });
    assert_eq!(written, RECORDED);
}

#[test]
fn invalid_input_is_refused_and_leaves_no_folder() {
    let folder = tempfile::tempdir().unwrap();
    let neem = folder.path().join("neem");
    let create = |rate| NeemWriter::create(&neem, &meta(), &NeemConfig { tf_rate_hz: rate });
    assert!(matches!(create(0.0), Err(NeemError::Rate { .. })));
    let mut writer = create(f64::INFINITY).unwrap();
    writer.episode(&pushed_episode()).unwrap();
    assert!(matches!(
        writer.episode(&pushed_episode()),
        Err(NeemError::Twice { .. })
    ));
    let mut strange = pushed_episode();
    strange.id = "strange".to_owned();
    strange.individuals[4].class = "semka:Stroke".to_owned();
    let error = writer.episode(&strange).unwrap_err().to_string();
    assert!(
        error.contains("semka") && error.contains("semco"),
        "{error}"
    );
    strange.individuals[4].class = "semco:A Stroke".to_owned();
    assert!(matches!(
        writer.episode(&strange),
        Err(NeemError::Name { .. })
    ));
    strange.individuals[4].class = "semco:Stroke".to_owned();
    let timed = ("dul:hasTimeInterval".to_owned(), vec!["#3".to_owned()]);
    strange.individuals[4].relations.extend([timed]);
    assert!(matches!(
        writer.episode(&strange),
        Err(NeemError::Reserved { .. })
    ));
    let nowhere = FrameSample {
        time: f64::NAN,
        frame: "sponge",
        parent: "world",
        parent_from_frame: Pose::identity(),
    };
    assert!(matches!(
        writer.frame(&nowhere),
        Err(NeemError::Sample { .. })
    ));
    drop(writer);
    assert_eq!(folder.path().read_dir().unwrap().count(), 0);
    std::fs::create_dir(&neem).unwrap();
    assert!(matches!(create(1.0), Err(NeemError::Exists { .. })));
}

#[test]
fn an_incomplete_episode_is_an_error() {
    let all = triples(&pushed_episode()).unwrap();
    assert_eq!(records(all.clone()).unwrap(), [pushed_episode()]);
    let mut incomplete = 0;
    for missing in 0..all.len() {
        let mut some = all.clone();
        some.remove(missing);
        match records(some) {
            Ok(records) if records == [pushed_episode()] => {}
            Ok(records) => {
                // Without a relation, value or parent, the result is another valid episode.
                for record in records {
                    record.check().unwrap();
                }
            }
            Err(_) => incomplete += 1,
        }
    }
    // The record has six fields; each interval has a type and two ends.
    assert!(incomplete >= 6 + 6 + 10, "{incomplete}");
}

#[test]
fn the_order_of_subjects_does_not_matter() {
    let mut all = triples(&pushed_episode()).unwrap();
    all.sort_by(|a, b| b.subject.cmp(&a.subject));
    assert_eq!(records(all).unwrap(), [pushed_episode()]);
}

#[test]
fn a_stated_relation_that_is_also_derived_is_kept() {
    let mut record = pushed_episode();
    let parts = ["#5", "semco:sponge"].map(str::to_owned).to_vec();
    let relations = &mut record.individuals[4].relations;
    relations.insert("dul:hasConstituent".to_owned(), parts);
    assert_eq!(records(triples(&record).unwrap()).unwrap(), [record]);
}
