//! Reading files with limits, and the embedded knowledge base and scenarios.

use crate::digest::InputDigest;
use crate::error::Error;
use crate::knowledge::{
    InteractionRevision, RevisedFile, list_learned_rounds, parse_knowledge, revise_knowledge,
};
use include_dir::{Dir, include_dir};
use std::collections::BTreeSet;
use std::fs::File;
use std::io::{ErrorKind, Read};
use std::path::{Path, PathBuf};
use wisch::goal::Domain;
use wisch::represent::KnowledgeBase;

/// Maximum size of a file [bytes].
const MAX_FILE_LEN: u64 = 256 << 20;

/// Minimum similarity of a file name, from 0 to 1 (equal), to be suggested for a missing file.
const LIKE: f64 = 0.6;

/// The knowledge folder at the time of the build.
static BUILT_IN: Dir = include_dir!("$WISCH_SHIPPED/knowledge");

/// The scenarios at the time of the build.
static SCENARIOS: Dir = include_dir!("$WISCH_SHIPPED/scenarios");

/// The file with the PDDL domain in a knowledge folder.
const DOMAIN_FILE: &str = "wiping.pddl";

/// Reads a whole file into memory.
///
/// # Errors
/// If the file is missing, is a folder, exceeds 256 MiB, or cannot be read.
pub fn read(path: &Path) -> Result<Vec<u8>, Error> {
    let failed = |error: std::io::Error| match error.kind() {
        ErrorKind::NotFound => Error::NoSuchFile {
            path: path.to_owned(),
            nearest: nearest_name(path),
        },
        _ => Error::unusable(path, error),
    };
    if is_pipe(path) {
        return read_pipe(path);
    }
    let file = File::open(path).map_err(failed)?;
    let metadata = file.metadata().map_err(failed)?;
    if metadata.is_dir() {
        return Err(Error::unusable(path, "this is a folder, not a file"));
    }
    let mut bytes = Vec::new();
    // Pipes and devices have no known length, so count the bytes.
    file.take(MAX_FILE_LEN + 1)
        .read_to_end(&mut bytes)
        .map_err(failed)?;
    if bytes.len() as u64 > MAX_FILE_LEN {
        let len = metadata.len().max(bytes.len() as u64);
        let problem = format!("{len} bytes exceed the limit of {MAX_FILE_LEN} bytes");
        return Err(Error::unusable(path, problem));
    }
    Ok(bytes)
}

/// Time to wait for a writer of a named pipe.
#[cfg(unix)]
const PATIENCE: std::time::Duration = std::time::Duration::from_secs(10);

#[cfg(unix)]
fn is_pipe(path: &Path) -> bool {
    use std::os::unix::fs::FileTypeExt;
    std::fs::metadata(path).is_ok_and(|metadata| metadata.file_type().is_fifo())
}

#[cfg(not(unix))]
fn is_pipe(_: &Path) -> bool {
    false
}

#[cfg(not(unix))]
fn read_pipe(path: &Path) -> Result<Vec<u8>, Error> {
    Err(Error::unusable(path, "this is not a regular file or pipe"))
}

/// Reads a named pipe to its end; fails if no data arrives in time.
#[cfg(unix)]
fn read_pipe(path: &Path) -> Result<Vec<u8>, Error> {
    use std::os::unix::fs::OpenOptionsExt;
    let failed = |error: std::io::Error| Error::unusable(path, error);
    let mut pipe = File::options()
        .read(true)
        .custom_flags(libc::O_NONBLOCK)
        .open(path)
        .map_err(failed)?;
    let mut bytes = Vec::new();
    let mut since = std::time::Instant::now();
    let mut part = [0; 1 << 16];
    loop {
        match pipe.read(&mut part) {
            // End of the data, or the other side is not open yet.
            Ok(0) if !bytes.is_empty() => return Ok(bytes),
            Ok(count) if count > 0 => {
                bytes.extend_from_slice(&part[..count]);
                since = std::time::Instant::now();
            }
            Err(error) if error.kind() != ErrorKind::WouldBlock => return Err(failed(error)),
            _ => std::thread::sleep(std::time::Duration::from_millis(10)),
        }
        if bytes.len() as u64 > MAX_FILE_LEN {
            let problem = format!("the data exceed the limit of {MAX_FILE_LEN} bytes");
            return Err(Error::unusable(path, problem));
        }
        if since.elapsed() > PATIENCE {
            let waited = PATIENCE.as_secs();
            let problem = format!("no data arrived on this pipe for {waited} s");
            return Err(Error::unusable(path, problem));
        }
    }
}

