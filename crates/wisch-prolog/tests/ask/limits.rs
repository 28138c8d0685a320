//! Statements limited in time, and goals in any order.

use super::{BY_HAND, QuerySession, asker, engines, shown};
use wisch_memory::ask::AskError;

fn answers(asker: &mut QuerySession, query: &str) -> Result<Vec<String>, String> {
    match asker.ask(query) {
        Ok(answers) => Ok(shown(&answers)),
        Err(AskError::Fault(fault)) => Err(fault.to_string()),
        Err(error) => panic!("{query}: {error}"),
    }
}

/// The only push is that of e0, from 1010.0 to 1011.5 s; round 1 of e0 lasts from 1000 to 1030 s.
#[test]
fn statements_about_events_hold_within_their_times_only() {
    const PUSH: &str = "semco:'HumanCollision_e0-7'";
    let about_the_push = [
        "human_collision(_, C, _)",
        "human_collision_in(_, _, C, _)",
        "peak_force_per_collision(C, _)",
        "hardest_collision(C, _)",
        "interrupted_stroke(_, C)",
        "occurs(C), has_type(C, 'Collision')",
        "has_type(C, 'Collision')",
        "instance_of(C, 'HumanCollision')",
        "triple(C, dul:hasParticipant, semco:human)",
        "triple(semco:human, dul:isParticipantIn, C)",
        "has_data_value(C, peakForce = 22)",
        "(peak_force_per_collision(C, _F), _F > 20)",
        "(fail ; has_type(C, 'Collision'))",
        "once(has_type(C, 'Collision'))",
    ];
    for engine in engines() {
        let mut asker = asker(engine);
        for statement in about_the_push {
            for (limit, is_within) in [
                ("during [1010, 1011.5]", true),
                ("during [1000, 2000]", true),
                ("during [1010.1, 1020]", false),
                ("during [60, 70]", false),
                ("since 1010", true),
                ("since 1010.5", false),
                ("until 1011.5", true),
                ("until 1011", false),
                ("since 1000 until 1020", true),
                ("since 1000 until 1011", false),
            ] {
                let query = format!("({statement}) {limit}");
                let found = answers(&mut asker, &query);
                let expected = if is_within { vec![PUSH] } else { Vec::new() };
                let names = found.as_ref().map(|rows| {
                    let names = rows.iter().map(|row| row.split(' ').next().unwrap_or(""));
                    names.collect::<Vec<_>>()
                });
                assert_eq!(names, Ok(expected), "{query}: {found:?}");
            }
        }
        for (query, expected) in [
            (
                "occurs('HumanCollision_e0-7') during [S, E]",
                &["1010.0 1011.5"][..],
            ),
            (
                "goal_met(A) during [1000, 1060]",
                &["semco:'WipingAction_e0-1'"],
            ),
            ("goal_met(A) since 6000", &["semco:'WipingAction_e5-1'"]),
            (
                "last_episode(E, T) until 5000",
                &["semco:'WipingEpisode_e3-0' 4030.0"],
            ),
            (
                "aggregate_all(count, has_type(_, 'Stroke'), N) during [1000, 1060]",
                &["2"],
            ),
            (
                "findall(C, has_type(C, 'Collision'), L) during [60, 70]",
                &["_ []"],
            ),
            ("(\\+ has_type(_, 'Collision')) during [60, 70]", &[""]),
            ("(\\+ has_type(_, 'Collision')) during [1000, 1060]", &[]),
            (
                "tool_performance(T, M, P, N), T = semco:broom",
                &["semco:broom semco:sand 0.95 1"],
            ),
        ] {
            let found = answers(&mut asker, query);
            let expected: Vec<String> = expected.iter().map(|row| (*row).to_owned()).collect();
            assert_eq!(found, Ok(expected), "{query}");
        }
    }
}

