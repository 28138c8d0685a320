//! Sequences of steps for goals of several parts, with the knowledge and the domain that are shipped.

use proptest::prelude::*;
use std::collections::BTreeMap;
use wisch::goal::{
    CompoundGoal, Domain, GoalLiteral, MediumOnSurface, Sequence, Situation, StepPlace, StepTimes,
    Wiping,
};
use wisch::represent::{Action, KnowledgeBase, SurfaceEntry};
use wisch_io::KnowledgeSource;

const CHANGE: f64 = 10.0;
const EMPTY: f64 = 20.0;
const TOOLS: [&str; 3] = ["sponge", "brush", "window_wiper"];

/// Times of wiping by tool and surface [s], and places along a line, in seconds of way.
#[derive(Debug, Clone, Default)]
struct Times {
    wiping: BTreeMap<(String, String), f64>,
    at: BTreeMap<String, f64>,
}

impl Times {
    fn position(&self, place: StepPlace<'_>) -> f64 {
        match place {
            StepPlace::Start => 0.0,
            StepPlace::Surface(name) | StepPlace::Rack(name) => {
                self.at.get(name).copied().unwrap_or(0.0)
            }
        }
    }
}

impl StepTimes for Times {
    fn wiping(&self, wiping: &Wiping) -> Option<f64> {
        let key = (wiping.tool.clone(), wiping.surface.clone());
        if self.wiping.is_empty() {
            Some(60.0)
        } else {
            self.wiping.get(&key).copied()
        }
    }

    fn handling(&self, name: &str) -> f64 {
        if name == "empty" { EMPTY } else { CHANGE }
    }

    fn moving(&self, from: StepPlace<'_>, to: StepPlace<'_>) -> f64 {
        (self.position(from) - self.position(to)).abs()
    }
}

fn domain() -> Domain {
    KnowledgeSource::BuiltIn.domain().unwrap()
}

/// The shipped knowledge, with tables of further names.
fn knowledge(tables: usize) -> KnowledgeBase {
    let mut knowledge = KnowledgeSource::BuiltIn.base().unwrap();
    for table in 0..tables {
        knowledge.insert_surface(SurfaceEntry {
            name: format!("table{table}"),
            friction: 0.35,
        });
    }
    knowledge
}

fn on(medium: &str, surface: &str) -> MediumOnSurface {
    MediumOnSurface {
        medium: medium.to_owned(),
        surface: surface.to_owned(),
    }
}

fn steps(sequence: &Sequence) -> Vec<String> {
    sequence.steps.iter().map(ToString::to_string).collect()
}

fn plan(goal: &str, media: &[MediumOnSurface], tools: &[&str]) -> Sequence {
    let (domain, goal) = (domain(), CompoundGoal::parse(goal).unwrap());
    let situation = Situation::new(&domain, &knowledge(0), &goal, media, None, tools).unwrap();
    (situation.plan(&goal, StepPlace::Start, &Times::default())).unwrap()
}

#[test]
fn crumbs_go_before_the_water_among_them_and_a_loaded_tool_is_emptied() {
    let media = [
        on("water", "table"),
        on("breadcrumbs", "table"),
        on("water", "floor"),
    ];
    let sequence = plan(
        "(and (absorbed water table) (not (wet table)) (absorbed water floor))",
        &media,
        &["sponge"],
    );
    assert_eq!(sequence.left_out, []);
    let steps = steps(&sequence);
    let at = |step: &str| steps.iter().position(|one| one == step);
    let crumbs = steps
        .iter()
        .position(|step| step.contains("breadcrumbs table"));
    assert!(crumbs < at("(absorb sponge water table)"), "{steps:?}");
    // One of the spills is absorbed first, and the sponge is emptied before the other one.
    assert_eq!(
        steps
            .iter()
            .filter(|step| *step == "(empty sponge)")
            .count(),
        1
    );
    assert!(at("(absorb sponge water floor)").is_some());
}

#[test]
fn what_holds_needs_no_step_and_steps_change_what_holds() {
    let (domain, knowledge) = (domain(), knowledge(0));
    let goal = CompoundGoal::parse("(and (absorbed water table) (not (wet table)))").unwrap();
    let media = [on("water", "table")];
    let mut situation =
        Situation::new(&domain, &knowledge, &goal, &media, Some("sponge"), &[]).unwrap();
    let planned = |situation: &Situation<'_>| {
        situation
            .plan(&goal, StepPlace::Start, &Times::default())
            .unwrap()
    };
    let sequence = planned(&situation);
    assert_eq!(steps(&sequence), ["(absorb sponge water table)"]);
    let holds = |situation: &Situation<'_>| -> Vec<bool> {
        goal.parts()
            .map(|(holds, fact)| situation.holds(fact) == holds)
            .collect()
    };
    assert_eq!(holds(&situation), [false, false]);
    situation.apply(&sequence.steps[0]);
    assert_eq!(holds(&situation), [true, true]);
    assert_eq!(planned(&situation).steps, []);
}

