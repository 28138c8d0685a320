//! Reading of a log's forces: bias, axis, scale and clock, inferred from the log itself.
//!
//! The band of (10) is relative to the nominal force. If the sensor was not zeroed, the wrench is
//! in another frame, or the press force differs, no sample lies in the band, although the tool
//! wiped as before. Geometry identifies wiping instead: the tool slides at one height over a plane,
//! and the force there differs from the force in the air above. That difference is the contact
//! force, of any size and direction.

use super::bias_change::{BiasChange, find_bias_change};
use super::clock::{ClockOffset, clock_offset};
use super::downsampling::MeasuredPiece;
use super::inertia::Inertia;
use super::plane::{PlaneFit, fit_plane};
use super::sensor::{SensorAxes, bias_and_noise, shift_forces};
use super::weighted::{median, mode, spread};
use crate::geometry::{Point3, Vector3};
use crate::interpret::config::{InterpretConfig, PlaneConfig};
use crate::represent::Surface;
use nalgebra::UnitQuaternion;

/// Time on either side over which velocities are compared [s], to separate inertial forces from bias.
const CALM_REACH: f64 = 0.05;
/// Acceleration below which the tool moves calmly [m/s²]; 0.5 N for a hand of 0.5 kg.
const CALM_ACCELERATION: f64 = 1.0;
/// Least number of pieces of free motion that show a bias.
const MIN_CALM: usize = 5;
/// Least speed of sliding along a surface [m/s], and its largest rise [1].
const SLIDING: [f64; 2] = [0.01, 0.25];
/// Largest number of planes at different heights on which a tool may slide: the surface, and planes
/// of travel in the air.
const MOST_PLANES: usize = 5;
/// Least share of the sliding points that a plane must hold [1].
const LEAST_ON_PLANE: f64 = 0.05;
/// Largest distance of a sliding tool from its plane [m]; its compression varies with the force.
const SLIDING_DISTANCE: f64 = 2e-3;
/// Least distance above a plane at which the tool is free of it [m].
const FREE_DISTANCE: f64 = 8e-3;
/// Weight of sliding beside the believed surface against sliding above it, in the search for contact [1].
const BESIDE: f64 = 1e-3;
/// Least share of the sliding above the believed surface at which contact may be read in axes other than the declared
/// ones [1].
const LEAST_OVER: f64 = 0.5;
/// Least ratio of the contact force to the spread of the force in the air [1].
const LEAST_SIGNIFICANCE: f64 = 2.0;
/// Least contact force: over the nominal one [1], and in newtons.
const LEAST_FORCE: [f64; 2] = [0.1, 0.3];
/// Largest spread of the force on the plane over its median [1]; a larger spread comes from a
/// person's hand.
const MOST_VARIATION: f64 = 0.6;
/// Least share of the time in which a tool slides with force, and of that in which it slides without, where it hovers for a
/// part of its strokes [1], and least height over the contact at which it hovers [m].
const LEAST_PART: f64 = 0.1;
const LEAST_HOVER: f64 = 5e-4;
/// Range of the contact force over the nominal one at which contact far from the believed surface is recognised [1].
const DISTANT_FORCE: std::ops::RangeInclusive<f64> = 0.5..=2.0;
/// Least cosine of the angle between contact force and normal at which the declared frame holds [1]; friction of rubber
/// tilts the force by 40° at most.
const LEAST_ALIGNED: f64 = 0.5;
/// Ratio of the force's variations in two frames below which the bias is constant in the first [1].
const FRAME_PREFERENCE: f64 = 0.5;
/// Least evidence for contact below another one, over that of the best [1].
const LEAST_BELOW: f64 = 0.1;
/// Least evidence for contact with shifted clocks, over that for contact at its height without a shift [1].
const CLOCK_EVIDENCE: f64 = 2.0;
/// Range of the press force over the declared force that counts as the declared force [1], and the
/// least share of the pressing time within this range: the band of (10) then holds enough samples.
const AS_DECLARED: [f64; 2] = [0.9, 1.1];
const LEAST_AS_DECLARED: f64 = 0.05;
/// Noise of single pieces over the nominal force above which forces are averaged [1], and the longest averaging time
/// [s].
const NOISE_SHARE: f64 = 0.06;
const LONGEST_MEAN: f64 = 0.3;

