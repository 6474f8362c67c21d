//! The second part of the report: integrators.

use std::error::Error;

use measuring::table::{Table, short};
use robot_dynamics::nalgebra::{SVector, Vector2, Vector6};
use robot_dynamics::{DoubleDouble, ForwardDynamics, simulation::TaylorDynamics};
use testkit::plot::{Mark, Plot, Series};
use testkit::references::MotionFile;

use crate::integrators::{Curve, Problem, Run, Setting, work_at};
use crate::page::{Part, Section};
use crate::problems::{FreePuma, OneLink, StiffArm, TwoLinks};

/// Where runs are drawn that did not reach their end, or reached it more than a radian away.
const NO_RESULT: f64 = 1.0;

pub(crate) fn section(quick: bool) -> Result<Section, Box<dyn Error>> {
    let mut section = Section::appendix("Integrators", "integrators");
    section.text(
        "Errors are the largest of a position at the end of a free motion. Beside them stand the time of \
         the whole run and the evaluations of the equations of motion. The structure-preserving methods \
         evaluate M, its rate of change and the bias force instead; the Taylor method counts orders of a \
         series. Runs have steps of a power of two, or a tolerance of a power of ten. A cell `-` means \
         that no run reached the error.",
    );
    section.text(
        "The problem's own floor is what the motion makes of one rounding of its initial state. The order \
         is the slope of log error over log evaluations between 0.03 and a hundred floors.",
    );
    section.parts.push(Part::Legend(
        "Every point of a plot is a run. A cross is a run that did not reach the end or ended a radian or \
         more from the truth. The vertical line is the problem's floor.",
    ));
    for problem in [
        from_file("one_link_free", "One link, 10 s", &OneLink, quick)?,
        from_file("two_link_free", "Two links, 10 s", &TwoLinks, quick)?,
        puma(quick),
        stiff(quick),
    ] {
        add(&mut section, &problem)?;
    }
    Ok(section)
}

/// A problem whose reference is a file of 30 digits.
fn from_file<R: ForwardDynamics<N> + TaylorDynamics<N>, const N: usize>(
    file: &str,
    name: &'static str,
    arm: &R,
    quick: bool,
) -> Result<Problem, Box<dyn Error>> {
    let motion: MotionFile = testkit::references::read("trajectories", file);
    let (q, qd) = motion.initial();
    let duration = 10.0;
    let (Some(end), Some(growth)) = (motion.y.last(), motion.sensitivity_per_sample.last()) else {
        return Err(format!("{file} has no samples").into());
    };
    let end = SVector::<_, N>::from_fn(|i, _| end[i].value());
    let text = format!(
        "Free fall from rest. The reference is tests/data/trajectories/{file}.json, of 30 digits. The \
         motion makes {growth:.0} of a unit change of its start."
    );
    let setting = Setting {
        name,
        arm,
        q,
        qd,
        duration,
    };
    Ok(setting.problem(text, &end, *growth, quick))
}

fn puma(quick: bool) -> Problem {
    let setting = Setting {
        name: "PUMA 560, 2 s",
        arm: &FreePuma,
        q: Vector6::zeros(),
        qd: Vector6::zeros(),
        duration: 2.0,
    };
    in_31_digits(
        &setting,
        "Free fall from rest at q = 0, without friction",
        128,
        quick,
    )
}

fn stiff(quick: bool) -> Problem {
    let setting = Setting {
        name: "Stiff arm, 0.2 s",
        arm: &StiffArm,
        q: Vector2::zeros(),
        qd: Vector2::new(1.0, 10.0),
        duration: 0.2,
    };
    let text = "A rod of 12 kg is in a joint of 10^4 N m s, a wrist of 10^-6 kg m^2 in a joint of \
                10^-2 N m s. They start at 1 and 10 rad/s and decay at 2,500 and 10,000 per second";
    in_31_digits(&setting, text, 1024, quick)
}

