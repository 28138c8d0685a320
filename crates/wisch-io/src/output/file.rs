//! A file that is written beside its target under another name, and then moved there.

use super::fault::{OTHER_FILE, cannot_write_file, refused};
use super::{Unfinished, UnfinishedPath};
use crate::error::Error;
use std::fs::{self, File};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use tempfile::{NamedTempFile, PersistError};

/// Ending of a file that is not complete yet, and the mark before the random part of its name: `.NAME.wisch-RANDOM.part`.
const PART_ENDING: &str = ".part";
const PART_MARK: &str = ".wisch-";
/// Number of random characters in the name of an unfinished file.
const RANDOM_LEN: usize = 6;
/// Longest part of the target's name in that of its unfinished file [bytes]: file systems allow 255 bytes for all of it.
const MAX_PART_NAME: usize = 200;
/// Largest number of links from one path to its file, as on Linux.
const MAX_LINKS: usize = 40;

/// An unfinished file, which appears at its target complete or not at all. An interruption removes it; if the process is
/// killed, the next file in the same folder does.
pub struct OutputFile {
    target: PathBuf,
    /// `None` for a target that is no regular file, such as `/dev/stdout`, which is written in place.
    part: Option<Part>,
}

/// A file beside its target, locked as long as it is written.
struct Part {
    // Dropped in this order: the file is removed while it is guarded.
    file: NamedTempFile,
    unfinished: Unfinished,
}

impl OutputFile {
    /// Begins a file beside `target`, which [`Self::finish`] moves there.
    ///
    /// A file that is replaced keeps its permissions. The file behind a link is replaced, not the link.
    ///
    /// # Errors
    /// If the target is a folder or read-only, or the file cannot be written.
    pub fn begin(target: &Path) -> Result<Self, Error> {
        let replaced = fs::metadata(target).ok();
        if replaced.as_ref().is_some_and(fs::Metadata::is_dir) {
            return Err(refused(
                target,
                "cannot write the file: this is a folder",
                OTHER_FILE,
            ));
        }
        if replaced
            .as_ref()
            .is_some_and(|replaced| !replaced.is_file())
        {
            return Ok(Self {
                target: target.to_owned(),
                part: None,
            });
        }
        let target = follow_links(target).map_err(|error| cannot_write_file(target, &error))?;
        let kept = replaced.map(|replaced| replaced.permissions());
        if kept.as_ref().is_some_and(fs::Permissions::readonly) {
            return Err(refused(
                &target,
                "cannot replace the file: it is read-only",
                OTHER_FILE,
            ));
        }
        let part =
            Part::begin(&target, kept).map_err(|error| cannot_write_file(&target, &error))?;
        Ok(Self {
            target,
            part: Some(part),
        })
    }

    /// Writes the contents and moves the file to its target.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn finish(self, contents: &[u8]) -> Result<(), Error> {
        self.place(contents, |file, target| file.persist(target))
    }

    /// Writes the contents and moves the file to its target, which must not exist.
    ///
    /// # Errors
    /// If the target exists meanwhile, or the file cannot be written.
    pub fn finish_new(self, contents: &[u8]) -> Result<(), Error> {
        self.place(contents, |file, target| file.persist_noclobber(target))
    }

    fn place(
        self,
        contents: &[u8],
        persist: impl FnOnce(NamedTempFile, &Path) -> Result<File, PersistError>,
    ) -> Result<(), Error> {
        let Self { target, part } = self;
        let failed = |error: io::Error| cannot_write_file(&target, &error);
        let Some(Part {
            mut file,
            unfinished,
        }) = part
        else {
            return fs::write(&target, contents).map_err(failed);
        };
        file.write_all(contents).map_err(failed)?;
        let placed = unfinished.place(|| persist(file, &target));
        placed.map_err(|error| match error.error.kind() {
            ErrorKind::AlreadyExists => refused(&target, "it exists already", OTHER_FILE),
            _ => failed(error.error),
        })?;
        Ok(())
    }
}

/// Returns the path behind links, also if no file exists there yet.
fn follow_links(target: &Path) -> io::Result<PathBuf> {
    let mut target = target.to_owned();
    for _ in 0..MAX_LINKS {
        let Ok(next) = fs::read_link(&target) else {
            return Ok(target);
        };
        // A link is relative to its folder.
        target = target.parent().unwrap_or(Path::new("")).join(next);
    }
    Err(io::Error::other(format!("more than {MAX_LINKS} links")))
}

impl Part {
    /// Begins a file for `target`. `permissions`: those of the replaced file.
    fn begin(target: &Path, permissions: Option<fs::Permissions>) -> io::Result<Self> {
        let folder = match target.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder,
            _ => Path::new("."),
        };
        // Another process must not take a file that is not locked yet for one that a killed process has left.
        let _turn = File::open(folder).and_then(|folder| folder.lock().map(|()| folder));
        remove_dead_parts(folder);
        let name = target.file_name().unwrap_or_default().to_string_lossy();
        let (file, unfinished) = Unfinished::create(|| {
            let file = new_part(folder, &part_prefix(&name))?;
            let path = UnfinishedPath::Whole(file.path().to_owned());
            io::Result::Ok((file, vec![path]))
        })?;
        if let Some(permissions) = permissions {
            file.as_file().set_permissions(permissions)?;
        }
        // Without locks, a killed process's file stays.
        let _ = file.as_file().try_lock();
        Ok(Self { file, unfinished })
    }
}

