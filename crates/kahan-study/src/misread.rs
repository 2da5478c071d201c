//! Mistakes in the JSON of questions and fields, each with its path.

use std::fmt;

use serde::de::DeserializeOwned;
use serde_json::Value;
use serde_path_to_error::Segment;

/// A mistake in a question or a subject.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Misread {
    /// The path to the mistake in the JSON: names of fields, and indices of list entries from 0.
    pub path: Vec<String>,
    /// A sentence that describes the mistake.
    pub why: String,
}

impl Misread {
    pub(crate) fn at(name: &str, why: impl Into<String>) -> Self {
        Misread { path: vec![name.to_owned()], why: why.into() }
    }
}

impl fmt::Display for Misread {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.path.is_empty() {
            write!(f, "{}: ", self.path.join("."))?;
        }
        f.write_str(&self.why)
    }
}

impl std::error::Error for Misread {}

/// Reads a value from JSON, or returns the first mistake.
pub fn read<T: DeserializeOwned>(value: Value) -> Result<T, Misread> {
    serde_path_to_error::deserialize(value).map_err(|error| {
        let name = |segment: &Segment| match segment {
            Segment::Seq { index } => Some(index.to_string()),
            Segment::Map { key } => Some(key.clone()),
            Segment::Enum { .. } | Segment::Unknown => None,
        };
        let path = error.path().iter().filter_map(name).collect();
        Misread { path, why: error.into_inner().to_string() }
    })
}
