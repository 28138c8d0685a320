//! Writer of a NEEM: document by document, complete or not at all.

use super::document::Closures;
use super::dump::MAX_DOCUMENT;
use super::meta::NeemMeta;
use super::triples::{self, Triple, individual};
use super::{NeemError, OBSERVATIONS, at, collection_file};
use crate::ontology::{Ontology, SEMCO_OWL};
use crate::record::{EpisodeRecord, Individual};
use bson::oid::ObjectId;
use bson::raw::cstr;
use bson::{DateTime, RawDocumentBuf, rawdoc};
use std::collections::{HashMap, HashSet};
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use wisch::geometry::Pose;

/// Settings of the writer of a NEEM.
#[derive(Debug, Clone, PartialEq)]
pub struct NeemConfig {
    /// Rate of each frame's poses \[Hz\]; infinite for every sample.
    ///
    /// Poses need much space: 30 frames at 1 kHz are 29 GB per hour.
    pub tf_rate_hz: f64,
}

impl Default for NeemConfig {
    fn default() -> Self {
        // Enough to show a motion; detected events are in the triples.
        Self { tf_rate_hz: 10.0 }
    }
}

/// Pose of a frame at a time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrameSample<'a> {
    /// Time [s since 1970]. In an episode, samples of a frame must be in order of their times.
    pub time: f64,
    /// Name of the frame: for an object, the local name of its IRI, for example `sponge`.
    pub frame: &'a str,
    /// Name of the frame in which the pose is stated.
    pub parent: &'a str,
    /// The pose.
    pub parent_from_frame: Pose,
}

/// A wrench at one time, stated in a frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WrenchSample<'a> {
    /// Time [s since 1970].
    pub time: f64,
    /// Name of the frame in which the wrench is stated, as in the poses.
    pub frame: &'a str,
    /// Name of the episode: times of two episodes may overlap.
    pub episode: &'a str,
    /// Name of the topic, which states the quantity.
    pub topic: &'a str,
    /// Force \[N\].
    pub force: [f64; 3],
    /// Torque about the frame's origin [N m], if measured.
    pub torque: Option<[f64; 3]>,
}

/// Numbers of the documents that were written, by kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct NeemReport {
    /// Episodes.
    pub episodes: u64,
    /// Triples.
    pub triples: u64,
    /// Comments.
    pub annotations: u64,
    /// Poses.
    pub poses: u64,
    /// Wrenches.
    pub wrenches: u64,
    /// Samples whose external wrench is left out, because its driver states that it is not usable.
    pub unusable_wrenches: u64,
    /// Camera observations.
    pub observations: u64,
}

/// Writer of episodes into the folder of a NEEM, which appears at its path when it is finished.
///
/// The writer keeps only the last time of each frame in memory, not the poses and wrenches.
///
/// ```no_run
/// use std::path::Path;
/// use wisch_memory::neem::{NeemConfig, NeemMeta, NeemWriter};
/// use wisch_memory::EpisodeRecord;
/// use wisch_memory::neem::NeemError;
///
/// fn export(records: &[EpisodeRecord], meta: &NeemMeta) -> Result<u64, NeemError> {
///     let mut neem = NeemWriter::create(Path::new("crumbs"), meta, &NeemConfig::default())?;
///     for record in records {
///         neem.episode(record)?;
///     }
///     Ok(neem.finish()?.triples)
/// }
/// ```
#[derive(Debug)]
pub struct NeemWriter {
    target: PathBuf,
    /// Temporary folder, removed with its contents if the NEEM is not finished.
    staging: tempfile::TempDir,
    triples: Collection,
    annotations: Collection,
    inferred: Collection,
    poses: Collection,
    wrenches: Collection,
    pub(super) observations: Collection,
    pub(super) unusable_wrenches: u64,
    closures: Closures,
    episodes: HashSet<String>,
    frames: HashMap<String, Frame>,
    /// Least time between two poses of a frame [s].
    period: f64,
}

