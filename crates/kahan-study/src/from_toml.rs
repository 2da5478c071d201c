//! Reads questions and subjects from TOML, with the names and values of the JSON form.

use std::ops::Range;

use serde::de::DeserializeOwned;
use serde_json::{Map, Number, Value};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::misread;

/// Reads a [`Question`](crate::Question), a [`Subject`](crate::Subject) or another value from
/// TOML. Decimals are exact: 0.1 is one tenth.
///
/// ```
/// use kahan_study::{Question, Subject, Systems, Unwatched, from_toml};
///
/// let subject: Subject = from_toml("name = 'e7'\nparams = { xi = 0.1 }").unwrap();
/// let question: Question = from_toml("ask = 'evaluate'\neps = 0.1\nat = [1, '2/3', -3]").unwrap();
/// assert!(subject.study(&Systems).unwrap().ask(&question, &Unwatched).is_ok());
/// ```
///
/// The error is a sentence about a mistake in TOML, with the line, or about a mistake in a value.
pub fn from_toml<T: DeserializeOwned>(text: &str) -> Result<T, String> {
    let document = TomlDocument::parse(text);
    let object = document.and_then(|document| document.to_json());
    let object = object.map_err(|(line, why)| format!("line {line}: {why}"))?;
    misread::read(Value::Object(object)).map_err(|mistake| mistake.to_string())
}

/// A text in TOML with the line of each value.
#[derive(Debug)]
pub struct TomlDocument<'t> {
    text: &'t str,
    root: Spanned<DeTable<'t>>,
}

/// A mistake with its line, counted from 1.
type MistakeAtLine = (usize, String);

impl<'t> TomlDocument<'t> {
    /// Parses a text, or returns the first mistake in the grammar of TOML.
    pub fn parse(text: &'t str) -> Result<Self, MistakeAtLine> {
        let root = DeTable::parse(text).map_err(|mistake| {
            (line_of(text, mistake.span().unwrap_or_default()), mistake.message().to_owned())
        })?;
        Ok(TomlDocument { text, root })
    }

    /// Converts the document to a JSON object, in the order of the text. Fails if JSON cannot
    /// represent a value.
    pub fn to_json(&self) -> Result<Map<String, Value>, MistakeAtLine> {
        of_table(self.root.get_ref()).map_err(|(span, why)| (line_of(self.text, span), why))
    }

    /// Follows keys and indices to the last value that exists, and returns its line (from 1).
    #[must_use]
    pub fn line(&self, path: &[String]) -> usize {
        let place = in_table(self.root.get_ref(), path);
        line_of(self.text, place.unwrap_or_else(|| self.root.span()))
    }
}

/// Returns the byte span of the last value that exists along a path of keys and indices.
fn in_table(table: &DeTable<'_>, path: &[String]) -> Option<Range<usize>> {
    let (name, rest) = path.split_first()?;
    let (key, value) = table.iter().find(|(key, _)| key.get_ref() == name)?;
    Some(inside(value, rest).unwrap_or_else(|| key.span()))
}

fn inside(value: &Spanned<DeValue<'_>>, path: &[String]) -> Option<Range<usize>> {
    match value.get_ref() {
        DeValue::Table(table) => in_table(table, path),
        DeValue::Array(list) => {
            let (place, rest) = path.split_first()?;
            let value = list.get(place.parse::<usize>().ok()?)?;
            Some(inside(value, rest).unwrap_or_else(|| value.span()))
        }
        _ => None,
    }
}

fn line_of(text: &str, span: Range<usize>) -> usize {
    let before = &text.as_bytes()[..span.start.min(text.len())];
    1 + before.iter().filter(|&&byte| byte == b'\n').count()
}

/// The reason why JSON cannot represent a value, with the value's byte span.
type NoJson = (Range<usize>, String);

fn of_table(table: &DeTable<'_>) -> Result<Map<String, Value>, NoJson> {
    let mut entries: Vec<_> = table.iter().collect();
    entries.sort_by_key(|(key, _)| key.span().start);
    entries.into_iter().map(|(key, value)| Ok((key.get_ref().to_string(), json(value)?))).collect()
}

fn json(value: &Spanned<DeValue<'_>>) -> Result<Value, NoJson> {
    let refused = |why: String| (value.span(), why);
    Ok(match value.get_ref() {
        DeValue::String(text) => Value::String(text.to_string()),
        DeValue::Integer(whole) if whole.radix() == 10 => number(whole.as_str()).map_err(refused)?,
        DeValue::Integer(whole) => match u64::from_str_radix(whole.as_str(), whole.radix()) {
            Ok(number) => Value::from(number),
            Err(_) => return Err(refused(format!("`{whole}` is too large"))),
        },
        DeValue::Float(float) => number(float.as_str()).map_err(refused)?,
        DeValue::Boolean(flag) => Value::Bool(*flag),
        DeValue::Datetime(date) => {
            return Err(refused(format!("`{date}` is a date, for which nothing asks")));
        }
        DeValue::Array(values) => values.iter().map(json).collect::<Result<_, _>>()?,
        DeValue::Table(table) => Value::Object(of_table(table)?),
    })
}

fn number(text: &str) -> Result<Value, String> {
    let number = text.trim_start_matches('+').parse::<Number>();
    number.map(Value::Number).map_err(|_| format!("`{text}` is no finite number"))
}
