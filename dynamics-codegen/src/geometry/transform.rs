//! Places of frames in one another, and bodies that are moved between them.

use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::Value;

use super::number::{bounded, sin_cos, tidy};

/// Three components.
pub type Vector = [Rational; 3];
/// Rows of a matrix.
pub type Matrix = [Vector; 3];

/// A frame in another one.
#[derive(Clone, Debug)]
pub struct Transform {
    /// Its axes, the columns, in those of the other frame.
    pub rotation: Matrix,
    /// Its origin in the other frame, m.
    pub origin: Vector,
}

impl Transform {
    /// The frame itself.
    pub fn identity() -> Transform {
        Transform {
            rotation: identity(),
            origin: [Rational::ZERO; 3],
        }
    }

    /// T(xyz) Rz(yaw) Ry(pitch) Rx(roll); none where an angle is no number.
    pub fn new(xyz: &Vector, rpy: &[Value; 3]) -> Option<Transform> {
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
    pub fn then(&self, next: &Transform) -> Transform {
        Transform {
            rotation: product(&self.rotation, &next.rotation).map(|row| row.map(bounded)),
            origin: self.point(&next.origin).map(bounded),
        }
    }

    /// The outer frame in this one.
    pub fn inverse(&self) -> Transform {
        let rotation = transpose(&self.rotation);
        let origin = apply(&rotation, &self.origin).map(|x| -x);
        Transform { rotation, origin }
    }

    /// The frame with long numbers rounded to fifty digits.
    pub fn tidy(self) -> Transform {
        Transform {
            rotation: self.rotation.map(|row| row.map(tidy)),
            origin: self.origin.map(tidy),
        }
    }

    /// The axis of that index, x, y or z.
    pub fn axis(&self, index: usize) -> Vector {
        self.rotation.each_ref().map(|row| row[index].clone())
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

/// The scalar product.
pub fn dot(a: &Vector, b: &Vector) -> Rational {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

/// The vector product.
pub fn cross(a: &Vector, b: &Vector) -> Vector {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &a[i] * &b[j] - &a[j] * &b[i])
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
pub struct Mass {
    mass: Rational,
    moment: Vector,
    inertia: Matrix,
}

/// A body: mass, centre of mass, inertia tensor about that in the frame's axes.
pub struct Body {
    /// Mass, kg.
    pub mass: Rational,
    /// Centre of mass, m.
    pub com: Vector,
    /// xx, yy, zz, xy, yz, xz, kg m^2.
    pub inertia: [Rational; 6],
}

impl Mass {
    /// No body.
    pub fn none() -> Mass {
        Mass {
            mass: Rational::ZERO,
            moment: [Rational::ZERO; 3],
            inertia: [(); 3].map(|()| [Rational::ZERO; 3]),
        }
    }

    /// A body whose centre of mass is the origin of a frame, with the tensor in its axes.
    pub fn new(mass: &Rational, tensor: &[Rational; 6], frame: &Transform) -> Mass {
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

    /// The body, given in `frame`, in the frame in which that one is placed.
    pub fn seen_from(&self, frame: &Transform) -> Mass {
        let body = self.body();
        let center = Transform {
            origin: body.com.clone(),
            ..Transform::identity()
        };
        Mass::new(&body.mass, &body.inertia, &frame.then(&center))
    }

    /// Puts another body beside this one.
    pub fn add(&mut self, other: &Mass) {
        self.mass = bounded(&self.mass + &other.mass);
        for (x, y) in self.moment.iter_mut().zip(&other.moment) {
            *x = bounded(&*x + y);
        }
        self.inertia = sum(&self.inertia, &other.inertia).map(|row| row.map(bounded));
    }

    /// As a body: J - m (c.c 1 - c c') about the centre of mass.
    pub fn body(&self) -> Body {
        let com = if self.mass.is_zero() {
            [Rational::ZERO; 3]
        } else {
            self.moment.each_ref().map(|h| h / &self.mass)
        };
        let steiner = steiner(&self.moment, &com);
        let entry = |i: usize, j: usize| &self.inertia[i][j] - &steiner[i][j];
        Body {
            mass: self.mass.clone(),
            inertia: [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (0, 2)]
                .map(|(i, j)| bounded(entry(i, j))),
            com: com.map(bounded),
        }
    }
}

/// h.c 1 - h c'
fn steiner(h: &Vector, c: &Vector) -> Matrix {
    let trace = dot(h, c);
    let entry = |i: usize, j: usize| {
        if i == j {
            &trace - &h[i] * &c[j]
        } else {
            -(&h[i] * &c[j])
        }
    };
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| entry(i, j)))
}

fn sum(a: &Matrix, b: &Matrix) -> Matrix {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| &a[i][j] + &b[i][j]))
}

#[cfg(test)]
mod tests {
    use dynamics_symbolic::exact::{MOST_BITS, bit_length};

    use super::*;

    /// Sixty links that are fixed to each other: with exact products the last place would have 20,000 bits.
    #[test]
    fn frames_in_each_other_stay_short() {
        let decimal = |hundredths: i64| Rational::from(hundredths) / Rational::from(100);
        let angles = [30, 50, 70].map(|angle| Value::Rational(decimal(angle)));
        let frame = Transform::new(&[1, 2, 3].map(decimal), &angles).unwrap();
        let (mut place, mut mass) = (Transform::identity(), Mass::none());
        for _ in 0..60 {
            place = place.then(&frame);
            let tensor = [4, 5, 6, 0, 0, 0].map(decimal);
            mass.add(&Mass::new(&decimal(70), &tensor, &place));
            mass = mass.seen_from(&frame);
        }
        let Transform { rotation, origin } = &place;
        let body = mass.body();
        let numbers = rotation.iter().flatten().chain(origin);
        let mut numbers = numbers.chain(&body.com).chain(&body.inertia);
        assert!(numbers.all(|x| bit_length(x) <= MOST_BITS));
        let length = dot(&rotation[0], &rotation[0]) - Rational::ONE;
        assert!(length.to_f64().value().abs() < 1e-45);
    }
}
