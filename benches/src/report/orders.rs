//! Reports compositions of order 8 against DOP853 at equal errors.

use super::Section;
use crate::limit::Limit;
use crate::orders::{COMPOSITION, ERROR, HORIZON, Run, runs};
use crate::progress::Progress;
use crate::race::{Effort, race, seconds};
use crate::table::{Table, short};
use kahan_bench_fields::{self as fields, start};

pub(crate) fn orders(effort: Effort) -> (Vec<Section>, Vec<Limit>) {
    let progress = Progress::new(3);
    let mut table = Table::new(&[
        "to the horizon",
        "µs a unit of time",
        "ratio",
        "quartiles",
        "largest error on the way",
    ]);
    let mut limits = Vec::new();
    for system in ["EulerTop", "E6", "LotkaVolterra"] {
        progress.begin(format!("{system}: order 8"));
        let runs: [Run; 2] = match system {
            "EulerTop" => runs(fields::euler_top(), start::SPACE),
            "E6" => runs(fields::E6, start::SPACE),
            _ => runs(fields::LotkaVolterra, start::LOTKA_VOLTERRA),
        };
        let standings =
            race(runs.len(), effort, |i, units| seconds(|| (0..units).for_each(|_| (runs[i].go)())));
        for (run, standing) in runs.iter().zip(&standings) {
            table.push(vec![
                format!("{system}: {}", run.name),
                short(Some(1e-3 * standing.nanoseconds / HORIZON)),
                short(Some(standing.ratio.median)),
                format!("[{:.2}, {:.2}]", standing.ratio.low, standing.ratio.high),
                format!("{:.1e}", run.error),
            ]);
        }
        let figure = format!("{system}: order 8 / DOP853 at an error of {ERROR:.0e}");
        limits.push(Limit::ratio(figure, 1.6, Some(standings[1].ratio.median)));
        progress.advance();
    }
    let text = format!(
        "From t = 0 to {HORIZON}, each at the cheapest setting whose error on the way stays below {ERROR:.0e} of the largest\n\
         component. {} is composed of Kahan's map; DOP853 is that of `ode_solvers`. Above 1 we lose.",
        COMPOSITION.name()
    );
    (vec![Section { title: "Order 8".to_owned(), text, table }], limits)
}
