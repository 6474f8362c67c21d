//! Closed formulas of a free body, and the identities of every robot on a base that moves.

use approx::assert_abs_diff_eq;
use dynamics_runtime::{
    Convention, FloatingBase, JointMotion, Pose, Row, RuntimeTable, State, Table,
};
use nalgebra::{DVector, Dyn, Matrix3, Rotation3, SMatrix, SVector, Vector3, Vector6};
use tables::{floating_table, random_pose, random_state};

use super::{FloatingNewtonEuler, NumericFloating};
use crate::NewtonEuler;

#[track_caller]
fn assert_near<const R: usize, const C: usize>(
    computed: SMatrix<f64, R, C>,
    expected: SMatrix<f64, R, C>,
    tolerance: f64,
) {
    let tolerance = tolerance * (1.0 + expected.amax());
    assert_abs_diff_eq!(computed, expected, epsilon = tolerance);
}

type Robot = FloatingNewtonEuler<5, 11>;

/// A robot and its state.
struct Case {
    table: Table<5>,
    robot: Robot,
    base: Pose<f64>,
    q: SVector<f64, 5>,
    v: SVector<f64, 11>,
    a: SVector<f64, 11>,
}

fn cases() -> impl Iterator<Item = Case> {
    (1..=12).map(|seed| {
        let convention = [Convention::Standard, Convention::Modified][seed as usize % 2];
        let table = floating_table::<5>(convention, seed);
        let State { q, qd: v, qdd: a } = random_state::<11>(seed);
        Case {
            robot: Robot::new(&table),
            table,
            base: random_pose(seed),
            q: q.fixed_rows::<5>(0).into_owned(),
            v,
            a,
        }
    })
}

fn part(v: &SVector<f64, 11>, first: usize) -> Vector3<f64> {
    v.fixed_rows::<3>(first).into_owned()
}

impl Case {
    fn tau(&self) -> SVector<f64, 11> {
        self.robot
            .inverse_dynamics(&self.base, &self.q, &self.v, &self.a)
    }

    /// The base and the joints displaced: f(p + R d, R exp(phi), q).
    fn displaced(&self, by: &SVector<f64, 11>) -> (Pose<f64>, SVector<f64, 5>) {
        let base = Pose {
            rotation: self.base.rotation * Rotation3::new(part(by, 3)).into_inner(),
            position: self.base.position + self.base.rotation * part(by, 0),
        };
        (base, self.q + by.fixed_rows::<5>(6))
    }

    /// The derivative along v of what is a function of place and joints.
    fn along<X>(&self, h: f64, value: impl Fn(&Pose<f64>, &SVector<f64, 5>) -> X) -> X
    where
        X: core::ops::Sub<Output = X> + core::ops::Div<f64, Output = X>,
    {
        let [after, before] = [h, -h].map(|h| {
            let (base, q) = self.displaced(&(self.v * h));
            value(&base, &q)
        });
        (after - before) / (2.0 * h)
    }
}

