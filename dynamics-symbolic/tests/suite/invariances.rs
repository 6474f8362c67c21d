//! Changes of a table whose effect on the equations of motion is known: exactly, in a prime field.
//!
//! Turning the base, reversing an axis, splitting a link in two joined parts, adding a link without
//! mass, scaling all masses. Both arms of a comparison are derived on their own, from random tables.

use arms::{Bodies, Tables};
use dynamics_symbolic::Function;
use dynamics_symbolic::derive::derive;
use dynamics_symbolic::exact::{Rational, Residue, SplitMix64, circle_point};
use dynamics_symbolic::program::Arithmetic;
use dynamics_symbolic::robot::{Convention, JointType, Robot, Row, Symbol, Value};

type Number = Residue<{ (1 << 62) - 57 }>;

/// Tables for each change.
const TABLES: usize = 8;

/// The state of a joint: sine and cosine, position, velocity, acceleration, force, sign of the velocity.
#[derive(Clone, Copy)]
struct Joint([Number; 7]);

impl Joint {
    fn random(random: &mut SplitMix64) -> Self {
        let (s, c) = circle_point(random);
        let [q, qd, qdd, tau, sign] = [(); 5].map(|()| Number::random(random));
        Joint([s, c, q, qd, qdd, tau, sign])
    }

    /// At rest in its zero position.
    fn locked() -> Self {
        let (zero, one) = (Number::ZERO, Number::new(1));
        Joint([zero, one, zero, zero, zero, zero, zero])
    }

    /// Everything counted the other way round.
    fn reversed(self) -> Self {
        let [s, c, q, qd, qdd, tau, sign] = self.0;
        Joint([-s, c, -q, -qd, -qdd, -tau, -sign])
    }
}

/// A point of the prime field.
#[derive(Clone)]
struct Point {
    pi: Number,
    fields: Vec<Number>,
    joints: Vec<Joint>,
}

impl Point {
    fn random(robot: &Robot, seed: u64) -> Self {
        let mut random = SplitMix64::new(seed);
        Point {
            pi: Number::random(&mut random),
            fields: (0..8).map(|_| Number::random(&mut random)).collect(),
            joints: robot
                .rows
                .iter()
                .map(|_| Joint::random(&mut random))
                .collect(),
        }
    }

    /// Sine and cosine of an angle, however it is written: the angle seeds a point of the circle.
    fn circle(&self, angle: &Value) -> (Number, Number) {
        let angle = self.cell(angle);
        let (is_opposite, seed) = match (angle.get(), (-angle).get()) {
            (a, b) if a <= b => (false, a),
            (_, b) => (true, b),
        };
        let (s, c) = circle_point(&mut SplitMix64::new(seed));
        (if is_opposite { -s } else { s }, c)
    }

    fn cell(&self, value: &Value) -> Number {
        match value {
            Value::Rational(x) => Number::from_rational(x).expect("it has an image"),
            Value::Pi => self.pi,
            Value::Field(i) => self.fields[*i],
            Value::Neg(a) => -self.cell(a),
            Value::Add(a, b) => self.cell(a) + self.cell(b),
            Value::Mul(a, b) => self.cell(a) * self.cell(b),
            Value::Div(a, b) => {
                let divisor = self.cell(b).inverse();
                self.cell(a) * divisor.expect("no zero divides")
            }
        }
    }

    /// The values of a function of the arm here.
    fn value(&self, robot: &Robot, function: Function) -> Vec<Number> {
        let values = derive(robot, function).evaluate(&mut self.clone());
        values
            .into_iter()
            .map(|x| x.expect("no zero divides"))
            .collect()
    }
}

impl Arithmetic for Point {
    type Number = Option<Number>;

    fn rational(&mut self, x: &Rational) -> Option<Number> {
        Number::from_rational(x)
    }

