//! Quadrupeds on a base that moves, beside the values that Pinocchio has from the same files.

use dynamics_symbolic::Function;
use dynamics_symbolic::derive::derive_plain;
use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::function::{Argument, Part};
use dynamics_symbolic::program::Arithmetic;
use dynamics_symbolic::robot::{Robot, Symbol, Value};

use super::floating::{file, robot_of};
use super::*;
use crate::files::{Format, json};
use crate::tree::{Kind, Node};

/// A state, in the order of Pinocchio's joints.
struct State<'n>(&'n Node);

impl State<'_> {
    fn numbers(&self, key: &str) -> Vec<f64> {
        let mut numbers = Vec::new();
        collect(get(self.0, key), &mut numbers);
        numbers
    }
}

fn get<'n>(node: &'n Node, key: &str) -> &'n Node {
    let Kind::Table(items) = &node.kind else {
        panic!("a table with `{key}`");
    };
    let item = items.iter().find(|(found, _)| found.word == key);
    &item.unwrap_or_else(|| panic!("no `{key}`")).1
}

fn list(node: &Node) -> &[Node] {
    match &node.kind {
        Kind::List(items) => items,
        _ => panic!("a list"),
    }
}

/// All numbers in lists.
fn collect(node: &Node, to: &mut Vec<f64>) {
    match &node.kind {
        Kind::Number(number) => to.push(number.parse().expect("a number")),
        Kind::List(items) => items.iter().for_each(|item| collect(item, to)),
        _ => panic!("numbers"),
    }
}

/// Doubles at a state.
#[derive(Clone)]
struct Doubles {
    /// By rows, then the position.
    base: [f64; 12],
    q: Vec<f64>,
    v: Vec<f64>,
    a: Vec<f64>,
    tau: Vec<f64>,
}

impl Doubles {
    /// The state displaced by a degree of freedom: of the base by R d, and turned by R exp(phi).
    fn displaced(&self, freedom: usize, by: f64) -> Doubles {
        let mut other = self.clone();
        let axis = freedom % 3;
        let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
        for row in 0..3 {
            let at = |column: usize| self.base[3 * row + column];
            if freedom < 3 {
                other.base[9 + row] += at(axis) * by;
            } else if freedom < 6 {
                other.base[3 * row + j] = at(j) * by.cos() + at(k) * by.sin();
                other.base[3 * row + k] = at(k) * by.cos() - at(j) * by.sin();
            }
        }
        if freedom >= 6 {
            other.q[freedom - 6] += by;
        }
        other
    }
}

impl Arithmetic for Doubles {
    type Number = f64;

    fn rational(&mut self, x: &Rational) -> f64 {
        x.to_f64().value()
    }

    fn symbol(&mut self, symbol: &Symbol) -> f64 {
        match symbol {
            Symbol::Pi => core::f64::consts::PI,
            Symbol::AngleSine(angle) => angle.to_f64(&[]).sin(),
            Symbol::AngleCosine(angle) => angle.to_f64(&[]).cos(),
            Symbol::Sine(i) => self.q[i - 6].sin(),
            Symbol::Cosine(i) => self.q[i - 6].cos(),
            Symbol::Velocity(i) => self.v[*i],
            Symbol::Acceleration(i) => self.a[*i],
            Symbol::Force(i) => self.tau[*i],
            Symbol::Entry(Argument::Base, k) => self.base[*k],
            other => panic!("{other:?}"),
        }
    }

    fn neg(&mut self, a: f64) -> f64 {
        -a
    }

    fn add(&mut self, a: f64, b: f64) -> f64 {
        a + b
    }

    fn mul(&mut self, a: f64, b: f64) -> f64 {
        a * b
    }

    fn div(&mut self, a: f64, b: f64) -> f64 {
        a / b
    }
}

/// The rotation of a unit quaternion x, y, z, w by rows, and the position in front of it.
fn pose(q: &[f64]) -> [f64; 12] {
    let [px, py, pz, x, y, z, w] = q[..7].try_into().expect("a pose");
    let entry = |one: f64, other: f64| 2.0 * (one + other);
    [
        1.0 - entry(y * y, z * z),
        entry(x * y, -z * w),
        entry(x * z, y * w),
        entry(x * y, z * w),
        1.0 - entry(x * x, z * z),
        entry(y * z, -x * w),
        entry(x * z, -y * w),
        entry(y * z, x * w),
        1.0 - entry(x * x, y * y),
        px,
        py,
        pz,
    ]
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |largest, x| largest.max(x.abs()))
}

#[track_caller]
fn assert_near(what: &str, found: &[f64], expected: &[f64], scale: f64) {
    assert_eq!(found.len(), expected.len(), "{what}");
    for (found, expected) in found.iter().zip(expected) {
        let error = (found - expected).abs();
        assert!(error <= 1e-13 * scale, "{what}: {found} beside {expected}");
    }
}

