//! The rules of the house, read off the source: what a stage may import, and what it may not do.

mod circles;
mod documents;
mod names;
mod words;

use std::fs;
use std::path::{Path, PathBuf};

/// The stages in the order in which data walks through them.
const STAGES: [&str; 9] = [
    "represent",
    "goal",
    "plan",
    "follow",
    "control",
    "interpret",
    "learn",
    "recover",
    "run",
];

fn source() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
}

/// The sources of the libraries that read no clock, file or network.
fn libraries() -> [PathBuf; 2] {
    [source(), source().join("../../wisch-robot/src")]
}

fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files.extend(rust_files(&path));
        } else if path.extension().is_some_and(|e| e == "rs") {
            files.push(path);
        }
    }
    files
}

/// Code without comments.
fn code(text: &str) -> String {
    text.lines()
        .map(|line| line.split("//").next().unwrap_or(line))
        .collect::<Vec<_>>()
        .join("\n")
}

/// Code without comments, and without what is compiled for tests only.
fn production(text: &str) -> String {
    let text = code(text);
    let mut parts = text.split("#[cfg(test)]");
    let mut production = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        // One item: it ends with a semicolon, or with the brace that closes it.
        let mut depth = 0;
        let end = part.char_indices().find(|&(_, c)| {
            depth += i32::from(c == '{') - i32::from(c == '}');
            depth == 0 && (c == ';' || c == '}')
        });
        production += end.map_or("", |(at, _)| &part[at + 1..]);
    }
    production
}

/// Later stages that a file of `stage` imports.
fn forward_imports<'a>(stage: &str, text: &'a str) -> Vec<&'a str> {
    let position = |name: &str| STAGES.iter().position(|s| *s == name);
    text.match_indices("crate::")
        .filter_map(|(at, _)| {
            let rest = &text[at + "crate::".len()..];
            let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_')?;
            Some(&rest[..end])
        })
        .filter(|name| position(name) > position(stage))
        .collect()
}

#[test]
fn every_folder_is_a_stage_and_imports_only_earlier_ones() {
    for entry in fs::read_dir(source()).unwrap() {
        let path = entry.unwrap().path();
        if !path.is_dir() {
            continue;
        }
        let stage = path.file_name().unwrap().to_str().unwrap();
        assert!(
            STAGES.contains(&stage),
            "{stage} is not in the order of stages"
        );
        for file in rust_files(&path) {
            let text = code(&fs::read_to_string(&file).unwrap());
            let forward = forward_imports(stage, &text);
            assert!(forward.is_empty(), "{} imports {forward:?}", file.display());
        }
    }
}

#[test]
fn a_forward_import_is_noticed() {
    assert_eq!(
        forward_imports("represent", "use crate::plan::Plan;"),
        ["plan"]
    );
    assert!(forward_imports("plan", "use crate::geometry::Point2;").is_empty());
}

#[test]
fn the_library_reads_no_clock_file_or_network_and_serializes_no_domain_type() {
    let forbidden = [
        "std::fs",
        "std::net",
        "std::time",
        "Instant::now",
        "SystemTime",
        "thread_rng",
        "rand::rng()",
        "Serialize",
        "todo!",
        "unimplemented!",
    ];
    for file in libraries().iter().flat_map(|folder| rust_files(folder)) {
        let path = file.to_string_lossy();
        if path.ends_with("tests.rs") || path.contains("/tests/") {
            continue;
        }
        let text = production(&fs::read_to_string(&file).unwrap());
        for word in forbidden {
            assert!(!text.contains(word), "{} uses {word}", file.display());
        }
    }
}

/// The files that tell the strategies apart, by the one that nothing takes by default: each would have to learn of a
/// new one. As this is `plan/coverage/mod.rs` alone, adding a strategy touches two files: that one (its name, and the
/// call) and its own beside it. The program's option, task files and records take the names from there.
#[test]
fn only_the_folder_of_coverage_strategies_distinguishes_them() {
    let crates = source().join("../..");
    let told = |text: &str| text.contains("CoverageStrategy::Rrt") || text.contains("Self::Rrt");
    let mut named = Vec::new();
    for entry in fs::read_dir(crates).unwrap() {
        let folder = entry.unwrap().path().join("src");
        let files = if folder.is_dir() {
            rust_files(&folder)
        } else {
            Vec::new()
        };
        for file in files {
            if told(&production(&fs::read_to_string(&file).unwrap())) {
                let file = file.canonicalize().unwrap();
                let is_test = file.ends_with("tests.rs");
                named.extend((!is_test).then(|| file.display().to_string()));
            }
        }
    }
    assert_eq!(named.len(), 1, "{named:?}");
    assert!(
        named[0].ends_with("wisch/src/plan/coverage/mod.rs"),
        "{named:?}"
    );
}

