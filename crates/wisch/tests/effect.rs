//! The effect model against closed forms, and the laws that hold for any stroke.

use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI};
use wisch::geometry::{PlanarPose, Point2, Polygon, Region, Vector2};
use wisch::represent::{
    Effect, EffectModel, Fate, MotionEffect, ParticleDistribution, ParticleField, Surface,
    ToolMotion,
};
use wisch_testkit::surface;

/// Largest distance between two computations of the same motion [m].
const SAME: f64 = 1e-4;

fn sponge() -> Region {
    Region::new(vec![Polygon::rectangle(Vector2::new(0.07, 0.11))])
}

/// Two tufts side by side and a ring: separate pieces and a hole.
fn brush() -> Region {
    let moved = |size: f64, x: f64, y: f64| -> Vec<Point2> {
        Polygon::rectangle(Vector2::new(size, size))
            .outer()
            .iter()
            .map(|p| p + Vector2::new(x, y))
            .collect()
    };
    Region::new(vec![
        Polygon::new(moved(0.02, 0.0, 0.04), vec![]),
        Polygon::new(moved(0.02, 0.01, -0.04), vec![]),
        Polygon::new(moved(0.04, -0.01, 0.0), vec![moved(0.02, -0.01, 0.0)]),
    ])
}

fn board(half: f64) -> Surface {
    surface([2.0 * half; 2])
}

fn pose(x: f64, y: f64, heading: f64) -> PlanarPose {
    PlanarPose::new(Point2::new(x, y), heading)
}

fn wiped(
    footprint: &Region,
    interaction: Effect,
    points: &[Point2],
    motions: &[ToolMotion],
) -> ParticleDistribution {
    let surface = board(1.0);
    let mut field = ParticleField::new(&ParticleDistribution::new(points).unwrap());
    let mut model = EffectModel::new(footprint, interaction);
    for motion in motions {
        model.apply(&mut field, &surface, motion);
    }
    field.distribution()
}

/// The same motion in `pieces` equal parts.
fn split(motion: ToolMotion, pieces: usize) -> Vec<ToolMotion> {
    let at = |i: usize| {
        let t = i as f64 / pieces as f64;
        PlanarPose::new(
            motion.from.position + (motion.to.position - motion.from.position) * t,
            motion.from.heading + (motion.to.heading - motion.from.heading) * t,
        )
    };
    (0..pieces)
        .map(|i| ToolMotion {
            from: at(i),
            to: at(i + 1),
        })
        .collect()
}

#[test]
fn a_push_carries_what_it_meets_to_its_leading_edge() {
    let points = [
        Point2::new(0.1, 0.0),    // ahead: met
        Point2::new(0.0, 0.02),   // under the sponge when it comes down: carried
        Point2::new(-0.04, 0.0),  // behind: stays
        Point2::new(0.1, 0.056),  // beside: stays
        Point2::new(0.336, 0.0),  // ahead, out of reach: stays
        Point2::new(0.334, 0.05), // ahead, just in reach
    ];
    let motion = ToolMotion {
        from: pose(0.0, 0.0, 0.0),
        to: pose(0.3, 0.0, 0.0),
    };
    let after = wiped(&sponge(), Effect::Push, &points, &[motion]);
    for (i, x) in [0.335, 0.335, -0.04, 0.1, 0.336, 0.335]
        .into_iter()
        .enumerate()
    {
        assert!((after.position(i).x - x).abs() < 1e-8, "particle {i}");
        assert_eq!(after.position(i).y, points[i].y);
    }
}

#[test]
fn a_particle_in_a_hole_rides_on_the_edge_behind_it() {
    // The ring spans x −0.03..0.01 with a hole at −0.02..0.00.
    let points = [Point2::new(-0.01, 0.0)];
    let motion = ToolMotion {
        from: pose(0.0, 0.0, 0.0),
        to: pose(0.1, 0.0, 0.0),
    };
    let after = wiped(&brush(), Effect::Push, &points, &[motion]);
    assert!((after.position(0).x - 0.08).abs() < 1e-8);
}

