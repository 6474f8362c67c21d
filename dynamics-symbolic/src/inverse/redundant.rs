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

use super::chain::{Link, between};
use super::moves::{Move, Path};
use super::plan::{ELBOW, Step};
use super::rules::{Equation, distance};
use super::view::{Points, Unknown, View};
use crate::derive::symbols::Symbols;
use crate::expr::Expr;
use crate::linear::{Matrix3, Vector3};
use crate::spatial::AxisMotion;
use std::collections::BTreeSet;

type Vector<'g> = Vector3<Expr<'g>>;

/// Joints of the shoulder, and of the wrist.
const SHOULDER: core::ops::Range<usize> = 0..3;
const WRIST: core::ops::Range<usize> = 4..7;

/// How many links a chain has up to the third joint, and the way to the frame behind that.
type Part<'g> = (usize, Path<'g>);

/// Adds the steps that lead to the fourth joint and to the directions of the line and of the elbow. Returns the part of the arm that
/// these determine, and the numbers of `Plan::elbow`.
pub(super) fn shoulder<'g>(
    symbols: &mut Symbols<'g>,
    chain: &[Link<'g>],
    view: &View<'g>,
    found: &mut Vec<Equation<'g>>,
) -> Option<(Part<'g>, Vec<Expr<'g>>)> {
    let turns = |joint: &Unknown| joint.axis_motion == AxisMotion::Turns;
    if !view.joints.iter().all(turns) {
        return None;
    }
    let (Points::One(s), Points::One(p)) = (view.points(SHOULDER), view.points(WRIST)) else {
        return None;
    };
    let elbow = distance(view, 3)?;
    // In the frame before the first joint.
    let wrist = view.way(4, 6).inverse().point(p);
    let line = view.target.point(wrist) - s;
    let links = chain.iter().enumerate();
    let moving = links.filter(|(_, link)| link.joint.is_some());
    let moving: Vec<_> = moving.collect();
    let [(_, one), (_, two), (third, three), (_, fourth), ..] = moving[..] else {
        return None;
    };
    let link = Link3::new(view, fourth.motion, s, p)?;
    let [first, second] = [&view.links[0], &view.links[1]];
    let turn = |link: &Link<'g>| Path(vec![link.motion]);
    let to_third = turn(one)
        .then(first)
        .then(&turn(two))
        .then(second)
        .then(&turn(three));
    let seen = [link.line, link.elbow, link.axis].map(|v| to_third.direction(v).0);
    let seen = seen
        .into_iter()
        .flatten()
        .chain([link.elbow.dot(link.elbow)])
        .collect();
    let rotation = rotation(symbols, view, line, &link, found);
    // The first two directions, in the world, read no joint.
    found.insert(2, elbow);
    let origin = s - rotation.apply(link.shoulder);
    let first = &between(chain, &BTreeSet::new())[0];
    let behind_third = first.then(&Path(vec![Move { rotation, origin }]));
    Some(((third + 1, behind_third), seen))
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
        fourth: Move<'g>,
        shoulder: Vector<'g>,
        wrist: Vector<'g>,
    ) -> Option<Self> {
        let shoulder = view.way(0, 2).inverse().point(shoulder);
        let to_axis = &view.links[2];
        let to_wrist = to_axis.then(&Path(vec![fourth])).then(&view.links[3]);
        let axis = to_axis.direction(view.z());
        let apart = to_axis.point(view.origin()) - shoulder;
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

/// R, by the steps for the directions of the line and from it to the elbow, first in the world and then in the link.
///
/// A wrist in the shoulder has no line: any direction will do, if the elbow's is at a right angle to it.
fn rotation<'g>(
    symbols: &mut Symbols<'g>,
    view: &View<'g>,
    line: Vector<'g>,
    link: &Link3<'g>,
    found: &mut Vec<Equation<'g>>,
) -> Matrix3<Expr<'g>> {
    let [sine, cosine] = [ELBOW, ELBOW + 1].map(|place| symbols.behind_target(place));
    let mut place = ELBOW + 2;
    let mut direction = |v: Vector<'g>, other: Vector<'g>, size: Expr<'g>| {
        let step = Step::Direction(place);
        let coefficients = [&v.0[..], &other.0[..], &[size]].concat();
        found.push(Equation {
            step,
            coefficients,
            loses_digits: false,
        });
        let numbers = [0, 1, 2].map(|k| match v[k].is_zero() && other[k].is_zero() {
            true => v[k],
            false => symbols.behind_target(place + k),
        });
        place += 3;
        Vector3(numbers)
    };
    let across = |v: Vector<'g>, line: Vector<'g>| v - line * v.dot(line);
    let ([x, _, z], one) = (view.axes(), view.graph.one());
    let size = link.elbow.dot(link.elbow);
    let line = direction(line, z, size);
    // Once more at right angles: of a vector that is nearly along the line this part is small, and its rounding is not.
    let start = across(direction(across(z, line), across(x, line), one), line);
    let of_link = direction(link.line, link.axis.cross(link.elbow), size);
    let beside = link.axis.cross(of_link);
    let near = across(
        direction(across(link.elbow, of_link), beside, size),
        of_link,
    );
    let e = start * cosine + line.cross(start) * sine;
    let [beside, beside_link] = [line.cross(e), of_link.cross(near)];
    let entry =
        |i: usize, j: usize| e[i] * near[j] + line[i] * of_link[j] + beside[i] * beside_link[j];
    Matrix3([0, 1, 2].map(|i| [0, 1, 2].map(|j| entry(i, j))))
}
