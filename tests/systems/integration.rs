//! Generated arms under the methods that need more of them than forward dynamics.

use robot_dynamics::nalgebra::{Vector1, Vector2};
use robot_dynamics::{Friction, Method, Simulation, robot_dynamics, simulation::Dop853};

robot_dynamics! {
    /// A block on a floor.
    struct Block { m: f64, f: f64 }

    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        slide: prismatic { alpha: PI/2, mass: m, friction: { coulomb: f } },
    ],
}

robot_dynamics! {
    /// Two rods with friction at the elbow.
    struct DryElbow { f: f64 }

    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        shoulder: revolute { a: 2, mass: 3, com: [-1, 0, 0], inertia: rod(2) },
        elbow: revolute { a: 1, mass: 1, com: [-0.5, 0, 0], inertia: rod(1), friction: { coulomb: f } },
    ],
}

robot_dynamics! {
    /// An arm without the functions that momenta are made of.
    struct Bare;

    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [ swing: revolute { a: 1, mass: 1 } ],
    functions: [forward_dynamics],
}

/// v^2 / (2 f / m) after v / (f / m), and no further.
#[test]
fn a_block_stops_where_its_energy_is_used_up() {
    let block = Block { m: 2.0, f: 5.0 };
    let run = Simulation::new(&block)
        .initial(Vector1::new(1.0), Vector1::new(4.0))
        .friction(Friction::Sticking)
        .duration(3.0)
        .run()
        .unwrap();
    assert!((run.q[100][0] - (1.0 + 16.0 / 5.0)).abs() < 1e-14);
    assert_eq!(run.qd[100][0], 0.0);
}

/// Stuck, the arm is one body: the same by methods in velocities and in momenta.
#[test]
fn a_stuck_elbow_does_not_move() {
    let arm = DryElbow { f: 1e4 };
    let start = Vector2::new(0.5, -1.0);
    let energy = arm.potential_energy::<f64>(&start);
    for method in [
        Dop853::with_tolerance(1e-11).into(),
        Method::GaussLegendre6 { step: 5e-3 },
    ] {
        let run = Simulation::new(&arm)
            .initial(start, Vector2::zeros())
            .friction(Friction::Sticking)
            .method(method)
            .samples(11)
            .run()
            .unwrap();
        for (q, qd) in run.q.iter().zip(&run.qd) {
            assert!((q[1] - start[1]).abs() < 1e-12, "{method:?}: {q:?}");
            let now = arm.kinetic_energy::<f64>(q, qd) + arm.potential_energy::<f64>(q);
            assert!((now - energy).abs() < 1e-8, "{method:?}: {now} {energy}");
        }
        assert!(run.q[10][0] < -1.0);
    }
}

#[test]
fn an_arm_without_its_mass_matrix_is_not_known_in_momenta() {
    use robot_dynamics::{ForwardDynamics, simulation::InvalidSetting};
    assert!(Bare.momenta().is_none());
    assert!(DryElbow { f: 0.0 }.momenta().is_some());
    let step = 0.1;
    let error = Simulation::new(&Bare)
        .method(Method::ImplicitMidpoint { step })
        .run()
        .unwrap_err();
    assert_eq!(error.cause, InvalidSetting::NoMomenta.into());
}
