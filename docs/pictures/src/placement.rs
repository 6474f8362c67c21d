//! Frames and signs: base, joints, tool, the wrench at the tip, and the motor's side of a gear.

use std::f64::consts::FRAC_PI_2;

use measuring::drawing::{At, Drawing, Letters};

use crate::Picture;

const SIZE: [f64; 2] = [880.0, 560.0];
const AXIS: f64 = 48.0;
const WORLD: At = [52.0, 372.0];
const SHOULDER: At = [176.0, 316.0];
/// The angle of frame 0 in the world, and those of the joints.
const BASE: f64 = 0.22;
const JOINTS: [f64; 2] = [0.85, -0.75];
const LENGTHS: [f64; 2] = [180.0, 190.0];

pub(crate) fn picture() -> Picture {
    let title = "Frames and signs of base, joints, tool, wrench and motor";
    let mut drawing = Drawing::new(title, SIZE);
    arm(&mut drawing);
    signs(&mut drawing);
    motor(&mut drawing);
    Picture {
        name: "placement",
        drawing,
        alternative: ALTERNATIVE.replace('\n', " "),
        documents: &["docs/guide/src/tool_and_load.md", "docs/NOTATION.md"],
    }
}

const ALTERNATIVE: &str = "\
An arm of two links in a plane, all z axes towards you, in the standard convention. An arrow `base: {xyz, rpy}` leads from
the world's frame to frame 0, which is turned against it and sits at the first joint. Joint 1 turns about z of frame 0:
from its x axis to the first link the angle theta + q1 is positive anticlockwise, and so is the torque tau2 on the second
link at joint 2. An arrow `tool:
{xyz, rpy}` leads from frame n, at the end of the last link, to the tool frame. At the tool's origin act the force (fx, fy,
fz) and the moment (nx, ny, nz) of the surroundings on the tip, in axes of the world: M qdd + V + G + K + F = tau + J' w.
Gravity is an acceleration in axes of the world. Below, a rotor with its inertia turns a gear and the gear a joint. On the
motor's side q_m = gear_ratio q and tau_m = tau / gear_ratio. On the joint's side are q and tau, friction and springs. M_ii
gets gear_ratio^2 times the rotor's inertia.";

/// A place at this distance in this direction.
fn from([x, y]: At, distance: f64, angle: f64) -> At {
    [x + distance * angle.cos(), y - distance * angle.sin()]
}

/// An arrow around a place.
fn turn(drawing: &mut Drawing, ink: &str, centre: At, radius: f64, [begin, end]: [f64; 2]) {
    let angle = |k: i32| begin + (end - begin) * f64::from(k) / 32.0;
    let places: Vec<At> = (0..=32).map(|k| from(centre, radius, angle(k))).collect();
    drawing.arrow(ink, 2.0, &places);
}

const LABEL: Letters = Letters::PLAIN.size(14.0);

/// The axes of a frame whose z axis is towards the reader.
fn frame(drawing: &mut Drawing, origin: At, angle: f64, index: &str, shift: [At; 2]) {
    for (number, (name, ink)) in [("x", "red"), ("y", "green")].into_iter().enumerate() {
        let end = from(origin, AXIS, angle + FRAC_PI_2 * number as f64);
        drawing.arrow(ink, 2.5, &[origin, end]);
        let at = [0, 1].map(|k| end[k] + shift[number][k]);
        let words = match index {
            "" => name.to_owned(),
            index => format!("{name}_{{{index}}}"),
        };
        drawing.text(at, LABEL.ink(ink), &words);
    }
    drawing.disc("joint", origin, 6.0);
    drawing.disc("blue", origin, 2.5);
}

