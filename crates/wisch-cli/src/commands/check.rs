//! `wisch check`: checks a task and prints a summary of it.

use super::budget::in_evaluations;
use super::follow::{Chosen, describe_stand, follow_plan, workcell};
use super::goal::read_goal;
use super::prepare::{self, stage_failure};
use super::words::{format_count, internal, percent};
use crate::args::{CheckArgs, GlobalArgs};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::terminal::{Outcome, print, print_json};
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet};
use wisch::follow::{Followed, Workcell};
use wisch::geometry::{Bounds2, Mesh, Point2};
use wisch::goal::{Sequence, StepPlace, StepTimes, Wiping};
use wisch::plan::{BendContact, FreeSpace, NodeRole, Plan, Prediction, predict};
use wisch::represent::{Action, GoalState, SurfaceShape, Task, describe_weak_reaction};
use wisch::run::{NoExecutor, Stage, check_score, ignore_events};
use wisch_io::{GoalFile, KeptFiles, LoadedTask, ShapeRecord};

/// Number of sample points for free space along the longer side of the surface.
const RASTER: usize = 120;
/// Number of obstacles between two updates of the progress.
const OBSTACLES_PER_UPDATE: usize = 100;
/// Obstacles that are listed by name.
const LISTED: usize = 8;

/// Reads the task, plans it, checks the robot's start, predicts the effect and prints a summary.
pub fn check(args: &CheckArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    match read_goal(&args.task)? {
        Some(file) => check_parts(args, &file, global),
        None => check_task(args, global),
    }
}

/// Equal times of all steps, with which a search shows the parts of a goal that can be reached at all.
struct EqualTimes;

impl StepTimes for EqualTimes {
    fn wiping(&self, _: &Wiping) -> Option<f64> {
        Some(1.0)
    }

    fn handling(&self, _: &str) -> f64 {
        1.0
    }

    fn moving(&self, _: StepPlace<'_>, _: StepPlace<'_>) -> f64 {
        0.0
    }
}

/// Checks the task of each wiping step that the goal needs, and names the parts that no step can reach.
fn check_parts(args: &CheckArgs, file: &GoalFile, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let failure = |error| stage_failure(&args.task, error);
    let situation = file.situation().map_err(failure)?;
    let sequence = situation.plan(&file.goal, StepPlace::Start, &EqualTimes);
    let Sequence { steps, left_out } = sequence.map_err(failure)?;
    let wipings = steps.iter().filter_map(|step| step.wiping.as_ref());
    let parts = wipings.filter_map(|wiping| {
        let fact = situation.find_effect_of(wiping)?;
        Some((fact.to_string(), wiping.tool.clone()))
    });
    let parts: Vec<(String, String)> = parts.collect();
    let mut outcome = Outcome::Done;
    for (part, reason) in &left_out {
        if !global.quiet && !args.json {
            print(&format!("{part}: cannot be reached: {reason}\n"))?;
        }
        outcome = Outcome::GoalNotMet;
    }
    let (mut steps, mut notes) = (Vec::new(), Vec::new());
    for (part, tool) in parts {
        if !global.quiet && !args.json {
            print(&format!("{part}: "))?;
        }
        let mut args = args.clone();
        let text = |text: String| serde_json::Value::from(text).to_string();
        let of_step = [
            ("goal", text(part.clone())),
            ("tool.name", text(tool.clone())),
            ("tool.in_hand", text(tool)),
            ("tool.available", "[]".to_owned()),
        ];
        let of_step = of_step.map(|(key, value)| (key.to_owned(), value));
        args.task.settings.extend(of_step);
        let checked = check_one(&args, global)?;
        if !matches!(checked.outcome, Outcome::Done) {
            outcome = Outcome::GoalNotMet;
        }
        let new = checked.assumptions.into_iter();
        let new: Vec<String> = new.filter(|note| !notes.contains(note)).collect();
        notes.extend(new);
        steps.extend(checked.record.map(|check| StepCheck { part, check }));
    }
    if args.json {
        print_json(&GoalCheckRecord::new(file, &left_out, steps, notes))?;
    }
    Ok(outcome)
}

fn check_task(args: &CheckArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let checked = check_one(args, global)?;
    if let Some(record) = &checked.record {
        print_json(record)?;
    }
    Ok(checked.outcome)
}

