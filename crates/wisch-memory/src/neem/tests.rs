use super::bson::{Bson, Document, Documents};
use super::*;
use crate::ontology::Ontology;
use crate::record::{EPISODE_SCHEMA, EpisodeRecord, Individual, Origin, Value};
use crate::store::Memory;
use crate::telemetry::{Mark, TelemetryHead};
use proptest::prelude::*;
use std::collections::BTreeMap;
use std::fs::File;
use std::io::BufReader;
use wisch::follow::Phase;
use wisch::geometry::{Pose, Vector3};
use wisch::robot::RobotModel;

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

/// One round in which a human bumps into a stroke.
fn bumped() -> EpisodeRecord {
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

fn documents(neem: &std::path::Path, collection: &str) -> Vec<Document> {
    let file = File::open(collection_file(neem, collection)).unwrap();
    Documents::new(BufReader::new(file))
        .collect::<Result<_, _>>()
        .unwrap()
}

fn texts(document: &Document, field: &str) -> Vec<String> {
    let Some(Bson::Array(values)) = document.get(field) else {
        return Vec::new();
    };
    let text = |value: &Bson| match value {
        Bson::Text(text) => text.clone(),
        other => panic!("{other:?}"),
    };
    values.iter().map(text).collect()
}

#[test]
fn what_is_exported_is_imported() {
    let folder = tempfile::tempdir().unwrap();
    let neem = folder.path().join("neem");
    let mut second = bumped();
    second.id = "other".to_owned();
    second.origin = Origin::Imported("lab.mcap".to_owned());
    let mut writer = NeemWriter::create(&neem, &meta(), &NeemConfig::default()).unwrap();
    for record in [&bumped(), &second] {
        writer.episode(record).unwrap();
    }
    assert!(!neem.exists(), "it appears whole or not at all");
    let report = writer.finish().unwrap();
    assert_eq!(report.episodes, 2);
    assert_eq!(report.triples, documents(&neem, "triples").len() as u64);
    assert_eq!(import(&neem).unwrap(), [bumped(), second]);
    assert!(documents(&neem, "inferred").is_empty());
}

#[test]
fn documents_carry_the_closures_that_readers_match() {
    let folder = tempfile::tempdir().unwrap();
    let neem = folder.path().join("neem");
    let mut writer = NeemWriter::create(&neem, &meta(), &NeemConfig::default()).unwrap();
    writer.episode(&bumped()).unwrap();
    writer.finish().unwrap();
    let all = documents(&neem, "triples");
    let event = format!("{SEMCO}HumanCollision_20260101-crumbs-5");
    let said = |predicate: &str| -> Vec<&Document> {
        let of_event = |document: &&Document| {
            document.text("s") == Some(&event) && document.text("p") == Some(predicate)
        };
        all.iter().filter(of_event).collect()
    };
    let types = said("http://www.w3.org/1999/02/22-rdf-syntax-ns#type");
    let above = texts(types[0], "o*");
    assert_eq!(above[0], format!("{SEMCO}HumanCollision"));
    for class in [format!("{SEMCO}Collision"), format!("{DUL}Event")] {
        assert!(above.contains(&class), "{class}");
    }
    let classified = said(&format!("{DUL}isClassifiedBy"));
    assert_eq!(
        texts(classified[0], "p*"),
        ["isClassifiedBy", "associatedWith"].map(|local| format!("{DUL}{local}"))
    );
    assert_eq!(texts(classified[0], "o*"), Vec::<String>::new());
    let time = classified[0].document("scope").unwrap();
    let time = time.document("time").unwrap();
    assert_eq!(time.number("since"), Some(1_767_225_603.25));
    assert_eq!(time.number("until"), Some(f64::INFINITY));
    assert!(
        all.iter()
            .all(|document| document.text("graph") == Some(GRAPH))
    );

    // Its force as a region, and the whole that has it.
    let force = &said(&format!("{SEMCO}hasPeakForce"))[0];
    let region = force.text("o").unwrap();
    let value = all.iter().find(|document| {
        document.text("s") == Some(region)
            && document.text("p") == Some("http://www.ease-crc.org/ont/SOMA.owl#hasForceValue")
    });
    assert_eq!(value.unwrap().number("o"), Some(31.5));
    let whole = all
        .iter()
        .find(|document| document.text("o") == Some(&event))
        .unwrap();
    assert_eq!(whole.text("p"), Some(&*format!("{DUL}hasConstituent")));
    assert_eq!(
        whole.text("s"),
        Some(&*format!("{SEMCO}Stroke_20260101-crumbs-4"))
    );

    // A timeline shows only tasks with exactly one underscore.
    let task = all
        .iter()
        .find(|document| document.text("p") == Some(&*format!("{DUL}executesTask")))
        .unwrap();
    assert_eq!(task.text("o").unwrap().matches('_').count(), 1);
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
        time: 1_767_225_600.0625,
        frame: "sponge",
        topic: "wrench/external",
        force: [0.0, 0.5, -10.0],
        torque: [0.0; 3],
    };
    writer.wrench(&wrench).unwrap();
    let report = writer.finish().unwrap();
    assert_eq!((report.poses, report.wrenches), (20, 1));
    let poses = documents(&neem, "tf");
    let sponge = poses
        .iter()
        .filter(|pose| pose.text("child_frame_id") == Some("sponge"));
    for (number, pose) in sponge.enumerate() {
        let header = pose.document("header").unwrap();
        let stamp = 1_767_225_600_000 + 100 * number as i64;
        assert_eq!(header.get("stamp"), Some(&Bson::Date(stamp)));
        assert_eq!(header.text("frame_id"), Some("world"));
        let transform = pose.document("transform").unwrap();
        let translation = transform.document("translation").unwrap();
        assert_eq!(translation.number("z"), Some(100.0 * number as f64));
        assert_eq!(
            transform.document("rotation").unwrap().number("w"),
            Some(1.0)
        );
    }
    let wrench = &documents(&neem, "wrench")[0];
    let header = wrench.document("header").unwrap();
    assert_eq!(header.number("time"), Some(1_767_225_600.0625));
    let force = wrench
        .document("wrench")
        .unwrap()
        .document("force")
        .unwrap();
    assert_eq!(force.number("z"), Some(-10.0));
}

