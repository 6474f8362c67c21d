//! The equations in one joint.

use nalgebra::{Matrix3, Matrix4, Vector3};

use super::Real;

/// The position of a joint: the sine and the cosine of an angle, up to a common positive factor, or a displacement.
#[derive(Clone, Copy, Debug)]
pub struct Found<T> {
    /// The sine, or the displacement itself.
    pub sine: T,
    /// The cosine; of a displacement zero.
    pub cosine: T,
    /// Whether another position would do as well, or nearly.
    pub is_singular: bool,
}

/// At most two solutions.
pub type Roots<T> = core::iter::Take<core::array::IntoIter<Found<T>, 2>>;

/// Numbers below this part of those that they are differences of may be nothing but rounding.
const ROUNDINGS: f64 = 16.0;

#[inline]
fn roundings<T: Real>(size: T) -> T {
    T::from_f64(ROUNDINGS) * T::epsilon() * size
}

impl<T: Real> Found<T> {
    #[inline]
    fn new(sine: T, cosine: T, is_singular: bool) -> Self {
        Found {
            sine,
            cosine,
            is_singular,
        }
    }

    /// No turn, if any will do.
    #[inline]
    fn any() -> Self {
        Found::new(T::from_f64(0.0), T::from_f64(1.0), true)
    }
}

/// The turn with this cosine and sine times `length`, the square of a distance from the axis; zero if that vanishes beside
/// `size`, the square of the whole distance. First as they are, and then on the unit circle, for joints behind it.
#[inline]
pub fn turn<T: Real>(cosine: T, sine: T, length: T, size: T) -> [Found<T>; 2] {
    let squares = cosine * cosine + sine * sine;
    let least = roundings(T::from_f64(1.0));
    if length <= least * least * size || squares <= T::from_f64(0.0) {
        return [Found::any(); 2];
    }
    let is_singular = length <= T::APART * T::APART * size;
    let scale = T::from_f64(1.0) / squares.sqrt();
    [T::from_f64(1.0), scale].map(|by| Found::new(sine * by, cosine * by, is_singular))
}

/// The turns with a cos q + b sin q = c, where c is a difference of numbers whose squares are as large as `size`. The
/// discriminant is a^2 + b^2 - c^2.
#[inline]
pub fn turns<T: Real>(a: T, b: T, c: T, discriminant: T, size: T) -> Roots<T> {
    let square = a * a + b * b;
    let size = size + square;
    let least = roundings(T::from_f64(1.0));
    if square <= least * least * size {
        // Both sides vanish, or none does.
        let count = usize::from(c * c <= least * least * size && size.is_finite());
        let both = [Found::any(); 2];
        return both.into_iter().take(count);
    }
    if discriminant > least * least * square {
        let is_singular = T::from_f64(4.0) * discriminant <= T::APART * T::APART * square;
        let (root, scale) = (discriminant.sqrt(), T::from_f64(1.0) / square);
        let turn = |root: T| {
            let (s, c) = ((b * c + a * root) * scale, (a * c - b * root) * scale);
            Found::new(s, c, is_singular)
        };
        let both = [turn(root), turn(-root)];
        return both.into_iter().take(2);
    }
    // The turn between the two.
    let is_one = discriminant >= -roundings(size) && size.is_finite();
    let radius = square.sqrt();
    let scale = if c < T::from_f64(0.0) {
        -radius
    } else {
        radius
    };
    let both = [Found::new(b / scale, a / scale, true); 2];
    both.into_iter().take(usize::from(is_one))
}

/// A position that was found by itself.
#[inline]
pub fn slide<T: Real>(position: T) -> Found<T> {
    Found::new(position, T::from_f64(0.0), false)
}

/// d = b + root and b - root of the discriminant, a difference of numbers as large as `size`.
#[inline]
pub fn slides<T: Real>(b: T, discriminant: T, size: T) -> Roots<T> {
    let is_some = discriminant >= -roundings(size) && size.is_finite();
    let is_two = discriminant.is_positive();
    let root = if is_two {
        discriminant.sqrt()
    } else {
        T::from_f64(0.0)
    };
    let twice = root + root;
    let is_singular = twice * twice <= T::APART * T::APART * size;
    let slide = |position| Found::new(position, T::from_f64(0.0), is_singular);
    let both = [slide(b + root), slide(b - root)];
    both.into_iter()
        .take(usize::from(is_some) + usize::from(is_some && is_two))
}

/// Whether a vector vanishes beside distances with the sum of squares `size`.
#[inline]
pub fn is_reached<T: Real>(x: T, y: T, z: T, size: T) -> bool {
    x * x + y * y + z * z <= T::REACHED * T::REACHED * size && size.is_finite()
}

/// The direction of a vector, or of another one if the square of its length vanishes beside `size`, and whether the first one is
/// so short that another would do nearly as well.
#[inline]
pub fn direction<T: Real>(
    x: T,
    y: T,
    z: T,
    other_x: T,
    other_y: T,
    other_z: T,
    size: T,
) -> (Vector3<T>, bool) {
    let square = x * x + y * y + z * z;
    let least = roundings(T::from_f64(1.0));
    let [x, y, z] = if square > least * least * size {
        [x, y, z]
    } else {
        [other_x, other_y, other_z]
    };
    let scale = T::from_f64(1.0) / (x * x + y * y + z * z).sqrt();
    let is_any = square <= T::APART * T::APART * size;
    (Vector3::new(x * scale, y * scale, z * scale), is_any)
}

/// Whether a matrix is a pose: homogeneous, with a rotation.
#[inline]
pub fn is_pose<T: Real>(matrix: &Matrix4<T>) -> bool {
    is_homogeneous(matrix) && is_rotation(&matrix.fixed_view::<3, 3>(0, 0).into_owned())
}

/// Whether the last row of a matrix is 0, 0, 0, 1, which a transposed pose has as its last column.
#[inline]
pub(crate) fn is_homogeneous<T: Real>(matrix: &Matrix4<T>) -> bool {
    let [x, y, z, position] = &matrix.data.0;
    are_small(&[x[3], y[3], z[3], position[3] - T::from_f64(1.0)])
}

/// Whether a matrix is a rotation: two columns of length one at right angles, and their vector product the third.
#[inline]
pub(crate) fn is_rotation<T: Real>(matrix: &Matrix3<T>) -> bool {
    let [[a, b, c], [d, e, f], [g, h, i]] = matrix.data.0;
    let one = T::from_f64(1.0);
    let misses = [
        a * a + b * b + c * c - one,
        d * d + e * e + f * f - one,
        a * d + b * e + c * f,
        b * f - c * e - g,
        c * d - a * f - h,
        a * e - b * d - i,
    ];
    are_small(&misses)
}

#[inline]
fn are_small<T: Real>(misses: &[T]) -> bool {
    misses
        .iter()
        .all(|x| *x <= T::ROTATION && *x >= -T::ROTATION)
}
