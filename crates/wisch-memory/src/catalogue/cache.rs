//! A catalogue on disk: tables in Parquet with one row group per property, so that a memory opens without reading every
//! episode.

use super::{Catalogue, CatalogueNode, EpisodeRow, IndividualId, Interned, NONE, at};
use crate::checked_file::CheckedFile;
use crate::columns::{Kind, Values, open, read_chunk, schema, with_encodings, write_group};
use parquet::basic::{Compression, ZstdLevel};
use parquet::data_type::{ByteArray, ByteArrayType, DataType, DoubleType, Int32Type};
use parquet::errors::ParquetError;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::reader::FileReader;
use parquet::file::serialized_reader::SerializedFileReader;
use parquet::file::writer::SerializedFileWriter;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, HashMap};
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Version of these files. Since version 2, they lack performances that a verdict calls unknown.
const CACHE_SCHEMA: u32 = 2;
const HEAD_FILE: &str = "head.json";
/// File with the CRC-32 of each other file.
const SUMS_FILE: &str = "checksums.json";
const EPISODES: Table = Table {
    file: "episodes.parquet",
    columns: &[
        ("id", Kind::Text),
        ("task", Kind::Text),
        ("start", Kind::Double),
        ("end", Kind::Double),
        ("first", Kind::Growing32),
        ("len", Kind::Code),
        ("rounds", Kind::Text),
    ],
};
const INDIVIDUALS: Table = Table {
    file: "individuals.parquet",
    columns: &[
        ("class", Kind::Code),
        ("start", Kind::Double),
        ("end", Kind::Double),
        ("parent", Kind::Growing32),
    ],
};
const NUMBERS: Table = Table {
    file: "numbers.parquet",
    columns: &[("subject", Kind::Growing32), ("value", Kind::Double)],
};
const TEXTS: Table = Table {
    file: "texts.parquet",
    columns: &[("subject", Kind::Growing32), ("value", Kind::Text)],
};
/// Objects are individuals, or −1 minus the index of a shared thing.
const RELATIONS: Table = Table {
    file: "relations.parquet",
    columns: &[("subject", Kind::Growing32), ("object", Kind::Growing32)],
};

/// A table in a file of its own.
struct Table {
    file: &'static str,
    columns: &'static [(&'static str, Kind)],
}

/// Names that the numbers in the tables refer to.
#[derive(Debug, Serialize, Deserialize)]
struct Head {
    schema: u32,
    classes: Vec<String>,
    properties: Vec<String>,
    shared: Vec<String>,
    /// Number of individuals.
    individuals: usize,
    /// Property of each row group.
    numbers: Vec<u32>,
    texts: Vec<u32>,
    relations: Vec<u32>,
}

/// The reason why a catalogue on disk cannot be used.
#[derive(Debug, thiserror::Error)]
pub(crate) enum CacheError {
    #[error("{}: {error}", path.display())]
    File { path: PathBuf, error: io::Error },
    #[error("{}: {error}", path.display())]
    Parquet { path: PathBuf, error: ParquetError },
    #[error("{}: {what}", path.display())]
    Broken { path: PathBuf, what: String },
}

/// Writes the files of a catalogue into a folder, and syncs them to disk.
pub(crate) fn write(catalogue: &Catalogue, folder: &Path) -> Result<(), CacheError> {
    write_episodes(catalogue, folder)?;
    let mut individuals = Output::begin(folder, &INDIVIDUALS)?;
    let classes: Vec<i32> = catalogue.classes.iter().copied().map(i32::from).collect();
    individuals.group(&[
        Values::Ints(&classes),
        Values::Doubles(&catalogue.starts),
        Values::Doubles(&catalogue.ends),
        Values::Ints(&to_signed(&catalogue.parents)),
    ])?;
    individuals.finish()?;
    let head = Head {
        schema: CACHE_SCHEMA,
        classes: catalogue.names.classes.names.clone(),
        properties: catalogue.names.properties.names.clone(),
        shared: catalogue.names.shared.names.clone(),
        individuals: catalogue.classes.len(),
        numbers: write_columns(folder, &NUMBERS, &catalogue.values, |group, column| {
            let values: Vec<f64> = column.0.iter().map(|(_, value)| *value).collect();
            group(&subjects(&column.0), Values::Doubles(&values))
        })?,
        texts: write_columns(folder, &TEXTS, &catalogue.texts, |group, column| {
            let values: Vec<ByteArray> = column
                .iter()
                .map(|(_, text)| ByteArray::from(text.as_str()))
                .collect();
            group(&subjects(column), Values::Texts(&values))
        })?,
        relations: write_columns(folder, &RELATIONS, &catalogue.relations, |group, column| {
            let objects: Vec<i32> = column.iter().map(|(_, node)| code_of(*node)).collect();
            group(&subjects(column), Values::Ints(&objects))
        })?,
    };
    write_json(&folder.join(HEAD_FILE), &head)?;
    write_json(&folder.join(SUMS_FILE), &sums(folder)?)
}