#[test]
fn a_time_that_ends_before_it_begins_is_an_error_that_names_both() {
    for engine in engines() {
        let mut asker = asker(engine);
        for query in [
            "has_type(C, 'Collision') during [1060, 1000]",
            "occurs(C) during [1060, 1000]",
            "occurs(C), has_type(C, 'Collision') during [1060, 1000]",
            "(has_type(C, 'Collision') since 1060) until 1000",
            "(has_type(C, 'Collision') during [1060, 1070]) until 1000",
            "(\\+ has_type(_, 'Collision')) during [1060, 1000]",
            "is_at(sponge, P) during [1060, 1000]",
            "interval_during(C, [1060, 1000])",
            "interval_before([1060, 1000], C)",
            "telemetry(force, [1060, 1000], max, V)",
            "object_trajectory(sponge, [1060, 1000], dt(1), T)",
            "tf_mng_trajectory(sponge, 1060, 1000, T)",
            "show(sponge, [1060, 1000])",
        ] {
            let Err(found) = answers(&mut asker, query) else {
                panic!("{query}: no error");
            };
            let says = "the time from 1060 to 1000 ends before it begins";
            assert!(found.contains(says), "{query}: {found}");
        }
        let instant = answers(&mut asker, "has_type(C, 'Collision') during [1010, 1010]");
        assert_eq!(instant, Ok(vec![]), "a time without duration is one");
    }
}

#[test]
fn what_has_no_time_cannot_be_limited_in_time() {
    for engine in engines() {
        let mut asker = asker(engine);
        for (query, says) in [
            (
                "subclass_of(X, 'Collision') during [0, 1]",
                "subclass_of/2 has no time",
            ),
            (
                "tool_performance(T, M, P, N) during [0, 1]",
                "tool_performance/4 has no time",
            ),
            ("X = 1 during [0, 1]", "has no time"),
            ("show(sponge) during [0, 1]", "show/1 has no time"),
            (
                "has_type(semco:sponge, 'WipingTool') during [0, 1]",
                "semco:sponge has no time",
            ),
            ("is_task(T) during [0, 1]", "has no time"),
            (
                "has_type(C, 'Collision') during [S, 2]",
                "each of the two times of during",
            ),
            (
                "(has_type(C, 'Collision'), occurs(C)) during I",
                "each of the two times of during",
            ),
            (
                "(has_type(C, 'Collision'), occurs(C)) since T",
                "the time of since",
            ),
            (
                "telemetry(Channel, [1, 2], max, V)",
                "the channel of telemetry",
            ),
            (
                "telemetry(force, [1, 2], How, V)",
                "the statistic of telemetry",
            ),
            ("occurs(C) during [now, then]", "now"),
            ("occurs(C) during 7", "7 is not an interval"),
            ("occurs(C) until soon", "soon"),
        ] {
            let found = answers(&mut asker, query).expect_err(query);
            assert!(found.contains(says), "{query}: {found}");
        }
    }
}

/// Whatever is asked: nothing was before the first episode, all is within all time, or an error says what has no time.
#[test]
fn every_query_about_wiping_keeps_its_limits() {
    for engine in engines() {
        let mut asker = asker(engine);
        let mut limited = 0;
        for (query, _) in BY_HAND {
            let is_alone =
                !query.contains("), ") && !query.contains(") during") && !query.contains(") since");
            if !is_alone {
                continue;
            }
            let plain = answers(&mut asker, query).expect(query);
            if plain.is_empty() {
                continue;
            }
            let none = answers(&mut asker, &format!("({query}) during [0, 999]"));
            let all = answers(&mut asker, &format!("({query}) during [0, 99999]"));
            match (none, all) {
                (Ok(none), Ok(all)) => {
                    let is_count =
                        query.starts_with("aggregate_all") || query.starts_with("forall");
                    assert!(is_count || none.is_empty(), "{query}: {none:?}");
                    assert_eq!(all, plain, "{query}");
                    limited += 1;
                }
                (Err(none), Err(_)) => assert!(none.contains("has no time"), "{query}: {none}"),
                other => panic!("{query}: {other:?}"),
            }
        }
        assert!(limited > 35, "only {limited} queries were limited");
    }
}

