//! Robots whose base moves: every function is proven, and other programs are refused.

use arms::{Bodies, Tables};
use dynamics_symbolic::Function;
use dynamics_symbolic::derive::derive_plain;
use dynamics_symbolic::prove::prove;
use dynamics_symbolic::robot::{Base, Body, Robot, Value};

use crate::trees::{ratio, tree_of_five};

/// Functions that a robot whose base moves has.
fn functions() -> impl Iterator<Item = Function> {
    let of_standing_bases = [
        Function::CoriolisCoefficients,
        Function::CentrifugalCoefficients,
        Function::TaylorSeries,
    ];
    Function::ALL
        .into_iter()
        .filter(move |function| !of_standing_bases.contains(function))
}

fn body() -> Body {
    Body {
        mass: ratio(7, 2),
        com: [ratio(1, 5), ratio(-3, 7), ratio(2, 9)],
        inertia: [(5, 2), (7, 3), (9, 4), (1, 5), (-1, 6), (1, 7)].map(|(a, b)| ratio(a, b)),
    }
}

/// A robot on a base that moves.
fn on_moving_base(robot: Robot) -> Robot {
    Robot {
        base: Some(Base::Floating(body())),
        ..robot
    }
}

fn free_body() -> Robot {
    Robot {
        gravity: [ratio(1, 3), Value::zero(), ratio(-981, 100)],
        rows: Vec::new(),
        ..on_moving_base(tree_of_five())
    }
}

#[test]
fn trial() {
    let mut robots = vec![free_body()];
    let mut tables = Tables::new(21, Bodies::Physical);
    for n in [0, 0, 0, 1, 1, 1] {
        robots.push(on_moving_base(if n == 0 {
            tables.tree()
        } else {
            tables.tree_with_all_cells()
        }));
    }
    for (k, robot) in robots.iter().enumerate() {
        for function in functions() {
            if function.row().of_tip && robot.tip_row().is_none() {
                continue;
            }
            let start = std::time::Instant::now();
            let program = std::panic::catch_unwind(|| derive_plain(robot, function));
            match program {
                Ok(program) => {
                    let result = prove(robot, function, &program).map_err(|f| f.cause);
                    println!("{k} {} {result:?} {:?}", function.name(), start.elapsed());
                }
                Err(_) => println!("{k} {} PANIC", function.name()),
            }
        }
    }
}