#[test]
fn what_is_left_behind_stays_when_the_tool_turns_back() {
    let points = [Point2::new(0.1, 0.0)];
    let there = ToolMotion {
        from: pose(0.0, 0.0, 0.0),
        to: pose(0.2, 0.0, 0.0),
    };
    let back = ToolMotion {
        from: there.to,
        to: there.from,
    };
    let after = wiped(&sponge(), Effect::Push, &points, &[there, back]);
    assert!((after.position(0).x - 0.235).abs() < 1e-8);
}

#[test]
fn a_blade_turning_on_the_spot_carries_particles_round() {
    let blade = Region::new(vec![Polygon::rectangle(Vector2::new(0.002, 0.2))]);
    let radius = 0.08;
    let points = [Point2::new(radius * 0.3f64.cos(), radius * 0.3f64.sin())];
    // The blade stands along y; its right half (toward −y) sweeps towards +x.
    let motion = ToolMotion {
        from: pose(0.0, 0.0, 0.0),
        to: pose(0.0, 0.0, FRAC_PI_2 + 1.0),
    };
    let after = wiped(&blade, Effect::Push, &points, &[motion]);
    // It rides on the blade's face at its radius; the blade's arm then points to 1 rad.
    let at = after.position(0);
    assert!((at.coords.norm() - radius).abs() < 1e-8);
    let face_ahead = (0.001 / radius).asin();
    assert!((at.y.atan2(at.x) - (1.0 + face_ahead)).abs() < 1e-6);
}

#[test]
fn absorbing_deletes_what_lies_under_the_swept_area() {
    let points: Vec<Point2> = (0..40)
        .flat_map(|i| {
            (0..40).map(move |j| Point2::new(i as f64 * 0.01 - 0.2, j as f64 * 0.01 - 0.2))
        })
        .collect();
    let motion = ToolMotion {
        from: pose(-0.051, 0.0, 0.0),
        to: pose(0.103, 0.0, 0.0),
    };
    let after = wiped(&sponge(), Effect::Absorb, &points, &[motion]);
    for (i, p) in points.iter().enumerate() {
        let under = p.x > -0.086 && p.x < 0.138 && p.y.abs() < 0.055;
        assert_eq!(after.fate(i) == Fate::Absorbed, under, "{p}");
    }
}

#[test]
fn particles_leave_over_the_edge_that_their_way_crosses() {
    let surface = board(0.2);
    let points = [Point2::new(0.0, 0.0)];
    let mut field = ParticleField::new(&ParticleDistribution::new(&points).unwrap());
    let down = ToolMotion {
        from: pose(0.0, 0.05, -FRAC_PI_2),
        to: pose(0.0, -0.2, -FRAC_PI_2),
    };
    let effect = EffectModel::new(&sponge(), Effect::Push).apply(&mut field, &surface, &down);
    assert_eq!(effect.off_surface, 1);
    assert_eq!(field.distribution().fate(0), Fate::OffSurface { edge: 0 });
}

#[test]
fn the_effect_does_not_depend_on_the_order_of_the_particles() {
    let points: Vec<Point2> = (0..300)
        .map(|i| {
            let a = i as f64 * 2.399_963;
            Point2::new(a.cos(), a.sin()) * (0.3 * (i as f64 / 300.0).sqrt())
        })
        .collect();
    let motions = [
        ToolMotion {
            from: pose(-0.2, 0.0, 0.0),
            to: pose(0.1, 0.05, 0.8),
        },
        ToolMotion {
            from: pose(0.1, 0.05, 0.8),
            to: pose(0.0, 0.2, 2.0),
        },
    ];
    let forward = wiped(&brush(), Effect::Push, &points, &motions);
    let reversed: Vec<Point2> = points.iter().rev().copied().collect();
    let backward = wiped(&brush(), Effect::Push, &reversed, &motions);
    let back_again: Vec<_> = backward.iter().collect();
    for (one, other) in forward.iter().zip(back_again.into_iter().rev()) {
        assert_eq!(one, other);
    }
}

