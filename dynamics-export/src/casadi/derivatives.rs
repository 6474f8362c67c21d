//! Which programs have the derivatives of a function, and where among their values an entry stands.

use dynamics_symbolic::function::{Argument, Function, Request};
use dynamics_symbolic::robot::Robot;

/// A function with derivatives: the programs that have them.
pub(super) struct Derivatives {
    /// The functions whose values are the matrices of first derivatives, one for each argument of the function in order.
    first: &'static [Function],
    /// Functions of which derivatives by the pose of a base are made besides.
    on_a_base: &'static [Function],
    /// How second derivatives follow from those of the inverse dynamics.
    pub(super) second: Option<Second>,
}

/// How second derivatives follow from those of the inverse dynamics.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Second {
    /// They are the same.
    Same,
    /// The function solves the equation of inverse dynamics (`solved`).
    Solved,
}

const OF_INVERSE_DYNAMICS: Derivatives = Derivatives {
    first: &[Function::InverseDynamicsDerivatives, Function::MassMatrix],
    on_a_base: &[],
    second: Some(Second::Same),
};

/// Inverse dynamics without accelerations: their program reads zeros there.
const OF_BIAS_FORCE: Derivatives = Derivatives {
    first: &[Function::InverseDynamicsDerivatives],
    on_a_base: &[Function::MassMatrix],
    second: None,
};

const OF_FORWARD_DYNAMICS: Derivatives = Derivatives {
    first: &[Function::ForwardDynamicsDerivatives],
    on_a_base: &[],
    second: Some(Second::Solved),
};

const OF_CENTER_OF_MASS: Derivatives = Derivatives {
    first: &[Function::CenterOfMassJacobian],
    on_a_base: &[],
    second: None,
};

/// The derivatives of a method, where programs have them.
pub(super) fn derivatives(request: &Request) -> Option<&'static Derivatives> {
    match request.function()? {
        Function::InverseDynamics => Some(&OF_INVERSE_DYNAMICS),
        Function::BiasForce => Some(&OF_BIAS_FORCE),
        Function::ForwardDynamics | Function::ForwardDynamicsAba => Some(&OF_FORWARD_DYNAMICS),
        Function::CenterOfMass => Some(&OF_CENTER_OF_MASS),
        _ => None,
    }
}

impl Derivatives {
    /// The program of the first derivatives.
    pub(super) fn first(&self, robot: &Robot) -> Request {
        let on_a_base = if robot.freedoms().has_base() {
            self.on_a_base
        } else {
            &[]
        };
        match (self.first, on_a_base) {
            ([function], []) => Request::from(*function),
            (first, besides) => {
                let functions = first.iter().chain(besides).copied();
                Request::fused("first_derivatives", functions)
            }
        }
    }

    /// The program of the second ones.
    pub(super) fn second(&self) -> Option<Request> {
        let second = self.second.as_ref();
        second.map(|_| Request::from(Function::InverseDynamicsSecondDerivatives))
    }
}

/// Where the second derivative of force `i` by two entries of arguments stands: the array of matrices, and row and column
/// in its matrix `i`. `None` where it is zero always.
pub(super) fn second_derivative(
    one: (Argument, usize),
    other: (Argument, usize),
) -> Option<(usize, usize, usize)> {
    use Argument::{Acceleration, Position, Velocity};
    match ((one.0, other.0), one.1, other.1) {
        ((Position, Position), j, k) => Some((0, j, k)),
        ((Velocity, Velocity), j, k) => Some((1, j, k)),
        ((Position, Velocity), j, k) | ((Velocity, Position), k, j) => Some((2, j, k)),
        ((Acceleration, Position), j, k) | ((Position, Acceleration), k, j) => Some((3, j, k)),
        _ => None,
    }
}
