//! A robot as URDF: a link behind each joint, whose frame has the joint's axis as z, one at each frame, and a last one at
//! the tip if there is a tip.

use std::collections::BTreeSet;
use std::slice::from_ref;

use dynamics_codegen::geometry::{Body, Transform, number};
use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::{Body as Fixed, JointType, Row, Value};

use super::angle::{Angle, Origin, origins};
use super::arm::{Arm, Joint, Place};
use super::number::{decimal, radians};

/// The first link and the one at the tip, if no frame has the name.
const CHAIN: [&str; 2] = ["base", "tip"];

/// The parts of joints that URDF has no words for: a word of [`crate::arguments::WITHOUT`], and a sentence.
pub(super) fn without_words(arm: &Arm) -> Vec<(&'static str, String)> {
    let mut parts = Vec::new();
    for joint in &arm.joints {
        let row = joint.row;
        let mut note = |word: &'static str, what: &str| {
            parts.push((word, format!("`{}` has {what}", row.name)));
        };
        if row.has_motor() && !row.motor_inertia.is_zero() {
            note("motor", "a motor with inertia");
        }
        if row.spring.is_some() {
            note("spring", "a spring");
        }
        if row.stribeck.is_some() {
            note("friction", "static friction that falls with the velocity");
        }
        if row.coulomb[0] != row.coulomb[1] {
            note("friction", "friction that differs by direction");
        }
    }
    parts
}

/// Where the robot begins and ends, as a sentence without its end.
pub(super) fn extent(arm: &Arm) -> String {
    let mut names = Names::new(arm);
    let [base, tip] = CHAIN.map(|link| names.link(link));
    let extent = match arm.tip {
        Some(_) => format!("The arm is the chain from {base} to {tip}"),
        None => format!("The robot is all that {base} carries"),
    };
    match arm.base {
        Some(_) => format!("{extent}, and {base} moves (`base: floating`)"),
        None => extent,
    }
}

/// A sentence on the order of the joints, where the file has another one: it is read depth first.
pub(super) fn order(arm: &Arm) -> Option<String> {
    let mut order: Vec<usize> = Vec::new();
    let mut open: Vec<usize> = arm.children(None).collect();
    open.reverse();
    while let Some(joint) = open.pop() {
        order.push(joint);
        let mut children: Vec<usize> = arm.children(Some(joint)).collect();
        children.reverse();
        open.append(&mut children);
    }
    let names = order.iter().map(|joint| &*arm.joints[*joint].row.name);
    let names: Vec<&str> = names.collect();
    let sentence = format!(
        "The joints of a file are read depth first: {}.",
        names.join(", ")
    );
    (!order.is_sorted()).then_some(sentence)
}

/// The text of an arm, without the parts that it has no words for.
pub(super) fn text(name: &str, arm: &Arm, remarks: &[String]) -> String {
    let mut names = Names::new(arm);
    let [base, tip] = CHAIN.map(|link| names.link(link));
    let mut writer = Writer {
        text: String::new(),
        names,
    };
    writer.line(0, "<?xml version=\"1.0\"?>");
    for remark in remarks {
        // Two hyphens end a comment.
        writer.line(0, &format!("<!-- {} -->", remark.replace("--", "- -")));
    }
    writer.line(0, &format!("<robot name={}>", quoted(name)));
    let body = arm.base.as_ref().map(|base| base.body());
    writer.link(&base, body.as_ref());
    let mut links: Vec<String> = Vec::new();
    let on = |place: Option<usize>, frame: &Transform, links: &[String]| match place {
        None => (base.clone(), frame.clone()),
        Some(joint) => {
            let inverse = arm.joints[joint].frame.inverse();
            (links[joint].clone(), inverse.then(frame).tidy())
        }
    };
    for joint in &arm.joints {
        let (parent, origin) = on(joint.parent, &joint.frame, &links);
        let link = writer.names.link(&format!("{}_link", joint.row.name));
        writer.joint(joint, [&parent, &link], &origin, arm);
        writer.link(&link, Some(&joint.body.body()));
        links.push(link);
    }
    let mut end = |name: &str, place: &Place, body: Option<&Fixed>| {
        let (parent, origin) = on(place.on, &place.frame, &links);
        let body = body.map(|body| [from_ref(&body.mass), &body.com, &body.inertia]);
        writer.end(name, &parent, &origin, body.map(body_of_values).as_ref());
    };
    for (place, frame) in arm.frames.iter().zip(&arm.robot.frames) {
        end(&frame.name, place, frame.body.as_ref());
    }
    if let Some(place) = &arm.tip {
        let tool = arm.robot.tool.as_ref().filter(|tool| tool.has_body());
        end(&tip, place, tool.map(|tool| &tool.body));
    }
    writer.line(0, "</robot>");
    writer.text
}

