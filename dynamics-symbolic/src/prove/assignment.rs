//! The random point of the prime field: a value for every symbol.

use crate::exact::{Rational, Residue, SplitMix64, circle_point, rotation_point};
use crate::function::Argument;
use crate::program::{Arithmetic, Instruction, Operand, Program};
use crate::robot::{Angle, Interpretation, JointType, Robot, Symbol, Value};

/// A number of the field in which programs are proven: 2^62 - 57 is prime.
pub type Number = Residue<{ (1 << 62) - 57 }>;

/// 1/2, because 2 (2^61 - 28) = 2^62 - 56.
pub(super) const HALF: Number = Number::new((1 << 61) - 28);

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

/// Purposes of random numbers, which a seed of their own keeps apart.
const ENTRIES: u64 = 1 << 32;
const OTHER_JOINTS: u64 = 2 << 32;
const ROTATION: u64 = 4 << 32;
pub(super) const STATES: u64 = 3 << 32;

/// A value for every symbol of a robot's equations, and a digest of what was read of it.
pub struct Assignment {
    random: SplitMix64,
    pi: Number,
    fields: Vec<Number>,
    angles: Vec<(Value, (Number, Number))>,
    /// The degrees of freedom, then the followers.
    joints: Vec<JointPoint>,
    /// The pose that is to be reached, where there is one, and numbers behind it.
    pose: Vec<Number>,
    seed: u64,
    unfaithful: bool,
    digest: u64,
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
        let joints = joint_points(robot, &mut random);
        Assignment {
            random,
            pi,
            fields,
            angles: Vec::new(),
            joints,
            pose: Vec::new(),
            seed,
            unfaithful: false,
            digest: 0,
        }
    }

    /// The seed of random numbers for a purpose of their own.
    pub(super) fn seed_for(&self, purpose: u64) -> u64 {
        SplitMix64::number(self.seed, purpose)
    }

    /// A cell of the table, noted in the digest.
    pub(super) fn cell(&mut self, cell: &Value) -> Number {
        let x = self.value(cell);
        self.note([x.get()]);
        x
    }

    /// Sine and cosine of a cell of the table, noted in the digest.
    pub(super) fn angle(&mut self, cell: &Value) -> (Number, Number) {
        let (s, c) = self.sin_cos(cell);
        self.note([s, c].map(Number::get));
        (s, c)
    }

    /// Adds words to the digest: each chooses a number of the sequence whose seed is the digest before it.
    pub(super) fn note(&mut self, words: impl IntoIterator<Item = u64>) {
        self.digest = words.into_iter().fold(self.digest, SplitMix64::number);
    }

    /// Adds a program to the digest. An input, as a constant, is known by its value at this point.
    pub(super) fn note_program(&mut self, program: &Program) {
        let constants = program.constants.evaluate(self);
        self.note(constants.into_iter().map(word_of_value));
        for symbol in &program.inputs {
            let value = self.symbol(symbol);
            self.note([word_of_value(value)]);
        }
        for instruction in &program.instructions {
            let [a, b] = instruction.operands();
            let operation = match instruction {
                Instruction::Add(..) => 0,
                Instruction::Sub(..) => 1,
                Instruction::Mul(..) => 2,
                Instruction::Div(..) => 3,
            };
            self.note([operation, word(a), word(b)]);
        }
        let outputs = program.outputs.iter();
        self.note(outputs.flat_map(|output| [word(output.operand), output.negative.into()]));
    }

    /// A number that differs wherever something else was read or added.
    pub(super) fn digest(&self) -> u64 {
        self.digest
    }

    /// The variables of the joints that move by themselves, then those of the followers, of which the
    /// sine, the cosine, the sign and the exponential are read.
    pub fn joints(&self) -> &[JointPoint] {
        &self.joints
    }

    /// Moves joint i to another position.
    pub(super) fn move_joint(&mut self, i: usize, sin_cos: (Number, Number), q: Number) {
        let joint = &mut self.joints[i];
        (joint.sin_cos, joint.q) = (sin_cos, q);
    }

    /// Sine, cosine and position of a joint.
    pub(super) fn position(&self, i: usize) -> (Number, Number, Number) {
        let JointPoint {
            sin_cos: (s, c), q, ..
        } = self.joints[i];
        (s, c, q)
    }

    /// Sets the pose that is to be reached: rotation by rows, position.
    pub(super) fn set_pose(&mut self, pose: [Number; 12]) {
        self.pose = pose.to_vec();
    }

    /// Sets numbers from that place on behind the entries of the pose, which has been set.
    pub(super) fn set_behind_pose(&mut self, place: usize, numbers: &[Number]) {
        self.pose.truncate(place);
        self.pose.resize(place, Number::ZERO);
        self.pose.extend(numbers);
    }

    /// Reads at this point, with joints at a point of another arm.
    pub(super) fn with_joints_of<T>(
        &mut self,
        robot: &Robot,
        read: impl FnOnce(&mut Self) -> T,
    ) -> T {
        let mut random = SplitMix64::new(self.seed_for(OTHER_JOINTS));
        let others = joint_points(robot, &mut random);
        let own = core::mem::replace(&mut self.joints, others);
        let value = read(self);
        self.joints = own;
        value
    }

    /// An entry of another argument than q, qd, qdd and tau. The base stands at a random rotation.
    pub fn entry(&self, argument: Argument, index: usize) -> Number {
        if argument == Argument::Base && index < 9 {
            let random = &mut SplitMix64::new(self.seed_for(ROTATION));
            return rotation_point(random)[index / 3][index % 3];
        }
        if argument == Argument::Pose && index < self.pose.len() {
            return self.pose[index];
        }
        let place = argument as u64 * 0x0001_0000 + index as u64;
        Number::random(&mut SplitMix64::new(self.seed_for(ENTRIES) ^ place))
    }

    /// Whether a constant of the table had no image in the field: nothing is proven then.
    pub fn is_unfaithful(&self) -> bool {
        self.unfaithful
    }
}

