//! The search for groups, pairs and a ready posture, with a tool on the tip and, if there is a task, in its scene.

use super::trial::{Trial, Tried, states};
use wisch::follow::{FollowError, Workcell, WorkcellConfig};
use wisch::geometry::{Bounds2, Mesh, Pose, Vector3};
use wisch::robot::setup::{
    ArmChain, LinkPairs, ReadyPosture, ReadyRequest, SetupConfig, SetupError, SetupStage,
    WipingRegion, find_arms, find_ready_postures, find_table, hand_extent, held_posture,
    sample_pairs,
};
use wisch::robot::{
    CollisionModel, Group, GroupState, JointId, JointKind, LinkAxis, LinkId, READY_STATE,
    RobotError, RobotModel, Srdf, ToolHolder,
};
use wisch_io::LoadedTask;

/// Sizes of stand-ins for a tool that is not known yet, along x, y and z of the tip \[m\]; `None` for no tool. The first one
/// with which a ready posture is found is taken.
const STAND_INS: [Option<[f64; 3]>; 3] = [Some([0.10, 0.10, 0.12]), Some([0.03, 0.03, 0.10]), None];
/// Name of the group of joints that no arm moves.
const REST_GROUP: &str = "rest";
/// Size of the table under a fixed arm \[m\].
const TABLE: [f64; 3] = [6.0, 6.0, 0.5];
/// Number of ready postures from which a plan of the task is followed.
const TRIED_POSTURES: usize = 8;
/// Acceleration of gravity \[m/s²\].
const GRAVITY: f64 = 9.81;
/// Cosine of the largest angle between the normal of a level surface and the vertical [1].
const LEVEL: f64 = 0.9;

/// A proposed SRDF, with its parts and the assumptions of the search.
pub struct Proposal {
    /// The SRDF.
    pub srdf: Srdf,
    /// The arms with their groups.
    pub arms: Vec<ArmChain>,
    /// Pairs of links that are not checked.
    pub pairs: LinkPairs,
    /// Unusual assumptions of the search.
    pub assumed: Assumed,
    /// Ready posture of each arm, with the group that was moved.
    pub ready: Vec<(Group, ReadyPosture)>,
    /// How the ready posture of the first arm was chosen, if a plan of the task was followed for it.
    pub tried: Option<Tried>,
}

/// Unusual assumptions with which a ready posture was found.
#[derive(Debug, Clone, Copy, Default)]
pub struct Assumed {
    /// Whether no tool is at the tips, because every tool would collide.
    pub no_tool: bool,
    /// Whether the robot hangs from a ceiling or a frame over the surface.
    pub hangs: bool,
}

/// Called occasionally with a stage, the work done and all work.
type Progress<'a> = &'a (dyn Fn(SetupStage, usize, usize) + Sync);

/// The place in which a ready posture is searched.
struct Scene {
    collisions: CollisionModel,
    /// Posture of the robot before the search; n values.
    held: Vec<f64>,
    place: Place,
}

/// The result of a search for ready postures.
#[derive(Default)]
struct Found {
    ready: Vec<(Group, ReadyPosture)>,
    tried: Option<Tried>,
}

/// Where the surface is, relative to the robot.
enum Place {
    /// Around the robot, on which its table or floor is.
    Around,
    /// Below the robot, which hangs.
    Below,
    /// Where the task states it.
    Known(KnownSurface),
}

/// The surface of a task, relative to the robot.
struct KnownSurface {
    root_from_surface: Pose,
    bounds: Bounds2,
    name: String,
    /// Whether the robot drives there.
    is_driven_to: bool,
}

