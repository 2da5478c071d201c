//! The table of orbits: where it goes, and what becomes of an orbit that ends early.
//!
//! In: what is known before the first row, and who hands on the rows of each orbit. Out: the table,
//! and an answer that says why orbits ended. What a step is, this module must not know.

use std::ops::ControlFlow;
use std::time::Duration;

use kahan_study::{End, Progress, Unwatched, Watch};
use serde_json::{Map, Value, json};

use super::Orbit;
use super::chain::is_array;
use crate::printing::{Answer, Broken, Format, Prompt, Refusal, Sink, Table, has_room_for_progress};

/// The prompt, as one of several orbits sees it.
struct OneOrbit<'a> {
    prompt: &'a Prompt,
    /// The steps of those before.
    before: u64,
}

impl Watch for OneOrbit<'_> {
    fn now(&self) -> Option<Duration> {
        self.prompt.now()
    }

    fn look(&self, progress: &Progress<'_>) -> ControlFlow<()> {
        self.prompt.look(&Progress { done: self.before + progress.done, ..*progress })
    }
}

impl Orbit {
    /// Opens the table, lets it be filled orbit by orbit, closes it.
    pub(super) fn write<O>(
        &self,
        head: Value,
        orbits: Vec<O>,
        fill: impl FnMut(O, &mut Table, &dyn Watch) -> Result<End, Broken>,
    ) -> Result<Answer, Refusal> {
        let Value::Object(mut head) = head else { unreachable!("a head is an object") };
        if orbits.len() > 1 {
            let columns = head["columns"].as_array_mut().expect("columns have names");
            let names: Vec<&str> = columns.iter().filter_map(Value::as_str).collect();
            columns.insert(0, json!(kahan_study::free_name(&names, "orbit")));
        }
        let file = self.out.as_deref().filter(|path| !is_array(path));
        let sink = file.map_or_else(|| Ok(Sink::standard()), Sink::table)?;
        let steps = self.steps.saturating_mul(orbits.len() as u64);
        let prompt = has_room_for_progress(file.is_some()).then(|| Prompt::new(steps, "steps"));
        let written = self.write_into(sink, &head, orbits, prompt.as_ref(), fill);
        prompt.iter().for_each(Prompt::finish);
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
                head.insert("out".to_owned(), json!(path.display().to_string()));
                head.insert("stopped".to_owned(), stopped(&stops));
                Answer::json(&Value::Object(head))
            }
            _ => Answer::text(String::new()),
        };
        Ok(Answer { complaint: complaint(&stops), ..answer })
    }

    /// Why orbits ended early.
    fn write_into<O>(
        &self,
        sink: Sink,
        head: &Map<String, Value>,
        orbits: Vec<O>,
        prompt: Option<&Prompt>,
        mut fill: impl FnMut(O, &mut Table, &dyn Watch) -> Result<End, Broken>,
    ) -> Result<Vec<Option<String>>, Broken> {
        let format = if self.json && sink.is_standard() { Format::Json } else { Format::Csv };
        let mut table = Table::begin(sink, format, head)?;
        let mut stops = Vec::new();
        let are_several = orbits.len() > 1;
        for (index, orbit) in orbits.into_iter().enumerate() {
            if are_several {
                table.begin_orbit(index);
            }
            let before = self.steps.saturating_mul(index as u64);
            let watch = prompt.map(|prompt| OneOrbit { prompt, before });
            let end = match &watch {
                Some(watch) => fill(orbit, &mut table, watch),
                None => fill(orbit, &mut table, &Unwatched),
            }?;
            table.written()?;
            stops.push(end.last().map(|last| last.why.replace("; try ", "; try --")));
        }
        table.end(&stopped(&stops))?;
        Ok(stops)
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
