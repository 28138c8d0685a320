//! Polishing and painting: passes over places against closed forms, lanes, and their goals; and tools that hover.

use nalgebra::UnitQuaternion;
use wisch::geometry::{PlanarPose, Point2, Polygon, Pose, Region, Vector2, Vector3};
use wisch::interpret::{
    Belief, Diagnosis, Doubt, InterpretConfig, Interpretation, TouchSample, Uncertainty, interpret,
};
use wisch::plan::{
    CoverageStrategy, Plan, PlanConfig, Planner, Strategy, check_strokes, plan, predict,
};
use wisch::recover::remaining_dirt;
use wisch::represent::{
    Action, Effect, EffectModel, Fate, GoalState, Interaction, ParticleDistribution, ParticleField,
    Performance, Task, ToolMotion, Treatment, surface_cells,
};
use wisch::represent::{DirtArea, OccupiedArea};
use wisch_testkit::{board, interaction, surface};

const TOOL: [f64; 2] = [0.07, 0.11];

fn pad() -> Region {
    Region::new(vec![Polygon::rectangle(Vector2::from(TOOL))])
}

fn pose(x: f64, y: f64, heading: f64) -> PlanarPose {
    PlanarPose::new(Point2::new(x, y), heading)
}

/// Passes over one place.
fn passes(footprint: &Region, at: Point2, motions: &[ToolMotion]) -> f64 {
    let mut field = ParticleField::new(&ParticleDistribution::new(&[at]).unwrap());
    let mut model = EffectModel::new(footprint, Effect::Treat);
    for motion in motions {
        model.apply(&mut field, &surface([2.0; 2]), motion);
    }
    let after = field.distribution();
    assert_eq!((after.position(0), after.tally().remaining), (at, 1));
    after.fate(0).passes()
}

fn motion(from: PlanarPose, to: PlanarPose) -> ToolMotion {
    ToolMotion { from, to }
}

#[test]
fn a_pass_is_the_way_of_the_tool_over_a_place_over_its_length() {
    let over = motion(pose(-0.2, 0.0, 0.0), pose(0.2, 0.0, 0.0));
    let at = Point2::new(0.01, 0.05);
    assert!((passes(&pad(), at, &[over]) - 1.0).abs() < 1e-12);
    assert_eq!(passes(&pad(), Point2::new(0.0, 0.056), &[over]), 0.0);
    // Set down on it and drawn off by 2 cm; and along its broad side.
    let off = motion(pose(0.0, 0.0, 0.0), pose(0.02, 0.0, 0.0));
    assert!((passes(&pad(), at, &[off]) - 0.02 / 0.07).abs() < 1e-12);
    let aside = motion(pose(0.0, -0.2, 0.0), pose(0.0, 0.2, 0.0));
    assert!((passes(&pad(), at, &[aside]) - 0.11 / 0.07).abs() < 1e-12);
    // Turning in place, it slides by radius times angle.
    let turn = motion(pose(0.0, 0.0, 0.3), pose(0.0, 0.0, 0.3 + 1.0));
    let near = Point2::new(0.02, 0.01);
    let expected = near.coords.norm() / 0.07;
    assert!((passes(&pad(), near, &[turn]) - expected).abs() < 1e-9);
    // Two halves with a gap count as one piece: passes are the distance over which the tool slides.
    let half = |x: f64| {
        let corners = Polygon::rectangle(Vector2::new(0.02, 0.11));
        let moved = corners.outer().iter().map(|p| p + Vector2::new(x, 0.0));
        Polygon::new(moved.collect(), vec![])
    };
    let halves = Region::new(vec![half(-0.03), half(0.03)]);
    assert!((passes(&halves, at, &[over]) - 1.0).abs() < 1e-12);
}

#[test]
fn splitting_a_motion_changes_no_passes() {
    for turn in [0.0, 0.8, -2.5, 9.0] {
        let [from, to] = [pose(-0.1, 0.02, 0.2), pose(0.12, -0.03, 0.2 + turn)];
        let at = |i: usize| {
            let share = i as f64 / 64.0;
            PlanarPose::new(
                from.position + (to.position - from.position) * share,
                from.heading + turn * share,
            )
        };
        let split: Vec<ToolMotion> = (0..64).map(|i| motion(at(i), at(i + 1))).collect();
        for place in [[0.0, 0.0], [0.03, 0.04], [-0.09, 0.05], [0.1, -0.07]] {
            let place = Point2::from(place);
            let whole = passes(&pad(), place, &[motion(from, to)]);
            let parts = passes(&pad(), place, &split);
            assert!(
                (whole - parts).abs() < 1e-9,
                "{turn} {place}: {whole} {parts}"
            );
        }
    }
}

