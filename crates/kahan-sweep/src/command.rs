//! The command `kahan-sweep`: takes arguments, and returns text and an exit status.

use std::ffi::OsString;
use std::fs;
use std::io::{BufWriter, ErrorKind, IsTerminal, Write, stderr, stdout};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use clap::{Parser, ValueEnum};
use indicatif::{ProgressBar, ProgressStyle};
use serde_json::json;

use crate::estimate::Estimate;
use crate::files::{RESULTS_FILE, Status, TableError, folder_is_writable, merge, ranges, status, table};
use crate::launcher::{RecognisedLauncher, detect};
use crate::plan::Plan;
use crate::run::{Run, RunEnd, Shard};
use crate::scripts;

/// Computes many orbits of Kahan's maps by a plan, on one machine or many.
///
/// A plan is a TOML file that specifies the field, the initial points, parameters and eps, the
/// observables, and the output. The initial points may be the rows of a file F.parquet, F.csv or
/// F.npy. Without further options, the whole plan is computed on all cores, and the result is
/// DIR/results.parquet. After an interruption, the same command continues where it stopped.
///
/// With --shard i/n, this process computes the i-th of n shards. Under a launcher (Slurm, MPI,
/// Kubernetes, Grid Engine, LSF, PBS), it takes i and n from the environment. All shards write into
/// one folder, and --merge joins their parts. The bytes of the result depend on the plan alone, not
/// on shards, threads or interruptions.
///
/// The exit status is 0 for success, 1 if parts are missing or do not belong to the plan, 2 for
/// wrong usage or a mistake in the plan, 130 after an interruption.
#[derive(Debug, Parser)]
#[command(name = "kahan-sweep", version, after_help = EXAMPLES)]
struct Cli {
    /// The plan, a TOML file.
    #[arg(value_name = "PLAN.toml", required_unless_present = "read")]
    plan: Option<PathBuf>,

    /// The folder of the results, created if missing.
    #[arg(long, value_name = "DIR", required_unless_present_any = ["dry_run", "scheduler", "read"])]
    out: Option<PathBuf>,

    /// Compute shard i of n, as in 3/10; `auto` takes it from the launcher.
    #[arg(long, value_name = "I/N", conflicts_with_all = ["status", "merge", "dry_run", "scheduler"])]
    shard: Option<String>,

    /// Print how many parts are done, and which are missing.
    #[arg(long, conflicts_with_all = ["merge", "dry_run", "scheduler"])]
    status: bool,

    /// Join all parts into DIR/results.parquet.
    #[arg(long, conflicts_with_all = ["dry_run", "scheduler"])]
    merge: bool,

    /// Only print the number of points, the estimated time and the size.
    #[arg(long, conflicts_with = "scheduler")]
    dry_run: bool,

    /// Print the rows of a result as CSV.
    #[arg(long, value_name = "F.parquet", conflicts_with_all = ["plan", "out", "shard", "status", "merge", "dry_run", "scheduler"])]
    read: Option<PathBuf>,

    /// With --read: the columns to print, in this order; all if not given.
    #[arg(long, value_name = "NAMES", value_delimiter = ',', requires = "read")]
    columns: Vec<String>,

    /// Print a job description for a scheduler.
    #[arg(long = "for", value_name = "SCHEDULER", value_enum, requires = "shards")]
    scheduler: Option<Scheduler>,

    /// With --for: the number of shards.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=1_000_000))]
    shards: Option<u64>,

    /// The number of threads; one per core if not given.
    #[arg(long, value_name = "T", value_parser = clap::value_parser!(u64).range(1..=65_536))]
    threads: Option<u64>,

    /// Print one JSON object.
    #[arg(long)]
    json: bool,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Scheduler {
    Slurm,
    Kubernetes,
}

const EXAMPLES: &str = "\
Examples:
  kahan-sweep plan.toml --dry-run
  kahan-sweep plan.toml --out results
  kahan-sweep plan.toml --out results --shard 3/10
  kahan-sweep plan.toml --out results --status
  kahan-sweep plan.toml --out results --merge
  kahan-sweep --read results/results.parquet --columns x,sali > rows.csv
  kahan-sweep plan.toml --out results --for slurm --shards 100 > job.sh";

/// The text for standard output, or the error message; each with the exit status.
type CommandResult = Result<(String, u8), (String, u8)>;

/// Returns a message about wrong usage, together with the exit status 2.
fn usage(why: impl Into<String>) -> (String, u8) {
    (why.into(), 2)
}

/// Runs the command. The first argument is the program's name.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    let cli = match Cli::try_parse_from(arguments) {
        Ok(cli) => cli,
        Err(error) => {
            let _ = error.print();
            return ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(2));
        }
    };
    let status = match cli.ended() {
        Ok((text, status)) => {
            print!("{text}");
            status
        }
        Err((why, status)) => {
            eprintln!("error: {why}");
            status
        }
    };
    ExitCode::from(status)
}

impl Cli {
    fn ended(&self) -> CommandResult {
        if let Some(path) = &self.read {
            return self.table(path);
        }
        let path = self.plan.as_deref().unwrap_or(Path::new("plan.toml"));
        let name = path.display().to_string();
        let text = fs::read_to_string(path);
        let text = text.map_err(|error| usage(format!("{name} cannot be read: {error}")))?;
        let plan = Plan::read(&text, &name).map_err(usage)?;
        let out = self.out.as_deref().unwrap_or(Path::new("results"));
        if let Some(scheduler) = self.scheduler {
            let shards = self.shards.unwrap_or(1);
            let text = match scheduler {
                Scheduler::Slurm => scripts::slurm(path, out, shards),
                Scheduler::Kubernetes => scripts::kubernetes(path, shards),
            };
            return Ok((text, 0));
        }
        if self.dry_run {
            let estimate = Estimate::of(&plan);
            return Ok((if self.json { format!("{:#}\n", estimate.json()) } else { estimate.text() }, 0));
        }
        if self.status {
            return Ok(self.status(&plan, out));
        }
        folder_is_writable(out).map_err(|error| {
            usage(format!("--out: nothing can be written into {}: {error}", out.display()))
        })?;
        if self.merge { merge_results(&plan, out) } else { self.compute(&plan, out) }
    }

