//! Tries formulas.
use dynamics_symbolic::{Function, derive::derive, formula::*};
fn main() {
    for name in std::env::args().skip(1) {
        let mut robot = arms::robot(&name);
        if name == "two_link_craig" {
            use dynamics_symbolic::robot::Value;
            robot.fields = ["m1", "m2", "l1", "l2", "g"].map(str::to_owned).to_vec();
            for (row, (mass, length)) in robot.rows.iter_mut().zip([(0, 2), (1, 3)]) {
                row.mass = Value::field(mass);
                row.a = Value::field(length);
            }
            robot.gravity[1] = -Value::field(4);
        }
        for f in Function::ALL {
            if f.row().symbol.is_none() { continue; }
            let p = derive(&robot, f);
            let t = std::time::Instant::now();
            let fs = Formulas::new(&robot, &[f], &p, Budget { terms: 300, products: 5000 });
            for format in [Format::Text, Format::Latex] {
            for s in fs.shown(format, 24) { println!("{} = {}", s.name, s.formula.unwrap_or_else(|e| e.to_string())); }
            }
            println!("   {:?} {:?}", fs.legend(24), t.elapsed());
            if let Some(s) = Structure::of(&robot, f, &p, 0..p.outputs.len()) { println!("   {}", s.sentence()); }
        }
    }
}
