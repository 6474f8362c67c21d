//! A robot whose functions are evaluated without a compiler.

use std::sync::{Mutex, OnceLock};

use dynamics_runtime::{
    NAMES_OF_BASE, Operations, Scalar, SingularMassMatrix, table::RuntimeTable,
};
use dynamics_symbolic::function::{Argument, plain};
use dynamics_symbolic::robot::Robot;
use dynamics_symbolic::{Proven, Request, proven_program};
use fearless_simd::Level;

use crate::block::{Batch, Block, run};
use crate::compiled::{Compiled, check_length};
use crate::error::{BuildError, EvaluationError, UnknownField};
use crate::read::{Axis, Reader, at_state, axes};
use crate::table::table;
use crate::validate::validate;
use crate::value::Value;

/// A robot arm known at run time, with the functions of a generated one.
///
/// Its functions are derived and proven as the macro's are, and are the same operations on the same
/// constants: a call returns, bit for bit, what a generated method returns. A call looks up the operands of each
/// operation. A batch looks them up once for 32 states, in the lanes of vector registers: a state takes about as long
/// as a call of generated code, and an eighth of a call here.
///
/// ```
/// # mod robot_dynamics {
/// # pub use dynamics_evaluation as evaluation;
/// # }
/// use robot_dynamics::evaluation::{ReadOptions, RuntimeRobot};
///
/// // A mass that hangs from a horizontal axis: its mass is a field, its distance 1/2 m.
/// let table = r#"
///     convention = "modified"
///     gravity = [9.81, 0, 0]
///     [[joint]]
///     name = "pivot"
///     type = "revolute"
///     mass = "mass"
///     com = [0.5, 0, 0]
/// "#;
/// let options = ReadOptions::new().fields(["mass"]).functions(["mass_matrix", "gravity_vector"]);
/// let mut arm = RuntimeRobot::from_toml(table, &options)?;
/// arm.set_field("mass", 4.0)?;
/// assert_eq!(arm.mass_matrix(&[0.3])?[0], 1.0);
/// arm.set_field("mass", 8.0)?;
/// assert_eq!(arm.mass_matrix(&[0.3])?[0], 2.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct RuntimeRobot {
    robot: Robot,
    fields: Vec<f64>,
    /// The axes for the present values of the fields.
    axes: Vec<Axis<f64>>,
    functions: Vec<Compiled>,
    /// Notes for whoever reads the file.
    warnings: Vec<String>,
    /// The table for these values, once it has been needed: its exact cells take longer than many calls.
    table: OnceLock<RuntimeTable>,
    /// Slots that no call is using.
    rooms: Mutex<Vec<Room>>,
}

/// Slots of blocks.
struct Room(Vec<Block>);

impl core::fmt::Debug for Room {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "{} slots", self.0.len())
    }
}

impl Clone for RuntimeRobot {
    fn clone(&self) -> Self {
        RuntimeRobot {
            robot: self.robot.clone(),
            fields: self.fields.clone(),
            axes: self.axes.clone(),
            functions: self.functions.clone(),
            warnings: self.warnings.clone(),
            table: self.table.clone(),
            rooms: Mutex::default(),
        }
    }
}

impl RuntimeRobot {
    /// The robot with the functions that are requested, each derived and proven.
    ///
    /// Fields have no value yet: until each has one by [`set_field`](RuntimeRobot::set_field), values that
    /// depend on them are NaN.
    ///
    /// # Errors
    ///
    /// [`BuildError`]: the table has no joint that moves, or a function could not be proven.
    #[doc(hidden)]
    pub fn new<R: Into<Request>>(
        robot: Robot,
        functions: impl IntoIterator<Item = R>,
    ) -> Result<Self, BuildError> {
        validate(&robot)?;
        let mut programs = Vec::new();
        for request in functions {
            let request = request.into();
            let program = proven_program(&robot, &request)
                .map_err(|failure| BuildError::Failure(failure.to_string()))?;
            programs.push((request, program));
        }
        Self::of_programs(robot, &programs)
    }

