//! Writes tables of orbits, and reports how the orbits end.

use kahan_study::{Ending, StoredColumn};
use serde_json::{Map, Value, json};

use super::{Orbit, is_array};
use crate::printing::{Answer, Format, OutputStream, ProgressDisplay, Table, UsageError, WriteError, warn};
use crate::reading::option;

impl Orbit {
    /// Writes a table, orbit by orbit. `places` names the columns that identify an orbit.
    pub(super) fn write<O>(
        &self,
        head: Value,
        places: &[String],
        orbits: impl ExactSizeIterator<Item = (Vec<StoredColumn>, O)>,
        fill: impl FnMut(O, &mut Table, &ProgressDisplay) -> Result<Ending, WriteError>,
    ) -> Result<Answer, UsageError> {
        let Value::Object(mut head) = head else { unreachable!("a head is an object") };
        let columns = head["columns"].as_array_mut().expect("columns have names");
        let names: Vec<String> = columns.iter().filter_map(Value::as_str).map(str::to_owned).collect();
        columns.splice(0..0, places.iter().map(|place| json!(kahan_study::free_name(&names, place))));
        let file = self.out.as_deref().filter(|path| !is_array(path));
        let sink = file.map_or_else(|| Ok(OutputStream::standard()), OutputStream::table)?;
        let stops = match self.write_into(sink, &head, orbits, fill) {
            Ok(stops) => stops,
            // If the reader closes the pipe, the table ends without an error.
            Err(WriteError::ReaderGone) => Vec::new(),
            Err(failed) => return Err(failed.into()),
        };
        let answer = match file {
            Some(path) if self.json => {
                head.insert("out".to_owned(), json!(path.display().to_string()));
                head.extend(ended(&stops));
                Answer::json(&Value::Object(head))
            }
            _ => Answer::text(String::new()),
        };
        if let Some(note) = stops.iter().find_map(|ending| ending.note.as_ref()) {
            warn(&format!("{note}; `kahan trade` measures which eps resolves them"));
        }
        Ok(answer.with_complaint(complaint(&stops)))
    }

    fn write_into<O>(
        &self,
        sink: OutputStream,
        head: &Map<String, Value>,
        orbits: impl ExactSizeIterator<Item = (Vec<StoredColumn>, O)>,
        mut fill: impl FnMut(O, &mut Table, &ProgressDisplay) -> Result<Ending, WriteError>,
    ) -> Result<Vec<Ending>, WriteError> {
        let steps = self.before.transient.saturating_add(self.steps);
        let prompt =
            ProgressDisplay::beside_rows(!sink.is_standard(), steps.saturating_mul(orbits.len() as u64));
        let format = if self.json && sink.is_standard() { Format::Json } else { Format::Csv };
        let mut table = Table::begin(sink, format, head)?;
        let mut stops = Vec::new();
        for (place, orbit) in orbits {
            table.begin_orbit(place);
            let ending = fill(orbit, &mut table, &prompt)?;
            table.written()?;
            prompt.show_steps(steps);
            stops.push(ending);
        }
        table.end(&ended(&stops))?;
        Ok(stops)
    }
}

/// Returns the JSON members that say how orbits ended. For several orbits, each member is a list.
fn ended(endings: &[Ending]) -> Map<String, Value> {
    let of_all = |value: fn(&Ending) -> Value| match endings {
        [] => Value::Null,
        [one] => value(one),
        all => all.iter().map(value).collect(),
    };
    let mut entries = vec![
        ("ended", of_all(|ending| json!(ending.end.name()))),
        ("ended_step", of_all(|ending| json!(ending.step))),
        ("stopped", of_all(|ending| json!(ending.in_words(option)))),
    ];
    if endings.iter().any(|ending| ending.note.is_some()) {
        entries.push(("note", of_all(|ending| json!(ending.note))));
    }
    entries.into_iter().map(|(name, value)| (name.to_owned(), value)).collect()
}

/// Says how many orbits ended early, and why the first of them ended; `None` if none did.
fn complaint(endings: &[Ending]) -> Option<String> {
    let early = endings.iter().enumerate();
    let mut early = early.filter_map(|(orbit, ending)| Some((orbit, ending.in_words(option)?)));
    let (orbit, why) = early.next()?;
    Some(match endings.len() {
        1 => why,
        count => format!(
            "{} of {count} orbits end early, the first of them is orbit {orbit}: {why}",
            1 + early.count()
        ),
    })
}
