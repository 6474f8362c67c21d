//! Only what a scene needs: the PUMA 560 complete, without its wrist and abbreviated; what each piece
//! of an arm costs, and what leaving it out does.
//!
//! ```text
//! cargo run --release -p scene
//! ```

use robot_dynamics::nalgebra::{Vector3, Vector6};
use scene::arms::{Puma, PumaWithoutWrist};
use scene::features::{Feature, features};
use scene::measure::{self, FUNCTIONS, State, operations, states, times};

fn main() {
    println!(
        "Operations / ns / error of a function: its largest difference from that of the complete arm"
    );
    println!(
        "at 500 random states (within pi, 3 rad/s, 10 rad/s^2) over the largest value of that.\n"
    );
    heading();
    let features = features();
    for Feature {
        arm,
        without,
        operations,
        nanoseconds,
        errors,
    } in &features
    {
        row(arm, without, operations, nanoseconds, Some(errors));
    }
    let (count, time) = (
        operations(&PumaWithoutWrist::OPERATIONS),
        times(&PumaWithoutWrist),
    );
    row("PUMA 560", "wrist, which is locked", &count, &time, None);
    println!("\nWithout the wrist, beside the complete arm's first three joints:");
    println!(
        "  the wrist at rest where it is locked: tau differs by {:.0e} of its largest value,",
        wrist(0.0)
    );
    println!(
        "  the wrist in motion (3 rad/s, 10 rad/s^2):           {:.0e}.",
        wrist(1.0)
    );
    articulated();
}

/// Forward dynamics by articulated bodies beside the factored mass matrix.
fn articulated() {
    let all = &Puma::OPERATIONS;
    let total = |name: &str| {
        all.iter()
            .find(|(function, _)| *function == name)
            .map(|(_, o)| o.total())
    };
    let time = |articulated: bool| {
        measure::time(|[q, qd, tau]: &State<6>| {
            let solution = match articulated {
                true => Puma.forward_dynamics_aba(q, qd, tau),
                false => Puma.forward_dynamics(q, qd, tau),
            };
            let _ = std::hint::black_box(solution);
        })
    };
    println!("\nThe PUMA 560's accelerations:");
    for (name, is_articulated) in [("forward_dynamics", false), ("forward_dynamics_aba", true)] {
        println!(
            "  {name:22}{:>6} operations{:>6.0} ns",
            total(name).unwrap_or(0),
            time(is_articulated)
        );
    }
}

fn heading() {
    print!("{:9} {:24}", "arm", "without");
    for function in FUNCTIONS {
        print!("{function:>22}");
    }
    println!();
}

fn row(
    arm: &str,
    without: &str,
    operations: &[u32; 5],
    times: &[f64; 5],
    errors: Option<&[f64; 5]>,
) {
    print!("{arm:9} {without:24}");
    for k in 0..FUNCTIONS.len() {
        let error = errors.map_or(String::new(), |errors| format!("{:.0e}", errors[k]));
        print!("{:>8}{:>6.0}{error:>8}", operations[k], times[k]);
    }
    println!();
}

/// The largest difference of the first three joint torques of the arm without its wrist from those
/// of the complete arm, whose wrist is at the locked pose and moves as in a random state times
/// `motion`.
fn wrist(motion: f64) -> f64 {
    let (mut difference, mut size) = (0.0_f64, 0.0_f64);
    for state in states::<6>() {
        let [q, qd, qdd]: State<6> = state;
        let arm = |x: Vector6<f64>| Vector3::new(x[0], x[1], x[2]);
        let whole = |x: Vector6<f64>, wrist: f64| {
            Vector6::from_fn(|i, _| if i < 3 { x[i] } else { wrist * x[i] })
        };
        let complete =
            Puma.inverse_dynamics(&whole(q, 0.0), &whole(qd, motion), &whole(qdd, motion));
        let locked = PumaWithoutWrist.inverse_dynamics(&arm(q), &arm(qd), &arm(qdd));
        difference = difference.max((arm(complete) - locked).amax());
        size = size.max(arm(complete).amax());
    }
    difference / size
}