/// The passes of a pad that spins while it travels, against the sum over small steps.
#[test]
fn a_spinning_pad_passes_as_far_as_it_slides_under_it() {
    let [from, to] = [pose(-0.02, 0.01, 0.3), pose(0.03, -0.01, 0.3 + 4.0)];
    let steps = 200_000;
    for place in [
        [0.0, 0.0],
        [0.04, 0.03],
        [-0.05, 0.02],
        [0.03, -0.055],
        [0.08, 0.0],
    ] {
        let place = Point2::from(place);
        let in_tool = |i: usize| {
            let share = i as f64 / steps as f64;
            let (sin, cos) = (from.heading + 4.0 * share).sin_cos();
            let d = place - (from.position + (to.position - from.position) * share);
            Point2::new(cos * d.x + sin * d.y, cos * d.y - sin * d.x)
        };
        // The tool's velocity at the place: how far the place moves in the tool's frame.
        let slid: f64 = (0..steps)
            .map(|i| (in_tool(i), in_tool(i + 1)))
            .filter(|(at, _)| at.x.abs() < TOOL[0] / 2.0 && at.y.abs() < TOOL[1] / 2.0)
            .map(|(at, next)| (next - at).norm())
            .sum();
        let found = passes(&pad(), place, &[motion(from, to)]);
        assert!((found - slid / TOOL[0]).abs() < 1e-4, "{place}: {found}");
    }
}

/// A plate without a scene, with a treatment of its points.
fn task(action: Action, treatment: Treatment, size: [f64; 2]) -> Task {
    let mut task = board(Action::Absorb, [0.0, 0.0, 0.0]);
    task.scene.clear();
    task.action = action;
    task.treatment = Some(treatment);
    task.surface = surface(size);
    let area = DirtArea {
        outline: &task.surface.outline,
        occupied: &OccupiedArea::default(),
    };
    task.particles = surface_cells(area, (size[0] * size[1] / 1e-4) as usize).unwrap();
    task.tool_start = Point2::new(-size[0] / 2.0, -size[1] / 2.0);
    task
}

fn polish(passes: u32, size: [f64; 2]) -> Task {
    let treatment = Treatment::Polish {
        passes,
        max_passes: passes + 1,
        preston: None,
    };
    task(Action::Polish, treatment, size)
}

/// Paint of a tenth of a millimetre, which the sponge dispenses in this number of passes.
fn paint(coats: f64, size: [f64; 2]) -> Task {
    let thickness = 1e-4;
    let volume_per_metre = thickness * TOOL[1] / coats;
    let treatment = Treatment::Dispense {
        thickness,
        volume_per_metre,
    };
    task(Action::Dispense, treatment, size)
}

fn lanes() -> PlanConfig {
    PlanConfig {
        strategy: Strategy::Lanes,
        ..PlanConfig::default()
    }
}

fn share(task: &Task, plan: &Plan) -> f64 {
    predict(task, plan, |_| ()).performance.ratio()
}

#[test]
fn lanes_pass_every_place_on_hardly_more_than_the_shortest_way() {
    for (wanted, size) in [
        (1, [0.5, 0.31]),
        (2, [0.5, 0.31]),
        (3, [0.31, 0.8]),
        (2, [1.0, 0.6]),
    ] {
        let task = polish(wanted, size);
        let plan = plan(&task, &lanes()).unwrap();
        assert_eq!(share(&task, &plan), 1.0, "{wanted} {size:?}");
        let shortest = size[0] * size[1] / TOOL[1] * f64::from(wanted);
        let way = plan.contact_distance() / shortest;
        assert!(way <= 1.3, "{wanted} {size:?}: {way}");
        // Points between two lanes get one pass more than required, and those in corners a little
        // more.
        let after = predict(&task, &plan, |_| ()).particles;
        let most = f64::from(wanted) + 1.5;
        let above = after
            .iter()
            .filter(|(_, fate)| fate.passes() > most)
            .count();
        assert!(
            above * 50 <= after.len(),
            "{wanted} {size:?}: {above} of {}",
            after.len()
        );
        // The length of the path is due to the number of passes: a further pass is not reached.
        let mut more = plan.clone();
        more.graph.goal = GoalState::Polished { passes: wanted + 1 };
        assert!(share(&task, &more) < 0.5, "{wanted} {size:?}");
    }
}

