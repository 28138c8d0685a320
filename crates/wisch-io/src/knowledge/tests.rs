use super::*;
use crate::KnowledgeSource;
use proptest::prelude::*;
use std::collections::BTreeSet;
use wisch::geometry::Vector3;
use wisch::represent::{Action, AreaOfEffect, Effect, MediumKind};

fn shipped() -> KnowledgeBase {
    KnowledgeSource::BuiltIn
        .base()
        .unwrap_or_else(|error| panic!("{error}"))
}

/// The smallest text with an entry of each kind, of which tests replace pieces.
const SMALL: &str = r#"schema = 1
[[tool]]
name = "squeegee"
mesh_file = "squeegee.stl"
compression_depth_m = 0.002
rotation_about_normal_rad = [-0.5, 0.5]
area_of_effect = { width_m = 0.3, depth_m = 0.01 }
tilt = { axis_in_tool = [0.0, 1.0, 0.0], range_rad = [-0.2, 0.4] }
grasp = "by the handle"
[[medium]]
name = "gravel"
kind = "solid"
grain_size_m = [0.01, 0.02]
[[surface]]
name = "yard"
friction = 0.6
[[surface]]
name = "roof"
friction = 0.7
[[interaction]]
tool = "squeegee"
medium = "gravel"
surface = "any"
actions = ["skim"]
press_force_n = 10
stiffness_n_per_m = 500.0
damping_ratio = 0.7
nullspace_posture_weight = 0.0
mu = 0.0
sigma = 1.0
"#;

/// Returns the error of reading `SMALL` after one piece of it is replaced.
fn error_after(piece: &str, by: &str) -> String {
    assert_eq!(SMALL.matches(piece).count(), 1, "{piece} must occur once");
    let text = SMALL.replace(piece, by);
    parse_knowledge(&[("small.toml", &text)])
        .expect_err("the text is broken")
        .to_string()
}

#[test]
fn an_entry_says_what_its_file_says() {
    let knowledge = parse_knowledge(&[("small.toml", SMALL)]).unwrap();
    let tool = knowledge.tool("squeegee").unwrap();
    let area = AreaOfEffect {
        width_m: 0.3,
        depth_m: 0.01,
    };
    assert_eq!(tool.area_of_effect, Some(area));
    let tilt = tool.tilt.unwrap();
    assert_eq!(*tilt.axis_in_tool, Vector3::y());
    assert_eq!((tilt.range.min_rad, tilt.range.max_rad), (-0.2, 0.4));
    assert_eq!((tool.grip, tool.second_grip), (None, None));
    let interaction = knowledge.interaction("squeegee", "gravel", "roof").unwrap();
    assert_eq!(interaction.press_force_n, 10.0);
    assert_eq!(interaction.surface, SurfaceScope::Any);
    assert_eq!(interaction.actions, BTreeSet::from([Action::Skim]));
}

#[test]
fn the_compression_depth_is_the_tools_unless_the_interaction_says_otherwise() {
    let depth = |text: &str| {
        let knowledge = parse_knowledge(&[("small.toml", text)]).unwrap();
        let interaction = knowledge.interaction("squeegee", "gravel", "yard");
        interaction.unwrap().compression_depth_m
    };
    assert_eq!(depth(SMALL), 0.002);
    let overridden = SMALL.replace("mu = 0.0", "compression_depth_m = 0.004\nmu = 0.0");
    assert_eq!(depth(&overridden), 0.004);
    // A rigid tool.
    let rigid = SMALL.replace("compression_depth_m = 0.002", "compression_depth_m = 0");
    assert_eq!(depth(&rigid), 0.0);
}

#[test]
fn what_is_known_of_the_very_surface_comes_before_what_is_known_of_any() {
    let at = SMALL.find("[[interaction]]").unwrap();
    let on_the_roof = (SMALL[at..].replace("\"any\"", "\"roof\"")).replace("n = 10", "n = 3");
    let text = format!("{SMALL}{on_the_roof}");
    let knowledge = parse_knowledge(&[("small.toml", &text)]).unwrap();
    let force = |surface| {
        let interaction = knowledge.interaction("squeegee", "gravel", surface);
        interaction.unwrap().press_force_n
    };
    assert_eq!((force("roof"), force("yard")), (3.0, 10.0));
}

