//! The 3-D scene of a query, in the format of the page's script.

use super::names::local;
use crate::scene::{Meshes, Solid, tenths, vector};
use serde::Serialize;
use wisch::geometry::{Bounds2, Point3, Polygon, Pose};
use wisch_memory::view::{
    Colour, DirtState, Emphasis, Figure, ShownBody, ShownDirt, ShownPart, ShownRound, Track, View,
};

/// Maximum number of triangles of a mesh.
const MAX_TRIANGLES: usize = 3000;
/// Maximum number of drawn particles; with more particles, every n-th is drawn.
const MAX_PARTICLES: usize = 3000;
/// Radius of a queried line, as a share of the surface's diagonal [1].
const LINE: f64 = 0.011;
/// Assumed diagonal of an unknown surface, as a share of the tool's largest distance from its start [1].
const FAR_SHARE: f64 = 0.5;
/// Radius of particles, as a share of that of lines [1].
const PARTICLE: f64 = 0.7;
/// Limits of the radius of lines [m].
const LINE_LIMITS: [f64; 2] = [0.0025, 0.02];
/// Height above the surface at which flat items are drawn [m].
const ABOVE: f64 = 0.0015;
/// Opacity of robots after the first [1].
const GHOST: f64 = 0.28;

/// The script's input, in the format of [`crate::scene`].
#[derive(Debug, Serialize)]
pub(crate) struct Space {
    meshes: Meshes,
    pub(crate) items: Vec<Item>,
    /// Positions of robots and surface, which determine the first view [m].
    robot: Option<[f64; 3]>,
    surface: Option<[f64; 3]>,
}

/// An item that the reader can show and hide.
#[derive(Debug, Serialize)]
pub(crate) struct Item {
    /// Shown name.
    pub(crate) name: String,
    /// Name of a colour of the page, or `#rrggbb`.
    pub(crate) colour: String,
    /// Opacity, in [0, 1].
    alpha: f64,
    /// Whether the query asked for it; other items are context.
    pub(crate) asked: bool,
    /// Whether it shows through items in front of it.
    shines: bool,
    solids: Vec<Solid>,
    lines: Vec<Line>,
    dots: Vec<Line>,
}

#[derive(Debug, Serialize)]
struct Line {
    radius: f64,
    points: Vec<i64>,
}

impl Space {
    /// Makes the scene of a view.
    pub(crate) fn new(view: &View) -> Self {
        let mut space = Self {
            meshes: Meshes::new(MAX_TRIANGLES),
            items: Vec::new(),
            robot: None,
            surface: None,
        };
        for (place, round) in view.rounds.iter().enumerate() {
            // The rounds of an episode share their surroundings.
            let before = &view.rounds[..place];
            let is_new = !before
                .iter()
                .any(|other| has_same_surroundings(other, round));
            if is_new {
                space.add_surroundings(round);
            }
            space.add_full_path(view, round);
        }
        let mut robots = 0;
        for body in &view.bodies {
            space.add_body(view, body, robots);
            robots += usize::from(matches!(body.figure, Figure::Robot { .. }));
        }
        for track in &view.tracks {
            space.add_track(view, track);
        }
        for dirt in &view.particles {
            space.add_dirt(view, dirt);
        }
        space
    }

    /// Whether the scene has no items.
    pub(crate) fn is_empty(&self) -> bool {
        self.items.is_empty()
    }

    /// Whether an item shows through others, so that a close view makes sense.
    pub(crate) fn shines(&self) -> bool {
        self.items.iter().any(|item| item.shines)
    }

    fn add_surroundings(&mut self, round: &ShownRound) {
        let [_, _, name] = &round.names;
        self.surface = Some(vector(&round.world_from_surface.translation.vector));
        if let Some(outline) = &round.outline {
            let mut item = Item::new(name, "outline");
            item.lines = rings(round, outline, &round.world_from_surface);
            self.items.push(item);
        }
        if !round.objects.is_empty() {
            let mut item = Item::new("scene objects", "obstacle");
            item.alpha = 0.5;
            for (world_from_object, mesh) in &round.objects {
                (item.solids).push(self.meshes.solid(world_from_object, mesh));
            }
            self.items.push(item);
        }
    }

