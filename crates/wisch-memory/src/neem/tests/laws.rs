//! Round trip of arbitrary records.

use super::super::{Triple, document, records, triples};
use super::SEMCO;
use crate::ontology::Ontology;
use crate::record::{EPISODE_SCHEMA, EpisodeRecord, Individual, Origin, Value};
use proptest::prelude::*;

/// Returns names with prefix, known and unknown.
fn names() -> impl Strategy<Value = String> {
    let known: Vec<String> = Ontology::load()
        .terms()
        .map(|(name, _)| name.to_owned())
        .collect();
    const OTHERS: [&str; 4] = [
        "rdf:type",
        "owl:NamedIndividual",
        "rdfs:label",
        "owl:sameAs",
    ];
    prop_oneof![
        4 => prop::sample::select(known),
        1 => prop::sample::select(&OTHERS[..]).prop_map(str::to_owned),
        2 => "(semco|soma|justin):[A-Za-z_#/-]{1,5}",
    ]
}

fn numbers() -> impl Strategy<Value = f64> {
    prop_oneof![any::<f64>(), -1e3..1e3, Just(-0.0)].prop_filter("finite", |x| x.is_finite())
}

fn intervals() -> impl Strategy<Value = [f64; 2]> {
    [numbers(), numbers()].prop_map(|[a, b]| [a.min(b), a.max(b)])
}

fn individuals() -> impl Strategy<Value = Vec<Individual>> {
    let text = prop_oneof![".{0,6}", Just(format!("{SEMCO}sponge"))];
    let value = prop_oneof![
        numbers().prop_map(Value::Number),
        text.prop_map(Value::Text)
    ];
    let object = prop_oneof![
        names().prop_map(Ok),
        any::<prop::sample::Index>().prop_map(Err)
    ];
    // Parent and interval state these relations.
    let relation = names().prop_filter("free", |name| {
        ![triples::STEP_OF, triples::HAS_INTERVAL].contains(&name.as_str())
    });
    let relations =
        prop::collection::btree_map(relation, prop::collection::vec(object, 1..3), 0..3);
    let values = prop::collection::btree_map(names(), value, 0..3);
    let parent = prop::option::of(any::<prop::sample::Index>());
    let class = names().prop_filter("a class", |name| name != triples::NAMED);
    let one = (
        class,
        prop::option::of(intervals()),
        parent,
        relations,
        values,
    );
    prop::collection::vec(one, 0..6).prop_map(|all| {
        let count = all.len();
        let numbered = all.into_iter().enumerate();
        numbered
            .map(|(place, (class, interval, parent, relations, values))| {
                let objects = |objects: Vec<Result<String, prop::sample::Index>>| {
                    let named = |object: Result<String, prop::sample::Index>| match object {
                        Ok(name) => name,
                        Err(index) => format!("#{}", index.index(count)),
                    };
                    objects.into_iter().map(named).collect()
                };
                Individual {
                    class,
                    interval,
                    parent: parent.filter(|_| place > 0).map(|index| index.index(place)),
                    relations: relations
                        .into_iter()
                        .map(|(property, related)| (property, objects(related)))
                        .collect(),
                    values,
                }
            })
            .collect()
    })
}

fn episodes() -> impl Strategy<Value = EpisodeRecord> {
    let origin = prop_oneof![
        Just(Origin::Simulated),
        ".{0,6}".prop_map(Origin::Executor),
        ".{0,6}".prop_map(Origin::Imported)
    ];
    let rounds = prop::collection::vec(numbers(), 0..3);
    let head = ("[A-Za-z0-9-]{1,8}", ".{0,6}", intervals(), origin);
    (head, ".{0,6}", any::<u64>(), rounds, individuals()).prop_map(
        |((id, task, interval, origin), program, seed, rounds, individuals)| EpisodeRecord {
            schema: EPISODE_SCHEMA,
            id,
            task,
            interval,
            origin,
            program,
            seed,
            rounds,
            individuals,
        },
    )
}

proptest! {
    #[test]
    fn records_survive_conversion_to_triples_and_back(record in episodes()) {
        prop_assume!(record.check().is_ok());
        let through_documents = |triple: &Triple| {
            let document = document::Closures::default().document(bson::oid::ObjectId::from_bytes([0; 12]), triple).unwrap();
            document::triple(&document).unwrap()
        };
        let there = triples::triples(&record).unwrap();
        let back: Vec<Triple> = there.iter().map(through_documents).collect();
        prop_assert_eq!(&there, &back);
        prop_assert_eq!(records(back).unwrap(), [record]);
    }
}
