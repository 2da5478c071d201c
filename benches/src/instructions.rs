//! Counts instructions per step with valgrind's callgrind. The counts of a short and a long run are
//! subtracted, so that only the additional steps remain.

use std::env;
use std::process::{Command, Stdio};

use anyhow::{Context, Result, bail};

pub(crate) const RUN_ONE: &str = "run-one";

/// The number of steps in the shorter run. The longer run has twice as many.
const STEPS: usize = 2048;

pub(crate) fn can_be_counted() -> bool {
    let status =
        Command::new("valgrind").arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    status.is_ok_and(|status| status.success())
}

pub(crate) fn per_step(system: &str, contender: usize) -> Result<f64> {
    let (short, long) = (count(system, contender, STEPS)?, count(system, contender, 2 * STEPS)?);
    Ok((long as f64 - short as f64) / STEPS as f64)
}

fn count(system: &str, contender: usize, steps: usize) -> Result<u64> {
    let program = env::current_exe().context("the path of this program is unknown")?;
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(program)
        .args([RUN_ONE, system, &contender.to_string(), &steps.to_string()])
        .output()
        .context("valgrind does not run")?;
    let report = String::from_utf8_lossy(&output.stderr);
    if !output.status.success() {
        bail!("valgrind failed on {system}, contender {contender}: {report}");
    }
    let collected = report.lines().find_map(|line| line.split_once("Collected :"));
    let (_, number) = collected.with_context(|| format!("valgrind gave no count: {report}"))?;
    number.trim().parse().with_context(|| format!("valgrind's count is no number: {number}"))
}
