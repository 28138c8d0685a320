//! Asks synthetic episodes, and takes the time: `ask [--swi] EPISODES QUERY…`; each query is asked twice.

use std::sync::Arc;
use std::time::Instant;
use wisch_memory::ask::{Asker, EngineCommand, Limits, Senses, Told, work};
use wisch_memory::{Catalogue, EPISODE_SCHEMA, EpisodeRecord, Individual, Origin, Value};

/// One episode: a round of four strokes, some of them pushed.
fn episode(number: u32) -> EpisodeRecord {
    let start = 1.7e9 + 100.0 * f64::from(number);
    let individual =
        |class: &str, parent: usize, at: [f64; 2], values: &[(&str, f64)]| Individual {
            class: format!("semco:{class}"),
            interval: Some(at.map(|t| start + t)),
            parent: Some(parent),
            relations: [].into(),
            values: values
                .iter()
                .map(|(name, value)| (format!("semco:{name}"), Value::Number(*value)))
                .collect(),
        };
    let performance = 0.6 + 0.4 * f64::from(number * 37 % 100) / 100.0;
    let quality = [("performance", performance)];
    let mut individuals = vec![
        individual("WipingEpisode", 0, [0.0, 60.0], &[]),
        individual("WipingAction", 0, [0.0, 60.0], &quality),
        individual(
            "WipingRound",
            1,
            [0.0, 60.0],
            &[("performance", performance), ("round", 1.0)],
        ),
    ];
    individuals[0].parent = None;
    individuals[1].relations = [
        ("semco:usesTool".to_owned(), vec!["semco:sponge".to_owned()]),
        (
            "soma:isPerformedBy".to_owned(),
            vec!["semco:humanoid".to_owned()],
        ),
    ]
    .into();
    for stroke in 0..10 {
        let begin = 6.0 * f64::from(stroke);
        individuals.push(individual(
            "Stroke",
            2,
            [begin, begin + 5.0],
            &[("meanNormalForce", -9.5)],
        ));
    }
    let from = 3.0 + f64::from(number % 40);
    let force = 15.0 + f64::from(number % 23);
    individuals.push(individual(
        "HumanCollision",
        3,
        [from, from + 1.5],
        &[("peakForce", force)],
    ));
    EpisodeRecord {
        schema: EPISODE_SCHEMA,
        id: format!("e{number}"),
        task: "board".to_owned(),
        interval: [start, start + 60.0],
        origin: Origin::Simulated,
        program: "example".to_owned(),
        seed: 0,
        rounds: vec![start],
        individuals,
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments: Vec<String> = std::env::args().skip(1).collect();
    if arguments
        .first()
        .is_some_and(|argument| argument == "engine")
    {
        return Ok(work(arguments[1].parse()?)?);
    }
    let command = if arguments
        .first()
        .is_some_and(|argument| argument == "--swi")
    {
        arguments.remove(0);
        EngineCommand::Swi("swipl".into())
    } else {
        EngineCommand::Own(std::env::current_exe()?, vec!["engine".to_owned()])
    };
    let count = arguments.remove(0).parse()?;
    let episodes: Vec<_> = (0..count).map(episode).collect();
    let catalogue = Arc::new(Catalogue::of(&episodes));
    let limits = Limits::default();
    let mut asker = Asker::new(
        command,
        limits,
        catalogue,
        Senses::default(),
        Told::default(),
    );
    for query in &arguments {
        println!("?- {query}");
        for _ in 0..2 {
            let begin = Instant::now();
            let result = asker.ask(query);
            let time = begin.elapsed();
            match result {
                Ok(answers) => {
                    for row in answers.rows.iter().take(3) {
                        let shown = answers.names.iter().zip(row);
                        let shown: Vec<_> = shown
                            .map(|(name, term)| format!("{name} = {term}"))
                            .collect();
                        println!("   {}", shown.join(", "));
                    }
                    println!(
                        "   {} answers, {} views, {time:.1?}",
                        answers.rows.len(),
                        answers.views.len()
                    );
                }
                Err(error) => println!("   {error}, {time:.1?}"),
            }
        }
    }
    Ok(())
}
