//! The page in the repository, and how tables are read.

use std::fs;

use crate::appendix::{Appendices, Appendix};
use crate::chart::{Chart, Series};
use crate::{files, root};

#[test]
fn the_page_is_what_its_tables_make() {
    let root = root();
    for (path, text) in files(&Appendices::read(&root)) {
        let there = fs::read_to_string(root.join(&path)).unwrap_or_default();
        assert!(there == text, "{path}: run `cargo run -p performance`");
    }
}

const DOCUMENT: &str = "\
# Title

`benches/some.sh` measures it.

<!-- times -->
A processor; a compiler; a day.

### arm

| function | by | ns |
|---|--:|--:|
| torque | here | 2.5 |
| torque | there |  |

## Others

| a |
|---|
| b |
<!-- end -->

| not | measured |
";

#[test]
fn regions_are_read() {
    let appendix = Appendix::new("some.md", DOCUMENT.to_owned());
    assert_eq!(appendix.command(), "benches/some.sh");
    let region = appendix.region("times");
    assert_eq!(region.conditions, "A processor; a compiler; a day");
    assert_eq!(region.table().rows.len(), 2);
    let arm = region.below("arm");
    assert_eq!(arm.number(&["torque", "here"], "ns"), Some(2.5));
    assert_eq!(arm.number(&["torque", "there"], "ns"), None);
    assert_eq!(arm.firsts(), ["torque"]);
    assert_eq!(region.below("Others").cells("a"), ["b"]);
}

#[test]
#[should_panic = "some.md has no `errors`"]
fn a_region_is_not_missed() {
    Appendix::new("some.md", DOCUMENT.to_owned()).region("errors");
}

#[test]
#[should_panic = "no column `us`"]
fn a_column_is_not_missed() {
    let appendix = Appendix::new("some.md", DOCUMENT.to_owned());
    appendix.region("times").table().cells("us");
}

/// Where the marks are, from the left.
fn positions(svg: &str) -> Vec<f64> {
    let places = svg.split("translate(").skip(1);
    let places = places.map(|text| text.split(' ').next().unwrap_or_default());
    places.map(|x| x.parse().expect("a number")).collect()
}

#[test]
fn marks_stand_where_their_values_are() {
    let chart = Chart {
        file: "some",
        title: "Times < others: ns",
        rows: vec!["a".to_owned(), "b".to_owned()],
        series: vec![
            Series {
                name: "here",
                mark: 0,
                values: vec![Some(1.0), Some(10.0)],
            },
            Series {
                name: "there",
                mark: 1,
                values: vec![Some(100.0), None],
            },
        ],
    };
    let svg = chart.svg();
    // Two marks of the legend, then those of the first row and of the second.
    let [_, _, one, hundred, ten] = positions(&svg)[..] else {
        panic!("{svg}");
    };
    assert!(
        (ten - 0.5 * (one + hundred)).abs() < 0.11,
        "{one} {ten} {hundred}"
    );
    assert!(svg.contains("Times &lt; others") && svg.contains("prefers-color-scheme:dark"));
}
