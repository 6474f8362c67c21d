//! The modules of each crate depend on each other one way.
//!
//! A file depends on another where it names something that is defined there: by a `use`, through any
//! number of re-exports, or by a path in the code. Tests do not count. A `mod.rs` and one child of
//! it may depend on each other, for a type and an algorithm on it often do. Nothing else may form a
//! circle.

mod circles;
mod names;
mod source;

use std::path::Path;

use names::Names;
use source::Crate;

/// The circles of a crate, each as the list of its files, but those of a parent and its child.
fn circles_of(name: &str) -> Vec<Vec<String>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(name).join("src");
    let sources = Crate::read(&folder);
    let edges = Names::of(&sources).edges();
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
fn the_runtime_has_no_circles() {
    let circles = circles_of("dynamics-runtime");
    assert!(circles.is_empty(), "{circles:#?}");
}

#[test]
fn show() {
    for name in ["dynamics-runtime", "dynamics-symbolic", "dynamics-codegen"] {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(name).join("src");
        let sources = Crate::read(&folder);
        println!("{name} {:#?}", circles_of(name));
        if std::env::var("EDGES").is_ok() {
            for (a, b) in Names::of(&sources).edges() {
                println!("{} -> {}", sources.files[a].path, sources.files[b].path);
            }
        }
    }
}
