//! An arm of the engine's whose programs are run and not compiled: the same operations on the same
//! doubles as the functions that are emitted.

use dynamics_symbolic::Function;
use dynamics_symbolic::derive::derive;
use dynamics_symbolic::program::{Instruction, Operand, Program};
use dynamics_symbolic::robot::{self, Robot, Symbol, Value};
use robot_dynamics::nalgebra::{SMatrix, SVector};
use robot_dynamics::{
    Convention, Evaluate, Evaluation, JointType, Model, Placement, Row, Scalar, SingularMassMatrix,
    State, Table,
};

/// The functions that are run.
const FUNCTIONS: [Function; 9] = [
    Function::MassMatrix,
    Function::CoriolisVector,
    Function::GravityVector,
    Function::FrictionVector,
    Function::InverseDynamics,
    Function::ForwardDynamics,
    Function::ForwardDynamicsAba,
    Function::KineticEnergy,
    Function::PotentialEnergy,
];

/// A program with its constants as they are emitted, each correctly rounded.
struct Rounded {
    program: Program,
    constants: Vec<f64>,
}

/// An arm of N joints with values for its fields.
pub(crate) struct Interpreted<const N: usize> {
    robot: Robot,
    fields: Vec<f64>,
    programs: [Rounded; 9],
}

impl<const N: usize> Interpreted<N> {
    pub(crate) fn new(robot: Robot, fields: Vec<f64>) -> Self {
        assert_eq!((robot.rows.len(), robot.fields.len()), (N, fields.len()));
        let programs = FUNCTIONS.map(|function| {
            let program = derive(&robot, function);
            let constants = program.rounded_constants();
            Rounded { program, constants }
        });
        Interpreted {
            robot,
            fields,
            programs,
        }
    }

    fn cell(&self, value: &Value) -> f64 {
        value.to_f64(&self.fields)
    }

    fn row(&self, row: &robot::Row) -> Row {
        let cell = |value| self.cell(value);
        Row {
            joint_type: match row.joint_type {
                robot::JointType::Revolute => JointType::Revolute,
                robot::JointType::Prismatic => JointType::Prismatic,
            },
            a: cell(&row.a),
            alpha: cell(&row.alpha),
            d: cell(&row.d),
            theta: cell(&row.theta),
            mass: cell(&row.mass),
            com: row.com.each_ref().map(cell),
            inertia: row.inertia.each_ref().map(cell),
            motor_inertia: cell(&row.motor_inertia),
            gear_ratio: cell(&row.gear_ratio),
            viscous: cell(&row.viscous),
            coulomb: cell(&row.coulomb),
            limits: None,
            mount: Placement::IDENTITY,
            tip: Placement::IDENTITY,
        }
    }

    fn input(&self, symbol: &Symbol, state: &State<N>, tau: &SVector<f64, N>) -> f64 {
        match symbol {
            Symbol::Pi => std::f64::consts::PI,
            Symbol::Field(i) => self.fields[*i],
            Symbol::AngleSine(angle) => Scalar::sin_cos(self.cell(angle)).0,
            Symbol::AngleCosine(angle) => Scalar::sin_cos(self.cell(angle)).1,
            Symbol::Sine(i) => Scalar::sin_cos(state.q[*i]).0,
            Symbol::Cosine(i) => Scalar::sin_cos(state.q[*i]).1,
            Symbol::Position(i) => state.q[*i],
            Symbol::Velocity(i) => state.qd[*i],
            Symbol::Acceleration(i) => state.qdd[*i],
            Symbol::Force(i) => tau[*i],
            Symbol::VelocitySign(i) => Scalar::sign(state.qd[*i]),
        }
    }

    /// The outputs of the program of a function.
    fn run(&self, function: Function, state: &State<N>, tau: &SVector<f64, N>) -> Vec<f64> {
        let index = FUNCTIONS.iter().position(|f| *f == function);
        let Rounded { program, constants } = &self.programs[index.expect("a function that is run")];
        let inputs = program
            .inputs
            .iter()
            .map(|symbol| self.input(symbol, state, tau));
        let inputs: Vec<_> = inputs.collect();
        let mut results: Vec<f64> = Vec::with_capacity(program.instructions.len());
        let read = |results: &[f64], operand: Operand| match operand {
            Operand::Constant(id) => constants[id.index()],
            Operand::Input(i) => inputs[i as usize],
            Operand::Result(i) => results[i as usize],
        };
        for instruction in &program.instructions {
            let (a, b) = instruction.operands();
            let (a, b) = (read(&results, a), read(&results, b));
            results.push(match instruction {
                Instruction::Add(..) => a + b,
                Instruction::Sub(..) => a - b,
                Instruction::Mul(..) => a * b,
                Instruction::Div(..) => a / b,
            });
        }
        let outputs = program.outputs.iter().map(|output| {
            let value = read(&results, output.operand);
            if output.negative { -value } else { value }
        });
        outputs.collect()
    }
}

impl<const N: usize> Model<N> for Interpreted<N> {
    const JOINT_NAMES: [&'static str; N] = ["joint"; N];

    fn table(&self) -> Table<N> {
        Table {
            convention: match self.robot.convention {
                robot::Convention::Standard => Convention::Standard,
                robot::Convention::Modified => Convention::Modified,
            },
            gravity: self.robot.gravity.each_ref().map(|value| self.cell(value)),
            rows: std::array::from_fn(|i| self.row(&self.robot.rows[i])),
        }
    }
}

impl<const N: usize> Evaluate<N> for Interpreted<N> {
    fn evaluate(&self, state: &State<N>, tau: &SVector<f64, N>) -> Evaluation<N> {
        let values = |function| self.run(function, state, tau);
        let vector = |function| SVector::from_row_slice(&values(function));
        Evaluation {
            mass_matrix: Some(SMatrix::from_row_slice(&values(Function::MassMatrix))),
            coriolis_vector: Some(vector(Function::CoriolisVector)),
            gravity_vector: Some(vector(Function::GravityVector)),
            friction_vector: Some(vector(Function::FrictionVector)),
            inverse_dynamics: Some(vector(Function::InverseDynamics)),
            forward_dynamics: Some(accelerations(&values(Function::ForwardDynamics))),
            forward_dynamics_aba: Some(accelerations(&values(Function::ForwardDynamicsAba))),
            kinetic_energy: Some(values(Function::KineticEnergy)[0]),
            potential_energy: Some(values(Function::PotentialEnergy)[0]),
            ..Evaluation::default()
        }
    }
}

/// Accelerations, then pivots, then the diagonal entries that they are compared with.
fn accelerations<const N: usize>(outputs: &[f64]) -> Result<SVector<f64, N>, SingularMassMatrix> {
    for joint in (0..N).rev() {
        SingularMassMatrix::test(joint, outputs[N + joint], outputs[2 * N + joint])?;
    }
    Ok(SVector::from_row_slice(&outputs[..N]))
}
