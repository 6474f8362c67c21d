//! Numbers of a file that were meant as others: noise beside zero, and angles near a quarter turn.

use core::f64::consts::FRAC_PI_2;

use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::{Angle, Value};

use crate::geometry::Vector;
use crate::rounded::{NEARLY, Rounded};

/// Angles up to so much, rad, are zero, and so are parts of an axis up to so much of its largest one:
/// doubles that were computed have such noise.
const NO_ANGLE: f64 = 1e-12;

/// Lengths up to so much are zero, m: a double of one metre is as uncertain as that.
const NO_LENGTH: f64 = 1e-15;

/// Beyond so many quarter turns an angle is judged as it is written.
const MOST_QUARTERS: f64 = 4.0;

/// Which numbers are taken as others, and how many were.
#[derive(Default)]
pub(crate) struct Rounding {
    /// How near the call wants angles to be to a quarter turn that they are taken for, rad.
    within: f64,
    /// Numbers that were noise.
    noise: usize,
    /// Angles that were rounded because the call says so.
    asked: usize,
    /// Angles that are taken for a quarter turn without being asked for, and noise.
    pub(super) rounded: Rounded,
    /// How far those angles are from a quarter turn that may be meant as one.
    left: Vec<f64>,
}

impl Rounding {
    pub(crate) fn new(within: f64) -> Rounding {
        Rounding {
            within,
            ..Rounding::default()
        }
    }

    /// An angle, or the multiple of a quarter turn that it is taken for.
    pub(crate) fn angle(&mut self, angle: Rational) -> Value {
        let radians = angle.to_f64().value();
        let quarters = (radians / FRAC_PI_2).round();
        let apart = (radians - quarters * FRAC_PI_2).abs();
        let written = Value::Rational(angle);
        let is_multiple = if quarters == 0.0 {
            written.is_zero() || self.is_noise(apart, NO_ANGLE) || self.is_rounded(apart)
        } else if Angle::new(&written).rest.is_some() {
            self.is_rounded(apart)
        } else {
            self.is_turn(radians, quarters, apart)
        };
        if !is_multiple {
            return written;
        }
        let half = Rational::from_parts_signed((quarters as i64).into(), 2_u8.into());
        Value::Pi * Value::Rational(half)
    }

    /// The axis without those of its parts that are taken for zero.
    pub(crate) fn axis(&mut self, axis: Vector) -> Vector {
        let parts = axis.each_ref().map(|part| part.to_f64().value().abs());
        let largest = parts.iter().fold(0.0_f64, |a, b| a.max(*b));
        let mut index = 0;
        axis.map(|part| {
            let apart = parts[index] / largest;
            index += 1;
            let is_zero =
                !part.is_zero() && (self.is_noise(apart, NO_ANGLE) || self.is_rounded(apart));
            if is_zero { Rational::ZERO } else { part }
        })
    }

    /// A length, or zero where it is noise.
    pub(crate) fn length(&mut self, length: Rational) -> Rational {
        let is_noise = !length.is_zero() && self.is_noise(length.to_f64().value().abs(), NO_LENGTH);
        if is_noise { Rational::ZERO } else { length }
    }

    /// Whether a number is noise. As an angle, rad, or as a share of an axis, it differs from zero by its size.
    fn is_noise(&mut self, size: f64, most: f64) -> bool {
        let is_noise = size <= most;
        self.noise += usize::from(is_noise);
        if is_noise && size > self.within {
            self.rounded.add(size, size);
        }
        is_noise
    }

    /// Whether an angle that the engine takes for a quarter turn is made one here. That is told unless the call says it.
    fn is_turn(&mut self, radians: f64, quarters: f64, apart: f64) -> bool {
        let is_turn = quarters.abs() <= MOST_QUARTERS;
        if is_turn && apart > self.within {
            self.rounded.add(radians, apart);
        }
        is_turn
    }

    /// Whether the call rounds an angle that is so far from a quarter turn.
    fn is_rounded(&mut self, apart: f64) -> bool {
        let is_rounded = apart <= self.within;
        self.asked += usize::from(is_rounded);
        if !is_rounded && apart <= NEARLY {
            self.left.push(apart);
        }
        is_rounded
    }

    /// Notes for the struct's documentation: what was rounded, and what was perhaps meant as a quarter turn.
    pub(super) fn notes(&self) -> Vec<String> {
        let mut notes = Vec::new();
        if self.noise > 0 {
            let numbers = counted(
                self.noise,
                "number of the file is",
                "numbers of the file are",
            );
            notes.push(format!(
                " {numbers} noise and taken as zero: angles and parts of axes up to {NO_ANGLE:e}, lengths up to \
                 {NO_LENGTH:e} m."
            ));
        }
        if self.asked > 0 {
            let angles = counted(self.asked, "angle of the file is", "angles of the file are");
            let within = self.within;
            notes.push(format!(
                " {angles} taken as multiples of a quarter turn: `round_angles: {within:e}`."
            ));
        }
        notes.extend(self.nearly());
        notes
    }

    /// The angles that are near a quarter turn, and the tolerances that take them for it.
    fn nearly(&self) -> Option<String> {
        let all = self.left.len();
        let mut taken = 0;
        let mut tolerances = Vec::new();
        for tolerance in [
            1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, NEARLY,
        ] {
            let reached = self
                .left
                .iter()
                .filter(|apart| **apart <= tolerance)
                .count();
            if reached > taken {
                taken = reached;
                tolerances.push(format!(
                    "`round_angles: {tolerance:e}` takes {reached} of them"
                ));
            }
        }
        (all > 0).then(|| {
            format!(
                " {} within {NEARLY} rad of a multiple of a quarter turn, and taken as written: every vector that passes \
                 such an angle costs four multiplications and two additions. As multiples, {}.",
                counted(all, "angle of the file is", "angles of the file are"),
                tolerances.join(", ")
            )
        })
    }
}

