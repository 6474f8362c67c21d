//! The curves as SVG, both axes logarithmic.

use std::{fs, ops::Range, path::Path};

use plotters::prelude::*;

use super::series::{Panel, Series, panels};
use super::{Chain, Outcome};

const SIZE: (u32, u32) = (900, 560);
const LEGEND: u32 = 240;

/// Colours that stay apart for colour-blind readers: Okabe and Ito, Color Universal Design (2008).
const COLOURS: [RGBColor; 5] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
];

/// Writes the plots to `examples/output/`.
pub(crate) fn plots(chains: &[Chain]) -> Outcome<()> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/output");
    fs::create_dir_all(&folder)?;
    for panel in panels(chains) {
        let path = folder.join(panel.file).with_extension("svg");
        draw(&panel, &path)?;
        println!("plot: examples/output/{}.svg", panel.file);
    }
    Ok(())
}

fn draw(panel: &Panel, path: &Path) -> Outcome<()> {
    let root = SVGBackend::new(path, SIZE).into_drawing_area();
    root.fill(&WHITE)?;
    let body = root
        .margin(6, 0, 0, 0)
        .titled(panel.title, ("sans-serif", 20))?;
    let (left, right) = body.split_horizontally(SIZE.0 - LEGEND);
    let series: Vec<_> = panel
        .series
        .iter()
        .filter(|s| !s.points.is_empty())
        .collect();
    let points = || series.iter().flat_map(|series| &series.points);
    let x = range(points().map(|point| point.0));
    let y = range(points().map(|point| point.1));
    let ticks = [&x, &y].map(decades);
    let mut chart = ChartBuilder::on(&left)
        .margin(10)
        .x_label_area_size(40)
        .y_label_area_size(80)
        .build_cartesian_2d(
            x.log_scale().with_key_points(ticks[0].clone()),
            y.log_scale().with_key_points(ticks[1].clone()),
        )?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(BLACK.mix(0.15))
        .label_style(("sans-serif", 13))
        .axis_desc_style(("sans-serif", 15))
        .x_desc(panel.x.0)
        .y_desc(panel.y)
        .x_label_formatter(&|x| format!("{x}"))
        .y_label_formatter(&|y| format!("{y}"))
        .draw()?;
    for (series, colour) in series.iter().zip(COLOURS) {
        let line = series.points.iter().copied();
        chart.draw_series(LineSeries::new(line.clone(), colour.stroke_width(2)))?;
        chart.draw_series(line.map(|point| Circle::new(point, 3, colour.filled())))?;
    }
    draw_legend(&right, &series, panel.x.1)?;
    root.present()?;
    Ok(())
}

/// Beside the curves and never on them.
fn draw_legend(
    area: &DrawingArea<SVGBackend, plotters::coord::Shift>,
    series: &[&Series],
    x: &str,
) -> Outcome<()> {
    for (k, (series, colour)) in series.iter().zip(COLOURS).enumerate() {
        let y = 22 + 24 * k as i32;
        area.draw(&PathElement::new([(4, y), (30, y)], colour.stroke_width(3)))?;
        area.draw(&Text::new(series.label(x), (38, y - 7), ("sans-serif", 14)))?;
    }
    Ok(())
}

/// The range of some positive values with a margin.
fn range(values: impl Iterator<Item = f64>) -> Range<f64> {
    let (low, high) = values.fold((f64::INFINITY, 0.0_f64), |(low, high), value| {
        (low.min(value), high.max(value))
    });
    low / 1.15..high * 1.15
}

/// 1, 2, 3 and 5 times the powers of ten in a range.
fn decades(range: &Range<f64>) -> Vec<f64> {
    let powers = range.start.log10().floor() as i32..=range.end.log10().ceil() as i32;
    let ticks = powers.flat_map(|power| {
        // Decimal text gives the number that a reader expects: 0.1, not ten to the power of -1.
        [1, 2, 3, 5].map(|digit| format!("{digit}e{power}").parse().unwrap_or(f64::NAN))
    });
    ticks.filter(|tick| range.contains(tick)).collect()
}
