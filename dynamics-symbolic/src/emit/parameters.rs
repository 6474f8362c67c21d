//! The base parameters as formulas in the standard parameters of the links.

use super::polynomial::{Polynomial, Polynomials};
use crate::derive::base::{Geometry, LinkGeometry, Observed, dependent, geometry, group, observed};
use crate::derive::symbols::Symbols;
use crate::exact::{bit_length, negate_if};
use crate::expr::{Expr, Graph};
use crate::linear::Vector3;
use crate::mechanism::Mechanism;
use crate::program::{Operand, Output};
use crate::robot::{Convention, Grouping, JointType, Parameter, Robot, Row, Symbol};
use crate::simplify::Network;
use crate::spatial::{AxisMotion, Body, Place, Turn};

/// A longer formula is written in steps.
const LONGEST: usize = 250;

/// Bits of the longest fraction that a formula shows, 40 digits: other coefficients are shown as decimals.
const MOST_BITS_READ: usize = 128;

/// The base parameters of a robot, in the order of the regressor's columns.
pub struct BaseParameters {
    /// Each as a formula in the standard parameters of the links.
    pub formulas: Vec<String>,
    /// Sums and numbers of couplings that stand in the formulas, as `name = formula`.
    pub steps: Vec<String>,
    /// The meaning of the names.
    pub legend: String,
}

impl BaseParameters {
    /// The base parameters of a robot.
    pub fn new(robot: &Robot) -> Self {
        let observed = Observed::of(&robot.into());
        let expanded = Formulas::new(robot, &observed, false);
        let in_steps = || Formulas::new(robot, &observed, true).expect("steps are never too long");
        let Formulas {
            columns,
            steps,
            coefficients,
        } = expanded.unwrap_or_else(in_steps);
        let steps = steps.into_iter().chain(coefficients);
        BaseParameters {
            formulas: columns,
            steps: steps
                .map(|(name, formula)| format!("{name} = {formula}"))
                .collect(),
            legend: legend(robot),
        }
    }
}

/// The first term of each base parameter.
pub fn base_parameter_names(robot: &Robot) -> Vec<String> {
    // The links of a base that moves come first: its body has the number 0.
    let of_base = robot.freedoms().base;
    let columns = observed(robot).into_iter();
    columns
        .map(|(i, parameter)| parameter.name(i + 1 - of_base))
        .collect()
}

/// The formulas of the base parameters, and what the names in them mean: lines of documentation.
pub(super) fn lines(robot: &Robot) -> Vec<String> {
    let BaseParameters {
        formulas,
        steps,
        legend,
    } = BaseParameters::new(robot);
    let mut lines = [" The base parameters:", "", " ```text"]
        .map(str::to_owned)
        .to_vec();
    let columns = formulas.iter().enumerate();
    lines.extend(columns.map(|(k, formula)| format!(" {:3}  {formula}", k + 1)));
    let mut steps = steps.iter().map(|step| format!("      {step}"));
    if let Some(first) = steps.next() {
        lines.extend([" where".to_owned(), first]);
        lines.extend(steps);
    }
    lines.extend([" ```".to_owned(), String::new()]);
    lines.extend([format!(" {legend}"), String::new()]);
    lines
}

