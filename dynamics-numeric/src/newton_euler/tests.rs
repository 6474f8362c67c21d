//! Closed forms from books, and the identities that the equations of motion of every arm satisfy.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use dynamics_runtime::{
    Carrier, Convention, JointMotion, JointType, Model, Row, RuntimeTable, State, Table,
};
use nalgebra::{
    DVector, Dyn, Matrix1, Matrix2, Matrix3, Matrix4, Rotation3, SMatrix, SVector, Vector1,
    Vector2, Vector3,
};
use tables::{CRAIG_ARM, general_table, mounted_table, random_state};

use super::{NewtonEuler, NumericArm};

#[track_caller]
fn assert_near<const R: usize, const C: usize>(
    computed: SMatrix<f64, R, C>,
    expected: SMatrix<f64, R, C>,
    tolerance: f64,
) {
    assert_abs_diff_eq!(computed, expected, epsilon = tolerance);
}

fn seeds() -> impl Iterator<Item = u64> {
    1..=20
}

/// The cases of the identities: arms of both conventions, at a state each.
fn general_cases() -> impl Iterator<Item = (NewtonEuler<6>, State<6>)> {
    [Convention::Standard, Convention::Modified]
        .into_iter()
        .flat_map(|convention| seeds().map(move |seed| (convention, seed)))
        .flat_map(|(convention, seed)| {
            let tables = [
                general_table(convention, seed),
                mounted_table(convention, seed),
            ];
            tables.map(|table| (NewtonEuler::new(&table), random_state(seed)))
        })
}

/// A slender rod of length a, hinged at one end, hanging down at q = 0:
/// (1/3) m a^2 qdd + (1/2) m g a sin q = tau (Saha).
#[test]
fn hanging_rod() {
    let (m, a, g) = (1.7, 0.9, 9.81);
    let rod = Row {
        a,
        mass: m,
        com: [-a / 2.0, 0.0, 0.0],
        inertia: [0.0, m * a * a / 12.0, m * a * a / 12.0, 0.0, 0.0, 0.0],
        ..Row::new(JointType::Revolute)
    };
    let arm = NewtonEuler::new(&Table::new(Convention::Standard, [g, 0.0, 0.0], [rod]));
    for seed in seeds() {
        let State { q, qd, .. } = random_state::<1>(seed);
        let weight = m * g * a / 2.0;
        assert_near(arm.mass_matrix(&q), Matrix1::new(m * a * a / 3.0), 1e-15);
        assert_near(arm.coriolis_vector(&q, &qd), Vector1::new(0.0), 1e-14);
        assert_near(
            arm.gravity_vector(&q),
            Vector1::new(weight * q[0].sin()),
            1e-14,
        );
        let expected = -weight * q[0].cos();
        assert_abs_diff_eq!(arm.potential_energy(&q), expected, epsilon = 1e-14);
    }
}

/// Two point masses, Craig (6.60) to (6.62).
#[test]
fn two_links_with_point_masses() {
    let arm = NewtonEuler::new(&CRAIG_ARM.table());
    for seed in seeds() {
        let State { q, qd, .. } = random_state::<2>(seed);
        assert_near(arm.mass_matrix(&q), CRAIG_ARM.mass_matrix(&q), 1e-14);
        let v = CRAIG_ARM.coriolis_vector(&q, &qd);
        assert_near(arm.coriolis_vector(&q, &qd), v, 1e-13);
        assert_near(arm.gravity_vector(&q), CRAIG_ARM.gravity_vector(&q), 1e-13);
    }
}

