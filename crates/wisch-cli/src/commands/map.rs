//! `wisch robot map`: computes the capability map of a robot's arm.

use crate::args::{GlobalArgs, RobotMapArgs};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::terminal::{Outcome, print, print_json, remark};
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::time::Instant;
use wisch::follow::PlanningGroup;
use wisch::geometry::Pose;
use wisch::robot::{CapabilityMap, CollisionModel, MapConfig, MapError, MapRequest, MapStage};
use wisch_io::OutputFile;
use wisch_io::{MAP_EXTENSION, Robot, RobotDescription, robot_warnings};

/// The schema of the object that `--json` prints.
const SCHEMA: u32 = 1;
/// Clearance that a posture must keep to count as collision-free [m].
const MARGIN: f64 = 5e-3;

/// The object that `--json` prints.
#[derive(Debug, Serialize)]
struct MapRecord {
    format: &'static str,
    schema: u32,
    robot: String,
    base: String,
    tip: String,
    voxel_m: f64,
    voxels: [usize; 3],
    directions: usize,
    samples: u64,
    bytes: usize,
    build_time_s: f64,
    out: String,
}

/// Builds the map and writes it.
pub fn map(args: &RobotMapArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let progress = Progress::start(global);
    progress.say("reading the robot");
    let description = Robot::description(&args.robot);
    // A path on the command line is relative to the working directory.
    let robot = Robot::read_without_map(&description, Path::new(""), &args.packages)?;
    for warning in robot_warnings(&robot.model) {
        progress.aside(|| remark(&warning));
    }
    let of_robot = |error| Failure::new(format!("{}: {error}", args.robot));
    let group = PlanningGroup::choose(&robot.model, robot.srdf.as_ref(), args.group.as_deref())
        .map_err(of_robot)?;
    let collisions =
        CollisionModel::new(&robot.model, robot.srdf.as_ref()).map_err(Failure::new)?;
    let chain = robot
        .model
        .chain(group.base, group.tip)
        .map_err(Failure::new)?;
    let collisions = collisions.with_variables(chain.variables());
    let tool = MapRequest {
        robot: &robot.model,
        base: group.base,
        tip: group.tip,
        tip_from_tool: Pose::identity(),
        posture: &group.ready,
    };
    let config = MapConfig {
        voxel: args.voxel_m,
        samples: args.samples,
        // Coarser than the default: half the file size and time, with the same agreement with inverse kinematics.
        frequency: 3,
        starts: 3,
        refinements: 2,
        ..MapConfig::default()
    };
    // The file comes before the long computation, so that a missing permission is reported at once.
    let out = out_file(args, &description, robot.model.name())?;
    let file = OutputFile::begin(&out)?;
    let start = Instant::now();
    let is_free = |q: &[f64]| matches!(collisions.collision(q, MARGIN), Ok(None));
    let built = CapabilityMap::build(&tool, is_free, &config, |stage, done, total| {
        let what = match stage {
            MapStage::Sampling => "random postures",
            MapStage::Spreading => "spreading to neighbouring cells",
            MapStage::Refining => "refining the boundary",
        };
        progress.say(format!("{what}: {done} of {total}"));
    })
    .map_err(|error| match error {
        MapError::Setting {
            field: "voxel",
            value,
            lower,
            upper,
        } => Failure::new(format!(
            "--voxel-m {value} is outside its limits: at least {lower} and at most {upper}"
        )),
        error => Failure::new(error),
    })?;
    let bytes = built.to_bytes();
    file.finish(&bytes)?;
    drop(progress);

    let (voxels, directions) = built.shape();
    let name = |link: wisch::robot::LinkId| robot.model.links()[link.index()].name.clone();
    let record = MapRecord {
        format: "wisch-robot-map",
        schema: SCHEMA,
        robot: robot.model.name().to_owned(),
        base: name(group.base),
        tip: name(group.tip),
        voxel_m: config.voxel,
        voxels,
        directions,
        samples: config.samples,
        bytes: bytes.len(),
        build_time_s: start.elapsed().as_secs_f64(),
        out: out.display().to_string(),
    };
    if args.json {
        print_json(&record)?;
    } else if !global.quiet {
        print(&in_words(&record))?;
    }
    Ok(Outcome::Done)
}

/// Returns the file of `--out`, else the file beside the URDF, where wisch finds the map automatically.
fn out_file(
    args: &RobotMapArgs,
    description: &RobotDescription,
    robot: &str,
) -> Result<PathBuf, Failure> {
    match (&args.out, description) {
        // The check prevents overwriting a task or a URDF by mistake.
        (Some(out), _) if out.extension().is_none_or(|e| e != MAP_EXTENSION) => {
            Err(Failure::new(format!(
                "{}: the file name of a capability map must end in .{MAP_EXTENSION}",
                out.display()
            )))
        }
        (Some(out), _) => Ok(out.clone()),
        (None, RobotDescription::Files { urdf, .. }) => {
            Ok(Path::new(urdf).with_extension(MAP_EXTENSION))
        }
        (None, RobotDescription::Named(_)) => Ok(PathBuf::from(format!("{robot}.{MAP_EXTENSION}"))),
    }
}

fn in_words(record: &MapRecord) -> String {
    let [x, y, z] = record.voxels;
    format!(
        "{}: reach of {} from {}\n  {:<12} {x} x {y} x {z} of {} m, {} directions each\n  {:<12} {:.1} s\n  {:<12} {} ({} kB)\n",
        record.robot,
        record.tip,
        record.base,
        "voxels",
        record.voxel_m,
        record.directions,
        "build time",
        record.build_time_s,
        "map",
        record.out,
        record.bytes.div_ceil(1000),
    )
}
