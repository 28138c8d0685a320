//! The objective by which plans for the same dirt are compared: their predicted effect.

use super::edge_margin::EdgeMargin;
use super::nominal_times::NominalTimes;
use super::score::DirtTerms;
use super::{Plan, Stroke};
use crate::represent::{Effect, ParticleField, Task};

/// Objective of doing nothing for as long as a plan takes [particles], see [`objective`]; meanwhile
/// a liquid film runs.
pub(super) fn objective_at_rest(task: &Task, plan: &Plan) -> i64 {
    let goal = &plan.graph.goal;
    if !task.has_running_film() {
        return DirtTerms::evaluate(&task.particles, goal, &task.surface, None).whole();
    }
    let mut field = ParticleField::new(&task.particles);
    let mut model = task.effect_model(&task.tool.footprint, goal.action().effect());
    let times = NominalTimes::of(task);
    for (motions, before) in plan
        .strokes
        .iter()
        .map(Stroke::motions)
        .zip(times.before(plan))
    {
        model.wait(&mut field, &task.surface, before);
        for (_, time) in motions.flat_map(|motion| times.parts(&motion)) {
            model.wait(&mut field, &task.surface, time);
        }
    }
    DirtTerms::evaluate(&field.distribution(), goal, &task.surface, None).whole()
}

/// Whether a plan is predicted to have a higher objective than doing nothing for the same time.
pub fn has_predicted_gain(task: &Task, plan: &Plan) -> bool {
    objective(task, plan) > objective_at_rest(task, plan)
}

/// Objective of a plan [particles]: the number of particles predicted to end where they belong, less two costs.
/// Each particle that falls over a wrong edge costs three. Each that is pushed so near an edge that part of the
/// heap would fall costs a share. Pushed dirt heaps up before the tool: of a heap brought just to the rim of the
/// goal, part lies beyond it.
pub(super) fn objective(task: &Task, plan: &Plan) -> i64 {
    let mut margin = EdgeMargin::new(
        &task.particles,
        &task.surface,
        &plan.graph.goal,
        plan.collision_radius,
    );
    let effect = plan.graph.goal.action().effect();
    let mut field = ParticleField::new(&task.particles);
    let mut model = task.effect_model(&task.tool.footprint, effect);
    let mut touched = Vec::new();
    let times = NominalTimes::of(task);
    for (motions, before) in plan
        .strokes
        .iter()
        .map(Stroke::motions)
        .zip(times.before(plan))
    {
        model.wait(&mut field, &task.surface, before);
        for (motion, time) in motions.flat_map(|motion| times.parts(&motion)) {
            touched.clear();
            model.apply_where(&mut field, &task.surface, &motion, |particle, _| {
                touched.push(particle);
                true
            });
            model.wait(&mut field, &task.surface, time);
            // Only pushed dirt comes near an edge.
            if effect == Effect::Push {
                margin.pass_of(&field, touched.iter().copied());
            }
        }
        model.lift_off(&mut field, &task.surface);
    }
    let (after, goal) = (field.distribution(), &plan.graph.goal);
    DirtTerms::evaluate(&after, goal, &task.surface, Some(&margin)).whole()
}

/// Returns the plan with the highest objective; of equal plans, the one with the shortest path in
/// contact. If a liquid film runs, liquid that would run off without the plan does not count for
/// the plan.
///
/// The objective is the number of particles that reach the goal, less several for each that falls over a wrong
/// edge, because remaining dirt can be wiped again and lost dirt cannot. Particles pushed so near an edge that
/// part of a heap would fall count less. The prediction covers all dirt of the task, so that a stroke that
/// scatters a heap counts against its plan.
pub(super) fn best_by_objective(
    task: &Task,
    plans: impl IntoIterator<Item = Plan>,
) -> Option<Plan> {
    let scored = plans.into_iter().map(|plan| {
        // If no film runs, doing nothing has the same objective for every plan.
        let at_rest = if task.has_running_film() {
            objective_at_rest(task, &plan)
        } else {
            0
        };
        let gain = objective(task, &plan) - at_rest;
        (gain, plan.contact_distance(), plan)
    });
    let best = scored.reduce(|best, next| {
        let is_better = next.0 > best.0 || next.0 == best.0 && next.1 < best.1;
        if is_better { next } else { best }
    });
    best.map(|(_, _, plan)| plan)
}

#[cfg(test)]
mod tests {
    use super::super::{CoverageStrategy, Node, NodeRole, SemanticDirectedGraph, Stroke, predict};
    use super::*;
    use crate::geometry::{Mesh, PlanarPose, Point2, Polygon, Pose, Region, Vector2, Vector3};
    use crate::represent::{
        Action, AngleRange, GoalState, Interaction, LogNormal, LogNormalSpread,
        ParticleDistribution, Redraw, Surface, SurfaceScope, Tool,
    };
    use std::f64::consts::FRAC_PI_2;

