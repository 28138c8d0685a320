//! Logs of a perfect wipe over surfaces that are no planes, and over planes: shape, pose, noise and strokes drawn at random.
//!
//! `WISCH_LOGS=4000 cargo test --workspace --test main interpret::relief` reads as many logs.

use super::interpreted_with;
use super::log::{BOARD, DEPTH, PRESS, STEEP, task};
use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};
use std::f64::consts::{PI, TAU};
use wisch::geometry::{Point2, Point3, Pose, Vector3};
use wisch::interpret::{Diagnosis, Doubt, InterpretConfig, Interpretation};
use wisch::represent::SurfaceShape;
use wisch_testkit::{Relief, ReliefWipe};

/// Number of logs unless `WISCH_LOGS` sets it, and the seed of the first.
const COUNT: u64 = 40;
const FIRST_SEED: u64 = 1000;
/// Largest distance of the truth from the interval, and largest lost share of contact, where no
/// doubt is stated [1].
const MOST_MISSED: f64 = 0.1;
const MOST_LOST: f64 = 0.15;
/// Relative error of a radius [1], and error of the axis [rad].
const RADIUS_TOLERANCE: f64 = 0.2;
const AXIS_TOLERANCE: f64 = 0.2;

/// Strokes back and forth in parallel rows over the board.
fn strokes(rows: usize, is_along_x: bool) -> Vec<[Point2; 2]> {
    let [length, width] = if is_along_x {
        BOARD
    } else {
        [BOARD[1], BOARD[0]]
    };
    let (half, apart) = (0.5 * length - 0.04, (width - 0.11) / 2.0);
    (0..rows)
        .map(|row| {
            let across = apart * (row as f64 - 0.5 * (rows as f64 - 1.0));
            let way = if row % 2 == 0 { half } else { -half };
            let at = |along: f64| {
                if is_along_x {
                    Point2::new(along, across)
                } else {
                    Point2::new(across, along)
                }
            };
            [at(-way), at(way)]
        })
        .collect()
}

/// Three strokes of a tool that leans with the surface.
fn wipe(relief: Relief) -> ReliefWipe {
    ReliefWipe {
        relief,
        strokes: strokes(3, true),
        leans: true,
        press: [PRESS, DEPTH],
        friction: 0.0,
        noise: [0.1, 1e-5],
        rate: 250.0,
        believed_from_real: Pose::identity(),
        seed: 1,
    }
}

fn read(wipe: &ReliefWipe) -> Interpretation {
    let task = task(80, STEEP);
    let samples = wipe.samples(&task.surface.world_from_surface);
    interpreted_with(&samples, &task, &InterpretConfig::from_task(&task))
}

/// A wipe drawn at random.
fn draw(random: &mut ChaCha8Rng) -> ReliefWipe {
    let mut between = |low: f64, high: f64| low + (high - low) * random.random::<f64>();
    let sign = if between(0.0, 1.0) < 0.5 { 1.0 } else { -1.0 };
    let curvature = sign / between(0.4_f64.ln(), 20.0_f64.ln()).exp();
    let axis = between(0.0, PI);
    let relief = match between(0.0, 8.0) as usize {
        0 => Relief::Flat,
        1..=3 => Relief::Cylinder { curvature, axis },
        4 => Relief::Sphere { curvature },
        5 => Relief::Saddle { curvature, axis },
        6 => Relief::Crease {
            distance: between(-0.12, 0.12),
            direction: TAU * between(0.0, 1.0),
            fall: sign * between(0.005, 0.15),
        },
        _ => Relief::Cone {
            curvature,
            axis,
            tip: between(0.35, 2.0),
        },
    };
    let about = between(0.0, TAU);
    let lean = between(0.0, 2.0_f64.to_radians());
    ReliefWipe {
        strokes: strokes(1 + between(0.0, 3.0) as usize, between(0.0, 1.0) < 0.5),
        leans: between(0.0, 1.0) < 0.5,
        friction: between(0.0, 0.5),
        noise: [between(0.0, 1.5), between(0.0, 5e-4)],
        rate: between(50.0_f64.ln(), 1000.0_f64.ln()).exp(),
        believed_from_real: Pose::new(
            Vector3::z() * between(-0.01, 0.01),
            Vector3::new(about.cos(), about.sin(), 0.0) * lean,
        ),
        seed: random.random(),
        ..wipe(relief)
    }
}

