//! A plan: a question over axes, of which field, and what of its rows is written where.
//!
//! In: a text in TOML, and before anything runs all that is wrong with it. Out: a number of points,
//! and the rows of any of them.

mod read;

use std::fmt::Write as _;
use std::ops::Range;
use std::sync::OnceLock;

use kahan_algebra::render::macro_block;
use kahan_study::{Observe, Over, Question, Study, Table, Watch};
use serde_json::{Map, Value, json};
use sha2::{Digest, Sha256};

/// A plan that can be run.
#[derive(Clone, Debug)]
pub struct Plan {
    study: Study,
    /// What is asked over the axes; the last runs fastest, but for the draws.
    question: Question,
    points: u64,
    /// Rows of a part, but for the last.
    rows_per_part: u64,
    /// The places of the columns that are written among all, `None` for all.
    places: Option<Vec<usize>>,
    /// A table that has them, and no rows.
    pub(crate) empty: Table,
    canonical: OnceLock<String>,
}

/// The columns at these places, or all.
fn choose(table: Table, places: Option<&[usize]>) -> Table {
    let Some(places) = places else { return table };
    let columns = places.iter().map(|&place| table.columns[place].clone()).collect();
    Table { columns, values: places.iter().map(|&place| table.values[place].clone()).collect() }
}

impl Plan {
    /// Reads a plan; `origin` is the name of its file, for reports and to find the file of first
    /// points beside it.
    ///
    /// # Errors
    /// All that is wrong with it: each mistake with its line, and what to write instead.
    pub fn read(text: &str, origin: &str) -> Result<Self, String> {
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
        let mut all = Table::default();
        let end = self.study.rows(&self.question, indices, &mut all, watch);
        end.expect("the columns were asked for when the plan was read");
        choose(all, self.places.as_deref())
    }

    /// Returns the plan as JSON in one form, however it was written.
    pub fn canonical(&self) -> &str {
        self.canonical.get_or_init(|| self.to_json().to_string())
    }

    fn to_json(&self) -> Value {
        let mut question = json!(self.question);
        let starts: Vec<String> = self.over().starts.iter().flatten().map(ToString::to_string).collect();
        // A million points would stand in every part.
        let count = self.over().starts.len();
        question["starts"] = match count {
            0 => json!([]),
            _ => json!({"count": count, "sha256": sha256(&starts.join(", "))}),
        };
        let columns: Vec<&str> = self.empty.columns.iter().map(|column| &*column.name).collect();
        let parameters: Map<String, Value> =
            self.study.fixed().iter().map(|(name, value)| (name.clone(), value.to_string().into())).collect();
        json!({
            "subject": {"field": macro_block(self.study.system()), "params": parameters},
            "question": question,
            "output": {"rows_per_part": self.rows_per_part, "columns": columns},
        })
    }

    /// What tells this plan from others: SHA-256 of its [one form](Self::canonical).
    #[must_use]
    pub fn hash(&self) -> String {
        sha256(self.canonical())
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
