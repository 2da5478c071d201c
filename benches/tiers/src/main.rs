//! A process that times tiers when it is asked to: first its tasks, a line each (system, tier, 0) and an empty one; then a
//! line `TASK UNITS` is answered by the seconds that so many steps took.

mod tasks;

use std::io::{self, BufRead, Write};

use anyhow::{Context, Result};

fn main() -> Result<()> {
    let tasks = tasks::all();
    let mut output = io::stdout().lock();
    for task in &tasks {
        writeln!(output, "{}\t{}\t0", task.system, task.what)?;
    }
    writeln!(output)?;
    output.flush()?;
    for line in io::stdin().lock().lines() {
        let line = line?;
        let request = line.split_once(' ').and_then(|(task, units)| {
            Some((tasks.get(task.parse::<usize>().ok()?)?, units.parse::<usize>().ok()?))
        });
        let (task, units) = request.with_context(|| format!("not a request: {line:?}; write TASK UNITS"))?;
        writeln!(output, "{:e}", (task.seconds)(units))?;
        output.flush()?;
    }
    Ok(())
}
