//! Reports the latency of one step, and its number of instructions.

use anyhow::Result;

use super::Section;
use crate::contender::{Contender, Role};
use crate::instructions;
use crate::limit::Limit;
use crate::progress::Progress;
use crate::race::{Effort, Standing, race, seconds};
use crate::rivals::midpoint;
use crate::systems::{STATIC_LU, System};
use crate::table::{Table, short};

struct Row {
    name: &'static str,
    role: Role,
    standing: Option<Standing>,
    instructions: Option<f64>,
}

/// Times the steps of `systems`. Instructions are counted if valgrind is installed.
pub(crate) fn steps(systems: &[System], effort: Option<Effort>) -> Result<(Vec<Section>, Vec<Limit>)> {
    let progress = Progress::new(systems.len());
    let (mut sections, mut limits, mut by_lu) = (Vec::new(), Vec::new(), Vec::new());
    for system in systems {
        progress.begin(system.name);
        let rows = rows(system, effort)?;
        let best = |of: fn(&Row) -> Option<f64>| {
            let values = rows.iter().filter(|row| row.role == Role::ByHand).filter_map(of);
            values.reduce(f64::min)
        };
        let latency = best(|row| Some(row.standing?.ratio.median)).map(f64::recip);
        let fewest = best(|row| row.instructions);
        let of_fastest = fastest_by_hand(&rows).and_then(|row| row.instructions);
        if effort.is_some() {
            limits.push(Limit::ratio(
                format!("{}: latency, generated / best by hand", system.name),
                1.05,
                latency,
            ));
        }
        let over = |count: Option<f64>| Some(rows[0].instructions? / count?);
        let figure = |which| format!("{}: instructions, generated / {which} by hand", system.name);
        if let Some(measured) = over(of_fastest) {
            limits.push(Limit::ratio(figure("fastest"), 1.05, Some(measured)));
        }
        if let Some(measured) = over(fewest) {
            limits.push(Limit::comparison(figure("shortest"), Some(measured)));
        }
        let lu = rows.iter().find(|row| row.name == STATIC_LU).and_then(|row| row.standing);
        by_lu.extend(lu.map(|standing| (system.dimension, standing.ratio.median.recip())));
        sections.push(section(system, &rows));
        progress.advance();
    }
    for (dimension, at_most) in [(3, 1.0 / 4.5), (6, 1.0 / 6.0)] {
        let ratios = by_lu.iter().filter(|(of, _)| *of == dimension).map(|(_, ratio)| *ratio);
        if let Some(worst) = ratios.reduce(f64::max) {
            let figure = format!("N = {dimension}: latency, generated / SMatrix LU, worst system");
            limits.push(Limit::ratio(figure, at_most, Some(worst)));
        }
    }
    Ok((sections, limits))
}

pub(crate) struct StepTimes {
    pub(crate) system: &'static str,
    pub(crate) generated: f64,
    pub(crate) by_hand: f64,
    /// The time of a step by nalgebra's LU decomposition of a matrix of static size.
    pub(crate) lu: f64,
    pub(crate) midpoint: f64,
}

pub(crate) fn step_times(systems: &[System], effort: Effort) -> Vec<StepTimes> {
    let of = |system: &System| {
        let (steps, standings) = (&system.steps, standings(system, effort));
        let least = |belongs: &dyn Fn(&Contender) -> bool| {
            let times = steps.iter().zip(&standings).filter(|(step, _)| belongs(step));
            times.map(|(_, standing)| standing.nanoseconds).fold(f64::INFINITY, f64::min)
        };
        StepTimes {
            system: system.name,
            generated: standings[0].nanoseconds,
            by_hand: least(&|step| step.role == Role::ByHand),
            lu: least(&|step| step.name == STATIC_LU),
            midpoint: least(&|step| step.name == midpoint::NAME),
        }
    };
    systems.iter().map(of).collect()
}

fn fastest_by_hand(rows: &[Row]) -> Option<&Row> {
    let ratio = |row: &Row| row.standing.map_or(f64::NAN, |standing| standing.ratio.median);
    let by_hand = rows.iter().filter(|row| row.role == Role::ByHand && row.standing.is_some());
    by_hand.min_by(|a, b| ratio(a).total_cmp(&ratio(b)))
}

fn standings(system: &System, effort: Effort) -> Vec<Standing> {
    let steps = &system.steps;
    race(steps.len(), effort, |i, units| seconds(|| steps[i].run(units)))
}

fn rows(system: &System, effort: Option<Effort>) -> Result<Vec<Row>> {
    let steps = &system.steps;
    let standings: Vec<Option<Standing>> = match effort {
        Some(effort) => standings(system, effort).into_iter().map(Some).collect(),
        None => vec![None; steps.len()],
    };
    let counted = instructions::can_be_counted();
    let rows = steps.iter().zip(standings).enumerate().map(|(i, (contender, standing))| {
        let instructions = counted.then(|| instructions::per_step(system.name, i)).transpose()?;
        Ok(Row { name: contender.name, role: contender.role, standing, instructions })
    });
    rows.collect()
}

fn section(system: &System, rows: &[Row]) -> Section {
    let mut table = Table::new(&["a step", "ns", "ratio", "quartiles", "instructions", "their ratio"]);
    for row in rows {
        let quartiles =
            row.standing.map(|Standing { ratio, .. }| format!("[{:.2}, {:.2}]", ratio.low, ratio.high));
        let instructions = row.instructions.zip(rows[0].instructions).map(|(count, base)| count / base);
        table.push(vec![
            row.name.to_owned(),
            short(row.standing.map(|standing| standing.nanoseconds)),
            short(row.standing.map(|standing| standing.ratio.median)),
            quartiles.unwrap_or_else(|| short(None)),
            row.instructions.map_or_else(|| "not measured".to_owned(), |count| format!("{count:.1}")),
            short(instructions),
        ]);
    }
    let text = format!(
        "A chain of dependent steps, {} variables. Newton's method ends at an update of {:e}, relative to max(1, |x̃|).",
        system.dimension,
        midpoint::TOLERANCE,
    );
    Section { title: format!("{}: one step", system.name), text, table }
}