    /// The robot with functions whose programs are known already, from [`proven_program`] of the same
    /// description, for example because they are emitted in another language too.
    ///
    /// # Errors
    ///
    /// [`BuildError`], as [`new`](RuntimeRobot::new).
    #[doc(hidden)]
    pub fn of_programs(robot: Robot, programs: &[(Request, Proven)]) -> Result<Self, BuildError> {
        validate(&robot)?;
        let mut compiled: Vec<Compiled> = Vec::new();
        for (request, proven) in programs {
            let name = request.name();
            if compiled.iter().any(|known| known.request.name() == name) {
                return Err(BuildError::Repeated(name.to_owned()));
            }
            compiled.push(Compiled::new(&robot, request.clone(), proven)?);
        }
        let fields = vec![f64::NAN; robot.fields.len()];
        let mut arm = RuntimeRobot {
            robot,
            fields,
            axes: Vec::new(),
            functions: compiled,
            warnings: Vec::new(),
            table: OnceLock::new(),
            rooms: Mutex::default(),
        };
        arm.update();
        Ok(arm)
    }

    /// The same robot with notes for whoever reads its file.
    pub(crate) fn with_warnings(mut self, warnings: Vec<String>) -> Self {
        self.warnings = warnings;
        self
    }

    /// Notes on values of the file that a reader may not expect, a text each. One counts the angles that are taken as quarter
    /// turns. If base parameters are among the functions, another one names the angles because of which torques hardly tell
    /// these apart. There are none for a robot that comes from no file.
    ///
    /// # Errors
    ///
    /// None.
    pub fn warnings(&self) -> &[String] {
        &self.warnings
    }

    /// The description that the robot was made of.
    #[doc(hidden)]
    pub fn robot(&self) -> &Robot {
        &self.robot
    }

    /// The table as numbers, with the present values of the fields: without a value for each, some are NaN.
    pub fn table(&self) -> RuntimeTable {
        let table = || table(&self.robot, &self.fields);
        self.table.get_or_init(table).clone()
    }

    /// Number of joints that move, and six more of a base that moves.
    pub fn dof(&self) -> usize {
        self.robot.dof()
    }

    /// Names of the joints that move, from the base outwards.
    pub fn joint_names(&self) -> impl Iterator<Item = &str> {
        self.robot.joints().map(|row| row.name.as_str())
    }

    /// Names of the fields.
    pub fn field_names(&self) -> &[String] {
        &self.robot.fields
    }

    /// Values of the fields, in that order.
    pub fn fields(&self) -> &[f64] {
        &self.fields
    }

    /// Gives a field a value: a mass that changes takes no new derivation.
    ///
    /// # Errors
    ///
    /// [`UnknownField`] where there is no field of that name.
    pub fn set_field(&mut self, name: &str, value: f64) -> Result<(), UnknownField> {
        let names = self.robot.fields.iter().map(|field| plain(field));
        let Some(index) = names.clone().position(|field| field == plain(name)) else {
            return Err(UnknownField {
                name: name.to_owned(),
                fields: names.map(str::to_owned).collect(),
            });
        };
        self.fields[index] = value;
        self.update();
        Ok(())
    }

    /// Gives all fields their values.
    ///
    /// # Errors
    ///
    /// [`EvaluationError::Length`] where there are not as many values as fields.
    pub fn set_fields(&mut self, values: &[f64]) -> Result<(), EvaluationError> {
        check_length("fields", values.len(), self.fields.len())?;
        self.fields.copy_from_slice(values);
        self.update();
        Ok(())
    }

    fn update(&mut self) {
        self.table = OnceLock::new();
        self.axes = axes(&self.robot, &self.fields, &|x| x);
        for function in &mut self.functions {
            function.shared = function.tape.shared(&self.fields, &|x| x);
            if let Some((single, prepared)) = &mut function.single {
                *prepared = single.prepare(&function.shared, &self.axes, &function.arguments);
            }
        }
    }

    /// The names of the functions.
    pub fn function_names(&self) -> impl Iterator<Item = &str> {
        self.functions
            .iter()
            .map(|function| function.request.name())
    }

    /// The operations of a function.
    ///
    /// # Errors
    ///
    /// [`EvaluationError::NotDerived`] where it was not requested.
    pub fn operations(&self, function: &str) -> Result<Operations, EvaluationError> {
        self.function(function).map(|function| function.operations)
    }

