//! Reports the speed of fields read at run time, compared with the macro's code.

use anyhow::{Context, Result};

use super::Section;
use crate::limit::Limit;
use crate::progress::Progress;
use crate::race::{Effort, least_times};
use crate::table::{Table, short};
use crate::worker::{self, Worker};

/// The prefix in the name of a task that runs the macro's code.
const MACRO: &str = "macro: ";
const RUN_TIME: &str = "run time: ";
/// The prefix in the name of a task that compiles. The macro's code has no such task.
const COMPILING: &str = "compiling: ";
/// Tasks whose times have no limit. In the first, run-time code needs a call for each step. In the
/// second, the macro's code uses fused multiply-adds.
const UNJUDGED: [&str; 2] = ["a step at a time", "ensemble"];
/// The largest permitted time of run-time code, divided by that of the macro's code.
const AT_MOST: f64 = 1.15;
/// The largest permitted time to compile formulas to machine code, in milliseconds.
const COMPILING_AT_MOST: [(&str, f64); 2] =
    [("E6: step and integrals", 0.2), ("Clebsch: step and integrals", 1.0)];
const POINTS: f64 = 512.0;

struct Line {
    system: String,
    what: String,
    generated: f64,
    run_time: f64,
}

impl Line {
    fn ratio(&self) -> f64 {
        self.run_time / self.generated
    }

    fn cells(&self) -> [String; 3] {
        let states = if self.what.starts_with("ensemble") { POINTS } else { 1.0 };
        let time = |nanoseconds: f64| short(Some(nanoseconds / states));
        [time(self.generated), time(self.run_time), short(Some(self.ratio()))]
    }
}

pub(crate) fn run_time(effort: Effort) -> Result<(Vec<Section>, Vec<Limit>)> {
    let progress = Progress::new(3);
    progress.begin("building for every processor and for this one");
    let mut workers = [
        Worker::start(&worker::build(worker::RUN_TIME, false)?)?,
        Worker::start(&worker::build(worker::RUN_TIME, true)?)?,
    ];
    progress.advance();
    progress.begin("run time beside the macro");
    let [lines, native_lines] = [measure(&mut workers[0], effort)?, measure(&mut workers[1], effort)?];
    progress.advance();
    progress.begin("compiling");
    let (compiling, compiling_limits) = compiling(&mut workers[0], effort)?;
    progress.advance();
    let head = [
        "a state's step",
        "macro, ns",
        "run time, ns",
        "ratio",
        "built for this processor: macro, ns",
        "run time, ns",
        "ratio",
    ];
    let mut table = Table::new(&head);
    let mut limits = Vec::new();
    for (line, native) in lines.iter().zip(&native_lines) {
        let name = format!("{}: {}", line.system, line.what);
        table.push([name].into_iter().chain(line.cells()).chain(native.cells()).collect());
    }
    for (lines, build) in [(&lines, ""), (&native_lines, ", built for this processor")] {
        for line in lines.iter().filter(|line| !UNJUDGED.contains(&line.what.as_str())) {
            let figure = format!("{}: {}, run time / macro{build}", line.system, line.what);
            limits.push(Limit::ratio(figure, AT_MOST, Some(line.ratio())));
        }
    }
    limits.extend(compiling_limits);
    let text = "The map of a field that is read at run time beside the macro's code of the same field, in one process, with the same bits:\n\
                chains of dependent steps, `orbit(..).nth(k)` beside `advance(.., k)`; a step at a time, where the run-time side makes a\n\
                call for each; and ensembles of 512 trajectories on one thread at each level. `ensemble` alone is what each side\n\
                does when it is not asked: the macro's takes the largest level, with its fused bits; the other one keeps the bits of the\n\
                build. Ratios are those of the least times of all rounds."
        .to_owned();
    let sections = vec![Section { title: "Run time".to_owned(), text, table }, compiling];
    Ok((sections, limits))
}

fn measure(worker: &mut Worker, effort: Effort) -> Result<Vec<Line>> {
    let find = |system: &str, what: &str| {
        let mut tasks = worker.tasks().iter();
        tasks.position(|task| task.system == system && task.what == what)
    };
    let mut names = Vec::new();
    let mut races = Vec::new();
    for (i, task) in worker.tasks().iter().enumerate() {
        let Some(what) = task.what.strip_prefix(MACRO) else { continue };
        let other = find(&task.system, &format!("{RUN_TIME}{what}"));
        races.push([i, other.with_context(|| format!("{}: {what} has one side alone", task.system))?]);
        names.push((task.system.clone(), what.to_owned()));
    }
    let runners = vec![2; races.len()];
    let times = least_times(&runners, effort, |race, i, units| worker.seconds(races[race][i], units))?;
    let line = |((system, what), times): (_, &Vec<f64>)| Line {
        system,
        what,
        generated: times[0],
        run_time: times[1],
    };
    Ok(names.into_iter().zip(&times).map(line).collect())
}

fn compiling(worker: &mut Worker, effort: Effort) -> Result<(Section, Vec<Limit>)> {
    let tasks = worker.tasks().iter().enumerate();
    let tasks: Vec<(usize, String, String)> = tasks
        .filter_map(|(i, task)| Some((i, task.system.clone(), task.what.strip_prefix(COMPILING)?.to_owned())))
        .collect();
    let mut table = Table::new(&["from a plan to machine code", "ms"]);
    let mut limits = Vec::new();
    for (task, system, what) in tasks {
        let milliseconds = 1e3 * worker.seconds(task, effort.rounds)? / effort.rounds as f64;
        let name = format!("{system}: {what}");
        if let Some((_, at_most)) = COMPILING_AT_MOST.iter().find(|(limited, _)| *limited == name) {
            let figure = format!("{name}, from a plan to machine code");
            limits.push(Limit { figure, at_most: Some(*at_most), measured: Some(milliseconds), unit: " ms" });
        }
        table.push(vec![name, short(Some(milliseconds))]);
    }
    let text = "A field that is planned and was never compiled, in `f64`: `map.at(eps)`, then the first `integrals`, or the first\n\
                `advance_columns`. The median of many fields."
        .to_owned();
    Ok((Section { title: "Compiling at run time".to_owned(), text, table }, limits))
}
