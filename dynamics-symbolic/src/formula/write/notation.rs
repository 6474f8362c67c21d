//! The parts of a formula, which each format writes in its own way.

use super::number::Written;

/// The way in which a format writes the parts of a formula: as plain text, unless it says otherwise.
pub(super) trait Notation {
    /// A letter as it stands in text, and its parts: base, dots above it, subscript.
    fn letter(&self, text: &str, _base: &str, _dots: usize, _subscript: &str) -> String {
        text.to_owned()
    }
    /// A number.
    fn number(&self, number: &Written) -> String {
        match number {
            Written::Decimal(digits, None) => digits.clone(),
            Written::Decimal(digits, Some(exponent)) => format!("{digits}e{exponent}"),
            Written::Fraction(numerator, denominator) => format!("{numerator}/{denominator}"),
        }
    }
    /// A power; the base is an atom or in parentheses.
    fn power(&self, base: &str, exponent: u32) -> String {
        format!("{base}^{exponent}")
    }
    /// Factors side by side.
    fn product(&self, factors: &[String]) -> String {
        factors.join(" ")
    }
    /// A quotient; `is_single` says whether the divisor is one factor.
    fn quotient(&self, dividend: &str, divisor: &str, is_single: bool) -> String {
        if is_single {
            format!("{dividend} / {divisor}")
        } else {
            format!("{dividend} / ({divisor})")
        }
    }
    /// Terms with their signs.
    fn sum(&self, terms: &[(bool, String)]) -> String {
        signed_sum(terms, [" + ", " - ", "-"])
    }
    /// In parentheses.
    fn parentheses(&self, inner: &str) -> String {
        format!("({inner})")
    }
    /// A function of an argument.
    fn call(&self, function: &str, argument: &str) -> String {
        format!("{function}({argument})")
    }
    /// Between the sides of an equation.
    fn equals(&self) -> &'static str {
        " = "
    }
    /// A whole formula.
    fn element(&self, inner: String) -> String {
        inner
    }
}

/// Plain text: `2 m2 l1 l2 c2 qd1 qd2`.
pub(super) struct Text;

impl Notation for Text {}

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