/// State of a frame.
#[derive(Debug)]
struct Frame {
    last: f64,
    written: i64,
}

/// Share of the period by which a sample may be early and still be written [1].
const EARLY: f64 = 1e-3;

impl NeemWriter {
    /// Begins a NEEM at the folder `target`, which must not exist.
    ///
    /// # Errors
    /// If the target exists, cannot be written, or the rate is not above 0.
    pub fn create(target: &Path, meta: &NeemMeta, config: &NeemConfig) -> Result<Self, NeemError> {
        let rate = config.tf_rate_hz;
        if rate.is_nan() || rate <= 0.0 {
            return Err(NeemError::Rate { rate });
        }
        if target.exists() {
            return Err(NeemError::Exists {
                path: target.to_owned(),
            });
        }
        let beside = match target.parent() {
            Some(parent) if !parent.as_os_str().is_empty() => parent,
            _ => Path::new("."),
        };
        fs::create_dir_all(beside).map_err(at(beside))?;
        let staging = tempfile::tempdir_in(beside).map_err(at(beside))?;
        let folder = staging.path().join(STAGED);
        let seconds = meta.created_at.max(0.0) as u32;
        let collection = |name| Collection::create(&folder, name, seconds);
        let mut writer = Self {
            target: target.to_owned(),
            triples: collection("triples")?,
            annotations: collection("annotations")?,
            inferred: collection("inferred")?,
            poses: collection("tf")?,
            wrenches: collection("wrench")?,
            observations: collection(OBSERVATIONS)?,
            unusable_wrenches: 0,
            closures: Closures::default(),
            episodes: HashSet::new(),
            frames: HashMap::new(),
            period: 1.0 / rate,
            staging,
        };
        let id = ObjectIds::new(&meta.name, seconds).next();
        write_file(&folder.join("meta.json"), &meta.json(id))?;
        write_file(&folder.join("semco.owl"), SEMCO_OWL)?;
        writer.ontology()?;
        Ok(writer)
    }

    fn ontology(&mut self) -> Result<(), NeemError> {
        for triple in triples::ontology_triples()? {
            self.triple(&triple)?;
        }
        let ontology = Ontology::load();
        for (name, term) in ontology.terms() {
            if !term.comment.is_empty() {
                self.annotation(name, &term.comment)?;
            }
        }
        Ok(())
    }

    /// Writes the triples of an episode.
    ///
    /// # Errors
    /// If the record is faulty or was written before, or writing fails.
    pub fn episode(&mut self, record: &EpisodeRecord) -> Result<(), NeemError> {
        if self.episodes.contains(&record.id) {
            return Err(NeemError::Twice {
                episode: record.id.clone(),
            });
        }
        let triples = triples::triples(record)?;
        // An episode need not be later than the previous one.
        for frame in self.frames.values_mut() {
            frame.last = f64::NEG_INFINITY;
        }
        self.episodes.insert(record.id.clone());
        for triple in triples {
            self.triple(&triple)?;
        }
        if !record.individuals.is_empty() {
            self.annotation(&individual(record, 0), &describe_episode(record))?;
        }
        Ok(())
    }

    fn triple(&mut self, triple: &Triple) -> Result<(), NeemError> {
        let id = self.triples.ids.next();
        let document = self.closures.document(id, triple)?;
        self.triples.write(&document)
    }

    fn annotation(&mut self, name: &str, comment: &str) -> Result<(), NeemError> {
        let document = rawdoc! {
            "_id": self.annotations.ids.next(),
            "s": triples::iri(name)?,
            "p": triples::iri("rdfs:comment")?,
            "v": comment,
        };
        self.annotations.write(&document)
    }