    /// Adds the full path of the tool as a thin line, as context of queried paths.
    fn add_full_path(&mut self, view: &View, round: &ShownRound) {
        let episode = &view.episodes[round.episode].id;
        let [_, tool, _] = &round.names;
        let name = format!(
            "full path of the {tool}, round {} of {episode}",
            round.number
        );
        let mut item = Item::new(&name, "quiet");
        let points = round.tool_path.iter().copied();
        item.lines = vec![Line::new(line_radius(round) / 4.0, points)];
        self.items.push(item);
    }

    fn add_body(&mut self, view: &View, body: &ShownBody, robots: usize) {
        let round = &view.rounds[body.round];
        let at = describe_time(view, body.round, body.time);
        let name = format!("{} {at}", display_name(round, &body.thing));
        let mut item = Item::new(
            &name,
            &tint(body.emphasis, body.colour, default_colour(&body.figure)),
        );
        item.asked = true;
        match &body.figure {
            Figure::Robot {
                parts,
                world_from_tool,
            } => {
                if robots > 0 {
                    item.alpha = GHOST;
                }
                let mut held = Item::new(&format!("{} {at}", round.names[1]), "tool");
                held.alpha = item.alpha;
                held.asked = true;
                held.solids.push(self.tool_solid(round, world_from_tool));
                item.solids = self.make_solids(parts);
                self.items.extend([item, held]);
                return;
            }
            Figure::Tool(world_from_tool) => {
                item.solids.push(self.tool_solid(round, world_from_tool))
            }
            Figure::Surface(world_from_surface) => match &round.outline {
                Some(outline) => item.lines = rings(round, outline, world_from_surface),
                None => item.dots.push(mark(round, world_from_surface)),
            },
            Figure::Frame(world_from_frame) => item.dots.push(mark(round, world_from_frame)),
        }
        self.items.push(item);
    }

    fn make_solids(&mut self, parts: &[ShownPart]) -> Vec<Solid> {
        if let Some(base) = parts.first() {
            let at = vector(&base.world_from_shape.translation.vector);
            self.robot.get_or_insert(at);
        }
        let solids =
            (parts.iter()).map(|part| self.meshes.shape(&part.world_from_shape, &part.shape));
        solids.collect()
    }

    /// Returns the tool; a ball if its mesh is unknown.
    fn tool_solid(&mut self, round: &ShownRound, world_from_tool: &Pose) -> Solid {
        match &round.tool_mesh {
            Some(mesh) => self.meshes.solid(world_from_tool, mesh),
            None => Solid::ball(world_from_tool, 4.0 * line_radius(round)),
        }
    }

    fn add_track(&mut self, view: &View, track: &Track) {
        let round = &view.rounds[track.round];
        let [from, to] = track.interval;
        let name = format!(
            "{}'s path {} to {}",
            display_name(round, &track.thing),
            describe_time(view, track.round, from),
            format_since_start(view, track.round, to)
        );
        let mut item = Item::new(&name, &tint(track.emphasis, track.colour, "contact"));
        item.asked = true;
        item.shines = true;
        let radius = line_radius(round);
        item.lines = vec![Line::new(radius, track.path.iter().copied())];
        let samples = track.samples.iter().map(|(_, place)| *place);
        item.dots = vec![Line::new(2.2 * radius, samples)];
        self.items.push(item);
    }

    fn add_dirt(&mut self, view: &View, dirt: &ShownDirt) {
        let round = &view.rounds[dirt.round];
        let when = match dirt.state {
            DirtState::Before => "before",
            DirtState::Estimated => "after",
        };
        let episode = &view.episodes[round.episode].id;
        let name = format!("particles {when} round {} of {episode}", round.number);
        let mut item = Item::new(&name, &tint(Emphasis::Plain, dirt.colour, "left"));
        item.asked = true;
        let step = dirt.positions.len().div_ceil(MAX_PARTICLES).max(1);
        let places = dirt.positions.iter().step_by(step);
        let places = places.map(|p| round.world_from_surface * Point3::new(p.x, p.y, ABOVE));
        item.dots = vec![Line::new(PARTICLE * line_radius(round), places)];
        self.items.push(item);
    }
}

