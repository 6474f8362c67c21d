//! Vectors and matrices of dimension three over any commutative ring, and elimination: the same
//! formulas serve expressions on the graph and numbers of a prime field.

mod elimination;
mod matrix;
mod vector;

pub use elimination::eliminate;
pub use matrix::{Matrix3, Symmetric3};
pub use vector::Vector3;

use core::ops::{Add, Mul, Neg, Sub};

/// Numbers, or expressions, that can be added, subtracted and multiplied.
pub trait Ring:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
}

impl<R> Ring for R where
    R: Copy + Add<Output = R> + Sub<Output = R> + Mul<Output = R> + Neg<Output = R>
{
}