#[test]
fn a_wiping_serves_the_parts_that_it_reaches_or_whose_way_it_clears() {
    let (domain, knowledge) = (domain(), knowledge(0));
    let goal = "(and (absorbed water table) (not (wet table)) (collected breadcrumbs table) (absorbed water floor))";
    let goal = CompoundGoal::parse(goal).unwrap();
    let media = [
        on("water", "table"),
        on("breadcrumbs", "table"),
        on("sand", "table"),
        on("water", "floor"),
    ];
    let tools = ["sponge", "brush", "broom"];
    let situation = Situation::new(&domain, &knowledge, &goal, &media, None, &tools).unwrap();
    let served = |action, medium: &str, surface: &str| {
        let wipings = situation.list_possible_wipings(&goal);
        let is_meant = |wiping: &&Wiping| {
            (wiping.action, &*wiping.medium, &*wiping.surface) == (action, medium, surface)
        };
        let wiping = wipings.iter().find(is_meant).unwrap();
        situation.find_served_parts(wiping, &goal)
    };
    assert_eq!(served(Action::Absorb, "water", "table"), [0, 1]);
    assert_eq!(served(Action::Absorb, "water", "floor"), [3]);
    // The crumbs are a part of the goal; the sand is wiped because it lies in the way of the water.
    assert_eq!(served(Action::Collect, "breadcrumbs", "table"), [2]);
    assert_eq!(served(Action::Collect, "sand", "table"), [0, 1]);
}

#[test]
fn what_cannot_be_reached_is_left_out_and_the_rest_is_planned() {
    let media = [on("breadcrumbs", "chopping_board"), on("water", "table")];
    let goal = "(and (collected breadcrumbs chopping_board) (absorbed water table))";
    let sequence = plan(goal, &media, &["brush"]);
    assert_eq!(
        steps(&sequence),
        [
            "(grasp brush)",
            "(collect brush breadcrumbs chopping_board)"
        ]
    );
    let [(part, reason)] = &sequence.left_out[..] else {
        panic!("{:?}", sequence.left_out);
    };
    assert_eq!(part, "(absorbed water table)");
    assert!(
        reason.contains("absorb needs (can-absorb ?t water table)"),
        "{reason}"
    );

    let (domain, goal) = (domain(), CompoundGoal::parse(goal).unwrap());
    let knowledge = knowledge(0);
    let mut situation = Situation::new(
        &domain,
        &knowledge,
        &goal,
        &media,
        None,
        &["sponge", "brush"],
    )
    .unwrap();
    let first = (situation.plan(&goal, StepPlace::Start, &Times::default())).unwrap();
    let wipings: Vec<Wiping> = first
        .steps
        .iter()
        .filter_map(|step| step.wiping.clone())
        .collect();
    assert_eq!(wipings.len(), 2);
    for wiping in situation.list_possible_wipings(&goal) {
        if wiping.tool == "sponge" && wiping.action == Action::Collect {
            situation.rule_out(&wiping);
        }
    }
    let next = (situation.plan(&goal, StepPlace::Start, &Times::default())).unwrap();
    let tools: Vec<&str> = (next.steps.iter())
        .filter_map(|step| Some(step.wiping.as_ref()?.tool.as_str()))
        .collect();
    assert!(
        tools.contains(&"brush") && tools.contains(&"sponge"),
        "{tools:?}"
    );
}

#[test]
fn what_was_collected_is_not_passed_over() {
    let (domain, knowledge) = (domain(), knowledge(0));
    let text = "(and (collected breadcrumbs table) (absorbed water table))";
    let goal = CompoundGoal::parse(text).unwrap();
    let media = [on("water", "table"), on("breadcrumbs", "table")];
    let mut situation =
        Situation::new(&domain, &knowledge, &goal, &media, Some("sponge"), &[]).unwrap();
    let planned = |situation: &Situation<'_>| {
        situation
            .plan(&goal, StepPlace::Start, &Times::default())
            .unwrap()
    };
    let apart = planned(&situation);
    assert_eq!(apart.left_out, []);
    let absorb = apart.steps[1].wiping.clone().unwrap();
    situation.note_sweep(&absorb, "breadcrumbs");
    let sequence = planned(&situation);
    assert_eq!(steps(&sequence), ["(collect sponge breadcrumbs table)"]);
    assert_eq!(sequence.left_out[0].0, "(absorbed water table)");
    let reason = &sequence.left_out[0].1;
    assert!(
        reason.contains("would pass over the heap of breadcrumbs"),
        "{reason}"
    );
    // If it happens all the same, the crumbs are not collected, and are not collected again.
    for step in &apart.steps {
        situation.apply(step);
    }
    assert!(!situation.holds(goal.parts().next().unwrap().1));
    assert!(planned(&situation).steps.is_empty());
}

