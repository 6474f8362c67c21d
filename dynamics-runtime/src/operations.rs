//! The cost of a generated function.

use core::fmt;

/// The operations of one generated function, as they stand in its straight-line program.
///
/// Sines and cosines are counted apart from the arithmetic: a pair of them costs as much as many
/// products. Subtractions count as additions, changes of sign as nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Operations {
    /// Products of two numbers.
    pub multiplications: u32,
    /// Sums and differences.
    pub additions: u32,
    /// Quotients.
    pub divisions: u32,
    /// Pairs of a sine and a cosine of one angle.
    pub sin_cos: u32,
}

impl Operations {
    /// Multiplications, additions and divisions together.
    pub const fn total(&self) -> u32 {
        self.multiplications + self.additions + self.divisions
    }
}

impl fmt::Display for Operations {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&format!(
            "{} mul, {} add, {} div, {} sin_cos",
            self.multiplications, self.additions, self.divisions, self.sin_cos
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::Operations;

    const COUNTED: Operations = Operations {
        multiplications: 183,
        additions: 145,
        divisions: 2,
        sin_cos: 6,
    };

    #[test]
    fn total_leaves_sines_apart() {
        assert_eq!(COUNTED.total(), 330);
    }

    #[test]
    fn display_honours_a_width() {
        assert_eq!(COUNTED.to_string(), "183 mul, 145 add, 2 div, 6 sin_cos");
        assert_eq!(format!("{COUNTED:>40}").len(), 40);
    }
}
