use super::*;
use crate::geometry::{Polygon, Pose};
use crate::represent::ToolPace;

/// A board of 2 x 0.1 m that leans towards −x.
fn board(angle: f64) -> Surface {
    let outline = Polygon::rectangle(Vector2::new(2.0, 0.1));
    Surface::new(
        "board",
        outline,
        Pose::new(Vector3::zeros(), -Vector3::y() * angle),
    )
}

const ANGLE: f64 = 0.5;
const THICKNESS: f64 = 2e-4;
const LENGTH: f64 = 0.5;

/// A glycerol solution.
fn film(particle_volume: f64, adhering_thickness: f64) -> FilmFlow {
    let liquid = Liquid {
        viscosity: 0.01,
        density: 1100.0,
        adhering_thickness,
    };
    let film = LiquidFilm {
        liquid,
        particle_volume,
        pace: ToolPace::default(),
    };
    FilmFlow::new(film, OccupiedArea::default())
}

/// c = ρ g sin θ / 3μ.
fn rate() -> f64 {
    1100.0 * GRAVITY * ANGLE.sin() / 0.03
}

/// A film over the uppermost 0.5 m of the board in a lattice, and the volume of each particle. The board's upper end is at
/// x = 1 m.
fn lattice(rows: usize) -> (Vec<Point2>, f64) {
    let columns = rows / 5;
    let count = rows * columns;
    let place = |i: usize| {
        let (row, column) = (i / columns, i % columns);
        Point2::new(
            1.0 - LENGTH * (row as f64 + 0.5) / rows as f64,
            0.1 * ((column as f64 + 0.5) / columns as f64 - 0.5),
        )
    };
    let volume = LENGTH * 0.1 * THICKNESS / count as f64;
    ((0..count).map(place).collect(), volume)
}

fn run(flow: &FilmFlow, places: &[Point2], durations: &[f64]) -> Vec<Point2> {
    let surface = board(ANGLE);
    let spacing = 0.1 / (places.len() as f64 / 5.0).sqrt();
    durations.iter().fold(places.to_vec(), |places, &duration| {
        let moved = flow.displacements(&places, &surface, spacing, duration);
        places
            .iter()
            .zip(moved)
            .map(|(place, by)| place + by)
            .collect()
    })
}

/// Distances from the upper end, in order [m].
fn ways(places: &[Point2]) -> Vec<f64> {
    let mut ways: Vec<f64> = places.iter().map(|place| 1.0 - place.x).collect();
    ways.sort_unstable_by(f64::total_cmp);
    ways
}

/// Jeffreys (1930): the film that drains has h = √(μ x / ρ g t sin θ), up to x = ρ g h₀² t sin θ / μ, where it meets the film
/// of the first thickness h₀. That ends at a front that advances by ρ g h₀² t sin θ / 3μ.
#[test]
fn a_film_drains_with_the_profile_of_jeffreys_behind_a_front_of_the_mean_speed() {
    let (places, volume) = lattice(240);
    assert!(places.len() > 9_000);
    let flow = film(volume, 0.0);
    let time = 0.5 * LENGTH / (3.0 * rate() * THICKNESS * THICKNESS);
    for durations in [vec![time], vec![time / 5.0; 5]] {
        let found = ways(&run(&flow, &places, &durations));
        let front = LENGTH + rate() * THICKNESS * THICKNESS * time;
        let last = found.last().unwrap();
        assert!((last / front - 1.0).abs() < 0.01, "{last} {front}");
        let meets = 3.0 * rate() * THICKNESS * THICKNESS * time;
        assert!((meets - 0.5 * LENGTH).abs() < 1e-12);
        // The volume above x is ⅔ x √(x / 3ct), per width.
        for tenth in 2..=10 {
            let x = meets * f64::from(tenth) / 10.0;
            let above = found.iter().filter(|way| **way < x).count() as f64 * volume / 0.1;
            let wanted = 2.0 / 3.0 * x * (x / (3.0 * rate() * time)).sqrt();
            // Within 3 % of the mean thickness.
            let off = (above - wanted).abs() / x;
            assert!(off < 0.03 * THICKNESS, "{x}: {above} {wanted}");
        }
        // Below, the thickness is still the first one.
        for x in [0.6 * LENGTH, 0.9 * LENGTH] {
            let between = found
                .iter()
                .filter(|way| (x..x + 0.04).contains(*way))
                .count();
            let thickness = between as f64 * volume / (0.1 * 0.04);
            assert!(
                (thickness / THICKNESS - 1.0).abs() < 0.03,
                "{x}: {thickness}"
            );
        }
        assert_eq!(found.len(), places.len());
    }
}

