//! Taylor series of the motion, order by order from the generated equations.
//!
//! With q(t) = sum q_k t^k, each quantity of the equations is a series too, and its coefficient of
//! order k follows from coefficients of order up to k (automatic differentiation of ordinary
//! differential equations: A. Jorba, M. Zou, *A software package for the numerical integration of
//! ODEs by means of high-order Taylor methods*, Experimental Mathematics 14 (2005), section 2):
//!
//! ```text
//! c = a + b       c_k = a_k + b_k
//! c = a b         c_k = a_0 b_k + a_k b_0 + sum_{0<j<k} a_j b_{k-j}
//! s = sin q       (k + 1) s_{k+1} = (cos q  qd)_k
//! c = cos q       (k + 1) c_{k+1} = -(sin q  qd)_k
//! ```
//!
//! A joint that follows another one by a factor turns by that multiple of q, at that multiple of qd.
//!
//! The equations of motion are not solved for qdd: the coefficient of order k of tau = M(q) qdd + V + G + K + F is linear
//! in the unknown qdd_k, with the matrix M(q_0) whatever k:
//!
//! ```text
//! M(q_0) qdd_k = tau_k - (M qdd + V + G + K + F)_k  with qdd_k = 0 on the right.
//! ```
//!
//! So M is factored once for all orders, and no series is divided. Inner sums depend on lower orders alone: those of all
//! products are computed at once, in the lanes of vector registers ([`Block`]), before the straight-line code runs.
//!
//! The program is the inverse dynamics, whose equations are linear in the unknown coefficient qdd_k, with the matrix
//! M(q_0) at every order. So the mass matrix is factored once a step, and the series need no pivots and quotients:
//! for the PUMA 560 119 products of two series instead of 205 and four quotients. Values that depend on the
//! accelerations are evaluated twice at each order, with qdd_k = 0 and with its value.
//!
//! The inner sum of a product, sum a_j b_(k-j) for 0 < j < k, knows only lower orders. The inner sums of all
//! products are computed together, eight products to a block, and a pass begins the sums of four orders, because
//! reading the rows
//! takes longer than multiplying. Products with a common factor share a block that stores it once. Code is compiled
//! for the build's instructions and, on x86 without them, for AVX2 and AVX-512 with fused products (`fused`): the
//! digits of a motion depend on the processor, in the last places.

mod coefficients;
mod expansion;
mod products;
mod term;

use nalgebra::{SMatrix, SVector};

use crate::{Inputs, Model, Scalar, SingularMassMatrix};
pub use coefficients::{MAX_TAYLOR_ORDER, TaylorCoefficients};
pub use expansion::Expansion;
#[cfg(feature = "std")]
pub use expansion::mass_matrix;
pub use products::{Block, Common, ProductTable, Products};
pub use term::SeriesTerm;

/// An arm whose motion can be expanded in a Taylor series: `functions: [taylor_series]`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no Taylor series of its motion: `taylor_series` is not in `functions`",
    note = "add it: `functions: [default, taylor_series]`"
)]
pub trait TaylorDynamics<const N: usize>: Model<N> {
    /// Room for the products of two series in the equations of motion.
    #[doc(hidden)]
    type Products<T: Scalar>: Products<T>;

    /// M(q), with the sines of the joint positions from `sines`.
    #[doc(hidden)]
    fn leading_matrix<T: Scalar>(
        &self,
        sines: &impl Inputs<T>,
        q: &SVector<T, N>,
    ) -> SMatrix<T, N, N>;

    /// The equations of motion at one order.
    #[doc(hidden)]
    fn series_term<T: Scalar>(&self, term: &mut impl SeriesTerm<T, N>);

    /// Taylor coefficients q_0, q_1, ... of the motion q(t) = sum q_k t^k of the arm from `q` and
    /// `qd` at t = 0 under the constant torque `tau`.
    ///
    /// `q` in rad or m, `qd` per second, `tau` in N m or N; q_k in rad or m per s^k. Orders above
    /// [`MAX_TAYLOR_ORDER`] and below 2 are taken as these. The sign in Coulomb friction is that of
    /// `qd`, as if it did not change: the series is that of the motion up to the first reversal of
    /// a joint.
    ///
    /// # Errors
    ///
    /// [`SingularMassMatrix`] where M(q) is not positive definite to working precision, or holds a
    /// NaN. Never panics, never allocates; coefficients too large for `T` are infinite or NaN, and so
    /// are those after them.
    fn taylor_series<T: Scalar>(
        &self,
        q: &SVector<T, N>,
        qd: &SVector<T, N>,
        tau: &SVector<T, N>,
        order: usize,
    ) -> Result<TaylorCoefficients<T, N>, SingularMassMatrix>
    where
        Self: Sized,
    {
        let mut expansion = Expansion::<Self, T, N>::new(q);
        expansion.begin(self, q, qd, tau)?;
        expansion.extend(self, order);
        Ok(*expansion.coefficients())
    }
}
