//! The belief before the first measurement, and its updates by observations.

use super::interpreted_with;
use super::log::{PRESS, STEEP, Script, task};
use wisch::geometry::{Point2, Polygon, Pose, Region, Vector2, Vector3};
use wisch::interpret::{
    Belief, DirtPrior, Doubt, InterpretConfig, Interpreter, ObservationUpdate, TouchSample,
    interpret,
};
use wisch::recover::is_claimable;
use wisch::represent::{
    Action, Cluster, Fate, GoalState, LogNormal, Observation, ParticleDistribution, SensorModel,
    Sight, Task,
};

/// A camera that detects every grain at its exact position, without false alarms.
const SHARP: Sight = Sight {
    sensor: SensorModel {
        detection: 1.0,
        half_size_m: 0.0,
        false_alarms_per_m2: 0.0,
        position_error_m: 1e-6,
    },
    detection: 1.0,
};

fn update<'a>(
    task: &'a Task,
    goal: &'a GoalState,
    observation: &'a Observation,
) -> ObservationUpdate<'a> {
    ObservationUpdate {
        observation,
        sight: SHARP,
        surface: &task.surface,
        goal,
        seed: 5,
    }
}

fn places(count: usize, x: f64) -> Vec<Point2> {
    (0..count)
        .map(|i| Point2::new(x, -0.1 + 0.002 * i as f64))
        .collect()
}

fn counts(belief: &Belief) -> Vec<usize> {
    belief
        .members()
        .iter()
        .map(ParticleDistribution::len)
        .collect()
}

#[test]
fn dirt_that_lies_anywhere_lies_elsewhere_in_every_member() {
    let task = task(80, STEEP);
    let prior = DirtPrior::Anywhere { count: 80 };
    let belief = prior.belief(&task, 400);
    assert_eq!(belief, prior.belief(&task, 400));
    let logs: Vec<f64> = counts(&belief)
        .iter()
        .map(|&n| (n as f64 / 80.0).ln())
        .collect();
    let mean = logs.iter().sum::<f64>() / 400.0;
    let deviation = (logs.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / 400.0).sqrt();
    // Log-normal with a spread of 0.3; four standard errors of 400 draws.
    assert!(mean.abs() < 0.06, "{mean}");
    assert!((deviation - 0.3).abs() < 0.05, "{deviation}");
    // About half of the members have their dirt in heaps: closer together than dirt that is spread evenly.
    let spread = |member: &ParticleDistribution| {
        let n = member.len() as f64;
        let mean = member.remaining().map(|p| p.coords).sum::<Vector2>() / n;
        let squares: f64 = member
            .remaining()
            .map(|p| (p.coords - mean).norm_squared())
            .sum();
        (squares / n).sqrt()
    };
    // √((0.4² + 0.28²) / 12) = 0.141 m if spread evenly.
    let heaped = belief
        .members()
        .iter()
        .filter(|member| spread(member) < 0.115)
        .count();
    assert!((80..220).contains(&heaped), "{heaped}");
    let outline = &task.surface.outline;
    assert!(
        belief
            .members()
            .iter()
            .all(|m| m.remaining().all(|p| outline.contains(p)))
    );
}

#[test]
fn what_is_known_and_what_was_seen_lies_where_it_was_said() {
    let mut task = task(0, STEEP);
    task.particles = ParticleDistribution::new(&places(50, 0.1)).unwrap();
    assert!(DirtPrior::Known.belief(&task, 64).is_certain());
    let sight = Sight {
        sensor: SensorModel {
            position_error_m: 2e-3,
            false_alarms_per_m2: 0.0,
            ..SHARP.sensor
        },
        detection: 0.8,
    };
    let belief = DirtPrior::Seen(sight).belief(&task, 400);
    let mean = counts(&belief).iter().sum::<usize>() as f64 / 400.0;
    // One of five grains is missed; four standard errors of Poisson counts.
    assert!(
        (mean - 62.5).abs() < 4.0 * (12.5_f64 / 400.0).sqrt(),
        "{mean}"
    );
    let near = belief
        .members()
        .iter()
        .flat_map(|m| m.remaining())
        .filter(|p| (p.x - 0.1).abs() < 0.01);
    assert!((near.count() as f64 / 400.0 - 50.0).abs() < 2.0);
    let heaps = vec![Cluster {
        center: Point2::new(-0.1, 0.0),
        sigma: 0.01,
        weight: 1.0,
    }];
    let belief = DirtPrior::Heaps { count: 50, heaps }.belief(&task, 10);
    assert!(
        belief
            .members()
            .iter()
            .all(|m| m.remaining().all(|p| p.x < 0.0))
    );
}

