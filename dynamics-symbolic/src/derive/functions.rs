//! The outputs of each function, on one chain.

use super::chain::Chain;
use super::derivatives::{ForceDerivatives, Matrix, sum_of_products};
use super::displacement::Held;
use super::joints::Joints;
use super::passivity::Rates;
use super::second_derivatives::SecondDerivatives;
use super::solve::Factors;
use super::symbols::Symbols;
use super::{
    articulated, base, center_of_mass, centroidal, composite, derivatives, displacement, energy,
    joint_forces, kinematics, link_jacobians, momenta, passivity, rates, recursive, regressor,
    second_derivatives, tip,
};
use crate::expr::Expr;
pub use crate::function::Form;
use crate::function::{self, Argument, Function};
use crate::linear::Vector3;
use crate::mechanism::Frame;

/// A function, of a frame where it is about one, and how it is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Part {
    /// The function.
    pub function: Function,
    /// The place of the frame among the named ones; `None` for the tip.
    pub frame: Option<usize>,
    /// The function's form.
    pub form: Form,
}

impl Part {
    /// A part of a request in this form.
    pub fn new(part: impl Into<function::Part>, form: Form) -> Self {
        let function::Part { function, frame } = part.into();
        Part {
            function,
            frame,
            form,
        }
    }

    /// A part of a request as the recursion that is made for it.
    pub fn recursive(part: impl Into<function::Part>) -> Self {
        Part::new(part, Form::Recursive)
    }
}

/// The outputs of a function, in the order of its contract: matrices by rows.
/// For forward dynamics and its derivatives: the values, the pivots, and M's diagonal.
pub fn outputs<'g>(
    symbols: &mut Symbols<'g>,
    chain: &Chain<Expr<'g>>,
    part: Part,
) -> Vec<Expr<'g>> {
    let Part { function, form, .. } = part;
    let mut equations = Equations {
        frame: symbols.arm().frame(part.frame),
        qd: symbols.all(|joint| joint.qd),
        qdd: symbols.all(|joint| joint.qdd),
        still: symbols.still(),
        symbols,
        chain,
    };
    let of_rows = equations.of_rows(function, form);
    if is_of_joints(function) {
        return of_rows;
    }
    equations.joints().outputs(function.shape(), of_rows)
}

/// Whether the outputs are those of the joints that move by themselves from the start: what is solved
/// for, derivatives by positions, and products of velocities, which are more of the rows than of the
/// joints.
fn is_of_joints(function: Function) -> bool {
    function.has_pivots()
        || matches!(
            function,
            Function::InverseDynamicsDerivatives
                | Function::InverseDynamicsSecondDerivatives
                | Function::CoriolisCoefficients
                | Function::CentrifugalCoefficients
        )
}

type Vector<'g> = Vec<Expr<'g>>;

/// The equations of an arm, with entries for the joint of every row: a locked joint is one that stands still, at a
/// constant position, a follower one that moves as it has to.
struct Equations<'a, 'g> {
    symbols: &'a mut Symbols<'g>,
    chain: &'a Chain<Expr<'g>>,
    /// The frame that a function of a frame is about.
    frame: &'g Frame,
    qd: Vector<'g>,
    qdd: Vector<'g>,
    /// The accelerations of joints whose velocities are constant: zero, except for those of a base that moves.
    still: Vector<'g>,
}

