//! Charts: a line for each row, a mark for each tool, times on a logarithmic axis. The colours are those of the reader's
//! screen, light or dark.

use std::fmt::Write;

use measuring::table::escaped;

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

/// Colours that stay apart for colour-blind readers (Okabe and Ito, Color Universal Design, 2008), on white and on black.
const COLOURS: [[&str; 2]; 6] = [
    ["#d55e00", "#ff8c3a"],
    ["#0072b2", "#56b4e9"],
    ["#009e73", "#2fd3a5"],
    ["#cc79a7", "#e79fc6"],
    ["#7a6a00", "#f0e442"],
    ["#666666", "#bbbbbb"],
];

/// Around the origin: disc, square, diamond, two triangles, cross.
const MARKS: [&str; 6] = [
    "M-5 0a5 5 0 1 0 10 0a5 5 0 1 0 -10 0z",
    "M-4.5-4.5h9v9h-9z",
    "M0-6 6 0 0 6-6 0z",
    "M0-5.5 5.5 4.5h-11z",
    "M0 5.5 5.5-4.5h-11z",
    "M-5-3-3-5 0-2 3-5 5-3 2 0 5 3 3 5 0 2-3 5-5 3-2 0z",
];

impl Chart {
    /// The drawing: the same text for the same values.
    pub(crate) fn svg(&self) -> String {
        let height = TOP + ROW * self.rows.len() as f64 + BOTTOM;
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height}\" role=\"img\" \
             font-family=\"sans-serif\" font-size=\"13\">\n<title>{title}</title>\n{style}\
             <rect class=\"ground\" width=\"{WIDTH}\" height=\"{height}\"/>\n\
             <text x=\"12\" y=\"22\" font-weight=\"bold\">{title}</text>\n",
            title = escaped(self.title),
            style = style(),
        );
        self.legend(&mut svg);
        let range = self.range();
        let end = height - BOTTOM;
        for tick in ticks(range) {
            let x = place(tick, range);
            line(&mut svg, [x, TOP - 6.0], [x, end]);
            text(&mut svg, [x, end + 18.0], "middle", &tick.to_string());
        }
        for (row, name) in self.rows.iter().enumerate() {
            let y = TOP + ROW * (row as f64 + 0.5);
            text(&mut svg, [AXIS[0] - 12.0, y + 4.5], "end", name);
            line(&mut svg, [AXIS[0], y], [AXIS[1], y]);
            for series in &self.series {
                if let Some(value) = series.values[row] {
                    mark(&mut svg, series.mark, [place(value, range), y]);
                }
            }
        }
        svg + "</svg>\n"
    }

    fn legend(&self, svg: &mut String) {
        let mut x = 18.0;
        for series in &self.series {
            mark(svg, series.mark, [x, 42.0]);
            text(svg, [x + 12.0, 46.5], "start", series.name);
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

fn style() -> String {
    let colours = |theme: usize| -> String {
        let [text, ground, line] = [
            ["#222222", "#ffffff", "#dddddd"],
            ["#e6e6e6", "#1b1f24", "#3d444d"],
        ][theme];
        let marks = COLOURS.iter().enumerate();
        let marks = marks.map(|(number, colour)| format!(".m{number}{{fill:{}}}", colour[theme]));
        format!("text{{fill:{text}}}.ground{{fill:{ground}}}line{{stroke:{line}}}")
            + &marks.collect::<String>()
    };
    format!(
        "<style>{}@media (prefers-color-scheme:dark){{{}}}</style>\n",
        colours(0),
        colours(1)
    )
}

fn mark(svg: &mut String, number: usize, [x, y]: [f64; 2]) {
    let shape = MARKS[number];
    let at = format!("translate({x:.1} {y:.1})");
    writeln!(
        svg,
        "<path class=\"m{number}\" d=\"{shape}\" transform=\"{at}\"/>"
    )
    .unwrap();
}

fn line(svg: &mut String, from: [f64; 2], to: [f64; 2]) {
    let [[x1, y1], [x2, y2]] = [from, to];
    writeln!(
        svg,
        "<line x1=\"{x1:.1}\" y1=\"{y1:.1}\" x2=\"{x2:.1}\" y2=\"{y2:.1}\"/>"
    )
    .unwrap();
}

fn text(svg: &mut String, [x, y]: [f64; 2], anchor: &str, words: &str) {
    let words = escaped(words);
    writeln!(
        svg,
        "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\">{words}</text>"
    )
    .unwrap();
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
