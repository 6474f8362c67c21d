//! The table of goals, met or missed, and the times behind it, from the lines of many runs.

use measured_arms::*;
use measuring::records::Records;
use measuring::table::Table;
use testkit::five::NAMES;

macro_rules! names {
    ($($file:ident: $arm:ident, $n:literal;)*) => { [$(stringify!($file)),*] };
}

const ARMS: [&str; 6] = for_each_arm!(names);

const GENERATED: &str = "generated";
const TRIAL: &str = "trial";
const COMPILERS: [&str; 2] = ["C,gcc", "C,clang"];

/// The lines of many runs; NaN for what was not measured.
struct Runs(Records);

impl Runs {
    /// The least of all runs, each of which is a median itself. Some runs of one program take twice as long as others
    /// from their first call to the last: the trial's gravity vector of the PUMA 560 either 6.3 or 13.6 ns.
    fn time(&self, arm: &str, function: &str, candidate: &str) -> f64 {
        let least = self.0.least(["time", arm, function, candidate]);
        least.unwrap_or(f64::NAN)
    }

    fn ratio(&self, arm: &str, function: &str) -> f64 {
        let median = self.0.median(["ratio", arm, function, GENERATED]);
        median.unwrap_or(f64::NAN)
    }

    /// Largest error and root of the mean square.
    fn errors(&self, arm: &str, function: &str, candidate: &str) -> [f64; 2] {
        let errors = self.0.errors(arm, function, candidate);
        errors.unwrap_or([f64::NAN; 2])
    }

    fn errors_in_words(&self, arm: &str, function: &str, candidate: &str) -> String {
        let [largest, rms] = self.errors(arm, function, candidate);
        format!("{largest:.0e}, {rms:.0e}")
    }

    /// The share of the trial's time.
    fn share(&self, arm: &str, function: &str) -> f64 {
        self.time(arm, function, GENERATED) / self.time(arm, function, TRIAL)
    }
}

/// A number for each function of each arm.
struct Each(Vec<(String, f64)>);

impl Each {
    fn of(arms: &[&str], number: impl Fn(&str, &str) -> f64) -> Self {
        let of_arm = |arm: &&str| {
            let arm = *arm;
            let number = &number;
            NAMES.map(|function| (format!("`{function}` of {arm}"), number(arm, function)))
        };
        Each(arms.iter().flat_map(of_arm).collect())
    }

    fn geometric_mean(&self) -> f64 {
        let sum: f64 = self.0.iter().map(|(_, x)| x.ln()).sum();
        (sum / self.0.len() as f64).exp()
    }

    /// The largest; NaN is.
    fn largest(&self) -> (String, f64) {
        let larger = |a: &(String, f64), b: &(String, f64)| a.1.total_cmp(&b.1);
        self.0.iter().cloned().max_by(larger).expect("functions")
    }
}

#[derive(Clone, Copy)]
enum Bar {
    AtMost(f64),
    AtLeast(f64),
}

/// The table of goals.
struct Goals(Table);

impl Goals {
    /// One line of it.
    fn add(&mut self, quantity: &str, measured: f64, bar: Bar) {
        let (is_met, words) = match bar {
            Bar::AtMost(bar) => (measured <= bar, format!("at most {}", digits(bar))),
            Bar::AtLeast(bar) => (measured >= bar, format!("at least {}", digits(bar))),
        };
        let verdict = if is_met { "met" } else { "**missed**" };
        self.0
            .row([quantity, &digits(measured), &words, verdict].map(str::to_owned));
    }

    /// The mean and the largest share of the trial's time.
    fn shares(&mut self, calls: &str, each: &Each, bar: f64) {
        let mean = format!("{calls}, time / the trial's, geometric mean");
        self.add(&mean, each.geometric_mean(), Bar::AtMost(bar));
        self.slowest(calls, each, 1.0);
    }

    fn slowest(&mut self, calls: &str, each: &Each, bar: f64) {
        let (slowest, largest) = each.largest();
        let name = format!("{calls}, the slowest: {slowest}");
        self.add(&name, largest, Bar::AtMost(bar));
    }
}

fn digits(x: f64) -> String {
    match x {
        ..1e-3 => format!("{x:.1e}"),
        ..10.0 => format!("{x:.2}"),
        _ => format!("{x:.0}"),
    }
}

/// Prints all tables, of a processor with that many lanes of doubles.
pub(crate) fn print(lanes: &str, file: &str) {
    let runs = Runs(Records::read(file));
    let is_widest = lanes == "8";
    let mut goals = Goals(Table::new("", &["goal", "measured", "bar", ""]));
    five_functions(&mut goals, &runs, is_widest);
    single_precision(&mut goals, &runs);
    derivatives(&mut goals, &runs, is_widest);
    for name in runs.0.names("ratio", 2) {
        if let Some(batch) = name.strip_prefix("par_") {
            let batch = batch.replace("_of_", "`, states: ");
            let name_of_goal = format!("two cores / one, `par_{batch}");
            goals.add(&name_of_goal, runs.ratio("panda", name), Bar::AtLeast(1.8));
        }
    }
    print!("{}", goals.0.markdown_rows());
    print!("{HEADING}{}", details(&runs).markdown_rows());
    if !runs.time(ARMS[0], NAMES[0], COMPILERS[0]).is_nan() {
        print!("{HEADING_OF_C}{}", in_c(&runs).markdown_rows());
    }
}

