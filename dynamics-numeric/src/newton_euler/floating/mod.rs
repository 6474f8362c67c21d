//! Dynamics of a robot whose base moves, numerically, from its table.
//!
//! The recursions are those of an arm. They begin with the twist and the acceleration of the base, and what the links hand on
//! to the base is what moves it.

use dynamics_runtime::table::AsArm as _;
use dynamics_runtime::{JointMatrix as _, Pose, Size};
use nalgebra::Const;

use super::base::Footing;
use super::{NumericArm, Placed};

/// The numeric dynamics of a robot with `N` joints on a base that moves, read from its [`Table`](dynamics_runtime::Table). `V` is
/// 6 + N.
///
/// The methods are named like the generated functions that are compared with them, and take and return the same quantities.
/// `base` is where the base stands; `q` has the positions of the joints, rad or m. Velocities `v` are `V` numbers: the linear
/// velocity of the origin of the base's frame, its angular velocity, **both in the axes of the base**, and the rates of the
/// joints. Accelerations are the time derivatives of these numbers. Forces are the force at that origin and the moment about
/// it, in the same axes, then the torques or forces of the joints.
///
/// No method panics, unless a frame is not there, or allocates. Only the two of forward dynamics can fail; input that is not
/// finite propagates. Functions of the tip are NaN where there is none, as those of [`NewtonEuler`](crate::NewtonEuler).
///
/// ```
/// use robot_dynamics::{FloatingNewtonEuler, Pose, nalgebra::SVector};
/// use robot_dynamics::table::{Convention, FloatingBase, JointType, Row, Table};
///
/// // A satellite of 100 kg with a wheel of 2 kg.
/// let inertia = [10.0, 10.0, 10.0, 0.0, 0.0, 0.0];
/// let wheel = Row { mass: 2.0, inertia: [0.1, 0.1, 0.2, 0.0, 0.0, 0.0], ..Row::new(JointType::Revolute) };
/// let satellite = FloatingNewtonEuler::<1, 7>::new(&Table {
///     floating: Some(FloatingBase { mass: 100.0, com: [0.0; 3], inertia }),
///     ..Table::new(Convention::Modified, [0.0; 3], [wheel])
/// });
///
/// // A moment of 1 N m at the wheel turns the satellite the other way.
/// let still = SVector::zeros();
/// let torque = SVector::from([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]);
/// let a = satellite.forward_dynamics(&Pose::identity(), &SVector::from([0.0]), &still, &torque)?;
/// assert!((a[5] + 0.1).abs() < 1e-12 && (a[6] - 5.1).abs() < 1e-12);
/// # Ok::<(), robot_dynamics::SingularMassMatrix>(())
/// ```
pub type FloatingNewtonEuler<const N: usize, const V: usize> = NumericFloating<Const<N>, Const<V>>;

/// The numeric dynamics of a robot on a base that moves: [`FloatingNewtonEuler`] where the compiler knows the numbers of
/// joints and of velocities. Where they are known at run time alone, `NumericFloating<Dyn, Dyn>` has the same methods.
#[derive(Clone, Debug)]
pub struct NumericFloating<D: Size, V: Size>(NumericArm<D, V>);

impl<D: Size, V: Size> NumericFloating<D, V> {
    /// Reads the table.
    ///
    /// # Panics
    ///
    /// If the base of the table stands, or V is not 6 + N; as [`NewtonEuler::new`](crate::NewtonEuler::new) besides.
    pub fn new(table: &D::Table) -> Self {
        let freedoms = 6 + table.arm().rows.len();
        let declared = V::try_to_usize().unwrap_or(freedoms);
        assert_eq!(
            declared, freedoms,
            "velocities of the base and of the joints"
        );
        let arm = NumericArm::read(table, V::from_usize(freedoms));
        assert!(
            arm.body.is_some(),
            "a table with `floating`: its base moves"
        );
        NumericFloating(arm)
    }

    /// The number of its velocities, 6 + N.
    pub fn dof(&self) -> usize {
        self.0.dof()
    }

    /// Generalized momentum p = M v: linear and angular momentum of all bodies about the origin of the base's frame, in the
    /// axes of the base, then the momenta of the joints.
    pub fn generalized_momentum(&self, q: &D::Vector, v: &V::Vector) -> V::Vector {
        self.mass_matrix(q).times(v)
    }

    /// Rate of the generalized momentum without applied forces, C' v - G - K - F, with the C of
    /// [`coriolis_matrix`](Self::coriolis_matrix): d(M v)/dt is the sum of it and tau.
    pub fn momentum_bias(&self, base: &Pose<f64>, q: &D::Vector, v: &V::Vector) -> V::Vector {
        let (coriolis, size) = (self.coriolis_matrix(q, v), self.0.freedoms);
        let of_velocity = size.vector_of(|j| size.joints().map(|i| coriolis[(i, j)] * v[i]).sum());
        of_velocity - self.gravity_vector(base, q) - self.0.joint_forces(q, v)
    }

    /// The block of the [standard regressor](Self::standard_regressor) for the
    /// [parameters of the base](dynamics_runtime::Table::standard_parameters_of_base). The rows of joints are zero.
    pub fn standard_regressor_of_base(
        &self,
        base: &Pose<f64>,
        v: &V::Vector,
        a: &V::Vector,
    ) -> V::Rows<10> {
        let base = self.footing(base);
        self.0.placed(&base).standard_regressor_of_base(v, a)
    }

    /// Where the base is.
    pub(super) fn footing(&self, base: &Pose<f64>) -> Footing {
        Footing::new(base.into(), &self.0.world_gravity)
    }

    /// The robot with its base at a place that does not matter.
    pub(super) fn anywhere(&self) -> Placed<'_, '_, D, V> {
        self.0.standing()
    }

    /// The robot with its base there.
    pub(super) fn placed<'b>(&self, base: &'b Footing) -> Placed<'_, 'b, D, V> {
        self.0.placed(base)
    }
}

#[cfg(test)]
mod tests;
