//! Robots with branches in URDF files, read whole, beside the values that Pinocchio has from the same files.

use std::collections::BTreeMap;

use std::path::Path;

use dynamics_evaluation::{ReadOptions, RuntimeRobot, Value};
use robot_dynamics::check::Check;
use robot_dynamics::{check_against_rnea, robot_dynamics};
use serde::Deserialize;

use super::text;

/// Values of a robot, as Pinocchio computes them from its file.
#[derive(Deserialize)]
pub(crate) struct Reference {
    pub(crate) joints: Vec<String>,
    pub(crate) states: Vec<State>,
}

#[derive(Deserialize)]
#[allow(non_snake_case, reason = "the names of the quantities")]
pub(crate) struct State {
    pub(crate) q: Vec<f64>,
    pub(crate) v: Vec<f64>,
    pub(crate) a: Vec<f64>,
    pub(crate) tau: Vec<f64>,
    pub(crate) M: Vec<Vec<f64>>,
    pub(crate) nle: Vec<f64>,
    pub(crate) g: Vec<f64>,
    pub(crate) kinetic_energy: f64,
    /// Centre of mass of the links that move.
    pub(crate) com: Vec<f64>,
    /// Transforms of links, by rows.
    pub(crate) leaf_poses: BTreeMap<String, Vec<Vec<f64>>>,
}

impl State {
    /// The same for joints in another order: Pinocchio sorts the children of a link by the names of their joints.
    fn in_order(&self, order: &[usize]) -> Self {
        let of = |values: &[f64]| -> Vec<f64> { order.iter().map(|i| values[*i]).collect() };
        State {
            q: of(&self.q),
            v: of(&self.v),
            a: of(&self.a),
            tau: of(&self.tau),
            M: order.iter().map(|row| of(&self.M[*row])).collect(),
            nle: of(&self.nle),
            g: of(&self.g),
            kinetic_energy: self.kinetic_energy,
            com: self.com.clone(),
            leaf_poses: self.leaf_poses.clone(),
        }
    }
}

pub(crate) fn reference(name: &str) -> Reference {
    let text = text(&format!("urdf/trees/{name}.json"));
    serde_json::from_str(&text).expect("a reference")
}

pub(crate) fn file(name: &str) -> String {
    format!(
        "{}/../data/urdf/trees/{name}.urdf",
        env!("CARGO_MANIFEST_DIR")
    )
}

/// The robot of a whole file, with its functions and the poses of some links.
pub(crate) fn robot(path: impl AsRef<Path>, links: &[&str]) -> RuntimeRobot {
    let poses = links
        .iter()
        .map(|link| format!("forward_kinematics(\"{link}\")"));
    let functions = [
        "mass_matrix",
        "bias_force",
        "gravity_vector",
        "inverse_dynamics",
        "friction_vector",
        "kinetic_energy",
        "center_of_mass",
        "forward_dynamics",
    ];
    let functions = functions.map(String::from).into_iter().chain(poses);
    let options = ReadOptions::new()
        .functions(functions)
        .entries("gravity = [0, 0, -9.81]\nallow = [\"unphysical_inertia\"]");
    RuntimeRobot::from_file(path, &options).unwrap_or_else(|error| panic!("{error}"))
}

/// The largest difference, relative to a scale.
#[track_caller]
pub(crate) fn assert_near(what: &str, found: &[f64], expected: &[f64], scale: f64) {
    assert_eq!(found.len(), expected.len(), "{what}");
    for (found, expected) in found.iter().zip(expected) {
        let error = (found - expected).abs();
        assert!(error <= 1e-14 * scale, "{what}: {found} beside {expected}");
    }
}

pub(crate) fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |largest, x| largest.max(x.abs()))
}

/// The numbers of a function, matrices by columns.
#[track_caller]
fn value(robot: &RuntimeRobot, function: &str, arguments: &[&[f64]]) -> Vec<f64> {
    match robot.evaluate(function, arguments) {
        Ok(Value::Number(x)) => vec![x],
        Ok(Value::Matrix(matrix)) => matrix.as_slice().to_vec(),
        other => panic!("{function}: {other:?}"),
    }
}

/// Compares the robot of a file with the values of a reference.
fn compare(path: impl AsRef<Path>, reference: &Reference) {
    let links: Vec<&str> = reference.states[0]
        .leaf_poses
        .keys()
        .map(String::as_str)
        .collect();
    let robot = robot(path, &links);
    let place = |name: &str| reference.joints.iter().position(|joint| joint == name);
    let order: Option<Vec<usize>> = robot.joint_names().map(place).collect();
    let order = order.expect("the joints of the reference");
    assert_eq!(order.len(), reference.joints.len());
    for state in reference.states.iter().map(|state| state.in_order(&order)) {
        let State {
            q, v, a, M: matrix, ..
        } = &state;
        let value = |function: &str, arguments: &[&[f64]]| value(&robot, function, arguments);
        // Symmetric, so that rows are columns.
        let matrix = matrix.concat();
        let forces = largest(&state.tau)
            .max(largest(&state.nle))
            .max(largest(&matrix) * largest(a));
        assert_near("M", &value("mass_matrix", &[q]), &matrix, largest(&matrix));
        // Pinocchio's forces are without friction.
        let friction = value("friction_vector", &[v]);
        let forces = forces.max(largest(&friction));
        let without_friction = |function: &str, arguments: &[&[f64]]| -> Vec<f64> {
            let found = value(function, arguments);
            found
                .iter()
                .zip(&friction)
                .map(|(x, friction)| x - friction)
                .collect()
        };
        assert_near(
            "bias",
            &without_friction("bias_force", &[q, v]),
            &state.nle,
            forces,
        );
        assert_near("G", &value("gravity_vector", &[q]), &state.g, forces);
        let tau = without_friction("inverse_dynamics", &[q, v, a]);
        assert_near("tau", &tau, &state.tau, forces);
        assert_near(
            "T",
            &value("kinetic_energy", &[q, v]),
            &[state.kinetic_energy],
            state.kinetic_energy,
        );
        assert_near(
            "centre of mass",
            &value("center_of_mass", &[q]),
            &state.com,
            1.0,
        );
        for (link, pose) in &state.leaf_poses {
            let columns: Vec<f64> = (0..16).map(|k| pose[k % 4][k / 4]).collect();
            let function = format!("forward_kinematics_{}", link.to_lowercase());
            assert_near(link, &value(&function, &[q]), &columns, 1.0);
        }
    }
    let report = Check::new().samples(24).run_any(&robot);
    assert!(report.is_ok(), "{report}");
}

