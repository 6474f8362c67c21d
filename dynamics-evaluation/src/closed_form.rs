//! Inverse kinematics in closed form of a robot at run time: the plan of the generated method, step by step.

use dynamics_runtime::Scalar;
use dynamics_runtime::closed_form::{
    Branches, Family, Found, NoSolution, Roots, direction, elbow_angle, is_reached, nearest_pose,
    slide, slides, turn, turns,
};
use dynamics_runtime::nalgebra::{Matrix4, Vector3};
use dynamics_symbolic::function::Argument;
use dynamics_symbolic::inverse::{ELBOW, Plan, Rule, Step, Target};
use dynamics_symbolic::program::{Instruction, Line, Operand, Output, Program, Proven, Rest};
use dynamics_symbolic::proven_plan;
use dynamics_symbolic::robot::{JointType, Symbol};

use crate::error::BuildError;
use crate::read::parameter;
use crate::{EvaluationError, RuntimeRobot};

/// All joint positions that lead the tip of a [`RuntimeRobot`], or one of its frames, to a pose: bit for bit those of the generated
/// `inverse_kinematics`.
#[derive(Clone, Debug)]
pub struct ClosedForm {
    plan: Plan,
    equations: Evaluator,
    /// The steps, and behind them the lines that read all joints.
    stages: Vec<Stage>,
    has_families: bool,
    elbow: Option<Evaluator>,
    turns: Vec<bool>,
}

/// All that a step reads of the plan.
#[derive(Clone, Debug)]
struct Stage {
    /// The lines that read no later joint.
    lines: Vec<usize>,
    /// The joints whose families ask how far the equation is from having a solution.
    families_before: Vec<usize>,
    has_family: bool,
    /// The inputs of the program that are parts of the solution.
    parts: Vec<(usize, &'static str)>,
}

/// A solution.
#[derive(Clone, Debug, PartialEq)]
pub struct ClosedSolution {
    /// The positions, rad or m; angles above -pi and up to pi.
    pub q: Vec<f64>,
    /// Whether the pose is singular, as [`Solution`](dynamics_runtime::closed_form::Solution) says.
    pub is_singular: bool,
    /// The name of the branch.
    pub branch: String,
}

impl RuntimeRobot {
    /// Inverse kinematics in closed form of the tip, or of the frame of this name, for the present values of the fields.
    ///
    /// ```
    /// # mod robot_dynamics {
    /// # pub use dynamics_runtime::nalgebra;
    /// # pub use dynamics_evaluation as evaluation;
    /// # }
    /// use robot_dynamics::evaluation::{ReadOptions, RuntimeRobot};
    /// use robot_dynamics::nalgebra::{Matrix4, Vector3};
    ///
    /// // Two links of 0.5 m in a plane.
    /// let table = r#"
    ///     convention = "standard"
    ///     gravity = [0, 0, -9.81]
    ///     joint = [
    ///         { name = "shoulder", type = "revolute", a = 0.5 },
    ///         { name = "elbow", type = "revolute", a = 0.5 },
    ///     ]
    /// "#;
    /// let arm = RuntimeRobot::from_toml(table, &ReadOptions::new().functions(["forward_kinematics"]))?;
    /// let inverse = arm.closed_form(None)?;
    /// let pose = Matrix4::new_translation(&Vector3::new(0.5, 0.5, 0.0));
    /// let solutions = inverse.solutions(&pose, None).expect("a point in reach");
    /// let branches: Vec<&str> = solutions.iter().map(|one| &*one.branch).collect();
    /// assert_eq!(branches, ["elbow up", "elbow down"]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`BuildError::NoClosedForm`] with the reason why the arm has none, or if there is no frame of this name.
    pub fn closed_form(&self, frame: Option<&str>) -> Result<ClosedForm, BuildError> {
        let robot = self.robot();
        let error = |why: String| BuildError::NoClosedForm(why);
        let place = frame.map(|name| {
            let place = robot.frames.iter().position(|frame| frame.name == name);
            place.ok_or_else(|| error(format!("there is no frame `{name}`")))
        });
        let plan = proven_plan(robot, place.transpose()?).map_err(|why| error(why.to_string()))?;
        let fields = self.fields();
        let stages = plan.stages();
        let equations = Evaluator::new(&plan.program, fields);
        let of_stage = |stage: usize| {
            let lines = stages.iter().enumerate();
            let lines = lines.filter(|&(line, of)| *of == stage && equations.lines[line].is_some());
            let step = plan.steps.get(stage);
            Stage {
                lines: lines.map(|(line, _)| line).collect(),
                families_before: step.map_or_else(Vec::new, |_| plan.families_before(stage)),
                has_family: step.is_some() && plan.has_family(stage),
                parts: step.map_or_else(Vec::new, |step| plan.inputs_of(*step).collect()),
            }
        };
        let joints = robot.joints();
        Ok(ClosedForm {
            stages: (0..=plan.steps.len()).map(of_stage).collect(),
            elbow: plan
                .elbow
                .as_ref()
                .map(|program| Evaluator::new(program, fields)),
            has_families: plan.has_families(),
            turns: joints
                .map(|row| row.joint_type == JointType::Revolute)
                .collect(),
            equations,
            plan,
        })
    }
}

impl ClosedForm {
    /// The number of joints.
    pub fn joints(&self) -> usize {
        self.plan.joints
    }

