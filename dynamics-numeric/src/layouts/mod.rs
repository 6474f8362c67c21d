//! Robots on a base that moves in the layouts of other libraries: positions, velocities, accelerations, forces, mass matrices
//! and Jacobians.
//!
//! Here the six velocities of the base are linear, then angular, both in the axes of the base, and the base stands at a
//! [`Pose`]. The libraries differ in the order of the quaternion, in the order of the six numbers, and in the axes of each
//! three of them:
//!
//! | library | position | velocity of the base |
//! |---|---|---|
//! | [`Pinocchio`] | x y z, quaternion x y z w, joints | linear, angular; both in the axes of the base |
//! | [`MuJoCo`] | x y z, quaternion w x y z, joints | linear in the axes of the world, angular in those of the base |
//! | [`Drake`] | quaternion w x y z, x y z, joints | angular, linear; both in the axes of the world |
//! | [`Rbdl`] | x y z, quaternion x y z, joints, quaternion w | linear in the axes of the world, angular in those of the base |
//!
//! Sources, read in 2026: Pinocchio, documentation of `JointModelFreeFlyerTpl` (`joint-free-flyer.hpp`): "(x, y, z, w)", "body
//! linear velocity", "body angular velocity". MuJoCo, documentation, *Overview*, section *Floating objects*: linear positions
//! and velocities in the global frame, rotational velocities in the local body frame. Drake, `quaternion_floating_joint.h`:
//! the angular velocity `w_FM` and the linear velocity `v_FM`, both expressed in F, which is the world; quaternions are stored
//! as (w, x, y, z). RBDL, `Joint.h`, *Joint Modeling*: the floating base is `JointTypeTranslationXYZ`, then
//! `JointTypeSpherical`, whose angular velocity is in body coordinates, and the fourth component of the quaternion is appended
//! to q.
//!
//! Let v' = S v, where S turns the linear and the angular part or neither. Then a force is f' = S f, a mass matrix M' =
//! S M S^T, a Jacobian J' = J S^T: power v.f and energy 1/2 v.M v are the same. Accelerations have one more term where
//! the linear velocity is in the axes of the world: `d/dt (R v) = R (dv/dt + w x v)`.
//!
//! Joints are matched by their names. Pinocchio sorts the children of a link by the alphabet, so its order is that of
//! `model.names` behind `universe` and `root_joint`, and seldom that of a file.
//!
//! ```
//! use robot_dynamics::Pose;
//! use robot_dynamics::layouts::MuJoCo;
//! use robot_dynamics::nalgebra::{Matrix3, SVector, Vector3};
//!
//! let layout = MuJoCo::new(&["hip", "knee"], &["knee", "hip"])?;
//! // A base that has turned left by a right angle, and goes ahead along its own x axis.
//! let base = Pose {
//!     rotation: Matrix3::new(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0),
//!     position: Vector3::new(0.1, 0.2, 0.3),
//! };
//! let v = SVector::from([2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 7.0, 8.0]);
//! assert_eq!(layout.velocity(&base, &v), SVector::from([0.0, 2.0, 0.0, 0.0, 0.0, 0.0, 8.0, 7.0]));
//! let qpos: SVector<f64, 9> = layout.position(&base, &SVector::from([0.4, 0.5]));
//! assert_eq!((qpos[7], qpos[8]), (0.5, 0.4));
//! # Ok::<(), robot_dynamics::layouts::WrongJoint>(())
//! ```

mod library;

use core::fmt;
use core::marker::PhantomData;

use dynamics_runtime::Pose;
use dynamics_runtime::internal::quaternion;
use nalgebra::{Matrix3, SMatrix, SVector, Vector3};

pub use library::Library;
use library::{DrakeRules, MuJoCoRules, PinocchioRules, RbdlRules};

/// The layout of Pinocchio, for a free-flyer as the root joint: see [`layouts`](self).
pub type Pinocchio<const N: usize> = Layout<PinocchioRules, N>;

/// The layout of MuJoCo, for a body with a free joint: see [`layouts`](self).
pub type MuJoCo<const N: usize> = Layout<MuJoCoRules, N>;

/// The layout of Drake, for a floating body with a quaternion: see [`layouts`](self).
pub type Drake<const N: usize> = Layout<DrakeRules, N>;

/// The layout of RBDL, for `JointTypeFloatingBase`: see [`layouts`](self).
pub type Rbdl<const N: usize> = Layout<RbdlRules, N>;

/// The layout of a library for a robot with `N` joints on a base that moves. Made once, it converts both ways; nothing of it
/// allocates.
///
/// The lengths of vectors follow from their types: `V` is 6 + N, `Q` is 7 + N. Others do not compile.
pub struct Layout<L, const N: usize> {
    /// Where each joint is among those of the library.
    places: [usize; N],
    library: PhantomData<L>,
}

