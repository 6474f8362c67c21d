//! The motion of a base in charts, in which a method of integration may add.
//!
//! Positions add, rotations do not. Within a step the rotation of the base is `R exp(phi x)`, with the rotation R at the
//! start of the step and a rotation vector phi, which begins at 0 and whose entries add.
//!
//! Source: H. Munthe-Kaas, *High order Runge-Kutta methods on manifolds*, Applied Numerical Mathematics 29 (1999), 115-127.
//!
//! R is kept as a quaternion of any length, whose rotation has no error of scale or shear. Roundings of products turn it by
//! about 1e-16 and leave it a rotation, however many steps there are: nothing is made orthogonal afterwards.

use dynamics_runtime::internal::quaternion;
use dynamics_runtime::{Pose, Scalar, Size};
use nalgebra::{Matrix3, Vector3};

/// The chart around a rotation of the base. Coordinates are the position of the base in the world, the rotation vector phi,
/// and the positions of the joints.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Chart {
    /// The rotation at the start of the run.
    pub(crate) initial: Matrix3<f64>,
    /// The turn from there to the centre of the chart, w first.
    turn: [f64; 4],
}

impl Chart {
    /// Around a rotation.
    pub(crate) fn around(initial: Matrix3<f64>) -> Self {
        let turn = [1.0, 0.0, 0.0, 0.0];
        Chart { initial, turn }
    }

    /// The pose of the base.
    pub(crate) fn pose<V: Size>(&self, positions: &V::Vector) -> Pose<f64> {
        let turn = product(self.turn, exponential(&vector::<V>(positions, 3)));
        Pose {
            rotation: self.initial * quaternion::rotation(&turn),
            position: vector::<V>(positions, 0),
        }
    }

    /// The rates of the coordinates, `p' = R exp(phi x) v`, `phi' = w + 1/2 phi x w + c phi x (phi x w)` with the velocities v
    /// and w of the base in its own axes: the inverse of the differential of exp (A. Iserles et al., *Lie-group methods*, Acta
    /// Numerica 9 (2000), (B.11)).
    pub(crate) fn rates<V: Size>(&self, positions: &V::Vector, v: &V::Vector) -> V::Vector {
        let linear = self.pose::<V>(positions).rotation * vector::<V>(v, 0);
        let (phi, w) = (vector::<V>(positions, 3), vector::<V>(v, 3));
        let across = phi.cross(&w);
        let angular = w + across * 0.5 + phi.cross(&across) * curvature(phi.norm_squared());
        V::of(v).vector_of(|k| match k {
            0..3 => linear[k],
            3..6 => angular[k - 3],
            _ => v[k],
        })
    }

    /// The chart around a place, and the coordinates there.
    pub(crate) fn recentred<V: Size>(mut self, positions: &V::Vector) -> (Self, V::Vector) {
        self.turn = product(self.turn, exponential(&vector::<V>(positions, 3)));
        let mut centre = positions.clone();
        for k in 3..6 {
            centre[k] = 0.0;
        }
        (self, centre)
    }
}

/// Three of the numbers of a vector.
fn vector<V: Size>(numbers: &V::Vector, first: usize) -> Vector3<f64> {
    Vector3::from_fn(|i, _| numbers[first + i])
}

/// The quaternion of a rotation vector: cos(a/2), and the vector times sin(a/2) / a, for an angle a.
fn exponential(phi: &Vector3<f64>) -> [f64; 4] {
    let square = phi.norm_squared();
    let half = 0.5 * square.sqrt();
    let (sine, cosine) = <f64 as Scalar>::sin_cos(half);
    // Below 1e-8 the quotient is 1/2 to the last digit.
    let factor = if half < 1e-8 { 0.5 } else { 0.5 * sine / half };
    [cosine, factor * phi.x, factor * phi.y, factor * phi.z]
}

/// The turn of a first quaternion, then of a second one in the turned axes.
fn product([a, b, c, d]: [f64; 4], [w, x, y, z]: [f64; 4]) -> [f64; 4] {
    [
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    ]
}