#[test]
fn an_exact_observation_before_wiping_determines_the_dirt() {
    let task = task(80, STEEP);
    let goal = GoalState::Absorbed;
    let belief = DirtPrior::Anywhere { count: 80 }.belief(&task, 64);
    let seen = Observation {
        detections: places(30, 0.05),
        hidden: Region::default(),
    };
    let after = belief.observe(&update(&task, &goal, &seen));
    for member in after.members() {
        assert_eq!(member.tally().remaining, 30);
        assert_eq!(member.len(), 30);
        assert!(member.remaining().all(|p| (p.x - 0.05).abs() < 1e-4));
    }
    // In a hidden area, the members keep their particles.
    let hidden = Region::new(vec![Polygon::rectangle(Vector2::new(0.2, 0.28))]);
    let behind = Observation {
        detections: vec![],
        hidden: hidden.clone(),
    };
    let after = belief.observe(&update(&task, &goal, &behind));
    assert!(
        after
            .members()
            .iter()
            .all(|m| m.remaining().all(|p| hidden.contains(p)))
    );
    let all: usize = after.members().iter().map(|m| m.tally().remaining).sum();
    assert!(all > 64 * 20, "{all}");
}

#[test]
fn an_observation_after_wiping_shows_what_is_left_and_what_is_gone() {
    let task = task(80, STEEP);
    let goal = GoalState::Absorbed;
    let script = Script::default();
    let config = InterpretConfig::from_task(&task);
    let mut felt = interpreted_with(&script.samples(&task), &task, &config);
    assert!(felt.performance.mean > 0.5);
    let seen = Observation {
        detections: places(20, 0.1),
        hidden: Region::default(),
    };
    felt.observe(&update(&task, &goal, &seen));
    assert_eq!(felt.performance.mean, 0.75);
    assert_eq!([felt.performance.low, felt.performance.high], [0.75; 2]);
    assert!(felt.by_touch.mean > 0.5 && felt.observation.is_some());
    for member in felt.belief.members() {
        assert_eq!((member.len(), member.tally().absorbed), (80, 60));
    }
    // The observation of a blind camera changes nothing.
    let blind = Sight {
        detection: 0.0,
        ..SHARP
    };
    let before = interpreted_with(&script.samples(&task), &task, &config).belief;
    let nothing = Observation::default();
    let after = before.observe(&ObservationUpdate {
        sight: blind,
        ..update(&task, &goal, &nothing)
    });
    assert!(after.members() == before.members());
}

#[test]
fn an_observation_that_contradicts_touch_raises_a_doubt_and_widens_the_interval() {
    let task = task(80, STEEP);
    let goal = GoalState::Absorbed;
    let config = InterpretConfig::from_task(&task);
    let members = (0..64).map(|k| {
        let some = task.particles.remaining().take(60 + k % 21);
        ParticleDistribution::new(&some.collect::<Vec<_>>()).unwrap()
    });
    let belief = Belief::from_members(members.collect()).unwrap();
    let felt = interpreted_from(&belief, &task, &config);
    let left = |member: &ParticleDistribution| member.tally().remaining;
    let most = felt.belief.members().iter().map(left).max().unwrap();
    let after = |count: usize| {
        let seen = Observation {
            detections: places(count, 0.1),
            hidden: Region::default(),
        };
        let mut felt = felt.clone();
        felt.observe(&update(&task, &goal, &seen));
        let told = felt.doubts.iter().find_map(|doubt| match doubt {
            Doubt::ObservationContradicts {
                seen,
                left,
                believed,
                ..
            } => Some((*seen, left[1] <= most as f64, believed[1] <= 80.0)),
            _ => None,
        });
        (felt, told)
    };
    let (agrees, told) = after(most);
    assert_eq!((told, agrees.is_conclusive()), (None, true));
    // As many detections as the initial number of grains: the estimate by touch is wrong.
    let (unwiped, told) = after(75);
    assert_eq!(told, Some((75, true, true)), "{most} left by touch");
    assert!(unwiped.is_conclusive() && unwiped.performance.low < 0.05);
    // More detections than grains: the number is wrong, and the performance unknown.
    let (more, told) = after(130);
    assert_eq!(told, Some((130, true, true)));
    let estimate = more.performance;
    assert!(
        !more.is_conclusive() && estimate.low < 0.1 && estimate.high > 0.8,
        "{estimate:?}"
    );
}