/// The meaning of the names.
fn legend(robot: &Robot) -> String {
    let is_mounted = robot.rows.iter().any(|row| row.mount.is_some());
    let frame = match robot.convention {
        Convention::Modified if is_mounted => {
            "at the origin of the link frame of joint i in the file, turned so that its z axis is that of the joint"
        }
        Convention::Modified => "the link frame i of the table",
        Convention::Standard => {
            "the link frame i of the table before its factors Tx(a) Rx(alpha): its origin and its z axis are on \
             the axis of joint i"
        }
    };
    let cells = cells(robot);
    let shown_if = |holds: bool, text: &'static str| if holds { text } else { "" };
    let motor = shown_if(
        robot.rows.iter().any(|row| row.has_motor()),
        "; Ii (kg m^2 or kg) is gear_ratio^2 times the inertia of motor i",
    );
    let is_locked = robot.rows.iter().any(|row| row.locked.is_some());
    let mut joint_types = robot.rows.iter().map(|row| row.joint_type);
    let slides = joint_types.any(|joint_type| joint_type == JointType::Prismatic);
    let turn = shown_if(
        (slides || is_locked) && !is_mounted,
        ", sti, cti of its theta",
    );
    let position = if is_mounted {
        "; where joint i is locked, di or the angle of sti and cti is its position"
    } else {
        "; where joint i is locked, its position is added to theta or d"
    };
    let locked = shown_if(is_locked, position);
    let base = shown_if(robot.floating().is_some(), "; frame 0 is that of the base");
    let coupled = shown_if(
        robot.is_coupled(),
        ". Links of joints that follow others have parameters of their own as far as the forces depend on \
         each; the others are combined into sums",
    );
    format!(
        "Jixx to Jizz (kg m^2) are the entries of link i's inertia tensor about the origin of frame i, hix to hiz \
         (kg m) its first moments mass * com from there, mi (kg) its mass{motor}. Frame i is {frame}{base}. \
         {cells}{turn}{locked}{coupled}."
    )
}

/// The meaning of the names of what is between the axes of joints.
fn cells(robot: &Robot) -> String {
    let before = if robot.is_serial() {
        "frame i - 1"
    } else {
        "the frame of the joint that carries joint i"
    };
    let places = format!(
        "xi, yi, zi are its origin in {before}, si_k, ci_k sine and cosine of the k-th angle between the two that is no \
         quarter turn"
    );
    let of_table = "ai, di are cells of row i, sai, cai sine and cosine of its alpha";
    let is_mounted = robot.rows.iter().any(|row| row.mount.is_some());
    if is_mounted {
        places
    } else if robot.rows.iter().any(is_placed) {
        format!("{of_table}; if row i says where it begins, {places}")
    } else {
        of_table.to_owned()
    }
}

/// Whether more than the cells of a table is between the row's joint and the one that carries it.
fn is_placed(row: &Row) -> bool {
    row.mount.is_some() || !row.at.is_empty()
}

/// The formulas as text.
struct Formulas {
    columns: Vec<String>,
    /// Sums that the columns read: parameters with an apostrophe, those that moved inwards to the link included.
    steps: Vec<(String, String)>,
    /// Numbers that couplings lead to.
    coefficients: Vec<(String, String)>,
}

impl Formulas {
    /// In the links' own parameters alone, which is `None` if that is too long to read; or in parameters with an
    /// apostrophe.
    fn new(robot: &Robot, observed: &Observed, in_steps: bool) -> Option<Self> {
        let all = Polynomials::default();
        let couplings = Couplings::new(&all, robot, observed);
        let (columns, steps) = columns(&all, robot, &observed.grouping, in_steps);
        let (columns, coefficients) = couplings.applied(observed, columns);
        let variables = columns.iter().flat_map(|column| column.variables());
        let mut used: Vec<_> = variables.collect();
        let mut needed = Vec::new();
        for (name, formula) in steps.into_iter().rev() {
            if used.contains(&name) {
                used.extend(formula.variables());
                needed.push((name, formula.text()));
            }
        }
        let columns: Vec<_> = columns.iter().map(|column| column.text()).collect();
        let is_short = || columns.iter().all(|text| text.len() <= LONGEST) && !all.overflow();
        (in_steps || is_short()).then_some(Formulas {
            columns,
            steps: needed,
            coefficients,
        })
    }
}

type Step<'p> = (String, Polynomial<'p>);

