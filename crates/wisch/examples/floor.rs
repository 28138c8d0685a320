//! A floor around an arm, wiped with a round pad. It compares the joint movement in three cases:
//! the tool turned as planned, its yaw chosen by the robot, and the order of places chosen by the
//! robot as well.
//!
//! ```text
//! cargo run --release --package wisch --example floor -- [--bandwidth M] [--pad M] [--strategy NAME] [--tool NAME] \
//!     [--targets FILE.csv] [--urdf FILE --tip LINK --hand-height M]
//! ```
//!
//! Without a file, targets are 50 mm apart around the shipped arm of seven joints, from 0.3 to 0.72
//! m off its foot. A CSV file has a target's x and y in each row [m], or columns named
//! `target-POS_X`, `target-POS_Y` and `target-POS_Z`, like the files of arm_coverage; they are in
//! the frame of the robot's root. Another robot needs a URDF, the link whose frame is moved to the
//! targets with its z axis down, and the height of that frame above the floor, where the pad is
//! [m]. Meshes are searched beside the URDF.
//!
//! `passed` is the share of targets over whose centre the pad's centre passes within 1 mm; `faults`
//! are the faults of the audit.

use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};
use std::path::Path;
use std::time::Instant;
use wisch::follow::{FollowConfig, Workcell, WorkcellConfig, audit, follow};
use wisch::geometry::{Mesh, Point2, Polygon, Pose, Region, Vector2, Vector3};
use wisch::plan::{CoverageStrategy, Plan, PlanConfig, YawRule, plan, predict};
use wisch::represent::{Action, ParticleDistribution, SceneObject, ScenePart, Surface, Task, Tool};
use wisch::robot::{RobotModel, Srdf};
use wisch_testkit::{AnyError, arm7, interaction, sponge};

/// Distance between targets [m].
const PITCH: f64 = 0.05;
/// Radius of the pad [m]: it covers a square of the pitch.
const PAD: f64 = 0.036;
/// Height of the pad in the hand of the shipped arm, and in that of another robot [m].
const THICKNESS: [f64; 2] = [0.05, 0.015];
/// Range of the distance of the targets from the foot of the arm [m].
const REACH: [f64; 2] = [0.3, 0.72];
/// Distance within which a centre counts as passed [m].
const PASSED: f64 = 1e-3;

fn main() -> Result<(), AnyError> {
    let options = options()?;
    let number = |name: &str| {
        options
            .get(name)
            .map(|text| text.parse::<f64>())
            .transpose()
    };
    let pad = number("pad")?.unwrap_or(PAD);
    let (targets, height) = match options.get("targets") {
        Some(path) => read(path)?,
        None => (ring(), 0.0),
    };
    let hand_height = number("hand-height")?.unwrap_or(0.0);
    let thickness = THICKNESS[usize::from(options.contains_key("urdf"))];
    let task = floor(&targets, [pad, thickness], height - hand_height)?;
    let cell = match options.get("urdf") {
        None => {
            let robot = arm7();
            let config = WorkcellConfig::default();
            Workcell::new(robot.model, Some(&robot.srdf), &task, &config)?
        }
        Some(urdf) => {
            let tip = options.get("tip").ok_or("--urdf needs --tip LINK")?;
            cell_of(urdf, tip, hand_height, &task)?
        }
    };
    println!("{} targets, a pad of {} mm", targets.len(), 2e3 * pad);
    println!(
        "{:8} {:10} {:>7} {:>7} {:>6} {:>9} {:>8} {:>7} {:>6} {:>6} {:>6}",
        "plan",
        "tool",
        "contact",
        "in all",
        "lifts",
        "abandoned",
        "covered",
        "passed",
        "faults",
        "exec s",
        "comp s"
    );
    for strategy in CoverageStrategy::ALL {
        let is_asked = |name: &str, value: &str| options.get(name).is_none_or(|all| all == value);
        if !is_asked("strategy", strategy.as_str()) {
            continue;
        }
        for (tool, yaw, [free_yaw, free_order]) in [
            ("blended", YawRule::Blended, [false, false]),
            ("best", YawRule::Best, [false, false]),
            ("free-yaw", YawRule::Best, [true, false]),
            ("free-order", YawRule::Best, [true, true]),
        ] {
            if !is_asked("tool", tool) {
                continue;
            }
            let begin = Instant::now();
            let config = PlanConfig {
                strategy: strategy.into(),
                yaw,
                bandwidth: number("bandwidth")?,
                ..PlanConfig::default()
            };
            let plan = plan(&task, &config)?;
            let config = FollowConfig {
                free_yaw,
                free_order,
                ..FollowConfig::default()
            };
            let followed = follow(&task, &plan, &cell, None, &config, &mut |_| ())?;
            let seconds = begin.elapsed().as_secs_f64();
            let wiped = Plan {
                strokes: followed.strokes.clone(),
                ..plan.clone()
            };
            let [contact, all] = followed.joint_movement(cell.arm_variables());
            println!(
                "{:8} {tool:10} {contact:7.1} {all:7.1} {:6} {:9} {:7.1}% {:6.1}% {:6} {:6.1} {seconds:6.2}",
                strategy.to_string(),
                followed.strokes.len(),
                followed.abandoned.len(),
                100.0 * predict(&task, &wiped, |_| ()).performance.ratio(),
                100.0 * passed(&targets, &wiped),
                audit(&followed, &cell, &task, &config)?.faults.len(),
                followed.duration(),
            );
        }
    }
    Ok(())
}

