//! The links and joints of a URDF document.

use std::cell::Cell;

use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::{JointType, Placement, Value};
use roxmltree::{Document, Node};

use super::loops;
use super::prefixes::Declared;
use super::reader::{Read, Reader};
use super::xml::{child, elements, is_named, parsed};
use crate::diagnose::Diagnostics;
use crate::files::Request;
use crate::files::links::{Follows, Inertial, Joint, Kind, Link, Number, Rounding, Tree, Words};
use crate::geometry::{Transform, Vector, direction};
use crate::mistake::urdf as mistake;
use crate::place::Place;
use crate::validate::is_in_whole_degrees;
use crate::words;

/// Limits beyond so many rad or m are none.
const WIDE: f64 = 1e3;

/// Efforts and velocities of so much are none, N m, N, rad/s or m/s.
const UNBOUNDED: f64 = 1e9;

/// Angles of more turns are meant in degrees, rad. Files have a turn that is rounded up.
const MOST_RADIANS: f64 = 2.0 * core::f64::consts::TAU;

/// Names for the parts of a file in messages.
const WORDS: Words = Words {
    follower: "<mimic>",
    body: "<inertial>",
};

/// Reads a document; what is wrong in it is reported.
pub(in crate::files) fn read(
    source: &str,
    request: &Request,
    diagnostics: &Diagnostics,
) -> Option<Tree> {
    parsed(source, diagnostics, |declared, document| {
        tree(declared, document, request, diagnostics)
    })?
}

/// The links and joints.
fn tree(
    declared: &Declared,
    document: &Document,
    request: &Request,
    diagnostics: &Diagnostics,
) -> Option<Tree> {
    let root = document.root_element();
    let within = request.round_angles.as_ref();
    let mut reader = Reader {
        text: declared,
        diagnostics,
        request,
        rounding: Rounding::new(within.map_or(0.0, |within| within.to_f64().value())),
        left_over: Cell::new(None),
    };
    reader.require_robot(root).ok()?;
    let elements =
        |name: &'static str| elements(root).filter(move |element| is_named(*element, name));
    let links: Vec<Read<Link>> = elements("link").map(|link| reader.link(link)).collect();
    let joints: Vec<Read<Joint>> = elements("joint").map(|joint| reader.joint(joint)).collect();
    let links: Vec<Link> = links.into_iter().collect::<Read<_>>().ok()?;
    let joints: Vec<Joint> = joints.into_iter().collect::<Read<_>>().ok()?;
    let names: Vec<&str> = links.iter().map(|link| link.name.as_str()).collect();
    let tree = Tree {
        warnings: loops::warnings(root, &names, |node| reader.place(node)),
        links,
        joints,
        rounding: reader.rounding,
        words: WORDS,
    };
    tree.report_names(diagnostics);
    diagnostics.is_empty().then_some(tree)
}

