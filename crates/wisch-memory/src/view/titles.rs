//! Titles of individuals, as the page's timeline names them.

use super::{PlotData, View};
use crate::ask::{Answers, Term};
use crate::catalogue::{Catalogue, IndividualId, entries};
use crate::ontology::Ontology;
use std::collections::BTreeMap;

const ROUND: &str = "semco:WipingRound";

/// Returns the titles of the individuals that answers and diagrams name, by their names with prefix.
pub(super) fn titles(
    answers: &Answers,
    view: Option<&View>,
    catalogue: &Catalogue,
) -> BTreeMap<String, String> {
    let mut names = Vec::new();
    for term in answers.rows.iter().flatten() {
        collect_names(term, &mut names);
    }
    for plot in view.map_or(&[][..], |view| &view.plots) {
        match &plot.data {
            PlotData::Amounts(amounts) => names.extend(amounts.iter().map(|(name, _)| &**name)),
            PlotData::Spans(spans) => names.extend(spans.iter().map(|(name, _)| &**name)),
            PlotData::Points(_) => {}
        }
    }
    let titled = |name: &str| {
        let id = catalogue.find(name.strip_prefix("semco:")?)?;
        Some((name.to_owned(), title(catalogue, id)))
    };
    names.into_iter().filter_map(titled).collect()
}

fn collect_names<'a>(term: &'a Term, names: &mut Vec<&'a str>) {
    match term {
        Term::Atom(name) => names.push(name),
        Term::List(terms) | Term::Compound(_, terms) => {
            for term in terms {
                collect_names(term, names);
            }
        }
        _ => {}
    }
}

/// Returns the title of an individual: "round 2, stroke 3" with the number of the plan, "round 2, tool contact 5" in the
/// order of time, or the class outside of rounds.
fn title(catalogue: &Catalogue, id: IndividualId) -> String {
    let class = catalogue.class(id);
    let label = Ontology::load().term(class).map(|term| &*term.label);
    let label = label.unwrap_or_else(|| class.strip_prefix("semco:").unwrap_or(class));
    let Some(round) = round_of(catalogue, id) else {
        return label.to_owned();
    };
    let number = |property: &str, id| Some(entries(catalogue.numbers(property), id).first()?.1);
    let Some(count) = number("semco:round", round) else {
        return label.to_owned();
    };
    if id == round {
        return format!("round {count}");
    }
    if let Some(stroke) = number("semco:stroke", id) {
        return format!("round {count}, stroke {}", stroke + 1.0);
    }
    let row = catalogue.episode_of(id);
    let mut same: Vec<IndividualId> = (row.first..row.first + row.len)
        .filter(|&other| catalogue.class(other) == class)
        .filter(|&other| round_of(catalogue, other) == Some(round))
        .collect();
    let start = |id: &IndividualId| catalogue.interval(*id).map_or(f64::NAN, |[from, _]| from);
    same.sort_by(|a, b| start(a).total_cmp(&start(b)));
    match same.iter().position(|&other| other == id) {
        Some(place) if same.len() > 1 => format!("round {count}, {label} {}", place + 1),
        _ => format!("round {count}, {label}"),
    }
}

/// Returns the round of an individual: itself, or one that contains it.
fn round_of(catalogue: &Catalogue, id: IndividualId) -> Option<IndividualId> {
    let mut above = std::iter::successors(Some(id), |&id| catalogue.parent(id));
    above.find(|&id| catalogue.class(id) == ROUND)
}
