//! The capability map of the humanoid's right arm: samples, making, queries, reading.

use divan::{Bencher, black_box, counter::ItemsCount};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::sync::LazyLock;
use wisch_robot::geometry::{Point3, Pose, Vector3};
use wisch_robot::{
    CapabilityMap, Chain, CollisionModel, MapConfig, MapRequest, RobotHash, RobotModel,
};

fn main() {
    divan::main();
}

static HUMANOID: LazyLock<RobotModel> = LazyLock::new(|| {
    let text = include_str!("../../../robots/humanoid.urdf");
    RobotModel::from_urdf("humanoid.urdf", text, &mut |_| Err(String::new())).unwrap()
});

fn arm() -> Chain {
    let [base, tip] = ["right_arm_base", "right_tcp"].map(|name| HUMANOID.link(name).unwrap());
    HUMANOID.chain(base, tip).unwrap()
}

fn make(config: &MapConfig) -> CapabilityMap {
    let chain = arm();
    let collisions = CollisionModel::new(&HUMANOID, None).unwrap();
    let collisions = collisions.with_variables(chain.variables());
    let tool = MapRequest {
        robot: &HUMANOID,
        base: chain.base(),
        tip: chain.tip(),
        tip_from_tool: Pose::identity(),
        posture: &vec![0.0; HUMANOID.dof()],
    };
    let is_free = |q: &[f64]| matches!(collisions.collision(q, 0.0), Ok(None));
    CapabilityMap::build(&tool, is_free, config, |_, _, _| {}).unwrap()
}

/// The map at 5 cm, without the refinement of its boundary: as large, made sooner.
static MAP: LazyLock<CapabilityMap> = LazyLock::new(|| {
    make(&MapConfig {
        samples: 200_000,
        refinements: 0,
        ..MapConfig::default()
    })
});

fn poses(count: usize) -> Vec<Pose> {
    let mut random = ChaCha8Rng::seed_from_u64(0);
    let mut cube = || Vector3::from_fn(|_, _| 2.0 * random.random::<f64>() - 1.0);
    let pose = |_| {
        let place = 0.6 * cube();
        let rotation = nalgebra::UnitQuaternion::rotation_between(&Vector3::z(), &cube());
        Pose::from_parts(place.into(), rotation.unwrap_or_default())
    };
    (0..count).map(pose).collect()
}

/// Far apart, so that the values are not in the cache.
#[divan::bench(sample_count = 20)]
fn reachability_of_10000_poses(bencher: Bencher) {
    let poses = poses(10_000);
    let map = &*MAP;
    bencher
        .counter(ItemsCount::new(poses.len()))
        .bench_local(|| {
            let all = poses.iter().map(|pose| map.reachability(black_box(pose)));
            all.sum::<f64>()
        });
}

#[divan::bench(sample_size = 1000)]
fn index_of_a_point(bencher: Bencher) {
    let map = &*MAP;
    bencher.bench_local(|| map.index(black_box(&Point3::new(0.3, -0.2, 0.1))));
}

/// Random positions of the arm, where its tool is, and whether it touches the rest.
#[divan::bench(sample_count = 20)]
fn forward_samples_10000_checked(bencher: Bencher) {
    let chain = arm();
    let collisions = CollisionModel::new(&HUMANOID, None).unwrap();
    let collisions = collisions.with_variables(chain.variables());
    let mut random = ChaCha8Rng::seed_from_u64(0);
    let mut all = vec![0.0; HUMANOID.dof()];
    const SAMPLES: usize = 10_000;
    bencher.counter(ItemsCount::new(SAMPLES)).bench_local(|| {
        let mut sum = 0.0;
        for _ in 0..SAMPLES {
            let mut q = [0.0; 7];
            for (q, &variable) in q.iter_mut().zip(chain.variables()) {
                let limits = HUMANOID.variable(variable).limits.position.unwrap();
                *q = limits.lower + (limits.upper - limits.lower) * random.random::<f64>();
                all[variable] = *q;
            }
            let base_from_tip = chain.forward_kinematics(&q).unwrap().base_from_tip();
            if collisions.collision(&all, 0.0).unwrap().is_none() {
                sum += base_from_tip.translation.x;
            }
        }
        sum
    });
}

#[divan::bench(sample_count = 1, sample_size = 1)]
fn make_at_10_cm(bencher: Bencher) {
    bencher.bench_local(|| {
        make(&MapConfig {
            voxel: 0.1,
            frequency: 3,
            samples: 100_000,
            ..MapConfig::default()
        })
    });
}

#[divan::bench(sample_count = 10)]
fn read_from_bytes(bencher: Bencher) {
    let bytes = MAP.to_bytes();
    let hash = RobotHash::from_robot(&HUMANOID);
    bencher.bench_local(|| CapabilityMap::from_bytes("map", black_box(&bytes), hash).unwrap());
}
