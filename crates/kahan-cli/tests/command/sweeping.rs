//! Tests that `kahan sweep` passes its arguments to another program.

use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::{Command, Output};

use crate::running::text;

/// Runs the command from the folder `programs`. A link is preferred to a copy, because Linux may
/// refuse to run a file that was just written.
fn sweep(programs: &Path, arguments: &[&str]) -> Output {
    let copy = programs.join("kahan");
    let command = env!("CARGO_BIN_EXE_kahan");
    fs::hard_link(command, &copy)
        .or_else(|_| fs::copy(command, &copy).map(drop))
        .expect("the command in the folder");
    Command::new(copy).arg("sweep").args(arguments).env("PATH", programs).output().expect("the command runs")
}

#[test]
fn arguments_and_the_exit_status_are_handed_on() {
    let folder = tempfile::tempdir().expect("a folder");
    let program = folder.path().join("kahan-sweep");
    fs::write(&program, "#!/bin/sh\necho \"$@\"\nexit 7\n").expect("a program");
    fs::set_permissions(&program, fs::Permissions::from_mode(0o755)).expect("permissions");
    let output = sweep(folder.path(), &["plan.toml", "--out", "my results", "--shard", "1/2", "--json"]);
    assert_eq!(text(&output.stdout), "plan.toml --out my results --shard 1/2 --json\n");
    assert_eq!(output.status.code(), Some(7));
}

#[test]
fn where_it_is_not_installed_it_is_said_how() {
    let folder = tempfile::tempdir().expect("a folder");
    let output = sweep(folder.path(), &["plan.toml"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("cargo install --profile sweep --path crates/kahan-sweep"));
}
