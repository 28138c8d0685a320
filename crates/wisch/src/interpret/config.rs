//! Settings of the interpretation, with the sources of their defaults.

use super::error::{InterpretError, within};
use super::uncertainty::Uncertainty;
use crate::represent::{LogNormal, Task};

/// Settings of the interpretation. [`InterpretConfig::from_task`] takes the task-dependent ones
/// from a task.
///
/// f′, the normalised force of (9), is the normal force over the nominal force, from 0 (no contact)
/// to 1 (nominal contact).
#[derive(Debug, Clone, PartialEq)]
pub struct InterpretConfig {
    /// f_max of (9): at normal forces above this one there is no contact \[N\]; 0 in the paper.
    pub max_normal_force_n: f64,
    /// f_min of (9): normal force of nominal contact \[N\], negative; minus the task's press force.
    pub min_normal_force_n: f64,
    /// Least f′ of a confident contact, the lower bound of (10) \[1\]; 0.9 in the paper.
    pub confident_share: f64,
    /// Error of a measured force \[N\]; it widens the upper bound of (10), which is 1.
    pub force_noise_n: f64,
    /// How far the tool compresses under a force.
    pub compliance: ToolCompliance,
    /// Height at which a hovering tool works over the surface \[m\]; 0 for a tool that touches. The f′ of a hovering tool
    /// is this gap over its clearance from the believed surface.
    pub gap_m: f64,
    /// Settings of the plane fit.
    pub plane: PlaneConfig,
    /// μ and σ of the activation likelihood (12).
    pub likelihood: LogNormal,
    /// Force at which the tool centre point lies on the surface \[N\]; the nominal force where it is `None`.
    pub level_force_n: Option<f64>,
    /// Uncertain parameters and their spreads.
    pub uncertainty: Uncertainty,
    /// Number of members that replace a certain belief at the first log.
    pub replays: usize,
    /// ℓ: travel in contact after which a particle draws its threshold again \[m\]; by default r_s of the tool.
    pub redraw_length_m: f64,
    /// Tilt of the fitted plane above which the surface counts as misplaced \[rad\].
    pub relocalize_tilt: f64,
    /// Offset of the fitted plane above which the surface counts as misplaced \[m\].
    pub relocalize_offset_m: f64,
    /// Height of the tool centre point over the believed surface above which the tool is certainly
    /// free \[m\]; a force measured there is bias. The compression of the tool is not subtracted.
    pub free_height_m: f64,
    /// Largest distance of the real surface from the believed one \[m\].
    pub search_height_m: f64,
    /// Whether each sample holds pose and force of the same instant, as those of an executor do.
    /// Otherwise the force may be early or late, and is aligned.
    pub has_one_clock: bool,
    /// Mass of tool and holder behind the force sensor, whose inertia the forces include \[kg\]; 0 if it is unknown. A mass
    /// that the forces in free motion show takes precedence.
    pub moved_mass_kg: f64,
    /// Thresholds of the events.
    pub events: EventConfig,
    /// Maximum number of pieces that a log is reduced to; beyond it, neighbouring pieces are merged.
    pub max_pieces: usize,
    /// Seed of all random numbers.
    pub seed: u64,
}

/// Cause of a contact force that differs from the declared one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum OtherForce {
    /// The sensor has another scale.
    Scale,
    /// The tool presses with another force.
    Press,
}

/// How far a tool compresses. At nominal force, the tool centre point is at the underside of the
/// tool. At a smaller force the tool is less compressed, so the tool centre point is higher above
/// the surface while the tool touches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ToolCompliance {
    /// The tool does not compress.
    Rigid,
    /// The tool compresses like a linear spring.
    Spring {
        /// Force per compression [N/m].
        stiffness_n_per_m: f64,
        /// Relative error of a computed compression \[1\].
        uncertainty: f64,
    },
}

/// Settings of the RANSAC plane fit (11).
#[derive(Debug, Clone, PartialEq)]
pub struct PlaneConfig {
    /// ε of (11): largest distance of an inlier from the plane \[m\].
    pub inlier_distance_m: f64,
    /// Largest angle between the fitted normal and the believed one \[rad\].
    pub cone: f64,
    /// Probability that at least one hypothesis is drawn from inliers alone \[1\].
    pub confidence: f64,
    /// Maximum number of hypotheses.
    pub max_iterations: usize,
    /// Minimum number of inliers.
    pub min_points: usize,
    /// Least share of inliers among the points \[1\]: scattered points lie on no plane.
    pub min_share: f64,
    /// Least standard deviation of the points along a direction at which they determine the slope there \[m\].
    pub min_spread_m: f64,
}

