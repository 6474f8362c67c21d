//! The equations of a robot that a simulation solves.

mod moving_base;

use nalgebra::{Const, SMatrix, SVector};

use crate::dual::Dual;
use crate::factorisation::JointFactors;
use crate::place::{OnBase, Place, Sizes, Velocities};
use crate::size::Size;
use crate::{ForwardDynamics, Model, Scalar, SingularMassMatrix, SizedMomenta};

/// Accelerations, and what a unit torque at each of some joints adds to them: columns of M^-1.
pub type Responses<D> = (<D as Size>::Vector, <D as Size>::Matrix);

/// A robot that a `Simulation` can move: its equations of motion, solved for the accelerations, in
/// doubles. For an arm `K` is its number of joints, `Const<N>`, or `Dyn` where it is known at run time alone; on a base that
/// moves it is [`OnBase`]. The compiler finds out which one it is.
///
/// Every robot with a generated `forward_dynamics` is one, and each arm with [`ForwardDynamics`]. So are
/// `NewtonEuler` and `FloatingNewtonEuler` for any table.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be simulated: `forward_dynamics` is not in `functions`",
    note = "add it to its `functions:`, or write `functions: [default, ...]`, which holds it"
)]
pub trait EquationsOfMotion<K: Sizes> {
    /// The number of joints.
    fn joints(&self) -> K::Joints;

    /// The number of velocities: that of joints, and six more on a base that moves.
    fn size(&self) -> K::Freedoms;

    /// Accelerations qdd of `M(q) qdd + V(q, qd) + G + K(q) + F(qd) = tau`.
    ///
    /// `qd` per second, `tau` in N m or N.
    ///
    /// # Errors
    ///
    /// [`SingularMassMatrix`] where M(q) is not positive definite to working precision, or holds a NaN.
    fn accelerations(
        &self,
        place: &Place<K::Joints>,
        qd: &Velocities<K>,
        tau: &Velocities<K>,
    ) -> Result<Velocities<K>, SingularMassMatrix>;

    /// The accelerations, and the columns of M(q)^-1 that belong to `freedoms`; other columns are zero.
    ///
    /// # Errors
    ///
    /// As [`accelerations`](EquationsOfMotion::accelerations).
    fn accelerations_and_responses(
        &self,
        place: &Place<K::Joints>,
        qd: &Velocities<K>,
        tau: &Velocities<K>,
        freedoms: &<K::Freedoms as Size>::Each<bool>,
    ) -> Result<Responses<K::Freedoms>, SingularMassMatrix>;

    /// The arm in positions and momenta, as the structure-preserving methods need it; `None` for a robot without
    /// these functions.
    fn in_momenta(&self) -> Option<&dyn SizedMomenta<K::Freedoms>> {
        None
    }
}

impl<R: ForwardDynamics<N>, const N: usize> EquationsOfMotion<Const<N>> for R {
    fn joints(&self) -> Const<N> {
        Const
    }

    fn size(&self) -> Const<N> {
        Const
    }

    #[inline]
    fn accelerations(
        &self,
        place: &Place<Const<N>>,
        qd: &SVector<f64, N>,
        tau: &SVector<f64, N>,
    ) -> Result<SVector<f64, N>, SingularMassMatrix> {
        self.forward_dynamics(&place.q, qd, tau)
    }

    fn accelerations_and_responses(
        &self,
        place: &Place<Const<N>>,
        qd: &SVector<f64, N>,
        tau: &SVector<f64, N>,
        joints: &[bool; N],
    ) -> Result<Responses<Const<N>>, SingularMassMatrix> {
        let [q, qd] = [&place.q, qd].map(|x| x.map(Dual::from_f64));
        responses(tau, joints, |tau| self.forward_dynamics(&q, &qd, tau))
    }

    #[inline]
    fn in_momenta(&self) -> Option<&dyn SizedMomenta<Const<N>>> {
        self.momenta().map(|arm| arm as &dyn SizedMomenta<Const<N>>)
    }
}

/// Accelerations under some torques, and the columns of M^-1 that belong to `joints`. A column is the derivative by a torque,
/// which a dual number carries along.
fn responses<const N: usize>(
    tau: &SVector<f64, N>,
    joints: &[bool; N],
    under: impl Fn(&SVector<Dual, N>) -> Result<SVector<Dual, N>, SingularMassMatrix>,
) -> Result<Responses<Const<N>>, SingularMassMatrix> {
    let along = |j| SVector::from_fn(|i, _| Dual::new(tau[i], f64::from(u8::from(i == j))));
    let mut columns = SMatrix::<f64, N, N>::zeros();
    let mut free = None;
    for j in (0..N).filter(|j| joints[*j]) {
        let qdd = under(&along(j))?;
        columns.set_column(j, &qdd.map(|entry| entry.slope));
        free = Some(qdd);
    }
    // Along no torque, where there is no such joint.
    let free = free.map_or_else(|| under(&along(N)), Ok)?;
    Ok((free.map(|entry| entry.value), columns))
}

/// The columns of M^-1 that belong to `joints`; others are zero.
pub fn inverse_columns<D: Size>(
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
pub trait SizedModel<K: Sizes> {
    /// The table as numbers.
    fn sized_table(&self) -> <K::Joints as Size>::Table;

    /// The names of the joints, from the base outwards.
    fn names(&self) -> <K::Joints as Size>::Each<String>;

    /// Kinetic and potential energy, J; `None` for a robot without both functions.
    fn sized_energies(
        &self,
        place: &Place<K::Joints>,
        velocities: &Velocities<K>,
    ) -> Option<[f64; 2]>;
}

impl<R: Model<N>, const N: usize> SizedModel<Const<N>> for R {
    fn sized_table(&self) -> crate::Table<N> {
        self.table()
    }

    fn names(&self) -> [String; N] {
        self.joint_names().map(String::from)
    }

    fn sized_energies(&self, place: &Place<Const<N>>, qd: &SVector<f64, N>) -> Option<[f64; 2]> {
        self.energies(&place.q, qd)
    }
}

impl<R: Model<N, V>, const N: usize, const V: usize> SizedModel<OnBase<N, V>> for R {
    fn sized_table(&self) -> crate::Table<N> {
        self.table()
    }

    fn names(&self) -> [String; N] {
        self.joint_names().map(String::from)
    }

    fn sized_energies(&self, place: &Place<Const<N>>, v: &SVector<f64, V>) -> Option<[f64; 2]> {
        self.energies_on(&place.pose(), &place.q, v)
    }
}
