//! The `kahan-sweep` command.

use std::process::ExitCode;

fn main() -> ExitCode {
    kahan_sweep::run(std::env::args_os())
}
