//! Values of cells on their way through an expression.

use dynamics_symbolic::robot::Value;

use super::angle::{Odd, odd};
use crate::description::Operator;
use crate::mistake::couple as mistake;
use crate::place::Place;
use crate::tree::Fault;

/// A value and how it came about. In the position of a follower it is `factor * leader + value`.
#[derive(Clone)]
pub(super) struct Measured {
    pub(super) value: Value,
    /// The number of its terms.
    pub(super) terms: usize,
    /// Whether two values were put together in it.
    pub(super) is_computed: bool,
    pub(super) leader: Option<Box<Leader>>,
}

/// A joint in the position of a follower.
#[derive(Clone)]
pub(super) struct Leader {
    pub(super) name: String,
    pub(super) place: Place,
    pub(super) factor: Value,
    /// The oddity of the value beside it as an angle, if that is one value as it was written, up to sign.
    pub(super) odd: Option<(Odd, Place)>,
}

impl Leader {
    fn scaled(&self, factor: Value) -> Box<Leader> {
        Box::new(Leader {
            factor,
            odd: None,
            ..self.clone()
        })
    }
}

impl Measured {
    /// A number or a name.
    pub(super) fn new(value: Value) -> Measured {
        Measured {
            value,
            terms: 1,
            is_computed: false,
            leader: None,
        }
    }

    /// The position of the joint of that name.
    pub(super) fn position_of(name: &str, place: Place) -> Measured {
        let leader = Leader {
            name: name.to_owned(),
            place,
            factor: Value::integer(1),
            odd: None,
        };
        Measured {
            leader: Some(Box::new(leader)),
            ..Measured::new(Value::zero())
        }
    }

    pub(super) fn negated(mut self) -> Measured {
        self.value = -self.value;
        if let Some(leader) = &mut self.leader {
            leader.factor = -leader.factor.clone();
        }
        self
    }

    /// The value in rad of one in degrees.
    pub(super) fn degrees(self) -> Option<Measured> {
        let half_turn = Value::integer(180);
        let value = if self.leader.is_none() {
            // The quotient first: deg(90) is PI/2, with no rounding of 90 PI.
            self.value.checked_div(half_turn.clone())? * Value::Pi
        } else {
            self.value * Value::Pi.checked_div(half_turn.clone())?
        };
        let degree = Value::Pi.checked_div(half_turn)?;
        let leader = self.leader;
        Some(Measured {
            value,
            terms: self.terms + 2,
            is_computed: self.is_computed,
            leader: leader.map(|leader| leader.scaled(leader.factor.clone() * degree)),
        })
    }

    fn odd(&self, place: Place) -> Option<(Odd, Place)> {
        match &self.leader {
            Some(leader) => leader.odd.clone(),
            None => odd(&self.value, self.is_computed).map(|odd| (odd, place)),
        }
    }
}

/// The leader in what an operator makes of two values at `places`. The error says why the position of `follower` is not
/// linear.
pub(super) fn leader(
    operator: Operator,
    [a, b]: [&Measured; 2],
    places: [Place; 2],
    follower: &str,
) -> Result<Option<Box<Leader>>, Fault> {
    let not_linear = |leader: &Leader, place| {
        let mistake = mistake::not_linear(follower, &leader.name);
        Err((place, mistake))
    };
    let (one, other) = match (&a.leader, &b.leader) {
        (None, None) => return Ok(None),
        leaders => leaders,
    };
    match (operator, one, other) {
        (Operator::Mul, Some(_), Some(leader)) => not_linear(leader, places[0].to(places[1])),
        (Operator::Mul, Some(leader), _) => {
            Ok(Some(leader.scaled(leader.factor.clone() * b.value.clone())))
        }
        (Operator::Mul, _, leader) => Ok(leader
            .as_ref()
            .map(|leader| leader.scaled(a.value.clone() * leader.factor.clone()))),
        (Operator::Div, _, Some(leader)) => not_linear(leader, places[1]),
        (Operator::Div, leader, _) => Ok(leader.as_ref().and_then(|leader| {
            let quotient = leader.factor.clone().checked_div(b.value.clone());
            quotient.map(|factor| leader.scaled(factor))
        })),
        (Operator::Add | Operator::Sub, one, other) => {
            let mut sum = one.clone();
            if let Some(other) = other {
                let is_sum = operator == Operator::Add;
                let factor = other.factor.clone();
                let added = if is_sum { factor } else { -factor };
                match &mut sum {
                    Some(one) if one.name != other.name => {
                        let mistake = mistake::two_leaders(follower, &[&one.name, &other.name]);
                        return Err((other.place, mistake));
                    }
                    Some(one) => one.factor = one.factor.clone() + added,
                    None => sum = Some(other.scaled(added)),
                }
            }
            if let Some(sum) = &mut sum {
                sum.odd = match (a.value.is_zero(), b.value.is_zero()) {
                    (true, _) => b.odd(places[1]),
                    (_, true) => a.odd(places[0]),
                    _ => None,
                };
            }
            Ok(sum)
        }
    }
}