/// Names that are taken.
struct Names {
    joints: BTreeSet<String>,
    links: BTreeSet<String>,
}

impl Names {
    /// The names of the joints, and of the frames, each of which is a link.
    fn new(arm: &Arm) -> Self {
        let joints = arm.joints.iter().map(|joint| joint.row.name.clone());
        let frames = arm.robot.frames.iter().map(|frame| frame.name.clone());
        Names {
            joints: joints.collect(),
            links: frames.collect(),
        }
    }

    /// A free name of a link.
    fn link(&mut self, name: &str) -> String {
        free(name.to_owned(), &mut self.links)
    }
}

/// A name like the given one, which is then taken.
fn free(mut name: String, taken: &mut BTreeSet<String>) -> String {
    while !taken.insert(name.clone()) {
        name.push('_');
    }
    name
}

/// A body by its mass, its centre of mass and its tensor.
fn body_of_values([mass, com, inertia]: [&[Value]; 3]) -> Body {
    let of = |value: &Value| number(value).unwrap_or(Rational::ZERO);
    Body {
        mass: of(&mass[0]),
        com: [0, 1, 2].map(|k| of(&com[k])),
        inertia: [0, 1, 2, 3, 4, 5].map(|k| of(&inertia[k])),
    }
}

struct Writer {
    text: String,
    names: Names,
}

impl Writer {
    fn line(&mut self, depth: usize, line: &str) {
        let indent = "  ".repeat(depth);
        self.text.push_str(&format!("{indent}{line}\n"));
    }

    /// A link with its body.
    fn link(&mut self, name: &str, body: Option<&Body>) {
        let Some(Body { mass, com, inertia }) = body else {
            self.line(1, &format!("<link name={}/>", quoted(name)));
            return;
        };
        self.line(1, &format!("<link name={}>", quoted(name)));
        self.line(2, "<inertial>");
        self.line(3, &format!("<origin xyz=\"{}\" rpy=\"0 0 0\"/>", all(com)));
        self.line(3, &format!("<mass value=\"{}\"/>", decimal(mass)));
        let words = ["ixx", "iyy", "izz", "ixy", "iyz", "ixz"];
        let entry = |(word, x): (&str, &Rational)| format!(" {word}=\"{}\"", decimal(x));
        let tensor: String = words.into_iter().zip(inertia).map(entry).collect();
        self.line(3, &format!("<inertia{tensor}/>"));
        self.line(2, "</inertial>");
        self.line(1, "</link>");
    }

    /// The links that a joint joins, and where it is.
    fn ends(&mut self, [parent, child]: [&str; 2], (xyz, rpy): &Origin) {
        self.line(2, &format!("<parent link={}/>", quoted(parent)));
        self.line(2, &format!("<child link={}/>", quoted(child)));
        let rpy = rpy.each_ref().map(radians).join(" ");
        let xyz = all(xyz);
        self.line(2, &format!("<origin xyz=\"{xyz}\" rpy=\"{rpy}\"/>"));
    }

    /// Leads from a link to the last of some places, by links without bodies: that place, and the link that it
    /// is in.
    fn lead(&mut self, parent: &str, joint: &str, origin: &Transform) -> (String, Origin) {
        let mut parent = parent.to_owned();
        let mut places = origins(origin);
        let last = places.pop();
        for (index, place) in places.iter().enumerate() {
            let link = self.names.link(&format!("{joint}_place_{}", index + 1));
            self.fixed(&link, [&parent, &link], place);
            self.link(&link, None);
            parent = link;
        }
        let nowhere = || (origin.origin.clone(), [0; 3].map(|_| Angle::ZERO));
        (parent, last.unwrap_or_else(nowhere))
    }