/// Curvature doubts of a reading.
fn shapes(found: &Interpretation) -> Vec<Doubt> {
    let is_shape = |doubt: &&Doubt| {
        matches!(
            doubt,
            Doubt::Curved { .. }
                | Doubt::CurvedAlong { .. }
                | Doubt::DoublyCurved { .. }
                | Doubt::NotPlanar { .. }
        )
    };
    found.doubts.iter().filter(is_shape).copied().collect()
}

/// Returns the faults of the interpretation of a log, given that of the same wipe over a plane.
fn fault(wipe: &ReliefWipe, found: &Interpretation, flat: &Interpretation) -> Option<String> {
    let (truth, estimate) = (flat.performance.mean, found.performance);
    let missed = (estimate.low - truth).max(truth - estimate.high);
    if found.doubts.is_empty() {
        let lost = flat.contact_share.unwrap() - found.contact_share.unwrap();
        return (missed > MOST_MISSED || lost > MOST_LOST)
            .then(|| format!("missed by {missed:.2}, {lost:.2} of the contact lost"));
    }
    let shapes = shapes(found);
    if shapes.is_empty() {
        return None;
    }
    if estimate.high - estimate.low < 0.5 {
        return Some(format!("sure in spite of its doubts: {estimate:?}"));
    }
    match (wipe.relief, shapes[0]) {
        (
            Relief::Cylinder { curvature, axis },
            Doubt::Curved {
                radius,
                axis: found,
                is_convex,
            },
        ) => {
            let turned = (found - axis + 0.5 * PI).rem_euclid(PI) - 0.5 * PI;
            let is_right = (radius * curvature.abs() - 1.0).abs() < RADIUS_TOLERANCE
                && turned.abs() < AXIS_TOLERANCE
                && is_convex == (curvature > 0.0);
            (!is_right).then(|| "another cylinder".into())
        }
        (Relief::Cylinder { .. }, Doubt::DoublyCurved { .. }) => Some("no cylinder".into()),
        _ => None,
    }
}

#[test]
fn no_curved_surface_is_read_as_a_plane_without_a_word() {
    let count = std::env::var("WISCH_LOGS").map_or(COUNT, |count| count.parse().unwrap());
    let (mut faults, mut named) = (Vec::new(), 0);
    for seed in FIRST_SEED..FIRST_SEED + count {
        let wipe = draw(&mut ChaCha8Rng::seed_from_u64(seed));
        let found = read(&wipe);
        let flat = read(&ReliefWipe {
            relief: Relief::Flat,
            ..wipe.clone()
        });
        named += u64::from(!shapes(&found).is_empty());
        let doubted = format!("a plane is doubted: {:?}", flat.doubts);
        let doubted = (!flat.doubts.is_empty()).then_some(doubted);
        if let Some(fault) = doubted.or_else(|| fault(&wipe, &found, &flat)) {
            faults.push((seed, fault, found.doubts, wipe));
        }
    }
    println!("{count} logs: {named} named, {} faults", faults.len());
    assert!(faults.is_empty(), "{faults:#?}");
    assert!(4 * named > count, "{named}");
}

/// Logs of slow loggers: contacts are 10 to 40 mm apart.
#[test]
fn a_sparse_log_raises_a_doubt_on_a_cylinder_but_not_on_a_plane() {
    for rate in [20.0, 10.0, 5.0] {
        let sparse = |relief| {
            read(&ReliefWipe {
                strokes: strokes(3, true),
                rate,
                ..wipe(relief)
            })
        };
        let bent = sparse(Relief::Cylinder {
            curvature: 1.0,
            axis: 0.0,
        });
        assert!(!bent.doubts.is_empty(), "{rate} Hz");
        assert_eq!(sparse(Relief::Flat).doubts, [], "{rate} Hz");
    }
}