/// Reads a whole file as text.
///
/// # Errors
/// Those of [`read`], or if the file is not UTF-8.
pub fn read_text(path: &Path) -> Result<String, Error> {
    let bytes = read(path)?;
    String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        let line = 1 + error.as_bytes()[..at]
            .iter()
            .filter(|&&b| b == b'\n')
            .count();
        Error::NotText {
            path: path.to_owned(),
            line,
            byte: at,
        }
    })
}

/// Returns the shipped scenarios, sorted by name: name and text of the task file.
///
/// ```
/// let names: Vec<&str> = wisch_io::shipped_scenarios().map(|(name, _)| name).collect();
/// assert!(names.contains(&"chopping-board"));
/// ```
pub fn shipped_scenarios() -> impl Iterator<Item = (&'static str, &'static str)> {
    let mut scenarios: Vec<_> = (SCENARIOS.files())
        .filter(|file| is_toml(file.path()))
        .filter_map(|file| Some((file.path().file_stem()?.to_str()?, file.contents_utf8()?)))
        .collect();
    scenarios.sort_unstable();
    scenarios.into_iter()
}

/// Returns the text of a task file, or of the shipped scenario of that name if there is no such file. A folder of that
/// name, such as one with results, is no file.
pub(crate) fn read_task_text(path: &Path) -> Result<String, Error> {
    if let Some(text) = find_shipped(path).filter(|_| path.is_dir()) {
        return Ok(text.to_owned());
    }
    read_text(path).or_else(|error| {
        let Error::NoSuchFile { path, nearest } = error else {
            return Err(error);
        };
        let text = find_shipped(&path).ok_or_else(|| Error::NoSuchFile {
            nearest: nearest.or_else(|| nearest_scenario(&path)),
            path,
        })?;
        Ok(text.to_owned())
    })
}

/// Returns the text of the shipped scenario of this name.
fn find_shipped(name: &Path) -> Option<&'static str> {
    let named = shipped_scenarios().find(|(known, _)| Path::new(known) == name);
    named.map(|(_, text)| text)
}

/// Returns the shipped scenario with the most similar name, if one is similar.
fn nearest_scenario(path: &Path) -> Option<String> {
    let wanted = path.to_str()?;
    let names = shipped_scenarios().map(|(name, _)| name.to_owned());
    nearest_of(wanted, names)
}

/// Returns the most similar file name in the same folder, if one is similar.
fn nearest_name(path: &Path) -> Option<String> {
    let wanted = path.file_name()?.to_str()?;
    let folder = match path.parent()? {
        parent if parent.as_os_str().is_empty() => Path::new("."),
        parent => parent,
    };
    let names = std::fs::read_dir(folder).ok()?;
    nearest_of(
        wanted,
        names.filter_map(|entry| entry.ok()?.file_name().into_string().ok()),
    )
}

fn nearest_of(wanted: &str, names: impl Iterator<Item = String>) -> Option<String> {
    names
        .map(|name| (strsim::normalized_levenshtein(&name, wanted), name))
        .filter(|(likeness, _)| *likeness >= LIKE)
        .max_by(|a, b| a.0.total_cmp(&b.0).then_with(|| b.1.cmp(&a.1)))
        .map(|(_, name)| name)
}

/// Returns the files that a shipped scenario names: paths relative to its task file, and contents.
pub fn scenario_files(task_file: &str) -> impl Iterator<Item = (&'static str, &'static [u8])> {
    let files = SCENARIOS.dirs().flat_map(|folder| folder.files());
    let files = files.filter_map(|file| Some((file.path().to_str()?, file.contents())));
    files.filter(move |(path, _)| task_file.contains(&format!("\"{path}\"")))
}

/// Returns a file that a shipped scenario names, such as a mesh.
fn shipped_file(scenario: &str, path: &str) -> Result<Vec<u8>, String> {
    let file = SCENARIOS.get_file(path);
    let missing = || {
        format!(
            "{path}: the shipped scenarios have no such file. State its absolute path, or write the scenario into a folder with wisch scenarios {scenario} --out FOLDER, and use the task file there"
        )
    };
    Ok(file.ok_or_else(missing)?.contents().to_vec())
}

/// Returns a reader for the files of a task: their paths are absolute, or relative to the task file's folder, or those of a
/// shipped scenario if there is no such task file.
pub fn read_beside(task_file: &Path) -> impl FnMut(&str) -> Result<Vec<u8>, String> + use<> {
    let is_shipped = find_shipped(task_file).is_some() && !task_file.exists();
    let folder = task_file
        .parent()
        .map(Path::to_path_buf)
        .unwrap_or_default();
    let scenario = task_file.display().to_string();
    move |path| match is_shipped && Path::new(path).is_relative() {
        true => shipped_file(&scenario, path),
        false => read(&folder.join(path)).map_err(|error| error.to_string()),
    }
}

