//! The links and joints of a URDF document.

use std::borrow::Cow;
use std::cell::Cell;
use std::collections::BTreeSet;

use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::Value;
use roxmltree::{Attribute, Document, Error, Node};

use super::loops;
use super::prefixes::Declared;
use super::rounding::Rounding;
use crate::diagnose::{Diagnostics, Reported};
use crate::files::Request;
use crate::finding::Finding;
use crate::geometry::{Transform, Vector, direction};
use crate::limits::MOST_LETTERS;
use crate::mistake::{Mistake, file as text, size, urdf as mistake};
use crate::parse::number::in_file;
use crate::place::Place;
use crate::validate::is_in_whole_degrees;
use crate::words;

/// The links and joints of a document.
pub(super) struct Tree {
    pub(super) links: Vec<Link>,
    pub(super) joints: Vec<Joint>,
    /// The numbers that were taken as others.
    pub(super) rounding: Rounding,
    /// Warnings of loops that are left out.
    pub(super) loops: Vec<Finding>,
}

impl Tree {
    /// The links to which no joint leads, and those from which none does.
    pub(super) fn ends(&self) -> (Vec<&str>, Vec<&str>) {
        let outside_of = |end: fn(&Joint) -> &str| {
            let taken: BTreeSet<&str> = self.joints.iter().map(end).collect();
            let names = self.links.iter().map(|link| link.name.as_str());
            names.filter(|name| !taken.contains(name)).collect()
        };
        (
            outside_of(|joint| &joint.child),
            outside_of(|joint| &joint.parent),
        )
    }
}

pub(super) struct Link {
    pub(super) name: String,
    pub(super) place: Place,
    pub(super) inertial: Option<Inertial>,
}

pub(super) struct Inertial {
    pub(super) place: Place,
    pub(super) mass: Rational,
    /// xx, yy, zz, xy, yz, xz about the centre of mass, in the axes of its frame.
    pub(super) tensor: [Rational; 6],
    /// That frame in the link's.
    pub(super) frame: Transform,
}

pub(super) struct Joint {
    pub(super) name: String,
    pub(super) place: Place,
    pub(super) kind: Kind,
    pub(super) parent: String,
    pub(super) child: String,
    pub(super) xyz: Vector,
    pub(super) rpy: [Value; 3],
    pub(super) axis: [Value; 2],
    pub(super) damping: Option<(Rational, Place)>,
    pub(super) friction: Option<(Rational, Place)>,
    pub(super) limits: Option<([Rational; 2], Place)>,
    pub(super) effort: Option<(Rational, Place)>,
    pub(super) velocity: Option<(Rational, Place)>,
    pub(super) mimic: Option<Mimic>,
}

/// `<mimic joint="finger_1" multiplier="-1" offset="0.02"/>`: the joint is at multiplier * q + offset.
pub(super) struct Mimic {
    pub(super) place: Place,
    /// The joint that leads.
    pub(super) joint: String,
    /// 1 where it is left out.
    pub(super) multiplier: Rational,
    /// 0 where it is left out.
    pub(super) offset: Value,
}

