//! Functions for CasADi, called through the interface that `casadi.external` uses: values beside those of Rust, derivatives
//! beside differences of these. The package of Python compares them with CasADi's own derivatives.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::process::Command;

use dynamics_evaluation::RuntimeRobot;
use dynamics_export::{casadi_requests, casadi_source};
use dynamics_symbolic::robot::{Robot, Value};
use dynamics_symbolic::{Function, Proven, Request, proven_program};

use crate::generated;
use crate::languages::{by_rows, folder, is_there, run};

/// A bound on errors relative to the largest entry, where both sides compute the same.
const OF_VALUES: f64 = 1e-12;

/// The same of differences with this step.
const OF_DIFFERENCES: f64 = 1e-6;
const STEP: f64 = 1e-5;

/// Reads each function as CasADi does, and prints its outputs with all of their entries, by rows.
const READER: &str = r#"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef long long int number;
typedef const number *(*pattern_of)(number);
typedef const char *(*name_of)(number);
typedef int (*function)(const double **, double **, number *, double *, int);
typedef int (*room_of)(number *, number *, number *, number *);

#define CALL(f) call(#f, f, f##_n_in(), f##_n_out(), f##_name_in, f##_name_out, f##_sparsity_in, f##_sparsity_out, f##_work)
#define DECLARE(f) \
    int f(const double **, double **, number *, double *, int); \
    number f##_n_in(void); \
    number f##_n_out(void); \
    const char *f##_name_in(number); \
    const char *f##_name_out(number); \
    const number *f##_sparsity_in(number); \
    const number *f##_sparsity_out(number); \
    int f##_work(number *, number *, number *, number *);

static void require(int is_right, const char *what)
{
    if (is_right) return;
    fprintf(stderr, "%s\n", what);
    exit(1);
}

static number entries(const number *pattern)
{
    number column, place;
    const number rows = pattern[0], columns = pattern[1], *starts = pattern + 2;
    if (starts[0] == 1) return rows * columns;
    for (column = 0; column < columns; ++column)
        for (place = starts[column]; place < starts[column + 1]; ++place) {
            const number row = starts[columns + 1 + place];
            require(row >= 0 && row < rows, "a row that is there");
            require(place == starts[column] || starts[columns + place] < row, "rows in order");
        }
    return starts[columns];
}

static double entry(const number *pattern, const double *values, number row, number column)
{
    const number rows = pattern[0], columns = pattern[1], *starts = pattern + 2;
    number place;
    if (starts[0] == 1) return values[column * rows + row];
    for (place = starts[column]; place < starts[column + 1]; ++place)
        if (starts[columns + 1 + place] == row) return values[place];
    return 0.0;
}

static void call(const char *name, function f, number n_in, number n_out, name_of name_in, name_of name_out,
                 pattern_of sparsity_in, pattern_of sparsity_out, room_of room)
{
    const double *arg[200] = {0};
    double *res[200] = {0}, *w;
    number i, row, column, sz_arg, sz_res, sz_iw, sz_w;
    require(n_in < 200 && n_out < 200, "room");
    require(room(0, 0, 0, 0) == 0 && room(&sz_arg, &sz_res, &sz_iw, &sz_w) == 0, "a size of the room");
    require(sz_arg == n_in && sz_res == n_out && sz_iw == 0, "pointers to inputs and outputs");
    w = malloc((size_t)(sz_w + 1) * sizeof(double));
    w[sz_w] = 123.0;
    /* Nothing is given, and nothing asked for. */
    f(arg, res, 0, w, 0);
    for (i = 0; i < n_in; ++i) {
        const number *pattern = sparsity_in(i);
        const int is_place = !strncmp(name_in(i), "out_", 4);
        require(entries(pattern) == (is_place ? 0 : pattern[0] * pattern[1]), "inputs that are full, places that are empty");
        arg[i] = is_place ? 0 : input(name_in(i));
    }
    for (i = 0; i < n_out; ++i) {
        const number count = entries(sparsity_out(i));
        res[i] = malloc((size_t)(count + 1) * sizeof(double));
        res[i][count] = 123.0;
    }
    require(f(arg, res, 0, w, 0) == 0, "a value");
    require(w[sz_w] == 123.0, "no more room than there is");
    free(w);
    for (i = 0; i < n_out; ++i) {
        const number *pattern = sparsity_out(i);
        require(res[i][entries(pattern)] == 123.0, "no more entries than there are");
        printf("%s %s %lld %lld", name, name_out(i), pattern[0], pattern[1]);
        for (row = 0; row < pattern[0]; ++row)
            for (column = 0; column < pattern[1]; ++column) printf(" %.17g", entry(pattern, res[i], row, column));
        printf("\n");
        free(res[i]);
    }
}
"#;

