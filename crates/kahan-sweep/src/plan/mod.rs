//! A plan: a question over axes, of which field, and what of its rows is written where.
//!
//! In: a text in TOML, and before anything runs all that is wrong with it. Out: a number of points,
//! and the rows of any of them.

mod mistakes;
mod read;
mod table;

use std::fmt::Write as _;
use std::ops::{ControlFlow, Range};

use kahan_algebra::rational::Rational;
use kahan_algebra::render::macro_block;
use kahan_study::{
    Column, Observe, Over, Question, Rows, Source, Study, Table, Through, Values, Varied, Watch,
};
use sha2::{Digest, Sha256};

pub use mistakes::{Mistake, Mistakes};

/// A plan that can be run.
#[derive(Clone, Debug)]
pub struct Plan {
    study: Study,
    /// `[system.params]`, in the order of the plan.
    fixed: Vec<(String, Rational)>,
    /// The line of the plan's one form that tells first points from a file from others.
    starts: String,
    /// What is asked over the axes; the last runs fastest, but for the draws.
    question: Question,
    points: u64,
    /// Rows of a part, but for the last.
    rows_per_part: u64,
    /// Which columns are written, `None` for all.
    columns: Option<Vec<String>>,
    /// Their places among all.
    places: Vec<usize>,
    /// A table that has them, and no rows.
    pub(crate) empty: Table,
}

/// Takes some of the columns.
struct Chosen<'a> {
    places: &'a [usize],
    table: Table,
}

impl Rows for Chosen<'_> {
    fn block(&mut self, columns: &[Column], values: &[Values<'_>]) -> ControlFlow<()> {
        let columns: Vec<Column> = self.places.iter().map(|&place| columns[place].clone()).collect();
        let values: Vec<Values<'_>> = self.places.iter().map(|&place| values[place]).collect();
        self.table.block(&columns, &values)
    }
}

impl Plan {
    /// Reads a plan; `origin` is the name of its file, for reports and to find the file of first
    /// points beside it.
    ///
    /// # Errors
    /// All that is wrong with it.
    pub fn read(text: &str, origin: &str) -> Result<Self, Mistakes> {
        read::plan(text, origin)
    }

    fn over(&self) -> &Over {
        let Question::Over(over) = &self.question else { unreachable!("a plan goes over axes") };
        over
    }

    /// How many points it has.
    #[must_use]
    pub fn points(&self) -> u64 {
        self.points
    }

    /// How many parts it is written in.
    #[must_use]
    pub fn parts(&self) -> u64 {
        self.points().div_ceil(self.rows_per_part)
    }

    /// The points of a part.
    pub(crate) fn part(&self, part: u64) -> Range<u64> {
        let first = part * self.rows_per_part;
        first..self.points().min(first + self.rows_per_part)
    }

    /// The fewest and the most rows that a thread should take at once: orbits fill registers,
    /// unless they are so long that too much would be lost with a process that ends.
    pub(crate) fn at_once(&self) -> [u64; 2] {
        match &*self.over().question {
            Question::Observe(Observe { steps, .. }) if *steps > 1 << 20 => [1, 1],
            Question::Observe(_) => [16, 256],
            _ => [1, 256],
        }
    }

    /// The rows of these points, as far as they were made before the watch ended it.
    pub(crate) fn rows(&self, indices: Range<u64>, watch: &dyn Watch) -> Table {
        let mut chosen = Chosen { places: &self.places, table: Table::default() };
        let end = self.study.rows(&self.question, indices, &mut chosen, watch);
        end.expect("the columns were asked for when the plan was read");
        chosen.table
    }

    /// The plan in one form, however it was written.
    #[must_use]
    pub fn canonical(&self) -> String {
        let mut text = format!("{}\n", macro_block(self.study.system()));
        for (name, value) in &self.fixed {
            let _ = writeln!(text, "{name} = [{value}]");
        }
        text.push_str(&self.starts);
        let over = self.over();
        for Varied { name, through } in &over.axes {
            let _ = match through {
                Through::List(values) => {
                    let values: Vec<String> = values.iter().map(ToString::to_string).collect();
                    writeln!(text, "{name} = [{}]", values.join(", "))
                }
                Through::Range(range) => {
                    let (count, from, step) = (range.count(), range.value(0), range.step());
                    writeln!(text, "{name} = {count} values from {from}, {step} apart")
                }
                Through::Drawn { source: Source::Sobol, low, high } => {
                    writeln!(text, "{name} = sobol from {low} to {high}")
                }
                Through::Drawn { source: Source::Uniform, low, high } => {
                    writeln!(text, "{name} = uniform from {low} to {high}")
                }
            };
        }
        let _ = writeln!(text, "draws = {}\nseed = {}", over.draws, over.seed);
        // In the words of the first version, so that what was computed goes on.
        let _ = match &*over.question {
            Question::Observe(Observe { steps, every, escape, of, .. }) => writeln!(
                text,
                "Orbit {{ steps: {steps}, every: {every}, escape: {escape:?}, observe: {of:?} }}"
            ),
            Question::Heights(asked) => {
                writeln!(text, "Heights(Heights {{ steps: {}, digits: {} }})", asked.steps, asked.max_digits)
            }
            Question::Discover(asked) => writeln!(text, "Search(Search {{ degree: {:?} }})", asked.degree),
            other => unreachable!("no plan asks {}", other.name()),
        };
        let _ = writeln!(text, "rows_per_part = {}", self.rows_per_part);
        let columns = self.columns.as_ref().map_or("all".to_owned(), |columns| columns.join(", "));
        let _ = writeln!(text, "columns = {columns}");
        text
    }

    /// What tells this plan from others: SHA-256 of its [one form](Self::canonical).
    #[must_use]
    pub fn hash(&self) -> String {
        sha256(&self.canonical())
    }

    /// The seed of what is drawn.
    #[must_use]
    pub fn seed(&self) -> u64 {
        self.over().seed
    }
}

/// SHA-256 of a text, in hexadecimal digits.
fn sha256(text: &str) -> String {
    Sha256::digest(text).iter().fold(String::new(), |mut digits, byte| {
        let _ = write!(digits, "{byte:02x}");
        digits
    })
}