/// Proposes an SRDF.
pub fn propose(
    robot: &RobotModel,
    tips: &[LinkId],
    task: Option<&LoadedTask>,
    config: &SetupConfig,
    progress: impl Fn(SetupStage, usize, usize) + Sync,
) -> Result<Proposal, SetupError> {
    let arms = find_arms(robot, tips)?;
    let pairs = sample_pairs(robot, &arms, config, &progress)?;
    let groups = arms.iter().flat_map(|arm| &arm.groups);
    let groups = groups.map(|proposed| proposed.group.clone()).collect();
    let mut srdf = Srdf::new(groups, build_rest_state(robot), pairs.disabled.clone());
    // z is what programs expect of a flange.
    let unusual = arms.iter().filter(|arm| arm.tip_axis != LinkAxis::Z);
    srdf.tool_holders = unusual
        .filter_map(|arm| {
            Some(ToolHolder {
                link: arm.groups.first()?.group.tip,
                axis: arm.tip_axis,
                hand_lean: None,
            })
        })
        .collect();
    let (Found { ready, tried }, assumed) = match task {
        Some(task) => {
            let (scene, trial) = scene_of_task(robot, &srdf, task)?;
            let trial = trial.as_ref().map(|trial| (trial, &srdf));
            let found = find_postures(robot, &arms, scene, trial, config, &progress)?;
            (found, Assumed::default())
        }
        None => search_without_task(robot, &srdf, &arms, config, &progress)?,
    };
    srdf.states.splice(0..0, states(robot, &arms, &ready)?);
    srdf.counterbalanced = ready
        .last()
        .map_or_else(Vec::new, |(_, last)| find_overloaded_joints(robot, &last.q));
    Ok(Proposal {
        assumed,
        srdf,
        arms,
        pairs,
        ready,
        tried,
    })
}

/// Searches ready postures without a task, assuming no more than is needed to find them.
fn search_without_task(
    robot: &RobotModel,
    srdf: &Srdf,
    arms: &[ArmChain],
    config: &SetupConfig,
    progress: Progress<'_>,
) -> Result<(Found, Assumed), SetupError> {
    let mut refused = None;
    for hangs in [false, true] {
        for stand_in in STAND_INS {
            let scene = scene_without_task(robot, srdf, arms, stand_in, hangs)?;
            let no_tool = stand_in.is_none();
            match find_postures(robot, arms, scene, None, config, progress) {
                // Most robots stand, so what prevents that is reported.
                Err(error @ SetupError::NoReadyPosture { .. }) if !hangs => refused = Some(error),
                Err(SetupError::NoReadyPosture { .. }) => {}
                ready => return Ok((ready?, Assumed { no_tool, hangs })),
            }
        }
    }
    refused.map_or_else(|| Ok((Found::default(), Assumed::default())), Err)
}

