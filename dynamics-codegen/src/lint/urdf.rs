//! Links and joints of a URDF file, as far as no model needs them: geometry, effort, lengths of axes, names.

use std::collections::{BTreeMap, BTreeSet};

use dynamics_symbolic::robot::{Angle, Value};
use roxmltree::{Document, Node};

use super::body::{self, Body};
use super::space::{Point, norm, placed};
use super::{Judged, rule, sides};
use crate::files::urdf::prefixes::Declared;
use crate::files::urdf::xml::{child, elements, is_named};
use crate::finding::Finding;
use crate::parse::number::in_file;
use crate::place::Place;
use crate::rounded::NEARLY;

/// A document with what its elements are to one another.
struct File<'d> {
    declared: &'d Declared<'d>,
    links: Vec<Node<'d, 'd>>,
    joints: Vec<Joint<'d>>,
    /// Where joints are on the link that carries them.
    carried: BTreeMap<&'d str, Vec<Point>>,
    /// The links that joints carry.
    children: BTreeSet<&'d str>,
}

struct Joint<'d> {
    node: Node<'d, 'd>,
    name: &'d str,
    kind: &'d str,
    parent: &'d str,
    child: &'d str,
    xyz: Point,
}

impl Joint<'_> {
    /// Whether it moves along or about an axis.
    fn has_axis(&self) -> bool {
        ["revolute", "continuous", "prismatic"].contains(&self.kind)
    }
}

/// Judges a document.
pub(super) fn judged(declared: &Declared, document: &Document) -> Judged {
    let root = document.root_element();
    let named = |name: &'static str| elements(root).filter(move |node| is_named(*node, name));
    let joints: Vec<Joint> = named("joint").map(joint).collect();
    let mut carried = BTreeMap::<_, Vec<_>>::new();
    for joint in &joints {
        carried.entry(joint.parent).or_default().push(joint.xyz);
    }
    let file = File {
        declared,
        links: named("link").collect(),
        carried,
        children: joints.iter().map(|joint| joint.child).collect(),
        joints,
    };
    let mut findings: Vec<Finding> = file
        .joints
        .iter()
        .flat_map(|joint| file.of_joint(joint))
        .collect();
    let ends = file.links.iter().map(|link| (*link, "link"));
    let names = ends.chain(file.joints.iter().map(|joint| (joint.node, "joint")));
    findings.extend(names.filter_map(|(node, what)| file.of_name(node, what)));
    findings.extend(file.links.iter().filter_map(|link| file.of_massless(*link)));
    let bodies: Vec<Body> = file
        .links
        .iter()
        .filter_map(|link| file.body(*link))
        .collect();
    let ways: Vec<f64> = file.joints.iter().map(|joint| norm(joint.xyz)).collect();
    findings.extend(body::findings(&bodies, &ways));
    findings.extend(sides::findings(&bodies));
    let moving_base = file.moving_base();
    if let Some(first) = &moving_base {
        let chain = first
            .as_ref()
            .map_or(String::new(), |link| format!("--chain {link} "));
        let place = file.place(root);
        findings.push(rule::moving_base(place, &format!("{chain}--base floating")));
    }
    Judged {
        findings,
        moving_base,
    }
}

fn joint<'d>(node: Node<'d, 'd>) -> Joint<'d> {
    let link = |end: &str| child(node, end).and_then(|end| end.attribute("link"));
    Joint {
        node,
        name: name(node),
        kind: node.attribute("type").unwrap_or_default(),
        parent: link("parent").unwrap_or_default(),
        child: link("child").unwrap_or_default(),
        xyz: origin(node)[0],
    }
}

fn name<'d>(node: Node<'d, 'd>) -> &'d str {
    node.attribute("name").unwrap_or_default()
}

/// The numbers of an attribute, if all of them are finite and as many as expected.
fn numbers<const N: usize>(node: Node, name: &str) -> Option<[f64; N]> {
    let words = node.attribute(name)?.split_whitespace();
    let numbers = words.map(|word| word.parse().ok().filter(|x: &f64| x.is_finite()));
    numbers.collect::<Option<Vec<f64>>>()?.try_into().ok()
}

