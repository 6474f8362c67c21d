//! The difference between a generated and a numeric value, relative to its natural magnitude.

use nalgebra::SMatrix;

/// The largest relative error of one function at one state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Deviation {
    pub(super) function: &'static str,
    /// Infinite where a value is not a number; `None` where there was nothing to compare.
    pub(super) error: Option<f64>,
    /// The joint of the worst entry, where entries belong to joints.
    pub(super) joint: Option<usize>,
}

/// Entries of a matrix whose row i belongs to joint i.
pub(super) fn entries<const R: usize, const C: usize>(
    difference: SMatrix<f64, R, C>,
    scale: f64,
) -> impl Iterator<Item = Entry> {
    (0..R).flat_map(move |row| {
        (0..C).map(move |column| Entry {
            joint: Some(row),
            difference: difference[(row, column)],
            scale,
        })
    })
}

/// One entry of a difference, and the magnitude that the entry could have.
pub(super) struct Entry {
    pub(super) joint: Option<usize>,
    pub(super) difference: f64,
    pub(super) scale: f64,
}

impl Entry {
    /// Where the scale is zero nothing but an exact agreement will do.
    fn relative(&self) -> f64 {
        if self.difference == 0.0 {
            return 0.0;
        }
        let relative = self.difference.abs() / self.scale;
        if relative.is_nan() {
            f64::INFINITY
        } else {
            relative
        }
    }
}

impl Deviation {
    pub(super) fn worst(function: &'static str, entries: impl Iterator<Item = Entry>) -> Self {
        let mut worst = (0.0, None);
        for entry in entries {
            let error = entry.relative();
            if error > worst.0 {
                worst = (error, entry.joint);
            }
        }
        Deviation {
            function,
            error: Some(worst.0),
            joint: worst.1,
        }
    }

    /// Row i belongs to joint i.
    pub(super) fn of_matrix<const R: usize, const C: usize>(
        function: &'static str,
        difference: &SMatrix<f64, R, C>,
        scale: f64,
    ) -> Self {
        Deviation::worst(function, entries(*difference, scale))
    }

    pub(super) fn of_number(function: &'static str, difference: f64, scale: f64) -> Self {
        let entry = Entry {
            joint: None,
            difference,
            scale,
        };
        Deviation::worst(function, core::iter::once(entry))
    }
}
