//! The third part of the report: energy and structure.

use std::error::Error;
use std::time::Instant;

use num_dual::Dual64;
use robot_dynamics::nalgebra::{SMatrix, SVector};
use robot_dynamics::{
    Energy, ForwardDynamics, Scalar, Simulation, SimulationError, Taylor, TaylorDynamics,
    TaylorSimulation, Trajectory,
};
use robots::{Elbow3r, Panda, Puma560, Scara, Stanford, TwoLinkSaha};
use testkit::plot::{Mark, Plot, Series};
use testkit::table::{Table, short};

use crate::functions::Arm;
use crate::integrators::{FAMILIES, TAYLOR};
use crate::page::{Part, Section};
use crate::problems::{OneLink as Swing, TwoLinks};
use crate::samples::{Samples, State};

/// Drifts below this are drawn here.
const LEAST: f64 = 1e-16;

pub(crate) fn section(duration: f64) -> Result<Section, Box<dyn Error>> {
    let mut section = Section::new("Energy and structure");
    section.text(format!(
        "Drift of the energy in free motion of {duration:e} s, by every method, with a step of 10 ms \
         or a tolerance of 1e-9, at 101 samples between steps of the adaptive methods, so that the \
         error of their interpolation is in it. A cross is where a run ended early."
    ));
    let swing = SVector::<f64, 1>::new(2.0);
    drifts(&mut section, "One link from 2 rad", &Swing, swing, duration)?;
    let fall = SVector::<f64, 2>::zeros();
    drifts(
        &mut section,
        "Two links from the horizontal",
        &TwoLinks,
        fall,
        duration,
    )?;
    section.text(
        "Identities of the generated functions in doubles at 48 random states: the asymmetry of M, its \
         smallest eigenvalue over its largest, |qd'(Mdot - 2 C) qd| over max |M| max |qd|^3, and \
         the power |dE/dt - qd'(tau - F)| over max |tau| max |qd|. Mdot is M on dual numbers of \
         num-dual.",
    );
    section.parts.push(Part::Table(identities()));
    Ok(section)
}

/// A method, its setting, the time of its run, s, and the run.
type Named<const N: usize> = (
    &'static str,
    String,
    f64,
    Result<Trajectory<N>, Box<SimulationError<N>>>,
);

/// The energy of every method's run.
fn drifts<R: ForwardDynamics<N> + Energy<N> + TaylorDynamics<N>, const N: usize>(
    section: &mut Section,
    title: &'static str,
    arm: &R,
    q: SVector<f64, N>,
    duration: f64,
) -> Result<(), Box<dyn Error>> {
    let heads = [
        "method",
        "setting",
        "s of processor",
        "largest drift, J",
        "drift at the end, J",
        "remark",
    ];
    let mut table = Table::new(format!("{title}, {duration:e} s"), &heads);
    let none = || "-".to_owned();
    // Methods with error control have a greatest number of steps between samples.
    let samples = if duration > 1e4 { 1001 } else { 101 };
    let mut series = Vec::new();
    let mut runs: Vec<Named<N>> = Vec::new();
    for family in &FAMILIES {
        let (method, setting) = family.method(0.01, 1e-9);
        let simulation = Simulation::new(arm)
            .method(method)
            .initial(q, SVector::zeros())
            .duration(duration)
            .samples(samples);
        let start = Instant::now();
        let run = simulation.run();
        runs.push((family.name, setting, start.elapsed().as_secs_f64(), run));
    }
    let simulation = TaylorSimulation::new(arm)
        .settings(Taylor::with_tolerance(1e-9))
        .initial(q, SVector::zeros())
        .duration(duration)
        .samples(samples);
    let start = Instant::now();
    let run = simulation.run();
    let time = start.elapsed().as_secs_f64();
    runs.push((TAYLOR, "tolerance 1e-9".to_owned(), time, run));
    for (name, setting, time, run) in runs {
        let (motion, remark) = match run {
            Ok(motion) => (motion, String::new()),
            Err(end) => {
                let remark = format!("stopped at {:.3} s: {:?}", end.time, end.cause);
                (end.trajectory, remark)
            }
        };
        let energies = motion.energies(arm);
        let drift: Vec<_> = energies
            .iter()
            .map(|energy| (energy - energies[0]).abs())
            .collect();
        table.row([
            name.to_owned(),
            setting,
            format!("{time:.2}"),
            // The first sample is where the drift is counted from.
            drift
                .iter()
                .skip(1)
                .copied()
                .reduce(f64::max)
                .map_or_else(none, short),
            drift
                .iter()
                .skip(1)
                .last()
                .copied()
                .map_or_else(none, short),
            remark.clone(),
        ]);
        let points = motion.t.iter().zip(&drift).skip(1);
        let mut points: Vec<_> = points
            .filter(|(_, drift)| drift.is_finite())
            .map(|(&t, &drift)| (t, drift.clamp(LEAST, 1e6), Mark::Dot))
            .collect();
        if !remark.is_empty() {
            let (t, drift) = points
                .last()
                .map_or((duration / 100.0, 1.0), |p| (p.0, p.1));
            points.push((t, drift, Mark::Cross));
        }
        series.push(Series {
            name: name.to_owned(),
            joined: true,
            points,
        });
    }
    let plot = Plot {
        title: format!("{title}: |E - E(0)| over time"),
        x: "t, s",
        y: "J",
        series,
        limits: Vec::new(),
    };
    let file = format!("energy_{}", title.to_lowercase().replace(' ', "_"));
    section.parts.push(Part::Plot(file, plot.svg()?));
    section.parts.push(Part::Table(table));
    Ok(())
}