fn counted(count: usize, one: &str, several: &str) -> String {
    match count {
        1 => format!("One {one}"),
        _ => format!("{count} {several}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse::number::in_file;

    fn number(text: &str) -> Rational {
        in_file(text).unwrap_or_else(|mistake| panic!("{mistake}"))
    }

    fn quarters(count: i64) -> Value {
        Value::Pi * Value::Rational(Rational::from_parts_signed(count.into(), 2_u8.into()))
    }

    #[test]
    fn noise_is_zero_and_angles_are_rounded_where_that_is_asked_for() {
        let as_written = |text: &str| Value::Rational(number(text));
        for (text, exact, rounded) in [
            ("0", quarters(0), quarters(0)),
            ("2.7629E-18", quarters(0), quarters(0)),
            ("-9e-13", quarters(0), quarters(0)),
            ("1e-9", as_written("1e-9"), quarters(0)),
            ("-1.5708", as_written("-1.5708"), quarters(-1)),
            ("3.1416", as_written("3.1416"), quarters(2)),
            ("1.571", as_written("1.571"), as_written("1.571")),
            ("0.3", as_written("0.3"), as_written("0.3")),
        ] {
            for (within, expected) in [(0.0, exact), (1e-5, rounded)] {
                assert_eq!(
                    Rounding::new(within).angle(number(text)),
                    expected,
                    "{text}"
                );
            }
        }
        let axis = |within: f64, text: [&str; 3]| Rounding::new(within).axis(text.map(number));
        let noisy = ["-6.16190875927568e-16", "9.9e-17", "1"];
        assert_eq!(axis(0.0, noisy), ["0", "0", "1"].map(number));
        let skew = ["2", "-2", "1e-12"];
        assert_eq!(axis(0.0, skew), ["2", "-2", "0"].map(number));
        let nearly = ["0.00001", "0", "-2"];
        assert_eq!(axis(0.0, nearly), nearly.map(number));
        assert_eq!(axis(1e-5, nearly), ["0", "0", "-2"].map(number));
        assert_eq!(axis(0.1, ["0", "0", "0"]), ["0", "0", "0"].map(number));
        let length = |text: &str| Rounding::new(0.1).length(number(text));
        assert_eq!(length("-8.326672684688674e-17"), Rational::ZERO);
        assert_eq!(length("2e-15"), number("2e-15"));
    }

    /// Quarter turns that lack digits are quarter turns, which is told unless it is asked for. So is noise that is large.
    #[test]
    fn digits_that_a_quarter_turn_lacks_are_told() {
        let told = |within: f64, text: &str| {
            let mut rounding = Rounding::new(within);
            let angle = rounding.angle(number(text));
            (angle, rounding.rounded.note("").is_some())
        };
        for (text, count, is_told) in [
            ("1.57079632679", 1, true),
            ("-3.14159265359", -2, true),
            ("1.570796327", 1, true),
            ("6.28318530718", 4, true),
            ("1.5707963267948966", 1, false),
            ("3.14159265358979", 2, false),
            ("4e-13", 0, true),
            ("4e-16", 0, false),
        ] {
            assert_eq!(told(0.0, text), (quarters(count), is_told), "{text}");
            assert_eq!(told(1e-9, text), (quarters(count), false), "{text}");
        }
        assert_eq!(told(0.0, "1.57"), (Value::Rational(number("1.57")), false));
        let five = "7.85398163397";
        assert_eq!(told(0.0, five), (Value::Rational(number(five)), false));
    }

    #[test]
    fn notes_count_and_name_the_tolerance_that_takes_what_is_left() {
        let notes = |within: f64| {
            let mut rounding = Rounding::new(within);
            for text in [
                "1.5707963267948966",
                "2.7e-18",
                "3.1416",
                "1.571",
                "3.14",
                "0.004",
                "0.7",
            ] {
                rounding.angle(number(text));
            }
            rounding.axis(["-6e-16", "0", "1"].map(number));
            rounding.axis(["0", "2e-5", "1"].map(number));
            rounding.length(number("0.1"));
            rounding.length(number("1e-17"));
            rounding.notes()
        };
        let noise = " 3 numbers of the file are noise and taken as zero: angles and parts of axes up to 1e-12, lengths up to \
                     1e-15 m.";
        let left = |count: &str, tolerances: &str| {
            format!(
                " {count} within 0.01 rad of a multiple of a quarter turn, and taken as written: every vector that passes \
                 such an angle costs four multiplications and two additions. As multiples, {tolerances}."
            )
        };
        let of_all = "`round_angles: 1e-5` takes 1 of them, `round_angles: 1e-4` takes 2 of them, \
                      `round_angles: 1e-3` takes 3 of them, `round_angles: 1e-2` takes 5 of them";
        assert_eq!(
            notes(0.0),
            [noise.to_owned(), left("5 angles of the file are", of_all)]
        );
        let of_two = "`round_angles: 1e-2` takes 2 of them";
        let taken =
            " 3 angles of the file are taken as multiples of a quarter turn: `round_angles: 1e-3`.";
        assert_eq!(
            notes(1e-3),
            [
                noise.to_owned(),
                taken.to_owned(),
                left("2 angles of the file are", of_two)
            ]
        );
        assert_eq!(notes(1e-2).len(), 2);
        assert!(Rounding::new(1e-2).notes().is_empty());
    }
}
