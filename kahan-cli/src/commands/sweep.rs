//! `kahan sweep`: hands its arguments to the program `kahan-sweep`, which is installed apart.

use std::env::consts::EXE_SUFFIX;
use std::ffi::OsString;
use std::io::ErrorKind;
use std::path::PathBuf;
use std::process::Command;

use clap::Args;

use crate::printing::{Answer, Refusal};

/// Runs a plan of many orbits, on one machine or many; the program kahan-sweep does it.
///
/// A plan in TOML says which field, which starts, parameters and eps, what to observe, what to write.
/// The result is one file of Parquet, whose bytes depend on the plan alone. kahan-sweep is a program
/// of its own, so that its libraries weigh on nobody else: `cargo install --path kahan-sweep`. What
/// stands behind `sweep` is handed on to it, and `kahan-sweep --help` says what that may be.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Sweep {
    /// The plan, and options of kahan-sweep.
    #[arg(value_name = "ARGUMENTS", trailing_var_arg = true, allow_hyphen_values = true)]
    arguments: Vec<OsString>,
}

const EXAMPLES: &str = "\
Examples:
  kahan sweep plan.toml --dry-run
  kahan sweep plan.toml --out results
  kahan sweep plan.toml --out results --shard 3/10";

impl Sweep {
    /// The exit status of kahan-sweep.
    pub(crate) fn run(&self) -> Result<Answer, Refusal> {
        let name = format!("kahan-sweep{EXE_SUFFIX}");
        let beside =
            std::env::current_exe().ok().map(|own| own.with_file_name(&name)).filter(|path| path.exists());
        let program = beside.unwrap_or_else(|| PathBuf::from(&name));
        match Command::new(&program).args(&self.arguments).status() {
            // It has said all there is to say.
            Ok(status) => std::process::exit(status.code().unwrap_or(1)),
            Err(error) if error.kind() == ErrorKind::NotFound => Err(Refusal::new(
                "sweeps are run by the program kahan-sweep, which is not installed here; `cargo install --path kahan-sweep` in the \
                 source tree installs it",
            )),
            Err(error) => Err(Refusal::new(format!("{} does not run: {error}", program.display()))),
        }
    }
}
