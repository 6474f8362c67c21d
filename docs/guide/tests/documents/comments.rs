//! Comments of Rust files, and the help texts of the command, read like documents.

use pulldown_cmark::{Options, Parser};

use crate::prose::{Prose, words};
use crate::sentences::{LONGEST, is_headless};
use crate::{assert_none, files, root};

/// Folders of Rust files.
const FOLDERS: [&str; 24] = [
    "src",
    "examples",
    "dynamics-runtime",
    "dynamics-numeric",
    "dynamics-simulation",
    "dynamics-functions",
    "dynamics-items",
    "dynamics-macros",
    "dynamics-codegen",
    "dynamics-symbolic/src",
    "dynamics-symbolic/tests",
    "dynamics-export",
    "dynamics-evaluation",
    "dynamics-cli",
    "dynamics-python/src",
    "tests",
    "testkit",
    "measurements",
    "benches",
    "fuzz/src",
    "fuzz/fuzz_targets",
    "no_std/src",
    "docs/guide",
    "docs/pictures",
];

/// Folders of Rust files that the engine has written: tests of the engine hold their texts.
const WRITTEN: [&str; 2] = ["golden", "generated"];

/// Derivations: a formula counts as many words, so that sentences with formulas may be long there.
const DERIVATIONS: &str = "dynamics-symbolic/src";

/// Files in which every text between quotation marks is one of the command's help. The help of a single option is a comment.
const HELP: &str = "dynamics-cli/src/arguments";

/// The comments of a file: lines one below the other that begin with the same mark.
fn comments(source: &str) -> Vec<String> {
    let mut comments = Vec::new();
    let mut last = None;
    for line in source.lines().map(str::trim_start) {
        let mark = ["///", "//!", "//"]
            .into_iter()
            .find(|mark| line.starts_with(mark));
        if let Some(mark) = mark {
            if last != Some(mark) {
                comments.push(String::new());
            }
            let comment = comments.last_mut().expect("it has begun");
            comment.push_str(&line[mark.len()..]);
            comment.push('\n');
        }
        last = mark;
    }
    comments
}

/// The texts between quotation marks, of which none has one inside, with their lines as the reader sees them.
fn texts(source: &str) -> Vec<String> {
    let code = source
        .lines()
        .filter(|line| !line.trim_start().starts_with("//"));
    let code: String = code.flat_map(|line| [line, "\n"]).collect();
    let shown = |text: &str| {
        let pieces = text.split("\\\n").map(str::trim_start);
        pieces.collect::<String>().replace("\\n", "\n")
    };
    code.split('"').skip(1).step_by(2).map(shown).collect()
}

fn sentences(text: &str) -> Vec<String> {
    let mut prose = Prose::default();
    Parser::new_ext(text, Options::ENABLE_TABLES).for_each(|event| prose.hear(&event));
    prose.sentences
}

/// The mistake of a sentence that may have `longest` words, if it has one.
fn complaint(sentence: &str, longest: usize) -> Option<String> {
    let count = words(sentence);
    if is_headless(sentence) {
        Some(format!("begins without its noun: {sentence}"))
    } else {
        (count > longest).then(|| format!("{count} words: {sentence}"))
    }
}

#[test]
fn comments_and_help_texts_are_read_once() {
    let mut complaints = Vec::new();
    let mut count = [0; 2];
    for folder in FOLDERS {
        let longest = if folder == DERIVATIONS {
            usize::MAX
        } else {
            LONGEST
        };
        for path in files(&root().join(folder), "rs") {
            let source = std::fs::read_to_string(&path).expect("a text");
            let name = path.strip_prefix(root()).expect("below the root");
            if WRITTEN
                .iter()
                .any(|folder| name.iter().any(|part| part == *folder))
            {
                continue;
            }
            let comments = comments(&source);
            let texts = if name.starts_with(HELP) {
                texts(&source)
            } else {
                Vec::new()
            };
            count[0] += comments.len();
            count[1] += texts.len();
            for text in comments.iter().chain(&texts) {
                let found = sentences(text).into_iter();
                let found = found.filter_map(|sentence| complaint(&sentence, longest));
                complaints.extend(found.map(|found| format!("{}: {found}", name.display())));
            }
        }
    }
    assert_none(complaints);
    assert!(
        count[0] > 11_000 && count[1] > 150,
        "read too little: {count:?}"
    );
}

#[test]
fn sentences_of_comments_and_help_texts() {
    let source = "//! A file.\n\n/// One is right. Of two\n/// none is.\n// Those neither\nfn f() {} // What?\n/// ```\n/// \"What is code\"\n/// ```\n";
    let found: Vec<_> = comments(source)
        .iter()
        .flat_map(|text| sentences(text))
        .collect();
    let expected = [
        "A file.",
        "One is right.",
        "Of two none is.",
        "Those neither",
    ];
    assert_eq!(found, expected);
    let wrong: Vec<_> = found
        .iter()
        .map(|text| complaint(text, 3).is_some())
        .collect();
    assert_eq!(wrong, [false, false, true, true]);
    assert!(complaint("These are four words.", 3).is_some());
    let help = "// no \"text\"\n.help(\n    \"What is\\n\\n\\\n     said\",\n)";
    assert_eq!(texts(help), ["What is\n\nsaid"]);
}
