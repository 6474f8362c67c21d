//! The outputs of a program: values in their arrangement, and tests of pivots.

use dynamics_runtime::{Scalar, SingularMassMatrix};
use dynamics_symbolic::Request;
use dynamics_symbolic::function::{Freedoms, Shape, Sizes, sizes_of, spans};

/// The outputs of a program.
#[derive(Clone, Debug)]
pub(crate) struct Layout {
    /// The sizes of the values.
    pub(crate) sizes: Sizes,
    /// The outputs that are values, each with its place among them. Values stand in the order of
    /// the shape, matrices by columns.
    pub(crate) values: Vec<(usize, usize)>,
    /// The same with matrices by rows, in the order of the places.
    pub(crate) by_rows: Vec<(usize, usize)>,
    /// The tests that M is not singular, in the order in which they are made.
    pub(crate) tests: Vec<Test>,
}

/// A test of a pivot: two outputs.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Test {
    /// The joint.
    pub(crate) joint: usize,
    /// The pivot.
    pub(crate) pivot: usize,
    /// The entry of M on the diagonal.
    pub(crate) diagonal: usize,
}

impl Test {
    /// Whether the pivot is one, where the outputs have the values that `of` gives them.
    pub(crate) fn result<T: Scalar>(
        &self,
        of: impl Fn(usize) -> T,
    ) -> Result<(), SingularMassMatrix> {
        SingularMassMatrix::test(self.joint, of(self.pivot), of(self.diagonal))
    }
}

impl Layout {
    /// The outputs of a program, which are so many, of a robot with these degrees of freedom.
    pub(crate) fn new(request: &Request, freedoms: Freedoms, outputs: usize) -> Self {
        let sizes = sizes_of(request.parts(), freedoms, outputs);
        let spans = spans(request.parts(), freedoms, outputs);
        let joints = freedoms.all();
        let (mut places, mut values, mut tests) = (Vec::new(), Vec::new(), Vec::new());
        for (function, span) in request.functions().zip(spans) {
            let start = places.len();
            by_columns(function.shape(), sizes, &mut places);
            let places = places[start..].iter();
            values.extend((span.start..).zip(places.copied()));
            if function.has_pivots() {
                let pivots = span.end - 2 * joints;
                tests.extend((0..joints).rev().map(|joint| Test {
                    joint,
                    pivot: pivots + joint,
                    diagonal: pivots + joints + joint,
                }));
            }
        }
        let outputs = values.iter().enumerate();
        let by_rows = outputs.map(|(place, (output, _))| (*output, place));
        Layout {
            sizes,
            by_rows: by_rows.collect(),
            values,
            tests,
        }
    }

    /// How many values there are.
    pub(crate) fn entries(&self) -> usize {
        self.values.len()
    }

    /// The values among these outputs.
    pub(crate) fn values_of<T: Copy>(&self, outputs: &[T]) -> Vec<T> {
        let mut values: Vec<Option<T>> = vec![None; self.values.len()];
        for &(output, place) in &self.values {
            values[place] = Some(outputs[output]);
        }
        values.into_iter().flatten().collect()
    }
}

/// The places of values that come by rows.
fn by_columns(shape: &Shape, sizes: Sizes, places: &mut Vec<usize>) {
    let start = places.len();
    match shape {
        Shape::Number => places.push(start),
        Shape::Matrix(rows, columns) => {
            let (rows, columns) = (rows.of(sizes), columns.of(sizes));
            let entries = (0..rows).flat_map(|i| (0..columns).map(move |j| (i, j)));
            places.extend(entries.map(|(i, j)| start + j * rows + i));
        }
        Shape::Each(count, one) => {
            (0..count.of(sizes)).for_each(|_| by_columns(one, sizes, places))
        }
        Shape::Tuple(parts) => parts
            .iter()
            .for_each(|(_, part)| by_columns(part, sizes, places)),
        // Not evaluated here.
        Shape::Series => {}
    }
}
