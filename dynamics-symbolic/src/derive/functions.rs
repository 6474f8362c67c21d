//! The outputs of each function, on one chain.

use super::chain::Chain;
use super::derivatives::ForceDerivatives;
use super::joints::Joints;
use super::passivity::Rates;
use super::second_derivatives::SecondDerivatives;
use super::solve::Factors;
use super::symbols::Symbols;
use super::{
    articulated, base, center_of_mass, christoffel, composite, derivatives, energy, joint_forces,
    kinematics, link_jacobians, momenta, passivity, rates, recursive, regressor,
    second_derivatives, tip,
};
use crate::exact::Rational;
use crate::expr::{Expr, Graph};
pub use crate::function::Form;
use crate::function::{Argument, Function};
use crate::linear::Vector3;

/// A function, and how it is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Part {
    /// The function.
    pub function: Function,
    /// Its form.
    pub form: Form,
}

/// The outputs of a function, in the order of its contract: matrices by rows.
/// For forward dynamics and its derivatives: the values, the pivots, and M's diagonal.
pub fn outputs<'g>(
    symbols: &mut Symbols<'g>,
    chain: &Chain<Expr<'g>>,
    function: Function,
    form: Form,
) -> Vec<Expr<'g>> {
    let of_rows = of_rows(symbols, chain, function, form);
    match is_of_joints(function) {
        true => of_rows,
        false => Joints::of(symbols).outputs(function.shape(), of_rows),
    }
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

/// The outputs with entries for the joint of every row of the table: a locked joint is one that stands
/// still, at a constant position, a follower one that moves as it has to. See [`is_of_joints`].
fn of_rows<'g>(
    symbols: &mut Symbols<'g>,
    chain: &Chain<Expr<'g>>,
    function: Function,
    form: Form,
) -> Vec<Expr<'g>> {
    match form {
        Form::Assembled => return assembled(symbols, chain, function),
        Form::Columns => return columns(symbols, chain, function),
        Form::Recursive | Form::Articulated => {}
    }
    let graph = symbols.graph();
    let (zero, one) = (graph.zero(), graph.one());
    let still = vec![zero; chain.links.len()];
    let weightless = Vector3::splat(zero);
    let qd = symbols.all(|joint| joint.qd);
    let qdd = symbols.all(|joint| joint.qdd);
    match function {
        Function::MassMatrix => composite::mass_matrix(chain).concat(),
        Function::CoriolisVector => recursive::inverse_dynamics(chain, &qd, &still, weightless),
        Function::GravityVector => energy::gravity_vector(chain),
        Function::FrictionVector => joint_forces::friction(symbols),
        Function::SpringVector => joint_forces::springs(symbols),
        // Series of the equations of motion as they are, not solved for the accelerations.
        Function::InverseDynamics | Function::TaylorSeries => {
            let forces = recursive::inverse_dynamics(chain, &qd, &qdd, chain.gravity);
            sum(forces, &joint_forces::both(symbols))
        }
        Function::BiasForce => {
            let forces = recursive::inverse_dynamics(chain, &qd, &still, chain.gravity);
            sum(forces, &joint_forces::both(symbols))
        }
        Function::ForwardDynamics => forward_dynamics(symbols, chain, form),
        Function::KineticEnergy => vec![energy::kinetic_energy(graph, chain, &qd)],
        Function::PotentialEnergy => {
            let of_springs = joint_forces::energy_of_springs(symbols);
            vec![energy::potential_energy(chain) + of_springs]
        }
        Function::CoriolisMatrix => coriolis_matrix(graph, chain, &qd),
        Function::CoriolisCoefficients => coriolis_coefficients(symbols, chain),
        Function::CentrifugalCoefficients => centrifugal_coefficients(symbols, chain),
        Function::ForwardKinematics => {
            let frames = kinematics::frames(symbols);
            kinematics::tip(symbols, &frames).homogeneous(zero, one)
        }
        Function::LinkPoses => {
            let frames = kinematics::frames(symbols);
            frames
                .iter()
                .flat_map(|frame| frame.pose.homogeneous(zero, one))
                .collect()
        }
        Function::Jacobian => kinematics::jacobian(symbols),
        Function::InverseDynamicsDerivatives => {
            let of_links = derivatives::recursion(chain, &qd, &qdd);
            force_derivatives(symbols, of_links.of_joints(symbols))
        }
        Function::ForwardDynamicsDerivatives => {
            acceleration_derivatives(symbols, chain, |factors, b| factors.solve(b))
        }
        Function::Regressor => regressor::by_recursion(symbols, chain),
        Function::BaseParameters => base::observed_parameters(symbols),
        // Articulated bodies are of joints that move by themselves.
        Function::ForwardDynamicsAba if symbols.arm().is_coupled() => {
            forward_dynamics(symbols, chain, Form::Recursive)
        }
        Function::ForwardDynamicsAba => articulated_dynamics(symbols, chain, &qd),
        Function::WrenchTorques => tip::wrench_torques(symbols, chain),
        Function::ToolVelocity => tip::velocity(symbols, chain),
        Function::ToolAcceleration => tip::acceleration(symbols, chain),
        Function::JacobianRate => link_jacobians::rate(symbols),
        Function::LinkJacobians => link_jacobians::of_links(symbols),
        Function::CenterOfMass => center_of_mass::center(symbols, chain),
        Function::CenterOfMassJacobian => center_of_mass::jacobian(symbols, chain),
        Function::OperationalInertiaInverse => operational_inertia_inverse(symbols, chain),
        Function::GeneralizedMomentum => momenta::generalized_momentum(chain, &qd),
        Function::MomentumBias => {
            let gradient = momenta::kinetic_gradient(chain, &qd);
            momentum_bias(symbols, chain, gradient)
        }
        Function::PassivityTorque => {
            let rates = passivity_rates(symbols);
            let forces = passivity::torque(chain, &rates, regressor::half(symbols));
            sum(forces, &joint_forces::both(symbols))
        }
        Function::PassivityRegressor => {
            let rates = passivity_rates(symbols);
            regressor::of_passivity(symbols, chain, &rates)
        }
        Function::EnergyRegressors => regressor::of_energies(symbols, chain),
        Function::InverseDynamicsRates => force_rates(symbols, chain),
        Function::InverseDynamicsSecondDerivatives => {
            let of_links = second_derivatives::recursion(symbols, chain, &qd, &qdd);
            let of_joints = of_links.of_joints(symbols);
            second_force_derivatives(symbols, of_joints)
        }
    }
}

