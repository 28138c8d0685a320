use super::*;
use crate::KnowledgeSource;
use proptest::prelude::*;
use wisch::geometry::Vector2;
use wisch::represent::{Interaction, ScenePart, Task};

mod execution;
mod faults;
mod treatment;

/// A task with the required keys only, and a cup on the table.
const SMALL: &str = r#"schema = 1
name = "small"
action = "skim"
[tool]
name = "sponge"
[medium]
name = "breadcrumbs"
[surface]
name = "table"
size_m = [0.5, 0.4]
skim_edges = ["y_min"]
[particles]
source = "uniform"
count = 10
[[scene]]
name = "cup"
cylinder = { radius_m = 0.04, height_m = 0.1 }
frame = "surface"
position_m = [0.1, 0.1, 0.05]
"#;

fn small_with(pieces: &[(&str, &str)]) -> String {
    pieces.iter().fold(SMALL.to_owned(), |text, (piece, by)| {
        assert_eq!(text.matches(piece).count(), 1, "{piece} must occur once");
        text.replace(piece, by)
    })
}

fn parsed(text: &str) -> Result<TaskFile, TaskError> {
    TaskFile::parse("small.toml", text, &[])
}

fn set(text: &str, settings: &[(&str, &str)]) -> Result<TaskFile, TaskError> {
    let settings: Vec<_> = settings
        .iter()
        .map(|(key, value)| ((*key).to_owned(), (*value).to_owned()))
        .collect();
    TaskFile::parse("small.toml", text, &settings)
}

/// Resolves with the shipped knowledge; `files` are the assets.
fn resolved_as(
    file: &TaskFile,
    action: Action,
    tool: &str,
    medium: &str,
    files: &[(&str, &[u8])],
) -> Result<Task, TaskError> {
    let mut assets = |path: &str| {
        let found = files.iter().find(|(name, _)| *name == path);
        found
            .map(|(_, bytes)| bytes.to_vec())
            .ok_or("no such file".to_owned())
    };
    let shipped = KnowledgeSource::BuiltIn;
    file.resolve(
        action,
        tool,
        medium,
        file.run.plan.seed,
        &shipped.base().expect("shipped knowledge is sound"),
        &mut assets,
        &mut |path| shipped.asset(path),
    )
}

fn resolved(file: &TaskFile) -> Result<Task, TaskError> {
    let Intent::Action {
        action,
        tool,
        medium,
    } = &file.intent
    else {
        panic!("the task names no action");
    };
    resolved_as(file, *action, tool, medium, &[])
}

#[test]
fn the_template_is_a_task() {
    let file = TaskFile::parse("template.toml", TaskFile::TEMPLATE, &[])
        .unwrap_or_else(|error| panic!("{error}"));
    assert_eq!((file.name.as_str(), file.run.plan.seed), ("template", 1));
    let task = resolved(&file).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(task.particles.len(), 80);
}

#[test]
fn the_template_shows_every_key() {
    let schema: serde_json::Value = serde_json::from_str(&TaskFile::json_schema()).unwrap();
    let mut keys = Vec::new();
    collect_keys(&schema, &mut keys);
    assert!(keys.len() > 60, "{keys:?}");
    for key in keys {
        let shown = ["{key} = ", "[{key}]", ".{key}]"].map(|form| form.replace("{key}", &key));
        let is_shown = shown.iter().any(|form| TaskFile::TEMPLATE.contains(form));
        assert!(is_shown, "{key} is not in the template");
    }
}

/// The names of all properties in a schema.
fn collect_keys(schema: &serde_json::Value, keys: &mut Vec<String>) {
    match schema {
        serde_json::Value::Object(fields) => {
            if let Some(serde_json::Value::Object(properties)) = fields.get("properties") {
                keys.extend(properties.keys().cloned());
            }
            fields.values().for_each(|value| collect_keys(value, keys));
        }
        serde_json::Value::Array(items) => items.iter().for_each(|item| collect_keys(item, keys)),
        _ => {}
    }
}

