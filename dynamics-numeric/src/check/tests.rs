//! The check passes what is right and finds what is wrong.

use dynamics_runtime::functions::NAMES;
use dynamics_runtime::internal::FORMS;
use dynamics_runtime::table::{FixedFrame, Frame, Placement, RuntimeTable, Table};
use dynamics_runtime::{
    AccelerationDerivatives, MAX_TAYLOR_ORDER, Model, Pose, SingularMassMatrix, SizedState, State,
    TaylorCoefficients,
};
use nalgebra::{DMatrix, DVector, Dyn, Matrix2, SMatrix, SVector, Vector2};
use tables::{CRAIG_ARM, CraigArm, random_state};

use super::accelerations::refused;
use super::at::At;
use super::functions::{Row, Rule, deviations};
use crate::check::{Check, Evaluate, Evaluation, Report};
use crate::{NewtonEuler, NumericArm, check_against_rnea};

/// The textbook arm with some values of its evaluation changed.
struct Damaged(fn(&State<2>, &mut Evaluation));

impl Model<2> for Damaged {
    const JOINT_NAMES: [&'static str; 2] = CraigArm::JOINT_NAMES;

    fn table(&self) -> Table<2> {
        CRAIG_ARM.table()
    }
}

impl Evaluate<2> for Damaged {
    fn evaluate(&self, state: &State<2>, tau: &SVector<f64, 2>) -> Evaluation {
        let mut evaluation = CRAIG_ARM.evaluate(state, tau);
        (self.0)(state, &mut evaluation);
        evaluation
    }
}

/// Names of the functions that do not pass.
fn wrong(report: &Report) -> Vec<&str> {
    let wrong = report.functions.iter().filter(|function| !function.is_ok());
    wrong.map(|function| function.function).collect()
}

fn check(damage: fn(&State<2>, &mut Evaluation)) -> Report {
    Check::new().samples(20).run(&Damaged(damage))
}

#[test]
fn a_right_model_passes_with_room_to_spare() {
    let report = check_against_rnea(&CRAIG_ARM);
    report.assert_ok();
    assert_eq!(report.functions.len(), 8);
    for function in &report.functions {
        assert!(function.error < 1e-14, "{function}");
        assert_eq!(function.states, report.states);
    }
}

/// The compiler finds out in generic code, too, that the base stands.
fn generic<R: Evaluate<N>, const N: usize>(robot: &R) -> Report {
    Check::new().samples(2).run(robot)
}

#[test]
fn robots_are_checked_in_generic_code() {
    generic(&CRAIG_ARM).assert_ok();
}

fn any_vector(vector: &Vector2<f64>) -> DVector<f64> {
    DVector::from_column_slice(vector.as_slice())
}

fn of_any_size(state: &State<2>) -> SizedState<Dyn> {
    let [q, qd, qdd] = [&state.q, &state.qd, &state.qdd].map(any_vector);
    SizedState { q, qd, qdd }
}

fn numeric() -> NewtonEuler<2> {
    NewtonEuler::new(&CRAIG_ARM.table())
}

/// B(q) and C(q), Craig (6.61).
fn coefficients(state: &State<2>) -> (Vector2<f64>, Matrix2<f64>) {
    let CraigArm { m2, l1, l2, .. } = CRAIG_ARM;
    let h = m2 * l1 * l2 * state.q[1].sin();
    (Vector2::new(-2.0 * h, 0.0), Matrix2::new(0.0, -h, h, 0.0))
}

fn force_derivatives(state: &State<2>) -> (Matrix2<f64>, Matrix2<f64>) {
    numeric().inverse_dynamics_derivatives(&state.q, &state.qd, &state.qdd)
}

fn acceleration_derivatives(state: &State<2>) -> AccelerationDerivatives<f64, 2> {
    let (by_position, by_velocity) = force_derivatives(state);
    let inverse = CRAIG_ARM.mass_matrix(&state.q).try_inverse().unwrap();
    (-inverse * by_position, -inverse * by_velocity, inverse)
}

fn taylor_series(state: &State<2>) -> TaylorCoefficients<f64, 2> {
    let State { q, qd, qdd } = state;
    let (by_position, by_velocity) = force_derivatives(state);
    let inverse = CRAIG_ARM.mass_matrix(q).try_inverse().unwrap();
    let jerk = -inverse * (by_position * qd + by_velocity * qdd);
    let mut series = [Vector2::zeros(); MAX_TAYLOR_ORDER + 1];
    series[..4].copy_from_slice(&[*q, *qd, qdd / 2.0, jerk / 6.0]);
    series
}

fn passivity(state: &State<2>) -> SVector<f64, 2> {
    let State { q, qd, .. } = state;
    let inertial = numeric().mass_matrix(q) * state.reference_acceleration();
    let coriolis = numeric().coriolis_matrix(q, qd) * state.reference_velocity();
    inertial + coriolis + numeric().gravity_vector(q)
}

/// Gives all functions and forms their values. The arm has neither friction nor springs.
fn complete(state: &State<2>, e: &mut Evaluation) {
    let (numeric, State { q, qd, qdd }) = (numeric(), state);
    let torque = numeric.inverse_dynamics(q, qd, qdd);
    let (coriolis, centrifugal) = coefficients(state);
    let jacobian = numeric.jacobian(q);
    let jacobian_rate = numeric.jacobian_rate(q, qd);
    let inverse = CRAIG_ARM.mass_matrix(q).try_inverse().expect("regular");
    let momentum_bias = numeric.coriolis_matrix(q, qd).transpose() * qd - numeric.gravity_vector(q);
    let rates = numeric.inverse_dynamics_rates(q, qd, qdd, &state.jerk(), &state.snap());
    let second = numeric.inverse_dynamics_second_derivatives(q, qd, qdd);
    e.set("friction_vector", Vector2::zeros());
    e.set("spring_vector", Vector2::zeros());
    e.set("coriolis_matrix", numeric.coriolis_matrix(q, qd));
    e.set("coriolis_coefficients", coriolis);
    e.set("centrifugal_coefficients", centrifugal);
    e.set("configuration_space_form", numeric.coriolis_vector(q, qd));
    e.set("forward_kinematics", numeric.forward_kinematics(q));
    e.set("link_poses", numeric.link_poses(q));
    e.set("jacobian", jacobian);
    e.set("regressor_form", torque);
    e.set("inverse_dynamics_derivatives", force_derivatives(state));
    e.set(
        "forward_dynamics_derivatives",
        acceleration_derivatives(state),
    );
    e.set("inverse_dynamics_second_derivatives", second);
    e.set("forward_dynamics_aba", *qdd);
    e.set("taylor_series", taylor_series(state));
    e.set(
        "wrench_torques",
        jacobian.transpose() * State::<2>::wrench(),
    );
    e.set("tool_velocity", jacobian * qd);
    e.set("tool_acceleration", jacobian * qdd + jacobian_rate * qd);
    e.set("jacobian_rate", jacobian_rate);
    e.set("link_jacobians", numeric.link_jacobians(q));
    e.set("center_of_mass", numeric.center_of_mass(q));
    e.set(
        "center_of_mass_jacobian",
        numeric.center_of_mass_jacobian(q),
    );
    e.set(
        "centroidal_momentum_matrix",
        numeric.centroidal_momentum_matrix(q),
    );
    e.set(
        "centroidal_momentum_bias",
        numeric.centroidal_momentum_bias(q, qd),
    );
    e.set(
        "operational_inertia_inverse",
        jacobian * inverse * jacobian.transpose(),
    );
    e.set("generalized_momentum", numeric.mass_matrix(q) * qd);
    e.set("momentum_bias", momentum_bias);
    e.set("passivity_torque", passivity(state));
    e.set("passivity_form", passivity(state));
    e.set(
        "energies_form",
        (numeric.kinetic_energy(q, qd), numeric.potential_energy(q)),
    );
    e.set("inverse_dynamics_rates", rates);
}

/// The rows of what is compared by itself.
fn compared() -> impl Iterator<Item = &'static Row<f64>> {
    let rows = Row::<f64>::ALL.iter();
    rows.filter(|row| !matches!(row.rule, Rule::FactorOf(..)))
}

