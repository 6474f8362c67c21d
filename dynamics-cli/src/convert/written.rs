//! Values as they were written: exact decimals, and expressions where they are none.

use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::Value;

use super::number::scaled;
use super::string::quoted;

/// How tightly an operation binds.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
pub(super) enum Binding {
    Sum,
    Product,
    Factor,
}

/// The text of a value without fields, from which the same value is read: a decimal, or between quotes an expression in
/// the macro's words, such as `PI / 3` and `1 / 3`.
pub(super) fn written(value: &Value) -> String {
    match value.as_rational().and_then(exact) {
        Some(number) => number,
        None => quoted(&expression(value, Binding::Sum)),
    }
}

/// A number as a decimal, with all of its digits; none where it has no end.
fn exact(x: &Rational) -> Option<String> {
    /// The smallest double has as many places behind the point.
    const PLACES: isize = 1074;
    let mut rest = x.denominator().clone();
    let mut places = 0;
    for prime in [2_u8, 5] {
        let mut count = 0;
        while (&rest % prime) == 0 {
            rest /= prime;
            count += 1;
        }
        places = count.max(places);
    }
    if !rest.is_one() || places > PLACES {
        return None;
    }
    let text = (x * Rational::from(10).pow(places)).numerator().to_string();
    Some(scaled(&text, -places, usize::MAX))
}

/// A value in the macro's words, between parentheses where what is around it binds tighter.
pub(super) fn expression(value: &Value, around: Binding) -> String {
    let (binding, text) = match value {
        Value::Rational(x) => match exact(x) {
            Some(text) if text.starts_with('-') => (Binding::Product, text),
            Some(text) => (Binding::Factor, text),
            None => {
                let fraction = format!("{} / {}", x.numerator(), x.denominator());
                (Binding::Product, fraction)
            }
        },
        Value::Pi => (Binding::Factor, "PI".to_owned()),
        // Arms with fields are not converted.
        Value::Field(index) => (Binding::Factor, format!("field_{index}")),
        Value::Neg(a) => {
            let a = expression(a, Binding::Factor);
            (Binding::Product, format!("-{a}"))
        }
        Value::Add(a, b) => (Binding::Sum, sum(expression(a, Binding::Sum), b)),
        Value::Mul(a, b) => (Binding::Product, product(a, '*', b)),
        Value::Div(a, b) => (Binding::Product, product(a, '/', b)),
    };
    if binding < around {
        format!("({text})")
    } else {
        text
    }
}

/// A sum of a text and a value.
pub(super) fn sum(a: String, b: &Value) -> String {
    let b = expression(b, Binding::Product);
    match b.strip_prefix('-') {
        Some(opposite) => format!("{a} - {opposite}"),
        None => format!("{a} + {b}"),
    }
}

fn product(a: &Value, operator: char, b: &Value) -> String {
    let a = expression(a, Binding::Product);
    format!("{a} {operator} {}", expression(b, Binding::Factor))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_have_all_of_their_digits() {
        let ratio = |n: i64, d: i64| Value::Rational(Rational::from(n) / Rational::from(d));
        let tiny = Value::Rational(Rational::ONE / Rational::from(10).pow(40));
        let third_of_a_turn = Value::Pi * ratio(2, 3);
        let turned = Value::Pi.checked_div(Value::integer(2)).expect("two");
        for (value, expected) in [
            (ratio(0, 1), "0"),
            (ratio(-5, 4), "-1.25"),
            (ratio(1_200, 1), "1200"),
            (ratio(1, 1 << 40), "9.094947017729282379150390625e-13"),
            (tiny, "1e-40"),
            (ratio(-1, 3), "-1 / 3"),
            (third_of_a_turn, "PI * (2 / 3)"),
            (-turned.clone(), "-(PI / 2)"),
            (ratio(1, 2) + turned.clone(), "0.5 + PI / 2"),
            (
                (ratio(1, 2) + Value::Pi) * ratio(-2, 1),
                "(0.5 + PI) * (-2)",
            ),
            (ratio(1, 7) + -Value::Pi, "1 / 7 - PI"),
        ] {
            assert_eq!(written(&value).trim_matches('"'), expected);
        }
    }
}
