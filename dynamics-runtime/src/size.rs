//! How many joints an arm has: known to the compiler, or at run time alone.

use core::fmt::Debug;
use core::ops::{Add, Index, IndexMut, Mul, Neg, Range, Sub};

use nalgebra::allocator::Allocator;
use nalgebra::{Const, DefaultAllocator, Dim, OMatrix, OVector, SMatrix, SVector};
#[cfg(feature = "std")]
use nalgebra::{DMatrix, DVector, Dyn};

use crate::Scalar;
#[cfg(feature = "std")]
use crate::table::RuntimeTable;
use crate::table::{AsArm, List, Table};

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
    type Each<X: Clone + Debug>: Clone
        + Debug
        + AsRef<[X]>
        + AsMut<[X]>
        + IndexMut<usize, Output = X>;
    /// A list with an entry for each link: those of joints that follow others are links too.
    type Links<X: Copy + Debug>: Clone + Debug + IndexMut<usize, Output = X>;
    /// The table of such an arm.
    type Table: AsArm + Clone + Debug;

    /// The number of joints of a vector.
    #[inline(always)]
    fn of(vector: &Self::Vector) -> Self {
        Self::from_usize(vector.entries().len())
    }

    /// The joints, counted from 0.
    #[inline(always)]
    fn joints(self) -> Range<usize> {
        0..self.value()
    }

    /// The vector with these entries.
    #[inline(always)]
    fn vector_of(self, entry: impl FnMut(usize) -> f64) -> Self::Vector {
        Self::Vector::from_entries(self.value(), entry)
    }

    /// Zeros.
    #[inline(always)]
    fn vector(self) -> Self::Vector {
        self.vector_of(|_| 0.0)
    }

    /// Zeros.
    fn matrix(self) -> Self::Matrix;

    /// Zeros.
    fn columns<const R: usize>(self) -> Self::Columns<R>;

    /// Zeros.
    fn rows<const C: usize>(self) -> Self::Rows<C>;

    /// An entry for each joint.
    fn each<X: Clone + Debug>(self, entry: impl FnMut(usize) -> X) -> Self::Each<X>;

    /// Sines and cosines of angles.
    fn sin_cos(angles: &Self::Vector) -> Self::Each<(f64, f64)>;

    /// The same entry for each of so many links.
    fn links<X: Copy + Debug>(self, count: usize, entry: X) -> Self::Links<X>;
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
    /// The number of entries, where the compiler knows it.
    fn size() -> Option<usize>;

    /// The vector with these entries.
    fn from_entries(size: usize, entry: impl FnMut(usize) -> f64) -> Self;

    /// The entries.
    fn entries(&self) -> &[f64];

    /// The largest magnitude of an entry; NaN if one is.
    fn largest(&self) -> f64;

    /// `self + factor * other`.
    #[inline(always)]
    fn plus(&self, factor: f64, other: &Self) -> Self {
        Self::from_entries(self.entries().len(), |i| self[i] + other[i] * factor)
    }
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
    /// The vectors that it is multiplied with.
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
    type Links<X: Copy + Debug> = Inline<X, N>;
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
    fn sin_cos(angles: &Self::Vector) -> Self::Each<(f64, f64)> {
        let [angles] = angles.data.0;
        f64::sin_cos_array(angles)
    }

    #[inline(always)]
    fn links<X: Copy + Debug>(self, count: usize, entry: X) -> Self::Links<X> {
        Inline {
            first: [entry; N],
            more: List::filled(count.saturating_sub(N), entry),
        }
    }
}

impl<D: Dim> JointVector for OVector<f64, D>
where
    DefaultAllocator: Allocator<D>,
{
    fn size() -> Option<usize> {
        D::try_to_usize()
    }

    #[inline(always)]
    fn from_entries(size: usize, mut entry: impl FnMut(usize) -> f64) -> Self {
        OVector::from_fn_generic(D::from_usize(size), Const::<1>, |i, _| entry(i))
    }

    #[inline(always)]
    fn entries(&self) -> &[f64] {
        self.as_slice()
    }

    fn largest(&self) -> f64 {
        self.amax()
    }
}

impl<D: Dim> JointMatrix for OMatrix<f64, D, D>
where
    DefaultAllocator: Allocator<D> + Allocator<D, D>,
{
    type Vector = OVector<f64, D>;

    #[inline(always)]
    fn times(&self, vector: &Self::Vector) -> Self::Vector {
        self * vector
    }
}

/// A list with room for `N` entries, and for those of the joints that follow others where there are any: an allocator is
/// needed where these are more than 8.
#[derive(Clone, Debug)]
pub struct Inline<X, const N: usize> {
    first: [X; N],
    more: List<X, 8>,
}

impl<X, const N: usize> Index<usize> for Inline<X, N> {
    type Output = X;

    #[inline(always)]
    fn index(&self, k: usize) -> &X {
        match self.first.get(k) {
            Some(entry) => entry,
            None => &self.more[k - N],
        }
    }
}

impl<X, const N: usize> IndexMut<usize> for Inline<X, N> {
    #[inline(always)]
    fn index_mut(&mut self, k: usize) -> &mut X {
        match self.first.get_mut(k) {
            Some(entry) => entry,
            None => &mut self.more[k - N],
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
    type Links<X: Copy + Debug> = Vec<X>;
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

    fn sin_cos(angles: &Self::Vector) -> Self::Each<(f64, f64)> {
        let four = |angles: &[f64]| {
            let angles = core::array::from_fn(|i| angles.get(i).copied().unwrap_or(0.0));
            <f64 as Scalar>::sin_cos_array::<4>(angles)
        };
        let pairs = angles.as_slice().chunks(4).flat_map(four);
        pairs.take(angles.len()).collect()
    }

    fn links<X: Copy + Debug>(self, count: usize, entry: X) -> Self::Links<X> {
        vec![entry; count]
    }
}
