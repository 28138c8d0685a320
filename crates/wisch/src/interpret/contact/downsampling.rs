//! Reduction of a log to pieces, in memory that is bounded for any length and sampling rate.

use super::path::TouchSample;
use super::registration::in_space;
use crate::geometry::{Point3, Pose, Vector3, wrap_angle};
use crate::interpret::error::InterpretError;
use crate::represent::{Surface, SurfaceShape};
use nalgebra::UnitQuaternion;
use std::collections::VecDeque;

/// Longest duration of a piece [s]; events are resolved to a fraction of 50 ms.
const MAX_DURATION: f64 = 0.01;
/// Longest travel within a piece [m]; below the inlier distance of the plane.
const MAX_TRAVEL: f64 = 1e-3;
/// Largest rotation within a piece [rad]; 2°, at which the corner of a sponge moves by 2 mm.
const MAX_TURN: f64 = 0.035;
/// Tolerance for times that are multiples of a sampling period and not exact in binary [s].
const TIME_SLACK: f64 = 1e-6;

/// Greatest speed of a tool [m/s], and least distance of a jump [m]: a faster motion over a longer
/// distance is an error of the pose.
const FASTEST: f64 = 10.0;
const LEAST_JUMP: f64 = 0.02;
/// Time over which speeds are compared at high rates [s].
const SPEED_TIME: f64 = 0.01;
/// Longest duration of a wrong pose that is left out; a pose that lasts longer is accepted [s].
const LONGEST_GLITCH: f64 = 0.1;

/// Largest height of the tool over another patch of the mesh that it touches [m].
const ON_PATCH: f64 = 0.02;

/// Largest valid coordinate [m].
const MAX_POSITION: f64 = 1e4;
/// Largest valid force [N].
const MAX_FORCE: f64 = 1e6;
/// Largest valid time [s]: seconds since 1970 fit and still resolve a microsecond.
const MAX_TIME: f64 = 1e10;

/// Consecutive samples merged into a piece, as measured, in the chart of the believed surface: places are those of the
/// chart, heights those along its normal, and directions in the axes that its frame has at the place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::interpret) struct MeasuredPiece {
    /// Time of the first and of the last sample [s].
    pub(in crate::interpret) time: [f64; 2],
    /// Number of samples.
    pub(in crate::interpret) samples: u32,
    /// Tool centre point at the last sample [m].
    pub(in crate::interpret) position: Point3,
    /// Mean height of the tool centre point over the believed surface [m].
    pub(in crate::interpret) mean_height: f64,
    /// Yaw at the last sample [rad].
    pub(in crate::interpret) heading: f64,
    /// Orientation of the tool at the last sample.
    pub(in crate::interpret) surface_from_tool: UnitQuaternion<f64>,
    /// Turn of these axes from those at the chart's origin; `None` for a plane.
    pub(in crate::interpret) turn: Option<UnitQuaternion<f64>>,
    /// Whether the tool touches another patch of the divided mesh, beyond the chart of this one.
    pub(in crate::interpret) is_on_other_patch: bool,
    /// Mean force of the environment on the tool [N].
    pub(in crate::interpret) force: Vector3,
    /// Largest absolute force [N].
    pub(in crate::interpret) peak_force: f64,
}

impl MeasuredPiece {
    /// Returns the piece in the chart of the surface at another pose, which is given in the frame of the believed surface.
    pub(in crate::interpret) fn in_chart_at(&self, pose: &Pose, shape: &SurfaceShape) -> Self {
        let back = pose.inverse();
        let chart_at = |height: f64| {
            let point = Point3::new(self.position.x, self.position.y, height);
            shape.chart(back * in_space(shape, &point))
        };
        let at = chart_at(self.position.z);
        let turn = shape.orientation(at.place);
        let turned = turn.inverse() * back.rotation * self.turn.unwrap_or_default();
        let surface_from_tool = turned * self.surface_from_tool;
        Self {
            position: Point3::new(at.place.x, at.place.y, at.height),
            mean_height: chart_at(self.mean_height).height,
            heading: heading_of(&surface_from_tool),
            surface_from_tool,
            turn: Some(turn),
            force: turned * self.force,
            ..*self
        }
    }
}

/// Yaw of a tool with this orientation [rad].
fn heading_of(surface_from_tool: &UnitQuaternion<f64>) -> f64 {
    let axis = surface_from_tool * Vector3::x();
    libm::atan2(axis.y, axis.x)
}

/// Jumps of the pose, faster than any tool moves.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(in crate::interpret) struct PoseJumps {
    /// Number of samples that were left out, because the pose jumped there and back.
    pub(in crate::interpret) left_out: usize,
    /// Number of jumps after which the pose did not return, or that took several samples.
    pub(in crate::interpret) lasting: usize,
    /// Time [s] and distance [m] of the first jump.
    pub(in crate::interpret) first: Option<(f64, f64)>,
}

