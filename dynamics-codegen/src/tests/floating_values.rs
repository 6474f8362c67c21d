//! Quadrupeds on a base that moves, beside the values that Pinocchio has from the same files.

use dynamics_symbolic::Function;
use dynamics_symbolic::derive::derive_plain;
use dynamics_symbolic::function::Part;
use dynamics_symbolic::robot::{Robot, Value};

use super::doubles::{Doubles, assert_near, largest, pose};
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
            jerk: Vec::new(),
        };
        let matrix = state.numbers("M");
        let entry = |i: &usize, j: &usize| matrix[18 * i + j];
        let row = |i: &usize| freedoms.iter().map(|j| entry(i, j)).collect::<Vec<f64>>();
        let matrix: Vec<f64> = freedoms.iter().flat_map(row).collect();
        let forces = largest(&state.numbers("tau")).max(largest(&matrix) * largest(&at.a));
        let accelerations = forward.evaluate(at);
        // As far as M is known, whose condition is about 1e4.
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
