//! Functions that solve with M, their values bounded by residuals.

use nalgebra::{Const, Matrix6, SMatrix, SVector};
#[cfg(feature = "std")]
use nalgebra::{DMatrix, DVector};

use super::outward::Bound;
use super::rounded::Magnitude;
use super::solution::Verification;
use super::{Certified, Rounded};
use crate::function::{Entries, Function, Of, functions};
use crate::inputs::Evaluated;
use crate::{
    AccelerationDerivatives, ForwardDynamics, InverseDynamics, MassMatrix, Scalar,
    SingularMassMatrix,
};

/// A vector for each joint, three of them, and a square matrix.
type Joints<const N: usize> = Entries<N, 1>;
type State<const N: usize> = (Joints<N>, Joints<N>, Joints<N>);
type Square<const N: usize> = Entries<N, N>;

/// The numbers that bounds are kept in.
type Size<F> = <F as Rounded>::Magnitude;

/// A vector of numbers with their errors.
type Vector<F, const N: usize> = SVector<Certified<F>, N>;

/// `forward_dynamics`, with bounds that are sharp for long arms too.
///
/// The values are those of the plain method, bit for bit. Its bounds on [`Certified`] numbers grow some threefold with
/// each joint, because errors that cancel in an elimination are added up. This function returns the smaller one of that
/// bound and of a bound by the residual tau - tau(q, qd, qdd) of the computed accelerations, by `inverse_dynamics`, times
/// a proven bound of |M^-1| from `mass_matrix` (S. M. Rump, *Verification methods: rigorous results using floating-point
/// arithmetic*, Acta Numerica 19 (2010), section 10). For single precision the residual is evaluated in double.
///
/// Where M may be singular within its own errors, bounds are infinite.
///
/// # Errors
///
/// [`SingularMassMatrix`] where the plain method returns it. Never panics, never allocates.
///
/// ```
/// use robot_dynamics::nalgebra::Vector2;
/// use robot_dynamics::{Certified, certified, robot_dynamics};
///
/// robot_dynamics! {
///     /// Two point masses at the ends of two links.
///     struct Arm;
///     convention: modified,
///     gravity: [0, -9.81, 0],
///     joints: [
///         shoulder: revolute { mass: 1.2, com: [0.4, 0, 0] },
///         elbow: revolute { a: 0.4, mass: 0.7, com: [0.3, 0, 0] },
///     ],
/// }
///
/// let [q, qd, tau] = [[0.3, -1.1], [2.0, -1.0], [5.0, 1.0]].map(Vector2::from);
/// let [x, xd, force] = [q, qd, tau].map(|x| x.map(Certified::exact));
/// let qdd = certified::forward_dynamics(&Arm, &x, &xd, &force)?;
/// assert_eq!(qdd.map(|x| x.value()), Arm.forward_dynamics(&q, &qd, &tau)?);
/// assert!(qdd.iter().all(|x| x.bound() < 1e-12));
/// # Ok::<(), robot_dynamics::SingularMassMatrix>(())
/// ```
pub fn forward_dynamics<A, F, const N: usize>(
    arm: &A,
    q: &SVector<Certified<F>, N>,
    qd: &SVector<Certified<F>, N>,
    tau: &SVector<Certified<F>, N>,
) -> Result<SVector<Certified<F>, N>, SingularMassMatrix>
where
    A: ForwardDynamics<N> + InverseDynamics<N> + MassMatrix<N>,
    F: Rounded,
{
    let qdd = arm.forward_dynamics(q, qd, tau)?;
    Ok(accelerations(arm, [q, qd, tau], qdd))
}

/// `forward_dynamics_aba`, bounded as [`forward_dynamics`] is.
///
/// # Errors
///
/// [`SingularMassMatrix`] where the plain method returns it. Never panics, never allocates.
pub fn forward_dynamics_aba<A, F, const N: usize>(
    arm: &A,
    q: &SVector<Certified<F>, N>,
    qd: &SVector<Certified<F>, N>,
    tau: &SVector<Certified<F>, N>,
) -> Result<SVector<Certified<F>, N>, SingularMassMatrix>
where
    A: Function<functions::ForwardDynamicsAba, N, Arguments = State<N>, Values = Joints<N>>
        + InverseDynamics<N>
        + MassMatrix<N>,
    F: Rounded,
{
    let qdd = value(arm, functions::ForwardDynamicsAba, (*q, *qd, *tau))?;
    Ok(accelerations(arm, [q, qd, tau], qdd))
}