/// Returns the values of the flags; each flag has one.
fn options() -> Result<BTreeMap<String, String>, AnyError> {
    const FLAGS: [&str; 8] = [
        "bandwidth",
        "pad",
        "strategy",
        "tool",
        "targets",
        "urdf",
        "tip",
        "hand-height",
    ];
    let mut options = BTreeMap::new();
    let mut arguments = std::env::args().skip(1);
    while let Some(flag) = arguments.next() {
        let known = flag.strip_prefix("--").filter(|name| FLAGS.contains(name));
        let name = known.ok_or_else(|| format!("{flag}: not one of --{}", FLAGS.join(", --")))?;
        let value = arguments
            .next()
            .ok_or_else(|| format!("{flag} needs a value"))?;
        options.insert(name.to_owned(), value);
    }
    Ok(options)
}

/// Targets in the plane, and their height [m].
fn read(path: &str) -> Result<(Vec<Point2>, f64), AnyError> {
    let text = std::fs::read_to_string(path).map_err(|error| format!("{path}: {error}"))?;
    let header: Vec<&str> = text.lines().next().unwrap_or_default().split(',').collect();
    let column = |name: &str| header.iter().position(|title| title.trim() == name);
    let [x, y, z] = ["X", "Y", "Z"].map(|axis| column(&format!("target-POS_{axis}")));
    let (x, y) = (x.unwrap_or(0), y.unwrap_or(1));
    let row = |line: &str| -> Option<(Point2, f64)> {
        let fields: Vec<&str> = line.split(',').map(str::trim).collect();
        let number = |column: usize| fields.get(column)?.parse::<f64>().ok();
        Some((
            Point2::new(number(x)?, number(y)?),
            z.map_or(Some(0.0), number)?,
        ))
    };
    let rows: Vec<(Point2, f64)> = text.lines().filter_map(row).collect();
    let height = rows.first().ok_or_else(|| format!("{path}: no targets"))?.1;
    if rows.iter().any(|(_, other)| (other - height).abs() > 1e-6) {
        return Err(format!("{path}: the targets are not at one height").into());
    }
    Ok((rows.into_iter().map(|(place, _)| place).collect(), height))
}

