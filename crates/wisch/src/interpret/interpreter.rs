//! Interpretation of a log, from its samples to what was wiped.

use super::belief::{Belief, ContactEvidence, Exposure, Replay};
use super::config::{InterpretConfig, OtherForce};
use super::contact::{
    ClassifiedPath, ContactClassifier, ContactLevels, Downsampler, FittedPlane, ForceReading,
    MeasuredPiece, MeasuredStiffness, PlaneFit, StiffnessBelief, ToolOnBend, ToolStiffness,
    TouchSample, find_early_tare, find_stiffness, interpolate_held_poses, level_leaning_tool,
    median, middle,
};
use super::doubt::Doubt;
use super::error::InterpretError;
use super::events::{Event, EventDetector};
use super::fast_turns::find_fast_turns;
use super::interpretation::{Diagnosis, Interpretation};
use super::log_evidence::{LEAST_ON_PLANE, LogEvidence};
use super::poses_alone::PosesAlone;
use super::wrench_quality::UnusableWrenches;
use crate::geometry::{PlanarPose, Point2, Point3, Pose, Region, Vector3};
use crate::represent::{
    DirtSlide, Effect, FilmFlow, GoalState, ParticleDistribution, ParticleError, Surface, Task,
};
use nalgebra::{Translation3, UnitQuaternion};
use std::borrow::Cow;

/// Time before and after a push during which the force includes the hand's [s].
const SETTLING: f64 = 0.5;
/// Largest force of an event over a lasting change of the bias that explains it [1]: the change is that of medians, and
/// the bias goes on drifting.
const BIAS_FORCE: f64 = 1.5;

/// Interpreter of a log that takes sample by sample in bounded memory, and interprets at any time what it has so far.
///
/// ```
/// use wisch::geometry::{Pose, Vector3};
/// use wisch::interpret::{Belief, Diagnosis, InterpretConfig, Interpreter, TouchSample};
/// # use wisch::geometry::*;
/// # use wisch::represent::*;
/// # let task = Task {
/// #     name: "board".into(),
/// #     action: Action::Absorb,
/// #     surface: Surface {
/// #         name: "board".into(),
/// #         outline: Polygon::rectangle(Vector2::new(0.4, 0.28)),
/// #         world_from_surface: Pose::identity(),
/// #         skim_edges: vec![],
/// #         shape: Default::default(),
/// #     },
/// #     scene: vec![],
/// #     tool: Tool {
/// #         name: "sponge".into(),
/// #         mesh: Mesh::cuboid(Vector3::new(0.07, 0.11, 0.05)).unwrap(),
/// #         footprint: Region::new(vec![Polygon::rectangle(Vector2::new(0.07, 0.11))]),
/// #         area_of_effect: Vector2::new(0.07, 0.11),
/// #         rotation_about_normal: AngleRange::FULL,
/// #         tilt: None,
/// #         mount: None,
/// #         second_grip: None,
/// #     },
/// #     medium: "breadcrumbs".into(),
/// #     mobility: DirtMobility::Unknown,
/// #     interaction: Interaction {
/// #         tool: "sponge".into(),
/// #         medium: "breadcrumbs".into(),
/// #         surface: SurfaceScope::Any,
/// #         actions: Action::ALL.into_iter().collect(),
/// #         press_force_n: 10.0,
/// #         stiffness_n_per_m: 500.0,
/// #         damping_ratio: 0.7,
/// #         nullspace_posture_weight: 0.1,
/// #         compression_depth_m: 0.005,
/// #         gap_m: 0.0,
/// #         likelihood: LogNormal { mu: -1.05, sigma: 0.25 },
/// #         likelihood_spread: LogNormalSpread::default(),
/// #         redraw: Redraw::default(),
/// #     },
/// #     particles: ParticleDistribution::new(&[Point2::new(0.0, 0.0), Point2::new(0.0, 0.1)])?,
/// #     collect_goal: None,
/// #     treatment: None,
/// #     tool_start: Point2::new(0.0, -0.3),
/// #     seed: 1,
/// # };
/// // A board with two crumbs, one of them in the path of a stroke with the task's 10 N.
/// let mut interpreter = Interpreter::new(&task, &InterpretConfig::from_task(&task))?;
/// // Before it, the tool comes down without force, which shows the bias of the sensor.
/// for i in 0..3000 {
///     let time = f64::from(i) * 1e-3;
///     let (x, height) = ((0.1 * time - 0.2).max(-0.1), (0.05 - 0.05 * time).max(0.0));
///     let force = if height > 0.0 { 0.0 } else { 10.0 };
///     interpreter.push(&TouchSample {
///         time,
///         world_from_tool: Pose::translation(x, 0.0, height),
///         force: Vector3::new(0.0, 0.0, force),
///     })?;
/// }
/// let believed = Belief::from_particles(task.particles.clone());
/// let interpretation = interpreter.conclude(&believed, &GoalState::Absorbed)?;
/// assert_eq!(interpretation.diagnosis, Diagnosis::Localized);
/// // In hardly any member of the belief is the threshold so high that the crumb stays.
/// assert!((interpretation.performance.mean - 0.5).abs() < 0.01);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Interpreter {
    surface: Surface,
    footprint: Region,
    slide: Option<DirtSlide>,
    film: Option<FilmFlow>,
    /// Largest angle by which the tool may tilt by design [rad].
    own_tilt: f64,
    config: InterpretConfig,
    downsampler: Downsampler,
    unusable: UnusableWrenches,
    poses_alone: PosesAlone,
}