#[test]
fn the_first_observation_does_not_prove_that_the_camera_detects_dirt() {
    // Half of the dirt is expected to stay where the tool presses.
    let stubborn = LogNormal {
        mu: 0.0,
        sigma: 0.25,
    };
    let task = task(80, stubborn);
    let goal = GoalState::Absorbed;
    let config = InterpretConfig::from_task(&task);
    let members = (0..64).map(|k| {
        let some = task.particles.remaining().take(40 + k % 41);
        ParticleDistribution::new(&some.collect::<Vec<_>>()).unwrap()
    });
    let belief = Belief::from_members(members.collect()).unwrap();
    let script = Script::default();
    let after = |belief: &Belief, count: usize| {
        let seen = Observation {
            detections: places(count, 0.1),
            hidden: Region::default(),
        };
        let mut felt = interpret(&script.samples(&task), &task, belief, &goal, &config).unwrap();
        felt.observe(&update(&task, &goal, &seen));
        felt
    };
    let unseen = after(&belief, 0);
    let first = Observation {
        detections: task.particles.remaining().take(60).collect(),
        hidden: Region::default(),
    };
    let seen_before = belief.observe(&update(&task, &goal, &first));
    let clean = after(&seen_before, 1);
    let [unseen, clean] = [unseen, clean].map(|felt| felt.performance);
    assert!(unseen.low < 0.7 && clean.low > 0.8, "{unseen:?} {clean:?}");
}

/// The tool wipes the right half of the board only, and places and number of the dirt are unknown.
#[test]
fn a_first_observation_of_fewer_grains_than_expected_proves_nothing() {
    let task = task(60, STEEP);
    let goal = GoalState::Absorbed;
    let config = InterpretConfig::from_task(&task);
    let belief = DirtPrior::Anywhere { count: 60 }.belief(&task, 400);
    let upward = |x: f64| [Point2::new(x, -0.09), Point2::new(x, 0.09)];
    let script = Script {
        strokes: [0.03, 0.08, 0.13].map(upward).to_vec(),
        ..Script::default()
    };
    let samples = script.samples(&task);
    let places: Vec<Point2> = task.particles.remaining().collect();
    let first = |count: usize| Observation {
        detections: places[..count].to_vec(),
        hidden: Region::default(),
    };
    let after = |belief: &Belief, count: usize| {
        let mut felt = interpret(&samples, &task, belief, &goal, &config).unwrap();
        let seen = Observation {
            detections: (0..count)
                .map(|i| Point2::new(-0.15, -0.1 + 0.004 * i as f64))
                .collect(),
            hidden: Region::default(),
        };
        felt.observe(&update(&task, &goal, &seen));
        let is_doubted =
            (felt.doubts.iter()).any(|doubt| matches!(doubt, Doubt::ObservationContradicts { .. }));
        (felt, is_doubted)
    };
    for count in 0..12 {
        let (felt, is_doubted) = after(&belief, count);
        let [found, by_touch] = [felt.performance, felt.by_touch];
        assert!(is_doubted, "{count}: {found:?}");
        assert!(
            found.low < 0.5 * (by_touch.low + by_touch.mean),
            "{count}: {found:?} {by_touch:?}"
        );
        assert!(
            !is_claimable(&felt.distribution, 0.85),
            "{count}: {found:?}"
        );
    }
    let (felt, is_doubted) = after(&belief, 27);
    let found = felt.performance;
    assert!(
        !is_doubted && found.low > 0.2 && found.high < 0.7,
        "{found:?}"
    );
    // An earlier observation shows that the camera detects dirt, and how much there was.
    let seen_before = belief.observe(&update(&task, &goal, &first(60)));
    let (_, is_doubted) = after(&seen_before, 27);
    assert!(!is_doubted);
}

