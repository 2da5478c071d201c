//! A process that times tasks on request, so that several builds of it can be timed alternately.
//!
//! The process writes its tasks, one on each line, then an empty line. To a request `TASK UNITS` it
//! answers the seconds that this many units of work take.

use std::io::{self, BufRead, Write};

/// A task that is timed.
pub struct Task {
    /// The name of the system. A task that runs no system has another word here, such as `bound`.
    pub system: &'static str,
    /// The name of the task.
    pub what: &'static str,
    /// The number of operations of a step; 0 if they are not counted.
    pub operations: usize,
    /// Repeats the work of the task as often as the argument says, and returns the seconds.
    pub seconds: Box<dyn Fn(usize) -> f64>,
}

/// Writes the tasks, and answers requests until the input ends. Fails for invalid requests.
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
