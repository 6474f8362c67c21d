//! What each base parameter is, as a formula in the standard parameters of the links.

use super::polynomial::{Polynomial, Polynomials};
use crate::derive::base::{LinkGeometry, geometry, group};
use crate::derive::symbols::Symbols;
use crate::expr::{Expr, Graph};
use crate::robot::{Convention, Grouping, JointType, Parameter, Robot};
use crate::spatial::{Body, Turn};

/// A longer formula is written in steps.
const LONGEST: usize = 250;

/// The formulas of the base parameters, and what the names in them mean: lines of documentation.
pub(super) fn lines(robot: &Robot) -> Vec<String> {
    let grouping = Grouping::of(robot);
    let formulas = Formulas::expanded(robot, &grouping)
        .unwrap_or_else(|| Formulas::in_steps(robot, &grouping));
    let mut lines = vec![" The base parameters:".to_owned(), String::new()];
    lines.push(" ```text".to_owned());
    let columns = formulas.columns.iter().enumerate();
    lines.extend(columns.map(|(k, formula)| format!(" {:3}  {formula}", k + 1)));
    if !formulas.steps.is_empty() {
        lines.push(" where".to_owned());
        let step = |(name, formula)| format!("      {name} = {formula}");
        lines.extend(formulas.steps.into_iter().map(step));
    }
    lines.push(" ```".to_owned());
    lines.push(String::new());
    lines.push(format!(" {}", legend(robot)));
    lines.push(String::new());
    lines
}

/// The meaning of the names.
fn legend(robot: &Robot) -> String {
    let frame = match robot.convention {
        Convention::Modified => "the link frame i of the table",
        Convention::Standard => {
            "the link frame i of the table before its factors Tx(a) Rx(alpha): its origin and its z axis are on \
             the axis of joint i"
        }
    };
    let motor = match robot.rows.iter().any(|row| row.has_motor()) {
        true => "; Ii (kg m^2 or kg) is gear_ratio^2 times the inertia of motor i",
        false => "",
    };
    let slides = |row: &crate::robot::Row| row.joint_type == JointType::Prismatic;
    let is_locked = |row: &crate::robot::Row| row.locked.is_some();
    let turn = match robot.rows.iter().any(slides) || robot.rows.iter().any(is_locked) {
        true => ", sti, cti of its theta",
        false => "",
    };
    let turn = match robot.rows.iter().any(is_locked) {
        true => format!("{turn}; where joint i is locked, its position is added to theta or d"),
        false => turn.to_owned(),
    };
    let coupled = match robot.is_coupled() {
        true => {
            " They are those of the arm in which the joints that follow others move by themselves: what they \
             multiply may be dependent."
        }
        false => "",
    };
    format!(
        "Jixx to Jizz (kg m^2) are the entries of link i's inertia tensor about the origin of frame i, hix to hiz \
         (kg m) its first moments mass * com from there, mi (kg) its mass{motor}. Frame i is {frame}. ai, di are cells of row i, \
         sai, cai sine and cosine of its alpha{turn}.{coupled}"
    )
}

/// The formulas as text.
struct Formulas {
    columns: Vec<String>,
    /// Sums that the columns read: parameters with an apostrophe, those that moved inwards to the
    /// link included.
    steps: Vec<(String, String)>,
}

impl Formulas {
    /// In the links' own parameters alone; `None` where that is too long to read.
    fn expanded(robot: &Robot, grouping: &Grouping) -> Option<Self> {
        let all = Polynomials::default();
        let (columns, _) = columns(&all, robot, grouping, false);
        let columns: Vec<_> = columns.iter().map(|column| column.text()).collect();
        let is_readable = columns.iter().all(|text| text.len() <= LONGEST);
        (is_readable && !all.overflow()).then_some(Formulas {
            columns,
            steps: Vec::new(),
        })
    }

    /// In parameters with an apostrophe.
    fn in_steps(robot: &Robot, grouping: &Grouping) -> Self {
        let all = Polynomials::default();
        let (columns, steps) = columns(&all, robot, grouping, true);
        let mut used: Vec<_> = columns
            .iter()
            .flat_map(|column| column.variables())
            .collect();
        let mut needed = Vec::new();
        for (name, formula) in steps.into_iter().rev() {
            if used.contains(&name) {
                used.extend(formula.variables());
                needed.push((name, formula.text()));
            }
        }
        Formulas {
            columns: columns.iter().map(|column| column.text()).collect(),
            steps: needed,
        }
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
    let (zero, one) = (all.number(0), all.number(1));
    let links = named_geometry(all, robot);
    let own: Vec<[Polynomial<'p>; 11]> = (1..=links.len())
        .map(|i| Parameter::ALL.map(|parameter| all.variable(parameter.name(i))))
        .collect();
    let (mut columns, mut steps) = (Vec::new(), Vec::new());
    let mut carried = Body::splat(zero);
    for i in (0..links.len()).rev() {
        let mut whole = own[i];
        for (k, &moved) in carried.parameters().iter().enumerate() {
            if moved.is_zero() {
                continue;
            }
            whole[k] = whole[k] + moved;
            if in_steps {
                let name = format!("{}'", Parameter::ALL[k].name(i + 1));
                let sum = core::mem::replace(&mut whole[k], all.variable(name.clone()));
                steps.push((name, sum));
            }
        }
        let [body @ .., motor] = whole;
        let whole = (Body::from_parameters(body), motor);
        let moved = group(grouping, &links, i, whole, (zero, one));
        columns.push(moved.kept);
        carried = moved.inward;
    }
    columns.reverse();
    (columns.concat(), steps)
}

/// The geometry with the names of cells in place of their numbers, and 0 and +-1 as they are.
fn named_geometry<'p>(all: &'p Polynomials, robot: &Robot) -> Vec<LinkGeometry<Polynomial<'p>>> {
    let graph = Graph::new();
    let mut symbols = Symbols::new(&graph, robot);
    let cell = |value: Expr<'_>, name: String| match value.is_zero() {
        true => all.number(0),
        false => all.variable(name),
    };
    let one = graph.one();
    let turn = |turn: Turn<Expr<'_>>, letter: &str, row: usize| {
        let (s, c) = all.circle([format!("s{letter}{row}"), format!("c{letter}{row}")]);
        let known = |value: Expr<'_>, named| match value {
            x if x.is_zero() => all.number(0),
            x if x == one => all.number(1),
            x if x == -one => all.number(-1),
            _ => named,
        };
        Turn {
            s: known(turn.s, s),
            c: known(turn.c, c),
        }
    };
    let links = geometry(&mut symbols, robot).into_iter().enumerate();
    links
        .map(|(i, link)| {
            // The row that has the a and the alpha between the axes of joints i and i + 1.
            let row = match robot.convention {
                Convention::Standard => i,
                Convention::Modified => i + 1,
            };
            LinkGeometry {
                joint_type: link.joint_type,
                locked: link.locked,
                a: cell(link.a, format!("a{row}")),
                d: cell(link.d, format!("d{}", i + 1)),
                twist: turn(link.twist, "a", row),
                turn: match link.joint_type {
                    JointType::Revolute if !link.locked => Turn {
                        s: all.number(0),
                        c: all.number(1),
                    },
                    _ => turn(link.turn, "t", i + 1),
                },
            }
        })
        .collect()
}
