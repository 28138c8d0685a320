//! Uneven pressure under a tool that leans, and the uncertainty of parameters.

use super::log::{DEPTH, PRESS, STEEP, Script, task};
use super::{exact, interpreted_with};
use wisch::geometry::{Point2, Pose, Vector3};
use wisch::interpret::{
    Belief, InterpretConfig, InterpretError, Interpretation, PerformanceDistribution, TouchSample,
    Uncertainty, interpret,
};
use wisch::represent::{
    Action, DirtArea, Fate, GoalState, LogNormal, OccupiedArea, ParticleDistribution, Surface,
    Task, Treatment, surface_cells,
};

/// A law by which half of the particles respond at half the force.
const HALF: LogNormal = LogNormal {
    mu: -std::f64::consts::LN_2,
    sigma: 0.25,
};
/// Columns of particles under the second stroke, along the tool's x [m].
const COLUMNS: [f64; 5] = [-0.03, -0.015, 0.0, 0.015, 0.03];
const PER_COLUMN: usize = 300;

/// Two strokes beside the particles determine the plane. A further one leads along y over them,
/// with half the force and the tool leaning by an angle about its y axis.
fn leaning(task: &Task, lean: f64) -> Vec<TouchSample> {
    let mut samples = Vec::new();
    let mut at = |x: f64, y: f64, share: f64, lean: f64| {
        let time = 1e-3 * samples.len() as f64;
        let height = DEPTH * (1.0 - share);
        let surface_from_tool = Pose::new(Vector3::new(x, y, height), Vector3::y() * lean);
        samples.push(TouchSample {
            time,
            world_from_tool: task.surface.world_from_surface * surface_from_tool,
            force: task.surface.world_from_surface.rotation
                * Vector3::z()
                * (PRESS * share.max(0.0)),
        });
    };
    let way = |i: i32| f64::from(i) * 1e-4;
    (0..1000).for_each(|i| at(0.5, way(i), 1.0, 0.0));
    (0..1000).for_each(|i| at(0.5 + way(i), 0.1, 1.0, 0.0));
    // In the air, the tool moves to the particles.
    let lift = |i: i32| 1.0 - 0.1 * f64::from(i);
    (0..100).for_each(|i| at(0.6, 0.1, lift(i), 0.0));
    (0..200).for_each(|i| at(0.6 - 0.003 * f64::from(i), 0.1, -9.0, 0.0));
    (0..130).for_each(|i| at(0.0, 0.1 - 0.001 * f64::from(i), -9.0, 0.0));
    (6..100).for_each(|i| at(0.0, -0.03, lift(105 - i), lean));
    (0..600).for_each(|i| at(0.0, way(i) - 0.03, 0.5, lean));
    samples
}

/// Share of each column that a leaning tool absorbs.
fn taken(lean: f64) -> [f64; 5] {
    let mut task = task(0, HALF);
    let places: Vec<Point2> = (COLUMNS.iter())
        .flat_map(|&x| {
            (0..PER_COLUMN).map(move |i| Point2::new(x, 0.04 * i as f64 / PER_COLUMN as f64 - 0.02))
        })
        .collect();
    task.particles = ParticleDistribution::new(&places).unwrap();
    let config = InterpretConfig {
        redraw_length_m: 1.0,
        replays: 16,
        ..exact(&task)
    };
    let interpretation = interpreted_with(&leaning(&task, lean), &task, &config);
    let mut shares = [0.0; 5];
    for replay in interpretation.belief.members() {
        for i in 0..replay.len() {
            if replay.fate(i) == Fate::Absorbed {
                shares[i / PER_COLUMN] += 1.0 / (PER_COLUMN * 16) as f64;
            }
        }
    }
    shares
}

