//! A process that times ensembles when it is asked to.
//!
//! Several builds of it, for the processor at large and for this one, are timed in turns by the benchmarks. First it
//! writes its tasks, a line each: the system, what is done, and the operations of one step besides divisions; an empty
//! line ends them. Then a line `TASK UNITS` is answered by the seconds that so many units took.

mod bounds;
mod counted;
mod tasks;

use std::io::{self, BufRead, Write};

use anyhow::{Context, Result};

fn main() -> Result<()> {
    let tasks = tasks::all();
    let mut output = io::stdout().lock();
    for task in &tasks {
        writeln!(output, "{}\t{}\t{}", task.system, task.what, task.operations)?;
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