    /// How many numbers at each state the evaluation of a function keeps at once.
    ///
    /// # Errors
    ///
    /// [`EvaluationError::NotDerived`] where it was not requested.
    pub fn slots(&self, function: &str) -> Result<usize, EvaluationError> {
        self.function(function).map(|function| function.tape.slots)
    }

    /// The value of a function at a state, by its name or that of a method of several functions: what
    /// the method of that name returns. The arguments are those of the method.
    ///
    /// # Errors
    ///
    /// [`EvaluationError`] where the function was not requested, an argument is too short or too long,
    /// or M is singular.
    pub fn evaluate(&self, function: &str, arguments: &[&[f64]]) -> Result<Value, EvaluationError> {
        let function = self.function(function)?;
        let values = self.at(function, arguments)?;
        Ok(Value::new(
            &function.request,
            function.layout.sizes,
            &values,
        ))
    }

    /// The entries of the value of a function at a state, in the arithmetic of any scalar: in the order
    /// of [`batch`](RuntimeRobot::batch).
    ///
    /// # Errors
    ///
    /// The errors of [`evaluate`](RuntimeRobot::evaluate).
    pub fn evaluate_in<T: Scalar>(
        &self,
        function: &str,
        arguments: &[&[T]],
    ) -> Result<Vec<T>, EvaluationError> {
        let function = self.function(function)?;
        let like = arguments.iter().find_map(|entries| entries.first());
        let constant = |x: f64| like.map_or_else(|| T::from_f64(x), |like| like.constant(x));
        let shared = function.tape.shared(&self.fields, &constant);
        self.of_state(function, &shared, arguments, &constant)
    }

    /// The entries of the value of a function at a state.
    pub(crate) fn at(
        &self,
        function: &Compiled,
        arguments: &[&[f64]],
    ) -> Result<Vec<f64>, EvaluationError> {
        let Some((single, prepared)) = &function.single else {
            return self.of_state(function, &function.shared, arguments, &|x| x);
        };
        function.check_lengths(arguments, 1)?;
        let values = single.values(prepared, arguments);
        values.map_err(|error| self.singular(None, error))
    }

    pub(crate) fn of_state<T: Scalar>(
        &self,
        function: &Compiled,
        shared: &[T],
        arguments: &[&[T]],
        constant: &impl Fn(f64) -> T,
    ) -> Result<Vec<T>, EvaluationError> {
        function.check_lengths(arguments, 1)?;
        let entry = function.entry(arguments, constant);
        let values = self.values(function, shared, &entry, constant);
        values.map_err(|error| self.singular(None, error))
    }

    /// The arguments of a function by their names, `q`, `qd` and so on, each with its number of entries at a state.
    ///
    /// # Errors
    ///
    /// [`EvaluationError::NotDerived`] where it was not requested.
    pub fn arguments(
        &self,
        function: &str,
    ) -> Result<impl Iterator<Item = (&'static str, usize)>, EvaluationError> {
        let arguments = self.function(function)?.arguments.iter();
        Ok(arguments.map(|(argument, entries)| (argument.name(), *entries)))
    }

    /// How many entries the value of a function has at each state.
    ///
    /// # Errors
    ///
    /// [`EvaluationError::NotDerived`] where it was not requested.
    pub fn entries(&self, function: &str) -> Result<usize, EvaluationError> {
        self.function(function)
            .map(|function| function.layout.entries())
    }

    /// The values of a function at many states. Arguments and results hold one state after the other,
    /// matrices by columns, one after the other where there are several.
    ///
    /// Sums of products are fused where the processor can: values are those of
    /// [`evaluate`](RuntimeRobot::evaluate) to the last few units in the last place of the largest
    /// terms. The room that a call takes is kept for the next one.
    ///
    /// # Errors
    ///
    /// [`EvaluationError::Length`] where arguments or results do not have as many states as the first
    /// argument; nothing is written then. [`EvaluationError::Singular`] for the first state where M is singular: the
    /// values of all such states are NaN then, those of the others are written.
    pub fn batch(
        &self,
        function: &str,
        arguments: &[&[f64]],
        results: &mut [f64],
    ) -> Result<(), EvaluationError> {
        self.batch_at(Level::new(), function, arguments, results)
    }