/// Blocks of neighbours are tested or skipped as a whole, stroke after stroke.
#[test]
fn what_becomes_of_a_particle_does_not_depend_on_the_others() {
    let points: Vec<Point2> = (0..400)
        .map(|i| {
            let a = f64::from(i) * 2.399_963;
            Point2::new(a.cos(), a.sin()) * (0.24 * (f64::from(i) / 400.0).sqrt())
        })
        .collect();
    let poses: Vec<_> = (0..24)
        .map(|i| {
            let a = f64::from(i) * 2.1;
            let heading = if i % 4 < 2 { 0.3 } else { a };
            pose(0.22 * a.cos(), 0.22 * (1.7 * a).sin(), heading)
        })
        .collect();
    let surface = board(0.25);
    let played = |points: &[Point2], tool: &Region, kind| {
        let mut field = ParticleField::new(&ParticleDistribution::new(points).unwrap());
        let mut model = EffectModel::new(tool, kind);
        for pair in poses.windows(2) {
            let motion = ToolMotion {
                from: pair[0],
                to: pair[1],
            };
            model.apply(&mut field, &surface, &motion);
        }
        (field.distribution(), field.remaining())
    };
    for tool in [sponge(), brush()] {
        for kind in [Effect::Push, Effect::Absorb, Effect::Treat] {
            let (together, remaining) = played(&points, &tool, kind);
            assert_eq!(remaining, together.tally().remaining);
            for (i, &point) in points.iter().enumerate() {
                let (alone, _) = played(&[point], &tool, kind);
                let after = |all: &ParticleDistribution, i| (all.position(i), all.fate(i));
                assert_eq!(after(&together, i), after(&alone, 0), "{kind:?} {i}");
            }
        }
    }
}

#[test]
fn the_number_of_threads_changes_nothing() {
    let points: Vec<Point2> = (0..20_000)
        .map(|i| {
            let a = f64::from(i) * 2.399_963;
            Point2::new(a.cos(), a.sin()) * (0.3 * (f64::from(i) / 20_000.0).sqrt())
        })
        .collect();
    let motions = [ToolMotion {
        from: pose(-0.2, 0.0, 0.0),
        to: pose(0.2, 0.05, 1.5),
    }];
    let on = |threads: usize| {
        rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap()
            .install(|| wiped(&sponge(), Effect::Push, &points, &motions))
    };
    let one = on(1);
    assert_ne!(one.position(0), points[0]);
    assert_eq!(one, on(3));
}

#[test]
fn particles_that_do_not_respond_stay_and_the_others_do_what_they_did() {
    let points: Vec<Point2> = (0..5_000)
        .map(|i| {
            let a = f64::from(i) * 2.399_963;
            Point2::new(a.cos(), a.sin()) * (0.3 * (f64::from(i) / 5_000.0).sqrt())
        })
        .collect();
    let surface = board(1.0);
    for turn in [0.0, 1.5] {
        let motion = ToolMotion {
            from: pose(-0.2, 0.0, 0.0),
            to: pose(0.2, 0.05, turn),
        };
        for kind in [Effect::Push, Effect::Absorb] {
            let all = wiped(&sponge(), kind, &points, &[motion]);
            let mut asked = vec![0; points.len()];
            let mut field = ParticleField::new(&ParticleDistribution::new(&points).unwrap());
            EffectModel::new(&sponge(), kind).apply_where(&mut field, &surface, &motion, |i, _| {
                asked[i] += 1;
                i % 3 == 0
            });
            let some = field.distribution();
            for (i, point) in points.iter().enumerate() {
                let touched = (all.position(i), all.fate(i)) != (*point, Fate::OnSurface);
                assert_eq!(asked[i], usize::from(touched), "particle {i}");
                if i % 3 == 0 {
                    assert_eq!(
                        (some.position(i), some.fate(i)),
                        (all.position(i), all.fate(i))
                    );
                } else {
                    assert_eq!((some.position(i), some.fate(i)), (*point, Fate::OnSurface));
                }
            }
        }
    }
}

