//! Values of functions whose arrangement is known at run time.

use dynamics_runtime::nalgebra::{DMatrix, DVector};
use dynamics_symbolic::Request;
use dynamics_symbolic::function::{Shape, Sizes};

/// The value of a function, in the arrangement that generated code returns it in.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A number.
    Number(f64),
    /// A matrix; a vector is one of a single column.
    Matrix(DMatrix<f64>),
    /// An array of one for each joint.
    Each(Vec<Value>),
    /// A tuple.
    Tuple(Vec<Value>),
}

impl Value {
    /// The value of a request among its entries, in the order of its shape, matrices by columns.
    pub(crate) fn new(request: &Request, sizes: Sizes, entries: &[f64]) -> Self {
        let mut entries = entries.iter().copied();
        let functions = request.functions();
        let mut values = functions.map(|function| read(function.shape(), sizes, &mut entries));
        if request.is_tuple() {
            return Value::Tuple(values.collect());
        }
        values.next().expect("a request has a part")
    }
}

fn read(shape: &Shape, sizes: Sizes, entries: &mut impl Iterator<Item = f64>) -> Value {
    match shape {
        Shape::Number => Value::Number(entries.next().unwrap_or(f64::NAN)),
        Shape::Matrix(rows, columns) => {
            let (rows, columns) = (rows.of(sizes), columns.of(sizes));
            let of_matrix = entries.by_ref().take(rows * columns);
            Value::Matrix(DMatrix::from_iterator(rows, columns, of_matrix))
        }
        Shape::Each(count, one) => {
            let all = 0..count.of(sizes);
            Value::Each(all.map(|_| read(one, sizes, entries)).collect())
        }
        Shape::Tuple(parts) => Value::Tuple(
            parts
                .iter()
                .map(|(_, part)| read(part, sizes, entries))
                .collect(),
        ),
        // Not evaluated here.
        Shape::Series => Value::Tuple(Vec::new()),
    }
}

/// A result of the methods of a [`RuntimeRobot`](crate::RuntimeRobot): a [`Value`] of a known arrangement.
pub(crate) trait FromValue: Sized {
    /// The value; `None` where it is arranged otherwise.
    fn from_value(value: Value) -> Option<Self>;
}

impl FromValue for f64 {
    fn from_value(value: Value) -> Option<Self> {
        match value {
            Value::Number(x) => Some(x),
            _ => None,
        }
    }
}

impl FromValue for DMatrix<f64> {
    fn from_value(value: Value) -> Option<Self> {
        match value {
            Value::Matrix(matrix) => Some(matrix),
            _ => None,
        }
    }
}

impl FromValue for DVector<f64> {
    fn from_value(value: Value) -> Option<Self> {
        let matrix = DMatrix::from_value(value)?;
        (matrix.ncols() == 1).then(|| DVector::from_column_slice(matrix.as_slice()))
    }
}

impl<V: FromValue> FromValue for Vec<V> {
    fn from_value(value: Value) -> Option<Self> {
        match value {
            Value::Each(values) => values.into_iter().map(V::from_value).collect(),
            _ => None,
        }
    }
}

macro_rules! impl_from_value_for_tuples {
    ($(($($value:ident)*))*) => {$(
        impl<$($value: FromValue),*> FromValue for ($($value,)*) {
            fn from_value(value: Value) -> Option<Self> {
                let Value::Tuple(values) = value else {
                    return None;
                };
                let mut values = values.into_iter();
                Some(($($value::from_value(values.next()?)?,)*))
            }
        }
    )*};
}

impl_from_value_for_tuples!((A B) (A B C) (A B C D));