impl<'g> Equations<'_, 'g> {
    /// The outputs, of all rows except for [`is_of_joints`].
    fn of_rows(&mut self, function: Function, form: Form) -> Vector<'g> {
        let (chain, frame) = (self.chain, self.frame);
        let (zero, one) = (chain.zero, chain.one);
        match form {
            Form::Assembled => return self.assembled(function),
            Form::Columns => return self.columns(function),
            Form::Recursive | Form::Articulated => {}
        }
        match function {
            Function::MassMatrix => composite::mass_matrix(chain).concat(),
            Function::CoriolisVector => self.link_forces(&self.still, Vector3::splat(zero)),
            Function::GravityVector => energy::gravity_vector(chain),
            Function::FrictionVector => joint_forces::friction(self.symbols),
            Function::SpringVector => joint_forces::springs(self.symbols),
            // Series of the equations of motion as they are, not solved for the accelerations.
            Function::InverseDynamics | Function::TaylorSeries => {
                let forces = self.link_forces(&self.qdd, chain.gravity);
                self.with_joint_forces(forces)
            }
            Function::BiasForce => {
                let forces = self.link_forces(&self.still, chain.gravity);
                self.with_joint_forces(forces)
            }
            Function::ForwardDynamics => self.forward_dynamics(form),
            Function::KineticEnergy => vec![energy::kinetic_energy(chain, &self.qd)],
            Function::PotentialEnergy => {
                let of_springs = joint_forces::energy_of_springs(self.symbols);
                vec![energy::potential_energy(chain) + of_springs]
            }
            Function::CoriolisMatrix => self.coriolis_matrix(),
            // The symbols of each pair of different joints, both orders of it added up.
            Function::CoriolisCoefficients => self.coefficients(|c| {
                let pairs = (0..c.len()).flat_map(|j| (j + 1..c.len()).map(move |k| (j, k)));
                pairs.map(|(j, k)| c[j][k] + c[k][j]).collect()
            }),
            // The symbols of each joint with itself.
            Function::CentrifugalCoefficients => {
                self.coefficients(|c| (0..c.len()).map(|j| c[j][j]).collect())
            }
            Function::ForwardKinematics => {
                let frames = kinematics::frames(self.symbols);
                kinematics::fixed(self.symbols, &frames, frame.place()).homogeneous(zero, one)
            }
            Function::LinkPoses => {
                let frames = kinematics::frames(self.symbols).into_iter();
                let poses = frames.flat_map(|frame| frame.pose.homogeneous(zero, one));
                poses.collect()
            }
            Function::Jacobian => kinematics::jacobian(self.symbols, frame),
            Function::InverseDynamicsDerivatives => {
                let of_links = derivatives::recursion(chain, &self.qd, &self.qdd);
                self.force_derivatives(of_links.of_joints(self.symbols), Held::Accelerations)
            }
            Function::ForwardDynamicsDerivatives => {
                self.acceleration_derivatives(|factors, b| factors.solve(b))
            }
            Function::Regressor => regressor::by_recursion(self.symbols, chain),
            Function::BaseParameters => base::observed_parameters(self.symbols),
            // Articulated bodies are of joints that move by themselves.
            Function::ForwardDynamicsAba if self.symbols.arm().is_coupled() => {
                self.forward_dynamics(Form::Recursive)
            }
            Function::ForwardDynamicsAba => self.articulated_dynamics(),
            Function::WrenchTorques => tip::wrench_torques(self.symbols, chain, frame),
            Function::ToolVelocity => tip::velocity(self.symbols, chain, frame),
            Function::ToolAcceleration => tip::acceleration(self.symbols, chain, frame),
            Function::JacobianRate => self.jacobian_rate(),
            Function::LinkJacobians => link_jacobians::of_links(self.symbols),
            Function::CenterOfMass => center_of_mass::center(self.symbols, chain),
            Function::CenterOfMassJacobian => center_of_mass::jacobian(self.symbols, chain),
            Function::CentroidalMomentumMatrix => centroidal::matrix(self.symbols, chain),
            Function::CentroidalMomentumBias => {
                centroidal::bias(self.symbols, chain, [&self.qd, &self.still])
            }
            Function::OperationalInertiaInverse => self.operational_inertia_inverse(),
            Function::GeneralizedMomentum => momenta::generalized_momentum(chain, &self.qd),
            Function::MomentumBias => {
                let gradient = momenta::kinetic_gradient(chain, &self.qd);
                self.momentum_bias(gradient)
            }
            Function::PassivityTorque => {
                let rates = self.passivity_rates();
                let forces = passivity::torque(chain, &rates, self.symbols.graph().half());
                self.with_joint_forces(forces)
            }
            Function::PassivityRegressor => {
                let rates = self.passivity_rates();
                regressor::of_passivity(self.symbols, chain, &rates)
            }
            Function::EnergyRegressors => regressor::of_energies(self.symbols, chain),
            Function::InverseDynamicsRates => self.force_rates(),
            Function::InverseDynamicsSecondDerivatives => {
                let of_links =
                    second_derivatives::recursion(self.symbols, chain, &self.qd, &self.qdd);
                let of_joints = of_links.of_joints(self.symbols);
                self.second_force_derivatives(of_joints, Held::Accelerations)
            }
        }
    }

    /// The functions that have a second form.
    fn assembled(&mut self, function: Function) -> Vector<'g> {
        let (chain, zero) = (self.chain, self.chain.zero);
        match function {
            Function::CoriolisVector => {
                let motion = self.assembled_motion();
                self.with_still(motion)
            }
            Function::CoriolisMatrix => {
                let symbols = self.christoffel();
                let matrix = symbols.iter().map(|c| times(zero, c, &self.qd)).collect();
                self.with_base_rate(matrix, || composite::mass_matrix(chain))
                    .concat()
            }
            Function::BiasForce => {
                let bias = self.assembled_bias();
                self.with_still(bias)
            }
            Function::InverseDynamics | Function::TaylorSeries => {
                let inertial = times(zero, &composite::mass_matrix(chain), &self.qdd);
                sum(inertial, &self.assembled_bias())
            }
            Function::GravityVector => {
                let still = vec![zero; chain.links.len()];
                recursive::inverse_dynamics(chain, &still, &still, chain.gravity)
            }
            Function::InverseDynamicsDerivatives => {
                let motion: [&[_]; 2] = [&self.qd, &self.qdd];
                let of_links = derivatives::differentiated(self.symbols, chain, motion);
                self.force_derivatives(of_links, Held::Rates)
            }
            Function::ForwardDynamicsDerivatives => {
                self.acceleration_derivatives(|factors, b| times(zero, &factors.inverse(), &b))
            }
            Function::Regressor => regressor::by_partial_velocities(self.symbols, chain),
            Function::GeneralizedMomentum => times(zero, &composite::mass_matrix(chain), &self.qd),
            Function::MomentumBias => {
                let gradient = gradient(zero, &self.christoffel(), &self.qd);
                self.momentum_bias(gradient)
            }
            Function::PassivityTorque => {
                let rates = self.passivity_rates();
                let qd_r: Vec<_> = rates.iter().map(|rates| rates.qd_r).collect();
                let qdd_r: Vec<_> = rates.iter().map(|rates| rates.qdd_r).collect();
                let symbols = self.christoffel();
                let inertial = times(zero, &composite::mass_matrix(chain), &qdd_r);
                let forces = sum(inertial, &contracted(zero, &symbols, [&self.qd, &qd_r]));
                self.with_joint_forces(sum(forces, &energy::gravity_vector(chain)))
            }
            Function::InverseDynamicsRates => {
                let forces = self.assembled(Function::InverseDynamics);
                let [jerk, snap] = self.jerk_and_snap();
                rates::differentiated(self.symbols, &forces, [&jerk, &snap]).concat()
            }
            Function::InverseDynamicsSecondDerivatives => {
                let (qd, qdd) = (&self.qd, &self.qdd);
                let of_links = second_derivatives::differentiated(self.symbols, chain, qd, qdd);
                self.second_force_derivatives(of_links, Held::Rates)
            }
            _ => self.of_rows(function, Form::Recursive),
        }
    }

    /// sum c_ijk qd_j qd_k: V, except for the accelerations that the motion of a base adds.
    fn assembled_motion(&self) -> Vector<'g> {
        contracted(self.chain.zero, &self.christoffel(), [&self.qd, &self.qd])
    }

    /// The same with G + K + F.
    fn assembled_bias(&mut self) -> Vector<'g> {
        let motion = self.assembled_motion();
        let gravity = energy::gravity_vector(self.chain);
        self.with_joint_forces(sum(motion, &gravity))
    }

    /// Forces with M D u added, of the accelerations D u that the motion of a base adds.
    fn with_still(&self, forces: Vector<'g>) -> Vector<'g> {
        if !self.has_base() {
            return forces;
        }
        let matrix = composite::mass_matrix(self.chain);
        sum(forces, &times(self.chain.zero, &matrix, &self.still))
    }

    /// The functions that are written by the composite bodies of M, beside that.
    fn columns(&mut self, function: Function) -> Vector<'g> {
        let (chain, motion) = (self.chain, [&self.qd[..], &self.still]);
        match function {
            Function::GravityVector => composite::gravity_vector(chain),
            Function::CoriolisVector => {
                composite::bias_force(chain, motion, Vector3::splat(chain.zero))
            }
            Function::BiasForce => {
                let forces = composite::bias_force(chain, motion, chain.gravity);
                self.with_joint_forces(forces)
            }
            _ => self.of_rows(function, Form::Recursive),
        }
    }

    fn joints(&self) -> Joints<Expr<'g>> {
        Joints::of(self.symbols)
    }

    /// M qdd + V, and G if `gravity` is the chain's.
    fn link_forces(&self, qdd: &[Expr<'g>], gravity: Vector3<Expr<'g>>) -> Vector<'g> {
        recursive::inverse_dynamics(self.chain, &self.qd, qdd, gravity)
    }

    /// Forces, and K + F.
    fn with_joint_forces(&mut self, forces: Vector<'g>) -> Vector<'g> {
        sum(forces, &joint_forces::both(self.symbols))
    }

    /// The Christoffel symbols c_ijk of all rows, indexed `[i][j][k]`.
    fn christoffel(&self) -> Vec<Matrix<Expr<'g>>> {
        super::christoffel::christoffel(self.chain)
    }

    /// The values that `of_joint` makes of the Christoffel symbols of each joint that moves by itself.
    fn coefficients(&self, of_joint: impl Fn(&Matrix<Expr<'g>>) -> Vector<'g>) -> Vector<'g> {
        let of_joints = self.joints().cube(self.christoffel());
        of_joints.iter().flat_map(of_joint).collect()
    }

    /// C = 1/2 dV/dqd: V is quadratic in qd, with the Christoffel symbols as coefficients.
    fn coriolis_matrix(&self) -> Vector<'g> {
        let forces = derivatives::recursion(self.chain, &self.qd, &self.still);
        let half = self.symbols.graph().half();
        let halved = |row: &Vector<'g>| row.iter().map(|&entry| half * entry).collect();
        let matrix: Matrix<_> = forces.by_velocity.iter().map(halved).collect();
        self.with_base_rate(matrix, || composite::mass_matrix(self.chain))
            .concat()
    }

    /// A matrix with J D added, of the J that is multiplied by the velocities of the base; D is none of a base that stands.
    fn with_base_rate(
        &self,
        mut matrix: Matrix<Expr<'g>>,
        multiplied: impl FnOnce() -> Matrix<Expr<'g>>,
    ) -> Matrix<Expr<'g>> {
        if !self.has_base() {
            return matrix;
        }
        let rate = self.symbols.base_rate();
        for (row, multiplied) in matrix.iter_mut().zip(multiplied()) {
            let of_base = core::array::from_fn(|k| multiplied[k]);
            add_first(row, rate.transposed_times(of_base));
        }
        matrix
    }

    fn has_base(&self) -> bool {
        self.symbols.arm().freedoms().has_base()
    }

    /// dJ/dt by rows.
    fn jacobian_rate(&mut self) -> Vector<'g> {
        let count = self.chain.links.len();
        let by_rows = |entries: Vector<'g>| -> Matrix<_> {
            entries.chunks(count).map(<[_]>::to_vec).collect()
        };
        let rate = link_jacobians::rate(self.symbols, self.frame);
        if !self.has_base() {
            return rate;
        }
        let jacobian = kinematics::jacobian(self.symbols, self.frame);
        self.with_base_rate(by_rows(rate), || by_rows(jacobian))
            .concat()
    }

    /// C' qd - G - K - F, from the first term.
    fn momentum_bias(&mut self, gradient: Vector<'g>) -> Vector<'g> {
        let mut gradient = gradient;
        if self.has_base() {
            let momentum = momenta::generalized_momentum(self.chain, &self.qd);
            let momentum = core::array::from_fn(|k| momentum[k]);
            let added = self.symbols.base_rate().transposed_times(momentum);
            add_first(&mut gradient, added);
        }
        let conservative = difference(gradient, energy::gravity_vector(self.chain));
        difference(conservative, joint_forces::both(self.symbols))
    }

    /// The velocities and the reference motion of the joint of every row.
    fn passivity_rates(&mut self) -> Vec<Rates<Expr<'g>>> {
        let qd_r = self.symbols.entries(Argument::ReferenceVelocity);
        let qdd_r = self.symbols.entries(Argument::ReferenceAcceleration);
        let joints = self.qd.iter().zip(qd_r).zip(qdd_r);
        let rates = joints.map(|((&qd, qd_r), qdd_r)| Rates { qd, qd_r, qdd_r });
        let mut rates: Vec<_> = rates.collect();
        if self.has_base() {
            let reference = core::array::from_fn(|k| rates[k].qd_r);
            let added = self.symbols.base_rate().times(reference);
            for (rates, added) in rates.iter_mut().zip(added) {
                rates.qdd_r = rates.qdd_r + added;
            }
        }
        rates
    }

    fn jerk_and_snap(&mut self) -> [Vector<'g>; 2] {
        [Argument::Jerk, Argument::Snap].map(|argument| self.symbols.entries(argument))
    }

    /// The first derivatives of the joint forces along a motion, then the second ones.
    fn force_rates(&mut self) -> Vector<'g> {
        let [jerk, snap] = self.jerk_and_snap();
        let of_links = rates::recursion(self.symbols, self.chain, [&jerk, &snap]);
        let own = joint_forces::both(self.symbols);
        let of_joints = rates::differentiated(self.symbols, &own, [&jerk, &snap]);
        let orders = of_links.into_iter().zip(&of_joints);
        orders.flat_map(|(forces, own)| sum(forces, own)).collect()
    }

    /// J M^-1 J^T by rows, the pivots, and the diagonal of M.
    fn operational_inertia_inverse(&mut self) -> Vector<'g> {
        let joints = self.joints();
        let matrix = joints.block(composite::mass_matrix(self.chain));
        let nothing = vec![self.chain.zero; matrix.len()];
        let (factors, _) = self.factored(matrix.clone(), nothing);
        let jacobian = kinematics::jacobian(self.symbols, self.frame);
        let rows = jacobian.chunks(self.chain.links.len());
        let rows: Vec<_> = rows.map(|row| joints.entries(row.to_vec())).collect();
        let values = factors.congruence(&rows).concat();
        [values, factors.pivots().to_vec(), diagonal(&matrix)].concat()
    }

    /// The factors of M, and the solution of M x = b.
    fn factored(&self, matrix: Vec<Vector<'g>>, b: Vector<'g>) -> (Factors<'g>, Vector<'g>) {
        let outermost = self.symbols.arm().outermost();
        Factors::new(self.symbols.graph(), outermost, matrix, b)
    }

    /// Accelerations, pivots, and the diagonal of M.
    fn forward_dynamics(&mut self, form: Form) -> Vector<'g> {
        let net = self.net_force();
        let joints = self.joints();
        let matrix = joints.block(composite::mass_matrix(self.chain));
        let diagonal = diagonal(&matrix);
        let (qdd, pivots) = if form == Form::Articulated {
            let (qdd, pivots) = articulated::solve(self.chain, &net);
            (joints.entries(qdd), joints.entries(pivots))
        } else {
            let net = joints.entries(net);
            let (factors, qdd) = self.factored(matrix, net);
            (qdd, factors.pivots().to_vec())
        };
        [qdd, pivots, diagonal].concat()
    }

    /// As [`Equations::forward_dynamics`]. The diagonal of M comes last: what is equal to one of its terms has been
    /// written by articulated bodies before.
    fn articulated_dynamics(&mut self) -> Vector<'g> {
        let applied = self.symbols.all(|joint| joint.tau);
        let net = difference(applied, joint_forces::both(self.symbols));
        let (qdd, pivots) = articulated::forward_dynamics(self.chain, &self.qd, &net);
        let qdd = difference(qdd, self.still.clone());
        let diagonal = diagonal(&composite::mass_matrix(self.chain));
        let of_rows = [qdd, pivots, diagonal];
        of_rows.map(|x| self.joints().entries(x)).concat()
    }

    /// tau - V - G - K - F, for the joint of every row.
    fn net_force(&mut self) -> Vector<'g> {
        let bias = self.of_rows(Function::BiasForce, Form::Recursive);
        difference(self.symbols.all(|joint| joint.tau), bias)
    }

    /// d tau/dq and d tau/dqd, from those of M qdd + V + G, of the joints that move by themselves.
    fn force_derivatives(
        &mut self,
        mut derivatives: ForceDerivatives<Expr<'g>>,
        held: Held,
    ) -> Vector<'g> {
        displacement::first(self.symbols, self.chain, &mut derivatives, held);
        joint_forces::add_slopes(self.symbols, &mut derivatives);
        let matrices = [derivatives.by_position, derivatives.by_velocity];
        matrices.concat().concat()
    }

    /// d2 tau/dq dq, d2 tau/dqd dqd, d2 tau/dq dqd and dM/dq, from those of M qdd + V + G.
    fn second_force_derivatives(
        &mut self,
        mut derivatives: SecondDerivatives<Expr<'g>>,
        held: Held,
    ) -> Vector<'g> {
        displacement::second(self.symbols, self.chain, &mut derivatives, held);
        joint_forces::add_curvatures(self.symbols, &mut derivatives);
        let SecondDerivatives {
            by_position,
            by_velocity,
            by_both,
            of_inertia,
        } = derivatives;
        let cubes = [by_position, by_velocity, by_both, of_inertia];
        cubes.concat().concat().concat()
    }

    /// Derivatives of M qdd + V + G + K + F = tau, which holds for every q, qd and tau:
    /// M d qdd/dq = -d tau/dq and M d qdd/dqd = -d tau/dqd at that qdd, M d qdd/d tau = 1.
    /// `solve` solves M x = b.
    fn acceleration_derivatives(
        &mut self,
        solve: impl Fn(&Factors<'g>, Vector<'g>) -> Vector<'g>,
    ) -> Vector<'g> {
        let (joints, n) = (self.joints(), self.symbols.arm().dof());
        let matrix = joints.block(composite::mass_matrix(self.chain));
        let net = joints.entries(self.net_force());
        let (factors, qdd) = self.factored(matrix.clone(), net);
        let qdd = sum(self.symbols.of_all(&qdd), &self.still);
        let of_links = derivatives::recursion(self.chain, &self.qd, &qdd);
        let forces = self.force_derivatives(of_links.of_joints(self.symbols), Held::Accelerations);
        let mut values = forces.clone();
        for (b, x) in forces.chunks(n * n).zip(values.chunks_mut(n * n)) {
            for column in 0..n {
                let right_side = (0..n).map(|row| -b[row * n + column]).collect();
                for (row, entry) in solve(&factors, right_side).into_iter().enumerate() {
                    x[row * n + column] = entry;
                }
            }
        }
        let inverse = factors.inverse().concat();
        [
            values,
            inverse,
            factors.pivots().to_vec(),
            diagonal(&matrix),
        ]
        .concat()
    }
}