/// Two slender rods (Saha): i11, i12, i22, h1, h2, gamma1, gamma2 with angles from the horizontal.
#[test]
fn two_links_with_slender_rods() {
    let (m1, m2, a1, a2, g) = (3.0, 1.0, 2.0, 1.0, 9.81);
    let rod = |m: f64, a: f64| Row {
        a,
        mass: m,
        com: [-a / 2.0, 0.0, 0.0],
        inertia: [0.0, m * a * a / 12.0, m * a * a / 12.0, 0.0, 0.0, 0.0],
        ..Row::new(JointType::Revolute)
    };
    let arm = NewtonEuler::new(&Table::new(
        Convention::Standard,
        [0.0, -g, 0.0],
        [rod(m1, a1), rod(m2, a2)],
    ));
    for seed in seeds() {
        let State { q, qd, .. } = random_state::<2>(seed);
        let ((s2, c2), c1, c12) = (q[1].sin_cos(), q[0].cos(), (q[0] + q[1]).cos());
        let i22 = m2 * a2 * a2 / 3.0;
        let i12 = i22 + m2 * a1 * a2 * c2 / 2.0;
        let i11 = m1 * a1 * a1 / 3.0 + i22 + m2 * a1 * a1 + m2 * a1 * a2 * c2;
        assert_near(arm.mass_matrix(&q), Matrix2::new(i11, i12, i12, i22), 1e-14);

        let h = m2 * a1 * a2 * s2 / 2.0;
        let h1 = -h * (2.0 * qd[0] * qd[1] + qd[1] * qd[1]);
        let h2 = h * qd[0] * qd[0];
        assert_near(arm.coriolis_vector(&q, &qd), Vector2::new(h1, h2), 1e-13);

        let gamma2 = m2 * g * a2 * c12 / 2.0;
        let gamma1 = m1 * g * a1 * c1 / 2.0 + m2 * g * a1 * c1 + gamma2;
        assert_near(arm.gravity_vector(&q), Vector2::new(gamma1, gamma2), 2e-13);
    }
}

/// A mass that slides along a rotating rail: M = diag(m r^2, m), V = (2 m r rd qd, -m r qd^2).
///
/// The polar coordinates of a point: the joints of the arm are one of each type.
#[test]
fn mass_on_a_rotating_rail() {
    let (m, g) = (2.5, 9.81);
    let turn = Row::new(JointType::Revolute);
    // Turns z of the second joint into the plane of the first: the rail points along -y at q = 0.
    let rail = Row {
        alpha: core::f64::consts::FRAC_PI_2,
        mass: m,
        ..Row::new(JointType::Prismatic)
    };
    let arm = NewtonEuler::new(&Table::new(
        Convention::Modified,
        [0.0, -g, 0.0],
        [turn, rail],
    ));
    for seed in seeds() {
        let State { q, qd, .. } = random_state::<2>(seed);
        let ((s, c), r) = (q[0].sin_cos(), q[1]);
        assert_near(
            arm.mass_matrix(&q),
            Matrix2::new(m * r * r, 0.0, 0.0, m),
            1e-14,
        );
        let v = Vector2::new(2.0 * m * r * qd[1] * qd[0], -m * r * qd[0] * qd[0]);
        assert_near(arm.coriolis_vector(&q, &qd), v, 1e-13);
        let g = Vector2::new(m * g * r * s, -m * g * c);
        assert_near(arm.gravity_vector(&q), g, 1e-13);
    }
}

/// The same arm, once in the frames of the standard and once of the modified convention.
#[test]
fn conventions_agree() {
    for seed in seeds() {
        let standard = general_table::<6>(Convention::Standard, seed);
        let (a, b) = (
            NewtonEuler::new(&standard),
            NewtonEuler::new(&to_modified(&standard)),
        );
        let State { q, qd, qdd } = random_state(seed);
        let tau = a.inverse_dynamics(&q, &qd, &qdd);
        assert_near(tau, b.inverse_dynamics(&q, &qd, &qdd), 1e-13 * tau.amax());
        assert_near(a.mass_matrix(&q), b.mass_matrix(&q), 1e-13);
        let last = &standard.rows[5];
        let flange = transform_along_x(last.alpha, last.a);
        assert_near(
            a.forward_kinematics(&q),
            b.forward_kinematics(&q) * flange,
            1e-14,
        );
    }
}

fn transform_along_x(alpha: f64, a: f64) -> Matrix4<f64> {
    let rotation = Rotation3::from_axis_angle(&Vector3::x_axis(), alpha);
    rotation
        .to_homogeneous()
        .append_translation(&Vector3::new(a, 0.0, 0.0))
}