fn number(node: Node, name: &str) -> Option<f64> {
    numbers(node, name).map(|[x]| x)
}

/// `xyz` and `rpy` of `<origin>`; zeros where they are left out.
fn origin(node: Node) -> [Point; 2] {
    let origin = child(node, "origin");
    ["xyz", "rpy"].map(|name| {
        origin
            .and_then(|node| numbers(node, name))
            .unwrap_or_default()
    })
}

/// Corners of the boxes around all shapes of the elements of that name; none if there are none, or a mesh.
fn corners(link: Node, name: &str) -> Option<Vec<Point>> {
    let mut corners = Vec::new();
    for element in elements(link).filter(|node| is_named(*node, name)) {
        let geometry = child(element, "geometry")?;
        let of = |shape: &str| child(geometry, shape);
        let half = if let Some(cuboid) = of("box") {
            numbers(cuboid, "size")?.map(|edge: f64| edge / 2.0)
        } else if let Some(cylinder) = of("cylinder") {
            let radius = number(cylinder, "radius")?;
            [radius, radius, number(cylinder, "length")? / 2.0]
        } else {
            [number(of("sphere")?, "radius")?; 3]
        };
        let [xyz, rpy] = origin(element);
        let sign = |corner: i32, axis: usize| if corner & (1 << axis) == 0 { -1.0 } else { 1.0 };
        let corner = |corner| {
            placed(
                xyz,
                rpy,
                core::array::from_fn(|i| sign(corner, i) * half[i]),
            )
        };
        corners.extend((0..8).map(corner));
    }
    (!corners.is_empty()).then_some(corners)
}