impl Interpreter {
    /// Returns an interpreter for a task that has no samples yet.
    ///
    /// # Errors
    /// [`InterpretError::Config`] for a setting out of its range.
    pub fn new(task: &Task, config: &InterpretConfig) -> Result<Self, InterpretError> {
        config.check()?;
        Ok(Self {
            surface: task.surface.clone(),
            footprint: task.tool.footprint.clone(),
            slide: task.dirt_slide(),
            film: task.film_flow(),
            own_tilt: task.tool.tilt.map_or(0.0, |tilt| {
                tilt.range.min_rad.abs().max(tilt.range.max_rad.abs())
            }),
            downsampler: Downsampler::new(&task.surface, config.max_pieces),
            config: config.clone(),
            unusable: UnusableWrenches::default(),
            poses_alone: PosesAlone::default(),
        })
    }

    /// Adds one sample. A rejected sample leaves the interpreter unchanged.
    ///
    /// # Errors
    /// [`InterpretError::TimeNotIncreasing`] for a time not after that of the previous sample;
    /// [`InterpretError::Measurement`] for a value that is not finite or exceeds the range of every
    /// robot.
    pub fn push(&mut self, sample: &TouchSample) -> Result<(), InterpretError> {
        self.downsampler.push(sample)
    }

    /// Counts samples whose wrenches are not usable. They show no contact; their numbers and share
    /// are reported as a [`Doubt`].
    pub const fn skip(&mut self, unusable: UnusableWrenches) {
        self.unusable.stale += unusable.stale;
        self.unusable.saturated += unusable.saturated;
        self.unusable.untared += unusable.untared;
        self.unusable.frozen_pose += unusable.frozen_pose;
        self.unusable.missing_pose += unusable.missing_pose;
    }

    /// Notes the pose of the tool in the world at a time without a force \[s\], before the first sample or after the last, in the
    /// order of the times. If the tool slid on the surface at such times, the estimate is a lower bound, and a [`Doubt`] states
    /// for how long.
    pub fn note_pose(&mut self, time: f64, world_from_tool: &Pose) {
        self.poses_alone.note(time, world_from_tool);
    }

