//! Joints at their stops from random starts: every run ends, and soon.

use std::cell::Cell;

use robot_dynamics::nalgebra::{Const, SVector, Vector1};
use robot_dynamics::{
    Energy, Friction, Method, Model, Simulation, SimulationError, TaylorSimulation, Trajectory,
    robot_dynamics,
    simulation::{Cause, Dop853, DormandPrince, EquationsOfMotion, Radau5, Taylor},
};
use testkit::random::Random;

robot_dynamics! {
    /// Two rods without friction.
    struct Two;

    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        a: revolute { a: 0.5, mass: 2, com: [-0.25, 0, 0], inertia: rod(0.5), limits: [-1, 1.2] },
        b: revolute { a: 0.4, mass: 1, com: [-0.2, 0, 0], inertia: rod(0.4), limits: [-0.8, 0.9] },
    ],
    functions: [default, taylor_series],
}

robot_dynamics! {
    /// A lift on a spring, and two rods with friction of all kinds.
    struct Three;

    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        a: prismatic {
            mass: 3, com: [0, 0.1, 0.1], inertia: cuboid(0.1, 0.2, 0.3), limits: [-0.1, 0.3],
            spring: { stiffness: 200, rest: 0.1 },
        },
        b: revolute {
            a: 0.1, alpha: PI/2, mass: 2, com: [0.25, 0, 0.02], inertia: rod(0.5), limits: [-1, 1.2],
            friction: {
                viscous: 0.1, coulomb: { positive: 0.9, negative: 0.4 }, stribeck: { static: 1.4, velocity: 0.1 },
            },
        },
        c: revolute {
            a: 0.5, mass: 1, com: [0.2, 0, 0], inertia: rod(0.4), limits: [-0.8, 0.9], friction: { coulomb: 0.3 },
        },
    ],
    functions: [default],
}

robot_dynamics! {
    /// Followers with friction.
    struct Coupled;

    convention: modified,
    gravity: [0, -9.81, 0],
    joints: [
        a: revolute {
            mass: 2, com: [0.25, 0, 0], inertia: rod(0.5), limits: [-1, 1.2],
            friction: { coulomb: { positive: 0.5, negative: 0.2 } },
        },
        b: revolute {
            a: 0.5, mass: 1, com: [0.2, 0, 0], inertia: rod(0.4),
            friction: {
                viscous: 0.1, coulomb: { positive: 0.9, negative: 0.4 }, stribeck: { static: 1.4, velocity: 0.1 },
            },
        },
        c: revolute { a: 0.4, mass: 1, com: [0.2, 0, 0], inertia: rod(0.4), limits: [-0.8, 0.9] },
        d: prismatic { a: 0.3, mass: 0.3, friction: { viscous: 0.2, coulomb: 1.5 } },
    ],
    couple: [b = -1.5 * a + 0.2, d = 0.2 * c - 0.1],
    functions: [default],
}

/// The methods of `Simulation`; the Taylor series are the eleventh.
fn methods(step: f64) -> [Method; 10] {
    [
        Method::ExplicitEuler { step },
        Method::CraigEuler { step },
        Method::SemiImplicitEuler { step },
        Method::RungeKutta4 { step },
        Method::ImplicitMidpoint { step },
        Method::GaussLegendre4 { step },
        Method::GaussLegendre6 { step },
        DormandPrince::with_tolerance(1e-9).into(),
        Dop853::with_tolerance(1e-11).into(),
        Radau5::with_tolerance(1e-8).into(),
    ]
}

/// The start of a run, and its laws.
struct Start<const N: usize> {
    q: SVector<f64, N>,
    qd: SVector<f64, N>,
    /// The torques by turns, each for a period, s; or the first of them for the whole run.
    torques: [SVector<f64, N>; 2],
    period: Option<f64>,
    restitution: f64,
}

const DURATION: f64 = 0.6;

