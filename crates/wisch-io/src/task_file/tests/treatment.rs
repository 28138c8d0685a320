//! Tasks that treat a surface, and tools that hover.

use super::*;
use wisch::represent::{GoalState, Treatment};

const POLISH: &str = r#"
schema = 1
name = "polish"
action = "polish"
[tool]
name = "sponge"
[medium]
name = "polishing_paste"
[surface]
name = "table"
size_m = [0.4, 0.3]
[polish]
passes = 3
[particles]
source = "surface"
count = 1200
"#;

#[test]
fn a_polish_has_its_passes_and_the_places_of_the_surface() {
    let task = resolved(&parsed(POLISH).unwrap()).unwrap();
    let preston = None;
    assert_eq!(
        task.treatment,
        Some(Treatment::Polish {
            passes: 3,
            max_passes: 4,
            preston
        })
    );
    assert_eq!(task.goal(), Some(GoalState::Polished { passes: 3 }));
    assert_eq!(task.particles.len(), 40 * 30);
}

#[test]
fn the_earlier_name_of_dispense_is_read_with_a_hint() {
    let earlier = POLISH.replace(r#"action = "polish""#, r#"action = "emit""#).replace(
        "[polish]\npasses = 3",
        "[interaction]\nactions = [\"emit\"]\n[emit]\nthickness_m = 1e-4\nvolume_m3_per_m = 1e-5",
    );
    let file = parsed(&earlier).unwrap();
    let expected = Intent::Action {
        action: Action::Dispense,
        tool: "sponge".to_owned(),
        medium: "polishing_paste".to_owned(),
    };
    assert_eq!(file.intent, expected);
    let hint = |at: &str, what: &str| {
        format!("small.toml:{at}: the {what} today; the earlier name is still read")
    };
    assert_eq!(
        file.remarks,
        [
            hint("4:10", r#"action "emit" is called "dispense""#),
            hint("13:12", r#"action "emit" is called "dispense""#),
            hint("14:1", "table [emit] is called [dispense]"),
        ]
    );
    assert!(parsed(POLISH).unwrap().remarks.is_empty());
}

#[test]
fn what_a_treatment_lacks_or_cannot_have_is_said() {
    for (piece, by, expected) in [
        (
            "[polish]\npasses = 3\n",
            "",
            r#"polish: key "passes" is missing"#,
        ),
        ("passes = 3", "passes = 0", "polish.passes"),
        (
            "passes = 3",
            "passes = 3\nmax_passes = 2",
            "polish.max_passes: 2 is below polish.passes = 3",
        ),
        (
            "[polish]",
            "[perception]\nsenses = [\"touch\", \"sight\"]\n[polish]",
            "perception.senses: \"sight\" does not work with the action polish",
        ),
        (
            "passes = 3",
            "passes = 3\npreston_per_pa = 1",
            "preston_per_pa",
        ),
        (
            "action = \"polish\"",
            "action = \"absorb\"",
            "sponge cannot absorb polishing_paste on table according to the knowledge base, only polish",
        ),
    ] {
        let text = POLISH.replace(piece, by);
        assert_ne!(text, POLISH, "{piece}");
        let found = parsed(&text).and_then(|file| resolved(&file));
        let error = found.unwrap_err().to_string();
        assert!(error.contains(expected), "{error}");
    }
}

#[test]
fn a_tool_that_hovers_is_raised_by_its_gap() {
    let text = format!("{SMALL}[interaction]\ngap_m = 0.004\n");
    let file = parsed(&text).unwrap();
    let mut knowledge = KnowledgeSource::BuiltIn.base().unwrap();
    file.extend(&mut knowledge).unwrap();
    let now = knowledge
        .interaction("sponge", "breadcrumbs", "table")
        .unwrap();
    assert_eq!((now.gap_m, now.contact_force()), (0.004, 0.0));
    let shipped = KnowledgeSource::BuiltIn;
    let task = file
        .resolve(
            Action::Absorb,
            "sponge",
            "breadcrumbs",
            1,
            &knowledge,
            &mut |_| Err("no such file".to_owned()),
            &mut |path| shipped.asset(path),
        )
        .unwrap();
    let heights = task.tool.mesh.vertices().iter().map(|vertex| vertex.z);
    assert!((heights.fold(f64::INFINITY, f64::min) - 0.004).abs() < 1e-9);
    assert_eq!(task.surface_reaction().norm(), 0.0);
}