/// The result of the check of a task.
struct Checked {
    outcome: Outcome,
    /// The object of `--json`; `None` without this option.
    record: Option<CheckRecord>,
    /// Assumptions of the task.
    assumptions: Vec<String>,
}

/// Checks a task. Without `--json`, prints its summary.
fn check_one(args: &CheckArgs, global: &GlobalArgs) -> Result<Checked, Failure> {
    let progress = Progress::start(global);
    progress.say("reading the task");
    let task_args = &in_evaluations(&args.task, &KeptFiles::default())?;
    let prepared = prepare::read(task_args)?;
    let failure = |error| stage_failure(task_args, error);
    let free_area = FreeArea::of(&prepared.task, &progress).map_err(failure)?;
    progress.say(format!("planning ({})", prepared.run.plan.strategy));
    let mut session = prepared.session();
    (session.run_until(Stage::Planned, &mut NoExecutor, &mut ignore_events))
        .map_err(|error| stage_failure(task_args, error))?;
    let plan = (session.plan()).ok_or_else(|| internal("no plan was made"))?;
    let objects = format_count(prepared.task.scene.len(), "object");
    progress.say(format!("placing the robot among {objects}"));
    let robot = match Chosen::new(&args.robot, &prepared)? {
        Some(chosen) => {
            let cell = workcell(&chosen, task_args, &prepared)?;
            let nodes = plan.graph.nodes.len();
            let followed = follow_plan(&cell, &chosen, task_args, &prepared, plan, &mut |done| {
                progress.say(format!("following the plan: {done} of {nodes} nodes"));
            })?;
            Some(RobotFound::new(&cell.0, &followed, plan))
        }
        None => None,
    };
    progress.say("predicting");
    let wiped = robot.as_ref().map_or(plan, |robot| &robot.wiped);
    let prediction = predict(&prepared.task, wiped, |_| ());
    let least = prepared.run.min_score;
    let refusal = check_score(&prediction, prepared.task.action, least).err();
    let reaches_nothing = robot.as_ref().is_some_and(|robot| robot.reaches_nothing);
    drop(progress);
    let found = Found {
        free_area,
        plan,
        robot,
        prediction,
    };
    let record = args.json.then(|| {
        let refusal = refusal.as_ref().map(ToString::to_string);
        CheckRecord::new(&prepared, &found, refusal, reaches_nothing)
    });
    if !args.json && !global.quiet {
        let heading = match &refusal {
            _ if reaches_nothing => {
                "the task is valid, but the robot reaches no stroke of its plan".to_owned()
            }
            None => "the task is valid".to_owned(),
            Some(refusal) => refusal.to_string(),
        };
        print(&describe_found(&prepared, &found, &heading))?;
    }
    let outcome = match refusal {
        None if !reaches_nothing => Outcome::Done,
        _ => Outcome::GoalNotMet,
    };
    Ok(Checked {
        outcome,
        record,
        assumptions: prepared.assumptions,
    })
}

/// The object that `--json` prints for a goal of several parts.
#[derive(Serialize)]
struct GoalCheckRecord<'a> {
    format: &'static str,
    schema: u32,
    task: &'a str,
    goal: String,
    /// The parts of the goal, in its order.
    parts: Vec<PartCheck>,
    surfaces: Vec<&'a str>,
    media: Vec<MediumCheck<'a>>,
    /// The tool in the hand before the first step; null without one.
    tool_in_hand: Option<&'a str>,
    /// The tools in the rack.
    tools: Vec<ToolCheck<'a>>,
    /// The wiping steps that the goal needs, without their order in time.
    steps: Vec<StepCheck>,
    /// Assumptions about tools, media and interactions that the file defines.
    notes: Vec<String>,
}

/// A part of a goal.
#[derive(Serialize)]
struct PartCheck {
    part: String,
    /// Why no sequence of steps reaches the part; null if one does.
    left_out: Option<String>,
}

/// A medium on a surface.
#[derive(Serialize)]
struct MediumCheck<'a> {
    medium: &'a str,
    surface: &'a str,
}

/// A tool in the rack.
#[derive(Serialize)]
struct ToolCheck<'a> {
    tool: &'a str,
    /// Its position in the world; null if the file states none.
    position_m: Option<[f64; 3]>,
}

