//! The whole-body impedance controller (8): a saturated spring and damper at the tool, compensation of the
//! weight, and a posture task in the null space.

use super::{ControlConfig, Wrench};
use crate::geometry::{Point3, Pose, Vector3};
use crate::represent::{Interaction, Surface};
use crate::robot::{ArticulationState, Range};
use nalgebra::{Cholesky, DMatrix, DVector, Dyn, Matrix3, Matrix6, Matrix6xX, Vector6};

/// Number of periods between two designs of the damping; the inertia changes slowly.
const DESIGN_EVERY: usize = 10;
/// Smallest inertia at the tool for the design of the damping [kg, kg m²], and largest inertia for
/// translation [kg] and for rotation [kg m²]. Where a wrist is singular, the inertia about one
/// direction is unbounded. A damping designed for that inertia would accelerate the wrist abruptly
/// a moment later, beside the singularity.
const LEAST_INERTIA: f64 = 1e-3;
const MOST_INERTIA: [f64; 2] = [50.0, 0.5];
/// Smallest mobility of the tool [1/kg, 1/(kg m²)]; and the smallest shares of the total mobility
/// over the three directions of translation and of rotation [1]. The directions of rotation differ
/// more.
const LEAST_MOBILITY: f64 = 1e-6;
const LEAST_SHIFT: f64 = 1e-5;
const LEAST_TURN: f64 = 1e-7;
/// Damping ratio of the posture task [1].
const POSTURE_DAMPING: f64 = 0.7;
/// Natural frequency of a joint's end stop, critically damped [rad/s]: stiff enough for a person to lean on,
/// slow against the period of control.
const END_STOP_RATE: f64 = 200.0;

/// Desired pose and velocity of the tool.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DesiredToolState {
    /// Desired pose of the tool, the press into the surface included.
    pub world_from_tool: Pose,
    /// Desired twist, linear first, in the axes of the world [m/s, rad/s].
    pub velocity: Vector6<f64>,
}

/// Desired motion of the joints, one entry per variable of the articulation.
#[derive(Debug, Clone, Copy)]
pub struct DesiredPosture<'a> {
    /// Positions [rad or m].
    pub q: &'a [f64],
    /// Velocities [rad/s or m/s].
    pub qd: &'a [f64],
    /// Accelerations [rad/s² or m/s²].
    pub qdd: &'a [f64],
}

/// Measured state by the robot's joint sensors. Arrays have one entry per variable of the articulation, in its
/// order.
#[derive(Debug, Clone, Copy)]
pub struct MeasuredJointState<'a> {
    /// Positions of the articulation's variables [rad or m].
    pub q: &'a [f64],
    /// Their velocities [rad/s or m/s].
    pub qd: &'a [f64],
    /// Pose of the tool by forward kinematics of `q`.
    pub world_from_tool: Pose,
    /// Jacobian of the tool centre point in the axes of the world, 6 × n: linear rows first.
    pub jacobian: &'a Matrix6xX<f64>,
}

/// The controller of the compliant variables of an articulation. It allocates all memory at the start, because
/// a control loop must not wait for an allocator.
#[derive(Debug, Clone)]
pub struct ImpedanceController {
    compliant: Vec<usize>,
    /// Range of each compliant variable.
    ranges: Vec<Option<Range>>,
    stiffness: Matrix6<f64>,
    /// The surface and the stiffness in the axes of its normal [N/m], if these turn with the tool.
    turning: Option<(Surface, Matrix3<f64>)>,
    damping_ratio: f64,
    force_limit: f64,
    moment_limit: f64,
    posture_stiffness: f64,
    damping: Matrix6<f64>,
    periods: usize,
    mass: Option<Cholesky<f64, Dyn>>,
    spare: Option<DMatrix<f64>>,
    jacobian: Matrix6xX<f64>,
    /// M⁻¹ Jᵀ.
    carried: DMatrix<f64>,
    posture: DVector<f64>,
    efforts: DVector<f64>,
    tool_inertia: Matrix6<f64>,
}