/// Functions of a file that other stages may call and that change a particle field, by name.
fn field_mutators(text: &str) -> Vec<&str> {
    let text = text.split("#[cfg(test)]").next().unwrap_or_default();
    let mut owner = "";
    let mut found = Vec::new();
    for item in text.lines().map(str::trim_start) {
        if let Some(header) = item.strip_prefix("impl") {
            owner = header;
        }
        let is_open = item.starts_with("pub") && !item.starts_with("pub(super)");
        let (true, Some((_, rest))) = (is_open, item.split_once("fn ")) else {
            continue;
        };
        let at = item.as_ptr() as usize - text.as_ptr() as usize;
        let signature = text[at..].split(['{', ';']).next().unwrap_or_default();
        let is_method_of_field = owner.contains("ParticleField") && signature.contains("&mut self");
        if is_method_of_field || signature.contains("&mut ParticleField") {
            found.push(rest.split(['(', '<']).next().unwrap_or(rest));
        }
    }
    found
}

#[test]
fn only_the_effect_model_moves_particles() {
    for file in libraries().iter().flat_map(|folder| rust_files(folder)) {
        let text = code(&fs::read_to_string(&file).unwrap());
        let is_effect_model = file.ends_with("represent/effect.rs");
        let expected: &[&str] = if is_effect_model {
            &["lift_off", "wait", "apply", "apply_where"]
        } else {
            &[]
        };
        assert_eq!(field_mutators(&text), expected, "{}", file.display());
    }
}

#[test]
fn a_second_way_to_move_particles_is_noticed() {
    let shove = "impl ParticleField {\n    pub(crate) fn shove(\n        &mut self,\n        by: Vector2,\n    ) {}\n}";
    assert_eq!(field_mutators(shove), ["shove"]);
    let sweep = "pub fn sweep<T>(field: &mut ParticleField, by: T) {\n}";
    assert_eq!(field_mutators(sweep), ["sweep"]);
    let inside = "impl ParticleField {\n    pub(super) fn remove(&mut self) {}\n    pub fn len(&self) -> usize {}\n}";
    assert_eq!(field_mutators(inside), [""; 0]);
}

/// Every path that `use` statements name, groups taken apart.
fn used_paths(text: &str) -> Vec<String> {
    fn expand(prefix: &str, tree: &str, paths: &mut Vec<String>) {
        let (mut depth, mut begin) = (0, 0);
        let ends = tree.char_indices().filter(|&(_, c)| {
            depth += i32::from(c == '{') - i32::from(c == '}');
            c == ',' && depth == 0
        });
        let ends: Vec<usize> = ends.map(|(at, _)| at).chain([tree.len()]).collect();
        for end in ends {
            let part = tree[begin..end].trim();
            begin = (end + 1).min(tree.len());
            match part.split_once('{') {
                Some((head, inner)) => {
                    let inner = inner.trim_end().trim_end_matches('}');
                    expand(&format!("{prefix}{}", head.trim()), inner, paths);
                }
                None if !part.is_empty() => paths.push(format!("{prefix}{part}")),
                None => {}
            }
        }
    }
    let mut paths = Vec::new();
    let statements = code(text);
    for statement in statements.split(';') {
        let statement = statement.trim_start();
        if let Some((_, tree)) = statement.split_once("use ")
            && statement.len() - tree.len() <= "pub(in crate::follow) use ".len()
        {
            expand("", tree, &mut paths);
        }
    }
    paths
}

/// What the audit of a motion may know: data, and what describes the robot, its cell and the task.
const AUDITED: [&str; 28] = [
    "crate::digits::format_beside_limit",
    "crate::follow::AllowedContact",
    "crate::follow::FollowConfig",
    "crate::follow::FollowError",
    "crate::follow::Followed",
    "crate::follow::GRIP_TOLERANCE",
    "crate::follow::GripDeviation",
    "crate::follow::JointLimit",
    "crate::follow::JointLimits",
    "crate::follow::JointPath",
    "crate::follow::LEAN_TOLERANCE",
    "crate::follow::LineDeviation",
    "crate::follow::Motion",
    "crate::follow::Phase",
    "crate::follow::ToolPose",
    "crate::follow::Trajectory",
    "crate::follow::TrajectorySample",
    "crate::follow::Workcell",
    "crate::represent::Cone",
    "crate::represent::Surface",
    "crate::represent::SurfaceShape",
    "crate::represent::Task",
    "crate::robot::Joint",
    "crate::robot::JointKind",
    "crate::robot::LimitFault",
    "crate::robot::LinkId",
    "crate::robot::RobotError",
    "crate::robot::RobotModel",
];

