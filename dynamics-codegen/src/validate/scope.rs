//! The names that a value may use, and what a value comes to.

use std::collections::BTreeMap;

use dynamics_symbolic::exact::{Residue, SplitMix64, bit_length};
use dynamics_symbolic::robot::Value;

use super::measured::Measured;
use super::{angle, elementary};
use crate::audience::AT_THE_END;
use crate::description::{
    Allow, Elementary, Entry, Expr, ExprKind, Given, Name, Operator, Table, Vector,
};
use crate::diagnose::Diagnostics;
use crate::limits::{MOST_BITS, MOST_BITS_IN_ALL, MOST_TERMS, MOST_TERMS_IN_ALL};
use crate::mistake::{Mistake, joint, size, value as mistake};
use crate::place::Place;
use crate::words;

/// The names that a value may use.
pub(super) struct Scope<'d> {
    diagnostics: &'d Diagnostics,
    names: BTreeMap<String, Binding>,
    /// Every name that the call binds by `let`, wherever.
    lets: Vec<String>,
    /// Whether each of the fields was used.
    used: Vec<bool>,
    /// Whether all fields are known; if not, any name may be one.
    complete: bool,
    /// What the values so far are in all.
    total: Total,
    /// What is allowed everywhere in the table.
    everywhere: Allow,
    /// What is allowed besides in what is read, and what messages call that.
    body: Option<(Allow, &'static str)>,
}

/// The size of values.
#[derive(Default)]
struct Total {
    terms: usize,
    bits: usize,
}

enum Binding {
    Field(usize),
    /// `None`: the value is in error.
    Let(Option<Measured>),
}

impl<'d> Scope<'d> {
    /// The fields alone.
    pub(super) fn new(table: &Table, diagnostics: &'d Diagnostics) -> Scope<'d> {
        let mut scope = Scope {
            diagnostics,
            names: BTreeMap::new(),
            lets: Vec::new(),
            used: Vec::new(),
            complete: table.has_all_fields,
            total: Total::default(),
            everywhere: table.allow(),
            body: None,
        };
        for name in &table.fields {
            let index = scope.used.len();
            // One that cannot be bound can be used by no value.
            let bound = scope.insert(name, "field", Binding::Field(index));
            scope.used.push(!bound);
        }
        for entry in &table.entries {
            if let Entry::Let(name, _) = entry {
                scope.lets.push(name.plain().to_owned());
            }
        }
        scope
    }

    /// Reports an error.
    pub(super) fn error(&self, at: impl Into<Place>, mistake: Mistake) {
        self.diagnostics.error(at, mistake);
    }

    /// Reads a row or the tool, which `place` says, with what is allowed there.
    pub(super) fn within<T>(
        &mut self,
        allow: &Given<Allow>,
        place: &'static str,
        read: impl FnOnce(&mut Self) -> T,
    ) -> T {
        self.body = Some((self.with(allow), place));
        let value = read(self);
        self.body = None;
        value
    }

    /// What is allowed where that is allowed besides.
    pub(super) fn with(&self, allow: &Given<Allow>) -> Allow {
        self.everywhere.or(match allow {
            Given::Absent => Allow::default(),
            Given::Unreadable => Allow::EVERYTHING,
            Given::As(allow) => *allow,
        })
    }

    /// What is allowed in what is read.
    pub(super) fn allowed(&self) -> Allow {
        self.body.map_or(self.everywhere, |(allow, _)| allow)
    }

    /// Where it is allowed, as a message says it.
    pub(super) fn place_of_allow(&self) -> &'static str {
        match self.body {
            Some((_, "tool")) => "on the tool",
            Some(_) => "on the row",
            None => AT_THE_END,
        }
    }

    /// Binds the name to the value.
    pub(super) fn bind(&mut self, name: &Name, value: Option<&Expr>) {
        let value = value.and_then(|value| self.counted(value, None));
        self.insert(name, "`let`", Binding::Let(value));
    }

    /// Returns whether the name was free.
    fn insert(&mut self, name: &Name, what: &str, binding: Binding) -> bool {
        let word = name.plain().to_owned();
        if word == "PI" || word == "deg" {
            self.error(name, mistake::reserved(what, &word));
            return false;
        }
        let mistake = match self.names.get(&word) {
            None => {
                self.names.insert(word, binding);
                return true;
            }
            Some(Binding::Field(_)) => mistake::field_twice(&word),
            Some(Binding::Let(_)) => mistake::let_twice(&word),
        };
        self.error(name, mistake);
        false
    }

