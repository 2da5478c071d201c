//! The command line.

use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use clap::{Parser, Subcommand};

use crate::compile;
use crate::limit::{self, Limit};
use crate::output::write_whole;
use crate::race::Effort;
use crate::report::{self, Section};
use crate::{instructions, readme, systems};

const EXAMPLES: &str = "\
Examples (from the repository's root, on a machine with nothing else to do):
  cargo run --release --manifest-path benches/Cargo.toml                 everything, into benches/results
  cargo run --release --manifest-path benches/Cargo.toml steps E3 E6     one step of two systems
  cargo run --release --manifest-path benches/Cargo.toml -- --quick ensembles";

/// Generated Kahan steps against hand-written code, other integrators and the machine's bounds.
#[derive(Parser)]
#[command(after_help = EXAMPLES)]
struct Cli {
    /// Fewer rounds: a look, not a measurement
    #[arg(long, global = true)]
    quick: bool,
    #[command(subcommand)]
    what: Option<What>,
}

#[derive(Subcommand)]
enum What {
    /// Everything, a file of JSON a part; `benches/tables` makes tables of them (what happens
    /// without a subcommand)
    All {
        /// The folder [default: benches/results]
        #[arg(long)]
        out: Option<PathBuf>,
    },
    /// One step: dependent chains, timed in turns, and instructions counted by valgrind
    Steps {
        /// The systems [default: all]
        systems: Vec<String>,
    },
    /// Instructions of one step alone, counted by valgrind
    Instructions {
        /// The systems [default: all]
        systems: Vec<String>,
    },
    /// From one time to a later one: fixed steps against step control
    Orbits {
        /// The systems [default: all]
        systems: Vec<String>,
    },
    /// Many trajectories at once, against the machine's bounds and a build for this processor
    Ensembles,
    /// Fields read at run time beside the macro's code: steps, ensembles, compiling
    RunTime,
    /// The tiers of one step: what compensation, a promise and double-double cost
    Tiers,
    /// Order 8 against DOP853 at one error of the trajectory
    Orders,
    /// An integral over 10⁹ steps, plain and compensated
    Drift,
    /// The picture and the tables of `docs/reference/speed.md`, measured and written into it
    Readme,
    /// Measures the cost of a block at compile time, against the state in benches/before.tsv
    Compile {
        /// A checkout to measure in place of this one
        #[arg(long)]
        checkout: Option<PathBuf>,
        /// Writes the figures to this file as well, in the form of benches/before.tsv
        #[arg(long)]
        save: Option<PathBuf>,
    },
    /// Runs one contender for a number of steps
    #[command(name = instructions::RUN_ONE, hide = true)]
    RunOne { system: String, contender: usize, steps: usize },
}

/// Runs the command. Returns whether all measured figures are within their limits.
pub(crate) fn run() -> Result<bool> {
    let cli = Cli::parse();
    let effort = Effort::new(cli.quick);
    match cli.what.unwrap_or(What::All { out: None }) {
        What::All { out } => all(effort, &out.unwrap_or_else(|| root().join("benches/results"))),
        What::Steps { systems } => print(report::steps(&chosen(&systems)?, Some(effort))?),
        What::Instructions { systems } => {
            if !instructions::can_be_counted() {
                bail!("valgrind is not to be found, and it is what counts instructions; install it");
            }
            print(report::steps(&chosen(&systems)?, None)?)
        }
        What::Orbits { systems } => print(report::journeys(&chosen(&systems)?, effort)),
        What::Ensembles => print(report::ensembles(effort)?),
        What::RunTime => print(report::run_time(effort)?),
        What::Tiers => print(report::tiers(effort)?),
        What::Orders => print(report::orders(effort)),
        What::Readme => readme::write(&root(), effort).map(|()| true),
        What::Drift => print(report::drift(effort)),
        What::Compile { checkout, save } => {
            let figures = compile::measure(&checkout.unwrap_or_else(root), cli.quick)?;
            if let Some(path) = save {
                write_whole(&path, &compile::to_text(&figures))?;
            }
            print(report::compile(&figures)?)
        }
        What::RunOne { system, contender, steps } => run_one(&system, contender, steps).map(|()| true),
    }
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().map_or_else(PathBuf::new, Path::to_path_buf)
}

fn chosen(names: &[String]) -> Result<Vec<systems::System>> {
    let all = systems::all();
    for name in names {
        if !all.iter().any(|system| system.name == name) {
            let known: Vec<_> = all.iter().map(|system| system.name).collect();
            bail!("there is no system {name:?}; choose from {}", known.join(", "));
        }
    }
    let wanted = |system: &systems::System| names.is_empty() || names.iter().any(|name| name == system.name);
    Ok(all.into_iter().filter(wanted).collect())
}

fn hold(limits: &[Limit]) -> bool {
    let missed = limits.iter().filter(|limit| limit.is_missed());
    missed.inspect(|limit| eprintln!("does not hold: {}", limit.figure)).count() == 0
}

fn print((sections, limits): (Vec<Section>, Vec<Limit>)) -> Result<bool> {
    let mut text: String = sections.iter().map(|section| format!("{section}\n")).collect();
    if !limits.is_empty() {
        text += &limit::table(&limits).to_string();
    }
    match io::stdout().lock().write_all(text.as_bytes()) {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => {}
        written => written.context("standard output cannot be written")?,
    }
    Ok(hold(&limits))
}

fn all(effort: Effort, folder: &Path) -> Result<bool> {
    let systems = systems::all();
    let parts = [
        ("steps", report::steps(&systems, Some(effort))?),
        ("orbits", report::journeys(&systems, effort)),
        ("ensembles", report::ensembles(effort)?),
        ("run_time", report::run_time(effort)?),
        ("tiers", report::tiers(effort)?),
        ("orders", report::orders(effort)),
        ("drift", report::drift(effort)),
        ("compile", report::compile(&compile::measure(&root(), effort.is_quick())?)?),
    ];
    let mut all_hold = true;
    for (name, (sections, limits)) in parts {
        let path = folder.join(name).with_extension("json");
        write_whole(&path, &report::result(&root(), &sections, &limits))?;
        println!("{}", path.display());
        all_hold &= hold(&limits);
    }
    Ok(all_hold)
}

fn run_one(system: &str, contender: usize, steps: usize) -> Result<()> {
    let systems = chosen(&[system.to_owned()])?;
    let contender = systems[0].steps.get(contender);
    contender.with_context(|| format!("{system} has no such contender"))?.run(steps);
    Ok(())
}