#[test]
fn what_is_left_out_takes_its_default() {
    let file = parsed(SMALL).unwrap();
    assert_eq!(file.run.plan.seed, 0);
    assert_eq!(file.strategy, None);
    assert_eq!(file.run.plan.bandwidth, None);
    assert_eq!(file.run.plan.lift_height, 0.05);
    assert_eq!(file.run.target, 0.95);
    assert_eq!(file.surface.surface.name, "table");
    let task = resolved(&file).unwrap();
    assert_eq!(task.tool_start, Point2::new(0.0, -0.2));
    assert_eq!(task.collect_goal, None);
}

#[test]
fn a_task_has_what_its_file_and_the_knowledge_say() {
    let task = resolved(&parsed(SMALL).unwrap()).unwrap();
    assert_eq!(
        (task.action, task.medium.as_str()),
        (Action::Skim, "breadcrumbs")
    );
    assert_eq!(task.interaction.press_force_n, 10.0);
    // The mesh file holds single precision.
    let size = Vector2::new(0.07, 0.11);
    assert!((task.tool.area_of_effect - size).norm() < 1e-7);
    assert!((task.tool.footprint.area() - 0.07 * 0.11).abs() < 1e-8);
    assert_eq!(task.surface.skim_edges, [0]);
    assert_eq!(task.scene.len(), 1);
    assert_eq!(task.particles.tally().remaining, 10);
}

#[test]
fn a_nozzle_acts_on_its_whole_mouth() {
    let file = parsed(SMALL).unwrap();
    let task = resolved_as(&file, Action::Absorb, "vacuum_nozzle", "dust", &[]).unwrap();
    assert_eq!(task.tool.area_of_effect, Vector2::new(0.09, 0.30));
    assert!((task.tool.footprint.area() - 0.09 * 0.30).abs() < 1e-12);
}

#[test]
fn carrier_robot_and_tool_are_no_obstacles() {
    let others = r#"
[[scene]]
name = "tabletop"
box_m = [1, 1, 0.05]
[[scene]]
name = "arm"
capsule = { radius_m = 0.05, height_m = 0.3 }
role = "robot"
[[scene]]
name = "handle"
sphere = { radius_m = 0.05 }
role = "tool"
"#;
    let carried = small_with(&[(
        "name = \"table\"",
        "name = \"table\"\ncarried_by = \"tabletop\"",
    )]);
    let task = resolved(&parsed(&(carried + others)).unwrap()).unwrap();
    let names: Vec<&str> = task
        .obstacles()
        .map(|object| object.name.as_str())
        .collect();
    assert_eq!(names, ["cup"]);
    let parts: Vec<ScenePart> = task.scene.iter().map(|object| object.part).collect();
    assert!(parts.contains(&ScenePart::Carrier) && parts.contains(&ScenePart::Robot));
}

#[test]
fn poses_stand_in_the_frame_that_they_name() {
    let text = small_with(&[(
        "size_m = [0.5, 0.4]",
        "size_m = [0.5, 0.4]\nposition_m = [1, 2, 3]\nrpy_rad = [0, 0, 1.5707963267948966]",
    )]);
    let at = |text: &str| {
        let task = resolved(&parsed(text).unwrap()).unwrap();
        task.scene[0].world_from_object.translation.vector
    };
    // A quarter turn about z takes (0.1, 0.1) to (-0.1, 0.1).
    assert!((at(&text) - Vector3::new(0.9, 2.1, 3.05)).norm() < 1e-12);
    let in_world = text.replace("frame = \"surface\"", "frame = \"world\"");
    assert!((at(&in_world) - Vector3::new(0.1, 0.1, 0.05)).norm() < 1e-12);
    let by_quaternion = text.replace(
        "rpy_rad = [0, 0, 1.5707963267948966]",
        "quaternion_xyzw = [0, 0, 0.70710678, 0.70710678]",
    );
    assert!((at(&by_quaternion) - Vector3::new(0.9, 2.1, 3.05)).norm() < 1e-7);
}