/// The functions with a reverse mode, the weights of their values there, and functions whose values are their derivatives.
const REVERSED: [(&str, &str, &[&str]); 3] = [
    (
        "inverse_dynamics",
        "adj_tau",
        &["inverse_dynamics_derivatives", "mass_matrix"],
    ),
    (
        "forward_dynamics",
        "adj_qdd",
        &["forward_dynamics_derivatives"],
    ),
    (
        "forward_dynamics_aba",
        "adj_qdd",
        &["forward_dynamics_derivatives"],
    ),
];

/// A matrix that was printed.
struct Printed {
    output: String,
    rows: usize,
    columns: usize,
    /// By rows.
    entries: Vec<f64>,
}

/// A robot, and what C computed for each function.
struct Called {
    arm: RuntimeRobot,
    outputs: BTreeMap<String, Vec<Printed>>,
}

/// Entries of an argument.
fn argument(name: &str, count: usize) -> Vec<f64> {
    let seed = name.len() * 5 + usize::from(name.as_bytes()[0]);
    let entry = |i: usize| ((seed + 3 * i) as f64).sin();
    match name {
        // A quarter turn about x.
        "base" => vec![1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0, 0.1, 0.2, 0.3],
        _ => (0..count).map(entry).collect(),
    }
}

impl Called {
    /// Compiles functions of a robot and calls them, and each of their derivatives.
    fn new(robot: Robot, fields: &[f64], functions: &[Function]) -> Self {
        let requests = functions.iter().map(|function| Request::from(*function));
        let requests: Vec<_> = requests.collect();
        let programs = casadi_requests(&robot, &requests)
            .into_iter()
            .map(|request| {
                let program = proven_program(&robot, &request).expect("proven");
                (robot.request(request), program)
            });
        let programs: Vec<(Request, Proven)> = programs.collect();
        let source = casadi_source(&robot, &requests, &programs);
        let folder = folder(&format!("casadi_{}", source.name));
        let mut arm = RuntimeRobot::of_programs(robot, &programs).expect("a robot");
        arm.set_fields(fields).expect("a value for each field");
        let names = requests.iter().map(Request::name).flat_map(|name| {
            ["", "jac_", "jac_jac_", "adj1_", "jac_adj1_"].map(|prefix| format!("{prefix}{name}"))
        });
        let names: Vec<_> = names
            .filter(|name| source.text.contains(&format!(" {name}(const")))
            .collect();
        let main = main(&arm, &names);
        std::fs::write(folder.join("main.c"), main).expect("a file");
        std::fs::write(folder.join(&source.name), source.text).expect("a file");
        let mut compiler = Command::new("gcc");
        compiler
            .current_dir(&folder)
            .args([
                "-std=c99",
                "-Wall",
                "-Wextra",
                "-Wpedantic",
                "-Werror",
                "-O1",
            ])
            .args([&source.name, "main.c", "-lm", "-o", "called"]);
        run(&mut compiler);
        let printed = run(&mut Command::new(folder.join("called")));
        let mut outputs: BTreeMap<String, Vec<Printed>> = BTreeMap::new();
        for line in printed.lines() {
            let (function, output) = read(line);
            outputs.entry(function).or_default().push(output);
        }
        assert_eq!(outputs.len(), names.len());
        Called { arm, outputs }
    }

    fn arguments(&self, function: &str) -> Vec<(&'static str, usize)> {
        let arguments = self.arm.arguments(function).expect("a function");
        arguments.collect()
    }

