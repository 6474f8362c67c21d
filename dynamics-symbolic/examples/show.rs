//! Prints the generated text of one function of one robot.
#[path = "../tests/support/mod.rs"]
mod support;

fn main() {
    let mut arguments = std::env::args().skip(1);
    let robot = support::robot(&arguments.next().expect("a robot"));
    let function = dynamics_symbolic::Function::from_name(&arguments.next().expect("a function"))
        .expect("a function");
    let program = dynamics_symbolic::derive::derive(&robot, function);
    let path = quote::quote!(robot_dynamics);
    let text = dynamics_symbolic::emit::method(
        &robot,
        function,
        &program,
        &program.rounded_constants(),
        &path,
    )
    .to_string();
    println!("{}", text.replace(" ;", ";\n").replace("] ", "]\n"));
}