/// Direction of a log's contact force relative to the surface's normal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::interpret) enum PressDirection {
    /// Along the outward normal, as declared.
    Outward,
    /// Against the normal: the log holds the force of the tool on the surface.
    Inward,
    /// Along this unit direction in the axes of the tool or of the surface, as logged.
    Turned {
        /// Unit vector.
        direction: Vector3,
        /// Whether it is constant in the axes of the tool rather than in those of the surface.
        in_tool: bool,
    },
}

/// How the forces of a log are read.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::interpret) struct ForceReading {
    axes: SensorAxes,
    /// Mean force in free motion, in the sensor's axes [N].
    bias: Vector3,
    /// Rotation that aligns the contact force with the normal, after the bias is subtracted; in the sensor's axes.
    turn: UnitQuaternion<f64>,
    /// Largest force that noise produces in calm free motion [N]; infinite if there is none.
    pub(in crate::interpret) noise: f64,
    /// Direction of the contact force relative to the normal.
    pub(in crate::interpret) direction: PressDirection,
    /// Force with which the tool pressed for most of its sliding [N]; `None` if geometry shows no contact.
    pub(in crate::interpret) pressed: Option<f64>,
    /// Whether the tool pressed with the declared force for at least a part of the time.
    is_as_declared: bool,
    /// Index of the piece in the middle of the contact; 0 without contact.
    middle_of_contact: usize,
    /// Delay of the force's clock behind the position's [s]; 0 if they agree.
    pub(in crate::interpret) clock_offset: f64,
    /// Another delay that explains the log as well \[s\].
    pub(in crate::interpret) other_clock_offset: Option<f64>,
    /// Whether the log shows free motion, so that the bias is known.
    pub(in crate::interpret) has_free_motion: bool,
    /// Largest change of the bias during the log; `None` if noise explains the differences.
    pub(in crate::interpret) bias_change: Option<BiasChange>,
    /// Lowest plane near the believed surface on which the tool slid, with any force.
    pub(in crate::interpret) lowest: Option<PlaneFit>,
    /// Height over the believed surface of the plane on which the tool pressed, if contact is not searched there [m].
    pub(in crate::interpret) distant_height: Option<f64>,
    /// Inertia of the mass behind the sensor, if the forces include it.
    inertia: Option<Inertia>,
    /// Whether the tool is above the surface, by piece.
    is_clear: Vec<bool>,
}

impl ForceReading {
    /// Reads the forces of the pieces over the believed surface. Forces that inertia explains are read once more without it.
    pub(in crate::interpret) fn of(
        pieces: &[MeasuredPiece],
        surface: &Surface,
        config: &InterpretConfig,
    ) -> Self {
        let reading = Self::of_contact_forces(pieces, surface, config);
        let read = reading.apply(pieces, config);
        let Some(inertia) = Inertia::of(&read, &reading.is_clear, surface, config) else {
            return reading;
        };
        let again = if reading.clock_offset == 0.0 {
            let contact_forces: Vec<MeasuredPiece> = (pieces.iter().zip(&inertia.forces))
                .map(|(piece, force)| MeasuredPiece {
                    force: piece.force + reading.as_measured(piece, *force),
                    ..*piece
                })
                .collect();
            Self::of_contact_forces(&contact_forces, surface, config)
        } else {
            reading
        };
        Self {
            inertia: Some(inertia),
            ..again
        }
    }

    /// Reads the forces of a log as those of contact and bias alone.
    fn of_contact_forces(
        pieces: &[MeasuredPiece],
        surface: &Surface,
        config: &InterpretConfig,
    ) -> Self {
        let smooth = smooth_forces(pieces, config);
        let calm: Vec<bool> = (0..pieces.len()).map(|i| is_calm(pieces, i)).collect();
        let by_height = Self::from_height(&smooth, &calm, config);
        if config.gap_m > 0.0 {
            return by_height;
        }
        let slides: Vec<bool> = (0..pieces.len())
            .map(|i| is_sliding(pieces, i, config))
            .collect();
        // The pieces over the surface are fitted separately: a plane through both strokes and
        // travel beside the surface would be wrong.
        let over: Vec<bool> = (pieces.iter().zip(&slides))
            .map(|(piece, slides)| *slides && surface.outline.contains(piece.position.xy()))
            .collect();
        let mut planes = sliding_planes(pieces, &over, config);
        if over != slides {
            planes.extend(sliding_planes(pieces, &slides, config));
        }
        let near = |plane: &&PlaneFit| plane.height.abs() <= config.search_height_m;
        let lowest = (planes.iter().filter(near)).min_by(|a, b| a.height.total_cmp(&b.height));
        let scene = Scene {
            pieces: &smooth,
            calm: &calm,
            slides: &slides,
            surface,
            config,
        };
        let contacts = planes.iter().filter_map(|plane| {
            let contact = scene.find_contact(plane)?;
            Some((plane.height, contact))
        });
        let contact = most_plausible(contacts.collect());
        let reading = match contact {
            Some(contact) => Self::from_contact(&contact, &scene),
            None => match scene.find_distant_contact() {
                Some((height, contact)) => Self {
                    distant_height: Some(height),
                    ..Self::from_contact(&contact, &scene)
                },
                None => by_height,
            },
        };
        Self {
            lowest: lowest.copied(),
            ..reading
        }
    }

