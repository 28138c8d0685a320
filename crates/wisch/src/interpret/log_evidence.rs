//! Evidence in a log that raises doubts.

use super::config::InterpretConfig;
use super::contact::{
    ClassifiedPath, ContactLevels, ContactShape, ForceReading, MeasuredPiece, PathPiece,
    PressDirection, ToolStiffness, is_inland,
};
use super::doubt::{Doubt, FAR, LONGEST_PERIOD, NEAR, fits_other_unit};
use super::events::{Event, EventKind};
use crate::geometry::{Point2, Point3};
use crate::represent::{Surface, SurfaceShape};
use std::ops::Range;

/// Least time of pressing that shows the height of a surface [s].
const LEAST_PRESSING: f64 = 0.5;
/// Largest force in free motion over the nominal force [1], its least distance from the contacts [m], and the largest share
/// of the time that may speak for the other side [1].
const FREE_FORCE: f64 = 0.2;
const FREE_DISTANCE: f64 = 8e-3;
const FEW: f64 = 0.1;
/// Least share of the time with force on other patches of the mesh that is stated [1].
const LEAST_ON_OTHER: f64 = 0.05;
/// Largest spread of the heights at which a tool presses on one surface, which may be inclined [m].
const MOST_SPREAD: f64 = 0.03;
/// Pieces with more time between them do not follow each other [s].
const LONGEST_STEP: f64 = 0.1;
/// Least share of the confident contacts that a plane must hold [1].
pub(super) const LEAST_ON_PLANE: f64 = 0.5;
/// Least share of the time on or near the surface that a wiping tool is in contact [1].
const LEAST_CONTACT: f64 = 0.3;
/// Largest share of the contact time that may lie beside the surface [1].
const MOST_BESIDE: f64 = 0.5;
/// Travel over which steady sliding is recognised [m], least force over the nominal force at each
/// of its pieces [1], and range of the mean force over the nominal force [1].
const STEADY_TRAVEL: f64 = 0.02;
const LEAST_PRESSED: f64 = 0.5;
const STEADY: std::ops::RangeInclusive<f64> = 0.85..=1.15;
/// Steepest rise of a surface against the plane [1].
const STEEPEST: f64 = 0.25;
/// Least share of its pieces that are off the plane where a tool slides off it [1].
const MOSTLY: f64 = 0.5;
/// Least friction over the normal force on the plane that is compared [1], and least part of it off the plane that a surface
/// gives [1].
const LEAST_DRAG: f64 = 0.1;
const LEAST_DRAG_SHARE: f64 = 0.5;
/// Least share of all steady sliding [1], and least travel [m], off the plane that shows a surface that is no plane.
const LEAST_STEADY_OFF: f64 = 0.1;
const LEAST_STEADY_TRAVEL: f64 = 0.04;
/// Largest share of a log that hand guiding may take [1].
const MOST_LED: f64 = 0.3;
/// Height over the lowest plane that the tool itself slid on, within which it may have touched [m].
const LOW: f64 = 5e-3;
/// Ratio of the measured press force to the declared one, in either direction, from which they count as different [1].
const OTHER_FORCE: f64 = 1.2;
/// Ratio of the tool's stiffness to the declared one, in either direction, from which they count as different [1].
const OTHER_STIFFNESS: f64 = 1.2;
/// Least f′ of a tool that presses at the beginning or the end of a log [1].
const PRESSING: f64 = 0.5;
/// Longest time between two samples within which nothing is missed [s].
const LONGEST_GAP: f64 = 1.0;
/// Shortest gap [s] of several that together may be long, how much longer it is than the usual time between samples [1], and
/// their least share of the log [1].
const SHORT_GAP: f64 = 0.2;
const UNUSUAL: f64 = 5.0;
const MANY_GAPS: f64 = 0.1;
/// Travel during a gap in the air from which the tool may have wiped in it [m].
const TRAVEL_IN_GAP: f64 = 0.02;
/// Least change of the bias over the press force that is stated [1].
const LEAST_BIAS_CHANGE: f64 = 0.2;
/// Least lean of a tool that is stated [rad]; 12°, with which a pad presses with one edge only.
const LEAST_LEAN: f64 = 12.0 * std::f64::consts::PI / 180.0;

