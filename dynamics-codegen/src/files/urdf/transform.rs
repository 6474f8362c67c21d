//! Places of frames in one another, and bodies that are moved between them.

use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::Value;

use super::number::sin_cos;

pub(super) type Vector = [Rational; 3];
pub(super) type Matrix = [Vector; 3];

/// A frame in another one.
#[derive(Clone, Debug)]
pub(super) struct Transform {
    rotation: Matrix,
    origin: Vector,
}

impl Transform {
    pub(super) fn identity() -> Transform {
        Transform {
            rotation: identity(),
            origin: [Rational::ZERO; 3],
        }
    }

    /// T(xyz) Rz(yaw) Ry(pitch) Rx(roll); none where an angle is no number.
    pub(super) fn new(xyz: &Vector, rpy: &[Value; 3]) -> Option<Transform> {
        let mut rotation = identity();
        for axis in [2, 1, 0] {
            rotation = product(&rotation, &turn(axis, &rpy[axis])?);
        }
        Some(Transform {
            rotation,
            origin: xyz.clone(),
        })
    }

    /// The frame that `next` is in this one.
    pub(super) fn then(&self, next: &Transform) -> Transform {
        Transform {
            rotation: product(&self.rotation, &next.rotation),
            origin: self.point(&next.origin),
        }
    }

    /// A point of this frame in the outer one.
    fn point(&self, p: &Vector) -> Vector {
        let turned = apply(&self.rotation, p);
        [0, 1, 2].map(|k| &turned[k] + &self.origin[k])
    }
}

fn identity() -> Matrix {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| Rational::from(u8::from(i == j))))
}

fn dot(a: &Vector, b: &Vector) -> Rational {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

fn apply(m: &Matrix, v: &Vector) -> Vector {
    m.each_ref().map(|row| dot(row, v))
}

fn transpose(m: &Matrix) -> Matrix {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| m[j][i].clone()))
}

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    let columns = transpose(b);
    a.each_ref()
        .map(|row| columns.each_ref().map(|column| dot(row, column)))
}

/// The turn about the axis of that index.
fn turn(axis: usize, by: &Value) -> Option<Matrix> {
    let [s, c] = sin_cos(by)?;
    let mut m = identity();
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    m[i][i] = c.clone();
    m[j][j] = c;
    m[i][j] = -s.clone();
    m[j][i] = s;
    Some(m)
}

/// Mass, first moments and inertia about the origin of a frame, xx, yy, zz, xy, yz, xz.
#[derive(Clone, Debug)]
pub(super) struct Mass {
    mass: Rational,
    moment: Vector,
    inertia: Matrix,
}

/// A body: mass, centre of mass, inertia tensor about that in the frame's axes.
pub(super) struct Body {
    pub(super) mass: Rational,
    pub(super) com: Vector,
    pub(super) inertia: [Rational; 6],
}

impl Mass {
    pub(super) fn none() -> Mass {
        Mass {
            mass: Rational::ZERO,
            moment: [Rational::ZERO; 3],
            inertia: [(); 3].map(|()| [Rational::ZERO; 3]),
        }
    }

    /// A body whose centre of mass is the origin of a frame, with the tensor in its axes.
    pub(super) fn new(mass: &Rational, tensor: &[Rational; 6], frame: &Transform) -> Mass {
        let [xx, yy, zz, xy, yz, xz] = tensor;
        let tensor = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]].map(|row| row.map(Rational::clone));
        let r = &frame.rotation;
        let turned = product(&product(r, &tensor), &transpose(r));
        let moment = frame.origin.each_ref().map(|x| mass * x);
        let steiner = steiner(&moment, &frame.origin);
        Mass {
            mass: mass.clone(),
            moment,
            inertia: sum(&turned, &steiner),
        }
    }

    pub(super) fn add(&mut self, other: &Mass) {
        self.mass += &other.mass;
        for (x, y) in self.moment.iter_mut().zip(&other.moment) {
            *x += y;
        }
        self.inertia = sum(&self.inertia, &other.inertia);
    }

    /// As a body: J - m (c.c 1 - c c') about the centre of mass.
    pub(super) fn body(&self) -> Body {
        let com = match self.mass.is_zero() {
            true => [Rational::ZERO; 3],
            false => self.moment.each_ref().map(|h| h / &self.mass),
        };
        let steiner = steiner(&self.moment, &com);
        let entry = |i: usize, j: usize| &self.inertia[i][j] - &steiner[i][j];
        Body {
            mass: self.mass.clone(),
            inertia: [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2)].map(|(i, j)| entry(i, j)),
            com,
        }
    }
}

/// h.c 1 - h c'
fn steiner(h: &Vector, c: &Vector) -> Matrix {
    let trace = dot(h, c);
    let entry = |i: usize, j: usize| match i == j {
        true => &trace - &h[i] * &c[j],
        false => -(&h[i] * &c[j]),
    };
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| entry(i, j)))
}

fn sum(a: &Matrix, b: &Matrix) -> Matrix {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| &a[i][j] + &b[i][j]))
}