#[test]
fn an_observation_without_dirt_that_no_contact_explains_decides_nothing() {
    for goal in [GoalState::Absorbed, GoalState::Skimmed] {
        let task = task(80, STEEP);
        let config = InterpretConfig::from_task(&task);
        let here = ParticleDistribution::new(&places(60, 0.1)).unwrap();
        let belief = Belief::from_members(vec![here; 64]).unwrap();
        let mut interpreter = Interpreter::new(&task, &config).unwrap();
        for sample in hovering() {
            interpreter.push(&sample).unwrap();
        }
        let hovered = interpreter.conclude(&belief, &goal).unwrap();
        let after = |count: usize| {
            let seen = Observation {
                detections: places(count, 0.1),
                hidden: Region::default(),
            };
            let mut found = hovered.clone();
            found.observe(&update(&task, &goal, &seen));
            found
        };
        let unexplained = after(0);
        let estimate = unexplained.performance;
        assert!(!unexplained.is_conclusive(), "{goal:?}: {estimate:?}");
        assert!(estimate.low < 0.2, "{goal:?}: {estimate:?}");
        // All the dirt is still there, as it must be without contact.
        let explained = after(57);
        assert!(explained.is_conclusive(), "{goal:?}");
        assert!(explained.performance.high < 0.2, "{goal:?}");
    }
}

/// Over the right half of the board the tool hovers in its own softness, with hardly any force.
#[test]
fn dirt_that_was_hardly_touched_does_not_vanish() {
    let task = task(60, STEEP);
    let goal = GoalState::Absorbed;
    let config = InterpretConfig::from_task(&task);
    let script = Script {
        press: |place| if place.x > 0.0 { 0.6 } else { PRESS },
        ..Script::default()
    };
    let grains: Vec<Point2> = task.particles.remaining().collect();
    let before = Observation {
        detections: grains.clone(),
        hidden: Region::default(),
    };
    let belief = DirtPrior::Anywhere { count: 60 }.belief(&task, 200);
    let belief = belief.observe(&update(&task, &goal, &before));
    let mut felt = interpret(&script.samples(&task), &task, &belief, &goal, &config).unwrap();
    let right = grains.iter().copied().filter(|place| place.x > 0.05);
    let few = Observation {
        detections: right.take(5).collect(),
        hidden: Region::default(),
    };
    felt.observe(&update(&task, &goal, &few));
    let [found, by_touch] = [felt.performance, felt.by_touch];
    assert!(found.low < by_touch.mean, "{found:?} {by_touch:?}");
    assert!(!is_claimable(&felt.distribution, 0.85), "{found:?}");
}

/// A camera sees the same grains before and after a log in which the tool hovers.
#[test]
fn a_log_without_contact_after_others_leaves_what_the_camera_sees() {
    let task = task(80, STEEP);
    let goal = GoalState::Absorbed;
    let config = InterpretConfig::from_task(&task);
    let grains: Vec<Point2> = task.particles.remaining().take(60).collect();
    let seen = |count: usize| Observation {
        detections: grains[..count].to_vec(),
        hidden: Region::default(),
    };
    let belief = DirtPrior::Anywhere { count: 60 }.belief(&task, 200);
    let belief = belief.observe(&update(&task, &goal, &seen(60)));
    let mut wiped = interpreted_from(&belief, &task, &config);
    wiped.observe(&update(&task, &goal, &seen(14)));
    let mut interpreter = Interpreter::new(&task, &config).unwrap();
    for sample in hovering() {
        interpreter.push(&sample).unwrap();
    }
    let mut hovered = interpreter.conclude(&wiped.belief, &goal).unwrap();
    hovered.observe(&update(&task, &goal, &seen(14)));
    let contradicts = |doubt: &Doubt| matches!(doubt, Doubt::ObservationContradicts { .. });
    assert!(
        !hovered.doubts.iter().any(contradicts),
        "{:?}",
        hovered.doubts
    );
    let [before, after] = [wiped, hovered].map(|found| found.performance);
    assert!(
        (after.mean - before.mean).abs() < 0.01,
        "{before:?} {after:?}"
    );
    assert!(after.high < 0.8, "{after:?}");
}