/// Returns the effect on a heap of this depth that is pushed along x to 1 cm before the edge at x =
/// 0.2.
fn heap_pushed_near_the_edge(depth: f64) -> (MotionEffect, ParticleDistribution) {
    let crumbs = ParticleDistribution::new(&[Point2::new(0.1, 0.0); 400]).unwrap();
    let mut field = ParticleField::new(&crumbs);
    let mut model = EffectModel::new(&sponge(), Effect::Push).with_heap(depth, 1);
    let motion = ToolMotion {
        from: pose(0.0, 0.0, 0.0),
        to: pose(0.155, 0.0, 0.0),
    };
    let effect = model.apply(&mut field, &board(0.2), &motion);
    model.lift_off(&mut field, &board(0.2));
    (effect, field.distribution())
}

#[test]
fn what_has_no_room_before_the_edge_falls_and_the_rest_lies_apart() {
    // The heap needs twice the space before the edge: half of it falls.
    let (effect, deep) = heap_pushed_near_the_edge(0.02);
    let count = |fate| deep.iter().filter(|(_, one)| *one == fate).count();
    assert!((150..250).contains(&effect.off_surface), "{effect:?}");
    assert_eq!(count(Fate::OffSurface { edge: 1 }), effect.off_surface);
    assert_eq!(count(Fate::OnSurface), effect.pushed);
    let left: Vec<Point2> = deep.remaining().collect();
    assert!(left.iter().all(|place| (0.19..0.2).contains(&place.x)));
    assert!(left.iter().any(|place| place.y < -0.008));
    assert!(left.iter().any(|place| place.y > 0.008));
    let (effect, _) = heap_pushed_near_the_edge(0.009);
    assert_eq!([effect.pushed, effect.off_surface], [400, 0]);
    // With a depth of 0, the particles lie on a line.
    let (_, flat) = heap_pushed_near_the_edge(0.0);
    let line = flat.remaining().next().unwrap();
    assert!((line.x - 0.19).abs() < SAME && line.y == 0.0, "{line}");
    assert!(flat.remaining().all(|place| place == line));
}

#[test]
fn a_heap_that_is_taken_up_needs_no_room() {
    let crumbs = ParticleDistribution::new(&[Point2::new(0.19, 0.0); 50]).unwrap();
    let mut field = ParticleField::new(&crumbs);
    let mut model = EffectModel::new(&sponge(), Effect::Absorb).with_heap(0.1, 1);
    let motion = ToolMotion {
        from: pose(0.0, 0.0, 0.0),
        to: pose(0.16, 0.0, 0.0),
    };
    let effect = model.apply(&mut field, &board(0.2), &motion);
    model.lift_off(&mut field, &board(0.2));
    assert_eq!([effect.absorbed, effect.off_surface], [50, 0]);
}

fn any_motion() -> impl Strategy<Value = ToolMotion> {
    (
        -0.2..0.2f64,
        -0.2..0.2f64,
        -PI..PI,
        -0.3..0.3f64,
        -0.3..0.3f64,
        prop_oneof![Just(0.0), -3.0..3.0f64],
    )
        .prop_map(|(x, y, heading, dx, dy, turn)| ToolMotion {
            from: pose(x, y, heading),
            to: pose(x + dx, y + dy, heading + turn),
        })
}

fn any_points() -> impl Strategy<Value = Vec<Point2>> {
    prop::collection::vec(
        (-0.5..0.5f64, -0.5..0.5f64).prop_map(|(x, y)| Point2::new(x, y)),
        0..150,
    )
}

