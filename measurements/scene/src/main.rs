//! Only what a scene needs: the PUMA 560 complete, without its wrist and abbreviated; what each piece
//! of an arm costs, and what leaving it out does.
//!
//! ```text
//! cargo run --release -p scene
//! ```

use measuring::table::Table;
use robot_dynamics::Operations;
use robot_dynamics::nalgebra::{Vector3, Vector6};
use scene::arms::{Puma, PumaWithoutWrist};
use scene::features::features;
use scene::measure::{State, operations, states, time, times};
use testkit::five::NAMES;

const TITLE: &str = "\
Operations / ns / error of a function: its largest difference from that of the complete arm
at 500 random states (within pi, 3 rad/s, 10 rad/s^2) over the largest value of that";

fn main() {
    let mut table = Table::new(TITLE, &[&["arm", "without"][..], &NAMES].concat());
    for feature in features() {
        let errors = feature.errors.map(|error| format!("{error:.0e}"));
        let names = [feature.arm, feature.without];
        row(
            &mut table,
            names,
            feature.operations,
            feature.nanoseconds,
            errors,
        );
    }
    row(
        &mut table,
        ["PUMA 560", "wrist, which is locked"],
        operations(&PumaWithoutWrist::OPERATIONS),
        times(&PumaWithoutWrist),
        ["-"; 5].map(str::to_owned),
    );
    println!("{}", table.text());
    println!("Without the wrist, beside the complete arm's first three joints:");
    println!(
        "  the wrist at rest where it is locked: tau differs by {:.0e} of its largest value,",
        wrist(0.0)
    );
    println!(
        "  the wrist in motion (3 rad/s, 10 rad/s^2):           {:.0e}.\n",
        wrist(1.0)
    );
    println!("{}", articulated().text());
}

fn row(
    table: &mut Table,
    names: [&str; 2],
    operations: [u32; 5],
    times: [f64; 5],
    errors: [String; 5],
) {
    let cells = (0..5).map(|k| format!("{} / {:.0} / {}", operations[k], times[k], errors[k]));
    table.row(names.map(str::to_owned).into_iter().chain(cells));
}

/// Forward dynamics by articulated bodies beside the factored mass matrix.
fn articulated() -> Table {
    let mut table = Table::new(
        "The PUMA 560's accelerations",
        &["function", "operations", "ns"],
    );
    let all: &[(&str, Operations)] = &Puma::OPERATIONS;
    let mut row = |name: &str, time: f64| {
        let found = all.iter().find(|(function, _)| *function == name);
        let operations = found.map_or(0, |(_, operations)| operations.total());
        table.row([
            name.to_owned(),
            operations.to_string(),
            format!("{time:.0}"),
        ]);
    };
    row(
        "forward_dynamics",
        time(|[q, qd, tau]: &State<6>| Puma.forward_dynamics(q, qd, tau)),
    );
    row(
        "forward_dynamics_aba",
        time(|[q, qd, tau]: &State<6>| Puma.forward_dynamics_aba(q, qd, tau)),
    );
    table
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
