//! The base poses, seen from above.

use super::input::{BasePose, CandidateBase, MotionInput, ShownContact, ShownPhase};
use super::sampled::{SampledMotion, world_from_link};
use crate::draw::{BANDS, Entry, Panel, Pen, View, WIDTH, hull, inset, legend, outline, px};
use maud::{Markup, html};
use wisch::geometry::{Bounds2, PlanarPose, Point2, Point3, Vector2};
use wisch::represent::ScenePart;
use wisch::robot::{JointKind, LinkId, RobotModel};

/// Maximum height of the plan.
const HEIGHT: f64 = 620.0;
/// Margin around the shown objects [m].
const MARGIN: f64 = 0.2;
/// Maximum number of drawn base positions.
const MAX_PLACES: usize = 4_000;
/// Movement below which a base counts as fixed [m].
const STILL: f64 = 1e-3;

/// Draws the plan view; `None` if there is nothing to show.
pub(crate) fn panel(input: &MotionInput, frames: &SampledMotion) -> Option<Panel> {
    let base = find_base(input.robot)?;
    let body = find_footprint(input.robot, base);
    let way: Vec<Point2> = (frames.path(input, base, Point3::origin()).iter())
        .map(|p| p.xy())
        .collect();
    let stands = list_base_poses(input, frames, base);
    let tool = input.link_from_tool.translation.vector.into();
    let path: Vec<Point2> = (frames.path(input, input.tool_link, tool).iter())
        .map(|p| p.xy())
        .collect();
    let surface = list_surface_rings(input);
    let bodies: Vec<Vec<Point2>> = stands
        .iter()
        .map(|stand| place_points(&body, stand))
        .collect();
    let rated = || {
        input
            .ratings
            .iter()
            .map(|place| Point2::new(place.x, place.y))
    };
    let shown = (surface.iter().flatten().copied())
        .chain(bodies.iter().flatten().copied())
        .chain(way.iter().copied())
        .chain(path.iter().copied())
        .chain(rated())
        .filter(|p| p.x.is_finite() && p.y.is_finite());
    let mut bounds = Bounds2::from_points(shown)?;
    bounds.min -= Vector2::repeat(MARGIN);
    bounds.max += Vector2::repeat(MARGIN);
    let view = View::with_axes(bounds, Vector2::new(WIDTH, HEIGHT));
    let drives = Bounds2::from_points(way.iter().copied()).is_some_and(|b| b.size().norm() > STILL);
    let layers = html! {
        (draw_scene(input, &view))
        path class="surface-plan" d=(view.rings(surface.iter().map(Vec::as_slice))) {}
        (draw_ratings(input, &view))
        (draw_tool_path(input, frames, &view, &path))
        @if drives { path class="driven" d=(view.line(thin_line(&way))) {} }
        @for (body, stand) in bodies.iter().zip(&stands) {
            path class="robot-plan" d=(view.rings([body.as_slice()])) {}
            (draw_heading(&view, stand))
        }
        (draw_numbers(&view, &stands))
    };
    let (legend, below) = draw_legend(input, drives, view.bottom());
    Some(Panel {
        width: WIDTH,
        height: view.bottom() + below,
        body: html! {
            (inset(&view, layers))
            (view.axes())
            (view.scale_bar())
            (legend)
        },
    })
}

/// Returns the link on the floor: the first link with a shape, or the link to which it is fixed.
fn find_base(robot: &RobotModel) -> Option<LinkId> {
    let shaped = robot
        .links()
        .iter()
        .find(|link| !link.collision.is_empty())?;
    let mut joint = shaped.parent;
    while let Some(held) = joint.map(|id| &robot.joints()[id.index()]) {
        if held.kind != JointKind::Fixed {
            return Some(held.child);
        }
        joint = robot.links()[held.parent.index()].parent;
    }
    Some(robot.root())
}

/// Returns the outline of the base and of all links fixed to it, in the base frame [m].
fn find_footprint(robot: &RobotModel, base: LinkId) -> Vec<Point2> {
    let zero = vec![0.0; robot.dof()];
    let Ok(kinematics) = robot.forward_kinematics(&zero) else {
        return Vec::new();
    };
    let base_from_root = kinematics.world_from_link(base).inverse();
    let mut fixed = vec![false; robot.links().len()];
    fixed[base.index()] = true;
    let mut points = Vec::new();
    for id in std::iter::once(base).chain(robot.joints().iter().map(|joint| joint.child)) {
        let link = &robot.links()[id.index()];
        if let Some(joint) = link.parent.map(|id| &robot.joints()[id.index()]) {
            fixed[id.index()] |= joint.kind == JointKind::Fixed && fixed[joint.parent.index()];
        }
        if fixed[id.index()] {
            let base_from_link = base_from_root * kinematics.world_from_link(id);
            let shapes = link.collision.iter();
            points.extend(
                shapes.flat_map(|c| outline(&c.shape, &(base_from_link * c.link_from_shape))),
            );
        }
    }
    hull(points)
}

