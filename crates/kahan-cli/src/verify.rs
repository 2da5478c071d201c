//! The `kahan` command as `cargo run` starts it: with no arguments it proves the paper.

use std::env::args_os;
use std::process::ExitCode;

fn main() -> ExitCode {
    let verify = (args_os().len() == 1).then(|| "verify".into());
    kahan_cli::run(args_os().chain(verify))
}