/// Radii from a sagitta of 2 mm on, over strokes of 0.32 m.
#[test]
fn a_cylinder_is_named_with_radius_and_axis() {
    for radius in [
        6.0, 5.0, 4.0, 3.0, 2.5, 2.0, 1.0, 0.5, 0.3, -0.3, -2.5, -6.0,
    ] {
        for leans in [false, true] {
            let wipe = ReliefWipe {
                leans,
                ..wipe(Relief::Cylinder {
                    curvature: 1.0 / radius,
                    axis: 0.5 * PI,
                })
            };
            let found = read(&wipe);
            assert_eq!(fault(&wipe, &found, &found), None, "{radius}");
            let shapes = shapes(&found);
            assert!(
                matches!(shapes[..], [Doubt::Curved { .. }]),
                "{radius}: {:?}",
                found.doubts
            );
            let by_hand = found.events.iter().filter(|event| event.kind.is_by_hand());
            assert_eq!(by_hand.count(), 0, "{radius}");
            assert!(!found.is_conclusive());
        }
    }
    for radius in [20.0, 1e9] {
        let flat = read(&wipe(Relief::Cylinder {
            curvature: 1.0 / radius,
            axis: 0.5 * PI,
        }));
        assert_eq!(flat.doubts, [], "{radius}");
        assert!(flat.is_conclusive());
    }
}

#[test]
fn two_curvatures_an_arc_and_a_crease_are_named() {
    let of = |relief, strokes| {
        let found = read(&ReliefWipe {
            strokes,
            ..wipe(relief)
        });
        let [shape] = shapes(&found)[..] else {
            panic!("{relief:?}: {:?}", found.doubts);
        };
        shape
    };
    let three = || strokes(3, true);
    let is_near = |found: f64, radius: f64| (found / radius - 1.0).abs() < RADIUS_TOLERANCE;
    let sphere = of(Relief::Sphere { curvature: -1.0 }, three());
    let Doubt::DoublyCurved { radii, .. } = sphere else {
        panic!("{sphere:?}");
    };
    assert!(
        radii.iter().all(|radius| is_near(*radius, -1.0)),
        "{radii:?}"
    );
    let saddle = Relief::Saddle {
        curvature: 1.0,
        axis: 0.7,
    };
    let Doubt::DoublyCurved { radii, .. } = of(saddle, three()) else {
        panic!();
    };
    let [convex, hollow] = [radii[0].max(radii[1]), radii[0].min(radii[1])];
    assert!(is_near(convex, 1.0) && is_near(hollow, -1.0), "{radii:?}");
    // One stroke shows the curvature along itself: 1/R cos² of the angle from the section.
    let Doubt::CurvedAlong {
        radius,
        direction,
        is_convex,
    } = of(
        Relief::Cylinder {
            curvature: 1.0,
            axis: 1.0,
        },
        strokes(1, true),
    )
    else {
        panic!();
    };
    assert!(
        is_near(radius, 1.0 / 1.0_f64.sin().powi(2)) && is_convex,
        "{radius}"
    );
    assert!(
        direction.min(PI - direction) < AXIS_TOLERANCE,
        "{direction}"
    );
    let crease = Relief::Crease {
        distance: 0.05,
        direction: 0.0,
        fall: 0.1,
    };
    let crease = of(crease, three());
    assert!(
        matches!(crease, Doubt::NotPlanar { off } if off > 2e-3),
        "{crease:?}"
    );
}

/// A plane through a part of the contacts says nothing about the pose of a bent surface: the surface is shifted to their
/// median height, and not tilted.
#[test]
fn contacts_on_no_plane_do_not_tilt_the_surface() {
    let board = task(80, STEEP).surface;
    let mut shifted = 0;
    for curvature in [-0.8, -0.5, -0.25, 0.25, 0.5, 0.8] {
        for leans in [false, true] {
            let relief = Relief::Cylinder {
                curvature,
                axis: 0.5 * PI,
            };
            let wipe = ReliefWipe {
                leans,
                ..wipe(relief)
            };
            let found = read(&wipe);
            let shift = found.doubts.iter().find_map(|doubt| match doubt {
                Doubt::HeightOnly { height } => Some(*height),
                _ => None,
            });
            let is_scattered = (found.doubts.iter()).any(|d| matches!(d, Doubt::Scattered { .. }));
            assert_eq!(shift.is_some(), is_scattered, "{:?}", found.doubts);
            let Some(shift) = shift else {
                continue;
            };
            shifted += 1;
            let pose = match found.diagnosis {
                Diagnosis::Relocalize { world_from_surface } => world_from_surface,
                _ => board.world_from_surface,
            };
            let moved = board.world_from_surface.inverse() * pose;
            assert!(moved.rotation.angle() < 1e-9, "{moved:?}");
            // The height lies between the lowest and the highest place that the tool touched.
            let ends = [0.0, 0.16].map(|x| relief.height(Point2::new(x, 0.0)));
            let [low, high] = [ends[0].min(ends[1]), ends[0].max(ends[1])];
            assert!(
                (low..=high).contains(&shift),
                "{curvature}: {shift} {ends:?}"
            );
            assert!(moved.translation.vector.z == 0.0 || moved.translation.vector.z == shift);
        }
    }
    assert!(shifted >= 4, "{shifted}");
}