/// Reduces samples to pieces as they arrive.
#[derive(Debug, Clone)]
pub(in crate::interpret) struct Downsampler {
    surface: Surface,
    surface_from_world: Pose,
    /// Pieces so far; the last one still grows.
    pieces: Vec<MeasuredPiece>,
    /// Position [m] and yaw [rad] at the beginning of the last piece.
    began: (Point3, f64),
    /// Factor by which the limits of a piece have grown.
    coarseness: f64,
    max_pieces: usize,
    /// Number of samples that were taken, and of all that were pushed.
    samples: usize,
    pushed: usize,
    /// Last samples that were taken, over [`SPEED_TIME`].
    recent: VecDeque<TouchSample>,
    /// Samples after a jump, which are taken if the pose stays there.
    jumped: Vec<TouchSample>,
    jumps: PoseJumps,
}

impl Downsampler {
    pub(in crate::interpret) fn new(surface: &Surface, max_pieces: usize) -> Self {
        Self {
            surface_from_world: surface.world_from_surface.inverse(),
            surface: surface.clone(),
            pieces: Vec::new(),
            began: (Point3::origin(), 0.0),
            coarseness: 1.0,
            max_pieces,
            samples: 0,
            pushed: 0,
            recent: VecDeque::new(),
            jumped: Vec::new(),
            jumps: PoseJumps::default(),
        }
    }

    /// Returns the pieces so far over the surface at another pose, which is given in the frame of the believed surface.
    pub(in crate::interpret) fn with_surface_at(&self, pose: &Pose) -> Self {
        let mut surface = self.surface.clone();
        surface.world_from_surface *= *pose;
        let pieces = self.pieces.iter();
        Self {
            surface_from_world: surface.world_from_surface.inverse(),
            pieces: pieces
                .map(|piece| piece.in_chart_at(pose, &surface.shape))
                .collect(),
            surface,
            ..self.clone()
        }
    }

    /// Number of samples so far.
    pub(in crate::interpret) const fn sample_count(&self) -> usize {
        self.samples
    }

    pub(in crate::interpret) fn pieces(&self) -> &[MeasuredPiece] {
        &self.pieces
    }

    /// The jumps so far. Samples after a jump from which the pose has not come back count as left out.
    pub(in crate::interpret) fn jumps(&self) -> PoseJumps {
        PoseJumps {
            left_out: self.jumps.left_out + self.jumped.len(),
            ..self.jumps
        }
    }

    /// Adds one sample; a rejected sample changes nothing. A sample that is too far from those before and after it is
    /// left out.
    pub(in crate::interpret) fn push(
        &mut self,
        sample: &TouchSample,
    ) -> Result<(), InterpretError> {
        self.check(sample)?;
        self.pushed += 1;
        let jump = self.find_jump(sample);
        let stays = self.jumped.last().is_some_and(|jumped| {
            let is_nearer = self
                .recent
                .back()
                .is_none_or(|taken| way_between(jumped, sample) < way_between(taken, sample));
            is_nearer && find_jump_between(jumped, sample).is_none()
        });
        match jump {
            _ if stays => self.follow_jump(sample),
            None => {
                self.jumps.left_out += self.jumped.len();
                self.jumped.clear();
                self.take(sample);
            }
            Some((distance, is_gradual)) => {
                self.jumps.first.get_or_insert((sample.time, distance));
                self.jumps.lasting += usize::from(is_gradual);
                self.jumps.left_out += self.jumped.len();
                self.jumped = vec![*sample];
            }
        }
        Ok(())
    }

    /// Adds a sample near those after a jump. Once the pose has remained there for longer than a
    /// glitch lasts, all of these samples are accepted.
    fn follow_jump(&mut self, sample: &TouchSample) {
        self.jumped.push(*sample);
        if sample.time - self.jumped[0].time <= LONGEST_GLITCH {
            return;
        }
        let rests = (self.pieces.windows(2)).all(|pair| pair[0].position == pair[1].position);
        if rests {
            // The poses before were wrong, such as zeros before the first measurement.
            self.jumps.left_out += self.samples;
            self.samples = 0;
            self.pieces.clear();
            self.coarseness = 1.0;
        } else {
            self.jumps.lasting += 1;
        }
        self.recent.clear();
        for sample in std::mem::take(&mut self.jumped) {
            self.take(&sample);
        }
    }

    /// Returns the distance of a sample from the last samples [m] if no tool moves over it in the time between them, and
    /// whether the pose got there gradually, so that samples of the jump were taken before.
    fn find_jump(&self, sample: &TouchSample) -> Option<(f64, bool)> {
        let from = |taken: Option<&TouchSample>| find_jump_between(taken?, sample);
        let at_once = from(self.recent.back()).map(|distance| (distance, false));
        at_once.or_else(|| Some((from(self.recent.front())?, true)))
    }