    /// Whether the name is that of a value, or may be.
    pub(super) fn has(&self, name: &str) -> bool {
        let is_bound = self.lets.iter().any(|bound| bound == name);
        name == "PI" || is_bound || self.names.contains_key(name) || !self.complete
    }

    /// Whether no error was reported.
    pub(super) fn is_good(&self) -> bool {
        self.diagnostics.is_empty()
    }

    /// The names of fields and values that are bound.
    pub(super) fn names(&self) -> impl Iterator<Item = &str> {
        self.names.keys().map(String::as_str)
    }

    /// Whether the field of that index was used in a value.
    pub(super) fn is_used(&self, field: usize) -> bool {
        self.used.get(field).copied().unwrap_or(true)
    }

    /// The value of an expression, or `None` where it is in error.
    pub(super) fn value(&mut self, expr: &Expr) -> Option<Value> {
        self.cell(expr, None)
    }

    /// The value of an angle and what is odd about it, of which nothing is said.
    pub(super) fn unjudged_angle(&mut self, expr: &Expr) -> Option<(Value, Option<angle::Odd>)> {
        let angle = self.measured_cell(expr, None)?;
        let odd = angle::odd(&angle);
        Some((angle.value, odd))
    }

    /// The value of an angle; left out, it is zero. One that was hardly meant is reported. `variable` is
    /// the cell's name where the joint's variable is added to it.
    pub(super) fn angle(
        &mut self,
        cell: &Given<Expr>,
        variable: Option<&'static str>,
    ) -> Option<Value> {
        match cell {
            Given::As(expr) => self.written_angle(expr, variable),
            other => self.given(other),
        }
    }

    /// Reports what is odd about the angle, where that is not allowed.
    fn report_odd(&self, expr: &Expr, angle: &Measured) {
        if let Some(odd) = angle::odd(angle)
            && !self.allowed().odd_angle
        {
            self.error(expr.place, odd.mistake(self.place_of_allow()));
        }
    }

    /// Reports `deg(angle)` of what was in radians already; returns whether it was.
    fn report_radians(&self, expr: &Expr, angle: &Measured) -> bool {
        let is_judged = !self.allowed().odd_angle;
        let mistake = angle::degrees_of_radians(angle, self.place_of_allow());
        let mistake = mistake.filter(|_| is_judged);
        let is_wrong = mistake.is_some();
        if let Some(mistake) = mistake {
            self.error(expr.place, mistake);
        }
        is_wrong
    }

    fn written_angle(&mut self, expr: &Expr, variable: Option<&'static str>) -> Option<Value> {
        let angle = self.measured_cell(expr, variable)?;
        self.report_odd(expr, &angle);
        Some(angle.value)
    }

    /// Three angles; left out, they are zero.
    pub(super) fn angles(&mut self, angles: &Given<Vector>) -> [Option<Value>; 3] {
        match angles {
            Given::As(angles) => angles
                .each_ref()
                .map(|expr| self.written_angle(expr.as_ref()?, None)),
            other => self.given_vector(other),
        }
    }

    /// The value of a cell; left out, it is zero.
    pub(super) fn given(&mut self, cell: &Given<Expr>) -> Option<Value> {
        match cell {
            Given::Absent => Some(Value::zero()),
            Given::Unreadable => None,
            Given::As(expr) => self.value(expr),
        }
    }

    /// The value of the cell to which the joint's variable is added.
    pub(super) fn given_beside_variable(
        &mut self,
        cell: &Given<Expr>,
        name: &'static str,
    ) -> Option<Value> {
        match cell {
            Given::As(expr) => self.cell(expr, Some(name)),
            other => self.given(other),
        }
    }

    /// A cell that is refused where it is known to be negative.
    pub(super) fn not_negative(&mut self, cell: &Given<Expr>, what: &str) -> Option<Value> {
        let value = self.given(cell)?;
        match cell.value() {
            Some(expr) if value.is_negative() => {
                self.error(expr.place, joint::negative(what));
                None
            }
            _ => Some(value),
        }
    }

    /// Three values; left out, they are zero.
    pub(super) fn given_vector(&mut self, vector: &Given<Vector>) -> [Option<Value>; 3] {
        match vector {
            Given::Absent => std::array::from_fn(|_| Some(Value::zero())),
            vector => self.vector(vector.value()),
        }
    }

    /// The values of three expressions.
    pub(super) fn vector(&mut self, vector: Option<&Vector>) -> [Option<Value>; 3] {
        match vector {
            Some(vector) => vector.each_ref().map(|expr| self.value(expr.as_ref()?)),
            None => [None, None, None],
        }
    }

