//! Nanoseconds a state of some functions of an arm of the data files, one by one and in batches on one core:
//! `cargo run --release -p dynamics-evaluation --example time -- panda`.

use dynamics_evaluation::RuntimeRobot;
use dynamics_symbolic::Function;
use fearless_simd::Level;
use measuring::Effort;
use measuring::table::{Table, nanoseconds};

/// States of one batch.
const STATES: usize = 1024;

const FUNCTIONS: [Function; 5] = [
    Function::MassMatrix,
    Function::CoriolisVector,
    Function::GravityVector,
    Function::InverseDynamics,
    Function::ForwardDynamics,
];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let name = std::env::args().nth(1).unwrap_or("panda".to_owned());
    let arm = RuntimeRobot::new(arms::robot(&name), FUNCTIONS)?;
    let mut random = random_numbers();
    let vector: Vec<Vec<f64>> = (0..3)
        .map(|_| (0..STATES * arm.dof()).map(|_| random()).collect())
        .collect();
    let level = Level::new();
    let title = format!("{name}, {STATES} states, ns a state");
    let columns = ["function", "operations", "slots", "one", "AVX2", "here"];
    let mut table = Table::new(title, &columns);
    for function in FUNCTIONS {
        let name = function.name();
        let arguments: Vec<&[f64]> = vector[..function.arguments().len()]
            .iter()
            .map(Vec::as_slice)
            .collect();
        let states: Vec<Vec<&[f64]>> = (0..STATES)
            .map(|k| state(&arguments, k, arm.dof()))
            .collect();
        let one = |state: &Vec<&[f64]>| arm.evaluate(name, state).expect("regular");
        let one = nanoseconds(Effort::FULL.nanoseconds(&states, one));
        let mut results = vec![0.0; STATES * arm.entries(name)?];
        let mut time = |level: Level| {
            let batch = |_: &()| {
                arm.batch_at(level, name, &arguments, &mut results)
                    .expect("regular")
            };
            nanoseconds(Effort::FULL.nanoseconds(&[()], batch) / STATES as f64)
        };
        let here = time(level);
        let avx2 = level.as_avx2();
        let avx2 = avx2.map_or("-".to_owned(), |avx2| time(Level::Avx2(avx2)));
        let [operations, slots] = [arm.operations(name)?.total() as usize, arm.slots(name)?];
        let counts = [operations.to_string(), slots.to_string()];
        table.row(
            [name.to_owned()]
                .into_iter()
                .chain(counts)
                .chain([one, avx2, here]),
        );
    }
    println!("{}", table.text());
    Ok(())
}

/// The arguments of a state.
fn state<'a>(arguments: &[&'a [f64]], state: usize, dof: usize) -> Vec<&'a [f64]> {
    let entries = state * dof..(state + 1) * dof;
    arguments.iter().map(|all| &all[entries.clone()]).collect()
}

/// Numbers between -2 and 2, the same each time.
fn random_numbers() -> impl FnMut() -> f64 {
    let mut state = 1_u64;
    move || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 51) as f64 - 2.0
    }
}
