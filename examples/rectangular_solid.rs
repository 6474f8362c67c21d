//! Inertia tensors: the rectangular solid by its integral, the sign of the products of inertia,
//! the other solids, and the tensor in base axes.
//!
//! After Flores's slides *Dynamics*.
//!
//! ```text
//! cargo run --example rectangular_solid
//! ```

mod compare;

use robot_dynamics::{
    nalgebra::{Matrix3, Rotation3, Vector3},
    robot_dynamics,
};

robot_dynamics! {
    /// A rectangular solid on a gimbal: three revolute joints whose axes meet in its centre.
    struct Brick { m: f64, a: f64, b: f64, c: f64 }

    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        roll:  revolute { alpha: PI/2 },
        pitch: revolute { alpha: PI/2 },
        yaw:   revolute { mass: m, inertia: cuboid(a, b, c) },
    ],
    functions: [kinetic_energy, forward_kinematics, jacobian],
}

robot_dynamics! {
    /// One joint for each of the other solids.
    struct Solids { m: f64, radius: f64, length: f64 }

    convention: standard,
    gravity: [0, 0, -9.81],
    joints: [
        cylinder: revolute { mass: m, inertia: cylinder(radius, length) },
        rod:      revolute { mass: m, inertia: rod(length) },
        sphere:   revolute { mass: m, inertia: sphere(radius) },
    ],
    functions: [mass_matrix],
}

const BRICK: Brick = Brick {
    m: 2.4,
    a: 0.3,
    b: 0.2,
    c: 0.1,
};

fn main() {
    by_its_integral();
    sign_of_the_products();
    other_solids();
    kinetic_energy();
}

/// The table's entries beside rho a b c/12 (b^2 + c^2) and so on, and beside the integral itself.
fn by_its_integral() {
    let Brick { m, a, b, c } = BRICK;
    let [xx, yy, zz, xy, yz, xz] = BRICK.table().rows[2].inertia;
    compare::heading("Rectangular solid, m = 2.4, 0.3 x 0.2 x 0.1: m = rho a b c");
    compare::row("Ixx = m (b^2 + c^2)/12", xx, m / 12.0 * (b * b + c * c));
    compare::row("Iyy = m (a^2 + c^2)/12", yy, m / 12.0 * (a * a + c * c));
    compare::row("Izz = m (a^2 + b^2)/12", zz, m / 12.0 * (a * a + b * b));

    let integral = tensor(gauss_points());
    compare::row("Ixx = integral of rho (y^2 + z^2)", xx, integral[(0, 0)]);
    compare::row("Iyy = integral of rho (x^2 + z^2)", yy, integral[(1, 1)]);
    compare::row("Izz = integral of rho (x^2 + y^2)", zz, integral[(2, 2)]);
    for (name, product) in [("Ixy = 0", xy), ("Iyz = 0", yz), ("Ixz = 0", xz)] {
        compare::row(name, product, 0.0);
    }
}

/// The solid turned by 30 degrees about z: its tensor R I R' has an entry xy, and that entry is
/// *minus* the integral of rho x y.
fn sign_of_the_products() {
    let turn = Rotation3::from_axis_angle(&Vector3::z_axis(), 30_f64.to_radians());
    let turned: Vec<Vector3<f64>> = gauss_points().map(|p| turn * p).collect();
    let product: f64 = turned.iter().map(|p| BRICK.m / 8.0 * p.x * p.y).sum();
    let similarity = turn.matrix() * tensor(gauss_points()) * turn.matrix().transpose();

    println!("\n  turned by 30 degrees about z, the integral of rho x y is {product:+.9}");
    compare::row(
        "entry xy of R I R' = -integral of rho x y",
        similarity[(0, 1)],
        -product,
    );
    compare::row(
        "entry xy of the turned solid's tensor",
        similarity[(0, 1)],
        tensor(turned)[(0, 1)],
    );
}

fn other_solids() {
    let solids = Solids {
        m: 2.4,
        radius: 0.1,
        length: 0.5,
    };
    let Solids { m, radius, length } = solids;
    let [cylinder, rod, sphere] = solids.table().rows.map(|row| row.inertia);
    compare::heading("The other solids, m = 2.4, radius 0.1, length 0.5");
    let across = m * (3.0 * radius * radius + length * length) / 12.0;
    compare::row("cylinder: Ixx = m (3 r^2 + l^2)/12", cylinder[0], across);
    compare::row(
        "cylinder: Izz = m r^2/2",
        cylinder[2],
        m * radius * radius / 2.0,
    );
    compare::row("rod: Ixx = 0", rod[0], 0.0);
    compare::row("rod: Izz = m l^2/12", rod[2], m * length * length / 12.0);
    compare::row(
        "sphere: Ixx = 2 m r^2/5",
        sphere[0],
        0.4 * m * radius * radius,
    );
}

/// K = 1/2 w' (R I R') w, with the angular velocity w in base axes from the Jacobian: the tensor in
/// base axes turns with the body.
fn kinetic_energy() {
    let (q, qd) = (Vector3::new(0.3, -0.8, 1.2), Vector3::new(1.0, -2.0, 0.5));
    let rotation: Matrix3<f64> = BRICK.forward_kinematics(&q).fixed_view::<3, 3>(0, 0).into();
    let omega: Vector3<f64> = BRICK.jacobian(&q).fixed_rows::<3>(3) * qd;
    let in_base_axes = rotation * tensor(gauss_points()) * rotation.transpose();
    compare::heading("The solid turning about its centre");
    compare::row(
        "K = 1/2 w' (R I R') w",
        BRICK.kinetic_energy(&q, &qd),
        0.5 * omega.dot(&(in_base_axes * omega)),
    );
}

/// The eight points of Gauss's rule, at +-1/sqrt(3) of each half edge. It integrates cubic
/// polynomials exactly, so eight masses of m/8 have the same tensor as the solid.
fn gauss_points() -> impl Iterator<Item = Vector3<f64>> {
    let node = Vector3::new(BRICK.a, BRICK.b, BRICK.c) / 12_f64.sqrt();
    let side = |bit: usize, corner: usize| if corner >> bit & 1 == 0 { -1.0 } else { 1.0 };
    (0..8).map(move |k| node.component_mul(&Vector3::new(side(0, k), side(1, k), side(2, k))))
}

/// Inertia tensor of eight masses of m/8: the sum of m/8 (p'p 1 - p p').
fn tensor(points: impl IntoIterator<Item = Vector3<f64>>) -> Matrix3<f64> {
    points
        .into_iter()
        .map(|p| BRICK.m / 8.0 * (Matrix3::identity() * p.norm_squared() - p * p.transpose()))
        .sum()
}