#[derive(Clone, Copy, PartialEq)]
pub(super) enum Kind {
    Fixed,
    Revolute,
    Prismatic,
    /// `floating`, `planar` or `spherical`, which is refused where it matters.
    Other(&'static str),
}

/// Limits beyond so many rad or m are none.
const WIDE: f64 = 1e3;

/// Efforts and velocities of so much are none, N m, N, rad/s or m/s.
const UNBOUNDED: f64 = 1e9;

/// Angles of more turns are meant in degrees, rad. Files have a turn that is rounded up.
const MOST_RADIANS: f64 = 2.0 * core::f64::consts::TAU;

type Read<T> = Result<T, Reported>;

/// Reads a document; what is wrong in it is reported.
pub(super) fn read(source: &str, request: &Request, diagnostics: &Diagnostics) -> Option<Tree> {
    parsed(source, diagnostics, |declared, document| {
        tree(declared, document, request, diagnostics)
    })?
}

/// Takes what is needed from a document and the places in it; a text that is none is reported.
pub(crate) fn parsed<T>(
    source: &str,
    diagnostics: &Diagnostics,
    take: impl FnOnce(&Declared, &Document) -> T,
) -> Option<T> {
    let source = &*with_declaration_in_front(source);
    let mut declared = Declared::as_written(source);
    let mut document = Document::parse(source);
    if let Err(Error::UnknownNamespace(..)) = document {
        declared = Declared::with_prefixes(source);
        document = Document::parse(declared.text());
    }
    let document = document.map_err(|error| {
        let place = declared.place_of(error.pos());
        diagnostics.error(place, text::syntax("XML", &reason(&error)))
    });
    Some(take(&declared, &document.ok()?))
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
    let loops = loops::warnings(root, &names, |node| reader.place(node));
    let tree = Tree {
        loops,
        links,
        joints,
        rounding: reader.rounding,
    };
    let links = tree.links.iter();
    report_repeated("link", links.map(|l| (&*l.name, l.place)), diagnostics);
    let joints = tree.joints.iter();
    report_repeated("joint", joints.map(|j| (&*j.name, j.place)), diagnostics);
    report_unknown_links(&tree, diagnostics);
    diagnostics.is_empty().then_some(tree)
}

/// The document, in which a declaration behind blank lines is blank too, as other readers take it. XML has it in front alone.
fn with_declaration_in_front(source: &str) -> Cow<'_, str> {
    let blank = source.len() - source.trim_start().len();
    let is_late = blank > 0 && source[blank..].starts_with("<?xml");
    let Some(end) = source.find("?>").filter(|_| is_late) else {
        return Cow::Borrowed(source);
    };
    let (declaration, rest) = source.split_at(end + 2);
    // As many bytes, in as many lines.
    let kept = |byte| if byte == b'\n' { '\n' } else { ' ' };
    Cow::Owned(declaration.bytes().map(kept).collect::<String>() + rest)
}

/// Reports each name that stands before it in the list already.
fn report_repeated<'a>(
    what: &str,
    names: impl Iterator<Item = (&'a str, Place)>,
    diagnostics: &Diagnostics,
) {
    let mut seen = BTreeSet::new();
    for (name, place) in names {
        if !seen.insert(name) {
            diagnostics.error(place, mistake::twice(what, name));
        }
    }
}

/// Reports the parents and children of joints that are no links of the file.
fn report_unknown_links(tree: &Tree, diagnostics: &Diagnostics) {
    let known: Vec<&str> = tree.links.iter().map(|link| link.name.as_str()).collect();
    for joint in &tree.joints {
        for link in [&joint.parent, &joint.child] {
            // To look for what was meant takes long, and no more is shown.
            if !known.contains(&link.as_str()) && !diagnostics.is_full() {
                let meant = words::nearest(link, &known);
                let mistake = mistake::unknown_link_of(&joint.name, link, meant);
                diagnostics.error(joint.place, mistake);
            }
        }
    }
}

/// The mistake without its place, which the message has behind "at".
fn reason(error: &roxmltree::Error) -> String {
    let shown = error.to_string();
    let end = shown.rfind(" at ").unwrap_or(shown.len());
    shown[..end].to_owned()
}

struct Reader<'a> {
    text: &'a Declared<'a>,
    diagnostics: &'a Diagnostics,
    request: &'a Request,
    rounding: Rounding,
    /// Whether something was found that xacro should have replaced: the rest of it goes with the first.
    left_over: Cell<Option<Reported>>,
}

/// The elements in another one that a reader of URDF knows. A prefix marks those of other programs.
pub(crate) fn elements<'a, 'i>(node: Node<'a, 'i>) -> impl Iterator<Item = Node<'a, 'i>> {
    let space = |node: Node<'a, 'i>| node.tag_name().namespace();
    let own = space(node.document().root_element());
    let elements = node.children().filter(Node::is_element);
    elements.filter(move |element| space(*element) == own)
}

pub(crate) fn is_named(element: Node, name: &str) -> bool {
    element.tag_name().name() == name
}