    /// Values by rows, where an argument is changed by so much in one of its entries.
    fn values(&self, function: &str, changed: Option<(&str, usize, f64)>) -> Vec<f64> {
        let arguments = self.arguments(function);
        let mut entries: Vec<Vec<f64>> = arguments
            .iter()
            .map(|(name, count)| argument(name, *count))
            .collect();
        if let Some((name, entry, change)) = changed {
            let place = arguments.iter().position(|(argument, _)| *argument == name);
            if let Some(place) = place {
                entries[place][entry] += change;
            }
        }
        let slices: Vec<&[f64]> = entries.iter().map(Vec::as_slice).collect();
        by_rows(&self.arm.evaluate(function, &slices).expect("regular"))
    }

    /// The derivative of these values by an entry of an argument.
    fn difference(&self, functions: &[&str], argument: &str, entry: usize) -> Vec<f64> {
        let at = |change: f64| -> Vec<f64> {
            let changed = Some((argument, entry, change));
            let values = functions
                .iter()
                .map(|function| self.values(function, changed));
            values.flatten().collect()
        };
        let both = at(STEP).into_iter().zip(at(-STEP));
        both.map(|(after, before)| (after - before) / (2.0 * STEP))
            .collect()
    }

    fn assert_values(&self, function: &str) {
        let outputs = self.outputs[function].iter();
        let found: Vec<f64> = outputs.flat_map(|output| output.entries.clone()).collect();
        assert_near(&found, &self.values(function, None), OF_VALUES, function);
    }

    /// Each block of first derivatives beside differences, or unknown by `arm`.
    fn assert_first(&self, function: &str) {
        let arguments = self.arguments(function);
        for block in &self.outputs[&format!("jac_{function}")] {
            let label = format!("{} of {function}", block.output);
            let (_, input) = block.output.rsplit_once('_').expect("names");
            if is_unknown(input) {
                assert!(block.entries.iter().all(|x| x.is_nan()), "{label}");
                continue;
            }
            let (_, count) = arguments
                .iter()
                .find(|(name, _)| *name == input)
                .expect("an argument");
            assert_eq!(block.columns, *count, "{label}");
            for column in 0..block.columns {
                let expected = self.difference(&[function], input, column);
                assert_near(&block.column(column), &expected, OF_DIFFERENCES, &label);
            }
        }
    }

    /// Each block of second derivatives beside differences of the first ones, which are matrices of Rust.
    fn assert_second_of_inverse_dynamics(&self) {
        const FIRST: [&str; 2] = ["inverse_dynamics_derivatives", "mass_matrix"];
        let count = self.values("inverse_dynamics", None).len();
        for block in &self.outputs["jac_jac_inverse_dynamics"] {
            let label = &block.output;
            let mut words = label["jac_jac_tau_".len()..].split('_');
            let (one, other) = (
                words.next().expect("a name"),
                words.next().expect("two names"),
            );
            if other == "out" {
                assert!(block.entries.iter().all(|x| *x == 0.0), "{label}");
                continue;
            }
            if is_unknown(one) || is_unknown(other) {
                assert!(block.entries.iter().all(|x| x.is_nan()), "{label}");
                continue;
            }
            let columns = block.rows / count;
            if one == "base" {
                // Forces are linear in the pose; otherwise the order of two derivatives does not matter.
                block.assert_entries(OF_VALUES, &|row, column| match other {
                    "base" => 0.0,
                    _ => {
                        let turned = format!("jac_jac_tau_{other}_base");
                        let turned = self.block("jac_jac_inverse_dynamics", &turned);
                        let (force, number) = (row % count, row / count);
                        turned.entries[(column * count + force) * turned.columns + number]
                    }
                });
                continue;
            }
            let matrix = ["q", "qd", "qdd"]
                .iter()
                .position(|name| *name == one)
                .expect("known");
            for column in 0..block.columns {
                let first = self.difference(&FIRST, other, column);
                let first = &first[matrix * count * count..][..count * count];
                let places =
                    (count - columns..count).flat_map(|j| (0..count).map(move |i| i * count + j));
                let expected: Vec<f64> = places.map(|place| first[place]).collect();
                assert_near(&block.column(column), &expected, OF_DIFFERENCES, label);
            }
        }
    }
}

impl Called {
    fn block(&self, function: &str, output: &str) -> &Printed {
        let mut blocks = self.outputs[function].iter();
        blocks.find(|of| of.output == output).expect("a block")
    }