    /// Interprets the samples so far. The result holds contacts, plane, events and doubts, and the
    /// belief about the dirt after the log, given the belief `believed` before it.
    ///
    /// A certain belief becomes an ensemble of as many members as the settings say; an ensemble is continued member by
    /// member. The result depends on samples, settings and belief only, not on the number of threads.
    ///
    /// # Errors
    /// [`InterpretError::Config`] for a goal that is not finite. Too little contact is a
    /// diagnosis and no error.
    pub fn conclude(
        &self,
        believed: &Belief,
        goal: &GoalState,
    ) -> Result<Interpretation, InterpretError> {
        if let GoalState::Collected { center, radius } = goal {
            let numbers = [
                ("goal x [m]", center.x),
                ("goal y [m]", center.y),
                ("goal radius [m]", *radius),
            ];
            if let Some((name, value)) = numbers.into_iter().find(|(_, value)| !value.is_finite()) {
                return Err(InterpretError::Config {
                    name,
                    value,
                    expected: "the finite numbers",
                });
            }
        }
        let analysis = self.analyse();
        let evidence = analysis.evidence(self);
        let prior = StiffnessBelief::prior(self.config.uncertainty.stiffness_share);
        let stiffness = (believed.stiffness().unwrap_or(prior)).update(analysis.stiffness);
        let replay = self.replay(goal.action().effect(), stiffness, &analysis);
        let belief = replay.run(believed, &evidence);
        // A certain belief stays certain if the tool touched nothing.
        let is_untouched = evidence.is_untouched() && believed.is_certain();
        let deviation = if is_untouched {
            0.0
        } else {
            self.config.uncertainty.model_share
        };
        let mut distribution = belief.performance(goal, &self.surface, deviation);
        let mut analysis = analysis;
        for doubt in &mut analysis.doubts {
            if let Doubt::PressForceDiffers { matters, .. } = doubt {
                *matters = replay.difference_by_scale(&belief, goal);
            }
        }
        let turning = find_fast_turns(&analysis.classified.path, goal.action().treats());
        analysis.doubts.extend(turning);
        if analysis.doubts.iter().any(is_misreading) {
            // Absorbed dirt and dirt off the surface do not return, even if the log does not show
            // all contacts.
            let least = if matches!(goal, GoalState::Absorbed | GoalState::Skimmed) {
                let before = believed.performance(goal, &self.surface, deviation);
                before.estimate().low
            } else {
                0.0
            };
            let share = self.config.uncertainty.misread_share;
            distribution = distribution.or_unknown(share, least);
        }
        let shift = self.shift_without_plane(&analysis);
        let LogAnalysis {
            classified,
            believed_from_real,
            events,
            contact_share,
            mut doubts,
            ..
        } = analysis;
        if let Some(plane) = &shift {
            let height = plane.offset;
            doubts.push(Doubt::HeightOnly { height });
        }
        let diagnosis = match &shift {
            Some(plane) => self.diagnose_shift(plane),
            None if self.is_unfitted(&classified, &doubts) => Diagnosis::Unfitted,
            None => self.diagnosis(&classified, &believed_from_real),
        };
        let plane = shift.or(classified.plane.map(|(_, described)| described));
        let is_fitted = diagnosis != Diagnosis::Unfitted;
        Ok(Interpretation {
            diagnosis,
            events,
            contact_share,
            doubts,
            force_bias: analysis.force_bias,
            pressed_force: analysis.pressed,
            tool_stiffness: self.config.stiffness().map(|declared| {
                let is_assumed = stiffness == prior;
                (analysis.found_stiffness)
                    .unwrap_or_else(|| stiffness.of_tool(declared, is_assumed))
            }),
            performance: distribution.estimate(),
            by_touch: distribution.estimate(),
            observation: None,
            distribution,
            belief,
            plane: plane.filter(|_| is_fitted),
            registration: classified.registration.filter(|_| is_fitted),
            residuals: classified.residuals,
            path: classified.path,
        })
    }

    /// Returns the exposure of dirt at `places`, in the believed surface frame \[m\], on condition
    /// that it does not respond to the tool.
    ///
    /// The result has one list per place, with one entry per guess. Each guess shifts the place by
    /// a normal error of standard deviation `deviation` along x and along y \[m\], and draws the
    /// grasp of the tool and a hypothesis about each push. The guesses depend on the settings' seed
    /// only, so they are the same for every log.
    ///
    /// # Errors
    /// A place that is not finite.
    pub fn exposures(
        &self,
        places: &[Point2],
        effect: Effect,
        deviation: f64,
        guesses: usize,
    ) -> Result<Vec<Vec<Exposure>>, ParticleError> {
        let particles = ParticleDistribution::new(places)?;
        let analysis = self.analyse();
        let evidence = analysis.evidence(self);
        let prior = StiffnessBelief::prior(self.config.uncertainty.stiffness_share);
        let replay = self.replay(effect, prior.update(analysis.stiffness), &analysis);
        Ok(replay.exposures(&particles, &evidence, deviation, guesses))
    }

    /// Classifies the pieces. If the force differs from the declared one, either the sensor has
    /// another scale, or the tool presses with another force and is compressed by another distance.
    /// The cause for which the surface is nearer to the believed one is taken, unless it is known.
    fn level(
        &self,
        measured: &[MeasuredPiece],
        reading: &ForceReading,
        reference: f64,
        known: Option<ForceCause>,
    ) -> LeveledLog {
        if let Some(known) = known {
            return LeveledLog {
                force_cause: Some(known),
                ..self.level_by(measured, reading, reference, known.cause)
            };
        }
        let by_scale = self.level_by(measured, reading, reference, OtherForce::Scale);
        let is_declared = reference == self.config.nominal_force();
        if is_declared || self.config.stiffness().is_none() {
            return by_scale;
        }
        let by_press = self.level_by(measured, reading, reference, OtherForce::Press);
        let offsets = [&by_press, &by_scale].map(|leveled| leveled.offset(&self.surface));
        let (cause, nearer) = if offsets[0] < offsets[1] {
            (OtherForce::Press, by_press)
        } else {
            (OtherForce::Scale, by_scale)
        };
        LeveledLog {
            force_cause: Some(ForceCause { cause, offsets }),
            ..nearer
        }
    }

