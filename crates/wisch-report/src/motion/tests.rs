use super::demo::Demo;
use super::*;
use crate::page::document::document;
use crate::tests::{keep, requests};
use crate::{ReportInput, rasterize};
use resvg::usvg;
use wisch::follow::TrajectorySample;
use wisch::follow::{FollowConfig, follow};
use wisch::geometry::{Mesh, Point2, Pose};
use wisch::plan::predict;
use wisch::recover::relocalized;
use wisch::represent::Action;
use wisch::robot::RobotModel;
use wisch::run::TelemetrySample;
use wisch_testkit as kit;

/// A page with nothing but the motion.
fn page(input: &MotionInput) -> String {
    page_of_rounds(input, Vec::new())
}

/// A page with nothing but the rounds in motion, or the plan where there are none.
fn page_of_rounds<'a>(plan: &'a MotionInput<'a>, rounds: Vec<Track<'a>>) -> String {
    document("motion", "", &motion_section(plan, rounds))
}

fn round<'a>(number: usize, motion: &'a MotionInput<'a>) -> Track<'a> {
    Track {
        round: Some(number),
        motion,
        marks: Vec::new(),
    }
}

/// The numbers of the 3-D view in a page.
fn data(html: &str) -> serde_json::Value {
    let from = html
        .split(r#"id="motion-data">"#)
        .nth(1)
        .expect("the page has data");
    let json = from.split("</script>").next().expect("the data end");
    serde_json::from_str(json).expect("the data are JSON")
}

fn pictures(input: &MotionInput) -> [(&'static str, String); 2] {
    [
        ("joints", joint_plots(input)),
        ("placements", placements_plan(input)),
    ]
}

/// Where the tool is by the library's kinematics, for `viewer/check.mjs`.
fn tool_csv(input: &MotionInput) -> String {
    let frames = SampledMotion::new(input);
    let tool = input.link_from_tool.translation.vector.into();
    let mut csv = String::from("time,x,y,z\n");
    for (k, p) in frames.path(input, input.tool_link, tool).iter().enumerate() {
        csv += &format!("{},{},{},{}\n", k as f64 * frames.period, p.x, p.y, p.z);
    }
    csv
}

#[test]
fn the_humanoid_at_the_board_is_shown() {
    let demo = Demo::new();
    let input = demo.input();
    let html = page(&input);
    keep("motion.html", &html);
    keep("motion-tool.csv", tool_csv(&input));
    assert_eq!(requests(&html), [""; 0]);
    assert_eq!(html, page(&input), "same input, same bytes");
    assert!(html.len() < 1_500_000, "{} bytes", html.len());
    for (stem, svg) in pictures(&input) {
        assert_eq!(requests(&svg), [""; 0], "{stem}");
        assert!(svg.len() < 200_000, "{stem}: {} bytes", svg.len());
        usvg::Tree::from_str(&svg, &usvg::Options::default()).expect("it is SVG");
        keep(&format!("motion-{stem}.svg"), &svg);
        let png = rasterize(&svg, 2.0).expect("it can be drawn");
        keep(&format!("motion-{stem}.png"), png);
    }
    let joints = joint_plots(&input);
    assert!(joints.contains("right_arm_7") && joints.contains("Not moving: "));
    assert_eq!(
        joints.matches("class=\"course\"").count(),
        2 * 14,
        "two curves a moving joint"
    );
}

#[test]
fn a_report_with_a_motion_has_its_view_and_pictures() {
    let demo = Demo::new();
    let motion = demo.input();
    let mut frames = crate::EffectFrames::new(&demo.task, &demo.plan);
    let prediction = predict(&demo.task, &demo.plan, |progress| frames.watch(progress));
    let mut input = ReportInput {
        title: "chopping board",
        task: &demo.task,
        plan: &demo.plan,
        prediction: &prediction,
        frames: &frames,
        bandwidth: None,
        facts: &[],
        motion: None,
        rounds: None,
    };
    assert!(!crate::page(&input).contains("motion-"));
    input.motion = Some(&motion);
    let html = crate::page(&input);
    keep("motion-report.html", &html);
    assert!(html.len() < 1_500_000, "{} bytes", html.len());
    let markup = html.replace(VIEWER, "");
    let mut ids: Vec<&str> = (markup.split(" id=\"").skip(1))
        .filter_map(|rest| rest.split('"').next())
        .collect();
    ids.sort_unstable();
    let all = ids.len();
    ids.dedup();
    assert!(
        ids.contains(&"motion-canvas") && ids.len() == all,
        "an id stands twice"
    );
    let pictures = crate::pictures(&input);
    let stems: Vec<&str> = pictures.iter().map(|(stem, _)| stem.as_str()).collect();
    assert!(stems.ends_with(&["joints", "placements"]));
}

#[test]
fn the_data_lead_back_to_the_positions() {
    let demo = Demo::new();
    let input = demo.input();
    let frames = SampledMotion::new(&input);
    let track = &data(&page(&input))["tracks"][0];
    let mut q: Vec<i64> = serde_json::from_value(track["start"].clone()).expect("numbers");
    let changes: Vec<(usize, Vec<i64>)> =
        serde_json::from_value(track["changes"].clone()).expect("columns");
    assert_eq!(changes.len(), 13, "base, torso and arm move");
    for (k, expected) in frames.q.iter().enumerate() {
        for (variable, steps) in changes.iter().filter(|_| k > 0) {
            q[*variable] += steps[k - 1];
        }
        for (&q, expected) in q.iter().zip(expected) {
            assert!((q as f64 * 1e-5 - expected).abs() <= 0.5001e-5, "frame {k}");
        }
    }
    // Frames lie on the samples' polyline: a sample apart they differ by less than full speed allows.
    let period = track["period"].as_f64().expect("a number");
    assert!(period <= 1.0 / 39.0 && frames.q.len() <= 4_000);
    let last = input.samples.last().expect("samples");
    assert_eq!(frames.q.last(), Some(&last.q));
}

#[test]
fn the_particles_data_lead_back_to_the_frames() {
    let demo = Demo::new();
    let input = demo.input();
    let track = &data(&page(&input))["tracks"][0];
    let records: Vec<(f64, Vec<usize>, Vec<i64>)> =
        serde_json::from_value(track["particles"].clone()).expect("frames");
    assert!(records.len() > 20);
    let mut list: Vec<[i64; 2]> = Vec::new();
    for (time, removed, added) in records {
        let mut index = 0;
        list.retain(|_| {
            index += 1;
            !removed.contains(&(index - 1))
        });
        list.extend(added.chunks_exact(2).map(|p| [p[0], p[1]]));
        let frame = (input.particles.iter()).filter(|f| (f.time - time).abs() < 1e-4);
        let tenths = |p: &Point2| [p.x, p.y].map(|v| (v * 1e4).round() as i64);
        let mut sorted = list.clone();
        sorted.sort_unstable();
        let found = frame.map(|frame| {
            let mut places: Vec<[i64; 2]> = frame.positions.iter().map(tenths).collect();
            places.sort_unstable();
            places
        });
        assert!(
            found.into_iter().any(|places| places == sorted),
            "at {time} s"
        );
    }
}

#[test]
fn hostile_names_stay_text() {
    let evil = r#"</title></script><script>alert("1")</script><!--&'"#;
    let mut demo = Demo::new();
    demo.task.name = evil.into();
    demo.task.tool.name = evil.into();
    demo.task.surface.name = evil.into();
    for object in &mut demo.task.scene {
        object.name = evil.into();
    }
    for phase in &mut demo.phases {
        phase.name = evil.into();
    }
    let urdf = r#"<robot name="&lt;/script>&lt;script>alert(1)"><link name="a"/><link name="&lt;script>alert(b)"/>
        <joint name="&lt;script>alert(j)" type="continuous"><parent link="a"/><child link="&lt;script>alert(b)"/></joint></robot>"#;
    let robot = RobotModel::from_urdf("evil", urdf, &mut |_| Err(String::new())).expect("a robot");
    let samples = [0.0, 1.0].map(|t| TrajectorySample {
        time: t,
        q: vec![t],
        qd: vec![0.0],
        qdd: vec![0.0],
    });
    let input = MotionInput {
        robot: &robot,
        tool_link: robot.root(),
        samples: &samples,
        ..demo.input()
    };
    let texts = pictures(&input).map(|(_, svg)| svg);
    for text in texts.into_iter().chain([page(&input)]) {
        assert!(!text.contains("<script>alert"));
        assert!(!text.contains("</script><script>a") && !text.contains("<!--"));
        assert!(text.contains("&lt;script&gt;alert"));
    }
    assert_eq!(data(&page(&input))["tracks"][0]["phases"][0]["name"], evil);
}

#[test]
fn motions_with_nothing_in_them_are_shown_all_the_same() {
    let demo = Demo::new();
    let full = demo.input();
    let bare = MotionInput {
        phases: &[],
        placements: &[],
        ratings: &[],
        particles: &[],
        ..full
    };
    let broken: Vec<TrajectorySample> = [f64::NAN, 0.0, 0.0]
        .map(|time| TrajectorySample {
            time,
            q: vec![0.0; 2],
            qd: vec![],
            qdd: vec![],
        })
        .into();
    let strange = [RatedPlace {
        x: f64::NAN,
        y: 0.0,
        rating: f64::INFINITY,
        blocked: false,
    }];
    for input in [
        MotionInput {
            samples: &[],
            ..bare
        },
        MotionInput {
            samples: &demo.samples[..1],
            ..bare
        },
        MotionInput {
            samples: &broken,
            ratings: &strange,
            ..full
        },
        MotionInput {
            ratings: &strange,
            ..full
        },
        bare,
    ] {
        let html = page(&input);
        let markup = html.replace(VIEWER, "");
        assert!(!markup.contains("NaN") && !markup.contains("inf\""));
        for (stem, svg) in pictures(&input) {
            assert!(!svg.contains("NaN") && !svg.contains("inf "), "{stem}");
            rasterize(&svg, 1.0).expect("it can be drawn");
        }
    }
}

#[test]
fn an_hour_with_many_particles_and_large_meshes_is_thinned_and_the_page_says_so() {
    let mut demo = Demo::new();
    for sample in &mut demo.samples {
        sample.time *= 3600.0 / 45.0;
    }
    let ball = Mesh::sphere(0.2, 200).expect("a ball");
    assert!(ball.triangles().len() > 30_000);
    demo.task.scene[1].mesh = ball;
    let crowd = |k: i32| ParticleFrame {
        time: f64::from(k),
        positions: (0..10_000)
            .map(|i| Point2::new(f64::from(i % 100) * 2e-3, f64::from(i / 100 + k) * 2e-3))
            .collect(),
    };
    demo.particles = (0..60).map(crowd).collect();
    let html = page(&demo.input());
    keep("motion-large.html", &html);
    assert!(html.len() < 2_000_000, "{} bytes", html.len());
    assert!(html.contains("coarsens 1 of them"));
    assert!(html.contains("about one particle in 7"));
    assert!(data(&html)["tracks"][0]["count"].as_u64() <= Some(4_000));
}

#[test]
fn rounds_are_shown_one_at_a_time_and_the_robot_is_in_the_page_once() {
    let demo = Demo::new();
    let plan = demo.input();
    let first = MotionInput {
        origin: Origin::Measured,
        ..plan
    };
    let up = Pose::translation(0.0, 0.0, 0.012);
    let found = relocalized(&demo.task, up * demo.task.surface.world_from_surface);
    let half = demo.samples.len() / 2;
    let second = MotionInput {
        task: &found,
        samples: &demo.samples[half..],
        ..first
    };
    let begin = demo.samples[half].time;
    let mark = Mark {
        kind: MarkKind::Felt,
        name: "collision felt",
        times: [begin + 1.5, begin + 2.0],
    };
    let marked = Track {
        marks: vec![mark],
        ..round(2, &second)
    };
    let alone = page_of_rounds(&plan, vec![round(1, &first)]);
    let html = page_of_rounds(&plan, vec![round(1, &first), marked]);
    keep("motion-rounds.html", &html);
    assert_eq!(requests(&html), [""; 0]);
    assert!(html.len() < 1_500_000, "{} bytes", html.len());

    let (one, both) = (data(&alone), data(&html));
    for part in ["joints", "meshes", "links", "tool"] {
        assert_eq!(one[part], both[part], "{part}");
    }
    let tracks = both["tracks"].as_array().expect("tracks");
    assert_eq!(tracks.len(), 2);
    assert_eq!(tracks[0], one["tracks"][0]);
    let rounds: Vec<_> = tracks.iter().map(|track| &track["round"]).collect();
    assert_eq!(rounds, [1, 2]);
    let start: Vec<f64> = serde_json::from_value(tracks[1]["start"].clone()).expect("numbers");
    for (units, q) in start.iter().zip(&demo.samples[half].q) {
        assert!((units * 1e-5 - q).abs() <= 0.5001e-5, "{units} for {q}");
    }
    let felt = &tracks[1]["marks"][0];
    assert_eq!((&felt["start"], &felt["end"]), (&1.5.into(), &2.0.into()));

    // The surface, and with it what stands round it, is where it was believed in that round.
    let height = |track: &serde_json::Value, of: &str| track["surface"][of][2].as_f64();
    let at_first = height(&tracks[0], "pose").expect("a height");
    let then = height(&tracks[1], "pose").expect("a height");
    assert!((then - at_first - 0.012).abs() < 1e-6, "{then}");
    assert_eq!(height(&tracks[1], "first"), Some(at_first));
    assert_eq!(height(&tracks[0], "first"), None);
    let stands = |track: &serde_json::Value| track["scene"][0]["pose"][2].as_f64();
    assert_ne!(stands(&tracks[0]), stands(&tracks[1]));

    let markup = html.replace(VIEWER, "");
    assert_eq!(markup.matches("aria-pressed=\"").count(), 2);
    assert_eq!(markup.matches(r#"<div class="strip""#).count(), 2);
    let captions = [
        r#"<p class="caption">Round 1, the joints as measured.</p>"#,
        r#"<p class="caption" hidden>Round 2, the joints as measured. The surface is where it was believed then: 12.0 mm and 0.00°"#,
    ];
    assert!(captions.iter().all(|caption| markup.contains(caption)));
    assert!(markup.contains("As planned for the first round."));
    assert!(markup.contains("collision felt"));
    let markup = alone.replace(VIEWER, "");
    assert!(!markup.contains("aria-pressed=\"") && markup.contains(captions[0]));
}

#[test]
fn a_round_without_samples_is_left_out_and_without_any_round_the_plan_is_shown() {
    let demo = Demo::new();
    let plan = demo.input();
    let empty = MotionInput {
        samples: &[],
        ..plan
    };
    let rounds = |html: &str| -> Vec<Option<usize>> {
        let data = data(html);
        let tracks = data["tracks"].as_array().expect("tracks");
        let round = |track: &serde_json::Value| track["round"].as_u64().map(|n| n as usize);
        tracks.iter().map(round).collect()
    };
    let html = page_of_rounds(&plan, vec![round(1, &empty), round(2, &plan)]);
    assert_eq!(rounds(&html), [Some(2)]);
    assert!(html.contains("Round 2, the joints as planned, for none were measured."));
    assert_eq!(
        rounds(&page_of_rounds(&plan, vec![round(1, &empty)])),
        [None]
    );
    let html = page_of_rounds(&empty, vec![round(1, &empty)]);
    assert!(html.contains("nothing to play"));
}

#[test]
fn many_rounds_share_what_a_page_may_hold() {
    let mut demo = Demo::new();
    let crowd = |k: i32| ParticleFrame {
        time: f64::from(k),
        positions: (0..3_000)
            .map(|i| Point2::new(f64::from(i % 100) * 2e-3, f64::from(i / 100 + k) * 2e-3))
            .collect(),
    };
    demo.particles = (0..20).map(crowd).collect();
    let motion = demo.input();
    let html = page_of_rounds(&motion, (1..=40).map(|n| round(n, &motion)).collect());
    keep("motion-many-rounds.html", &html);
    assert!(html.len() < 2_500_000, "{} bytes", html.len());
    let data = data(&html);
    let tracks = data["tracks"].as_array().expect("tracks");
    let frames: u64 = tracks
        .iter()
        .filter_map(|track| track["count"].as_u64())
        .sum();
    assert!(
        tracks.len() == 40 && (7_000..=8_000).contains(&frames),
        "{frames} frames"
    );
    assert!(html.contains("about one particle in 14"));
}

/// A sample in which only the joints are measured.
fn measured(time: f64, positions: &[f64]) -> TelemetrySample<'_> {
    let touch = wisch::interpret::TouchSample {
        time,
        world_from_tool: Pose::identity(),
        force: wisch::geometry::Vector3::zeros(),
    };
    TelemetrySample {
        positions,
        ..TelemetrySample::of_touch(&touch, 0, wisch::follow::Phase::Drive)
    }
}

#[test]
fn a_round_is_shown_as_measured_and_where_nothing_was_as_planned_up_to_its_end() {
    let task = kit::board(Action::Absorb, [0.55, 0.0, 0.4]);
    let plan = kit::first_stroke(kit::planned(&task));
    let cell = kit::cell(&task);
    let config = FollowConfig::default();
    let followed = follow(&task, &plan, &cell, None, &config, &mut |_| ()).expect("a motion");
    let frames = crate::EffectFrames::new(&task, &plan);
    let n = cell.robot().dof();

    let mut thinned = MeasuredMotion::default();
    for k in 0..=1_000 {
        let time = f64::from(k) * 1e-3;
        thinned.watch(&measured(time, &vec![time; n]));
    }
    let shown = ShownMotion::of(&cell, &followed, &frames).executed(&thinned, 1.0);
    let input = shown.input(&task);
    assert_eq!((input.origin, input.samples.len()), (Origin::Measured, 41));
    assert!(
        input
            .samples
            .iter()
            .all(|sample| sample.q == vec![sample.time; n])
    );
    // Without velocities there is no joint plot, but the motion is shown.
    assert_eq!(SampledMotion::new(&input).q.len(), 41);
    assert!(!joint_plots(&input).contains("class=\"course\""));

    for positions in [vec![], vec![0.0; n + 1]] {
        let mut useless = MeasuredMotion::default();
        useless.watch(&measured(0.0, &positions));
        let shown = ShownMotion::of(&cell, &followed, &frames).executed(&useless, 1.0);
        let input = shown.input(&task);
        assert_eq!(input.origin, Origin::Planned);
        let last = input.samples.last().expect("samples").time;
        assert!((0.9..=1.0).contains(&last), "{last}");
    }
}
