//! The equations in one joint.

use nalgebra::Vector3;

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
    /// Whether it is the second of two roots.
    pub(super) is_second: bool,
    /// An angle is known to `rounding * sqrt(size / length)`, half a turn at most.
    pub(super) length: T,
    pub(super) size: T,
}

/// At most two solutions.
#[derive(Clone, Copy, Debug)]
pub struct Roots<T> {
    both: [Found<T>; 2],
    pub(super) count: usize,
    /// How far an equation without a solution is from having one, at most 0.
    pub(super) miss: T,
}

impl<T> IntoIterator for Roots<T> {
    type Item = Found<T>;
    type IntoIter = core::iter::Take<core::array::IntoIter<Found<T>, 2>>;

    #[inline]
    fn into_iter(self) -> Self::IntoIter {
        self.both.into_iter().take(self.count)
    }
}

/// Numbers below this part of those that they are differences of may be nothing but rounding.
const ROUNDINGS: f64 = 16.0;

/// An equation that misses a root by more than so many slacks of a joint has none within the slack.
const STEEP: f64 = 8.0;

/// Farther away than any equation is from having a solution.
pub(super) const NO_TRY: f64 = -1e30;

#[inline]
pub(super) fn roundings<T: Real>(size: T) -> T {
    T::from_f64(ROUNDINGS) * T::epsilon() * size
}

impl<T: Real> Found<T> {
    #[inline]
    pub(super) fn new(sine: T, cosine: T, is_singular: bool) -> Self {
        Found {
            sine,
            cosine,
            is_singular,
            is_second: false,
            length: T::from_f64(0.0),
            size: T::from_f64(1.0),
        }
    }

    /// Two roots, told apart.
    #[inline]
    fn both(first: Self, second: Self) -> [Self; 2] {
        let is_second = true;
        [
            first,
            Found {
                is_second,
                ..second
            },
        ]
    }

    /// No turn, if any will do.
    #[inline]
    fn any() -> Self {
        Found::new(T::from_f64(0.0), T::from_f64(1.0), true)
    }

    #[inline]
    fn known_to(self, length: T, size: T) -> Self {
        Found {
            length,
            size,
            ..self
        }
    }

    /// Whether another position, within the slack of this one, may solve an equation that misses a root by so much.
    #[inline]
    pub(super) fn may_solve(&self, miss: T) -> bool {
        let steep = roundings(T::from_f64(STEEP));
        miss * miss * self.length <= steep * steep * self.size && miss > T::from_f64(NO_TRY)
    }

    /// This turn, on the unit circle, and another one after it, of which it is not told apart.
    pub(super) fn turned(self, by: T) -> Self {
        let (s, c) = by.sin_cos();
        let sine = self.sine * c + self.cosine * s;
        Found {
            is_second: self.is_second,
            ..Found::new(sine, self.cosine * c - self.sine * s, true)
        }
    }
}

/// The turn with this cosine and sine times a length, the square of a distance from the axis; zero if that vanishes beside
/// `size`, the square of the whole distance. First as they are, and then on the unit circle, for joints behind it. The proof
/// divides by `_length`; of a folded arm it has no digits left, and the cosine and the sine have.
#[inline]
pub fn turn<T: Real>(cosine: T, sine: T, _length: T, size: T) -> [Found<T>; 2] {
    let length = (cosine * cosine + sine * sine).sqrt();
    let least = roundings(T::from_f64(1.0));
    if length <= least * least * size || length <= T::from_f64(0.0) {
        return [Found::any(); 2];
    }
    let is_singular = length <= T::APART * T::APART * size;
    let scale = T::from_f64(1.0) / length;
    [T::from_f64(1.0), scale]
        .map(|by| Found::new(sine * by, cosine * by, is_singular).known_to(length, size))
}

/// The turns with a cos q + b sin q = c, where c is a difference of numbers whose squares are as large as `size`. The
/// discriminant is a^2 + b^2 - c^2.
#[inline]
pub fn turns<T: Real>(a: T, b: T, c: T, discriminant: T, size: T) -> Roots<T> {
    let square = a * a + b * b;
    let least = roundings(T::from_f64(1.0));
    // A discriminant that is nothing but rounding is none: later joints then see the same root as this one.
    let noise = T::from_f64(0.25) * least * least * size * square;
    let size = size + square;
    if square <= least * least * size {
        // Both sides vanish, or none does.
        let is_some = c * c <= least * least * size && size.is_finite();
        return Roots {
            both: [Found::any(); 2],
            count: usize::from(is_some),
            miss: -(c * c / size),
        };
    }
    if discriminant > least * least * square && discriminant * discriminant > noise {
        let (four, apart) = (T::from_f64(4.0), T::APART * T::APART);
        let is_singular = four * discriminant <= apart * square || square <= apart * size;
        let length = if is_singular {
            length(discriminant, square, size)
        } else {
            discriminant
        };
        let (root, scale) = (discriminant.sqrt(), T::from_f64(1.0) / square);
        let turn = |root: T| {
            let (s, c) = ((b * c + a * root) * scale, (a * c - b * root) * scale);
            Found::new(s, c, is_singular).known_to(length, size)
        };
        return Roots {
            both: Found::both(turn(root), turn(-root)),
            count: 2,
            miss: discriminant,
        };
    }
    // The turn between the two.
    let is_one = discriminant >= -roundings(size) && size.is_finite();
    let radius = square.sqrt();
    let scale = if c < T::from_f64(0.0) {
        -radius
    } else {
        radius
    };
    let length = length(T::from_f64(0.0), square, size);
    Roots {
        both: [Found::new(b / scale, a / scale, true).known_to(length, size); 2],
        count: usize::from(is_one),
        miss: discriminant / size,
    }
}

/// The turns with a cos q + b sin q = c of a point, and u cos q + v sin q = w of the direction of a line on which it is. The
/// point that is farther along the line by the root of `size` has the sum of both.
///
///   (a + along u) cos q + (b + along v) sin q = c + along w
///
/// Three numbers make its discriminant: that of the point, `size` times that of the direction, and twice
/// along (a u + b v - c w). The sign of `along` makes the last one a gain. The sum is small only if neither equation says where
/// the joint is.
#[inline]
pub fn turns_of_line<T: Real>(a: T, b: T, c: T, u: T, v: T, w: T, size: T) -> Roots<T> {
    let along = size.sqrt();
    let along = if a * u + b * v < c * w { -along } else { along };
    let [a, b, c] = [a + along * u, b + along * v, c + along * w];
    turns(a, b, c, a * a + b * b - c * c, size)
}

/// The length of a root: a step d from it changes a cos q + b sin q by root d + radius d^2 / 2, which is to be rounding.
#[cold]
fn length<T: Real>(discriminant: T, square: T, size: T) -> T {
    let least = T::from_f64(0.5) * roundings((square * size).sqrt());
    if discriminant > least {
        discriminant
    } else {
        least
    }
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
    Roots {
        both: Found::both(slide(b + root), slide(b - root)),
        count: usize::from(is_some) + usize::from(is_some && is_two),
        miss: discriminant / size,
    }
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
