//! Names that queries may use, for completion in the page, and example queries.

use serde_json::{Value, json};
use wisch_memory::Ontology;
use wisch_memory::ask::{ANNOTATIONS, builtins, predicates};
use wisch_memory::ontology::TermKind;

/// Example queries: the question, and the query.
pub const EXAMPLES: [(&str, &str); 11] = [
    (
        "The paper's Fig. 20: where was the sponge during each collision, and the robot in the middle of it?",
        "owl_individual_of(C, semco:'Collision'), occurs(C, [S, E]), M is 0.5*(S+E),\n\
         show(trajectory('sponge'), interval(S, E, dt(0.5))), show(justin:'justin_robot1', M)",
    ),
    (
        "Which rounds have a performance of 80 % or less?",
        "low_performance_round(Round, P)",
    ),
    (
        "When did a person push the robot, and during which motion?",
        "human_collision(Motion, C, [S, E])",
    ),
    (
        "What was the peak force of each collision?",
        "owl_individual_of(C, semco:'Collision'), occurs(C, [S, E]), telemetry(force, [S, E], max, F)",
    ),
    (
        "How did the performance change from round to round?",
        "performance_by_round(Action, Round, P)",
    ),
    (
        "What is the mean performance of each tool, as a chart?",
        "findall(_T, tool_performance(_T, _, _, _), Tools),\n\
         findall(_P, tool_performance(_, _, _P, _), Ps),\n\
         data_vis(barchart(tools), [data: [Tools, Ps], title: 'Mean performance by tool'])",
    ),
    (
        "Which strokes pressed with too little force?",
        "weak_stroke(Stroke, F)",
    ),
    (
        "Where was contact lost near an edge?",
        "contact_loss_near_edge(Loss, D), show(Loss)",
    ),
    (
        "In which rounds was there a localisation error?",
        "relocalized(Round, Tilt, Offset)",
    ),
    (
        "How long was the longest contact of the last episode?",
        "last_episode(Episode, _), longest_contact(Episode, C, Seconds), show(C)",
    ),
    (
        "Which notes did people add?",
        "holds(Thing, rdfs:comment, Note)",
    ),
];

/// Returns the whole vocabulary.
pub fn vocabulary() -> Value {
    let ontology = Ontology::load();
    let terms = |wanted: fn(TermKind) -> bool| {
        let found = ontology.terms().filter(move |(_, term)| wanted(term.kind));
        found
            .map(|(name, term)| json!({ "name": name, "label": term.label, "comment": term.comment }))
            .collect::<Vec<_>>()
    };
    let mut properties = terms(TermKind::is_property);
    let annotations = ANNOTATIONS.iter();
    properties.extend(
        annotations.map(|(name, comment)| json!({ "name": name, "label": "", "comment": comment })),
    );
    let predicates = predicates().into_iter().map(|predicate| {
        json!({
            "name": predicate.name,
            "arity": predicate.arity,
            "meaning": predicate.meaning,
        })
    });
    let examples = EXAMPLES.iter();
    let examples = examples.map(|(title, query)| json!({ "title": title, "query": query }));
    json!({
        "predicates": predicates.collect::<Vec<_>>(),
        "builtins": builtins(),
        "classes": terms(|kind| kind == TermKind::Class),
        "properties": properties,
        "individuals": terms(|kind| kind == TermKind::Individual),
        "examples": examples.collect::<Vec<_>>(),
    })
}
