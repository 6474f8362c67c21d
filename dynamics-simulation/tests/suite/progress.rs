//! Runs that would not get on end by one rule, soon and with the reason, and runs that creep say so.

use std::cell::Cell;

use robot_dynamics::nalgebra::{Vector1, Vector2};
use robot_dynamics::{
    Friction, Method, Simulation, Trajectory, robot_dynamics,
    simulation::{Cause, Dop853, DormandPrince, InvalidSetting, JointSet, Radau5},
};

use crate::every_method::{controlled, fixed};

robot_dynamics! {
    /// Two slender rods in a vertical plane, with dry joints, and limits far away.
    struct Rods { c1: f64, c2: f64 }

    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        shoulder: revolute {
            a: 1, mass: 1, com: [-0.5, 0, 0], inertia: rod(1), friction: { coulomb: c1 }, limits: [-3, 3],
        },
        elbow: revolute {
            a: 1, mass: 1, com: [-0.5, 0, 0], inertia: rod(1), friction: { coulomb: c2 }, limits: [-3, 3],
        },
    ],
    functions: [default],
}

robot_dynamics! {
    /// A weight that falls onto a stop, with friction that damps.
    struct Weight { viscous: f64, coulomb: f64 }

    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [height: prismatic { mass: 1, limits: [0, 1], friction: { viscous: viscous, coulomb: coulomb } }],
    functions: [default],
}

/// With stops that no joint is near to, the cause is the same as without, and as soon there.
#[test]
fn an_arm_that_friction_holds_ends_alike_with_and_without_stops() {
    let arm = Rods { c1: 20.0, c2: 10.0 };
    for method in [
        DormandPrince::default().into(),
        Dop853::default().into(),
        Method::from(Radau5::default()),
    ] {
        let run = Simulation::new(&arm)
            .friction(Friction::Sign)
            .method(method);
        let run = run
            .initial(Vector2::new(-1.0, 0.1), Vector2::new(0.2, -0.1))
            .duration(5.0);
        let without = run.clone().run().unwrap_err();
        let with = run.stops(0.3).run().unwrap_err();
        for end in [&with, &without] {
            assert!(
                matches!(end.cause, Cause::Sticks { .. }),
                "{method:?}: {end}"
            );
            assert!(
                end.to_string().ends_with(")")
                    && end.to_string().contains("take sticking friction")
            );
            assert!(
                end.trajectory.work.evaluations < 1_100_000,
                "{method:?}: {:?}",
                end.trajectory.work
            );
        }
    }
}

/// The case of a report: friction holds the elbow of two rods that fall, far from their stops, for 0.05 s.
#[test]
fn an_elbow_that_friction_holds_in_a_fall_ends_alike_with_and_without_stops() {
    let arm = Rods { c1: 0.5, c2: 0.3 };
    for method in controlled(1e-9) {
        let run = Simulation::new(&arm)
            .friction(Friction::Sign)
            .method(method)
            .initial(Vector2::new(-1.0, 0.1), Vector2::zeros())
            .duration(0.05);
        let [without, with] = [run.clone(), run.stops(0.3)].map(|run| match run.run() {
            Ok(run) => (None, run.work.evaluations as f64),
            Err(end) => (Some(end.cause), end.trajectory.work.evaluations as f64),
        });
        assert_eq!(without.0, with.0, "{method:?}");
        assert!((without.1 / with.1 - 1.0).abs() < 0.1, "{method:?}");
        // The implicit method reaches the end before a million evaluations.
        let implicit = matches!(method, Method::Radau5(_));
        let expected = (!implicit).then_some(Cause::Sticks { joint: 1 });
        assert_eq!(with.0, expected, "{method:?}");
        assert!(with.1 < 1_100_000.0, "{method:?}");
    }
}

/// A weight whose stop is elastic, by the law that counts its calls.
fn dropped(
    weight: &Weight,
    kind: Friction,
    restitution: f64,
    method: Method,
) -> (Trajectory<1>, u64) {
    let calls = Cell::new(0);
    let law = |_: f64, _: &Vector1<f64>, _: &Vector1<f64>| {
        calls.set(calls.get() + 1);
        Vector1::zeros()
    };
    let run = Simulation::new(weight)
        .torque(law)
        .friction(kind)
        .stops(restitution);
    let run = run
        .initial(Vector1::new(0.3), Vector1::zeros())
        .duration(2.0);
    let run = run.method(method).run();
    (
        run.unwrap_or_else(|end| panic!("{weight:?} {restitution} {method:?}: {end}")),
        calls.get(),
    )
}

/// Bounces that shrink, however slowly, come to rest where the tolerance does not tell them from it.
#[test]
fn elastic_bounces_that_friction_damps_come_to_rest() {
    let regularised = Friction::Regularised { speed: 0.01 };
    let methods = [
        DormandPrince::default().into(),
        Dop853::default().into(),
        Method::RungeKutta4 { step: 1e-2 },
    ];
    for (viscous, coulomb, kind) in [
        (2.43, 0.0, Friction::Sign),
        (20.0, 0.0, Friction::Sign),
        (2.43, 2.0, regularised),
        (0.0, 2.0, Friction::Sticking),
        (2.43, 2.0, Friction::Sticking),
    ] {
        let weight = Weight { viscous, coulomb };
        for (restitution, method) in [1.0, 0.9, 0.5]
            .into_iter()
            .flat_map(|e| methods.map(|method| (e, method)))
        {
            let (run, calls) = dropped(&weight, kind, restitution, method);
            let end = run.last().unwrap();
            let what =
                format!("{viscous} {coulomb} {restitution} {method:?}: {calls} calls, {end:?}");
            assert!(calls < 2_000_000, "{what}");
            assert!(viscous < 20.0 || end.qd[0].abs() < 1e-2, "{what}");
        }
    }
}