fn to_modified<const N: usize>(table: &Table<N>) -> Table<N> {
    let row = |i: usize| {
        let row = table.rows[i];
        let rotation = Rotation3::from_axis_angle(&Vector3::x_axis(), row.alpha);
        let com = rotation * Vector3::from(row.com) + Vector3::new(row.a, 0.0, 0.0);
        let [xx, yy, zz, xy, yz, xz] = row.inertia;
        let inertia = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
        let turned = rotation.matrix() * inertia * rotation.matrix().transpose();
        let entries = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2)];
        let (alpha, a) = match i {
            0 => (0.0, 0.0),
            _ => (table.rows[i - 1].alpha, table.rows[i - 1].a),
        };
        Row {
            alpha,
            a,
            com: com.into(),
            inertia: entries.map(|entry| turned[entry]),
            ..row
        }
    };
    Table {
        convention: Convention::Modified,
        rows: core::array::from_fn(row),
        ..table.clone()
    }
}

/// M is symmetric and positive definite.
#[test]
fn mass_matrix_is_symmetric_and_positive_definite() {
    for (arm, State { q, .. }) in general_cases() {
        let m = arm.mass_matrix(&q);
        assert_near(m, m.transpose(), 1e-14 * m.amax());
        assert!(m.cholesky().is_some());
    }
}

/// 1/2 qd' M qd = T.
#[test]
fn kinetic_energy_is_the_form_of_the_mass_matrix() {
    for (arm, State { q, qd, .. }) in general_cases() {
        let expected = 0.5 * qd.dot(&(arm.mass_matrix(&q) * qd));
        let computed = arm.kinetic_energy(&q, &qd);
        assert_relative_eq!(computed, expected, max_relative = 1e-14);
    }
}

/// M by composite bodies and G by composite first moments are what the recursion gives at rest:
/// column j of M is the torque of a unit acceleration of joint j, beyond that of gravity.
#[test]
fn composite_bodies_agree_with_the_recursion() {
    for (arm, State { q, .. }) in general_cases() {
        let (m, rest) = (arm.mass_matrix(&q), SVector::zeros());
        let g = arm.inverse_dynamics(&q, &rest, &rest);
        let own = arm.spring_vector(&q);
        assert_near(arm.gravity_vector(&q) + own, g, 1e-14 * g.amax());
        for j in 0..6 {
            let unit = SVector::from_fn(|i, _| f64::from(i == j));
            let column = arm.inverse_dynamics(&q, &rest, &unit) - g;
            let scale = m.amax() + g.amax();
            assert_near(m.column(j).into_owned(), column, 1e-14 * scale);
        }
    }
}

/// The torques of a motion move the arm by it.
#[test]
fn forward_dynamics_is_the_inverse_of_inverse_dynamics() {
    for (arm, State { q, qd, qdd }) in general_cases() {
        let tau = arm.inverse_dynamics(&q, &qd, &qdd);
        let by_factors = arm.forward_dynamics(&q, &qd, &tau).unwrap();
        let by_articulated_bodies = arm.forward_dynamics_aba(&q, &qd, &tau).unwrap();
        for found in [by_factors, by_articulated_bodies] {
            let needed = arm.mass_matrix(&q) * (found - qdd);
            assert_near(needed, SVector::zeros(), 2e-14 * tau.amax());
        }
    }
}

/// A point mass on its own axis resists neither that joint nor, at q2 = 0, more than one of two.
#[test]
fn forward_dynamics_refuses_a_singular_mass_matrix() {
    let table = CRAIG_ARM.table();
    let mut on_axis = table.clone();
    on_axis.rows[1].com = [0.0; 3];
    let rest = Vector2::zeros();
    let tip = NewtonEuler::new(&on_axis);
    let found = tip.forward_dynamics(&rest, &rest, &rest).unwrap_err();
    assert_eq!(found.joint, 1);
    assert_eq!(tip.forward_dynamics_aba(&rest, &rest, &rest), Err(found));

    let mut massless = table.clone();
    massless.rows[0].mass = 0.0;
    let straight = NewtonEuler::new(&massless);
    let found = straight.forward_dynamics(&rest, &rest, &rest);
    assert_eq!(found.unwrap_err().joint, 0);
    let found = straight.forward_dynamics_aba(&rest, &rest, &rest);
    assert_eq!(found.unwrap_err().joint, 0);

    let nan = Vector2::repeat(f64::NAN);
    let arm = NewtonEuler::new(&table);
    for state in [
        arm.forward_dynamics(&nan, &rest, &rest),
        arm.forward_dynamics_aba(&nan, &rest, &rest),
    ] {
        assert!(state.unwrap_err().relative_pivot.is_nan());
    }
}

