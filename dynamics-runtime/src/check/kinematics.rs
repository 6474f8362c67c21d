//! Differences of poses and Jacobians: directions are of size 1.

use nalgebra::{Matrix4, SMatrix, Vector6};

use super::deviation::Entry;
use crate::{JointType, Table};

/// Entries of a transform's difference: those of the rotation are of size 1.
pub(super) fn pose_entries(
    joint: Option<usize>,
    difference: Matrix4<f64>,
    position: f64,
) -> impl Iterator<Item = Entry> {
    (0..4).flat_map(move |row| {
        (0..4).map(move |column| Entry {
            joint,
            difference: difference[(row, column)],
            scale: if row < 3 && column == 3 {
                position
            } else {
                1.0
            },
        })
    })
}

/// Entries of a Jacobian's difference: axes are of size 1, velocities of revolute joints as large
/// as the distance from their axis.
pub(super) fn jacobian_entries<const N: usize>(
    table: &Table<N>,
    difference: &SMatrix<f64, 6, N>,
    position: f64,
) -> impl Iterator<Item = Entry> {
    (0..N).flat_map(move |joint| {
        let revolute = table.rows[joint].joint_type == JointType::Revolute;
        (0..6).map(move |row| Entry {
            joint: Some(joint),
            difference: difference[(row, joint)],
            scale: if row < 3 && revolute { position } else { 1.0 },
        })
    })
}

/// Entries of a matrix of which no row or column belongs to a joint.
pub(super) fn in_space<const R: usize, const C: usize>(
    difference: SMatrix<f64, R, C>,
    scale: f64,
) -> impl Iterator<Item = Entry> {
    let places = (0..R).flat_map(|row| (0..C).map(move |column| (row, column)));
    places.map(move |place| Entry {
        joint: None,
        difference: difference[place],
        scale,
    })
}

/// Entries of a motion of the tip for joints that move by so much: its linear part is as large as the
/// distance from the base besides, and as what a prismatic joint moves itself.
pub(super) fn tip_entries(
    difference: Vector6<f64>,
    size: f64,
    position: f64,
) -> impl Iterator<Item = Entry> {
    let linear = size * position.max(1.0);
    (0..6).map(move |row| Entry {
        joint: None,
        difference: difference[row],
        scale: if row < 3 { linear } else { size },
    })
}
