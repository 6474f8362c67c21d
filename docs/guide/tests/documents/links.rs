//! Links to files and headings.

use std::path::{Path, PathBuf};

use crate::document::{Document, Library};
use crate::packages::repository;
use crate::{assert_none, documents, root};

/// Every file and heading that a document of the project links to is there. Addresses of other hosts are not asked for.
#[test]
fn links_lead_somewhere() {
    let mut library = Library::default();
    let mut dead = Vec::new();
    for path in documents(&root()) {
        let links = library.read(&path).links.clone();
        for link in links {
            if let Some(complaint) = complaint(&mut library, &path, &link) {
                dead.push(format!("{}: {link}: {complaint}", path.display()));
            }
        }
    }
    assert_none(dead);
}

/// The mistake of a link, if it has one.
fn complaint(library: &mut Library, path: &Path, link: &str) -> Option<&'static str> {
    // A file of the repository, where a registry has no other files.
    if let Some(file) = link.strip_prefix(&format!("{}/blob/main/", repository())) {
        return complaint(library, &root().join("README.md"), file);
    }
    // Another host, or an item of Rust, which rustdoc looks up.
    if link.contains(":/") || link.contains("::") || link.starts_with("mailto:") {
        return None;
    }
    let (file, anchor) = link.split_once('#').unwrap_or((link, ""));
    let target = match file {
        "" => path.to_owned(),
        file => path.with_file_name(file),
    };
    if !target.exists() {
        return Some("there is no such file");
    }
    let is_document = target
        .extension()
        .is_some_and(|extension| extension == "md");
    if anchor.is_empty() || !is_document {
        return None;
    }
    let anchors = &library.read(&target).anchors;
    let known = anchors.iter().any(|known| known == anchor);
    (!known).then_some("there is no such heading")
}

/// The pages of the book. mdBook leaves out all other documents.
fn pages() -> Vec<PathBuf> {
    let contents = root().join("docs/SUMMARY.md");
    let links = Document::read(&contents).links;
    let pages = links
        .iter()
        .map(|link| contents.with_file_name(link).canonicalize());
    pages.map(|page| page.expect("a page")).collect()
}

#[test]
fn every_chapter_is_a_page_of_the_book() {
    let pages = pages();
    let chapters = documents(&root().join("docs/guide/src")).into_iter();
    let missing = chapters.filter(|path| !pages.contains(&path.canonicalize().expect("a chapter")));
    assert_none(missing.map(|path| path.display().to_string()).collect());
}

/// A page of the book links to other pages, or to pictures and files that mdBook copies: those in `docs`.
#[test]
fn links_of_the_book_stay_in_it() {
    let (docs, pages) = (root().join("docs").canonicalize().expect("`docs`"), pages());
    let mut outside = Vec::new();
    for page in &pages {
        for link in Document::read(page).links {
            let file = link.split('#').next().unwrap_or_default();
            // A link that leads to no file is a complaint of `links_lead_somewhere`.
            let Ok(target) = page.with_file_name(file).canonicalize() else {
                continue;
            };
            let is_document = target.extension().is_some_and(|end| end == "md");
            let is_there = target.starts_with(&docs) && (!is_document || pages.contains(&target));
            if !file.is_empty() && !is_there {
                outside.push(format!("{}: {link}", page.display()));
            }
        }
    }
    assert_none(outside);
}

#[test]
fn a_dead_link_is_found() {
    let notation = root().join("docs/NOTATION.md");
    let mut library = Library::default();
    let mut complaint = |link: &str| complaint(&mut library, &notation, link);
    let of_repository = |file: &str| format!("{}/blob/main/{file}", repository());
    assert_eq!(complaint(&of_repository("docs/NOTATION.md")), None);
    assert!(complaint(&of_repository("NOTATION.md")).is_some());
    assert_eq!(complaint("ACCURACY.md#functions"), None);
    assert_eq!(complaint("#equation-of-motion"), None);
    assert_eq!(complaint("https://example.org/nothing.md"), None);
    assert_eq!(complaint("accuracies.md"), Some("there is no such file"));
    assert_eq!(
        complaint("ACCURACY.md#function"),
        Some("there is no such heading")
    );
}