fn write_json(path: &Path, what: &impl Serialize) -> Result<(), CacheError> {
    let bytes = serde_json::to_vec(what).map_err(|error| broken(path, error))?;
    let written = File::create(path).and_then(|mut file| {
        file.write_all(&bytes)?;
        file.sync_all()
    });
    written.map_err(|error| CacheError::File {
        path: path.to_path_buf(),
        error,
    })
}

fn read_json<T: DeserializeOwned>(path: &Path) -> Result<T, CacheError> {
    let bytes = bytes_of(path)?;
    serde_json::from_slice(&bytes).map_err(|error| broken(path, error))
}

fn bytes_of(path: &Path) -> Result<Vec<u8>, CacheError> {
    fs::read(path).map_err(|error| CacheError::File {
        path: path.to_path_buf(),
        error,
    })
}

/// Returns the CRC-32 of every file except the file of sums.
fn sums(folder: &Path) -> Result<BTreeMap<String, u32>, CacheError> {
    let tables = [EPISODES, INDIVIDUALS, NUMBERS, TEXTS, RELATIONS];
    let names = tables.iter().map(|table| table.file).chain([HEAD_FILE]);
    let sums = names.map(|name| {
        let sum = crc32fast::hash(&bytes_of(&folder.join(name))?);
        Ok((name.to_owned(), sum))
    });
    sums.collect()
}

fn write_episodes(catalogue: &Catalogue, folder: &Path) -> Result<(), CacheError> {
    let rows = &catalogue.episodes;
    let texts = |of: &dyn Fn(&EpisodeRow) -> String| -> Vec<ByteArray> {
        let texts = rows.iter().map(|row| ByteArray::from(of(row).into_bytes()));
        texts.collect()
    };
    let doubles = |place: usize| -> Vec<f64> { rows.iter().map(|r| r.interval[place]).collect() };
    let firsts: Vec<u32> = rows.iter().map(|row| row.first).collect();
    let lengths: Vec<u32> = rows.iter().map(|row| row.len).collect();
    let mut output = Output::begin(folder, &EPISODES)?;
    output.group(&[
        Values::Texts(&texts(&|row| row.id.clone())),
        Values::Texts(&texts(&|row| row.task.clone())),
        Values::Doubles(&doubles(0)),
        Values::Doubles(&doubles(1)),
        Values::Ints(&to_signed(&firsts)),
        Values::Ints(&to_signed(&lengths)),
        Values::Texts(&texts(&|row| {
            serde_json::to_string(&row.rounds).unwrap_or_default()
        })),
    ])?;
    output.finish()
}

/// Writes a row group for each property with entries, and returns these properties.
fn write_columns<T>(
    folder: &Path,
    table: &Table,
    columns: &[T],
    entries: impl Fn(
        &mut dyn FnMut(&[i32], Values<'_>) -> Result<(), CacheError>,
        &T,
    ) -> Result<(), CacheError>,
) -> Result<Vec<u32>, CacheError> {
    let mut output = Output::begin(folder, table)?;
    let mut properties = Vec::new();
    for (property, column) in (0..).zip(columns) {
        let mut add = |subjects: &[i32], values: Values<'_>| {
            if subjects.is_empty() {
                return Ok(());
            }
            properties.push(property);
            output.group(&[Values::Ints(subjects), values])
        };
        entries(&mut add, column)?;
    }
    output.finish()?;
    Ok(properties)
}

/// A table that is being written.
struct Output {
    path: PathBuf,
    file: SerializedFileWriter<BufWriter<File>>,
}

impl Output {
    fn begin(folder: &Path, table: &Table) -> Result<Self, CacheError> {
        let path = folder.join(table.file);
        let file = File::create(&path).map_err(|error| CacheError::File {
            path: path.clone(),
            error,
        })?;
        let columns = || table.columns.iter().copied();
        let builder = WriterProperties::builder()
            .set_compression(Compression::ZSTD(ZstdLevel::default()))
            .set_max_row_group_row_count(None)
            .set_statistics_enabled(EnabledStatistics::None)
            .set_offset_index_disabled(true);
        let properties = with_encodings(builder, columns()).build();
        let file = schema(columns()).and_then(|schema| {
            SerializedFileWriter::new(BufWriter::new(file), schema, Arc::new(properties))
        });
        match file {
            Ok(file) => Ok(Self { path, file }),
            Err(error) => Err(CacheError::Parquet { path, error }),
        }
    }

