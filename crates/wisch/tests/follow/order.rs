//! For absorb, the order of nodes is free: another order moves the joints less and has the same
//! effect.

use std::collections::BTreeSet;
use wisch::follow::{FollowConfig, Followed, Workcell, follow};
use wisch::geometry::{Mesh, Point2, Polygon, Pose, Vector2, Vector3};
use wisch::plan::{CoverageStrategy, Plan, PlanConfig, plan, predict};
use wisch::represent::{Action, Mount, ParticleDistribution, Task};
use wisch_testkit::{block, board, cell, faults};

/// Particles 0.1 m apart on a floor around the arm.
fn floor(action: Action) -> Task {
    let all =
        (-6..=6).flat_map(|i| (-6..=6).map(move |j| Point2::new(f64::from(i), f64::from(j)) * 0.1));
    let places: Vec<Point2> = all
        .filter(|place| (0.35..=0.6).contains(&place.coords.norm()))
        .collect();
    let floor = board(action, [0.0, 0.0, 0.0]);
    let mut scene = floor.scene;
    scene[0].mesh = Mesh::cuboid(Vector3::new(1.6, 1.6, 0.02)).unwrap();
    scene[0].world_from_object = Pose::translation(0.0, 0.0, -0.01);
    let mut surface = floor.surface;
    surface.outline = Polygon::rectangle(Vector2::new(1.6, 1.6));
    let mut tool = floor.tool;
    tool.area_of_effect = Vector2::new(0.07, 0.07);
    tool.mount = Some(Mount::Hand { lean: 0.8 });
    Task {
        scene,
        surface,
        tool,
        particles: ParticleDistribution::new(&places).unwrap(),
        tool_start: places[0],
        ..board(action, [0.0, 0.0, 0.0])
    }
}

fn covering(task: &Task) -> Plan {
    let config = PlanConfig {
        strategy: CoverageStrategy::Kde.into(),
        bandwidth: Some(0.02),
        ..PlanConfig::default()
    };
    plan(task, &config).unwrap()
}

fn followed(task: &Task, plan: &Plan, cell: &Workcell, free_order: bool) -> Followed {
    let config = FollowConfig {
        free_order,
        ..FollowConfig::default()
    };
    follow(task, plan, cell, None, &config, &mut |_| ()).unwrap()
}

fn order(strokes: &[wisch::plan::Stroke]) -> Vec<usize> {
    let nodes = strokes.iter().flat_map(|stroke| stroke.nodes.iter());
    nodes.copied().collect()
}

#[test]
fn joints_move_less_where_the_order_is_theirs_to_choose() {
    let task = floor(Action::Absorb);
    let (plan, cell) = (covering(&task), cell(&task));
    let [in_order, free] = [false, true].map(|free_order| {
        let followed = followed(&task, &plan, &cell, free_order);
        assert_eq!(followed.abandoned, []);
        assert_eq!(faults(&task, &plan, &cell, &followed), [] as [String; 0]);
        followed
    });
    let achieved = |followed: &Followed| {
        let wiped = Plan {
            strokes: followed.strokes.clone(),
            ..plan.clone()
        };
        predict(&task, &wiped, |_| ()).performance.achieved
    };
    assert!(achieved(&free) >= achieved(&in_order));
    let moved = |followed: &Followed| followed.joint_movement(cell.arm_variables());
    let ([_, kept], [_, chosen]) = (moved(&in_order), moved(&free));
    assert!(chosen < 0.8 * kept, "{chosen} rad of {kept}");
    // Each place once, in one stroke, and planned strokes as they are unless the order is free.
    let nodes = order(&free.strokes);
    assert_eq!(
        (free.strokes.len(), nodes.len()),
        (1, plan.graph.nodes.len())
    );
    assert_eq!(nodes.iter().collect::<BTreeSet<_>>().len(), nodes.len());
    let mut once = order(&plan.strokes);
    once.dedup();
    assert_eq!(order(&in_order.strokes), once);
}

#[test]
fn the_order_is_the_same_on_one_thread_and_on_two() {
    let task = floor(Action::Absorb);
    let (plan, cell) = (covering(&task), cell(&task));
    let [one, two] = [1, 2].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        let pool = pool.build().unwrap();
        pool.install(|| followed(&task, &plan, &cell, true))
    });
    assert!(one.duration() > 0.0);
    assert!(format!("{one:?}") == format!("{two:?}"));
}

#[test]
fn what_pushes_or_stands_round_things_keeps_to_what_its_way_does() {
    // A tool that pushes follows the planned order, even if another one is shorter.
    let task = floor(Action::Collect);
    let (plan, cell_) = (covering(&task), cell(&task));
    let [in_order, free] = [false, true].map(|free| followed(&task, &plan, &cell_, free).strokes);
    assert_eq!(in_order, free);
    // At a block, the tool is lifted over the places that it cannot pass.
    let mut task = floor(Action::Absorb);
    task.scene
        .push(block("block", [0.05, 0.05, 0.04], [0.45, 0.15, 0.02]));
    let (plan, cell) = (covering(&task), cell(&task));
    let followed = followed(&task, &plan, &cell, true);
    assert_eq!(faults(&task, &plan, &cell, &followed), [] as [String; 0]);
}
