//! The items that a call expands to.

use super::*;
use dynamics_symbolic::derive::derive_together as derive_program;
use proc_macro2::{Delimiter, Group, TokenTree};

fn expansion(source: &str) -> String {
    crate::generate_by(source.parse().expect("the source lexes"), &derive_program).to_string()
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
    assert_eq!(conditional.matches("# [derive").count(), 0);
    let always = expansion(&format!("#[cfg_attr(true, derive(Default))] {call}"));
    assert_eq!(always.matches("# [derive").count(), 0);
    let other = expansion(&format!("#[cfg_attr(test, must_use)] {call}"));
    assert_eq!(other.matches("# [derive").count(), 1);
}

#[test]
fn what_is_no_attribute_is_handed_on_to_the_compiler() {
    let items = expansion(&format!(
        "#[5] #[] #[doc = include_str!(\"a\")] {}",
        with_cells("mass: 1")
    ));
    assert!(items.contains("# [5] # [] # [doc = include_str ! (\"a\")]"));
}

/// The tokens that a macro's `$(#[$attribute:meta])*` makes of an attribute.
fn handed_on(attribute: &str) -> TokenStream {
    let content: TokenStream = attribute.parse().expect("the attribute lexes");
    let fragment = TokenTree::from(Group::new(Delimiter::None, content));
    quote::quote!(#[#fragment])
}

/// How many impl blocks there are; an argument's type may be an `impl` too.
fn blocks(items: &str) -> usize {
    items.matches(" impl ").count() - items.matches(": & impl ").count()
}

#[test]
fn attributes_that_another_macro_hands_on_are_read() {
    let [derive, cfg, doc] = ["derive(Debug)", "cfg(unix)", "doc = \"x\""].map(handed_on);
    let call = quote::quote! {
        #derive #cfg #doc struct Arm { #doc m: f64 }
        #doc convention: standard, gravity: [0, 0, 0],
        joints: [#doc joint: revolute { #doc mass: m }]
    };
    let items = crate::generate_by(call, &derive_program).to_string();
    assert!(!items.contains("compile_error"), "{items}");
    assert!(!items.contains("PartialEq"));
    let impls = blocks(&items);
    assert_eq!(items.matches("# [cfg (unix)]").count(), impls + 1);
    let switched = quote::quote!(struct Arm { #cfg m: f64 } convention: standard,
        gravity: [0, 0, 0], joints: [joint: revolute { mass: m }]);
    let (_, messages) = read(switched);
    assert_eq!(
        messages,
        ["a field that the table refers to cannot be switched off by `cfg`"]
    );
}

#[test]
fn a_condition_around_the_switch_goes_with_it() {
    let attribute = "#[cfg_attr(unix, derive(Debug), cfg(test), cfg_attr(windows, cfg(doc)))]";
    let items = expansion(&format!("{attribute} {}", with_cells("mass: 1")));
    let impls = blocks(&items);
    for copied in [
        "# [cfg_attr (unix , cfg (test))]",
        "# [cfg_attr (unix , cfg_attr (windows , cfg (doc)))]",
    ] {
        assert_eq!(items.matches(copied).count(), impls, "{copied}");
    }
}

#[test]
fn names_of_tests_keep_the_case_of_the_struct() {
    let items = expansion(&format!("{} tests: true", with_cells("mass: 1")));
    assert!(items.contains("fn Arm_agrees_with_recursive_newton_euler ()"));
    assert!(items.contains("mod Arm_model"));
}

#[test]
fn what_switches_the_struct_off_switches_its_impls_off() {
    let items = expansion(&format!("#[cfg(unix)] {}", with_cells("mass: 1")));
    let impls = blocks(&items);
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
fn base_parameters_are_counted_where_a_function_is_about_them() {
    let call = with_cells("mass: 1, com: [1, 0, 0]");
    assert!(!expansion(&call).contains("BASE_PARAMETERS"));
    for function in ["regressor", "base_parameters"] {
        let items = expansion(&format!("{call} functions: [{function}]"));
        // J_zz alone: gravity is along the axis.
        assert!(items.contains("BASE_PARAMETERS : usize = 1"), "{items}");
        assert!(items.contains("BASE_PARAMETER_NAMES : [& 'static str ; 1] = [\"J1zz\"]"));
    }
    let wrong = with_cells("mass: ");
    let items = expansion(&format!("{wrong} functions: [regressor]"));
    assert!(items.contains("BASE_PARAMETERS : usize = 0"), "{items}");
    // A motor cell is a parameter, even where it says zero.
    let rail = "struct Arm; convention: standard, gravity: [0, 0, -9.81], joints: [
        rail: prismatic { motor: { inertia: 0, gear_ratio: 1 } }], functions: [regressor], allow: [no_inertia]";
    assert!(expansion(rail).contains("BASE_PARAMETERS : usize = 2"));
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
    // A batch of arms reads their fields.
    assert!(default.contains("Fields for Arm"));
    let unknown = expansion(&format!("{wrong} functions: [jacobean]"));
    assert!(unknown.contains("fn jacobian") && unknown.contains("fn mass_matrix"));
}

#[test]
fn without_rows_the_stubs_take_any_number_of_joints() {
    let items = expansion("struct Arm; convention: standard, gravity: [0, 0, 0]");
    assert!(items.contains("const N : usize"));
    assert!(items.contains("DOF : usize = 0"));
}

#[test]
fn rows_that_cannot_be_counted_leave_the_number_unknown() {
    for (rows, joints) in [
        ("[one: revolute {}, two: revolute {}]", 0),
        ("joint one revolute: {}, two: revolute {}", 0),
        ("joint one: revolute {}, joint two: revolute {}", 2),
        ("one: revolute {} two = revolute {}", 0),
        ("\"one\": revolute {}, two: revolute {}", 0),
        ("one: revolute {} two: revolute {}", 2),
        ("one { mass: 1 }, revolute { mass: 1 }", 2),
        ("one: revolute, two: {}", 2),
        ("revolute(one, a: 1), prismatic(two)", 2),
        ("_: revolute {}", 1),
    ] {
        let items = expansion(&with_rows(rows));
        assert!(items.contains("compile_error"), "{rows}");
        assert!(items.contains(&format!("DOF : usize = {joints}")), "{rows}");
    }
}

/// Two links, of which the second one hardly matters.
const SCENE: &str = "
    struct Arm;
    convention: standard, gravity: [0, -9.81, 0],
    joints: [
        one: revolute { a: 1, mass: 10, com: [-0.5, 0, 0], inertia: rod(1) },
        two: revolute { a: 0.2, mass: 0.1, com: [-0.1, 0.001, 0], motor: { inertia: 0.1, gear_ratio: 3 } },
        three: revolute { mass: 0.1 },
    ],";

#[test]
fn the_documentation_says_what_is_left_out() {
    let items = expansion(&format!("{SCENE} lock: [three = deg(30)], neglect: 0.5%"));
    for part in [
        "Joints that are locked, and are none of this arm's:",
        " - `three` at 0.5235987755982988",
        "Abbreviated: of the Lagrangian, the base inertial parameters that make less than 0.5 %",
        "are neglected, and all functions are derived from what is left: `h2y`.",
        "The model is abbreviated: what stays below 0.5 % is neglected. The largest error at 200",
        ":: dynamics_runtime :: Table :: lock (",
        "pub const DOF : usize = 2 ;",
    ] {
        assert!(items.contains(part), "{part} is not in\n{items}");
    }
    let nothing = expansion(&format!("{SCENE} neglect: 0.000001%"));
    assert!(
        nothing.contains("Nothing is neglected: every base inertial parameter makes 0.000001 %")
    );
}

#[test]
fn a_share_is_a_number_with_a_percent_sign_or_without() {
    let of = |share: &str| expansion(&format!("{SCENE} neglect: {share}"));
    assert_eq!(of("0.5%"), of("0.005"));
    assert_eq!(of("0.5%"), of("1% / 2".replace("% / 2", " / 2%").as_str()));
}

#[test]
fn what_is_locked_may_stand_above_the_joints_and_use_names() {
    let call = "struct Arm { bend: f64 } let half = bend / 2; lock: [two = half],
        convention: standard, gravity: [0, -9.81, 0],
        joints: [one: revolute { mass: 1, com: [1, 0, 0] }, two: revolute { mass: 1, com: [1, 0, 0] }]";
    let items = expansion(call);
    assert!(!items.contains("compile_error"), "{items}");
    assert!(items.contains("- `two` at a position made of fields"));
    assert!(items.contains("JOINT_NAMES : [& 'static str ; 1] = [\"one\"]"));
}

/// After an error the methods have the number of joints that the user's code counts on.
#[test]
fn stubs_of_locked_arms_have_fewer_joints() {
    let items = expansion(&format!("{SCENE} lock: [two = ?], neglect: 400%"));
    assert!(items.contains("compile_error") && items.contains("pub const DOF : usize = 2 ;"));
    let unknown = expansion(&format!("{SCENE} lock: [four = 1]"));
    assert!(unknown.contains("compile_error") && unknown.contains("const N : usize"));
}

#[test]
fn the_documentation_says_where_base_and_tool_are() {
    let call = "struct Cell { load: f64, tilt: f64 } convention: modified, gravity: [0, 0, -9.81], \
                base: { xyz: [0, 0, 0.8], rpy: [0, tilt, 0] }, joints: [joint: revolute { mass: 1 }], \
                tool: { xyz: [0.5, 0, tilt + 1], mass: load }, functions: [forward_kinematics, jacobian]";
    let items = expansion(call);
    for text in [
        "The base frame is placed in the world at xyz (0, 0, 0.8) m and rpy (0, `tilt`, 0) rad",
        "The tool frame is placed in the last link frame at xyz (0.5, 0, a value made of fields) m",
        "with a body of `load` kg",
        "the homogeneous transform of the tool frame in the world, m.",
        "Geometric Jacobian of the tool frame's origin, 6 x N, rows vx vy vz wx wy wz, in the world.",
    ] {
        assert!(items.contains(text), "{text}");
    }
}