/// A joint of the robot has no place of its own among the names of the library.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum WrongJoint<'a> {
    /// The joint of this name is not among the names of the library.
    Missing(&'a str),
    /// Two joints have this name, so that one of the library would stand for both.
    Twice(&'a str),
}

impl<'a, L: Library, const N: usize> Layout<L, N> {
    /// The layout for joints of these names. `theirs` are the names in the order of the library, without those of the base.
    ///
    /// # Errors
    ///
    /// [`WrongJoint`] if one of the names is not among those of the library, or stands twice among `ours`. A name that stands
    /// twice among `theirs` leaves a joint without a place, which is missing.
    pub fn new(ours: &[&'a str; N], theirs: &[&str; N]) -> Result<Self, WrongJoint<'a>> {
        let mut places = [0; N];
        for (joint, name) in ours.iter().enumerate() {
            if ours[..joint].contains(name) {
                return Err(WrongJoint::Twice(name));
            }
            let found = theirs.iter().position(|other| other == name);
            places[joint] = found.ok_or(WrongJoint::Missing(name))?;
        }
        let library = PhantomData;
        Ok(Layout { places, library })
    }
}

impl<L: Library, const N: usize> Layout<L, N> {
    /// The layout for a library that has the joints in the same order.
    pub fn in_order() -> Self {
        Layout {
            places: core::array::from_fn(|joint| joint),
            library: PhantomData,
        }
    }

    /// The library's q of a place of the base and of positions of the joints, rad or m. The quaternion has a length of 1, and
    /// its w is not negative.
    ///
    /// `base.rotation` must be one; the errors of the quaternion are a few units in the last place then.
    pub fn position<const Q: usize>(
        &self,
        base: &Pose<f64>,
        q: &SVector<f64, N>,
    ) -> SVector<f64, Q> {
        const { assert!(Q == N + 7, "a position has 7 + N numbers") };
        let mut theirs = SVector::<f64, Q>::zeros();
        for (place, x) in L::quaternion(N)
            .into_iter()
            .zip(quaternion::of(&base.rotation))
        {
            theirs[place] = x;
        }
        theirs
            .fixed_rows_mut::<3>(L::ORIGIN)
            .copy_from(&base.position);
        for (joint, place) in self.places.iter().enumerate() {
            theirs[L::FIRST_JOINT + place] = q[joint];
        }
        theirs
    }

    /// The place of the base and the positions of the joints of the library's q. A quaternion of another length than 1 counts as
    /// its direction; one of length 0 has none, and its rotation is NaN.
    pub fn from_position<const Q: usize>(
        &self,
        theirs: &SVector<f64, Q>,
    ) -> (Pose<f64>, SVector<f64, N>) {
        const { assert!(Q == N + 7, "a position has 7 + N numbers") };
        let base = Pose {
            rotation: quaternion::rotation(&L::quaternion(N).map(|place| theirs[place])),
            position: theirs.fixed_rows::<3>(L::ORIGIN).into_owned(),
        };
        let q = SVector::from_fn(|joint, _| theirs[L::FIRST_JOINT + self.places[joint]]);
        (base, q)
    }

    /// The library's velocity of `v`, with the base at this place.
    pub fn velocity<const V: usize>(
        &self,
        base: &Pose<f64>,
        v: &SVector<f64, V>,
    ) -> SVector<f64, V> {
        self.there(base, v)
    }

    /// v of the library's velocity.
    pub fn from_velocity<const V: usize>(
        &self,
        base: &Pose<f64>,
        theirs: &SVector<f64, V>,
    ) -> SVector<f64, V> {
        self.back(base, theirs)
    }

    /// The library's acceleration, the rate of its velocity, of `a` at the velocity `v`.
    pub fn acceleration<const V: usize>(
        &self,
        base: &Pose<f64>,
        v: &SVector<f64, V>,
        a: &SVector<f64, V>,
    ) -> SVector<f64, V> {
        self.there(base, &(a + Self::turning(v)))
    }

    /// `a` of the library's acceleration, at our velocity `v`.
    pub fn from_acceleration<const V: usize>(
        &self,
        base: &Pose<f64>,
        v: &SVector<f64, V>,
        theirs: &SVector<f64, V>,
    ) -> SVector<f64, V> {
        self.back(base, theirs) - Self::turning(v)
    }

    /// The library's generalized force of the force and moment on the base and the forces of the joints, with the same power.
    ///
    /// A force of a motion is one: `inverse_dynamics`, `gravity_vector`. A Coriolis vector V is the library's only where its
    /// linear velocity is in the axes of the base: elsewhere it is this force of V - M c, with c the difference of
    /// accelerations that `acceleration` adds.
    pub fn force<const V: usize>(
        &self,
        base: &Pose<f64>,
        force: &SVector<f64, V>,
    ) -> SVector<f64, V> {
        self.there(base, force)
    }

    /// The force of the library's generalized force.
    pub fn from_force<const V: usize>(
        &self,
        base: &Pose<f64>,
        theirs: &SVector<f64, V>,
    ) -> SVector<f64, V> {
        self.back(base, theirs)
    }

    /// The library's mass matrix, S M S^T.
    pub fn mass_matrix<const V: usize>(
        &self,
        base: &Pose<f64>,
        mass_matrix: &SMatrix<f64, V, V>,
    ) -> SMatrix<f64, V, V> {
        self.jacobian(base, &self.jacobian(base, mass_matrix).transpose())
    }

    /// M of the library's mass matrix.
    pub fn from_mass_matrix<const V: usize>(
        &self,
        base: &Pose<f64>,
        theirs: &SMatrix<f64, V, V>,
    ) -> SMatrix<f64, V, V> {
        self.from_jacobian(base, &self.from_jacobian(base, theirs).transpose())
    }

    /// A Jacobian with the columns of the library's velocities, J S^T. Its rows stay what they are.
    pub fn jacobian<const R: usize, const V: usize>(
        &self,
        base: &Pose<f64>,
        jacobian: &SMatrix<f64, R, V>,
    ) -> SMatrix<f64, R, V> {
        by_rows(jacobian, |row| self.there(base, row))
    }

    /// The Jacobian of the library's.
    pub fn from_jacobian<const R: usize, const V: usize>(
        &self,
        base: &Pose<f64>,
        theirs: &SMatrix<f64, R, V>,
    ) -> SMatrix<f64, R, V> {
        by_rows(theirs, |row| self.back(base, row))
    }

    /// S x.
    fn there<const V: usize>(&self, base: &Pose<f64>, ours: &SVector<f64, V>) -> SVector<f64, V> {
        self.moved(&base.rotation, ours, |[here, there]| (here, there))
    }

    /// S^T x, which is the inverse.
    fn back<const V: usize>(&self, base: &Pose<f64>, theirs: &SVector<f64, V>) -> SVector<f64, V> {
        let rotation = base.rotation.transpose();
        self.moved(&rotation, theirs, |[here, there]| (there, here))
    }

    /// The numbers of x at other places, those between the axes of the base and of the world turned. `way` says from which of
    /// the places here and there, and to which.
    fn moved<const V: usize>(
        &self,
        rotation: &Matrix3<f64>,
        x: &SVector<f64, V>,
        way: impl Fn([usize; 2]) -> (usize, usize),
    ) -> SVector<f64, V> {
        const { assert!(V == N + 6, "a velocity has 6 + N numbers") };
        let mut moved = SVector::<f64, V>::zeros();
        for (here, there, in_world) in Self::parts() {
            let (from, to) = way([here, there]);
            let part: Vector3<f64> = x.fixed_rows::<3>(from).into_owned();
            let part = if in_world { rotation * part } else { part };
            moved.fixed_rows_mut::<3>(to).copy_from(&part);
        }
        for (joint, place) in self.places.iter().enumerate() {
            let (from, to) = way([6 + joint, 6 + place]);
            moved[to] = x[from];
        }
        moved
    }

    /// The linear and the angular part: where they begin here and there, and whether they are in the axes of the world there.
    fn parts() -> [(usize, usize, bool); 2] {
        let (linear, angular) = if L::ANGULAR_FIRST { (3, 0) } else { (0, 3) };
        [
            (0, linear, L::LINEAR_IN_WORLD),
            (3, angular, L::ANGULAR_IN_WORLD),
        ]
    }

    /// `w x v`, which the rate of a linear velocity in the axes of the world has besides.
    fn turning<const V: usize>(v: &SVector<f64, V>) -> SVector<f64, V> {
        let mut turning = SVector::<f64, V>::zeros();
        if L::LINEAR_IN_WORLD {
            let [linear, angular] = [0, 3].map(|k| Vector3::new(v[k], v[k + 1], v[k + 2]));
            turning
                .fixed_rows_mut::<3>(0)
                .copy_from(&angular.cross(&linear));
        }
        turning
    }
}

/// Each row as a vector, changed.
fn by_rows<const R: usize, const V: usize>(
    matrix: &SMatrix<f64, R, V>,
    change: impl Fn(&SVector<f64, V>) -> SVector<f64, V>,
) -> SMatrix<f64, R, V> {
    let mut changed = *matrix;
    for (mut to, row) in changed.row_iter_mut().zip(matrix.row_iter()) {
        to.tr_copy_from(&change(&row.transpose()));
    }
    changed
}

impl<L, const N: usize> Clone for Layout<L, N> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<L, const N: usize> Copy for Layout<L, N> {}

impl<L, const N: usize> fmt::Debug for Layout<L, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Layout").field(&self.places).finish()
    }
}

impl fmt::Display for WrongJoint<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (name, reason) = match self {
            WrongJoint::Missing(name) => (name, "is not among the names of the library"),
            WrongJoint::Twice(name) => (name, "stands twice among the names of the robot"),
        };
        write!(f, "joint `{name}` {reason}")
    }
}

impl core::error::Error for WrongJoint<'_> {}

#[cfg(test)]
mod tests;
