//! Whether a log shows wiping of this surface, and if not, why.

mod force_unit;
mod text;

pub(super) use self::force_unit::fits_other_unit;

use super::contact::{ContactLevel, MOST_LEVELS};
use super::wrench_quality::UnusableWrenches;

/// Height over the believed surface within which a tool without measured force may have touched [m].
pub(super) const NEAR: f64 = 0.02;
/// Distance from the believed surface, in addition to its own size, above which a unit or a frame
/// must be wrong [m].
pub(super) const FAR: f64 = 10.0;
/// Shortest time near the surface after which a sliding tool must show contact [s].
const LEAST_NEAR: f64 = 0.5;
/// Difference of the performance at which the scale of the force becomes decisive [1].
const MOST_BY_SCALE: f64 = 0.1;
/// Largest share of samples without a usable wrench at which the remaining samples still show what
/// was wiped [1].
const MOST_UNUSABLE: f64 = 0.5;
/// Largest share of samples without a usable wrench that is negligible [1].
const FEW_UNUSABLE: f64 = 0.02;
/// Largest share of samples with a wrong pose at which the remaining samples still show what was
/// wiped [1].
const MOST_JUMPS: f64 = 0.05;
/// Range of the press force over the declared one beyond which the unit of the force must be wrong [1].
const PLAUSIBLE_FORCE: std::ops::RangeInclusive<f64> = 0.2..=5.0;
/// Largest change of the bias over the press force at which contact still differs from free motion
/// [1].
const MOST_BIAS_CHANGE: f64 = 0.3;
/// Longest median time between samples, or between changes of the pose, that shows contact [s].
pub(super) const LONGEST_PERIOD: f64 = 0.3;
/// Largest distance [m] and angle [rad] between the tool's pose and that of the joint positions at
/// which the log still shows where the tool was.
const MOST_CONTRADICTION: [f64; 2] = [0.03, 0.2];
/// Largest share of the dirt in occluded places at which an observation that contradicts the log still decides [1].
const MOST_HIDDEN: f64 = 0.1;
/// Largest lean of a tool whose underside still faces the surface [rad]; 60°, a cosine of 0.5.
const MOST_LEAN: f64 = std::f64::consts::FRAC_PI_3;

/// Options of `wisch interpret` in the text of doubts, and the corresponding statements of an
/// executor.
const REMEDIES: [(&str, &str); 6] = [
    (
        "--wrench-sign",
        "force_n of the executor is the force of the surroundings on the tool",
    ),
    (
        "--force-unit-n, --force-scale",
        "force_n of the executor is in newtons",
    ),
    (
        "--wrench-frame",
        "wrench_axes of the executor names the axes of force_n",
    ),
    (
        "--length-unit-m",
        "world_from_tool of the executor is in metres",
    ),
    (
        "--pose-offset",
        "world_from_tool of the executor is the pose of the tool",
    ),
    (
        "--payload-mass",
        "force_n of the executor is without the tool's weight",
    ),
];

