//! Tests with domains and problems that a user might write.

use super::*;
use proptest::prelude::*;

const BLOCKS: &str = "(define (domain blocks)
  (:requirements :strips :typing)
  (:types block - object)
  (:constants spare - block)
  (:predicates (on ?x ?y - block) (free ?x - block) (on-table ?x - block))
  (:action stack
    :parameters (?x ?y - block)
    :precondition (and (free ?x) (free ?y) (on-table ?x))
    :effect (and (on ?x ?y) (not (free ?y)) (not (on-table ?x))))
  (:action unstack
    :parameters (?x ?y - block)
    :precondition (and (free ?x) (on ?x ?y))
    :effect (and (on-table ?x) (free ?y) (not (on ?x ?y)))))
";

const TOWER: &str = "(define (problem tower)
  (:domain blocks)
  (:objects a b c - block)
  (:init (on-table b) (on-table c) (on a b) (free a) (free c))
  (:goal (and (on b c) (on a b))))
";

/// Plans for a problem in PDDL; only tests write problems as text.
fn plan(domain: &str, problem: &str) -> Result<Option<Vec<String>>, GoalError> {
    let domain = Domain::parse("domain.pddl", domain)?;
    let source = Source {
        name: "problem.pddl",
        text: problem,
    };
    let form = form::read(source)?;
    let sections = form.list().unwrap_or_default();
    let section = |keyword| {
        let mut found = sections.iter().filter_map(form::Form::head);
        found
            .find(|(head, _)| *head == keyword)
            .map_or(&[][..], |(_, rest)| rest)
    };
    let objects = syntax::read_typed_list(source, section(":objects"), syntax::Listed::Names)?;
    let atoms = |keyword| -> Result<Vec<syntax::Atom>, GoalError> {
        let lists = section(keyword)
            .iter()
            .map(|form| syntax::read_literals(source, form));
        let literals = lists.collect::<Result<Vec<_>, _>>()?.concat().into_iter();
        Ok(literals.map(|literal| literal.atom).collect())
    };
    let (init, goal) = (atoms(":init")?, atoms(":goal")?);
    let problem = Problem {
        domain: &domain,
        objects: (domain.constants.iter().chain(&objects))
            .map(syntax::Typed::as_pair)
            .collect(),
        init: init.iter().map(syntax::Atom::fact).collect(),
        goal: goal.iter().map(|atom| (true, atom.fact())).collect(),
    };
    problem.check()?;
    let plan = problem.shortest_plan()?;
    Ok(plan.map(|plan| plan.iter().map(|step| search::format_fact(step)).collect()))
}

/// Returns the planning error after one piece of the domain is replaced.
fn domain_error(piece: &str, by: &str) -> String {
    assert_eq!(BLOCKS.matches(piece).count(), 1, "{piece} must occur once");
    plan(&BLOCKS.replace(piece, by), TOWER)
        .expect_err("the domain is broken")
        .to_string()
}

/// Returns the planning error after one piece of the problem is replaced.
fn problem_error(piece: &str, by: &str) -> String {
    assert_eq!(TOWER.matches(piece).count(), 1, "{piece} must occur once");
    plan(BLOCKS, &TOWER.replace(piece, by))
        .expect_err("the problem is broken")
        .to_string()
}

#[test]
fn a_tower_is_taken_apart_and_built() {
    let expected = ["(unstack a b)", "(stack b c)", "(stack a b)"].map(str::to_owned);
    assert_eq!(plan(BLOCKS, TOWER).unwrap(), Some(expected.to_vec()));
}

#[test]
fn a_goal_that_holds_takes_no_step_and_one_that_cannot_has_no_plan() {
    let held = TOWER.replace("(and (on b c) (on a b))", "(on a b)");
    assert_eq!(plan(BLOCKS, &held).unwrap(), Some(vec![]));
    // With delete relaxation, each half of this goal is reachable; together they are not.
    let circle = TOWER.replace("(and (on b c) (on a b))", "(and (on b c) (on c b))");
    assert_eq!(plan(BLOCKS, &circle).unwrap(), None);
    let out_of_reach = TOWER.replace("(and (on b c) (on a b))", "(on spare a)");
    assert_eq!(plan(BLOCKS, &out_of_reach).unwrap(), None);
}

