//! Dynamics of a robot whose base moves, numerically, from its table.
//!
//! The recursions are those of an arm. They begin with the twist and the acceleration of the base, and what the links hand on
//! to the base is what moves it.
//!
//! Source: R. Featherstone, *Rigid Body Dynamics Algorithms*, Springer 2008, chapter 9: the base is body 0, and gravity is an
//! acceleration of it.

mod body;
mod centroidal;
mod coriolis;
mod derivatives;
mod energy;
mod forces;
mod forward;
mod kinematics;
mod rates;
mod regressor;
mod second_derivatives;

use nalgebra::{Const, Vector3};

use super::NumericArm;
use super::pose::Pose as Place;
use crate::Pose;
use crate::size::Size;
use crate::table::AsArm as _;
use body::Body;
#[cfg(feature = "std")]
pub use forward::NAMES_OF_BASE;

/// The numeric dynamics of a robot with `N` joints on a base that moves, read from its [`Table`](crate::Table). `V` is
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
/// # extern crate dynamics_runtime as robot_dynamics;
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
pub struct NumericFloating<D: Size, V: Size> {
    /// The links, in the frame of the base.
    arm: NumericArm<D, V>,
    /// The base's own body, and what is fixed to it.
    body: Body,
    /// The tip of a robot without joints in the frame of the base.
    tip: Place,
}

impl<D: Size, V: Size> NumericFloating<D, V> {
    /// Reads the table.
    ///
    /// # Panics
    ///
    /// If the base of the table stands, or V is not 6 + N; as [`NewtonEuler::new`](crate::NewtonEuler::new) besides.
    pub fn new(table: &D::Table) -> Self {
        let arm = table.arm();
        let freedoms = 6 + arm.rows.len();
        let declared = V::try_to_usize().unwrap_or(freedoms);
        assert_eq!(
            declared, freedoms,
            "velocities of the base and of the joints"
        );
        let body = arm
            .base_body()
            .expect("a table with `floating`: its base moves");
        NumericFloating {
            arm: NumericArm::read(table, V::from_usize(freedoms)),
            tip: body.tip_in_link(),
            body: Body::from(&body),
        }
    }

    /// The number of its velocities, 6 + N.
    pub fn dof(&self) -> usize {
        self.arm.dof()
    }

    /// Gravity in the axes of the base.
    fn gravity(&self, base: &Pose<f64>) -> Vector3<f64> {
        base.rotation.tr_mul(&self.arm.world_gravity)
    }
}

/// Linear and angular part of the six numbers of the base.
fn twist<V: Size>(velocities: &V::Vector) -> [Vector3<f64>; 2] {
    [0, 3].map(|k| Vector3::new(velocities[k], velocities[k + 1], velocities[k + 2]))
}

/// The base, as a frame to calculate with.
impl From<&Pose<f64>> for Place {
    fn from(base: &Pose<f64>) -> Self {
        Place {
            rotation: base.rotation,
            position: base.position,
        }
    }
}

#[cfg(test)]
mod tests;
