//! The equations of an arm that a simulation solves.

use nalgebra::{Const, SMatrix, SVector};

#[cfg(feature = "std")]
use crate::Model;
use crate::dual::Dual;
use crate::factorisation::JointFactors;
use crate::size::Size;
use crate::{ForwardDynamics, NumericArm, Scalar, SingularMassMatrix, SizedMomenta};

/// Accelerations, and what a unit torque at each of some joints adds to them: columns of M^-1.
pub type Responses<D> = (<D as Size>::Vector, <D as Size>::Matrix);

/// An arm that a [`Simulation`](crate::Simulation) can move: its equations of motion, solved for the
/// accelerations, in doubles. `D` is its number of joints, `Const<N>`, or `Dyn` where it is known at run time alone.
///
/// Every arm with [`ForwardDynamics`] is one, and [`NewtonEuler`](crate::NewtonEuler) is one for any table.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be simulated: `forward_dynamics` was not asked for",
    note = "add it to its `functions:`, or write `functions: [default, ...]`, which holds it"
)]
pub trait EquationsOfMotion<D: Size> {
    /// The number of joints.
    fn size(&self) -> D;

    /// Joint accelerations qdd of `M(q) qdd + V(q, qd) + G(q) + K(q) + F(qd) = tau`.
    ///
    /// `q` in rad or m, `qd` per second, `tau` in N m or N.
    ///
    /// # Errors
    ///
    /// [`SingularMassMatrix`] where M(q) is not positive definite to working precision, or holds a NaN.
    fn accelerations(
        &self,
        q: &D::Vector,
        qd: &D::Vector,
        tau: &D::Vector,
    ) -> Result<D::Vector, SingularMassMatrix>;

    /// The accelerations, and the columns of M(q)^-1 that belong to `joints`; other columns are zero.
    ///
    /// # Errors
    ///
    /// As [`accelerations`](EquationsOfMotion::accelerations).
    fn accelerations_and_responses(
        &self,
        q: &D::Vector,
        qd: &D::Vector,
        tau: &D::Vector,
        joints: &D::Each<bool>,
    ) -> Result<Responses<D>, SingularMassMatrix>;

    /// The arm in positions and momenta, as the structure-preserving methods need it; `None` for an arm without
    /// these functions.
    fn in_momenta(&self) -> Option<&dyn SizedMomenta<D>>;
}

impl<R: ForwardDynamics<N>, const N: usize> EquationsOfMotion<Const<N>> for R {
    fn size(&self) -> Const<N> {
        Const
    }

    #[inline]
    fn accelerations(
        &self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        tau: &SVector<f64, N>,
    ) -> Result<SVector<f64, N>, SingularMassMatrix> {
        self.forward_dynamics(q, qd, tau)
    }

    /// A column of M^-1 is the derivative by a torque, which a dual number carries along.
    fn accelerations_and_responses(
        &self,
        q: &SVector<f64, N>,
        qd: &SVector<f64, N>,
        tau: &SVector<f64, N>,
        joints: &[bool; N],
    ) -> Result<Responses<Const<N>>, SingularMassMatrix> {
        let [positions, velocities] = [q, qd].map(|x| x.map(Dual::from_f64));
        let mut free = None;
        let mut columns = SMatrix::<f64, N, N>::zeros();
        for j in (0..N).filter(|j| joints[*j]) {
            let tau = SVector::from_fn(|i, _| Dual::new(tau[i], f64::from(u8::from(i == j))));
            let qdd = self.forward_dynamics(&positions, &velocities, &tau)?;
            free = Some(qdd.map(|entry| entry.value));
            columns.set_column(j, &qdd.map(|entry| entry.slope));
        }
        match free {
            Some(free) => Ok((free, columns)),
            None => Ok((self.accelerations(q, qd, tau)?, columns)),
        }
    }

    #[inline]
    fn in_momenta(&self) -> Option<&dyn SizedMomenta<Const<N>>> {
        self.momenta().map(|arm| arm as &dyn SizedMomenta<Const<N>>)
    }
}

impl<D: Size> EquationsOfMotion<D> for NumericArm<D> {
    fn size(&self) -> D {
        D::from_usize(self.dof())
    }

    fn accelerations(
        &self,
        q: &D::Vector,
        qd: &D::Vector,
        tau: &D::Vector,
    ) -> Result<D::Vector, SingularMassMatrix> {
        self.forward_dynamics(q, qd, tau)
    }

    fn accelerations_and_responses(
        &self,
        q: &D::Vector,
        qd: &D::Vector,
        tau: &D::Vector,
        joints: &D::Each<bool>,
    ) -> Result<Responses<D>, SingularMassMatrix> {
        let factors = JointFactors::new(self.dof(), self.mass_matrix(q))?;
        let available = tau.clone() - self.bias_force(q, qd);
        Ok((
            factors.solve(&available),
            inverse_columns(self.size(), &factors, joints),
        ))
    }

    fn in_momenta(&self) -> Option<&dyn SizedMomenta<D>> {
        Some(self)
    }
}

/// The columns of M^-1 that belong to `joints`; others are zero.
pub(crate) fn inverse_columns<D: Size>(
    size: D,
    factors: &JointFactors<D::Matrix>,
    joints: &D::Each<bool>,
) -> D::Matrix {
    let mut columns = size.matrix();
    for j in size.joints().filter(|j| joints[*j]) {
        let column = factors.solve(&size.vector_of(|i| f64::from(u8::from(i == j))));
        for i in size.joints() {
            columns[(i, j)] = column[i];
        }
    }
    columns
}

/// An arm besides its equations: its table, the names of its joints, and its energies.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no robot",
    note = "`robot_dynamics!` makes robots, from Denavit-Hartenberg tables"
)]
#[cfg(feature = "std")]
pub trait SizedModel<D: Size> {
    /// The table as numbers.
    fn sized_table(&self) -> D::Table;

    /// The names of the joints, from the base outwards.
    fn names(&self) -> D::Each<String>;

    /// Kinetic and potential energy, J; `None` for an arm without both functions.
    fn sized_energies(&self, q: &D::Vector, qd: &D::Vector) -> Option<[f64; 2]>;
}

#[cfg(feature = "std")]
impl<R: Model<N>, const N: usize> SizedModel<Const<N>> for R {
    fn sized_table(&self) -> crate::Table<N> {
        self.table()
    }

    fn names(&self) -> [String; N] {
        self.joint_names().map(String::from)
    }

    fn sized_energies(&self, q: &SVector<f64, N>, qd: &SVector<f64, N>) -> Option<[f64; 2]> {
        self.energies(q, qd)
    }
}
