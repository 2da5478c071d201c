//! Exact numbers in questions and answers: `"3/7"`, or a number as it is written there.
//!
//! For `#[serde(with = "exact")]` on a [`Rational`], `exact::list` on a list of them, and
//! `exact::optional` on one that may be absent. A number of JSON is taken from its text, so that
//! 0.1 is one tenth.

use kahan_algebra::rational::Rational;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serializer};
use serde_json::Value;

use super::number;

/// Writes p/q, or p.
///
/// # Errors
/// Those of the serializer.
pub fn serialize<S: Serializer>(value: &Rational, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(value)
}

/// Reads what [`Rational::typed`] takes.
///
/// # Errors
/// Where it is no exact number.
pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Rational, D::Error> {
    read(&Value::deserialize(deserializer)?)
}

fn read<E: Error>(value: &Value) -> Result<Rational, E> {
    let text = match value {
        Value::String(text) => text.clone(),
        other => other.to_string(),
    };
    number(&text).map_err(E::custom)
}

/// Lists of exact numbers.
pub mod list {
    use super::{Deserialize, Deserializer, Rational, Serializer, Value, read};

    /// Writes a list of p/q.
    ///
    /// # Errors
    /// Those of the serializer.
    pub fn serialize<S: Serializer>(values: &[Rational], serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(values.iter().map(ToString::to_string))
    }

    /// Reads a list of exact numbers.
    ///
    /// # Errors
    /// Where one of them is none.
    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<Rational>, D::Error> {
        let values = Vec::<Value>::deserialize(deserializer)?;
        values.iter().map(read::<D::Error>).collect()
    }
}

/// An exact number that may be absent.
pub mod optional {
    use super::{Deserialize, Deserializer, Rational, Serializer, Value, read};

    /// Writes p/q, or null.
    ///
    /// # Errors
    /// Those of the serializer.
    pub fn serialize<S: Serializer>(value: &Option<Rational>, serializer: S) -> Result<S::Ok, S::Error> {
        match value {
            Some(value) => serializer.collect_str(value),
            None => serializer.serialize_none(),
        }
    }

    /// Reads an exact number, or null.
    ///
    /// # Errors
    /// Where it is neither.
    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<Rational>, D::Error> {
        match Value::deserialize(deserializer)? {
            Value::Null => Ok(None),
            value => read::<D::Error>(&value).map(Some),
        }
    }
}

/// Lists of lists of exact numbers: points.
pub mod lists {
    use super::{Deserialize, Deserializer, Rational, Serializer, Value, read};

    /// Writes a list of lists of p/q.
    ///
    /// # Errors
    /// Those of the serializer.
    pub fn serialize<S: Serializer>(values: &[Vec<Rational>], serializer: S) -> Result<S::Ok, S::Error> {
        let texts = |row: &Vec<Rational>| row.iter().map(ToString::to_string).collect::<Vec<_>>();
        serializer.collect_seq(values.iter().map(texts))
    }

    /// Reads a list of lists of exact numbers.
    ///
    /// # Errors
    /// Where one of them is none.
    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<Vec<Rational>>, D::Error> {
        let rows = Vec::<Vec<Value>>::deserialize(deserializer)?;
        rows.iter().map(|row| row.iter().map(read::<D::Error>).collect()).collect()
    }
}