#[test]
fn subtypes_and_constants_count_as_objects() {
    let domain = "(define (domain d) (:types rag sponge - tool tool) (:constants old - rag)
        (:predicates (wet ?t - tool) (done))
        (:action dip :parameters (?t - sponge) :effect (wet ?t))
        (:action soak :parameters () :effect (wet old))
        (:action finish :parameters (?t - tool) :precondition (wet ?t) :effect (done)))";
    let problem = "(define (problem p) (:domain d) (:objects new - rag) (:init) (:goal (done)))";
    let expected = ["(soak)", "(finish old)"].map(str::to_owned);
    assert_eq!(plan(domain, problem).unwrap(), Some(expected.to_vec()));
    // A rag that is new cannot get wet.
    let problem = problem.replace("(done)", "(wet new)");
    assert_eq!(plan(domain, &problem).unwrap(), None);
}

#[test]
fn added_facts_outlast_deleted_ones() {
    let domain = "(define (domain d) (:predicates (a) (b))
        (:action go :effect (and (a) (not (a)) (b))))";
    let problem = "(define (problem p) (:domain d) (:init) (:goal (and (a) (b))))";
    assert_eq!(
        plan(domain, problem).unwrap(),
        Some(vec!["(go)".to_owned()])
    );
}

#[test]
fn a_fault_of_a_domain_is_reported_with_its_place() {
    let cases = [
        (
            "(define",
            "(defin",
            "domain.pddl:1:1: expected `(define (domain name) ...)`, found `(defin ...)`",
        ),
        (
            "(domain blocks)",
            "(problem blocks)",
            "domain.pddl:1:9: expected `(domain name)`, found `(problem ...)`",
        ),
        (
            ":predicates",
            ":predicate",
            r#"domain.pddl:5:3: unknown section ":predicate"; nearest: :predicates"#,
        ),
        (
            "(free ?x - block)",
            "free",
            "domain.pddl:5:35: expected a predicate `(name ?parameter - type ...)`, found `free`",
        ),
        (
            "(free ?x - block)",
            "(free x - block)",
            "domain.pddl:5:41: expected a parameter `?name`, or `-` and a type, found `x`",
        ),
        (
            "(free ?x - block)",
            "(free ?x - blok)",
            r#"domain.pddl:5:46: unknown type "blok"; nearest: block"#,
        ),
        (
            "(free ?x - block)",
            "(free ?x -)",
            "domain.pddl:5:44: expected a name before and a type after every `-`, found a list without",
        ),
        (
            "(free ?x - block)",
            "(on ?x - block)",
            "domain.pddl:5:35: predicate on is already defined at domain.pddl:5:16",
        ),
        (
            "block - object",
            "block - stone",
            r#"domain.pddl:3:19: unknown type "stone"; known: "#,
        ),
        (
            "block - object",
            "block - stone stone - block",
            "domain.pddl:3:11: type block is its own ancestor",
        ),
        (
            "block - object",
            "block block",
            "domain.pddl:3:17: type block is already defined at domain.pddl:3:11",
        ),
        (
            "(:action unstack",
            "(:action stack",
            "domain.pddl:10:3: action stack is already defined at domain.pddl:6:3",
        ),
        (
            "(:action unstack",
            "(:action (unstack)",
            "domain.pddl:10:3: expected `(:action name ...)`, found `(:action ...)`",
        ),
        (
            "(free ?x) (on ?x ?y)",
            "(free ?z) (on ?x ?y)",
            r#"domain.pddl:12:24: unknown parameter "?z"; known: ?x"#,
        ),
        (
            "(free ?x) (on ?x ?y)",
            "(free sparse) (on ?x ?y)",
            r#"domain.pddl:12:24: unknown constant "sparse"; nearest: spare"#,
        ),
        (
            "(free ?x) (on ?x ?y)",
            "(free ?x) (an ?x ?y)",
            r#"domain.pddl:12:34: unknown predicate "an"; known: on"#,
        ),
        (
            "(free ?x) (on ?x ?y)",
            "(free ?x) (on ?x)",
            "domain.pddl:12:34: predicate on takes 2 arguments, found 1",
        ),
        (
            ":effect (and (on ?x ?y)",
            "(and (on ?x ?y)",
            "domain.pddl:9:5: expected `:parameters`, `:precondition` or `:effect`, found `(and ...)`",
        ),
        (
            "    :effect (and (on ?x ?y) (not (free ?y)) (not (on-table ?x))))",
            ")",
            "domain.pddl:6:3: expected `:effect` in the action, found none",
        ),
    ];
    for (piece, by, expected) in cases {
        let error = domain_error(piece, by);
        assert!(
            error.starts_with(expected),
            "{expected:?} does not begin {error:?}"
        );
    }
}

