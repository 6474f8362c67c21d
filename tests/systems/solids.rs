//! Inertia tensors of solids: the rectangular solid by integration, the others by their formulas.

use robot_dynamics::nalgebra::Vector1;
use robot_dynamics::robot_dynamics;
use testkit::random::Random;

use crate::assert_near;

robot_dynamics! {
    /// A rectangular solid of sides a, b, c along x, y, z, turning about z.
    struct RectangularSolid { m: f64, a: f64, b: f64, c: f64 }

    convention: modified,
    gravity: [0, 0, 0],
    joints: [turn: revolute { mass: m, inertia: cuboid(a, b, c) }],
    functions: [mass_matrix],
}

robot_dynamics! {
    /// A solid cylinder about its own axis, then about a diameter.
    struct Cylinder { m: f64, r: f64, l: f64 }

    convention: modified,
    gravity: [0, 0, 0],
    joints: [
        turn: revolute {},
        tumble: revolute { alpha: PI/2, mass: m, inertia: cylinder(r, l) },
    ],
    functions: [mass_matrix],
}

robot_dynamics! {
    /// A slender rod and a ball.
    struct RodAndBall { m: f64, l: f64, r: f64 }

    convention: modified,
    gravity: [0, 0, 0],
    joints: [
        rod: revolute { mass: m, inertia: rod(l) },
        ball: revolute { mass: m, inertia: sphere(r) },
    ],
    functions: [mass_matrix],
}

/// The integral of `f` over a rectangular solid about the origin by Gauss-Legendre quadrature
/// with two points for each side, which is exact for polynomials of the third degree.
fn integral([a, b, c]: [f64; 3], f: impl Fn(f64, f64, f64) -> f64) -> f64 {
    let node = 0.5 / 3.0_f64.sqrt();
    let mut sum = 0.0;
    for x in [-a * node, a * node] {
        for y in [-b * node, b * node] {
            for z in [-c * node, c * node] {
                sum += f(x, y, z);
            }
        }
    }
    sum * a * b * c / 8.0
}

/// Ixx = rho abc/12 (b^2 + c^2) and so on (Flores), products of inertia zero.
#[test]
fn the_rectangular_solid_has_the_tensor_of_its_integrals() {
    let mut random = Random::seeded(12);
    for _ in 0..20 {
        let [m, a, b, c] = [(); 4].map(|()| random.between(0.1, 4.0));
        let density = m / (a * b * c);
        let moment = |f: fn(f64, f64, f64) -> f64| density * integral([a, b, c], f);
        let expected = [
            moment(|_, y, z| y * y + z * z),
            moment(|x, _, z| x * x + z * z),
            moment(|x, y, _| x * x + y * y),
        ];
        let solid = RectangularSolid { m, a, b, c };
        let found = solid.table().rows[0].inertia;
        for (found, expected) in found.into_iter().zip(expected) {
            assert_near(found, expected, expected);
        }
        assert_eq!(found[3..], [0.0; 3]);

        let mass_matrix = solid.mass_matrix(&Vector1::new(random.between(-3.0, 3.0)));
        assert_near(mass_matrix[0], expected[2], expected[2]);
    }
}

#[test]
fn the_rectangular_solid_of_the_slides_is_as_printed() {
    let (rho, a, b, c) = (2_700.0, 0.5, 0.2, 0.1);
    let m = rho * a * b * c;
    let printed = rho * a * b * c / 12.0 * (a * a + b * b);
    let found = RectangularSolid { m, a, b, c }.mass_matrix(&Vector1::zeros());
    assert_near(found[0], printed, printed);
}

/// Izz = 1/2 m r^2, Ixx = Iyy = m (3 r^2 + l^2)/12, with the axis along z.
#[test]
fn the_cylinder_has_its_axis_along_z() {
    let (m, r, l) = (3.0, 0.25, 0.8);
    let cylinder = Cylinder { m, r, l };
    let across = m * (3.0 * r * r + l * l) / 12.0;
    let along = m * r * r / 2.0;
    let tensor = cylinder.table().rows[1].inertia;
    for (found, expected) in tensor
        .into_iter()
        .zip([across, across, along, 0.0, 0.0, 0.0])
    {
        assert_near(found, expected, along);
    }
    // The second axis lies across the first, so that one turns the cylinder as a wheel and the
    // other as a baton.
    let mass_matrix = cylinder.mass_matrix(&[0.3, 0.7].into());
    assert_near(mass_matrix[(0, 0)], across, across);
    assert_near(mass_matrix[(1, 1)], along, along);
    assert_eq!(mass_matrix[(0, 1)], 0.0);
}

/// 1/12 m l^2 about y and z and nothing about x; 2/5 m r^2 about every axis.
#[test]
fn the_rod_lies_along_x_and_the_ball_is_round() {
    let (m, l, r) = (1.5, 0.8, 0.1);
    let rows = RodAndBall { m, l, r }.table().rows;
    let rod = m * l * l / 12.0;
    let ball = 0.4 * m * r * r;
    for (found, expected) in rows[0]
        .inertia
        .into_iter()
        .zip([0.0, rod, rod, 0.0, 0.0, 0.0])
    {
        assert_near(found, expected, rod);
    }
    for (found, expected) in rows[1]
        .inertia
        .into_iter()
        .zip([ball, ball, ball, 0.0, 0.0, 0.0])
    {
        assert_near(found, expected, ball);
    }
    let mass_matrix = RodAndBall { m, l, r }.mass_matrix(&[0.1, 0.2].into());
    assert_near(mass_matrix[(0, 0)], rod + ball, rod);
    assert_near(mass_matrix[(1, 1)], ball, ball);
}
