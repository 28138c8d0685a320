use super::*;
use crate::geometry::Polygon;
use std::f64::consts::{FRAC_PI_2, PI};

/// Sides of the pad, along x and y [m].
const PAD: [f64; 2] = [0.06, 0.1];

fn pad() -> Region {
    Region::new(vec![Polygon::rectangle(Vector2::new(PAD[0], PAD[1]))])
}

fn bend(along: f64, across: f64) -> Matrix2<f64> {
    Matrix2::from_diagonal(&Vector2::new(along, across))
}

/// Share that touches, least and largest f′.
fn contact(footprint: &Region, compression: f64, bend: Matrix2<f64>) -> [f64; 3] {
    let tool = ElasticFoundation::new(footprint, compression).unwrap();
    let pressure = tool.press(1.0, Vector2::zeros(), &bend);
    let [least, most] = tool.range(&pressure);
    [tool.touched_share(&pressure), least.max(0.0), most]
}

/// Share that touches, f′ in the middle, and largest f′ of 400 × 400 springs, by bisection of the depth.
fn contact_of_springs(
    is_under: impl Fn(f64, f64) -> bool,
    force: f64,
    depth: impl Fn(f64, f64) -> f64,
) -> [f64; 3] {
    const SPRINGS: usize = 400;
    let place = |i: usize, side: f64| ((i as f64 + 0.5) / SPRINGS as f64 - 0.5) * side;
    let springs: Vec<f64> = (0..SPRINGS * SPRINGS)
        .map(|i| [place(i / SPRINGS, PAD[0]), place(i % SPRINGS, PAD[1])])
        .filter(|&[x, y]| is_under(x, y))
        .map(|[x, y]| depth(x, y))
        .collect();
    let mean = |middle: f64| {
        springs.iter().map(|h| (middle + h).max(0.0)).sum::<f64>() / springs.len() as f64
    };
    let (mut low, mut high) = (-100.0, 100.0);
    for _ in 0..80 {
        let between = 0.5 * (low + high);
        if mean(between) < force {
            low = between;
        } else {
            high = between;
        }
    }
    let most = springs.iter().fold(f64::NEG_INFINITY, |a, &b| a.max(b));
    // The share that touches is the derivative of the mean by the depth. Its difference is taken over several rows of
    // springs, as a count of springs would only be exact to a row.
    let step = 0.02 * (low + most);
    let share = (mean(low + step) - mean(low - step)) / (2.0 * step);
    [share, low, low + most]
}

#[test]
fn a_rectangle_lies_on_a_bend_as_long_as_its_corners_or_its_middle_touch() {
    for (along, across) in [
        (0.0, 2.0),
        (3.0, 2.0),
        (0.0, -5.0),
        (-4.0, -4.0),
        (2.0, -2.0),
    ] {
        let depth = 0.01;
        // κ₁L₁² + κ₂L₂²
        let by_side = along * PAD[0] * PAD[0] + across * PAD[1] * PAD[1];
        let [share, least, most] = contact(&pad(), depth, bend(along, across));
        assert_eq!(share, 1.0);
        let middle = 1.0 + by_side / (24.0 * depth);
        let corner = 1.0 - by_side / (12.0 * depth);
        if along * across >= 0.0 {
            let ends = [middle.min(corner), middle.max(corner)];
            assert!((least - ends[0]).abs() < 1e-9 && (most - ends[1]).abs() < 1e-9);
        }
        let tool = ElasticFoundation::new(&pad(), depth).unwrap();
        let pressure = tool.press(1.0, Vector2::zeros(), &bend(along, across));
        assert!((pressure.evaluate(Point2::origin()) - middle).abs() < 1e-9);
        assert!((pressure.evaluate(Point2::new(0.03, 0.05)) - corner).abs() < 1e-9);
    }
    // The whole pad touches up to κL² = 12 δ on a bulge and 24 δ in a hollow, and the pressure is continuous there.
    for (limit, sign) in [(12.0, 1.0), (24.0, -1.0)] {
        let at = |share: f64| {
            let curvature = sign * share * limit * 0.01 / (PAD[1] * PAD[1]);
            contact(&pad(), 0.01, bend(0.0, curvature))
        };
        let [inside, beyond] = [at(1.0 - 1e-9), at(1.0 + 1e-9)];
        assert_eq!(inside[0], 1.0);
        assert!(beyond[0] < 1.0 && beyond[0] > 1.0 - 1e-4, "{beyond:?}");
        assert!((inside[1] - beyond[1]).abs() < 1e-6 && (inside[2] - beyond[2]).abs() < 1e-6);
    }
}

