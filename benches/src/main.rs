//! Benchmarks of generated steps, ensembles, other integrators, and compilation.

mod by_hand;
mod cli;
mod compile;
mod contender;
mod drift;
mod instructions;
mod journey;
mod limit;
mod machine;
mod orders;
mod output;
mod progress;
mod race;
mod readme;
mod report;
mod rivals;
mod systems;
mod table;
mod worker;

use std::process::ExitCode;

fn main() -> ExitCode {
    match cli::run() {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::from(2)
        }
    }
}