#[test]
fn paint_is_as_thick_as_wanted_and_wasted_hardly_anywhere() {
    for (coats, size) in [(1.0, [1.0, 0.55]), (2.0, [1.0, 0.55]), (1.1, [0.8, 0.44])] {
        let task = paint(coats, size);
        let plan = plan(&task, &lanes()).unwrap();
        let prediction = predict(&task, &plan, |_| ());
        assert!(prediction.performance.ratio() >= 0.95, "{coats} {size:?}");
        let [mean, deviation] = Treatment::spread(&prediction.particles);
        assert!((mean / coats.round() - 1.0).abs() < 0.02, "{mean}");
        assert!(deviation / mean < 0.1, "{deviation}");
        let per_pass = task.depth_per_pass();
        assert!((per_pass.unwrap() * coats - 1e-4).abs() < 1e-12);
    }
}

#[test]
fn a_coat_thinner_than_half_a_pass_is_refused() {
    let error = plan(&paint(0.4, [0.3, 0.3]), &lanes()).unwrap_err();
    let words = error.to_string();
    assert!(words.contains("one pass leaves 0.25"), "{words}");
}

#[test]
fn only_what_is_missing_is_gone_over_again() {
    let task = polish(2, [0.5, 0.31]);
    let goal = task.goal().unwrap();
    let whole = plan(&task, &lanes()).unwrap();
    let mut half = whole.clone();
    half.strokes.truncate(1);
    let mut after = task.clone();
    after.particles = predict(&task, &half, |_| ()).particles;
    let open = remaining_dirt(&after, &goal).unwrap();
    assert!(open.len() < task.particles.len() * 3 / 4);
    let rest = Planner::new(&after, &lanes())
        .with_remaining(&open)
        .plan_best(1)
        .unwrap();
    assert!(rest.contact_distance() < 0.8 * whole.contact_distance());
    assert_eq!(share(&after, &rest), 1.0);
    let mut done = after.clone();
    done.particles = predict(&after, &rest, |_| ()).particles;
    let open = remaining_dirt(&done, &goal).unwrap();
    assert!(open.is_empty());
}

/// Puts a cup of 6 cm on the surface.
fn put_cup(task: &mut Task, x: f64, y: f64) {
    let mut cup = board(Action::Absorb, [0.0, 0.0, 0.0]).scene.remove(0);
    cup.mesh = wisch::geometry::Mesh::cylinder(0.03, 0.2, 24).unwrap();
    cup.part = wisch::represent::ScenePart::Obstacle;
    cup.world_from_object = task.surface.world_from_surface * Pose::translation(x, y, 0.1);
    task.scene = vec![cup];
}

#[test]
fn lanes_keep_clear_of_what_stands_on_the_surface() {
    let mut task = polish(1, [0.8, 0.5]);
    put_cup(&mut task, 0.05, 0.02);
    let plan = plan(&task, &lanes()).unwrap();
    let middle = Point2::new(0.05, 0.02);
    for pose in plan.strokes.iter().flat_map(|stroke| &stroke.poses) {
        let clear = (pose.position - middle).norm() - 0.03;
        assert!(clear >= plan.collision_radius - 1e-3, "{clear}");
    }
    assert!(share(&task, &plan) > 0.8);
}

/// Outlines whose borders are slanted or notched, with a hole, and beside an object.
fn odd_outlines() -> Vec<Polygon> {
    let ring = |points: &[[f64; 2]]| points.iter().copied().map(Point2::from).collect::<Vec<_>>();
    let mut outlines = vec![
        Polygon::new(ring(&[[0.0, 0.0], [0.4, 0.0], [0.2, 0.3]]), vec![]),
        Polygon::new(ring(&[[0.0, 0.0], [0.5, 0.1], [0.1, 0.12]]), vec![]),
        Polygon::new(
            ring(&[
                [0.0, 0.0],
                [0.5, 0.0],
                [0.5, 0.2],
                [0.2, 0.2],
                [0.2, 0.5],
                [0.0, 0.5],
            ]),
            vec![],
        ),
        Polygon::new(
            ring(&[[0.0, 0.0], [0.4, 0.0], [0.4, 0.4], [0.2, 0.15], [0.0, 0.4]]),
            vec![],
        ),
        Polygon::new(
            ring(&[[-0.3, -0.2], [0.3, -0.2], [0.3, 0.2], [-0.3, 0.2]]),
            vec![ring(&[[0.0, -0.08], [0.1, 0.02], [-0.05, 0.1]])],
        ),
    ];
    outlines.extend((1..=12).map(|i| {
        let angle = |k: u32| f64::from(k) * 2.1 + 0.37 * f64::from(i);
        let corner = |k: u32| [0.3 * angle(k).cos(), 0.22 * angle(k).sin()];
        Polygon::new(ring(&[corner(0), corner(1), corner(2)]), vec![])
    }));
    outlines
}

