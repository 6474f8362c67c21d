//! A frame of a robot at run time, as numeric inverse kinematics and forces of the surroundings take it.

use core::marker::PhantomData;

use dynamics_runtime::inverse_kinematics::SizedTable;
use dynamics_runtime::nalgebra::{DVector, Dyn, Matrix4, Matrix6xX};
use dynamics_runtime::table::RuntimeTable;
use dynamics_runtime::{Pose, SizedKinematics};
use dynamics_symbolic::Function;

use crate::compiled::Compiled;
use crate::{EvaluationError, Moves, RuntimeRobot};

/// The tip of a [`RuntimeRobot`], or one of its frames: what
/// [`InverseKinematics`](dynamics_runtime::InverseKinematics) needs of it. Vectors are `DVector<f64>`. One that [`Moves`] is
/// that of a robot on a base that moves.
#[derive(Clone, Debug)]
pub struct RuntimePlace<'a, K = ()> {
    arm: &'a RuntimeRobot,
    table: RuntimeTable,
    pose: &'a Compiled,
    jacobian: &'a Compiled,
    base: PhantomData<K>,
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
    /// # pub use dynamics_runtime::*;
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
    /// [`EvaluationError::MovingBase`] of a robot whose base moves; [`EvaluationError::NotDerived`] unless both
    /// [`place_functions`](RuntimeRobot::place_functions) were requested.
    pub fn place(&self, frame: Option<&str>) -> Result<RuntimePlace<'_>, EvaluationError> {
        match self.robot().floating() {
            Some(_) => Err(EvaluationError::MovingBase),
            None => self.place_of(frame),
        }
    }

    /// The same of a robot on a base that moves.
    ///
    /// # Errors
    ///
    /// [`EvaluationError::StandingBase`] of a robot whose base stands; [`EvaluationError::NotDerived`] as for
    /// [`place`](RuntimeRobot::place).
    pub fn place_on_base(
        &self,
        frame: Option<&str>,
    ) -> Result<RuntimePlace<'_, Moves>, EvaluationError> {
        match self.robot().floating() {
            Some(_) => self.place_of(frame),
            None => Err(EvaluationError::StandingBase),
        }
    }

    fn place_of<K>(&self, frame: Option<&str>) -> Result<RuntimePlace<'_, K>, EvaluationError> {
        let [pose, jacobian] = RuntimeRobot::place_methods(frame);
        Ok(RuntimePlace {
            arm: self,
            table: self.table(),
            pose: self.function(&pose)?,
            jacobian: self.function(&jacobian)?,
            base: PhantomData,
        })
    }
}

impl<K> RuntimePlace<'_, K> {
    /// The entries of a function; NaN where there are none.
    fn entries(&self, function: &Compiled, arguments: &[&[f64]]) -> Vec<f64> {
        let values = self.arm.at(function, arguments);
        values.unwrap_or_else(|_| vec![f64::NAN; function.layout.entries()])
    }

    fn pose(&self, arguments: &[&[f64]]) -> Matrix4<f64> {
        Matrix4::from_column_slice(&self.entries(self.pose, arguments))
    }

    fn jacobian(&self, arguments: &[&[f64]]) -> Matrix6xX<f64> {
        Matrix6xX::from_vec(self.entries(self.jacobian, arguments))
    }
}

impl RuntimePlace<'_> {
    /// The pose and the Jacobian: what [`wrench_at`](dynamics_runtime::Simulation::wrench_at) needs.
    pub fn at(&self, q: &DVector<f64>) -> (Matrix4<f64>, Matrix6xX<f64>) {
        (self.tip_pose(q), self.tip_jacobian(q))
    }
}

impl RuntimePlace<'_, Moves> {
    /// The pose and the Jacobian where the base has a pose; the columns of the base come first.
    pub fn at(&self, base: &Pose<f64>, q: &DVector<f64>) -> (Matrix4<f64>, Matrix6xX<f64>) {
        let entries = base.entries();
        let arguments = [entries.as_slice(), q.as_slice()];
        (self.pose(&arguments), self.jacobian(&arguments))
    }
}

impl SizedKinematics<Dyn> for RuntimePlace<'_> {
    fn tip_pose(&self, q: &DVector<f64>) -> Matrix4<f64> {
        self.pose(&[q.as_slice()])
    }

    fn tip_jacobian(&self, q: &DVector<f64>) -> Matrix6xX<f64> {
        self.jacobian(&[q.as_slice()])
    }
}

impl SizedTable<Dyn> for RuntimePlace<'_> {
    fn sized_numbers(&self) -> RuntimeTable {
        self.table.clone()
    }
}