/// `f = m a_c - m R' g`, `n = I wd + w x I w + c x f`, with `a_c = dv/dt + w x v + wd x c + w x (w x c)`.
#[test]
fn a_free_body() {
    let (m, c) = (3.0, Vector3::new(0.1, -0.2, 0.3));
    let inertia = [0.4, 0.5, 0.6, 0.01, -0.02, 0.03];
    let [xx, yy, zz, xy, yz, xz] = inertia;
    let tensor = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
    let gravity = Vector3::new(1.0, 2.0, -9.0);
    let floating = Some(FloatingBase {
        mass: m,
        com: c.into(),
        inertia,
    });
    let body = FloatingNewtonEuler::<0, 6>::new(&Table {
        floating,
        ..Table::new(Convention::Standard, gravity.into(), [])
    });
    let none = SVector::zeros();
    for seed in 1..=10 {
        let (State { q: v, qd: a, .. }, base) = (random_state::<6>(seed), random_pose(seed));
        let [lin, w, vd, wd] =
            [(v, 0), (v, 3), (a, 0), (a, 3)].map(|(x, k)| x.fixed_rows::<3>(k).into_owned());
        let of_center = vd + w.cross(&lin) + wd.cross(&c) + w.cross(&w.cross(&c));
        let force = (of_center - base.rotation.transpose() * gravity) * m;
        let moment = tensor * wd + w.cross(&(tensor * w)) + c.cross(&force);
        let expected = Vector6::from_iterator(force.iter().chain(&moment).copied());
        assert_near(body.inverse_dynamics(&base, &none, &v, &a), expected, 1e-14);
        for found in [
            body.forward_dynamics(&base, &none, &v, &expected),
            body.forward_dynamics_aba(&base, &none, &v, &expected),
        ] {
            assert_near(found.unwrap(), a, 1e-12);
        }
        let speed = lin + w.cross(&c);
        let kinetic = 0.5 * (m * speed.norm_squared() + w.dot(&(tensor * w)));
        assert_abs_diff_eq!(
            body.kinetic_energy(&none, &v),
            kinetic,
            epsilon = 1e-13 * kinetic
        );
        let center = base.position + base.rotation * c;
        assert_near(body.center_of_mass(&base, &none), center, 1e-15);
        let potential = -m * gravity.dot(&center);
        assert_abs_diff_eq!(
            body.potential_energy(&base, &none),
            potential,
            epsilon = 1e-12
        );
        assert_eq!(body.forward_kinematics(&base, &none), base.homogeneous());
    }
}

#[test]
fn the_terms_make_the_forces() {
    for case in cases() {
        let Case {
            robot,
            base,
            q,
            v,
            a,
            ..
        } = &case;
        let mass_matrix = robot.mass_matrix(q);
        assert_near(mass_matrix, mass_matrix.transpose(), 0.0);
        assert!(mass_matrix.cholesky().is_some());
        let bias = robot.coriolis_vector(q, v)
            + robot.gravity_vector(base, q)
            + robot.friction_vector(v)
            + robot.spring_vector(q);
        assert_near(robot.bias_force(base, q, v), bias, 1e-13);
        let tau = case.tau();
        assert_near(mass_matrix * a + bias, tau, 1e-13);
        let kinetic = 0.5 * v.dot(&(mass_matrix * v));
        assert_abs_diff_eq!(
            robot.kinetic_energy(q, v),
            kinetic,
            epsilon = 1e-13 * kinetic
        );
        for found in [
            robot.forward_dynamics(base, q, v, &tau),
            robot.forward_dynamics_aba(base, q, v, &tau),
        ] {
            assert_near(found.expect("regular"), *a, 1e-9);
        }
        for joint_terms in [robot.friction_vector(v), robot.spring_vector(q)] {
            assert_eq!(joint_terms.rows(0, 6).amax(), 0.0);
        }
        let momentum = robot.generalized_momentum(q, v);
        assert_near(momentum, mass_matrix * v, 1e-15);
    }
}

/// C v = V, and dM/dt - 2 C is skew.
#[test]
fn the_coriolis_matrix_is_one() {
    for case in cases() {
        let Case {
            robot, base, q, v, ..
        } = &case;
        let coriolis = robot.coriolis_matrix(q, v);
        assert_near(coriolis * v, robot.coriolis_vector(q, v), 1e-13);
        let rate = case.along(1e-4, |_, q| robot.mass_matrix(q));
        assert_near(rate, coriolis + coriolis.transpose(), 1e-6);
        let forces =
            robot.gravity_vector(base, q) + robot.spring_vector(q) + robot.friction_vector(v);
        let bias = coriolis.transpose() * v - forces;
        assert_near(robot.momentum_bias(base, q, v), bias, 1e-13);
    }
}

