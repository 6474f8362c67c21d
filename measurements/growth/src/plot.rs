//! The curves as SVG, both axes logarithmic.

use testkit::plot::{self, Mark, Plot};

use crate::chain::{Chain, Outcome};
use crate::series::{Panel, Series, panels};

/// Writes the plots to `examples/output/`.
pub(crate) fn plots(chains: &[Chain]) -> Outcome<()> {
    for panel in panels(chains) {
        plot(&panel).save(panel.file)?;
    }
    Ok(())
}

fn plot(panel: &Panel) -> Plot {
    let series = panel.series.iter().filter(|s| !s.points.is_empty());
    Plot {
        title: panel.title.to_owned(),
        x: panel.x.0,
        y: panel.y,
        series: series.map(|series| curve(series, panel.x.1)).collect(),
        limits: Vec::new(),
    }
}

fn curve(series: &Series, x: &str) -> plot::Series {
    let points = series.points.iter().map(|&(x, y)| (x, y, Mark::Dot));
    plot::Series {
        name: series.label(x),
        points: points.collect(),
        joined: true,
    }
}
