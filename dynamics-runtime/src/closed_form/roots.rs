//! The equations in one joint.

use super::Real;

/// The position of a joint: the sine and the cosine of an angle, or a displacement.
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
#[derive(Clone, Copy, Debug)]
pub struct Roots<T> {
    both: [Found<T>; 2],
    count: usize,
}

impl<T> Roots<T> {
    /// The solutions.
    #[inline]
    pub fn as_slice(&self) -> &[Found<T>] {
        &self.both[..self.count]
    }
}

/// Numbers below this part of those that they are differences of may be nothing but rounding.
const ROUNDINGS: f64 = 16.0;

#[inline]
fn roundings<T: Real>(size: T) -> T {
    T::from_f64(ROUNDINGS) * T::epsilon() * size
}

impl<T: Real> Found<T> {
    #[inline]
    fn turn(sine: T, cosine: T, is_singular: bool) -> Self {
        Found {
            sine,
            cosine,
            is_singular,
        }
    }

    /// No turn, if any will do.
    #[inline]
    fn any() -> Self {
        Found::turn(T::from_f64(0.0), T::from_f64(1.0), true)
    }

    #[inline]
    fn slide(position: T, is_singular: bool) -> Self {
        Found::turn(position, T::from_f64(0.0), is_singular)
    }
}

/// The turn with this cosine and sine times `length`, the square of a distance from the axis; zero if that vanishes beside
/// `size`, the square of the whole distance.
#[inline]
pub fn turn<T: Real>(cosine: T, sine: T, length: T, size: T) -> Found<T> {
    let squares = cosine * cosine + sine * sine;
    let least = roundings(T::from_f64(1.0));
    if length <= least * least * size || squares <= T::from_f64(0.0) {
        return Found::any();
    }
    let is_singular = length <= T::APART * T::APART * size;
    let scale = T::from_f64(1.0) / squares.sqrt();
    Found::turn(sine * scale, cosine * scale, is_singular)
}

/// The turns with a cos q + b sin q = c, where c is a difference of numbers whose squares are as large as `size`.
#[inline]
pub fn turns<T: Real>(a: T, b: T, c: T, size: T) -> Roots<T> {
    let square = a * a + b * b;
    let size = size + square;
    let least = roundings(T::from_f64(1.0));
    if square <= least * least * size {
        // Both sides vanish, or none does.
        let count = usize::from(c * c <= least * least * size && size.is_finite());
        let both = [Found::any(); 2];
        return Roots { both, count };
    }
    let radius = square.sqrt();
    let magnitude = if c.is_positive() { c } else { -c };
    let discriminant = (radius - magnitude) * (radius + magnitude);
    by_discriminant([a, b, c], [square, radius], discriminant, size)
}

/// |y - Rz(q) x|^2 + rest = found, which is a cos q + b sin q = (known - found) / 2.
///
/// If y and x are nearly equally long, `known` is much larger than `found`, and so is its rounding. The difference of the two
/// vectors is as exact as they are: one step of Newton's method takes q to where its square is right.
#[inline]
#[allow(clippy::too_many_arguments)]
pub fn turns_at_distance<T: Real>(
    a: T,
    b: T,
    known: T,
    found: T,
    x0: T,
    x1: T,
    y0: T,
    y1: T,
    rest: T,
) -> Roots<T> {
    let size = (known + found) * (known + found);
    let c = (known - found) * T::from_f64(0.5);
    let mut roots = turns(a, b, c, size);
    for Found {
        sine: s,
        cosine: c,
        is_singular,
    } in &mut roots.both
    {
        if !*is_singular {
            let (u, v) = (*c * x0 - *s * x1, *s * x0 + *c * x1);
            let (du, dv) = (u - y0, v - y1);
            let miss = (found - rest) - (du * du + dv * dv);
            // The square changes by twice the product of y and the turned x.
            let step = miss / ((u * y1 - v * y0) * T::from_f64(-2.0));
            (*s, *c) = (*s + *c * step, *c - *s * step);
        }
    }
    roots
}

/// As [`turns`] with a^2 + b^2 - c^2, which has no rounding of larger numbers.
#[inline]
pub fn turns_by<T: Real>(a: T, b: T, c: T, discriminant: T) -> Roots<T> {
    let square = a * a + b * b;
    let radius = square.sqrt();
    let least = roundings(radius);
    let is_nothing = discriminant <= least * least && discriminant >= -roundings(square);
    let discriminant = if is_nothing {
        T::from_f64(0.0)
    } else {
        discriminant
    };
    by_discriminant([a, b, c], [square, radius], discriminant, square)
}

/// As [`turns_by`], with the discriminant (1 - along) (1 + along - twice), where (1 - along) (1 + along) = across.
#[inline]
pub fn inclined_turns<T: Real>(a: T, b: T, c: T, along: T, across: T, twice: T) -> Roots<T> {
    let beyond = T::from_f64(1.0) + along;
    turns_by(a, b, c, across / beyond * (beyond - twice))
}

/// The two turns, or the one between them.
#[inline]
fn by_discriminant<T: Real>(
    [a, b, c]: [T; 3],
    [square, radius]: [T; 2],
    discriminant: T,
    size: T,
) -> Roots<T> {
    let zero = T::from_f64(0.0);
    if discriminant.is_positive() {
        let root = discriminant.sqrt();
        let is_singular = root + root <= T::APART * radius;
        let scale = T::from_f64(1.0) / square;
        let turn = |root: T| {
            let (s, c) = ((b * c + a * root) * scale, (a * c - b * root) * scale);
            Found::turn(s, c, is_singular)
        };
        let both = [turn(root), turn(-root)];
        return Roots { both, count: 2 };
    }
    let is_one = discriminant >= -roundings(size) && size.is_finite();
    let scale = if c < zero { -radius } else { radius };
    let one = Found::turn(b / scale, a / scale, true);
    Roots {
        both: [one; 2],
        count: usize::from(is_one),
    }
}

/// A position that was found by itself.
#[inline]
pub fn slide<T: Real>(position: T) -> Found<T> {
    Found::slide(position, false)
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
    let slide = |position| Found::slide(position, is_singular);
    Roots {
        both: [slide(b + root), slide(b - root)],
        count: usize::from(is_some) + usize::from(is_some && is_two),
    }
}

/// Whether a vector vanishes beside distances with the sum of squares `size`.
#[inline]
pub fn is_reached<T: Real>(x: T, y: T, z: T, size: T) -> bool {
    x * x + y * y + z * z <= T::REACHED * T::REACHED * size && size.is_finite()
}

/// The square root.
#[inline]
pub fn root<T: Real>(square: T) -> T {
    square.sqrt()
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
) -> ([T; 3], bool) {
    let square = x * x + y * y + z * z;
    let least = roundings(T::from_f64(1.0));
    let [x, y, z] = if square > least * least * size {
        [x, y, z]
    } else {
        [other_x, other_y, other_z]
    };
    let scale = T::from_f64(1.0) / (x * x + y * y + z * z).sqrt();
    let is_any = square <= T::APART * T::APART * size;
    ([x * scale, y * scale, z * scale], is_any)
}
