use super::reasons::rate_bases;
use super::*;
use serde_json::Value;
use wisch::follow::{FollowConfig, Placement, RatedBasePose, follow};
use wisch::geometry::{PlanarPose, Point2};
use wisch::interpret::Belief;
use wisch::plan::{Candidate, PlanConfig, PlanError, PlanScore, plan, predict};
use wisch::represent::{Action, DirtArea, Fate, GoalState, OccupiedArea, Treatment, surface_cells};
use wisch::run::CandidateEvaluation;
use wisch_testkit as kit;

/// Parses the pieces of a recording.
fn pieces(recording: &[u8]) -> Vec<Value> {
    let text = std::str::from_utf8(recording).expect("it is text");
    let lines = text.lines();
    lines
        .map(|line| serde_json::from_str(line).expect("each line is JSON"))
        .collect()
}

/// Records a followed plan that is not executed.
fn record_followed_plan(task: &Task) -> Vec<u8> {
    let plan = kit::planned(task);
    let cell = kit::cell(task);
    let config = FollowConfig::default();
    let followed = follow(task, &plan, &cell, None, &config, &mut |_| ()).expect("it is in reach");
    let wiped = Plan {
        strokes: followed.strokes.clone(),
        ..plan
    };
    let mut frames = EffectFrames::new(task, &wiped);
    let prediction = predict(task, &wiped, |progress| frames.record(progress));
    let audit = Audit {
        line: Default::default(),
        grip: Default::default(),
        min_clearance: 0.1,
        faults: Vec::new(),
    };
    let mut recording = RecordingWriter::new(Vec::new());
    let head = RecordingHead {
        title: "</script><b>board",
        program: "test 1",
        task,
        strategy: wiped.strategy,
        target: 0.9,
        cell: Some(&cell),
        appearance: None,
    };
    recording.begin(&head).expect("memory takes it");
    let planned = UnexecutedPlan {
        task,
        plan: &wiped,
        prediction: &prediction,
        frames: &frames,
        followed: Some((&cell, &followed, &audit)),
    };
    recording.record_plan(&planned).expect("memory takes it");
    recording.into_inner()
}

#[test]
fn the_recording_of_a_followed_plan_is_complete() {
    let task = kit::board(Action::Absorb, [0.6, 0.0, 0.2]);
    let recording = record_followed_plan(&task);
    assert_eq!(
        recording,
        record_followed_plan(&task),
        "same input, same bytes"
    );
    let pieces = pieces(&recording);
    let (head, round, samples) = (&pieces[0], &pieces[1], &pieces[2..]);
    assert_eq!(
        (&head["piece"], &round["piece"]),
        (&"head".into(), &"round".into())
    );
    let variables = head["robot"]["variables"].as_array().expect("names").len();
    let mut q: Vec<Option<f64>> = vec![None; variables];
    let mut last = f64::NEG_INFINITY;
    let mut count = 0;
    for piece in samples {
        assert_eq!(piece["piece"], "samples");
        let times = piece["t"].as_array().expect("times");
        for time in times {
            let time = time.as_f64().expect("a number");
            assert!(time > last, "{time} after {last}");
            last = time;
        }
        count += times.len();
        for (name, per_instant) in [("tool", 7), ("force", 3), ("normal", 1), ("height", 1)] {
            let numbers = piece[name].as_array().expect("numbers");
            assert_eq!(numbers.len(), per_instant * times.len(), "{name}");
        }
        for (index, values) in piece["q"].as_object().expect("variables") {
            let values = values.as_array().expect("numbers");
            assert_eq!(values.len(), times.len());
            q[index.parse::<usize>().expect("an index")] = values.last().and_then(Value::as_f64);
        }
    }
    assert!(
        q.iter().all(Option::is_some),
        "the first piece has all of them"
    );
    let duration = round["duration"].as_f64().expect("a number");
    assert!((last - duration).abs() < 1e-3 && count as f64 > 24.0 * duration);
    assert!(round["growth"].as_array().expect("points").len() > 2);
}

#[test]
fn a_plan_has_reasons() {
    let task = kit::board(Action::Absorb, [0.6, 0.0, 0.2]);
    let recording = pieces(&record_followed_plan(&task));
    let round = &recording[1];
    let list = |name: &str| round[name].as_array().expect("a list").clone();
    let strokes = list("strokes");
    assert_eq!(list("headings").len(), strokes.len());
    let share = |value: &Value| value.as_f64().expect("a share");
    let whole = share(&round["predicted"]);
    let without = list("without");
    assert_eq!(without.len(), strokes.len());
    for (i, left_out) in without.iter().enumerate() {
        assert_eq!(left_out["stroke"], i);
        assert!(share(&left_out["performance"]) <= whole, "{left_out}");
    }
    let loses = |left_out: &Value| share(&left_out["performance"]) < whole;
    assert!(without.iter().any(loses), "some stroke is needed");
    assert!(
        round.get("another").is_none(),
        "no stroke gains a second time"
    );
    let bases = &round["bases"];
    assert_eq!(bases, &Value::Null, "the arm stands still");
}

