//! The command `kahan sweep`, which runs the separate program `kahan-sweep`.

use std::ffi::OsString;

use clap::Args;

use crate::printing::{Answer, UsageError};
use crate::reading::{not_started, sweeper};

/// Runs a plan of many orbits, on one machine or many: calls the program kahan-sweep.
///
/// A plan is a TOML file that specifies the field, the initial points, parameters and eps, the
/// observables, and the output. The result is one Parquet file; its bytes depend on the plan alone.
/// kahan-sweep is a separate program, so that its large libraries are needed only by those who use
/// it. Install it by `cargo install --profile sweep --path crates/kahan-sweep`. All arguments after
/// `sweep` are passed on to it, and `kahan-sweep --help` lists them.
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  kahan sweep plan.toml --dry-run
  kahan sweep plan.toml --out results
  kahan sweep plan.toml --out results --shard 3/10")]
pub(crate) struct Sweep {
    /// The plan and the options of kahan-sweep.
    #[arg(value_name = "ARGUMENTS", trailing_var_arg = true, allow_hyphen_values = true)]
    arguments: Vec<OsString>,
}

impl Sweep {
    pub(crate) fn run(&self) -> Result<Answer, UsageError> {
        match sweeper().args(&self.arguments).status() {
            Ok(status) => {
                Ok(Answer::silent(status.code().and_then(|code| u8::try_from(code).ok()).unwrap_or(1)))
            }
            Err(error) => Err(not_started(&error)),
        }
    }
}
