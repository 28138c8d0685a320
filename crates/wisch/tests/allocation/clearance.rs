//! Queries of collisions allocate nothing once the scratch space of the thread has its size.

use crate::ALLOCATOR;
use stats_alloc::Region as Watched;
use wisch::geometry::{Mesh, Pose, Vector3};
use wisch::robot::{CollisionModel, RobotModel};

pub fn a_query_allocates_nothing() {
    let text = include_str!("../../../../robots/humanoid.urdf");
    let robot = RobotModel::from_urdf("humanoid", text, &mut |_| Err(String::new())).unwrap();
    let mut model = CollisionModel::new(&robot, None).unwrap();
    let tcp = robot.link("right_tcp").unwrap();
    let tool = Mesh::cylinder(0.04, 0.1, 12).unwrap();
    model.attach("tool", tcp, Pose::identity(), &tool).unwrap();
    let table = Mesh::cuboid(Vector3::new(1.2, 0.8, 0.04)).unwrap();
    let before_it = Pose::translation(0.9, 0.0, 0.73);
    model.add_obstacle("table", before_it, &table).unwrap();
    let from: Vec<f64> = (0..robot.dof()).map(|i| 0.02 * i as f64).collect();
    let to: Vec<f64> = from.iter().map(|position| position + 0.05).collect();
    let query = || {
        model.clearance(&from, f64::INFINITY).unwrap();
        model.collision(&from, 0.01).unwrap();
        model.segment_contact(&from, &to, 0.0).unwrap();
        model.motion_bound(&from, &to);
    };
    query();

    let watched = Watched::new(ALLOCATOR);
    let before = watched.change().allocations;
    for _ in 0..10 {
        query();
    }
    assert_eq!(watched.change().allocations, before);

    // The counter detects an allocation.
    let grown: Vec<u8> = Vec::with_capacity(std::hint::black_box(64));
    assert_eq!(watched.change().allocations, before + 1);
    drop(grown);
}
