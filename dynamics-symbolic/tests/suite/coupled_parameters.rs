//! Base parameters of arms whose joints follow others: no fewer would do, and no more are there.

use arms::{Bodies, Tables};
use dynamics_symbolic::derive::base::{columns, observed};
use dynamics_symbolic::derive::derive;
use dynamics_symbolic::exact::{
    MOST_BITS, Rational, Residue, SplitMix64, bit_length, circle_point,
};
use dynamics_symbolic::program::{Arithmetic, Constant, Instruction, Operand, Program};
use dynamics_symbolic::prove::{Proof, prove};
use dynamics_symbolic::robot::{
    Angle, Convention, Coupling, Grouping, JointType, Robot, Row, Symbol, Value,
};
use dynamics_symbolic::{Function, expand};

/// The functions whose columns are the base parameters.
const FUNCTIONS: [Function; 4] = [
    Function::Regressor,
    Function::BaseParameters,
    Function::PassivityRegressor,
    Function::EnergyRegressors,
];

/// Neither the graph's field nor the proof's.
type Number = Residue<2_305_843_009_213_693_921>;

/// Random numbers for the cells, the same at each state, and a random state at which sines of angles in
/// rational ratios belong together, however large the numbers of the ratio are.
struct Point<'r> {
    robot: &'r Robot,
    cells: SplitMix64,
    angles: Vec<(Value, (Number, Number))>,
    /// A common denominator of all factors.
    parts: i64,
    /// The sine and the cosine of each joint's angle over the denominator.
    angles_of_parts: Vec<(Number, Number)>,
    state: u64,
}

impl<'r> Point<'r> {
    fn new(robot: &'r Robot) -> Self {
        Point {
            robot,
            cells: SplitMix64::new(1),
            angles: Vec::new(),
            parts: common_denominator(robot),
            angles_of_parts: Vec::new(),
            state: 0,
        }
    }

    fn move_on(&mut self) {
        self.state += 1;
        let mut random = SplitMix64::new(self.state);
        let point = |_| circle_point(&mut random);
        self.angles_of_parts = (0..self.robot.dof()).map(point).collect();
    }

    /// Sine and cosine of a joint's angle, or of the factor times its leader's.
    fn joint(&self, index: usize) -> (Number, Number) {
        let Some((leader, factor)) = self.robot.followed(index) else {
            return times(self.angles_of_parts[index], self.parts);
        };
        let factor = factor.as_rational();
        match factor.map(|factor| factor * Rational::from(self.parts)) {
            Some(n) => times(
                self.angles_of_parts[leader],
                i64::try_from(n.round()).unwrap(),
            ),
            None => circle_point(&mut SplitMix64::new(self.state ^ (index as u64) << 32)),
        }
    }

    fn number(&self, kind: u64, index: usize) -> Number {
        Number::random(&mut SplitMix64::new(
            self.state << 16 | kind << 8 | index as u64,
        ))
    }
}

/// The least number by which all factors that are numbers are whole.
fn common_denominator(robot: &Robot) -> i64 {
    let factors = robot.rows.iter().filter_map(|row| row.follows.as_ref());
    let factors = factors.filter_map(|coupling| coupling.factor.as_rational());
    let parts = factors.fold(Rational::ONE, |parts, factor| {
        let rest = &parts * factor;
        parts * Rational::from(rest.denominator().clone())
    });
    i64::try_from(parts.round()).expect("few decimals")
}

/// Sine and cosine of n times an angle.
fn times(angle: (Number, Number), n: i64) -> (Number, Number) {
    let mut times = (Number::ZERO, Number::ONE);
    for bit in (0..64 - n.unsigned_abs().leading_zeros()).rev() {
        times = turned(times, times);
        if n.unsigned_abs() >> bit & 1 == 1 {
            times = turned(times, angle);
        }
    }
    if n < 0 { (-times.0, times.1) } else { times }
}

fn turned((s, c): (Number, Number), (t, d): (Number, Number)) -> (Number, Number) {
    (s * d + c * t, c * d - s * t)
}

