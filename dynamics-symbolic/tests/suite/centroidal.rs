//! The momentum of arms on a standing base about their centre of mass.

use dynamics_symbolic::Function;
use dynamics_symbolic::prove::{Assignment, Definition, Number};
use dynamics_symbolic::robot::Interpretation;

/// Its linear part is the motion of the centre of mass.
#[test]
fn linear_momentum_is_that_of_the_center_of_mass() {
    for name in arms::NAMES.into_iter().chain([arms::MOUNTED]) {
        let robot = arms::robot(name);
        let point = &mut Assignment::new(&robot, 5);
        let definition = Definition::new(point, &robot);
        let of = |function: Function| definition.expected(function, &[]);
        let Some(by_center) = of(Function::CenterOfMassJacobian) else {
            assert_eq!(of(Function::CentroidalMomentumMatrix), None, "{name}");
            continue;
        };
        let tool = robot.tool.iter().map(|tool| &tool.body.mass);
        let masses = robot.rows.iter().map(|row| &row.mass).chain(tool);
        let mass = masses.fold(Number::ZERO, |sum, mass| sum + point.value(mass));
        let by_center: Vec<_> = by_center.into_iter().map(|x| x * mass).collect();
        let matrix = of(Function::CentroidalMomentumMatrix).expect("defined");
        assert_eq!(matrix[..by_center.len()], by_center, "{name}");
    }
}
