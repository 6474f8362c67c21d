//! Inertia tensors of homogeneous solids.

use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::Value;

use crate::description::{Axis, Solid};

/// The tensor of a solid about its centre of mass: entries xx, yy, zz, xy, yz, xz.
///
/// Meriam and Kraige, Engineering Mechanics: Dynamics, 8th ed., table D/4. With mass m:
///
/// - cuboid with edges x, y, z: `Ixx = m (y^2 + z^2) / 12`, and cyclically;
/// - cylinder of radius r and length h: `m r^2 / 2` about its axis, `m (3 r^2 + h^2) / 12` across it;
/// - slender rod of length l: 0 about its axis, `m l^2 / 12` across it;
/// - sphere of radius r: `Ixx = Iyy = Izz = 2 m r^2 / 5`.
pub(super) fn tensor(solid: Solid, mass: &Value, sizes: &[Value]) -> Option<[Value; 6]> {
    let squares: Vec<Value> = sizes.iter().map(|s| s.clone() * s.clone()).collect();
    let times_mass = |value: Value, numerator: i64, denominator: u64| {
        let factor = Rational::from_parts_signed(numerator.into(), denominator.into());
        mass.clone() * (Value::Rational(factor) * value)
    };
    let [xx, yy, zz] = match (solid, squares.as_slice()) {
        (Solid::Cuboid, [x, y, z]) => [
            times_mass(y.clone() + z.clone(), 1, 12),
            times_mass(x.clone() + z.clone(), 1, 12),
            times_mass(x.clone() + y.clone(), 1, 12),
        ],
        (Solid::Cylinder(axis), [r, h]) => {
            let across = times_mass(Value::integer(3) * r.clone() + h.clone(), 1, 12);
            along(axis, times_mass(r.clone(), 1, 2), across)
        }
        (Solid::Rod(axis), [l]) => along(axis, Value::zero(), times_mass(l.clone(), 1, 12)),
        (Solid::Sphere, [r]) => {
            let moment = times_mass(r.clone(), 2, 5);
            [moment.clone(), moment.clone(), moment]
        }
        _ => return None,
    };
    let zero = Value::zero();
    Some([xx, yy, zz, zero.clone(), zero.clone(), zero])
}

/// The moments of a body that is alike across its axis.
fn along(axis: Axis, about: Value, across: Value) -> [Value; 3] {
    let mut moments = [across.clone(), across.clone(), across];
    moments[axis as usize] = about;
    moments
}

#[cfg(test)]
mod tests {
    use super::*;

    fn diagonal(solid: Solid, mass: i64, sizes: &[i64]) -> [String; 3] {
        let sizes: Vec<Value> = sizes.iter().map(|s| Value::integer(*s)).collect();
        let tensor = tensor(solid, &Value::integer(mass), &sizes).unwrap();
        assert!(tensor[3..].iter().all(Value::is_zero));
        [0, 1, 2].map(|i| tensor[i].as_rational().unwrap().to_string())
    }

    #[test]
    fn solids_have_their_textbook_tensors() {
        assert_eq!(diagonal(Solid::Cuboid, 12, &[1, 2, 3]), ["13", "10", "5"]);
        let cylinder = |axis| diagonal(Solid::Cylinder(axis), 12, &[1, 2]);
        assert_eq!(cylinder(Axis::Z), ["7", "7", "6"]);
        assert_eq!(cylinder(Axis::X), ["6", "7", "7"]);
        let rod = |axis| diagonal(Solid::Rod(axis), 3, &[2]);
        assert_eq!(rod(Axis::X), ["0", "1", "1"]);
        assert_eq!(rod(Axis::Y), ["1", "0", "1"]);
        assert_eq!(rod(Axis::Z), ["1", "1", "0"]);
        assert_eq!(diagonal(Solid::Sphere, 5, &[3]), ["18", "18", "18"]);
    }

    #[test]
    fn a_wrong_number_of_sizes_has_no_tensor() {
        assert!(tensor(Solid::Rod(Axis::X), &Value::integer(1), &[]).is_none());
    }
}
