//! Logs of wiping tools from any writer, as input for the interpreter.

use super::bag::{BagReader, FRAME_SURFACE, FRAME_WORLD, active_path};
use super::correction::Correction;
use super::error::{ReadError, ReadFault};
use super::frames::Chain;
use super::frozen::{find_frozen, find_frozen_poses, find_held_forces, shows_contact};
use super::log_files::{bytes, check_is_file, is_bag_file, list_parts, open_bag, other_recording};
use super::options::{Axes, AxesChoice, LogOptions, WrenchSign};
use super::plausibility::doubts;
use super::quantity::QuantityError;
use super::ros2::NANOSECONDS_PER_SECOND;
use super::saturated::{Saturation, find_saturated};
use super::spikes::take_out_spikes;
use super::table;
use super::track::{RawLog, pair, seconds};
use nalgebra::UnitQuaternion;
use std::path::Path;
use wisch::geometry::{Pose, Vector3};
use wisch::interpret::{TouchSample, UnusableWrenches, WrenchQuality};
use wisch::represent::{Observation, UnknownName};

/// How the axes of a force were determined.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum AxesSource {
    /// An option states them.
    Given,
    /// The log states them.
    Logged,
    /// Neither states them, so the reader assumes them.
    Assumed,
}

/// A log as input for the interpreter: poses and forces at common times.
#[derive(Debug, Clone)]
pub struct Log {
    /// Tool poses and forces in the task's world; time counts from `start`.
    pub samples: Vec<TouchSample>,
    /// Times \[s\] and poses of the tool in the task's world before the first force and after the last; empty if the forces
    /// cover the poses up to a second.
    pub poses_alone: Vec<(f64, Pose)>,
    /// Numbers of samples that are left out because their wrench is not usable.
    pub unusable: UnusableWrenches,
    /// The log's time at which the samples' time is 0 \[ns\].
    pub start: i64,
    /// Source of the poses.
    pub pose_name: String,
    /// Source of the forces.
    pub wrench_name: String,
    /// Axes in which the log states the force.
    pub axes: Axes,
    /// How these axes were determined.
    pub axes_source: AxesSource,
    /// Units and frames in which the log was read, where it does not state them or its transforms give them.
    pub conventions: Vec<String>,
    /// Name of the executed task; bags written by [`crate::BagWriter`] state it.
    pub task: Option<String>,
    /// Digest of the mesh of the surface, in hexadecimal digits; bags that `wisch run` has written on meshes state it.
    pub surface_mesh: Option<String>,
    /// Nominal press force \[N\]; bags that `wisch run` has written state it.
    pub press_force_n: Option<f64>,
    /// Number of the executed round, from 1; bags written by [`crate::BagWriter`] state it.
    pub round: Option<usize>,
    /// Camera observations of the dirt before the first sample and after the last, in the frame of the believed
    /// surface.
    pub observations: [Option<Observation>; 2],
    /// Pose of the target surface at the beginning; bags written by [`crate::BagWriter`] state it.
    pub world_from_surface: Option<Pose>,
    /// Remarks: what the reader assumed or did.
    pub remarks: Vec<String>,
    /// Begin and end of gaps longer than the interpolation limit \[s\].
    pub gaps: Vec<[f64; 2]>,
    /// Invalid poses and forces that were dropped.
    pub skipped: Vec<Skipped>,
    /// Number of poses or forces dropped because their time equals the previous one; of a table, number of rows.
    pub repeated: usize,
    /// Number of samples of the more frequent track dropped because the other track is unknown there.
    pub unpaired: usize,
    /// Whether the log is incomplete: its writer was killed or is still writing.
    pub is_unfinished: bool,
}

/// Longest time by which poses and forces may begin or end apart without a remark \[ns\].
const LONGEST_ALONE: i64 = 1_000_000_000;
/// Longest time between two measurements of the force, of a writer that repeats them, between which forces are interpolated
/// \[s\]; beyond it, the log has a sample per measurement.
const LONGEST_INTERPOLATED: f64 = 0.25;
/// Number of gaps that [`Log::describe_reading`] lists one by one.
const GAPS_SHOWN: usize = 5;