impl ImpedanceController {
    /// Returns a controller that moves the variables `compliant` of an articulation.
    ///
    /// - `compliant`: indices into the articulation's variables.
    /// - `ranges`: range of each compliant variable [rad or m]; `None` for a variable without
    ///   limits.
    /// - `interaction`: press force, stiffness along the normal, damping ratio and weight of the
    ///   posture.
    /// - `surface`: its normal gives the axes of the stiffness; on a curved surface they turn with
    ///   the desired pose of the tool.
    /// - `config`: stiffness along the surface, and the remaining gains.
    pub fn new(
        compliant: Vec<usize>,
        ranges: Vec<Option<Range>>,
        interaction: &Interaction,
        surface: &Surface,
        config: &ControlConfig,
    ) -> Self {
        let count = compliant.len();
        let turned = surface.world_from_surface.rotation.to_rotation_matrix();
        let lateral = config.lateral_stiffness;
        let along_axes = Matrix3::from_diagonal(&Vector3::new(
            lateral,
            lateral,
            interaction.stiffness_n_per_m,
        ));
        let mut stiffness = Matrix6::from_diagonal_element(config.rotational_stiffness);
        let linear = turned * along_axes * turned.inverse();
        stiffness.fixed_view_mut::<3, 3>(0, 0).copy_from(&linear);
        Self {
            stiffness,
            turning: (!surface.shape.is_plane()).then(|| (surface.clone(), along_axes)),
            damping_ratio: interaction.damping_ratio,
            force_limit: interaction.press_force_n,
            moment_limit: config.moment_limit,
            posture_stiffness: config.posture_stiffness * interaction.nullspace_posture_weight,
            damping: Matrix6::zeros(),
            periods: 0,
            mass: None,
            spare: Some(DMatrix::zeros(count, count)),
            jacobian: Matrix6xX::zeros(count),
            carried: DMatrix::zeros(count, 6),
            posture: DVector::zeros(count),
            efforts: DVector::zeros(count),
            tool_inertia: Matrix6::zeros(),
            compliant,
            ranges,
        }
    }

    /// The variables of the articulation that are compliant.
    pub fn compliant_variables(&self) -> &[usize] {
        &self.compliant
    }

    /// Efforts of the compliant variables after [`Self::command`] [Nm or N].
    pub fn efforts(&self) -> &[f64] {
        self.efforts.as_slice()
    }

    /// Computes the efforts and returns f_c, the controller's wrench on the tool. Returns `None` if
    /// the mass matrix is not positive definite, as for a robot without inertia.
    pub fn command(
        &mut self,
        state: &ArticulationState,
        measured: &MeasuredJointState<'_>,
        desired: &DesiredToolState,
        posture: &DesiredPosture<'_>,
    ) -> Option<Wrench> {
        self.turn_stiffness(&desired.world_from_tool);
        self.factorize(state, measured)?;
        let wrench = self.spring_and_damper(measured, desired);
        let mass = self.mass.as_ref()?;
        // PD control of the posture with damping 2 ζ √(k m) for the joint's own inertia m.

        for (k, &i) in self.compliant.iter().enumerate() {
            let stiffness = self.posture_stiffness;
            let inertia = state.mass_matrix()[(i, i)];
            let damping = 2.0 * POSTURE_DAMPING * (stiffness * inertia).sqrt();
            self.posture[k] = stiffness * (posture.q[i] - measured.q[i])
                + damping * (posture.qd[i] - measured.qd[i]);
        }
        // Null-space projection, dynamically consistent: τ = τ₀ − Jᵀ Λ J M⁻¹ τ₀, so that τ₀ does not accelerate
        // the tool.
        self.efforts.copy_from(&self.posture);
        mass.solve_mut(&mut self.posture);
        let mut tool_force = Vector6::zeros();
        for (k, column) in self.jacobian.column_iter().enumerate() {
            tool_force += column * self.posture[k];
        }
        let tool_force = self.tool_inertia * tool_force;
        let force = Vector6::new(
            wrench.force.x,
            wrench.force.y,
            wrench.force.z,
            wrench.moment.x,
            wrench.moment.y,
            wrench.moment.z,
        ) - tool_force;
        for (k, &i) in self.compliant.iter().enumerate() {
            let row = state.mass_matrix().row(i);
            let ahead: f64 = row.iter().zip(posture.qdd).map(|(m, a)| m * a).sum();
            self.efforts[k] += self.jacobian.column(k).dot(&force) + state.bias()[i] + ahead;
        }
        self.stop_at_ends(measured);
        Some(wrench)
    }

