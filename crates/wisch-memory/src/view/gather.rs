//! Collection of a view's data from the memory.

use super::posed::{figure, line, local, place};
use super::{
    DirtState, Emphasis, Occurrence, ShownBody, ShownDirt, ShownEpisode, ShownRound, Track, View,
    ViewCommand, ViewError, ViewRequest, ViewSubject, ViewTime,
};
use crate::ask::{Term, tool_of};
use crate::catalogue::{Catalogue, CatalogueNode, EpisodeRow, IndividualId, entries};
use crate::frames::{FrameError, Frames, Sampling};
use crate::ontology::Ontology;
use crate::store::Memory;
use crate::telemetry::Telemetry;
use std::collections::HashMap;
use std::rc::Rc;
use wisch::geometry::Point2;
use wisch::robot::RobotModel;

/// Largest number of poses in a view.
pub const MAX_POSES: usize = 64;
/// Largest number of trajectories in a view.
const MAX_TRACKS: usize = 200;
/// Largest number of rounds that are shown in space.
const MAX_ROUNDS: usize = 24;
/// Largest number of episodes that are shown over time.
const MAX_EPISODES: usize = 12;
/// Number of poses over an interval, if a query states no period.
const POSES_OF_INTERVAL: usize = 5;

/// Collects the data for a query's commands `views`. `rows` are the query's answers, whose events
/// are shown over time.
///
/// What the memory lacks, for example a thing that an episode did not use, becomes a remark.
///
/// # Errors
/// If a term is not a command.
pub fn gather(
    views: &[Term],
    rows: &[Vec<Term>],
    memory: &Memory,
    catalogue: &Catalogue,
) -> Result<View, ViewError> {
    let mut gathering = Gathering {
        memory,
        catalogue,
        view: View::default(),
        opened: Vec::new(),
        known: HashMap::new(),
    };
    let mut wishes: Vec<ViewRequest> = Vec::new();
    for term in views {
        match ViewCommand::from_term(term)? {
            ViewCommand::Plot(plot) => {
                let plots = &mut gathering.view.plots;
                plots.retain(|other| (other.diagram, &other.id) != (plot.diagram, &plot.id));
                plots.push(plot);
            }
            // Answers repeat commands that do not depend on them.
            ViewCommand::Show(wanted) => {
                for wish in wanted {
                    if !wishes.contains(&wish) {
                        wishes.push(wish);
                    }
                }
            }
        }
    }
    for wish in &wishes {
        if gathering.is_full() {
            gathering.view.left_out += 1;
        } else {
            gathering.wish(wish);
        }
    }
    gathering.mention(rows);
    Ok(gathering.view)
}

/// An opened round.
#[derive(Clone)]
struct Opened {
    /// Robot of the round; `None` for a log.
    robot: Option<Rc<RobotModel>>,
    /// Name of the tool.
    tool: String,
    telemetry: Rc<Telemetry>,
    /// Start of the round [s since 1970].
    began: f64,
    /// Names of the round's media, with prefix.
    media: Vec<String>,
}

struct Gathering<'a> {
    memory: &'a Memory,
    catalogue: &'a Catalogue,
    view: View,
    /// Opened rounds, as many as the view has rounds.
    opened: Vec<Opened>,
    /// Index of a round by episode and number.
    known: HashMap<(String, usize), usize>,
}

/// Part of a round, in its own time [s].
#[derive(Clone, Copy)]
struct Stretch {
    round: usize,
    from: f64,
    to: f64,
}