impl File<'_> {
    fn place(&self, node: Node) -> Place {
        self.declared.place(node.range().start)
    }

    /// The body of a link, if all that is said of it can be read.
    fn body(&self, link: Node) -> Option<Body> {
        let inertial = child(link, "inertial")?;
        let (mass, inertia) = (child(inertial, "mass")?, child(inertial, "inertia")?);
        let entries =
            ["ixx", "iyy", "izz", "ixy", "iyz", "ixz"].map(|entry| number(inertia, entry));
        let tensor = entries
            .into_iter()
            .collect::<Option<Vec<f64>>>()?
            .try_into()
            .ok()?;
        let name = name(link).to_owned();
        let carried = self.carried.get(&*name).into_iter().flatten();
        let shapes = ["visual", "collision"].map(|shape| corners(link, shape).unwrap_or_default());
        Some(Body {
            mass: (number(mass, "value")?, self.place(mass)),
            com: (
                origin(inertial)[0],
                self.place(child(inertial, "origin").unwrap_or(inertial)),
            ),
            tensor: (tensor, self.place(inertia)),
            joints: Some([[0.0; 3]].iter().chain(carried).copied().collect()),
            geometry: shapes.concat(),
            is_allowed: false,
            place: self.place(link),
            name,
        })
    }

    /// A link without mass that has a geometry. A root that stands has none often.
    fn of_massless(&self, link: Node) -> Option<Finding> {
        let mass = child(child(link, "inertial")?, "mass")?;
        let is_carried = self.children.contains(name(link));
        let has_geometry = child(link, "visual").or(child(link, "collision")).is_some();
        let is_odd = number(mass, "value")? == 0.0 && has_geometry && is_carried;
        is_odd.then(|| rule::no_mass_but_geometry(self.place(mass), name(link)))
    }

    fn of_joint(&self, joint: &Joint) -> Vec<Finding> {
        let mut found = Vec::from_iter(self.quarter_turns(joint));
        let axis = child(joint.node, "axis");
        let length = axis.and_then(|axis| numbers(axis, "xyz")).map(norm);
        if let Some((axis, length)) = axis.zip(length)
            && (length - 1.0).abs() > NEARLY
            && joint.has_axis()
            && length > 0.0
        {
            found.push(rule::axis_not_unit(self.place(axis), joint.name, length));
        }
        let limit = child(joint.node, "limit");
        let is_zero = |what: &&str| limit.and_then(|limit| number(limit, what)) == Some(0.0);
        let zeros: Vec<&str> = ["effort", "velocity"].into_iter().filter(is_zero).collect();
        // A follower has no drive of its own.
        let is_driven = joint.has_axis() && child(joint.node, "mimic").is_none();
        if let Some(limit) = limit.filter(|_| is_driven && !zeros.is_empty()) {
            found.push(rule::effort_zero(
                self.place(limit),
                joint.name,
                &zeros.join(" and "),
            ));
        }
        found
    }

    /// Angles that are quarter turns as far as their digits go, if no reader takes them for that.
    fn quarter_turns(&self, joint: &Joint) -> Option<Finding> {
        let origin = child(joint.node, "origin")?;
        let words = origin.attribute("rpy")?.split_whitespace();
        let words: Vec<_> = words
            .filter(|word| is_nearly_right(word) == Some(true))
            .collect();
        let place = self.place(origin);
        (!words.is_empty())
            .then(|| rule::nearly_quarter_turns(place, joint.name, &words.join(", ")))
    }

    /// A name of which other tools make something else, or nothing.
    fn of_name(&self, node: Node, what: &str) -> Option<Finding> {
        let name = name(node);
        let is_good = |letter: char| letter.is_ascii_alphanumeric() || "_-.:+".contains(letter);
        let why = if name.is_empty() {
            "it is empty".to_owned()
        } else if name.starts_with("__") && name.ends_with("__") {
            "SDF keeps names between double underscores for itself".to_owned()
        } else if name.contains("::") {
            "`::` is between names in SDF".to_owned()
        } else {
            format!(
                "it has `{}`",
                name.chars().find(|letter| !is_good(*letter))?
            )
        };
        Some(rule::name_of_no_other_tool(
            self.place(node),
            what,
            name,
            &why,
        ))
    }

    /// The link at which a robot begins whose base moves; none of a whole file in which nothing else moves.
    fn moving_base(&self) -> Option<Option<String>> {
        let mut roots = self
            .links
            .iter()
            .filter(|link| !self.children.contains(name(**link)));
        let (root, None) = (name(*roots.next()?), roots.next()) else {
            return None;
        };
        let mut carried = self.joints.iter().filter(|joint| joint.parent == root);
        if let (Some(first), None) = (carried.next(), carried.next())
            && first.kind == "floating"
        {
            return Some(Some(first.child.to_owned()));
        }
        let is_still = self.joints.iter().all(|joint| joint.kind == "fixed");
        is_still.then_some(None)
    }
}

/// Whether a word is a multiple of a quarter turn but zero to the digits that it has, at least two, and no quarter turn to
/// the engine.
fn is_nearly_right(word: &str) -> Option<bool> {
    let (_, decimals) = word.split_once('.')?;
    let exact = in_file(word).ok()?;
    let radians = exact.to_f64().value();
    let quarters = (radians / core::f64::consts::FRAC_PI_2).round();
    let apart = (radians - quarters * core::f64::consts::FRAC_PI_2).abs();
    let digit = 10.0_f64.powi(-i32::try_from(decimals.len()).ok()?);
    let is_near = apart <= digit && apart <= NEARLY && quarters != 0.0;
    Some(is_near && Angle::new(&Value::Rational(exact)).rest.is_some())
}

#[cfg(test)]
mod tests {
    use super::is_nearly_right;

    /// Calibrated angles have all their digits.
    #[test]
    fn angles_that_lack_digits_are_nearly_right() {
        for word in [
            "1.57", "1.571", "-1.5708", "3.14", "3.1416", "4.712", "6.28", "1.570796",
        ] {
            assert_eq!(is_nearly_right(word), Some(true), "{word}");
        }
        for word in [
            "0.0",
            "1.57079632679",
            "1.5701",
            "1.5683",
            "3.2",
            "0.785",
            "0.001",
        ] {
            assert_eq!(is_nearly_right(word), Some(false), "{word}");
        }
        for word in ["2", "", "nan", "1.x"] {
            assert_eq!(is_nearly_right(word), None, "{word}");
        }
    }
}