/// A reason why a log may not show wiping, or not wiping of this surface; and the assumption with
/// which the log was read.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Doubt {
    /// The tool came near the surface, but its force shows no contact.
    NoContactForce {
        /// Smallest distance of the tool from the believed surface \[m\].
        closest: f64,
        /// Size of the force that is not exceeded during 90 % of the time near the surface \[N\].
        force: f64,
        /// Declared press force \[N\].
        declared: f64,
        /// Time near the surface \[s\].
        lasts: f64,
    },
    /// Near the surface, the force is the declared one in another unit.
    ForceInOtherUnit {
        /// Median size of the force near the surface \[N\].
        force: f64,
        /// Declared press force \[N\].
        declared: f64,
    },
    /// The tool was so far from the surface that the unit of length or the frame of the log must be
    /// wrong.
    FarAway {
        /// Median distance of the tool from the origin of the surface \[m\].
        distance: f64,
    },
    /// The tool pressed against the other side of the surface, and moved freely on that side.
    OtherSide,
    /// The tool never came near the surface.
    NeverNearSurface {
        /// Smallest distance of the tool from the believed surface \[m\].
        closest: f64,
    },
    /// The log shows no calm free motion, so the bias of the force is unknown.
    NoFreeMotion,
    /// The contacts lie on a cylinder rather than on a plane.
    Curved {
        /// Radius \[m\].
        radius: f64,
        /// Angle of its axis from the surface's x, from 0 to π \[rad\].
        axis: f64,
        /// Whether it bulges towards the tool.
        is_convex: bool,
    },
    /// The contacts lie on an arc along one direction rather than on a plane; they do not show the rest of the surface.
    CurvedAlong {
        /// Radius \[m\].
        radius: f64,
        /// Angle of the direction from the surface's x, from 0 to π \[rad\].
        direction: f64,
        /// Whether it bulges towards the tool.
        is_convex: bool,
    },
    /// The contacts lie on a surface that is curved in two directions rather than on a plane.
    DoublyCurved {
        /// Principal radii, the smaller first; positive where the surface bulges towards the tool \[m\].
        radii: [f64; 2],
        /// Angle of the direction with the first radius from the surface's x, from 0 to π \[rad\].
        direction: f64,
    },
    /// The contacts lie on no plane, and no shape explains them.
    NotPlanar {
        /// Distance from the best plane that a tenth of the contacts exceeds \[m\].
        off: f64,
    },
    /// The contacts lie on parallel planes at different heights rather than on one plane.
    SeveralHeights {
        /// The planes, the lowest first; unused entries are without contacts.
        levels: [ContactLevel; MOST_LEVELS],
        /// Number of contacts.
        contacts: usize,
    },
    /// The contacts do not lie on the curved surface that was believed.
    OffShape {
        /// Distance from the believed shape, at its best pose, that a tenth of the contacts exceeds \[m\].
        off: f64,
    },
    /// The tool pressed with a force other than the declared one.
    PressForceDiffers {
        /// Force with which the tool pressed for most of the time \[N\].
        force: f64,
        /// Declared force \[N\].
        declared: f64,
        /// Difference of the performance between the two explanations \[1\]: the tool really pressed with this force, or
        /// the force is measured on another scale.
        matters: f64,
        /// Distance of the surface from where it is believed to be, under the first and the second explanation \[m\], if they
        /// differ; the smaller one is taken.
        offsets: Option<[f64; 2]>,
    },
    /// The heights of the contacts fit a tool of another stiffness than the declared one.
    StiffnessDiffers {
        /// Stiffness that the contacts show \[N/m\].
        found: f64,
        /// Declared press force over declared compression \[N/m\].
        declared: f64,
    },
    /// The force of contact points into the surface: the log holds the force of the tool on the surface.
    WrenchSignInverted,
    /// The force of contact does not lie along the surface's normal: it is given in another frame.
    WrenchFrameRotated {
        /// Its direction, a unit vector.
        direction: [f64; 3],
        /// Whether it is constant in the axes of the tool rather than in those of the surface.
        in_tool: bool,
    },
    /// The clocks of force and position differ by a constant.
    ClockOffset {
        /// Delay of the force; negative where it is early \[s\].
        offset: f64,
    },
    /// The log begins or ends while the tool presses, or has a gap: wiping at that time is not counted.
    Incomplete {
        /// Whether it begins while the tool presses.
        begins: bool,
        /// Whether it ends while the tool presses.
        ends: bool,
        /// Time without samples, or with poses but without forces, in which the tool may have wiped \[s\].
        missing: f64,
    },
    /// The pose jumps faster than any tool moves.
    PoseJumps {
        /// Number of samples that were left out, because the pose jumped there and back.
        left_out: usize,
        /// Their share of all samples \[1\].
        share: f64,
        /// Number of jumps after which the pose stayed elsewhere, or that took several samples.
        lasting: usize,
        /// Time \[s\] and distance \[m\] of the first jump.
        first: (f64, f64),
    },
    /// The time between two samples is too long to show contact.
    Sparse {
        /// Median time between two samples \[s\].
        period: f64,
    },
    /// The pose changes at a lower rate than the samples follow each other; it was interpolated.
    HeldPoses {
        /// Time between two changes of the pose \[s\].
        period: f64,
    },
    /// The force sensor was tared before the first contact; the samples before it were left out.
    TaredEarly {
        /// Time of the tare \[s\].
        time: f64,
        /// Size of the change \[N\].
        change: f64,
    },
    /// The forces include the inertia of the mass behind the sensor, which was subtracted.
    Inertia {
        /// The mass \[kg\].
        mass: f64,
    },
    /// The force shows that the clocks of force and position differ, but not by how much.
    ClocksUncertain {
        /// Two delays of the force that match landings and lifts of the tool equally well \[s\].
        offsets: [f64; 2],
    },
    /// The bias of the force differs between two free motions: it drifts, or the sensor was tared in between.
    BiasChange {
        /// Size of the change \[N\].
        change: f64,
        /// The change over the usual press force \[1\].
        share: f64,
        /// Times of the two free motions \[s\].
        times: [f64; 2],
    },
    /// The contacts lie on a plane that is steeper than the searched planes.
    TooSteep {
        /// Its angle to the believed surface \[rad\].
        tilt: f64,
        /// Largest angle that is searched \[rad\].
        searched: f64,
    },
    /// The contacts lie on another shape than a plane, so that only their height is used for the pose of the surface.
    HeightOnly {
        /// Median height of the contacts over the believed surface \[m\].
        height: f64,
    },
    /// In contact, the tool turns by more than a quarter turn between two samples: a faster turn looks like a slower one in
    /// the other direction.
    FastTurns {
        /// Median angle between two samples, as the log shows it \[rad\].
        turn: f64,
        /// Whether the effect of the tool depends on its turns, as in polishing.
        counts: bool,
    },
    /// In contact, the z axis of the tool's frame leans away from the normal of the surface.
    ToolLeans {
        /// Median angle between the two lines, from 0 to π/2 \[rad\].
        lean: f64,
        /// The part of the lean that exceeds the tilt of the tool by design \[rad\].
        beyond: f64,
    },
    /// The wrenches of these samples were not usable, so that they do not show what the tool touched.
    UnusableWrench {
        /// Numbers of these samples, by cause.
        unusable: UnusableWrenches,
        /// Their share of all samples \[1\].
        share: f64,
    },
    /// An observation after the log shows a number of grains that hardly a member of the belief explains.
    ObservationContradicts {
        /// Number of detections.
        seen: usize,
        /// Range of the numbers of detections that touch predicts, from the 5th to the 95th percentile.
        left: [f64; 2],
        /// Share of the detections within the goal, and its predicted range from the 5th to the 95th percentile \[1\], if only
        /// this share differs, and not the number of detections.
        shares: Option<[f64; 3]>,
        /// Range of the number of detections if the tool had removed nothing, from the 5th to the
        /// 95th percentile.
        believed: [f64; 2],
        /// Least number of detections of dirt that the tool never touched.
        untouched: f64,
        /// Whether the observation shows more dirt than lay there before the log.
        is_more_than_before: bool,
        /// Share of the dirt in occluded places, about which the log may be as wrong as about the
        /// observed places \[1\]; 0 unless the observation shows more dirt than touch predicts.
        hidden_share: f64,
        /// Whether no earlier observation showed dirt, so that there is no evidence that the camera
        /// detects it.
        is_first: bool,
    },
    /// The places of the detections contradict those of known dirt, as if the frame of the observation were another one.
    ObservationInOtherFrame {
        /// Number of known dirt locations that the tool did not touch.
        untouched: usize,
        /// Number of them at which the observation shows dirt again.
        seen_again: usize,
        /// Number of detections at places where dirt is neither known nor possible after the log.
        unknown: usize,
        /// Number of all detections.
        of: usize,
    },
    /// The first observation shows no dirt, and contact forces do not decide: the camera may detect
    /// no dirt at all.
    UnprovenCamera,
    /// Detections of a camera lie beside the surface and are not used.
    DetectionsBeside {
        /// Number of these detections.
        left_out: usize,
        /// Number of all detections.
        of: usize,
        /// Largest distance of a detection from the surface's edge \[m\].
        farthest: f64,
    },
    /// Detections of a camera repeat another one, and count once.
    DetectionsRepeated {
        /// Number of detections that repeat another one.
        repeated: usize,
        /// Number of all detections.
        of: usize,
    },
    /// For most of the motion, the joint positions give another pose of the tool than the measured
    /// one.
    PositionsContradictPose {
        /// Median distance of the two poses \[m\].
        distance: f64,
        /// Median angle between the two poses \[rad\].
        angle: f64,
    },
    /// The robot stood still although it was ordered to move.
    RobotStoodStill {
        /// Time for which it stood still \[s\].
        time: f64,
        /// Time for which it was ordered to move \[s\].
        ordered: f64,
    },
    /// For most of the motion, the tool was far from the ordered path.
    RobotOffPath {
        /// Median distance from the nearest point of the path \[m\].
        distance: f64,
    },
    /// A person guided the tool by hand: the force is that of the hand as well as that of the surface.
    HandGuided {
        /// Share of the log during which the tool was guided \[1\].
        share: f64,
    },
    /// The tool pressed with its nominal force, but far from the believed surface.
    ContactFarFromSurface {
        /// Median height of the pressing tool over the believed surface \[m\].
        height: f64,
        /// Largest distance from the believed surface at which contact is searched \[m\].
        searched: f64,
    },
    /// In the air, the force is vertical and as large as the weight of a tool.
    LoadInAir {
        /// Size of the force \[N\].
        force: f64,
        /// Mass with this weight \[kg\].
        mass: f64,
    },
    /// The tool was in contact mostly beside the surface.
    ContactBesideSurface {
        /// Share of the contact time beside the outline \[1\].
        share: f64,
    },
    /// The tool was in contact with other patches of the divided mesh too; their effect is not counted.
    OnOtherPatches {
        /// Share of the time with force on other patches \[1\].
        share: f64,
    },
    /// The contacts lie on no common plane.
    Scattered {
        /// Number of confident contacts on the plane that holds most of them.
        inliers: usize,
        /// Number of confident contacts.
        confident: usize,
    },
    /// The tool was near the surface, but hardly in contact with it.
    LittleContact {
        /// Time in contact over the time on or near the surface \[1\].
        share: f64,
    },
    /// In contact, the tool hardly moved along the surface.
    LittleSliding {
        /// Travel along the surface in contact \[m\].
        travel: f64,
        /// Radius of the tool \[m\].
        radius: f64,
    },
}

