//! Friction by direction, and static friction that falls to Coulomb's: printed values, motions with closed
//! forms, and a check that finds every wrong cell.

use robot_dynamics::nalgebra::{SVector, Vector1};
use robot_dynamics::{
    Batch, ForwardDynamics, Friction, Method, Model, Simulation, State, Trajectory,
    check::{Check, Evaluate, Evaluation},
    check_against_rnea, robot_dynamics,
    simulation::{Dop853, Radau5},
    table::{Spring, Stribeck, Table},
};

use tables::data::load;

robot_dynamics! {
    /// Friction of the PUMA 560 as it was published, by direction (Corke and Armstrong-Helouvry 1994).
    struct Puma;

    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        waist: revolute {
            friction: { viscous: 5.80182176795, coulomb: { positive: 24.7313845, negative: 27.2358285 } },
        },
        shoulder: revolute {
            friction: { viscous: 9.49686864183, coulomb: { positive: 13.58469, negative: 7.654865 } },
        },
        elbow: revolute {
            friction: { viscous: 3.98042599037, coulomb: { positive: 7.0892316, negative: 5.6391615 } },
        },
        roll: revolute {
            friction: { viscous: 0.411645229697, coulomb: { positive: 0.85160768, negative: 1.28501516 } },
        },
        bend: revolute {
            friction: { viscous: 0.427283020935, coulomb: { positive: 0.66600698, negative: 1.0428835 } },
        },
        twist: revolute {
            friction: { viscous: 0.215823253273, coulomb: { positive: 0.30367656, negative: 0.805203 } },
        },
    ],
    functions: [friction_vector],
}

robot_dynamics! {
    /// A block on a level rail.
    struct Block { mass: f64, forth: f64, back: f64, holding: f64, slow: f64 }

    convention: standard,
    gravity: [0, 0, 0],
    joints: [
        slide: prismatic {
            mass: mass,
            friction: {
                coulomb: { positive: forth, negative: back },
                stribeck: { static: holding, velocity: slow },
            },
        },
    ],
    functions: [
        mass_matrix, friction_vector, inverse_dynamics, forward_dynamics, bias_force,
        inverse_dynamics_derivatives, forward_dynamics_derivatives, forward_dynamics_aba,
    ],
}

robot_dynamics! {
    /// A block on a rail that rubs more one way than the other.
    struct Rail { forth: f64, back: f64 }

    convention: standard,
    gravity: [0, 0, 0],
    joints: [
        slide: prismatic { mass: 2, friction: { coulomb: { positive: forth, negative: back } } },
    ],
    functions: [mass_matrix, inverse_dynamics, forward_dynamics],
}

const RAIL: Rail = Rail {
    forth: 3.0,
    back: 1.0,
};

const BLOCK: Block = Block {
    mass: 2.0,
    forth: 3.0,
    back: 1.0,
    holding: 5.0,
    slow: 0.05,
};

/// The columns of the data file are those of a program of others: friction there has the sign of the
/// velocity in its Coulomb terms.
#[test]
fn the_puma_rubs_as_published() {
    let file = load("robots/puma560");
    let viscous = |i: usize| file["joints"][i]["viscous"].as_f64().unwrap();
    let dry = |i: usize, key: &str| file["rtb_friction"][i][key].as_f64().unwrap();
    for speed in [1e-3, 0.7, 12.0] {
        let (forth, back) = (SVector::repeat(speed), SVector::repeat(-speed));
        let (forth, back) = (Puma.friction_vector(&forth), Puma.friction_vector(&back));
        for i in 0..6 {
            let of_speed = viscous(i) * speed;
            let positive = of_speed + dry(i, "coulomb_joint_pos");
            let negative = -of_speed + dry(i, "coulomb_joint_neg");
            assert!((forth[i] - positive).abs() <= 1e-14 * positive, "joint {i}");
            assert!((back[i] - negative).abs() <= -1e-14 * negative, "joint {i}");
        }
    }
    let still = SVector::<f64, 6>::zeros();
    assert_eq!(Puma.friction_vector(&still), still);
}

