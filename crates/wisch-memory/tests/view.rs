//! Views of a memory with a tool that slides along x at 0.1 m/s.

use tempfile::TempDir;
use wisch::follow::Phase;
use wisch::geometry::{Pose, Vector3};
use wisch::run::{SampleStatus, TelemetrySample, Wrench};
use wisch_memory::ask::Term;
use wisch_memory::view::{Colour, DirtState, Emphasis, Figure, MAX_POSES, View, ViewError, gather};
use wisch_memory::{
    Catalogue, EPISODE_SCHEMA, EpisodeRecord, Individual, Memory, Origin, RobotText, RoundScene,
};

const ID: &str = "20261122-010000-abcd";
/// Start of the episode [s since 1970].
const BEGIN: f64 = 1000.0;
const SPEED: f64 = 0.1;
const PERIOD: f64 = 0.1;
const SAMPLES: usize = 101;
/// Tolerance: telemetry stores joints in single precision.
const TOLERANCE: f64 = 1e-6;

const SLIDER: &str = r#"<robot name="slider"><link name="root"/>
    <link name="tip"><collision><origin xyz="0 0 0.5"/><geometry><box size="0.1 0.2 0.3"/></geometry></collision></link>
    <joint name="rail" type="prismatic"><parent link="root"/><child link="tip"/><axis xyz="1 0 0"/>
    <limit lower="-5" upper="5" effort="10" velocity="1"/></joint></robot>"#;

const BEFORE: &str = "particle,x_m,y_m,fate,edge\n0,0.1,0.05,on_surface,\n1,0.2,0,on_surface,\n";
const AFTER: &str = "particle,x_m,y_m,fate,edge\n0,0.1,0.05,absorbed,\n1,0.3,0,on_surface,\n";

fn individual(class: &str, parent: Option<usize>, [from, to]: [f64; 2]) -> Individual {
    Individual {
        class: format!("semco:{class}"),
        interval: Some([BEGIN + from, BEGIN + to]),
        parent,
        relations: [].into(),
        values: [].into(),
    }
}

fn record() -> EpisodeRecord {
    let all = [0.0, 10.0];
    let mut individuals = vec![
        individual("WipingEpisode", None, all),
        individual("WipingAction", Some(0), all),
        individual("WipingRound", Some(1), all),
        individual("Stroke", Some(2), [1.0, 8.0]),
        individual("HumanCollision", Some(3), [3.0, 5.0]),
    ];
    let crumbs = vec!["semco:breadcrumbs".to_owned()];
    individuals[1].relations = [("semco:removesMedium".to_owned(), crumbs)].into();
    EpisodeRecord {
        schema: EPISODE_SCHEMA,
        id: ID.to_owned(),
        task: "slide".to_owned(),
        interval: [BEGIN, BEGIN + 10.0],
        origin: Origin::Simulated,
        program: "test".to_owned(),
        seed: 1,
        rounds: vec![BEGIN],
        individuals,
    }
}

fn slide(memory: &Memory, after: &str) {
    let writer = memory.begin(ID).unwrap();
    let robot = RobotText {
        urdf: SLIDER.to_owned(),
        ..RobotText::default()
    };
    robot.attach_to(&writer).unwrap();
    let head = RoundScene::with_upright_tool("slider", "tip", "sponge", "board")
        .head(vec!["rail".to_owned()]);
    let mut telemetry = writer.telemetry(1, head).unwrap();
    let none = Wrench {
        force: Vector3::zeros(),
        moment: Vector3::zeros(),
    };
    for k in 0..SAMPLES {
        let time = k as f64 * PERIOD;
        let pose = Pose::translation(SPEED * time, 0.0, 0.0);
        let sample = TelemetrySample {
            time,
            positions: &[SPEED * time],
            velocities: &[SPEED],
            efforts: &[0.0],
            world_from_commanded: pose,
            world_from_tool: pose,
            controller: none,
            external: none,
            motion: 0,
            phase: Phase::Wipe(0),
            status: SampleStatus::default(),
        };
        telemetry.write(&sample).unwrap();
    }
    telemetry.finish().unwrap();
    let attach = |name: &str, text: &str| writer.attach(name, text.as_bytes()).unwrap();
    attach("round-1/particles-before.csv", BEFORE);
    attach("round-1/particles-estimated.csv", after);
    writer.commit(&record()).unwrap();
}

struct Shown {
    _folder: TempDir,
    memory: Memory,
    catalogue: Catalogue,
}

fn memory_with(after: &str) -> Shown {
    let folder = tempfile::tempdir().unwrap();
    let memory = Memory::open(folder.path()).unwrap();
    slide(&memory, after);
    let catalogue = memory.catalogue().unwrap();
    Shown {
        _folder: folder,
        memory,
        catalogue,
    }
}

impl Shown {
    fn view(&self, views: &[&str]) -> Result<View, ViewError> {
        let views: Vec<Term> = views
            .iter()
            .map(|text| Term::parse(text).unwrap())
            .collect();
        gather(&views, &[], &self.memory, &self.catalogue)
    }

    /// Returns the remarks on what is not drawn.
    fn remarks(&self, view: &str) -> Vec<String> {
        self.view(&[view]).unwrap().remarks
    }
}