fn any_tool() -> impl Strategy<Value = Region> {
    prop_oneof![Just(sponge()), Just(brush())]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn particles_are_conserved(points in any_points(), motions in prop::collection::vec(any_motion(), 1..6), tool in any_tool(), absorb: bool) {
        let interaction = if absorb { Effect::Absorb } else { Effect::Push };
        let surface = board(0.25);
        let points: Vec<Point2> = points.into_iter().map(|p| p * 0.5).collect();
        let mut field = ParticleField::new(&ParticleDistribution::new(&points).unwrap());
        let mut model = EffectModel::new(&tool, interaction);
        for motion in &motions {
            model.apply(&mut field, &surface, motion);
            let after = field.distribution();
            let tally = after.tally();
            prop_assert_eq!(tally.initial, points.len());
            prop_assert_eq!(tally.initial, tally.remaining + tally.absorbed + tally.off_surface);
            prop_assert_eq!(tally.remaining, field.remaining());
            for (p, fate) in after.iter() {
                let inside = p.x.abs() <= 0.25 && p.y.abs() <= 0.25;
                prop_assert!(inside || fate != Fate::OnSurface, "{p} {fate:?}");
            }
        }
    }

    /// Dividing a motion changes nothing: there is no step size.
    #[test]
    fn splitting_a_motion_changes_nothing(points in any_points(), motion in any_motion(), tool in any_tool()) {
        let whole = wiped(&tool, Effect::Push, &points, &[motion]);
        for pieces in [2, 4, 32] {
            let parts = wiped(&tool, Effect::Push, &points, &split(motion, pieces));
            for (i, point) in points.iter().enumerate() {
                let apart = (whole.position(i) - parts.position(i)).norm();
                prop_assert!(apart < SAME, "particle {i} {point}: {} vs {} in {pieces} pieces", whole.position(i), parts.position(i));
            }
        }
    }

    #[test]
    fn nothing_pushed_stays_under_the_tool(points in any_points(), motion in any_motion(), tool in any_tool()) {
        prop_assume!((motion.to.position - motion.from.position).norm() > 1e-3);
        let after = wiped(&tool, Effect::Push, &points, &[motion]);
        for (p, _) in after.iter() {
            let in_tool = motion.to.inverse_transform(p);
            prop_assert!(!tool.contains(in_tool) || tool.boundary_distance(in_tool) < 1e-9, "{p}");
        }
    }

    /// A rotation below the resolution is a translation.
    #[test]
    fn the_two_computations_agree_where_they_meet(points in any_points(), motion in any_motion()) {
        prop_assume!((motion.to.position - motion.from.position).norm() > 1e-3);
        let straight = ToolMotion { to: PlanarPose { heading: motion.from.heading, ..motion.to }, ..motion };
        let slight = ToolMotion { to: PlanarPose { heading: motion.from.heading + 1e-7, ..motion.to }, ..motion };
        let a = wiped(&sponge(), Effect::Push, &points, &[straight]);
        let b = wiped(&sponge(), Effect::Push, &points, &[slight]);
        for i in 0..points.len() {
            prop_assert!((a.position(i) - b.position(i)).norm() < SAME, "{} vs {}", a.position(i), b.position(i));
        }
    }

    #[test]
    fn the_effect_moves_with_the_frame(points in any_points(), motion in any_motion(), shift in (-0.1..0.1f64, -0.1..0.1f64), angle in -PI..PI) {
        let frame = pose(shift.0, shift.1, angle);
        let moved = |p: PlanarPose| PlanarPose::new(frame.transform(p.position), p.heading + angle);
        let there: Vec<Point2> = points.iter().map(|p| frame.transform(*p)).collect();
        let a = wiped(&brush(), Effect::Push, &points, &[motion]);
        let b = wiped(&brush(), Effect::Push, &there, &[ToolMotion { from: moved(motion.from), to: moved(motion.to) }]);
        for i in 0..points.len() {
            // In no orientation does anything reach the edge of this surface.
            prop_assert_eq!((a.fate(i), b.fate(i)), (Fate::OnSurface, Fate::OnSurface));
            prop_assert!((frame.transform(a.position(i)) - b.position(i)).norm() < SAME);
        }
    }
}

/// A case in which the particle at the boundary is neither carried nor left: it slides along the
/// edge.
#[test]
fn a_particle_that_is_neither_carried_nor_left_slides_along_the_edge() {
    let points = [Point2::new(0.019_076_565, 0.024_441_248)];
    let motion = ToolMotion {
        from: pose(0.016_534_406, 0.0, -1.536_070_255),
        to: pose(0.016_534_406, 0.037_855_510, -3.843_999_206),
    };
    let whole = wiped(&sponge(), Effect::Push, &points, &[motion]);
    for pieces in [2, 8, 32, 500] {
        let parts = wiped(&sponge(), Effect::Push, &points, &split(motion, pieces));
        assert!((whole.position(0) - parts.position(0)).norm() < 1e-6);
    }
    let in_tool = motion.to.inverse_transform(whole.position(0));
    assert!(!sponge().contains(in_tool));
}
