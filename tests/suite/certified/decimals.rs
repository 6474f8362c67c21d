//! The dynamics of a table at the decimals that it has.
//!
//! A table at run time has doubles. The constants of generated code are made of the decimals and rounded once,
//! so that these are what their errors are measured from. They differ from the doubles by one part in 2^53 at
//! most: of a function of the cells, f(decimals) - f(doubles) is a difference quotient, of doubles moved by 2^26
//! times the distance, to some 24 digits of the function.

use robot_dynamics::nalgebra::SMatrix;
use robot_dynamics::{
    DoubleDouble,
    table::{Row, Stribeck, Table},
};
use testkit::exact::Exact;
use testkit::references::Decimal;

const MOVED: f64 = 67_108_864.0;

/// A table, and its cells moved towards their decimals and beyond.
pub(super) struct Decimals<const N: usize> {
    doubles: Table<N>,
    moved: Table<N>,
}

impl<const N: usize> Decimals<N> {
    pub(super) fn of(doubles: Table<N>) -> Self {
        let rows = doubles.rows.map(moved_row);
        let gravity = doubles.gravity.map(moved);
        let moved = Table {
            rows,
            gravity,
            ..doubles.clone()
        };
        Decimals { doubles, moved }
    }

    /// A value at the decimals.
    pub(super) fn exact<const R: usize, const C: usize>(
        &self,
        of: impl Fn(&Exact<N>) -> SMatrix<DoubleDouble, R, C>,
    ) -> SMatrix<DoubleDouble, R, C> {
        let at_doubles = of(&Exact(&self.doubles));
        let difference = of(&Exact(&self.moved)) - at_doubles;
        at_doubles + difference.map(|x| x / DoubleDouble::from(MOVED))
    }
}

fn moved_row(row: Row) -> Row {
    Row {
        a: moved(row.a),
        alpha: moved(row.alpha),
        d: moved(row.d),
        theta: moved(row.theta),
        mass: moved(row.mass),
        com: row.com.map(moved),
        inertia: row.inertia.map(moved),
        motor_inertia: moved(row.motor_inertia),
        gear_ratio: moved(row.gear_ratio),
        viscous: moved(row.viscous),
        coulomb: row.coulomb.map(moved),
        stribeck: row.stribeck.map(|stribeck| Stribeck {
            friction: moved(stribeck.friction),
            velocity: moved(stribeck.velocity),
        }),
        ..row
    }
}

/// The shortest decimal that is read as `x` is what stands in the table; multiples of pi/2 are exact as they are.
fn moved(x: f64) -> f64 {
    let quarters = x / std::f64::consts::FRAC_PI_2;
    if quarters.fract() == 0.0 {
        return x;
    }
    let decimal = Decimal::try_from(format!("{x:e}")).expect("a number");
    x - MOVED * decimal.error_of(x)
}