#[test]
fn static_friction_falls_to_that_of_the_direction() {
    let at = |qd: f64| BLOCK.friction_vector(&Vector1::new(qd))[0];
    assert_eq!([at(0.0), at(10.0), at(-10.0)], [0.0, 3.0, -1.0]);
    let left = (-1.0_f64).exp();
    for (qd, expected) in [(0.05, 3.0 + 2.0 * left), (-0.05, -1.0 - 4.0 * left)] {
        assert!((at(qd) - expected).abs() <= 4e-15, "{qd}");
    }
    assert!((at(1e-12) - 5.0).abs() <= 4e-15);
    assert!((at(-1e-12) + 5.0).abs() <= 4e-15);
    assert_eq!([at(f64::MAX), at(f64::MIN)], [3.0, -1.0]);
    assert!(at(f64::NAN).is_nan());
}

#[test]
fn every_function_agrees_with_newton_euler() {
    for slow in [0.05, 1.0, 1e-3] {
        let report = check_against_rnea(&Block { slow, ..BLOCK });
        report.assert_ok();
        // The special ones, a hundred random ones, and those at which friction falls.
        assert_eq!(report.states, 136);
    }
}

/// In the lanes of vectors the exponential is that of single calls.
#[test]
fn batches_are_single_calls() {
    let states = 0..37;
    let velocity = |i: i32| Vector1::new(0.01 * f64::from(i - 18));
    let still = vec![Vector1::zeros(); 37];
    let qd: Vec<_> = states.map(velocity).collect();
    let mut tau = still.clone();
    let batch = BLOCK.inverse_dynamics_batch(&still, &qd, &still, &mut tau);
    batch.unwrap();
    for (qd, tau) in qd.iter().zip(&tau) {
        let single = BLOCK.friction_vector(qd)[0];
        assert!((tau[0] - single).abs() <= 2e-15, "{qd}: {tau} and {single}");
    }
}

/// The block with another table: what the numeric side reads.
struct Misread(fn(&mut robot_dynamics::table::Row));