/// C = 1/2 dV/dqd: V is quadratic in qd, with the Christoffel symbols as coefficients.
fn coriolis_matrix<'g>(
    graph: &'g Graph,
    chain: &Chain<Expr<'g>>,
    qd: &[Expr<'g>],
) -> Vec<Expr<'g>> {
    let still = vec![graph.zero(); qd.len()];
    let forces = derivatives::recursion(chain, qd, &still);
    let half = graph.rational(&(Rational::ONE / Rational::from(2)));
    let entries = forces.by_velocity.concat();
    entries.into_iter().map(|entry| half * entry).collect()
}

/// The Christoffel symbols of each pair of different joints, both orders of it added up.
fn coriolis_coefficients<'g>(symbols: &mut Symbols<'g>, chain: &Chain<Expr<'g>>) -> Vec<Expr<'g>> {
    let n = symbols.arm().dof();
    let pairs: Vec<_> = (0..n)
        .flat_map(|j| (j + 1..n).map(move |k| (j, k)))
        .collect();
    let of_rows = christoffel::christoffel(symbols.graph(), chain);
    Joints::of(symbols)
        .cube(of_rows)
        .iter()
        .flat_map(|c| pairs.iter().map(|&(j, k)| c[j][k] + c[k][j]))
        .collect()
}

/// The Christoffel symbols of each joint with itself.
fn centrifugal_coefficients<'g>(
    symbols: &mut Symbols<'g>,
    chain: &Chain<Expr<'g>>,
) -> Vec<Expr<'g>> {
    let of_rows = christoffel::christoffel(symbols.graph(), chain);
    Joints::of(symbols)
        .cube(of_rows)
        .iter()
        .flat_map(|c| (0..c.len()).map(|j| c[j][j]))
        .collect()
}

/// C' qd - G - K - F, from the first term.
fn momentum_bias<'g>(
    symbols: &mut Symbols<'g>,
    chain: &Chain<Expr<'g>>,
    gradient: Vec<Expr<'g>>,
) -> Vec<Expr<'g>> {
    let less = |a: Vec<Expr<'g>>, b: Vec<Expr<'g>>| -> Vec<_> {
        a.into_iter().zip(b).map(|(a, b)| a - b).collect()
    };
    let conservative = less(gradient, energy::gravity_vector(chain));
    less(conservative, joint_forces::both(symbols))
}