    /// Reads the forces if geometry shows no contact: the bias is the force of calm motion well above the believed
    /// surface.
    fn from_height(pieces: &[MeasuredPiece], calm: &[bool], config: &InterpretConfig) -> Self {
        // Half the nominal force at a single height is not bias: it shows a surface far above the
        // believed one.
        let is_free = |i: usize| {
            calm[i]
                && pieces[i].mean_height > config.free_height_m
                && pieces[i].force.z.abs() < 0.5 * config.nominal_force()
        };
        let free: Vec<usize> = (0..pieces.len()).filter(|&i| is_free(i)).collect();
        // A force whose bias changes leaves that range.
        let is_clear: Vec<bool> = (pieces.iter())
            .map(|piece| piece.mean_height > config.free_height_m)
            .collect();
        let high: Vec<usize> = (0..pieces.len())
            .filter(|&i| calm[i] && is_clear[i])
            .collect();
        let axes = SensorAxes::Surface;
        let known = (free.len() >= MIN_CALM).then(|| bias_and_noise(pieces, &free, axes));
        let known = known.or_else(|| find_constant_bias(pieces, &high, &is_clear, config));
        let (bias, noise) = known.unwrap_or((Vector3::zeros(), f64::INFINITY));
        Self {
            axes,
            bias,
            turn: UnitQuaternion::identity(),
            noise,
            direction: PressDirection::Outward,
            pressed: None,
            is_as_declared: true,
            middle_of_contact: 0,
            clock_offset: 0.0,
            other_clock_offset: None,
            has_free_motion: known.is_some(),
            bias_change: find_bias_change(pieces, &high, &is_clear, axes),
            lowest: None,
            distant_height: None,
            inertia: None,
            is_clear,
        }
    }

    fn from_contact(contact: &SlidingContact, scene: &Scene<'_>) -> Self {
        let pieces = shift_forces(scene.pieces, contact.clock_offset);
        let (bias, noise) = bias_and_noise(&pieces, &contact.free, contact.axes);
        let (normal, outward) = (contact.normal, contact.step.normalize());
        let aligned = outward.dot(&normal);
        // Only friction tilts a force that lies roughly along the normal, so it is not rotated.
        let (direction, turn) = if aligned >= LEAST_ALIGNED {
            (PressDirection::Outward, UnitQuaternion::identity())
        } else if aligned <= -LEAST_ALIGNED {
            (PressDirection::Inward, half_turn(&normal))
        } else {
            let direction = PressDirection::Turned {
                direction: outward,
                in_tool: contact.axes == SensorAxes::Tool,
            };
            let turn = UnitQuaternion::rotation_between(&outward, &normal);
            (direction, turn.unwrap_or_else(UnitQuaternion::identity))
        };
        let mut reading = Self {
            axes: contact.axes,
            bias,
            turn,
            noise,
            direction,
            pressed: None,
            is_as_declared: true,
            middle_of_contact: contact.on[contact.on.len() / 2],
            clock_offset: contact.clock_offset,
            other_clock_offset: contact.other_clock_offset,
            has_free_motion: true,
            bias_change: find_bias_change(&pieces, &contact.free, &contact.is_clear, contact.axes),
            lowest: None,
            distant_height: None,
            inertia: None,
            is_clear: contact.is_clear.clone(),
        };
        let least = LEAST_FORCE[0] * contact.step.norm();
        let pressing = |some: &[usize]| -> Vec<f64> {
            let forces = some
                .iter()
                .map(|&i| reading.correct_force(&pieces[i], pieces[i].force).z);
            forces.filter(|force| *force > least).collect()
        };
        let [low, high] = AS_DECLARED.map(|share| share * scene.config.nominal_force());
        let near = pressing(&contact.near);
        let as_declared = near.iter().filter(|force| (low..=high).contains(force));
        let least_count = LEAST_AS_DECLARED * near.len() as f64;
        let is_as_declared = as_declared.count() as f64 >= least_count;
        // If the force varies about the declared force, its most frequent values are the ends of
        // its range.
        let pressed = if is_as_declared && !near.is_empty() {
            Some(median(near.iter().map(|force| (*force, 1.0)).collect()))
        } else {
            mode(pressing(&contact.on))
        };
        reading.is_as_declared = is_as_declared;
        reading.pressed = pressed;
        reading
    }

