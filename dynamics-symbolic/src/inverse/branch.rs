//! The names of branches: "shoulder left, elbow up, wrist flipped".
//!
//! A joint whose equation has two roots makes two branches of each. The first root is the positive turn from where the two
//! would be one. Which of both is left, or up, is seen at sample positions (Lee, Ziegler, Geometric approach in solving inverse
//! kinematics of PUMA robots, IEEE Transactions on Aerospace and Electronic Systems 20, 1984):
//!
//! - An arm is left if it passes axis 1 on the left, seen from there to the wrist; without a step beside axis 1, if axis 2 points
//!   to the left.
//! - The elbow is up if it is above the line from axis 2 to the wrist, axis 1 pointing upwards.
//!
//! The first root of other arms is called left, up, and not flipped.

use super::chain::{Link, joints};
use super::moves::Path;
use super::plan::{BranchNames, Plan, Rule, Step, Target};
use super::view::Unknown;
use crate::exact::{Rational, SplitMix64, sin_cos};
use crate::expr::{Edge, Graph};
use crate::function::Argument;
use crate::linear::Vector3;
use crate::program::{Arithmetic, Program, by_operators};
use crate::robot::Symbol;
use crate::spatial::AxisMotion;

/// Positions at which it is seen what is left and up.
const SAMPLES: u64 = 16;

/// A part of an arm, and what its two roots are called.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Part {
    Shoulder,
    Elbow,
    Wrist,
}

impl Part {
    const fn words(self) -> [&'static str; 2] {
        match self {
            Part::Shoulder => ["shoulder left", "shoulder right"],
            Part::Elbow => ["elbow up", "elbow down"],
            Part::Wrist => ["wrist unflipped", "wrist flipped"],
        }
    }

    /// The part that a joint is of, by its number.
    const fn of(joint: usize, target: Target) -> Self {
        match (joint, target) {
            (0, _) | (1, Target::PoseAndElbow) => Part::Shoulder,
            (1 | 2, _) | (3, Target::PoseAndElbow) => Part::Elbow,
            _ => Part::Wrist,
        }
    }
}

/// The joints with two roots, each with its part: the shoulder before the elbow before the wrist.
fn parts(plan: &Plan) -> Vec<(usize, Part)> {
    let two = plan.steps.iter().filter_map(|step| match step {
        Step::Joint(joint, rule) if step.solutions() == 2 => Some(*joint),
        _ => None,
    });
    let mut two: Vec<usize> = two.collect();
    two.sort_unstable();
    let parts = two.iter().map(|joint| Part::of(*joint, plan.target));
    let parts: Vec<Part> = match (parts.collect::<Vec<_>>(), two.len()) {
        (_, 3) => vec![Part::Shoulder, Part::Elbow, Part::Wrist],
        (parts, 2) if parts[0] == parts[1] && parts[0] == Part::Wrist => {
            vec![Part::Elbow, Part::Wrist]
        }
        (parts, 2) if parts[0] == parts[1] => vec![Part::Shoulder, Part::Elbow],
        (parts, _) => parts,
    };
    two.into_iter().zip(parts).collect()
}

