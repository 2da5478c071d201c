//! A table of TOML whose entries are taken by name; what nobody took was a mistake.
//!
//! A value that is not what it should be is noted where it stands, and is then none: the plan is
//! refused in the end, and whatever was read in its place goes with it.

use std::ops::{Range, RangeInclusive};

use kahan_algebra::rational::Rational;
use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue};

use super::mistakes::Collector;

/// A value with its name and its place in the text.
#[derive(Clone, Copy)]
pub(super) struct Given<'t> {
    key: &'t Spanned<DeString<'t>>,
    value: &'t Spanned<DeValue<'t>>,
    mistakes: &'t Collector<'t>,
}

impl<'t> Given<'t> {
    pub(super) fn name(&self) -> &'t str {
        self.key.get_ref()
    }

    /// Notes what is wrong with it.
    pub(super) fn note(&self, message: impl Into<String>) {
        self.mistakes.note(&self.value.span(), message);
    }

    fn expect<T>(&self, found: Option<T>, what: &str) -> Option<T> {
        if found.is_none() {
            self.note(format!("{} is {what}", self.name()));
        }
        found
    }

    /// An exact number: `3`, `0.1`, `"1/3"`.
    pub(super) fn number(&self) -> Option<Rational> {
        let number = match self.value.get_ref() {
            DeValue::String(text) => Rational::parse(text.trim()),
            _ => self.as_it_stands(),
        };
        self.expect(number, "no exact number; write it as 3, 0.1, 1e-3 or \"1/3\"")
    }

    /// A whole number within these bounds.
    pub(super) fn whole(&self, bounds: RangeInclusive<u64>) -> Option<u64> {
        let number = self.as_it_stands().filter(Rational::is_integer);
        let count = number.and_then(|number| number.to_string().parse().ok());
        let (least, most) = (bounds.start(), bounds.end());
        self.expect(
            count.filter(|count| bounds.contains(count)),
            &format!("a whole number from {least} to {most}"),
        )
    }

    /// A decimal as what it says, not as the double that is near to it.
    fn as_it_stands(&self) -> Option<Rational> {
        let is_number = matches!(self.value.get_ref(), DeValue::Integer(_) | DeValue::Float(_));
        is_number.then(|| Rational::parse(self.mistakes.source(self.value.span()).trim())).flatten()
    }

    /// A text.
    pub(super) fn text(&self) -> Option<&'t str> {
        self.expect(self.value.get_ref().as_str(), "a text; write it in quotation marks")
    }

    /// What has this name among those that are known; `no` begins the sentence where none has it.
    pub(super) fn one_of<T: Clone>(&self, no: &str, known: &[(&str, T)]) -> Option<T> {
        let text = self.text()?;
        let found = known.iter().find(|(name, _)| *name == text);
        if found.is_none() {
            let known: Vec<&str> = known.iter().map(|(name, _)| *name).collect();
            self.note(format!("{no} `{text}`; there is {}", known.join(", ")));
        }
        found.map(|(_, found)| found.clone())
    }

    /// Itself, or the values of a list.
    pub(super) fn each(self) -> Vec<Self> {
        match self.value.get_ref() {
            DeValue::Array(values) => values.iter().map(|value| Given { value, ..self }).collect(),
            _ => vec![self],
        }
    }

    /// The entries of a table, which has this name in reports; `None` where it is none.
    pub(super) fn table(&self, name: impl Into<String>) -> Option<Table<'t>> {
        let table = self.value.get_ref().as_table()?;
        Some(Table::new(name, self.value.span(), table, self.mistakes))
    }

    /// The entries of a table of the plan's own: `[task]`.
    pub(super) fn section(self) -> Option<Table<'t>> {
        let name = self.name();
        let table = self.table(format!("[{name}]"));
        if table.is_none() {
            self.note(format!("`{name}` is a table; write [{name}] on a line of its own"));
        }
        table
    }
}

/// The entries of a table.
pub(super) struct Table<'t> {
    /// What it is called in reports: `[task]`.
    name: String,
    span: Range<usize>,
    entries: Vec<Given<'t>>,
    known: Vec<&'static str>,
    mistakes: &'t Collector<'t>,
}

impl<'t> Table<'t> {
    pub(super) fn new(
        name: impl Into<String>,
        span: Range<usize>,
        table: &'t DeTable<'t>,
        mistakes: &'t Collector<'t>,
    ) -> Self {
        let mut entries: Vec<_> = table.iter().map(|(key, value)| Given { key, value, mistakes }).collect();
        // As they stand in the text.
        entries.sort_by_key(|given| given.key.span().start);
        Self { name: name.into(), span, entries, known: Vec::new(), mistakes }
    }

    /// Notes what is wrong with all of it.
    pub(super) fn note(&self, message: impl Into<String>) {
        self.mistakes.note(&self.span, message);
    }

    /// The value with this name.
    pub(super) fn take(&mut self, name: &'static str) -> Option<Given<'t>> {
        self.known.push(name);
        let place = self.entries.iter().position(|given| given.name() == name)?;
        Some(self.entries.remove(place))
    }

    /// The value with this name; where there is none, what is needed is noted.
    pub(super) fn needs(&mut self, name: &'static str, what: &str) -> Option<Given<'t>> {
        let given = self.take(name);
        if given.is_none() {
            self.note(format!("{} needs {what}", self.name));
        }
        given
    }

    /// The whole number with this name, if there is one within these bounds.
    pub(super) fn whole(&mut self, name: &'static str, bounds: RangeInclusive<u64>) -> Option<u64> {
        self.take(name)?.whole(bounds)
    }

    /// All values that were not taken.
    pub(super) fn rest(&mut self) -> Vec<Given<'t>> {
        std::mem::take(&mut self.entries)
    }

    /// Notes every value that nobody took.
    pub(super) fn finish(&self) {
        for Given { key, .. } in &self.entries {
            let (name, known) = (key.get_ref(), self.known.join(", "));
            self.mistakes.note(&key.span(), format!("{} has no `{name}`; it has {known}", self.name));
        }
    }
}