    /// Returns a measured force corrected for bias, frame and sign, in the axes of the believed surface [N].
    fn correct_force(&self, piece: &MeasuredPiece, measured: Vector3) -> Vector3 {
        let force = self.axes.without_bias(piece, measured, self.bias);
        let read = if self.direction == PressDirection::Inward {
            -force
        } else {
            self.turn * force
        };
        match self.axes {
            SensorAxes::Surface => read,
            SensorAxes::Tool => self.axes.to_surface(piece, read),
        }
    }

    /// Returns a corrected force as the sensor would have measured it without bias, in the axes of the believed surface [N].
    fn as_measured(&self, piece: &MeasuredPiece, corrected: Vector3) -> Vector3 {
        if self.direction == PressDirection::Inward {
            return -corrected;
        }
        let back = self.turn.inverse();
        match self.axes {
            SensorAxes::Surface => back * corrected,
            SensorAxes::Tool => {
                let in_tool = self.axes.of(piece, corrected);
                self.axes.to_surface(piece, back * in_tool)
            }
        }
    }

    /// Returns the pieces with corrected forces.
    pub(in crate::interpret) fn apply(
        &self,
        pieces: &[MeasuredPiece],
        config: &InterpretConfig,
    ) -> Vec<MeasuredPiece> {
        let bias = self.bias.norm();
        let is_small = bias <= config.force_noise_n;
        let pieces = shift_forces(&smooth_forces(pieces, config), self.clock_offset);
        let read = pieces.iter().enumerate().map(|(i, piece)| {
            let inertial = self.inertia.as_ref().map(|inertia| inertia.forces[i]);
            let force =
                self.correct_force(piece, piece.force) + inertial.unwrap_or_else(Vector3::zeros);
            let peak_force = if is_small && inertial.is_none() {
                piece.peak_force
            } else {
                force.norm()
            };
            MeasuredPiece {
                force,
                peak_force,
                ..*piece
            }
        });
        read.collect()
    }

    /// Bias along the surface's normal in the middle of the contact, or at the first piece without contact [N].
    pub(in crate::interpret) fn normal_bias(&self, pieces: &[MeasuredPiece]) -> f64 {
        let piece = pieces.get(self.middle_of_contact);
        piece.map_or(0.0, |piece| self.axes.to_surface(piece, self.bias).z)
    }

    /// Force in free motion at the first piece, in the axes of the believed surface [N].
    pub(in crate::interpret) fn force_in_air(&self, pieces: &[MeasuredPiece]) -> Vector3 {
        (pieces.first()).map_or_else(Vector3::zeros, |first| {
            self.axes.to_surface(first, self.bias)
        })
    }

    /// Mass behind the sensor whose inertia is subtracted [kg].
    pub(in crate::interpret) fn moved_mass(&self) -> Option<f64> {
        self.inertia.as_ref().map(|inertia| inertia.mass)
    }

    /// Nominal force of this log [N]: the declared one unless the tool pressed with another.
    pub(in crate::interpret) fn reference_force(&self, declared: f64) -> f64 {
        match self.pressed {
            Some(pressed) if !self.is_as_declared => pressed,
            _ => declared,
        }
    }
}

/// Returns bias and noise of a log whose force is the same well above the surface and near it, however large; `None` if the
/// force differs. The spring of a tool has the same force at one height only.
///
/// # Parameters
/// - `high`: pieces of calm motion well above the surface.
/// - `is_clear`: whether the tool is well above the surface at each piece.
fn find_constant_bias(
    pieces: &[MeasuredPiece],
    high: &[usize],
    is_clear: &[bool],
    config: &InterpretConfig,
) -> Option<(Vector3, f64)> {
    let low: Vec<usize> = (0..pieces.len()).filter(|&i| !is_clear[i]).collect();
    if high.len().min(low.len()) < MIN_CALM {
        return None;
    }
    let axes = SensorAxes::Surface;
    let [above, below] = [high, &low].map(|some| bias_and_noise(pieces, some, axes));
    let difference = (above.0 - below.0).norm();
    let is_same = difference <= above.1.max(config.force_noise_n);
    is_same.then_some(above)
}

