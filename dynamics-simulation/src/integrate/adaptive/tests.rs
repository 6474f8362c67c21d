//! Orders, outputs, tolerances and ends.

use core::convert::Infallible;

use nalgebra::Const;

use super::{Adaptive, Embedded};
use crate::integrate::test_problems::{ACCELERATION, Acceleration, distance, solution, vector};
use crate::integrate::{
    Dop853Method, DormandPrince54, Equations, Failure, Phase, StepRange, Stepper, Tolerance,
};

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

fn start<M: Embedded<Const<1>>>(value: f64) -> Adaptive<M, Const<1>> {
    let Ok(run) = Adaptive::start(&ACCELERATION, solution(0.0), tolerance(value), RANGE);
    run
}

/// The test problem at its start, with a given step size.
fn with_step<M: Embedded<Const<1>>>(h: f64) -> Adaptive<M, Const<1>> {
    let mut run = start::<M>(1e6);
    run.range.greatest = h;
    run.next.h = h;
    run
}

fn step<M: Embedded<Const<1>>>(run: &mut Adaptive<M, Const<1>>) {
    run.step(&ACCELERATION, 2.0).unwrap();
}

fn at<M: Embedded<Const<1>>>(run: &mut Adaptive<M, Const<1>>, t: f64) -> Phase<Const<1>> {
    run.at(&ACCELERATION, t).unwrap()
}

/// Errors of the end of two seconds and of the middles of the steps, at a fixed step size.
fn errors<M: Embedded<Const<1>>>(steps: usize) -> (f64, f64) {
    let mut run = with_step::<M>(2.0 / steps as f64);
    let mut dense = 0.0_f64;
    while run.next.t < 2.0 {
        let before = run.next.t;
        step(&mut run);
        for s in [0.25, 0.5, 0.8] {
            let t = before + s * (run.next.t - before);
            dense = dense.max(distance(&at(&mut run, t), &solution(t)));
        }
    }
    (
        distance(&run.next.phase, &solution(2.0)).log2(),
        dense.log2(),
    )
}

#[test]
fn dormand_prince_is_of_fifth_order_with_output_of_local_order_five() {
    let (coarse, fine) = (errors::<DormandPrince54>(40), errors::<DormandPrince54>(80));
    let order = coarse.0 - fine.0;
    assert!((order - 5.0).abs() < 0.2, "order {order}");
    // The polynomial is of fourth order: its own error within one step falls with h^5.
    let dense = coarse.1 - fine.1;
    assert!((dense - 5.0).abs() < 0.3, "dense order {dense}");
}

#[test]
fn dop853_is_of_eighth_order_with_output_of_local_order_eight() {
    let (coarse, fine) = (errors::<Dop853Method>(8), errors::<Dop853Method>(16));
    let order = coarse.0 - fine.0;
    assert!((order - 8.0).abs() < 0.4, "order {order}");
    let dense = coarse.1 - fine.1;
    assert!((dense - 8.0).abs() < 0.5, "dense order {dense}");
}

fn check_output<M: Embedded<Const<1>>>() {
    let mut run = with_step::<M>(0.1);
    for before in [0.0, 0.1] {
        let from = run.next.phase.clone();
        step(&mut run);
        assert_eq!(at(&mut run, before), from);
        let end = run.next.t;
        assert_eq!(at(&mut run, end), run.next.phase);
        let before_the_end = M::evaluate(run.polynomial.as_ref().unwrap(), 1.0);
        assert!(distance(&before_the_end, &run.next.phase) < 1e-15);
    }
}

#[test]
fn output_meets_the_ends_of_the_step() {
    check_output::<DormandPrince54>();
    check_output::<Dop853Method>();
}

fn check_tolerance<M: Embedded<Const<1>>>(least: f64) {
    for value in [1e-4, 1e-7, 1e-10] {
        let mut run = start::<M>(value);
        while run.next.t < 2.0 {
            step(&mut run);
        }
        assert_eq!(run.next.t, 2.0);
        let error = distance(&run.next.phase, &solution(2.0));
        assert!((least * value..10.0 * value).contains(&error), "{error:e}");
    }
}

