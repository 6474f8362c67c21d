//! The lanes of every instruction set that this processor has.

use fearless_simd::{Level, Simd};
use nalgebra::{Matrix3, SVector, Vector2, Vector3};

use super::layout::{States, StatesMut};
use super::run::{Failure, Task};
use crate::function::{Entries, Function, functions};
use crate::random::SplitMix64;
use crate::sine::Kernel as _;
use crate::sine::tests::{angles, ulps, ulps_of_single};
use crate::{
    Batch as _, DoubleDouble, ForwardDynamics, GravityVector, InverseDynamics, MassMatrix, Part,
    Scalar, SingularMassMatrix,
};

const M: functions::MassMatrix = functions::MassMatrix;

/// The instruction sets that this processor has.
fn levels() -> Vec<Level> {
    let best = Level::new();
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    {
        let lesser = [
            best.as_sse2().map(Simd::level),
            best.as_sse4_2().map(Simd::level),
            best.as_avx2().map(Simd::level),
        ];
        let mut levels: Vec<_> = lesser.into_iter().flatten().collect();
        levels.push(best);
        levels
    }
    #[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
    vec![best]
}

/// No arm: each operation of [`Scalar`] for itself.
struct Operations;

impl InverseDynamics<3> for Operations {
    #[inline(always)]
    fn inverse_dynamics<T: Scalar>(
        &self,
        a: &Vector3<T>,
        b: &Vector3<T>,
        c: &Vector3<T>,
    ) -> Vector3<T> {
        let root = (b[1] * b[1] + a[1].constant(0.25)).sqrt();
        Vector3::new(
            a[0] * T::from_f64(3.0) - a[1] / c[0],
            a[2].sign() + root * b[2].sign(),
            -c[2] * T::epsilon(),
        )
    }
}

impl MassMatrix<3> for Operations {
    /// Products and sums alone.
    #[inline(always)]
    fn mass_matrix<T: Scalar>(&self, q: &Vector3<T>) -> Matrix3<T> {
        Matrix3::from_fn(|i, j| q[i] * q[j] - q[i].constant(0.1 * j as f64))
    }
}

fn states<const N: usize>(count: usize, seed: u64) -> Vec<SVector<f64, N>> {
    let mut random = SplitMix64(seed);
    let state = |_| SVector::from_fn(|_, _| random.within(&(-4.0..=4.0)));
    (0..count).map(state).collect()
}

/// The arrangement of three vectors.
type Three<const N: usize> = (Entries<N, 1>, Entries<N, 1>, Entries<N, 1>);

/// The function at three vectors for each state.
fn of_three<F: Copy, R, const N: usize>(
    level: Level,
    function: F,
    robot: &R,
    [a, b, c]: [&Vec<SVector<f64, N>>; 3],
) -> (Vec<SVector<f64, N>>, Failure)
where
    R: Function<F, N, Arguments = Three<N>, Values = Entries<N, 1>>,
{
    let mut values = vec![SVector::repeat(7.0); a.len()];
    let arguments = (a.source(), b.source(), c.source());
    let mut results = StatesMut::<Entries<N, 1>>::sink(&mut values);
    let task = Task::<R, f64, _, _, _, _, N>::new(function, robot, &arguments, &mut results);
    let failure = task.expect("all as long").run(level);
    (values, failure)
}

#[test]
fn every_operation_is_that_of_a_double_in_every_lane() {
    for count in 0..=20 {
        let (mut a, mut b, c) = (states(count, 1), states(count, 2), states(count, 3));
        let special = [0.0, -0.0, f64::NAN, f64::INFINITY, -3e6, 1e22];
        for (i, x) in special.into_iter().enumerate().filter(|(i, _)| *i < count) {
            a[i][0] = x;
            a[i][2] = x;
            b[count - 1 - i][2] = x;
        }
        for level in levels() {
            let (values, failure) =
                of_three(level, functions::InverseDynamics, &Operations, [&a, &b, &c]);
            assert!(failure.is_none());
            for (i, value) in values.iter().enumerate() {
                let expected = Operations.inverse_dynamics(&a[i], &b[i], &c[i]);
                let [value, expected] = [value, &expected].map(|v| v.map(f64::to_bits));
                let same = value.iter().zip(&expected).all(|(x, y)| {
                    x == y || f64::from_bits(*x).is_nan() && f64::from_bits(*y).is_nan()
                });
                assert!(same, "{level:?}: state {i} of {count}");
            }
        }
    }
}

/// The sine of an angle, the cosine of another, and the sine of a third.
struct SinesOfThree {
    /// Each without the other part.
    alone: bool,
}

