//! Named columns of numbers from files: results of `kahan sweep`, and tables.

use std::env::consts::EXE_SUFFIX;
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;

use kahan_study::number_file::Numbers;

use super::points::read;
use crate::printing::UsageError;

/// Returns the program `kahan-sweep`, from the folder of this program or from the search path.
pub(crate) fn sweeper() -> Command {
    let name = format!("kahan-sweep{EXE_SUFFIX}");
    let beside =
        std::env::current_exe().ok().map(|own| own.with_file_name(&name)).filter(|path| path.exists());
    Command::new(beside.unwrap_or_else(|| PathBuf::from(&name)))
}

pub(crate) fn not_started(error: &io::Error) -> UsageError {
    UsageError::new(if error.kind() == io::ErrorKind::NotFound {
        "sweeps and their results are for the program kahan-sweep, which is not installed here; `cargo install \
         --profile sweep --path crates/kahan-sweep` in the source tree installs it"
            .to_owned()
    } else {
        format!("kahan-sweep does not run: {error}")
    })
}

/// Reads columns by name from a file, or from the sweep result in a folder. Errors name `option`.
pub(crate) fn columns(path: &Path, names: &[&str], option: &str) -> Result<Vec<Vec<f64>>, UsageError> {
    let merged = path.join("results.parquet");
    if path.is_dir() && !merged.exists() {
        let path = path.display();
        return Err(UsageError::new(format!(
            "{option}: there is no results.parquet in {path}; `kahan sweep PLAN.toml --out {path} --merge` joins what is there"
        )));
    }
    let path = if path.is_dir() { &merged } else { path };
    let shown = path.display().to_string();
    let numbers = match path.extension().and_then(|ending| ending.to_str()) {
        Some("parquet") => read_results(path, names, option)?,
        Some("csv") => read(&shown, option)?,
        _ => {
            return Err(UsageError::new(format!(
                "{option}: {shown} is no result that can be read; it ends in .parquet or .csv, or is the folder of a sweep"
            )));
        }
    };
    let known = numbers.names.ok_or_else(|| {
        UsageError::new(format!("{option}: {shown} does not begin with a line of its columns' names"))
    })?;
    let column = |name: &&str| {
        let place = known.iter().position(|known| known == name).ok_or_else(|| {
            let known = known.join(", ");
            UsageError::new(format!("{option}: {shown} has no column `{name}`; it has {known}"))
        })?;
        Ok(numbers.values.iter().skip(place).step_by(known.len()).copied().collect())
    };
    names.iter().map(column).collect()
}

fn read_results(path: &Path, names: &[&str], option: &str) -> Result<Numbers, UsageError> {
    let mut program = sweeper();
    program.arg("--read").arg(path).arg("--columns").arg(names.join(","));
    let read = program.output().map_err(|error| not_started(&error))?;
    if !read.status.success() {
        let complaint = String::from_utf8_lossy(&read.stderr);
        let why = complaint.trim_start_matches("error: ").trim();
        return Err(UsageError::new(format!("{option}: {why}")));
    }
    let numbers = Numbers::of("rows.csv", &read.stdout);
    numbers.map_err(|why| UsageError::new(format!("{option}: {}: {why}", path.display())))
}
