//! The command's help texts.

use super::calls::{errors, output};

const SUBCOMMANDS: [&str; 12] = [
    "show",
    "check",
    "generate",
    "evaluate",
    "simulate",
    "inverse-dynamics",
    "reach",
    "measure",
    "convert",
    "lint",
    "page",
    "completions",
];

/// Each subcommand is listed, and has a text of its own with an example that starts as a call does.
#[test]
fn every_subcommand_has_help_with_an_example() {
    let help = output(&["--help"]);
    for subcommand in SUBCOMMANDS {
        assert!(help.contains(&format!("  {subcommand} ")), "{help}");
        let help = output(&[subcommand, "--help"]);
        let example = format!("  robot-dynamics {subcommand} ");
        assert!(
            help.contains("Example") && help.contains(&example),
            "{help}"
        );
    }
    let missing = errors(&[], 2);
    assert!(missing.contains("Usage: robot-dynamics"), "{missing}");
}

/// The completions of each shell know every subcommand, and the options of one.
#[test]
fn completions_know_all_subcommands() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = output(&["completions", shell]);
        for word in SUBCOMMANDS
            .into_iter()
            .chain(["round-angles", "against", "convention"])
        {
            assert!(script.contains(word), "{shell}: {word}");
        }
    }
    assert!(errors(&["completions", "cobol"], 2).contains("possible values"));
}
