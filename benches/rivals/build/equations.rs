//! Kinetic and potential energy of an arm as expressions of symplex, from its table.
//!
//! Velocities pass from frame to frame (`w' = R^T w`, `v' = R^T (v + w x p)`), which gives symplex
//! far shorter expressions than the derivatives of positions in the base.

use serde_json::Value;
use symplex::dynamics::{ManipulatorEquation, manipulator_equation};
use symplex::prelude::{Context, Ex, Matrix};
use symplex::robotics::dh_matrix;

use crate::vector::{Vector, cross, dot, plus, translation, turned, turned_back};

/// The equations `M qdd + C qd + G`, and the symbols that they are written in.
pub(crate) struct Equations {
    pub(crate) terms: ManipulatorEquation,
    pub(crate) qd: Vec<Ex>,
    pub(crate) qdd: Vec<Ex>,
    /// The names of q, of qd and of qdd.
    pub(crate) names: [Vec<String>; 3],
}

impl Equations {
    pub(crate) fn new(robot: &Value) -> Self {
        let context = Context::new();
        let joints = robot["joints"].as_array().unwrap();
        let named = |letter: &str| -> Vec<String> {
            (1..=joints.len()).map(|i| format!("{letter}{i}")).collect()
        };
        let names = ["q", "qd", "qdd"].map(named);
        let [q, qd, qdd] = names
            .each_ref()
            .map(|names| -> Vec<Ex> { names.iter().map(|name| context.symbol(name)).collect() });
        let (kinetic, potential) = energies(&context, robot, &q, &qd);
        let references = |symbols: &[Ex]| -> Vec<Ex> { symbols.to_vec() };
        let (qs, qds) = (references(&q), references(&qd));
        let (q, v): (Vec<&Ex>, Vec<&Ex>) = (qs.iter().collect(), qds.iter().collect());
        let terms = manipulator_equation(&kinetic, &potential, &q, &v).unwrap();
        Equations {
            terms,
            qd,
            qdd,
            names,
        }
    }
}

/// T = sum 1/2 m v_c.v_c + 1/2 w.I w + 1/2 J qd^2 and U = -sum m g.c.
fn energies(context: &Context, robot: &Value, q: &[Ex], qd: &[Ex]) -> (Ex, Ex) {
    let number = |value: &Value| exact(context, value.as_f64().unwrap());
    let vector = |value: &Value| -> Vector { std::array::from_fn(|i| number(&value[i])) };
    let zero = || -> Vector { std::array::from_fn(|_| context.int(0)) };
    let standard = robot["convention"] == "standard";
    let gravity = vector(&robot["gravity"]);

    let (mut kinetic, mut potential) = (context.int(0), context.int(0));
    let (mut angular, mut linear) = (zero(), zero());
    let mut base: Option<Matrix> = None;
    for (i, row) in robot["joints"].as_array().unwrap().iter().enumerate() {
        let [a, d, mass] = ["a", "d", "mass"].map(|cell| number(&row[cell]));
        let [alpha, theta] = ["alpha", "theta"].map(|cell| angle(context, &row[cell]));
        let revolute = row["type"] == "revolute";
        let (theta, d) = if revolute {
            (&theta + &q[i], d)
        } else {
            (theta, &d + &q[i])
        };
        let none = context.int(0);
        let before = dh_matrix(&none, &none, &a, &alpha);
        let about_z = dh_matrix(&theta, &d, &none, &none);
        let (spin, slide) = if revolute {
            ([none.clone(), none.clone(), qd[i].clone()], zero())
        } else {
            (zero(), [none.clone(), none.clone(), qd[i].clone()])
        };
        // The joint's own motion comes between the two factors of a row of either convention.
        let factors = if standard {
            [&about_z, &before]
        } else {
            [&before, &about_z]
        };
        for (factor, moves) in factors.into_iter().zip([standard, !standard]) {
            linear = turned_back(
                factor,
                &plus(&linear, &cross(&angular, &translation(factor))),
            );
            angular = turned_back(factor, &angular);
            if moves {
                linear = plus(&linear, &slide);
                angular = plus(&angular, &spin);
            }
            base = Some(base.map_or(factor.clone(), |base| &base * factor));
        }

        let com = vector(&row["com"]);
        let centre = plus(&linear, &cross(&angular, &com));
        let tensor: [Ex; 6] = std::array::from_fn(|k| number(&row["inertia"][k]));
        let [xx, yy, zz, xy, yz, xz] = &tensor;
        let rows = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
        let momentum: Vector = std::array::from_fn(|k| dot(&rows[k].map(Clone::clone), &angular));
        let ratio = number(&row["gear_ratio"]);
        let reflected = &(&ratio * &ratio) * &number(&row["motor_inertia"]);
        let half = context.rational(1, 2);
        let twice = &(&(&mass * &dot(&centre, &centre)) + &dot(&angular, &momentum))
            + &(&reflected * &(&qd[i] * &qd[i]));
        kinetic = &kinetic + &(&half * &twice);

        let base = base.as_ref().unwrap();
        let place = plus(&translation(base), &turned(base, &com));
        potential = &potential - &(&mass * &dot(&gravity, &place));
    }
    (kinetic, potential)
}

/// A double as the decimal that it is written as.
fn exact(context: &Context, value: f64) -> Ex {
    let text = format!("{value:?}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits: i64 = format!("{whole}{fraction}").parse().unwrap();
    let power = fraction.len() as i32 - exponent.parse::<i32>().unwrap();
    let ten = |power: i32| context.int(10).powi(power.into());
    &context.int(digits) * &ten(-power)
}

/// A constant angle: multiples of pi/2 are exact.
fn angle(context: &Context, cell: &Value) -> Ex {
    let quarters = cell.as_f64().unwrap() / std::f64::consts::FRAC_PI_2;
    assert_eq!(quarters, quarters.round(), "no other angles in these arms");
    &context.pi() * &context.rational(quarters as i64, 2)
}