/// tau = M qdd + V + G + K + F, and C qd = V.
#[test]
fn terms_add_up() {
    for (arm, State { q, qd, qdd }) in general_cases() {
        let v = arm.coriolis_vector(&q, &qd);
        let own = arm.spring_vector(&q) + arm.friction_vector(&qd);
        let bias = v + arm.gravity_vector(&q) + own;
        let tau = arm.mass_matrix(&q) * qdd + bias;
        assert_near(arm.inverse_dynamics(&q, &qd, &qdd), tau, 1e-13 * tau.amax());
        assert_near(arm.bias_force(&q, &qd), bias, 1e-13 * tau.amax());
        assert_near(arm.coriolis_matrix(&q, &qd) * qd, v, 1e-13 * tau.amax());
    }
}

/// Mdot - 2 C is skew: holds for the Christoffel symbols and for few other factors of V.
#[test]
fn coriolis_matrix_is_that_of_the_christoffel_symbols() {
    let h = 1e-5;
    for (arm, State { q, qd, .. }) in general_cases() {
        let change = arm.mass_matrix(&(q + qd * h)) - arm.mass_matrix(&(q - qd * h));
        let difference = change / (2.0 * h) - arm.coriolis_matrix(&q, &qd) * 2.0;
        let scale = arm.mass_matrix(&q).amax() * qd.amax();
        assert_near(difference, -difference.transpose(), 1e-8 * scale);
    }
}

/// G + K = dU/dq.
#[test]
fn gravity_and_springs_are_the_gradient_of_the_potential_energy() {
    let h = 1e-5;
    for (arm, State { q, .. }) in general_cases() {
        let gradient = SVector::from_fn(|i, _| {
            let mut step = SVector::zeros();
            step[i] = h;
            let change = arm.potential_energy(&(q + step)) - arm.potential_energy(&(q - step));
            change / (2.0 * h)
        });
        let forces = arm.gravity_vector(&q) + arm.spring_vector(&q);
        assert_near(forces, gradient, 1e-7);
    }
}

/// J qd is the velocity of the last frame: (pdot, w) with Rdot R' = [w]x.
#[test]
fn jacobian_is_the_velocity_of_the_last_frame() {
    let h = 1e-5;
    for (arm, State { q, qd, .. }) in general_cases() {
        let pose = arm.forward_kinematics(&q);
        let change = arm.forward_kinematics(&(q + qd * h)) - arm.forward_kinematics(&(q - qd * h));
        let rate = change / (2.0 * h);
        let spin: Matrix3<f64> =
            rate.fixed_view::<3, 3>(0, 0) * pose.fixed_view::<3, 3>(0, 0).transpose();
        let expected = [rate.m14, rate.m24, rate.m34, spin.m32, spin.m13, spin.m21];
        assert_near(arm.jacobian(&q) * qd, SVector::from(expected), 1e-8);
    }
}

/// sign(0) = 0: a joint at rest has no dry friction.
#[test]
fn friction_is_odd_and_zero_at_rest() {
    let arm = NewtonEuler::new(&general_table::<6>(Convention::Standard, 1));
    let State { qd, .. } = random_state(1);
    assert_eq!(arm.friction_vector(&SVector::zeros()).amax(), 0.0);
    assert_eq!(arm.friction_vector(&-qd), -arm.friction_vector(&qd));
    assert!(arm.friction_vector(&qd).amin() > 0.1);
}

