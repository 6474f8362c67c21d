//! Every function of every robot is proven.

mod support;

use dynamics_symbolic::derive::chain::{Chain, Origin};
use dynamics_symbolic::derive::functions::outputs;
use dynamics_symbolic::derive::symbols::Symbols;
use dynamics_symbolic::expr::Graph;
use dynamics_symbolic::program::Program;
use dynamics_symbolic::{Function, prove};

#[test]
fn all_functions_of_all_robots() {
    for name in support::NAMES {
        let robot = support::robot(name);
        for function in Function::ALL {
            let graph = Graph::new();
            let mut symbols = Symbols::new(&graph, &robot);
            let mut chain = Chain::new(
                &mut symbols,
                &robot,
                &vec![Origin::AfterOffset; robot.rows.len()],
            );
            chain.group_parameters();
            let outputs: Vec<_> = outputs(&mut symbols, &robot, &chain, function)
                .iter()
                .map(|e| e.edge())
                .collect();
            let program = Program::new(&graph, symbols.meanings(), &outputs, &|id| {
                graph.operation(id)
            });
            let result = prove::prove(&robot, function, &program);
            println!(
                "{name} {} {:?} {result:?}",
                function.name(),
                program.operations()
            );
        }
    }
}
