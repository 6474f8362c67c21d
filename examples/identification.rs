//! Identification: the base inertial parameters of an arm from its joint torques, by least squares.
//!
//! ```text
//! cargo run --release --example identification
//! ```

use robot_dynamics::nalgebra::{DMatrix, DVector, SVector};
use robot_dynamics::robot_dynamics;

robot_dynamics! {
    /// An elbow arm; `payload` is a mass at its hand.
    struct Arm { payload: f64 }

    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        waist:    revolute { d: 0.4, mass: 8, com: [0, 0.02, -0.1], inertia: cylinder(0.1, 0.4) },
        shoulder: revolute {
            alpha: PI/2, mass: 5, com: [0.22, 0, 0.05], inertia: rod(0.45),
            motor: { inertia: 1e-4, gear_ratio: 100 },
        },
        elbow: revolute {
            a: 0.45, mass: 2 + payload, com: [(2 * 0.18 + payload * 0.4) / (2 + payload), 0, 0], inertia: { yy: 0.06, zz: 0.06 },
            motor: { inertia: 1e-4, gear_ratio: 80 },
            friction: { viscous: 0.8, coulomb: 0.5 },
        },
    ],
    functions: [regressor, base_parameters, inverse_dynamics, friction_vector],
}

/// Degrees of freedom, and base parameters.
const N: usize = Arm::DOF;
const P: usize = Arm::BASE_PARAMETERS;

/// Samples of the motion, at 50 Hz.
const SAMPLES: usize = 500;

/// Size of the noise of the measured torques, N m.
const NOISE: f64 = 0.2;

/// A motion that excites all parameters: q_i is a sum of sines, with velocity and acceleration.
fn motion(t: f64) -> [SVector<f64, N>; 3] {
    let amplitudes = [[0.8, 0.3], [0.6, 0.4], [0.9, 0.2]];
    let frequencies = [[1.0, 3.7], [1.3, 4.1], [1.9, 5.3]];
    [0, 1, 2].map(|derivative| {
        SVector::from_fn(|i, _| {
            let terms = amplitudes[i].iter().zip(frequencies[i]);
            let phase = f64::from(derivative) * std::f64::consts::FRAC_PI_2;
            terms
                .map(|(a, w): (&f64, f64)| a * w.powi(derivative) * (w * t + phase).sin())
                .sum()
        })
    })
}

/// Reproducible noise within -1 to 1: a linear congruential sequence (Knuth).
fn noise(state: &mut u64) -> f64 {
    *state = state
        .wrapping_mul(6_364_136_223_846_793_005)
        .wrapping_add(1);
    (*state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
}

fn main() {
    // The arm as it is, with a load that the model does not know, and the model.
    let (arm, model) = (Arm { payload: 1.5 }, Arm { payload: 0.0 });
    let mut state = 1;
    let mut regressors = DMatrix::zeros(N * SAMPLES, P);
    let mut torques = DVector::zeros(N * SAMPLES);
    for k in 0..SAMPLES {
        let [q, qd, qdd] = motion(k as f64 / 50.0);
        let measured = arm
            .inverse_dynamics(&q, &qd, &qdd)
            .map(|x| x + NOISE * noise(&mut state));
        // Y base_parameters = tau - F
        let rows = N * k;
        regressors
            .rows_mut(rows, N)
            .copy_from(&model.regressor(&q, &qd, &qdd));
        torques
            .rows_mut(rows, N)
            .copy_from(&(measured - model.friction_vector(&qd)));
    }

    let factors = regressors.svd(true, true);
    let identified = factors
        .solve(&torques, 0.0)
        .expect("both factors were asked for");
    let (assumed, exact): (SVector<f64, P>, _) = (model.base_parameters(), arm.base_parameters());
    println!("{P} base parameters, kg m^2, kg m; {SAMPLES} samples, noise {NOISE} N m");
    println!("column  parameter   assumed     exact  identified     error");
    for k in 0..P {
        let (name, error) = (Arm::BASE_PARAMETER_NAMES[k], identified[k] - exact[k]);
        println!(
            "{:6}  {name:9} {:9.4} {:9.4} {:11.4} {error:9.4}",
            k + 1,
            assumed[k],
            exact[k],
            identified[k]
        );
    }
    let worst = (identified - exact).amax();
    println!("largest error {worst:.4}");
    assert!(worst < 0.05, "the payload was not identified");
}