/// Least force in the air over the press force that is stated as a weight [1], and least cosine of its angle to the vertical
/// [1].
const LEAST_LOAD: f64 = 0.2;
const VERTICAL: f64 = 0.95;
/// Standard gravity [m/s²].
const GRAVITY: f64 = 9.80665;

/// A part of the path over which the tool slid and pressed all the time.
struct SteadySlide {
    /// Numbers of its pieces in the log.
    pieces: Range<usize>,
    /// Length of its path along the surface [m].
    travel: f64,
    /// Mean normal force on the tool [N].
    force: f64,
    /// Friction over the normal force, on average [1].
    drag: f64,
    /// Height of its end over its beginning [m].
    rise: f64,
    /// Largest distance from the plane [m].
    highest: f64,
    /// Share of its pieces that are off the plane [1].
    share_off_plane: f64,
}

/// The slides of a log.
struct SteadySlides {
    /// Those off the plane.
    off: Vec<SteadySlide>,
    /// Length of those on the plane [m].
    travel_on: f64,
    /// Least friction over the normal force of a tool that slides on a surface [1]; `None` if the slides on the plane show no
    /// friction.
    least_drag: Option<f64>,
}

impl SteadySlides {
    /// Whether a hand carries the tool: it has not the friction that it has on the plane.
    fn is_carried(&self, slide: &SteadySlide) -> bool {
        self.least_drag.is_some_and(|least| slide.drag < least)
    }
}

/// Contents of a log from which its doubts are derived.
pub(super) struct LogEvidence<'a> {
    /// Pieces of the log, with their forces as read.
    pub(super) pieces: &'a [MeasuredPiece],
    /// The same pieces, with their forces as measured.
    pub(super) measured: &'a [MeasuredPiece],
    pub(super) reading: &'a ForceReading,
    pub(super) classified: &'a ClassifiedPath,
    pub(super) events: &'a [Event],
    pub(super) contact_share: Option<f64>,
    /// Planes at different heights on which the contacts lie.
    pub(super) levels: Option<ContactLevels>,
    /// Tilt of a plane that holds the contacts and is steeper than those that are searched [rad].
    pub(super) steep: Option<f64>,
    /// Stiffness of the tool that the heights of the contacts show, if it is not the declared one.
    pub(super) found_stiffness: Option<ToolStiffness>,
    /// Distances of the surface from its believed position, for the two causes of a force that
    /// differs from the declared one [m].
    pub(super) offsets: Option<[f64; 2]>,
    pub(super) surface: &'a Surface,
    /// Largest angle by which the tool may tilt by design [rad].
    pub(super) own_tilt: f64,
    /// Settings as declared.
    pub(super) declared: &'a InterpretConfig,
    /// Settings with the log's own nominal force.
    pub(super) config: &'a InterpretConfig,
}

