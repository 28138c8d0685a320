//! Acute corners of strokes.

use wisch::follow::{FollowConfig, follow};
use wisch::geometry::{PlanarPose, Point2};
use wisch::plan::plan_from_strokes;
use wisch::represent::Action;
use wisch_testkit::{board, cell, faults};

#[test]
fn the_tool_reaches_the_tip_of_an_acute_corner_as_the_audit_demands() {
    let task = board(Action::Absorb, [0.5, 0.0, 0.2]);
    let cell = cell(&task);
    for height in [0.005, 0.01, 0.02, 0.04] {
        let corner = [[-0.08, 0.0], [0.08, height / 2.0], [-0.08, height]];
        let stroke = corner.map(|[x, y]| PlanarPose::new(Point2::new(x, y), 0.0));
        let plan = plan_from_strokes(&task, &[stroke.to_vec()], 0.05).unwrap();
        let config = FollowConfig::default();
        let followed = follow(&task, &plan, &cell, None, &config, &mut |_| ()).unwrap();
        assert_eq!(followed.abandoned, []);
        assert_eq!(faults(&task, &plan, &cell, &followed), [] as [String; 0]);
    }
}