/// The check of a wiping step.
#[derive(Serialize)]
struct StepCheck {
    /// The fact that the step brings about.
    part: String,
    #[serde(flatten)]
    check: CheckRecord,
}

impl<'a> GoalCheckRecord<'a> {
    fn new(
        file: &'a GoalFile,
        left_out: &[(String, String)],
        steps: Vec<StepCheck>,
        notes: Vec<String>,
    ) -> Self {
        let parts = file.goal.parts().map(|(holds, fact)| {
            let part = match holds {
                true => fact.to_string(),
                false => format!("(not {fact})"),
            };
            let reason = left_out.iter().find(|(left, _)| *left == part);
            PartCheck {
                left_out: reason.map(|(_, reason)| reason.clone()),
                part,
            }
        });
        let mut surfaces: Vec<&str> = Vec::new();
        for on in &file.media {
            if !surfaces.contains(&&*on.surface) {
                surfaces.push(&on.surface);
            }
        }
        let media = file.media.iter().map(|on| MediumCheck {
            medium: &on.medium,
            surface: &on.surface,
        });
        let tools = file.tools.iter().map(|tool| ToolCheck {
            tool: &tool.name,
            position_m: tool.position,
        });
        Self {
            format: "wisch-goal-check",
            schema: 1,
            task: &file.name,
            goal: file.goal.to_string(),
            parts: parts.collect(),
            surfaces,
            media: media.collect(),
            tool_in_hand: file.tool_in_hand.as_deref(),
            tools: tools.collect(),
            steps,
            notes,
        }
    }
}

/// The object that `--json` prints.
#[derive(Serialize)]
struct CheckRecord {
    task: String,
    action: &'static str,
    surface: String,
    tool: String,
    medium: String,
    strategy: &'static str,
    seed: u64,
    particles: usize,
    free_share: f64,
    nodes: usize,
    strokes: usize,
    distance_in_contact_m: f64,
    unreachable_share: f64,
    predicted_performance: f64,
    reaction_probability: f64,
    target_performance: f64,
    lost_share: f64,
    score: f64,
    min_score: f64,
    /// Why the plan would not be executed; null if it would.
    refusal: Option<String>,
    /// Whether the robot reaches a stroke of the plan; null without a robot.
    reaches_a_stroke: Option<bool>,
    /// The lines about the robot, by name; null without a robot.
    robot: Option<BTreeMap<&'static str, String>>,
}

impl CheckRecord {
    fn new(
        prepared: &LoadedTask,
        found: &Found<'_>,
        refusal: Option<String>,
        reaches_nothing: bool,
    ) -> Self {
        let (task, plan, prediction) = (&prepared.task, found.plan, &found.prediction);
        let performance = prediction.performance;
        let lines = |robot: &RobotFound| robot.lines.iter().cloned().collect();
        Self {
            task: task.name.clone(),
            action: task.action.as_str(),
            surface: task.surface.name.clone(),
            tool: task.tool.name.clone(),
            medium: task.medium.clone(),
            strategy: prepared.run.plan.strategy.as_str(),
            seed: prepared.run.plan.seed,
            particles: task.particles.len(),
            free_share: found.free_area.free_share,
            nodes: plan.graph.nodes.len(),
            strokes: plan.strokes.len(),
            distance_in_contact_m: plan.contact_distance(),
            unreachable_share: plan.unreachable_share,
            predicted_performance: performance.ratio(),
            reaction_probability: task.interaction.reaction_probability(),
            target_performance: prepared.run.target,
            lost_share: performance.lost as f64 / performance.initial.max(1) as f64,
            score: prediction.score(),
            min_score: prepared.run.min_score,
            refusal,
            reaches_a_stroke: found.robot.as_ref().map(|_| !reaches_nothing),
            robot: found.robot.as_ref().map(lines),
        }
    }
}

/// The results of a check.
struct Found<'a> {
    free_area: FreeArea,
    plan: &'a Plan,
    /// The robot, unless the task has none.
    robot: Option<RobotFound>,
    prediction: Prediction,
}