const SINES_OF_THREE: [SinesOfThree; 2] =
    [SinesOfThree { alone: false }, SinesOfThree { alone: true }];

impl InverseDynamics<3> for SinesOfThree {
    #[inline(always)]
    fn inverse_dynamics<T: Scalar>(
        &self,
        a: &Vector3<T>,
        _: &Vector3<T>,
        _: &Vector3<T>,
    ) -> Vector3<T> {
        let angles = [a[0], a[1], a[2]];
        let [(first, _), (_, second), (third, _)] = if self.alone {
            T::sin_cos_parts(angles, [Part::Sine, Part::Cosine, Part::Sine])
        } else {
            T::sin_cos_array(angles)
        };
        Vector3::new(first, second, third)
    }
}

/// Angles of which the first two are the same.
fn triples<T: Copy>(angles: &[T]) -> Vec<[T; 3]> {
    let triple = |pair: &[T]| [pair[0], pair[0], pair[1]];
    angles.chunks_exact(2).map(triple).collect()
}

fn assert_sines_in_lanes_below_one_ulp(count: usize) {
    let triples = triples(&angles(count, 4));
    let a: Vec<_> = triples.iter().map(|x| SVector::from(*x)).collect();
    let exact = |x: &[f64; 3]| {
        let [sine, cosine] = <[_; 2]>::from(DoubleDouble::from(x[0]).sin_cos());
        [sine, cosine, DoubleDouble::from(x[2]).sin_cos().0]
    };
    let exact: Vec<_> = triples.iter().map(exact).collect();
    for (level, sines) in levels()
        .into_iter()
        .flat_map(|l| SINES_OF_THREE.map(|s| (l, s)))
    {
        let torques = functions::InverseDynamics;
        let (values, _) = of_three(level, torques, &sines, [&a, &a, &a]);
        let mut largest = 0.0_f64;
        for (exact, value) in exact.iter().zip(&values) {
            for (found, exact) in value.iter().zip(exact) {
                largest = largest.max(ulps(*found, *exact));
            }
        }
        println!("{level:?}: {largest} ulp, alone: {}", sines.alone);
        assert!(largest < 0.95, "{level:?}: {largest}");
    }
}

#[test]
fn sines_in_lanes_stay_below_one_ulp() {
    assert_sines_in_lanes_below_one_ulp(20_000);
}

#[test]
#[ignore = "takes seconds: .ci/run runs it"]
fn sines_of_many_angles_in_lanes_stay_below_one_ulp() {
    assert_sines_in_lanes_below_one_ulp(100_000);
}

#[test]
fn sines_of_singles_in_lanes_stay_below_one_ulp() {
    let bits = (0..=f32::LARGEST.to_bits()).step_by(40_009);
    let all: Vec<f32> = bits.map(f32::from_bits).flat_map(|x| [x, -x]).collect();
    let a: Vec<_> = triples(&all).into_iter().map(SVector::from).collect();
    for sines in SINES_OF_THREE {
        let mut values = vec![Vector3::zeros(); a.len()];
        sines
            .inverse_dynamics_batch(&a, &a, &a, &mut values)
            .unwrap();
        let mut largest = 0.0_f64;
        for (x, value) in a.iter().zip(&values) {
            let [first, second, third] = <[f32; 3]>::from(*x).map(f64::from);
            for (found, exact) in value.iter().zip([first.sin(), second.cos(), third.sin()]) {
                largest = largest.max(ulps_of_single(*found, exact));
            }
        }
        println!("{largest} ulp, alone: {}", sines.alone);
        assert!(largest < 0.95, "{largest}");
    }
}

/// Zeros keep their sign; a group with an angle beyond the lanes' reduction, or none, has the digits of one
/// state.
#[test]
fn special_angles_in_lanes() {
    let special = [
        0.0,
        -0.0,
        5e-324,
        -5e-324,
        f64::NAN,
        f64::INFINITY,
        3e6,
        -1e22,
    ];
    for (level, sines) in levels()
        .into_iter()
        .flat_map(|l| SINES_OF_THREE.map(|s| (l, s)))
    {
        for (place, angle) in special.into_iter().enumerate() {
            let mut a = vec![Vector3::zeros(); 9];
            a[place] = Vector3::repeat(angle);
            let torques = functions::InverseDynamics;
            let (values, _) = of_three(level, torques, &sines, [&a, &a, &a]);
            for (x, value) in a.iter().zip(&values) {
                let expected = sines.inverse_dynamics(x, x, x);
                let same =
                    |(x, y): (&f64, &f64)| x.to_bits() == y.to_bits() || y.is_nan() && x.is_nan();
                assert!(
                    value.iter().zip(&expected).all(same),
                    "{level:?}: {x:?}: {value:?}"
                );
            }
        }
    }
}

