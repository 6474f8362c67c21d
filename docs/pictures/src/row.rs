//! One row of a table in either convention.

use measuring::drawing::{At, Drawing, Letters};

use crate::Picture;

const SIZE: [f64; 2] = [880.0, 420.0];
/// A unit along x, y and z, as it is seen.
const SEEN: [At; 3] = [[60.0, 12.0], [33.0, -24.0], [0.0, -63.0]];
const THETA: f64 = 0.9;
const ALPHA: f64 = 0.7;
/// The lengths a and d, in units.
const A: f64 = 3.0;
const D: f64 = 1.65;

type Vector = [f64; 3];

/// A frame: its origin and its axes.
#[derive(Clone, Copy)]
struct Frame {
    origin: Vector,
    axes: [Vector; 3],
}

impl Frame {
    const FIRST: Frame = Frame {
        origin: [0.0; 3],
        axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
    };

    /// A place given in this frame.
    fn place(&self, place: Vector) -> Vector {
        let [x, y, z] = place;
        let [ex, ey, ez] = self.axes;
        [0, 1, 2].map(|k| self.origin[k] + x * ex[k] + y * ey[k] + z * ez[k])
    }

    fn shifted(self, by: Vector) -> Frame {
        let origin = self.place(by);
        Frame { origin, ..self }
    }

    /// Turned about z.
    fn about_z(self, angle: f64) -> Frame {
        let [x, y, z] = self.axes;
        let (s, c) = angle.sin_cos();
        let turned = |a: f64, b: f64| [0, 1, 2].map(|k| a * x[k] + b * y[k]);
        let axes = [turned(c, s), turned(-s, c), z];
        Frame { axes, ..self }
    }

    /// Turned about x.
    fn about_x(self, angle: f64) -> Frame {
        let [x, y, z] = self.axes;
        let (s, c) = angle.sin_cos();
        let turned = |a: f64, b: f64| [0, 1, 2].map(|k| a * y[k] + b * z[k]);
        let axes = [x, turned(c, s), turned(-s, c)];
        Frame { axes, ..self }
    }
}

/// Where the first frame is in the drawing.
#[derive(Clone, Copy)]
struct View(At);

impl View {
    fn at(self, [x, y, z]: Vector) -> At {
        let [ex, ey, ez] = SEEN;
        [0, 1].map(|k| self.0[k] + x * ex[k] + y * ey[k] + z * ez[k])
    }

    /// The axes x and z, with this index.
    fn axes(self, drawing: &mut Drawing, frame: Frame, index: &str, shift: [At; 2]) {
        let origin = self.at(frame.origin);
        let ends = [[1.05, 0.0, 0.0], [0.0, 0.0, 1.0]].map(|end| self.at(frame.place(end)));
        for (number, (name, ink)) in [("x", "red"), ("z", "blue")].into_iter().enumerate() {
            drawing.arrow(ink, 2.5, &[origin, ends[number]]);
            let at = [0, 1].map(|k| ends[number][k] + shift[number][k]);
            let letters = Letters::PLAIN.ink(ink).size(15.0);
            drawing.text(at, letters, &format!("{name}_{{{index}}}"));
        }
    }

    /// An arrow around a frame's axis: from the place `of(0)` to `of(1)`.
    fn turn(self, drawing: &mut Drawing, of: impl Fn(f64) -> Vector) {
        let places: Vec<At> = (0..=24).map(|k| self.at(of(f64::from(k) / 24.0))).collect();
        drawing.arrow("ink", 1.5, &places);
    }
}

pub(crate) fn picture() -> Picture {
    let title = "One row of the table in the standard and in the modified convention";
    let mut drawing = Drawing::new(title, SIZE);
    standard(&mut drawing);
    modified(&mut drawing);
    drawing.stroke("faint", 1.0, &[[440.0, 20.0], [440.0, 400.0]]);
    Picture {
        name: "row",
        drawing,
        alternative: "In the standard convention a row turns by theta about z and shifts by d along it, and then shifts \
                      by a along the new x and turns by alpha about it: Rz(theta) Tz(d) Tx(a) Rx(alpha). Joint i turns \
                      about z of frame i-1, or slides along it. In the modified convention it turns by alpha about x and \
                      shifts by a along it, and then turns by theta about the new z and shifts by d along it: Rx(alpha) \
                      Tx(a) Rz(theta) Tz(d). Joint i turns about z of frame i itself, or slides along it."
            .to_owned(),
        documents: &["docs/guide/src/conventions.md"],
    }
}

