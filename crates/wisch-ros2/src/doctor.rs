//! The doctor: what the robot reports, and what forbids a motion. It commands nothing.

use crate::commissioning::Commissioning;
use crate::connection::{Connection, SURVEY};
use crate::link::Vendor;
use crate::robot_file::RobotFile;
use crate::wrench_quality::assumptions;
use std::io::Write;

/// Width of the first column.
const WIDTH: usize = 22;

/// Prints what the robot reports. Returns whether nothing forbids a motion.
///
/// # Errors
/// If the robot is not found, or standard output is closed.
pub(crate) fn examine(file: RobotFile) -> Result<bool, String> {
    let connection = Connection::open(file, "wisch_doctor")?;
    let survey = connection.survey();
    let file = &connection.file;
    let mut out = std::io::stdout().lock();
    let mut line = |name: &str, text: String| {
        writeln!(out, "  {name:<WIDTH$} {text}").map_err(|error| error.to_string())
    };
    line("network", connection.link.network.to_string())?;
    line("joints", connection.names.join(", "))?;
    let rates = [
        (Some(&file.motion.joint_states), Some(survey.rates[0])),
        (file.force.topic.as_ref(), Some(survey.rates[1])),
        (file.motion.progress.as_ref(), None),
        (file.motion.scaling.as_ref(), None),
        (file.stop.safety.as_ref(), None),
        (file.stop.program.as_ref(), None),
    ];
    for (topic, rate) in rates {
        let Some(topic) = topic else {
            continue;
        };
        let rate = rate.map_or(String::new(), |rate| {
            format!("; {rate:.0} Hz over {} s", SURVEY.as_secs_f64())
        });
        line(topic, format!("{}{rate}", publishers(&connection, topic)))?;
    }
    let services = [
        Some(format!("{}/_action/send_goal", file.motion.action)),
        connection.tare.as_ref().map(|tare| tare.name().to_owned()),
        connection
            .force
            .as_ref()
            .map(|force| force.start.name().to_owned()),
    ];
    for service in services.into_iter().flatten() {
        let server = connection.link.server(&service);
        let vendor = server.map_or("no server".to_owned(), |server| {
            format!("served by {}", Vendor::from_guid(&server.guid))
        });
        line(&service, vendor)?;
    }
    for controller in connection
        .manager
        .list()
        .map_err(|error| error.to_string())?
    {
        let state = if controller.is_active {
            "active"
        } else {
            "inactive"
        };
        let claimed = controller.claimed.len();
        let text = format!("{state}, {}, claims {claimed} interfaces", controller.kind);
        line(&controller.name, text)?;
    }
    print_readings(&connection, &mut line)?;
    for text in assumptions(file, false) {
        line("assumed", text)?;
    }
    let mut faults = connection.faults(&survey);
    if connection.file.force.topic.is_some()
        && let Err(text) = Commissioning::read(&connection.file, &connection.frames)
    {
        faults.push(text);
    }
    for fault in &faults {
        line("refused", fault.clone())?;
    }
    if faults.is_empty() {
        line("refused", "nothing".to_owned())?;
    }
    Ok(faults.is_empty())
}

/// Describes who publishes a topic.
fn publishers(connection: &Connection, topic: &str) -> String {
    let found = connection.link.publishers(topic);
    let describe = |writer: &crate::link::DiscoveredWriter| {
        let reliability = if writer.is_reliable {
            "reliable"
        } else {
            "best effort"
        };
        let durability = if writer.is_latched { ", latched" } else { "" };
        let kind = writer.type_name.replace("::dds_::", "/").replace("::", "/");
        let kind = kind.trim_end_matches('_');
        format!(
            "{kind} of {}, {reliability}{durability}",
            Vendor::from_guid(&writer.guid)
        )
    };
    match &found[..] {
        [] => "no publisher".to_owned(),
        [one] => describe(one),
        several => {
            let all: Vec<String> = several.iter().map(describe).collect();
            format!("{} publishers: {}", several.len(), all.join("; "))
        }
    }
}

fn print_readings(
    connection: &Connection,
    line: &mut impl FnMut(&str, String) -> Result<(), String>,
) -> Result<(), String> {
    let readings = connection.readings.lock();
    if let Some(joints) = &readings.joints {
        let shown = |values: &[f64]| {
            let texts: Vec<String> = values.iter().map(|value| format!("{value:.3}")).collect();
            texts.join(" ")
        };
        line("positions [rad]", shown(&joints.positions))?;
        line("velocities [rad/s]", shown(&joints.velocities))?;
    }
    if let Some(wrench) = &readings.wrench {
        let [x, y, z] = wrench.force;
        line(
            "force [N]",
            format!("{x:.2} {y:.2} {z:.2} in the frame {:?}", wrench.frame),
        )?;
    }
    if let Some((_, scaling)) = readings.scaling {
        line("speed scaling", format!("{:.0} %", 100.0 * scaling))?;
    }
    Ok(())
}
