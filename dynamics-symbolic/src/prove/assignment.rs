//! The random point of the prime field: a value for every symbol.

use crate::exact::{Rational, Residue, SplitMix64, circle_point};
use crate::function::Argument;
use crate::program::Arithmetic;
use crate::robot::{Interpretation, Robot, Symbol, Value};

/// A number of the field in which programs are proven: 2^62 - 57 is prime.
pub type Number = Residue<{ (1 << 62) - 57 }>;

/// The variables of one joint at the random point.
#[derive(Clone, Copy, Debug)]
pub struct JointPoint {
    /// Sine and cosine of the joint angle.
    pub sin_cos: (Number, Number),
    /// Position.
    pub q: Number,
    /// Velocity.
    pub qd: Number,
    /// Acceleration.
    pub qdd: Number,
    /// Force or torque.
    pub tau: Number,
    /// Sign of the velocity (any number does: it is a symbol to the program).
    pub sign: Number,
    /// exp(-(qd/v)^2) (any number does, as for the sign).
    pub stribeck: Number,
}

/// A value for every symbol of a robot's equations.
pub struct Assignment {
    random: SplitMix64,
    pi: Number,
    fields: Vec<Number>,
    angles: Vec<(Value, (Number, Number))>,
    joints: Vec<JointPoint>,
    /// The seed of all other arguments.
    entries: u64,
    unfaithful: bool,
}

impl Assignment {
    /// The point that belongs to a seed.
    pub fn new(robot: &Robot, seed: u64) -> Self {
        let mut random = SplitMix64::new(seed);
        let pi = Number::random(&mut random);
        let fields = robot
            .fields
            .iter()
            .map(|_| Number::random(&mut random))
            .collect();
        let joints = robot.joints().map(|_| JointPoint {
            sin_cos: circle_point(&mut random),
            q: Number::random(&mut random),
            qd: Number::random(&mut random),
            qdd: Number::random(&mut random),
            tau: Number::random(&mut random),
            sign: Number::random(&mut random),
            stribeck: Number::random(&mut random),
        });
        let joints = joints.collect();
        Assignment {
            random,
            pi,
            fields,
            angles: Vec::new(),
            joints,
            entries: seed.rotate_left(32),
            unfaithful: false,
        }
    }

    /// The variables of the joints that move.
    pub fn joints(&self) -> &[JointPoint] {
        &self.joints
    }

    /// An entry of another argument than q, qd, qdd and tau.
    pub fn entry(&self, argument: Argument, index: usize) -> Number {
        let place = argument as u64 * 0x0001_0000 + index as u64;
        Number::random(&mut SplitMix64::new(self.entries ^ place))
    }

    /// Whether a constant of the table had no image in the field: nothing is proven then.
    pub fn is_unfaithful(&self) -> bool {
        self.unfaithful
    }
}

impl Interpretation for Assignment {
    type Number = Number;

    fn rational(&mut self, x: &Rational) -> Number {
        Number::from_rational(x).unwrap_or_else(|| {
            self.unfaithful = true;
            Number::ZERO
        })
    }

    fn pi(&mut self) -> Number {
        self.pi
    }

    fn field(&mut self, index: usize) -> Number {
        self.fields[index]
    }

    fn quotient(&mut self, a: Number, b: Number) -> Number {
        a * b.inverse().unwrap_or_else(|| {
            self.unfaithful = true;
            Number::ZERO
        })
    }

    fn circle(&mut self, angle: &Value) -> (Number, Number) {
        let opposite = -angle.clone();
        for (known, (s, c)) in &self.angles {
            if known == angle {
                return (*s, *c);
            }
            if *known == opposite {
                return (-*s, *c);
            }
        }
        let point = circle_point(&mut self.random);
        self.angles.push((angle.clone(), point));
        point
    }
}

/// Programs are evaluated in the field; a division by zero gives no number.
impl Arithmetic for Assignment {
    type Number = Option<Number>;

    fn rational(&mut self, x: &Rational) -> Option<Number> {
        Number::from_rational(x)
    }

    fn symbol(&mut self, symbol: &Symbol) -> Option<Number> {
        Some(match symbol {
            Symbol::Pi => self.pi,
            Symbol::Field(i) => self.fields[*i],
            Symbol::AngleSine(angle) => self.circle(angle).0,
            Symbol::AngleCosine(angle) => self.circle(angle).1,
            Symbol::Sine(i) => self.joints[*i].sin_cos.0,
            Symbol::Cosine(i) => self.joints[*i].sin_cos.1,
            Symbol::Position(i) => self.joints[*i].q,
            Symbol::Velocity(i) => self.joints[*i].qd,
            Symbol::Acceleration(i) => self.joints[*i].qdd,
            Symbol::Force(i) => self.joints[*i].tau,
            Symbol::VelocitySign(i) => self.joints[*i].sign,
            Symbol::Stribeck(i) => self.joints[*i].stribeck,
            Symbol::Entry(argument, i) => self.entry(*argument, *i),
        })
    }

    fn neg(&mut self, a: Option<Number>) -> Option<Number> {
        Some(-a?)
    }

    fn add(&mut self, a: Option<Number>, b: Option<Number>) -> Option<Number> {
        Some(a? + b?)
    }

    fn mul(&mut self, a: Option<Number>, b: Option<Number>) -> Option<Number> {
        Some(a? * b?)
    }

    fn div(&mut self, a: Option<Number>, b: Option<Number>) -> Option<Number> {
        Some(a? * b?.inverse()?)
    }
}
