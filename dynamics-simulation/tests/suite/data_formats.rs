//! Tables, trajectories, settings and reports as data, by serde: what is written is read back.

use robot_dynamics::nalgebra::SVector;
use robot_dynamics::{
    FloatingNewtonEuler, Friction, Method, NewtonEuler, Pose, Simulation, Trajectory,
    check_against_rnea, robot_dynamics,
    simulation::{Dop853, FloatingTrajectory, Taylor},
    table::{Convention, FloatingBase, Table},
};
use serde::{Serialize, de::DeserializeOwned};

robot_dynamics! {
    /// An arm with something of everything.
    struct Arm;

    convention: standard,
    gravity: [0, 0, -9.81],
    base: { xyz: [0, 0, 0.5], rpy: [0, 0.1, 0] },
    joints: [
        turn: revolute {
            d: 0.3, alpha: PI/2, mass: 4, com: [0, 0.01, 0.02], inertia: cylinder(0.1, 0.3),
            friction: { viscous: 0.1, coulomb: 0.3, stribeck: { static: 0.5, velocity: 0.01 } },
            spring: { stiffness: 3, rest: 0.1 },
        },
        slide: prismatic { mass: 1, com: [0, 0, 0.1], limits: [0.1, 0.7] },
    ],
    tool: { xyz: [0, 0, 0.1], mass: 0.5 },
}

fn read_back<T: Serialize + DeserializeOwned>(value: &T) -> T {
    let text = serde_json::to_string(value).unwrap();
    serde_json::from_str(&text).unwrap_or_else(|error| panic!("{error}: {text}"))
}

#[test]
fn tables_and_trajectories_are_read_as_they_were_written() {
    let table = read_back(&Arm.table());
    assert_eq!(table, Arm.table());
    let run = |table: &Table<2>| {
        Simulation::new(&NewtonEuler::new(table))
            .initial(SVector::from([0.3, 0.2]), SVector::zeros())
            .friction(Friction::Sticking)
            .samples(6)
            .run()
            .unwrap()
    };
    let original = run(&Arm.table());
    assert_eq!(run(&table), original);
    assert_eq!(read_back(&original), original);

    let text = serde_json::to_string(&original).unwrap();
    assert!(text.contains(r#""q":[[0.3,0.2],["#), "{text}");
    // A base that stands has no poses.
    assert!(!text.contains(r#""base""#), "{text}");
    let other = serde_json::from_str::<Trajectory<3>>(&text)
        .unwrap_err()
        .to_string();
    assert!(
        other.contains("invalid length 2, expected a sequence of 3"),
        "{other}"
    );
}

/// JSON has no numbers that are not finite: an acceleration that could not be computed is written as `null`.
#[test]
fn motions_without_accelerations_are_read_back_and_no_others() {
    let motion = Simulation::new(&NewtonEuler::new(&Arm.table()))
        .initial(SVector::from([0.3, 0.2]), SVector::zeros())
        .friction(Friction::Sticking)
        .samples(3)
        .run()
        .unwrap();
    let mut written = serde_json::to_value(&motion).unwrap();
    written["qdd"][1] = serde_json::json!([null, 2.5]);
    let read: Trajectory<2> = serde_json::from_value(written.clone()).unwrap();
    assert!(read.qdd[1][0].is_nan() && read.qdd[1][1] == 2.5);
    assert_eq!(serde_json::to_value(&read).unwrap(), written);

    let refused = |change: fn(&mut serde_json::Value)| {
        let mut changed = written.clone();
        change(&mut changed);
        serde_json::from_value::<Trajectory<2>>(changed)
            .unwrap_err()
            .to_string()
    };
    assert_eq!(
        refused(|motion| motion["t"] = serde_json::json!([0.0, 0.5])),
        "2 times in `t`, and 3 entries in `q`"
    );
    assert_eq!(
        refused(|motion| motion["t"][2] = serde_json::json!(0.25)),
        "times must grow from sample to sample: 0.25 s stands behind 0.5 s"
    );
    assert_eq!(
        refused(|motion| motion["q"][1][0] = serde_json::Value::Null),
        "the time, a position or a velocity of sample 2 is not finite"
    );
}

#[test]
fn motions_on_a_base_that_moves_have_its_poses() {
    let brick = Table::<0> {
        floating: Some(FloatingBase {
            mass: 2.0,
            com: [0.0; 3],
            inertia: [0.1, 0.2, 0.3, 0.0, 0.0, 0.0],
        }),
        ..Table::new(Convention::Modified, [0.0, 0.0, -9.81], [])
    };
    let v = SVector::from([0.1, 0.0, 1.0, 0.5, 2.0, -0.3]);
    let original = Simulation::new(&FloatingNewtonEuler::<0, 6>::new(&brick))
        .initial(Pose::identity(), SVector::zeros(), v)
        .samples(4)
        .run()
        .unwrap();
    assert_eq!(read_back(&original), original);
    let text = serde_json::to_string(&original).unwrap();
    assert!(text.contains(r#""base":[[1.0,0.0,0.0,0.0,1.0,"#), "{text}");
    assert_eq!(original.base.len(), 4);
    let mut longer = serde_json::to_value(&original).unwrap();
    let pose = longer["base"][0].clone();
    longer["base"].as_array_mut().unwrap().push(pose);
    let error = serde_json::from_value::<FloatingTrajectory<0, 6>>(longer).unwrap_err();
    assert_eq!(error.to_string(), "4 times in `t`, and 5 entries in `base`");
}

#[test]
fn settings_are_read_as_they_were_written() {
    for method in [
        Method::RungeKutta4 { step: 1.0 / 3.0 },
        Dop853::with_tolerance(1e-11).into(),
        Method::default(),
    ] {
        assert_eq!(read_back(&method), method);
    }
    for friction in [
        Friction::Sign,
        Friction::Sticking,
        Friction::Regularised { speed: 0.1 },
    ] {
        assert_eq!(read_back(&friction), friction);
    }
    let taylor = Taylor::with_tolerance(1e-14);
    assert_eq!(read_back(&taylor), taylor);
    // As a person writes it.
    let written = r#"{"RungeKutta4": {"step": 0.001}}"#;
    let method = serde_json::from_str::<Method>(written).unwrap();
    assert_eq!(method, Method::RungeKutta4 { step: 1e-3 });
}

#[test]
fn reports_are_written() {
    let report = check_against_rnea(&Arm);
    let text = serde_json::to_value(&report).unwrap();
    assert_eq!(
        text["functions"][0]["function"],
        report.functions[0].function
    );
    assert_eq!(text["states"], report.states);
}

#[test]
fn limits_are_a_constant_of_the_arm() {
    assert_eq!(Arm::JOINT_LIMITS, [None, Some([0.1, 0.7])]);
    assert_eq!(Arm.table().joint_limits(), Arm::JOINT_LIMITS);
}