#[test]
fn an_outline_may_repeat_its_first_point_at_the_end() {
    let outline = |points: &str| {
        let outline = format!(
            "outline_m = [{points}]\nholes_m = [[[0.1, 0.1], [0.2, 0.1], [0.1, 0.2], [0.1, 0.1]]]"
        );
        let text = small_with(&[
            ("size_m = [0.5, 0.4]", outline.as_str()),
            ("skim_edges = [\"y_min\"]", "skim_edges = [1]"),
            (
                "position_m = [0.1, 0.1, 0.05]",
                "position_m = [0.4, 0.3, 0.05]",
            ),
        ]);
        resolved(&parsed(&text).unwrap()).unwrap().surface.outline
    };
    let open = outline("[0, 0], [0.5, 0], [0.5, 0.4], [0, 0.4]");
    let closed = outline("[0, 0], [0.5, 0], [0.5, 0.4], [0, 0.4], [0, 0]");
    assert_eq!(open, closed);
    assert_eq!((closed.outer().len(), closed.holes()[0].len()), (4, 3));
    // As exporters write a clockwise ring.
    let clockwise = outline("[0, 0], [0, 0.4], [0.5, 0.4], [0.5, 0], [0.0, 0.0]");
    assert_eq!(
        (clockwise.outer().len(), clockwise.area()),
        (4, closed.area())
    );
}

#[test]
fn an_edge_of_an_outline_is_counted_as_typed_whichever_way_the_points_run() {
    for points in ["[0, 0], [0, 0.4], [0.3, 0], ", "[0, 0], [0.3, 0], [0, 0.4]"] {
        let outline = format!("outline_m = [{points}]");
        for typed in 0..3 {
            let edges = format!("skim_edges = [{typed}]");
            let text = small_with(&[
                ("size_m = [0.5, 0.4]", &outline),
                ("skim_edges = [\"y_min\"]", &edges),
                ("position_m = [0.1, 0.1, 0.05]", ""),
            ]);
            let task = resolved(&parsed(&text).unwrap()).unwrap();
            let numbers: Vec<f64> = points
                .split(|c: char| !(c.is_ascii_digit() || c == '.'))
                .filter(|text| !text.is_empty())
                .map(|text| text.parse().unwrap())
                .collect();
            let typed_point =
                |i: usize| Point2::new(numbers[2 * (i % 3)], numbers[2 * (i % 3) + 1]);
            let edge = task
                .surface
                .outline
                .edges()
                .nth(task.surface.skim_edges[0])
                .unwrap();
            let ends = [typed_point(typed), typed_point(typed + 1)];
            assert!(
                ends == [edge.start, edge.end] || ends == [edge.end, edge.start],
                "edge {typed} of {points}"
            );
        }
    }
}

#[test]
fn a_goal_leaves_action_and_tool_open() {
    let goal = "goal = \"(collected breadcrumbs table)\"";
    let text = small_with(&[
        ("action = \"skim\"", goal),
        (
            "name = \"sponge\"",
            "in_hand = \"brush\"\navailable = [\"sponge\"]",
        ),
        ("[medium]\nname = \"breadcrumbs\"\n", ""),
    ]);
    let intent = Intent::Goal {
        literal: "(collected breadcrumbs table)".to_owned(),
        tool_in_hand: Some("brush".to_owned()),
        available_tools: vec!["sponge".to_owned()],
    };
    assert_eq!(parsed(&text).unwrap().intent, intent);
    // A setting of the goal replaces the action, and the tool that was named is in hand.
    let file = set(SMALL, &[("goal", "(skimmed breadcrumbs table)")]).unwrap();
    let intent = Intent::Goal {
        literal: "(skimmed breadcrumbs table)".to_owned(),
        tool_in_hand: Some("sponge".to_owned()),
        available_tools: Vec::new(),
    };
    assert_eq!(file.intent, intent);
}

