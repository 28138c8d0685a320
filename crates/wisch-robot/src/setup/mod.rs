//! The SRDF of a robot that has only a URDF: planning groups, a ready posture, and pairs of links that need no check.
//!
//! | step | function | result |
//! |---|---|---|
//! | 1 | [`find_arms`] | arms, with the groups of each |
//! | 2 | [`sample_pairs`] | pairs of links that are not checked against each other |
//! | 3 | [`find_ready`] | a posture free of self-collision, with the tool over a place to wipe |
//!
//! Every step is deterministic: its result depends on the robot and on [`SetupConfig`], not on the number of threads.
//! [`Srdf::to_xml`](crate::Srdf::to_xml) writes the result.
//!
//! ```
//! # let text = include_str!("../../../../robots/arm6.urdf");
//! # let robot = wisch_robot::RobotModel::from_urdf("arm6.urdf", text, &mut |_| Err(String::new()))?;
//! use wisch_robot::setup::{ReadyRequest, SetupConfig, WipingRegion};
//! use wisch_robot::setup::{find_arms, find_ready, middle_posture, sample_pairs};
//! use wisch_robot::{CollisionModel, Srdf};
//!
//! let config = SetupConfig { pair_samples: 1000, posture_samples: 200, ..SetupConfig::default() };
//! let arms = find_arms(&robot, &[])?;
//! assert_eq!((arms[0].name.as_str(), arms[0].groups.len()), ("arm", 1));
//! let pairs = sample_pairs(&robot, &arms, &config, |_, _, _| {})?;
//! let srdf = Srdf::new(Vec::new(), Vec::new(), pairs.disabled);
//!
//! let held = middle_posture(&robot);
//! let ready = find_ready(
//!     &ReadyRequest {
//!         robot: &robot,
//!         group: &arms[0].groups[0].group,
//!         axis: arms[0].tip_axis,
//!         held: &held,
//!         collisions: &CollisionModel::new(&robot, Some(&srdf))?,
//!         regions: &WipingRegion::around(&robot, &arms[0], &held)?,
//!     },
//!     &config,
//!     |_, _, _| {},
//! )?;
//! assert!(ready.clearance > 0.005); // [m]
//! assert!(ready.tilt < 0.01); // points down
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod arms;
mod config;
mod error;
mod joint_tree;
mod link_names;
mod pairs;
mod postures;
mod ready;
mod region;
mod tips;

pub use arms::{ArmChain, ProposedGroup, find_arms};
pub use config::{SetupConfig, SetupStage};
pub use error::SetupError;
pub use pairs::{LinkPairs, sample_pairs};
pub use postures::{held_posture, middle_posture};
pub use ready::{
    ReadyPosture, ReadyRequest, SINGULAR, find_ready, find_ready_postures, manipulability,
};
pub use region::{WipingRegion, find_table, hand_extent, lowest_point};