impl Arithmetic for Point<'_> {
    type Number = Number;

    fn rational(&mut self, x: &Rational) -> Number {
        Number::from_rational(x).expect("an image")
    }

    fn symbol(&mut self, symbol: &Symbol) -> Number {
        match symbol {
            Symbol::Pi => Number::new(3_141),
            Symbol::Field(i) => Number::random(&mut SplitMix64::new(*i as u64 + 1_000)),
            Symbol::AngleSine(angle) | Symbol::AngleCosine(angle) => {
                let known = self.angles.iter().find(|(known, _)| known == angle);
                let point = match known {
                    Some((_, point)) => *point,
                    None => {
                        let point = circle_point(&mut self.cells);
                        self.angles.push((angle.clone(), point));
                        let opposite = (-point.0, point.1);
                        let negative = Angle::new(&-angle.clone());
                        self.angles
                            .extend(negative.rest.map(|angle| (angle, opposite)));
                        point
                    }
                };
                match symbol {
                    Symbol::AngleSine(_) => point.0,
                    _ => point.1,
                }
            }
            Symbol::Sine(i) => self.joint(*i).0,
            Symbol::Cosine(i) => self.joint(*i).1,
            Symbol::Position(i) => self.number(1, *i),
            Symbol::Velocity(i) => self.number(2, *i),
            Symbol::Acceleration(i) => self.number(3, *i),
            Symbol::Force(_) | Symbol::VelocitySign(_) | Symbol::Stribeck(_) => Number::ZERO,
            Symbol::Entry(argument, i) => self.number(4 + *argument as u64, *i),
        }
    }

    fn neg(&mut self, a: Number) -> Number {
        -a
    }

    fn add(&mut self, a: Number, b: Number) -> Number {
        a + b
    }

    fn mul(&mut self, a: Number, b: Number) -> Number {
        a * b
    }

    fn div(&mut self, a: Number, b: Number) -> Number {
        a * b.inverse().expect("not zero")
    }
}

/// The number of independent columns of a regressor over more states than there are columns.
fn rank(robot: &Robot, program: &Program, rows_of_state: usize) -> (usize, usize) {
    let width = program.outputs.len() / rows_of_state;
    let mut point = Point::new(robot);
    let mut rows: Vec<Vec<Number>> = Vec::new();
    for _ in 0..width + 2 {
        point.move_on();
        for row in program.evaluate(&mut point).chunks(width.max(1)) {
            let mut row = row.to_vec();
            for known in &rows {
                let lead = known.iter().position(|x| !x.is_zero()).unwrap();
                let factor = row[lead];
                let terms = row.iter_mut().zip(known);
                terms.for_each(|(x, &y)| *x = *x - factor * y);
            }
            if let Some(lead) = row.iter().find(|x| !x.is_zero()) {
                let inverse = lead.inverse().unwrap();
                rows.push(row.iter().map(|&x| x * inverse).collect());
            }
        }
    }
    (rows.len(), width)
}

/// The columns are independent, and the programs proven.
fn assert_smallest(robot: &Robot, what: &str) {
    let count = observed(robot).len();
    for function in FUNCTIONS {
        let program = derive(robot, function);
        assert_eq!(prove(robot, function, &program), Ok(()), "{what}");
        if let Function::Regressor | Function::PassivityRegressor = function {
            assert_eq!(rank(robot, &program, robot.dof()), (count, count), "{what}");
        }
    }
}

fn count_without_couplings(robot: &Robot) -> usize {
    columns(&Grouping::of(robot)).len()
}

fn row(name: &str, joint_type: JointType, [a, alpha, d, theta]: [Value; 4]) -> Row {
    Row {
        a,
        alpha,
        d,
        theta,
        mass: Value::integer(2),
        com: [
            arms::decimal(0.1),
            arms::decimal(0.02),
            arms::decimal(-0.03),
        ],
        inertia: [0.3, 0.4, 0.5, 0.01, -0.02, 0.03].map(arms::decimal),
        ..Row::new(name, joint_type)
    }
}

fn follows(mut row: Row, leader: usize, factor: Value, offset: Value) -> Row {
    row.follows = Some(Coupling {
        leader,
        factor,
        offset,
    });
    row
}

fn arm(convention: Convention, gravity: [i64; 3], fields: usize, rows: Vec<Row>) -> Robot {
    Robot {
        name: "arm".to_owned(),
        fields: (0..fields).map(|i| format!("p{i}")).collect(),
        convention,
        gravity: gravity.map(Value::integer),
        rows,
        frames: Vec::new(),
        neglected: None,
        bounds: Default::default(),
        base: None,
        tool: None,
    }
}

fn right() -> Value {
    Value::Pi * Value::Rational(Rational::from_parts(1.into(), 2_u32.into()))
}

