//! A frame of a robot at run time, as numeric inverse kinematics and forces of the surroundings take it.

use dynamics_numeric::inverse_kinematics::SizedTable;
use dynamics_runtime::SizedKinematics;
use dynamics_runtime::nalgebra::{DVector, Dyn, Matrix4, Matrix6xX};
use dynamics_runtime::table::RuntimeTable;
use dynamics_simulation::simulation::Place;
use dynamics_symbolic::Function;

use crate::compiled::Compiled;
use crate::{EvaluationError, RuntimeRobot};

/// The tip of a [`RuntimeRobot`], or one of its frames: what
/// [`InverseKinematics`](dynamics_numeric::InverseKinematics) needs of it, and a force at it in a
/// [`Simulation`](dynamics_simulation::Simulation). Vectors are `DVector<f64>`. Inverse kinematics takes a base that moves to stand in
/// the frame of the world.
#[derive(Clone, Debug)]
pub struct RuntimePlace<'a> {
    arm: &'a RuntimeRobot,
    table: RuntimeTable,
    pose: &'a Compiled,
    jacobian: &'a Compiled,
}

/// The functions that find a place: its pose, and its Jacobian.
const OF_A_PLACE: [Function; 2] = [Function::ForwardKinematics, Function::Jacobian];

impl RuntimeRobot {
    /// The names of the functions that [`place`](RuntimeRobot::place) needs: `forward_kinematics` and `jacobian` of the tip, or
    /// those of a frame, such as `jacobian(hand)`.
    pub fn place_functions(frame: Option<&str>) -> [String; 2] {
        let of_frame = frame.map_or_else(String::new, |frame| format!("({frame})"));
        OF_A_PLACE.map(|function| format!("{}{of_frame}", function.name()))
    }

    /// The names of these functions as methods: `jacobian_hand`.
    #[doc(hidden)]
    pub fn place_methods(frame: Option<&str>) -> [String; 2] {
        OF_A_PLACE.map(|function| match frame {
            None => function.name().to_owned(),
            Some(frame) => function.name_of_frame(frame),
        })
    }

    /// The tip, or the frame of that name, whose joint positions are to be found.
    ///
    /// ```
    /// # mod robot_dynamics {
    /// # pub use dynamics_numeric::*;
    /// # pub use dynamics_runtime::nalgebra;
    /// # pub use dynamics_evaluation as evaluation;
    /// # }
    /// use robot_dynamics::InverseKinematics;
    /// use robot_dynamics::evaluation::{ReadOptions, RuntimeRobot};
    /// use robot_dynamics::inverse_kinematics::Target;
    /// use robot_dynamics::nalgebra::{DVector, Vector3};
    ///
    /// // Two links of 0.5 m in a plane.
    /// let table = r#"
    ///     convention = "modified"
    ///     gravity = [0, 0, -9.81]
    ///     tool = { xyz = [0.5, 0, 0] }
    ///     [[joint]]
    ///     name = "shoulder"
    ///     type = "revolute"
    ///     [[joint]]
    ///     name = "elbow"
    ///     type = "revolute"
    ///     a = 0.5
    /// "#;
    /// let options = ReadOptions::new().functions(RuntimeRobot::place_functions(None));
    /// let arm = RuntimeRobot::from_toml(table, &options)?;
    /// let tip = arm.place(None)?;
    /// let target = Target::position(Vector3::new(0.5, 0.5, 0.0));
    /// let found = InverseKinematics::new(&tip).solve(target, &DVector::from_vec(vec![0.1, 0.1]))?;
    /// assert!(found.q[0].abs() < 1e-8);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`EvaluationError::NotDerived`] unless both [`place_functions`](RuntimeRobot::place_functions) were requested.
    pub fn place(&self, frame: Option<&str>) -> Result<RuntimePlace<'_>, EvaluationError> {
        let [pose, jacobian] = RuntimeRobot::place_methods(frame);
        Ok(RuntimePlace {
            arm: self,
            table: self.table(),
            pose: self.function(&pose)?,
            jacobian: self.function(&jacobian)?,
        })
    }
}

impl RuntimePlace<'_> {
    /// The entries of a function; NaN where there are none.
    fn entries(&self, function: &Compiled, place: &Place<Dyn>) -> Vec<f64> {
        let values = self
            .arm
            .behind_base(place, [], |arguments| self.arm.at(function, arguments));
        values.unwrap_or_else(|_| vec![f64::NAN; function.layout.entries()])
    }

    /// The pose and the Jacobian where the robot is: what [`wrench_at`](dynamics_simulation::Simulation::wrench_at) needs. The
    /// columns of a base that moves come first.
    pub fn at(&self, place: &Place<Dyn>) -> (Matrix4<f64>, Matrix6xX<f64>) {
        let pose = Matrix4::from_column_slice(&self.entries(self.pose, place));
        (
            pose,
            Matrix6xX::from_vec(self.entries(self.jacobian, place)),
        )
    }
}

/// Joints alone move.
fn joints(q: &DVector<f64>) -> Place<Dyn> {
    let q = q.clone();
    Place { base: None, q }
}

impl SizedKinematics<Dyn> for RuntimePlace<'_> {
    fn tip_pose(&self, q: &DVector<f64>) -> Matrix4<f64> {
        Matrix4::from_column_slice(&self.entries(self.pose, &joints(q)))
    }

    fn tip_jacobian(&self, q: &DVector<f64>) -> Matrix6xX<f64> {
        let entries = self.entries(self.jacobian, &joints(q));
        let of_base = entries.len() - 6 * q.len();
        Matrix6xX::from_column_slice(&entries[of_base..])
    }
}

impl SizedTable<Dyn> for RuntimePlace<'_> {
    fn sized_numbers(&self) -> RuntimeTable {
        self.table.clone()
    }
}