    /// Turns the axes of the stiffness with the normal of a curved surface under the desired pose of the tool.
    fn turn_stiffness(&mut self, world_from_tool: &Pose) {
        let Some((surface, along_axes)) = &self.turning else {
            return;
        };
        let tool: Point3 = world_from_tool.translation.vector.into();
        let place = surface.chart(tool).place;
        let turned = (surface.world_from_place(place, 0.0).rotation).to_rotation_matrix();
        let linear = turned * along_axes * turned.inverse();
        (self.stiffness.fixed_view_mut::<3, 3>(0, 0)).copy_from(&linear);
    }

    /// Keeps the joints within their ranges, even if a person pushes the arm.
    fn stop_at_ends(&mut self, measured: &MeasuredJointState<'_>) {
        let Some(mass) = self.mass.as_ref() else {
            return;
        };
        for (k, &i) in self.compliant.iter().enumerate() {
            let (position, velocity) = (measured.q[i], measured.qd[i]);
            let Some(beyond) = self.ranges[k].and_then(|range| distance_beyond(&range, position))
            else {
                continue;
            };
            // Inertia of this joint with all other joints free, 1 / (M⁻¹)ᵢᵢ. It is small for a wrist where
            // another axis is parallel to it, and a stop that is too stiff for it would hammer.
            self.posture.fill(0.0);
            self.posture[k] = 1.0;
            mass.solve_mut(&mut self.posture);
            let inertia = 1.0 / self.posture[k];
            self.efforts[k] += end_stop_effort(beyond, velocity, inertia);
        }
    }

    /// Computes the mass matrix and the inertia at the tool, and at intervals the damping.
    fn factorize(
        &mut self,
        state: &ArticulationState,
        measured: &MeasuredJointState<'_>,
    ) -> Option<()> {
        let used = self.mass.take().map(Cholesky::unpack_dirty);
        let mut mass = used.or_else(|| self.spare.take())?;
        for (row, &i) in self.compliant.iter().enumerate() {
            self.jacobian.set_column(row, &measured.jacobian.column(i));
            for (column, &j) in self.compliant.iter().enumerate() {
                mass[(row, column)] = state.mass_matrix()[(i, j)];
            }
        }
        let mass = Cholesky::new(mass)?;
        self.jacobian.transpose_to(&mut self.carried);
        mass.solve_mut(&mut self.carried);
        // Mobility at the tool: Λ⁻¹ = J M⁻¹ Jᵀ.
        let mut mobility = Matrix6::<f64>::zeros();
        for row in 0..6 {
            for column in 0..6 {
                let products = (0..self.compliant.len())
                    .map(|k| self.jacobian[(row, k)] * self.carried[(k, column)]);
                mobility[(row, column)] = products.sum();
            }
        }
        // Directions in which the tool cannot move have no finite inertia. A lower bound of the mobility bounds
        // it, separately for translation and rotation, because the tool turns far more easily than it shifts.
        for (first, share) in [(0, LEAST_SHIFT), (3, LEAST_TURN)] {
            let trace: f64 = (first..first + 3).map(|i| mobility[(i, i)]).sum();
            for i in first..first + 3 {
                mobility[(i, i)] += LEAST_MOBILITY + share * trace;
            }
        }
        self.tool_inertia = mobility.try_inverse().unwrap_or_else(Matrix6::zeros);
        self.mass = Some(mass);
        if self.periods.is_multiple_of(DESIGN_EVERY) {
            self.design_damping(mobility);
        }
        self.periods += 1;
        Some(())
    }

    /// Designs D with the desired damping ratio in every mode of stiffness and inertia: with Λ = Q Qᵀ and K = Q
    /// K₀ Qᵀ, D = 2 ζ Q √K₀ Qᵀ (Albu-Schäffer, Ott, Frese, Hirzinger 2003).
    fn design_damping(&mut self, mut mobility: Matrix6<f64>) {
        for i in 0..6 {
            mobility[(i, i)] += 1.0 / MOST_INERTIA[i / 3];
        }
        let Some(inertia) = mobility.try_inverse() else {
            return;
        };
        let symmetric = (inertia + inertia.transpose()) * 0.5;
        let safe = symmetric + Matrix6::from_diagonal_element(LEAST_INERTIA);
        let Some(root) = safe.cholesky().map(|c| c.l()) else {
            return;
        };
        let Some(inverse) = root.try_inverse() else {
            return;
        };
        let modes = (inverse * self.stiffness * inverse.transpose()).symmetric_eigen();
        let q = root * modes.eigenvectors;
        let roots = modes.eigenvalues.map(|k| k.max(0.0).sqrt());
        self.damping =
            2.0 * self.damping_ratio * q * Matrix6::from_diagonal(&roots) * q.transpose();
    }