/// Two fingers on a slide that move apart: of each the mass alone, both at the same speed.
#[test]
fn fingers_have_one_mass() {
    let zero = Value::zero;
    let fingers = |factor: Value, fields: usize| {
        let rows = vec![
            row(
                "lift",
                JointType::Prismatic,
                [zero(), zero(), zero(), zero()],
            ),
            row(
                "left",
                JointType::Prismatic,
                [zero(), right(), zero(), zero()],
            ),
            follows(
                row(
                    "right",
                    JointType::Prismatic,
                    [zero(), zero(), zero(), zero()],
                ),
                1,
                factor,
                arms::decimal(0.04),
            ),
        ];
        arm(Convention::Modified, [0, 0, -10], fields, rows)
    };
    // The right finger hangs on the left one. At the factor -1 it stands still beside it, at -2 it moves as fast
    // the other way: 2 T = m3 (v1^2 + (1 + k)^2 v2^2), so much of 2 T = m2 (v1^2 + v2^2) and of m1 v1^2.
    for (factor, fields, formulas) in [
        (Value::integer(-1), 0, ["m1 + m3", "m2"]),
        (Value::integer(-2), 0, ["m1", "m2 + m3"]),
        (Value::integer(2), 0, ["m1 - 8 m3", "m2 + 9 m3"]),
        (Value::field(0), 1, ["m1 + k1 m3", "m2 + k2 m3"]),
    ] {
        let robot = fingers(factor, fields);
        assert_eq!(
            (count_without_couplings(&robot), observed(&robot).len()),
            (3, 2)
        );
        assert_smallest(&robot, "gripper");
        let path = quote::quote!(robot_dynamics);
        let methods = expand(&robot, &[Function::BaseParameters], &path).expect("proven");
        let text = methods[0].tokens.to_string();
        for (number, formula) in (1..).zip(formulas) {
            assert!(
                text.contains(&format!("   {number}  {formula}\"")),
                "{text}"
            );
        }
    }
}

/// A parallelogram keeps the hand level: what turns with the waist alone is a part of that.
#[test]
fn a_palletiser() {
    let zero = Value::zero;
    let with_offset = |offset: Value| {
        let rows = vec![
            row(
                "waist",
                JointType::Revolute,
                [zero(), right(), Value::integer(1), zero()],
            ),
            row(
                "upper",
                JointType::Revolute,
                [arms::decimal(0.7), zero(), zero(), zero()],
            ),
            row(
                "fore",
                JointType::Revolute,
                [arms::decimal(0.6), zero(), zero(), zero()],
            ),
            follows(
                row(
                    "level",
                    JointType::Revolute,
                    [zero(), zero(), zero(), zero()],
                ),
                1,
                Value::integer(-1),
                zero(),
            ),
            follows(
                row(
                    "hand",
                    JointType::Revolute,
                    [arms::decimal(0.1), zero(), zero(), zero()],
                ),
                2,
                Value::integer(-1),
                offset,
            ),
        ];
        arm(Convention::Standard, [0, 0, -10], 0, rows)
    };
    for offset in [zero(), right(), arms::decimal(0.3)] {
        let robot = with_offset(offset);
        assert_eq!(count_without_couplings(&robot), 29);
        assert_smallest(&robot, "palletiser");
    }
}

/// Any factors and offsets, before and behind the joint that leads.
#[test]
fn random_arms() {
    let mut tables = Tables::new(21, Bodies::Any);
    let mut fewer = 0;
    for table in 0..30 {
        let mut robot = tables.coupled_robot();
        for row in &mut robot.rows {
            (row.spring, row.stribeck) = (None, None);
        }
        fewer += usize::from(observed(&robot).len() < count_without_couplings(&robot));
        assert_smallest(&robot, &format!("table {table}: {robot:#?}"));
    }
    assert!(fewer >= 15, "{fewer}");
}

/// Branches, also with followers on other ones, and bodies in frames.
#[test]
fn random_trees() {
    let mut tables = Tables::new(22, Bodies::Any);
    let mut trees = 0;
    for table in 0..30 {
        let mut robot = tables.tree();
        for row in &mut robot.rows {
            (row.spring, row.stribeck) = (None, None);
        }
        trees += usize::from(!robot.is_serial());
        assert_smallest(&robot, &format!("table {table}: {robot:#?}"));
    }
    assert!(trees >= 15, "{trees}");
}

/// Three joints on one motor: exact cosines of a thousand times an angle would not end.
#[test]
fn factors_of_three_decimals() {
    let zero = Value::zero;
    let joint = |name, a: f64, d: f64| {
        let cells = [arms::decimal(a), right(), arms::decimal(d), zero()];
        row(name, JointType::Revolute, cells)
    };
    let follows_by = |row, factor: f64| follows(row, 1, arms::decimal(factor), zero());
    let rows = vec![
        follows_by(joint("j0", 0.5, 0.0), -0.997),
        joint("j1", -0.2, 0.25),
        follows_by(joint("j2", 0.0, 0.3), -0.988027),
    ];
    let robot = arm(Convention::Modified, [0, 0, -10], 0, rows);
    assert_smallest(&robot, "three joints on one motor");
    assert_short(&robot);
}

