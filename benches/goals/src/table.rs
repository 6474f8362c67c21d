//! The table of goals, met or missed, and the times behind it, from the lines of many runs.

use std::collections::BTreeMap;
use std::fs;

use crate::five::NAMES;
use measured_arms::*;

macro_rules! names {
    ($($file:ident: $arm:ident, $n:literal;)*) => { [$(stringify!($file)),*] };
}

const ARMS: [&str; 6] = for_each_arm!(names);

const GENERATED: &str = "generated";
const TRIAL: &str = "trial";
const COMPILERS: [&str; 2] = ["C,gcc", "C,clang"];

/// Numbers by kind, arm, function and candidate, those of all runs in rising order.
struct Records(BTreeMap<String, Vec<[f64; 2]>>);

impl Records {
    fn read(file: &str) -> Self {
        let text = fs::read_to_string(file).unwrap_or_else(|error| panic!("{file}: {error}"));
        let mut records = BTreeMap::<String, Vec<[f64; 2]>>::new();
        for line in text.lines() {
            let words: Vec<&str> = line.split(' ').collect();
            let number = |k: usize| words.get(k).and_then(|word| word.parse().ok());
            let numbers = [number(4).expect(line), number(5).unwrap_or(f64::NAN)];
            records
                .entry(words[..4].join(" "))
                .or_default()
                .push(numbers);
        }
        records
            .values_mut()
            .for_each(|numbers| numbers.sort_by(|a, b| a[0].total_cmp(&b[0])));
        Records(records)
    }

    /// The median; NaN where nothing was measured.
    fn of(&self, kind: &str, arm: &str, function: &str, candidate: &str) -> [f64; 2] {
        let numbers = self.0.get(&[kind, arm, function, candidate].join(" "));
        numbers.map_or([f64::NAN; 2], |numbers| numbers[numbers.len() / 2])
    }

    /// The least of all runs, each of which is a median itself. Some runs of one program take twice as long as others
    /// from their first call to the last: the trial's gravity vector of the PUMA 560 either 6.3 or 13.6 ns.
    fn time(&self, arm: &str, function: &str, candidate: &str) -> f64 {
        let numbers = self.0.get(&["time", arm, function, candidate].join(" "));
        numbers.map_or(f64::NAN, |numbers| numbers[0][0])
    }

    fn ratio(&self, arm: &str, function: &str) -> f64 {
        self.of("ratio", arm, function, GENERATED)[0]
    }

