//! Strokes allocate nothing once their scratch space has its size.

use crate::ALLOCATOR;
use stats_alloc::Region as Watched;
use wisch::geometry::{PlanarPose, Point2, Polygon, Region, Vector2};
use wisch::represent::{Effect, EffectModel, ParticleDistribution, ParticleField, ToolMotion};

pub fn a_stroke_allocates_nothing() {
    let points: Vec<Point2> = (0..2000)
        .map(|i| {
            let a = f64::from(i) * 2.399_963;
            Point2::new(a.cos(), a.sin()) * (0.45 * (f64::from(i) / 2000.0).sqrt())
        })
        .collect();
    let surface = wisch_testkit::surface([1.0; 2]);
    let sponge = Region::new(vec![Polygon::rectangle(Vector2::new(0.07, 0.11))]);
    let pose = |x: f64, y: f64, heading: f64| PlanarPose::new(Point2::new(x, y), heading);
    let there = ToolMotion {
        from: pose(-0.2, 0.0, 0.0),
        to: pose(0.2, 0.0, 0.0),
    };
    let turning = ToolMotion {
        from: there.to,
        to: pose(0.1, 0.2, 1.5),
    };
    let mut field = ParticleField::new(&ParticleDistribution::new(&points).unwrap());
    let mut model = EffectModel::new(&sponge, Effect::Push);
    for motion in [&there, &turning] {
        model.apply(&mut field.clone(), &surface, motion);
    }

    let watched = Watched::new(ALLOCATOR);
    let before = watched.change().allocations;
    for motion in [&there, &turning] {
        let effect = model.apply(&mut field, &surface, motion);
        assert!(effect.pushed > 10);
    }
    assert_eq!(watched.change().allocations, before);

    // The counter detects an allocation.
    let grown: Vec<u8> = Vec::with_capacity(std::hint::black_box(64));
    assert_eq!(watched.change().allocations, before + 1);
    drop(grown);
}
