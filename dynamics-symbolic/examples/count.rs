//! Prints operation counts.
#[path = "../tests/support/mod.rs"]
mod support;
use dynamics_symbolic::derive::chain::{Chain, Origin};
use dynamics_symbolic::derive::symbols::Symbols;
use dynamics_symbolic::derive::{composite, recursive};
use dynamics_symbolic::expr::{Expr, Graph, Level, Operation};
use dynamics_symbolic::linear::Vector3;

fn count(graph: &Graph, outputs: &[Expr]) -> (usize, usize) {
    let mut seen = vec![false; graph.len()];
    let mut stack: Vec<_> = outputs.iter().map(|e| e.edge().node()).collect();
    let (mut m, mut a) = (0, 0);
    while let Some(id) = stack.pop() {
        if std::mem::replace(&mut seen[id.index()], true) || graph.level_of(id) == Level::Constant {
            continue;
        }
        let op = graph.operation(id);
        match op {
            Operation::Add(..) => a += 1,
            Operation::Mul(..) | Operation::Div(..) => m += 1,
            _ => {}
        }
        stack.extend(op.operands());
    }
    (m, a)
}

fn main() {
    for name in [
        "two_link_saha",
        "elbow_3r",
        "stanford",
        "puma560",
        "ur5",
        "panda",
        "generic_chain_n7",
        "generic_chain_n12",
    ] {
        let robot = support::robot(name);
        let n = robot.rows.len();
        let start = std::time::Instant::now();
        let mut best = [(usize::MAX, (0, 0), 0); 4];
        for code in 0..1usize << n.min(6) {
            let origins: Vec<_> = (0..n)
                .map(|i| {
                    if code >> i & 1 == 0 {
                        Origin::AfterOffset
                    } else {
                        Origin::BeforeOffset
                    }
                })
                .collect();
            let graph = Graph::new();
            let mut symbols = Symbols::new(&graph, &robot);
            let mut chain = Chain::new(&mut symbols, &robot, &origins);
            chain.group_parameters();
            let (qd, qdd) = (symbols.all(|j| j.qd), symbols.all(|j| j.qdd));
            let zeros = vec![graph.zero(); n];
            let none = Vector3::splat(graph.zero());
            let tau = recursive::inverse_dynamics(&chain, &qd, &qdd, chain.gravity);
            let v = recursive::inverse_dynamics(&chain, &qd, &zeros, none);
            let g = recursive::inverse_dynamics(&chain, &zeros, &zeros, chain.gravity);
            let m: Vec<_> = composite::mass_matrix(&chain).concat();
            for (k, f) in [tau, v, m, g].iter().enumerate() {
                let c = count(&graph, f);
                if c.0 + c.1 < best[k].0 {
                    best[k] = (c.0 + c.1, c, code);
                }
            }
        }
        println!(
            "{name:20} tau {:?} V {:?} M {:?} G {:?} {:?}",
            best[0],
            best[1],
            best[2],
            best[3],
            start.elapsed()
        );
    }
}
