//! Reads plans, and collects their mistakes.

use std::path::Path;
use std::sync::OnceLock;

use kahan_algebra::rational::Rational;
use kahan_study::columns::{ExpectedColumns, OtherColumns};
use kahan_study::number_file::Numbers;
use kahan_study::{
    AxisValues, Misread, Over, Question, Study, StudyError, Subject, Systems, Table, TomlDocument, Unwatched,
    read,
};
use serde::Deserialize;
use serde_json::{Map, Value};

use super::{Plan, select_columns};
use crate::files::numbers;

const ROWS: u64 = 100_000;
/// The largest number of values in a part, because a part must fit in memory.
const MOST_NUMBERS: u64 = 12_000_000;
/// The largest number of parts, because Parquet counts row groups with 15 bits.
const MOST_PARTS: u64 = 32_767;

const KEYS: [&str; 6] = ["seed", "draws", "starts", "subject", "question", "output"];
/// Old names of tables in a plan, each with its present name.
const RENAMED_TABLES: [(&str, &str); 3] =
    [("system", "[subject]"), ("task", "[question]"), ("axes", "[question.over]")];

pub(super) fn plan(text: &str, origin: &str) -> Result<Plan, String> {
    let at_line = |(line, why): (usize, String)| format!("{origin}:{line}: {why}");
    let document = TomlDocument::parse(text).map_err(at_line)?;
    let mut root = document.to_json().map_err(at_line)?;
    let mut mistakes = Vec::new();
    let plan = read_plan(&mut root, origin, &mut mistakes);
    if mistakes.is_empty() {
        return Ok(plan.expect("where nothing is missing nothing was noted"));
    }
    let lines = mistakes.into_iter().map(|Misread { path, why }| (document.line(&path), why));
    let mut lines: Vec<(usize, String)> = lines.collect();
    lines.sort();
    Err(lines.into_iter().map(at_line).collect::<Vec<_>>().join("\n"))
}

fn mistake(path: &[&str], why: impl Into<String>) -> Misread {
    Misread { path: path.iter().map(|&name| name.to_owned()).collect(), why: why.into() }
}

/// Returns the value that was read, or records the mistake under the name `table`.
fn note<T>(read: Result<T, Misread>, table: &str, mistakes: &mut Vec<Misread>) -> Option<T> {
    read.map_err(|Misread { mut path, why }| {
        let why = path.last().map_or_else(|| why.clone(), |name| format!("{name}: {why}"));
        if path.first().is_none_or(|first| !KEYS[..3].contains(&first.as_str())) {
            path.insert(0, table.to_owned());
        }
        mistakes.push(Misread { path, why });
    })
    .ok()
}

fn read_plan(root: &mut Map<String, Value>, origin: &str, mistakes: &mut Vec<Misread>) -> Option<Plan> {
    for name in root.keys().filter(|name| !KEYS.contains(&name.as_str())) {
        let now = RENAMED_TABLES.iter().find(|(before, _)| before == name);
        let now =
            now.map_or_else(|| format!("it has {}", KEYS.join(", ")), |(_, now)| format!("write {now}"));
        mistakes.push(mistake(&[name], format!("the plan has no `{name}`; {now}")));
    }
    let written = root.remove("subject");
    let subject = match &written {
        Some(written) => note(read::<Subject>(written.clone()), "subject", mistakes),
        None => {
            mistakes
                .push(mistake(&[], "a plan has a [subject], with name = \"e6\" or field = \"xdot = …;\""));
            None
        }
    };
    let output = root.remove("output").map_or(Ok(Output::default()), read);
    let output = note(output, "output", mistakes);
    let has_draws = root.contains_key("draws");
    let file = root.remove("starts");
    let question = question(root, mistakes);
    // A table with an old name was reported above, so no table is reported as missing.
    if RENAMED_TABLES.iter().any(|(before, _)| root.contains_key(*before)) {
        mistakes.retain(|mistake| !mistake.path.is_empty());
    }
    let written = written?;
    let study = subject?.study(&Systems).and_then(|study| study.proved().map(|_| study.clone()));
    let study = study.map_err(|why| mistakes.push(of_subject(&why, &written))).ok()?;
    let (mut over, output) = (question?, output?);
    if let Some(file) = file {
        let points = starts(&file, origin, &study, &over.question);
        over.starts = points.map_err(|why| mistakes.push(mistake(&["starts"], why))).ok()?;
    }
    contradictions(&over, (&written, has_draws), mistakes);
    if !mistakes.is_empty() {
        return None;
    }
    let (points, drifts) = (over.cells(&study), over.has_integrals(&study));
    let question = Question::Over(over);
    let mut empty = Table::default();
    let asked = drifts.and_then(|()| study.rows(&question, 0..0, &mut empty, &Unwatched));
    let points = asked.and(points).map_err(|why| mistakes.push(of_question(&why))).ok()?;
    let places = output.places(&empty, mistakes);
    let empty = select_columns(empty, places.as_deref());
    let rows_per_part = output.rows_per_part;
    let plan = Plan { study, question, points, rows_per_part, places, empty, canonical: OnceLock::new() };
    mistakes.extend(too_large(&plan));
    Some(plan)
}

