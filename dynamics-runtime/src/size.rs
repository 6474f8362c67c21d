//! How many joints an arm has: known to the compiler, or at run time alone.

use core::fmt::Debug;
use core::ops::{Add, Index, IndexMut, Mul, Neg, Sub};

use nalgebra::{Const, Dim, SMatrix, SVector};
#[cfg(feature = "std")]
use nalgebra::{DMatrix, DVector, Dyn, OMatrix};

#[cfg(feature = "std")]
use crate::table::RuntimeTable;
use crate::table::{AsArm, MOST_FOLLOWERS, Table};

mod sealed {
    pub trait Sealed {}

    impl<const N: usize> Sealed for nalgebra::Const<N> {}

    #[cfg(feature = "std")]
    impl Sealed for nalgebra::Dyn {}
}

/// A number of joints, and what belongs to the joints of an arm with so many.
///
/// `Const<N>` is a number that the compiler knows: vectors, matrices and lists are arrays, and nothing is allocated.
/// `Dyn` is a number that is known at run time alone: they are on the heap, and one compiled program serves all arms.
pub trait Size: Dim + sealed::Sealed {
    /// A number for each joint.
    type Vector: JointVector;
    /// A number for each pair of joints.
    type Matrix: JointMatrix<Vector = Self::Vector>;
    /// A column of `R` numbers for each joint.
    type Columns<const R: usize>: Clone + Debug + PartialEq + IndexMut<(usize, usize), Output = f64>;
    /// A row of `C` numbers for each joint.
    type Rows<const C: usize>: Clone + Debug + PartialEq + IndexMut<(usize, usize), Output = f64>;
    /// A list with an entry for each joint.
    type Each<X: Clone + Debug>: Clone + Debug + AsRef<[X]> + AsMut<[X]>;
    /// A list with an entry for each link: those of joints that follow others are links too.
    type Links<X: Clone + Debug>: Clone + Debug + IndexMut<usize, Output = X>;
    /// The table of such an arm.
    type Table: AsArm + Clone + Debug;

    /// Zeros.
    fn vector(self) -> Self::Vector {
        Self::Vector::from_entries(self.value(), |_| 0.0)
    }

    /// Zeros.
    fn matrix(self) -> Self::Matrix;

    /// Zeros.
    fn columns<const R: usize>(self) -> Self::Columns<R>;

    /// Zeros.
    fn rows<const C: usize>(self) -> Self::Rows<C>;

    /// An entry for each joint.
    fn each<X: Clone + Debug>(self, entry: impl FnMut(usize) -> X) -> Self::Each<X>;

    /// The same entry for each of so many links.
    fn links<X: Clone + Debug>(self, count: usize, entry: X) -> Self::Links<X>;
}

/// A number for each joint: `SVector<f64, N>` or `DVector<f64>`.
pub trait JointVector:
    Clone
    + Debug
    + PartialEq
    + IndexMut<usize, Output = f64>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<f64, Output = Self>
    + Neg<Output = Self>
{
    /// The vector with these entries.
    fn from_entries(size: usize, entry: impl FnMut(usize) -> f64) -> Self;

    /// The entries.
    fn entries(&self) -> &[f64];

    /// The entries, to be written.
    fn entries_mut(&mut self) -> &mut [f64];

    /// The largest magnitude of an entry; NaN if one is.
    fn largest(&self) -> f64;
}

/// A number for each pair of joints: `SMatrix<f64, N, N>` or `DMatrix<f64>`.
pub trait JointMatrix:
    Clone
    + Debug
    + PartialEq
    + IndexMut<(usize, usize), Output = f64>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<f64, Output = Self>
{
    /// What it is multiplied with.
    type Vector: JointVector;

    /// The product with a vector.
    fn times(&self, vector: &Self::Vector) -> Self::Vector;
}

/// [`SecondDerivatives`](crate::SecondDerivatives) of an arm of any size.
pub type SizedSecondDerivatives<D> = (
    <D as Size>::Each<<D as Size>::Matrix>,
    <D as Size>::Each<<D as Size>::Matrix>,
    <D as Size>::Each<<D as Size>::Matrix>,
    <D as Size>::Each<<D as Size>::Matrix>,
);

impl<const N: usize> Size for Const<N> {
    type Vector = SVector<f64, N>;
    type Matrix = SMatrix<f64, N, N>;
    type Columns<const R: usize> = SMatrix<f64, R, N>;
    type Rows<const C: usize> = SMatrix<f64, N, C>;
    type Each<X: Clone + Debug> = [X; N];
    type Links<X: Clone + Debug> = Inline<X, N>;
    type Table = Table<N>;