#[test]
fn every_function_has_a_row() {
    let rows: Vec<_> = Row::<f64>::ALL.iter().map(|row| row.name).collect();
    let names = NAMES.iter().chain(&FORMS);
    let without: Vec<_> = names.filter(|name| !rows.contains(name)).collect();
    assert!(without.is_empty(), "no row: {without:?}");
    assert_eq!(rows.len(), NAMES.len() + FORMS.len());
}

#[test]
fn every_right_value_passes() {
    let report = check(complete);
    report.assert_ok();
    assert_eq!(report.functions.len(), compared().count());
}

/// A change of any number of any function is found, in this function and in no other: a change far above the tolerance and
/// far below that of a wrong term.
#[test]
fn every_entry_of_every_function_is_compared() {
    let (table, numeric) = (CRAIG_ARM.table(), numeric());
    let state: State<2> = random_state(5);
    let tau = numeric.inverse_dynamics(&state.q, &state.qd, &state.qdd);
    let (table, any_state) = (RuntimeTable::from(&table), of_any_size(&state));
    let (numeric, torques) = (NumericArm::on_any_base(&table), any_vector(&tau));
    let base = Pose::identity();
    let footing = numeric.footing(&base);
    let at = At::new(
        numeric.placed(&footing),
        &table,
        (&base, &any_state),
        &torques,
    );
    let mut right = CRAIG_ARM.evaluate(&state, &tau);
    complete(&state, &mut right);
    let wrong = |values: &Evaluation| {
        let deviations = deviations(values, &at).into_iter();
        let wrong = deviations.filter(|found| found.error.is_none_or(|error| error > 2e-13));
        wrong.map(|found| found.function).collect::<Vec<_>>()
    };
    assert!(wrong(&right).is_empty());
    for row in compared() {
        let entries: Vec<f64> = right.get(row.name).expect(row.name);
        // A series is compared up to the jerk.
        let asked_for = if row.name == "taylor_series" {
            8
        } else {
            entries.len()
        };
        for k in 0..asked_for {
            let scale = match row.rule {
                Rule::Beside(_, unit) => unit(&at, k).0,
                _ => 1.0,
            };
            let mut damaged = entries.clone();
            // Where there is no friction, anything but zero is wrong.
            damaged[k] += f64::max(1e-9 * scale, 1e-300);
            let mut values = right.clone();
            values.set(row.name, damaged);
            assert_eq!(wrong(&values), [row.name], "entry {k}");
        }
    }
}