#[test]
fn texts_may_refer_to_each_other_in_any_order() {
    let (entries, interactions) = SMALL.split_once("[[interaction]]").unwrap();
    let interactions = format!("schema = 1\n[[interaction]]{interactions}");
    let files = [("b.toml", interactions.as_str()), ("a.toml", entries)];
    assert_eq!(
        parse_knowledge(&files).unwrap(),
        parse_knowledge(&[("small.toml", SMALL)]).unwrap()
    );
}

#[test]
fn a_broken_text_is_an_error_with_its_line() {
    let cases = [
        ("name = \"yard\"", "name = yard", "small.toml:15:8: "),
        ("friction = 0.6", "friction = \"low\"", "small.toml:16:12: "),
        (
            "friction = 0.6",
            "friktion = 0.6",
            "small.toml:16:1: unknown field `friktion`",
        ),
        ("friction = 0.6\n", "", "missing field `friction`"),
        (
            "\"solid\"",
            "\"gas\"",
            "small.toml:12:8: unknown variant `gas`",
        ),
        (
            "schema = 1",
            "schema = 2",
            "small.toml:1:10: schema 2 is not supported; this version reads schema 1",
        ),
        ("schema = 1\n", "", "small.toml:1:1: missing field `schema`"),
    ];
    for (piece, by, expected) in cases {
        let error = error_after(piece, by);
        assert!(error.contains(expected), "{expected:?} is not in {error:?}");
    }
}

#[test]
fn an_unknown_reference_is_an_error_with_its_line_and_the_nearest_name() {
    let cases = [
        (
            "tool = \"squeegee\"",
            "tool = \"squeege\"",
            r#"small.toml:21:8: unknown tool "squeege"; nearest: squeegee"#,
        ),
        (
            "medium = \"gravel\"",
            "medium = \"grovel\"",
            r#"small.toml:22:10: unknown medium "grovel"; nearest: gravel"#,
        ),
        (
            "\"any\"",
            "\"rof\"",
            r#"small.toml:23:11: unknown surface "rof"; nearest: roof; known: roof, yard"#,
        ),
        (
            "\"skim\"",
            "\"skin\"",
            r#"small.toml:24:12: unknown action "skin"; nearest: skim; known: skim, absorb, polish, dispense, collect"#,
        ),
    ];
    for (piece, by, expected) in cases {
        assert_eq!(error_after(piece, by), expected);
    }
}

#[test]
fn values_outside_their_limits_are_errors_with_value_and_limits() {
    let cases = [
        (
            "depth_m = 0.002",
            "depth_m = -0.002",
            "small.toml:5:23: compression_depth_m = -0.002 is outside its limits: at least 0 and at most 0.1",
        ),
        (
            "depth_m = 0.002",
            "depth_m = nan",
            "compression_depth_m = NaN is outside",
        ),
        ("width_m = 0.3", "width_m = inf", "width_m = inf is outside"),
        (
            "[-0.5, 0.5]",
            "[-0.5, 9.0]",
            "rotation_about_normal_rad = 9 is outside",
        ),
        (
            "[-0.5, 0.5]",
            "[0.5, -0.5]",
            "the minimum 0.5 exceeds the maximum -0.5",
        ),
        (
            "[0.0, 1.0, 0.0]",
            "[0.0, 0.0, 0.0]",
            "length of axis_in_tool = 0 is outside",
        ),
        (
            "[0.01, 0.02]",
            "[0.02, 0.01]",
            "the minimum 0.02 exceeds the maximum 0.01",
        ),
        ("[0.01, 0.02]", "[0.0, 0.01]", "grain_size_m = 0 is outside"),
        (
            "friction = 0.6",
            "friction = -0.6",
            "friction = -0.6 is outside",
        ),
        (
            "press_force_n = 10",
            "press_force_n = 0",
            "press_force_n = 0 is outside its limits: above 0 and at most 200",
        ),
        (
            "press_force_n = 10",
            "press_force_n = 1e9",
            "press_force_n = 1000000000 is outside",
        ),
        (
            "stiffness_n_per_m = 500.0",
            "stiffness_n_per_m = -1.0",
            "stiffness_n_per_m = -1 is outside",
        ),
        (
            "damping_ratio = 0.7",
            "damping_ratio = -0.1",
            "damping_ratio = -0.1 is outside its limits: at least 0",
        ),
        (
            "weight = 0.0",
            "weight = -1.0",
            "nullspace_posture_weight = -1 is outside",
        ),
        (
            "mu = 0.0",
            "mu = nan",
            "small.toml:29:6: mu = NaN is outside",
        ),
        (
            "sigma = 1.0",
            "sigma = 0.0",
            "small.toml:30:9: sigma = 0 is outside its limits: above 0",
        ),
        ("sigma = 1.0", "sigma = -1.0", "sigma = -1 is outside"),
    ];
    for (piece, by, expected) in cases {
        let error = error_after(piece, by);
        assert!(error.contains(expected), "{expected:?} is not in {error:?}");
    }
}

