//! `kahan sweep`: runs the separate program `kahan-sweep`.

use std::ffi::OsString;

use clap::Args;

use crate::printing::{Answer, Refusal};
use crate::reading::{not_started, sweeper};

/// Runs a plan of many orbits, on one machine or many: the program kahan-sweep does it.
///
/// A plan in TOML says which field, which starts, parameters and eps, what to observe, what to
/// write. The result is one file of Parquet, whose bytes depend on the plan alone. kahan-sweep is a
/// program of its own, so that its libraries weigh on nobody else: `cargo install --profile sweep
/// --path crates/kahan-sweep` installs it. What stands behind `sweep` is handed on to it, and
/// `kahan-sweep --help` says what that may be.
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  kahan sweep plan.toml --dry-run
  kahan sweep plan.toml --out results
  kahan sweep plan.toml --out results --shard 3/10")]
pub(crate) struct Sweep {
    /// The plan, and options of kahan-sweep.
    #[arg(value_name = "ARGUMENTS", trailing_var_arg = true, allow_hyphen_values = true)]
    arguments: Vec<OsString>,
}

impl Sweep {
    pub(crate) fn run(&self) -> Result<Answer, Refusal> {
        match sweeper().args(&self.arguments).status() {
            Ok(status) => {
                Ok(Answer::silent(status.code().and_then(|code| u8::try_from(code).ok()).unwrap_or(1)))
            }
            Err(error) => Err(not_started(&error)),
        }
    }
}