impl Reader<'_> {
    /// Refuses a document whose root is no `<robot>`, and calls of xacro that would give it links and joints.
    fn require_robot(&self, root: Node) -> Read<()> {
        /// Their definitions do nothing by themselves.
        const DEFINITIONS: [&str; 3] = ["arg", "macro", "property"];
        if !is_named(root, "robot") {
            return Err(self.error(root, mistake::no_robot(root.tag_name().name())));
        }
        self.require_expanded(root, &DEFINITIONS);
        self.left_over.get().map_or(Ok(()), Err)
    }

    /// `<origin xyz rpy>`
    fn origin(&mut self, node: Node) -> Read<(Vector, [Value; 3])> {
        // The element is a joint, or an inertia, which has no name.
        let joint = node.attribute("name").unwrap_or_default();
        let odd_angle = self.request.allowed(Some(joint)).odd_angle;
        let origin = child(node, "origin");
        if let Some(origin) = origin {
            self.spelled(origin, &[], &["xyz", "rpy"]);
        }
        let xyz = self.vector(origin, "xyz", [0; 3]);
        let (rpy, place) = self.vector(origin, "rpy", [0; 3])?;
        for angle in &rpy {
            let radians = angle.to_f64().value();
            let is_odd = radians.abs() > MOST_RADIANS || is_in_whole_degrees(radians);
            if is_odd && !odd_angle {
                self.diagnostics.error(place, mistake::in_degrees(radians));
            }
        }
        Ok((
            xyz?.0.map(|length| self.rounding.length(length)),
            rpy.map(|angle| self.rounding.angle(angle)),
        ))
    }

    fn link(&mut self, node: Node) -> Read<Link> {
        self.spelled(
            node,
            &["inertial", "visual", "collision"],
            &["name", "type"],
        );
        let name = self.name(node);
        let inertial = child(node, "inertial")
            .map(|node| self.inertial(node))
            .transpose();
        Ok(Link {
            name: name?,
            place: self.place(node),
            inertial: inertial?,
        })
    }

    fn inertial(&mut self, node: Node) -> Read<Inertial> {
        self.spelled(node, &["origin", "mass", "inertia"], &[]);
        let origin = self.origin(node);
        let mass = self
            .part(node, "mass")
            .and_then(|mass| self.required(mass, "value"));
        let inertia = self.part(node, "inertia")?;
        let entries = ["ixx", "iyy", "izz", "ixy", "iyz", "ixz"];
        let entries = entries.map(|name| self.required(inertia, name));
        let entries: Read<Vec<_>> = entries.into_iter().collect();
        let tensor = entries?.try_into().unwrap_or([Rational::ZERO; 6]);
        let (xyz, rpy) = origin?;
        Ok(Inertial {
            place: self.place(node),
            mass: mass?,
            tensor,
            frame: Transform::new(&xyz, &rpy).unwrap_or_else(Transform::identity),
        })
    }

    fn joint(&mut self, node: Node) -> Read<Joint> {
        const PARTS: [(&str, &[&str]); 6] = [
            ("parent", &["link"]),
            ("child", &["link"]),
            ("axis", &["xyz"]),
            ("limit", &["lower", "upper", "effort", "velocity"]),
            ("dynamics", &["damping", "friction"]),
            ("mimic", &["joint", "multiplier", "offset"]),
        ];
        let parts = PARTS.map(|(part, _)| part);
        let elements = [&parts[..], &["origin"]].concat();
        self.spelled(node, &elements, &["name", "type"]);
        for (part, attributes) in PARTS {
            if let Some(part) = child(node, part) {
                self.spelled(part, &[], attributes);
            }
        }
        let name = self.name(node);
        let kind = self.kind(node);
        let link = |part: &str| {
            let part = self.part(node, part)?;
            let link = self.attribute(part, "link")?;
            Ok(link.value().to_owned())
        };
        let (parent, child_link) = (link("parent"), link("child"));
        let origin = self.origin(node);
        let dynamics = child(node, "dynamics");
        let damping = self.optional(dynamics, "damping");
        let friction = self.optional(dynamics, "friction");
        let limits = self.limits(node);
        let [effort, velocity] = ["effort", "velocity"].map(|name| self.greatest(node, name));
        let kind = kind?;
        let mimic = child(node, "mimic").map(|mimic| self.mimic(mimic, kind));
        let axis = self.axis(node, kind);
        let (xyz, rpy) = origin?;
        Ok(Joint {
            name: name?,
            place: self.place(node),
            kind,
            parent: parent?,
            child: child_link?,
            origin: Placement {
                xyz: xyz.map(Value::Rational),
                rpy,
            },
            axis: axis?,
            viscous: damping?,
            coulomb: friction?,
            limits: limits?,
            effort: effort?,
            velocity: velocity?,
            follows: mimic.transpose()?,
        })
    }

    /// `<mimic joint="finger_1" multiplier="-1" offset="0.02"/>`, of which 1 and 0 may be left out.
    fn mimic(&mut self, node: Node, kind: Kind) -> Read<Follows> {
        let joint = self.attribute(node, "joint");
        let number = |name: &str, default: i8| {
            let number = self.optional(Some(node), name)?;
            Ok(number.map_or(Rational::from(default), |(number, _)| number))
        };
        let (multiplier, offset) = (number("multiplier", 1), number("offset", 0));
        Ok(Follows {
            place: self.place(node),
            leader: joint?.value().to_owned(),
            factor: multiplier?,
            offset: match kind {
                Kind::Moves(JointType::Revolute) => self.rounding.angle(offset?),
                _ => Value::Rational(offset?),
            },
        })
    }

    fn kind(&self, node: Node) -> Read<Kind> {
        const KNOWN: [&str; 4] = ["revolute", "continuous", "prismatic", "fixed"];
        const OTHERS: [&str; 4] = ["floating", "planar", "spherical", "ball"];
        let attribute = self.attribute(node, "type")?;
        Ok(match attribute.value() {
            "revolute" | "continuous" => Kind::Moves(JointType::Revolute),
            "prismatic" => Kind::Moves(JointType::Prismatic),
            "fixed" => Kind::Fixed,
            word => {
                if let Some(other) = OTHERS.into_iter().find(|other| *other == word) {
                    return Ok(Kind::Other(other));
                }
                let place = self.text.place(attribute.range_value().start);
                let meant = words::meant(word, &KNOWN);
                let mistake = crate::mistake::unknown("joint type", word, meant, &KNOWN);
                return Err(self.diagnostics.error(place, mistake));
            }
        })
    }

    /// The direction of a joint's axis, (1, 0, 0) where nothing is said.
    fn axis(&mut self, node: Node, kind: Kind) -> Read<[Value; 2]> {
        if !matches!(kind, Kind::Moves(_)) {
            return Ok([Value::zero(), Value::zero()]);
        }
        let (axis, place) = self.vector(child(node, "axis"), "xyz", [1, 0, 0])?;
        let zero = || self.diagnostics.error(place, mistake::axis_of_no_length());
        direction(&self.rounding.axis(axis)).ok_or_else(zero)
    }

    /// The greatest effort or velocity of `<limit>`, where it says something: many files have 0 there, or -1.
    fn greatest(&self, node: Node, name: &str) -> Read<Option<Number>> {
        let most = self.optional(child(node, "limit"), name)?;
        let says = |most: &Rational| *most > Rational::ZERO && most.to_f64().value() < UNBOUNDED;
        Ok(most.filter(|(most, _)| says(most)))
    }

    /// Where both are there and say something: continuous joints have none.
    fn limits(&self, node: Node) -> Read<Option<([Rational; 2], Place)>> {
        let limit = child(node, "limit");
        let lower = self.optional(limit, "lower")?;
        let upper = self.optional(limit, "upper")?;
        if node.attribute("type") == Some("continuous") || (lower.is_none() && upper.is_none()) {
            return Ok(None);
        }
        let place = lower.as_ref().or(upper.as_ref()).map(|(_, place)| *place);
        let limits = [lower, upper].map(|limit| limit.map_or(Rational::ZERO, |(value, _)| value));
        let is_wide = limits
            .iter()
            .any(|limit| limit.to_f64().value().abs() > WIDE);
        let says_nothing = is_wide || limits[0] == limits[1];
        Ok(place.filter(|_| !says_nothing).map(|place| (limits, place)))
    }
}
