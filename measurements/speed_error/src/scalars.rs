//! The cost of other numbers than doubles, in the same generated functions.

use measuring::Effort;
use measuring::table::{Table, digits};
use num_dual::{Dual64, DualSVec64};
use robot_dynamics::nalgebra::SVector;
use robot_dynamics::{DoubleDouble, Scalar};
use robots::{Panda, Puma560};

use crate::functions::Arm;
use crate::page::{Part, Section};
use crate::samples::Samples;

pub(crate) fn section(effort: Effort) -> Section {
    let mut section = Section::appendix("Other numbers", "numbers");
    section.text(
        "One evaluation of inverse and of forward dynamics, over its time in doubles. Dual numbers carry a \
         derivative along one direction, vectors of them the whole Jacobian by q. DoubleDouble has 31 digits.",
    );
    let heads = ["numbers", "tau", "qdd", "tau", "qdd"];
    let mut table = Table::new("PUMA 560 (first two columns), Panda (last two)", &heads);
    let mut rows = Vec::new();
    macro_rules! rows {
        ($($name:literal: $puma:ty, $panda:ty;)*) => {$(
            let [tau, qdd] = times::<$puma, 6>(&Puma560, effort);
            let [panda_tau, panda_qdd] = times::<$panda, 7>(&Panda, effort);
            rows.push(($name, [tau, qdd, panda_tau, panda_qdd]));
        )*};
    }
    rows! {
        "f64": f64, f64;
        "f32": f32, f32;
        "Dual64": Dual64, Dual64;
        "DualSVec64, one for each joint": DualSVec64<6>, DualSVec64<7>;
        "DoubleDouble": DoubleDouble, DoubleDouble;
    }
    // The first row is that of doubles.
    let doubles = rows.first().map_or([f64::NAN; 4], |(_, times)| *times);
    for (name, times) in rows {
        let row = std::array::from_fn::<_, 4, _>(|k| digits(times[k] / doubles[k]));
        table.row(std::iter::once(name.to_owned()).chain(row));
    }
    section.parts.push(Part::Table(table));
    section
}

fn times<T: Scalar, const N: usize>(arm: &impl Arm<N>, effort: Effort) -> [f64; 2] {
    let samples = Samples::of(&arm.table());
    let number = |x: &SVector<f64, N>| x.map(<T as Scalar>::from_f64);
    let states: Vec<_> = (samples.states::<f64>().iter().take(samples.timed()))
        .map(|s| [number(&s.q), number(&s.qd), number(&s.qdd), number(&s.tau)])
        .collect();
    [
        effort.nanoseconds(&states, |[q, qd, qdd, _]| arm.inverse_dynamics(q, qd, qdd)),
        effort.nanoseconds(&states, |[q, qd, _, tau]| arm.forward_dynamics(q, qd, tau)),
    ]
}