/// The velocities and the reference motion of the joint of every row.
fn passivity_rates<'g>(symbols: &mut Symbols<'g>) -> Vec<Rates<Expr<'g>>> {
    let qd_r = symbols.entries(Argument::ReferenceVelocity);
    let qdd_r = symbols.entries(Argument::ReferenceAcceleration);
    let joints = qd_r.into_iter().zip(qdd_r).enumerate();
    let rates = joints.map(|(i, (qd_r, qdd_r))| Rates {
        qd: symbols.joint(i).qd,
        qd_r,
        qdd_r,
    });
    rates.collect()
}

fn jerk_and_snap<'g>(symbols: &mut Symbols<'g>) -> [Vec<Expr<'g>>; 2] {
    [Argument::Jerk, Argument::Snap].map(|argument| symbols.entries(argument))
}

/// The first derivatives of the joint forces along a motion, then the second ones.
fn force_rates<'g>(symbols: &mut Symbols<'g>, chain: &Chain<Expr<'g>>) -> Vec<Expr<'g>> {
    let [jerk, snap] = jerk_and_snap(symbols);
    let of_links = rates::recursion(symbols, chain, [&jerk, &snap]);
    let own = joint_forces::both(symbols);
    let of_joints = rates::differentiated(symbols, &own, [&jerk, &snap]);
    let orders = of_links.into_iter().zip(&of_joints);
    orders.flat_map(|(forces, own)| sum(forces, own)).collect()
}

/// J M^-1 J^T by rows, the pivots, and the diagonal of M.
fn operational_inertia_inverse<'g>(
    symbols: &mut Symbols<'g>,
    chain: &Chain<Expr<'g>>,
) -> Vec<Expr<'g>> {
    let joints = Joints::of(symbols);
    let matrix = joints.block(composite::mass_matrix(chain));
    let nothing = vec![chain.zero; matrix.len()];
    let (factors, _) = Factors::new(symbols.graph(), matrix.clone(), nothing);
    let jacobian = kinematics::jacobian(symbols);
    let rows = jacobian.chunks(chain.links.len());
    let rows: Vec<_> = rows.map(|row| joints.entries(row.to_vec())).collect();
    [
        factors.congruence(&rows).concat(),
        pivots(&factors, &matrix),
    ]
    .concat()
}

/// Accelerations, pivots, and the diagonal of M.
fn forward_dynamics<'g>(
    symbols: &mut Symbols<'g>,
    chain: &Chain<Expr<'g>>,
    form: Form,
) -> Vec<Expr<'g>> {
    let net = net_force(symbols, chain);
    let joints = Joints::of(symbols);
    let matrix = joints.block(composite::mass_matrix(chain));
    let diagonal = (0..matrix.len()).map(|i| matrix[i][i]).collect();
    let (qdd, pivots) = match form {
        Form::Articulated => {
            let (qdd, pivots) = articulated::solve(chain, &net);
            (joints.entries(qdd), joints.entries(pivots))
        }
        _ => {
            let (factors, qdd) = Factors::new(symbols.graph(), matrix, joints.entries(net));
            (qdd, factors.pivots().to_vec())
        }
    };
    [qdd, pivots, diagonal].concat()
}

/// As [`forward_dynamics`]. The diagonal of M comes last: what is equal to one of its terms has been
/// written by articulated bodies before.
fn articulated_dynamics<'g>(
    symbols: &mut Symbols<'g>,
    chain: &Chain<Expr<'g>>,
    qd: &[Expr<'g>],
) -> Vec<Expr<'g>> {
    let applied = symbols.all(|joint| joint.tau).into_iter();
    let own = joint_forces::both(symbols);
    let net: Vec<_> = applied.zip(own).map(|(tau, f)| tau - f).collect();
    let (qdd, pivots) = articulated::forward_dynamics(chain, qd, &net);
    let matrix = composite::mass_matrix(chain);
    let diagonal = (0..matrix.len()).map(|i| matrix[i][i]).collect();
    let joints = Joints::of(symbols);
    [qdd, pivots, diagonal]
        .map(|of_rows| joints.entries(of_rows))
        .concat()
}

