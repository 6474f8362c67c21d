//! Bodies of links, wherever they are written, and what is doubtful about them.

use super::rule;
use super::space::{Bounds, Point, norm};
use crate::finding::Finding;
use crate::place::Place;
use crate::validate::{heaviest_of, in_kilograms, lightest_of};

/// A body on a link, with what is known of the link's size.
#[derive(Debug)]
pub(super) struct Body {
    pub(super) name: String,
    /// The place of its link.
    pub(super) place: Place,
    pub(super) mass: (f64, Place),
    /// The centre of mass in the frame of the link, m.
    pub(super) com: (Point, Place),
    /// xx, yy, zz, xy, yz, xz about the centre of mass, in any axes.
    pub(super) tensor: ([f64; 6], Place),
    /// Where joints and frames are on the link, its own joint too; none if that is not known.
    pub(super) joints: Option<Vec<Point>>,
    /// Corners of boxes around the geometry, if all of it is known.
    pub(super) geometry: Vec<Point>,
    /// Whether its numbers are said to be meant.
    pub(super) is_allowed: bool,
}

impl Body {
    /// The mean distance of the mass from its centre, m: half the trace of the tensor is the sum of m r^2.
    fn radius(&self) -> f64 {
        let [xx, yy, zz, ..] = self.tensor.0;
        ((xx + yy + zz) / 2.0 / self.mass.0).sqrt()
    }

    /// The half diagonal of its geometry, if that is known.
    fn size(&self) -> Option<f64> {
        Some(Bounds::of(&self.geometry)?.radius())
    }

    /// The box around joints and geometry.
    fn bounds(&self) -> Option<Bounds> {
        let joints = self.joints.as_ref()?;
        Bounds::of(&[&joints[..], &self.geometry].concat())
    }

    /// How far the centre of mass is outside of that.
    pub(super) fn outside(&self) -> Option<f64> {
        Some(self.bounds()?.distance(self.com.0))
    }
}

/// Mass so many times further from its centre than the whole geometry reaches is not inside of it: a body that is has 1 at
/// most, and a uniform box 0.58.
const BEYOND_GEOMETRY: f64 = 2.0;

/// A body so many times smaller than its geometry is a point in it: a motor at the end of a long thin cover has 5.
const BELOW_GEOMETRY: f64 = 30.0;

/// Mass may be so many times further from its centre than the longest part of the robot is long. In published files it
/// is up to 2, beside tensors of 1 kg m^2 that nobody measured.
const BEYOND_ROBOT: f64 = 3.0;

/// A centre of mass may be so many times further outside of its link than the longest part of the robot is long. In
/// published files it is up to 1.5, at the stand of a finger.
const OUTSIDE: f64 = 2.0;

/// Bodies of this share of the mass and of the inertia of the robot, or less, stand for nothing: programs that refuse a mass
/// of 0 are given them.
const NOTHING: f64 = 1e-4;

/// The density of osmium, kg/m^3: nothing is denser.
const DENSEST: f64 = 22_590.0;

/// A geometry that is so many times larger than the longest way between joints, and than 10 m, is in mm.
const IN_MILLIMETRES: f64 = 100.0;

/// Lengths of a robot, m, and its mass.
struct Whole {
    /// The longest way between joints, or half of the diagonal of a geometry.
    longest: f64,
    /// All ways together, and that to a centre of mass: nothing is further away.
    all: f64,
    /// Geometries of more are in mm.
    most: f64,
    /// The mass of all links, kg.
    mass: f64,
}

/// All that is doubtful about bodies of a robot with these ways between joints, m.
pub(super) fn findings(bodies: &[Body], ways: &[f64]) -> Vec<Finding> {
    let greatest = |sizes: &mut dyn Iterator<Item = f64>| sizes.fold(0.0, f64::max);
    let way = greatest(&mut ways.iter().copied());
    let most = if way > 0.0 {
        (IN_MILLIMETRES * way).max(10.0)
    } else {
        f64::INFINITY
    };
    let sizes = bodies.iter().filter_map(Body::size);
    let longest = greatest(&mut sizes.filter(|size| *size <= most)).max(way);
    let com = greatest(&mut bodies.iter().map(|body| norm(body.com.0)));
    let whole = Whole {
        longest,
        all: ways.iter().sum::<f64>() + longest.max(com),
        most,
        mass: bodies.iter().map(|body| body.mass.0).sum(),
    };
    let mut found = Vec::new();
    for body in bodies
        .iter()
        .filter(|body| !body.is_allowed && body.mass.0 > 0.0)
    {
        let told = mass(body, longest).or_else(|| geometry(body, way, &whole));
        // A wrong mass says nothing of the tensor, nor does a geometry in mm.
        let is_judged = told.is_none() && !is_nothing(body, &whole);
        found.extend(told);
        found.extend(is_judged.then(|| inertia(body, longest)).flatten());
        found.extend(centre(body, longest));
    }
    found.extend(total(bodies, &whole));
    found
}

