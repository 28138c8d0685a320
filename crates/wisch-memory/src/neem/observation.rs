//! Camera observations as documents of a collection of the NEEM.

use super::document::number;
use super::dump::Documents;
use super::writer::{NeemWriter, check_finite, date, xyz};
use super::{NeemError, OBSERVATIONS, at, collection_file};
use crate::observations::{RoundObservations, pose};
use bson::raw::{CStr, RawArrayBuf, cstr};
use bson::{RawDocument, RawDocumentBuf, rawdoc};
use std::collections::BTreeMap;
use std::fs::File;
use std::io::{self, BufReader};
use std::path::Path;
use wisch::geometry::{Point2, Polygon, Pose, Region};
use wisch::represent::Observation;

/// Topics of the observations before and after a round.
const TOPICS: [&str; 2] = ["dirt_before", "dirt_after"];

/// The round to which observations belong.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NeemRound<'a> {
    /// Name of the episode.
    pub episode: &'a str,
    /// Number of the round in the episode, from 1.
    pub number: usize,
    /// Begin and end of the round [s since 1970].
    pub interval: [f64; 2],
    /// Name of the surface.
    pub surface: &'a str,
}

impl NeemWriter {
    /// Writes the observations before and after a round, one document each.
    ///
    /// # Errors
    /// If a number is not finite, or writing fails.
    pub fn observations(
        &mut self,
        of: &NeemRound<'_>,
        seen: &RoundObservations,
    ) -> Result<(), NeemError> {
        seen.check().map_err(|fault| NeemError::Observations {
            episode: of.episode.to_owned(),
            round: of.number,
            fault,
        })?;
        let looks = TOPICS.iter().zip(of.interval).zip(&seen.observations);
        for ((topic, time), observation) in looks {
            let Some(observation) = observation else {
                continue;
            };
            check_finite(of.surface, time, [time])?;
            let surface = &seen.world_from_surface;
            let [i, j, k, w] = [0, 1, 2, 3].map(|axis| surface.rotation.coords[axis]);
            let hidden = observation.hidden.polygons().iter();
            let hidden: RawArrayBuf = hidden
                .map(|part| part.rings().map(coordinates).collect::<RawArrayBuf>())
                .collect();
            let mut document = rawdoc! {
                "_id": self.observations.ids.next(),
                // BSON dates resolve milliseconds only.
                "header": { "stamp": date(time), "time": time, "frame_id": of.surface },
                "episode": of.episode,
                "round": of.number as i64,
                "world_from_surface": {
                    "translation": xyz(surface.translation.vector.into()),
                    "rotation": { "x": i, "y": j, "z": k, "w": w },
                },
                "detections": coordinates(&observation.detections),
                "hidden": hidden,
                "__recorded": date(time),
                "__topic": *topic,
            };
            if let Some(round) = seen.round {
                document.append(cstr!("round_of_run"), round as i64);
            }
            self.observations.write(&document)?;
        }
        Ok(())
    }
}

/// Converts points to two lists of coordinates [m].
fn coordinates(places: &[Point2]) -> RawDocumentBuf {
    let list = |axis: usize| places.iter().map(|p| p[axis]).collect::<RawArrayBuf>();
    rawdoc! { "x": list(0), "y": list(1) }
}