/// The source of the knowledge base.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub enum KnowledgeSource {
    /// The shipped knowledge base.
    #[default]
    BuiltIn,
    /// A folder of the user.
    Folder(PathBuf),
}

impl KnowledgeSource {
    /// Returns the user's folder, else the built-in knowledge base.
    pub fn new(folder: Option<&Path>) -> Self {
        folder.map_or(Self::BuiltIn, |folder| Self::Folder(folder.to_path_buf()))
    }

    /// Reads all tools, media, surfaces and interactions.
    ///
    /// # Errors
    /// If the folder or a file cannot be read, or the knowledge is inconsistent.
    pub fn base(&self) -> Result<KnowledgeBase, Error> {
        let texts = self.texts()?;
        let texts: Vec<(&str, &str)> = texts
            .iter()
            .map(|(name, text)| (name.as_str(), text.as_str()))
            .collect();
        Ok(parse_knowledge(&texts)?)
    }

    /// Returns the files that the revisions change, without writing them.
    ///
    /// # Errors
    /// Those of [`base`](Self::base), or if no file has an interaction as a table, or a revised one would be invalid.
    pub fn revise_knowledge(
        &self,
        revisions: &[InteractionRevision],
    ) -> Result<Vec<RevisedFile>, Error> {
        revise_knowledge(&self.texts()?, revisions)
    }

    /// Returns the digests of the rounds from which `wisch learn` has learned entries.
    ///
    /// # Errors
    /// If the folder or a file cannot be read.
    pub fn list_learned_rounds(&self) -> Result<BTreeSet<String>, Error> {
        Ok(list_learned_rounds(&self.texts()?))
    }

    /// Reads the PDDL domain of wiping.
    ///
    /// # Errors
    /// If the file cannot be read or is not a valid domain.
    pub fn domain(&self) -> Result<Domain, Error> {
        let text = self.asset(DOMAIN_FILE).map_err(Error::Asset)?;
        let name = self.shown(DOMAIN_FILE);
        let text = String::from_utf8(text)
            .map_err(|_| Error::unusable(Path::new(&name), "the file is not UTF-8 text"))?;
        Ok(Domain::parse(&name, &text)?)
    }

    /// Reads a file of the knowledge folder, such as a tool's mesh.
    ///
    /// # Errors
    /// A message if the file is missing or cannot be read.
    pub fn asset(&self, path: &str) -> Result<Vec<u8>, String> {
        match self {
            Self::BuiltIn => BUILT_IN
                .get_file(path)
                .map(|file| file.contents().to_vec())
                .ok_or_else(|| format!("{path}: the built-in knowledge has no such file")),
            Self::Folder(folder) => read(&folder.join(path)).map_err(|error| error.to_string()),
        }
    }

    /// Adds all knowledge files to a digest.
    pub(crate) fn add_to(&self, inputs: &mut InputDigest) -> Result<(), Error> {
        for (name, text) in self.texts()? {
            inputs.add(&name, text);
        }
        inputs.add(DOMAIN_FILE, self.asset(DOMAIN_FILE).unwrap_or_default());
        Ok(())
    }

    fn shown(&self, file: &str) -> String {
        match self {
            Self::BuiltIn => format!("built-in {file}"),
            Self::Folder(folder) => folder.join(file).display().to_string(),
        }
    }

    /// Lists the TOML files of the folder with their texts, sorted by name.
    pub(crate) fn texts(&self) -> Result<Vec<(String, String)>, Error> {
        let mut texts = match self {
            Self::BuiltIn => BUILT_IN
                .files()
                .filter(|file| is_toml(file.path()))
                .filter_map(|file| {
                    let name = self.shown(file.path().to_str()?);
                    Some((name, file.contents_utf8()?.to_owned()))
                })
                .collect::<Vec<_>>(),
            Self::Folder(folder) => {
                let entries =
                    std::fs::read_dir(folder).map_err(|error| Error::unusable(folder, error))?;
                entries
                    .filter_map(|entry| Some(entry.ok()?.path()))
                    .filter(|path| is_toml(path))
                    .map(|path| Ok((path.display().to_string(), read_text(&path)?)))
                    .collect::<Result<Vec<_>, Error>>()?
            }
        };
        if let (Self::Folder(folder), true) = (self, texts.is_empty()) {
            return Err(Error::NoKnowledge {
                folder: folder.clone(),
            });
        }
        texts.sort();
        Ok(texts)
    }
}

fn is_toml(path: &Path) -> bool {
    path.extension()
        .is_some_and(|extension| extension == "toml")
}
