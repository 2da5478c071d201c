//! A plan: a field, a question asked at every point of a grid or sample, and the columns to write.
//!
//! A plan is read from a TOML text. Mistakes are reported before anything runs, several at once if
//! possible. The plan determines the number of points, and the rows of any range of points.

mod read;

use std::fmt::Write as _;
use std::ops::Range;
use std::sync::OnceLock;

use kahan_algebra::render::macro_block;
use kahan_study::{Observe, Over, Question, Study, Table, Watch};
use serde_json::{Map, Value, json};
use sha2::{Digest, Sha256};

/// A plan without mistakes.
#[derive(Clone, Debug)]
pub struct Plan {
    study: Study,
    /// The question, asked at every point of the plan.
    question: Question,
    points: u64,
    /// The number of rows of a part; the last part may have fewer.
    rows_per_part: u64,
    /// The indices of the columns to write; `None` for all.
    places: Option<Vec<usize>>,
    /// An empty table with the columns to write.
    pub(crate) empty: Table,
    canonical: OnceLock<String>,
}

fn select_columns(table: Table, places: Option<&[usize]>) -> Table {
    let Some(places) = places else { return table };
    let columns = places.iter().map(|&place| table.columns[place].clone()).collect();
    Table { columns, values: places.iter().map(|&place| table.values[place].clone()).collect() }
}

impl Plan {
    /// Reads a plan; file names in the plan are relative to the path `origin`. Fails with a list of
    /// mistakes, each with its line, a reason and a remedy: the first mistake of each table, or
    /// only the first one if the text is not TOML.
    pub fn read(text: &str, origin: &str) -> Result<Self, String> {
        read::plan(text, origin)
    }

    fn over(&self) -> &Over {
        let Question::Over(over) = &self.question else { unreachable!("a plan goes over axes") };
        over
    }

    /// Returns the number of points.
    #[must_use]
    pub fn points(&self) -> u64 {
        self.points
    }

    /// Returns the number of parts.
    #[must_use]
    pub fn parts(&self) -> u64 {
        self.points().div_ceil(self.rows_per_part)
    }

    pub(crate) fn part(&self, part: u64) -> Range<u64> {
        let first = part * self.rows_per_part;
        first..self.points().min(first + self.rows_per_part)
    }

    /// Returns the smallest and the largest number of rows that a thread computes together. Orbits
    /// of more than 2²⁰ steps run singly, so that an interruption loses little.
    pub(crate) fn at_once(&self) -> [u64; 2] {
        match &*self.over().question {
            Question::Observe(Observe { steps, .. }) if *steps > 1 << 20 => [1, 1],
            Question::Observe(_) => [16, 256],
            _ => [1, 256],
        }
    }

    /// Returns the rows of these points, up to the row at which `watch` stops the work.
    pub(crate) fn rows(&self, indices: Range<u64>, watch: &dyn Watch) -> Table {
        let mut all = Table::default();
        let end = self.study.rows(&self.question, indices, &mut all, watch);
        end.expect("the columns were asked for when the plan was read");
        select_columns(all, self.places.as_deref())
    }

    /// Returns the plan as canonical JSON, which does not depend on the formatting of the TOML.
    pub fn canonical(&self) -> &str {
        self.canonical.get_or_init(|| self.to_json().to_string())
    }

    fn to_json(&self) -> Value {
        let mut question = json!(self.question);
        let starts: Vec<String> = self.over().starts.iter().flatten().map(ToString::to_string).collect();
        // Every part contains this JSON, so a hash replaces the initial states.
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

    /// Returns the SHA-256 of the [canonical form](Self::canonical), which identifies the plan.
    #[must_use]
    pub fn hash(&self) -> String {
        sha256(self.canonical())
    }

    /// Returns the seed of random draws.
    #[must_use]
    pub fn seed(&self) -> u64 {
        self.over().seed
    }
}

fn sha256(text: &str) -> String {
    Sha256::digest(text).iter().fold(String::new(), |mut digits, byte| {
        let _ = write!(digits, "{byte:02x}");
        digits
    })
}
