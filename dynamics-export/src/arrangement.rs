//! Values in their arrangement: vectors, matrices, and lists of these.

use crate::body::number;
use dynamics_symbolic::function::{Request, Shape, Size, Sizes};

/// How a language writes a value.
pub(crate) struct Arrangement {
    pub(crate) number: fn(String) -> String,
    pub(crate) vector: fn(&[String]) -> String,
    /// A matrix of its rows.
    pub(crate) matrix: fn(&[Vec<String>]) -> String,
    /// Values of different arrangements, or one for each link.
    pub(crate) list: fn(&[String]) -> String,
}

impl Arrangement {
    /// The value of each part of a request.
    pub(crate) fn values(
        &self,
        request: &Request,
        sizes: Sizes,
        values: &[Vec<String>],
    ) -> Vec<String> {
        let parts = request.parts().iter().zip(values);
        let of_part = |(part, values): (&dynamics_symbolic::function::Part, &Vec<String>)| {
            self.value(part.function.shape(), sizes, &mut values.iter())
        };
        parts.map(of_part).collect()
    }

    fn value<'v>(
        &self,
        shape: &Shape,
        sizes: Sizes,
        values: &mut impl Iterator<Item = &'v String>,
    ) -> String {
        let mut entries = |count: usize| -> Vec<String> {
            let entry = |_| values.next().cloned().unwrap_or_else(|| number(0.0));
            (0..count).map(entry).collect()
        };
        match shape {
            Shape::Number => (self.number)(entries(1).concat()),
            Shape::Matrix(rows, Size::One) => (self.vector)(&entries(rows.of(sizes))),
            Shape::Matrix(rows, columns) => {
                let rows = (0..rows.of(sizes)).map(|_| entries(columns.of(sizes)));
                (self.matrix)(&rows.collect::<Vec<_>>())
            }
            Shape::Each(count, one) => {
                let all = (0..count.of(sizes)).map(|_| self.value(one, sizes, values));
                (self.list)(&all.collect::<Vec<_>>())
            }
            Shape::Tuple(parts) => {
                let all = parts
                    .iter()
                    .map(|(_, part)| self.value(part, sizes, values));
                (self.list)(&all.collect::<Vec<_>>())
            }
            // Never written: it is no program over numbers.
            Shape::Series => (self.list)(&[]),
        }
    }
}
