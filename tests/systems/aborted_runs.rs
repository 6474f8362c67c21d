//! A run that cannot go on says when and where, and keeps what it has.

use robot_dynamics::nalgebra::{Vector1, Vector2};
use robot_dynamics::{
    Method, Simulation, robot_dynamics,
    simulation::{Cause, DormandPrince},
};

robot_dynamics! {
    /// A mass on a slide.
    struct Slider { mass: f64 }

    convention: standard,
    gravity: [0, 0, 0],
    joints: [slide: prismatic { mass: mass }],
}

robot_dynamics! {
    /// A boom whose tip, a point mass, slides to the axis of the joint that turns it: there
    /// nothing resists the turn.
    struct Boom;

    convention: modified,
    gravity: [0, 0, 0],
    joints: [
        turn: revolute {},
        slide: prismatic { alpha: -PI/2, mass: 1 },
    ],
}

/// One method of each kind.
const METHODS: [Method; 4] = [
    Method::CraigEuler { step: 0.01 },
    Method::SemiImplicitEuler { step: 0.01 },
    Method::RungeKutta4 { step: 0.01 },
    Method::DormandPrince(DormandPrince::with_tolerance(1e-9).max_step(0.01)),
];

#[test]
fn a_torque_that_is_no_number_ends_the_run_where_it_occurs() {
    for method in METHODS {
        let failing = |t: f64, _: &Vector1<f64>, _: &Vector1<f64>| {
            Vector1::new(if t > 0.505 { f64::NAN } else { 2.0 })
        };
        let slider = Slider { mass: 1.0 };
        let simulation = Simulation::new(&slider).torque(failing).method(method);
        let error = simulation
            .duration(1.0)
            .samples(11)
            .run()
            .expect_err("no number");
        assert_eq!(
            error.cause,
            Cause::NonFiniteTorque { joint: 0 },
            "{method:?}"
        );
        assert!(
            (0.45..0.52).contains(&error.time),
            "{method:?}: {}",
            error.time
        );
        assert!(
            (error.q[0] - error.time.powi(2)).abs() < 0.01,
            "{method:?}: {}",
            error.q
        );
        // t = 0, 0.1, ..., 0.5
        assert_eq!(error.trajectory.len(), 6, "{method:?}");
        assert!((error.trajectory.q[5][0] - 0.25).abs() < 0.01, "{method:?}");
    }
}

#[test]
fn a_mass_matrix_that_is_singular_from_the_start_keeps_the_initial_sample() {
    for method in METHODS {
        let slider = Slider { mass: 0.0 };
        let run = Simulation::new(&slider).method(method).run();
        let error = run.expect_err("nothing to accelerate");
        assert!(
            matches!(error.cause, Cause::SingularMassMatrix(_)),
            "{method:?}"
        );
        assert_eq!(error.time, 0.0);
        assert!(error.to_string().contains("joint 1"), "{error}");
    }
}

/// With steps of 1/64 s, which are exact, the tip is on the axis at t = 1/2 to the bit.
#[test]
fn a_mass_matrix_that_becomes_singular_ends_the_run_there() {
    let method = Method::CraigEuler { step: 1.0 / 64.0 };
    let simulation = Simulation::new(&Boom).method(method);
    let started = simulation.initial(Vector2::new(0.0, 0.5), Vector2::new(0.0, -1.0));
    let error = started
        .duration(1.0)
        .samples(9)
        .run()
        .expect_err("singular");
    assert!(matches!(error.cause, Cause::SingularMassMatrix(at) if at.joint == 0));
    assert_eq!((error.time, error.q[1], error.qd[1]), (0.5, 0.0, -1.0));
    assert_eq!(error.trajectory.t, [0.0, 0.125, 0.25, 0.375, 0.5]);
}
