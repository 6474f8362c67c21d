//! Seven joints with a spherical shoulder and a spherical wrist, and the angle of the elbow about the line between these.
//!
//! The distance from shoulder S to wrist W is that of the pose, and gives the fourth joint. The third link then stands so that
//! the line SW is where it has to be, and the elbow E in the half plane that the angle names. With the unit vectors w
//! along the line and e from it to the elbow, in the world and in the link, the link's rotation is
//!
//!   R = w w_l' + e e_l' + (w x e) (w_l x e_l)'
//!
//! and it is solved for the first three joints; the last three follow from the pose. The angle is counted about w from the half
//! plane that holds the direction of axis 1 (Shimizu, Kakuya, Yoon, Kitagaki, Kosuge, Analytical inverse kinematic
//! computation for 7-DOF redundant manipulators, IEEE Transactions on Robotics 24, 2008, with the elbow in place of a joint).

use super::chain::{Link, chain_view};
use super::found::Found;
use super::moves::{Move, Path};
use super::plan::{ELBOW, Rule, Solved, Step};
use super::rules::distance;
use super::view::{Points, View};
use crate::derive::symbols::Symbols;
use crate::expr::Expr;
use crate::linear::{Matrix3, Vector3};
use crate::robot::JointType;

type Vector<'g> = Vector3<Expr<'g>>;

/// Joints of the shoulder, and of the wrist.
const SHOULDER: core::ops::Range<usize> = 0..3;
const WRIST: core::ops::Range<usize> = 4..7;

/// Adds the steps that lead to the fourth joint and to the directions of the line and of the elbow. Returns how many links the
/// chain has up to the third joint, and the way to the frame behind that.
pub(super) fn shoulder<'g>(
    symbols: &mut Symbols<'g>,
    chain: &[Link<'g>],
    pose: &Path<'g>,
    found: &mut Vec<Found<'g>>,
) -> Option<(usize, Path<'g>)> {
    let mut view = chain_view(chain, symbols.graph());
    let turns = |joint: &super::view::Unknown| joint.joint_type == JointType::Revolute;
    if view.joints.len() != 7 || !view.joints.iter().all(turns) {
        return None;
    }
    let first = fixed_before(chain);
    let last = fixed_behind(chain);
    view.target = first.inverse().then(pose).then(&last.inverse());
    let (Points::One(s), Points::One(p)) = (view.points(SHOULDER), view.points(WRIST)) else {
        return None;
    };
    let elbow = distance(&view, 3)?;
    found.push(Found {
        step: Step {
            solved: Solved::Joint(3),
            rule: elbow.rule,
        },
        coefficients: elbow.coefficients,
    });
    // In the frame before the first joint.
    let wrist = view.way(4, 6).inverse().point(p);
    let line = view.target.point(wrist) - s;
    let link = Link3::new(&view, symbols, chain, s, p)?;
    let rotation = rotation(symbols, &view, line, &link, found);
    let origin = s - rotation.apply(link.shoulder);
    let links = 1 + position_of_joint(chain, 2);
    Some((
        links,
        first.then(&Path(vec![Move::Fixed(rotation, origin)])),
    ))
}

/// The third link, in its own frame behind the third joint.
struct Link3<'g> {
    shoulder: Vector<'g>,
    /// From the shoulder to the wrist.
    line: Vector<'g>,
    /// From the shoulder to the elbow, the point of axis 4 that is nearest to it.
    elbow: Vector<'g>,
    /// The direction of axis 4.
    axis: Vector<'g>,
}