#[test]
fn wrong_input_is_refused_and_leaves_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let neem = folder.path().join("neem");
    let create = |rate| NeemWriter::create(&neem, &meta(), &NeemConfig { tf_rate_hz: rate });
    assert!(matches!(create(0.0), Err(NeemError::Rate { .. })));
    let mut writer = create(f64::INFINITY).unwrap();
    writer.episode(&bumped()).unwrap();
    assert!(matches!(
        writer.episode(&bumped()),
        Err(NeemError::Twice { .. })
    ));
    let mut strange = bumped();
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
fn half_an_episode_is_an_error_not_another_episode() {
    let all = triples(&bumped()).unwrap();
    assert_eq!(records(all.clone()).unwrap(), [bumped()]);
    let mut incomplete = 0;
    for missing in 0..all.len() {
        let mut some = all.clone();
        some.remove(missing);
        match records(some) {
            Ok(records) if records == [bumped()] => {}
            Ok(records) => {
                // A relation, value or parent less: that is another episode, but a good one.
                for record in records {
                    record.check().unwrap();
                }
            }
            Err(_) => incomplete += 1,
        }
    }
    // Six fields of the record, a type and two ends of an interval each.
    assert!(incomplete >= 6 + 6 + 10, "{incomplete}");
}

#[test]
fn order_of_triples_between_subjects_does_not_matter() {
    let mut all = triples(&bumped()).unwrap();
    all.sort_by(|a, b| b.subject.cmp(&a.subject));
    assert_eq!(records(all).unwrap(), [bumped()]);
}

/// A name with prefix, known or not.
fn names() -> impl Strategy<Value = String> {
    let known: Vec<String> = Ontology::shipped()
        .terms()
        .map(|(name, _)| name.to_owned())
        .collect();
    const OTHERS: [&str; 4] = [
        "rdf:type",
        "owl:NamedIndividual",
        "rdfs:label",
        "owl:sameAs",
    ];
    prop_oneof![
        4 => prop::sample::select(known),
        1 => prop::sample::select(&OTHERS[..]).prop_map(str::to_owned),
        2 => "(semco|soma|justin):[A-Za-z_#/-]{1,5}",
    ]
}

fn numbers() -> impl Strategy<Value = f64> {
    prop_oneof![any::<f64>(), -1e3..1e3, Just(-0.0)].prop_filter("finite", |x| x.is_finite())
}

fn intervals() -> impl Strategy<Value = [f64; 2]> {
    [numbers(), numbers()].prop_map(|[a, b]| [a.min(b), a.max(b)])
}

