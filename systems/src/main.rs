//! The `kahan` command: proves the catalog, shows systems, and evaluates them.

mod cli;

use std::process::ExitCode;

fn main() -> ExitCode {
    cli::run(std::env::args_os())
}
