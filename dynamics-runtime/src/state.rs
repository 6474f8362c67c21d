//! A state of an arm, and types of the values of functions there.

use nalgebra::{Const, SMatrix, SVector, Vector6};

use crate::Pose;
use crate::size::Size;

/// Position, velocity and acceleration of all joints. [`State`] is that of an arm whose number of joints the compiler
/// knows.
#[derive(Clone, Debug, PartialEq)]
pub struct SizedState<D: Size> {
    /// Joint positions, rad or m.
    pub q: D::Vector,
    /// Joint velocities, rad/s or m/s.
    pub qd: D::Vector,
    /// Joint accelerations, rad/s^2 or m/s^2.
    pub qdd: D::Vector,
}

/// Position, velocity and acceleration of `N` joints.
pub type State<const N: usize> = SizedState<Const<N>>;

impl<const N: usize> Copy for State<N> {}

/// Some functions have arguments that a state does not hold. Checks make them of the state, so that the state is all
/// that they choose: these arguments are as fast as the state, and none is a multiple of another argument of the same
/// function.
impl<D: Size> SizedState<D> {
    /// qd_r, a reference velocity.
    #[doc(hidden)]
    pub fn reference_velocity(&self) -> D::Vector {
        self.qdd.clone() * 0.25
    }

    /// qdd_r, a reference acceleration.
    #[doc(hidden)]
    pub fn reference_acceleration(&self) -> D::Vector {
        self.qd.clone() * 4.0 - self.qdd.clone() * 0.5
    }

    /// The rates of the accelerations.
    #[doc(hidden)]
    pub fn jerk(&self) -> D::Vector {
        self.qdd.clone() * -2.0 + self.qd.clone() * 8.0
    }

    /// The rates of the jerk.
    #[doc(hidden)]
    pub fn snap(&self) -> D::Vector {
        self.qdd.clone() * 8.0 - self.qd.clone() * 4.0
    }

    /// A force on the tip and a moment about its origin: the same at every state.
    #[doc(hidden)]
    pub fn wrench() -> Vector6<f64> {
        Vector6::new(5.0, -3.0, 8.0, 2.0, -1.0, 0.5)
    }
}

/// Place, position, velocity and acceleration of `N` joints on a base that moves; `V` is 6 + N.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FloatingState<const N: usize, const V: usize> {
    /// Where the base stands.
    pub base: Pose<f64>,
    /// Joint positions, rad or m.
    pub q: SVector<f64, N>,
    /// Linear and angular velocity of the base in its own axes, m/s and rad/s, then those of the joints.
    pub v: SVector<f64, V>,
    /// The rates of `v`.
    pub a: SVector<f64, V>,
}

/// A state on a base that stands in the world's axes.
impl<const N: usize> From<State<N>> for FloatingState<N, N> {
    fn from(State { q, qd, qdd }: State<N>) -> Self {
        FloatingState {
            base: Pose::identity(),
            q,
            v: qd,
            a: qdd,
        }
    }
}

#[cfg(feature = "std")]
impl<const N: usize, const V: usize> FloatingState<N, V> {
    /// Its velocities and accelerations as those of a state, which makes further arguments of functions of them.
    #[doc(hidden)]
    pub fn motion(&self) -> State<V> {
        State {
            q: SVector::zeros(),
            qd: self.v,
            qdd: self.a,
        }
    }
}

/// d2 tau/dq dq, d2 tau/dqd dqd, d2 tau/dq dqd and dM/dq, each a matrix for every joint force: entry
/// `[i][(j, k)]` is that of tau_i by q_j and q_k, by qd_j and qd_k, by q_j and qd_k, and dM_ij/dq_k.
pub type SecondDerivatives<T, const N: usize> = (
    [SMatrix<T, N, N>; N],
    [SMatrix<T, N, N>; N],
    [SMatrix<T, N, N>; N],
    [SMatrix<T, N, N>; N],
);

/// d qdd/dq, d qdd/dqd and d qdd/d tau, the inverse of M.
pub type AccelerationDerivatives<T, const N: usize> =
    (SMatrix<T, N, N>, SMatrix<T, N, N>, SMatrix<T, N, N>);