impl Default for PlaneConfig {
    fn default() -> Self {
        Self {
            inlier_distance_m: 1e-3,
            cone: 10.0_f64.to_radians(),
            confidence: 0.9999,
            max_iterations: 1000,
            min_points: 10,
            min_share: 0.2,
            min_spread_m: 0.02,
        }
    }
}

/// Thresholds of the events. Forces are those of the pieces of a log, with the bias subtracted. f′
/// is the normalised force of (9).
#[derive(Debug, Clone, PartialEq)]
pub struct EventConfig {
    /// f′ at which a contact begins, and f′ at which it ends \[1\].
    pub contact_share: [f64; 2],
    /// Least duration of an event \[s\].
    pub min_duration_s: f64,
    /// Longest interruption that is still part of an event \[s\].
    pub bridge_s: f64,
    /// Height over the plane up to which the tool counts as near the surface \[m\], compression not subtracted.
    pub near_height_m: f64,
    /// Travel along the surface without force that makes a contact loss \[m\].
    pub loss_travel_m: f64,
    /// Time without force, while the tool stands during a stroke, that makes a contact loss \[s\].
    pub loss_rest_s: f64,
    /// Distance from the plane, beyond the inlier distance, that makes a push \[m\].
    pub collision_height_m: f64,
    /// f′ off the plane at which a push may begin, and f′ down to which it lasts \[1\].
    pub collision_share: [f64; 2],
    /// Friction coefficient that wiping may reach: tangential over normal force \[1\]. Rubber on a dry board has about
    /// 0.8.
    pub friction_limit: f64,
    /// Tangential force that makes a push, in addition to friction at `friction_limit`; and the
    /// force down to which it lasts, in addition to the friction that the log itself shows \[N\].
    pub tangential_margin_n: [f64; 2],
    /// Normal force over the nominal force at which an overload begins, and the ratio down to which
    /// it lasts \[1\].
    pub overload: [f64; 2],
    /// Force in free motion at which a push begins, and the force down to which it lasts \[N\].
    /// Both count above the noise of the log and exceed the inertial force of a hand.
    pub free_force_n: [f64; 2],
    /// Longest interruption that is still part of a push in free motion \[s\]: when the robot lifts, the tool runs ahead
    /// of the hand that pushes it.
    pub free_bridge_s: f64,
    /// Pushes with less time between them are merged \[s\].
    pub push_gap_s: f64,
    /// Duration from which a push counts as hand guiding \[s\].
    pub guiding_s: f64,
    /// Longest time after a push within which the released tool may land \[s\].
    pub landing_s: f64,
    /// Largest delay of measured forces behind positions \[s\].
    pub force_lag_s: f64,
    /// Number of changes between sticking and slipping that make stick-slip.
    pub stick_slip_turns: usize,
}

impl Default for EventConfig {
    fn default() -> Self {
        Self {
            contact_share: [0.1, 0.05],
            min_duration_s: 0.03,
            bridge_s: 0.03,
            near_height_m: 0.015,
            loss_travel_m: 0.005,
            loss_rest_s: 0.1,
            collision_height_m: 0.002,
            collision_share: [0.5, 0.3],
            friction_limit: 0.8,
            tangential_margin_n: [5.0, 1.5],
            overload: [1.8, 1.5],
            free_force_n: [2.0, 1.5],
            free_bridge_s: 0.25,
            push_gap_s: 0.35,
            guiding_s: 5.0,
            landing_s: 1.0,
            force_lag_s: 0.015,
            stick_slip_turns: 6,
        }
    }
}