#[test]
fn under_a_leaning_sponge_each_place_has_a_pressure_of_its_own() {
    for lean in [-0.03_f64, 0.0, 0.03] {
        let found = taken(lean);
        for (x, found) in COLUMNS.into_iter().zip(found) {
            // A bed of springs: where the underside is lower by lean * x, it is compressed by so much more.
            let expected = HALF.probability(0.5 + lean.tan() * x / DEPTH);
            // Four standard errors of 4800 draws.
            let error = 4.0 * (0.25 / (PER_COLUMN * 16) as f64).sqrt();
            assert!(
                (found - expected).abs() < error,
                "{lean} {x}: {found}, expected {expected}"
            );
        }
    }
    assert!(HALF.probability(0.5 + 0.18) - HALF.probability(0.5 - 0.18) > 0.8);
}

fn board() -> (Task, Vec<TouchSample>) {
    let task = task(400, STEEP);
    let samples = Script::default().samples(&task);
    (task, samples)
}

/// Interprets the log of a sponge that pushes towards a goal, with some parameters uncertain.
fn pushed(task: &Task, samples: &[TouchSample], uncertainty: Uncertainty) -> Interpretation {
    let goal = GoalState::Collected {
        center: Point2::new(0.16, 0.0),
        radius: 0.12,
    };
    let config = InterpretConfig {
        uncertainty,
        ..InterpretConfig::from_task(task)
    };
    let believed = Belief::from_particles(task.particles.clone());
    interpret(samples, task, &believed, &goal, &config).unwrap()
}

fn width(interpretation: &Interpretation) -> f64 {
    interpretation.performance.high - interpretation.performance.low
}

#[test]
#[ignore = "slow: many cases; `just slow`"]
fn the_interval_widens_with_all_that_is_uncertain() {
    let (task, samples) = board();
    let none = Uncertainty::NONE;
    let certain = pushed(&task, &samples, none);
    // At full force every particle responds, so that little is random where the tool lands and
    // lifts off.
    assert!(width(&certain) < 0.01, "{:?}", certain.performance);
    let default = Uncertainty::default();
    let (grasp_offset_m, grasp_turn) = (default.grasp_offset_m, default.grasp_turn);
    let (particle_m, slip_share) = (default.particle_m, default.slip_share);
    let heap_depth = default.heap_depth;
    let alone = [
        Uncertainty {
            grasp_offset_m,
            ..none
        },
        Uncertainty { grasp_turn, ..none },
        Uncertainty {
            footprint_share: default.footprint_share,
            ..none
        },
        Uncertainty { particle_m, ..none },
        Uncertainty { slip_share, ..none },
        Uncertainty { heap_depth, ..none },
        default,
    ];
    for uncertainty in alone {
        let interpretation = pushed(&task, &samples, uncertainty);
        assert!(
            width(&interpretation) > 0.0,
            "{uncertainty:?}: {:?}",
            interpretation.performance
        );
        let times = |factor: f64| Uncertainty {
            grasp_offset_m: factor * uncertainty.grasp_offset_m,
            grasp_turn: factor * uncertainty.grasp_turn,
            footprint_share: factor * uncertainty.footprint_share,
            particle_m: factor * uncertainty.particle_m,
            slip_share: factor * uncertainty.slip_share,
            heap_depth: factor * uncertainty.heap_depth,
            ..uncertainty
        };
        // With all uncertainties together, the interval cannot become wider between 0 and 1.
        let pair = if uncertainty == default {
            [default, times(1.0 / 3.0)]
        } else {
            [
                times(if uncertainty.grasp_turn > 0.0 {
                    8.0
                } else {
                    3.0
                }),
                uncertainty,
            ]
        };
        let widths = pair.map(|uncertainty| width(&pushed(&task, &samples, uncertainty)));
        // The more particles slip, the more of them lie where the next stroke carries them along.
        let slips_alone = uncertainty.slip_share > 0.0 && uncertainty.heap_depth == 0.0;
        assert!(
            slips_alone || widths[0] > widths[1],
            "{widths:?} {uncertainty:?}"
        );
    }
    let model = Uncertainty {
        model_share: 0.1,
        ..none
    };
    let interpretation = pushed(&task, &samples, model).performance;
    assert_eq!(interpretation.mean, certain.performance.mean);
    // A normal distribution: 1.645 standard deviations to either side.
    assert!(
        (interpretation.high - interpretation.low - 0.329).abs() < 1e-3,
        "{interpretation:?}"
    );
}

