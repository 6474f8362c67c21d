//! Robots on a base that moves, as they are read at run time: their programs run in any arithmetic.

use std::sync::LazyLock;

use dynamics_evaluation::{EvaluationError, ReadOptions, RuntimeRobot};
use dynamics_symbolic::Function;
use robot_dynamics::nalgebra::{DMatrix, DVector};
use robot_dynamics::{
    Pose, Scalar, SizedState,
    check::{Checked, Evaluation},
    table::RuntimeTable,
};

use super::any_robot::{AnyRobot, MassMatrix};
use super::place::State;

pub(super) struct Moving {
    name: &'static str,
    pub(super) robot: RuntimeRobot,
    /// The end of the names of functions of the tip, of robots that have a frame in its place.
    suffix: String,
}

/// Two branches, one of which slides, with a motor, a spring, friction, and frames with bodies on a link and on the base.
pub(super) static FLYER: LazyLock<Moving> = LazyLock::new(|| {
    let text = r#"
        convention = "modified"
        gravity = [1, 2, -9.81]
        base = { floating = true, mass = 5, com = [0.1, -0.2, 0.3], inertia = { xx = 0.3, yy = 0.4, zz = 0.5, xy = 0.02, yz = -0.03, xz = 0.04 } }
        frame.hand = { on = "elbow", xyz = [0.3, 0.1, 0], rpy = [0.1, 0.2, 0.3], mass = 0.5, com = [0, 0, 0.1], inertia = "sphere(0.1)" }
        frame.pack = { on = "base", xyz = [0.2, 0, 0.1], rpy = [0.5, 0, 0], mass = 0.7, com = [0.1, 0, 0], inertia = "sphere(0.05)" }
        joint = [
            { name = "turn", type = "revolute", alpha = 0.3, a = 0.2, d = 0.1, theta = 0.5, mass = 2, com = [0.1, 0.2, -0.1], inertia = { xx = 0.2, yy = 0.3, zz = 0.4, xy = 0.02, yz = 0.03, xz = -0.01 }, motor = { inertia = 1e-4, gear_ratio = 50 }, spring = { stiffness = 3, rest = 0.2 }, friction = { viscous = 0.7 } },
            { name = "elbow", type = "revolute", alpha = -0.7, a = 0.3, mass = 1, com = [0.2, 0, 0.1], inertia = "sphere(0.1)" },
            { name = "slide", type = "prismatic", on = "base", at = { xyz = [0.1, 0.2, 0.3], rpy = [0.4, 0.5, 0.6] }, mass = 1.5, com = [0.1, 0, 0.05], inertia = "cuboid(0.1, 0.2, 0.3)" },
        ]
    "#;
    moving("flyer", text, "hand", &[])
});

/// A robot of `tests/data/files/kinds`.
macro_rules! kind {
    ($robot:ident, $file:literal, $tip:literal, $fields:expr) => {
        pub(super) static $robot: LazyLock<Moving> = LazyLock::new(|| {
            let text = include_str!(concat!("../../data/files/kinds/", $file, ".toml"));
            moving($file, text, $tip, $fields)
        });
    };
}

kind!(MOVING_TREE, "moving_tree", "foot", &[]);
kind!(BODY, "body", "camera", &[]);
kind!(LOCKED_ARM, "locked_arm", "", &[]);
kind!(
    MOVING_ARM,
    "moving_arm",
    "",
    &[("g", 9.81), ("trunk", 4.0), ("reach", 0.3)]
);

/// Functions of robots on a base that stands alone.
const OF_STANDING: [Function; 3] = [
    Function::CoriolisCoefficients,
    Function::CentrifugalCoefficients,
    Function::TaylorSeries,
];

fn moving(name: &'static str, text: &str, tip: &'static str, fields: &[(&str, f64)]) -> Moving {
    let functions = Function::ALL.into_iter();
    let functions = functions.filter(|function| !OF_STANDING.contains(function));
    let functions = functions.map(|function| match function.row().of_tip && !tip.is_empty() {
        true => format!("{}({tip})", function.name()),
        false => function.name().to_owned(),
    });
    let options = ReadOptions::new()
        .functions(functions)
        .fields(fields.iter().map(|(name, _)| *name));
    let robot = RuntimeRobot::from_toml(text, &options);
    let mut robot = robot.unwrap_or_else(|error| panic!("{name}: {error}"));
    for (field, value) in fields {
        robot.set_field(field, *value).expect("a field");
    }
    let suffix = match tip {
        "" => String::new(),
        frame => format!("_{frame}"),
    };
    Moving {
        name,
        robot,
        suffix,
    }
}

impl Moving {
    /// The name of a method, that of a function of the tip at the frame that stands for it.
    fn method(&self, function: &str) -> String {
        let mut names = self.robot.function_names();
        match names.any(|name| name == function) {
            true => function.to_owned(),
            false => format!("{function}{}", self.suffix),
        }
    }

    /// The numbers of a function at arguments by their names; none where M is singular.
    pub(super) fn numbers<T: Scalar>(
        &self,
        function: &str,
        arguments: &[(&str, Vec<T>)],
    ) -> Vec<T> {
        let method = self.method(function);
        let named = |name: &str| {
            let found = arguments.iter().find(|(found, _)| *found == name);
            &found.unwrap_or_else(|| panic!("`{name}` of {function}")).1[..]
        };
        let names = self.robot.arguments(&method).expect("asked for");
        let entries: Vec<&[T]> = names.map(|(name, _)| named(name)).collect();
        match self.robot.evaluate_in(&method, &entries) {
            Ok(numbers) => numbers,
            Err(EvaluationError::Singular { .. }) => Vec::new(),
            Err(error) => panic!("{function}: {error}"),
        }
    }
}

impl AnyRobot for Moving {
    fn file(&self) -> &str {
        self.name
    }

    fn table(&self) -> RuntimeTable {
        self.robot.table()
    }

    fn tip(&self) -> &str {
        &self.suffix
    }

    fn freedoms(&self) -> usize {
        self.robot.dof()
    }

    fn evaluate(&self, state: &State, tau: &DVector<f64>) -> Evaluation {
        let State { q, qd, qdd } = state.clone();
        let base = q.base.unwrap_or_else(Pose::identity);
        self.robot
            .values(&base, &SizedState { q: q.q, qd, qdd }, tau)
    }

    fn force_on_momenta(&self, state: &State, tau: &DVector<f64>) -> DVector<f64> {
        let bias = self.evaluate(state, tau).get::<Vec<f64>>("momentum_bias");
        tau + DVector::from(bias.expect("asked for"))
    }

    fn momentum_and_back(&self, state: &State) -> Option<[DVector<f64>; 2]> {
        let found = self
            .evaluate(state, &state.qdd)
            .get::<Vec<f64>>("generalized_momentum");
        let momentum = DVector::from(found.expect("asked for"));
        let m: DMatrix<f64> = self.mass_matrix(&state.q);
        let velocity = m.cholesky()?.solve(&momentum);
        Some([momentum, velocity])
    }
}