#[test]
fn goals_have_the_same_answers_in_any_order_or_an_error_says_what_to_bind() {
    let goals: &[&[&str]] = &[
        &["has_type(T, 'WipingTool')", "T = semco:sponge"],
        &["has_type(T, 'WipingTool')", "T = sponge"],
        &["has_type(T, 'WipingTool')", "T \\= semco:sponge"],
        &["has_type(T, 'WipingTool')", "T \\== semco:sponge"],
        &["has_type(S, 'Stroke')", "S = 'Stroke_e0-5'"],
        &["has_type(C, 'Collision')", "occurs(C, [1010, 1011.5])"],
        &["occurs(C, [S, E])", "has_type(C, 'Collision')", "S = 1010"],
        &[
            "interval_during(X, [S, E])",
            "occurs('Stroke_e0-5', [S, E])",
        ],
        &[
            "telemetry(force, [S, E], max, F)",
            "occurs('Stroke_e0-5', [S, E])",
        ],
        &["tf(sponge, T, P, Q)", "T = 1010.0"],
        &["triple(T, dul:isParticipantIn, A)", "T = semco:broom"],
        &["triple(A, P, semco:broom)", "P = dul:hasParticipant"],
        &[
            "triple(A, P, O)",
            "A = 'WipingAction_e5-1'",
            "P = semco:usesTool",
        ],
        &["instance_of(I, C)", "C = dul:'Process'"],
        &["instance_of(I, C)", "I = 'HumanCollision_e0-7'"],
        &[
            "triple(X, transitive(dul:isConstituentOf), W)",
            "X = 'HumanCollision_e0-7'",
        ],
        &[
            "triple(X, reflexive(dul:isConstituentOf), W)",
            "X = 'HumanCollision_e0-7'",
        ],
        &["has_data_value(A, round = N)", "N = 2"],
        &["has_data_value(A, performance =< X)", "X = 0.65"],
        &["has_data_value(A, K)", "K = (performance =< 0.65)"],
        &["low_performance(A, P)", "P < 0.65"],
        &["goal_missed(A, P)", "P = 0.7"],
        &[
            "has_subevent(R, A)",
            "\\+ has_type(A, 'Stroke')",
            "has_type(R, 'WipingRound')",
        ],
        &[
            "has_type(A, 'WipingRound')",
            "aggregate_all(count, has_subevent(A, _), N)",
        ],
        &[
            "has_type(A, 'WipingRound')",
            "findall(B, has_subevent(A, B), L)",
        ],
        &[
            "goal_met(A)",
            "forall(has_subevent(A, R), has_data_value(R, performance > 0.9))",
        ],
        &["occurs(A, [S, _])", "number(S)", "has_type(A, 'Collision')"],
        &["protective_stop(S, T, R)", "R = 'WipingRound_e3-3'"],
        &["last_episode(E, T)", "E = 'WipingEpisode_e5-0'"],
        &["is_at(O, P)", "O = semco:sponge"],
    ];
    for engine in engines() {
        let mut asker = asker(engine);
        asker.join_facts(true);
        for goals in goals {
            let orders: Vec<Vec<&str>> = permutations(goals);
            let found = orders.iter().map(|order| {
                let query = order.join(", ");
                // In the order of the query, variables stand elsewhere.
                let listed = variables(goals);
                let query = format!(
                    "findall(row({listed}), ({query}), Rows0), msort(Rows0, Rows), member(R, Rows)"
                );
                let found = match asker.ask(&query) {
                    // 1 is 1.0, and a name is the same with its prefix and without.
                    Ok(answers) => Ok(answers
                        .rows
                        .iter()
                        .filter_map(|row| row.last().map(ToString::to_string))
                        .map(|row| row.replace("semco:", "").replace(".0", ""))
                        .collect::<Vec<_>>()),
                    Err(error) => Err(error.to_string()),
                };
                (query, found)
            });
            let found: Vec<_> = found.collect();
            let good: Vec<_> = found
                .iter()
                .filter_map(|(_, found)| found.as_ref().ok())
                .collect();
            for (query, found) in &found {
                match found {
                    Ok(rows) => assert_eq!(&rows, &good[0], "{query}"),
                    Err(says) => assert!(
                        says.contains("must be") || says.contains("telemetry"),
                        "{query}: {says}"
                    ),
                }
            }
        }
    }
}

fn permutations<'a>(goals: &[&'a str]) -> Vec<Vec<&'a str>> {
    if goals.len() < 2 {
        return vec![goals.to_vec()];
    }
    let mut all = Vec::new();
    for (place, first) in goals.iter().enumerate() {
        let rest = [&goals[..place], &goals[place + 1..]].concat();
        for mut order in permutations(&rest) {
            order.insert(0, first);
            all.push(order);
        }
    }
    all
}

/// The variables of goals, each once.
fn variables(goals: &[&str]) -> String {
    let text = goals.join(" ");
    let words = text.split(|c: char| !c.is_alphanumeric() && c != '_' && c != '\'');
    let mut found: Vec<&str> = words
        .filter(|word| word.len() == 1 && word.chars().all(|c| c.is_ascii_uppercase()))
        .collect();
    found.sort_unstable();
    found.dedup();
    found.join(", ")
}
