//! What a crate may depend on, read off its manifest.

use std::fs;
use std::path::{Path, PathBuf};

/// The crates in the order in which data walks through them; those of a row do not know each other.
const LAYERS: [&[&str]; 8] = [
    &["wisch-robot", "wisch-web"],
    &["wisch"],
    &["wisch-io"],
    &["wisch-sim", "wisch-telemetry", "wisch-memory"],
    &["wisch-report"],
    &["wisch-record"],
    &["wisch-eval"],
    &["wisch-cli"],
];

/// Crates beside the order, and what they may depend on of this workspace. Nothing depends on them.
const APART: [(&str, &[&str]); 5] = [
    ("wisch-fleet", &["wisch-memory"]),
    ("wisch-prolog", &[]),
    ("wisch-studio", &["wisch-memory", "wisch-web"]),
    (
        "wisch-py",
        &[
            "wisch",
            "wisch-io",
            "wisch-telemetry",
            "wisch-memory",
            "wisch-report",
            "wisch-record",
            "wisch-cli",
        ],
    ),
    ("wisch-testkit", &["wisch", "wisch-io"]),
];

/// Crates that only some of ours may depend on, by the beginning of their names.
/// The simulated world is opened by the program and by evaluations alone: what plans, interprets, reads files or draws
/// cannot name it.
const KEPT_APART: [(&str, &[&str]); 8] = [
    ("wisch-sim", &["wisch-eval", "wisch-cli"]),
    ("rapier", &["wisch-sim"]),
    ("clap", &["wisch-cli", "wisch-fleet"]),
    ("scryer", &["wisch-prolog"]),
    ("axum", &["wisch-studio"]),
    ("tokio", &["wisch-fleet", "wisch-studio"]),
    ("datafusion", &["wisch-fleet"]),
    ("object_store", &["wisch-fleet"]),
];

fn crates() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// What a manifest depends on in what is shipped: names of packages, without those for tests.
fn dependencies(manifest: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut is_listing = false;
    for line in manifest.lines() {
        let line = line.trim();
        if let Some(section) = line.strip_prefix('[') {
            let section = section.trim_end_matches(']');
            let (_, last) = section.rsplit_once("dependencies").unwrap_or_default();
            let is_for_tests = section.contains("dev-dependencies");
            is_listing = section.ends_with("dependencies") && !is_for_tests;
            let alone = last.strip_prefix('.').filter(|_| !is_for_tests);
            found.extend(alone.map(str::to_owned));
        } else if let Some((name, value)) = line.split_once('=')
            && !name.starts_with('#')
        {
            let renamed = value.split_once("package = \"").map(|(_, name)| name);
            let renamed = renamed.and_then(|name| name.split('"').next());
            let name = name.trim().split('.').next().unwrap_or_default();
            if is_listing {
                found.push(renamed.unwrap_or(name).to_owned());
            }
        }
    }
    found
}

/// What a crate depends on and may not.
fn forbidden(name: &str, manifest: &str) -> Vec<String> {
    let layer = LAYERS.iter().position(|layer| layer.contains(&name));
    let apart = APART.iter().find(|(apart, _)| *apart == name);
    let may_use = |other: &str| match (layer, apart) {
        (Some(layer), _) => LAYERS[..layer].iter().any(|below| below.contains(&other)),
        (None, Some((_, allowed))) => allowed.contains(&other),
        (None, None) => false,
    };
    let is_ours = |other: &str| other == "wisch" || other.starts_with("wisch-");
    let is_kept_apart = |other: &str| {
        (KEPT_APART.iter())
            .any(|(begin, allowed)| other.starts_with(begin) && !allowed.contains(&name))
    };
    (dependencies(manifest).into_iter())
        .filter(|other| is_kept_apart(other) || (is_ours(other) && !may_use(other)))
        .collect()
}

#[test]
fn crates_depend_only_on_earlier_ones() {
    let mut seen = Vec::new();
    for entry in fs::read_dir(crates()).unwrap() {
        let entry = entry.unwrap();
        let name = entry.file_name().into_string().unwrap();
        let Ok(manifest) = fs::read_to_string(entry.path().join("Cargo.toml")) else {
            continue;
        };
        assert_eq!(forbidden(&name, &manifest), [""; 0], "{name}");
        seen.push(name);
    }
    let mut told: Vec<&str> = LAYERS.iter().copied().flatten().copied().collect();
    told.extend(APART.map(|(name, _)| name));
    told.sort_unstable();
    seen.sort();
    assert_eq!(seen, told, "every crate has its place in the order");
}

#[test]
fn a_dependency_the_wrong_way_is_noticed() {
    let on = |name: &str, line: &str| {
        forbidden(
            name,
            &format!("[package]\nname = \"x\"\n[dependencies]\n{line}\n"),
        )
    };
    assert_eq!(on("wisch-io", "clap = \"4\""), ["clap"]);
    assert_eq!(on("wisch", "rapier3d-f64 = \"=0.36.1\""), ["rapier3d-f64"]);
    assert_eq!(
        on("wisch", "wisch-io = { path = \"../wisch-io\" }"),
        ["wisch-io"]
    );
    assert_eq!(
        on("wisch-memory", "wisch-sim = { path = \"../wisch-sim\" }"),
        ["wisch-sim"]
    );
    assert_eq!(
        on("wisch-report", "wisch-sim = { path = \"../wisch-sim\" }"),
        ["wisch-sim"]
    );
    assert_eq!(
        on(
            "wisch-cli",
            "prolog = { package = \"scryer-prolog\", version = \"0.10\" }"
        ),
        ["scryer-prolog"]
    );
    assert_eq!(
        on("wisch-cli", "wisch-testkit.path = \"x\""),
        ["wisch-testkit"]
    );
    assert_eq!(
        on("wisch-new", "wisch = { path = \"../wisch\" }"),
        ["wisch"]
    );
    let alone = "[dependencies.wisch-report]\npath = \"../wisch-report\"\n";
    assert_eq!(forbidden("wisch-sim", alone), ["wisch-report"]);
    let elsewhere = "[target.'cfg(unix)'.dependencies]\nwisch-cli = { path = \"../wisch-cli\" }\n";
    assert_eq!(forbidden("wisch-sim", elsewhere), ["wisch-cli"]);
    let for_tests = "[dev-dependencies]\nwisch-testkit = { path = \"../wisch-testkit\" }\n";
    assert_eq!(forbidden("wisch", for_tests), [""; 0]);
}
