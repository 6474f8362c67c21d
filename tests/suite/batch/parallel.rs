//! All cores put out what one does.

use robot_dynamics::nalgebra::{SMatrix, SVector};
use robot_dynamics::{Batch, batch::BatchError};
use robots::Puma560;

use super::arms::Strut;
use super::values::{States, Values, assert_same};

#[test]
fn all_cores_put_out_what_one_does() {
    for count in [0, 5, 1023, 1024, 5003] {
        let states = States::<6>::random(count, 17);
        let States { q, qd, x } = &states;
        let vectors = vec![SVector::zeros(); count];
        let mut values = Values {
            mass_matrix: vec![SMatrix::zeros(); count],
            coriolis_vector: vectors.clone(),
            gravity_vector: vectors.clone(),
            inverse_dynamics: vectors.clone(),
            forward_dynamics: vectors,
            error: None,
        };
        Puma560
            .par_mass_matrix_batch(q, &mut values.mass_matrix)
            .unwrap();
        Puma560
            .par_coriolis_vector_batch(q, qd, &mut values.coriolis_vector)
            .unwrap();
        Puma560
            .par_gravity_vector_batch(q, &mut values.gravity_vector)
            .unwrap();
        Puma560
            .par_inverse_dynamics_batch(q, qd, x, &mut values.inverse_dynamics)
            .unwrap();
        Puma560
            .par_forward_dynamics_batch(q, qd, x, &mut values.forward_dynamics)
            .unwrap();
        assert_same(&values, &Values::by_rows(&Puma560, &states));
    }
}

#[test]
fn the_first_singular_state_of_all_cores_is_named() {
    for singular in [&[4000, 100][..], &[2777, 4999], &[4998]] {
        let mut states = States::<2>::random(5000, 19);
        for (i, q) in states.q.iter_mut().enumerate() {
            q[1] = if singular.contains(&i) {
                0.0
            } else {
                0.5 + q[1].abs()
            };
        }
        let States { q, qd, x } = &states;
        let mut qdd = vec![SVector::zeros(); 5000];
        let error = Strut
            .par_forward_dynamics_batch(q, qd, x, &mut qdd)
            .unwrap_err();
        let first = *singular.iter().min().unwrap();
        assert!(
            matches!(error, BatchError::Singular { state, .. } if state == first),
            "{error}"
        );
        for (i, qdd) in qdd.iter().enumerate() {
            assert_eq!(qdd.iter().any(|x| x.is_nan()), singular.contains(&i), "{i}");
        }
    }
}

#[test]
fn lengths_are_compared_before_the_cores_are_asked() {
    let q = vec![SVector::<f64, 6>::zeros(); 5000];
    let mut out = vec![SVector::zeros(); 4999];
    let error = Puma560.par_gravity_vector_batch(&q, &mut out).unwrap_err();
    assert_eq!(
        (error.argument, error.found, error.expected),
        ("gravity_vector", 4999, 5000)
    );
}
