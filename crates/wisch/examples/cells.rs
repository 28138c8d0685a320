//! scratch
use rand::RngExt;
use rand_chacha::{ChaCha8Rng, rand_core::SeedableRng};
use wisch::geometry::*;
use wisch::plan::*;
use wisch::represent::*;

fn boxed(name: &str, size: [f64; 3], at: [f64; 3]) -> SceneObject {
    SceneObject {
        name: name.into(),
        mesh: Mesh::cuboid(Vector3::new(size[0], size[1], size[2])).unwrap(),
        world_from_object: Pose::translation(at[0], at[1], at[2]),
    }
}
fn cyl(name: &str, r: f64, h: f64, at: [f64; 2]) -> SceneObject {
    SceneObject {
        name: name.into(),
        mesh: Mesh::cylinder(r, h, 48).unwrap(),
        world_from_object: Pose::translation(at[0], at[1], h / 2.0),
    }
}

fn pillar(side: f64) -> SceneObject {
    let mut o = boxed("pillar", [0.06, 0.6, 0.06], [side * 0.49, 0.0, 0.0]);
    o.world_from_object.rotation =
        nalgebra::UnitQuaternion::from_euler_angles(0.0, 0.0, side * 0.1);
    o
}
pub fn task(which: usize, action: Action, seed: u64) -> Task {
    let (size, count, scene, goal, start) = match which {
        0 => (
            Vector2::new(0.40, 0.28),
            80,
            vec![],
            Point2::new(0.13, -0.08),
            Point2::new(0.0, -0.25),
        ),
        1 => (
            Vector2::new(0.80, 0.50),
            80,
            vec![
                cyl("cup", 0.04, 0.1, [-0.30, 0.18]),
                cyl("bowl", 0.06, 0.08, [0.33, 0.19]),
                boxed("box", [0.10, 0.06, 0.2], [-0.02, 0.22, 0.1]),
            ],
            Point2::new(0.25, -0.15),
            Point2::new(0.0, -0.4),
        ),
        _ => (
            Vector2::new(0.90, 0.40),
            160,
            vec![pillar(-1.0), pillar(1.0)],
            Point2::new(0.0, -0.1),
            Point2::new(0.0, -0.4),
        ),
    };
    let surface = Surface {
        name: "s".into(),
        outline: Polygon::rectangle(size),
        world_from_surface: Pose::identity(),
        skim_edges: vec![0],
    };
    let mut task = Task {
        name: "t".into(),
        action,
        surface,
        scene,
        tool: Tool {
            name: "sponge".into(),
            footprint: Region::new(vec![Polygon::rectangle(Vector2::new(0.07, 0.11))]),
            area_of_effect: Vector2::new(0.07, 0.11),
        },
        medium: "breadcrumbs".into(),
        particles: ParticleDistribution::default(),
        collect_goal: Some(goal),
        tool_start: start,
        seed,
    };
    let meshes: Vec<_> = task.scene_in_surface().collect();
    let space = FreeSpace::new(&task.surface, &meshes, 0.065).unwrap();
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut pts = vec![];
    while pts.len() < count {
        let p = Point2::new(
            (rng.random::<f64>() - 0.5) * size.x,
            (rng.random::<f64>() - 0.5) * size.y,
        );
        if !space.is_occupied(p) {
            pts.push(p)
        }
    }
    task.particles = ParticleDistribution::new(&pts).unwrap();
    task
}

fn main() {
    let paper = [
        [
            [84.25, 85.00, 95.75],
            [77.00, 79.50, 70.50],
            [90.13, 90.50, 91.00],
        ],
        [
            [86.50, 86.75, 90.50],
            [70.25, 69.25, 41.75],
            [48.50, 39.25, 62.75],
        ],
        [
            [88.00, 80.25, 97.00],
            [71.75, 65.50, 53.00],
            [94.50, 88.50, 88.50],
        ],
    ];
    let paper_d = [
        [[1.52, 1.41, 1.90], [4.34, 4.10, 3.24], [4.44, 4.84, 4.69]],
        [[1.54, 1.45, 1.90], [3.68, 3.60, 2.92], [4.97, 4.76, 4.22]],
        [[1.81, 1.62, 2.01], [5.48, 4.95, 3.75], [5.58, 5.65, 5.89]],
    ];
    let ns: u64 = std::env::var("NS").map_or(5, |v| v.parse().unwrap());
    let s0: u64 = if ns == 5 { 1 } else { 101 };
    let mut wins = 0;
    for (a, action) in [Action::Absorb, Action::Collect, Action::Skim]
        .into_iter()
        .enumerate()
    {
        for s in 0..3 {
            for (k, strategy) in CoverageStrategy::ALL.into_iter().enumerate() {
                let (mut perf, mut dist, mut nodes, mut unr) = (0.0, 0.0, 0, 0.0);
                let t0 = std::time::Instant::now();
                for seed in s0..s0 + ns {
                    let t = task(s, action, seed);
                    let p = plan(
                        &t,
                        &PlanConfig {
                            strategy,
                            seed,
                            bandwidth: None,
                            lift_height: 0.05,
                        },
                    )
                    .unwrap();
                    let r = predict(&t, &p, |_| ());
                    perf += r.performance.ratio() * 100.0 / ns as f64;
                    dist += p.contact_distance() / ns as f64;
                    nodes += p.graph.nodes.len();
                    unr += p.unreachable_share * 100.0 / ns as f64;
                }
                let ms = t0.elapsed().as_secs_f64() * 1000.0 / ns as f64;
                let ok = perf >= paper[a][s][k];
                wins += ok as usize;
                println!(
                    "{:?}-{}-{} {:.2}/{:.2} {} d {:.2}/{:.2} n {:.1} unr {:.1} {:.1}ms",
                    action,
                    ["board", "table", "wind"][s],
                    strategy.as_str(),
                    perf,
                    paper[a][s][k],
                    if ok { "ok" } else { "LOW" },
                    dist,
                    paper_d[a][s][k],
                    nodes as f64 / ns as f64,
                    unr,
                    ms
                );
            }
        }
    }
    println!("{wins} of 27");
}