/// Searches the ready postures of all arms, one after the other; each keeps those before it. With a trial, that of the first
/// arm, which holds the tool, is the one of the best that reaches most of the surface.
fn find_postures(
    robot: &RobotModel,
    arms: &[ArmChain],
    scene: Scene,
    trial: Option<(&Trial<'_>, &Srdf)>,
    config: &SetupConfig,
    progress: Progress<'_>,
) -> Result<Found, SetupError> {
    let mut tried = None;
    let mut held = straighten(robot, arms, scene.held)?;
    let mut moved: Vec<usize> = Vec::new();
    let mut ready = Vec::new();
    for arm in arms {
        let regions = list_regions(robot, arm, &held, &scene.place)?;
        let mut found = None;
        for (group, places) in list_attempts(robot, arm, &moved, regions.len())? {
            let request = ReadyRequest {
                robot,
                group,
                axis: arm.tip_axis,
                held: &held,
                collisions: &scene.collisions,
                regions: &regions[..places],
            };
            let trial = trial.filter(|_| ready.is_empty());
            let count = trial.map_or(1, |_| TRIED_POSTURES);
            match find_ready_postures(&request, config, count, progress) {
                Err(error @ SetupError::NoReadyPosture { .. }) => found = Some(Err(error)),
                other => {
                    found = Some(other.map(|postures| (group.clone(), postures)));
                    break;
                }
            }
        }
        let Some((group, mut postures)) = found.transpose()? else {
            continue;
        };
        let posture = match trial.filter(|_| ready.is_empty()) {
            Some((trial, srdf)) => {
                let (best, result) = trial.choose(robot, srdf, arms, &group, postures)?;
                tried = result;
                best
            }
            None => postures.swap_remove(0),
        };
        held.clone_from(&posture.q);
        let chain = robot.chain(group.base, group.tip)?;
        moved.extend_from_slice(chain.variables());
        ready.push((group, posture));
    }
    Ok(Found { ready, tried })
}

/// Returns the posture with the revolute joints that carry an arm, such as those of a torso, at 0 where their limits permit
/// it: the middle of an uneven range would turn the arms aside.
fn straighten(
    robot: &RobotModel,
    arms: &[ArmChain],
    held: Vec<f64>,
) -> Result<Vec<f64>, SetupError> {
    let mut straight = held.clone();
    for arm in arms {
        let (Some(whole), Some(own)) = (arm.groups.first(), arm.groups.last()) else {
            continue;
        };
        let whole = robot.chain(whole.group.base, whole.group.tip)?;
        let own = robot.chain(own.group.base, own.group.tip)?;
        let carriers = whole
            .variables()
            .iter()
            .filter(|v| !own.variables().contains(v));
        for &variable in carriers {
            let joint = robot.variable(variable);
            let range = joint.limits.position;
            let permits = range.is_none_or(|range| (range.lower..=range.upper).contains(&0.0));
            if joint.kind == JointKind::Revolute && permits {
                straight[variable] = 0.0;
            }
        }
    }
    let has_more_faults = robot.limit_faults(&straight)?.len() > robot.limit_faults(&held)?.len();
    Ok(if has_more_faults { held } else { straight })
}

/// Returns the groups with which a posture is searched, each with the number of places: first the arm alone in the best
/// place, with a lift or torso where it stays; then with these; then in all places. Joints that an arm before has set are
/// not moved again.
fn list_attempts<'a>(
    robot: &RobotModel,
    arm: &'a ArmChain,
    moved: &[usize],
    places: usize,
) -> Result<Vec<(&'a Group, usize)>, SetupError> {
    let mut free = Vec::new();
    for proposed in arm.groups.iter().rev() {
        let group = &proposed.group;
        let chain = robot.chain(group.base, group.tip)?;
        if chain.variables().iter().all(|v| !moved.contains(v)) {
            free.push(group);
        }
    }
    if free.is_empty() {
        free.extend(arm.groups.last().map(|proposed| &proposed.group));
    }
    let first = free.iter().map(|&group| (group, 1));
    let all = free.iter().map(|&group| (group, places));
    Ok(first.chain(all.filter(|_| places > 1)).collect())
}

/// Returns the ready state of joints that cannot stay in the middle of their limits; a group of its own, if there are any.
fn build_rest_state(robot: &RobotModel) -> Vec<GroupState> {
    let (held, driving) = held_posture(robot);
    let state = GroupState {
        name: READY_STATE.to_owned(),
        group: REST_GROUP.to_owned(),
        positions: driving.into_iter().map(|v| (v, held[v])).collect(),
    };
    Vec::from_iter((!state.positions.is_empty()).then_some(state))
}

/// Returns the joints that need more effort to hold a posture than their limits permit. A robot that exists holds it, so
/// springs or weights carry such a joint, or its URDF is wrong. None if the URDF has too few masses to say.
fn find_overloaded_joints(robot: &RobotModel, q: &[f64]) -> Vec<JointId> {
    let down = Vector3::new(0.0, 0.0, -GRAVITY);
    let Ok(efforts) = (robot.dynamics()).and_then(|dynamics| dynamics.gravity(q, down)) else {
        return Vec::new();
    };
    let joints = robot.variables().iter().zip(&efforts);
    let heavy = joints.filter(|(joint, effort)| {
        let limit = robot.joints()[joint.index()].limits.effort;
        limit.is_some_and(|limit| limit > 0.0 && effort.abs() > limit)
    });
    heavy.map(|(joint, _)| *joint).collect()
}

/// Returns where the arm may wait, the best place first.
fn list_regions(
    robot: &RobotModel,
    arm: &ArmChain,
    held: &[f64],
    place: &Place,
) -> Result<Vec<WipingRegion>, SetupError> {
    let surface = match place {
        Place::Around => return WipingRegion::around(robot, arm, held),
        Place::Below => return Ok(vec![WipingRegion::below(robot, arm, held)?]),
        Place::Known(surface) => surface,
    };
    let (at, name) = (&surface.root_from_surface, &surface.name);
    if !surface.is_driven_to {
        return Ok(vec![WipingRegion::from_surface(*at, &surface.bounds, name)]);
    }
    let around = WipingRegion::around(robot, arm, held)?;
    if (at.rotation * Vector3::z()).z < LEVEL {
        return Ok(around);
    }
    let height = at.translation.z;
    Ok((around.into_iter())
        .map(|region| region.with_height(height, name))
        .collect())
}