    /// Whether solutions are those of an angle of the elbow, as of seven joints.
    pub fn has_elbow(&self) -> bool {
        self.plan.target == Target::PoseAndElbow
    }

    /// For each joint whether it turns.
    pub fn turns(&self) -> &[bool] {
        &self.turns
    }

    /// All solutions. `elbow` is the angle of seven joints' elbow, rad, and 0 if there is none.
    ///
    /// # Errors
    ///
    /// Why there is no solution.
    pub fn solutions(
        &self,
        pose: &Matrix4<f64>,
        elbow: Option<f64>,
    ) -> Result<Vec<ClosedSolution>, NoSolution> {
        macro_rules! solve {
            ($($joints:literal)*) => {
                match self.plan.joints {
                    $($joints => self.solve::<$joints>(pose, elbow.unwrap_or(0.0)),)*
                    _ => Err(NoSolution::OutOfReach),
                }
            };
        }
        solve!(1 2 3 4 5 6 7)
    }

    /// The angle of seven joints' elbow, rad, by which these joint positions are found; `None` of other arms.
    ///
    /// # Errors
    ///
    /// [`EvaluationError::Length`] if `q` has not an entry for each joint.
    pub fn elbow_angle(&self, q: &[f64]) -> Result<Option<f64>, EvaluationError> {
        if q.len() != self.plan.joints {
            return Err(EvaluationError::Length {
                argument: "q",
                found: q.len(),
                expected: self.plan.joints,
            });
        }
        let Some(elbow) = &self.elbow else {
            return Ok(None);
        };
        let mut state = elbow.state();
        for (place, symbol) in elbow.inputs.iter().enumerate() {
            match symbol {
                Symbol::Sine(joint) => state.inputs[place] = Scalar::sin_cos(q[*joint]).0,
                Symbol::Cosine(joint) => state.inputs[place] = Scalar::sin_cos(q[*joint]).1,
                _ => {}
            }
        }
        let lines = (0..elbow.lines.len()).filter(|&line| elbow.lines[line].is_some());
        elbow.compute(&mut state, lines);
        let number = |k: usize| elbow.output(&state, elbow.outputs[k]);
        let [line, across, axis] =
            [0, 3, 6].map(|k| Vector3::new(number(k), number(k + 1), number(k + 2)));
        Ok(Some(elbow_angle(line, across, axis, number(9))))
    }