#[test]
fn settings_override_the_text_and_are_checked_like_it() {
    let settings = [
        ("particles.count", "20"),
        ("surface.size_m", "[1.0, 0.5]"),
        ("scene.0.position_m", "[0.3, 0, 0.05]"),
        ("collect.goal_m", "[0.1, 0]"),
        ("medium.name", "dust"),
        ("action", "collect"),
        ("seed", "18446744073709551615"),
    ];
    let file = set(SMALL, &settings).unwrap();
    assert_eq!(file.run.plan.seed, u64::MAX);
    let medium = "dust".to_owned();
    let tool = "sponge".to_owned();
    let action = Action::Collect;
    assert_eq!(
        file.intent,
        Intent::Action {
            action,
            tool,
            medium
        }
    );
    let task = resolved_as(&file, action, "sponge", "breadcrumbs", &[]).unwrap();
    assert_eq!(task.particles.len(), 20);
    assert_eq!(task.surface.outline.area(), 0.5);
    assert_eq!(task.collect_goal, Some(Point2::new(0.1, 0.0)));
    assert_eq!(task.scene[0].world_from_object.translation.x, 0.3);

    for (key, value, expected) in [
        (
            "particles.count",
            "x",
            "setting particles.count:1:1: particles.count: expected a whole number, found the string \"x\"",
        ),
        (
            "surface.size_m",
            "[1, 200]",
            "setting surface.size_m:1:5: surface.size_m[1] = 200 is outside its limits: at least 0.001 and at most 100",
        ),
        (
            "surface.colour",
            "3",
            "setting surface.colour:1:1: surface: unknown key \"colour\"",
        ),
        (
            "scene.1.name",
            "x",
            "setting scene.1.name: \"1\" is not an index into an array of length 1",
        ),
        (
            "scene.name",
            "x",
            "setting scene.name: \"name\" is not an index into an array of length 1",
        ),
        (
            "name.first",
            "x",
            "setting name.first: \"first\" is not a key of the string \"small\"",
        ),
        ("", "x", "setting : the key has an empty part"),
    ] {
        let error = set(SMALL, &[(key, value)]).expect_err(key).to_string();
        assert!(error.starts_with(expected), "{error}");
    }
}

#[test]
fn the_same_file_and_seed_give_the_same_task() {
    let file = parsed(SMALL).unwrap();
    let particles = |seed| {
        let mut none = |_: &str| Err("not needed".to_owned());
        let shipped = KnowledgeSource::BuiltIn;
        file.resolve(
            Action::Skim,
            "sponge",
            "breadcrumbs",
            seed,
            &shipped.base().unwrap(),
            &mut none,
            &mut |path| shipped.asset(path),
        )
        .unwrap()
        .particles
    };
    assert_eq!(particles(4), particles(4));
    assert_ne!(particles(4), particles(5));
}

proptest! {
    #[test]
    fn no_text_makes_the_reader_panic(text in any::<String>(), key in "[a-z0-9_.]{0,12}", value in any::<String>()) {
        let _ = parsed(&text);
        let _ = set(SMALL, &[(&key, &value)]);
    }

    #[test]
    fn no_change_of_the_template_makes_the_reader_panic(
        start in 0..TaskFile::TEMPLATE.len(), length in 0_usize..40, by in "[\\[\\]{}=,.\"#\n a-z0-9_-]{0,20}"
    ) {
        let text = TaskFile::TEMPLATE;
        let start = text.floor_char_boundary(start);
        let end = text.floor_char_boundary((start + length).min(text.len()));
        let changed = format!("{}{by}{}", &text[..start], &text[end..]);
        if let Err(error) = parsed(&changed) {
            prop_assert!(error.to_string().starts_with("small.toml:"), "{}", error);
        }
    }

    #[test]
    fn no_outline_makes_the_reader_panic(points in prop::collection::vec((-3_i8..3, -3_i8..3), 0..8)) {
        let text = format!("outline_m = {points:?}").replace('(', "[").replace(')', "]");
        let text = small_with(&[("size_m = [0.5, 0.4]", &text), ("[\"y_min\"]", "[0]")]);
        if let Ok(file) = parsed(&text) {
            prop_assert!(file.surface.surface.outline.area() >= 1e-6);
        }
    }
}

