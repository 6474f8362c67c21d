//! Random simulations: arms, trees and moving bases with stops, friction of every kind and couplings, by several methods.
//! Every run ends soon, at its end or with a cause.

use arms::{Bodies, Tables, decimal};
use dynamics_evaluation::{ReadOptions, RuntimeRobot};
use dynamics_symbolic::Function;
use dynamics_symbolic::robot::{Base, Body, Robot, Value};
use robot_dynamics::nalgebra::{DVector, Matrix3, Vector3};
use robot_dynamics::simulation::{
    Cause, Dop853, DormandPrince, InvalidSetting, Place, Radau5, Work,
};
use robot_dynamics::{Friction, Method, Pose, Simulation};
use testkit::random::Random;

/// The processor time of a run, s.
const MOST: f64 = 10.0;

/// The time simulated, s.
const DURATION: f64 = 0.5;

/// Links that have mass and inertia, so that few runs end at a mass matrix that is singular.
fn heavy(mut robot: Robot) -> Robot {
    let add = |to: &mut Value, value: f64| *to = to.clone() + decimal(value);
    for row in &mut robot.rows {
        add(&mut row.mass, 0.5);
        (0..3).for_each(|k| add(&mut row.inertia[k], 0.02));
    }
    if let Some(Base::Floating(Body { mass, inertia, .. })) = &mut robot.base {
        add(mass, 1.0);
        (0..3).for_each(|k| add(&mut inertia[k], 0.05));
    }
    robot
}

/// A random robot of the kind whose turn it is, with limits around where its joints begin.
fn draw(number: usize, tables: &mut Tables, random: &mut Random) -> (RuntimeRobot, DVector<f64>) {
    let robot = match number % 4 {
        0 => tables.robot_with_joint_forces(),
        1 => tables.coupled_robot(),
        2 => tables.tree_with_all_cells(),
        _ => {
            let tree = tables.tree_with_all_cells();
            tables.on_moving_base(tree)
        }
    };
    let mut robot = heavy(robot);
    let q: Vec<f64> = robot.joints().map(|_| random.between(-1.0, 1.0)).collect();
    let free = robot
        .rows
        .iter_mut()
        .filter(|row| row.follows.is_none() && row.locked.is_none());
    for (row, q) in free.zip(&q) {
        if random.between(0.0, 1.0) < 0.6 {
            let way = random.between(0.0, 0.5);
            let to_thousandths = |x: f64| decimal((x * 1e3).round() / 1e3);
            row.limits = Some([
                to_thousandths(q - way - 0.001),
                to_thousandths(q + 0.501 - way),
            ]);
        }
    }
    let fields: Vec<f64> = robot
        .fields
        .iter()
        .map(|_| random.between(0.1, 2.0))
        .collect();
    let all = RuntimeRobot::simulation_functions();
    let functions = if robot.floating().is_some() {
        &all[2..5]
    } else {
        &all[..5]
    };
    let requests = Function::ALL
        .into_iter()
        .filter(|function| functions.contains(&function.name()));
    let mut arm = RuntimeRobot::new(robot, requests).expect("programs are proven");
    arm.set_fields(&fields).expect("a value for each field");
    (arm, DVector::from_vec(q))
}

fn method(number: usize, moves: bool) -> Method {
    let step = 1e-3;
    let all: [Method; 9] = [
        DormandPrince::default().into(),
        Dop853::default().into(),
        Method::RungeKutta4 { step },
        DormandPrince::with_tolerance(1e-6).into(),
        Method::ExplicitEuler { step },
        Method::SemiImplicitEuler { step },
        Radau5::default().into(),
        Method::ImplicitMidpoint { step },
        Method::GaussLegendre4 { step: 2e-3 },
    ];
    all[number % if moves { 6 } else { 9 }]
}

macro_rules! planned {
    ($simulation:expr, $number:expr, $method:expr) => {{
        let kinds = [
            Friction::Sign,
            Friction::Sign,
            Friction::Sticking,
            Friction::Regularised { speed: 0.01 },
        ];
        let simulation = $simulation.friction(kinds[$number / 5 % 4]).method($method);
        let simulation = simulation.duration(DURATION);
        let restitution = [0.3, 1.0, 0.0, 0.9, f64::NAN][$number / 3 % 5];
        if restitution.is_nan() {
            simulation
        } else {
            simulation.stops(restitution)
        }
    }};
}

