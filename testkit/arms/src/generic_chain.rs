//! Generic chains of any length: revolute joints, every cell of the table non-zero, full tensors.
//!
//! The cells are residues of multiples of the row's number. A shorter chain is the beginning of a
//! longer one, and those of up to twelve joints are the data files `generic_chain_n*.json`.

use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::{Convention, JointType, Robot, Row, Value};

/// The chain of `joints` joints, standard convention, gravity down.
pub fn generic_chain(joints: usize) -> Robot {
    Robot {
        name: format!("generic_chain_n{joints}"),
        fields: Vec::new(),
        convention: Convention::Standard,
        gravity: [thousandths(0), thousandths(0), thousandths(-9_810)],
        rows: (1..=joints as i64).map(row).collect(),
        frames: Vec::new(),
        neglected: None,
        bounds: Default::default(),
        base: None,
        tool: None,
    }
}

/// Row k, counted from 1.
fn row(k: i64) -> Row {
    let alternating = if k % 2 == 1 { 1 } else { -1 };
    Row {
        a: thousandths(100 + 10 * (7 * k % 11)),
        alpha: thousandths(100 * (11 * k % 25 - 12)),
        d: thousandths(alternating * (50 + 10 * (5 * k % 13))),
        theta: thousandths(cycle(k, [250, 300, -100, 200, -200, 100, -300])),
        mass: thousandths(500 + 100 * (13 * k % 31)),
        com: com(k, alternating).map(thousandths),
        inertia: inertia(k).map(ten_thousandths),
        ..Row::new(format!("joint{k}"), JointType::Revolute)
    }
}

/// Centre of mass, mm.
fn com(k: i64, alternating: i64) -> [i64; 3] {
    let sign_x = if k % 3 == 0 { -1 } else { 1 };
    let sign_y = if k % 4 < 2 { -1 } else { 1 };
    [
        sign_x * 10 * (9 - (k - 1) % 9),
        sign_y * 10 * ((-2 * k).rem_euclid(7) + 1),
        alternating * 10 * (8 - (k - 1) % 8),
    ]
}

/// xx, yy, zz, xy, yz, xz in 1e-4 kg m^2: I = tr(S) 1 - S with S positive definite.
fn inertia(k: i64) -> [i64; 6] {
    let (x, y, z) = (9 - (k - 1) % 6, 3 + 2 * k % 5, 5 + 4 * k % 7);
    let sign = if k % 3 == 2 { 1 } else { -1 };
    [
        10 * (y + z),
        10 * (x + z),
        10 * (x + y),
        cycle(k, [-10, 15, -5, 10, -15, 5]),
        cycle(k, [-8, -4, 8, -4, -8, 4]),
        sign * cycle(k, [6, 9, 12, 3]),
    ]
}

fn cycle<const N: usize>(k: i64, values: [i64; N]) -> i64 {
    values[(k - 1) as usize % N]
}

fn thousandths(x: i64) -> Value {
    Value::Rational(Rational::from(x) / Rational::from(1_000))
}

fn ten_thousandths(x: i64) -> Value {
    Value::Rational(Rational::from(x) / Rational::from(10_000))
}
