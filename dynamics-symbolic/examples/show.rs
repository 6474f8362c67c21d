//! Prints the generated text of one function of one robot:
//! `cargo run -p dynamics-symbolic --example show -- two_link_saha mass_matrix`

use dynamics_symbolic::{Function, expand};

fn main() {
    let mut arguments = std::env::args().skip(1);
    let robot = arms::robot(&arguments.next().expect("a robot"));
    let name = arguments.next().expect("a function");
    let function = Function::from_name(&name).expect("the name of a function");
    let methods = expand(&robot, &[function], &quote::quote!(robot_dynamics));
    let method = &methods.unwrap_or_else(|failures| panic!("{}", failures[0]))[0];
    // The program stands in the implementation of a trait of the runtime.
    let of_trait = method.provided.as_ref().or(method.function.as_ref());
    let program = of_trait.unwrap_or(&method.tokens);
    let file = syn::parse2(quote::quote!(impl Robot { #program })).expect("Rust");
    print!("{}", prettyplease::unparse(&file));
}