/// Returns the chosen base poses, or the initial pose.
fn list_base_poses(input: &MotionInput, frames: &SampledMotion, base: LinkId) -> Vec<PlanarPose> {
    let stand = |p: &BasePose| PlanarPose::new(Point2::new(p.x, p.y), p.yaw);
    let known =
        (input.placements.iter()).filter(|p| [p.x, p.y, p.yaw].iter().all(|v| v.is_finite()));
    let stands: Vec<PlanarPose> = known.map(stand).collect();
    if !stands.is_empty() {
        return stands;
    }
    let world_from_base = frames
        .q
        .first()
        .and_then(|q| world_from_link(input, q, base));
    let stand = world_from_base.map(|world_from_base| {
        let ahead = world_from_base.rotation * wisch::geometry::Vector3::x();
        let position = world_from_base.translation.vector.xy().into();
        PlanarPose::new(position, ahead.y.atan2(ahead.x))
    });
    stand.into_iter().collect()
}

fn place_points(points: &[Point2], world_from_base: &PlanarPose) -> Vec<Point2> {
    points
        .iter()
        .map(|&p| world_from_base.transform(p))
        .collect()
}

fn list_surface_rings(input: &MotionInput) -> Vec<Vec<Point2>> {
    let surface = &input.task.surface;
    let place = |p: &Point2| {
        surface
            .world_from_place(*p, 0.0)
            .translation
            .vector
            .xy()
            .into()
    };
    let rings = surface.outline.rings();
    rings.map(|ring| ring.iter().map(place).collect()).collect()
}

/// Returns the hulls of the scene objects, the lowest first.
fn draw_scene(input: &MotionInput, view: &View) -> Markup {
    let shown = (input.task.scene.iter())
        .filter(|object| matches!(object.part, ScenePart::Obstacle | ScenePart::Carrier));
    let mut hulls: Vec<(f64, ScenePart, Vec<Point2>)> = shown
        .map(|object| {
            let vertices = object.mesh.vertices().iter();
            let places: Vec<Point3> = vertices.map(|v| object.world_from_object * v).collect();
            let height = places.iter().map(|p| p.z).fold(f64::NEG_INFINITY, f64::max);
            (height, object.part, hull(places.iter().map(|p| p.xy())))
        })
        .collect();
    hulls.sort_by(|a, b| a.0.total_cmp(&b.0));
    html! {
        @for (_, part, hull) in &hulls {
            @let class = if *part == ScenePart::Carrier { "carrier-plan" } else { "obstacle-plan" };
            path class=(class) d=(view.rings([hull.as_slice()])) {}
        }
    }
}

/// Returns n so that every n-th rated position is drawn.
fn place_step(input: &MotionInput) -> usize {
    input.ratings.len().div_ceil(MAX_PLACES).max(1)
}

/// Draws rated positions as dots (darker is better), and blocked positions as crosses.
fn draw_ratings(input: &MotionInput, view: &View) -> Markup {
    let drawn = input.ratings.iter().step_by(place_step(input));
    let drawn: Vec<&CandidateBase> = drawn
        .filter(|p| p.x.is_finite() && p.y.is_finite())
        .collect();
    let area = view.width() * view.height() / drawn.len().max(1) as f64;
    let radius = (0.22 * area.sqrt()).clamp(1.5, 6.0);
    let mut rim = Pen::default();
    let mut blocked = Pen::default();
    let mut bands: Vec<Pen> = (0..BANDS).map(|_| Pen::default()).collect();
    for place in drawn {
        let at = view.at(Point2::new(place.x, place.y));
        if place.blocked {
            blocked.cross(at, 0.7 * radius);
        } else {
            rim.dot(at);
            bands[find_band(place.rating) - 1].dot(at);
        }
    }
    html! {
        path class="rate-rim" stroke-width=(px(2.0 * radius + 1.6)) d=(rim.path()) {}
        @for (i, pen) in bands.into_iter().enumerate() {
            path class=(format!("rate-{}", i + 1)) stroke-width=(px(2.0 * radius)) d=(pen.path()) {}
        }
        path class="mark-blocked" d=(blocked.path()) {}
    }
}

/// Returns the band of a rating, from 1 to [`BANDS`].
fn find_band(rating: f64) -> usize {
    (rating * BANDS as f64)
        .floor()
        .clamp(0.0, BANDS as f64 - 1.0) as usize
        + 1
}

