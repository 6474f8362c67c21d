//! The law by which a joint follows another one: an expression that is linear in the leader's position.

use dynamics_symbolic::robot::Value;

use super::super::angle::Odd;
use super::super::scope::{Scope, is_identically_zero};
use crate::description::{Expr, ExprKind, Name, Operator};
use crate::mistake::couple as mistake;
use crate::place::Place;
use crate::words;

/// factor * leader + offset
pub(super) struct Law {
    pub(super) leader: String,
    pub(super) factor: Value,
    pub(super) offset: Value,
    /// What is odd about the offset, where it is an angle.
    pub(super) odd: Option<(Odd, Place)>,
}

/// Reads the law of a follower.
pub(super) fn law(
    position: &Expr,
    follower: &Name,
    joints: &[String],
    scope: &mut Scope,
) -> Option<Law> {
    let mut reader = Reader {
        follower: follower.plain(),
        joints,
        scope,
    };
    let Linear { term, rest, odd } = reader.linear(position)?;
    let Some((leader, place, factor)) = term else {
        scope.error(position.place, mistake::no_leader(follower.plain()));
        return None;
    };
    if leader == follower.plain() {
        scope.error(place, mistake::itself(&leader));
        return None;
    }
    if is_identically_zero(&factor) {
        scope.error(
            position.place,
            mistake::factor_zero(follower.plain(), &leader),
        );
        return None;
    }
    Some(Law {
        leader,
        factor,
        offset: rest,
        odd,
    })
}

/// A value that may hold a joint's position, once and by a factor.
struct Linear {
    /// Name, place and factor of the joint.
    term: Option<(String, Place, Value)>,
    rest: Value,
    /// What is odd about the rest as an angle, where it is one value as it was written, up to sign.
    odd: Option<(Odd, Place)>,
}

impl Linear {
    fn negated(self) -> Self {
        Linear {
            term: self
                .term
                .map(|(name, place, factor)| (name, place, -factor)),
            rest: -self.rest,
            odd: self.odd,
        }
    }

    /// The same, or `None` where a value in it is longer than one may be.
    fn limited(self, scope: &Scope, place: Place) -> Option<Self> {
        let term = match self.term {
            Some((name, at, factor)) => Some((name, at, scope.limited(factor, place)?)),
            None => None,
        };
        Some(Linear {
            term,
            rest: scope.limited(self.rest, place)?,
            odd: self.odd,
        })
    }

    fn scaled(self, by: impl Fn(Value) -> Option<Value>) -> Option<Self> {
        let term = match self.term {
            Some((name, place, factor)) => Some((name, place, by(factor)?)),
            None => None,
        };
        Some(Linear {
            term,
            rest: by(self.rest)?,
            odd: None,
        })
    }
}

/// Reads the position of one follower.
struct Reader<'s, 'd> {
    follower: &'s str,
    joints: &'s [String],
    scope: &'s mut Scope<'d>,
}

impl Reader<'_, '_> {
    fn linear(&mut self, expr: &Expr) -> Option<Linear> {
        if !self.names_joint(expr) {
            self.report_unknown(expr)?;
            let (rest, odd) = self.scope.unjudged_angle(expr)?;
            return Some(Linear {
                term: None,
                rest,
                odd: odd.map(|odd| (odd, expr.place)),
            });
        }
        match &expr.kind {
            ExprKind::Number(_) => None,
            ExprKind::Name(name) => Some(Linear {
                term: Some((plain(name).to_owned(), expr.place, Value::integer(1))),
                rest: Value::zero(),
                odd: None,
            }),
            ExprKind::Degrees(angle) => {
                let degree = Value::Pi.checked_div(Value::integer(180))?;
                self.linear(angle)?.scaled(|x| Some(x * degree.clone()))
            }
            ExprKind::Function(_, value) => {
                let leader = self.linear(value)?.term.map(|(leader, ..)| leader);
                self.not_linear(&leader.unwrap_or_default(), expr.place)
            }
            ExprKind::Minus(value) => Some(self.linear(value)?.negated()),
            ExprKind::Binary(operator, left, right) => {
                // Both sides before either `?`: there may be errors in both.
                let (a, b) = (self.linear(left), self.linear(right));
                let combined = self.combined(*operator, a?, b?, [left, right])?;
                combined.limited(self.scope, expr.place)
            }
        }
    }

