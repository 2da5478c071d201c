//! Reports the cost of each tier, which is a way to take a step with a certain guarantee.

use anyhow::Result;

use super::Section;
use crate::limit::Limit;
use crate::progress::Progress;
use crate::race::{Effort, least_times};
use crate::table::{Table, short};
use crate::worker::{self, Worker};

/// The kind of step with which all others are compared.
const FAST: &str = "fast";
/// The fast step with one call for each step, for comparison with the stable step.
const STEP: &str = "fast, a step at a time";

/// The limits: two tiers, `true` for native builds, and the largest permitted ratio of times.
const LIMITS: [(&str, &str, bool, f64); 3] =
    [("compensated", FAST, false, 1.20), ("stable", STEP, false, 1.5), ("accurate", FAST, true, 10.0)];

pub(crate) fn tiers(effort: Effort) -> Result<(Vec<Section>, Vec<Limit>)> {
    let progress = Progress::new(3);
    let mut table = Table::new(&["a step", "ns", "ratio", "ns, built for this processor", "ratio"]);
    let mut limits = Vec::new();
    let mut columns = Vec::new();
    for native in [false, true] {
        progress.begin("tiers");
        let mut worker = Worker::start(&worker::build(worker::TIERS, native)?)?;
        columns.push(measure(&mut worker, effort)?);
        progress.advance();
    }
    for (line, native) in columns[0].iter().zip(&columns[1]) {
        table.push(vec![
            format!("{}: {}", line.system, line.what),
            short(Some(line.nanoseconds)),
            short(Some(line.ratio)),
            short(Some(native.nanoseconds)),
            short(Some(native.ratio)),
        ]);
    }
    for (what, base, native, at_most) in LIMITS {
        let build = if native { ", built for this processor" } else { "" };
        let lines = &columns[usize::from(native)];
        for line in lines.iter().filter(|line| line.what == what && line.is_small()) {
            let base_line = lines.iter().find(|other| other.system == line.system && other.what == base);
            let ratio = base_line.map(|base_line| line.ratio / base_line.ratio);
            let figure = format!("{}: {what} / {base}{build}", line.system);
            limits.push(Limit::ratio(figure, at_most, ratio));
        }
    }
    progress.advance();
    let text = "Chains of dependent steps, each tier against the fast one of the same build: `orbit`, `orbit(..).compensated()`, \
                `orbit(..).projective()`\nfar from poles, `try_step`, `Dd`, and for `f32` also the step computed in `f64`. Ratios are those of the least times of all rounds."
        .to_owned();
    Ok((vec![Section { title: "Tiers".to_owned(), text, table }], limits))
}

/// Returns the cost of each tier relative to the fast tier, for systems of two or three variables.
pub(crate) fn tier_prices(effort: Effort) -> Result<Vec<(String, f64)>> {
    let mut worker = Worker::start(&worker::build(worker::TIERS, false)?)?;
    let lines = measure(&mut worker, effort)?;
    Ok(lines.into_iter().filter(Line::is_small).map(|line| (line.what, line.ratio)).collect())
}

struct Line {
    system: String,
    what: String,
    nanoseconds: f64,
    ratio: f64,
}

impl Line {
    /// Returns whether the system has two or three variables, so that limits apply.
    fn is_small(&self) -> bool {
        self.system != "Clebsch"
    }
}

fn measure(worker: &mut Worker, effort: Effort) -> Result<Vec<Line>> {
    let tasks: Vec<(String, String)> =
        worker.tasks().iter().map(|task| (task.system.clone(), task.what.clone())).collect();
    let mut systems: Vec<&str> = tasks.iter().map(|(system, _)| system.as_str()).collect();
    systems.dedup();
    let races: Vec<Vec<usize>> = systems
        .iter()
        .map(|&system| {
            let mut of: Vec<usize> = (0..tasks.len()).filter(|&task| tasks[task].0 == system).collect();
            of.sort_by_key(|&task| tasks[task].1 != FAST);
            of
        })
        .collect();
    let runners: Vec<usize> = races.iter().map(Vec::len).collect();
    let times = least_times(&runners, effort, |race, i, units| worker.seconds(races[race][i], units))?;
    let lines = races.iter().zip(&times).flat_map(|(of, times)| {
        of.iter().zip(times).map(|(&task, &nanoseconds)| {
            let (system, what) = tasks[task].clone();
            Line { system, what, nanoseconds, ratio: nanoseconds / times[0] }
        })
    });
    Ok(lines.collect())
}
