//! Settings of the interpretation, with where their defaults come from.

use super::error::{InterpretError, within};
use super::uncertainty::Uncertainty;
use crate::represent::{LogNormal, Task};

/// Settings of the interpretation. [`InterpretConfig::of`] takes from a task what depends on it.
#[derive(Debug, Clone, PartialEq)]
pub struct InterpretConfig {
    /// f_max of (9): normal force above which there is no contact at all [N], 0 in the paper.
    pub max_normal_force_n: f64,
    /// f_min of (9): normal force of nominal contact, negative [N]; minus the task's press force.
    pub min_normal_force_n: f64,
    /// Lower bound of f′ of a confident contact (10), 0.9 in the paper.
    pub confident_share: f64,
    /// By how much a measured force may be off [N]; widens the upper bound of (10), which is 1.
    pub force_noise_n: f64,
    /// How far the tool gives way under a force.
    pub compliance: ToolCompliance,
    /// How high the tool hovers over the surface instead of touching it [m]; with 0 it touches. Of one that hovers, f′ is this
    /// over its clearance from the believed surface.
    pub gap_m: f64,
    /// How the plane is found.
    pub plane: PlaneConfig,
    /// μ and σ of (12).
    pub likelihood: LogNormal,
    /// What is not known exactly.
    pub uncertainty: Uncertainty,
    /// Members that a belief has which begins as a certainty.
    pub replays: usize,
    /// ℓ: after this travel in contact a particle's threshold is drawn again [m]; r_s of the tool, unless more is known.
    pub redraw_length_m: f64,
    /// From this tilt on the surface counts as elsewhere [rad].
    pub relocalize_tilt: f64,
    /// From this offset on the surface counts as elsewhere [m].
    pub relocalize_offset_m: f64,
    /// Raw height over the believed surface from which on the tool is certainly free, so that what is
    /// felt there is bias [m].
    pub free_height_m: f64,
    /// How far the real surface may be from the believed one [m].
    pub search_height_m: f64,
    /// When an event is one.
    pub events: EventConfig,
    /// Most pieces that a log is kept in; beyond it neighbours become one.
    pub max_pieces: usize,
    /// Seed of everything random.
    pub seed: u64,
}

/// How far a tool gives way. Its tool centre point is its underside at nominal force; under less force
/// the underside has sprung back, so the tool centre point stands higher while it touches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ToolCompliance {
    /// Not at all.
    Rigid,
    /// Like a spring.
    Spring {
        /// Force per compression [N/m].
        stiffness_n_per_m: f64,
        /// By which share of itself a computed compression may be wrong [1].
        uncertainty: f64,
    },
}

/// How a plane is found among points.
#[derive(Debug, Clone, PartialEq)]
pub struct PlaneConfig {
    /// ε of (11): farthest that an inlier may be from the plane [m].
    pub inlier_distance_m: f64,
    /// How far the normal may lean from the believed one [rad].
    pub cone: f64,
    /// With this probability at least one hypothesis is drawn from inliers alone [1].
    pub confidence: f64,
    /// Most hypotheses.
    pub max_iterations: usize,
    /// Fewest inliers.
    pub min_points: usize,
    /// Least share of the points that are inliers: scattered points lie on no plane [1].
    pub min_share: f64,
    /// Standard deviation of the points along a direction from which on they tell the slope there [m].
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

/// When an event is one. Forces are those of pieces of the log, the bias taken off.
#[derive(Debug, Clone, PartialEq)]
pub struct EventConfig {
    /// f′ at which a contact begins, and that at which it ends [1].
    pub contact_share: [f64; 2],
    /// An event lasts at least this long [s].
    pub min_duration_s: f64,
    /// Interruptions up to this long are part of the event [s].
    pub bridge_s: f64,
    /// Raw height over the plane up to which the tool counts as near the surface [m].
    pub near_height_m: f64,
    /// Travel along the surface without force that makes a loss of contact [m].
    pub loss_travel_m: f64,
    /// How long a tool stands without force, in the midst of a stroke, that has lost its contact [s].
    pub loss_rest_s: f64,
    /// Distance from the plane, beyond the inliers' tolerance, that makes a collision [m].
    pub collision_height_m: f64,
    /// f′ off the plane at which a collision may begin, and that down to which it lasts [1].
    pub collision_share: [f64; 2],
    /// Force along the surface over the normal force that wiping may take [1]; friction of rubber on a dry
    /// board is about 0.8.
    pub friction_limit: f64,
    /// Force along the surface that makes a collision: beyond `friction_limit`; and that down to which it lasts:
    /// beyond the friction that the log itself shows [N].
    pub tangential_margin_n: [f64; 2],
    /// Normal force over the nominal one that makes an overload, and that down to which it lasts [1].
    pub overload: [f64; 2],
    /// Size of a force in free motion that makes a collision, and that down to which it lasts [N]; both beyond
    /// the noise that the log shows, and above what the inertia of a hand makes believe.
    pub free_force_n: [f64; 2],
    /// Interruptions of a collision in free motion up to this long are part of it [s]: a tool that the robot
    /// lifts runs ahead of the hand that pushes it.
    pub free_bridge_s: f64,
    /// Two pushes with less time between them are one [s].
    pub push_gap_s: f64,
    /// A push that lasts longer than this is somebody who leads the tool [s].
    pub guiding_s: f64,
    /// How long after a push a tool that was let go of may land [s].
    pub landing_s: f64,
    /// By how long measured forces may lag behind positions [s].
    pub force_lag_s: f64,
    /// Stuck and slipping times, one after the other, that make stick-slip [1].
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
    /// The settings for a task: forces, compliance, likelihood, ℓ and seed are the task's.
    pub fn of(task: &Task) -> Self {
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
            uncertainty: Uncertainty {
                law_mu: interaction.likelihood_spread.mu,
                law_sigma: interaction.likelihood_spread.ln_sigma,
                redraw_share: interaction.redraw.ln_length_spread,
                kept_share: interaction.redraw.kept_share,
                ..Uncertainty::default()
            },
            replays: members(task),
            redraw_length_m: (interaction.redraw.length_m)
                .unwrap_or_else(|| task.tool.collision_radius()),
            relocalize_tilt: 0.5_f64.to_radians(),
            relocalize_offset_m: 0.003,
            free_height_m: 0.015,
            search_height_m: 0.05,
            events: EventConfig::default(),
            max_pieces: 1 << 20,
            seed: task.seed,
        }
    }

