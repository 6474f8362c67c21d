//! Equations in which one joint is the only unknown.
//!
//! In A Z B = L (see `view`), Z is the motion of one joint, A that of the joints before it and B that of the joints behind.
//! A point p that B does not move is at A Z p = L p. A quantity of this point that A does not change is an equation in
//! the one joint: a height over a plane, the distance from a point, or the distance from an axis. The same holds of
//! directions.
//!
//! Sources: Pieper, The kinematics of manipulators under computer control (1968), for axes that meet; Craig, Introduction to
//! Robotics, 4.5 and 4.6. Equations of these forms are those of Paden and Kahan (Murray, Li, Sastry 1994, 3.3).
//!
//! Equations that lose digits near singular poses have forms of their own (`Rule`): a distance is corrected by the
//! difference of the two vectors, the discriminant of a wrist is a cross product. `prove::inverse` takes a pose of
//! the textbook definition at random joints in the prime field, follows every branch, and asks the definition for the
//! pose at the end. Roots are in the field for every second number, so that it draws until each branch has been seen.
//! Equations are necessary, and the proof says that they are sufficient.

use super::plan::{Rule, Step};
use super::view::{Points, View, are_parallel, moved};
use crate::expr::Expr;
use crate::linear::Vector3;
use crate::spatial::AxisMotion;

type Vector<'g> = Vector3<Expr<'g>>;

/// A step with its coefficients.
pub(super) struct Equation<'g> {
    pub(super) step: Step,
    pub(super) coefficients: Vec<Expr<'g>>,
    /// Whether another equation is better: a distance in space has no digits left of one in a plane where that is small.
    pub(super) loses_digits: bool,
}

impl<'g> Equation<'g> {
    /// The equation of joint t of a view, as it moves in the equation that is no inverse.
    fn of(view: &View<'g>, t: usize, rule: Rule, mut coefficients: Vec<Expr<'g>>) -> Self {
        if view.is_inverse {
            let opposite: &[usize] = match rule {
                Rule::Turn | Rule::Turns => &[1],
                Rule::TurnsOfLine => &[1, 4],
                Rule::Slide | Rule::Slides => &[0],
            };
            for &k in opposite {
                coefficients[k] = -coefficients[k];
            }
        }
        let step = Step::Joint(view.joints[t].number, rule);
        Equation {
            step,
            coefficients,
            loses_digits: false,
        }
    }

    /// a cos q + b sin q = c for joint t, if it depends on q; `discriminant` and `size` as in [`Rule::Turns`].
    fn turns(
        view: &View<'g>,
        t: usize,
        [a, b, c]: [Expr<'g>; 3],
        discriminant: Option<Expr<'g>>,
        size: Expr<'g>,
    ) -> Option<Self> {
        let discriminant = discriminant.unwrap_or_else(|| a * a + b * b - c * c);
        let coefficients = vec![a, b, c, discriminant, size];
        let depends = !(a.is_zero() && b.is_zero());
        (depends && view.allows(&coefficients))
            .then(|| Equation::of(view, t, Rule::Turns, coefficients))
    }
}

/// A vector that stays what it is in the frame of the last joint, and the same in the frame behind the joint in question.
#[derive(Clone, Copy)]
struct Pair<'g> {
    /// Behind the joint.
    near: Vector<'g>,
    /// In the last frame, where L leads.
    far: Vector<'g>,
}

/// All equations of the joints of a view: first those with one solution.
pub(super) fn equations<'g>(view: &View<'g>) -> Vec<Equation<'g>> {
    let of_type = |axis_motion| {
        let joints = 0..view.joints.len();
        joints.filter(move |&t| view.joints[t].axis_motion == axis_motion)
    };
    let (turning, sliding) = (of_type(AxisMotion::Turns), of_type(AxisMotion::Slides));
    let front = (view.joints[0].axis_motion == AxisMotion::Turns).then_some(view);
    let single = front.and_then(first_turn).into_iter();
    let single = single.chain(sliding.clone().filter_map(|t| slide(view, t)));
    let double = turning
        .clone()
        .filter_map(|t| angle_between(view, t))
        .chain(front.and_then(front_heights))
        .chain(turning.clone().filter_map(|t| heights(view, t)))
        .chain(turning.filter_map(|t| distance(view, t)))
        .chain(front.and_then(front_distance))
        .chain(sliding.filter_map(|t| slides(view, t)));
    single.chain(double).collect()
}

