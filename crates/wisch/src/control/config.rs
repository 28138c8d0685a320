//! Gains and limits of the controller.

/// Gains and limits of the controller, in addition to those that the knowledge base gives per task.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ControlConfig {
    /// Period of control and telemetry \[s\].
    pub period: f64,
    /// Stiffness along the surface [N/m]: it keeps the tool on its line against friction. The stiffness of the
    /// knowledge base acts along the normal.
    pub lateral_stiffness: f64,
    /// Rotational stiffness [Nm/rad].
    pub rotational_stiffness: f64,
    /// Limit at which the controller's moment is saturated \[Nm\].
    pub moment_limit: f64,
    /// Force of the unsaturated spring on the surface over the saturation force \[1\]. It sets how much farther
    /// away than estimated the surface may be before the force drops.
    pub press_margin: f64,
    /// Height above the surface below which the spring is commanded into it \[m\].
    pub approach_height: f64,
    /// Stiffness of the posture task at a weight of 1 [Nm/rad].
    pub posture_stiffness: f64,
    /// Bandwidth of the external-torque observer [1/s].
    pub observer_gain: f64,
}

impl Default for ControlConfig {
    fn default() -> Self {
        Self {
            period: 1e-3,
            lateral_stiffness: 2000.0,
            rotational_stiffness: 60.0,
            moment_limit: 8.0,
            press_margin: 1.1,
            approach_height: 0.012,
            posture_stiffness: 100.0,
            observer_gain: 150.0,
        }
    }
}