impl LogEvidence<'_> {
    /// Returns the reasons against wiping of this surface and the assumptions made to read the log, the most likely
    /// cause first.
    pub(super) fn doubts(&self) -> Vec<Doubt> {
        let path = &self.classified.path;
        let heights = self.levels.map(|found| Doubt::SeveralHeights {
            levels: found.levels,
            contacts: found.contacts,
        });
        // A tool that slides at one of few heights is on a surface and not guided by hand.
        let led = find_hand_guiding(path, self.events).filter(|_| heights.is_none());
        let mut doubts: Vec<Doubt> = Vec::new();
        // In a wrong unit of length or a wrong frame, heights, speeds and jumps mean nothing.
        if let Some(far) = self.find_distance() {
            doubts.push(far);
            return doubts;
        }
        if self.declared.gap_m > 0.0 {
            doubts.extend(led);
            return doubts;
        }
        // Read for the believed side, the force in the air is a contact, and that of the contact a bias or a hand's.
        if let Some(side) = self.find_other_side() {
            doubts.push(side);
            return doubts;
        }
        doubts.extend(self.find_sparseness());
        doubts.extend(self.find_other_patches());
        // The force of a hand is no bias, nor is that of contact at another height.
        if led.is_none() && heights.is_none() {
            doubts.extend(self.find_bias_change());
        }
        if let Some(tilt) = self.steep.filter(|_| led.is_none() && heights.is_none()) {
            let searched = self.config.plane.cone;
            doubts.push(Doubt::TooSteep { tilt, searched });
            return doubts;
        }
        let Some((_, plane)) = &self.classified.plane else {
            // A tool that presses at one height for long is on a surface and not guided by hand.
            let searched = self.config.search_height_m;
            let distant = self.reading.distant_height;
            let far_off = distant.map(|height| Doubt::ContactFarFromSurface { height, searched });
            let far_off = far_off.or_else(|| find_distant_contact(path, self.config));
            let shape = || {
                let scatter = self.find_scatter()?;
                let curved = self.find_curvature().filter(Doubt::is_other_surface);
                Some(curved.unwrap_or(scatter))
            };
            let reason = far_off.or(heights).or(led);
            if reason.is_none() {
                doubts.extend(self.find_other_unit());
            }
            let reason = reason.or_else(shape);
            doubts.extend(reason.or_else(|| self.explain_missing_contact()));
            doubts.extend(distant.and_then(|_| self.find_load()));
            return doubts;
        };
        let has_heights = heights.is_some();
        doubts.extend(led);
        doubts.extend(heights.or_else(|| self.find_curvature()));
        if !self.reading.has_free_motion {
            doubts.push(Doubt::NoFreeMotion);
        }
        doubts.extend(self.assumptions());
        doubts.extend(self.find_lean());
        doubts.extend(self.find_gaps());
        let Sliding {
            time,
            beside,
            travel,
        } = self.sliding();
        let share = if time > 0.0 { beside / time } else { 0.0 };
        let (inliers, confident) = (plane.inliers, plane.confident);
        let radius = self.config.redraw_length_m;
        let contact_share = self.contact_share.unwrap_or(1.0);
        let all = [
            (
                !has_heights && (inliers as f64) < LEAST_ON_PLANE * confident as f64,
                Doubt::Scattered { inliers, confident },
            ),
            (
                contact_share < LEAST_CONTACT,
                Doubt::LittleContact {
                    share: contact_share,
                },
            ),
            (travel < radius, Doubt::LittleSliding { travel, radius }),
            (share > MOST_BESIDE, Doubt::ContactBesideSurface { share }),
        ];
        doubts.extend(
            all.into_iter()
                .filter(|(is_so, _)| *is_so)
                .map(|(_, doubt)| doubt),
        );
        doubts
    }

    /// Returns a doubt if the force in the air is like the weight of a tool that the sensor carries.
    fn find_load(&self) -> Option<Doubt> {
        let measured = self.reading.force_in_air(self.pieces);
        let force = measured.norm();
        let world_from_surface = self.surface.world_from_surface.rotation;
        let is_vertical = (world_from_surface * measured).z.abs() >= VERTICAL * force;
        let is_large = force >= LEAST_LOAD * self.declared.nominal_force();
        (is_large && is_vertical).then_some(Doubt::LoadInAir {
            force,
            mass: force / GRAVITY,
        })
    }

    /// Marks the pieces at which the tool was low enough to touch, for the case that its force or the shape of the surface
    /// is misread.
    pub(super) fn is_low(&self) -> Vec<bool> {
        if self.classified.plane.is_some() {
            let is_low = |piece: &PathPiece| {
                piece.height.abs() <= NEAR || piece.normalized_force >= PRESSING
            };
            return self.classified.path.iter().map(is_low).collect();
        }
        let lowest = (self.reading.lowest.as_ref()).filter(|plane| plane.height.abs() <= NEAR);
        let is_low = |piece: &MeasuredPiece| match lowest {
            Some(plane) => {
                let place = Point3::new(piece.position.x, piece.position.y, piece.mean_height);
                plane.distance(place) <= LOW
            }
            None => piece.mean_height.abs() <= NEAR,
        };
        self.pieces.iter().map(is_low).collect()
    }

    /// Returns a doubt if the tool pressed near the surface but its contacts lie on no common plane.
    fn find_scatter(&self) -> Option<Doubt> {
        let is_pressed = |piece: &&PathPiece| {
            piece.normalized_force >= self.config.confident_share
                && piece.height.abs() <= self.config.search_height_m
        };
        let confident = self.classified.path.iter().filter(is_pressed).count();
        let inliers = 0;
        (confident >= self.config.plane.min_points)
            .then_some(Doubt::Scattered { inliers, confident })
    }

    /// Returns why no contact was found: the tool stayed away, or its force shows none.
    fn explain_missing_contact(&self) -> Option<Doubt> {
        let closest = (self.pieces.iter())
            .map(|piece| piece.mean_height.abs())
            .min_by(f64::total_cmp)?;
        if closest > NEAR {
            return Some(Doubt::NeverNearSurface { closest });
        }
        let (forces, lasts) = self.near_forces();
        Some(Doubt::NoContactForce {
            closest,
            force: forces.get(forces.len() * 9 / 10).copied().unwrap_or(0.0),
            declared: self.declared.nominal_force(),
            lasts,
        })
    }

    /// Returns a doubt if the tool is too far from the surface for any robot that works there.
    fn find_distance(&self) -> Option<Doubt> {
        let mut distances: Vec<f64> = (self.pieces.iter())
            .map(|piece| piece.position.coords.norm())
            .collect();
        distances.sort_unstable_by(f64::total_cmp);
        let distance = *distances.get(distances.len() / 2)?;
        let corners = self.surface.outline.outer().iter();
        let size = corners.map(|corner| corner.coords.norm());
        let size = size.fold(0.0, f64::max);
        (distance > size + FAR).then_some(Doubt::FarAway { distance })
    }

    /// Returns a doubt if the tool pressed on other patches of the divided mesh.
    fn find_other_patches(&self) -> Option<Doubt> {
        let least = PRESSING * self.declared.nominal_force();
        let path = &self.classified.path;
        let (mut pressed, mut other) = (0.0, 0.0);
        for (i, piece) in self.measured.iter().enumerate() {
            if piece.force.norm() >= least {
                let lasts = PathPiece::duration(path, i).min(LONGEST_GAP);
                pressed += lasts;
                other += if piece.is_on_other_patch { lasts } else { 0.0 };
            }
        }
        let share = other / pressed;
        (share >= LEAST_ON_OTHER).then_some(Doubt::OnOtherPatches { share })
    }

    /// Returns a doubt if the force over the surface is that of contact on its other side, and the tool moves freely only on
    /// that side of its contacts. The axes of the tool say nothing, because z may point into the surface as well as out of it.
    fn find_other_side(&self) -> Option<Doubt> {
        // With the bias subtracted, the contacts lie where the surface is believed.
        if let Some((_, plane)) = &self.classified.plane
            && 2 * plane.inliers >= plane.confident
            && plane.offset.abs() < FREE_DISTANCE
        {
            return None;
        }
        let nominal = self.declared.nominal_force();
        let path = &self.classified.path;
        let over: Vec<(&MeasuredPiece, f64)> = (self.measured.iter().enumerate())
            .filter(|(_, piece)| self.surface.outline.contains(piece.position.xy()))
            .map(|(i, piece)| (piece, PathPiece::duration(path, i).min(LONGEST_GAP)))
            .collect();
        let time = |is_so: &dyn Fn(&MeasuredPiece) -> bool| -> f64 {
            let those = over.iter().filter(|(piece, _)| is_so(piece));
            those.map(|(_, lasts)| lasts).sum()
        };
        let is_pressed = |piece: &MeasuredPiece| piece.force.z <= -PRESSING * nominal;
        let pressed = time(&is_pressed);
        if pressed < LEAST_PRESSING
            || time(&|piece| piece.force.z >= PRESSING * nominal) > FEW * pressed
        {
            return None;
        }
        let mut heights: Vec<f64> = (over.iter())
            .filter(|(piece, _)| is_pressed(piece))
            .map(|(piece, _)| piece.mean_height)
            .collect();
        heights.sort_unstable_by(f64::total_cmp);
        let [low, high] = [1, 19].map(|part| heights[(heights.len() - 1) * part / 20]);
        // Free motion of a biased sensor has several heights.
        if self.surface.shape.is_plane() && high - low > MOST_SPREAD {
            return None;
        }
        let is_free = |piece: &MeasuredPiece| piece.force.norm() <= FREE_FORCE * nominal;
        let below = time(&|piece| is_free(piece) && piece.mean_height < low - FREE_DISTANCE);
        let above = time(&|piece| is_free(piece) && piece.mean_height > high + FREE_DISTANCE);
        (below >= LEAST_PRESSING && above <= FEW * below).then_some(Doubt::OtherSide)
    }

    /// Returns the sizes of the forces at which the tool was low enough to touch, in ascending order [N], and the time there
    /// [s].
    fn near_forces(&self) -> (Vec<f64>, f64) {
        let is_low = self.is_low();
        let path = &self.classified.path;
        let lasts = (0..path.len().min(is_low.len()))
            .filter(|&i| is_low[i])
            .map(|i| PathPiece::duration(path, i).min(LONGEST_GAP))
            .sum();
        let mut forces: Vec<f64> = (self.pieces.iter().zip(is_low))
            .filter(|(_, is_low)| *is_low)
            .map(|(piece, _)| piece.force.norm())
            .collect();
        forces.sort_unstable_by(f64::total_cmp);
        (forces, lasts)
    }

    /// Returns a doubt if the force near the surface is the declared one in another unit.
    fn find_other_unit(&self) -> Option<Doubt> {
        let (forces, _) = self.near_forces();
        let force = *forces.get(forces.len() / 2)?;
        let declared = self.declared.nominal_force();
        let is_noise = self.reading.has_free_motion && force <= self.reading.noise;
        (!is_noise && fits_other_unit(force, declared))
            .then_some(Doubt::ForceInOtherUnit { force, declared })
    }

    /// Returns a doubt if the contacts lie on a surface that is no plane.
    fn find_curvature(&self) -> Option<Doubt> {
        let mut pieces = self.pieces.to_vec();
        if let Some(fit) = &self.classified.registration {
            for piece in &mut pieces {
                *piece = piece.in_chart_at(&fit.believed_from_real, &self.surface.shape);
            }
        }
        let slides = self.divide_slides();
        // Where a hand carries the tool, it shows no shape.
        for slide in slides
            .off
            .iter()
            .rev()
            .filter(|slide| slides.is_carried(slide))
        {
            pieces.drain(slide.pieces.clone());
        }
        let shape = ContactShape::of(&pieces, self.surface, self.config);
        if !self.surface.shape.is_plane() {
            let off = shape.map(|(_, off)| off);
            let doubt = off.map(|off| Doubt::OffShape { off });
            return doubt.or_else(|| self.find_steady_contact_off_plane(&slides));
        }
        let doubt = shape.map(|(shape, off)| match shape {
            ContactShape::Cylinder {
                radius,
                axis,
                is_convex,
            } => Doubt::Curved {
                radius,
                axis,
                is_convex,
            },
            ContactShape::Arc {
                radius,
                direction,
                is_convex,
            } => Doubt::CurvedAlong {
                radius,
                direction,
                is_convex,
            },
            ContactShape::Doubly { radii, direction } => Doubt::DoublyCurved { radii, direction },
            ContactShape::Other => Doubt::NotPlanar { off },
        });
        doubt.or_else(|| self.find_steady_contact_off_plane(&slides))
    }

    /// Returns a doubt if the tool slid off the plane with the force and the friction with which it slides on it: a hand that
    /// pushes gives no such force for long, and a tool that it lifts has no friction.
    fn find_steady_contact_off_plane(&self, slides: &SteadySlides) -> Option<Doubt> {
        self.classified.plane.as_ref()?;
        let nominal = self.config.nominal_force();
        // A hand lifts the tool steeply or far, with the force that the controller keeps.
        let is_lifted = |slide: &SteadySlide| {
            let is_steep = slide.rise.abs() > STEEPEST * slide.travel;
            is_steep || slide.highest > MOST_SPREAD || slides.is_carried(slide)
        };
        let off = (slides.off.iter()).filter(|slide| STEADY.contains(&(slide.force / nominal)));
        let off: Vec<&SteadySlide> = off.filter(|slide| !is_lifted(slide)).collect();
        let travel_off: f64 = off.iter().map(|slide| slide.travel).sum();
        let least = (LEAST_STEADY_OFF * (slides.travel_on + travel_off)).max(LEAST_STEADY_TRAVEL);
        if off.is_empty() || travel_off < least {
            return None;
        }
        let path = &self.classified.path;
        let mut distances: Vec<f64> = (off.iter())
            .flat_map(|slide| slide.pieces.clone())
            .map(|i| path[i].height.abs())
            .collect();
        distances.sort_unstable_by(f64::total_cmp);
        let off = distances[(distances.len() - 1) * 9 / 10];
        Some(if self.surface.shape.is_plane() {
            Doubt::NotPlanar { off }
        } else {
            Doubt::OffShape { off }
        })
    }

    /// Divides the slides into those on the plane and those off it.
    fn divide_slides(&self) -> SteadySlides {
        let (off, on): (Vec<_>, Vec<_>) =
            (self.steady_slides().into_iter()).partition(|slide| slide.share_off_plane >= MOSTLY);
        let travel_on: f64 = on.iter().map(|slide| slide.travel).sum();
        let dragged: f64 = on.iter().map(|slide| slide.drag * slide.travel).sum();
        let has_friction = travel_on > 0.0 && dragged >= LEAST_DRAG * travel_on;
        SteadySlides {
            off,
            travel_on,
            least_drag: has_friction.then(|| LEAST_DRAG_SHARE * dragged / travel_on),
        }
    }

    /// Divides the path into pieces of a given travel over which the tool pressed all the time.
    fn steady_slides(&self) -> Vec<SteadySlide> {
        let path = &self.classified.path;
        let nominal = self.config.nominal_force();
        let is_pressed = |i: &usize| {
            self.pieces[*i].force.z >= LEAST_PRESSED * nominal
                && is_inland(path[*i].position.xy(), self.surface, self.config)
        };
        let mut slides = Vec::new();
        let mut first = 0;
        while first < path.len() {
            let pressed = (first..path.len()).take_while(is_pressed);
            let mut travel = 0.0;
            let mut last = first;
            for i in pressed {
                travel += (path[i].position - path[last].position).xy().norm();
                last = i;
                if travel >= STEADY_TRAVEL {
                    break;
                }
            }
            if travel >= STEADY_TRAVEL {
                slides.push(self.describe_slide(first..last + 1, travel));
            }
            first = last + 1;
        }
        slides
    }

    fn describe_slide(&self, pieces: Range<usize>, travel: f64) -> SteadySlide {
        let path = &self.classified.path;
        let [first, last] = [&path[pieces.start], &path[pieces.end - 1]];
        let count = pieces.len() as f64;
        let force = pieces.clone().map(|i| self.pieces[i].force.z).sum::<f64>() / count;
        let rise = last.height - first.height;
        // By steps, because the tool may go back and forth.
        let against = (pieces.start + 1..pieces.end).map(|i| {
            let step = (path[i].position - path[i - 1].position).xy();
            let force = self.pieces[i].force;
            -force.xy().dot(&step) / force.z
        });
        let against: f64 = against.sum();
        let heights = pieces.clone().map(|i| path[i].height.abs());
        let is_off = |i: &usize| !path[*i].is_on_plane();
        SteadySlide {
            travel,
            force,
            // A surface that rises pushes the tool back, without friction.
            drag: (against - rise) / travel,
            rise,
            highest: heights.fold(0.0, f64::max),
            share_off_plane: pieces.clone().filter(is_off).count() as f64 / count,
            pieces,
        }
    }

    /// Returns the assumptions made where the forces are not as declared.
    fn assumptions(&self) -> impl Iterator<Item = Doubt> {
        let reading = self.reading;
        let turned = match reading.direction {
            PressDirection::Outward => None,
            PressDirection::Inward => Some(Doubt::WrenchSignInverted),
            PressDirection::Turned { direction, in_tool } => Some(Doubt::WrenchFrameRotated {
                direction: direction.into(),
                in_tool,
            }),
        };
        let declared = self.declared.nominal_force();
        let reference = reading.reference_force(declared);
        let ratio = reference / declared;
        let is_other = !(1.0 / OTHER_FORCE..=OTHER_FORCE).contains(&ratio);
        let otherwise = is_other
            .then_some(reference)
            .map(|force| Doubt::PressForceDiffers {
                force,
                declared,
                matters: 0.0,
                offsets: self.offsets,
            });
        let offset = reading.clock_offset;
        let clocks = match reading.other_clock_offset {
            Some(other) => Some(Doubt::ClocksUncertain {
                offsets: [offset, other],
            }),
            None => (offset != 0.0).then_some(Doubt::ClockOffset { offset }),
        };
        let stiffness = self.found_stiffness.map(|found| found.n_per_m);
        let stiffness = stiffness.zip(self.declared.stiffness());
        let stiffness = stiffness
            .filter(|(found, declared)| !as_stiff(*declared).contains(found))
            .map(|(found, declared)| Doubt::StiffnessDiffers { found, declared });
        let turned = turned.into_iter().chain(otherwise);
        turned.chain(clocks).chain(stiffness)
    }

    fn is_touching(&self, piece: &PathPiece) -> bool {
        piece.is_on_plane() && piece.normalized_force >= self.config.events.contact_share[1]
    }

    /// Returns a doubt if the samples are too far apart in time to show contact.
    fn find_sparseness(&self) -> Option<Doubt> {
        let period = self.median_period();
        (period > LONGEST_PERIOD).then_some(Doubt::Sparse { period })
    }

    /// Median time between two pieces [s].
    fn median_period(&self) -> f64 {
        let mut periods: Vec<f64> = (self.pieces.windows(2))
            .map(|pair| pair[1].time[0] - pair[0].time[1])
            .collect();
        periods.sort_unstable_by(f64::total_cmp);
        periods.get(periods.len() / 2).copied().unwrap_or(0.0)
    }

    /// Returns a doubt if the bias of the force changes during the log.
    fn find_bias_change(&self) -> Option<Doubt> {
        let change = self.reading.bias_change?;
        // A push in between is force on a lifted tool, and no bias, unless the force stays.
        let [from, to] = change.times;
        let is_pushed = (self.events.iter())
            .any(|event| event.kind.is_by_hand() && event.start < to && event.end > from);
        if is_pushed && !change.persists {
            return None;
        }
        let reference = self.reading.reference_force(self.declared.nominal_force());
        let share = change.size / reference;
        (share > LEAST_BIAS_CHANGE).then_some(Doubt::BiasChange {
            change: change.size,
            share,
            times: change.times,
        })
    }

    /// Returns a doubt if the tool leans in contact, so that the logged frame may not be that of the tool.
    fn find_lean(&self) -> Option<Doubt> {
        let (plane, _) = self.classified.plane.as_ref()?;
        let normal = plane.normal();
        let touching = self.pieces.iter().zip(&self.classified.path);
        let touching = touching.filter(|(_, piece)| self.is_touching(piece));
        // A tool frame may point into the surface as well as out of it.
        let mut facing: Vec<f64> = touching
            .map(|(piece, _)| {
                (piece.surface_from_tool.inverse() * normal)
                    .z
                    .abs()
                    .min(1.0)
            })
            .collect();
        facing.sort_unstable_by(f64::total_cmp);
        let lean = libm::acos(*facing.get(facing.len() / 2)?);
        let beyond = (lean - self.own_tilt).max(0.0);
        (beyond > LEAST_LEAN).then_some(Doubt::ToolLeans { lean, beyond })
    }

    /// Returns a doubt if the log is cut while the tool presses, or has gaps in which the tool may have wiped.
    fn find_gaps(&self) -> Option<Doubt> {
        let path = &self.classified.path;
        let is_pressing = |piece: Option<&PathPiece>| {
            piece.is_some_and(|piece| piece.is_on_plane() && piece.normalized_force >= PRESSING)
        };
        let begins = is_pressing(path.first());
        let ends = is_pressing(path.last());
        let gaps = (path.windows(2)).filter(|pair| {
            let way = pair[1].position - pair[0].position;
            pair.iter().any(|piece| self.is_touching(piece)) || way.norm() > TRAVEL_IN_GAP
        });
        let gaps: Vec<f64> = gaps.map(|pair| pair[1].time[0] - pair[0].time[1]).collect();
        let sum = |least: f64| gaps.iter().filter(|gap| **gap > least).sum::<f64>();
        let short = sum(SHORT_GAP.max(UNUSUAL * self.median_period()));
        let lasts = (path.first().zip(path.last())).map_or(0.0, |(a, b)| b.time[1] - a.time[0]);
        let long = sum(LONGEST_GAP);
        let missing = if short > MANY_GAPS * lasts {
            short.max(long)
        } else {
            long
        };
        (begins || ends || missing > 0.0).then_some(Doubt::Incomplete {
            begins,
            ends,
            missing,
        })
    }

    /// Whether a place lies beside the surface, and on no other patch of the same mesh.
    fn is_beside(&self, place: Point2) -> bool {
        let is_on_seam = match &self.surface.shape {
            SurfaceShape::Mesh(mesh) => mesh.reaches_beyond_seam(place),
            SurfaceShape::Plane | SurfaceShape::Cylinder { .. } | SurfaceShape::Cone(_) => false,
        };
        !is_on_seam && !self.surface.outline.contains(place)
    }

    /// Sums up the time and travel of the tool in contact.
    fn sliding(&self) -> Sliding {
        let mut sliding = Sliding::default();
        for pair in self.classified.path.windows(2) {
            let [before, piece] = [&pair[0], &pair[1]];
            if !self.is_touching(piece) {
                continue;
            }
            let lasts = (piece.time[1] - before.time[1]).min(LONGEST_STEP);
            sliding.time += lasts;
            if self.is_beside(piece.position.xy()) {
                sliding.beside += lasts;
            }
            if self.is_touching(before) {
                sliding.travel += (piece.position - before.position).xy().norm();
            }
        }
        sliding
    }
}

