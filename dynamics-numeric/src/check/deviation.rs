//! The difference between a generated and a numeric value, relative to its natural magnitude.

use dynamics_runtime::{Certified, Scalar};
use nalgebra::{ClosedAddAssign, ClosedMulAssign, ClosedSubAssign, DMatrix, DVector};
use num_traits::{One, Zero};

/// The numbers of a comparison: doubles, or doubles with a bound of their rounding.
pub(super) trait Measured:
    Scalar + ClosedAddAssign + ClosedSubAssign + ClosedMulAssign + Zero + One
{
    /// A number that is compared with.
    fn of(x: f64) -> Self;

    /// The number.
    fn double(self) -> f64;

    /// The bound of its rounding errors; 0 if they were not counted.
    fn rounding(self) -> f64;
}

impl Measured for f64 {
    fn of(x: f64) -> Self {
        x
    }

    fn double(self) -> f64 {
        self
    }

    fn rounding(self) -> f64 {
        0.0
    }
}

impl Measured for Certified {
    fn of(x: f64) -> Self {
        Certified::exact(x)
    }

    fn double(self) -> f64 {
        self.value()
    }

    fn rounding(self) -> f64 {
        self.bound()
    }
}

/// Numbers that are compared with.
pub(super) fn of<T: Measured>(matrix: &DMatrix<f64>) -> DMatrix<T> {
    matrix.map(T::of)
}

/// The same of a vector.
pub(super) fn of_vector<T: Measured>(vector: &DVector<f64>) -> DMatrix<T> {
    DMatrix::from_iterator(vector.len(), 1, vector.iter().map(|x| T::of(*x)))
}

/// The largest magnitude.
pub(super) fn amax<T: Measured>(matrix: &DMatrix<T>) -> f64 {
    matrix.map(T::double).amax()
}

/// The largest relative error of one function at one state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Deviation {
    pub(super) function: &'static str,
    /// Infinite where a value is not a number; `None` where there was nothing to compare.
    pub(super) error: Option<f64>,
    /// The largest that rounding adds, relative to the same magnitudes.
    pub(super) rounding: f64,
    /// The joint of the worst entry, where entries belong to joints.
    pub(super) joint: Option<usize>,
    /// Whether the magnitude of the worst entry is not finite: the numbers compared with overflow.
    pub(super) overflows: bool,
}

/// Entries of a matrix whose row i belongs to joint i.
pub(super) fn entries<T: Measured>(
    difference: DMatrix<T>,
    scale: f64,
) -> impl Iterator<Item = Entry> {
    let rows = 0..difference.nrows();
    rows.flat_map(move |row| {
        let entries: Vec<T> = difference.row(row).iter().copied().collect();
        entries
            .into_iter()
            .map(move |entry| Entry::new(Some(row), entry, scale))
    })
}

/// One entry of a difference, and the magnitude that the entry could have.
pub(super) struct Entry {
    joint: Option<usize>,
    difference: f64,
    rounding: f64,
    scale: f64,
}

impl Entry {
    pub(super) fn new<T: Measured>(joint: Option<usize>, difference: T, scale: f64) -> Self {
        Entry {
            joint,
            difference: difference.double(),
            rounding: difference.rounding(),
            scale,
        }
    }

    /// Where the scale is zero nothing but an exact agreement will do.
    fn relative(&self, size: f64) -> f64 {
        if size == 0.0 {
            return 0.0;
        }
        let relative = size.abs() / self.scale;
        if relative.is_nan() {
            f64::INFINITY
        } else {
            relative
        }
    }
}

impl Deviation {
    pub(super) fn worst(function: &'static str, entries: impl Iterator<Item = Entry>) -> Self {
        let (mut worst, mut rounding) = ((0.0, None, false), 0.0_f64);
        for entry in entries {
            rounding = rounding.max(entry.relative(entry.rounding));
            let error = entry.relative(entry.difference);
            if error > worst.0 {
                worst = (error, entry.joint, !entry.scale.is_finite());
            }
        }
        Deviation {
            function,
            error: Some(worst.0),
            rounding,
            joint: worst.1,
            overflows: worst.2,
        }
    }

    /// The deviation of a value that there is nothing to compare with.
    pub(super) fn not_compared(function: &'static str) -> Self {
        Deviation {
            function,
            error: None,
            rounding: 0.0,
            joint: None,
            overflows: false,
        }
    }
}