/// What a check finds about the robot.
struct RobotFound {
    /// Lines about its position, the tool in its hand, and its reach.
    lines: Vec<(&'static str, String)>,
    /// Whether every stroke of the plan is abandoned.
    reaches_nothing: bool,
    /// The plan as the robot executes it: without abandoned nodes.
    wiped: Plan,
    /// Whether the robot abandons a part of the plan.
    abandons: bool,
}

impl RobotFound {
    fn new(cell: &Workcell, followed: &Followed, plan: &Plan) -> Self {
        let mut lines = vec![
            ("robot", describe_stand(cell)),
            ("tool held", cell.mount().to_string()),
        ];
        let held = cell.held_joints();
        if !held.is_empty() {
            let joints = format!("{}, at their ready positions", held.join(", "));
            lines.push(("joints held", joints));
        }
        let abandoned: BTreeSet<usize> = followed.abandoned.iter().map(|node| node.node).collect();
        let reach = match followed.abandoned.first() {
            None => "the robot follows the whole plan".to_owned(),
            Some(first) => format!(
                "the robot abandons {} of {}; {first}",
                abandoned.len(),
                format_count(plan.graph.nodes.len(), "node")
            ),
        };
        lines.push(("reach", reach));
        Self {
            lines,
            reaches_nothing: followed.strokes.is_empty() && !plan.strokes.is_empty(),
            wiped: Plan {
                strokes: followed.strokes.clone(),
                ..plan.clone()
            },
            abandons: !followed.abandoned.is_empty(),
        }
    }
}

/// The free area of a surface.
struct FreeArea {
    /// Share of the surface on which a node can be placed [1].
    free_share: f64,
    /// Obstacles, each with the share of the surface that it blocks for the tool [1].
    obstacles: Vec<(String, f64)>,
}

impl FreeArea {
    fn of(task: &Task, progress: &Progress) -> Result<Self, wisch::plan::PlanError> {
        let radius = task.tool.collision_radius();
        progress.say("computing the free area");
        let scene: Vec<_> = task.obstacles_in_surface().collect();
        let raster = sample_surface(task);
        let share = |count: usize| count as f64 / raster.len().max(1) as f64;
        let space = FreeSpace::new(&task.surface, &scene, radius)?;
        let free = raster.iter().filter(|&&p| space.is_free(p)).count();
        let mut obstacles = Vec::new();
        for (i, (object, mesh)) in task.obstacles().zip(&scene).enumerate() {
            if i % OBSTACLES_PER_UPDATE == 0 {
                let count = format_count(scene.len(), "obstacle");
                progress.say(format!("computing the free area beside {count} ({i} done)"));
            }
            let alone = FreeSpace::new(&task.surface, [mesh], radius)?;
            let near = select_points_near(&raster, mesh, radius);
            let kept = near.filter(|&p| !alone.is_clear(p)).count();
            if kept > 0 {
                obstacles.push((object.name.clone(), share(kept)));
            }
        }
        Ok(Self {
            free_share: share(free),
            obstacles,
        })
    }
}

/// Selects the points whose distance from a mesh can be below a radius [m]. `raster`: points by rows of rising y.
fn select_points_near<'a>(
    raster: &'a [Point2],
    mesh: &Mesh,
    radius: f64,
) -> impl Iterator<Item = Point2> + 'a {
    let (low, high) = mesh.bounds();
    let begin = raster.partition_point(|p| p.y < low.y - radius);
    let end = raster.partition_point(|p| p.y <= high.y + radius);
    let rows = raster[begin..end.max(begin)].iter().copied();
    rows.filter(move |p| (low.x - radius..=high.x + radius).contains(&p.x))
}

/// Evenly spaced points on the surface.
fn sample_surface(task: &Task) -> Vec<Point2> {
    let outline = &task.surface.outline;
    let Some(bounds) = Bounds2::from_points(outline.outer().iter().copied()) else {
        return Vec::new();
    };
    let size = bounds.size();
    let pitch = size.amax() / RASTER as f64;
    let steps = |length: f64| ((length / pitch).ceil() as usize).clamp(1, RASTER);
    let (columns, rows) = (steps(size.x), steps(size.y));
    (0..columns * rows)
        .map(|i| {
            let at = |index: usize, count: usize| (index as f64 + 0.5) / count as f64;
            Point2::new(
                bounds.min.x + size.x * at(i % columns, columns),
                bounds.min.y + size.y * at(i / columns, rows),
            )
        })
        .filter(|&point| outline.contains(point))
        .collect()
}

