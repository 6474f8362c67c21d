//! Dry friction against exact solutions.

use core::f64::consts::PI;

use dynamics_runtime::table::{Convention, JointType, Row, Table};
use dynamics_runtime::{
    ForwardDynamics, InverseDynamics, MassMatrix, Model, Scalar, SingularMassMatrix,
};
use nalgebra::{SMatrix, SVector, Vector1, Vector2};
use tables::{CRAIG_ARM, CraigArm};

use crate::simulation::{Cause, Dop853, DormandPrince, InvalidSetting, Momenta, Radau5};
use crate::{Friction, Method, Simulation, Trajectory};

/// A block of 1 kg on a floor with friction of 1 N.
struct Block;

impl Model<1> for Block {
    const JOINT_NAMES: [&'static str; 1] = ["slide"];

    fn table(&self) -> Table<1> {
        let row = Row {
            mass: 1.0,
            coulomb: [1.0; 2],
            ..Row::new(JointType::Prismatic)
        };
        Table::new(Convention::Modified, [0.0; 3], [row])
    }
}

impl MassMatrix<1> for Block {
    fn mass_matrix<T: Scalar>(&self, _: &SVector<T, 1>) -> SMatrix<T, 1, 1> {
        SMatrix::<T, 1, 1>::new(T::from_f64(1.0))
    }
}

impl InverseDynamics<1> for Block {
    fn inverse_dynamics<T: Scalar>(
        &self,
        _: &SVector<T, 1>,
        qd: &SVector<T, 1>,
        qdd: &SVector<T, 1>,
    ) -> SVector<T, 1> {
        Vector1::new(qdd[0] + qd[0].sign())
    }
}

impl ForwardDynamics<1> for Block {
    fn forward_dynamics<T: Scalar>(
        &self,
        _: &SVector<T, 1>,
        qd: &SVector<T, 1>,
        tau: &SVector<T, 1>,
    ) -> Result<SVector<T, 1>, SingularMassMatrix> {
        Ok(Vector1::new(tau[0] - qd[0].sign()))
    }