#[test]
fn constructs_beyond_typed_strips_are_named() {
    let cases = [
        (":strips", ":adl", "domain.pddl:2:18: `:adl`"),
        (
            "(:constants",
            "(:functions (cost)) (:constants",
            "domain.pddl:4:3: `:functions`",
        ),
        (
            "(:action unstack",
            "(:durative-action unstack",
            "domain.pddl:10:3: `:durative-action`",
        ),
        (
            "(free ?x) (on ?x ?y)",
            "(forall (?z) (forall (?v) (on ?v ?z)))",
            "domain.pddl:12:24: `forall` in `forall`",
        ),
        (
            "(free ?x) (on ?x ?y)",
            "(or (free ?x) (on ?x ?y))",
            "domain.pddl:12:24: `or`",
        ),
        (
            "(free ?x) (on ?x ?y)",
            "(= ?x ?y)",
            "domain.pddl:12:24: `=`",
        ),
        (
            "(free ?x) (on ?x ?y)",
            "(exists (?z) (on ?x ?z))",
            "domain.pddl:12:24: `exists`",
        ),
        (
            "(on-table ?x) (free ?y)",
            "(when (free ?x) (free ?y))",
            "domain.pddl:13:24: a condition of `when` that an action changes",
        ),
        (
            "(on-table ?x) (free ?y)",
            "(increase (cost) 1)",
            "domain.pddl:13:18: `increase`",
        ),
        (
            "(on-table ?x) (free ?y)",
            "(not (not (free ?y)))",
            "domain.pddl:13:23: `(not (not ...))`",
        ),
        (
            "spare - block",
            "spare - (either block object)",
            "domain.pddl:4:23: `either`",
        ),
    ];
    for (piece, by, construct) in cases {
        let expected = format!("{construct} is not supported; expected typed STRIPS with negation");
        assert_eq!(domain_error(piece, by), expected);
    }
}

#[test]
fn facts_that_do_not_fit_the_domain_are_reported() {
    let cases = [
        (
            "a b c - block",
            "a b c",
            "a is of type object, not of block",
        ),
        (
            "(free a)",
            "(free d)",
            r#"unknown object "d"; known: a, b, c, spare"#,
        ),
        (
            "(free a)",
            "(fre a)",
            r#"unknown predicate "fre"; nearest: free"#,
        ),
        (
            "(free a)",
            "(free a b)",
            "predicate free takes 1 arguments, found 2",
        ),
    ];
    for (piece, by, expected) in cases {
        let error = problem_error(piece, by);
        let expected = format!("problem derived from the goal:1:1: {expected}");
        assert!(
            error.starts_with(&expected),
            "{expected:?} does not begin {error:?}"
        );
    }
}

/// Returns a domain whose states are the numbers of `count` binary digits.
fn switches(count: usize, goal: &str) -> (String, String) {
    let domain = "(define (domain switches) (:predicates (lit ?s) (dark ?s) (never))
        (:action on :parameters (?s) :precondition (dark ?s) :effect (and (lit ?s) (not (dark ?s))))
        (:action off :parameters (?s) :precondition (lit ?s) :effect (and (dark ?s) (not (lit ?s))))
        (:action both :parameters (?s) :precondition (and (lit ?s) (dark ?s)) :effect (never)))";
    let names: Vec<String> = (0..count).map(|i| format!("s{i}")).collect();
    let dark: String = names.iter().map(|name| format!("(dark {name})")).collect();
    let problem = format!(
        "(define (problem p) (:domain switches) (:objects {}) (:init {dark}) (:goal {goal}))",
        names.join(" ")
    );
    (domain.to_owned(), problem)
}

#[test]
fn a_search_is_complete_and_ends_at_its_limit() {
    let (domain, problem) = switches(10, "(never)");
    assert_eq!(plan(&domain, &problem).unwrap(), None);
    let (domain, problem) = switches(17, "(never)");
    let error = plan(&domain, &problem).unwrap_err().to_string();
    assert!(error.starts_with(TOO_LONG), "{error}");
    assert!(error.ends_with(" exceeds the limit of 5000000"), "{error}");
}

/// Error of a search that has reached its limit.
const TOO_LONG: &str = "problem derived from the goal: steps of the search: 500";