impl Log {
    /// Returns remarks for users on how the log was read, a sentence each: transforms, assumptions,
    /// samples that were left out, and gaps.
    pub fn describe_reading(&self) -> Vec<String> {
        let skipped = self.skipped.iter().map(|skipped| {
            let plural = if skipped.count == 1 { "" } else { "s" };
            format!(
                "left out: {} sample{plural}; the first: {}",
                skipped.count, skipped.first
            )
        });
        let known = self.conventions.iter().chain(&self.remarks).cloned();
        known.chain(skipped).chain(self.describe_gaps()).collect()
    }

    fn describe_gaps(&self) -> Option<String> {
        let shown: Vec<String> = (self.gaps.iter().take(GAPS_SHOWN))
            .map(|[start, end]| format!("{:.2} s at {start:.2} s", end - start))
            .collect();
        let more = match self.gaps.len().saturating_sub(GAPS_SHOWN) {
            0 => String::new(),
            more => format!(" and {more} more"),
        };
        (!shown.is_empty()).then(|| {
            format!(
                "gaps in the log: {}{more}; wiping during gaps is not counted",
                shown.join(", ")
            )
        })
    }
}

/// Invalid poses or forces that were dropped.
#[derive(Debug, Clone, PartialEq)]
pub struct Skipped {
    /// Their number.
    pub count: usize,
    /// Place and fault of the first of them.
    pub first: String,
}

impl Skipped {
    fn of_log(raw: &RawLog) -> Vec<Self> {
        let poses = Self::of(&raw.poses.first_skipped, raw.poses.skipped);
        let wrenches = Self::of(&raw.wrenches.first_skipped, raw.wrenches.skipped);
        poses.into_iter().chain(wrenches).collect()
    }

    fn of(first: &Option<(String, QuantityError)>, count: usize) -> Option<Self> {
        first.as_ref().map(|(place, error)| Self {
            count,
            first: format!("{place}: {error}"),
        })
    }
}

/// Reads a log: a bag, a folder with the parts of a bag, or a table. If the file does not exist but a bag of that name
/// is being written, reads that bag.
///
/// # Errors
/// If the file cannot be read or its contents are ambiguous; see [`ReadFault`].
///
/// ```
/// use wisch::follow::Phase;
/// use wisch::geometry::{Pose, Vector3};
/// use wisch::interpret::TouchSample;
/// use wisch::run::TelemetrySample;
/// use wisch_telemetry::{BagHead, BagWriter, LogOptions, read};
/// # let folder = tempfile::tempdir()?;
/// # let path = folder.path().join("wipe.mcap");
/// let mut bag = BagWriter::create(&path, BagHead::from_surface_pose(Pose::identity()))?;
/// for index in 0..3 {
///     let pose = Pose::translation(0.01 * f64::from(index), 0.0, 0.0);
///     let touch = TouchSample::new(0.1 * f64::from(index), pose, Vector3::new(0.0, 0.0, 10.0));
///     bag.write(&TelemetrySample::from_touch(&touch, 0, Phase::Wipe(0)))?;
/// }
/// bag.finish()?;
/// assert_eq!(read(&path, &LogOptions::default())?.samples.len(), 3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn read(path: &Path, options: &LogOptions) -> Result<Log, ReadError> {
    let active = active_path(path);
    let path = if !path.exists() && active.exists() {
        &active
    } else {
        path
    };
    let within = |path: &Path, fault| ReadError {
        file: path.display().to_string(),
        fault,
    };
    let correction = Correction::from_options(options).map_err(|fault| within(path, fault))?;
    let parts = list_parts(path).map_err(|error| within(path, ReadFault::System(error)))?;
    for part in &parts {
        check_is_file(part).map_err(|fault| within(part, fault))?;
    }
    if let Some(kind) =
        other_recording(&parts[0]).map_err(|error| within(path, ReadFault::System(error)))?
    {
        return Err(within(path, ReadFault::OtherRecording { kind }));
    }
    let raw = if is_bag_file(&parts[0]).map_err(|error| within(path, ReadFault::System(error)))? {
        let mut reader = BagReader::new(options);
        for part in &parts {
            let read = open_bag(part).and_then(|source| reader.read(part, source));
            read.map_err(|fault| within(part, fault))?;
        }
        reader.finish()
    } else {
        bytes(path).and_then(|bytes| table::read(&bytes, options))
    };
    raw.and_then(|raw| combine(raw, correction, options))
        .map_err(|fault| within(path, fault))
}

