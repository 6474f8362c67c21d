//! Sentences that are read once: short ones, which begin with their noun.

use std::path::PathBuf;

use crate::document::Document;
use crate::prose::words;
use crate::{assert_none, documents, root};

/// The most words of a sentence.
pub(crate) const LONGEST: usize = 40;

/// The most words of a sentence in the mean over a document.
const MEAN: f64 = 16.0;

/// The most words of prose in a document.
const MOST: [(&str, usize); 2] = [("README.md", 600), ("docs/PERFORMANCE.md", 1_000)];

/// The most words of prose in all documents for users.
const ALL: usize = 18_000;

/// Beginnings of a sentence whose noun comes late or never.
const HEADLESS: [&str; 4] = ["What ", "Those ", "That of ", "Of "];

/// Documents for users beside the guide; `ERRATA.md` is about other people's books.
const REFERENCE: [&str; 8] = [
    "README.md",
    "src/robot_dynamics.md",
    "docs/README.md",
    "docs/NOTATION.md",
    "docs/TRUST.md",
    "docs/ACCURACY.md",
    "docs/PERFORMANCE.md",
    "docs/PAGE.md",
];

/// All documents for users, with their paths: reference and guide.
fn for_users() -> Vec<(String, Document)> {
    let mut paths: Vec<PathBuf> = REFERENCE.iter().map(|path| root().join(path)).collect();
    paths.extend(documents(&root().join("docs/guide/src")));
    let named = paths.into_iter().map(|path| {
        let name = path.strip_prefix(root()).expect("below the root");
        (name.display().to_string(), Document::read(&path))
    });
    named.collect()
}

/// Whether a sentence begins without its noun. A question may begin with "What".
pub(crate) fn is_headless(sentence: &str) -> bool {
    !sentence.ends_with('?') && HEADLESS.iter().any(|word| sentence.starts_with(word))
}

#[test]
fn sentences_are_short() {
    let mut complaints = Vec::new();
    for (name, document) in for_users() {
        let lengths = document.sentences.iter().map(|sentence| words(sentence));
        let mean = lengths.clone().sum::<usize>() as f64 / lengths.len().max(1) as f64;
        if mean > MEAN {
            complaints.push(format!("{name}: {mean:.1} words in the mean"));
        }
        for sentence in &document.sentences {
            let count = words(sentence);
            if count > LONGEST {
                complaints.push(format!("{name}: {count} words: {sentence}"));
            }
        }
    }
    assert_none(complaints);
}

#[test]
fn sentences_begin_with_their_noun() {
    let mut complaints = Vec::new();
    for (name, document) in for_users() {
        for sentence in &document.sentences {
            if is_headless(sentence) {
                complaints.push(format!("{name}: {sentence}"));
            }
        }
    }
    assert_none(complaints);
}

#[test]
fn documents_are_short() {
    let counts: Vec<(String, usize)> = for_users()
        .into_iter()
        .map(|(name, document)| {
            let counts = document.sentences.iter().map(|sentence| words(sentence));
            (name, counts.sum())
        })
        .collect();
    let sum: usize = counts.iter().map(|(_, count)| count).sum();
    for (document, most) in MOST {
        let count = counts.iter().find(|(name, _)| name == document);
        let count = count.expect("a document for users").1;
        assert!(count <= most, "{document}: {count} words of prose");
    }
    assert!(sum <= ALL, "{sum} words of prose: {counts:#?}");
}