/// A third and two thirds in four decimals keep a hand level together, and in four decimals there is no other way to
/// know.
#[test]
fn a_hand_that_two_followers_keep_level() {
    let zero = Value::zero;
    let joint = |name| {
        let cells = [arms::decimal(0.5), zero(), zero(), zero()];
        row(name, JointType::Revolute, cells)
    };
    let with = |factors: [f64; 2]| {
        let [second, third] = factors.map(arms::decimal);
        let rows = vec![
            joint("first"),
            follows(joint("second"), 0, second, zero()),
            follows(joint("third"), 0, third, zero()),
        ];
        arm(Convention::Standard, [0, -10, 0], 0, rows)
    };
    let [level, other] = [[-0.3333, -0.6667], [-0.3333, -0.6666]].map(with);
    assert_smallest(&level, "level");
    assert_smallest(&other, "not level");
    assert!(observed(&level).len() < observed(&other).len());
}

/// Numbers of the program of base parameters are no longer than the engine's may get, and there are not many.
fn assert_short(robot: &Robot) {
    let program = derive(robot, Function::BaseParameters);
    let longest = program
        .constants
        .iter()
        .filter_map(|constant| match constant {
            Constant::Rational(x) => Some(bit_length(x)),
            _ => None,
        });
    let longest = longest.max().unwrap_or(0);
    let count = program.constants.iter().count();
    assert!(
        longest <= MOST_BITS + 1 && count <= 100_000,
        "{longest} bits, {count} constants: {robot:#?}"
    );
}

/// Up to six followers, of one leader or of another follower, by factors of up to six decimals.
fn random_decimals(seed: u64, arms: usize) {
    let mut tables = Tables::new(seed, Bodies::Any);
    let mut coupled = 0;
    for _ in 0..arms {
        let robot = tables.robot_with_decimal_couplings();
        coupled += usize::from(robot.is_coupled());
        assert_smallest(&robot, &format!("{robot:#?}"));
        assert_short(&robot);
    }
    assert!(2 * coupled > arms, "{coupled}");
}

#[test]
fn random_decimal_factors() {
    random_decimals(31, 6);
}

#[test]
#[ignore = "half a minute"]
fn many_random_decimal_factors() {
    random_decimals(32, 200);
}

/// Every operation, and every parameter that is a constant.
#[test]
fn damages_are_found() {
    let zero = Value::zero;
    let mut rows = vec![
        row(
            "first",
            JointType::Revolute,
            [zero(), zero(), zero(), zero()],
        ),
        follows(
            row(
                "second",
                JointType::Revolute,
                [Value::field(0), zero(), zero(), zero()],
            ),
            0,
            Value::field(1),
            arms::decimal(0.3),
        ),
        follows(
            row(
                "third",
                JointType::Prismatic,
                [zero(), right(), zero(), zero()],
            ),
            0,
            arms::decimal(0.05),
            zero(),
        ),
    ];
    rows[1].mass = Value::field(2);
    rows[2].mass = Value::field(3);
    let robot = arm(Convention::Modified, [0, -10, 0], 4, rows);
    let function = Function::BaseParameters;
    let sound = derive(&robot, function);
    let mut proof = Proof::new(&robot, &[function.into()], &sound);
    assert_eq!(proof.holds(&sound), Ok(()));
    assert!(sound.instructions.len() > 10);
    for index in 0..sound.instructions.len() {
        let mut program = sound.clone();
        let one = Operand::Constant(program.constants.push(Constant::Rational(Rational::ONE)));
        let instruction = &mut program.instructions[index];
        *instruction = match *instruction {
            Instruction::Add(a, b) => Instruction::Sub(a, b),
            Instruction::Sub(a, b) => Instruction::Add(a, b),
            Instruction::Mul(a, _) | Instruction::Div(a, _) => Instruction::Add(a, one),
        };
        assert!(proof.holds(&program).is_err(), "operation {index}");
    }
    // The programs of the arm without couplings are others.
    let uncoupled: Program = derive(&robot.uncoupled(), function);
    assert!(proof.holds(&uncoupled).is_err());
    let uncoupled = derive(&robot.uncoupled(), Function::Regressor);
    assert!(prove(&robot, Function::Regressor, &uncoupled).is_err());
}