fn question(root: &mut Map<String, Value>, mistakes: &mut Vec<Misread>) -> Option<Over> {
    let mut question = match root.remove("question") {
        Some(Value::Object(question)) => question,
        Some(_) => {
            let why = "`question` is a table; write [question] on a line of its own";
            mistakes.push(mistake(&["question"], why));
            return None;
        }
        None => {
            let why = format!(
                "a plan has a [question], with ask = \"{}\", and [question.over]",
                Question::OVER_AXES.join("\" or \"")
            );
            mistakes.push(mistake(&[], why));
            return None;
        }
    };
    let several = ["order", "scalar"].map(|name| (name, question.get(name)));
    if let Some((name, _)) = several
        .into_iter()
        .find(|(name, value)| value.is_some_and(|value| value.is_array() || *name == "scalar"))
    {
        mistakes.push(mistake(
            &["question", name],
            format!("`{name}` goes through values: it stands in [question.over]"),
        ));
        return None;
    }
    question.entry("over").or_insert_with(|| Map::new().into());
    for key in ["seed", "draws"] {
        question.extend(root.remove(key).map(|value| (key.to_owned(), value)));
    }
    match note(Question::read(question), "question", mistakes)? {
        Question::Over(mut over) => {
            if let Question::Observe(asked) = &mut *over.question {
                asked.observe = asked.observables();
            }
            Some(over)
        }
        other => {
            let why = format!(
                "`{}` has no rows over axes; there are {}",
                other.name(),
                Question::OVER_AXES.join(", ")
            );
            mistakes.push(mistake(&["question", "ask"], why));
            None
        }
    }
}

/// Records contradictions between the values, axes and random draws of a question.
fn contradictions(over: &Over, (written, has_draws): (&Value, bool), mistakes: &mut Vec<Misread>) {
    for name in written["params"].as_object().into_iter().flat_map(Map::keys) {
        if over.over.iter().any(|axis| axis.name == *name) {
            let why = format!("`{name}` stands under [subject.params], too; leave it out of one");
            mistakes.push(mistake(&["question", "over", name], why));
        }
    }
    match (over.over.iter().any(|axis| matches!(axis.through, AxisValues::Drawn { .. })), has_draws) {
        (true, false) => {
            let why = "axes are drawn; say how many points by draws = 1000 at the top of the plan";
            mistakes.push(mistake(&["question", "over"], why));
        }
        (false, true) => {
            let why = "no axis is drawn; leave `draws` out, or write an axis as { draw = \"sobol\", low = 0, high = 1 }";
            mistakes.push(mistake(&["draws"], why));
        }
        _ => {}
    }
}

/// Converts the error of an invalid subject to a mistake at the key that causes it.
fn of_subject(why: &StudyError, written: &Value) -> Misread {
    let said = why.to_string();
    let said = said.trim_start_matches("error: ").trim_end();
    match why {
        StudyError::UnknownParameter { name, .. } => mistake(&["subject", "params", name], said),
        _ if written.get("name").is_some() => mistake(&["subject", "name"], said),
        _ => mistake(&["subject", "field"], said),
    }
}