    /// Writes the pose of a frame, unless the frame's previous pose is less than a period ago.
    ///
    /// # Errors
    /// If a number is not finite, or writing fails.
    pub fn frame(&mut self, sample: &FrameSample) -> Result<(), NeemError> {
        let pose = &sample.parent_from_frame;
        let [x, y, z] = [0, 1, 2].map(|axis| pose.translation.vector[axis]);
        let rotation = [0, 1, 2, 3].map(|axis| pose.rotation.coords[axis]);
        let numbers = [sample.time, x, y, z].into_iter().chain(rotation);
        check_finite(sample.frame, sample.time, numbers)?;
        let Some(seq) = self.due(sample.frame, sample.time) else {
            return Ok(());
        };
        let [i, j, k, w] = rotation;
        let document = rawdoc! {
            "_id": self.poses.ids.next(),
            "header": { "seq": seq, "stamp": date(sample.time), "frame_id": sample.parent },
            "child_frame_id": sample.frame,
            "transform": {
                "translation": xyz([x, y, z]),
                "rotation": { "x": i, "y": j, "z": k, "w": w },
            },
            "__recorded": date(sample.time),
            "__topic": "tf",
        };
        self.poses.write(&document)
    }

    /// Least time between two written poses of a frame [s].
    pub(super) fn shortest_period(&self) -> f64 {
        self.period * (1.0 - EARLY)
    }

    /// Returns the number of the frame's sample if it is due, and then stores its time.
    fn due(&mut self, name: &str, time: f64) -> Option<i64> {
        let shortest = self.shortest_period();
        match self.frames.get_mut(name) {
            Some(frame) if time - frame.last < shortest => None,
            Some(frame) => {
                frame.last = time;
                frame.written += 1;
                Some(frame.written)
            }
            None => {
                let first = Frame {
                    last: time,
                    written: 0,
                };
                self.frames.insert(name.to_owned(), first);
                Some(0)
            }
        }
    }

    /// Writes a wrench sample as a document.
    ///
    /// # Errors
    /// If a number is not finite, or writing fails.
    pub fn wrench(&mut self, sample: &WrenchSample) -> Result<(), NeemError> {
        let torque = sample.torque.into_iter().flatten();
        let numbers = sample.force.into_iter().chain(torque);
        check_finite(sample.frame, sample.time, numbers.chain([sample.time]))?;
        let mut wrench = rawdoc! { "force": xyz(sample.force) };
        if let Some(torque) = sample.torque {
            wrench.append(cstr!("torque"), xyz(torque));
        }
        let document = rawdoc! {
            "_id": self.wrenches.ids.next(),
            "header": {
                "stamp": date(sample.time),
                // BSON dates resolve milliseconds only; telemetry is finer.
                "time": sample.time,
                "frame_id": sample.frame,
            },
            "episode": sample.episode,
            "wrench": wrench,
            "__recorded": date(sample.time),
            "__topic": sample.topic,
        };
        self.wrenches.write(&document)
    }

    /// Finishes the NEEM and moves it to its path.
    ///
    /// # Errors
    /// If writing fails, or the path exists meanwhile.
    pub fn finish(self) -> Result<NeemReport, NeemError> {
        let report = NeemReport {
            episodes: self.episodes.len() as u64,
            triples: self.triples.written,
            annotations: self.annotations.written,
            poses: self.poses.written,
            wrenches: self.wrenches.written,
            unusable_wrenches: self.unusable_wrenches,
            observations: self.observations.written,
        };
        for collection in [
            self.triples,
            self.annotations,
            self.inferred,
            self.poses,
            self.wrenches,
            self.observations,
        ] {
            collection.finish()?;
        }
        if self.target.exists() {
            return Err(NeemError::Exists { path: self.target });
        }
        let staged = self.staging.path().join(STAGED);
        fs::rename(&staged, &self.target).map_err(at(&self.target))?;
        Ok(report)
    }
}

/// Name of the folder during writing. It lies inside the temporary folder, so that it gets normal permissions.
const STAGED: &str = "neem";

/// A file of documents.
#[derive(Debug)]
pub(super) struct Collection {
    path: PathBuf,
    file: BufWriter<File>,
    pub ids: ObjectIds,
    written: u64,
}

