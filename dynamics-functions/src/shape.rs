//! The arrangement of values: vectors, matrices, and arrays and tuples of them.

/// A number of rows or columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Size {
    /// One: a matrix of one column is a vector.
    One,
    /// So many of every robot.
    Fixed(usize),
    /// One for each joint that moves by itself.
    Joints,
    /// One for each degree of freedom: six of a base that moves, then the joints.
    Freedoms,
    /// One for each pair of joints, in the order (1,2), (1,3), ..., (n-1,n).
    Pairs,
    /// One for each base inertial parameter.
    Parameters,
}

/// The degrees of freedom of one robot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Freedoms {
    /// Degrees of freedom of the base: none of one that stands, six of one that moves.
    pub base: usize,
    /// Joints that move by themselves.
    pub joints: usize,
}

impl Freedoms {
    /// All of them: entries of a velocity.
    pub const fn all(self) -> usize {
        self.base + self.joints
    }

    /// Whether the base moves.
    pub const fn has_base(self) -> bool {
        self.base > 0
    }
}

/// So many joints on a base that stands.
impl From<usize> for Freedoms {
    fn from(joints: usize) -> Self {
        Freedoms { base: 0, joints }
    }
}

/// The sizes of one robot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sizes {
    /// Degrees of freedom.
    pub freedoms: Freedoms,
    /// Base inertial parameters.
    pub parameters: usize,
}

impl Sizes {
    /// The sizes with which some values are so many, where `count` gives their number; no parameters where these do not
    /// matter.
    pub(super) fn with_count(
        freedoms: Freedoms,
        values: usize,
        count: impl Fn(Sizes) -> usize,
    ) -> Self {
        let sizes = |parameters| Sizes {
            freedoms,
            parameters,
        };
        let [without, with_one] = [0, 1].map(|parameters| count(sizes(parameters)));
        let rest = values.saturating_sub(without);
        let parameters = rest.checked_div(with_one - without).unwrap_or(0);
        sizes(parameters)
    }
}

impl Size {
    /// The number.
    pub fn of(self, sizes: Sizes) -> usize {
        match self {
            Size::One => 1,
            Size::Fixed(count) => count,
            Size::Joints => sizes.freedoms.joints,
            Size::Freedoms => sizes.freedoms.all(),
            Size::Pairs => {
                let joints = sizes.freedoms.joints;
                joints * joints.saturating_sub(1) / 2
            }
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
    /// An array with so many of them.
    Each(Size, &'static Shape),
    /// One after the other, each with its name.
    Tuple(&'static [(&'static str, Shape)]),
    /// Taylor coefficients of the positions. The program's outputs are the joint forces of one order.
    Series,
}

impl Shape {
    /// How many values there are.
    pub fn entries(&self, sizes: Sizes) -> usize {
        match self {
            Shape::Number => 1,
            Shape::Matrix(rows, columns) => rows.of(sizes) * columns.of(sizes),
            Shape::Each(count, one) => count.of(sizes) * one.entries(sizes),
            Shape::Tuple(parts) => parts.iter().map(|(_, part)| part.entries(sizes)).sum(),
            Shape::Series => sizes.freedoms.joints,
        }
    }

    /// The number of base parameters with which there are so many values; 0 where it does not matter.
    pub fn parameters(&self, freedoms: impl Into<Freedoms>, entries: usize) -> usize {
        Sizes::with_count(freedoms.into(), entries, |sizes| self.entries(sizes)).parameters
    }

    /// Whether a size is the number of base parameters.
    pub fn has_parameters(&self) -> bool {
        match self {
            Shape::Number | Shape::Series => false,
            Shape::Matrix(rows, columns) => [rows, columns].contains(&&Size::Parameters),
            Shape::Each(_, one) => one.has_parameters(),
            Shape::Tuple(parts) => parts.iter().any(|(_, part)| part.has_parameters()),
        }
    }
}