/// Returns the robot alone, with a stand-in for a tool at each tip, and on a table if it is an arm on one, unless it hangs.
fn scene_without_task(
    robot: &RobotModel,
    srdf: &Srdf,
    arms: &[ArmChain],
    stand_in: Option<[f64; 3]>,
    hangs: bool,
) -> Result<Scene, SetupError> {
    let (held, _) = held_posture(robot);
    let mut collisions = CollisionModel::new(robot, Some(srdf))?;
    for arm in arms {
        let tip = arm.groups.first().map(|proposed| proposed.group.tip);
        let (Some(tip), Some([x, y, z])) = (tip, stand_in) else {
            continue;
        };
        let tool = build_cuboid("tool", Vector3::new(x, y, z))?;
        let name = format!("tool of {}", arm.name);
        let axis = arm.tip_axis;
        let out = hand_extent(robot, tip, axis, &held)? + z / 2.0;
        let in_tip = axis.frame() * Pose::translation(0.0, 0.0, out);
        collisions.attach(&name, tip, in_tip, &tool)?;
        // A gripper holds the tool.
        for link in robot.carried_links(tip) {
            collisions.allow(&name, &robot.links()[link.index()].name)?;
        }
    }
    if hangs {
        let place = Place::Below;
        return Ok(Scene {
            collisions,
            held,
            place,
        });
    }
    if let Some(top) = find_table(robot, arms, &held)? {
        let [x, y, z] = TABLE;
        let table = build_cuboid("table", Vector3::new(x, y, z))?;
        let below = Pose::translation(0.0, 0.0, top - z / 2.0);
        collisions.add_obstacle("table below", below, &table)?;
    }
    Ok(Scene {
        collisions,
        held,
        place: Place::Around,
    })
}

fn build_cuboid(name: &str, size: Vector3) -> Result<Mesh, SetupError> {
    Mesh::cuboid(size).map_err(|error| {
        SetupError::Robot(RobotError::Obstacle {
            name: name.to_owned(),
            problem: error.to_string(),
        })
    })
}

/// Returns the robot with the task's tool in the task's scene, where the task puts it, and for a fixed base a trial.
fn scene_of_task<'a>(
    robot: &RobotModel,
    srdf: &Srdf,
    task: &'a LoadedTask,
) -> Result<(Scene, Option<Trial<'a>>), SetupError> {
    let config = WorkcellConfig {
        group: None,
        second_group: None,
        ..task.run.workcell.clone()
    };
    let cell = Workcell::new(robot.clone(), Some(srdf), &task.task, &config);
    let cell = cell.map_err(|error| match error {
        FollowError::Robot(error) => SetupError::Robot(error),
        other => SetupError::Robot(RobotError::Obstacle {
            name: task.task.name.clone(),
            problem: other.to_string(),
        }),
    })?;
    let surface = &task.task.surface;
    let outline = surface.outline.outer().iter().copied();
    let known = Bounds2::from_points(outline).map(|bounds| KnownSurface {
        root_from_surface: cell.world_from_root().inv_mul(&surface.world_from_surface),
        bounds,
        name: surface.name.clone(),
        is_driven_to: cell.base().is_some(),
    });
    let scene = Scene {
        collisions: cell.collisions().clone(),
        held: cell.ready_posture().to_vec(),
        place: known.map_or(Place::Around, Place::Known),
    };
    let trial = match cell.base() {
        None => Trial::new(task, config),
        Some(_) => None,
    };
    Ok((scene, trial))
}

/// Whether a joint moves the robot's base, which is that of its first group.
pub fn is_mobile(robot: &RobotModel, arms: &[ArmChain]) -> bool {
    let base = arms.first().and_then(|arm| arm.groups.first());
    base.is_some_and(|proposed| {
        let mut joints = robot.joints_above(proposed.group.base);
        joints.any(|joint| joint.kind != JointKind::Fixed)
    })
}
