//! States without accelerations, numbers that are none, angles of many turns, arguments that do
//! not fit.

use robot_dynamics::nalgebra::{Const, Dyn, OMatrix, Vector2, Vector6};
use robot_dynamics::{
    Batch,
    batch::{BatchError, LengthMismatch},
};
use robots::Puma560;

use super::arms::Strut;
use super::values::{States, Values, assert_same, columns};

/// States of the strut, stretched where told.
fn strut_states(count: usize, stretched: &[usize]) -> States<2> {
    let mut states = States::random(count, 3);
    for (i, q) in states.q.iter_mut().enumerate() {
        q[1] = if stretched.contains(&i) {
            0.0
        } else {
            0.5 + q[1].abs()
        };
    }
    states
}

#[test]
fn a_singular_state_spoils_no_other() {
    for stretched in [&[5, 11, 12][..], &[0], &[19], &[18, 19]] {
        let states = strut_states(20, stretched);
        let single = Values::single(&Strut, &states);
        for values in [
            Values::by_rows(&Strut, &states),
            Values::by_columns(&Strut, &states),
        ] {
            let state = stretched[0];
            let error = Strut
                .forward_dynamics(&states.q[state], &states.qd[state], &states.x[state])
                .unwrap_err();
            assert_eq!(values.error, Some(BatchError::Singular { state, error }));
            for (i, (a, b)) in values
                .forward_dynamics
                .iter()
                .zip(&single.forward_dynamics)
                .enumerate()
            {
                if stretched.contains(&i) {
                    assert!(a.iter().all(|x| x.is_nan()), "{i}: {a}");
                } else {
                    assert!((a - b).amax() <= 1e-14 * b.amax(), "{i}: {a} {b}");
                }
            }
        }
    }
}

#[test]
fn a_singular_state_is_found_in_a_batch_shorter_than_the_lanes() {
    let states = strut_states(3, &[1]);
    let values = Values::by_rows(&Strut, &states);
    assert!(matches!(
        values.error,
        Some(BatchError::Singular { state: 1, .. })
    ));
    assert!(values.forward_dynamics[0].iter().all(|x| x.is_finite()));
    assert!(values.forward_dynamics[1].iter().all(|x| x.is_nan()));
    let text = values.error.unwrap().to_string();
    assert!(
        text.starts_with("state 1: the mass matrix is not positive definite at joint 1"),
        "{text}"
    );
}

/// The batch at these states, state 9 but for `change`, beside single calls; the other states'
/// values must be what they were.
fn with_one_changed(change: impl Fn(&mut States<6>)) -> [Values<6>; 2] {
    let mut states = States::random(20, 11);
    let before = Values::by_rows(&Puma560, &states);
    change(&mut states);
    let after = Values::by_rows(&Puma560, &states);
    assert_same(&after, &Values::by_columns(&Puma560, &states));
    for ((function, a), (_, b)) in before.numbers().into_iter().zip(after.numbers()) {
        for (i, (a, b)) in a.iter().zip(&b).enumerate().filter(|(i, _)| *i != 9) {
            let size = a.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
            let same = a.iter().zip(*b).all(|(a, b)| (a - b).abs() <= 2e-13 * size);
            assert!(same, "{function} of state {i}: {a:?} {b:?}");
        }
    }
    [after, Values::single(&Puma560, &states)]
}

#[test]
fn an_angle_of_many_turns_is_reduced_exactly() {
    for angle in [1.0e5, 1.1e5, -3.7e7, 1e22, f64::MAX] {
        let [batch, single] = with_one_changed(|states| states.q[9][2] = angle);
        assert_eq!(batch.error, None);
        for ((function, a), (_, b)) in batch.numbers().into_iter().zip(single.numbers()) {
            let size = b[9].iter().fold(0.0_f64, |size, x| size.max(x.abs()));
            let near = a[9]
                .iter()
                .zip(b[9])
                .all(|(a, b)| (a - b).abs() <= 2e-13 * size);
            assert!(near, "{function} at {angle:e}: {:?} {:?}", a[9], b[9]);
        }
    }
}