/// The base parameters as polynomials and, where they are wanted, the steps, from the tip inwards.
fn columns<'p>(
    all: &'p Polynomials,
    robot: &Robot,
    grouping: &Grouping,
    in_steps: bool,
) -> (Vec<Polynomial<'p>>, Vec<Step<'p>>) {
    let geometry = named_geometry(all, robot);
    let links = geometry.tree.len();
    // The last joint of a base that moves carries its body, which has the number 0; the joints before carry nothing.
    let number = |i: usize| (i + 1).checked_sub(robot.freedoms().base);
    let variables = |i| match number(i) {
        Some(number) => Parameter::ALL.map(|parameter| all.variable(parameter.name(number))),
        None => Parameter::ALL.map(|_| all.number(0)),
    };
    let own: Vec<_> = (0..links).map(variables).collect();
    let (mut columns, mut steps) = (vec![Vec::new(); links], Vec::new());
    let none = Body::splat(geometry.zero);
    geometry.tree.inward(none, Body::joined, |i, outer| {
        let mut whole = own[i];
        for (k, &moved) in outer.parameters().iter().enumerate() {
            if moved.is_zero() {
                continue;
            }
            whole[k] = whole[k] + moved;
            if let (true, Some(number)) = (in_steps, number(i)) {
                let name = format!("{}'", Parameter::ALL[k].name(number));
                let sum = core::mem::replace(&mut whole[k], all.variable(name.clone()));
                steps.push((name, sum));
            }
        }
        let [body @ .., motor] = whole;
        let whole = (Body::from_parameters(body), motor);
        let moved = group(grouping, &geometry, i, whole);
        columns[i] = moved.kept;
        moved.inward
    });
    (columns.concat(), steps)
}

/// The combinations of base parameters that joints lead to because they follow others.
struct Couplings<'p> {
    /// A column, and how much of it is added to another one.
    terms: Vec<(usize, usize, Polynomial<'p>)>,
    /// The numbers in these, by their names.
    coefficients: Vec<(String, String)>,
}

impl<'p> Couplings<'p> {
    fn new(all: &'p Polynomials, robot: &Robot, observed: &Observed) -> Self {
        let mut couplings = Couplings {
            terms: Vec::new(),
            coefficients: Vec::new(),
        };
        if !robot.is_coupled() {
            return couplings;
        }
        let graph = Graph::new();
        let arm = Mechanism::from(robot);
        let mut symbols = Symbols::new(&graph, &arm);
        let mut coefficients = Coefficients {
            all,
            known: Vec::new(),
        };
        for dependent in dependent(&mut symbols, &observed.grouping) {
            for (column, coefficient) in dependent.terms {
                let coefficient = coefficients.name(coefficient);
                let term = (dependent.column, column, coefficient);
                couplings.terms.push(term);
            }
        }
        couplings.coefficients = coefficients.values(symbols.meanings());
        couplings
    }

    /// The columns that remain, and the values of the numbers in them.
    fn applied(
        self,
        observed: &Observed,
        mut columns: Vec<Polynomial<'p>>,
    ) -> (Vec<Polynomial<'p>>, Vec<(String, String)>) {
        for (from, to, coefficient) in self.terms {
            columns[to] = columns[to] + coefficient * columns[from];
        }
        let kept = observed.kept.iter().map(|&column| columns[column]);
        (kept.collect(), self.coefficients)
    }
}

/// Coefficients that are no short rational numbers have names: k1, k2, ...
struct Coefficients<'p, 'g> {
    all: &'p Polynomials,
    known: Vec<(Expr<'g>, Polynomial<'p>)>,
}