    /// Reverse mode beside first derivatives, and its own derivatives beside differences of first ones of Rust.
    fn assert_adjoint(&self, function: &str, weights: &str, derivatives: &[&str]) {
        let outputs = weights.replace("adj_", "");
        let values = argument(weights, self.values(function, None).len());
        let count = values.len();
        let first = |input: &str| {
            self.block(
                &format!("jac_{function}"),
                &format!("jac_{outputs}_{input}"),
            )
        };
        for found in &self.outputs[&format!("adj1_{function}")] {
            let block = first(&found.output["adj_".len()..]);
            found.assert_entries(OF_VALUES, &|j, _| block.weighted(&values, j));
        }
        let arguments = self.arguments(function);
        let joints = arguments.iter().filter(|(name, _)| *name != "base");
        let joints: Vec<&str> = joints.map(|(name, _)| *name).collect();
        for found in &self.outputs[&format!("jac_adj1_{function}")] {
            let names = found.output["jac_adj_".len()..].split_once('_');
            let (one, other) = names.expect("two names");
            if other == weights {
                let block = first(one);
                found.assert_entries(OF_VALUES, &|j, k| block.entries[k * block.columns + j]);
            } else if other.starts_with("out_") {
                found.assert_entries(0.0, &|_, _| 0.0);
            } else if is_unknown(one) || is_unknown(other) {
                assert!(found.entries.iter().all(|x| x.is_nan()), "{}", found.output);
            } else if one == "base" {
                // The order of two derivatives does not matter, and values are linear in the pose.
                let block = self.block(
                    &format!("jac_adj1_{function}"),
                    &format!("jac_adj_{other}_base"),
                );
                found.assert_entries(OF_VALUES, &|j, k| match other {
                    "base" => 0.0,
                    _ => block.entries[k * block.columns + j],
                });
            } else {
                let matrix = joints.iter().position(|name| *name == one).expect("known");
                let columns = 0..found.columns;
                let rates: Vec<_> = columns
                    .map(|k| self.difference(derivatives, other, k))
                    .collect();
                found.assert_entries(OF_DIFFERENCES, &|j, k| {
                    let column = count - found.rows + j;
                    let entry = |i: usize| rates[k][(matrix * count + i) * count + column];
                    values
                        .iter()
                        .enumerate()
                        .map(|(i, weight)| weight * entry(i))
                        .sum()
                });
            }
        }
    }
}

impl Printed {
    /// Each entry beside another value; unknown ones are so together.
    fn assert_entries(&self, bound: f64, expected: &dyn Fn(usize, usize) -> f64) {
        let places = (0..self.rows).flat_map(|i| (0..self.columns).map(move |j| (i, j)));
        let expected: Vec<f64> = places.map(|(i, j)| expected(i, j)).collect();
        if expected.iter().any(|x| x.is_nan()) {
            let mut all = self.entries.iter().chain(&expected);
            assert!(all.all(|x| x.is_nan()), "{}", self.output);
            return;
        }
        assert_near(&self.entries, &expected, bound, &self.output);
    }

    /// The weighted sum down a column.
    fn weighted(&self, weights: &[f64], column: usize) -> f64 {
        let entries = (0..).map(|row| self.entries[row * self.columns + column]);
        entries
            .zip(weights)
            .map(|(entry, weight)| weight * entry)
            .sum()
    }

    fn column(&self, column: usize) -> Vec<f64> {
        let rows = self.entries.chunks(self.columns.max(1));
        rows.map(|row| row[column]).collect()
    }
}

fn is_unknown(input: &str) -> bool {
    input == "arm"
}