/// Combines poses and forces in the task's world.
fn combine(
    mut raw: RawLog,
    correction: Correction,
    options: &LogOptions,
) -> Result<Log, ReadFault> {
    // A driver that states the quality of each wrench marks unusable ones itself.
    let spikes = if raw.qualities.is_empty() {
        let max_gap = options.max_gap * NANOSECONDS_PER_SECOND as f64;
        take_out_spikes(&mut raw.wrenches.entries, max_gap as i64)
    } else {
        None
    };
    let held = take_out_repetitions(&mut raw);
    let held_for = held.as_ref().map_or(0.0, |(_, period)| *period);
    let mut pairs = pair_held(&raw, held_for, options.max_gap)?;
    let first = pairs[0].0;
    let world = World::of(&raw, options)?;
    let poses = world.poses_of(&raw, options);
    let (unusable, saturated) = leave_out_unusable(&raw, &poses, &mut pairs);
    if pairs.is_empty() {
        let count = unusable.count();
        return Err(ReadFault::UnusableWrenches { count });
    }
    let sensor = Sensor::of(&raw, options)?;
    let start = raw.start.unwrap_or(first);
    let since_start = |time: i64| seconds(time.saturating_sub(start));
    let length = options.length_unit.unwrap_or(1.0);
    let force_unit = options.force_unit.unwrap_or(1.0);
    let sign = match options.sign.or(raw.sign).unwrap_or(WrenchSign::OnTool) {
        WrenchSign::OnTool => 1.0,
        WrenchSign::ByTool => -1.0,
    };
    let sample = |&(time, mut log_from_logged, force): &(i64, Pose, Vector3)| {
        log_from_logged.translation.vector *= length;
        let world_from_log = world.at(time, options)?;
        let world_from_logged = world_from_log * log_from_logged;
        let world_from_axes = match sensor.axes {
            Axes::World => UnitQuaternion::identity(),
            Axes::Log => world_from_log.rotation,
            Axes::Tool => world_from_logged.rotation,
            Axes::Surface => options.world_from_surface.rotation,
            Axes::Named => {
                let log_from_sensor = sensor.chain.as_ref()?.pose_at(time, options.max_gap)?;
                world_from_log.rotation * log_from_sensor.rotation
            }
        };
        let force = correction.remove_bias(force * force_unit) * sign;
        Some(TouchSample {
            time: since_start(time),
            world_from_tool: world_from_logged * options.logged_from_tool,
            force: correction.without_weight(world_from_axes * sensor.turned * force),
        })
    };
    let samples: Vec<TouchSample> = pairs.iter().filter_map(sample).collect();
    if samples.is_empty() {
        return Err(ReadFault::Transforms {
            limit: options.max_gap,
        });
    }
    let frequent = raw.poses.entries.len().max(raw.wrenches.entries.len());
    let remarks = raw
        .remarks
        .iter()
        .cloned()
        .chain(spikes.map(|found| found.describe(start, force_unit, options.max_gap)))
        .chain(held.map(|(remark, _)| remark))
        .chain(saturated.iter().map(|found| found.describe(force_unit)))
        .chain(raw.frames.remark_on_changes())
        .chain(correction.remarks)
        .chain(doubts(&samples, options))
        .collect();
    Ok(Log {
        start,
        remarks,
        gaps: gaps(&samples, options.max_gap.max(1.5 * held_for)),
        poses_alone: find_poses_alone(&raw, &poses)
            .map(|(time, pose)| (since_start(time), pose * options.logged_from_tool))
            .collect(),
        unpaired: frequent.saturating_sub(samples.len() + unusable.count()),
        samples,
        unusable,
        pose_name: raw.poses.name.clone(),
        wrench_name: raw.wrenches.name.clone(),
        axes: sensor.axes,
        axes_source: sensor.source,
        conventions: [raw.assumed_units.clone(), world.remark, sensor.remark]
            .into_iter()
            .flatten()
            .collect(),
        world_from_surface: surface(&raw, start),
        task: raw.task.clone(),
        surface_mesh: raw.surface_mesh.clone(),
        press_force_n: raw.press_force_n,
        round: raw.round,
        observations: raw.looks.clone(),
        repeated: raw.poses.repeated + raw.wrenches.repeated,
        skipped: Skipped::of_log(&raw),
        is_unfinished: raw.unfinished,
    })
}