#[test]
fn the_path_of_the_tool_and_the_robot_during_a_push_are_shown() {
    let shown = memory_with(AFTER);
    let view = shown
        .view(&[
            "show(trajectory('semco:sponge'),interval(1003,1005,dt(0.5)))",
            "show('semco:slider',1004)",
            // Another answer repeats the command.
            "show('semco:slider',1004)",
        ])
        .unwrap();
    let [track] = view.tracks.as_slice() else {
        panic!("{:?}", view.tracks);
    };
    assert_eq!(track.samples.len(), 5);
    for (k, (time, place)) in track.samples.iter().enumerate() {
        let elapsed = 3.0 + 0.5 * k as f64;
        assert!((time - BEGIN - elapsed).abs() < TOLERANCE, "{time}");
        assert!((place.x - SPEED * elapsed).abs() < TOLERANCE, "{place}");
    }
    assert!(track.path.len() > 15, "{} points", track.path.len());
    let [body] = view.bodies.as_slice() else {
        panic!("{:?}", view.bodies);
    };
    assert_eq!(body.figure, Figure::Robot);
    assert_eq!(view.rounds.len(), 1);
    let episode = &view.episodes[0];
    assert_eq!(episode.shown, [[1003.0, 1005.0], [1004.0, 1004.0]]);
    let of_collisions = episode.occurrences.iter().filter(|one| one.is_collision);
    let names: Vec<&str> = of_collisions.map(|one| one.class.as_str()).collect();
    assert_eq!(names, ["HumanCollision"]);
}

#[test]
fn an_event_is_shown_by_the_path_of_the_tool() {
    let shown = memory_with(AFTER);
    let view = shown
        .view(&[&format!("highlight('semco:HumanCollision_{ID}-4',blue)")])
        .unwrap();
    let track = &view.tracks[0];
    assert_eq!(track.interval, [1003.0, 1005.0]);
    assert_eq!(track.emphasis, Emphasis::Strong);
    assert_eq!(track.colour, Some(Colour([43, 108, 213])));
}

#[test]
fn shown_data_is_highlighted_and_not_duplicated() {
    let shown = memory_with(AFTER);
    let view = shown
        .view(&["show('semco:sponge',1002)", "highlight('semco:sponge')"])
        .unwrap();
    assert_eq!(view.bodies.len(), 1);
    assert_eq!(view.bodies[0].emphasis, Emphasis::Strong);
    assert_eq!(view.bodies[0].figure, Figure::Tool);
    let at = view.bodies[0].world_from_frame.translation.vector;
    assert!(
        (at - Vector3::new(0.2, 0.0, 0.0)).norm() < TOLERANCE,
        "{at}"
    );
}

#[test]
fn particles_are_the_believed_ones() {
    let shown = memory_with(AFTER);
    let view = shown
        .view(&[
            "show(particles('semco:breadcrumbs'),1002)",
            "show('semco:breadcrumbs')",
        ])
        .unwrap();
    let found: Vec<_> = (view.particles.iter())
        .map(|dirt| {
            let places = dirt.positions.iter().map(|place| place.x);
            (dirt.state, places.collect::<Vec<f64>>())
        })
        .collect();
    assert_eq!(
        found,
        [
            (DirtState::Before, vec![0.1, 0.2]),
            (DirtState::Estimated, vec![0.3])
        ],
        "what was absorbed lies nowhere"
    );
}

#[test]
fn without_a_time_the_latest_pose_is_shown() {
    let shown = memory_with(AFTER);
    let view = shown
        .view(&["show('semco:sponge')", "show(trajectory('semco:sponge'))"])
        .unwrap();
    assert!((view.bodies[0].time - BEGIN - 10.0).abs() < TOLERANCE);
    let ends = [view.tracks[0].path.first(), view.tracks[0].path.last()];
    let ends = ends.map(|end| end.unwrap().x);
    assert!(ends[0].abs() < TOLERANCE && (ends[1] - 1.0).abs() < TOLERANCE);
}

#[test]
fn answers_add_their_episodes() {
    let shown = memory_with(AFTER);
    let row = vec![Term::atom(format!("semco:Stroke_{ID}-3")), Term::Float(1.0)];
    let view = gather(&[], &[row], &shown.memory, &shown.catalogue).unwrap();
    assert_eq!(view.episodes[0].id, ID);
    assert!(view.rounds.is_empty(), "nothing was to be seen in space");
}

#[test]
fn the_number_of_shown_answers_is_limited() {
    let shown = memory_with(AFTER);
    let views: Vec<String> = (0..MAX_POSES + 16)
        .map(|k| format!("show('semco:slider',{})", BEGIN + PERIOD * k as f64))
        .collect();
    let views: Vec<&str> = views.iter().map(String::as_str).collect();
    let view = shown.view(&views).unwrap();
    assert_eq!(view.bodies.len(), MAX_POSES);
    assert_eq!(view.left_out, 16);
}

#[test]
fn a_command_that_fails_affects_no_other() {
    let shown = memory_with(AFTER);
    let view = shown
        .view(&["show('semco:spong',1002)", "show('semco:sponge',1002)"])
        .unwrap();
    assert_eq!((view.remarks.len(), view.bodies.len()), (1, 1));
}

#[test]
fn missing_recordings_are_reported() {
    let shown = memory_with("x\n1\n");
    for (view, remark) in [
        (
            "show('semco:sponge',5)",
            "semco:sponge: nothing was recorded between 5 and 5 s".to_owned(),
        ),
        (
            "show('semco:spong',1002)",
            format!(
                "episode {ID}, round 1: there is no frame \"spong\"; the nearest is \"sponge\""
            ),
        ),
        (
            "show('semco:sponge',interval(1000,1010,dt(0.1)))",
            format!(
                "episode {ID}, round 1: semco:sponge: 101 poses exceed the limit of {MAX_POSES}; ask for fewer times"
            ),
        ),
        (
            "show(particles('semco:breadcrumbs'))",
            format!(
                "episode {ID}, round 1: round-1/particles-estimated.csv: line 1: x names no x_m and y_m"
            ),
        ),
    ] {
        assert_eq!(shown.remarks(view), [remark]);
    }
}