#[test]
fn lanes_stay_within_the_limits_of_strokes_that_are_given() {
    for (index, outline) in odd_outlines().into_iter().enumerate() {
        for mut task in [
            polish(1, [0.4; 2]),
            polish(3, [0.4; 2]),
            paint(1.0, [0.4; 2]),
        ] {
            task.surface.outline = outline.clone();
            if index % 2 == 1 {
                put_cup(&mut task, 0.05, 0.05);
            }
            let occupied = task.occupied_area();
            let area = DirtArea {
                outline: &outline,
                occupied: &occupied,
            };
            task.particles = surface_cells(area, 600).unwrap();
            let plan = plan(&task, &lanes()).unwrap();
            let checked = check_strokes(&task, &plan.strokes);
            let (name, share) = (task.action, share(&task, &plan));
            assert!(checked.is_ok(), "{index} {name}: {checked:?}");
            // Beside a cup there is little room on the narrow ones.
            assert!(share > 0.6 || index % 2 == 1, "{index} {name}: {share}");
        }
    }
}

#[test]
fn a_strategy_that_does_not_fit_the_action_is_refused() {
    let task = polish(1, [0.5, 0.3]);
    let kde = PlanConfig {
        strategy: CoverageStrategy::Kde.into(),
        ..PlanConfig::default()
    };
    let error = plan(&task, &kde).unwrap_err().to_string();
    assert_eq!(
        error,
        "strategy \"kde\" cannot plan the action polish; strategies that can: lanes, best"
    );
    let wiped = board(Action::Absorb, [0.0, 0.0, 0.0]);
    let error = plan(&wiped, &lanes()).unwrap_err().to_string();
    assert!(
        error.contains("\"lanes\" cannot plan the action absorb"),
        "{error}"
    );
}

#[test]
fn passes_are_counted_whole_and_coats_within_a_fifth() {
    let surface = surface([1.0; 2]);
    let met = |goal: GoalState, passes| {
        let place = (Point2::origin(), Fate::Treated { passes });
        let places = ParticleDistribution::with_fates(&[place]).unwrap();
        let performance = Performance::evaluate(&places, &goal, &surface);
        (performance.achieved, performance.lost)
    };
    let polished = GoalState::Polished { passes: 2 };
    assert_eq!(met(polished, 1.49), (0, 0));
    assert_eq!(met(polished, 1.5), (1, 0));
    assert_eq!(met(polished, 7.0), (1, 0));
    let dispensed = GoalState::Dispensed {
        thickness: 1e-4,
        per_pass: 5e-5,
    };
    assert_eq!(met(dispensed, 1.59), (0, 0));
    assert_eq!(met(dispensed, 1.61), (1, 0));
    assert_eq!(met(dispensed, 2.39), (1, 0));
    assert_eq!(
        met(dispensed, 2.41),
        (0, 1),
        "nothing takes paint off again"
    );
    assert_eq!(
        [0.0, 0.4, 0.6, 1.6].map(|had| polished.missing_passes(had)),
        [2, 2, 1, 0]
    );
}

/// A stroke at 10 cm/s along x at a height over the believed surface, with a force [N] along its normal.
fn stroke(task: &Task, height: f64, force: f64) -> Vec<TouchSample> {
    let world_from_surface = task.surface.world_from_surface;
    let sample = |i: u32| {
        let time = f64::from(i) * 1e-3;
        let at = Pose::translation(0.1 * time - 0.2, 0.0, height);
        TouchSample::new(
            time,
            world_from_surface * at,
            world_from_surface * Vector3::new(0.0, 0.0, force),
        )
    };
    (0..4000).map(sample).collect()
}

/// A stroke at 10 cm/s along x over the surface with 10 N, at 100 Hz, of a tool that spins at this rate [rad/s].
fn spinning_stroke(task: &Task, rate: f64) -> Vec<TouchSample> {
    let world_from_surface = task.surface.world_from_surface;
    let sample = |i: u32| {
        let time = f64::from(i) * 1e-2;
        let lift = (0.5 - time).max(time - 2.5).max(0.0);
        let turn = UnitQuaternion::from_euler_angles(0.0, 0.0, rate * time);
        let force = if lift > 0.0 { 0.0 } else { 10.0 };
        TouchSample::new(
            time,
            world_from_surface * Pose::translation(0.1 * time - 0.15, 0.0, 0.1 * lift) * turn,
            world_from_surface * Vector3::new(0.0, 0.0, force),
        )
    };
    (0..=300).map(sample).collect()
}