/// A run of a random robot: the time that it takes, and its end.
fn run(
    number: usize,
    tables: &mut Tables,
    random: &mut Random,
) -> (f64, Method, Result<Work, (Work, f64, Cause)>) {
    let (robot, q) = draw(number, tables, random);
    let moves = number % 4 == 3;
    let method = method(number / 4, moves);
    let v = DVector::from_fn(robot.dof(), |_, _| {
        random.between(-1.0, 1.0) * (number % 2) as f64
    });
    let begun = measuring::thread_seconds();
    let dynamics = robot.dynamics().expect("all functions");
    let simulation = Simulation::new(&dynamics).initial(Place { base: None, q }, v);
    let end = planned!(simulation, number, method)
        .run()
        .map(|run| run.work)
        .map_err(|end| (end.trajectory.work, end.time, end.cause));
    (measuring::thread_seconds() - begun, method, end)
}

/// So many runs, none of which takes long, and most of which reach their end.
fn survey(seed: u64, count: usize) {
    let (mut tables, mut random) = (Tables::new(seed, Bodies::Physical), Random::seeded(seed));
    let (mut longest, mut at_end) = (0.0_f64, 0);
    for number in 0..count {
        let (seconds, method, end) = run(number, &mut tables, &mut random);
        let what = format!("run {number} of seed {seed}, {method:?}: {seconds:.2} s, {end:?}");
        assert!(seconds < MOST, "{what}");
        if seconds > 0.1 * MOST {
            println!("{what}");
        }
        longest = longest.max(seconds);
        at_end += usize::from(end.is_ok());
    }
    println!("{at_end} of {count} runs of seed {seed} to their end, at most {longest:.1} s");
    assert!(2 * at_end > count);
}

#[test]
fn random_runs_end_soon() {
    survey(48, 200);
}

/// Friction by its sign at a follower holds the joint that it follows, on a base that moves: the steps were four million.
#[test]
fn a_follower_that_sticks_on_a_moving_base_ends_a_run() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/sticks.toml");
    let functions = RuntimeRobot::simulation_functions();
    let options = ReadOptions::new().functions(functions[2..5].iter().copied());
    let robot = RuntimeRobot::from_file(path, &options).expect("a robot");
    let dynamics = robot.dynamics().expect("all functions");
    #[rustfmt::skip]
    let rotation = Matrix3::new(
        -0.9793617076820234, -0.1856775969155235, 0.07984031268618186,
        0.08311348862945792, -0.009898993591240635, 0.9964909221531935,
        -0.18423570102993575, 0.9825608581302011, 0.025127008107834047,
    );
    let base = Pose {
        rotation,
        position: Vector3::zeros(),
    };
    let q = DVector::from_vec(vec![1.548601312988001, 0.46236036423355187]);
    for method in [
        DormandPrince::default().into(),
        Dop853::default().into(),
        Method::from(Radau5::default()),
    ] {
        let (base, q) = (Some(base), q.clone());
        let run = Simulation::new(&dynamics).initial(Place { base, q }, DVector::zeros(8));
        let run = run
            .friction(Friction::Sign)
            .stops(0.3)
            .method(method)
            .duration(DURATION);
        let end = match (method, run.run()) {
            (Method::Radau5(_), Err(end)) => {
                assert_eq!(end.cause, InvalidSetting::MovingBase.into());
                continue;
            }
            (_, Err(end)) => end,
            (_, Ok(run)) => panic!("{method:?}: {:?}", run.work),
        };
        let is_of_a_joint = matches!(end.cause, Cause::Sticks { joint: 6.. });
        let work = end.trajectory.work;
        assert!(
            is_of_a_joint && work.evaluations < 1_100_000,
            "{method:?}: {end}, {work:?}"
        );
    }
}

mod release {
    #[test]
    #[ignore = "minutes: run before a release"]
    fn two_thousand_random_runs_end_soon() {
        (0..10).for_each(|seed| super::survey(480 + seed, 200));
    }
}