impl Collection {
    fn create(neem: &Path, name: &'static str, seconds: u32) -> Result<Self, NeemError> {
        let path = collection_file(neem, name);
        let folder = path.parent().unwrap_or(neem);
        fs::create_dir_all(folder).map_err(at(folder))?;
        let metadata = serde_json::json!({
            "options": {},
            "indexes": [{"v": 2, "key": {"_id": 1}, "name": "_id_", "ns": format!("roslog.{name}")}],
            "collectionName": name,
            "type": "collection",
        });
        let beside = folder.join(format!("{name}.metadata.json"));
        write_file(&beside, &metadata.to_string())?;
        let file = File::create_new(&path).map_err(at(&path))?;
        Ok(Self {
            file: BufWriter::new(file),
            ids: ObjectIds::new(name, seconds),
            written: 0,
            path,
        })
    }

    pub fn write(&mut self, document: &RawDocumentBuf) -> Result<(), NeemError> {
        let bytes = document.as_bytes();
        let written = if bytes.len() > MAX_DOCUMENT {
            let message = format!("a document of {} bytes is too long", bytes.len());
            Err(io::Error::new(io::ErrorKind::InvalidInput, message))
        } else {
            self.file.write_all(bytes)
        };
        written.map_err(at(&self.path))?;
        self.written += 1;
        Ok(())
    }

    fn finish(mut self) -> Result<(), NeemError> {
        self.file.flush().map_err(at(&self.path))?;
        self.file.get_ref().sync_all().map_err(at(&self.path))
    }
}

/// Generator of document identifiers: the same export gets the same identifiers.
#[derive(Debug)]
pub(super) struct ObjectIds {
    head: [u8; 7],
    next: u64,
}

impl ObjectIds {
    fn new(of: &str, seconds: u32) -> Self {
        // FNV-1a, 32 bit, of which three bytes are used.
        let hash = of.bytes().fold(0x811c_9dc5_u32, |hash, byte| {
            (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193)
        });
        let [a, b, c, d] = seconds.to_be_bytes();
        let [e, f, g, _] = hash.to_be_bytes();
        Self {
            head: [a, b, c, d, e, f, g],
            next: 0,
        }
    }

    pub fn next(&mut self) -> ObjectId {
        let mut id = [0; 12];
        id[..7].copy_from_slice(&self.head);
        id[7..].copy_from_slice(&self.next.to_be_bytes()[3..]);
        self.next += 1;
        ObjectId::from_bytes(id)
    }
}

/// Describes an episode in a sentence.
fn describe_episode(record: &EpisodeRecord) -> String {
    if record.is_of_goal() {
        let is_step = |individual: &&Individual| individual.values.contains_key("semco:step");
        let steps = record.individuals.iter().filter(is_step).count();
        let plural = if steps == 1 { "" } else { "s" };
        return format!(
            "Goal of several parts of the task {} in {steps} step{plural}.",
            record.task
        );
    }
    let mut text = format!("Wiping task {}", record.task);
    let rounds = record.rounds.len();
    text += &format!(" in {rounds} round{}", if rounds == 1 { "" } else { "s" });
    let action = record
        .individuals
        .iter()
        .find(|individual| individual.class == "semco:WipingAction");
    if let Some(performance) = action.and_then(Individual::performance) {
        text += &format!(", estimated performance {:.1} %", 100.0 * performance);
    }
    text + "."
}

pub(super) fn xyz([x, y, z]: [f64; 3]) -> RawDocumentBuf {
    rawdoc! { "x": x, "y": y, "z": z }
}

pub(super) fn date(time: f64) -> DateTime {
    DateTime::from_millis((1e3 * time).round() as i64)
}

pub(super) fn check_finite(
    frame: &str,
    time: f64,
    numbers: impl IntoIterator<Item = f64>,
) -> Result<(), NeemError> {
    if numbers.into_iter().all(f64::is_finite) {
        return Ok(());
    }
    Err(NeemError::Sample {
        frame: frame.to_owned(),
        time,
    })
}

fn write_file(path: &Path, text: &str) -> Result<(), NeemError> {
    fs::write(path, text).map_err(at(path))
}