impl Item {
    fn new(name: &str, colour: &str) -> Self {
        Self {
            name: name.to_owned(),
            colour: colour.to_owned(),
            alpha: 1.0,
            asked: false,
            shines: false,
            solids: Vec::new(),
            lines: Vec::new(),
            dots: Vec::new(),
        }
    }
}

impl Line {
    fn new(radius: f64, points: impl Iterator<Item = Point3>) -> Self {
        Self {
            radius: (radius * 1e5).round() / 1e5,
            points: tenths(points),
        }
    }
}

/// Returns the rings of an outline, slightly above the surface.
fn rings(round: &ShownRound, outline: &Polygon, world_from_surface: &Pose) -> Vec<Line> {
    let rings = outline.rings().map(|ring| {
        let closed = ring.iter().chain(ring.first());
        let points = closed.map(|p| world_from_surface * Point3::new(p.x, p.y, ABOVE));
        Line::new(line_radius(round) / 3.0, points)
    });
    rings.collect()
}

/// Returns the default colour of a figure.
const fn default_colour(figure: &Figure) -> &'static str {
    match figure {
        Figure::Robot { .. } => "robot-arm",
        Figure::Tool(_) => "tool",
        Figure::Surface(_) => "surface-3d",
        Figure::Frame(_) => "plane",
    }
}

fn mark(round: &ShownRound, world_from_frame: &Pose) -> Line {
    let place = Point3::from(world_from_frame.translation.vector);
    Line::new(3.0 * line_radius(round), [place].into_iter())
}

/// Whether two rounds have the same objects at the same poses.
fn has_same_surroundings(a: &ShownRound, b: &ShownRound) -> bool {
    let near = (a.world_from_surface.translation.vector - b.world_from_surface.translation.vector)
        .norm()
        < 1e-6;
    near && a.names == b.names && a.objects.len() == b.objects.len()
}

/// Returns the radius of queried lines [m].
fn line_radius(round: &ShownRound) -> f64 {
    let corners = round.outline.iter().flat_map(Polygon::outer).copied();
    let extent = match Bounds2::from_points(corners) {
        Some(bounds) => bounds.size().norm(),
        None => FAR_SHARE * max_distance(&round.tool_path),
    };
    (LINE * extent).clamp(LINE_LIMITS[0], LINE_LIMITS[1])
}

/// Returns the largest distance of a path from its start [m].
fn max_distance(path: &[Point3]) -> f64 {
    path.first().map_or(0.0, |first| {
        let reach = path.iter().map(|place| (place - first).norm());
        reach.fold(0.0, f64::max)
    })
}

fn tint(emphasis: Emphasis, colour: Option<Colour>, usual: &str) -> String {
    match (colour, emphasis) {
        (Some(Colour([r, g, b])), _) => format!("#{r:02x}{g:02x}{b:02x}"),
        (None, Emphasis::Strong) => "limit".to_owned(),
        (None, Emphasis::Plain) => usual.to_owned(),
    }
}

/// Describes a time: its round, its episode, and the time since the start of the episode.
fn describe_time(view: &View, round: usize, time: f64) -> String {
    let shown = &view.rounds[round];
    let episode = &view.episodes[shown.episode];
    let of = if view.episodes.len() > 1 {
        format!(" of {}", episode.id)
    } else {
        String::new()
    };
    let at = format_since_start(view, round, time);
    format!("in round {}{of}, {at}", shown.number)
}

/// Formats the time since the start of the episode.
fn format_since_start(view: &View, round: usize, time: f64) -> String {
    let began = view.episodes[view.rounds[round].episode].interval[0];
    format!("{:.1} s", time - began)
}

/// Returns the shown name of an object.
fn display_name<'a>(round: &'a ShownRound, thing: &'a str) -> &'a str {
    match local(thing) {
        "tool" | "tcp" => &round.names[1],
        name => name,
    }
}
