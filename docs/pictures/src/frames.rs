//! Where the frames of two links sit, in either convention.

use measuring::drawing::{At, Drawing, Letters};

use crate::Picture;

const SIZE: [f64; 2] = [880.0, 350.0];
/// Lengths of the links, and their angles from the horizontal.
const LENGTHS: [f64; 2] = [170.0, 150.0];
const ANGLES: [f64; 2] = [0.873, 0.209];
const AXIS: f64 = 54.0;

pub(crate) fn picture() -> Picture {
    let title = "Two links in a plane: where the frames sit";
    let mut drawing = Drawing::new(title, SIZE);
    half(&mut drawing, 20.0, true);
    half(&mut drawing, 460.0, false);
    drawing.stroke("faint", 1.0, &[[440.0, 20.0], [440.0, 330.0]]);
    Picture {
        name: "frames",
        drawing,
        alternative: "Two links in a plane. In the standard convention frame 0 sits at the shoulder, along the \
                      horizontal, frame 1 at the elbow and frame 2 at the tip; the centres of mass are at x = -l/2 of \
                      their frames. In the modified convention frame 1 sits at the shoulder and frame 2 at the elbow; the \
                      centres of mass are at x = +l/2, and no frame is at the tip. The x axis of each link's frame is \
                      along its link."
            .to_owned(),
        documents: &["docs/guide/src/conventions.md"],
    }
}

/// A place at this distance in this direction.
fn from([x, y]: At, distance: f64, angle: f64) -> At {
    [x + distance * angle.cos(), y - distance * angle.sin()]
}

fn half(drawing: &mut Drawing, left: f64, is_standard: bool) {
    let shoulder = [left + 50.0, 270.0];
    let elbow = from(shoulder, LENGTHS[0], ANGLES[0]);
    let tip = from(elbow, LENGTHS[1], ANGLES[1]);
    let name = match is_standard {
        true => "convention: standard",
        false => "convention: modified (Craig)",
    };
    drawing.text([left, 32.0], Letters::PLAIN.bold().size(17.0), name);
    drawing.stroke("faint", 3.0, &[[left + 16.0, 284.0], [left + 84.0, 284.0]]);
    drawing.stroke("link-a", 16.0, &[shoulder, elbow]);
    drawing.stroke("link-b", 16.0, &[elbow, tip]);
    for joint in [shoulder, elbow] {
        drawing.disc("joint", joint, 7.0);
    }
    let label = Letters::PLAIN.size(15.0);
    if is_standard {
        frame(drawing, shoulder, 0.0, 0);
        drawing.text([left + 30.0, 312.0], label, "frame 0");
        frame(drawing, elbow, ANGLES[0], 1);
        drawing.text([elbow[0] + 10.0, elbow[1] + 32.0], label, "frame 1");
        frame(drawing, tip, ANGLES[1], 2);
        drawing.text([tip[0] - 6.0, tip[1] + 32.0], label, "frame 2");
    } else {
        frame(drawing, shoulder, ANGLES[0], 1);
        drawing.text([left + 30.0, 308.0], label, "frame 1");
        frame(drawing, elbow, ANGLES[1], 2);
        drawing.text([elbow[0] + 10.0, elbow[1] + 34.0], label, "frame 2");
        let at = [tip[0] + 30.0, tip[1] - 22.0];
        drawing.text(at, label.left().ink("faint"), "no frame at the tip");
    }
    let sign = if is_standard { '-' } else { '+' };
    let words = format!("com = [{sign}l/2, 0, 0]");
    let (first, second) = (
        from(shoulder, 0.5 * LENGTHS[0], ANGLES[0]),
        from(elbow, 0.5 * LENGTHS[1], ANGLES[1]),
    );
    let below = [second[0] + 18.0, second[1] + 64.0];
    drawing.stroke("blue", 1.0, &[second, below]);
    for (centre, at) in [
        (first, [first[0] + 16.0, first[1] + 24.0]),
        (second, [below[0] - 36.0, below[1] + 16.0]),
    ] {
        drawing.disc("blue", centre, 5.0);
        drawing.text(at, label.ink("blue"), &words);
    }
}

/// The axes of a frame in the plane.
fn frame(drawing: &mut Drawing, origin: At, angle: f64, number: usize) {
    let right = std::f64::consts::FRAC_PI_2;
    let label = Letters::PLAIN.size(15.0);
    let end = from(origin, AXIS, angle);
    drawing.arrow("red", 2.5, &[origin, end]);
    drawing.text(
        [end[0] + 6.0, end[1] + 12.0],
        label.ink("red"),
        &format!("x_{{{number}}}"),
    );
    let end = from(origin, AXIS, angle + right);
    drawing.arrow("green", 2.5, &[origin, end]);
    drawing.text(
        [end[0] - 8.0, end[1] - 7.0],
        label.ink("green"),
        &format!("y_{{{number}}}"),
    );
}
