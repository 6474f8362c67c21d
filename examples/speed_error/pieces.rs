//! The fourth part of the report: what each piece of a model costs.

use robot_dynamics::nalgebra::SVector;
use robot_dynamics::{Operations, robot_dynamics};

use crate::functions::Arm;
use crate::page::{Part, Section};
use crate::samples::{Samples, State};
use crate::table::{Table, nanoseconds, short};
use crate::timing::Effort;

/// The PUMA 560 with gravity, motors and friction multiplied by 1 or 0, and with other lines of the
/// macro after the joints.
macro_rules! puma {
    ($(#[$documentation:meta])* $name:ident, $gravity:tt, $motor:tt, $friction:tt $(, $($more:tt)*)?) => {
        robot_dynamics! {
            $(#[$documentation])*
            struct $name;

            convention: standard,
            gravity: [0, 0, -9.81 * $gravity],
            joints: [
                waist: revolute {
                    d: 0.67183, alpha: PI/2,
                    inertia: { yy: 0.35 },
                    allow: [unphysical_inertia],
                    motor: { inertia: 0.0002 * $motor, gear_ratio: -62.6111 },
                    friction: { viscous: 5.80182176795 * $friction, coulomb: 25.9836065 * $friction },
                },
                shoulder: revolute {
                    a: 0.4318,
                    mass: 17.4, com: [-0.3638, 0.006, 0.2275],
                    inertia: { xx: 0.13, yy: 0.524, zz: 0.539 },
                    motor: { inertia: 0.0002 * $motor, gear_ratio: 107.815 },
                    friction: { viscous: 9.49686864183 * $friction, coulomb: 10.6197775 * $friction },
                },
                elbow: revolute {
                    d: 0.15005, a: 0.0203, alpha: -PI/2,
                    mass: 4.8, com: [-0.0203, -0.0141, 0.07],
                    inertia: { xx: 0.066, yy: 0.086, zz: 0.0125 },
                    allow: [unphysical_inertia],
                    motor: { inertia: 0.0002 * $motor, gear_ratio: -53.7063 },
                    friction: { viscous: 3.98042599037 * $friction, coulomb: 6.36419655 * $friction },
                },
                forearm: revolute {
                    d: 0.4318, alpha: PI/2,
                    mass: 0.82, com: [0, 0.019, 0],
                    inertia: { xx: 0.0018, yy: 0.0013, zz: 0.0018 },
                    motor: { inertia: 3.3e-5 * $motor, gear_ratio: 76.0364 },
                    friction: { viscous: 0.411645229697 * $friction, coulomb: 1.06831142 * $friction },
                },
                wrist: revolute {
                    alpha: -PI/2,
                    mass: 0.34,
                    inertia: { xx: 0.0003, yy: 0.0004, zz: 0.0003 },
                    motor: { inertia: 3.3e-5 * $motor, gear_ratio: 71.923 },
                    friction: { viscous: 0.427283020935 * $friction, coulomb: 0.85444524 * $friction },
                },
                flange: revolute {
                    mass: 0.09, com: [0, 0, 0.032],
                    inertia: { xx: 0.00015, yy: 0.00015, zz: 4e-5 },
                    motor: { inertia: 3.3e-5 * $motor, gear_ratio: 76.686 },
                    friction: { viscous: 0.215823253273 * $friction, coulomb: 0.55443978 * $friction },
                },
            ],
            functions: [
                mass_matrix, coriolis_vector, gravity_vector, inverse_dynamics, forward_dynamics
            ],
            $($($more)*)?
        }
    };
}

puma!(/** Everything. */ Complete, 1, 1, 1);
puma!(/** Weightless. */ NoGravity, 0, 1, 1);
puma!(/** Without motors. */ NoMotors, 1, 0, 1);
puma!(/** Without friction. */ NoFriction, 1, 1, 0);

/// The Panda with the products of inertia multiplied by 1 or 0.
macro_rules! panda {
    ($(#[$documentation:meta])* $name:ident, $product:tt) => {
        robot_dynamics! {
            $(#[$documentation])*
            struct $name;

            convention: modified,
            gravity: [0, 0, -9.81],
            joints: [
                joint1: revolute {
                    d: 0.333,
                    mass: 4.970684, com: [0.003875, 0.002081, -0.04762],
                    inertia: {
                        xx: 0.70337, yy: 0.70661, zz: 0.009117,
                        xy: -0.000139 * $product, yz: 0.019169 * $product, xz: 0.006772 * $product,
                    },
                },
                joint2: revolute {
                    alpha: -PI/2,
                    mass: 0.646926, com: [-0.003141, -0.02872, 0.003495],
                    inertia: {
                        xx: 0.007962, yy: 0.02811, zz: 0.025995,
                        xy: -0.003925 * $product, yz: 0.000704 * $product, xz: 0.010254 * $product,
                    },
                },
                joint3: revolute {
                    alpha: PI/2, d: 0.316,
                    mass: 3.228604, com: [0.027518, 0.039252, -0.066502],
                    inertia: {
                        xx: 0.037242, yy: 0.036155, zz: 0.01083,
                        xy: -0.004761 * $product, yz: -0.012805 * $product, xz: -0.011396 * $product,
                    },
                },
                joint4: revolute {
                    a: 0.0825, alpha: PI/2,
                    mass: 3.587895, com: [-0.05317, 0.104419, 0.027454],
                    inertia: {
                        xx: 0.025853, yy: 0.019552, zz: 0.028323,
                        xy: 0.007796 * $product, yz: 0.008641 * $product, xz: -0.001332 * $product,
                    },
                },
                joint5: revolute {
                    a: -0.0825, alpha: -PI/2, d: 0.384,
                    mass: 1.225946, com: [-0.011953, 0.041065, -0.038437],
                    inertia: {
                        xx: 0.035549, yy: 0.029474, zz: 0.008627,
                        xy: -0.002117 * $product, yz: 0.000229 * $product, xz: -0.004037 * $product,
                    },
                },
                joint6: revolute {
                    alpha: PI/2,
                    mass: 1.666555, com: [0.060149, -0.014117, -0.010517],
                    inertia: {
                        xx: 0.001964, yy: 0.004354, zz: 0.005433,
                        xy: 0.000109 * $product, yz: 0.000341 * $product, xz: -0.001158 * $product,
                    },
                },
                joint7: revolute {
                    a: 0.088, alpha: PI/2, d: 0.107,
                    mass: 0.735522, com: [0.010517, -0.004252, -0.045403],
                    inertia: {
                        xx: 0.012516, yy: 0.010027, zz: 0.004815,
                        xy: -0.000428 * $product, yz: -0.000741 * $product, xz: -0.001196 * $product,
                    },
                },
            ],
            functions: [
                mass_matrix, coriolis_vector, gravity_vector, inverse_dynamics, forward_dynamics
            ],
        }
    };
}

panda!(/** Everything. */ PandaComplete, 1);
panda!(/** Principal moments only. */ NoProducts, 0);

type Counts = [(&'static str, Operations)];

pub(crate) fn section(effort: Effort) -> Section {
    let mut section = Section::new("What each piece costs");
    section.text(
        "Operations are multiplications, additions and divisions of the generated program; sines \
         apart. The error is that of leaving the piece out: the largest difference of the torques and \
         of M over 48 random states (joints anywhere, up to 3 rad/s and 10 rad/s^2), relative to the \
         natural magnitude, and the root of the mean of the squares for the torques.",
    );
    let heads = [
        "model",
        "tau: operations",
        "ns",
        "M: operations",
        "ns",
        "qdd: operations",
        "ns",
        "error of tau",
        "rms",
        "error of M",
    ];
    let mut table = Table::new("The PUMA 560 and the Panda, piece by piece", &heads);
    let puma = Whole::of(&Complete, effort);
    puma.add(
        &mut table,
        "PUMA 560, complete",
        &Complete,
        &Complete::OPERATIONS,
    );
    puma.add(
        &mut table,
        "without gravity",
        &NoGravity,
        &NoGravity::OPERATIONS,
    );
    puma.add(
        &mut table,
        "without friction",
        &NoFriction,
        &NoFriction::OPERATIONS,
    );
    puma.add(
        &mut table,
        "without motor inertia",
        &NoMotors,
        &NoMotors::OPERATIONS,
    );
    let panda = Whole::of(&PandaComplete, effort);
    panda.add(
        &mut table,
        "Panda, complete",
        &PandaComplete,
        &PandaComplete::OPERATIONS,
    );
    panda.add(
        &mut table,
        "without products of inertia",
        &NoProducts,
        &NoProducts::OPERATIONS,
    );
    section.parts.push(Part::Table(table));
    section
}

/// A complete model, that others are compared with.
struct Whole<'a, R, const N: usize> {
    arm: &'a R,
    samples: Samples<N>,
    effort: Effort,
}

impl<'a, R: Arm<N>, const N: usize> Whole<'a, R, N> {
    fn of(arm: &'a R, effort: Effort) -> Self {
        Whole {
            arm,
            samples: Samples::of(&arm.table()),
            effort,
        }
    }

    fn add<S: Arm<N>>(&self, table: &mut Table, name: &str, part: &S, counts: &Counts) {
        let states = self.samples.states::<f64>();
        let states = &states[..self.samples.timed()];
        let time = |value: &dyn Fn(&State<f64, N>) -> f64| self.effort.nanoseconds(states, value);
        let operations = |function: &str| {
            let count = counts.iter().find(|(name, _)| *name == function);
            count.map_or("-".to_owned(), |(_, count)| count.total().to_string())
        };
        let mut row = vec![name.to_owned(), operations("inverse_dynamics")];
        row.push(nanoseconds(time(&|s| {
            part.inverse_dynamics(&s.q, &s.qd, &s.qdd)[0]
        })));
        row.push(operations("mass_matrix"));
        row.push(nanoseconds(time(&|s| part.mass_matrix(&s.q)[0])));
        row.push(operations("forward_dynamics"));
        row.push(nanoseconds(time(&|s| {
            part.forward_dynamics(&s.q, &s.qd, &s.tau)
                .map_or(f64::NAN, |qdd| qdd[0])
        })));
        row.extend(self.errors(states, part));
        table.row(row);
    }

    /// The largest error and the root mean square of tau, and the largest of M.
    fn errors<S: Arm<N>>(&self, states: &[State<f64, N>], part: &S) -> [String; 3] {
        let (mut largest, mut squares, mut inertia) = (0.0_f64, 0.0, 0.0_f64);
        for (state, values) in states.iter().zip(&self.samples.values) {
            let State { q, qd, qdd, .. } = state;
            let difference: SVector<f64, N> =
                part.inverse_dynamics(q, qd, qdd) - self.arm.inverse_dynamics(q, qd, qdd);
            let relative = difference / values.scale.torque;
            largest = largest.max(relative.amax());
            squares += relative.norm_squared() / N as f64;
            let difference = part.mass_matrix(q) - self.arm.mass_matrix(q);
            inertia = inertia.max(difference.amax() / values.scale.inertia);
        }
        [largest, (squares / states.len() as f64).sqrt(), inertia].map(short)
    }
}