#[test]
fn an_adhering_layer_stays_and_the_rest_runs_off() {
    let (places, volume) = lattice(80);
    let adhering = 0.5 * THICKNESS;
    let flow = film(volume, adhering);
    // The film that still lies where it lay, after ever longer times.
    let left = [1.0, 100.0, 1e4, 1e6].map(|time| {
        let found = ways(&run(&flow, &places, &[time]));
        let on = found.iter().filter(|way| (0.1..0.4).contains(*way)).count();
        on as f64 * volume / (0.1 * 0.3)
    });
    assert!(
        left.windows(2).all(|pair| pair[1] <= pair[0] * 1.001),
        "{left:?}"
    );
    assert!(
        (left[0] / THICKNESS - 1.0).abs() < 0.1 && (left[3] / adhering - 1.0).abs() < 0.05,
        "{left:?}"
    );
    // A film that adheres as a whole does not move.
    let still = film(volume, 1.1 * THICKNESS);
    assert_eq!(run(&still, &places, &[1e3]), places);
}

#[test]
fn a_film_on_a_level_or_curved_surface_or_in_no_time_does_not_move() {
    let (places, volume) = lattice(50);
    let still = |surface: &Surface, duration| {
        let moved = film(volume, 0.0).displacements(&places, surface, 0.01, duration);
        moved.iter().all(|by| *by == Vector2::zeros())
    };
    assert!(still(&board(0.0), 1e3) && still(&board(ANGLE), 0.0));
    assert!(!still(&board(ANGLE), 1.0));
    let mut bent = board(ANGLE);
    bent.shape = crate::represent::SurfaceShape::Cylinder {
        radius: 2.0,
        axis: 0.0,
    };
    assert!(still(&bent, 1e3));
}

#[test]
fn a_film_beyond_the_limit_of_its_reynolds_number_runs_no_faster() {
    let film = Liquid::WATER;
    let thickest = film.largest_thickness(ANGLE);
    let speed = film.speed(thickest, ANGLE);
    assert!((1000.0 * speed * thickest / 1e-3 - MAX_REYNOLDS).abs() < 1e-6);
    assert_eq!(film.speed(2.0 * thickest, ANGLE), speed);
    // 0.3 mm of water upright: a Reynolds number of 88.
    let bare = 1000.0 * GRAVITY * 9e-8 / 3e-3;
    assert!((1000.0 * bare * 3e-4 / 1e-3 - 88.3).abs() < 0.1 && bare > film.speed(3e-4, 1.57));
    assert_eq!(film.speed(1e-4, 0.0), 0.0);
}

#[test]
fn the_speed_at_which_a_volume_passes_is_the_inverse_of_the_transform() {
    for adhering in [0.0, 1e-4] {
        let FilmFlow { film, .. } = film(1e-9, adhering);
        let slope = film.liquid.on_slope(ANGLE.sin());
        for speed in [1e-6, 1e-3, 0.02] {
            let passing = speed * (adhering + 2.0 / 3.0 * (speed / (3.0 * slope.rate)).sqrt());
            assert!((slope.speed_of(passing) / speed - 1.0).abs() < 1e-9);
        }
    }
}

#[test]
fn a_film_stops_before_an_object() {
    let (places, volume) = lattice(40);
    let mut flow = film(volume, 0.0);
    let bar = crate::geometry::Mesh::cuboid(Vector3::new(0.02, 0.2, 0.02)).unwrap();
    flow.occupied = OccupiedArea::from_scene([&bar]);
    let found = run(&flow, &places, &[200.0; 10]);
    assert!(found.iter().all(|place| place.x > 0.01 - 1e-9));
    assert!(found.iter().any(|place| place.x < 0.02));
}
