//! Every function at many states at once beside single calls: on one core and on all, at `f64` and `f32`,
//! for batches shorter and longer than the lanes, with one arm and with an arm for each state.

#[macro_use]
#[path = "../../testkit/robots/src/functions.rs"]
mod functions;

mod arms;
mod compare;
mod each;
mod states;

use arms::{CRANE, Crane, Strut, Wrist};
use compare::{Outcome, compare};
use robot_dynamics::nalgebra::{Matrix2, Matrix3, SMatrix, Vector2, Vector3};
use robot_dynamics::{Batch, batch::BatchError};
use states::States;

/// Shorter than the lanes, as long, longer by one, and with a remainder, of four to sixteen lanes.
const COUNTS: [usize; 12] = [0, 1, 3, 4, 5, 7, 8, 9, 15, 16, 17, 43];

/// Compares the functions of a list, called by `$batch`, with single calls of the arm of each state.
macro_rules! compare_all {
    ({ $number:ident, $states:ident, $arm:expr, $many:expr } $($name:ident $batch:ident $par:ident [$($argument:ident),*])*) => {$({
        let count = $states.q.len();
        let at = |i: usize| $arm(i).$name::<$number>($(argument!($argument: one $states i)),*).outcome();
        let single: Vec<_> = (0..count).map(at).collect();
        compare(stringify!($name), &single, |out| {
            let done = $many.$batch($(argument!($argument: all $states),)* out);
            done.map_err(BatchError::from)
        });
        compare(stringify!($par), &single, |out| {
            let done = $many.$par($(argument!($argument: all $states),)* out);
            done.map_err(BatchError::from)
        });
        if let (false, Some(Ok(value))) = (stringify!($($argument)*).is_empty(), single.first()) {
            let mut out = vec![*value; count + 1];
            let done = $many.$batch($(argument!($argument: all $states),)* &mut out);
            let Err(BatchError::Length(mismatch)) = done.map_err(BatchError::from) else {
                panic!("{}: another length is taken", stringify!($name));
            };
            assert_eq!((mismatch.found, mismatch.expected), (count + 1, count));
        }
    })*};
}

/// An argument of one state, or of all.
macro_rules! argument {
    (order: one $states:ident $i:ident) => {
        5
    };
    (order: all $states:ident) => {
        5
    };
    ($name:ident: one $states:ident $i:ident) => {
        &$states.$name[$i]
    };
    ($name:ident: all $states:ident) => {
        &$states.$name
    };
}

#[test]
fn every_function_in_double_precision() {
    for count in COUNTS {
        let states = States::<f64, 2>::random(count, 1);
        each_batch! { compare_all { f64, states, |_| &CRANE, CRANE } }
    }
}

#[test]
fn every_function_in_single_precision() {
    for count in COUNTS {
        let states = States::<f32, 2>::random(count, 2);
        each_batch! { compare_all { f32, states, |_| &CRANE, CRANE } }
    }
}

#[test]
fn every_function_with_an_arm_for_each_state() {
    for count in COUNTS {
        let states = States::<f64, 2>::random(count, 3);
        let arms: Vec<Crane> = (0..count).map(Crane::numbered).collect();
        each_batch! { compare_all { f64, states, |i: usize| &arms[i], Crane::with_parameters(&arms) } }
    }
}

#[test]
fn another_number_of_arms_than_of_states_is_an_error() {
    let states = States::<f64, 2>::random(5, 3);
    let arms: Vec<Crane> = (0..4).map(Crane::numbered).collect();
    let mut out = vec![Vector2::repeat(7.0); 5];
    let many = Batch::with_parameters(&arms);
    let error = many.gravity_vector_batch(&states.q, &mut out).unwrap_err();
    assert_eq!(
        error.to_string(),
        "`parameters` has 4 states where `q` has 5"
    );
    assert!(out.iter().all(|x| *x == Vector2::repeat(7.0)));
    let error = Wrist
        .friction_vector_batch(&[Vector3::<f64>::zeros(); 2], &mut [])
        .unwrap_err();
    assert_eq!(
        error.to_string(),
        "`friction_vector` has 0 states where `qd` has 2"
    );
}

