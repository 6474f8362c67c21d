//! Chains of any length.

use arms::generic_chain;
use arms::robot;
use dynamics_symbolic::{Function, expand};
use quote::quote;

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

/// An expansion is proven. That the text compiles is seen by the example `growth`.
#[test]
fn thirty_axes_expand() {
    let functions = Function::default_set(false);
    let methods = expand(&generic_chain(30), &functions, &quote!(::robot_dynamics));
    let methods = methods.unwrap_or_else(|failures| panic!("{}", failures[0]));
    assert_eq!(methods.len(), functions.len());
    // Linear in the joints: what is asked of 30 axes in tests/data/hard_cases.json, HC42, and half of it is there.
    let tau = methods
        .iter()
        .find(|m| m.request.function() == Some(Function::InverseDynamics));
    assert!(tau.expect("tau").operations.total() <= 9_000);
}