/// Makes a file that others may read, as the process's mask of permissions allows.
fn new_part(folder: &Path, prefix: &str) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder
        .prefix(prefix)
        .rand_bytes(RANDOM_LEN)
        .suffix(PART_ENDING)
        .tempfile_in(folder)
}

/// Removes the unfinished files of killed processes in a folder. Files that cannot be removed stay.
fn remove_dead_parts(folder: &Path) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        if !is_part_name(&name) {
            continue;
        }
        let path = entry.path();
        let is_file = entry.file_type().is_ok_and(|kind| kind.is_file());
        if is_file && File::open(&path).is_ok_and(|file| file.try_lock().is_ok()) {
            let _ = fs::remove_file(&path);
        }
    }
}

/// Returns the first part of the name of an unfinished file for a target's name, which is cut if it is long.
fn part_prefix(name: &str) -> String {
    let end = name.floor_char_boundary(MAX_PART_NAME);
    format!(".{}{PART_MARK}", &name[..end])
}

/// Whether a file has the name of an unfinished file of this program.
fn is_part_name(name: &str) -> bool {
    let name = name
        .strip_suffix(PART_ENDING)
        .and_then(|name| name.strip_prefix('.'));
    name.and_then(|name| name.rsplit_once(PART_MARK))
        .is_some_and(|(_, random)| {
            random.len() == RANDOM_LEN && random.bytes().all(|byte| byte.is_ascii_alphanumeric())
        })
}

#[cfg(test)]
mod tests {
    use super::super::tests::names;
    use super::*;

    #[test]
    fn a_file_that_is_written_aside_removes_only_those_of_dead_processes() {
        let folder = tempfile::tempdir().expect("a folder");
        let living = OutputFile::begin(&folder.path().join("a.txt")).expect("a file");
        let [of_living] = &names(folder.path())[..] else {
            panic!("one file");
        };
        let of_others = [
            ".a.wisch-x1y2.z.part",
            ".b.txt.x1y2z3.part",
            ".cache.sqlite.part",
            ".notes.part",
        ];
        for name in of_others.iter().chain(&[".b.txt.wisch-x1y2z3.part"]) {
            fs::write(folder.path().join(name), "half").expect("a file");
        }
        let dropped = OutputFile::begin(&folder.path().join("c.txt")).expect("a file");
        assert_eq!(names(folder.path()).len(), of_others.len() + 2);
        assert!(folder.path().join(of_living).exists());
        drop(dropped);
        living.finish(b"whole").expect("in place");
        let left = names(folder.path());
        assert_eq!(left[..of_others.len()], of_others);
        assert_eq!(left[of_others.len()..], ["a.txt"]);
    }

    #[test]
    fn a_file_with_the_longest_name_is_written() {
        let folder = tempfile::tempdir().expect("a folder");
        let name = format!("a{}", "é".repeat(127));
        let begun = OutputFile::begin(&folder.path().join(&name)).expect("a file");
        begun.finish(b"whole").expect("in place");
        assert_eq!(names(folder.path()), [name]);
    }

    #[test]
    fn a_new_file_replaces_none_that_appears_meanwhile() {
        let folder = tempfile::tempdir().expect("a folder");
        let target = folder.path().join("a.txt");
        let begun = OutputFile::begin(&target).expect("a file");
        fs::write(&target, "of another program").expect("a file");
        let error = begun.finish_new(b"new").expect_err("it exists");
        assert!(error.to_string().contains("it exists already"), "{error}");
        assert_eq!(fs::read(&target).expect("a file"), b"of another program");
        assert_eq!(names(folder.path()), ["a.txt"]);
    }

    #[cfg(unix)]
    #[test]
    fn a_replaced_file_keeps_its_permissions_and_a_read_only_one_its_contents() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().expect("a folder");
        let target = folder.path().join("a.txt");
        fs::write(&target, "old").expect("a file");
        let allow = |mode| {
            fs::set_permissions(&target, fs::Permissions::from_mode(mode)).expect("permissions");
        };
        allow(0o600);
        let begun = OutputFile::begin(&target).expect("a file");
        begun.finish(b"new").expect("in place");
        let mode = fs::metadata(&target).expect("a file").permissions().mode();
        assert_eq!(mode & 0o777, 0o600);
        allow(0o444);
        let Err(error) = OutputFile::begin(&target) else {
            panic!("it is read-only");
        };
        assert!(error.to_string().contains("read-only"), "{error}");
        assert_eq!(names(folder.path()), ["a.txt"]);
    }

    #[cfg(unix)]
    #[test]
    fn links_and_devices_are_written_and_not_replaced() {
        let folder = tempfile::tempdir().expect("a folder");
        let [link, file] = ["link", "file"].map(|name| folder.path().join(name));
        fs::write(&file, "old").expect("a file");
        std::os::unix::fs::symlink(&file, &link).expect("a link");
        let begun = OutputFile::begin(&link).expect("a file");
        begun.finish(b"new").expect("in place");
        assert!(link.is_symlink());
        assert_eq!(fs::read(&file).expect("a file"), b"new");
        // Also if the link shows where the file will be.
        fs::remove_file(&file).expect("a file");
        std::os::unix::fs::symlink("link", folder.path().join("second")).expect("a link");
        let begun = OutputFile::begin(&folder.path().join("second")).expect("a file");
        begun.finish(b"first").expect("in place");
        assert!(link.is_symlink() && !file.is_symlink());
        assert_eq!(fs::read(&file).expect("a file"), b"first");
        let null = Path::new("/dev/null");
        let begun = OutputFile::begin(null).expect("a device");
        begun.finish(b"new").expect("written");
        assert!(!null.is_file());
    }
}