#[test]
fn what_is_not_finite_propagates() {
    let arm = NewtonEuler::new(&general_table::<6>(Convention::Modified, 1));
    let nan = SVector::repeat(f64::NAN);
    assert!(arm.mass_matrix(&nan)[(0, 0)].is_nan());
    assert!(arm.inverse_dynamics(&SVector::zeros(), &nan, &nan)[0].is_nan());
    assert!(arm.potential_energy(&nan).is_nan());
}

/// A pendulum on a slide that is driven: the derivatives of its two equations, by hand.
///
/// (m1 + m2) xdd + m2 l (thdd c - thd^2 s) = f + friction, m2 l^2 thdd + m2 l c xdd + m2 g l s = tau.
#[test]
fn derivatives_of_a_pendulum_on_a_slide() {
    let (m1, m2, l, g, viscous) = (1.3, 0.7, 0.4, 9.81, 0.25);
    // The slide along the base's z, which is horizontal; the pendulum's axis is the base's y.
    let slide = Row {
        mass: m1,
        viscous,
        coulomb: [0.5; 2],
        ..Row::new(JointType::Prismatic)
    };
    let pendulum = Row {
        alpha: -core::f64::consts::FRAC_PI_2,
        mass: m2,
        com: [l, 0.0, 0.0],
        ..Row::new(JointType::Revolute)
    };
    let arm = NewtonEuler::new(&Table::new(
        Convention::Modified,
        [g, 0.0, 0.0],
        [slide, pendulum],
    ));
    for seed in seeds() {
        let State { q, qd, qdd } = random_state::<2>(seed);
        let (by_position, by_velocity) = arm.inverse_dynamics_derivatives(&q, &qd, &qdd);
        let (s, c) = q[1].sin_cos();
        // The pendulum swings towards -z where the axis is y.
        let force = -m2 * l * (-qdd[1] * s - qd[1] * qd[1] * c);
        let torque = -m2 * l * -s * qdd[0] + m2 * g * l * c;
        let expected = Matrix2::new(0.0, force, 0.0, torque);
        assert_near(by_position, expected, 1e-13);
        let expected = Matrix2::new(viscous, 2.0 * m2 * l * qd[1] * s, 0.0, 0.0);
        assert_near(by_velocity, expected, 1e-13);
    }
}

/// Arms of both types of joints: the derivatives are the limits of small differences.
#[test]
fn derivatives_are_limits_of_differences() {
    const H: f64 = 1e-4;
    for (arm, State { q, qd, qdd }) in general_cases() {
        let (by_position, by_velocity) = arm.inverse_dynamics_derivatives(&q, &qd, &qdd);
        for j in 0..6 {
            let step = SVector::from_fn(|i, _| if i == j { H } else { 0.0 });
            let slope = (arm.inverse_dynamics(&(q + step), &qd, &qdd)
                - arm.inverse_dynamics(&(q - step), &qd, &qdd))
                / (2.0 * H);
            let size = arm.inverse_dynamics(&q, &qd, &qdd).amax() + 100.0;
            assert_near(by_position.column(j).into_owned(), slope, 1e-6 * size);
            let slope = (arm.inverse_dynamics(&q, &(qd + step), &qdd)
                - arm.inverse_dynamics(&q, &(qd - step), &qdd))
                / (2.0 * H);
            assert_near(by_velocity.column(j).into_owned(), slope, 1e-6 * size);
        }
    }
}

/// The rows' positions by those of the two joints that lead: each row has a factor times one of them, and an offset.
const FACTORS: [[f64; 2]; 4] = [[1.0, 0.0], [-0.5, 0.0], [0.0, 1.0], [1.5, 0.0]];
const OFFSETS: [f64; 4] = [0.0, 0.3, 0.0, -0.2];

fn coupled(convention: Convention, seed: u64) -> (Table<4>, Table<2>) {
    let whole = mounted_table::<4>(convention, seed);
    let follows = |row: usize| JointMotion::Follows {
        leader: 0,
        factor: FACTORS[row][0],
        offset: OFFSETS[row],
    };
    let motions = [JointMotion::Free, follows(1), JointMotion::Free, follows(3)];
    let table = Table {
        base: whole.base,
        tool: whole.tool,
        ..Table::couple(convention, whole.gravity, whole.rows, motions)
    };
    (whole, table)
}