/// Pieces of a log, with what their motion alone shows.
#[derive(Clone, Copy)]
struct Scene<'a> {
    pieces: &'a [MeasuredPiece],
    calm: &'a [bool],
    slides: &'a [bool],
    surface: &'a Surface,
    config: &'a InterpretConfig,
}

/// A plane on which the tool slid with a force other than that above it.
struct SlidingContact {
    axes: SensorAxes,
    /// Pieces that slide on the plane.
    on: Vec<usize>,
    free: Vec<usize>,
    /// Whether the tool is clear of the plane, by piece.
    is_clear: Vec<bool>,
    /// Pieces that slide on the plane, or off it by the compression of the tool under another force.
    near: Vec<usize>,
    /// Mean force on the plane minus that above it, in the sensor's axes [N].
    step: Vector3,
    /// The believed surface's normal in the sensor's axes, averaged over the contact if these are the tool's.
    normal: Vector3,
    clock_offset: f64,
    other_clock_offset: Option<f64>,
    /// Evidence for contact: force times time [N s].
    weight: f64,
}

impl Scene<'_> {
    /// Returns the contact of the tool that slides on a plane, at all times or for a part of them.
    fn find_contact(&self, plane: &PlaneFit) -> Option<SlidingContact> {
        let distances = self.distances(plane);
        let on: Vec<usize> = (0..self.pieces.len())
            .filter(|&i| self.slides[i] && distances[i].abs() <= SLIDING_DISTANCE)
            .collect();
        let free = self.free(&distances);
        (self.examine(&distances, on.clone(), free.clone()))
            .or_else(|| self.find_partial_contact(&on, &free))
    }

    /// Returns the contact of a tool that presses for a part of its strokes, and hovers closely above for the rest. Both lie
    /// on one plane of sliding, whose force is then not steady.
    fn find_partial_contact(&self, on: &[usize], free: &[usize]) -> Option<SlidingContact> {
        if on.len() < self.config.plane.min_points || free.len() < MIN_CALM {
            return None;
        }
        let axes = SensorAxes::Surface;
        let (bias, _) = bias_and_noise(self.pieces, free, axes);
        let size = |i: usize| (axes.of(&self.pieces[i], self.pieces[i].force) - bias).norm();
        let mut sizes: Vec<f64> = on.iter().map(|&i| size(i)).collect();
        sizes.sort_unstable_by(f64::total_cmp);
        let least = 0.5 * sizes[(sizes.len() - 1) * 9 / 10];
        let is_pressed = |i: &usize| size(*i) > least;
        let points: Vec<Point3> = (on.iter().copied().filter(is_pressed))
            .map(|i| at_mean_height(&self.pieces[i]))
            .collect();
        let settings = PlaneConfig {
            inlier_distance_m: SLIDING_DISTANCE,
            ..self.config.plane.clone()
        };
        let distances = self.distances(&fit_plane(&points, &settings, self.config.seed)?);
        let near = |i: &usize| self.slides[*i] && distances[*i].abs() <= FREE_DISTANCE;
        let (pressed, hovers): (Vec<usize>, Vec<usize>) =
            (0..self.pieces.len()).filter(near).partition(is_pressed);
        let [pressing, hovering] = [&pressed, &hovers]
            .map(|some| some.iter().map(|&i| lasts(self.pieces, i)).sum::<f64>());
        let least = LEAST_PART * (pressing + hovering);
        let above = median(
            hovers
                .iter()
                .map(|&i| (distances[i], lasts(self.pieces, i)))
                .collect(),
        );
        // A tool without force is above the surface; a hand pushes wherever the tool is.
        if pressing < least || hovering < least || above < LEAST_HOVER {
            return None;
        }
        let on = pressed
            .into_iter()
            .filter(|&i| distances[i].abs() <= SLIDING_DISTANCE);
        let contact = self.examine(&distances, on.collect(), self.free(&distances))?;
        let aligned = contact.step.normalize().dot(&contact.normal);
        (aligned >= LEAST_ALIGNED).then_some(contact)
    }

    /// Returns the contact on the lowest plane on which the tool slid over the outline, with the height of that plane [m], if
    /// it is too far from the believed surface for the search.
    fn find_distant_contact(&self) -> Option<(f64, SlidingContact)> {
        let is_over = |i: usize| self.surface.outline.contains(self.pieces[i].position.xy());
        let slides: Vec<bool> = (0..self.pieces.len())
            .map(|i| moves_along(self.pieces, i) && is_over(i))
            .collect();
        let planes = sliding_planes(self.pieces, &slides, self.config);
        let plane = planes.iter().min_by(|a, b| a.height.total_cmp(&b.height))?;
        let distances = self.distances(plane);
        let is_below = (0..distances.len()).any(|i| is_over(i) && distances[i] < -FREE_DISTANCE);
        if plane.height.abs() <= self.config.search_height_m || is_below {
            return None;
        }
        let scene = Scene {
            slides: &slides,
            ..*self
        };
        let contact = scene.find_contact(plane)?;
        let ratio = contact.step.norm() / self.config.nominal_force();
        (DISTANT_FORCE.contains(&ratio)).then_some((plane.height, contact))
    }

    /// Signed distances of all pieces from a plane [m].
    fn distances(&self, plane: &PlaneFit) -> Vec<f64> {
        let pieces = self.pieces.iter();
        pieces
            .map(|piece| plane.distance(at_mean_height(piece)))
            .collect()
    }

    /// Whether a tool at a distance from the plane is clear of it.
    fn is_clear(&self, distance: f64) -> bool {
        distance > self.clear_distance()
    }

    /// Distance from the plane above which a tool is clear of it [m].
    fn clear_distance(&self) -> f64 {
        FREE_DISTANCE.max(2.0 * self.config.nominal_compression())
    }

    /// Returns the calm pieces clear of the plane with these distances [m].
    fn free(&self, distances: &[f64]) -> Vec<usize> {
        (0..self.pieces.len())
            .filter(|&i| self.calm[i] && self.is_clear(distances[i]))
            .collect()
    }

    /// Returns the contact of the pieces `on` a plane, if their force differs from that of the `free` pieces and is steady.
    /// `distances` are those from the plane [m].
    fn examine(
        &self,
        distances: &[f64],
        on: Vec<usize>,
        free: Vec<usize>,
    ) -> Option<SlidingContact> {
        if on.len() < self.config.plane.min_points || free.len() < MIN_CALM {
            return None;
        }
        let clocks = if self.config.has_one_clock {
            ClockOffset::default()
        } else {
            let low = SLIDING_DISTANCE.max(0.5 * self.config.nominal_compression());
            let limits = [low, self.clear_distance()];
            clock_offset(self.pieces, distances, limits, (&on, &free))
        };
        let pieces = shift_forces(self.pieces, clocks.delay);
        let axes = sensor_axes(&pieces, &on, &free);
        let (bias, _) = bias_and_noise(&pieces, &free, axes);
        let forces = on
            .iter()
            .map(|&i| axes.without_bias(&pieces[i], pieces[i].force, bias));
        let forces: Vec<Vector3> = forces.collect();
        let step = forces.iter().sum::<Vector3>() / forces.len() as f64;
        let size = step.norm();
        let [share, newtons] = LEAST_FORCE;
        if size < (share * self.config.nominal_force()).max(newtons) {
            return None;
        }
        // A tool that presses with another force elsewhere is compressed by another distance.
        let ratio = (size / self.config.nominal_force()).max(1.0);
        let reach = SLIDING_DISTANCE + ratio * self.config.nominal_compression();
        let near: Vec<usize> = (0..self.pieces.len())
            .filter(|&i| self.slides[i] && distances[i].abs() <= reach)
            .collect();
        let along = step / size;
        let pressing: Vec<(f64, f64)> = (on.iter().zip(&forces))
            .map(|(&i, force)| (force.dot(&along), f64::from(pieces[i].samples)))
            .collect();
        let resting: Vec<(f64, f64)> = (free.iter())
            .map(|&i| {
                let force = axes.without_bias(&pieces[i], pieces[i].force, bias);
                (force.dot(&along), f64::from(pieces[i].samples))
            })
            .collect();
        let pressed = median(pressing.clone());
        let is_steady = spread(pressing, pressed) <= MOST_VARIATION * pressed;
        let is_significant = pressed >= LEAST_SIGNIFICANCE * spread(resting, 0.0);
        let normals = on.iter().map(|&i| axes.normal(&pieces[i]));
        let normal = normals.sum::<Vector3>().normalize();
        let is_over = |i: usize| self.surface.outline.contains(pieces[i].position.xy());
        let [mut over, mut beside] = [0.0; 2];
        for &i in &on {
            *(if is_over(i) { &mut over } else { &mut beside }) += lasts(&pieces, i);
        }
        // Beside the surface, a tool also travels below it. Relative to that travel, the contact
        // force would count as free motion.
        let is_outward = along.dot(&normal) >= LEAST_ALIGNED;
        let is_possible = is_outward || over >= LEAST_OVER * (over + beside);
        (is_steady && is_significant && is_possible).then_some(SlidingContact {
            axes,
            step,
            normal,
            clock_offset: clocks.delay,
            other_clock_offset: clocks.other,
            weight: pressed * (over + BESIDE * beside),
            on,
            free,
            is_clear: distances.iter().map(|off| self.is_clear(*off)).collect(),
            near,
        })
    }
}