#[test]
fn a_base_that_was_not_rated_has_no_share_in_reach() {
    let at = |x: f64| PlanarPose::new(Point2::new(x, 0.0), 0.0);
    let rated =
        [(0.0, Some(0.25)), (1.0, None), (2.0, Some(1.0))].map(|(x, rating)| RatedBasePose {
            world_from_base: at(x),
            rating,
        });
    // The rating of a placement is how amply the path is reached, and no share of it.
    let placements = [2.0, 3.0].map(|x| Placement {
        world_from_base: at(x),
        rating: 0.6,
    });
    let bases = serde_json::to_value(rate_bases(&rated, &placements)).expect("JSON");
    let poses = serde_json::json!([
        [0.0, 0.0, 0.0, 0.25],
        [2.0, 0.0, 0.0, 1.0],
        [3.0, 0.0, 0.0, null]
    ]);
    assert_eq!(bases["poses"], poses);
    assert_eq!(bases["chosen"], serde_json::json!([1, 2]));
    assert!(rate_bases(&[], &placements).is_none());
}

#[test]
fn a_density_counts_the_particles_that_remain() {
    let task = kit::board(Action::Collect, [0.6, 0.0, 0.2]);
    let goal = GoalState::Collected {
        center: Point2::new(-0.2, -0.1),
        radius: 0.015,
    };
    let place = |i: usize| Point2::new(0.0015 * i as f64 - 0.2, -0.1);
    let member = |gone: usize| {
        let fates: Vec<(Point2, Fate)> = (0..100)
            .map(|i| {
                (
                    place(i),
                    if i < gone {
                        Fate::Absorbed
                    } else {
                        Fate::OnSurface
                    },
                )
            })
            .collect();
        ParticleDistribution::with_fates(&fates).expect("finite places")
    };
    let belief =
        Belief::from_members([0, 0, 0, 100].map(member).to_vec()).expect("the same places");
    let found = serde_json::to_value(particles::find_density(&belief, &goal, &task.surface))
        .expect("numbers");
    let expected = found["expected"].as_array().expect("numbers").iter();
    let sum: f64 = expected
        .map(|count| count.as_f64().expect("a number"))
        .sum();
    assert!((sum - 75.0).abs() < 0.1, "{sum}");
    assert_eq!(found["remaining"], 75.0);
    // Ten or eleven of the places are within 15 mm, in three of four members.
    let in_goal = found["goal"].as_f64().expect("a number");
    assert!((7.5..=8.25).contains(&in_goal), "{in_goal}");
    // Thinly spread dirt has wider cells, and is not left out.
    let far = |k: usize| vec![(Point2::new(0.004 * k as f64 - 0.2, 0.01), Fate::OnSurface)];
    let thin = (0..100).map(|k| ParticleDistribution::with_fates(&far(k)).expect("finite"));
    let thin = Belief::from_members(thin.collect()).expect("the same places");
    let spread = serde_json::to_value(particles::find_density(&thin, &goal, &task.surface));
    let spread = spread.expect("numbers");
    let held = spread["expected"].as_array().expect("numbers").iter();
    let held: f64 = held.map(|count| count.as_f64().expect("a number")).sum();
    assert!(
        held > 0.97 && spread["cell"].as_f64() >= Some(0.01),
        "{spread}"
    );
    let cells = found["places"].as_array().expect("numbers").len() / 2;
    assert_eq!((&found["cell"], cells), (&0.01.into(), 15));
}

#[test]
fn particle_steps_reproduce_the_positions() {
    let moments: Vec<particles::Moment> = (0..5)
        .map(|k| particles::Moment {
            time: f64::from(k),
            places: (0..40 - 3 * k)
                .map(|i| Point2::new(0.001 * f64::from(i), if i < 4 * k { 0.1 } else { 0.0 }))
                .collect(),
        })
        .collect();
    let mut now: Vec<[i64; 2]> = Vec::new();
    for (step, moment) in particles::steps(&moments).iter().zip(&moments) {
        let (time, gone, added) = step;
        assert_eq!(*time, moment.time);
        let mut kept: Vec<[i64; 2]> = (now.iter().enumerate())
            .filter(|(i, _)| !gone.contains(i))
            .map(|(_, place)| *place)
            .collect();
        kept.extend(added.chunks(2).map(|xy| [xy[0], xy[1]]));
        let mut wanted: Vec<[i64; 2]> = (moment.places.iter())
            .map(|p| [p.x, p.y].map(|x| (1e4 * x).round() as i64))
            .collect();
        now = kept.clone();
        kept.sort_unstable();
        wanted.sort_unstable();
        assert_eq!(kept, wanted);
    }
}