/// With the base at rest, the joints feel what those of an arm on a base that stands feel.
#[test]
fn a_base_that_is_held_is_that_of_an_arm() {
    for case in cases() {
        let Case {
            table,
            robot,
            base,
            q,
            mut v,
            mut a,
        } = case;
        v.fixed_rows_mut::<6>(0).fill(0.0);
        a.fixed_rows_mut::<6>(0).fill(0.0);
        let gravity = base.rotation.transpose() * Vector3::from(table.gravity);
        let arm = NewtonEuler::new(&Table {
            gravity: gravity.into(),
            floating: None,
            ..table
        });
        let [qd, qdd] = [v, a].map(|x| x.fixed_rows::<5>(6).into_owned());
        let joints = |x: SVector<f64, 11>| x.fixed_rows::<5>(6).into_owned();
        let tau = robot.inverse_dynamics(&base, &q, &v, &a);
        assert_near(joints(tau), arm.inverse_dynamics(&q, &qd, &qdd), 1e-13);
        let block = robot.mass_matrix(&q).fixed_view::<5, 5>(6, 6).into_owned();
        assert_near(block, arm.mass_matrix(&q), 1e-14);
        let block = robot
            .coriolis_matrix(&q, &v)
            .fixed_view::<5, 5>(6, 6)
            .into_owned();
        assert_near(block, arm.coriolis_matrix(&q, &qd), 1e-12);
        let weights = joints(robot.gravity_vector(&base, &q));
        assert_near(weights, arm.gravity_vector(&q), 1e-13);
        let kinetic = arm.kinetic_energy(&q, &qd);
        assert_abs_diff_eq!(
            robot.kinetic_energy(&q, &v),
            kinetic,
            epsilon = 1e-13 * kinetic
        );
        let found = robot.inverse_dynamics_derivatives(&base, &q, &v, &a);
        let expected = arm.inverse_dynamics_derivatives(&q, &qd, &qdd);
        assert_near(
            found.0.fixed_view::<5, 5>(6, 6).into_owned(),
            expected.0,
            1e-12,
        );
        assert_near(
            found.1.fixed_view::<5, 5>(6, 6).into_owned(),
            expected.1,
            1e-12,
        );
        let found = robot.inverse_dynamics_second_derivatives(&base, &q, &v, &a);
        let expected = arm.inverse_dynamics_second_derivatives(&q, &qd, &qdd);
        for i in 0..5 {
            let pairs = [
                (found.0[6 + i], expected.0[i]),
                (found.1[6 + i], expected.1[i]),
                (found.2[6 + i], expected.2[i]),
                (found.3[6 + i], expected.3[i]),
            ];
            for (found, expected) in pairs {
                assert_near(found.fixed_view::<5, 5>(6, 6).into_owned(), expected, 1e-12);
            }
        }
    }
}

/// The power of tau less that of friction is the rate of T + U.
#[test]
fn power_is_the_rate_of_energy() {
    for case in cases() {
        let Case {
            robot,
            base,
            q,
            v,
            a,
            ..
        } = &case;
        let power = v.dot(&(case.tau() - robot.friction_vector(v)));
        let kinetic = case.along(1e-5, |_, q| robot.kinetic_energy(q, v))
            + v.dot(&(robot.mass_matrix(q) * a));
        let potential = case.along(1e-5, |base, q| robot.potential_energy(base, q));
        assert_abs_diff_eq!(
            kinetic + potential,
            power,
            epsilon = 1e-6 * (1.0 + power.abs())
        );
        // dT/dt without acceleration is v' C' v = v' V: the quasi-velocities do no work.
        let forces = robot.gravity_vector(base, q) + robot.spring_vector(q);
        assert_abs_diff_eq!(
            potential,
            v.dot(&forces),
            epsilon = 1e-6 * (1.0 + potential.abs())
        );
    }
}