/// Reads a log over a surface that is believed to be rolled onto a cylinder with its axis along y.
fn read_rolled(wipe: &ReliefWipe, radius: f64) -> Interpretation {
    let mut task = task(80, STEEP);
    task.surface.shape = SurfaceShape::Cylinder {
        radius,
        axis: 0.5 * PI,
    };
    let samples = wipe.samples(&task.surface.world_from_surface);
    interpreted_with(&samples, &task, &InterpretConfig::from_task(&task))
}

#[test]
fn on_a_known_cylinder_contact_is_read_as_on_a_plane() {
    let flat = read(&wipe(Relief::Flat));
    let by_hand = |found: &Interpretation| {
        (found.events.iter())
            .filter(|event| event.kind.is_by_hand())
            .count()
    };
    for radius in [20.0, 8.0, 6.0, 4.0, 2.5, 2.0, 1.0, 0.5, -0.5, -2.5] {
        for leans in [false, true] {
            let wipe = ReliefWipe {
                leans,
                friction: 0.3,
                ..wipe(Relief::Cylinder {
                    curvature: 1.0 / radius,
                    axis: 0.5 * PI,
                })
            };
            let found = read_rolled(&wipe, radius);
            assert_eq!(found.doubts, [], "{radius} {leans}");
            assert_eq!(found.diagnosis, Diagnosis::Localized, "{radius} {leans}");
            assert_eq!(by_hand(&found), 0, "{radius} {leans}");
            let off = found.contact_share.unwrap() - flat.contact_share.unwrap();
            assert!(off.abs() < 0.01, "{radius} {leans}: {off}");
        }
    }
}

/// A rigid motion of the cylinder is found; where touch does not determine it, the smallest one.
#[test]
fn a_known_cylinder_elsewhere_is_found_along_its_normals() {
    let shape = SurfaceShape::Cylinder {
        radius: 1.0,
        axis: 0.5 * PI,
    };
    let moved = Pose::new(
        Vector3::new(0.0, 0.0, 0.0035),
        Vector3::new(0.9, 0.7, 0.0) * 1.2_f64.to_radians(),
    );
    let found = read_rolled(
        &ReliefWipe {
            believed_from_real: moved,
            ..wipe(Relief::Cylinder {
                curvature: 1.0,
                axis: 0.5 * PI,
            })
        },
        1.0,
    );
    let Diagnosis::Relocalize { world_from_surface } = found.diagnosis else {
        panic!("{:?}", found.diagnosis);
    };
    let believed = task(80, STEEP).surface.world_from_surface;
    let mut squares = Vec::new();
    for [x, y] in [
        [-0.15, -0.08],
        [-0.15, 0.08],
        [0.0, 0.0],
        [0.15, -0.08],
        [0.15, 0.08],
    ] {
        // Height of the real surface over the surface as found.
        let real = believed * moved * shape.place(Point2::new(x, y), 0.0);
        let at = shape.chart(
            (world_from_surface.inverse() * real)
                .translation
                .vector
                .into(),
        );
        squares.push(at.height * at.height);
    }
    let off = (squares.iter().sum::<f64>() / squares.len() as f64).sqrt();
    assert!(off < 3e-4, "{off}");
}

