//! A digital controller and mechanical stops: a PID controller at 1 kHz, whose integrals and log are its
//! memory, and what happens when it is switched off.
//!
//! ```text
//! cargo run --release --example sampled
//! ```

use std::error::Error;
use std::fs::File;
use std::io::BufWriter;

use robot_dynamics::nalgebra::Vector2;
use robot_dynamics::{Friction, Simulation, robot_dynamics};

robot_dynamics! {
    /// An arm in a vertical plane, with stops.
    struct Arm;

    convention: modified,
    gravity: [0, -9.81, 0],
    joints: [
        shoulder: revolute {
            mass: 4, com: [0.2, 0, 0], inertia: rod(0.4),
            motor: { inertia: 2e-4, gear_ratio: 50 },
            friction: { viscous: 0.5, coulomb: 0.4 },
            limits: [deg(-60), deg(120)],
        },
        elbow: revolute {
            a: 0.4, mass: 2, com: [0.15, 0, 0], inertia: rod(0.3),
            friction: { viscous: 0.2, coulomb: 0.1 },
            limits: [deg(-20), deg(150)],
        },
    ],
}

type Vector = Vector2<f64>;

const PERIOD: f64 = 1e-3;
const TARGET: Vector = Vector::new(0.8, 0.5);

/// tau = P e + I int e dt - D qd, with e = q_d - q. It knows nothing of the arm.
struct Pid {
    gains: [Vector; 3],
    integral: Vector,
    /// The largest torques so far.
    largest: Vector,
}

impl Pid {
    fn torque(&mut self, q: &Vector, qd: &Vector) -> Vector {
        let [p, i, d] = self.gains;
        let error = TARGET - q;
        self.integral += error * PERIOD;
        let tau = p.component_mul(&error) + i.component_mul(&self.integral) - d.component_mul(qd);
        self.largest = self.largest.sup(&tau.abs());
        tau
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut pid = Pid {
        gains: [
            Vector::new(180.0, 60.0),
            Vector::new(250.0, 120.0),
            Vector::new(30.0, 6.0),
        ],
        integral: Vector::zeros(),
        largest: Vector::zeros(),
    };
    // The law is called at 0, 1 ms, 2 ms, ..., once each: it may keep what it learns.
    let mut simulation = Simulation::new(&Arm)
        .control_period(PERIOD)
        .torque(|_t, q, qd| pid.torque(q, qd))
        .friction(Friction::Sticking)
        .stops(0.3)
        .duration(4.0)
        .samples(401);
    let held = simulation.run()?;
    let (q, tau) = (held.q[400], held.tau[400]);
    let error = (TARGET - q).amax();
    println!("after 4 s of control the joints are {error:.1e} rad from their target");
    let weight = Arm.gravity_vector(&q);
    println!(
        "the motors hold what friction does not of gravity: {:.2} and {:.2} N m of {:.2} and {:.2}",
        tau[0], tau[1], weight[0], weight[1]
    );
    println!(
        "at most {:.1} and {:.1} N m were asked for",
        pid.largest[0], pid.largest[1]
    );
    assert!(error < 5e-3);

    // The motors are switched off: the arm falls onto its stops.
    let fall = Simulation::new(&Arm)
        .initial(q, Vector::zeros())
        .friction(Friction::Sticking)
        .stops(0.3)
        .duration(3.0)
        .samples(301)
        .run()?;
    let energies = fall.energies(&Arm);
    let lost = energies[0] - energies[300];
    println!(
        "switched off, it comes to rest on its stops at {:.1} and {:.1} degrees, {lost:.1} J lost",
        fall.q[300][0].to_degrees(),
        fall.q[300][1].to_degrees()
    );
    assert!(energies.windows(2).all(|pair| pair[1] <= pair[0] + 1e-7));
    assert_eq!(fall.qd[300], Vector::zeros());

    // Where a limit is a mistake and no stop, the run ends there and says so.
    let passed = Simulation::new(&Arm)
        .initial(q, Vector::zeros())
        .limits_are_errors()
        .run()
        .unwrap_err();
    println!("without stops: {passed}");

    std::fs::create_dir_all("examples/output")?;
    let file = File::create("examples/output/sampled.csv")?;
    held.write_csv(&Arm, BufWriter::new(file))?;
    held.plot(&Arm, "examples/output/sampled.svg")?;
    fall.plot(&Arm, "examples/output/sampled_stops.svg")?;
    println!("samples and curves: examples/output/sampled.csv, sampled.svg, sampled_stops.svg");
    Ok(())
}