    /// Returns f_c: spring and damper at the tool, K Δx + D Δẋ, saturated in norm with the direction kept.
    fn spring_and_damper(
        &self,
        measured: &MeasuredJointState<'_>,
        desired: &DesiredToolState,
    ) -> Wrench {
        let linear = desired.world_from_tool.translation.vector
            - measured.world_from_tool.translation.vector;
        let turn = rotation_vector_between(&measured.world_from_tool, &desired.world_from_tool);
        let error = Vector6::new(linear.x, linear.y, linear.z, turn.x, turn.y, turn.z);
        let mut velocity = desired.velocity;
        for &i in &self.compliant {
            velocity -= measured.jacobian.column(i) * measured.qd[i];
        }
        // f = K Δx + D Δẋ.
        let wrench = self.stiffness * error + self.damping * velocity;
        Wrench {
            force: saturate(wrench.fixed_rows::<3>(0).into(), self.force_limit),
            moment: saturate(wrench.fixed_rows::<3>(3).into(), self.moment_limit),
        }
    }

    /// Returns the external wrench on the tool that causes the external efforts of the compliant
    /// variables: Λ J M⁻¹ τ_ext. `external_efforts`: one entry per compliant variable [Nm or N].
    pub fn external_wrench(&self, external_efforts: &[f64]) -> Wrench {
        let mut moved = Vector6::zeros();
        for (k, effort) in external_efforts.iter().enumerate() {
            for row in 0..6 {
                moved[row] += self.carried[(k, row)] * effort;
            }
        }
        let wrench = self.tool_inertia * moved;
        Wrench {
            force: wrench.fixed_rows::<3>(0).into(),
            moment: wrench.fixed_rows::<3>(3).into(),
        }
    }
}

/// Returns the signed distance of a position beyond the nearer end of a range [rad or m], negative
/// below the lower end; `None` within the range.
pub fn distance_beyond(range: &Range, position: f64) -> Option<f64> {
    let over = (position - range.upper).max(0.0) + (position - range.lower).min(0.0);
    (over != 0.0).then_some(over)
}

/// Returns the effort of a joint's end stop [Nm or N]: a spring back to the end of its range, and a
/// damper while the joint moves further out.
///
/// `beyond`: see [`distance_beyond`]. `velocity`: of the joint [rad/s or m/s]. `inertia`: at the
/// joint [kg m² or kg].
pub fn end_stop_effort(beyond: f64, velocity: f64, inertia: f64) -> f64 {
    let outwards = (velocity * beyond.signum()).max(0.0) * beyond.signum();
    // Critically damped: −m (ω² x + 2 ω v), with the velocity v outwards only.
    -inertia * (END_STOP_RATE * END_STOP_RATE * beyond + 2.0 * END_STOP_RATE * outwards)
}

/// The saturation S of (8): returns the vector with its norm limited to `limit` and its direction
/// kept.
pub fn saturate(vector: Vector3, limit: f64) -> Vector3 {
    let norm = vector.norm();
    if norm > limit {
        vector * (limit / norm)
    } else {
        vector
    }
}

/// Returns the rotation vector that turns one frame into the other, in the axes of the world [rad]. It uses
/// atan2, which is accurate near 0 and π.
pub fn rotation_vector_between(from: &Pose, to: &Pose) -> Vector3 {
    let between = to.rotation * from.rotation.inverse();
    let (scalar, vector) = (between.w, between.imag());
    let sine = vector.norm();
    if sine < 1e-12 {
        return 2.0 * vector * scalar.signum();
    }
    let angle = 2.0 * sine.atan2(scalar.abs());
    vector * (angle * scalar.signum() / sine)
}
