//! The command's help texts.

use super::calls::{assert_has, errors, output, refused};

const SUBCOMMANDS: &str = "show check generate evaluate simulate inverse-dynamics reach measure convert lint page completions";

/// Each subcommand is listed, and has a text of its own with an example that starts as a call does.
#[test]
fn every_subcommand_has_help_with_an_example() {
    let help = output(&["--help"]);
    for subcommand in SUBCOMMANDS.split(' ') {
        assert!(help.contains(&format!("  {subcommand} ")), "{help}");
        let help = output(format!("{subcommand} --help"));
        let example = format!("  robot-dynamics {subcommand} ");
        assert_has(&help, ["Example", &example]);
    }
    refused("", 2, ["Usage: robot-dynamics"]);
}

/// The completions of each shell know every subcommand, and the options of one.
#[test]
fn completions_know_all_subcommands() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = output(&["completions", shell]);
        for word in SUBCOMMANDS
            .split(' ')
            .chain(["round-angles", "against", "convention"])
        {
            assert!(script.contains(word), "{shell}: {word}");
        }
    }
    assert!(errors(&["completions", "cobol"], 2).contains("possible values"));
}
