//! Nanoseconds a state of some functions of an arm of the data files, in batches on one core:
//! `cargo run --release -p dynamics-evaluation --example time -- panda`.

use dynamics_evaluation::RuntimeRobot;
use dynamics_symbolic::Function;
use fearless_simd::Level;

/// States of one batch.
const STATES: usize = 1024;

/// Batches that are timed; the fastest counts.
const BATCHES: usize = 1000;

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
    println!("{name}, {STATES} states, the fastest of {BATCHES} batches, ns a state and function");
    println!(
        "{:<20}{:>6}{:>7}{:>10}{:>10}",
        "", "ops", "slots", "AVX2", "here"
    );
    for function in FUNCTIONS {
        let name = function.name();
        let arguments: Vec<&[f64]> = vector[..function.arguments().len()]
            .iter()
            .map(Vec::as_slice)
            .collect();
        let mut results = vec![0.0; STATES * arm.entries(name)?];
        let mut time = |level: Level| -> Result<f64, Box<dyn std::error::Error>> {
            let mut best = f64::INFINITY;
            for _ in 0..BATCHES {
                let start = std::time::Instant::now();
                arm.batch_at(level, name, &arguments, &mut results)?;
                best = best.min(start.elapsed().as_secs_f64());
            }
            Ok(best * 1e9 / STATES as f64)
        };
        let here = time(level)?;
        let avx2 = match level.as_avx2() {
            Some(avx2) => format!("{:.1}", time(Level::Avx2(avx2))?),
            None => "-".to_owned(),
        };
        let (operations, slots) = (arm.operations(name)?.total(), arm.slots(name)?);
        println!("{name:<20}{operations:>6}{slots:>7}{avx2:>10}{here:>10.1}");
    }
    Ok(())
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