/// Samples of a tool that hovers over the surface without any force.
fn hovering() -> impl Iterator<Item = TouchSample> {
    (0..500).map(|k| {
        let world_from_tool = Pose::translation(1e-3 * f64::from(k) - 0.25, 0.0, 0.05);
        TouchSample::new(0.01 * f64::from(k), world_from_tool, Vector3::zeros())
    })
}

#[test]
fn false_alarms_are_distinguished_by_where_dirt_may_be() {
    let task = task(80, STEEP);
    let goal = GoalState::Absorbed;
    let here = ParticleDistribution::new(&places(40, 0.1)).unwrap();
    let belief = Belief::from_members(vec![here; 200]).unwrap();
    let sight = Sight {
        sensor: SensorModel {
            false_alarms_per_m2: 50.0,
            ..SHARP.sensor
        },
        detection: 0.95,
    };
    let mut detections = places(40, 0.1);
    detections.push(Point2::new(-0.15, 0.0));
    let seen = Observation {
        detections,
        hidden: Region::default(),
    };
    let after = belief.observe(&ObservationUpdate {
        sight,
        ..update(&task, &goal, &seen)
    });
    let share = |is: fn(f64) -> bool| {
        let all = after.members().iter().flat_map(|m| m.remaining());
        all.filter(|p| is(p.x)).count() as f64 / 200.0
    };
    let [alarm, dirt] = [share(|x| x < 0.0), share(|x| x > 0.0)];
    assert!(alarm < 0.6 && dirt > 37.0, "{alarm} {dirt}");
}

#[test]
fn an_observation_weighs_the_laws_by_how_much_is_left() {
    let task = task(80, STEEP);
    // Particles with a high threshold remain in some members, and are gone in others.
    let mut config = InterpretConfig::from_task(&task);
    config.uncertainty.law_mu = 1.0;
    config.uncertainty.kept_share = 1.0;
    let mut felt = interpreted_with(&Script::default().samples(&task), &task, &config);
    let left = |felt: &wisch::interpret::Interpretation| {
        let counts = felt.belief.members().iter().zip(felt.belief.weights());
        let left = counts.map(|(m, w)| w * m.tally().remaining as f64);
        left.sum::<f64>()
    };
    let before = left(&felt);
    let all: Vec<Point2> = task.particles.remaining().collect();
    let seen = Observation {
        detections: all,
        hidden: Region::default(),
    };
    felt.observe(&update(&task, &GoalState::Absorbed, &seen));
    assert!(before < 60.0 && (left(&felt) - 80.0).abs() < 1e-9);
    // After another wipe, the dirt is believed to remain.
    let again = interpreted_from(&felt.belief, &task, &config);
    let once = interpreted_with(&Script::default().samples(&task), &task, &config);
    assert!(
        left(&again) > left(&once) + 10.0,
        "{} {}",
        left(&again),
        left(&once)
    );
    assert!(
        again
            .belief
            .members()
            .iter()
            .all(|m| m.iter().all(|(_, f)| f != Fate::OffSurface { edge: 9 }))
    );
}

fn interpreted_from(
    belief: &Belief,
    task: &Task,
    config: &InterpretConfig,
) -> wisch::interpret::Interpretation {
    let samples = Script::default().samples(task);
    wisch::interpret::interpret(&samples, task, belief, &GoalState::Absorbed, config).unwrap()
}

