//! Robots with branches in URDF files, read whole, on a base that stands or moves, beside the values that Pinocchio has from
//! the same files.

use std::collections::BTreeMap;

use std::path::Path;

use dynamics_evaluation::{ReadOptions, RuntimeRobot, Value};
use robot_dynamics::check::Check;
use robot_dynamics::nalgebra::{Quaternion, UnitQuaternion, Vector3};
use robot_dynamics::{Pose, check_against_rnea, robot_dynamics};
use serde::Deserialize;

use super::text;

/// Values of a robot, as Pinocchio computes them from its file.
#[derive(Deserialize)]
pub(crate) struct Reference {
    pub(crate) joints: Vec<String>,
    pub(crate) states: Vec<State>,
}

/// The positions of a base that moves are its origin and a quaternion x, y, z, w; its velocities are the first six.
#[derive(Clone, Deserialize)]
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
    /// Where a base that moves stands.
    pub(crate) fn base(&self) -> Option<Pose<f64>> {
        let [x, y, z, i, j, k, w] = *self.q.first_chunk()?;
        let rotation = UnitQuaternion::from_quaternion(Quaternion::new(w, i, j, k));
        (self.q.len() > self.v.len()).then(|| Pose {
            rotation: rotation.to_rotation_matrix().into_inner(),
            position: Vector3::new(x, y, z),
        })
    }

    /// The same for the joints of a robot: Pinocchio sorts the children of a link by the names of their joints, the first of
    /// which is a base that moves.
    pub(crate) fn of<'a>(
        &self,
        reference: &Reference,
        names: impl Iterator<Item = &'a str>,
    ) -> Self {
        let place = |name: &str| reference.joints.iter().position(|joint| joint == name);
        let places: Option<Vec<usize>> = names.map(place).collect();
        let places = places.expect("the joints of the reference");
        let (first, of_base) = self.base().map_or((0, 0), |_| (1, 6));
        assert_eq!(first + places.len(), reference.joints.len());
        let beyond = |of_base: usize| {
            let joints = places.iter().map(move |place| place - first + of_base);
            (0..of_base).chain(joints).collect::<Vec<_>>()
        };
        let (of_positions, order) = (beyond(of_base + first), beyond(of_base));
        let of = |values: &[f64]| -> Vec<f64> { order.iter().map(|i| values[*i]).collect() };
        State {
            q: of_positions.iter().map(|i| self.q[*i]).collect(),
            v: of(&self.v),
            a: of(&self.a),
            tau: of(&self.tau),
            M: order.iter().map(|row| of(&self.M[*row])).collect(),
            nle: of(&self.nle),
            g: of(&self.g),
            ..self.clone()
        }
    }

    /// The numbers of a function here, matrices by columns, under these forces.
    #[track_caller]
    pub(crate) fn value(&self, robot: &RuntimeRobot, function: &str, tau: &[f64]) -> Vec<f64> {
        let base = self
            .base()
            .map_or(Vec::new(), |base| base.entries().as_slice().to_vec());
        let of_joints = if base.is_empty() { 0 } else { 7 };
        let names = robot.arguments(function).expect("asked for");
        let arguments = names.map(|(name, _)| match name {
            "base" => &base,
            "q" => &self.q[of_joints..],
            "qd" => &self.v,
            "qdd" => &self.a,
            _ => tau,
        });
        value(robot, function, &arguments.collect::<Vec<_>>())
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

/// The entries beside a file.
pub(crate) const STANDING: &str = "gravity = [0, 0, -9.81]\nallow = [\"unphysical_inertia\"]";
pub(crate) const MOVING: &str =
    "gravity = [0, 0, -9.81]\nallow = [\"unphysical_inertia\"]\nbase = \"floating\"";

/// The robot of a whole file, with its functions and the poses of some links.
pub(crate) fn robot(path: impl AsRef<Path>, beside: &str, links: &[&str]) -> RuntimeRobot {
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
        "potential_energy",
        "center_of_mass",
        "forward_dynamics",
    ];
    let functions = functions.map(String::from).into_iter().chain(poses);
    let options = ReadOptions::new().functions(functions).entries(beside);
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

fn sum(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a + b).collect()
}

