//! Measurements as sections of a document, each with the limits that it decides.

mod compile;
mod drift;
mod ensembles;
mod journeys;
mod orders;
mod run_time;
mod steps;
mod tiers;

use std::fmt;

use crate::limit::{self, Limit};
use crate::race::Effort;
use crate::table::Table;

pub(crate) use compile::compile;
pub(crate) use drift::drift;
pub(crate) use ensembles::{ensemble_times, ensembles};
pub(crate) use journeys::journeys;
pub(crate) use orders::orders;
pub(crate) use run_time::run_time;
pub(crate) use steps::{step_times, steps};
pub(crate) use tiers::{tier_prices, tiers};

/// A heading, what the table below it means, the table.
pub(crate) struct Section {
    pub(crate) title: String,
    pub(crate) text: String,
    pub(crate) table: Table,
}

impl fmt::Display for Section {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "### {}\n", self.title)?;
        if !self.text.is_empty() {
            writeln!(f, "{}\n", self.text)?;
        }
        write!(f, "{}", self.table)
    }
}

const INTRODUCTION: &str = "\
# Benchmarks

Written by a command, from one run on one machine; every comparison is a ratio formed round by round between things
timed in turns. Times in nanoseconds are the least of all rounds; ratios are medians unless a section says otherwise, with
the quartiles in brackets where they are of use. Below 1 is faster than what stands at 1.00.

```sh
cargo run --release --manifest-path benches/Cargo.toml          # writes this file; `-- --help` for the parts
```

The machine should have nothing else to do. Instructions are counted by valgrind's callgrind, where it is to be had; they
do not depend on the load. The best step by hand is the one of least latency; where another one is shorter, it waits longer,
and its instructions are given for comparison.
";

/// The whole document.
pub(crate) fn document(machine: &str, sections: &[Section], limits: &[Limit], effort: Effort) -> String {
    let sections: Vec<String> = sections.iter().map(Section::to_string).collect();
    format!(
        "{INTRODUCTION}\n## The machine\n\n{machine}- Effort: {} rounds\n\n## What must hold\n\n{}\n## Measurements\n\n{}",
        effort.rounds,
        limit::table(limits),
        sections.join("\n"),
    )
}