/// `forward_dynamics_derivatives`, bounded by the residuals of the equations that the derivatives satisfy:
/// M d qdd/dq + d tau/dq = 0, M d qdd/dqd + d tau/dqd = 0 and M M^-1 = 1.
///
/// The derivatives of tau are those of `inverse_dynamics_derivatives` at the exact accelerations, which are known up to
/// a bound, by `inverse_dynamics`. Otherwise as [`forward_dynamics`].
///
/// # Errors
///
/// [`SingularMassMatrix`] where the plain method returns it. Never panics, never allocates.
pub fn forward_dynamics_derivatives<A, F, const N: usize>(
    arm: &A,
    q: &SVector<Certified<F>, N>,
    qd: &SVector<Certified<F>, N>,
    tau: &SVector<Certified<F>, N>,
) -> Result<AccelerationDerivatives<Certified<F>, N>, SingularMassMatrix>
where
    A: Function<
            functions::ForwardDynamicsDerivatives,
            N,
            Arguments = State<N>,
            Values = (Square<N>, Square<N>, Square<N>),
        > + Function<
            functions::InverseDynamicsDerivatives,
            N,
            Arguments = State<N>,
            Values = (Square<N>, Square<N>),
        > + InverseDynamics<N>
        + MassMatrix<N>,
    F: Rounded,
{
    let found = value(arm, functions::ForwardDynamicsDerivatives, (*q, *qd, *tau))?;
    let [q, qd, tau] = [q, qd, tau].map(widened);
    let matrix = arm.mass_matrix(&q);
    let Some(verification) = Verification::of(&matrix) else {
        return Ok(found);
    };
    let qdd = enclosed(arm, &verification, [&q, &qd, &tau]);
    let forces = value(arm, functions::InverseDynamicsDerivatives, (q, qd, qdd))?;
    let (by_position, by_velocity) = forces;
    let one =
        SMatrix::from_fn(|i, j| Certified::exact(F::Wide::from_f64(f64::from(u8::from(i == j)))));
    let sharpened = |found: SMatrix<Certified<F>, N, N>, b: SMatrix<Certified<F::Wide>, N, N>| {
        by_columns(found, |x, j| {
            let residual = b.column(j) - matrix * x;
            verification.error(&residual)
        })
    };
    Ok((
        sharpened(found.0, -by_position),
        sharpened(found.1, -by_velocity),
        sharpened(found.2, one),
    ))
}

/// `operational_inertia_inverse`, J M^-1 J', bounded by the residual of M X = J' with `jacobian` and `mass_matrix`.
/// Otherwise as [`forward_dynamics`].
///
/// # Errors
///
/// [`SingularMassMatrix`] where the plain method returns it. Never panics, never allocates.
pub fn operational_inertia_inverse<A, F, const N: usize>(
    arm: &A,
    q: &SVector<Certified<F>, N>,
) -> Result<Matrix6<Certified<F>>, SingularMassMatrix>
where
    A: Function<
            functions::OperationalInertiaInverse,
            N,
            Arguments = (Joints<N>,),
            Values = Entries<6, 6>,
        > + Function<functions::Jacobian, N, Arguments = (Joints<N>,), Values = Entries<6, N>>
        + MassMatrix<N>,
    F: Rounded,
{
    let found = value(arm, functions::OperationalInertiaInverse, (*q,))?;
    let q = widened(q);
    let matrix = arm.mass_matrix(&q);
    let Some(verification) = Verification::of(&matrix) else {
        return Ok(found);
    };
    let jacobian = value(arm, functions::Jacobian, (q,))?;
    Ok(by_columns(found, |found, j| {
        let b = jacobian.row(j).transpose();
        let x = verification.approximate(&b);
        let error = verification.error(&(b - matrix * x.map(Certified::exact)));
        let solution = SVector::<_, N>::from_fn(|i, _| Certified::new(x[i], error[i]));
        (found - jacobian * solution).map(Certified::largest)
    }))
}