/// A task with a tool, a medium and a surface of its own.
const OWN: &str = r#"schema = 1
name = "own"
action = "collect"
[tool]
name = "felt_pad"
footprint_m = [0.06, 0.12]
compression_depth_m = 0.002
[medium]
name = "sawdust"
kind = "powder"
[surface]
name = "workbench"
friction = 0.5
size_m = [0.5, 0.4]
[interaction]
press_force_n = 12
sigma = 0.4
[particles]
source = "uniform"
count = 10
"#;

#[test]
fn a_task_may_define_what_the_knowledge_does_not_have() {
    let mut knowledge = KnowledgeSource::BuiltIn.base().unwrap();
    let file = parsed(OWN).unwrap();
    let assumed = file.extend(&mut knowledge).unwrap();
    assert_eq!(
        assumed,
        [
            "tool \"felt_pad\" is taken to be 0.05 m high: set tool.height_m",
            "the knowledge base has no interaction of felt_pad on sawdust on workbench: assuming stiffness_n_per_m = 500, damping_ratio = 0.7, nullspace_posture_weight = 0.2, compression_depth_m = 0.002, mu = -1.05, mu_spread = 0.3, ln_sigma_spread = 0.2 (set them in [interaction])"
        ]
    );
    let known = knowledge
        .interaction("felt_pad", "sawdust", "workbench")
        .unwrap();
    assert_eq!((known.press_force_n, known.likelihood.sigma), (12.0, 0.4));
    let mut none = |_: &str| Err("not needed".to_owned());
    let mut no_mesh = |_: &str| Err("not needed".to_owned());
    let (tool, medium) = ("felt_pad", "sawdust");
    let task = file
        .resolve(
            Action::Collect,
            tool,
            medium,
            1,
            &knowledge,
            &mut none,
            &mut no_mesh,
        )
        .unwrap();
    assert!((task.tool.footprint.area() - 0.06 * 0.12).abs() < 1e-8);
    assert_eq!(knowledge.surface("workbench").unwrap().friction, 0.5);
}

#[test]
fn a_task_may_override_what_the_knowledge_has() {
    let text = format!("{SMALL}[interaction]\npress_force_n = 4\ncompression_depth_m = 0\n");
    let file = parsed(&text).unwrap();
    let mut knowledge = KnowledgeSource::BuiltIn.base().unwrap();
    let before = (knowledge.interaction("sponge", "breadcrumbs", "table")).cloned();
    let assumed = file.extend(&mut knowledge).unwrap();
    let now = knowledge
        .interaction("sponge", "breadcrumbs", "table")
        .unwrap();
    assert_eq!((now.press_force_n, now.compression_depth_m), (4.0, 0.0));
    // The thresholds stay the same in newtons.
    let newtons = |known: &Interaction| known.likelihood.mu.exp() * known.press_force_n;
    let before = before.unwrap();
    assert!((newtons(now) - newtons(&before)).abs() < 1e-12);
    assert_eq!(now.likelihood.sigma, before.likelihood.sigma);
    assert_eq!(
        assumed,
        [
            "interaction.press_force_n is 4 N, and the knowledge base has 10 N: assuming that particles need the same force, and that the tool is as stiff up to twice its compression: interaction.mu = -0.134, so that 70.4 % of the particles react when the tool first touches them"
        ]
    );
    // On other surfaces, the interaction is unchanged.
    let board = knowledge
        .interaction("sponge", "breadcrumbs", "chopping_board")
        .unwrap();
    assert_eq!(board.press_force_n, 10.0);
}

