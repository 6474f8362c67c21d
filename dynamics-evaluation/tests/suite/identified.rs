//! What was identified, back in a robot.

use dynamics_evaluation::{EvaluationError, IdentificationError, RuntimeRobot};
use dynamics_symbolic::Function;
use dynamics_symbolic::robot::{Coupling, Robot, Value};

const FUNCTIONS: [Function; 4] = [
    Function::InverseDynamics,
    Function::FrictionVector,
    Function::Regressor,
    Function::BaseParameters,
];

/// The arm as it is, beside its table with these values of its fields: other masses, centres of mass and tensors.
fn real(guess: &Robot, fields: &[f64]) -> Robot {
    let mut real = guess.clone();
    for (k, row) in real.rows.iter_mut().enumerate() {
        let more = |value: &Value, i: usize| {
            let share = 0.2 * (1.0 + ((7 * k + 3 * i) as f64).sin());
            let x = value.to_f64(fields);
            Value::from_f64(x + share * x.abs() + 0.01 * share).expect("finite")
        };
        if !row.mass.is_zero() {
            row.mass = more(&row.mass, 0);
        }
        row.com = [1, 2, 3].map(|i| more(&row.com[i - 1], i));
        row.inertia = [4, 5, 6, 7, 8, 9].map(|i| more(&row.inertia[i - 4], i));
    }
    real
}

fn values(arm: &RuntimeRobot, function: &str, arguments: &[&[f64]]) -> Vec<f64> {
    let mut values = vec![0.0; arm.entries(function).expect("derived")];
    arm.batch(function, arguments, &mut values)
        .expect("a value");
    values
}

fn made(robot: Robot, fields: &[f64]) -> RuntimeRobot {
    let mut arm = RuntimeRobot::new(robot, FUNCTIONS).expect("proven");
    arm.set_fields(fields).expect("a value for each field");
    arm
}

/// Two slides of which the second one follows the first, at one and a half times its speed.
fn coupled() -> Robot {
    let mut robot = arms::robot("cylindrical_rpp");
    robot.rows[2].follows = Some(Coupling {
        leader: 1,
        factor: arms::decimal(1.5),
        offset: arms::decimal(0.25),
    });
    robot
}

/// The torques of the identified arm are those of the real one, and its base parameters.
fn assert_found<const N: usize>(guess: Robot, fields: &[f64]) {
    let name = guess.name.clone();
    let (real, guess) = (made(real(&guess, fields), fields), made(guess, fields));
    let identified = values(&real, "base_parameters", &[]);
    let found = guess
        .typed::<N>()
        .expect("so many joints")
        .identified(&identified);
    let found = found.expect("a robot");
    let close = |a: &[f64], b: &[f64]| {
        let largest = a.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
        a.iter()
            .zip(b)
            .all(|(a, b)| (a - b).abs() <= 1e-11 * largest)
    };
    assert!(
        close(&identified, &values(&found, "base_parameters", &[])),
        "{name}"
    );
    for seed in 0..5 {
        let vector = |of: usize| -> Vec<f64> {
            (0..N)
                .map(|i| 2.0 * ((31 * seed + 17 * of + 5 * i) as f64).sin())
                .collect()
        };
        let motion = [vector(0), vector(1), vector(2)];
        let motion: [&[f64]; 3] = motion.each_ref().map(Vec::as_slice);
        let [real, found, guess] =
            [&real, &found, &guess].map(|arm| values(arm, "inverse_dynamics", &motion));
        assert!(close(&real, &found), "{name}: {real:?}, {found:?}");
        assert!(!close(&real, &guess), "{name}");
    }
}

#[test]
fn an_identified_robot_moves_as_the_real_one() {
    assert_found::<6>(arms::robot("puma560"), &[]);
    assert_found::<6>(arms::robot("stanford"), &[]);
    let mut locked = arms::robot("puma560");
    locked.rows[1].locked = Some(arms::decimal(0.3));
    locked.rows[5].locked = Some(arms::decimal(-1.5));
    assert_found::<4>(locked, &[]);
    assert_found::<2>(coupled(), &[]);
    let symbolic = arms::with_inertial_fields("elbow_3r");
    let fields: Vec<f64> = (0..symbolic.fields.len())
        .map(|k| 1.0 + 0.3 * (5.0 * k as f64).sin())
        .collect();
    assert_found::<3>(symbolic, &fields);
}

#[test]
fn what_is_no_identification_is_refused() {
    let guess = made(arms::robot("two_link_saha"), &[]);
    let typed = guess.typed::<2>().expect("two joints");
    let mut found = values(&guess, "base_parameters", &[]);
    assert!(typed.identified(&found).is_ok());
    let error = typed.identified(&found[1..]).expect_err("one is missing");
    let length = EvaluationError::Length {
        argument: "base_parameters",
        found: found.len() - 1,
        expected: found.len(),
    };
    assert_eq!(error, IdentificationError::Values(length));
    found[1] = f64::NAN;
    let error = typed.identified(&found).expect_err("no number");
    assert_eq!(error, IdentificationError::NotFinite(1));
    let symbolic = arms::with_inertial_fields("two_link_saha");
    let arm = RuntimeRobot::new(symbolic, FUNCTIONS).expect("proven");
    let count = arm.entries("base_parameters").expect("derived");
    let typed = arm.typed::<2>().expect("two joints");
    let error = typed.identified(&vec![1.0; count]).expect_err("no values");
    assert_eq!(error, IdentificationError::Field("p0".to_owned()));
    let arm = RuntimeRobot::new(arms::robot("two_link_saha"), [Function::MassMatrix]);
    let error = arm
        .expect("proven")
        .typed::<2>()
        .expect("two joints")
        .identified(&found);
    assert!(
        error
            .expect_err("no regressor")
            .to_string()
            .contains("`regressor` was not derived")
    );
}
