//! Curves over time as SVG: panels above one another, one time axis, a legend beside each panel.

use std::ops::Range;
use std::path::Path;

use nalgebra::SVector;
use plotters::coord::{Shift, types::RangedCoordf64};
use plotters::prelude::*;

use super::Outcome;
use crate::replace_files;

/// Units of the drawing in one pixel. Plotters rounds to whole units: finer ones keep curves smooth.
const PIXEL: u32 = 8;
const WIDTH: u32 = 900 * PIXEL;
const PANEL_HEIGHT: u32 = 260 * PIXEL;
const TITLE_HEIGHT: u32 = 44 * PIXEL;
/// Beside the curves and never on them.
const LEGEND_WIDTH: u32 = 170 * PIXEL;

/// Colours that stay apart for colour-blind readers (Okabe and Ito, Color Universal Design, 2008), and some more.
pub const COLOURS: [RGBColor; 12] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(0, 0, 0),
    RGBColor(150, 110, 60),
    RGBColor(120, 120, 120),
    RGBColor(110, 60, 160),
    RGBColor(190, 190, 40),
    RGBColor(200, 30, 30),
];

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Chart<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<RangedCoordf64, RangedCoordf64>>;

/// One named curve. Numbers that are not finite have no place in it.
#[derive(Clone, Debug)]
pub struct Curve {
    name: String,
    points: Vec<(f64, f64)>,
}

impl Curve {
    /// The values `y` at the times `t`, s.
    pub fn new(name: impl Into<String>, t: &[f64], y: impl IntoIterator<Item = f64>) -> Self {
        let is_finite = |(t, y): &(f64, f64)| t.is_finite() && y.is_finite();
        Self {
            name: name.into(),
            points: t.iter().copied().zip(y).filter(is_finite).collect(),
        }
    }
}

/// One curve for each joint: the entries of the vectors `values` at the times `t`, s.
pub fn joints<const N: usize>(
    names: [&str; N],
    t: &[f64],
    values: impl IntoIterator<Item = SVector<f64, N>>,
) -> [Curve; N] {
    let values: Vec<_> = values.into_iter().collect();
    std::array::from_fn(|i| Curve::new(names[i], t, values.iter().map(|v| v[i])))
}

#[derive(Clone, Debug)]
struct Panel {
    y_label: String,
    curves: Vec<Curve>,
}

/// Panels above one another, over one time axis.
///
/// ```
/// use robot_dynamics::plot::{Curve, Figure};
///
/// let t: Vec<f64> = (0..101).map(|k| 0.1 * f64::from(k)).collect();
/// let wave = Curve::new("wave", &t, t.iter().map(|t| t.sin()));
/// let svg = Figure::new("A wave").panel("height, m", [wave]).svg()?;
/// assert!(svg.contains("A wave") && svg.contains("height, m"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
#[must_use]
pub struct Figure {
    title: String,
    panels: Vec<Panel>,
}

impl Figure {
    /// A figure without panels.
    pub fn new(title: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            panels: Vec::new(),
        }
    }

    /// Another title; none where it is empty.
    pub fn title(mut self, title: impl Into<String>) -> Self {
        self.title = title.into();
        self
    }

    /// Adds a panel below the others; `y_label` names the quantity and its unit.
    pub fn panel(
        mut self,
        y_label: impl Into<String>,
        curves: impl IntoIterator<Item = Curve>,
    ) -> Self {
        self.panels.push(Panel {
            y_label: y_label.into(),
            curves: curves.into_iter().collect(),
        });
        self
    }

    /// Writes the drawing into a file, whose folder is made where it is missing. An old file is replaced when the drawing
    /// is complete.
    ///
    /// # Errors
    ///
    /// Where the file cannot be written, or there is nothing to draw.
    pub fn save(&self, file: impl AsRef<Path>) -> Outcome {
        let svg = self.svg()?;
        if let Some(folder) = file.as_ref().parent() {
            std::fs::create_dir_all(folder)?;
        }
        replace_files(&[(file.as_ref().to_owned(), svg)]).map_err(|(_, error)| error.into())
    }

    /// The drawing: as high as its panels, 900 pixels wide.
    ///
    /// # Errors
    ///
    /// Where there is nothing to draw.
    pub fn svg(&self) -> Outcome<String> {
        let points = self.panels.iter().flat_map(|panel| &panel.curves);
        if points.map(|curve| curve.points.len()).sum::<usize>() == 0 {
            return Err("there is nothing to draw".into());
        }
        let height = self.title_height() + PANEL_HEIGHT * self.panels.len() as u32;
        let mut svg = String::new();
        self.draw(SVGBackend::with_string(&mut svg, (WIDTH, height)))?;
        // Drawn in fine units, shown at its size in pixels.
        let size =
            |pixel: u32| format!("width=\"{}\" height=\"{}\"", WIDTH / pixel, height / pixel);
        Ok(svg.replacen(&size(1), &size(PIXEL), 1))
    }

    fn title_height(&self) -> u32 {
        if self.title.is_empty() {
            6 * PIXEL
        } else {
            TITLE_HEIGHT
        }
    }

    fn draw(&self, backend: SVGBackend) -> Outcome {
        let root = backend.into_drawing_area();
        root.fill(&WHITE)?;
        let mut body = root.margin(6 * PIXEL, 0, 0, 0);
        if !self.title.is_empty() {
            body = body.titled(&self.title, font(20))?;
        }
        let areas = body.split_evenly((self.panels.len(), 1));
        for (panel, area) in self.panels.iter().zip(areas) {
            panel.draw(&area)?;
        }
        root.present()?;
        Ok(())
    }
}

