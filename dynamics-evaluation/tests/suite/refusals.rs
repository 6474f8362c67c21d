//! Refusals, and their messages.

use dynamics_evaluation::dynamics_runtime::NAMES_OF_BASE;
use dynamics_evaluation::dynamics_runtime::nalgebra::Vector6;
use dynamics_evaluation::dynamics_simulation::{Friction, Simulation};
use dynamics_evaluation::{BuildError, EvaluationError, FileError, ReadOptions, RuntimeRobot};
use dynamics_symbolic::Function;
use dynamics_symbolic::robot::{Mount, Placement, Value};

fn arm() -> RuntimeRobot {
    let functions = [Function::InverseDynamics, Function::BaseParameters];
    RuntimeRobot::new(arms::robot("elbow_3r"), functions).expect("an arm")
}

#[test]
fn what_was_not_asked_for_is_no_value() {
    let error = arm().mass_matrix(&[0.0; 3]).unwrap_err();
    assert_eq!(error, EvaluationError::NotDerived("mass_matrix".to_owned()));
    assert!(
        error
            .to_string()
            .contains("request it when the robot is made"),
        "{error}"
    );
    assert!(arm().dynamics().is_err());
}

#[test]
fn a_simulation_says_which_function_it_lacks_and_what_to_write() {
    let robot = arms::robot("elbow_3r");
    let all = RuntimeRobot::simulation_functions();
    let all = all.map(|name| Function::from_name(name).expect("a function"));
    for (k, missing) in all.iter().enumerate().step_by(4) {
        let others = all.iter().filter(|function| *function != missing);
        let arm = RuntimeRobot::new(robot.clone(), others.copied()).expect("an arm");
        let error = match arm.dynamics() {
            Err(error) => error,
            Ok(_) => {
                assert!(k >= 5, "{missing:?}");
                let error = arm.place(None).expect_err("no tip");
                let lacking = EvaluationError::NotDerived(missing.name().to_owned());
                assert_eq!(error, lacking);
                continue;
            }
        };
        let name = missing.name();
        assert_eq!(error, EvaluationError::NotSimulated(name.to_owned()));
        let text = error.to_string();
        assert!(
            text.starts_with(&format!("a simulation needs `{name}`")),
            "{text}"
        );
        assert!(
            text.contains("request all of `RuntimeRobot::simulation_functions()`"),
            "{text}"
        );
    }
    let arm = RuntimeRobot::new(robot, all).expect("an arm");
    let (dynamics, tip) = (
        arm.dynamics().expect("all"),
        arm.place(None).expect("a tip"),
    );
    let pushed = Simulation::new(&dynamics).friction(Friction::Sticking);
    let pushed = pushed.wrench_at(|_, place| tip.at(place), |_, _, _| Vector6::repeat(0.1));
    assert_eq!(pushed.duration(0.1).run().expect("a motion").len(), 101);
}

#[test]
fn lengths_are_told() {
    let arm = arm();
    let error = arm
        .inverse_dynamics(&[0.0; 3], &[0.0; 2], &[0.0; 3])
        .unwrap_err();
    assert_eq!(error.to_string(), "`qd` has 2 entries where 3 are expected");
    let mut tau = [7.0; 5];
    let error = arm
        .inverse_dynamics_batch(&[0.0; 6], &[0.0; 6], &[0.0; 6], &mut tau)
        .unwrap_err();
    assert_eq!(
        error.to_string(),
        "`results` has 5 entries where 6 are expected"
    );
    assert_eq!(tau, [7.0; 5]);
    let error = arm
        .inverse_dynamics_batch(&[0.0; 4], &[0.0; 6], &[0.0; 6], &mut tau)
        .unwrap_err();
    assert!(
        matches!(error, EvaluationError::Length { argument: "q", .. }),
        "{error}"
    );
    let error = arm.evaluate("inverse_dynamics", &[&[0.0; 3]]).unwrap_err();
    assert_eq!(
        error.to_string(),
        "1 arguments where 3 are expected: q, qd, qdd"
    );
    assert!(arm.batch("base_parameters", &[], &mut []).is_ok());
}

#[test]
fn fields_are_known_by_name() {
    let mut arm = RuntimeRobot::new(
        arms::with_inertial_fields("one_link"),
        [Function::GravityVector],
    )
    .expect("an arm");
    assert!(arm.gravity_vector(&[0.3]).expect("a value")[0].is_nan());
    let error = arm.set_field("mass", 1.0).unwrap_err().to_string();
    assert!(
        error.starts_with("no field `mass`: expected one of p0, p1"),
        "{error}"
    );
    assert!(arm.set_fields(&[1.0]).is_err());
}