#[test]
fn a_step_that_misses_its_goal_still_fills_the_tool() {
    let (domain, knowledge) = (domain(), knowledge(0));
    let goal = CompoundGoal::parse("(and (absorbed water table) (absorbed water floor))").unwrap();
    let media = [on("water", "table"), on("water", "floor")];
    let mut situation =
        Situation::new(&domain, &knowledge, &goal, &media, Some("sponge"), &[]).unwrap();
    let plan = situation.plan(&goal, StepPlace::Start, &Times::default());
    let first = plan.unwrap().steps[0].clone();
    situation.apply_missed(&first);
    let fact = goal.parts().map(|(_, fact)| situation.holds(fact));
    assert_eq!(fact.collect::<Vec<_>>(), [false, false]);
    let again = situation.plan(&goal, StepPlace::Start, &Times::default());
    assert_eq!(again.unwrap().steps[0].name(), "empty");
}

#[test]
fn nothing_lies_under_a_treatment_and_a_coat_goes_last() {
    let media = [on("breadcrumbs", "table"), on("polishing_paste", "table")];
    let goal = "(and (polished polishing_paste table) (not (wet table)))";
    let sequence = plan(goal, &media, &["sponge", "brush"]);
    let steps = steps(&sequence);
    assert!(
        steps.iter().any(|step| [
            "(absorb sponge breadcrumbs table)",
            "(skim sponge breadcrumbs table)"
        ]
        .contains(&step.as_str())),
        "{steps:?}"
    );
    assert!(
        !steps.iter().any(|step| step.starts_with("(collect")),
        "{steps:?}"
    );
    // The brush can only collect.
    let sequence = plan("(and (polished polishing_paste table))", &media, &["brush"]);
    assert_eq!(sequence.steps, []);
    let (domain, knowledge) = (domain(), knowledge(0));
    let goal = CompoundGoal::parse("(and (polished polishing_paste table))").unwrap();
    let mut situation =
        Situation::new(&domain, &knowledge, &goal, &media, None, &["sponge"]).unwrap();
    for wiping in situation.list_possible_wipings(&goal) {
        if wiping.medium == "breadcrumbs" {
            situation.rule_out(&wiping);
        }
    }
    let left_out = situation.plan(&goal, StepPlace::Start, &Times::default());
    let reason = &left_out.unwrap().left_out[0].1;
    assert_eq!(
        reason,
        "polish needs (not (under breadcrumbs polishing_paste table))"
    );

    let media = [on("paint", "table"), on("polishing_paste", "table")];
    let text = "(and (dispensed paint table) (polished polishing_paste table))";
    let goal = CompoundGoal::parse(text).unwrap();
    let tools = ["window_wiper", "sponge"];
    let situation = Situation::new(&domain, &knowledge, &goal, &media, None, &tools).unwrap();
    let holds = |fact: &str| situation.holds(&GoalLiteral::parse(fact).unwrap());
    assert!(holds("(in-way polishing_paste paint table)"));
    assert!(!holds("(in-way paint polishing_paste table)"));
}

#[test]
fn goals_that_are_no_conjunctions_of_facts_are_refused() {
    for (text, expected) in [
        ("(and)", "goal:1:1: expected a fact, found `(and ...)`"),
        (
            "(and (wet ?s))",
            "goal:1:6: expected names only, found `?s`",
        ),
        (
            "(forall (?s) (wet ?s))",
            "goal:1:1: `forall` in a goal is not supported; expected typed STRIPS with negation",
        ),
    ] {
        assert_eq!(CompoundGoal::parse(text).unwrap_err().to_string(), expected);
    }
    let goal = CompoundGoal::parse("(and (clean table) (wet table))").unwrap();
    let (domain, knowledge) = (domain(), knowledge(0));
    let situation = Situation::new(
        &domain,
        &knowledge,
        &goal,
        &[on("water", "table")],
        None,
        &["sponge"],
    );
    let error = situation
        .unwrap()
        .plan(&goal, StepPlace::Start, &Times::default())
        .unwrap_err();
    assert!(
        error.to_string().contains("unknown predicate \"clean\""),
        "{error}"
    );
}

