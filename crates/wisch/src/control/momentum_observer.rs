//! The external-torque observer: estimates joint torques that the model does not explain.

use crate::robot::ArticulationState;
use nalgebra::DMatrix;

/// A generalised-momentum observer (De Luca, Albu-Schäffer, Haddadin, Hirzinger 2006). It estimates external
/// efforts, filtered to first order, without accelerations.
#[derive(Debug, Clone)]
pub struct MomentumObserver {
    gain: f64,
    variables: Vec<usize>,
    residual: Vec<f64>,
    explained: Vec<f64>,
    mass: DMatrix<f64>,
    bias: Vec<f64>,
    has_begun: bool,
}

impl MomentumObserver {
    /// Returns an observer of the variables with these indices, in an articulation of `n`
    /// variables. `gain`: bandwidth of the observer [1/s].
    pub fn new(variables: &[usize], n: usize, gain: f64) -> Self {
        Self {
            gain,
            residual: vec![0.0; variables.len()],
            explained: vec![0.0; variables.len()],
            variables: variables.to_vec(),
            mass: DMatrix::zeros(n, n),
            bias: vec![0.0; n],
            has_begun: false,
        }
    }

    /// Updates the observer and returns the external efforts of the observed variables [Nm or N].
    ///
    /// - `state`: current mass matrix and bias of the articulation.
    /// - `qd`: velocities of all n variables [rad/s or m/s].
    /// - `efforts_since`: efforts of the observed variables since the last call [Nm or N].
    /// - `period`: time since the last call \[s\].
    pub fn update(
        &mut self,
        state: &ArticulationState,
        qd: &[f64],
        efforts_since: &[f64],
        period: f64,
    ) -> &[f64] {
        let present = state.mass_matrix();
        for (k, &i) in self.variables.iter().enumerate() {
            let momentum: f64 = (0..qd.len()).map(|j| present[(i, j)] * qd[j]).sum();
            if self.has_begun {
                let change: f64 = (0..qd.len())
                    .map(|j| (present[(i, j)] - self.mass[(i, j)]) * qd[j])
                    .sum();
                // r = K (p − ∫ (τ − b + r + Ṁ q̇) dt) with the momentum p = M q̇;
                // the bias b holds gravity and Coriolis terms.
                self.explained[k] +=
                    period * (efforts_since[k] - self.bias[i] + self.residual[k]) + change;
                self.residual[k] = self.gain * (momentum - self.explained[k]);
            } else {
                self.explained[k] = momentum;
            }
        }
        self.mass.copy_from(present);
        self.bias.copy_from_slice(state.bias());
        self.has_begun = true;
        &self.residual
    }
}
