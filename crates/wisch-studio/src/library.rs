//! The memory's episodes, for the page's list.

use crate::refusal::Refusal;
use flate2::read::GzDecoder;
use serde::Serialize;
use serde_json::Value;
use std::collections::HashMap;
use std::fs::File;
use std::io::{BufRead, BufReader, Read as _};
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};
use wisch_memory::catalogue::{EpisodeRow, entries};
use wisch_memory::{Catalogue, CatalogueNode, IndividualId, Memory, MemoryError, RECORDING_FILE};

/// Largest number of listed episodes.
pub const MOST_LISTED: usize = 500;
/// Classes of the events that the page draws for each episode, without prefix.
const DRAWN_EVENTS: [&str; 5] = [
    "HumanCollision",
    "HandGuiding",
    "ContactLoss",
    "Overload",
    "ProtectiveStop",
];
/// Endings of rounds that it draws too, with the classes by which they are listed.
const DRAWN_ENDINGS: [(&str, &str); 2] = [("stopped", "Stopped"), ("ended early", "EndedEarly")];
/// Events of a class with a shorter pause between them are listed as one: a share of the episode's duration [1].
const MERGED_SHARE: f64 = 0.01;

/// Largest size of a decompressed recording that is searched for its ending [bytes].
const MOST_UNPACKED: u64 = 1 << 28;

/// The memory, with its last catalogue and the endings of runs as caches.
#[derive(Debug)]
pub struct Library {
    memory: Memory,
    last: Mutex<Option<Read>>,
    /// How runs ended, by episode; see [`Listed::badge`].
    endings: Mutex<HashMap<String, Option<String>>>,
}

/// A catalogue of these episodes.
#[derive(Debug, Clone)]
struct Read {
    ids: Vec<String>,
    catalogue: Arc<Catalogue>,
}

/// Summary of an episode.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Listed {
    id: String,
    title: String,
    /// Name of the action, for example "Collecting".
    action: Option<String>,
    tool: Option<String>,
    medium: Option<String>,
    surface: Option<String>,
    /// Start of the episode [s since 1970].
    begun: f64,
    seconds: f64,
    rounds: usize,
    /// Final estimate of the performance: mean, and both ends of the 90 % interval.
    performance: Option<f64>,
    low: Option<f64>,
    high: Option<f64>,
    met: bool,
    /// Verdict on its last round, for example "goal met".
    verdict: Option<String>,
    /// How the run ended, for example "not met: no rounds left", as the recording of a missed goal states it.
    badge: Option<String>,
    /// Target performance [1].
    target: Option<f64>,
    /// Begins of the rounds [s since the episode began].
    round_starts: Vec<f64>,
    events: Vec<ListedEvent>,
    has_recording: bool,
}

/// Events of a class that follow each other closely.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct ListedEvent {
    class: &'static str,
    /// Begin and end [s since the episode began].
    start: f64,
    end: f64,
    count: usize,
}

/// List of episodes, newest first.
#[derive(Debug, Serialize)]
pub struct List {
    episodes: Vec<Listed>,
    /// Number of matching episodes, listed or not.
    total: usize,
    /// Episodes that cannot be read, with the reason.
    broken: Vec<String>,
}

impl Library {
    pub fn new(memory: Memory) -> Self {
        Self {
            memory,
            last: Mutex::default(),
            endings: Mutex::default(),
        }
    }

    pub fn memory(&self) -> &Memory {
        &self.memory
    }

    /// Returns the catalogue of the present episodes.
    pub fn catalogue(&self) -> Result<Arc<Catalogue>, MemoryError> {
        let ids = self.memory.episodes()?;
        let mut last = self.last.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(read) = last.as_ref()
            && read.ids == ids
        {
            return Ok(Arc::clone(&read.catalogue));
        }
        let catalogue = Arc::new(self.memory.catalogue()?);
        *last = Some(Read {
            ids,
            catalogue: Arc::clone(&catalogue),
        });
        Ok(catalogue)
    }

    /// Returns the newest episodes whose name, task, action, tool, medium or surface contain all words.
    pub fn list(&self, wanted: &str) -> Result<List, Refusal> {
        let catalogue = self.catalogue()?;
        let words: Vec<String> = wanted.split_whitespace().map(str::to_lowercase).collect();
        let about = About::of(&catalogue);
        let mut rows: Vec<&EpisodeRow> = catalogue.episodes().iter().collect();
        rows.sort_by(|a, b| {
            let times = b.interval[0].total_cmp(&a.interval[0]);
            times.then_with(|| b.id.cmp(&a.id))
        });
        let mut list = List {
            episodes: Vec::new(),
            total: 0,
            broken: catalogue.omitted_episodes().to_vec(),
        };
        for row in rows {
            let is_wanted = words.is_empty() || {
                let text = about.text(row).to_lowercase();
                words.iter().all(|word| text.contains(word))
            };
            if !is_wanted {
                continue;
            }
            list.total += 1;
            if list.episodes.len() < MOST_LISTED {
                let mut listed = about.summarise(row);
                let recording = self.memory.folder().join(&row.id).join(RECORDING_FILE);
                listed.has_recording = recording.is_file();
                if listed.has_recording && !listed.met {
                    listed.badge = self.ending(&row.id, &recording);
                }
                list.episodes.push(listed);
            }
        }
        Ok(list)
    }

    /// Returns how a run ended. Each recording is read once.
    fn ending(&self, id: &str, recording: &Path) -> Option<String> {
        let mut endings = self.endings.lock().unwrap_or_else(PoisonError::into_inner);
        let ending = endings.entry(id.to_owned());
        ending.or_insert_with(|| read_ending(recording)).clone()
    }
}

