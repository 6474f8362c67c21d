//! Values of functions as numbers one after the other.

use nalgebra::allocator::Allocator;
use nalgebra::{DefaultAllocator, Dim, OMatrix, SMatrix};

use crate::{Scalar, SingularMassMatrix};

/// A value of a generated function in the numbers `T`: a number, a matrix, an array or a tuple of these, or an error in
/// their place.
///
/// As a list of numbers, matrices count by columns, and arrays and tuples one part after the other. A `Vec` is as long as
/// the numbers last.
pub trait FunctionValue<T: Scalar>: Numbers<T> + Sized {
    /// The value whose numbers are the first of these, which are taken away; `None` if they are too few.
    fn take(numbers: &mut &[T]) -> Option<Self>;

    /// The error that replaces numbers.
    fn refusal(&self) -> Option<SingularMassMatrix> {
        None
    }

    /// The value of a function that refuses, if it can be said in this type.
    fn refused(error: SingularMassMatrix) -> Option<Self> {
        let _ = error;
        None
    }
}

/// Numbers one after the other: matrices by columns, arrays and tuples one part after the other.
pub trait Numbers<T: Scalar> {
    /// Appends its numbers.
    fn write(&self, numbers: &mut Vec<T>);
}

/// The numbers of a value.
pub fn flat<T: Scalar>(value: &impl Numbers<T>) -> Vec<T> {
    let mut numbers = Vec::new();
    value.write(&mut numbers);
    numbers
}

/// The value of these numbers; `None` if it has more or fewer.
pub(crate) fn read<T: Scalar, V: FunctionValue<T>>(mut numbers: &[T]) -> Option<V> {
    let value = V::take(&mut numbers);
    value.filter(|_| numbers.is_empty())
}

impl<T: Scalar> Numbers<T> for T {
    fn write(&self, numbers: &mut Vec<T>) {
        numbers.push(*self);
    }
}

impl<T: Scalar> FunctionValue<T> for T {
    fn take(numbers: &mut &[T]) -> Option<Self> {
        numbers.split_off_first().copied()
    }
}

impl<T: Scalar, R: Dim, C: Dim> Numbers<T> for OMatrix<T, R, C>
where
    DefaultAllocator: Allocator<R, C>,
{
    fn write(&self, numbers: &mut Vec<T>) {
        numbers.extend(self.iter());
    }
}

impl<T: Scalar, const R: usize, const C: usize> FunctionValue<T> for SMatrix<T, R, C> {
    fn take(numbers: &mut &[T]) -> Option<Self> {
        let own = numbers.split_off(..R * C)?;
        Some(SMatrix::from_column_slice(own))
    }
}

impl<T: Scalar, V: Numbers<T>, const K: usize> Numbers<T> for [V; K] {
    fn write(&self, numbers: &mut Vec<T>) {
        self.iter().for_each(|part| part.write(numbers));
    }
}

impl<T: Scalar, V: FunctionValue<T>, const K: usize> FunctionValue<T> for [V; K] {
    fn take(numbers: &mut &[T]) -> Option<Self> {
        let mut parts = Vec::with_capacity(K);
        for _ in 0..K {
            parts.push(V::take(numbers)?);
        }
        parts.try_into().ok()
    }
}

impl<T: Scalar, V: Numbers<T>> Numbers<T> for Vec<V> {
    fn write(&self, numbers: &mut Vec<T>) {
        self.iter().for_each(|part| part.write(numbers));
    }
}

impl<T: Scalar, V: FunctionValue<T>> FunctionValue<T> for Vec<V> {
    fn take(numbers: &mut &[T]) -> Option<Self> {
        let mut parts = Vec::new();
        while !numbers.is_empty() {
            let before = numbers.len();
            parts.push(V::take(numbers)?);
            // A part without numbers would be there without end.
            if numbers.len() == before {
                return None;
            }
        }
        Some(parts)
    }
}

impl<T: Scalar, V: Numbers<T>> Numbers<T> for Result<V, SingularMassMatrix> {
    fn write(&self, numbers: &mut Vec<T>) {
        if let Ok(value) = self {
            value.write(numbers);
        }
    }
}

impl<T: Scalar, V: FunctionValue<T>> FunctionValue<T> for Result<V, SingularMassMatrix> {
    fn take(numbers: &mut &[T]) -> Option<Self> {
        V::take(numbers).map(Ok)
    }

    fn refusal(&self) -> Option<SingularMassMatrix> {
        self.as_ref().err().copied()
    }

    fn refused(error: SingularMassMatrix) -> Option<Self> {
        Some(Err(error))
    }
}

macro_rules! impl_tuple {
    ($($part:ident $value:ident),*) => {
        impl<T: Scalar, $($part: Numbers<T>),*> Numbers<T> for ($($part,)*) {
            fn write(&self, numbers: &mut Vec<T>) {
                let ($($value,)*) = self;
                $($value.write(numbers);)*
            }
        }

        impl<T: Scalar, $($part: FunctionValue<T>),*> FunctionValue<T> for ($($part,)*) {
            fn take(numbers: &mut &[T]) -> Option<Self> {
                Some(($($part::take(numbers)?,)*))
            }
        }
    };
}

impl_tuple!(A a, B b);
impl_tuple!(A a, B b, C c);
impl_tuple!(A a, B b, C c, D d);