/// A value as a word, where there is one: numbers of the field are smaller.
fn word_of_value(value: Option<Number>) -> u64 {
    value.map_or(u64::MAX, Number::get)
}

/// An operand as a word.
fn word(operand: Operand) -> u64 {
    let (kind, index) = match operand {
        Operand::Constant(id) => (0, id.index() as u64),
        Operand::Input(index) => (1, u64::from(index)),
        Operand::Result(index) => (2, u64::from(index)),
    };
    index << 2 | kind
}

/// Random points of all joints. Where an angle is a whole multiple of another one, so is its point.
fn joint_points(robot: &Robot, random: &mut SplitMix64) -> Vec<JointPoint> {
    let freedoms = 0..robot.dof();
    let mut points: Vec<_> = freedoms.map(|_| JointPoint::random(random)).collect();
    for (row, coupling) in robot.followers() {
        let mut point = JointPoint::random(random);
        let leader = robot.joint_of(coupling.leader);
        let turn = [row, &robot.rows[coupling.leader]]
            .iter()
            .all(|row| row.joint_type == JointType::Revolute);
        if let Some(n) = whole(&coupling.factor).filter(|_| turn) {
            point.sin_cos = multiple(points[leader].sin_cos, n);
        }
        if let Some(sign) = coupling.sign() {
            let sign_of_leader = points[leader].sign;
            point.sign = if sign < 0 {
                -sign_of_leader
            } else {
                sign_of_leader
            };
        }
        points.push(point);
    }
    points
}

impl JointPoint {
    fn random(random: &mut SplitMix64) -> Self {
        JointPoint {
            sin_cos: circle_point(random),
            q: Number::random(random),
            qd: Number::random(random),
            qdd: Number::random(random),
            tau: Number::random(random),
            sign: Number::random(random),
            stribeck: Number::random(random),
        }
    }
}

/// A factor that is a whole number.
fn whole(factor: &Value) -> Option<i64> {
    let factor = factor.as_rational()?;
    factor
        .is_int()
        .then(|| i64::try_from(factor.round()).ok())?
}

/// Sine and cosine of the sum of two angles.
pub(super) fn turned((s, c): (Number, Number), (t, d): (Number, Number)) -> (Number, Number) {
    (s * d + c * t, c * d - s * t)
}

/// Sine and cosine of n times an angle: (c + i s)^n, by squares.
pub(super) fn multiple((s, c): (Number, Number), n: i64) -> (Number, Number) {
    let mut power = (Number::ZERO, Number::ONE);
    for bit in (0..64 - n.unsigned_abs().leading_zeros()).rev() {
        power = turned(power, power);
        if n.unsigned_abs() >> bit & 1 == 1 {
            power = turned(power, (s, c));
        }
    }
    if n < 0 { (-power.0, power.1) } else { power }
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
        for (known, (s, c)) in &self.angles {
            if known == angle {
                return (*s, *c);
            }
            if Angle::are_opposite(known, angle) {
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
