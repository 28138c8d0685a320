use super::demo::Demo;
use super::*;
use crate::rasterize;
use crate::tests::{find_requests, keep};
use resvg::usvg;
use wisch::follow::TrajectorySample;
use wisch::robot::RobotModel;

fn pictures(input: &MotionInput) -> [(&'static str, String); 2] {
    [
        ("joints", joint_plots(input)),
        ("placements", placements_plan(input)),
    ]
}

#[test]
fn the_humanoid_at_the_board_is_shown() {
    let demo = Demo::new();
    let input = demo.input();
    assert_eq!(pictures(&input), pictures(&input), "same input, same bytes");
    for (stem, svg) in pictures(&input) {
        assert_eq!(find_requests(&svg), [""; 0], "{stem}");
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
    for text in texts {
        assert!(!text.contains("<script>alert"));
        assert!(!text.contains("</script><script>a") && !text.contains("<!--"));
        assert!(text.contains("&lt;script&gt;alert"));
    }
}

#[test]
fn empty_and_invalid_motions_are_drawn() {
    let demo = Demo::new();
    let full = demo.input();
    let bare = MotionInput {
        phases: &[],
        placements: &[],
        ratings: &[],
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
    let strange = [CandidateBase {
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
        for (stem, svg) in pictures(&input) {
            assert!(!svg.contains("NaN") && !svg.contains("inf "), "{stem}");
            rasterize(&svg, 1.0).expect("it can be drawn");
        }
    }
}
