//! The functions that have a reference, and what their errors are relative to.

use robot_dynamics::nalgebra::{Matrix4, SVector};
use robot_dynamics::{
    SingularMassMatrix, State,
    check::Evaluation,
    table::{JointType, Row, Table},
};
use robots::Arm;
use testkit::references::{Decimal, ReferenceState};

use super::quantity::{Quantity, magnitude, matrix, sum, vector};

/// The longest distance of the last frame from the base that the table allows at `q`.
fn reach<const N: usize>(table: &Table<N>, q: &[f64]) -> f64 {
    let link = |(row, q): (&Row, &f64)| match row.joint_type {
        JointType::Revolute => row.a.abs() + row.d.abs(),
        JointType::Prismatic => row.a.abs() + (row.d.abs() + q.abs()),
    };
    table.rows.iter().zip(q).map(link).sum()
}

/// tau + F, the torques that give the accelerations of the reference state.
fn applied_torque(reference: &ReferenceState) -> Vec<Decimal> {
    sum(&reference.tau, &reference.friction)
}

/// Every function that has a reference, at one of its states.
pub(super) fn quantities<const N: usize, const P: usize, R: Arm<N, P>>(
    robot: &R,
    reference: &ReferenceState,
) -> Vec<Quantity> {
    let state = State {
        q: SVector::from_row_slice(&reference.q),
        qd: SVector::from_row_slice(&reference.qd),
        qdd: SVector::from_row_slice(&reference.qdd),
    };
    let torque = applied_torque(reference);
    let tau = SVector::from_fn(|i, _| torque[i].nearest());
    let found = robot.evaluate(&state, &tau);

    let mut all = dynamics::<N>(&found, reference);
    all.extend(energies(&found, reference));
    let table = robot.table();
    let slides = (table.rows.iter()).any(|row| row.joint_type == JointType::Prismatic);
    let reach = reach(&table, &reference.q);
    all.extend(kinematics::<N>(&found, reference, reach, slides));
    all.push(forward_dynamics::<N>(&found, reference, &torque));
    all
}

fn dynamics<const N: usize>(found: &Evaluation, reference: &ReferenceState) -> Vec<Quantity> {
    let scale = &reference.scale;
    let torque = applied_torque(reference);
    let bias = sum(
        &sum(&reference.coriolis_vector, &reference.gravity_vector),
        &reference.friction,
    );
    vec![
        Quantity::new(
            "M",
            scale.M,
            matrix::<N, N>(found.get("mass_matrix"), &reference.mass_matrix),
        ),
        Quantity::new(
            "V",
            scale.V,
            vector::<N>(found.get("coriolis_vector"), &reference.coriolis_vector),
        ),
        Quantity::new(
            "G",
            scale.G,
            vector::<N>(found.get("gravity_vector"), &reference.gravity_vector),
        ),
        Quantity::new(
            "F",
            magnitude(&reference.friction),
            vector::<N>(found.get("friction_vector"), &reference.friction),
        ),
        Quantity::new(
            "tau",
            scale.tau.max(magnitude(&torque)),
            vector::<N>(found.get("inverse_dynamics"), &torque),
        ),
        Quantity::new(
            "Y b",
            scale.tau,
            vector::<N>(found.get("regressor_form"), &reference.tau),
        ),
        Quantity::new(
            "V+G+F",
            (scale.V + scale.G).max(magnitude(&bias)),
            vector::<N>(found.get("bias_force"), &bias),
        ),
        Quantity::new(
            "C",
            scale.C,
            matrix::<N, N>(found.get("coriolis_matrix"), &reference.coriolis_matrix),
        ),
        Quantity::new(
            "B, C",
            scale.V,
            vector::<N>(
                found.get("configuration_space_form"),
                &reference.coriolis_vector,
            ),
        ),
    ]
}

fn energies(found: &Evaluation, reference: &ReferenceState) -> Vec<Quantity> {
    let kinetic = found.get("kinetic_energy").expect("asked for");
    let potential = found.get("potential_energy").expect("asked for");
    // The files say 1e-300 for the kinetic energy of an arm at rest, which is zero.
    let at_rest = reference.scale.T < 1e-200;
    let scale = if at_rest { 0.0 } else { reference.scale.T };
    vec![
        Quantity::new("T", scale, vec![(kinetic, reference.kinetic_energy)]),
        Quantity::new(
            "U",
            reference.scale.U,
            vec![(potential, reference.potential_energy)],
        ),
    ]
}

/// Directions relative to 1, lengths to the reach.
fn kinematics<const N: usize>(
    found: &Evaluation,
    reference: &ReferenceState,
    reach: f64,
    slides: bool,
) -> Vec<Quantity> {
    let rotation =
        |pose: Vec<(f64, Decimal)>| (0..16).filter(|i| i % 4 < 3).map(|i| pose[i]).collect();
    let position = |pose: Vec<(f64, Decimal)>| (0..3).map(|i| pose[4 * i + 3]).collect();
    let pose = matrix::<4, 4>(found.get("forward_kinematics"), &reference.ee_pose);
    let last = matrix(
        found
            .get("link_poses")
            .map(|poses: [Matrix4<f64>; N]| poses[N - 1]),
        &reference.ee_pose,
    );
    let jacobian = matrix::<6, N>(found.get("jacobian"), &reference.jacobian);
    let (linear, angular) = jacobian.split_at(3 * N);
    // A prismatic joint moves the origin by what it moves itself.
    let lever = if slides { reach.max(1.0) } else { reach };
    vec![
        Quantity::new("pose", 1.0, rotation(pose.clone())),
        Quantity::new("pose", reach, position(pose)),
        Quantity::new("poses", 1.0, rotation(last.clone())),
        Quantity::new("poses", reach, position(last)),
        Quantity::new("J", lever, linear.to_vec()),
        Quantity::new("J", 1.0, angular.to_vec()),
    ]
}

/// The accelerations are judged by the torques that they need beyond those that were applied,
/// M (qdd - exact qdd), so that an ill-conditioned M is held to the same bound.
fn forward_dynamics<const N: usize>(
    found: &Evaluation,
    reference: &ReferenceState,
    torque: &[Decimal],
) -> Quantity {
    let qdd: Result<SVector<f64, N>, SingularMassMatrix> =
        found.get("forward_dynamics").expect("asked for");
    let qdd = qdd.expect("the mass matrix is positive definite");
    let residual = |i: usize| {
        let row = reference.mass_matrix[i].iter();
        let errors = qdd.iter().zip(&reference.qdd).map(|(x, exact)| x - exact);
        let needed: f64 = row.zip(errors).map(|(m, error)| m.nearest() * error).sum();
        needed - torque[i].error_of(torque[i].nearest())
    };
    let zero = Decimal::default();
    Quantity::new(
        "qdd",
        reference.scale.tau.max(magnitude(torque)),
        (0..N).map(|i| (residual(i), zero)).collect(),
    )
}