/// Leaves out the samples whose wrench is not usable, or whose pose is frozen. `poses`: in the
/// world. Returns the numbers of these samples, and the saturation of the sensor.
fn leave_out_unusable(
    raw: &RawLog,
    poses: &[(i64, Pose)],
    pairs: &mut Vec<(i64, Pose, Vector3)>,
) -> (UnusableWrenches, Vec<Saturation>) {
    let mut unusable = UnusableWrenches::default();
    // A driver that states the quality of each wrench marks unusable ones itself.
    let (frozen, saturated) = if raw.qualities.is_empty() {
        let entries = &raw.wrenches.entries;
        (find_frozen(entries), find_saturated(entries))
    } else {
        (Vec::new(), Vec::new())
    };
    let covers = |intervals: &[[i64; 2]], time: i64| {
        let next = intervals.partition_point(|[_, to]| *to < time);
        intervals.get(next).is_some_and(|[from, _]| *from <= time)
    };
    let wrenches = raw.wrenches.entries.iter();
    let usable: Vec<(i64, Vector3)> = wrenches
        .filter(|(time, _)| raw.quality_at(*time).is_usable())
        .copied()
        .collect();
    let frozen_poses = find_frozen_poses(poses, &usable);
    let [from, to] = ends(&raw.poses.entries);
    let [before, after] = [
        &usable[..usable.partition_point(|(time, _)| *time < from)],
        &usable[usable.partition_point(|(time, _)| *time <= to)..],
    ];
    // Pairs have the times of the more frequent track.
    let within = usable.len() - before.len() - after.len();
    let per_force = (pairs.len() as f64 / within.max(1) as f64).max(1.0);
    for alone in [before, after] {
        let [from, to] = ends(alone);
        if to.saturating_sub(from) > LONGEST_ALONE && shows_contact(alone, &usable) {
            unusable.missing_pose += (alone.len() as f64 * per_force).round() as usize;
        }
    }
    pairs.retain(|(time, ..)| {
        let is_frozen = covers(&frozen, *time);
        let quality = match raw.quality_at(*time) {
            WrenchQuality::Ok if is_frozen => WrenchQuality::Stale,
            WrenchQuality::Ok if saturated.iter().any(|found| found.covers(*time)) => {
                WrenchQuality::Saturated
            }
            stated => stated,
        };
        unusable.add(quality);
        let has_frozen_pose = quality.is_usable() && covers(&frozen_poses, *time);
        unusable.frozen_pose += usize::from(has_frozen_pose);
        quality.is_usable() && !has_frozen_pose
    });
    (unusable, saturated)
}

/// Leaves only the first of equal forces that a writer repeats, with a remark on that and the period of the measurements \[s\].
fn take_out_repetitions(raw: &mut RawLog) -> Option<(String, f64)> {
    let (measured, period) = find_held_forces(&raw.wrenches.entries)?;
    raw.wrenches.entries = measured;
    let remark = format!(
        "{} repeats each measurement until the next one, {period:.2} s later: only the first of equal forces is used",
        raw.wrenches.name
    );
    Some((remark, period))
}

/// Returns the poses and forces at common times. `held_for`: period of forces that a writer repeats \[s\], or 0.
fn pair_held(
    raw: &RawLog,
    held_for: f64,
    max_gap: f64,
) -> Result<Vec<(i64, Pose, Vector3)>, ReadFault> {
    let is_sparse = held_for > LONGEST_INTERPOLATED;
    let longest = if is_sparse { 0.0 } else { 1.5 * held_for };
    pair(&raw.poses, &raw.wrenches, longest.max(max_gap), is_sparse)
}