/// An arm with its Coriolis matrix, which no trait has.
macro_rules! identities_of {
    ($table:ident: $($robot:ident, $n:literal;)*) => {$(
        let coriolis = |q: &SVector<f64, $n>, qd: &SVector<f64, $n>| $robot.coriolis_matrix(q, qd);
        $table.row(line::<_, $n>(stringify!($robot), &$robot, &coriolis));
    )*};
}

fn identities() -> Table {
    let heads = [
        "robot",
        "max |M - M'|",
        "least eigenvalue / greatest",
        "skewness",
        "power",
    ];
    let mut table = Table::new("Identities", &heads);
    identities_of! { table:
        TwoLinkSaha, 2;
        Elbow3r, 3;
        Scara, 4;
        Stanford, 6;
        Puma560, 6;
        Panda, 7;
    }
    table
}

/// The Coriolis matrix of an arm.
type Coriolis<'a, const N: usize> =
    &'a dyn Fn(&SVector<f64, N>, &SVector<f64, N>) -> SMatrix<f64, N, N>;

fn line<R: Arm<N>, const N: usize>(name: &str, arm: &R, coriolis: Coriolis<N>) -> Vec<String> {
    let samples = Samples::of(&arm.table());
    let states = samples.states::<f64>();
    let (mut asymmetry, mut definite) = (0.0_f64, f64::INFINITY);
    let (mut skewness, mut power) = (0.0_f64, 0.0_f64);
    for state in &states[..samples.timed()] {
        let State { q, qd, qdd, .. } = state;
        let m: SMatrix<f64, N, N> = arm.mass_matrix(q);
        asymmetry = asymmetry.max((m - m.transpose()).amax());
        definite = definite.min(least_over_greatest(m));
        let along = SVector::<_, N>::from_fn(|i, _| Dual64::new(q[i], qd[i]));
        let rate = arm.mass_matrix(&along).map(|entry| entry.eps);
        let skew = qd.dot(&((rate - coriolis(q, qd) * 2.0) * qd));
        skewness = skewness.max(skew.abs() / (m.amax() * qd.amax().powi(3)));

        // dE/dt = qd'(M qdd + 1/2 Mdot qd + G)
        let table = arm.table();
        let friction = SVector::<f64, N>::from_fn(|i, _| {
            let row = &table.rows[i];
            row.viscous * qd[i] + row.coulomb[0] * Scalar::sign(qd[i])
        });
        let tau: SVector<f64, N> = arm.inverse_dynamics(q, qd, qdd);
        let gravity: SVector<f64, N> = arm.gravity_vector(q);
        let change = qd.dot(&(m * qdd + rate * qd * 0.5 + gravity));
        let lost = change - qd.dot(&(tau - friction));
        power = power.max(lost.abs() / (tau.amax() * qd.amax()));
    }
    vec![
        name.to_owned(),
        short(asymmetry),
        short(definite),
        short(skewness),
        short(power),
    ]
}

/// By Jacobi's rotations.
fn least_over_greatest<const N: usize>(mut m: SMatrix<f64, N, N>) -> f64 {
    for _ in 0..12 {
        for i in 0..N {
            for j in i + 1..N {
                if m[(i, j)] == 0.0 {
                    continue;
                }
                // The angle that turns the entry (i, j) to zero (Golub and Van Loan, 8.5.2).
                let slope = (m[(j, j)] - m[(i, i)]) / (2.0 * m[(i, j)]);
                let t = slope.signum() / (slope.abs() + (slope * slope + 1.0).sqrt());
                let c = 1.0 / (t * t + 1.0).sqrt();
                let s = t * c;
                for k in 0..N {
                    let (a, b) = (m[(k, i)], m[(k, j)]);
                    (m[(k, i)], m[(k, j)]) = (c * a - s * b, s * a + c * b);
                }
                for k in 0..N {
                    let (a, b) = (m[(i, k)], m[(j, k)]);
                    (m[(i, k)], m[(j, k)]) = (c * a - s * b, s * a + c * b);
                }
            }
        }
    }
    let eigenvalues = m.diagonal();
    eigenvalues.min() / eigenvalues.max()
}