/// Returns a robot that holds the pad at a distance beyond a link's frame, along its z axis [m].
fn cell_of(urdf: &str, tip: &str, hand_height: f64, task: &Task) -> Result<Workcell, AnyError> {
    let text = std::fs::read_to_string(urdf).map_err(|error| format!("{urdf}: {error}"))?;
    let folder = Path::new(urdf).parent().unwrap_or(Path::new(""));
    let robot = RobotModel::from_urdf(urdf, &text, &mut |file| {
        std::fs::read(folder.join(file)).map_err(|error| error.to_string())
    })?;
    let root = &robot.links()[robot.root().index()].name;
    let group = format!(
        r#"<robot name="r"><group name="arm"><chain base_link="{root}" tip_link="{tip}"/></group></robot>"#
    );
    let srdf = Srdf::parse("the group of --tip", &group, &robot)?;
    let down = nalgebra::UnitQuaternion::from_euler_angles(PI, 0.0, 0.0);
    let config = WorkcellConfig {
        tip_from_tool: Some(Pose::from_parts([0.0, 0.0, hand_height].into(), down)),
        ..WorkcellConfig::default()
    };
    Ok(Workcell::new(robot, Some(&srdf), task, &config)?)
}

/// Returns the share of the targets over whose centre the pad's centre passes [1].
fn passed(targets: &[Point2], plan: &Plan) -> f64 {
    let distance = |target: &Point2| {
        let motions = plan.strokes.iter().flat_map(|stroke| stroke.motions());
        let distances = motions.map(|motion| {
            let (from, way) = (
                motion.from.position,
                motion.to.position - motion.from.position,
            );
            let along = (target - from).dot(&way) / way.norm_squared().max(f64::MIN_POSITIVE);
            (from + way * along.clamp(0.0, 1.0) - target).norm()
        });
        distances.fold(f64::INFINITY, f64::min)
    };
    let passed = targets.iter().filter(|target| distance(target) <= PASSED);
    passed.count() as f64 / targets.len() as f64
}

fn ring() -> Vec<Point2> {
    let most = (REACH[1] / PITCH) as i32;
    let all = (-most..=most).flat_map(|i| (-most..=most).map(move |j| [i, j]));
    all.map(|[i, j]| Point2::new(PITCH * f64::from(i), PITCH * f64::from(j)))
        .filter(|place| (REACH[0]..=REACH[1]).contains(&place.coords.norm()))
        .collect()
}

/// Returns the task of wiping the targets with a pad of this radius and thickness, on a floor at
/// this height in the world [m].
fn floor(targets: &[Point2], [pad, thickness]: [f64; 2], height: f64) -> Result<Task, AnyError> {
    let reach = targets
        .iter()
        .map(|place| place.coords.amax())
        .fold(0.0, f64::max)
        + 2.0 * pad;
    let corner = |i: usize| {
        let angle = TAU * i as f64 / 32.0;
        Point2::new(pad * libm::cos(angle), pad * libm::sin(angle))
    };
    let mesh = Mesh::cylinder(pad, thickness, 32)?;
    Ok(Task {
        name: "floor".into(),
        action: Action::Absorb,
        surface: Surface {
            name: "floor".into(),
            world_from_surface: Pose::translation(0.0, 0.0, height),
            skim_edges: Vec::new(),
            shape: Default::default(),
            outline: Polygon::rectangle(Vector2::new(2.0 * reach, 2.0 * reach)),
        },
        scene: vec![SceneObject {
            name: "floor".into(),
            part: ScenePart::Carrier,
            mesh: Mesh::cuboid(Vector3::new(2.0 * reach, 2.0 * reach, 0.02))?,
            world_from_object: Pose::translation(0.0, 0.0, height - 0.01),
        }],
        tool: Tool {
            name: "pad".into(),
            mesh: mesh.transform(&Pose::translation(0.0, 0.0, thickness / 2.0)),
            footprint: Region::new(vec![Polygon::new(
                (0..32).map(corner).collect(),
                Vec::new(),
            )]),
            area_of_effect: Vector2::new(2.0 * pad, 2.0 * pad),
            ..sponge()
        },
        medium: "dust".into(),
        interaction: interaction(),
        particles: ParticleDistribution::new(targets)?,
        collect_goal: None,
        treatment: None,
        mobility: Default::default(),
        tool_start: targets.first().copied().unwrap_or_else(Point2::origin),
        seed: 1,
    })
}