/// Range of stiffnesses that count as the declared one [N/m].
fn as_stiff(declared: f64) -> std::ops::RangeInclusive<f64> {
    declared / OTHER_STIFFNESS..=declared * OTHER_STIFFNESS
}

/// Totals of the contact.
#[derive(Debug, Clone, Copy, Default)]
struct Sliding {
    /// Time in contact [s].
    time: f64,
    /// The part of it beside the surface [s].
    beside: f64,
    /// Travel in contact [m].
    travel: f64,
}

fn find_hand_guiding(path: &[PathPiece], events: &[Event]) -> Option<Doubt> {
    let led = (events.iter()).filter(|event| event.kind == EventKind::HandGuiding);
    let led: f64 = led.map(|event| event.end - event.start).sum();
    let all = path.last()?.time[1] - path.first()?.time[0];
    let share = led / all;
    (share > MOST_LED).then_some(Doubt::HandGuided { share })
}

/// Returns a doubt if the tool pressed too far from the believed surface. Without a plane, heights are those over the
/// believed surface.
fn find_distant_contact(path: &[PathPiece], config: &InterpretConfig) -> Option<Doubt> {
    let is_pressed = |i: &usize| path[*i].normalized_force >= config.confident_share;
    let mut heights: Vec<(f64, f64)> = ((0..path.len()).filter(is_pressed))
        .map(|i| (path[i].height, PathPiece::duration(path, i)))
        .collect();
    let pressed: f64 = heights.iter().map(|(_, lasts)| lasts).sum();
    if pressed < LEAST_PRESSING {
        return None;
    }
    heights.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
    let at = |tenth: usize| heights[(heights.len() - 1) * tenth / 10].0;
    if at(9) - at(1) > MOST_SPREAD {
        return None;
    }
    let height = at(5);
    let searched = config.search_height_m;
    (height.abs() > searched).then_some(Doubt::ContactFarFromSurface { height, searched })
}
