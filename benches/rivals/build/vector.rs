//! Vectors of three expressions.

use symplex::prelude::{Ex, Matrix};

pub(crate) type Vector = [Ex; 3];

pub(crate) fn plus(a: &Vector, b: &Vector) -> Vector {
    std::array::from_fn(|i| &a[i] + &b[i])
}

pub(crate) fn cross(a: &Vector, b: &Vector) -> Vector {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        &(&a[j] * &b[k]) - &(&a[k] * &b[j])
    })
}

pub(crate) fn dot(a: &Vector, b: &Vector) -> Ex {
    &(&(&a[0] * &b[0]) + &(&a[1] * &b[1])) + &(&a[2] * &b[2])
}

/// The rotation of the homogeneous transform `t`, transposed, times `v`.
pub(crate) fn turned_back(t: &Matrix, v: &Vector) -> Vector {
    std::array::from_fn(|i| dot(&std::array::from_fn(|j| t.get(j, i).clone()), v))
}

/// The rotation of the homogeneous transform `t` times `v`.
pub(crate) fn turned(t: &Matrix, v: &Vector) -> Vector {
    std::array::from_fn(|i| dot(&std::array::from_fn(|j| t.get(i, j).clone()), v))
}

pub(crate) fn translation(t: &Matrix) -> Vector {
    std::array::from_fn(|i| t.get(i, 3).clone())
}
