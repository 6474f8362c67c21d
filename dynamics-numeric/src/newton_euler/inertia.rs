//! The mass properties of a body, about the origin of its frame.

use core::ops::Add;

use dynamics_runtime::Row;
use dynamics_runtime::internal::geometry::{Joint, Pose, cross, dot, sum, tensor, times};
use nalgebra::{Matrix3, Vector3};

/// Integrals over a body's mass, in some frame, about its origin.
///
/// They add up: the inertia of several bodies is the sum of theirs.
#[derive(Clone, Copy, Debug)]
pub(super) struct Inertia {
    /// m = int dm.
    pub(super) mass: f64,
    /// h = int r dm, the mass times the centre of mass.
    pub(super) first_moment: Vector3<f64>,
    /// S = int r r^T dm, of which the inertia tensor is `J = tr(S) 1 - S`.
    pub(super) second_moment: Matrix3<f64>,
}

impl Inertia {
    /// No mass.
    pub(super) const ZERO: Inertia = Inertia {
        mass: 0.0,
        first_moment: Vector3::new(0.0, 0.0, 0.0),
        second_moment: Matrix3::new(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
    };

    /// The integrals of a body with its inertia tensor about the centre of mass: `S = tr(I)/2 1 - I + m c c^T`.
    pub(super) fn new(mass: f64, com: &Vector3<f64>, tensor: &Matrix3<f64>) -> Self {
        let about_com = Matrix3::from_diagonal_element(0.5 * tensor.trace()) - tensor;
        Inertia {
            mass,
            first_moment: com * mass,
            second_moment: about_com + com * com.transpose() * mass,
        }
    }

    /// The inertia of frame i in frame i-1, about that frame's origin p:
    /// `h' = R h + m p`, `S' = R S R^T + p (R h)^T + (R h) p^T + m p p^T`.
    #[inline(always)]
    pub(super) fn inward(&self, joint: &Joint) -> Self {
        let (m, p) = (self.mass, &joint.origin);
        let turned = joint.inward(&self.first_moment);
        let half = turned + p * (0.5 * m);
        let s = joint.tensor_inward(&self.second_moment);
        let shifted = |i: usize, j: usize| s[(i, j)] + sum(p[i], half[j], half[i], p[j]);
        let (xx, yy, zz) = (shifted(0, 0), shifted(1, 1), shifted(2, 2));
        let (xy, yz, xz) = (shifted(0, 1), shifted(1, 2), shifted(0, 2));
        Inertia {
            mass: m,
            first_moment: turned + p * m,
            second_moment: Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz),
        }
    }

    /// Force and moment (about the origin) that give the points r of the body the accelerations
    /// `a + U r`: `f = m a + U h` and `n = int r x (a + U r) dm = h x a + int r x U r dm`.
    ///
    /// With B = U S the last integral is (B_zy - B_yz, B_xz - B_zx, B_yx - B_xy) (Balafoutis,
    /// Patel and Misra 1988): 18 products, where `J wd + w x J w` takes 24.
    #[inline(always)]
    pub(super) fn wrench(&self, acceleration: &Vector3<f64>, u: &Matrix3<f64>) -> Wrench {
        let (h, s) = (&self.first_moment, &self.second_moment);
        let row = |i: usize| [u[(i, 0)], u[(i, 1)], u[(i, 2)]];
        let b = |i: usize, j: usize| dot(row(i), [s[(0, j)], s[(1, j)], s[(2, j)]]);
        let turning = Vector3::new(b(2, 1) - b(1, 2), b(0, 2) - b(2, 0), b(1, 0) - b(0, 1));
        Wrench {
            force: times(u, h, &(acceleration * self.mass)),
            moment: cross(h, acceleration, &turning),
        }
    }
}

/// A force and a moment about the frame's origin.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wrench {
    pub(super) force: Vector3<f64>,
    pub(super) moment: Vector3<f64>,
}

impl Wrench {
    pub(super) const ZERO: Wrench = Wrench {
        force: Vector3::new(0.0, 0.0, 0.0),
        moment: Vector3::new(0.0, 0.0, 0.0),
    };

    /// The force, then the moment.
    pub(super) fn entries(&self) -> [f64; 6] {
        let (f, n) = (&self.force, &self.moment);
        [f.x, f.y, f.z, n.x, n.y, n.z]
    }
}

impl Add for Wrench {
    type Output = Wrench;

    #[inline(always)]
    fn add(self, other: Wrench) -> Wrench {
        Wrench {
            force: self.force + other.force,
            moment: self.moment + other.moment,
        }
    }
}

impl Add for Inertia {
    type Output = Inertia;

    #[inline(always)]
    fn add(self, other: Inertia) -> Inertia {
        Inertia {
            mass: self.mass + other.mass,
            first_moment: self.first_moment + other.first_moment,
            second_moment: self.second_moment + other.second_moment,
        }
    }
}

/// A rigid body in some frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct Solid {
    pub(super) mass: f64,
    pub(super) com: Vector3<f64>,
    /// About the centre of mass.
    pub(super) tensor: Matrix3<f64>,
    /// All three about the frame's origin.
    pub(super) inertia: Inertia,
}

impl Solid {
    /// No mass.
    pub(super) const NONE: Solid = Solid {
        mass: 0.0,
        com: Inertia::ZERO.first_moment,
        tensor: Inertia::ZERO.second_moment,
        inertia: Inertia::ZERO,
    };

    /// The body of a row whose frame is at a place: c' = p + R c, I' = R I R^T.
    pub(super) fn new(row: &Row, Pose { rotation, position }: &Pose) -> Self {
        let com = position + rotation * Vector3::from(row.com);
        let tensor = rotation * tensor(row) * rotation.transpose();
        Solid {
            mass: row.mass,
            com,
            tensor,
            inertia: Inertia::new(row.mass, &com, &tensor),
        }
    }
}
