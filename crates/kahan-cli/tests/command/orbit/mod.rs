//! Tests `kahan orbit`: numbers against known orbits and generated maps, files, and refusals.

mod chains;
mod files;
mod json;
mod manners;
mod order;
mod poles;
mod scalars;
mod starts;

use std::fs;
use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::Duration;

use kahan_core::prelude::*;
use kahan_systems::{E6, E7, E9, EulerTop, LotkaVolterra};
use serde_json::{Value, json};
use tempfile::TempDir;

use crate::running::{examples_run, text};

fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_kahan"));
    command.arg("orbit").args(arguments);
    command
}

fn kahan(arguments: &[&str]) -> Output {
    command(arguments).output().expect("the command runs")
}

/// Returns the standard output of a run that prints nothing to standard error.
fn answer(arguments: &[&str]) -> String {
    let output = kahan(arguments);
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {}", text(&output.stderr));
    assert!(output.stderr.is_empty(), "{arguments:?}: {}", text(&output.stderr));
    text(&output.stdout)
}

fn table(csv: &str) -> (Vec<String>, Vec<Vec<String>>) {
    assert!(csv.ends_with('\n'), "{csv}");
    let mut lines = csv.lines().map(|line| line.split(',').map(str::to_owned).collect::<Vec<_>>());
    let names = lines.next().expect("a line of names");
    let rows: Vec<_> = lines.collect();
    assert!(rows.iter().all(|row| row.len() == names.len()), "{csv}");
    (names, rows)
}

fn folder() -> TempDir {
    tempfile::tempdir_in(env!("CARGO_TARGET_TMPDIR")).expect("a folder")
}

fn contents(folder: &TempDir) -> Vec<String> {
    let entries = fs::read_dir(folder.path()).expect("the folder can be read");
    let name = |entry: fs::DirEntry| entry.file_name().into_string().expect("UTF-8");
    let mut names: Vec<String> = entries.map(|entry| name(entry.expect("an entry"))).collect();
    names.sort();
    names
}

fn path_text(path: &Path) -> &str {
    path.to_str().expect("UTF-8")
}

const ALL: [&str; 11] = ["euler", "lv", "e1", "e2", "e3", "e4", "e5", "e6", "e7", "e8", "e9"];

/// Returns the test vectors of a system, which were computed independently.
fn vectors(system: &str) -> Value {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(format!("../../tests/data/{system}.json"));
    serde_json::from_str(&fs::read_to_string(path).expect("the vectors are there")).expect("JSON")
}

fn exact(value: &Value) -> String {
    let text = value.as_str().expect("a string");
    text.strip_suffix("/1").unwrap_or(text).to_owned()
}

fn point(values: &Value) -> String {
    values.as_array().expect("a list").iter().map(exact).collect::<Vec<_>>().join(",")
}

fn parameters(values: &Value) -> Vec<String> {
    let values = values.as_object().expect("an object");
    values
        .iter()
        .flat_map(|(name, value)| ["--param".to_owned(), format!("{name}={}", exact(value))])
        .collect()
}

fn with<'a>(arguments: &[&'a str], more: &'a [String]) -> Vec<&'a str> {
    arguments.iter().copied().chain(more.iter().map(String::as_str)).collect()
}
