//! Ensembles: the default build against one for this processor and against the machine's bounds.

use anyhow::Result;

use super::Section;
use crate::limit::Limit;
use crate::progress::Progress;
use crate::race::{Effort, Standing, race};
use crate::table::{Table, short};
use crate::worker::{self, Worker};

/// Divider and multiply-add loops.
const BOUND: &str = "bound";
/// One division of `f64`, four at a time.
const DIVISIONS: &str = "divisions, AVX2";
/// One multiply-add of `f64`, eight at a time.
const MULTIPLY_ADDS: &str = "multiply-adds, AVX-512";
const ENSEMBLE: &str = "ensemble";

/// One line of the table: who ran what.
struct Line {
    native: bool,
    system: String,
    what: String,
    operations: usize,
    standing: Standing,
}

/// Builds and times the ensembles.
pub(crate) fn ensembles(effort: Effort) -> Result<(Vec<Section>, Vec<Limit>)> {
    let progress = Progress::new(7);
    progress.begin("building for every processor and for this one");
    let mut workers = [
        Worker::start(&worker::build(worker::ENSEMBLES, false)?)?,
        Worker::start(&worker::build(worker::ENSEMBLES, true)?)?,
    ];
    progress.advance();
    let mut systems: Vec<String> = workers[0].tasks().iter().map(|task| task.system.clone()).collect();
    systems.retain(|system| system != BOUND);
    systems.dedup();
    let mut table = Table::new(&["a trajectory's step", "ns", "ratio", "quartiles", "of its bound"]);
    let mut limits = Vec::new();
    for system in &systems {
        progress.begin(format!("{system}: ensembles"));
        let lines = measure(&mut workers, system, effort)?;
        for line in lines.iter().filter(|line| line.system != BOUND) {
            table.push(row(line, &lines));
        }
        limits.extend(decide(system, &lines));
        progress.advance();
    }
    let lines = measure(&mut workers, BOUND, effort)?;
    for line in lines.iter().filter(|line| !line.native) {
        table.push(row(line, &[]));
    }
    let text = "512 trajectories of `f64` on one thread; ratios to the ensemble of the default build. The bound is what the divider\n\
                allows, one division of four numbers after the other, measured in the same rounds; for the estimated reciprocal it\n\
                is the ports that multiply and add, for as many operations as the step has, counted by running it. Both sides of that\n\
                comparison are the least of all rounds."
        .to_owned();
    Ok((vec![Section { title: "Ensembles".to_owned(), text, table }], limits))
}

/// Times everything of one system in both builds, and the bounds, in turns.
fn measure(workers: &mut [Worker; 2], system: &str, effort: Effort) -> Result<Vec<Line>> {
    let mut runners = Vec::new();
    for native in [false, true] {
        for (i, task) in workers[usize::from(native)].tasks().iter().enumerate() {
            if task.system == system || (task.system == BOUND && !native) {
                runners.push((native, i));
            }
        }
    }
    // The ensemble of the default build is what all ratios refer to.
    let base = runners.iter().position(|&(native, i)| !native && workers[0].tasks()[i].what == ENSEMBLE);
    runners.swap(0, base.unwrap_or(0));
    let mut failure = None;
    let standings = race(runners.len(), effort, |i, units| {
        let (native, task) = runners[i];
        workers[usize::from(native)].seconds(task, units).unwrap_or_else(|error| {
            failure = Some(error);
            1.0
        })
    });
    if let Some(error) = failure {
        return Err(error);
    }
    let lines = runners.iter().zip(standings).map(|(&(native, i), standing)| {
        let task = &workers[usize::from(native)].tasks()[i];
        let (system, what) = (task.system.clone(), task.what.clone());
        Line { native, system, what, operations: task.operations, standing }
    });
    Ok(lines.collect())
}

/// A unit of work is a step of this many trajectories.
const POINTS: f64 = 512.0;

fn row(line: &Line, lines: &[Line]) -> Vec<String> {
    let build = if line.native { ", built for this processor" } else { "" };
    let Standing { nanoseconds, ratio } = line.standing;
    vec![
        format!("{}: {}{build}", line.system, line.what),
        short(Some(nanoseconds / POINTS)),
        short(Some(ratio.median)),
        format!("[{:.2}, {:.2}]", ratio.low, ratio.high),
        short(of_bound(line, lines)),
    ]
}

fn find<'l>(lines: &'l [Line], native: bool, what: &str) -> Option<&'l Line> {
    lines.iter().find(|line| line.native == native && line.what == what)
}

/// Its time over the least that the processor's busiest unit allows, both at their least: a bound is what the machine can do
/// when nobody else has it, and on a busy one the medians of two loops, one of them long, do not meet.
fn of_bound(line: &Line, lines: &[Line]) -> Option<f64> {
    let least = |what| find(lines, false, what).map(|line| line.standing.nanoseconds);
    let bound = match line.what.as_str() {
        "ensemble, AVX2" => least(DIVISIONS)?,
        "ensemble, AVX-512, estimated" if line.operations > 0 => {
            least(MULTIPLY_ADDS)? * line.operations as f64
        }
        _ => return None,
    };
    Some(line.standing.nanoseconds / bound)
}

fn decide(system: &str, lines: &[Line]) -> Vec<Limit> {
    let ratio = |native, what| find(lines, native, what).map(|line| line.standing.ratio.median);
    let bound = |what| of_bound(find(lines, false, what)?, lines);
    let native = ratio(true, ENSEMBLE).map(f64::recip);
    let mut limits = vec![Limit::ratio(
        format!("{system}: ensemble, default build / built for this processor"),
        1.10,
        native,
    )];
    if ["LotkaVolterra", "E1", "E3"].contains(&system) {
        let figure = format!("{system}: ensemble, AVX2 / divider bound");
        limits.push(Limit::ratio(figure, 1.15, bound("ensemble, AVX2")));
    }
    let figure = format!("{system}: ensemble, estimated reciprocal / multiply-add bound");
    limits.push(Limit::ratio(figure, 1.33, bound("ensemble, AVX-512, estimated")));
    if system == "E3" {
        let single = ratio(false, "single trajectory").map(f64::recip);
        limits.push(Limit::ratio("E3: ensemble / a single trajectory's latency", 1.0 / 12.0, single));
    }
    limits
}