fn arm(drawing: &mut Drawing) {
    let first = BASE + JOINTS[0];
    let second = first + JOINTS[1];
    let elbow = from(SHOULDER, LENGTHS[0], first);
    let end = from(elbow, LENGTHS[1], second);
    drawing.stroke("link-a", 16.0, &[SHOULDER, elbow]);
    drawing.stroke("link-b", 16.0, &[elbow, end]);
    drawing.disc("joint", elbow, 7.0);
    // The world and frame 0.
    drawing.dashed_arrow("ink", 1.5, &[WORLD, from(SHOULDER, 12.0, 3.6)]);
    drawing.text([112.0, 366.0], LABEL.mono(), "base: {xyz, rpy}");
    frame(drawing, WORLD, 0.0, "", [[5.0, 14.0], [-4.0, -6.0]]);
    drawing.text([24.0, 396.0], LABEL.bold(), "world");
    drawing.dashes("faint", 1.5, &[SHOULDER, from(SHOULDER, 132.0, BASE)]);
    frame(drawing, SHOULDER, BASE, "0", [[2.0, 16.0], [-18.0, -4.0]]);
    drawing.text(
        [SHOULDER[0] - 92.0, SHOULDER[1] - 2.0],
        LABEL.bold(),
        "frame 0",
    );
    turn(drawing, "blue", SHOULDER, 100.0, [BASE, first - 0.1]);
    drawing.text([276.0, 262.0], LABEL.ink("blue"), "theta + q_{1} > 0");
    turn(drawing, "blue", elbow, 34.0, [0.8, 3.5]);
    drawing.text([196.0, 114.0], LABEL.ink("blue"), "tau_{2} > 0");
    // Frame n and the tool.
    frame(drawing, end, second, "n", [[2.0, -8.0], [-10.0, -6.0]]);
    drawing.text([end[0] - 84.0, end[1] - 26.0], LABEL.bold(), "frame n");
    let tool = [end[0] + 92.0, end[1] + 74.0];
    drawing.dashed_arrow("ink", 1.5, &[from(end, 8.0, -0.68), from(tool, 10.0, 2.46)]);
    drawing.text(
        [end[0] - 98.0, end[1] + 62.0],
        LABEL.mono(),
        "tool: {xyz, rpy}",
    );
    frame(
        drawing,
        tool,
        second - 0.6,
        "tool",
        [[4.0, 14.0], [8.0, 4.0]],
    );
    drawing.text(
        [tool[0] - 96.0, tool[1] + 24.0],
        LABEL.bold(),
        "tool, the tip",
    );
    wrench(drawing, tool);
}

fn signs(drawing: &mut Drawing) {
    let note = Letters::PLAIN.ink("faint");
    drawing.arrow("ink", 2.5, &[[52.0, 130.0], [52.0, 186.0]]);
    drawing.text([64.0, 152.0], LABEL.mono(), "gravity");
    drawing.text([64.0, 172.0], note, "an acceleration");
    drawing.text([64.0, 190.0], note, "in axes of the world");
    drawing.text([20.0, 34.0], LABEL.bold(), "All z axes are towards you.");
    drawing.text([20.0, 56.0], note, "Positive angles and torques turn");
    drawing.text([20.0, 74.0], note, "anticlockwise, about z.");
    let words = [
        "wrench w: of the surroundings",
        "on the tip, about its origin,",
        "in axes of the world",
    ];
    for (number, words) in words.into_iter().enumerate() {
        let letters = if number == 0 { LABEL.bold() } else { note };
        drawing.text([632.0, 34.0 + 20.0 * number as f64], letters, words);
    }
    let words = "M qdd + V + G + K + F = tau + J' w";
    drawing.text([600.0, 400.0], LABEL.bold(), words);
}

fn wrench(drawing: &mut Drawing, tool: At) {
    let end = from(tool, 116.0, 0.35);
    drawing.arrow("ink", 3.0, &[tool, end]);
    drawing.text([end[0] + 8.0, end[1] + 4.0], LABEL, "(f_{x}, f_{y}, f_{z})");
    turn(drawing, "ink", tool, 56.0, [4.0, 5.6]);
    drawing.text(
        [tool[0] + 42.0, tool[1] + 64.0],
        LABEL,
        "(n_{x}, n_{y}, n_{z})",
    );
}

fn motor(drawing: &mut Drawing) {
    let note = Letters::PLAIN.ink("faint");
    let (top, shaft) = (424.0, 488.0);
    drawing.rectangle("band", [10.0, top], [SIZE[0] - 20.0, 126.0], 8.0);
    for [begin, end] in [[116.0, 372.0], [482.0, 740.0]] {
        drawing.stroke("ink", 4.0, &[[begin, shaft], [end, shaft]]);
    }
    let boxes = [
        (26.0, 90.0, "rotor", "inertia"),
        (372.0, 110.0, "gear", "gear_ratio"),
        (740.0, 114.0, "joint i", "row i"),
    ];
    for (x, width, name, more) in boxes {
        drawing.rectangle("box", [x, shaft - 30.0], [width, 60.0], 6.0);
        let middle = x + 0.5 * width;
        drawing.text([middle, shaft - 4.0], LABEL.bold().centred(), name);
        drawing.text([middle, shaft + 16.0], note.centred(), more);
    }
    let sides = [
        (
            244.0,
            "motor's side",
            ["q_{m} = gear_ratio q", "tau_{m} = tau / gear_ratio"],
        ),
        (
            611.0,
            "joint's side: q, tau",
            ["friction and springs;", "M_{ii} has gear_ratio^2 inertia"],
        ),
    ];
    for (x, name, lines) in sides {
        drawing.text([x, shaft - 16.0], LABEL.bold().centred(), name);
        for (number, line) in lines.into_iter().enumerate() {
            let y = shaft + 24.0 + 20.0 * number as f64;
            drawing.text([x, y], LABEL.size(13.0).centred(), line);
        }
    }
}
