//! Units of a query's variables, from the predicates that bind them.

use crate::ontology::Ontology;

/// Unit of each argument of the predicates with numbers; empty for an argument without a unit. "share": from 0 to 1.
const UNITS: [(&str, &[&str]); 36] = [
    ("low_performance", &["", "share"]),
    ("low_performance_round", &["", "share"]),
    ("final_performance", &["", "share"]),
    ("goal_missed", &["", "share"]),
    ("wiping_time", &["", "s"]),
    ("performance_by_round", &["", "", "share"]),
    ("prediction_error", &["", "share"]),
    ("overconfident_prediction", &["", "share"]),
    ("uncertain_estimate", &["", "share"]),
    ("estimate_missed_truth", &["", "share", "share"]),
    ("peak_force_per_collision", &["", "N"]),
    ("hardest_collision", &["", "N"]),
    ("contact_share", &["", "share"]),
    ("poor_contact", &["", "share"]),
    ("contact_loss_near_edge", &["", "m"]),
    ("mean_force_per_stroke", &["", "N"]),
    ("weak_stroke", &["", "N"]),
    ("longest_contact", &["", "", "s"]),
    ("contact_time", &["", "s"]),
    ("landing", &["", "", "N"]),
    ("overload", &["", "", "N"]),
    ("vibration", &["", "", "N"]),
    ("hand_guiding", &["", "", "N"]),
    ("recovery_that_worked", &["", "", "share", "share"]),
    ("recovery_gain", &["", "share"]),
    ("relocalized", &["", "rad", "m"]),
    ("tilted_surface", &["", "rad"]),
    ("contact_force_drift", &["", "N per episode", "N", "N"]),
    ("localization_drift", &["", "m per episode", "m", "m"]),
    ("localization_change", &["", "", "m", "m"]),
    ("drift_cause", &["", "m", ""]),
    ("tool_wear", &["", "1 per episode", "N/m", "N/m"]),
    ("tool_performance", &["", "", "share", ""]),
    ("strategy_performance", &["", "share", ""]),
    ("surface_performance", &["", "share", ""]),
    ("sure_failure", &["", "share"]),
];
/// Predicates about a property: subject, property, value.
const STATEMENTS: [&str; 4] = ["triple", "holds", "owl_has", "rdf_has"];

/// Returns the unit of each variable, where the query passes it to a predicate whose unit is known.
pub(crate) fn units_of(query: &str, variables: &[String]) -> Vec<Option<String>> {
    let calls = calls(query);
    let unit = |variable: &String| {
        let of_call = |(name, arguments): &(&str, Vec<&str>)| {
            let place = arguments.iter().position(|argument| argument == variable)?;
            unit_of_argument(name, arguments, place)
        };
        calls.iter().find_map(of_call)
    };
    variables.iter().map(unit).collect()
}

fn unit_of_argument(name: &str, arguments: &[&str], place: usize) -> Option<String> {
    let of_channel = |channel: &str, value: usize| match channel.trim_matches('\'') {
        "force" | "vertical_force" if place == value => Some("N".to_owned()),
        "speed" if place == value => Some("m/s".to_owned()),
        _ => None,
    };
    match (name, arguments) {
        ("telemetry", [channel, _, _, _]) => of_channel(channel, 3),
        ("telemetry_in", [_, channel, _, _, _]) => of_channel(channel, 4),
        (_, [_, property, _]) if STATEMENTS.contains(&name) && place == 2 => {
            unit_of_property(&property.replace('\'', ""))
        }
        _ => {
            let (_, units) = UNITS.iter().find(|(known, _)| *known == name)?;
            let unit = units.get(place).filter(|unit| !unit.is_empty())?;
            (units.len() == arguments.len()).then(|| (*unit).to_owned())
        }
    }
}

/// Returns the unit that the comment of a property states in brackets; none for a count.
fn unit_of_property(name: &str) -> Option<String> {
    let comment = &Ontology::load().term(name)?.comment;
    let (unit, _) = comment.split_once('[')?.1.split_once(']')?;
    match unit {
        "1" => {
            let is_share = comment.contains("from 0 to 1") || comment.contains("semco:performance");
            is_share.then(|| "share".to_owned())
        }
        // Times are shown as date and time.
        "s since 1970" => None,
        unit => Some(unit.to_owned()),
    }
}

/// Returns names and arguments of all compound terms in a query, the outer ones first.
fn calls(query: &str) -> Vec<(&str, Vec<&str>)> {
    let mut calls = Vec::new();
    for (place, _) in query.match_indices('(') {
        let before = &query[..place];
        let is_text = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let name = before[before.trim_end_matches(is_text).len()..].trim_start();
        let is_known = STATEMENTS.contains(&name)
            || name.starts_with("telemetry")
            || UNITS.iter().any(|(known, _)| *known == name);
        if is_known {
            calls.push((name, arguments(&query[place + 1..])));
        }
    }
    calls
}

/// Returns the arguments up to the closing parenthesis.
fn arguments(text: &str) -> Vec<&str> {
    let (mut arguments, mut from) = (Vec::new(), 0);
    let (mut depth, mut is_quoted) = (0, false);
    for (at, c) in text.char_indices() {
        match c {
            '\'' => is_quoted = !is_quoted,
            _ if is_quoted => {}
            ',' | ')' if depth == 0 => {
                arguments.push(text[from..at].trim());
                from = at + 1;
                if c == ')' {
                    break;
                }
            }
            '(' | '[' => depth += 1,
            ')' | ']' => depth -= 1,
            _ => {}
        }
    }
    arguments
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ask::predicates;

    fn units(query: &str, variables: &[&str]) -> Vec<Option<String>> {
        let variables: Vec<String> = variables.iter().map(|name| (*name).to_owned()).collect();
        units_of(query, &variables)
    }

    fn unit(query: &str, variable: &str) -> String {
        units(query, &[variable]).remove(0).unwrap_or_default()
    }

    #[test]
    fn predicates_give_their_variables_units() {
        let query = "low_performance_round(Round, P), relocalized(Round, Tilt, Offset)";
        let found = units(query, &["Round", "P", "Tilt", "Offset", "Other"]);
        let found: Vec<_> = found.iter().map(Option::as_deref).collect();
        assert_eq!(found, [None, Some("share"), Some("rad"), Some("m"), None]);
        let query =
            "occurs(C, [S, E]), telemetry(force, [S, E], max, F), telemetry(speed, C, max, V)";
        assert_eq!(unit(query, "F"), "N");
        assert_eq!(unit(query, "V"), "m/s");
        assert_eq!(unit(query, "S"), "");
        assert_eq!(unit("telemetry(joint_1, C, max, V)", "V"), "");
        assert_eq!(unit("( weak_stroke('a,(b', F) ; true )", "F"), "N");
        // No predicate of this name has so many arguments.
        assert_eq!(unit("weak_stroke(S, F, X)", "F"), "");
    }

    #[test]
    fn properties_give_their_values_units() {
        assert_eq!(unit("triple(C, semco:peakForce, F)", "F"), "N");
        assert_eq!(unit("triple(C, semco:'peakForce', F)", "F"), "N");
        assert_eq!(unit("holds(R, semco:performance, P)", "P"), "share");
        assert_eq!(unit("triple(E, semco:seed, N)", "N"), "");
    }

    #[test]
    fn every_unit_is_of_a_predicate() {
        let known = predicates();
        for (name, units) in UNITS {
            let is_known = |arity| known.iter().any(|p| p.name == name && p.arity == arity);
            assert!(is_known(units.len()), "{name}/{}", units.len());
        }
    }
}
