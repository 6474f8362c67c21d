//! Rust code for every arm, as symplex writes it.

use std::path::Path;
use std::{env, fs};

use serde_json::Value;
use symplex::prelude::{CodegenOptions, Ex, Matrix};

use crate::equations::Equations;

const ARMS: [&str; 6] = [
    "two_link_saha",
    "elbow_3r",
    "stanford",
    "puma560",
    "ur5",
    "panda",
];

/// Writes `symplex.rs`: a module for each arm, with a function for each term.
pub(crate) fn all() {
    let code: String = ARMS.iter().map(|arm| module(arm)).collect();
    let file = Path::new(&env::var_os("OUT_DIR").unwrap()).join("symplex.rs");
    fs::write(file, code).unwrap();
}

fn module(arm: &str) -> String {
    let manifest = env::var("CARGO_MANIFEST_DIR").unwrap();
    let file = format!("{manifest}/../../tests/data/robots/{arm}.json");
    println!("cargo::rerun-if-changed={file}");
    let robot: Value = serde_json::from_str(&fs::read_to_string(file).unwrap()).unwrap();
    let Equations {
        terms,
        qd,
        qdd,
        names: [q, v, a],
    } = Equations::new(&robot);
    let n = qd.len();

    let sum = |row: &dyn Fn(usize) -> Ex| (1..n).fold(row(0), |sum, j| &sum + &row(j));
    let coriolis: Vec<Ex> = (0..n)
        .map(|i| sum(&|j| terms.coriolis.get(i, j) * &qd[j]))
        .collect();
    let bias: Vec<Ex> = (0..n).map(|i| &coriolis[i] + &terms.gravity[i]).collect();
    let inertial = |i: usize| sum(&|j| terms.mass.get(i, j) * &qdd[j]);
    let inverse: Vec<Ex> = (0..n).map(|i| &inertial(i) + &bias[i]).collect();

    let functions = [
        function("inverse_dynamics", &column(inverse), &[&q, &v, &a]),
        function("mass_matrix", &terms.mass, &[&q]),
        function("coriolis_vector", &column(coriolis), &[&q, &v]),
        function("gravity_vector", &column(terms.gravity.clone()), &[&q]),
        function("bias_force", &column(bias), &[&q, &v]),
    ];
    format!("pub(super) mod {arm} {{\n{}}}\n", functions.concat())
}

fn column(entries: Vec<Ex>) -> Matrix {
    Matrix::new(entries.into_iter().map(|entry| vec![entry]).collect()).unwrap()
}

/// The function as symplex writes it, with an argument for each number, and one that takes arrays.
fn function(name: &str, value: &Matrix, arguments: &[&[String]]) -> String {
    let names: Vec<&str> = arguments
        .concat()
        .iter()
        .map(|n| n.clone().leak() as &str)
        .collect();
    let options = CodegenOptions {
        // Without the instruction it is a call of a library function, many times slower.
        use_mul_add: env::var("CARGO_CFG_TARGET_FEATURE")
            .unwrap()
            .contains("fma"),
        ..CodegenOptions::default()
    };
    let scalar = format!("{name}_of_scalars");
    let code = value
        .to_rust_fn_with_options(&scalar, &names, &options)
        .unwrap();
    let (n, (rows, columns)) = (arguments[0].len(), value.shape());
    let parameters: String = (0..arguments.len())
        .map(|k| format!("x{k}: &[f64; {n}], "))
        .collect();
    let values: String = (0..arguments.len())
        .flat_map(|k| (0..n).map(move |i| format!("x{k}[{i}], ")))
        .collect();
    let size = rows * columns;
    format!("{code}\npub fn {name}({parameters}) -> [f64; {size}] {{ {scalar}({values}) }}\n")
}
