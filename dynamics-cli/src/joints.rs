//! Arms of so many joints, of which the compiler must know the number, and their positions.

use std::f64::consts::TAU;
use std::io::Write as _;

use dynamics_symbolic::robot::{JointType, Robot};

use crate::failure::Failure;

/// The most joints of arms that are compared with Newton-Euler and simulated, which the compiler compiles for
/// each number apart.
const MOST: usize = 32;

/// The stack of a thread in which functions have whole arms of that many joints in their variables.
const STACK: usize = 512 << 20;

/// The value of an expression for arms of `$dof` joints, whose number `$n` stands for.
macro_rules! with_joints {
    ($dof:expr, $n:ident => $value:expr) => {
        with_joints!(@ $dof, $n => $value;
            1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30 31 32)
    };
    (@ $dof:expr, $n:ident => $value:expr; $($joints:literal)*) => {
        match $dof {
            $($joints => {
                const $n: usize = $joints;
                $crate::joints::with_stack(|| $value)
            })*
            dof => Err($crate::joints::too_many(dof)),
        }
    };
}
pub(crate) use with_joints;

/// Calls a function that needs a large stack.
pub(crate) fn with_stack<T: Send>(
    call: impl FnOnce() -> Result<T, Failure> + Send,
) -> Result<T, Failure> {
    std::thread::scope(|scope| {
        let thread = std::thread::Builder::new().stack_size(STACK);
        let thread = thread.spawn_scoped(scope, call)?;
        match thread.join() {
            Ok(result) => result,
            Err(panic) => std::panic::resume_unwind(panic),
        }
    })
}

/// There are more joints than that.
pub(crate) fn too_many(dof: usize) -> Failure {
    let message = format!(
        "{dof} joints move: expected {MOST} at most, lock others by `--lock JOINT=POSITION`"
    );
    Failure::after(String::new(), message)
}

/// From so many turns on, an angle was perhaps meant in degrees.
const TURNS: f64 = 2.0;

/// Remarks on the first angle that was perhaps meant in degrees; whether there is one.
pub(crate) fn note_degrees(source: &str, robot: &Robot, positions: &[f64]) -> bool {
    let mut joints = robot.joints().zip(positions);
    let many_turns = joints.find(|(row, position)| {
        row.joint_type == JointType::Revolute && position.abs() > TURNS * TAU
    });
    if let Some((row, position)) = many_turns {
        // What cannot be said is no failure.
        let _ = writeln!(
            std::io::stderr(),
            "`{source}`: {position} rad of `{}` are {:.1} turns: angles are in radians, and {position} degrees are {:.4}",
            row.name,
            position.abs() / TAU,
            position.to_radians()
        );
    }
    many_turns.is_some()
}