/// The turn between two samples counts; beyond half a turn the log does not show it.
#[test]
fn a_pad_that_spins_faster_than_the_samples_show_leaves_the_passes_unknown() {
    let task = polish(1, [0.32, 0.04]);
    let is_fast = |found: &Interpretation| {
        (found.doubts.iter()).any(|doubt| matches!(doubt, Doubt::FastTurns { .. }))
    };
    for rate in [0.0, -40.0] {
        let found = read(&task, &spinning_stroke(&task, rate), Uncertainty::NONE);
        assert!(
            !is_fast(&found) && found.is_conclusive(),
            "{rate}: {:?}",
            found.doubts
        );
    }
    // 4 rad and 1.7 rad per sample.
    for rate in [400.0, 170.0] {
        let found = read(&task, &spinning_stroke(&task, rate), Uncertainty::default());
        assert!(
            is_fast(&found) && !found.is_conclusive(),
            "{rate}: {:?}",
            found.doubts
        );
    }
    // Absorbed dirt is gone after the first touch, however fast the tool turns.
    let mut absorb = board(Action::Absorb, [0.0, 0.0, 0.0]);
    absorb.particles = ParticleDistribution::new(&[Point2::new(0.0, 0.0)]).unwrap();
    let found = read(
        &absorb,
        &spinning_stroke(&absorb, 400.0),
        Uncertainty::default(),
    );
    assert!(
        is_fast(&found) && found.is_conclusive(),
        "{:?}",
        found.doubts
    );
}

fn estimated(task: &Task, samples: &[TouchSample]) -> (Diagnosis, f64) {
    let found = read(task, samples, Uncertainty::default());
    (found.diagnosis, found.performance.mean)
}

fn read(task: &Task, samples: &[TouchSample], uncertainty: Uncertainty) -> Interpretation {
    let believed = Belief::from_particles(task.particles.clone());
    let config = InterpretConfig {
        uncertainty,
        ..InterpretConfig::from_task(task)
    };
    let goal = task.goal().unwrap();
    interpret(samples, task, &believed, &goal, &config).unwrap()
}

#[test]
fn a_pass_that_is_not_pressed_is_none() {
    let mut task = polish(1, [0.4, 0.1]);
    task.interaction = Interaction {
        press_force_n: 10.0,
        ..interaction()
    };
    let pressed = read(&task, &stroke(&task, 0.0, 10.0), Uncertainty::NONE);
    assert_eq!(pressed.diagnosis, Diagnosis::Localized);
    assert!(pressed.performance.mean > 0.8, "{:?}", pressed.performance);
    let weak = read(&task, &stroke(&task, 0.0, 1.0), Uncertainty::NONE);
    assert!(weak.performance.mean < 0.1, "{:?}", weak.performance);
    // Without free motion, and with another force than declared, the performance is unknown.
    let weak = read(&task, &stroke(&task, 0.0, 1.0), Uncertainty::default());
    assert!(!weak.is_conclusive());
}

#[test]
fn the_effect_of_a_hovering_tool_follows_from_its_poses_without_force() {
    let mut task = board(Action::Absorb, [0.0, 0.0, 0.0]);
    let places: Vec<Point2> = (0..40)
        .map(|i| Point2::new(0.008 * f64::from(i) - 0.16, 0.0))
        .collect();
    task.particles = ParticleDistribution::new(&places).unwrap();
    task.interaction = Interaction {
        gap_m: 0.003,
        ..interaction()
    };
    let (found, near) = estimated(&task, &stroke(&task, 0.0, 0.0));
    assert_eq!(found, Diagnosis::Hovering);
    assert!(near > 0.9, "{near}");
    let (found, far) = estimated(&task, &stroke(&task, 0.05, 0.0));
    assert_eq!((found, far), (Diagnosis::Hovering, 0.0));
    // If a tool with contact measures no force, the performance is unknown: the force may be
    // misread.
    task.interaction.gap_m = 0.0;
    let found = read(&task, &stroke(&task, 0.0, 0.0), Uncertainty::default());
    assert_eq!(found.diagnosis, Diagnosis::NoContact);
    assert!(!found.is_conclusive() && found.performance.high > 0.9);
}
