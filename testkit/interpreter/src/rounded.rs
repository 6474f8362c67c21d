//! Programs of the engine, run in the arithmetic of any scalar.

use std::f64::consts::PI;

use dynamics_runtime::{DoubleDouble, Scalar, SingularMassMatrix};
use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::function::Argument;
use dynamics_symbolic::program::{Arithmetic, Constant, ConstantId, Operand, Program};
use dynamics_symbolic::robot::Symbol;

/// A program with its constants as they are emitted, each correctly rounded.
pub struct Rounded<'a> {
    program: &'a Program,
    constants: Vec<f64>,
}

/// The inputs of a program.
#[derive(Clone, Copy)]
pub struct Inputs<'a> {
    /// Values of the fields.
    pub fields: &'a [f64],
    /// Positions; behind those of the joints those of followers, less their offsets.
    pub q: &'a [f64],
    /// Velocities; behind those of the joints those of followers.
    pub qd: &'a [f64],
    /// Accelerations.
    pub qdd: &'a [f64],
    /// Forces and torques.
    pub tau: &'a [f64],
    /// Stribeck's velocities, of joints that have one.
    pub stribeck: &'a [f64],
    /// Velocities of a reference motion.
    pub qd_r: &'a [f64],
    /// Accelerations of a reference motion.
    pub qdd_r: &'a [f64],
    /// Rates of the accelerations.
    pub jerk: &'a [f64],
    /// Rates of these.
    pub snap: &'a [f64],
    /// Force and moment at the tip.
    pub wrench: &'a [f64],
}

impl Inputs<'_> {
    /// The value of a symbol. The sines of a table's angles are taken of doubles.
    fn value<T: Scalar>(&self, symbol: &Symbol) -> T {
        let number = |x: f64| T::from_f64(x);
        match symbol {
            Symbol::Pi => number(PI),
            Symbol::Field(i) => number(self.fields[*i]),
            Symbol::AngleSine(angle) => number(Scalar::sin_cos(angle.to_f64(self.fields)).0),
            Symbol::AngleCosine(angle) => number(Scalar::sin_cos(angle.to_f64(self.fields)).1),
            Symbol::Sine(i) => number(self.q[*i]).sin_cos().0,
            Symbol::Cosine(i) => number(self.q[*i]).sin_cos().1,
            Symbol::Position(i) => number(self.q[*i]),
            Symbol::Velocity(i) => number(self.qd[*i]),
            Symbol::Acceleration(i) => number(self.qdd[*i]),
            Symbol::Force(i) => number(self.tau[*i]),
            Symbol::VelocitySign(i) => number(Scalar::sign(self.qd[*i])),
            Symbol::Stribeck(i) => {
                let x = number(self.qd[*i]) / number(self.stribeck[*i]);
                (-(x * x)).exp()
            }
            Symbol::Entry(argument, i) => number(self.argument(*argument)[*i]),
        }
    }

    fn argument(&self, argument: Argument) -> &[f64] {
        match argument {
            Argument::Position => self.q,
            Argument::Velocity => self.qd,
            Argument::Acceleration => self.qdd,
            Argument::Force => self.tau,
            Argument::ReferenceVelocity => self.qd_r,
            Argument::ReferenceAcceleration => self.qdd_r,
            Argument::Jerk => self.jerk,
            Argument::Snap => self.snap,
            Argument::Wrench => self.wrench,
            Argument::Base | Argument::Order | Argument::Pose => &[],
        }
    }
}

impl<'a> Rounded<'a> {
    /// The program with its constants.
    pub fn new(program: &'a Program) -> Self {
        Rounded {
            program,
            constants: program.rounded_constants(),
        }
    }

    /// The outputs by the operations and from the constants of the function that is emitted.
    pub fn run<T: Scalar>(&self, inputs: &Inputs<'_>) -> Vec<T> {
        let constants = self.constants.iter().map(|x| T::from_f64(*x)).collect();
        let mut at = At(|symbol: &Symbol| inputs.value(symbol));
        self.program.evaluate_with(constants, &mut at)
    }

    /// The sizes of the outputs: of all that the program adds on the way to them, with one sign.
    pub fn sizes(&self, inputs: &Inputs<'_>) -> Vec<f64> {
        let constants = self.constants.iter().map(|x| Sized::new(*x)).collect();
        let outputs = self.program.evaluate_with(constants, &mut Sizes(inputs));
        outputs.into_iter().map(|output| output.size).collect()
    }