/// By virtual work: tau of an arm with followers is S' tau of the arm in which each row moves by itself, at S q + c.
#[test]
fn followers_move_with_their_leaders() {
    let s = SMatrix::<f64, 4, 2>::from_fn(|i, j| FACTORS[i][j]);
    for seed in 1..=6 {
        let convention = [Convention::Standard, Convention::Modified][seed as usize % 2];
        let (whole, table) = coupled(convention, seed);
        let (whole, arm) = (NewtonEuler::new(&whole), NewtonEuler::new(&table));
        let State { q, qd, qdd } = random_state::<2>(seed);
        let all = s * q + SVector::from(OFFSETS);
        let [v, a] = [s * qd, s * qdd];
        let tau = arm.inverse_dynamics(&q, &qd, &qdd);
        let near = 1e-11;
        assert_near(tau, s.tr_mul(&whole.inverse_dynamics(&all, &v, &a)), near);
        assert_near(
            arm.mass_matrix(&q),
            s.tr_mul(&(whole.mass_matrix(&all) * s)),
            near,
        );
        assert_near(
            arm.coriolis_matrix(&q, &qd),
            s.tr_mul(&(whole.coriolis_matrix(&all, &v) * s)),
            near,
        );
        assert_near(arm.jacobian(&q), whole.jacobian(&all) * s, near);
        assert_near(
            arm.jacobian_rate(&q, &qd),
            whole.jacobian_rate(&all, &v) * s,
            near,
        );
        assert_near(
            arm.center_of_mass_jacobian(&q),
            whole.center_of_mass_jacobian(&all) * s,
            near,
        );
        assert_near(
            arm.centroidal_momentum_matrix(&q),
            whole.centroidal_momentum_matrix(&all) * s,
            near,
        );
        assert_near(
            arm.centroidal_momentum_bias(&q, &qd),
            whole.centroidal_momentum_bias(&all, &v),
            near,
        );
        let energy = arm.potential_energy(&q) + arm.kinetic_energy(&q, &qd);
        assert_abs_diff_eq!(
            energy,
            whole.potential_energy(&all) + whole.kinetic_energy(&all, &v),
            epsilon = near
        );
        assert_near(arm.link_poses(&q)[1], whole.link_poses(&all)[2], near);
        assert_near(
            arm.link_jacobians(&q)[1],
            whole.link_jacobians(&all)[2] * s,
            near,
        );

        let (found, expected) = (
            arm.inverse_dynamics_derivatives(&q, &qd, &qdd),
            whole.inverse_dynamics_derivatives(&all, &v, &a),
        );
        assert_near(found.0, s.tr_mul(&(expected.0 * s)), 1e-10);
        assert_near(found.1, s.tr_mul(&(expected.1 * s)), 1e-10);
        let [jerk, snap] = [qd * 2.0, qdd - qd];
        let found = arm.inverse_dynamics_rates(&q, &qd, &qdd, &jerk, &snap);
        let expected = whole.inverse_dynamics_rates(&all, &v, &a, &(s * jerk), &(s * snap));
        assert_near(found.0, s.tr_mul(&expected.0), 1e-9);
        assert_near(found.1, s.tr_mul(&expected.1), 1e-8);
        assert_near(
            arm.inverse_dynamics(&q, &qd, &arm.forward_dynamics(&q, &qd, &tau).unwrap()),
            tau,
            1e-9,
        );

        let second = arm.inverse_dynamics_second_derivatives(&q, &qd, &qdd);
        let h = 1e-5;
        let along = |k: usize, sign: f64| {
            SVector::<f64, 2>::from_fn(|i, _| if i == k { sign * h } else { 0.0 })
        };
        for k in 0..2 {
            let [plus, minus] = [1.0, -1.0].map(|sign| q + along(k, sign));
            let rate = (arm.mass_matrix(&plus) - arm.mass_matrix(&minus)) / (2.0 * h);
            assert_near(
                SMatrix::<f64, 2, 2>::from_fn(|i, j| second.3[i][(j, k)]),
                rate,
                1e-6,
            );
            let [plus, minus] =
                [plus, minus].map(|q| arm.inverse_dynamics_derivatives(&q, &qd, &qdd).0);
            let slope = (plus - minus) / (2.0 * h);
            assert_near(
                SMatrix::<f64, 2, 2>::from_fn(|i, j| second.0[i][(j, k)]),
                slope,
                1e-5,
            );
        }
    }
}

