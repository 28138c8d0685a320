//! Goals that the program joins: the answers are those that the engine finds by itself, in the same order.

use super::random;
use super::{Answers, BY_HAND, EngineCommand, QuerySession, asker, engines};

/// Answers as text, in the order in which they came; or what was wrong.
fn in_order(asker: &mut QuerySession, query: &str) -> Vec<String> {
    let rows = |answers: Answers| {
        let rows = answers.rows.into_iter();
        let texts = rows.map(|row| row.iter().map(|term| format!("{term} ")).collect());
        texts.collect()
    };
    match asker.ask(query) {
        Ok(answers) => rows(answers),
        Err(error) => vec![format!("error: {error}")],
    }
}

/// An asker that joins facts, and one that does not.
fn both(command: &EngineCommand) -> [QuerySession; 2] {
    let mut plain = asker(command.clone());
    plain.join_facts(false);
    [asker(command.clone()), plain]
}

#[test]
fn joined_or_not_random_queries_have_the_same_answers() {
    for engine in engines() {
        let [mut joined, mut plain] = both(&engine);
        let mut answered = 0;
        for seed in 0..200 {
            let query = random::of_facts(seed);
            let answers = in_order(&mut joined, &query);
            assert_eq!(answers, in_order(&mut plain, &query), "{seed}: {query}");
            answered += usize::from(!answers.is_empty());
        }
        assert!(answered > 60, "only {answered} of 200 queries have answers");
        let [joins, none] = [&joined, &plain].map(QuerySession::join_count);
        assert!(joins > 150 && none == 0, "{joins} and {none} joins");
    }
}

#[test]
fn joined_or_not_listed_queries_have_the_same_answers() {
    for engine in engines() {
        let [mut joined, mut plain] = both(&engine);
        for (query, _) in BY_HAND {
            assert_eq!(
                in_order(&mut joined, query),
                in_order(&mut plain, query),
                "{query}"
            );
        }
    }
}

#[test]
fn whole_queries_beginnings_and_what_is_inside_are_joined() {
    let queries = [
        "has_type(A, 'Stroke'), occurs(A, I)",
        "has_type(A, 'Stroke'), occurs(A, [S, _]), atom(A)",
        "X = [1], findall(A, (has_type(A, 'Stroke'), occurs(A, _)), L), atom(a)",
        "low_performance_round(R, P)",
        "human_collision(M, C, I), atom(C)",
        "tool_performance(T, M, P, N)",
    ];
    for engine in engines() {
        let mut asker = asker(engine);
        for query in queries {
            let before = asker.join_count();
            asker.ask(query).unwrap();
            assert!(asker.join_count() > before, "{query}");
        }
    }
}

#[test]
fn errors_are_the_engines_with_and_without_joins() {
    let wrong = [
        "has_type(A, 'Colision'), occurs(A, I)",
        "has_type(A, 'Stroke'), occurs(A, [S, _]), X is S + foo",
        "has_type(A, 'Stroke'), triple(A, semco:strategy, S), S > 1",
        "has_type(A, 'Stroke'), N > 1",
        "findall(A, (has_type(A, 'Stroke'), has_data_value(A, nothing > 1)), L)",
    ];
    for engine in engines() {
        let [mut joined, mut plain] = both(&engine);
        for query in wrong {
            let said = in_order(&mut joined, query);
            assert_eq!(said, in_order(&mut plain, query), "{query}");
        }
    }
}

#[test]
fn asserted_statements_are_joined_too() {
    for engine in engines() {
        let mut asker = asker(engine);
        let query = "has_data_value(A, peakForce > 50), has_type(A, 'Stroke')";
        assert_eq!(in_order(&mut asker, query), [""; 0]);
        asker
            .ask("tell(holds('Stroke_e0-5', semco:peakForce, 99.0))")
            .unwrap();
        assert_eq!(in_order(&mut asker, query), ["semco:'Stroke_e0-5' "]);
    }
}