/// Returns the poses before the first force and after the last, with their times \[ns\]. `poses`: in the world.
fn find_poses_alone<'a>(
    raw: &RawLog,
    poses: &'a [(i64, Pose)],
) -> impl Iterator<Item = (i64, Pose)> + 'a {
    let [from, to] = ends(&raw.wrenches.entries);
    let is_alone = move |time: i64| {
        from.saturating_sub(time) > LONGEST_ALONE || time.saturating_sub(to) > LONGEST_ALONE
    };
    let has_long = poses.iter().any(|(time, _)| is_alone(*time));
    (poses.iter().copied()).filter(move |(time, _)| has_long && (*time < from || *time > to))
}

/// Returns the first and the last time of a track, which has entries \[ns\].
fn ends<T>(entries: &[(i64, T)]) -> [i64; 2] {
    let time = |entry: Option<&(i64, T)>| entry.map_or(0, |entry| entry.0);
    [time(entries.first()), time(entries.last())]
}

/// Names the source of the transforms, for remarks.
fn transforms_in_words(raw: &RawLog) -> &'static str {
    if raw.joints.are_known() {
        "the log's transforms and the robot's joints"
    } else {
        "the log's transforms"
    }
}

/// Pose of the log's reference frame in the task's world.
struct World<'a> {
    chain: Option<Chain<'a>>,
    /// Remark on how it was determined, if by transforms or by assumption.
    remark: Option<String>,
}

impl<'a> World<'a> {
    fn of(raw: &'a RawLog, options: &'a LogOptions) -> Result<Self, ReadFault> {
        let (world, frame) = (&options.world_frame, &raw.poses.frame);
        let is_default = world == Axes::World.as_str();
        if !is_default && !raw.frames.knows(world) {
            let known = raw.frames.names();
            return Err(ReadFault::Unknown(UnknownName::new("frame", world, known)));
        }
        let chain = match options.world_from_log {
            Some(_) => None,
            None => raw.frames.between(world, frame),
        };
        let chain = chain.filter(|_| !frame.is_empty() && frame != world);
        let remark = match &chain {
            Some(_) => {
                let by = transforms_in_words(raw);
                Some(format!(
                    "poses in {frame:?} are transformed into {world:?} by {by}"
                ))
            }
            None if options.world_from_log.is_some() || frame == world => None,
            None if frame.is_empty() => Some(format!(
                "poses are read in the frame {world:?} of the task, as the log names no frame; --world-from-log states another"
            )),
            None => Some(format!(
                "poses in {frame:?} are read as if this frame were {world:?}, as no transform of the log connects them; --world-from-log states their pose"
            )),
        };
        Ok(Self { chain, remark })
    }

    /// Returns the logged poses in the world, with their times, where both are known.
    fn poses_of(&self, raw: &RawLog, options: &LogOptions) -> Vec<(i64, Pose)> {
        let length = options.length_unit.unwrap_or(1.0);
        let entries = raw.poses.entries.iter();
        let posed = entries.filter_map(|&(time, mut log_from_logged)| {
            log_from_logged.translation.vector *= length;
            Some((time, self.at(time, options)? * log_from_logged))
        });
        posed.collect()
    }

    fn at(&self, time: i64, options: &LogOptions) -> Option<Pose> {
        match &self.chain {
            Some(chain) => chain.pose_at(time, options.max_gap),
            None => Some(options.world_from_log.unwrap_or_else(Pose::identity)),
        }
    }
}

/// Axes of the forces.
struct Sensor<'a> {
    axes: Axes,
    source: AxesSource,
    /// Path from the frame of the forces to that of the poses, for [`Axes::Named`].
    chain: Option<Chain<'a>>,
    /// Rotation of the sensor in these axes.
    turned: UnitQuaternion<f64>,
    /// Remark on how they were determined, if by transforms.
    remark: Option<String>,
}