/// Tuples of sinks, columns for each entry, arrays of them: every arrangement of values is the same numbers.
#[test]
fn results_lie_where_they_like() {
    let states = States::<f64, 3>::random(21, 4);
    let States { q, qd, qdd, .. } = &states;
    let mut together = vec![(Matrix3::zeros(), Matrix3::zeros()); 21];
    Wrist
        .inverse_dynamics_derivatives_batch(q, qd, qdd, &mut together)
        .unwrap();
    let mut by_position = vec![Matrix3::zeros(); 21];
    let mut columns: [[Vec<f64>; 3]; 3] = [(); 3].map(|()| [(); 3].map(|()| vec![0.0; 21]));
    let by_velocity = columns.each_mut().map(|c| c.each_mut().map(|c| &mut c[..]));
    Wrist
        .par_inverse_dynamics_derivatives_batch(q, qd, qdd, (&mut by_position, by_velocity))
        .unwrap();
    for (state, (a, b)) in together.iter().enumerate() {
        assert_eq!(*a, by_position[state]);
        assert_eq!(
            *b,
            SMatrix::<f64, 3, 3>::from_fn(|i, j| columns[j][i][state])
        );
    }
    let mut poses = vec![[SMatrix::zeros(); 3]; 21];
    Wrist.link_poses_batch(q, &mut poses).unwrap();
    let [mut a, mut b, mut c] = [(); 3].map(|()| vec![SMatrix::zeros(); 21]);
    Wrist.link_poses_batch(q, [&mut a, &mut b, &mut c]).unwrap();
    for state in 0..21 {
        assert_eq!(poses[state], [a[state], b[state], c[state]]);
    }
    // Rows have the digits of columns.
    let mut columns = [(); 3].map(|()| [(); 4].map(|()| [(); 4].map(|()| vec![0.0; 21])));
    let views = columns.each_mut().map(|pose| {
        pose.each_mut()
            .map(|column| column.each_mut().map(|entry| &mut entry[..]))
    });
    Wrist.link_poses_batch(q, views).unwrap();
    for state in 0..21 {
        let single = Wrist.link_poses(&q[state]);
        for ((pose, columns), single) in poses[state].iter().zip(&columns).zip(single) {
            let by_columns = SMatrix::<f64, 4, 4>::from_fn(|i, j| columns[j][i][state]);
            assert_eq!(*pose, by_columns);
            assert!((pose - single).amax() < 1e-14, "{pose} {single}");
        }
    }
    let mut short = vec![Matrix3::zeros(); 20];
    let error = Wrist
        .inverse_dynamics_derivatives_batch(q, qd, qdd, (&mut by_position, &mut short))
        .unwrap_err();
    assert_eq!(
        (error.argument, error.found),
        ("inverse_dynamics_derivatives", 20)
    );
}

/// Several functions as one have batches too.
#[test]
fn tuples_of_functions_have_batches() {
    let states = States::<f64, 3>::random(19, 5);
    let States { q, qd, tau, .. } = &states;
    let single = |i: usize| Wrist.control_terms(&q[i], &qd[i]).outcome();
    let single: Vec<_> = (0..19).map(single).collect();
    compare("control_terms", &single, |out| {
        Ok(Wrist.control_terms_batch(q, qd, out)?)
    });
    let single = |i: usize| Wrist.motion(&q[i], &qd[i], &tau[i]).outcome();
    let single: Vec<_> = (0..19).map(single).collect();
    compare("motion", &single, |out| Wrist.motion_batch(q, qd, tau, out));
    compare("motion", &single, |out| {
        Wrist.par_motion_batch(q, qd, tau, out)
    });
}

/// Stretched, the arm has no inertia along itself.
#[test]
fn a_singular_state_spoils_no_other() {
    for singular in [0, 6, 20] {
        let mut states = States::<f64, 2>::random(21, 6);
        for (i, q) in states.q.iter_mut().enumerate() {
            q[1] = if i == singular { 0.0 } else { 0.5 + q[1].abs() };
        }
        macro_rules! refusing {
            ($($name:ident $batch:ident $par:ident [$($argument:ident),*])*) => {
                compare_all! { { f64, states, |_| &Strut, Strut } $($name $batch $par [$($argument),*])* }
            };
        }
        refusing! {
            forward_dynamics forward_dynamics_batch par_forward_dynamics_batch [q, qd, tau]
            forward_dynamics_derivatives forward_dynamics_derivatives_batch
                par_forward_dynamics_derivatives_batch [q, qd, tau]
            forward_dynamics_aba forward_dynamics_aba_batch par_forward_dynamics_aba_batch [q, qd, tau]
            operational_inertia_inverse operational_inertia_inverse_batch
                par_operational_inertia_inverse_batch [q]
            taylor_series taylor_series_batch par_taylor_series_batch [q, qd, tau, order]
        }
    }
}

/// A few hundred states of a function that takes some hundred operations are shared by all cores, and are what
/// one core puts out.
#[test]
fn all_cores_put_out_what_one_does() {
    let states = States::<f64, 3>::random(700, 7);
    let States { q, qd, tau, .. } = &states;
    let mut one = vec![(Matrix3::zeros(), Matrix3::zeros(), Matrix3::zeros()); 700];
    let mut all = one.clone();
    Wrist
        .forward_dynamics_derivatives_batch(q, qd, tau, &mut one)
        .unwrap();
    Wrist
        .par_forward_dynamics_derivatives_batch(q, qd, tau, &mut all)
        .unwrap();
    assert_eq!(one, all);
    let mut inertia = vec![Matrix2::<f32>::zeros(); 3000];
    let states = States::<f32, 2>::random(3000, 8);
    CRANE
        .par_mass_matrix_batch(&states.q, &mut inertia)
        .unwrap();
    for (q, inertia) in states.q.iter().zip(&inertia) {
        assert!((CRANE.mass_matrix(q) - inertia).amax() <= 1e-6 * inertia.amax());
    }
}