#[test]
fn many_particles_are_thinned() {
    let crowd = |k: usize| particles::Moment {
        time: k as f64,
        places: (0..200_000)
            .map(|i| Point2::new(1e-3 * (i % 500) as f64, 1e-3 * (i / 500 + k) as f64))
            .collect(),
    };
    let moments: Vec<particles::Moment> = (0..80).map(crowd).collect();
    let steps = particles::steps(&moments);
    let numbers: usize = steps
        .iter()
        .map(|(_, gone, added)| gone.len() + added.len())
        .sum();
    assert!(steps.len() > 1 && numbers < 80_000, "{numbers}");
    assert_eq!(
        steps.last().map(|step| step.0),
        Some(79.0),
        "the end is there"
    );
}

/// Returns a board whose about 1200 points are to be polished: 2 to 4 passes each.
pub(super) fn polished() -> Task {
    let mut task = kit::board(Action::Polish, [0.6, 0.0, 0.2]);
    task.treatment = Some(Treatment::Polish {
        passes: 2,
        max_passes: 4,
        preston: None,
    });
    let area = DirtArea {
        outline: &task.surface.outline,
        occupied: &OccupiedArea::default(),
    };
    task.particles = surface_cells(area, 1200).expect("there is room");
    task
}

#[test]
fn a_polished_surface_has_its_passes_at_every_place() {
    let task = polished();
    let config = PlanConfig {
        strategy: Strategy::Lanes,
        ..PlanConfig::default()
    };
    let plan = plan(&task, &config).expect("a plan");
    let mut frames = EffectFrames::new(&task, &plan);
    let prediction = predict(&task, &plan, |progress| frames.record(progress));
    let mut recording = RecordingWriter::new(Vec::new());
    let planned = UnexecutedPlan {
        task: &task,
        plan: &plan,
        prediction: &prediction,
        frames: &frames,
        followed: None,
    };
    recording.record_plan(&planned).expect("memory takes it");
    let piece = pieces(&recording.into_inner()).remove(0);
    assert_eq!(
        piece["particles"],
        serde_json::json!([]),
        "places are no dirt"
    );
    let record = &piece["treatment"];
    assert_eq!(record["unit"], "passes");
    assert_eq!([&record["low"], &record["high"]], [2.0, 4.0]);
    let numbers = |value: &Value| -> Vec<f64> {
        let list = value.as_array().expect("numbers").iter();
        list.map(|number| number.as_f64().expect("a number"))
            .collect()
    };
    assert_eq!(numbers(&record["places"]).len(), 2 * task.particles.len());
    let step = record["step"].as_f64().expect("a number");
    let mut passes = vec![f64::NAN; task.particles.len()];
    for change in record["steps"].as_array().expect("steps") {
        for (place, value) in numbers(&change[1]).iter().zip(numbers(&change[2])) {
            passes[*place as usize] = step * value;
        }
    }
    let done = passes.iter().filter(|passes| passes.round() >= 2.0).count();
    let share = done as f64 / passes.len() as f64;
    assert!(share > 0.3, "{share}");
    assert!(
        (share - prediction.performance.ratio()).abs() < 0.005,
        "{share}"
    );
}

#[test]
fn a_round_lists_the_candidate_plans() {
    let task = kit::board(Action::Absorb, [0.6, 0.0, 0.2]);
    let plan = kit::planned(&task);
    let prediction = predict(&task, &plan, |_| ());
    let frames = EffectFrames::new(&task, &plan);
    let other = (Strategy::ALL.into_iter())
        .find(|&strategy| strategy != plan.strategy && strategy != Strategy::Best)
        .expect("there are several");
    let found = Candidate {
        plan: plan.clone(),
        score: PlanScore {
            total: 0.751_23,
            ..PlanScore::default()
        },
    };
    let considered = [
        CandidateEvaluation {
            strategy: other,
            candidate: Err(PlanError::NoFreeNode {
                surface: "board".to_owned(),
                diameter: 0.2,
                has_obstacles: true,
            }
            .into()),
            prediction: None,
            motion: None,
        },
        CandidateEvaluation {
            strategy: plan.strategy,
            candidate: Ok(found),
            prediction: Some(prediction.clone()),
            motion: None,
        },
    ];
    let mut recording = RecordingWriter::new(Vec::new());
    let evaluated = RunEvent::Evaluated {
        round: 1,
        considered: &considered,
    };
    recording.record_event(&evaluated).expect("memory takes it");
    let planned = UnexecutedPlan {
        task: &task,
        plan: &plan,
        prediction: &prediction,
        frames: &frames,
        followed: None,
    };
    recording.record_plan(&planned).expect("memory takes it");
    recording.record_plan(&planned).expect("memory takes it");
    let pieces = pieces(&recording.into_inner());
    let rounds: Vec<&Value> = pieces.iter().filter(|p| p["piece"] == "round").collect();
    let [none, chosen] = rounds[0]["considered"]
        .as_array()
        .expect("plans")
        .as_slice()
    else {
        panic!("{}", rounds[0]["considered"]);
    };
    assert_eq!(none["chosen"], false);
    assert!(none["score"].is_null() && none["error"].is_string());
    assert_eq!(chosen["chosen"], true);
    assert_eq!(chosen["strategy"], plan.strategy.as_str());
    assert_eq!(chosen["score"], 0.7512);
    assert_eq!(chosen["strokes"], plan.strokes.len());
    assert!(chosen["error"].is_null() && chosen["duration"].is_null());
    assert!(
        rounds[1].get("considered").is_none(),
        "candidates belong to one plan only"
    );
}