#[test]
fn an_entry_that_contradicts_itself_is_refused() {
    let cases = [
        (
            "\"solid\"",
            "\"liquid\"",
            "small.toml:11:8: medium gravel: a liquid has no grain_size_m",
        ),
        (
            "grain_size_m = [0.01, 0.02]\n",
            "",
            "medium gravel: grain_size_m = [min, max] is missing",
        ),
        (
            "grain_size_m = [0.01, 0.02]\n",
            "grain_size_m = [0.01, 0.02]\nkinetic_friction = 0.4\n",
            "medium gravel: kinetic_friction needs static_friction",
        ),
        (
            "grain_size_m = [0.01, 0.02]\n",
            "grain_size_m = [0.01, 0.02]\nstatic_friction = 0.3\nkinetic_friction = 0.4\n",
            "medium gravel: kinetic_friction exceeds static_friction",
        ),
        (
            "grain_size_m = [0.01, 0.02]\n",
            "grain_size_m = [0.01, 0.02]\nviscosity_pa_s = 0.1\n",
            "medium gravel: only a liquid has a viscosity",
        ),
        (
            "grain_size_m = [0.01, 0.02]\n",
            "grain_size_m = [0.01, 0.02]\ndensity_kg_per_m3 = 900.0\n",
            "medium gravel: viscosity_pa_s is missing",
        ),
        (
            "[\"skim\"]",
            "[]",
            "small.toml:24:11: an interaction needs at least one action",
        ),
        (
            "\"squeegee.stl\"",
            "\"\"",
            "small.toml:4:13: mesh_file is empty",
        ),
        (
            "name = \"yard\"",
            "name = \"any\"",
            "small.toml:15:8: \"any\" is not a valid name",
        ),
        (
            "name = \"yard\"",
            "name = \"Yard\"",
            "\"Yard\" is not a valid name",
        ),
        (
            "name = \"yard\"",
            "name = \"back yard\"",
            "\"back yard\" is not a valid name",
        ),
        ("name = \"yard\"", "name = \"\"", "\"\" is not a valid name"),
    ];
    for (piece, by, expected) in cases {
        let error = error_after(piece, by);
        assert!(error.contains(expected), "{expected:?} is not in {error:?}");
    }
}

#[test]
fn defining_something_twice_names_both_places() {
    assert_eq!(
        error_after("name = \"roof\"", "name = \"yard\""),
        "small.toml:18:8: surface yard is already defined at small.toml:15:8"
    );
    let error = parse_knowledge(&[("a.toml", SMALL), ("b.toml", SMALL)]).unwrap_err();
    let expected = "b.toml:3:8: tool squeegee is already defined at a.toml:3:8";
    assert_eq!(error.to_string(), expected);
    let again = &SMALL[SMALL.find("[[interaction]]").unwrap()..];
    let error = parse_knowledge(&[("a.toml", &format!("{SMALL}{again}"))]).unwrap_err();
    assert!(
        error
            .to_string()
            .contains("interaction squeegee, gravel, any is already defined")
    );
}

