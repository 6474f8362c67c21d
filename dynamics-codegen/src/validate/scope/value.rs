//! The values of expressions.

use dynamics_symbolic::exact::bit_length;
use dynamics_symbolic::robot::Value;

use super::Scope;
use crate::description::{Elementary, Expr, ExprKind, Given, Name, Operator, Vector};
use crate::limits::{MOST_BITS, MOST_BITS_IN_ALL, MOST_TERMS, MOST_TERMS_IN_ALL};
use crate::mistake::{couple, joint, size, value as mistake};
use crate::place::Place;
use crate::validate::known::{all, is_identically_zero};
use crate::validate::measured::{self, Measured};
use crate::validate::{angle, elementary};

impl Scope<'_> {
    /// The position of a follower, a linear function of one joint of the table.
    pub(in crate::validate) fn position_of(
        &mut self,
        follower: &Name,
        position: &Expr,
    ) -> Option<Measured> {
        self.follower = Some(follower.plain().to_owned());
        let position = self.measured_cell(position);
        self.follower = None;
        position
    }

    /// The value of an expression, or `None` where it is in error.
    pub(in crate::validate) fn value(&mut self, expr: &Expr) -> Option<Value> {
        Some(self.measured_cell(expr)?.value)
    }

    /// The value of an angle and what is odd about it, of which nothing is said.
    pub(in crate::validate) fn unjudged_angle(
        &mut self,
        expr: &Expr,
    ) -> Option<(Value, Option<angle::Odd>)> {
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
    pub(in crate::validate) fn report_odd(&self, odd: &angle::Odd, place: Place) {
        if !self.allowed().odd_angle {
            self.error(place, odd.mistake(self.place_of_allow()));
        }
    }

    /// The value of an angle; left out, it is zero.
    pub(in crate::validate) fn angle(&mut self, cell: &Given<Expr>) -> Option<Value> {
        cell.read(Value::zero(), |expr| self.written_angle(expr))
    }

    /// Three angles; left out, they are zero.
    pub(in crate::validate) fn angles(&mut self, angles: &Given<Vector>) -> Option<[Value; 3]> {
        let zero = [0; 3].map(Value::integer);
        angles.read(zero, |angles| {
            all(angles
                .each_ref()
                .map(|expr| self.written_angle(expr.as_ref()?)))
        })
    }

    /// The value of a cell; left out, it is zero.
    pub(in crate::validate) fn given(&mut self, cell: &Given<Expr>) -> Option<Value> {
        cell.read(Value::zero(), |expr| self.value(expr))
    }

    /// A cell that is refused where it is known to be negative.
    pub(in crate::validate) fn not_negative(
        &mut self,
        cell: &Given<Expr>,
        what: &str,
    ) -> Option<Value> {
        cell.read(Value::zero(), |expr| match self.value(expr)? {
            value if value.is_negative() => self.refused(expr.place, joint::negative(what)),
            value => Some(value),
        })
    }

    /// Three values; left out, they are zero.
    pub(in crate::validate) fn given_vector(
        &mut self,
        vector: &Given<Vector>,
    ) -> Option<[Value; 3]> {
        vector.read([0; 3].map(Value::integer), |vector| self.vector(vector))
    }

    /// The values of three expressions.
    pub(in crate::validate) fn vector(&mut self, vector: &Vector) -> Option<[Value; 3]> {
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
    pub(super) fn counted(&mut self, expr: &Expr) -> Option<Measured> {
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
    pub(in crate::validate) fn limited(&self, value: Value, place: Place) -> Option<Value> {
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
