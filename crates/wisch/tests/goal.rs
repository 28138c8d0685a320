//! From goals to actions, with the knowledge and the domain that are shipped.

use proptest::prelude::*;
use wisch::goal::{Domain, GoalError, GoalLiteral, ResolvedGoal, resolve_goal};
use wisch::represent::{Action, Interaction, KnowledgeBase, SurfaceScope};
use wisch_io::KnowledgeSource;

/// Longest text that is read [bytes].
const MAX_TEXT_LEN: usize = 1 << 20;
/// Words that begin something other than an atom.
const CONSTRUCTS: [&str; 12] = [
    "or",
    "imply",
    "exists",
    "forall",
    "when",
    "oneof",
    "preference",
    "assign",
    "increase",
    "decrease",
    "scale-up",
    "scale-down",
];

fn wiping_text() -> String {
    let text = KnowledgeSource::BuiltIn.asset("wiping.pddl").unwrap();
    String::from_utf8(text).unwrap()
}

fn wiping() -> Domain {
    let domain = Domain::parse("wiping.pddl", &wiping_text());
    domain.unwrap_or_else(|error| panic!("{error}"))
}

fn knowledge() -> KnowledgeBase {
    let knowledge = KnowledgeSource::BuiltIn.base();
    knowledge.unwrap_or_else(|error| panic!("{error}"))
}

fn resolve(goal: &str, in_hand: Option<&str>, at_hand: &[&str]) -> Result<ResolvedGoal, GoalError> {
    let goal = GoalLiteral::parse(goal)?;
    resolve_goal(&goal, &wiping(), &knowledge(), in_hand, at_hand)
}

fn resolve_error(goal: &str, in_hand: Option<&str>, at_hand: &[&str]) -> String {
    resolve(goal, in_hand, at_hand).unwrap_err().to_string()
}

const ALL_TOOLS: [&str; 5] = ["broom", "brush", "sponge", "vacuum_nozzle", "window_wiper"];

#[test]
fn an_empty_hand_grasps_a_tool_first() {
    let resolved = resolve("(skimmed detergent solar_panel)", None, &["window_wiper"]).unwrap();
    assert_eq!(
        resolved,
        ResolvedGoal {
            action: Action::Skim,
            tool: "window_wiper".to_owned(),
            medium: "detergent".to_owned(),
            surface: "solar_panel".to_owned(),
            steps: vec![
                "(grasp window_wiper)".to_owned(),
                "(skim window_wiper detergent solar_panel)".to_owned()
            ],
        }
    );
}

#[test]
fn a_tool_in_hand_that_will_do_is_kept() {
    // The brush is worse at it, but changing tools would make the plan longer.
    let resolved = resolve("(skimmed detergent solar_panel)", Some("brush"), &ALL_TOOLS).unwrap();
    assert_eq!(resolved.steps, ["(skim brush detergent solar_panel)"]);
}

#[test]
fn a_tool_in_hand_that_will_not_do_is_released() {
    let resolved = resolve("(absorbed water table)", Some("broom"), &["sponge"]).unwrap();
    let expected = [
        "(release broom)",
        "(grasp sponge)",
        "(absorb sponge water table)",
    ];
    assert_eq!(resolved.steps, expected);
}

#[test]
fn of_equally_long_plans_the_one_with_the_best_tool_is_taken() {
    for order in [["brush", "window_wiper"], ["window_wiper", "brush"]] {
        let resolved = resolve("(skimmed detergent windshield)", None, &order).unwrap();
        assert_eq!(resolved.tool, "window_wiper");
        let resolved = resolve("(skimmed detergent windshield)", Some("broom"), &order).unwrap();
        assert_eq!(resolved.tool, "window_wiper");
    }
}

#[test]
fn every_shipped_interaction_is_reached_by_a_goal() {
    let knowledge = knowledge();
    let mut reached = 0;
    for interaction in knowledge.interactions() {
        let surfaces: Vec<&str> = match &interaction.surface {
            SurfaceScope::Named(surface) => vec![surface],
            SurfaceScope::Any => knowledge.surfaces().map(|s| s.name.as_str()).collect(),
        };
        for surface in surfaces {
            for action in &interaction.actions {
                let participle = match action {
                    Action::Absorb => "absorbed",
                    Action::Collect => "collected",
                    Action::Skim => "skimmed",
                    Action::Polish => "polished",
                    Action::Dispense => "dispensed",
                };
                let goal = format!("({participle} {} {surface})", interaction.medium);
                let tool = interaction.tool.as_str();
                let resolved = resolve(&goal, None, &[tool]).unwrap_or_else(|e| panic!("{e}"));
                assert_eq!((resolved.action, resolved.tool.as_str()), (*action, tool));
                assert_eq!(resolved.medium, interaction.medium);
                assert_eq!(resolved.surface, surface);
                reached += 1;
            }
        }
    }
    assert!(reached > 100, "only {reached} goals");
}

