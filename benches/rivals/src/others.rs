//! Functions that only the generated code has, and their rounding errors.

use robot_dynamics::DoubleDouble;
use robot_dynamics::nalgebra::SMatrix;

/// Hands the numbers of a function's value on, matrix by matrix.
pub(crate) trait Matrices<T> {
    fn for_each(&self, f: impl FnMut(&[T]));
}

macro_rules! number {
    ($($number:ty)*) => {$(
        impl Matrices<$number> for $number {
            fn for_each(&self, mut f: impl FnMut(&[$number])) {
                f(std::slice::from_ref(self));
            }
        }
    )*};
}
number!(f64 DoubleDouble);

impl<T, const R: usize, const C: usize> Matrices<T> for SMatrix<T, R, C> {
    fn for_each(&self, mut f: impl FnMut(&[T])) {
        f(self.as_slice());
    }
}

impl<T, A: Matrices<T>, B: Matrices<T>> Matrices<T> for (A, B) {
    fn for_each(&self, mut f: impl FnMut(&[T])) {
        self.0.for_each(&mut f);
        self.1.for_each(&mut f);
    }
}

impl<T, A: Matrices<T>, B: Matrices<T>, C: Matrices<T>> Matrices<T> for (A, B, C) {
    fn for_each(&self, mut f: impl FnMut(&[T])) {
        self.0.for_each(&mut f);
        self.1.for_each(&mut f);
        self.2.for_each(&mut f);
    }
}

/// The largest error of a value's numbers, each relative to the largest number of its matrix, against
/// the same function in arithmetic of 31 digits. NaN is the largest of all.
pub(crate) fn rounding_error<A: Matrices<f64>, B: Matrices<DoubleDouble>>(
    value: &A,
    accurate: &B,
) -> f64 {
    let mut numbers: Vec<Vec<f64>> = Vec::new();
    value.for_each(|matrix| numbers.push(matrix.to_vec()));
    let mut numbers = numbers.into_iter();
    let mut worst = 0.0_f64;
    accurate.for_each(|accurate| {
        let matrix = numbers.next().expect("as many matrices");
        let largest = accurate.iter().map(|x| x.high().abs()).fold(0.0, f64::max);
        for (x, exact) in matrix.iter().zip(accurate) {
            let error = (*exact - DoubleDouble::from(*x)).high().abs();
            let relative = if error == 0.0 { 0.0 } else { error / largest };
            worst = if relative <= worst { worst } else { relative };
        }
    });
    worst
}