#[test]
fn a_force_known_badly_counts_where_contact_is_weak() {
    let task = task(400, STEEP);
    // One stroke with full force determines the plane.
    let script = Script {
        press: |place| {
            if place.y < -0.05 { PRESS } else { 0.4 * PRESS }
        },
        ..Script::default()
    };
    let samples = script.samples(&task);
    let with = |force_share| {
        let uncertainty = Uncertainty {
            force_share,
            ..Uncertainty::NONE
        };
        let config = InterpretConfig {
            uncertainty,
            ..InterpretConfig::from_task(&task)
        };
        width(&interpreted_with(&samples, &task, &config))
    };
    assert!(with(0.2) > 2.0 * with(0.0), "{} {}", with(0.2), with(0.0));
}

#[test]
fn a_stiffness_known_badly_counts_where_the_tool_leans() {
    let task = task(400, STEEP);
    // A softer tool presses more evenly where the surface leans, which one stroke with full force
    // shows.
    let press = |place: Point2| {
        if place.y < -0.05 { PRESS } else { 0.15 * PRESS }
    };
    let leaning = Script {
        press,
        surface: |place| 0.03 * place.x,
        ..Script::default()
    };
    let even = Script {
        press,
        ..Script::default()
    };
    let with = |script: &Script, stiffness_share| {
        let uncertainty = Uncertainty {
            stiffness_share,
            ..Uncertainty::NONE
        };
        let config = InterpretConfig {
            uncertainty,
            ..InterpretConfig::from_task(&task)
        };
        width(&interpreted_with(&script.samples(&task), &task, &config))
    };
    let (known, unknown) = (with(&leaning, 0.0), with(&leaning, 0.4));
    assert!(unknown > 1.5 * known, "{unknown}, known {known}");
    assert_eq!(with(&even, 0.4), with(&even, 0.0));
}

#[test]
fn without_a_touch_what_was_certain_stays_certain() {
    let (task, _) = board();
    let interpretation = pushed(&task, &[], Uncertainty::default());
    let lie = |p: &Point2| (p - Point2::new(0.16, 0.0)).norm() <= 0.12;
    let share = task.particles.remaining().filter(lie).count() as f64 / 400.0;
    // Only particles near the border of the goal are uncertain: positions are known to a millimetre
    // or two.
    assert!((interpretation.performance.mean - share).abs() < 0.01);
    assert!(
        width(&interpretation) < 0.03,
        "{:?}",
        interpretation.performance
    );
    let nothing = pushed(&task, &[], Uncertainty::NONE);
    assert_eq!(nothing.performance.mean, share);
    assert_eq!(width(&nothing), 0.0);
}

#[test]
fn equal_shares_have_that_share_as_their_mean() {
    let surface: Surface = task(0, STEEP).surface;
    let at = |x: f64| Point2::new(x, 0.0);
    let four_of_five = [at(0.0), at(0.0), at(0.0), at(0.0), at(0.1)];
    let replay = ParticleDistribution::new(&four_of_five).unwrap();
    let goal = GoalState::Collected {
        center: at(0.0),
        radius: 0.05,
    };
    for count in 1..100 {
        let belief = Belief::from_members(vec![replay.clone(); count]).unwrap();
        let interpretation = belief.performance(&goal, &surface, 0.0).estimate();
        assert_eq!(
            [interpretation.low, interpretation.mean, interpretation.high],
            [0.8; 3]
        );
    }
}

