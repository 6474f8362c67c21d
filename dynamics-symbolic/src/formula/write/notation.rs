//! What formats have in common.

use super::number::Written;

/// What a format does with the parts of a formula.
pub(super) trait Notation {
    /// A letter as it stands in text, and its parts: base, dots above it, subscript.
    fn letter(&self, text: &str, base: &str, dots: usize, subscript: &str) -> String;
    /// A number.
    fn number(&self, number: &Written) -> String;
    /// A power; the base is an atom or in parentheses.
    fn power(&self, base: &str, exponent: u32) -> String;
    /// Factors side by side.
    fn product(&self, factors: &[String]) -> String;
    /// A quotient; `is_single` says whether the divisor is one factor.
    fn quotient(&self, dividend: &str, divisor: &str, is_single: bool) -> String;
    /// Terms with their signs.
    fn sum(&self, terms: &[(bool, String)]) -> String;
    /// In parentheses.
    fn parentheses(&self, inner: &str) -> String;
    /// A function of an argument.
    fn call(&self, function: &str, argument: &str) -> String;
}

/// Letters with a name in Greek, as LaTeX has them.
pub(super) const GREEK: [(&str, &str); 24] = [
    ("alpha", "α"),
    ("beta", "β"),
    ("gamma", "γ"),
    ("delta", "δ"),
    ("epsilon", "ϵ"),
    ("zeta", "ζ"),
    ("eta", "η"),
    ("theta", "θ"),
    ("iota", "ι"),
    ("kappa", "κ"),
    ("lambda", "λ"),
    ("mu", "μ"),
    ("nu", "ν"),
    ("xi", "ξ"),
    ("pi", "π"),
    ("rho", "ρ"),
    ("sigma", "σ"),
    ("tau", "τ"),
    ("upsilon", "υ"),
    ("phi", "ϕ"),
    ("chi", "χ"),
    ("psi", "ψ"),
    ("omega", "ω"),
    ("Omega", "Ω"),
];