#[test]
fn strips_and_discs_have_closed_forms() {
    for (side, depth) in [(0usize, 1e-3), (1, 1e-3), (1, 1e-4), (1, 1e-2)] {
        for curvature in [2.0, 20.0, 50.0] {
            let bent = [bend(curvature, 0.0), bend(0.0, curvature)][side];
            let [share, ..] = contact(&pad(), depth, bent);
            // Λ = κL²/12δ: a strip of share Λ^(−1/3).
            let ratio = curvature * PAD[side] * PAD[side] / (12.0 * depth);
            let expected = ratio.powf(-1.0 / 3.0).min(1.0);
            assert!((share - expected).abs() < 1e-6, "{share} {expected}");
        }
    }
    // A hollow: the tool rides on two strips beyond y₀, (κ/L)(L³/24 + ⅔y₀³ − ½y₀²L) = δ.
    for (curvature, depth) in [(2.0, 1e-4), (12.5, 1e-3), (30.0, 1e-2)] {
        let tool = ElasticFoundation::new(&pad(), depth).unwrap();
        let pressure = tool.press(1.0, Vector2::zeros(), &bend(0.0, -curvature));
        let inner = (-2.0 * pressure.middle * depth / curvature).sqrt();
        let length = PAD[1];
        let sum = length.powi(3) / 24.0 + 2.0 / 3.0 * inner.powi(3) - 0.5 * inner * inner * length;
        assert!((curvature / length * sum / depth - 1.0).abs() < 1e-6);
        let share = 1.0 - 2.0 * inner / length;
        assert!((tool.touched_share(&pressure) - share).abs() < 1e-6);
    }
    // A round pad on a ball: a disc of share Λ^(−1/2), Λ = κr²/4δ, with πr² the area of the polygon.
    let round: Vec<Point2> = (0..64)
        .map(|i| {
            Point2::new(
                libm::cos(f64::from(i) * PI / 32.0),
                libm::sin(f64::from(i) * PI / 32.0),
            ) * 0.05
        })
        .collect();
    let round = Region::new(vec![Polygon::new(round, vec![])]);
    for (curvature, depth) in [(4.0, 1e-3), (10.0, 1e-4), (20.0, 5e-3)] {
        let [share, _, most] = contact(&round, depth, bend(curvature, curvature));
        let ratio = curvature * round.area() / (4.0 * PI * depth);
        assert!((share - ratio.powf(-0.5)).abs() < 1e-6, "{share} {ratio}");
        assert!((most - 2.0 * ratio.sqrt()).abs() < 1e-6, "{most} {ratio}");
    }
}

/// The numbers of a pad of 10 × 6 cm that the documents state, to their last digit.
#[test]
fn a_known_pad_on_known_surfaces() {
    let soft = |bend| contact(&pad(), 0.01, bend);
    let close = |found: [f64; 3], expected: [f64; 3]| {
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() < 0.0051, "{found} {expected}");
        }
    };
    close(soft(bend(0.0, 2.0)), [1.0, 0.83, 1.08]);
    close(soft(bend(2.0, 0.0)), [1.0, 0.94, 1.03]);
    close(soft(bend(-4.0, -4.0)), [1.0, 0.77, 1.45]);
    assert!((soft(bend(0.0, 20.0))[0] - 0.84).abs() < 0.0051);
    let rigid = |bend| contact(&pad(), 0.0, bend)[0];
    assert!((rigid(bend(0.0, 2.0)) - 0.39).abs() < 0.0051);
    assert!((rigid(bend(2.0, 0.0)) - 0.55).abs() < 0.0051);
}