    fn level_by(
        &self,
        measured: &[MeasuredPiece],
        reading: &ForceReading,
        reference: f64,
        cause: OtherForce,
    ) -> LeveledLog {
        let mut pieces = reading.apply(measured, &self.config);
        // The force on another patch of the mesh is no contact with this one.
        for piece in pieces.iter_mut().filter(|piece| piece.is_on_other_patch) {
            (piece.force, piece.peak_force) = (Vector3::zeros(), 0.0);
        }
        let config = &self.config.with_reference_force(reference, cause);
        let compression = config.nominal_compression();
        let tool = ToolOnBend::new(&self.surface, &self.footprint, compression, config);
        if let Some(tool) = tool {
            tool.level(&mut pieces, config);
        }
        let as_logged = self.classify(pieces, config, reference);
        let is_flat = self.surface.shape.is_plane() && self.own_tilt == 0.0;
        let plane = (as_logged.classified.plane.as_ref()).filter(|_| is_flat);
        let leveled = plane.and_then(|(fit, _)| {
            level_leaning_tool(&as_logged.pieces, &fit.normal(), &self.footprint, config)
        });
        let Some(pieces) = leveled else {
            return as_logged;
        };
        LeveledLog {
            counts_lean: true,
            ..self.classify(pieces, config, reference)
        }
    }

    /// Classifies pieces whose forces are read.
    fn classify(
        &self,
        pieces: Vec<MeasuredPiece>,
        config: &InterpretConfig,
        reference: f64,
    ) -> LeveledLog {
        let found_stiffness = find_stiffness(&pieces, &self.surface, config);
        let config = config
            .clone()
            .with_stiffness(found_stiffness.map(|found| found.n_per_m));
        let levels = ContactLevels::of(&pieces, &self.surface, middle(&self.surface), &config);
        let classified = self
            .classifier(&config, reference, levels)
            .classify(&pieces);
        LeveledLog {
            pieces,
            config,
            found_stiffness,
            levels,
            classified,
            counts_lean: false,
            force_cause: None,
        }
    }

