//! Reads and writes axes as a JSON object such as `{"a": "0:1:/9", "eps": "1/10:1:5"}`. An axis is
//! a name with the values to try.
//!
//! Use `#[serde(with = "axes")]` on a [`NamedValues`], an optional one or a list of them.

use std::fmt;
use std::marker::PhantomData;

use serde::de::{DeserializeSeed, Error, MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serializer};
use serde_json::Value;

use crate::range::{Axis, Range};

/// A name with the values on its axis.
pub(crate) trait NamedValues: Sized {
    fn name(&self) -> &str;

    fn to_json(&self) -> Value;

    /// Reads the values of `name`, or returns a sentence that describes the mistake.
    fn of_json(name: &str, values: Value) -> Result<Self, String>;
}

impl NamedValues for Axis {
    fn name(&self) -> &str {
        &self.name
    }

    fn to_json(&self) -> Value {
        self.range.to_string().into()
    }

    fn of_json(name: &str, values: Value) -> Result<Self, String> {
        let text =
            values.as_str().ok_or_else(|| format!("`{values}` is no range; write a text, as \"0:1:11\""))?;
        let range = Range::read(text).map_err(|why| why.to_string())?;
        Ok(Axis { name: name.to_owned(), range })
    }
}

/// One [`NamedValues`], an optional one, or a list of them.
pub(crate) trait NamedValueList: Sized {
    type Entry: NamedValues;

    fn entries(&self) -> &[Self::Entry];

    /// Builds the value from a list; fails if the list is too short or too long.
    fn of(entries: Vec<Self::Entry>) -> Result<Self, &'static str>;
}

impl<E: NamedValues> NamedValueList for Vec<E> {
    type Entry = E;

    fn entries(&self) -> &[E] {
        self
    }

    fn of(entries: Vec<E>) -> Result<Self, &'static str> {
        Ok(entries)
    }
}

impl<E: NamedValues> NamedValueList for Option<E> {
    type Entry = E;

    fn entries(&self) -> &[E] {
        self.as_slice()
    }

    fn of(entries: Vec<E>) -> Result<Self, &'static str> {
        let mut entries = entries.into_iter();
        let first = entries.next();
        if entries.next().is_some() {
            Err("one name goes through values here, not several")
        } else {
            Ok(first)
        }
    }
}

impl NamedValueList for Axis {
    type Entry = Self;

    fn entries(&self) -> &[Self] {
        std::slice::from_ref(self)
    }

    fn of(entries: Vec<Self>) -> Result<Self, &'static str> {
        Option::of(entries)?.ok_or("no name goes through values; give one, as {\"eps\": \"0.1:1:10\"}")
    }
}

/// Writes the entries as an object.
pub(crate) fn serialize<T: NamedValueList, S: Serializer>(
    axes: &T,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.collect_map(axes.entries().iter().map(|entry| (entry.name(), entry.to_json())))
}

/// Reads an object and keeps the order of its names; `null` gives no entries.
pub(crate) fn deserialize<'de, T: NamedValueList, D: Deserializer<'de>>(
    deserializer: D,
) -> Result<T, D::Error> {
    let entries = deserializer.deserialize_any(NamedValuesVisitor(PhantomData))?;
    T::of(entries).map_err(D::Error::custom)
}

struct NamedValuesVisitor<E>(PhantomData<E>);

impl<'de, E: NamedValues> Visitor<'de> for NamedValuesVisitor<E> {
    type Value = Vec<E>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an object with the values of each name, as {\"eps\": \"0.1:1:10\"}")
    }

    fn visit_unit<X: Error>(self) -> Result<Vec<E>, X> {
        Ok(Vec::new())
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Vec<E>, A::Error> {
        let mut entries = Vec::new();
        while let Some(name) = map.next_key::<String>()? {
            entries.push(map.next_value_seed(NamedEntrySeed(&name, PhantomData))?);
        }
        Ok(entries)
    }
}

/// Reads the values of the axis with this name.
struct NamedEntrySeed<'a, E>(&'a str, PhantomData<E>);

impl<'de, E: NamedValues> DeserializeSeed<'de> for NamedEntrySeed<'_, E> {
    type Value = E;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<E, D::Error> {
        E::of_json(self.0, Value::deserialize(deserializer)?).map_err(D::Error::custom)
    }
}
