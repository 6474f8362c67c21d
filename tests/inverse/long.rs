//! The tests that are compiled with optimisation: `cargo test --release -p inverse -- --ignored`.

use crate::{arms::*, random_poses_are_solved};

macro_rules! many_random_poses {
    ($($name:ident: $n:literal, $reads_rotation:literal;)*) => {
        $(random_poses_are_solved::<$n, _>(&$name, 100_000);)*
    };
}

#[test]
#[ignore = "a hundred thousand poses of each arm"]
fn every_one_of_many_random_poses_is_solved() {
    for_each_arm!(many_random_poses);
}