    fn take(&mut self, sample: &TouchSample) {
        self.recent.push_back(*sample);
        while (self.recent.get(1)).is_some_and(|next| sample.time - next.time >= SPEED_TIME) {
            self.recent.pop_front();
        }
        let is_on_other_patch = match &self.surface.shape {
            SurfaceShape::Mesh(mesh) => {
                let point = self.surface_from_world
                    * Point3::from(sample.world_from_tool.translation.vector);
                mesh.is_on_other_patch(point, ON_PATCH)
            }
            SurfaceShape::Plane | SurfaceShape::Cylinder { .. } | SurfaceShape::Cone(_) => false,
        };
        let (surface_from_tool, turn) = if self.surface.shape.is_plane() {
            (self.surface_from_world * sample.world_from_tool, None)
        } else {
            let tool = self.surface.chart_from_tool(&sample.world_from_tool);
            let place = tool.translation.vector.xy().into();
            (tool, Some(self.surface.shape.orientation(place)))
        };
        let force = self.surface_from_world.rotation * sample.force;
        let one = MeasuredPiece {
            time: [sample.time; 2],
            samples: 1,
            position: surface_from_tool.translation.vector.into(),
            mean_height: surface_from_tool.translation.z,
            heading: heading_of(&surface_from_tool.rotation),
            surface_from_tool: surface_from_tool.rotation,
            turn,
            is_on_other_patch,
            force: turn.map_or(force, |turn| turn.inverse() * force),
            peak_force: sample.force.norm(),
        };
        match self.pieces.last_mut() {
            Some(last) if fits(last, &one, self.began, self.coarseness) => {
                *last = join(last, &one);
            }
            _ => {
                if self.pieces.len() >= self.max_pieces {
                    self.coarsen();
                }
                self.began = (one.position, one.heading);
                self.pieces.push(one);
            }
        }
        self.samples += 1;
    }

    fn check(&self, sample: &TouchSample) -> Result<(), InterpretError> {
        let translation = &sample.world_from_tool.translation.vector;
        let rotation = &sample.world_from_tool.rotation.coords;
        let fields = [
            ("time [s]", sample.time, MAX_TIME),
            ("position x [m]", translation.x, MAX_POSITION),
            ("position y [m]", translation.y, MAX_POSITION),
            ("position z [m]", translation.z, MAX_POSITION),
            ("orientation x", rotation.x, 1.0 + 1e-3),
            ("orientation y", rotation.y, 1.0 + 1e-3),
            ("orientation z", rotation.z, 1.0 + 1e-3),
            ("orientation w", rotation.w, 1.0 + 1e-3),
            ("force x [N]", sample.force.x, MAX_FORCE),
            ("force y [N]", sample.force.y, MAX_FORCE),
            ("force z [N]", sample.force.z, MAX_FORCE),
        ];
        for (field, value, limit) in fields {
            if value.is_nan() || value.abs() > limit {
                return Err(InterpretError::Measurement {
                    sample: self.pushed,
                    field,
                    value,
                    limit,
                });
            }
        }
        match self.jumped.last().or(self.recent.back()) {
            Some(last) if sample.time <= last.time => Err(InterpretError::TimeNotIncreasing {
                sample: self.pushed,
                time: sample.time,
                previous: last.time,
            }),
            _ => Ok(()),
        }
    }

    /// Merges every two pieces into one, and doubles the limits of later pieces.
    fn coarsen(&mut self) {
        let pairs = self.pieces.chunks(2);
        self.pieces = pairs
            .map(|pair| match pair {
                [one, next] => join(one, next),
                _ => pair[0],
            })
            .collect();
        self.coarseness *= 2.0;
    }
}

fn way_between(from: &TouchSample, to: &TouchSample) -> f64 {
    let [from, to] = [from, to].map(|sample| sample.world_from_tool.translation.vector);
    (to - from).norm()
}

/// Returns the distance between two samples [m] if no tool moves over it in the time between them.
fn find_jump_between(from: &TouchSample, to: &TouchSample) -> Option<f64> {
    let distance = way_between(from, to);
    (distance > LEAST_JUMP.max(FASTEST * (to.time - from.time))).then_some(distance)
}

/// Whether a sample still belongs to the last piece.
fn fits(
    piece: &MeasuredPiece,
    sample: &MeasuredPiece,
    began: (Point3, f64),
    coarseness: f64,
) -> bool {
    let (position, heading) = began;
    sample.time[1] - piece.time[0] < MAX_DURATION * coarseness - TIME_SLACK
        && (sample.position - position).norm() <= MAX_TRAVEL * coarseness
        && wrap_angle(sample.heading - heading).abs() <= MAX_TURN * coarseness
}

/// Returns two consecutive pieces as one.
fn join(one: &MeasuredPiece, next: &MeasuredPiece) -> MeasuredPiece {
    let samples = one.samples.saturating_add(next.samples);
    let share = f64::from(next.samples) / f64::from(samples);
    MeasuredPiece {
        time: [one.time[0], next.time[1]],
        samples,
        position: next.position,
        mean_height: one.mean_height + (next.mean_height - one.mean_height) * share,
        heading: next.heading,
        surface_from_tool: next.surface_from_tool,
        turn: next.turn,
        is_on_other_patch: next.is_on_other_patch,
        force: one.force + (next.force - one.force) * share,
        peak_force: one.peak_force.max(next.peak_force),
    }
}
