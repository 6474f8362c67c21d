//! Where a robot is and how it moves, whatever the number of its joints, and on a base of either kind.

use num_dual::Dual64;
use robot_dynamics::nalgebra::{DVector, Matrix3, SMatrix, SVector, Vector3};
use robot_dynamics::{Pose, Scalar};

/// The pose of a base that moves, and the positions of the joints.
#[derive(Clone)]
pub(super) struct Place<T> {
    pub(super) base: Option<Pose<T>>,
    pub(super) q: DVector<T>,
}

/// Velocities and accelerations begin with the six of a base that moves, in its own axes.
#[derive(Clone)]
pub(super) struct State {
    pub(super) q: Place<f64>,
    pub(super) qd: DVector<f64>,
    pub(super) qdd: DVector<f64>,
}

/// Numbers that functions read.
pub(super) trait Argument<T> {
    /// The numbers of the joints, as many as there are.
    fn sized<const N: usize>(&self) -> SVector<T, N>;

    /// All of them, by the names that they have among the arguments of a function.
    fn name<'a>(&self, name: &'a str, named: &mut Vec<(&'a str, Vec<T>)>);
}

impl<T: Scalar> Argument<T> for DVector<T> {
    fn sized<const N: usize>(&self) -> SVector<T, N> {
        SVector::from_column_slice(self.as_slice())
    }

    fn name<'a>(&self, name: &'a str, named: &mut Vec<(&'a str, Vec<T>)>) {
        named.push((name, self.as_slice().to_vec()));
    }
}

impl<T: Scalar> Argument<T> for Place<T> {
    fn sized<const N: usize>(&self) -> SVector<T, N> {
        self.q.sized()
    }

    fn name<'a>(&self, name: &'a str, named: &mut Vec<(&'a str, Vec<T>)>) {
        self.q.name(name, named);
        if let Some(base) = self.base {
            named.push(("base", base.entries().as_slice().to_vec()));
        }
    }
}

impl<T: Scalar> Place<T> {
    /// The same numbers in another arithmetic.
    pub(super) fn map<U: Scalar>(&self, f: impl Fn(T) -> U) -> Place<U> {
        Place {
            base: self.base.map(|base| Pose {
                rotation: base.rotation.map(&f),
                position: base.position.map(&f),
            }),
            q: self.q.map(&f),
        }
    }

    /// All positions of the joints replaced by this.
    pub(super) fn at_joints(&self, q: T) -> Self {
        let q = self.q.map(|_| q);
        Place { q, ..self.clone() }
    }
}

impl Place<f64> {
    /// The place displaced by so much along each degree of freedom, to second order: a base by R d, and turned by
    /// R exp(phi), exp(phi) = 1 + X + X^2/2 with X = [phi x].
    pub(super) fn displaced<T: Scalar>(&self, by: &DVector<T>) -> Place<T> {
        let Place { base, q } = self.map(T::from_f64);
        let Some(Pose { rotation, position }) = base else {
            return Place {
                base,
                q: q.zip_map(by, |q, by| q + by),
            };
        };
        let [d, phi] = [0, 3].map(|first| Vector3::from_fn(|i, _| by[first + i]));
        let zero = T::from_f64(0.0);
        let x = Matrix3::new(
            zero, -phi.z, phi.y, //
            phi.z, zero, -phi.x, //
            -phi.y, phi.x, zero,
        );
        let half = T::from_f64(0.5);
        let turn = x.zip_map(&product(&x, &x), |first, second| first + half * second);
        let (turned, moved) = (product(&rotation, &turn), product(&rotation, &d));
        let base = Pose {
            rotation: rotation.zip_map(&turned, |r, by| r + by),
            position: position.zip_map(&moved, |p, by| p + by),
        };
        let q = DVector::from_fn(q.len(), |i, _| q[i] + by[6 + i]);
        Place {
            base: Some(base),
            q,
        }
    }
}

/// In any arithmetic.
fn product<T: Scalar, const C: usize>(a: &Matrix3<T>, b: &SMatrix<T, 3, C>) -> SMatrix<T, 3, C> {
    let entry = |i, j| a[(i, 0)] * b[(0, j)] + a[(i, 1)] * b[(1, j)] + a[(i, 2)] * b[(2, j)];
    SMatrix::from_fn(entry)
}

/// A motion at `direction`: values there carry their derivatives that way.
pub(super) trait Along {
    type Dual;

    fn along(&self, direction: &DVector<f64>) -> Self::Dual;

    /// At rest.
    fn still(&self) -> Self::Dual;
}

impl Along for DVector<f64> {
    type Dual = DVector<Dual64>;

    fn along(&self, direction: &DVector<f64>) -> DVector<Dual64> {
        self.zip_map(direction, Dual64::new)
    }

    fn still(&self) -> DVector<Dual64> {
        self.map(Dual64::from)
    }
}

impl Along for Place<f64> {
    type Dual = Place<Dual64>;

    fn along(&self, direction: &DVector<f64>) -> Place<Dual64> {
        self.displaced(&direction.map(|x| Dual64::new(0.0, x)))
    }

    fn still(&self) -> Place<Dual64> {
        self.map(Dual64::from)
    }
}
