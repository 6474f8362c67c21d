//! The arms of the hard cases, each with the functions that its cases need.

use robot_dynamics::robot_dynamics;

/// A chain of slender rods of 1 m and 1 kg in a vertical plane.
macro_rules! planar_chain {
    ($name:ident, $function:ident: $($joint:ident)*) => {
        robot_dynamics! {
            pub(crate) struct $name;
            convention: standard,
            gravity: [0, -9.81, 0],
            joints: [$($joint: revolute { a: 1, mass: 1, com: [-1/2, 0, 0], inertia: rod(1) },)*],
            functions: [$function],
        }
    };
}

planar_chain!(Chain10, forward_dynamics: j1 j2 j3 j4 j5 j6 j7 j8 j9 j10);
planar_chain!(ArticulatedChain10, forward_dynamics_aba: j1 j2 j3 j4 j5 j6 j7 j8 j9 j10);
planar_chain!(Chain30, forward_dynamics: j1 j2 j3 j4 j5 j6 j7 j8 j9 j10 j11 j12 j13 j14 j15 j16 j17 j18
    j19 j20 j21 j22 j23 j24 j25 j26 j27 j28 j29 j30);
planar_chain!(ArticulatedChain30, forward_dynamics_aba: j1 j2 j3 j4 j5 j6 j7 j8 j9 j10 j11 j12 j13 j14 j15
    j16 j17 j18 j19 j20 j21 j22 j23 j24 j25 j26 j27 j28 j29 j30);

/// Point masses at the ends of two links of 1 m, the first without mass where `m1` is 0.
macro_rules! point_masses {
    ($name:ident, $functions:tt) => {
        robot_dynamics! {
            pub(crate) struct $name { pub(crate) m1: f64, pub(crate) m2: f64 }
            convention: standard,
            gravity: [0, -9.81, 0],
            joints: [
                shoulder: revolute { a: 1, mass: m1 },
                elbow: revolute { a: 1, mass: m2 },
            ],
            functions: $functions,
        }
    };
}

point_masses!(
    PointMasses,
    [mass_matrix, inverse_dynamics, forward_dynamics]
);
point_masses!(ArticulatedMasses, [forward_dynamics_aba]);

robot_dynamics! {
    /// A rod, and a link without mass.
    pub(crate) struct MasslessTip;
    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        shoulder: revolute { a: 1, mass: 1, com: [-1/2, 0, 0], inertia: rod(1) },
        elbow: revolute { a: 1 },
    ],
    functions: [forward_dynamics],
}

robot_dynamics! {
    /// A rod, and a point mass on the axis of the last joint.
    pub(crate) struct PointOnAxis;
    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        shoulder: revolute { a: 1, mass: 1, com: [-1/2, 0, 0], inertia: rod(1) },
        hand: revolute { mass: 1 },
    ],
    functions: [forward_dynamics],
}

robot_dynamics! {
    /// A link without mass, and a rod: regular everywhere.
    pub(crate) struct MasslessRoot;
    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        shoulder: revolute { a: 1 },
        elbow: revolute { a: 1, mass: 1, com: [-1/2, 0, 0], inertia: rod(1) },
    ],
    functions: [forward_dynamics],
}

/// Three axes that meet in one point, and one body: singular where the outer two are parallel.
macro_rules! ideal_wrist {
    ($name:ident, $functions:tt) => {
        robot_dynamics! {
            pub(crate) struct $name;
            convention: standard,
            gravity: [0, 0, -9.81],
            joints: [
                yaw: revolute { alpha: -PI/2 },
                pitch: revolute { alpha: PI/2 },
                roll: revolute {
                    mass: 1, com: [0, 0, 0.1],
                    inertia: { xx: 0.001, yy: 0.001, zz: 0.001 },
                },
            ],
            functions: $functions,
        }
    };
}

ideal_wrist!(
    IdealWrist,
    [mass_matrix, inverse_dynamics, forward_dynamics]
);
ideal_wrist!(ArticulatedWrist, [forward_dynamics_aba]);

