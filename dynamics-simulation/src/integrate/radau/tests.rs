//! Orders, outputs, tolerances, stiffness and ends.

use core::cell::Cell;
use core::convert::Infallible;

use nalgebra::Const;

use super::Radau;
use crate::integrate::test_problems::{ACCELERATION, distance, solution, vector};
use crate::integrate::{Failure, Phase, StepRange, Stepper, Tolerance};

const RANGE: StepRange = StepRange {
    least: 1e-14,
    greatest: 10.0,
};

fn tolerance(value: f64) -> Tolerance {
    Tolerance {
        relative: value,
        absolute: value,
    }
}

/// Errors of the end of two seconds and within the steps, at a fixed step size.
fn errors(steps: usize) -> (f64, f64) {
    let h = 2.0 / steps as f64;
    let Ok(mut run) = Radau::start(&ACCELERATION, solution(0.0), tolerance(1e-13), RANGE);
    run.newton.tolerance = 1e-6;
    // No error is too large.
    run.tolerance = tolerance(1e-6);
    run.range.greatest = h;
    let mut dense = 0.0_f64;
    while run.here.t < 2.0 {
        let before = run.here.t;
        run.h = h;
        run.step(&ACCELERATION, 2.0).unwrap();
        assert_eq!(run.rejected, 0);
        for s in [0.25, 0.5, 0.8] {
            let t = before + s * (run.here.t - before);
            let at = run.at(&ACCELERATION, t).unwrap();
            dense = dense.max(distance(&at, &solution(t)));
        }
    }
    (
        distance(&run.here.phase, &solution(2.0)).log2(),
        dense.log2(),
    )
}

#[test]
fn is_of_fifth_order_with_output_of_local_order_four() {
    let (coarse, fine) = (errors(80), errors(160));
    let order = coarse.0 - fine.0;
    assert!((order - 5.0).abs() < 0.3, "order {order}");
    let dense = coarse.1 - fine.1;
    assert!((dense - 4.0).abs() < 0.3, "dense order {dense}");
}

#[test]
fn output_meets_the_ends_of_the_step() {
    let Ok(mut run) = Radau::start(&ACCELERATION, solution(0.0), tolerance(1e-6), RANGE);
    run.step(&ACCELERATION, 2.0).unwrap();
    let (start, end) = (
        run.polynomial.as_ref().unwrap().at(0.0),
        run.polynomial.as_ref().unwrap().at(run.here.t),
    );
    assert!(distance(&start, &solution(0.0)) < 1e-15);
    assert!(distance(&end, &run.here.phase) < 1e-15);
}

#[test]
fn error_follows_the_tolerance() {
    for value in [1e-4, 1e-7, 1e-10] {
        let Ok(mut run) = Radau::start(&ACCELERATION, solution(0.0), tolerance(value), RANGE);
        while run.here.t < 2.0 {
            run.step(&ACCELERATION, 2.0).unwrap();
        }
        assert_eq!(run.here.t, 2.0);
        let error = distance(&run.here.phase, &solution(2.0));
        assert!((1e-3 * value..10.0 * value).contains(&error), "{error:e}");
    }
}

/// q'' = -b q' - G sin q with b = 10^6, G = 10^3, from rest: q lags by G sin(1) / b^2 behind the
/// solution 2 atan(tan(1/2) exp(-G t / b)) of b q' = -G sin q, up to the next order of 1/b.
#[test]
fn stiff_friction_takes_few_evaluations() {
    let count = Cell::new(0);
    let law = |_: f64, p: &Phase<Const<1>>| {
        count.set(count.get() + 1);
        Ok::<_, Infallible>(vector(-1e6 * p.qd[0] - 1e3 * p.q[0].sin()))
    };
    let start = Phase {
        q: vector(1.0),
        qd: vector(0.0),
    };
    let Ok(mut run) = Radau::start(&law, start, tolerance(1e-8), RANGE);
    while run.here.t < 1.0 {
        run.step(&law, 1.0).unwrap();
    }
    let exact = 2.0 * (0.5_f64.tan() * (-1e-3_f64).exp()).atan() + 1e-9 * 1.0_f64.sin();
    let error = run.here.phase.q[0] - exact;
    assert!(error.abs() < 2e-11, "{error:e}");
    assert!(count.get() < 400, "{}", count.get());
}

#[test]
fn a_wall_is_reached_and_not_crossed() {
    let wall = |t: f64, _: &Phase<Const<1>>| if t < 1.0 { Ok(vector(t)) } else { Err("wall") };
    let mut run = Radau::start(&wall, Phase::zeros(Const), tolerance(1e-6), RANGE).unwrap();
    let failure = loop {
        if let Err(failure) = run.step(&wall, 2.0) {
            break failure;
        }
    };
    assert_eq!(failure, Failure::Refused("wall"));
    assert!(
        run.here.t < 1.0 && run.here.t > 1.0 - 1e-12,
        "{}",
        run.here.t
    );
}