#[test]
fn binding_parameters_ends_at_a_limit() {
    let problem = |count: usize| {
        let names: String = (0..count).map(|i| format!("o{i} ")).collect();
        format!("(define (problem p) (:domain d) (:objects {names}) (:init) (:goal (q)))")
    };
    let many = "(define (domain d) (:predicates (p ?a ?b ?c ?d) (q) (no ?d))
        (:action go :parameters (?a ?b ?c ?d) :precondition (no ?d) :effect (p ?a ?b ?c ?d)))";
    let error = plan(many, &problem(101)).unwrap_err().to_string();
    assert!(error.starts_with(TOO_LONG), "{error}");
    let pairs = "(define (domain d) (:predicates (p ?a ?b) (q))
        (:action go :parameters (?a ?b) :effect (p ?a ?b)))";
    assert_eq!(plan(pairs, &problem(101)).unwrap(), None);
    let parameters: String = (0..13).map(|i| format!("?p{i} ")).collect();
    let wide = pairs.replace("(?a ?b) :", &format!("(?a ?b {parameters}) :"));
    assert_eq!(
        Domain::parse("d", &wide).unwrap_err().to_string(),
        "d: parameters of an action: 15 exceeds the limit of 12"
    );
}

/// Checks a plan step by step, with sets of strings as states: an oracle that is independent of the search.
fn is_blocks_plan(init: &[&str], plan: &[String], goal: &[&str]) -> bool {
    let mut state: std::collections::BTreeSet<String> = init.iter().map(|&f| f.into()).collect();
    for step in plan {
        let words: Vec<&str> = step.trim_matches(['(', ')']).split(' ').collect();
        let [action, x, y] = words[..] else {
            return false;
        };
        let [free_x, free_y] = [x, y].map(|b| format!("free {b}"));
        let (on_table, on) = (format!("on-table {x}"), format!("on {x} {y}"));
        let (needed, lost, won) = match action {
            "stack" => (
                vec![&free_x, &free_y, &on_table],
                vec![&free_y, &on_table],
                vec![&on],
            ),
            _ => (vec![&free_x, &on], vec![&on], vec![&on_table, &free_y]),
        };
        if !needed.into_iter().all(|fact| state.contains(fact)) {
            return false;
        }
        for fact in lost {
            state.remove(fact);
        }
        state.extend(won.into_iter().cloned());
    }
    goal.iter().all(|&fact| state.contains(fact))
}

#[test]
fn the_oracle_refuses_a_plan_that_skips_a_step() {
    let init = ["on-table a", "on-table b", "free a", "free b"];
    assert!(is_blocks_plan(
        &init,
        &["(stack a b)".to_owned()],
        &["on a b"]
    ));
    assert!(!is_blocks_plan(
        &init,
        &["(unstack a b)".to_owned()],
        &["on-table a"]
    ));
    assert!(!is_blocks_plan(&init, &[], &["on a b"]));
}

proptest! {
    /// Blocks on the table can be stacked in any order, one step for each but the lowest.
    #[test]
    fn towers_of_any_order_are_built_in_the_fewest_steps(
        tower in Just(["a", "b", "c", "d", "e"].to_vec()).prop_shuffle(), height in 1..=5_usize
    ) {
        let init: Vec<String> = ["a", "b", "c", "d", "e"]
            .iter()
            .flat_map(|b| [format!("on-table {b}"), format!("free {b}")])
            .collect();
        let goal: Vec<String> =
            tower[..height].windows(2).map(|pair| format!("on {} {}", pair[1], pair[0])).collect();
        let list = |facts: &[String]| -> String { facts.iter().map(|f| format!("({f})")).collect() };
        let problem = format!(
            "(define (problem p) (:domain blocks) (:objects a b c d e - block) (:init {}) (:goal (and {})))",
            list(&init), list(&goal)
        );
        let plan = plan(BLOCKS, &problem).unwrap().expect("blocks on a table can be stacked");
        prop_assert_eq!(plan.len(), height - 1);
        let init: Vec<&str> = init.iter().map(String::as_str).collect();
        let goal: Vec<&str> = goal.iter().map(String::as_str).collect();
        prop_assert!(is_blocks_plan(&init, &plan, &goal));
    }

    #[test]
    fn no_change_to_a_problem_makes_planning_panic(
        cuts in prop::collection::vec((0.0..1.0_f64, 0..8_usize, "[()a-c?:\\PC -]{0,6}"), 1..4),
        in_domain: bool
    ) {
        let mut text = if in_domain { BLOCKS } else { TOWER }.to_owned();
        for (share, length, inserted) in cuts {
            let start = text.floor_char_boundary((share * text.len() as f64) as usize);
            let end = text.floor_char_boundary(start + length);
            text.replace_range(start..end, &inserted);
        }
        let result = if in_domain { plan(&text, TOWER) } else { plan(BLOCKS, &text) };
        if let Err(error) = result {
            prop_assert!(!error.to_string().is_empty());
        }
    }
}
