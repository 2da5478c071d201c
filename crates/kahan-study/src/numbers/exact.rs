//! Exact numbers in JSON: strings such as `"3/7"`, or decimals, so that 0.1 is one tenth.
//!
//! Use `#[serde(with = "exact")]` on a [`Rational`], an optional one, or lists of them.

use kahan_algebra::rational::Rational;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::Value;

use super::number;

/// Values made of exact numbers that are read from and written as JSON.
pub trait ExactJson: Sized {
    /// Writes a number as the text `p/q` or `p`, `None` as `null`, and a list as a list.
    fn to_json(&self) -> Value;

    /// Reads numbers in the grammar of [`Rational::parse`]. The error quotes the value that is not
    /// a number.
    fn of_json(value: &Value) -> Result<Self, String>;
}

impl ExactJson for Rational {
    fn to_json(&self) -> Value {
        self.to_string().into()
    }

    fn of_json(value: &Value) -> Result<Self, String> {
        number(&value.as_str().map_or_else(|| value.to_string(), str::to_owned))
    }
}

impl<T: ExactJson> ExactJson for Option<T> {
    fn to_json(&self) -> Value {
        self.as_ref().map_or(Value::Null, T::to_json)
    }

    fn of_json(value: &Value) -> Result<Self, String> {
        if value.is_null() { Ok(None) } else { T::of_json(value).map(Some) }
    }
}

impl<T: ExactJson> ExactJson for Vec<T> {
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
/// Errors of the serializer.
pub fn serialize<T: ExactJson, S: Serializer>(value: &T, serializer: S) -> Result<S::Ok, S::Error> {
    value.to_json().serialize(serializer)
}

/// Reads exact numbers.
///
/// # Errors
/// A value that is not an exact number.
pub fn deserialize<'de, T: ExactJson, D: Deserializer<'de>>(deserializer: D) -> Result<T, D::Error> {
    T::of_json(&Value::deserialize(deserializer)?).map_err(D::Error::custom)
}