/// The force and the moment on the base are the rates of momentum: they vanish where nothing acts from outside.
#[test]
fn momentum_changes_by_outer_forces_alone() {
    for case in cases() {
        let Case {
            table,
            base,
            q,
            v,
            a,
            ..
        } = &case;
        let robot = Robot::new(&Table {
            gravity: [0.0; 3],
            ..table.clone()
        });
        let momenta =
            |base: &Pose<f64>, q: &SVector<f64, 5>| robot.centroidal_momentum_matrix(base, q);
        let bias = robot.centroidal_momentum_bias(base, q, v);
        let matrix = momenta(base, q);
        let rate = case.along(1e-5, |base, q| momenta(base, q) * v);
        assert_near(bias, rate, 1e-6);
        let tau = robot.inverse_dynamics(base, q, v, a);
        let [force, moment] = [0, 3].map(|k| base.rotation * part(&tau, k));
        let arm = robot.center_of_mass(base, q) - base.position;
        let about = moment - arm.cross(&force);
        let expected = Vector6::from_iterator(force.iter().chain(&about).copied());
        assert_near(matrix * a + bias, expected, 1e-12);
        // Free: the joints alone push.
        let mut inner = tau;
        inner.fixed_rows_mut::<6>(0).fill(0.0);
        let free = robot.forward_dynamics(base, q, v, &inner).expect("regular");
        assert_near(matrix * free + bias, Vector6::zeros(), 1e-9);
        // The linear momentum moves the centre of mass.
        let mass = table.total_mass();
        let velocity = case.along(1e-5, |base, q| robot.center_of_mass(base, q));
        let linear = (matrix * v).fixed_rows::<3>(0).into_owned();
        assert_near(linear / mass, velocity, 1e-8);
        assert_near(
            robot.center_of_mass_jacobian(base, q) * v,
            linear / mass,
            1e-13,
        );
    }
}

/// Where the base stands matters to gravity alone, and there only how it is turned against it.
#[test]
fn the_pose_of_the_base_turns_gravity_alone() {
    for case in cases() {
        let Case {
            table,
            q,
            v,
            a,
            base,
            ..
        } = &case;
        let other = random_pose(99);
        let turn = other.rotation * base.rotation.transpose();
        let turned = Robot::new(&Table {
            gravity: (turn * Vector3::from(table.gravity)).into(),
            ..table.clone()
        });
        assert_near(turned.inverse_dynamics(&other, q, v, a), case.tau(), 1e-13);
    }
}

#[test]
fn derivatives_are_slopes() {
    for case in cases().take(3) {
        let Case {
            robot,
            base,
            q,
            v,
            a,
            ..
        } = &case;
        let (by_position, by_velocity) = robot.inverse_dynamics_derivatives(base, q, v, a);
        let (second, of_velocity, mixed, of_inertia) =
            robot.inverse_dynamics_second_derivatives(base, q, v, a);
        let unit = |j: usize| SVector::<f64, 11>::from_fn(|i, _| f64::from(u8::from(i == j)));
        let h = 1e-5;
        for j in 0..11 {
            let at = |h: f64| case.displaced(&(unit(j) * h));
            let tau = |h: f64| {
                let (base, q) = at(h);
                robot.inverse_dynamics(&base, &q, v, a)
            };
            let slope = (tau(h) - tau(-h)) / (2.0 * h);
            assert_near(by_position.column(j).into_owned(), slope, 1e-7);
            let tau = |h: f64| robot.inverse_dynamics(base, q, &(v + unit(j) * h), a);
            let slope = (tau(h) - tau(-h)) / (2.0 * h);
            assert_near(by_velocity.column(j).into_owned(), slope, 1e-7);
            let [after, before] = [h, -h].map(at);
            let mass_rate =
                (robot.mass_matrix(&after.1) - robot.mass_matrix(&before.1)) / (2.0 * h);
            let rate_of = |k: usize| {
                let [after, before] = [&after, &before].map(|(base, q)| {
                    robot
                        .inverse_dynamics_derivatives(base, q, v, a)
                        .1
                        .column(k)
                        .into_owned()
                });
                (after - before) / (2.0 * h)
            };
            let hessian = |k: usize| {
                let tau = |x: f64, y: f64| {
                    let (base, q) = case.displaced(&(unit(j) * x + unit(k) * y));
                    robot.inverse_dynamics(&base, &q, v, a)
                };
                let h = 1e-3;
                (tau(h, h) - tau(h, -h) - tau(-h, h) + tau(-h, -h)) / (4.0 * h * h)
            };
            for k in 0..11 {
                let of = |all: &[SMatrix<f64, 11, 11>; 11]| {
                    SVector::<f64, 11>::from_fn(|i, _| all[i][(j, k)])
                };
                assert_near(of(&mixed), rate_of(k), 1e-6);
                assert_near(of(&second), hessian(k), 1e-3);
                let inertia = SVector::<f64, 11>::from_fn(|i, _| of_inertia[i][(k, j)]);
                assert_near(inertia, mass_rate.column(k).into_owned(), 1e-7);
                // V is quadratic: its value at e_j + e_k has the product twice.
                let velocity = |v| robot.coriolis_vector(q, &v);
                let product = velocity(unit(j) + unit(k)) - velocity(unit(j)) - velocity(unit(k));
                assert_near(of(&of_velocity), product, 1e-12);
            }
        }
    }
}

