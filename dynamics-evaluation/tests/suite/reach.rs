//! Numeric inverse kinematics of robots at run time.

use dynamics_evaluation::{EvaluationError, ReadOptions, RuntimeRobot};
use dynamics_numeric::NumericArm;
use dynamics_numeric::inverse_kinematics::{InverseKinematics, Reason, Target};
use dynamics_runtime::nalgebra::{DVector, Dyn, Matrix4, Vector3, Vector6};
use dynamics_runtime::{Pose, SizedKinematics as _};
use dynamics_simulation::simulation::Place;

fn data(name: &str) -> String {
    format!("{}/../tests/data/{name}", env!("CARGO_MANIFEST_DIR"))
}

/// Arms of the data files, with the limits of the files: what is found is there by Newton-Euler too.
#[test]
fn poses_of_data_files_are_reached() {
    let options = ReadOptions::new().functions(RuntimeRobot::place_functions(None));
    for file in [
        "puma560",
        "ur5",
        "panda",
        "stanford",
        "scara",
        "generic_mixed_n6_standard",
    ] {
        let arm = RuntimeRobot::from_file(data(&format!("robots/{file}.json")), &options).unwrap();
        let tip = arm.place(None).unwrap();
        let numeric = NumericArm::<Dyn>::new(&arm.table());
        let solver = InverseKinematics::new(&tip);
        for k in 0..20 {
            let q = DVector::from_fn(arm.dof(), |i, _| (f64::from(k) * 0.37 + i as f64).sin());
            let pose = numeric.forward_kinematics(&q);
            let found = solver.solve(&pose, &DVector::zeros(arm.dof())).unwrap();
            let there = numeric.forward_kinematics(&found.q);
            assert!((there - pose).amax() < 1e-8, "{file}");
        }
    }
}

/// Two frames of a tree, each by its name.
#[test]
fn frames_of_a_tree_are_reached_together() {
    let names = ["left_hand", "right_hand"];
    let functions = names.map(|name| RuntimeRobot::place_functions(Some(name)));
    let text = r#"
        convention = "modified"
        gravity = [0, 0, -9.81]
        joint = [
            { name = "waist", type = "revolute" },
            { name = "left", type = "revolute", on = "waist", b = 0.4, gamma = "PI/2", alpha = "PI/2" },
            { name = "right", type = "revolute", on = "waist", b = 0.4, gamma = "-PI/2", alpha = "PI/2" },
        ]
        [frame.left_hand]
        on = "left"
        xyz = [0.5, 0, 0]
        [frame.right_hand]
        on = "right"
        xyz = [0.5, 0, 0]
    "#;
    let options = ReadOptions::new().functions(functions.as_flattened());
    let arm = RuntimeRobot::from_toml(text, &options).unwrap();
    let places = names.map(|name| arm.place(Some(name)).unwrap());
    let both: Vec<_> = places
        .iter()
        .map(|place| |q: &DVector<f64>| (place.tip_pose(q), place.tip_jacobian(q)))
        .collect();
    let solver = InverseKinematics::of_frames(&places[0], both);
    let q = DVector::from_vec(vec![0.3, 0.5, -0.4]);
    let targets = [0, 1].map(|k| Target::pose(&places[k].tip_pose(&q)));
    let found = solver.solve_all(&targets, &DVector::zeros(3)).unwrap();
    assert!((found.q - q).amax() < 1e-8);
    let short = solver.solve_all(&targets, &DVector::zeros(2)).unwrap_err();
    assert_eq!(short.reason, Reason::Length);
}

/// The velocity of a frame on a base that moves follows from its Jacobian.
#[test]
fn frames_are_placed_on_a_base_that_moves() {
    let text = r#"
        convention = "modified"
        gravity = [0, 0, -9.81]
        base = { floating = true, mass = 1, inertia = "sphere(0.1)" }
        joint = [{ name = "wheel", type = "revolute", mass = 1 }]
        [frame.knot]
        on = "base"
        xyz = [0, 0, 0.1]
    "#;
    let functions = RuntimeRobot::place_functions(Some("knot"));
    let arm = RuntimeRobot::from_toml(text, &ReadOptions::new().functions(&functions)).unwrap();
    let knot = arm.place(Some("knot")).unwrap();
    let mut base = Pose::identity();
    base.position = Vector3::new(1.0, 2.0, 3.0);
    let (base, q) = (Some(base), DVector::zeros(1));
    let (pose, jacobian) = knot.at(&Place { base, q });
    let position = pose.fixed_view::<3, 1>(0, 3).into_owned();
    assert!((position - Vector3::new(1.0, 2.0, 3.1)).amax() < 1e-15);
    // The base turns about x.
    let v = DVector::from_vec(vec![0.0, 0.5, 0.0, 1.0, 0.0, 0.0, 7.0]);
    let twist = Vector6::new(0.0, 0.4, 0.0, 1.0, 0.0, 0.0);
    assert!((jacobian * v - twist).amax() < 1e-15);
    // Inverse kinematics has the columns of the joints, and the base in the frame of the world.
    let q = DVector::zeros(1);
    let position = knot.tip_pose(&q).fixed_view::<3, 1>(0, 3).into_owned();
    assert!((position - Vector3::new(0.0, 0.0, 0.1)).amax() < 1e-15);
    assert_eq!(knot.tip_jacobian(&q).shape(), (6, 1));
}

#[test]
fn what_is_lacking_is_said() {
    let options = ReadOptions::new().functions(["mass_matrix"]);
    let arm = RuntimeRobot::from_file(data("robots/scara.json"), &options).unwrap();
    let lacking = EvaluationError::NotDerived("forward_kinematics".to_owned());
    assert_eq!(arm.place(None).unwrap_err(), lacking);
    let lacking = EvaluationError::NotDerived("forward_kinematics_hand".to_owned());
    assert_eq!(arm.place(Some("hand")).unwrap_err(), lacking);
    // A field without a value is no number.
    let text = r#"
        convention = "modified"
        gravity = [0, 0, -9.81]
        joint = [{ name = "one", type = "revolute", d = "height" }]
    "#;
    let functions = RuntimeRobot::place_functions(None);
    let options = ReadOptions::new().fields(["height"]).functions(functions);
    let arm = RuntimeRobot::from_toml(text, &options).unwrap();
    let tip = arm.place(None).unwrap();
    let found = InverseKinematics::new(&tip).solve(&Matrix4::identity(), &DVector::zeros(1));
    assert_eq!(found.unwrap_err().reason, Reason::NonFinite);
}
