//! `wisch robot check`: finds missing or inconsistent data in a robot's URDF and SRDF.

mod findings;
mod start;

use self::findings::FindingGroup;
use self::start::{check_chain, check_start};
use super::words::format_count;
use crate::args::{GlobalArgs, RobotCheckArgs};
use crate::failure::Failure;
use crate::terminal::{Outcome, print};
use serde::Serialize;
use std::path::{Path, PathBuf};
use wisch::follow::{MountSource, PlanningGroup, StartAssumption};
use wisch::represent::Mount;
use wisch::robot::{
    Appearance, Diagnostic, DiagnosticKind, LinkAxis, READY_STATE, RobotModel, Severity, Srdf,
    Subject, check, urdf_on_base,
};
use wisch::source_location::Place;
use wisch_io::{read_text, robot_meshes};

/// The schema of the object that `--json` prints.
const SCHEMA: u32 = 1;

/// The object that `--json` prints.
#[derive(Debug, Serialize)]
struct CheckRecord<'a> {
    format: &'static str,
    schema: u32,
    file: String,
    /// Null without an SRDF, or if the robot cannot be loaded.
    srdf: Option<String>,
    /// Null if the robot cannot be loaded from the file.
    robot: Option<RobotRecord<'a>>,
    errors: usize,
    warnings: usize,
    notes: usize,
    findings: Vec<FindingRecord<'a>>,
}

#[derive(Debug, Serialize)]
struct RobotRecord<'a> {
    name: &'a str,
    links: usize,
    joints: usize,
    /// Names of the independent joints, in the order of the robot's variables.
    variables: Vec<&'a str>,
    mass_kg: f64,
}

#[derive(Debug, Serialize)]
struct FindingRecord<'a> {
    severity: &'static str,
    fault: &'static str,
    /// The URDF or the SRDF.
    file: &'a str,
    line: usize,
    column: usize,
    link: Option<&'a str>,
    joint: Option<&'a str>,
    value: &'a str,
    limit: &'a str,
    advice: &'a str,
}

/// Reads the URDF and its SRDF, and reports on them.
pub fn check_robot(args: &RobotCheckArgs, global: &GlobalArgs) -> Result<Outcome, Failure> {
    let srdf_text = match srdf_of(args) {
        Some(path) => Some((path.display().to_string(), read_text(&path)?)),
        None => None,
    };
    let text = read_text(&args.file)?;
    let text =
        (srdf_text.as_ref()).map_or_else(|| text.clone(), |(_, srdf)| urdf_on_base(&text, srdf));
    let name = args.file.display().to_string();
    let mut meshes = robot_meshes(&args.file, &args.packages);
    let mut findings = check(&name, &text, &mut meshes).map_err(Failure::new)?;
    let robot = if count(&findings, Severity::Error) == 0 {
        let read = RobotModel::from_urdf(&name, &text, &mut meshes);
        Some(read.map_err(Failure::new)?)
    } else {
        None
    };
    if let Some(robot) = &robot {
        let looks = Appearance::from_urdf(&name, &text, robot, &mut meshes);
        findings.extend_from_slice(looks.map_err(Failure::new)?.diagnostics());
        findings.sort_by_key(|found| (found.at.line, found.at.column));
    }
    let srdf = match (&robot, srdf_text) {
        (Some(robot), Some((name, text))) => {
            findings.extend(Srdf::check(&name, &text, robot));
            findings.extend(assumed_start(&name, &text, robot));
            findings.extend(check_start(&name, &text, robot)?);
            Some(name)
        }
        _ => None,
    };
    if let Some(robot) = &robot {
        findings.extend(check_chain(&name, &text, robot, srdf.as_deref())?);
    }
    let (errors, warnings) = (
        count(&findings, Severity::Error),
        count(&findings, Severity::Warning),
    );
    if args.json {
        let record = CheckRecord {
            format: "wisch-robot-check",
            schema: SCHEMA,
            file: name.clone(),
            srdf: srdf.clone(),
            robot: robot.as_ref().map(RobotRecord::new),
            errors,
            warnings,
            notes: count(&findings, Severity::Note),
            findings: findings.iter().map(FindingRecord::new).collect(),
        };
        let line = serde_json::to_string(&record).map_err(|error| {
            Failure::new(format!("the report cannot be written as JSON: {error}"))
        })?;
        print(&(line + "\n"))?;
    } else if !global.quiet {
        let wipes = match &robot {
            Some(robot) if errors == 0 => describe_group(robot, srdf.as_deref())?,
            _ => String::new(),
        };
        print(&report(
            &name,
            robot.as_ref(),
            srdf.as_deref(),
            &wipes,
            &findings,
        ))?;
    }
    match (errors, warnings) {
        (0, 0) => Ok(Outcome::Done),
        (0, _) => Ok(Outcome::GoalNotMet),
        _ => Err(Failure::new(match srdf {
            Some(srdf) => format!(
                "{srdf}: the SRDF cannot be used: {}",
                format_count(errors, "error")
            ),
            None => format!(
                "{name}: the robot cannot be loaded: {}",
                format_count(errors, "error")
            ),
        })),
    }
}

/// Reads the SRDF of a robot.
fn read_srdf(path: &str, robot: &RobotModel) -> Result<Srdf, Failure> {
    let text = read_text(Path::new(path))?;
    Srdf::parse(path, &text, robot).map_err(Failure::new)
}