    fn cell(&mut self, expr: &Expr, variable: Option<&'static str>) -> Option<Value> {
        Some(self.measured_cell(expr, variable)?.value)
    }

    fn measured_cell(&mut self, expr: &Expr, variable: Option<&'static str>) -> Option<Measured> {
        let measured = self.counted(expr, variable)?;
        let value = &measured.value;
        self.total.bits += bits(value);
        if self.total.bits > MOST_BITS_IN_ALL {
            // Said once: the table would have to be as long again.
            self.total.bits = 0;
            self.error(expr.place, size::digits_in_all());
            return None;
        }
        if value.is_number() && !value.to_f64(&[]).is_finite() {
            self.error(expr.place, mistake::too_large());
            return None;
        }
        Some(measured)
    }

    /// The value, added to what there is in all.
    fn counted(&mut self, expr: &Expr, variable: Option<&'static str>) -> Option<Measured> {
        if self.total.terms > MOST_TERMS_IN_ALL || self.diagnostics.is_full() {
            return None;
        }
        let measured = self.measured(expr, variable)?;
        self.total.terms += measured.terms;
        if self.total.terms > MOST_TERMS_IN_ALL {
            self.error(expr.place, size::terms_in_all());
            return None;
        }
        Some(measured)
    }

    fn measured(&mut self, expr: &Expr, variable: Option<&'static str>) -> Option<Measured> {
        let measured = match &expr.kind {
            ExprKind::Number(number) => Measured::of(Value::Rational(number.clone())),
            ExprKind::Name(name) => return self.lookup(name, expr.place, variable),
            ExprKind::Degrees(angle) => {
                let angle = self.measured(angle, variable)?;
                if self.report_radians(expr, &angle) {
                    return None;
                }
                // The quotient first: deg(90) is PI/2, with no rounding of 90 PI.
                let turns = angle.value.checked_div(Value::integer(180))?;
                Measured {
                    value: turns * Value::Pi,
                    terms: angle.terms + 2,
                    is_computed: angle.is_computed,
                }
            }
            ExprKind::Function(function, argument) => {
                self.function(*function, argument, expr.place, variable)?
            }
            ExprKind::Minus(value) => {
                let value = self.measured(value, variable)?;
                Measured {
                    value: -value.value,
                    ..value
                }
            }
            ExprKind::Binary(operator, left, right) => {
                // Both sides before either `?`: there may be errors in both.
                let a = self.measured(left, variable);
                let b = self.measured(right, variable)?;
                if *operator == Operator::Div && is_identically_zero(&b.value) {
                    self.error(right.place, mistake::division_by_zero());
                    return None;
                }
                let a = a?;
                let terms = a.terms + b.terms;
                self.limit(terms, expr.place)?;
                Measured {
                    value: apply(*operator, a.value, b.value)?,
                    terms,
                    is_computed: true,
                }
            }
        };
        let rational = measured.value.as_rational();
        if rational.is_some_and(|r| r.to_f64().value().is_infinite()) {
            self.error(expr.place, mistake::too_large());
            return None;
        }
        self.limit_digits(&measured.value, expr.place)?;
        Some(measured)
    }

    /// A value that was put together of values that are good, or `None` where it is longer than a value may be.
    pub(super) fn limited(&self, value: Value, place: Place) -> Option<Value> {
        self.limit(terms(&value), place)?;
        self.limit_digits(&value, place)?;
        Some(value)
    }

    fn limit_digits(&self, value: &Value, place: Place) -> Option<()> {
        if value
            .as_rational()
            .is_none_or(|r| bit_length(r) <= MOST_BITS)
        {
            return Some(());
        }
        self.error(place, size::digits());
        None
    }

    /// A function of a number.
    fn function(
        &mut self,
        function: Elementary,
        argument: &Expr,
        place: Place,
        variable: Option<&'static str>,
    ) -> Option<Measured> {
        let x = self.measured(argument, variable)?;
        if function != Elementary::Sqrt {
            self.report_odd(argument, &x);
        }
        match elementary::value(function, &x.value) {
            Ok(value) => Some(Measured {
                value: Value::Rational(value),
                terms: x.terms,
                is_computed: true,
            }),
            Err(mistake) => {
                self.error(place, mistake);
                None
            }
        }
    }

    fn limit(&self, terms: usize, place: Place) -> Option<()> {
        if terms <= MOST_TERMS {
            return Some(());
        }
        self.error(place, size::terms());
        None
    }

