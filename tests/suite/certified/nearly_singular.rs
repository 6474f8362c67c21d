//! Bounds of accelerations beside what [`Conditioning`] predicts, where M is nearly singular.

use super::{exactly, largest};
use robot_dynamics::nalgebra::Vector2;
use robot_dynamics::{Conditioning, DoubleDouble, certified, robot_dynamics};

robot_dynamics! {
    /// Two point masses at the ends of two links, without a constant that is rounded.
    struct PointMasses { load: f64, g: f64 }
    convention: modified,
    gravity: [0, -g, 0],
    joints: [
        shoulder: revolute { mass: 1, com: [1, 0, 0] },
        elbow: revolute { a: 1, mass: load, com: [1, 0, 0] },
    ],
    functions: [mass_matrix, inverse_dynamics, forward_dynamics],
}

/// The error of the accelerations and its bound, relative to them, over what the pivots predict.
fn over_predicted(load: f64, elbow: f64) -> [f64; 2] {
    let arm = PointMasses { load, g: 9.81 };
    let (q, qd) = (Vector2::new(0.7, elbow), Vector2::new(0.3, -0.2));
    let tau = arm.inverse_dynamics(&q, &qd, &Vector2::new(1.0, -2.0));
    let [x, xd, force] = [&q, &qd, &tau].map(|x| x.map(DoubleDouble::from));
    let exact = arm.forward_dynamics(&x, &xd, &force).expect("regular");
    let [x, xd, force] = [&q, &qd, &tau].map(exactly::<f64, 2>);
    let found = certified::forward_dynamics(&arm, &x, &xd, &force).expect("regular");
    let errors = found.zip_map(&exact, |found, exact| {
        exact - DoubleDouble::from(found.value())
    });
    let bound = found.map(|x| x.bound()).max();
    assert!(largest(&errors) <= bound);
    let predicted = Conditioning::of(&arm.mass_matrix(&q)).error() * largest(&exact);
    [largest(&errors), bound].map(|x| x / predicted)
}

/// From a pivot of nearly 1 to one of 1e-12, by a load on an arm that is nearly stretched: the bound is the error, and
/// both are of the size that the least pivot tells.
#[test]
fn bounds_and_pivots_agree() {
    for load in [1.0, 1e3, 1e6, 1e9] {
        let mut means = [0.0; 2];
        for k in 0..10 {
            let elbow = 1e-2 * (1.0 + 0.37 * f64::from(k));
            let ratios = over_predicted(load, elbow);
            means = [0, 1].map(|i| means[i] + 0.1 * ratios[i]);
            assert!(ratios[1] < 4.0, "{load:e} {elbow}: {ratios:?}");
        }
        println!(
            "load {load:e}: error {:.3}, bound {:.3} of what is predicted",
            means[0], means[1]
        );
        assert!(means[1] > 0.02 && means[1] < 5.0 * means[0], "{means:?}");
    }
}