    /// A joint that does not move; its name is free.
    fn fixed(&mut self, name: &str, links: [&str; 2], place: &Origin) {
        let name = free(format!("{name}_joint"), &mut self.names.joints);
        self.line(1, &format!("<joint name={} type=\"fixed\">", quoted(&name)));
        self.ends(links, place);
        self.line(1, "</joint>");
    }

    fn joint(&mut self, joint: &Joint, [parent, child]: [&str; 2], origin: &Transform, arm: &Arm) {
        let row = joint.row;
        let (parent, place) = self.lead(parent, &row.name, origin);
        let kind = match (row.joint_type, &row.limits) {
            (JointType::Prismatic, _) => "prismatic",
            (JointType::Revolute, Some(_)) => "revolute",
            (JointType::Revolute, None) => "continuous",
        };
        let name = quoted(&row.name);
        self.line(1, &format!("<joint name={name} type=\"{kind}\">"));
        self.ends([&parent, child], &place);
        self.line(2, "<axis xyz=\"0 0 1\"/>");
        self.limit(row);
        self.dynamics(row);
        if let Some(coupling) = &row.follows {
            let leader = quoted(&arm.robot.rows[coupling.leader].name);
            let [factor, offset] = [&coupling.factor, &coupling.offset].map(shown);
            let law = format!("multiplier=\"{factor}\" offset=\"{offset}\"");
            self.line(2, &format!("<mimic joint={leader} {law}/>"));
        }
        self.line(1, "</joint>");
    }

    /// URDF requires the greatest effort and velocity too: where the table has none, they are so great that they bound
    /// nothing.
    fn limit(&mut self, row: &Row) {
        const NONE: &str = "1000000000";
        let bounds = match (&row.limits, row.joint_type) {
            (Some([lower, upper]), _) => Some([lower, upper].map(shown)),
            (None, JointType::Prismatic) => Some([format!("-{NONE}"), NONE.to_owned()]),
            (None, JointType::Revolute) => None,
        };
        let greatest = [&row.torque_limit, &row.velocity_limit];
        if bounds.is_none() && greatest.iter().all(|limit| limit.is_none()) {
            return;
        }
        let bounds = bounds.map_or(String::new(), |[lower, upper]| {
            format!("lower=\"{lower}\" upper=\"{upper}\" ")
        });
        let [effort, velocity] =
            greatest.map(|limit| limit.as_ref().map_or(NONE.to_owned(), shown));
        let line = format!("<limit {bounds}effort=\"{effort}\" velocity=\"{velocity}\"/>");
        self.line(2, &line);
    }

    fn dynamics(&mut self, row: &Row) {
        let [positive, negative] = &row.coulomb;
        // Friction that differs by direction is left out.
        let coulomb = if positive == negative {
            shown(positive)
        } else {
            "0".to_owned()
        };
        let damping = shown(&row.viscous);
        if damping != "0" || coulomb != "0" {
            self.line(
                2,
                &format!("<dynamics damping=\"{damping}\" friction=\"{coulomb}\"/>"),
            );
        }
    }

    /// A link that is fixed to another one.
    fn end(&mut self, name: &str, parent: &str, origin: &Transform, body: Option<&Body>) {
        let (parent, place) = self.lead(parent, name, origin);
        self.fixed(name, [&parent, name], &place);
        self.link(name, body);
    }
}

fn shown(value: &Value) -> String {
    decimal(&number(value).unwrap_or(Rational::ZERO))
}

fn all(numbers: &[Rational]) -> String {
    let numbers: Vec<_> = numbers.iter().map(decimal).collect();
    numbers.join(" ")
}

fn quoted(text: &str) -> String {
    let escaped = text.replace('&', "&amp;").replace('"', "&quot;");
    format!("\"{}\"", escaped.replace('<', "&lt;"))
}
