//! The outputs of each function, on one chain.

use super::chain::Chain;
use super::symbols::Symbols;
use super::{articulated, christoffel, composite, energy, kinematics, recursive, solve};
use crate::expr::Expr;
use crate::function::Function;
use crate::linear::Vector3;
use crate::robot::{Interpretation, Robot};

/// How a function is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// By the recursion that is made for it; forward dynamics by factoring the mass matrix.
    Recursive,
    /// From other functions: M qdd + V + G, the contraction of the Christoffel
    /// symbols, or inverse dynamics at rest.
    Assembled,
    /// Forward dynamics by articulated bodies, without the mass matrix.
    Articulated,
}

impl Form {
    /// The forms that may be the shortest. Assembled motions grow with a higher
    /// power of the number of joints: they win for up to three.
    pub fn of(function: Function, dof: usize) -> &'static [Form] {
        match function {
            Function::GravityVector => &[Form::Recursive, Form::Assembled],
            Function::ForwardDynamics => &[Form::Recursive, Form::Articulated],
            Function::InverseDynamics | Function::BiasForce | Function::CoriolisVector
                if dof <= 3 =>
            {
                &[Form::Recursive, Form::Assembled]
            }
            _ => &[Form::Recursive],
        }
    }
}

/// What a function puts out, in the order of its contract: matrices by rows.
/// Forward dynamics: the accelerations, the pivots, and M's diagonal.
pub fn outputs<'g>(
    symbols: &mut Symbols<'g>,
    robot: &Robot,
    chain: &Chain<'g>,
    function: Function,
    form: Form,
) -> Vec<Expr<'g>> {
    if form == Form::Assembled {
        return assembled(symbols, robot, chain, function);
    }
    let graph = symbols.graph();
    let (zero, one) = (graph.zero(), graph.one());
    let still = vec![zero; robot.rows.len()];
    let weightless = Vector3::splat(zero);
    let qd = symbols.all(|joint| joint.qd);
    let qdd = symbols.all(|joint| joint.qdd);
    match function {
        Function::MassMatrix => composite::mass_matrix(chain).concat(),
        Function::CoriolisVector => recursive::inverse_dynamics(chain, &qd, &still, weightless),
        Function::GravityVector => energy::gravity_vector(chain),
        Function::FrictionVector => friction(symbols, robot),
        Function::InverseDynamics => {
            let forces = recursive::inverse_dynamics(chain, &qd, &qdd, chain.gravity);
            sum(forces, &friction(symbols, robot))
        }
        Function::BiasForce => {
            let forces = recursive::inverse_dynamics(chain, &qd, &still, chain.gravity);
            sum(forces, &friction(symbols, robot))
        }
        Function::ForwardDynamics => forward_dynamics(symbols, robot, chain, form),
        Function::KineticEnergy => vec![energy::kinetic_energy(graph, chain, &qd)],
        Function::PotentialEnergy => vec![energy::potential_energy(chain)],
        Function::CoriolisMatrix => {
            let symbols = christoffel::christoffel(graph, chain);
            symbols
                .iter()
                .flatten()
                .map(|row| dot(zero, row, &qd))
                .collect()
        }
        Function::CoriolisCoefficients => {
            let n = robot.rows.len();
            let pairs: Vec<_> = (0..n)
                .flat_map(|j| (j + 1..n).map(move |k| (j, k)))
                .collect();
            let symbols = christoffel::christoffel(graph, chain);
            symbols
                .iter()
                .flat_map(|c| pairs.iter().map(|&(j, k)| c[j][k] + c[k][j]))
                .collect()
        }
        Function::CentrifugalCoefficients => {
            let symbols = christoffel::christoffel(graph, chain);
            symbols
                .iter()
                .flat_map(|c| (0..c.len()).map(|j| c[j][j]))
                .collect()
        }
        Function::ForwardKinematics => {
            let frames = kinematics::frames(symbols, robot);
            frames
                .last()
                .map(|frame| frame.homogeneous(zero, one))
                .unwrap_or_default()
        }
        Function::LinkPoses => {
            let frames = kinematics::frames(symbols, robot);
            frames
                .iter()
                .flat_map(|frame| frame.homogeneous(zero, one))
                .collect()
        }
        Function::Jacobian => kinematics::jacobian(symbols, robot),
    }
}

/// Accelerations, pivots, and the diagonal of M.
fn forward_dynamics<'g>(
    symbols: &mut Symbols<'g>,
    robot: &Robot,
    chain: &Chain<'g>,
    form: Form,
) -> Vec<Expr<'g>> {
    let bias = outputs(symbols, robot, chain, Function::BiasForce, Form::Recursive);
    let applied = symbols.all(|joint| joint.tau).into_iter();
    let net: Vec<_> = applied.zip(bias).map(|(tau, bias)| tau - bias).collect();
    let matrix = composite::mass_matrix(chain);
    let diagonal = (0..matrix.len()).map(|i| matrix[i][i]).collect();
    let solution = match form {
        Form::Articulated => articulated::solve(chain, &net),
        _ => solve::solve(symbols.graph(), matrix, net),
    };
    [solution.x, solution.pivots, diagonal].concat()
}

/// The functions that have a second form.
fn assembled<'g>(
    symbols: &mut Symbols<'g>,
    robot: &Robot,
    chain: &Chain<'g>,
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
        Function::BiasForce => {
            let motion = assembled(symbols, robot, chain, Function::CoriolisVector);
            let gravity = energy::gravity_vector(chain);
            sum(sum(motion, &gravity), &friction(symbols, robot))
        }
        Function::InverseDynamics => {
            let qdd = symbols.all(|joint| joint.qdd);
            let inertial = composite::mass_matrix(chain)
                .iter()
                .map(|row| dot(zero, row, &qdd))
                .collect();
            sum(
                inertial,
                &assembled(symbols, robot, chain, Function::BiasForce),
            )
        }
        Function::GravityVector => {
            let still = vec![zero; robot.rows.len()];
            recursive::inverse_dynamics(chain, &still, &still, chain.gravity)
        }
        _ => outputs(symbols, robot, chain, function, Form::Recursive),
    }
}

/// F_i = viscous_i qd_i + coulomb_i sign(qd_i)
fn friction<'g>(symbols: &mut Symbols<'g>, robot: &Robot) -> Vec<Expr<'g>> {
    let force = |(i, row): (usize, &crate::robot::Row)| {
        let joint = *symbols.joint(i);
        symbols.value(&row.viscous) * joint.qd + symbols.value(&row.coulomb) * joint.sign
    };
    robot.rows.iter().enumerate().map(force).collect()
}

fn dot<'g>(zero: Expr<'g>, a: &[Expr<'g>], b: &[Expr<'g>]) -> Expr<'g> {
    a.iter().zip(b).fold(zero, |sum, (&a, &b)| sum + a * b)
}

fn sum<'g>(a: Vec<Expr<'g>>, b: &[Expr<'g>]) -> Vec<Expr<'g>> {
    a.into_iter().zip(b).map(|(a, &b)| a + b).collect()
}