    fn classifier<'a>(
        &'a self,
        config: &'a InterpretConfig,
        reference: f64,
        levels: Option<ContactLevels>,
    ) -> ContactClassifier<'a> {
        ContactClassifier {
            levels,
            surface: &self.surface,
            reach: self.reach(),
            config,
            most_share: (self.config.nominal_force() / reference).max(1.0),
        }
    }

    /// Analyses the log over the surface at the pose that its contacts show: a curved surface that lies elsewhere has other
    /// places below the tool.
    fn analyse(&self) -> LogAnalysis {
        let believed = self.analyse_over_surface(None);
        let pose = self.find_other_pose(&believed.classified);
        let Some(pose) = pose.filter(|_| !believed.doubts.contains(&Doubt::OtherSide)) else {
            return believed;
        };
        let moved = Self {
            surface: Surface {
                world_from_surface: self.surface.world_from_surface * pose,
                ..self.surface.clone()
            },
            downsampler: self.downsampler.with_surface_at(&pose),
            ..self.clone()
        };
        let mut analysis = moved.analyse_over_surface(believed.force_cause);
        let classified = &mut analysis.classified;
        let (Some((_, plane)), Some(fit)) = (&mut classified.plane, &mut classified.registration)
        else {
            return believed;
        };
        fit.believed_from_real = pose * fit.believed_from_real;
        *plane = self.describe_pose(plane, &fit.believed_from_real);
        classified.is_moved = believed.classified.is_moved;
        analysis
    }

    /// Returns the pose of a curved surface in the frame of the believed one, if its contacts show that it lies elsewhere.
    fn find_other_pose(&self, classified: &ClassifiedPath) -> Option<Pose> {
        let registration = classified.registration.as_ref()?;
        let (_, plane) = classified.plane.as_ref()?;
        let is_elsewhere = classified.is_moved || !self.is_here(plane, classified);
        is_elsewhere.then_some(registration.believed_from_real)
    }

    /// Describes a plane on the chart of the surface at this pose by its height and tilt in the middle of the believed
    /// surface.
    fn describe_pose(&self, plane: &FittedPlane, believed_from_real: &Pose) -> FittedPlane {
        let shape = &self.surface.shape;
        let place = middle(&self.surface);
        let believed_from_middle = shape.place(place, 0.0);
        let middle_from_real = believed_from_middle.inverse() * believed_from_real;
        let at = shape.chart(middle_from_real.inverse() * Point3::origin());
        let normal = middle_from_real.rotation * shape.orientation(at.place) * Vector3::z();
        FittedPlane {
            point: Point3::new(place.x, place.y, -at.height),
            normal,
            tilt: libm::acos(normal.z.clamp(-1.0, 1.0)),
            offset: -at.height,
            ..*plane
        }
    }

    /// Reads the forces, classifies the pieces over the surface and detects the events.
    fn analyse_over_surface(&self, known: Option<ForceCause>) -> LogAnalysis {
        let (measured, corrections) = self.correct_pieces();
        let measured = &measured[..];
        let reading = ForceReading::of(measured, &self.surface, &self.config);
        let reference = reading.reference_force(self.config.nominal_force());
        let LeveledLog {
            pieces,
            config,
            found_stiffness,
            levels,
            classified,
            counts_lean,
            force_cause,
        } = self.level(measured, &reading, reference, known);
        let pieces = &pieces;
        let classifier = self.classifier(&config, reference, levels);
        let believed_from_real = classified
            .plane
            .as_ref()
            .map_or_else(Pose::identity, |(fit, _)| {
                believed_from_real(fit, &self.surface)
            });
        let detector = EventDetector::new(
            pieces,
            &classified,
            &self.surface,
            &self.footprint,
            reading.noise,
            &config,
        );
        let (mut events, contact_share) = (detector.events(), detector.contact_share());
        let may_be_steep = self.surface.shape.is_plane() && config.gap_m == 0.0;
        let steep = (may_be_steep && is_poor(&classified))
            .then(|| classifier.find_steep_plane(pieces))
            .flatten();
        let evidence = LogEvidence {
            levels,
            steep,
            found_stiffness,
            offsets: force_cause.map(|found| found.offsets),
            own_tilt: self.own_tilt,
            pieces,
            measured,
            reading: &reading,
            classified: &classified,
            events: &events,
            contact_share,
            surface: &self.surface,
            declared: &self.config,
            config: &config,
        };
        let mut doubts = evidence.doubts();
        self.count_sliding_without_force(&classified, &mut doubts);
        doubts.extend(corrections);
        doubts.extend(reading.moved_mass().map(|mass| Doubt::Inertia { mass }));
        // In a wrong unit of length, a tool that moves jumps.
        if !matches!(doubts[..], [Doubt::FarAway { .. }]) {
            doubts.extend(self.find_jumps());
        }
        if let Some(doubt) = self.find_unusable() {
            // Unusable wrenches explain missing contact.
            let place = if classified.plane.is_none() {
                0
            } else {
                doubts.len()
            };
            doubts.insert(place, doubt);
        }
        let may_be_misread = classified.plane.is_none() || doubts.iter().any(is_misreading);
        let is_low = (may_be_misread && config.gap_m == 0.0).then(|| evidence.is_low());
        leave_out_false_pushes(&mut events, &doubts, pieces, &reading);
        if self.config.gap_m > 0.0 {
            // A hovering tool has no contact that could begin or be lost.
            events.retain(|event| event.kind.is_by_hand());
        }
        // Landings are measured against the declared stiffness.
        let stiffness = (found_stiffness.is_none())
            .then(|| self.stiffness(&classified, &events, &config))
            .flatten();
        // Without contacts on a plane it is unknown whether the tool touched.
        let has_plane = classified.plane.is_some();
        let is_read = !doubts.contains(&Doubt::OtherSide);
        LogAnalysis {
            force_bias: (reading.has_free_motion && is_read).then(|| reading.normal_bias(measured)),
            pressed: reading.pressed.filter(|_| is_read),
            force_ratio: reference / self.config.nominal_force(),
            config,
            classified,
            force_cause,
            counts_lean,
            believed_from_real,
            events,
            contact_share: contact_share.filter(|share| is_read && (*share > 0.0 || has_plane)),
            doubts,
            stiffness,
            found_stiffness,
            is_low: is_low.unwrap_or_default(),
        }
    }

    /// Returns the pieces with interpolated poses if they were held, and without those before a tare that precedes the first
    /// contact; with the assumptions made.
    fn correct_pieces(&self) -> (Cow<'_, [MeasuredPiece]>, Vec<Doubt>) {
        let mut pieces = Cow::Borrowed(self.downsampler.pieces());
        let mut doubts = Vec::new();
        if let Some((interpolated, period)) = interpolate_held_poses(&pieces) {
            pieces = Cow::Owned(interpolated);
            doubts.push(Doubt::HeldPoses { period });
        }
        if let Some(tare) = find_early_tare(&pieces, &self.config) {
            pieces = Cow::Owned(pieces[tare.pieces..].to_vec());
            let (time, change) = (tare.time, tare.change);
            doubts.push(Doubt::TaredEarly { time, change });
        }
        (pieces, doubts)
    }

    /// Adds the time in which the tool slid on the surface without a force to the doubt about an incomplete log.
    fn count_sliding_without_force(&self, classified: &ClassifiedPath, doubts: &mut Vec<Doubt>) {
        let Some(time) = self.poses_alone.time_on(&self.surface, classified) else {
            return;
        };
        let known = doubts.iter_mut().find_map(|doubt| match doubt {
            Doubt::Incomplete { missing, .. } => Some(missing),
            _ => None,
        });
        match known {
            Some(missing) => *missing += time,
            None => doubts.push(Doubt::Incomplete {
                begins: false,
                ends: false,
                missing: time,
            }),
        }
    }

    fn find_unusable(&self) -> Option<Doubt> {
        let count = self.unusable.count();
        let all = count + self.downsampler.sample_count();
        (count > 0).then(|| Doubt::UnusableWrench {
            unusable: self.unusable,
            share: count as f64 / all as f64,
        })
    }

    fn find_jumps(&self) -> Option<Doubt> {
        let jumps = self.downsampler.jumps();
        let all = jumps.left_out + self.downsampler.sample_count();
        let is_some = jumps.left_out + jumps.lasting > 0;
        jumps
            .first
            .filter(|_| is_some)
            .map(|first| Doubt::PoseJumps {
                left_out: jumps.left_out,
                share: jumps.left_out as f64 / all as f64,
                lasting: jumps.lasting,
                first,
            })
    }

    /// Measures the tool's stiffness from the pieces in which the whole tool is on the surface and nobody pushes it.
    fn stiffness(
        &self,
        classified: &ClassifiedPath,
        events: &[Event],
        config: &InterpretConfig,
    ) -> Option<MeasuredStiffness> {
        classified.plane.as_ref()?;
        let path = &classified.path;
        let corners = self.footprint.bounds()?.corners();
        let is_carried = |i: usize| {
            let tool = PlanarPose::new(path[i].position.xy(), path[i].heading);
            (corners.iter()).all(|&corner| self.surface.outline.contains(tool.transform(corner)))
        };
        let is_pushed = |i: usize| {
            let time = path[i].time;
            (events.iter().filter(|event| event.kind.is_by_hand()))
                .any(|push| time[1] > push.start - SETTLING && time[0] < push.end + SETTLING)
        };
        MeasuredStiffness::of(
            path,
            config.nominal_force(),
            config.nominal_compression(),
            |i| is_carried(i) && !is_pushed(i),
        )
    }

    fn replay(
        &self,
        effect: Effect,
        stiffness: StiffnessBelief,
        analysis: &LogAnalysis,
    ) -> Replay<'_> {
        Replay {
            force_ratio: analysis.force_ratio,
            footprint: &self.footprint,
            slide: self.slide.as_ref(),
            film: self.film.as_ref(),
            span: analysis.span(),
            effect,
            surface: &self.surface,
            config: &self.config,
            stiffness,
        }
    }

    /// Largest distance of the footprint from the tool centre point [m].
    fn reach(&self) -> f64 {
        let corners = self.footprint.edges().map(|edge| edge.start.coords.norm());
        corners.fold(0.0, f64::max)
    }

    /// Returns the believed plane at the median height of the contacts, if they lie on another shape and most of them on no
    /// plane. The plane through the others then says nothing about the pose of the surface.
    fn shift_without_plane(&self, analysis: &LogAnalysis) -> Option<FittedPlane> {
        let (fit, plane) = analysis.classified.plane.as_ref()?;
        if !self.surface.shape.is_plane() || !is_scattered(&analysis.doubts) {
            return None;
        }
        let heights = (analysis.classified.path.iter())
            .filter(|piece| piece.normalized_force >= self.config.confident_share)
            .map(|piece| {
                (
                    fit.height_at(piece.position.coords.xy()) + piece.height,
                    1.0,
                )
            })
            .filter(|(height, _)| height.abs() <= self.config.search_height_m);
        let offset = median(heights.collect());
        Some(FittedPlane {
            point: Point3::new(plane.point.x, plane.point.y, offset),
            normal: Vector3::z(),
            tilt: 0.0,
            offset,
            ..*plane
        })
    }

    /// Whether contacts lie on a curved surface at no pose, or on its other side: their height over it then means nothing.
    fn is_unfitted(&self, classified: &ClassifiedPath, doubts: &[Doubt]) -> bool {
        let is_elsewhere = !self.surface.shape.is_plane()
            && classified.plane.is_some()
            && (classified.registration.is_none() || is_scattered(doubts));
        is_elsewhere || doubts.contains(&Doubt::OtherSide)
    }

    /// Returns the diagnosis for a surface of which only the height is known.
    fn diagnose_shift(&self, plane: &FittedPlane) -> Diagnosis {
        if plane.offset.abs() < self.config.relocalize_offset_m {
            return Diagnosis::Localized;
        }
        let shift = Pose::translation(0.0, 0.0, plane.offset);
        Diagnosis::Relocalize {
            world_from_surface: self.surface.world_from_surface * shift,
        }
    }

    /// Whether the surface is where it was believed to be.
    fn is_here(&self, plane: &FittedPlane, classified: &ClassifiedPath) -> bool {
        // In the chart, a yawed surface is no tilted plane.
        let is_turned = (classified.registration.as_ref()).is_some_and(|registration| {
            classified.is_moved
                && registration.believed_from_real.rotation.angle() >= self.config.relocalize_tilt
        });
        plane.tilt < self.config.relocalize_tilt
            && plane.offset.abs() < self.config.relocalize_offset_m
            && !is_turned
    }

    fn diagnosis(&self, classified: &ClassifiedPath, believed_from_real: &Pose) -> Diagnosis {
        match &classified.plane {
            None if self.config.gap_m > 0.0 => Diagnosis::Hovering,
            None => Diagnosis::NoContact,
            Some((_, plane)) if self.is_here(plane, classified) => Diagnosis::Localized,
            Some(_) => Diagnosis::Relocalize {
                world_from_surface: self.surface.world_from_surface
                    * (classified.registration.as_ref())
                        .map_or(*believed_from_real, |fit| fit.believed_from_real),
            },
        }
    }
}

