//! Starts processes that time tasks on request, in a default and a native build.

use std::env;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use anyhow::{Context, Result, bail};

/// The package that times ensembles; its program has the same name.
pub(crate) const ENSEMBLES: &str = "kahan-bench-ensembles";
pub(crate) const RUN_TIME: &str = "kahan-bench-run-time";
pub(crate) const TIERS: &str = "kahan-bench-tiers";

pub(crate) struct Task {
    pub(crate) system: String,
    pub(crate) what: String,
    /// The number of additions, multiplications and multiply-adds of one step.
    pub(crate) operations: usize,
}

pub(crate) struct Worker {
    child: Child,
    requests: ChildStdin,
    answers: BufReader<ChildStdout>,
    tasks: Vec<Task>,
}

/// Builds the program of a package, and returns its path.
pub(crate) fn build(package: &str, native: bool) -> Result<PathBuf> {
    let program = env::current_exe().context("the path of this program is unknown")?;
    // The path of the program ends in target/release/program.
    let target = program.ancestors().nth(2).context("this program does not lie in a target folder")?;
    let target = if native { target.join("native") } else { target.to_path_buf() };
    let mut command = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command
        .args(["build", "--quiet", "--release", "--package", package, "--manifest-path"])
        .arg(Path::new(env!("CARGO_MANIFEST_DIR")).join("Cargo.toml"))
        .arg("--target-dir")
        .arg(&target);
    if native {
        command.env("RUSTFLAGS", "-C target-cpu=native");
    }
    let status = command.status().context("cargo does not run")?;
    if !status.success() {
        bail!("the package {package} does not build; cargo has said why above");
    }
    Ok(target.join("release").join(package).with_extension(env::consts::EXE_EXTENSION))
}

impl Worker {
    pub(crate) fn start(program: &Path) -> Result<Self> {
        let mut child = Command::new(program)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .with_context(|| format!("{} does not start", program.display()))?;
        let requests = child.stdin.take().context("the worker has no input")?;
        let mut answers = BufReader::new(child.stdout.take().context("the worker has no output")?);
        let mut tasks = Vec::new();
        loop {
            let line = answer(&mut answers)?;
            let mut fields = line.split('\t');
            let (Some(system), Some(what), Some(operations)) = (fields.next(), fields.next(), fields.next())
            else {
                break;
            };
            let operations = operations.parse().context("a worker's task without its operations")?;
            tasks.push(Task { system: system.to_owned(), what: what.to_owned(), operations });
        }
        Ok(Self { child, requests, answers, tasks })
    }

    pub(crate) fn tasks(&self) -> &[Task] {
        &self.tasks
    }

    pub(crate) fn seconds(&mut self, task: usize, units: usize) -> Result<f64> {
        writeln!(self.requests, "{task} {units}").context("the worker has ended")?;
        self.requests.flush().context("the worker has ended")?;
        let text = answer(&mut self.answers)?;
        text.parse().with_context(|| format!("the worker's answer is no time: {text:?}"))
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        // An error is ignored, because the process may have ended already.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn answer(answers: &mut BufReader<ChildStdout>) -> Result<String> {
    let mut line = String::new();
    if answers.read_line(&mut line).context("the worker cannot be read")? == 0 {
        bail!("the worker ended before it answered");
    }
    Ok(line.trim_end_matches('\n').to_owned())
}
