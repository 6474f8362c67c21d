//! Where a base that moves stands.

use nalgebra::{Matrix3, Matrix4, SVector, Vector3};

use crate::Scalar;
use crate::closed_form::is_rotation;

/// Where a base that moves stands in the world: the first argument of the functions of a robot with `base: floating`.
///
/// It is written as a literal. Generated functions do not check that `rotation` is one.
///
/// ```
/// use robot_dynamics::Pose;
/// use robot_dynamics::nalgebra::{Rotation3, Vector3};
///
/// let tilted = Pose {
///     rotation: Rotation3::from_euler_angles(0.0, 0.1, 0.0).into_inner(),
///     position: Vector3::new(0.0, 0.0, 0.5),
/// };
/// assert_eq!(tilted.homogeneous()[(2, 3)], 0.5);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose<T> {
    /// The axes of the base in the world, as columns.
    pub rotation: Matrix3<T>,
    /// The origin of the base's frame in the world, m.
    pub position: Vector3<T>,
}

impl<T: Scalar> Pose<T> {
    /// A base whose frame is the world's.
    pub fn identity() -> Self {
        let entry = |i, j| T::from_f64(f64::from(u8::from(i == j)));
        Pose {
            rotation: Matrix3::from_fn(entry),
            position: Vector3::from_fn(|_, _| T::from_f64(0.0)),
        }
    }

    /// The pose as a homogeneous transform, from the axes of the base to those of the world.
    pub fn homogeneous(&self) -> Matrix4<T> {
        Matrix4::from_fn(|i, j| match (i, j) {
            (3, j) => T::from_f64(f64::from(u8::from(j == 3))),
            (i, 3) => self.position[i],
            (i, j) => self.rotation[(i, j)],
        })
    }

    /// The twelve numbers that programs read: the rotation by rows, then the position.
    #[doc(hidden)]
    #[inline(always)]
    pub fn entries(&self) -> SVector<T, 12> {
        let (r, p) = (&self.rotation, &self.position);
        SVector::from([
            r.m11, r.m12, r.m13, r.m21, r.m22, r.m23, r.m31, r.m32, r.m33, p.x, p.y, p.z,
        ])
    }
}

impl Pose<f64> {
    /// Whether the rotation is one: orthogonal unit vectors to 1e-6, right-handed.
    #[doc(hidden)]
    pub fn has_rotation(&self) -> bool {
        is_rotation(&self.rotation)
    }

    /// The pose of such twelve numbers.
    #[cfg(feature = "std")]
    #[doc(hidden)]
    pub fn of_entries([r11, r12, r13, r21, r22, r23, r31, r32, r33, x, y, z]: [f64; 12]) -> Self {
        Pose {
            rotation: Matrix3::new(r11, r12, r13, r21, r22, r23, r31, r32, r33),
            position: Vector3::new(x, y, z),
        }
    }
}

/// The rotation by rows, then the position.
#[cfg(feature = "serde")]
impl serde::Serialize for Pose<f64> {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.entries().data.0[0].serialize(serializer)
    }
}

#[cfg(feature = "serde")]
impl<'de> serde::Deserialize<'de> for Pose<f64> {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        <[f64; 12]>::deserialize(deserializer).map(Pose::of_entries)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_are_the_rotation_by_rows_and_the_position() {
        let pose = Pose {
            rotation: Matrix3::new(1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0),
            position: Vector3::new(10.0, 11.0, 12.0),
        };
        let entries = pose.entries();
        assert!((0..12).all(|k| entries[k] == (k + 1) as f64));
        let matrix = pose.homogeneous();
        assert_eq!(
            (matrix[(1, 2)], matrix[(2, 3)], matrix[(3, 3)]),
            (6.0, 12.0, 1.0)
        );
        assert_eq!(Pose::<f64>::identity().homogeneous(), Matrix4::identity());
    }
}