impl Gathering<'_> {
    fn is_full(&self) -> bool {
        let view = &self.view;
        view.bodies.len() >= MAX_POSES
            || view.tracks.len() >= MAX_TRACKS
            || view.rounds.len() > MAX_ROUNDS
    }

    fn remark(&mut self, what: String) {
        let remarks = &mut self.view.remarks;
        if !remarks.contains(&what) {
            remarks.push(what);
        }
    }

    fn wish(&mut self, wish: &ViewRequest) {
        let (ViewSubject::Thing(name)
        | ViewSubject::Trajectory(name)
        | ViewSubject::Particles(name)) = &wish.subject;
        // An event is shown as the tool's trajectory during the event.
        if let Some((interval, _)) = self.event(name) {
            let tool = ViewRequest {
                subject: ViewSubject::Trajectory("tool".to_owned()),
                when: match wish.when {
                    ViewTime::Latest => ViewTime::During(interval),
                    when => when,
                },
                ..wish.clone()
            };
            return self.wish(&tool);
        }
        let highlighted = self.emphasize(name, wish);
        if highlighted {
            return;
        }
        let stretches = match self.stretches(name, wish.when) {
            Ok(stretches) => stretches,
            Err(error) => return self.remark(error.to_string()),
        };
        for stretch in stretches {
            let drawn = match &wish.subject {
                ViewSubject::Particles(_) => self.particles(wish, stretch),
                ViewSubject::Thing(_) if self.is_medium(stretch.round, name) => {
                    self.particles(wish, stretch)
                }
                ViewSubject::Thing(_) => self.bodies(name, wish, stretch),
                ViewSubject::Trajectory(_) => self.track(name, wish, stretch),
            };
            if let Err(error) = drawn {
                let round = &self.view.rounds[stretch.round];
                let (number, episode) = (round.number, &self.view.episodes[round.episode].id);
                self.remark(format!("episode {episode}, round {number}: {error}"));
            }
        }
    }

    /// Highlights what is already shown, if the wish asks for nothing else.
    fn emphasize(&mut self, name: &str, wish: &ViewRequest) -> bool {
        if wish.emphasis == Emphasis::Plain || wish.when != ViewTime::Latest {
            return false;
        }
        let mut found = false;
        match wish.subject {
            ViewSubject::Thing(_) => {
                for body in self
                    .view
                    .bodies
                    .iter_mut()
                    .filter(|body| body.thing == name)
                {
                    body.emphasis = wish.emphasis;
                    body.colour = wish.colour.or(body.colour);
                    found = true;
                }
            }
            ViewSubject::Trajectory(_) => {
                for track in self
                    .view
                    .tracks
                    .iter_mut()
                    .filter(|track| track.thing == name)
                {
                    track.emphasis = wish.emphasis;
                    track.colour = wish.colour.or(track.colour);
                    found = true;
                }
            }
            ViewSubject::Particles(_) => {
                for dirt in &mut self.view.particles {
                    dirt.colour = wish.colour.or(dirt.colour);
                    found = true;
                }
            }
        }
        found
    }

    /// Returns the interval of the individual with this name.
    fn event(&self, name: &str) -> Option<([f64; 2], IndividualId)> {
        let id = self.catalogue.find(name.strip_prefix("semco:")?)?;
        Some((self.catalogue.interval(id)?, id))
    }

    fn is_medium(&self, round: usize, name: &str) -> bool {
        self.opened[round].media.iter().any(|medium| medium == name)
    }

    /// Returns the parts of rounds that a wish asks for.
    fn stretches(&mut self, thing: &str, when: ViewTime) -> Result<Vec<Stretch>, ViewError> {
        let catalogue = self.catalogue;
        let [from, to] = match when {
            ViewTime::At(time) => [time; 2],
            ViewTime::During(interval) | ViewTime::Every(interval, _) => interval,
            ViewTime::Latest => return self.latest(thing),
        };
        let (mut found, mut has_faults) = (Vec::new(), false);
        for row in catalogue.episodes_during([from, to]) {
            for number in 1..=row.rounds.len() {
                let began = row.rounds[number - 1];
                let ended = row.rounds.get(number).copied().unwrap_or(row.interval[1]);
                if began > to || ended < from {
                    continue;
                }
                let round = match self.open(row, number) {
                    Ok(round) => round,
                    Err(error) => {
                        has_faults = true;
                        self.remark(format!("episode {} is left out: {error}", row.id));
                        continue;
                    }
                };
                let telemetry = &self.opened[round].telemetry;
                let Some([first, last]) = telemetry.interval() else {
                    continue;
                };
                let stretch = [(from - began).max(first), (to - began).min(last)];
                if stretch[0] <= stretch[1] {
                    found.push(self.show_stretch(round, stretch, [from, to]));
                }
            }
        }
        if found.is_empty() && !has_faults {
            return Err(ViewError::NoRecord {
                thing: thing.to_owned(),
                from,
                to,
            });
        }
        Ok(found)
    }

    /// Returns the last round with telemetry.
    fn latest(&mut self, thing: &str) -> Result<Vec<Stretch>, ViewError> {
        let mut rows: Vec<&EpisodeRow> = self.catalogue.episodes().iter().collect();
        rows.sort_by(|a, b| b.interval[0].total_cmp(&a.interval[0]));
        for row in rows {
            for number in (1..=row.rounds.len()).rev() {
                let Ok(round) = self.open(row, number) else {
                    continue;
                };
                if let Some([first, last]) = self.opened[round].telemetry.interval() {
                    let began = self.opened[round].began;
                    let shown = [began + last; 2];
                    return Ok(vec![self.show_stretch(round, [first, last], shown)]);
                }
            }
        }
        Err(ViewError::NoRecord {
            thing: thing.to_owned(),
            from: f64::NEG_INFINITY,
            to: f64::INFINITY,
        })
    }

    fn show_stretch(&mut self, round: usize, [from, to]: [f64; 2], shown: [f64; 2]) -> Stretch {
        let intervals = &mut self.view.episodes[self.view.rounds[round].episode].shown;
        if !intervals.contains(&shown) {
            intervals.push(shown);
        }
        Stretch { round, from, to }
    }

    /// Returns the index of a round, which is opened if necessary.
    fn open(&mut self, row: &EpisodeRow, number: usize) -> Result<usize, ViewError> {
        let key = (row.id.clone(), number);
        if let Some(&place) = self.known.get(&key) {
            return Ok(place);
        }
        let episode = self.memory.episode(&row.id)?;
        let telemetry = Rc::new(episode.telemetry(number)?);
        let same = (self.known.iter()).find(|((id, _), _)| *id == row.id);
        let robot = match same {
            Some((_, &place)) => self.opened[place].robot.clone(),
            None if episode.has_robot() => Some(Rc::new(episode.robot()?)),
            None => None,
        };
        let tool = tool_of(self.catalogue, row);
        // Telemetry without usable poses is reported once, for the episode.
        frames_of(robot.as_deref(), &telemetry, &tool)?;
        let shown = ShownRound {
            episode: self.episode(row),
            number,
        };
        let opened = Opened {
            media: self.media(row),
            telemetry: Rc::clone(&telemetry),
            robot: robot.clone(),
            tool,
            began: row.rounds[number - 1],
        };
        self.view.rounds.push(shown);
        self.opened.push(opened);
        let place = self.opened.len() - 1;
        self.known.insert(key, place);
        Ok(place)
    }

    /// Returns the media that an episode removed.
    fn media(&self, row: &EpisodeRow) -> Vec<String> {
        let removed = self.catalogue.relations("semco:removesMedium");
        let nodes = (row.first..row.first + row.len).flat_map(|id| entries(removed, id));
        let mut media: Vec<String> = nodes
            .filter_map(|(_, node)| match node {
                CatalogueNode::Shared(number) => {
                    Some(self.catalogue.shared_individuals()[*number as usize].clone())
                }
                CatalogueNode::Individual(_) => None,
            })
            .collect();
        media.dedup();
        media
    }

    /// Returns the index of an episode, which is added if necessary.
    fn episode(&mut self, row: &EpisodeRow) -> usize {
        let shown = &mut self.view.episodes;
        if let Some(place) = shown.iter().position(|episode| episode.id == row.id) {
            return place;
        }
        shown.push(ShownEpisode {
            id: row.id.clone(),
            task: row.task.clone(),
            interval: row.interval,
            occurrences: occurrences(self.catalogue, row),
            shown: Vec::new(),
        });
        shown.len() - 1
    }

    fn bodies(
        &mut self,
        name: &str,
        wish: &ViewRequest,
        stretch: Stretch,
    ) -> Result<(), ViewError> {
        let opened = self.opened[stretch.round].clone();
        let frames = frames_of(opened.robot.as_deref(), &opened.telemetry, &opened.tool)?;
        let Stretch { round, from, to } = stretch;
        let poses = match wish.when {
            ViewTime::Latest => vec![frames.pose(local(name), to)?],
            ViewTime::At(_) => vec![frames.pose(local(name), from)?],
            ViewTime::During(_) => {
                let sampling = Sampling::Count(POSES_OF_INTERVAL);
                frames.trajectory(local(name), [from, to], sampling)?
            }
            ViewTime::Every(_, period) => {
                frames.trajectory(local(name), [from, to], Sampling::Every(period))?
            }
        };
        let count = poses.len();
        if count > MAX_POSES {
            return Err(ViewError::TooManyPoses {
                thing: name.to_owned(),
                count,
                limit: MAX_POSES,
            });
        }
        if self.view.bodies.len() + count > MAX_POSES {
            self.view.left_out += 1;
            return Ok(());
        }
        for at in poses {
            let body = ShownBody {
                thing: name.to_owned(),
                figure: figure(&frames, local(name)),
                world_from_frame: at.world_from_frame,
                round,
                time: opened.began + at.time,
                emphasis: wish.emphasis,
                colour: wish.colour,
            };
            self.view.bodies.push(body);
        }
        Ok(())
    }

    fn track(&mut self, name: &str, wish: &ViewRequest, stretch: Stretch) -> Result<(), ViewError> {
        let opened = self.opened[stretch.round].clone();
        let frames = frames_of(opened.robot.as_deref(), &opened.telemetry, &opened.tool)?;
        let interval = [stretch.from, stretch.to];
        let samples = match wish.when {
            ViewTime::Every(_, period) => {
                let poses = frames.trajectory(local(name), interval, Sampling::Every(period))?;
                let timed = poses.iter();
                timed
                    .map(|at| (opened.began + at.time, place(at)))
                    .collect()
            }
            _ => Vec::new(),
        };
        self.view.tracks.push(Track {
            thing: name.to_owned(),
            round: stretch.round,
            interval: interval.map(|time| opened.began + time),
            path: line(&frames, local(name), interval)?,
            samples,
            emphasis: wish.emphasis,
            colour: wish.colour,
        });
        Ok(())
    }

    fn particles(&mut self, wish: &ViewRequest, stretch: Stretch) -> Result<(), ViewError> {
        let round = &self.view.rounds[stretch.round];
        let id = self.view.episodes[round.episode].id.clone();
        let (state, name) = match wish.when {
            ViewTime::Latest => (DirtState::Estimated, "particles-estimated.csv"),
            _ => (DirtState::Before, "particles-before.csv"),
        };
        let file = format!("round-{}/{name}", round.number);
        let bytes = self.memory.episode(&id)?.attachment(&file)?;
        let positions = positions(&bytes).map_err(|what| ViewError::Particles { file, what })?;
        let dirt = ShownDirt {
            round: stretch.round,
            state,
            positions,
            colour: wish.colour,
        };
        let same = |other: &ShownDirt| other.round == dirt.round && other.state == dirt.state;
        if !self.view.particles.iter().any(same) {
            self.view.particles.push(dirt);
        }
        Ok(())
    }

    /// Adds the episodes of individuals in the answers.
    fn mention(&mut self, rows: &[Vec<Term>]) {
        for term in rows.iter().flatten() {
            if self.view.episodes.len() >= MAX_EPISODES {
                return;
            }
            let name = term.as_atom().and_then(|name| name.strip_prefix("semco:"));
            if let Some(id) = name.and_then(|name| self.catalogue.find(name)) {
                let catalogue = self.catalogue;
                self.episode(catalogue.episode_of(id));
            }
        }
    }
}