fn mass(body: &Body, longest: f64) -> Option<Finding> {
    let (mass, place) = body.mass;
    let (right, unit) = in_kilograms(mass, heaviest_of(longest))?;
    let is_odd = longest > 0.0 && mass > heaviest_of(longest);
    is_odd.then(|| rule::mass_in_other_unit(place, &body.name, mass, longest, right, unit))
}

fn is_nothing(body: &Body, whole: &Whole) -> bool {
    let share = body.mass.0 / whole.mass;
    share < NOTHING && share * (body.radius() / whole.longest).powi(2) < NOTHING
}

/// Compares the tensor with the geometry, or where that is not known with balls and the robot.
fn inertia(body: &Body, longest: f64) -> Option<Finding> {
    let (radius, place) = (body.radius(), body.tensor.1);
    if radius == 0.0 || !radius.is_finite() {
        return None;
    }
    if let Some(size) = body.size() {
        let is_good =
            |radius: f64| (size / BELOW_GEOMETRY..=BEYOND_GEOMETRY * size).contains(&radius);
        let hint = other_unit(|factor| is_good(radius * f64::sqrt(factor)));
        let is_odd = size > 0.0 && !is_good(radius);
        return is_odd
            .then(|| rule::inertia_far_from_geometry(place, &body.name, radius, size, hint));
    }
    // A ball of radius r: half the trace is 3/5 m r^2.
    let ball = (3.0 * body.mass.0 / (4.0 * core::f64::consts::PI * DENSEST)).cbrt();
    let least = 0.6_f64.sqrt() * ball;
    let most = if longest > 0.0 {
        BEYOND_ROBOT * longest.max(norm(body.com.0))
    } else {
        f64::INFINITY
    };
    let is_good = |radius: f64| (least..=most).contains(&radius);
    let hint = other_unit(|factor| is_good(radius * f64::sqrt(factor)));
    let is_whole = body.tensor.0[..3].iter().all(|moment| *moment > 0.0);
    let why = if radius > most {
        format!("in a robot whose longest part is {longest:.2} m")
    } else if radius < least && is_whole {
        format!(
            "and even a ball of osmium of {:.3} kg is larger",
            body.mass.0
        )
    } else {
        return None;
    };
    Some(rule::inertia_far_from_uniform(
        place, &body.name, radius, &why, hint,
    ))
}

fn centre(body: &Body, longest: f64) -> Option<Finding> {
    let (distance, place) = (body.outside()?, body.com.1);
    let is_good = |distance: f64| distance <= OUTSIDE * longest;
    let hint = other_unit(|factor| is_good(distance * factor));
    let is_odd = longest > 0.0 && !is_good(distance);
    is_odd.then(|| rule::centre_outside(place, &body.name, distance, longest, hint))
}

fn geometry(body: &Body, way: f64, whole: &Whole) -> Option<Finding> {
    let size = body.size().filter(|size| *size > whole.most)?;
    Some(rule::geometry_in_millimetres(
        body.place, &body.name, size, way,
    ))
}

/// The sum, where no body is told already.
fn total(bodies: &[Body], whole: &Whole) -> Option<Finding> {
    let first = bodies.iter().find(|body| body.mass.0 > 0.0)?;
    let is_told = |body: &Body| body.is_allowed || body.mass.0 > heaviest_of(whole.longest);
    let good = lightest_of(whole.longest)..=heaviest_of(whole.all);
    let is_odd = whole.longest > 0.0 && !good.contains(&whole.mass) && !bodies.iter().any(is_told);
    is_odd.then(|| rule::total_mass(first.mass.1, whole.mass, whole.all))
}

/// The words behind a remedy if a thousandth or a millionth of a number would be good.
fn other_unit(is_good: impl Fn(f64) -> bool) -> String {
    let factor = [("thousandth", 1e-3), ("millionth", 1e-6)];
    let factor = factor.into_iter().find(|(_, factor)| is_good(*factor));
    factor.map_or(String::new(), |(words, _)| {
        format!(" (a {words} of it would be plausible)")
    })
}
