//! Questions and subjects as TOML, which has the names and the values that JSON has.

use serde::de::DeserializeOwned;
use serde_json::{Number, Value};
use toml::de::{DeTable, DeValue};

/// Reads from TOML what reads itself from JSON: a [`Question`](crate::Question), a
/// [`Subject`](crate::Subject). A number is taken from its text, so that 0.1 is one tenth.
///
/// ```
/// use kahan_study::{Question, Subject, Systems, Unwatched, from_toml};
///
/// let subject: Subject = from_toml("name = 'e7'\nparams = { xi = 0.1 }").unwrap();
/// let question: Question = from_toml("ask = 'evaluate'\neps = 0.1\nat = [1, '2/3', -3]").unwrap();
/// assert!(subject.study(&Systems).unwrap().ask(&question, &Unwatched).is_ok());
/// ```
///
/// # Errors
/// The mistake in words: one of TOML with its place, one of a value with what is expected.
pub fn from_toml<T: DeserializeOwned>(text: &str) -> Result<T, String> {
    let table = DeTable::parse(text).map_err(|mistake| mistake.to_string())?;
    T::deserialize(of_table(table.get_ref())?).map_err(|mistake| mistake.to_string())
}

fn of_table(table: &DeTable<'_>) -> Result<Value, String> {
    table.iter().map(|(key, value)| Ok((key.get_ref().to_string(), json(value.get_ref())?))).collect()
}

fn json(value: &DeValue<'_>) -> Result<Value, String> {
    Ok(match value {
        DeValue::String(text) => Value::String(text.to_string()),
        DeValue::Integer(whole) if whole.radix() == 10 => number(whole.as_str())?,
        DeValue::Integer(whole) => match u64::from_str_radix(whole.as_str(), whole.radix()) {
            Ok(number) => Value::from(number),
            Err(_) => return Err(format!("`{whole}` is too large")),
        },
        DeValue::Float(float) => number(float.as_str())?,
        DeValue::Boolean(flag) => Value::Bool(*flag),
        DeValue::Datetime(date) => return Err(format!("`{date}` is a date, for which nothing asks")),
        DeValue::Array(values) => {
            values.iter().map(|value| json(value.get_ref())).collect::<Result<_, _>>()?
        }
        DeValue::Table(table) => of_table(table)?,
    })
}

fn number(text: &str) -> Result<Value, String> {
    let number = text.trim_start_matches('+').parse::<Number>();
    number.map(Value::Number).map_err(|_| format!("`{text}` is no finite number"))
}