/// The program that calls functions of these names.
fn main(arm: &RuntimeRobot, names: &[String]) -> String {
    let mut inputs: BTreeMap<&str, Vec<f64>> = BTreeMap::new();
    inputs.insert("arm", arm.fields().to_vec());
    for (_, weights, _) in REVERSED {
        inputs.insert(weights, argument(weights, arm.dof()));
    }
    for name in arm.function_names() {
        for (input, count) in arm.arguments(name).expect("a function") {
            inputs.insert(input, argument(input, count));
        }
    }
    let mut text = "static const double *input(const char *name);\n".to_owned();
    text.push_str(READER);
    for (name, entries) in &inputs {
        let entries: Vec<_> = entries.iter().map(|x| format!("{x:?}")).collect();
        let entries = if entries.is_empty() {
            "0".to_owned()
        } else {
            entries.join(", ")
        };
        let _ = writeln!(
            text,
            "static const double value_of_{name}[] = {{{entries}}};"
        );
    }
    text.push_str("static const double *input(const char *name)\n{\n");
    for name in inputs.keys() {
        let _ = writeln!(
            text,
            "    if (!strcmp(name, \"{name}\")) return value_of_{name};"
        );
    }
    text.push_str("    return 0;\n}\n");
    let _ = names
        .iter()
        .try_for_each(|name| writeln!(text, "DECLARE({name})"));
    text.push_str("int main(void)\n{\n");
    for name in names {
        let _ = writeln!(text, "    CALL({name});");
    }
    text + "    return 0;\n}\n"
}

/// A line of the program: the function, and an output.
fn read(line: &str) -> (String, Printed) {
    let mut words = line.split(' ');
    let mut word = || words.next().expect("a word").to_owned();
    let (function, output) = (word(), word());
    let [rows, columns] = [word(), word()].map(|size| size.parse().expect("a size"));
    let entries = words.map(|x| {
        x.trim_start_matches('-')
            .parse::<f64>()
            .map(|size| if x.starts_with('-') { -size } else { size })
    });
    let entries: Vec<f64> = entries.map(|x| x.expect("a number")).collect();
    assert_eq!(entries.len(), rows * columns);
    (
        function,
        Printed {
            output,
            rows,
            columns,
            entries,
        },
    )
}

#[track_caller]
fn assert_near(found: &[f64], expected: &[f64], bound: f64, label: &str) {
    assert_eq!(found.len(), expected.len(), "{label}");
    let size = expected.iter().fold(1.0_f64, |size, x| size.max(x.abs()));
    for (found, expected) in found.iter().zip(expected) {
        let is_near = (found - expected).abs() <= bound * size;
        assert!(is_near, "{label}: {found:e} {expected:e}");
    }
}

/// Functions with derivatives, and those that these are compared with.
const DIFFERENTIATED: [Function; 8] = [
    Function::InverseDynamics,
    Function::InverseDynamicsDerivatives,
    Function::MassMatrix,
    Function::ForwardDynamics,
    Function::ForwardDynamicsDerivatives,
    Function::ForwardDynamicsAba,
    Function::BiasForce,
    Function::CenterOfMass,
];

fn assert_casadi(robot: Robot, fields: &[f64], functions: &[Function]) {
    if !is_there("gcc") {
        return;
    }
    let called = Called::new(robot, fields, functions);
    for function in functions {
        called.assert_values(function.name());
    }
    for function in [
        "inverse_dynamics",
        "forward_dynamics",
        "forward_dynamics_aba",
        "bias_force",
        "center_of_mass",
    ] {
        called.assert_first(function);
    }
    called.assert_second_of_inverse_dynamics();
    for (function, weights, derivatives) in REVERSED {
        called.assert_adjoint(function, weights, derivatives);
    }
}

#[test]
fn derivatives_of_arms_are_those_of_their_functions() {
    for name in ["two_link_craig", "scara", "puma560"] {
        assert_casadi(arms::robot(name), &[], &DIFFERENTIATED);
    }
}

/// Every function, and symbolic parameters, by which derivatives are not known.
#[test]
fn every_function_has_the_interface_of_casadi() {
    let functions: Vec<_> = generated::all_functions().collect();
    assert_casadi(generated::description(), &generated::FIELDS, &functions);
}

/// Derivatives by each number of the base's pose, by the joints and by all velocities, under gravity along all axes.
#[test]
fn derivatives_on_a_base_that_moves() {
    let free = arms::floating("free_body");
    let gravity = free.gravity.clone();
    let leaning = [Value::integer(1), Value::field(0), gravity[2].clone()];
    for (gravity, fields) in [(gravity, &[][..]), (leaning, &[-2.0])] {
        let robot = Robot {
            name: format!("scara on a trunk {}", fields.len()),
            base: free.base.clone(),
            gravity,
            fields: fields.iter().map(|_| "g".to_owned()).collect(),
            ..arms::robot("scara")
        };
        assert_casadi(robot, fields, &DIFFERENTIATED);
    }
}
