//! Arms in URDF files of a registry, beside the values that Pinocchio has from the same files.

use std::path::Path;

use dynamics_codegen::description::{Name, Place};
use dynamics_codegen::files::{Format, Request};
use dynamics_symbolic::Function;
use dynamics_symbolic::derive::{derive, derive_plain};
use dynamics_symbolic::prove::prove;
use dynamics_symbolic::robot::{Robot, Row, Value};
use interpreter::{Inputs, Rounded};
use serde::Deserialize;

use super::{check, text};

/// The recorded values of an arm.
#[derive(Deserialize)]
pub(super) struct Reference {
    file: String,
    chain: [String; 2],
    ignore: Vec<String>,
    lock: std::collections::BTreeMap<String, f64>,
    joints: Vec<String>,
    states: Vec<State>,
}

#[derive(Deserialize)]
#[allow(non_snake_case, reason = "the names of the quantities")]
struct State {
    q: Vec<f64>,
    qd: Vec<f64>,
    qdd: Vec<f64>,
    M: Vec<Vec<f64>>,
    bias: Vec<f64>,
    tau: Vec<f64>,
    J: Vec<Vec<f64>>,
    pose: Vec<Vec<f64>>,
}

impl Reference {
    fn request(&self) -> Request {
        let name = |name: &String| Name::new(name, Place::File { line: 1, column: 1 });
        Request {
            chain: Some(self.chain.iter().map(name).collect()),
            ignore: self.ignore.iter().map(name).collect(),
            lock: self
                .lock
                .iter()
                .map(|(joint, q)| (name(joint), Value::from_f64(*q)))
                .collect(),
            unphysical_inertia: true,
            ..Request::default()
        }
    }
}

/// The references of the folder, with their names.
pub(super) fn references() -> Vec<(String, Reference)> {
    let folder = format!("{}/../data/urdf", env!("CARGO_MANIFEST_DIR"));
    let entries = std::fs::read_dir(folder).expect("the folder can be read");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    let is_reference = |path: &std::path::PathBuf| path.extension().is_some_and(|e| e == "json");
    let mut references: Vec<_> = paths
        .filter(is_reference)
        .map(|path| {
            let name = path
                .file_stem()
                .expect("a name")
                .to_string_lossy()
                .into_owned();
            let text = std::fs::read_to_string(&path).expect("a reference");
            (name, serde_json::from_str(&text).expect("a reference"))
        })
        .collect();
    references.sort_by(|(a, _), (b, _)| a.cmp(b));
    references
}

/// The largest difference, relative to a scale.
fn error(found: &[f64], expected: &[f64], scale: f64) -> f64 {
    assert_eq!(found.len(), expected.len());
    let differences = found
        .iter()
        .zip(expected)
        .map(|(a, b)| (a - b).abs() / scale);
    differences.fold(0.0, |a, b| if b.is_nan() { b } else { a.max(b) })
}

fn largest<'a>(values: impl IntoIterator<Item = &'a f64>) -> f64 {
    values.into_iter().fold(0.0, |a, b| a.max(b.abs()))
}

/// The robot of the arm's own file: without friction, which Pinocchio's torques leave out, and with gravity.
pub(super) fn robot(name: &str, reference: &Reference) -> Robot {
    let file = text(&format!("urdf/{}", reference.file));
    let mut robot = check(
        name,
        &file,
        Format::of(Path::new(&reference.file)).unwrap(),
        &reference.request(),
    );
    for row in &mut robot.rows {
        row.viscous = Value::zero();
        row.coulomb = [Value::zero(), Value::zero()];
    }
    robot
}

#[test]
fn arms_of_files_move_as_pinocchio_says() {
    let references = references();
    assert!(references.len() >= 20, "{}", references.len());
    let mut worst: f64 = 0.0;
    for (name, reference) in &references {
        let robot = robot(name, reference);
        let joints: Vec<&String> = robot.joints().map(|row| &row.name).collect();
        assert_eq!(
            joints,
            reference.joints.iter().collect::<Vec<_>>(),
            "{name}"
        );
        let program = |function| {
            let program = derive_plain(&robot, function);
            prove(&robot, function, &program).unwrap_or_else(|failure| panic!("{name}: {failure}"));
            program
        };
        let programs = [
            Function::MassMatrix,
            Function::BiasForce,
            Function::InverseDynamics,
            Function::Jacobian,
            Function::ForwardKinematics,
        ]
        .map(program);
        let programs = programs.each_ref().map(Rounded::new);
        for state in &reference.states {
            let inputs = inputs(state);
            let [m, bias, tau, jacobian, pose] = programs
                .each_ref()
                .map(|program| program.run::<f64>(&inputs));
            let mass = largest(state.M.iter().flatten());
            let forces = largest(&state.bias)
                .max(largest(&state.tau))
                .max(mass * largest(&state.qdd));
            let lengths = largest(state.J.iter().flatten()).max(1.0);
            let errors = [
                ("M", error(&m, &state.M.concat(), mass)),
                ("bias", error(&bias, &state.bias, forces)),
                ("tau", error(&tau, &state.tau, forces)),
                ("J", error(&jacobian, &state.J.concat(), lengths)),
                ("pose", error(&pose, &state.pose.concat(), lengths)),
            ];
            for (quantity, error) in errors {
                worst = worst.max(error);
                assert!(
                    error < 1e-12,
                    "{name}: {quantity} is off by {error:e} of its scale"
                );
            }
        }
    }
    println!(
        "{} arms, largest error {worst:e} of scale",
        references.len()
    );
}

/// A row of a file is one of its joints, and a file whose geometry is that of a table gives programs of the same length.
#[test]
fn programs_are_those_of_a_table_where_axes_allow_it() {
    let all = references();
    for (name, reference) in &all {
        let robot = robot(name, reference);
        assert!(robot.rows.iter().all(|row| !row.name.is_empty()), "{name}");
        assert_eq!(robot.rows.len(), robot.dof(), "{name}");
    }
    let (name, reference) = all
        .iter()
        .find(|(name, _)| name == "panda")
        .expect("a reference");
    let panda = robot(name, reference);
    // The published table has the same link frames.
    let mut table = arms::robot("panda");
    for (row, of_file) in table.rows.iter_mut().zip(&panda.rows) {
        let cells = row.clone();
        *row = Row {
            a: cells.a,
            alpha: cells.alpha,
            d: cells.d,
            theta: cells.theta,
            at: Vec::new(),
            mount: None,
            ..of_file.clone()
        };
    }
    let count = |robot: &Robot, function| {
        let operations = derive(robot, function).operations();
        operations.multiplications + operations.additions
    };
    for function in [Function::InverseDynamics, Function::MassMatrix] {
        let (file, table) = (count(&panda, function), count(&table, function));
        println!(
            "{}: {file} operations from the file, {table} from the table",
            function.name()
        );
        assert!(file <= table + table / 50);
    }
}

fn inputs(state: &State) -> Inputs<'_> {
    Inputs {
        fields: &[],
        q: &state.q,
        qd: &state.qd,
        qdd: &state.qdd,
        tau: &[],
        stribeck: &[],
        qd_r: &[],
        qdd_r: &[],
        jerk: &[],
        snap: &[],
        wrench: &[],
    }
}
