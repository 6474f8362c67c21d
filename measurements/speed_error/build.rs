//! Writes the textbook's own programs, as they come from the Lagrangian by differentiation: they are measured beside
//! the short ones. Each is proven as every program is, or the build ends.

use dynamics_symbolic::derive::symbols::Symbols;
use dynamics_symbolic::derive::textbook::Textbook;
use dynamics_symbolic::expr::Graph;
use dynamics_symbolic::function::Part;
use dynamics_symbolic::mechanism::Mechanism;
use dynamics_symbolic::program::Program;
use dynamics_symbolic::robot::Robot;
use dynamics_symbolic::{Function, expand_with};
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

/// Data files and names of up to three joints: beyond, the textbook's programs are longer by an order of magnitude.
const ARMS: [(&str, &str); 5] = [
    ("two_link_saha", "TwoLinkSaha"),
    ("two_link_craig", "TwoLinkCraig"),
    ("elbow_3r", "Elbow3r"),
    ("rrr_planar", "RrrPlanar"),
    ("spherical_wrist", "SphericalWrist"),
];

const FUNCTIONS: [Function; 3] = [
    Function::MassMatrix,
    Function::CoriolisVector,
    Function::GravityVector,
];

/// The graph's program of the formulas: equal expressions are one, and nothing else is done.
fn textbook(robot: &Robot, parts: &[Part]) -> Program {
    let graph = Graph::new();
    let arm = Mechanism::from(robot);
    let mut symbols = Symbols::new(&graph, &arm);
    let textbook = Textbook::new(&mut symbols);
    let outputs = match parts[0].function {
        Function::MassMatrix => textbook.mass_matrix.concat(),
        Function::CoriolisVector => textbook.coriolis_vector,
        Function::GravityVector => textbook.gravity_vector,
        other => unreachable!("{other:?} is not among them"),
    };
    let outputs: Vec<_> = outputs.iter().map(|output| output.edge()).collect();
    Program::new(&graph, symbols.meanings(), &outputs, &|id| {
        graph.operation(id)
    })
}

/// An arm with the three methods and the traits that they provide.
fn arm(file: &str, name: &str) -> TokenStream {
    let path = quote!(::robot_dynamics);
    let robot = arms::robot(file);
    let methods = expand_with(&robot, &FUNCTIONS, &path, &textbook).expect("proven");
    let (name, n) = (
        format_ident!("{name}"),
        Literal::usize_unsuffixed(robot.rows.len()),
    );
    let traits = methods.iter().zip(FUNCTIONS).map(|(method, function)| {
        let provided = format_ident!("{}", function.trait_name().expect("a trait"));
        let item = method.provided.as_ref().expect("the trait's item");
        quote!(impl #path::#provided<#n> for #name { #item })
    });
    let calls = methods.iter().map(|method| &method.tokens);
    quote! {
        pub struct #name;
        impl #name { #(#calls)* }
        #(#traits)*
    }
}

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=../../tests/data/robots");
    let arms = ARMS.map(|(file, name)| arm(file, name));
    // The compiler is slow to find a place in a very long line.
    let text = quote!(#(#arms)*).to_string().replace("; ", ";\n");
    let folder = std::env::var_os("OUT_DIR").expect("a build script has it");
    let file = std::path::Path::new(&folder).join("textbook_programs.rs");
    std::fs::write(file, text).expect("the folder can be written");
}
