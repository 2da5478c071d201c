//! Runs the command as a user does.

use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;

/// A field whose reduced map has too many terms to be written out.
pub(crate) const BEYOND_THE_BUDGET: &str = "
    adot = (a + b + c + d + e)*(a*2 + 1); bdot = (a + b + c + d + e)*(b*2 + 1);
    cdot = (a + b + c + d + e)*(c*2 + 1); ddot = (a + b + c + d + e)*(d*2 + 1);
    edot = (a + b + c + d + e)*(e*2 + 1);";

pub(crate) fn kahan(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_kahan")).args(arguments).output().expect("the command runs")
}

/// Runs `line` in a shell with `folder` as the current folder. The line begins with `kahan`.
#[cfg(unix)]
pub(crate) fn shell(line: &str, folder: &Path) -> Output {
    let arguments = line.strip_prefix("kahan ").expect("a command");
    let mut shell = Command::new("sh");
    shell.args(["-c", &format!("\"$KAHAN\" {arguments}")]);
    shell.env("KAHAN", env!("CARGO_BIN_EXE_kahan")).current_dir(folder).output().expect("a shell")
}

pub(crate) fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("UTF-8")
}

/// Returns the standard output of a run that succeeds.
pub(crate) fn answer(arguments: &[&str]) -> String {
    let output = kahan(arguments);
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {said}");
    let is_note = |line: &str| line.starts_with("note: ") && line.contains(": nothing defines ");
    assert!(said.lines().count() <= 1 && said.lines().all(is_note), "{arguments:?}: {said}");
    text(&output.stdout)
}

pub(crate) fn object(arguments: &[&str]) -> Value {
    serde_json::from_str(&answer(arguments)).expect("one JSON object")
}

pub(crate) fn refusal(arguments: &[&str]) -> String {
    let output = kahan(arguments);
    let paragraph = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {paragraph}");
    assert!(output.stdout.is_empty(), "{arguments:?} printed something");
    assert!(paragraph.starts_with("error: ") && paragraph.ends_with('\n'), "{paragraph}");
    assert!(!paragraph.contains("\n\n"), "more than one paragraph: {paragraph}");
    paragraph
}

/// Runs the examples of a command's help in a folder. Returns their number.
#[cfg(unix)]
pub(crate) fn examples_run(command: &str, folder: &Path) -> usize {
    let help = answer(&[command, "--help"]);
    let (_, examples) = help.split_once("Examples:\n").expect("the help has examples");
    let mut run = 0;
    for example in
        examples.lines().map(str::trim).take_while(|line| !line.is_empty() && !line.starts_with('`'))
    {
        let output = shell(example, folder);
        assert_eq!(output.status.code(), Some(0), "{example}: {}", text(&output.stderr));
        run += 1;
    }
    run
}