#[test]
fn a_force_alone_scales_the_compression_and_a_given_likelihood_holds() {
    let known = |interaction: &str| {
        let file = parsed(&format!("{SMALL}[interaction]\n{interaction}\n")).unwrap();
        let mut knowledge = KnowledgeSource::BuiltIn.base().unwrap();
        let assumed = file.extend(&mut knowledge).unwrap();
        let now = knowledge.interaction("sponge", "breadcrumbs", "table");
        (now.unwrap().clone(), assumed.len())
    };
    let (declared, _) = known("press_force_n = 10");
    let (gentle, said) = known("press_force_n = 5");
    let stiffness = |known: &Interaction| known.press_force_n / known.compression_depth_m;
    assert_eq!((stiffness(&gentle), said), (stiffness(&declared), 1));
    let (hard, _) = known("press_force_n = 40");
    assert_eq!(
        hard.compression_depth_m,
        2.0 * declared.compression_depth_m,
        "foam bottoms out"
    );
    let (stated, said) = known("press_force_n = 5\nmu = -1.0");
    assert_eq!((stated.likelihood.mu, said), (-1.0, 1), "the compression");
    let (stated, said) = known("press_force_n = 5\nmu = -1.0\ncompression_depth_m = 0.003");
    assert_eq!((stated.compression_depth_m, said), (0.003, 0));
    let (hovers, said) = known("press_force_n = 5\ngap_m = 0.003");
    assert_eq!((&hovers.likelihood, said), (&declared.likelihood, 0));
    let (same, said) = known("press_force_n = 10");
    assert_eq!((&same.likelihood, said), (&declared.likelihood, 0));
}

#[test]
fn a_tool_that_a_task_defines_keeps_its_compression_beside_a_known_interaction() {
    let text = SMALL.replace(
        "[tool]\nname = \"sponge\"",
        "[tool]\nname = \"sponge\"\nfootprint_m = [0.06, 0.12]\ncompression_depth_m = 0.001",
    );
    assert_ne!(text, SMALL);
    let mut knowledge = KnowledgeSource::BuiltIn.base().unwrap();
    parsed(&text).unwrap().extend(&mut knowledge).unwrap();
    let now = knowledge.interaction("sponge", "breadcrumbs", "table");
    assert_eq!(now.unwrap().compression_depth_m, 0.001);
}

#[test]
fn what_a_task_defines_must_hold_together() {
    for (piece, by, expected) in [
        (
            "\"felt_pad\"",
            "\"Felt pad\"",
            "5:8: tool.name: \"Felt pad\" is not a valid new name",
        ),
        ("kind = \"powder\"", "", "9:8: unknown medium \"sawdust\""),
        (
            "kind = \"powder\"",
            "kind = \"liquid\"\ngrain_size_m = [0.1, 0.1]",
            "11:16: medium.grain_size_m: a liquid has no grains",
        ),
        (
            "kind = \"powder\"",
            "kind = \"powder\"\ngrain_size_m = [0.01, 0.001]",
            "11:16: medium.grain_size_m: the minimum 0.01 exceeds the maximum 0.001",
        ),
        (
            "footprint_m = [0.06, 0.12]",
            "mesh = \"pad.stl\"\nheight_m = 0.01",
            "7:12: tool.height_m: this key needs footprint_m",
        ),
        (
            "footprint_m = [0.06, 0.12]",
            "footprint_m = [0.06, 0.12]\nmesh = \"pad.stl\"",
            "7:8: tool.mesh: footprint_m and mesh exclude each other",
        ),
        (
            "footprint_m = [0.06, 0.12]\n",
            "",
            "6:23: tool.compression_depth_m: this key needs footprint_m or mesh",
        ),
        (
            "sigma = 0.4",
            "sigma = 0",
            "17:9: interaction.sigma = 0 is outside its limits",
        ),
        (
            "sigma = 0.4",
            "actions = []",
            "17:11: interaction.actions: at least one action is needed",
        ),
    ] {
        assert_eq!(OWN.matches(piece).count(), 1, "{piece} must occur once");
        let mut knowledge = KnowledgeSource::BuiltIn.base().unwrap();
        let extended = parsed(&OWN.replace(piece, by)).and_then(|file| file.extend(&mut knowledge));
        let error = extended.expect_err(by).to_string();
        assert!(
            error.starts_with(&format!("small.toml:{expected}")),
            "{by:?}: {error}"
        );
    }
}