impl Model<1> for Misread {
    const JOINT_NAMES: [&'static str; 1] = ["slide"];

    fn table(&self) -> Table<1> {
        let mut table = BLOCK.table();
        self.0(&mut table.rows[0]);
        table
    }
}

impl Evaluate<1> for Misread {
    fn evaluate(&self, state: &State<1>, tau: &SVector<f64, 1>) -> Evaluation {
        BLOCK.evaluate(state, tau)
    }
}

/// A program with a wrong number in any of the cells is found by the check.
#[test]
fn a_wrong_cell_is_found() {
    let changes: [fn(&mut robot_dynamics::table::Row); 6] = [
        |row| row.coulomb[0] *= 1.0 + 1e-9,
        |row| row.coulomb[1] *= 1.0 + 1e-9,
        |row| {
            row.stribeck = Some(Stribeck {
                friction: 5.0 + 1e-8,
                velocity: 0.05,
            });
        },
        |row| {
            row.stribeck = Some(Stribeck {
                friction: 5.0,
                velocity: 0.05 * (1.0 + 1e-8),
            });
        },
        |row| row.viscous = 1e-8,
        |row| {
            row.spring = Spring {
                stiffness: 1e-8,
                rest: 0.0,
            };
        },
    ];
    for (i, change) in changes.into_iter().enumerate() {
        let report = Check::new().run(&Misread(change));
        assert!(!report.is_ok(), "change {i}: {report}");
    }
    Check::new().run(&Misread(|_| {})).assert_ok();
}

fn methods() -> [Method; 3] {
    [
        Dop853::with_tolerance(1e-11).into(),
        Radau5::with_tolerance(1e-10).into(),
        Method::GaussLegendre6 { step: 2e-3 },
    ]
}

fn run(
    block: &(impl ForwardDynamics<1> + Model<1>),
    method: Method,
    qd: f64,
    duration: f64,
    force: impl Fn(f64, f64) -> f64,
) -> Trajectory<1> {
    let start = Simulation::new(block).torque(|t, q, _| Vector1::new(force(t, q[0])));
    let start = start.initial(Vector1::zeros(), Vector1::new(qd));
    let start = start.friction(Friction::Sticking).method(method);
    start.duration(duration).samples(1001).run().unwrap()
}

/// The first sample at which the block moves.
fn starts(run: &Trajectory<1>) -> f64 {
    let moving = run.qd.iter().position(|qd| qd[0] != 0.0);
    run.t[moving.expect("it moves")]
}

/// Coulomb friction of the direction brakes, and holds: from 3 m/s either way, and pulled by a force that
/// grows.
#[test]
fn coulomb_friction_is_that_of_the_direction() {
    for method in methods() {
        for (way, coulomb) in [(1.0, 3.0), (-1.0, 1.0)] {
            let stops = run(&RAIL, method, way * 3.0, 7.0, |_, _| 0.0);
            for (t, qd) in stops.t.iter().zip(&stops.qd) {
                let expected = way * (3.0 - coulomb / 2.0 * t).max(0.0);
                let near = (qd[0] - expected).abs();
                assert!(near < 1e-12, "{method:?} at {t}: {near:e}");
            }
            assert_eq!(stops.qd[1000][0], 0.0, "{method:?}");
            let pulled = run(&RAIL, method, 0.0, 8.0, |t, _| way * t);
            for (t, qd) in pulled.t.iter().zip(&pulled.qd) {
                let expected = way * 0.25 * (t - coulomb).max(0.0).powi(2);
                let near = (qd[0] - expected).abs();
                assert!(near < 1e-9, "{method:?} at {t}: {near:e}");
            }
        }
    }
}

/// Pulled by a force that grows: it stays at rest to the last bit until static friction is overcome, in
/// either direction, and then runs away, for less holds it then.
#[test]
fn a_block_breaks_away_at_static_friction() {
    for method in methods() {
        for way in [1.0, -1.0] {
            let run = run(&BLOCK, method, 0.0, 8.0, |t, _| way * t);
            let first = starts(&run);
            assert!((5.0..5.02).contains(&first), "{method:?} {way}: {first}");
            // Under Coulomb friction alone from there on it would be slower at every time.
            let coulomb = if way > 0.0 { 3.0 } else { 1.0 };
            let speed = |t: f64| ((t * t - 25.0) / 2.0 - coulomb * (t - 5.0)) / 2.0;
            // After 0.8 s it has 0.16 m/s from the growth of the force alone: static friction is gone.
            let most = 0.8 * (5.0 - coulomb) / 2.0;
            for (t, qd) in run.t.iter().zip(&run.qd).filter(|(t, _)| **t > 5.5) {
                let behind = speed(*t) - way * qd[0];
                assert!((0.0..most).contains(&behind), "{method:?} at {t}: {behind}");
            }
        }
    }
}

/// A spring drags the block after a hand that moves evenly: it sticks and slips by turns, and what one
/// method says, another does too.
#[test]
fn a_block_on_a_slow_spring_sticks_and_slips() {
    let drag = |method| run(&BLOCK, method, 0.0, 12.0, |t, q| 20.0 * (0.5 * t - q));
    let [exact, others @ ..] = methods().map(drag);
    let stuck = exact.qd.iter().filter(|qd| qd[0] == 0.0).count();
    assert!((200..900).contains(&stuck), "{stuck}");
    let pairs = exact.qd.windows(2);
    let slips = pairs.filter(|pair| pair[0][0] == 0.0 && pair[1][0] != 0.0);
    assert!(slips.count() > 3);
    // It lets go for the first time where the spring pulls with 5 N.
    assert!((0.5..0.52).contains(&starts(&exact)));
    for other in others {
        let error = (other.q[1000] - exact.q[1000]).amax();
        assert!(error < 1e-5, "{error:e}");
    }
}

/// Regularised, friction has the magnitude of the direction as soon as it moves.
#[test]
fn regularised_friction_knows_the_direction() {
    let kind = Friction::Regularised { speed: 1e-4 };
    for (way, coulomb) in [(1.0, 3.0), (-1.0, 1.0)] {
        let push = Simulation::new(&RAIL).torque(|_, _, _| Vector1::new(way * 7.0));
        let push = push.friction(kind).method(Radau5::with_tolerance(1e-8));
        let run = push.duration(1.0).run().unwrap();
        let expected = way * (7.0 - coulomb) / 2.0;
        let error = (run.qd[100][0] - expected).abs();
        assert!(error < 1e-3, "{way}: {error:e}");
    }
}