    fn symbol(&mut self, symbol: &Symbol) -> Option<Number> {
        let joint = |i: &usize, k: usize| self.joints[*i].0[k];
        Some(match symbol {
            Symbol::Pi => self.pi,
            Symbol::Field(i) => self.fields[*i],
            Symbol::AngleSine(angle) => self.circle(angle).0,
            Symbol::AngleCosine(angle) => self.circle(angle).1,
            Symbol::Sine(i) => joint(i, 0),
            Symbol::Cosine(i) => joint(i, 1),
            Symbol::Position(i) => joint(i, 2),
            Symbol::Velocity(i) => joint(i, 3),
            Symbol::Acceleration(i) => joint(i, 4),
            Symbol::Force(i) => joint(i, 5),
            Symbol::VelocitySign(i) => joint(i, 6),
            Symbol::Stribeck(_) => panic!("no arm in here has friction that falls"),
            Symbol::Entry(argument, i) => {
                Number::random(&mut SplitMix64::new(((*argument as u64) << 16) + *i as u64))
            }
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

/// M, V, G and tau: what every change says something about.
const FUNCTIONS: [Function; 4] = [
    Function::MassMatrix,
    Function::CoriolisVector,
    Function::GravityVector,
    Function::InverseDynamics,
];

/// Random arms of at least `dof` joints, each with a point.
fn arms(seed: u64, dof: usize) -> impl Iterator<Item = (Robot, Point, Tables)> {
    let mut tables = Tables::new(seed, Bodies::Any);
    let next = move || {
        let robot = tables.robot();
        let point = Point::random(&robot, tables.below(1 << 40));
        (
            robot,
            point,
            Tables::new(tables.below(1 << 40), Bodies::Any),
        )
    };
    std::iter::repeat_with(next)
        .filter(move |(robot, _, _)| robot.rows.len() >= dof)
        .take(TABLES)
}

/// Whole quarter turns of gravity about z or x, as often as `turns` says.
fn turned(gravity: &[Value; 3], about: usize, turns: u64) -> [Value; 3] {
    let mut gravity = gravity.clone();
    let (u, v) = ((about + 1) % 3, (about + 2) % 3);
    for _ in 0..turns {
        let [a, b] = [gravity[u].clone(), gravity[v].clone()];
        (gravity[u], gravity[v]) = (-b, a);
    }
    gravity
}

fn quarter_turns(turns: u64) -> Value {
    Value::Pi * Value::Rational(Rational::from_parts((turns as i64).into(), 2_u32.into()))
}

/// Base and gravity turned together, about the axis that the first row starts with: nothing changes.
#[test]
fn turning_the_base_changes_nothing() {
    for (robot, point, mut tables) in arms(1, 1) {
        let turns = 1 + tables.below(3);
        let mut turned_arm = robot.clone();
        let row = &mut turned_arm.rows[0];
        let (angle, about) = match robot.convention {
            Convention::Standard => (&mut row.theta, 2),
            Convention::Modified => (&mut row.alpha, 0),
        };
        *angle = angle.clone() + quarter_turns(turns);
        turned_arm.gravity = turned(&robot.gravity, about, turns);
        for function in FUNCTIONS {
            let expected = point.value(&robot, function);
            let found = point.value(&turned_arm, function);
            assert_eq!(found, expected, "{function:?} of {robot:#?}");
        }
    }
}

/// A body in a frame turned by half a turn about x.
fn upside_down(row: &mut Row) {
    for entry in row.com[1..].iter_mut() {
        *entry = -entry.clone();
    }
    // xy and xz
    for k in [3, 5] {
        row.inertia[k] = -row.inertia[k].clone();
    }
}

/// The axis of joint `i` reversed: `T Rx(pi)`, and `Rx(-pi)` in front of what follows.
fn reversed(robot: &Robot, i: usize) -> Robot {
    let mut arm = robot.clone();
    let row = &mut arm.rows[i];
    row.theta = -row.theta.clone();
    row.d = -row.d.clone();
    match robot.convention {
        Convention::Modified => {
            upside_down(row);
            row.alpha = row.alpha.clone() + Value::Pi;
            if let Some(next) = arm.rows.get_mut(i + 1) {
                next.alpha = next.alpha.clone() - Value::Pi;
            }
        }
        Convention::Standard => {
            row.alpha = row.alpha.clone() - Value::Pi;
            let before = &mut arm.rows[i - 1];
            upside_down(before);
            before.alpha = before.alpha.clone() + Value::Pi;
        }
    }
    arm
}

/// A joint counted the other way round: its torque changes its sign, and its row and column of M.
#[test]
fn reversing_an_axis_changes_signs() {
    for (robot, point, mut tables) in arms(2, 2) {
        let n = robot.rows.len();
        let i = 1 + tables.below(n as u64 - 1) as usize;
        let arm = reversed(&robot, i);
        let mut reversed_point = point.clone();
        reversed_point.joints[i] = point.joints[i].reversed();
        for function in FUNCTIONS {
            let mut expected = point.value(&robot, function);
            for (k, x) in expected.iter_mut().enumerate() {
                let is_reversed = match function {
                    Function::MassMatrix => (k / n == i) != (k % n == i),
                    _ => k == i,
                };
                if is_reversed {
                    *x = -*x;
                }
            }
            let found = reversed_point.value(&arm, function);
            assert_eq!(found, expected, "{function:?}, joint {i} of {robot:#?}");
        }
    }
}

/// The joint that a table's row has one more of, by turns.
fn extra(tables: &mut Tables) -> JointType {
    match tables.below(2) {
        0 => JointType::Revolute,
        _ => JointType::Prismatic,
    }
}

/// Entries of a function of n + 1 joints that do not belong to joint `i`, and those that do.
fn without<T: Copy>(values: &[T], function: Function, n: usize, i: usize) -> (Vec<T>, Vec<T>) {
    let belongs = |k: usize| match function {
        Function::MassMatrix => k / (n + 1) == i || k % (n + 1) == i,
        _ => k == i,
    };
    let pick = |own: bool| {
        let chosen = values
            .iter()
            .enumerate()
            .filter(|(k, _)| belongs(*k) == own);
        chosen.map(|(_, x)| *x).collect()
    };
    (pick(false), pick(true))
}

/// A link without mass at the tip, moving: the other joints do not feel it, and it feels nothing.
#[test]
fn a_massless_link_at_the_tip_changes_nothing() {
    for (robot, mut point, mut tables) in arms(3, 1) {
        let n = robot.rows.len();
        let mut arm = robot.clone();
        let mut row = Row::new("extra", extra(&mut tables));
        (row.a, row.alpha, row.d) = (tables.number(), tables.number(), tables.number());
        arm.rows.push(row);
        let mut random = SplitMix64::new(tables.below(1 << 40));
        point.joints.push(Joint::random(&mut random));
        for function in FUNCTIONS {
            let expected = point.value(&robot, function);
            let found = point.value(&arm, function);
            let (others, own) = without(&found, function, n, n);
            assert_eq!(others, expected, "{function:?} of {robot:#?}");
            assert!(
                own.iter().all(|x| x.is_zero()),
                "{function:?} of {robot:#?}"
            );
        }
    }
}

/// A body of numbers: mass, centre of mass, tensor.
type Body = (Rational, [Rational; 3], [Rational; 6]);

fn body(tables: &mut Tables) -> Body {
    let mut number = || match tables.number() {
        Value::Rational(x) => x,
        other => panic!("{other:?}"),
    };
    // Masses of which no two add up to zero.
    let mass = Rational::from(5) + number();
    (mass, [(); 3].map(|()| number()), [(); 6].map(|()| number()))
}

/// Two bodies joined: m = m1 + m2, m c = m1 c1 + m2 c2, and the tensors about c by the theorem of
/// parallel axes, which adds m1 m2 / m (|r|^2 1 - r r^T) with r = c1 - c2.
fn joined((m1, c1, j1): &Body, (m2, c2, j2): &Body) -> Body {
    let m = m1 + m2;
    let c = [0, 1, 2].map(|k| (m1 * &c1[k] + m2 * &c2[k]) / &m);
    let reduced = m1 * m2 / &m;
    let r = [0, 1, 2].map(|k| &c1[k] - &c2[k]);
    let square = &r[0] * &r[0] + &r[1] * &r[1] + &r[2] * &r[2];
    let pairs = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2)];
    let entry = |k: usize| {
        let (u, v) = pairs[k];
        let diagonal = if u == v {
            square.clone()
        } else {
            Rational::ZERO
        };
        &j1[k] + &j2[k] + &reduced * (diagonal - &r[u] * &r[v])
    };
    (m, c, [0, 1, 2, 3, 4, 5].map(entry))
}

fn carry(row: &mut Row, (mass, com, inertia): Body) {
    row.mass = Value::Rational(mass);
    row.com = com.map(Value::Rational);
    row.inertia = inertia.map(Value::Rational);
}

/// A link of two parts, the second behind a joint that does not move: the other joints feel one link.
#[test]
fn splitting_a_link_changes_nothing() {
    for (mut robot, mut point, mut tables) in arms(4, 1) {
        let n = robot.rows.len();
        let i = tables.below(n as u64) as usize;
        let parts = [body(&mut tables), body(&mut tables)];
        let mut split = robot.clone();
        carry(&mut robot.rows[i], joined(&parts[0], &parts[1]));
        let [first, second] = parts;
        carry(&mut split.rows[i], first);
        let mut row = Row::new("extra", extra(&mut tables));
        carry(&mut row, second);
        split.rows.insert(i + 1, row);
        let whole = point.clone();
        point.joints.insert(i + 1, Joint::locked());
        for function in FUNCTIONS {
            let expected = whole.value(&robot, function);
            let found = point.value(&split, function);
            let (others, _) = without(&found, function, n, i + 1);
            assert_eq!(others, expected, "{function:?}, link {i} of {robot:#?}");
        }
    }
}

/// All masses, tensors, motors and frictions times 7/3: so are M, V, G and tau, and forces times 7/3
/// accelerate the arm as before.
#[test]
fn scaling_all_masses_scales_all_forces() {
    let factor = Rational::from_parts(7.into(), 3_u32.into());
    let in_field = Number::from_rational(&factor).expect("it has an image");
    for (robot, point, _) in arms(5, 1) {
        let mut heavy = robot.clone();
        for row in &mut heavy.rows {
            let inertia = row.inertia.iter_mut();
            let others = [&mut row.mass, &mut row.motor_inertia, &mut row.viscous];
            for cell in inertia.chain(others).chain(&mut row.coulomb) {
                *cell = cell.clone() * Value::Rational(factor.clone());
            }
        }
        for function in FUNCTIONS {
            let expected = point.value(&robot, function);
            let found = point.value(&heavy, function);
            let scaled: Vec<_> = expected.iter().map(|x| *x * in_field).collect();
            assert_eq!(found, scaled, "{function:?} of {robot:#?}");
        }
        let mut pushed = point.clone();
        for joint in &mut pushed.joints {
            joint.0[5] = joint.0[5] * in_field;
        }
        let n = robot.rows.len();
        let qdd = |robot: &Robot, point: &Point| {
            let values = derive(robot, Function::ForwardDynamics).evaluate(&mut point.clone());
            values[..n].to_vec()
        };
        assert_eq!(qdd(&heavy, &pushed), qdd(&robot, &point), "{robot:#?}");
    }
}
