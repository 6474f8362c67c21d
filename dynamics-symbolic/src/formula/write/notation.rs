//! The parts of a formula, which each format writes in its own way.

use super::number::Written;

/// The way in which a format writes the parts of a formula.
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
    /// Between the sides of an equation.
    fn equals(&self) -> &'static str {
        " = "
    }
    /// A whole formula.
    fn element(&self, inner: String) -> String {
        inner
    }
}

/// Terms with their signs: that between two terms, and minus in front of the first.
pub(crate) fn signed_sum(
    terms: &[(bool, String)],
    [plus, minus, first_minus]: [&str; 3],
) -> String {
    let mut sum = String::new();
    for (is_negative, term) in terms {
        sum += match (sum.is_empty(), is_negative) {
            (true, false) => "",
            (true, true) => first_minus,
            (false, false) => plus,
            (false, true) => minus,
        };
        sum += term;
    }
    sum
}

/// Letters with a name in Greek, as LaTeX has them.
const GREEK: &str = "
alpha=α beta=β gamma=γ delta=δ epsilon=ϵ zeta=ζ eta=η theta=θ iota=ι kappa=κ lambda=λ mu=μ nu=ν xi=ξ
pi=π rho=ρ sigma=σ tau=τ upsilon=υ phi=ϕ chi=χ psi=ψ omega=ω Omega=Ω
";

/// The Greek letter of a name.
pub(super) fn greek(name: &str) -> Option<&'static str> {
    let mut letters = GREEK
        .split_whitespace()
        .filter_map(|pair| pair.split_once('='));
    letters.find_map(|(own, letter)| (own == name).then_some(letter))
}