impl<'a> Sensor<'a> {
    fn of(raw: &'a RawLog, options: &'a LogOptions) -> Result<Self, ReadFault> {
        let of = |axes, source| Self {
            axes,
            source,
            chain: None,
            turned: UnitQuaternion::identity(),
            remark: None,
        };
        if let Some(turned) = options.logged_from_sensor {
            return Ok(Self {
                turned,
                ..of(Axes::Tool, AxesSource::Given)
            });
        }
        if let AxesChoice::Given(axes) = options.axes {
            return Ok(of(axes, AxesSource::Given));
        }
        let named = |name: &str| Axes::ALL.into_iter().find(|axes| axes.as_str() == name);
        if let Some(axes) = raw.axes.as_deref().and_then(named) {
            return Ok(of(axes, AxesSource::Logged));
        }
        let (frame, poses) = (raw.wrenches.frame.as_str(), raw.poses.frame.as_str());
        let by = transforms_in_words(raw);
        if frame.is_empty() {
            return Ok(of(Axes::Tool, AxesSource::Assumed));
        }
        if frame == poses {
            return Ok(of(Axes::Log, AxesSource::Logged));
        }
        // The frame whose pose is logged, and the frame of the forces.
        let logged = options.pose_frame.as_deref();
        let logged = logged.or((!raw.poses.child.is_empty()).then_some(raw.poses.child.as_str()));
        if let Some(name) = options.pose_frame.as_deref()
            && !raw.frames.knows(name)
        {
            let known = raw.frames.names();
            return Err(ReadFault::Unknown(UnknownName::new("frame", name, known)));
        }
        let rigid = |logged: &'a str| {
            let chain = raw.frames.between(logged, frame)?;
            // A chain that does not move is known at any time, even outside the log's.
            Some(chain.pose_at(i64::MIN / 2, 0.0)?.rotation)
        };
        if let Some(logged) = logged
            && let Some(turned) = rigid(logged)
        {
            return Ok(Self {
                turned,
                remark: Some(format!(
                    "forces in {frame:?} are rotated into {logged:?} by {by}"
                )),
                ..of(Axes::Tool, AxesSource::Logged)
            });
        }
        if !poses.is_empty()
            && let Some(chain) = raw.frames.between(poses, frame)
        {
            return Ok(Self {
                chain: Some(chain),
                remark: Some(format!(
                    "forces in {frame:?} are rotated into {poses:?} by {by}"
                )),
                ..of(Axes::Named, AxesSource::Logged)
            });
        }
        // If a sensor is fixed to its root frame, that root is most likely the logged frame.
        if let Some(root) = raw.frames.rigid_root(frame)
            && let Some(turned) = rigid(root)
        {
            return Ok(Self {
                turned,
                remark: Some(format!(
                    "forces in {frame:?} are rotated into {root:?}, which is assumed to be the frame whose pose is logged"
                )),
                ..of(Axes::Tool, AxesSource::Assumed)
            });
        }
        Ok(of(Axes::Tool, AxesSource::Assumed))
    }
}

/// Pose of the target surface in a log that `BagWriter` wrote.
fn surface(raw: &RawLog, time: i64) -> Option<Pose> {
    let chain = raw.frames.between(FRAME_WORLD, FRAME_SURFACE)?;
    chain.pose_at(time, f64::INFINITY)
}

/// Returns begin and end of gaps longer than `limit` [s].
fn gaps(samples: &[TouchSample], limit: f64) -> Vec<[f64; 2]> {
    let times = samples.windows(2).map(|pair| [pair[0].time, pair[1].time]);
    let steps = times.clone().map(|[start, end]| end - start);
    let mut steps: Vec<f64> = steps.collect();
    steps.sort_unstable_by(f64::total_cmp);
    let usual = steps.get(steps.len() / 2).copied().unwrap_or(0.0);
    // For a slow log, the usual period between samples is not a gap.
    let least = limit.max(UNUSUAL * usual);
    times.filter(|[start, end]| end - start > least).collect()
}

/// A gap is at least this multiple of the log's usual period [1].
const UNUSUAL: f64 = 5.0;