/// An oracle that knows only what this test needs: tables with crumbs (even numbers) or water (odd numbers), each wiped
/// once, by any order and any tool, with Bellman's recursion over the sets of wiped tables.
fn least_time(count: usize, times: &Times) -> f64 {
    // Tool 0 is the empty hand; water loads the tool, which is tracked for the sponge alone, as nothing else absorbs.
    #[derive(Clone, Copy, PartialEq, PartialOrd)]
    struct Reached(f64);
    let place = |name: &str| times.at.get(name).copied().unwrap_or(0.0);
    let mut best: BTreeMap<(usize, usize, bool, i64), Reached> = BTreeMap::new();
    let key_of = |position: f64| (position * 1e6).round() as i64;
    best.insert((0, 0, false, 0), Reached(0.0));
    let mut least = f64::INFINITY;
    for _ in 0..3 * count + 4 {
        let mut next = best.clone();
        for (&(mask, tool, is_loaded, at), &Reached(time)) in &best {
            let at = at as f64 / 1e6;
            if mask + 1 == 1 << count {
                least = least.min(time);
            }
            let mut reach = |mask, tool, is_loaded, to: f64, cost: f64| {
                let cost = time + (at - to).abs() + cost;
                let entry = next
                    .entry((mask, tool, is_loaded, key_of(to)))
                    .or_insert(Reached(f64::INFINITY));
                if Reached(cost) < *entry {
                    *entry = Reached(cost);
                }
            };
            if tool == 0 {
                for (index, name) in TOOLS.iter().enumerate() {
                    reach(mask, index + 1, is_loaded, place(name), CHANGE);
                }
                continue;
            }
            let name = TOOLS[tool - 1];
            reach(mask, 0, is_loaded, place(name), CHANGE);
            let is_full = is_loaded && name == "sponge";
            if is_full {
                reach(mask, tool, false, place(name), EMPTY);
            }
            for table in (0..count).filter(|table| mask >> table & 1 == 0) {
                let surface = format!("table{table}");
                let is_water = table % 2 == 1;
                let can = !is_full && (name == "sponge" || (name == "brush" && !is_water));
                let Some(wiping) = times
                    .wiping
                    .get(&(name.to_owned(), surface.clone()))
                    .filter(|_| can)
                else {
                    continue;
                };
                let loads = is_water || is_loaded;
                reach(mask | 1 << table, tool, loads, place(&surface), *wiping);
            }
        }
        if next == best {
            break;
        }
        best = next;
    }
    least
}

fn sequence_of_tables(count: usize, times: &Times) -> Sequence {
    let medium = |table: usize| {
        if table % 2 == 1 {
            "water"
        } else {
            "breadcrumbs"
        }
    };
    let parts: Vec<String> = (0..count)
        .map(|table| {
            let predicate = if table % 2 == 1 {
                "absorbed"
            } else {
                "collected"
            };
            format!("({predicate} {} table{table})", medium(table))
        })
        .collect();
    let goal = CompoundGoal::parse(&format!("(and {})", parts.join(" "))).unwrap();
    let media: Vec<MediumOnSurface> = (0..count)
        .map(|table| on(medium(table), &format!("table{table}")))
        .collect();
    let (domain, knowledge) = (domain(), knowledge(count));
    let situation = Situation::new(&domain, &knowledge, &goal, &media, None, &TOOLS).unwrap();
    situation.plan(&goal, StepPlace::Start, times).unwrap()
}

fn times_of(count: usize, numbers: &[f64]) -> Times {
    let mut times = Times::default();
    let mut numbers = numbers.iter().cycle();
    let mut next = || *numbers.next().unwrap();
    for table in 0..count {
        let surface = format!("table{table}");
        times.at.insert(surface.clone(), (next() * 8.0).round());
        for tool in TOOLS {
            times
                .wiping
                .insert((tool.to_owned(), surface.clone()), 20.0 + 100.0 * next());
        }
    }
    for tool in TOOLS {
        times.at.insert(tool.to_owned(), (next() * 8.0).round());
    }
    times
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]
    #[test]
    fn no_order_and_no_choice_of_tools_takes_less_time(
        count in 2..=5_usize, numbers in prop::collection::vec(0.0..1.0_f64, 23)
    ) {
        let times = times_of(count, &numbers);
        let sequence = sequence_of_tables(count, &times);
        let least = least_time(count, &times);
        prop_assert!((sequence.time() - least).abs() < 1e-6, "{} but {least}: {:?}", sequence.time(), steps(&sequence));
    }
}

#[test]
fn goals_of_twelve_parts_are_planned_to_the_optimum() {
    let numbers: Vec<f64> = (0..60).map(|i| f64::from(i * 37 % 61) / 61.0).collect();
    let times = times_of(12, &numbers);
    let sequence = sequence_of_tables(12, &times);
    assert_eq!(
        sequence
            .steps
            .iter()
            .filter(|step| step.wiping.is_some())
            .count(),
        12
    );
    assert!((sequence.time() - least_time(12, &times)).abs() < 1e-6);
}