/// Returns the contact with the most evidence. A contact that needs shifted clocks is left out if there is contact below it
/// that needs none, or contact at its height with comparable evidence that needs none.
///
/// A tool that slides on a surface never slides below it. If strokes follow each other regularly, or there is a single one,
/// a shift of the clocks moves the forces of contact into the travel above it, which is then read as contact.
fn most_plausible(contacts: Vec<(f64, SlidingContact)>) -> Option<SlidingContact> {
    let weights = contacts.iter().map(|(_, contact)| contact.weight);
    let least = LEAST_BELOW * weights.fold(0.0, f64::max);
    let unshifted: Vec<(f64, f64)> = contacts
        .iter()
        .filter(|(_, contact)| contact.clock_offset == 0.0 && contact.weight >= least)
        .map(|(height, contact)| (*height, contact.weight))
        .collect();
    let is_doubtful = |height: f64, weight: f64| {
        unshifted.iter().any(|&(other, evidence)| {
            let is_level = other <= height + FREE_DISTANCE && weight < CLOCK_EVIDENCE * evidence;
            other + FREE_DISTANCE < height || is_level
        })
    };
    let plausible = contacts.into_iter().filter(|(height, contact)| {
        contact.clock_offset == 0.0 || !is_doubtful(*height, contact.weight)
    });
    let best = plausible.max_by(|a, b| a.1.weight.total_cmp(&b.1.weight));
    best.map(|(_, contact)| contact)
}