#[test]
fn legs_on_a_fixed_trunk_move_as_pinocchio_says() {
    for name in ["hyq_no_sensors", "anymal_erd"] {
        compare(file(name), &reference(name));
    }
}

/// `chain` with two tips is the part of the tree that leads to these: on a trunk that stands, the legs move as before.
#[test]
fn a_chain_of_two_tips_is_a_part_of_the_tree() {
    let whole = robot(file("hyq_no_sensors"), &[]);
    let options = ReadOptions::new()
        .chain(["trunk", "lf_foot", "rh_foot"])
        .ignore(["rest"])
        .functions([
            "mass_matrix",
            "inverse_dynamics",
            "forward_kinematics(rh_foot)",
        ])
        .entries("gravity = [0, 0, -9.81]\nallow = [\"unphysical_inertia\"]\n");
    let part = RuntimeRobot::from_file(file("hyq_no_sensors"), &options);
    let part = part.unwrap_or_else(|error| panic!("{error}"));
    let place = |name: &str| whole.joint_names().position(|joint| joint == name);
    let places: Option<Vec<usize>> = part.joint_names().map(place).collect();
    let places = places.expect("joints of the whole tree");
    assert_eq!(part.dof(), 6);
    for state in reference("hyq_no_sensors").states {
        let [q, v, a] = [&state.q, &state.v, &state.a];
        let of_part = |x: &[f64]| -> Vec<f64> { places.iter().map(|i| x[*i]).collect() };
        let tau = value(&whole, "inverse_dynamics", &[q, v, a]);
        let found = value(
            &part,
            "inverse_dynamics",
            &[&of_part(q), &of_part(v), &of_part(a)],
        );
        assert_near("tau", &found, &of_part(&tau), largest(&tau));
        let matrix = value(&whole, "mass_matrix", &[q]);
        let entries = places
            .iter()
            .flat_map(|i| of_part(&matrix[12 * i..12 * i + 12]));
        let entries: Vec<f64> = entries.collect();
        let found = value(&part, "mass_matrix", &[&of_part(q)]);
        assert_near("M", &found, &entries, largest(&matrix));
    }
}

/// One finger follows the other one, which stands on another branch; without `<mimic>` both move by themselves.
#[test]
fn an_arm_with_two_fingers_moves_as_pinocchio_says() {
    compare(file("panda_erd"), &reference("panda_erd_mimic"));
    compare(file("panda_free"), &reference("panda_erd"));
}

/// Entries of M for joints on different legs are no part of the program.
#[test]
fn legs_know_nothing_of_each_other() {
    let robot = robot(file("hyq_no_sensors"), &[]);
    let q: Vec<f64> = (0..12).map(|i| 0.3 + 0.1 * f64::from(i)).collect();
    let matrix = value(&robot, "mass_matrix", &[&q]);
    let upper = (0..12).flat_map(|row| (row..12).map(move |column| 12 * column + row));
    let of_legs = upper.clone().filter(|entry| matrix[*entry] != 0.0);
    assert_eq!((of_legs.count(), upper.count()), (24, 78));
}

robot_dynamics! {
    /// An arm with a gripper, both fingers on one motor.
    struct Gripper;
    file: "../data/urdf/trees/panda_erd.urdf",
    gravity: [0, 0, -9.81],
    frames: { grip: { on: panda_hand, xyz: [0, 0, 0.1034] } },
    functions: [default, jacobian(grip), forward_kinematics(panda_leftfinger), forward_kinematics(panda_rightfinger)],
}

#[test]
fn a_compiled_gripper_moves_as_its_file_says() {
    check_against_rnea(&Gripper).assert_ok();
    let reference = reference("panda_erd_mimic");
    assert_eq!(Gripper::JOINT_NAMES.to_vec(), reference.joints);
    for state in &reference.states {
        let [q, v, a] = [&state.q, &state.v, &state.a]
            .map(|x| robot_dynamics::nalgebra::SVector::from_column_slice(x));
        let tau = Gripper.inverse_dynamics(&q, &v, &a) - Gripper.friction_vector(&v);
        assert_near("tau", tau.as_slice(), &state.tau, largest(&state.tau));
        let fingers = [
            (
                "panda_leftfinger",
                Gripper.forward_kinematics_panda_leftfinger(&q),
            ),
            (
                "panda_rightfinger",
                Gripper.forward_kinematics_panda_rightfinger(&q),
            ),
        ];
        for (link, pose) in fingers {
            let expected = &state.leaf_poses[link];
            assert_near(link, pose.transpose().as_slice(), &expected.concat(), 1.0);
        }
    }
}