    fn momenta(&self) -> Option<&dyn Momenta<1>> {
        Some(self)
    }
}

fn unit(x: f64) -> SVector<f64, 1> {
    Vector1::new(x)
}

/// The methods that solve a motion of constant force exactly. All except the second are exact for a
/// force linear in time too.
fn methods() -> [Method; 7] {
    let step = 0.03;
    [
        Method::RungeKutta4 { step },
        Method::ImplicitMidpoint { step },
        Method::GaussLegendre4 { step },
        Method::GaussLegendre6 { step },
        DormandPrince::default().into(),
        Dop853::default().into(),
        Radau5::default().into(),
    ]
}

fn run(
    method: Method,
    start: [f64; 2],
    duration: f64,
    force: impl Fn(f64, f64) -> f64,
) -> Trajectory<1> {
    let block = Simulation::new(&Block).torque(|t, q, _| unit(force(t, q[0])));
    let block = block.initial(unit(start[0]), unit(start[1]));
    let block = block.friction(Friction::Sticking).method(method);
    block.duration(duration).samples(9).run().unwrap()
}

#[track_caller]
fn assert_near(found: f64, expected: f64, bound: f64, method: &Method) {
    let error = (found - expected).abs();
    assert!(
        error <= bound,
        "{found} is {error:e} from {expected}: {method:?}"
    );
}

/// From 1 m/s it stops after 1 s and 1/2 m, and stays.
#[test]
fn a_block_stops_and_stays() {
    for method in methods() {
        let run = run(method, [0.0, 1.0], 2.0, |_, _| 0.0);
        for (t, q) in run.t.iter().zip(&run.q) {
            let t = t.min(1.0);
            assert_near(q[0], t - 0.5 * t * t, 2e-15, &method);
        }
        // At 1 s the sample is the event, up to its rounding.
        assert!(run.qd[4][0].abs() < 1e-14, "{method:?}");
        assert!(run.qd[5..].iter().all(|qd| qd[0] == 0.0), "{method:?}");
        assert!(run.work.evaluations < 5_000, "{:?}", run.work);
    }
}

/// Half of what would move it does not, exactly.
#[test]
fn a_block_at_rest_does_not_creep() {
    for method in methods() {
        let run = run(method, [0.0, 0.0], 10.0, |_, _| 0.5);
        assert!(run.q.iter().all(|q| q[0] == 0.0), "{method:?}");
    }
}

/// A force t/2 exceeds friction from 2 s on: q = (t - 2)^3 / 12.
#[test]
fn a_block_is_let_go_when_the_force_exceeds_friction() {
    for method in methods() {
        let run = run(method, [0.0, 0.0], 4.0, |t, _| 0.5 * t);
        let bound = match method {
            Method::ImplicitMidpoint { .. } => 1e-3,
            _ => 1e-13,
        };
        for (t, q) in run.t.iter().zip(&run.q) {
            let expected = (t - 2.0).max(0.0).powi(3) / 12.0;
            assert_near(q[0], expected, bound, &method);
        }
    }
}

/// A force of -3 N turns a block of 1 m/s round after 1/4 s, without sticking: it decelerates by
/// 4 m/s^2 and then accelerates by 2 m/s^2.
#[test]
fn a_strong_force_turns_a_block_round() {
    for method in methods() {
        let run = run(method, [0.0, 1.0], 1.0, |_, _| -3.0);
        assert_near(run.q[8][0], 0.125 - 0.75 * 0.75, 1e-14, &method);
        assert_near(run.qd[8][0], -1.5, 1e-14, &method);
    }
}

/// On a spring of 10 N/m with friction of 1 N the amplitude falls by 0.2 m in each half period: from
/// 1.05 over -0.85, 0.65, -0.45 and 0.25 to -0.05, where the spring cannot move it.
#[test]
fn a_spring_swings_out_in_five_halves() {
    let accurate = [
        DormandPrince::with_tolerance(1e-11).into(),
        Dop853::with_tolerance(1e-11).into(),
        Method::GaussLegendre6 { step: 0.02 },
    ];
    for method in accurate {
        let end = 5.0 * PI / 10.0_f64.sqrt();
        let run = run(method, [1.05, 0.0], end + 1.0, |_, q| -10.0 * q);
        assert_near(run.q[8][0], -0.05, 2e-9, &method);
        assert_eq!(run.qd[8][0], 0.0);
        let t = run.t[1];
        // Half a period takes 0.993 s: the second sample is in the second half.
        let half = PI / 10.0_f64.sqrt();
        let expected = if t < half {
            0.1 + 0.95 * (10.0_f64.sqrt() * t).cos()
        } else {
            -0.1 - 0.75 * (10.0_f64.sqrt() * (t - half)).cos()
        };
        assert_near(run.q[1][0], expected, 2e-9, &method);
    }
}

/// Under 1 + 2 (t - 1/2) N from 0.24 m/s the velocity is (t - 1/2)^2 - 0.01, until the block stops at
/// 0.4 s; it is let go at 0.5 s, from where the velocity is (t - 1/2)^2. At the ends of a step of 1 s
/// nothing is to be seen of it.
#[test]
fn a_stop_within_a_step_is_seen() {
    let force = |t: f64, _: &SVector<f64, 1>, _: &SVector<f64, 1>| unit(2.0 * t);
    let step = 1.0;
    for method in [
        Method::RungeKutta4 { step },
        Method::GaussLegendre4 { step },
        Method::GaussLegendre6 { step },
    ] {
        let block = Simulation::new(&Block).torque(force).method(method);
        let block = block.initial(unit(0.0), unit(0.24));
        let block = block.friction(Friction::Sticking).samples(2);
        let run = block.run().unwrap();
        assert_near(run.q[1][0], 0.079, 1e-15, &method);
        assert_near(run.qd[1][0], 0.25, 1e-14, &method);
    }
}

/// At half its friction it creeps at `speed atanh(1/2)`.
#[test]
fn regularised_friction_creeps_as_documented() {
    let speed = 1e-3;
    let block = Simulation::new(&Block).torque(|_, _, _| unit(0.5));
    let block = block.friction(Friction::Regularised { speed });
    let run = block
        .method(Radau5::default())
        .duration(10.0)
        .run()
        .unwrap();
    let creep = 10.0 * speed * 0.5_f64.atanh();
    assert!(
        (run.q[100][0] - creep).abs() < 1e-3 * creep,
        "{}",
        run.q[100][0]
    );
    assert!(run.work.evaluations < 2_000, "{:?}", run.work);
}

#[test]
fn a_speed_that_is_none_is_refused() {
    for speed in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let block = Simulation::new(&Block).friction(Friction::Regularised { speed });
        let cause = block.run().unwrap_err().cause;
        assert!(matches!(
            cause,
            Cause::InvalidSetting(InvalidSetting::FrictionSpeed(_))
        ));
    }
}

/// The two-link arm with a dry elbow.
struct DryElbow(f64);