/// Converts the error of an invalid question to a mistake at the key that causes it.
fn of_question(why: &StudyError) -> Misread {
    match why {
        StudyError::UnknownAxis { name, .. }
        | StudyError::AxisValues { name, .. }
        | StudyError::AxisTwice { name } => mistake(&["question", "over", name], why.to_string()),
        StudyError::NoIntegral { .. } => mistake(&["question", "observe"], format!("observe: {why}")),
        _ => mistake(&["question"], why.to_string()),
    }
}

/// Reads the initial states from a file; its path is relative to the folder of the plan.
fn starts(file: &Value, origin: &str, study: &Study, asked: &Question) -> Result<Vec<Vec<Rational>>, String> {
    if matches!(asked, Question::Discover(_)) {
        return Err("starts: \"discover\" has none; leave `starts` out".to_owned());
    }
    let name = file.as_str().ok_or("starts is the name of a file, in quotation marks")?;
    let path = Path::new(origin).with_file_name(name);
    let variables = study.variables();
    let read = match path.extension().and_then(|ending| ending.to_str()) {
        Some("parquet") => numbers(&path, variables),
        Some("csv" | "npy") => {
            let bytes = std::fs::read(&path).map_err(|error| error.to_string());
            let read = bytes.and_then(|bytes| Numbers::of(name, &bytes));
            read.map_err(|why| format!("cannot be read: {why}"))
        }
        _ => Err("is none of F.parquet, F.csv and F.npy".to_owned()),
    };
    // Columns of parameters and ε are ignored, because the plan gives their values.
    let wanted = ExpectedColumns::new(variables, study.parameters(), OtherColumns::Ignored);
    let points = read.and_then(|numbers| numbers.points(&wanted));
    points.map_err(|why| format!("starts: {} {why}", path.display()))
}

#[derive(Deserialize)]
#[serde(default, deny_unknown_fields)]
struct Output {
    rows_per_part: u64,
    columns: Option<Vec<String>>,
}

impl Default for Output {
    fn default() -> Self {
        Output { rows_per_part: ROWS, columns: None }
    }
}

impl Output {
    fn places(&self, all: &Table, mistakes: &mut Vec<Misread>) -> Option<Vec<usize>> {
        let columns = self.columns.as_ref()?;
        if columns.is_empty() {
            let why = "columns: there are none; name at least one, or leave `columns` out for all";
            mistakes.push(mistake(&["output", "columns"], why));
        }
        let mut places = Vec::new();
        for (k, name) in columns.iter().enumerate() {
            match all.columns.iter().position(|column| column.name == *name) {
                Some(place) => places.push(place),
                None => {
                    let known: Vec<&str> = all.columns.iter().map(|column| &*column.name).collect();
                    let why = format!("there is no column `{name}`; there is {}", known.join(", "));
                    mistakes.push(mistake(&["output", "columns", &k.to_string()], why));
                }
            }
        }
        Some(places)
    }
}

/// Returns a mistake if a part needs too much memory, or if there are too many parts.
fn too_large(plan: &Plan) -> Option<Misread> {
    let columns = plan.empty.columns.len() as u64;
    let most = MOST_NUMBERS / columns.max(1);
    let rows = plan.rows_per_part;
    let why = if rows == 0 {
        "rows_per_part is 1 or more".to_owned()
    } else if rows > MOST_NUMBERS || rows.min(plan.points()) > most {
        format!("rows_per_part is at most {most} with {columns} columns, so that a part fits into memory")
    } else if plan.parts() > MOST_PARTS {
        let (parts, least) = (plan.parts(), plan.points().div_ceil(MOST_PARTS));
        let advice = if least <= most {
            format!("write [output] rows_per_part = {least} or more")
        } else {
            format!("a sweep of {columns} columns has at most {} points", most.saturating_mul(MOST_PARTS))
        };
        format!("{parts} parts are too many for one file, which has at most {MOST_PARTS}; {advice}")
    } else {
        return None;
    };
    Some(mistake(&["output", "rows_per_part"], why))
}