impl<const N: usize> Start<N> {
    /// Each joint at one of its ends, at rest or without torque as often as not.
    fn random(arm: &impl Model<N>, random: &mut Random) -> Self {
        let limits = arm.table().joint_limits();
        let q = SVector::from_fn(|i, _| {
            let [low, high] = limits[i].unwrap_or([-1.0, 1.0]);
            random
                .between(1.4 * low - 0.4 * high, 1.4 * high - 0.4 * low)
                .clamp(low, high)
        });
        let mut some = |share: f64, limit: f64| {
            if random.between(0.0, 1.0) < share {
                random.between(-limit, limit)
            } else {
                0.0
            }
        };
        let qd = SVector::from_fn(|_, _| some(0.7, 3.0));
        let torques = [0, 1].map(|_| SVector::from_fn(|_, _| some(0.7, 25.0)));
        // Two thirds of the runs are under constant torques.
        let period = Some(random.between(0.01, 1.8)).filter(|period| *period < DURATION);
        let restitutions = [0.0, 0.1, 0.3, 0.5, 0.8, 0.9, 1.0];
        Start {
            q,
            qd,
            torques,
            period,
            restitution: restitutions[random.between(0.0, 7.0) as usize],
        }
    }

    fn torque(&self, t: f64) -> SVector<f64, N> {
        let turn = self.period.map_or(0, |period| (t / period) as usize);
        self.torques[turn % 2]
    }

    /// The most calls of the torques: a million in a second. Elastic bounces of a joint that torques press against its
    /// stop go on for ever, some in microseconds; no more is asked of such a run than that it ends.
    fn most_calls(&self) -> u64 {
        if self.restitution < 1.0 {
            600_000
        } else {
            20_000_000
        }
    }
}

type Run<const N: usize> = Result<Trajectory<N>, Box<SimulationError<N>>>;

/// The run, and how often the torques were asked for.
fn run<const N: usize>(
    arm: &(impl EquationsOfMotion<Const<N>> + Model<N>),
    start: &Start<N>,
    friction: Friction,
    method: Method,
) -> (Run<N>, u64) {
    let calls = Cell::new(0);
    let torque = |t: f64, _: &SVector<f64, N>, _: &SVector<f64, N>| {
        calls.set(calls.get() + 1);
        if calls.get() > start.most_calls() {
            // It ends there.
            return SVector::repeat(f64::NAN);
        }
        start.torque(t)
    };
    let run = Simulation::new(arm)
        .initial(start.q, start.qd)
        .torque(torque);
    let run = run.friction(friction).stops(start.restitution);
    let run = run.method(method).duration(DURATION).samples(61).run();
    (run, calls.get())
}

fn by_series(start: &Start<2>) -> (Run<2>, u64) {
    let run = TaylorSimulation::new(&Two).initial(start.q, start.qd);
    let run = run.control_period(0.05).torque(|t, _, _| start.torque(t));
    let run = run
        .settings(Taylor::with_tolerance(1e-11))
        .stops(start.restitution);
    let mut run = run.duration(DURATION).samples(61);
    let run = run.run();
    let work = run
        .as_ref()
        .map_or_else(|end| end.trajectory.work, |run| run.work);
    (run, work.evaluations)
}

/// The calls of a run, or the defect that was found in it.
fn verdict<const N: usize>(
    arm: &(impl Model<N> + Energy<N>),
    start: &Start<N>,
    (run, calls): (Run<N>, u64),
    conserves: bool,
) -> Result<u64, String> {
    let run = run.map_err(|error| error.to_string())?;
    if calls > start.most_calls() {
        return Err(format!("{calls} calls"));
    }
    let limits = arm.table().joint_limits();
    for (t, q) in run.t.iter().zip(&run.q) {
        let within = |i: usize| {
            let beyond = |[low, high]: [f64; 2]| f64::max(low - q[i], q[i] - high);
            // Samples within steps are as accurate as these, 1e-8 at worst.
            limits[i].map(beyond).is_none_or(|beyond| beyond < 1e-10)
        };
        if !(0..N).all(within) {
            return Err(format!("beyond a stop at {t} s: {q}"));
        }
    }
    if conserves && start.period.is_none() {
        let work = |q: &SVector<f64, N>| start.torques[0].dot(q);
        let energies = run.energies(arm);
        let left = energies
            .iter()
            .zip(&run.q)
            .map(|(energy, q)| energy - work(q));
        let left: Vec<f64> = left.collect();
        if let Some(k) = left.windows(2).position(|pair| pair[1] > pair[0] + 1e-4) {
            return Err(format!(
                "energy rises after {} s: {} J to {} J",
                run.t[k],
                left[k],
                left[k + 1]
            ));
        }
    }
    Ok(calls)
}