    /// Whether the numbers make sense.
    ///
    /// # Errors
    /// The first field that does not.
    pub(super) fn checked(&self) -> Result<(), InterpretError> {
        self.uncertainty.checked()?;
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
            ("search_height_m", self.search_height_m, metres),
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

    /// The same for a log in which this force counts as the nominal one [N]: the tool gives way under it as far as it does
    /// under the declared one.
    #[must_use]
    pub(super) fn with_reference_force(&self, reference: f64) -> Self {
        let ratio = reference / self.nominal_force();
        let mut config = self.clone();
        if ratio == 1.0 {
            return config;
        }
        config.min_normal_force_n = -reference;
        if let ToolCompliance::Spring {
            stiffness_n_per_m, ..
        } = &mut config.compliance
        {
            *stiffness_n_per_m *= ratio;
        }
        // Whatever makes forces larger makes noise and friction larger too.
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

    /// Force with which the tool is to press [N].
    pub(super) fn nominal_force(&self) -> f64 {
        -self.min_normal_force_n
    }

    /// Largest f′ that still counts as confident (10).
    pub(super) fn confident_limit(&self) -> f64 {
        1.0 + self.force_noise_n / self.nominal_force()
    }

    /// How far the tool is compressed at nominal force [m].
    pub(super) fn nominal_compression(&self) -> f64 {
        match self.compliance {
            ToolCompliance::Rigid => 0.0,
            ToolCompliance::Spring {
                stiffness_n_per_m, ..
            } => self.nominal_force() / stiffness_n_per_m,
        }
    }

    /// Stiffness of the tool [N/m], if it gives way.
    pub(super) fn stiffness(&self) -> Option<f64> {
        match self.compliance {
            ToolCompliance::Rigid => None,
            ToolCompliance::Spring {
                stiffness_n_per_m, ..
            } => Some(stiffness_n_per_m),
        }
    }

    /// f′ of (9) before it is held to at most 1.
    pub(super) fn normalized(&self, normal_force: f64) -> f64 {
        normal_force.min(self.max_normal_force_n) / self.min_normal_force_n
    }
}

/// Members of a belief at most and, unless there are very many particles, at least; the tail on which a claim stands is
/// told by many only.
const MEMBERS: [usize; 2] = [1024, 64];
/// Particles of all members together at most, unless that leaves too few members.
const MOST_PARTICLES: usize = 1 << 25;
const FEWEST_MEMBERS: usize = 16;
/// Particles times edges of the footprint times members, which is what a replay takes time by.
const MOST_WORK: usize = 1 << 20;

/// How many members a belief about this task has: as many as are of use, fewer where a replay takes long.
pub fn members(task: &Task) -> usize {
    let particles = task.particles.len().max(1);
    let edges = task.tool.footprint.edges().count().max(1);
    let [most, least] = MEMBERS;
    let of_use = (MOST_WORK / particles.saturating_mul(edges)).clamp(least, most);
    of_use.min((MOST_PARTICLES / particles).max(FEWEST_MEMBERS))
}