/// The PUMA 560 (Armstrong, Khatib and Burdick 1986; Corke 1996), without friction: `motors` times the inertia
/// of its motors, the last link `hand` times as heavy.
macro_rules! puma560 {
    ($(#[$doc:meta])* $name:ident, motors: $motors:literal, hand: $hand:literal, $functions:tt) => {
        robot_dynamics! {
            $(#[$doc])*
            pub(crate) struct $name;
            convention: standard,
            gravity: [0, 0, -9.81],
            joints: [
                waist: revolute {
                    d: 0.67183, alpha: PI/2,
                    inertia: { yy: 0.35 },
                    allow: [unphysical_inertia],
                    motor: { inertia: 0.0002 * $motors, gear_ratio: -62.6111 },
                },
                shoulder: revolute {
                    a: 0.4318,
                    mass: 17.4, com: [-0.3638, 0.006, 0.2275],
                    inertia: { xx: 0.13, yy: 0.524, zz: 0.539 },
                    motor: { inertia: 0.0002 * $motors, gear_ratio: 107.815 },
                },
                elbow: revolute {
                    d: 0.15005, a: 0.0203, alpha: -PI/2,
                    mass: 4.8, com: [-0.0203, -0.0141, 0.07],
                    inertia: { xx: 0.066, yy: 0.086, zz: 0.0125 },
                    allow: [unphysical_inertia],
                    motor: { inertia: 0.0002 * $motors, gear_ratio: -53.7063 },
                },
                forearm: revolute {
                    d: 0.4318, alpha: PI/2,
                    mass: 0.82, com: [0, 0.019, 0],
                    inertia: { xx: 0.0018, yy: 0.0013, zz: 0.0018 },
                    motor: { inertia: 3.3e-5 * $motors, gear_ratio: 76.0364 },
                },
                wrist: revolute {
                    alpha: -PI/2,
                    mass: 0.34,
                    inertia: { xx: 0.0003, yy: 0.0004, zz: 0.0003 },
                    motor: { inertia: 3.3e-5 * $motors, gear_ratio: 71.923 },
                },
                flange: revolute {
                    mass: 0.09 * $hand, com: [0, 0, 0.032],
                    inertia: { xx: 0.00015 * $hand, yy: 0.00015 * $hand, zz: 4e-5 * $hand },
                    motor: { inertia: 3.3e-5 * $motors, gear_ratio: 76.686 },
                },
            ],
            functions: $functions,
        }
    };
}

puma560! {
    /// The PUMA 560 without friction.
    Puma560, motors: 1, hand: 1,
    [mass_matrix, coriolis_vector, gravity_vector, inverse_dynamics, forward_dynamics,
     kinetic_energy, potential_energy]
}
puma560! {
    /// The PUMA 560 without motors.
    DirectPuma, motors: 0, hand: 1, [mass_matrix]
}
puma560! {
    /// The PUMA 560 without motors, its last link a millionth of a millionth as heavy.
    GradedPuma, motors: 0, hand: 1e-12, [mass_matrix, forward_dynamics]
}

robot_dynamics! {
    /// A slender rod that hangs at 0: thdd + 14.715 sin th = 3 tau.
    pub(crate) struct OneLink;
    convention: standard,
    gravity: [9.81, 0, 0],
    joints: [joint: revolute { a: 1, mass: 1, com: [-0.5, 0, 0], inertia: rod(1) }],
    functions: [mass_matrix, gravity_vector, inverse_dynamics, forward_dynamics,
                kinetic_energy, potential_energy],
}

robot_dynamics! {
    /// The same rod, its angle counted from the upright position: exact near it.
    pub(crate) struct UprightLink;
    convention: standard,
    gravity: [9.81, 0, 0],
    joints: [joint: revolute { theta: PI, a: 1, mass: 1, com: [-0.5, 0, 0], inertia: rod(1) }],
    functions: [forward_dynamics],
}

robot_dynamics! {
    /// Two slender rods, angles from the horizontal (Saha).
    pub(crate) struct TwoRods;
    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        shoulder: revolute { a: 2, mass: 3, com: [-1, 0, 0], inertia: rod(2) },
        elbow: revolute { a: 1, mass: 1, com: [-0.5, 0, 0], inertia: rod(1) },
    ],
    functions: [mass_matrix, coriolis_vector, gravity_vector, inverse_dynamics, forward_dynamics,
                kinetic_energy, potential_energy, taylor_series],
}

robot_dynamics! {
    /// Two rods whose axes are parallel but for 1e-9 rad.
    pub(crate) struct NearlyParallel;
    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        shoulder: revolute { a: 1, alpha: 1e-9, mass: 1, com: [-0.5, 0, 0], inertia: rod(1) },
        elbow: revolute { a: 1, mass: 1, com: [-0.5, 0, 0], inertia: rod(1) },
    ],
    functions: [gravity_vector],
}

/// A mass of 1 kg on a rail that rises at an angle; its force of gravity is a sine and a cosine of it.
macro_rules! inclined_rail {
    ($name:ident: $angle:expr) => {
        robot_dynamics! {
            pub(crate) struct $name { pub(crate) gy: f64, pub(crate) gz: f64 }
            convention: modified,
            gravity: [0, gy, gz],
            joints: [slide: prismatic { alpha: $angle, mass: 1 }],
            functions: [gravity_vector],
        }
    };
}

inclined_rail!(Rail30: deg(30));
inclined_rail!(Rail45: deg(45));
inclined_rail!(Rail60: deg(60));
inclined_rail!(Rail120: deg(120));

