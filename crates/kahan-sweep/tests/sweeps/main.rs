//! Tests that results do not depend on shards and interruptions, and that wrong parts are refused.

mod plans;
mod rows;
mod running;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const PLAN: &str = r#"
seed = 3
draws = 40

[subject]
name = "euler"
[subject.params]
a1 = 1
a2 = -3

[question]
ask = "observe"
steps = 50
observe = ["final", "drift", "extrema", "lyapunov", "spectrum", "log_det", "fli", "megno", "sali", "rotation", "escape", "passed_poles"]
[question.over]
x = { draw = "sobol", low = 0.1, high = 1 }
y = { draw = "uniform", low = 0.1, high = 1 }
z = "1/2"
a3 = [1, 2]
eps = "0.01:0.05:5"
order = [2, 4]
scalar = ["f64", "f32"]

[output]
rows_per_part = 97
"#;

fn sweep(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_kahan-sweep"));
    command.arg("plan.toml").args(arguments).current_dir(folder).output().expect("the command runs")
}

fn done(folder: &Path, arguments: &[&str]) -> String {
    let output = sweep(folder, arguments);
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {}", text(&output.stderr));
    text(&output.stdout)
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("UTF-8")
}

fn folder(plan: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("plan.toml"), plan).expect("the plan");
    folder
}

/// Returns the merged file of a run that was not interrupted.
fn undisturbed(plan: &str) -> Vec<u8> {
    let folder = folder(plan);
    done(folder.path(), &["--out", "results"]);
    fs::read(folder.path().join("results/results.parquet")).expect("the results")
}

fn parts(results: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(results).expect("the folder").map(|entry| entry.expect("an entry").path());
    let mut parts: Vec<PathBuf> = entries.filter(|path| path.to_string_lossy().contains("part-")).collect();
    parts.sort();
    parts
}