/// The mass of what moves.
fn mass(robot: &RuntimeRobot) -> f64 {
    let table = robot.table();
    let frames = table.frames.iter();
    let frames = frames.filter(|frame| frame.on.is_some() || table.floating.is_some());
    let bodies = frames.map(|frame| frame.mass);
    let bodies = bodies.chain(table.floating.map(|body| body.mass));
    let links = table
        .rows
        .iter()
        .chain(table.followers().map(|follower| &follower.row));
    links.map(|row| row.mass).chain(bodies).sum()
}

/// Compares the robot of a file with the values of a reference.
fn compare(path: impl AsRef<Path>, beside: &str, reference: &Reference) {
    let links: Vec<&str> = reference.states[0]
        .leaf_poses
        .keys()
        .map(String::as_str)
        .collect();
    let robot = robot(path, beside, &links);
    let weight = 9.81 * mass(&robot);
    for state in &reference.states {
        let state = state.of(reference, robot.joint_names());
        let value = |function: &str| state.value(&robot, function, &[]);
        // Symmetric, so that rows are columns.
        let matrix = state.M.concat();
        // Pinocchio's forces are without friction.
        let friction = value("friction_vector");
        let forces = largest(&state.tau)
            .max(largest(&state.nle))
            .max(largest(&matrix) * largest(&state.a))
            .max(largest(&friction));
        let energy = weight * state.com[2];
        let (tau, nle) = (sum(&state.tau, &friction), sum(&state.nle, &friction));
        for (function, expected, scale) in [
            ("mass_matrix", &matrix[..], largest(&matrix)),
            ("bias_force", &nle, forces),
            ("gravity_vector", &state.g, forces),
            ("inverse_dynamics", &tau, forces),
            (
                "kinetic_energy",
                &[state.kinetic_energy],
                state.kinetic_energy,
            ),
            ("potential_energy", &[energy], 10.0 * weight),
            ("center_of_mass", &state.com, 1.0),
        ] {
            assert_near(function, &value(function), expected, scale);
        }
        // As far as M is known, whose condition is about 1e4.
        let back = state.value(&robot, "forward_dynamics", &value("inverse_dynamics"));
        assert_near("forward_dynamics", &back, &state.a, 1e4 * largest(&state.a));
        for (link, pose) in &state.leaf_poses {
            let columns: Vec<f64> = (0..16).map(|k| pose[k % 4][k / 4]).collect();
            let function = format!("forward_kinematics_{}", link.to_lowercase());
            assert_near(link, &value(&function), &columns, 1.0);
        }
    }
    let report = Check::new().samples(24).run_any(&robot);
    assert!(report.is_ok(), "{report}");
}

#[test]
fn legs_on_a_trunk_move_as_pinocchio_says() {
    for name in ["hyq_no_sensors", "anymal_erd"] {
        compare(file(name), STANDING, &reference(name));
        compare(file(name), MOVING, &reference(&format!("{name}_free")));
    }
}

/// `chain` with two tips is the part of the tree that leads to these: on a trunk that stands, the legs move as before.
#[test]
fn a_chain_of_two_tips_is_a_part_of_the_tree() {
    let whole = robot(file("hyq_no_sensors"), STANDING, &[]);
    let options = ReadOptions::new()
        .chain(["trunk", "lf_foot", "rh_foot"])
        .ignore(["rest"])
        .functions([
            "mass_matrix",
            "inverse_dynamics",
            "forward_kinematics(rh_foot)",
        ])
        .entries(STANDING);
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
    compare(file("panda_erd"), STANDING, &reference("panda_erd_mimic"));
    compare(file("panda_free"), STANDING, &reference("panda_erd"));
}

/// Entries of M for joints on different legs are no part of the program.
#[test]
fn legs_know_nothing_of_each_other() {
    let robot = robot(file("hyq_no_sensors"), STANDING, &[]);
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
