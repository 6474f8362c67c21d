//! The cost of each piece of a model, and the effect of leaving it out.

use measuring::table::{Table, digits, short};
use scene::arms::PumaWithoutWrist;
use scene::features::{Feature, features};
use scene::measure::{operations, times};
use testkit::five::NAMES;

use crate::page::{Part, Section};

pub(crate) fn section() -> Section {
    let mut section = Section::appendix("What each piece costs", "pieces");
    section.text(
        "Operations are multiplications, additions and divisions; sines are not counted. The time of a \
         call is over that of the complete arm. The error is the largest difference from the complete \
         arm's value at 500 random states, over the largest value there. Joints are anywhere in them, \
         at up to 3 rad/s and 10 rad/s^2. Errors of accelerations are those under the complete arm's torques.",
    );
    section.text(
        "`neglect:` leaves out of the Lagrangian what is below a share of the largest value. A locked \
         wrist (`lock:`) makes an arm of three joints.",
    );
    let features = features();
    for (k, function) in NAMES.iter().enumerate() {
        let heads = ["without", "operations", "time", "error"];
        let mut table = Table::new(*function, &heads);
        for feature in &features {
            table.row([
                format!("{}: {}", feature.arm, feature.without),
                feature.operations[k].to_string(),
                digits(feature.nanoseconds[k] / of_complete_arm(&features, feature.arm, k)),
                short(feature.errors[k]),
            ]);
        }
        let (count, time) = (
            operations(&PumaWithoutWrist::OPERATIONS),
            times(&PumaWithoutWrist),
        );
        table.row([
            "PUMA 560: wrist, which is locked".to_owned(),
            count[k].to_string(),
            digits(time[k] / of_complete_arm(&features, "PUMA 560", k)),
            "another arm".to_owned(),
        ]);
        section.parts.push(Part::Table(table));
    }
    section
}

/// The time of a function of an arm from which nothing is left out, ns.
fn of_complete_arm(features: &[Feature], arm: &str, function: usize) -> f64 {
    let complete =
        (features.iter()).find(|feature| (feature.arm, feature.without) == (arm, "nothing"));
    complete.map_or(f64::NAN, |feature| feature.nanoseconds[function])
}