impl InterpretConfig {
    /// Returns the settings for a task, which provides forces, compliance, likelihood, ℓ and seed.
    ///
    /// ```
    /// # use wisch::prelude::*;
    /// # let outline = Polygon::rectangle(Vector2::new(0.4, 0.3));
    /// # let surface = Surface::new("tray", outline, Pose::identity());
    /// # let sponge = Tool::pad("sponge", Vector3::new(0.07, 0.11, 0.05))?;
    /// # let crumbs = ParticleDistribution::new(&[Point2::new(0.0, 0.0), Point2::new(0.0, 0.12)])?;
    /// # let task = Task::new(Action::Absorb, surface, sponge, "crumbs", crumbs);
    /// use wisch::interpret::InterpretConfig;
    /// let config = InterpretConfig::from_task(&task);
    /// assert_eq!(config.min_normal_force_n, -task.interaction.press_force_n);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from_task(task: &Task) -> Self {
        let interaction = &task.interaction;
        let compliance = if interaction.compression_depth_m > 0.0 && !interaction.hovers() {
            ToolCompliance::Spring {
                stiffness_n_per_m: interaction.press_force_n / interaction.compression_depth_m,
                uncertainty: 0.2,
            }
        } else {
            ToolCompliance::Rigid
        };
        Self {
            max_normal_force_n: 0.0,
            min_normal_force_n: -interaction.press_force_n,
            confident_share: 0.9,
            force_noise_n: 1.0,
            compliance,
            gap_m: interaction.gap_m,
            plane: PlaneConfig::default(),
            likelihood: interaction.likelihood,
            level_force_n: None,
            uncertainty: Uncertainty {
                law_mu: interaction.likelihood_spread.mu,
                law_sigma: interaction.likelihood_spread.ln_sigma,
                redraw_share: interaction.redraw.ln_length_spread,
                kept_share: interaction.redraw.kept_share,
                ..Uncertainty::default()
            },
            replays: member_count(task),
            redraw_length_m: (interaction.redraw.length_m)
                .unwrap_or_else(|| task.tool.collision_radius()),
            relocalize_tilt: 0.5_f64.to_radians(),
            relocalize_offset_m: 0.003,
            free_height_m: 0.015,
            search_height_m: 0.05,
            has_one_clock: false,
            moved_mass_kg: 0.0,
            events: EventConfig::default(),
            max_pieces: 1 << 20,
            seed: task.seed,
        }
    }

    /// Checks that every setting is within its range.
    ///
    /// # Errors
    /// The first field that is not.
    pub(super) fn check(&self) -> Result<(), InterpretError> {
        self.uncertainty.check()?;
        let (plane, events, likelihood) = (&self.plane, &self.events, &self.likelihood);
        let [metres, seconds] = [(0.0, 1e6, "0 to 1e6 m"), (0.0, 1e6, "0 to 1e6 s")];
        let positive = (1e-6, 1e6, "1e-6 to 1e6");
        let share = (0.0, 1.0, "0 to 1");
        let any_force = (-1e6, 1e6, "-1e6 to 1e6 N");
        let press_force = (1e-3, 1e6, "-1e6 to -1e-3 N, its size");
        let noise = (0.0, 1e6, "0 to 1e6 N");
        let near = (1e-9, 1.0, "1e-9 to 1 m");
        let mu = (-1e3, 1e3, "-1000 to 1000");
        let sigma = (1e-9, 1e3, "1e-9 to 1000");
        let (tilt, cone) = ((0.0, 4.0, "0 to 4 rad"), (0.0, 1.5, "0 to 1.5 rad"));
        let (some, many) = ((1.0, 1e5, "1 to 100000"), (1.0, 1e8, "1 to 1e8"));
        let (pieces, points) = ((16.0, 1e8, "16 to 1e8"), (3.0, 1e8, "3 to 1e8"));
        let [max_pieces, min_points] = [self.max_pieces, plane.min_points].map(|n| n as f64);
        let max_iterations = plane.max_iterations as f64;
        let fields = [
            ("max_normal_force_n", self.max_normal_force_n, any_force),
            ("min_normal_force_n", -self.min_normal_force_n, press_force),
            ("confident_share", self.confident_share, share),
            ("force_noise_n", self.force_noise_n, noise),
            ("likelihood.mu", likelihood.mu, mu),
            ("likelihood.sigma", likelihood.sigma, sigma),
            ("redraw_length_m", self.redraw_length_m, positive),
            ("gap_m", self.gap_m, metres),
            ("relocalize_tilt", self.relocalize_tilt, tilt),
            ("relocalize_offset_m", self.relocalize_offset_m, metres),
            ("free_height_m", self.free_height_m, metres),
            ("level_force_n", self.level_force(), any_force),
            ("search_height_m", self.search_height_m, metres),
            (
                "moved_mass_kg",
                self.moved_mass_kg,
                (0.0, 1e6, "0 to 1e6 kg"),
            ),
            ("plane.inlier_distance_m", plane.inlier_distance_m, near),
            ("plane.cone", plane.cone, cone),
            ("plane.confidence", plane.confidence, share),
            ("plane.min_share", plane.min_share, share),
            ("plane.min_spread_m", plane.min_spread_m, positive),
            ("events.min_duration_s", events.min_duration_s, seconds),
            ("events.bridge_s", events.bridge_s, seconds),
            ("events.free_bridge_s", events.free_bridge_s, seconds),
            ("events.push_gap_s", events.push_gap_s, seconds),
            ("events.loss_rest_s", events.loss_rest_s, seconds),
            ("events.guiding_s", events.guiding_s, seconds),
            ("events.landing_s", events.landing_s, seconds),
            ("events.near_height_m", events.near_height_m, metres),
            ("replays", self.replays as f64, some),
            ("max_pieces", max_pieces, pieces),
            ("plane.min_points", min_points, points),
            ("plane.max_iterations", max_iterations, many),
        ];
        fields.into_iter().try_for_each(within)?;
        if let ToolCompliance::Spring {
            stiffness_n_per_m, ..
        } = self.compliance
        {
            let range = (1e-3, 1e12, "0.001 to 1e12 N/m");
            within(("compliance.stiffness_n_per_m", stiffness_n_per_m, range))?;
        }
        if self.max_normal_force_n <= self.min_normal_force_n {
            return Err(InterpretError::Config {
                name: "max_normal_force_n",
                value: self.max_normal_force_n,
                expected: "min_normal_force_n to 1e6 N",
            });
        }
        Ok(())
    }

    /// Returns the settings for a log whose nominal force is `reference` [N].
    ///
    /// If the sensor has another scale, the tool compresses by the same distance under it as under the declared force. If
    /// the tool presses with another force, it compresses by another distance.
    #[must_use]
    pub(super) fn with_reference_force(&self, reference: f64, cause: OtherForce) -> Self {
        let ratio = reference / self.nominal_force();
        let mut config = self.clone();
        if ratio == 1.0 {
            return config;
        }
        config.min_normal_force_n = -reference;
        match (cause, &mut config.compliance) {
            (
                OtherForce::Scale,
                ToolCompliance::Spring {
                    stiffness_n_per_m, ..
                },
            ) => *stiffness_n_per_m *= ratio,
            _ => config.level_force_n = Some(self.level_force()),
        }
        // A larger scale of the forces scales noise and friction as well.
        let larger = ratio.max(1.0);
        config.force_noise_n *= larger;
        for force in [
            &mut config.events.tangential_margin_n,
            &mut config.events.free_force_n,
        ] {
            *force = force.map(|newtons| newtons * larger);
        }
        config
    }

    /// Returns the settings for a tool of another stiffness [N/m], if one is known; a rigid tool stays rigid.
    #[must_use]
    pub(super) fn with_stiffness(mut self, stiffness: Option<f64>) -> Self {
        if let (
            ToolCompliance::Spring {
                stiffness_n_per_m, ..
            },
            Some(stiffness),
        ) = (&mut self.compliance, stiffness)
        {
            *stiffness_n_per_m = stiffness;
        }
        self
    }

    /// Nominal press force [N].
    pub(super) fn nominal_force(&self) -> f64 {
        -self.min_normal_force_n
    }

    /// Force at which the tool centre point lies on the surface [N].
    pub(super) fn level_force(&self) -> f64 {
        self.level_force_n.unwrap_or_else(|| self.nominal_force())
    }

    /// Largest f′ of a confident contact (10) [1].
    pub(super) fn confident_limit(&self) -> f64 {
        1.0 + self.force_noise_n / self.nominal_force()
    }

    /// Compression of the tool at nominal force [m].
    pub(super) fn nominal_compression(&self) -> f64 {
        match self.compliance {
            ToolCompliance::Rigid => 0.0,
            ToolCompliance::Spring {
                stiffness_n_per_m, ..
            } => self.nominal_force() / stiffness_n_per_m,
        }
    }

    /// Stiffness of the tool [N/m]; `None` for a rigid tool.
    pub(super) fn stiffness(&self) -> Option<f64> {
        match self.compliance {
            ToolCompliance::Rigid => None,
            ToolCompliance::Spring {
                stiffness_n_per_m, ..
            } => Some(stiffness_n_per_m),
        }
    }

    /// f′ of (9), not yet limited to 1; `normal_force` in newtons, negative where the tool presses.
    pub(super) fn normalized(&self, normal_force: f64) -> f64 {
        normal_force.min(self.max_normal_force_n) / self.min_normal_force_n
    }
}

/// Largest number of members of a belief, and the smallest unless there are very many particles. A
/// claim depends on the tail of the distribution, which only many members resolve.
const MEMBERS: [usize; 2] = [1024, 64];
/// Largest number of particles of all members together, unless that leaves too few members.
const MOST_PARTICLES: usize = 1 << 25;
const FEWEST_MEMBERS: usize = 16;
/// Largest product of the numbers of particles, footprint edges and members; the time of a replay
/// is proportional to it.
const MOST_WORK: usize = 1 << 20;

/// Returns the number of members of a belief about this task: fewer where a replay takes long.
pub fn member_count(task: &Task) -> usize {
    let particles = task.particles.len().max(1);
    let edges = task.tool.footprint.edges().count().max(1);
    let [most, least] = MEMBERS;
    let of_use = (MOST_WORK / particles.saturating_mul(edges)).clamp(least, most);
    of_use.min((MOST_PARTICLES / particles).max(FEWEST_MEMBERS))
}