/// The same numbers, whether the compiler knows how many joints there are.
#[test]
fn arms_of_a_size_known_at_run_time_are_the_same() {
    let (_, table) = coupled(Convention::Standard, 7);
    let (fixed, sized) = (
        NewtonEuler::new(&table),
        NumericArm::<Dyn>::new(&RuntimeTable::from(&table)),
    );
    let State { q, qd, qdd } = random_state::<2>(7);
    let [x, v, a] = [q, qd, qdd].map(|vector| DVector::from_column_slice(vector.as_slice()));
    let expected = fixed.inverse_dynamics(&q, &qd, &qdd);
    assert_eq!(
        sized.inverse_dynamics(&x, &v, &a).as_slice(),
        expected.as_slice()
    );
    assert_eq!(
        sized.mass_matrix(&x).as_slice(),
        fixed.mass_matrix(&q).as_slice()
    );
    assert_eq!(sized.jacobian(&x).as_slice(), fixed.jacobian(&q).as_slice());
    assert_eq!(sized.dof(), 2);
}

/// Two links on the first one: all that is a sum over bodies is that of both arms, less the first link counted twice.
#[test]
fn branches_add_up() {
    for seed in seeds() {
        let convention = [Convention::Standard, Convention::Modified][seed as usize % 2];
        let table = general_table::<3>(convention, seed);
        let [first, second, third] = table.rows;
        let arm = |rows| NewtonEuler::new(&Table::new(table.convention, table.gravity, rows));
        let [left, right] = [second, third].map(|row| arm([first, row]));
        let root = NewtonEuler::new(&Table::new(table.convention, table.gravity, [first]));
        let branch = Row {
            on: Carrier::Row(0),
            ..third
        };
        let tree = NewtonEuler::new(&Table::new(
            table.convention,
            table.gravity,
            [first, second, branch],
        ));

        let State { q, qd, qdd } = random_state::<3>(seed);
        let [on_left, on_right] = [[0, 1], [0, 2]].map(|joints| {
            [q, qd, qdd].map(|x| SVector::<f64, 2>::from(joints.map(|joint: usize| x[joint])))
        });
        let on_root = [q, qd, qdd].map(|x| SVector::from([x[0]]));
        let joined = |[l, r]: [SVector<f64, 2>; 2], root: SVector<f64, 1>| {
            SVector::from([l[0] + r[0] - root[0], l[1], r[1]])
        };
        let tau = |arm: &NewtonEuler<2>, [q, qd, qdd]: &[SVector<f64, 2>; 3]| {
            arm.inverse_dynamics(q, qd, qdd)
        };
        let expected = joined(
            [tau(&left, &on_left), tau(&right, &on_right)],
            root.inverse_dynamics(&on_root[0], &on_root[1], &on_root[2]),
        );
        let found = tree.inverse_dynamics(&q, &qd, &qdd);
        assert_near(found, expected, 1e-13);
        let gravity = joined(
            [
                left.gravity_vector(&on_left[0]),
                right.gravity_vector(&on_right[0]),
            ],
            root.gravity_vector(&on_root[0]),
        );
        assert_near(tree.gravity_vector(&q), gravity, 1e-13);
        let kinetic = left.kinetic_energy(&on_left[0], &on_left[1])
            + right.kinetic_energy(&on_right[0], &on_right[1])
            - root.kinetic_energy(&on_root[0], &on_root[1]);
        assert!((tree.kinetic_energy(&q, &qd) / kinetic - 1.0).abs() < 1e-12);
        assert_eq!(tree.mass_matrix(&q)[(1, 2)], 0.0);
        for found in [
            tree.forward_dynamics(&q, &qd, &found),
            tree.forward_dynamics_aba(&q, &qd, &found),
        ] {
            assert_near(found.expect("regular"), qdd, 1e-9);
        }
    }
}
