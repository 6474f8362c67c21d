//! Identified parameters, back in a robot.

use dynamics_evaluation::dynamics_numeric::check::Check;
use dynamics_evaluation::dynamics_runtime::nalgebra::{DMatrix, DVector, Matrix3};
use dynamics_evaluation::dynamics_simulation::{Friction, Simulation};
use dynamics_evaluation::{EvaluationError, IdentificationError, JointFriction, RuntimeRobot};
use dynamics_symbolic::Function;
use dynamics_symbolic::exact::SplitMix64;
use dynamics_symbolic::robot::{Coupling, Robot, Row, Value};

const FUNCTIONS: [Function; 10] = [
    Function::MassMatrix,
    Function::CoriolisVector,
    Function::GravityVector,
    Function::InverseDynamics,
    Function::ForwardDynamics,
    Function::KineticEnergy,
    Function::PotentialEnergy,
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
fn assert_found(guess: Robot, fields: &[f64]) {
    let joints = guess.dof();
    let name = guess.name.clone();
    let (real, guess) = (made(real(&guess, fields), fields), made(guess, fields));
    let identified = values(&real, "base_parameters", &[]);
    let found = guess.identified(&identified);
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
            (0..joints)
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
    assert_found(arms::robot("puma560"), &[]);
    assert_found(arms::robot("stanford"), &[]);
    let mut locked = arms::robot("puma560");
    locked.rows[1].locked = Some(arms::decimal(0.3));
    locked.rows[5].locked = Some(arms::decimal(-1.5));
    assert_found(locked, &[]);
    assert_found(coupled(), &[]);
    let symbolic = arms::with_inertial_fields("elbow_3r");
    let fields: Vec<f64> = (0..symbolic.fields.len())
        .map(|k| 1.0 + 0.3 * (5.0 * k as f64).sin())
        .collect();
    assert_found(symbolic, &fields);
}

#[test]
fn what_is_no_identification_is_refused() {
    let guess = made(arms::robot("two_link_saha"), &[]);
    let mut found = values(&guess, "base_parameters", &[]);
    assert!(guess.identified(&found).is_ok());
    let error = guess.identified(&found[1..]).expect_err("one is missing");
    let length = EvaluationError::Length {
        argument: "base_parameters",
        found: found.len() - 1,
        expected: found.len(),
    };
    assert_eq!(error, IdentificationError::Values(length));
    found[1] = f64::NAN;
    let error = guess.identified(&found).expect_err("no number");
    assert_eq!(error, IdentificationError::NotFinite(1));
    let symbolic = arms::with_inertial_fields("two_link_saha");
    let arm = RuntimeRobot::new(symbolic, FUNCTIONS).expect("proven");
    let count = arm.entries("base_parameters").expect("derived");
    let error = arm.identified(&vec![1.0; count]).expect_err("no values");
    assert_eq!(error, IdentificationError::Field("p0".to_owned()));
    let arm = RuntimeRobot::new(arms::robot("two_link_saha"), [Function::MassMatrix]);
    let error = arm.expect("proven").identified(&found);
    assert!(
        error
            .expect_err("no regressor")
            .to_string()
            .contains("`regressor` was not derived")
    );
}

type Triple = [f64; 3];

/// The UR5e as Universal Robots publishes it: D-H parameters, masses, centres of mass and tensors.
fn ur5e() -> Robot {
    const HALF: f64 = std::f64::consts::FRAC_PI_2;
    #[rustfmt::skip]
    let links: [(Triple, f64, Triple, Triple); 6] = [
        ([0.0, HALF, 0.1625], 3.761, [0.0, -0.02561, 0.00193], [0.0084, 0.0064, 0.0084]),
        ([-0.425, 0.0, 0.0], 8.058, [0.2125, 0.0, 0.11336], [0.0078, 0.21, 0.21]),
        ([-0.3922, 0.0, 0.0], 2.846, [0.15, 0.0, 0.0265], [0.0016, 0.0462, 0.0462]),
        ([0.0, HALF, 0.1333], 1.37, [0.0, -0.0018, 0.01634], [0.0016, 0.0016, 0.0009]),
        ([0.0, -HALF, 0.0997], 1.3, [0.0, 0.0018, 0.01634], [0.0016, 0.0016, 0.0009]),
        ([0.0, 0.0, 0.0996], 0.365, [0.0, 0.0, -0.001159], [0.0001, 0.0001, 0.0001]),
    ];
    let value = |x: f64| Value::from_f64(x).expect("finite");
    let mut robot = arms::robot("ur5");
    robot.name = "ur5e".to_owned();
    for (row, ([a, alpha, d], mass, com, [xx, yy, zz])) in robot.rows.iter_mut().zip(links) {
        let inertia = [xx, yy, zz, 0.0, 0.0, 0.0].map(value);
        *row = Row {
            a: value(a),
            alpha: arms::decimal(alpha),
            d: value(d),
            mass: value(mass),
            com: com.map(value),
            inertia,
            viscous: value(2.5),
            coulomb: [value(3.0), value(2.0)],
            ..Row::new(row.name.clone(), row.joint_type)
        };
    }
    robot
}

/// A recorded motion: positions, velocities, accelerations and torques, one sample after the other.
struct Recorded {
    motion: [Vec<f64>; 3],
    tau: DVector<f64>,
}

/// 8 s at 50 Hz of a sum of three sines for each joint, and torques with noise of the size `noise` of the mean torque of
/// that joint.
fn recorded(arm: &RuntimeRobot, noise: f64, seed: u64) -> Recorded {
    const SAMPLES: usize = 400;
    let mut random = SplitMix64::new(seed);
    let sines: Vec<[f64; 3]> = (0..18)
        .map(|k| {
            let rate = 0.785 * (1 + k % 3) as f64;
            [
                0.5 * random.unit() + 0.2,
                rate,
                std::f64::consts::TAU * random.unit(),
            ]
        })
        .collect();
    let motion = [0, 1, 2].map(|derivative| {
        let turned = f64::from(derivative) * std::f64::consts::FRAC_PI_2;
        let at = |k: usize, i: usize| -> f64 {
            let sines = sines[3 * i..3 * i + 3].iter();
            let t = 0.02 * k as f64;
            sines
                .map(|[a, w, phase]| a * w.powi(derivative) * (w * t + phase + turned).sin())
                .sum()
        };
        (0..SAMPLES * 6)
            .map(|entry| at(entry / 6, entry % 6))
            .collect::<Vec<f64>>()
    });
    let mut tau = values_at(arm, "inverse_dynamics", &motion, SAMPLES * 6);
    let size =
        |i: usize| tau.iter().skip(i).step_by(6).map(|x| x.abs()).sum::<f64>() / SAMPLES as f64;
    let sizes = [0, 1, 2, 3, 4, 5].map(size);
    for (entry, tau) in tau.iter_mut().enumerate() {
        let gauss: f64 = (0..12).map(|_| random.unit()).sum::<f64>() - 6.0;
        *tau += noise * sizes[entry % 6] * gauss;
    }
    Recorded {
        motion,
        tau: DVector::from(tau),
    }
}

fn values_at(
    arm: &RuntimeRobot,
    function: &str,
    motion: &[Vec<f64>; 3],
    entries: usize,
) -> Vec<f64> {
    let mut found = vec![0.0; entries];
    let motion: [&[f64]; 3] = motion.each_ref().map(Vec::as_slice);
    arm.batch(function, &motion, &mut found).expect("a value");
    found
}

/// The columns of the base parameters, then those of friction of each joint: qd, sign(qd) above zero and below.
fn columns(arm: &RuntimeRobot, Recorded { motion, tau }: &Recorded) -> DMatrix<f64> {
    let count = arm.entries("base_parameters").expect("derived");
    let regressor = values_at(arm, "regressor", motion, tau.len() * count);
    DMatrix::from_fn(tau.len(), count + 18, |row, column| {
        let (qd, joint) = (motion[1][row], row % 6);
        match column.checked_sub(count) {
            None => regressor[row / 6 * 6 * count + column * 6 + joint],
            Some(k) if k / 3 != joint => 0.0,
            Some(k) => [qd, f64::from(qd > 0.0), -f64::from(qd < 0.0)][k % 3],
        }
    })
}

/// The least squares of a recorded motion: base parameters and friction.
fn fitted(guess: &RuntimeRobot, run: &Recorded) -> (DVector<f64>, [JointFriction; 6]) {
    let y = columns(guess, run);
    let found = (y.tr_mul(&y).cholesky()).expect("the motion shows all of them");
    let found = found.solve(&y.tr_mul(&run.tau));
    let count = y.ncols() - 18;
    let friction = [0, 1, 2, 3, 4, 5].map(|joint| {
        let [viscous, positive, negative] = [0, 1, 2].map(|k| found[count + 3 * joint + k]);
        JointFriction::new(viscous, [positive, negative])
    });
    (found.rows(0, count).into_owned(), friction)
}

/// The root mean square of what an arm's torques miss of the recorded ones.
fn residual(arm: &RuntimeRobot, Recorded { motion, tau }: &Recorded) -> f64 {
    let found = DVector::from(values_at(arm, "inverse_dynamics", motion, tau.len()));
    (found - tau).norm() / (tau.len() as f64).sqrt()
}

/// A table of masses that are wrong by up to a third, and centres of mass by 2 cm, without friction.
fn wrong(robot: &Robot) -> Robot {
    let mut wrong = robot.clone();
    for (k, row) in wrong.rows.iter_mut().enumerate() {
        let value = |x: f64| Value::from_f64(x).expect("finite");
        let share = 1.0 + 0.33 * (3.0 * k as f64 + 1.0).sin();
        row.mass = value(row.mass.to_f64(&[]) * share);
        row.com[k % 3] = value(row.com[k % 3].to_f64(&[]) + 0.02 * (k as f64).cos());
        row.viscous = Value::zero();
        row.coulomb = [Value::zero(), Value::zero()];
    }
    wrong
}

/// Masses and principal moments about the centres of mass are those of bodies.
fn assert_bodies(arm: &RuntimeRobot) {
    for row in &arm.robot().rows {
        let number = |value: &Value| value.to_f64(&[]);
        let [xx, yy, zz, xy, yz, xz] = row.inertia.each_ref().map(number);
        let tensor = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
        let moments = tensor.symmetric_eigenvalues();
        let name = &row.name;
        assert!(number(&row.mass) > 0.0, "{name}");
        assert!(
            moments.min() > 0.0 && moments.sum() > 2.0 * moments.max(),
            "{name}: {moments}"
        );
    }
}

/// Two links whose torques would push the other way.
#[test]
fn base_parameters_of_no_bodies_are_refused_with_what_is_impossible() {
    let mut robot = ur5e();
    robot.rows.truncate(2);
    let arm = made(robot, &[]);
    let b: Vec<f64> = values(&arm, "base_parameters", &[]);
    let negative: Vec<f64> = b.iter().map(|b| -b).collect();
    let error = arm.identified(&negative).expect_err("no bodies");
    let IdentificationError::Impossible(links) = &error else {
        panic!("{error}")
    };
    assert!(links.iter().any(|link| link.joint == "joint2"), "{error}");
    let text = error.to_string();
    assert!(
        text.starts_with("no bodies have these base parameters: the link of `joint")
            && text.ends_with("`nearest_possible` has the nearest that bodies have"),
        "{text}"
    );
    let nearest = arm.nearest_possible(&negative).expect("finite numbers");
    assert!(nearest.torque > 0.0);
    assert_bodies(&arm.identified(&nearest.base_parameters).expect("possible"));
}

/// Torques with noise of a tenth of their size: the parameters of least squares are no arm's.
#[test]
#[ignore = "takes eight seconds"]
fn the_nearest_possible_arm_fits_noisy_torques_nearly_as_well() {
    let (real, guess) = (made(ur5e(), &[]), made(wrong(&ur5e()), &[]));
    let run = recorded(&real, 0.1, 3);
    let (b, friction) = fitted(&guess, &run);
    let error = guess.identified(b.as_slice()).expect_err("no bodies");
    let IdentificationError::Impossible(links) = &error else {
        panic!("{error}")
    };
    assert!(links.len() > 1, "{error}");
    let text = error.to_string();
    assert!(
        text.starts_with("no bodies have these base parameters: the link of `joint"),
        "{text}"
    );
    assert!(
        text.ends_with("`nearest_possible` has the nearest that bodies have"),
        "{text}"
    );

    let nearest = guess
        .nearest_possible(b.as_slice())
        .expect("finite numbers");
    let identified = guess.identified_with_friction(&nearest.base_parameters, &friction);
    let identified = identified.expect("possible");
    assert_bodies(&identified);
    // The real arm is possible, and no nearer.
    let of_real = DVector::from(values(&real, "base_parameters", &[]));
    let [near, far] = [DVector::from(nearest.base_parameters), of_real].map(|other| {
        let motion = [0, 1, 2].map(|k| {
            let mut random = SplitMix64::new(7 + k);
            let largest = [std::f64::consts::PI, 3.0, 10.0][k as usize];
            (0..1200)
                .map(|_| largest * (2.0 * random.unit() - 1.0))
                .collect::<Vec<f64>>()
        });
        let still = Recorded {
            motion,
            tau: DVector::zeros(1200),
        };
        let y = columns(&guess, &still);
        (y.columns(0, b.len()) * (other - &b)).norm() / 1200_f64.sqrt()
    });
    assert!(
        (near / nearest.torque - 1.0).abs() < 0.2 && near < far,
        "{near}, {far}"
    );
    // The noise itself, and what the arms miss of the torques.
    let [of_real, found] = [&real, &identified].map(|arm| residual(arm, &run));
    assert!(found < 1.1 * of_real, "{found} of {of_real}");

    let dynamics = identified.dynamics().expect("derived");
    let falling = Simulation::new(&dynamics).friction(Friction::Sticking);
    let falling = falling.duration(0.2).samples(3).run();
    assert_eq!(falling.expect("M is positive definite").len(), 3);
}

/// Exact torques of a real arm, beside a table that is far from it: links of bodies, with its base parameters.
#[test]
fn possible_base_parameters_give_links_of_bodies() {
    let (real, guess) = (made(ur5e(), &[]), made(wrong(&ur5e()), &[]));
    let b = values(&real, "base_parameters", &[]);
    let nearest = guess.nearest_possible(&b).expect("possible");
    assert_eq!((nearest.base_parameters, nearest.torque), (b.clone(), 0.0));
    let found = guess.identified(&b).expect("possible");
    assert_bodies(&found);
    let again = values(&found, "base_parameters", &[]);
    assert!(
        b.iter().zip(&again).all(|(x, y)| (x - y).abs() < 1e-11),
        "{b:?}, {again:?}"
    );
}

#[test]
fn friction_that_feeds_energy_is_refused_and_replaces_that_of_the_table() {
    let mut guess = arms::robot("two_link_saha");
    guess.rows[0].coulomb = [arms::decimal(1.0), arms::decimal(1.0)];
    let guess = made(guess, &[]);
    let b = values(&guess, "base_parameters", &[]);
    let none = JointFriction::default();
    let of_first = JointFriction::new(2.0, [0.5, 0.25]);
    let arm = guess
        .identified_with_friction(&b, &[of_first, none])
        .expect("possible");
    assert_eq!(values(&arm, "friction_vector", &[&[3.0, 3.0]]), [6.5, 0.0]);
    assert_eq!(
        values(&arm, "friction_vector", &[&[-3.0, 3.0]]),
        [-6.25, 0.0]
    );
    let error = guess.identified_with_friction(&b, &[none]);
    let text = error.expect_err("one for two joints").to_string();
    assert_eq!(text, "`friction` has 1 entries where 2 are expected");
    for wrong in [-0.1, f64::NAN, f64::INFINITY] {
        let negative = JointFriction::new(0.0, [0.0, wrong]);
        let error = guess.identified_with_friction(&b, &[none, negative]);
        let text = error.expect_err("no friction").to_string();
        let expected = format!(
            "the friction of `joint2` has the coefficient {wrong}: expected a finite number, 0 or above"
        );
        assert_eq!(text, expected);
    }
}

/// A link of a negative inertia: checks and simulations say what is wrong.
#[test]
fn an_arm_without_a_positive_definite_mass_matrix_is_no_good_one() {
    let mut robot = arms::robot("two_link_saha");
    assert!(Check::new().certify_any(&made(robot.clone(), &[])).is_ok());
    robot.rows[1].inertia = [(); 6].map(|()| arms::decimal(-2.5));
    let arm = made(robot, &[]);
    let report = Check::new().certify_any(&arm);
    assert!(!report.is_ok() && report.functions.iter().all(|function| function.is_ok()));
    let text = report.to_string();
    assert!(
        text.contains("\nmass matrix: NOT positive definite, relative pivot -"),
        "{text}"
    );
    let dynamics = arm.dynamics().expect("derived");
    let error = Simulation::new(&dynamics).run().expect_err("no motion");
    let text = format!("{error:?}");
    assert!(
        error.time == 0.0 && text.contains("check masses, inertia tensors and motors"),
        "{text}"
    );
}