/// An arm with a frame on its first link, and the values of two functions there.
struct Framed {
    /// A number that is added to the Jacobian.
    damage: f64,
    /// The place of the frame in the table, where there is one frame.
    frame: usize,
}

impl Model<2> for Framed {
    const JOINT_NAMES: [&'static str; 2] = CraigArm::JOINT_NAMES;

    fn table(&self) -> Table<2> {
        let place = Placement::of_frames(&[Frame {
            xyz: [0.1, 0.2, 0.3],
            rpy: [0.4, 0.5, 0.6],
        }]);
        Table {
            frames: [FixedFrame::new(Some(0), place)][..].into(),
            ..CRAIG_ARM.table()
        }
    }
}

impl Evaluate<2> for Framed {
    fn evaluate(&self, state: &State<2>, _: &SVector<f64, 2>) -> Evaluation {
        let numeric = NewtonEuler::new(&self.table());
        let mut evaluation = Evaluation::default();
        let at_frame = evaluation.at_frame("elbow", self.frame);
        let jacobian = numeric.frame_jacobian(0, &state.q);
        at_frame.set("jacobian", jacobian.add_scalar(self.damage));
        at_frame.set("forward_kinematics", numeric.frame_pose(0, &state.q));
        evaluation
    }
}

#[test]
fn functions_are_compared_at_their_frames() {
    let check = |damage, frame| Check::new().samples(5).run(&Framed { damage, frame });
    let report = check(0.0, 0);
    report.assert_ok();
    let names: Vec<_> = report.functions.iter().map(ToString::to_string).collect();
    assert!(
        names[0].starts_with("forward_kinematics_elbow:"),
        "{names:?}"
    );
    assert!(names[1].starts_with("jacobian_elbow:"), "{names:?}");
    assert_eq!(wrong(&check(1e-9, 0)), ["jacobian"]);

    let report = check(0.0, 1);
    assert_eq!(report.not_compared, ["forward_kinematics", "jacobian"]);
    assert!(report.to_string().contains("no such frame"), "{report}");

    let state = random_state(3);
    let framed = Framed {
        damage: 0.0,
        frame: 0,
    };
    let values = framed.evaluate(&state, &Vector2::zeros());
    let jacobian: SMatrix<f64, 6, 2> = values.get("jacobian_elbow").expect("it was set");
    assert_eq!(
        jacobian,
        NewtonEuler::new(&framed.table()).frame_jacobian(0, &state.q)
    );
    assert_eq!(values.get::<SMatrix<f64, 6, 2>>("jacobian"), None);
}

/// C qd is V still: C' is no matrix of Christoffel symbols, though.
#[test]
fn another_coriolis_matrix_fails() {
    let report = check(|State { q, qd, .. }, e| {
        let shift = Matrix2::new(qd[1], -qd[0], 0.0, 0.0) * 1e-9;
        e.set("coriolis_matrix", numeric().coriolis_matrix(q, qd) + shift);
    });
    assert_eq!(wrong(&report), ["coriolis_matrix"]);
}

/// The first coefficients of a series are those of its start, to the last digit.
#[test]
fn a_series_from_elsewhere_fails() {
    let damages: [fn(&State<2>, &mut Evaluation); 3] = [
        |state, e| e.set("taylor_series", shifted(state, 0)),
        |state, e| e.set("taylor_series", shifted(state, 1)),
        |state, e| e.set("taylor_series", shifted(state, 2)),
    ];
    for damage in damages {
        assert_eq!(wrong(&check(damage)), ["taylor_series"]);
    }
}

fn shifted(state: &State<2>, order: usize) -> TaylorCoefficients<f64, 2> {
    let mut series = taylor_series(state);
    series[order][1] += 1e-9;
    series
}

/// One base parameter that is the torque itself, and one that is a coefficient.
#[test]
fn combinations_take_both_functions() {
    let state = State {
        q: Vector2::new(0.3, 0.4),
        qd: Vector2::new(2.0, -3.0),
        qdd: Vector2::zeros(),
    };
    let combined = |e: &Evaluation, name: &str| -> Option<Vector2<f64>> {
        e.clone().combined(state.qd.as_slice()).get(name)
    };
    let mut e = Evaluation::default();
    let columns = vec![Vector2::new(1.0, 2.0), Vector2::new(0.0, 1.0)];
    e.set("regressor", columns.clone());
    e.set("passivity_regressor", columns);
    e.set(
        "energy_regressors",
        (Vector2::new(2.0, 1.0), Vector2::new(0.0, -1.0)),
    );
    let forms = ["regressor_form", "passivity_form", "energies_form"];
    assert_eq!(forms.map(|form| combined(&e, form)), [None; 3]);
    e.set("base_parameters", Vector2::new(3.0, 5.0));
    let expected = [(3.0, 11.0), (3.0, 11.0), (11.0, -5.0)];
    let expected = expected.map(|(a, b)| Some(Vector2::new(a, b)));
    assert_eq!(forms.map(|form| combined(&e, form)), expected);

    let (coriolis, centrifugal) = coefficients(&state);
    e.set("coriolis_coefficients", vec![coriolis]);
    assert_eq!(combined(&e, "configuration_space_form"), None);
    e.set("centrifugal_coefficients", centrifugal);
    let found = combined(&e, "configuration_space_form").unwrap();
    let expected = numeric().coriolis_vector(&state.q, &state.qd);
    assert!((found - expected).amax() < 1e-12, "{found} {expected}");
}

/// A value has the shape that it is asked for in, or there is a panic.
#[test]
fn values_are_read_in_their_shapes() {
    let mut e = Evaluation::default();
    e.set("link_jacobians", [Matrix2::new(1.0, 2.0, 3.0, 4.0); 2]);
    let columns: Vec<Vector2<f64>> = e.get("link_jacobians").unwrap();
    assert_eq!(
        columns[2..],
        [Vector2::new(1.0, 3.0), Vector2::new(2.0, 4.0)]
    );
    let (first, rest): (f64, Vec<f64>) = e.get("link_jacobians").unwrap();
    assert_eq!((first, rest.len()), (1.0, 7));
    let refusal = SingularMassMatrix::new(1, 0.0);
    e.set("forward_dynamics", Err::<f64, _>(refusal));
    assert_eq!(e.get::<f64>("forward_dynamics"), None);
    assert_eq!(e.get("forward_dynamics"), Some(Err::<f64, _>(refusal)));
}

#[test]
#[should_panic(expected = "`mass_matrix` has 4 numbers here")]
fn a_value_of_another_size_panics() {
    let mut e = Evaluation::default();
    e.set("mass_matrix", Matrix2::identity());
    let _: Option<Vector2<f64>> = e.get("mass_matrix");
}

#[test]
#[should_panic(expected = "`mas_matrix` is not the name of a function")]
fn a_name_of_no_function_panics() {
    Evaluation::default().set("mas_matrix", 1.0);
}

/// The product is compared: one factor alone is not, and that is said.
#[test]
fn a_regressor_without_base_parameters_is_not_compared() {
    let report = check(|_, e| e.set("regressor", Vec::<f64>::new()));
    report.assert_ok();
    assert_eq!(report.not_compared, ["regressor"]);
    let line = "\nregressor: not compared at any state (that takes `base_parameters` too)";
    assert!(report.to_string().contains(line), "{report}");
}

#[test]
fn a_value_that_is_not_a_number_fails() {
    let report = check(|_, e| e.set("potential_energy", f64::NAN));
    assert_eq!(wrong(&report), ["potential_energy"]);
    let report = check(|state, e| {
        let mut mass_matrix = CRAIG_ARM.mass_matrix(&state.q);
        mass_matrix[(0, 1)] = f64::NAN;
        e.set("mass_matrix", mass_matrix);
    });
    assert_eq!(wrong(&report), ["mass_matrix"]);
    assert_eq!(report.functions[0].joint, Some(0));
}

#[test]
fn a_refusal_fails_where_the_mass_matrix_is_regular() {
    let report = check(|_, e| {
        e.set(
            "forward_dynamics",
            Err::<f64, _>(SingularMassMatrix::new(1, 0.0)),
        );
    });
    assert_eq!(wrong(&report), ["forward_dynamics"]);
    let function = report.functions.iter().find(|f| !f.is_ok()).unwrap();
    assert_eq!(function.joint, Some(1));
}

/// Without the outer mass the mass matrix is singular, and refusing it is right.
#[test]
fn a_refusal_passes_where_the_mass_matrix_is_singular() {
    let massless = CraigArm {
        m2: 0.0,
        ..CRAIG_ARM
    };
    let report = check_against_rnea(&massless);
    report.assert_ok();
    let names = report.functions.iter().map(|f| f.function);
    assert!(!names.collect::<Vec<_>>().contains(&"forward_dynamics"));
    assert_eq!(report.not_compared, ["forward_dynamics"]);
}

/// A joint that moves a thousandth of a millionth of the largest inertia is small, not singular.
#[test]
fn a_refusal_fails_where_one_inertia_is_small() {
    let light = CraigArm {
        m2: 1e-8,
        ..CRAIG_ARM
    };
    let m = light.mass_matrix(&Vector2::zeros());
    assert!(m[(1, 1)] < 1e-9 * m[(0, 0)]);
    let refusal = SingularMassMatrix::new(1, 0.0);
    let error = |m: &Matrix2<f64>| {
        let m = DMatrix::from_column_slice(2, 2, m.as_slice());
        refused("forward_dynamics", &m, &refusal).error
    };
    assert_eq!(error(&m), Some(f64::INFINITY));
    let vanishing = Matrix2::new(4e-33, 0.0, 0.0, 0.7);
    assert_eq!(error(&vanishing), None);
}

#[test]
fn columns_that_are_missing_or_too_many_fail() {
    let report = check(|_, e| e.set("coriolis_coefficients", Vec::<f64>::new()));
    assert_eq!(wrong(&report), ["coriolis_coefficients"]);
    let report = check(|state, e| {
        e.set("coriolis_coefficients", [coefficients(state).0; 2]);
    });
    assert_eq!(wrong(&report), ["coriolis_coefficients"]);
}

#[test]
fn a_function_compared_at_one_state_is_compared() {
    let report = check(|state, e| {
        if state.q[0] > 0.0 {
            e.remove("mass_matrix");
        }
    });
    assert!(report.not_compared.is_empty());
    assert!(!report.to_string().contains("not compared"));
}

#[test]
fn the_report_names_the_state_of_the_largest_error() {
    let report = check(|state, e| {
        if state.q[0] > 100.0 {
            let gravity = CRAIG_ARM.gravity_vector(&state.q);
            e.set("gravity_vector", gravity + Vector2::new(0.0, state.q[0]));
        }
    });
    let function = report.functions.iter().find(|f| !f.is_ok()).unwrap();
    assert_eq!(
        (function.function, function.joint),
        ("gravity_vector", Some(1))
    );
    assert!(function.label.starts_with("large angles"));
    assert!(function.q[0] > 100.0);
}

#[test]
fn the_printed_report_is_a_table() {
    let report = check(|_, e| e.set("kinetic_energy", -1.0));
    let text = report.to_string();
    let lines: Vec<&str> = text.lines().collect();
    assert!(lines[0].starts_with("comparison with recursive Newton-Euler at 40 states (seed 0)"));
    // The name of the state starts where its heading does.
    let column = lines[1].rfind("state").unwrap();
    let labels = [
        "zero", "pi/2", "-pi/2", "right", "large", "at rest", "random",
    ];
    for line in &lines[2..10] {
        assert!(
            labels.iter().any(|label| line[column..].starts_with(label)),
            "{text}"
        );
    }
    assert_eq!(
        lines.iter().filter(|line| line.contains("WRONG")).count(),
        1
    );
    assert!(text.contains("kinetic_energy: error") && text.contains("qdd = ["));
    // All states in the alternate form.
    assert_eq!(format!("{report:#}").matches("qdd = [").count(), 8);
}

/// Where the numbers that are compared with are not finite, nothing is known of the function.
#[test]
fn numbers_that_overflow_are_told_as_such() {
    struct Heavy;
    impl Model<2> for Heavy {
        const JOINT_NAMES: [&'static str; 2] = CraigArm::JOINT_NAMES;

        fn table(&self) -> Table<2> {
            let mut table = CRAIG_ARM.table();
            table.rows[1].mass = 1e308;
            table
        }
    }
    impl Evaluate<2> for Heavy {
        fn evaluate(&self, state: &State<2>, tau: &SVector<f64, 2>) -> Evaluation {
            let mut evaluation = CRAIG_ARM.evaluate(state, tau);
            evaluation.set("inverse_dynamics", SVector::from([f64::NAN; 2]));
            evaluation
        }
    }
    let report = Check::new().samples(20).run(&Heavy);
    assert!(!report.is_ok());
    let torques = report
        .functions
        .iter()
        .find(|row| row.function == "inverse_dynamics");
    assert!(torques.is_some_and(|row| row.overflows && row.error == f64::INFINITY));
    assert!(report.to_string().contains("overflow"), "{report}");
}

#[test]
#[should_panic(expected = "WRONG")]
fn assertion_panics_with_the_report() {
    check(|_, e| e.set("kinetic_energy", -1.0)).assert_ok();
}

#[test]
fn a_report_of_nothing_is_not_ok() {
    let report = check(|_, e| *e = Evaluation::default());
    assert!(!report.is_ok());
    assert!(report.to_string().contains("no function"));
}

/// The rates of the torques are limits of differences along the motion.
#[test]
fn rates_are_limits_of_differences() {
    let start = State {
        q: SVector::from([0.3, -0.8]),
        qd: SVector::from([1.1, 0.4]),
        qdd: SVector::from([-0.7, 2.0]),
    };
    let (jerk, snap) = (SVector::from([0.9, -1.3]), SVector::from([2.1, 0.6]));
    let torque = |t: f64| {
        let q = start.q
            + start.qd * t
            + start.qdd * (t * t / 2.0)
            + jerk * (t.powi(3) / 6.0)
            + snap * (t.powi(4) / 24.0);
        let qd = start.qd + start.qdd * t + jerk * (t * t / 2.0) + snap * (t.powi(3) / 6.0);
        let qdd = start.qdd + jerk * t + snap * (t * t / 2.0);
        numeric().inverse_dynamics(&q, &qd, &qdd)
    };
    let State { q, qd, qdd } = start;
    let (first, second) = numeric().inverse_dynamics_rates(&q, &qd, &qdd, &jerk, &snap);
    let h = 1e-3;
    let difference = (torque(h) - torque(-h)) / (2.0 * h);
    let curvature = (torque(h) - torque(0.0) * 2.0 + torque(-h)) / (h * h);
    // The differences err by h^2 times higher derivatives.
    assert!((first - difference).amax() < 1e-4 * first.amax());
    assert!((second - curvature).amax() < 1e-4 * second.amax());
}
