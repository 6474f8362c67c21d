//! The work of the fuzz targets on their input. They panic where something is wrong.

mod robot;

use dynamics_evaluation::RuntimeRobot;
use dynamics_numeric::check::Check;
use dynamics_symbolic::Function;
use dynamics_symbolic::derive::center_of_mass::is_massless;
use dynamics_symbolic::derive::derive;
use dynamics_symbolic::prove::prove;
use dynamics_symbolic::robot::Robot;
use proc_macro2::TokenStream;

/// Reads a call of the macro to its end. There is a model or there are errors; the items, the stubs
/// after an error too, are Rust.
pub fn parser(text: &str) {
    let Ok(tokens) = text.parse::<TokenStream>() else {
        return;
    };
    let items = dynamics_codegen::outline(tokens);
    // Attributes, visibilities and the path of the runtime are handed on as they were written.
    if !text.contains(['#', '@']) && !text.contains("pub") {
        let file = syn::parse2::<syn::File>(items.clone());
        assert!(file.is_ok(), "{:?}: {items}", file.err());
    }
}

/// Derives three functions of a random table, proves it, and compares its values in double precision
/// with those of the numeric Newton-Euler algorithm.
pub fn tables(bytes: &[u8]) {
    // Deriving takes most of the time: a few functions at once.
    let Some((choice, bytes)) = bytes.split_first() else {
        return;
    };
    let Ok((robot, fields)) = robot::robot(bytes) else {
        return;
    };
    let number = usize::from(*choice) % Function::ALL.len();
    let chosen = (0..3).map(|k| Function::ALL[(number + 7 * k) % Function::ALL.len()]);
    let chosen = chosen.filter(|function| !(function.divides_by_mass() && is_massless(&robot)));
    // Taylor series are no program over numbers: what they are written from is proven alone.
    let (series, chosen): (Vec<_>, Vec<_>) =
        chosen.partition(|function| *function == Function::TaylorSeries);
    for function in series {
        let program = derive(&robot, function);
        assert_eq!(prove(&robot, function, &program), Ok(()), "{robot:#?}");
    }
    compare(&robot, &fields, chosen);
}

/// Derives and proves what depends on the base parameters of a random arm whose joints follow others, and compares its
/// values as [`tables`] does.
pub fn couplings(bytes: &[u8]) {
    let Ok((robot, fields)) = robot::coupled_robot(bytes) else {
        return;
    };
    let functions = [
        Function::Regressor,
        Function::BaseParameters,
        Function::EnergyRegressors,
    ];
    compare(&robot, &fields, functions);
}

fn compare(robot: &Robot, fields: &[f64], functions: impl IntoIterator<Item = Function>) {
    let arm = RuntimeRobot::new(robot.clone(), functions);
    let mut arm = arm.unwrap_or_else(|error| panic!("{error}: {robot:#?}"));
    arm.set_fields(fields).expect("a value for each field");
    let report = Check::new().samples(4).run_any(&arm);
    assert!(report.is_ok(), "{report}\n{fields:?}\n{:#?}", arm.robot());
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    /// Reads all inputs of a target's corpus; how many there are.
    fn run(name: &str, target: fn(&[u8])) -> usize {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("corpus")
            .join(name);
        let entries = std::fs::read_dir(folder).expect("the folder can be read");
        let inputs = entries.map(|entry| entry.expect("an entry of the folder").path());
        inputs
            .map(|path| target(&std::fs::read(path).expect("an input can be read")))
            .count()
    }

    /// Among them are tables of which earlier versions of the target made bodies that cannot be.
    #[test]
    fn the_tables_of_the_corpus_pass() {
        let count = run("tables", crate::tables);
        assert!(count >= 15, "{count} tables");
    }

    #[test]
    fn the_couplings_of_the_corpus_pass() {
        let count = run("couplings", crate::couplings);
        assert!(count >= 8, "{count} arms");
    }
}