#[test]
fn the_integrals_are_those_of_springs() {
    let oval = |x: f64, y: f64| (x / 0.03).powi(2) + (y / 0.05).powi(2) <= 1.0;
    let ring: Vec<Point2> = (0..360)
        .map(|i| {
            let angle = f64::from(i) * PI / 180.0;
            Point2::new(0.03 * libm::cos(angle), 0.05 * libm::sin(angle))
        })
        .collect();
    let ring = Region::new(vec![Polygon::new(ring, vec![])]);
    let cases = [
        (0.0, 2.0, 0.0, 1e-4, [0.0; 2], 1.0),
        (2.0, -2.0, 0.0, 1e-3, [0.0; 2], 1.0),
        (2.0, -2.0, 0.5, 1e-4, [0.0; 2], 1.0),
        (4.0, 4.0, 0.0, 1e-3, [0.0; 2], 1.0),
        (-12.5, -12.5, 0.0, 5e-3, [0.0; 2], 1.0),
        (-4.0, -4.0, 0.0, 1e-3, [0.01, 0.02], 0.6),
        (20.0, 0.0, 0.4, 5e-3, [0.0; 2], 0.3),
        (3.0, 0.0, 1.1, 1e-3, [0.02, -0.03], 0.7),
        (0.0, 0.0, 0.0, 1e-3, [0.05, 0.02], 0.4),
        (6.0, 1.0, 0.8, 2e-3, [-0.05, 0.0], 1.5),
    ];
    for (first, second, turn, depth, slope, force) in cases {
        let turned = Rotation2::new(turn);
        let bent = turned.matrix() * bend(first, second) * turned.inverse().matrix();
        let slope = Vector2::from(slope);
        let height = |x: f64, y: f64| {
            let q = Vector2::new(x, y);
            (slope.dot(&q) - 0.5 * q.dot(&(bent * q))) / depth
        };
        for (is_oval, footprint) in [(false, pad()), (true, ring.clone())] {
            let tool = ElasticFoundation::new(&footprint, depth).unwrap();
            let pressure = tool.press(force, slope, &bent);
            let under = |x: f64, y: f64| !is_oval || oval(x, y);
            let [share, middle, most] = contact_of_springs(under, force, height);
            let found = [
                tool.touched_share(&pressure),
                pressure.middle,
                tool.range(&pressure)[1],
            ];
            let scale = most.max(1.0);
            let case = format!("{first} {second} {depth} oval {is_oval}");
            assert!((found[0] - share).abs() < 2e-3, "{case}: {found:?} {share}");
            assert!(
                (found[1] - middle).abs() < 2e-3 * scale,
                "{case}: {found:?} {middle}"
            );
            assert!(
                (found[2] - most).abs() < 2e-2 * scale,
                "{case}: {found:?} {most}"
            );
        }
    }
}

#[test]
fn a_plane_is_pressed_evenly_and_foam_bottoms_out() {
    let tool = ElasticFoundation::new(&pad(), 0.005).unwrap();
    let even = tool.press(0.7, Vector2::zeros(), &Matrix2::zeros());
    assert_eq!((even.middle, tool.touched_share(&even)), (0.7, 1.0));
    assert_eq!(tool.range(&even), [0.7; 2]);
    let corner = tool.press(1.0, Vector2::zeros(), &bend(-12.5, -12.5));
    assert!(tool.range(&corner)[1] > MAX_PRESSURE);
    assert_eq!(corner.evaluate(Point2::new(0.03, 0.05)), MAX_PRESSURE);
    assert_eq!(ElasticFoundation::new(&Region::default(), 0.005), None);
}