    /// [`batch`](RuntimeRobot::batch) with the instructions of a level.
    #[doc(hidden)]
    pub fn batch_at(
        &self,
        level: Level,
        function: &str,
        arguments: &[&[f64]],
        results: &mut [f64],
    ) -> Result<(), EvaluationError> {
        let function = self.function(function)?;
        self.batch_of(level, function, &function.layout.values, arguments, results)
    }

    /// The values of a function at many states, in an order of the values of a state.
    pub(crate) fn batch_of(
        &self,
        level: Level,
        function: &Compiled,
        values: &[(usize, usize)],
        arguments: &[&[f64]],
        results: &mut [f64],
    ) -> Result<(), EvaluationError> {
        let entries = function.layout.entries();
        let mut pairs = function.arguments.iter().zip(arguments);
        let states = match pairs.find(|((_, width), _)| *width > 0) {
            Some(((_, width), first)) => first.len() / width,
            // Base parameters are the same at all states, as are values of joint positions where there are no joints.
            None => results.len().checked_div(entries).unwrap_or(0),
        };
        function.check_lengths(arguments, states)?;
        check_length("results", results.len(), states * entries)?;
        let pairs = function.arguments.iter().zip(arguments);
        let reader = Reader {
            arguments: pairs
                .map(|((argument, width), entries)| (*argument, *entries, *width))
                .collect(),
            axes: &self.axes,
        };
        let batch = Batch {
            tape: &function.tape,
            stages: &function.stages,
            shared: &function.shared,
            layout: &function.layout,
            values,
            states,
        };
        let mut room = self.room(function.tape.slots);
        let failure = run(level, &batch, &reader, &mut room.0, results);
        self.give_back(room);
        match failure {
            None => Ok(()),
            Some((state, error)) => Err(self.singular(Some(state), error)),
        }
    }

    fn room(&self, slots: usize) -> Room {
        let kept = self.rooms.lock().ok().and_then(|mut rooms| rooms.pop());
        let mut room = kept.unwrap_or(Room(Vec::new()));
        if room.0.len() < slots {
            room.0.resize(slots, Block::ZERO);
        }
        room
    }

    fn give_back(&self, room: Room) {
        if let Ok(mut rooms) = self.rooms.lock() {
            rooms.push(room);
        }
    }

    /// The function of that name.
    pub(crate) fn function(&self, name: &str) -> Result<&Compiled, EvaluationError> {
        let mut functions = self.functions.iter();
        let found = functions.find(|function| function.request.name() == name);
        found.ok_or_else(|| EvaluationError::NotDerived(name.to_owned()))
    }

    pub(crate) fn functions(&self) -> &[Compiled] {
        &self.functions
    }

    /// The values of a function in the order of its shape, matrices by columns: `argument` are the
    /// entries of the arguments, `shared` the numbers that all states share.
    pub(crate) fn values<T: Scalar>(
        &self,
        function: &Compiled,
        shared: &[T],
        argument: &impl Fn(Argument, usize) -> T,
        constant: &impl Fn(f64) -> T,
    ) -> Result<Vec<T>, SingularMassMatrix> {
        let axes = axes(&self.robot, &self.fields, constant);
        let read = |symbol: &_| {
            let value = at_state(symbol, argument, &axes);
            value.unwrap_or_else(|| constant(f64::NAN))
        };
        let outputs = function.tape.at(shared, &read);
        for test in &function.layout.tests {
            test.result(|output| outputs[output])?;
        }
        Ok(function.layout.values_of(&outputs))
    }

    pub(crate) fn singular(
        &self,
        state: Option<usize>,
        error: SingularMassMatrix,
    ) -> EvaluationError {
        // The six of a base that moves are counted first.
        let of_base = NAMES_OF_BASE.into_iter().take(self.robot.freedoms().base);
        let joint = of_base.chain(self.joint_names()).nth(error.joint);
        EvaluationError::Singular {
            state,
            joint: joint.unwrap_or_default().to_owned(),
            error,
        }
    }
}