/// The number of steps is known before a run begins.
#[test]
fn too_many_steps_of_fixed_length_are_refused() {
    let arm = Rods { c1: 0.0, c2: 0.0 };
    let refused = |cause: Cause| match cause {
        Cause::InvalidSetting(InvalidSetting::TooManySteps { steps, most }) => (steps, most),
        other => panic!("{other}"),
    };
    for method in fixed(1e-8) {
        let run = Simulation::new(&arm).method(method);
        assert_eq!(refused(run.run().unwrap_err().cause), (1e8, 1e7));
    }
    for method in fixed(1e-2) {
        let run = Simulation::new(&arm).method(method).control_period(1e-9);
        let mut run = run.torque(|_, _, _| Vector2::zeros()).samples(2);
        let end = run.run().unwrap_err();
        let (steps, most) = refused(end.cause);
        assert!((steps - 1e9).abs() < 1e3 && most == 1e7, "{steps} {most}");
        assert!(
            end.to_string()
                .contains("take a longer step or control period, or more samples"),
            "{end}"
        );
    }
    // More samples allow more.
    let run = Simulation::new(&arm).method(Method::ExplicitEuler { step: 1e-9 });
    let run = run.duration(2e-3).samples(201).run().unwrap();
    assert!((run.work.steps as f64 - 2e6).abs() < 1e3);
}

/// Dry friction holds the arm, which fixed steps let creep up to the end.
#[test]
fn runs_of_fixed_step_say_which_joints_creep() {
    let arm = Rods { c1: 40.0, c2: 10.0 };
    for method in fixed(1e-2) {
        let run = |kind| {
            let run = Simulation::new(&arm)
                .friction(kind)
                .method(method)
                .duration(1.0);
            let run = run.initial(Vector2::new(-1.0, 0.1), Vector2::new(0.3, 0.0));
            [run.clone().run(), run.stops(0.3).run()].map(|run| run.map(|run| run.creeping))
        };
        for found in run(Friction::Sign) {
            match found {
                Ok(creeping) => assert!(creeping.contains(0), "{method:?}: {creeping}"),
                // Implicit methods find no solution across the jump.
                Err(end) => assert_eq!(end.cause, Cause::NoConvergence, "{method:?}"),
            }
        }
        for found in run(Friction::Sticking) {
            assert_eq!(found.unwrap(), JointSet::default(), "{method:?}");
        }
    }
    // No friction holds these, which turn back again and again.
    let arm = Rods { c1: 0.5, c2: 0.3 };
    let swings = Simulation::new(&arm)
        .friction(Friction::Sign)
        .method(Method::RungeKutta4 { step: 1e-3 });
    let swings = swings.duration(3.0).run().unwrap();
    assert_eq!(swings.creeping, JointSet::default());
    for method in controlled(1e-6) {
        let run = Simulation::new(&Rods { c1: 0.0, c2: 0.0 })
            .method(method)
            .run();
        assert!(run.unwrap().creeping.is_empty());
    }
}

/// A rod on a spring of 1e16 N m/rad: a tenth of the most steps shows that all of them would not be enough.
#[test]
fn a_motion_that_is_too_stiff_for_its_method_ends_soon() {
    robot_dynamics! {
        struct Stiff;

        convention: modified,
        gravity: [0, -9.81, 0],
        joints: [link: revolute { mass: 1, com: [0.5, 0, 0], inertia: rod(1), friction: { viscous: 1e12 } }],
        functions: [default],
    }
    let end = Simulation::new(&Stiff)
        .initial(Vector1::new(0.3), Vector1::new(0.0))
        .run()
        .unwrap_err();
    assert_eq!(end.cause, Cause::TooManySteps);
    assert!(
        end.trajectory.work.steps == 10_000,
        "{:?}",
        end.trajectory.work
    );
}

/// The first step of a method is short. A small number of steps is counted to its end, whatever share of the way the first ones
/// make.
#[test]
fn a_small_number_of_steps_is_all_there_for_a_motion() {
    let weight = Weight {
        viscous: 0.0,
        coulomb: 0.0,
    };
    let run = |settings: DormandPrince| {
        Simulation::new(&weight)
            .method(settings)
            .initial(Vector1::new(0.5), Vector1::new(0.0))
            .duration(0.1)
            .samples(2)
            .run()
    };
    let needed = run(DormandPrince::default()).unwrap().work.steps as usize;
    assert!((2..100).contains(&needed), "{needed}");
    for most in [needed, needed + 1, 10 * needed, 10 * needed + 9] {
        let end = run(DormandPrince::default().max_steps(most));
        assert!(end.is_ok(), "{most}: {end:?}");
    }
    let end = run(DormandPrince::default().max_steps(needed - 1)).unwrap_err();
    assert_eq!(end.cause, Cause::TooManySteps);
}