impl Model<2> for DryElbow {
    const JOINT_NAMES: [&'static str; 2] = CraigArm::JOINT_NAMES;

    fn table(&self) -> Table<2> {
        let mut table = CRAIG_ARM.table();
        table.rows[1].coulomb = [self.0; 2];
        table
    }
}

impl ForwardDynamics<2> for DryElbow {
    fn forward_dynamics<T: Scalar>(
        &self,
        q: &SVector<T, 2>,
        qd: &SVector<T, 2>,
        tau: &SVector<T, 2>,
    ) -> Result<SVector<T, 2>, SingularMassMatrix> {
        let rubbed = Vector2::new(tau[0], tau[1] - T::from_f64(self.0) * qd[1].sign());
        CRAIG_ARM.forward_dynamics(q, qd, &rubbed)
    }
}

/// A stuck elbow makes the arm one pendulum: friction does no work, and the energy stays.
#[test]
fn an_arm_with_a_stuck_elbow_is_one_pendulum() {
    let arm = DryElbow(1e3);
    let q = Vector2::new(0.3, -1.0);
    let start = Simulation::new(&arm).initial(q, Vector2::new(2.0, 0.0));
    let run = start
        .friction(Friction::Sticking)
        .method(Dop853::with_tolerance(1e-11))
        .duration(3.0)
        .run()
        .unwrap();
    assert!(run.q.iter().all(|state| state[1] == q[1]));
    assert!(run.qd.iter().all(|state| state[1] == 0.0));
    assert!(run.q.iter().any(|state| (state[0] - q[0]).abs() > 1.0));
    assert!(run.energy_drift(&CRAIG_ARM) < 1e-8);
}

/// Where the elbow slips, sticks and slips again, friction takes energy and never gives any, and the
/// motion does not depend on the method.
#[test]
fn an_arm_that_slips_and_sticks_loses_energy() {
    let arm = DryElbow(3.0);
    let fall = |method: Method| {
        let start = Simulation::new(&arm).initial(Vector2::new(0.3, -1.0), Vector2::zeros());
        let run = start.friction(Friction::Sticking).method(method);
        run.duration(2.0).samples(201).run().unwrap()
    };
    let run = fall(Dop853::with_tolerance(1e-10).into());
    let stuck = run.qd.iter().filter(|qd| qd[1] == 0.0).count();
    assert!((5..190).contains(&stuck), "{stuck}");
    let energies = run.energies(&CRAIG_ARM);
    assert!(energies.windows(2).all(|pair| pair[1] <= pair[0] + 1e-7));
    assert!(energies[200] < energies[0] - 1.0);
    for method in [
        DormandPrince::with_tolerance(1e-9).into(),
        Method::RungeKutta4 { step: 5e-3 },
        Radau5::with_tolerance(1e-8).into(),
    ] {
        let other = fall(method);
        let error = (other.q[200] - run.q[200]).amax();
        assert!(error < 1e-5, "{error:e}: {method:?}");
    }
}

/// Half of the friction pushes the block when it comes to rest after 0.2 s. To the end of the run it would take millions of
/// steps.
#[test]
fn a_joint_that_should_stick_ends_a_run_by_the_sign() {
    let methods: [Method; 3] = [
        DormandPrince::with_tolerance(1e-6).into(),
        Dop853::with_tolerance(1e-6).into(),
        Radau5::with_tolerance(1e-6).into(),
    ];
    for method in methods {
        let run = |duration, samples| {
            let run = Simulation::new(&Block)
                .friction(Friction::Sign)
                .torque(|_, _, _| Vector1::new(0.5))
                .initial(Vector1::zeros(), Vector1::new(0.1))
                .method(method);
            run.duration(duration).samples(samples).run()
        };
        // A little of it is followed.
        assert!(run(0.21, 22).is_ok(), "{method:?}");
        let Err(error) = run(1e4, 10_001) else {
            panic!("{method:?}: it crept to the end");
        };
        assert_eq!(error.cause, Cause::Sticks { joint: 0 }, "{method:?}");
        assert!(
            error.to_string().contains("joint 1 is held at rest"),
            "{error}"
        );
        let work = error.trajectory.work;
        assert!(
            error.time > 0.19 && work.steps < 12_000,
            "{method:?}: {work:?}"
        );
    }
}

/// A block that is shaken passes rest again and again, and goes on.
#[test]
fn passing_rest_often_is_no_chatter() {
    let run = Simulation::new(&Block)
        .friction(Friction::Sign)
        .torque(|t, _, _| Vector1::new(10.0 * (100.0 * t).cos()))
        .method(DormandPrince::with_tolerance(1e-6))
        .duration(500.0)
        .samples(3);
    let motion = run.run().expect("the end");
    assert!(motion.work.steps > 100_000, "{:?}", motion.work);
}
