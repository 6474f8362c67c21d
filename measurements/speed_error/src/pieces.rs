//! What each piece of a model costs, and what leaving it out does.

use measuring::table::{Table, nanoseconds, short};
use scene::arms::PumaWithoutWrist;
use scene::features::features;
use scene::measure::{operations, times};
use testkit::five::NAMES;

use crate::page::{Part, Section};

pub(crate) fn section() -> Section {
    let mut section = Section::new("What each piece costs");
    section.text(
        "For each function its operations (multiplications, additions and divisions; sines apart), ns of \
         a call, and the error made: the largest difference from the complete arm's value at 500 \
         random states (joints anywhere, up to 3 rad/s and 10 rad/s^2), over the largest value there. \
         What is below a share of the largest value is left out of the Lagrangian (`neglect:`), a \
         locked wrist makes an arm of three joints (`lock:`).",
    );
    let features = features();
    for (k, function) in NAMES.iter().enumerate() {
        let heads = ["without", "operations", "ns", "error"];
        let mut table = Table::new(*function, &heads);
        for feature in &features {
            table.row([
                format!("{}: {}", feature.arm, feature.without),
                feature.operations[k].to_string(),
                nanoseconds(feature.nanoseconds[k]),
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
            nanoseconds(time[k]),
            "another arm".to_owned(),
        ]);
        section.parts.push(Part::Table(table));
    }
    section
}