impl<'g> Link3<'g> {
    fn new(
        view: &View<'g>,
        symbols: &Symbols<'g>,
        chain: &[Link<'g>],
        shoulder: Vector<'g>,
        wrist: Vector<'g>,
    ) -> Option<Self> {
        let shoulder = view.way(0, 2).inverse().point(shoulder);
        let fourth = chain.iter().find_map(|link| match link {
            Link::Joint(joint, motion) if joint.number == 3 => Some(*motion),
            _ => None,
        })?;
        let to_axis = &view.links[2];
        let to_wrist = to_axis.then(&Path(vec![fourth])).then(&view.links[3]);
        let axis = to_axis.direction(view.z());
        let apart = to_axis.point(Vector3::splat(symbols.graph().zero())) - shoulder;
        let elbow = apart - axis * apart.dot(axis);
        let is_beside = elbow.0.iter().any(|x| !x.is_zero());
        is_beside.then(|| Link3 {
            shoulder,
            line: to_wrist.point(wrist) - shoulder,
            elbow,
            axis,
        })
    }
}

/// R, by the steps for the length of the line and for the directions from it.
fn rotation<'g>(
    symbols: &mut Symbols<'g>,
    view: &View<'g>,
    line: Vector<'g>,
    link: &Link3<'g>,
    found: &mut Vec<Found<'g>>,
) -> Matrix3<Expr<'g>> {
    let [sine, cosine] = [ELBOW, ELBOW + 1].map(|place| symbols.behind_target(place));
    let square = line.dot(line);
    let mut place = ELBOW + 2;
    let mut step = |rule: Rule, coefficients: Vec<Expr<'g>>, count: usize| {
        let numbers = (place..place + count).map(|place| symbols.behind_target(place));
        let numbers: Vec<Expr<'g>> = numbers.collect();
        let solved = Solved::Numbers(place);
        place += count;
        found.push(Found {
            step: Step { solved, rule },
            coefficients,
        });
        numbers
    };
    let length = step(Rule::Root, vec![square], 1)[0];
    // The part of a vector that is at right angles to a line, times the square of the line.
    let across = |v: Vector<'g>, line: Vector<'g>| v * line.dot(line) - line * v.dot(line);
    // Once more at right angles: of a vector that is nearly along the line this part is small, and its rounding is not.
    let mut direction = |v: Vector<'g>, other: Vector<'g>, line: Vector<'g>, size: Expr<'g>| {
        let coefficients = [&v.0[..], &other.0[..], &[size]].concat();
        let numbers = step(Rule::Direction, coefficients, 3);
        let found = Vector3::new(numbers[0], numbers[1], numbers[2]);
        found - line * (found.dot(line) / square)
    };
    let [x, _, z] = view.axes();
    let start = direction(across(z, line), across(x, line), line, square * square);
    let of_link = link.line.dot(link.line);
    let size = of_link * of_link * link.elbow.dot(link.elbow);
    let near = direction(
        across(link.elbow, link.line),
        link.axis.cross(link.line),
        link.line,
        size,
    );
    let e = start * cosine + line.cross(start) * (sine / length);
    let [beside, beside_link] = [line.cross(e), link.line.cross(near)];
    let entry = |i: usize, j: usize| {
        e[i] * near[j] + (line[i] * link.line[j] + beside[i] * beside_link[j]) / square
    };
    Matrix3([0, 1, 2].map(|i| [0, 1, 2].map(|j| entry(i, j))))
}

fn fixed_before<'g>(chain: &[Link<'g>]) -> Path<'g> {
    fixed(&chain[..position_of_joint(chain, 0)])
}

fn fixed_behind<'g>(chain: &[Link<'g>]) -> Path<'g> {
    fixed(&chain[position_of_joint(chain, 6)..])
}

fn fixed<'g>(links: &[Link<'g>]) -> Path<'g> {
    let moves = links.iter().filter_map(|link| match link {
        Link::Fixed(rotation, origin) => Some(Move::Fixed(*rotation, *origin)),
        Link::Joint(..) => None,
    });
    Path(moves.collect())
}

fn position_of_joint(chain: &[Link<'_>], number: usize) -> usize {
    let is_joint =
        |link: &Link<'_>| matches!(link, Link::Joint(joint, _) if joint.number == number);
    chain.iter().position(is_joint).unwrap_or(chain.len())
}
