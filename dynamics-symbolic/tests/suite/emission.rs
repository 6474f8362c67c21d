//! The text of generated code: readable, and the same each time.

use dynamics_symbolic::robot::{Robot, Value};
use dynamics_symbolic::{Function, Request, expand};
use expect_test::expect_file;
use quote::quote;

/// The generated methods as formatted Rust.
pub(crate) fn text<R: Clone + Into<Request>>(robot: &Robot, requests: &[R]) -> String {
    let path = quote!(::robot_dynamics);
    let methods = expand(robot, requests, &path).expect("proven");
    let n = robot.rows.len();
    let n = proc_macro2::Literal::usize_unsuffixed(n);
    let traits = methods.iter().enumerate().map(|(index, method)| {
        if let Some(items) = &method.function {
            let function = dynamics_symbolic::function_type(&method.request, index, &path);
            return quote!(impl #path::Function<#function, #n> for Arm { #items });
        }
        let function = method.request.function().expect("one function");
        let name = quote::format_ident!("{}", function.trait_name().expect("a trait"));
        let item = method.provided.as_ref().expect("the trait's item");
        quote!(impl #path::#name<#n> for Arm { #item })
    });
    let methods = methods.iter().map(|method| &method.tokens);
    let file = syn::parse2(quote!(impl Arm { #(#methods)* } #(#traits)*)).expect("Rust");
    prettyplease::unparse(&file)
}

#[test]
fn two_link_arm_with_numbers() {
    let text = text(&arms::robot("two_link_saha"), &Function::ALL);
    expect_file!["../golden/two_link_saha.rs"].assert_eq(&text);
}

#[test]
fn two_link_arm_with_parameters() {
    let text = text(&arms::two_link_craig(), &Function::default_set(false));
    expect_file!["../golden/two_link_craig.rs"].assert_eq(&text);
}

#[test]
fn gantry_has_no_sines() {
    let text = text(&arms::robot("gantry_ppp"), &Function::default_set(true));
    assert!(!text.contains("sin_cos("));
    expect_file!["../golden/gantry_ppp.rs"].assert_eq(&text);
}

/// A massless link at the tip: its documentation says that forward dynamics has no solution.
#[test]
fn documentation_says_that_nothing_resists_a_joint() {
    let mut robot = arms::robot("two_link_craig");
    robot.rows[1].mass = Value::zero();
    robot.rows[1].name = "hand".to_owned();
    let solving = [
        Function::ForwardDynamics,
        Function::ForwardDynamicsAba,
        Function::ForwardDynamicsDerivatives,
    ];
    for function in solving {
        let of_arm = |robot: &Robot| text(robot, &[function]).contains("nothing resists `hand`");
        assert!(of_arm(&robot), "{function:?}");
        assert!(!of_arm(&arms::robot("two_link_craig")), "{function:?}");
    }
}

/// Where there are formulas of a longer arm, of functions whose values have names.
#[test]
fn documentation_of_a_longer_arm_says_where_its_formulas_are() {
    let says = |arm: &str, function| {
        text(&arms::robot(arm), &[function]).contains("`robot-dynamics show`, with `--format text`")
    };
    assert!(says("scara", Function::GravityVector));
    assert!(!says("scara", Function::ForwardDynamics));
    assert!(!says("elbow_3r", Function::GravityVector));
}

fn assert_deterministic(names: &[&str]) {
    for name in names {
        let robot = arms::robot(name);
        let [one, other] = [(); 2].map(|()| text(&robot, &Function::ALL));
        assert_eq!(one, other, "{name}");
    }
}

#[test]
fn expansion_is_deterministic() {
    assert_deterministic(&["elbow_3r", "cylindrical_rpp"]);
}

#[test]
#[ignore = "takes seconds: .ci/run runs it"]
fn expansion_of_longer_arms_is_deterministic() {
    assert_deterministic(&["generic_chain_n3", "scara", "puma560"]);
}

/// rustc crashes on about 2,900 `let`s in one function with debug information (rust-lang/rust#93908).
#[test]
fn long_programs_declare_their_names_in_groups() {
    let long = text(&arms::robot("generic_chain_n12"), &[Function::MassMatrix]);
    assert!(
        long.matches("let ").count() < 100,
        "{}",
        long.matches("let ").count()
    );
    assert!(long.matches(';').count() > 1_000);
}

/// Cells that are numbers, and a constant of the program that is none.
#[test]
fn an_overflow_is_an_error_that_names_the_function() {
    let mut robot = arms::robot("one_link");
    robot.rows[0].mass = arms::decimal(1e300);
    robot.rows[0].com[0] = arms::decimal(1e10);
    let functions = [Function::MassMatrix, Function::GravityVector];
    let failures = expand(&robot, &functions, &quote!(path))
        .err()
        .expect("a failure");
    assert_eq!(failures.len(), 2);
    assert!(
        failures[0]
            .to_string()
            .contains("a constant in `mass_matrix` is too large")
    );
}

/// A parameter may be zero: programs divide by what the user divides by, forward dynamics by its
/// pivots, and centres of mass by the mass of the arm.
#[test]
fn no_division_by_a_parameter_is_invented() {
    let mut elbow = arms::robot("elbow_3r");
    elbow.fields = ["gx", "gy", "gz", "m", "x"].map(str::to_owned).to_vec();
    elbow.gravity = [0, 1, 2].map(Value::field);
    elbow.rows[2].mass = Value::field(3);
    elbow.rows[2].com[0] = Value::field(4);
    for robot in [elbow, arms::two_link_craig()] {
        for method in expand(&robot, &Function::ALL, &quote!(path)).expect("proven") {
            let divides = |function: Function| function.has_pivots() || function.divides_by_mass();
            assert!(
                method.request.function().is_some_and(divides) || method.operations.divisions == 0,
                "{}",
                method.request.name()
            );
        }
    }
}

#[test]
fn nothing_is_read_that_is_not_used() {
    // The first angle of an arm with a vertical first axis does not matter.
    let text = text(
        &arms::robot("puma560"),
        &[Function::MassMatrix, Function::GravityVector],
    );
    assert!(!text.contains("s_1") && !text.contains("c_1 "));
}