fn describe_found(prepared: &LoadedTask, found: &Found<'_>, heading: &str) -> String {
    let task = &prepared.task;
    let Found {
        free_area,
        plan,
        robot,
        prediction,
    } = found;
    let mut lines: Vec<(&str, String)> = vec![("action", describe_action(prepared))];
    if let Some(derived) = &prepared.derived {
        lines.push((
            "goal",
            format!("{}: {}", derived.goal, derived.steps.join(", ")),
        ));
    }
    lines.push(("surface", describe_surface(task)));
    lines.extend((prepared.steep).map(|steep| ("slope", steep.to_string())));
    lines.push(("tool", describe_tool(task)));
    lines.extend(BendContact::from_task(task).map(|contact| ("contact", contact.to_string())));
    let count = task.particles.len();
    lines.push(match task.action.treats() {
        true => ("points", format!("{count} on the surface")),
        false => (
            "dirt",
            format!("{} of {}", format_count(count, "particle"), task.medium),
        ),
    });
    lines.push(("obstacles", obstacles(free_area)));
    lines.push((
        "free",
        format!(
            "the tool's centre point can reach {:.0} % of the surface",
            100.0 * free_area.free_share
        ),
    ));
    lines.push(("goal", describe_destination(plan)));
    let dirt = if task.action.treats() {
        "points"
    } else {
        "particles"
    };
    lines.push((
        "plan",
        format!(
            "{}: {}, {}, {:.2} m in contact; {} of the {dirt} are out of reach",
            prepared.run.plan.strategy,
            format_count(plan.graph.nodes.len(), "node"),
            format_count(plan.strokes.len(), "stroke"),
            plan.contact_distance(),
            percent(plan.unreachable_share)
        ),
    ));
    let performance = prediction.performance;
    let abandons = robot.as_ref().is_some_and(|robot| robot.abandons);
    let share = |count: usize| percent(count as f64 / performance.initial.max(1) as f64);
    let (verb, lost) = if prepared.task.action.treats() {
        ("meet", String::new())
    } else {
        ("reach", format!(", {} are lost", share(performance.lost)))
    };
    lines.push((
        "predicted",
        format!(
            "{} of the {dirt} {verb} the goal{}{lost}; score {:.2} (minimum for execution: {:.2})",
            percent(performance.ratio()),
            if abandons {
                " with the strokes that the robot follows"
            } else {
                ""
            },
            prediction.score(),
            prepared.run.min_score
        ),
    ));
    match robot {
        Some(robot) => lines.extend(robot.lines.iter().cloned()),
        None => lines.push((
            "robot",
            "none: wisch predicts the plan but does not follow it; choose a robot with --robot"
                .to_owned(),
        )),
    }
    lines.push(("target", describe_target(prepared, prediction, abandons)));
    let weak = describe_weak_reaction(task.interaction.reaction_probability(), prepared.run.target);
    lines.extend(weak.map(|sentence| ("reaction", sentence)));
    let mut text = format!("{}: {heading}\n", task.name);
    for (name, value) in lines {
        text += &format!("  {name:<10} {value}\n");
    }
    text
}

/// The target, and whether the plan is predicted to reach it.
fn describe_target(prepared: &LoadedTask, prediction: &Prediction, abandons: bool) -> String {
    let target = prepared.run.target;
    let what = if abandons {
        "the followed part of this plan"
    } else {
        "this plan"
    };
    let is_exceeded = (prepared.task.treatment)
        .is_some_and(|treatment| treatment.exceeds_limit([(&prediction.particles, 1.0)], target));
    match target - prediction.performance.ratio() {
        missing if missing > 0.0 => format!(
            "{}: {what} is predicted to fall short by {:.1} points in one round",
            percent(target),
            100.0 * missing
        ),
        _ if is_exceeded => format!(
            "{}: {what} is predicted to reach it, but more than {} of the points have more passes than polish.max_passes",
            percent(target),
            percent(1.0 - target)
        ),
        _ if prepared.task.interaction.reaction_probability() < target => format!(
            "{}: {what} is predicted to reach it only if more particles react",
            percent(target)
        ),
        _ => format!("{}, which {what} is predicted to reach", percent(target)),
    }
}