/// A vector x before a turn about z, y behind it, and the square of their length.
struct Turned<'g> {
    x: Vector<'g>,
    y: Vector<'g>,
    size: Expr<'g>,
}

/// Z x = L x: the first joint turns a known direction, or a known point, to where it is. The angle from x to y about z has the
/// cosine x.y and the sine (x x y)_z, both times the square of their distance from the axis.
fn first_turn<'g>(view: &View<'g>) -> Option<Equation<'g>> {
    let Turned { x, y, size } = turned_direction(view).or_else(|| turned_point(view))?;
    let (cosine, sine) = (x[0] * y[0] + x[1] * y[1], x[0] * y[1] - x[1] * y[0]);
    let coefficients = vec![cosine, sine, beside_z(x), size];
    Some(Equation::of(view, 0, Rule::Turn, coefficients))
}

/// A direction that the joints behind the first do not turn.
fn turned_direction<'g>(view: &View<'g>) -> Option<Turned<'g>> {
    let mut all = directions_behind(view, 0).into_iter();
    let pair = all.find(|pair| !are_parallel(pair.near, view.z()))?;
    let y = view.target.direction(pair.far);
    view.allows(&y.0).then_some(Turned {
        x: pair.near,
        y,
        size: view.graph.one(),
    })
}

/// A point that the joints behind the first do not move, or move along its axis alone.
fn turned_point<'g>(view: &View<'g>) -> Option<Turned<'g>> {
    let Pair { near: x, far } = point_from(view, 0, 1, Some(view.z()))?;
    let y = view.target.point(far);
    let is_on_axis = x[0].is_zero() && x[1].is_zero();
    let size = beside_z(x) + view.span;
    (!is_on_axis && view.allows(&y.0[..2])).then_some(Turned { x, y, size })
}

/// y.(L p) = y.(A Z B p) with y at right angles to all that slides and along all that turns, except for joint t, which
/// slides by d:
/// d = (y.(L p) - y.(A B p)) / y.z
fn slide<'g>(view: &View<'g>, t: usize) -> Option<Equation<'g>> {
    let last = view.joints.len();
    (t + 1..=last).rev().find_map(|end| {
        let pair = point_from(view, t, end, None)?;
        let heights = view.heights(0..end, |i| i == t);
        let to_joint = view.way(0, t);
        let along = |y: &Vector<'g>| to_joint.inverse().direction(*y)[2];
        // The joint's own axis, as far as it is a combination of these.
        let parts = heights.iter().map(|y| *y * along(y));
        let y = parts.reduce(|sum, part| sum + part)?;
        let slope = along(&y);
        if slope.is_zero() {
            return None;
        }
        let here = to_joint.point(pair.near);
        let there = view.target.point(pair.far);
        let d = y.dot(there - here) / slope;
        view.allows(&[d])
            .then(|| Equation::of(view, t, Rule::Slide, vec![d]))
    })
}

/// y.(Z^-1 L p) = y.(B p): a height that joints right behind the first do not change, over a point that the others do not move.
///
/// y.(Z^-1 L w) = y.(B w): the direction w of a line that the others leave has digits left where p is near the first axis.
fn front_heights<'g>(view: &View<'g>) -> Option<Equation<'g>> {
    let last = view.joints.len();
    (2..=last).rev().find_map(|end| {
        let heights = view.heights(1..end, |_| false);
        let near = heights.iter().map(|y| view.links[0].direction(*y));
        let y = near.into_iter().find(|y| !are_parallel(*y, view.z()))?;
        let pair = point_from(view, 0, end, None)?;
        let v = view.target.point(pair.far);
        let equation = |near: Vector<'g>, v: Vector<'g>| {
            let height = y.dot(near);
            let (a, b) = (y[0] * v[0] + y[1] * v[1], y[0] * v[1] - y[1] * v[0]);
            [a, b, height - y[2] * v[2]]
        };
        let (of_point, size) = (equation(pair.near, v), v.dot(v) + view.span);
        let turns = Equation::turns(view, 0, of_point, None, size)?;
        let [w] = view.directions(end..last)[..] else {
            return Some(turns);
        };
        let near = view.way(0, end).direction(w);
        let far = view.way(0, last - 1).inverse().direction(near);
        let of_line = equation(near, view.target.direction(far));
        let both = [&of_point[..], &of_line, &[size]].concat();
        Some(match view.allows(&both) {
            true => Equation::of(view, 0, Rule::TurnsOfLine, both),
            false => turns,
        })
    })
}

