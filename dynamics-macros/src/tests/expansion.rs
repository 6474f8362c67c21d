//! What a call expands to.

use super::*;
use dynamics_symbolic::derive::derive;

fn expansion(source: &str) -> String {
    crate::generate(source.parse().expect("the source lexes"), &derive).to_string()
}

#[test]
fn the_path_in_front_names_the_runtime() {
    let call = with_cells("mass: 1");
    let named = expansion(&format!("@[::some::runtime] {call}"));
    assert!(named.contains(":: some :: runtime :: Model < 1 > for Arm"));
    assert!(!named.contains("dynamics_runtime"));
    assert!(expansion(&call).contains(":: dynamics_runtime :: Model < 1 > for Arm"));
}

#[test]
fn derives_are_added_where_there_is_none() {
    let call = with_cells("mass: 1");
    assert!(expansion(&call).contains("# [derive (Clone , Copy , Debug , PartialEq)]"));
    let own = expansion(&format!("#[derive(Default)] {call}"));
    assert_eq!(own.matches("# [derive").count(), 1);
    let conditional = expansion(&format!("#[cfg_attr(test, derive(Default))] {call}"));
    assert_eq!(conditional.matches("# [derive").count(), 1);
}

#[test]
fn what_switches_the_struct_off_switches_its_impls_off() {
    let items = expansion(&format!("#[cfg(unix)] {}", with_cells("mass: 1")));
    let impls = items.matches(" impl ").count();
    assert_eq!(items.matches("# [cfg (unix)]").count(), impls + 1);
}

#[test]
fn traits_are_implemented_where_their_functions_exist() {
    let call = with_cells("mass: 1");
    let all = expansion(&call);
    let some = expansion(&format!("{call} functions: [kinetic_energy]"));
    for name in ["Model", "Evaluate", "Energy", "ForwardDynamics"] {
        assert!(all.contains(&format!(":: {name} < 1 >")), "{name}");
    }
    assert!(some.contains(":: Evaluate < 1 >"));
    assert!(!some.contains(":: Energy < 1 >"));
    assert!(!some.contains(":: ForwardDynamics < 1 >"));
}

#[test]
fn the_same_call_expands_to_the_same_tokens() {
    let call = with_cells("a: 1, mass: 1, com: [0.1, 0.2, 0.3], inertia: sphere(0.1)");
    assert_eq!(expansion(&call), expansion(&call));
}

#[test]
fn after_an_error_the_methods_that_were_asked_for_exist() {
    let wrong = with_rows("one: revolute { mass: }, two: revolute { a: 1 }");
    let asked = expansion(&format!("{wrong} functions: [jacobian]"));
    assert!(asked.contains("fn jacobian"));
    assert!(!asked.contains("fn mass_matrix"));
    assert!(asked.contains("DOF : usize = 2"));
    let default = expansion(&wrong);
    assert!(default.contains("fn mass_matrix") && default.contains("fn friction_vector"));
    assert!(!default.contains("fn jacobian"));
    let unknown = expansion(&format!("{wrong} functions: [jacobean]"));
    assert!(unknown.contains("fn jacobian") && unknown.contains("fn mass_matrix"));
}

#[test]
fn without_rows_the_stubs_take_any_number_of_joints() {
    let items = expansion("struct Arm; convention: standard, gravity: [0, 0, 0]");
    assert!(items.contains("const N : usize"));
    assert!(items.contains("DOF : usize = 0"));
}