    fn combined(
        &mut self,
        operator: Operator,
        a: Linear,
        b: Linear,
        [left, right]: [&Expr; 2],
    ) -> Option<Linear> {
        match operator {
            Operator::Add => self.sum(a, b),
            Operator::Sub => self.sum(a, b.negated()),
            Operator::Mul => match (&a.term, &b.term) {
                (Some(_), Some((leader, ..))) => {
                    self.not_linear(leader, left.place.to(right.place))
                }
                (None, _) => b.scaled(|x| Some(a.rest.clone() * x)),
                (_, None) => a.scaled(|x| Some(x * b.rest.clone())),
            },
            Operator::Div => match &b.term {
                Some((leader, ..)) => self.not_linear(leader, right.place),
                None if is_identically_zero(&b.rest) => {
                    let division = crate::mistake::value::division_by_zero();
                    self.scope.error(right.place, division);
                    None
                }
                None => a.scaled(|x| x.checked_div(b.rest.clone())),
            },
        }
    }

    fn sum(&mut self, a: Linear, b: Linear) -> Option<Linear> {
        let term = match (a.term, b.term) {
            (Some((first, place, k)), Some((second, _, l))) if first == second => {
                Some((first, place, k + l))
            }
            (Some((first, ..)), Some((second, place, _))) => {
                let mistake = mistake::two_leaders(self.follower, &[&first, &second]);
                self.scope.error(place, mistake);
                return None;
            }
            (one, other) => one.or(other),
        };
        let odd = match (a.rest.is_zero(), b.rest.is_zero()) {
            (true, _) => b.odd,
            (_, true) => a.odd,
            _ => None,
        };
        Some(Linear {
            term,
            rest: a.rest + b.rest,
            odd,
        })
    }

    fn not_linear(&mut self, leader: &str, place: Place) -> Option<Linear> {
        let mistake = mistake::not_linear(self.follower, leader);
        self.scope.error(place, mistake);
        None
    }

    fn is_joint(&self, name: &str) -> bool {
        self.joints.iter().any(|joint| joint == plain(name))
    }

    fn names_joint(&self, expr: &Expr) -> bool {
        match &expr.kind {
            ExprKind::Number(_) => false,
            ExprKind::Name(name) => self.is_joint(name),
            ExprKind::Degrees(x) | ExprKind::Minus(x) | ExprKind::Function(_, x) => {
                self.names_joint(x)
            }
            ExprKind::Binary(_, a, b) => self.names_joint(a) || self.names_joint(b),
        }
    }

    /// A name that is no joint and no value may have been meant to be a joint.
    fn report_unknown(&mut self, expr: &Expr) -> Option<()> {
        match &expr.kind {
            ExprKind::Number(_) => Some(()),
            ExprKind::Name(name) if self.scope.has(plain(name)) => Some(()),
            ExprKind::Name(name) => {
                let joints: Vec<&str> = self.joints.iter().map(String::as_str).collect();
                let others = joints
                    .iter()
                    .copied()
                    .filter(|joint| *joint != self.follower);
                let known: Vec<&str> = others.chain(self.scope.names()).collect();
                let meant = words::nearest(plain(name), &known);
                let mistake = mistake::unknown_leader(plain(name), meant, &joints);
                self.scope.error(expr.place, mistake);
                None
            }
            ExprKind::Degrees(x) | ExprKind::Minus(x) | ExprKind::Function(_, x) => {
                self.report_unknown(x)
            }
            ExprKind::Binary(_, a, b) => {
                let (a, b) = (self.report_unknown(a), self.report_unknown(b));
                a.and(b)
            }
        }
    }
}

fn plain(name: &str) -> &str {
    name.strip_prefix("r#").unwrap_or(name)
}