/// The forces along a motion, whose rotation is integrated beside it.
#[test]
fn rates_are_slopes_along_a_motion() {
    for (seed, case) in (1..).zip(cases()) {
        let Case {
            robot,
            base,
            q,
            v,
            a,
            ..
        } = &case;
        let State {
            q: jerk, qd: snap, ..
        } = random_state::<11>(seed + 300);
        let velocity = |t: f64| v + a * t + jerk * (t * t / 2.0) + snap * (t * t * t / 6.0);
        let turn = |t: f64, r: &Matrix3<f64>| r * part(&velocity(t), 3).cross_matrix();
        let tau = |end: f64| {
            let (mut r, steps) = (base.rotation, 20);
            let h = end / f64::from(steps);
            for k in 0..steps {
                let t = h * f64::from(k);
                let first = turn(t, &r);
                let second = turn(t + h / 2.0, &(r + first * (h / 2.0)));
                let third = turn(t + h / 2.0, &(r + second * (h / 2.0)));
                let fourth = turn(t + h, &(r + third * h));
                r += (first + (second + third) * 2.0 + fourth) * (h / 6.0);
            }
            let t = end;
            let moved = v * t
                + a * (t * t / 2.0)
                + jerk * (t * t * t / 6.0)
                + snap * (t * t * t * t / 24.0);
            let acceleration = a + jerk * t + snap * (t * t / 2.0);
            let base = Pose {
                rotation: r,
                position: base.position,
            };
            let q = q + moved.fixed_rows::<5>(6);
            robot.inverse_dynamics(&base, &q, &velocity(t), &acceleration)
        };
        let (first, second) = robot.inverse_dynamics_rates(base, q, v, a, &jerk, &snap);
        let slope = |h: f64| (tau(h) - tau(-h)) / (2.0 * h);
        let curve = |h: f64| (tau(h) + tau(-h) - tau(0.0) * 2.0) / (h * h);
        // With the errors of degree two taken off.
        let h = 2e-3;
        assert_near(first, (slope(h) * 4.0 - slope(2.0 * h)) / 3.0, 1e-6);
        assert_near(second, (curve(h) * 4.0 - curve(2.0 * h)) / 3.0, 1e-6);
    }
}

#[test]
fn jacobians_are_slopes_of_the_poses() {
    for case in cases() {
        let Case {
            robot, base, q, v, ..
        } = &case;
        for frame in 0..3 {
            let jacobian = robot.frame_jacobian(frame, base, q);
            let rate = case.along(1e-5, |base, q| robot.frame_pose(frame, base, q));
            let twist = jacobian * v;
            let velocity = rate.fixed_view::<3, 1>(0, 3).into_owned();
            assert_near(twist.fixed_rows::<3>(0).into_owned(), velocity, 1e-8);
            let rotation = robot
                .frame_pose(frame, base, q)
                .fixed_view::<3, 3>(0, 0)
                .into_owned();
            let spin = twist.fixed_rows::<3>(3).into_owned().cross_matrix();
            assert_near(
                spin * rotation,
                rate.fixed_view::<3, 3>(0, 0).into_owned(),
                1e-8,
            );
            let rate = case.along(1e-5, |base, q| robot.frame_jacobian(frame, base, q));
            assert_near(robot.frame_jacobian_rate(frame, base, q, v), rate, 1e-7);
            let wrench = Vector6::new(1.0, -2.0, 3.0, 0.5, 0.7, -0.2);
            let forces = robot.frame_wrench_torques(frame, base, q, &wrench);
            assert_near(forces, jacobian.transpose() * wrench, 1e-14);
        }
        for link in 0..5 {
            let rate = case.along(1e-5, |base, q| robot.link_poses(base, q)[link]);
            let velocity = (robot.link_jacobians(base, q)[link] * v)
                .fixed_rows::<3>(0)
                .into_owned();
            assert_near(velocity, rate.fixed_view::<3, 1>(0, 3).into_owned(), 1e-8);
        }
        assert!(robot.jacobian(base, q).iter().all(|x| x.is_nan()));
    }
}

