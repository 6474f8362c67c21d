//! The measurements as curves.

use crate::chain::{Chain, LISTED};
use crate::fit;

/// A quantity over another one, for all chains.
pub(crate) struct Series {
    pub(crate) name: &'static str,
    pub(crate) points: Vec<(f64, f64)>,
}

impl Series {
    /// Only positive values have logarithms: a chain of one joint has no Coriolis forces.
    fn new(
        name: &'static str,
        chains: &[Chain],
        x: impl Fn(&Chain) -> f64,
        y: impl Fn(&Chain) -> Option<f64>,
    ) -> Self {
        let points = chains
            .iter()
            .filter_map(|chain| Some((x(chain), y(chain)?)));
        Series {
            name,
            points: points.filter(|point| point.1 > 0.0).collect(),
        }
    }

    /// The name with the power that was fitted, `y` over `x`.
    pub(crate) fn label(&self, x: &str) -> String {
        match fit::exponent(&self.points) {
            Some(exponent) => format!("{}  ~ {x}^{exponent:.2}", self.name),
            None => self.name.to_owned(),
        }
    }
}

/// One plot.
pub(crate) struct Panel {
    pub(crate) file: &'static str,
    pub(crate) title: &'static str,
    /// The quantity x, and its letter.
    pub(crate) x: (&'static str, &'static str),
    pub(crate) y: &'static str,
    pub(crate) series: Vec<Series>,
}

const JOINTS: (&str, &str) = ("joints n", "n");

/// All plots.
pub(crate) fn panels(chains: &[Chain]) -> [Panel; 4] {
    let joints = |chain: &Chain| chain.joints as f64;
    let each = |value: fn(&Chain, usize) -> f64| {
        let series = LISTED.iter().enumerate();
        series
            .map(|(k, (_, name))| Series::new(name, chains, joints, |chain| Some(value(chain, k))))
            .collect()
    };
    let length = |chain: &Chain| chain.length;
    [
        Panel {
            file: "growth_expansion",
            title: "Expansion of the default set of functions",
            x: JOINTS,
            y: "time on a processor, s",
            series: vec![
                Series::new("engine optimised", chains, joints, |c| Some(c.expansion)),
                Series::new("engine unoptimised", chains, joints, |c| c.unoptimised),
            ],
        },
        Panel {
            file: "growth_length",
            title: "Length of programs",
            x: JOINTS,
            y: "operations",
            series: each(|chain, k| chain.operations[k]),
        },
        Panel {
            file: "growth_rustc",
            title: "rustc on the default set of functions",
            x: ("operations L", "L"),
            y: "time on a processor, s",
            series: vec![
                Series::new("release", chains, length, |c| Some(c.release)),
                Series::new("dev", chains, length, |c| Some(c.dev)),
            ],
        },
        Panel {
            file: "growth_calls",
            title: "Time of a call",
            x: JOINTS,
            y: "time, ns",
            series: each(|chain, k| chain.calls[k]),
        },
    ]
}