/// Returns the badge in the last piece of a recording, which is compressed by gzip.
fn read_ending(recording: &Path) -> Option<String> {
    let unpacked = GzDecoder::new(File::open(recording).ok()?).take(MOST_UNPACKED);
    let lines = BufReader::new(unpacked).split(b'\n').map_while(Result::ok);
    let piece: Value = serde_json::from_slice(&lines.last()?).ok()?;
    piece["badge"].as_str().map(str::to_owned)
}

/// Summaries of the wiping actions, by episode.
struct About<'a> {
    catalogue: &'a Catalogue,
    /// Wiping action of each episode, by the episode's first individual.
    actions: HashMap<IndividualId, IndividualId>,
    events: HashMap<IndividualId, Vec<ListedEvent>>,
    /// Verdict on the last round, by the episode's first individual.
    verdicts: HashMap<IndividualId, &'a str>,
}

impl<'a> About<'a> {
    fn of(catalogue: &'a Catalogue) -> Self {
        let first = |id: IndividualId| catalogue.episode_of(id).first;
        let of_class = |class| catalogue.individuals_of_class(class).iter();
        let actions = of_class("semco:WipingAction").chain(of_class("semco:GoalAction"));
        let verdicts = catalogue.texts("semco:verdict").iter();
        Self {
            catalogue,
            actions: actions.map(|&id| (first(id), id)).collect(),
            events: find_events(catalogue),
            // Rounds are in order, so the last one remains.
            verdicts: verdicts
                .map(|(id, text)| (first(*id), text.as_str()))
                .collect(),
        }
    }

    fn summarise(&self, row: &EpisodeRow) -> Listed {
        let action = self.actions.get(&row.first).copied();
        let number = |property: &str| {
            let found = entries(self.catalogue.numbers(property), action?);
            found.first().map(|(_, value)| *value)
        };
        let shared = |property: &str| self.shared(property, action?);
        Listed {
            id: row.id.clone(),
            title: row.task.clone(),
            action: action.and_then(|action| self.task(action)),
            tool: shared("semco:usesTool"),
            medium: shared("semco:removesMedium"),
            surface: shared("semco:actsOnSurface"),
            begun: row.interval[0],
            seconds: row.interval[1] - row.interval[0],
            rounds: row.rounds.len(),
            performance: number("semco:performance"),
            low: number("semco:performanceLow"),
            high: number("semco:performanceHigh"),
            met: shared("soma:hasExecutionState").as_deref() == Some("ExecutionState_Succeeded"),
            verdict: (self.verdicts.get(&row.first)).map(|verdict| (*verdict).to_owned()),
            badge: None,
            target: number("semco:target"),
            round_starts: (row.rounds.iter())
                .map(|start| start - row.interval[0])
                .collect(),
            events: self.events.get(&row.first).cloned().unwrap_or_default(),
            has_recording: false,
        }
    }

    /// Returns the text of an episode that is searched.
    fn text(&self, row: &EpisodeRow) -> String {
        let about = self.summarise(row);
        let parts = [about.action, about.tool, about.medium, about.surface];
        let parts = parts.into_iter().flatten();
        let words: Vec<String> = [about.id, about.title].into_iter().chain(parts).collect();
        words.join(" ")
    }

    /// Returns the object of an individual's relation, without prefix, if episodes share it.
    fn shared(&self, property: &str, id: IndividualId) -> Option<String> {
        let related = entries(self.catalogue.relations(property), id);
        related.iter().find_map(|(_, node)| match node {
            CatalogueNode::Shared(place) => {
                let name = self.catalogue.shared_individuals().get(*place as usize)?;
                Some(local(name).to_owned())
            }
            CatalogueNode::Individual(_) => None,
        })
    }

    /// Returns the class of the task that an action executes.
    fn task(&self, action: IndividualId) -> Option<String> {
        let related = entries(self.catalogue.relations("dul:executesTask"), action);
        related.iter().find_map(|(_, node)| match node {
            CatalogueNode::Individual(id) => Some(local(self.catalogue.class(*id)).to_owned()),
            CatalogueNode::Shared(_) => None,
        })
    }
}

/// Returns the drawn events by the first individual of their episode.
fn find_events(catalogue: &Catalogue) -> HashMap<IndividualId, Vec<ListedEvent>> {
    let events = DRAWN_EVENTS.iter().flat_map(|&class| {
        let ids = catalogue.individuals_of_class(&format!("semco:{class}"));
        ids.iter()
            .filter_map(move |&id| Some((class, id, catalogue.interval(id)?)))
    });
    let endings = catalogue.texts("semco:ending").iter();
    let endings = endings.filter_map(|(id, text)| {
        let (_, class) = DRAWN_ENDINGS.iter().find(|(ending, _)| ending == text)?;
        let [_, end] = catalogue.interval(*id)?;
        Some((*class, *id, [end, end]))
    });
    let mut found: HashMap<IndividualId, Vec<ListedEvent>> = HashMap::new();
    for (class, id, [start, end]) in events.chain(endings) {
        let episode = catalogue.episode_of(id);
        let [begin, last] = episode.interval;
        let pause = MERGED_SHARE * (last - begin);
        let listed = found.entry(episode.first).or_default();
        match listed.last_mut() {
            // The individuals of a class are in order of time.
            Some(before) if before.class == class && start - begin <= before.end + pause => {
                before.end = before.end.max(end - begin);
                before.count += 1;
            }
            _ => listed.push(ListedEvent {
                class,
                start: start - begin,
                end: end - begin,
                count: 1,
            }),
        }
    }
    found
}

/// Returns a name without its prefix.
fn local(name: &str) -> &str {
    name.split_once(':').map_or(name, |(_, local)| local)
}