/// Yaw bends the chart of a cylinder, so that the contacts lie on no plane in it.
#[test]
fn a_known_cylinder_that_is_yawed_is_found_without_a_doubt() {
    let rolled = wipe(Relief::Cylinder {
        curvature: 2.0,
        axis: 0.5 * PI,
    });
    let straight = read_rolled(&rolled, 0.5);
    for degrees in [2.0, -3.0] {
        let turn = Vector3::z() * f64::to_radians(degrees);
        let yawed = ReliefWipe {
            believed_from_real: Pose::new(Vector3::zeros(), turn),
            ..rolled.clone()
        };
        let found = read_rolled(&yawed, 0.5);
        assert_eq!(found.doubts, [], "{degrees}°");
        let turned = found.registration.unwrap().believed_from_real.rotation;
        assert!(
            (turned.angle() - turn.norm()).abs() < 0.1_f64.to_radians(),
            "{degrees}°: {turned:?}"
        );
        assert!(
            matches!(found.diagnosis, Diagnosis::Relocalize { .. }),
            "{degrees}°: {:?}",
            found.diagnosis
        );
        let off = found.contact_share.unwrap() - straight.contact_share.unwrap();
        assert!(off.abs() < 0.02, "{degrees}°: {off}");
        let off = found.performance.mean - straight.performance.mean;
        assert!(off.abs() < 0.02, "{degrees}°: {off}");
    }
}

/// On a narrow cylinder that lies deeper or higher, the same poses are above other places of the believed surface.
#[test]
fn places_along_a_cylinder_elsewhere_are_those_of_its_fitted_pose() {
    let rolled = wipe(Relief::Cylinder {
        curvature: 5.0,
        axis: 0.5 * PI,
    });
    let extent = |found: &Interpretation| {
        let touched = found.path.iter().filter(|piece| piece.is_on_plane());
        let places = touched.map(|piece| piece.position.x);
        places.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| {
            [low.min(x), high.max(x)]
        })
    };
    let straight = read_rolled(&rolled, 0.2);
    let [low, high] = extent(&straight);
    for (height, degrees) in [(-0.015, 0.0), (0.012, 0.0), (0.0, 6.0), (-0.01, -5.0)] {
        let turn = Vector3::z() * f64::to_radians(degrees);
        let moved = Pose::new(Vector3::z() * height, turn);
        let found = read_rolled(
            &ReliefWipe {
                believed_from_real: moved,
                ..rolled.clone()
            },
            0.2,
        );
        let what = format!("{height} m, {degrees}°");
        assert_eq!(found.doubts, [], "{what}");
        assert!(found.is_conclusive(), "{what}");
        let ends = extent(&found);
        for (end, expected) in ends.into_iter().zip([low, high]) {
            assert!(
                (end - expected).abs() < 2e-3,
                "{what}: {ends:?} {low} {high}"
            );
        }
        let off = found.performance.mean - straight.performance.mean;
        assert!(off.abs() < 0.02, "{what}: {off}");
        let plane = found.plane.unwrap();
        // This wipe lacks the millimetre by which a tool sinks in over the bend.
        assert!((plane.offset - height).abs() < 1.5e-3, "{what}: {plane:?}");
        assert_eq!(plane.inliers, plane.confident, "{what}");
        let Diagnosis::Relocalize { world_from_surface } = found.diagnosis else {
            panic!("{what}: {:?}", found.diagnosis);
        };
        let believed = task(80, STEEP).surface.world_from_surface;
        let error = (believed * moved).inverse() * world_from_surface;
        assert!(error.translation.vector.norm() < 2e-3, "{what}: {error:?}");
        assert!(
            error.rotation.angle() < 0.2_f64.to_radians(),
            "{what}: {error:?}"
        );
    }
}

/// A narrow cylinder is found far beside its believed place; a shape that fits nowhere does not move the surface.
#[test]
fn a_cylinder_is_found_beside_its_place_and_another_shape_is_not() {
    let beside = |relief, shift: f64| {
        let moved = ReliefWipe {
            believed_from_real: Pose::translation(shift, 0.0, 0.0),
            ..wipe(relief)
        };
        read_rolled(&moved, 0.2)
    };
    let pipe = Relief::Cylinder {
        curvature: 5.0,
        axis: 0.5 * PI,
    };
    for shift in [0.04, -0.04] {
        let found = beside(pipe, shift);
        assert_eq!(found.doubts, [], "{shift}");
        let Diagnosis::Relocalize { world_from_surface } = found.diagnosis else {
            panic!("{shift}: {:?}", found.diagnosis);
        };
        // The axis counts, as the cylinder may also turn about it.
        let believed = task(80, STEEP).surface.world_from_surface;
        let axis = believed.inverse() * world_from_surface * Point3::new(0.0, 0.0, -0.2);
        let off = axis.xz() - Point2::new(shift, -0.2);
        assert!(off.norm() < 2e-3, "{shift}: {axis:?}");
    }
    let saddle = Relief::Saddle {
        curvature: 5.0,
        axis: 0.5 * PI,
    };
    let found = beside(saddle, 0.0);
    assert!(
        (found.doubts.iter()).any(|doubt| matches!(doubt, Doubt::OffShape { .. })),
        "{:?}",
        found.doubts
    );
    assert_eq!(found.diagnosis, Diagnosis::Unfitted);
    assert!(found.plane.is_none() && found.registration.is_none());
    assert!(!found.is_conclusive());
}