fn individuals() -> impl Strategy<Value = Vec<Individual>> {
    let text = prop_oneof![".{0,6}", Just(format!("{SEMCO}sponge"))];
    let value = prop_oneof![
        numbers().prop_map(Value::Number),
        text.prop_map(Value::Text)
    ];
    let object = prop_oneof![
        names().prop_map(Ok),
        any::<prop::sample::Index>().prop_map(Err)
    ];
    // Those are said by parent and interval.
    let relation = names().prop_filter("free", |name| {
        ![triples::STEP_OF, triples::HAS_INTERVAL].contains(&name.as_str())
    });
    let relations =
        prop::collection::btree_map(relation, prop::collection::vec(object, 1..3), 0..3);
    let values = prop::collection::btree_map(names(), value, 0..3);
    let parent = prop::option::of(any::<prop::sample::Index>());
    let class = names().prop_filter("a class", |name| name != triples::NAMED);
    let one = (
        class,
        prop::option::of(intervals()),
        parent,
        relations,
        values,
    );
    prop::collection::vec(one, 0..6).prop_map(|all| {
        let count = all.len();
        let numbered = all.into_iter().enumerate();
        numbered
            .map(|(place, (class, interval, parent, relations, values))| {
                let objects = |objects: Vec<Result<String, prop::sample::Index>>| {
                    let named = |object: Result<String, prop::sample::Index>| match object {
                        Ok(name) => name,
                        Err(index) => format!("#{}", index.index(count)),
                    };
                    objects.into_iter().map(named).collect()
                };
                Individual {
                    class,
                    interval,
                    parent: parent.filter(|_| place > 0).map(|index| index.index(place)),
                    relations: relations
                        .into_iter()
                        .map(|(property, related)| (property, objects(related)))
                        .collect(),
                    values,
                }
            })
            .collect()
    })
}

fn episodes() -> impl Strategy<Value = EpisodeRecord> {
    let origin = prop_oneof![Just(Origin::Simulated), ".{0,6}".prop_map(Origin::Imported)];
    let rounds = prop::collection::vec(numbers(), 0..3);
    let head = ("[A-Za-z0-9-]{1,8}", ".{0,6}", intervals(), origin);
    (head, ".{0,6}", any::<u64>(), rounds, individuals()).prop_map(
        |((id, task, interval, origin), program, seed, rounds, individuals)| EpisodeRecord {
            schema: EPISODE_SCHEMA,
            id,
            task,
            interval,
            origin,
            program,
            seed,
            rounds,
            individuals,
        },
    )
}

proptest! {
    #[test]
    fn records_and_triples_are_each_other_turned_round(record in episodes()) {
        prop_assume!(record.check().is_ok());
        let through_documents = |triple: &Triple| {
            let document = document::Closures::default().document([0; 12], triple).unwrap();
            document::triple(&document).unwrap()
        };
        let there = triples(&record).unwrap();
        let back: Vec<Triple> = there.iter().map(through_documents).collect();
        prop_assert_eq!(&there, &back);
        prop_assert_eq!(records(back).unwrap(), [record]);
    }
}

/// A memory with [`bumped`] in it: one second at 1 kHz of an arm that turns about its first joint.
fn stored(folder: &std::path::Path, robot: &RobotModel) -> Memory {
    let memory = Memory::create(&folder.join("episodes")).unwrap();
    let writer = memory.begin(&bumped().id).unwrap();
    let joints: Vec<String> = (0..robot.dof())
        .map(|variable| robot.variable(variable).name.clone())
        .collect();
    let origin =
        serde_json::json!({"position": [0.0, 0.0, 0.0], "quaternion": [0.0, 0.0, 0.0, 1.0]});
    let mut tool = origin.clone();
    tool["position"] = serde_json::json!([0.0, 0.0, 0.25]);
    let tip = &robot.links().last().unwrap().name;
    let scene = serde_json::json!({
        "schema": 1, "robot": "arm7", "world_from_root": origin, "tip": tip, "tip_from_tool": tool,
        "tool": "sponge", "surface": "chopping_board", "world_from_surface": origin,
    });
    let mut columns: Vec<String> = joints
        .iter()
        .map(|joint| format!("position/{joint}"))
        .collect();
    columns.extend(["x", "y", "z", "qx", "qy", "qz", "qw"].map(|part| format!("measured/{part}")));
    columns.extend(["fx", "fy", "fz", "mx", "my", "mz"].map(|part| format!("external/{part}")));
    let head = TelemetryHead {
        joints: joints.clone(),
        notes: [("scene".to_owned(), scene.to_string())].into(),
    };
    let mut log = writer.telemetry_with_columns(1, head, &columns).unwrap();
    let mark = Mark {
        motion: 0,
        phase: Phase::Transfer,
    };
    for step in 0..1000 {
        let time = 1e-3 * f64::from(step);
        let mut row = vec![0.0; columns.len()];
        row[0] = time;
        row[joints.len()..].copy_from_slice(&[
            0.5, 0.25, time, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -8.0, 0.0, 0.0, 0.0,
        ]);
        log.push(time, mark, row).unwrap();
    }
    log.finish().unwrap();
    writer.commit(&bumped()).unwrap();
    memory
}