    /// Largest error and root of the mean square, as text.
    fn errors(&self, arm: &str, function: &str, candidate: &str) -> String {
        let [largest, rms] = self.of("error", arm, function, candidate);
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

/// One line of the table of goals.
fn goal(what: &str, measured: f64, bar: Bar) {
    let (is_met, words) = match bar {
        Bar::AtMost(bar) => (measured <= bar, format!("at most {}", digits(bar))),
        Bar::AtLeast(bar) => (measured >= bar, format!("at least {}", digits(bar))),
    };
    let verdict = if is_met { "met" } else { "**missed**" };
    println!("| {what} | {} | {words} | {verdict} |", digits(measured));
}

fn digits(x: f64) -> String {
    match x {
        ..1e-3 => format!("{x:.1e}"),
        ..10.0 => format!("{x:.2}"),
        _ => format!("{x:.0}"),
    }
}

/// Prints both tables, of a processor with that many lanes of doubles.
pub(crate) fn print(lanes: &str, file: &str) {
    let records = Records::read(file);
    let widest = lanes == "8";
    println!("| goal | measured | bar | |\n|---|--:|--:|---|");
    let single = Each::of(&ARMS, |arm, function| records.share(arm, function));
    shares("one state", &single, 0.8);
    let batch = Each::of(&ARMS, |arm, function| {
        records.share(arm, &format!("{function}_batch"))
    });
    let bar = if widest { 0.85 } else { 0.7 };
    shares("batches", &batch, bar);
    let puma = Each::of(&["puma560"], |arm, function| {
        records.share(arm, &format!("{function}_batch"))
    });
    shares("batches of the PUMA 560", &puma, bar);
    for (what, suffix, bar) in [("batches", "_batch_f32", 0.55), ("one state", "_f32", 1.0)] {
        let ratio = |arm: &str, function: &str| records.ratio(arm, &format!("{function}{suffix}"));
        let each = Each::of(&ARMS, ratio);
        let (slowest, largest) = each.largest();
        let mean = each.geometric_mean();
        goal(
            &format!("`f32` / `f64`, {what}, geometric mean"),
            mean,
            Bar::AtMost(bar),
        );
        goal(
            &format!("`f32` / `f64`, {what}, the slowest: {slowest}"),
            largest,
            Bar::AtMost(bar),
        );
        let error = |arm: &str, function: &str| {
            records.of("error", arm, &format!("{function}{suffix}"), GENERATED)[0]
        };
        let (worst, error) = Each::of(&ARMS, error).largest();
        goal(
            &format!("`f32`, {what}, largest error: {worst}"),
            error,
            Bar::AtMost(4e-7),
        );
    }
    for (function, bar) in [("inverse", 200.0), ("forward", 350.0)] {
        let function = format!("{function}_dynamics_derivatives_batch");
        let time = records.time("panda", &function, GENERATED);
        let errors = records.errors("panda", &function, GENERATED);
        let bar = if widest { bar / 2.0 } else { bar };
        let what = format!("`{function}` of the Panda, ns a state (errors {errors})");
        goal(&what, time, Bar::AtMost(bar));
    }
    let second = "inverse_dynamics_second_derivatives";
    let errors = records.errors("panda", second, GENERATED);
    let what = format!("`{second}` of the Panda, ns a call (errors {errors})");
    goal(
        &what,
        records.time("panda", second, GENERATED),
        Bar::AtMost(1500.0),
    );
    for (key, numbers) in &records.0 {
        if let Some(name) = key.strip_prefix("ratio panda par_") {
            let name = name
                .trim_end_matches(" generated")
                .replace("_of_", "`, states: ");
            let ratio = numbers[numbers.len() / 2][0];
            goal(
                &format!("two cores / one, `par_{name}"),
                ratio,
                Bar::AtLeast(1.8),
            );
        }
    }
    details(&records);
    in_c(&records);
}

fn shares(what: &str, each: &Each, bar: f64) {
    let (slowest, largest) = each.largest();
    let mean = format!("{what}, time / the trial's, geometric mean");
    goal(&mean, each.geometric_mean(), Bar::AtMost(bar));
    goal(
        &format!("{what}, the slowest: {slowest}"),
        largest,
        Bar::AtMost(1.0),
    );
}

const HEADS: &str = "
Each function: ns a state here / the trial's, and its share; largest error and root of the mean square here
(over the largest value at 64 states) and of the trial (over the natural scale, angles of 1e6 rad among them);
then `f32`, as a share of the time of `f64`.

| arm | function | one state | share | errors | trial's | batch | share | errors | f32 | f32 batch | errors of f32 batch |
|---|---|--:|--:|---|---|--:|--:|---|--:|--:|---|
";

fn details(records: &Records) {
    print!("{HEADS}");
    for arm in ARMS {
        for function in NAMES {
            let batch = format!("{function}_batch");
            let times = |function: &str| {
                let [ours, trial] =
                    [GENERATED, TRIAL].map(|candidate| records.time(arm, function, candidate));
                format!("{ours:.1} / {trial:.1} | {:.2}", ours / trial)
            };
            println!(
                "| {arm} | {function} | {} | {} | {} | {} | {} | {:.2} | {:.2} | {} |",
                times(function),
                records.errors(arm, function, GENERATED),
                records.errors(arm, function, TRIAL),
                times(&batch),
                records.errors(arm, &batch, GENERATED),
                records.ratio(arm, &format!("{function}_f32")),
                records.ratio(arm, &format!("{batch}_f32")),
                records.errors(arm, &format!("{batch}_f32"), GENERATED),
            );
        }
    }
}

const HEADS_OF_C: &str = "
The C code that `robot-dynamics generate` writes: ns of one call, times those of the generated Rust, and largest error
and root of the mean square over the natural scale. The programs are the same; the sines are the C library's, one
angle after the other, where those of Rust are evaluated together in vectors.

| arm | function | Rust | C, gcc | / Rust | errors | C, clang | / Rust | errors |
|---|---|--:|--:|--:|---|--:|--:|---|
";

fn in_c(records: &Records) {
    if records.time(ARMS[0], NAMES[0], COMPILERS[0]).is_nan() {
        return;
    }
    print!("{HEADS_OF_C}");
    for arm in ARMS {
        for function in NAMES {
            let rust = records.time(arm, function, GENERATED);
            let [gcc, clang] = COMPILERS.map(|compiler| {
                let time = records.time(arm, function, compiler);
                let errors = records.errors(arm, function, compiler);
                format!("{time:.1} | {:.2} | {errors}", time / rust)
            });
            println!("| {arm} | {function} | {rust:.1} | {gcc} | {clang} |");
        }
    }
}
