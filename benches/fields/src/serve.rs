//! A process that times things when it is asked to, so that several builds of it can be timed in
//! turns.
//!
//! First it writes its tasks, a line each: the system, what is done, and the operations of one step
//! besides divisions, where they are counted; an empty line ends them. Then a line `TASK UNITS` is
//! answered by the seconds that so many units took.

use std::io::{self, BufRead, Write};

/// Something to time.
pub struct Task {
    /// The system, or what else is timed.
    pub system: &'static str,
    /// How it is run.
    pub what: &'static str,
    /// Additions, multiplications and multiply-adds of one step, or 0 where nobody counts them.
    pub operations: usize,
    /// The seconds that so many units take.
    pub seconds: Box<dyn Fn(usize) -> f64>,
}

/// Offers the tasks and answers requests until nobody asks any more.
///
/// # Errors
/// Where a line is no request, and where standard input or output break.
pub fn serve(tasks: &[Task]) -> io::Result<()> {
    let mut output = io::stdout().lock();
    for task in tasks {
        writeln!(output, "{}\t{}\t{}", task.system, task.what, task.operations)?;
    }
    writeln!(output)?;
    output.flush()?;
    for line in io::stdin().lock().lines() {
        let line = line?;
        let request = line.split_once(' ').and_then(|(task, units)| {
            Some((tasks.get(task.parse::<usize>().ok()?)?, units.parse::<usize>().ok()?))
        });
        let (task, units) =
            request.ok_or_else(|| io::Error::other(format!("not a request: {line:?}; write TASK UNITS")))?;
        writeln!(output, "{:e}", (task.seconds)(units))?;
        output.flush()?;
    }
    Ok(())
}
