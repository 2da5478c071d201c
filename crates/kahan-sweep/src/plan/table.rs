//! A table of TOML whose entries are taken by name; what nobody took was a mistake.

use std::ops::Range;

use kahan_algebra::rational::Rational;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::mistakes::Collector;

/// A value with its place in the text.
pub(super) type Value<'a> = Spanned<DeValue<'a>>;

/// The entries of a table.
pub(super) struct Table<'t, 'a> {
    /// What it is called in reports: `[task]`.
    name: String,
    /// Where it stands.
    pub(super) span: Range<usize>,
    entries: Vec<(&'t str, Range<usize>, &'t Value<'a>)>,
    known: Vec<&'static str>,
}

impl<'t, 'a> Table<'t, 'a> {
    pub(super) fn new(name: impl Into<String>, span: Range<usize>, table: &'t DeTable<'a>) -> Self {
        let entries = table.iter().map(|(key, value)| (key.get_ref().as_ref(), key.span(), value));
        let mut entries: Vec<_> = entries.collect();
        // As they stand in the text.
        entries.sort_by_key(|(_, span, _)| span.start);
        Self { name: name.into(), span, entries, known: Vec::new() }
    }

    /// The value with this name.
    pub(super) fn take(&mut self, name: &'static str) -> Option<&'t Value<'a>> {
        self.known.push(name);
        let place = self.entries.iter().position(|(key, ..)| *key == name)?;
        Some(self.entries.remove(place).2)
    }

    /// All values that were not taken, with their names.
    pub(super) fn rest(&mut self) -> Vec<(&'t str, Range<usize>, &'t Value<'a>)> {
        std::mem::take(&mut self.entries)
    }

    /// The table with this name.
    pub(super) fn table(
        &mut self,
        name: &'static str,
        mistakes: &mut Collector<'_>,
    ) -> Option<Table<'t, 'a>> {
        let value = self.take(name)?;
        match value.get_ref() {
            DeValue::Table(table) => Some(Table::new(format!("[{name}]"), value.span(), table)),
            _ => {
                mistakes
                    .note(&value.span(), format!("`{name}` is a table; write [{name}] on a line of its own"));
                None
            }
        }
    }

    /// Notes every entry that nobody took.
    pub(super) fn finish(self, mistakes: &mut Collector<'_>) {
        for (key, span, _) in &self.entries {
            mistakes.note(span, format!("{} has no `{key}`; it has {}", self.name, self.known.join(", ")));
        }
    }
}

/// An exact number: `3`, `0.1`, `"1/3"`.
pub(super) fn number(value: &Value<'_>, what: &str, mistakes: &mut Collector<'_>) -> Option<Rational> {
    let number = match value.get_ref() {
        // A decimal is what it says, not the double that is near to it.
        DeValue::Integer(_) | DeValue::Float(_) => Rational::typed(mistakes.source(&value.span()).trim()),
        DeValue::String(text) => Rational::typed(text.trim()),
        _ => None,
    };
    if number.is_none() {
        mistakes
            .note(&value.span(), format!("{what} is no exact number; write it as 3, 0.1, 1e-3 or \"1/3\""));
    }
    number
}

/// A whole number between two others.
pub(super) fn whole(
    value: &Value<'_>,
    what: &str,
    (least, most): (u64, u64),
    mistakes: &mut Collector<'_>,
) -> Option<u64> {
    let number = match value.get_ref() {
        DeValue::Integer(_) | DeValue::Float(_) => Rational::typed(mistakes.source(&value.span()).trim()),
        _ => None,
    };
    let count = number.filter(Rational::is_integer).and_then(|number| number.to_string().parse::<u64>().ok());
    let count = count.filter(|count| (least..=most).contains(count));
    if count.is_none() {
        mistakes.note(&value.span(), format!("{what} is a whole number from {least} to {most}"));
    }
    count
}

/// A text.
pub(super) fn text<'t>(value: &'t Value<'_>, what: &str, mistakes: &mut Collector<'_>) -> Option<&'t str> {
    match value.get_ref() {
        DeValue::String(text) => Some(text),
        _ => {
            mistakes.note(&value.span(), format!("{what} is a text; write it in quotation marks"));
            None
        }
    }
}

/// One value, or the values of a list.
pub(super) fn each<'t, 'a>(value: &'t Value<'a>) -> Vec<&'t Value<'a>> {
    match value.get_ref() {
        DeValue::Array(values) => values.iter().collect(),
        _ => vec![value],
    }
}