/// What the samples show before they are replayed.
struct LogAnalysis {
    /// Bias of the sensor along the normal [N]; `None` if it is unknown.
    force_bias: Option<f64>,
    /// Force with which the tool pressed for most of the time [N].
    pressed: Option<f64>,
    /// Nominal force of this log over the declared one [1].
    force_ratio: f64,
    /// The settings with the log's own nominal force.
    config: InterpretConfig,
    classified: ClassifiedPath,
    force_cause: Option<ForceCause>,
    /// Whether the heights are those of a tool that lies flat, although it leans.
    counts_lean: bool,
    believed_from_real: Pose,
    events: Vec<Event>,
    contact_share: Option<f64>,
    doubts: Vec<Doubt>,
    stiffness: Option<MeasuredStiffness>,
    /// Stiffness of the tool that the heights of the contacts show, if it is not the declared one.
    found_stiffness: Option<ToolStiffness>,
    /// Pieces at which the tool was low enough to touch, if no contact was found or the log may be misread; empty
    /// otherwise.
    is_low: Vec<bool>,
}

impl LogAnalysis {
    /// Times of the first and the last piece of the path [s].
    fn span(&self) -> [f64; 2] {
        let path = &self.classified.path;
        let [begin, end] = [path.first(), path.last()];
        [
            begin.map_or(0.0, |piece| piece.time[0]),
            end.map_or(0.0, |piece| piece.time[1]),
        ]
    }