    fn solve<const N: usize>(
        &self,
        pose: &Matrix4<f64>,
        elbow: f64,
    ) -> Result<Vec<ClosedSolution>, NoSolution> {
        let reads_rotation = self.plan.target != Target::Position;
        let mut place = None;
        let taken = nearest_pose(pose, &mut place, reads_rotation).filter(|_| elbow.is_finite());
        let mut branches = Branches::<f64, N>::default();
        if let Some(pose) = taken {
            branches = self.search(pose, elbow, false);
            if self.has_families && branches.is_loose() {
                branches = self.search(pose, elbow, true);
            }
        }
        let turns = core::array::from_fn(|joint| self.turns[joint]);
        let solutions = branches.solutions(turns, taken.is_some(), (&[], &[]));
        if let Some(why) = solutions.reason() {
            return Err(why);
        }
        let names = &self.plan.branches;
        let solution =
            |(k, one): (usize, &dynamics_runtime::closed_form::Solution<f64, N>)| ClosedSolution {
                q: one.q.as_slice().to_vec(),
                is_singular: one.is_singular,
                branch: names.names[branches.branch(k, &names.joints)].clone(),
            };
        Ok(solutions.iter().enumerate().map(solution).collect())
    }

    fn search<const N: usize>(
        &self,
        pose: &Matrix4<f64>,
        elbow: f64,
        searches: bool,
    ) -> Branches<f64, N> {
        let mut state = self.equations.state();
        let (sine, cosine) = Scalar::sin_cos(elbow);
        for (place, symbol) in self.equations.inputs.iter().enumerate() {
            state.inputs[place] = match symbol {
                Symbol::Entry(Argument::Pose, k) if *k < ELBOW => pose[Plan::place_in_pose(*k)],
                Symbol::Entry(Argument::Pose, ELBOW) if self.has_elbow() => sine,
                Symbol::Entry(Argument::Pose, k) if *k == ELBOW + 1 && self.has_elbow() => cosine,
                _ => continue,
            };
        }
        let mut search = Search {
            form: self,
            state,
            found: [slide(0.0); N],
            branches: Branches::default(),
            searches,
        };
        search.take(0, false);
        search.branches
    }
}

/// A search through the steps of a plan.
struct Search<'f, const N: usize> {
    form: &'f ClosedForm,
    state: State,
    found: [Found<f64>; N],
    branches: Branches<f64, N>,
    /// Whether positions that a pose leaves free are searched, or it is only noted that they should be.
    searches: bool,
}

impl<const N: usize> Search<'_, N> {
    /// Takes a step and all behind it.
    fn take(&mut self, step: usize, is_singular: bool) {
        let (form, plan) = (self.form, &self.form.plan);
        form.equations
            .compute(&mut self.state, form.stages[step].lines.iter().copied());
        let Some(&current) = plan.steps.get(step) else {
            return self.branches.push(self.found, is_singular);
        };
        let outputs = &form.equations.outputs[plan.outputs_of(step)];
        let number = |output: &Output| form.equations.output(&self.state, *output);
        let c: Vec<f64> = outputs.iter().map(number).collect();
        let (joint, roots) = match current {
            Step::Condition => {
                if is_reached(c[0], c[1], c[2], c[3]) {
                    self.take(step + 1, is_singular);
                }
                return;
            }
            Step::Direction(_) => {
                let (unit, is_any) = direction(c[0], c[1], c[2], c[3], c[4], c[5], c[6]);
                self.bind(step, |part| unit["xyz".find(part).unwrap_or(0)]);
                return self.take(step + 1, is_singular || is_any);
            }
            Step::Joint(joint, Rule::Turn) => {
                let both = turn(c[0], c[1], c[2], c[3]);
                return self.place(step, joint, both, is_singular);
            }
            Step::Joint(joint, Rule::Slide) => {
                return self.place(step, joint, [slide(c[0]); 2], is_singular);
            }
            Step::Joint(joint, Rule::Turns) => (joint, turns(c[0], c[1], c[2], c[3], c[4])),
            Step::Joint(joint, Rule::Slides) => (joint, slides(c[0], c[1], c[2])),
        };
        for root in self.judged(step, roots) {
            self.place(step, joint, [root; 2], is_singular);
        }
    }

    /// Roots, of which it is noted how far their equation is from having some.
    fn judged(&mut self, step: usize, roots: Roots<f64>) -> Roots<f64> {
        let before = &self.form.stages[step].families_before;
        let before: Vec<_> = before.iter().map(|joint| &self.found[*joint]).collect();
        match (before.is_empty(), self.searches) {
            (true, _) => roots,
            (false, true) => self.branches.noted(roots),
            (false, false) => self.branches.asked(roots, &before),
        }
    }

    /// Takes the steps behind one, with its joint at a position, or at each of its family: as it was found, and on the unit circle.
    fn place(&mut self, step: usize, joint: usize, both: [Found<f64>; 2], is_singular: bool) {
        if !(self.searches && self.form.stages[step].has_family) {
            return self.stand(step, joint, both, is_singular);
        }
        let mut family = Family::new(both);
        while let Some(both) = family.next(&mut self.branches) {
            self.stand(step, joint, both, is_singular);
        }
    }

    fn stand(
        &mut self,
        step: usize,
        joint: usize,
        [found, on_circle]: [Found<f64>; 2],
        is_singular: bool,
    ) {
        self.found[joint] = found;
        let parts = |part: &str| match part {
            "sine" => on_circle.sine,
            _ => on_circle.cosine,
        };
        self.bind(step, parts);
        self.take(step + 1, is_singular);
    }

    /// Gives the inputs of the program that are parts of a step's solution their values.
    fn bind(&mut self, step: usize, value: impl Fn(&str) -> f64) {
        for (place, part) in &self.form.stages[step].parts {
            self.state.inputs[*place] = value(part);
        }
    }
}