impl Doubt {
    /// Whether the log cannot show what was wiped. A doubt that is not decisive states an
    /// assumption with which the log was read.
    pub fn is_decisive(&self) -> bool {
        match self {
            Self::PressForceDiffers {
                force,
                declared,
                matters,
                ..
            } => *matters > MOST_BY_SCALE || !PLAUSIBLE_FORCE.contains(&(force / declared)),
            Self::PoseJumps { share, lasting, .. } => *lasting > 0 || *share > MOST_JUMPS,
            Self::BiasChange { share, .. } => *share > MOST_BIAS_CHANGE,
            Self::HeldPoses { period } => *period > LONGEST_PERIOD,
            Self::FastTurns { counts, .. } => *counts,
            Self::ToolLeans { beyond, .. } => *beyond > MOST_LEAN,
            Self::PositionsContradictPose { distance, angle } => {
                *distance > MOST_CONTRADICTION[0] || *angle > MOST_CONTRADICTION[1]
            }
            Self::ObservationContradicts {
                is_more_than_before,
                hidden_share,
                ..
            } => *is_more_than_before || *hidden_share > MOST_HIDDEN,
            Self::UnusableWrench { unusable, share } => unusable.lost_share(*share) > MOST_UNUSABLE,
            Self::NoContactForce { .. }
            | Self::ForceInOtherUnit { .. }
            | Self::FarAway { .. }
            | Self::OtherSide
            | Self::NeverNearSurface { .. }
            | Self::NoFreeMotion
            | Self::Curved { .. }
            | Self::CurvedAlong { .. }
            | Self::DoublyCurved { .. }
            | Self::NotPlanar { .. }
            | Self::SeveralHeights { .. }
            | Self::OffShape { .. }
            | Self::HandGuided { .. }
            | Self::ContactFarFromSurface { .. }
            | Self::ContactBesideSurface { .. }
            | Self::Sparse { .. }
            | Self::ClocksUncertain { .. }
            | Self::TooSteep { .. }
            | Self::Scattered { .. } => true,
            Self::StiffnessDiffers { .. }
            | Self::RobotStoodStill { .. }
            | Self::RobotOffPath { .. }
            | Self::WrenchSignInverted
            | Self::WrenchFrameRotated { .. }
            | Self::ClockOffset { .. }
            | Self::TaredEarly { .. }
            | Self::Inertia { .. }
            | Self::LoadInAir { .. }
            | Self::Incomplete { .. }
            | Self::UnprovenCamera
            | Self::DetectionsBeside { .. }
            | Self::DetectionsRepeated { .. }
            | Self::HeightOnly { .. }
            | Self::OnOtherPatches { .. }
            | Self::ObservationInOtherFrame { .. }
            | Self::LittleContact { .. }
            | Self::LittleSliding { .. } => false,
        }
    }

