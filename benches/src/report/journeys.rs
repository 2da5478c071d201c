//! Reports integrations: the computing time per unit of simulated time, and the final error.

use super::Section;
use crate::journey::{REFERENCE, SPAN, STEP, TOLERANCE};
use crate::limit::Limit;
use crate::progress::Progress;
use crate::race::{Effort, race, seconds};
use crate::systems::System;
use crate::table::{Table, short};

pub(crate) fn journeys(systems: &[System], effort: Effort) -> (Vec<Section>, Vec<Limit>) {
    let progress = Progress::new(systems.len());
    let mut table = Table::new(&["orbit", "ns a unit of time", "ratio", "quartiles", "error at the end"]);
    for system in systems {
        progress.begin(format!("{}: orbits", system.name));
        let (reference, timed): (Vec<_>, Vec<_>) =
            system.journeys.iter().partition(|journey| journey.name == REFERENCE);
        let flow = reference.first().map(|journey| journey.end()).unwrap_or_default();
        let size = flow.iter().map(|x| x.abs()).fold(0.0, f64::max);
        let standings = race(timed.len(), effort, |i, units| {
            seconds(|| {
                for _ in 0..units {
                    std::hint::black_box(timed[i].end());
                }
            })
        });
        for (journey, standing) in timed.iter().zip(standings) {
            let error =
                journey.end().iter().zip(&flow).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max) / size;
            table.push(vec![
                format!("{}: {}", system.name, journey.name),
                short(Some(standing.nanoseconds / SPAN)),
                short(Some(standing.ratio.median)),
                format!("[{:.2}, {:.2}]", standing.ratio.low, standing.ratio.high),
                format!("{error:.0e}"),
            ]);
        }
        progress.advance();
    }
    let text = format!(
        "From t = 0 to {SPAN}: fixed steps of {STEP}, both tolerances of the controlled ones {TOLERANCE:e}. The error is the\n\
         largest of a component over the largest component, against DOP853 at 1e-14. Kahan's map is of order 2: it never wins\n\
         on the error of an orbit; it is chosen for integrals that it keeps exactly. Lorenz is chaotic, its errors grow by\n\
         e^{{0.9 t}}."
    );
    (vec![Section { title: "Orbits".to_owned(), text, table }], Vec::new())
}
