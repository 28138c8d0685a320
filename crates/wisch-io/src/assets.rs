//! Files, with limits, and the knowledge that the library carries.

use crate::digest::InputDigest;
use crate::error::Error;
use crate::knowledge::{InteractionRevision, RevisedFile, parse_knowledge, revised};
use include_dir::{Dir, include_dir};
use std::fs::File;
use std::io::{ErrorKind, Read};
use std::path::{Path, PathBuf};
use wisch::goal::Domain;
use wisch::represent::KnowledgeBase;

/// Longest file that is read [bytes].
const MAX_FILE_LEN: u64 = 256 << 20;

/// From which likeness on, 1 being the same, a file name is offered in place of a missing one.
const LIKE: f64 = 0.6;

/// The knowledge folder as it was when the program was built.
static BUILT_IN: Dir = include_dir!("$WISCH_SHIPPED/knowledge");

/// The shipped scenarios as they were when the program was built.
static SCENARIOS: Dir = include_dir!("$WISCH_SHIPPED/scenarios");

/// The file with the PDDL domain in a knowledge folder.
const DOMAIN_FILE: &str = "wiping.pddl";

/// Reads a whole file.
///
/// # Errors
/// A file that is not there, a folder, one beyond 256 MiB, or whatever the system says.
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
    // Pipes and devices do not tell their length: count what comes.
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

/// How long a pipe that nobody writes into is waited for.
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
    Err(Error::unusable(path, "this is no file"))
}

/// Reads a named pipe to its end; gives up where nothing comes.
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
            // Its end, or nobody has opened the other side yet.
            Ok(0) if !bytes.is_empty() => return Ok(bytes),
            Ok(count) if count > 0 => {
                bytes.extend_from_slice(&part[..count]);
                since = std::time::Instant::now();
            }
            Err(error) if error.kind() != ErrorKind::WouldBlock => return Err(failed(error)),
            _ => std::thread::sleep(std::time::Duration::from_millis(10)),
        }
        if bytes.len() as u64 > MAX_FILE_LEN {
            let problem = format!("it exceeds the limit of {MAX_FILE_LEN} bytes");
            return Err(Error::unusable(path, problem));
        }
        if since.elapsed() > PATIENCE {
            let waited = PATIENCE.as_secs();
            let problem = format!("this is a pipe into which nobody wrote for {waited} s");
            return Err(Error::unusable(path, problem));
        }
    }
}

/// Reads a whole file as text.
///
/// # Errors
/// Those of [`read`], and bytes that are not UTF-8.
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

/// The shipped scenarios, each with its name and the text of its task file, by name.
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

/// The text of a task file, or, where there is no such file, of the shipped scenario of that name.
pub(crate) fn read_task_text(path: &Path) -> Result<String, Error> {
    read_text(path).or_else(|error| {
        let Error::NoSuchFile { path, nearest } = error else {
            return Err(error);
        };
        let named = shipped_scenarios().find(|(name, _)| Path::new(name) == path);
        let (_, text) = named.ok_or_else(|| Error::NoSuchFile {
            nearest: nearest.or_else(|| nearest_scenario(&path)),
            path,
        })?;
        Ok(text.to_owned())
    })
}

/// The shipped scenario with the name nearest to the one asked for, if one is near.
fn nearest_scenario(path: &Path) -> Option<String> {
    let wanted = path.to_str()?;
    let names = shipped_scenarios().map(|(name, _)| name.to_owned());
    nearest_of(wanted, names)
}

/// The name in the same folder that is nearest to the one asked for, if one is near.
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

/// Reads what a task file refers to: paths count from the task file's folder.
pub fn beside(task_file: &Path) -> impl FnMut(&str) -> Result<Vec<u8>, String> + use<> {
    let folder = task_file
        .parent()
        .map(Path::to_path_buf)
        .unwrap_or_default();
    move |path| read(&folder.join(path)).map_err(|error| error.to_string())
}

/// Where knowledge comes from.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub enum KnowledgeSource {
    /// That which is shipped.
    #[default]
    BuiltIn,
    /// A folder of the user's.
    Folder(PathBuf),
}

impl KnowledgeSource {
    /// The user's folder, or what is built in.
    pub fn new(folder: Option<&Path>) -> Self {
        folder.map_or(Self::BuiltIn, |folder| Self::Folder(folder.to_path_buf()))
    }

    /// All tools, media, surfaces and interactions.
    ///
    /// # Errors
    /// No folder, a file that cannot be read, or knowledge that does not hold together.
    pub fn base(&self) -> Result<KnowledgeBase, Error> {
        let texts = self.texts()?;
        let texts: Vec<(&str, &str)> = texts
            .iter()
            .map(|(name, text)| (name.as_str(), text.as_str()))
            .collect();
        Ok(parse_knowledge(&texts)?)
    }

    /// The files that change if this is written into them; nothing is written.
    ///
    /// # Errors
    /// Those of [`base`](Self::base), an interaction that no file has as a table, or one that would be refused.
    pub fn revised(&self, revisions: &[InteractionRevision]) -> Result<Vec<RevisedFile>, Error> {
        revised(&self.texts()?, revisions)
    }

    /// The PDDL domain of wiping.
    ///
    /// # Errors
    /// A file that cannot be read, or is no domain.
    pub fn domain(&self) -> Result<Domain, Error> {
        let text = self.asset(DOMAIN_FILE).map_err(Error::Asset)?;
        let name = self.shown(DOMAIN_FILE);
        let text = String::from_utf8(text)
            .map_err(|_| Error::unusable(Path::new(&name), "it is not UTF-8 text"))?;
        Ok(Domain::parse(&name, &text)?)
    }

    /// A file of the knowledge folder, such as a tool's mesh.
    ///
    /// # Errors
    /// A sentence about the file that is not there or cannot be read.
    pub fn asset(&self, path: &str) -> Result<Vec<u8>, String> {
        match self {
            Self::BuiltIn => BUILT_IN
                .get_file(path)
                .map(|file| file.contents().to_vec())
                .ok_or_else(|| format!("{path}: the built-in knowledge has no such file")),
            Self::Folder(folder) => read(&folder.join(path)).map_err(|error| error.to_string()),
        }
    }

    /// Takes in all knowledge.
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

    /// Every TOML file of the folder with its name, by name.
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