/// Nine of ten grains of a pile are detected, and every member has all of them there: the others
/// were missed.
#[test]
fn what_all_members_agree_on_was_missed_rather_than_gone() {
    let task = task(80, STEEP);
    let goal = GoalState::Absorbed;
    let pile = places(80, 0.1);
    let here = ParticleDistribution::new(&pile).unwrap();
    let belief = wiped(&Belief::from_members(vec![here; 400]).unwrap(), &task);
    let sight = Sight {
        detection: 0.9,
        sensor: SensorModel {
            position_error_m: 1e-3,
            ..SHARP.sensor
        },
    };
    let mut detections = pile;
    detections.retain(|place| (place.y * 500.0).round() as i64 % 10 != 0);
    assert_eq!(detections.len(), 72);
    let seen = Observation {
        detections,
        hidden: Region::default(),
    };
    let after = belief.observe(&ObservationUpdate {
        sight,
        ..update(&task, &goal, &seen)
    });
    let left: Vec<f64> = after
        .members()
        .iter()
        .map(|m| m.tally().remaining as f64)
        .collect();
    let mean = left.iter().sum::<f64>() / 400.0;
    let most = left.iter().copied().fold(0.0, f64::max);
    // 72 of 80 with a probability of 0.9, and a prior that is sharper than that.
    assert!((78.0..82.0).contains(&mean) && most < 90.0, "{mean} {most}");
    // Where members have dirt and the camera detects none, there is none.
    let nothing = Observation::default();
    let gone = belief.observe(&ObservationUpdate {
        sight,
        ..update(&task, &goal, &nothing)
    });
    let left: usize = gone.members().iter().map(|m| m.tally().remaining).sum();
    assert!(left < 400, "{left}");
}

/// A belief after a tool passed where there is no dirt.
fn wiped(belief: &Belief, task: &Task) -> Belief {
    let script = Script {
        strokes: vec![[Point2::new(-0.15, 0.0), Point2::new(-0.12, 0.0)]],
        ..Script::default()
    };
    let config = InterpretConfig::from_task(task);
    let samples = script.samples(task);
    let goal = GoalState::Absorbed;
    let felt = wisch::interpret::interpret(&samples, task, belief, &goal, &config).unwrap();
    felt.belief
}

/// Dirt is pushed over the edge at the bottom; dirt that is no longer detected went over the same edge, even if another edge is nearer.
#[test]
fn what_is_gone_went_over_the_edge_over_which_the_tool_wiped() {
    let task = task(80, STEEP);
    let surface = &task.surface;
    let here = |y: f64| Point2::new(0.0, y);
    let down = surface.exit_edge(here(-0.1), here(-0.5)).unwrap();
    let edge = u16::try_from(down).unwrap();
    let mut places = vec![(here(-0.2), Fate::OffSurface { edge }); 40];
    places.extend([(here(0.13), Fate::OnSurface); 40]);
    let member = ParticleDistribution::with_fates(&places).unwrap();
    let belief = wiped(&Belief::from_members(vec![member; 20]).unwrap(), &task);
    let seen = Observation::default();
    let after = belief.observe(&update(&task, &GoalState::Skimmed, &seen));
    for member in after.members() {
        assert!(
            member
                .iter()
                .all(|(_, fate)| fate == Fate::OffSurface { edge })
        );
    }
}

/// A camera with false alarms that detects this share of the grains.
fn camera(detection: f64) -> Sight {
    Sight {
        sensor: SensorModel {
            false_alarms_per_m2: 2.0,
            position_error_m: 1e-3,
            ..SHARP.sensor
        },
        detection,
    }
}

/// A member from 58 to 62 grains, none of which any member expects to withstand the tool.
fn clean_after_wiping(task: &Task) -> wisch::interpret::Interpretation {
    let members = (0..64).map(|k| {
        let some = task.particles.remaining().take(58 + k % 5);
        ParticleDistribution::new(&some.collect::<Vec<_>>()).unwrap()
    });
    let belief = Belief::from_members(members.collect()).unwrap();
    let felt = interpreted_from(&belief, task, &InterpretConfig::from_task(task));
    assert!(felt.performance.low > 0.7, "{:?}", felt.performance);
    felt
}

