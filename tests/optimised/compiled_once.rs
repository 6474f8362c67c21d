//! A method is compiled once for each arithmetic, however often it is called.

use std::collections::BTreeSet;
use std::fs;
use std::hint::black_box;
use std::process::Command;

use robot_dynamics::nalgebra::{Matrix3, Vector3};
use robot_dynamics::{CoriolisVector, ForwardDynamics, GravityVector, InverseDynamics, MassMatrix};

use crate::machine_code::Listing;
use crate::three_joints::ThreeJoints;

type Vector = Vector3<f64>;

/// The methods that [`at_six_places`] calls at each place.
const METHODS: [&str; 5] = [
    "mass_matrix",
    "coriolis_vector",
    "gravity_vector",
    "inverse_dynamics",
    "forward_dynamics",
];

/// Sums of the values at six places in the text.
macro_rules! at_six_places {
    ($states:ident, |$q:ident, $qd:ident, $x:ident| $m:expr, $v:expr, $g:expr, $tau:expr, $qdd:expr) => {{
        let (mut matrices, mut vectors) = (Matrix3::zeros(), Vector::zeros());
        at_six_places!(@each [0 1 2 3 4 5] $states, |$q, $qd, $x| {
            matrices += $m;
            vectors += $v + $g + $tau + $qdd.unwrap_or_default();
        });
        (matrices, vectors)
    }};
    (@each [$($place:literal)*] $states:ident, |$q:ident, $qd:ident, $x:ident| $sum:block) => {
        $({
            let [$q, $qd, $x] = &$states[$place];
            $sum
        })*
    };
}

type States = [[Vector; 3]; 6];

#[inline(never)]
fn called_by_methods(states: &States) -> (Matrix3<f64>, Vector) {
    let arm = ThreeJoints;
    at_six_places!(
        states,
        |q, qd, x| arm.mass_matrix(q),
        arm.coriolis_vector(q, qd),
        arm.gravity_vector(q),
        arm.inverse_dynamics(q, qd, x),
        arm.forward_dynamics(q, qd, x)
    )
}

#[inline(never)]
fn called_by_traits<A>(arm: &A, states: &States) -> (Matrix3<f64>, Vector)
where
    A: MassMatrix<3> + CoriolisVector<3> + GravityVector<3> + InverseDynamics<3>,
    A: ForwardDynamics<3>,
{
    at_six_places!(
        states,
        |q, qd, x| arm.mass_matrix(q),
        arm.coriolis_vector(q, qd),
        arm.gravity_vector(q),
        arm.inverse_dynamics(q, qd, x),
        arm.forward_dynamics(q, qd, x)
    )
}

#[test]
fn a_caller_has_calls_in_place_of_programs() {
    let states = black_box([[Vector::repeat(0.1); 3]; 6]);
    let sums = called_by_methods(&states);
    assert_eq!(sums, called_by_traits(&ThreeJoints, &states));
    let program = std::env::current_exe().expect("a program");
    let Some(listing) = Listing::of_program(&program) else {
        return;
    };
    for caller in ["called_by_methods", "called_by_traits"] {
        let called = listing.called_by(caller);
        for method in METHODS {
            let calls = called.iter().filter(|name| name.contains(method));
            let calls: Vec<_> = calls.collect();
            assert_eq!(calls.len(), 6, "{method} in {caller}: {called:?}");
            let different: BTreeSet<_> = calls.into_iter().collect();
            assert_eq!(different.len(), 1, "{different:?}");
        }
    }
}

/// Seconds that processes which this one has started and waited for, and those that these have, took of a
/// processor; `None` where the system does not tell (Linux does).
fn seconds_of_children() -> Option<f64> {
    let text = fs::read_to_string("/proc/self/stat").ok()?;
    // The name of the program is in parentheses; the times are the 16th and the 17th number, in hundredths.
    let (_, behind_name) = text.rsplit_once(')')?;
    let times = behind_name.split_whitespace().skip(13).take(2);
    let ticks = times.map(|time| time.parse::<f64>().ok());
    Some(ticks.sum::<Option<f64>>()? / 100.0)
}

/// Processor time of the compilation of `places.rs`, s.
fn compilation(configuration: &[&str], run: &str) -> Option<f64> {
    let before = seconds_of_children()?;
    let built = Command::new(env!("CARGO"))
        .args(["rustc", "--quiet", "--release", "--bin", "places", "--"])
        .args(configuration)
        // Another name each time: what was compiled in another run is not taken.
        .args(["--cfg", run])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .status();
    assert!(built.is_ok_and(|status| status.success()));
    Some(seconds_of_children()? - before)
}

/// Eleven methods of an arm of six joints, each at 24 places and at one, its equations of motion derived each time.
#[test]
#[ignore = "compiles a program seven times: .ci/run runs it"]
fn twenty_four_places_take_hardly_more_time_than_one() {
    let run = std::process::id();
    // The program's dependencies are compiled first.
    if compilation(&[], &format!("run_{run}")).is_none() {
        return println!("left out: the system does not tell times of children");
    }
    let least = |configuration: &[&str]| {
        let name = configuration.concat().replace('-', "_");
        let times = (0..3).map(|k| compilation(configuration, &format!("run_{run}_{name}_{k}")));
        times.flatten().fold(f64::INFINITY, f64::min)
    };
    let (many, one) = (least(&["--cfg", "at_24_places"]), least(&[]));
    println!("24 places {many:.2} s, one place {one:.2} s");
    assert!(many <= 2.5 * one, "{many:.2} s and {one:.2} s");
}
