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
    names.sort_unstable();
    names.dedup();
    let mut alike = BTreeMap::new();
    let titled = |name: &str| {
        let id = catalogue.find(name.strip_prefix("semco:")?)?;
        Some((name.to_owned(), title(catalogue, id, &mut alike)))
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
/// order of time, or the class outside of rounds. `alike`: cache of the individuals by round and
/// class, in the order of time.
fn title<'a>(
    catalogue: &'a Catalogue,
    id: IndividualId,
    alike: &mut BTreeMap<(String, &'a str), Vec<IndividualId>>,
) -> String {
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
    let same = alike
        .entry((format!("{} {count}", row.id), class))
        .or_insert_with(|| {
            let mut same: Vec<IndividualId> = (row.first..row.first + row.len)
                .filter(|&other| catalogue.class(other) == class)
                .filter(|&other| round_of(catalogue, other) == Some(round))
                .collect();
            let start =
                |id: &IndividualId| catalogue.interval(*id).map_or(f64::NAN, |[from, _]| from);
            same.sort_by(|a, b| start(a).total_cmp(&start(b)));
            same
        });
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

#[cfg(test)]
mod tests {
    use super::titles;
    use crate::ask::{Answers, Term};
    use crate::{Catalogue, EPISODE_SCHEMA, EpisodeRecord, Individual, Origin, Value};

    const ID: &str = "20261122-010000-abcd";

    fn individual(class: &str, parent: Option<usize>, start: f64) -> Individual {
        Individual {
            class: format!("semco:{class}"),
            interval: Some([start, start + 1.0]),
            parent,
            relations: [].into(),
            values: [].into(),
        }
    }

    #[test]
    fn titles_are_those_of_the_timeline() {
        let mut individuals = vec![
            individual("WipingEpisode", None, 0.0),
            individual("WipingAction", Some(0), 0.0),
            individual("WipingRound", Some(1), 0.0),
            individual("Approach", Some(2), 0.0),
            individual("Stroke", Some(2), 1.0),
            individual("HumanCollision", Some(4), 3.0),
            individual("HumanCollision", Some(4), 2.0),
            individual("WipingRound", Some(1), 5.0),
            individual("HumanCollision", Some(7), 6.0),
        ];
        for (place, property, value) in [
            (2, "semco:round", 1.0),
            (7, "semco:round", 2.0),
            (4, "semco:stroke", 2.0),
        ] {
            individuals[place].values = [(property.to_owned(), Value::Number(value))].into();
        }
        let names: Vec<String> = (individuals.iter().enumerate())
            .map(|(place, one)| format!("{}_{ID}-{place}", one.class))
            .collect();
        let catalogue = Catalogue::from_records(&[EpisodeRecord {
            schema: EPISODE_SCHEMA,
            id: ID.to_owned(),
            task: "board".to_owned(),
            interval: [0.0, 10.0],
            origin: Origin::Simulated,
            program: "test".to_owned(),
            seed: 1,
            rounds: vec![0.0, 5.0],
            individuals,
        }]);
        let listed = names.iter().cloned().map(Term::Atom).collect();
        let answers = Answers {
            rows: vec![vec![Term::List(listed), Term::atom("semco:sponge")]],
            ..Answers::default()
        };
        let found = titles(&answers, None, &catalogue);
        let found: Vec<&str> = names.iter().map(|name| &*found[name]).collect();
        assert_eq!(
            found,
            [
                "wiping episode",
                "wiping action",
                "round 1",
                "round 1, approach",
                "round 1, stroke 3",
                "round 1, human collision 2",
                "round 1, human collision 1",
                "round 2",
                "round 2, human collision",
            ]
        );
    }
}
