//! The lines of the scoreboard.

/// Which side of its bound a value has to stay on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Side {
    /// `measured <= bound`
    AtMost,
    /// `measured >= bound`
    AtLeast,
}

/// A quantity of a hard case: what was measured, and what had to be reached.
#[derive(Clone, Debug, PartialEq)]
pub struct Score {
    /// The entry of `tests/data/hard_cases.json`.
    pub case: &'static str,
    /// The measured quantity.
    pub quantity: String,
    /// Its value.
    pub measured: f64,
    /// Which values pass.
    pub side: Side,
    /// The last value that passes.
    pub bound: f64,
    /// The value of a naive implementation, which fails: from the entry, or measured here.
    pub naive: Option<f64>,
}

impl Score {
    /// A quantity that is to be small: an error, a number of violations.
    pub fn at_most(
        case: &'static str,
        quantity: impl Into<String>,
        measured: f64,
        bound: f64,
    ) -> Self {
        Score {
            case,
            quantity: quantity.into(),
            measured,
            side: Side::AtMost,
            bound,
            naive: None,
        }
    }

    /// A quantity that is to be large.
    pub fn at_least(
        case: &'static str,
        quantity: impl Into<String>,
        measured: f64,
        bound: f64,
    ) -> Self {
        Score {
            side: Side::AtLeast,
            ..Score::at_most(case, quantity, measured, bound)
        }
    }

    /// Adds the value of a naive implementation.
    pub fn naive(self, value: f64) -> Self {
        Score {
            naive: Some(value),
            ..self
        }
    }

    fn passes(&self, value: f64) -> bool {
        match self.side {
            Side::AtMost => value <= self.bound,
            Side::AtLeast => value >= self.bound,
        }
    }

    /// Whether the measured value passes; NaN never does.
    pub fn is_passed(&self) -> bool {
        self.passes(self.measured)
    }

    /// Whether the bound tells the naive implementation from this one.
    pub fn is_sharp(&self) -> bool {
        self.naive.is_none_or(|naive| !self.passes(naive))
    }

    /// The columns of the scoreboard.
    pub fn cells(&self) -> [String; 6] {
        let side = match self.side {
            Side::AtMost => "<=",
            Side::AtLeast => ">=",
        };
        [
            self.case.to_owned(),
            self.quantity.clone(),
            number(self.measured),
            format!("{side} {}", number(self.bound)),
            self.naive.map_or_else(String::new, number),
            if self.is_passed() { "pass" } else { "FAIL" }.to_owned(),
        ]
    }
}

/// The headings of `Score::cells`.
const HEADINGS: [&str; 6] = ["case", "quantity", "measured", "bound", "naive", ""];

fn number(x: f64) -> String {
    if x == 0.0 || (x.fract() == 0.0 && x.abs() < 1e6) {
        format!("{x}")
    } else {
        format!("{x:.1e}")
    }
}

/// The scoreboard as text.
pub fn table(scores: &[Score]) -> String {
    let mut text = line(&HEADINGS.map(str::to_owned));
    for score in scores {
        text += &line(&score.cells());
    }
    text
}

fn line([case, quantity, measured, bound, naive, verdict]: &[String; 6]) -> String {
    format!("{case:<13} {measured:>8}  {bound:<11} {naive:>8}  {verdict:<5} {quantity}\n")
}
