//! Columns of numbers from files with names above them: results of `kahan sweep`, tables.

use std::env::consts::EXE_SUFFIX;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use kahan_study::number_file::Numbers;

use super::number_file::read;
use crate::printing::Refusal;

/// The program that runs sweeps and reads their results: beside this one, or where programs are.
pub(crate) fn sweeper() -> Command {
    let name = format!("kahan-sweep{EXE_SUFFIX}");
    let beside =
        std::env::current_exe().ok().map(|own| own.with_file_name(&name)).filter(|path| path.exists());
    Command::new(beside.unwrap_or_else(|| PathBuf::from(&name)))
}

/// Why that program did not start.
pub(crate) fn not_started(error: &io::Error) -> Refusal {
    Refusal::new(if error.kind() == io::ErrorKind::NotFound {
        "sweeps and their results are for the program kahan-sweep, which is not installed here; `cargo install --path \
         crates/kahan-sweep` in the source tree installs it"
            .to_owned()
    } else {
        format!("kahan-sweep does not run: {error}")
    })
}

/// The columns with these names; a folder stands for the result of the sweep that was written into
/// it, and `option` names the file in refusals.
pub(crate) fn columns(path: &Path, names: &[&str], option: &str) -> Result<Vec<Vec<f64>>, Refusal> {
    let merged = path.join("results.parquet");
    if path.is_dir() && !merged.exists() {
        let path = path.display();
        return Err(Refusal::new(format!(
            "{option}: there is no results.parquet in {path}; `kahan sweep PLAN.toml --out {path} --merge` joins what is there"
        )));
    }
    let path = if path.is_dir() { &merged } else { path };
    let shown = path.display().to_string();
    let numbers = match path.extension().and_then(|ending| ending.to_str()) {
        Some("parquet") => swept(path, names, option)?,
        Some("csv") => read(&shown, option)?,
        _ => {
            return Err(Refusal::new(format!(
                "{option}: {shown} is no result that can be read; it ends in .parquet or .csv, or is the folder of a sweep"
            )));
        }
    };
    let known = numbers.names.ok_or_else(|| {
        Refusal::new(format!("{option}: {shown} does not begin with a line of its columns' names"))
    })?;
    let places: Vec<usize> = names
        .iter()
        .map(|name| {
            known.iter().position(|known| known == name).ok_or_else(|| {
                let known = known.join(", ");
                Refusal::new(format!("{option}: {shown} has no column `{name}`; it has {known}"))
            })
        })
        .collect::<Result<_, _>>()?;
    let rows = || numbers.values.chunks_exact(known.len());
    Ok(places.into_iter().map(|place| rows().map(|row| row[place]).collect()).collect())
}

/// Columns of a file of Parquet, as kahan-sweep reads it.
fn swept(path: &Path, names: &[&str], option: &str) -> Result<Numbers, Refusal> {
    let mut program = sweeper();
    program.arg("--read").arg(path).arg("--columns").arg(names.join(","));
    let started = program.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn();
    let mut reader = started.map_err(|error| not_started(&error))?;
    let (mut rows, mut complaint) = (Vec::new(), String::new());
    let read = reader.stdout.take().map_or(Ok(0), |mut pipe| pipe.read_to_end(&mut rows));
    // What it cannot say is not more important than that it failed.
    let _ = reader.stderr.take().map(|mut words| words.read_to_string(&mut complaint));
    let refused = |why: &str| Refusal::new(format!("{option}: {}", why.trim()));
    match reader.wait() {
        Ok(status) if status.success() => {
            let numbers =
                read.map_err(|error| error.to_string()).and_then(|_| Numbers::of("rows.csv", &rows));
            numbers.map_err(|why| refused(&format!("{}: {why}", path.display())))
        }
        Ok(_) => Err(refused(complaint.trim_start_matches("error: "))),
        Err(error) => Err(refused(&error.to_string())),
    }
}