/// The element of that name in another one.
pub(crate) fn child<'a, 'i>(node: Node<'a, 'i>, name: &str) -> Option<Node<'a, 'i>> {
    elements(node).find(|element| is_named(*element, name))
}

/// The known word that was meant by one that is none.
fn misspelled<'k>(word: &str, known: &[&'k str]) -> Option<&'k str> {
    if known.contains(&word) {
        None
    } else {
        words::nearest(word, known)
    }
}

impl Reader<'_> {
    fn place(&self, node: Node) -> Place {
        self.text.place(node.range().start)
    }

    fn error(&self, node: Node, mistake: Mistake) -> Reported {
        self.diagnostics.error(self.place(node), mistake)
    }

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

    /// Reports an element of xacro in one that is read, except those of some names.
    fn require_expanded(&self, node: Node, harmless: &[&str]) {
        let is_left = |element: &Node| {
            let name = element.tag_name();
            let is_xacro = name
                .namespace()
                .is_some_and(|space| space.ends_with("/xacro"));
            is_xacro && !harmless.contains(&name.name())
        };
        let own = node.document().root_element().tag_name().namespace();
        let mut others = node
            .children()
            .filter(|child| child.tag_name().namespace() != own);
        if let Some(element) = others.find(is_left) {
            let what = format!("<xacro:{}>", element.tag_name().name());
            self.report_left_over(self.place(element), &what);
        }
    }

    fn report_left_over(&self, place: Place, what: &str) -> Reported {
        let report = || self.diagnostics.error(place, mistake::xacro(what));
        let reported = self.left_over.get().unwrap_or_else(report);
        self.left_over.set(Some(reported));
        reported
    }

    /// Reports words of an element in whose place one of those that are known was meant, and the second of two
    /// elements of which one counts. Other words mean something to other programs.
    fn spelled(&self, node: Node, known: &[&str], attributes: &[&str]) {
        const REPEATABLE: [&str; 2] = ["visual", "collision"];
        let element = node.tag_name().name();
        self.require_expanded(node, &[]);
        for child in elements(node) {
            let word = child.tag_name().name();
            if let Some(right) = misspelled(word, known) {
                let mistake = mistake::misspelled(element, "element", word, right);
                self.error(child, mistake);
            }
            let counts = known.contains(&word) && !REPEATABLE.contains(&word);
            let first = counts.then(|| self::child(node, word)).flatten();
            if let Some(first) = first.filter(|first| *first != child) {
                let mistake = mistake::repeated(element, word, self.place(first).position());
                self.error(child, mistake);
            }
        }
        let is_own = |attribute: &Attribute| attribute.namespace().is_none();
        for attribute in node.attributes().filter(is_own) {
            let word = attribute.name();
            if let Some(right) = misspelled(word, attributes) {
                let place = self.text.place(attribute.range().start);
                let mistake = mistake::misspelled(element, "attribute", word, right);
                self.diagnostics.error(place, mistake);
            }
        }
    }

    /// An attribute, unless it says something that xacro should have replaced.
    fn found<'a, 'i>(&self, node: Node<'a, 'i>, name: &str) -> Read<Option<Attribute<'a, 'i>>> {
        let attribute = node.attribute_node(name);
        let is_left = |text: &str| text.contains("${") || text.contains("$(");
        match attribute.filter(|attribute| is_left(attribute.value())) {
            Some(left) => {
                let place = self.text.place(left.range_value().start);
                Err(self.report_left_over(place, left.value()))
            }
            None => Ok(attribute),
        }
    }

    fn attribute<'a, 'i>(&self, node: Node<'a, 'i>, name: &str) -> Read<Attribute<'a, 'i>> {
        let missing = || {
            let element = node.tag_name().name();
            self.error(node, mistake::attribute_missing(element, name))
        };
        self.found(node, name)?.ok_or_else(missing)
    }

    fn name(&self, node: Node) -> Read<String> {
        let name = self.attribute(node, "name")?;
        let word = name.value();
        if word.chars().any(char::is_control) {
            Err(self.error(node, text::control_in_name(word)))
        } else if word.len() > MOST_LETTERS {
            Err(self.error(node, size::name(word)))
        } else {
            Ok(word.to_owned())
        }
    }

    /// An element that has to be there.
    fn part<'a, 'i>(&self, node: Node<'a, 'i>, name: &str) -> Read<Node<'a, 'i>> {
        let missing = || {
            let element = node.tag_name().name();
            self.error(node, mistake::element_missing(element, name))
        };
        child(node, name).ok_or_else(missing)
    }

    fn number(&self, text: &str, place: Place) -> Read<Rational> {
        in_file(text).map_err(|mistake| self.diagnostics.error(place, mistake))
    }

    /// The number in an attribute, and where it is.
    fn value(&self, attribute: Attribute) -> Read<(Rational, Place)> {
        let place = self.text.place(attribute.range_value().start);
        Ok((self.number(attribute.value().trim(), place)?, place))
    }

    fn required(&self, node: Node, name: &str) -> Read<Rational> {
        let attribute = self.attribute(node, name)?;
        self.value(attribute).map(|(value, _)| value)
    }

    fn optional(&self, node: Option<Node>, name: &str) -> Read<Option<(Rational, Place)>> {
        let attribute = node.map(|node| self.found(node, name)).transpose()?;
        let attribute = attribute.flatten();
        attribute.map(|attribute| self.value(attribute)).transpose()
    }

    /// Three numbers, or what stands for them where they are left out.
    fn vector(&self, node: Option<Node>, name: &str, default: [i8; 3]) -> Read<(Vector, Place)> {
        let attribute = node.map(|node| self.found(node, name)).transpose()?;
        let Some(attribute) = attribute.flatten() else {
            let place = node.map_or(Place::File { line: 1, column: 1 }, |node| self.place(node));
            return Ok((default.map(Rational::from), place));
        };
        let start = attribute.range_value().start;
        let place = self.text.place(start);
        let numbers = attribute.value().split_whitespace();
        let numbers: Read<Vec<_>> = numbers.map(|number| self.number(number, place)).collect();
        let numbers = numbers?;
        let count = numbers.len();
        let vector = numbers.try_into();
        let vector = vector.map_err(|_| {
            self.diagnostics
                .error(place, mistake::three_numbers(name, count))
        })?;
        Ok((vector, place))
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
            xyz,
            rpy,
            axis: axis?,
            damping: damping?,
            friction: friction?,
            limits: limits?,
            effort: effort?,
            velocity: velocity?,
            mimic: mimic.transpose()?,
        })
    }

    fn mimic(&mut self, node: Node, kind: Kind) -> Read<Mimic> {
        let joint = self.attribute(node, "joint");
        let number = |name: &str, default: i8| {
            let number = self.optional(Some(node), name)?;
            Ok(number.map_or(Rational::from(default), |(number, _)| number))
        };
        let (multiplier, offset) = (number("multiplier", 1), number("offset", 0));
        Ok(Mimic {
            place: self.place(node),
            joint: joint?.value().to_owned(),
            multiplier: multiplier?,
            offset: match kind {
                Kind::Revolute => self.rounding.angle(offset?),
                _ => Value::Rational(offset?),
            },
        })
    }

    fn kind(&self, node: Node) -> Read<Kind> {
        const KNOWN: [&str; 4] = ["revolute", "continuous", "prismatic", "fixed"];
        const OTHERS: [&str; 4] = ["floating", "planar", "spherical", "ball"];
        let attribute = self.attribute(node, "type")?;
        Ok(match attribute.value() {
            "revolute" | "continuous" => Kind::Revolute,
            "prismatic" => Kind::Prismatic,
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
        if !matches!(kind, Kind::Revolute | Kind::Prismatic) {
            return Ok([Value::zero(), Value::zero()]);
        }
        let (axis, place) = self.vector(child(node, "axis"), "xyz", [1, 0, 0])?;
        let zero = || self.diagnostics.error(place, mistake::axis_of_no_length());
        direction(&self.rounding.axis(axis)).ok_or_else(zero)
    }

    /// The greatest effort or velocity of `<limit>`, where it says something: many files have 0 there, or -1.
    fn greatest(&self, node: Node, name: &str) -> Read<Option<(Rational, Place)>> {
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