fn arm() -> RobotModel {
    let urdf = include_str!("../../../../robots/arm7.urdf");
    RobotModel::from_urdf("arm7.urdf", urdf, &mut |mesh| Err(mesh.to_owned())).unwrap()
}

#[test]
fn a_stored_episode_brings_its_poses_and_wrenches() {
    let folder = tempfile::tempdir().unwrap();
    let robot = arm();
    let memory = stored(folder.path(), &robot);
    let episode = memory.episode(&bumped().id).unwrap();
    let export = |name, poses| {
        let neem = folder.path().join(name);
        let mut writer = NeemWriter::create(&neem, &meta(), &NeemConfig::default()).unwrap();
        writer.stored(&episode, poses).unwrap();
        (writer.finish().unwrap(), neem)
    };
    let (report, by_tool) = export("tool", PoseSource::Tool);
    assert_eq!((report.poses, report.wrenches), (10, 1000));
    let (report, by_robot) = export("robot", PoseSource::Robot(&robot));
    let frames = robot.links().len() as u64 + 3;
    assert_eq!((report.poses, report.wrenches), (10 * frames, 1000));
    for neem in [&by_tool, &by_robot] {
        assert_eq!(import(neem).unwrap(), [bumped()]);
    }
    let sponge = |neem| -> Vec<Document> {
        let mut poses = documents(neem, "tf");
        poses.retain(|pose| pose.text("child_frame_id") == Some("sponge"));
        poses
    };
    let position = |pose: &Document| {
        let translation = pose.document("transform").unwrap().document("translation");
        ["x", "y", "z"].map(|axis| translation.unwrap().number(axis).unwrap())
    };
    let stamp = |pose: &Document| pose.document("header").unwrap().get("stamp").cloned();
    for (number, pose) in sponge(&by_tool).iter().enumerate() {
        let [x, y, z] = position(pose);
        assert_eq!([x, y], [0.5, 0.25]);
        // Telemetry keeps 32 bits of a pose.
        assert!((z - 0.1 * number as f64).abs() < 1e-6, "{z}");
    }
    for (number, pose) in sponge(&by_robot).iter().enumerate() {
        let mut q = vec![0.0; robot.dof()];
        q[0] = f64::from(0.1_f32 * number as f32);
        let kinematics = robot.forward_kinematics(&q).unwrap();
        let tip = robot.link(&robot.links().last().unwrap().name).unwrap();
        let expected = kinematics.world_from_link(tip) * Pose::translation(0.0, 0.0, 0.25);
        let error = Vector3::from(position(pose)) - expected.translation.vector;
        assert!(error.norm() < 1e-6, "{error}");
        let milliseconds = 1_767_225_600_000 + 100 * number as i64;
        assert_eq!(stamp(pose), Some(Bson::Date(milliseconds)));
    }
}

#[test]
fn telemetry_of_another_robot_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let memory = stored(folder.path(), &arm());
    let urdf = include_str!("../../../../robots/arm6.urdf");
    let other = RobotModel::from_urdf("arm6.urdf", urdf, &mut |mesh| Err(mesh.to_owned())).unwrap();
    let neem = folder.path().join("neem");
    let mut writer = NeemWriter::create(&neem, &meta(), &NeemConfig::default()).unwrap();
    let episode = memory.episode(&bumped().id).unwrap();
    let refused = writer.stored(&episode, PoseSource::Robot(&other));
    assert!(matches!(refused, Err(NeemError::Frames(_))), "{refused:?}");
}