    /// The program with constants of 31 digits.
    pub fn with_all_digits(&self) -> AllDigits<'a> {
        let rests = rests(self.program, &self.constants);
        let parts = self.constants.iter().zip(rests);
        let constants = parts.map(|(&x, rest)| DoubleDouble::from(x) + DoubleDouble::from(rest));
        AllDigits {
            program: self.program,
            constants: constants.collect(),
        }
    }
}

/// A program with its constants in 31 digits.
pub struct AllDigits<'a> {
    program: &'a Program,
    constants: Vec<DoubleDouble>,
}

impl AllDigits<'_> {
    /// The outputs: those of the rational functions that the program computes, to 31 digits of what is
    /// added.
    pub fn run(&self, inputs: &Inputs<'_>) -> Vec<DoubleDouble> {
        let mut at = At(|symbol: &Symbol| inputs.value(symbol));
        self.program.evaluate_with(self.constants.clone(), &mut at)
    }
}

/// Whether a function that solves equations refuses: `tests` are the pivots, then the diagonal of M.
pub fn is_refused<T: Scalar>(tests: &[T]) -> bool {
    let (pivots, diagonal) = tests.split_at(tests.len() / 2);
    let mut tests = pivots.iter().zip(diagonal);
    tests.any(|(&pivot, &entry)| SingularMassMatrix::test(0, pivot, entry).is_err())
}

/// The difference of each constant of a program from its double, as a double.
fn rests(program: &Program, doubles: &[f64]) -> Vec<f64> {
    let mut pool = program.constants.clone();
    let mut rests: Vec<Option<ConstantId>> = vec![None; doubles.len()];
    let operands = program.instructions.iter().flat_map(|instruction| {
        let [a, b] = instruction.operands();
        [a, b]
    });
    for operand in operands.chain(program.outputs.iter().map(|output| output.operand)) {
        if let Operand::Constant(id) = operand
            && rests[id.index()].is_none()
        {
            let double = Rational::try_from(-doubles[id.index()]).expect("a finite constant");
            let double = pool.push(Constant::Rational(double));
            rests[id.index()] = Some(pool.push(Constant::Add(id, double)));
        }
    }
    let rounded = pool.round(|id| rests.contains(&Some(id)));
    let rest = |id: Option<ConstantId>| id.map_or(0.0, |id| rounded[id.index()]);
    rests.into_iter().map(rest).collect()
}

/// A scalar's arithmetic, at the values that a function gives the symbols.
pub struct At<F>(pub F);

impl<T: Scalar, F: FnMut(&Symbol) -> T> Arithmetic for At<F> {
    type Number = T;

    fn rational(&mut self, x: &Rational) -> T {
        T::from_f64(x.to_f64().value())
    }

    fn symbol(&mut self, symbol: &Symbol) -> T {
        (self.0)(symbol)
    }

    fn neg(&mut self, a: T) -> T {
        -a
    }

    fn add(&mut self, a: T, b: T) -> T {
        a + b
    }

    fn mul(&mut self, a: T, b: T) -> T {
        a * b
    }

    fn div(&mut self, a: T, b: T) -> T {
        a / b
    }
}

/// A number and its size: what it would be if all that is added on the way to it had one sign.
#[derive(Clone, Copy)]
struct Sized {
    value: f64,
    size: f64,
}

impl Sized {
    fn new(value: f64) -> Self {
        let size = value.abs();
        Sized { value, size }
    }
}

struct Sizes<'a>(&'a Inputs<'a>);

impl Arithmetic for Sizes<'_> {
    type Number = Sized;

    fn rational(&mut self, x: &Rational) -> Sized {
        Sized::new(x.to_f64().value())
    }

    fn symbol(&mut self, symbol: &Symbol) -> Sized {
        Sized::new(self.0.value(symbol))
    }

    fn neg(&mut self, a: Sized) -> Sized {
        let value = -a.value;
        Sized { value, ..a }
    }

    fn add(&mut self, a: Sized, b: Sized) -> Sized {
        Sized {
            value: a.value + b.value,
            size: a.size + b.size,
        }
    }

    fn mul(&mut self, a: Sized, b: Sized) -> Sized {
        Sized {
            value: a.value * b.value,
            size: a.size * b.size,
        }
    }

    /// A divisor that is a small difference of large numbers makes the quotient's error so much larger.
    fn div(&mut self, a: Sized, b: Sized) -> Sized {
        Sized {
            value: a.value / b.value,
            size: a.size * b.size / (b.value * b.value),
        }
    }
}