fn in_31_digits<R: ForwardDynamics<N> + TaylorDynamics<N>, const N: usize>(
    setting: &Setting<R, N>,
    text: &str,
    steps: u32,
    quick: bool,
) -> Problem {
    let (end, error, growth): (SVector<DoubleDouble, N>, _, _) = setting.reference(steps);
    let text = format!(
        "{text}. The reference is extrapolation of order 16 in 31 digits by {steps} steps. It differs \
         by {error:.0e} from that of half as many. The motion makes {growth:.1} of a unit change of its \
         start."
    );
    setting.problem(text, &end, growth, quick)
}

fn add(section: &mut Section, problem: &Problem) -> Result<(), Box<dyn Error>> {
    section.text(format!("{}. {}", problem.name, problem.text));
    let file = problem.name.to_lowercase().replace([' ', ',', '.'], "_");
    for (y, suffix, work) in [
        (
            "time of the run, us",
            "time",
            (|run| run.nanoseconds / 1e3) as fn(&Run) -> f64,
        ),
        ("evaluations", "evaluations", |run| run.evaluations as f64),
    ] {
        let svg = plot(problem, y, work).svg()?;
        section
            .parts
            .push(Part::Plot(format!("{file}_{suffix}"), svg));
    }
    section.parts.push(Part::Table(summary(problem)));
    section.parts.push(Part::Folded(runs(problem)));
    Ok(())
}

fn plot(problem: &Problem, y: &'static str, work: fn(&Run) -> f64) -> Plot {
    let series = problem.curves.iter().map(|curve| Series {
        name: curve.method.to_owned(),
        joined: true,
        points: (curve.runs.iter())
            .map(|run| match run.small_error() {
                Some(error) => (error.max(1e-17), work(run), Mark::Dot),
                None => (NO_RESULT, work(run), Mark::Cross),
            })
            .collect(),
    });
    Plot {
        title: problem.name.to_owned(),
        x: "error at the end, rad (crosses: none)",
        y,
        series: series.collect(),
        limits: vec![(problem.floor, "the problem's floor")],
    }
}

/// The work for given errors, and the order.
fn summary(problem: &Problem) -> Table {
    let heads = [
        "method",
        "order",
        "1e-4: us",
        "evaluations",
        "1e-8: us",
        "evaluations",
        "1e-10: us",
        "evaluations",
        "1e-12: us",
        "evaluations",
        "best error",
    ];
    let mut table = Table::new(format!("{}: work for an error", problem.name), &heads);
    for curve in &problem.curves {
        let mut row = vec![curve.method.to_owned()];
        row.push(
            curve
                .order
                .map_or("-".to_owned(), |order| format!("{order:.1}")),
        );
        for error in [1e-4, 1e-8, 1e-10, 1e-12] {
            match work_at(curve, error) {
                Some((time, evaluations)) => {
                    row.push(format!("{:.0}", time / 1e3));
                    row.push(format!("{evaluations:.0}"));
                }
                None => row.extend(["-".to_owned(), "-".to_owned()]),
            }
        }
        row.push(short(best(curve)));
        table.row(row);
    }
    table
}

fn best(curve: &Curve) -> f64 {
    let errors = curve.runs.iter().filter_map(Run::small_error);
    errors.fold(f64::INFINITY, f64::min)
}

fn runs(problem: &Problem) -> Table {
    let heads = ["method", "step or tolerance", "us", "evaluations", "error"];
    let mut table = Table::new(format!("{}: all runs", problem.name), &heads);
    for curve in &problem.curves {
        for run in &curve.runs {
            let error = match &run.error {
                Ok(error) => short(*error),
                Err(cause) => format!("stopped {cause}"),
            };
            table.row([
                curve.method.to_owned(),
                short(run.parameter),
                format!("{:.1}", run.nanoseconds / 1e3),
                run.evaluations.to_string(),
                error,
            ]);
        }
    }
    table
}