const NAME: Letters = Letters::PLAIN.size(15.0);
const NOTE: Letters = Letters::PLAIN.ink("faint");

fn standard(drawing: &mut Drawing) {
    let view = View([100.0, 330.0]);
    drawing.text(
        [20.0, 32.0],
        NAME.bold(),
        "standard: Rz(theta) Tz(d) Tx(a) Rx(alpha)",
    );
    let first = Frame::FIRST;
    let turned = first.about_z(THETA);
    let raised = turned.shifted([0.0, 0.0, D]);
    let shifted = raised.shifted([A, 0.0, 0.0]);
    let last = shifted.about_x(ALPHA);
    let places = [first, raised, shifted].map(|frame| view.at(frame.origin));
    drawing.stroke("link-a", 8.0, &places);
    drawing.dashes(
        "faint",
        1.5,
        &[places[0], view.at(turned.place([1.5, 0.0, 0.0]))],
    );
    drawing.dashes(
        "faint",
        1.5,
        &[places[2], view.at(shifted.place([0.0, 0.0, 1.3]))],
    );
    view.axes(drawing, first, "i-1", [[6.0, 10.0], [8.0, 2.0]]);
    view.axes(drawing, last, "i", [[6.0, 4.0], [8.0, 2.0]]);
    view.turn(drawing, |share| {
        first.about_z(share * THETA).place([0.9, 0.0, 0.0])
    });
    view.turn(drawing, |share| {
        shifted.about_x(share * ALPHA).place([0.0, 0.0, 0.85])
    });
    drawing.text([182.0, 334.0], NAME, "theta");
    drawing.text([76.0, 270.0], NAME, "d");
    drawing.text([190.0, 198.0], NAME, "a");
    drawing.text([238.0, 128.0], NAME, "alpha");
    let words = "Joint i turns about (or slides along) z of frame i-1.";
    drawing.text([20.0, 400.0], NOTE, words);
}

fn modified(drawing: &mut Drawing) {
    let view = View([520.0, 250.0]);
    drawing.text(
        [460.0, 32.0],
        NAME.bold(),
        "modified: Rx(alpha) Tx(a) Rz(theta) Tz(d)",
    );
    let first = Frame::FIRST;
    let shifted = first.shifted([A, 0.0, 0.0]);
    let inclined = shifted.about_x(ALPHA);
    let raised = inclined.shifted([0.0, 0.0, D]);
    let last = raised.about_z(THETA);
    let places = [first, shifted, raised].map(|frame| view.at(frame.origin));
    drawing.stroke("link-a", 8.0, &places);
    drawing.dashes(
        "faint",
        1.5,
        &[places[1], view.at(shifted.place([0.0, 0.0, 1.4]))],
    );
    drawing.dashes(
        "faint",
        1.5,
        &[places[2], view.at(raised.place([1.4, 0.0, 0.0]))],
    );
    view.axes(drawing, first, "i-1", [[-8.0, 22.0], [8.0, 2.0]]);
    view.axes(drawing, last, "i", [[6.0, 4.0], [-14.0, -6.0]]);
    view.turn(drawing, |share| {
        shifted.about_x(share * ALPHA).place([0.0, 0.0, 0.6])
    });
    view.turn(drawing, |share| {
        raised.about_z(share * THETA).place([0.9, 0.0, 0.0])
    });
    drawing.text([706.0, 268.0], NAME, "alpha");
    drawing.text([610.0, 296.0], NAME, "a");
    drawing.text([662.0, 262.0], NAME, "d");
    drawing.text([732.0, 222.0], NAME, "theta");
    let words = "Joint i turns about (or slides along) z of frame i itself.";
    drawing.text([460.0, 400.0], NOTE, words);
}