/// The names of the branches of a plan for the end of a chain.
pub(super) fn names(
    graph: &Graph,
    meanings: &[Symbol],
    chain: &[Link<'_>],
    fields: usize,
    plan: &Plan,
) -> BranchNames {
    let parts = parts(plan);
    let moving: Vec<Unknown> = joints(chain).collect();
    let sides = match may_have_sides(&moving, plan) {
        true => Sides::seen(&axes(graph, meanings, chain), fields, &moving, plan, &parts),
        false => Sides::default(),
    };
    let name = |index: usize| {
        let bit = |k: usize| index >> k & 1 == 1;
        let place = |part| parts.iter().position(|(_, one)| *one == part);
        let is_right = place(Part::Shoulder).is_some_and(bit);
        let words = parts.iter().enumerate().map(|(k, (_, part))| {
            let is_second = match part {
                Part::Shoulder => bit(k) != sides.is_left_second,
                Part::Elbow => {
                    let mirrors = sides.mirrors_elbow && is_right;
                    (bit(k) != mirrors) != sides.is_up_second
                }
                Part::Wrist => bit(k),
            };
            part.words()[usize::from(is_second)]
        });
        words.collect::<Vec<_>>().join(", ")
    };
    BranchNames {
        names: (0..1 << parts.len()).map(name).collect(),
        joints: parts.iter().map(|(joint, _)| *joint).collect(),
    }
}

/// Which roots are left and up.
#[derive(Clone, Copy, Default)]
struct Sides {
    is_left_second: bool,
    is_up_second: bool,
    /// Whether the other root of the shoulder turns the elbow over: the arm then reaches backwards.
    mirrors_elbow: bool,
}

/// How much oftener something was seen than its opposite.
#[derive(Default)]
struct Votes(i64);

impl Votes {
    fn add(&mut self, is_so: bool) {
        self.0 += if is_so { 1 } else { -1 };
    }
}

/// Whether an arm may have an axis that is upright to the next two.
fn may_have_sides(moving: &[Unknown], plan: &Plan) -> bool {
    let turns = |joint: &Unknown| joint.axis_motion == AxisMotion::Turns;
    let three = moving.get(..3);
    plan.target != Target::PoseAndElbow && three.is_some_and(|three| three.iter().all(turns))
}

impl Sides {
    /// The sides at sample positions.
    fn seen(
        axes: &Program,
        fields: usize,
        moving: &[Unknown],
        plan: &Plan,
        parts: &[(usize, Part)],
    ) -> Self {
        let place = |part| parts.iter().position(|(_, one)| *one == part);
        let [shoulder, elbow] = [Part::Shoulder, Part::Elbow].map(place);
        let [mut left, mut up, mut mirrored] = [const { Votes(0) }; 3];
        let mut any = Sample::new(fields, moving, 0);
        let axes = Numeric::new(axes, &mut any);
        let branches = Branches {
            plan,
            parts,
            equations: Numeric::new(&plan.program, &mut any),
        };
        for sample in 0..SAMPLES {
            let mut point = Sample::new(fields, moving, sample);
            point.reach(&axes);
            let mut follow = |point: &mut Sample, index: usize| {
                let places = axes.at(point);
                let Some(seen) = Seen::new(&places, moving.len()) else {
                    return;
                };
                let bit = |place: usize| index >> place & 1 == 1;
                if let Some(place) = shoulder {
                    left.add(seen.is_left != bit(place));
                }
                let turns_round = shoulder.is_none() && !seen.is_ahead;
                if let Some(place) = elbow.filter(|_| !turns_round) {
                    up.add(seen.is_up != bit(place));
                    let is_right = shoulder.is_some_and(bit);
                    mirrored.add(seen.is_up != (bit(place) != is_right));
                }
            };
            branches.follow(&mut point, 0, 0, &mut follow);
        }
        let mirrors_elbow = mirrored.0.abs() > up.0.abs();
        let up = if mirrors_elbow { mirrored } else { up };
        Sides {
            is_left_second: left.0 < 0,
            is_up_second: up.0 < 0,
            mirrors_elbow,
        }
    }
}

/// A program for the places of all axes and of the frame: origin and direction of z of each joint, before it moves; then the frame's
/// rotation by rows and its origin.
fn axes(graph: &Graph, meanings: &[Symbol], chain: &[Link<'_>]) -> Program {
    let (zero, one) = (graph.zero(), graph.one());
    let [x, y, z] = [[one, zero, zero], [zero, one, zero], [zero, zero, one]].map(Vector3);
    let mut way = Path::default();
    let mut outputs: Vec<Edge> = Vec::new();
    for link in chain {
        if link.joint.is_some() {
            let place = [way.point(Vector3::splat(zero)), way.direction(z)];
            outputs.extend(place.iter().flat_map(|v| v.0).map(|number| number.edge()));
        }
        way.0.push(link.motion);
    }
    let columns = [x, y, z].map(|axis| way.direction(axis).0);
    let rows = (0..3).flat_map(|i| columns.map(|column| column[i]));
    let origin = way.point(Vector3::splat(zero)).0;
    outputs.extend(rows.chain(origin).map(|number| number.edge()));
    Program::new(graph, meanings, &outputs, &|id| graph.operation(id))
}

/// The sides of an arm at a position.
struct Seen {
    is_ahead: bool,
    is_left: bool,
    is_up: bool,
}

impl Seen {
    /// `None` if the first axis is not upright to the next two, or these are not parallel, or the arm is too near to being neither.
    fn new(places: &[f64], joints: usize) -> Option<Self> {
        const NEAR: f64 = 1e-9;
        let vector = |k: usize| Vector3([places[k], places[k + 1], places[k + 2]]);
        let origin = |joint: usize| vector(6 * joint);
        let axis = |joint: usize| vector(6 * joint + 3);
        let tip = vector(6 * joints + 9);
        let (upwards, beside) = (axis(0), axis(1));
        let vanishes = |v: Vector3<f64>| v.dot(v) < NEAR;
        let is_parallel = |joint: usize| vanishes(axis(joint).cross(beside));
        if upwards.dot(beside).abs() > NEAR || !is_parallel(2) {
            return None;
        }
        let forwards = beside.cross(upwards);
        let wrist = if joints > 4 { origin(joints - 1) } else { tip };
        let from_waist = wrist - origin(0);
        let (reach, step) = (from_waist.dot(forwards), from_waist.dot(beside));
        let step = if step.abs() < NEAR { 1.0 } else { step };
        let end = if joints > 3 && is_parallel(3) {
            origin(3)
        } else {
            wrist
        };
        let in_plane = |v: Vector3<f64>| [v.dot(forwards), v.dot(upwards)];
        let [line, elbow] = [end, origin(2)].map(|v| in_plane(v - origin(1)));
        let above = (line[0] * elbow[1] - line[1] * elbow[0]) * line[0];
        (reach.abs() > NEAR && above.abs() > NEAR).then_some(Seen {
            is_ahead: reach > 0.0,
            is_left: reach * step > 0.0,
            is_up: above > 0.0,
        })
    }
}

/// Doubles for all symbols.
struct Sample {
    /// Each is 1.
    fields: Vec<f64>,
    /// Sine, cosine and position of each joint that moves.
    joints: Vec<[f64; 3]>,
    pose: Vec<f64>,
}

/// A program in doubles, whose constants are evaluated once.
struct Numeric<'p> {
    program: &'p Program,
    constants: Vec<f64>,
}

impl<'p> Numeric<'p> {
    fn new(program: &'p Program, point: &mut Sample) -> Self {
        let constants = program.constants.evaluate(point);
        Numeric { program, constants }
    }

    fn at(&self, point: &mut Sample) -> Vec<f64> {
        self.program.evaluate_with(self.constants.clone(), point)
    }
}

/// A plan whose branches are followed.
struct Branches<'p> {
    plan: &'p Plan,
    parts: &'p [(usize, Part)],
    equations: Numeric<'p>,
}

