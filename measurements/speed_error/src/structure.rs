//! The third part of the report: energy and structure.

use std::error::Error;

use measuring::seconds;
use measuring::table::{Table, short};
use num_dual::Dual64;
use robot_dynamics::nalgebra::{SMatrix, SVector};
use robot_dynamics::{
    Energy, ForwardDynamics, Scalar, Simulation, SimulationError, TaylorSimulation, Trajectory,
    simulation::{Taylor, TaylorDynamics},
};
use robots::{Elbow3r, Panda, Puma560, Scara, Stanford, TwoLinkSaha};
use testkit::plot::{Mark, Plot, Series};

use crate::functions::Arm;
use crate::integrators::{FAMILIES, TAYLOR};
use crate::page::{Part, Section};
use crate::problems::{OneLink as Swing, TwoLinks};
use crate::samples::{Samples, State};

/// How long the energy is watched in a run without `--long`, s.
pub(crate) const USUAL: f64 = 1e3;

/// Drifts below this are drawn here.
const LEAST: f64 = 1e-16;

pub(crate) fn section(duration: f64) -> Result<Section, Box<dyn Error>> {
    let mut section = if duration > USUAL {
        Section::appendix("Energy over a long time", "energy_long")
    } else {
        Section::appendix("Energy and structure", "energy")
    };
    section.text(format!(
        "Drift of the energy in free motion of {duration:e} s, by every method, with a step of 10 ms \
         or a tolerance of 1e-9. The {} samples are between steps of the adaptive methods, so that \
         the error of their interpolation is in it.",
        samples(duration)
    ));
    section
        .parts
        .push(Part::Legend("A cross is where a run ended early."));
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
    if duration <= USUAL {
        section.text(
            "The last table has identities of the generated functions in doubles at 48 random states. \
             They are the asymmetry of M, its smallest eigenvalue over its largest, \
             |qd'(Mdot - 2 C) qd| over max |M| max |qd|^3, and the power |dE/dt - qd'(tau - F)| over \
             max |tau| max |qd|. Mdot is M on dual numbers of num-dual.",
        );
        section.parts.push(Part::Table(identities()));
    }
    Ok(section)
}

/// The run of one method.
struct Run<const N: usize> {
    method: &'static str,
    setting: String,
    /// Time of the processor, s.
    time: f64,
    motion: Trajectory<N>,
    /// Why it ended early; empty where it did not.
    remark: String,
}

/// The energy of every method's run: a plot, and a table.
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
    let mut series = Vec::new();
    for run in runs(arm, q, duration) {
        let drift = drift(arm, &run.motion);
        series.push(curve(&run, &drift, duration));
        // The first sample is where the drift is counted from.
        let later = drift.get(1..).unwrap_or_default();
        let largest = later.iter().copied().reduce(f64::max);
        let shown = |drift: Option<f64>| drift.map_or_else(|| "-".to_owned(), short);
        table.row([
            run.method.to_owned(),
            run.setting,
            format!("{:.2}", run.time),
            shown(largest),
            shown(later.last().copied()),
            run.remark,
        ]);
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

/// The motion from rest at q by every method.
fn runs<R: ForwardDynamics<N> + TaylorDynamics<N>, const N: usize>(
    arm: &R,
    q: SVector<f64, N>,
    duration: f64,
) -> Vec<Run<N>> {
    let samples = samples(duration);
    let by_family = FAMILIES.iter().map(|family| {
        let (method, setting) = family.method(0.01, 1e-9);
        let simulation = Simulation::new(arm)
            .method(method)
            .initial(q, SVector::zeros())
            .duration(duration)
            .samples(samples);
        timed(family.name, setting, || simulation.run())
    });
    let mut runs: Vec<_> = by_family.collect();
    let simulation = TaylorSimulation::new(arm)
        .settings(Taylor::with_tolerance(1e-9))
        .initial(q, SVector::zeros())
        .duration(duration)
        .samples(samples);
    let setting = "tolerance 1e-9".to_owned();
    runs.push(timed(TAYLOR, setting, || simulation.run()));
    runs
}

/// Methods with error control have a greatest number of steps between samples.
fn samples(duration: f64) -> usize {
    if duration > USUAL { 1001 } else { 101 }
}

fn timed<const N: usize>(
    method: &'static str,
    setting: String,
    run: impl FnOnce() -> Result<Trajectory<N>, Box<SimulationError<N>>>,
) -> Run<N> {
    let (ended, time) = seconds(run);
    let (motion, remark) = match ended {
        Ok(motion) => (motion, String::new()),
        Err(end) => {
            let remark = format!("stopped at {:.3} s: {:?}", end.time, end.cause);
            (end.trajectory, remark)
        }
    };
    Run {
        method,
        setting,
        time,
        motion,
        remark,
    }
}

/// |E - E(0)| at each sample.
fn drift<R: Energy<N>, const N: usize>(arm: &R, motion: &Trajectory<N>) -> Vec<f64> {
    let energies = motion.energies(arm);
    let drift = |energy: &f64| (energy - energies[0]).abs();
    energies.iter().map(drift).collect()
}

/// The drift over time, with a cross where the run ended early.
fn curve<const N: usize>(run: &Run<N>, drift: &[f64], duration: f64) -> Series {
    let points = run.motion.t.iter().zip(drift).skip(1);
    let mut points: Vec<_> = points
        .filter(|(_, drift)| drift.is_finite())
        .map(|(&t, &drift)| (t, drift.clamp(LEAST, 1e6), Mark::Dot))
        .collect();
    if !run.remark.is_empty() {
        let last = points.last();
        let (t, drift) = last.map_or((duration / 100.0, 1.0), |p| (p.0, p.1));
        points.push((t, drift, Mark::Cross));
    }
    Series {
        name: run.method.to_owned(),
        joined: true,
        points,
    }
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