#[test]
fn an_uncertainty_out_of_range_is_refused_by_name() {
    let task = task(0, STEEP);
    for wrong in [-1e-3, 1.5, f64::NAN, f64::INFINITY] {
        let config = InterpretConfig {
            uncertainty: Uncertainty {
                grasp_turn: wrong,
                ..Uncertainty::default()
            },
            ..InterpretConfig::from_task(&task)
        };
        let refused = wisch::interpret::Interpreter::new(&task, &config).unwrap_err();
        let InterpretError::Config { name, .. } = refused else {
            panic!("{refused}");
        };
        assert_eq!(name, "uncertainty.grasp_turn");
    }
}

/// The tool slides over a bent plate that is believed to be flat, so it is unknown what the first log polished.
#[test]
fn passes_of_a_round_whose_effect_is_unknown_stay_unknown() {
    let mut plate = task(1, STEEP);
    plate.action = Action::Polish;
    plate.treatment = Some(Treatment::Polish {
        passes: 1,
        max_passes: 2,
        preston: None,
    });
    let area = DirtArea {
        outline: &plate.surface.outline,
        occupied: &OccupiedArea::default(),
    };
    plate.particles = surface_cells(area, 300).unwrap();
    let goal = GoalState::Polished { passes: 1 };
    let config = InterpretConfig::from_task(&plate);
    let polished = |script: &Script, belief: &Belief| {
        interpret(&script.samples(&plate), &plate, belief, &goal, &config).unwrap()
    };
    let mean_passes = |belief: &Belief| {
        let members = belief.members().iter().zip(belief.weights());
        let shares = members.map(|(places, weight)| (Treatment::spread(places)[0] / 10.0, *weight));
        PerformanceDistribution::from_shares(shares, 0.0)
            .interval(0.9)
            .map(|share| 10.0 * share)
    };
    let before = Belief::from_particles(plate.particles.clone());
    let flat = polished(&Script::default(), &before);
    let [least, full] = mean_passes(&flat.belief);
    assert!(flat.is_conclusive() && least > 0.8 * full, "{least} {full}");
    let bent = Script {
        surface: |place| -place.x * place.x / 1.2,
        ..Script::default()
    };
    let unknown = polished(&bent, &before);
    assert!(!unknown.is_conclusive(), "{:?}", unknown.doubts);
    let [low, high] = mean_passes(&unknown.belief);
    assert!(
        low < 0.1 * full && high > 0.8 * full,
        "{low} to {high} of {full}"
    );
    // A later round adds its own passes, and leaves those of the first one open.
    let later = polished(&Script::default(), &unknown.belief);
    let [low, high] = mean_passes(&later.belief);
    assert!(later.is_conclusive());
    assert!(
        low < 1.2 * full && high > 1.7 * full,
        "{low} to {high} of {full}"
    );
}

/// The tool passes 12 mm over the board without any force, in several rounds. If the sensor is dead, it is dead in all.
#[test]
fn rounds_without_contact_do_not_add_up_to_certainty() {
    let task = task(80, STEEP);
    let mut belief = Belief::from_particles(task.particles.clone());
    let mut means = Vec::new();
    for seed in 0..6 {
        let config = InterpretConfig {
            seed,
            ..InterpretConfig::from_task(&task)
        };
        let mut samples = Script::default().samples(&task);
        let up = task.surface.world_from_surface.rotation * Vector3::z() * 0.012;
        for sample in &mut samples {
            sample.world_from_tool.translation.vector += up;
            sample.force = Vector3::zeros();
        }
        let found = interpret(&samples, &task, &belief, &GoalState::Absorbed, &config).unwrap();
        assert!(
            !found.is_conclusive() && found.performance.low < 0.1,
            "{seed}"
        );
        belief = found.belief;
        means.push(
            belief
                .performance(&GoalState::Absorbed, &task.surface, 0.0)
                .mean(),
        );
    }
    assert!(means.iter().all(|mean| *mean < 0.65), "{means:?}");
    assert!(means[5] > 0.2, "{means:?}");
}
