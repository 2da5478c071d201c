//! Reports the speed of ensembles in two builds, compared with the machine's bounds.

use anyhow::Result;

use super::Section;
use crate::limit::Limit;
use crate::progress::Progress;
use crate::race::{Effort, least_times};
use crate::table::{Table, short};
use crate::worker::{self, Worker};

const BOUND: &str = "bound";
const DIVISIONS: &str = "divisions, AVX2";
const MULTIPLY_ADDS: &str = "multiply-adds, AVX-512";
const ENSEMBLE: &str = "ensemble";

struct Line {
    native: bool,
    system: String,
    what: String,
    operations: usize,
    nanoseconds: f64,
}

pub(crate) fn ensembles(effort: Effort) -> Result<(Vec<Section>, Vec<Limit>)> {
    let progress = Progress::new(2);
    progress.begin("building for every processor and for this one");
    let mut workers = [
        Worker::start(&worker::build(worker::ENSEMBLES, false)?)?,
        Worker::start(&worker::build(worker::ENSEMBLES, true)?)?,
    ];
    progress.advance();
    progress.begin("ensembles");
    let mut table = Table::new(&["a trajectory's step", "ns", "ratio", "of its bound"]);
    let mut limits = Vec::new();
    let of_systems = measure(&mut workers, effort)?;
    for lines in &of_systems {
        let system = &lines[0].system;
        for line in lines.iter().filter(|line| line.system == *system && (system != BOUND || !line.native)) {
            table.push(row(line, lines));
        }
        if system != BOUND {
            limits.extend(decide(system, lines));
        }
    }
    progress.advance();
    let text = "512 trajectories of `f64` on one thread; ratios to the ensemble of the default build. The bound is what the divider\n\
                allows, one division of four numbers after the other, measured in the same rounds; for the estimated reciprocal it\n\
                is the ports that multiply and add, for as many operations as the step has, counted by running it. Ratios are those\n\
                of the least times of all rounds."
        .to_owned();
    Ok((vec![Section { title: "Ensembles".to_owned(), text, table }], limits))
}

pub(crate) fn ensemble_times(effort: Effort) -> Result<Vec<(String, f64)>> {
    let mut worker = Worker::start(&worker::build(worker::ENSEMBLES, false)?)?;
    let tasks = worker.tasks().iter().enumerate().filter(|(_, task)| task.what == ENSEMBLE);
    let (tasks, systems): (Vec<usize>, Vec<String>) = tasks.map(|(i, task)| (i, task.system.clone())).unzip();
    let times =
        least_times(&vec![1; tasks.len()], effort, |race, _, units| worker.seconds(tasks[race], units))?;
    Ok(systems.into_iter().zip(times).map(|(system, times)| (system, times[0] / POINTS)).collect())
}

/// Times all tasks of each system in both builds alternately. The ensemble in the default build is
/// the reference of the ratios.
fn measure(workers: &mut [Worker; 2], effort: Effort) -> Result<Vec<Vec<Line>>> {
    let mut systems: Vec<&str> = workers[0].tasks().iter().map(|task| task.system.as_str()).collect();
    systems.sort_by_key(|&system| system == BOUND);
    systems.dedup();
    let races: Vec<Vec<(bool, usize)>> = systems
        .iter()
        .map(|&system| {
            let tasks = [false, true].into_iter().flat_map(|native| {
                let tasks = workers[usize::from(native)].tasks().iter().enumerate();
                tasks.map(move |(i, task)| (native, i, task))
            });
            let mut of: Vec<_> = tasks
                .filter(|(native, _, task)| task.system == system || (task.system == BOUND && !native))
                .collect();
            of.sort_by_key(|(native, _, task)| *native || task.system != system || task.what != ENSEMBLE);
            of.into_iter().map(|(native, i, _)| (native, i)).collect()
        })
        .collect();
    let runners: Vec<usize> = races.iter().map(Vec::len).collect();
    let times = least_times(&runners, effort, |race, i, units| {
        let (native, task) = races[race][i];
        workers[usize::from(native)].seconds(task, units)
    })?;
    let line = |(native, i): (bool, usize), nanoseconds| {
        let task = &workers[usize::from(native)].tasks()[i];
        let (system, what) = (task.system.clone(), task.what.clone());
        Line { native, system, what, operations: task.operations, nanoseconds }
    };
    let lines =
        |(of, times): (&Vec<_>, &Vec<f64>)| of.iter().zip(times).map(|(&of, &time)| line(of, time)).collect();
    Ok(races.iter().zip(&times).map(lines).collect())
}

const POINTS: f64 = 512.0;

fn row(line: &Line, lines: &[Line]) -> Vec<String> {
    let build = if line.native { ", built for this processor" } else { "" };
    vec![
        format!("{}: {}{build}", line.system, line.what),
        short(Some(line.nanoseconds / POINTS)),
        short(Some(line.nanoseconds / lines[0].nanoseconds)),
        short(of_bound(line, lines)),
    ]
}

fn find<'l>(lines: &'l [Line], native: bool, what: &str) -> Option<&'l Line> {
    lines.iter().find(|line| line.native == native && line.what == what)
}

/// Returns the time divided by the least time that the machine's throughput permits.
fn of_bound(line: &Line, lines: &[Line]) -> Option<f64> {
    let least = |what| find(lines, false, what).map(|line| line.nanoseconds);
    let bound = match line.what.as_str() {
        "ensemble, AVX2" => least(DIVISIONS)?,
        "ensemble, AVX-512, estimated" if line.operations > 0 => {
            least(MULTIPLY_ADDS)? * line.operations as f64
        }
        _ => return None,
    };
    Some(line.nanoseconds / bound)
}

fn decide(system: &str, lines: &[Line]) -> Vec<Limit> {
    let ratio = |native, what| {
        Some(find(lines, false, ENSEMBLE)?.nanoseconds / find(lines, native, what)?.nanoseconds)
    };
    let bound = |what| of_bound(find(lines, false, what)?, lines);
    let native = ratio(true, ENSEMBLE);
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
        let single = ratio(false, "single trajectory");
        limits.push(Limit::ratio("E3: ensemble / a single trajectory's latency", 1.0 / 12.0, single));
    }
    limits
}
