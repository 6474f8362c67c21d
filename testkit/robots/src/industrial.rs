//! Arms that are, or were, built: parameters as published.

every_function_and_tuples! {
    /// SCARA: kinematics of the Adept Cobra 600, masses and inertias of our own.
    pub struct Scara;

    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        shoulder: revolute {
            d: 0.387, a: 0.325,
            mass: 5.2, com: [-0.15, 0.01, -0.03],
            inertia: { xx: 0.012, yy: 0.065, zz: 0.07, xy: 0.001, yz: 0.0005, xz: -0.002 },
            motor: { inertia: 5e-5, gear_ratio: 80 },
            friction: { viscous: 0.3, coulomb: 0.4 },
        },
        elbow: revolute {
            a: 0.275, alpha: PI,
            mass: 3.1, com: [-0.13, -0.015, 0.02],
            inertia: { xx: 0.007, yy: 0.031, zz: 0.034, xy: -0.0006, yz: 0.0004, xz: 0.001 },
            motor: { inertia: 3e-5, gear_ratio: 50 },
            friction: { viscous: 0.2, coulomb: 0.3 },
        },
        quill: prismatic {
            mass: 1.1, com: [0.002, -0.003, -0.08],
            inertia: { xx: 0.0042, yy: 0.0043, zz: 0.0006, xy: 1e-5, yz: 2e-5, xz: -3e-5 },
            friction: { viscous: 8, coulomb: 3 },
        },
        wrist: revolute {
            mass: 0.4, com: [0.004, 0.001, 0.02],
            inertia: { xx: 0.0005, yy: 0.00052, zz: 0.0003, xy: 1e-5, yz: -2e-5, xz: 3e-5 },
            friction: { viscous: 0.02 },
        },
    ],
}

every_function_of_a_long_arm! {
    /// MTAB Aristo. D-H table as published, masses and inertias an estimate (solid cylinders).
    pub struct Aristo;

    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        waist: revolute {
            d: 0.322, alpha: PI/2,
            mass: 8, com: [0, -0.12, 0],
            inertia: { xx: 0.0482, yy: 0.0196, zz: 0.0482 },
        },
        shoulder: revolute {
            a: 0.3,
            mass: 6, com: [-0.15, 0, 0],
            inertia: { xx: 0.0075, yy: 0.0488, zz: 0.0488 },
        },
        elbow: revolute {
            alpha: PI/2,
            mass: 3.5, com: [0, 0, -0.1],
            inertia: { xx: 0.0139, yy: 0.0139, zz: 0.0044 },
        },
        forearm: revolute {
            d: -0.375, alpha: PI/2,
            mass: 2.2, com: [0, 0.12, 0],
            inertia: { xx: 0.0082, yy: 0.0018, zz: 0.0082 },
        },
        wrist: revolute {
            alpha: PI/2,
            mass: 0.9, com: [0, 0, 0.01],
            inertia: { xx: 0.0006, yy: 0.0006, zz: 0.0006 },
        },
        flange: revolute {
            d: 0.063,
            mass: 0.3, com: [0, 0, -0.02],
            inertia: { xx: 9e-5, yy: 9e-5, zz: 0.000135 },
        },
    ],
}

every_function_and_tuples! {
    /// PUMA 560 (Corke and Armstrong-Helouvry 1994). Links 1 and 3 have the published
    /// tensors, which no body can have.
    pub struct Puma560;

    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        waist: revolute {
            d: 0.67183, alpha: PI/2,
            inertia: { yy: 0.35 },
            allow: [unphysical_inertia],
            motor: { inertia: 0.0002, gear_ratio: -62.6111 },
            friction: { viscous: 5.80182176795, coulomb: 25.9836065 },
        },
        shoulder: revolute {
            a: 0.4318,
            mass: 17.4, com: [-0.3638, 0.006, 0.2275],
            inertia: { xx: 0.13, yy: 0.524, zz: 0.539 },
            motor: { inertia: 0.0002, gear_ratio: 107.815 },
            friction: { viscous: 9.49686864183, coulomb: 10.6197775 },
        },
        elbow: revolute {
            d: 0.15005, a: 0.0203, alpha: -PI/2,
            mass: 4.8, com: [-0.0203, -0.0141, 0.07],
            inertia: { xx: 0.066, yy: 0.086, zz: 0.0125 },
            allow: [unphysical_inertia],
            motor: { inertia: 0.0002, gear_ratio: -53.7063 },
            friction: { viscous: 3.98042599037, coulomb: 6.36419655 },
        },
        forearm: revolute {
            d: 0.4318, alpha: PI/2,
            mass: 0.82, com: [0, 0.019, 0],
            inertia: { xx: 0.0018, yy: 0.0013, zz: 0.0018 },
            motor: { inertia: 3.3e-5, gear_ratio: 76.0364 },
            friction: { viscous: 0.411645229697, coulomb: 1.06831142 },
        },
        wrist: revolute {
            alpha: -PI/2,
            mass: 0.34,
            inertia: { xx: 0.0003, yy: 0.0004, zz: 0.0003 },
            motor: { inertia: 3.3e-5, gear_ratio: 71.923 },
            friction: { viscous: 0.427283020935, coulomb: 0.85444524 },
        },
        flange: revolute {
            mass: 0.09, com: [0, 0, 0.032],
            inertia: { xx: 0.00015, yy: 0.00015, zz: 4e-5 },
            motor: { inertia: 3.3e-5, gear_ratio: 76.686 },
            friction: { viscous: 0.215823253273, coulomb: 0.55443978 },
        },
    ],
}

