//! One and two links, as lecture notes and textbooks have them.

every_function! {
    /// A moving mass, m xdd = f (Saha): gravity is perpendicular to its axis.
    pub struct MovingMass;

    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        slider: prismatic { mass: 2 },
    ],
}

every_function! {
    /// A mass that is lifted, m ydd = f - m g (Flores).
    pub struct VerticalMass;

    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        lift: prismatic { mass: 1 },
    ],
}

every_function! {
    /// A link driven through a gear, (r^2 Jm + Jl) thdd + M g l sin th = tau (Flores):
    /// Jl = 0.08 + 1.5 * 0.4^2 = 0.32, r^2 Jm = 0.25.
    pub struct GearedLink;

    convention: standard,
    gravity: [9.81, 0, 0],
    joints: [
        joint: revolute {
            a: 0.8,
            mass: 1.5, com: [-0.4, 0, 0],
            inertia: { xx: 0.02, yy: 0.08, zz: 0.08 },
            motor: { inertia: 0.0001, gear_ratio: 50 },
        },
    ],
}

every_function! {
    /// A slender rod that hangs at th = 0 (Saha): (1/3) m a^2 thdd + (1/2) m g a sin th = tau.
    pub struct OneLink;

    convention: standard,
    gravity: [9.81, 0, 0],
    joints: [
        joint: revolute { a: 1, mass: 1, com: [-0.5, 0, 0], inertia: rod(1) },
    ],
}

every_function_and_tuples! {
    /// Two slender rods, angles from the horizontal (Saha).
    pub struct TwoLinkSaha;

    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        shoulder: revolute { a: 2, mass: 3, com: [-1, 0, 0], inertia: rod(2) },
        elbow: revolute { a: 1, mass: 1, com: [-0.5, 0, 0], inertia: rod(1) },
    ],
}

every_function! {
    /// Two point masses at the ends of massless links (Craig, figure 6.6).
    pub struct TwoLinkCraig;

    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        shoulder: revolute { a: 0.5, mass: 4.6 },
        elbow: revolute { a: 0.3, mass: 2.3 },
    ],
}

every_function! {
    /// A planar arm with three parallel axes and oblique inertia tensors.
    pub struct RrrPlanar;

    convention: standard,
    gravity: [0, -9.81, 0],
    joints: [
        shoulder: revolute {
            a: 0.5,
            mass: 4.6, com: [-0.22, 0.01, 0],
            inertia: { xx: 0.011, yy: 0.12, zz: 0.125, xy: 0.002 },
            friction: { viscous: 0.1, coulomb: 0.2 },
        },
        elbow: revolute {
            a: 0.4,
            mass: 2.3, com: [-0.18, -0.02, 0],
            inertia: { xx: 0.006, yy: 0.041, zz: 0.043, xy: -0.001 },
            friction: { viscous: 0.08, coulomb: 0.1 },
        },
        wrist: revolute {
            a: 0.25,
            mass: 1, com: [-0.1, 0.005, 0],
            inertia: { xx: 0.0015, yy: 0.0072, zz: 0.0078, xy: 0.0003 },
            friction: { viscous: 0.05 },
        },
    ],
}