/// A mesh whose faces point inwards, or a board that is upside down: one doubt, and nothing that follows from it.
#[test]
fn a_log_of_the_other_side_is_named_and_not_read() {
    let over = Pose::new(Vector3::zeros(), Vector3::x() * PI);
    for (curvature, height) in [(0.0, 0.0), (0.0, -0.01), (1.0, 0.0), (-1.0, 0.005)] {
        let relief = Relief::Cylinder {
            curvature,
            axis: 0.5 * PI,
        };
        let turned = ReliefWipe {
            believed_from_real: Pose::translation(0.0, 0.0, height) * over,
            friction: 0.3,
            ..wipe(relief)
        };
        let found = if curvature == 0.0 {
            read(&turned)
        } else {
            // Seen from the other side, a bulge is a hollow.
            read_rolled(&turned, -1.0 / curvature)
        };
        let what = format!("{curvature} {height}");
        assert_eq!(found.doubts, [Doubt::OtherSide], "{what}");
        assert_eq!(found.diagnosis, Diagnosis::Unfitted, "{what}");
        assert!(
            found.events.iter().all(|event| event.kind.is_phase()),
            "{what}"
        );
        assert_eq!(
            (found.force_bias, found.contact_share),
            (None, None),
            "{what}"
        );
        assert!(!found.is_conclusive(), "{what}");
        let text = found.doubts[0].to_string();
        assert!(text.contains("surface.mesh.towards"), "{text}");
    }
}

#[test]
fn a_wrong_believed_radius_raises_a_doubt() {
    for (believed, real) in [(1.0, 0.5), (1.0, 2.0), (-1.0, 1.0), (0.5, 1e9)] {
        let found = read_rolled(
            &wipe(Relief::Cylinder {
                curvature: 1.0 / real,
                axis: 0.5 * PI,
            }),
            believed,
        );
        let is_off = |doubt: &Doubt| matches!(doubt, Doubt::OffShape { off } if *off > 1e-3);
        assert!(
            found.doubts.iter().any(is_off),
            "{believed} {real}: {:?}",
            found.doubts
        );
        assert!(!found.is_conclusive());
    }
}

/// A person lifts the tool while the controller keeps its force: that is a push and no surface.
#[test]
fn a_tool_that_is_lifted_at_the_same_force_shows_no_other_surface() {
    let contacts = super::log::Script::default().contacts();
    let [start, end] = contacts[1];
    let found = super::interpreted(&super::log::Script {
        hands: vec![super::log::Hand {
            start: start + 0.3,
            end: end - 0.3,
            off: Vector3::z() * 0.08,
            force: Vector3::z() * PRESS,
        }],
        ..super::log::Script::default()
    });
    assert_eq!(shapes(&found), [], "{:?}", found.doubts);
}

/// A tool that goes back and forth has friction on the way there and on the way back.
#[test]
fn a_raised_area_that_is_scrubbed_is_no_tool_in_a_hand() {
    let place = |k: u32| {
        let aside = if k.is_multiple_of(2) { 0.0 } else { 0.005 };
        Point2::new(0.04 + 0.0015 * f64::from(k), aside)
    };
    let line = |y: f64| [Point2::new(-0.16, y), Point2::new(-0.02, y)];
    let scrubs = (0..60).map(|k| [place(k), place(k + 1)]);
    let found = super::interpreted(&super::log::Script {
        strokes: [line(-0.085), line(0.0), line(0.085)]
            .into_iter()
            .chain(scrubs)
            .collect(),
        surface: |place| if place.x > 0.02 { 0.006 } else { 0.0 },
        ..super::log::Script::default()
    });
    assert!(
        !found.is_conclusive(),
        "{:?} {:?}",
        found.doubts,
        found.performance
    );
}