#[test]
fn dirt_that_a_camera_detects_where_no_member_has_any_is_dirt() {
    let goal = GoalState::Absorbed;
    let task = task(62, LogNormal { mu: -4.0, ..STEEP });
    let felt = clean_after_wiping(&task);
    // Every `nth` grain is missed by the camera, at the rate that the sensor states.
    for (nth, sight) in [(40, camera(0.98)), (5, camera(0.8)), (2, camera(0.5))] {
        let there = task.particles.remaining().take(60).enumerate();
        let seen = Observation {
            detections: (there.filter(|(i, _)| i % nth != 0))
                .map(|(_, place)| place)
                .collect(),
            hidden: Region::default(),
        };
        let mut felt = felt.clone();
        felt.observe(&ObservationUpdate {
            sight,
            ..update(&task, &goal, &seen)
        });
        let estimate = felt.performance;
        let is_contradicted =
            (felt.doubts.iter()).any(|doubt| matches!(doubt, Doubt::ObservationContradicts { .. }));
        assert!(is_contradicted && felt.is_conclusive(), "{nth}");
        assert!(estimate.low < 0.02, "{nth}: {estimate:?}");
        assert!(
            estimate.high < 0.4 / nth as f64 + 0.1,
            "{nth}: {estimate:?}"
        );
    }
    // A single detection where there should be none is a false alarm.
    let seen = Observation {
        detections: vec![Point2::new(0.0, 0.0)],
        hidden: Region::default(),
    };
    let mut alarmed = felt;
    alarmed.observe(&ObservationUpdate {
        sight: camera(0.98),
        ..update(&task, &goal, &seen)
    });
    assert!(alarmed.performance.mean > 0.95, "{:?}", alarmed.performance);
}

#[test]
fn a_camera_that_contradicts_the_log_leaves_hidden_dirt_unknown() {
    let goal = GoalState::Absorbed;
    let task = task(62, LogNormal { mu: -4.0, ..STEEP });
    let mut felt = clean_after_wiping(&task);
    let corners = [[0.0, -0.3], [0.3, -0.3], [0.3, 0.3], [0.0, 0.3]];
    let right = corners.map(|[x, y]| Point2::new(x, y)).to_vec();
    let hidden = Region::new(vec![Polygon::new(right, vec![])]);
    let there = task.particles.remaining();
    let seen = Observation {
        detections: there.filter(|place| !hidden.contains(*place)).collect(),
        hidden,
    };
    felt.observe(&ObservationUpdate {
        sight: camera(0.98),
        ..update(&task, &goal, &seen)
    });
    let estimate = felt.performance;
    assert!(!felt.is_conclusive() && estimate.low < 0.15, "{estimate:?}");
}