fn describe_action(prepared: &LoadedTask) -> String {
    let task = &prepared.task;
    let (surface, tool, medium) = (&task.surface.name, &task.tool.name, &task.medium);
    format!(
        "{} (seed {})",
        match task.action {
            Action::Polish => format!("polish {surface} with {tool} and {medium}"),
            Action::Dispense => format!("coat {surface} with {medium} from {tool}"),
            action => format!("{action} {medium} from {surface} with {tool}"),
        },
        prepared.run.plan.seed
    )
}

fn describe_surface(task: &Task) -> String {
    let outline = &task.surface.outline;
    let size = Bounds2::from_points(outline.outer().iter().copied())
        .map_or_else(String::new, |b| {
            format!("{:.3} x {:.3} m, ", b.size().x, b.size().y)
        });
    let at = task.surface.world_from_surface.translation.vector;
    let shape = match &task.surface.shape {
        SurfaceShape::Plane => String::new(),
        SurfaceShape::Cylinder { radius, axis } => format!(
            ", rolled onto a cylinder of radius {radius} m whose axis is at {:.0}° to x",
            axis.to_degrees()
        ),
        SurfaceShape::Cone(cone) => format!(
            ", rolled onto a cone of radius {} m and half angle {:.0}° that widens at {:.0}° to x",
            cone.radius,
            cone.half_angle.to_degrees(),
            cone.axis.to_degrees()
        ),
        shape @ SurfaceShape::Mesh(_) => format!(", {}", ShapeRecord::from(shape)),
    };
    let edges = match task.surface.skim_edges.len() {
        0 => "no skim edge".to_owned(),
        1 => format!("skim edge {}", task.surface.skim_edges[0]),
        _ => {
            let edges = task.surface.skim_edges.iter().map(ToString::to_string);
            format!("skim edges {}", edges.collect::<Vec<_>>().join(", "))
        }
    };
    format!(
        "{}, {size}{:.3} m2{shape}, at ({:.3}, {:.3}, {:.3}) m in the world; {edges}",
        task.surface.name,
        outline.area(),
        drop_sign_of_zero(at.x),
        drop_sign_of_zero(at.y),
        drop_sign_of_zero(at.z)
    )
}

/// Returns a number that prints without the sign of a zero, to a millimetre.
fn drop_sign_of_zero(number: f64) -> f64 {
    if number.abs() < 5e-4 { 0.0 } else { number }
}

fn describe_tool(task: &Task) -> String {
    let tool = &task.tool;
    format!(
        "{}, contact area {:.1} cm2 in {}; area of effect {:.3} m along and {:.3} m across the motion; collision radius r_s = {:.4} m",
        tool.name,
        1e4 * tool.footprint.area(),
        format_count(tool.footprint.polygons().len(), "piece"),
        tool.area_of_effect.x,
        tool.area_of_effect.y,
        tool.collision_radius()
    )
}

fn obstacles(free_area: &FreeArea) -> String {
    if free_area.obstacles.is_empty() {
        return "none near the surface".to_owned();
    }
    let mut listed: Vec<String> = free_area
        .obstacles
        .iter()
        .take(LISTED)
        .map(|(name, kept)| format!("{name} (blocks {:.0} %)", 100.0 * kept))
        .collect();
    if free_area.obstacles.len() > LISTED {
        listed.push(format!("{} more", free_area.obstacles.len() - LISTED));
    }
    listed.join(", ")
}

fn describe_destination(plan: &Plan) -> String {
    match plan.graph.goal {
        GoalState::Absorbed => "all particles are absorbed".to_owned(),
        GoalState::Collected { center, radius } => format!(
            "all particles lie within {radius:.4} m of ({:.3}, {:.3}) m on the surface",
            center.x, center.y
        ),
        GoalState::Polished { passes } => {
            format!(
                "the tool has passed every point {}",
                format_count(passes as usize, "time")
            )
        }
        GoalState::Dispensed {
            thickness,
            per_pass,
        } => format!(
            "a coat of {:.4} mm covers every point, {:.4} mm per pass",
            1e3 * thickness,
            1e3 * per_pass
        ),
        GoalState::Skimmed => {
            let goals = plan.graph.nodes.iter();
            let goals = goals.filter(|node| node.role == NodeRole::Goal).count();
            format!(
                "all particles are pushed over a skim edge ({} beyond it)",
                format_count(goals, "goal node")
            )
        }
    }
}
