//! The common normal of two axes.

use dynamics_codegen::geometry::{Transform, Vector, cross, dot, tidy};
use dynamics_symbolic::exact::Rational;

use super::angle::is_zero;
use super::arm::{between, length};

/// A line in space with a direction.
#[derive(Clone)]
pub(super) struct Axis {
    pub(super) point: Vector,
    pub(super) direction: Vector,
}

/// The shortest way between two axes, and a direction along it.
pub(super) struct Normal {
    pub(super) direction: Vector,
    /// Its foot on the first axis.
    pub(super) from: Vector,
    /// Its foot on the second axis.
    pub(super) to: Vector,
    /// Whether the axes are so nearly parallel that the feet have lost digits.
    pub(super) is_vague: bool,
}

impl Axis {
    /// The z axis of a frame.
    pub(super) fn z(frame: &Transform) -> Axis {
        Axis {
            point: frame.origin.clone(),
            direction: frame.axis(2),
        }
    }

    /// The point of the axis that is nearest to another point.
    pub(super) fn nearest(&self, point: &Vector) -> Vector {
        let along = dot(&between(&self.point, point), &self.direction);
        moved(&self.point, &self.direction, &along)
    }

    pub(super) fn passes(&self, point: &Vector) -> bool {
        between(point, &self.nearest(point)).iter().all(is_zero)
    }
}

/// The point that is so far from another in a direction.
fn moved(point: &Vector, direction: &Vector, by: &Rational) -> Vector {
    [0, 1, 2].map(|k| tidy(&point[k] + &direction[k] * by))
}

/// The direction of that part of a vector which is across another direction; none if there is no such part.
pub(super) fn across(v: &Vector, direction: &Vector) -> Option<Vector> {
    let part = |v: &Vector| moved(v, direction, &-dot(v, direction));
    let first = part(v);
    // Where little is left of the vector, its direction has few digits: it is put across again.
    (!first.iter().all(is_zero)).then(|| unit(&part(&unit(&first))))
}

/// The direction of a vector, in as many digits where that is short: squares of its entries would have twice the zeros.
fn unit(v: &Vector) -> Vector {
    let size = |x: &Rational| if *x < Rational::ZERO { -x } else { x.clone() };
    let largest = v.iter().map(size).max().unwrap_or(Rational::ONE);
    let v = v.each_ref().map(|x| tidy(x / &largest));
    let length = length(&v);
    v.map(|x| tidy(x / &length))
}

fn opposite(v: Vector) -> Vector {
    v.map(|x| -x)
}

/// The common normal of two axes. Its direction is that of the two which is nearer to `like`, a direction
/// across the first axis; between parallel axes its foot is at `near`, a point of the first axis.
pub(super) fn common_normal(first: &Axis, second: &Axis, like: &Vector, near: &Vector) -> Normal {
    let across = cross(&first.direction, &second.direction).map(tidy);
    let square = dot(&across, &across);
    let way = between(near, &second.point);
    // The sine of parallel axes is zero (`is_zero`). With fifty digits of a direction, one of 1e-15 leaves 20 digits of
    // the feet.
    let below = |places| square < Rational::ONE / Rational::from(10).pow(places);
    let is_parallel = below(60);
    let (from, to, line) = if is_parallel {
        let along = dot(&way, &first.direction);
        let to = moved(&second.point, &first.direction, &-along);
        let line = between(near, &to);
        (near.clone(), to, line)
    } else {
        // P = near + t u and Q = point + s v, Q - P across both: with w = point - near and n = u x v
        // t = (w x v).n / n.n, s = (w x u).n / n.n
        let along = |direction: &Vector| tidy(dot(&cross(&way, direction), &across) / &square);
        let from = moved(near, &first.direction, &along(&second.direction));
        let to = moved(&second.point, &second.direction, &along(&first.direction));
        let is_backwards = dot(&way, &across) < Rational::ZERO;
        (
            from,
            to,
            if is_backwards {
                opposite(across)
            } else {
                across
            },
        )
    };
    // If the axes are one, any direction across it is normal to both.
    let direction = self::across(&line, &first.direction).unwrap_or_else(|| like.clone());
    let is_like = dot(&direction, like);
    let is_against = is_like < Rational::ZERO && !is_zero(&is_like);
    Normal {
        direction: if is_against {
            opposite(direction)
        } else {
            direction
        },
        from,
        to,
        is_vague: !is_parallel && below(30),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn vector(v: [i64; 3]) -> Vector {
        v.map(Rational::from)
    }

    fn axis(point: [i64; 3], direction: [i64; 3]) -> Axis {
        Axis {
            point: vector(point),
            direction: vector(direction),
        }
    }

    #[test]
    fn every_pair_of_axes_has_a_common_normal() {
        let x = vector([1, 0, 0]);
        let near = vector([0, 0, 2]);
        let z = axis([0, 0, 2], [0, 0, 1]);
        for (second, direction, from, to) in [
            // Skew, parallel, against it, intersecting, coincident.
            (axis([3, 5, 7], [0, 1, 0]), [1, 0, 0], [0, 0, 7], [3, 0, 7]),
            (
                axis([-3, 0, 7], [0, 0, 1]),
                [1, 0, 0],
                [0, 0, 2],
                [-3, 0, 2],
            ),
            (axis([0, 4, 9], [0, 0, -1]), [0, 1, 0], [0, 0, 2], [0, 4, 2]),
            (axis([0, 0, 5], [1, 0, 0]), [0, 1, 0], [0, 0, 5], [0, 0, 5]),
            (axis([0, 0, 9], [0, 0, 1]), [1, 0, 0], [0, 0, 2], [0, 0, 2]),
        ] {
            let normal = common_normal(&z, &second, &x, &near);
            assert_eq!(normal.direction, vector(direction));
            assert_eq!((normal.from, normal.to), (vector(from), vector(to)));
        }
    }

    #[test]
    fn axes_that_are_nearly_parallel_have_a_far_normal() {
        let tilted = unit(&[Rational::ZERO, Rational::ONE, Rational::from(1_000_000)]);
        let second = Axis {
            point: vector([1, 1, 0]),
            direction: tilted,
        };
        let z = axis([0, 0, 0], [0, 0, 1]);
        let normal = common_normal(&z, &second, &vector([1, 0, 0]), &vector([0, 0, 0]));
        assert!(is_zero(&(&normal.from[2] + Rational::from(1_000_000))));
        assert!(is_zero(&(&normal.to[0] - Rational::ONE)));
    }
}
