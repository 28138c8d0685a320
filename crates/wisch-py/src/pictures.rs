//! Pictures of plans and predictions, and tables of rounds.

use wisch::plan::{Plan, predict};
use wisch::represent::Task;
use wisch::run::Round;
use wisch_report::{EffectFrames, ReportInput, pictures};

/// Names of a plan's pictures.
pub const NAMES: [&str; 4] = ["before-after", "graph", "density", "effect-over-time"];

/// Returns a picture of a plan by its name, as SVG; `bandwidth` of the density in [m].
pub fn draw(name: &str, task: &Task, plan: &Plan, bandwidth: Option<f64>) -> String {
    let mut frames = EffectFrames::new(task, plan);
    let prediction = predict(task, plan, |progress| frames.record(progress));
    let all = pictures(&ReportInput {
        title: &task.name,
        task,
        plan,
        prediction: &prediction,
        frames: &frames,
        bandwidth,
        motion: None,
        rounds: None,
    });
    let named = all.into_iter().find(|(stem, _)| stem == name);
    named.map_or_else(String::new, |(_, svg)| svg)
}

/// Returns rounds as an HTML table.
pub fn table(task: &str, rounds: &[&Round], verdict: Option<&str>) -> String {
    let percent = |share: f64| format!("{:.0} %", 100.0 * share);
    let mut html = format!(
        "<table><caption>{}: {}</caption><tr><th>round</th><th>strokes</th><th>predicted</th>\
         <th>estimated</th><th>90 % interval</th><th>duration</th><th>ending</th><th>verdict</th></tr>",
        escape(task),
        verdict.unwrap_or("not finished")
    );
    for round in rounds {
        let estimate = &round.interpretation.performance;
        html.push_str(&format!(
            "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{} to {}</td><td>{:.1} s</td>\
             <td>{}</td><td>{}</td></tr>",
            round.motion.number,
            round.motion.followed.strokes.len(),
            percent(round.motion.prediction.performance.ratio()),
            percent(estimate.mean),
            percent(estimate.low),
            percent(estimate.high),
            round.execution.duration,
            round.execution.ending.as_str(),
            round.verdict.as_str()
        ));
    }
    html + "</table>"
}

fn escape(text: &str) -> String {
    let text = text.replace('&', "&amp;");
    text.replace('<', "&lt;").replace('>', "&gt;")
}