    fn evidence<'a>(&'a self, interpreter: &'a Interpreter) -> ContactEvidence<'a> {
        // Without a plane, only the force indicates contact.
        let trusted: &[Event] = if self.classified.plane.is_some() {
            &self.events
        } else {
            &[]
        };
        ContactEvidence::new(
            &self.classified.path,
            trusted,
            interpreter.footprint.bounds(),
            self.believed_from_real.inverse(),
            &self.config,
        )
        .or_low(&self.is_low, self.classified.plane.is_some())
        .with_leveled_heights(self.counts_lean)
    }
}

/// The pieces of a log by one cause of a force that differs from the declared one.
struct LeveledLog {
    pieces: Vec<MeasuredPiece>,
    config: InterpretConfig,
    found_stiffness: Option<ToolStiffness>,
    levels: Option<ContactLevels>,
    classified: ClassifiedPath,
    /// Whether the heights are those of a tool that lies flat, although it leans.
    counts_lean: bool,
    /// `None` for the declared force.
    force_cause: Option<ForceCause>,
}

/// Why the force of a log differs from the declared one.
#[derive(Debug, Clone, Copy)]
struct ForceCause {
    cause: OtherForce,
    /// Distances of the surface from where it is believed to be, if the tool pressed with the force of the log, and if this
    /// force has a wrong scale [m].
    offsets: [f64; 2],
}

impl LeveledLog {
    /// Largest distance between the corners of the believed surface and the plane found [m]; infinite without a plane.
    fn offset(&self, surface: &Surface) -> f64 {
        let Some((fit, _)) = &self.classified.plane else {
            return f64::INFINITY;
        };
        let corners = surface.outline.outer().iter();
        let distances = corners.map(|corner| fit.height_at(corner.coords).abs());
        distances.fold(0.0, f64::max)
    }
}