#[test]
fn the_earlier_name_of_dispensed_is_read() {
    let mut knowledge = knowledge();
    let mut interaction = Interaction::assume("sponge", "water");
    interaction.surface = SurfaceScope::Named("table".to_owned());
    interaction.actions = [Action::Dispense].into();
    knowledge.insert_interaction(interaction).unwrap();
    let resolve = |predicate: &str, domain: &Domain| {
        let literal = GoalLiteral::parse(&format!("({predicate} water table)")).unwrap();
        let resolved = resolve_goal(&literal, domain, &knowledge, None, &["sponge"]);
        resolved.unwrap_or_else(|error| panic!("{error}"))
    };
    let today = resolve("dispensed", &wiping());
    assert_eq!(today.action, Action::Dispense);
    assert_eq!(today.steps[1], "(dispense sponge water table)");
    assert_eq!(resolve("emitted", &wiping()).steps, today.steps);

    // A user's domain that has the earlier names.
    let text = wiping_text()
        .replace("dispensed", "emitted")
        .replace("dispense", "emit");
    let domain = Domain::parse("wiping.pddl", &text).unwrap_or_else(|error| panic!("{error}"));
    let resolved = resolve("emitted", &domain);
    assert_eq!(resolved.action, Action::Dispense);
    assert_eq!(resolved.steps[1], "(emit sponge water table)");
}

#[test]
fn goals_that_cannot_be_reached_say_why() {
    assert_eq!(
        resolve_error("(collected water floor)", None, &ALL_TOOLS),
        "no known tool can collect water on floor; known for water on floor: absorb with sponge"
    );
    assert_eq!(
        resolve_error("(absorbed detergent table)", None, &["broom", "brush"]),
        "none of the available tools (broom, brush) can absorb detergent on table; tools that can: sponge"
    );
    assert_eq!(
        resolve_error("(absorbed water table)", None, &[]),
        "none of the available tools (none) can absorb water on table; tools that can: sponge"
    );
    assert_eq!(
        resolve_error("(holding sponge)", None, &["broom"]),
        "(holding sponge) needs sponge, which is not available; available: broom"
    );
    for goal in ["(holding sponge)", "(hand-empty)", "(on dust table)"] {
        assert_eq!(
            resolve_error(goal, None, &["sponge"]),
            format!(
                "goal {goal} needs no wiping action; goals that do: absorbed, collected, dispensed, polished, skimmed"
            )
        );
    }
}

#[test]
fn a_precondition_that_nothing_meets_is_named() {
    let text = wiping_text()
        .replace(
            "(hand-empty)\n    (holding",
            "(hand-empty)\n    (charged)\n    (holding",
        )
        .replace("(on ?m ?s) (can-skim", "(charged) (on ?m ?s) (can-skim");
    let domain = Domain::parse("charged.pddl", &text).unwrap();
    let goal = GoalLiteral::parse("(skimmed water windshield)").unwrap();
    let error = resolve_goal(&goal, &domain, &knowledge(), None, &["window_wiper"]).unwrap_err();
    let expected = "no plan reaches (skimmed water windshield): skim needs (charged)";
    assert_eq!(error.to_string(), expected);
}