#[test]
fn the_regressor_times_the_parameters_is_the_force() {
    for case in cases() {
        let Case {
            table,
            robot,
            base,
            q,
            v,
            a,
        } = &case;
        let blocks = robot.standard_regressor(base, q, v, a);
        let terms = blocks.iter().zip(table.standard_parameters());
        let of_base = table.standard_parameters_of_base().expect("it moves");
        let own = robot.standard_regressor_of_base(base, v, a) * of_base;
        let links = terms.fold(own, |sum, (y, x)| sum + y * x);
        let mut other = robot.friction_vector(v) + robot.spring_vector(q);
        for (i, row) in table.rows.iter().enumerate() {
            other[6 + i] += row.reflected_inertia() * a[6 + i];
        }
        assert_near(links + other, case.tau(), 1e-13);
    }
}

/// By virtual work, as on trees that stand: a base that moves has the identity before S.
#[test]
fn joints_are_locked_and_follow_others() {
    use JointMotion::{Free, Locked};
    let follows = JointMotion::Follows {
        leader: 0,
        factor: -1.5,
        offset: 0.2,
    };
    for (case, first) in cases().zip([Free, Locked(0.4)].into_iter().cycle()) {
        let Case {
            table,
            robot: whole,
            base,
            ..
        } = case;
        let leader = if first == Free { 0 } else { 1 };
        let follows = match follows {
            JointMotion::Follows { factor, offset, .. } => JointMotion::Follows {
                leader,
                factor,
                offset,
            },
            other => other,
        };
        let motions = [
            first,
            Free,
            if first == Free { Locked(0.3) } else { Free },
            follows,
            Locked(-0.7),
        ];
        let frames = [table.frames[0], table.frames[1], table.frames[2]];
        let floating = table.floating.expect("it moves");
        let rows: [Row; 5] = table.rows;
        let reduced = Table::<2>::with_floating_base(
            floating,
            table.convention,
            table.gravity,
            rows,
            motions,
            frames,
        );
        assert_abs_diff_eq!(reduced.total_mass(), table.total_mass(), epsilon = 1e-13);
        let robot = FloatingNewtonEuler::<2, 8>::new(&reduced);
        let (mut s, mut c) = (SMatrix::<f64, 11, 8>::zeros(), SVector::<f64, 5>::zeros());
        let (mut free, mut place) = (0, [0; 5]);
        (0..6).for_each(|i| s[(i, i)] = 1.0);
        for (row, motion) in motions.iter().enumerate() {
            match *motion {
                Free => {
                    s[(6 + row, 6 + free)] = 1.0;
                    place[row] = free;
                    free += 1;
                }
                Locked(position) => c[row] = position,
                JointMotion::Follows {
                    leader,
                    factor,
                    offset,
                } => {
                    s[(6 + row, 6 + place[leader])] = factor;
                    c[row] = offset;
                }
            }
        }
        let State { q: v, qd: a, qdd } = random_state::<8>(5);
        let q = qdd.fixed_rows::<2>(0).into_owned();
        let positions = s.fixed_view::<5, 2>(6, 6) * q + c;
        let (of_v, of_a) = (s * v, s * a);
        let tau = robot.inverse_dynamics(&base, &q, &v, &a);
        let of_whole = whole.inverse_dynamics(&base, &positions, &of_v, &of_a);
        assert_near(tau, s.tr_mul(&of_whole), 1e-13);
        let mass_matrix = s.tr_mul(&(whole.mass_matrix(&positions) * s));
        assert_near(robot.mass_matrix(&q), mass_matrix, 1e-13);
        let coriolis = s.tr_mul(&(whole.coriolis_matrix(&positions, &of_v) * s));
        assert_near(robot.coriolis_matrix(&q, &v), coriolis, 1e-12);
        let found = robot.forward_dynamics_aba(&base, &q, &v, &tau);
        assert_near(found.expect("regular"), a, 1e-9);
        let jacobian = whole.frame_jacobian(2, &base, &positions) * s;
        assert_near(robot.frame_jacobian(2, &base, &q), jacobian, 1e-13);
        let rate = whole.frame_jacobian_rate(2, &base, &positions, &of_v) * s;
        assert_near(robot.frame_jacobian_rate(2, &base, &q, &v), rate, 1e-12);
    }
}