/// The functions that have a second form.
fn assembled<'g>(
    symbols: &mut Symbols<'g>,
    chain: &Chain<Expr<'g>>,
    function: Function,
) -> Vec<Expr<'g>> {
    let graph = symbols.graph();
    let zero = graph.zero();
    let qd = symbols.all(|joint| joint.qd);
    match function {
        Function::CoriolisVector => {
            let products = |c: &Vec<Vec<Expr<'g>>>| {
                let contracted: Vec<_> = c.iter().map(|row| dot(zero, row, &qd)).collect();
                dot(zero, &contracted, &qd)
            };
            christoffel::christoffel(graph, chain)
                .iter()
                .map(products)
                .collect()
        }
        Function::CoriolisMatrix => {
            let symbols = christoffel::christoffel(graph, chain);
            symbols
                .iter()
                .flatten()
                .map(|row| dot(zero, row, &qd))
                .collect()
        }
        Function::BiasForce => {
            let motion = assembled(symbols, chain, Function::CoriolisVector);
            let gravity = energy::gravity_vector(chain);
            sum(sum(motion, &gravity), &joint_forces::both(symbols))
        }
        Function::InverseDynamics | Function::TaylorSeries => {
            let qdd = symbols.all(|joint| joint.qdd);
            let inertial = composite::mass_matrix(chain)
                .iter()
                .map(|row| dot(zero, row, &qdd))
                .collect();
            sum(inertial, &assembled(symbols, chain, Function::BiasForce))
        }
        Function::GravityVector => {
            let still = vec![zero; chain.links.len()];
            recursive::inverse_dynamics(chain, &still, &still, chain.gravity)
        }
        Function::InverseDynamicsDerivatives => {
            let qdd = symbols.all(|joint| joint.qdd);
            let of_links = derivatives::differentiated(symbols, chain, [&qd, &qdd]);
            force_derivatives(symbols, of_links)
        }
        Function::ForwardDynamicsDerivatives => {
            acceleration_derivatives(symbols, chain, |factors, b| {
                let inverse = factors.inverse();
                inverse.iter().map(|row| dot(zero, row, &b)).collect()
            })
        }
        Function::Regressor => regressor::by_partial_velocities(symbols, chain),
        Function::GeneralizedMomentum => times(zero, &composite::mass_matrix(chain), &qd),
        Function::MomentumBias => {
            let gradient = gradient(zero, &christoffel::christoffel(graph, chain), &qd);
            momentum_bias(symbols, chain, gradient)
        }
        Function::PassivityTorque => {
            let rates = passivity_rates(symbols);
            let [qd_r, qdd_r] = [|r: &Rates<Expr<'g>>| r.qd_r, |r: &Rates<Expr<'g>>| r.qdd_r]
                .map(|of| rates.iter().map(of).collect::<Vec<_>>());
            let velocity_terms = christoffel::christoffel(graph, chain);
            let velocity_terms = velocity_terms.iter().map(|c| {
                let contracted = times(zero, c, &qd);
                dot(zero, &contracted, &qd_r)
            });
            let inertial = times(zero, &composite::mass_matrix(chain), &qdd_r);
            let forces = sum(inertial, &velocity_terms.collect::<Vec<_>>());
            let forces = sum(forces, &energy::gravity_vector(chain));
            sum(forces, &joint_forces::both(symbols))
        }
        Function::InverseDynamicsRates => {
            let forces = assembled(symbols, chain, Function::InverseDynamics);
            let [jerk, snap] = jerk_and_snap(symbols);
            rates::differentiated(symbols, &forces, [&jerk, &snap]).concat()
        }
        Function::InverseDynamicsSecondDerivatives => {
            let qdd = symbols.all(|joint| joint.qdd);
            let of_links = second_derivatives::differentiated(symbols, chain, &qd, &qdd);
            second_force_derivatives(symbols, of_links)
        }
        _ => of_rows(symbols, chain, function, Form::Recursive),
    }
}

/// The functions that are written by the composite bodies of M, beside that.
fn columns<'g>(
    symbols: &mut Symbols<'g>,
    chain: &Chain<Expr<'g>>,
    function: Function,
) -> Vec<Expr<'g>> {
    let qd = symbols.all(|joint| joint.qd);
    match function {
        Function::GravityVector => composite::gravity_vector(chain),
        Function::CoriolisVector => composite::bias_force(chain, &qd, Vector3::splat(chain.zero)),
        Function::BiasForce => {
            let forces = composite::bias_force(chain, &qd, chain.gravity);
            sum(forces, &joint_forces::both(symbols))
        }
        _ => of_rows(symbols, chain, function, Form::Recursive),
    }
}

/// tau - V - G - K - F, for the joint of every row.
fn net_force<'g>(symbols: &mut Symbols<'g>, chain: &Chain<Expr<'g>>) -> Vec<Expr<'g>> {
    let bias = of_rows(symbols, chain, Function::BiasForce, Form::Recursive);
    let applied = symbols.all(|joint| joint.tau).into_iter();
    applied.zip(bias).map(|(tau, bias)| tau - bias).collect()
}

