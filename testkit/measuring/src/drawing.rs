//! Pictures as SVG. Their colours are those of the reader's screen, light or dark.

use std::fmt::Write;

use crate::table::escaped;

/// A rule of colour: a kind of element or a class, the property, and the colours on light and on dark screens.
pub type Rule = (&'static str, &'static str, [&'static str; 2]);

/// All colours. A drawing has those of its elements.
///
/// `m0` to `m5` stay apart for colour-blind readers (Okabe and Ito, Color Universal Design, 2008).
pub const RULES: [Rule; 35] = [
    ("text", "fill", ["#222222", "#e6e6e6"]),
    (".ground", "fill", ["#ffffff", "#1b1f24"]),
    ("line", "stroke", ["#dddddd", "#3d444d"]),
    (".m0", "fill", ["#d55e00", "#ff8c3a"]),
    (".m1", "fill", ["#0072b2", "#56b4e9"]),
    (".m2", "fill", ["#009e73", "#2fd3a5"]),
    (".m3", "fill", ["#cc79a7", "#e79fc6"]),
    (".m4", "fill", ["#7a6a00", "#f0e442"]),
    (".m5", "fill", ["#666666", "#bbbbbb"]),
    (".m0-line", "stroke", ["#d55e00", "#ff8c3a"]),
    (".m1-line", "stroke", ["#0072b2", "#56b4e9"]),
    (".m2-line", "stroke", ["#009e73", "#2fd3a5"]),
    (".m3-line", "stroke", ["#cc79a7", "#e79fc6"]),
    (".m4-line", "stroke", ["#7a6a00", "#f0e442"]),
    (".m5-line", "stroke", ["#666666", "#bbbbbb"]),
    (".band", "fill", ["#eef2f6", "#262d35"]),
    (".box", "fill", ["#ffffff", "#1b1f24"]),
    (".box", "stroke", ["#6b7480", "#8b949e"]),
    (".joint", "fill", ["#ffffff", "#1b1f24"]),
    (".joint", "stroke", ["#222222", "#e6e6e6"]),
    (".link-a-line", "stroke", ["#b8c7d9", "#4a5f78"]),
    (".link-b-line", "stroke", ["#d9cdb8", "#6e6048"]),
    (".bar-a", "fill", ["#768fad", "#6285aa"]),
    (".bar-b", "fill", ["#5583b3", "#7fb0e0"]),
    (".bar-c", "fill", ["#1f5fa8", "#b5d8ff"]),
    (".ink", "fill", ["#222222", "#e6e6e6"]),
    (".ink-line", "stroke", ["#222222", "#e6e6e6"]),
    (".faint", "fill", ["#5a6068", "#a8b0b8"]),
    (".faint-line", "stroke", ["#7a828c", "#8b949e"]),
    (".red", "fill", ["#b5301f", "#ff8f80"]),
    (".red-line", "stroke", ["#b5301f", "#ff8f80"]),
    (".green", "fill", ["#1a7340", "#5fd38d"]),
    (".green-line", "stroke", ["#1a7340", "#5fd38d"]),
    (".blue", "fill", ["#1f5fa8", "#7fb8ff"]),
    (".blue-line", "stroke", ["#1f5fa8", "#7fb8ff"]),
];

/// Marks around the origin: disc, square, diamond, two triangles, cross. Their colours are `m0` to `m5`.
pub const MARKS: [&str; 6] = [
    "M-5 0a5 5 0 1 0 10 0a5 5 0 1 0 -10 0z",
    "M-4.5-4.5h9v9h-9z",
    "M0-6 6 0 0 6-6 0z",
    "M0-5.5 5.5 4.5h-11z",
    "M0 5.5 5.5-4.5h-11z",
    "M-5-3-3-5 0-2 3-5 5-3 2 0 5 3 3 5 0 2-3 5-5 3-2 0z",
];

/// A place in a drawing: to the right and downwards.
pub type At = [f64; 2];

/// The size of letters that have no other.
pub const SIZE: f64 = 13.0;

/// How words are written.
#[derive(Clone, Copy, Debug)]
pub struct Letters {
    /// The part of the words that is at their place: `start`, `middle` or `end`.
    pub anchor: &'static str,
    /// The class of their colour; the colour of texts if it is empty.
    pub ink: &'static str,
    /// Their height.
    pub size: f64,
    /// Whether they are bold.
    pub is_bold: bool,
    /// Whether all letters have one width. It is 0.6 of their height, in any font.
    pub is_mono: bool,
}

impl Letters {
    /// Upright letters, from their place to the right.
    pub const PLAIN: Letters = Letters {
        anchor: "start",
        ink: "",
        size: SIZE,
        is_bold: false,
        is_mono: false,
    };

    /// The same in bold.
    #[must_use]
    pub const fn bold(self) -> Self {
        Letters {
            is_bold: true,
            ..self
        }
    }

    /// The same of this height.
    #[must_use]
    pub const fn size(self, size: f64) -> Self {
        Letters { size, ..self }
    }

    /// The same in this colour.
    #[must_use]
    pub const fn ink(self, ink: &'static str) -> Self {
        Letters { ink, ..self }
    }

    /// The same around their place.
    #[must_use]
    pub const fn centred(self) -> Self {
        Letters {
            anchor: "middle",
            ..self
        }
    }

    /// The same to the left of their place.
    #[must_use]
    pub const fn left(self) -> Self {
        Letters {
            anchor: "end",
            ..self
        }
    }

    /// The same with letters of one width.
    #[must_use]
    pub const fn mono(self) -> Self {
        Letters {
            is_mono: true,
            ..self
        }
    }

    /// The width of words, as wide as the widest of the usual fonts has them.
    fn width(&self, words: &str) -> f64 {
        let of = |letter: char| match letter {
            _ if self.is_mono => 0.6,
            '{' | '}' | '_' => 0.0,
            'i' | 'j' | 'l' | '.' | ',' | ':' | '\'' | '|' | ' ' | '(' | ')' | '[' | ']' => 0.36,
            'm' | 'w' | 'M' | 'W' | '%' => 0.95,
            'A'..='Z' | '+' | '=' | '>' => 0.75,
            _ => 0.6,
        };
        words.chars().map(of).sum::<f64>() * self.size
    }
}

/// Words, and the rectangle that they are within: left, top, right, bottom.
#[derive(Clone, Debug)]
pub struct Written {
    /// The words.
    pub words: String,
    /// Their rectangle.
    pub within: [f64; 4],
}

/// A drawing: the same text for the same calls.
#[derive(Clone, Debug)]
pub struct Drawing {
    title: String,
    size: [f64; 2],
    body: String,
    written: Vec<Written>,
}

impl Drawing {
    /// An empty one, with what a reader of screens says.
    pub fn new(title: &str, size: [f64; 2]) -> Self {
        let mut drawing = Drawing {
            title: title.to_owned(),
            size,
            body: String::new(),
            written: Vec::new(),
        };
        drawing.rectangle("ground", [0.0, 0.0], size, 0.0);
        drawing
    }

    /// Width and height.
    pub fn size(&self) -> [f64; 2] {
        self.size
    }

    /// All words in it.
    pub fn written(&self) -> &[Written] {
        &self.written
    }

    /// A rectangle of this class, with round corners.
    pub fn rectangle(&mut self, class: &str, [x, y]: At, [width, height]: [f64; 2], radius: f64) {
        let round = match radius {
            0.0 => String::new(),
            radius => format!(" rx=\"{radius}\""),
        };
        let place = format!("x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\"{round}");
        self.element(&format!("<rect class=\"{class}\" {place}/>"));
    }

    /// A disc of this class.
    pub fn disc(&mut self, class: &str, [x, y]: At, radius: f64) {
        let place = format!("cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius}\"");
        self.element(&format!("<circle class=\"{class}\" {place}/>"));
    }

    /// A thin line of a grid.
    pub fn line(&mut self, [x1, y1]: At, [x2, y2]: At) {
        self.element(&format!(
            "<line x1=\"{x1:.1}\" y1=\"{y1:.1}\" x2=\"{x2:.1}\" y2=\"{y2:.1}\"/>"
        ));
    }

    /// A line through some places, in the colour of a class `..-line`.
    pub fn stroke(&mut self, class: &str, width: f64, places: &[At]) {
        self.path(class, width, "", places);
    }

    /// The same with gaps.
    pub fn dashes(&mut self, class: &str, width: f64, places: &[At]) {
        self.path(class, width, " stroke-dasharray=\"5 4\"", places);
    }

    fn path(&mut self, class: &str, width: f64, more: &str, places: &[At]) {
        let places = places.iter().map(|[x, y]| format!("{x:.1} {y:.1}"));
        let places = places.collect::<Vec<_>>().join(" ");
        self.element(&format!(
            "<path class=\"{class}-line\" d=\"M{places}\" fill=\"none\" stroke-width=\"{width}\"{more}/>"
        ));
    }

    /// A line that ends in an arrow's head.
    pub fn arrow(&mut self, class: &str, width: f64, places: &[At]) {
        self.stroke(class, width, &shortened(places));
        self.head(class, places);
    }

    /// A line with gaps that ends in an arrow's head.
    pub fn dashed_arrow(&mut self, class: &str, width: f64, places: &[At]) {
        self.dashes(class, width, &shortened(places));
        self.head(class, places);
    }

    /// The head, in the direction of the last eight units.
    fn head(&mut self, class: &str, places: &[At]) {
        let [x, y] = places[places.len() - 1];
        let [bx, by] = shortened(places)[shortened(places).len() - 1];
        let [dx, dy] = [(x - bx) / HEAD, (y - by) / HEAD];
        let side = |sign: f64| {
            [
                x - 9.0 * dx - sign * 4.5 * dy,
                y - 9.0 * dy + sign * 4.5 * dx,
            ]
        };
        let [[x1, y1], [x2, y2]] = [side(1.0), side(-1.0)];
        self.element(&format!(
            "<path class=\"{class}\" d=\"M{x:.1} {y:.1} {x1:.1} {y1:.1} {x2:.1} {y2:.1}z\"/>"
        ));
    }

    /// A mark of [`MARKS`].
    pub fn mark(&mut self, number: usize, [x, y]: At) {
        let shape = MARKS[number];
        let at = format!("translate({x:.1} {y:.1})");
        self.element(&format!(
            "<path class=\"m{number}\" d=\"{shape}\" transform=\"{at}\"/>"
        ));
    }

    /// Words on a line. `_{..}` encloses a subscript.
    pub fn text(&mut self, [x, y]: At, letters: Letters, words: &str) {
        let width = letters.width(words);
        let left = match letters.anchor {
            "start" => x,
            "middle" => x - 0.5 * width,
            _ => x - width,
        };
        let (top, bottom) = (y - 0.75 * letters.size, y + 0.22 * letters.size);
        self.written.push(Written {
            words: words.to_owned(),
            within: [left, top, left + width, bottom],
        });
        let mut more = format!(" text-anchor=\"{}\"", letters.anchor);
        for (is_there, attribute) in [
            (
                !letters.ink.is_empty(),
                format!(" class=\"{}\"", letters.ink),
            ),
            (
                letters.size != SIZE,
                format!(" font-size=\"{}\"", letters.size),
            ),
            (letters.is_bold, " font-weight=\"bold\"".to_owned()),
            (letters.is_mono, fixed_width(width)),
        ] {
            if is_there {
                more += &attribute;
            }
        }
        let words = with_subscripts(&escaped(words));
        self.element(&format!(
            "<text x=\"{x:.1}\" y=\"{y:.1}\"{more}>{words}</text>"
        ));
    }

    fn element(&mut self, element: &str) {
        self.body.push_str(element);
        self.body.push('\n');
    }

    /// The text of the file.
    pub fn svg(&self) -> String {
        let [width, height] = self.size;
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" role=\"img\" \
             font-family=\"sans-serif\" font-size=\"{SIZE}\">\n<title>{title}</title>\n{style}{body}</svg>\n",
            title = escaped(&self.title),
            style = self.style(),
            body = self.body,
        )
    }

    /// The colours of what is drawn.
    fn style(&self) -> String {
        let is_drawn = |selector: &str| match selector.strip_prefix('.') {
            Some(class) => self.body.contains(&format!("class=\"{class}\"")),
            None => self.body.contains(&format!("<{selector} ")),
        };
        let colours = |theme: usize| {
            let mut rules = String::new();
            for (selector, property, colours) in RULES {
                if is_drawn(selector) {
                    write!(rules, "{selector}{{{property}:{}}}", colours[theme])
                        .expect("a string takes all that is written");
                }
            }
            rules
        };
        format!(
            "<style>{}@media (prefers-color-scheme:dark){{{}}}</style>\n",
            colours(0),
            colours(1)
        )
    }
}

/// The length of an arrow's head that its line leaves out.
const HEAD: f64 = 8.0;

/// A line whose last piece is shorter by an arrow's head.
fn shortened(places: &[At]) -> Vec<At> {
    let mut kept = places.to_vec();
    let [x, y] = places[places.len() - 1];
    let distance = |place: &At| (x - place[0]).hypot(y - place[1]);
    while kept.len() > 1 && kept.last().is_some_and(|place| distance(place) < HEAD) {
        kept.pop();
    }
    let from = kept[kept.len() - 1];
    let share = HEAD / distance(&from).max(HEAD);
    kept.push([x - share * (x - from[0]), y - share * (y - from[1])]);
    kept
}

/// Letters of one width fill the same place in any font.
fn fixed_width(width: f64) -> String {
    format!(
        " font-family=\"monospace\" textLength=\"{width:.1}\" lengthAdjust=\"spacingAndGlyphs\""
    )
}

/// `_{i-1}` becomes a subscript.
fn with_subscripts(words: &str) -> String {
    let mut parts = words.split("_{");
    let mut text = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (below, behind) = part.split_once('}').unwrap_or((part, ""));
        text += &format!("<tspan dy=\"4\" font-size=\"10\">{below}</tspan>");
        if !behind.is_empty() {
            text += &format!("<tspan dy=\"-4\">{behind}</tspan>");
        }
    }
    text
}