/// Places and mounts with that field in one of their cells, of each kind.
fn mounts_with_field(index: usize) -> [(Vec<Placement>, Mount); 3] {
    let zeros = || [0; 3].map(|_| Value::zero());
    let still = || Mount {
        axis: [Value::zero(), Value::zero()],
        tip: None,
    };
    let turned = || Placement {
        xyz: zeros(),
        rpy: [Value::zero(), Value::field(index), Value::zero()],
    };
    let axis = Mount {
        axis: [Value::field(index), Value::zero()],
        ..still()
    };
    let tip = Mount {
        tip: Some(vec![turned()]),
        ..still()
    };
    [
        (vec![turned()], still()),
        (Vec::new(), axis),
        (Vec::new(), tip),
    ]
}

#[test]
fn descriptions_that_make_no_sense_are_refused() {
    let mut robot = arms::robot("one_link");
    robot.rows[0].mass = Value::field(3);
    let refused = RuntimeRobot::new(robot.clone(), [Function::MassMatrix]).unwrap_err();
    assert_eq!(refused, BuildError::NoSuchField(3));
    robot.rows[0].mass = Value::zero();
    for (at, mount) in mounts_with_field(2) {
        robot.rows[0].at = at;
        robot.rows[0].mount = Some(mount);
        let refused = RuntimeRobot::new(robot.clone(), [Function::MassMatrix]).unwrap_err();
        assert_eq!(refused, BuildError::NoSuchField(2));
    }
    robot.rows[0].at = Vec::new();
    robot.rows[0].mount = None;
    robot.rows[0].locked = Some(Value::zero());
    let refused = RuntimeRobot::new(robot.clone(), [Function::MassMatrix]).unwrap_err();
    assert_eq!(refused, BuildError::NoJoints);
    let twice = [Function::MassMatrix, Function::MassMatrix];
    let refused = RuntimeRobot::new(arms::robot("one_link"), twice).unwrap_err();
    assert_eq!(refused.to_string(), "`mass_matrix` is requested twice");
    let series = RuntimeRobot::new(arms::robot("one_link"), [Function::TaylorSeries]).unwrap_err();
    assert!(
        series.to_string().contains("no program over numbers"),
        "{series}"
    );
}

/// Files and options say which function or cell is meant, and options which line of them is wrong.
#[test]
fn names_that_are_unknown_are_told_with_the_nearest_one() {
    let table = |cell: &str| {
        format!(
            "convention = 'modified'\ngravity = [9.81, 0, 0]\n[[joint]]\nname = 'pivot'\ntype = 'revolute'\n{cell} = 2\n"
        )
    };
    let options = ReadOptions::new().functions(["mass_matrix"]);
    let arm = RuntimeRobot::from_toml(&table("mass"), &options).expect("an arm");
    assert_eq!(arm.function_names().collect::<Vec<_>>(), ["mass_matrix"]);
    let told = |cell: &str, options: &ReadOptions| {
        let error = RuntimeRobot::from_toml(&table(cell), options).expect_err("no arm");
        let FileError::Mistakes(mistakes) = &error else {
            panic!("{error}")
        };
        (mistakes[0].line, error.to_string())
    };
    let (line, text) = told("mas", &options);
    assert!(
        line == 6 && text.starts_with("TOML:6:1: ") && text.contains("`mass`"),
        "{text}"
    );
    let (line, text) = told("mass", &ReadOptions::new().functions(["mass_matrx"]));
    assert!(
        line == 1
            && text.contains("unknown function `mass_matrx`")
            && text.contains("`mass_matrix`"),
        "{text}"
    );
    let (line, text) = told("mass", &options.entries("base = {}\ngravitty = [0, 0, 0]"));
    assert!(line == 2 && text.contains("`gravity`"), "{line}: {text}");
}

/// The six of a base that moves are counted before the joints, and have names.
#[test]
fn what_is_singular_on_a_moving_base_has_a_name() {
    let mut robot = arms::floating("torso");
    let last = robot.rows.len() - 1;
    robot.rows[last].mass = Value::zero();
    robot.rows[last].inertia = [(); 6].map(|()| Value::zero());
    let mut names: Vec<_> = NAMES_OF_BASE.map(str::to_owned).to_vec();
    names.extend(robot.joints().map(|row| row.name.clone()));
    let arm = RuntimeRobot::new(robot, [Function::ForwardDynamics]).expect("a robot");
    let joints = arm.joint_names().count();
    for q in [0.3, f64::NAN] {
        let (base, q) = ([1.0; 12], vec![q; joints]);
        let v = vec![0.0; 6 + joints];
        let refused = arm.evaluate("forward_dynamics", &[&base, &q, &v, &v]);
        let Err(EvaluationError::Singular { joint, error, .. }) = refused else {
            panic!("{refused:?}")
        };
        assert_eq!(joint, names[error.joint]);
    }
}