    /// Describes the doubt about the samples of an executor: remedies are statements of the
    /// executor instead of options of `wisch interpret`.
    pub fn describe_for_executor(&self) -> String {
        let describe =
            |text: String, (option, stated): &(&str, &str)| text.replace(*option, stated);
        REMEDIES.iter().fold(self.to_string(), describe)
    }

    /// Whether the log shows the shape or the pose of another surface than the believed one.
    pub(super) fn is_other_surface(&self) -> bool {
        matches!(
            self,
            Self::ContactFarFromSurface { .. }
                | Self::NeverNearSurface { .. }
                | Self::FarAway { .. }
                | Self::TooSteep { .. }
                | Self::Curved { .. }
                | Self::CurvedAlong { .. }
                | Self::DoublyCurved { .. }
                | Self::SeveralHeights { .. }
                | Self::OffShape { .. }
        )
    }

    /// Whether the contacts lie on another shape than the believed one.
    pub(super) fn is_other_shape(&self) -> bool {
        matches!(
            self,
            Self::Curved { .. }
                | Self::CurvedAlong { .. }
                | Self::DoublyCurved { .. }
                | Self::NotPlanar { .. }
                | Self::OffShape { .. }
        )
    }

    /// Whether the tool may have wiped more than the log shows: it begins or ends while the tool presses, or has no usable
    /// samples for a time.
    pub fn is_cut(&self) -> bool {
        match self {
            Self::Incomplete { .. } => true,
            Self::UnusableWrench { unusable, share } => unusable.lost_share(*share) > FEW_UNUSABLE,
            _ => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn remedies_for_an_executor_are_no_options() {
        let lean = Doubt::ToolLeans {
            lean: 1.2,
            beyond: 1.2,
        };
        let turned = Doubt::WrenchFrameRotated {
            direction: [1.0, 0.0, 0.0],
            in_tool: true,
        };
        let force = Doubt::PressForceDiffers {
            force: 1.0,
            declared: 10.0,
            matters: 0.5,
            offsets: None,
        };
        for (doubt, key) in [
            (lean, "world_from_tool"),
            (turned, "wrench_axes"),
            (force, "force_n of the executor is in newtons"),
            (Doubt::WrenchSignInverted, "force_n"),
        ] {
            assert!(doubt.to_string().contains("(--"), "{doubt}");
            let text = doubt.describe_for_executor();
            assert!(text.contains(key) && !text.contains("--"), "{text}");
        }
    }

    #[test]
    fn a_pose_far_from_the_joint_positions_shows_nothing() {
        let doubt = |distance, angle| Doubt::PositionsContradictPose { distance, angle };
        assert!(doubt(0.05, 0.0).is_decisive() && doubt(0.0, 1.57).is_decisive());
        assert!(!doubt(0.012, 0.1).is_decisive());
        let text = doubt(0.05, 0.0).to_string();
        assert!(
            text.contains("is 0.050 m and 0.0° from where the joint"),
            "{text}"
        );
    }
}
