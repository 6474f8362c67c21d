//! The outputs of a function that are measured together.
//!
//! An entry of a matrix may be the small one among entries that are multiplied by like quantities and
//! added: an error that is small beside the largest of these does not matter. Entries of different
//! rows belong to different joints, which may differ by many powers of ten, and are never compared.
//! The three components of a vector in space are.

use crate::function::{Freedoms, Function, Shape, Size, Sizes};
use crate::spatial::AxisMotion;
use std::collections::BTreeMap;

/// For each of `outputs` outputs of a function the number of its group: those of one row of a matrix
/// whose columns have the same unit, or the components of one vector. Behind three
/// lengths and three angles of a base that moves come the joints that move by themselves.
pub fn groups(
    freedoms: Freedoms,
    joints: &[AxisMotion],
    function: Function,
    outputs: usize,
) -> Vec<usize> {
    let of_base = (0..freedoms.base).map(|k| usize::from(k < 3));
    let units = of_base.chain(joints.iter().map(unit)).collect();
    let sizes = function.sizes(freedoms, outputs);
    let mut keys = Vec::with_capacity(outputs);
    Labels { units, sizes }.label(function.shape(), &[0], &mut keys);
    // Pivots and the diagonal of M may follow, each measured by itself.
    keys.extend((keys.len()..outputs).map(|index| vec![1, index]));
    let mut numbers = BTreeMap::new();
    let number = |key| {
        let next = numbers.len();
        *numbers.entry(key).or_insert(next)
    };
    keys.into_iter().map(number).collect()
}

fn unit(joint: &AxisMotion) -> usize {
    match joint {
        AxisMotion::Turns => 0,
        AxisMotion::Slides => 1,
    }
}

struct Labels {
    units: Vec<usize>,
    sizes: Sizes,
}

impl Labels {
    /// Adds a label for each value of a shape, equal for those of one group; all begin with `path`.
    fn label(&self, shape: &Shape, path: &[usize], keys: &mut Vec<Vec<usize>>) {
        let below = |index: usize| [path, &[index]].concat();
        match shape {
            Shape::Number => keys.push(path.to_vec()),
            Shape::Series => keys.extend((0..self.sizes.freedoms.joints).map(below)),
            Shape::Each(count, one) => {
                for index in 0..count.of(self.sizes) {
                    self.label(one, &below(index), keys);
                }
            }
            Shape::Tuple(parts) => {
                for (index, (_, part)) in parts.iter().enumerate() {
                    self.label(part, &below(index), keys);
                }
            }
            Shape::Matrix(rows, columns) => {
                let columns = self.along(*columns);
                for row in self.along(*rows) {
                    let labels = columns.iter().map(|column| match (row, *column) {
                        // The rows of a joint's column in space are components of its vectors.
                        (Along::Space(k), Along::Joint(j, _)) => [k, j],
                        (row, Along::Joint(_, unit)) => [row.number(), unit],
                        (row, column) => [row.number(), column.number()],
                    });
                    keys.extend(labels.map(|label| [path, &label].concat()));
                }
            }
        }
    }

    fn along(&self, size: Size) -> Vec<Along> {
        let numbered = (0..size.of(self.sizes)).map(Along::Other);
        match size {
            Size::One | Size::Parameters => numbered.collect(),
            Size::Fixed(count) => (0..count).map(|k| Along::Space(k / 3)).collect(),
            Size::Joints | Size::Freedoms => {
                let joints = self.units.iter().enumerate();
                joints.map(|(j, &unit)| Along::Joint(j, unit)).collect()
            }
            Size::Pairs => {
                let n = self.units.len();
                let pairs = (0..n).flat_map(|j| (j + 1..n).map(move |k| (j, k)));
                let pair = |(index, (j, k)): (usize, (usize, usize))| {
                    Along::Joint(index, self.units[j] + self.units[k])
                };
                pairs.enumerate().map(pair).collect()
            }
        }
    }
}

/// The owner of a row or a column.
#[derive(Clone, Copy)]
enum Along {
    /// A joint or a pair of joints, and the unit of what the entry is multiplied by.
    Joint(usize, usize),
    /// A direction in space, three of them to a vector: the number of the vector.
    Space(usize),
    Other(usize),
}

impl Along {
    fn number(self) -> usize {
        match self {
            Along::Joint(number, _) | Along::Space(number) | Along::Other(number) => number,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_of_one_row_and_unit_are_measured_together() {
        use AxisMotion::{Slides, Turns};
        let joints = [Turns, Slides, Turns];
        let groups = |function, outputs| super::groups(3.into(), &joints, function, outputs);
        assert_eq!(groups(Function::MassMatrix, 9), [0, 1, 0, 2, 3, 2, 4, 5, 4]);
        let pairs = [0, 1, 0, 2, 3, 2, 4, 5, 4];
        assert_eq!(groups(Function::CoriolisCoefficients, 9), pairs);
        assert_eq!(groups(Function::GravityVector, 3), [0, 1, 2]);
        let pivots = groups(Function::ForwardDynamics, 9);
        assert_eq!(pivots, [0, 1, 2, 3, 4, 5, 6, 7, 8]);
    }

    #[test]
    fn components_of_a_vector_are_measured_together() {
        let joints = [AxisMotion::Turns; 2];
        let jacobian = groups(2.into(), &joints, Function::Jacobian, 12);
        assert_eq!(jacobian, [0, 1, 0, 1, 0, 1, 2, 3, 2, 3, 2, 3]);
        let pose = groups(2.into(), &joints, Function::ForwardKinematics, 16);
        assert_eq!(pose[..8], [0, 0, 0, 1, 0, 0, 0, 1]);
    }
}
