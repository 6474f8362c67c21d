//! Charts: a line for each row, a mark for each tool, times on a logarithmic axis. The colours are those of the reader's
//! screen, light or dark.

use measuring::drawing::{Drawing, Letters};

/// Marks of one tool.
pub(crate) struct Series {
    pub(crate) name: &'static str,
    /// The place of its shape and colour.
    pub(crate) mark: usize,
    /// A value for each row; nothing where the tool has none.
    pub(crate) values: Vec<Option<f64>>,
}

pub(crate) struct Chart {
    /// The name of its file.
    pub(crate) file: &'static str,
    /// The heading: the quantity and its unit.
    pub(crate) title: &'static str,
    pub(crate) rows: Vec<String>,
    pub(crate) series: Vec<Series>,
}

const WIDTH: f64 = 760.0;
/// Where the axis begins and ends.
const AXIS: [f64; 2] = [270.0, 735.0];
/// Heading and legend.
const TOP: f64 = 66.0;
const ROW: f64 = 24.0;
const BOTTOM: f64 = 34.0;

impl Chart {
    /// The drawing: the same text for the same values.
    pub(crate) fn svg(&self) -> String {
        let height = TOP + ROW * self.rows.len() as f64 + BOTTOM;
        let mut drawing = Drawing::new(self.title, [WIDTH, height]);
        drawing.text([12.0, 22.0], Letters::PLAIN.bold(), self.title);
        self.legend(&mut drawing);
        let range = self.range();
        let end = height - BOTTOM;
        for tick in ticks(range) {
            let x = place(tick, range);
            drawing.line([x, TOP - 6.0], [x, end]);
            drawing.text([x, end + 18.0], Letters::PLAIN.centred(), &tick.to_string());
        }
        for (row, name) in self.rows.iter().enumerate() {
            let y = TOP + ROW * (row as f64 + 0.5);
            drawing.text([AXIS[0] - 12.0, y + 4.5], Letters::PLAIN.left(), name);
            drawing.line([AXIS[0], y], [AXIS[1], y]);
            for series in &self.series {
                if let Some(value) = series.values[row] {
                    drawing.mark(series.mark, [place(value, range), y]);
                }
            }
        }
        drawing.svg()
    }

    fn legend(&self, drawing: &mut Drawing) {
        let mut x = 18.0;
        for series in &self.series {
            drawing.mark(series.mark, [x, 42.0]);
            drawing.text([x + 12.0, 46.5], Letters::PLAIN, series.name);
            x += 34.0 + 7.2 * series.name.chars().count() as f64;
        }
    }

    /// The least and the largest value, with a margin.
    fn range(&self) -> [f64; 2] {
        let values = self
            .series
            .iter()
            .flat_map(|series| &series.values)
            .flatten();
        values.fold([f64::INFINITY, 0.0], |[low, high], value| {
            [low.min(value / 1.15), high.max(value * 1.15)]
        })
    }
}

/// Where a value stands on the axis.
fn place(value: f64, [low, high]: [f64; 2]) -> f64 {
    AXIS[0] + (AXIS[1] - AXIS[0]) * (value / low).ln() / (high / low).ln()
}

/// Round numbers: of the powers of ten one, two and five, and more of them where the range is small.
fn ticks([low, high]: [f64; 2]) -> Vec<f64> {
    let digits: &[&str] = match high / low {
        ..10.0 => &["1", "1.5", "2", "3", "4", "5", "7"],
        _ => &["1", "2", "5"],
    };
    let powers = -3..7;
    let ticks = powers.flat_map(|power| digits.iter().map(move |digit| format!("{digit}e{power}")));
    let ticks = ticks.map(|tick| crate::appendix::number(&tick));
    ticks.filter(|tick| (low..=high).contains(tick)).collect()
}