    #[inline(always)]
    fn matrix(self) -> Self::Matrix {
        SMatrix::zeros()
    }

    #[inline(always)]
    fn columns<const R: usize>(self) -> Self::Columns<R> {
        SMatrix::zeros()
    }

    #[inline(always)]
    fn rows<const C: usize>(self) -> Self::Rows<C> {
        SMatrix::zeros()
    }

    #[inline(always)]
    fn each<X: Clone + Debug>(self, entry: impl FnMut(usize) -> X) -> Self::Each<X> {
        core::array::from_fn(entry)
    }

    #[inline(always)]
    fn links<X: Clone + Debug>(self, count: usize, entry: X) -> Self::Links<X> {
        Inline {
            more: (count > N).then(|| core::array::from_fn(|_| entry.clone())),
            first: core::array::from_fn(|_| entry.clone()),
        }
    }
}

impl<const N: usize> JointVector for SVector<f64, N> {
    #[inline(always)]
    fn from_entries(_: usize, mut entry: impl FnMut(usize) -> f64) -> Self {
        SVector::from_fn(|i, _| entry(i))
    }

    #[inline(always)]
    fn entries(&self) -> &[f64] {
        self.as_slice()
    }

    #[inline(always)]
    fn entries_mut(&mut self) -> &mut [f64] {
        self.as_mut_slice()
    }

    fn largest(&self) -> f64 {
        self.amax()
    }
}

impl<const N: usize> JointMatrix for SMatrix<f64, N, N> {
    type Vector = SVector<f64, N>;

    #[inline(always)]
    fn times(&self, vector: &Self::Vector) -> Self::Vector {
        self * vector
    }
}

/// A list without an allocator, with room for `N` entries, and for those of the joints that may follow others where
/// there are any.
#[derive(Clone, Copy, Debug)]
pub struct Inline<X, const N: usize> {
    first: [X; N],
    more: Option<[X; MOST_FOLLOWERS]>,
}

impl<X, const N: usize> Index<usize> for Inline<X, N> {
    type Output = X;

    #[inline(always)]
    fn index(&self, k: usize) -> &X {
        match self.first.get(k) {
            Some(entry) => entry,
            None => &self.more.as_ref().expect("so many links")[k - N],
        }
    }
}

impl<X, const N: usize> IndexMut<usize> for Inline<X, N> {
    #[inline(always)]
    fn index_mut(&mut self, k: usize) -> &mut X {
        match self.first.get_mut(k) {
            Some(entry) => entry,
            None => &mut self.more.as_mut().expect("so many links")[k - N],
        }
    }
}

#[cfg(feature = "std")]
impl Size for Dyn {
    type Vector = DVector<f64>;
    type Matrix = DMatrix<f64>;
    type Columns<const R: usize> = OMatrix<f64, Const<R>, Dyn>;
    type Rows<const C: usize> = OMatrix<f64, Dyn, Const<C>>;
    type Each<X: Clone + Debug> = Vec<X>;
    type Links<X: Clone + Debug> = Vec<X>;
    type Table = RuntimeTable;

    fn matrix(self) -> Self::Matrix {
        DMatrix::zeros(self.0, self.0)
    }

    fn columns<const R: usize>(self) -> Self::Columns<R> {
        OMatrix::<f64, Const<R>, Dyn>::zeros(self.0)
    }

    fn rows<const C: usize>(self) -> Self::Rows<C> {
        OMatrix::<f64, Dyn, Const<C>>::zeros(self.0)
    }

    fn each<X: Clone + Debug>(self, entry: impl FnMut(usize) -> X) -> Self::Each<X> {
        (0..self.0).map(entry).collect()
    }

    fn links<X: Clone + Debug>(self, count: usize, entry: X) -> Self::Links<X> {
        vec![entry; count]
    }
}

#[cfg(feature = "std")]
impl JointVector for DVector<f64> {
    fn from_entries(size: usize, mut entry: impl FnMut(usize) -> f64) -> Self {
        DVector::from_fn(size, |i, _| entry(i))
    }

    fn entries(&self) -> &[f64] {
        self.as_slice()
    }

    fn entries_mut(&mut self) -> &mut [f64] {
        self.as_mut_slice()
    }

    fn largest(&self) -> f64 {
        self.amax()
    }
}

#[cfg(feature = "std")]
impl JointMatrix for DMatrix<f64> {
    type Vector = DVector<f64>;

    fn times(&self, vector: &Self::Vector) -> Self::Vector {
        self * vector
    }
}
