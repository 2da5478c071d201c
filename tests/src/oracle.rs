//! Reads the reference files `data/SYSTEM.json`, which `data/generate.py` writes and describes. A
//! value that is undefined at a point is `None`.

use serde_json::Value;

use crate::exact::{Matrix, Q, Vector, number};

/// The systems with a reference file.
pub const SYSTEMS: [&str; 11] = ["euler", "lv", "e1", "e2", "e3", "e4", "e5", "e6", "e7", "e8", "e9"];

/// The reference file of a system.
#[derive(Clone, Debug)]
pub struct File(Value);

/// An entry under `cases`, `orbits` or `singular` in a reference file.
#[derive(Clone, Copy, Debug)]
pub struct Entry<'a>(&'a Value, &'a Value);

/// Reads the reference file of a system. Panics if the file is missing.
#[must_use]
pub fn file(system: &str) -> File {
    let path = format!("{}/data/{system}.json", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    File(serde_json::from_str(&text).unwrap_or_else(|error| panic!("{path}: {error}")))
}

impl File {
    /// Returns the entries under `cases`, `orbits` or `singular`. Panics without such a key.
    #[must_use]
    pub fn entries(&self, key: &str) -> Vec<Entry<'_>> {
        let list = self.0[key].as_array().unwrap_or_else(|| panic!("no {key}"));
        assert!(!list.is_empty(), "no {key}");
        list.iter().map(|entry| Entry(entry, &self.0["param_names"])).collect()
    }
}

fn scalar(value: &Value) -> Q {
    number(value.as_str().unwrap_or_else(|| panic!("{value} is not a number")))
}

fn vector(value: &Value) -> Vector {
    value.as_array().unwrap_or_else(|| panic!("{value} is not a vector")).iter().map(scalar).collect()
}

fn matrix(value: &Value) -> Matrix {
    value.as_array().unwrap_or_else(|| panic!("{value} is not a matrix")).iter().map(vector).collect()
}

impl<'a> Entry<'a> {
    fn get(&self, key: &str) -> Option<&'a Value> {
        self.0.get(key).filter(|value| !value.is_null())
    }

    /// Returns whether the entry has this key, even with the value `null`.
    #[must_use]
    pub fn mentions(&self, key: &str) -> bool {
        self.0.get(key).is_some()
    }

    /// Returns the parameters in the system's order. Panics if one is missing.
    #[must_use]
    pub fn parameters(&self) -> Vector {
        let names = self.1.as_array().expect("the file names its parameters");
        names.iter().map(|name| scalar(&self.0["params"][name.as_str().unwrap_or_default()])).collect()
    }

    /// Returns the number under this key.
    #[must_use]
    pub fn scalar(&self, key: &str) -> Option<Q> {
        self.get(key).map(scalar)
    }

    /// Returns the vector under this key.
    #[must_use]
    pub fn vector(&self, key: &str) -> Option<Vector> {
        self.get(key).map(vector)
    }

    /// Returns the matrix, or the list of points, under this key.
    #[must_use]
    pub fn matrix(&self, key: &str) -> Option<Matrix> {
        self.get(key).map(matrix)
    }
}