/// The five functions beside the trial.
fn five_functions(goals: &mut Goals, runs: &Runs, is_widest: bool) {
    let batch = |arm: &str, function: &str| runs.share(arm, &format!("{function}_batch"));
    let bar = if is_widest { 0.85 } else { 0.7 };
    let single = Each::of(&ARMS, |arm, function| runs.share(arm, function));
    goals.shares("one state", &single, 0.8);
    goals.shares("batches", &Each::of(&ARMS, batch), bar);
    let puma = Each::of(&["puma560"], batch);
    goals.shares("batches of the PUMA 560", &puma, bar);
}

/// Times beside those in double precision, and errors.
fn single_precision(goals: &mut Goals, runs: &Runs) {
    for (calls, suffix, bar) in [("batches", "_batch_f32", 0.55), ("one state", "_f32", 1.0)] {
        let ratio = |arm: &str, function: &str| runs.ratio(arm, &format!("{function}{suffix}"));
        let each = Each::of(&ARMS, ratio);
        let ratios = format!("`f32` / `f64`, {calls}");
        let mean = format!("{ratios}, geometric mean");
        goals.add(&mean, each.geometric_mean(), Bar::AtMost(bar));
        goals.slowest(&ratios, &each, bar);
        let error = |arm: &str, function: &str| {
            runs.errors(arm, &format!("{function}{suffix}"), GENERATED)[0]
        };
        let (worst, error) = Each::of(&ARMS, error).largest();
        let name = format!("`f32`, {calls}, largest error: {worst}");
        goals.add(&name, error, Bar::AtMost(4e-7));
    }
}

/// Derivatives of the Panda's dynamics.
fn derivatives(goals: &mut Goals, runs: &Runs, is_widest: bool) {
    let lanes = if is_widest { 2.0 } else { 1.0 };
    for (function, unit, bar) in [
        ("inverse_dynamics_derivatives_batch", "state", 200.0 / lanes),
        ("forward_dynamics_derivatives_batch", "state", 350.0 / lanes),
        ("inverse_dynamics_second_derivatives", "call", 1500.0),
    ] {
        let errors = runs.errors_in_words("panda", function, GENERATED);
        let name = format!("`{function}` of the Panda, ns a {unit} (errors {errors})");
        let time = runs.time("panda", function, GENERATED);
        goals.add(&name, time, Bar::AtMost(bar));
    }
}

const HEADING: &str = "
Each function: ns a state here / the trial's, and its share; largest error and root of the mean square here
(over the largest value at 64 states) and of the trial (over the natural scale, angles of 1e6 rad among them);
then `f32`, as a share of the time of `f64`.

";

fn details(runs: &Runs) -> Table {
    let heads = [
        "arm",
        "function",
        "one state",
        "share",
        "errors",
        "trial's",
        "batch",
        "share",
        "errors",
        "f32",
        "f32 batch",
        "errors of f32 batch",
    ];
    let mut table = Table::new("", &heads);
    for (arm, function) in all() {
        let batch = format!("{function}_batch");
        let times = |function: &str| {
            let [ours, trial] = [GENERATED, TRIAL].map(|by| runs.time(arm, function, by));
            [
                format!("{ours:.1} / {trial:.1}"),
                format!("{:.2}", ours / trial),
            ]
        };
        let errors = |function: &str, by: &str| runs.errors_in_words(arm, function, by);
        let ratio =
            |suffix: &str| format!("{:.2}", runs.ratio(arm, &format!("{function}{suffix}")));
        let [[single, share], [many, share_of_batch]] = [times(function), times(&batch)];
        table.row([
            arm.to_owned(),
            function.to_owned(),
            single,
            share,
            errors(function, GENERATED),
            errors(function, TRIAL),
            many,
            share_of_batch,
            errors(&batch, GENERATED),
            ratio("_f32"),
            ratio("_batch_f32"),
            errors(&format!("{batch}_f32"), GENERATED),
        ]);
    }
    table
}

const HEADING_OF_C: &str = "
The C code that `robot-dynamics generate` writes: ns of one call, times those of the generated Rust, and largest error
and root of the mean square over the natural scale. The programs are the same; the sines are the C library's, one
angle after the other, where those of Rust are evaluated together in vectors.

";

fn in_c(runs: &Runs) -> Table {
    let heads = [
        "arm", "function", "Rust", "C, gcc", "/ Rust", "errors", "C, clang", "/ Rust", "errors",
    ];
    let mut table = Table::new("", &heads);
    for (arm, function) in all() {
        let rust = runs.time(arm, function, GENERATED);
        let compiled = COMPILERS.iter().flat_map(|compiler| {
            let time = runs.time(arm, function, compiler);
            let errors = runs.errors_in_words(arm, function, compiler);
            [format!("{time:.1}"), format!("{:.2}", time / rust), errors]
        });
        let names = [arm.to_owned(), function.to_owned(), format!("{rust:.1}")];
        table.row(names.into_iter().chain(compiled));
    }
    table
}

/// Every function of every arm.
fn all() -> impl Iterator<Item = (&'static str, &'static str)> {
    ARMS.into_iter()
        .flat_map(|arm| NAMES.map(|function| (arm, function)))
}
