//! The files of a log: the parts of a bag, tables, and formats that must be converted first.

use super::error::{ReadFault, RecordingKind};
use std::fs::File;
use std::io::{BufReader, ErrorKind, Read};
use std::path::{Path, PathBuf};

/// Checks that the path is a file or folder: a pipe or device may never begin or end.
pub(super) fn check_is_file(path: &Path) -> Result<(), ReadFault> {
    let kind = std::fs::metadata(path)
        .map_err(ReadFault::System)?
        .file_type();
    if kind.is_file() {
        return Ok(());
    }
    #[cfg(unix)]
    {
        use std::os::unix::fs::FileTypeExt;
        if kind.is_fifo() {
            return Err(ReadFault::NoFile { kind: "a pipe" });
        }
        if kind.is_socket() {
            return Err(ReadFault::NoFile { kind: "a socket" });
        }
    }
    let kind = if kind.is_dir() {
        "a folder in a folder"
    } else {
        "a device"
    };
    Err(ReadFault::NoFile { kind })
}

/// Opens a bag, unpacked if the whole file is packed.
pub(super) fn open_bag(path: &Path) -> Result<Box<dyn Read>, ReadFault> {
    let file = BufReader::new(File::open(path).map_err(ReadFault::System)?);
    if is_packed_bag(path) {
        return Ok(Box::new(
            zstd::Decoder::new(file).map_err(ReadFault::System)?,
        ));
    }
    Ok(Box::new(file))
}

/// Largest size of a table [bytes]: half an hour at 1 kHz.
const MAX_TABLE_LEN: u64 = 256 << 20;

pub(super) fn bytes(path: &Path) -> Result<Vec<u8>, ReadFault> {
    let file = File::open(path).map_err(ReadFault::System)?;
    let mut bytes = Vec::new();
    // Pipes and devices do not state their length, so the bytes are counted.
    file.take(MAX_TABLE_LEN + 1)
        .read_to_end(&mut bytes)
        .map_err(ReadFault::System)?;
    if bytes.len() as u64 > MAX_TABLE_LEN {
        return Err(ReadFault::TableLength {
            limit: MAX_TABLE_LEN,
        });
    }
    Ok(bytes)
}

/// Returns the file, or the bags in the folder in the order of their recording.
pub(super) fn list_parts(path: &Path) -> std::io::Result<Vec<PathBuf>> {
    if !path.is_dir() {
        return Ok(vec![path.to_path_buf()]);
    }
    let (mut parts, mut others) = (Vec::new(), Vec::new());
    for entry in std::fs::read_dir(path)? {
        let path = entry?.path();
        if has_bag_ending(&path) {
            parts.push(path);
        } else if path.extension().is_some_and(|ending| ending == "db3") {
            others.push(path);
        }
    }
    if parts.is_empty() {
        parts = others;
    } else {
        check_parts(path, &parts)?;
    }
    // Recorders number the parts without leading zeros: bag_2 before bag_10.
    parts.sort_by_key(|path| (path.as_os_str().len(), path.clone()));
    if parts.is_empty() {
        return Err(std::io::Error::new(
            ErrorKind::NotFound,
            "the folder holds no .mcap file",
        ));
    }
    Ok(parts)
}

/// Checks that the folder of a bag holds all parts that its metadata name.
fn check_parts(folder: &Path, parts: &[PathBuf]) -> std::io::Result<()> {
    let Ok(metadata) = std::fs::read_to_string(folder.join("metadata.yaml")) else {
        return Ok(());
    };
    let stem = |name: &str| {
        let end = name.find(".mcap").unwrap_or(name.len());
        name[..end].to_owned()
    };
    let known: Vec<String> = (parts.iter())
        .filter_map(|part| Some(stem(part.file_name()?.to_str()?)))
        .collect();
    let lines = metadata.lines().map(str::trim);
    let names = lines
        .skip_while(|line| *line != "relative_file_paths:")
        .skip(1);
    let names = names.map_while(|line| line.strip_prefix("- "));
    let mut names = names.map(|name| name.trim_matches(['"', '\'']));
    let missing = names.find(|name| {
        let last = name.rsplit('/').next().unwrap_or(name);
        last.contains(".mcap") && !known.contains(&stem(last))
    });
    missing.map_or(Ok(()), |name| {
        Err(std::io::Error::new(
            ErrorKind::NotFound,
            format!(
                "metadata.yaml names the part {name}, which is missing: copy it into the folder, or read one part by its own path"
            ),
        ))
    })
}