/// Describes the group that wipes by default, how it holds a tool, and which joints it leaves where they are.
fn describe_group(robot: &RobotModel, srdf: Option<&str>) -> Result<String, Failure> {
    let srdf = srdf.map(|path| read_srdf(path, robot)).transpose()?;
    let group = PlanningGroup::choose(robot, srdf.as_ref(), None).map_err(Failure::new)?;
    let [base, tip] = [group.base, group.tip].map(|link| &robot.links()[link.index()].name);
    let mut text = format!("  wipes with the chain from {base:?} to {tip:?}\n");
    let (mount, source) = group.mount(srdf.as_ref());
    let holder = srdf.as_ref().and_then(|srdf| srdf.tool_holder(group.tip));
    let axis = holder.map_or_else(LinkAxis::default, |holder| holder.axis);
    let how = match mount {
        Mount::Hand { lean } => format!("by the rear edge, leaning back by {lean:.2} rad"),
        _ => format!("square on the {axis} axis of {tip:?}"),
    };
    let origin = match source {
        MountSource::Assumed => "assumed",
        _ => "from the SRDF",
    };
    text += &format!(
        "  holds a tool {how} ({origin}), unless the task's [tool.mount] or the tool's grip says otherwise\n"
    );
    let held = group.held_joints(robot);
    if !held.is_empty() {
        let joints = held.join(", ");
        text += &format!("  holds {joints} at their ready positions: they are not in the group\n");
    }
    if srdf.is_none()
        && let Some(assumed) = StartAssumption::find(robot, None)
    {
        text += &format!("  assumes that motions begin {}\n", assumed.begins);
    }
    Ok(text)
}

/// Returns a note if the SRDF has no state named "ready", or one that leaves out joints.
fn assumed_start(name: &str, text: &str, robot: &RobotModel) -> Option<Diagnostic> {
    let srdf = Srdf::parse(name, text, robot).ok()?;
    let StartAssumption { lacks, begins } = StartAssumption::find(robot, Some(&srdf))?;
    Some(Diagnostic {
        severity: Severity::Note,
        at: Place::from_offset(name, text, 0),
        subject: Subject::Robot,
        kind: DiagnosticKind::Srdf,
        value: lacks,
        limit: format!(
            "a <group_state name=\"{READY_STATE}\"> of all joints, in which motions begin and end"
        ),
        advice: format!("add it; without it, motions begin {begins}"),
    })
}

/// Returns the SRDF of `--srdf`, else the file beside the URDF.
fn srdf_of(args: &RobotCheckArgs) -> Option<PathBuf> {
    let beside = || Some(args.file.with_extension("srdf")).filter(|path| path.is_file());
    args.srdf.clone().or_else(beside)
}

fn count(findings: &[Diagnostic], severity: Severity) -> usize {
    findings.iter().filter(|f| f.severity == severity).count()
}

impl<'a> RobotRecord<'a> {
    fn new(robot: &'a RobotModel) -> Self {
        Self {
            name: robot.name(),
            links: robot.links().len(),
            joints: robot.joints().len(),
            variables: (0..robot.dof())
                .map(|i| robot.variable(i).name.as_str())
                .collect(),
            mass_kg: sum_masses(robot),
        }
    }
}

impl<'a> FindingRecord<'a> {
    fn new(finding: &'a Diagnostic) -> Self {
        let (link, joint) = match &finding.subject {
            Subject::Link(name) => (Some(name.as_str()), None),
            Subject::Joint(name) => (None, Some(name.as_str())),
            Subject::Robot => (None, None),
        };
        Self {
            severity: finding.severity.as_str(),
            fault: finding.kind.as_str(),
            file: &finding.at.file,
            line: finding.at.line,
            column: finding.at.column,
            link,
            joint,
            value: &finding.value,
            limit: &finding.limit,
            advice: &finding.advice,
        }
    }
}

fn sum_masses(robot: &RobotModel) -> f64 {
    let bodies = robot.links().iter().filter_map(|link| link.body);
    bodies.fold(0.0, |sum, body| sum + body.mass)
}

fn report(
    name: &str,
    robot: Option<&RobotModel>,
    srdf: Option<&str>,
    wipes: &str,
    findings: &[Diagnostic],
) -> String {
    let mut text = match robot {
        Some(robot) => format!(
            "{}: {}, {}, {}, {:.1} kg\n",
            robot.name(),
            format_count(robot.links().len(), "link"),
            format_count(robot.joints().len(), "joint"),
            format_count(robot.dof(), "variable"),
            sum_masses(robot)
        ),
        None => format!("{name}\n"),
    };
    match (robot, srdf) {
        (Some(_), Some(srdf)) => text += &format!("  with {srdf}\n"),
        (Some(_), None) => {
            text += "  no SRDF: the first arm wipes, and there is no \"ready\" state\n"
        }
        (None, _) => {}
    }
    text += wipes;
    for group in FindingGroup::all(findings) {
        text += &format!("  {:<8} {group}\n", group.severity().as_str());
    }
    if findings.is_empty() {
        text += match srdf {
            Some(_) => "  no findings\n",
            None => {
                "  no findings in the URDF; wisch robot setup writes an SRDF, and checks the robot further\n"
            }
        };
    }
    text
}