/// A program whose lines are carried out some at a time.
#[derive(Clone, Debug)]
struct Evaluator {
    lines: Vec<Option<Line>>,
    constants: Vec<f64>,
    inputs: Vec<Symbol>,
    /// The values of fields, and of functions of them, among the inputs.
    known: Vec<f64>,
    outputs: Vec<Output>,
}

/// The inputs and the results so far.
struct State {
    inputs: Vec<f64>,
    results: Vec<f64>,
}

impl Evaluator {
    fn new(program: &Program, fields: &[f64]) -> Self {
        let Proven { program, constants } = Proven::rounding(program.clone());
        let known = program.inputs.iter().map(|symbol| match symbol {
            Symbol::Field(_) | Symbol::AngleSine(_) | Symbol::AngleCosine(_) | Symbol::Pi => {
                parameter(symbol, fields, &|x: f64| x)
            }
            _ => f64::NAN,
        });
        Evaluator {
            lines: program.lines(),
            known: known.collect(),
            constants,
            inputs: program.inputs,
            outputs: program.outputs,
        }
    }

    fn state(&self) -> State {
        State {
            inputs: self.known.clone(),
            results: vec![f64::NAN; self.lines.len()],
        }
    }

    /// Carries out lines, in their order.
    fn compute(&self, state: &mut State, lines: impl IntoIterator<Item = usize>) {
        for index in lines {
            if let Some(line) = &self.lines[index] {
                state.results[index] = self.value(state, line);
            }
        }
    }

    fn value(&self, state: &State, line: &Line) -> f64 {
        let at = |operand| self.operand(state, operand);
        match *line {
            Line::Single(Instruction::Add(a, b)) => at(a) + at(b),
            Line::Single(Instruction::Sub(a, b)) => at(a) - at(b),
            Line::Single(Instruction::Mul(a, b)) => at(a) * at(b),
            Line::Single(Instruction::Div(a, b)) => at(a) / at(b),
            Line::Fused {
                product: (x, y),
                is_subtracted,
                rest,
            } => {
                let factor = if is_subtracted { -at(x) } else { at(x) };
                let rest = match rest {
                    Rest::Plus(a) => at(a),
                    Rest::Minus(a) => -at(a),
                    Rest::Product(a, b) => at(a) * at(b),
                };
                Scalar::mul_add(factor, at(y), rest)
            }
        }
    }

    fn operand(&self, state: &State, operand: Operand) -> f64 {
        match operand {
            Operand::Constant(id) => self.constants[id.index()],
            Operand::Input(index) => state.inputs[index as usize],
            Operand::Result(index) => state.results[index as usize],
        }
    }

    fn output(&self, state: &State, output: Output) -> f64 {
        let value = self.operand(state, output.operand);
        if output.negative { -value } else { value }
    }
}