#[test]
fn a_look_up_of_something_unknown_names_the_nearest() {
    let knowledge = shipped();
    let error = knowledge.tool("spunge").unwrap_err().to_string();
    assert!(
        error.starts_with(r#"unknown tool "spunge"; nearest: sponge"#),
        "{error}"
    );
    let error = knowledge.medium("breadcrumb").unwrap_err().to_string();
    assert!(error.contains("nearest: breadcrumbs"), "{error}");
    let error = knowledge
        .tools_for("water", "windshild", Action::Skim)
        .unwrap_err();
    assert!(error.to_string().contains("nearest: windshield"), "{error}");
    assert_eq!(
        KnowledgeBase::default()
            .tool("sponge")
            .unwrap_err()
            .to_string(),
        r#"unknown tool "sponge"; no tool is known"#
    );
}

#[test]
fn a_combination_that_makes_no_sense_is_an_error_that_names_those_that_do() {
    let error = shipped()
        .interaction("broom", "water", "windshield")
        .unwrap_err();
    assert_eq!(
        error.to_string(),
        "no interaction of broom with water on windshield is known; tools known for it: sponge, window_wiper"
    );
}

#[test]
fn tools_are_ranked_by_their_chance_at_full_force() {
    let knowledge = shipped();
    let ranked = knowledge
        .tools_for("sand", "floor", Action::Collect)
        .unwrap();
    let names: Vec<&str> = ranked.iter().map(|tool| tool.tool.name.as_str()).collect();
    assert_eq!(names, ["sponge", "brush", "broom"]);
    assert!(ranked.is_sorted_by(|a, b| a.probability >= b.probability));
    assert!(knowledge.tools_for("sand", "floor", Action::Skim).is_ok());
    let none = knowledge
        .tools_for("water", "floor", Action::Collect)
        .unwrap();
    assert!(none.is_empty());
}

/// The outcomes of Fig. 11 and 13, as shares affected at full force.
#[test]
fn the_shipped_curves_have_the_outcomes_of_the_paper() {
    let knowledge = shipped();
    let share = |tool, medium, surface, force| {
        let interaction = knowledge.interaction(tool, medium, surface).unwrap();
        interaction.likelihood.probability(force)
    };
    let chippings = share("broom", "glass_chippings", "floor", 1.0);
    assert!(
        (0.85..0.90).contains(&chippings),
        "most chippings: {chippings}"
    );
    let sand = share("broom", "sand", "floor", 1.0);
    assert!((0.25..0.35).contains(&sand), "few of the sand: {sand}");
    let layer = share("brush", "detergent", "solar_panel", 1.0);
    assert!((0.25..0.35).contains(&layer), "a layer stays: {layer}");
    // Steep: at a third of the force the wiper loses nearly nothing.
    let weak = share("window_wiper", "detergent", "solar_panel", 0.33);
    assert!(weak > 0.99, "weak contact works: {weak}");
}

#[test]
fn the_scenarios_have_their_sponge() {
    let knowledge = shipped();
    for surface in ["chopping_board", "table", "windshield"] {
        let interaction = knowledge
            .interaction("sponge", "breadcrumbs", surface)
            .unwrap();
        assert_eq!(interaction.actions, BTreeSet::from(Action::WIPING));
        assert_eq!(interaction.compression_depth_m, 0.005);
    }
}

#[test]
fn no_shipped_tool_absorbs_what_it_could_not() {
    for interaction in shipped().interactions() {
        let absorbs = interaction.actions.contains(&Action::Absorb);
        let medium = shipped().medium(&interaction.medium).unwrap().kind;
        let can = match interaction.tool.as_str() {
            "sponge" => !["glass_chippings", "sand"].contains(&interaction.medium.as_str()),
            "vacuum_nozzle" => medium != MediumKind::Liquid,
            _ => false,
        };
        assert!(can || !absorbs, "{interaction:?}");
    }
}

#[test]
fn every_action_has_its_name_and_effect() {
    for action in Action::ALL {
        assert_eq!(action.as_str().parse(), Ok(action));
        assert_eq!(action.effect() == Effect::Absorb, action == Action::Absorb);
    }
}

proptest! {
    #[test]
    fn no_text_makes_the_reader_panic(text in "\\PC*", tail in ".*") {
        let _ = parse_knowledge(&[("any.toml", &text)]);
        let _ = parse_knowledge(&[("any.toml", &format!("{SMALL}{tail}"))]);
    }

    #[test]
    fn no_change_to_a_text_makes_the_reader_panic(
        file in prop::sample::select(vec!["small", "tools.toml", "media.toml", "surfaces.toml"]),
        cuts in prop::collection::vec((0.0..1.0_f64, 0..12_usize, "[\\PC\n\"\\[\\]{}=.#-]{0,6}"), 1..5)
    ) {
        let shipped = KnowledgeSource::BuiltIn.asset(file).map(String::from_utf8);
        let mut text = shipped.map_or(SMALL.to_owned(), |text| text.expect("it is text"));
        for (share, length, inserted) in cuts {
            let start = text.floor_char_boundary((share * text.len() as f64) as usize);
            let end = text.floor_char_boundary(start + length);
            text.replace_range(start..end, &inserted);
        }
        if let Err(error) = parse_knowledge(&[("mutated.toml", &text)]) {
            prop_assert!(!error.to_string().is_empty());
        }
    }

    #[test]
    fn every_offset_has_a_place(text in "(\\PC|\n){0,40}", offset in 0..200_usize) {
        let place = Place::from_offset("a", &text, offset);
        prop_assert!(place.line <= text.matches('\n').count() + 1);
        prop_assert!(place.column <= text.chars().count() + 1);
    }
}

/// The grips of the tool in `SMALL`, as keys of its entry.
const GRIPS: &str = r#"grip = { point_m = [0.0, 0.1, 0.9], hand_rpy_rad = [0.1, 0.0, 0.0] }
second_grip = { point_m = [0.0, 0.0, 1.2], axis_in_tool = [0.0, 0.0, 1.0], max_lean_rad = 0.6 }
grasp = "by the handle""#;

#[test]
fn a_tool_is_held_as_its_file_says() {
    let text = SMALL.replace("grasp = \"by the handle\"", GRIPS);
    let knowledge = parse_knowledge(&[("small.toml", &text)]).unwrap();
    let tool = knowledge.tool("squeegee").unwrap();
    let hand = tool.grip.unwrap().tool_from_hand;
    assert_eq!(hand.translation.vector, Vector3::new(0.0, 0.1, 0.9));
    assert!((hand.rotation.scaled_axis() - Vector3::x() * 0.1).norm() < 1e-15);
    let second = tool.second_grip.unwrap();
    assert_eq!(second.point_in_tool.coords, Vector3::new(0.0, 0.0, 1.2));
    assert_eq!((*second.axis_in_tool, second.max_lean), (Vector3::z(), 0.6));
}

#[test]
fn a_grip_out_of_range_is_named_with_its_limit() {
    for (piece, by, message) in [
        (
            "0.0, 0.1, 0.9",
            "0.0, 0.1, 3.1",
            "point_m = 3.1 is outside its limits: at least -3 and at most 3",
        ),
        (
            "hand_rpy_rad = [0.1",
            "hand_rpy_rad = [4.0",
            "hand_rpy_rad = 4 is outside its limits: at least -3.14",
        ),
        (
            "axis_in_tool = [0.0, 0.0, 1.0]",
            "axis_in_tool = [0.0, 0.0, 0.5]",
            "length of axis_in_tool = 0.5",
        ),
        (
            "max_lean_rad = 0.6",
            "max_lean_rad = 1.6",
            "max_lean_rad = 1.6",
        ),
    ] {
        assert_eq!(GRIPS.matches(piece).count(), 1, "{piece}");
        let error = error_after("grasp = \"by the handle\"", &GRIPS.replace(piece, by));
        assert!(error.contains(message), "{error}");
    }
}