/// y.(L x) = y.(Z x): the angle between a direction before joint t and one behind it, if the other joints turn neither.
///
/// If both are equally inclined to the axis, y_z = s x_z = m, they are one direction where its angle vanishes, and the discriminant
/// (1 - m^2)^2 - (w - s m^2)^2 = (1 - s w) (1 + s w - 2 m^2), w = y.(L x), is small there. 1 - s w has its digits from the
/// cross product: 2 (1 - s w) = |y x L x|^2 + (1 - s w)^2.
fn angle_between<'g>(view: &View<'g>, t: usize) -> Option<Equation<'g>> {
    let [y] = view.directions(0..t)[..] else {
        return None;
    };
    let [pair] = directions_behind(view, t)[..] else {
        return None;
    };
    let (m, x) = (view.way(0, t).inverse().direction(y), pair.near);
    let v = view.target.direction(pair.far);
    let [a, b] = rotated(m, x);
    let along = y.dot(v);
    let across = y.cross(v);
    let across = across.dot(across);
    let (one, zero) = (view.graph.one(), view.graph.zero());
    let (discriminant, size) = if m[2].is_zero() && x[2].is_zero() {
        (Some(across), zero)
    } else if (m[2] * m[2] - x[2] * x[2]).is_zero() {
        let is_same = (m[2] - x[2]).is_zero();
        let toward = if is_same { along } else { -along };
        let (apart, square) = (one - toward, m[2] * m[2]);
        // Twice 1 - s w.
        let twice = across + apart * apart;
        let rest = (one + toward) / (one + one) - square;
        (Some(twice * rest), twice)
    } else {
        (None, one)
    };
    let c = along - m[2] * x[2];
    Equation::turns(view, t, [a, b, c], discriminant, size)
}

/// y.(L p) = y.(A Z p): a height that the joints before t do not change.
fn heights<'g>(view: &View<'g>, t: usize) -> Option<Equation<'g>> {
    if t == 0 {
        return None;
    }
    let pair = point_from(view, t, t + 1, None)?;
    let way = view.way(0, t);
    let near = |y: &Vector<'g>| way.inverse().direction(*y);
    let heights = view.heights(0..t, |_| false);
    let y = heights
        .into_iter()
        .find(|y| !are_parallel(near(y), view.z()))?;
    let [a, b] = rotated(near(&y), pair.near);
    let v = view.target.point(pair.far);
    let known = y.dot(way.point(view.z() * pair.near[2]));
    let size = v.dot(v) + known * known + view.span;
    Equation::turns(view, t, [a, b, y.dot(v) - known], None, size)
}

/// A distance that the joints before t do not change: from a point o that they do not move, or from an axis that they leave where
/// it is, of which o is a point.
struct Distance<'g> {
    /// The axis, in the frame of joint t.
    axis: Option<Vector<'g>>,
    /// o and the point p behind joint t, both in the frame of joint t.
    o: Vector<'g>,
    p: Vector<'g>,
    /// The square of the distance between o and L p, beside the axis.
    found: Expr<'g>,
}

impl<'g> Distance<'g> {
    /// The distance for joint t, if its axis, of which this is the direction in the joint's frame, suits the joint.
    fn new(view: &View<'g>, t: usize, suits: impl Fn(Vector<'g>) -> bool) -> Option<Self> {
        let (o, axis) = match view.points(0..t) {
            Points::One(o) => (o, None),
            Points::Line {
                point, direction, ..
            } => (point, Some(direction)),
            _ => return None,
        };
        let back = view.way(0, t).inverse();
        let near = axis.map(|axis| back.direction(axis));
        if near.is_some_and(|near| !suits(near)) {
            return None;
        }
        let pair = point_from(view, t, t + 1, near)?;
        let apart = across(view.target.point(pair.far) - o, axis);
        Some(Distance {
            axis: near,
            o: back.point(o),
            p: pair.near,
            found: apart.dot(apart),
        })
    }
}

/// The part of a vector at right angles to an axis, if there is one.
fn across<'g>(v: Vector<'g>, axis: Option<Vector<'g>>) -> Vector<'g> {
    axis.map_or(v, |axis| v - axis * v.dot(axis))
}

/// |L p - o|^2 = |Z p - o|^2: the distance from a point, or from an axis that the joints before t have in common with t.
pub(super) fn distance<'g>(view: &View<'g>, t: usize) -> Option<Equation<'g>> {
    let is_parallel = |axis| are_parallel(axis, view.z());
    let Distance { axis, o, p, found } = Distance::new(view, t, is_parallel)?;
    by_distance(view, t, (across(o, axis), across(p, axis)), found)
}

