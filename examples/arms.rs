//! Published six- and seven-axis arms: the check against recursive Newton-Euler, and the energy of
//! a free fall.
//!
//! ```text
//! cargo run --release --example arms
//! ```

use std::error::Error;

use robot_dynamics::plot::{Curve, Figure, joints};
use robot_dynamics::{
    Energy, ForwardDynamics, Simulation, check::Evaluate, check_against_rnea, nalgebra::SVector,
    robot_dynamics,
};

robot_dynamics! {
    /// Stanford arm: joint 3 is prismatic.
    ///
    /// Numbers of the Robotics Toolbox for Python, `models/DH/Stanford.py`, as they stand there
    /// (several centres of mass look ten times too far out; no solid has link 5's tensor).
    struct Stanford;

    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        joint1: revolute {
            d: 0.412, alpha: -PI/2,
            mass: 9.29, com: [0, 0.0175, -0.1105],
            inertia: { xx: 0.276, yy: 0.255, zz: 0.071 },
            motor: { inertia: 0.953, gear_ratio: 1 },
        },
        joint2: revolute {
            d: 0.154, alpha: PI/2,
            mass: 5.01, com: [0, -1.054, 0],
            inertia: { xx: 0.108, yy: 0.018, zz: 0.1 },
            motor: { inertia: 2.193, gear_ratio: 1 },
        },
        joint3: prismatic {
            a: 0.0203, theta: -PI/2,
            mass: 4.25, com: [0, 0, -6.447],
            inertia: { xx: 2.51, yy: 2.51, zz: 0.006 },
            motor: { inertia: 0.782, gear_ratio: 1 },
        },
        joint4: revolute {
            alpha: -PI/2,
            mass: 1.08, com: [0, 0.092, -0.054],
            inertia: { xx: 0.002, yy: 0.001, zz: 0.001 },
            motor: { inertia: 0.106, gear_ratio: 1 },
        },
        joint5: revolute {
            alpha: PI/2,
            mass: 0.63, com: [0, 0.566, 0.003],
            inertia: { xx: 0.003, yy: 0.0004 },
            motor: { inertia: 0.097, gear_ratio: 1 },
            allow: [unphysical_inertia],
        },
        joint6: revolute {
            mass: 0.51, com: [0, 0, 1.554],
            inertia: { xx: 0.013, yy: 0.013, zz: 0.0003 },
            motor: { inertia: 0.02, gear_ratio: 1 },
        },
    ],
}

robot_dynamics! {
    /// Franka Emika Panda with full inertia tensors, frame 7 at the flange, no tool.
    ///
    /// Inertial parameters identified by C. Gaz and others, RA-L 4 (2019), as in franka_ros,
    /// moved to the frames of the modified Denavit-Hartenberg table.
    struct Panda;

    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        joint1: revolute {
            d: 0.333,
            mass: 4.970684, com: [0.003875, 0.002081, -0.04762],
            inertia: { xx: 0.70337, yy: 0.70661, zz: 0.009117,
                       xy: -0.000139, yz: 0.019169, xz: 0.006772 },
        },
        joint2: revolute {
            alpha: -PI/2,
            mass: 0.646926, com: [-0.003141, -0.02872, 0.003495],
            inertia: { xx: 0.007962, yy: 0.02811, zz: 0.025995,
                       xy: -0.003925, yz: 0.000704, xz: 0.010254 },
        },
        joint3: revolute {
            d: 0.316, alpha: PI/2,
            mass: 3.228604, com: [0.027518, 0.039252, -0.066502],
            inertia: { xx: 0.037242, yy: 0.036155, zz: 0.01083,
                       xy: -0.004761, yz: -0.012805, xz: -0.011396 },
        },
        joint4: revolute {
            a: 0.0825, alpha: PI/2,
            mass: 3.587895, com: [-0.05317, 0.104419, 0.027454],
            inertia: { xx: 0.025853, yy: 0.019552, zz: 0.028323,
                       xy: 0.007796, yz: 0.008641, xz: -0.001332 },
        },
        joint5: revolute {
            d: 0.384, a: -0.0825, alpha: -PI/2,
            mass: 1.225946, com: [-0.011953, 0.041065, -0.038437],
            inertia: { xx: 0.035549, yy: 0.029474, zz: 0.008627,
                       xy: -0.002117, yz: 0.000229, xz: -0.004037 },
        },
        joint6: revolute {
            alpha: PI/2,
            mass: 1.666555, com: [0.060149, -0.014117, -0.010517],
            inertia: { xx: 0.001964, yy: 0.004354, zz: 0.005433,
                       xy: 0.000109, yz: 0.000341, xz: -0.001158 },
        },
        joint7: revolute {
            d: 0.107, a: 0.088, alpha: PI/2,
            mass: 0.735522, com: [0.010517, -0.004252, -0.045403],
            inertia: { xx: 0.012516, yy: 0.010027, zz: 0.004815,
                       xy: -0.000428, yz: -0.000741, xz: -0.001196 },
        },
    ],
}