/// The same numbers, whether the compiler knows how many joints there are.
#[test]
fn at_run_time() {
    for case in cases() {
        let Case {
            table,
            robot,
            base,
            q,
            v,
            a,
        } = &case;
        let sized = NumericFloating::<Dyn, Dyn>::new(&RuntimeTable::from(table));
        let of_q = DVector::from_column_slice(q.as_slice());
        let [of_v, of_a] = [v, a].map(|x| DVector::from_column_slice(x.as_slice()));
        let tau = sized.inverse_dynamics(base, &of_q, &of_v, &of_a);
        assert_eq!(tau.as_slice(), case.tau().as_slice());
        let coriolis = robot.coriolis_matrix(q, v);
        assert_eq!(
            sized.coriolis_matrix(&of_q, &of_v).as_slice(),
            coriolis.as_slice()
        );
        assert_eq!(sized.dof(), 11);
    }
}

/// A pivot of the base counts among its six first.
#[test]
fn a_base_without_mass_is_refused() {
    let floating = Some(FloatingBase {
        mass: 0.0,
        com: [0.0; 3],
        inertia: [1.0, 1.0, 1.0, 0.0, 0.0, 0.0],
    });
    let body = FloatingNewtonEuler::<0, 6>::new(&Table {
        floating,
        ..Table::new(Convention::Standard, [0.0; 3], [])
    });
    let (base, none, six) = (Pose::identity(), SVector::zeros(), SVector::zeros());
    for found in [
        body.forward_dynamics(&base, &none, &six, &six),
        body.forward_dynamics_aba(&base, &none, &six, &six),
    ] {
        let error = found.unwrap_err();
        assert_eq!((error.joint, error.joint_name), (2, Some("base vz")));
    }
}

/// Where all rows are locked, the tip and the tool on it stay where they are: those of a robot that moves, at its positions.
#[test]
fn locked_rows_carry_the_tip() {
    let moving = floating_table::<2>(Convention::Standard, 1);
    let q = [0.3, -0.8];
    let base = moving.floating.expect("a base that moves");
    let motions = q.map(JointMotion::Locked);
    let (convention, gravity) = (moving.convention, moving.gravity);
    let frames = <[_; 3]>::try_from(&moving.frames[..]).expect("three frames");
    let fixed =
        Table::<0>::with_floating_base(base, convention, gravity, moving.rows, motions, frames);
    let fixed = Table {
        tool: moving.tool,
        ..fixed
    };
    let (moving, fixed) = (
        FloatingNewtonEuler::<2, 8>::new(&moving),
        FloatingNewtonEuler::<0, 6>::new(&fixed),
    );
    let (q, none, pose) = (SVector::from(q), SVector::zeros(), random_pose(1));
    assert_near(
        fixed.forward_kinematics(&pose, &none),
        moving.forward_kinematics(&pose, &q),
        1e-14,
    );
    let of_base = moving
        .jacobian(&pose, &q)
        .fixed_columns::<6>(0)
        .into_owned();
    assert_near(fixed.jacobian(&pose, &none), of_base, 1e-14);
    let of_base = moving.mass_matrix(&q).fixed_view::<6, 6>(0, 0).into_owned();
    assert_near(fixed.mass_matrix(&none), of_base, 1e-13);
}
