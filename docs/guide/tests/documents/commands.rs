//! Commands that documents tell their readers to type.

use std::path::Path;

use crate::document::Document;
use crate::{assert_none, documents, root};

/// Every example and package that a `cargo` command of a document names is there.
#[test]
fn cargo_commands_name_what_exists() {
    let root = root();
    let mut unknown = Vec::new();
    for path in documents(&root) {
        for (_, block) in Document::read(&path).blocks {
            let lines = block.lines().filter(|line| line.contains("cargo "));
            unknown.extend(
                lines
                    .filter_map(|line| nothing_of_that_name(&root, line))
                    .map(|complaint| format!("{}: {complaint}", path.display())),
            );
        }
    }
    assert_none(unknown);
}

/// The first thing that a command names and that does not exist.
fn nothing_of_that_name(root: &Path, command: &str) -> Option<String> {
    let words: Vec<&str> = command.split_whitespace().collect();
    let after = |option: &str| {
        let place = words.iter().position(|word| *word == option)?;
        words.get(place + 1).copied()
    };
    let package = after("-p");
    if let Some(package) = package.filter(|package| !is_package(root, package)) {
        return Some(format!("{command}: no package {package}"));
    }
    // An example of the facade; other packages have theirs in folders of their own.
    let example = after("--example").filter(|_| package.is_none())?;
    let file = root.join(format!("examples/{example}.rs"));
    (!file.exists()).then(|| format!("{command}: no example {example}"))
}

/// Whether a package of the workspace has this name: it is that of its folder.
fn is_package(root: &Path, name: &str) -> bool {
    let folders = ["", "docs", "measurements", "testkit", "tests"];
    let manifests = folders.map(|folder| root.join(folder).join(name).join("Cargo.toml"));
    name == "robot-dynamics" || manifests.iter().any(|manifest| manifest.exists())
}