every_function! {
    /// Stanford arm, as in the Robotics Toolbox: several centres of mass look ten times too far
    /// out, and link 5 has no Izz.
    pub struct Stanford;

    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        waist: revolute {
            d: 0.412, alpha: -PI/2,
            mass: 9.29, com: [0, 0.0175, -0.1105],
            inertia: { xx: 0.276, yy: 0.255, zz: 0.071 },
            motor: { inertia: 0.953, gear_ratio: 1 },
        },
        shoulder: revolute {
            d: 0.154, alpha: PI/2,
            mass: 5.01, com: [0, -1.054, 0],
            inertia: { xx: 0.108, yy: 0.018, zz: 0.1 },
            motor: { inertia: 2.193, gear_ratio: 1 },
        },
        boom: prismatic {
            theta: -PI/2, a: 0.0203,
            mass: 4.25, com: [0, 0, -6.447],
            inertia: { xx: 2.51, yy: 2.51, zz: 0.006 },
            motor: { inertia: 0.782, gear_ratio: 1 },
        },
        forearm: revolute {
            alpha: -PI/2,
            mass: 1.08, com: [0, 0.092, -0.054],
            inertia: { xx: 0.002, yy: 0.001, zz: 0.001 },
            motor: { inertia: 0.106, gear_ratio: 1 },
        },
        wrist: revolute {
            alpha: PI/2,
            mass: 0.63, com: [0, 0.566, 0.003],
            inertia: { xx: 0.003, yy: 0.0004 },
            allow: [unphysical_inertia],
            motor: { inertia: 0.097, gear_ratio: 1 },
        },
        flange: revolute {
            mass: 0.51, com: [0, 0, 1.554],
            inertia: { xx: 0.013, yy: 0.013, zz: 0.0003 },
            motor: { inertia: 0.02, gear_ratio: 1 },
        },
    ],
}

every_function_and_tuples! {
    /// Franka Panda (Gaz et al. 2019), frame 7 at the flange.
    pub struct Panda;

    convention: modified,
    gravity: [0, 0, -9.81],
    joints: [
        joint1: revolute {
            d: 0.333,
            mass: 4.970684, com: [0.003875, 0.002081, -0.04762],
            inertia: {
                xx: 0.70337, yy: 0.70661, zz: 0.009117,
                xy: -0.000139, yz: 0.019169, xz: 0.006772,
            },
        },
        joint2: revolute {
            alpha: -PI/2,
            mass: 0.646926, com: [-0.003141, -0.02872, 0.003495],
            inertia: {
                xx: 0.007962, yy: 0.02811, zz: 0.025995,
                xy: -0.003925, yz: 0.000704, xz: 0.010254,
            },
        },
        joint3: revolute {
            alpha: PI/2, d: 0.316,
            mass: 3.228604, com: [0.027518, 0.039252, -0.066502],
            inertia: {
                xx: 0.037242, yy: 0.036155, zz: 0.01083,
                xy: -0.004761, yz: -0.012805, xz: -0.011396,
            },
        },
        joint4: revolute {
            a: 0.0825, alpha: PI/2,
            mass: 3.587895, com: [-0.05317, 0.104419, 0.027454],
            inertia: {
                xx: 0.025853, yy: 0.019552, zz: 0.028323,
                xy: 0.007796, yz: 0.008641, xz: -0.001332,
            },
        },
        joint5: revolute {
            a: -0.0825, alpha: -PI/2, d: 0.384,
            mass: 1.225946, com: [-0.011953, 0.041065, -0.038437],
            inertia: {
                xx: 0.035549, yy: 0.029474, zz: 0.008627,
                xy: -0.002117, yz: 0.000229, xz: -0.004037,
            },
        },
        joint6: revolute {
            alpha: PI/2,
            mass: 1.666555, com: [0.060149, -0.014117, -0.010517],
            inertia: {
                xx: 0.001964, yy: 0.004354, zz: 0.005433,
                xy: 0.000109, yz: 0.000341, xz: -0.001158,
            },
        },
        joint7: revolute {
            a: 0.088, alpha: PI/2, d: 0.107,
            mass: 0.735522, com: [0.010517, -0.004252, -0.045403],
            inertia: {
                xx: 0.012516, yy: 0.010027, zz: 0.004815,
                xy: -0.000428, yz: -0.000741, xz: -0.001196,
            },
        },
    ],
}

every_function! {
    /// UR5: the ROS-Industrial inertias on Universal Robots' D-H table.
    pub struct Ur5;

    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        pan: revolute {
            d: 0.089159, alpha: PI/2,
            mass: 3.7,
            inertia: { xx: 0.010267495893, yy: 0.00666, zz: 0.010267495893 },
        },
        lift: revolute {
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
