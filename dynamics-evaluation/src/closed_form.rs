//! Inverse kinematics in closed form of a robot at run time: the plan of the generated method, step by step.

use core::ops::Range;

use dynamics_runtime::Scalar;
use dynamics_runtime::closed_form::{
    Branches, Family, Found, NoSolution, Roots, Solution, direction, elbow_angle, is_reached,
    nearest_pose, slide, slides, turn, turns, turns_of_line,
};
use dynamics_runtime::nalgebra::{Matrix4, Vector3};
use dynamics_symbolic::function::{Argument, INVERSE_KINEMATICS};
use dynamics_symbolic::inverse::{ELBOW, Plan, Rule, Step, Target};
use dynamics_symbolic::proven_plan;
use dynamics_symbolic::robot::{JointType, Symbol};

use crate::compiled::check_length;
use crate::error::BuildError;
use crate::read::parameter;
use crate::tape::{Staged, Tape, is_shared_symbol};
use crate::{EvaluationError, RuntimeRobot};

/// All joint positions that lead the tip of a [`RuntimeRobot`], or one of its frames, to a pose: bit for bit those of the generated
/// `inverse_kinematics`.
#[derive(Clone, Debug)]
pub struct ClosedForm {
    plan: Plan,
    equations: Staged,
    /// Its numbers before a call: those of fields are known.
    numbers: Vec<f64>,
    /// The steps, and behind them the lines that read all joints.
    stages: Vec<Stage>,
    has_families: bool,
    /// The numbers of the elbow's angle, and those of them that all positions share.
    elbow: Option<(Tape, Vec<f64>)>,
    turns: Vec<bool>,
}

/// All that a step reads of the plan.
#[derive(Clone, Debug, Default)]
struct Stage {
    /// The instructions that read no later joint.
    instructions: Vec<usize>,
    /// The places of the coefficients among the outputs.
    coefficients: Range<usize>,
    /// The joints whose families ask how far the equation is from having a solution.
    families_before: Vec<usize>,
    has_family: bool,
    /// The inputs of the program that are parts of the solution.
    parts: Vec<(usize, &'static str)>,
}

/// A solution.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
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
        let too_long = |_| BuildError::TooLong(INVERSE_KINEMATICS.to_owned());
        let equations = Staged::new(&plan.proven()).map_err(too_long)?;
        let mut numbers = equations.unknown();
        for (number, symbol) in numbers.iter_mut().zip(&equations.inputs) {
            if is_shared_symbol(symbol) {
                *number = parameter(symbol, self.fields(), &|x| x);
            }
        }
        let elbow = plan.proven_elbow().map(|proven| {
            let tape = Tape::new(&proven).map_err(too_long)?;
            let shared = tape.shared(self.fields(), &|x| x);
            Ok((tape, shared))
        });
        let turns = robot
            .joints()
            .map(|row| row.joint_type == JointType::Revolute);
        Ok(ClosedForm {
            stages: stages(&plan),
            has_families: plan.has_families(),
            turns: turns.collect(),
            elbow: elbow.transpose()?,
            equations,
            numbers,
            plan,
        })
    }
}

/// The steps of a plan, and behind them the instructions that read all joints.
fn stages(plan: &Plan) -> Vec<Stage> {
    let stages = plan.stages();
    let of_step = |step: usize| {
        let instructions = stages
            .iter()
            .enumerate()
            .filter(|(_, stage)| **stage == step);
        let instructions = instructions.map(|(instruction, _)| instruction).collect();
        let Some(&taken) = plan.steps.get(step) else {
            return Stage {
                instructions,
                ..Stage::default()
            };
        };
        Stage {
            instructions,
            coefficients: plan.outputs_of(step),
            families_before: plan.families_before(step),
            has_family: plan.has_family(step),
            parts: plan.inputs_of(taken).collect(),
        }
    };
    (0..=plan.steps.len()).map(of_step).collect()
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
        check_length("q", q.len(), self.plan.joints)?;
        let Some((tape, shared)) = &self.elbow else {
            return Ok(None);
        };
        let read = |symbol: &Symbol| match symbol {
            Symbol::Position(joint) => q[*joint],
            _ => f64::NAN,
        };
        let found = tape.at(shared, &read);
        let [line, across, axis] = [0, 3, 6].map(|k| Vector3::from_column_slice(&found[k..k + 3]));
        Ok(Some(elbow_angle(line, across, axis, found[9])))
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
        let solution = |(k, one): (usize, &Solution<f64, N>)| ClosedSolution {
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
        let mut numbers = self.numbers.clone();
        let (sine, cosine) = Scalar::sin_cos(elbow);
        for (place, symbol) in self.equations.inputs.iter().enumerate() {
            numbers[place] = match symbol {
                Symbol::Entry(Argument::Pose, k) if *k < ELBOW => pose[Plan::place_in_pose(*k)],
                Symbol::Entry(Argument::Pose, ELBOW) if self.has_elbow() => sine,
                Symbol::Entry(Argument::Pose, k) if *k == ELBOW + 1 && self.has_elbow() => cosine,
                _ => continue,
            };
        }
        let mut search = Search {
            form: self,
            numbers,
            found: [slide(0.0); N],
            branches: Branches::default(),
            searches,
        };
        search.take(0, false);
        search.branches
    }
}

/// A step has so many coefficients: a direction.
const MOST_COEFFICIENTS: usize = 7;

/// A search through the steps of a plan.
struct Search<'f, const N: usize> {
    form: &'f ClosedForm,
    numbers: Vec<f64>,
    found: [Found<f64>; N],
    branches: Branches<f64, N>,
    /// Whether positions that a pose leaves free are searched, or it is only noted that they should be.
    searches: bool,
}

impl<const N: usize> Search<'_, N> {
    /// Takes a step and all behind it.
    fn take(&mut self, step: usize, is_singular: bool) {
        let (form, stage) = (self.form, &self.form.stages[step]);
        form.equations
            .compute(&mut self.numbers, &stage.instructions);
        let Some(&current) = form.plan.steps.get(step) else {
            return self.branches.push(self.found, is_singular);
        };
        let mut c = [0.0; MOST_COEFFICIENTS];
        for (coefficient, output) in c.iter_mut().zip(stage.coefficients.clone()) {
            *coefficient = form.equations.output(&self.numbers, output);
        }
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
            Step::Joint(joint, Rule::TurnsOfLine) => {
                let roots = turns_of_line(c[0], c[1], c[2], c[3], c[4], c[5], c[6]);
                (joint, roots)
            }
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
            self.numbers[*place] = value(part);
        }
    }
}
