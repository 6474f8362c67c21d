//! The rows and bodies of a table in the words of the macro.

use dynamics_codegen::geometry::Body;
use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::{
    Body as Fixed, Carrier, Convention, JointType, Row as Joint, Value,
};

use super::node::{Entries, Node, entry, list, nodes, unless_empty, unless_zero, without_zeros};
use super::parameters::Parameters;
use super::table::Row;

/// A row.
pub(super) struct Line<'a> {
    pub(super) name: String,
    /// The row of the joint; none where a row is only there to stand still.
    pub(super) joint: Option<&'a Joint>,
    /// Where the joint stands still.
    pub(super) locked: Option<Node>,
    /// The link that carries it.
    pub(super) on: Carrier,
    /// Where it begins, the four parameters and the body, as far as they are not zero.
    pub(super) cells: Entries,
}

impl<'a> Line<'a> {
    /// A row that was found.
    pub(super) fn found(convention: Convention, row: &Row<'a>, name: String) -> Self {
        let Parameters { a, alpha, d, theta } = &row.parameters;
        let parameters = [a.into(), alpha.into(), d.into(), theta.into()];
        let at = row.at.as_ref().map(|(xyz, rpy)| [nodes(xyz), nodes(rpy)]);
        let Body { mass, com, inertia } = &row.body;
        let joint = row.joint.map(|joint| joint.row);
        Line {
            name,
            joint,
            locked: joint.is_none().then_some(Node::Number(Rational::ZERO)),
            on: row.on,
            cells: geometry(convention, at, parameters, (mass, com, inertia)),
        }
    }

    /// A row that was read. The row of a table begins at one place.
    pub(super) fn as_written(convention: Convention, row: &'a Joint) -> Self {
        let parameters = [&row.a, &row.alpha, &row.d, &row.theta].map(Node::from);
        let at = row.at.first().map(|at| [nodes(&at.xyz), nodes(&at.rpy)]);
        let body = (&row.mass, &row.com, &row.inertia);
        Line {
            name: row.name.clone(),
            joint: Some(row),
            locked: row.locked.as_ref().map(Node::from),
            on: row.on,
            cells: geometry(convention, at, parameters, body),
        }
    }

    /// All cells. `on` is the link that carries the row, where that is not the one above.
    pub(super) fn into_cells(self, on: Option<&str>) -> Entries {
        let joint_type = match self.joint.map(|joint| joint.joint_type) {
            Some(JointType::Prismatic) => "prismatic",
            _ => "revolute",
        };
        let mut cells = vec![entry("name", &*self.name), entry("type", joint_type)];
        cells.extend(on.map(|on| entry("on", on)));
        cells.extend(self.cells);
        cells.extend(self.joint.into_iter().flat_map(joint_cells));
        cells
    }
}

/// Where a row begins on the link that carries it. On a modified table a turn about z and a step along z have cells of
/// their own.
fn beginning(convention: Convention, [xyz, rpy]: [[Node; 3]; 2]) -> Entries {
    let others = [&xyz[0], &xyz[1], &rpy[0], &rpy[1]];
    if convention == Convention::Modified && others.into_iter().all(Node::is_zero) {
        let ([.., b], [.., gamma]) = (xyz, rpy);
        return without_zeros(["gamma", "b"], [gamma, b]);
    }
    let place = without_zeros(
        ["xyz", "rpy"],
        [xyz, rpy].map(|list| Node::List(list.into())),
    );
    unless_empty("at", place).into_iter().collect()
}

/// A base that moves, and its body.
pub(super) fn floating<'n, X>(mass: Node, com: Node, inertia: &'n [X; 6]) -> Entries
where
    Node: From<&'n X>,
{
    let mut entries = vec![entry("floating", Node::Yes), entry("mass", mass)];
    entries.extend(unless_zero("com", com));
    entries.extend(tensor(inertia));
    entries
}

/// The body of a frame or of the tool.
pub(super) fn fixed(body: &Fixed) -> Entries {
    let mut entries = vec![entry("mass", &body.mass), entry("com", list(&body.com))];
    entries.extend(tensor(&body.inertia));
    entries
}

/// Where a row begins, its parameters and its body, as far as they are not zero.
fn geometry<'n, X>(
    convention: Convention,
    at: Option<[[Node; 3]; 2]>,
    parameters: [Node; 4],
    (mass, com, inertia): (&'n X, &'n [X; 3], &'n [X; 6]),
) -> Entries
where
    Node: From<&'n X>,
{
    let mut cells = at.map_or(Entries::new(), |at| beginning(convention, at));
    cells.extend(without_zeros(["a", "alpha", "d", "theta"], parameters));
    let (mass, inertia) = (Node::from(mass), tensor(inertia));
    // A mass of zero is written where a tensor might be taken for one without its mass.
    if !mass.is_zero() || inertia.is_some() {
        cells.push(entry("mass", mass));
    }
    cells.extend(unless_zero("com", list(com)));
    cells.extend(inertia);
    cells
}

/// The entries of a tensor that are not zero.
fn tensor<'n, X>(inertia: &'n [X; 6]) -> Option<(String, Node)>
where
    Node: From<&'n X>,
{
    let entries = inertia.each_ref().map(Node::from);
    unless_empty("inertia", without_zeros(TENSOR, entries))
}

pub(super) const TENSOR: [&str; 6] = ["xx", "yy", "zz", "xy", "yz", "xz"];

// Each cell is written by `Line::as_written` or by `joint_cells`.
const _: () = assert!(Joint::CELLS == 11);

/// The motor, friction, spring and limits of a joint.
fn joint_cells(joint: &Joint) -> Entries {
    let named = |word, x: &Value| unless_zero(word, x.into());
    let pair =
        |word, [(a, x), (b, y)]: [(&str, &Value); 2]| entry(word, vec![entry(a, x), entry(b, y)]);
    let mut cells = Vec::new();
    if joint.has_motor() {
        let (inertia, ratio) = (&joint.motor_inertia, &joint.gear_ratio);
        cells.push(pair("motor", [("inertia", inertia), ("gear_ratio", ratio)]));
    }
    let mut friction: Entries = named("viscous", &joint.viscous).into_iter().collect();
    let [positive, negative] = &joint.coulomb;
    if positive == negative {
        friction.extend(named("coulomb", positive));
    } else {
        let directions = [("positive", positive), ("negative", negative)];
        friction.push(pair("coulomb", directions));
    }
    if let Some(of) = &joint.stribeck {
        let entries = [("static", &of.friction), ("velocity", &of.velocity)];
        friction.push(pair("stribeck", entries));
    }
    cells.extend(unless_empty("friction", friction));
    if let Some(spring) = &joint.spring {
        let mut entries = vec![entry("stiffness", &spring.stiffness)];
        entries.extend(named("rest", &spring.rest));
        cells.push(entry("spring", entries));
    }
    if let Some(limits) = &joint.limits {
        cells.push(entry("limits", list(limits)));
    }
    let greatest = [
        ("torque_limit", &joint.torque_limit),
        ("velocity_limit", &joint.velocity_limit),
    ];
    for (word, limit) in greatest {
        cells.extend(limit.as_ref().map(|limit| entry(word, limit)));
    }
    cells
}