/// Runs of one arm, one method after the other. Returns the defects, and the most calls of a run.
fn survey<const N: usize>(
    arm: &(impl EquationsOfMotion<Const<N>> + Model<N> + Energy<N>),
    frictions: [Friction; 2],
    starts: usize,
) -> (Vec<String>, u64) {
    let (mut wrong, mut most) = (Vec::new(), 0);
    for k in 0..starts {
        let start = Start::random(arm, &mut Random::seeded((1000 * N + k) as u64));
        let (method, friction) = (methods(1e-3)[k % 10], frictions[k / 10 % 2]);
        let conserves = (3..10).contains(&(k % 10)) && k % 10 != 4;
        match verdict(arm, &start, run(arm, &start, friction, method), conserves) {
            Ok(calls) if start.restitution < 1.0 => most = most.max(calls),
            Ok(_) => (),
            Err(what) => wrong.push(format!(
                "e = {}, {N} joints, start {k}, {method:?}, {friction:?}: {what}",
                start.restitution
            )),
        }
    }
    (wrong, most)
}

/// Two thousand runs, each method a tenth of those of an arm and of its kind of friction.
#[test]
#[ignore = "5 s in a release build"]
fn joints_at_their_stops_come_to_rest_from_random_starts() {
    let regularised = Friction::Regularised { speed: 0.05 };
    let frictions = [Friction::Sticking, regularised];
    let mut most = 0;
    let mut wrong = Vec::new();
    for (what, calls) in [
        survey(&Two, [Friction::Sign; 2], 600),
        survey(&Three, frictions, 600),
        survey(&Coupled, frictions, 600),
    ] {
        wrong.extend(what);
        most = most.max(calls);
    }
    for k in 0..200 {
        let start = Start::random(&Two, &mut Random::seeded(k + 10_000));
        match verdict(&Two, &start, by_series(&start), true) {
            Ok(calls) => most = most.max(calls),
            Err(what) => wrong.push(format!("series, start {k}: {what}")),
        }
    }
    println!("at most {most} calls in {DURATION} s where stops are not elastic");
    assert!(
        wrong.is_empty(),
        "{} of 2000:\n{}",
        wrong.len(),
        wrong.join("\n")
    );
}

robot_dynamics! {
    /// A ball that falls along z onto the ground.
    struct Ball;

    convention: modified,
    gravity: [0, 0, -10],
    joints: [height: prismatic { mass: 2, limits: [0, 20] }],
    functions: [default, taylor_series],
}

/// Elastic bounces from two nanometres take 40 microseconds each, for ever: a run of each kind ends after a million
/// evaluations, and says which joint it is; with many samples it goes on.
#[test]
#[ignore = "10 s in a release build"]
fn elastic_bounces_without_end_are_an_error_of_their_joint() {
    let (start, rest) = (Vector1::new(2e-9), Vector1::zeros());
    for method in [
        Method::RungeKutta4 { step: 1.0 },
        Method::GaussLegendre4 { step: 0.1 },
    ] {
        let bounces = Simulation::new(&Ball).initial(start, rest).stops(1.0);
        let bounces = bounces.method(method).duration(4.0);
        let end = bounces.clone().samples(2).run().unwrap_err();
        assert!(matches!(end.cause, Cause::Impacts { joints } if joints.iter().eq([0])));
        let work = end.trajectory.work;
        assert!(
            end.time > 0.1 && work.evaluations < 1_300_000,
            "{method:?}: {end} {work:?}"
        );
        bounces.samples(4001).run().unwrap();
    }
    let series = TaylorSimulation::new(&Ball).initial(start, rest).stops(1.0);
    let end = series.duration(400.0).samples(2).run().unwrap_err();
    let at = "at the stops of joint 1: they hit or leave them again and again";
    assert!(end.to_string().contains(at), "{end}");
}
