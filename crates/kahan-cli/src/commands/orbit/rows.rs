//! The table of orbits: which points become rows, how a table is filled orbit by orbit, and what
//! becomes of an orbit that ends early.
//!
//! In: what is known before the first row, and orbits that advance and write their points. Out: the
//! table, and an answer that says why orbits ended. What a step is, this module must not know.

use serde_json::{Map, Value, json};

use super::Orbit;
use super::chain::is_array;
use crate::printing::{Answer, Broken, Format, Prompt, Refusal, Sink, Table, has_room_for_progress};

/// Which points become rows.
pub(super) struct Rows<'a> {
    steps: i64,
    every: i64,
    progress: Option<&'a Prompt>,
}

/// Steps of floats between two looks: some hundredths of a second.
pub(super) const AT_ONCE: i64 = 1 << 20;

impl Rows<'_> {
    /// Steps from row to row, at most so many `at_once` between two looks at the orbit; what to
    /// tell the user where a step has no value.
    pub(super) fn follow<O>(
        &self,
        orbit: &mut O,
        at_once: i64,
        mut row: impl FnMut(&mut O, i64) -> Result<(), Broken>,
        mut advance: impl FnMut(&mut O, i64, i64) -> Result<(), String>,
    ) -> Result<Option<String>, Broken> {
        let mut n = 0;
        loop {
            let since = n % self.every;
            if since == 0 {
                row(orbit, n)?;
            }
            let steps = (self.every - since).min(self.steps - n).min(at_once);
            if steps == 0 {
                return Ok(None);
            }
            if let Err(why) = advance(orbit, n, steps) {
                return Ok(Some(why));
            }
            n += steps;
            if let Some(progress) = self.progress {
                progress.advance(steps.unsigned_abs());
            }
        }
    }
}

impl Orbit {
    /// Opens the table, lets it be filled orbit by orbit (why an orbit ended early comes back),
    /// closes it.
    pub(super) fn write<O>(
        &self,
        head: Map<String, Value>,
        orbits: impl IntoIterator<Item = O, IntoIter: ExactSizeIterator>,
        mut fill: impl FnMut(O, &Rows<'_>, &mut Table) -> Result<Option<String>, Broken>,
    ) -> Result<Answer, Refusal> {
        let orbits = orbits.into_iter();
        let count = orbits.len();
        let file = self.out.as_deref().filter(|path| !is_array(path));
        let sink = match file {
            Some(path) => Sink::file(path, "--out")?,
            None => Sink::standard(),
        };
        let format = if self.json && file.is_none() { Format::Json } else { Format::Csv };
        let mut table = Table::new(sink, format);
        let steps = self.steps.unsigned_abs().saturating_mul(count as u64);
        let progress = has_room_for_progress(file.is_some()).then(|| Prompt::new(steps, "steps"));
        let rows = Rows { steps: self.steps, every: self.every, progress: progress.as_ref() };
        let written = table.begin(&head).and_then(|()| {
            let mut stops = Vec::new();
            for (index, orbit) in orbits.enumerate() {
                if count > 1 {
                    table.begin_orbit(index);
                }
                stops.push(fill(orbit, &rows, &mut table)?);
            }
            table.end(&stopped(&stops))?;
            Ok(stops)
        });
        if let Some(progress) = progress {
            progress.finish();
        }
        let stops = match written {
            Ok(stops) => stops,
            // Nobody wants more rows, which is no error.
            Err(Broken::ReaderGone) => Vec::new(),
            Err(Broken::Failed(why)) => {
                return Ok(Answer { complaint: Some(why), ..Answer::text(String::new()) });
            }
        };
        // With rows in a file, the object that describes them is the answer.
        let answer = match file {
            Some(path) if self.json => {
                let mut object = head;
                object.insert("out".to_owned(), json!(path.display().to_string()));
                object.insert("stopped".to_owned(), stopped(&stops));
                Answer::json(&Value::Object(object))
            }
            _ => Answer::text(String::new()),
        };
        Ok(Answer { complaint: complaint(&stops), ..answer })
    }
}

/// Why orbits ended early, as it stands in an object: of one orbit a sentence or null, of several a
/// list of these.
fn stopped(stops: &[Option<String>]) -> Value {
    match stops {
        [] => Value::Null,
        [stop] => json!(stop),
        stops => json!(stops),
    }
}

/// The same for standard error: of several orbits, how many ended early, and why the first of them.
fn complaint(stops: &[Option<String>]) -> Option<String> {
    let mut early = stops.iter().enumerate().filter_map(|(orbit, why)| Some((orbit, why.as_ref()?)));
    let (orbit, why) = early.next()?;
    Some(match stops.len() {
        1 => why.clone(),
        count => {
            format!(
                "{} of {count} orbits end early, the first of them is orbit {orbit}: {why}",
                1 + early.count()
            )
        }
    })
}

/// The names of all columns: n and t, and before them orbit where there are several orbits, with a
/// `_` behind them where a variable or an integral has that name.
pub(super) fn columns(states: &[String], integrals: &[String], orbits: usize) -> Vec<String> {
    let named: Vec<String> = states.iter().chain(integrals).cloned().collect();
    let free = |name: &str| {
        let mut name = name.to_owned();
        while named.contains(&name) {
            name.push('_');
        }
        name
    };
    let counted: &[&str] = if orbits > 1 { &["orbit", "n", "t"] } else { &["n", "t"] };
    counted.iter().map(|name| free(name)).chain(named.iter().cloned()).collect()
}
