//! Exact numbers in questions and answers: `"3/7"`, or a number as it is written there.
//!
//! For `#[serde(with = "exact")]` on a [`Rational`], on one that may be absent, and on lists of
//! them. A number of JSON is taken from its text, so that 0.1 is one tenth.

use kahan_algebra::rational::Rational;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::Value;

use super::number;

/// Exact numbers as JSON has them.
pub trait Exactly: Sized {
    /// The text p/q, or p; null where there is none; lists of them.
    fn to_json(&self) -> Value;

    /// The numbers that [`Rational::parse`] takes.
    ///
    /// # Errors
    /// What is none, as a sentence.
    fn of_json(value: &Value) -> Result<Self, String>;
}

impl Exactly for Rational {
    fn to_json(&self) -> Value {
        self.to_string().into()
    }

    fn of_json(value: &Value) -> Result<Self, String> {
        number(&value.as_str().map_or_else(|| value.to_string(), str::to_owned))
    }
}

impl<T: Exactly> Exactly for Option<T> {
    fn to_json(&self) -> Value {
        self.as_ref().map_or(Value::Null, T::to_json)
    }

    fn of_json(value: &Value) -> Result<Self, String> {
        if value.is_null() { Ok(None) } else { T::of_json(value).map(Some) }
    }
}

impl<T: Exactly> Exactly for Vec<T> {
    fn to_json(&self) -> Value {
        self.iter().map(T::to_json).collect()
    }

    fn of_json(value: &Value) -> Result<Self, String> {
        let list = value.as_array().ok_or_else(|| format!("`{value}` is no list of exact numbers"))?;
        list.iter().map(T::of_json).collect()
    }
}

/// Writes exact numbers.
///
/// # Errors
/// Those of the serializer.
pub fn serialize<T: Exactly, S: Serializer>(value: &T, serializer: S) -> Result<S::Ok, S::Error> {
    value.to_json().serialize(serializer)
}

/// Reads exact numbers.
///
/// # Errors
/// Where one of them is none.
pub fn deserialize<'de, T: Exactly, D: Deserializer<'de>>(deserializer: D) -> Result<T, D::Error> {
    T::of_json(&Value::deserialize(deserializer)?).map_err(D::Error::custom)
}