#[test]
fn matrices_come_in_either_layout() {
    for level in levels() {
        for count in [0, 1, 7, 8, 9, 20] {
            let q = states::<3>(count, 5);
            let mut rows = vec![Matrix3::zeros(); count];
            let mut entries = [[(); 3]; 3].map(|column| column.map(|()| vec![0.0; count]));
            let q_columns = [0, 1, 2].map(|j| q.iter().map(|q| q[j]).collect::<Vec<_>>());
            let views = q_columns.each_ref().map(|column| &column[..]);
            let mut rows_sink = StatesMut::<Entries<3, 3>>::sink(&mut rows);
            let by_rows = ((&q).source(),);
            let task = Task::<Operations, f64, _, _, _, _, 3>::new(
                M,
                &Operations,
                &by_rows,
                &mut rows_sink,
            );
            task.unwrap().run(level);
            let mut sink = StatesMut::<Entries<3, 3>>::sink(&mut entries);
            let by_columns = (views.source(),);
            let task =
                Task::<Operations, f64, _, _, _, _, 3>::new(M, &Operations, &by_columns, &mut sink);
            task.unwrap().run(level);
            for (state, q) in q.iter().enumerate() {
                let expected = Operations.mass_matrix(q);
                assert_eq!(rows[state], expected, "{level:?}");
                let found = Matrix3::from_fn(|i, j| entries[j][i][state]);
                assert_eq!(found, expected, "{level:?}");
            }
        }
    }
}

/// Two point masses at the ends of rods of 0.5 m and 0.3 m, the first one without mass. Its constants are made by `from_f64`,
/// with no lane to ask.
struct Rods;

impl ForwardDynamics<2> for Rods {
    fn forward_dynamics<T: Scalar>(
        &self,
        q: &Vector2<T>,
        qd: &Vector2<T>,
        tau: &Vector2<T>,
    ) -> Result<Vector2<T>, SingularMassMatrix> {
        let [mass, near, far] = [2.3, 0.5, 0.3].map(T::from_f64);
        let (sin, cos) = q[1].sin_cos();
        let (outer, mixed) = (mass * far * far, mass * near * far);
        let (m11, m12) = (
            mass * near * near + mixed * (cos + cos) + outer,
            mixed * cos + outer,
        );
        let pivot = m11 - m12 * m12 / outer;
        if !pivot.is_positive() {
            return Err(SingularMassMatrix::new(0, pivot.ratio_to_f64(m11)));
        }
        let turning = mixed * sin;
        let first = tau[0] + turning * qd[1] * (qd[0] + qd[0] + qd[1]);
        let second = tau[1] - turning * qd[0] * qd[0];
        let qdd = (first - m12 / outer * second) / pivot;
        Ok(Vector2::new(qdd, (second - m12 * qdd) / outer))
    }
}

#[test]
fn a_state_without_accelerations_is_found_in_any_lane() {
    // Stretched, the arm has no inertia along itself.
    let arm = Rods;
    let (q, qd, tau) = (states(21, 7), states(21, 8), states(21, 9));
    for level in levels() {
        for singular in 0..21 {
            let mut q = q.clone();
            q[singular][1] = 0.0;
            let (values, failure) =
                of_three(level, functions::ForwardDynamics, &arm, [&q, &qd, &tau]);
            let error = arm.forward_dynamics(&q[singular], &qd[singular], &tau[singular]);
            assert_eq!(failure, error.err().map(|error| (singular, error)));
            for (i, value) in values.iter().enumerate() {
                match arm.forward_dynamics(&q[i], &qd[i], &tau[i]) {
                    Ok(expected) => {
                        let error: Vector2<f64> = value - expected;
                        assert!(error.amax() <= 1e-12 * expected.amax(), "{level:?}: {i}");
                    }
                    Err(_) => assert!(value.iter().all(|x| x.is_nan())),
                }
            }
        }
    }
}

/// A body without joints.
struct Body;

impl GravityVector<0> for Body {
    fn gravity_vector<T: Scalar>(&self, q: &SVector<T, 0>) -> SVector<T, 0> {
        *q
    }
}

/// Vectors of no numbers have no first one, which was read.
#[test]
fn a_body_without_joints_has_batches() {
    let q = vec![SVector::<f64, 0>::zeros(); 21];
    let mut values = q.clone();
    Body.gravity_vector_batch(&q, &mut values)
        .expect("as many values as states");
}