/// The value of a generated function.
fn value<A: Function<F, N>, F, T: Scalar, const N: usize>(
    arm: &A,
    function: F,
    arguments: Of<A::Arguments, T>,
) -> Result<Of<A::Values, T>, SingularMassMatrix> {
    let value = arm.at(function, &Evaluated, &arguments);
    value.map_err(Into::into)
}

/// Computed accelerations, each with the smaller one of its bound and the bound by its residual.
fn accelerations<A: InverseDynamics<N> + MassMatrix<N>, F: Rounded, const N: usize>(
    arm: &A,
    arguments: [&Vector<F, N>; 3],
    qdd: Vector<F, N>,
) -> Vector<F, N> {
    let [q, qd, tau] = arguments.map(widened);
    let Some(verification) = Verification::of(&arm.mass_matrix(&q)) else {
        return qdd;
    };
    by_columns(qdd, |x, _| {
        verification.error(&(tau - arm.inverse_dynamics(&q, &qd, &x)))
    })
}

/// The same where M is known already, and so is the residual `left` of accelerations nearby: the residual of `qdd` is
/// then left - M (qdd - nearby).
#[cfg(feature = "std")]
pub fn accelerations_near(
    (nearby, left): (&DVector<f64>, &DVector<Certified>),
    mass_matrix: &DMatrix<Certified>,
    qdd: DVector<Certified>,
) -> DVector<Certified> {
    let Some(verification) = Verification::of(mass_matrix) else {
        return qdd;
    };
    let steps = qdd.zip_map(nearby, |x, nearby| {
        Certified::exact(x.value) - Certified::exact(nearby)
    });
    let errors = verification.error(&(left - mass_matrix * steps));
    qdd.zip_map(&errors, |x, error| {
        Certified::new(x.value, x.error.min(error))
    })
}

/// The exact accelerations: approximate ones, computed by M^-1 and improved once by their residual, with a bound of
/// their error.
fn enclosed<A: InverseDynamics<N>, F: Rounded, const N: usize>(
    arm: &A,
    verification: &Verification<F, Const<N>>,
    [q, qd, tau]: [&Vector<F, N>; 3],
) -> Vector<F, N> {
    let residual = |x: &SVector<F, N>| tau - arm.inverse_dynamics(q, qd, &x.map(Certified::exact));
    let mut qdd = SVector::repeat(F::ZERO);
    for _ in 0..2 {
        let step = verification.approximate(&residual(&qdd));
        qdd = qdd.zip_map(&step, |x, step| x + step);
    }
    let error = verification.error(&residual(&qdd));
    SVector::from_fn(|i, _| Certified::new(qdd[i], error[i]))
}

/// The numbers that were found, each with the smaller one of its bound and the bound that `error` returns for the
/// values of its column. `error` works in the precision of residuals.
fn by_columns<F: Rounded, const R: usize, const C: usize>(
    found: SMatrix<Certified<F>, R, C>,
    error: impl Fn(Vector<F::Wide, R>, usize) -> SVector<Bound<Size<F::Wide>>, R>,
) -> SMatrix<Certified<F>, R, C> {
    let errors: [_; C] = core::array::from_fn(|j| {
        let values = found.column(j).map(|x| Certified::exact(x.value()));
        error(widened(&values), j)
    });
    SMatrix::from_fn(|i, j| {
        let Certified { value, error } = found[(i, j)];
        let by_residual = Bound::new(Size::<F>::at_least(errors[j][i].get().double()));
        Certified::new(value, error.min(by_residual))
    })
}

/// The same numbers and errors in the precision of residuals.
fn widened<F: Rounded, const N: usize>(x: &Vector<F, N>) -> Vector<F::Wide, N> {
    x.map(|x| {
        let value = F::Wide::from_f64(x.value.to_f64());
        let error = Size::<F::Wide>::at_least(x.error.get().double());
        Certified::new(value, Bound::new(error))
    })
}