/// Returns the axes in which the bias is constant: those of the surface, unless the log shows a
/// bias that rotates with the tool.
///
/// Free motion decides if the tool rotates in it. Otherwise contact counts too, which also has friction.
fn sensor_axes(pieces: &[MeasuredPiece], on: &[usize], free: &[usize]) -> SensorAxes {
    let variances = |axes: SensorAxes| {
        let (bias, _) = bias_and_noise(pieces, free, axes);
        [on, free].map(|some| {
            let forces = some
                .iter()
                .map(|&i| axes.without_bias(&pieces[i], pieces[i].force, bias));
            let forces: Vec<Vector3> = forces.collect();
            let mean = forces.iter().sum::<Vector3>() / forces.len() as f64;
            let squares = forces.iter().map(|force| (force - mean).norm_squared());
            squares.sum::<f64>() / forces.len() as f64
        })
    };
    let in_tool = variances(SensorAxes::Tool);
    let in_surface = variances(SensorAxes::Surface);
    let preference = FRAME_PREFERENCE * FRAME_PREFERENCE;
    let is_in_tool = if in_surface[1] < preference * in_tool[1] {
        false
    } else {
        in_tool[1] < preference * in_surface[1]
            || in_tool.iter().sum::<f64>() < preference * in_surface.iter().sum::<f64>()
    };
    if is_in_tool {
        SensorAxes::Tool
    } else {
        SensorAxes::Surface
    }
}

/// Averages the forces over as many neighbours as their noise requires; forces with little noise
/// are not changed.
fn smooth_forces(pieces: &[MeasuredPiece], config: &InterpretConfig) -> Vec<MeasuredPiece> {
    let allowed = NOISE_SHARE * config.nominal_force();
    let steps = pieces.windows(2).map(|pair| {
        let step = pair[1].force.z - pair[0].force.z;
        (step.abs(), 1.0)
    });
    // The median absolute difference of two normal values is 0.954 standard deviations of one.
    let noise = median(steps.collect()) / 0.954;
    if noise <= allowed {
        return pieces.to_vec();
    }
    let reach = ((noise / allowed).powi(2) / 2.0).ceil() as usize;
    let mean = |i: usize| {
        let time = pieces[i].time;
        let range = i.saturating_sub(reach)..(i + reach + 1).min(pieces.len());
        let near = range.filter(|&j| {
            let other = pieces[j].time;
            other[0] - time[1] <= LONGEST_MEAN / 2.0 && time[0] - other[1] <= LONGEST_MEAN / 2.0
        });
        let (sum, count) = near.fold((Vector3::zeros(), 0.0), |(sum, count), j| {
            let samples = f64::from(pieces[j].samples);
            (sum + pieces[j].force * samples, count + samples)
        });
        sum / count
    };
    (0..pieces.len())
        .map(|i| MeasuredPiece {
            force: mean(i),
            ..pieces[i]
        })
        .collect()
}