/// Functions by which motions are found and accepted, some of them methods of what the audit may know.
const ACCEPTING: [&str; 11] = [
    "forward_kinematics",
    "limit_faults",
    "world_from_tool(task",
    "Workcell::world_from_tool",
    "line_deviation",
    "worst_grip",
    "is_held",
    ".deviation(",
    ".interpolate(",
    ".samples(",
    "time_path",
];

/// What a file of the audit takes from what it audits.
fn taken_from_what_is_audited(text: &str) -> Vec<String> {
    let text = &production(text);
    let own = [
        "super::dynamics::",
        "super::given_mesh::",
        "super::kinematics::",
        "super::line::",
        "super::surface::",
        "super::trajectory::",
    ];
    let is_audited = |path: &String| match path.split("::").next() {
        Some("crate") => {
            !AUDITED.contains(&path.as_str()) && !path.starts_with("crate::geometry::")
        }
        Some("super") => !own.iter().any(|file| path.starts_with(file)),
        _ => false,
    };
    let mut taken: Vec<String> = used_paths(text).into_iter().filter(is_audited).collect();
    // Paths may stand outside of `use` too.
    let paths = text.split(|c: char| !(c.is_alphanumeric() || c == '_' || c == ':'));
    let inner = [
        "schedule",
        "path",
        "timing",
        "placement",
        "workcell",
        "follower",
    ];
    taken.extend(
        paths
            .filter(|path| {
                inner
                    .iter()
                    .any(|part| path.contains(&format!("follow::{part}")))
            })
            .map(str::to_owned),
    );
    taken.extend(
        (ACCEPTING.iter())
            .filter(|name| text.contains(**name))
            .map(|name| (*name).to_owned()),
    );
    taken
}

#[test]
fn the_audit_of_motions_and_what_accepts_them_share_no_code() {
    let folder = source().join("follow");
    let audit = folder.join("audit");
    assert!(rust_files(&audit).len() > 1);
    let check = source().join("../../wisch-robot/src/timing/check.rs");
    let uses = used_paths(&production(&fs::read_to_string(&check).unwrap()));
    let data = [
        "super::JointLimits",
        "super::JointPath",
        "super::TrajectorySample",
        "thiserror::Error",
    ];
    assert_eq!(
        uses, data,
        "what checks a timing knows nothing of how it is made"
    );
    for file in rust_files(&folder) {
        let text = fs::read_to_string(&file).unwrap();
        if file.starts_with(&audit) {
            let taken = taken_from_what_is_audited(&text);
            assert!(taken.is_empty(), "{} takes {taken:?}", file.display());
        } else if file != folder.join("mod.rs") {
            let text = code(&text);
            for name in ["audit", "Audit", "trajectory_faults", "MotionFault"] {
                assert!(!text.contains(name), "{} uses {name}", file.display());
            }
        }
    }
}

#[test]
fn code_that_an_audit_shares_is_noticed() {
    assert_eq!(
        used_paths("use a::{b, c::{d, e}};\nfn f() {}\npub use g::h;"),
        ["a::b", "a::c::d", "a::c::e", "g::h"]
    );
    for shared in [
        "use crate::follow::{Motion, schedule::timed};",
        "use crate::follow::workcell::second_arm::off_grip;",
        "use super::super::path::arm::Arm;",
        "use super::schedule;",
        "fn f() { crate::follow::schedule::timed() }",
        "fn f() { cell.robot().forward_kinematics(q) }",
        "fn f() { motion.trajectory.samples(0.01) }",
    ] {
        assert_ne!(
            taken_from_what_is_audited(shared),
            [] as [String; 0],
            "{shared}"
        );
    }
    let own =
        "use super::line::Line;\nuse crate::follow::{Motion, Phase};\nuse crate::geometry::Pose;";
    assert_eq!(taken_from_what_is_audited(own), [] as [String; 0]);
}
