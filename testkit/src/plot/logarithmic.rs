//! Plots with two logarithmic axes, as SVG.

use std::ops::Range;

use plotters::coord::Shift;
use plotters::prelude::*;

use robot_dynamics::plot::COLOURS;

use super::Outcome;

const WIDTH: u32 = 940;
const HEIGHT: u32 = 480;
const LEGEND: u32 = 230;

/// How a point is drawn.
#[derive(Clone, Debug)]
pub enum Mark {
    /// A disc.
    Dot,
    /// A run that did not reach its end.
    Cross,
    /// A letter that the legend or the text explains.
    Letter(&'static str),
}

/// Points of one colour.
#[derive(Clone, Debug)]
pub struct Series {
    /// Their name in the legend.
    pub name: String,
    /// Where they are, and what they look like.
    pub points: Vec<(f64, f64, Mark)>,
    /// Whether the points are joined by a line.
    pub joined: bool,
}

/// A plot.
pub struct Plot {
    /// Its heading.
    pub title: String,
    /// The quantity to the right, and its unit.
    pub x: &'static str,
    /// The quantity upwards, and its unit.
    pub y: &'static str,
    /// The points that are drawn; values that are not positive have no place.
    pub series: Vec<Series>,
    /// Values of x that are drawn as lines, with what they mean.
    pub limits: Vec<(f64, &'static str)>,
}

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

impl Plot {
    /// Writes `examples/output/<name>.svg` and says so on standard output.
    ///
    /// # Errors
    ///
    /// Where the file cannot be written.
    pub fn save(&self, name: &str) -> Outcome {
        super::save(&self.svg()?, name)
    }

    /// The drawing.
    ///
    /// # Errors
    ///
    /// Where it cannot be drawn.
    pub fn svg(&self) -> Outcome<String> {
        let mut svg = String::new();
        self.draw(SVGBackend::with_string(&mut svg, (WIDTH, HEIGHT)))?;
        Ok(svg)
    }

    fn draw(&self, backend: SVGBackend) -> Outcome {
        let root = backend.into_drawing_area();
        root.fill(&WHITE)?;
        let body = root
            .margin(6, 0, 0, 0)
            .titled(&self.title, ("sans-serif", 18))?;
        let (left, right) = body.split_horizontally(WIDTH - LEGEND);
        self.draw_points(&left)?;
        self.draw_legend(&right)?;
        root.present()?;
        Ok(())
    }

    fn draw_points(&self, area: &Area) -> Outcome {
        let points = || self.series.iter().flat_map(|series| &series.points);
        let limits = self.limits.iter().map(|limit| limit.0);
        let x = range(points().map(|point| point.0).chain(limits));
        let y = range(points().map(|point| point.1));
        let [x_ticks, y_ticks] = [&x, &y].map(decades);
        let mut chart = ChartBuilder::on(area)
            .margin(10)
            .x_label_area_size(40)
            .y_label_area_size(70)
            .build_cartesian_2d(
                x.log_scale().with_key_points(x_ticks),
                y.clone().log_scale().with_key_points(y_ticks),
            )?;
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(BLACK.mix(0.15))
            .label_style(("sans-serif", 13))
            .axis_desc_style(("sans-serif", 15))
            .x_desc(self.x)
            .y_desc(self.y)
            .x_label_formatter(&|x| tick(*x))
            .y_label_formatter(&|y| tick(*y))
            .draw()?;
        for (limit, _) in &self.limits {
            let line = [(*limit, y.start), (*limit, y.end)];
            chart.draw_series(LineSeries::new(line, BLACK.mix(0.6).stroke_width(1)))?;
        }
        for (series, colour) in self.series.iter().zip(COLOURS.iter().cycle()) {
            let line = series.points.iter().map(|point| (point.0, point.1));
            if series.joined {
                chart.draw_series(LineSeries::new(line, colour.mix(0.7).stroke_width(1)))?;
            }
            for (x, y, mark) in &series.points {
                let at = (*x, *y);
                match mark {
                    Mark::Dot => {
                        chart.draw_series([Circle::new(at, 3, colour.filled())])?;
                    }
                    Mark::Cross => {
                        chart.draw_series([Cross::new(at, 5, colour.stroke_width(2))])?;
                    }
                    Mark::Letter(letter) => {
                        let style = ("sans-serif", 14).into_font().color(colour);
                        chart.draw_series([Text::new(*letter, at, style)])?;
                    }
                }
            }
        }
        Ok(())
    }

    /// Beside the points and never on them.
    fn draw_legend(&self, area: &Area) -> Outcome {
        let mut y = 20;
        for (series, colour) in self.series.iter().zip(COLOURS.iter().cycle()) {
            area.draw(&PathElement::new([(4, y), (26, y)], colour.stroke_width(3)))?;
            area.draw(&Text::new(
                series.name.as_str(),
                (34, y - 7),
                ("sans-serif", 14),
            ))?;
            y += 21;
        }
        for (_, meaning) in &self.limits {
            area.draw(&PathElement::new(
                [(4, y), (26, y)],
                BLACK.mix(0.6).stroke_width(1),
            ))?;
            area.draw(&Text::new(*meaning, (34, y - 7), ("sans-serif", 14)))?;
            y += 21;
        }
        Ok(())
    }
}

/// The range of some positive values with a margin.
fn range(values: impl Iterator<Item = f64>) -> Range<f64> {
    let finite = values.filter(|value| value.is_finite() && *value > 0.0);
    let (low, high) = finite.fold((f64::INFINITY, 0.0_f64), |(low, high), value| {
        (low.min(value), high.max(value))
    });
    if low > high {
        return 0.1..1.0;
    }
    low / 1.6..high * 1.6
}

/// Powers of ten in a range, and twos and fives between them where they are few.
fn decades(range: &Range<f64>) -> Vec<f64> {
    let powers = range.start.log10().floor() as i32..=range.end.log10().ceil() as i32;
    let digits: &[u32] = match powers.clone().count() {
        0..=4 => &[1, 2, 5],
        _ => &[1],
    };
    let step = powers.clone().count() / 12 + 1;
    let ticks = powers.step_by(step).flat_map(|power| {
        let digits = digits.iter();
        digits.map(move |digit| format!("{digit}e{power}").parse().unwrap_or(f64::NAN))
    });
    ticks.filter(|tick| range.contains(tick)).collect()
}

fn tick(x: f64) -> String {
    if (1e-2..1e5).contains(&x) {
        format!("{x}")
    } else {
        format!("{x:e}")
    }
}
