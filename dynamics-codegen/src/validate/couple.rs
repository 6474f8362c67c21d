//! Joints that follow others.

use std::collections::BTreeSet;

use dynamics_symbolic::robot::{Coupling, JointType, Row, Value};

use super::angle::Odd;
use super::scope::{Scope, is_identically_zero};
use crate::description::{self, Coupled, Expr, ExprKind, Given, Name, Operator};
use crate::limits::{MOST_FOLLOWERS, MOST_JOINTS_OF_COUPLED};
use crate::mistake::{couple as mistake, entry};
use crate::place::Place;
use crate::words;

/// A joint that follows another one.
pub(super) struct Couple {
    name: Name,
    /// `None` where it is in error.
    law: Option<Law>,
}

/// factor * leader + offset
struct Law {
    leader: String,
    factor: Value,
    offset: Value,
    /// What is odd about the offset, where it is an angle.
    odd: Option<(Odd, Place)>,
}

/// The couplings, in the scope of the place where they are written; `joints` are the names of all joints.
pub(super) fn couplings(
    coupled: Option<&[Coupled]>,
    joints: &[String],
    scope: &mut Scope,
) -> Vec<Couple> {
    let coupled = coupled.unwrap_or_default();
    let couple = |coupled: &Coupled| Couple {
        name: coupled.follower.clone(),
        law: coupled
            .position
            .as_ref()
            .and_then(|position| law(position, &coupled.follower, joints, scope)),
    };
    coupled.iter().map(couple).collect()
}

fn law(position: &Expr, follower: &Name, joints: &[String], scope: &mut Scope) -> Option<Law> {
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
                self.combined(*operator, a?, b?, [left, right])
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
                let mistake = mistake::two_leaders(self.follower, [&first, &second]);
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

/// Couples the rows' joints. A row that is in error (`None`) is known by its name alone. What follows a
/// joint that is locked is locked, and what follows a follower follows the joint that leads that one.
pub(super) fn couple(
    rows: &mut [Option<Row>],
    couples: &[Couple],
    written: &[description::Row],
    scope: &Scope,
) {
    let names: Vec<String> = written.iter().map(name_of).collect();
    let position = |word: &str| names.iter().position(|name| name == word);
    if let Some(first_too_many) = couples.get(MOST_FOLLOWERS) {
        scope.error(&first_too_many.name, mistake::too_many());
        return;
    }
    if let Some(couple) = couples.first()
        && names.len() > MOST_JOINTS_OF_COUPLED
    {
        let mistake = mistake::too_many_rows(MOST_JOINTS_OF_COUPLED);
        scope.error(&couple.name, mistake);
        return;
    }
    let mut laws: Vec<Option<(usize, &Law)>> = names.iter().map(|_| None).collect();
    let mut seen = BTreeSet::new();
    for couple in couples {
        let word = couple.name.plain();
        let Some(row) = position(word) else {
            let known: Vec<&str> = names.iter().map(String::as_str).collect();
            let mistake = entry::unknown_joint(word, words::nearest(word, &known), &known);
            scope.error(&couple.name, mistake);
            continue;
        };
        if !seen.insert(row) {
            scope.error(&couple.name, mistake::twice(word));
            continue;
        }
        if rows[row].as_ref().is_some_and(|row| row.locked.is_some()) {
            scope.error(&couple.name, mistake::locked(word));
            continue;
        }
        let Some(law) = &couple.law else {
            continue;
        };
        // A URDF file has limits at each joint, and angles that are rounded where it is asked for.
        if written[row].mount.is_none() {
            report_limits(&written[row], &law.leader, scope);
            report_offset(rows[row].as_ref(), law, scope);
        }
        laws[row] = position(&law.leader).map(|leader| (leader, law));
    }
    if report_circles(&laws, couples, &names, scope) {
        return;
    }
    for row in 0..names.len() {
        let Some((leader, factor, offset)) = resolved(&laws, row) else {
            continue;
        };
        let locked = rows[leader].as_ref().and_then(|row| row.locked.clone());
        let Some(row) = &mut rows[row] else {
            continue;
        };
        // It is where the joint that leads is, within the limits of that one.
        row.limits = None;
        match locked {
            Some(position) => row.locked = Some(factor * position + offset),
            None => {
                row.follows = Some(Coupling {
                    leader,
                    factor,
                    offset,
                });
            }
        }
    }
}

fn name_of(row: &description::Row) -> String {
    row.name
        .as_ref()
        .map_or(String::new(), |name| name.plain().to_owned())
}

fn report_limits(row: &description::Row, leader: &str, scope: &Scope) {
    let Given::As([Some(lower), Some(upper)]) = &row.limits else {
        return;
    };
    let mistake = mistake::limits(&name_of(row), leader);
    scope.error(lower.place.to(upper.place), mistake);
}

/// Reports an offset that was hardly meant as an angle.
fn report_offset(row: Option<&Row>, law: &Law, scope: &Scope) {
    let is_angle = row.is_some_and(|row| row.joint_type == JointType::Revolute);
    if let Some((odd, place)) = &law.odd
        && is_angle
        && !scope.allowed().odd_angle
    {
        scope.error(*place, odd.mistake(scope.place_of_allow()));
    }
}

/// Reports every circle of followers, once; whether there is one.
fn report_circles(
    laws: &[Option<(usize, &Law)>],
    couples: &[Couple],
    names: &[String],
    scope: &Scope,
) -> bool {
    let mut in_circles: BTreeSet<usize> = BTreeSet::new();
    for couple in couples {
        let start = names.iter().position(|name| name == couple.name.plain());
        let Some(start) = start.filter(|start| !in_circles.contains(start)) else {
            continue;
        };
        let mut chain = vec![start];
        while let Some((leader, _)) = chain.last().and_then(|&row| laws[row]) {
            chain.push(leader);
            if leader == start {
                let names: Vec<&str> = chain.iter().map(|&row| names[row].as_str()).collect();
                scope.error(&couple.name, mistake::circle(&names));
                in_circles.extend(&chain);
                break;
            }
            if chain.len() > laws.len() {
                break;
            }
        }
    }
    !in_circles.is_empty()
}

/// The row that leads a follower in the end, the factor and the offset.
fn resolved(laws: &[Option<(usize, &Law)>], row: usize) -> Option<(usize, Value, Value)> {
    let (mut leader, law) = laws[row]?;
    let (mut factor, mut offset) = (law.factor.clone(), law.offset.clone());
    while let Some((next, law)) = laws[leader] {
        // k (k' q + c') + c
        offset = factor.clone() * law.offset.clone() + offset;
        factor = factor * law.factor.clone();
        leader = next;
    }
    Some((leader, factor, offset))
}