/// Returns the frame of the real surface: the believed one, rotated by the least angle and shifted along its normal so
/// that the middle of the surface lies on the plane.
fn believed_from_real(fit: &PlaneFit, surface: &Surface) -> Pose {
    let middle = middle(surface).coords;
    let turn = UnitQuaternion::rotation_between(&Vector3::z(), &fit.normal())
        .unwrap_or_else(UnitQuaternion::identity);
    let there = Vector3::new(middle.x, middle.y, fit.height_at(middle));
    let back = Vector3::new(-middle.x, -middle.y, 0.0);
    Translation3::from(there) * turn * Translation3::from(back)
}

/// Interprets a whole log: [`Interpreter`] in one call.
///
/// # Errors
/// As [`Interpreter::new`], [`Interpreter::push`] and [`Interpreter::conclude`].
///
/// ```
/// # use wisch::prelude::*;
/// # let outline = Polygon::rectangle(Vector2::new(0.4, 0.3));
/// # let surface = Surface::new("tray", outline, Pose::identity());
/// # let sponge = Tool::pad("sponge", Vector3::new(0.07, 0.11, 0.05))?;
/// # let crumbs = ParticleDistribution::new(&[Point2::new(0.0, 0.0), Point2::new(0.0, 0.12)])?;
/// # let task = Task::new(Action::Absorb, surface, sponge, "crumbs", crumbs);
/// use wisch::interpret::{Diagnosis, InterpretConfig};
/// use wisch::represent::GoalState;
/// // A stroke along x over the middle of the tray, at 0.1 m/s with the task's 10 N.
/// let samples: Vec<TouchSample> = (0..2000)
///     .map(|i| f64::from(i) * 1e-3)
///     .map(|time| TouchSample::new(time, Pose::translation(0.1 * time - 0.1, 0.0, 0.0), Vector3::new(0.0, 0.0, 10.0)))
///     .collect();
/// let believed = Belief::from_particles(task.particles.clone());
/// let config = InterpretConfig::from_task(&task);
/// let interpretation = interpret(&samples, &task, &believed, &GoalState::Absorbed, &config)?;
/// assert_eq!(interpretation.diagnosis, Diagnosis::Localized);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn interpret<'a>(
    samples: impl IntoIterator<Item = &'a TouchSample>,
    task: &Task,
    believed: &Belief,
    goal: &GoalState,
    config: &InterpretConfig,
) -> Result<Interpretation, InterpretError> {
    let mut interpreter = Interpreter::new(task, config)?;
    for sample in samples {
        interpreter.push(sample)?;
    }
    interpreter.conclude(believed, goal)
}

/// Whether the contacts lie on another shape, and most of them on no plane.
fn is_scattered(doubts: &[Doubt]) -> bool {
    doubts.iter().any(Doubt::is_other_shape)
        && (doubts.iter()).any(|doubt| matches!(doubt, Doubt::Scattered { .. }))
}

/// Whether a doubt leaves open what the tool touched. Members of the belief that differ in the scale of the force already
/// cover a doubtful press force.
fn is_misreading(doubt: &Doubt) -> bool {
    doubt.is_decisive() && !matches!(doubt, Doubt::PressForceDiffers { .. })
}

/// Whether a plane holds few of the confident contacts.
fn is_poor(classified: &ClassifiedPath) -> bool {
    (classified.plane.as_ref())
        .is_none_or(|(_, plane)| (plane.inliers as f64) < LEAST_ON_PLANE * plane.confident as f64)
}

/// Removes the pushes that another surface or a lasting change of the bias explains, and all events on the other side of the
/// surface.
fn leave_out_false_pushes(
    events: &mut Vec<Event>,
    doubts: &[Doubt],
    pieces: &[MeasuredPiece],
    reading: &ForceReading,
) {
    if doubts.contains(&Doubt::OtherSide) {
        events.retain(|event| event.kind.is_phase());
    }
    let is_held = |doubt: &Doubt| matches!(doubt, Doubt::HeldPoses { .. }) && doubt.is_decisive();
    if doubts
        .iter()
        .any(|doubt| doubt.is_other_surface() || is_held(doubt))
    {
        // A force off the plane is a contact with another surface, not the force of a hand.
        events.retain(|event| !event.kind.is_by_hand());
    }
    if let Some(change) = reading.bias_change.filter(|change| change.persists) {
        let most = BIAS_FORCE * change.size;
        events.retain(|event| !event.kind.is_by_hand() || median_force(pieces, event) > most);
    }
}

/// Median size of the force during an event [N].
fn median_force(pieces: &[MeasuredPiece], event: &Event) -> f64 {
    let during = |piece: &&MeasuredPiece| piece.time[1] > event.start && piece.time[0] < event.end;
    let forces = pieces.iter().filter(during);
    let forces = forces.map(|piece| (piece.force.norm(), piece.time[1] - piece.time[0]));
    median(forces.collect())
}