/// Returns the frames of a round: of its robot, or of the logged poses.
fn frames_of<'a>(
    robot: Option<&'a RobotModel>,
    telemetry: &'a Telemetry,
    tool: &str,
) -> Result<Frames<'a>, FrameError> {
    match robot {
        Some(robot) => Frames::new(robot, telemetry),
        None => Frames::from_log(telemetry, tool),
    }
}

/// Returns the actions and events of an episode, without individuals that only group others.
fn occurrences(catalogue: &Catalogue, row: &EpisodeRow) -> Vec<Occurrence> {
    let kinds = Ontology::load().subclasses("semco:Collision");
    let kinds = kinds.unwrap_or_default();
    let ids = row.first..row.first + row.len;
    let found = ids.filter_map(|id| {
        let class = catalogue.class(id);
        Some(Occurrence {
            name: catalogue.name(id),
            class: local(class).to_owned(),
            is_collision: class == "semco:Collision" || kinds.contains(&class),
            interval: catalogue.interval(id)?,
        })
    });
    let wholes = ["WipingEpisode", "WipingAction", "GoalEpisode", "GoalAction"];
    found
        .filter(|occurrence| !wholes.contains(&occurrence.class.as_str()))
        .collect()
}

/// Parses the particles on the surface from a table in the format of distributions.
fn positions(bytes: &[u8]) -> Result<Vec<Point2>, String> {
    let text = std::str::from_utf8(bytes).map_err(|error| error.to_string())?;
    let mut lines = text.lines().enumerate();
    let (_, head) = lines.next().ok_or("it is empty")?;
    let heads: Vec<&str> = head.split(',').collect();
    let column = |name: &str| heads.iter().position(|head| *head == name);
    let (Some(x), Some(y)) = (column("x_m"), column("y_m")) else {
        return Err(format!("line 1: {head} names no x_m and y_m"));
    };
    let fate = column("fate");
    let mut positions = Vec::new();
    for (number, line) in lines.filter(|(_, line)| !line.is_empty()) {
        let cells: Vec<&str> = line.split(',').collect();
        let number_in = |column: usize| {
            let value = cells.get(column)?.parse::<f64>().ok()?;
            value.is_finite().then_some(value)
        };
        let (Some(x), Some(y)) = (number_in(x), number_in(y)) else {
            return Err(format!("line {}: {line} has no x_m and y_m", number + 1));
        };
        let lies_there = fate.is_none_or(|fate| cells.get(fate) == Some(&"on_surface"));
        if lies_there {
            positions.push(Point2::new(x, y));
        }
    }
    Ok(positions)
}
