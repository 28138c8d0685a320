//! No circle of imports between the files of a crate, read off the source.

use super::{production, rust_files, used_paths};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// A file as the path of its module.
type Module = Vec<String>;

fn module(root: &Path, file: &Path) -> Module {
    let path = file.strip_prefix(root).unwrap().with_extension("");
    let mut module: Module = (path.iter())
        .map(|part| part.to_str().unwrap().to_owned())
        .collect();
    if module
        .last()
        .is_some_and(|last| ["mod", "lib", "main"].contains(&last.as_str()))
    {
        module.pop();
    }
    module
}

/// The file of `files` in which a path that stands in `from` ends; nothing if it leads out of the crate.
fn target(from: &Module, path: &str, files: &BTreeSet<Module>) -> Option<Module> {
    let mut parts = path.split("::").peekable();
    let mut at: Module = match parts.peek().copied()? {
        "crate" => {
            parts.next();
            Vec::new()
        }
        "self" => {
            parts.next();
            from.clone()
        }
        _ => from.clone(),
    };
    while parts.next_if_eq(&"super").is_some() {
        at.pop();
    }
    let is_relative = at == *from;
    let mut found = files.contains(&at).then(|| at.clone());
    for (index, part) in parts.enumerate() {
        at.push(part.to_owned());
        if files.contains(&at) {
            found = Some(at.clone());
        } else if index == 0 && is_relative {
            // A crate of others, or an item of the file itself.
            return None;
        }
    }
    found
}

/// Paths of a text that stand outside of `use` statements.
fn paths_in_code(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| !(c.is_alphanumeric() || c == '_' || c == ':'))
        .filter(|path| path.starts_with("crate::") || path.starts_with("super::"))
}

/// Groups of files that import from each other, around however many corners. What a file and the folder that holds
/// it have of each other does not count: a parent gathers its children.
fn circles(texts: &BTreeMap<Module, String>) -> Vec<Vec<String>> {
    let files: BTreeSet<Module> = texts.keys().cloned().collect();
    let mut imports: BTreeMap<&Module, BTreeSet<Module>> = BTreeMap::new();
    for (from, text) in texts {
        let text = production(text);
        let used = used_paths(&text);
        let all = (used.iter().map(String::as_str)).chain(paths_in_code(&text));
        let others = all
            .filter_map(|path| target(from, path.split(" as ").next()?, &files))
            .filter(|to| !to.starts_with(from) && !from.starts_with(to));
        imports.insert(from, others.collect());
    }
    let reached: BTreeMap<&Module, BTreeSet<&Module>> = (imports.keys())
        .map(|from| {
            let mut reached = BTreeSet::new();
            let mut open: Vec<&Module> = imports[from].iter().collect();
            while let Some(file) = open.pop() {
                if reached.insert(file) {
                    open.extend(&imports[file]);
                }
            }
            (*from, reached)
        })
        .collect();
    let mut circles: Vec<Vec<String>> = (reached.iter())
        .filter(|(file, reached)| reached.contains(*file))
        .map(|(file, others)| {
            let back = others
                .iter()
                .filter(|other| reached[**other].contains(file));
            back.map(|module| module.join("/")).collect()
        })
        .collect();
    circles.sort();
    circles.dedup();
    circles
}

#[test]
fn no_files_import_from_each_other() {
    let mut found = Vec::new();
    for entry in fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("..")).unwrap() {
        let folder = entry.unwrap().path();
        let root = folder.join("src");
        if !root.is_dir() {
            continue;
        }
        let texts: BTreeMap<Module, String> = (rust_files(&root).iter())
            .map(|file| (module(&root, file), fs::read_to_string(file).unwrap()))
            .collect();
        let name = folder.file_name().unwrap().to_str().unwrap().to_owned();
        found.extend((circles(&texts).into_iter()).map(|circle| (name.clone(), circle.join(" "))));
    }
    found.sort();
    assert_eq!(found, [] as [(String, String); 0]);
}

#[test]
fn a_circle_is_noticed() {
    let of = |files: &[(&str, &str)]| {
        let texts = files.iter().map(|&(path, text)| {
            let parts = path.split('/').filter(|part| !part.is_empty());
            (parts.map(str::to_owned).collect(), text.to_owned())
        });
        circles(&texts.collect())
    };
    let two = [
        ("", "mod a;\nmod b;\npub use a::A;"),
        ("a", "use crate::b::{self, B};"),
        ("b", "use std::fmt;\nfn f() -> super::a::A { g() }"),
    ];
    assert_eq!(of(&two), [["a", "b"]]);
    let three = [
        ("x/a", "use super::b::B as C;"),
        ("x/b", "use {crate::y, std::fmt};"),
        ("y", "pub(crate) use crate::x::a::A;"),
    ];
    assert_eq!(of(&three), [["x/a", "x/b", "y"]]);
    // A parent and its children, a name that a parent hands on, and what only tests use.
    let none = [
        ("x", "mod a;\nmod b;\npub use a::A;\npub use b::B;"),
        (
            "x/a",
            "use super::B;\n#[cfg(test)]\nuse super::b::C;\nfn f() {}",
        ),
        (
            "x/b",
            "use super::a::A;\n#[cfg(test)]\nmod tests {\n    use crate::x::a;\n}",
        ),
    ];
    assert_eq!(of(&none), [[""; 0]; 0]);
}
