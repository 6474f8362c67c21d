//! The names that a value may use, and what a value comes to.

use std::collections::BTreeMap;

use dynamics_symbolic::exact::{Residue, SplitMix64, bit_length};
use dynamics_symbolic::function::plain;
use dynamics_symbolic::robot::Value;

use super::measured::{self, Measured};
use super::named::read_masses;
use super::{angle, elementary};
use crate::audience::{AT_THE_END, Audience};
use crate::description::{
    Allow, Elementary, Entry, Expr, ExprKind, Given, Name, Operator, Row, Table, Vector,
};
use crate::diagnose::Diagnostics;
use crate::limits::{MOST_BITS, MOST_BITS_IN_ALL, MOST_TERMS, MOST_TERMS_IN_ALL};
use crate::mistake::{Mistake, couple, joint, size, value as mistake};
use crate::place::Place;
use crate::words;

/// A base that moves, as messages call what is read.
pub(super) const BASE: &str = "base";

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
    /// The size of all values so far.
    total: Total,
    /// The allowances of the whole table.
    everywhere: Allow,
    /// The allowances of the row or tool that is read, and how messages call it.
    body: Option<(Allow, &'static str)>,
    /// The cell that is read, where the joint's variable is added to it.
    variable: Option<&'static str>,
    /// The joint that follows another one, where its position is read.
    follower: Option<String>,
    /// The names of all joints.
    joints: Vec<String>,
    /// Names that nothing binds, in the order in which they are read.
    free: Vec<String>,
    /// The fields that the file lists, where it does.
    listed: Option<Vec<String>>,
    /// Whether a name that nothing binds is reported once, and not where it is used again.
    once: bool,
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
        let joints = table.rows().iter().filter_map(|row| row.name.as_ref());
        let mut everywhere = table.allow();
        everywhere.unphysical_inertia |= !read_masses(table);
        let mut scope = Scope {
            diagnostics,
            names: BTreeMap::new(),
            lets: Vec::new(),
            used: Vec::new(),
            complete: table.has_all_fields,
            total: Total::default(),
            everywhere,
            body: None,
            variable: None,
            follower: None,
            joints: joints.map(|name| name.plain().to_owned()).collect(),
            free: Vec::new(),
            listed: table
                .listed_fields()
                .map(|names| names.iter().map(|name| name.plain().to_owned()).collect()),
            once: table.audience == Audience::Command,
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

    /// Reads a row, the tool or a frame, which `place` says, with what is allowed there.
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

    /// The allowances of a row or tool, and of the whole table.
    pub(super) fn with(&self, allow: &Given<Allow>) -> Allow {
        self.everywhere.or(match allow {
            Given::Absent => Allow::default(),
            Given::Unreadable => Allow::EVERYTHING,
            Given::As(allow) => *allow,
        })
    }

    /// The allowances where the scope is now.
    pub(super) fn allowed(&self) -> Allow {
        self.body.map_or(self.everywhere, |(allow, _)| allow)
    }

    /// The row, the tool, the frame or the base that is read, as messages call it.
    pub(super) fn place(&self) -> &'static str {
        self.body.map_or("row", |(_, place)| place)
    }

    /// Whether it is a base that moves.
    pub(super) fn is_in_base(&self) -> bool {
        self.place() == BASE
    }

    /// Where it is allowed, as a message says it.
    pub(super) fn place_of_allow(&self) -> &'static str {
        match self.body {
            Some((_, "tool")) => "on the tool",
            Some((_, "frame")) => "on the frame",
            Some((_, BASE)) => "on the base",
            Some(_) => "on the row",
            None => AT_THE_END,
        }
    }

    /// Binds the name to the value.
    pub(super) fn bind(&mut self, name: &Name, value: Option<&Expr>) {
        let value = value.and_then(|value| self.counted(value));
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

    /// Whether no error was reported.
    pub(super) fn is_good(&self) -> bool {
        self.diagnostics.is_empty()
    }

    /// Whether the field of that index was used in a value.
    pub(super) fn is_used(&self, field: usize) -> bool {
        self.used.get(field).copied().unwrap_or(true)
    }

    /// Reads the cell of that name, to which the joint's variable is added.
    pub(super) fn beside_variable<T>(
        &mut self,
        cell: Option<&'static str>,
        read: impl FnOnce(&mut Self) -> T,
    ) -> T {
        self.variable = cell;
        let value = read(self);
        self.variable = None;
        value
    }

    /// The position of a follower, a linear function of one joint of the table.
    pub(super) fn position_of(&mut self, follower: &Name, position: &Expr) -> Option<Measured> {
        self.follower = Some(follower.plain().to_owned());
        let position = self.measured_cell(position);
        self.follower = None;
        position
    }

    /// The value of an expression, or `None` where it is in error.
    pub(super) fn value(&mut self, expr: &Expr) -> Option<Value> {
        Some(self.measured_cell(expr)?.value)
    }

    /// The value of an angle and what is odd about it, of which nothing is said.
    pub(super) fn unjudged_angle(&mut self, expr: &Expr) -> Option<(Value, Option<angle::Odd>)> {
        let Measured {
            value, is_computed, ..
        } = self.measured_cell(expr)?;
        let odd = angle::odd(&value, is_computed);
        Some((value, odd))
    }

    /// The value of an angle. One that was hardly meant is reported.
    fn written_angle(&mut self, expr: &Expr) -> Option<Value> {
        let (value, odd) = self.unjudged_angle(expr)?;
        odd.iter().for_each(|odd| self.report_odd(odd, expr.place));
        Some(value)
    }

    /// Reports what is odd about an angle, where that is not allowed.
    pub(super) fn report_odd(&self, odd: &angle::Odd, place: Place) {
        if !self.allowed().odd_angle {
            self.error(place, odd.mistake(self.place_of_allow()));
        }
    }

    /// The row of the joint of that name; reports that there is none.
    pub(super) fn row_of(&self, name: &Name, rows: &[Row]) -> Option<usize> {
        let row = rows.iter().position(|row| row.word() == name.plain());
        if row.is_none() {
            let known: Vec<&str> = self.joints.iter().map(String::as_str).collect();
            let meant = words::nearest(name.plain(), &known);
            self.error(
                name,
                crate::mistake::unknown("joint", name.plain(), meant, &known),
            );
        }
        row
    }

    /// The value of an angle; left out, it is zero.
    pub(super) fn angle(&mut self, cell: &Given<Expr>) -> Option<Value> {
        cell.read(Value::zero(), |expr| self.written_angle(expr))
    }

    /// Three angles; left out, they are zero.
    pub(super) fn angles(&mut self, angles: &Given<Vector>) -> Option<[Value; 3]> {
        let zero = [0; 3].map(Value::integer);
        angles.read(zero, |angles| {
            all(angles
                .each_ref()
                .map(|expr| self.written_angle(expr.as_ref()?)))
        })
    }

    /// The value of a cell; left out, it is zero.
    pub(super) fn given(&mut self, cell: &Given<Expr>) -> Option<Value> {
        cell.read(Value::zero(), |expr| self.value(expr))
    }

    /// A cell that is refused where it is known to be negative.
    pub(super) fn not_negative(&mut self, cell: &Given<Expr>, what: &str) -> Option<Value> {
        cell.read(Value::zero(), |expr| match self.value(expr)? {
            value if value.is_negative() => self.refused(expr.place, joint::negative(what)),
            value => Some(value),
        })
    }

    /// Three values; left out, they are zero.
    pub(super) fn given_vector(&mut self, vector: &Given<Vector>) -> Option<[Value; 3]> {
        vector.read([0; 3].map(Value::integer), |vector| self.vector(vector))
    }

    /// The values of three expressions.
    pub(super) fn vector(&mut self, vector: &Vector) -> Option<[Value; 3]> {
        all(vector.each_ref().map(|expr| self.value(expr.as_ref()?)))
    }

    fn measured_cell(&mut self, expr: &Expr) -> Option<Measured> {
        let measured = self.counted(expr)?;
        let value = &measured.value;
        // Bits of the exact numbers in it.
        self.total.bits += size_of(value, |leaf| leaf.as_rational().map_or(0, bit_length));
        if self.total.bits > MOST_BITS_IN_ALL {
            // Said once: the table would have to be as long again.
            self.total.bits = 0;
            return self.refused(expr.place, size::digits_in_all());
        }
        if value.is_number() && !value.to_f64(&[]).is_finite() {
            return self.refused(expr.place, mistake::too_large());
        }
        Some(measured)
    }

    /// The value, added to what there is in all.
    fn counted(&mut self, expr: &Expr) -> Option<Measured> {
        if self.total.terms > MOST_TERMS_IN_ALL || self.diagnostics.is_full() {
            return None;
        }
        let measured = self.measured(expr)?;
        self.total.terms += measured.terms;
        if self.total.terms > MOST_TERMS_IN_ALL {
            return self.refused(expr.place, size::terms_in_all());
        }
        Some(measured)
    }

    /// Reports why there is no value.
    pub(super) fn refused<T>(&self, place: Place, mistake: Mistake) -> Option<T> {
        self.error(place, mistake);
        None
    }

    fn measured(&mut self, expr: &Expr) -> Option<Measured> {
        // From the first operand on: a sum of hundreds of terms is nested as deep.
        let mut chain = Vec::new();
        let mut first = expr;
        while let ExprKind::Binary(operator, left, right) = &first.kind {
            chain.push((*operator, [left.as_ref(), right.as_ref()], first.place));
            first = left;
        }
        let mut measured = self.operand(first);
        for (operator, sides, place) in chain.into_iter().rev() {
            measured = self.binary(operator, measured, sides, place);
        }
        measured
    }

    /// A value that is no result of an operator of two.
    fn operand(&mut self, expr: &Expr) -> Option<Measured> {
        let measured = match &expr.kind {
            ExprKind::Value(value) => {
                let terms = size_of(value, |_| 1);
                self.limit(terms, expr.place)?;
                Measured {
                    terms,
                    is_computed: terms > 1,
                    ..Measured::new(value.clone())
                }
            }
            ExprKind::Name(name) => return self.lookup(name, expr.place),
            ExprKind::Degrees(angle) => self.degrees(angle, expr.place)?,
            ExprKind::Function(function, argument) => {
                self.function(*function, argument, expr.place)?
            }
            ExprKind::Minus(value) => self.measured(value)?.negated(),
            ExprKind::Binary(..) => self.measured(expr)?,
        };
        self.held(measured, expr.place)
    }

    /// The value unless it is too large, or takes too many digits.
    fn held(&self, measured: Measured, place: Place) -> Option<Measured> {
        let rational = measured.value.as_rational();
        if rational.is_some_and(|r| r.to_f64().value().is_infinite()) {
            return self.refused(place, mistake::too_large());
        }
        self.limit_digits(&measured.value, place)?;
        if let Some(leader) = &measured.leader {
            self.limit_digits(&leader.factor, place)?;
        }
        Some(measured)
    }

    fn degrees(&mut self, angle: &Expr, place: Place) -> Option<Measured> {
        let angle = self.measured(angle)?;
        let mistake = angle::degrees_of_radians(&angle.value, self.place_of_allow());
        let is_judged = angle.leader.is_none() && !self.allowed().odd_angle;
        match mistake.filter(|_| is_judged) {
            Some(mistake) => self.refused(place, mistake),
            None => angle.degrees(),
        }
    }

    fn binary(
        &mut self,
        operator: Operator,
        a: Option<Measured>,
        [left, right]: [&Expr; 2],
        place: Place,
    ) -> Option<Measured> {
        // The right side before the first `?`: there may be errors in both.
        let b = self.measured(right)?;
        if operator == Operator::Div && b.leader.is_none() && is_identically_zero(&b.value) {
            return self.refused(right.place, mistake::division_by_zero());
        }
        let a = a?;
        let terms = a.terms + b.terms;
        self.limit(terms, place)?;
        let follower = self.follower.as_deref().unwrap_or_default();
        let leader = measured::leader(operator, [&a, &b], [left.place, right.place], follower);
        let measured = Measured {
            leader: match leader {
                Ok(leader) => leader,
                Err((place, mistake)) => return self.refused(place, mistake),
            },
            value: apply(operator, a.value, b.value)?,
            terms,
            is_computed: true,
        };
        self.held(measured, place)
    }

    /// A value that was put together of values that are good, or `None` where it is longer than a value may be.
    pub(super) fn limited(&self, value: Value, place: Place) -> Option<Value> {
        self.limit(size_of(&value, |_| 1), place)?;
        self.limit_digits(&value, place)?;
        Some(value)
    }

    fn limit_digits(&self, value: &Value, place: Place) -> Option<()> {
        match value.as_rational() {
            Some(r) if bit_length(r) > MOST_BITS => self.refused(place, size::digits()),
            _ => Some(()),
        }
    }

    /// A function of a number.
    fn function(
        &mut self,
        function: Elementary,
        argument: &Expr,
        place: Place,
    ) -> Option<Measured> {
        let x = self.measured(argument)?;
        if let (Some(leader), Some(follower)) = (&x.leader, &self.follower) {
            return self.refused(place, couple::not_linear(follower, &leader.name));
        }
        if function != Elementary::Sqrt {
            let odd = angle::odd(&x.value, x.is_computed);
            odd.iter()
                .for_each(|odd| self.report_odd(odd, argument.place));
        }
        match elementary::value(function, &x.value) {
            Ok(value) => Some(Measured {
                terms: x.terms,
                is_computed: true,
                ..Measured::new(Value::Rational(value))
            }),
            Err(mistake) => self.refused(place, mistake),
        }
    }

    fn limit(&self, terms: usize, place: Place) -> Option<()> {
        if terms > MOST_TERMS {
            return self.refused(place, size::terms());
        }
        Some(())
    }

    fn lookup(&mut self, name: &str, place: Place) -> Option<Measured> {
        let word = plain(name);
        if self.follower.is_some() && self.joints.iter().any(|joint| joint == word) {
            return Some(Measured::position_of(word, place));
        }
        if name == "PI" {
            return Some(Measured::new(Value::Pi));
        }
        match self.names.get(word) {
            Some(Binding::Field(index)) => {
                self.used[*index] = true;
                Some(Measured::new(Value::field(*index)))
            }
            Some(Binding::Let(value)) => value.clone(),
            None if self.complete && !self.diagnostics.is_full() => {
                if self.once && self.free.iter().any(|known| known == word) {
                    return None;
                }
                self.free.push(word.to_owned());
                let mistake = self.unknown(name);
                self.refused(place, mistake)
            }
            None => {
                self.note_free(word);
                None
            }
        }
    }

    /// Notes a name that may be that of a field.
    fn note_free(&mut self, name: &str) {
        // The leader of a follower was meant to be a joint.
        let is_leader = self.follower.is_some()
            && words::nearest(
                name,
                &self.joints.iter().map(String::as_str).collect::<Vec<_>>(),
            )
            .is_some();
        let is_bound = self.lets.iter().any(|bound| bound == name);
        let is_known = self.free.iter().any(|known| known == name);
        if !(is_leader || is_bound || is_known) && mistake::may_be_a_field(name) {
            self.free.push(name.to_owned());
        }
    }

    /// The names that were noted.
    #[cfg(feature = "files")]
    pub(super) fn into_free_names(self) -> Vec<String> {
        self.free
    }

    /// The mistake of a name that is not in scope. A field that was meant is used.
    fn unknown(&mut self, name: &str) -> Mistake {
        if self.lets.iter().any(|bound| bound == name) {
            return mistake::bound_below(name);
        }
        let names: Vec<&str> = self.names.keys().map(String::as_str).collect();
        if let Some(follower) = &self.follower {
            let joints: Vec<&str> = self.joints.iter().map(String::as_str).collect();
            let others = joints.iter().filter(|joint| *joint != follower);
            let known: Vec<&str> = others.chain(&names).copied().collect();
            return couple::unknown_leader(name, words::nearest(name, &known), &joints);
        }
        if let Some(ours) = words::constant_of_std(name) {
            return mistake::constant_of_std(name, ours);
        }
        let meant = words::nearest(name, &[names.as_slice(), &["PI"]].concat());
        if let Some(Binding::Field(index)) = meant.and_then(|meant| self.names.get(meant)) {
            self.used[*index] = true;
        }
        let is_unlisted = |listed: &Vec<String>| listed.iter().all(|known| known != name);
        let is_unlisted = self.listed.as_ref().is_some_and(is_unlisted);
        if meant.is_none() && is_unlisted && mistake::may_be_a_field(name) {
            return mistake::unlisted_name(name);
        }
        mistake::unknown_name(name, meant, &names, self.variable)
    }
}

/// The sum of the sizes of all numbers, constants and fields in the value.
fn size_of(value: &Value, leaf: fn(&Value) -> usize) -> usize {
    match value {
        Value::Rational(_) | Value::Pi | Value::Field(_) => leaf(value),
        Value::Neg(a) => size_of(a, leaf),
        Value::Add(a, b) | Value::Mul(a, b) | Value::Div(a, b) => {
            size_of(a, leaf) + size_of(b, leaf)
        }
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
pub(super) fn norm(vector: &[Value; 3]) -> Option<f64> {
    let [x, y, z] = vector.each_ref().map(number);
    Some(x?.hypot(y?).hypot(z?))
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
