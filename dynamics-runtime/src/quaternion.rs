//! Rotations as quaternions w, x, y, z.

use nalgebra::Matrix3;

/// The unit quaternion of a rotation, with w >= 0.
///
/// Source: S. W. Shepperd, *Quaternion from rotation matrix*, J. Guidance and Control 1 (1978), 223-224: the largest of
/// `4 w^2 = 1 + tr R` and `4 x_i^2 = 1 + 2 R_ii - tr R` is the one that is divided by, and no digit cancels.
pub fn of(r: &Matrix3<f64>) -> [f64; 4] {
    let trace = r.trace();
    let squares = [
        1.0 + trace,
        1.0 + 2.0 * r.m11 - trace,
        1.0 + 2.0 * r.m22 - trace,
        1.0 + 2.0 * r.m33 - trace,
    ];
    let largest = (1..4).fold(
        0,
        |best, k| if squares[k] > squares[best] { k } else { best },
    );
    let (a, b, c) = (r.m32 - r.m23, r.m13 - r.m31, r.m21 - r.m12);
    let (xy, yz, xz) = (r.m21 + r.m12, r.m32 + r.m23, r.m13 + r.m31);
    // Four times the largest one times each of them.
    let mut quaternion = match largest {
        0 => [squares[0], a, b, c],
        1 => [a, squares[1], xy, xz],
        2 => [b, xy, squares[2], yz],
        _ => [c, xz, yz, squares[3]],
    };
    let length = libm::sqrt(quaternion.iter().map(|x| x * x).sum());
    let sign = if quaternion[0] < 0.0 { -1.0 } else { 1.0 };
    quaternion.iter_mut().for_each(|x| *x *= sign / length);
    quaternion
}

/// The rotation of a quaternion of any length but zero, of which it is NaN.
pub fn rotation(quaternion: &[f64; 4]) -> Matrix3<f64> {
    let mut quaternion = *quaternion;
    let square = |quaternion: &[f64; 4]| quaternion.iter().map(|x| x * x).sum::<f64>();
    // Squares of short ones lose digits and vanish, those of long ones are infinite.
    if !(1e-200..1e200).contains(&square(&quaternion)) {
        let largest = quaternion
            .iter()
            .fold(0.0, |most: f64, x| most.max(x.abs()));
        quaternion = quaternion.map(|x| x / largest);
    }
    let s = 2.0 / square(&quaternion);
    let [w, x, y, z] = quaternion;
    let (xx, yy, zz) = (s * x * x, s * y * y, s * z * z);
    let (xy, yz, xz) = (s * x * y, s * y * z, s * x * z);
    let (wx, wy, wz) = (s * w * x, s * w * y, s * w * z);
    #[rustfmt::skip]
    let rotation = Matrix3::new(
        1.0 - yy - zz, xy - wz,       xz + wy,
        xy + wz,       1.0 - xx - zz, yz - wx,
        xz - wy,       yz + wx,       1.0 - xx - yy,
    );
    rotation
}