    fn group(&mut self, columns: &[Values<'_>]) -> Result<(), CacheError> {
        write_group(&mut self.file, columns.iter().copied()).map_err(|error| CacheError::Parquet {
            path: self.path.clone(),
            error,
        })
    }

    fn finish(self) -> Result<(), CacheError> {
        let Self { path, file } = self;
        let buffer = match file.into_inner() {
            Ok(buffer) => buffer,
            Err(error) => return Err(CacheError::Parquet { path, error }),
        };
        let synced = (buffer.into_inner())
            .map_err(io::IntoInnerError::into_error)
            .and_then(|file| file.sync_all());
        synced.map_err(|error| CacheError::File { path, error })
    }
}

/// A table that is being read.
struct Input {
    path: PathBuf,
    file: SerializedFileReader<CheckedFile>,
}

impl Input {
    fn open(folder: &Path, table: &Table) -> Result<Self, CacheError> {
        let path = folder.join(table.file);
        let file = CheckedFile::open(&path, None).map_err(|error| CacheError::File {
            path: path.clone(),
            error,
        })?;
        match open(file) {
            Ok(file) => Ok(Self { path, file }),
            Err(error) => Err(CacheError::Parquet { path, error }),
        }
    }

    fn groups(&self, expected: usize) -> Result<(), CacheError> {
        match self.file.num_row_groups() {
            found if found == expected => Ok(()),
            found => Err(broken(
                &self.path,
                format!("{found} row groups; expected {expected}"),
            )),
        }
    }

    fn column<T: DataType>(&self, group: usize, column: usize) -> Result<Vec<T::T>, CacheError> {
        read_chunk::<T>(&self.file, group, column).map_err(|error| CacheError::Parquet {
            path: self.path.clone(),
            error,
        })
    }

    fn texts(&self, group: usize, column: usize) -> Result<Vec<String>, CacheError> {
        let texts = self.column::<ByteArrayType>(group, column)?;
        let texts = texts.iter().map(|bytes| {
            let text = bytes.as_utf8().map_err(|error| broken(&self.path, error))?;
            Ok(text.to_owned())
        });
        texts.collect()
    }

