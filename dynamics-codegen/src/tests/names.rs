//! Names of variables in what a call expands to.

use std::collections::BTreeSet;

use dynamics_symbolic::Function;
use syn::visit::Visit;

use crate::expand::names::NAMES;

/// The names that patterns bind.
#[derive(Default)]
struct Bound(BTreeSet<String>);

impl<'ast> Visit<'ast> for Bound {
    fn visit_pat_ident(&mut self, pattern: &'ast syn::PatIdent) {
        self.0.insert(pattern.ident.to_string());
    }

    /// The items that are handed on to the runtime's macro.
    fn visit_macro(&mut self, call: &'ast syn::Macro) {
        if let Ok(file) = syn::parse2::<syn::File>(call.tokens.clone()) {
            self.visit_file(&file);
        }
    }
}

/// A pattern that is the name of a user's constant would be that constant: each name is hidden, or ends in a `_`.
#[test]
fn names_of_variables_are_apart_from_those_around_the_call() {
    let functions: Vec<&str> = Function::ALL.iter().map(|f| f.name()).collect();
    let call = format!(
        "struct Arm {{ l: f64, off: f64 }} convention: standard, gravity: [0, 0, -9.81], joints: [
            a: revolute {{ a: l, alpha: off, mass: 1, com: [1, 2, 3], friction: {{ coulomb: 1 }} }},
            b: prismatic {{ mass: l, alpha: 0.3 }},
        ], functions: [{}, both = (mass_matrix, gravity_vector)], tests: true",
        functions.join(", ")
    );
    let seven = "struct Seven; convention: standard, gravity: [0, 0, 1], joints: [
            a: revolute { alpha: -PI/2 }, b: revolute { alpha: PI/2 }, c: revolute { d: 0.4, alpha: PI/2 },
            d: revolute { alpha: -PI/2 }, e: revolute { d: 0.4, alpha: -PI/2 }, f: revolute { alpha: PI/2 },
            g: revolute {},
        ], functions: [inverse_kinematics]";
    let floating = "struct Stone; base: floating { mass: 1, inertia: sphere(1) }, gravity: [0, 0, 1], joints: []";
    let mut bound = Bound::default();
    for call in [call.as_str(), seven, floating] {
        let items = crate::generate(call.parse().expect("the call lexes"));
        bound.visit_file(&syn::parse2(items).expect("the expansion is Rust"));
    }
    let plain: BTreeSet<String> = bound.0.into_iter().filter(|x| !x.ends_with('_')).collect();
    assert_eq!(plain, NAMES.split(' ').map(str::to_owned).collect());
}
