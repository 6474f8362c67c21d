//! Programs in arithmetic of any number of bits.

use dashu_float::round::mode::HalfEven;
use dashu_float::{Context, FBig};
use dynamics_symbolic::exact::{Rational, SplitMix64};
use dynamics_symbolic::program::{Arithmetic, Constant, ConstantPool, Program};
use dynamics_symbolic::robot::{Symbol, Value};

pub(crate) type Float = FBig<HalfEven, 2>;

/// A state, exact: sines and cosines are on the unit circle.
#[derive(Clone)]
pub(crate) struct State {
    pub(crate) joints: Vec<Joint>,
    pub(crate) fields: Vec<Rational>,
}

/// The state of one joint.
#[derive(Clone, Default)]
pub(crate) struct Joint {
    pub(crate) position: Rational,
    pub(crate) sine: Rational,
    pub(crate) cosine: Rational,
    pub(crate) velocity: Rational,
    pub(crate) acceleration: Rational,
    pub(crate) force: Rational,
}

impl Joint {
    /// At the angle whose half has the tangent t.
    pub(crate) fn at(t: &Rational) -> Self {
        let square = t * t;
        let scale = Rational::ONE / (Rational::ONE + &square);
        Joint {
            position: t.clone(),
            sine: Rational::from(2) * t * &scale,
            cosine: (Rational::ONE - square) * scale,
            ..Joint::default()
        }
    }
}

/// Every result, input and constant rounded once, to so many bits.
pub(crate) struct Bits<'a> {
    precision: usize,
    state: &'a State,
}

impl<'a> Bits<'a> {
    pub(crate) fn new(precision: usize, state: &'a State) -> Self {
        Bits { precision, state }
    }

    fn context(&self) -> Context<HalfEven> {
        Context::new(self.precision)
    }

    fn value(&mut self, value: &Value) -> Float {
        match value {
            Value::Rational(x) => self.rational(x),
            Value::Pi => self.context().pi(None).value(),
            Value::Field(i) => self.rational(&self.state.fields[*i].clone()),
            Value::Neg(a) => -self.value(a),
            Value::Add(a, b) => self.value(a) + self.value(b),
            Value::Mul(a, b) => self.value(a) * self.value(b),
            Value::Div(a, b) => self.value(a) / self.value(b),
        }
    }
}

impl Arithmetic for Bits<'_> {
    type Number = Float;

    fn rational(&mut self, x: &Rational) -> Float {
        let context = self.context();
        let numerator = Float::from(x.numerator().clone()).with_precision(0).value();
        let denominator = Float::from(x.denominator().clone())
            .with_precision(0)
            .value();
        context
            .div(numerator.repr(), denominator.repr())
            .expect("finite")
            .value()
    }

    fn symbol(&mut self, symbol: &Symbol) -> Float {
        let joint = |i: &usize| &self.state.joints[*i];
        let exact = match symbol {
            Symbol::Pi => return self.value(&Value::Pi),
            Symbol::AngleSine(angle) => {
                let angle = self.value(angle);
                return self
                    .context()
                    .sin(angle.repr(), None)
                    .expect("finite")
                    .value();
            }
            Symbol::AngleCosine(angle) => {
                let angle = self.value(angle);
                return self
                    .context()
                    .cos(angle.repr(), None)
                    .expect("finite")
                    .value();
            }
            Symbol::Field(i) => &self.state.fields[*i],
            Symbol::Sine(i) => &joint(i).sine,
            Symbol::Cosine(i) => &joint(i).cosine,
            Symbol::Position(i) => &joint(i).position,
            Symbol::Velocity(i) | Symbol::VelocitySign(i) | Symbol::Stribeck(i) => {
                &joint(i).velocity
            }
            Symbol::Acceleration(i) => &joint(i).acceleration,
            Symbol::Force(i) => &joint(i).force,
            Symbol::Entry(..) => unreachable!("nothing with other arguments is solved"),
        };
        self.rational(&exact.clone())
    }

    fn neg(&mut self, a: Float) -> Float {
        -a
    }

    fn add(&mut self, a: Float, b: Float) -> Float {
        self.context()
            .add(a.repr(), b.repr())
            .expect("finite")
            .value()
    }

    fn mul(&mut self, a: Float, b: Float) -> Float {
        self.context()
            .mul(a.repr(), b.repr())
            .expect("finite")
            .value()
    }

    fn div(&mut self, a: Float, b: Float) -> Float {
        self.context()
            .div(a.repr(), b.repr())
            .expect("a pivot of zero")
            .value()
    }
}

/// The program as it is emitted: its constants are doubles.
pub(crate) fn emitted(program: &Program) -> Program {
    let mut constants = ConstantPool::default();
    for x in program.rounded_constants() {
        let x = Rational::try_from(x).unwrap_or_default();
        constants.push(Constant::Rational(x));
    }
    Program {
        constants,
        ..program.clone()
    }
}

/// A number with three digits.
pub(crate) fn thousandths(random: &mut SplitMix64, limit: u64) -> Rational {
    let numerator = random.next_u64() % (2 * limit + 1);
    Rational::from_parts((numerator as i64 - limit as i64).into(), 1000_u32.into())
}