impl Arithmetic for Sample {
    type Number = f64;

    fn rational(&mut self, x: &Rational) -> f64 {
        x.to_f64().value()
    }

    fn symbol(&mut self, symbol: &Symbol) -> f64 {
        match symbol {
            Symbol::Pi => core::f64::consts::PI,
            Symbol::Field(i) => self.fields[*i],
            Symbol::AngleSine(angle) => sin_cos(angle.to_f64(&self.fields)).0,
            Symbol::AngleCosine(angle) => sin_cos(angle.to_f64(&self.fields)).1,
            Symbol::Sine(i) => self.joints[*i][0],
            Symbol::Cosine(i) => self.joints[*i][1],
            Symbol::Position(i) => self.joints[*i][2],
            Symbol::Entry(Argument::Pose, k) => self.pose[*k],
            _ => f64::NAN,
        }
    }

    by_operators!(f64);
}

impl Sample {
    /// Random positions.
    fn new(fields: usize, moving: &[Unknown], seed: u64) -> Self {
        let mut random = SplitMix64::new(seed);
        let joint = |_: &Unknown| {
            let q = 6.0 * random.unit() - 3.0;
            let (s, c) = sin_cos(q);
            [s, c, q]
        };
        Sample {
            fields: vec![1.0; fields],
            joints: moving.iter().map(joint).collect(),
            pose: Vec::new(),
        }
    }

    /// The pose that is to be reached becomes that of the positions.
    fn reach(&mut self, axes: &Numeric<'_>) {
        let places = axes.at(self);
        let pose = &places[places.len() - 12..];
        self.pose = pose.to_vec();
    }
}

impl Branches<'_> {
    /// Takes the steps from one on, and hands each solution to `then` with the number of its branch.
    fn follow(
        &self,
        point: &mut Sample,
        step: usize,
        index: usize,
        then: &mut dyn FnMut(&mut Sample, usize),
    ) {
        let Some(&current) = self.plan.steps.get(step) else {
            return then(point, index);
        };
        let outputs = self.equations.at(point);
        let coefficients = &outputs[self.plan.outputs_of(step)];
        // Seven joints, which alone have directions, are not sampled.
        let (joint, roots) = match current {
            Step::Joint(joint, rule) => (joint, roots(rule, coefficients)),
            Step::Direction(_) | Step::Condition => {
                return self.follow(point, step + 1, index, then);
            }
        };
        let place = self.parts.iter().position(|(one, _)| *one == joint);
        for (k, root) in roots.into_iter().enumerate() {
            if root.iter().all(|number| number.is_finite()) {
                point.joints[joint] = root;
                let bit = place.map_or(0, |place| k << place);
                self.follow(point, step + 1, index | bit, then);
            }
        }
    }
}

/// The roots of an equation, each as sine, cosine and position; not finite if there are none.
fn roots(rule: Rule, coefficients: &[f64]) -> Vec<[f64; 3]> {
    let unit = |s: f64, c: f64| {
        let length = (s * s + c * c).sqrt();
        [s / length, c / length, 0.0]
    };
    match (rule, coefficients) {
        (Rule::Turn, &[cosine, sine, ..]) => vec![unit(sine, cosine)],
        (Rule::Turns, &[a, b, c, discriminant, _]) => {
            let both = [discriminant.sqrt(), -discriminant.sqrt()];
            both.map(|root| unit(b * c + a * root, a * c - b * root))
                .to_vec()
        }
        (Rule::TurnsOfLine, &[a, b, c, u, v, w, size]) => {
            let along = size.sqrt().copysign(a * u + b * v - c * w);
            let [a, b, c] = [a + along * u, b + along * v, c + along * w];
            roots(Rule::Turns, &[a, b, c, a * a + b * b - c * c, size])
        }
        (Rule::Slides, &[b, discriminant, _]) => {
            let both = [discriminant.sqrt(), -discriminant.sqrt()];
            both.map(|root| [0.0, 1.0, b + root]).to_vec()
        }
        (_, &[d, ..]) => vec![[0.0, 1.0, d]],
        (_, []) => Vec::new(),
    }
}