#[test]
fn the_largest_pressure_on_a_straight_way_is_that_of_its_places() {
    let tool = ElasticFoundation::new(&pad(), 0.002).unwrap();
    for (slope, bent) in [
        ([0.0, 0.0], bend(0.0, 8.0)),
        ([0.01, 0.0], bend(-5.0, 3.0)),
        ([0.0, -0.02], bend(-3.0, -3.0)),
    ] {
        let pressure = tool.press(1.0, Vector2::from(slope), &bent);
        for (from, to) in [
            ([-0.03, -0.05], [0.03, 0.05]),
            ([0.0, -0.05], [0.02, -0.01]),
            ([0.03, 0.0], [0.03, 0.0]),
        ] {
            let (from, to) = (Point2::from(from), Point2::from(to));
            let places =
                (0..=1000).map(|i| pressure.evaluate(from + (to - from) * (f64::from(i) / 1000.0)));
            let most = places.fold(0.0, f64::max);
            assert!((pressure.largest_between(from, to) - most).abs() < 1e-5);
        }
    }
    // An upright tool that turns by a right angle swaps its sides.
    let [a, b] = [0.0, FRAC_PI_2].map(|yaw| tool.press_upright(&bend(0.0, 8.0), yaw).middle);
    let c = tool.press_upright(&bend(8.0, 0.0), FRAC_PI_2).middle;
    assert!((a - c).abs() < 1e-9 && (a - b).abs() > 0.1);
}

#[test]
fn the_needed_compression_is_that_at_which_the_least_pressure_vanishes() {
    let [x, y] = PAD;
    for curvatures in [
        [2.0, 0.0],
        [2.0, 2.0],
        [2.0, -2.0],
        [-4.0, -4.0],
        [11.5, -0.3],
        [0.0, -3.0],
    ] {
        let [one, other] = curvatures;
        let needed = find_needed_compression(curvatures, PAD);
        // Of the two ways to lay the pad, the better one just touches everywhere.
        let least = |along, across| {
            let tool = ElasticFoundation::new(&pad(), needed).unwrap();
            let pressure = tool.press(1.0, Vector2::zeros(), &bend(along, across));
            tool.range(&pressure)[0]
        };
        let (this, that) = (least(one, other), least(other, one));
        let found = this.max(that);
        assert!(
            found.abs() < 1e-6,
            "{curvatures:?} on {x} x {y}: {this} {that}"
        );
    }
}

#[test]
fn a_harmless_bend_leaves_enough_pressure_everywhere_at_every_yaw() {
    let shifted = Polygon::rectangle(Vector2::new(0.03, 0.05));
    let moved = shifted
        .outer()
        .iter()
        .map(|corner| corner + Vector2::new(0.02, -0.01));
    let two_pieces = Region::new(vec![
        shifted.clone(),
        Polygon::new(
            moved
                .map(|corner| corner + Vector2::new(0.06, 0.0))
                .collect(),
            Vec::new(),
        ),
    ]);
    for (footprint, compression, least) in [
        (pad(), 0.01, 0.3),
        (pad(), 0.002, 0.05),
        (two_pieces, 0.005, 0.5),
    ] {
        let tool = ElasticFoundation::new(&footprint, compression).unwrap();
        let size = tool.harmless_bend(least);
        assert!(size > 0.0);
        for (i, j) in (0..24).flat_map(|i| (0..24).map(move |j| (i, j))) {
            let [mix, yaw] = [i, j].map(|k| f64::from(k) * PI / 12.0);
            let [along, across] = [size * mix.cos(), size * mix.sin()];
            let pressure = tool.press_upright(&bend(along, across), yaw);
            assert!(tool.range(&pressure)[0] >= least, "{mix} {yaw}");
        }
    }
    assert_eq!(
        ElasticFoundation::new(&pad(), 0.01)
            .unwrap()
            .harmless_bend(2.0),
        0.0
    );
}
