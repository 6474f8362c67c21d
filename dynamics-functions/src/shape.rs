//! The arrangement of values: vectors, matrices, and arrays and tuples of them.

/// A number of rows or columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Size {
    /// One: a matrix of one column is a vector.
    One,
    /// So many of every robot.
    Fixed(usize),
    /// One for each joint that moves.
    Joints,
    /// One for each pair of joints, in the order (1,2), (1,3), ..., (n-1,n).
    Pairs,
    /// One for each base inertial parameter.
    Parameters,
}

/// The sizes of one robot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sizes {
    /// Joints.
    pub joints: usize,
    /// Base inertial parameters.
    pub parameters: usize,
}

impl Sizes {
    /// The sizes with which some values are so many, where `count` gives their number; no parameters where these do not
    /// matter.
    pub(super) fn with_count(joints: usize, values: usize, count: impl Fn(Sizes) -> usize) -> Self {
        let [without, with_one] = [0, 1].map(|parameters| count(Sizes { joints, parameters }));
        let rest = values.saturating_sub(without);
        let parameters = rest.checked_div(with_one - without).unwrap_or(0);
        Sizes { joints, parameters }
    }
}

impl Size {
    /// The number.
    pub fn of(self, sizes: Sizes) -> usize {
        match self {
            Size::One => 1,
            Size::Fixed(count) => count,
            Size::Joints => sizes.joints,
            Size::Pairs => sizes.joints * sizes.joints.saturating_sub(1) / 2,
            Size::Parameters => sizes.parameters,
        }
    }
}

/// An arrangement of values. The outputs of a program are the values in order, matrices by rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// One number.
    Number,
    /// A matrix of so many rows and columns, or a vector.
    Matrix(Size, Size),
    /// An array with one for each joint that moves.
    Each(&'static Shape),
    /// One after the other.
    Tuple(&'static [Shape]),
    /// Taylor coefficients of the positions. The program's outputs are the joint forces of one order.
    Series,
}

impl Shape {
    /// How many values there are.
    pub fn entries(&self, sizes: Sizes) -> usize {
        match self {
            Shape::Number => 1,
            Shape::Matrix(rows, columns) => rows.of(sizes) * columns.of(sizes),
            Shape::Each(one) => sizes.joints * one.entries(sizes),
            Shape::Tuple(parts) => parts.iter().map(|part| part.entries(sizes)).sum(),
            Shape::Series => sizes.joints,
        }
    }

    /// The number of base parameters with which there are so many values; 0 where it does not matter.
    pub fn parameters(&self, joints: usize, entries: usize) -> usize {
        Sizes::with_count(joints, entries, |sizes| self.entries(sizes)).parameters
    }

    /// Whether a size is the number of base parameters.
    pub fn has_parameters(&self) -> bool {
        match self {
            Shape::Number | Shape::Series => false,
            Shape::Matrix(rows, columns) => [rows, columns].contains(&&Size::Parameters),
            Shape::Each(one) => one.has_parameters(),
            Shape::Tuple(parts) => parts.iter().any(Shape::has_parameters),
        }
    }
}