/// Returns the planes at different heights on which the tool slides, those with the most sliding first.
fn sliding_planes(
    pieces: &[MeasuredPiece],
    slides: &[bool],
    config: &InterpretConfig,
) -> Vec<PlaneFit> {
    let settings = PlaneConfig {
        inlier_distance_m: SLIDING_DISTANCE,
        min_share: 0.0,
        ..config.plane.clone()
    };
    let mut points: Vec<Point3> = (pieces.iter().zip(slides))
        .filter(|(_, slides)| **slides)
        .map(|(piece, _)| at_mean_height(piece))
        .collect();
    let least = (LEAST_ON_PLANE * points.len() as f64) as usize;
    let mut planes = Vec::new();
    while planes.len() < MOST_PLANES
        && let Some(plane) = fit_plane(&points, &settings, config.seed)
        && plane.inliers >= least
    {
        points.retain(|point| plane.distance(*point).abs() > SLIDING_DISTANCE);
        planes.push(plane);
    }
    planes
}

/// Whether the tool moves along the surface rather than towards it, within the height at which contact is searched.
pub(super) fn is_sliding(pieces: &[MeasuredPiece], i: usize, config: &InterpretConfig) -> bool {
    pieces[i].mean_height.abs() <= config.search_height_m && moves_along(pieces, i)
}

/// Whether the tool moves along the surface rather than towards it, at any height.
fn moves_along(pieces: &[MeasuredPiece], i: usize) -> bool {
    let Some([before, after]) = neighbours(pieces, i) else {
        return false;
    };
    let [before, after] = [&pieces[before], &pieces[after]];
    let way = after.position - before.position;
    let along = way.xy().norm();
    let [slowest, steepest] = SLIDING;
    along >= slowest * (after.time[1] - before.time[1]) && way.z.abs() <= steepest * along
}

/// Place of a piece at its mean height [m].
fn at_mean_height(piece: &MeasuredPiece) -> Point3 {
    Point3::new(piece.position.x, piece.position.y, piece.mean_height)
}

/// Whether the velocity before and after a piece is about the same.
fn is_calm(pieces: &[MeasuredPiece], i: usize) -> bool {
    let Some([before, after]) = neighbours(pieces, i) else {
        return false;
    };
    let [before, here, after] = [&pieces[before], &pieces[i], &pieces[after]];
    let first = here.time[1] - before.time[1];
    let second = after.time[1] - here.time[1];
    let change =
        (after.position - here.position) / second - (here.position - before.position) / first;
    change.norm() / (0.5 * (first + second)) < CALM_ACCELERATION
}

/// Returns the nearest pieces before and after a piece that are far enough away in time.
fn neighbours(pieces: &[MeasuredPiece], i: usize) -> Option<[usize; 2]> {
    let time = pieces[i].time[1];
    // Slightly less, for times that are multiples of a period and not exact in binary.
    let reach = 0.99 * CALM_REACH;
    let before = (0..i).rev().find(|&j| time - pieces[j].time[1] >= reach)?;
    let after = (i + 1..pieces.len()).find(|&j| pieces[j].time[1] - time >= reach)?;
    Some([before, after])
}

/// Duration of a piece, up to the next one [s].
fn lasts(pieces: &[MeasuredPiece], i: usize) -> f64 {
    let end = pieces
        .get(i + 1)
        .map_or(pieces[i].time[1], |next| next.time[0]);
    (end - pieces[i].time[0]).min(LONGEST_MEAN)
}

/// Returns a rotation by π about an axis perpendicular to `normal`.
fn half_turn(normal: &Vector3) -> UnitQuaternion<f64> {
    UnitQuaternion::rotation_between(&Vector3::x(), normal).map_or_else(
        UnitQuaternion::identity,
        |turn| {
            let across = nalgebra::Unit::new_normalize(turn * Vector3::y());
            UnitQuaternion::from_axis_angle(&across, std::f64::consts::PI)
        },
    )
}