/// The square of the distance from the z axis.
fn beside_z<'g>(v: Vector<'g>) -> Expr<'g> {
    v[0] * v[0] + v[1] * v[1]
}

/// |y - Z x|^2 = found for joint t: 2 a cos q + 2 b sin q = X + Y - f with X, Y and f the squares of x, y and found in the plane.
///
/// The discriminant is Heron's, 16 times the square of a triangle's area, with f as a factor: if x and y are nearly equally
/// long, f may be small beside X + Y and has no digits left in the difference.
fn by_distance<'g>(
    view: &View<'g>,
    t: usize,
    (y, x): (Vector<'g>, Vector<'g>),
    found: Expr<'g>,
) -> Option<Equation<'g>> {
    let along = y[2] - x[2];
    let (rest, squares) = (along * along, [beside_z(x), beside_z(y)]);
    let [sum, difference] = [squares[0] + squares[1], squares[0] - squares[1]];
    let flat = found - rest;
    let discriminant = flat * (sum + sum - flat) - difference * difference;
    let size = (found + rest) * (sum + sum + found) + difference * difference;
    let [a, b] = rotated(y, x).map(|x| x + x);
    let loses_digits = !rest.is_zero();
    let equation = Equation::turns(view, t, [a, b, sum - flat], Some(discriminant), size)?;
    Some(Equation {
        loses_digits,
        ..equation
    })
}

/// |L p - Z o|^2 = |B p - o|^2 with a point o that joints right behind the first do not move.
fn front_distance<'g>(view: &View<'g>) -> Option<Equation<'g>> {
    let last = view.joints.len();
    (2..=last).rev().find_map(|end| {
        let Points::One(o) = moved(&view.links[0], view.points(1..end)) else {
            return None;
        };
        let pair = point_from(view, 0, end, None)?;
        let v = view.target.point(pair.far);
        let apart = pair.near - o;
        by_distance(view, 0, (v, o), apart.dot(apart))
    })
}

/// |L p - o|^2 = |p + d z - o|^2, a quadratic equation in d; an axis is at a right angle to that of joint t.
fn slides<'g>(view: &View<'g>, t: usize) -> Option<Equation<'g>> {
    let is_across = |axis: Vector<'g>| axis[2].is_zero();
    let Distance { axis, o, p, found } = Distance::new(view, t, is_across)?;
    let e = across(p - o, axis);
    let beside = beside_z(e);
    let coefficients = vec![-e[2], found - beside, found + beside];
    view.allows(&coefficients)
        .then(|| Equation::of(view, t, Rule::Slides, coefficients))
}

/// The coefficients of cos q and sin q in y.(Rz(q) x).
fn rotated<'g>(y: Vector<'g>, x: Vector<'g>) -> [Expr<'g>; 2] {
    [y[0] * x[0] + y[1] * x[1], y[1] * x[0] - y[0] * x[1]]
}

/// Directions that the joints behind joint t do not turn; if there is none behind it, its own x axis first.
fn directions_behind<'g>(view: &View<'g>, t: usize) -> Vec<Pair<'g>> {
    let last = view.joints.len();
    if t + 1 == last {
        let same = |v| Pair { near: v, far: v };
        return view.axes().map(same).to_vec();
    }
    let on = view.directions(t + 1..last);
    let far = view.way(t + 1, last - 1).inverse();
    let pair = |v: &Vector<'g>| Pair {
        near: view.links[t].direction(*v),
        far: far.direction(*v),
    };
    on.iter().map(pair).collect()
}

/// A point that the joints from `end` on do not move, or only along an axis if one is given: in the frame behind joint t, if the
/// joints between the two stand at zero, and in the last frame.
fn point_from<'g>(
    view: &View<'g>,
    t: usize,
    end: usize,
    axis: Option<Vector<'g>>,
) -> Option<Pair<'g>> {
    let last = view.joints.len();
    if end == last {
        let near = view.way(t, last - 1).point(view.tip);
        return Some(Pair {
            near,
            far: view.tip,
        });
    }
    let is_along = |direction| axis.is_some_and(|axis| are_parallel(direction, axis));
    let near = match moved(&view.way(t, end), view.points(end..last)) {
        Points::One(point) => point,
        Points::Line {
            point,
            direction,
            each,
        } if each || is_along(direction) => point,
        Points::Lines(direction) if is_along(direction) => view.origin(),
        _ => return None,
    };
    let far = view.way(t, last - 1).inverse().point(near);
    Some(Pair { near, far })
}