/// Draws the path of the tool, in contact and lifted.
fn draw_tool_path(
    input: &MotionInput,
    frames: &SampledMotion,
    view: &View,
    path: &[Point2],
) -> Markup {
    let wipes = |time: f64| {
        let next = input.phases.partition_point(|phase| phase.start <= time);
        next.checked_sub(1)
            .is_some_and(|i| input.phases[i].contact == ShownContact::Wiping)
    };
    let (mut contact, mut lifted) = (Pen::default(), Pen::default());
    let mut from = 0;
    while from + 1 < path.len() {
        let kind = wipes(frames.time(from) + 0.5 * frames.period);
        let mut to = from + 1;
        while to + 1 < path.len() && wipes(frames.time(to) + 0.5 * frames.period) == kind {
            to += 1;
        }
        let pen = if kind { &mut contact } else { &mut lifted };
        let line = thin_line(&path[from..=to]);
        pen.line(line.into_iter().map(|p| view.at(p)));
        from = to;
    }
    html! {
        path class="lifted" d=(lifted.path()) {}
        path class="contact-path" d=(contact.path()) {}
    }
}

/// Removes points that are less than 2 mm from the last kept point.
fn thin_line(points: &[Point2]) -> Vec<Point2> {
    let mut line: Vec<Point2> = Vec::new();
    for (i, &point) in points.iter().enumerate() {
        let far = line.last().is_none_or(|last| (point - last).norm() > 2e-3);
        if far || i + 1 == points.len() {
            line.push(point);
        }
    }
    line
}

/// Draws the heading of the base.
fn draw_heading(view: &View, stand: &PlanarPose) -> Markup {
    let tip = |along: f64, aside: f64| view.at(stand.transform(Point2::new(along, aside)));
    let mut arrow = Pen::default();
    arrow.line([tip(0.14, 0.0), tip(0.27, 0.0)]);
    let mut head = Pen::default();
    head.line([tip(0.36, 0.0), tip(0.26, 0.055), tip(0.26, -0.055)]);
    head.close();
    html! {
        path class="edge" d=(arrow.path()) {}
        path class="arrow" d=(head.path()) {}
    }
}

fn draw_numbers(view: &View, stands: &[PlanarPose]) -> Markup {
    html! {
        @for (i, stand) in stands.iter().enumerate() {
            @let (x, y) = view.at(stand.position);
            circle class="node" cx=(px(x)) cy=(px(y)) r="10" {}
            text class="number" font-size="12" x=(px(x)) y=(px(y + 4.3)) { (i + 1) }
        }
    }
}

/// Draws the legend from a height on; returns its height, too.
fn draw_legend(input: &MotionInput, drives: bool, top: f64) -> (Markup, f64) {
    const LEFT: f64 = 48.0;
    let is_blocked = |place: &CandidateBase| place.blocked;
    let wiping = |phase: &ShownPhase| phase.contact == ShownContact::Wiping;
    let entries = [
        (
            true,
            "base; the arrow is its heading",
            html! { rect class="robot-plan" x="3" y="-6" width="18" height="12" rx="4" {} },
        ),
        (
            drives,
            "path of the base",
            html! { path class="driven" d="M0 0h24" {} },
        ),
        (
            true,
            "surface",
            html! { rect class="surface-plan" x="2" y="-6" width="20" height="12" {} },
        ),
        (
            true,
            "obstacle (hull)",
            html! { rect class="obstacle-plan" x="2" y="-6" width="20" height="12" {} },
        ),
        (
            input.phases.iter().any(wiping),
            "tool, wiping",
            html! { path class="contact-path" d="M0 0h24" {} },
        ),
        (
            true,
            "tool, lifted",
            html! { path class="lifted" d="M0 0h24" {} },
        ),
        (
            input.ratings.iter().any(is_blocked),
            "blocked position",
            html! { path class="mark-blocked" d="M8-4l8 8m0-8l-8 8" {} },
        ),
    ];
    let entries: Vec<Entry> = (entries.into_iter())
        .filter(|(shown, ..)| *shown)
        .map(|(_, label, sample)| Entry {
            label: label.to_owned(),
            sample,
        })
        .collect();
    let (body, height) = legend::rows(&entries, [LEFT, top + 2.5], WIDTH - LEFT);
    if input.ratings.iter().all(is_blocked) {
        return (body, height - 1.0);
    }
    let body = html! {
        (body)
        g transform=(format!("translate({} {})", px(LEFT), px(top + height + 10.0))) { (draw_scale(place_step(input))) }
    };
    (body, height + 46.0)
}

/// Draws the colour scale of ratings.
fn draw_scale(one_in: usize) -> Markup {
    const FROM: f64 = 110.0;
    const CELL: f64 = 34.0;
    let end = FROM + CELL * BANDS as f64;
    html! {
        text class="text" font-size="12" x="0" y="4.3" { "position rating" }
        @for band in 1..=BANDS {
            rect class=(format!("band-{band}")) x=(px(FROM + CELL * (band - 1) as f64)) y="-7" width=(px(CELL)) height="14" {}
        }
        rect class="rule" x=(px(FROM)) y="-7" width=(px(end - FROM)) height="14" {}
        text class="text small quiet middle" x=(px(FROM)) y="20" { "0" }
        text class="text small quiet middle" x=(px(end)) y="20" { "1" }
        @if one_in > 1 {
            text class="text small quiet" x=(px(end + 20.0)) y="4.3" { "1 of " (one_in) " positions is drawn" }
        }
    }
}