/// Returns the observations in a NEEM, by the episode's name and the number of the round in it.
///
/// They equal the written ones, bit for bit. A NEEM without this collection has no observations.
///
/// # Errors
/// If the NEEM cannot be read, or a document in the collection is not an observation.
pub fn observations(
    neem: &Path,
) -> Result<BTreeMap<String, BTreeMap<usize, RoundObservations>>, NeemError> {
    let path = collection_file(neem, OBSERVATIONS);
    let mut episodes = BTreeMap::<String, BTreeMap<usize, RoundObservations>>::new();
    let file = match File::open(&path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(episodes),
        opened => opened.map_err(at(&path))?,
    };
    for (number, document) in (0..).zip(Documents::new(BufReader::new(file))) {
        let document = document.map_err(|error| NeemError::Dump {
            path: path.clone(),
            error,
        })?;
        let fault = |what| NeemError::Observation {
            path: path.clone(),
            number,
            what,
        };
        let look = ObservationDocument::of(&document).map_err(fault)?;
        let rounds = episodes.entry(look.episode).or_default();
        let seen = rounds.entry(look.round).or_insert(RoundObservations {
            round: look.round_of_run,
            world_from_surface: look.world_from_surface,
            observations: [None, None],
        });
        if (seen.round, seen.world_from_surface) != (look.round_of_run, look.world_from_surface) {
            return Err(fault(
                "the other observation of its round has another surface",
            ));
        }
        let place = &mut seen.observations[look.place];
        if place.replace(look.observation).is_some() {
            return Err(fault("its round already has this observation"));
        }
        seen.check()
            .map_err(|_| fault("a number is not finite, or the quaternion is not a rotation"))?;
    }
    Ok(episodes)
}

/// Contents of a document.
struct ObservationDocument {
    episode: String,
    round: usize,
    round_of_run: Option<usize>,
    world_from_surface: Pose,
    /// 0 before the round, 1 after it.
    place: usize,
    observation: Observation,
}

impl ObservationDocument {
    fn of(document: &RawDocument) -> Result<Self, &'static str> {
        let surface = document.get_document("world_from_surface");
        let surface = surface.map_err(|_| "it has no world_from_surface")?;
        let part = |of: &str, axis: &str| number(surface.get_document(of).ok()?, axis);
        let [x, y, z] = ["x", "y", "z"].map(|axis| part("translation", axis));
        let [i, j, k, w] = ["x", "y", "z", "w"].map(|axis| part("rotation", axis));
        let world_from_surface = (|| Some(pose([x?, y?, z?], [i?, j?, k?, w?])))();
        let topic = document.get_str("__topic").ok();
        let place = topic.and_then(|topic| TOPICS.iter().position(|known| *known == topic));
        let episode = document.get_str("episode");
        Ok(Self {
            episode: episode.map_err(|_| "it has no episode")?.to_owned(),
            round: count(document, cstr!("round")).ok_or("round is not a number from 1")?,
            round_of_run: match document.get("round_of_run") {
                Ok(None) => None,
                _ => Some(
                    count(document, cstr!("round_of_run"))
                        .ok_or("round_of_run is not a number from 1")?,
                ),
            },
            world_from_surface: world_from_surface.ok_or("world_from_surface is not a pose")?,
            place: place.ok_or("__topic is neither dirt_before nor dirt_after")?,
            observation: Observation {
                detections: (document.get_document("detections").ok().and_then(places))
                    .ok_or("detections are not lists x and y of numbers")?,
                hidden: hidden(document).ok_or("hidden is not a list of polygons")?,
            },
        })
    }
}

fn count(document: &RawDocument, field: &CStr) -> Option<usize> {
    let number = document.get_i64(field.as_str()).ok()?;
    usize::try_from(number).ok().filter(|number| *number > 0)
}

fn hidden(document: &RawDocument) -> Option<Region> {
    let mut polygons = Vec::new();
    for polygon in document.get_array("hidden").ok()? {
        let rings = polygon.ok()?.as_array()?.into_iter();
        let rings = rings.map(|ring| places(ring.ok()?.as_document()?));
        let mut rings = rings.collect::<Option<Vec<_>>>()?.into_iter();
        let outer = rings.next().unwrap_or_default();
        polygons.push(Polygon::new(outer, rings.collect()));
    }
    Some(Region::new(polygons))
}

fn places(document: &RawDocument) -> Option<Vec<Point2>> {
    let list = |axis: &str| -> Option<Vec<f64>> {
        let values = document.get_array(axis).ok()?.into_iter();
        values.map(|value| value.ok()?.as_f64()).collect()
    };
    let (x, y) = (list("x")?, list("y")?);
    let pairs = x.iter().zip(&y).map(|(&x, &y)| Point2::new(x, y));
    (x.len() == y.len()).then(|| pairs.collect())
}