#[test]
fn error_follows_the_tolerance() {
    check_tolerance::<DormandPrince54>(1e-2);
    // Its estimate is of lower order than its error.
    check_tolerance::<Dop853Method>(1e-4);
}

fn failure<M: Embedded<Const<1>>, S: Equations<Const<1>>>(
    system: &S,
    start: Phase<Const<1>>,
) -> (f64, Failure<S::Refusal>) {
    let Ok(mut run) = Adaptive::<M, Const<1>>::start(system, start, tolerance(1e-6), RANGE) else {
        panic!("refused at the start");
    };
    loop {
        if let Err(failure) = run.step(system, 2.0) {
            return (run.next.t, failure);
        }
    }
}

#[test]
fn a_wall_is_reached_and_not_crossed() {
    let wall = |t: f64, _: &Phase<Const<1>>| if t < 1.0 { Ok(vector(t)) } else { Err("wall") };
    for (t, failure) in [
        failure::<DormandPrince54, _>(&wall, Phase::zeros(Const)),
        failure::<Dop853Method, _>(&wall, Phase::zeros(Const)),
    ] {
        assert_eq!(failure, Failure::Refused("wall"));
        assert!(t < 1.0 && t > 1.0 - 1e-12, "{t}");
    }
}

#[test]
fn a_pole_ends_in_a_step_that_is_too_small() {
    // q' = 1 / (1 - t), which no step passes.
    let pole =
        |_: f64, phase: &Phase<Const<1>>| Ok::<_, Infallible>(phase.qd.component_mul(&phase.qd));
    let start = Phase {
        q: vector(0.0),
        qd: vector(1.0),
    };
    for (t, failure) in [
        failure::<DormandPrince54, _>(&pole, start.clone()),
        failure::<Dop853Method, _>(&pole, start),
    ] {
        assert_eq!(failure, Failure::StepTooSmall);
        // The place of the pole is as accurate as the steps before it.
        assert!((t - 1.0).abs() < 1e-5, "{t}");
    }
}

/// From rest with an acceleration that is even in time, embedded differences may vanish: the
/// first step must be short all the same, and the steps after it no longer than each permits.
fn check_rest<M: Embedded<Const<1>>>() {
    let swing = |_: f64, phase: &Phase<Const<1>>| Ok::<_, Infallible>(vector(-phase.q[0].cos()));
    let range = StepRange {
        greatest: f64::INFINITY,
        ..RANGE
    };
    let Ok(mut run) =
        Adaptive::<M, Const<1>>::start(&swing, Phase::zeros(Const), tolerance(1e-9), range);
    let mut steps = 0;
    while run.next.t < 10.0 {
        run.step(&swing, 10.0).unwrap();
        steps += 1;
    }
    assert!(steps > 10, "{steps}");
    let energy = 0.5 * run.next.phase.qd[0].powi(2) + run.next.phase.q[0].sin();
    assert!(energy.abs() < 1e-7, "{energy}");
}

#[test]
fn a_start_from_rest_is_not_stepped_over() {
    check_rest::<DormandPrince54>();
    check_rest::<Dop853Method>();
}

/// Stages, rates at the ends and stages of the output.
#[test]
fn evaluations_are_those_of_the_method() {
    let count = core::cell::Cell::new(0);
    let counted = |t: f64, phase: &Phase<Const<1>>| {
        count.set(count.get() + 1);
        let acceleration: Acceleration = ACCELERATION;
        acceleration(t, phase)
    };
    let Ok(mut run) =
        Adaptive::<Dop853Method, Const<1>>::start(&counted, solution(0.0), tolerance(1e6), RANGE);
    count.set(0);
    run.step(&counted, 1.0).unwrap();
    assert_eq!(count.replace(0), 12);
    for t in [0.3, 0.5] {
        run.at(&counted, t * run.next.t).unwrap();
    }
    assert_eq!(count.get(), 3);
}