/// Three strokes over the right half of a board with known dirt, and an observation after them.
#[test]
fn an_observation_in_another_frame_is_noticed_and_noise_is_none() {
    let task = task(60, STEEP);
    let goal = GoalState::Absorbed;
    let config = InterpretConfig::from_task(&task);
    let upward = |x: f64| [Point2::new(x, -0.09), Point2::new(x, 0.09)];
    let script = Script {
        strokes: [0.03, 0.08, 0.13].map(upward).to_vec(),
        ..Script::default()
    };
    let samples = script.samples(&task);
    let known = Belief::from_particles(task.particles.clone());
    let doubt = |belief: &Belief, detections: Vec<Point2>| {
        let seen = Observation {
            detections,
            hidden: Region::default(),
        };
        let mut felt = interpret(&samples, &task, belief, &goal, &config).unwrap();
        felt.observe(&ObservationUpdate {
            sight: camera(0.98),
            ..update(&task, &goal, &seen)
        });
        let other = felt.doubts.iter();
        other
            .copied()
            .find(|doubt| matches!(doubt, Doubt::ObservationInOtherFrame { .. }))
    };
    let left: Vec<Point2> = (task.particles.remaining().filter(|place| place.x < -0.01)).collect();
    let count = left.len();
    let moved = |to: fn(Point2) -> Point2| left.iter().copied().map(to).collect::<Vec<_>>();
    for detections in [
        moved(|p| -p),
        moved(|p| Point2::new(-p.x, p.y)),
        moved(|p| Point2::new(p.y, p.x)),
        moved(|p| p + Vector2::new(0.03, 0.0)),
    ] {
        let found = doubt(&known, detections);
        let Some(Doubt::ObservationInOtherFrame {
            untouched,
            seen_again,
            unknown,
            of,
        }) = found
        else {
            panic!("{found:?}");
        };
        assert_eq!(of, count);
        assert!(
            (count..count + 6).contains(&untouched),
            "{untouched} of {count}"
        );
        assert!(2 * seen_again < untouched && 2 * unknown > of, "{found:?}");
    }
    // Whether dirt is in the goal area depends on its place.
    let collected = GoalState::Collected {
        center: Point2::new(0.09, 0.0),
        radius: 0.25,
    };
    let seen = Observation {
        detections: moved(|p| Point2::new(-p.x, p.y)),
        hidden: Region::default(),
    };
    let mut felt = interpret(&samples, &task, &known, &collected, &config).unwrap();
    felt.observe(&ObservationUpdate {
        sight: camera(0.98),
        ..update(&task, &collected, &seen)
    });
    assert!(felt.performance.low < 0.5, "{:?}", felt.performance);
    // Errors of the camera, a third of the dirt missed, as many false alarms, and a wiped board.
    let mut noisy = moved(|p| p + Vector2::new(1.5e-3 * (900.0 * p.y).sin(), 1.5e-3));
    assert_eq!(doubt(&known, noisy.clone()), None);
    noisy.truncate(2 * count / 3);
    noisy.extend(places(count / 3, 0.15));
    assert_eq!(doubt(&known, noisy.clone()), None);
    noisy.truncate(3);
    assert_eq!(doubt(&known, noisy), None);
    assert_eq!(doubt(&known, places(count, 0.15)[..4].to_vec()), None);
    // The tool has moved nothing: all known dirt is seen.
    assert_eq!(doubt(&known, task.particles.remaining().collect()), None);
    // Where the places are unknown, no frame contradicts them.
    let anywhere = DirtPrior::Anywhere { count: 60 }.belief(&task, 400);
    assert_eq!(doubt(&anywhere, moved(|p| -p)), None);
    // An observation before the log makes them known.
    let seen = Observation {
        detections: task.particles.remaining().collect(),
        hidden: Region::default(),
    };
    let seen = anywhere.observe(&update(&task, &goal, &seen));
    assert!(doubt(&seen, moved(|p| -p)).is_some());
    assert_eq!(doubt(&seen, left.clone()), None);
}

/// The number of detections is as expected, but all of them lie in the goal area.
#[test]
fn a_share_within_the_goal_that_differs_is_named() {
    let mut task = task(60, STEEP);
    task.action = Action::Collect;
    task.collect_goal = Some(Point2::new(0.1, 0.0));
    let goal = task.goal().unwrap();
    let config = InterpretConfig::from_task(&task);
    let known = Belief::from_particles(task.particles.clone());
    let samples = Script::default().samples(&task);
    let mut felt = interpret(&samples, &task, &known, &goal, &config).unwrap();
    let seen = Observation {
        detections: (0..58)
            .map(|i| Point2::new(0.08 + 7e-4 * f64::from(i), 0.01))
            .collect(),
        hidden: Region::default(),
    };
    felt.observe(&ObservationUpdate {
        sight: camera(0.98),
        ..update(&task, &goal, &seen)
    });
    let text: Vec<String> = felt.doubts.iter().map(ToString::to_string).collect();
    assert!(
        text.iter().any(|text| text.starts_with("of the 58 dirt locations that the observation shows, 100 % lie within the goal, but after the log ")),
        "{text:?}"
    );
}