/// Returns the head of a recording without rounds.
fn head(task: &Task, cell: Option<&Workcell>, appearance: Option<&Appearance>) -> Value {
    let mut recording = RecordingWriter::new(Vec::new());
    let head = RecordingHead {
        title: "board",
        program: "test 1",
        task,
        strategy: Strategy::Adaptive,
        target: 0.9,
        cell,
        appearance,
    };
    recording.begin(&head).expect("memory takes it");
    pieces(&recording.into_inner()).remove(0)
}

#[test]
fn a_task_without_a_robot_has_a_head() {
    let piece = head(&kit::board(Action::Collect, [0.6, 0.0, 0.2]), None, None);
    assert!(piece["robot"].is_null() && piece["tool"]["link"].is_null());
    let asked = piece["task"]["asked"].as_str().expect("words");
    assert!(asked.contains("90.0 %"), "{asked}");
}

#[test]
fn a_robot_is_shown_with_its_visual_geometry() {
    let task = kit::board(Action::Absorb, [0.6, 0.0, 0.2]);
    let cell = kit::cell(&task);
    let head = |appearance: Option<&Appearance>| head(&task, Some(&cell), appearance);
    let robot = cell.robot();
    let [first, second] = [0, 1].map(|i| robot.links()[i].name.as_str());
    let urdf = format!(
        r#"<robot name="r"><material name="orange"><color rgba="1 0.5 0 1"/></material>
  <link name="{first}"><visual><geometry><mesh filename="ball.obj"/></geometry><material name="orange"/></visual></link>
  <link name="{second}"><visual><geometry><mesh filename="none.obj"/></geometry></visual></link>
</robot>"#
    );
    let ball = wisch::geometry::Mesh::sphere(0.1, 300).expect("a ball");
    let vertices = ball.vertices().iter();
    let vertices = vertices.map(|v| format!("v {} {} {}\n", v.x, v.y, v.z));
    let faces = ball.triangles().iter();
    let faces = faces.map(|[a, b, c]| format!("f {} {} {}\n", a + 1, b + 1, c + 1));
    let ball: String = vertices.chain(faces).collect();
    let mut meshes = |file: &str| match file {
        "ball.obj" => Ok(ball.clone().into_bytes()),
        _ => Err("no such file".to_owned()),
    };
    let looks = Appearance::from_urdf("r.urdf", &urdf, robot, &mut meshes).expect("a URDF");
    let shown = head(Some(&looks));
    let links = shown["robot"]["links"].as_array().expect("links");
    let solid = &links[0]["shapes"][0];
    assert_eq!(
        (&links[0]["visual"], &solid["kind"]),
        (&true.into(), &"mesh".into())
    );
    assert_eq!(solid["color"], serde_json::json!([1.0, 0.5, 0.0, 1.0]));
    let mesh = &shown["meshes"][solid["mesh"].as_u64().expect("a number") as usize];
    let triangles = mesh["triangles"].as_array().expect("triangles").len() / 3;
    assert!((2000..=5000).contains(&triangles), "{triangles}");
    // Links whose mesh is missing, or without visual geometry, keep their collision geometry.
    let plain = head(None);
    let plain_links = plain["robot"]["links"].as_array().expect("links");
    assert_eq!(links[1], plain_links[1], "by its collision geometry");
    assert!(links[1].get("visual").is_none());
    assert_eq!(links[2]["shapes"], serde_json::json!([]));
    // A robot without any visual geometry is shown with its collision geometry.
    let bare = format!(r#"<robot name="r"><link name="{first}"/></robot>"#);
    let bare = Appearance::from_urdf("r.urdf", &bare, robot, &mut meshes).expect("a URDF");
    assert_eq!(head(Some(&bare)), plain);
}
