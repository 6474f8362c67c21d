//! An arm as URDF: a link behind each joint, whose frame has the joint's axis as z, and a last one at the tip.

use std::collections::BTreeSet;

use dynamics_codegen::geometry::{Body, Transform, Vector, number};
use dynamics_symbolic::exact::Rational;
use dynamics_symbolic::robot::{JointType, Row, Value};

use super::angle::{Angle, roll_pitch_yaw};
use super::arm::{Arm, Joint};
use super::number::{decimal, radians};

/// The first and the last link.
pub(super) const CHAIN: [&str; 2] = ["base", "tip"];

/// The options for parts of an arm that URDF has no words for.
pub(super) const WITHOUT: [&str; 3] = ["motor", "spring", "friction"];

/// The parts of joints that URDF has no words for: a word of [`WITHOUT`], and a sentence.
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

/// The text of an arm, without the parts that it has no words for.
pub(super) fn text(name: &str, arm: &Arm, remarks: &[String]) -> String {
    let names = arm.joints.iter().map(|joint| joint.row.name.clone());
    let mut writer = Writer {
        text: String::new(),
        names: names.collect(),
    };
    writer.line(0, "<?xml version=\"1.0\"?>");
    for remark in remarks {
        // Two hyphens end a comment.
        writer.line(0, &format!("<!-- {} -->", remark.replace("--", "- -")));
    }
    writer.line(0, &format!("<robot name={}>", quoted(name)));
    writer.line(1, &format!("<link name={}/>", quoted(CHAIN[0])));
    let mut parent = (CHAIN[0].to_owned(), Transform::identity());
    for joint in &arm.joints {
        let link = format!("{}_link", joint.row.name);
        let origin = parent.1.inverse().then(&joint.frame).tidy();
        writer.joint(joint, [&parent.0, &link], &origin, arm);
        writer.link(&link, Some(&joint.body.body()));
        parent = (link, joint.frame.clone());
    }
    let origin = parent.1.inverse().then(&arm.tip).tidy();
    writer.tip(&parent.0, &origin, arm);
    writer.line(0, "</robot>");
    writer.text
}

/// A frame by xyz and rpy.
type Place = (Vector, [Angle; 3]);

/// A frame in as many places, each in the one before it, as it takes for angles to mean what they say.
fn places(frame: &Transform) -> Vec<Place> {
    let [roll, pitch, yaw] = roll_pitch_yaw(&frame.rotation).map(Angle::split);
    let xyz = frame.origin.clone();
    if roll.0.is_none() && pitch.0.is_none() && yaw.0.is_none() {
        return vec![(xyz, [roll.1, pitch.1, yaw.1])];
    }
    // Rz(whole) Rz(rest) Ry(whole) Ry(rest) Rx(whole) Rx(rest), for Rz Ry Rx is one place.
    let whole = |(whole, _): &(Option<Angle>, Angle)| whole.clone().unwrap_or(Angle::ZERO);
    let (zero, nowhere) = (|| Angle::ZERO, || [Rational::ZERO; 3]);
    vec![
        (xyz, [zero(), zero(), whole(&yaw)]),
        (nowhere(), [zero(), whole(&pitch), yaw.1.clone()]),
        (nowhere(), [whole(&roll), pitch.1.clone(), zero()]),
        (nowhere(), [roll.1, zero(), zero()]),
    ]
}

struct Writer {
    text: String,
    /// Names of joints that are taken.
    names: BTreeSet<String>,
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
    fn ends(&mut self, [parent, child]: [&str; 2], (xyz, rpy): &Place) {
        self.line(2, &format!("<parent link={}/>", quoted(parent)));
        self.line(2, &format!("<child link={}/>", quoted(child)));
        let rpy = rpy.each_ref().map(radians).join(" ");
        let xyz = all(xyz);
        self.line(2, &format!("<origin xyz=\"{xyz}\" rpy=\"{rpy}\"/>"));
    }

    /// Leads from a link to the last of some places, by links without bodies: that place, and the link that it
    /// is in.
    fn lead(&mut self, parent: &str, joint: &str, origin: &Transform) -> (String, Place) {
        let mut parent = parent.to_owned();
        let mut places = places(origin);
        let last = places.pop();
        for (index, place) in places.iter().enumerate() {
            let link = format!("{joint}_place_{}", index + 1);
            self.fixed(&link, [&parent, &link], place);
            self.link(&link, None);
            parent = link;
        }
        let nowhere = || (origin.origin.clone(), [0; 3].map(|_| Angle::ZERO));
        (parent, last.unwrap_or_else(nowhere))
    }

    /// A joint that does not move; its name is free.
    fn fixed(&mut self, name: &str, links: [&str; 2], place: &Place) {
        let mut name = format!("{name}_joint");
        while !self.names.insert(name.clone()) {
            name.push('_');
        }
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

    /// URDF asks for the greatest effort and velocity too: where the table has none, they are so great that they bound
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

    fn tip(&mut self, parent: &str, origin: &Transform, arm: &Arm) {
        let (parent, place) = self.lead(parent, CHAIN[1], origin);
        self.fixed(CHAIN[1], [&parent, CHAIN[1]], &place);
        let tool = arm.robot.tool.as_ref().filter(|tool| tool.has_body());
        let body = tool.map(|tool| {
            let of = |value: &Value| number(value).unwrap_or(Rational::ZERO);
            Body {
                mass: of(&tool.mass),
                com: tool.com.each_ref().map(of),
                inertia: tool.inertia.each_ref().map(of),
            }
        });
        self.link(CHAIN[1], body.as_ref());
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