impl Panel {
    fn draw(&self, area: &Area) -> Outcome {
        let (left, right) = area.split_horizontally(WIDTH - LEGEND_WIDTH);
        let mut chart = ChartBuilder::on(&left)
            .margin(10 * PIXEL)
            .x_label_area_size(38 * PIXEL)
            .y_label_area_size(78 * PIXEL)
            .build_cartesian_2d(self.time_range(), self.value_range())?;
        self.draw_axes(&mut chart)?;
        for (curve, colour) in self.curves.iter().zip(COLOURS.iter().cycle()) {
            let style = colour.stroke_width(2 * PIXEL);
            chart.draw_series(LineSeries::new(curve.points.iter().copied(), style))?;
        }
        self.draw_legend(&right)
    }

    fn draw_axes(&self, chart: &mut Chart) -> Outcome {
        let range = self.value_range();
        let largest = range.start.abs().max(range.end.abs());
        let value_label = move |y: &f64| tick_label(*y, largest);
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(BLACK.mix(0.15).stroke_width(PIXEL))
            .axis_style(BLACK.stroke_width(PIXEL))
            .set_all_tick_mark_size(5 * PIXEL)
            .label_style(font(13))
            .axis_desc_style(font(15))
            .x_desc("time, s")
            .y_desc(&self.y_label)
            .y_labels(7)
            .y_label_formatter(&value_label)
            .draw()?;
        Ok(())
    }

    fn draw_legend(&self, area: &Area) -> Outcome {
        let at = |x: u32, y: u32| ((x * PIXEL) as i32, (y * PIXEL) as i32);
        let mut y = 22;
        for (curve, colour) in self.curves.iter().zip(COLOURS.iter().cycle()) {
            let line = [at(4, y), at(30, y)];
            area.draw(&PathElement::new(line, colour.stroke_width(3 * PIXEL)))?;
            area.draw(&Text::new(curve.name.as_str(), at(38, y - 7), font(14)))?;
            y += 22;
        }
        Ok(())
    }

    fn time_range(&self) -> Range<f64> {
        let (low, high) = extent(self.curves.iter().flat_map(|c| &c.points).map(|p| p.0));
        low..if low < high { high } else { low + 1.0 }
    }

    /// The values' range with a margin, and a range of its own for a constant.
    fn value_range(&self) -> Range<f64> {
        let (low, high) = extent(self.curves.iter().flat_map(|c| &c.points).map(|p| p.1));
        let margin = match 0.06 * (high - low) {
            0.0 if low == 0.0 => 1.0,
            0.0 => 0.1 * low.abs(),
            margin => margin,
        };
        low - margin..high + margin
    }
}

/// The readers' own font, `size` pixels high.
fn font(size: u32) -> (&'static str, u32) {
    ("sans-serif", size * PIXEL)
}

/// The least and the greatest of some values; of none, 0 and 1.
fn extent(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let widened = |(low, high): (f64, f64), v| (low.min(v), high.max(v));
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), widened);
    if low <= high { (low, high) } else { (0.0, 1.0) }
}

/// A label with the digits that ticks need on an axis whose largest value is `largest`.
fn tick_label(y: f64, largest: f64) -> String {
    match largest {
        // The tick at zero carries a rounding error.
        l if y.abs() < 1e-9 * l => "0".to_owned(),
        l if l < 1e-2 => format!("{y:.1e}"),
        l if l < 2.0 => format!("{y:.2}"),
        l if l < 20.0 => format!("{y:.1}"),
        _ => format!("{y:.0}"),
    }
}