    fn table(&self, path: &Path) -> CommandResult {
        let mut to = BufWriter::new(stdout().lock());
        let written = table(path, &self.columns, &mut to);
        match written.and_then(|()| to.flush().map_err(TableError::Unwritten)) {
            // A broken pipe means that the reader needs no more rows, so it is not an error.
            Err(TableError::Unwritten(error)) if error.kind() != ErrorKind::BrokenPipe => {
                Err((format!("the rows cannot be written: {error}"), 1))
            }
            Err(TableError::Unreadable(why)) => Err(usage(why)),
            _ => Ok((String::new(), 0)),
        }
    }

    fn status(&self, plan: &Plan, out: &Path) -> (String, u8) {
        let bar = bar(plan.parts(), "parts");
        let Status { done, missing, refused } = status(plan, out, || bar.inc(1));
        bar.finish_and_clear();
        let is_whole = done == plan.parts();
        let text = if self.json {
            let object = json!({
                "points": plan.points(), "parts": plan.parts(), "done": done, "missing": missing,
                "refused": refused, "plan": plan.hash(),
            });
            format!("{object:#}\n")
        } else {
            let mut lines = vec![format!("{done} of {} parts are done", plan.parts())];
            if !missing.is_empty() {
                lines.push(format!("missing: {}", ranges(&missing)));
            }
            lines.extend(refused);
            lines.join("\n") + "\n"
        };
        (text, u8::from(!is_whole))
    }

    /// Returns the shard to compute, and how many processes of the sweep run on this machine.
    fn shard(&self) -> Result<(Shard, usize), String> {
        let said = self.shard.as_deref();
        if let Some(text) = said.filter(|text| *text != "auto") {
            let why = || format!("--shard {text}: write i/n, the i-th of n shards, as in 3/10");
            return shard(text).map(|shard| (shard, 1)).ok_or_else(why);
        }
        match detect(&|name| std::env::var(name))? {
            Some(RecognisedLauncher { shard, sentence, beside }) => {
                // One call writes sentence and newline, because launchers interleave the output of
                // their tasks.
                eprint!("{}", sentence + "\n");
                Ok((shard, beside))
            }
            None if said.is_some() => {
                Err("--shard auto: no launcher is recognised here; give --shard i/n".to_owned())
            }
            None => Ok((Shard::WHOLE, 1)),
        }
    }

    fn compute(&self, plan: &Plan, out: &Path) -> CommandResult {
        let (shard, beside) = self.shard().map_err(usage)?;
        let threads = self.threads.map(|threads| threads as usize).or_else(|| {
            let cores = std::thread::available_parallelism().ok()?.get();
            Some((cores / beside).max(1))
        });
        let rows: u64 = shard.parts(plan).map(|part| plan.part(part)).map(|rows| rows.end - rows.start).sum();
        let stop = Arc::new(AtomicBool::new(false));
        for signal in [signal_hook::consts::SIGINT, signal_hook::consts::SIGTERM] {
            // A second signal ends the process at once.
            let _ = signal_hook::flag::register_conditional_shutdown(signal, 130, Arc::clone(&stop));
            let _ = signal_hook::flag::register(signal, Arc::clone(&stop));
        }
        let bar = bar(rows, "points");
        let run = Run {
            plan,
            folder: out,
            threads,
            stop: &stop,
            progress: &|rows| bar.inc(rows),
            say: &|words| bar.suspend(|| eprintln!("note: {words}")),
        };
        let end = run.shard(shard);
        bar.finish_and_clear();
        match end.map_err(|why| (why, 1))? {
            RunEnd::Interrupted => {
                Err(("interrupted; the same command goes on where this stopped".to_owned(), 130))
            }
            RunEnd::Done if shard == Shard::WHOLE => merge_results(plan, out),
            RunEnd::Done => {
                let (Shard { index, of }, parts) = (shard, shard.parts(plan).count());
                let text = format!(
                    "shard {} of {of}: {parts} parts are in {}; when all shards are done, --merge joins them\n",
                    index + 1,
                    out.display()
                );
                Ok((text, 0))
            }
        }
    }
}

fn merge_results(plan: &Plan, out: &Path) -> CommandResult {
    let bar = bar(plan.parts(), "parts");
    let merged = merge(plan, out, || bar.inc(1));
    bar.finish_and_clear();
    let bytes = merged.map_err(|reasons| (reasons.join("\nerror: "), 1))?;
    let (results, size) = (out.join(RESULTS_FILE), bytes as f64 / 1e6);
    Ok((format!("{} written: {} points, {size:.1} MB\n", results.display(), plan.points()), 0))
}

fn shard(text: &str) -> Option<Shard> {
    let (index, of) = text.split_once('/')?;
    let (index, of): (u64, u64) = (index.trim().parse().ok()?, of.trim().parse().ok()?);
    (1 <= index && index <= of).then(|| Shard { index: index - 1, of })
}

fn bar(length: u64, what: &str) -> ProgressBar {
    if !stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} {msg} ({elapsed}, {eta} left)");
    let bar = ProgressBar::new(length).with_message(what.to_owned());
    bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}