/// The pivots, and the diagonal of the matrix that they are measured by.
fn pivots<'g>(factors: &Factors<'g>, matrix: &[Vec<Expr<'g>>]) -> Vec<Expr<'g>> {
    let diagonal = (0..matrix.len()).map(|i| matrix[i][i]);
    factors.pivots().iter().copied().chain(diagonal).collect()
}

/// d tau/dq and d tau/dqd, from those of M qdd + V + G, of the joints that move by themselves.
fn force_derivatives<'g>(
    symbols: &mut Symbols<'g>,
    mut derivatives: ForceDerivatives<Expr<'g>>,
) -> Vec<Expr<'g>> {
    joint_forces::add_slopes(symbols, &mut derivatives);
    [derivatives.by_position, derivatives.by_velocity]
        .concat()
        .concat()
}

/// d2 tau/dq dq, d2 tau/dqd dqd, d2 tau/dq dqd and dM/dq, from those of M qdd + V + G.
fn second_force_derivatives<'g>(
    symbols: &mut Symbols<'g>,
    mut derivatives: SecondDerivatives<Expr<'g>>,
) -> Vec<Expr<'g>> {
    joint_forces::add_curvatures(symbols, &mut derivatives);
    let SecondDerivatives {
        by_position,
        by_velocity,
        by_both,
        of_inertia,
    } = derivatives;
    [by_position, by_velocity, by_both, of_inertia]
        .concat()
        .concat()
        .concat()
}

/// Derivatives of M qdd + V + G + K + F = tau, which holds for every q, qd and tau:
/// M d qdd/dq = -d tau/dq and M d qdd/dqd = -d tau/dqd at that qdd, M d qdd/d tau = 1.
/// `solve` solves M x = b.
fn acceleration_derivatives<'g>(
    symbols: &mut Symbols<'g>,
    chain: &Chain<Expr<'g>>,
    solve: impl Fn(&Factors<'g>, Vec<Expr<'g>>) -> Vec<Expr<'g>>,
) -> Vec<Expr<'g>> {
    let joints = Joints::of(symbols);
    let n = symbols.arm().dof();
    let matrix = joints.block(composite::mass_matrix(chain));
    let net = joints.entries(net_force(symbols, chain));
    let (factors, qdd) = Factors::new(symbols.graph(), matrix.clone(), net);
    let qd = symbols.all(|joint| joint.qd);
    let qdd = symbols.of_all(&qdd);
    let of_links = derivatives::recursion(chain, &qd, &qdd).of_joints(symbols);
    let forces = force_derivatives(symbols, of_links);
    let mut values = forces.clone();
    for (b, x) in forces.chunks(n * n).zip(values.chunks_mut(n * n)) {
        for column in 0..n {
            let right_side = (0..n).map(|row| -b[row * n + column]).collect();
            for (row, entry) in solve(&factors, right_side).into_iter().enumerate() {
                x[row * n + column] = entry;
            }
        }
    }
    [
        values,
        factors.inverse().concat(),
        pivots(&factors, &matrix),
    ]
    .concat()
}

/// dT/dq_i = 1/2 sum dM_jk/dq_i qd_j qd_k = sum c_kij qd_j qd_k, from the symbols c[k][i][j].
fn gradient<'g>(zero: Expr<'g>, c: &[Vec<Vec<Expr<'g>>>], qd: &[Expr<'g>]) -> Vec<Expr<'g>> {
    let of_joint = |i: usize| {
        let rows: Vec<_> = c.iter().map(|c| dot(zero, &c[i], qd)).collect();
        dot(zero, &rows, qd)
    };
    (0..qd.len()).map(of_joint).collect()
}

/// The product of a matrix and a vector.
fn times<'g>(zero: Expr<'g>, matrix: &[Vec<Expr<'g>>], x: &[Expr<'g>]) -> Vec<Expr<'g>> {
    matrix.iter().map(|row| dot(zero, row, x)).collect()
}

fn dot<'g>(zero: Expr<'g>, a: &[Expr<'g>], b: &[Expr<'g>]) -> Expr<'g> {
    a.iter().zip(b).fold(zero, |sum, (&a, &b)| sum + a * b)
}

fn sum<'g>(a: Vec<Expr<'g>>, b: &[Expr<'g>]) -> Vec<Expr<'g>> {
    a.into_iter().zip(b).map(|(a, &b)| a + b).collect()
}