impl<'p, 'g> Coefficients<'p, 'g> {
    fn name(&mut self, coefficient: Expr<'g>) -> Polynomial<'p> {
        let rational = coefficient.as_rational();
        if let Some(x) = rational.filter(|x| bit_length(x) <= MOST_BITS_READ) {
            return self.all.rational(x);
        }
        for &(known, name) in &self.known {
            if [known, -known].contains(&coefficient) {
                return negate_if(name, known != coefficient);
            }
        }
        let name = self.all.variable(format!("k{}", self.known.len() + 1));
        self.known.push((coefficient, name));
        name
    }

    /// The names and values; a number that depends on fields has no value.
    fn values(&self, meanings: &[Symbol]) -> Vec<(String, String)> {
        let Some((first, _)) = self.known.first() else {
            return Vec::new();
        };
        let outputs: Vec<_> = self.known.iter().map(|(x, _)| x.edge()).collect();
        let program = Network::new(first.graph, &outputs).program(meanings);
        let constants = program.rounded_constants();
        let value = |output: &Output| match output.operand {
            Operand::Constant(id) => negate_if(constants[id.index()], output.negative).to_string(),
            _ => "a number that depends on the fields".to_owned(),
        };
        let names = (1..).map(|number| format!("k{number}"));
        names.zip(program.outputs.iter().map(value)).collect()
    }
}

/// The geometry with the names of cells in place of their numbers, and 0 and +-1 as they are.
fn named_geometry<'p>(all: &'p Polynomials, robot: &Robot) -> Geometry<Polynomial<'p>> {
    let graph = Graph::new();
    let arm = Mechanism::from(robot);
    let mut symbols = Symbols::new(&graph, &arm);
    let cell = |value: Expr<'_>, name: String| {
        if value.is_zero() {
            all.number(0)
        } else {
            all.variable(name)
        }
    };
    let one = graph.one();
    let known = |value: Expr<'_>| match value {
        x if x.is_zero() => Some(all.number(0)),
        x if x == one => Some(all.number(1)),
        x if x == -one => Some(all.number(-1)),
        _ => None,
    };
    let turn = |turn: Turn<Expr<'_>>, name: String| {
        let (s, c) = all.circle([format!("s{name}"), format!("c{name}")]);
        Turn {
            s: known(turn.s).unwrap_or(s),
            c: known(turn.c).unwrap_or(c),
        }
    };
    let cells = geometry(&mut symbols, &arm);
    let of_base = robot.freedoms().base;
    let links = cells.links.into_iter().enumerate().map(|(i, link)| {
        let Some(i) = i.checked_sub(of_base) else {
            // Along the axes of the base or about them: quarter turns at its origin.
            return link.map(|value| known(value).expect("0, 1 or -1"));
        };
        // The row that has the a and the alpha before the axis of joint i + 1.
        let row = match robot.convention {
            Convention::Standard => robot.parent(i).map_or(0, |parent| parent + 1),
            Convention::Modified => i + 1,
        };
        let is_mounted = is_placed(&robot.rows[i]);
        let name = |axis: &str| {
            if is_mounted {
                format!("{axis}{}", i + 1)
            } else {
                format!("a{row}")
            }
        };
        let [x, y, z] = link.before.origin.0;
        let origin = Vector3::new(cell(x, name("x")), cell(y, name("y")), cell(z, name("z")));
        let mut angles = 0;
        let turns = link.before.turns.map(|step| {
            if !is_mounted {
                return turn(step, format!("a{row}"));
            }
            // Quarter turns have no names.
            angles += usize::from(!step.s.is_zero() && !step.c.is_zero());
            turn(step, format!("{}_{angles}", i + 1))
        });
        LinkGeometry {
            axis_motion: link.axis_motion,
            stands: link.stands,
            is_of_base: link.is_of_base,
            before: Place { origin, turns },
            d: cell(link.d, format!("d{}", i + 1)),
            turn: match link.axis_motion {
                AxisMotion::Turns if !link.stands => Turn {
                    s: all.number(0),
                    c: all.number(1),
                },
                _ => turn(link.turn, format!("t{}", i + 1)),
            },
        }
    });
    Geometry {
        zero: all.number(0),
        one: all.number(1),
        links: links.collect(),
        tree: cells.tree,
    }
}