    fn lookup(
        &mut self,
        name: &str,
        place: Place,
        variable: Option<&'static str>,
    ) -> Option<Measured> {
        if name == "PI" {
            return Some(Measured::of(Value::Pi));
        }
        match self.names.get(name.strip_prefix("r#").unwrap_or(name)) {
            Some(Binding::Field(index)) => {
                self.used[*index] = true;
                Some(Measured::of(Value::field(*index)))
            }
            Some(Binding::Let(value)) => value.clone(),
            None => {
                if self.complete && !self.diagnostics.is_full() {
                    let mistake = self.unknown(name, variable);
                    self.error(place, mistake);
                }
                None
            }
        }
    }

    /// What to say about a name that is not in scope. A field that was meant is used.
    fn unknown(&mut self, name: &str, variable: Option<&'static str>) -> Mistake {
        if self.lets.iter().any(|bound| bound == name) {
            return mistake::bound_below(name);
        }
        if let Some(ours) = words::constant_of_std(name) {
            return mistake::constant_of_std(name, ours);
        }
        let names: Vec<&str> = self.names.keys().map(String::as_str).collect();
        let meant = words::nearest(name, &[names.as_slice(), &["PI"]].concat());
        if let Some(Binding::Field(index)) = meant.and_then(|meant| self.names.get(meant)) {
            self.used[*index] = true;
        }
        mistake::unknown_name(name, meant, &names, variable)
    }
}

/// Terms of the value.
fn terms(value: &Value) -> usize {
    match value {
        Value::Rational(_) | Value::Pi | Value::Field(_) => 1,
        Value::Neg(a) => terms(a),
        Value::Add(a, b) | Value::Mul(a, b) | Value::Div(a, b) => terms(a) + terms(b),
    }
}

/// Bits of the exact numbers in the value.
fn bits(value: &Value) -> usize {
    match value {
        Value::Rational(r) => bit_length(r),
        Value::Pi | Value::Field(_) => 0,
        Value::Neg(a) => bits(a),
        Value::Add(a, b) | Value::Mul(a, b) | Value::Div(a, b) => bits(a) + bits(b),
    }
}

/// The result, or `None` for a quotient by the number zero.
fn apply(operator: Operator, a: Value, b: Value) -> Option<Value> {
    match operator {
        Operator::Add => Some(a + b),
        Operator::Sub => Some(a - b),
        Operator::Mul => Some(a * b),
        Operator::Div => a.checked_div(b),
    }
}

/// The value, where it is a known number.
pub(super) fn number(value: &Value) -> Option<f64> {
    value.is_number().then(|| value.to_f64(&[]))
}

/// The length of a vector, where its components are known numbers.
pub(super) fn norm(vector: [Option<&Value>; 3]) -> Option<f64> {
    let [x, y, z] = vector.map(|component| Some(number(component?)?.powi(2)));
    Some((x? + y? + z?).sqrt())
}

/// The values, where all of them are known.
pub(super) fn all<const N: usize>(values: [Option<Value>; N]) -> Option<[Value; N]> {
    let values: Option<Vec<Value>> = values.into_iter().collect();
    values?.try_into().ok()
}

/// Whether the value is zero whatever the fields are.
///
/// A value is a rational function of the fields and of pi, which is transcendental:
/// where it vanishes at one point chosen at random, it is zero (Schwartz 1980,
/// J. ACM 27(4), 701-717). The point is one of a prime field, where no number gets longer than others.
pub(super) fn is_identically_zero(value: &Value) -> bool {
    at_random_point(value).is_some_and(Number::is_zero)
}

/// A number of the field.
type Number = Residue<{ (1 << 61) - 1 }>;

/// The value at one fixed point, `None` at a pole and where a number has no image in the field.
fn at_random_point(value: &Value) -> Option<Number> {
    Some(match value {
        Value::Rational(r) => Number::from_rational(r)?,
        Value::Pi => coordinate(0),
        Value::Field(index) => coordinate(*index as u64 + 1),
        Value::Neg(a) => -at_random_point(a)?,
        Value::Add(a, b) => at_random_point(a)? + at_random_point(b)?,
        Value::Mul(a, b) => at_random_point(a)? * at_random_point(b)?,
        Value::Div(a, b) => at_random_point(a)? * at_random_point(b)?.inverse()?,
    })
}

/// The coordinate of that index of the fixed point.
fn coordinate(index: u64) -> Number {
    Number::new(SplitMix64::number(0, index))
}
