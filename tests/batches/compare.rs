//! Results of any shape beside each other.

use robot_dynamics::nalgebra::SMatrix;
use robot_dynamics::{Scalar, SingularMassMatrix, batch::BatchError};

/// The result of a single call.
pub(crate) trait Outcome {
    type Value: Numbers;

    fn outcome(self) -> Result<Self::Value, SingularMassMatrix>;
}

impl<V: Numbers> Outcome for Result<V, SingularMassMatrix> {
    type Value = V;

    fn outcome(self) -> Self {
        self
    }
}

/// Numbers in some shape.
pub(crate) trait Numbers: Copy {
    /// The distance from 1 to the next larger one.
    const EPSILON: f64;

    fn tell(&self, tell: &mut dyn FnMut(f64));
}

macro_rules! of_one_shape {
    ($([$($generic:tt)*] $shape:ty: $inner:ty, |$value:ident, $tell:ident| $do:expr;)*) => {$(
        impl<$($generic)*> Numbers for $shape {
            const EPSILON: f64 = <$inner>::EPSILON;

            fn tell(&self, $tell: &mut dyn FnMut(f64)) {
                let $value = self;
                $do;
            }
        }

        impl<$($generic)*> Outcome for $shape {
            type Value = Self;

            fn outcome(self) -> Result<Self, SingularMassMatrix> {
                Ok(self)
            }
        }
    )*};
}

of_one_shape! {
    [] f32: f32f64::Single, |value, tell| tell(f64::from(*value));
    [] f64: f32f64::Double, |value, tell| tell(*value);
    [T: Numbers + Scalar, const R: usize, const C: usize] SMatrix<T, R, C>: T,
        |value, tell| value.iter().for_each(|x| x.tell(tell));
    [V: Numbers, const K: usize] [V; K]: V, |value, tell| value.iter().for_each(|x| x.tell(tell));
    [A: Numbers, B: Numbers] (A, B): A, |value, tell| {
        value.0.tell(tell);
        value.1.tell(tell);
    };
    [A: Numbers, B: Numbers, C: Numbers] (A, B, C): A, |value, tell| {
        value.0.tell(tell);
        value.1.tell(tell);
        value.2.tell(tell);
    };
    [A: Numbers, B: Numbers, C: Numbers, D: Numbers] (A, B, C, D): A, |value, tell| {
        value.0.tell(tell);
        value.1.tell(tell);
        value.2.tell(tell);
        value.3.tell(tell);
    };
}

/// The precisions, where a type of the language has a constant of the same name.
mod f32f64 {
    pub(super) enum Single {}
    pub(super) enum Double {}

    impl Single {
        pub(super) const EPSILON: f64 = f32::EPSILON as f64;
    }

    impl Double {
        pub(super) const EPSILON: f64 = f64::EPSILON;
    }
}

fn numbers(value: &impl Numbers) -> Vec<f64> {
    let mut numbers = Vec::new();
    value.tell(&mut |x| numbers.push(x));
    numbers
}

/// The largest difference from single calls, in units in the last place of the largest number of the batch. Lanes fuse
/// sums of products where a plain build does not. Solving with M loses digits, according to its condition.
const ULPS: f64 = 2000.0;

/// Compares a batch with single calls: its values, and the first state without one.
#[track_caller]
pub(crate) fn compare<V: Numbers>(
    name: &str,
    single: &[Result<V, SingularMassMatrix>],
    batch: impl FnOnce(&mut Vec<V>) -> Result<(), BatchError>,
) {
    let any = single.iter().flatten().last();
    let mut found = any.map_or(Vec::new(), |value| vec![*value; single.len()]);
    let error = single.iter().enumerate().find_map(|(state, value)| {
        let error = value.as_ref().err().copied();
        error.map(|error| BatchError::Singular { state, error })
    });
    assert_eq!(batch(&mut found).err(), error, "{name}");
    let values = single.iter().flatten().flat_map(numbers);
    let largest = values.fold(0.0_f64, |largest, x| largest.max(x.abs()));
    for (state, (single, found)) in single.iter().zip(&found).enumerate() {
        for (i, x) in numbers(found).into_iter().enumerate() {
            match single {
                Ok(value) => {
                    let error = (x - numbers(value)[i]).abs();
                    let bound = ULPS * V::EPSILON * largest;
                    assert!(
                        error <= bound,
                        "{name}: state {state}: {error:e} of {largest:e}"
                    );
                }
                Err(_) => assert!(x.is_nan(), "{name}: state {state}: {x}"),
            }
        }
    }
}
