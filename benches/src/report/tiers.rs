//! Tiers: what a promise costs.

use anyhow::Result;

use super::Section;
use crate::limit::Limit;
use crate::progress::Progress;
use crate::race::{Effort, race};
use crate::table::{Table, short};
use crate::worker::{self, Worker};

/// What all others are compared with.
const FAST: &str = "fast";

/// The tiers with a limit: whether it is one of the build for this processor (with multiply-adds), and the most that the ratio
/// may be.
const LIMITS: [(&str, bool, f64); 3] =
    [("compensated", false, 1.20), ("stable", false, 1.5), ("accurate", true, 10.0)];

/// Builds and times the tiers.
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
    for (what, native, at_most) in LIMITS {
        let build = if native { ", built for this processor" } else { "" };
        for line in columns[usize::from(native)].iter().filter(|line| line.what == what) {
            // The promise is for three variables; larger systems are told, not judged.
            if what == "stable" && !line.is_small() {
                continue;
            }
            let figure = format!("{}: {what} / fast{build}", line.system);
            limits.push(Limit::ratio(figure, at_most, Some(line.ratio)));
        }
    }
    progress.advance();
    let text = "Chains of dependent steps, each tier against the fast one of the same build: `orbit`, `orbit(..).compensated()`, \
                `try_step`, `Dd`,\nand for `f32` also the step computed in `f64`."
        .to_owned();
    Ok((vec![Section { title: "Tiers".to_owned(), text, table }], limits))
}

struct Line {
    system: String,
    what: String,
    nanoseconds: f64,
    ratio: f64,
}

impl Line {
    fn is_small(&self) -> bool {
        self.system != "Clebsch"
    }
}

/// Times the tiers of each system in turns.
fn measure(worker: &mut Worker, effort: Effort) -> Result<Vec<Line>> {
    let tasks: Vec<(String, String)> =
        worker.tasks().iter().map(|task| (task.system.clone(), task.what.clone())).collect();
    let mut systems: Vec<String> = tasks.iter().map(|(system, _)| system.clone()).collect();
    systems.dedup();
    let mut lines = Vec::new();
    for system in systems {
        let of_system: Vec<usize> = (0..tasks.len()).filter(|&task| tasks[task].0 == system).collect();
        let base = of_system.iter().position(|&task| tasks[task].1 == FAST).unwrap_or(0);
        let mut order = of_system.clone();
        order.swap(0, base);
        let mut failure = None;
        let standings = race(order.len(), effort, |i, units| {
            worker.seconds(order[i], units).unwrap_or_else(|error| {
                failure = Some(error);
                1.0
            })
        });
        if let Some(error) = failure {
            return Err(error);
        }
        lines.extend(order.iter().zip(standings).map(|(&task, standing)| Line {
            system: tasks[task].0.clone(),
            what: tasks[task].1.clone(),
            nanoseconds: standing.nanoseconds,
            ratio: standing.ratio.median,
        }));
    }
    Ok(lines)
}