/// The factor c = (1 - h cot h) / a^2 with h = a/2, of an angle a with the given square.
fn curvature(square: f64) -> f64 {
    /// The series of c in powers of a^2 has the Bernoulli numbers |B_2k| / (2k)!.
    const SERIES: [f64; 8] = [
        1.0 / 12.0,
        1.0 / 720.0,
        1.0 / 30_240.0,
        1.0 / 1_209_600.0,
        1.0 / 47_900_160.0,
        691.0 / 1_307_674_368_000.0,
        1.0 / 74_724_249_600.0,
        3_617.0 / 10_670_622_842_880_000.0,
    ];
    if square < 0.5 {
        return SERIES
            .iter()
            .rev()
            .fold(0.0, |sum, term| sum * square + term);
    }
    let half = 0.5 * square.sqrt();
    let (sine, cosine) = <f64 as Scalar>::sin_cos(half);
    (1.0 - half * cosine / sine) / square
}

#[cfg(test)]
mod tests {
    use dynamics_runtime::internal::quaternion;
    use dynamics_runtime::{DoubleDouble, Scalar};
    use nalgebra::{Const, SVector, Vector3};

    use super::{Chart, curvature, exponential};

    type Six = Const<6>;

    /// Along the rates, the rotation turns by R w x and the position moves by R v: slopes of central differences.
    #[test]
    fn rates_of_coordinates_are_those_of_the_pose() {
        let axis = Vector3::new(0.6, -0.3, 0.2).normalize();
        let v = SVector::from([0.3, -0.4, 0.5, 1.1, 0.7, -0.9]);
        let w = Vector3::new(v[3], v[4], v[5]);
        for angle in [0.0, 1e-9, 1e-3, 0.5, 0.7, 0.8, 2.0, 3.1] {
            let initial = nalgebra::Rotation3::new(Vector3::new(1.0, 2.0, 3.0));
            let chart = Chart::around(*initial.matrix());
            let at = Vector3::new(1.0, 2.0, 3.0).push(0.0).push(0.0).push(0.0);
            let at =
                SVector::<f64, 6>::from_fn(|i, _| if i < 3 { at[i] } else { angle * axis[i - 3] });
            let rates = chart.rates::<Six>(&at, &v);
            let h = 1e-5;
            let [before, after] = [-h, h].map(|h| chart.pose::<Six>(&(at + rates * h)));
            let pose = chart.pose::<Six>(&at);
            let turn = (after.rotation - before.rotation) / (2.0 * h);
            let error = (turn - pose.rotation * w.cross_matrix()).amax();
            assert!(error < 1e-9, "{angle}: {error:e}");
            let way = (after.position - before.position) / (2.0 * h);
            let moved = pose.rotation * Vector3::new(v[0], v[1], v[2]);
            assert!((way - moved).amax() < 1e-10);
        }
    }

    /// The place stays the same in the chart around it.
    #[test]
    fn another_chart_is_another_name_of_the_place() {
        let mut chart = Chart::around(nalgebra::Matrix3::identity());
        let mut at = SVector::from([1.0, 2.0, 3.0, 0.5, -1.2, 0.8]);
        for _ in 0..3 {
            let before = chart.pose::<Six>(&at);
            (chart, at) = chart.recentred::<Six>(&at);
            assert_eq!((at[3], at[4], at[5]), (0.0, 0.0, 0.0));
            let after = chart.pose::<Six>(&at);
            assert!((before.rotation - after.rotation).amax() < 1e-15);
            assert_eq!(before.position, after.position);
            (at[3], at[4], at[5]) = (-0.4, 0.9, 1.3);
        }
    }

    /// Beside 31 digits, on both sides of the place at which the series ends.
    #[test]
    fn the_curvature_has_all_its_digits() {
        for square in [1e-30, 1e-6, 0.1, 0.4999, 0.5, 0.6, 2.0, 9.0] {
            let exact = DoubleDouble::from_f64(square);
            let half = exact.sqrt() * DoubleDouble::from_f64(0.5);
            let (sine, cosine) = half.sin_cos();
            let one = DoubleDouble::from_f64(1.0);
            let exact = ((one - half * cosine / sine) / exact).to_f64();
            // Below 1e-6 the digits of the quotient cancel in 31 digits too.
            let exact = if square < 1e-5 {
                1.0 / 12.0 + square / 720.0
            } else {
                exact
            };
            let error = (curvature(square) / exact - 1.0).abs();
            assert!(error < 3e-15, "{square}: {error:e}");
        }
    }

    #[test]
    fn the_exponential_is_that_of_rotations() {
        for angle in [0.0, 1e-200, 1e-9, 0.3, 3.0] {
            let phi = Vector3::new(2.0, -1.0, 0.5).normalize() * angle;
            let found = quaternion::rotation(&exponential(&phi));
            let expected = nalgebra::Rotation3::new(phi).into_inner();
            assert!((found - expected).amax() < 1e-15, "{angle}");
        }
    }
}