robot_dynamics! {
    /// Universal Robots UR5: links as solid cylinders, from the ROS-Industrial description, on the
    /// maker's Denavit-Hartenberg table.
    struct Ur5;

    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        shoulder_pan: revolute {
            d: 0.089159, alpha: PI/2,
            mass: 3.7,
            inertia: { xx: 0.010267495893, yy: 0.00666, zz: 0.010267495893 },
        },
        shoulder_lift: revolute {
            a: -0.425,
            mass: 8.393, com: [0.145, 0, 0.13585],
            inertia: { xx: 0.0151074, yy: 0.22689067591, zz: 0.22689067591 },
        },
        elbow: revolute {
            a: -0.39225,
            mass: 2.275, com: [0.14225, 0, 0.01615],
            inertia: { xx: 0.004095, yy: 0.049443313556, zz: 0.049443313556 },
        },
        wrist1: revolute {
            d: 0.10915, alpha: PI/2,
            mass: 1.219, com: [0, -0.093, 0],
            inertia: { xx: 0.111172755531, yy: 0.111172755531, zz: 0.21942 },
        },
        wrist2: revolute {
            d: 0.09465, alpha: -PI/2,
            mass: 1.219, com: [0, 0.09465, 0],
            inertia: { xx: 0.111172755531, yy: 0.21942, zz: 0.111172755531 },
        },
        wrist3: revolute {
            d: 0.0823,
            mass: 0.1879, com: [0, 0, -0.0823],
            inertia: { xx: 0.0171364731454, yy: 0.033822, zz: 0.0171364731454 },
        },
    ],
}

fn main() -> Result<(), Box<dyn Error>> {
    let stanford = [0.0, 0.5, 0.3, 0.2, 0.4, 0.0];
    let panda = [0.0, -0.785, 0.0, -2.356, 0.0, 1.571, 0.785];
    let ur5 = [0.0, -0.5, 0.8, 0.3, 0.4, 0.0];
    examine("stanford", &Stanford, stanford)?;
    examine("panda", &Panda, panda)?;
    examine("ur5", &Ur5, ur5)
}

/// Prints the check of any arm, and lets it fall for one second from rest at `start`.
fn examine<const N: usize, R>(name: &str, robot: &R, start: [f64; N]) -> Result<(), Box<dyn Error>>
where
    R: Evaluate<N> + ForwardDynamics<N> + Energy<N>,
{
    let report = check_against_rnea(robot);
    println!("\n{name}: {report}");
    report.assert_ok();
    let run = Simulation::new(robot)
        .initial(SVector::from(start), SVector::zeros())
        .duration(1.0)
        .samples(401)
        .run()?;
    let drift = run.energy_drift(robot);
    println!("free fall of 1 s: largest energy error {drift:.1e} J");

    let energies = run.energies(robot);
    let errors = energies.iter().map(|energy| energy - energies[0]);
    let energy_error = Curve::new("T + U", &run.t, errors);
    Figure::new(format!("{name}: free fall"))
        .panel("positions, rad or m", joints(R::JOINT_NAMES, &run.t, run.q))
        .panel("energy error, J", [energy_error])
        .save(format!("examples/output/{name}_free_fall.svg"))
}