/// Two rods with a twist between their axes.
macro_rules! twisted {
    ($name:ident: $angle:expr) => {
        robot_dynamics! {
            pub(crate) struct $name;
            convention: standard,
            gravity: [0, -9.81, 0],
            joints: [
                shoulder: revolute { a: 1, alpha: $angle, mass: 1, com: [-0.5, 0.1, 0], inertia: rod(1) },
                elbow: revolute { a: 1, mass: 1, com: [-0.5, 0, 0.2], inertia: rod(1) },
            ],
            functions: [inverse_dynamics],
            allow: [odd_angle], // One of them is nearly a right angle.
        }
    };
}

twisted!(TwistedByPi: PI/2);
twisted!(TwistedByDegrees: deg(90));
twisted!(TwistedByDecimals: 1.5707963267948966);
twisted!(TwistedByFewDecimals: 1.570796327);
twisted!(TwistedByRoughly: 1.5708);

robot_dynamics! {
    /// A joint with dry friction: J = 1 kg m^2, 1 N m.
    pub(crate) struct DryJoint;
    convention: standard,
    gravity: [0, 0, 0],
    joints: [joint: revolute {
        mass: 1, inertia: { xx: 1, yy: 1, zz: 1 },
        friction: { coulomb: 1 },
    }],
    functions: [friction_vector, forward_dynamics],
}

robot_dynamics! {
    /// A joint with much viscous friction: J = 1 kg m^2, 10^6 N m s.
    pub(crate) struct StiffJoint;
    convention: standard,
    gravity: [0, 0, 0],
    joints: [joint: revolute {
        mass: 1, inertia: { xx: 1, yy: 1, zz: 1 },
        friction: { viscous: 1e6 },
    }],
    functions: [forward_dynamics],
}

robot_dynamics! {
    /// A point of 1 kg in a plane, in polar coordinates: M = diag(r^2, 1).
    pub(crate) struct PolarPoint;
    convention: standard,
    gravity: [0, 0, 0],
    joints: [
        angle: revolute { alpha: PI/2 },
        radius: prismatic { mass: 1 },
    ],
    functions: [mass_matrix, forward_dynamics],
}

robot_dynamics! {
    /// A mass of 1 kg on a rail.
    pub(crate) struct Cart;
    convention: standard,
    gravity: [0, 0, 0],
    joints: [slide: prismatic { mass: 1 }],
    functions: [forward_dynamics],
}

robot_dynamics! {
    /// Two links of which everything is a field.
    pub(crate) struct Scaled {
        pub(crate) a1: f64,
        pub(crate) m1: f64,
        pub(crate) c1: f64,
        pub(crate) i1: f64,
        pub(crate) a2: f64,
        pub(crate) m2: f64,
        pub(crate) c2: f64,
        pub(crate) i2: f64,
        pub(crate) g: f64,
    }
    convention: standard,
    gravity: [0, -g, 0],
    joints: [
        shoulder: revolute { a: a1, mass: m1, com: [c1, 0, 0], inertia: { zz: i1 }, allow: [unphysical_inertia] },
        elbow: revolute { a: a2, mass: m2, com: [c2, 0, 0], inertia: { zz: i2 }, allow: [unphysical_inertia] },
    ],
    functions: [mass_matrix, inverse_dynamics, forward_dynamics],
}

/// An elbow arm without friction, of whose Lagrangian all terms below a share are left out.
macro_rules! pruned_elbow {
    ($name:ident, $share:literal) => {
        robot_dynamics! {
            pub(crate) struct $name;
            convention: standard,
            gravity: [0, 0, -9.81],
            joints: [
                waist: revolute {
                    d: 0.4, alpha: PI/2,
                    mass: 5, com: [0.01, -0.12, 0.02],
                    inertia: { xx: 0.06, yy: 0.03, zz: 0.055, xy: 0.001, yz: -0.002, xz: 0.0015 },
                    motor: { inertia: 0.0002, gear_ratio: 100 },
                },
                shoulder: revolute {
                    a: 0.45,
                    mass: 7.5, com: [-0.21, 0.015, 0.06],
                    inertia: { xx: 0.05, yy: 0.21, zz: 0.22, xy: -0.004, yz: 0.003, xz: 0.006 },
                    motor: { inertia: 0.0002, gear_ratio: 120 },
                },
                elbow: revolute {
                    a: 0.38,
                    mass: 3.2, com: [-0.17, -0.01, 0.015],
                    inertia: { xx: 0.009, yy: 0.045, zz: 0.048, xy: 0.0012, yz: -0.0008, xz: 0.0009 },
                    motor: { inertia: 0.0001, gear_ratio: 80 },
                },
            ],
            neglect: $share%,
            functions: [forward_dynamics, kinetic_energy, potential_energy],
        }
    };
}

pruned_elbow!(ElbowAtTenthOfPercent, 0.1);
pruned_elbow!(ElbowAtOnePercent, 1);
pruned_elbow!(ElbowAtThreePercent, 3);
