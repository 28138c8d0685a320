//! The rules of the house, read off the source: what a stage may import, and what it may not do.

use std::fs;
use std::path::{Path, PathBuf};

/// The stages in the order in which data walks through them.
const STAGES: [&str; 8] = [
    "geometry",
    "represent",
    "plan",
    "robot",
    "follow",
    "execute",
    "interpret",
    "recover",
];

fn source() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
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
    for file in rust_files(&source()) {
        let path = file.to_string_lossy();
        if path.ends_with("tests.rs") || path.contains("/tests/") {
            continue;
        }
        let text = code(&fs::read_to_string(&file).unwrap());
        let text = text.split("#[cfg(test)]").next().unwrap_or_default();
        for word in forbidden {
            assert!(!text.contains(word), "{} uses {word}", file.display());
        }
    }
}

/// Items named in a text as `stage::…::Name`.
fn items(text: &str) -> Vec<&str> {
    text.split('`')
        .skip(1)
        .step_by(2)
        .filter(|word| {
            STAGES
                .iter()
                .any(|stage| word.starts_with(&format!("{stage}::")))
        })
        .collect()
}

fn exists(item: &str) -> bool {
    let mut parts = item.split("::");
    let stage = parts.next().unwrap_or_default();
    let names: Vec<&str> = parts.collect();
    let text: String = rust_files(&source().join(stage))
        .iter()
        .map(|file| code(&fs::read_to_string(file).unwrap()))
        .collect();
    !names.is_empty()
        && names.iter().all(|name| {
            let declared = |keyword: &str| {
                text.match_indices(&format!("{keyword} {name}"))
                    .any(|(at, found)| {
                        !text[at + found.len()..]
                            .starts_with(|c: char| c.is_alphanumeric() || c == '_')
                    })
            };
            ["fn", "struct", "enum", "const", "type", "trait"]
                .into_iter()
                .any(declared)
                || text.contains(&format!("    {name},"))
                || text.contains(&format!("    {name} {{"))
        })
}

#[test]
fn what_paper_md_names_exists() {
    let paper = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../PAPER.md");
    let text = fs::read_to_string(paper).unwrap();
    let items = items(&text);
    assert!(
        items.len() > 20,
        "PAPER.md names only {} items",
        items.len()
    );
    let missing: Vec<&str> = items.into_iter().filter(|item| !exists(item)).collect();
    assert!(
        missing.is_empty(),
        "PAPER.md names what is not there: {missing:?}"
    );
}

#[test]
fn an_item_that_is_not_there_is_noticed() {
    assert!(exists("represent::EffectModel::apply"));
    assert!(!exists("represent::EffectModel::undo_everything"));
    assert_eq!(items("see `plan::grid` and `cargo doc`"), ["plan::grid"]);
}

/// What only the simulated world knows: its names must not stand in stages that do without.
const TRUTH: [&str; 4] = ["GroundTruth", "Dirt", "Reality", ".truth"];

fn opens_truth(text: &str) -> Option<&'static str> {
    let code: Vec<&str> = (text.lines())
        .filter(|line| !line.trim_start().starts_with("//"))
        .collect();
    TRUTH
        .into_iter()
        .find(|name| code.iter().any(|line| line.contains(name)))
}

#[test]
fn no_plan_and_no_interpretation_opens_the_truth() {
    for stage in [
        "geometry",
        "plan",
        "robot",
        "follow",
        "interpret",
        "recover",
    ] {
        for file in rust_files(&source().join(stage)) {
            let text = fs::read_to_string(&file).unwrap();
            assert_eq!(opens_truth(&text), None, "{}", file.display());
        }
    }
    assert_eq!(
        opens_truth("let lies = executed.truth.dirt;"),
        Some(".truth")
    );
    assert_eq!(opens_truth("/// GroundTruth is not for us"), None);
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
    for file in rust_files(&source()) {
        let text = code(&fs::read_to_string(&file).unwrap());
        let is_effect_model = file.ends_with("represent/effect.rs");
        let expected: &[&str] = if is_effect_model {
            &["lift_off", "apply", "apply_where"]
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