fn has_bag_ending(path: &Path) -> bool {
    let name = path.as_os_str().to_string_lossy();
    name.ends_with(".mcap") || name.ends_with(".mcap.active") || is_packed_bag(path)
}

/// Whether a whole bag is packed, as rosbag2 does in its compression mode for files.
fn is_packed_bag(path: &Path) -> bool {
    let name = path.as_os_str().to_string_lossy();
    name.ends_with(".mcap.zstd") || name.ends_with(".mcap.zst")
}

/// Returns the format of a recording that must be converted first, by its first bytes.
pub(super) fn other_recording(path: &Path) -> std::io::Result<Option<RecordingKind>> {
    let mut begin = Vec::new();
    let file = File::open(path)?;
    file.take(MOST_BEGIN).read_to_end(&mut begin)?;
    let known = OTHER_RECORDINGS
        .iter()
        .find(|(magic, _)| begin.starts_with(magic));
    Ok(match known {
        Some((_, kind)) => Some(*kind),
        None if is_workbook(&begin) => Some(RecordingKind::Workbook),
        None if is_json(&begin) => Some(RecordingKind::Json),
        None => None,
    })
}

/// Number of the first bytes that show the format of a recording.
const MOST_BEGIN: u64 = 256;

/// First bytes of recordings that must be converted first.
const OTHER_RECORDINGS: [(&[u8], RecordingKind); 6] = [
    (b"SQLite format 3\0", RecordingKind::Sqlite),
    (b"#ROSBAG V", RecordingKind::Ros1),
    (b"\x1f\x8b", RecordingKind::Gzip),
    (b"\xff\xfe", RecordingKind::Utf16),
    (b"\xfe\xff", RecordingKind::Utf16),
    (b"\x89HDF\r\n\x1a\n", RecordingKind::Hdf5),
];

/// Whether a zip archive begins with a part of a workbook, after the 30 bytes of its first header.
fn is_workbook(begin: &[u8]) -> bool {
    let parts = [
        "[Content_Types].xml",
        "_rels/",
        "docProps/",
        "xl/",
        "mimetype",
    ];
    let name = begin.get(30..).unwrap_or_default();
    begin.starts_with(b"PK") && parts.iter().any(|part| name.starts_with(part.as_bytes()))
}

/// Whether a text begins with an object or an array of JSON; the names of a table may begin with a bracket, too.
fn is_json(begin: &[u8]) -> bool {
    let mut signs = begin.iter().filter(|byte| !byte.is_ascii_whitespace());
    match (signs.next(), signs.next()) {
        (Some(b'{'), Some(next)) => b"\"}".contains(next),
        (Some(b'['), Some(next)) => b"{[\"-]".contains(next) || next.is_ascii_digit(),
        _ => false,
    }
}

/// Returns whether a file is a bag, by its ending or its first bytes. A folder is one if it holds parts of a bag.
///
/// # Errors
/// If the file cannot be read.
pub fn is_bag(path: &Path) -> std::io::Result<bool> {
    let parts = list_parts(path)?;
    is_bag_file(&parts[0])
}

/// Whether a file is a bag, by its ending or its first bytes.
pub(super) fn is_bag_file(path: &Path) -> std::io::Result<bool> {
    let mut begin = Vec::new();
    let file = File::open(path)?;
    file.take(mcap::MAGIC.len() as u64)
        .read_to_end(&mut begin)?;
    Ok(has_bag_ending(path) || begin == mcap::MAGIC)
}