#[test]
fn names_that_are_not_known_come_with_the_nearest() {
    let cases = [
        (
            "(colected dust table)",
            r#"goal:1:1: unknown predicate "colected"; nearest: collected"#,
        ),
        (
            "(collected dusk table)",
            r#"unknown medium "dusk"; nearest: dust"#,
        ),
        (
            "(collected dust tabel)",
            r#"unknown surface "tabel"; nearest: table"#,
        ),
        (
            "(holding spong)",
            r#"unknown tool "spong"; nearest: sponge"#,
        ),
    ];
    for (goal, expected) in cases {
        let error = resolve_error(goal, None, &ALL_TOOLS);
        assert!(error.starts_with(expected), "{error}");
    }
    let error = resolve_error("(collected dust table)", None, &["broomstick"]);
    assert!(
        error.contains(r#"unknown tool "broomstick"; nearest: broom"#),
        "{error}"
    );
    let error = resolve_error("(collected dust table)", Some("bush"), &ALL_TOOLS);
    assert!(
        error.contains(r#"unknown tool "bush"; nearest: brush"#),
        "{error}"
    );
}

#[test]
fn a_goal_that_is_no_atom_says_what_was_expected() {
    let cases = [
        ("", "goal:1:1: expected `(`, found the end of the text"),
        (
            "; nothing",
            "goal:1:10: expected `(`, found the end of the text",
        ),
        ("dust", "goal:1:1: expected `(`, found `dust`"),
        (
            "(collected dust\n  table",
            "goal:1:1: expected `)` for this parenthesis, found the end of the text",
        ),
        (
            "(collected dust table))",
            "goal:1:23: expected the end of the text, found `)`",
        ),
        (")", "goal:1:1: expected `(`, found `)`"),
        (
            "()",
            "goal:1:1: expected an atom `(predicate argument ...)`, found `()`",
        ),
        (
            "((a))",
            "goal:1:1: expected an atom `(predicate argument ...)`, found `((...) ...)`",
        ),
        (
            "(collected (dust) table)",
            "goal:1:12: expected a name or a `?variable`, found `(dust ...)`",
        ),
        (
            "(collected 3 table)",
            "goal:1:12: expected a name or a `?variable`, found `3`",
        ),
        (
            "(collected ?m table)",
            "goal:1:1: expected names only, found `?m`",
        ),
        (
            "(collected du§t table)",
            "goal:1:14: expected a word or a parenthesis, found '§'",
        ),
        (
            "(collected dust)",
            "goal:1:1: predicate collected takes 2 arguments, found 1",
        ),
        (
            "(and (collected dust table))",
            "goal:1:1: `and` in a single goal is not supported; expected typed STRIPS with negation",
        ),
        (
            "(not (on dust table))",
            "goal:1:1: `not` in a single goal is not supported; expected typed STRIPS with negation",
        ),
        (
            "(or (on dust table))",
            "goal:1:1: `or` is not supported; expected typed STRIPS with negation",
        ),
    ];
    for (goal, expected) in cases {
        assert_eq!(resolve_error(goal, None, &ALL_TOOLS), expected);
    }
}

#[test]
fn case_and_comments_make_no_difference() {
    let goal = GoalLiteral::parse(" ( Collected\n; what\n DUST table ) ; done").unwrap();
    assert_eq!(goal.to_string(), "(collected dust table)");
}

#[test]
fn names_that_are_keywords_of_the_parser_are_names_here() {
    let goal =
        GoalLiteral::parse("(at start problem define in-package over all end domain)").unwrap();
    assert_eq!(goal.predicate(), "at");
    let arguments = [
        "start",
        "problem",
        "define",
        "in-package",
        "over",
        "all",
        "end",
        "domain",
    ];
    assert_eq!(goal.arguments(), arguments);
}

/// Names go to the parser behind a letter, which once made `ot` the keyword `not`.
#[test]
fn what_is_left_of_a_keyword_is_a_name() {
    let keywords = [
        "define",
        "problem",
        "domain",
        "and",
        "not",
        "either",
        "assign",
        "scale-up",
        "scale-down",
        "increase",
        "decrease",
        "forall",
        "at",
        "over",
        "all",
        "start",
        "end",
    ];
    for rest in keywords.map(|keyword| &keyword[1..]) {
        let goal = GoalLiteral::parse(&format!("({rest} {rest})")).unwrap();
        assert_eq!(
            (goal.predicate(), goal.arguments()),
            (rest, &[rest.to_owned()][..])
        );
    }
}

#[test]
fn texts_beyond_the_limits_are_refused() {
    let deep = format!("{}{}", "(a ".repeat(65), ")".repeat(65));
    let expected = "goal: nesting of parentheses: 65 exceeds the limit of 64";
    assert_eq!(GoalLiteral::parse(&deep).unwrap_err().to_string(), expected);
    let long = " ".repeat(MAX_TEXT_LEN + 1);
    let expected = "goal: length in bytes: 1048577 exceeds the limit of 1048576";
    assert_eq!(GoalLiteral::parse(&long).unwrap_err().to_string(), expected);
    let word = format!("({})", "a".repeat(129));
    let expected = "goal: length of a word in bytes: 129 exceeds the limit of 128";
    assert_eq!(GoalLiteral::parse(&word).unwrap_err().to_string(), expected);
    assert!(GoalLiteral::parse(&"(".repeat(MAX_TEXT_LEN)).is_err());
}

proptest! {
    #[test]
    fn no_text_makes_a_reader_panic(text in "\\PC*", lisp in "[()a-z?:; \n=-]{0,80}") {
        for text in [&text, &lisp] {
            let _ = GoalLiteral::parse(text);
            let _ = Domain::parse("any.pddl", text);
        }
    }

    #[test]
    fn a_goal_reads_back_what_it_prints(
        predicate in "[a-z][a-z0-9_-]{0,10}", arguments in prop::collection::vec("[a-z][a-z0-9_-]{0,10}", 0..4)
    ) {
        prop_assume!(!["and", "not", "either"].contains(&predicate.as_str()));
        let text = format!("({predicate} {})", arguments.join(" "));
        if let Ok(goal) = GoalLiteral::parse(&text) {
            prop_assert_eq!(&GoalLiteral::parse(&goal.to_string()).unwrap(), &goal);
            prop_assert_eq!(goal.arguments(), arguments);
        } else {
            prop_assert!(CONSTRUCTS.contains(&predicate.as_str()));
        }
    }

    #[test]
    fn no_change_to_the_domain_makes_a_reader_or_the_search_panic(
        cuts in prop::collection::vec((0.0..1.0_f64, 0..12_usize, "[()a-z?:\\PC -]{0,6}"), 1..4)
    ) {
        let mut text = wiping_text();
        for (share, length, inserted) in cuts {
            let start = text.floor_char_boundary((share * text.len() as f64) as usize);
            let end = text.floor_char_boundary(start + length);
            text.replace_range(start..end, &inserted);
        }
        match Domain::parse("mutated.pddl", &text) {
            Err(error) => prop_assert!(!error.to_string().is_empty()),
            Ok(domain) => {
                let goal = GoalLiteral::parse("(collected dust floor)").unwrap();
                let _ = resolve_goal(&goal, &domain, &knowledge(), Some("sponge"), &ALL_TOOLS);
            }
        }
    }
}
