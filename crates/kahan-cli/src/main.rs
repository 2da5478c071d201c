//! The program `kahan`.

use std::process::ExitCode;

fn main() -> ExitCode {
    kahan_cli::run(std::env::args_os())
}
