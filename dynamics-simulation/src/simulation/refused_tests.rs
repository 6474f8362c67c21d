//! Programs that the compiler refuses.

/// A law with a memory needs a period:
///
/// ```compile_fail,E0594
/// use robot_dynamics::nalgebra::Vector1;
/// use robot_dynamics::{Simulation, robot_dynamics};
/// robot_dynamics! {
///     struct Cart;
///     convention: modified,
///     gravity: [0, -9.81, 0],
///     joints: [rail: prismatic { mass: 2 }],
/// }
/// let mut calls = 0;
/// Simulation::new(&Cart).torque(|_, q, _| {
///     calls += 1;
///     -q
/// });
/// ```
struct LawWithMemory;

/// A force at the tool needs `forward_kinematics` and `jacobian`:
///
/// ```compile_fail,E0277
/// use robot_dynamics::nalgebra::Vector6;
/// use robot_dynamics::{Simulation, robot_dynamics};
/// robot_dynamics! {
///     struct Cart;
///     convention: modified,
///     gravity: [0, -9.81, 0],
///     joints: [rail: prismatic { mass: 2 }],
///     functions: [default, jacobian],
/// }
///
/// Simulation::new(&Cart).tool_wrench(|_, _, _| Vector6::zeros()).run();
/// ```
struct ArmWithoutTip;

/// A force that is held needs a period:
///
/// ```compile_fail,E0277
/// use robot_dynamics::nalgebra::Vector6;
/// use robot_dynamics::{Simulation, robot_dynamics};
/// robot_dynamics! {
///     struct Cart;
///     convention: modified,
///     gravity: [0, -9.81, 0],
///     joints: [rail: prismatic { mass: 2 }],
///     functions: [default, forward_kinematics, jacobian],
/// }
/// Simulation::new(&Cart).held_tool_wrench(|_, _, _| Vector6::zeros()).run();
/// ```
struct WrenchWithoutPeriod;
