//! Formulas of generated functions.

use core::fmt;

/// A value of a generated function and its formula, as an equation. `formulas()` of a generated struct
/// returns those that are short enough to read.
///
/// c12 is cos(q1 + q2), s12 its sine; q, qd, qdd and tau are counted from 1. Numbers are exact, unless
/// they have more than 17 digits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Formula {
    /// The name of the method.
    pub function: &'static str,
    /// The name of the value: a letter and its row and column, such as `M12`.
    pub value: &'static str,
    /// As text: `M12 = m2 l2^2 + m2 l1 l2 c2`.
    pub text: &'static str,
    /// As LaTeX for math mode, with the commands of amsmath.
    pub latex: &'static str,
    /// As a `math` element of MathML, which browsers show as it is.
    pub mathml: &'static str,
}

/// The text.
impl fmt::Display for Formula {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.text)
    }
}
