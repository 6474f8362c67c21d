//! Entries of packages that registries show.

use std::fs::read_to_string;
use std::path::PathBuf;

use crate::document::Document;
use crate::{assert_none, files, root};

/// The text of a file of the project.
fn text(file: &str) -> String {
    read_to_string(root().join(file)).expect(file)
}

/// The value of a key in a manifest.
fn value<'t>(manifest: &'t str, key: &str) -> Option<&'t str> {
    let of_key = |line: &'t str| line.strip_prefix(key)?.strip_prefix(" = ");
    Some(manifest.lines().find_map(of_key)?.trim_matches('"'))
}

/// The address of the project, which one line says.
pub(crate) fn repository() -> String {
    let manifest = text("Cargo.toml");
    value(&manifest, "repository")
        .expect("an address")
        .to_owned()
}

/// The manifests of packages that are published.
fn published() -> Vec<PathBuf> {
    let manifests = files(&root(), "toml").into_iter();
    let is_published = |path: &PathBuf| {
        let text = read_to_string(path).expect("a manifest");
        text.contains("[package]") && !text.contains("publish = false")
    };
    let manifests = manifests.filter(|path| path.ends_with("Cargo.toml"));
    manifests.filter(is_published).collect()
}

#[test]
fn every_package_says_what_registries_show() {
    let keys = ["description", "documentation", "categories", "readme"];
    let inherited = [
        "version",
        "authors",
        "license",
        "repository",
        "keywords",
        "rust-version",
    ];
    let mut missing = Vec::new();
    let manifests = published();
    assert!(manifests.len() > 10, "{manifests:?}");
    for path in manifests {
        let manifest = read_to_string(&path).expect("a manifest");
        let own = keys
            .iter()
            .filter(|key| !manifest.contains(&format!("\n{key}")));
        let lines = inherited.map(|key| format!("{key}.workspace = true"));
        let lines = lines
            .iter()
            .map(String::as_str)
            .filter(|line| !manifest.contains(line));
        missing.extend(
            own.copied()
                .chain(lines)
                .map(|key| format!("{}: {key}", path.display())),
        );
    }
    assert_none(missing);
}

/// The registry of Python packages knows no files beside the README.
#[test]
fn the_python_package_links_to_the_repository() {
    let manifest = text("dynamics-python/pyproject.toml");
    assert_eq!(value(&manifest, "Repository"), Some(repository().as_str()));
    let links = Document::read(&root().join("dynamics-python/README.md")).links;
    let relative = links.into_iter().filter(|link| !link.contains(":/"));
    assert_none(relative.collect());
}
