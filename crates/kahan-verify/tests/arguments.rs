//! Tests of the program's arguments; `crates/kahan-paper/tests` covers the proofs.

use std::process::{Command, Output};

fn run(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_kahan-verify")).args(arguments).output().expect("the program starts")
}

fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).expect("UTF-8")
}

#[test]
fn other_arguments_are_answered_by_the_call_of_the_command() {
    for (arguments, call) in [
        (&["atlas", "--out", "atlas"][..], "atlas --out atlas"),
        (&["orbit", "--field", "xdot = x - x^2;"], "orbit --field 'xdot = x - x^2;'"),
        (&["verify", "--all"], "verify --all"),
        (&["--system", "e6"], "verify --system e6"),
        (&["--all", "--json"], "verify --all --json"),
        (&["show", "it's", ""], r"show 'it'\''s' ''"),
    ] {
        let output = run(arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(output.stdout.is_empty());
        let message = text(&output.stderr);
        assert!(
            message.contains(&format!("\n    cargo run --release -p kahan-cli -- {call}\n")),
            "{message}"
        );
        assert!(message.contains(&format!("`kahan {call}`")), "{message}");
    }
}

#[test]
fn help_shows_the_one_option() {
    let output = run(&["--help"]);
    assert!(output.status.success());
    let help = text(&output.stdout);
    assert!(help.contains("kahan-verify [--all]"), "{help}");
    assert!(help.lines().all(|line| line.chars().count() <= 100), "{help}");
}
