//! The tutorial: its programs run, print the documented output, are short, and are equal to those
//! in `docs/tutorial.md`.

use std::cell::RefCell;
use std::fs;
use std::path::{Path, PathBuf};

thread_local! {
    /// The output of the program that runs in this thread.
    static PRINTED: RefCell<String> = const { RefCell::new(String::new()) };
}

/// Replaces the macro of the standard library in the programs below.
macro_rules! println {
    ($($argument:tt)*) => {
        super::PRINTED.with_borrow_mut(|text| {
            text.push_str(&format!($($argument)*));
            text.push('\n');
        })
    };
}

#[path = "../examples/06_ask.rs"]
mod ask;
#[path = "../examples/04_execute.rs"]
mod execute;
#[path = "../examples/03_follow.rs"]
mod follow;
#[path = "../examples/05_interpret.rs"]
mod interpret;
#[path = "../examples/01_load.rs"]
mod load;
#[path = "../examples/02_plan.rs"]
mod plan;

type Outcome = Result<(), Box<dyn std::error::Error>>;

/// The programs, in their order.
const PROGRAMS: [&str; 6] = [
    "01_load",
    "02_plan",
    "03_follow",
    "04_execute",
    "05_interpret",
    "06_ask",
];
/// Largest number of lines of code of a program, without imports and paths of files.
const MOST_LINES: usize = 25;

/// Returns the output of a program.
fn printed(program: fn() -> Outcome) -> String {
    program().unwrap_or_else(|error| panic!("{error}"));
    PRINTED.take()
}

fn assert_says(program: fn() -> Outcome, telling: &[&str]) {
    let text = printed(program);
    for words in telling {
        assert!(text.contains(words), "{words:?} is missing in\n{text}");
    }
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn source(program: &str) -> String {
    fs::read_to_string(root().join(format!("crates/wisch/examples/{program}.rs"))).expect(program)
}

/// Lines of code, without blank lines, comments, imports and constants.
fn code_lines(text: &str) -> usize {
    let mut count = 0;
    let mut is_inside = false;
    for line in text.lines() {
        is_inside |= line.starts_with("use ") || line.starts_with("const ");
        let is_code = !line.trim().is_empty() && !line.trim_start().starts_with("//");
        count += usize::from(is_code && !is_inside);
        is_inside &= !line.ends_with(';');
    }
    count
}

#[test]
fn the_first_loads_a_task() {
    assert_says(
        load::main,
        &[
            "arm-board: collect breadcrumbs on chopping_board with a sponge",
            "60 particles are on it",
        ],
    );
}

#[test]
fn the_second_plans_and_predicts() {
    assert_says(
        plan::main,
        &["kde places 8 strokes", "% are predicted to be collected"],
    );
}

#[test]
fn the_third_follows_with_a_urdf() {
    assert_says(
        follow::main,
        &["0 nodes abandoned", "the check finds 0 faults"],
    );
}

#[test]
fn the_fourth_wipes_with_an_executor_of_its_own() {
    assert_says(execute::main, &["round 1: ", "% by touch, "]);
}

#[test]
fn the_fifth_plans_from_a_bag() {
    assert_says(
        interpret::main,
        &["% are at the goal", "the next round wipes 0."],
    );
}

/// Without an engine, the program prints how to install one. CI has one where it builds the whole
/// workspace.
#[test]
fn the_sixth_asks_the_memory() {
    let is_ci = std::env::var("CI").is_ok_and(|ci| ci == "true");
    if is_ci || wisch_memory::ask::EngineCommand::find().is_some() {
        return assert_says(ask::main, &["of round"]);
    }
    let error = ask::main().expect_err("there is no engine").to_string();
    assert!(error.contains("cargo build -p wisch-prolog"), "{error}");
    eprintln!("there is no Prolog engine: the last program of the tutorial was not asked anything");
}

#[test]
fn each_is_short() {
    for program in PROGRAMS {
        let lines = code_lines(&source(program));
        assert!(lines <= MOST_LINES, "{program}: {lines} lines");
    }
    let counted = "//! doc\nuse a::{\n    b,\n};\n\nconst C: &str =\n    \"c\";\nfn f() {\n    // why\n    g();\n}\n";
    assert_eq!(code_lines(counted), 3);
}

#[test]
fn the_documentation_shows_them_as_they_are() {
    let page = fs::read_to_string(root().join("docs/tutorial.md")).expect("docs/tutorial.md");
    let mut shown = page.split("```rust\n").skip(1);
    for program in PROGRAMS {
        let text = source(program);
        let (doc, code) = text.split_once("\n\n").expect("a comment, then code");
        assert!(doc.starts_with("//! "), "{program}");
        let block = shown.next().and_then(|rest| rest.split_once("```"));
        let (block, _) = block.unwrap_or_else(|| panic!("docs/tutorial.md lacks {program}"));
        assert_eq!(block, code, "{program} differs in docs/tutorial.md");
        assert!(page.contains(&format!("--example {program}")), "{program}");
    }
    assert_eq!(shown.next(), None);
}