    /// Returns the subjects of a property, after checking that each is an individual.
    fn subjects(&self, group: usize, individuals: usize) -> Result<Vec<IndividualId>, CacheError> {
        let subjects = to_unsigned(self.column::<Int32Type>(group, 0)?);
        // Columns are searched by bisection, so they must be sorted.
        if !subjects.is_sorted()
            || subjects
                .last()
                .is_some_and(|&id| id as usize >= individuals)
        {
            let what = format!("row group {group}: the individuals are not sorted or do not exist");
            return Err(broken(&self.path, what));
        }
        Ok(subjects)
    }
}

/// Reads a catalogue from the files in a folder.
pub(crate) fn read(folder: &Path) -> Result<Catalogue, CacheError> {
    // Everything is read anyway, and a damaged table would falsify every answer, so all sums are checked.
    let path = folder.join(SUMS_FILE);
    if read_json::<BTreeMap<String, u32>>(&path)? != sums(folder)? {
        return Err(broken(
            &path,
            "the checksums do not match the files in this folder",
        ));
    }
    let path = folder.join(HEAD_FILE);
    let head: Head = read_json(&path)?;
    if head.schema != CACHE_SCHEMA {
        return Err(broken(&path, format!("schema {}", head.schema)));
    }
    let mut catalogue = Catalogue::default();
    read_episodes(folder, &head, &mut catalogue)?;
    read_individuals(folder, &head, &mut catalogue)?;
    let numbers = Input::open(folder, &NUMBERS)?;
    numbers.groups(head.numbers.len())?;
    for (group, &property) in head.numbers.iter().enumerate() {
        let subjects = numbers.subjects(group, head.individuals)?;
        let values = numbers.column::<DoubleType>(group, 1)?;
        at(&mut catalogue.values, property).0 = subjects.into_iter().zip(values).collect();
    }
    let texts = Input::open(folder, &TEXTS)?;
    texts.groups(head.texts.len())?;
    for (group, &property) in head.texts.iter().enumerate() {
        let subjects = texts.subjects(group, head.individuals)?;
        let values = texts.texts(group, 1)?;
        *at(&mut catalogue.texts, property) = subjects.into_iter().zip(values).collect();
    }
    let relations = Input::open(folder, &RELATIONS)?;
    relations.groups(head.relations.len())?;
    for (group, &property) in head.relations.iter().enumerate() {
        let subjects = relations.subjects(group, head.individuals)?;
        let objects = relations.column::<Int32Type>(group, 1)?;
        let nodes: Vec<CatalogueNode> = objects.into_iter().map(node_of).collect();
        let is_there = |node: &CatalogueNode| match *node {
            CatalogueNode::Individual(id) => (id as usize) < head.individuals,
            CatalogueNode::Shared(place) => (place as usize) < head.shared.len(),
        };
        if !nodes.iter().all(is_there) {
            let what = format!("row group {group}: an object does not exist");
            return Err(broken(&relations.path, what));
        }
        *at(&mut catalogue.relations, property) = subjects.into_iter().zip(nodes).collect();
    }
    catalogue.names.classes = intern(head.classes);
    catalogue.names.properties = intern(head.properties);
    catalogue.names.shared = intern(head.shared);
    Ok(catalogue)
}

fn read_episodes(folder: &Path, head: &Head, catalogue: &mut Catalogue) -> Result<(), CacheError> {
    let input = Input::open(folder, &EPISODES)?;
    input.groups(1)?;
    let ids = input.texts(0, 0)?;
    let tasks = input.texts(0, 1)?;
    let starts = input.column::<DoubleType>(0, 2)?;
    let ends = input.column::<DoubleType>(0, 3)?;
    let firsts = to_unsigned(input.column::<Int32Type>(0, 4)?);
    let lengths = to_unsigned(input.column::<Int32Type>(0, 5)?);
    let rounds = input.texts(0, 6)?;
    let mut next = 0;
    for (place, id) in ids.into_iter().enumerate() {
        if firsts[place] != next {
            return Err(broken(
                &input.path,
                format!("the individuals of episode {id} do not follow the previous episode's"),
            ));
        }
        next += lengths[place];
        catalogue.by_id.insert(id.clone(), place as u32);
        catalogue.episodes.push(EpisodeRow {
            task: tasks[place].clone(),
            interval: [starts[place], ends[place]],
            rounds: serde_json::from_str(&rounds[place])
                .map_err(|error| broken(&input.path, format!("rounds of {id}: {error}")))?,
            first: firsts[place],
            len: lengths[place],
            id,
        });
    }
    if next as usize != head.individuals {
        let what = format!("{next} individuals; expected {}", head.individuals);
        return Err(broken(&input.path, what));
    }
    Ok(())
}

fn read_individuals(
    folder: &Path,
    head: &Head,
    catalogue: &mut Catalogue,
) -> Result<(), CacheError> {
    let input = Input::open(folder, &INDIVIDUALS)?;
    input.groups(1)?;
    let classes = input.column::<Int32Type>(0, 0)?;
    catalogue.starts = input.column::<DoubleType>(0, 1)?;
    catalogue.ends = input.column::<DoubleType>(0, 2)?;
    catalogue.parents = to_unsigned(input.column::<Int32Type>(0, 3)?);
    let count = head.individuals;
    let is_class = |&class: &i32| usize::try_from(class).is_ok_and(|c| c < head.classes.len());
    // A parent precedes its parts, so there are no cycles.
    let is_parent = |(id, &parent): (usize, &u32)| parent == NONE || (parent as usize) < id;
    if classes.len() != count
        || !classes.iter().all(is_class)
        || !catalogue.parents.iter().enumerate().all(is_parent)
    {
        return Err(broken(
            &input.path,
            "a class or parent of an individual does not exist",
        ));
    }
    for (id, &class) in (0..).zip(&classes) {
        at(&mut catalogue.of_class, class as u32).push(id);
    }
    catalogue.classes = classes.into_iter().map(|class| class as u16).collect();
    Ok(())
}

fn intern(names: Vec<String>) -> Interned {
    let numbers: HashMap<String, u32> = names.iter().cloned().zip(0..).collect();
    Interned { names, numbers }
}

fn subjects<T>(column: &[(IndividualId, T)]) -> Vec<i32> {
    column.iter().map(|(id, _)| *id as i32).collect()
}

/// Reinterprets the bits as signed: Parquet has no unsigned integers.
fn to_signed(numbers: &[u32]) -> Vec<i32> {
    numbers.iter().map(|&number| number as i32).collect()
}

fn to_unsigned(numbers: Vec<i32>) -> Vec<u32> {
    numbers.into_iter().map(|number| number as u32).collect()
}

fn code_of(node: CatalogueNode) -> i32 {
    match node {
        CatalogueNode::Individual(id) => id as i32,
        CatalogueNode::Shared(place) => -1 - place as i32,
    }
}

fn node_of(code: i32) -> CatalogueNode {
    match u32::try_from(code) {
        Ok(id) => CatalogueNode::Individual(id),
        Err(_) => CatalogueNode::Shared(-(code + 1) as u32),
    }
}

fn broken(path: &Path, what: impl std::fmt::Display) -> CacheError {
    CacheError::Broken {
        path: path.to_path_buf(),
        what: what.to_string(),
    }
}