/// The robot without friction, which Pinocchio's forces are without, and the frames of these links.
fn robot(name: &str, links: &[&str]) -> Robot {
    let poses = links
        .iter()
        .map(|link| format!("forward_kinematics(\"{link}\")"));
    let poses = poses.collect::<Vec<_>>().join(", ");
    let beside = format!(
        "base: floating, gravity: [0, 0, -9.81], allow: [unphysical_inertia],
         functions: [inverse_dynamics, {poses}],"
    );
    let text = file(&format!("{name}.urdf"));
    let mut robot = robot_of(&text, Format::Urdf, &beside);
    for row in &mut robot.rows {
        row.viscous = Value::zero();
        row.coulomb = [0, 0].map(Value::integer);
        row.stribeck = None;
    }
    robot
}

/// The programs, and what Pinocchio calls their values.
const FUNCTIONS: [(Function, &str); 6] = [
    (Function::MassMatrix, "M"),
    (Function::InverseDynamics, "tau"),
    (Function::BiasForce, "nle"),
    (Function::GravityVector, "g"),
    (Function::KineticEnergy, "kinetic_energy"),
    (Function::CenterOfMass, "com"),
];

fn compare(name: &str) {
    let diagnostics = Diagnostics::new();
    // The reader of robots keeps the keys that it knows.
    let text = format!("{{ \"let\": {} }}", file(&format!("{name}_free.json")));
    let root = json::document(&text, &diagnostics).expect("JSON");
    let root = get(&root, "let");
    let states = list(get(root, "states"));
    let Kind::Table(poses) = &get(&states[0], "leaf_poses").kind else {
        panic!("poses");
    };
    let links: Vec<&str> = poses.iter().map(|(key, _)| key.word.as_str()).collect();
    let robot = robot(name, &links);
    // Pinocchio sorts the children of a link by the names of their joints; the first of its joints is the base.
    let names: Vec<_> = list(get(root, "joints")).iter().map(Node::word).collect();
    let place = |row: &str| {
        names
            .iter()
            .position(|name| *name == Some(row))
            .expect("a joint")
            - 1
    };
    let order: Vec<usize> = robot.joints().map(|row| place(&row.name)).collect();
    let freedoms: Vec<usize> = (0..6).chain(order.iter().map(|joint| 6 + joint)).collect();
    let programs = FUNCTIONS.map(|(function, key)| (derive_plain(&robot, function), key));
    let [potential, forward] = [Function::PotentialEnergy, Function::ForwardDynamics]
        .map(|function| derive_plain(&robot, function));
    for state in states.iter().map(State) {
        let ordered = |key: &str| {
            let values = state.numbers(key);
            freedoms.iter().map(|i| values[*i]).collect::<Vec<f64>>()
        };
        let q = state.numbers("q");
        let at = &mut Doubles {
            base: pose(&q),
            q: order.iter().map(|joint| q[7 + joint]).collect(),
            v: ordered("v"),
            a: ordered("a"),
            tau: ordered("tau"),
        };
        let matrix = state.numbers("M");
        let entry = |i: &usize, j: &usize| matrix[18 * i + j];
        let row = |i: &usize| freedoms.iter().map(|j| entry(i, j)).collect::<Vec<f64>>();
        let matrix: Vec<f64> = freedoms.iter().flat_map(row).collect();
        let forces = largest(&state.numbers("tau")).max(largest(&matrix) * largest(&at.a));
        let accelerations = forward.evaluate(at);
        // As far as M is known, whose condition is some 1e4.
        assert_near("a", &accelerations[..18], &at.a, 1e3 * largest(&at.a));
        for (program, key) in &programs {
            let (expected, scale) = match *key {
                "M" => (matrix.clone(), largest(&matrix)),
                "kinetic_energy" => (state.numbers(key), state.numbers(key)[0]),
                "com" => (state.numbers(key), 1.0),
                _ => (ordered(key), forces),
            };
            assert_near(key, &program.evaluate(at), &expected, scale);
        }
        let mass = matrix[0];
        let weight = 9.81 * mass;
        let energy = weight * state.numbers("com")[2];
        assert_near("U", &potential.evaluate(at), &[energy], weight);
        for (frame, link) in links.iter().enumerate() {
            assert_eq!(robot.frames[frame].name, *link);
            let function = Function::ForwardKinematics;
            let part = Part {
                function,
                frame: Some(frame),
            };
            let mut expected = Vec::new();
            collect(get(get(state.0, "leaf_poses"), link), &mut expected);
            let found = derive_plain(&robot, part).evaluate(at);
            assert_near(link, &found, &expected, 1.0);
        }
    }
}

