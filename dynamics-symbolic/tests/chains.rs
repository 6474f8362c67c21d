//! Chains of any length.

mod generic_chain;
mod support;

use generic_chain::generic_chain;
use support::robot;

#[test]
fn generic_chains_are_those_of_the_data_files() {
    for joints in [1, 2, 3, 4, 6, 7, 10, 12] {
        let chain = generic_chain(joints);
        let file = robot(&chain.name);
        assert_eq!(chain.rows, file.rows);
        assert_eq!(chain.gravity, file.gravity);
        assert_eq!(chain.convention, file.convention);
    }
}
