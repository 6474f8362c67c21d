//! Numbers of 31 digits as text.
//!
//! Rust prints the exact decimal value of a double on request. The digits of the two halves are added, and rounded once.

use core::fmt;

use super::DoubleDouble;

/// The digits behind the point of the smallest double, 2^-1074.
const PLACES: usize = 1074;

/// The digits that are shown, if no precision asks for others.
const DIGITS: usize = 32;

/// A number with 32 significant digits, `1.2345e-6` as `{:e}` writes doubles; a precision says how many stand behind the point.
impl fmt::Display for DoubleDouble {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.high.is_finite() || self.high == 0.0 {
            return fmt::LowerExp::fmt(&self.high, f);
        }
        let (digits, exponent) = rounded(
            sum(self.high.abs(), self.low * self.high.signum()),
            f.precision().map_or(DIGITS, |places| places + 1),
        );
        let text: String = digits
            .iter()
            .map(|digit| char::from(b'0' + digit))
            .collect();
        let (first, rest) = text.split_at(1);
        let rest = match f.precision() {
            Some(_) => rest,
            None => rest.trim_end_matches('0'),
        };
        let point = if rest.is_empty() { "" } else { "." };
        f.pad_integral(
            self.high > 0.0,
            "",
            &format!("{first}{point}{rest}e{exponent}"),
        )
    }
}

/// The decimal digits of a sum that is above zero, from the first that is none to the last place, and the exponent of the
/// first one.
fn sum(high: f64, low: f64) -> (Vec<u8>, i32) {
    let digits = |x: f64| -> Vec<u8> {
        let text = format!("{:0>1400.PLACES$}", x.abs());
        text.bytes()
            .filter(u8::is_ascii_digit)
            .map(|digit| digit - b'0')
            .collect()
    };
    let (mut total, low_digits) = (digits(high), digits(low));
    let sign = if low < 0.0 { -1 } else { 1 };
    let mut carry = 0;
    for (digit, other) in total.iter_mut().zip(low_digits).rev() {
        let here = *digit as i8 + sign * other as i8 + carry;
        carry = here.div_euclid(10);
        *digit = here.rem_euclid(10) as u8;
    }
    let first = total.iter().take_while(|digit| **digit == 0).count();
    let exponent = (total.len() - PLACES - 1) as i32 - first as i32;
    (total.split_off(first), exponent)
}

/// So many digits, the last one rounded: halves away from zero.
fn rounded((mut digits, mut exponent): (Vec<u8>, i32), count: usize) -> (Vec<u8>, i32) {
    let up = digits.get(count).is_some_and(|digit| *digit >= 5);
    digits.resize(count, 0);
    if up {
        let nines = digits.iter().rev().take_while(|digit| **digit == 9).count();
        let kept = count - nines;
        digits[kept..].fill(0);
        match kept.checked_sub(1) {
            Some(last) => digits[last] += 1,
            None => {
                digits[0] = 1;
                exponent += 1;
            }
        }
    }
    (digits, exponent)
}

#[cfg(test)]
mod tests {
    use super::DoubleDouble;

    fn quotient(a: f64, b: f64) -> DoubleDouble {
        DoubleDouble::from(a) / DoubleDouble::from(b)
    }

    #[test]
    fn all_digits_are_shown() {
        assert_eq!(
            format!("{:.29}", quotient(1.0, 3.0)),
            "3.33333333333333333333333333333e-1"
        );
        assert_eq!(
            format!("{:.29}", quotient(-2.0, 3.0)),
            "-6.66666666666666666666666666667e-1"
        );
        assert_eq!(format!("{:.0}", quotient(29.0, 3.0)), "1e1");
        assert_eq!(
            DoubleDouble::from(0.1).to_string(),
            "1.0000000000000000555111512312578e-1"
        );
        assert_eq!(DoubleDouble::from(-1e22).to_string(), "-1e22");
        assert_eq!(
            DoubleDouble::from(f64::MAX).to_string(),
            "1.797693134862315708145274237317e308"
        );
        assert_eq!(
            DoubleDouble::from(f64::from_bits(1)).to_string(),
            "4.9406564584124654417656879286822e-324"
        );
    }

    #[test]
    fn halves_of_either_sign_are_added() {
        let tiny = DoubleDouble::from(1e-20);
        let one = DoubleDouble::from(1.0);
        assert_eq!(format!("{:.21}", one + tiny), "1.000000000000000000010e0");
        assert_eq!(format!("{:.21}", one - tiny), "9.999999999999999999900e-1");
        assert_eq!(format!("{:.3}", -(one - tiny)), "-1.000e0");
    }

    #[test]
    fn numbers_that_are_none_and_widths_are_shown_as_those_of_doubles() {
        let shown = [0.0, f64::NAN, f64::INFINITY].map(|x| DoubleDouble::from(x).to_string());
        assert_eq!(shown, ["0e0", "NaN", "inf"]);
        assert_eq!(format!("{:>8}", DoubleDouble::from(2.0)), "     2e0");
    }
}
