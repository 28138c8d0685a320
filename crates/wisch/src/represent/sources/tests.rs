use super::*;
use crate::geometry::{Mesh, Pose, Vector3};

const BOARD: [f64; 2] = [0.40, 0.28];

fn board() -> Polygon {
    Polygon::rectangle(Vector2::from(BOARD))
}

/// A cup of radius 0.08 m in the middle of the board.
fn cup() -> OccupiedArea {
    let mesh = Mesh::cylinder(0.08, 0.1, 48).expect("sizes are positive");
    OccupiedArea::from_scene([&mesh.transform(&Pose::translation(0.0, 0.0, 0.05))])
}

fn bare() -> OccupiedArea {
    OccupiedArea::default()
}

fn on<'a>(outline: &'a Polygon, occupied: &'a OccupiedArea) -> DirtArea<'a> {
    DirtArea { outline, occupied }
}

#[test]
fn an_object_below_the_surface_does_not_occupy_it() {
    let table = Mesh::cuboid(Vector3::new(1.0, 1.0, 0.1)).expect("sizes are positive");
    let below = table.transform(&Pose::translation(0.0, 0.0, -0.05));
    assert!(!OccupiedArea::from_scene([&below]).contains(Point2::origin()));
    assert!(OccupiedArea::from_scene([&table]).contains(Point2::origin()));
}

#[test]
fn no_particle_is_spread_over_an_object_or_off_the_board() {
    let (board, cup) = (board(), cup());
    let heap = Cluster {
        center: Point2::new(0.08, 0.0),
        sigma: 0.05,
        weight: 1.0,
    };
    let area = on(&board, &cup);
    for seed in 0..20 {
        let spread = uniform_particles(area, 500, seed).expect("there is room");
        let heaped = cluster_particles(area, &[heap], 500, seed).expect("there is room");
        for position in spread.remaining().chain(heaped.remaining()) {
            assert!(board.contains(position));
            // The cup's rim is a polygon within its circle, at least cos(π/48) of the radius.
            assert!(position.coords.norm() > 0.0798, "{position}");
        }
    }
}

#[test]
fn an_even_spread_fills_each_quarter_alike() {
    let (board, bare) = (board(), bare());
    let particles = uniform_particles(on(&board, &bare), 40_000, 3).expect("there is room");
    for (sx, sy) in [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)] {
        let quarter = particles
            .remaining()
            .filter(|p| p.x * sx > 0.0 && p.y * sy > 0.0);
        // Binomial: 10 000 ± 87; five standard deviations.
        assert!(quarter.count().abs_diff(10_000) < 435);
    }
}

#[test]
fn a_heap_has_its_centre_spread_and_share() {
    let (board, bare) = (board(), bare());
    let heap = |x, weight| Cluster {
        center: Point2::new(x, 0.02),
        sigma: 0.01,
        weight,
    };
    let heaps = [heap(-0.1, 3.0), heap(0.1, 1.0)];
    let particles = cluster_particles(on(&board, &bare), &heaps, 40_000, 5).expect("there is room");
    let left: Vec<Point2> = particles.remaining().filter(|p| p.x < 0.0).collect();
    // Binomial: 30 000 ± 87; five standard deviations.
    assert!(left.len().abs_diff(30_000) < 435);
    let count = left.len() as f64;
    let mean = left.iter().map(|p| p.coords).sum::<Vector2>() / count;
    // The mean of 30 000 draws is off by 0.01 / √30 000 = 0.00006 m.
    assert!((mean - Vector2::new(-0.1, 0.02)).norm() < 5e-4);
    let variance = left
        .iter()
        .map(|p| (p.coords - mean).norm_squared())
        .sum::<f64>()
        / count
        / 2.0;
    assert!((variance.sqrt() - 0.01).abs() < 2e-4);
}

#[test]
fn the_seed_decides() {
    let (board, cup) = (board(), cup());
    let area = on(&board, &cup);
    let spread = |seed| uniform_particles(area, 100, seed).expect("there is room");
    assert_eq!(spread(1), spread(1));
    assert_ne!(spread(1), spread(2));
}

#[test]
fn counts_and_places_that_cannot_be_are_refused() {
    let (board, bare) = (board(), bare());
    let area = on(&board, &bare);
    let refused = uniform_particles(area, 0, 1).unwrap_err().to_string();
    assert!(
        refused.contains("count = 0") && refused.contains("at least 1"),
        "{refused}"
    );
    let elsewhere = Cluster {
        center: Point2::new(5.0, 0.0),
        sigma: 0.01,
        weight: 1.0,
    };
    // Two heaps, of which one lies beside the board: its particles are not drawn from the other.
    let on_board = Cluster {
        center: Point2::origin(),
        ..elsewhere
    };
    let error = cluster_particles(area, &[on_board, elsewhere], 10, 1).unwrap_err();
    assert!(
        matches!(error, SourceError::OffSurface { cluster: 1, .. }),
        "{error}"
    );
}
