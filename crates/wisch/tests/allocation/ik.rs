//! Solving for joint positions allocates nothing, restarts included.

use crate::ALLOCATOR;
use stats_alloc::Region as Watched;
use wisch::geometry::Pose;
use wisch::robot::{IkConfig, IkOutcome, IkSolver, RobotModel, RotationGoal};

pub fn solving_and_self_motion_allocate_nothing() {
    let text = include_str!("../../../../robots/humanoid.urdf");
    let robot = RobotModel::from_urdf("humanoid", text, &mut |_| Err(String::new())).unwrap();
    let (base, tip) = (
        robot.link("platform").unwrap(),
        robot.link("right_tcp").unwrap(),
    );
    let solver = IkSolver::new(&robot, base, tip, Pose::identity()).unwrap();
    let config = IkConfig::default();
    let out_of_reach = Pose::translation(5.0, 0.0, 1.0);

    let watched = Watched::new(ALLOCATOR);
    let before = watched.change().allocations;
    let outcome = solver.solve(&out_of_reach, RotationGoal::Full, &[], 1, &config);
    let Ok(IkOutcome::Stuck { best, .. }) = outcome else {
        panic!("{outcome:?}");
    };
    solver.relax(RotationGoal::Full, &best, &config).unwrap();
    assert_eq!(watched.change().allocations, before);

    // The counter detects an allocation.
    let grown: Vec<u8> = Vec::with_capacity(std::hint::black_box(64));
    assert_eq!(watched.change().allocations, before + 1);
    drop(grown);
}
