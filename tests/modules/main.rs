//! The modules of each crate depend on each other one way.
//!
//! A file depends on another where it names something that is defined there: by a `use`, through any
//! number of re-exports, or by a path in the code. Tests do not count. A `mod.rs` and one child of
//! it may depend on each other, for a type and an algorithm on it often do. Nothing else may form a
//! circle.

mod circles;
mod documentation;
mod length;
mod names;
mod signatures;
mod source;

use std::fs;
use std::path::{Path, PathBuf};

use names::Names;
use source::Crate;

/// The folder of a crate's sources.
fn folder(name: &str) -> PathBuf {
    let repository = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    repository.join(name).join("src")
}

/// A crate of this repository: its library, its program, or both.
fn read(name: &str) -> Vec<Crate> {
    Crate::read_all(&folder(name))
}

/// The circles of a crate, each as the list of its files, but those of a parent and its child.
fn circles_of(sources: &Crate) -> Vec<Vec<String>> {
    let edges = Names::of(sources).edges();
    let path = |file: usize| sources.files[file].path.clone();
    let circles = circles::circles(&edges).into_iter();
    circles
        .map(|circle| circle.into_iter().map(path).collect())
        .filter(|circle: &Vec<String>| !is_parent_and_child(circle))
        .collect()
}

/// Whether these are `x/mod.rs` and a module that it declares, `x/y.rs` or `x/y/mod.rs`.
fn is_parent_and_child(circle: &[String]) -> bool {
    let [a, b] = circle else {
        return false;
    };
    let declares = |parent: &String, child: &String| {
        let child = child.strip_suffix("/mod.rs").unwrap_or(child);
        let folder = child.rsplit_once('/').map_or("", |(folder, _)| folder);
        *parent == format!("{folder}/mod.rs")
    };
    declares(a, b) || declares(b, a)
}

#[test]
fn modules_form_no_circles() {
    for name in [
        "dynamics-functions",
        "dynamics-symbolic",
        "dynamics-codegen",
        "dynamics-items",
        "dynamics-macros",
        "dynamics-runtime",
        "dynamics-numeric",
        "dynamics-simulation",
        "dynamics-export",
        "dynamics-evaluation",
        "dynamics-cli",
        "dynamics-python",
        "testkit",
        "testkit/arms",
        "testkit/interpreter",
        "testkit/tables",
        "benches/goals",
        "benches/rivals",
        "measurements/growth",
        "measurements/hard_cases",
        "measurements/scene",
        "measurements/speed_error",
    ] {
        for sources in read(name) {
            let circles = circles_of(&sources);
            assert!(circles.is_empty(), "{name}: {circles:#?}");
        }
    }
}

/// Words of a format of files.
const OF_FORMATS: [&str; 6] = ["urdf", "xacro", "mimic", "xml", "toml", "json"];

/// So that a further format is a reader alone.
#[test]
fn the_tree_of_links_knows_no_format() {
    let sources = &read("dynamics-codegen")[0];
    let path = |file: usize| sources.files[file].path.as_str();
    let is_of_links = |file: usize| path(file).starts_with("files/links/");
    let edges = Names::of(sources).edges();
    let used = edges.iter().filter(|(file, _)| is_of_links(*file));
    let used = used.map(|(file, on)| (path(*file), path(*on)));
    let files = (0..sources.files.len()).filter(|&file| is_of_links(file));
    let texts: Vec<_> = files
        .map(|file| {
            let text = fs::read_to_string(folder("dynamics-codegen").join(path(file)));
            (path(file), text.expect("a source").to_lowercase())
        })
        .collect();
    for word in OF_FORMATS {
        let used: Vec<_> = used.clone().filter(|(_, on)| on.contains(word)).collect();
        assert!(used.is_empty(), "{word}: {used:?}");
        let mut naming = texts.iter().filter(|(_, text)| text.contains(word));
        assert_eq!(naming.next().map(|(file, _)| file), None, "{word}");
    }
    let is_read = |(file, on): &(usize, usize)| path(*file).contains("urdf") && is_of_links(*on);
    assert!(texts.len() > 5 && edges.iter().any(is_read));
}

/// A longer function has more than one idea.
const LONGEST: usize = 100;

#[test]
fn functions_of_the_product_are_short() {
    let mut files = 0;
    for name in [
        "",
        "dynamics-functions",
        "dynamics-symbolic",
        "dynamics-codegen",
        "dynamics-items",
        "dynamics-macros",
        "dynamics-runtime",
        "dynamics-numeric",
        "dynamics-simulation",
        "dynamics-export",
        "dynamics-evaluation",
        "dynamics-cli",
        "dynamics-python",
    ] {
        for file in read(name).into_iter().flat_map(|sources| sources.files) {
            let text = fs::read_to_string(folder(name).join(&file.path)).expect("a source");
            let long = length::long_functions(&text, LONGEST);
            assert!(long.is_empty(), "{name}/src/{}: {long:?}", file.path);
            files += 1;
        }
    }
    assert!(files > 300, "{files} files");
}

#[test]
fn robots_at_run_time_show_nothing_of_the_engine() {
    let mut public = 0;
    for name in ["", "dynamics-evaluation"] {
        for file in read(name).into_iter().flat_map(|sources| sources.files) {
            let text = fs::read_to_string(folder(name).join(&file.path)).expect("a source");
            let open = signatures::open_items(&text);
            assert!(open.is_empty(), "{name}/src/{}: {open:#?}", file.path);
            public += text.matches("pub fn").count();
        }
    }
    assert!(public > 20, "{public} public functions");
}

/// Or the tests above would pass whatever the modules do.
#[test]
fn dependencies_are_seen() {
    let [runtime, numeric, sources] = [
        "dynamics-runtime",
        "dynamics-numeric",
        "dynamics-simulation",
    ]
    .map(|name| read(name).remove(0));
    let depends = |sources: &Crate, from: &str, on: &str| {
        let edges = Names::of(sources).edges();
        let file = |path: &str| sources.files.iter().position(|file| file.path == path);
        edges.contains(&(file(from).expect(from), file(on).expect(on)))
    };
    // By `use crate::taylor::SeriesStepper`, a re-export.
    assert!(depends(
        &sources,
        "simulation/taylor.rs",
        "taylor/stepper.rs"
    ));
    // By `use crate::Scalar`, a re-export of the root.
    assert!(depends(&runtime, "dual.rs", "scalar/mod.rs"));
    // By `sine::one(x)` in a function, where `sine` is a module.
    assert!(depends(&runtime, "batch/wide.rs", "sine/mod.rs"));
    // By `use super::NewtonEuler`, which the parent defines.
    assert!(depends(
        &numeric,
        "newton_euler/energy.rs",
        "newton_euler/mod.rs"
    ));
    // Its tests use the test problems, and tests do not count.
    assert!(
        sources
            .files
            .iter()
            .all(|file| !file.path.contains("test_problems"))
    );
    assert!(!depends(&runtime, "scalar/mod.rs", "taylor/products.rs"));
}