#[test]
fn what_is_not_finite_stays_in_its_state() {
    for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let [batch, single] = with_one_changed(|states| states.q[9][1] = x);
        for ((function, a), (_, b)) in batch.numbers().into_iter().zip(single.numbers()) {
            let agree = a[9].iter().zip(b[9]).all(|(a, b)| a.is_nan() == b.is_nan());
            assert!(agree, "{function}: {:?} {:?}", a[9], b[9]);
        }
        let joint = |error: Option<BatchError>| match error {
            Some(BatchError::Singular { state: 9, error }) => error.joint,
            other => panic!("{other:?}"),
        };
        assert_eq!(joint(batch.error), joint(single.error));
        let [batch, single] = with_one_changed(|states| states.qd[9][3] = x);
        assert_eq!(batch.error, single.error);
        for (a, b) in batch.inverse_dynamics[9]
            .iter()
            .zip(&single.inverse_dynamics[9])
        {
            assert_eq!(a.is_finite(), b.is_finite());
        }
    }
}

#[test]
fn lengths_that_differ_are_named_and_nothing_is_written() {
    let states = States::<6>::random(9, 1);
    let mut out = vec![Vector6::repeat(7.0); 9];
    let error = Puma560
        .inverse_dynamics_batch(&states.q, &states.qd[..8], &states.x, &mut out)
        .unwrap_err();
    let expected = LengthMismatch {
        argument: "qd",
        found: 8,
        expected: 9,
    };
    assert_eq!(error, expected);
    assert_eq!(error.to_string(), "`qd` has 8 states where `q` has 9");
    let error = Puma560
        .forward_dynamics_batch(&states.q, &states.qd, &states.x, &mut out[..1])
        .unwrap_err();
    let expected = LengthMismatch {
        argument: "qdd",
        found: 1,
        expected: 9,
    };
    assert_eq!(error, BatchError::Length(expected));
    assert!(out.iter().all(|x| *x == Vector6::repeat(7.0)));
    let none: &[Vector6<f64>] = &[];
    let error = Puma560.gravity_vector_batch(none, &mut out).unwrap_err();
    assert_eq!(
        (error.argument, error.found, error.expected),
        ("gravity_vector", 9, 0)
    );
}

#[test]
fn columns_that_differ_among_themselves_are_named() {
    let (long, short) = ([0.0; 9], [0.0; 4]);
    let mut out = [[0.0; 9]; 2];
    let out = out.each_mut().map(|column| &mut column[..]);
    let error = Strut
        .gravity_vector_batch([&long[..], &short], out)
        .unwrap_err();
    assert_eq!((error.argument, error.found, error.expected), ("q", 4, 9));
    let mut entries = [[vec![0.0; 9], vec![0.0; 9]], [vec![0.0; 9], vec![0.0; 8]]];
    let out = entries
        .each_mut()
        .map(|columns| columns.each_mut().map(|c| &mut c[..]));
    let error = Strut
        .mass_matrix_batch([&long[..], &long], out)
        .unwrap_err();
    assert_eq!(
        (error.argument, error.found, error.expected),
        ("mass_matrix", 8, 9)
    );
}

/// A matrix of a row for each state is a column for each joint; layouts may differ.
#[test]
fn arguments_may_be_matrices_and_arrays() {
    let q = [
        Vector2::new(0.3, 1.0),
        Vector2::new(-0.2, 2.0),
        Vector2::new(1.5, 0.7),
    ];
    let matrix = OMatrix::<f64, Dyn, Const<2>>::from_fn(3, |i, j| q[i][j]);
    let mut expected = [Vector2::zeros(); 3];
    Strut.gravity_vector_batch(&q, &mut expected).unwrap();
    let mut found = OMatrix::<f64, Dyn, Const<2>>::zeros(3);
    Strut.gravity_vector_batch(&matrix, &mut found).unwrap();
    for (i, expected) in expected.iter().enumerate() {
        assert_eq!(found.row(i).transpose(), *expected);
    }
    let mut mixed = vec![Vector2::zeros(); 3];
    Strut.gravity_vector_batch(&matrix, &mut mixed).unwrap();
    assert_eq!(mixed, expected);
    let mut vectors = [vec![0.0; 3], vec![0.0; 3]];
    Strut
        .gravity_vector_batch(&columns(&q), &mut vectors)
        .unwrap();
    assert_eq!(vectors, columns(&expected));
    let mut none = OMatrix::<f64, Dyn, Const<2>>::zeros(0);
    Strut
        .gravity_vector_batch(&none.clone(), &mut none)
        .unwrap();
}