#[test]
fn quadrupeds_have_the_values_of_pinocchio() {
    for name in ["hyq_no_sensors", "anymal_erd"] {
        compare(name);
    }
}

/// Entry (i, k): the derivative of value i along freedom k, by central differences.
fn differences(count: usize, values: impl Fn(usize, f64) -> Vec<f64>) -> Vec<f64> {
    const STEP: f64 = 1e-5;
    let columns = (0..count).map(|k| (values(k, STEP), values(k, -STEP)));
    let columns = columns.map(|(up, down)| {
        up.iter()
            .zip(down)
            .map(|(u, d)| (u - d) / (2.0 * STEP))
            .collect()
    });
    let columns: Vec<Vec<f64>> = columns.collect();
    (0..columns[0].len())
        .flat_map(|i| {
            columns
                .iter()
                .map(move |column| column[i])
                .collect::<Vec<_>>()
        })
        .collect()
}

/// Derivatives are by displacements in the axes of the base, Jacobians and accelerations too.
#[test]
fn derivatives_are_those_of_displacements() {
    let robot = robot("hyq_no_sensors", &["lf_foot"]);
    let some = |i: usize| ((i * i + 3) as f64).sin();
    let at = Doubles {
        base: pose(&[0.3, -0.2, 0.5, 0.1, -0.5, 0.7, 0.5]),
        q: (0..12).map(some).collect(),
        v: (20..38).map(some).collect(),
        a: (40..58).map(some).collect(),
        tau: (60..78).map(some).collect(),
    };
    let of = |part: Part| {
        let program = derive_plain(&robot, part);
        move |at: &Doubles| program.evaluate(&mut at.clone())
    };
    let function = |function: Function| of(function.into());
    let at_foot = |function: Function| {
        of(Part {
            function,
            frame: Some(0),
        })
    };
    // Central differences lose seven digits or less.
    let near = |what: &str, found: &[f64], expected: &[f64]| {
        assert_near(what, found, expected, 1e6 * largest(expected));
    };
    // Forces.
    let torques = function(Function::InverseDynamics);
    let along = |k: usize, h: f64| torques(&at.displaced(k, h));
    let with = |k: usize, h: f64| {
        let mut other = at.clone();
        other.v[k] += h;
        torques(&other)
    };
    let derivatives = function(Function::InverseDynamicsDerivatives)(&at);
    near("d tau", &derivatives[..324], &differences(18, along));
    near("d tau/dv", &derivatives[324..], &differences(18, with));
    // The centre of mass, and the place of a foot.
    let center = function(Function::CenterOfMass);
    let jacobian = function(Function::CenterOfMassJacobian)(&at);
    near(
        "d com",
        &jacobian,
        &differences(18, |k, h| center(&at.displaced(k, h))),
    );
    let foot = at_foot(Function::ForwardKinematics);
    let origin = |k: usize, h: f64| {
        let pose = foot(&at.displaced(k, h));
        [3, 7, 11].map(|i| pose[i]).to_vec()
    };
    let jacobian = at_foot(Function::Jacobian)(&at);
    near("J", &jacobian[..54], &differences(18, origin));
    // Along the motion: dJ/dt, J a + dJ/dt v, and dM/dt, of which 2 C is a part that is skew.
    let later = |h: f64| {
        let step = |at: Doubles, k: usize| at.displaced(k, h * at.v[k]);
        (0..18).fold(at.clone(), step)
    };
    let along = |values: &dyn Fn(&Doubles) -> Vec<f64>| differences(1, |_, h| values(&later(h)));
    let rate = at_foot(Function::JacobianRate)(&at);
    near("dJ/dt", &rate, &along(&at_foot(Function::Jacobian)));
    let applied = |matrix: &[f64], v: &[f64]| -> Vec<f64> {
        let rows = matrix.chunks(v.len());
        rows.map(|row| row.iter().zip(v).map(|(m, v)| m * v).sum())
            .collect()
    };
    let sum = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a + b).collect::<Vec<f64>>();
    let expected = sum(&applied(&jacobian, &at.a), &applied(&rate, &at.v));
    let found = at_foot(Function::ToolAcceleration)(&at);
    assert_near(
        "a of the foot",
        &found,
        &expected,
        10.0 * largest(&expected),
    );
    let coriolis = function(Function::CoriolisMatrix)(&at);
    let expected = function(Function::CoriolisVector)(&at);
    assert_near(
        "C v",
        &applied(&coriolis, &at.v),
        &expected,
        10.0 * largest(&expected),
    );
    let transposed = (0..324).map(|i| coriolis[18 * (i % 18) + i / 18]);
    let both = sum(&coriolis, &transposed.collect::<Vec<_>>());
    near("C + C'", &both, &along(&function(Function::MassMatrix)));
}