/// Adds to the first of all entries.
fn add_first<'g>(entries: &mut [Expr<'g>], added: impl IntoIterator<Item = Expr<'g>>) {
    for (entry, added) in entries.iter_mut().zip(added) {
        *entry = *entry + added;
    }
}

fn diagonal<'g>(matrix: &[Vector<'g>]) -> Vector<'g> {
    (0..matrix.len()).map(|i| matrix[i][i]).collect()
}

/// sum c_ijk a_k b_j, from the symbols c[i][j][k].
fn contracted<'g>(zero: Expr<'g>, c: &[Matrix<Expr<'g>>], [a, b]: [&[Expr<'g>]; 2]) -> Vector<'g> {
    let of_joint = |c: &Matrix<Expr<'g>>| sum_of_products(zero, &times(zero, c, a), b);
    c.iter().map(of_joint).collect()
}

/// dT/dq_i = 1/2 sum dM_jk/dq_i qd_j qd_k = sum c_kij qd_j qd_k, from the symbols c[k][i][j].
fn gradient<'g>(zero: Expr<'g>, c: &[Matrix<Expr<'g>>], qd: &[Expr<'g>]) -> Vector<'g> {
    let of_joint = |i: usize| {
        let rows: Vec<_> = c.iter().map(|c| sum_of_products(zero, &c[i], qd)).collect();
        sum_of_products(zero, &rows, qd)
    };
    (0..qd.len()).map(of_joint).collect()
}

/// The product of a matrix and a vector.
fn times<'g>(zero: Expr<'g>, matrix: &[Vector<'g>], x: &[Expr<'g>]) -> Vector<'g> {
    matrix
        .iter()
        .map(|row| sum_of_products(zero, row, x))
        .collect()
}

fn sum<'g>(a: Vector<'g>, b: &[Expr<'g>]) -> Vector<'g> {
    a.into_iter().zip(b).map(|(a, &b)| a + b).collect()
}

fn difference<'g>(a: Vector<'g>, b: Vector<'g>) -> Vector<'g> {
    a.into_iter().zip(b).map(|(a, b)| a - b).collect()
}
