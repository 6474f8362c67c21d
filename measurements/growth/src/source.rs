//! The Rust text that is compiled: a library with the methods of a chain, and a program that
//! times them.

use dynamics_symbolic::{Function, Method};

use crate::chain::LISTED;

/// A library with the methods of a chain, and a function for each that is not generic, so that
/// its code is generated here.
pub(crate) fn library(joints: usize, functions: &[Function], methods: &[Method]) -> String {
    let mut text = format!(
        "use dynamics_runtime::{{SingularMassMatrix, nalgebra::{{SMatrix, SVector}}}};\n\
         type Vector = SVector<f64, {joints}>;\n\
         pub struct Chain;\n\
         impl Chain {{\n"
    );
    for method in methods {
        text += &in_lines(&method.tokens);
    }
    text += "}\n";
    for (index, method) in methods.iter().enumerate() {
        if let Some(items) = &method.function {
            let path = quote::quote!(dynamics_runtime);
            let name = dynamics_symbolic::function_type(&method.request, index, &path);
            let items = in_lines(items);
            text += &format!(
                "impl dynamics_runtime::Function<{name}, {joints}> for Chain {{\n{items}}}\n"
            );
        }
        let name = method.request.function().and_then(Function::trait_name);
        if let (Some(name), Some(items)) = (name, &method.provided) {
            let items = in_lines(items);
            text += &format!("impl dynamics_runtime::{name}<{joints}> for Chain {{\n{items}}}\n");
        }
    }
    for &function in functions {
        let (arguments, value) = signature(function, joints);
        let list: Vec<_> = arguments.iter().map(|x| format!("{x}: &Vector")).collect();
        let (name, list, arguments) = (function.name(), list.join(", "), arguments.join(", "));
        text += &format!(
            "#[inline(never)]\npub fn {name}({list}) -> {value} {{ Chain.{name}({arguments}) }}\n"
        );
    }
    text
}

/// The text of tokens. rustc is slow to find a place in a very long line.
fn in_lines(tokens: &impl ToString) -> String {
    tokens.to_string().replace("; ", ";\n") + "\n"
}

/// The arguments of a method, and the type of its value.
fn signature(function: Function, joints: usize) -> (&'static [&'static str], String) {
    let vector = || "Vector".to_owned();
    match function {
        Function::MassMatrix => (&["q"], format!("SMatrix<f64, {joints}, {joints}>")),
        Function::GravityVector => (&["q"], vector()),
        Function::PotentialEnergy => (&["q"], "f64".to_owned()),
        Function::KineticEnergy => (&["q", "qd"], "f64".to_owned()),
        Function::InverseDynamics => (&["q", "qd", "qdd"], vector()),
        Function::ForwardDynamics => {
            let result = "Result<Vector, SingularMassMatrix>";
            (&["q", "qd", "tau"], result.to_owned())
        }
        _ => (&["q", "qd"], vector()),
    }
}

/// A program that compares the functions with one another, and prints the time of a call of each
/// listed one, ns.
pub(crate) fn program(joints: usize) -> String {
    let mut calls = String::new();
    for (function, _) in LISTED {
        let (arguments, _) = signature(function, joints);
        let arguments: Vec<_> = (0..arguments.len())
            .map(|k| format!("&state[{k}]"))
            .collect();
        let (name, arguments) = (function.name(), arguments.join(", "));
        calls += &format!(
            "    println!(\"{{}}\", Effort::FULL.nanoseconds(&states, |state| chain::{name}({arguments})));\n"
        );
    }
    format!(
        "const JOINTS: usize = {joints};\n{TIMING}fn main() {{\n    let states = states();\n    states.iter().for_each(compare);\n{calls}}}\n"
    )
}

const TIMING: &str = r#"
use dynamics_runtime::nalgebra::SVector;
use measuring::Effort;

type State = [SVector<f64, JOINTS>; 3];

/// Positions, velocities, and accelerations or forces, in [-2, 2).
fn states() -> Vec<State> {
    let mut seed = 1_u64;
    let mut number = || {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (seed >> 11) as f64 / (1_u64 << 51) as f64 - 2.0
    };
    (0..64).map(|_| [(); 3].map(|()| SVector::from_fn(|_, _| number()))).collect()
}

/// tau = M qdd + V + G, and the accelerations of tau need tau: two programs of their own each.
fn compare([q, qd, qdd]: &State) {
    let tau = chain::inverse_dynamics(q, qd, qdd);
    let sum = chain::mass_matrix(q) * qdd + chain::coriolis_vector(q, qd) + chain::gravity_vector(q);
    assert!((tau - sum).norm() <= 1e-12 * tau.norm());
    let accelerations = chain::forward_dynamics(q, qd, &tau).expect("a regular mass matrix");
    let needed = chain::inverse_dynamics(q, qd, &accelerations);
    assert!((tau - needed).norm() <= 1e-9 * tau.norm());
}

"#;