    /// A task with crumbs on a board that ends at y = -0.14.
    fn task(crumbs: &[Point2]) -> Task {
        Task {
            name: "test".into(),
            action: Action::Collect,
            surface: Surface {
                name: "board".into(),
                outline: Polygon::rectangle(Vector2::new(0.4, 0.28)),
                world_from_surface: Pose::identity(),
                skim_edges: vec![0],
                shape: Default::default(),
            },
            scene: vec![],
            tool: Tool {
                name: "sponge".into(),
                mesh: Mesh::cuboid(Vector3::new(0.07, 0.11, 0.05)).unwrap(),
                footprint: Region::new(vec![Polygon::rectangle(Vector2::new(0.07, 0.11))]),
                area_of_effect: Vector2::new(0.07, 0.11),
                rotation_about_normal: AngleRange::FULL,
                tilt: None,
                mount: None,
                second_grip: None,
            },
            medium: "breadcrumbs".into(),
            mobility: Default::default(),
            interaction: Interaction {
                tool: "sponge".into(),
                medium: "breadcrumbs".into(),
                surface: SurfaceScope::Any,
                actions: Action::ALL.into_iter().collect(),
                press_force_n: 10.0,
                stiffness_n_per_m: 500.0,
                damping_ratio: 0.7,
                nullspace_posture_weight: 0.1,
                compression_depth_m: 0.005,
                gap_m: 0.0,
                likelihood: LogNormal {
                    mu: -1.05,
                    sigma: 0.25,
                },
                likelihood_spread: LogNormalSpread::NONE,
                redraw: Redraw::default(),
            },
            particles: ParticleDistribution::new(crumbs).unwrap(),
            collect_goal: None,
            treatment: None,
            tool_start: Point2::new(0.0, -0.3),
            seed: 1,
        }
    }

    /// A plan with one stroke towards the edge that ends before it; the goal holds everything that it pushes.
    fn towards_the_edge(end: f64, goal: GoalState) -> Plan {
        let at = [Point2::new(0.0, 0.0), Point2::new(0.0, end)];
        Plan {
            strategy: CoverageStrategy::Kde.into(),
            graph: SemanticDirectedGraph {
                nodes: (at.iter())
                    .map(|&position| Node {
                        position,
                        role: NodeRole::Coverage,
                    })
                    .collect(),
                edges: vec![(0, 1)],
                goal,
                max_edge_length: None,
                unreachable: vec![],
            },
            strokes: vec![Stroke {
                nodes: vec![0, 1],
                poses: at.map(|at| PlanarPose::new(at, -FRAC_PI_2)).to_vec(),
            }],
            collision_radius: Vector2::new(0.07, 0.11).norm() / 2.0,
            unreachable_share: 0.0,
            tool_start: Point2::new(0.0, -0.3),
            lift_height: 0.05,
        }
    }

    #[test]
    fn a_heap_within_the_margin_counts_less_the_nearer_it_is_and_a_single_crumb_in_full() {
        let goal = GoalState::Collected {
            center: Point2::new(0.0, -0.1),
            radius: 0.05,
        };
        let near = towards_the_edge(-0.09, goal);
        let heap = task(&[Point2::new(0.0, -0.06); 50]);
        assert_eq!(objective_at_rest(&heap, &near), 50);
        // The leading edge is 35 mm ahead, and a heap of all crumbs needs 22.8 mm.
        let ends = [-0.08, -0.09, -0.1, -0.104];
        let objectives = ends.map(|end| objective(&heap, &towards_the_edge(end, goal)));
        assert_eq!(objectives, [50, 41, 30, 26]);
        // The tool crosses the edge.
        assert_eq!(objective(&heap, &towards_the_edge(-0.12, goal)), -3 * 50);
        let mut crumbs = vec![Point2::new(0.19, 0.13); 49];
        crumbs.push(Point2::new(0.0, -0.06));
        assert_eq!(objective(&task(&crumbs), &near), 1);
        // A skim is to push the heap over this edge.
        let skimmed = towards_the_edge(-0.1, GoalState::Skimmed);
        assert_eq!(objective(&heap, &skimmed), 0);
        let skimmed = towards_the_edge(-0.12, GoalState::Skimmed);
        assert_eq!(objective(&heap, &skimmed), 50);
    }

    #[test]
    fn a_heap_that_is_brought_just_to_the_rim_of_the_goal_is_partly_beyond_it() {
        let heap = task(&[Point2::origin(); 50]);
        let goal = |y: f64| GoalState::Collected {
            center: Point2::new(0.0, y),
            radius: 0.03,
        };
        let anywhere = towards_the_edge(-0.05, goal(0.0));
        let lies = predict(&heap, &anywhere, |_| ()).particles.position(0).y;
        let [rim, middle] = [lies + 0.029, lies].map(|y| towards_the_edge(-0.05, goal(y)));
        let achieved = |plan| predict(&heap, plan, |_| ()).performance.achieved;
        assert_eq!([achieved(&rim), achieved(&middle)], [50; 2]);
        assert!(objective(&heap, &rim) < objective(&heap, &middle) - 20);
        assert!(has_predicted_gain(&heap, &middle));
        // Where the heap lies in the goal already, the push gains nothing.
        let away = towards_the_edge(-0.05, goal(0.0));
        assert!(!has_predicted_gain(&heap, &away));
    }
}
